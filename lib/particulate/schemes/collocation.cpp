#include <particulate/schemes/collocation.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

// Newton's sweeps that contract less keep their Jacobian no longer.
constexpr double slow = 1e-2;

// sum += scale sum_j w_j k_j, over some rows of k. Four columns at a time, so that the sum is loaded and stored a
// quarter as often.
template <class Rows>
void add_weighted(const double* w, double scale, const Rows& k, Eigen::VectorXd& sum) {
  const Eigen::Index s = k.cols();
  Eigen::Index j = 0;
  for (; j + 4 <= s; j += 4) {
    sum += (scale * w[j]) * k.col(j) + (scale * w[j + 1]) * k.col(j + 1) + (scale * w[j + 2]) * k.col(j + 2) +
           (scale * w[j + 3]) * k.col(j + 3);
  }
  for (; j < s; ++j) sum += (scale * w[j]) * k.col(j);
}

// sum = start + change, and what rounding added to it.
void add_compensated(const Eigen::VectorXd& start, const Eigen::VectorXd& change, Eigen::VectorXd& sum,
                     Eigen::VectorXd& carry) {
  sum = start + change;
  carry = (sum - start) - change;
}

Sizes sizes_of(const CollocationSettings& settings) {
  return {.size = settings.size, .speed = settings.speed, .each = settings.sizes};
}

}  // namespace

void validate(const CollocationSettings& settings) { validate("collocation", sizes_of(settings)); }

void collocation_at(const CollocationTable& table, const Eigen::MatrixXd& rates, const State& from, double dt,
                    double theta, State& there) {
  const Eigen::Index n = from.r.size(), m = rates.rows() - n;
  const StageWeights once = table.once(theta);
  advance_time(from, theta * dt, there);
  there.r = from.r + (theta * dt) * from.v;
  there.v = from.v;
  there.y = from.y;
  if (n > 0) {
    add_weighted(table.twice(theta).data(), dt * dt, rates.topRows(n), there.r);
    add_weighted(once.data(), dt, rates.topRows(n), there.v);
  }
  if (m > 0) add_weighted(once.data(), dt, rates.bottomRows(m), there.y);
}

double unresolved(const CollocationTable& table, int order, double dt, double change, double rate) {
  const double power = static_cast<double>(order) / static_cast<double>(std::max<Eigen::Index>(table.stages() - 1, 1));
  return rate == 0.0 ? 0.0 : dt * rate * std::pow(change / rate, power);
}

AnyCollocation::AnyCollocation(const CollocationTable& table, int order, CollocationSettings settings,
                               StageSolver solver)
    : table_(&table),
      A_(table.A),
      order_(order),
      settings_(std::move(settings)),
      solver_(std::move(solver)),
      scales_(sizes_of(settings_)) {
  validate(settings_);
}

bool AnyCollocation::predict(const Problem& problem, const State& from, double dt, State& to) {
  begin_step(problem, from);
  if (!guess(problem, from, dt)) return false;
  advance_time(from, dt, to);
  to.y = from.y;
  finish(from, dt, to);
  if (is_newton() && !prepare_newton(problem, from, dt, to)) return false;
  if (!is_newton() && S() > 1) weigh_otherwise(dt);
  return true;
}

// The guess of the step shows how large its numbers are, where they start from zero; of those that stay at zero in it,
// the rates at its end do. Changes are measured by the start, where that is not zero: a guess that shoots beyond the
// step would loosen what they must meet.
bool AnyCollocation::prepare_newton(const Problem& problem, const State& from, double dt, const State& to) {
  Eigen::VectorXd sizes;
  const auto known_from = [&](const State& end) {
    scales_.look(problem, from, dt, end);
    sizes = scales_.unknowns();
    return sizes.size() == 0 || sizes.minCoeff() > ErrorScales::smallest;
  };
  stage_ = to;
  if (!known_from(to)) {
    if (!rates_here(problem, to.t)) return false;
    stage_.r = to.r + (dt * dt) * f_.head(n_);
    if (m_ > 0) stage_.y = to.y + dt * f_.tail(m_);
    (void)known_from(stage_);
  }
  range_TOL_.resize(m_);
  if (m_ > 0) {
    for (const Range& range : problem.ranges(m_)) range_TOL_.segment(range.first, range.size).setConstant(range.TOL);
  }
  const bool bad = retried_ || rate_ > slow;
  if (!solver_.newton.prepare(problem, from, dt, {.A = A_, .sizes = sizes, .speed = scales_.speed(), .bad = bad})) {
    return false;
  }
  if (!known_from(from)) (void)known_from(stage_);
  stage_.y = from.y;
  return true;
}

Iteration AnyCollocation::sweep(const Problem& problem, const State& from, double dt, State& to) {
  if (!renew_rates(problem, from, dt)) return measures_.no_value();
  if (is_newton()) {
    finish(from, dt, to);
    measures_.motion().normalize(1.0, 0.0);
    return measures_.motion().record(stage_change(image_, dt));
  }
  before_ = needs_speed_ ? to.v : to.r;
  before_y_ = to.y;
  finish(from, dt, to);
  if (S() > 1) {
    other_before_r_.swap(other_r_);
    other_before_y_.swap(other_y_);
    weigh_otherwise(dt);
  }
  measure(problem, from, dt, to);
  return measures_.worst();
}

void AnyCollocation::measure(const Problem& problem, const State& from, double dt, const State& to) {
  if (problem.traits().motion) measure_motion(problem, from, dt, to);
  if (m_ == 0) return;
  if (S() > 1) {
    measures_.record_values(problem, from.y, before_y_, to.y, other_before_y_, other_y_);
  } else {
    measures_.record_values(problem, from.y, before_y_, to.y);
  }
}

// Where forces depend on velocities the sweeps are measured by these, as in PhiFamily.
void AnyCollocation::measure_motion(const Problem& problem, const State& from, double dt, const State& to) {
  IterationMeasure& measure = measures_.motion();
  const double scale = needs_speed_ ? dt : 1.0;
  if (measure.waits_for_first()) { measures_.normalize_motion(problem, from, dt, to.r, scale); }
  double change = scale * problem.distance(needs_speed_ ? to.v : to.r, before_);
  if (S() > 1) change = std::max(change, problem.distance(other_r_, other_before_r_));
  measure.record(change);
}

Truncation AnyCollocation::truncation(const Problem& problem, const State& from, double dt, const State& to) {
  scales_.look(problem, from, dt, to);
  if (S() == 1 && settings_.guess == Guess::free_flight) {
    if (!has_old_ && !rates_at_start(problem, from)) return {};
    guessed_ = has_old_ ? Eigen::VectorXd(old_.col(0)) : start_;
  }
  if (order_ % 2 == 0 || m_ == 0) return leading_coefficient(dt);
  const Truncation of_values = defect_at_start(problem, from, dt);
  if (n_ == 0) return of_values;
  const Truncation of_motion = leading_coefficient(dt);
  return of_values.error >= of_motion.error ? of_values : of_motion;
}

void AnyCollocation::accept(double dt) {
  accepted_ = true;
  old_dt_ = dt;
  swap(end_, new_end_);
  if (settings_.compensated) std::swap(carry_, new_carry_);
  refused_at_ = std::numeric_limits<double>::quiet_NaN();
}

void AnyCollocation::begin(const Problem& problem, const State& state) {
  if (problem.identity() != of_ || !continues(state) || !answers_as_before(problem)) forget();
  of_ = problem.identity();
}

// Where it was asked last.
bool AnyCollocation::answers_as_before(const Problem& problem) {
  const Rates before = rates_;
  return rates_here(problem, stage_.t) && rates_.a == before.a && rates_.dy == before.dy;
}

void AnyCollocation::forget() {
  accepted_ = has_old_ = false;
  refused_at_ = std::numeric_limits<double>::quiet_NaN();
  end_.t = std::numeric_limits<double>::quiet_NaN();
  solver_.newton.forget();
}

// --- The step --------------------------------------------------------------------------------------------------------

void AnyCollocation::Carry::clear(const State& of) {
  r.setZero(of.r.size());
  v.setZero(of.v.size());
  y.setZero(of.y.size());
}

void AnyCollocation::begin_step(const Problem& problem, const State& from) {
  const Traits& has = problem.traits();
  n_ = from.r.size();
  m_ = has.values ? from.y.size() : 0;
  needs_speed_ = has.velocities;
  rate_ = measures_.motion().iteration().rate;
  if (is_newton()) {
    measures_.begin_as_one();
  } else {
    measures_.begin(problem, from, has.velocities ? 1 : 2);
  }
  solver_.mixing.forget();
  retried_ = refused_at_ == from.t;
  refused_at_ = from.t;  // until accept() says otherwise
  if (accepted_) {
    old_.swap(k_);
    has_old_ = true;
    accepted_ = false;
  }
  if (!continues(from)) {
    has_old_ = false;
    carry_.clear(from);
  }
  scales_.check(n_ + m_);
  k_.resize(n_ + m_, S());
  f_.resize(n_ + m_);
  stage_.y = from.y;
}

// The end of a run may be set to the time asked for, which differs by rounding.
bool AnyCollocation::continues(const State& from) const {
  return std::abs(from.t - end_.t) <= 1e-9 * old_dt_ && from.r.size() == end_.r.size() &&
         from.y.size() == end_.y.size() && from.r == end_.r && from.v == end_.v && from.y == end_.y;
}

bool AnyCollocation::guess(const Problem& problem, const State& from, double dt) {
  bootstraps_ = false;
  if (settings_.guess == Guess::free_flight) {
    k_.setZero();
    return true;
  }
  if (has_old_) {
    for (Eigen::Index i = 0; i < S(); ++i) {
      f_.setZero();
      add_weighted(table_->basis(1.0 + table_->c[i] * dt / old_dt_).data(), 1.0, old_, f_);
      k_.col(i) = f_;
    }
  } else {
    if (!rates_at_start(problem, from)) return false;
    k_.colwise() = start_;
    bootstraps_ = S() > 1;
  }
  if (S() == 1) guessed_ = k_.col(0);
  return true;
}

bool AnyCollocation::rates_here(const Problem& problem, double t) {
  stage_.t = t;
  if (!problem.rates(t, stage_.r, stage_.v, stage_.y, rates_)) return false;
  f_.head(n_) = rates_.a;
  if (m_ > 0) f_.tail(m_) = rates_.dy;
  return true;
}

bool AnyCollocation::rates_at_start(const Problem& problem, const State& from) {
  stage_.r = from.r;
  stage_.v = from.v;
  stage_.y = from.y;
  if (!rates_here(problem, from.t)) return false;
  start_ = f_;
  return true;
}

// From the rates as they stand.
bool AnyCollocation::rates_at_stage(const Problem& problem, const State& from, double dt, Eigen::Index i) {
  const double c = table_->c[i];
  if (n_ > 0) {
    stage_.r = from.r + (c * dt) * from.v;
    add_weighted(table_->A_bar.row(i).data(), dt * dt, k_.topRows(n_), stage_.r);
    stage_.v = from.v;
    if (needs_speed_) add_weighted(table_->A.row(i).data(), dt, k_.topRows(n_), stage_.v);
  }
  if (m_ > 0) {
    stage_.y = from.y;
    add_weighted(table_->A.row(i).data(), dt, k_.bottomRows(m_), stage_.y);
  }
  return rates_here(problem, from.t + c * dt);
}

bool AnyCollocation::renew_rates(const Problem& problem, const State& from, double dt) {
  if (solver_.how == StageSolver::How::in_turn) {
    for (Eigen::Index i = 0; i < S(); ++i) {
      if (!rates_at_stage(problem, from, dt, i)) return false;
      k_.col(i) = f_;
      if (bootstraps_) draw_through(i);
    }
    bootstraps_ = false;
    return true;
  }
  image_.resize(k_.rows(), S());
  for (Eigen::Index i = 0; i < S(); ++i) {
    if (!rates_at_stage(problem, from, dt, i)) return false;
    image_.col(i) = f_;
  }
  mix();
  return true;
}

// The later stages on the polynomial through the rates at the start and at the nodes up to i.
void AnyCollocation::draw_through(Eigen::Index i) {
  const Eigen::VectorXd& c = table_->c;
  for (Eigen::Index later = i + 1; later < S(); ++later) {
    double at_start = 1.0;
    StageWeights l = StageWeights::Zero(S());
    for (Eigen::Index j = 0; j <= i; ++j) {
      at_start *= (c[later] - c[j]) / -c[j];
      l[j] = c[later] / c[j];
      for (Eigen::Index m = 0; m <= i; ++m) l[j] *= m == j ? 1.0 : (c[later] - c[m]) / (c[j] - c[m]);
    }
    f_ = at_start * start_;
    add_weighted(l.data(), 1.0, k_, f_);
    k_.col(later) = f_;
  }
}

void AnyCollocation::mix() {
  if (solver_.how == StageSolver::How::newton) {
    image_ = solver_.newton.solve(image_ - k_);  // the change
    k_ += image_;
  } else if (solver_.how == StageSolver::How::at_once) {
    k_.swap(image_);
  } else {
    Eigen::VectorXd x = k_.reshaped(), gx = image_.reshaped();
    solver_.mixing.next(x, gx);
    k_ = x.reshaped(k_.rows(), S());
  }
}

// Largest change of a stage, each number over its size, values over the tolerance of their range too.
double AnyCollocation::stage_change(const Eigen::MatrixXd& change, double dt) const {
  if (!change.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  double biggest = 0.0;
  Eigen::VectorXd moved;
  for (Eigen::Index i = 0; i < S(); ++i) {
    moved.setZero(n_);
    add_weighted(table_->A_bar.row(i).data(), dt * dt, change.topRows(n_), moved);
    if (n_ > 0) biggest = std::max(biggest, scales_.of_places(moved));
    moved.setZero(m_);
    add_weighted(table_->A.row(i).data(), dt, change.bottomRows(m_), moved);
    if (m_ > 0) biggest = std::max(biggest, scales_.of_values(moved.cwiseQuotient(range_TOL_)));
  }
  return biggest;
}

// The rates with the other one of the weights b and b_bar than the state that is measured, over the same powers of the
// step: changes that turn, as they do where the slowest contracting ones are a pair, are never blind to both.
void AnyCollocation::weigh_otherwise(double dt) {
  other_r_.setZero(n_);
  other_y_.setZero(m_);
  const Eigen::VectorXd& of_motion = needs_speed_ ? table_->b_bar : table_->b;
  if (n_ > 0) add_weighted(of_motion.data(), dt * dt, k_.topRows(n_), other_r_);
  if (m_ > 0) add_weighted(table_->b_bar.data(), dt, k_.bottomRows(m_), other_y_);
}

void AnyCollocation::finish(const State& from, double dt, State& to) {
  const double *const by_place = table_->b_bar.data(), *const by_speed = table_->b.data();
  if (settings_.compensated) {
    if (n_ > 0) {
      change_ = dt * from.v - carry_.r;
      add_weighted(by_place, dt * dt, k_.topRows(n_), change_);
      add_compensated(from.r, change_, to.r, new_carry_.r);
      change_ = -carry_.v;
      add_weighted(by_speed, dt, k_.topRows(n_), change_);
      add_compensated(from.v, change_, to.v, new_carry_.v);
    }
    if (m_ > 0) {
      change_ = -carry_.y;
      add_weighted(by_speed, dt, k_.bottomRows(m_), change_);
      add_compensated(from.y, change_, to.y, new_carry_.y);
    }
  } else {
    if (n_ > 0) {
      to.r = from.r + dt * from.v;
      add_weighted(by_place, dt * dt, k_.topRows(n_), to.r);
      to.v = from.v;
      add_weighted(by_speed, dt, k_.topRows(n_), to.v);
    }
    if (m_ > 0) {
      to.y = from.y;
      add_weighted(by_speed, dt, k_.bottomRows(m_), to.y);
    }
  }
  new_end_ = to;
}

// --- Its error -------------------------------------------------------------------------------------------------------

// The larger of what it tells of the motion and of the values.
Truncation AnyCollocation::leading_coefficient(double dt) {
  if (n_ + m_ == 0) return {.error = 0.0, .order = order_};
  if (S() == 1) {
    change_ = k_.col(0) - guessed_;
  } else {
    change_.setZero(k_.rows());
    add_weighted(table_->top.data(), 1.0, k_, change_);
  }
  f_ = k_.cwiseAbs().rowwise().maxCoeff();
  const auto left = [&](double change, double rate) { return unresolved(*table_, order_, dt, change, rate); };
  double error = 0.0;
  if (n_ > 0) error = left(scales_.of_accelerations(change_.head(n_), dt), scales_.of_accelerations(f_.head(n_), dt));
  if (m_ > 0) {
    const double of_values = left(scales_.of_values(change_.tail(m_)), scales_.of_values(f_.tail(m_)));
    error = of_values >= error || std::isnan(of_values) ? of_values : error;
  }
  return {.error = error, .order = order_};
}

Truncation AnyCollocation::defect_at_start(const Problem& problem, const State& from, double dt) {
  const auto order = static_cast<int>(S());
  if (has_old_) {
    start_ = old_.col(S() - 1);
  } else if (settings_.guess == Guess::free_flight) {
    if (!rates_at_start(problem, from)) return {.error = std::numeric_limits<double>::infinity(), .order = order};
  }
  change_.setZero(k_.rows());
  add_weighted(table_->basis(0.0).data(), 1.0, k_, change_);
  Eigen::VectorXd error = filtered(start_ - change_, dt);
  if (retried_ || !has_old_) {  // the stiff part of a start off the slow solution has still to be damped once
    stage_.r = from.r;
    stage_.v = from.v;
    stage_.y = from.y + error.tail(m_);
    if (rates_here(problem, from.t)) error = filtered(f_ - change_, dt);
  }
  return {.error = scales_.of_values(error.tail(m_)), .order = order};
}

Eigen::VectorXd AnyCollocation::filtered(const Eigen::VectorXd& defect, double dt) const {
  if (is_newton()) return solver_.newton.filtered(defect, dt);
  return (dt / (2.0 * static_cast<double>(S()) - 1.0)) * defect;
}

}  // namespace particulate::schemes
