// Orders of Gauss and Radau IIA collocation under a force that depends on velocities.

#include <cmath>

#include <harness/case.hpp>

#include "collocation_orders.hpp"

namespace verification::order_collocation_velocity {

using namespace particulate::schemes;

// A charge about an attracting centre in a magnetic field that decays from it: r'' = -(1 - q) r/|r|^3 + q J v/|r|^2,
// with J a quarter turn. On the unit circle both parts pull inwards, and the sum is 1.
struct ChargeInField {
  double q = 0.4;

  bool acceleration(double, In r, In v, Out a) const {
    const double d = r.norm();
    a = -(1.0 - q) / (d * d * d) * r + q / (d * d) * Eigen::Vector2d{-v[1], v[0]};
    return true;
  }
  State exact(double t) const {
    return {.t = t, .r = Eigen::Vector2d{std::cos(t), std::sin(t)}, .v = Eigen::Vector2d{-std::sin(t), std::cos(t)}};
  }
};

const Case order_collocation_velocity{
    {.name = "order_collocation_velocity",
     .claim = "under a force that depends on velocities Gauss collocation has order 2 s and Radau IIA 2 s - 1, neither "
              "less nor more, and their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      ChargeInField charge;
      compare_collocation_orders(rows, charge,
                                 {{.t_end = 2.3, .coarsest = 60, .dense_end = 2.3, .dense_coarse = 60},
                                  {.t_end = 2.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 200},
                                  {.t_end = 28.3, .coarsest = 76, .dense_end = 2.3, .dense_coarse = 16},
                                  {.t_end = 28.3, .coarsest = 36, .dense_end = 2.3, .dense_coarse = 12},
                                  {.t_end = 28.3, .coarsest = 20, .dense_end = 2.3, .dense_coarse = 8},
                                  {.t_end = 28.3, .coarsest = 15, .dense_end = 4.6, .dense_coarse = 8},
                                  {.t_end = 28.3, .coarsest = 11, .dense_end = 7.9, .dense_coarse = 8},
                                  {.t_end = 2.3, .coarsest = 3000, .dense_end = 2.3, .dense_coarse = 3000},
                                  {.t_end = 2.3, .coarsest = 40, .dense_end = 2.3, .dense_coarse = 40},
                                  {.t_end = 2.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 24},
                                  {.t_end = 28.3, .coarsest = 7, .dense_end = 11.3, .dense_coarse = 6}});
    }};

}  // namespace verification::order_collocation_velocity
