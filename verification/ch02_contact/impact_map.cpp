// The impact map, line by line of its derivation, with other forces acting meanwhile.

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::impact_map {

using namespace particulate;

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
void by_hand(Rows& rows) {
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

const Case impact_map{
    {.name = "impact_map",
     .claim = "the impact map obeys every line of its derivation, whatever forces act meanwhile",
     .equation = "M 2.16",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      by_hand(rows);
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
      rows.at_least(
          "share of encounters in which the contact acts",
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
    }};

}  // namespace verification::impact_map
