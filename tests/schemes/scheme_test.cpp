#include <particulate/schemes/scheme.hpp>

#include <cmath>
#include <memory>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"

namespace tests::scheme_test {

using particulate::schemes::Controller;
using particulate::schemes::Decision;
using particulate::schemes::Dense;
using particulate::schemes::In;
using particulate::schemes::Iteration;
using particulate::schemes::Iterative;
using particulate::schemes::State;
using particulate::schemes::Out;
using particulate::schemes::Outcome;
using particulate::schemes::RungeKutta4;
using particulate::schemes::Scheme;
using particulate::schemes::Status;
using particulate::schemes::State;
using particulate::schemes::VelocityVerlet;

struct Spring {
  bool acceleration(double, In r, Out a) const {
    a = -r;
    return true;
  }
};
struct Damped {
  bool acceleration(double, In r, In v, Out a) const {
    a = -r - v;
    return true;
  }
};
struct Decay {
  bool rate(double, In y, Out dy) const {
    dy = -y;
    return true;
  }
};

static_assert(Scheme<RungeKutta4, Spring, Motion> && Scheme<RungeKutta4, Damped, Motion> &&
              Scheme<RungeKutta4, Decay, Values>);
static_assert(Scheme<VelocityVerlet, Spring, Motion>);
static_assert(Scheme<RungeKutta4, const Spring, Motion>, "a problem may be constant");
static_assert(!Scheme<VelocityVerlet, Damped, Motion>, "Verlet has no rule for forces that depend on velocities");
static_assert(!Scheme<RungeKutta4, Decay, Motion> && !Scheme<VelocityVerlet, Decay, Values>);
static_assert(!Iterative<RungeKutta4, Spring, Motion> && !Dense<RungeKutta4, Motion>);

struct Swept : RungeKutta4 {
  Iteration sweep(Spring&, const Motion&, double, Motion&) { return {}; }
  void at(const Motion&, double, double, Motion&) const {}
};
static_assert(Iterative<Swept, Spring, Motion> && Dense<Swept, Motion>);

// History behind a pointer would be shared by a checkpoint.
struct Uncopyable : RungeKutta4 {
  std::unique_ptr<int> history;
};
static_assert(!Scheme<Uncopyable, Spring, Motion>);

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
