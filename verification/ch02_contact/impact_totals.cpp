// What the impacts of one moment leave of momentum and angular momentum, without and with friction, and whether what is
// recorded of them is what the bodies felt.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/momentum.hpp>

#include "clouds.hpp"

namespace verification::impact_totals {

using namespace particulate;

struct Totals {
  double force = 0.0,
         moment = 0.0;  // |sum P| over sum |P|, |sum r x P| over sum |r||P|, P = m (v' - v) of each particle
  long impacts = 0;
};

// The velocities before bound the rounding where impulses nearly cancel.
Totals worst_totals(std::uint64_t seed, int count, double decades, contact::Resolution how) {
  Encounters drawn({}, seed);
  Totals worst;
  for (int k = 0; k < count; ++k) {
    const kinematics::Particles all = cluster(drawn, 2 + k % 7, decades);
    const Jumped after = jump_of(contact_scene(all, smooth(k % 2 == 0 ? drawn.positive() : 1.0, how)), 1e-3);
    if (after.jump.impacts == 0) continue;
    worst.impacts += after.jump.impacts;
    const kinematics::Vectors P = all.mass.asDiagonal() * (after.v - all.velocity);
    const Eigen::VectorXd size = all.mass.cwiseProduct(after.v.rowwise().norm() + all.velocity.rowwise().norm());
    keep_worst(worst.force, P.colwise().sum().norm() / size.sum());
    keep_worst(worst.moment, kinematics::moment(all.position, P).norm() / all.position.rowwise().norm().dot(size));
  }
  return worst;
}

// A pair away from the origin that meets with friction: the change of its angular momentum against the book's defect,
// -(r_j - r_i) x F_t dt with the tangential impulse on i evaluated apart.
struct Defect {
  double error = 0.0;         // over |r| sum m max|v|, in eps
  double momentum = 0.0;      // change of the momentum over sum m max|v|, in eps
  double median_share = 0.0;  // of the defect itself, over |r| sum m max|v|
};

Defect defects(std::uint64_t seed, int count) {
  Encounters drawn({.decades = 1.0, .mu = 1.0}, seed);
  Defect seen;
  std::vector<double> shares;
  for (int k = 0; k < count; ++k) {
    Encounter at = drawn.next();
    kinematics::Particles pair = touching_pair(at);
    const Eigen::RowVector3d place = 3.0 * drawn.direction().transpose();
    pair.position.rowwise() += place;
    at.n = (pair.position.row(1) - pair.position.row(0)).normalized().transpose();
    const WideImpact book = monograph_impact(at);
    const Jumped after = jump_of(contact_scene(pair, rough(at.e, at.friction)), 1e-3);
    const kinematics::Vectors P = pair.mass.asDiagonal() * (after.v - pair.velocity);
    const WideVector r_i = pair.position.row(0).transpose().cast<Wide>(),
                     r_j = pair.position.row(1).transpose().cast<Wide>();
    const WideVector P_i = P.row(0).transpose().cast<Wide>(), P_j = P.row(1).transpose().cast<Wide>();
    const WideVector change = r_i.cross(P_i) + r_j.cross(P_j);
    const WideVector expected = -(r_j - r_i).cross(book.friction * static_cast<Wide>(at.duration));
    const Wide size = pair.mass.sum() * largest_speed(at, after.v.row(0), after.v.row(1));
    keep_worst(seen.error, static_cast<double>((change - expected).norm() / (eps * size * place.norm())));
    keep_worst(seen.momentum, static_cast<double>((P_i + P_j).norm() / (eps * size)));
    shares.push_back(static_cast<double>(expected.norm() / (size * place.norm())));
  }
  std::nth_element(shares.begin(), shares.begin() + count / 2, shares.end());
  seen.median_share = shares[static_cast<std::size_t>(count / 2)];
  return seen;
}

// 2 kg at (0, 0, 0) meets 2 kg at (1, 0, 0) with (1, 1, 0) m/s, e = 1/2, mu = 0.1: J = -1.5 N s, friction -0.15 N s
// along y on i, so H_z changes by -(1)(-0.15).
void by_hand(Rows& rows) {
  const Encounter at{.i = {.velocity = {1.0, 1.0, 0.0}, .inverse_mass = 0.5},
                     .j = {.inverse_mass = 0.5},
                     .e = 0.5,
                     .friction = {.mu_s = 0.1, .mu_d = 0.1}};
  const kinematics::Particles pair = touching_pair(at);
  const Jumped after = jump_of(contact_scene(pair, rough(at.e, at.friction)), 1e-3);
  const Eigen::Vector3d H = kinematics::angular_momentum(pair.mass, pair.position, after.v) -
                            kinematics::angular_momentum(pair.mass, pair.position, pair.velocity);
  rows.compare("change of H_z, by hand [kg m^2/s]", {.expected = 0.15,
                                                     .computed = H.z(),
                                                     .tolerance = relative(2e-14),
                                                     .because = "some ten roundings of momenta of 2 kg m/s"});
}

const Case impact_totals{
    {.name = "impact_totals",
     .claim = "momentum is kept, and angular momentum without friction; with friction each contact changes it by -(r_j "
              "- r_i) x F_t dt",
     .equation = "D 2.30",
     .reference = Reference::identity},
    [](Rows& rows) {
      by_hand(rows);
      const int count = rows.quick() ? 2000 : 20000;
      for (const double decades : {0.0, 1.0}) {
        for (const auto& [how, name] : {std::pair{contact::Resolution::summed, "summed"},
                                        std::pair{contact::Resolution::sequential, "sequential"}}) {
          const Totals seen = worst_totals(rows.case_seed(), count, decades, how);
          const std::string which = fmt::format(", masses within {} decades, {}", 2.0 * decades, name);
          const char* const because =
              "each impulse is rounded twice in each body, and acts on both; up to some hundred in turn in a cluster "
              "of eight";
          rows.at_least("impacts" + which, {.limit = static_cast<double>(count),
                                            .computed = static_cast<double>(seen.impacts),
                                            .because = "most spheres touch several others"});
          rows.at_most("|sum P| / sum m (|v| + |v'|), frictionless" + which,
                       {.limit = 2e-15, .computed = seen.force, .because = because});
          rows.at_most("|sum r x P| / sum |r| m (|v| + |v'|), frictionless" + which,
                       {.limit = 2e-15, .computed = seen.moment, .because = because});
        }
      }
      const Defect seen = defects(rows.case_seed(), 2 * count);
      rows.at_least(
          "median of the defect itself over |r| sum m max|v|",
          {.limit = 1e-3, .computed = seen.median_share, .because = "it must stand clear of rounding to be compared"});
      rows.at_most("angular momentum's change with friction against -(r_j - r_i) x F_t dt, in eps |r| sum m max|v|",
                   {.limit = 8.0,
                    .computed = seen.error,
                    .because = "the normal from places three diameters out carries 3 eps and turns the impulse; "
                               "velocities after carry some 8 roundings"});
      rows.at_most("momentum's change with friction, in eps sum m max|v|",
                   {.limit = 4.0,
                    .computed = seen.momentum,
                    .because = "both get the same impulse; J/m and v + J/m are rounded once a component"});
    }};

// What was recorded against what happened, in clusters with friction: impulses against the changes of m v, their work
// against the change of kinetic energy.
struct Recorded {
  double momentum = 0.0, energy = 0.0;  // over sum m (|v| + |v'|), and over the kinetic energies before and after
  long impacts = 0, records = 0;
  double shares = 0.0;  // of the energy that is taken, summed over clusters
};

Recorded recorded(std::uint64_t seed, int count, contact::Resolution how) {
  Encounters drawn({}, seed);
  Recorded worst;
  for (int k = 0; k < count; ++k) {
    const kinematics::Particles all = cluster(drawn, 2 + k % 7, 0.0);
    kinematics::Vectors P = kinematics::Vectors::Zero(all.size(), 3);
    double work = 0.0;
    auto law = rough(drawn.positive(), {.mu_s = 0.5, .mu_d = 0.3}, how);
    law.recorder = [&](const contact::ImpactRecord& impact) {
      const Eigen::Vector3d on_i = impact.tangential - impact.push * impact.n;
      P.row(impact.i) += on_i.transpose();
      P.row(impact.j) -= on_i.transpose();
      work += on_i.dot(0.5 * (impact.before + impact.after));
      ++worst.records;
    };
    const Jumped after = jump_of(contact_scene(all, law), 1e-3);
    worst.impacts += after.jump.impacts;
    const kinematics::Vectors changed = all.mass.asDiagonal() * (after.v - all.velocity);
    const Eigen::VectorXd size = all.mass.cwiseProduct(after.v.rowwise().norm() + all.velocity.rowwise().norm());
    const double T = 0.5 * all.mass.dot(all.velocity.rowwise().squaredNorm());
    keep_worst(worst.momentum, (changed - P).norm() / size.sum());
    keep_worst(worst.energy, std::abs(after.jump.energy_change - work) / T);
    worst.shares -= after.jump.energy_change / T;
  }
  return worst;
}

const Case recorded_impacts{
    {.name = "recorded_impacts",
     .claim =
         "what is recorded of every impact is what the bodies felt: the impulses change their momenta, and the work "
         "of these is the kinetic energy that is lost",
     .equation = "D 2.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const int count = rows.quick() ? 500 : 5000;
      for (const auto& [how, name] : {std::pair{contact::Resolution::summed, "summed"},
                                      std::pair{contact::Resolution::sequential, "sequential"}}) {
        const Recorded seen = recorded(rows.case_seed(), count, how);
        const std::string which = fmt::format(", {}", name);
        rows.equal("impacts that were recorded" + which,
                   {.expected = seen.impacts, .computed = seen.records, .because = "each of them, once"});
        rows.at_least("share of the kinetic energy that they take, on average" + which,
                      {.limit = 0.05,
                       .computed = std::abs(seen.shares) / count,
                       .because = "it must stand clear of rounding to be compared"});
        const char* const because = "rounded a few times an impact, of which a cluster of eight has some hundred";
        rows.at_most("|m (v' - v) - sum P| / sum m (|v| + |v'|)" + which,
                     {.limit = 2e-15, .computed = seen.momentum, .because = because});
        rows.at_most("|change of kinetic energy - work of the impulses| / kinetic energy" + which,
                     {.limit = 1e-14, .computed = seen.energy, .because = because});
      }
    }};

}  // namespace verification::impact_totals
