#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <particulate/reference/integrator.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::bdf_test {

using namespace particulate::reference;
using namespace particulate::schemes;

// y' = -1e6 (y - cos t) - sin t: y = cos t + (y_0 - 1) exp(-1e6 t).
struct Stiff {
  static bool rate(double t, In y, Out dy) {
    dy[0] = -1e6 * (y[0] - std::cos(t)) - std::sin(t);
    return true;
  }
};

// Three species, from (1, 0, 0).
struct Robertson {
  static bool rate(double, In y, Out dy) {
    dy[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
    dy[2] = 3e7 * y[1] * y[1];
    dy[1] = -dy[0] - dy[2];
    return true;
  }
};

struct RobertsonWithJacobian : Robertson {
  static void jacobian(double, In y, Eigen::MatrixXd& J) {
    J.row(0) << -0.04, 1e4 * y[2], 1e4 * y[1];
    J.row(2) << 0.0, 6e7 * y[1], 0.0;
    J.row(1) = -J.row(0) - J.row(2);
  }
};

State robertson_start() { return {.t = 0.0, .y = Eigen::Vector3d(1.0, 0.0, 0.0)}; }

// Heat in a rod of 24 nodes between cold ends: the modes sin(k pi i/25) decay at 4 * 25^2 sin^2(k pi/50).
struct Rod {
  static constexpr Eigen::Index n = 24;
  static bool rate(double, In u, Out du) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double left = i > 0 ? u[i - 1] : 0.0, right = i + 1 < n ? u[i + 1] : 0.0;
      du[i] = 625.0 * (left - 2.0 * u[i] + right);
    }
    return true;
  }
};

// Modes 1 and 3 at time t, from amplitudes 1 and 1/2.
State rod(double t) {
  State at{.t = t, .y = Eigen::VectorXd::Zero(Rod::n)};
  for (const int mode : {1, 3}) {
    const double decay = std::exp(-2500.0 * std::pow(std::sin(mode * pi / 50.0), 2) * t);
    for (Eigen::Index i = 0; i < Rod::n; ++i) {
      at.y[i] += (mode == 1 ? 1.0 : 0.5) * decay * std::sin(mode * pi * static_cast<double>(i + 1) / 25.0);
    }
  }
  return at;
}

// Each cell takes over the value of the one before it, cell 0 that of cos t: y_i' = 1000 (y_(i-1) - y_i).
struct Conveyor {
  static bool rate(double t, In y, Out dy) {
    dy[0] = 1000.0 * (std::cos(t) - y[0]);
    for (Eigen::Index i = 1; i < y.size(); ++i) dy[i] = 1000.0 * (y[i - 1] - y[i]);
    return true;
  }
};

BOOST_AUTO_TEST_SUITE(bdf)

BOOST_AUTO_TEST_CASE(a_stiff_linear_problem_meets_its_closed_form_at_the_cost_of_a_smooth_one) {
  for (const double start : {1.0, 2.0}) {
    Stiff problem;
    State state = one(start);
    const Outcome out = integrate(problem, state, 3.0, Bdf{.relative = 1e-8, .absolute = 1e-10});
    BOOST_TEST((out.status == Status::reached));
    BOOST_TEST(std::abs(state.y[0] - std::cos(3.0)) < 1e-6);
    BOOST_TEST(out.evaluations < 2000);
  }
  // Adams is bound by stability to steps of some 1e-6.
  Stiff problem;
  State state = one(1.0);
  const Outcome out = integrate(problem, state, 3.0, Adams{.relative = 1e-8, .absolute = 1e-10, .max_steps = 20'000});
  BOOST_TEST((out.status == Status::failed));
  BOOST_TEST(out.t < 0.1);
}

// The digits at t = 40 on which published results of Radau, Rosenbrock and multistep codes agree.
BOOST_AUTO_TEST_CASE(robertsons_kinetics_meet_the_published_digits) {
  const Eigen::Vector3d published(0.7158270687, 9.185534765e-6, 0.2841637457);
  const Bdf method{.relative = 1e-11, .absolute = 1e-16};
  Robertson plain;
  RobertsonWithJacobian differentiated;
  State by_quotients = robertson_start(), by_jacobian = robertson_start();
  BOOST_TEST((integrate(plain, by_quotients, 40.0, method).status == Status::reached));
  BOOST_TEST((integrate(differentiated, by_jacobian, 40.0, method).status == Status::reached));
  BOOST_TEST(close(by_quotients.y, published, {.relative = 1e-9}));
  BOOST_TEST(close(by_jacobian.y, published, {.relative = 1e-9}));
}

// The quotients of a linear problem are exact to rounding: all else is the same but for 8 right-hand sides a Jacobian.
BOOST_AUTO_TEST_CASE(a_given_jacobian_takes_the_place_of_difference_quotients) {
  struct Differentiated : Conveyor {
    long jacobians = 0;
    void jacobian(double, In y, Eigen::MatrixXd& J) {
      ++jacobians;
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        J(i, i) = -1000.0;
        if (i > 0) J(i, i - 1) = 1000.0;
      }
    }
  };
  const Bdf method{.relative = 1e-6, .absolute = 1e-8};
  Conveyor plain;
  Differentiated problem;
  long of_plain = 0, evaluations = 0;
  const Problem counted_plain(plain, &of_plain), counted(problem, &evaluations);
  State state{.t = 0.0, .y = Eigen::VectorXd::Ones(8)}, same = state;
  Integrator integrator(counted, state, method);
  const Outcome out = integrator.advance(state, 2.0), quotients = integrate(counted_plain, same, 2.0, method);
  BOOST_TEST((out.status == Status::reached && quotients.status == Status::reached));
  BOOST_TEST(problem.jacobians > 0);
  BOOST_TEST(out.evaluations == evaluations);
  BOOST_TEST(out.evaluations == integrator.evaluations_by_sundials());
  BOOST_TEST(quotients.evaluations == of_plain);
  BOOST_TEST(quotients.evaluations == out.evaluations + 8 * problem.jacobians);
  BOOST_TEST(out.sweeps == quotients.sweeps);
  BOOST_TEST(out.steps == quotients.steps);
}

// y drives a damped spring and is driven by both its place and its speed, stiffly; y rides along where it has no rate.
struct Coupled {
  static bool rates(double, In r, In v, In y, Out a, Out dy) {
    a[0] = -1e4 * r[0] - 1e3 * v[0] + 1e4 * y[0];
    if (dy.size() > 0) dy[0] = -2e3 * y[0] + 1e3 * r[0] + 10.0 * v[0];
    return true;
  }
};
struct Carried : Coupled {
  static constexpr bool values_by_jumps = true;
};

BOOST_AUTO_TEST_CASE(a_given_jacobian_of_motion_and_values_takes_the_place_of_difference_quotients) {
  struct Differentiated : Coupled {
    long jacobians = 0;
    void jacobian(double, In, In, In, Eigen::MatrixXd& J) {
      ++jacobians;
      J << -1e4, -1e3, 1e4, 1e3, 10.0, -2e3;
    }
  } problem;
  Coupled plain;
  const Bdf method{.relative = 1e-6, .absolute = 1e-8};
  State state = displaced(Eigen::VectorXd::Ones(1)), same = state;
  const Outcome out = integrate(problem, state, 0.2, method), quotients = integrate(plain, same, 0.2, method);
  BOOST_TEST((out.status == Status::reached && quotients.status == Status::reached));
  BOOST_TEST(problem.jacobians > 0);
  BOOST_TEST(out.evaluations < quotients.evaluations);
  BOOST_TEST(std::abs(out.sweeps - quotients.sweeps) <= quotients.sweeps / 10);
  BOOST_TEST(std::abs(out.steps - quotients.steps) <= quotients.steps / 10);
  BOOST_TEST(close(flat(state), flat(same), {.relative = 1e-5}));
}

BOOST_AUTO_TEST_CASE(a_given_jacobian_leaves_out_values_that_change_by_jumps_alone) {
  struct Carrying : Carried {
    long jacobians = 0;
    void jacobian(double, In, In, In, Eigen::MatrixXd& J) {
      ++jacobians;
      BOOST_TEST((J.rows() == 1 && J.cols() == 2));
      J << -1e4, -1e3;
    }
  } problem;
  State state = displaced(Eigen::VectorXd::Constant(1, 0.5));
  const Outcome out = integrate(problem, state, 3.0, Bdf{.relative = 1e-8, .absolute = 1e-10});
  BOOST_TEST((out.status == Status::reached), out.reason);
  BOOST_TEST(problem.jacobians > 0);
  BOOST_TEST(state.y[0] == 0.5);
  BOOST_TEST(std::abs(state.r[0] - 0.5) <= 1e-7);  // where the spring comes to rest
}

// A Jacobian that is wrong costs iterations and steps.
BOOST_AUTO_TEST_CASE(a_given_jacobian_of_a_nonlinear_problem_iterates_as_its_quotients_do) {
  const Bdf method{.relative = 1e-8, .absolute = 1e-12};
  RobertsonWithJacobian problem;
  Robertson plain;
  State state = robertson_start(), same = state;
  const Outcome out = integrate(problem, state, 40.0, method), quotients = integrate(plain, same, 40.0, method);
  BOOST_TEST(out.evaluations < quotients.evaluations);
  BOOST_TEST(std::abs(out.sweeps - quotients.sweeps) <= quotients.sweeps / 20);
  BOOST_TEST(std::abs(out.steps - quotients.steps) <= quotients.steps / 20);
}

BOOST_AUTO_TEST_CASE(a_band_does_what_a_full_matrix_does_for_fewer_right_hand_sides) {
  Rod problem;
  State full = rod(0.0), banded = rod(0.0);
  const Outcome dense = integrate(problem, full, 0.05, Bdf{.relative = 1e-9, .absolute = 1e-12});
  const Outcome band =
      integrate(problem, banded, 0.05,
                Bdf{.relative = 1e-9, .absolute = 1e-12, .jacobian = BandedJacobian{.lower = 1, .upper = 1}});
  BOOST_TEST((dense.status == Status::reached && band.status == Status::reached));
  BOOST_TEST(close(full.y, rod(0.05).y, {.absolute = 1e-7}));
  BOOST_TEST(close(banded.y, rod(0.05).y, {.absolute = 1e-7}));
  BOOST_TEST(band.steps == dense.steps);
  BOOST_TEST(band.sweeps == dense.sweeps);
  // 24 right-hand sides a Jacobian against 3.
  const long saved = dense.evaluations - band.evaluations;
  BOOST_TEST(saved > 0);
  BOOST_TEST(saved % (24 - 3) == 0);
}

BOOST_AUTO_TEST_CASE(lower_and_upper_are_told_apart) {
  const auto run = [](const particulate::reference::Jacobian& jacobian) {
    Conveyor problem;
    State state{.t = 0.0, .y = Eigen::VectorXd::Ones(8)};
    const Outcome out = integrate(problem, state, 2.0, Bdf{.relative = 1e-6, .absolute = 1e-8, .jacobian = jacobian});
    BOOST_TEST((out.status == Status::reached));
    return out;
  };
  const Outcome full = run(DenseJacobian{}), below = run(BandedJacobian{.lower = 1, .upper = 0}),
                above = run(BandedJacobian{.lower = 0, .upper = 1});
  BOOST_TEST(below.sweeps == full.sweeps);
  BOOST_TEST(below.steps == full.steps);
  BOOST_TEST((full.evaluations - below.evaluations) % (8 - 2) == 0);
  BOOST_TEST(above.steps > 2 * full.steps);
}

BOOST_AUTO_TEST_CASE(a_second_order_problem_is_solved_by_difference_quotients) {
  struct Oscillator {
    bool asked = false;
    static bool acceleration(double, In r, In v, Out a) {
      a = -1e4 * r - 1e4 * v;
      return true;
    }
    void jacobian(double, In, Eigen::MatrixXd&) { asked = true; }
  };
  Oscillator problem;
  State state{.t = 0.0, .r = Eigen::VectorXd::Constant(1, 1.0), .v = Eigen::VectorXd::Constant(1, 0.0)};
  const Outcome out = integrate(problem, state, 2.0, Bdf{.relative = 1e-9, .absolute = 1e-12});
  BOOST_TEST((out.status == Status::reached));
  BOOST_TEST(!problem.asked);
  BOOST_TEST(out.evaluations < 2000);
  // r = (s_2 e^(s_1 t) - s_1 e^(s_2 t))/(s_2 - s_1) with s^2 + 1e4 s + 1e4 = 0; the fast root's part has died out.
  const double fast = -5e3 - std::sqrt(25e6 - 1e4), slow = 1e4 / fast;
  const double r = fast / (fast - slow) * std::exp(slow * 2.0);
  BOOST_TEST(close(Eigen::Vector2d(state.r[0], state.v[0]), Eigen::Vector2d(r, slow * r), {.relative = 1e-6}));
}

BOOST_AUTO_TEST_CASE(every_setting_reaches_cvode) {
  const auto steps_with = [](const Bdf& method) {
    Stiff problem;
    State state = one(1.0);
    const Outcome out = integrate(problem, state, 1.0, method);
    BOOST_TEST((out.status == Status::reached));
    return out.steps;
  };
  const long steps = steps_with({.relative = 1e-6, .absolute = 1e-6});
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e-6, .max_order = 1}) > 3 * steps);
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e-6, .first_step = 1e-12}) > steps);
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e-6, .largest_step = 0.001}) >= 1000);
  BOOST_TEST(steps_with({.relative = 1e-9, .absolute = 1e-6}) > steps);
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e-2}) < steps);
  Stiff problem;
  State state = one(1.0);
  const Outcome cut = integrate(problem, state, 1.0, Bdf{.max_steps = 7});
  BOOST_TEST((cut.status == Status::failed && cut.steps == 7));
  BOOST_TEST(contains(cut.reason, "max_steps = 7 were not enough"));
}

BOOST_AUTO_TEST_CASE(counts_in_legs_what_the_problem_and_sundials_count) {
  Robertson problem;
  long evaluations = 0;
  const Problem counted(problem, &evaluations);
  State state = robertson_start();
  Integrator integrator(counted, state, Bdf{.relative = 1e-6, .absolute = 1e-10});
  const Outcome first = integrator.advance(state, 0.4), second = integrator.advance(state, 4.0);
  BOOST_TEST(first.evaluations + second.evaluations == evaluations);
  BOOST_TEST(integrator.evaluations_by_sundials() == evaluations);
  BOOST_TEST((first.sweeps >= first.steps && second.sweeps >= second.steps));
  BOOST_TEST(evaluations > first.sweeps + second.sweeps);

  // A changed state starts afresh, also the counts, as a new integrator would from there.
  state.y = Eigen::Vector3d(0.5, 1e-6, 0.5);
  State copy = state;
  BOOST_TEST(integrator.advance(state, state.t).evaluations == 0);
  BOOST_TEST(integrator.evaluations_by_sundials() == 0);
  const Outcome changed = integrator.advance(state, 8.0),
                afresh = integrate(problem, copy, 8.0, Bdf{.relative = 1e-6, .absolute = 1e-10});
  BOOST_TEST(changed.evaluations == afresh.evaluations);
  BOOST_TEST(integrator.evaluations_by_sundials() == changed.evaluations);
  BOOST_TEST((state.t == copy.t && state.y == copy.y));
}

// From y(0) = 2 the solution falls onto cos t within microseconds, and passes 1/2 there at t = pi/3.
BOOST_AUTO_TEST_CASE(events_stop_it_where_the_closed_form_has_them) {
  for (const particulate::reference::Jacobian& jacobian :
       {particulate::reference::Jacobian(DenseJacobian{}), particulate::reference::Jacobian(BandedJacobian{0, 0})}) {
    Stiff problem;
    State state = one(2.0);
    const Events events{{.function = [](const State& at) { return at.y[0] - 1.5; }, .direction = Direction::falling},
                        {.function = [](const State& at) { return at.y[0] - 0.5; }}};
    Integrator integrator(problem, state, Bdf{.relative = 1e-9, .absolute = 1e-11, .jacobian = jacobian}, events);
    BOOST_TEST(integrator.advance(state, 4.0).reason == "event 0 falling");
    BOOST_TEST(state.t == 1e-6 * std::log(2.0), tolerance(1e-5));
    BOOST_TEST(integrator.advance(state, 4.0).reason == "event 1 falling");
    BOOST_TEST(state.t == pi / 3.0, tolerance(1e-7));
    BOOST_TEST((integrator.advance(state, 4.0).status == Status::reached));
    BOOST_TEST(integrator.advance(state, 6.0).reason == "event 1 rising");
    BOOST_TEST(state.t == 5.0 * pi / 3.0, tolerance(1e-7));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bdf_jacobian)

BOOST_AUTO_TEST_CASE(what_it_throws_comes_out_and_the_integrator_goes_on) {
  struct Mistaken : Decay {
    bool mistaken = true;
    void jacobian(double, In, Eigen::MatrixXd& J) const {
      if (mistaken) throw std::domain_error("no derivative today");
      J(0, 0) = -1.0;
    }
  } problem;
  State state = one(1.0);
  Integrator integrator(problem, state, Bdf{});
  BOOST_CHECK_EXCEPTION((void)integrator.advance(state, 1.0), std::domain_error, says("no derivative today"));
  BOOST_TEST((state.t == 0.0 && state.y[0] == 1.0));
  problem.mistaken = false;
  BOOST_TEST((integrator.advance(state, 1.0).status == Status::reached));
  BOOST_TEST(state.y[0] == std::exp(-1.0), tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(of_another_size_is_refused) {
  struct Larger : Decay {
    static void jacobian(double, In, Eigen::MatrixXd& J) { J = -Eigen::MatrixXd::Identity(2, 3); }
  } problem;
  State state = one(1.0);
  CHECK_REFUSED(integrate(problem, state, 1.0, Bdf{}),
                "jacobian must leave its matrix 1 x 1, one row a rate and one column an unknown, got 2 x 3");
}

BOOST_AUTO_TEST_CASE(that_is_not_finite_ends_the_run_with_the_reason) {
  struct Singular : Decay {
    static void jacobian(double t, In, Eigen::MatrixXd& J) { J(0, 0) = t < 0.5 ? -1.0 : not_a_number; }
  } problem;
  State state = one(1.0);
  const Outcome out = integrate(problem, state, 10.0, Bdf{.relative = 1e-6, .absolute = 1e-8});
  BOOST_TEST((out.status == Status::failed));
  BOOST_TEST(contains(out.reason, "its Jacobian was not finite at t = "));
  BOOST_TEST(state.y[0] == std::exp(-state.t), tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_band_as_wide_as_the_problem_is_refused) {
  Rod problem;
  const State state = rod(0.0);
  for (const auto& [lower, upper] : {std::pair(24, 0), std::pair(0, 24)}) {
    const Bdf method{.jacobian = BandedJacobian{.lower = lower, .upper = upper}};
    CHECK_REFUSED(Integrator(problem, state, method),
                  "half-bandwidths must be below the number of unknowns, 24, got lower " + std::to_string(lower) +
                      " and upper " + std::to_string(upper));
  }
  BOOST_CHECK_NO_THROW(Integrator(problem, state, Bdf{.jacobian = BandedJacobian{.lower = 23, .upper = 23}}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::bdf_test
