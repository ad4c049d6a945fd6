// Stress: Cauchy's tetrahedron, the torque on a cube, and what a Newtonian fluid may and may not do.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/continuum/balance.hpp>
#include <particulate/continuum/stress.hpp>

#include "complex_step.hpp"

namespace verification::continuum_stresses {

using namespace particulate::continuum;

const Case tetrahedron{
    {.name = "cauchy_tetrahedron",
     .claim = "tractions on the four faces of a tetrahedron balance, whatever the stress",
     .equation = "D A.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      double worst = 0.0;
      for (int k = 0; k < 200; ++k) {
        const Tensor<double> sigma = random_tensor(uniform);
        const Vector<double> edges = Vector<double>(0.1, 0.1, 0.1) + random_tensor(uniform).col(0).cwiseAbs();
        const Vector<double> slanted =
            0.5 * Vector<double>(-edges[0], edges[1], 0.0).cross(Vector<double>(-edges[0], 0.0, edges[2]));
        Vector<double> force = slanted.norm() * traction<double>(sigma, slanted.normalized());
        // On the plane across axis j, whose outward normal is -e_j, the stresses sigma_ij act by definition.
        for (int j = 0; j < 3; ++j) {
          const double area = 0.5 * edges[(j + 1) % 3] * edges[(j + 2) % 3];
          for (int i = 0; i < 3; ++i) force[i] -= sigma(i, j) * area;
        }
        keep_larger(worst, force.norm(), sigma.norm() * slanted.norm());
      }
      rows.compare(
          "force over stress times area",
          {.expected = 0.0, .computed = worst, .tolerance = absolute(1e-15), .because = "rounding of a sum of four"});
    }};

// Torque on a cube of edge h about its middle, by forces in the middles of its faces, which is exact for one stress.
Vector<double> torque(const Tensor<double>& sigma, double h) {
  Vector<double> sum = Vector<double>::Zero();
  for (int face = 0; face < 6; ++face) {
    const Vector<double> n = (face % 2 == 0 ? 1.0 : -1.0) * Vector<double>::Unit(face / 2);
    sum += (0.5 * h * n).cross(h * h * traction(sigma, n));
  }
  return sum;
}

const Case cube{
    {.name = "torque_on_a_cube",
     .claim = "tractions turn a small cube as what is not symmetric of the stress says, and never in a Newtonian fluid",
     .equation = "D A.6",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      double off = 0.0, fluid = 0.0;
      for (int k = 0; k < 200; ++k) {
        const double h = std::exp(10.0 * (uniform() - 0.5)), P = uniform();
        const Tensor<double> sigma = random_tensor(uniform);
        keep_larger(off, (torque(sigma, h) / (h * h * h) - angular_momentum_residual(sigma)).norm());
        const Tensor<double> viscous = stress({.mu = 2.0, .lambda = 0.5}, P, rate_of_deformation(sigma));
        keep_larger(fluid, torque(viscous, h).norm(), h * h * h);
        keep_larger(fluid, angular_momentum_residual(viscous).norm());
      }
      rows.compare(
          "torque per volume, less what is not symmetric [Pa]",
          {.expected = 0.0, .computed = off, .tolerance = absolute(2e-15), .because = "rounding of six forces"});
      rows.compare("torque per volume in a Newtonian fluid [Pa]",
                   {.expected = 0.0, .computed = fluid, .tolerance = absolute(4e-15), .because = "rounding"});
    }};

const Case isotropy{
    {.name = "newtonian_isotropy",
     .claim = "a Newtonian fluid has no directions of its own, and no stress beyond its pressure where it only turns",
     .equation = "D A.8",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      const Newtonian law{.mu = 2.0, .lambda = -0.7};
      double turned = 0.0, mean = 0.0, rigid = 0.0;
      for (int k = 0; k < 200; ++k) {
        const Tensor<double> L = random_tensor(uniform), D = rate_of_deformation(L);
        const Tensor<double> Q = rotation(std::numbers::pi * uniform());
        const Tensor<double> sigma = stress(law, 3.0, D);
        const Tensor<double> of_turned = stress<double>(law, 3.0, Q * D * Q.transpose());
        keep_larger(turned, (of_turned - Q * sigma * Q.transpose()).norm(), sigma.norm());
        // (lambda + 2 mu/3) tr D, with lambda + 2 mu/3 = 19/30.
        keep_larger(mean, sigma.trace() / 3.0 + 3.0 - 19.0 / 30.0 * L.trace());
        const Tensor<double> turning = rate_of_deformation<double>(spin(L));
        keep_larger(rigid, (stress(law, 3.0, turning) + 3.0 * Tensor<double>::Identity()).norm());
      }
      rows.compare("stress of the turned flow, less the turned stress, relative",
                   {.expected = 0.0, .computed = turned, .tolerance = absolute(4e-15), .because = "rounding"});
      rows.compare("mean normal stress, less -P + (lambda + 2/3 mu) div v [Pa]",
                   {.expected = 0.0, .computed = mean, .tolerance = absolute(4e-15), .because = "rounding"});
      rows.compare(
          "stress and pressure where a fluid turns [Pa]",
          {.expected = 0.0, .computed = rigid, .tolerance = absolute(0.0), .because = "D is 0 to the last bit"});
      const Tensor<double> extension = Vector<double>(1.0, -0.5, -0.5).asDiagonal();
      const Tensor<double> pulled = stress(law, 3.0, extension);
      rows.compare("pull of a thread over that of a shear, mu = 2: Trouton's ratio",
                   {.expected = 3.0,
                    .computed = (pulled(0, 0) - pulled(1, 1)) / 2.0,
                    .tolerance = relative(1e-15),
                    .because = "3, for any lambda and pressure"});
    }};

const Case second_law{
    {.name = "dissipation",
     .claim =
         "what viscosity takes from a flow is the power of its stress, and never negative down to lambda = -2 mu/3",
     .equation = "D A.8",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      double off = 0.0, least = 1.0, rigid = 0.0;
      for (int k = 0; k < 1000; ++k) {
        const Tensor<double> L = random_tensor(uniform), D = rate_of_deformation(L);
        const Newtonian law{.mu = 1.5, .lambda = k % 2 == 0 ? -1.0 : 4.0 * uniform() - 1.0};
        const double heat = dissipation(law, D);
        // Work of the viscous stress on the whole gradient, of which it feels the symmetric part alone.
        keep_larger(off, stress_power(viscous_stress(law, D), L) - heat);
        least = std::min(least, heat);
        keep_larger(rigid, dissipation<double>(law, rate_of_deformation<double>(spin(L))));
      }
      rows.compare("power of the viscous stress, less dissipation [W/m^3]",
                   {.expected = 0.0, .computed = off, .tolerance = absolute(4e-14), .because = "rounding of up to 50"});
      rows.at_least("least dissipation of a thousand flows [W/m^3]",
                    {.limit = 0.0, .computed = least, .because = "the second law of thermodynamics"});
      rows.compare(
          "dissipation where a fluid turns [W/m^3]",
          {.expected = 0.0, .computed = rigid, .tolerance = absolute(0.0), .because = "D is 0 to the last bit"});
      rows.compare("expansion at lambda = -2 mu/3 [W/m^3]",
                   {.expected = 0.0,
                    .computed = dissipation<double>({.mu = 1.5, .lambda = -1.0}, Tensor<double>::Identity()),
                    .tolerance = absolute(1e-15),
                    .because = "rounding of -2/3 mu"});
      // What a larger violation than rounding would do: 3 lambda + 2 mu = -0.03.
      rows.at_most("expansion at lambda = -2 mu/3 - 0.01, which is refused [W/m^3]",
                   {.limit = -0.05,
                    .computed = dissipation<double>({.mu = 1.5, .lambda = -1.01}, Tensor<double>::Identity()),
                    .because = "it would give energy: -0.09 W/m^3"});
    }};

}  // namespace verification::continuum_stresses
