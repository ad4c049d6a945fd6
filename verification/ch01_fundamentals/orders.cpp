// The rulers have the orders that their marks are spaced by.

#include <harness/case.hpp>
#include <harness/scheme_order.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::orders {

using namespace particulate;

void prove_order_rk4(Rows& rows) {
  compare_order<schemes::RungeKutta4>(rows, 480,
                                      "four stages of order 4 on a smooth force, at no multiple of the period");
}

const Case order_rk4{{.name = "order_rk4",
                      .claim = "the classical Runge-Kutta method has order 4, neither less nor more",
                      .equation = "M 3.1",
                      .reference = Reference::convergence},
                     prove_order_rk4};

void prove_order_verlet(Rows& rows) {
  compare_order<schemes::VelocityVerlet>(
      rows, 480, "a symmetric method of order 2, at no multiple of the period, where it would gain");
}

const Case order_verlet{{.name = "order_verlet",
                         .claim = "velocity Verlet has order 2, neither less nor more",
                         .equation = "M 3.1",
                         .reference = Reference::convergence},
                        prove_order_verlet};

}  // namespace verification::orders
