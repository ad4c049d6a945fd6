//! @page appB_reflectance Appendix B: Reflectance against angle
//! @brief How much light a surface reflects at each angle, and when it reflects less at a slant than straight on.
//! @tableofcontents
//!
//! @section appB_dip Does it dip?
//!
//! Common glass reflects 4 % of the light that meets it straight on, and hardly anything else up to 50 degrees. Then R
//! rises to 1. Good reflectors do otherwise: R first falls. The monograph draws both.
//!
//! @figure{appB_reflectance, Reflectance against the angle of incidence\, for ratios of refractive indices with one permeability: Figure B.1. A mark: the least reflectance\, where it lies at a slant.}
//!
//! Near normal incidence \f$ R = R(0) + c_4 \sin^4\theta + \dots \f$ There is no term of second order, since what the
//! two polarizations gain and lose cancels. The next one is
//!
//! \f[ c_4 = -\frac{\hat\mu\, (\hat n^2 - 1)^2\, (\hat n^2 - 4 \hat\mu \hat n + \hat\mu^2)}
//!                 {2\, \hat n^3\, (\hat n + \hat\mu)^4} , \f]
//!
//! and R dips if it is negative: if \f$ \hat n/\hat\mu \f$ lies outside of \f$ 2 \pm \sqrt 3 \f$. At the ends
//! \f$ R(0) = (\hat n - \hat\mu)^2/(\hat n + \hat\mu)^2 = 1/3 \f$. In words: **what reflects more than a third straight
//! on reflects less at a slant.**
//!
//! @section appB_dip_program The program

#include <cmath>
#include <numbers>

#include "appB_scattering.hpp"

namespace appB {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
double at_angle(const Fresnel& law, double degrees) { return reflectance(law, std::cos(degrees * degree)); }

//! The least value is looked for among angles, which know nothing of the series above.

struct Least {
  double degrees, R;
};

Least least_of(const Fresnel& law) {
  Least least{0.0, reflectance(law, 1.0)};
  for (int k = 1; k <= 9000; ++k) {
    const double degrees = 0.01 * k, R = at_angle(law, degrees);
    // What rounding makes of a value that is level counts for nothing.
    if (R < least.R - 1e-15) least = {degrees, R};
  }
  return least;
}

void write_curves(report::Chapter& chapter) {
  report::Table curves({"mu^", "n^", "angle [degrees]", "R", "in the plane of incidence", "across it"});
  report::Table dips({"mu^", "n^", "R straight on", "c_4", "least R", "at [degrees]"});
  for (const double mu_hat : {1.0, 2.0, 10.0}) {
    for (const double n_hat : {1.5, 2.0, 4.0, 10.0, 32.0}) {
      const Fresnel law{n_hat, mu_hat};
      for (int k = 0; k <= 180; ++k) {
        const double cosine = std::cos(0.5 * k * degree);
        const double along = r_parallel(law, cosine), across = r_perpendicular(law, cosine);
        curves.add({mu_hat, n_hat, 0.5 * k, reflectance(law, cosine), along * along, across * across});
      }
      const Least least = least_of(law);
      dips.add({mu_hat, n_hat, reflectance(law, 1.0), dip_coefficient(law), least.R, least.degrees});
    }
  }
  chapter.output().write("curves", curves);
  chapter.output().write("dips", dips);
}

//! Whether there is a dip is asked of a few hundred surfaces, save those within a hundredth of the limit, where it is
//! too shallow to be told from rounding.

double wrong_about_dips() {
  double wrong = 0.0;
  for (const double mu_hat : {0.5, 1.0, 2.0, 10.0}) {
    for (int k = 0; k <= 60; ++k) {
      const Fresnel law{mu_hat * std::pow(10.0, k / 30.0 - 0.5), mu_hat};
      const double straight = reflectance(law, 1.0);
      // Under total reflection, n^ < 1, there is nothing to look for; at n^ = 1 and mu^ = 1 nothing is reflected.
      if (law.n_hat < 1.01 || std::abs(straight - 1.0 / 3.0) < 0.01) continue;
      if ((least_of(law).degrees > 0.0) != (straight > 1.0 / 3.0)) ++wrong;
    }
  }
  return wrong;
}

}  // namespace

void reflectances(report::Chapter& chapter) {
  write_curves(chapter);
  report::Checks& checks = chapter.claims("checks");
  checks.add("surfaces that dip without reflecting a third straight on, or the reverse", wrong_about_dips(), 0.0);
  checks.add("n^ = 4: least reflectance, less 0.357778", least_of({4.0}).R - 0.357778, 1e-6);
  checks.add("Brewster's angle for n^ = 1.5: amplitude in the plane of incidence",
             r_parallel({1.5}, std::cos(brewster_angle(1.5))), 1e-15);
}

}  // namespace appB

//! @section appB_dip_results What comes of it
//!
//! @figure{appB_permeability, The same with permeabilities\, 2 (above) and 10 (below): Figure B.2.}
//!
//! @table{appB_dips}
//!
//! Permeability moves the limit: what counts is \f$ \hat n/\hat\mu \f$, the ratio of impedances upside down. Where
//! \f$ \hat n \f$ is near \f$ \hat\mu \f$ hardly anything is reflected straight on, whatever its size; where it is far
//! below, R dips again.
//!
//! @figure{appB_polarized, The two polarizations apart\, for n^ = 1.5 and n^ = 10: at Brewster's angle one of them is not reflected.}
//!
//! @section appB_dip_exercises Exercises
//!
//! 1. Derive \f$ c_4 \f$. Why can there be no term \f$ c_2 \sin^2\theta \f$, for any \f$ \hat\mu \f$?
//! 2. Where is the least R in the limit \f$ \hat n \to \infty \f$, and how deep is the dip there?
//! 3. Show that for \f$ \hat\mu = \hat n \f$ a surface in normal incidence is invisible. Is it at a slant?
