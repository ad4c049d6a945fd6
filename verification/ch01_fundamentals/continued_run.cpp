// A run in two parts is the run in one; a state that was moved between them is met afresh.

#include <string>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::continued_run {

using namespace particulate;

// Goes on with a scheme that may have a past; returns the number of right-hand sides.
template <class S>
long go_on(NearFieldScene& scene, schemes::State& state, double t_end, S& scheme) {
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
void compare(Rows& rows, const std::string& method, NearFieldScene& scene, long evaluations) {
  const schemes::State start = scenes::start(scene);
  S in_one, in_two, fresh;
  schemes::State whole = start, parts = start;
  const long asked = go_on(scene, whole, 1.0, in_one);
  go_on(scene, parts, 0.5, in_two);
  schemes::State moved = disturbed(parts), anew = moved;
  S with_past = in_two;
  go_on(scene, parts, 1.0, in_two);
  rows.equal("components that differ, one run and two parts, " + method,
             {.expected = 0, .computed = differing(whole, parts), .because = "a scheme's history is part of the run"});

  go_on(scene, moved, 1.0, with_past);
  go_on(scene, anew, 1.0, fresh);
  rows.equal("components that differ, moved state with and without a past, " + method,
             {.expected = 0,
              .computed = differing(moved, anew),
              .because = "what a scheme kept holds where it was computed, nowhere else"});
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
      compare<schemes::RungeKutta4>(rows, "RK4", scene, 4 * 64);
      compare<schemes::VelocityVerlet>(rows, "velocity Verlet", scene, 1 + 64);
    }};

}  // namespace verification::continued_run
