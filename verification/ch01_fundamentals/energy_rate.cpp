// At one instant the kinetic energy changes by the power of the forces, the angular momentum by their moment.

#include <cmath>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "differences.hpp"
#include "fixed_centre.hpp"

namespace verification::energy_rate {

using namespace particulate;

constexpr double h = 0.01;

// What a function of the state does in time at the middle one of nine states, h apart.
template <class F>
double rate_at_middle(const std::vector<schemes::State>& states, const F& of) {
  return slope_at_zero([&](double t) { return of(states[static_cast<std::size_t>(4 + std::lround(t / h))]); }, h);
}

// Sums over particles written out, so that a mistake in the library's own sums does not meet itself.
struct Sums {
  double energy = 0.0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), about_origin = Eigen::Vector3d::Zero();
};

Sums sums_of(const Eigen::VectorXd& mass, const schemes::State& at) {
  const Eigen::Index N = mass.size();
  Sums sums;
  for (Eigen::Index i = 0; i < N; ++i) {
    const double m = mass[i], x = at.r[i], y = at.r[N + i], z = at.r[2 * N + i];
    const double u = at.v[i], v = at.v[N + i], w = at.v[2 * N + i];
    sums.energy += 0.5 * m * (u * u + v * v + w * w);
    sums.momentum += m * Eigen::Vector3d{u, v, w};
    sums.about_origin += m * Eigen::Vector3d{y * w - z * v, z * u - x * w, x * v - y * u};
  }
  return sums;
}

const Case energy_rate{
    {.name = "energy_rate",
     .claim = "dT/dt = sum Psi . v, dG/dt = sum Psi and dH/dt = sum r x Psi at one instant",
     .equation = "M 1.16",
     .reference = Reference::identity},
    [](Rows& rows) {
      scenes::Scene scene(
          random_cloud({.N = 20}, rows.case_seed()), kinematics::Space{},
          laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25},
          FixedCentre{.place{0.4, 2.0, -1.0}, .law{.alpha1 = 2.0, .alpha2 = 0.1, .beta1 = 0.5, .beta2 = 1.5}});
      constexpr long fine = 20;
      const std::vector<schemes::State> states =
          path<schemes::RungeKutta4>(scene, scenes::start(scene), 8.0 * h, 8 * fine);
      std::vector<schemes::State> nine;
      for (std::size_t k = 0; k <= 8; ++k) nine.push_back(states[k * fine]);

      const Eigen::VectorXd& mass = scene.particles().mass;
      const schemes::State& middle = nine[4];
      Eigen::VectorXd flat(middle.r.size());
      if (!scene.total_force(middle, flat)) throw std::runtime_error("the cloud has no forces");
      const kinematics::Vectors force = rows_of(flat), r = rows_of(middle.r), v = rows_of(middle.v);

      const Sums written_out = sums_of(mass, middle);
      const auto distance_from = [](const Eigen::Vector3d& computed, const Eigen::Vector3d& expected) {
        return (computed - expected).norm() / expected.norm();
      };
      const char* const summed = "sums over 20 particles rounded to eps/2 each";
      rows.compare("T [J]", {.expected = written_out.energy,
                             .computed = kinematics::kinetic_energy(mass, v),
                             .tolerance = relative(5e-15),
                             .because = summed});
      rows.at_most("error of G", {.limit = 5e-14,
                                  .computed = distance_from(kinematics::linear_momentum(mass, v), written_out.momentum),
                                  .because = summed});
      rows.at_most("error of H_o",
                   {.limit = 5e-14,
                    .computed = distance_from(kinematics::angular_momentum(mass, r, v), written_out.about_origin),
                    .because = summed});

      const char* const because =
          "sums near 10 rounded to 1e-16 carry 2e-13 in differences over h = 0.01; truncation h^8 and "
          "RK4's (h/20)^4 lie below";
      rows.compare("dT/dt [W]",
                   {.expected = rate_at_middle(nine, [&](const auto& at) { return sums_of(mass, at).energy; }),
                    .computed = kinematics::power_of(force, v),
                    .tolerance = relative(2e-12),
                    .because = because});
      const Eigen::Vector3d dG = force.colwise().sum().transpose(), dH = kinematics::moment(r, force);
      for (int axis = 0; axis < 3; ++axis) {
        const std::string name(1, "xyz"[axis]);
        rows.compare(
            "dG_" + name + "/dt [N]",
            {.expected = rate_at_middle(nine, [&](const auto& at) { return sums_of(mass, at).momentum[axis]; }),
             .computed = dG[axis],
             .tolerance = absolute(1e-12 * dG.norm()),
             .because = because});
        rows.compare(
            "dH_" + name + "/dt [N m]",
            {.expected = rate_at_middle(nine, [&](const auto& at) { return sums_of(mass, at).about_origin[axis]; }),
             .computed = dH[axis],
             .tolerance = absolute(1e-12 * dH.norm()),
             .because = because});
      }
      rows.at_least("power [W]", {.limit = 1e-2,
                                  .computed = std::abs(kinematics::power_of(force, v)),
                                  .because = "else nothing was compared"});
    }};

}  // namespace verification::energy_rate
