#include <particulate/identification/history_cost.hpp>

#include <cmath>
#include <exception>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/kinematics/energy.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/sampling.hpp>

namespace particulate::identification {

namespace {

// A target that varies by less than this share of its size says nothing: rounding moves a constant by less, and noise
// that mattered would hide a variation so small.
constexpr double least_variation = 1e-9;

[[noreturn]] void refuse_target(const Target& target, const std::string& why) {
  throw std::invalid_argument(fmt::format("target \"{}\": {}", target.name, why));
}

void validate_times(const Target& target) {
  const std::vector<double>& t = target.times;
  if (t.size() < 2) refuse_target(target, fmt::format("it must have two times at least, got {}", t.size()));
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (!std::isfinite(t[k]) || (k > 0 && !(t[k] > t[k - 1]))) {
      refuse_target(target, fmt::format("times must be finite and rise, time {} is {} s", k, t[k]));
    }
  }
}

void validate_start(const Target& target, Eigen::Index start) {
  const auto values = target.values.col(start);
  const double size = values.lpNorm<Eigen::Infinity>(), variation = values.maxCoeff() - values.minCoeff();
  if (size == 0.0) {
    refuse_target(target, fmt::format("start {}: it is zero throughout, and distances are counted relative to it: "
                                      "choose a quantity that is not",
                                      start));
  }
  if (variation <= least_variation * size) {
    refuse_target(target,
                  fmt::format("start {}: it must vary by more than {:g} of its size, got {:.3g}; a constant says "
                              "nothing of the parameters. The bulk energy of an isolated scene is one: choose the "
                              "relative energy",
                              start, least_variation, variation / size));
  }
}

// Half of the interval on either side of each time [s].
Eigen::VectorXd trapezoidal_weights(const std::vector<double>& times) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(times.size()));
  for (Eigen::Index k = 1; k < weights.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double half = 0.5 * (times[at] - times[at - 1]);
    weights[k - 1] += half;
    weights[k] += half;
  }
  return weights;
}

// Refuses what targets must not be together. @return the sum of their weights
double validate_all(const std::vector<Target>& targets) {
  if (targets.empty()) throw std::invalid_argument("a cost of histories must have a target at least, got none");
  double weights = 0.0;
  for (const Target& target : targets) {
    validate(target);
    if (target.values.cols() != targets.front().values.cols()) {
      refuse_target(target, fmt::format("all targets must have as many starts, it has {} and the first has {}",
                                        target.values.cols(), targets.front().values.cols()));
    }
    weights += target.weight;
  }
  if (!(weights > 0.0)) throw std::invalid_argument("weights of targets must not all be zero");
  return weights;
}

void require_like(const Simulated& simulated, const std::vector<Target>& targets) {
  if (simulated.histories.size() != targets.size()) {
    throw std::invalid_argument(fmt::format("a model of histories must give one a target, {}, got {}", targets.size(),
                                            simulated.histories.size()));
  }
  for (std::size_t h = 0; h < targets.size(); ++h) {
    const Sampled& history = simulated.histories[h];
    if (history.times != targets[h].times || history.values.size() != targets[h].values.rows()) {
      refuse_target(targets[h],
                    "the model's history must be at the times of its target, it is at others: hand it the "
                    "same numbers");
    }
  }
}

Simulated simulate(const HistoryModel& model, const Eigen::VectorXd& parameters, Eigen::Index start) {
  try {
    return model(parameters, start);
  } catch (const std::exception& error) { return {.reason = error.what()}; }
}

}  // namespace

void validate(const Target& target) {
  validate_times(target);
  const auto times = static_cast<Eigen::Index>(target.times.size());
  if (target.values.rows() != times || target.values.cols() == 0) {
    refuse_target(target, fmt::format("it must have {} values, one a time, from one start at least, got {} from {}",
                                      times, target.values.rows(), target.values.cols()));
  }
  if (!target.values.allFinite()) refuse_target(target, "its values must be finite");
  if (!(target.weight >= 0.0 && std::isfinite(target.weight))) {
    refuse_target(target, fmt::format("its weight must be finite and not negative, got {}", target.weight));
  }
  for (Eigen::Index start = 0; start < target.values.cols(); ++start) validate_start(target, start);
}

HistoryCost::HistoryCost(std::vector<Target> targets, HistoryModel model)
    : targets_(std::move(targets)), model_(std::move(model)) {
  const double weights = validate_all(targets_);
  Eigen::Index length = 0, next = 0;
  for (const Target& target : targets_) length += target.values.size();
  data_.resize(length), per_absolute_.resize(length), per_square_.resize(length);
  for (const Target& target : targets_) {
    shares_.push_back(target.weight / (weights * static_cast<double>(starts())));
    const Eigen::VectorXd q = trapezoidal_weights(target.times);
    for (const auto& values : target.values.colwise()) {
      data_.segment(next, q.size()) = values;
      per_absolute_.segment(next, q.size()) = q / q.dot(values.cwiseAbs());
      per_square_.segment(next, q.size()) = shares_.back() / q.dot(values.cwiseAbs2()) * q;
      next += q.size();
    }
  }
}

Eigen::VectorXd HistoryCost::sampled(const Eigen::VectorXd& parameters, std::string& reason) const {
  Eigen::VectorXd all(data_.size());
  for (Eigen::Index start = 0; start < starts(); ++start) {
    const Simulated simulated = simulate(model_, parameters, start);
    reason = simulated.reason;
    if (!reason.empty()) return {};
    require_like(simulated, targets_);
    Eigen::Index before = 0;
    for (const Sampled& history : simulated.histories) {
      all.segment(before + start * history.values.size(), history.values.size()) = history.values;
      before += starts() * history.values.size();
    }
  }
  if (all.allFinite()) return all;
  reason = "a history is not finite";
  return {};
}

Parts HistoryCost::parts(const Eigen::VectorXd& parameters) const {
  Parts all;
  const Eigen::VectorXd values = sampled(parameters, all.reason);
  if (values.size() == 0) return all;
  const Eigen::VectorXd distances = per_absolute_.cwiseProduct((values - data_).cwiseAbs());
  Eigen::Index next = 0;
  for (std::size_t h = 0; h < targets_.size(); ++h) {
    const Eigen::Index times = targets_[h].values.rows();
    for (Eigen::Index start = 0; start < starts(); ++start, next += times) {
      all.parts.push_back({.name = fmt::format("{}, start {}", targets_[h].name, start),
                           .share = shares_[h],
                           .distance = distances.segment(next, times).sum()});
    }
  }
  return all;
}

Value HistoryCost::operator()(const Eigen::VectorXd& parameters) const {
  const Parts all = parts(parameters);
  if (!all.reason.empty()) return Value(all.reason);
  double cost = 0.0;
  for (const Part& part : all.parts) cost += part.share * part.distance;
  return cost;
}

Eigen::VectorXd HistoryCost::residuals(const Eigen::VectorXd& parameters) const {
  const Eigen::VectorXd values = sampled(parameters);
  if (values.size() == 0) return values;
  return per_square_.cwiseSqrt().cwiseProduct(values - data_);
}

Eigen::VectorXd HistoryCost::sampled(const Eigen::VectorXd& parameters) const {
  std::string reason;
  return sampled(parameters, reason);
}

Simulated relative_energy_history(const kinematics::Particles& particles, const schemes::Problem& problem,
                                  const std::vector<double>& times, const HistoryRun& run) {
  if (times.empty() || !(times.back() > 0.0)) {
    throw std::invalid_argument(
        "a history must have a time after the start at 0 s, got none: give the times to look at");
  }
  Sampled history{.times = times, .values = Eigen::VectorXd(static_cast<Eigen::Index>(times.size()))};
  Eigen::Index next = 0;
  long steps = 0;
  schemes::Sampling sampling(
      times,
      [&](const schemes::State& at) {
        history.values[next++] = kinematics::split_kinetic_energy(particles.mass, schemes::velocities(at)).relative;
      },
      [&](const auto&...) { return ++steps < run.most_steps; });
  schemes::State state{.t = 0.0, .r = particles.position.reshaped(), .v = particles.velocity.reshaped()};
  const schemes::Outcome outcome =
      schemes::integrate(problem, state, times.back(), schemes::Collocation<schemes::Gauss<8>>(),
                         schemes::ErrorControl{.TOL = run.TOL, .sweep_TOL = run.TOL}, sampling);
  // A run that reaches its end in the last step allowed has all its times.
  if (sampling.left() == 0) return {.histories = {std::move(history)}};
  if (outcome.status == schemes::Status::stopped) return {.reason = "the run takes too many steps"};
  return {.reason = fmt::format("the run does not reach its end: {}", schemes::name(outcome.failure))};
}

}  // namespace particulate::identification
