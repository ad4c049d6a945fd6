// What flights, forces and potentials are in closed form.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/symplectic_euler.hpp>

#include "swarms.hpp"

namespace verification::swarm_closed_forms {

using namespace particulate;

// It speeds up for 3/4 s and then flies at 3 m/s: 1 - (1/3) (9/32 + 81/8)/10.
const Case capped{
    {.name = "objective_of_one_member",
     .claim = "the objective of one member under a constant pull 4 and the cap 3, from 10 m away, tends to 0.653125 at "
              "order 1",
     .equation = "R 6.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      swarm::Course course{.target = {10.0, 0.0, 0.0}, .c_d = 0.0, .v_max = 3.0, .duration = 3.0};
      std::vector<double> steps, errors, extrapolated;
      double coarser = 0.0;
      for (int k = 0; k < 7; ++k) {
        course.step = 0.02 * std::ldexp(1.0, -k);
        const double now =
            swarm::fly({.alpha_t = 4.0, .beta_t = 0.0}, course, members({Eigen::Vector3d::Zero()})).objective;
        if (k > 0) extrapolated.push_back(2.0 * now - coarser);
        steps.push_back(course.step);
        errors.push_back(std::abs(now - 0.653125));
        coarser = now;
      }
      rows.order("objective", {.nominal = 1.0,
                               .steps = steps,
                               .errors = errors,
                               .floor = 1e-15,
                               .because = "within a step a member exceeds the cap by the 4 Dt that the pull adds, and "
                                          "so flies ahead of it"});
      rows.compare("extrapolated to Dt = 0",
                   {.expected = 0.653125,
                    .computed = extrapolated.back(),
                    .tolerance = absolute(std::pow(steps.back(), 2)),
                    .because = "what is left is of order 2, with a factor below 1: it speeds up for 3/4 s of 3"});
    }};

// 4 h^0.7 = 0.5 d^-1.5 - 0.5 d^0.3 with d = 2 h.
const Case pair{{.name = "two_members_about_the_target",
                 .claim = "two members come to rest at 0.216229868450448 m from the target",
                 .equation = "R 6.1",
                 .reference = Reference::closed_form},
                [](Rows& rows) {
                  // Their mean over two members is a half of the sum: strengths of 1 stand for 0.5 of each.
                  const swarm::Design design{
                      .alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 0.3, .beta2 = 1.5, .alpha_t = 4.0, .beta_t = 0.7};
                  const Eigen::Vector3d target{10.0, 0.0, 0.0}, aside = 0.5 * Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0;
                  const swarm::Trial trial = swarm::fly(design, {.target = target, .duration = 80.0},
                                                        members({target + aside, target - aside}));
                  for (const Eigen::Index i : {0, 1}) {
                    rows.compare(fmt::format("distance of member {} [m]", i),
                                 {.expected = 0.216229868450448,
                                  .computed = (schemes::position(trial.flight.state, i) - target).norm(),
                                  .tolerance = relative(2e-14),
                                  .because = "after 80 s drag has left exp(-40), and places are rounded 10 m away"});
                  }
                }};

// The potential 2 alpha_o/((beta_o - 1) d^2) of both is 4 at the gate, 4/(1 + x_0^2) at the start.
bool passes(double x_0, double v) {
  kinematics::Particles one = members({{-x_0, 0.0, 0.0}});
  one.velocity(0, 0) = v;
  const scenes::Scene scene(
      one, kinematics::Space{},
      swarm::Obstacles{
          .centre = {{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}}, .radius = {0.25, 0.25}, .alpha = 4.0, .beta = 3.0});
  schemes::State state = scenes::start(scene);
  schemes::RungeKutta4 scheme;
  schemes::FixedStep control{.step = 2e-3};
  const auto decided = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
    return to.v[0] > 0.0 && to.r[0] < 0.0;
  };
  const schemes::Outcome outcome = schemes::integrate(scene, state, 100.0, scheme, control, decided);
  if (outcome.status != schemes::Status::stopped) throw std::runtime_error("neither passed nor turned back");
  return state.r[0] >= 0.0;
}

const Case gate{
    {.name = "gate",
     .claim = "between two obstacles at (0, +-1, 0), alpha_o = 4, beta_o = 3, a member passes if it comes from x_0 "
              "faster than 2 sqrt(2) x_0/sqrt(1 + x_0^2)",
     .equation = "D 6.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double x_0 : {0.5, 2.0, 8.0}) {
        const double least = 2.0 * std::sqrt(2.0) * x_0 / std::sqrt(1.0 + x_0 * x_0);
        const char* because = "its energy is then a thousandth from what the gate asks, and a step of RK4 makes 1e-9";
        rows.equal(fmt::format("from {} m, a thousandth too slow: passes", x_0),
                   {.expected = false, .computed = passes(x_0, least * (1.0 - 1e-3)), .because = because});
        rows.equal(fmt::format("from {} m, a thousandth faster: passes", x_0),
                   {.expected = true, .computed = passes(x_0, least * (1.0 + 1e-3)), .because = because});
      }
    }};

// The work of all forces while the whole swarm is moved along straight lines, by Gauss's rule.
double work_between(const auto& scene, const schemes::State& from, const schemes::State& to) {
  schemes::State there = from;
  Eigen::VectorXd force(from.r.size());
  const auto power = [&](double s) {
    there.r = from.r + s * (to.r - from.r);
    return scene.total_force(there, force) ? force.dot(to.r - from.r) : missing;
  };
  return boost::math::quadrature::gauss<double, 40>::integrate(power, 0.0, 1.0);
}

const Case potentials{
    {.name = "swarm_potentials",
     .claim = "members, obstacles and target work as much as their potential energies fall",
     .equation = "R 6.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const std::vector<std::pair<double, double>> exponents = {{0.5, 0.0}, {1.0, 0.4}, {2.0, 1.0}, {4.0, 0.7}};
      for (const auto& [beta_o, beta_t] : exponents) {
        swarm::Design design = passing;
        design.beta_o = beta_o;
        design.beta_t = beta_t;
        kinematics::Particles start = swarm_at_rest(12, rows.case_seed());
        for (Eigen::Index i = 0; i < 12; ++i) start.mass[i] = 1.0 + 0.1 * static_cast<double>(i);
        start.position *= 3.0;  // apart, so that the rule sees smooth forces
        const auto scene = scene_of(start, design, swarm::fence());
        const schemes::State from = scenes::start(scene);
        schemes::State to = from;
        to.r = 0.8 * from.r;
        to.r.head(12).array() -= 1.0;
        const double fall = scene.potential_energy(from) - scene.potential_energy(to);
        rows.compare(fmt::format("beta_o = {}, beta_t = {}: work [J]", beta_o, beta_t),
                     {.expected = fall,
                      .computed = work_between(scene, from, to),
                      .tolerance = relative(1e-12),
                      .because = "rounding of energies ten times as large; forty points leave less"});
      }
    }};

const Case drag{
    {.name = "drag_alone",
     .claim = "under drag alone velocities fall as exp(-c_d t), whatever the masses: symplectic Euler at order 1, RK4 "
              "at order 4",
     .equation = "R 6.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      kinematics::Particles start = members({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
      start.mass[1] = 100.0;
      start.velocity.rowwise() = Eigen::RowVector3d(1.0, -2.0, 0.5);
      const double c_d = 0.7, t_end = 1.9;
      const scenes::Scene scene(start, kinematics::Space{}, swarm::LinearDrag{.c_d = c_d});
      const Eigen::VectorXd v_0 = start.velocity.reshaped(), exact_v = std::exp(-c_d * t_end) * v_0;
      const Eigen::VectorXd exact_r = start.position.reshaped() - std::expm1(-c_d * t_end) / c_d * v_0;
      const auto claim_order = [&]<class S>(const std::string& by, long coarsest) {
        std::vector<double> steps, errors;
        for (long n = coarsest; steps.size() < 6; n *= 2) {
          schemes::State state = scenes::start(scene);
          advance<S>(scene, state, t_end, n);
          steps.push_back(t_end / static_cast<double>(n));
          errors.push_back(
              std::max((state.v - exact_v).lpNorm<Eigen::Infinity>(), (state.r - exact_r).lpNorm<Eigen::Infinity>()));
        }
        rows.order(by, {.nominal = S::order,
                        .steps = steps,
                        .errors = errors,
                        .floor = 1e-15,
                        .because = "the order of the scheme, where forces depend on velocities"});
      };
      claim_order.operator()<schemes::SymplecticEuler>("symplectic Euler", 300);
      claim_order.operator()<schemes::RungeKutta4>("RK4", 8);
    }};

}  // namespace verification::swarm_closed_forms
