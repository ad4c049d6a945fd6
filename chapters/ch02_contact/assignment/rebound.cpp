#include "rebound.hpp"

// Fill the four holes. The brief is README.md; what each function must return stands in rebound.hpp.

Eigen::Vector3d normal([[maybe_unused]] double degrees) { return Eigen::Vector3d::Zero(); }

double normal_impulse([[maybe_unused]] const Body& i, [[maybe_unused]] const Body& j,
                      [[maybe_unused]] const Eigen::Vector3d& n, [[maybe_unused]] double e) {
  return 0.0;
}

Eigen::Vector3d friction_impulse([[maybe_unused]] const Body& i, [[maybe_unused]] const Body& j,
                                 [[maybe_unused]] const Eigen::Vector3d& n, [[maybe_unused]] const Surface& surface) {
  return Eigen::Vector3d::Zero();
}

Velocities impact([[maybe_unused]] const Body& i, [[maybe_unused]] const Body& j,
                  [[maybe_unused]] const Eigen::Vector3d& n, [[maybe_unused]] const Surface& surface) {
  return {};
}
