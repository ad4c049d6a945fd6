// Which of several fields sets the step, and to what.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "linear_problems.hpp"

namespace verification::staggering_control {

using namespace particulate::schemes;

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
    worst = std::max(worst, hand[k].w_K / setting.TOL[k]);
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

}  // namespace verification::staggering_control
