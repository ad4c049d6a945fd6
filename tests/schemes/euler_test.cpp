#include <particulate/schemes/euler.hpp>

#include <particulate/schemes/scheme.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::euler_test {

using namespace particulate::schemes;

// No value before t = 0.
struct Damped {
  bool acceleration(double t, In r, In v, Out a) const {
    a = -2.0 * r - v;
    return t >= 0.0;
  }
};
struct Decay {
  bool rate(double t, In y, Out dy) const {
    dy = -3.0 * y;
    return t >= 0.0;
  }
};

static_assert(Advances<ForwardEuler, Damped> && Advances<ForwardEuler, Decay>);

BOOST_AUTO_TEST_SUITE(ForwardEuler_)

// a = -2 - 4 = -6 at (1, 4): r = 1 + 4/4, v = 4 - 6/4.
BOOST_AUTO_TEST_CASE(moves_on_with_the_rates_of_the_start) {
  const State to = predicted(ForwardEuler(), Damped{}, body(1.0, 4.0, 1.0), 0.25);
  BOOST_TEST(to.t == 1.25);
  BOOST_TEST(to.r[0] == 2.0);
  BOOST_TEST(to.v[0] == 2.5);
}

BOOST_AUTO_TEST_CASE(multiplies_a_decaying_value_by_one_minus_its_rate) {
  const State to = predicted(ForwardEuler(), Decay{}, one(8.0), 0.25);
  BOOST_TEST(to.y[0] == 2.0);
  BOOST_TEST(to.t == 0.25);
}

// 1 - c Dt: at c Dt = 2 it turns for ever.
BOOST_AUTO_TEST_CASE(spans_twice_the_time_of_what_decays_and_relaxes_and_minds_no_load) {
  using Kind = TimeScale::Kind;
  BOOST_TEST(std::abs(predicted(ForwardEuler(), Decay{}, one(1.0), 2.0 / 3.0).y[0] + 1.0) < 1e-15);
  BOOST_TEST((ForwardEuler::spans(Kind::decays, 0) == 2.0 && ForwardEuler::spans(Kind::relaxes, 0) == 2.0));
  BOOST_TEST(ForwardEuler::spans(Kind::loads, 0) == infinity);
}

BOOST_AUTO_TEST_CASE(says_that_there_is_no_value) {
  const Decay decay;
  const Damped damped;
  ForwardEuler scheme;
  State values, motion;
  BOOST_TEST(!scheme.predict(decay, one(1.0, -1.0), 0.25, values));
  BOOST_TEST(!scheme.predict(damped, body(1.0, 1.0, -1.0), 0.25, motion));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::euler_test
