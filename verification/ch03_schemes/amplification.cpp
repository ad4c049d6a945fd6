// What one step makes of drag and of a spring, against the factors that theory gives.

#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "linear_problems.hpp"

namespace verification::amplification {

using namespace particulate::schemes;

// A power of two, so that the times of a run are exact and every step is the same to the last bit.
constexpr double dt = 1.0 / 64.0;

template <class S>
State after(S scheme, const Problem& problem, State state, long steps) {
  FixedStep control{.step = dt};
  require_reached(integrate(problem, state, state.t + static_cast<double>(steps) * dt, scheme, control));
  return state;
}

// Mass 4 and speed 3: neither drops out by being one. State and motions go through different code.
template <class S>
void compare_drag(Rows& rows, const std::string& method, const S& scheme, const std::function<double(double)>& factor) {
  for (const double z : {0.01, 0.1, 0.5, 0.9}) {
    const Drag drag{.c = 4.0 * z / dt, .m = 4.0};
    const DragRate rate{.c = drag.c, .m = drag.m};
    const Comparison expected{.expected = factor(z),
                              .tolerance = relative(32.0 * eps / (1.0 - z)),
                              .because =
                                  "one step; sweeps end within a rounding of each other, 1/(1 - c Dt/m) from "
                                  "their limit"};
    const auto compare = [&](const char* form, double v) {
      Comparison row = expected;
      row.computed = v / 3.0;
      rows.compare(fmt::format("{}, c Dt/m = {}, {}", method, z, form), row);
    };
    compare("first order", after(scheme, rate, State{.t = 0.0, .y = Eigen::VectorXd::Constant(1, 3.0)}, 1).y[0]);
    compare("second order", after(scheme, drag, motion(0.0, 3.0), 1).v[0]);
  }
}

// Forward Euler decays below 2 m/c and grows above.
void compare_limit(Rows& rows) {
  constexpr long steps = 10000;
  for (const double z : {2.0 - 2e-3, 2.0 + 2e-3}) {
    const DragRate drag{.c = z / dt, .m = 1.0};
    const double v = after(ForwardEuler{}, drag, State{.t = 0.0, .y = Eigen::VectorXd::Ones(1)}, steps).y[0];
    rows.compare(fmt::format("ln |v| after {} steps of forward Euler, Dt = {} m/c", steps, z),
                 {.expected = static_cast<double>(steps) * std::log(std::abs(1.0 - z)),
                  .computed = std::log(std::abs(v)),
                  .tolerance = absolute(static_cast<double>(steps) * 3.0 * eps),
                  .because = "three roundings a step"});
  }
}

const Case amplification_drag{
    {.name = "amplification_drag",
     .claim = "on m v' = -c v each scheme has its own factor, and forward Euler is stable exactly for Dt < 2 m/c",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_drag(rows, "forward Euler", ForwardEuler{}, [](double z) { return 1.0 - z; });
      compare_drag(rows, "backward Euler", BackwardEuler{}, [](double z) { return 1.0 / (1.0 + z); });
      compare_drag(rows, "phi = 1/2", BackwardEuler(0.5), [](double z) { return (1.0 - z / 2.0) / (1.0 + z / 2.0); });
      compare_drag(rows, "phi = 0.7", BackwardEuler(0.7), [](double z) { return (1.0 - 0.3 * z) / (1.0 + 0.7 * z); });
      compare_drag(rows, "RK4", RungeKutta4{},
                   [](double z) { return 1.0 - z + z * z / 2.0 - z * z * z / 6.0 + z * z * z * z / 24.0; });
      compare_limit(rows);
    }};

// The energy's factor of one step, from energies many steps apart.
template <class S>
void compare_energy(Rows& rows, const std::string& method, const S& scheme,
                    const std::function<double(double)>& factor) {
  constexpr long steps = 256;
  for (const double x : {0.01, 0.3, 0.9}) {
    const State start = motion(0.6, 0.8 * x / dt);
    const Oscillators spring = oscillator(x / dt);
    const State end = after(scheme, spring, start, steps);
    rows.compare(fmt::format("ln of the energy's growth in {} steps, {}, omega Dt = {}", steps, method, x),
                 {.expected = static_cast<double>(steps) * std::log(factor(x)),
                  .computed = std::log(energy(x / dt, end) / energy(x / dt, start)),
                  .tolerance = absolute(static_cast<double>(steps) * 8.0 * eps / (1.0 - x * x)),
                  .because = "a few roundings a step; sweeps end within a rounding of each other, 1/(1 - (omega Dt)^2) "
                             "from their limit"});
  }
}

// Not the energy, but an ellipse close by is what Verlet keeps: v^2 + omega^2 (1 - (omega Dt)^2/4) r^2.
void compare_verlet(Rows& rows) {
  constexpr long steps = 10000;
  for (const double x : {0.01, 0.3, 0.9, 1.9}) {
    const double omega = x / dt, flattened = omega * std::sqrt(1.0 - x * x / 4.0);
    const State start = motion(0.6, 0.8 * omega);
    const Oscillators spring = oscillator(omega);
    const State end = after(VelocityVerlet{}, spring, start, steps);
    rows.compare(fmt::format("ln of the growth of Verlet's ellipse in {} steps, omega Dt = {}", steps, x),
                 {.expected = 0.0,
                  .computed = std::log(energy(flattened, end) / energy(flattened, start)),
                  .tolerance = absolute(static_cast<double>(steps) * 4.0 * eps / (1.0 - x * x / 4.0)),
                  .because = "a few roundings a step, the more as the ellipse is flat"});
  }
}

const Case amplification_spring{
    {.name = "amplification_spring",
     .claim = "on a spring forward Euler gains energy and backward Euler loses it by their own factors in every step; "
              "phi = 1/2 keeps it, and Verlet keeps an ellipse close to it",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_energy(rows, "forward Euler", ForwardEuler{}, [](double x) { return 1.0 + x * x; });
      compare_energy(rows, "backward Euler", BackwardEuler{}, [](double x) { return 1.0 / (1.0 + x * x); });
      compare_energy(rows, "phi = 1/2", BackwardEuler(0.5), [](double) { return 1.0; });
      compare_energy(rows, "phi = 0.7", BackwardEuler(0.7),
                     [](double x) { return (1.0 + 0.09 * x * x) / (1.0 + 0.49 * x * x); });
      compare_energy(rows, "RK4", RungeKutta4{},
                     [](double x) { return 1.0 - std::pow(x, 6) / 72.0 + std::pow(x, 8) / 576.0; });
      compare_verlet(rows);
    }};

}  // namespace verification::amplification
