#pragma once

#include <cstdint>
#include <vector>

#include <particulate/scattering/trace.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/thermo/cooling.hpp>

/// @file
/// Light that heats. Rays know nothing of temperatures as long as indices of refraction are constant: they are traced
/// first, and what bodies have absorbed is then a number for each.
///
/// - A **steady beam** gives each body watts: HeatedBodies::power is Traced::absorbed, and temperatures follow on their
///   own time scale.
/// - A **pulse** has crossed a cloud long before a body can cool. The rays of a beam whose `irradiance` is a fluence
///   [J/m^2] carry joules; each hit is a jump of temperature, heat_jumps(), and all of them together warmed_by().

namespace particulate::scattering {

inline constexpr double speed_of_light = 299792458.0;  ///< c [m/s]

/// Bodies that light heats and that cool, each of one temperature: a problem of first order, of as many temperatures
/// as bodies. @see schemes::FirstOrderProblem
///
/// \f[ m_i\,c_i\,\dot\theta_i = P_i - a_i \left[h_c\,(\theta_i - \theta_o)
///     + B\,\varepsilon\,(\theta_i^4 - \theta_s^4)\right] \f]
///
/// @equation{R 9.5} With thermo::heat_flux(). No body shades another from its surroundings, nor lights it.
struct HeatedBodies {
  Eigen::VectorXd capacity;      ///< m c, > 0, N [J/K]
  Eigen::VectorXd surface;       ///< a, > 0, N [m^2]
  Eigen::VectorXd power;         ///< P that each absorbs, >= 0, N [W]
  thermo::Cooling cooling = {};  ///< of all

  /// @param theta  temperatures, N [K]
  /// @param d      receives their rates, N [K/s]
  /// @return whether there are any: none of a temperature below 0 K
  bool rate(double, schemes::In theta, schemes::Out d) const;
  /// @param theta  temperatures, N [K]
  /// @param J      receives the derivatives of their rates, N x N, of which the diagonal is there [1/s]
  void sparse_jacobian(double, schemes::In theta, schemes::SparseJacobian& J) const;
  /// @return none: no temperature acts on another
  schemes::Bandwidth bandwidth() const { return {}; }
};

/// The bodies of a cloud, in the dark.
///
/// @tparam B  a Body
/// @param cloud    bodies, each as large as volume() and area() say
/// @param rho_c    heat capacity per volume, density times specific heat, > 0 [J/(m^3 K)]
/// @param cooling  constants that validate() accepts
/// @return the bodies, of zero power
/// @throws std::invalid_argument as validate() does
template <Body B>
HeatedBodies heated_bodies(const Cloud<B>& cloud, double rho_c, const thermo::Cooling& cooling = {});

/// Refuses what cannot be heated.
///
/// @param bodies  the bodies
/// @throws std::invalid_argument naming the body and the number, what must hold and what was given
void validate(const HeatedBodies& bodies);

/// Bodies of one temperature, at t = 0.
///
/// @param bodies   the bodies
/// @param theta_0  of each, > 0 [K]
/// @return a state of HeatedBodies, theta in y
/// @throws std::invalid_argument as validate() does, and for a temperature that is none
schemes::State start(const HeatedBodies& bodies, double theta_0);

/// Where each temperature ends in a steady beam. @see thermo::equilibrium_temperature()
///
/// @equation{D 9.5}
/// @param bodies  the bodies, which convection or radiation cools
/// @return temperatures, N [K]
/// @throws std::invalid_argument as validate() does, and if nothing cools
Eigen::VectorXd equilibrium_temperatures(const HeatedBodies& bodies);

/// Temperatures after a pulse, \f$ \theta_i + E_i/(m_i c_i) \f$.
///
/// @equation{R 9.5} Nothing is lost on the way.
/// @param bodies  the bodies; their power and cooling do not matter
/// @param theta   before, N [K]
/// @param energy  that each has absorbed, Traced::absorbed of rays that carry energies, >= 0, N [J]
/// @return temperatures, N [K]
/// @throws std::invalid_argument for other numbers of temperatures or energies than bodies, naming a body of which one
///         cannot be meant
Eigen::VectorXd warmed_by(const HeatedBodies& bodies, const Eigen::VectorXd& theta, const Eigen::VectorXd& energy);

/// A hit of a ray of a pulse.
struct HeatJump {
  double t;           ///< time of flight, of light in vacuum [s]
  std::int32_t body;  ///< that is warmer then
  double energy;      ///< that it has absorbed [J]
};

/// The hits of a pulse in the order of their times.
///
/// \f[ t = s/c, \qquad E = I_- - I_+ \f]
///
/// @equation{R 9.5} With s the length of the path, and what the ray carries before and after.
/// @param paths  of rays that carry energies, Traced::paths
/// @return a jump a hit; of two at the same time that of the body with the lower number is first
std::vector<HeatJump> heat_jumps(const std::vector<PathPoint>& paths);

template <Body B>
HeatedBodies heated_bodies(const Cloud<B>& cloud, double rho_c, const thermo::Cooling& cooling) {
  const auto N = static_cast<Eigen::Index>(cloud.bodies().size());
  HeatedBodies bodies{.capacity = Eigen::VectorXd(N),
                      .surface = Eigen::VectorXd(N),
                      .power = Eigen::VectorXd::Zero(N),
                      .cooling = cooling};
  for (Eigen::Index i = 0; i < N; ++i) {
    const B& body = cloud.bodies()[static_cast<std::size_t>(i)];
    bodies.capacity[i] = rho_c * volume(body);
    bodies.surface[i] = area(body);
  }
  validate(bodies);
  return bodies;
}

}  // namespace particulate::scattering
