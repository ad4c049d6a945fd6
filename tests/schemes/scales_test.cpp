#include <particulate/schemes/scales.hpp>

#include <limits>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "../numbers.hpp"
#include "../says.hpp"

namespace tests::scales_test {

using namespace particulate::schemes;
using Eigen::Vector2d, Eigen::Vector3d;

// Two places on a line, which know what they share.
struct Pair {
  bool acceleration(double, In, Out) const { return true; }
  double spacing(In r) const { return std::abs(r[1] - r[0]); }
  void common_motion(In v, Out shared) const { shared.setConstant(0.5 * (v[0] + v[1])); }
};
struct Blind {
  bool acceleration(double, In, Out) const { return true; }
};
struct TwoKinds {
  bool rate(double, In, Out) const { return true; }
  std::vector<Range> ranges() const {
    return {{.name = "K", .first = 0, .size = 2}, {.name = "mol", .first = 2, .size = 1}};
  }
};

template <class P>
ErrorScales seen(const P& problem, const State& from, double dt, const State& to, const Sizes& given = {}) {
  ErrorScales scales(given);
  scales.look(problem, from, dt, to);
  return scales;
}

BOOST_AUTO_TEST_SUITE(ErrorScales_)

// From 4 apart to 8 apart, at 3 and -1 m/s about a common 1e4, then 2 and 0: spacing 8, speed 2.
BOOST_AUTO_TEST_CASE(sees_bodies_from_inside) {
  const State from{.r = Vector2d(1e6, 1e6 + 4.0), .v = Vector2d(1e4 + 2.0, 1e4 - 2.0)};
  const State to{.r = Vector2d(2e6, 2e6 + 8.0), .v = Vector2d(1e4 + 1.0, 1e4 - 1.0)};
  const ErrorScales scales = seen(Pair{}, from, 1.0, to);
  BOOST_TEST(scales.of_places(Vector2d(-4.0, 1.0)) == 0.5);
  BOOST_TEST(scales.of_speeds(Vector2d(0.5, -1.0)) == 0.5);
  BOOST_TEST(scales.relative({.r = Vector2d(4.0, 0.0), .v = Vector2d(3.0, 0.0)}) == 1.5);
}

BOOST_AUTO_TEST_CASE(counts_from_zero_where_nothing_is_known) {
  const State from{.r = Vector2d(-5.0, 1.0), .v = Vector2d(0.0, 3.0)},
      to{.r = Vector2d(2.0, 4.0), .v = Vector2d(-6.0, 0.0)};
  const ErrorScales scales = seen(Blind{}, from, 1.0, to);
  BOOST_TEST(scales.of_places(Vector2d(0.0, 5.0)) == 1.0);
  BOOST_TEST(scales.of_speeds(Vector2d(3.0, 0.0)) == 0.5);
}

BOOST_AUTO_TEST_CASE(takes_no_noise_at_rest_for_motion) {
  const State rest{.r = Vector2d(0.0, 2.0), .v = Vector2d(0.0, 1e-16)};
  BOOST_TEST(seen(Pair{}, rest, 0.5, rest).speed() == 1e-8 * 2.0 / 0.5);
}

BOOST_AUTO_TEST_CASE(measures_each_kind_of_values_by_its_largest) {
  const State from{.y = Vector3d(1.0, -300.0, 0.0)}, to{.y = Vector3d(2.0, 200.0, 1e-9)};
  const ErrorScales scales = seen(TwoKinds{}, from, 1.0, to);
  BOOST_TEST(scales.of_values(Vector3d(3.0, 0.0, 0.0)) == 0.01);
  BOOST_TEST(scales.of_values(Vector3d(3.0, 0.0, 1e-9)) == 1.0);
  const State nothing{.y = Vector3d::Zero()};
  BOOST_TEST(seen(TwoKinds{}, nothing, 1.0, nothing).of_values(Vector3d::Zero()) == 0.0);
}

BOOST_AUTO_TEST_CASE(follows_what_is_given) {
  const State at{.r = Vector2d(-5.0, 1.0), .v = Vector2d(0.0, 3.0)};
  const ErrorScales both = seen(Pair{}, at, 1.0, at, {.size = 2.0, .speed = 10.0});
  BOOST_TEST(both.of_places(Vector2d(5.0, 0.0)) == 1.0);
  BOOST_TEST(both.of_speeds(Vector2d(5.0, 0.0)) == 0.5);
  const ErrorScales each = seen(Pair{}, at, 1.0, at, {.each = Vector2d(1.0, 4.0)});
  BOOST_TEST(each.of_places(Vector2d(1.0, 2.0)) == 0.5);
  BOOST_TEST((each.unknowns() - Vector2d(1.0, 4.0)).norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(says_that_an_error_is_unknown) {
  const State at{.r = Vector2d(0.0, 1.0), .v = Vector2d(0.0, 3.0)};
  const ErrorScales scales = seen(Pair{}, at, 1.0, at);
  BOOST_TEST(std::isnan(scales.relative({.r = Vector2d(not_a_number, 0.0), .v = Vector2d(1.0, 0.0)})));
  BOOST_TEST(std::isnan(scales.relative({.r = Vector2d(1.0, 0.0), .v = Vector2d(0.0, not_a_number)})));
}

BOOST_AUTO_TEST_CASE(refuses_sizes_that_cannot_be_meant) {
  CHECK_REFUSED(validate("x", Sizes{.size = 0.0}), "x: size must be positive and finite, got 0");
  CHECK_REFUSED(validate("x", Sizes{.speed = -1.0}), "x: speed must be positive and finite, got -1");
  const State at{.r = Vector2d(0.0, 1.0), .v = Vector2d(0.0, 3.0)};
  CHECK_REFUSED(seen(Pair{}, at, 1.0, at, {.each = Vector3d::Ones()}),
                "sizes must be one for each of 2 unknowns, got 3");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::scales_test
