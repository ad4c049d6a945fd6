// Extreme cases: what must be refused, and what must be solved.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::extremes {

using namespace particulate;

// Contacts that cannot be meant, and places that leave no direction to part, are refused with the reason.

// Two unit spheres of diameter 1 that approach.
kinematics::Particles approaching(double apart) {
  kinematics::Particles pair =
      touching_pair({.i = {.velocity = {1.0, 0.0, 0.0}, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}});
  pair.position(1, 0) = apart;
  return pair;
}

template <class R, class F>
void refuse_law(Rows& rows, const std::string& name, const std::string& key_words, const contact::Contact<R, F>& law) {
  rows.must_be_refused(name, key_words, [&] {
    contact_scene(approaching(1.0), law);
    return accepted();
  });
}

void refuse_restitution(Rows& rows) {
  using Falling = contact::Contact<contact::Restitution, contact::Frictionless>;
  for (const double bad : {not_a_number, infinite, -1e-300, 1.0 + eps, -infinite}) {
    const std::string given = fmt::format("{}", bad);
    refuse_law(rows, "restitution e = " + given, "e must [0, 1] " + given, smooth(bad));
    refuse_law(rows, "restitution e_o = " + given, "e_o must [0, 1] " + given, Falling{.restitution = {.e_o = bad}});
    refuse_law(rows, "restitution e_minus = " + given, "e_minus must " + given,
               Falling{.restitution = {.e_o = 0.5, .v_star = 1.0, .e_minus = bad}});
  }
  refuse_law(rows, "restitution e_minus > e_o", "e_minus must 0.5 0.6",
             Falling{.restitution = {.e_o = 0.5, .v_star = 1.0, .e_minus = 0.6}});
  for (const double bad : {not_a_number, 0.0, -1.0, -infinite}) {
    refuse_law(rows, fmt::format("restitution v_star = {}", bad), fmt::format("v_star must positive {}", bad),
               Falling{.restitution = {.e_o = 0.5, .v_star = bad}});
  }
}

void refuse_friction(Rows& rows) {
  for (const double bad : {not_a_number, infinite, -1e-300, -infinite}) {
    const std::string given = fmt::format("{}", bad);
    refuse_law(rows, "friction mu_d = " + given, "mu_d must " + given, rough(0.5, {.mu_s = 1.0, .mu_d = bad}));
    refuse_law(rows, "friction mu_s = " + given, "mu_s must " + given, rough(0.5, {.mu_s = bad, .mu_d = 0.0}));
  }
  refuse_law(rows, "friction mu_s < mu_d", "mu_s must mu_d 0.1 0.2", rough(0.5, {.mu_s = 0.1, .mu_d = 0.2}));
}

void refuse_gamma(Rows& rows) {
  for (const double bad : {not_a_number, infinite, -infinite, 1.0, -0.01, 2.0}) {
    contact::Contact<> law = smooth(0.5);
    law.gamma = bad;
    refuse_law(rows, fmt::format("gamma = {}", bad), fmt::format("gamma must [0, 1) {}", bad), law);
  }
}

void refuse_resolution(Rows& rows) {
  refuse_law(rows, "resolution number 7", "resolution must summed sequential 7",
             smooth(0.5, static_cast<contact::Resolution>(7)));
}

void refuse_walls(Rows& rows) {
  const auto refuse = [&](const std::string& name, const std::string& key_words, const kinematics::Wall& wall) {
    rows.must_be_refused(name, key_words, [&] {
      const kinematics::Space domain{{kinematics::Wall{}, wall}};
      scenes::Scene<kinematics::Space, contact::Contact<>>{approaching(1.0), domain, smooth(0.5)};
      return accepted();
    });
  };
  refuse("wall normal of length 2", "wall 1 normal unit 2", {.normal = {0.0, 0.0, 2.0}});
  refuse("wall normal of length 1 + 1e-6", "wall 1 normal unit", {.normal = {0.0, 0.0, 1.0 + 1e-6}});
  refuse("wall normal zero", "wall 1 normal unit 0", {.normal = {0.0, 0.0, 0.0}});
  refuse("wall normal with NaN", "wall 1 normal unit nan", {.normal = {0.0, not_a_number, 1.0}});
  refuse("wall normal infinite", "wall 1 normal unit inf", {.normal = {0.0, 0.0, infinite}});
  refuse("wall point with NaN", "wall 1 point finite nan", {.point = {not_a_number, 0.0, 0.0}});
  refuse("wall point infinite", "wall 1 point finite inf", {.point = {0.0, infinite, 0.0}});
  for (const double bad : {not_a_number, infinite}) {
    rows.must_be_refused(fmt::format("gravity of {}", bad), fmt::format("gravity finite {}", bad), [&] {
      scenes::Scene<kinematics::Space, laws::Gravity>{approaching(1.0), {}, laws::Gravity{.g = {0.0, 0.0, bad}}};
      return accepted();
    });
  }
  rows.must_be_refused("immovable flags of another number", "immovable entry 3 2", [] {
    kinematics::Particles pair = approaching(1.0);
    pair.immovable = {true, false, true};
    contact_scene(pair, smooth(0.5));
    return accepted();
  });
}

template <class Scene>
Ending ending_of(Scene scene, double step) {
  schemes::State state = scenes::start(scene);
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = step};
  return verification::ending_of(integrate(scene, state, 1.0, scheme, control));
}

void refuse_coincidence(Rows& rows) {
  kinematics::Particles together = approaching(0.0);
  together.velocity.setZero();
  rows.must_be_refused("coincident centres, contact", "same centre direction",
                       [&] { return ending_of(contact_scene(together, smooth(0.5)), 0.1); });
  together.velocity.row(0) << 1.0, 2.0, 3.0;
  together.velocity.row(1) = together.velocity.row(0);
  rows.must_be_refused("coincident centres that fly together", "same centre direction",
                       [&] { return ending_of(contact_scene(together, rough(0.5, {.mu_s = 0.2, .mu_d = 0.1})), 0.1); });
  rows.must_be_refused("a step that ends where the centres meet", "same centre direction", [] {
    kinematics::Particles meeting = approaching(2.0);
    meeting.velocity(1, 0) = -1.0;
    return ending_of(contact_scene(meeting, smooth(0.5)), 1.0);
  });
}

const Case extremes_refused{{.name = "extremes_refused",
                             .claim = "laws, walls and places that cannot be meant are refused, with the reason",
                             .equation = "M 2.16",
                             .reference = Reference::design},
                            [](Rows& rows) {
                              refuse_restitution(rows);
                              refuse_friction(rows);
                              refuse_gamma(rows);
                              refuse_resolution(rows);
                              refuse_walls(rows);
                              refuse_coincidence(rows);
                            }};

// Extreme contacts that must give an answer.

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

}  // namespace verification::extremes
