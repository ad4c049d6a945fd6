#pragma once

#include <particulate/reference/integrator.hpp>

#include <harness/motions.hpp>

/// @file
/// The reference integrators with the tolerances that this chapter's cases use.

namespace verification {

/// Adams methods of orders up to 12, tight.
inline const particulate::reference::Adams adams{.relative = 1e-14, .absolute = 1e-15};

/// Fehlberg's method with 13 stages and orders 7 and 8, tight.
inline const particulate::reference::ExplicitRungeKutta fehlberg{
    .table = particulate::reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-15};

/// Dormand and Prince's method of orders 4 and 5, tight.
inline const particulate::reference::ExplicitRungeKutta dormand_prince{
    .table = particulate::reference::Table::dormand_prince_7_4_5, .relative = 1e-13, .absolute = 1e-14};

/// Moves a state to t_end by a reference method, in one leg.
template <class P>
void advance_by(const particulate::reference::Method& method, P& problem, particulate::schemes::State& state,
                double t_end) {
  require_reached(particulate::reference::integrate(problem, state, t_end, method));
}

}  // namespace verification
