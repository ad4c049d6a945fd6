#include <particulate/identification/misfit.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::identification {

namespace {

void validate(const Wanted& wanted) {
  const auto require = [&](bool holds, const char* what, double given) {
    if (!holds) throw std::invalid_argument(fmt::format("wanted \"{}\": {}, got {}", wanted.name, what, given));
  };
  require(std::isfinite(wanted.value), "its value must be finite", wanted.value);
  require(wanted.weight >= 0.0 && std::isfinite(wanted.weight), "its weight must be finite and not negative",
          wanted.weight);
  require(wanted.scale >= 0.0 && std::isfinite(wanted.scale), "its scale must be finite and not negative",
          wanted.scale);
  require(wanted.scale > 0.0 || wanted.value != 0.0,
          "a difference is counted in its value, which must not be zero: give a scale", wanted.value);
}

double scale_of(const Wanted& wanted) { return wanted.scale > 0.0 ? wanted.scale : std::abs(wanted.value); }

}  // namespace

Misfit::Misfit(std::vector<Wanted> wanted, SampledModel model)
    : wanted_(std::move(wanted)), model_(std::move(model)), shares_(static_cast<Eigen::Index>(wanted_.size())) {
  Eigen::Index k = 0;
  for (const Wanted& one : wanted_) {
    validate(one);
    shares_[k++] = one.weight;
  }
  if (!(shares_.sum() > 0.0)) {
    throw std::invalid_argument(
        fmt::format("something must be wanted, with a positive weight; got {} numbers, whose weights add up to {}",
                    wanted_.size(), shares_.sum()));
  }
  shares_ /= shares_.sum();
}

Eigen::VectorXd Misfit::misfits(const Eigen::VectorXd& found) const {
  if (found.size() != 0 && found.size() != shares_.size()) {
    throw std::invalid_argument(
        fmt::format("the model must give a number for each of {} that are wanted, or none at all, got {}",
                    shares_.size(), found.size()));
  }
  Eigen::VectorXd misfits(found.size());
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    const Wanted& wanted = wanted_[static_cast<std::size_t>(k)];
    misfits[k] = (found[k] - wanted.value) / scale_of(wanted);
  }
  return misfits;
}

Value Misfit::of(const Eigen::VectorXd& found) const {
  const Eigen::VectorXd off = misfits(found);
  if (off.size() == 0) return Value(std::string("the model has no value"));
  return off.cwiseAbs().dot(shares_);
}

Value Misfit::operator()(const Eigen::VectorXd& parameters) const { return of(model_(parameters)); }

Eigen::VectorXd Misfit::residuals(const Eigen::VectorXd& parameters) const {
  const Eigen::VectorXd off = misfits(model_(parameters));
  if (off.size() == 0) return {};
  return off.cwiseProduct(shares_.cwiseSqrt());
}

std::vector<Reached> Misfit::reached(const Eigen::VectorXd& parameters) const {
  const Eigen::VectorXd found = model_(parameters), off = misfits(found);
  std::vector<Reached> all;
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    const Wanted& wanted = wanted_[static_cast<std::size_t>(k)];
    all.push_back({.name = wanted.name, .wanted = wanted.value, .found = found[k], .misfit = off[k]});
  }
  return all;
}

std::string unreached(const std::vector<Reached>& reached, double tolerance) {
  if (!(tolerance > 0.0)) {
    throw std::invalid_argument(fmt::format("a tolerance must be positive, got {}", tolerance));
  }
  std::string text;
  for (const Reached& one : reached) {
    if (std::abs(one.misfit) <= tolerance) continue;
    text += fmt::format("{}\"{}\": {:.6g} is wanted, {:.6g} came nearest", text.empty() ? "" : "; ", one.name,
                        one.wanted, one.found);
  }
  return text;
}

}  // namespace particulate::identification
