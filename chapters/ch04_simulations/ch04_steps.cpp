//! @page ch04_steps Chapter 4: How much of it is the step
//! @brief The same clouds with smaller steps, by another scheme, and with located contacts: which differences are physics.
//! @tableofcontents
//!
//! Two things go wrong with a step that is too long. Backward Euler damps whatever swings, however well its sweeps have
//! converged. And a contact at the end of a step comes late: spheres have entered each other, and may have passed. The
//! first is looked at by a scheme that damps nothing, Verlet's; the second by contacts that end the step where they
//! happen.
//!
//! @section ch04_steps_program The program

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/contact/hard_spheres.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/report/checks.hpp>
#include <particulate/report/spread.hpp>

#include "ch04_simulations.hpp"

namespace ch04 {

//! Without a near field there is nothing to integrate between two impacts. So we follow case (1) once more as a gas of
//! hard spheres, which flies from impact to impact and knows no step: @ref ch04_gas "its page" says how.

void add_gas(const Parameters& p, const kinematics::Particles& cloud, report::Table& ends) {
  contact::HardSpheres gas(cloud, kinematics::Space{}, restitution_of(p), friction_of(p));
  schemes::State state = start(gas);
  const schemes::Outcome outcome = gas.advance(state, p.duration);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
  const kinematics::KineticEnergy energy = kinematics::split_kinetic_energy(cloud.mass, velocities(state));
  ends.add({near_fields[0].name, "hard spheres", report::Cell(), energy.relative, outcome.overlap / cloud.radius[0],
            outcome.impacts, report::Cell()});
}

//! Steps are halved three times. Of located contacts there is no step to choose: the error of each is held below
//! `--accuracy`.

void steps(const Parameters& p, Journal& journal, report::Chapter& chapter, report::Checks& checks) {
  report::Table ends(
      {"case", "way", "limit of the step [s]", "relative [J/kg]", "overlap / radius [-]", "impacts", "evaluations"});
  report::Table limits({"case", "time [s]", "relative [J/kg]"});
  const double b = journal.cloud().radius[0];
  double overlap = 0.0, off_books = 0.0;
  const auto add = [&](const Followed& run) {
    const bool located = run.run.way == Way::located;
    ends.add({near_fields[run.run.near_field].name, ways[static_cast<std::size_t>(run.run.way)],
              located ? report::Cell() : report::Cell(run.run.limit), run.last("relative"), run.outcome.overlap / b,
              run.outcome.impacts, run.outcome.evaluations});
  };
  for (std::size_t k = 0; k < near_fields.size(); ++k) {
    for (const Way way : {Way::backward_euler, Way::verlet}) {
      for (int halvings = 0; halvings < 4; ++halvings) { add(journal.follow({k, way, p.limit / (1 << halvings)})); }
    }
    const Followed& located = journal.follow({k, Way::located, 0.0});
    add(located);
    if (k == 0) add_gas(p, journal.cloud(), ends);
    overlap = report::worse_of(overlap, located.outcome.overlap / b);
    const auto books = [&](Eigen::Index row) {
      return located.column("bulk", row) + located.column("relative", row) + located.column("potential", row) +
             located.column("lost", row);
    };
    double off = 0.0, size = 0.0;
    for (Eigen::Index row = 0; row < located.history.rows(); ++row) {
      off = report::worse_of(off, std::abs(books(row) - books(0)));
      size = report::worse_of(size, located.column("relative", row) + std::abs(located.column("potential", row)));
      limits.add({near_fields[k].name, located.column("time", row), located.column("relative", row)});
    }
    off_books = report::worse_of(off_books, off / (size * static_cast<double>(located.outcome.steps)));
  }
  chapter.output().write("ends", ends);
  chapter.output().write("limits", limits);
  checks.add("located contacts: deepest overlap over the radius", overlap, 1e-10);
  checks.add("located contacts: error of the books in a step, over relative and potential energy", off_books,
             p.accuracy);

  const Followed& longest = journal.follow({p.watched - 1U, Way::backward_euler, p.limit});
  const Followed& watched = journal.follow({p.watched - 1U, Way::located, 0.0});
  report::Table& summary = chapter.summary();
  summary.add({"spheres", journal.cloud().size()});
  summary.add({"impacts, located, of the watched case", watched.outcome.impacts});
  summary.add({"relative energy at the end, located [J/kg]", watched.last("relative")});
  summary.add({"the same by backward Euler at the limit of the step [J/kg]", longest.last("relative")});
  summary.add({"deepest overlap there, as a share of the radius", longest.outcome.overlap / b});
  if (!(longest.outcome.overlap < 0.1 * b)) {
    chapter.note(
        fmt::format("with steps of {:.3g} s spheres enter each other by up to {:.2g} of their radius: the page says "
                    "what becomes of the results; lower --limit for less.",
                    p.limit, longest.outcome.overlap / b));
  }
}

}  // namespace ch04

//! @section ch04_steps_results What is left of the differences
//!
//! @figure{ch04_steps, Relative energy at the end against the limit of the step\, for the four near fields: backward Euler (full)\, Verlet (broken)\, with located contacts (thin lines)\, and of case (1) as a gas of hard spheres (broad line).}
//!
//! @table{ch04_ends}
//!
//! Read the figure from right to left. As steps become small, both stepped ways come near to the located one, up to the
//! scatter that single impacts make: a cloud in which one impact happens otherwise is another cloud a little later. In
//! that limit a stronger near field leaves *more* motion, because more potential has turned into it. With the step of
//! the monograph backward Euler takes so much of that away that the strongest case falls below the one before. Its sweeps
//! have converged to TOL all the same: what TOL bounds is the error of the sweeps, and nothing else.
//!
//! The column of overlaps says the same of contacts. With the longest step spheres enter each other by a large part of
//! their radius before anything is done about it; some that graze are never seen at all. With located contacts there is
//! no overlap, and the books close to what was asked of a step. The gas of hard spheres, in the last line of case (1),
//! has the impacts of the located ones, until rounding has grown, at a small part of their cost.
