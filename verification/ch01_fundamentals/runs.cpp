// Whole runs: against energy alone, against SUNDIALS, and in two parts.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "quadrature.hpp"
#include "references.hpp"

namespace verification::runs {

using namespace particulate;

// The pair of the monograph's default law, released at rest at 0.75 m: how near it comes, and when it is back.

constexpr double d_min = 0.34980807456;
constexpr double period = 3.396184587;
constexpr double released_at = 0.75;

const ReleasedPair by_energy{
    .law = {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0}, .reduced_mass = 0.5L, .start = released_at};

NearFieldScene released() { return {pair_at_rest(1.0, 1.0, released_at), {}, {.alpha1 = 0.5, .alpha2 = 0.25}}; }

// How near the pair came, and the moment at which it is back.
struct Found {
  double nearest, period;
};

template <class S>
Found by_scheme(double step) {
  NearFieldScene scene = released();
  const std::vector<Turning> found = turnings<S>(scene, scenes::start(scene), step, 2);
  return {.nearest = found[0].distance, .period = found[1].t};
}

// The state near the inner turning point, moved there by one Newton step on the rate of the distance.
Found by_adams() {
  NearFieldScene scene = released();
  schemes::State state = scenes::start(scene);
  advance_by(adams, scene, state, 0.5 * period);
  const double d = distance_of_pair(state);
  const double rate = parting(state) / d;
  const double acceleration = 2.0 * (0.25 / (d * d) - 0.5 / d);  // -C/m*
  const double left = -rate / acceleration;
  return {.nearest = d + 0.5 * rate * left, .period = 2.0 * (state.t + left)};
}

void compare_released(Rows& rows, const std::string& method, const Found& found, double tolerance,
                      const std::string& because) {
  rows.compare("d_min by " + method + " [m]",
               {.expected = d_min, .computed = found.nearest, .tolerance = absolute(tolerance), .because = because});
  rows.compare("period by " + method + " [s]", {.expected = period,
                                                .computed = found.period,
                                                .tolerance = absolute(std::max(tolerance, 6e-10)),
                                                .because = because});
}

void prove_released_pair(Rows& rows) {
  const long double near = by_energy.nearest(0.3L, 0.5L);
  const Found quadrature{.nearest = static_cast<double>(near),
                         .period = static_cast<double>(by_energy.period(near, 64))};
  compare_released(rows, "quadrature", quadrature, 6e-12, "the reference has 11 decimals of d_min and 9 of the period");
  rows.compare("quadrature with twice the points [s]",
               {.expected = static_cast<double>(by_energy.period(near, 128)),
                .computed = quadrature.period,
                .tolerance = relative(1e-15),
                .because = "the midpoint rule of a smooth periodic integrand has converged"});
  compare_released(rows, "RK4", by_scheme<schemes::RungeKutta4>(1e-3), 2e-11,
                   "omega up to 5/s at d_min: (5e-3)^4/120 = 5e-12 a radian, and 11 decimals of the reference");
  const double h = rows.quick() ? 4e-4 : 1e-4;
  compare_released(rows, "velocity Verlet", by_scheme<schemes::VelocityVerlet>(h), 5.0 * h * h,
                   "order 2: T (omega h)^2/24 with omega up to 5/s is 3.5 h^2");
  compare_released(rows, "CVODE", by_adams(), 1e-10, "tolerances of 1e-13, of which a global error is some hundred");
}

const Case released_pair{
    {.name = "released_pair",
     .claim = "unit masses with alpha = (0.5, 0.25), beta = (1, 2), released at rest at 0.75 m, come as near and take "
              "as long as energy says",
     .equation = "M 1.33",
     .reference = Reference::independent_method},
    prove_released_pair};

// A cloud under near fields: two reference integrators of different families agree, and then our schemes with them.

constexpr double cloud_end = 2.3;

// Largest difference of positions over the cloud's size, and of velocities over the largest speed.
double difference(const schemes::State& one, const schemes::State& other) {
  return std::max((one.r - other.r).lpNorm<Eigen::Infinity>() / other.r.lpNorm<Eigen::Infinity>(),
                  (one.v - other.v).lpNorm<Eigen::Infinity>() / other.v.lpNorm<Eigen::Infinity>());
}

template <class S>
schemes::State by_steps(NearFieldScene& scene, long steps) {
  schemes::State state = scenes::start(scene);
  advance<S>(scene, state, cloud_end, steps);
  return state;
}

schemes::State by_reference(NearFieldScene& scene, const reference::Method& method) {
  schemes::State state = scenes::start(scene);
  advance_by(method, scene, state, cloud_end);
  return state;
}

// A scheme may be as far from the judge as halving its steps moves it, times 1/(1 - 2^-order) and a fifth; and no
// farther than `worst`, so that a scheme cannot excuse itself by being coarse.
template <class S>
void compare_scheme(Rows& rows, const std::string& what, NearFieldScene& scene, const schemes::State& judge, long steps,
                    double worst) {
  const schemes::State coarse = by_steps<S>(scene, steps), fine = by_steps<S>(scene, 2 * steps);
  const double moved = difference(coarse, fine);
  rows.at_most(
      what, {.limit = std::min(worst, 1.2 * moved / (1.0 - std::pow(0.5, S::order)) + 1e-10),
             .computed = difference(coarse, judge),
             .because = fmt::format("halving the step moves it by {:.2g}, which bounds its error; references agree to "
                                    "1e-10; at most {:g}",
                                    moved, worst)});
}

void compare_with_sundials(Rows& rows, const laws::NearField& law) {
  NearFieldScene scene(random_cloud({.N = 20}, smooth), {}, law);
  const schemes::State judge = by_reference(scene, fehlberg);
  const std::string which = fmt::format(" against ARKODE Fehlberg, beta = ({}, {})", law.beta1, law.beta2);
  const char* const because =
      "tolerances of 1e-13 and 1e-14 with global errors some hundred times larger, in a motion "
      "that amplifies them tenfold";
  rows.at_least("start" + which, {.limit = 0.1,
                                  .computed = difference(scenes::start(scene), judge),
                                  .because = "else there is nothing to agree on"});
  rows.at_most("CVODE Adams" + which,
               {.limit = 1e-10, .computed = difference(by_reference(scene, adams), judge), .because = because});
  rows.at_most(
      "ARKODE Dormand-Prince" + which,
      {.limit = 1e-10, .computed = difference(by_reference(scene, dormand_prince), judge), .because = because});
  compare_scheme<schemes::RungeKutta4>(rows, "RK4" + which, scene, judge, 4000, 1e-6);
  compare_scheme<schemes::VelocityVerlet>(rows, "velocity Verlet" + which, scene, judge, rows.quick() ? 10000 : 40000,
                                          1e-4);
}

void prove_schemes_against_sundials(Rows& rows) {
  compare_with_sundials(rows, {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0});
  compare_with_sundials(rows, {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.3, .beta2 = 2.7});
}

const Case schemes_against_sundials{{.name = "schemes_against_sundials",
                                     .claim = "RK4 and velocity Verlet move a cloud as CVODE and ARKODE do",
                                     .equation = "M 2.1",
                                     .reference = Reference::sundials},
                                    prove_schemes_against_sundials};

// A run in two parts is the run in one; a state that was moved between them is met afresh, and so are other forces.

// The forces of a scene, which somebody turns up.
struct Adjustable {
  const NearFieldScene& scene;
  double strength = 1.0;
  bool acceleration(double t, schemes::In r, schemes::Out a) const {
    const bool valued = scene.acceleration(t, r, a);
    a *= strength;
    return valued;
  }
};

// Goes on with a scheme that may have a past; returns the number of right-hand sides.
template <class S, class P>
long go_on(P& scene, schemes::State& state, double t_end, S& scheme) {
  schemes::FixedStep control{.step = 1.0 / 64.0};
  const schemes::Outcome outcome = integrate(scene, state, t_end, scheme, control);
  require_reached(outcome);
  return outcome.evaluations;
}

long differing(const schemes::State& one, const schemes::State& other) {
  return (one.r.array() != other.r.array()).count() + (one.v.array() != other.v.array()).count();
}

// One particle is somewhere else, nothing else has changed.
schemes::State disturbed(schemes::State state) {
  state.r[3] += 0.125;
  return state;
}

template <class S>
void compare_continued(Rows& rows, const std::string& method, NearFieldScene& scene, long evaluations) {
  const schemes::State start = scenes::start(scene);
  S in_one, in_two, fresh;
  schemes::State whole = start, parts = start;
  const long asked = go_on(scene, whole, 1.0, in_one);
  go_on(scene, parts, 0.5, in_two);
  schemes::State moved = disturbed(parts), anew = moved;
  S with_past = in_two;
  go_on(scene, parts, 1.0, in_two);
  rows.none("components that differ, one run and two parts, " + method, differing(whole, parts),
            "a scheme's history is part of the run");

  go_on(scene, moved, 1.0, with_past);
  go_on(scene, anew, 1.0, fresh);
  rows.none("components that differ, moved state with and without a past, " + method, differing(moved, anew),
            "what a scheme kept holds where it was computed, nowhere else");

  Adjustable forces{scene};
  schemes::State stronger = start;
  S knew;
  go_on(forces, stronger, 0.5, knew);
  forces.strength = 2.0;
  anew = stronger;
  fresh = S();
  go_on(forces, stronger, 1.0, knew);
  go_on(forces, anew, 1.0, fresh);
  rows.none("components that differ, forces doubled in place with and without a past, " + method,
            differing(stronger, anew), "the same problem may ask for something else in the next run");
  rows.equal("right-hand sides in 64 steps, " + method,
             {.expected = evaluations,
              .computed = asked,
              .because = "counted by hand: the first step's start and each step's own"});
}

const Case continued_run{
    {.name = "continued_run",
     .claim = "a run that is continued repeats the uninterrupted one to the last bit, and keeps nothing stale",
     .equation = "M 2.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      NearFieldScene scene(random_cloud({.N = 20}, rows.case_seed()), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
      compare_continued<schemes::RungeKutta4>(rows, "RK4", scene, 4 * 64);
      compare_continued<schemes::VelocityVerlet>(rows, "velocity Verlet", scene, 1 + 64);
    }};

}  // namespace verification::runs
