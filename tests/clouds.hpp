#pragma once

#include <cmath>
#include <cstdint>

#include <particulate/kinematics/particles.hpp>

namespace tests {

/// Evenly distributed numbers, the same everywhere.
class Uniform {
 public:
  /// @param seed  another one, other numbers
  explicit Uniform(std::uint64_t seed) : state_(seed) {}
  /// @return the next, in [0, 1)
  double operator()() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// Particles of 1 kg at random in a box, overlapping or not, with velocities within +-1 m/s.
///
/// @param N         how many
/// @param box       its lengths, from the origin [m]
/// @param smallest  radius [m]
/// @param largest   radius; in between evenly in the logarithm [m]
/// @param seed      of the numbers
inline particulate::kinematics::Particles random_cloud(Eigen::Index N, const Eigen::Vector3d& box, double smallest,
                                                       double largest, std::uint64_t seed = 1) {
  Uniform uniform(seed);
  particulate::kinematics::Particles cloud{.position = particulate::kinematics::Vectors(N, 3),
                                           .velocity = particulate::kinematics::Vectors(N, 3),
                                           .mass = Eigen::VectorXd::Ones(N),
                                           .radius = Eigen::VectorXd(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      cloud.position(i, k) = box[k] * uniform();
      cloud.velocity(i, k) = 2.0 * uniform() - 1.0;
    }
    cloud.radius[i] = smallest * std::pow(largest / smallest, uniform());
  }
  return cloud;
}

}  // namespace tests
