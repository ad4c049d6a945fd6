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

void write_clusters(std::vector<Flight> starts, const std::vector<Flight>& loose, report::Chapter& chapter) {
  starts.insert(starts.end(), loose.begin(), loose.end());
  report::Table table({"bonds", "seed", "linked spheres [-]", "links a sphere [-]", "clusters", "largest",
                       "its gyration [m]", "deepest overlap / diameter [-]"});
  for (const Flight& one : starts) {
    const thermo::Clusters& linked = one.linked;
    const auto alone = std::count(linked.sizes.begin(), linked.sizes.end(), 1);
    table.add({yes_or_no(one.bonds), one.seed, linked.linked_share(),
               static_cast<double>(linked.links) / static_cast<double>(linked.of.size()),
               static_cast<long>(linked.sizes.size()) - alone, linked.largest(), gyration_of_largest(one),
               one.deepest});
  }
  chapter.output().write("clusters", table);
  const double deepest = report::spread_over(starts, &Flight::deepest).largest;
  if (deepest > 0.1) {
    chapter.note(
        fmt::format("with steps of {:.3g} s spheres enter each other by up to {:.2g} of a diameter, more than "
                    "a tenth: lower --step for less.",
                    starts.front().step, deepest));
  }
}

//! @section ch07_sinking How deep they sink
//!
//! A contact that is found at the end of a step comes late. By then spheres have entered each other by their speed times
//! the step, and what presses on a cluster keeps them there. So all starts, with bonds, are flown with other steps:

void compare_steps(const Parameters& p, const std::vector<Flight>& all, report::Chapter& chapter) {
  report::Table table({"step [s]", "deepest overlap / diameter [-]", "the same at the end [-]",
                       "relative energy, mean of starts [J/kg]", "its scatter [J/kg]", "rise of temperature, mean [K]",
                       "its scatter [K]"});
  std::vector<double> deepest, warm;
  for (const double share : steps) {
    const std::vector<Flight> flights = those(all, [&](const Flight& one) {
      return one.bonds && !one.softens && one.kappa == p.kappa && one.step == share * p.step;
    });
    const Eigen::VectorXd energy = numbers_of(flights, &Flight::relative), rise = numbers_of(flights, &Flight::rise);
    deepest.push_back(numbers_of(flights, &Flight::deepest).maxCoeff());
    warm.push_back(theta_0 + rise.mean());
    table.add({share * p.step, deepest.back(), numbers_of(flights, &Flight::left).maxCoeff(), energy.mean(),
               scatter_of(energy), rise.mean(), scatter_of(rise)});
  }
  chapter.output().write("steps", table);
  claim_of_own(p, chapter, "deepest overlap with a quarter of the longest step, over that with it",
               deepest.back() / deepest.front(), 0.4);
  const report::Spread spread = report::spread_of(warm);
  claim_of_own(p, chapter, "mean temperature with steps of 2 Dt, Dt and Dt/2, its range over its median",
               (spread.largest - spread.least) / spread.median, 0.01);
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
  write_clusters(alike(p, all, true, false), alike(p, all, false, false), chapter);
  compare_steps(p, all, chapter);
  write_places(those(all, [](const Flight& one) { return one.watched; }), chapter.output());
}

}  // namespace ch07

//! @section ch07_clusters_results Sizes
//!
//! @table{ch07_clusters}
//!
//! With bonds most spheres are linked to another at the end, in chains and clumps of all sizes. How large the largest
//! is depends on the start more than anything else on these pages, as one bond joins two clusters. Without bonds
//! spheres are linked because they happen to be near, mostly in pairs that are about to part.
//!
//! @section ch07_sinking_results Overlap
//!
//! @table{ch07_steps}
//!
//! The deepest overlap goes with the step. It is made by impacts that are seen late, with bonds and without: compare the
//! last column of the other table. What remains at the end is less, and lies within clusters, where nothing pushes apart
//! what rests in each other. The program warns where a flight exceeds a tenth of a diameter. Energy and temperature
//! move with the step by no more than about what starts differ in.
//!
//! @section ch07_clusters_exercises Exercises
//!
//! 1. Take `--link 0.055` and 0.08. Which columns depend on it, and why does the share of linked spheres hardly?
//! 2. How many links may a sphere in a clump have at most, and how many have those of a chain? What do the numbers of
//!    the table tell of the clusters' shape?
//! 3. Fly the cloud by backward Euler, as in chapter 4. It damps the swings of a bond: does it exaggerate clusters?
//! 4. Give bonds a strength at touching: add a constant to the shape \f$ W \f$. How deep do spheres sink then?
