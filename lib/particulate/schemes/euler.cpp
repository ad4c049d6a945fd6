#include <particulate/schemes/euler.hpp>

namespace particulate::schemes {

bool ForwardEuler::predict(const Problem& problem, const State& from, double dt, State& to) {
  if (!problem.rates(from, rates_)) return false;
  advance_time(from, dt, to);
  to.r = from.r + dt * from.v;
  to.v = from.v + dt * rates_.a;
  to.y = from.y;
  if (problem.traits().values) to.y += dt * rates_.dy;
  return true;
}

void ForwardEuler::at(const State& from, double dt, double theta, State& there) const {
  advance_time(from, theta * dt, there);
  there.r = from.r + (theta * dt) * from.v;
  there.v = from.v + (theta * dt) * rates_.a;
  there.y = from.y;
  if (rates_.dy.size() > 0) there.y += (theta * dt) * rates_.dy;
}

}  // namespace particulate::schemes
