//! @page ch08_fluid Chapter 8: A fluid, and particles in it
//! @brief A compressible, viscous fluid on a grid, by itself and with hot particles that stir it.
//! @tableofcontents
//!
//! @section ch08_question Particles are not alone
//!
//! So far particles flew through nothing. Chapter 8 of the monograph @cite zohdi2007 puts them into a fluid that they
//! drag along, and that drags them. It takes that apart: the fluid is pushed at the places of particles by forces that
//! are opposite to those that move the particles (8.1.1).
//!
//! @figure{ch08_decomposition, What particles and fluid do to each other\, taken apart: Figure 8.1.}
//!
//! All that happens in a small part of a larger flow, which stands for the whole. What leaves it on one side comes in
//! on the other, particles and fluid alike.
//!
//! @figure{ch08_element, A representative element\, cut out of a flow: Figure 8.2.}
//!
//! What is asked:
//!
//! - What does the fluid do by itself? @subpage ch08_flow
//! - Which step does it allow, and what do the monograph's sweeps cost? @subpage ch08_steps
//! - What does it do to a sphere? @subpage ch08_drag
//! - What do many hot particles and the fluid do to each other? @subpage ch08_element
//! - Which step, and which cells, do both together need? @subpage ch08_particle_steps
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch08_fluid
//! build/release/bin/ch08_fluid --out ch08 --threads 2
//! @endverbatim
//!
//! That takes two or three minutes on two cores, and some seconds with `--quick`.
//!
//! @section ch08_program The program
//!
//! The parameters, and what the pages share, stand on @subpage ch08_shared.

#include <particulate/laws/near_field.hpp>

#include "ch08_fluid.hpp"

namespace ch08 {

void run(const Parameters& p, report::Chapter& chapter) {
  flow_alone(p, chapter);
  steps(p, chapter);
  drag(p, chapter);
  element_with_particles(p, chapter);
  steps_with_particles(p, chapter);
}

}  // namespace ch08

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch08_fluid",
                              .summary = "Chapter 8: particles in a fluid.",
                              .out = "ch08",
                              .figures = "chapters/ch08_fluid/figures.gp"},
                             laws::name(laws::best_kernel()), ch08::run);
}

//! @section ch08_film A flow in motion
//!
//! @animation{ch08_film, Sixteen vortices\, and what becomes of them. Colour: vorticity.}
//!
//! @section ch08_results What held
//!
//! @table{ch08_checks}
//!
//! @table{ch08_summary}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch08}
