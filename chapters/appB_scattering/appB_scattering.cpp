//! @page appB_scattering Appendix B: More on scattering
//! @brief Reflectance with permeability, light through red blood cells, and sound against a solid.
//! @tableofcontents
//!
//! @section appB_question What is added to chapter 9
//!
//! Appendix B of the monograph @cite zohdi2007 has three additions to @ref ch09_scattering "chapter 9".
//!
//! @figure{appB_system, A beam of parallel rays\, and a cube with 8000 red blood cells\, of which those at half height are drawn\, as a plane cuts them: Figure B.3.}
//!
//! - How does reflectance depend on angle, index and permeability? @subpage appB_reflectance
//! - What do thousands of red blood cells leave of a beam? @subpage appB_cells
//! - Where does sound go that meets a solid? @subpage appB_sound
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target appB_scattering
//! build/release/bin/appB_scattering --out appB --threads 2
//! @endverbatim
//!
//! That takes some ten seconds, with `--quick` three.
//!
//! @section appB_program The program
//!
//! The parameters, and what the pages share, stand on @subpage appB_shared.

#include "appB_scattering.hpp"

namespace appB {

void run(const Parameters& p, report::Chapter& chapter) {
  reflectances(chapter);
  cells(p, chapter);
  sound(chapter);
}

}  // namespace appB

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "appB_scattering",
                              .summary = "Appendix B: reflectance, light through blood cells, sound against a solid.",
                              .out = "appB",
                              .figures = "chapters/appB_scattering/figures.gp"},
                             "none", appB::run);
}

//! @section appB_results What held
//!
//! @table{appB_checks}
//!
//! @table{appB_summary}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{appB}
