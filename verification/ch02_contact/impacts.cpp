// The impact of two spheres: its map, its totals, and by random.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/momentum.hpp>

#include "clouds.hpp"
#include "encounters.hpp"

namespace verification::impacts {

using namespace particulate;

// The impact map, line by line of its derivation, with other forces acting meanwhile.

// Largest deviations from the monograph's lines, in units of eps times the largest quantity that enters each.
struct Deviations {
  double phases = 0.0, normal_i = 0.0, normal_j = 0.0, restitution = 0.0, parting = 0.0, mean_force = 0.0,
         reaction = 0.0, tangential = 0.0, momentum = 0.0;
};

void raise(double& worst, Wide error, Wide unit) { keep_worst(worst, std::abs(error) / (eps * unit)); }

void measure(const Encounter& at, Deviations& worst) {
  const WideImpact book = monograph_impact(at);
  const contact::Rebound lib = library_impact(at);
  const contact::Phases split = contact::phases(at.duration, at.e);
  const Wide dt = at.duration, e = at.e, m_i = 1 / static_cast<Wide>(at.i.inverse_mass),
             m_j = 1 / static_cast<Wide>(at.j.inverse_mass);
  const WideVector n = at.n.cast<Wide>(), v_i = lib.velocity_i.cast<Wide>(), v_j = lib.velocity_j.cast<Wide>();
  const Wide largest =
      largest_speed(at, lib.velocity_i, lib.velocity_j) + dt * at.acceleration_i.norm() + dt * at.acceleration_j.norm();
  const Wide reduced = 1 / (1 / m_i + 1 / m_j);
  const WideVector pushed_i = dt * at.acceleration_i.cast<Wide>(), pushed_j = dt * at.acceleration_j.cast<Wide>();

  raise(worst.phases, split.compression + static_cast<Wide>(split.recovery) - dt, dt);
  raise(worst.phases, split.recovery - e * static_cast<Wide>(split.compression), dt);
  raise(worst.normal_i, (v_i - book.velocity_i).dot(n), largest);
  raise(worst.normal_j, (v_j - book.velocity_j).dot(n), largest);
  // e is the ratio of the impulses of both phases: m*(v_jn' - v_in' + Delta_2) over m*(u + Delta_1).
  raise(worst.restitution, (v_j - v_i).dot(n) + book.delta2 - e * (book.u + book.delta1), largest);
  raise(worst.parting, (v_j - v_i).dot(n) - e * book.u, largest);
  raise(worst.mean_force, lib.impulse.normal / dt - book.mean_normal_force, reduced * largest / dt);
  raise(worst.reaction, m_i * (v_i - at.i.velocity.cast<Wide>() - pushed_i).dot(n) - lib.impulse.normal, m_i * largest);
  raise(worst.reaction, m_j * (v_j - at.j.velocity.cast<Wide>() - pushed_j).dot(n) + lib.impulse.normal, m_j * largest);
  raise(worst.tangential, ((v_i - book.velocity_i) - (v_i - book.velocity_i).dot(n) * n).norm(), largest);
  raise(worst.tangential, ((v_j - book.velocity_j) - (v_j - book.velocity_j).dot(n) * n).norm(), largest);
  const WideVector gained = m_i * (v_i - at.i.velocity.cast<Wide>()) + m_j * (v_j - at.j.velocity.cast<Wide>());
  raise(worst.momentum, (gained - m_i * pushed_i - m_j * pushed_j).norm(), (m_i + m_j) * largest);
}

// With impulses of the recovery that are no multiple of the compression's: only the second line of the map feels them.
double worst_of_unequal_phases(Encounters& drawn, int count) {
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const contact::External external{.compression = 0.3 * at.i.velocity.norm() * drawn.direction(),
                                     .recovery = 0.3 * at.i.velocity.norm() * drawn.direction()};
    const WideVector n = at.n.cast<Wide>();
    const Wide u = (at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>()).dot(n);
    const Wide delta1 = external.compression.cast<Wide>().dot(n), delta2 = external.recovery.cast<Wide>().dot(n);
    const contact::Impulse impulse = impact_impulse(at.i, at.j, at.n, at.e, external, contact::Frictionless{});
    if (!(u > 0 && u + delta1 > 0)) continue;
    const Wide after =
        u + delta1 + delta2 + impulse.normal * (static_cast<Wide>(at.i.inverse_mass) + at.j.inverse_mass);
    raise(worst, -after - (at.e * (u + delta1) - delta2), at.i.velocity.norm() + at.j.velocity.norm());
  }
  return worst;
}

// 2 and 3 kg at 4 and -1 m/s, e = 1/2, pushed by 10 and -5 m/s^2 for 0.3 s: dt1 = 0.2 s, D1 = 3 m/s, D2 = 1.5 m/s,
// u + D1 = 8 m/s, E_i + E_j = 6 - 4.5 N s; v_in' = (8 - 3 + 1.5 - 3 (4 - 1.5))/5, J = -1.5 * 1.2 * 8.
void map_by_hand(Rows& rows) {
  const contact::Rebound after =
      contact::impact({.velocity = {4.0, 0.0, 0.0}, .inverse_mass = 1.0 / 2.0},
                      {.velocity = {-1.0, 0.0, 0.0}, .inverse_mass = 1.0 / 3.0}, {1.0, 0.0, 0.0}, 0.5, {10.0, 0.0, 0.0},
                      {-5.0, 0.0, 0.0}, 0.3, contact::Frictionless{});
  const char* const because = "some ten roundings of numbers up to 8, two digits of which cancel";
  rows.compare("v_in after, by hand [m/s]",
               {.expected = -0.2, .computed = after.velocity_i.x(), .tolerance = absolute(1e-14), .because = because});
  rows.compare("v_jn after, by hand [m/s]",
               {.expected = 2.3, .computed = after.velocity_j.x(), .tolerance = absolute(1e-14), .because = because});
  rows.compare("mean normal force, by hand [N]", {.expected = -48.0,
                                                  .computed = after.impulse.normal / 0.3,
                                                  .tolerance = relative(2e-15),
                                                  .because = "five products, each rounded once"});
}

void prove_impact_map(Rows& rows) {
  map_by_hand(rows);
  Encounters drawn({.decades = 3.0, .mu = 1.0, .acceleration = 300.0}, rows.case_seed());
  Deviations worst;
  long acting = 0;
  const int count = rows.quick() ? 20000 : 200000;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    if (!monograph_impact(at).acts) continue;
    ++acting;
    measure(at, worst);
  }
  rows.at_least("share of encounters in which the contact acts",
                {.limit = 0.5, .computed = static_cast<double>(acting) / count, .because = "only these are compared"});
  const auto row = [&](const char* what, double computed, double limit, const char* because) {
    rows.at_most(what, {.limit = limit, .computed = computed, .because = because});
  };
  const char* const velocities =
      "u takes 3 subtractions, 3 products and 2 sums, the impulse 4 products, each velocity after it 4 more "
      "roundings, "
      "of at most twice the largest speed";
  row("phases: dt1 + dt2 = gamma Dt, dt2 = e dt1, in eps", worst.phases, 2.0, "one division, one product");
  row("v_in' against (2.16), in eps max|v|", worst.normal_i, 8.0, velocities);
  row("v_jn' against (2.16), in eps max|v|", worst.normal_j, 8.0, velocities);
  row("e as the ratio of both phases' impulses, in eps max|v|", worst.restitution, 12.0,
      "the same roundings in both bodies");
  row("v_jn' - v_in' = e u whatever the forces, in eps max|v|", worst.parting, 12.0,
      "the same roundings in both bodies");
  row("mean normal force against (2.17), in eps m* max|v|/dt", worst.mean_force, 12.0, velocities);
  row("m (v' - v) - E = J on i, -J on j, in eps m max|v|", worst.reaction, 8.0, velocities);
  row("tangential velocities against (2.30), in eps max|v|", worst.tangential, 12.0,
      "as the normal ones, with the normal part taken off first");
  row("momentum gained = impulse of the other forces, in eps (m_i + m_j) max|v|", worst.momentum, 8.0, velocities);
  row("recovery forces that are no multiple of the compression's, in eps (|v_i| + |v_j|)",
      worst_of_unequal_phases(drawn, count), 8.0, velocities);
}

const Case impact_map{{.name = "impact_map",
                       .claim = "the impact map obeys every line of its derivation, whatever forces act meanwhile",
                       .equation = "M 2.16",
                       .reference = Reference::independent_method},
                      prove_impact_map};

// What the impacts of one moment leave of momentum and angular momentum, without and with friction.

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
void totals_by_hand(Rows& rows) {
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
      totals_by_hand(rows);
      const int count = rows.quick() ? 2000 : 20000;
      for (const double decades : {0.0, 1.0}) {
        for (const auto& [how, name] : resolutions) {
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

// A million random impacts, frictional, grazing, between any masses: never an energy gain.

struct Seen {
  double gain = -std::numeric_limits<double>::infinity();  // largest T' - T over eps T
  double momentum = 0.0;                                   // largest change over eps sum m|v|
  double loss = 0.0;                                       // smallest (T' - T)/T
};

void look_at_random(const Encounter& at, const Eigen::Vector3d& after_i, const Eigen::Vector3d& after_j, Seen& worst) {
  const WideVector v_i = at.i.velocity.cast<Wide>(), v_j = at.j.velocity.cast<Wide>();
  const WideVector w_i = after_i.cast<Wide>(), w_j = after_j.cast<Wide>();
  const Wide m_i = 1 / static_cast<Wide>(at.i.inverse_mass), m_j = 1 / static_cast<Wide>(at.j.inverse_mass);
  const Wide before = pair_energy(at, v_i, v_j), change = pair_energy(at, w_i, w_j) - before;
  const double gain = static_cast<double>(change / (eps * before));
  keep_worst(worst.gain, gain);
  worst.loss = std::min(worst.loss, static_cast<double>(change / before));
  const Wide moved = (m_i * (w_i - v_i) + m_j * (w_j - v_j)).norm();
  const Wide unit = m_i * std::max(v_i.norm(), w_i.norm()) + m_j * std::max(v_j.norm(), w_j.norm());
  const double momentum = static_cast<double>(moved / (eps * unit));
  keep_worst(worst.momentum, momentum);
}

template <class After>
Seen worst_seen(const Drawn& of, std::uint64_t seed, long count, const After& after) {
  Encounters drawn(of, seed);
  Seen worst;
  for (long k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const auto [v_i, v_j] = after(at);
    look_at_random(at, v_i, v_j, worst);
  }
  return worst;
}

void compare(Rows& rows, const std::string& which, const Seen& seen) {
  rows.at_most(
      "largest energy gain, in eps T" + which,
      {.limit = 16.0,
       .computed = seen.gain,
       .because = "e = 1 without friction keeps T; velocities after carry up to 8 roundings, T is quadratic in them"});
  rows.at_most("largest change of momentum, in eps sum m max(|v|, |v'|)" + which,
               {.limit = 4.0,
                .computed = seen.momentum,
                .because = "both bodies get the same impulse; J/m and v + J/m are rounded once a component"});
  rows.at_most("largest loss, (T' - T)/T" + which,
               {.limit = -0.5,
                .computed = seen.loss,
                .because = "low e, opposite velocities, friction that sticks: some pair loses half or more, else the "
                           "energies would prove little"});
}

const Case random_impacts{
    {.name = "random_impacts",
     .claim = "no impact gains energy or changes momentum: random, frictional, a quarter each at 76 and 89.9 degrees, "
              "mass ratios up to 1e12",
     .equation = "D 2.30",
     .reference = Reference::identity},
    [](Rows& rows) {
      const long count = rows.quick() ? 100000 : 1000000;
      const Drawn smooth_pairs{.decades = 6.0, .bulk = 1.0}, near{.decades = 0.5, .bulk = 1.0, .mu = 1.0},
          far{.decades = 6.0, .bulk = 1.0, .mu = 5.0};
      compare(rows, ", mass ratios up to 1e12, frictionless",
              worst_seen(smooth_pairs, rows.case_seed(), count / 4, by_impact));
      compare(rows, ", mass ratios up to 10, mu up to 1", worst_seen(near, rows.case_seed(), count / 4, by_impact));
      compare(rows, ", mass ratios up to 1e12, mu up to 5", worst_seen(far, rows.case_seed(), count / 2, by_impact));
      const auto in_a_scene = [](const Encounter& at) { return by_scene(at, rough(at.e, at.friction)); };
      compare(rows, ", scene, mass ratios up to 1e12, mu up to 5",
              worst_seen(far, rows.case_seed(), count / 10, in_a_scene));
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
      worst.records += impact.push > 0.0 ? 1 : 0;  // else friction alone, of contacts hit in turn
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

}  // namespace verification::impacts
