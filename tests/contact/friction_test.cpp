#include <particulate/contact/friction.hpp>

#include "close.hpp"

namespace tests::friction_test {

using namespace particulate::contact;

const Friction rough{.mu_s = 0.5, .mu_d = 0.25};
const Eigen::Vector3d slip(3.0, 4.0, 0.0);  // 5 m/s

BOOST_AUTO_TEST_SUITE(tangential_impulse_)

// Stopping 5 m/s of 2 kg takes 10 N s, which mu_s J = 0.5 20 N s just holds.
BOOST_AUTO_TEST_CASE(stops_the_slip_where_it_can) {
  BOOST_TEST(close(tangential_impulse(rough, slip, 2.0, 20.0), Eigen::Vector3d(-6.0, -8.0, 0.0), {}));
  BOOST_TEST(close(tangential_impulse(rough, slip, 2.0, 1e9), Eigen::Vector3d(-6.0, -8.0, 0.0), {}));
}

// Just below that it slides: mu_d J = 0.25 19 = 4.75 N s against (0.6, 0.8, 0).
BOOST_AUTO_TEST_CASE(slides_with_the_dynamic_coefficient_where_it_cannot) {
  BOOST_TEST(close(tangential_impulse(rough, slip, 2.0, 19.0), Eigen::Vector3d(-2.85, -3.8, 0.0), {.relative = 1e-15}));
}

// Whatever normal impulse: what the sliding leaves, slip + P/m*, points the way of the slip or vanishes.
BOOST_AUTO_TEST_CASE(never_reverses_the_sliding) {
  for (const double mu_d : {0.0, 0.25, 0.4999, 0.5}) {
    for (double normal = 1e-3; normal < 1e3; normal *= 1.01) {
      const Eigen::Vector3d left = slip + tangential_impulse({.mu_s = 0.5, .mu_d = mu_d}, slip, 2.0, normal) / 2.0;
      BOOST_REQUIRE(left.dot(slip) >= 0.0);
      BOOST_REQUIRE(left.norm() <= slip.norm() * (1.0 + 1e-15));
    }
  }
}

BOOST_AUTO_TEST_CASE(vanishes_without_slip_without_push_and_without_coefficients) {
  BOOST_TEST(close(tangential_impulse(rough, Eigen::Vector3d::Zero(), 2.0, 3.0), Eigen::Vector3d::Zero(), {}));
  BOOST_TEST(close(tangential_impulse(rough, Eigen::Vector3d::Zero(), 2.0, 0.0), Eigen::Vector3d::Zero(), {}));
  BOOST_TEST(close(tangential_impulse(rough, slip, 2.0, 0.0), Eigen::Vector3d::Zero(), {}));
  BOOST_TEST(close(tangential_impulse({}, slip, 2.0, 3.0), Eigen::Vector3d::Zero(), {}));
}

// The squares of such slips leave the doubles.
BOOST_AUTO_TEST_CASE(finds_the_direction_of_huge_and_of_tiny_slips) {
  for (const double size : {1e-200, 1e200}) {
    const Eigen::Vector3d sliding = tangential_impulse(rough, size * slip, 2.0, size);
    BOOST_TEST(close(sliding / size, Eigen::Vector3d(-0.15, -0.2, 0.0), {.relative = 1e-14}));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(stopping_friction_)

// 3/((1 + 0.5) 4) = 0.5.
BOOST_AUTO_TEST_CASE(is_the_tangential_over_the_whole_change_of_the_normal_speed) {
  BOOST_TEST(stopping_friction(3.0, 4.0, 0.5) == 0.5);
  BOOST_TEST(stopping_friction(0.0, 4.0, 0.5) == 0.0);
}

// |J| = (1 + e) m* u_n: with mu_d = mu_d* sliding stops the slip exactly, one percent less leaves one percent of it.
BOOST_AUTO_TEST_CASE(just_stops_the_sliding_whatever_the_mass) {
  for (const double reduced_mass : {1e-12, 1.0, 1e12}) {
    const double push = 1.5 * reduced_mass * 4.0;
    const double mu = stopping_friction(5.0, 4.0, 0.5);
    const auto left = [&](double mu_d) -> Eigen::Vector3d {
      return slip + tangential_impulse({.mu_s = mu_d, .mu_d = mu_d}, slip, reduced_mass, push) / reduced_mass;
    };
    BOOST_TEST(close(left(mu), Eigen::Vector3d::Zero(), {.absolute = 1e-14}));
    BOOST_TEST(close(left(0.99 * mu), 0.01 * slip, {.relative = 1e-13}));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_no_friction_equal_coefficients_and_large_ones) {
  BOOST_CHECK_NO_THROW(validate(Friction{}));
  BOOST_CHECK_NO_THROW(validate(Friction{.mu_s = 0.5, .mu_d = 0.5}));
  BOOST_CHECK_NO_THROW(validate(Friction{.mu_s = 1e6, .mu_d = 0.0}));
}

BOOST_AUTO_TEST_CASE(names_the_coefficient_that_is_none) {
  const auto refuses = [](const Friction& law, const char* words) { CHECK_REFUSED(validate(law), words); };
  refuses({.mu_s = 0.5, .mu_d = -0.1}, "friction: mu_d must be finite and not negative, got -0.1");
  refuses({.mu_s = 0.5, .mu_d = not_a_number}, "mu_d must be finite and not negative, got nan");
  refuses({.mu_s = infinity, .mu_d = infinity}, "mu_d must be finite and not negative, got inf");
  refuses({.mu_s = 0.1, .mu_d = 0.2}, "friction: mu_s must be finite and at least mu_d = 0.2, got 0.1");
  refuses({.mu_s = not_a_number, .mu_d = 0.2}, "mu_s must be finite and at least mu_d = 0.2, got nan");
  refuses({.mu_s = infinity, .mu_d = 0.2}, "mu_s must be finite and at least mu_d = 0.2, got inf");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::friction_test
