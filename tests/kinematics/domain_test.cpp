#include <particulate/kinematics/domain.hpp>

#include <cmath>

#include "close.hpp"

namespace tests::domain_test {

using namespace particulate::kinematics;

struct WithoutSeparation {};

// Single precision would lose what the laws are entitled to.
struct Coarse {};
[[maybe_unused]] Eigen::Vector3f separation(const Coarse&, const Eigen::Vector3d&, const Eigen::Vector3d&) {
  return Eigen::Vector3f::Zero();
}

static_assert(Domain<Space> && HasWalls<Space>);
static_assert(!Domain<WithoutSeparation>, "a type is no domain without a separation");
static_assert(!Domain<Coarse>, "a separation is a Vector3d");

BOOST_AUTO_TEST_SUITE(separation_)

BOOST_AUTO_TEST_CASE(leads_from_the_first_place_to_the_second) {
  const Eigen::Vector3d from(1.0, -2.0, 0.5), to(4.0, 2.0, 0.25);
  BOOST_TEST(close(separation(Space{}, from, to), Eigen::Vector3d(3.0, 4.0, -0.25), {}));
  BOOST_TEST(close(separation(Space{}, from, to), -separation(Space{}, to, from), {}));
}

BOOST_AUTO_TEST_CASE(passes_through_walls) {
  const Space halves{{Wall{.point = {2.0, 0.0, 0.0}, .normal = {1.0, 0.0, 0.0}}}};
  const Eigen::Vector3d from(1.0, -2.0, 0.5), to(4.0, 2.0, 0.25);
  BOOST_TEST(close(separation(halves, from, to), Eigen::Vector3d(3.0, 4.0, -0.25), {}));
}

BOOST_AUTO_TEST_CASE(vanishes_between_a_place_and_itself) {
  const Eigen::Vector3d here(1e300, -1e-300, 0.1);
  BOOST_TEST(close(separation(Space{}, here, here), Eigen::Vector3d::Zero(), {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(separation_in_periods)

const Space tube{.lengths = {1.0, infinity, 2.0}};

BOOST_AUTO_TEST_CASE(leads_to_the_nearest_image_across_a_corner) {
  BOOST_TEST(close(separation(tube, {0.1, 0.1, 0.1}, {0.95, 0.95, 1.95}), Eigen::Vector3d(-0.15, 0.85, -0.15),
                   {.absolute = 1e-15}));
}

BOOST_AUTO_TEST_CASE(is_the_same_after_any_number_of_periods) {
  const Eigen::Vector3d here(0.25, 0.5, 0.75), there(0.5, 0.125, 1.0);
  for (const double n : {-1e6, -1.0, 1.0, 2.0, 1e6}) {
    BOOST_TEST(close(separation(tube, here, there + Eigen::Vector3d(n, 0.0, -4.0 * n)),
                     Eigen::Vector3d(0.25, -0.375, 0.25), {}));
  }
}

BOOST_AUTO_TEST_CASE(changes_its_sign_with_the_direction_also_at_half_a_period) {
  const Eigen::Vector3d from(0.0, 0.0, 0.25);
  for (const double x : {0.25, 0.5, 0.75, 1.5, 2.5}) {
    const Eigen::Vector3d to(x, 3.0, 1.25 + x);
    BOOST_TEST(close(separation(tube, from, to), -separation(tube, to, from), {}));
    BOOST_TEST(separation(tube, from, to).cwiseAbs().x() <= 0.5);
  }
}

BOOST_AUTO_TEST_CASE(has_no_value_where_a_place_has_none) {
  BOOST_TEST(std::isnan(separation(tube, {not_a_number, 0.0, 0.0}, {0.0, 0.0, 0.0}).x()));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(wrapped_)

BOOST_AUTO_TEST_CASE(brings_a_place_into_the_first_period) {
  const Space tube{.lengths = {1.0, infinity, 2.0}};
  BOOST_TEST(close(wrapped(tube, {-0.25, -7.0, 5.5}), Eigen::Vector3d(0.75, -7.0, 1.5), {}));
  BOOST_TEST(close(wrapped(tube, {1.0, 1.0, -2.0}), Eigen::Vector3d(0.0, 1.0, 0.0), {}));
  BOOST_TEST(wrapped(tube, {-1e-20, 0.0, 0.0}).x() == 0.0);  // a length less that, rounded, is the length
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(has_periods_)

BOOST_AUTO_TEST_CASE(where_any_length_is_finite) {
  BOOST_TEST(!has_periods(Space{}));
  BOOST_TEST(has_periods(Space{.lengths = {infinity, infinity, 3.0}}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_periods_)

BOOST_AUTO_TEST_CASE(wants_two_diameters_of_the_largest_body) {
  const Eigen::VectorXd radius = Eigen::Vector3d(0.1, 0.25, 0.0);
  BOOST_CHECK_NO_THROW(validate_periods(Space{.lengths = {1.0, infinity, 1.0}}, radius));
  BOOST_CHECK_NO_THROW(validate_periods(Space{.lengths = {1.0, 1.0, 1.0}}, Eigen::VectorXd()));
  CHECK_REFUSED(validate_periods(Space{.lengths = {1.0, 0.999, infinity}}, radius),
                "space: its length in direction y must be at least two diameters of the largest body, 1 m with "
                "particle 1, got 0.999 m: lengthen it, or take smaller bodies");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(height_above_)

// ((1, 2, 3) - (0, 0, 1)).(0.6, 0, 0.8) = 0.6 + 1.6.
BOOST_AUTO_TEST_CASE(is_measured_along_the_normal) {
  const Wall tilted{.point = {0.0, 0.0, 1.0}, .normal = {0.6, 0.0, 0.8}};
  BOOST_TEST(height_above(tilted, {1.0, 2.0, 3.0}) == 2.2, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(height_above(tilted, {0.0, 1e9, 1.0}) == 0.0);
  BOOST_TEST(height_above(tilted, {0.0, 0.0, -4.0}) == -4.0, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(of_a_wall_that_nobody_describes_is_z) { BOOST_TEST(height_above(Wall{}, {1.0, 2.0, 3.0}) == 3.0); }

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(walls_)

BOOST_AUTO_TEST_CASE(are_those_of_the_domain_in_order) {
  const Space room{{Wall{}, Wall{.point = {0.0, 0.0, 2.0}, .normal = {0.0, 0.0, -1.0}}}};
  BOOST_REQUIRE(walls(room).size() == 2U);
  BOOST_TEST(walls(room)[1].point.z() == 2.0);
  BOOST_TEST(walls(Space{}).empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_unit_normals_to_rounding_and_no_wall_at_all) {
  BOOST_CHECK_NO_THROW(validate(Space{}));
  const double third = 1.0 / std::sqrt(3.0);
  BOOST_CHECK_NO_THROW(validate(Space{{Wall{}, Wall{.normal = {third, third, -third}}}}));
}

BOOST_AUTO_TEST_CASE(names_the_wall_what_must_hold_and_what_was_given) {
  const auto refuses = [](const Wall& wall, const char* words) {
    CHECK_REFUSED(validate(Space{{Wall{}, wall}}), words);
  };
  refuses({.normal = {0.0, 3.0, 4.0}}, "wall 1: its normal must be a unit vector, got (0, 3, 4) of length 5; divide");
  refuses({.normal = {0.0, 0.0, 1.000001}}, "wall 1: its normal must be a unit vector");
  refuses({.normal = Eigen::Vector3d::Zero()}, "got (0, 0, 0) of length 0");
  refuses({.normal = {not_a_number, 0.0, 1.0}}, "got (nan, 0, 1) of length nan");
  refuses({.point = {0.0, not_a_number, 0.0}}, "wall 1: its point must be finite, got (0, nan, 0) m");
  refuses({.point = {0.0, 0.0, infinity}}, "got (0, 0, inf) m");
}

BOOST_AUTO_TEST_CASE(names_a_length_that_is_none) {
  constexpr double infinite = infinity;
  const auto refuses = [](const Eigen::Vector3d& lengths, const char* words) {
    CHECK_REFUSED(validate(Space{.lengths = lengths}), words);
  };
  refuses({0.0, infinite, infinite}, "space: its length in direction x must be positive, got 0 m; leave it out");
  refuses({infinite, -2.0, infinite}, "space: its length in direction y must be positive, got -2 m");
  refuses({1.0, infinite, not_a_number}, "space: its length in direction z must be positive, got nan m");
}

BOOST_AUTO_TEST_CASE(refuses_a_wall_across_a_period) {
  const Wall floor{}, tilted{.normal = {0.6, 0.0, 0.8}};
  BOOST_CHECK_NO_THROW(validate(Space{.walls = {floor, floor}, .lengths = {1.0, 2.0, infinity}}));
  BOOST_CHECK_NO_THROW(validate(Space{.walls = {tilted}, .lengths = {infinity, 2.0, infinity}}));
  CHECK_REFUSED(validate(Space{.walls = {floor, tilted}, .lengths = {1.0, 2.0, infinity}}),
                "wall 1: its normal must have no component in direction x, in which space repeats itself after 1 m, "
                "got (0.6, 0, 0.8); turn the wall, or leave that length out");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::domain_test
