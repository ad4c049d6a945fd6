#include <particulate/kinematics/energy.hpp>

#include <particulate/kinematics/momentum.hpp>

namespace particulate::kinematics {

double kinetic_energy(const ScalarsIn& mass, const VectorsIn& velocity) {
  require_one_length({mass.size(), velocity.rows()});
  return 0.5 * mass.dot(velocity.rowwise().squaredNorm());
}

KineticEnergy split_kinetic_energy(const ScalarsIn& mass, const VectorsIn& velocity) {
  const Eigen::Vector3d v_cm = centre_of_mass(mass, velocity);
  const Vectors about = velocity.rowwise() - v_cm.transpose();
  return {.bulk = 0.5 * v_cm.squaredNorm(), .relative = kinetic_energy(mass, about) / mass.sum()};
}

double power_of(const VectorsIn& force, const VectorsIn& velocity) {
  require_one_length({force.rows(), velocity.rows()});
  return force.cwiseProduct(velocity).sum();
}

double work_between(const VectorsIn& force_1, const VectorsIn& position_1, const VectorsIn& force_2,
                    const VectorsIn& position_2) {
  require_one_length({force_1.rows(), position_1.rows(), force_2.rows(), position_2.rows()});
  return 0.5 * (force_1 + force_2).cwiseProduct(position_2 - position_1).sum();
}

}  // namespace particulate::kinematics
