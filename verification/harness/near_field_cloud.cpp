#include <harness/near_field_cloud.hpp>

#include <cmath>
#include <utility>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

namespace verification {

particulate::kinematics::Particles random_cloud(const Cloud& of, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto side = static_cast<Eigen::Index>(std::ceil(std::cbrt(static_cast<double>(of.N)) - 1e-9));
  using particulate::kinematics::Vectors;
  particulate::kinematics::Particles cloud{.position = Vectors(of.N, 3),
                                           .velocity = Vectors(of.N, 3),
                                           .mass = Eigen::VectorXd(of.N),
                                           .radius = Eigen::VectorXd(of.N)};
  for (Eigen::Index i = 0; i < of.N; ++i) {
    const Eigen::Index corner[3] = {i % side, i / side % side, i / (side * side)};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      cloud.position(i, axis) = of.spacing * (static_cast<double>(corner[axis]) + 0.25 * uniform(engine));
      cloud.velocity(i, axis) = of.speed * uniform(engine);
    }
    cloud.mass[i] = std::pow(10.0, of.decades * uniform(engine));
    cloud.radius[i] = of.spacing * (0.1 + 0.05 * uniform(engine));
  }
  return cloud;
}

NearFieldScene near_field_cloud(Eigen::Index N, std::uint64_t seed, double spacing) {
  particulate::kinematics::Particles cloud =
      random_cloud({.N = N, .spacing = spacing, .speed = 0.2, .decades = 0.0}, seed);
  return {std::move(cloud), {}, {.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 3.0}};
}

}  // namespace verification
