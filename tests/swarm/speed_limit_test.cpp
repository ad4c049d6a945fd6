#include <particulate/swarm/speed_limit.hpp>

#include <utility>

#include "close.hpp"
#include "contact/moment.hpp"

namespace tests::speed_limit_test {

using namespace particulate::kinematics;
using namespace particulate::swarm;
using particulate::schemes::Jump;

// At 5, 3 and 13 m/s, the last one immovable.
Moment three_members() {
  return {particles(
      {{.position = {0.0, 0.0, 0.0}, .velocity = {3.0, 0.0, -4.0}, .mass = 2.0, .radius = 0.0},
       {.position = {1.0, 0.0, 0.0}, .velocity = {0.0, 3.0, 0.0}, .mass = 1.0, .radius = 0.0},
       {.position = {2.0, 0.0, 0.0}, .velocity = {5.0, 12.0, 0.0}, .mass = 1.0, .radius = 0.0, .immovable = true}})};
}

std::pair<Jump, Vectors> limited(double v_max, const Moment& moment) {
  Eigen::VectorXd v = moment.particles.velocity.reshaped();
  const Jump done = jump(SpeedLimit{.v_max = v_max}, Space{}, moment.at(), 0.0, v);
  return {done, v.reshaped(moment.particles.size(), 3)};
}

BOOST_AUTO_TEST_SUITE(speed_limit_jump)

// 5 m/s to 3, of 2 kg: 25 - 9 = 16 J less. What moves at the limit keeps its bits, and so does what is immovable.
BOOST_AUTO_TEST_CASE(shortens_what_is_too_fast_and_books_what_that_takes) {
  const auto [done, v] = limited(3.0, three_members());
  BOOST_TEST(close(v.row(0), Eigen::RowVector3d(1.8, 0.0, -2.4), {.relative = 4 * eps}));
  BOOST_TEST(close(v.bottomRows(2), three_members().particles.velocity.bottomRows(2), {}));
  BOOST_TEST(done.impacts == 1);
  BOOST_TEST(done.energy_change == -16.0, tolerance(8 * eps));
  BOOST_TEST(done.unsettled.empty());
}

// What was shortened once is not again, whatever its roundings, for a thousand directions.
BOOST_AUTO_TEST_CASE(done_twice_changes_nothing_the_second_time) {
  Moment moment = three_members();
  for (int k = 0; k < 1000; ++k) {
    moment.particles.velocity.row(0) = Eigen::RowVector3d(1.0 + k, 700.0 - k, 0.01 * k * k);
    const auto [first, v] = limited(0.7, moment);
    moment.particles.velocity = v;
    const auto [second, w] = limited(0.7, moment);
    BOOST_REQUIRE(first.impacts >= 1);
    BOOST_REQUIRE(second.impacts == 0);
    BOOST_REQUIRE(w == v);
  }
}

BOOST_AUTO_TEST_CASE(of_zero_stops_everything_that_moves_and_of_infinity_nothing) {
  const auto [stopped, still] = limited(0.0, three_members());
  BOOST_TEST(still.topRows(2).isZero(0.0));
  BOOST_TEST(stopped.energy_change == -29.5, tolerance(8 * eps));
  const auto [again, rest] = limited(0.0, {particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}})});
  BOOST_TEST(again.impacts == 0);
  BOOST_TEST(rest.isZero(0.0));
  const auto [none, free] = limited(infinity, three_members());
  BOOST_TEST(none.impacts == 0);
  BOOST_TEST(none.energy_change == 0.0);
  BOOST_TEST((free == three_members().particles.velocity));
}

BOOST_AUTO_TEST_CASE(of_1e_minus_12_and_of_a_speed_of_1e200_keeps_the_direction) {
  Moment fast = three_members();
  fast.particles.velocity.row(0) *= 1e200;
  for (const Moment& moment : {three_members(), fast}) {
    const Vectors v = limited(1e-12, moment).second;
    BOOST_TEST(close(v.row(0), 1e-12 * Eigen::RowVector3d(0.6, 0.0, -0.8), {.relative = 8 * eps}));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(speed_limit_validate)

BOOST_AUTO_TEST_CASE(names_what_must_hold_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(SpeedLimit{}));
  BOOST_CHECK_NO_THROW(validate(SpeedLimit{.v_max = 0.0}));
  CHECK_REFUSED(validate(SpeedLimit{.v_max = -1.0}), "speed limit: v_max must not be negative, got -1 m/s; leave");
  CHECK_REFUSED(validate(SpeedLimit{.v_max = not_a_number}), "got nan m/s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::speed_limit_test
