#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <particulate/fluid/flow.hpp>

namespace particulate::fluid {

/// A state of a flow that stands still, as a field for the laws of a scene: see StreamField.
///
/// It is read by Hats, and has no value outside of a box that does not begin again: a step that leads there is refused.
/// Asked, it writes into scratch of its own; a copy of a scene has its own.
/// @tparam F  a Flow
template <class F>
class FrozenFlow {
 public:
  /// @param flow   the fluid
  /// @param state  that stands still
  /// @param w      half-width of the hats; none: the largest edge of a cell [m]
  /// @throws std::invalid_argument if the state is not of this flow, or has no value
  FrozenFlow(F flow, const schemes::State& state, std::optional<double> w = {})
      : flow_(std::move(flow)),
        hats_(flow_.grid(), flow_.boundaries(), Eigen::VectorXd::Constant(1, w ? *w : largest_edge(flow_.grid()))) {
    if (!flow_.measure(state.t, state.y)) {
      throw std::invalid_argument("frozen flow: the state must have a value everywhere: " + flow_.why_no_value(state));
    }
  }

  /// @param x  a place [m]
  /// @return the fluid there; outside no numbers
  Stream operator()(double, const Eigen::Vector3d& x) const {
    if (!hats_.place(x)) return {.rho = std::numeric_limits<double>::quiet_NaN()};
    flow_.gather(hats_, there_);
    return there_.front();
  }

 private:
  static double largest_edge(const Grid<F::directions>& grid) {
    double h = 0.0;
    for (int a = 0; a < F::directions; ++a) h = std::max(h, grid.h(a));
    return h;
  }

  F flow_;
  mutable Hats<F::directions> hats_;
  mutable std::vector<Stream> there_ = std::vector<Stream>(1);
};

}  // namespace particulate::fluid
