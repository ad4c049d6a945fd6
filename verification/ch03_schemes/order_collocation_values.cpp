// Orders of Gauss and Radau IIA collocation on a problem of first order whose rate depends on time.

#include <cmath>

#include <harness/case.hpp>

#include "collocation_orders.hpp"

namespace verification::order_collocation_values {

using namespace particulate::schemes;

// A body about an attracting centre that is driven by a turning push: y = (r, v) with
// r'' = -(1 - q) r/|r|^3 - q (cos t, sin t). The push agrees with the circle of radius 1.
struct DrivenOrbit {
  double q = 0.2;

  bool rate(double t, In y, Out dy) const {
    const double d = std::hypot(y[0], y[1]), pull = (1.0 - q) / (d * d * d);
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = -pull * y[0] - q * std::cos(t);
    dy[3] = -pull * y[1] - q * std::sin(t);
    return true;
  }
  State exact(double t) const {
    return {.t = t, .y = Eigen::Vector4d{std::cos(t), std::sin(t), -std::sin(t), std::cos(t)}};
  }
};

const Case order_collocation_values{
    {.name = "order_collocation_values",
     .claim = "on a problem of first order whose rate depends on time Gauss collocation has order 2 s and Radau IIA "
              "2 s - 1, neither less nor more, and their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      DrivenOrbit orbit;
      compare_collocation_orders(rows, orbit,
                                 {{.t_end = 2.3, .coarsest = 60, .dense_end = 2.3, .dense_coarse = 60},
                                  {.t_end = 2.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 200},
                                  {.t_end = 28.3, .coarsest = 76, .dense_end = 2.3, .dense_coarse = 16},
                                  {.t_end = 28.3, .coarsest = 36, .dense_end = 2.3, .dense_coarse = 12},
                                  {.t_end = 28.3, .coarsest = 20, .dense_end = 2.3, .dense_coarse = 8},
                                  {.t_end = 28.3, .coarsest = 15, .dense_end = 4.6, .dense_coarse = 8},
                                  {.t_end = 28.3, .coarsest = 10, .dense_end = 7.9, .dense_coarse = 8},
                                  {.t_end = 2.3, .coarsest = 3000, .dense_end = 2.3, .dense_coarse = 3000},
                                  {.t_end = 2.3, .coarsest = 40, .dense_end = 2.3, .dense_coarse = 40},
                                  {.t_end = 2.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 24},
                                  {.t_end = 28.3, .coarsest = 8, .dense_end = 11.3, .dense_coarse = 8}});
    }};

}  // namespace verification::order_collocation_values
