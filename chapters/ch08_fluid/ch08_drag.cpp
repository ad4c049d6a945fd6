//! @page ch08_drag Chapter 8: The drag of a sphere
//! @brief The drag coefficient over six decades, its jumps, and a sphere that may fall at either of two speeds.
//! @tableofcontents
//!
//! @section ch08_drag_question One sphere, two speeds
//!
//! What a fluid does to a sphere, and a sphere to a fluid, is drag (8.1.1),
//!
//! \f[ \Psi^{drag} = \tfrac12 C_D\, \rho_f\, \|v_f - v\|\, (v_f - v)\, \pi b^2, \qquad
//!     Re = \frac{2 b\, \rho_f\, \|v_f - v\|}{\mu_f} . \f]
//!
//! The coefficient is one that the monograph takes from Chow, branch by branch
//! (particulate::fluid::drag_coefficient). As its first branch is 24/Re, drag itself is finite at rest: that of Stokes,
//! \f$ 6 \pi \mu_f b\, (v_f - v) \f$.
//!
//! @figure{ch08_coefficient, The drag coefficient of a sphere. Where the flow along its surface becomes turbulent it drops.}
//!
//! It jumps a little where branches meet, and by a factor of six at Re = 3e5: the drag crisis. A sphere that gets
//! faster than that has *less* drag. Does it matter? Let spheres fall through water.
//!
//! @section ch08_drag_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <particulate/fluid/drag.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>

#include "ch08_fluid.hpp"

namespace ch08 {
namespace {

const Stream lake{.rho = 1000.0, .mu = 1e-3};
constexpr double rho_of_spheres = 2500.0, g = 9.81;  // [kg/m^3], [m/s^2]

double volume_of(double b) { return 4.0 / 3.0 * std::numbers::pi * b * b * b; }

double reynolds_of(double b, double u) { return 2.0 * b * lake.rho * u / lake.mu; }

//! Speeds at which drag balances weight less buoyancy have a closed form on each branch
//! (particulate::fluid::steady_speeds).

std::vector<double> terminal_speeds(double b) {
  return steady_speeds(lake, b, volume_of(b) * (rho_of_spheres - lake.rho) * g);
}

void write_coefficient(const report::Output& output) {
  report::Table table({"branch", "Re", "C_D"});
  const std::array<double, 6> ends{1e-2, 1.0, 400.0, 3e5, 2e6, 1e7};
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    for (int n = 0; n <= 20; ++n) {
      // A branch has its right end and not its left one.
      const double left = ends[k] * (1.0 + 1e-12), Re = left * std::pow(ends[k + 1] / left, n / 20.0);
      table.add({k, Re, drag_coefficient(std::min(Re, ends[k + 1]))});
    }
  }
  output.write("coefficient", table);
}

void write_terminal_speeds(const report::Output& output) {
  report::Table table({"diameter [m]", "which", "speed [m/s]", "Re"});
  for (int n = 0; n <= 240; ++n) {
    const double d = 1e-4 * std::pow(10.0, 4.0 * n / 240.0);
    int which = 0;
    for (const double u : terminal_speeds(0.5 * d)) table.add({d, which++, u, reynolds_of(0.5 * d, u)});
  }
  output.write("terminal", table);
}

//! A sphere of 0.1 m is dropped, and another one thrown down. Both are scenes with gravity, buoyancy and drag.

double fall(double thrown, double end, report::Table& table) {
  constexpr double b = 0.05;
  const kinematics::Particles sphere = kinematics::particles({{.position = Eigen::Vector3d::Zero(),
                                                               .velocity = {0.0, 0.0, -thrown},
                                                               .mass = rho_of_spheres * volume_of(b),
                                                               .radius = b}});
  const scenes::Scene scene(sphere, kinematics::Space{}, laws::Gravity{.g = {0.0, 0.0, -g}}, Buoyancy{lake},
                            Drag{lake});
  State state = start(scene);
  schemes::Sampling samples(equal_times(end, 60), [&](const State& at) { table.add({thrown, at.t, -at.v[2]}); });
  const schemes::Outcome outcome =
      integrate(scene, state, end, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.005}, samples);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error("a falling sphere: " + describe(outcome));
  return -state.v[2];
}

}  // namespace

void drag(const Parameters&, report::Chapter& chapter) {
  write_coefficient(chapter.output());
  write_terminal_speeds(chapter.output());
  report::Table falls({"thrown at [m/s]", "t [s]", "speed [m/s]"});
  const double dropped = fall(0.0, 3.0, falls), thrown = fall(3.5, 3.0, falls);
  chapter.output().write("falls", falls);
  const std::vector<double> speeds = terminal_speeds(0.05);
  report::Checks& checks = chapter.claims("checks");
  checks.add("a sphere that is dropped into water: its speed over the slow one, less 1", dropped / speeds.front() - 1.0,
             1e-3);
  checks.add("the same, thrown: its speed over the fast one, less 1", thrown / speeds.back() - 1.0, 1e-3);
}

}  // namespace ch08

//! @section ch08_drag_results Two speeds
//!
//! @figure{ch08_terminal, Left: the speeds at which spheres of 2500 kg/m^3 fall through water\, over their diameters. Right: one of 0.1 m that is dropped\, and one that is thrown.}
//!
//! In a range of diameters there are two speeds, and both are stable. Between them lies the jump, which repels: below
//! it drag is too large and the sphere slows down, above it drag is too small and the sphere goes on. Which one a
//! sphere takes depends on how it began. For computations this means that an *implicit* step may have two solutions,
//! and nothing in the step says which is right; a suspension counts those, and which one it took
//! (particulate::fluid::Suspension::roots_taken).
//!
//! Of a real sphere the drop is steep, not sudden, and comes earlier the rougher it is. That two speeds exist is real.
//!
//! @section ch08_drag_exercises Exercises
//!
//! 1. For which diameters are there two speeds? Derive the range from the coefficients on both sides of the jump, and
//!    compare it with the figure.
//! 2. From which speed on must the sphere of 0.1 m be thrown to end up fast? Try, and explain.
//! 3. Leave out buoyancy. Which spheres notice, in water and in air?
