// Swarms that must be flown, however few, slow or large, and those that must be refused.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/identification/genetic_algorithm.hpp>

#include "swarms.hpp"

namespace verification::swarm_extremes {

using namespace particulate;

swarm::Trial passed(const swarm::Course& course, const kinematics::Particles& start) {
  const swarm::Trial trial = swarm::fly(passing, course, start);
  if (trial.flight.outcome.status != schemes::Status::reached) throw std::runtime_error(trial.flight.outcome.reason);
  return trial;
}

// n steps under the pull 4 from rest: each adds 4 Dt, and then the member moves.
Ending one_member() {
  const swarm::Course course{.c_d = 0.0, .v_max = infinite, .duration = 2.0, .step = 0x1p-6};
  const swarm::Trial trial = swarm::fly({.alpha_t = 4.0, .beta_t = 0.0}, course, members({Eigen::Vector3d::Zero()}));
  const double n = 128.0;
  return Ending::solved({.error = std::abs(trial.flight.state.r[0] - 2.0 * course.step * course.step * n * (n + 1.0)),
                         .tolerance = 1e-13,
                         .because = "rounding of 128 steps"});
}

// It starts on the surface of an obstacle, which is outside, and is inside after the first step.
Ending lost_at_once() {
  swarm::Course course = swarm::fence();
  course.duration = 1.0, course.step = 0.25, course.c_d = 0.0;
  kinematics::Particles start = members({{4.5, 0.0, 0.0}});
  start.velocity(0, 0) = 1.0;
  const swarm::Trial trial = swarm::fly({}, course, start);
  const double there = 5.25 / 5.5;
  return Ending::solved({.error = std::abs(trial.objective - (0.25 * (1.0 + there) / 2.0 + 0.75 * there + 1.0)),
                         .tolerance = 1e-15,
                         .because = "a step of a quarter of a second at 1 m/s, then 5.25 m from the target, and lost"});
}

Ending target_in_the_middle() {
  const Eigen::Vector3d away{1.0, 2.0, -0.5};
  const swarm::Trial trial = passed({.target = Eigen::Vector3d::Zero()}, members({away, {0.0, 0.0, 0.0}, -away}));
  const auto place = [&](Eigen::Index i) { return schemes::position(trial.flight.state, i); };
  return Ending::solved({.error = place(1).norm() + (place(0) + place(2)).norm(),
                         .tolerance = 1e-12,
                         .because = "what is a mirror image stays one, its middle at rest, but for rounding"});
}

// At the end of each step the speed is v_max again, so that in a step it moves by what the pull adds in it.
Ending hardly_any_speed(double v_max) {
  const swarm::Course course{.v_max = v_max, .duration = 2.0};
  const swarm::Trial trial = swarm::fly({.alpha_t = 4.0, .beta_t = 0.0}, course, members({Eigen::Vector3d::Zero()}));
  const double gain = 4.0 * course.step, kept = v_max * (1.0 - course.step);
  return Ending::solved({.error = std::abs(trial.flight.state.r[0] - course.step * (100.0 * gain + 99.0 * kept)),
                         .tolerance = 1e-14,
                         .because = "rounding of 100 steps"});
}

// Nothing but each other: no momentum.
Ending many(long steps) {
  swarm::Course course{.c_d = 0.0, .v_max = infinite, .duration = 0.02 * static_cast<double>(steps)};
  swarm::Design design = passing;
  design.alpha_t = 0.0;
  const kinematics::Particles start = swarm_at_rest(4096, 1);
  const Eigen::VectorXd v = swarm::fly(design, course, start).flight.state.v;
  return Ending::solved({.error = std::abs(v.head(4096).sum()) / v.head(4096).lpNorm<1>(),
                         .tolerance = 1e-13,
                         .because = "what members do to each other adds up to nothing, but for rounding"});
}

// How much the objective changes with the units of length, time and mass, of which it knows none.
double change_with_units(double length, double time, double mass) {
  swarm::Course course = swarm::fence();
  kinematics::Particles start = swarm_at_rest(32, 1);
  const double before = passed(course, start).objective;
  swarm::Design design = passing;
  const auto strength = [&](double beta) { return length * std::pow(length, beta) / (time * time); };
  design.alpha1 *= strength(-design.beta1), design.alpha2 *= strength(design.beta2);
  design.alpha_o *= strength(design.beta_o), design.alpha_t *= strength(-design.beta_t);
  for (Eigen::Vector3d& centre : course.obstacles) centre *= length;
  for (double& radius : course.radii) radius *= length;
  course.target *= length, course.v_max *= length / time, course.c_d /= time;
  course.duration *= time, course.step *= time;
  start.position *= length, start.mass *= mass;
  return std::abs(swarm::fly(design, course, start).objective - before);
}

// The threads share the starts and the course.
Ending threads_and_repeats() {
  swarm::Course course = swarm::fence();
  course.duration = 3.0;
  const identification::Cost cost = swarm::objective({swarm_at_rest(8, 1), swarm_at_rest(8, 2)}, course);
  std::vector<Eigen::VectorXd> best;
  for (const int threads : {1, 1, 2, 3}) {
    const identification::GeneticAlgorithm algorithm{.S = 12, .K = 4, .threads = threads};
    identification::Population population = first_population(swarm::design_bounds(), algorithm, 1);
    best.push_back(evolve(cost, swarm::design_bounds(), algorithm, {.generations = 3}, population).best.parameters);
  }
  const auto differs = [&](const Eigen::VectorXd& one) { return one != best.front(); };
  return Ending::solved({.error = static_cast<double>(std::count_if(best.begin(), best.end(), differs)),
                         .tolerance = 0.0,
                         .because = "an objective is a function of the design alone"});
}

const Case solved{
    {.name = "swarm_extremes_solved",
     .claim = "one member, all lost, a target among the members, hardly any speed, 4096 members, other units, and any "
              "number of threads are solved",
     .equation = "R 6.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.must_be_solved("one member", one_member);
      rows.must_be_solved("all lost in the first step", lost_at_once);
      rows.must_be_solved("the target in the middle, with a member there", target_in_the_middle);
      rows.must_be_solved("a speed limit of 1e-12 m/s", [] { return hardly_any_speed(1e-12); });
      rows.must_be_solved("a speed limit of 0", [] { return hardly_any_speed(0.0); });
      rows.must_be_solved("4096 members", [&] { return many(rows.quick() ? 4 : 40); });
      const auto units = [&](const std::string& name, const Eigen::Vector3d& of, double tolerance,
                             const std::string& because) {
        rows.must_be_solved(name, [&] {
          return Ending::solved(
              {.error = change_with_units(of[0], of[1], of[2]), .tolerance = tolerance, .because = because});
        });
      };
      const std::string exact = "powers of two change no bit of a product, and so none of the objective";
      units("masses of 2^-40 kg", {1.0, 1.0, 0x1p-40}, 0.0, exact);
      units("a flight of 2^30 times 15 s", {1.0, 0x1p30, 1.0}, 0.0, exact);
      units("micrometres", {1e-6, 1.0, 1.0}, 1e-9, "powers of distances round otherwise, which encounters multiply");
      rows.must_be_solved("flights again, and by several threads", threads_and_repeats);
    }};

void refuse_flights(Rows& rows) {
  const auto refuse = [&](const std::string& name, const std::string& key_words, const kinematics::Particles& start,
                          const swarm::Course& course = swarm::fence(), const swarm::Design& design = passing) {
    rows.must_be_refused(name, key_words, [&] { return ending_of(swarm::fly(design, course, start).flight.outcome); });
  };
  const kinematics::Particles few = members({{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
  const kinematics::Particles twins = members({{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}});
  refuse("coincident members", "near field particles 1 and 2 place them otherwise", twins);
  refuse("a member inside an obstacle", "member 1 inside obstacle 4 elsewhere",
         members({{0.0, 0.0, 0.0}, {5.25, 0.0, 0.0}}));
  refuse("no member", "one member at least none", swarm_at_rest(0, 1));
  refuse("all members at the target", "distance target positive 0 m", members({{10.0, 0.0, 0.0}}));
  kinematics::Particles lost = few;
  lost.position(1, 2) = not_a_number;
  refuse("a member nowhere", "particle 1 position finite", lost);
  const auto with = [](const auto& change) {
    swarm::Course course = swarm::fence();
    change(course);
    return course;
  };
  refuse("a member at the centre of an obstacle", "member 1 centre of obstacle 9 otherwise", few,
         with([](swarm::Course& c) { c.obstacles.emplace_back(0.0, 1.0, 0.0), c.radii.push_back(0.0); }));
  refuse("a target inside an obstacle", "target outside inside obstacle 4", few, with([](swarm::Course& c) {
           c.target = {5.0, 0.25, 0.0};
         }));
  refuse("a radius missing", "9 centres and 8 radii", few, with([](swarm::Course& c) { c.radii.pop_back(); }));
  refuse("a negative speed limit", "v_max not negative -1", few, with([](swarm::Course& c) { c.v_max = -1.0; }));
  refuse("a speed limit that is no number", "v_max nan", few, with([](swarm::Course& c) { c.v_max = not_a_number; }));
  refuse("negative drag", "c_d not negative -1", few, with([](swarm::Course& c) { c.c_d = -1.0; }));
  refuse("a step of 0", "step positive 0", few, with([](swarm::Course& c) { c.step = 0.0; }));
  refuse("an endless flight", "duration finite inf", few, with([](swarm::Course& c) { c.duration = infinite; }));
}

void refuse_designs(Rows& rows) {
  const auto refuse = [&](const std::string& name, const std::string& key_words, const auto& change) {
    rows.must_be_refused(name, key_words, [&] {
      swarm::Design design = passing;
      change(design);
      return ending_of(swarm::fly(design, swarm::fence(), swarm_at_rest(4, 1)).flight.outcome);
    });
  };
  refuse("beta_o = 0", "design beta_o positive got 0", [](swarm::Design& d) { d.beta_o = 0.0; });
  refuse("beta_o = -1", "design beta_o positive got -1", [](swarm::Design& d) { d.beta_o = -1.0; });
  refuse("alpha_t = nan", "design alpha_t nan", [](swarm::Design& d) { d.alpha_t = not_a_number; });
  refuse("alpha1 = nan", "alpha1 nan", [](swarm::Design& d) { d.alpha1 = not_a_number; });
  refuse("beta_t = 2", "design beta_t between 0 and 1 got 2", [](swarm::Design& d) { d.beta_t = 2.0; });
  rows.must_be_refused("seven parameters", "8 parameters got 7", [] {
    (void)swarm::design_of(Eigen::VectorXd::Ones(7));
    return accepted();
  });
  rows.must_be_refused("bounds that allow nothing", "allowed 1000 strings none narrower", [] {
    identification::Box box = swarm::design_bounds();
    box.allows = [](const Eigen::VectorXd& x) { return x[0] > 2.0; };
    (void)first_population(box, {}, 1);
    return accepted();
  });
  rows.must_be_refused("no start", "one start at least none", [] {
    (void)swarm::objective({}, swarm::fence());
    return accepted();
  });
  rows.must_be_refused("a cost of coincident members", "no value", [] {
    const identification::Value value =
        swarm::objective({members({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})}, swarm::fence())(swarm::string_of(passing));
    return std::isnan(value.cost) ? Ending::refused(value.reason) : accepted();
  });
}

const Case refused{{.name = "swarm_extremes_refused",
                    .claim = "swarms, courses and designs that cannot be meant are refused, with the reason",
                    .equation = "R 6.3",
                    .reference = Reference::design},
                   [](Rows& rows) {
                     refuse_flights(rows);
                     refuse_designs(rows);
                   }};

}  // namespace verification::swarm_extremes
