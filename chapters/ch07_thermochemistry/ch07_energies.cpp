//! @page ch07_energies Chapter 7: Energy and heat of bound clouds
//! @brief The same clouds with and without bonds, with four reactions: energy and temperature, over several starts.
//! @tableofcontents
//!
//! @section ch07_energies_question With bonds and without
//!
//! A cloud of chapter 4 is followed with bonds and without them, and each with four reactions, whose energy per area
//! \f$ \kappa \f$ doubles from one to the next. The monograph draws kinetic energy and mean temperature in time.
//!
//! @figure{ch07_snapshots, Halfway and at the end\, about the centre and seen along z: with bonds (above\, Figure 7.5) and without (below\, Figure 7.6). Colour: temperature\, from 300 K (blue) to 400 K and above (red).}
//!
//! @section ch07_energies_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>

#include <fmt/format.h>

#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/binding.hpp>
#include <particulate/thermo/clusters.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {
namespace {

//! One flight. Nothing but impacts changes a temperature, so that velocity Verlet carries it as it does in chapter 4.

template <class R>
void fly(const Parameters& p, const R& restitution, Flight& flight) {
  const double side = std::cbrt(particles_of(p) / 1000.0);
  const Eigen::Vector3d mean{1.0, 0.1, 0.1};
  const kinematics::Particles cloud =
      cloud_in({.lengths = Eigen::Vector3d::Constant(side)}, particles_of(p), mean, mean, p.c, flight.seed);
  const scenes::Scene scene(cloud, kinematics::Space{}, near_field,
                            thermo::Binding{.F_b = flight.bonds ? p.F_b : 0.0, .d_b = p.d_b}, contact_with(restitution),
                            thermo::ImpactHeat{.kappa = flight.kappa, .J_star = p.J_star});
  scenes::History history(scene, evenly(100, p.duration));
  const auto keep = [&](const schemes::State& at) {
    if (flight.watched) flight.moments.push_back(at);
  };
  flight.end = start(scene);
  flight.outcome =
      integrate(scene, flight.end, p.duration, schemes::VelocityVerlet{}, schemes::FixedStep{.step = flight.step},
                schemes::Sampling(evenly(30, p.duration), keep, std::ref(history)));
  require_end(flight.outcome);
  flight.history = history.rows();
  flight.relative = kinematics::split_kinetic_energy(cloud.mass, velocities(flight.end)).relative;
  flight.deepest = flight.outcome.penetration;
  flight.left = scene.overlap(flight.end).deepest / (2.0 * radius);
  flight.rise = flight.end.y.mean() - theta_0;
  flight.linked = thermo::find_clusters(scene.domain(), positions(flight.end), p.link);
}

void fly(const Parameters& p, Flight& flight) {
  if (!flight.softens) return fly(p, cold, flight);
  fly(p, contact::SofteningRestitution{.cold = cold, .theta_r = theta_0, .theta_star = p.theta_star}, flight);
}

//! All flights of the page: every start with and without bonds, with and without softening, and with bonds and other
//! steps; of the first start all reactions.

constexpr std::array<double, 4> shares{0.125, 0.25, 0.5, 1.0};

std::vector<Flight> fly_all(const Parameters& p) {
  std::vector<Flight> all;
  for (int k = 0; k < seeds_of(p); ++k) {
    for (const double share : shares) {
      if (k > 0 && share < 1.0) continue;
      for (const bool bonds : {true, false}) {
        for (const bool softens : {false, true}) {
          all.push_back({.seed = seed_of(p, k),
                         .kappa = share * p.kappa,
                         .step = p.step,
                         .bonds = bonds,
                         .softens = softens,
                         .watched = k == 0 && share == 1.0 && !softens});
        }
      }
    }
    for (const double share : steps) {
      if (share != 1.0) all.push_back({.seed = seed_of(p, k), .kappa = p.kappa, .step = share * p.step});
    }
  }
  report::for_each_run("clouds", static_cast<int>(all.size()), p.line.common().threads,
                       [&](int k) { fly(p, all[static_cast<std::size_t>(k)]); });
  return all;
}

//! Energy and temperature in time, and what four reactions come to:

void write_reactions(const std::vector<Flight>& first, const report::Output& output) {
  report::Table energies(
      {"bonds", "softens", "kappa [J/m^2]", "time [s]", "kinetic energy [J/kg]", "mean temperature [K]"});
  report::Table reactions({"bonds", "softens", "kappa [J/m^2]", "released [J]", "relative energy [J/kg]",
                           "rise of temperature [K]", "hottest [K]"});
  for (const Flight& flight : first) {
    for (Eigen::Index row = 0; row < flight.history.rows(); ++row) {
      const Eigen::VectorXd at = flight.history.row(row);  // time, bulk, relative, ... temperature
      energies.add(
          {yes_or_no(flight.bonds), yes_or_no(flight.softens), flight.kappa, at[0], at[1] + at[2], at[at.size() - 1]});
    }
    reactions.add({yes_or_no(flight.bonds), yes_or_no(flight.softens), flight.kappa, flight.outcome.released,
                   flight.relative, flight.rise, flight.end.y.maxCoeff()});
  }
  output.write("energies", energies);
  output.write("reactions", reactions);
}

//! Without softening nothing asks for a temperature. So the four flights must be one flight, bit for bit, and each
//! impact release what is proportional to \f$ \kappa \f$. With any softening heat is what impacts took and released.

bool same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

void check_reactions(const std::vector<Flight>& first, report::Checks& checks) {
  double other = 0.0, off = 0.0, books = 0.0;
  for (const bool bonds : {true, false}) {
    const std::vector<Flight> four =
        those(first, [&](const Flight& one) { return one.bonds == bonds && !one.softens; });
    for (const Flight& one : four) {
      const bool same = same_bits(one.end.r, four[0].end.r) && same_bits(one.end.v, four[0].end.v) &&
                        same_bits(one.history.leftCols(3), four[0].history.leftCols(3));
      other += same ? 0.0 : 1.0;
      off = worse_of(off, std::abs(one.outcome.released / four[0].outcome.released * four[0].kappa / one.kappa - 1.0));
    }
  }
  for (const Flight& one : first) {
    books = worse_of(books, std::abs(one.outcome.heat / (one.outcome.released - one.outcome.energy_change) - 1.0));
  }
  checks.add("flights with another kappa, not softened, whose places, velocities or energies differ in a bit", other,
             0.0);
  checks.add("energy released over kappa, not softened, relative to that of the smallest kappa", off, 1e-13);
  checks.add("heat of all impacts over what they took and released, less one", books, 1e-12);
}

//! Start by start: the energy that is left, and the temperature.

void compare_starts(const Parameters& p, const std::vector<Flight>& loose, const std::vector<Flight>& bound,
                    report::Chapter& chapter) {
  report::Table starts({"seed", "relative energy without bonds [J/kg]", "with [J/kg]", "ratio [-]", "rise without [K]",
                        "with [K]", "ratio of rises [-]"});
  double ratio = 0.0, not_doubled = 0.0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    const double of_energies = bound[k].relative / loose[k].relative, of_rises = bound[k].rise / loose[k].rise;
    starts.add(
        {bound[k].seed, loose[k].relative, bound[k].relative, of_energies, loose[k].rise, bound[k].rise, of_rises});
    ratio = worse_of(ratio, of_energies);
    not_doubled += of_rises >= 2.0 ? 0.0 : 1.0;
  }
  chapter.output().write("starts", starts);
  claim_of_own(p, chapter, "largest ratio of relative energies, with bonds over without", ratio, 0.7);
  claim_of_own(p, chapter, "starts in which bonds do not double the rise of temperature", not_doubled, 0.0);
}

//! Softening is judged by what starts differ in anyhow: within two of their deviations, one start cannot tell.

void compare_softening(const Parameters& p, const std::vector<Flight>& all, report::Chapter& chapter) {
  report::Table softening({"bonds", "relative energy, mean of all starts [J/kg]", "scatter of starts [J/kg]",
                           "more with softening, mean [J/kg]", "scatter of that [J/kg]"});
  for (const bool bonds : {true, false}) {
    const Eigen::VectorXd energy = numbers_of(alike(p, all, bonds, false), &Flight::relative);
    const Eigen::VectorXd more = numbers_of(alike(p, all, bonds, true), &Flight::relative) - energy;
    softening.add({yes_or_no(bonds), energy.mean(), scatter_of(energy), more.mean(), scatter_of(more)});
    claim_of_own(p, chapter,
                 fmt::format("mean difference that softening makes {} bonds, over the scatter of starts",
                             bonds ? "with" : "without"),
                 more.mean() / scatter_of(energy), 2.0);
  }
  chapter.output().write("softening", softening);
}

}  // namespace

std::vector<Flight> energies(const Parameters& p, report::Chapter& chapter) {
  std::vector<Flight> all = fly_all(p);
  const std::vector<Flight> first =
      those(all, [&](const Flight& one) { return one.seed == seed_of(p, 0) && one.step == p.step; });
  write_reactions(first, chapter.output());
  check_reactions(first, chapter.claims("checks"));
  compare_starts(p, alike(p, all, false, false), alike(p, all, true, false), chapter);
  compare_softening(p, all, chapter);
  chapter.summary().add({"spheres of a cloud", particles_of(p)});
  chapter.summary().add({"impacts in the first start with bonds", alike(p, all, true, false).front().outcome.impacts});
  chapter.summary().add({"and without", alike(p, all, false, false).front().outcome.impacts});
  return all;
}

}  // namespace ch07

//! @section ch07_energies_results What comes of it
//!
//! @figure{ch07_energy, Kinetic energy per unit mass\, with bonds (above: Figure 7.7) and without (below: Figure 7.8). Broad: not softened\, four curves in one. Thin: softened\, one for each reaction.}
//!
//! Kinetic energy rises and falls as the cloud breathes: near neighbours repel, the cloud as a whole attracts. Bonds take
//! from that. Two spheres that come near fall into their bond, hit, lose energy and stay; then they share one motion.
//! Start by start the relative energy that is left at the end is much smaller with bonds. By how much depends on where in
//! its breath the cloud then is, and so on the number of its spheres:
//!
//! @table{ch07_starts}
//!
//! @figure{ch07_temperature, Mean temperature\, with bonds (above: Figure 7.9) and without (below: Figure 7.10)\, not softened (full) and softened (broken).}
//!
//! Temperatures rise with the number of impacts, of which a bound cloud has many times as many: a sphere in a cluster
//! hits its neighbours again and again. Nearly all of this heat is chemical. Of the energies per area that a reaction
//! sets free even the smallest is far beyond what an impact takes from the motion, so that temperatures are
//! proportional to \f$ \kappa \f$ as closely as a figure can show.
//!
//! @table{ch07_reactions}
//!
//! @subsection ch07_back Does heat act back?
//!
//! Without softening it does not. **The four curves of Figure 7.7 coincide bit for bit, and so do those of Figure
//! 7.8**: places, velocities and energies, compared as the bytes that they are. No force and no impact asks for a
//! temperature, and a reaction adds nothing to motion. If the monograph's curves differ, as drawn curves would, its
//! heat must act on something, and softening restitution is our guess of what. With it the curves part, by no more than
//! those of two starts:
//!
//! @table{ch07_softening}
//!
//! An impact that happens a little otherwise makes another cloud a little later. So one start cannot tell what
//! softening does. The mean over many can, and it finds less than the scatter.
//!
//! @section ch07_energies_exercises Exercises
//!
//! 1. How much would the mean temperature rise if all relative energy of the start became heat? Compare with the table.
//! 2. Take `--bond_strength 50` and 300. Does the rise of temperature follow the strength, or the number of impacts?
//! 3. Take `--impulse 1`. Are temperatures still proportional to \f$ \kappa \f$? What becomes of gentle impacts?
//! 4. Let spheres grow sticky as they warm: make \f$ F_b \f$ depend on temperature. Of which kind of problem is the
//!    scene then, and which schemes may solve it?
