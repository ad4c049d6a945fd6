#include <particulate/schemes/first_step.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "problems.hpp"
#include "says.hpp"

namespace tests::first_step_test {

using namespace particulate::schemes;

State body(double r, double v) { return {.r = Eigen::VectorXd::Constant(1, r), .v = Eigen::VectorXd::Constant(1, v)}; }

// A force that sets in from nothing, at a place that nothing tells from others.
struct Pushed {
  double force = 1.0;
  bool acceleration(double t, In, Out a) const {
    a.setConstant(force * t);
    return true;
  }
};

BOOST_AUTO_TEST_SUITE(first_step_)

BOOST_AUTO_TEST_CASE(is_a_hundredth_of_the_shortest_time_of_the_start) {
  Spring spring{1e4};
  BOOST_TEST(first_step(spring, body(1.0, 0.0), 10.0) == 1e-4, tolerance(1e-12));
  BOOST_TEST(first_step(spring, body(1.0, 1e3), 10.0) <= 1e-5);
  Decay decay;
  BOOST_TEST(first_step(decay, {.y = Eigen::VectorXd::Constant(1, 7.0)}, 100.0) == 0.01, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(is_a_hundredth_of_the_run_where_the_start_tells_nothing) {
  Pushed pushed;
  BOOST_TEST(first_step(pushed, body(0.0, 0.0), 5.0) == 0.05, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(has_the_units_of_the_problem) {
  for (const double length : {0x1p-40, 0x1p40}) {
    Spring spring{3.0};
    BOOST_TEST(first_step(spring, body(length, 0.3 * length), 9.0) == first_step(spring, body(1.0, 0.3), 9.0));
  }
  for (const double time : {0x1p-30, 0x1p30}) {
    Spring spring{3.0 / (time * time)}, plain{3.0};
    BOOST_TEST(first_step(spring, body(1.0, 0.3 / time), 9.0 * time) == time * first_step(plain, body(1.0, 0.3), 9.0));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(first_step_of_a_run)

// Step and limit left out: the error at the end follows TOL all the same.
template <class S>
void keeps_to(double TOL, double most) {
  State spring = body(1.0, 0.0);
  const Outcome outcome = run(Spring{}, spring, 10.0, S(), ErrorControl{.TOL = TOL});
  BOOST_TEST(outcome.reason == "");
  BOOST_TEST(std::abs(spring.r[0] - std::cos(10.0)) <= most * TOL);
}

BOOST_AUTO_TEST_CASE(is_chosen_where_it_is_left_out) {
  for (const double TOL : {1e-3, 1e-6, 1e-9}) {
    keeps_to<Collocation<Gauss<3>>>(TOL, 20.0);
    keeps_to<RungeKutta4>(TOL, 20.0);
    if (TOL > 1e-9) keeps_to<VelocityVerlet>(TOL, 20.0);
  }
}

BOOST_AUTO_TEST_CASE(is_counted_and_within_the_settings) {
  State spring = body(1.0, 0.0);
  PhiControl control{.TOL = 1e-6, .limit = 1e-3};
  Spring problem;
  PhiFamily<> scheme(0.5);
  const auto once = [](const auto&...) { return false; };
  const Outcome outcome = integrate(problem, spring, 1.0, scheme, control, once);
  BOOST_TEST(spring.t == 1e-3);
  BOOST_TEST(outcome.evaluations == outcome.sweeps + 1 + 2);
  BOOST_TEST(!control.waits_for_step());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::first_step_test
