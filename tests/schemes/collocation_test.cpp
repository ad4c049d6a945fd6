#include <particulate/schemes/collocation.hpp>

#include <cmath>
#include <vector>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::collocation_test {

using namespace particulate::schemes;

using Gauss3 = Collocation<Gauss<3>>;
using Stiff = Collocation<Radau<3>, Newton<>>;

// A spring under a force of its own, with the places where it was asked.
struct Spring {
  double stiffness = 1.0;
  double push = 0.0;  // times t
  std::vector<double> asked = {};

  bool acceleration(double t, In r, Out a) {
    asked.push_back(r[0]);
    a = -stiffness * r.array() + push * t;
    return true;
  }
};

static_assert(Iterative<Gauss3> && Dense<Gauss3> && EstimatesTruncation<Gauss3> && Advances<Gauss3, Spring>);
static_assert(Iterative<Stiff> && Dense<Stiff> && EstimatesTruncation<Stiff> && Advances<Stiff, Decay>);

// One step, its sweeps to rounding, accepted.
template <class S, class P>
State stepped(S& scheme, P& problem, const State& from, double dt) {
  State to = swept(scheme, problem, from, dt);
  scheme.accept(dt);
  return to;
}

// Right-hand sides asked for by the guess of a step.
long asked_by_guess(Gauss3 scheme, const State& from, double dt) {
  Spring problem;
  predicted(scheme, problem, from, dt);
  return static_cast<long>(problem.asked.size());
}

template <class S, class P>
Truncation estimated(S scheme, P problem, const State& from, double dt) {
  const State to = swept(scheme, problem, from, dt);
  return scheme.truncation(problem, from, dt, to);
}

BOOST_AUTO_TEST_SUITE(Collocation_)

BOOST_AUTO_TEST_CASE(of_one_radau_stage_from_free_flight_is_the_monographs_scheme_iterate_by_iterate) {
  Spring problem{.stiffness = 2.0};
  Collocation<Radau<1>, Picard> scheme({.guess = Guess::free_flight, .compensated = false});
  BackwardEuler euler;
  const State from = body(1.0, 2.0);
  State to = predicted(scheme, problem, from, 0.375), other = predicted(euler, problem, from, 0.375);
  for (int k = 0; k < 6; ++k) {
    BOOST_TEST(to.r[0] == other.r[0]);
    BOOST_TEST(to.v[0] == other.v[0]);
    const Iteration one = scheme.sweep(problem, from, 0.375, to);
    const Iteration two = euler.sweep(problem, from, 0.375, other);
    BOOST_TEST(one.w_K == two.w_K);
    BOOST_TEST(one.rate == two.rate);
  }
}

// r = t^3 under r'' = 6 t: the velocity 3 t^2 is the polynomial of its values at three nodes.
BOOST_AUTO_TEST_CASE(has_the_polynomial_of_the_step_anywhere_in_it) {
  Spring problem{.stiffness = 0.0, .push = 6.0};
  Gauss3 scheme;
  const State from = body(0.0, 0.0), to = stepped(scheme, problem, from, 0.5);
  BOOST_TEST(std::abs(to.r[0] - 0.125) <= 3e-17);
  State there;
  const double node = 0.5 + std::sqrt(15.0) / 10.0;
  for (const double theta : {0.0, 0.3, node, 1.0, 1.2}) {
    scheme.at(from, 0.5, theta, there);
    BOOST_TEST(there.t == 0.5 * theta);
    BOOST_TEST(std::abs(there.r[0] - std::pow(0.5 * theta, 3)) <= 2e-16);
    BOOST_TEST(std::abs(there.v[0] - 3.0 * std::pow(0.5 * theta, 2)) <= 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(has_dense_output_that_begins_at_the_start_and_ends_at_the_end) {
  Spring problem{.stiffness = 4.0};
  Gauss3 scheme;
  const State from = body(1.0, 2.0), to = stepped(scheme, problem, from, 0.5);
  State there;
  scheme.at(from, 0.5, 0.0, there);
  BOOST_TEST(there.r[0] == 1.0);
  BOOST_TEST(there.v[0] == 2.0);
  scheme.at(from, 0.5, 1.0, there);
  BOOST_TEST(std::abs(there.r[0] - to.r[0]) <= 1e-15);
  BOOST_TEST(std::abs(there.v[0] - to.v[0]) <= 2e-15);
}

// Under r'' = 6 t from rest at 0: the first stage believes in the rate at the start, which is none, the others in the
// straight line through it and the first stage's, which is right: their places are t^3.
BOOST_AUTO_TEST_CASE(draws_later_stages_of_the_first_sweep_through_the_rates_found_so_far) {
  Spring problem{.stiffness = 0.0, .push = 6.0};
  swept(Gauss3(), problem, body(0.0, 0.0), 0.5, 1);
  BOOST_TEST_REQUIRE(problem.asked.size() == 4U);
  BOOST_TEST(problem.asked[1] == 0.0);
  BOOST_TEST(std::abs(problem.asked[2] - std::pow(0.25, 3)) <= 1e-16);
  BOOST_TEST(std::abs(problem.asked[3] - std::pow(0.5 * (0.5 + std::sqrt(15.0) / 10.0), 3)) <= 1e-16);
}

BOOST_AUTO_TEST_CASE(extrapolates_where_the_step_goes_on_and_begins_anew_elsewhere) {
  Spring problem;
  Gauss3 scheme;
  const State end = stepped(scheme, problem, body(1.0, 2.0), 0.25);
  BOOST_TEST(asked_by_guess(scheme, end, 0.25) == 0);
  const auto changed = [&](auto change) {
    State other = end;
    change(other);
    return asked_by_guess(scheme, other, 0.25);
  };
  BOOST_TEST(changed([](State& m) { m.t = std::nextafter(m.t, 1.0); }) == 0);
  BOOST_TEST(changed([](State& m) { m.t += 0.1; }) == 1);
  BOOST_TEST(changed([](State& m) { m.r[0] = std::nextafter(m.r[0], 9.0); }) == 1);
  BOOST_TEST(changed([](State& m) { m.v[0] = -m.v[0]; }) == 1);
  scheme.forget();
  BOOST_TEST(asked_by_guess(scheme, end, 0.25) == 1);
}

BOOST_AUTO_TEST_CASE(still_knows_the_last_step_when_one_is_made_again_smaller) {
  Spring problem;
  Gauss3 scheme;
  const State end = stepped(scheme, problem, body(1.0, 2.0), 0.25);
  swept(scheme, problem, end, 0.5, 1);
  BOOST_TEST(asked_by_guess(scheme, end, 0.25) == 0);
}

BOOST_AUTO_TEST_CASE(is_a_checkpoint_when_copied) {
  Spring problem;
  Gauss3 scheme;
  const State end = stepped(scheme, problem, body(1.0, 2.0), 0.25);
  Gauss3 copy = scheme;
  const State one = stepped(scheme, problem, end, 0.25), other = stepped(copy, problem, end, 0.25);
  BOOST_TEST(one.r[0] == other.r[0]);
  BOOST_TEST(one.v[0] == other.v[0]);
}

// A thousand times 1e-17 to 1: each alone is lost in the rounding.
BOOST_AUTO_TEST_CASE(adds_up_what_rounding_takes_from_the_state) {
  const auto after = [](bool compensated) {
    Gauss3 scheme({.compensated = compensated});
    State state = body(1.0, 1e-17);
    BOOST_REQUIRE(run(Spring{.stiffness = 0.0}, state, 1000.0, scheme, FixedStep{.step = 1.0}).steps == 1000);
    return state.r[0];
  };
  BOOST_TEST(after(false) == 1.0);
  BOOST_TEST(std::abs(after(true) - (1.0 + 1e-14)) <= 2.3e-16);
}

// Order p: a step half as long leaves 2^-(p+1) of the error.
BOOST_AUTO_TEST_CASE(estimates_an_error_that_falls_with_the_order_that_it_names) {
  const auto falls = [](auto scheme, auto problem, const auto& from, int order) {
    const Truncation whole = estimated(scheme, problem, from, 1e-1), half = estimated(scheme, problem, from, 5e-2);
    BOOST_TEST(whole.order == order);
    BOOST_TEST(std::abs(std::log2(whole.error / half.error) - (order + 1)) <= 0.2);
  };
  falls(Gauss3(), Spring(), body(1.0, 2.0), 6);
  falls(Stiff(), Decay(), one(), 3);
}

// One stage compares with the rates at the start where there is no last step.
BOOST_AUTO_TEST_CASE(estimates_the_error_of_one_stage_from_its_first_step_on) {
  const Collocation<Radau<1>, Picard> scheme({.guess = Guess::free_flight});
  const Truncation whole = estimated(scheme, Spring(), body(1.0, 2.0), 1e-2);
  const Truncation half = estimated(scheme, Spring(), body(1.0, 2.0), 5e-3);
  BOOST_TEST(whole.order == 1);
  BOOST_TEST(std::abs(std::log2(whole.error / half.error) - 2.0) <= 0.1);
}

// y' = 2 y with a step of 1/2: the equation of the stage is 0 k = 2.
BOOST_AUTO_TEST_CASE(refuses_a_singular_system_with_the_reason) {
  State state = one();
  const Outcome outcome = run(Decay{-2.0}, state, 0.5, Collocation<Radau<1>, Newton<>>(), FixedStep{.step = 0.5});
  BOOST_TEST((outcome.failure == Failure::no_value));
  BOOST_TEST(contains(outcome.reason, "no finite value within this step of 0.5 s"));
  BOOST_TEST(state.y[0] == 1.0);
}

// (I + h A) k = -1 on y' = -y: the Pade approximation (1 - 2h/5 + h^2/20)/(1 + 3h/5 + 3h^2/20 + h^3/60) at h = 1.
BOOST_AUTO_TEST_CASE(solves_a_linear_problem_by_newton) {
  const State to = swept(Stiff(), Decay{}, one(), 1.0);
  BOOST_TEST(std::abs(to.y[0] - 0.65 / (1.0 + 0.6 + 0.15 + 1.0 / 60.0)) <= 2e-16);
}

// Springs of 2, 3, 1 and 5 unknowns, one after another, by a scheme that has solved others and by a new one.
BOOST_AUTO_TEST_CASE(serves_one_problem_after_another_of_different_length_by_newton) {
  Collocation<Gauss<3>, Newton<>> used;
  for (const Eigen::Index n : {2, 3, 1, 5}) {
    Spring spring{.stiffness = static_cast<double>(n)};
    State state{.r = Eigen::VectorXd::LinSpaced(n, 1.0, 2.0), .v = Eigen::VectorXd::Zero(n)}, again = state;
    FixedStep control{.step = 0.25};
    const Outcome outcome = integrate(spring, state, 1.0, used, control);
    BOOST_TEST(outcome.reason == "");
    BOOST_TEST(outcome.evaluations == run(spring, again, 1.0, Collocation<Gauss<3>, Newton<>>(), control).evaluations);
    BOOST_TEST(close(flat(state), flat(again), {}));
    const double root = std::sqrt(static_cast<double>(n));
    BOOST_TEST(close(state.r, std::cos(root) * Eigen::VectorXd::LinSpaced(n, 1.0, 2.0), {.absolute = 1e-4}));
  }
}

BOOST_AUTO_TEST_CASE(wants_as_many_sizes_as_unknowns) {
  Decay decay;
  Stiff scheme({.sizes = Eigen::Vector2d(1.0, 2.0)});
  State to;
  CHECK_REFUSED(scheme.predict(decay, one(), 1.0, to), "sizes must be one for each of 1 unknowns, got 2");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_the_size_and_what_was_given) {
  const auto refuses = [](const CollocationSettings& bad, const char* words) {
    CHECK_REFUSED(validate(bad), words);
    CHECK_REFUSED(Gauss3{bad}, words);
  };
  BOOST_CHECK_NO_THROW(validate(CollocationSettings{}));
  refuses({.size = 0.0}, "collocation: size must be positive and finite, got 0");
  refuses({.speed = -1.0}, "collocation: speed must be positive and finite, got -1");
  refuses({.sizes = Eigen::Vector2d(1.0, not_a_number)}, "collocation: sizes must be positive and finite, got nan");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::collocation_test
