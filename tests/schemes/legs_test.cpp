#include <particulate/schemes/legs.hpp>

#include <cmath>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::legs_test {

using namespace particulate::schemes;

const auto ignore = [](const State&, const auto&, const Outcome&) {};

// What a run needs to go on, at every multiple that it reached.
struct Mark {
  State state;
  double step;
  Outcome so_far;
};
struct Marks {
  std::vector<Mark> seen = {};
  template <class C>
  void operator()(const State& state, const C& control, const Outcome& so_far) {
    seen.push_back({state, control.step, so_far});
  }
};

BOOST_AUTO_TEST_SUITE(multiples_)

BOOST_AUTO_TEST_CASE(are_the_same_bits_from_wherever_they_are_asked_for) {
  for (int k = 1; k < 1000; ++k) {
    const double t = k * 0.1;
    BOOST_TEST(next_multiple(0.1, t) == (k + 1) * 0.1);
    BOOST_TEST(next_multiple(0.1, std::nextafter(t, 0.0)) == t);
    BOOST_TEST(next_multiple(0.1, t - 0.05) == t);
    BOOST_TEST(next_multiple(0.1, -t) == (1 - k) * 0.1);
  }
}

BOOST_AUTO_TEST_CASE(of_an_interval_count_both_ends) {
  BOOST_TEST(multiples(0.25, 0.0, 1.0) == std::vector<double>({0.0, 0.25, 0.5, 0.75, 1.0}),
             boost::test_tools::per_element());
  BOOST_TEST(multiples(0.25, 0.1, 0.6) == std::vector<double>({0.25, 0.5}), boost::test_tools::per_element());
  BOOST_TEST(multiples(0.25, 1.0, 0.5).empty());
}

BOOST_AUTO_TEST_CASE(refuse_a_period_that_cannot_be_meant) {
  for (const double period : {0.0, -1.0, infinity, not_a_number}) {
    CHECK_REFUSED(next_multiple(period, 1.0), "period: must be positive and finite, got");
  }
  CHECK_REFUSED(next_multiple(1e-10, 1e6), "lost in the rounding of the time, got 1e-10 s at t = 1000000 s: choose");
  CHECK_REFUSED(multiples(1.0, 0.0, infinity), "must end at a finite time, got inf s");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(integrate_in_legs_)

// By hand: steps of 0.4 s, cut at 0.5 and 1; what is left, 0.25, is no multiple.
BOOST_AUTO_TEST_CASE(ends_a_leg_at_every_multiple_and_the_run_at_its_end) {
  State state = displaced();
  RungeKutta4 scheme;
  FixedStep control{.step = 0.4};
  std::vector<double> ends;
  const auto save = [&](const State& at, const FixedStep&, const Outcome& so_far) {
    BOOST_TEST(so_far.t == at.t);
    ends.push_back(at.t);
  };
  std::vector<double> steps;
  const auto observe = [&](const State&, const State& to, double, const RungeKutta4&) {
    steps.push_back(to.t);
    return true;
  };
  Spring spring;
  const Outcome outcome = integrate_in_legs(spring, state, 1.25, scheme, control, 0.5, save, observe);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(state.t == 1.25);
  BOOST_TEST(outcome.t == 1.25);
  BOOST_TEST(outcome.steps == 5);
  BOOST_TEST(ends == std::vector<double>({0.5, 1.0}), boost::test_tools::per_element());
  BOOST_TEST(steps == std::vector<double>({0.4, 0.5, 0.9, 1.0, 1.25}), boost::test_tools::per_element());
}

// 3 x 0.1 is above 0.3 by a rounding, and 7 x 0.1 above 0.7: the end is no multiple, and no leg of one rounding
// follows.
BOOST_AUTO_TEST_CASE(makes_no_leg_of_rounding) {
  for (const double t_end : {0.3, 0.7, std::nextafter(0.5, 1.0)}) {
    State state = displaced();
    VelocityVerlet scheme;
    FixedStep control{.step = 0.05};
    Marks marks;
    Spring spring;
    const Outcome outcome = integrate_in_legs(spring, state, t_end, scheme, control, 0.1, marks);
    BOOST_TEST(state.t == t_end);
    BOOST_TEST(outcome.steps == std::lround(t_end / 0.05));
    BOOST_TEST(static_cast<long>(marks.seen.size()) == std::lround(t_end / 0.1) - 1);
  }
}

// From each mark, with a scheme and a control that know nothing.
template <class S, class C>
void goes_on_with_the_same_bits(const S& fresh, const C& control) {
  Damped problem;
  const State start{.t = 0.0, .r = Eigen::Vector2d(1.0, 0.3), .v = Eigen::Vector2d(0.0, -2.0)};
  State whole = start;
  S scheme = fresh;
  C whole_control = control;
  Marks marks;
  const Outcome done = integrate_in_legs(problem, whole, 2.05, scheme, whole_control, 0.3, marks);
  BOOST_TEST_REQUIRE((done.status == Status::reached));
  BOOST_TEST_REQUIRE(marks.seen.size() == 6);
  for (const Mark& mark : marks.seen) {
    State state = mark.state;
    S other = fresh;
    C its = control;
    its.step = mark.step;
    const Outcome all = integrate_in_legs(problem, state, 2.05, other, its, 0.3, ignore, Unobserved{}, mark.so_far);
    BOOST_TEST(flat(state) == flat(whole));
    BOOST_TEST(state.t_carry == whole.t_carry);
    BOOST_TEST(its.step == whole_control.step);
    BOOST_TEST(all.evaluations == done.evaluations);
    BOOST_TEST(all.rejections == done.rejections);
    BOOST_TEST(all.steps == done.steps);
  }
}

BOOST_AUTO_TEST_CASE(goes_on_with_the_same_bits_at_fixed_and_chosen_steps) {
  goes_on_with_the_same_bits(RungeKutta4(), FixedStep{.step = 0.07});
  goes_on_with_the_same_bits(RungeKutta4(), ErrorControl{.TOL = 1e-7});
  goes_on_with_the_same_bits(Collocation<Gauss<4>>(), ErrorControl{.TOL = 1e-8, .sweep_TOL = 1e-10});
}

// What it must not do: the scheme keeps the polynomial of its last step, and the run another end.
struct Remembering : Collocation<Gauss<4>> {
  void forget() {}
};
BOOST_AUTO_TEST_CASE(has_other_bits_where_the_scheme_forgets_nothing) {
  Damped problem;
  State with = body(1.0, 0.0), without = with;
  Remembering remembering;
  Collocation<Gauss<4>> forgetting;
  FixedStep control{.step = 0.1, .TOL = 1e-6};
  (void)integrate_in_legs(problem, with, 0.9, remembering, control, 0.3, ignore);
  (void)integrate_in_legs(problem, without, 0.9, forgetting, control, 0.3, ignore);
  BOOST_TEST(flat(with) != flat(without));
}

// Each leg counts into the whole; the observer stops the third one.
BOOST_AUTO_TEST_CASE(stops_where_the_observer_says_so_and_saves_no_more) {
  State state = displaced();
  VelocityVerlet scheme;
  FixedStep control{.step = 0.25};
  Marks marks;
  Spring spring;
  const auto observe = [](const State&, const State& to, double, const VelocityVerlet&) { return to.t < 1.25; };
  const Outcome outcome = integrate_in_legs(spring, state, 3.0, scheme, control, 0.5, marks, observe);
  BOOST_TEST((outcome.status == Status::stopped));
  BOOST_TEST(outcome.reason == "the observer asked for it");
  BOOST_TEST(outcome.steps == 5);
  BOOST_TEST(marks.seen.size() == 2);
}

BOOST_AUTO_TEST_CASE(does_nothing_over_no_time_and_refuses_what_cannot_be_meant) {
  State state = body(1.0, 0.0, 0.5);
  VelocityVerlet scheme;
  FixedStep control{.step = 0.25};
  Marks marks;
  Spring spring;
  BOOST_TEST(integrate_in_legs(spring, state, 0.5, scheme, control, 0.5, marks).steps == 0);
  BOOST_TEST(marks.seen.empty());
  CHECK_REFUSED(integrate_in_legs(spring, state, 0.25, scheme, control, 0.5, marks), "not before the start at 0.5 s");
  CHECK_REFUSED(integrate_in_legs(spring, state, infinity, scheme, control, 0.5, marks), "end time must be finite");
  CHECK_REFUSED(integrate_in_legs(spring, state, 1.0, scheme, control, 0.0, marks), "must be positive and finite");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::legs_test
