#include <particulate/schemes/crossing.hpp>

#include <cmath>
#include <functional>
#include <numbers>

#include "close.hpp"

namespace tests::crossing_test {

using namespace particulate::schemes;

using Function = std::function<double(double)>;

struct Found {
  std::optional<Crossing> crossing;
  int side;
  int asked = 0;  // how often the function was asked between its samples
};

// Looks at a function between equal parts of [0, 1].
Found find(const Function& f, const Function& slope, const ZeroRules& rules, int side, int parts) {
  Found found{.crossing = {}, .side = side};
  std::vector<Sample> samples;
  for (int k = 0; k <= parts; ++k) {
    const double theta = static_cast<double>(k) / parts;
    samples.push_back({.theta = theta, .value = f(theta), .slope = slope(theta)});
  }
  const Along along{.value =
                        [&](double theta) {
                          ++found.asked;
                          return f(theta);
                        },
                    .slope =
                        [&](double theta) {
                          ++found.asked;
                          return slope(theta);
                        }};
  found.crossing = first_crossing(samples, along, rules, found.side);
  return found;
}

// (x - a)(x - b), its slope, and where it turns.
struct Parabola {
  double a, b, offset = 0.0;
  Function value() const {
    return [*this](double x) { return (x - a) * (x - b) + offset; };
  }
  Function slope() const {
    return [*this](double x) { return 2.0 * x - a - b; };
  }
};

Found find(const Parabola& parabola, const ZeroRules& rules, int side, int parts) {
  return find(parabola.value(), parabola.slope(), rules, side, parts);
}

BOOST_AUTO_TEST_SUITE(chebyshev_points_)

BOOST_AUTO_TEST_CASE(start_at_zero_end_at_the_end_and_lie_densest_there) {
  const std::vector<double> four = chebyshev_points(4, 2.0);
  BOOST_REQUIRE(four.size() == 5U);
  BOOST_TEST(four[0] == 0.0);
  BOOST_TEST(four[1] == 1.0 - std::numbers::sqrt2 / 2.0, tolerance(1e-15));
  BOOST_TEST(four[2] == 1.0, tolerance(1e-15));
  BOOST_TEST(four[4] == 2.0);
  const std::vector<double> one = chebyshev_points(1, 1.1);
  BOOST_REQUIRE(one.size() == 2U);
  BOOST_TEST(one[1] == 1.1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bracketed_root_)

BOOST_AUTO_TEST_CASE(is_the_root_to_two_roundings_and_never_short_of_it) {
  for (const double root : {1e-9, 0.1, 1.0 / 3.0, 0.5, 0.9, 1.0 - 1e-12}) {
    const Function f = [&](double x) { return std::expm1(x - root); };
    for (const double sign : {1.0, -1.0}) {
      const double found =
          bracketed_root([&](double x) { return sign * f(x); }, 0.0, sign * f(0.0), 1.0, sign * f(1.0));
      BOOST_TEST(found >= root);
      BOOST_TEST(found <= root + 5e-16);
    }
  }
}

// x^21 - 1/2 is flat where regula falsi starts: it alone would take thousands of steps.
BOOST_AUTO_TEST_CASE(asks_seldom_and_never_more_than_one_above_bisection) {
  int asked = 0;
  const Function flat = [&](double x) {
    ++asked;
    return std::pow(x, 21) - 1e-12;
  };
  BOOST_TEST(bracketed_root(flat, 0.0, -1e-12, 1.0, 1.0) == std::pow(1e-12, 1.0 / 21.0), tolerance(1e-15));
  BOOST_TEST(asked <= 53);
  asked = 0;
  const Function smooth = [&](double x) {
    ++asked;
    return std::sin(3.0 * x) - 0.5;
  };
  BOOST_TEST(bracketed_root(smooth, 0.0, -0.5, 0.5, std::sin(1.5) - 0.5) == std::numbers::pi / 18.0, tolerance(4e-15));
  BOOST_TEST(asked <= 14);
}

BOOST_AUTO_TEST_CASE(is_the_place_of_a_jump_and_an_exact_zero) {
  const Function step = [](double x) { return x < 0.3 ? -1.0 : 1.0; };
  BOOST_TEST(bracketed_root(step, 0.0, -1.0, 1.0, 1.0) == 0.3, tolerance(2e-15));
  const Function line = [](double x) { return x - 0.5; };
  BOOST_TEST(bracketed_root(line, 0.0, -0.5, 1.0, 0.5) == 0.5);
  BOOST_TEST(bracketed_root(line, 0.0, -0.5, 0.5, 0.0) <= 0.5);
  BOOST_TEST(bracketed_root(line, 0.0, -0.5, 0.5, 0.0) == 0.5, tolerance(1e-15));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(first_crossing_)

BOOST_AUTO_TEST_CASE(tells_which_way_a_function_passes_zero) {
  const Function wave = [](double x) { return std::cos(9.0 * x); },
                 slope = [](double x) { return -9.0 * std::sin(9.0 * x); };
  const double quarter = std::numbers::pi / 18.0;
  const auto crossing = [&](Direction direction) { return find(wave, slope, {.direction = direction}, 1, 8).crossing; };
  BOOST_TEST(crossing(Direction::either)->theta == quarter, tolerance(1e-14));
  BOOST_TEST((crossing(Direction::either)->way == Direction::falling));
  BOOST_TEST(crossing(Direction::falling)->theta == quarter, tolerance(1e-14));
  BOOST_TEST(crossing(Direction::falling)->counts);
}

// What passes the other way first is given, and does not count: dense output may see two passages where there is none.
BOOST_AUTO_TEST_CASE(gives_a_passage_the_other_way_where_one_that_counts_comes_after_it) {
  const Parabola dip{.a = 0.3, .b = 0.7};
  const Found up = find(dip, {.direction = Direction::rising}, 1, 8);
  BOOST_TEST(up.crossing.value().theta == 0.3, tolerance(1e-13));
  BOOST_TEST((up.crossing->way == Direction::falling));
  BOOST_TEST(!up.crossing->counts);
  BOOST_TEST(!find(Parabola{.a = 0.3, .b = 1.7}, {.direction = Direction::rising}, 1, 8).crossing.has_value());
}

BOOST_AUTO_TEST_CASE(finds_nothing_where_there_is_nothing) {
  const Found found = find(Parabola{.a = 1.5, .b = 2.0}, {}, 1, 4);
  BOOST_TEST(!found.crossing.has_value());
  BOOST_TEST(found.side == 1);
  BOOST_TEST(found.asked == 0);
}

// A single interval shows two positive ends; the slopes show the dip.
BOOST_AUTO_TEST_CASE(sees_two_roots_between_two_samples) {
  const Parabola dip{.a = 0.45, .b = 0.46};
  const Found down = find(dip, {.direction = Direction::falling}, 1, 1);
  BOOST_TEST(down.crossing.value().theta == 0.45, tolerance(1e-13));
  const Found up = find(dip, {.direction = Direction::rising}, 1, 1);
  BOOST_TEST(up.crossing.value().theta == 0.45, tolerance(1e-13));
  BOOST_TEST(!up.crossing->counts);
}

BOOST_AUTO_TEST_CASE(takes_a_double_root_for_one_touch_of_the_direction_it_came_from) {
  for (const double miss : {0.0, 1e-13, -1e-13}) {
    const Parabola graze{.a = 0.4, .b = 0.4, .offset = miss};
    for (const Direction direction : {Direction::either, Direction::falling}) {
      const Found found = find(graze, {.direction = direction, .graze = 1e-12, .touches = true}, 1, 4);
      BOOST_TEST(found.crossing.value().theta == 0.4, tolerance(1e-14));
      BOOST_TEST((found.crossing->way == Direction::either));
    }
    BOOST_TEST(
        !find(graze, {.direction = Direction::rising, .graze = 1e-12, .touches = true}, 1, 4).crossing.has_value());
    const auto mirrored = [&](const Function& f) { return [f](double x) { return -f(x); }; };
    BOOST_TEST((find(mirrored(graze.value()), mirrored(graze.slope()),
                     {.direction = Direction::rising, .graze = 1e-12, .touches = true}, -1, 4)
                    .crossing.value()
                    .way == Direction::either));
  }
  BOOST_TEST(!find(Parabola{.a = 0.4, .b = 0.4, .offset = 1e-11}, {.graze = 1e-12, .touches = true}, 1, 4)
                  .crossing.has_value());
  const Found two = find(Parabola{.a = 0.4, .b = 0.4, .offset = -1e-10}, {.graze = 1e-12, .touches = true}, 1, 4);
  BOOST_TEST(two.crossing.value().theta == 0.4 - 1e-5, tolerance(1e-9));
  BOOST_TEST((two.crossing->way == Direction::falling));
}

BOOST_AUTO_TEST_CASE(takes_no_touch_for_one_where_none_counts) {
  for (const double miss : {0.0, 1e-13, -1e-13}) {
    const Found found = find(Parabola{.a = 0.4, .b = 0.4, .offset = miss}, {.graze = 1e-12}, 1, 4);
    BOOST_TEST(!found.crossing.has_value());
    BOOST_TEST(found.side == 1);
  }
}

// 0.01 in the middle of the step, 4 0.4 0.6 0.01 = 0.0096 at 0.4.
BOOST_AUTO_TEST_CASE(gives_the_place_of_an_extreme_value_that_is_in_doubt) {
  for (const Direction direction : {Direction::falling, Direction::rising}) {
    const ZeroRules rules{.direction = direction, .doubt = 0.01};
    for (const double offset : {0.0095, 1e-9}) {
      const Found found = find(Parabola{.a = 0.4, .b = 0.4, .offset = offset}, rules, 1, 4);
      BOOST_TEST(found.crossing.value().theta == 0.4, tolerance(1e-14));
      BOOST_TEST((found.crossing->way == Direction::either));
    }
    BOOST_TEST(!find(Parabola{.a = 0.4, .b = 0.4, .offset = 0.0097}, rules, 1, 4).crossing.has_value());
  }
}

BOOST_AUTO_TEST_CASE(passes_nothing_by_leaving_zero) {
  const Parabola up{.a = 0.0, .b = -1.0}, down{.a = 0.0, .b = 2.0};
  const Found risen = find(up, {.leave = 1e-3}, 0, 4);
  BOOST_TEST(!risen.crossing.has_value());
  BOOST_TEST(risen.side == 1);
  const Found fallen = find(down, {.leave = 1e-3}, 0, 4);
  BOOST_TEST(!fallen.crossing.has_value());
  BOOST_TEST(fallen.side == -1);
  BOOST_TEST(find(up, {.leave = 3.0}, 0, 4).side == 0);
}

// x (0.3 - x): up from zero and back to it, within one interval.
BOOST_AUTO_TEST_CASE(sees_a_function_leave_zero_and_return_between_two_samples) {
  const Function hop = [](double x) { return x * (0.3 - x); }, slope = [](double x) { return 0.3 - 2.0 * x; };
  const Found found = find(hop, slope, {.direction = Direction::falling, .leave = 1e-3}, 0, 1);
  BOOST_TEST(found.crossing.value().theta == 0.3, tolerance(1e-14));
  // The top of the hop is 0.0225.
  BOOST_TEST(!find(hop, slope, {.direction = Direction::falling, .leave = 0.03}, 0, 1).crossing.has_value());
}

BOOST_AUTO_TEST_CASE(lets_what_has_not_left_zero_pass_its_floor) {
  const Function hop = [](double x) { return x * (0.3 - x); }, slope = [](double x) { return 0.3 - 2.0 * x; };
  const ZeroRules rules{.direction = Direction::falling, .leave = 0.03, .floor = -0.04};
  for (const int parts : {1, 2, 16}) {
    const Found found = find(hop, slope, rules, 0, parts);
    BOOST_TEST(found.crossing.value().theta == 0.4, tolerance(1e-14));  // 0.4 (0.3 - 0.4) = -0.04
    BOOST_TEST((found.crossing->way == Direction::falling));
  }
}

BOOST_AUTO_TEST_CASE(reaches_zero_where_a_sample_does) {
  const Function line = [](double x) { return 1.0 - x; }, slope = [](double) { return -1.0; };
  BOOST_TEST(find(line, slope, {}, 1, 3).crossing.value().theta == 1.0);
  const Function above = [](double x) { return 1.0 + 1e-15 - x; };
  BOOST_TEST(!find(above, slope, {}, 1, 3).crossing.has_value());
  BOOST_TEST(find(above, slope, {.reach = 1e-14}, 1, 3).crossing.value().theta == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::crossing_test
