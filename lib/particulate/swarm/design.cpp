#include <particulate/swarm/design.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/symplectic_euler.hpp>

namespace particulate::swarm {

namespace {

Obstacles obstacles_on(const Course& course, const Design& design) {
  return {.centre = course.obstacles,
          .radius = course.radii,
          .alpha = design.alpha_o,
          .beta = design.beta_o,
          .kernel = course.kernel};
}

void require(bool holds, const char* what, double given) {
  if (!holds) throw std::invalid_argument(fmt::format("{}, got {}", what, given));
}

}  // namespace

void validate(const Design& d) {
  const auto is_strength = [](double alpha) { return alpha >= 0.0 && std::isfinite(alpha); };
  require(is_strength(d.alpha1), "design: alpha1 must be finite and not negative", d.alpha1);
  require(is_strength(d.alpha2), "design: alpha2 must be finite and not negative", d.alpha2);
  require(d.beta1 <= 1.0 && std::isfinite(d.beta1), "design: beta1 must be finite and at most 1", d.beta1);
  require(d.beta2 >= -1.0 && std::isfinite(d.beta2), "design: beta2 must be finite and at least -1", d.beta2);
  require(is_strength(d.alpha_o), "design: alpha_o must be finite and not negative", d.alpha_o);
  require(d.beta_o > 0.0 && std::isfinite(d.beta_o), "design: beta_o must be positive and finite", d.beta_o);
  require(is_strength(d.alpha_t), "design: alpha_t must be finite and not negative", d.alpha_t);
  require(d.beta_t >= 0.0 && d.beta_t <= 1.0, "design: beta_t must lie between 0 and 1", d.beta_t);
}

Design design_of(const Eigen::VectorXd& string) {
  if (string.size() != 8) {
    throw std::invalid_argument(fmt::format("design: must have 8 parameters, got {}", string.size()));
  }
  return {string[0], string[1], string[2], string[3], string[4], string[5], string[6], string[7]};
}

Eigen::VectorXd string_of(const Design& d) {
  return Eigen::Vector<double, 8>{d.alpha1, d.alpha2, d.beta1, d.beta2, d.alpha_o, d.beta_o, d.alpha_t, d.beta_t};
}

identification::Box design_bounds() {
  return {.lower = string_of({0.0, 0.0, 0.0, 0.5, 0.0, 0.5, 0.0, 0.0}),
          .upper = string_of({1.0, 1.0, 1.0, 3.0, 5.0, 4.0, 5.0, 1.0})};
}

Course fence() {
  Course course;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) course.obstacles.emplace_back(5.0, 2.0 * i, 2.0 * j);
  }
  course.radii.assign(course.obstacles.size(), 0.5);
  return course;
}

void validate(const Course& course) {
  const Obstacles obstacles = obstacles_on(course, {});
  validate(obstacles);
  validate(Target{.place = course.target});
  validate(LinearDrag{.c_d = course.c_d});
  validate(SpeedLimit{.v_max = course.v_max});
  require(course.duration > 0.0 && std::isfinite(course.duration), "course: duration must be positive and finite",
          course.duration);
  require(course.step > 0.0 && std::isfinite(course.step), "course: step must be positive and finite", course.step);
  require(course.loss_penalty >= 0.0 && std::isfinite(course.loss_penalty),
          "course: loss_penalty must be finite and not negative", course.loss_penalty);
  if (const auto k = obstacle_around(obstacles, kinematics::Space{}, course.target)) {
    throw std::invalid_argument(
        fmt::format("course: the target must be outside of all obstacles, but is inside obstacle {}: place it "
                    "elsewhere",
                    *k));
  }
}

laws::NearField members_law(const Design& design, double mass, laws::Kernel kernel) {
  return {.alpha1 = design.alpha1 / mass,
          .alpha2 = design.alpha2 / mass,
          .beta1 = -design.beta1,
          .beta2 = design.beta2,
          .kernel = kernel};
}

Trial fly(const Design& design, const Course& course, const kinematics::Particles& start, const Watcher& watcher) {
  validate(design);
  validate(course);
  Objective objective(course.target, start);
  const auto observe = [&](const schemes::State& from, const schemes::State& to, double dt, const auto& scheme) {
    if (watcher) watcher(to);
    return objective(from, to, dt, scheme);
  };
  Trial trial{
      .objective = std::numeric_limits<double>::quiet_NaN(),
      .flight =
          fly(start, kinematics::Space{}, course.duration, schemes::SymplecticEuler{},
              schemes::FixedStep{.step = course.step}, observe, members_law(design, start.mass.sum(), course.kernel),
              obstacles_on(course, design),
              Target{.place = course.target, .alpha = design.alpha_t, .beta = design.beta_t, .kernel = course.kernel},
              LinearDrag{.c_d = course.c_d}, SpeedLimit{.v_max = course.v_max})};
  if (trial.flight.outcome.status != schemes::Status::reached) return trial;
  const double lost = static_cast<double>(trial.flight.lost.size()) / static_cast<double>(start.size());
  trial.objective = objective.mean() + course.loss_penalty * lost;
  return trial;
}

identification::Cost objective(std::vector<kinematics::Particles> starts, Course course) {
  validate(course);
  if (starts.empty()) throw std::invalid_argument("objective: needs one start at least, got none");
  for (const kinematics::Particles& start : starts) {
    const Objective refuses(course.target, start);
    const Obstacles obstacles = obstacles_on(course, {});
    detail::Legs(start, kinematics::Space{}, &obstacles);
  }
  return [starts = std::move(starts), course = std::move(course)](const Eigen::VectorXd& string) {
    double sum = 0.0;
    for (const kinematics::Particles& start : starts) {
      const Trial trial = fly(design_of(string), course, start);
      if (std::isnan(trial.objective)) return identification::Value(std::string(name(trial.flight.outcome.failure)));
      sum += trial.objective;
    }
    return identification::Value(sum / static_cast<double>(starts.size()));
  };
}

}  // namespace particulate::swarm
