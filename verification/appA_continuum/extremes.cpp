// Deformations and fluids that must be borne, however extreme, and those that must be refused.

#include <cmath>
#include <string>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/continuum/equation_of_state.hpp>
#include <particulate/continuum/stress.hpp>
#include <particulate/continuum/viscosity.hpp>

namespace verification::continuum_extremes {

using namespace particulate::continuum;

Ending within(double error, double tolerance, const char* because) {
  return Ending::solved({.error = error, .tolerance = tolerance, .because = because});
}
Tensor<double> stretches(double x, double y, double z) { return Vector<double>(x, y, z).asDiagonal(); }
const Tensor<double> unit = Tensor<double>::Identity();

void solve(Rows& rows) {
  for (const double size : {1e-8, 1e8, 1e-90, 1e90}) {
    rows.must_be_solved("F = I times " + std::to_string(static_cast<int>(std::log10(size))) + " decades", [size] {
      const Tensor<double> F = size * unit, L = velocity_gradient(F, F);
      const double J = size * size * size;
      const double area = deformed_area<double>(F, {0.0, 0.0, 1.0})[2] / (size * size) - 1.0;
      return within((L - unit).norm() + std::abs(jacobian(F) / J - 1.0) + std::abs(area), 2e-15, "rounding");
    });
  }
  rows.must_be_solved("a film 1e-12 thin, sheared 1e3 times", [] {
    Tensor<double> F = stretches(1e6, 1e6, 1e-12);
    F(0, 2) = 1e-9;
    return within((velocity_gradient(F, F) - unit).norm(), 4e-13, "rounding of F F^-1, with terms of 1e3");
  });
  rows.must_be_solved("areas of what is pressed flat, J = 0", [] {
    const Tensor<double> F = stretches(2.0, 3.0, 0.0);
    return within((deformed_area<double>(F, {1.0, 1.0, 1.0}) - Vector<double>(0.0, 0.0, 6.0)).norm(), 0.0,
                  "only the plane is left");
  });
  rows.must_be_solved("a gas at 1e-300 K", [] {
    const double theta = 1e-300, expected = std::sqrt(1.4 * 287.0) * 1e-150;
    const double off = speed_of_sound(IdealGas{287.0}, 1.2, theta, 717.5) / expected - 1.0;
    return within(std::abs(off) + std::abs(pressure(IdealGas{287.0}, 1.2, theta) / 344.4e-300 - 1.0), 1e-14,
                  "rounding");
  });
  rows.must_be_solved("a gas at 0 K", [] {
    return within(pressure(IdealGas{}, 1.2, 0.0) + speed_of_sound(IdealGas{}, 1.2, 0.0, 717.5), 0.0, "nothing moves");
  });
  rows.must_be_solved("Y = 1e10, 1 % denser", [] {
    const LinearizedState law{.Y = 1e10};
    const double P = pressure(law, 1010.0, 300.0) / 1.001e8 - 1.0;
    // c_s^2 = 1e7 + 1e10 1e-7 1.001e8/(1010^2 2500).
    const double speed =
        speed_of_sound(law, 1010.0, 300.0, 2500.0) / std::sqrt(1e7 + 1.001e11 / (1010.0 * 1010.0 * 2500.0));
    return within(std::abs(P) + std::abs(speed - 1.0), 1e-13, "rounding of a density, times 100");
  });
  rows.must_be_solved("a fluid without viscosity, lambda = 0", [] {
    validate(Newtonian{.mu = 0.0, .lambda = 0.0});
    return within((stress({.mu = 0.0, .lambda = 0.0}, 5.0, stretches(1e300, 2.0, 3.0)) + 5.0 * unit).norm(), 0.0,
                  "pressure alone");
  });
  rows.must_be_solved("the viscosity of what hardly thins, at 1e5 K", [] {
    const double mu = viscosity(ExponentialViscosity{.mu_R = 1.0, .c_mu = 5.0}, 1e5);
    return within(std::abs(mu / std::exp(-4.985) - 1.0), 1e-15, "rounding");
  });
}

void refuse(Rows& rows) {
  const auto deformation = [&](const std::string& name, const Tensor<double>& F) {
    rows.must_be_refused(name, "J positive motion", [&F] {
      static_cast<void>(velocity_gradient(F, unit));
      return accepted();
    });
  };
  Tensor<double> in_one_plane;
  in_one_plane << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  deformation("the rate of what is pressed flat", stretches(2.0, 3.0, 0.0));
  deformation("the rate of what is flat to rounding", in_one_plane / 3.0);
  deformation("the rate of a mirror image", stretches(1.0, 1.0, -1.0));
  deformation("the rate of what is so small that J is 0", 1e-120 * unit);
  deformation("the rate of what is not a number", not_a_number * unit);
  const auto law = [&](const std::string& name, const char* key_words, const auto& given) {
    rows.must_be_refused(name, key_words, [&given] {
      validate(given);
      return accepted();
    });
  };
  law("negative viscosity", "mu negative -1", Newtonian{.mu = -1.0, .lambda = 1.0});
  law("lambda below -2 mu/3", "lambda -2", Newtonian{.mu = 3.0, .lambda = -2.0 - 1e-9});
  law("lambda that is not a number", "lambda nan", Newtonian{.lambda = not_a_number});
  law("Y = 0", "Y positive 0", LinearizedState{.Y = 0.0});
  law("an infinite Y", "Y finite inf", LinearizedState{.Y = infinite});
  law("an expansion that is not a number", "a_th finite nan", LinearizedState{.a_th = not_a_number});
  law("a gas constant of 0", "R positive", IdealGas{.R = 0.0});
  law("a barotropic fluid without density", "rho_R positive", Barotropic{.rho_R = 0.0});
  law("theta_R = 0 of a viscosity", "theta_R positive", ExponentialViscosity{.theta_R = 0.0});
  law("a negative constant viscosity", "mu negative", ConstantViscosity{.mu = -1e-300});
}

const Case extremes{{.name = "extremes",
                     .claim = "what is extreme is borne, and what no motion or fluid can be is refused with the reason",
                     .equation = "D A.8",
                     .reference = Reference::design},
                    [](Rows& rows) {
                      solve(rows);
                      refuse(rows);
                    }};

}  // namespace verification::continuum_extremes
