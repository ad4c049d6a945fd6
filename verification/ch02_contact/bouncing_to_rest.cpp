// A ball bounces to rest: infinitely many impacts in a finite time, by CVODE with root finding and by stepped contact.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/bouncing.hpp>
#include <harness/case.hpp>
#include <harness/impacts_by_events.hpp>
#include <harness/motions.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::bouncing_to_rest {

using namespace particulate;

constexpr double height = 0.4;

// The catalogue's digits of sqrt(2h/g) (1+e)/(1-e), h = 0.4 m, g = 9.81 m/s^2.
struct Known {
  double e, total_time;
};
constexpr Known lossy{.e = 0.5, .total_time = 0.856705873756};
constexpr Known lively{.e = 0.9, .total_time = 5.42580386712};

void by_roots(Rows& rows, const Known& known) {
  const Bouncing exact{.h = height, .e = known.e};
  BouncingScene scene = bouncing_scene({height}, known.e);
  schemes::State state = scenes::start(scene);
  reference::Integrator integrator(scene, state, reference::Adams{.relative = 1e-15, .absolute = 1e-18},
                                   ground_events(1));
  constexpr double slowest = 1e-3;
  double worst_time = 0.0, worst_speed = 0.0, speed = 1.0;
  int impacts = 0;
  for (; speed > slowest; ++impacts) {
    const schemes::Outcome leg = integrator.advance(state, 2.0 * known.total_time);
    if (leg.status != schemes::Status::stopped) throw std::runtime_error("no further impact: " + leg.reason);
    speed = -state.v[2];
    worst_time = report::worse_of(worst_time, std::abs(state.t - exact.impact_time(impacts)));
    worst_speed = report::worse_of(worst_speed, std::abs(speed - exact.impact_speed(impacts)));
    rebound(known.e)(state, integrator.hits());
  }
  const std::string which = fmt::format(", e = {}, {} impacts", known.e, impacts);
  const char* const because =
      "events are found to 100 roundings of the time, and every impact hands its error on to the next";
  rows.equal(
      "impacts down to 1e-3 m/s by CVODE" + which,
      {.expected = 1 + static_cast<int>(std::ceil(std::log(slowest / exact.impact_speed(0)) / std::log(known.e))),
       .computed = impacts,
       .because = "each keeps e of the speed: counted by logarithms"});
  rows.at_most("worst time of an impact by CVODE [s]" + which,
               {.limit = 1e-11, .computed = worst_time, .because = because});
  rows.at_most("worst speed of an impact by CVODE [m/s]" + which,
               {.limit = 1e-10, .computed = worst_speed, .because = because});
  rows.compare(
      fmt::format("time to rest by CVODE, and the flights below 1e-3 m/s by their series, e = {} [s]", known.e),
      {.expected = known.total_time,
       .computed = state.t + 2.0 * known.e * speed / (exact.g * (1.0 - known.e)),
       .tolerance = relative(1e-11),
       .because = "the expected value is given to 12 digits"});
  rows.compare(fmt::format("time to rest in closed form, e = {} [s]", known.e),
               {.expected = known.total_time,
                .computed = exact.total_time(),
                .tolerance = relative(1e-11),
                .because = "the expected value is given to 12 digits; the formula that the other rows use"});
}

const Case roots{{.name = "bouncing_to_rest_by_roots",
                  .claim = "CVODE with root finding meets every impact of a ball that bounces to rest",
                  .equation = "M 2.2",
                  .reference = Reference::closed_form},
                 [](Rows& rows) {
                   by_roots(rows, lossy);
                   by_roots(rows, lively);
                 }};

// Heights about the nominal one. How late within its step an impact is seen is as good as random from height to height.
std::vector<double> heights_about(double nominal, int count) {
  std::vector<double> heights;
  for (int k = 0; k < count; ++k) heights.push_back(nominal * (0.98 + 0.04 * (k + 0.5) / count));
  return heights;
}

// How a stepped ball differs from the closed form.
struct Difference {
  double position = 0.0;  // at a time between impacts, over the height [-]
  double velocity = 0.0;  // likewise, over the first impact's speed [-]
  double slowed = 0.0;    // time of the first impact slower than a given speed, over the time to rest [-]
};

struct Stepped {
  double e;
  double t;        // generic: amid a flight, for all heights [s]
  double slow;     // impact speed, amid the speeds of two impacts in closed form [m/s]
  double longest;  // step [s]
};

template <class Observer>
schemes::Outcome run(BouncingScene& scene, schemes::State& state, double t_end, double dt, Observer&& observer) {
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = dt};
  return schemes::integrate(scene, state, t_end, scheme, control, observer);
}

double time_of_slow_impact(BouncingScene& scene, const Stepped& how, double t_end, double dt) {
  schemes::State state = scenes::start(scene);
  const auto watch = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
    const bool meets = to.r[2] <= ball_radius && to.v[2] < 0.0;
    return !(meets && -to.v[2] < how.slow);
  };
  const schemes::Outcome out = run(scene, state, t_end, dt, watch);
  if (out.status != schemes::Status::stopped) throw std::runtime_error("the ball never slowed down: " + out.reason);
  return state.t;
}

Difference difference(const Stepped& how, double h, double dt) {
  const Bouncing exact{.h = h, .e = how.e};
  BouncingScene scene = bouncing_scene({h}, how.e);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = run(scene, state, how.t, dt, schemes::Unobserved{});
  require_reached(out);
  int slow_impact = 0;
  while (exact.impact_speed(slow_impact) >= how.slow) ++slow_impact;
  const double slowed = time_of_slow_impact(scene, how, 1.5 * exact.total_time(), dt);
  const Bouncing::Moment there = exact.at(how.t);
  return {.position = std::abs(state.r[2] - ball_radius - there.z) / h,
          .velocity = std::abs(state.v[2] - there.v) / exact.impact_speed(0),
          .slowed = std::abs(slowed - exact.impact_time(slow_impact)) / exact.total_time()};
}

void by_steps(Rows& rows, const Stepped& how) {
  const std::vector<double> heights = heights_about(height, rows.quick() ? 16 : 100);
  std::vector<double> steps, position, velocity, slowed;
  const double finer = rows.quick() ? 1.6 : 2.0;  // as many points for half the steps
  for (int k = 0; k < (rows.quick() ? 5 : 6); ++k) {
    // A whole number of steps to the generic time.
    const double dt = how.t / std::round(how.t / how.longest * std::pow(finer, k));
    Difference mean;
    for (const double h : heights) {
      const Difference one = difference(how, h, dt);
      mean.position += one.position / static_cast<double>(heights.size());
      mean.velocity += one.velocity / static_cast<double>(heights.size());
      mean.slowed += one.slowed / static_cast<double>(heights.size());
    }
    steps.push_back(dt), position.push_back(mean.position), velocity.push_back(mean.velocity);
    slowed.push_back(mean.slowed);
  }
  const std::string because = fmt::format(
      "an impact is seen up to a step late, as good as at random: the mean error over {} heights is of first order",
      heights.size());
  const auto order = [&](const std::string& what, const std::vector<double>& errors) {
    rows.order(fmt::format("{}, e = {}", what, how.e),
               {.nominal = 1.0, .steps = steps, .errors = errors, .floor = 1e-13, .because = because});
  };
  order(fmt::format("stepped contact: height at t = {} s", how.t), position);
  order(fmt::format("stepped contact: velocity at t = {} s", how.t), velocity);
  order(fmt::format("stepped contact: time of the first impact below {} m/s", how.slow), slowed);
}

const Case stepped{{.name = "bouncing_to_rest_by_steps",
                    .claim = "stepped contact converges at first order to the ball that bounces to rest",
                    .equation = "R 2.2",
                    .reference = Reference::convergence},
                   [](Rows& rows) {
                     by_steps(rows, {.e = lossy.e, .t = 0.65, .slow = 0.0155, .longest = 1e-4});
                     by_steps(rows, {.e = lively.e, .t = 1.5, .slow = 0.29, .longest = 2e-4});
                   }};

// A ball that rests meets the ground once a step, at u, and leaves it at v' = e u + gamma g Dt: the weight during the
// impact is made up for, because the step that follows applies it again. Then u = (1 - gamma) g Dt / (1 + e) repeats,
// and a step moves the ball by v' Dt - g Dt^2 / 2.
const Case resting{
    {.name = "resting_on_the_ground",
     .claim = "a ball at rest sinks by g Dt^2 ((1-e)/2 - gamma)/(1+e) a step: stepped contact holds it to O(Dt)",
     .equation = "R 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double dt = 1e-3, g = 9.81, gamma = 0.01;
      constexpr int count = 1000;
      for (const double e : {0.0, 0.5, 0.9}) {
        BouncingScene scene = bouncing_scene({0.0}, e, gamma);
        schemes::State state = scenes::start(scene);
        const double before = state.r[2];
        state.v[2] = (e * (1.0 - gamma) / (1.0 + e) + gamma) * g * dt;
        const schemes::Outcome out = run(scene, state, count * dt, dt, schemes::Unobserved{});
        require_reached(out);
        rows.compare(fmt::format("sinks in 1000 steps of 1 ms, e = {} [m]", e),
                     {.expected = count * g * dt * dt * (0.5 * (1.0 - e) - gamma) / (1.0 + e),
                      .computed = before - state.r[2],
                      .tolerance = mixed(1e-9, 1e-13),
                      .because = "exact for constant forces but for rounding, 1000 steps of a height of 0.05 m"});
        rows.equal(fmt::format("impacts in 1000 steps, e = {}", e),
                   {.expected = count, .computed = out.impacts, .because = "one at the end of each step"});
      }
    }};

// A ball on the ground for a long time, with the contact that a scene has by default.
struct Long {
  double highest = 0.0;  // of its lowest point, in the last second [m]
  double lowest = 0.0;   // in the whole run, at the ends of steps [m]
  double last = 0.0;     // of its lowest point at the end [m]
};

Long for_long(double dropped_from, double e, double dt, double seconds) {
  BouncingScene scene = bouncing_scene({dropped_from}, e, contact::Contact<>{}.gamma);
  schemes::State state = scenes::start(scene);
  Long seen;
  const auto watch = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
    seen.last = to.r[2] - ball_radius;
    seen.lowest = std::min(seen.lowest, seen.last);
    if (to.t > seconds - 1.0) seen.highest = report::worse_of(seen.highest, seen.last + 0.5 * to.v[2] * to.v[2] / 9.81);
    return true;
  };
  require_reached(run(scene, state, seconds, dt, watch));
  return seen;
}

// From rest the ball falls by g Dt^2/2 in the first step, and is held there.
const Case rest_and_bounces{
    {.name = "rest_and_elastic_bounces",
     .claim = "by default an elastic ball keeps its height for 1000 s, and a ball at rest does not sink",
     .equation = "R 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double dt = 1e-3;
      const double seconds = rows.quick() ? 100.0 : 1000.0;
      rows.compare(fmt::format("elastic ball: height that it gained in {} s [m]", seconds),
                   {.expected = 0.0,
                    .computed = for_long(height, 1.0, dt, seconds).highest - height,
                    .tolerance = absolute(1e-11),
                    .because = "1e6 steps, each exact but for some 1e-17 m"});
      for (const double e : {0.0, 0.5, 1.0}) {
        const Long rests = for_long(0.0, e, dt, seconds);
        rows.compare(fmt::format("ball at rest, e = {}: depth in {} s [m]", e, seconds),
                     {.expected = 0.5 * 9.81 * dt * dt,
                      .computed = -rests.last,
                      .tolerance = absolute(1e-11),
                      .because = "the fall of the first step; 1e6 steps, each exact but for some 1e-17 m"});
        const Long landed = for_long(height, e, dt, seconds);
        if (e < 1.0) {
          rows.at_most(fmt::format("ball dropped, e = {}: depth in {} s over its first move in a step", e, seconds),
                       {.limit = 1.0,
                        .computed = -landed.lowest / (std::sqrt(2.0 * 9.81 * height) * dt),
                        .because = "it enters the ground by less than it moves in a step"});
        }
      }
    }};

// Before the first impact: 9.81 m/s^2 for 0.2 s are 1.962 m/s and 0.1962 m.
void prove_falling(Rows& rows) {
  BouncingScene scene = bouncing_scene({height}, lossy.e);
  schemes::State state = scenes::start(scene);
  const double V = scene.potential_energy(state);
  rows.compare("potential energy of 2 kg at 0.45 m [J]",
               {.expected = 8.829, .computed = V, .tolerance = relative(8e-16), .because = "two products, and a sum"});
  const schemes::Outcome out = run(scene, state, 0.2, 1e-3, schemes::Unobserved{});
  require_reached(out);
  rows.compare("potential energy lost in 0.2 s [J]",
               {.expected = 3.849444,
                .computed = V - scene.potential_energy(state),
                .tolerance = relative(1e-13),
                .because = "exact for constant forces but for the rounding of 200 steps"});
  rows.compare("kinetic energy gained in 0.2 s [J]",
               {.expected = 3.849444,
                .computed = 0.5 * 2.0 * state.v[2] * state.v[2],
                .tolerance = relative(1e-13),
                .because = "exact for constant forces but for the rounding of 200 steps"});
}

const Case falling{{.name = "falling_ball",
                    .claim = "a ball has the potential energy m g z, and gains as it falls what it loses of that",
                    .equation = "D 1.13",
                    .reference = Reference::closed_form},
                   prove_falling};

}  // namespace verification::bouncing_to_rest
