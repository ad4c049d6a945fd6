#include "objective.hpp"

// Fill the hole. The brief is README.md; what the function must do stands in objective.hpp.

double objective([[maybe_unused]] const Flight& flight, [[maybe_unused]] const Eigen::Vector3d& target,
                 [[maybe_unused]] double penalty) {
  return 0.0;
}
