// The restitution that comes out of an impact is the one that went in.

#include <fmt/format.h>

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::restitution_in_out {

using namespace particulate;

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

using Velocities = std::array<Eigen::Vector3d, 2>;

Velocities by_impact(const Encounter& at) {
  const contact::Rebound after = library_impact(at);
  return {after.velocity_i, after.velocity_j};
}

Velocities by_scene(const Encounter& at, contact::Resolution resolution) {
  const Jumped after = jump_of(contact_scene(touching_pair(at), smooth(at.e, resolution)), 1e-3);
  return {after.v.row(0).transpose(), after.v.row(1).transpose()};
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

const Case restitution_in_out{
    {.name = "restitution_in_out",
     .claim = "restitution out equals restitution in, for e from 0 to 1 and mass ratios of 1e-12 to 1e12, head-on to "
              "grazing",
     .equation = "M 2.13",
     .reference = Reference::identity},
    [](Rows& rows) {
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
        rows.at_most(
            "|e_out - e| in units of eps max(|v|, |v'|)/u, " + what,
            {.limit = 8.0,
             .computed = computed,
             .because = "u is rounded in 3 differences and a scalar product of vectors no longer than 2 max|v|, "
                        "which 1 + e <= 2 doubles; each velocity after is rounded twice"});
      };
      const auto sequential = [](const Encounter& at) { return by_scene(at, contact::Resolution::sequential); };
      const auto summed = [](const Encounter& at) { return by_scene(at, contact::Resolution::summed); };
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
    }};

}  // namespace verification::restitution_in_out
