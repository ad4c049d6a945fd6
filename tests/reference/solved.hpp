#pragma once

#include <boost/test/unit_test.hpp>
#include <particulate/reference/integrator.hpp>

namespace tests {

/// The state that a run ends in, which must reach its end.
template <class P>
particulate::schemes::State solved(P&& problem, particulate::schemes::State state, double t_end,
                                   const particulate::reference::Method& method) {
  const particulate::schemes::Outcome out = particulate::reference::integrate(problem, state, t_end, method);
  BOOST_TEST((out.status == particulate::schemes::Status::reached), out.reason);
  return state;
}

}  // namespace tests
