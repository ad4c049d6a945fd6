#include <particulate/contact/impact.hpp>

#include <algorithm>
#include <cmath>

#include "close.hpp"

namespace tests::impact_test {

using namespace particulate::contact;

const Eigen::Vector3d nothing = Eigen::Vector3d::Zero();
const Eigen::Vector3d along_x = Eigen::Vector3d::UnitX();

double energy(double mass, const Eigen::Vector3d& v) { return 0.5 * mass * v.squaredNorm(); }

// Two bodies of 2 and 3 kg that close at 4 m/s along x, and other forces on them.
struct Setting {
  Body i{.velocity = {3.0, 1.0, 0.0}, .inverse_mass = 0.5};
  Body j{.velocity = {-1.0, 0.0, 2.0}, .inverse_mass = 1.0 / 3.0};
  Eigen::Vector3d force_i{8.0, -2.0, 1.0}, force_j{-6.0, 3.0, 0.0};  // N
  double duration = 0.125, e = 0.6;

  template <class F>
  Rebound rebound(const F& friction) const {
    return impact(i, j, along_x, e, force_i / 2.0, force_j / 3.0, duration, friction);
  }
};

BOOST_AUTO_TEST_SUITE(phases_)

// 0.3/1.5 = 0.2 of compression and half as much recovery.
BOOST_AUTO_TEST_CASE(share_the_duration_as_one_to_e) {
  const Phases split = phases(0.3, 0.5);
  BOOST_TEST(split.compression == 0.2, tolerance(1e-15));
  BOOST_TEST(split.recovery == 0.1, tolerance(1e-15));
  BOOST_TEST(phases(0.3, 0.0).compression == 0.3);
  BOOST_TEST(phases(0.3, 0.0).recovery == 0.0);
  BOOST_TEST(phases(0.3, 1.0).recovery == 0.15);
  BOOST_TEST(phases(0.0, 1.0).compression == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(external_changes_)

// (4 - 1, 0, 2) m/s^2 over 0.5 and 0.25 s.
BOOST_AUTO_TEST_CASE(are_those_of_the_relative_velocity) {
  const External changes = external_changes({4.0, 1.0, 2.0}, {1.0, 1.0, 0.0}, {.compression = 0.5, .recovery = 0.25});
  BOOST_TEST(close(changes.compression, Eigen::Vector3d(1.5, 0.0, 1.0), {}));
  BOOST_TEST(close(changes.recovery, Eigen::Vector3d(0.75, 0.0, 0.5), {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(normal_impulse_)

// -(1 + 0.5) 1.2 (4 + 1) = -9.
BOOST_AUTO_TEST_CASE(turns_the_approach_that_other_forces_leave) {
  BOOST_TEST(normal_impulse(4.0, 1.0, 0.5, 1.2) == -9.0, tolerance(1e-15));
  BOOST_TEST(normal_impulse(4.0, -3.5, 0.0, 2.0) == -1.0);
}

BOOST_AUTO_TEST_CASE(acts_on_what_approaches_and_goes_on_approaching_only) {
  BOOST_TEST(normal_impulse(0.0, 1.0, 0.5, 1.0) == 0.0);
  BOOST_TEST(normal_impulse(-1.0, 5.0, 0.5, 1.0) == 0.0);
  BOOST_TEST(normal_impulse(1.0, -1.0, 0.5, 1.0) == 0.0);
  BOOST_TEST(normal_impulse(1.0, -2.0, 0.5, 1.0) == 0.0);
  BOOST_TEST(normal_impulse(1.0, -0.999, 0.5, 1.0) < 0.0);
  BOOST_TEST(normal_impulse(1e-300, 0.0, 0.5, 1.0) < 0.0);
}

BOOST_AUTO_TEST_CASE(vanishes_between_two_immovable_bodies) {
  BOOST_TEST(normal_impulse(1.0, 0.0, 0.5, infinity) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(impact_impulse_)

// m* = 1.2, J = -1.6 1.2 4 = -7.68.
BOOST_AUTO_TEST_CASE(points_along_the_normal_without_friction) {
  const Setting s;
  const Impulse impulse = impact_impulse(s.i, s.j, along_x, s.e, {}, Frictionless{});
  BOOST_TEST(impulse.normal == -7.68, tolerance(1e-15));
  BOOST_TEST(close(impulse.tangential, nothing, {}));
  BOOST_TEST(close(impulse.total(along_x), Eigen::Vector3d(impulse.normal, 0.0, 0.0), {}));
}

// The slip is (0, 1, -2): stopping it takes 1.2 sqrt 5 = 2.683 N s. mu_s 7.68 = 3.07 holds it with mu_s = 0.4, not with
// 0.3, where mu_d = 0.2 slides with 1.536 N s.
BOOST_AUTO_TEST_CASE(sticks_or_slides_across_it_with_friction) {
  const Setting s;
  const Impulse stuck = impact_impulse(s.i, s.j, along_x, s.e, {}, Friction{.mu_s = 0.4, .mu_d = 0.2});
  const Impulse slid = impact_impulse(s.i, s.j, along_x, s.e, {}, Friction{.mu_s = 0.3, .mu_d = 0.2});
  BOOST_TEST(close(stuck.tangential, Eigen::Vector3d(0.0, -1.2, 2.4), {.relative = 1e-15}));
  BOOST_TEST(close(slid.tangential, 1.536 / std::sqrt(5.0) * Eigen::Vector3d(0.0, -1.0, 2.0), {.relative = 1e-14}));
  BOOST_TEST(stuck.normal == slid.normal);
  BOOST_TEST(close(slid.total(along_x), slid.normal * along_x + slid.tangential, {}));
}

// u_t + Delta_t = (0, 1, -2) + (0, 0.25, 0) + (0, 0.5, 0), while the normal parts of both changes belong to J.
BOOST_AUTO_TEST_CASE(stops_what_other_forces_add_to_the_slip_in_both_phases) {
  const Setting s;
  const External external{.compression = {0.5, 0.25, 0.0}, .recovery = {7.0, 0.5, 0.0}};
  const Impulse stuck = impact_impulse(s.i, s.j, along_x, s.e, external, Friction{.mu_s = 10.0, .mu_d = 0.0});
  BOOST_TEST(stuck.normal == -1.6 * 1.2 * 4.5, tolerance(1e-15));
  BOOST_TEST(close(stuck.tangential, -1.2 * Eigen::Vector3d(0.0, 1.75, -2.0), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(has_no_friction_where_nothing_presses) {
  Setting s;
  s.i.velocity.x() = -1.5;
  const Impulse none = impact_impulse(s.i, s.j, along_x, s.e, {}, Friction{.mu_s = 1.0, .mu_d = 1.0});
  BOOST_TEST(close(none.total(along_x), nothing, {}));
}

BOOST_AUTO_TEST_CASE(changes_its_sign_with_the_roles_of_the_bodies) {
  const Setting s;
  const Friction rough{.mu_s = 0.3, .mu_d = 0.2};
  const External there{.compression = {0.5, 0.25, 0.0}, .recovery = {0.25, 0.5, 0.0}};
  const External back{.compression = -there.compression, .recovery = -there.recovery};
  const Impulse on_i = impact_impulse(s.i, s.j, along_x, s.e, there, rough);
  const Impulse on_j = impact_impulse(s.j, s.i, -along_x, s.e, back, rough);
  BOOST_TEST(close(on_i.total(along_x), -on_j.total(-along_x), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(vanishes_between_two_immovable_bodies) {
  const Body driven{.velocity = {1.0, 2.0, 0.0}, .inverse_mass = 0.0};
  const Impulse none = impact_impulse(driven, Body{}, along_x, 0.5, {}, Friction{.mu_s = 1.0, .mu_d = 1.0});
  BOOST_TEST(close(none.total(along_x), nothing, {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(impact_)

// The monograph's form, evaluated apart: the accelerations are (4, -1, 0.5) and (-2, 1, 0), dt_1 = 0.125/1.6,
// Delta_1 = 6 dt_1 = 0.46875, Delta_2 = 0.6 Delta_1 = 0.28125, E_in = 1, E_jn = -0.75, e (u + Delta_1) - Delta_2 =
// 0.6 4.46875 - 0.28125 = 2.4; v_in' = (6 - 3 + 0.25 - 3 2.4)/5 = -0.79, v_jn' = -0.79 + 2.4 = 1.61.
BOOST_AUTO_TEST_CASE(is_the_map_of_the_monograph_with_other_forces) {
  const Rebound after = Setting{}.rebound(Frictionless{});
  BOOST_TEST(after.velocity_i.x() == -0.79, tolerance(1e-14));
  BOOST_TEST(after.velocity_j.x() == 1.61, tolerance(1e-14));
  BOOST_TEST(after.impulse.normal == -1.6 * 1.2 * 4.46875, tolerance(1e-15));  // = 2 (-0.79 - 3) - 1
  BOOST_TEST(after.impulse.normal == 2.0 * (-0.79 - 3.0) - 1.0, tolerance(1e-14));
  // Across the normal the forces act alone: 1 - 0.125, 0.5 0.125, 0.125, 2.
  BOOST_TEST(close(after.velocity_i.tail<2>(), Eigen::Vector2d(0.875, 0.0625), {.relative = 1e-15}));
  BOOST_TEST(close(after.velocity_j.tail<2>(), Eigen::Vector2d(0.125, 2.0), {.relative = 1e-15}));
}

// Sticking leaves no slip after the duration, the forces' share included.
BOOST_AUTO_TEST_CASE(leaves_no_slip_where_it_sticks) {
  const Rebound after = Setting{}.rebound(Friction{.mu_s = 1.0, .mu_d = 0.5});
  BOOST_TEST(close(after.velocity_i.tail<2>(), after.velocity_j.tail<2>(), {.relative = 1e-15, .absolute = 1e-15}));
}

// Delta_2 = e Delta_1, so v_jn' - v_in' = e (u + Delta_1) - Delta_2 = e u.
BOOST_AUTO_TEST_CASE(parts_with_e_times_the_approach_speed_whatever_the_forces) {
  for (const double e : {0.0, 0.25, 0.6, 1.0}) {
    for (const double force : {-60.0, 0.0, 8.0, 1000.0}) {
      Setting s;
      s.e = e;
      s.force_i.x() = force;
      const Rebound after = s.rebound(Frictionless{});
      const double apart = after.velocity_j.x() - after.velocity_i.x();
      BOOST_TEST(std::abs(apart - e * 4.0) <= 8.0 * eps * 70.0);
    }
  }
}

// u = 4, but -400/2 m/s^2 over 0.125/1.6 s take 15.6 m/s of it.
BOOST_AUTO_TEST_CASE(lets_the_forces_act_alone_where_they_part_the_bodies) {
  Setting s;
  s.force_i.x() = -400.0;
  const Rebound after = s.rebound(Friction{.mu_s = 1.0, .mu_d = 1.0});
  BOOST_TEST(close(after.impulse.total(along_x), nothing, {}));
  BOOST_TEST(close(after.velocity_i, Eigen::Vector3d(3.0 - 25.0, 0.875, 0.0625), {.relative = 1e-15}));
  BOOST_TEST(close(after.velocity_j, Eigen::Vector3d(-1.25, 0.125, 2.0), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(keeps_the_momentum_that_the_forces_leave) {
  const Setting s;
  for (const double mu : {0.0, 0.1, 10.0}) {
    const Rebound after = s.rebound(Friction{.mu_s = mu, .mu_d = mu});
    const Eigen::Vector3d before = 2.0 * s.i.velocity + 3.0 * s.j.velocity + s.duration * (s.force_i + s.force_j);
    BOOST_TEST(close(2.0 * after.velocity_i + 3.0 * after.velocity_j, before, {.relative = 1e-14, .absolute = 1e-14}));
  }
}

// Equal masses exchange their normal velocities at e = 1 and share them at e = 0.
BOOST_AUTO_TEST_CASE(of_equal_masses_exchanges_or_shares_the_normal_velocities) {
  const Body i{.velocity = {2.0, 1.0, 0.0}, .inverse_mass = 0.25},
      j{.velocity = {-1.0, 0.0, 3.0}, .inverse_mass = 0.25};
  const Rebound elastic = impact(i, j, along_x, 1.0, nothing, nothing, 0.0, Frictionless{});
  BOOST_TEST(close(elastic.velocity_i, Eigen::Vector3d(-1.0, 1.0, 0.0), {}));
  BOOST_TEST(close(elastic.velocity_j, Eigen::Vector3d(2.0, 0.0, 3.0), {}));
  const Rebound plastic = impact(i, j, along_x, 0.0, nothing, nothing, 0.0, Frictionless{});
  BOOST_TEST(close(plastic.velocity_i, Eigen::Vector3d(0.5, 1.0, 0.0), {}));
  BOOST_TEST(close(plastic.velocity_j, Eigen::Vector3d(0.5, 0.0, 3.0), {}));
}

BOOST_AUTO_TEST_CASE(leaves_an_immovable_partner_alone) {
  const Body ball{.velocity = {2.0, 1.0, 0.0}, .inverse_mass = 4.0};
  const Rebound after = impact(ball, Body{}, along_x, 0.5, nothing, nothing, 0.0, Frictionless{});
  BOOST_TEST(close(after.velocity_i, Eigen::Vector3d(-1.0, 1.0, 0.0), {}));
  BOOST_TEST(close(after.velocity_j, nothing, {}));
  BOOST_TEST(after.impulse.normal == -0.75);
}

// Restitution in is restitution out. A partner 1e12 times as heavy moves by 2e-12 of what the light one does.
BOOST_AUTO_TEST_CASE(takes_mass_ratios_of_a_million_millions) {
  for (const double ratio : {1e-12, 1e12}) {
    for (const double e : {0.0, 0.3, 1.0}) {
      const Body i{.velocity = {2.0, 0.0, 0.0}, .inverse_mass = 1.0}, j{.velocity = nothing, .inverse_mass = ratio};
      const Rebound after = impact(i, j, along_x, e, nothing, nothing, 0.0, Frictionless{});
      const double apart = after.velocity_j.x() - after.velocity_i.x();
      const double fastest = std::max({2.0, after.velocity_i.norm(), after.velocity_j.norm()});
      BOOST_TEST(std::abs(apart / 2.0 - e) <= 8.0 * eps * fastest / 2.0);
      BOOST_TEST(after.velocity_i.x() + after.velocity_j.x() / ratio == 2.0, tolerance(1e-14));
    }
  }
}

// 1/2 m* ((1 - e^2) u^2) and friction's: sliding takes P (|u_t| + |u_t'|)/2.
BOOST_AUTO_TEST_CASE(loses_the_energy_of_the_closed_form_and_frictions_work) {
  const Setting s;
  const auto lost = [&](const auto& friction) {
    const Rebound after = impact(s.i, s.j, along_x, s.e, nothing, nothing, 0.0, friction);
    return energy(2.0, s.i.velocity) + energy(3.0, s.j.velocity) - energy(2.0, after.velocity_i) -
           energy(3.0, after.velocity_j);
  };
  const double normal = 0.5 * 1.2 * (1.0 - 0.36) * 16.0;
  const double push = 0.2 * 7.68, slip = std::sqrt(5.0);
  BOOST_TEST(lost(Frictionless{}) == normal, tolerance(1e-14));
  BOOST_TEST(lost(Friction{.mu_s = 1.0, .mu_d = 0.2}) == normal + 0.5 * 1.2 * 5.0, tolerance(1e-14));
  BOOST_TEST(lost(Friction{.mu_s = 0.2, .mu_d = 0.2}) == normal + push * (slip - 0.5 * push / 1.2), tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(normal_heat_)

BOOST_AUTO_TEST_CASE(is_the_loss_where_no_other_force_acts) {
  BOOST_TEST(normal_heat(4.0, 0.0, 0.0, 0.5, 1.2) == 0.5 * 1.2 * 0.75 * 16.0, tolerance(1e-15));
  BOOST_TEST(normal_heat(4.0, 0.0, 0.0, 1.0, 1.2) == 0.0);
}

// Energy lost plus the work of the other forces. The pair's centre has no part in it: the forces change the relative
// velocity by Delta_1 on the way from u to 0 and by Delta_2 on the way from 0 to u', with mean velocities u/2 and u'/2.
BOOST_AUTO_TEST_CASE(is_the_kinetic_energy_lost_plus_the_work_of_the_other_forces) {
  for (const double e : {0.0, 0.6, 1.0}) {
    Setting s;
    s.e = e;
    const Rebound after = s.rebound(Frictionless{});
    const double delta1 = 6.0 * 0.125 / (1.0 + e), delta2 = e * delta1;
    const double u = 4.0, out = after.velocity_i.x() - after.velocity_j.x();
    const double lost = 0.5 * 1.2 * (u * u - out * out);
    const double work = 1.2 * (delta1 * 0.5 * u + delta2 * 0.5 * out);
    BOOST_TEST(normal_heat(u, delta1, delta2, e, 1.2) == lost + work, tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::impact_test
