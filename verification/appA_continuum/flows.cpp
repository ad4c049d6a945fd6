// Balance laws in flows that are known exactly: what each leaves over is rounding.

#include <cmath>
#include <numbers>
#include <string>

#include <boost/math/quadrature/gauss.hpp>

#include <harness/case.hpp>
#include <particulate/continuum/balance.hpp>
#include <particulate/continuum/equation_of_state.hpp>
#include <particulate/continuum/stress.hpp>
#include <particulate/continuum/viscosity.hpp>

#include "complex_step.hpp"

namespace verification::continuum_flows {

using namespace particulate::continuum;
using Gauss = boost::math::quadrature::gauss<double, 30>;

const Vector<double> nothing = Vector<double>::Zero();

// The largest of what each law leaves over, over the size of its terms.
struct Left {
  double mass = 0.0, momentum = 0.0, energy = 0.0;

  void rows(Rows& rows, double tolerance) const {
    const auto row = [&](const char* what, double computed) {
      rows.compare(what, {.expected = 0.0,
                          .computed = computed,
                          .tolerance = absolute(tolerance),
                          .because = "rounding, over the size of the terms"});
    };
    row("mass", mass);
    row("momentum", momentum);
    row("energy", energy);
  }
};

const Case couette{
    {.name = "couette_flow",
     .claim = "a fluid between two walls, heavy and heated by its own viscosity, keeps mass, momentum and energy",
     .equation = "D A.7",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // u = U y/h, P = P_0 - rho g y, theta = linear + (mu U^2/h^2 + q)/(2 K) y (h - y).
      const double h = 0.02, U = 3.0, rho = 900.0, g = 9.81, q = 2e3;
      const Newtonian law{.mu = 0.5, .lambda = 0.1};
      const auto velocity = [&](const Vector<Complex>& x) { return Vector<Complex>(U * x[1] / h, 0.0, 0.0); };
      const double div_h = 0.5 * U * U / (h * h) + q;  // -K theta''
      Left left;
      for (double y = 0.0; y <= h; y += 0.01 * h) {
        const Tensor<double> L = gradient(velocity, {0.3, y, -0.2});
        const Vector<double> v(U * y / h, 0.0, 0.0);
        const Tensor<Complex> D = rate_of_deformation(L).cast<Complex>();
        const auto on_plane = [&](Complex at) {
          return traction<Complex>(stress(law, 1e5 - rho * g * at, D), {0, 1, 0});
        };
        const double power = stress_power<double>(stress(law, Complex(1e5 - rho * g * y), D).real(), L);
        keep_larger(left.mass, mass_residual(rho, material_rate<double>(0.0, v, nothing), L), rho * U / h);
        const Vector<double> weight(0.0, -rho * g, 0.0), acceleration = material_rate<double>(nothing, v, L);
        keep_larger(left.momentum, momentum_residual(rho, acceleration, derivative(on_plane, y), weight).norm(),
                    rho * g);
        keep_larger(left.energy, energy_residual(rho, 0.0, power, div_h, q), div_h);
      }
      left.rows(rows, 1e-15);
    }};

const Case warm_couette{
    {.name = "couette_of_a_fluid_that_thins",
     .claim = "between walls of 300 and 400 K a fluid that thins as it warms has the known stress and velocity",
     .equation = "R A.8",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const ExponentialViscosity law{.mu_R = 2.0, .c_mu = 5.0, .theta_R = 300.0};
      const auto fluidity = [&](double y) { return 2.0 / viscosity(law, 300.0 + 100.0 * y); };
      const double half = Gauss::integrate(fluidity, 0.0, 0.5), whole = half + Gauss::integrate(fluidity, 0.5, 1.0);
      const char* because = "15 digits were given";
      rows.compare(
          "tau h/(mu_R U)",
          {.expected = 0.473834491838658, .computed = 1.0 / whole, .tolerance = absolute(2e-15), .because = because});
      rows.compare(
          "u(h/2)/U",
          {.expected = 0.352179212961142, .computed = half / whole, .tolerance = absolute(2e-15), .because = because});
    }};

const Case expansion{
    {.name = "expanding_gas",
     .claim = "a gas that expands evenly cools along P rho^-gamma, and keeps mass, momentum and energy",
     .equation = "D A.7",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // x = a X with a = 1 + t/T: no acceleration, one state everywhere.
      const double T = 0.7, gamma = 1.4, rho_0 = 1.2, theta_0 = 300.0;
      const IdealGas gas{.R = 287.0};
      const double c = gas.R / (gamma - 1.0);
      const Newtonian law{.mu = 5.0, .lambda = -10.0 / 3.0};
      const auto rho = [&](Complex t) { return rho_0 * std::pow(1.0 + t / T, -3.0); };
      const auto theta = [&](Complex t) { return theta_0 * std::pow(1.0 + t / T, -3.0 * (gamma - 1.0)); };
      Left left;
      double since_start = 0.0, along = 0.0;
      for (double t = 0.0; t < 5.0; t += 0.1) {
        const double a = 1.0 + t / T;
        const Tensor<double> F = a * Tensor<double>::Identity();
        const Tensor<double> L = velocity_gradient<double>(F, Tensor<double>::Identity() / T);
        const double rho_t = rho(t).real(), P = pressure(gas, rho_t, theta(t).real());
        const Tensor<double> sigma = stress(law, P, rate_of_deformation(L));
        keep_larger(since_start, mass_since_start(rho_t, F, rho_0), rho_0);
        keep_larger(left.mass, mass_residual(rho_t, derivative(rho, t), L), rho_t / T);
        const Vector<double> v = L * Vector<double>(3.0, 4.0, 5.0);
        const Vector<double> acceleration = material_rate<double>(-v / (T + t), v, L);
        keep_larger(left.momentum, momentum_residual(rho_t, acceleration, nothing, nothing).norm(),
                    rho_t * v.norm() / T);
        keep_larger(left.energy, energy_residual(rho_t, c * derivative(theta, t), stress_power(sigma, L), 0.0, 0.0),
                    P * L.trace());
        keep_larger(along, P * std::pow(rho_t, -gamma) / (287.0 * 1.2 * 300.0 * std::pow(1.2, -1.4)) - 1.0, 1.0);
      }
      rows.compare("mass since the start", {.expected = 0.0,
                                            .computed = since_start,
                                            .tolerance = absolute(2e-15),
                                            .because = "rounding, over the density at the start"});
      left.rows(rows, 4e-15);
      rows.compare("P rho^-gamma over what it was, less 1",
                   {.expected = 0.0, .computed = along, .tolerance = absolute(4e-15), .because = "rounding of powers"});
    }};

// Becker's shock at Pr = 3/4, of which all is known as a function of v = u/u_1. Units: rho_1 = u_1 = mu = 1.
struct Shock {
  double M, gamma = 1.4, c = 2.5;
  IdealGas gas{.R = 1.0};
  Newtonian law{};

  double behind() const { return ((gamma - 1.0) + 2.0 / (M * M)) / (gamma + 1.0); }
  // dv/dx of x = A (ln(1 - v) - v_f ln(v - v_f))/(1 - v_f), A = 8 gamma/(3 (gamma + 1)).
  template <class S>
  S slope(S v) const {
    return -(1.0 - v) * (v - behind()) * 3.0 * (gamma + 1.0) / (8.0 * gamma * v);
  }
  // gamma R theta_1 = 1/M^2; gamma c theta + v^2/2 stays.
  template <class S>
  S theta(S v) const {
    return 1.0 / (M * M * gamma * gas.R) + (1.0 - v * v) / (2.0 * gamma * c);
  }
  template <class S>
  Tensor<S> L(S v) const {
    Tensor<S> result = Tensor<S>::Zero();
    result(0, 0) = slope(v);
    return result;
  }
  template <class S>
  S pressure_at(S v) const {
    return pressure(gas, S(1.0 / v), theta(v));
  }
  template <class S>
  Tensor<S> sigma(S v) const {
    return stress(law, pressure_at(v), L(v));
  }
};

const Case becker{
    {.name = "becker_shock",
     .claim = "through a shock of which all is known, a viscous gas that conducts heat keeps mass, momentum and energy",
     .equation = "D A.8",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto check = [&](double M, double from, double to, double span) {
        const Shock shock{.M = M};
        const double K = shock.gamma * shock.c / 0.75;  // mu gamma c/Pr
        Left left;
        for (double v = shock.behind() + 0.01; v < 0.99; v += 0.01) {
          // Along x all changes by v alone.
          const double slope = shock.slope(v);
          const auto along = [&](const auto& of_v) { return slope * derivative(of_v, v); };
          const Vector<double> speed(v, 0.0, 0.0);
          const Tensor<double> L = shock.L(v);
          const auto unit = [](double x) { return Vector<double>(x, 0.0, 0.0); };
          const double rho_rate = material_rate<double>(0.0, speed, unit(along([](Complex at) { return 1.0 / at; })));
          const Vector<double> acceleration = material_rate<double>(nothing, speed, L);
          const double force = along([&](Complex at) { return shock.sigma(at)(0, 0); });
          // -K theta' = K v v'/(gamma c).
          const double div_h = along([&](Complex at) { return K * at * shock.slope(at) / (shock.gamma * shock.c); });
          const double e_rate =
              material_rate<double>(0.0, speed, unit(along([&](Complex at) { return shock.c * shock.theta(at); })));
          const double size = std::abs(slope);
          keep_larger(left.mass, mass_residual(1.0 / v, rho_rate, L), size / v);
          keep_larger(left.momentum, momentum_residual<double>(1.0 / v, acceleration, unit(force), nothing).norm(),
                      size);
          keep_larger(left.energy, energy_residual(1.0 / v, e_rate, stress_power(shock.sigma(v), L), div_h, 0.0), size);
        }
        left.rows(rows, 2e-14);
        // Its width by what the stress must be: v + P - sigma_viscous = 1 + P_1 between rest states.
        const double push = viscous_stress<double>(shock.law, Vector<double>(1.0, 0.0, 0.0).asDiagonal())(0, 0);
        const double P_1 = shock.pressure_at(1.0);
        const auto dx = [&](double v) { return push / (v - 1.0 + shock.pressure_at(v) - P_1); };
        rows.compare(
            "distance between two speeds [mu/(rho_1 u_1)]",
            {.expected = span,
             .computed = Gauss::integrate(dx, from, 0.5 * (from + to)) + Gauss::integrate(dx, 0.5 * (from + to), to),
             .tolerance = relative(2e-13),
             .because = "15 digits were given; a quadrature near a pole"});
      };
      check(1.5, 0.95, 0.6, 10.3807429854605);
      check(3.0, 0.9, 0.4, 4.58791228875445);
    }};

const Case viscous_sound{
    {.name = "viscous_sound",
     .claim = "plane waves of the known decay and frequency obey mass and momentum of a viscous fluid",
     .equation = "D A.8",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // exp(i k x - i w t), c_s = 1, nu_L = 4/3 0.01, k = 2 pi; the wave's velocity is 1.
      const Complex w(6.27767066016, -0.263189450696), i(0.0, 1.0);
      const double k = 2.0 * std::numbers::pi;
      const Barotropic fluid{.Y = 1000.0, .rho_R = 1000.0};
      const Newtonian law{.mu = 10.0, .lambda = -20.0 / 3.0};
      Tensor<Complex> L = Tensor<Complex>::Zero();
      L(0, 0) = i * k;
      const Complex rho = 1000.0 * k / w;
      const double slope = derivative([&](Complex at) { return pressure(fluid, at); }, 1000.0);
      const Tensor<Complex> sigma = stress(law, slope * rho, L);
      const Vector<Complex> acceleration(-i * w, 0.0, 0.0), force(i * k * sigma(0, 0), 0.0, 0.0);
      rows.compare("mass", {.expected = 0.0,
                            .computed = std::abs(mass_residual<Complex>(1000.0, -i * w * rho, L)) / (1000.0 * k),
                            .tolerance = absolute(1e-15),
                            .because = "rounding"});
      const Vector<Complex> left = momentum_residual<Complex>(1000.0, acceleration, force, Vector<Complex>::Zero());
      rows.compare("momentum", {.expected = 0.0,
                                .computed = std::abs(left[0]) / (1000.0 * k),
                                .tolerance = absolute(1e-12),
                                .because = "12 digits were given of decay and frequency"});
      rows.compare("speed of sound without viscosity", {.expected = std::sqrt(slope),
                                                        .computed = speed_of_sound(fluid, 1000.0),
                                                        .tolerance = relative(1e-15),
                                                        .because = "rounding"});
    }};

}  // namespace verification::continuum_flows
