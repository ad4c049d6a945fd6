#include <particulate/schemes/staggering.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes {

double Aitken::factor(const Eigen::VectorXd& residual) {
  if (!omega_) {
    omega_ = 1.0;
  } else {
    const Eigen::VectorXd step = residual - last_;
    const double square = step.squaredNorm();
    if (square > 0.0) omega_ = -*omega_ * last_.dot(step) / square;
  }
  last_ = residual;
  return *omega_;
}

Staggered::Staggered(std::vector<Field> fields, Seen seen, std::optional<Aitken> relaxation)
    : fields_(std::move(fields)), seen_(seen), relaxation_(std::move(relaxation)) {
  if (fields_.empty()) throw std::invalid_argument("staggering: there must be at least one field, got none");
  if (relaxation_ && seen_ == Seen::previous) {
    throw std::invalid_argument(
        "staggering: relaxation needs Seen::newest, got Seen::previous: one factor cannot bring down the pairs of "
        "eigenvalues of opposite sign that a Jacobi sweep has");
  }
  for (const Field& field : fields_) {
    validate_tolerance(fmt::format("staggering: field {}", field.name), field.TOL);
    if (field.p < 1) {
      throw std::invalid_argument(
          fmt::format("staggering: field {}: p must be at least 1, got {}", field.name, field.p));
    }
  }
}

void Staggered::require_fields(std::size_t of_problem) const {
  if (fields_.size() != of_problem) {
    throw std::invalid_argument(fmt::format(
        "staggering: there must be settings for each of the problem's {} fields, got {}", of_problem, fields_.size()));
  }
}

void Staggered::collect() {
  iterations_.clear();
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    Iteration it = measures_[k].iteration();
    it.w_0 /= fields_[k].TOL;
    it.w_K /= fields_[k].TOL;
    it.rounding /= fields_[k].TOL;
    iterations_.push_back(it);
  }
}

// A field without a value is the worst; the first of equals.
const Iteration& Staggered::worst() const {
  return *std::max_element(iterations_.begin(), iterations_.end(), [](const Iteration& a, const Iteration& b) {
    return a.evaluated != b.evaluated ? a.evaluated : a.w_K < b.w_K;
  });
}

double Staggered::relaxation_factor() {
  Eigen::Index size = 0;
  for (std::size_t k = first_relaxed(); k < fields_.size(); ++k) size += olds_[k].size();
  Eigen::VectorXd residual(size);
  Eigen::Index at = 0;
  for (std::size_t k = first_relaxed(); k < fields_.size(); ++k) {
    const double unit = measures_[k].unit();
    residual.segment(at, olds_[k].size()) = olds_[k] / (unit > 0.0 ? unit : 1.0);
    at += olds_[k].size();
  }
  return relaxation_->factor(residual);
}

}  // namespace particulate::schemes
