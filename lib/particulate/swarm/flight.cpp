#include <particulate/swarm/flight.hpp>

#include <limits>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::swarm::detail {

namespace {

// A box around all obstacles, so that members far from them are looked at once.
void find_corners(const Obstacles& obstacles, Eigen::Vector3d& low, Eigen::Vector3d& high) {
  high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  low = -high;
  for (std::size_t k = 0; k < obstacles.centre.size(); ++k) {
    const Eigen::Vector3d radius = Eigen::Vector3d::Constant(obstacles.radius[k]);
    low = low.cwiseMin(obstacles.centre[k] - radius);
    high = high.cwiseMax(obstacles.centre[k] + radius);
  }
}

}  // namespace

Legs::Legs(const kinematics::Particles& start, const kinematics::Space& domain, const Obstacles* obstacles)
    : start_(start),
      domain_(domain),
      obstacles_(obstacles),
      low_(Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity())),
      high_(-low_) {
  kinematics::validate(start);
  if (start.size() == 0) throw std::invalid_argument("swarm: must have one member at least, got none");
  flying_.resize(static_cast<std::size_t>(start.size()));
  std::iota(flying_.begin(), flying_.end(), Eigen::Index{0});
  state_ = {.t = 0.0, .r = start.position.reshaped(), .v = start.velocity.reshaped()};
  resting_ = state_;
  if (!obstacles_) return;
  validate(*obstacles_);
  if (!kinematics::has_periods(domain_)) find_corners(*obstacles_, low_, high_);
  if (!find_lost(state_)) return;
  throw std::invalid_argument(
      fmt::format("swarm: no member may start inside an obstacle, but member {} is inside obstacle {}: place it "
                  "elsewhere",
                  found_.front().k, found_.front().obstacle));
}

bool Legs::find_lost(const schemes::State& to) {
  found_.clear();
  if (!obstacles_) return false;
  const schemes::VectorsOf place = schemes::positions(to);
  for (Eigen::Index k = 0; k < place.rows(); ++k) {
    if (!(place(k, 0) > low_[0] && place(k, 0) < high_[0] && place(k, 1) > low_[1] && place(k, 1) < high_[1])) continue;
    if (const auto obstacle = obstacle_around(*obstacles_, domain_, place.row(k))) found_.push_back({k, *obstacle});
  }
  return !found_.empty();
}

bool Legs::end_leg() {
  if (found_.empty()) return false;
  scatter(state_, resting_);
  std::vector<Eigen::Index> stay;
  std::size_t next = 0;
  for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(flying_.size()); ++k) {
    const Eigen::Index member = flying_[static_cast<std::size_t>(k)];
    if (next == found_.size() || found_[next].k != k) {
      stay.push_back(k);
      continue;
    }
    lost_.push_back({.member = member,
                     .obstacle = found_[next++].obstacle,
                     .t = state_.t,
                     .place = schemes::position(state_, k),
                     .velocity = schemes::velocity(state_, k)});
    schemes::set_velocity(resting_, member, Eigen::Vector3d::Zero());
  }
  found_.clear();
  const kinematics::Vectors r = schemes::positions(state_)(stay, Eigen::all),
                            v = schemes::velocities(state_)(stay, Eigen::all);
  state_.r = r.reshaped();
  state_.v = v.reshaped();
  for (Eigen::Index& k : stay) k = flying_[static_cast<std::size_t>(k)];
  flying_ = std::move(stay);
  return true;
}

void Legs::say_who_flew(schemes::Outcome& outcome) const {
  if (outcome.status != schemes::Status::failed || are_all()) return;
  outcome.reason += fmt::format("; its numbers count the {} members that still flew, in their order", flying_.size());
}

const schemes::State& Legs::whole(const schemes::State& flying, schemes::State& all) const {
  if (are_all()) return flying;
  all = resting_;
  scatter(flying, all);
  return all;
}

void Legs::scatter(const schemes::State& flying, schemes::State& all) const {
  all.t = flying.t;
  all.t_carry = flying.t_carry;
  const Eigen::Index N = start_.size(), n = static_cast<Eigen::Index>(flying_.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index to = axis * N + flying_[static_cast<std::size_t>(k)], from = axis * n + k;
      all.r[to] = flying.r[from];
      all.v[to] = flying.v[from];
    }
  }
}

}  // namespace particulate::swarm::detail
