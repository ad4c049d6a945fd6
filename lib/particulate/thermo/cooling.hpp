#pragma once

#include <numbers>

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::thermo {

inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< B [W/(m^2 K^4)]

/// Surface of a sphere.
///
/// @equation{R 7.4.2}
/// @param b  radius [m]
/// @return \f$ a_s = 4\pi b^2 \f$ [m^2]
inline double surface(double b) { return 4.0 * std::numbers::pi * b * b; }

/// Heat that a sphere gives to its surroundings, Stage II: convection and radiation.
///
/// \f[ m\,c\,\dot\theta = -h_c\, a_s\, (\theta - \theta_o) - B\,\varepsilon\, a_s\, (\theta^4 - \theta_s^4), \qquad
///     a_s = 4\pi b^2 \f]
///
/// @equation{R 7.4.2} Each sphere has one temperature, and none shades another.
struct Cooling {
  double h_c = 0.0;         ///< of convection, >= 0 [W/(m^2 K)]
  double theta_o = 300.0;   ///< temperature of what flows around it, >= 0 [K]
  double emissivity = 0.0;  ///< epsilon, 0 to 1 [-]
  double theta_s = 300.0;   ///< temperature of what it radiates to, >= 0 [K]
};

/// Refuses constants that are no cooling. Called once, where a law enters a scene.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Cooling& law);

/// Heat flow into a sphere, per area of its surface.
///
/// @equation{R 7.4.2}
/// @param law    constants that validate() accepts
/// @param theta  temperature of the sphere, >= 0 [K]
/// @return \f$ -h_c (\theta - \theta_o) - B \varepsilon (\theta^4 - \theta_s^4) \f$ [W/m^2]
double heat_flux(const Cooling& law, double theta);

/// Its slope, \f$ -h_c - 4 B \varepsilon\, \theta^3 \f$.
///
/// @equation{D 7.4.2}
/// @param law    constants that validate() accepts
/// @param theta  temperature of the sphere, >= 0 [K]
/// @return slope [W/(m^2 K)]
double heat_flux_slope(const Cooling& law, double theta);

/// The temperature at which a sphere gives away what it absorbs; of one that absorbs nothing it lies between theta_o
/// and theta_s.
///
/// @equation{D 7.4.2} By bisection, to rounding.
/// @param law       constants that validate() accepts, with convection or radiation
/// @param absorbed  from elsewhere, per area of its surface, >= 0 and finite [W/m^2]
/// @return theta, at which heat_flux() is -absorbed [K]
/// @throws std::invalid_argument if neither acts, and for what cannot be absorbed
double equilibrium_temperature(const Cooling& law, double absorbed = 0.0);

/// Temperature under convection alone, \f$ \theta_o + (\theta_0 - \theta_o)\, e^{-t/\tau} \f$.
///
/// @equation{D 7.4.2}
/// @param theta_0  at t = 0 [K]
/// @param theta_o  of what flows around it [K]
/// @param tau      \f$ m c/(h_c a_s) \f$, > 0 [s]
/// @param t        time [s]
/// @return theta [K]
double convected_temperature(double theta_0, double theta_o, double tau, double t);

/// Time that radiation alone takes from one temperature to another.
///
/// \f[ 4 k\, \theta_s^3\, t = F(\theta_0) - F(\theta), \qquad
///     F(x) = \ln\left|\frac{x - \theta_s}{x + \theta_s}\right| - 2 \arctan\frac{x}{\theta_s}, \qquad
///     k = \frac{B \varepsilon a_s}{m c} \f]
///
/// @equation{D 7.4.2} For theta_s = 0, \f$ 3 k\, t = \theta^{-3} - \theta_0^{-3} \f$.
/// @param k        > 0 [1/(s K^3)]
/// @param theta_0  at the start, > 0 [K]
/// @param theta    at the end, between theta_0 and theta_s, > 0 [K]
/// @param theta_s  of what it radiates to, >= 0 [K]
/// @return t [s]
/// @throws std::invalid_argument for a temperature that radiation does not reach, and for a k that is not positive
double radiation_time(double k, double theta_0, double theta, double theta_s);

/// Adds the heat flows into all particles.
///
/// @equation{R 7.4.2}
/// @param law   constants that validate() accepts
/// @param at    the particles
/// @param heat  receives the flows, added to what it holds, N [W]
/// @return true
template <kinematics::Domain D>
bool add_heat(const Cooling& law, const D&, const laws::At<laws::Temperature>& at, laws::Heats heat) {
  for (Eigen::Index i = 0; i < heat.size(); ++i) {
    heat[i] += surface(at.radius[i]) * heat_flux(law, at.temperature[i]);
  }
  return true;
}

/// Appends the slopes of these flows: each sphere's own alone.
///
/// @equation{D 7.4.2}
/// @param law     constants that validate() accepts
/// @param at      the particles
/// @param slopes  receives N entries [W/K]
template <kinematics::Domain D>
void add_heat_slopes(const Cooling& law, const D&, const laws::At<laws::Temperature>& at, laws::HeatSlopes& slopes) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    slopes.emplace_back(i, i, surface(at.radius[i]) * heat_flux_slope(law, at.temperature[i]));
  }
}

}  // namespace particulate::thermo
