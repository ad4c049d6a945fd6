// Work summed along a motion is the change of kinetic energy.

#include <harness/case.hpp>

#include "sampled_motion.hpp"

namespace {

using namespace particulate;
using namespace verification;

double error_of_work(const SampledMotion& fine, std::size_t stride) {
  double work = 0.0;
  for (std::size_t k = stride; k < fine.force.size(); k += stride) {
    work +=
        kinematics::work_between(fine.force[k - stride], fine.position[k - stride], fine.force[k], fine.position[k]);
  }
  const double gained = kinematics::kinetic_energy(fine.mass, fine.velocity.back()) -
                        kinematics::kinetic_energy(fine.mass, fine.velocity.front());
  return std::abs(work - gained) / std::abs(gained);
}

const Case work_energy{
    {.name = "work_energy",
     .claim = "the work of all forces along a motion is the change of kinetic energy, summed to order 2",
     .equation = "M 1.15",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const SampledMotion fine = sampled_motion(rows.case_seed(), 8192);
      const SumErrors seen = errors_of_sums(fine, [&](std::size_t stride) { return error_of_work(fine, stride); });
      rows.order("work against T_2 - T_1",
                 {.nominal = 2.0,
                  .steps = seen.steps,
                  .errors = seen.errors,
                  .floor = 1e-13,
                  .because = "the trapezoidal rule along a smooth path; RK4's own error is below 1e-12"});
      rows.at_most("work against T_2 - T_1, 4096 pieces",
                   {.limit = 1e-5,
                    .computed = seen.errors.back(),
                    .because = "order 2 from below 1e-2 at 128 pieces: 32^2 times less"});
    }};

}  // namespace
