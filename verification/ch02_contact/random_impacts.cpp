// A million random impacts, frictional, grazing, between any masses: never an energy gain.

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::random_impacts {

using namespace particulate;

struct Seen {
  double gain = -std::numeric_limits<double>::infinity();  // largest T' - T over eps T
  double momentum = 0.0;                                   // largest change over eps sum m|v|
  double loss = 0.0;                                       // smallest (T' - T)/T
};

void look(const Encounter& at, const Eigen::Vector3d& after_i, const Eigen::Vector3d& after_j, Seen& worst) {
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

Seen by_impact(const Drawn& of, std::uint64_t seed, long count) {
  Encounters drawn(of, seed);
  Seen worst;
  for (long k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const contact::Rebound after = library_impact(at);
    look(at, after.velocity_i, after.velocity_j, worst);
  }
  return worst;
}

Seen by_scene(const Drawn& of, std::uint64_t seed, long count) {
  Encounters drawn(of, seed);
  Seen worst;
  for (long k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const Jumped after = jump_of(contact_scene(touching_pair(at), rough(at.e, at.friction)), 1e-3);
    look(at, after.v.row(0).transpose(), after.v.row(1).transpose(), worst);
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
      compare(rows, ", mass ratios up to 1e12, frictionless", by_impact(smooth_pairs, rows.case_seed(), count / 4));
      compare(rows, ", mass ratios up to 10, mu up to 1", by_impact(near, rows.case_seed(), count / 4));
      compare(rows, ", mass ratios up to 1e12, mu up to 5", by_impact(far, rows.case_seed(), count / 2));
      compare(rows, ", scene, mass ratios up to 1e12, mu up to 5", by_scene(far, rows.case_seed(), count / 10));
    }};

}  // namespace verification::random_impacts
