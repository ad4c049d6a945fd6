#include <particulate/schemes/iteration.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/schemes/scales.hpp>

namespace particulate::schemes {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Where rounding rules, the changes go up and down within some roundings.
constexpr double some_roundings = 64.0;

std::string of_field(const Iteration& it) { return it.field.empty() ? "" : fmt::format(" of field {}", it.field); }

// The mean contraction of all sweeps: the last ratio alone may be one of a period of two.
double mean_rate(const Iteration& it) { return it.K > 0 ? std::pow(it.w_K / it.w_0, 1.0 / it.K) : it.rate; }

}  // namespace

void IterationMeasure::begin(int p, std::string_view field) {
  it_ = {.p = p, .field = field};
  denominator_ = 0.0;
}

void IterationMeasure::normalize(double displacement, double size) {
  const double whole = size + displacement;
  denominator_ = std::max(displacement, epsilon * whole);
  it_.rests = displacement <= ErrorScales::at_rest * whole;
  it_.rounding = denominator_ > 0.0 ? epsilon * whole / denominator_ : 0.0;
}

const Iteration& IterationMeasure::record(double change) {
  const double w = change > 0.0 ? change / denominator_ : 0.0;
  // What overflows may end as NaN: the last ratio still tells whether the sweeps were diverging.
  const double rate = it_.change > 0.0 ? change / it_.change : 0.0;
  if (!std::isnan(rate)) it_.rate = rate;
  if (!(std::isfinite(change) && std::isfinite(w) && std::isfinite(denominator_))) return no_value();
  it_.K = waits_for_first() ? 0 : it_.K + 1;
  if (it_.K == 0) it_.w_0 = w;
  it_.w_K = w;
  it_.change = change;
  return it_;
}

const Iteration& IterationMeasure::no_value() {
  it_.evaluated = false;
  return it_;
}

void PartMeasures::begin(const Problem& problem, const State& from, int p) {
  const Traits& has = problem.traits();
  moves_ = has.motion;
  ranges_.clear();
  if (has.values) ranges_ = problem.ranges(from.y.size());
  measures_.resize((moves_ ? 1 : 0) + ranges_.size());
  const bool several = measures_.size() > 1;
  if (moves_) measures_.front().begin(p, several ? "motion" : "");
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    measures_[k + (moves_ ? 1 : 0)].begin(1, several ? ranges_[k].name : "");
  }
  iterations_.clear();
}

void PartMeasures::begin_as_one() {
  moves_ = true;
  ranges_.clear();
  measures_.resize(1);
  measures_.front().begin(1);
}

void PartMeasures::normalize_motion(const Problem& problem, const State& from, double dt, const Eigen::VectorXd& after,
                                    double scale) {
  const bool by_speed = problem.traits().velocities;
  if (zero_.size() != from.r.size()) zero_.setZero(from.r.size());
  const double size = scale * problem.distance(by_speed ? from.v : from.r, zero_);
  if (problem.has_scales()) {
    problem.common_motion(from.v, drifted_);
    drifted_ = from.r + dt * drifted_;
  }
  motion().normalize(problem.distance(after, problem.has_scales() ? drifted_ : from.r), size);
}

double PartMeasures::distance(const Problem& problem, const Range& range, const Eigen::VectorXd& x,
                              const Eigen::VectorXd& y) const {
  if (measures_.size() == 1) return problem.distance(x, y);
  return (x.segment(range.first, range.size) - y.segment(range.first, range.size)).lpNorm<1>();
}

void PartMeasures::record_values(const Problem& problem, const Eigen::VectorXd& start, const Eigen::VectorXd& before,
                                 const Eigen::VectorXd& after) {
  record_values(problem, start, before, after, before, before);
}

void PartMeasures::record_values(const Problem& problem, const Eigen::VectorXd& start, const Eigen::VectorXd& before,
                                 const Eigen::VectorXd& after, const Eigen::VectorXd& other_before,
                                 const Eigen::VectorXd& other_after) {
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    IterationMeasure& measure = measures_[k + (moves_ ? 1 : 0)];
    const auto apart = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
      return distance(problem, ranges_[k], x, y);
    };
    if (measure.waits_for_first()) {
      measure.normalize(apart(after, start), apart(start, Eigen::VectorXd::Zero(start.size())));
    }
    double change = apart(after, before);
    if (&other_before != &other_after) change = std::max(change, apart(other_after, other_before));
    measure.record(change);
  }
}

Iteration PartMeasures::no_value() {
  for (IterationMeasure& measure : measures_) measure.no_value();
  return worst();
}

Iteration PartMeasures::worst() {
  if (measures_.size() == 1 && (moves_ || ranges_.front().TOL == 1.0)) return measures_.front().iteration();
  iterations_.clear();
  if (moves_) iterations_.push_back(measures_.front().iteration());
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    iterations_.push_back(in_units(measures_[k + (moves_ ? 1 : 0)].iteration(), ranges_[k].TOL));
  }
  return worst_of(iterations_);
}

const Iteration& worst_of(std::span<const Iteration> all) {
  const auto left = [](const Iteration& it) { return met(it, 0.0) ? 0.0 : it.w_K; };
  return *std::max_element(all.begin(), all.end(), [&](const Iteration& a, const Iteration& b) {
    return a.evaluated != b.evaluated ? a.evaluated : left(a) < left(b);
  });
}

Iteration in_units(Iteration it, double TOL) {
  it.w_0 /= TOL;
  it.w_K /= TOL;
  it.rounding /= TOL;
  return it;
}

double phi_K(const Iteration& it, double TOL, int K_d) {
  if (it.K < 1) return std::numeric_limits<double>::quiet_NaN();
  if (it.w_K == 0.0) return std::numeric_limits<double>::infinity();
  return std::pow(TOL / it.w_0, 1.0 / (it.p * K_d)) / std::pow(it.w_K / it.w_0, 1.0 / (it.p * it.K));
}

void validate_tolerance(std::string_view whose, double TOL) {
  if (!(TOL >= epsilon && std::isfinite(TOL))) {
    throw std::invalid_argument(fmt::format(
        "{}: TOL must be finite and at least {:.3g}, below which is rounding, got {}", whose, epsilon, TOL));
  }
}

bool at_rounding(const Iteration& it) {
  if (it.w_K <= it.rounding) return true;
  // What has all but come to rest may go round in a few roundings from its first sweep on.
  if (it.rests && it.K > 0 && it.rate >= 1.0 && it.w_K <= some_roundings * it.rounding) return true;
  if (!(it.K > 0 && it.rate >= 1.0 && it.w_K < it.w_0)) return false;
  return it.w_K * (1.0 - mean_rate(it)) <= some_roundings * it.rounding;
}

bool shows_contraction(const Iteration& it) { return !it.evaluated || it.w_K >= 1000.0 * it.rounding; }

Decision unmet(const Attempt& made, double TOL, int allowed) {
  const Iteration& it = made.iteration;
  if (it.evaluated && at_rounding(it)) {
    return {
        .accepted = false,
        .impossible = fmt::format(
            "TOL = {:.3g} is below rounding: the sweeps{} change the state by w = {:.3g} and no less, where one "
            "rounding of it is w = {:.3g} of the displacement at Dt = {:.3g} s; choose a larger TOL, or larger steps",
            TOL, of_field(it), it.w_K, it.rounding, made.dt),
        .failure = Failure::rounding};
  }
  if (!it.evaluated && !(it.rate > 1.0)) {
    return {.accepted = false,
            .impossible = fmt::format("the problem has no finite value within this step of {:.6g} s", made.dt),
            .failure = Failure::no_value};
  }
  const double rate = mean_rate(it);
  const bool contracts = it.evaluated && rate < 1.0;
  const double workable = phi_K(it, TOL, allowed) * made.dt;
  return {.accepted = false,
          .impossible = fmt::format(
              "the sweeps{} {} by a factor of {:.4g} each at Dt = {:.6g} s, w = {:.3g} after {}; TOL = {:.3g} in {} "
              "contractions needs {}",
              of_field(it), contracts ? "contract" : "diverge", rate, made.dt, it.w_K, it.K + 1, TOL, allowed,
              std::isfinite(workable) ? fmt::format("about Dt = {:.4g} s", workable) : "a smaller step"),
          .failure = contracts ? Failure::slow : Failure::diverging,
          .workable = workable};
}

}  // namespace particulate::schemes
