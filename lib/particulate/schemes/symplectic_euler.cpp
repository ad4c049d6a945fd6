#include <particulate/schemes/symplectic_euler.hpp>

namespace particulate::schemes {

bool SymplecticEuler::predict(const Problem& problem, const State& from, double dt, State& to) {
  if (!problem.rates(from, rates_)) return false;
  at(from, dt, 1.0, to);
  return true;
}

void SymplecticEuler::at(const State& from, double dt, double theta, State& there) const {
  const double part = theta * dt;
  advance_time(from, part, there);
  there.v = from.v + part * rates_.a;
  there.r = from.r + part * there.v;
  there.y = from.y;
  if (rates_.dy.size() > 0) there.y += part * rates_.dy;
}

}  // namespace particulate::schemes
