//! @page ch09_shared Chapter 9: What its pages share
//! @brief The parameters of the chapter, its beam and its clouds.
//! @tableofcontents
//!
//! @section ch09_parameters Parameters
//!
//! Captions of the monograph tell L and n^ of the beam that is watched, and the axes of the ellipsoids. A thousand
//! scatterers are those of chapter 4; all other numbers are our choice. The fluence is chosen to warm the
//! scatterers by about a hundred kelvins in the mean.

#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <particulate/report/chapter.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/heat.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/trace.hpp>

namespace ch09 {

using namespace particulate;
using namespace particulate::scattering;
using kinematics::uniform_from;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  int& rays = line.field(1000, {"rays", "of a beam", "-", between(500, 10000), "9.3"});
  int& realizations = line.field(
      40, {"realizations", "clouds that an answer is averaged over, a fifth with --quick", "-", between(40, 80), ours});
  double& settled = line.field(
      0.002, {"settled", "change of a running mean below which it counts as settled", "-", between(1e-4, 0.01), ours});
  double& L = line.field(0.325, {"length_ratio", "radius over spacing of the scatterers whose rays are drawn", "-",
                                 between(0.2, 0.4), "9.6"});
  double& n_hat =
      line.field(10.0, {"n_hat", "ratio of refractive indices of the same, n^", "-", between(1.1, 100.0), "9.6"});
  double& edge = line.field(1e-3, {"edge", "of a cube whose scatterers get warm", "m", between(1e-4, 1e-2), ours});
  double& rho_c =
      line.field(2e6, {"rho_c", "density times specific heat of the same", "J/(m^3 K)", between(1e6, 4e6), ours});
  double& fluence = line.field(1.7e5, {"fluence", "energy per area of a pulse", "J/m^2", between(1e4, 1e6), ours});
  double& irradiance = line.field(1e6, {"irradiance", "of a steady beam", "W/m^2", between(1e4, 1e7), ours});
  int& searches =
      line.field(10, {"searches", "for the cloud that was seen, two fifths with --quick", "-", between(5, 20), ours});
  int& fitted =
      line.field(6, {"fitted", "clouds that a search averages over, a third with --quick", "-", between(6, 24), ours});
};

//! @section ch09_beam The beam and what it meets
//!
//! Scatterers lie wholly within the unit cube, put there one after the other, each at a place drawn anew until it
//! overlaps none. A square beam of half the cube's edge comes in through the middle of the face x = 0, along x.

inline constexpr Eigen::Index scatterers = 1000;
inline const Beam beam{.centre = {0.0, 0.5, 0.5}, .width = 0.5};

inline constexpr double theta_0 = 300.0;  // of everything before it gets warm, and of what is around [K]

inline double radius_of(double L) { return L / std::cbrt(static_cast<double>(scatterers)); }

// Where they stand densest, the last ones take many tries.
inline const kinematics::Addition into_cube{.inside = kinematics::Inside::spheres, .most_attempts = 100000000};

inline Cloud<Sphere> spheres(double L, const std::function<double()>& uniform) {
  return {place_spheres(scatterers, radius_of(L), into_cube, uniform).bodies, {}};
}

//! Heat makes size matter. Where there is heat, the cube has the edge that the parameters say, and the same numbers from
//! the same seed put the same cloud into it, smaller. The beam may be a pulse: its rays then carry energies, and fluence
//! stands for irradiance.

inline Beam small_beam(const Parameters& p, double irradiance) {
  return {.centre = p.edge * beam.centre, .width = p.edge * beam.width, .irradiance = irradiance};
}

inline Cloud<Sphere> small_spheres(const Parameters& p, const std::function<double()>& uniform) {
  kinematics::Addition into = into_cube;
  into.box.lengths *= p.edge;
  return {place_spheres(scatterers, radius_of(p.L) * p.edge, into, uniform).bodies, into.box};
}

//! @section ch09_pulse A pulse
//!
//! Energies that a pulse brings to the spheres of a cloud, of which all are as warm as what they radiate to.

inline const thermo::Cooling radiation{.emissivity = 1.0, .theta_s = theta_0};

struct Pulse {
  Cloud<Sphere> cloud;
  HeatedBodies bodies;
  Rays rays;      // before
  Traced traced;  // with paths
};

Pulse pulse(const Parameters& p, int k);

//! @section ch09_way Where a ray is
//!
//! A path is kept as the places where its ray turns. Where the ray is between two of them, and after the last, is a
//! matter of going straight.

using Path = std::vector<PathPoint>;
std::vector<Path> split(const std::vector<PathPoint>& points, Eigen::Index rays);

struct Moment {
  Eigen::Vector3d place, velocity;  // [m], over that of light [-]
  double power;
};
Moment moment_of(const Path& path, const Rays& at_the_end, double length);

//! Realization k of every question has the same seed, whatever else differs.

inline int realizations_of(const Parameters& p) { return p.line.common().quick ? p.realizations / 5 : p.realizations; }
inline std::uint64_t seed_of(const Parameters& p, int k) {
  return p.line.common().seed + static_cast<std::uint64_t>(k);
}

//! A page is a function. It writes its tables and adds what it claims.

void reflectance_of_one(report::Chapter& chapter);
void progress(const Parameters& p, report::Chapter& chapter);
void clouds(const Parameters& p, report::Chapter& chapter);
void heat(const Parameters& p, report::Chapter& chapter);
void slow_heat(const Parameters& p, report::Chapter& chapter);
void inverse(const Parameters& p, report::Chapter& chapter);

}  // namespace ch09
