#include <particulate/kinematics/momentum.hpp>

#include <cmath>

#include <stdexcept>

#include <Eigen/Geometry>

namespace particulate::kinematics {

Eigen::Vector3d linear_momentum(const ScalarsIn& mass, const VectorsIn& velocity) {
  require_one_length({mass.size(), velocity.rows()});
  return velocity.transpose() * mass;
}

Eigen::Vector3d angular_momentum(const ScalarsIn& mass, const VectorsIn& position, const VectorsIn& velocity) {
  require_one_length({mass.size(), velocity.rows()});
  const Vectors momentum = mass.asDiagonal() * velocity;
  return moment(position, momentum);
}

Eigen::Vector3d moment(const VectorsIn& position, const VectorsIn& force) {
  require_one_length({position.rows(), force.rows()});
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < position.rows(); ++i) sum += vector(position, i).cross(vector(force, i));
  return sum;
}

Eigen::Vector3d centre_of_mass(const ScalarsIn& mass, const VectorsIn& of) {
  if (mass.size() == 0) throw std::invalid_argument("centre of mass: there must be at least one particle, got none");
  return linear_momentum(mass, of) / mass.sum();
}

double radius_of_gyration(const VectorsIn& position) {
  const Eigen::RowVector3d centre = position.colwise().mean();
  return std::sqrt((position.rowwise() - centre).rowwise().squaredNorm().mean());
}

Vectors impulse_between(const VectorsIn& force_1, const VectorsIn& force_2, double dt) {
  require_one_length({force_1.rows(), force_2.rows()});
  return (0.5 * dt) * (force_1 + force_2);
}

}  // namespace particulate::kinematics
