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

#include <cstdlib>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <particulate/laws/near_field.hpp>
#include <particulate/report/checks.hpp>
#include <particulate/report/command_line.hpp>
#include <particulate/report/stamp.hpp>
#include <particulate/report/table.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

void describe(report::CommandLine& line, Parameters& p) {
  const std::string ours = "our choice";
  line.field(p.TOL, {"tolerance", "of the sweeps, TOL", "-", report::between(1e-6, 1e-2), ours});
  line.field(p.K_d, {"desired", "contractions a step should take, K_d", "-", report::between(3, 100), ours});
  line.field(p.limit, {"limit", "Dt_lim, as a share of the pair's period", "-", report::between(1e-3, 0.1), ours});
  line.field(p.stiffness, {"stiffness", "repulsion of the steered pair, attraction 1", "N m^3/kg^2",
                           report::between(0.05, 0.6), ours});
  line.field(p.softness,
             {"softness", "repulsion where errors are looked at", "N m^3/kg^2", report::between(0.2, 0.5), ours});
  line.field(p.rough, {"rough", "Dt_lim of the run that is wrong, as a share of the period", "-",
                       report::between(0.004, 0.1), ours});
  line.field(p.springs, {"springs", "of different stiffness, in one problem", "-", report::between(1, 100), ours});
  line.field(p.sweeps, {"sweeps", "whose errors are drawn", "-", report::between(10, 60), ours});
  line.field(p.coupling, {"coupling", "a_12 = -a_21 of two decaying fields", "1/s", report::between(1.5, 20.0), ours});
  line.field(p.beyond, {"beyond", "their step over the last that contracts", "-", report::between(1.001, 2.0), ours});
  line.field(p.duration, {"duration", "of their decay", "s", report::between(1.0, 20.0), ours});
  line.field(p.mildness, {"mildness", "repulsion of the pair whose errors are looked at, attraction 1", "N m^3/kg^2",
                          report::between(0.6, 0.95), ours});
  line.field(p.closeness, {"closeness", "repulsion of the pair that passes close by, attraction 1", "N m^3/kg^2",
                           report::between(1e-3, 0.5), ours});
  line.field(p.accuracy,
             {"accuracy", "of its steps, for truncation and sweeps", "-", report::between(1e-12, 1e-4), ours});
  line.field(p.mu, {"mu", "damping of van der Pol's oscillator", "-", report::between(1.0, 1e5), "its test set"});
  line.field(p.drop, {"drop", "height that a ball falls", "m", report::between(0.01, 100.0), ours});
  line.field(p.e, {"restitution", "of the ball", "-", report::between(0.1, 0.9), "chapter 4"});
  line.field(p.periods, {"periods", "over which energy is watched", "-", report::between(20, 10000), ours});
}

//! Every page is one function, and what the run claims is kept in two tables, of the first three and of the last three.

int run(int argc, char** argv) {
  Parameters p;
  report::CommandLine line(
      {.name = "ch03_schemes",
       .summary = "Chapter 3: implicit steps, their sweeps, their control, staggered fields, high order.",
       .out = "ch03"});
  describe(line, p);
  if (const std::optional<int> status = line.parse(argc, argv)) return *status;
  const report::Output output(line.common().out);
  const bool quick = line.common().quick;

  report::Checks checks;
  stability(p, output, quick, checks);
  control(p, output, checks);
  staggering(p, output, checks);
  output.write("checks", checks.table());

  report::Checks of_family;
  family(p, output, quick, of_family);
  stiffness_and_errors(p, output, of_family);
  contacts(p, output, quick, of_family);
  output.write("family_checks", of_family.table());

  line.write_parameters();
  const std::string kernel(laws::name(laws::best_kernel()));
  report::write_stamp(output.folder(), report::make_stamp(line.line(), line.common().seed, kernel));
  fmt::print("{}\n{}", checks.table().text(), of_family.table().text());
  return checks.all_hold() && of_family.all_hold() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace ch03

int main(int argc, char** argv) {
  return particulate::report::guarded("ch03_schemes", [&] { return ch03::run(argc, argv); });
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
