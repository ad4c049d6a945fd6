#include <particulate/identification/polishing.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <unsupported/Eigen/NonLinearOptimization>

namespace particulate::identification {

namespace {

// What stands for residuals where there are none: so large that a step there is taken back.
constexpr double far_off = 1e100;

// The residuals as a function of angles, in the form that Eigen's solver asks for; it keeps the best that it meets.
class OfAngles {
 public:
  using Scalar = double;

  OfAngles(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start, const Polishing& polishing)
      : residuals_(residuals), box_(box), polishing_(polishing), width_(box.upper - box.lower) {
    best_.parameters = start;
    best_.before = best_.after = std::numeric_limits<double>::infinity();
    first_ = residuals_at(start);
    best_.before = best_.after;
    if (first_.size() != 0 && first_.size() < start.size()) {
      throw std::invalid_argument(
          fmt::format("polishing: there must be at least as many residuals as parameters, got {} and {}: add residuals "
                      "or hold parameters fixed",
                      first_.size(), start.size()));
    }
  }

  int values() const { return static_cast<int>(first_.size()); }

  Eigen::VectorXd first_angles() {
    constexpr double off_bound = 1e-3;
    from_ = best_.parameters.cwiseMax(box_.lower + off_bound * width_).cwiseMin(box_.upper - off_bound * width_);
    angles_ = (1.0 - 2.0 * (from_ - box_.lower).array() / width_.array()).acos();
    return angles_;
  }

  // Both return a negative number once the evaluations are used up, which ends the solver.
  int operator()(const Eigen::VectorXd& angles, Eigen::VectorXd& values) {
    at_ = box_.lower + (0.5 * width_.array() * (1.0 - angles.array().cos())).matrix();
    at_ = at_.cwiseMax(box_.lower).cwiseMin(box_.upper);
    // Rounding must not carry the start across the edge of where there are residuals.
    at_ = (angles.array() == angles_.array()).select(from_, at_);
    here_ = residuals_at(at_);
    if (here_.size() == 0) here_.setConstant(first_.size(), far_off);
    values = here_;
    return used_up_ ? -1 : 0;
  }
  // The solver differentiates where it has just evaluated.
  int df(const Eigen::VectorXd& angles, Eigen::MatrixXd& jacobian) {
    for (Eigen::Index i = 0; i < at_.size(); ++i) {
      jacobian.col(i) = 0.5 * width_[i] * std::sin(angles[i]) * slope(i);
    }
    return used_up_ ? -1 : 0;
  }

  Polished& best() { return best_; }

 private:
  // Empty: there are none.
  Eigen::VectorXd residuals_at(const Eigen::VectorXd& parameters) {
    if (best_.evaluations >= polishing_.most_evaluations) used_up_ = true;
    if (used_up_ || (box_.allows && !box_.allows(parameters))) return {};
    best_.evaluations += 1;
    const Eigen::VectorXd values = residuals_(parameters);
    if (!values.allFinite() || values.size() == 0) return {};
    if (first_.size() != 0 && values.size() != first_.size()) {
      throw std::invalid_argument(
          fmt::format("polishing: there must be as many residuals for all parameters, got {} and {}: give an empty "
                      "vector where there are none",
                      first_.size(), values.size()));
    }
    if (values.squaredNorm() < best_.after) {
      best_.parameters = parameters;
      best_.after = values.squaredNorm();
    }
    return values;
  }
  Eigen::VectorXd beside(Eigen::Index i, double step) {
    Eigen::VectorXd parameters = at_;
    parameters[i] += step;
    if (parameters[i] < box_.lower[i] || parameters[i] > box_.upper[i]) return {};
    const long before = best_.evaluations;
    Eigen::VectorXd values = residuals_at(parameters);
    best_.for_differences += best_.evaluations - before;
    if (values.size() == 0 && !used_up_) ++best_.failed_differences;
    return values;
  }
  // The derivative for parameter i, to the other side where one has no residuals, zero where neither has.
  Eigen::VectorXd slope(Eigen::Index i) {
    const double step = polishing_.step * width_[i];
    const Eigen::VectorXd ahead = beside(i, step);
    if (ahead.size() != 0 && !polishing_.central) return (ahead - here_) / step;
    const Eigen::VectorXd behind = beside(i, -step);
    if (ahead.size() == 0 && behind.size() == 0) return Eigen::VectorXd::Zero(here_.size());
    if (behind.size() == 0) return (ahead - here_) / step;
    if (ahead.size() == 0) return (here_ - behind) / step;
    return (ahead - behind) / (2.0 * step);
  }

  const Residuals& residuals_;
  const Box& box_;
  const Polishing& polishing_;
  Eigen::VectorXd width_, first_;  // residuals at the start
  Eigen::VectorXd from_, angles_;  // where it sets out, off the bounds
  Eigen::VectorXd at_, here_;      // the last place asked for, and its residuals
  Polished best_;
  bool used_up_ = false;
};

std::string reason_of(Eigen::LevenbergMarquardtSpace::Status status) {
  using namespace Eigen::LevenbergMarquardtSpace;
  switch (status) {
    case RelativeReductionTooSmall:
    case RelativeErrorTooSmall:
    case RelativeErrorAndReductionTooSmall:
      return "a step gained no more than the tolerance asks for";
    case CosinusTooSmall:
      return "the gradient is zero";
    case UserAsked:
      return "the limit of evaluations is reached";
    default:
      return "rounding leaves nothing to gain";
  }
}

void require_inside(const Box& box, const Eigen::VectorXd& start) {
  const bool inside = start.size() == box.lower.size() && (start.array() >= box.lower.array()).all() &&
                      (start.array() <= box.upper.array()).all() && (!box.allows || box.allows(start));
  if (!inside) throw std::invalid_argument("polishing: the start must lie in the box, and allowed: start there");
}

}  // namespace

void validate(const Polishing& polishing) {
  if (!(polishing.step > 0.0 && polishing.step < 0.5)) {
    throw std::invalid_argument(fmt::format(
        "polishing: the step of differences must lie between 0 and 0.5 widths of the box, got {}", polishing.step));
  }
  if (!(polishing.tolerance >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("polishing: the tolerance must not be negative, got {}", polishing.tolerance));
  }
  if (polishing.most_evaluations < 1) {
    throw std::invalid_argument(
        fmt::format("polishing: at least one evaluation must be allowed, got {}", polishing.most_evaluations));
  }
}

Polished polish(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start, const Polishing& polishing) {
  validate(box);
  validate(polishing);
  require_inside(box, start);
  OfAngles function(residuals, box, start, polishing);
  if (function.values() == 0) {
    function.best().reason = "the start has no residuals";
    return function.best();
  }
  Eigen::LevenbergMarquardt<OfAngles> solver(function);
  solver.parameters.ftol = polishing.tolerance;
  solver.parameters.xtol = std::sqrt(std::numeric_limits<double>::epsilon());
  solver.parameters.factor = 1.0;
  Eigen::VectorXd angles = function.first_angles();
  Eigen::LevenbergMarquardtSpace::Status status = solver.minimizeInit(angles);
  while (status == Eigen::LevenbergMarquardtSpace::NotStarted || status == Eigen::LevenbergMarquardtSpace::Running) {
    status = solver.minimizeOneStep(angles);
  }
  function.best().reason = reason_of(status);
  return function.best();
}

}  // namespace particulate::identification
