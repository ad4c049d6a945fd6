#include <harness/competitors.hpp>

#include <cmath>
#include <stdexcept>

#include <particulate/schemes/runge_kutta.hpp>

#include "says.hpp"

namespace tests::competitors_test {

using namespace verification;
using schemes::State;

long asked = 0;

struct Decay {
  double lambda = 1.0;
  bool rate(double, schemes::In y, schemes::Out dy) const {
    ++asked;
    dy = -lambda * y;
    return true;
  }
};

// Twice as fast each time it is asked.
struct Fading {
  double lambda;
  bool rate(double, schemes::In y, schemes::Out dy) {
    dy = -lambda * y;
    lambda *= 2.0;
    return true;
  }
};

Race decay_race() {
  const auto exact = [](double t) { return State{.t = t, .y = Eigen::Vector2d{std::exp(-t), 8.0 * std::exp(-t)}}; };
  return {.problem = Decay{}, .start = exact(0.0), .outputs = {0.5, 1.0}, .truth = exact};
}

BOOST_AUTO_TEST_SUITE(competitors)

BOOST_AUTO_TEST_CASE(errors_of_motions_are_in_units_of_the_race_and_those_of_values_relative_to_each) {
  // Places 0 and 4 of size 2, missed by 1: 1/2 where the truth is below the size, 1/4 where it is above.
  Race race = decay_race();
  race.length = 2.0, race.speed = 5.0;
  State exact{
      .t = 1.0, .r = Eigen::Vector2d{0.0, 4.0}, .v = Eigen::Vector2d{1.0, 1.0}, .y = Eigen::Vector2d{1e-6, 8.0}};
  race.truth = [&](double) { return exact; };
  State handed = exact;
  handed.r[1] = 5.0;
  BOOST_TEST(errors_of(race, {handed}).end == 0.25);
  handed.r[0] = 1.0;
  BOOST_TEST(errors_of(race, {handed}).end == 0.5);
  handed.v[0] = 6.0;  // 5 of 5
  BOOST_TEST(errors_of(race, {handed}).end == 1.0);
  handed.y[0] = 4e-6;  // 3 times itself
  BOOST_TEST(errors_of(race, {handed}).end == 3.0, boost::test_tools::tolerance(1e-15));
  const Errors both = errors_of(race, {handed, exact});
  BOOST_TEST(both.end == 0.0);
  BOOST_TEST(both.max == 3.0, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_run_and_its_replay_do_the_same_and_only_the_run_asks) {
  const Competitor who = competitor("RK4", decay_race(), {0.125}, at_fixed_step<schemes::RungeKutta4>());
  const Prepared prepared = who.prepare(0.125);
  BOOST_TEST(prepared.task.start == (std::vector{1.0, 8.0}), boost::test_tools::per_element());
  BOOST_TEST(prepared.task.rate == (std::vector{-1.0, -8.0}), boost::test_tools::per_element());
  asked = 0;
  const Counts run = prepared.run();
  BOOST_TEST(run.evaluations == 32);  // eight steps of four
  BOOST_TEST(asked == 32);
  // A step of RK4 multiplies by 1 - h + h^2/2 - h^3/6 + h^4/24 where e^-h is right; both values likewise.
  constexpr double h = 0.125, step = 1.0 - h + h * h / 2.0 - h * h * h / 6.0 + h * h * h * h / 24.0;
  const double end = std::pow(step * std::exp(h), 8) - 1.0;
  BOOST_TEST(prepared.errors().end == end, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((prepared.replay() == run));
  BOOST_TEST((prepared.replay() == run));
  BOOST_TEST(asked == 32);
  BOOST_TEST(prepared.errors().end == end, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_race_holds_a_problem_of_its_own_and_so_does_its_copy) {
  Decay decay{.lambda = 3.0};
  const HeldProblem held(decay);
  decay.lambda = 7.0;
  const HeldProblem copy = held;
  HeldProblem other(Fading{.lambda = 1.0});
  const auto rate_of = [](const HeldProblem& problem) {
    schemes::Rates rates;
    BOOST_TEST(problem.seen().rates({.y = Eigen::VectorXd::Ones(1)}, rates));
    return rates.dy[0];
  };
  BOOST_TEST(rate_of(copy) == -3.0);
  // What one is asked does not change the other.
  const HeldProblem before = other;
  BOOST_TEST(rate_of(other) == -1.0);
  BOOST_TEST(rate_of(other) == -2.0);
  BOOST_TEST(rate_of(before) == -1.0);
  other = held;
  BOOST_TEST(rate_of(other) == -3.0);
}

BOOST_AUTO_TEST_CASE(an_integrator_that_does_not_count_every_right_hand_side_is_refused) {
  const Begin forgetful = [](const schemes::Problem& problem, const State&, double) -> Advance {
    return [&problem](State& state, double t_end) {
      schemes::Rates rates;
      problem.rates(state, rates);
      state.t = t_end;
      return schemes::Outcome{.t = t_end};
    };
  };
  const Competitor who = competitor("forgetful", decay_race(), {0.1}, forgetful);
  BOOST_CHECK_EXCEPTION(who.prepare(0.1), std::logic_error, says("it says 0, the problem 2"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::competitors_test
