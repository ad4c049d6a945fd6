// Orders of the monograph's schemes on a near field. RK4 and velocity Verlet have theirs in chapter 1.

#include <harness/case.hpp>
#include <harness/scheme_order.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>

namespace verification::order_near_field {

using particulate::schemes::Anderson;
using particulate::schemes::Picard;

// The family's members by their own names and orders.
template <class Mixing>
struct Trapezoidal : particulate::schemes::PhiFamily<Mixing> {
  static constexpr int order = 2;
  Trapezoidal() : particulate::schemes::PhiFamily<Mixing>(0.5) {}
};
struct Weighted : particulate::schemes::PhiFamily<Picard> {
  Weighted() : PhiFamily(0.7) {}
};

constexpr auto first_order =
    "Euler schemes agree with the motion to the first power, on a smooth force, at no multiple "
    "of the period; sweeps to rounding";
constexpr auto second_order =
    "the trapezoidal rule is symmetric, on a smooth force, at no multiple of the period; "
    "sweeps to rounding";

template <class S>
auto proof(long coarsest, const char* because) {
  return [=](Rows& rows) { compare_order<S>(rows, coarsest, because); };
}

const Case order_forward_euler{{.name = "order_forward_euler",
                                .claim = "forward Euler has order 1 on a near field, neither less nor more",
                                .equation = "M 3.3",
                                .reference = Reference::convergence},
                               proof<particulate::schemes::ForwardEuler>(30000, first_order)};
const Case order_backward_euler{{.name = "order_backward_euler",
                                 .claim = "backward Euler has order 1 on a near field, neither less nor more",
                                 .equation = "M 3.5",
                                 .reference = Reference::convergence},
                                proof<particulate::schemes::BackwardEuler>(30000, first_order)};
const Case order_backward_euler_anderson{
    {.name = "order_backward_euler_anderson",
     .claim = "backward Euler solved by Anderson's iteration has order 1 on a near field, neither less nor more",
     .equation = "M 3.5",
     .reference = Reference::convergence},
    proof<particulate::schemes::PhiFamily<Anderson>>(30000, first_order)};
const Case order_phi{{.name = "order_phi",
                      .claim = "phi = 0.7 has order 1 on a near field, neither less nor more",
                      .equation = "R 3.3",
                      .reference = Reference::convergence},
                     proof<Weighted>(20000, first_order)};
const Case order_trapezoidal{{.name = "order_trapezoidal",
                              .claim = "phi = 1/2 has order 2 on a near field, neither less nor more",
                              .equation = "R 3.3",
                              .reference = Reference::convergence},
                             proof<Trapezoidal<Picard>>(480, second_order)};
const Case order_trapezoidal_anderson{
    {.name = "order_trapezoidal_anderson",
     .claim = "phi = 1/2 solved by Anderson's iteration has order 2 on a near field, neither less nor more",
     .equation = "R 3.3",
     .reference = Reference::convergence},
    proof<Trapezoidal<Anderson>>(480, second_order)};

}  // namespace verification::order_near_field
