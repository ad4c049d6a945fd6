#include <particulate/schemes/runge_kutta.hpp>

namespace particulate::schemes {

bool RungeKutta4::predict(const Problem& problem, const State& from, double dt, State& to) {
  const double half = 0.5 * dt;
  const double middle = from.t + (half + from.t_carry);
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
  advance_time(from, dt, to);
  if (!problem.rates(to.t, at.r, at.v, y, k4_)) return false;

  to.r = from.r + dt * from.v + (dt * dt / 6.0) * (k1_.a + k2_.a + k3_.a);
  to.v = from.v + (dt / 6.0) * (k1_.a + 2.0 * (k2_.a + k3_.a) + k4_.a);
  if (values) {
    to.y = from.y + (dt / 6.0) * (k1_.dy + 2.0 * (k2_.dy + k3_.dy) + k4_.dy);
  } else {
    to.y = from.y;
  }
  return true;
}

// Weights of the stages for values and velocities; the places take them through the velocities of the stages.
void RungeKutta4::at(const State& from, double dt, double theta, State& there) const {
  const double square = theta * theta, cube = 2.0 / 3.0 * theta * square;
  const double first = theta - 1.5 * square + cube, middle = square - cube, last = cube - 0.5 * square;
  advance_time(from, theta * dt, there);
  there.r = from.r + (theta * dt) * from.v + (dt * dt) * (0.5 * middle * (k1_.a + k2_.a) + last * k3_.a);
  there.v = from.v + dt * (first * k1_.a + middle * (k2_.a + k3_.a) + last * k4_.a);
  there.y = from.y;
  if (k1_.dy.size() > 0) there.y += dt * (first * k1_.dy + middle * (k2_.dy + k3_.dy) + last * k4_.dy);
}

}  // namespace particulate::schemes
