// Extreme contacts that must give an answer.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::extremes_solved {

using namespace particulate;

const Eigen::Vector3d slanted = Eigen::Vector3d{2.0, 3.0, 6.0} / 7.0;

// A slanted pair with friction, against the monograph's formulas in extended precision; in units of eps max|v|.
Ending meet(double e, double m_i, double m_j, double mu) {
  const Encounter at{.i = {.velocity = {1.3, -0.2, 0.9}, .inverse_mass = 1.0 / m_i},
                     .j = {.velocity = {-0.4, 0.7, -0.1}, .inverse_mass = 1.0 / m_j},
                     .n = slanted,
                     .e = e,
                     .friction = {.mu_s = mu, .mu_d = mu}};
  const WideImpact book = monograph_impact(at);
  const Jumped after = jump_of(contact_scene(touching_pair(at), rough(e, at.friction)), 1e-3);
  const Wide off = std::max((after.v.row(0).transpose().cast<Wide>() - book.velocity_i).norm(),
                            (after.v.row(1).transpose().cast<Wide>() - book.velocity_j).norm());
  return Ending::solved({.error = static_cast<double>(off / (eps * largest_speed(at, after.v.row(0), after.v.row(1)))),
                         .tolerance = 16.0,
                         .because = "in units of eps max|v|: the impulse and velocities take some 15 roundings"});
}

// Two spheres that touch without overlap, d = b_i + b_j to the last bit, and approach.
Ending just_touching(double speed) {
  Encounter at{.i = {.velocity = {speed, 0.0, 0.0}, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}};
  kinematics::Particles pair = touching_pair(at);
  pair.radius.setConstant(0.5);
  const Jumped after = jump_of(contact_scene(pair, smooth(1.0)), 1e-3);
  const double expected = speed > 0.0 ? speed : 0.0;
  const double told =
      std::abs(static_cast<double>(after.jump.impacts) - (speed > 0.0 ? 1.0 : 0.0)) + after.jump.overlap;
  return Ending::solved({.error = std::abs(after.v(1, 0) - expected) / std::abs(speed) + told,
                         .tolerance = 4.0 * eps,
                         .because = "equal masses exchange velocities, or fly on; one impulse, two roundings"});
}

// One bit apart: no contact.
Ending just_apart() {
  Encounter at{.i = {.velocity = {1.0, 0.0, 0.0}, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}};
  kinematics::Particles pair = touching_pair(at);
  pair.radius.setConstant(0.5);
  pair.position(1, 0) = std::nextafter(1.0, 2.0);
  const Jumped after = jump_of(contact_scene(pair, smooth(1.0)), 1e-3);
  return Ending::solved({.error = (after.v - pair.velocity).norm() + static_cast<double>(after.jump.impacts),
                         .tolerance = 0.0,
                         .because = "they do not touch: nothing changes"});
}

// What is immovable stays, even with a velocity of zero struck by 1e12 kg, and between two such nothing happens.
Ending immovable(double mass) {
  const Encounter at{
      .i = {.velocity = 3.0 * slanted, .inverse_mass = 1.0 / mass}, .j = {.inverse_mass = 0.0}, .n = slanted, .e = 0.5};
  const Jumped after = jump_of(contact_scene(touching_pair(at), smooth(0.5)), 1e-3);
  return Ending::solved({.error = (after.v.row(0).transpose() + 1.5 * slanted).norm() + after.v.row(1).norm(),
                         .tolerance = 8.0 * 3.0 * eps,
                         .because = "8 roundings of 3 m/s; the rock's velocity stays 0"});
}

Ending two_immovable() {
  const Encounter at{.i = {.velocity = {1.0, 0.0, 0.0}, .inverse_mass = 0.0}, .j = {.inverse_mass = 0.0}};
  const Jumped after = jump_of(contact_scene(touching_pair(at), rough(0.5, {.mu_s = 0.2, .mu_d = 0.1})), 1e-3);
  return Ending::solved({.error = (after.v.row(0) - at.i.velocity.transpose()).norm() + after.v.row(1).norm(),
                         .tolerance = 0.0,
                         .because = "no impulse moves either"});
}

// No particle, and one: a scene with contact, friction, wall and gravity.
Ending fall(Eigen::Index N) {
  kinematics::Particles few{.position = kinematics::Vectors::Constant(N, 3, 9.0),
                            .velocity = kinematics::Vectors::Zero(N, 3),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.5)};
  using Room = scenes::Scene<kinematics::Space, laws::Gravity,
                             contact::Contact<contact::ConstantRestitution, contact::Friction>>;
  Room room{few, kinematics::Space{{kinematics::Wall{}}}, laws::Gravity{}, rough(0.5, {.mu_s = 0.2, .mu_d = 0.1})};
  schemes::State state = scenes::start(room);
  const long impacts = march<schemes::VelocityVerlet>(room, state, 1.0, 100).impacts;
  const double expected = 9.0 - 0.5 * 9.81;
  const double off =
      N == 0 ? static_cast<double>(state.r.size()) : std::abs(state.r[2] - expected) + static_cast<double>(impacts);
  return Ending::solved({.error = off,
                         .tolerance = 1e-13,
                         .because = "Verlet is exact for constant forces; 100 steps, each rounding 9 m to eps/2"});
}

// A sphere deep inside a wall that moves on into it, and one that leaves it.
Ending inside_wall(double speed) {
  const Encounter at{.i = {.velocity = {0.3, 0.0, speed}, .inverse_mass = 1.0}};
  kinematics::Particles one{.position = kinematics::Vectors::Zero(1, 3),
                            .velocity = at.i.velocity.transpose(),
                            .mass = Eigen::VectorXd::Ones(1),
                            .radius = Eigen::VectorXd::Constant(1, 0.5)};
  const scenes::Scene<kinematics::Space, contact::Contact<>> room{
      one, {{kinematics::Wall{.point = {0.0, 0.0, 40.0}}}}, smooth(0.5)};
  const Jumped after = jump_of(room, 1e-3);
  const Eigen::RowVector3d expected{0.3, 0.0, speed < 0.0 ? -0.5 * speed : speed};
  return Ending::solved({.error = (after.v.row(0) - expected).norm() + std::abs(after.jump.overlap - 40.5),
                         .tolerance = 1e-15,
                         .because = "one product; depth 40.5 m without rounding"});
}

// Grazing to the last digits: the approach is far below the rounding of the speeds, and it must settle all the same.
Ending grazing(double u, double e) {
  const Encounter at{.i = {.velocity = {u, 1.0, 1.0}, .inverse_mass = 1.0},
                     .j = {.velocity = {0.0, -1.0, 0.5}, .inverse_mass = 1.0 / 3.0},
                     .n = slanted,
                     .e = e,
                     .friction = {.mu_s = 0.2, .mu_d = 0.1}};
  Encounter turned = at;
  // Across n, but for u along it.
  turned.i.velocity = at.i.velocity - at.i.velocity.dot(slanted) * slanted + u * slanted;
  turned.j.velocity = at.j.velocity - at.j.velocity.dot(slanted) * slanted;
  const Jumped after = jump_of(contact_scene(touching_pair(turned), rough(e, at.friction)), 1e-3);
  const double change = std::max((after.v.row(0).transpose() - turned.i.velocity).norm(),
                                 (after.v.row(1).transpose() - turned.j.velocity).norm());
  return Ending::solved(
      {.error = change,
       .tolerance = 2.0 * u * 1.2 + 16.0 * eps,
       .because = "impulses up to (1 + e) m* u along n, mu times that across; rounding of speeds near 1"});
}

// Speeds so large or small that squares of them are no doubles.
Ending scaled_speeds(double scale) {
  const Encounter at{
      .i = {.velocity = scale * slanted, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}, .n = slanted, .e = 0.5};
  const contact::Rebound after = library_impact(at);
  return Ending::solved(
      {.error = (after.velocity_i / scale - 0.25 * slanted).norm() + (after.velocity_j / scale - 0.75 * slanted).norm(),
       .tolerance = 8.0 * eps,
       .because = "some 8 roundings; nothing is squared"});
}

const Case extremes_solved{
    {.name = "extremes_solved",
     .claim = "e = 0 and 1, mass ratios of 1e-12 and 1e12, just touching, immovable, grazing to the last digit: all "
              "get an answer",
     .equation = "M 2.16",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double e : {0.0, 1.0}) {
        for (const double ratio : {1e-12, 1.0, 1e12}) {
          for (const double mu : {0.0, 0.4})
            rows.must_be_solved(fmt::format("pair, e = {}, m_i/m_j = {}, mu = {}", e, ratio, mu),
                                [=] { return meet(e, ratio, 1.0, mu); });
        }
      }
      rows.must_be_solved("pair of 1e-300 and 1e300 kg", [] { return meet(0.5, 1e-300, 1e300, 0.2); });
      for (const double speed : {1.0, -1.0, 1e-300, 1e150})
        rows.must_be_solved(fmt::format("two just touching, {} m/s", speed), [=] { return just_touching(speed); });
      rows.must_be_solved("two one bit apart", just_apart);
      for (const double mass : {1.0, 1e12, 1e-12})
        rows.must_be_solved(fmt::format("immovable partner of {} kg", mass), [=] { return immovable(mass); });
      rows.must_be_solved("two immovable, one told to move", two_immovable);
      rows.must_be_solved("no particle, wall, gravity, friction", [] { return fall(0); });
      rows.must_be_solved("one particle, wall, gravity, friction", [] { return fall(1); });
      for (const double speed : {-2.0, 2.0})
        rows.must_be_solved(fmt::format("80 radii inside a wall, {} m/s", speed), [=] { return inside_wall(speed); });
      for (const double e : {0.0, 0.5, 1.0}) {
        for (const double u : {1e-3, 1e-9, 1e-15, 1e-18})
          rows.must_be_solved(fmt::format("grazing at u = {} m/s, e = {}", u, e), [=] { return grazing(u, e); });
      }
      for (const double scale : {1e-200, 1e200})
        rows.must_be_solved(fmt::format("speeds of {} m/s", scale), [=] { return scaled_speeds(scale); });
    }};

}  // namespace verification::extremes_solved
