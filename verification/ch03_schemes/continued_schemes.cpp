// A run that is stopped, copied and continued repeats the uninterrupted one to the last bit.

#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>

#include "bits.hpp"
#include "classical_problems.hpp"

namespace verification::continued_schemes {

using namespace particulate;
using namespace particulate::schemes;

// A checkpoint: the three values that a run is made of.
template <class S, class C>
struct Checkpoint {
  State state;
  S scheme;
  C control;
  Outcome outcome = {};

  // Goes on to t_end, or until so many more steps are made.
  void go_on(const Problem& problem, double t_end, long steps = -1) {
    const auto watch = [&steps](const State&, const State&, double, const S&) { return --steps != 0; };
    outcome = integrate(problem, state, t_end, scheme, control, watch);
    if (outcome.status == Status::failed) throw std::runtime_error(outcome.reason);
  }
};

std::string counts(const Outcome& one) {
  return fmt::format("{} {} {} {}", one.steps, one.rejections, one.sweeps, one.evaluations);
}
Outcome sum(const Outcome& one, const Outcome& other) {
  Outcome both;
  both.steps = one.steps + other.steps;
  both.rejections = one.rejections + other.rejections;
  both.sweeps = one.sweeps + other.sweeps;
  both.evaluations = one.evaluations + other.evaluations;
  return both;
}

// The original goes on after the checkpoint was taken, the checkpoint after it: neither may see the other.
template <class S, class C>
void compare(Rows& rows, const std::string& which, const Problem& problem, const State& start, double t_end,
             const S& scheme, const C& control) {
  Checkpoint<S, C> whole{.state = start, .scheme = scheme, .control = control};
  Checkpoint<S, C> parts = whole;
  whole.go_on(problem, t_end);
  parts.go_on(problem, t_end, whole.outcome.steps / 2);
  const Outcome first_half = parts.outcome;
  Checkpoint<S, C> copy = parts;
  parts.go_on(problem, t_end);
  copy.go_on(problem, t_end);

  rows.equal("numbers that differ, " + which,
             {.expected = 0,
              .computed = differing(whole.state, parts.state) + differing(whole.state, copy.state) +
                          static_cast<long>(whole.control.dt() != parts.control.dt()) +
                          static_cast<long>(whole.control.dt() != copy.control.dt()),
              .because = "scheme, controller and state are all that a run remembers"});
  rows.equal("steps, refusals, sweeps, right-hand sides, " + which,
             {.expected = counts(whole.outcome),
              .computed = counts(sum(first_half, parts.outcome)),
              .because = "both parts together do the work of the whole"});
  rows.equal("the same of the copy, " + which, {.expected = counts(parts.outcome),
                                                .computed = counts(copy.outcome),
                                                .because = "it does what the original does"});
  rows.at_least("steps before the checkpoint, " + which,
                {.limit = 8, .computed = static_cast<double>(first_half.steps), .because = "a past worth keeping"});
}

template <class S>
void compare_near_field(Rows& rows, const std::string& method, NearFieldScene& scene, const S& scheme) {
  const State start = scenes::start(scene);
  compare(rows, method + ", fixed step", scene, start, 1.4, scheme, FixedStep{.step = 1.0 / 64.0});
  compare(rows, method + ", Phi_K control", scene, start, 1.4, scheme,
          PhiControl{.TOL = 1e-10, .K_d = 4, .step = 0.05, .limit = 0.05});
}

template <class Solver>
void compare_collocation(Rows& rows, const std::string& solver, NearFieldScene& scene) {
  const State start = scenes::start(scene);
  const Collocation<Gauss<4>, Solver> scheme({}, Solver());
  compare(rows, "Gauss 4, " + solver + ", fixed step", scene, start, 1.4, scheme, FixedStep{.step = 1.0 / 16.0});
  compare(rows, "Gauss 4, " + solver + ", error control", scene, start, 1.4, scheme,
          ErrorControl{.TOL = 1e-13, .sweep_TOL = 1e-13, .step = 0.02, .limit = 0.1});
}

void compare_stiff(Rows& rows) {
  VanDerPol problem{.mu = 100.0};
  const Collocation<Radau<3>, Newton<>> scheme({.sizes = Eigen::Vector2d{1.0, 1e-3}});
  compare(rows, "Radau 3, Newton, fixed step", problem, VanDerPol::start(), 20.0, scheme, FixedStep{.step = 0.5});
  compare(rows, "Radau 3, Newton, error control", problem, VanDerPol::start(), 100.0, scheme,
          ErrorControl{.TOL = 1e-6, .sweep_TOL = 1e-8, .K_d = 3, .step = 1e-3, .limit = 10.0, .growth = 8.0});
}

void compare_staggered(Rows& rows, const std::string& method, Seen seen, const std::optional<Aitken>& relaxation) {
  FirstOrderPair pair;
  pair.a << 1.0, 3.0, -3.0, 1.0;
  const int p = seen == Seen::newest ? 2 : 1;
  const Staggered scheme({{.name = "first", .TOL = 1e-9, .p = p}, {.name = "second", .TOL = 1e-7, .p = p}}, seen,
                         relaxation);
  const State start{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.7}};
  compare(rows, method + ", fixed step", pair, start, 1.0, scheme, FixedStep{.step = 1.0 / 32.0});
  compare(rows, method + ", Phi_K control", pair, start, 8.0, scheme,
          PhiControl{.TOL = 1.0, .K_d = 5, .step = 0.4, .limit = 0.4});
}

const Case continued_schemes{
    {.name = "continued_schemes",
     .claim = "every scheme under every controller can be stopped, copied and continued, to the same bits and the same "
              "counts",
     .equation = "R 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      NearFieldScene scene(random_cloud({.N = 8}, rows.case_seed()), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
      compare_near_field(rows, "forward Euler", scene, ForwardEuler{});
      compare_near_field(rows, "RK4", scene, RungeKutta4{});
      compare_near_field(rows, "velocity Verlet", scene, VelocityVerlet{});
      for (const double phi : {1.0, 0.5}) {
        compare_near_field(rows, fmt::format("phi = {}", phi), scene, BackwardEuler(phi));
        compare_near_field(rows, fmt::format("phi = {}, Anderson", phi), scene, PhiFamily<Anderson>(phi));
      }
      compare_collocation<Sequential>(rows, "sequential", scene);
      compare_collocation<Anderson>(rows, "Anderson", scene);
      compare_stiff(rows);
      compare_staggered(rows, "Gauss-Seidel", Seen::newest, {});
      compare_staggered(rows, "Gauss-Seidel with Aitken", Seen::newest, Aitken{});
      compare_staggered(rows, "Jacobi", Seen::previous, {});
    }};

}  // namespace verification::continued_schemes
