#include <particulate/swarm/objective.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::swarm {

namespace {

const kinematics::Vectors& places_of_some(const kinematics::Particles& start) {
  validate(start);
  if (start.size() == 0) throw std::invalid_argument("objective: must have one member at least, got none");
  return start.position;
}

}  // namespace

Objective::Objective(const Eigen::Vector3d& target, const kinematics::Particles& start, const kinematics::Space& domain)
    : target_(target), domain_(domain), at_start_(mean_distance({places_of_some(start).data(), start.size(), 3})) {
  if (at_start_ > 0.0 && std::isfinite(at_start_)) return;
  throw std::invalid_argument(fmt::format(
      "objective: the mean distance of the members from the target must be positive and finite at the start, as all "
      "distances are counted in it, got {} m",
      at_start_));
}

void Objective::add(const schemes::State& to, double dt) {
  const double before = last_;
  last_ = mean_distance(schemes::positions(to)) / at_start_;
  sum_ += 0.5 * dt * (before + last_);
  time_ += dt;
}

double Objective::mean_distance(const Eigen::Map<const kinematics::Vectors>& place) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < place.rows(); ++i) {
    sum += kinematics::length(separation(domain_, place.row(i), target_));
  }
  return sum / static_cast<double>(place.rows());
}

}  // namespace particulate::swarm
