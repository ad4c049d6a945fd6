// The controller meets its tolerance in every step, and the answer is wrong: it bounds one error of two.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "linear_problems.hpp"

namespace verification::iteration_error_only {

using namespace particulate;
using namespace particulate::schemes;

constexpr double t_end = 2.0, alpha2 = 0.5;
const ExactBreathing exact{.force = kinematics::breathing_pair(1.0, alpha2, 1.0, 1.0), .r_0 = 1.0};

NearFieldScene breathing() {
  return {pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
}

// Phi_K control that writes down the largest error it accepted.
struct Honest {
  PhiControl control;
  double worst = 0.0;

  double dt() const { return control.dt(); }
  bool goes_on(const Iteration& it) const { return control.goes_on(it); }
  Decision judge(const Attempt& made) {
    Decision decision = control.judge(made);
    if (decision.accepted) keep_worst(worst, made.iteration.w_K);
    return decision;
  }
};
void validate(const Honest& honest) { validate(honest.control); }

struct Answer {
  State state;
  double error = 0.0;  // of positions, over the farthest
  double worst_w = 0.0;
};

Answer solve(double TOL, double limit) {
  NearFieldScene scene = breathing();
  Answer answer{.state = scenes::start(scene)};
  BackwardEuler scheme;
  Honest control{.control = {.TOL = TOL, .K_d = 20, .step = limit, .limit = limit}};
  require_reached(integrate(scene, answer.state, t_end, scheme, control));
  BreathingErrors errors;
  compare_with(exact, pair_shape(1.0, 1.0), answer.state, errors);
  answer.error = errors.position;
  answer.worst_w = control.worst;
  return answer;
}

// How far particles moved from one state to another, each by itself, then summed.
double moved(const State& from, const State& to) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < from.r.size() / 3; ++i) {
    sum += (rows_of(to.r).row(i) - rows_of(from.r).row(i)).norm();
  }
  return sum;
}

// What is compared with TOL: particles that move unequally far tell a sum from a largest and from one norm over all.
void compare_measure(Rows& rows) {
  const NearFieldScene scene(random_cloud({.N = 5}, smooth), {},
                             {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0});
  const State from = scenes::start(scene);
  const auto swept = sweep_by_hand(BackwardEuler{}, scene, from, 1e-2, 3);
  const std::vector<State>& at = swept.iterates;
  const double displacement = moved(from, at[1]);
  for (std::size_t k = 0; k < 3; ++k) {
    rows.compare(fmt::format("w_{} of five particles", k),
                 {.expected = moved(at[k], at[k + 1]) / displacement,
                  .computed = swept.iterations[k].w_K,
                  .tolerance = absolute(64.0 * eps / displacement),
                  .because = "differences of positions of a few m, five of them, over the displacement"});
  }
}

void compare_wrong(Rows& rows) {
  constexpr double limit = 0.02;
  std::vector<double> errors;
  for (const double TOL : {1e-6, 1e-12}) {
    const Answer answer = solve(TOL, limit);
    rows.at_most(fmt::format("largest w_K of a step over TOL = {}", TOL),
                 {.limit = 1.0, .computed = answer.worst_w / TOL, .because = "the controller keeps its promise"});
    rows.at_least(fmt::format("error of positions, TOL = {}", TOL),
                  {.limit = 0.1,
                   .computed = answer.error,
                   .because = "backward Euler with 100 steps of 0.02 s loses energy that the closed form keeps"});
    errors.push_back(answer.error);
  }
  rows.compare("error of positions at TOL = 1e-12 over that at 1e-6",
               {.expected = 1.0,
                .computed = errors[1] / errors[0],
                .tolerance = relative(1e-4),
                .because = "100 steps, each changed by less than 1e-6 of its displacement"});
}

void compare_limits(Rows& rows) {
  for (const double TOL : {1e-6, 1e-12}) {
    std::vector<double> limits, errors;
    for (double limit = 4e-4; limits.size() < 5; limit /= 2.0) {
      limits.push_back(limit);
      errors.push_back(solve(TOL, limit).error);
    }
    rows.order(fmt::format("error of positions over Dt_lim, TOL = {}", TOL),
               {.nominal = 1.0,
                .steps = limits,
                .errors = errors,
                .floor = 1e-9,
                .because = "every step is Dt_lim; floor: what TOL = 1e-6 leaves"});
  }
}

// The iteration's own share: the difference to sweeps that went on to rounding at the same steps.
void compare_tolerances(Rows& rows) {
  constexpr double step = 5e-3;
  NearFieldScene scene = breathing();
  const auto run = [&](const FixedStep& settings) {
    State state = scenes::start(scene);
    BackwardEuler scheme;
    FixedStep control = settings;
    require_reached(integrate(scene, state, t_end, scheme, control));
    return state;
  };
  const State settled = run({.step = step});
  std::vector<double> tolerances, errors;
  for (double TOL = 1e-2; tolerances.size() < 11; TOL /= std::sqrt(10.0)) {
    tolerances.push_back(TOL);
    errors.push_back((run({.step = step, .TOL = TOL}).r - settled.r).norm() / settled.r.norm());
  }
  rows.order("difference to sweeps that went on to rounding, over TOL",
             {.nominal = 1.0,
              .steps = tolerances,
              .errors = errors,
              .floor = 1e-14,
              .because = "the last change of every step is some share of TOL, a mean over 400 steps"});
}

const Case iteration_error_only{
    {.name = "iteration_error_only",
     .claim = "TOL bounds the iteration's error, to which it is proportional, and nothing else: it is met in every "
              "step of an answer that is 10 % off and that only a smaller Dt_lim mends",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_measure(rows);
      compare_wrong(rows);
      compare_limits(rows);
      compare_tolerances(rows);
    }};

}  // namespace verification::iteration_error_only
