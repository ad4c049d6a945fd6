//! @page ch09_scattering Chapter 9: Light in a cloud of scatterers
//! @brief Rays of a beam meet a thousand scatterers: what comes through, what comes back, and what stays.
//! @tableofcontents
//!
//! @section ch09_question A beam meets a cloud
//!
//! Chapter 9 of the monograph @cite zohdi2007 sends light through clouds of particles. A beam is many rays; each is
//! reflected where it meets a scatterer, which absorbs the rest of its power.
//!
//! @figure{ch09_system, The system: a beam of parallel rays\, and a cube with a thousand scatterers. Figures 9.1 and 9.3.}
//!
//! What is asked (9.1.3):
//!
//! - What does a smooth surface reflect, and what does a whole scatterer? @subpage ch09_reflectance
//! - What happens to a beam on its way? @subpage ch09_rays
//! - How much goes on, and how much comes back, against size, shape and material, and for sound? @subpage ch09_clouds
//! - How warm does a pulse make the scatterers? @subpage ch09_heat
//! - And how do they cool, or end in a beam that stays on? @subpage ch09_slow_heat
//! - Which cloud answers a beam as this one did? @subpage ch09_inverse
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch09_scattering
//! build/release/bin/ch09_scattering --out ch09 --threads 2
//! @endverbatim
//!
//! That takes about a minute and a half, with `--quick` some fifteen seconds.
//!
//! @section ch09_model Rays
//!
//! **When rays will do** (9.1.1). A ray is a fair picture where scatterers are much larger than the wavelength, some
//! ten times at least, and smooth on that scale. Diffraction, which sends as much light past an obstacle as it
//! intercepts, into a narrow cone about the beam, is then left to the beam; interference averages out among scatterers
//! at random.
//!
//! **Beams** (9.1.2). A beam of irradiance I and cross-section a is a number of parallel rays
//! (particulate::scattering::rays_of). Each carries \f$ I a/N_r \f$, the power of its part of the cross-section: a
//! number of watts, which neither spreads nor fades on the way. *Random* rays are the monograph's. Where they stand in
//! the middle of equal parts, or at random within, the same number of rays tells more.
//!
//! **Scatterers** (9.3.1) are as large as \f$ L = b/(V/N_p)^{1/3} \f$ says, radius over spacing, and stand at random
//! without overlap (particulate::scattering::place_spheres). With \f$ v_f = \tfrac43 \pi L^3 \f$ that ends near
//! \f$ L = 0.45 \f$.
//!
//! **At a hit** the ray keeps the share R of its power, and goes on as from a mirror,
//!
//! \f[ d' = d - 2\, (d \cdot n)\, n, \qquad I' = R(\hat n, \hat\mu, d \cdot n)\, I , \f]
//!
//! and the scatterer absorbs the rest. The monograph moves rays in small steps and reflects what has come to lie inside
//! of a scatterer. Here each ray is followed from one hit to the next (particulate::scattering::trace), exactly, so
//! that there is no step to choose; particulate::scattering::trace_in_steps is the other way, and the chapter's
//! verification has one converge to the other.
//!
//! **A ledger** counts all of the power (particulate::scattering::Ledger): what left through each face of the cube, and
//! what was absorbed, add up to what came in.
//!
//! @section ch09_program The program
//!
//! The parameters, and what the pages share, stand on @subpage ch09_shared.

#include "ch09_scattering.hpp"

namespace ch09 {

void run(const Parameters& p, report::Chapter& chapter) {
  reflectance_of_one(chapter);
  progress(p, chapter);
  clouds(p, chapter);
  heat(p, chapter);
  slow_heat(p, chapter);
  inverse(p, chapter);
}

}  // namespace ch09

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch09_scattering",
                              .summary = "Chapter 9: light and sound in clouds of scatterers.",
                              .out = "ch09",
                              .figures = "chapters/ch09_scattering/figures.gp"},
                             "none", ch09::run);
}

//! @section ch09_film The beam in motion
//!
//! @animation{ch09_film, Rays of the beam in the cloud\, seen from the side. The darker\, the more power a ray has.}
//!
//! @section ch09_results What held
//!
//! @table{ch09_checks}
//!
//! @table{ch09_summary}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch09}
//!
//! @section ch09_discussion Discussion
//!
//! Section 9.4 in our words, from what these pages show:
//!
//! - *The sign says what the sum hides.* A cloud of good reflectors turns the beam back; one of poor ones swallows it.
//!   Summed over forward rays alone, both clouds only let little through.
//! - *The first layers decide.* A beam is spent within a few mean free paths. Behind them scatterers might as well not
//!   be there, save for what comes through between all of them.
//! - *Absorption is a matter of hits.* In a dense cloud light of \f$ \hat n = 10 \f$ is hit several times before it
//!   gets out, and most of it is lost although a single hit takes about a third.
//! - *Shape counts by surface.* What a body is in a beam is its shadow, and a convex body in random orientation has a
//!   quarter of its surface as shadow.
//! - *A settled mean is not an exact one.* Standard errors are cheap; the look of a running mean is not a substitute.
