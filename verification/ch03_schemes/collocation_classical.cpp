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

// Its digits, and what a step may cost.
struct Published {
  State start, end;
  Eigen::Vector3d sizes;  // below which errors of a step count as absolute; so many as there are digits
  double TOL;             // of a step
};

// Counts its Jacobians.
template <class P>
struct Counting : P {
  long jacobians = 0;

  void jacobian(double t, In y, Eigen::MatrixXd& J) {
    ++jacobians;
    P::jacobian(t, y, J);
  }
};

template <class Nodes>
void compare(Rows& rows, const std::string& how, const Problem& problem, const Published& known,
             const long* jacobians = nullptr) {
  const long before = jacobians ? *jacobians : 0;
  const Eigen::Index n = known.start.y.size();
  Collocation<Nodes, Newton<>> scheme({.sizes = known.sizes.head(n)});
  ErrorControl control{.TOL = known.TOL,
                       .sweep_TOL = std::max(1e-3 * known.TOL, 1e-14),
                       .K_d = 3,
                       .step = 1e-6,
                       .limit = known.end.t,
                       .growth = 8.0,
                       .worth = 1.2};
  State state = known.start;
  const Outcome out = integrate(problem, state, known.end.t, scheme, control);
  rows.equal(how + ": ended", {.expected = "reached",
                               .computed = out.reason.empty() ? "reached" : out.reason,
                               .because = "there is an answer at the end only"});
  if (jacobians) {
    const auto asked = static_cast<double>(*jacobians - before);
    rows.at_least(how + ": Jacobians", {.limit = 10.0, .computed = asked, .because = "it changes by decades"});
    rows.at_most(how + ": Jacobians, over steps", {.limit = 0.9,
                                                   .computed = asked / static_cast<double>(out.steps),
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
template <class P>
void compare_all(Rows& rows, const Eigen::Vector3d& sizes) {
  Counting<P> given;
  const WithoutJacobian<P> without;
  Published known{.start = P::start(), .end = P::published(), .sizes = sizes, .TOL = 1e-7};
  compare<Radau<5>>(rows, "Radau 5, given Jacobian", given, known, &given.jacobians);
  compare<Radau<5>>(rows, "Radau 5, difference quotients", without, known);
  known.TOL = 1e-9;
  compare<Radau<3>>(rows, "Radau 3, given Jacobian", given, known, &given.jacobians);
  compare<Radau<3>>(rows, "Radau 3, difference quotients", without, known);
}

Claim claim_of(const std::string& name, const std::string& problem) {
  return {.name = "collocation_" + name,
          .claim = "Radau collocation with Newton meets ten published digits of " + problem,
          .equation = "D 3.4",
          .reference = Reference::published};
}

const Case robertson{claim_of("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
                       compare_all<Robertson>(rows, {1e-10, 1e-16, 1e-10});
                     }};
const Case van_der_pol{claim_of("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"), [](Rows& rows) {
                         compare_all<VanDerPol>(rows, {1.0, 1e-3, 1.0});
                       }};
const Case oregonator{claim_of("oregonator", "the Oregonator at t = 360"), [](Rows& rows) {
                        compare_all<Oregonator>(rows, {1.0, 1.0, 1.0});
                      }};

const Case pleiades_case{
    {.name = "collocation_pleiades",
     .claim = "adaptive Gauss collocation meets ten published digits of seven stars under a near field",
     .equation = "D 3.4",
     .reference = Reference::published},
    [](Rows& rows) {
      auto scene = pleiades();
      State state = scenes::start(scene);
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
