// The Pleiades, a near-field scene with published digits, by two reference methods of different families.

#include <string>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>

#include "classical_problems.hpp"

namespace verification::classical_pleiades {

using namespace particulate;

void compare(Rows& rows, const std::string& how, const reference::Method& method) {
  const auto scene = pleiades();
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = reference::integrate(scene, state, pleiades_end, method);
  rows.equal(how + ": ended", {.expected = "reached",
                               .computed = out.reason.empty() ? "reached" : out.reason,
                               .because = "there is an answer at the end only"});
  const std::string because = "1e-14 a step, which the close passages amplify some 1e4-fold";
  rows.compare(
      how + ": x1",
      {.expected = 0.3706139143970502, .computed = state.r[0], .tolerance = relative(2e-10), .because = because});
  rows.compare(
      how + ": y1",
      {.expected = -3.943437585517392, .computed = state.r[7], .tolerance = relative(2e-10), .because = because});
}

const Case pleiades_case{{.name = "classical_pleiades",
                          .claim = "seven stars under a near field without repulsion end where the literature says",
                          .equation = "M 2.3",
                          .reference = Reference::published},
                         [](Rows& rows) {
                           compare(rows, "CVODE Adams", reference::Adams{.relative = 1e-14, .absolute = 1e-15});
                           compare(
                               rows, "ARKODE Fehlberg 8(7)",
                               reference::ExplicitRungeKutta{
                                   .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-15});
                         }};

}  // namespace verification::classical_pleiades
