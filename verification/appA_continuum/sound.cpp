// Equations of state: compression without heat, step by step, and the speed of sound along it.

#include <cmath>
#include <string>

#include <Eigen/Core>

#include <harness/case.hpp>
#include <particulate/continuum/equation_of_state.hpp>

namespace verification::continuum_sound {

using namespace particulate::continuum;

// Compression of a fluid to another density without heat or friction, rho c theta' = -P div v: at its end temperature
// and pressure, and the sum of c_s^2 d rho on the way. Runge and Kutta's classical steps.
struct Compression {
  double theta, pressure, sum;
};
template <class Law>
Compression compressed(const Law& law, double from, double to, double theta_0, double c, int steps) {
  const auto rate = [&](double rho, double theta) {
    return Eigen::Vector2d(pressure(law, rho, theta) / (rho * rho * c),
                           std::pow(speed_of_sound(law, rho, theta, c), 2));
  };
  const double h = (to - from) / steps;
  Eigen::Vector2d y(theta_0, 0.0);
  for (int k = 0; k < steps; ++k) {
    const double rho = from + k * h;
    const Eigen::Vector2d k1 = rate(rho, y[0]), k2 = rate(rho + 0.5 * h, y[0] + 0.5 * h * k1[0]),
                          k3 = rate(rho + 0.5 * h, y[0] + 0.5 * h * k2[0]), k4 = rate(rho + h, y[0] + h * k3[0]);
    y += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return {y[0], pressure(law, to, y[0]), y[1]};
}

const Case adiabats{
    {.name = "speed_of_sound",
     .claim = "along a compression without heat, pressure grows by the sum of c_s^2 d rho",
     .equation = "D A.8",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const auto check = [&](const std::string& name, const auto& law, double from, double to, double c) {
        const double start = pressure(law, from, 300.0);
        const Compression end = compressed(law, from, to, 300.0, c, 2000);
        rows.compare(name + ": sum of c_s^2 d rho [Pa]", {.expected = end.pressure - start,
                                                          .computed = end.sum,
                                                          .tolerance = relative(1e-12),
                                                          .because = "2000 steps of order four, and rounding"});
        return end;
      };
      const double c = 717.5;
      const Compression gas = check("air to 3 times its density", IdealGas{287.0}, 1.2, 3.6, c);
      rows.compare("air: pressure over what it was", {.expected = std::pow(3.0, 1.4),
                                                      .computed = gas.pressure / (1.2 * 287.0 * 300.0),
                                                      .tolerance = relative(1e-12),
                                                      .because = "Poisson's law, P rho^-gamma"});
      const LinearizedState stiff{.P_R = 1e8, .Y = 1e9, .a_th = 1e-3};
      static_cast<void>(check("a liquid that expands much, under 1000 bar", stiff, 1000.0, 1300.0, 1000.0));
      const LinearizedState soft{.Y = 1e5};
      static_cast<void>(check("a soft fluid, Y = 1e5", soft, 1000.0, 1100.0, 2500.0));
      // Without expansion c (theta - theta_0) = (P_R - Y) (1/rho_0 - 1/rho) + Y/rho_R ln(rho/rho_0).
      const LinearizedState inert{.P_R = 1e8, .Y = 1e9, .a_th = 0.0};
      const Compression end = check("a liquid that does not expand", inert, 1000.0, 1300.0, 1000.0);
      const double warmed = (-9e8 * (1.0 / 1000.0 - 1.0 / 1300.0) + 1e6 * std::log(1.3)) / 1000.0;
      rows.compare("a liquid that does not expand: warmed by [K]", {.expected = warmed,
                                                                    .computed = end.theta - 300.0,
                                                                    .tolerance = relative(1e-11),
                                                                    .because = "rounding of 300 K in 2000 steps"});
    }};

const Case standard{{.name = "standard_atmosphere",
                     .claim = "air at sea level has the pressure and the speed of sound of the standard atmosphere",
                     .equation = "D A.8",
                     .reference = Reference::published},
                    [](Rows& rows) {
                      // ICAO, Manual of the Standard Atmosphere (Doc 7488): 288.15 K, 1.225 kg/m^3, R = 287.05287,
                      // kappa = 1.4.
                      const IdealGas air;
                      const double c = air.R / 0.4;
                      rows.compare("pressure [Pa]", {.expected = 101325.0,
                                                     .computed = pressure(air, 1.225, 288.15),
                                                     .tolerance = absolute(0.5),
                                                     .because = "1.225 is rounded to six digits at best"});
                      rows.compare("speed of sound [m/s]", {.expected = 340.294,
                                                            .computed = speed_of_sound(air, 1.225, 288.15, c),
                                                            .tolerance = absolute(5e-4),
                                                            .because = "six digits were given"});
                    }};

}  // namespace verification::continuum_sound
