// Orders of Gauss and Radau IIA collocation under a near field, forces that depend on positions only.

#include <cmath>

#include <harness/case.hpp>
#include <harness/starts.hpp>

#include "collocation_orders.hpp"

namespace verification::order_collocation_near_field {

using namespace particulate;

const Eigen::Vector3d across{3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0};
constexpr double alpha2 = 0.3;

// Two unit masses that circle each other at the distance 1: omega^2 = A - B with A = 2 and B = 2 alpha2.
struct CirclingPair {
  NearFieldScene scene{pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
  double omega = std::sqrt(2.0 - 2.0 * alpha2);

  bool acceleration(double t, schemes::In r, schemes::Out a) const { return scene.acceleration(t, r, a); }
  double distance(schemes::In x, schemes::In y) const { return scene.distance(x, y); }
  schemes::State exact(double t) const {
    const Eigen::Vector3d r = std::cos(omega * t) * slanted() + std::sin(omega * t) * across;
    const Eigen::Vector3d v = omega * (std::cos(omega * t) * across - std::sin(omega * t) * slanted());
    kinematics::Vectors places(2, 3), velocities(2, 3);
    kinematics::set_vector(places, 0, -0.5 * r);
    kinematics::set_vector(places, 1, 0.5 * r);
    kinematics::set_vector(velocities, 0, -0.5 * v);
    kinematics::set_vector(velocities, 1, 0.5 * v);
    return {.t = t, .r = places.reshaped(), .v = velocities.reshaped()};
  }
};

const Case order_collocation_near_field{
    {.name = "order_collocation_near_field",
     .claim = "under a near field Gauss collocation has order 2 s and Radau IIA 2 s - 1, neither less nor more, and "
              "their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      CirclingPair pair;
      compare_collocation_orders(rows, pair,
                                 {{.t_end = 2.3, .coarsest = 60, .dense_end = 2.3, .dense_coarse = 60},
                                  {.t_end = 2.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 200},
                                  {.t_end = 20.3, .coarsest = 24, .dense_end = 2.3, .dense_coarse = 16},
                                  {.t_end = 20.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 12},
                                  {.t_end = 20.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 8},
                                  {.t_end = 20.3, .coarsest = 10, .dense_end = 4.6, .dense_coarse = 8},
                                  {.t_end = 20.3, .coarsest = 8, .dense_end = 7.9, .dense_coarse = 8},
                                  {.t_end = 2.3, .coarsest = 3000, .dense_end = 2.3, .dense_coarse = 3000},
                                  {.t_end = 2.3, .coarsest = 40, .dense_end = 2.3, .dense_coarse = 40},
                                  {.t_end = 2.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 24},
                                  {.t_end = 20.9, .coarsest = 6, .dense_end = 11.3, .dense_coarse = 8}});
    }};

}  // namespace verification::order_collocation_near_field
