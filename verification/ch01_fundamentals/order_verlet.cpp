// Velocity Verlet has order 2.

#include <harness/case.hpp>
#include <harness/scheme_order.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::order_verlet {

const Case order_verlet{{.name = "order_verlet",
                         .claim = "velocity Verlet has order 2, neither less nor more",
                         .equation = "M 3.1",
                         .reference = Reference::convergence},
                        [](Rows& rows) {
                          compare_order<particulate::schemes::VelocityVerlet>(
                              rows, 480,
                              "a symmetric method of order 2, at no multiple of the period, where it would gain");
                        }};

}  // namespace verification::order_verlet
