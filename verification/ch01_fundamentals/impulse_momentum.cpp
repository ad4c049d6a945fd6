// The impulse on each particle, summed in time, is the change of its momentum.

#include <harness/case.hpp>

#include "sampled_motion.hpp"

namespace verification::impulse_momentum {

using namespace particulate;

double error_of_impulse(const SampledMotion& fine, std::size_t stride) {
  const double dt = fine.t_end * static_cast<double>(stride) / static_cast<double>(fine.force.size() - 1);
  kinematics::Vectors impulse = kinematics::Vectors::Zero(fine.mass.size(), 3);
  for (std::size_t k = stride; k < fine.force.size(); k += stride) {
    impulse += kinematics::impulse_between(fine.force[k - stride], fine.force[k], dt);
  }
  const kinematics::Vectors gained = fine.mass.asDiagonal() * (fine.velocity.back() - fine.velocity.front());
  return (impulse - gained).norm() / gained.norm();
}

const Case impulse_momentum{
    {.name = "impulse_momentum",
     .claim = "the impulse of the forces on each particle is the change of its momentum, summed to order 2",
     .equation = "M 1.38",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const SampledMotion fine = sampled_motion(smooth, 8192);
      const SumErrors seen = errors_of_sums(fine, [&](std::size_t stride) { return error_of_impulse(fine, stride); });
      rows.order("impulses against m (v_2 - v_1)",
                 {.nominal = 2.0,
                  .steps = seen.steps,
                  .errors = seen.errors,
                  .floor = 1e-13,
                  .because = "the trapezoidal rule in time; RK4's own error is below 1e-12"});
      rows.at_most("impulses against m (v_2 - v_1), 4096 pieces",
                   {.limit = 1e-5,
                    .computed = seen.errors.back(),
                    .because = "order 2 from below 1e-2 at 128 pieces: 32^2 times less"});
    }};

}  // namespace verification::impulse_momentum
