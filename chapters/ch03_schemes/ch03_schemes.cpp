//! @page ch03_schemes Chapter 3: Iterative solution schemes
//! @brief Implicit steps solved by sweeps: when the sweeps contract, and how that chooses the step.
//! @tableofcontents
//!
//! @section ch03_question What a step costs, and what it may be
//!
//! Chapter 3 of the monograph @cite zohdi2007 moves the particles of the first two chapters in time. Its schemes are
//! implicit: the forces that move a particle over a step are those at the end of the step, which nobody knows yet. So
//! they are guessed, the step is made, the forces are taken where it ended, and the step is made again. One such pass
//! over all particles is a *sweep*. The chapter's idea is to let the sweeps choose the step: if they settle too slowly
//! the step was too long, if they settle at once it could have been longer.
//!
//! Five questions follow, a page each, in the order in which the program asks them:
//!
//! - What does implicitness buy, if it is solved by sweeps, and how fast do they settle? @subpage ch03_stability
//! - What does a step that is steered by them promise about the answer, and what not? @subpage ch03_control
//! - What changes when several fields are solved in turn (7.5.1, 7.5.2)? @subpage ch03_staggering
//! - What do the same sweeps do at high order? @subpage ch03_family, and with stiffness and two errors to look at,
//!   @subpage ch03_errors
//! - When did it happen? @subpage ch03_contacts
//!
//! Build and run them all with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch03_schemes
//! build/release/bin/ch03_schemes --out ch03
//! @endverbatim
//!
//! It takes some seconds. Every parameter below is an option (`--help` lists them), a run writes the `parameters.toml`
//! that repeats it, and the exit status says whether every check at the end of this page held.
//!
//! @section ch03_program The program
//!
//! The parameters, and the few problems and helpers that the pages share, stand on @subpage ch03_shared.

#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! Every page is one function, and what the run claims is kept in two tables, of the first three and of the last three.

void run(const Parameters& p, report::Chapter& chapter) {
  const report::Output& output = chapter.output();
  const bool quick = chapter.common().quick;

  report::Checks& checks = chapter.claims("checks");
  stability(p, output, quick, checks);
  control(p, output, checks);
  staggering(p, output, checks);

  report::Checks& of_family = chapter.claims("family_checks");
  family(p, output, quick, of_family);
  stiffness_and_errors(p, output, of_family);
  contacts(p, output, quick, of_family);
}

}  // namespace ch03

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(
      argc, argv,
      {.name = "ch03_schemes",
       .summary = "Chapter 3: implicit steps, their sweeps, their control, staggered fields, high order.",
       .out = "ch03",
       .figures = "chapters/ch03_schemes/figures.gp"},
      laws::name(laws::best_kernel()), ch03::run);
}

//! @section ch03_results What held
//!
//! Where an identity is claimed, the allowance is rounding, magnified by what stands between: a step near the pole of
//! an implicit scheme, a contraction measured as a ratio of small changes of numbers of size one. The staggered runs
//! stop at TOL in each of their steps, so their sum may be off by many TOL.
//!
//! @table{ch03_checks}
//!
//! Of the family, orders are claimed from both sides:
//!
//! @table{ch03_family_checks}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch03}
