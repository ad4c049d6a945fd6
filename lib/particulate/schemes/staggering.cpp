#include <particulate/schemes/staggering.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
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

double Staggered::spans(TimeScale::Kind kind, int sweeps) const {
  const double none = std::numeric_limits<double>::infinity();
  if (relaxation_ || kind == TimeScale::Kind::oscillates || kind == TimeScale::Kind::relaxes) return none;
  if (kind == TimeScale::Kind::drifts) return sweeps == 1 ? 1.0 : none;
  if (kind == TimeScale::Kind::waves && sweeps == 1 && seen_ == Seen::previous) return 0.0;
  return sweeps == 1 ? 2.0 : 1.0;
}

bool Staggered::predict(const Problem& problem, const State& from, double dt, State& to) {
  to = from;
  advance_time(from, dt, to);
  begin(problem, to);
  return true;
}

void Staggered::begin(const Problem& problem, const State& to) {
  if (fields_.size() != problem.fields()) {
    throw std::invalid_argument(
        fmt::format("staggering: there must be settings for each of the problem's {} fields, got {}", problem.fields(),
                    fields_.size()));
  }
  owned_.resize(fields_.size());
  measures_.resize(fields_.size());
  starts_.resize(fields_.size());
  olds_.resize(fields_.size());
  Eigen::Index places = 0, values = 0;
  std::vector<bool> taken(static_cast<std::size_t>(to.y.size()));
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const Part part = problem.part(k);
    if (!part.motion && !(part.first >= 0 && part.size >= 0 && part.first + part.size <= to.y.size())) {
      throw std::invalid_argument(
          fmt::format("staggering: field {} must own a range of the {} values of the state, got {} from {} on",
                      fields_[k].name, to.y.size(), part.size, part.first));
    }
    for (Eigen::Index i = part.first; i < part.first + part.size && !part.motion; ++i) {
      if (taken[static_cast<std::size_t>(i)]) {
        throw std::invalid_argument(
            fmt::format("staggering: fields must own all of the state, each number once; field {} owns value {}, which "
                        "another owns",
                        fields_[k].name, i));
      }
      taken[static_cast<std::size_t>(i)] = true;
    }
    owned_[k] = {.part = part, .measured = part.motion ? to.r.size() : part.size};
    measures_[k].begin(fields_[k].p, fields_[k].name);
    (part.motion ? places : values) += owned_[k].measured;
    starts_[k] = read(owned_[k], to);
  }
  if (places != to.r.size() || values != to.y.size()) {
    throw std::invalid_argument(fmt::format(
        "staggering: fields must own all of the state, {} places and {} values, each once; they own {} and {}",
        to.r.size(), to.y.size(), places, values));
  }
  if (relaxation_) relaxation_->forget();
  collect();
}

Eigen::VectorXd Staggered::read(const Owned& field, const State& state) {
  if (!field.part.motion) return state.y.segment(field.part.first, field.part.size);
  Eigen::VectorXd all(state.r.size() + state.v.size());
  all.head(state.r.size()) = state.r;
  all.tail(state.v.size()) = state.v;
  return all;
}

void Staggered::write(const Owned& field, const Eigen::VectorXd& value, State& state) {
  if (field.part.motion) {
    state.r = value.head(state.r.size());
    state.v = value.tail(state.v.size());
  } else {
    state.y.segment(field.part.first, field.part.size) = value;
  }
}

Iteration Staggered::sweep(const Problem& problem, const State& from, double dt, State& to) {
  for (std::size_t k = 0; k < fields_.size(); ++k) olds_[k] = read(owned_[k], to);
  std::optional<State> previous;
  if (seen_ == Seen::previous) previous = to;
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    if (!problem.solve(k, from, dt, previous ? *previous : to, to)) {
      measures_[k].no_value();
      break;
    }
    record(problem, k, from, to);
  }
  collect();
  const Iteration worst = worst_of(iterations_);
  if (relaxation_ && worst.evaluated) relax(to);
  end_ = to;
  return worst;
}

void Staggered::at(const State& from, double dt, double theta, State& there) const {
  advance_time(from, theta * dt, there);
  there.r = from.r + theta * (end_.r - from.r);
  there.v = from.v + theta * (end_.v - from.v);
  there.y = from.y + theta * (end_.y - from.y);
}

void Staggered::record(const Problem& problem, std::size_t k, const State& from, const State& to) {
  const Eigen::Index n = owned_[k].measured;
  const Eigen::VectorXd value = read(owned_[k], to).head(n);
  if (measures_[k].waits_for_first()) {
    measures_[k].normalize(problem.distance(k, value, starts_[k].head(n)), problem.size(k, from, starts_[k].head(n)));
  }
  measures_[k].record(problem.distance(k, value, olds_[k].head(n)));
}

// Leaves in olds_ the residuals, and moves every field on by the same multiple of its own.
void Staggered::relax(State& to) {
  for (std::size_t k = first_relaxed(); k < fields_.size(); ++k) olds_[k] = read(owned_[k], to) - olds_[k];
  const double omega = relaxation_factor();
  for (std::size_t k = first_relaxed(); k < fields_.size(); ++k) {
    write(owned_[k], read(owned_[k], to) + (omega - 1.0) * olds_[k], to);
  }
}

void Staggered::collect() {
  iterations_.clear();
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    iterations_.push_back(in_units(measures_[k].iteration(), fields_[k].TOL));
  }
}

double Staggered::relaxation_factor() {
  Eigen::Index size = 0;
  for (std::size_t k = first_relaxed(); k < fields_.size(); ++k) size += owned_[k].measured;
  Eigen::VectorXd residual(size);
  Eigen::Index at = 0;
  for (std::size_t k = first_relaxed(); k < fields_.size(); ++k) {
    const double unit = measures_[k].unit();
    const Eigen::Index n = owned_[k].measured;
    residual.segment(at, n) = olds_[k].head(n) / (unit > 0.0 ? unit : 1.0);
    at += n;
  }
  return relaxation_->factor(residual);
}

}  // namespace particulate::schemes
