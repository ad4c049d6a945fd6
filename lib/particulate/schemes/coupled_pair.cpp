#include <particulate/schemes/coupled_pair.hpp>

#include <cmath>

namespace particulate::schemes {

bool FirstOrderPair::rate(double, In y, Out dy) const {
  dy = -a * y;
  return true;
}

bool FirstOrderPair::solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const {
  const auto self = static_cast<Eigen::Index>(k);
  const Eigen::Index other = 1 - self;
  const double diagonal = 1.0 + dt * a(self, self);
  to.y[self] = (from.y[self] - dt * a(self, other) * seen.y[other]) / diagonal;
  return diagonal != 0.0;
}

bool SecondOrderPair::rate(double, In y, Out dy) const {
  dy << y[1], -c12 * y[2], y[3], -c21 * y[0];
  return true;
}

bool SecondOrderPair::solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const {
  const Eigen::Index self = 2 * static_cast<Eigen::Index>(k), other = 2 - self;
  const double pull = -(k == 0 ? c12 : c21) * seen.y[other];
  const double speed = from.y[self + 1] + dt * pull;
  to.y[self] = from.y[self] + dt * speed;
  to.y[self + 1] = speed;
  return true;
}

double SecondOrderPair::distance(std::size_t, In x, In y) const { return std::abs(x[0] - y[0]); }

}  // namespace particulate::schemes
