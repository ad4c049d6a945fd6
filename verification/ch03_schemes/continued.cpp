// Runs that are stopped and continued, and steps that are refused and leave no trace.

#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

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

namespace verification::continued {

using namespace particulate;
using namespace particulate::schemes;

// A run that is stopped, copied and continued repeats the uninterrupted one to the last bit.

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
    if (outcome.status == Status::failed) throw std::runtime_error(describe(outcome));
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

// The original goes on after the checkpoint was taken, the checkpoint after it: neither may see the other. A scheme
// whose history would be wrong if the problem had changed asks once more.
template <class S, class C>
void compare_continued(Rows& rows, const std::string& which, const Problem& problem, const State& start, double t_end,
                       const S& scheme, const C& control) {
  constexpr bool first_same_as_last = std::is_same_v<S, RungeKutta4> && std::is_same_v<C, ErrorControl>;
  constexpr bool asks_again =
      std::is_same_v<S, VelocityVerlet> || std::is_base_of_v<AnyCollocation, S> || first_same_as_last;
  constexpr long asked_again = asks_again ? 1 : 0;
  Checkpoint<S, C> whole{.state = start, .scheme = scheme, .control = control};
  Checkpoint<S, C> parts = whole;
  whole.go_on(problem, t_end);
  parts.go_on(problem, t_end, whole.outcome.steps / 2);
  Outcome first_half = parts.outcome;
  Checkpoint<S, C> copy = parts;
  parts.go_on(problem, t_end);
  copy.go_on(problem, t_end);

  rows.none("numbers that differ, " + which,
            differing(whole.state, parts.state) + differing(whole.state, copy.state) +
                static_cast<long>(whole.control.dt() != parts.control.dt()) +
                static_cast<long>(whole.control.dt() != copy.control.dt()),
            "scheme, controller and state are all that a run remembers");
  first_half.evaluations -= asked_again;
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
void continue_near_field(Rows& rows, const std::string& method, NearFieldScene& scene, const S& scheme) {
  const State start = scenes::start(scene);
  compare_continued(rows, method + ", fixed step", scene, start, 1.4, scheme, FixedStep{.step = 1.0 / 64.0});
  if constexpr (Iterative<S>) {
    compare_continued(rows, method + ", Phi_K control", scene, start, 1.4, scheme,
                      PhiControl{.TOL = 1e-10, .K_d = 4, .step = 0.05, .limit = 0.05});
  }
  if constexpr (EstimatesTruncation<S>) {
    compare_continued(rows, method + ", error control", scene, start, 1.4, scheme,
                      ErrorControl{.TOL = 1e-4, .sweep_TOL = 1e-8, .step = 0.02, .limit = 0.1});
  }
}

template <class Solver>
void continue_collocation(Rows& rows, const std::string& solver, NearFieldScene& scene) {
  const State start = scenes::start(scene);
  const Collocation<Gauss<4>, Solver> scheme({}, Solver());
  compare_continued(rows, "Gauss 4, " + solver + ", fixed step", scene, start, 1.4, scheme,
                    FixedStep{.step = 1.0 / 16.0});
  compare_continued(rows, "Gauss 4, " + solver + ", error control", scene, start, 1.4, scheme,
                    ErrorControl{.TOL = 1e-13, .sweep_TOL = 1e-13, .step = 0.02, .limit = 0.1});
}

void continue_stiff(Rows& rows) {
  VanDerPol problem{.mu = 100.0};
  const Collocation<Radau<3>, Newton<>> scheme({.sizes = Eigen::Vector2d{1.0, 1e-3}});
  compare_continued(rows, "Radau 3, Newton, fixed step", problem, VanDerPol::start(), 20.0, scheme,
                    FixedStep{.step = 0.5});
  compare_continued(rows, "Radau 3, Newton, error control", problem, VanDerPol::start(), 100.0, scheme,
                    ErrorControl{.TOL = 1e-6, .sweep_TOL = 1e-8, .K_d = 3, .step = 1e-3, .limit = 10.0, .growth = 8.0});
}

void continue_staggered(Rows& rows, const std::string& method, Seen seen, const std::optional<Aitken>& relaxation) {
  FirstOrderPair pair;
  pair.a << 1.0, 3.0, -3.0, 1.0;
  const int p = seen == Seen::newest ? 2 : 1;
  const Staggered scheme({{.name = "first", .TOL = 1e-9, .p = p}, {.name = "second", .TOL = 1e-7, .p = p}}, seen,
                         relaxation);
  const State start{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.7}};
  compare_continued(rows, method + ", fixed step", pair, start, 1.0, scheme, FixedStep{.step = 1.0 / 32.0});
  compare_continued(rows, method + ", Phi_K control", pair, start, 8.0, scheme,
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
      continue_near_field(rows, "forward Euler", scene, ForwardEuler{});
      continue_near_field(rows, "RK4", scene, RungeKutta4{});
      continue_near_field(rows, "velocity Verlet", scene, VelocityVerlet{});
      for (const double phi : {1.0, 0.5}) {
        continue_near_field(rows, fmt::format("phi = {}", phi), scene, BackwardEuler(phi));
        continue_near_field(rows, fmt::format("phi = {}, Anderson", phi), scene, PhiFamily<Anderson>(phi));
      }
      continue_collocation<Sequential>(rows, "sequential", scene);
      continue_collocation<Anderson>(rows, "Anderson", scene);
      continue_stiff(rows);
      continue_staggered(rows, "Gauss-Seidel", Seen::newest, {});
      continue_staggered(rows, "Gauss-Seidel with Aitken", Seen::newest, Aitken{});
      continue_staggered(rows, "Jacobi", Seen::previous, {});
    }};

// A refused step leaves no trace: replaying the accepted ones alone gives the same run.

double sweep_tolerance(const PhiControl& control) { return control.TOL; }
double sweep_tolerance(const ErrorControl& control) { return control.sweep_TOL; }

// Tries, one after the other, the steps that another run accepted; sweeps as that run did.
template <class C>
struct Replayed {
  std::vector<double> steps;
  C control;
  std::size_t next = 0;

  double dt() const { return steps.at(next); }
  bool goes_on(const Iteration& it) const { return control.goes_on(it); }
  Decision judge(const Attempt& made) {
    if (!(made.iteration.evaluated && made.iteration.w_K <= sweep_tolerance(control))) {
      return {.accepted = false, .impossible = "a step that was accepted before is refused now"};
    }
    if (next + 1 < steps.size()) ++next;
    return {.accepted = true};
  }
};
template <class C>
void validate(const Replayed<C>&) {}

// Counts by itself what the run claims to have counted.
template <class C>
struct Watched {
  static constexpr bool ignores_truncation = IgnoresTruncation<C>;
  C control;
  long steps = 0, rejections = 0, swept = 0;

  double dt() const { return control.dt(); }
  bool goes_on(const Iteration& it) const { return control.goes_on(it); }
  Decision judge(const Attempt& made) {
    swept += made.iteration.K + 1;
    Decision decision = control.judge(made);
    ++(decision.accepted ? steps : rejections);
    return decision;
  }
};
template <class C>
void validate(const Watched<C>& watched) {
  validate(watched.control);
}

// Counts right-hand sides by itself.
struct Asked {
  NearFieldScene& scene;
  long evaluations = 0;

  bool acceleration(double t, In r, Out a) {
    ++evaluations;
    return scene.acceleration(t, r, a);
  }
  double distance(In x, In y) const { return scene.distance(x, y); }
};

struct Run {
  std::vector<State> states;
  std::vector<double> steps;
  Outcome outcome = {};
  long broken = 0;  // accepted steps that did not start where the last one ended
};

template <class S, class C>
Run run(const Problem& problem, const State& start, double t_end, S scheme, C& control) {
  Run seen{.states = {start}, .steps = {}};
  State state = start;
  const auto keep = [&](const State& from, const State& to, double dt, const S&) {
    if (differing(from, seen.states.back()) != 0) ++seen.broken;
    seen.states.push_back(to);
    seen.steps.push_back(dt);
    return true;
  };
  seen.outcome = integrate(problem, state, t_end, scheme, control, keep);
  require_reached(seen.outcome);
  return seen;
}

// What every such run must show; returns what its controller counted.
template <class S, class C>
Watched<C> compare_restored(Rows& rows, const std::string& method, const Problem& problem, const State& start,
                            double t_end, const S& scheme, const C& control) {
  Watched<C> watched{.control = control};
  const Run adaptive = run(problem, start, t_end, scheme, watched);
  Replayed<C> again{.steps = adaptive.steps, .control = control};
  const Run replayed = run(problem, start, t_end, scheme, again);
  long differ = 0;
  for (std::size_t k = 0; k < adaptive.states.size(); ++k) {
    differ += differing(adaptive.states[k], replayed.states.at(k));
  }
  rows.at_least("steps refused, " + method, {.limit = 10,
                                             .computed = static_cast<double>(adaptive.outcome.rejections),
                                             .because = "settings that provoke refusals, or nothing is shown"});
  rows.none("numbers that differ from a run without refusals, " + method, differ, "a refused step leaves no trace");
  rows.none("steps refused where only the accepted ones are tried, " + method, replayed.outcome.rejections,
            "only accepted steps are tried");
  rows.none("steps that do not start where the last one ended, " + method, adaptive.broken,
            "the observer sees every state once as from and once as to");
  const Outcome& out = adaptive.outcome;
  rows.equal("steps, refusals and sweeps, " + method,
             {.expected = fmt::format("{} {} {}", watched.steps, watched.rejections, watched.swept),
              .computed = fmt::format("{} {} {}", out.steps, out.rejections, out.sweeps),
              .because = "counted by a controller of the case's own"});
  return watched;
}

// Right-hand sides of one run on the pair, which the case counts itself.
template <class S, class C>
Watched<C> restore_pair(Rows& rows, const std::string& method, const S& scheme, const C& control, long& evaluations) {
  NearFieldScene scene(pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = 0.1, .beta1 = 2.0, .beta2 = 3.0});
  Asked asked{.scene = scene};
  const Watched<C> watched = compare_restored(rows, method, asked, scenes::start(scene), 1.5, scheme, control);
  // The problem was asked by the replay too, which did what was accepted.
  const long before = asked.evaluations;
  Watched<C> fresh{.control = control};
  const auto once = run(asked, scenes::start(scene), 1.5, scheme, fresh);
  evaluations = once.outcome.evaluations;
  rows.equal("right-hand sides, " + method, {.expected = asked.evaluations - before,
                                             .computed = evaluations,
                                             .because = "counted by a problem of the case's own"});
  return watched;
}

template <class S>
void restore_near_field(Rows& rows, const std::string& method, const S& scheme, int predictions) {
  const PhiControl control{.TOL = 1e-8, .K_d = 3, .step = 0.05, .limit = 0.05, .growth = 4.0};
  long evaluations = 0;
  const Watched<PhiControl> watched = restore_pair(rows, method, scheme, control, evaluations);
  rows.equal("right-hand sides, " + method + ", from sweeps and attempts",
             {.expected = watched.swept + predictions * (watched.steps + watched.rejections),
              .computed = evaluations,
              .because = "one a sweep, and one an attempt where the start's share counts"});
}

// Four stages; the first step, and its repetitions, ask for the rates at the start too.
template <class Solver>
void restore_collocation(Rows& rows, const std::string& solver) {
  const std::string method = "Gauss 4, " + solver;
  const ErrorControl control{
      .TOL = 1e-8, .sweep_TOL = 1e-10, .K_d = 2, .allowed = 2, .step = 0.05, .limit = 0.2, .safety = 1.0};
  long evaluations = 0;
  const Watched<ErrorControl> watched =
      restore_pair(rows, method, Collocation<Gauss<4>, Solver>({}, Solver()), control, evaluations);
  const long beyond = evaluations - 4 * watched.swept;
  rows.at_least("right-hand sides beyond four a sweep, " + method,
                {.limit = 1.0, .computed = static_cast<double>(beyond), .because = "the guess of the first step"});
  rows.at_most("right-hand sides beyond four a sweep, " + method,
               {.limit = 10.0,
                .computed = static_cast<double>(beyond),
                .because = "one an attempt at the first step: all later guesses extrapolate, after a refusal too"});
}

// A pair whose coefficients let the sweeps fail at the limit and whose decay makes the steps grow again.
void restore_staggered(Rows& rows, const std::string& method, const std::optional<Aitken>& relaxation, Seen seen,
                       int p) {
  FirstOrderPair pair;
  pair.a << 1.0, 3.0, -3.0, 1.0;
  const Staggered scheme({{.name = "first", .TOL = 1e-8, .p = p}, {.name = "second", .TOL = 1e-6, .p = p}}, seen,
                         relaxation);
  const PhiControl control{.TOL = 1.0, .K_d = 2, .step = 0.4, .limit = 0.4, .growth = 64.0};
  const State start{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.5}};
  compare_restored(rows, method, pair, start, 0.3, scheme, control);
}

const Case restored_after_rejection{
    {.name = "restored_after_rejection",
     .claim = "a run whose steps are refused again and again equals, bit for bit, the run that tries only the accepted "
              "ones, and its counts are those of an independent count",
     .equation = "R 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      restore_near_field(rows, "phi = 1", BackwardEuler{}, 0);
      restore_near_field(rows, "phi = 1/2", BackwardEuler(0.5), 1);
      restore_near_field(rows, "phi = 1, Anderson", PhiFamily<Anderson>(1.0, Anderson(2)), 0);
      restore_collocation<Sequential>(rows, "sequential");
      restore_collocation<Anderson>(rows, "Anderson");
      restore_staggered(rows, "Gauss-Seidel", {}, Seen::newest, 2);
      restore_staggered(rows, "Gauss-Seidel with Aitken", Aitken{}, Seen::newest, 2);
      restore_staggered(rows, "Jacobi", {}, Seen::previous, 1);
    }};

}  // namespace verification::continued
