#include <particulate/reference/integrator.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <stdexcept>
#include <utility>
#include <vector>

#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/reference/fixed_point.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "close.hpp"
#include "problems.hpp"
#include "reference/solved.hpp"

namespace tests::integrator_test {

using namespace particulate::reference;
using namespace particulate::schemes;

bool equal(const State& a, const State& b) { return a.t == b.t && a.r == b.r && a.v == b.v && a.y == b.y; }

// What must hold for every method: Adams, BDF, and two tables, one with an embedded pair of high order.
std::vector<Method> every_kind(double relative, double absolute) {
  return {Adams{.relative = relative, .absolute = absolute},
          ExplicitRungeKutta{.relative = relative, .absolute = absolute},
          ExplicitRungeKutta{.table = Table::fehlberg_13_7_8, .relative = relative, .absolute = absolute},
          Bdf{.relative = relative, .absolute = absolute}};
}

// y' = -y and others whose rate is one expression of t and y.
template <class F>
struct Scalar {
  F f;
  long evaluations = 0;
  double latest = 0.0;
  bool rate(double t, In y, Out dy) {
    ++evaluations;
    latest = std::max(latest, t);
    dy[0] = f(t, y[0]);
    return true;
  }
};
template <class F>
Scalar(F) -> Scalar<F>;

// y' = y cos t, y = y_0 exp(sin t).
auto swinging() {
  return Scalar{[](double t, double y) { return y * std::cos(t); }};
}

// r'' = -r/|r|^3 in the plane, from the pericentre of an orbit of semi-major axis 1.
struct Kepler {
  static bool acceleration(double, In r, Out a) {
    const double d = r.norm();
    a = -r / (d * d * d);
    return true;
  }
};

constexpr long double eccentricity = 0.3L;

// Kepler's equation E - e sin E = t by its fixed point, which contracts by e.
State orbit(double t) {
  long double E = t;
  for (int i = 0; i < 100; ++i) E = t + eccentricity * std::sin(E);
  const long double minor = std::sqrt(1.0L - eccentricity * eccentricity);
  const long double turning = 1.0L / (1.0L - eccentricity * std::cos(E));
  const Eigen::Vector2d r(static_cast<double>(std::cos(E) - eccentricity), static_cast<double>(minor * std::sin(E)));
  const Eigen::Vector2d v(static_cast<double>(-std::sin(E) * turning),
                          static_cast<double>(minor * std::cos(E) * turning));
  return {.t = t, .r = r, .v = v};
}

double error(const State& computed) {
  const State exact = orbit(computed.t);
  return std::hypot((computed.r - exact.r).norm(), (computed.v - exact.v).norm());
}

// y' = -2 sqrt(y) from 1, y = (1 - t)^2: no value for y < 0, which it says in one of two ways.
struct Draining {
  bool says_so;
  long refused = 0;
  bool rate(double, In y, Out dy) {
    dy[0] = -2.0 * std::sqrt(y[0]);
    if (y[0] >= 0.0) return true;
    ++refused;
    return !says_so;
  }
};

// y' = 1, and no value beyond y = 1.
struct Walled {
  static bool rate(double, In y, Out dy) {
    dy[0] = 1.0;
    return y[0] <= 1.0;
  }
};

BOOST_AUTO_TEST_SUITE(integrate_)

BOOST_AUTO_TEST_CASE(a_first_order_problem_meets_its_closed_form) {
  for (const Method& method : every_kind(1e-12, 1e-14)) {
    BOOST_TEST_CONTEXT("method " << method.index()) {
      const State state = solved(swinging(), one(2.0), 4.0, method);
      BOOST_TEST(state.y[0] == 2.0 * std::exp(std::sin(4.0)), tolerance(1e-10));
    }
  }
}

BOOST_AUTO_TEST_CASE(an_orbit_meets_keplers_equation_by_every_method) {
  std::vector<Method> methods{Adams{.relative = 1e-12, .absolute = 1e-12}};
  for (const Table table : tables) {
    // An error per step of 1e-12 would take the method of order 2 too many steps for a test.
    const double tolerance = order(table) < 3 ? 1e-9 : 1e-12;
    if (embedded_order(table) > 0) {
      methods.emplace_back(ExplicitRungeKutta{.table = table, .relative = tolerance, .absolute = tolerance});
    }
  }
  for (const Method& method : methods) {
    const auto* const tabled = std::get_if<ExplicitRungeKutta>(&method);
    BOOST_TEST_CONTEXT((tabled ? name(tabled->table) : "Adams")) {
      const State state = solved(Kepler{}, orbit(0.0), 3.0, method);
      BOOST_TEST(error(state) < (tabled && order(tabled->table) < 3 ? 1e-5 : 1e-9));
    }
  }
}

// r'' = -r - 2 z v with z = 0.1: r = exp(-z t) (cos w t + (z/w) sin w t), w = sqrt(1 - z^2), from r = 1, v = 0.
BOOST_AUTO_TEST_CASE(forces_that_depend_on_velocities_see_them) {
  struct Damped {
    static bool acceleration(double, In r, In v, Out a) {
      a = -r - 0.2 * v;
      return true;
    }
  };
  const double w = std::sqrt(0.99), t = 5.0;
  const double r = std::exp(-0.1 * t) * (std::cos(w * t) + 0.1 / w * std::sin(w * t));
  const double v = -std::exp(-0.1 * t) / w * std::sin(w * t);
  for (const Method& method : every_kind(1e-12, 1e-14)) {
    State state = solved(Damped{}, displaced(), t, method);
    // BDF takes many more steps, and their errors add up.
    const double tolerance = std::holds_alternative<Bdf>(method) ? 1e-9 : 1e-10;
    BOOST_TEST(close(Eigen::Vector2d(state.r[0], state.v[0]), Eigen::Vector2d(r, v), {.relative = tolerance}));
  }
}

// r = cos t and y = exp(-t): neither looks at the other on the solution alone.
struct Coupled {
  static bool rates(double t, In r, In v, In y, Out a, Out dy) {
    a[0] = -r[0] + (y[0] - std::exp(-t)) - 0.5 * (v[0] + std::sin(t));
    dy[0] = -y[0] + (r[0] - std::cos(t)) + 0.5 * (v[0] + std::sin(t)) * y[0];
    return true;
  }
};
// r'' = -y r with y as it starts.
struct Carrying {
  static constexpr bool values_by_jumps = true;
  static bool rates(double, In r, In, In y, Out a, Out) {
    a = -y[0] * r;
    return true;
  }
};

BOOST_AUTO_TEST_CASE(motion_and_values_that_act_on_each_other_meet_their_closed_form) {
  const double t = 4.0;
  for (const Method& method : every_kind(1e-12, 1e-14)) {
    const State state = solved(Coupled{}, displaced(Eigen::VectorXd::Ones(1)), t, method);
    const Eigen::Vector3d exact(std::cos(t), -std::sin(t), std::exp(-t));
    BOOST_TEST(close(flat(state), exact, {.absolute = std::holds_alternative<Bdf>(method) ? 1e-9 : 1e-10}));
  }
}

BOOST_AUTO_TEST_CASE(values_that_change_by_jumps_alone_are_carried_along) {
  for (const Method& method : every_kind(1e-12, 1e-14)) {
    const State state = solved(Carrying{}, displaced(Eigen::Vector2d(4.0, -1e300)), 1.0, method);
    BOOST_TEST(close(state.y, Eigen::Vector2d(4.0, -1e300), {}));
    BOOST_TEST(state.r[0] == std::cos(2.0), tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(one_scene_object_serves_sundials_and_our_schemes) {
  using namespace particulate;
  kinematics::Particles pair{.position = kinematics::Vectors::Zero(2, 3),
                             .velocity = kinematics::Vectors::Zero(2, 3),
                             .mass = Eigen::VectorXd::Ones(2),
                             .radius = Eigen::VectorXd::Zero(2)};
  pair.position(0, 0) = -0.5;
  pair.position(1, 0) = 0.5;
  const laws::NearField law{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0};
  const scenes::Scene scene(pair, kinematics::Space{}, law);
  const kinematics::Breathing exact(kinematics::breathing_pair(1.0, 0.5, 1.0, 1.0), 1.0);
  const double t_end = 0.7 * exact.period();
  const auto radial = [](const State& at) { return Eigen::Vector2d(at.r[1] - at.r[0], at.v[1] - at.v[0]); };
  const Eigen::Vector2d expected(exact.at(t_end).r, exact.at(t_end).v);

  for (const Method& method : every_kind(1e-12, 1e-12)) {
    State state = scenes::start(scene);
    const Outcome out = integrate(scene, state, t_end, method);
    BOOST_TEST((out.status == Status::reached));
    BOOST_TEST(close(radial(state), expected, {.relative = 1e-9}));
  }
  State state = scenes::start(scene);
  schemes::RungeKutta4 ruler;
  schemes::FixedStep control{.step = t_end / 2000};
  BOOST_TEST((schemes::integrate(scene, state, t_end, ruler, control).status == Status::reached));
  BOOST_TEST(close(radial(state), expected, {.relative = 1e-9}));
}

// Least squares over six refinements by 1.25, where the errors lie between 1e3 roundings and 1e-2.
BOOST_AUTO_TEST_CASE(every_table_shows_its_order_at_fixed_steps_from_both_sides) {
  for (const Table table : tables) {
    const double coarsest = order(table) >= 8 ? 13.0 : order(table) == 6 ? 75.0 : order(table) == 5 ? 146.0 : 230.0;
    Eigen::VectorXd log_steps(6), log_error(6);
    for (Eigen::Index k = 0; k < 6; ++k) {
      const long n = std::lround(coarsest * std::pow(1.25, static_cast<double>(k)));
      Kepler problem;
      State state = orbit(0.0);
      const Outcome out = integrate(problem, state, 3.0,
                                    ExplicitRungeKutta{.table = table, .fixed_step = 3.0 / static_cast<double>(n)});
      BOOST_TEST((out.status == Status::reached));
      BOOST_TEST(out.steps == n);
      BOOST_TEST(error(state) > 3e-13);
      BOOST_TEST(error(state) < 1e-2);
      log_steps[k] = std::log(static_cast<double>(n));
      log_error[k] = std::log(error(state));
    }
    const Eigen::VectorXd x = log_steps.array() - log_steps.mean();
    const double slope = -x.dot(log_error) / x.squaredNorm();
    BOOST_TEST_CONTEXT(name(table)) { BOOST_TEST(std::abs(slope - order(table)) <= 0.2, "order " << slope); }
  }
}

BOOST_AUTO_TEST_CASE(tighter_tolerances_give_smaller_errors) {
  for (std::size_t kind = 0; kind < every_kind(1e-6, 1e-6).size(); ++kind) {
    std::vector<double> errors;
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
      const State state = solved(Kepler{}, orbit(0.0), 3.0, every_kind(tolerance, tolerance)[kind]);
      errors.push_back(error(state));
    }
    BOOST_TEST_CONTEXT("method " << kind) {
      for (std::size_t k = 1; k < errors.size(); ++k) BOOST_TEST(errors[k] < 0.3 * errors[k - 1]);
      BOOST_TEST(errors.back() < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_setting_reaches_sundials) {
  const auto steps_with = [](const Method& method) {
    auto problem = swinging();
    State state = one(1.0);
    const Outcome out = integrate(problem, state, 4.0, method);
    BOOST_TEST((out.status == Status::reached));
    return out.steps;
  };
  const long adams = steps_with(Adams{.relative = 1e-6, .absolute = 1e-6});
  BOOST_TEST(steps_with(Adams{.relative = 1e-6, .absolute = 1e-6, .max_order = 1}) > 10 * adams);
  BOOST_TEST(steps_with(Adams{.relative = 1e-6, .absolute = 1e-6, .largest_step = 0.004}) >= 1000);
  BOOST_TEST(steps_with(Adams{.relative = 1e-6, .absolute = 1e-12, .first_step = 1e-9}) > adams);
  BOOST_TEST(steps_with(Adams{.relative = 1e-6, .absolute = 1e3}) < adams);
  const long tabled = steps_with(ExplicitRungeKutta{.relative = 1e-6, .absolute = 1e-6});
  BOOST_TEST(steps_with(ExplicitRungeKutta{.relative = 1e-6, .absolute = 1e-6, .largest_step = 0.004}) >= 1000);
  BOOST_TEST(steps_with(ExplicitRungeKutta{.relative = 1e-6, .absolute = 1e-6, .first_step = 1e-12}) > tabled);
  BOOST_TEST(steps_with(ExplicitRungeKutta{.relative = 1e-6, .absolute = 1e3}) < tabled);
  BOOST_TEST(steps_with(ExplicitRungeKutta{.fixed_step = 0.004}) == 1000);

  Kepler problem;
  State plain = orbit(0.0), mixed = orbit(0.0);
  BOOST_TEST((integrate(problem, plain, 3.0, Adams{.relative = 1e-6}).status == Status::reached));
  BOOST_TEST((integrate(problem, mixed, 3.0, Adams{.relative = 1e-6, .anderson = 2}).status == Status::reached));
  BOOST_TEST(!(plain.r == mixed.r));
  BOOST_TEST(error(mixed) < 1e-4);
}

BOOST_AUTO_TEST_CASE(nothing_to_solve_takes_no_step) {
  struct Nothing {
    static bool rate(double, In, Out) { return true; }
  } nothing;
  struct Nobody {
    static bool acceleration(double, In, Out) { return true; }
  } nobody;
  for (const Method& method : every_kind(1e-6, 1e-6)) {
    State values{.t = 1.0, .y = Eigen::VectorXd(0)};
    State motion{.t = 1.0, .r = Eigen::VectorXd(0), .v = Eigen::VectorXd(0)};
    const Outcome first = integrate(nothing, values, 3.0, method), second = integrate(nobody, motion, 3.0, method);
    BOOST_TEST((first.status == Status::reached && second.status == Status::reached));
    BOOST_TEST((values.t == 3.0 && motion.t == 3.0 && first.t == 3.0 && second.t == 3.0));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(advance)

BOOST_AUTO_TEST_CASE(lands_on_every_end_and_asks_for_nothing_beyond_it) {
  for (const Method& method : every_kind(1e-8, 1e-8)) {
    auto problem = swinging();
    State state = one(1.0);
    Integrator integrator(problem, state, method);
    for (const double t_end : {0.1, 0.1 + 0.2, 1.0, pi, 1e3 / 3.0}) {
      const Outcome out = integrator.advance(state, t_end);
      BOOST_TEST((out.status == Status::reached));
      BOOST_TEST(out.t == t_end, tolerance(0.0));
      BOOST_TEST(state.t == t_end, tolerance(0.0));
      BOOST_TEST(problem.latest <= t_end * (1.0 + 1e-15));
      BOOST_TEST(state.y[0] == std::exp(std::sin(t_end)), tolerance(1e-4));
    }
    const State there = state;
    const Outcome none = integrator.advance(state, state.t);
    BOOST_TEST((none.status == Status::reached && none.steps == 0 && none.evaluations == 0));
    BOOST_TEST(equal(state, there));
  }
}

BOOST_AUTO_TEST_CASE(two_legs_agree_with_one_to_the_tolerances) {
  for (const Method& method : every_kind(1e-10, 1e-10)) {
    Kepler problem;
    State whole = orbit(0.0), legs = orbit(0.0);
    BOOST_TEST((integrate(problem, whole, 3.0, method).status == Status::reached));
    Integrator integrator(problem, legs, method);
    for (const double t_end : {1.1, 3.0}) BOOST_TEST((integrator.advance(legs, t_end).status == Status::reached));
    BOOST_TEST(close(legs.r, whole.r, {.absolute = 1e-7}));
    BOOST_TEST(error(legs) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(fixed_steps_in_legs_are_those_of_one_leg_to_the_bit) {
  Kepler problem;
  const ExplicitRungeKutta method{.fixed_step = 1.0 / 64};
  State whole = orbit(0.0), legs = orbit(0.0);
  const Outcome once = integrate(problem, whole, 3.0, method);
  Integrator integrator(problem, legs, method);
  const long steps = integrator.advance(legs, 1.25).steps + integrator.advance(legs, 3.0).steps;
  BOOST_TEST(once.steps == 192);
  BOOST_TEST(steps == 192);
  BOOST_TEST((legs.r == whole.r && legs.v == whole.v));
}

BOOST_AUTO_TEST_CASE(a_step_cut_by_an_end_does_not_change_the_fixed_step) {
  Kepler problem;
  State state = orbit(0.0);
  Integrator integrator(problem, state, ExplicitRungeKutta{.fixed_step = 0.25});
  BOOST_TEST(integrator.advance(state, 0.6).steps == 3);
  BOOST_TEST(integrator.advance(state, 1.6).steps == 4);
}

// SUNDIALS counts from its last start.
BOOST_AUTO_TEST_CASE(goes_on_with_its_history_from_the_state_it_left) {
  for (const Method& method : every_kind(1e-10, 1e-10)) {
    Kepler problem;
    State state = orbit(0.0);
    Integrator integrator(problem, state, method);
    const Outcome first = integrator.advance(state, 1.5), second = integrator.advance(state, 3.0);
    BOOST_TEST((first.evaluations > 0 && second.evaluations > 0));
    BOOST_TEST(integrator.evaluations_by_sundials() == first.evaluations + second.evaluations);
  }
}

BOOST_AUTO_TEST_CASE(starts_afresh_from_a_state_that_was_changed) {
  for (const Method& method : every_kind(1e-10, 1e-10)) {
    Kepler problem;
    State state = orbit(0.0);
    Integrator integrator(problem, state, method);
    BOOST_TEST((integrator.advance(state, 1.5).status == Status::reached));
    state.v *= -1.0;
    State copy = state;
    const Outcome bounced = integrator.advance(state, 3.0), afresh = integrate(problem, copy, 3.0, method);
    BOOST_TEST(bounced.evaluations == afresh.evaluations);
    BOOST_TEST(integrator.evaluations_by_sundials() == bounced.evaluations);
    BOOST_TEST(bounced.steps == afresh.steps);
    BOOST_TEST((state.r == copy.r && state.v == copy.v));
    // Back where it came from: the orbit at -t with its velocity reversed.
    BOOST_TEST(close(state.r, orbit(0.0).r, {.absolute = 1e-7}));
  }
}

// The problem of first order that y = (r, v) obeys, written by hand.
BOOST_AUTO_TEST_CASE(takes_positions_and_velocities_as_one_vector) {
  struct FirstOrderKepler {
    static bool rate(double t, In y, Out dy) {
      dy.head(2) = y.tail(2);
      return Kepler::acceleration(t, y.head(2), dy.tail(2));
    }
  } form;
  Kepler problem;
  State motion = orbit(0.0);
  State values{.t = 0.0, .y = flat(motion)};
  BOOST_TEST((integrate(problem, motion, 3.0, Adams{}).status == Status::reached));
  BOOST_TEST((integrate(form, values, 3.0, Adams{}).status == Status::reached));
  BOOST_TEST(close(values.y, flat(motion), {}));
}

BOOST_AUTO_TEST_CASE(counts_what_the_problem_and_sundials_count) {
  for (const Method& method : every_kind(1e-8, 1e-8)) {
    auto problem = swinging();
    State state = one(1.0);
    Integrator integrator(problem, state, method);
    const Outcome first = integrator.advance(state, 2.0), second = integrator.advance(state, 5.0);
    BOOST_TEST(first.evaluations + second.evaluations == problem.evaluations);
    BOOST_TEST(first.evaluations + second.evaluations == integrator.evaluations_by_sundials());
    BOOST_TEST((first.steps > 0 && second.steps > 0));
    const bool iterates = !std::holds_alternative<ExplicitRungeKutta>(method);
    BOOST_TEST(
        (iterates ? first.sweeps >= first.steps && second.sweeps >= second.steps : first.sweeps + second.sweeps == 0));
  }
}

// Nothing is spent on dense output, a slope at the end of every step that nobody asks for. Whether the start costs one
// more is up to SUNDIALS.
BOOST_AUTO_TEST_CASE(a_table_costs_its_stages_a_step) {
  auto problem = swinging();
  State state = one(1.0);
  Integrator integrator(problem, state, ExplicitRungeKutta{.table = Table::zonneveld_5_3_4, .fixed_step = 0.25});
  const long first = integrator.advance(state, 10.0).evaluations;
  BOOST_TEST(first >= 40 * 5);
  BOOST_TEST(first <= 40 * 5 + 1);
  BOOST_TEST(integrator.advance(state, 20.0).evaluations == 40 * 5);
}

BOOST_AUTO_TEST_CASE(reads_and_writes_the_vectors_of_sundials_in_place) {
  struct Contiguous {
    bool always = true;
    bool acceleration(double, In r, In v, Out a) {
      always = always && r.data() + r.size() == v.data();
      a = -r;
      return true;
    }
  };
  for (const Method& method : every_kind(1e-8, 1e-8)) {
    Contiguous problem;
    State state{.t = 0.0, .r = Eigen::VectorXd::Ones(6), .v = Eigen::VectorXd::Zero(6)};
    BOOST_TEST(integrate(problem, state, 1.0, method).evaluations > 0);
    BOOST_TEST(problem.always);
  }
}

BOOST_AUTO_TEST_CASE(a_moved_integrator_goes_on) {
  auto problem = swinging();
  State stays = one(1.0), moves = one(1.0);
  Integrator kept(problem, stays, Adams{}), from(problem, moves, Adams{});
  BOOST_TEST(
      (kept.advance(stays, 1.0).status == Status::reached && from.advance(moves, 1.0).status == Status::reached));
  Integrator to = std::move(from);
  BOOST_TEST((kept.advance(stays, 2.0).status == Status::reached && to.advance(moves, 2.0).status == Status::reached));
  BOOST_TEST(equal(stays, moves));
}

BOOST_AUTO_TEST_CASE(integrators_in_several_threads_do_not_disturb_each_other) {
  const auto run = [](Method method) {
    Kepler problem;
    State state = orbit(0.0);
    const Outcome out = integrate(problem, state, 30.0, method);
    return std::pair(out.evaluations, Eigen::VectorXd(state.r));
  };
  for (const Method& method : every_kind(1e-10, 1e-10)) {
    auto first = std::async(std::launch::async, run, method), second = std::async(std::launch::async, run, method);
    const auto alone = run(method);
    BOOST_TEST((first.get() == alone && second.get() == alone));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(exceptions)

BOOST_AUTO_TEST_CASE(what_the_problem_throws_comes_out_at_once_and_the_state_stays) {
  struct Mistaken {
    double from;
    long after = 0;
    bool thrown = false;
    bool rate(double t, In y, Out dy) {
      if (thrown) ++after;
      if (t >= from) {
        thrown = true;
        throw std::domain_error("this law knows no time after its own");
      }
      dy = -y;
      return true;
    }
  };
  for (const double from : {0.0, 0.5}) {
    for (const Method& method : every_kind(1e-8, 1e-8)) {
      Mistaken problem{.from = from};
      State state = one(1.0);
      Integrator integrator(problem, state, method);
      BOOST_CHECK_EXCEPTION((void)integrator.advance(state, 1.0), std::domain_error,
                            says("this law knows no time after its own"));
      BOOST_TEST(problem.after == 0);
      BOOST_TEST(equal(state, one(1.0)));

      problem.from = 2.0;
      BOOST_TEST((integrator.advance(state, 1.0).status == Status::reached));
      BOOST_TEST(state.y[0] == std::exp(-1.0), tolerance(1e-6));
    }
  }
}

BOOST_AUTO_TEST_CASE(whatever_its_type) {
  struct Odd {
    static bool rate(double, In, Out) { throw 42; }
  } problem;
  for (const Method& method : every_kind(1e-8, 1e-8)) {
    State state = one(1.0);
    BOOST_CHECK_EXCEPTION((void)integrate(problem, state, 1.0, method), int, [](int thrown) { return thrown == 42; });
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(no_value)

BOOST_AUTO_TEST_CASE(a_step_that_meets_none_is_tried_again_smaller) {
  for (const bool says_so : {true, false}) {
    for (const Method& method : {Method(Adams{.relative = 1e-6, .absolute = 1e-8}),
                                 Method(ExplicitRungeKutta{.relative = 1e-6, .absolute = 1e-8}),
                                 Method(ExplicitRungeKutta{.relative = 1e-4, .absolute = 1e-8, .first_step = 0.9}),
                                 Method(Bdf{.relative = 1e-6, .absolute = 1e-8})}) {
      Draining problem{.says_so = says_so};
      State state = one(1.0);
      Integrator integrator(problem, state, method);
      const Outcome out = integrator.advance(state, 0.9999);
      BOOST_TEST((out.status == Status::reached), out.reason);
      BOOST_TEST(problem.refused > 0);
      BOOST_TEST(out.rejections >= problem.refused);
      BOOST_TEST(out.evaluations == integrator.evaluations_by_sundials());
      BOOST_TEST(std::abs(state.y[0] - 1e-8) < 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(where_no_step_leads_on_the_run_fails_at_the_state_it_reached) {
  for (const Method& method : every_kind(1e-6, 1e-8)) {
    Walled problem;
    State state = one(0.0);
    Integrator integrator(problem, state, method);
    const Outcome out = integrator.advance(state, 2.0);
    BOOST_TEST((out.status == Status::failed));
    BOOST_TEST(contains(out.reason, "the problem had no finite value at t = "));
    BOOST_TEST(contains(out.reason, "stop before this time"));
    BOOST_TEST(out.t == state.t, tolerance(0.0));
    BOOST_TEST(state.t == 1.0, tolerance(1e-6));
    BOOST_TEST(state.y[0] == state.t, tolerance(1e-12));
    BOOST_TEST(out.rejections > 0);

    // The integrator is none the worse for it.
    state = one(0.0);
    BOOST_TEST((integrator.advance(state, 0.5).status == Status::reached));
    BOOST_TEST(state.y[0] == 0.5, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(a_fixed_step_cannot_shrink) {
  Walled problem;
  State state = one(0.0);
  const Outcome out = integrate(problem, state, 2.0, ExplicitRungeKutta{.fixed_step = 0.3});
  BOOST_TEST((out.status == Status::failed));
  BOOST_TEST(out.steps == 3);
  BOOST_TEST(out.t == 0.9, tolerance(1e-14));
  BOOST_TEST(state.t == out.t, tolerance(0.0));
  BOOST_TEST(state.y[0] == 0.9, tolerance(1e-14));
  BOOST_TEST(contains(out.reason, "ARK_UNREC_RHSFUNC_ERR"));
  BOOST_TEST(contains(out.reason, "take smaller steps"));
}

BOOST_AUTO_TEST_CASE(a_start_without_one_fails_there) {
  for (const bool says_so : {true, false}) {
    for (const Method& method : every_kind(1e-6, 1e-8)) {
      Draining problem{.says_so = says_so};
      State state = one(-1.0);
      const Outcome out = integrate(problem, state, 1.0, method);
      BOOST_TEST((out.status == Status::failed));
      BOOST_TEST(out.steps == 0);
      BOOST_TEST(out.evaluations == 1);
      BOOST_TEST(equal(state, one(-1.0)));
      BOOST_TEST(contains(out.reason, "at t = 0 s: "));
      BOOST_TEST(contains(out.reason, "the problem had no finite value at t = 0 s"));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(failures)

// y' = y^2 from 1 is 1/(1 - t): there is no answer at t = 2.
BOOST_AUTO_TEST_CASE(a_solution_that_ends_before_t_end_is_no_answer) {
  for (const Method& method : every_kind(1e-8, 1e-8)) {
    Scalar problem{[](double, double y) { return y * y; }};
    State state = one(1.0);
    const Outcome out = integrate(problem, state, 2.0, method);
    BOOST_TEST((out.status == Status::failed));
    BOOST_TEST(out.t == 1.0, tolerance(1e-3));
    BOOST_TEST(state.t == out.t, tolerance(0.0));
    BOOST_TEST(std::isfinite(state.y[0]));
    BOOST_TEST(contains(out.reason, "too small to change the time"));
  }
}

// From 1e308 the second step of size 1 at 1e308 a second leaves the range of a double.
BOOST_AUTO_TEST_CASE(a_step_to_infinity_is_not_taken) {
  Scalar problem{[](double, double) { return 1e308; }};
  State state = one(0.0);
  const Outcome out =
      integrate(problem, state, 3.0, ExplicitRungeKutta{.table = Table::heun_euler_2_1_2, .fixed_step = 1.0});
  BOOST_TEST((out.status == Status::failed));
  BOOST_TEST(contains(out.reason, "not finite"));
  BOOST_TEST(out.t == 1.0, tolerance(0.0));
  BOOST_TEST(state.y[0] == 1e308, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_run_that_takes_too_many_steps_stops_and_can_go_on) {
  for (const Method& method :
       {Method(Adams{.max_steps = 7}), Method(ExplicitRungeKutta{.max_steps = 7}),
        Method(ExplicitRungeKutta{.fixed_step = 0.0625, .max_steps = 7}), Method(Bdf{.max_steps = 7})}) {
    Kepler problem;
    State state = orbit(0.0), whole = orbit(0.0);
    Integrator integrator(problem, state, method);
    const Outcome cut = integrator.advance(state, 3.0);
    BOOST_TEST((cut.status == Status::failed));
    BOOST_TEST(cut.steps == 7);
    BOOST_TEST(contains(cut.reason, "max_steps = 7 were not enough to get beyond t = "));
    BOOST_TEST((cut.t == state.t && state.t < 3.0));
    BOOST_TEST(error(state) < 1e-6);

    int calls = 0;
    while (integrator.advance(state, 3.0).status == Status::failed && ++calls < 1000) {}
    Method patient = method;
    std::visit([](auto& settings) { settings.max_steps = 100'000; }, patient);
    BOOST_TEST((integrate(problem, whole, 3.0, patient).status == Status::reached));
    BOOST_TEST(calls > 2);
    BOOST_TEST((state.t == 3.0 && state.r == whole.r && state.v == whole.v));
  }
}

BOOST_AUTO_TEST_CASE(more_digits_than_a_double_has_are_refused_with_the_reason) {
  for (const Method& method : every_kind(1e-16, 1e-300)) {
    Scalar problem{[](double, double y) { return -y; }};
    State state = one(1.0);
    const Outcome out = integrate(problem, state, 1.0, method);
    BOOST_TEST((out.status == Status::failed));
    BOOST_TEST(contains(out.reason, "_TOO_MUCH_ACC: the tolerances ask for more digits than a double has"));
    BOOST_TEST(equal(state, one(1.0)));
  }
}

BOOST_AUTO_TEST_CASE(an_end_within_rounding_of_the_start_is_refused) {
  for (const Method& method : every_kind(1e-8, 1e-8)) {
    auto problem = swinging();
    State state = one(1.0, 3.0);
    const Outcome out = integrate(problem, state, std::nextafter(3.0, 4.0), method);
    BOOST_TEST((out.status == Status::failed));
    BOOST_TEST(contains(out.reason, "lies within rounding of the state's time 3 s; choose an end more than"));
  }
}

BOOST_AUTO_TEST_CASE(sundials_prints_nothing) {
  std::fflush(stderr);
  std::FILE* const caught = std::tmpfile();
  BOOST_REQUIRE(caught);
  const int standard_error = dup(2);
  BOOST_REQUIRE(dup2(fileno(caught), 2) == 2);
  for (const Method& method : every_kind(1e-16, 1e-300)) {
    Walled walled;
    Scalar decaying{[](double, double y) { return -y; }};
    Scalar exploding{[](double, double y) { return y * y; }};
    State a = one(0.0), b = one(1.0), c = one(1.0);
    (void)integrate(walled, a, 2.0, every_kind(1e-6, 1e-6)[method.index()]);
    (void)integrate(decaying, b, 1.0, method);
    (void)integrate(exploding, c, 2.0, every_kind(1e-6, 1e-6)[method.index()]);
  }
  struct SplitWalled : Walled {
    static bool rate_slow(double t, In y, Out dy) { return rate(t, y, dy); }
    static bool rate_fast(double, In, Out dy) {
      dy[0] = 0.0;
      return true;
    }
  } split;
  State state = one(0.0);
  (void)integrate(split, state, 2.0, ImplicitExplicit{});
  Eigen::VectorXd x = Eigen::VectorXd::Ones(1);
  const auto diverging = [](In from, Out to) {
    to = 2.0 * from;
    return true;
  };
  (void)solve_fixed_point(diverging, x, {.max_iterations = 3});
  std::fflush(stderr);
  BOOST_REQUIRE(dup2(standard_error, 2) == 2);
  ::close(standard_error);
  BOOST_TEST(lseek(fileno(caught), 0, SEEK_END) == 0);
  std::fclose(caught);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(mistakes)

BOOST_AUTO_TEST_CASE(a_bad_setting_is_refused_where_it_enters) {
  auto problem = swinging();
  State state = one(1.0);
  CHECK_REFUSED(Integrator(problem, state, Adams{.relative = 1e-17}), "got 1e-17");
  CHECK_REFUSED(integrate(problem, state, 1.0, ExplicitRungeKutta{.fixed_step = -1.0}),
                "fixed_step must be positive and finite");
}

BOOST_AUTO_TEST_CASE(a_bad_start_or_end_is_refused) {
  auto problem = swinging();
  Kepler kepler;
  State state = one(1.0, 2.0);
  Integrator integrator(problem, state, Adams{});
  CHECK_REFUSED(Integrator(problem, one(not_a_number), Adams{}), "values must start finite, got nan");
  CHECK_REFUSED(integrator.advance(state, 1.0), "not before the start at 2 s, got 1 s");
  CHECK_REFUSED(integrator.advance(state, not_a_number), "got nan s");
  State uneven = orbit(0.0);
  uneven.v.conservativeResize(1);
  CHECK_REFUSED(Integrator(kepler, uneven, Adams{}), "positions and velocities must have one length, got 2 and 1");
}

BOOST_AUTO_TEST_CASE(a_part_of_the_state_that_the_problem_does_not_have_is_refused) {
  auto problem = swinging();
  Kepler kepler;
  State both = orbit(0.0);
  both.y = Eigen::VectorXd::Ones(1);
  CHECK_REFUSED(Integrator(problem, both, Adams{}), "a rate of values alone, so the state must have no places, got 2");
  CHECK_REFUSED(Integrator(kepler, both, Adams{}), "no rate for values, so the state must have none, got 1");
}

BOOST_AUTO_TEST_CASE(a_state_that_changed_its_length_is_refused) {
  auto problem = swinging();
  Integrator integrator(problem, one(1.0), Adams{});
  State longer{.t = 0.0, .y = Eigen::VectorXd::Ones(2)};
  CHECK_REFUSED(integrator.advance(longer, 1.0),
                "the state must keep the 1 unknowns that the integrator was made for, got 2");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::integrator_test
