#include <particulate/kinematics/similarity.hpp>

#include "close.hpp"

namespace tests::similarity_test {

using namespace particulate::kinematics;

const Dimensional scene{.law = {.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 2.0, .beta2 = 3.0},
                        .mass = 1.5,
                        .speed = 0.9,
                        .radius = 0.05,
                        .step = 0.011};

// The scene as it reads in units that are larger by `by`.
Dimensional grown(const Dimensional& small, const Scales& by) {
  return {.law = scaled(small.law, by),
          .mass = small.mass * by.mass,
          .speed = small.speed * by.length / by.time,
          .radius = small.radius * by.length,
          .step = small.step * by.time};
}

void same(const SimilarityGroups& a, const SimilarityGroups& b, double tolerance) {
  BOOST_TEST(a.attraction == b.attraction, boost::test_tools::tolerance(tolerance));
  BOOST_TEST(a.repulsion == b.repulsion, boost::test_tools::tolerance(tolerance));
  BOOST_TEST(a.speed == b.speed, boost::test_tools::tolerance(tolerance));
  BOOST_TEST(a.radius == b.radius, boost::test_tools::tolerance(tolerance));
  BOOST_TEST(a.step == b.step, boost::test_tools::tolerance(tolerance));
}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_the_scale_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(Scales{}));
  CHECK_REFUSED(validate(Scales{.length = 0.0}), "length must be positive and finite, got 0 m");
  CHECK_REFUSED(validate(Scales{.time = not_a_number}), "time must be positive and finite, got nan s");
  CHECK_REFUSED(validate(Scales{.mass = infinity}), "mass must be positive and finite, got inf kg");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(similarity_groups_)

// L = 2, tau = 3: pi_1 = 0.7 1.5 9/8, pi_2 = 0.3 1.5 9/16, 0.9 3/2, 0.05/2, 0.011/3.
BOOST_AUTO_TEST_CASE(are_the_five_dimensionless_numbers) {
  const SimilarityGroups groups = similarity_groups(scene, {.length = 2.0, .time = 3.0});
  same(groups, {.attraction = 1.18125, .repulsion = 0.253125, .speed = 1.35, .radius = 0.025, .step = 0.011 / 3.0},
       1e-15);
}

BOOST_AUTO_TEST_CASE(do_not_change_when_scene_and_units_grow_together) {
  const Scales units{.length = 0.4, .time = 0.7}, by{.length = 3.3, .time = 0.19, .mass = 41.0};
  const Scales grown_units{.length = units.length * by.length, .time = units.time * by.time};
  same(similarity_groups(grown(scene, by), grown_units), similarity_groups(scene, units), 1e-14);
}

BOOST_AUTO_TEST_CASE(keep_their_bits_under_powers_of_two) {
  const Scales units{.length = 0.4, .time = 0.7}, by{.length = 8.0, .time = 0.25, .mass = 32.0};
  const Scales grown_units{.length = units.length * by.length, .time = units.time * by.time};
  const SimilarityGroups a = similarity_groups(grown(scene, by), grown_units), b = similarity_groups(scene, units);
  BOOST_TEST(a.attraction == b.attraction);
  BOOST_TEST(a.repulsion == b.repulsion);
  BOOST_TEST(a.speed == b.speed);
  BOOST_TEST(a.radius == b.radius);
  BOOST_TEST(a.step == b.step);
}

BOOST_AUTO_TEST_CASE(refuse_scales_that_are_none) {
  CHECK_REFUSED(similarity_groups(scene, {.length = -1.0}), "length must be positive");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(scaled_law)

// alpha_1' = 0.7 2^3/(5 9) and alpha_2' = 0.3 2^4/(5 9).
BOOST_AUTO_TEST_CASE(multiplies_by_length_and_divides_by_mass_and_time_squared) {
  const CentralForce law = scaled(scene.law, {.length = 2.0, .time = 3.0, .mass = 5.0});
  BOOST_TEST(law.alpha1 == 5.6 / 45.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(law.alpha2 == 4.8 / 45.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(law.beta1 == 2.0);
  BOOST_TEST(law.beta2 == 3.0);
}

// Between masses M m at a distance L d it must pull M L/tau^2 times as hard; exponents that are not whole.
BOOST_AUTO_TEST_CASE(scales_the_force_like_mass_times_acceleration) {
  const CentralForce law{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 0.5, .beta2 = 7.3};
  const Scales by{.length = 3.3, .time = 0.19, .mass = 41.0};
  const double scaled_force = by.mass * by.mass * strength(scaled(law, by), 0.8 * by.length);
  BOOST_TEST(scaled_force == strength(law, 0.8) * by.mass * by.length / (by.time * by.time),
             boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(refuses_scales_that_are_none) {
  CHECK_REFUSED(scaled(scene.law, {.time = 0.0}), "time must be positive");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(scaled_particles)

BOOST_AUTO_TEST_CASE(multiplies_each_quantity_by_its_own_unit) {
  const Particles one{.position = Vectors{{1.0, -2.0, 3.0}},
                      .velocity = Vectors{{4.0, 0.0, -8.0}},
                      .mass = Eigen::VectorXd::Constant(1, 0.5),
                      .radius = Eigen::VectorXd::Constant(1, 0.25)};
  const Particles big = scaled(one, {.length = 3.0, .time = 4.0, .mass = 10.0});
  BOOST_TEST(close(big.position, Vectors{{3.0, -6.0, 9.0}}, {}));
  BOOST_TEST(close(big.velocity, Vectors{{3.0, 0.0, -6.0}}, {}));
  BOOST_TEST(big.mass[0] == 5.0);
  BOOST_TEST(big.radius[0] == 0.75);
}

BOOST_AUTO_TEST_CASE(refuses_scales_that_are_none) {
  CHECK_REFUSED(scaled(Particles{}, {.mass = not_a_number}), "mass must be positive");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::similarity_test
