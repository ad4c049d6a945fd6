#include <particulate/schemes/scales.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

// NaN is the worst.
double worse(double a, double b) { return b >= a || std::isnan(b) ? b : a; }

}  // namespace

double largest(const Eigen::VectorXd& x) { return x.size() > 0 ? x.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() : 0.0; }

void validate(std::string_view whose, const Sizes& sizes) {
  const auto require = [&](const char* what, double given) {
    if (!(given > 0.0 && std::isfinite(given))) {
      throw std::invalid_argument(fmt::format("{}: {} must be positive and finite, got {}", whose, what, given));
    }
  };
  if (sizes.size) require("size", *sizes.size);
  if (sizes.speed) require("speed", *sizes.speed);
  for (const double size : sizes.each) require("sizes", size);
}

void ErrorScales::look(const Problem& problem, const State& from, double dt, const State& to) {
  values_ = problem.traits().values;
  n_ = from.r.size();
  check(n_ + (values_ ? from.y.size() : 0));
  if (n_ > 0) look_at_motion(problem, from, dt, to);
  if (values_) look_at_values(problem, from, to);
}

void ErrorScales::look_at_motion(const Problem& problem, const State& from, double dt, const State& to) {
  if (given_.each.size() > 0) {
    places_ = to.r.cwiseAbs().cwiseMax(given_.each.head(n_));
    length_ = places_.minCoeff();
  } else if (given_.size) {
    length_ = std::max(*given_.size, largest(to.r));
  } else {
    length_ = std::max(problem.spacing(from.r), problem.spacing(to.r));
    if (length_ == 0.0) length_ = std::max(largest(from.r), largest(to.r));
    length_ = std::max(length_, smallest);
  }
  if (given_.speed) {
    speed_ = std::max(*given_.speed, largest(to.v));
    return;
  }
  const auto within = [&](const Eigen::VectorXd& v) {
    if (!problem.has_scales()) return largest(v);
    problem.common_motion(v, shared_);
    return (v - shared_).cwiseAbs().maxCoeff();
  };
  speed_ = std::max({within(from.v), within(to.v), at_rest * length_ / dt, smallest});
}

void ErrorScales::look_at_values(const Problem& problem, const State& from, const State& to) {
  const Eigen::Index m = from.y.size();
  if (given_.each.size() > 0) {
    of_y_ = to.y.cwiseAbs().cwiseMax(given_.each.tail(m));
  } else if (given_.size) {
    of_y_ = to.y.cwiseAbs().cwiseMax(*given_.size);
  } else {
    of_y_.resize(m);
    for (const Range& range : problem.ranges(m)) {
      const auto part = [&](const Eigen::VectorXd& y) {
        return y.segment(range.first, range.size).lpNorm<Eigen::Infinity>();
      };
      of_y_.segment(range.first, range.size).setConstant(std::max({part(from.y), part(to.y), smallest}));
    }
  }
}

double ErrorScales::of_places(const Eigen::VectorXd& x) const {
  return given_.each.size() > 0 ? largest(x.cwiseQuotient(places_)) : largest(x) / length_;
}

double ErrorScales::of_speeds(const Eigen::VectorXd& x) const { return largest(x) / speed_; }

double ErrorScales::of_accelerations(const Eigen::VectorXd& a, double dt) const {
  return std::max(of_speeds(a), dt * of_places(a));
}

double ErrorScales::of_values(const Eigen::VectorXd& x) const { return largest(x.cwiseQuotient(of_y_)); }

double ErrorScales::relative(const State& error) const {
  double all = 0.0;
  if (error.r.size() > 0) all = worse(of_places(error.r), of_speeds(error.v));
  return values_ ? worse(all, of_values(error.y)) : all;
}

Eigen::VectorXd ErrorScales::unknowns() const {
  if (given_.each.size() > 0) return given_.each;
  const Eigen::Index m = values_ ? of_y_.size() : 0;
  Eigen::VectorXd all(n_ + m);
  all.head(n_).setConstant(given_.size.value_or(length_));
  if (given_.size) {
    all.tail(m).setConstant(*given_.size);
  } else if (m > 0) {
    all.tail(m) = of_y_;
  }
  return all;
}

void ErrorScales::check(Eigen::Index unknowns) const {
  if (given_.each.size() == 0 || given_.each.size() == unknowns) return;
  throw std::invalid_argument(
      fmt::format("sizes must be one for each of {} unknowns, got {}", unknowns, given_.each.size()));
}

}  // namespace particulate::schemes
