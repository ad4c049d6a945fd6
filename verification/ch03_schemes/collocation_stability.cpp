// What one step of collocation makes of linear problems, against the Pade approximations that it should be.

#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <Eigen/Core>

#include <harness/case.hpp>
#include <harness/linear_algebra.hpp>
#include <particulate/schemes/collocation.hpp>

#include "linear_problems.hpp"
#include "pade.hpp"

namespace verification::collocation_stability {

using namespace particulate::schemes;
using Complex = std::complex<double>;

// A power of two, so that lambda dt is what it should be to the last bit.
constexpr double dt = 1.0 / 64.0;

// y' = lambda y in the plane of complex numbers.
struct Turning {
  Complex lambda;

  bool rate(double, In y, Out dy) const {
    dy[0] = lambda.real() * y[0] - lambda.imag() * y[1];
    dy[1] = lambda.imag() * y[0] + lambda.real() * y[1];
    return true;
  }
  void jacobian(double, In, Eigen::MatrixXd& J) const {
    J.resize(2, 2);
    J << lambda.real(), -lambda.imag(), lambda.imag(), lambda.real();
  }
};

// To rounding, by hand.
template <class S>
Complex one_step(S scheme, const Turning& problem, const State& from) {
  State to = from;
  if (!scheme.predict(problem, from, dt, to)) throw std::runtime_error("a linear problem has a value everywhere");
  Iteration it;
  do { it = scheme.sweep(problem, from, dt, to); } while (it.evaluated && !at_rounding(it) && it.K < 100);
  if (!at_rounding(it)) throw std::runtime_error("Newton ought to solve a linear problem");
  return {to.y[0], to.y[1]};
}

// From y = 1 + 0 i.
template <class Nodes>
Complex measured(Complex z) {
  const Turning problem{.lambda = z / dt};
  const State from{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.0}};
  return one_step(Collocation<Nodes, Newton<>>(), problem, from);
}

// The end of a step is 1 + sum_j b_j h k_j, where h k solves (I - z A) h k = z: what rounding leaves of the sum.
template <class Nodes>
double rounding(Complex z) {
  const CollocationTable of = collocation_table(Nodes::nodes());
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(Nodes::stages, Nodes::stages) - z * of.A;
  const Eigen::VectorXcd terms =
      of.b.cast<Complex>().cwiseProduct(solve(system, Eigen::VectorXcd::Constant(Nodes::stages, z)));
  return eps * (1.0 + terms.cwiseAbs().sum());
}

template <class Nodes>
void compare_decay(Rows& rows, const std::string& method) {
  constexpr int s = Nodes::stages, numerator = Nodes::order - s;
  const std::string roundings = "the rounding of 1 + sum b_j h k_j, sixteen times: stages end within some roundings";
  for (const Complex z : {Complex(-0.5, 0.0), Complex(-3.0, 4.0), Complex(2.0, -1.0), Complex(0.0, 0.75),
                          Complex(0.0, -20.0), Complex(-1e3, 1e3), Complex(-1e6, 0.0)}) {
    rows.at_most(
        fmt::format("{}, distance from the Pade approximation, lambda dt = {} + {} i", method, z.real(), z.imag()),
        {.limit = 16.0 * rounding<Nodes>(z),
         .computed = std::abs(measured<Nodes>(z) - pade(numerator, s, z)),
         .because = roundings});
  }
  const bool symmetric = numerator == s;
  for (const double y : {0.1, 1.0, 10.0, 1e4}) {
    const double size = std::abs(measured<Nodes>({0.0, y}));
    const std::string what = fmt::format("{}, |R|, lambda dt = {} i", method, y);
    if (symmetric) {
      rows.compare(what, {.expected = 1.0,
                          .computed = size,
                          .tolerance = absolute(16.0 * rounding<Nodes>({0.0, y})),
                          .because = roundings});
    } else {
      rows.at_most(what, {.limit = 1.0 + 16.0 * rounding<Nodes>({0.0, y}), .computed = size, .because = roundings});
    }
  }
  // The leading terms of numerator and denominator: (-1)^s for Gauss, (-1)^s s/z for Radau.
  const double limit = (s % 2 == 0 ? 1.0 : -1.0) * (symmetric ? 1.0 : -s / 1e6);
  rows.compare(fmt::format("{}, R far to the left, lambda dt = -1e6", method),
               {.expected = limit,
                .computed = measured<Nodes>(-1e6).real(),
                .tolerance = absolute((symmetric ? 4.0 * s * (s + 1) / 1e6 : 4.0 * s * s * s / 1e12) +
                                      16.0 * rounding<Nodes>(-1e6)),
                .because = "the next term is smaller by about s^2/|lambda dt|"});
}

const Case collocation_stability{
    {.name = "collocation_stability",
     .claim =
         "on y' = lambda y Gauss makes of a step the diagonal Pade approximation of exp(lambda dt), with |R| = 1 on "
         "the imaginary axis, and Radau IIA the one below it, which vanishes far to the left",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_decay<Gauss<1>>(rows, "Gauss 1");
      compare_decay<Gauss<2>>(rows, "Gauss 2");
      compare_decay<Gauss<3>>(rows, "Gauss 3");
      compare_decay<Gauss<4>>(rows, "Gauss 4");
      compare_decay<Gauss<5>>(rows, "Gauss 5");
      compare_decay<Gauss<6>>(rows, "Gauss 6");
      compare_decay<Gauss<7>>(rows, "Gauss 7");
      compare_decay<Gauss<8>>(rows, "Gauss 8");
      compare_decay<Radau<1>>(rows, "Radau 1");
      compare_decay<Radau<2>>(rows, "Radau 2");
      compare_decay<Radau<3>>(rows, "Radau 3");
      compare_decay<Radau<5>>(rows, "Radau 5");
    }};

}  // namespace verification::collocation_stability
