// Clouds of section 7.5.3: clustering and heat, an obstacle, clouds that meet; clusters, and how deep they sink.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/contact/impulse_windows.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/clusters.hpp>

#include "spheres.hpp"

namespace verification::thermo_clouds {

using namespace particulate;

// A cloud of chapter 4 that can react, after some time.
struct Flown {
  schemes::State end;
  schemes::Outcome outcome;
  std::vector<double> energies;  // kinetic, at every step [J]
  double warming(double theta = 300.0) const { return end.y.mean() - theta; }
};
Flown fly(const kinematics::Particles& start, double F_b, const thermo::ImpactHeat& heat, double step, double t_end,
          const contact::ImpactRecorder& recorder = {}) {
  thermo::Binding binding = book_binding;
  binding.F_b = F_b;
  BookContact contact = book_contact();
  contact.recorder = recorder;
  const scenes::Scene scene(start, kinematics::Space{}, book_near_field, binding, contact, heat);
  Flown flown{.end = scenes::start(scene), .outcome = {}, .energies = {}};
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = step};
  const auto watch = [&](const schemes::State& from, const schemes::State&, double, const auto&) {
    flown.energies.push_back(kinematics::kinetic_energy(start.mass, rows_of(from.v)));
    return true;
  };
  flown.outcome = schemes::integrate(scene, flown.end, t_end, scheme, control, watch);
  require_reached(flown.outcome);
  return flown;
}

constexpr thermo::ImpactHeat strongest{.kappa = 8e6, .J_star = 0.1};
constexpr double bonds = 200.0, no_bonds = 0.0, book_step = 2.5e-3;

const Case clustering{
    {.name = "clustering_and_heat",
     .claim =
         "bonds lower the relative energy of a cloud to 0.7 of what it is without at most, and at least double its "
         "rise of temperature, whatever the seed; spheres in clusters sink into each other less the shorter the "
         "step is, and an outcome says how deep",
     .equation = "M 7.5.3",
     .reference = Reference::statistics},
    [](Rows& rows) {
      double energy = 0.0, warming = infinity, linked = 1.0;
      const std::uint64_t seeds = rows.quick() ? 2 : 8;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const kinematics::Particles start = warmed(book_cloud(1000, rows.case_seed() + seed));
        const Flown with = fly(start, bonds, strongest, book_step, 1.0);
        const Flown without = fly(start, no_bonds, strongest, book_step, 1.0);
        energy = report::worse_of(energy, relative_energy(start, with.end) / relative_energy(start, without.end));
        warming = std::min(warming, with.warming() / without.warming());
        linked = std::min(linked, thermo::find_clusters({}, rows_of(with.end.r), 0.07).linked_share());
      }
      const char* because = "the sign that the figures show, of every seed";
      rows.at_most("largest ratio of relative energies", {.limit = 0.7, .computed = energy, .because = because});
      rows.at_least("least ratio of rises of temperature", {.limit = 2.0, .computed = warming, .because = because});
      rows.at_least("least share of spheres within 0.07 m of another",
                    {.limit = 0.95, .computed = linked, .because = "nearly all are in clusters"});
    }};

// With J*, an impulse, as the scale of the reaction, and with a force instead, which makes it I* Dt.
const Case in_steps{
    {.name = "heat_against_steps",
     .claim =
         "the mean temperature of a cloud that reacts does not depend on the step, as it would if the scale of the "
         "reaction were a force; how deep clusters sink does",
     .equation = "R 7.4.1",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const kinematics::Particles start = warmed(book_cloud(1000, rows.case_seed()));
      const std::array<double, 3> steps{5e-3, 2.5e-3, 1.25e-3};
      std::vector<double> warm, by_force, depth;
      report::Table shown({"step [s]", "mean temperature [K]", "with a force of 40 N as scale [K]",
                           "largest overlap over the diameter [-]"});
      for (const double step : steps) {
        double released = 0.0;  // with a force as scale
        const auto release = [&](const contact::ImpactRecord& one) {
          released +=
              strongest.kappa * std::min(one.push / (40.0 * step), 1.0) * std::numbers::pi * std::pow(book_radius, 2);
        };
        const Flown flown = fly(start, bonds, strongest, step, 1.0, release);
        warm.push_back(flown.end.y.mean());
        by_force.push_back(warm.back() + (released - flown.outcome.released) / start.mass.dot(start.heat_capacity));
        depth.push_back(flown.outcome.penetration);
        shown.add({step, warm.back(), by_force.back(), depth.back()});
      }
      const auto spread = [](const std::vector<double>& of) {
        const auto [least, most] = std::minmax_element(of.begin(), of.end());
        return *most / *least - 1.0;
      };
      rows.at_most("spread of the mean temperature over steps of 5, 2.5 and 1.25 ms",
                   {.limit = 0.01,
                    .computed = spread(warm),
                    .because = "paths part after some impacts, seeds differ by half a percent"});
      rows.at_least(
          "the same with a force as scale",
          {.limit = 0.1, .computed = spread(by_force), .because = "a tenth and more: the defect that J* mends"});
      rows.at_least("largest overlap over the diameter, steps of 5 ms",
                    {.limit = 0.1, .computed = depth.front(), .because = "beyond a tenth it is said to be too deep"});
      for (std::size_t k = 0; k < 2; ++k) {
        rows.at_most(fmt::format("overlap at {} s over that at {} s", steps[k + 1], steps[k]),
                     {.limit = 0.8,
                      .computed = depth[k + 1] / depth[k],
                      .because = "it is what a step goes too far, but for chance"});
      }
      rows.write("heat_against_steps", shown);
    }};

const Case four_kappas{
    {.name = "heat_of_four_reactions",
     .claim = "the heat of the reaction is proportional to kappa, and where heat does not act back the motion has the "
              "same bits whatever it is",
     .equation = "M 7.5.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      const kinematics::Particles start = warmed(book_cloud(1000, rows.case_seed()));
      std::vector<Flown> flown;
      const std::array<double, 4> kappas{1e6, 2e6, 4e6, 8e6};
      for (const double kappa : kappas)
        flown.push_back(fly(start, bonds, {.kappa = kappa, .J_star = 0.1}, book_step, 0.25));
      long other_energies = 0;
      double off = 0.0;
      for (std::size_t k = 1; k < 4; ++k) {
        other_energies += flown[k].energies != flown[0].energies || flown[k].end.v != flown[0].end.v;
        off = std::max(off,
                       std::abs(flown[k].outcome.released / flown[0].outcome.released / (kappas[k] / kappas[0]) - 1.0));
      }
      rows.none("energy curves that differ in a bit from the first", other_energies, "no force knows temperatures");
      rows.at_most("farthest H over kappa from the first one's",
                   {.limit = 1e-13, .computed = off, .because = "rounding"});
      rows.at_least("H at 1e6 J/m^2 [J]",
                    {.limit = 1e3, .computed = flown[0].outcome.released, .because = "else nothing reacts"});
    }};

// What a cloud does to an obstacle that is charged or not.
contact::WindowImpulse on_obstacle(std::uint64_t seed, bool charged, double& largest_force) {
  Uniform uniform(seed);
  constexpr Eigen::Index N = 200;
  kinematics::Particles all{.position = kinematics::Vectors::Zero(N + 1, 3),
                            .velocity = 0.3 * (2.0 * random_places(uniform, N + 1).array() - 1.0),
                            .mass = Eigen::VectorXd::Constant(N + 1, book_mass),
                            .radius = Eigen::VectorXd::Constant(N + 1, book_radius),
                            .immovable = std::vector<bool>(N + 1, false)};
  all.velocity.col(0).array() += 3.0;
  all.position.topRows(N) = kinematics::random_addition(all.radius.head(N), {}, [&] { return uniform(); }).position;
  all.position.row(N) << 1.35, 0.5, 0.5;
  all.velocity.row(N).setZero();
  all.mass[N] = 10.0, all.radius[N] = 0.25, all.immovable[N] = true;
  contact::ImpulseWindows windows(N, 0.02);
  BookContact contact = book_contact();
  contact.recorder = std::ref(windows);
  const scenes::Scene scene(all, kinematics::Space{}, laws::NearField{.alpha2 = charged ? 0.25 : 0.0}, contact);
  schemes::State state = scenes::start(scene);
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = 1e-3};
  require_reached(schemes::integrate(scene, state, 0.8, scheme, control,
                                     [&](const auto&, const schemes::State& to, double, const auto&) {
                                       windows.until(to.t);
                                       return true;
                                     }));
  largest_force = windows.largest_force();
  return windows.whole();
}

const Case obstacle{
    {.name = "charged_obstacle",
     .claim =
         "a cloud that is charged like the obstacle in its way hits it less hard: the largest impulse, the largest "
         "force in a window and the whole impulse are lower, whatever the seed",
     .equation = "M 7.5.3",
     .reference = Reference::statistics},
    [](Rows& rows) {
      double largest = 0.0, force = 0.0, whole = 0.0;
      for (std::uint64_t seed = 0; seed < (rows.quick() ? 2u : 8u); ++seed) {
        double force_without, force_with;
        const contact::WindowImpulse without = on_obstacle(rows.case_seed() + seed, false, force_without);
        const contact::WindowImpulse with = on_obstacle(rows.case_seed() + seed, true, force_with);
        largest = report::worse_of(largest, with.largest / without.largest);
        force = report::worse_of(force, force_with / force_without);
        whole = report::worse_of(whole, (with.normal + with.tangential) / (without.normal + without.tangential));
      }
      const char* because = "lower in every seed";
      rows.at_most("largest impulse, charged over not, worst seed",
                   {.limit = 1.0, .computed = largest, .because = because});
      rows.at_most("largest force in a window, likewise", {.limit = 1.0, .computed = force, .because = because});
      rows.at_most("whole impulse, likewise", {.limit = 1.0, .computed = whole, .because = because});
    }};

// Two clouds that approach each other at +-U: what share of all is in the largest cluster after 2 s.
double merged(std::uint64_t seed, double U) {
  Uniform uniform(seed);
  constexpr Eigen::Index N = 200;
  kinematics::Particles all{.position = kinematics::Vectors::Zero(N, 3),
                            .velocity = kinematics::Vectors::Zero(N, 3),
                            .mass = Eigen::VectorXd::Constant(N, book_mass),
                            .radius = Eigen::VectorXd::Constant(N, book_radius)};
  const kinematics::Addition half{.box = {.lengths = Eigen::Vector3d::Constant(0.5)}};
  for (const Eigen::Index first : {Eigen::Index{0}, N / 2}) {
    const Eigen::VectorXd radius = all.radius.head(N / 2);
    all.position.middleRows(first, N / 2) =
        kinematics::random_addition(radius, half, [&] { return uniform(); }).position;
    all.position.col(0).segment(first, N / 2).array() += first == 0 ? 0.0 : 1.1;
    all.velocity.col(0).segment(first, N / 2).setConstant(first == 0 ? U : -U);
  }
  const scenes::Scene scene(all, kinematics::Space{}, book_near_field, book_contact());
  schemes::State state = scenes::start(scene);
  advance<schemes::VelocityVerlet>(scene, state, 2.0, 2000);
  return static_cast<double>(thermo::find_clusters({}, rows_of(state.r), 0.35).largest()) / static_cast<double>(N);
}

const Case two_clouds{
    {.name = "two_clouds",
     .claim =
         "two clouds that meet slowly merge, and two that meet fast disperse: the largest part that hangs together "
         "by links of 0.35 m after 2 s",
     .equation = "M 7.5.3",
     .reference = Reference::statistics},
    [](Rows& rows) {
      double slow = 1.0, fast = 0.0;
      for (std::uint64_t seed = 0; seed < (rows.quick() ? 1u : 8u); ++seed) {
        for (const double U : {1.0, 2.0}) slow = std::min(slow, merged(rows.case_seed() + seed, U));
        fast = report::worse_of(fast, merged(rows.case_seed() + seed, 8.0));
      }
      rows.at_least("least share of the largest part, U = 1 and 2 m/s",
                    {.limit = 0.95, .computed = slow, .because = "all but stragglers"});
      rows.at_most("largest share of the largest part, U = 8 m/s",
                   {.limit = 0.05, .computed = fast, .because = "one to ten spheres of 200"});
    }};

// The least number among those that hang together with each body, by passes over all pairs until nothing changes.
std::vector<Eigen::Index> least_linked(const kinematics::Vectors& places, double link, long& links) {
  std::vector<Eigen::Index> least(static_cast<std::size_t>(places.rows()));
  std::iota(least.begin(), least.end(), 0);
  for (bool changes = true; changes;) {
    changes = false, links = 0;
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
      for (Eigen::Index j = i + 1; j < places.rows(); ++j) {
        Eigen::Vector3d towards = places.row(j) - places.row(i);
        towards.x() -= std::round(towards.x());  // space repeats itself after 1 m
        if (towards.norm() > link) continue;
        ++links;
        Eigen::Index &one = least[static_cast<std::size_t>(i)], &other = least[static_cast<std::size_t>(j)];
        changes = changes || one != other;
        one = other = std::min(one, other);
      }
    }
  }
  return least;
}

const Case components{{.name = "clusters_over_all_pairs",
                       .claim = "clusters are the parts that a search over all pairs finds to hang together",
                       .equation = "R 7.2",
                       .reference = Reference::independent_method},
                      [](Rows& rows) {
                        Uniform uniform(rows.case_seed());
                        const kinematics::Vectors places = random_places(uniform, 400);
                        const kinematics::Space space{.lengths = {1.0, infinity, infinity}};
                        long other_parts = 0, other_links = 0;
                        for (const double link : {0.0, 0.05, 0.09, 0.12, 0.5}) {
                          const thermo::Clusters found = thermo::find_clusters(space, places, link);
                          long links = 0;
                          const std::vector<Eigen::Index> least = least_linked(places, link, links);
                          for (std::size_t i = 0; i < least.size(); ++i) {
                            for (std::size_t j = 0; j < i; ++j)
                              other_parts += (least[i] == least[j]) != (found.of[i] == found.of[j]);
                          }
                          other_links += found.links != links;
                        }
                        rows.none("pairs that only one of both says to hang together", other_parts,
                                  "components of the same graph");
                        rows.none("link lengths of five with another number of links", other_links, "the same pairs");
                      }};

}  // namespace verification::thermo_clouds
