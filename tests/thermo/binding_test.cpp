#include <particulate/thermo/binding.hpp>

#include <algorithm>
#include <cmath>

#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>

#include "close.hpp"
#include "clouds.hpp"
#include "says.hpp"

namespace tests::binding_test {

using boost::test_tools::tolerance;
using namespace particulate;
using kinematics::Space;
using thermo::Binding;

BOOST_AUTO_TEST_SUITE(binding_shape_)

BOOST_AUTO_TEST_CASE(is_1_halfway_and_0_at_both_ends_and_beyond) {
  BOOST_TEST(thermo::binding_shape(0.5) == 1.0);
  BOOST_TEST(thermo::binding_shape(0.25) == 0.5625);
  for (const double x : {-1.0, 0.0, 1.0, 2.0}) BOOST_TEST(thermo::binding_shape(x) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(binding_integral_)

// From 1/2: half of 8/15, by symmetry.
BOOST_AUTO_TEST_CASE(falls_from_8_15ths_to_0) {
  BOOST_TEST(thermo::binding_integral(-3.0) == 8.0 / 15.0, tolerance(1e-15));
  BOOST_TEST(thermo::binding_integral(0.5) == 4.0 / 15.0, tolerance(1e-15));
  BOOST_TEST(thermo::binding_integral(1.5) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(add_force_)

// 2 N/kg^2 between 1 and 3 kg, halfway: 6 N along x.
BOOST_AUTO_TEST_CASE(draws_two_together_by_opposite_forces) {
  const auto two = kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.2},
                                          {.position = {0.75, 0.0, 0.0}, .mass = 3.0, .radius = 0.3}});
  const scenes::Scene scene(two, Space{}, Binding{.F_b = 2.0, .d_b = 1.0});
  Eigen::VectorXd force(6);
  BOOST_TEST(scene.total_force(scenes::start(scene), force));
  BOOST_TEST(close(force, (Eigen::VectorXd(6) << 6.0, -6.0, 0.0, 0.0, 0.0, 0.0).finished(), {.relative = 1e-15}));
}

// Of a cloud that is searched, against differences of its energy.
BOOST_AUTO_TEST_CASE(is_the_slope_of_the_potential) {
  const scenes::Scene scene(random_cloud(80, {1.0, 1.0, 1.0}, 0.02, 0.06), Space{}, Binding{.F_b = 3.0, .d_b = 0.2});
  schemes::State state = scenes::start(scene);
  Eigen::VectorXd force(240);
  BOOST_TEST(scene.total_force(state, force));
  BOOST_TEST(force.lpNorm<Eigen::Infinity>() > 0.1);
  const double h = 1e-6;
  for (Eigen::Index k = 0; k < 240; k += 7) {
    const double here = state.r[k];
    state.r[k] = here + h;
    const double above = scene.potential_energy(state);
    state.r[k] = here - h;
    const double below = scene.potential_energy(state);
    state.r[k] = here;
    BOOST_TEST(excess(force[k], (below - above) / (2.0 * h), {.relative = 1e-6, .absolute = 1e-6}) <= 0.0);
  }
}

// A pair of chapter 4's spheres, with the near field: known to 15 digits.
BOOST_AUTO_TEST_CASE(balances_a_near_field_where_it_should) {
  const double m = 0.130899693899575, d_e = 0.0555182484196815;
  const auto pull_at = [&](double d) {
    const auto pair = kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = m, .radius = 0.025},
                                             {.position = {d, 0.0, 0.0}, .mass = m, .radius = 0.025}});
    const scenes::Scene scene(pair, Space{}, laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25},
                              Binding{.F_b = 200.0, .d_b = 0.08});
    Eigen::VectorXd force(6);
    BOOST_TEST(scene.total_force(scenes::start(scene), force));
    return force[0] / (m * m);
  };
  const double h = 1e-7, stiffness = (pull_at(d_e + h) - pull_at(d_e - h)) / (2.0 * h);
  BOOST_TEST(std::abs(pull_at(d_e)) < 1e-10);
  BOOST_TEST(stiffness == 23001.8434894926, tolerance(1e-7));
}

// Of a cloud in space that repeats itself, with points among it, against all pairs with their nearest images by hand.
// A second bond of twice the strength adds twice as much.
BOOST_AUTO_TEST_CASE(is_that_of_all_pairs_in_space_that_repeats_itself) {
  kinematics::Particles cloud = random_cloud(120, {1.0, 2.0, 1.5}, 0.005, 0.05);
  cloud.radius.head(20).setZero();
  cloud.mass = Eigen::VectorXd::LinSpaced(120, 0.5, 2.0);
  const Space space{.lengths = {1.0, 2.0, 1.5}};
  const Binding one{.F_b = 3.0, .d_b = 0.25}, other{.F_b = 6.0, .d_b = 0.25};
  const scenes::Scene scene(cloud, space, one, other);
  const schemes::State state = scenes::start(scene);
  kinematics::Vectors expected = kinematics::Vectors::Zero(120, 3);
  double energy = 0.0;
  long bonds = 0;
  for (Eigen::Index i = 0; i < 120; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      Eigen::Vector3d apart = cloud.position.row(j) - cloud.position.row(i);
      for (Eigen::Index k = 0; k < 3; ++k) apart[k] -= space.lengths[k] * std::round(apart[k] / space.lengths[k]);
      const double d = apart.norm(), d_0 = cloud.radius[i] + cloud.radius[j], x = (d - d_0) / (0.25 - d_0);
      if (x >= 1.0) continue;
      const double strength = 9.0 * cloud.mass[i] * cloud.mass[j], at = std::max(x, 0.0);
      energy -= strength * (0.25 - d_0) *
                (8.0 / 15.0 - 16.0 * (std::pow(at, 3) / 3.0 - std::pow(at, 4) / 2.0 + std::pow(at, 5) / 5.0));
      const Eigen::Vector3d pull = strength * 16.0 * std::pow(at * (1.0 - at), 2) / d * apart;
      expected.row(i) += pull;
      expected.row(j) -= pull;
      ++bonds;
    }
  }
  BOOST_TEST(bonds > 100);
  Eigen::VectorXd force(360);
  BOOST_TEST(scene.total_force(state, force));
  BOOST_TEST(close(force, Eigen::VectorXd(expected.reshaped()), {.relative = 1e-12, .absolute = 1e-12}));
  BOOST_TEST(scene.potential_energy(state) == energy, tolerance(1e-12));
}

// What coincides has no direction and needs none; what is immovable pulls and stays; what is not finite has no force.
BOOST_AUTO_TEST_CASE(has_a_value_where_bodies_coincide_and_none_where_one_is_nowhere) {
  const auto three =
      kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                             {.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                             {.position = {0.5, 0.0, 0.0}, .mass = 2.0, .radius = 0.0, .immovable = true}});
  const scenes::Scene scene(three, Space{}, Binding{.F_b = 1.0, .d_b = 1.0});
  schemes::State state = scenes::start(scene);
  Eigen::VectorXd a(9);
  BOOST_TEST(scene.acceleration(0.0, state.r, a));
  BOOST_TEST(close(a.head(3), Eigen::Vector3d(2.0, 2.0, 0.0), {.relative = 1e-15}));
  BOOST_TEST(scene.potential_energy(state) == -8.0 / 15.0 - 4.0 * 4.0 / 15.0, tolerance(1e-15));
  state.r[0] = NAN;
  BOOST_TEST(!scene.acceleration(0.0, state.r, a));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_a_reach_within_touching_and_beyond_half_a_period) {
  const auto cloud = random_cloud(3, {1.0, 1.0, 1.0}, 0.1, 0.1);
  const auto scene_of = [&](const Space& space, const Binding& law) { return scenes::Scene(cloud, space, law); };
  CHECK_REFUSED(scene_of({}, {.F_b = 1.0, .d_b = 0.2}), "above the sum of any two radii");
  CHECK_REFUSED(scene_of({}, {.F_b = -1.0, .d_b = 0.3}), "F_b must be finite and not negative, got -1 N/kg^2");
  CHECK_REFUSED(scene_of({.lengths = {1.0, 1.0, 1.0}}, {.F_b = 1.0, .d_b = 0.6}), "half the shortest period");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::binding_test
