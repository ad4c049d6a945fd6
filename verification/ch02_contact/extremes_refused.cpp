// Contacts that cannot be meant, and places that leave no direction to part, are refused with the reason.

#include <functional>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::extremes_refused {

using namespace particulate;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Ending accepted() { return Ending::solved({.error = 0.0, .tolerance = 0.0, .because = "it was accepted"}); }

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
  for (const double bad : {not_a_number, infinite, -infinite, 0.0, 1.0, -0.01, 2.0}) {
    contact::Contact<> law = smooth(0.5);
    law.gamma = bad;
    refuse_law(rows, fmt::format("gamma = {}", bad), fmt::format("gamma must between {}", bad), law);
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
  const schemes::Outcome outcome = integrate(scene, state, 1.0, scheme, control);
  return outcome.status == schemes::Status::failed ? Ending::refused(outcome.reason) : accepted();
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

}  // namespace verification::extremes_refused
