// Work summed along a motion is the change of kinetic energy.

#include <harness/case.hpp>

#include "sampled_motion.hpp"

namespace verification::work_energy {

using namespace particulate;

// Particle by particle, because the errors of many could cancel in their sum.
double error_of_work(const SampledMotion& fine, std::size_t stride) {
  const Eigen::Index N = fine.mass.size();
  Eigen::VectorXd error(N), gained(N);
  for (Eigen::Index i = 0; i < N; ++i) {
    double work = 0.0;
    for (std::size_t k = stride; k < fine.force.size(); k += stride) {
      work += kinematics::work_between(fine.force[k - stride].row(i), fine.position[k - stride].row(i),
                                       fine.force[k].row(i), fine.position[k].row(i));
    }
    const Eigen::VectorXd mass = fine.mass.segment(i, 1);
    gained[i] = kinematics::kinetic_energy(mass, fine.velocity.back().row(i)) -
                kinematics::kinetic_energy(mass, fine.velocity.front().row(i));
    error[i] = work - gained[i];
  }
  return error.norm() / gained.norm();
}

// All particles at once, against the sum of what they gain one by one.
double difference_of_sum(const SampledMotion& fine) {
  double at_once = 0.0, one_by_one = 0.0, size = 0.0;
  for (std::size_t k = 1; k < fine.force.size(); ++k) {
    at_once += kinematics::work_between(fine.force[k - 1], fine.position[k - 1], fine.force[k], fine.position[k]);
    for (Eigen::Index i = 0; i < fine.mass.size(); ++i) {
      const double work = kinematics::work_between(fine.force[k - 1].row(i), fine.position[k - 1].row(i),
                                                   fine.force[k].row(i), fine.position[k].row(i));
      one_by_one += work;
      size += std::abs(work);
    }
  }
  return std::abs(at_once - one_by_one) / size;
}

const Case work_energy{
    {.name = "work_energy",
     .claim =
         "the work of all forces on a particle along its motion is the change of its kinetic energy, summed to order 2",
     .equation = "M 1.15",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const SampledMotion fine = sampled_motion(smooth, 8192);
      const SumErrors seen = errors_of_sums(fine, [&](std::size_t stride) { return error_of_work(fine, stride); });
      rows.order("work on each particle against its T_2 - T_1",
                 {.nominal = 2.0,
                  .steps = seen.steps,
                  .errors = seen.errors,
                  .floor = 1e-13,
                  .because = "the trapezoidal rule along a smooth path; RK4's own error is below 1e-12"});
      rows.at_most("work on each particle against its T_2 - T_1, 4096 pieces",
                   {.limit = 1e-5,
                    .computed = seen.errors.back(),
                    .because = "order 2 from below 1e-2 at 128 pieces: 32^2 times less"});
      rows.at_most("work on all at once against one by one",
                   {.limit = 1e-13,
                    .computed = difference_of_sum(fine),
                    .because = "8192 times 20 terms in another order, each rounded to 1e-16"});
    }};

}  // namespace verification::work_energy
