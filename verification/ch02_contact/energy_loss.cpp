// What an impact takes from the kinetic energy.

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::energy_loss {

using namespace particulate;

// Change of the kinetic energy in closed form: restitution's share, and the work of Coulomb friction, which sticks and
// takes all of the sliding or slides and takes less.
Wide change_in_closed_form(const Encounter& at) {
  const WideVector n = at.n.cast<Wide>().normalized(),
                   relative = at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>();
  const Wide reduced = 1 / (static_cast<Wide>(at.i.inverse_mass) + at.j.inverse_mass), e = at.e;
  const Wide u = relative.dot(n), u_t = (relative - u * n).norm(), J = (1 + e) * reduced * u;
  const Wide normal = -reduced * (1 - e * e) * u * u / 2;
  if (reduced * u_t <= at.friction.mu_s * J) return normal - reduced * u_t * u_t / 2;
  const Wide slide = at.friction.mu_d * J;
  return normal - slide * u_t + slide * slide / (2 * reduced);
}

template <class After>
double worst_of(const Drawn& of, std::uint64_t seed, int count, const After& after) {
  Encounters drawn(of, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const auto [v_i, v_j] = after(at);
    const Wide before = pair_energy(at, at.i.velocity.cast<Wide>(), at.j.velocity.cast<Wide>());
    const Wide seen = pair_energy(at, v_i.template cast<Wide>(), v_j.template cast<Wide>()) - before;
    const double error = static_cast<double>(std::abs(seen - change_in_closed_form(at)) / (eps * before));
    keep_worst(worst, error);
  }
  return worst;
}

std::array<Eigen::Vector3d, 2> by_impact(const Encounter& at) {
  const contact::Rebound after = library_impact(at);
  return {after.velocity_i, after.velocity_j};
}

std::array<Eigen::Vector3d, 2> by_scene(const Encounter& at) {
  const Jumped after = jump_of(contact_scene(touching_pair(at), rough(at.e, at.friction)), 1e-3);
  return {after.v.row(0).transpose(), after.v.row(1).transpose()};
}

// The scene's own account of the change, against the closed form, over eps T.
double worst_account(const Drawn& of, std::uint64_t seed, int count) {
  Encounters drawn(of, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const double told = jump_of(contact_scene(touching_pair(at), rough(at.e, at.friction)), 1e-3).jump.energy_change;
    const Wide before = pair_energy(at, at.i.velocity.cast<Wide>(), at.j.velocity.cast<Wide>());
    keep_worst(worst, static_cast<double>(std::abs(told - change_in_closed_form(at)) / (eps * before)));
  }
  return worst;
}

const Case energy_loss{
    {.name = "energy_loss",
     .claim = "an impact takes 1/2 m* (1 - e^2) u_n^2 and the work of friction from the kinetic energy",
     .equation = "D 2.22",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const int count = rows.quick() ? 20000 : 200000;
      const char* const because =
          "velocities after carry up to 8 roundings, and T is quadratic in them; masses within six decades, speeds of "
          "the "
          "centre of mass up to the closing speed";
      const Drawn smooth_pairs{.decades = 3.0}, rough_pairs{.decades = 3.0, .mu = 2.0};
      const auto row = [&](const char* what, double computed) {
        rows.at_most(what, {.limit = 16.0, .computed = computed, .because = because});
      };
      row("T' - T against the closed form, frictionless, in eps T",
          worst_of(smooth_pairs, rows.case_seed(), count, by_impact));
      row("T' - T against the closed form, with friction, in eps T",
          worst_of(rough_pairs, rows.case_seed(), count, by_impact));
      row("T' - T against the closed form, scene with friction, in eps T",
          worst_of(rough_pairs, rows.case_seed(), count / 4, by_scene));
      row("energy_change of the scene's jump, in eps T", worst_account(rough_pairs, rows.case_seed(), count / 4));
      for (const double e : {0.0, 0.3, 0.75, 1.0}) {
        const Encounter head_on{.i = {.velocity = {1.7, 0.0, 0.0}, .inverse_mass = 0.4},
                                .j = {.velocity = {-1.7, 0.0, 0.0}, .inverse_mass = 0.4},
                                .e = e};
        const contact::Rebound after = library_impact(head_on);
        rows.compare(
            "T'/T of an identical pair head-on, e = " + std::to_string(e),
            {.expected = e * e,
             .computed = (after.velocity_i.squaredNorm() + after.velocity_j.squaredNorm()) / (2.0 * 1.7 * 1.7),
             .tolerance = absolute(2e-15),
             .because = "velocities after are differences of 1.7 m/s and its (1 + e)-fold, rounded three times each"});
      }
    }};

}  // namespace verification::energy_loss
