#include <particulate/schemes/state.hpp>

#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "close.hpp"
#include "problems.hpp"
#include "says.hpp"

namespace tests::state_test {

using namespace particulate::schemes;

// Every number is another one.
State numbered() {
  return {.t = 0.5,
          .r = Eigen::Vector2d(1.0, 2.0),
          .v = Eigen::Vector2d(3.0, 4.0),
          .y = Eigen::Vector3d(5.0, 6.0, 7.0),
          .t_carry = 0.25};
}

BOOST_AUTO_TEST_SUITE(flat_)

BOOST_AUTO_TEST_CASE(puts_places_before_velocities_before_values) {
  BOOST_TEST(close(flat(numbered()), Eigen::VectorXd::LinSpaced(7, 1.0, 7.0), {}));
}

BOOST_AUTO_TEST_CASE(leaves_out_what_is_not_there) {
  BOOST_TEST(close(flat({.y = Eigen::Vector2d(8.0, 9.0)}), Eigen::Vector2d(8.0, 9.0), {}));
  BOOST_TEST(close(flat(displaced()), Eigen::Vector2d(1.0, 0.0), {}));
  BOOST_TEST(flat(State{}).size() == 0);
}

BOOST_AUTO_TEST_SUITE_END()

// Two particles: r_0 = (1, 3, 5), r_1 = (2, 4, 6), velocities ten times that.
State two_particles() {
  State state;
  state.r = Eigen::VectorXd::LinSpaced(6, 1.0, 6.0);
  state.v = 10.0 * state.r;
  return state;
}

BOOST_AUTO_TEST_SUITE(views)

BOOST_AUTO_TEST_CASE(read_a_row_a_particle) {
  const State state = two_particles();
  BOOST_TEST((positions(state).row(1) == Eigen::RowVector3d(2.0, 4.0, 6.0)));
  BOOST_TEST((velocities(state).row(0) == Eigen::RowVector3d(10.0, 30.0, 50.0)));
  BOOST_TEST((position(state, 0) == Eigen::Vector3d(1.0, 3.0, 5.0)));
  BOOST_TEST((velocity(state, 1) == Eigen::Vector3d(20.0, 40.0, 60.0)));
  BOOST_TEST(positions(state).data() == state.r.data());  // no copy
  const State without{.y = Eigen::Vector2d::Ones()};
  BOOST_TEST(positions(without).rows() == 0);
}

BOOST_AUTO_TEST_CASE(write_where_the_numbers_stand) {
  State state = two_particles();
  const Eigen::Vector3d before = position(state, 1);
  set_position(state, 1, {7.0, 8.0, 9.0});
  set_velocity(state, 0, -velocity(state, 0));
  positions(state).col(0).array() += 100.0;
  velocities(state).row(1).setZero();
  BOOST_TEST((before == Eigen::Vector3d(2.0, 4.0, 6.0)));  // a copy
  BOOST_TEST(close(state.r, (Eigen::VectorXd(6) << 101.0, 107.0, 3.0, 8.0, 5.0, 9.0).finished(), {}));
  BOOST_TEST(close(state.v, (Eigen::VectorXd(6) << -10.0, 0.0, -30.0, 0.0, -50.0, 0.0).finished(), {}));
}

// An assignment to what is read would change a copy, a view of a temporary would read what is gone: neither compiles.
template <class S>
concept HasView = requires(S&& state) {
  positions(std::forward<S>(state));
};
static_assert(HasView<State&> && HasView<const State&> && !HasView<State> && !HasView<const State>);
static_assert(!std::is_assignable_v<decltype(position(std::declval<State&>(), 0)), Eigen::Vector3d>);

BOOST_AUTO_TEST_CASE(refuse_what_is_no_array_of_particles_and_particles_that_are_not_there) {
  State state = two_particles();
  for (const Eigen::Index i : {-1, 2}) {
    const std::string words = fmt::format("asked for with 0 <= i < 2, got i = {}", i);
    CHECK_REFUSED(position(state, i), words);
    CHECK_REFUSED(velocity(state, i), words);
    CHECK_REFUSED(set_position(state, i, Eigen::Vector3d::Zero()), words);
    CHECK_REFUSED(set_velocity(state, i, Eigen::Vector3d::Zero()), words);
  }
  state.v.resize(0);
  CHECK_REFUSED(velocity(state, 0), "0 <= i < 0");
  state.r.resize(7);
  CHECK_REFUSED(positions(state), "r must hold three numbers a particle, all x, all y, all z, got 7");
  CHECK_REFUSED(position(state, 0), "got 7");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(unflatten_)

BOOST_AUTO_TEST_CASE(undoes_flat_and_leaves_the_time_alone) {
  State state = numbered();
  unflatten(-flat(numbered()), state);
  BOOST_TEST(close(state.r, Eigen::Vector2d(-1.0, -2.0), {}));
  BOOST_TEST(close(state.v, Eigen::Vector2d(-3.0, -4.0), {}));
  BOOST_TEST(close(state.y, Eigen::Vector3d(-5.0, -6.0, -7.0), {}));
  BOOST_TEST(state.t == 0.5);
  BOOST_TEST(state.t_carry == 0.25);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(swap_)

BOOST_AUTO_TEST_CASE(exchanges_every_part_without_copying_a_number) {
  State one = numbered(), other{.t = -1.0, .y = Eigen::VectorXd::Constant(1, 9.0)};
  const double* const places = one.r.data();
  swap(one, other);
  BOOST_TEST(one.t == -1.0);
  BOOST_TEST(one.t_carry == 0.0);
  BOOST_TEST(close(flat(one), Eigen::VectorXd::Constant(1, 9.0), {}));
  BOOST_TEST(one.r.size() == 0);
  BOOST_TEST(other.t == 0.5);
  BOOST_TEST(other.t_carry == 0.25);
  BOOST_TEST(close(flat(other), flat(numbered()), {}));
  BOOST_TEST(other.r.data() == places);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(is_finite_)

BOOST_AUTO_TEST_CASE(looks_at_every_number) {
  const Eigen::Vector2d good(1.0, -1e308);
  BOOST_TEST(is_finite({.t = 0.0, .r = good, .v = good, .y = good}));
  BOOST_TEST(is_finite(State{}));
  for (const double bad : {not_a_number, infinity, -infinity}) {
    const Eigen::Vector2d worse(0.0, bad);
    BOOST_TEST(!is_finite({.t = 0.0, .r = worse, .v = good, .y = good}));
    BOOST_TEST(!is_finite({.t = 0.0, .r = good, .v = worse, .y = good}));
    BOOST_TEST(!is_finite({.t = 0.0, .r = good, .v = good, .y = worse}));
    BOOST_TEST(!is_finite({.t = bad, .r = good, .v = good, .y = good}));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(advance_time_)

// t = 0.5 with 0.25 carried, and a step of 0.125.
BOOST_AUTO_TEST_CASE(adds_the_step_and_what_was_carried_and_leaves_the_rest) {
  State to{.t = 9.0, .y = Eigen::VectorXd::Ones(1)};
  advance_time(numbered(), 0.125, to);
  BOOST_TEST(to.t == 0.875);
  BOOST_TEST(to.t_carry == 0.0);
  BOOST_TEST(to.y[0] == 1.0);
}

// The time of 1.7e9 s has a rounding of 2.4e-7 s: a plain sum of steps of 1e-7 s would stand still.
BOOST_AUTO_TEST_CASE(carries_on_what_rounding_takes) {
  State at{.t = 1.7e9};
  for (int n = 0; n < 100000; ++n) {
    const State from = at;
    advance_time(from, 1e-7, at);
  }
  BOOST_TEST((at.t - 1.7e9) + at.t_carry == 0.01, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::state_test
