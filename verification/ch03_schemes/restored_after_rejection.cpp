// A refused step leaves no trace: replaying the accepted ones alone gives the same run.

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/staggering.hpp>

#include "bits.hpp"

namespace verification::restored_after_rejection {

using namespace particulate;
using namespace particulate::schemes;

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
Watched<C> compare(Rows& rows, const std::string& method, const Problem& problem, const State& start, double t_end,
                   const S& scheme, const C& control) {
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
  rows.equal("numbers that differ from a run without refusals, " + method,
             {.expected = 0, .computed = differ, .because = "a refused step leaves no trace"});
  rows.equal("steps refused in the replay, " + method,
             {.expected = 0, .computed = replayed.outcome.rejections, .because = "only accepted steps are tried"});
  rows.equal("steps that do not start where the last one ended, " + method,
             {.expected = 0,
              .computed = adaptive.broken,
              .because = "the observer sees every state once as from and once as to"});
  const Outcome& out = adaptive.outcome;
  rows.equal("steps, refusals and sweeps, " + method,
             {.expected = fmt::format("{} {} {}", watched.steps, watched.rejections, watched.swept),
              .computed = fmt::format("{} {} {}", out.steps, out.rejections, out.sweeps),
              .because = "counted by a controller of the case's own"});
  return watched;
}

// Right-hand sides of one run on the pair, which the case counts itself.
template <class S, class C>
Watched<C> compare_pair(Rows& rows, const std::string& method, const S& scheme, const C& control, long& evaluations) {
  NearFieldScene scene(pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = 0.1, .beta1 = 2.0, .beta2 = 3.0});
  Asked asked{.scene = scene};
  const Watched<C> watched = compare(rows, method, asked, scenes::start(scene), 1.5, scheme, control);
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
void compare_near_field(Rows& rows, const std::string& method, const S& scheme, int predictions) {
  const PhiControl control{.TOL = 1e-8, .K_d = 3, .step = 0.05, .limit = 0.05, .growth = 4.0};
  long evaluations = 0;
  const Watched<PhiControl> watched = compare_pair(rows, method, scheme, control, evaluations);
  rows.equal("right-hand sides, " + method + ", from sweeps and attempts",
             {.expected = watched.swept + predictions * (watched.steps + watched.rejections),
              .computed = evaluations,
              .because = "one a sweep, and one an attempt where the start's share counts"});
}

// Four stages; the first step, and its repetitions, ask for the rates at the start too.
template <class Solver>
void compare_collocation(Rows& rows, const std::string& solver) {
  const std::string method = "Gauss 4, " + solver;
  const ErrorControl control{
      .TOL = 1e-8, .sweep_TOL = 1e-10, .K_d = 2, .allowed = 2, .step = 0.05, .limit = 0.2, .safety = 1.0};
  long evaluations = 0;
  const Watched<ErrorControl> watched =
      compare_pair(rows, method, Collocation<Gauss<4>, Solver>({}, Solver()), control, evaluations);
  const long beyond = evaluations - 4 * watched.swept;
  rows.at_least("right-hand sides beyond four a sweep, " + method,
                {.limit = 1.0, .computed = static_cast<double>(beyond), .because = "the guess of the first step"});
  rows.at_most("right-hand sides beyond four a sweep, " + method,
               {.limit = 10.0,
                .computed = static_cast<double>(beyond),
                .because = "one an attempt at the first step: all later guesses extrapolate, after a refusal too"});
}

// A pair whose coefficients let the sweeps fail at the limit and whose decay makes the steps grow again.
void compare_staggered(Rows& rows, const std::string& method, const std::optional<Aitken>& relaxation, Seen seen,
                       int p) {
  FirstOrderPair pair;
  pair.a << 1.0, 3.0, -3.0, 1.0;
  const Staggered scheme({{.name = "first", .TOL = 1e-8, .p = p}, {.name = "second", .TOL = 1e-6, .p = p}}, seen,
                         relaxation);
  const PhiControl control{.TOL = 1.0, .K_d = 2, .step = 0.4, .limit = 0.4, .growth = 64.0};
  const State start{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.5}};
  compare(rows, method, pair, start, 0.3, scheme, control);
}

const Case restored_after_rejection{
    {.name = "restored_after_rejection",
     .claim = "a run whose steps are refused again and again equals, bit for bit, the run that tries only the accepted "
              "ones, and its counts are those of an independent count",
     .equation = "R 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      compare_near_field(rows, "phi = 1", BackwardEuler{}, 0);
      compare_near_field(rows, "phi = 1/2", BackwardEuler(0.5), 1);
      compare_near_field(rows, "phi = 1, Anderson", PhiFamily<Anderson>(1.0, Anderson(2)), 0);
      compare_collocation<Sequential>(rows, "sequential");
      compare_collocation<Anderson>(rows, "Anderson");
      compare_staggered(rows, "Gauss-Seidel", {}, Seen::newest, 2);
      compare_staggered(rows, "Gauss-Seidel with Aitken", Aitken{}, Seen::newest, 2);
      compare_staggered(rows, "Jacobi", {}, Seen::previous, 1);
    }};

}  // namespace verification::restored_after_rejection
