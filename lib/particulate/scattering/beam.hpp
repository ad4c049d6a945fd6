#pragma once

#include <functional>

#include <particulate/scattering/trace.hpp>

namespace particulate::scattering {

/// A beam of parallel rays with the same power.
struct Beam {
  /// What its cross-section is.
  enum class Shape { square, disc };
  /// Where in it the rays are.
  enum class Points {
    random,      ///< drawn anew, each for itself
    stratified,  ///< one in each of n equal parts, at random within
    regular      ///< in the middle of each of n equal parts
  };
  Shape shape = Shape::square;                           ///< see Shape
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();      ///< of the cross-section from which it starts [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< a unit vector [-]
  double width = 1.0;                                    ///< edge of the square, diameter of the disc, > 0 [m]
  double irradiance = 1.0;                               ///< power per area across it, > 0 [W/m^2]
  Points points = Points::random;                        ///< see Points
};

/// Refuses a beam that is none.
///
/// @param beam  the beam
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Beam& beam);

/// @param beam  a beam that validate() accepts
/// @return area of its cross-section [m^2]
double area(const Beam& beam);

/// The rays of a beam, each with the power \f$ I a/n \f$ of its part of the cross-section a.
///
/// @equation{R 9.3} A part of a disc is that of a square under the map that keeps areas and takes squares about the
/// middle to circles: @cite shirley1997.
/// @param beam     a beam that validate() accepts
/// @param n        how many rays, >= 0; a square number unless they are random
/// @param uniform  draws a number in [0, 1), two a ray; not asked for regular points
/// @return rays, whose parts follow one another line by line
/// @throws std::invalid_argument for a beam that is none, or a number of rays that does not divide its cross-section
Rays rays_of(const Beam& beam, Eigen::Index n, const std::function<double()>& uniform);

/// Moves the start of a beam back along its direction until it lies outside of a box, and refuses one that misses it.
///
/// @param beam  a beam
/// @param box   in which bodies are
/// @return the beam, starting before the box
/// @throws std::invalid_argument saying where the beam goes and where the box is, if no ray of the beam can meet it
Beam before(Beam beam, const kinematics::Box& box);

}  // namespace particulate::scattering
