#include <particulate/schemes/phi_family.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes {

template <class Mixing>
PhiFamily<Mixing>::PhiFamily(double phi, Mixing mixing) : phi_(phi), mixing_(std::move(mixing)) {
  if (!(phi >= 0.0 && phi <= 1.0)) {
    throw std::invalid_argument(fmt::format("phi family: phi must be in [0, 1], got {}", phi));
  }
}

// One sweep of y' = lambda y is forward Euler; one of r'' = -omega^2 r has trace 2 - 2 phi z^2 and determinant
// 1 + (1 - 2 phi) z^2. More of them are bounded by their contraction, and below phi = 1/2 by the scheme itself. There
// an odd number of them falls short of the fixed point on the side of forward Euler: by how much it may span more than
// that is left aside. Of y' = i y two sweeps make 1 + i z - phi z^2.
template <class Mixing>
double PhiFamily<Mixing>::spans(TimeScale::Kind kind, int sweeps) const {
  const bool oscillates = kind == TimeScale::Kind::oscillates;
  const double contraction = phi_ > 0.0 ? 1.0 / phi_ : std::numeric_limits<double>::infinity();
  if (kind == TimeScale::Kind::loads) return std::numeric_limits<double>::infinity();
  if (kind == TimeScale::Kind::drifts) return sweeps == 1 ? 1.0 : std::numeric_limits<double>::infinity();
  if ((oscillates || kind == TimeScale::Kind::waves) && phi_ < 0.5) return 0.0;
  if (kind == TimeScale::Kind::waves && sweeps == 1) return 0.0;
  if (kind == TimeScale::Kind::waves && sweeps == 2) return std::sqrt(2.0 * phi_ - 1.0) / phi_;
  if (sweeps == 1 || (phi_ < 0.5 && sweeps % 2 == 1)) return oscillates ? 2.0 / std::sqrt(4.0 * phi_ - 1.0) : 2.0;
  return phi_ < 0.5 ? std::min(contraction, 2.0 / (1.0 - 2.0 * phi_)) : contraction;
}

// Every iterate is the start moved on with mean rates over the step, phi of the end's and 1 - phi of the start's. The
// iteration is one for these means; it begins with 0.
template <class Mixing>
bool PhiFamily<Mixing>::predict(const Problem& problem, const State& from, double dt, State& to) {
  values_ = problem.traits().values;
  kept_.begin_step(from);
  if (phi_ < 1.0 && !problem.rates(from, kept_.start.rates)) return false;
  measures_.begin(problem, from, problem.traits().velocities ? 1 : 2);
  mixing_.forget();
  mean_.a.setZero(from.r.size());
  mean_.dy.setZero(values_ ? from.y.size() : 0);
  advance_time(from, dt, to);
  to.r = from.r + dt * from.v;
  to.v = from.v;
  to.y = from.y;
  return true;
}

template <class Mixing>
Iteration PhiFamily<Mixing>::sweep(const Problem& problem, const State& from, double dt, State& to) {
  if (!problem.rates(to, rates_)) return measures_.no_value();
  if (phi_ < 1.0) {
    rates_.a = phi_ * rates_.a + (1.0 - phi_) * kept_.start.rates.a;
    if (values_) rates_.dy = phi_ * rates_.dy + (1.0 - phi_) * kept_.start.rates.dy;
  }
  if (problem.traits().motion) measure_motion(problem, from, dt, to);
  if (values_) {
    next_ = from.y + dt * rates_.dy;
    measures_.record_values(problem, from.y, to.y, next_);
  }
  mix();
  to.r = from.r + dt * from.v + (phi_ * dt * dt) * mean_.a;
  to.v = from.v + dt * mean_.a;
  if (values_) to.y = from.y + dt * mean_.dy;
  return measures_.worst();
}

// The cubic through places and velocities of both ends; the parabola through what else is known.
template <class Mixing>
void PhiFamily<Mixing>::at(const State& from, double dt, double theta, State& there) const {
  const double square = theta * theta;
  const Rates& start = phi_ < 1.0 ? kept_.start.rates : mean_;
  advance_time(from, theta * dt, there);
  there.r =
      from.r + (theta * dt) * from.v + (dt * dt * square * (3.0 * phi_ - 1.0 + (1.0 - 2.0 * phi_) * theta)) * mean_.a;
  there.v = from.v + dt * ((theta - square) * start.a + square * mean_.a);
  there.y = from.y;
  if (values_) there.y += dt * ((theta - square) * start.dy + square * mean_.dy);
}

// Of what rates do in the step, D1, and what they do otherwise than in the step before, D2.
template <class Mixing>
Truncation PhiFamily<Mixing>::truncation(const Problem& problem, const State& from, double dt, const State& to) {
  const int p = phi_ == 0.5 ? 2 : 1;
  if (!find_rates(problem, from, dt, to)) return over_a_change(std::numeric_limits<double>::infinity(), p);
  const Rates &start = kept_.start.rates, &end = kept_.end.rates;
  const auto of_rates = [&](const Eigen::VectorXd& f, const Eigen::VectorXd& next, const Eigen::VectorXd& third,
                            Eigen::VectorXd& error) {
    error.setZero(f.size());
    if (phi_ < 1.0) second_difference(f, next, third, kept_.place(), error);
    error = ((0.5 - phi_) * dt) * (next - f) - (dt / 12.0) * error;
  };
  of_rates(start.a, end.a, kept_.third().a, error_.v);
  of_rates(start.dy, end.dy, kept_.third().dy, error_.y);
  error_.r = (dt * dt) * ((0.5 - phi_) * start.a + (1.0 / 6.0 - phi_ * phi_) * (end.a - start.a));
  scales_.look(problem, from, dt, to);
  return over_a_change(scales_.relative(error_), p);
}

// The rates at the end are what the mean makes them, without a further right-hand side.
template <class Mixing>
bool PhiFamily<Mixing>::find_rates(const Problem& problem, const State& from, double dt, const State& to) {
  Rates &start = kept_.start.rates, &end = kept_.end.rates;
  if (!kept_.start.hold_at(from)) {
    if (phi_ == 1.0 && !problem.rates(from, start)) return false;
    kept_.start.at = from;
  }
  if (phi_ > 0.0) {
    end.a = (mean_.a - (1.0 - phi_) * start.a) / phi_;
    end.dy = (mean_.dy - (1.0 - phi_) * start.dy) / phi_;
  } else if (!problem.rates(to, end)) {
    return false;
  }
  kept_.end.at = to;
  return phi_ == 1.0 || kept_.find_third(*this, problem, from, dt);
}

template <class Mixing>
void PhiFamily<Mixing>::measure_motion(const Problem& problem, const State& from, double dt, const State& to) {
  IterationMeasure& measure = measures_.motion();
  const bool by_speed = problem.traits().velocities;
  const double scale = by_speed ? phi_ * dt : 1.0;
  next_ = from.r + dt * from.v + (phi_ * dt * dt) * rates_.a;
  if (measure.waits_for_first()) measures_.normalize_motion(problem, from, dt, next_, scale);
  if (by_speed) next_ = from.v + dt * rates_.a;
  measure.record(scale * problem.distance(next_, by_speed ? to.v : to.r));
}

template <class Mixing>
void PhiFamily<Mixing>::mix() {
  const Eigen::Index n = mean_.a.size(), m = mean_.dy.size();
  if constexpr (std::is_same_v<Mixing, Picard>) {
    mixing_.next(mean_.a, rates_.a);
    if (m > 0) mixing_.next(mean_.dy, rates_.dy);
  } else {
    Eigen::VectorXd x(n + m), gx(n + m);
    x.head(n) = mean_.a, gx.head(n) = rates_.a;
    if (m > 0) x.tail(m) = mean_.dy, gx.tail(m) = rates_.dy;
    mixing_.next(x, gx);
    mean_.a = x.head(n), mean_.dy = x.tail(m);
  }
}

template class PhiFamily<Picard>;
template class PhiFamily<Anderson>;

}  // namespace particulate::schemes
