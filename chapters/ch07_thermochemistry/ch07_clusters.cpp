//! @page ch07_clusters Chapter 7: Clusters
//! @brief What hangs together at the end, how large it is, and how deep stepped contact lets it sink.
//! @tableofcontents
//!
//! @section ch07_clusters_question What hangs together
//!
//! Two spheres are linked up to a distance of their centres that the parameters state; a cluster is what hangs together
//! by links (particulate::thermo::find_clusters).
//!
//! @figure{ch07_structures, The largest cluster of the cloud with bonds at its end\, in full colour\, and what is about it: Figure 7.11. Colour: temperature\, as before.}
//!
//! @section ch07_clusters_program The program

#include <algorithm>

#include <fmt/format.h>

#include <particulate/kinematics/momentum.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/thermo/clusters.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {
namespace {

Eigen::Index number_of_largest(const thermo::Clusters& clusters) {
  return std::max_element(clusters.sizes.begin(), clusters.sizes.end()) - clusters.sizes.begin();
}

double gyration_of_largest(const Flight& flight) {
  std::vector<Eigen::Index> members;
  for (std::size_t i = 0; i < flight.linked.of.size(); ++i) {
    if (flight.linked.of[i] == number_of_largest(flight.linked)) members.push_back(static_cast<Eigen::Index>(i));
  }
  const kinematics::Vectors places = positions(flight.end);
  return kinematics::radius_of_gyration(places(members, Eigen::all));
}

void write_clusters(const std::vector<Flight>& starts, report::Chapter& chapter) {
  report::Table table({"bonds", "seed", "linked spheres [-]", "links a sphere [-]", "clusters", "largest",
                       "its gyration [m]", "deepest overlap / diameter [-]"});
  for (const Flight& one : starts) {
    const thermo::Clusters& linked = one.linked;
    const auto alone = std::count(linked.sizes.begin(), linked.sizes.end(), 1);
    table.add({yes_or_no(one.bonds), one.seed, linked.linked_share(),
               static_cast<double>(linked.links) / static_cast<double>(linked.of.size()),
               static_cast<long>(linked.sizes.size()) - alone, linked.largest(), gyration_of_largest(one),
               one.outcome.penetration});
  }
  chapter.output().write("clusters", table);
  const double deepest = report::spread_over(starts, [](const Flight& one) { return one.outcome.penetration; }).largest;
  if (deepest > 0.1) {
    chapter.note(
        fmt::format("with steps of {:.3g} s spheres enter each other by up to {:.2g} of a diameter, more than "
                    "a tenth: lower --step for less.",
                    starts.front().step, deepest));
  }
}

//! @section ch07_sinking How deep they sink
//!
//! A contact that is found at the end of a step comes late. By then spheres have entered each other by their speed
//! times the step, and what presses on a cluster keeps them there. So the first start, with bonds, is flown with other
//! steps:

void compare_steps(const Parameters& p, const std::vector<Flight>& all, report::Chapter& chapter) {
  report::Table table({"step [s]", "deepest overlap / diameter [-]", "the same at the end [-]",
                       "relative energy [J/kg]", "mean temperature [K]", "impacts"});
  std::vector<Flight> flights;
  for (const double share : steps) {
    flights.push_back(those(all, [&](const Flight& one) {
                        return one.seed == seed_of(p, 0) && one.bonds && !one.softens && one.kappa == p.kappa &&
                               one.step == share * p.step;
                      }).front());
    const Flight& one = flights.back();
    table.add({one.step, one.outcome.penetration, one.left, one.relative, theta_0 + one.rise, one.outcome.impacts});
  }
  chapter.output().write("steps", table);
  claim_of_own(p, chapter, "deepest overlap with an eighth of the longest step, over that with it",
               flights.back().outcome.penetration / flights.front().outcome.penetration, 0.2);
  flights.pop_back();
  const report::Spread warm = report::spread_over(flights, [](const Flight& one) { return theta_0 + one.rise; });
  claim_of_own(p, chapter, "mean temperature with steps of 2 Dt, Dt and Dt/2, its range over its median",
               (warm.largest - warm.least) / warm.median, 0.01);
}

//! Places are drawn about the centre of the cloud.

void write_places(const std::vector<Flight>& watched, const report::Output& output) {
  report::Table places(
      {"bonds", "picture", "time [s]", "x [m]", "y [m]", "z [m]", "temperature [K]", "in the largest"});
  for (const Flight& one : watched) {
    for (std::size_t k = 0; k < one.moments.size(); ++k) {
      const kinematics::Vectors r = positions(one.moments[k]);
      const Eigen::RowVector3d centre = r.colwise().mean();
      for (Eigen::Index i = 0; i < r.rows(); ++i) {
        const Eigen::RowVector3d at = r.row(i) - centre;
        const bool is_in = one.linked.of[static_cast<std::size_t>(i)] == number_of_largest(one.linked);
        places.add(
            {yes_or_no(one.bonds), k, one.moments[k].t, at[0], at[1], at[2], one.moments[k].y[i], is_in ? 1 : 0});
      }
    }
  }
  output.write("places", places);
}

}  // namespace

void clusters(const Parameters& p, const std::vector<Flight>& all, report::Chapter& chapter) {
  write_clusters(
      those(all, [&](const Flight& one) { return !one.softens && one.kappa == p.kappa && one.step == p.step; }),
      chapter);
  compare_steps(p, all, chapter);
  write_places(those(all, [](const Flight& one) { return one.watched; }), chapter.output());
}

}  // namespace ch07

//! @section ch07_clusters_results Sizes
//!
//! @table{ch07_clusters}
//!
//! With bonds nearly every sphere is linked to another at the end. Clusters are chains and clumps of a few to many
//! dozens; how large the largest is depends on the start more than anything else on these pages, as one bond joins two
//! clusters. Without bonds spheres are linked because they happen to be near, mostly in pairs that are about to part.
//!
//! @section ch07_sinking_results Overlap
//!
//! @table{ch07_steps}
//!
//! The deepest overlap goes with the step, in clusters and outside alike: the last column of the other table shows that
//! flights without bonds enter as deep, by their fast first impacts. What remains at the end lies within clusters:
//! nothing pushes apart what rests in each other, as a contact takes an approach away and not an overlap. A program
//! warns where a flight exceeds a tenth of a diameter. Energy and temperature hardly depend on it, by less than on the
//! start, and with backward Euler, which damps the swings of a bond, there would be more of both clusters and overlap.
//!
//! @section ch07_clusters_exercises Exercises
//!
//! 1. Take `--link 0.055` and 0.08. Which columns depend on it, and why does the share of linked spheres hardly?
//! 2. How many links may a sphere in a clump have at most, and how many have those of a chain? What do the numbers of
//!    the table tell of the clusters' shape?
//! 3. Give bonds a strength at touching: add a constant to the shape \f$ W \f$. How deep do spheres sink then?
