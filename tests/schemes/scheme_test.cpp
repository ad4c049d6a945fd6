#include <particulate/schemes/scheme.hpp>

#include <cmath>
#include <memory>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::scheme_test {

using namespace particulate::schemes;

// Fields alone, without a rate of all of them.
struct Fields {
  std::size_t fields() const { return 1; }
  bool solve(std::size_t, const State&, double, const State&, State&) const { return true; }
  particulate::schemes::Part part(std::size_t) const { return {.motion = true}; }
};

static_assert(Scheme<RungeKutta4> && Scheme<VelocityVerlet> && Scheme<Staggered>);
static_assert(Advances<RungeKutta4, Spring> && Advances<RungeKutta4, Damped> && Advances<RungeKutta4, Decay>);
static_assert(Advances<VelocityVerlet, Spring>);
static_assert(Advances<RungeKutta4, const Spring>, "a problem may be constant");
static_assert(!Advances<VelocityVerlet, Damped>, "Verlet has no rule for forces that depend on velocities");
static_assert(!Advances<VelocityVerlet, Decay>);
static_assert(Advances<Staggered, Fields> && !Advances<RungeKutta4, Fields> && !Advances<Staggered, Spring>);
static_assert(Advances<VelocityVerlet, Problem>, "of an erased problem it is known only when a run starts");
static_assert(!Advances<Damped, Spring>, "what is no scheme advances nothing");
static_assert(!Iterative<RungeKutta4> && Dense<RungeKutta4> && !Measured<RungeKutta4> && Limited<RungeKutta4>);

struct Swept : RungeKutta4 {
  Iteration sweep(const Problem&, const State&, double, State&) { return {}; }
  void at(const State&, double, double, State&) const {}
};
static_assert(Iterative<Swept> && Dense<Swept>);

struct WithoutDense : RungeKutta4 {
  void at() const;
};
static_assert(Scheme<WithoutDense> && !Dense<WithoutDense>);

// History behind a pointer would be shared by a checkpoint.
struct Uncopyable : RungeKutta4 {
  std::unique_ptr<int> history;
};
static_assert(!Scheme<Uncopyable>);

// A scheme says what it can advance.
struct Silent {
  static constexpr int order = 1;
  bool predict(const Problem&, const State&, double, State&) { return true; }
  void accept(double) {}
  void forget() {}
};
static_assert(!Scheme<Silent>);

struct WithoutValidation {
  double dt() const { return 1.0; }
  bool goes_on(const Iteration&) const { return false; }
  Decision judge(const particulate::schemes::Attempt&) const { return {.accepted = true, .impossible = {}}; }
};
static_assert(Controller<particulate::schemes::FixedStep>);
static_assert(!Controller<WithoutValidation>, "a controller is checked when a run starts");

BOOST_AUTO_TEST_SUITE(Outcome_)

BOOST_AUTO_TEST_CASE(of_a_run_that_did_nothing_counts_nothing) {
  const Outcome none;
  BOOST_TEST((none.status == Status::reached));
  BOOST_TEST(none.reason.empty());
  BOOST_TEST(none.steps + none.rejections + none.sweeps + none.evaluations + none.impacts == 0);
  BOOST_TEST(none.contraction == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Iteration_)

BOOST_AUTO_TEST_CASE(without_a_sweep_has_no_contraction) {
  BOOST_TEST(Iteration{}.K == -1);
  BOOST_TEST(Iteration{}.rate == 0.0);
  BOOST_TEST(Iteration{}.evaluated);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Attempt_)

BOOST_AUTO_TEST_CASE(has_no_truncation_error_unless_the_scheme_gives_one) {
  const particulate::schemes::Attempt attempt{.dt = 0.1, .iteration = {}};
  BOOST_TEST(std::isnan(attempt.truncation.error));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::scheme_test
