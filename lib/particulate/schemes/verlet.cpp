#include <particulate/schemes/verlet.hpp>

#include <cmath>
#include <utility>

namespace particulate::schemes {

bool VelocityVerlet::Kept::holds_at(const State& state) const {
  return state.t == at.t && state.r.size() == at.r.size() && state.r == at.r && state.y.size() == at.y.size() &&
         state.y == at.y;
}

bool VelocityVerlet::Kept::renew(const Problem& problem, const State& state, const Eigen::VectorXd& v) {
  at.t = std::numeric_limits<double>::quiet_NaN();
  if (!problem.rates(state.t, state.r, v, state.y, rates)) return false;
  at.t = state.t;
  at.r = state.r;
  at.y = state.y;
  return true;
}

bool VelocityVerlet::predict(const Problem& problem, const State& from, double dt, State& to) {
  if (end_.holds_at(from)) std::swap(start_, end_);
  if (!start_.holds_at(from) && !start_.renew(problem, from, from.v)) return false;
  const Eigen::VectorXd& a = start_.rates.a;
  advance_time(from, dt, to);
  to.r = from.r + dt * from.v + (0.5 * dt * dt) * a;
  to.y = from.y;
  if (!end_.renew(problem, to, from.v)) return false;
  to.v = from.v + (0.5 * dt) * (a + end_.rates.a);
  return true;
}

// The cubic through places and velocities of both ends, and through velocities and accelerations, which has no cubic
// term.
void VelocityVerlet::at(const State& from, double dt, double theta, State& there) const {
  const Eigen::VectorXd &a = start_.rates.a, &next = end_.rates.a;
  const double square = theta * theta;
  advance_time(from, theta * dt, there);
  there.r = from.r + (theta * dt) * from.v + (0.5 * dt * dt * square) * (a + (theta - 1.0) * (next - a));
  there.v = from.v + (0.5 * dt) * ((2.0 * theta - square) * a + square * next);
  there.y = from.y;
}

}  // namespace particulate::schemes
