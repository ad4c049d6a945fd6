// The same flow in other units, later, and seen by somebody who moves.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification::fluid_frames {

using namespace particulate;
using namespace particulate::fluid;

constexpr double pi = std::numbers::pi;

// A gas in a box with walls of every kind, in a box that is `size` as large; its speeds are the same, its times and
// coefficients `size` as large. After a while.
GasFlow<2> boxed(double size) {
  const Fluid<continuum::IdealGas> gas{
      .state = {.R = 1.0}, .viscosity = {.mu = 0.02 * size}, .lambda_over_mu = -0.3, .c = 2.5, .K = 0.05 * size};
  return GasFlow<2>({.cells = {9, 12}, .lengths = Vector<2>(0.8, 1.0) * size, .corner = Vector<2>(-0.3, 0.2) * size},
                    gas,
                    {Wall<2>{.theta = 1.1}, Wall<2>{.slips = true}, Wall<2>{},
                     Wall<2>{.velocity = Vector<2>(0.4, 0.0), .theta = 0.9}});
}
Eigen::VectorXd stirred(double size, double from) {
  const GasFlow<2> flow = boxed(size);
  schemes::State state = flow.start([&](const Vector<2>& x) {
    const double X = pi * (x[0] / size + 0.3) / 0.8, Y = pi * (x[1] / size - 0.2);
    return Local<2>{.rho = 1.0 + 0.1 * std::cos(X),
                    .v = Vector<2>(0.3 * std::sin(X) * std::cos(Y), 0.2 * std::sin(Y)),
                    .theta = 1.0 + 0.1 * std::cos(Y)};
  });
  state.t = from;
  advance<schemes::RungeKutta4>(flow, state, from + 0.5 * size, 64);
  return state.y;
}

const Case units{
    {.name = "units",
     .claim = "a flow is the same in a box of a micrometre or a thousand kilometres, and after thirty years",
     .equation = "D 8.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const Eigen::VectorXd here = stirred(1.0, 0.0);
      const auto row = [&](const char* what, const Eigen::VectorXd& there, double tolerance, const char* because) {
        rows.compare(what, {.expected = 0.0,
                            .computed = (there - here).lpNorm<Eigen::Infinity>() / here.lpNorm<Eigen::Infinity>(),
                            .tolerance = absolute(tolerance),
                            .because = because});
      };
      row("1e-6 m", stirred(1e-6, 0.0), 1e-13, "rounding, in 64 steps");
      row("1e6 m", stirred(1e6, 0.0), 1e-13, "rounding, in 64 steps");
      row("2^-20 m", stirred(0x1p-20, 0.0), 0.0, "powers of two round nothing");
      row("2^20 m", stirred(0x1p20, 0.0), 0.0, "powers of two round nothing");
      row("from t = 2^30 s", stirred(1.0, 0x1p30), 0.0, "its laws do not know the time, and its steps are exact");
    }};

// A periodic gas at t = 0.5, seen from a frame in which it drifts by (2, -4): by (1, -2) boxes.
Eigen::VectorXd drifted(const Vector<2>& drift, Eigen::Index n) {
  const Fluid<continuum::IdealGas> gas{.state = {.R = 1.0}, .viscosity = {.mu = 0.02}, .c = 2.5, .K = 0.05};
  const GasFlow<2> flow({.cells = {n, n}}, gas, {});
  schemes::State state = flow.start([&](const Vector<2>& x) {
    const double X = 2.0 * pi * x[0], Y = 2.0 * pi * x[1];
    return Local<2>{.rho = 1.0 + 0.1 * std::sin(X) * std::cos(Y),
                    .v = drift + 0.2 * Vector<2>(std::sin(X) * std::cos(Y), std::cos(X + Y)),
                    .theta = 1.0 + 0.1 * std::cos(X)};
  });
  advance<schemes::RungeKutta4>(flow, state, 0.5, 5 * n);
  Eigen::VectorXd seen(4 * n * n);
  for (Eigen::Index cell = 0; cell < n * n; ++cell) {
    const Local<2> there = flow.local(state, cell);
    seen.segment<4>(4 * cell) << there.rho, there.v - drift, there.theta;
  }
  return seen;
}

const Case galilean{{.name = "drifting_frame",
                     .claim = "what a drift adds to a flow falls with the square of the cells",
                     .equation = "D 8.2",
                     .reference = Reference::identity},
                    [](Rows& rows) {
                      std::vector<double> steps;
                      std::array<std::vector<double>, 4> errors;
                      for (const Eigen::Index n : {24, 30, 38, 48, 60}) {
                        const Eigen::VectorXd off = drifted({2.0, -4.0}, n) - drifted({0.0, 0.0}, n);
                        steps.push_back(1.0 / static_cast<double>(n));
                        for (Eigen::Index f = 0; f < 4; ++f) {
                          const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<4>> field(off.data() + f,
                                                                                                  n * n);
                          errors[static_cast<std::size_t>(f)].push_back(field.norm() / static_cast<double>(n));
                        }
                      }
                      const std::array names{"density", "velocity in x", "velocity in y", "temperature"};
                      for (std::size_t f = 0; f < 4; ++f) {
                        rows.order(names[f], {.nominal = 2.0,
                                              .steps = steps,
                                              .errors = errors[f],
                                              .floor = 1e-13,
                                              .because = "central differences: the flow itself knows no rest"});
                      }
                    }};

}  // namespace verification::fluid_frames
