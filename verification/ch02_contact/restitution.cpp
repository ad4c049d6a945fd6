// Restitution: what goes in comes out, constant or of the speed of approach.

#include <fmt/format.h>

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::restitution {

using namespace particulate;

// The restitution that comes out of an impact is the one that went in.

// Deviation of the restitution seen from the one given, in units of eps max(|v|, |v'|)/u.
double deviation(const Encounter& at, const WideVector& n, const Eigen::Vector3d& after_i,
                 const Eigen::Vector3d& after_j) {
  const Wide u = (at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>()).dot(n);
  const Wide seen = (after_j.cast<Wide>() - after_i.cast<Wide>()).dot(n) / u;
  return static_cast<double>(std::abs(seen - at.e) * u / (eps * largest_speed(at, after_i, after_j)));
}

// Worst deviation over random encounters; prepare() may change each, after() gives the velocities it leads to.
template <class Prepare, class After>
double worst_of(std::uint64_t seed, int count, const Prepare& prepare, const After& after) {
  Encounters drawn({.decades = 6.0}, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    Encounter at = drawn.next();
    prepare(at);
    const auto [v_i, v_j] = after(at);
    const double seen = deviation(at, at.n.cast<Wide>().normalized(), v_i, v_j);
    keep_worst(worst, seen);
  }
  return worst;
}

// A wall behind the body instead of the other one; it stands still.
Velocities by_wall(const Encounter& at) {
  const kinematics::Space domain{{kinematics::Wall{.point = 0.5 * at.n, .normal = -at.n}}};
  kinematics::Particles one{.position = kinematics::Vectors::Zero(1, 3),
                            .velocity = at.i.velocity.transpose(),
                            .mass = Eigen::VectorXd::Ones(1),
                            .radius = Eigen::VectorXd::Constant(1, 0.5 + 1e-9)};
  const scenes::Scene<kinematics::Space, contact::Contact<>> scene{one, domain, smooth(at.e)};
  return {jump_of(scene, 1e-3).v.row(0).transpose(), Eigen::Vector3d::Zero()};
}

void prove_restitution_in_out(Rows& rows) {
  const int count = rows.quick() ? 20000 : 400000;
  const auto as_it_is = [](Encounter&) {};
  const auto on_a_rock = [](Encounter& at) { at.j = {.velocity = Eigen::Vector3d::Zero(), .inverse_mass = 0.0}; };
  // The relative velocity stays what it was, seen from the body that now stands still.
  const auto on_a_wall = [&](Encounter& at) {
    at.i.velocity -= at.j.velocity;
    on_a_rock(at);
  };
  const auto one_is_e = [](double e, double ratio) {
    return [=](Encounter& at) { at.e = e, at.i.inverse_mass = 1.0 / ratio, at.j.inverse_mass = 1.0; };
  };
  const auto row = [&](const std::string& what, double computed) {
    rows.at_most("|e_out - e| in units of eps max(|v|, |v'|)/u, " + what,
                 {.limit = 8.0,
                  .computed = computed,
                  .because = "u is rounded in 3 differences and a scalar product of vectors no longer than 2 max|v|, "
                             "which 1 + e <= 2 doubles; each velocity after is rounded twice"});
  };
  const auto sequential = [](const Encounter& at) {
    return by_scene(at, smooth(at.e, contact::Resolution::sequential));
  };
  const auto summed = [](const Encounter& at) { return by_scene(at, smooth(at.e, contact::Resolution::summed)); };
  row("contact::impact", worst_of(rows.case_seed(), count, as_it_is, by_impact));
  row("contact::impact, j immovable", worst_of(rows.case_seed(), count, on_a_wall, by_impact));
  row("scene, sequential", worst_of(rows.case_seed(), count / 4, as_it_is, sequential));
  row("scene, summed", worst_of(rows.case_seed(), count / 4, as_it_is, summed));
  row("scene, j immovable", worst_of(rows.case_seed(), count / 4, on_a_wall, sequential));
  row("scene, wall", worst_of(rows.case_seed(), count / 4, on_a_wall, by_wall));
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double ratio : {1e-12, 1.0, 1e12}) {
      const std::string which = fmt::format(", e = {}, m_i/m_j = {}", e, ratio);
      row("contact::impact" + which, worst_of(rows.case_seed(), count / 10, one_is_e(e, ratio), by_impact));
      row("scene" + which, worst_of(rows.case_seed(), count / 10, one_is_e(e, ratio), sequential));
    }
  }
}

const Case restitution_in_out{
    {.name = "restitution_in_out",
     .claim = "restitution out equals restitution in, for e from 0 to 1 and mass ratios of 1e-12 to 1e12, head-on to "
              "grazing",
     .equation = "M 2.13",
     .reference = Reference::identity},
    prove_restitution_in_out};

// Restitution that falls with the severity of the impact, down to a floor.

Wide law_in_words(const contact::Restitution& law, Wide u) {
  const Wide falling = static_cast<Wide>(law.e_o) - static_cast<Wide>(law.e_o) * u / static_cast<Wide>(law.v_star);
  return falling < law.e_minus ? static_cast<Wide>(law.e_minus) : falling;
}

std::vector<double> many_speeds(const contact::Restitution& law, int count) {
  const double kink = std::isfinite(law.v_star) && law.e_o > 0.0 ? law.v_star * (1.0 - law.e_minus / law.e_o) : 1.0;
  std::vector<double> speeds;
  // A law whose floor is e_o has its kink at rest, where no impact tells a restitution.
  if (kink > 0.0) speeds = {kink, kink * (1.0 - 1e-9), kink * (1.0 + 1e-9), 0.5 * kink, 2.0 * kink};
  for (int k = 0; k <= count; ++k) speeds.push_back(std::pow(10.0, -9.0 + 18.0 * k / count));
  return speeds;
}

// Restitution seen in a scene of two unlike bodies that meet at this speed, slanted to the axes and drifting.
double seen_in_scene(const contact::Restitution& law, double u) {
  const Eigen::Vector3d n = Eigen::Vector3d{2.0, 3.0, 6.0} / 7.0;
  const Encounter at{.i = {.velocity = u * n, .inverse_mass = 0.3},
                     .j = {.velocity = Eigen::Vector3d::Zero(), .inverse_mass = 2.0},
                     .n = n};
  const contact::Contact<contact::Restitution, contact::Frictionless> falling{.restitution = law};
  const contact::Contact<contact::Restitution, contact::Frictionless> added{.restitution = law,
                                                                            .resolution = contact::Resolution::summed};
  const auto out_of = [&](const auto& contact_law) {
    const Jumped after = jump_of(contact_scene(touching_pair(at), contact_law), 1e-3);
    return static_cast<double>((after.v.row(1) - after.v.row(0)).cast<Wide>().dot(n.cast<Wide>().transpose()) /
                               (at.i.velocity.cast<Wide>().dot(n.cast<Wide>())));
  };
  const double sequential = out_of(falling), summed = out_of(added),
               expected = static_cast<double>(law_in_words(law, u));
  return std::abs(sequential - expected) > std::abs(summed - expected) ? sequential : summed;
}

void compare(Rows& rows, const contact::Restitution& law, const std::string& name) {
  double worst = 0.0, worst_seen = 0.0;
  for (const double u : many_speeds(law, rows.quick() ? 1000 : 20000)) {
    keep_worst(worst, static_cast<double>(std::abs(contact::restitution_at(law, u) - law_in_words(law, u))));
    keep_worst(worst_seen, static_cast<double>(std::abs(seen_in_scene(law, u) - law_in_words(law, u))));
  }
  rows.at_most("e against the formula, 1e-9 to 1e9 m/s, " + name,
               {.limit = 4.0 * eps,
                .computed = worst,
                .because = "a quotient up to 1 above the floor, a difference and a product, each rounded once"});
  rows.at_most("e out of a scene against the formula, " + name,
               {.limit = 24.0 * eps,
                .computed = worst_seen,
                .because = "8 eps max|v|/u from the impact, with max|v| up to 2 u; e itself"});
}

// e_o = 0.8, v* = 10 m/s, floor 0.2: 0.8 at rest, 0.6 at 2.5 m/s, the floor from 7.5 m/s on.
void by_hand(Rows& rows) {
  const contact::Restitution law{.e_o = 0.8, .v_star = 10.0, .e_minus = 0.2};
  for (const auto& [u, e] : {std::pair{0.0, 0.8}, std::pair{2.5, 0.6}, std::pair{5.0, 0.4}, std::pair{7.5, 0.2},
                             std::pair{10.0, 0.2}, std::pair{1e6, 0.2}}) {
    rows.compare(fmt::format("e at {} m/s, by hand", u), {.expected = e,
                                                          .computed = contact::restitution_at(law, u),
                                                          .tolerance = absolute(3e-16),
                                                          .because = "three roundings of numbers up to 1"});
  }
  // 0.3 kg and 0.2 kg at 5 m/s: m* = 0.12 kg, loss 0.06 * (1 - 0.16) * 25.
  const Encounter at{.i = {.velocity = {5.0, 0.0, 0.0}, .inverse_mass = 1.0 / 0.3}, .j = {.inverse_mass = 1.0 / 0.2}};
  const contact::Contact<contact::Restitution, contact::Frictionless> contact_law{.restitution = law};
  rows.compare("energy taken at 5 m/s, by hand [J]",
               {.expected = -1.26,
                .computed = jump_of(contact_scene(touching_pair(at), contact_law), 1e-3).jump.energy_change,
                .tolerance = relative(1e-14),
                .because = "differences of energies of 3.75 J, rounded some ten times"});
}

const Case restitution_velocity_dependent{
    {.name = "restitution_velocity_dependent",
     .claim = "e = max(e_o (1 - u/v*), e^-) at every speed, by itself and out of a scene",
     .equation = "R 2.4.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      by_hand(rows);
      compare(rows, {.e_o = 0.8, .v_star = 10.0, .e_minus = 0.2}, "e_o = 0.8, v* = 10, least e 0.2");
      compare(rows, {.e_o = 1.0, .v_star = 1e-3, .e_minus = 0.0}, "e_o = 1, v* = 1e-3, no least e");
      compare(rows, {.e_o = 0.7, .v_star = 1e5, .e_minus = 0.7}, "least e = e_o = 0.7");
      compare(rows, {.e_o = 0.9}, "e_o = 0.9, no critical speed");
      compare(rows, {.e_o = 0.0, .v_star = 1.0, .e_minus = 0.0}, "e_o = 0");
    }};

}  // namespace verification::restitution
