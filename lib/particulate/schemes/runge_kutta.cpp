#include <particulate/schemes/runge_kutta.hpp>

#include <limits>

namespace particulate::schemes {

bool RungeKutta4::predict(const Problem& problem, const State& from, double dt, State& to) {
  const double half = 0.5 * dt;
  const double middle = from.t + (half + from.t_carry);
  const bool values = problem.traits().values;
  State& at = stage_;
  const Eigen::VectorXd& y = values ? at.y : from.y;

  if (!kept_.begin_step(from) && !problem.rates(from, kept_.start.rates)) return false;
  const Rates& first = kept_.start.rates;
  at.r = from.r + half * from.v;
  at.v = from.v + half * first.a;
  if (values) at.y = from.y + half * first.dy;
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

  to.r = from.r + dt * from.v + (dt * dt / 6.0) * (first.a + k2_.a + k3_.a);
  to.v = from.v + (dt / 6.0) * (first.a + 2.0 * (k2_.a + k3_.a) + k4_.a);
  if (values) {
    to.y = from.y + (dt / 6.0) * (first.dy + 2.0 * (k2_.dy + k3_.dy) + k4_.dy);
  } else {
    to.y = from.y;
  }
  return true;
}

// Weights of the stages for values and velocities; the places take them through the velocities of the stages.
void RungeKutta4::at(const State& from, double dt, double theta, State& there) const {
  const double square = theta * theta, cube = 2.0 / 3.0 * theta * square;
  const double first = theta - 1.5 * square + cube, middle = square - cube, last = cube - 0.5 * square;
  const Rates& start = kept_.start.rates;
  advance_time(from, theta * dt, there);
  there.r = from.r + (theta * dt) * from.v + (dt * dt) * (0.5 * middle * (start.a + k2_.a) + last * k3_.a);
  there.v = from.v + dt * (first * start.a + middle * (k2_.a + k3_.a) + last * k4_.a);
  there.y = from.y;
  if (start.dy.size() > 0) there.y += dt * (first * start.dy + middle * (k2_.dy + k3_.dy) + last * k4_.dy);
}

// Where rates depend on time alone, the embedded method is the method: what a rate does from step to step must tell.
Truncation RungeKutta4::truncation(const Problem& problem, const State& from, double dt, const State& to) {
  const Truncation unknown{.error = std::numeric_limits<double>::infinity(), .order = 3};
  if (!kept_.start.hold_at(from)) kept_.start.at = from;
  kept_.end.forget();
  if (!problem.rates(to, kept_.end.rates) || !kept_.find_third(*this, problem, from, dt)) return unknown;
  kept_.end.at = to;
  const Rates &start = kept_.start.rates, &end = kept_.end.rates, &third = kept_.third();
  scales_.look(problem, from, dt, to);
  error_.r = (dt / 6.0) * (from.v + dt * k3_.a - to.v);
  error_.v = (dt / 6.0) * (k4_.a - end.a);
  error_.y = (dt / 6.0) * (k4_.dy - end.dy);
  const double embedded = scales_.relative(error_);
  const auto differ = [&](const Eigen::VectorXd& f0, const Eigen::VectorXd& k2, const Eigen::VectorXd& k3,
                          const Eigen::VectorXd& f1, const Eigen::VectorXd& other, Eigen::VectorXd& error) {
    second_difference(f0, f1, other, kept_.place(), error);
    error = (dt / 32.0 / (kept_.place() - 0.5)) * (error - 4.0 * (f0 - k2 - k3 + f1));
  };
  error_.r.setZero();
  differ(start.a, k2_.a, k3_.a, end.a, third.a, error_.v);
  differ(start.dy, k2_.dy, k3_.dy, end.dy, third.dy, error_.y);
  const double by_differences = scales_.relative(error_);
  return estimated(by_differences >= embedded ? by_differences : embedded, 3);
}

}  // namespace particulate::schemes
