#pragma once

#include <particulate/fluid/drag.hpp>
#include <particulate/thermo/cooling.hpp>

/// @file
/// The heat that a sphere and the fluid around it exchange.

namespace particulate::fluid {

/// What heats and cools a sphere in a fluid: convection, radiation, and its share of what drag dissipates.
///
/// \f[ m\,c\,\dot\theta = h_c\, a_s\, (\theta_f - \theta) - B\,\varepsilon\, a_s\, (\theta^4 - \theta_s^4) + a_v\, D
/// \f] \f[ D = \Psi^{drag} \cdot (v_f - v) \ge 0 \f]
///
/// @equation{R 8.1.2} The fluid gets the opposite of the convection, and the rest of D; radiation goes to the
/// surroundings.
struct HeatExchange {
  double h_c = 0.0;         ///< of convection, >= 0 [W/(m^2 K)]
  double emissivity = 0.0;  ///< epsilon, 0 to 1 [-]
  double theta_s = 300.0;   ///< temperature of what it radiates to, >= 0 [K]
  double a_v = 0.0;         ///< share of the dissipation that heats the sphere, 0 to 1 [-]
};

/// Refuses constants that are no exchange of heat.
///
/// @param heat  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const HeatExchange& heat);

/// Convection and radiation of it as a law of chapter 7.
///
/// @equation{R 8.1.2}
/// @param heat     constants
/// @param theta_f  temperature of the fluid [K]
/// @return the same @see thermo::heat_flux
inline thermo::Cooling cooling(const HeatExchange& heat, double theta_f) {
  return {.h_c = heat.h_c, .theta_o = theta_f, .emissivity = heat.emissivity, .theta_s = heat.theta_s};
}

/// Heats each particle in a given flow, which does not feel it.
///
/// @equation{R 8.1.2}
/// @tparam Field  a Stream, a callable or a FrozenFlow
template <StreamField Field>
struct HeatFromFluid {
  Field fluid;             ///< around the particles
  HeatExchange heat = {};  ///< the constants
};
/// @cond
template <class Field>
HeatFromFluid(Field, HeatExchange) -> HeatFromFluid<Field>;
/// @endcond

/// Refuses constants that are no exchange of heat, and a uniform stream that is none.
///
/// @param law  the law
/// @throws std::invalid_argument naming what must hold and what was given
template <StreamField Field>
void validate(const HeatFromFluid<Field>& law) {
  if constexpr (std::same_as<Field, Stream>) validate(law.fluid);
  validate(law.heat);
}

/// Adds the heat flows into all particles.
///
/// @equation{R 8.1.2}
/// @param law   constants that validate() accepts
/// @param at    the particles
/// @param flow  receives the heat flows, added to what it holds, N [W]
/// @return whether the fluid has a value at each of them
template <StreamField Field, kinematics::Domain D>
bool add_heat(const HeatFromFluid<Field>& law, const D&, const laws::At<laws::Velocity, laws::Temperature>& at,
              laws::Heats flow) {
  for (Eigen::Index i = 0; i < flow.size(); ++i) {
    const Stream there = law.fluid(at.t, at.position.row(i));
    if (!is_value(there)) return false;
    const Eigen::Vector3d v = at.velocity.row(i);
    flow[i] += thermo::surface(at.radius[i]) * heat_flux(cooling(law.heat, there.theta), at.temperature[i]) +
               law.heat.a_v * drag(there, at.radius[i], v).dot(there.v - v);
  }
  return flow.allFinite();
}

/// @param law  the law
/// @param at   the particles
/// @return which of them the fluid has no value at; empty: none
template <StreamField Field, kinematics::Domain D>
std::string why_no_force(const HeatFromFluid<Field>& law, const D&, const laws::At<>& at) {
  return detail::why_no_stream(at, law.fluid);
}

/// Appends the slopes of these flows: each sphere's own alone.
///
/// @equation{D 8.1.2}
/// @param law     constants that validate() accepts
/// @param at      the particles
/// @param slopes  receives N entries [W/K]
template <StreamField Field, kinematics::Domain D>
void add_heat_slopes(const HeatFromFluid<Field>& law, const D&, const laws::At<laws::Velocity, laws::Temperature>& at,
                     laws::HeatSlopes& slopes) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Stream there = law.fluid(at.t, at.position.row(i));
    slopes.emplace_back(
        i, i, thermo::surface(at.radius[i]) * heat_flux_slope(cooling(law.heat, there.theta), at.temperature[i]));
  }
}

}  // namespace particulate::fluid
