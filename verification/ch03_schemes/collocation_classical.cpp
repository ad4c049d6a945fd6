// Problems of the literature by the library's own methods, to ten published digits.

#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/integrate.hpp>

#include "classical_problems.hpp"

namespace verification::collocation_classical {

using namespace particulate;
using namespace particulate::schemes;

// A problem with its digits, and what a step may cost.
struct Published {
  AnyValues problem;
  Values start, end;
  Eigen::Vector3d sizes;  // below which errors of a step count as absolute; so many as there are digits
  double TOL;             // of a step
};

template <class P>
Published published(const P& problem, const Eigen::Vector3d& sizes, double TOL) {
  return {.problem = any_values(problem), .start = P::start(), .end = P::published(), .sizes = sizes, .TOL = TOL};
}

template <class Nodes, class P>
void compare(Rows& rows, const std::string& how, P of, const Published& known) {
  Counted<P> problem{of};
  const Eigen::Index n = known.start.y.size();
  Collocation<Nodes, Newton<>> scheme({.sizes = known.sizes.head(n)});
  ErrorControl control{.TOL = known.TOL,
                       .sweep_TOL = std::max(1e-3 * known.TOL, 1e-14),
                       .K_d = 3,
                       .step = 1e-6,
                       .limit = known.end.t,
                       .growth = 8.0,
                       .worth = 1.2};
  Values state = known.start;
  const Outcome out = integrate(problem, state, known.end.t, scheme, control);
  rows.equal(how + ": ended", {.expected = "reached",
                               .computed = out.reason.empty() ? "reached" : out.reason,
                               .because = "there is an answer at the end only"});
  if constexpr (HasJacobian<P>) {
    rows.at_least(
        how + ": Jacobians",
        {.limit = 10.0, .computed = static_cast<double>(problem.jacobians), .because = "it changes by decades"});
    rows.at_most(how + ": Jacobians, over steps",
                 {.limit = 0.9,
                  .computed = static_cast<double>(problem.jacobians) / static_cast<double>(out.steps),
                  .because = "kept where the sweeps contract fast"});
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    rows.compare(fmt::format("{}: y{}", how, k + 1), {.expected = known.end.y[k],
                                                      .computed = state.y[k],
                                                      .tolerance = relative(1e-10),
                                                      .because = "ten digits, the catalogue's goal"});
  }
}

// Radau 3 needs more and smaller steps: its estimate has order 3, so that the steps, not the errors, follow TOL.
void compare_all(Rows& rows, Published known, double TOL_of_three) {
  const WithoutJacobian<AnyValues> without{known.problem};
  compare<Radau<5>>(rows, "Radau 5, given Jacobian", known.problem, known);
  compare<Radau<5>>(rows, "Radau 5, difference quotients", without, known);
  known.TOL = TOL_of_three;
  compare<Radau<3>>(rows, "Radau 3, given Jacobian", known.problem, known);
  compare<Radau<3>>(rows, "Radau 3, difference quotients", without, known);
}

Claim claim_of(const std::string& name, const std::string& problem) {
  return {.name = "collocation_" + name,
          .claim = "Radau collocation with Newton meets ten published digits of " + problem,
          .equation = "D 3.4",
          .reference = Reference::published};
}

const Case robertson{claim_of("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
                       const Robertson problem;
                       compare_all(rows, published(problem, {1e-10, 1e-16, 1e-10}, 1e-7), 1e-9);
                     }};
const Case van_der_pol{claim_of("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"), [](Rows& rows) {
                         const VanDerPol problem;
                         compare_all(rows, published(problem, {1.0, 1e-3, 1.0}, 1e-7), 1e-9);
                       }};
const Case oregonator{claim_of("oregonator", "the Oregonator at t = 360"), [](Rows& rows) {
                        const Oregonator problem;
                        compare_all(rows, published(problem, {1.0, 1.0, 1.0}, 1e-7), 1e-9);
                      }};

const Case pleiades_case{
    {.name = "collocation_pleiades",
     .claim = "adaptive Gauss collocation meets ten published digits of seven stars under a near field",
     .equation = "D 3.4",
     .reference = Reference::published},
    [](Rows& rows) {
      auto scene = pleiades();
      Motion state = scenes::start(scene);
      Collocation<Gauss<8>> scheme;
      ErrorControl control{.TOL = 1e-11, .sweep_TOL = 1e-14, .step = 1e-3, .limit = 0.3};
      const Outcome out = integrate(scene, state, pleiades_end, scheme, control);
      rows.equal("ended", {.expected = "reached",
                           .computed = out.reason.empty() ? "reached" : out.reason,
                           .because = "there is an answer at the end only"});
      const char* const because = "ten digits, the catalogue's goal";
      rows.compare(
          "x1",
          {.expected = 0.3706139143970502, .computed = state.r[0], .tolerance = relative(1e-10), .because = because});
      rows.compare(
          "y1",
          {.expected = -3.943437585517392, .computed = state.r[7], .tolerance = relative(1e-10), .because = because});
    }};

}  // namespace verification::collocation_classical
