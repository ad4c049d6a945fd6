#include <particulate/scattering/beam.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/Geometry>

namespace particulate::scattering {

namespace {

// From the square [-1, 1]^2 to the disc of radius 1, with equal areas: Shirley and Chiu's concentric map.
Eigen::Vector2d on_disc(const Eigen::Vector2d& square) {
  const double x = square[0], y = square[1];
  if (x == 0.0 && y == 0.0) return Eigen::Vector2d::Zero();
  const bool wide = std::abs(x) > std::abs(y);
  const double r = wide ? x : y, quarter = 0.25 * std::numbers::pi;
  const double phi = wide ? quarter * (y / x) : 2.0 * quarter - quarter * (x / y);
  return {r * std::cos(phi), r * std::sin(phi)};
}

Eigen::Index parts_of_an_edge(Eigen::Index n) {
  const auto edge = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(n))));
  if (edge * edge == n) return edge;
  throw std::invalid_argument(
      fmt::format("beam: stratified and regular rays fill a square of equal parts, so their number must be a square, "
                  "such as {}, got {}",
                  edge * edge, n));
}

}  // namespace

void validate(const Beam& beam) {
  const auto require = [](bool holds, const char* what, double given) {
    if (!holds) throw std::invalid_argument(fmt::format("beam: {}, got {}", what, given));
  };
  require(beam.centre.allFinite(), "its centre must be finite", beam.centre.sum());
  require(std::abs(beam.direction.norm() - 1.0) <= 1e-12, "its direction must be a unit vector, of length 1",
          beam.direction.norm());
  require(beam.width > 0.0 && std::isfinite(beam.width), "width must be positive and finite", beam.width);
  require(beam.irradiance > 0.0 && std::isfinite(beam.irradiance), "irradiance must be positive and finite",
          beam.irradiance);
}

double area(const Beam& beam) {
  return (beam.shape == Beam::Shape::square ? 1.0 : 0.25 * std::numbers::pi) * beam.width * beam.width;
}

Rays rays_of(const Beam& beam, Eigen::Index n, const std::function<double()>& uniform) {
  validate(beam);
  if (n < 0) throw std::invalid_argument(fmt::format("beam: the number of rays must not be negative, got {}", n));
  const bool random = beam.points == Beam::Points::random;
  const Eigen::Index edge = random ? 1 : parts_of_an_edge(n);
  // Across a beam along x these are y and z.
  const Eigen::Vector3d helper =
      std::abs(beam.direction[2]) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d across = helper.cross(beam.direction).normalized(), up = beam.direction.cross(across);
  Rays rays{.place = kinematics::Vectors(n, 3),
            .direction = beam.direction.transpose().replicate(n, 1),
            .power = Eigen::VectorXd::Constant(
                n, beam.irradiance * area(beam) / static_cast<double>(std::max<Eigen::Index>(n, 1)))};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index line = i / edge;
    Eigen::Vector2d at(static_cast<double>(i % edge), static_cast<double>(line));
    const bool middle = beam.points == Beam::Points::regular;
    for (double& coordinate : at) {
      const double within = middle ? 0.5 : uniform();
      coordinate = 2.0 * ((random ? 0.0 : coordinate) + within) / static_cast<double>(edge) - 1.0;
    }
    if (beam.shape == Beam::Shape::disc) at = on_disc(at);
    rays.place.row(i) = beam.centre + 0.5 * beam.width * (at[0] * across + at[1] * up);
  }
  return rays;
}

Beam before(Beam beam, const kinematics::Box& box) {
  validate(beam);
  const Eigen::Vector3d middle = box.corner + 0.5 * box.lengths - beam.centre, half = 0.5 * box.lengths;
  const double ahead = middle.dot(beam.direction), depth = half.dot(beam.direction.cwiseAbs());
  const double aside = (middle - ahead * beam.direction).norm();
  if (aside > half.norm() + beam.width) {
    throw std::invalid_argument(
        fmt::format("beam: it must meet the box, and passes its middle at {} m, where the box is {} m wide at most: "
                    "move its centre",
                    aside, 2.0 * half.norm()));
  }
  // A ray on the face of the box starts outside of all bodies; a little before it rounding does not matter.
  if (ahead < depth) beam.centre -= (depth - ahead) * (1.0 + 1e-9) * beam.direction;
  return beam;
}

}  // namespace particulate::scattering
