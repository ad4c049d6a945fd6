// The ruler has the order that its marks are spaced by.

#include <harness/case.hpp>
#include <harness/scheme_order.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification::order_rk4 {

const Case order_rk4{{.name = "order_rk4",
                      .claim = "the classical Runge-Kutta method has order 4, neither less nor more",
                      .equation = "M 3.1",
                      .reference = Reference::convergence},
                     [](Rows& rows) {
                       compare_order<particulate::schemes::RungeKutta4>(
                           rows, 480, "four stages of order 4 on a smooth force, at no multiple of the period");
                     }};

}  // namespace verification::order_rk4
