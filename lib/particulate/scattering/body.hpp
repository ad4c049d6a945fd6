#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include <Eigen/Core>

/// @file
/// Opaque bodies that rays meet: what every one can be asked, and the convex ones. No tolerance keeps a ray from the
/// body that it has just left: it is asked next_entry(), which knows that the ray starts on the surface.

namespace particulate::scattering {

/// Where a ray goes on without end [m].
inline constexpr double nowhere = std::numeric_limits<double>::infinity();

/// A body: where it is, what contains it, and where rays enter it.
///
/// `centre` is a place; `bounding_radius(body)` that of a ball about it which contains it, `half_extents(body)` how far
/// it reaches from there in each direction [m]. `first_entry(body, from,
/// direction)` is the distance after which a ray from outside first enters, or nowhere; `next_entry()` the same of a
/// ray that has just been reflected at a place of the surface. `outward_normal(body, place)` is the unit normal at a
/// place of the surface, `contains(body, place)` whether a place lies inside. `are_apart(one, other)` says that they do
/// not overlap; touching, to 1e-12 of their size, counts as apart. `volume(body)` [m^3], `area(body)` [m^2].
template <class B>
concept Body = std::copyable<B> && requires(const B& body, const Eigen::Vector3d& x) {
  { body.centre } -> std::convertible_to<Eigen::Vector3d>;
  { bounding_radius(body) } -> std::same_as<double>;
  { half_extents(body) } -> std::same_as<Eigen::Vector3d>;
  { first_entry(body, x, x) } -> std::same_as<double>;
  { next_entry(body, x, x) } -> std::same_as<double>;
  { outward_normal(body, x) } -> std::same_as<Eigen::Vector3d>;
  { contains(body, x) } -> std::same_as<bool>;
  { are_apart(body, body) } -> std::same_as<bool>;
  { volume(body) } -> std::same_as<double>;
  { area(body) } -> std::same_as<double>;
};

/// A ball.
struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  double radius = 1.0;                               ///< b > 0 [m]
};

/// An ellipsoid of revolution: oblate where its polar radius is the smaller one, else prolate.
struct Spheroid {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< of revolution, a unit vector [-]
  double equatorial = 1.0;                           ///< radius across the axis, > 0 [m]
  double polar = 1.0;                                ///< radius along the axis, > 0 [m]
};

/// Refuses a body that is none. Called once, where a body enters.
///
/// @param body  the body
/// @throws std::invalid_argument naming the number, what must hold and what was given
void validate(const Sphere& body);
/// @copydoc validate(const Sphere&)
void validate(const Spheroid& body);

/// Distance after which a line, parametrized by its direction's length, first enters a ball about the origin.
///
/// \f[ t = t_0 - \frac{\sqrt{b^2 - h^2}}{|d|}, \qquad t_0 = -\frac{x \cdot d}{d^2}, \quad h = |x + t_0\, d| \f]
///
/// @equation{D 9.3} From the foot of the perpendicular: the difference of two large squares of the quadratic formula,
/// which loses the digits of far rays, does not appear.
/// @param from       a place outside of it [m]
/// @param direction  of any length > 0
/// @param radius     b [m]
/// @return t >= 0; nowhere where the line misses it or only touches, or leads away from it
inline double entry_of_ball(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double radius) {
  const double ahead = -from.dot(direction);
  if (!(ahead > 0.0)) return nowhere;
  const double square = direction.squaredNorm(), middle = ahead / square;
  const double left = radius * radius - (from + middle * direction).squaredNorm();
  if (!(left > 0.0)) return nowhere;
  return std::max(middle - std::sqrt(left / square), 0.0);
}

/// @param body  a ball
/// @return its radius [m]
inline double bounding_radius(const Sphere& body) { return body.radius; }

/// @param body  a ball
/// @return its radius, in each direction [m]
inline Eigen::Vector3d half_extents(const Sphere& body) { return Eigen::Vector3d::Constant(body.radius); }

/// First entry of a ray. @equation{D 9.3}
///
/// @param body       a ball
/// @param from       a place outside of it [m]
/// @param direction  a unit vector
/// @return distance; nowhere: it misses the body [m]
inline double first_entry(const Sphere& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  // entry_of_ball() of a direction whose length is 1, which is half of its work. Most balls lie beside the ray, half of
  // them behind: the first question is the one whose answer processors guess.
  const Eigen::Vector3d to_centre = body.centre - from;
  const double ahead = to_centre.dot(direction);
  const double left = body.radius * body.radius - (to_centre - ahead * direction).squaredNorm();
  if (!(left > 0.0) || !(ahead > 0.0)) return nowhere;
  return std::max(ahead - std::sqrt(left), 0.0);
}
/// What leaves a convex body does not meet it again. @return nowhere
inline double next_entry(const Sphere&, const Eigen::Vector3d&, const Eigen::Vector3d&) { return nowhere; }

/// @param body   a ball
/// @param place  on its surface [m]
/// @return unit normal, outwards
inline Eigen::Vector3d outward_normal(const Sphere& body, const Eigen::Vector3d& place) {
  return (place - body.centre).normalized();
}
/// @param body   a ball
/// @param place  any [m]
/// @return whether it lies inside
inline bool contains(const Sphere& body, const Eigen::Vector3d& place) {
  return (place - body.centre).squaredNorm() < body.radius * body.radius;
}
/// @param one    a ball
/// @param other  another
/// @return false: they overlap by more than 1e-12 of the distance at which they touch
inline bool are_apart(const Sphere& one, const Sphere& other) {
  const double touching = (1.0 - 1e-12) * (one.radius + other.radius);
  return (one.centre - other.centre).squaredNorm() >= touching * touching;
}
/// @param body  a ball @return its volume [m^3]
inline double volume(const Sphere& body) {
  return 4.0 / 3.0 * std::numbers::pi * body.radius * body.radius * body.radius;
}
/// @param body  a ball @return its surface [m^2]
inline double area(const Sphere& body) { return 4.0 * std::numbers::pi * body.radius * body.radius; }

/// A vector as a spheroid sees it: stretched along the axis, so that the spheroid becomes a ball of its equatorial
/// radius.
///
/// @param body  a spheroid
/// @param x     a vector
/// @return \f$ x + (a/c - 1)\,(x \cdot u)\, u \f$
inline Eigen::Vector3d stretched(const Spheroid& body, const Eigen::Vector3d& x) {
  return x + ((body.equatorial / body.polar - 1.0) * x.dot(body.axis)) * body.axis;
}

/// @param body  a spheroid
/// @return its larger radius [m]
inline double bounding_radius(const Spheroid& body) { return std::fmax(body.equatorial, body.polar); }

/// How far it reaches along each axis of space, \f$ \sqrt{a^2 (1 - u_k^2) + c^2 u_k^2} \f$. @equation{D 9.3.3}
///
/// @param body  a spheroid
/// @return half extents [m]
inline Eigen::Vector3d half_extents(const Spheroid& body) {
  const double a = body.equatorial, c = body.polar;
  return (a * a + (c - a) * (c + a) * body.axis.array().square()).sqrt();
}

/// First entry of a ray, that of the stretched ray into a ball. @equation{D 9.3.3}
///
/// @param body       a spheroid
/// @param from       a place outside of it [m]
/// @param direction  a unit vector
/// @return distance; nowhere: it misses the body [m]
inline double first_entry(const Spheroid& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  return entry_of_ball(stretched(body, from - body.centre), stretched(body, direction), body.equatorial);
}
/// What leaves a convex body does not meet it again. @return nowhere
inline double next_entry(const Spheroid&, const Eigen::Vector3d&, const Eigen::Vector3d&) { return nowhere; }

/// The gradient of its squared form, over its length. @equation{D 9.3.3}
///
/// @param body   a spheroid
/// @param place  on its surface [m]
/// @return unit normal, outwards
inline Eigen::Vector3d outward_normal(const Spheroid& body, const Eigen::Vector3d& place) {
  return stretched(body, stretched(body, place - body.centre)).normalized();
}
/// @param body   a spheroid
/// @param place  any [m]
/// @return whether it lies inside
inline bool contains(const Spheroid& body, const Eigen::Vector3d& place) {
  return stretched(body, place - body.centre).squaredNorm() < body.equatorial * body.equatorial;
}
/// Whether two spheroids are apart, by the separation of their centres. @see are_apart()
///
/// @param one    a spheroid
/// @param other  another
/// @return false: they overlap by more than 1e-12 of their distance
bool are_apart(const Spheroid& one, const Spheroid& other);
/// @param body  a spheroid @return its volume [m^3]
inline double volume(const Spheroid& body) {
  return 4.0 / 3.0 * std::numbers::pi * body.equatorial * body.equatorial * body.polar;
}
/// Its surface, in closed form for both kinds. @equation{D 9.3.3}
///
/// @param body  a spheroid
/// @return area [m^2]
double area(const Spheroid& body);

}  // namespace particulate::scattering
