// Stiff problems of the literature by CVODE's backward differentiation formulas, to the published digits.

#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>

#include "classical_problems.hpp"

namespace verification::classical_stiff {

using namespace particulate;

// Two tolerances of a step, and what they may cost over the whole run.
struct Tolerances {
  double relative, absolute;  // of a step
  double tolerance;           // of the digits
  std::string because;
};

void compare(Rows& rows, const std::string& how, const schemes::Problem& problem, schemes::State state,
             const schemes::State& known, const Tolerances& allowed) {
  const reference::Bdf method{.relative = allowed.relative, .absolute = allowed.absolute};
  const schemes::Outcome out = reference::integrate(problem, state, known.t, method);
  rows.equal(how + ": ended", {.expected = "reached",
                               .computed = out.reason.empty() ? "reached" : out.reason,
                               .because = "there is an answer at the end only"});
  for (Eigen::Index k = 0; k < known.y.size(); ++k) {
    rows.compare(fmt::format("{}: y{}", how, k + 1), {.expected = known.y[k],
                                                      .computed = state.y[k],
                                                      .tolerance = relative(allowed.tolerance),
                                                      .because = allowed.because});
  }
}

template <class P>
void compare_both(Rows& rows, const P& problem, const Tolerances& allowed) {
  compare(rows, "given Jacobian", problem, P::start(), P::published(), allowed);
  const WithoutJacobian<P> without{problem};
  compare(rows, "difference quotients", without, P::start(), P::published(), allowed);
}

Claim claim_of(const std::string& name, const std::string& problem) {
  return {.name = "classical_" + name,
          .claim = "CVODE's stiff method meets the published digits of " + problem,
          .equation = "R 3.2",
          .reference = Reference::published};
}

const Case robertson{claim_of("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
                       compare_both(rows, Robertson{},
                                    {.relative = 1e-10,
                                     .absolute = 1e-24,
                                     .tolerance = 1e-8,
                                     .because = "100 times the tolerance of a step: y1 and y2 fall as 1/t, which keeps "
                                                "relative errors, and y2 reaches 8e-14, far above the absolute 1e-24"});
                     }};
const Case van_der_pol{
    claim_of("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"), [](Rows& rows) {
      compare_both(
          rows, VanDerPol{},
          {.relative = 1e-11,
           .absolute = 1e-13,
           .tolerance = 1e-8,
           .because =
               "1000 times the tolerance of a step: their errors shift the leaps in time, and nothing damps a shift"});
    }};
const Case oregonator{
    claim_of("oregonator", "the Oregonator at t = 360"), [](Rows& rows) {
      compare_both(
          rows, Oregonator{},
          {.relative = 1e-11,
           .absolute = 1e-13,
           .tolerance = 1e-8,
           .because =
               "1000 times the tolerance of a step: their errors shift the pulses in time, and nothing damps a shift"});
    }};

}  // namespace verification::classical_stiff
