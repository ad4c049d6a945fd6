#include <particulate/schemes/verlet.hpp>

#include <limits>

namespace particulate::schemes {

bool VelocityVerlet::keep(const Problem& problem, const State& state, const Eigen::VectorXd& v, KeptRates& kept) {
  kept.forget();
  if (!problem.rates(state.t, state.r, v, state.y, kept.rates)) return false;
  kept.at.t = state.t;
  kept.at.r = state.r;
  kept.at.y = state.y;
  return true;
}

bool VelocityVerlet::predict(const Problem& problem, const State& from, double dt, State& to) {
  if (!kept_.begin_step(from) && !keep(problem, from, from.v, kept_.start)) return false;
  const Eigen::VectorXd& a = kept_.start.rates.a;
  advance_time(from, dt, to);
  to.r = from.r + dt * from.v + (0.5 * dt * dt) * a;
  to.y = from.y;
  if (!keep(problem, to, from.v, kept_.end)) return false;
  to.v = from.v + (0.5 * dt) * (a + kept_.end.rates.a);
  return true;
}

Truncation VelocityVerlet::truncation(const Problem& problem, const State& from, double dt, const State& to) {
  if (!kept_.find_third(*this, problem, from, dt)) return over_a_change(std::numeric_limits<double>::infinity(), order);
  const Eigen::VectorXd &a = kept_.start.rates.a, &next = kept_.end.rates.a;
  second_difference(a, next, kept_.third().a, kept_.place(), error_.v);
  error_.v *= dt / 12.0;
  error_.r = (dt * dt / 6.0) * (next - a);
  scales_.look(problem, from, dt, to);
  return over_a_change(scales_.relative(error_), order);
}

// The cubic through places and velocities of both ends, and through velocities and accelerations, which has no cubic
// term.
void VelocityVerlet::at(const State& from, double dt, double theta, State& there) const {
  const Eigen::VectorXd &a = kept_.start.rates.a, &next = kept_.end.rates.a;
  const double square = theta * theta;
  advance_time(from, theta * dt, there);
  there.r = from.r + (theta * dt) * from.v + (0.5 * dt * dt * square) * (a + (theta - 1.0) * (next - a));
  there.v = from.v + (0.5 * dt) * ((2.0 * theta - square) * a + square * next);
  there.y = from.y;
}

}  // namespace particulate::schemes
