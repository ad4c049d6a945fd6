#pragma once

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/schemes/state.hpp>

namespace particulate::swarm {

/// How far a swarm is from its target, on the average over members and time: an observer for fly(), of one flight.
///
/// \f[ \Pi = \frac1T \int_0^T \frac{\sum_i d_i(t)}{\sum_i d_i(0)}\,dt, \qquad d_i = \|r_t - r_i\| \f]
///
/// @equation{R 6.2} Members that are lost count at their place. By the trapezoidal rule over the steps.
class Objective {
 public:
  /// @param target  r_t [m]
  /// @param start   the members
  /// @param domain  space
  /// @throws std::invalid_argument for particles that are none, for no member, and unless some member starts away
  ///         from the target
  Objective(const Eigen::Vector3d& target, const kinematics::Particles& start, const kinematics::Space& domain = {});

  /// One step of a flight.
  ///
  /// @param to  its end, of the whole swarm
  /// @param dt  its length [s]
  /// @return true: go on
  template <class S>
  bool operator()(const schemes::State&, const schemes::State& to, double dt, const S&) {
    add(to, dt);
    return true;
  }

  /// @return the mean so far; 1 before the first step [-]
  double mean() const { return time_ > 0.0 ? sum_ / time_ : 1.0; }
  /// @return mean distance of the members at the end of the last step [m]
  double distance() const { return last_ * at_start_; }

 private:
  void add(const schemes::State& to, double dt);
  double mean_distance(const Eigen::Map<const kinematics::Vectors>& place) const;

  Eigen::Vector3d target_;
  kinematics::Space domain_;
  double at_start_;                             // mean distance [m]
  double last_ = 1.0, sum_ = 0.0, time_ = 0.0;  // distances over that at the start
};

}  // namespace particulate::swarm
