#include <particulate/schemes/sweeps.hpp>

#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/staggering.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::sweeps_test {

using namespace particulate::schemes;

// No value before t = 0.
struct Decay {
  bool rate(double t, In y, Out dy) const {
    dy = -y;
    return t >= 0.0;
  }
};

const Decay decay;

BOOST_AUTO_TEST_SUITE(sweep_by_hand_)

// y <- 1 - y/2 from y = 1.
BOOST_AUTO_TEST_CASE(keeps_the_guess_and_every_sweep) {
  const Sweeps seen = sweep_by_hand(BackwardEuler(), decay, one(1.0, 1.0), 0.5, 3);
  BOOST_REQUIRE(seen.iterates.size() == 4u);
  const double expected[] = {1.0, 0.5, 0.75, 0.625};
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(seen.iterates[k].y[0] == expected[k]);
    BOOST_TEST(seen.iterates[k].t == 1.5);
  }
  BOOST_REQUIRE(seen.iterations.size() == 3u);
  for (int k = 0; k < 3; ++k) BOOST_TEST(seen.iterations[static_cast<std::size_t>(k)].K == k);
  BOOST_TEST(seen.iterations[2].rate == 0.5);
  BOOST_REQUIRE(seen.parts.size() == 3u);
  BOOST_TEST(seen.parts[2].empty());
}

// Field by field, in the order of the scheme.
BOOST_AUTO_TEST_CASE(keeps_what_every_part_of_the_state_did) {
  const FirstOrderPair pair{.a = Eigen::Matrix2d{{1.0, 2.0}, {4.0, 3.0}}};
  const Staggered scheme({{.name = "one"}, {.name = "two"}});
  const Sweeps seen = sweep_by_hand(scheme, pair, {.y = Eigen::Vector2d(5.0, 2.0)}, 0.25, 2);
  BOOST_REQUIRE(seen.parts.size() == 2u);
  BOOST_REQUIRE(seen.parts[1].size() == 2u);
  BOOST_TEST(seen.parts[1][0].field == "one");
  BOOST_TEST(seen.parts[1][1].field == "two");
  BOOST_TEST(seen.parts[1][1].K == 1);
}

BOOST_AUTO_TEST_CASE(makes_no_sweep_where_none_is_asked_for) {
  const Sweeps seen = sweep_by_hand(BackwardEuler(), decay, one(1.0, 1.0), 0.5, 0);
  BOOST_TEST(seen.iterates.size() == 1u);
  BOOST_TEST(seen.iterations.empty());
}

// A sweep of backward Euler is one right-hand side, its guess none.
BOOST_AUTO_TEST_CASE(asks_for_no_more_than_the_scheme_does) {
  long evaluations = 0;
  sweep_by_hand(BackwardEuler(), Problem(decay, &evaluations), one(1.0, 1.0), 0.5, 3);
  BOOST_TEST(evaluations == 3);
}

BOOST_AUTO_TEST_CASE(refuses_a_guess_without_a_value) {
  CHECK_REFUSED(sweep_by_hand(PhiFamily<>(0.5), decay, one(1.0, -1.0), 0.5, 1),
                "the problem must have a value for the guess of the step, and has none");
}

BOOST_AUTO_TEST_CASE(refuses_a_scheme_that_leaves_something_behind) {
  CHECK_REFUSED(sweep_by_hand(Staggered({{"one", 1e-6, 1}}), decay, one(1.0, 1.0), 0.5, 1),
                "the scheme must be able to advance all that the problem has");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::sweeps_test
