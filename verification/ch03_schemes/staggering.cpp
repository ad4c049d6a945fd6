// Staggered fields: the factor of a sweep, and which field sets the step.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "linear_problems.hpp"

namespace verification::staggering {

using namespace particulate::schemes;

// The factor of a staggered sweep, against theory: below, at and beyond the step where it is one.

constexpr double above_rounding = 1e-10, tolerance_of_ratio = 4.0 * eps / above_rounding;
constexpr auto ratios_rounded = "ratios of changes that are above 1e-10 of numbers near 1, four roundings each";

Staggered staggered(int p, Seen seen = Seen::newest, std::optional<Aitken> relaxation = {}) {
  return Staggered({{.name = "first", .TOL = 1e-6, .p = p}, {.name = "second", .TOL = 1e-6, .p = p}}, seen, relaxation);
}

// Changes of one number of the state from sweep to sweep, with their sign.
std::vector<double> signed_changes(const Sweeps& swept, Eigen::Index of) {
  std::vector<double> changes;
  for (std::size_t k = 1; k < swept.iterates.size(); ++k) {
    changes.push_back(swept.iterates[k].y[of] - swept.iterates[k - 1].y[of]);
  }
  return changes;
}

// The signed ratio over `stride` sweeps farthest from what is expected, from sweep `first` on.
double farthest_ratio(const std::vector<double>& change, std::size_t first, std::size_t stride, double expected) {
  double farthest = missing;
  for (std::size_t k = first + stride; k < change.size() && std::abs(change[k]) > above_rounding; ++k) {
    const double ratio = change[k] / change[k - stride];
    if (std::isnan(farthest) || std::abs(ratio - expected) > std::abs(farthest - expected)) farthest = ratio;
  }
  return farthest;
}

// Both fields, both kinds of sweep. The first field's first change comes from the second's start, not from a sweep, so
// that its law holds from its second change on. A Jacobi sweep has two eigenvalues of opposite sign, or imaginary ones:
// over two sweeps both are the factor of Gauss-Seidel.
void compare_pair(Rows& rows, const std::string& which, const Problem& pair, const State& start, double dt,
                  double factor) {
  const Eigen::Index second = start.y.size() / 2;
  const Sweeps gauss_seidel = sweep_by_hand(staggered(2), pair, start, dt, 30);
  const Sweeps jacobi = sweep_by_hand(staggered(1, Seen::previous), pair, start, dt, 60);
  const auto compare = [&](const std::string& what, double ratio) {
    rows.compare(
        what + ", " + which,
        {.expected = factor, .computed = ratio, .tolerance = relative(tolerance_of_ratio), .because = ratios_rounded});
  };
  compare("Gauss-Seidel, first field", farthest_ratio(signed_changes(gauss_seidel, 0), 1, 1, factor));
  compare("Gauss-Seidel, second field", farthest_ratio(signed_changes(gauss_seidel, second), 0, 1, factor));
  compare("two Jacobi sweeps, first field", farthest_ratio(signed_changes(jacobi, 0), 0, 2, factor));
  compare("two Jacobi sweeps, second field", farthest_ratio(signed_changes(jacobi, second), 0, 2, factor));
}

FirstOrderPair first_order(double a11, double a12, double a21, double a22) {
  FirstOrderPair pair;
  pair.a << a11, a12, a21, a22;
  return pair;
}

const State two{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.7}};
const State four{.t = 0.0, .y = Eigen::Vector4d{1.0, 0.4, 0.7, -0.3}};

const Case staggering_contraction{
    {.name = "staggering_contraction",
     .claim = "a Gauss-Seidel sweep multiplies errors by dt^2/(ab), dt^4/(ab), and with each field's own decay by dt^2 "
              "a12 a21/((1 + dt a11)(1 + dt a22)); two Jacobi sweeps do the same",
     .equation = "R 7.5.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double a : {0.5, 2.0}) {
        for (const double b : {1.0, -3.0}) {
          for (const double dt : {0.1, 0.6}) {
            const std::string with = fmt::format("a = {}, b = {}, dt = {}", a, b, dt);
            const FirstOrderPair first = first_order(0.0, 1.0 / a, 1.0 / b, 0.0);
            const SecondOrderPair second{.c12 = 1.0 / a, .c21 = 1.0 / b};
            compare_pair(rows, "first order, " + with, first, two, dt, dt * dt / (a * b));
            compare_pair(rows, "second order, " + with, second, four, dt, std::pow(dt, 4) / (a * b));
          }
        }
      }
      for (const double dt : {0.05, 0.3, 0.499, 0.501}) {
        const FirstOrderPair turning = first_order(1.0, 3.0, -3.0, 1.0), driven = first_order(2.0, 4.0, 1.0, 0.5);
        const double q = dt * dt * 3.0 * -3.0 / ((1.0 + dt) * (1.0 + dt));
        compare_pair(rows, fmt::format("a11 = a22 = 1, a12 = -a21 = 3, dt = {}", dt), turning, two, dt, q);
        const double other = dt * dt * 4.0 / ((1.0 + 2.0 * dt) * (1.0 + 0.5 * dt));
        compare_pair(rows, fmt::format("a11 = 2, a22 = 1/2, a12 = 4, a21 = 1, dt = {}", dt), driven, two, dt, other);
      }
    }};

const FirstOrderPair stable_physics = first_order(1.0, 3.0, -3.0, 1.0);

// What the scheme itself reports of the error's factor: q = -0.09/1.21 at dt = 0.1.
void compare_reported(Rows& rows) {
  std::vector<double> w;
  for (const auto& fields : sweep_by_hand(staggered(2), stable_physics, two, 0.1, 4).parts) w.push_back(fields[1].w_K);
  for (std::size_t k = 1; k < w.size(); ++k) {
    rows.compare(fmt::format("w_{} over w_{} of the second field at dt = 0.1", k, k - 1),
                 {.expected = 0.09 / 1.21,
                  .computed = w[k] / w[k - 1],
                  .tolerance = relative(1e-10),
                  .because = "frozen denominator: the ratio of changes; over each sweep's own displacement the first "
                             "would be |q|/(1 - |q|) = 0.0804"});
  }
}

// Runs that must end at the coupled backward Euler steps that Cramer's rule gives.
template <class C>
Ending decay(double t_end, C control, const std::optional<Aitken>& relaxation, double tolerance_here,
             const std::string& reason, Outcome* out = nullptr) {
  FirstOrderPair pair = stable_physics;
  Staggered scheme = staggered(2, Seen::newest, relaxation);
  State state = two;
  Eigen::Vector2d exact = two.y;
  const auto follow = [&](const State&, const State&, double dt, const Staggered&) {
    exact = implicit_step(stable_physics.a, dt, exact);
    return true;
  };
  const Outcome outcome = integrate(pair, state, t_end, scheme, control, follow);
  if (out != nullptr) *out = outcome;
  if (outcome.status != Status::reached) return Ending::refused(outcome.reason);
  return Ending::solved(
      {.error = (state.y - exact).norm() / exact.norm(), .tolerance = tolerance_here, .because = reason});
}

void prove_staggering_limit(Rows& rows) {
  constexpr int plenty = 20000;
  rows.must_be_solved("dt = 0.499 at a fixed step", [] {
    return decay(3.0 * 0.499, FixedStep{.step = 0.499, .TOL = 1e-6, .contractions = plenty}, {}, 3.0 * 375.0 * 1e-12,
                 "three steps, each of whose sweeps stop within 1e-6 of TOL = 1e-6 of each other, at most 1/(1 - "
                 "0.99733) = 375 times nearer than their limit");
  });
  Outcome refused;
  rows.must_be_refused("dt = 0.501 at a fixed step", "diverge 1.003 Dt field", [&] {
    return decay(3.0 * 0.501, FixedStep{.step = 0.501, .TOL = 1.0, .contractions = 1000}, {}, 0.0,
                 "it should not come to this", &refused);
  });
  rows.at_most("workable step, told with the refusal at 0.501 [s]",
               {.limit = 0.5, .computed = refused.workable_step, .because = "sweeps contract below 0.5 only"});
  rows.at_least(
      "workable step, told with the refusal at 0.501, at least [s]",
      {.limit = 0.49, .computed = refused.workable_step, .because = "1e-6^(1/2000) = 0.993 of 0.5, by the model"});
  Outcome adaptive;
  rows.must_be_solved("dt = 0.501 at first, Phi_K control", [&] {
    return decay(6.0, PhiControl{.TOL = 1.0, .K_d = 20, .step = 0.501, .limit = 0.501}, {}, 1e-4,
                 "some twenty steps, each within some TOL = 1e-6 of its first displacement", &adaptive);
  });
  rows.at_least("steps refused on the way", {.limit = 1,
                                             .computed = static_cast<double>(adaptive.rejections),
                                             .because = "no sweeps meet their tolerance at 0.501"});
  for (const double dt : {0.501, 5.0}) {
    rows.must_be_solved(fmt::format("dt = {} at a fixed step, Aitken", dt), [=] {
      return decay(3.0 * dt, FixedStep{.step = dt}, Aitken{}, 1e-13,
                   "the secant of a linear map ends at rounding; three steps, some tens of roundings each");
    });
  }
  compare_reported(rows);
}

const Case staggering_limit{
    {.name = "staggering_limit",
     .claim = "fields that decay are staggered in vain beyond dt = 1/2: a fixed step is refused and told of a smaller "
              "one, the adaptive step shrinks, Aitken's relaxation solves it as it stands",
     .equation = "R 7.5.2",
     .reference = Reference::closed_form},
    prove_staggering_limit};

// Which of several fields sets the step, and to what.

// What the text says, from iterates alone: errors over the displacement of the first change, and Phi_K of each field.
struct ByHand {
  double w_0 = 0.0, w_K = 0.0, phi = 0.0;
};

ByHand by_hand(const Sweeps& swept, Eigen::Index field, int p, double TOL, int K_d) {
  ByHand hand;
  double displacement = 0.0;
  int K = -1;
  for (std::size_t k = 1; k < swept.iterates.size(); ++k) {
    const double change = std::abs(swept.iterates[k].y[field] - swept.iterates[k - 1].y[field]);
    if (K < 0 && change == 0.0) continue;
    if (++K == 0) displacement = std::abs(swept.iterates[k].y[field] - swept.iterates[0].y[field]);
    (K == 0 ? hand.w_0 : hand.w_K) = change / displacement;
  }
  hand.phi = std::pow(TOL / hand.w_0, 1.0 / (p * K_d)) * std::pow(hand.w_0 / hand.w_K, 1.0 / (p * K));
  return hand;
}

struct Setting {
  std::array<double, 2> TOL;
  std::array<int, 2> p;
  std::string controls;  // the field that must control, by reasoning
};

// Three sweeps of one step are judged, as the controller would, and as the text says.
void compare_judgement(Rows& rows, const FirstOrderPair& pair, const State& from, double dt, const Setting& setting) {
  constexpr int K_d = 3;
  const std::array<std::string_view, 2> names{"first", "second"};
  const Staggered scheme({{.name = names[0], .TOL = setting.TOL[0], .p = setting.p[0]},
                          {.name = names[1], .TOL = setting.TOL[1], .p = setting.p[1]}});
  const Sweeps swept = sweep_by_hand(scheme, pair, from, dt, K_d + 1);
  const Iteration& last = swept.iterations.back();

  std::array<ByHand, 2> hand;
  double worst = 0.0, smallest = std::numeric_limits<double>::infinity();
  std::size_t controlling = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    hand[k] = by_hand(swept, static_cast<Eigen::Index>(k), setting.p[k], setting.TOL[k], K_d);
    worst = particulate::report::worse_of(worst, hand[k].w_K / setting.TOL[k]);
    if (hand[k].phi < smallest) controlling = k;
    smallest = std::min(smallest, hand[k].phi);
  }
  PhiControl control{
      .TOL = 1.0, .K_d = K_d, .step = dt, .limit = 1e3, .growth = 1e3, .retry = 0.999999, .shrink = 1e-6};
  const Decision decision = control.judge({.dt = dt, .iteration = last, .fields = swept.parts.back()});
  const std::string which =
      fmt::format(", TOL = {}, {}, p = {}, {}", setting.TOL[0], setting.TOL[1], setting.p[0], setting.p[1]);
  constexpr auto because = "errors of 1e-4 and more of numbers near 1";
  rows.compare("largest w_K/TOL" + which,
               {.expected = worst, .computed = last.w_K, .tolerance = relative(1e-10), .because = because});
  rows.equal("accepted" + which,
             {.expected = worst <= 1.0, .computed = decision.accepted, .because = "w_K <= TOL for all"});
  rows.compare("next step over this one" + which,
               {.expected = smallest, .computed = control.step / dt, .tolerance = relative(1e-10), .because = because});
  rows.equal("controlling field" + which, {.expected = std::string(names[controlling]),
                                           .computed = std::string(control.controlling),
                                           .because = "the smallest Phi_K, from the iterates alone"});
  rows.equal("controlling field by reasoning" + which, {.expected = setting.controls,
                                                        .computed = std::string(control.controlling),
                                                        .because = "the field with much the smaller TOL, or else p"});
}

const Case staggering_control{
    {.name = "staggering_control",
     .claim = "a step stands if every field meets its own tolerance, the smallest Phi_K of all fields sets the next "
              "one, and the controller names that field",
     .equation = "R 7.5.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      FirstOrderPair pair;
      pair.a << 2.0, 4.0, 1.0, 0.5;
      const State from{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.7}};
      const std::array<Setting, 6> settings{{{{1e-1, 1e-2}, {2, 2}, "second"},
                                             {{1e-8, 1e-2}, {2, 2}, "first"},
                                             {{1e-2, 1e-8}, {2, 2}, "second"},
                                             {{1e-3, 1e-3}, {1, 4}, "first"},
                                             {{1e-3, 1e-3}, {4, 1}, "second"},
                                             {{1e-3, 1.0}, {2, 1}, "first"}}};
      for (const Setting& setting : settings) compare_judgement(rows, pair, from, 0.3, setting);
    }};

// The step that a run proposes after one step.
PhiControl proposed(const FirstOrderPair& pair, const State& from, double dt, const Staggered& scheme, int K_d) {
  Staggered fresh = scheme;
  State state = from;
  PhiControl control{.TOL = 1.0, .K_d = K_d, .step = dt, .limit = 1e3, .growth = 1e3};
  require_reached(integrate(pair, state, dt, fresh, control));
  return control;
}

const Case staggering_prediction{
    {.name = "staggering_prediction",
     .claim = "for a w1' + w2 = 0, b w2' + w1 = 0 the next step is sqrt(ab) min TOL_k^(1/(p K_d)), whatever the last "
              "one was: p = 2 by Gauss-Seidel, p = 1 by Jacobi",
     .equation = "R 7.5.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double a = 2.0, b = 0.8;
      constexpr int K_d = 10;
      FirstOrderPair pair;
      pair.a << 0.0, 1.0 / a, 1.0 / b, 0.0;
      // One field alone moves at first, so that the changes of both are one geometric sequence each, from 1 on.
      const State one_moves{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.0}};
      // Along an eigenvector of the Jacobi sweep.
      const State together{.t = 0.0, .y = Eigen::Vector2d{1.0 / std::sqrt(a), 1.0 / std::sqrt(b)}};
      for (const double dt : {0.05, 0.1, 0.3}) {
        for (const bool newest : {true, false}) {
          const int p = newest ? 2 : 1;
          const Staggered scheme({{.name = "first", .TOL = 1e-4, .p = p}, {.name = "second", .TOL = 1e-5, .p = p}},
                                 newest ? Seen::newest : Seen::previous);
          const PhiControl control = proposed(pair, newest ? one_moves : together, dt, scheme, K_d);
          const std::string which = fmt::format(", {}, dt = {}", newest ? "Gauss-Seidel" : "Jacobi", dt);
          rows.compare("next step" + which + " [s]",
                       {.expected = std::sqrt(a * b) * std::pow(1e-5, 1.0 / (p * K_d)),
                        .computed = control.step,
                        .tolerance = relative(1e-8),
                        .because = "changes of 1e-7 and more of numbers near 1, some roundings each"});
          rows.equal("controlling field" + which, {.expected = "second",
                                                   .computed = std::string(control.controlling),
                                                   .because = "both contract alike, it is asked for more"});
        }
      }
    }};

}  // namespace verification::staggering
