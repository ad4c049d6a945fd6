#include <particulate/scattering/body.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::scattering {

namespace {

void require_place(const char* whose, const Eigen::Vector3d& centre) {
  if (centre.allFinite()) return;
  throw std::invalid_argument(
      fmt::format("{}: its centre must be finite, got ({}, {}, {}) m", whose, centre[0], centre[1], centre[2]));
}

void require_radius(const char* whose, const char* what, double radius) {
  if (radius > 0.0 && std::isfinite(radius)) return;
  throw std::invalid_argument(fmt::format("{}: its {} must be positive and finite, got {} m", whose, what, radius));
}

}  // namespace

void validate(const Sphere& body) {
  require_place("sphere", body.centre);
  require_radius("sphere", "radius", body.radius);
}

void validate(const Spheroid& body) {
  require_place("spheroid", body.centre);
  require_radius("spheroid", "equatorial radius", body.equatorial);
  require_radius("spheroid", "polar radius", body.polar);
  if (std::abs(body.axis.norm() - 1.0) <= 1e-12) return;
  throw std::invalid_argument(fmt::format("spheroid: its axis must be a unit vector, got ({}, {}, {})", body.axis[0],
                                          body.axis[1], body.axis[2]));
}

double area(const Spheroid& body) {
  const double a = body.equatorial, c = body.polar;
  const double e = std::sqrt(std::abs((a - c) * (a + c))) / std::fmax(a, c);  // eccentricity
  // artanh(e)/e and asin(e)/e, which are 1 for a ball.
  const double oblate = e > 0.0 ? std::atanh(e) / e : 1.0, prolate = e > 0.0 ? std::asin(e) / e : 1.0;
  return 2.0 * std::numbers::pi * a * (c <= a ? a + c * (c / a) * oblate : a + c * prolate);
}

}  // namespace particulate::scattering
