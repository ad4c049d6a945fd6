#include <particulate/schemes/runge_kutta.hpp>

namespace particulate::schemes {

bool RungeKutta4::predict(const Problem& problem, const State& from, double dt, State& to) {
  const double half = 0.5 * dt;
  const double middle = from.t + half;
  const bool values = problem.traits().values;
  State& at = stage_;
  const Eigen::VectorXd& y = values ? at.y : from.y;

  if (!problem.rates(from, k1_)) return false;
  at.r = from.r + half * from.v;
  at.v = from.v + half * k1_.a;
  if (values) at.y = from.y + half * k1_.dy;
  if (!problem.rates(middle, at.r, at.v, y, k2_)) return false;
  at.r = from.r + half * at.v;
  at.v = from.v + half * k2_.a;
  if (values) at.y = from.y + half * k2_.dy;
  if (!problem.rates(middle, at.r, at.v, y, k3_)) return false;
  at.r = from.r + dt * at.v;
  at.v = from.v + dt * k3_.a;
  if (values) at.y = from.y + dt * k3_.dy;
  if (!problem.rates(from.t + dt, at.r, at.v, y, k4_)) return false;

  advance_time(from, dt, to);
  to.r = from.r + dt * from.v + (dt * dt / 6.0) * (k1_.a + k2_.a + k3_.a);
  to.v = from.v + (dt / 6.0) * (k1_.a + 2.0 * (k2_.a + k3_.a) + k4_.a);
  if (values) {
    to.y = from.y + (dt / 6.0) * (k1_.dy + 2.0 * (k2_.dy + k3_.dy) + k4_.dy);
  } else {
    to.y = from.y;
  }
  return true;
}

}  // namespace particulate::schemes
