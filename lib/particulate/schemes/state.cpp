#include <particulate/schemes/state.hpp>

#include <cmath>

namespace particulate::schemes {

Eigen::VectorXd flat(const State& state) {
  Eigen::VectorXd x(state.r.size() + state.v.size() + state.y.size());
  const Eigen::Index n = state.r.size();
  x.head(n) = state.r;
  x.segment(n, state.v.size()) = state.v;
  x.tail(state.y.size()) = state.y;
  return x;
}

void unflatten(In x, State& state) {
  const Eigen::Index n = state.r.size();
  state.r = x.head(n);
  state.v = x.segment(n, n);
  state.y = x.tail(state.y.size());
}

// Zero times what is not finite is not zero.
bool is_finite(const State& state) {
  const double sum = (0.0 * state.r).sum() + (0.0 * state.v).sum() + (0.0 * state.y).sum();
  return std::isfinite(state.t) && sum == 0.0;
}

}  // namespace particulate::schemes
