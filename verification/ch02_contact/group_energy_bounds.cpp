// Bounds on what a group of particles loses when each meets at most one other, and a group that goes below them.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

#include "encounters.hpp"

namespace verification::group_energy_bounds {

using namespace particulate;

// Pairs ten metres apart that touch; a fifth of them parts.
kinematics::Particles pairs(Encounters& drawn, Eigen::Index count) {
  kinematics::Particles group{.position = kinematics::Vectors(2 * count, 3),
                              .velocity = kinematics::Vectors(2 * count, 3),
                              .mass = Eigen::VectorXd(2 * count),
                              .radius = Eigen::VectorXd::Constant(2 * count, 0.5 + 1e-9)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const double speed = (at.i.velocity - at.j.velocity).norm();
    const Eigen::Vector3d place{10.0 * static_cast<double>(k), 0.0, 0.0};
    for (Eigen::Index side = 0; side < 2; ++side) {
      const contact::Body& body = side == 0 ? at.i : at.j;
      const Eigen::Vector3d centre = place + static_cast<double>(side) * at.n;
      group.position.row(2 * k + side) = centre.transpose();
      group.velocity.row(2 * k + side) = body.velocity.transpose() / speed;
      group.mass[2 * k + side] = 1.0 / body.inverse_mass;
    }
  }
  return group;
}

struct Range {
  double above_lower = std::numeric_limits<double>::infinity();  // smallest (T' - T)/T - (e^2 - 1)
  double highest = -std::numeric_limits<double>::infinity();     // largest (T' - T)/T
};

Range changes(std::uint64_t seed, int groups, double e, contact::Resolution resolution) {
  Encounters drawn({.decades = 2.0, .only_approaching = false}, seed);
  Range range;
  for (int k = 0; k < groups; ++k) {
    const kinematics::Particles group = pairs(drawn, 1 + k % 6);
    const Jumped after = jump_of(contact_scene(group, smooth(e, resolution)), 1e-3);
    const double T = kinematics::kinetic_energy(group.mass, group.velocity);
    const double change = (kinematics::kinetic_energy(group.mass, after.v) - T) / T;
    range.above_lower = std::min(range.above_lower, change - (e * e - 1.0));
    keep_worst(range.highest, change);
  }
  return range;
}

// Momentum-free head-on pairs in slanted directions: the lower bound is attained.
double change_of_head_on_pairs(std::uint64_t seed, double e) {
  Encounters drawn({.decades = 2.0}, seed);
  kinematics::Particles group = pairs(drawn, 5);
  for (Eigen::Index k = 0; k < 5; ++k) {
    const Eigen::RowVector3d n = group.position.row(2 * k + 1) - group.position.row(2 * k);
    group.velocity.row(2 * k) = n / group.mass[2 * k];
    group.velocity.row(2 * k + 1) = -n / group.mass[2 * k + 1];
  }
  const Jumped after = jump_of(contact_scene(group, smooth(e)), 1e-3);
  const double T = kinematics::kinetic_energy(group.mass, group.velocity);
  return (kinematics::kinetic_energy(group.mass, after.v) - T) / T;
}

// Three equal bodies at 1, 0 and -1 m/s, e = 1/2, hit in turn: 1 and 2, 2 and 3, 1 and 2 again, then all part.
// Velocities are (1/4, 3/4, -1), (1/4, -9/16, 5/16), (-23/64, 3/64, 5/16): T'/T = (529 + 9 + 400)/8192.
constexpr double left_in_turn = 938.0 / 8192.0;

double in_turn_by_impacts() {
  std::array<contact::Body, 3> body;
  for (int k = 0; k < 3; ++k)
    body[static_cast<std::size_t>(k)] = {.velocity = {1.0 - k, 0.0, 0.0}, .inverse_mass = 1.0};
  for (const std::size_t first : {0U, 1U, 0U}) {
    const contact::Rebound after =
        contact::impact(body[first], body[first + 1], {1.0, 0.0, 0.0}, 0.5, Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Zero(), 0.0, contact::Frictionless{});
    body[first].velocity = after.velocity_i, body[first + 1].velocity = after.velocity_j;
  }
  return 0.5 * (body[0].velocity.squaredNorm() + body[1].velocity.squaredNorm() + body[2].velocity.squaredNorm());
}

// The same in time: gaps of 0.1 and 0.3 m make them meet in that order.
struct InTime {
  double share;
  long impacts;
};

InTime in_turn_by_scene() {
  kinematics::Particles three{.position = kinematics::Vectors::Zero(3, 3),
                              .velocity = kinematics::Vectors::Zero(3, 3),
                              .mass = Eigen::VectorXd::Ones(3),
                              .radius = Eigen::VectorXd::Constant(3, 0.5)};
  three.position.col(0) << -1.1, 0.0, 1.3;
  three.velocity.col(0) << 1.0, 0.0, -1.0;
  auto scene = contact_scene(three, smooth(0.5));
  schemes::State state = scenes::start(scene);
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = 1e-3};
  const schemes::Outcome outcome = integrate(scene, state, 3.0, scheme, control);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(outcome.reason);
  return {.share = 0.5 * state.v.squaredNorm(), .impacts = outcome.impacts};
}

const Case group_energy_bounds{
    {.name = "group_energy_bounds",
     .claim = "e^2 - 1 <= (T' - T)/T <= 0 for a group in which each meets at most one other; repeated impacts go below",
     .equation = "M 2.29",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const int groups = rows.quick() ? 4000 : 40000;
      const char* const because =
          "the bound itself, less the rounding of T and T': some 30 roundings of sums of positive terms";
      for (const double e : {0.0, 0.5, 0.9, 1.0}) {
        for (const auto& [resolution, name] : {std::pair{contact::Resolution::summed, "summed"},
                                               std::pair{contact::Resolution::sequential, "sequential"}}) {
          const Range range = changes(rows.case_seed(), groups, e, resolution);
          rows.at_least(fmt::format("smallest (T' - T)/T - (e^2 - 1), e = {}, {}", e, name),
                        {.limit = -4e-15, .computed = range.above_lower, .because = because});
          rows.at_most(fmt::format("largest (T' - T)/T, e = {}, {}", e, name),
                       {.limit = 4e-15, .computed = range.highest, .because = because});
        }
        rows.compare(fmt::format("(T' - T)/T of pairs without momentum, head-on, e = {}", e),
                     {.expected = e * e - 1.0,
                      .computed = change_of_head_on_pairs(rows.case_seed(), e),
                      .tolerance = absolute(4e-15),
                      .because = because});
      }
      rows.compare("T'/T, hit in turn, by impacts", {.expected = left_in_turn,
                                                     .computed = in_turn_by_impacts(),
                                                     .tolerance = relative(1e-15),
                                                     .because = "all velocities are multiples of 1/64: no rounding"});
      rows.compare("T'/T, hit in turn, four digits", {.expected = 0.1145,
                                                      .computed = in_turn_by_impacts(),
                                                      .tolerance = absolute(5e-5),
                                                      .because = "half of the fourth decimal"});
      const InTime seen = in_turn_by_scene();
      rows.compare("T'/T, hit in turn, scene", {.expected = left_in_turn,
                                                .computed = seen.share,
                                                .tolerance = relative(4e-15),
                                                .because = "as above; the resolver divides by its own inverse masses"});
      rows.equal("impacts, hit in turn, scene",
                 {.expected = 3, .computed = seen.impacts, .because = "1 and 2, 2 and 3, 1 and 2; then all part"});
    }};

}  // namespace verification::group_energy_bounds
