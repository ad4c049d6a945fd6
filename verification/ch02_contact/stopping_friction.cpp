// The coefficient that just stops the sliding takes the most energy; more of it changes nothing, and nothing reverses.

#include <fmt/format.h>

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::stopping_friction {

using namespace particulate;

WideVector parting(const Encounter& at, double mu) {
  Encounter with = at;
  with.friction = {.mu_s = mu, .mu_d = mu};
  const contact::Rebound after = library_impact(with);
  return after.velocity_i.cast<Wide>() - after.velocity_j.cast<Wide>();
}

// Energy of the relative motion after an impact with mu_s = mu_d = mu, over that before.
Wide energy_left(const Encounter& at, double mu) {
  const WideVector before = at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>();
  return parting(at, mu).squaredNorm() / before.squaredNorm();
}

// While it slides the energy is a parabola in mu: its vertex from three energies that the library leaves.
double vertex(const Encounter& at, double step) {
  const Wide E_0 = energy_left(at, 0.0), E_1 = energy_left(at, step), E_2 = energy_left(at, 2.0 * step);
  return static_cast<double>(step * (3 * E_0 - 4 * E_1 + E_2) / (2 * (E_0 - 2 * E_1 + E_2)));
}

struct Worst {
  double vertex = 0.0;  // distance of the parabola's vertex from mu_d*, relative
  double rise = 0.0;    // energy at mu = f mu_d* against the minimum plus its parabola, f from 0 to 4, over eps
  double least = 0.0;   // how far any energy lies below the one at mu_d*, over eps
};

void look(const Encounter& at, Worst& worst) {
  const WideVector n = at.n.cast<Wide>(), v = at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>();
  const Wide u_n = v.dot(n), u_t = (v - u_n * n).norm();
  const double star = contact::stopping_friction(static_cast<double>(u_t), static_cast<double>(u_n), at.e);
  keep_worst(worst.vertex, std::abs(vertex(at, 0.4 * star) / star - 1.0));
  const Wide smallest = at.e * static_cast<Wide>(at.e) * u_n * u_n / v.squaredNorm(),
             sliding = u_t * u_t / v.squaredNorm();
  const Wide here = energy_left(at, star);
  for (const double f : {0.0, 0.3, 0.7, 0.95, 1.05, 1.5, 4.0}) {
    const Wide seen = energy_left(at, f * star), expected = smallest + (f < 1.0 ? (1 - f) * (1 - f) * sliding : 0);
    keep_worst(worst.rise, static_cast<double>(std::abs(seen - expected) / eps));
    keep_worst(worst.least, static_cast<double>((here - seen) / eps));
  }
}

// Two equal bodies that meet at v_n and v_t each: with friction below mu_d* each keeps v_t - (1 + e) v_n mu_d.
void symmetric_pair(Rows& rows) {
  const double v_n = 1.3, v_t = 0.9, e = 0.6;
  const Encounter at{.i = {.velocity = {v_n, v_t, 0.0}, .inverse_mass = 0.2},
                     .j = {.velocity = {-v_n, -v_t, 0.0}, .inverse_mass = 0.2},
                     .e = e};
  rows.compare("mu_d* of a symmetric pair, v_t/((1 + e) v_n)",
               {.expected = 0.432692307692307692,
                .computed = contact::stopping_friction(2.0 * v_t, 2.0 * v_n, e),
                .tolerance = relative(4e-16),
                .because = "0.9/2.08: one sum, one product, one division"});
  // 0.9 - 1.6 * 1.3 * mu_d
  for (const auto& [mu, kept] :
       {std::pair{0.1, 0.692}, std::pair{0.4, 0.068}, std::pair{0.43269231, 0.0}, std::pair{0.6, 0.0}}) {
    rows.compare(fmt::format("v_t after of a symmetric pair, mu_d = {} [m/s]", mu),
                 {.expected = kept,
                  .computed = static_cast<double>(parting(at, mu).y()) / 2.0,
                  .tolerance = absolute(1e-15),
                  .because = "differences of numbers near 1, each rounded a few times"});
  }
}

// Sliding along or against what it was, after random impacts with mu_d <= mu_s: over eps max|v|.
double worst_reversal(const Drawn& of, std::uint64_t seed, int count) {
  Encounters drawn(of, seed);
  double worst = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const contact::Rebound after = library_impact(at);
    const WideVector n = at.n.cast<Wide>();
    const auto across = [&](const WideVector& v) -> WideVector { return v - v.dot(n) * n; };
    const WideVector pushed = static_cast<Wide>(at.duration) * (at.acceleration_i - at.acceleration_j).cast<Wide>();
    const WideVector slip = across(at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>() + pushed);
    const WideVector left = across(after.velocity_i.cast<Wide>() - after.velocity_j.cast<Wide>());
    const double against = static_cast<double>(-left.dot(slip) / slip.norm());
    keep_worst(worst, against / (eps * (largest_speed(at, after.velocity_i, after.velocity_j) +
                                        static_cast<double>(pushed.norm()))));
  }
  return worst;
}

const Case stopping_friction{
    {.name = "stopping_friction",
     .claim = "mu_d* = |u_t|/((1 + e) u_n) leaves the least energy whatever the masses, and friction with mu_d <= mu_s "
              "never reverses the sliding",
     .equation = "M 2.49",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      symmetric_pair(rows);
      const int count = rows.quick() ? 5000 : 50000;
      Encounters drawn({.decades = 6.0, .bulk = 0.0}, rows.case_seed());
      Worst worst;
      for (int k = 0; k < count; ++k) {
        const Encounter at = drawn.next();
        const double u_n = (at.i.velocity - at.j.velocity).dot(at.n), speed = (at.i.velocity - at.j.velocity).norm();
        // At 76 degrees and between: sliding and approach both hold digits to compare.
        if (u_n > 0.05 * speed && u_n < 0.95 * speed) look(at, worst);
      }
      rows.at_most("vertex of the energy's parabola against mu_d*, relative",
                   {.limit = 1e-12,
                    .computed = worst.vertex,
                    .because = "second difference of energies of 3 eps each, sliding 0.1 of the energy or more, step "
                               "0.4 mu_d*: 3 * 8 eps/(0.16 * 0.1) = 3e-13, and mu_d* itself"});
      rows.at_most("energy at 0 to 4 mu_d* against e^2 u_n^2 + (1 - f)^2 u_t^2, over eps of the whole",
                   {.limit = 16.0,
                    .computed = worst.rise,
                    .because = "velocities after carry some 8 roundings, the energy is quadratic in them"});
      rows.at_most(
          "how far any energy lies below the one at mu_d*, over eps of the whole",
          {.limit = 16.0, .computed = worst.least, .because = "as above: equal beyond mu_d*, where it sticks"});
      const char* const because =
          "u_t + P/m* with |P| <= m* |u_t|: exact arithmetic never passes zero; some ten roundings of speeds";
      rows.at_most("sliding reversed, in eps max|v|",
                   {.limit = 12.0,
                    .computed = worst_reversal({.decades = 6.0, .mu = 5.0}, rows.case_seed(), 4 * count),
                    .because = because});
      rows.at_most(
          "sliding reversed with other forces, in eps max|v|",
          {.limit = 12.0,
           .computed = worst_reversal({.decades = 6.0, .mu = 5.0, .acceleration = 3000.0}, rows.case_seed(), 4 * count),
           .because = because});
    }};

}  // namespace verification::stopping_friction
