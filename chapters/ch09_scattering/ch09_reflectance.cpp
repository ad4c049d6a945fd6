//! @page ch09_reflectance Chapter 9: Waves, and one scatterer
//! @brief From plane waves to the share that a smooth surface reflects, and what a single scatterer reflects in all.
//! @tableofcontents
//!
//! @section ch09_waves Plane waves
//!
//! A **plane wave** (9.2.1) has the same value all over each plane across its direction,
//!
//! \f[ E = E_0 \cos(k \cdot x - \omega t), \qquad |k| = \frac{2\pi}{\lambda} = \frac{\omega}{v} . \f]
//!
//! A plane of equal phase moves along the *propagation vector* k with the speed v. A ray is such a direction, drawn as
//! a line: it tells where power goes, and nothing of phases.
//!
//! @figure{ch09_front, Wave fronts and their propagation vector: Figure 9.2.}
//!
//! **Light** (9.2.2) obeys Maxwell's equations. In a medium without charges and currents, \f$ D = \epsilon E \f$ and
//! \f$ B = \mu H \f$, they read
//!
//! \f[ \nabla \times E = -\mu\, \partial_t H, \quad \nabla \times H = \epsilon\, \partial_t E, \quad
//!     \nabla \cdot E = 0, \quad \nabla \cdot H = 0 . \f]
//!
//! The curl of the first, with the second, is the wave equation \f$ \nabla^2 E = \epsilon\mu\, \partial_t^2 E \f$, so
//! that \f$ v = 1/\sqrt{\epsilon\mu} = c/n \f$. Put the plane wave into them: \f$ k \cdot E_0 = k \cdot H_0 = 0 \f$ and
//! \f$ k \times E_0 = \mu\omega H_0 \f$. Both fields lie across the direction and across each other, and
//! \f$ |E_0|/|H_0| = \sqrt{\mu/\epsilon} \f$.
//!
//! **Power** (9.2.3) flows by Poynting's vector \f$ S = E \times H \f$. Over a period \f$ \cos^2 \f$ is one half in the
//! mean, which gives the *irradiance*, the power per area that a ray stands for:
//!
//! \f[ I = \langle |S| \rangle = \tfrac12\, |E_0|\, |H_0| = \tfrac12 \sqrt{\epsilon/\mu}\; |E_0|^2 . \f]
//!
//! @section ch09_fresnel What a surface reflects
//!
//! Where a wave meets a smooth surface (9.2.4), the parts of E and H along the surface are continuous. Amplitudes of
//! the reflected and the transmitted wave follow, separately for an electric field in the plane of incidence and across
//! it. With \f$ \hat n = n_t/n_i \f$, \f$ \hat\mu = \mu_t/\mu_i \f$ and \f$ s = \sqrt{\hat n^2 - \sin^2\theta} \f$,
//!
//! \f[ r_\parallel = \frac{(\hat n^2/\hat\mu)\cos\theta - s}{(\hat n^2/\hat\mu)\cos\theta + s}, \qquad
//!     r_\perp = \frac{\cos\theta - s/\hat\mu}{\cos\theta + s/\hat\mu}, \qquad
//!     R = \tfrac12 \left(r_\parallel^2 + r_\perp^2\right) . \f]
//!
//! @figure{ch09_fresnel, Electric fields in the plane of incidence (left) and across it (right): Figure 9.4.}
//!
//! A ray keeps R of its power; what is not reflected counts as absorbed: the scatterers are opaque. Mean values are
//! right for light that is not polarized. After one reflection it is, a little, which a tracer that carries one number
//! a ray does not know. What that costs was measured once, with a tracer that carries it
//! (`verify_ch09_polarization_left_out`): \f$ I_x \f$ of a cloud changes by at most \f$ 6 \cdot 10^{-4} \f$ of the beam,
//! for \f$ \hat n \f$ from 1.5 to 32 and L from 0.25 to 0.4, which is less than the scatter of twenty clouds.
//!
//! @figure{ch09_particle, The same at a scatterer: what counts is the angle to the normal at the place of the hit\, Figure 9.5.}
//!
//! @section ch09_one_program The program
//!
//! One scatterer reflects, *integrated* over what it shows to the beam,
//!
//! \f[ F = 2 \int_0^{\pi/2} R \sin\theta \cos\theta\, d\theta , \f]
//!
//! if it is a sphere in a uniform beam: the ring between \f$ \theta \f$ and \f$ \theta + d\theta \f$ has the shadow
//! \f$ 2\pi b^2 \sin\theta \cos\theta\, d\theta \f$. The caption of Figure 9.8 has a quarter of a scatterer. Read as
//! the quarter of a circle in the plane, the shadow is \f$ b \cos\theta\, d\theta \f$, and the integral
//! \f$ \int_0^{\pi/2} R \cos\theta\, d\theta \f$. We show both.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ch09_scattering.hpp"

namespace ch09 {
namespace {

//! That the first is what a sphere reflects is shown by rays, which know nothing of it: one sphere in a beam as wide as
//! itself, in the middle of each of 160,000 equal parts of the disc.

double by_rays(double n_hat) {
  const Cloud<Sphere> one({{.centre = Eigen::Vector3d::Constant(0.5), .radius = 0.4}}, {});
  const Beam disc{.shape = Beam::Shape::disc, .centre = {0.0, 0.5, 0.5}, .width = 0.8, .points = Beam::Points::regular};
  const Ledger ledger = trace(one, Fresnel{n_hat}, rays_of(disc, 160000, {})).ledger;
  return 1.0 - ledger.absorbed / ledger.incident;
}

//! Those rays stand on 200 rings about the axis, as many on each as its circumference asks for. Their sum is the
//! integral by the midpoint rule over the radius, to rounding. The rule itself is a little off, since near the rim
//! \f$ R \approx 1 - C \cos\theta \f$ leaves 1 like a square root.

double over_rings(double n_hat) {
  constexpr int rings = 200;
  double sum = 0.0;
  for (int k = 0; k < rings; ++k) {
    const double r = (k + 0.5) / rings;
    sum += 2.0 * r * reflectance(Fresnel{n_hat}, std::sqrt((1.0 - r) * (1.0 + r)));
  }
  return sum / rings;
}

//! Summed over equal parts of the angle, in which R is smooth, both integrals are found at once.

struct Integrals {
  double of_sphere = 0.0, of_quarter = 0.0;
};

Integrals over_angles(double n_hat) {
  constexpr int parts = 20000;
  const double part = 0.5 * std::numbers::pi / parts;
  Integrals found;
  for (int k = 0; k < parts; ++k) {
    const double theta = (k + 0.5) * part,
                 weighed = reflectance(Fresnel{n_hat}, std::cos(theta)) * std::cos(theta) * part;
    found.of_sphere += 2.0 * std::sin(theta) * weighed;
    found.of_quarter += weighed;
  }
  return found;
}

}  // namespace

void reflectance_of_one(report::Chapter& chapter) {
  report::Table curve({"n^ [-]", "of a sphere [-]", "of a planar quarter [-]", "at normal incidence [-]"});
  for (int k = 0; k <= 200; ++k) {
    const double n_hat = std::pow(100.0, k / 200.0);
    const Fresnel law{n_hat};
    curve.add({n_hat, sphere_reflectance(law), planar_reflectance(law), reflectance(law, 1.0)});
  }
  chapter.output().write("integrated", curve);
  report::Table table({"n^", "at normal incidence", "of a sphere, F", "the same by rays", "of a planar quarter"});
  double worst_rays = 0.0, worst_sphere = 0.0, worst_quarter = 0.0;
  for (const double n_hat : {1.1, 1.5, 2.0, 4.0, 10.0, 32.0, 100.0}) {
    const Fresnel law{n_hat};
    const double F = sphere_reflectance(law), planar = planar_reflectance(law), rays = by_rays(n_hat);
    table.add({n_hat, reflectance(law, 1.0), F, rays, planar});
    worst_rays = report::worse_of(worst_rays, std::abs(rays - over_rings(n_hat)));
    const Integrals summed = over_angles(n_hat);
    worst_sphere = report::worse_of(worst_sphere, std::abs(summed.of_sphere - F));
    worst_quarter = report::worse_of(worst_quarter, std::abs(summed.of_quarter - planar));
  }
  chapter.output().write("one", table);
  report::Checks& checks = chapter.claims("checks");
  checks.add("one sphere: share reflected, by rays against a sum over the rings where they stand", worst_rays, 1e-12);
  checks.add("one sphere: the library's integral against a sum over angles", worst_sphere, 1e-8);
  checks.add("a planar quarter: the library's integral against the same sum", worst_quarter, 1e-8);
}

}  // namespace ch09

//! @section ch09_one_results What one scatterer reflects
//!
//! @figure{ch09_integrated, Integrated reflectance of one scatterer\, read both ways\, against n^: Figure 9.8.}
//!
//! @table{ch09_one}
//!
//! The readings weigh angles differently. The sphere shows most of itself near 45 degrees, the planar quarter near
//! normal incidence, and so it has less of the grazing rays, which are reflected whatever the sphere is made of. The
//! difference matters where little is reflected.
//!
//! @section ch09_one_exercises Exercises
//!
//! 1. Show that \f$ F \to 0 \f$ as \f$ \hat n \to 1 \f$, although R is 1 at grazing incidence for all \f$ \hat n \f$.
//! 2. What does an ellipsoid reflect whose axis lies along the beam? Take the shadow of a ring instead of a sphere's.
//! 3. A mirror sphere scatters into all directions alike. Prove it, and find the direction that a sphere with
//!    \f$ \hat n = 1.5 \f$ prefers.
