//! @page appB_sound Appendix B: Sound against a solid
//! @brief Where the power of a sound wave goes that meets a solid: back, or into two kinds of waves.
//! @tableofcontents
//!
//! @section appB_solid Two waves in the solid
//!
//! Sound in a fluid that meets an elastic solid makes two waves in it: a *longitudinal* one of speed \f$ c_l \f$, and a
//! *shear* wave of speed \f$ c_s \f$ (B.3.1). Both must keep step with the incident wave along the surface,
//!
//! \f[ \frac{\sin\theta}{c_f} = \frac{\sin\theta_l}{c_l} = \frac{\sin\theta_s}{c_s} , \f]
//!
//! and both are faster than sound in the fluid. Beyond a critical angle, where \f$ \sin\theta_l \f$ or
//! \f$ \sin\theta_s \f$ would exceed 1, that wave clings to the surface and carries no power away. With the impedances
//! \f$ Z_l = \rho_s c_l/\cos\theta_l \f$, \f$ Z_s = \rho_s c_s/\cos\theta_s \f$, \f$ Z_f = \rho_f c_f/\cos\theta \f$,
//!
//! \f[ r = \frac{N - Z_f}{N + Z_f}, \qquad N = Z_l \cos^2 2\theta_s + Z_s \sin^2 2\theta_s . \f]
//!
//! @figure{appB_solid, Shares of the power of sound in water that meets steel\, against the angle of incidence.}
//!
//! Here \f$ W_l \f$ and \f$ W_s \f$ are the shares that go into the solid (particulate::scattering::shares). Together
//! with \f$ |r|^2 \f$ they are all there is.
//!
//! **The local frame** of a reflection (B.3.2). Rays come from anywhere and surfaces look anywhere. What the formulas
//! need is the frame of the hit: the normal n, and the tangent in the plane of incidence,
//! \f$ t = (d - (d \cdot n)\, n)/\sin\theta \f$. The tracer gets by without t, as a mirror keeps it:
//! \f$ d' = d - 2 (d \cdot n)\, n \f$.
//!
//! @figure{appB_frame, The local frame of a reflection: Figure B.8.}
//!
//! @section appB_sound_program The program

#include <algorithm>
#include <cmath>
#include <numbers>

#include "appB_scattering.hpp"

namespace appB {

void sound(report::Chapter& chapter) {
  const FluidSolid steel{.rho_f = 1000.0, .c_f = 1480.0, .rho_s = 7800.0, .c_l = 5900.0, .c_s = 3200.0};
  constexpr double degree = std::numbers::pi / 180.0;
  report::Table table({"angle [degrees]", "reflected", "longitudinal", "shear"});
  double worst = 0.0, beyond = 0.0;
  for (int k = 0; k <= 900; ++k) {
    const SolidShares now = shares(steel, std::cos(0.1 * k * degree));
    table.add({0.1 * k, now.reflected, now.longitudinal, now.shear});
    worst = report::worse_of(worst, std::abs(now.reflected + now.longitudinal + now.shear - 1.0));
    if (k > 276) beyond = report::worse_of(beyond, std::abs(now.reflected - 1.0));
  }
  chapter.output().write("solid", table);
  const double to_l = critical_angle(steel.c_f / steel.c_l) / degree,
               to_s = critical_angle(steel.c_f / steel.c_s) / degree;
  report::Checks& checks = chapter.claims("checks");
  checks.add("water and steel: sum of all shares, less 1", worst, 1e-13);
  checks.add("water and steel: share reflected beyond both critical angles, less 1", beyond, 1e-13);
  checks.add("water and steel: share reflected at 20 degrees, less 0.84241",
             shares(steel, std::cos(20.0 * degree)).reflected - 0.84241, 5e-6);
  checks.add("water and steel: critical angles, less 14.528 and 27.549 [degrees]",
             std::max(std::abs(to_l - 14.528), std::abs(to_s - 27.549)), 5e-4);
  chapter.summary().add({"water and steel: critical angle of longitudinal waves [degrees]", to_l});
  chapter.summary().add({"water and steel: critical angle of shear waves [degrees]", to_s});
}

}  // namespace appB

//! @section appB_sound_results What comes of it
//!
//! Straight on, steel returns nearly nine tenths, and the rest goes on as a longitudinal wave; a shear wave begins with
//! the angle. At the first critical angle everything is reflected, at that one angle. Between the two a shear wave
//! alone enters, and beyond the second nothing does.
//!
//! @section appB_sound_exercises Exercises
//!
//! 1. Why is all reflected exactly at the first critical angle, although a shear wave could enter?
//! 2. Set \f$ c_s \to 0 \f$: what is left should be two fluids. What becomes of \f$ W_s \f$?
//! 3. Trace a cloud of steel spheres in water: replace Fresnel in the program by FluidSolid. How does \f$ I_x \f$
//!    differ from that of two fluids with the same \f$ \hat Z \f$?
