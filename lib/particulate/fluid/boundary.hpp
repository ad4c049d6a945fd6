#pragma once

#include <array>
#include <functional>
#include <optional>
#include <variant>

#include <particulate/fluid/grid.hpp>

/// @file
/// What happens at the faces of a box.

namespace particulate::fluid {

/// A fluid at a place: what is measured, not what is conserved.
template <int Dim>
struct Local {
  double rho = 1.0;                     ///< density [kg/m^3]
  Vector<Dim> v = Vector<Dim>::Zero();  ///< velocity [m/s]
  double theta = 300.0;                 ///< temperature; a barotropic fluid has none [K]
};

/// Beyond this face the box begins again at the opposite one, which must be periodic too.
struct Periodic {};

/// Nothing passes. Its temperature is given, or it lets no heat through.
template <int Dim>
struct Wall {
  Vector<Dim> velocity = Vector<Dim>::Zero();  ///< along itself [m/s]
  bool slips = false;                          ///< whether it holds back nothing that moves along it
  std::optional<double> theta = {};            ///< > 0; none: adiabatic [K]
};

/// The fluid beyond the face is known: an inflow, or a solution that is.
template <int Dim>
struct Given {
  std::function<Local<Dim>(double t, const Vector<Dim>& x)> fluid;  ///< at places up to a cell beyond the face
};

/// The fluid leaves against a pressure. All else goes on with no second derivative at the face.
///
/// For streams that carry more than they diffuse: where viscosity is all (a Reynolds number of the box below about 1/2)
/// a given pressure alone is no condition under which a gas stays at rest, and disturbances grow.
struct Outflow {
  double P = 1e5;  ///< at the face [Pa]
};

template <int Dim>
using Boundary = std::variant<Periodic, Wall<Dim>, Given<Dim>, Outflow>;  ///< of one face

/// Of the faces x low, x high, y low and so on.
template <int Dim>
using Boundaries = std::array<Boundary<Dim>, 2 * Dim>;

/// Refuses boundaries that do not belong together or cannot be meant.
///
/// @param boundaries  of all faces
/// @param has_heat    whether the fluid has a temperature
/// @throws std::invalid_argument naming the face, what must hold and what was given
template <int Dim>
void validate(const Boundaries<Dim>& boundaries, bool has_heat);

}  // namespace particulate::fluid
