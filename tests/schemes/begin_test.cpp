#include <cmath>
#include <string>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "problems.hpp"

// A scheme object used for another run begins anew: to the last bit what a new one does.

namespace tests::begin_test {

using namespace particulate::schemes;

// As many bodies on springs, at r = 1 and at rest.
State springs(Eigen::Index n, double t = 0.0) {
  return {.t = t, .r = Eigen::VectorXd::Ones(n), .v = Eigen::VectorXd::Zero(n)};
}

State values(Eigen::Index n) { return {.y = Eigen::VectorXd::Ones(n)}; }

// The run of a scheme with a past is that of one without.
template <class S, class P>
void runs_as_if_new(S& used, const S& fresh, P& problem, const State& start, double TOL = 1e-9) {
  State one = start, other = start;
  S anew = fresh;
  const Outcome by_used = run(problem, one, start.t + 1.0, used, equal_steps<S>(0.125, TOL));
  const Outcome by_fresh = run(problem, other, start.t + 1.0, anew, equal_steps<S>(0.125, TOL));
  BOOST_TEST(by_fresh.reason == "");
  BOOST_TEST(close(flat(one), flat(other), {}));
  BOOST_TEST(by_used.evaluations == by_fresh.evaluations);
}

// A past of every kind: other sizes, the same size and another problem or another kind of unknowns, the same problem
// from the start again, a run that an observer stopped and one that failed, and a copy of all that.
template <class S>
void begins_anew(const S& fresh) {
  S used = fresh;
  for (const Eigen::Index n : {2, 3, 1, 5}) {
    Spring spring{1.0 + static_cast<double>(n)};
    runs_as_if_new(used, fresh, spring, springs(n));
  }
  Spring soft{1.0}, hard{9.0};
  State went = springs(5);
  runs_as_if_new(used, fresh, soft, went);
  runs_as_if_new(used, fresh, hard, went);
  runs_as_if_new(used, fresh, hard, went);
  (void)run(soft, went, 1.0, used, FixedStep{.step = 0.125});
  runs_as_if_new(used, fresh, hard, went);  // where the last run ended
  const auto stop = [](const State&, const State& to, double, const S&) { return to.t < 0.3; };
  went = springs(5);
  (void)run(soft, went, 1.0, used, FixedStep{.step = 0.125}, stop);
  runs_as_if_new(used, fresh, soft, springs(5));
  Failing failing{7};
  went = springs(1);
  BOOST_TEST((run(failing, went, 9.0, used, FixedStep{.step = 0.125}).status == Status::failed));
  S copy = used;
  runs_as_if_new(used, fresh, soft, went);
  runs_as_if_new(copy, fresh, soft, springs(1));
  if constexpr (Advances<S, Decay>) {
    Decay decay;
    runs_as_if_new(used, fresh, decay, values(1));
    runs_as_if_new(used, fresh, soft, springs(1));
  }
}

// A problem that is made four times as stiff between two parts of a run: as if the second were begun by a new scheme.
template <class S>
void sees_a_change_in_place(S scheme) {
  S fresh = scheme;
  Spring spring;
  FixedStep control = equal_steps<S>(0.125, 1e-13);
  State state = displaced();
  BOOST_TEST(integrate(spring, state, 1.0, scheme, control).steps == 8);
  spring.stiffness = 4.0;
  State anew = state;
  BOOST_TEST(integrate(spring, state, 2.0, scheme, control).reason == "");
  BOOST_TEST(integrate(spring, anew, 2.0, fresh, control).steps == 8);
  BOOST_TEST(close(flat(state), flat(anew), {}));
}

// One run and two parts of it.
template <class S>
void continues_to_the_same_bits(S scheme) {
  FixedStep control = equal_steps<S>(0.125, 1e-7);
  S other = scheme;
  Driven problem;
  State whole = Driven::at(0.0), parts = whole;
  const Outcome outcome = run(problem, whole, 2.0, other, control);
  const Outcome first = run(problem, parts, 1.0, scheme, control);
  const Outcome second = run(problem, parts, 2.0, scheme, control);
  BOOST_TEST(close(flat(parts), flat(whole), {}));
  BOOST_TEST(first.sweeps + second.sweeps == outcome.sweeps);
}

BOOST_AUTO_TEST_SUITE(Begins_)

BOOST_AUTO_TEST_CASE(anew_whatever_the_scheme_was_used_for) {
  begins_anew(RungeKutta4());
  begins_anew(VelocityVerlet());
  begins_anew(ForwardEuler());
  begins_anew(BackwardEuler());
  begins_anew(PhiFamily<Anderson>(0.5));
  begins_anew(Collocation<Gauss<1>>());
  begins_anew(Collocation<Gauss<3>, Newton<>>());
  begins_anew(Collocation<Radau<2>, Anderson>());
  begins_anew(Collocation<Radau<3>, Newton<>>());
}

BOOST_AUTO_TEST_CASE(with_a_problem_that_was_changed_in_place) {
  sees_a_change_in_place(VelocityVerlet());
  sees_a_change_in_place(RungeKutta4());
  sees_a_change_in_place(PhiFamily<>(0.5));
  sees_a_change_in_place(Collocation<Gauss<4>>());
  sees_a_change_in_place(Collocation<Radau<3>, Newton<>>());
}

BOOST_AUTO_TEST_CASE(where_the_last_run_ended_with_what_that_knew) {
  continues_to_the_same_bits(Collocation<Gauss<3>>());
  continues_to_the_same_bits(Collocation<Gauss<3>, Newton<>>());
  continues_to_the_same_bits(VelocityVerlet());
  continues_to_the_same_bits(PhiFamily<Anderson>(0.5));
}

// Stale, the Jacobian of the soft spring would let Newton diverge on the stiff one: the step is not refused.
BOOST_AUTO_TEST_CASE(with_the_jacobian_of_a_problem_that_has_become_stiff) {
  Spring spring;
  Collocation<Radau<3>, Newton<>> scheme;
  FixedStep control{.step = 0.1, .TOL = 1e-9, .contractions = 4};
  State state = displaced();
  BOOST_TEST(integrate(spring, state, 1.0, scheme, control).reason == "");
  spring.stiffness = 1e6;
  BOOST_TEST(integrate(spring, state, 2.0, scheme, control).reason == "");
}

// The fields of a pair are two, of which the first scheme knows nothing any more.
BOOST_AUTO_TEST_CASE(of_staggered_fields_as_well) {
  FirstOrderPair pair, other;
  pair.a << 1.0, 3.0, -3.0, 1.0;
  other.a << 2.0, 1.0, 0.5, 4.0;
  const Staggered fresh({{.name = "first"}, {.name = "second"}}, Seen::newest, Aitken());
  Staggered used = fresh;
  for (FirstOrderPair* problem : {&pair, &other, &pair}) runs_as_if_new(used, fresh, *problem, values(2), 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::begin_test
