#include <particulate/schemes/verlet.hpp>

namespace particulate::schemes {

bool VelocityVerlet::continues(const State& from) const {
  return kept_ && from.t == kept_at_.t && from.r.size() == kept_at_.r.size() && from.r == kept_at_.r &&
         from.y.size() == kept_at_.y.size() && from.y == kept_at_.y;
}

bool VelocityVerlet::predict(const Problem& problem, const State& from, double dt, State& to) {
  if (!continues(from)) {
    kept_ = false;
    if (!problem.rates(from, start_)) return false;
  }
  advance_time(from, dt, to);
  to.r = from.r + dt * from.v + (0.5 * dt * dt) * start_.a;
  if (!problem.rates(to.t, to.r, from.v, from.y, end_)) return false;
  to.v = from.v + (0.5 * dt) * (start_.a + end_.a);
  to.y = from.y;
  end_at_.t = to.t;
  end_at_.r = to.r;
  end_at_.y = from.y;
  return true;
}

void VelocityVerlet::accept(double) {
  start_.a.swap(end_.a);
  swap(kept_at_, end_at_);
  kept_ = true;
}

}  // namespace particulate::schemes
