// Stiff problems of the literature by CVODE's backward differentiation formulas, to the published digits.

#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>

#include "classical_problems.hpp"

namespace {

using namespace particulate;
using namespace verification;

// A problem's digits, and what two tolerances a step may cost over its whole run.
struct Published {
  double t_end;                // [s]
  std::vector<double> digits;  // at t_end
  double relative, absolute;   // of a step
  double tolerance;            // of the digits
  std::string because;
};

template <class P>
void compare(Rows& rows, const std::string& how, P problem, const schemes::Values& start, const Published& known) {
  schemes::Values state = start;
  const reference::Bdf method{.relative = known.relative, .absolute = known.absolute};
  const schemes::Outcome out = reference::integrate(problem, state, known.t_end, method);
  rows.equal(how + ": ended", {.expected = "reached",
                               .computed = out.reason.empty() ? "reached" : out.reason,
                               .because = "there is an answer at the end only"});
  for (std::size_t k = 0; k < known.digits.size(); ++k) {
    rows.compare(fmt::format("{}: y{}", how, k + 1), {.expected = known.digits[k],
                                                      .computed = state.y[static_cast<Eigen::Index>(k)],
                                                      .tolerance = relative(known.tolerance),
                                                      .because = known.because});
  }
}

template <class P>
void compare_both(Rows& rows, const P& problem, const Published& known) {
  compare(rows, "given Jacobian", problem, P::start(), known);
  compare(rows, "difference quotients", WithoutJacobian<P>{problem}, P::start(), known);
}

Claim claim_of(const std::string& name, const std::string& problem) {
  return {.name = "classical_" + name,
          .claim = "CVODE's stiff method meets the published digits of " + problem,
          .equation = "R 3.2",
          .reference = Reference::published};
}

const Case robertson{claim_of("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
                       compare_both(rows, Robertson{},
                                    {.t_end = 1e11,
                                     .digits = {2.083340149701255e-8, 8.333360770334713e-14, 0.9999999791665050},
                                     .relative = 1e-10,
                                     .absolute = 1e-24,
                                     .tolerance = 1e-8,
                                     .because = "100 times the tolerance of a step: y1 and y2 fall as 1/t, which keeps "
                                                "relative errors, and y2 reaches 8e-14, far above the absolute 1e-24"});
                     }};
const Case van_der_pol{
    claim_of("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"), [](Rows& rows) {
      compare_both(
          rows, VanDerPol{},
          {.t_end = 2000.0,
           .digits = {1.706167732170469, -8.928097010248125e-4},
           .relative = 1e-11,
           .absolute = 1e-13,
           .tolerance = 1e-8,
           .because =
               "1000 times the tolerance of a step: their errors shift the leaps in time, and nothing damps a shift"});
    }};
const Case oregonator{
    claim_of("oregonator", "the Oregonator at t = 360"), [](Rows& rows) {
      compare_both(
          rows, Oregonator{},
          {.t_end = 360.0,
           .digits = {1.000814870318523, 1228.178521549917, 132.0554942846706},
           .relative = 1e-11,
           .absolute = 1e-13,
           .tolerance = 1e-8,
           .because =
               "1000 times the tolerance of a step: their errors shift the pulses in time, and nothing damps a shift"});
    }};

}  // namespace
