#include <particulate/schemes/multirate.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <particulate/schemes/integrate.hpp>

namespace particulate::schemes {

namespace {

bool ask_fast(const Problem& problem, double t, const double* r, double* a, Eigen::Index n) {
  return problem.rate_fast(Where{t, {r, n}, {nullptr, 0}, {nullptr, 0}}, Answers{{a, n}, {nullptr, 0}});
}

// The motion under the fast acceleration and the polynomial of the slow one, from 0 to dt.
struct UnderSlow {
  const Problem& problem;
  const CollocationTable& table;
  const Eigen::MatrixXd& slow;
  double t, dt, apart;

  bool acceleration(double since, In r, Out a) const {
    if (!ask_fast(problem, t + since, r.data(), a.data(), r.size())) return false;
    const StageWeights l = table.basis(since / dt);
    a.noalias() += slow * l;
    return true;
  }
  double distance(In x, In y) const { return problem.distance(x, y); }
  double spacing(In) const { return apart; }
  void common_motion(In v, Out shared) const {
    Eigen::VectorXd all;
    problem.common_motion(v, all);
    shared = all;
  }
};

Sizes sizes_of(const MultirateSettings& settings) {
  return {.size = settings.size, .speed = settings.speed, .each = {}};
}

}  // namespace

void validate(const MultirateSettings& settings) {
  validate_tolerance("multirate collocation", settings.TOL);
  validate("multirate collocation", sizes_of(settings));
}

AnyMultirate::AnyMultirate(const CollocationTable& table, int order, const MultirateSettings& settings)
    : table_(&table), order_(order), settings_(settings), scales_(sizes_of(settings)) {
  validate(settings_);
}

bool AnyMultirate::predict(const Problem& problem, const State& from, double dt, State& to) {
  if (!problem.splits_motion()) {
    throw std::invalid_argument(
        "multirate collocation needs a problem that can split its acceleration, with split(state, dt) and "
        "acceleration_fast(t, r, a), such as a scene with one near field and no other law of pairs; take Collocation "
        "for this one");
  }
  measures_.begin(problem, from, 2);
  spacing_ = settings_.size ? 0.0 : problem.spacing(from.r);
  t_ = from.t;
  const bool bootstraps = !continues(from);
  if (!problem.split(from, dt) || !guess_slow(problem, from, dt) || !travel(problem, from, dt, to)) return false;
  // A constant is so much worse a guess than a polynomial that these make up for it.
  for (int extra = 0; bootstraps && extra < 2; ++extra) {
    if (!renew_slow(problem, from, dt) || !travel(problem, from, dt, to)) return false;
  }
  return true;
}

Iteration AnyMultirate::sweep(const Problem& problem, const State& from, double dt, State& to) {
  before_ = to.r;
  if (!renew_slow(problem, from, dt) || !travel(problem, from, dt, to)) return measures_.no_value();
  if (measures_.motion().waits_for_first()) measures_.normalize_motion(problem, from, dt, to.r, 1.0);
  return measures_.motion().record(problem.distance(to.r, before_));
}

Truncation AnyMultirate::truncation(const Problem& problem, const State& from, double dt, const State& to) {
  if (from.r.size() == 0) return {.error = 0.0, .order = order_};
  scales_.look(problem, from, dt, to);
  change_.noalias() = slow_ * table_->top;
  size_ = slow_.cwiseAbs().rowwise().maxCoeff();
  const double error =
      unresolved(*table_, order_, dt, scales_.of_accelerations(change_, dt), scales_.of_accelerations(size_, dt));
  return {.error = error, .order = order_};
}

void AnyMultirate::accept(double dt) {
  old_places_.swap(asked_);
  old_whole_.swap(whole_);
  old_t_ = t_;
  old_dt_ = dt;
  std::swap(end_, new_end_);
  inner_step_ = first_inner_step_;
  has_old_ = true;
}

// Asked once more where it was asked last.
void AnyMultirate::begin(const Problem& problem, const State& state) {
  const Eigen::Index last = table_->stages() - 1;
  const bool same =
      problem.identity() == of_ && continues(state) &&
      problem.rates(old_t_ + table_->c[last] * old_dt_, old_places_.col(last), state.v, state.y, rates_) &&
      rates_.a == old_whole_.col(last);
  if (!same) forget();
  of_ = problem.identity();
}

void AnyMultirate::forget() {
  has_old_ = false;
  inner_step_ = 0.0;
  end_.t = std::numeric_limits<double>::quiet_NaN();
}

void AnyMultirate::at(const State& from, double dt, double theta, State& there) const {
  const double since = theta * dt;
  std::size_t k = 0;
  while (k + 1 < inner_steps_ && pieces_[k + 1].from.t <= since) ++k;
  const Piece& piece = pieces_[k];
  collocation_at(table_of<Gauss<6>>(), piece.rates, piece.from, piece.dt, (since - piece.from.t) / piece.dt, there);
  advance_time(from, since, there);
  there.y = from.y;
}

// --- The step --------------------------------------------------------------------------------------------------------

bool AnyMultirate::continues(const State& from) const {
  return has_old_ && std::abs(from.t - end_.t) <= 1e-9 * old_dt_ && from.r.size() == end_.r.size() &&
         from.r == end_.r && from.v == end_.v;
}

bool AnyMultirate::fast_at(const Problem& problem, double t, const Eigen::VectorXd& r) {
  fast_.resize(r.size());
  return ask_fast(problem, t, r.data(), fast_.data(), r.size());
}

bool AnyMultirate::slow_at(const Problem& problem, double t, const Eigen::VectorXd& r, Eigen::Index node) {
  if (!problem.rates(t, r, Eigen::VectorXd(), Eigen::VectorXd(), rates_) || !fast_at(problem, t, r)) return false;
  asked_.col(node) = r;
  whole_.col(node) = rates_.a;
  slow_.col(node) = rates_.a - fast_;
  return true;
}

bool AnyMultirate::renew_slow(const Problem& problem, const State& from, double dt) {
  for (Eigen::Index i = 0; i < table_->stages(); ++i) {
    if (!slow_at(problem, from.t + table_->c[i] * dt, places_.col(i), i)) return false;
  }
  return true;
}

// What is fast now may have been slow in the last step, whose slow part is formed anew.
bool AnyMultirate::guess_slow(const Problem& problem, const State& from, double dt) {
  const Eigen::Index n = from.r.size(), s = table_->stages();
  slow_.resize(n, s);
  whole_.resize(n, s);
  places_.resize(n, s);
  asked_.resize(n, s);
  if (!continues(from)) {
    if (!slow_at(problem, from.t, from.r, 0)) return false;
    for (Eigen::Index j = 1; j < s; ++j) slow_.col(j) = slow_.col(0);
    return true;
  }
  Eigen::MatrixXd ahead(s, s);  // of the old nodes in each new one
  for (Eigen::Index i = 0; i < s; ++i) ahead.col(i) = table_->basis(1.0 + table_->c[i] * dt / old_dt_);
  slow_.setZero();
  for (Eigen::Index j = 0; j < s; ++j) {
    if (!fast_at(problem, old_t_ + table_->c[j] * old_dt_, old_places_.col(j))) return false;
    change_ = old_whole_.col(j) - fast_;
    slow_ += change_ * ahead.row(j);
  }
  return true;
}

bool AnyMultirate::travel(const Problem& problem, const State& from, double dt, State& to) {
  const UnderSlow inner{problem, *table_, slow_, from.t, dt, spacing_};
  Inner scheme({.size = settings_.size, .speed = settings_.speed, .sizes = {}});
  ErrorControl control{
      .TOL = settings_.TOL, .sweep_TOL = settings_.TOL, .step = std::min(inner_step_, dt), .limit = dt};
  State now{.t = 0.0, .r = from.r, .v = from.v};
  inner_steps_ = 0;
  Eigen::Index node = 0;
  State there;
  const Outcome outcome = integrate(inner, now, dt, scheme, control,
                                    [&](const State& start, const State& end, double step, const Inner& by) {
                                      for (; node < table_->stages() && table_->c[node] * dt <= end.t; ++node) {
                                        by.at(start, step, (table_->c[node] * dt - start.t) / step, there);
                                        places_.col(node) = there.r;
                                      }
                                      if (inner_steps_ == pieces_.size()) pieces_.emplace_back();
                                      Piece& piece = pieces_[inner_steps_++];
                                      piece.from = start;
                                      piece.dt = step;
                                      piece.rates = by.rates();
                                      return true;
                                    });
  if (outcome.status != Status::reached) return false;
  first_inner_step_ = control.step;
  advance_time(from, dt, to);
  to.r = now.r;
  to.v = now.v;
  to.y = from.y;
  new_end_ = to;
  return true;
}

}  // namespace particulate::schemes
