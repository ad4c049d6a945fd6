#include <cmath>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::coupled_problem_test {

using namespace particulate::schemes;

// r = cos t and y = 1/(1 + t): every coupling vanishes on the solution alone, so that none is left out unseen.
// r'' = -r + (y - s) r [- (v + sin t)/2] and y' = -y^2 + r - cos t [+ (v + sin t) y/2] with s = 1/(1 + t).
struct Manufactured {
  double by_velocity = 0.5;
  bool rates(double t, In r, In v, In y, Out a, Out dy) const {
    const double off = by_velocity > 0.0 ? by_velocity * (v[0] + std::sin(t)) : 0.0;
    a[0] = -r[0] + (y[0] - 1.0 / (1.0 + t)) * r[0] - off;
    dy[0] = -y[0] * y[0] + r[0] - std::cos(t) + off * y[0];
    return true;
  }
  static State at(double t) {
    return {.t = t,
            .r = Eigen::VectorXd::Constant(1, std::cos(t)),
            .v = Eigen::VectorXd::Constant(1, -std::sin(t)),
            .y = Eigen::VectorXd::Constant(1, 1.0 / (1.0 + t))};
  }
};
// The same with its Jacobian: rows (a, y'), columns (r, v, y).
struct Differentiated : Manufactured {
  mutable long jacobians = 0;
  void jacobian(double t, In r, In v, In y, Eigen::MatrixXd& J) const {
    ++jacobians;
    J << -1.0 + y[0] - 1.0 / (1.0 + t), -by_velocity, r[0],  //
        1.0, by_velocity * y[0], -2.0 * y[0] + by_velocity * (v[0] + std::sin(t));
  }
};
// Without the terms in brackets, and v is not that of the moment.
struct Blind : Manufactured {
  static constexpr bool ignores_velocities = true;
  Blind() : Manufactured{.by_velocity = 0.0} {}
};
// Says nothing of it: it asks for velocities and does not look at them.
struct Unsaid : Manufactured {
  Unsaid() : Manufactured{.by_velocity = 0.0} {}
};

template <class S, class P>
double error_after(S scheme, const P& problem, int steps) {
  const double t_end = 1.7;
  State state = P::at(0.0);
  const Outcome outcome = run(problem, state, t_end, scheme, FixedStep{.step = t_end / steps});
  BOOST_REQUIRE(outcome.reason == "");
  BOOST_REQUIRE(outcome.steps == steps);
  return (flat(state) - flat(P::at(t_end))).norm();
}

template <class S, class P>
void has_order(int order, const S& scheme, const P& problem, const std::vector<int>& steps) {
  const double observed = observed_order([&](int n) { return error_after(scheme, problem, n); }, steps);
  BOOST_TEST(std::abs(observed - order) <= 0.2, "order " << observed << " in place of " << order);
}

const std::vector<int> many{40, 60, 90, 135, 200}, few{10, 14, 20, 28, 40};

template <class P>
void has_every_order(const P& problem) {
  has_order(1, ForwardEuler(), problem, many);
  has_order(4, RungeKutta4(), problem, few);
  has_order(1, PhiFamily<>(1.0), problem, many);
  has_order(2, PhiFamily<>(0.5), problem, many);
  has_order(2, PhiFamily<Anderson>(0.5), problem, many);
  has_order(4, Collocation<Gauss<2>, Sequential>(), problem, few);
  has_order(4, Collocation<Gauss<2>, Picard>(), problem, few);
  has_order(4, Collocation<Gauss<2>, Anderson>(), problem, few);
  has_order(4, Collocation<Gauss<2>, Newton<DenseStages>>(), problem, few);
  has_order(3, Collocation<Radau<2>>(), problem, few);
}

static_assert(Advances<ForwardEuler, Manufactured> && Advances<RungeKutta4, Manufactured> &&
              Advances<PhiFamily<>, Manufactured> && Advances<Collocation<Gauss<2>>, Manufactured>);
static_assert(!Advances<VelocityVerlet, Manufactured> && !Advances<VelocityVerlet, Blind>,
              "Verlet has no rule for values that have rates");

BOOST_AUTO_TEST_SUITE(coupled_problem)

BOOST_AUTO_TEST_CASE(is_solved_at_its_order_by_every_scheme) { has_every_order(Manufactured{}); }

BOOST_AUTO_TEST_CASE(that_ignores_velocities_is_solved_at_its_order_by_every_scheme) { has_every_order(Blind{}); }

BOOST_AUTO_TEST_CASE(with_a_jacobian_of_everything_is_solved_at_its_order) {
  has_order(4, Collocation<Gauss<2>, Newton<>>(), Differentiated{}, few);
}

// The exponent of its contraction is that of forces by position, which saves the velocities of the stages.
BOOST_AUTO_TEST_CASE(that_ignores_velocities_contracts_with_the_square_of_the_step) {
  const Blind blind;
  const Unsaid unsaid;
  const auto exponent = [](const Problem& problem) {
    PhiFamily<> scheme;
    swept(scheme, problem, Manufactured::at(0.0), 0.1, 1);
    return scheme.iterations()[0].p;
  };
  BOOST_TEST(exponent(blind) == 2);
  BOOST_TEST(exponent(unsaid) == 1);
}

// A first step of Newton by its own Jacobian is one by difference quotients, to their error, for four right-hand sides
// fewer: the start, and each of r, v and y.
BOOST_AUTO_TEST_CASE(gives_newton_the_jacobian_that_difference_quotients_make) {
  const Manufactured plain;
  const Differentiated differentiated;
  State from = Manufactured::at(0.0);
  from.y[0] = 2.0, from.v[0] = 1.0;  // off the solution, so that no derivative vanishes
  const auto newton = [&](const Problem& problem, long& evaluations) {
    return flat(swept(Collocation<Gauss<2>, Newton<>>(), problem.counted_by(evaluations), from, 0.5, 1));
  };
  long by_quotients = 0, by_hand = 0;
  const Eigen::VectorXd quotients = newton(plain, by_quotients), hand = newton(differentiated, by_hand);
  BOOST_TEST(close(quotients, hand, {.relative = 1e-7}));
  BOOST_TEST(differentiated.jacobians == 1);
  BOOST_TEST(by_quotients == by_hand + 4);
}

// Sweeps contract by 1e3 each without Newton; the coupling of motion and values is as stiff as either.
BOOST_AUTO_TEST_CASE(that_is_stiff_in_its_coupling_is_solved_by_newton_alone) {
  struct Stiff {
    bool rates(double t, In r, In v, In y, Out a, Out dy) const {
      a[0] = -std::cos(t) - 1e4 * (r[0] - std::cos(t)) - 1e3 * (v[0] + std::sin(t)) + 1e4 * (y[0] - std::cos(t));
      dy[0] = -std::sin(t) - 1e4 * (y[0] - std::cos(t)) - 1e3 * (v[0] + std::sin(t));
      return true;
    }
  } problem;
  const State start = displaced(Eigen::VectorXd::Ones(1));
  State state = start;
  FixedStep control{.step = 0.1, .TOL = 1e-10};
  BOOST_TEST(run(problem, state, 2.0, Collocation<Radau<3>, Newton<>>(), control).reason == "");
  BOOST_TEST(std::abs(state.r[0] - std::cos(2.0)) <= 1e-6);
  BOOST_TEST(std::abs(state.y[0] - std::cos(2.0)) <= 1e-6);
  State other = start;
  BOOST_TEST((run(problem, other, 2.0, Collocation<Radau<3>>(), control).status == Status::failed));
}

BOOST_AUTO_TEST_CASE(has_no_sparse_jacobian_and_says_what_to_do) {
  State state = Manufactured::at(0.0);
  CHECK_REFUSED(run(Manufactured{}, state, 1.0, Collocation<Gauss<2>, Newton<SparseStages>>(), FixedStep{.step = 0.1}),
                "sparse matrices are for problems of motion or of values, got one of both: take "
                "DenseStages, or stagger the two");
}

BOOST_AUTO_TEST_CASE(refuses_a_jacobian_of_another_size) {
  struct Larger : Manufactured {
    void jacobian(double, In, In, In, Eigen::MatrixXd& J) const { J = Eigen::MatrixXd::Zero(3, 3); }
  } problem;
  State state = Manufactured::at(0.0);
  CHECK_REFUSED(run(problem, state, 1.0, Collocation<Gauss<2>, Newton<>>(), FixedStep{.step = 0.1}),
                "jacobian(t, r, v, y, J) must leave its matrix as large as it gets it");
}

// The polynomials of the stages carry the values too: r and y of order 2 and more anywhere in a step.
BOOST_AUTO_TEST_CASE(has_dense_output_of_motion_and_values) {
  const auto error = [](double dt) {
    const State from = Manufactured::at(0.3);
    State there;
    Collocation<Gauss<3>> scheme;
    swept(scheme, Manufactured{}, from, dt, 40);
    scheme.at(from, dt, 0.4, there);
    return (flat(there) - flat(Manufactured::at(0.3 + 0.4 * dt))).norm();
  };
  BOOST_TEST(error(0.1) < 1e-5);
  BOOST_TEST(std::abs(std::log2(error(0.1) / error(0.05)) - 4.0) <= 0.3);
}

BOOST_AUTO_TEST_SUITE_END()

// --- What is not advanced --------------------------------------------------------------------------------------------

// a = -r - v: no rule of Verlet's.
static_assert(!Advances<VelocityVerlet, Damped> && !Advances<VelocityVerlet, Decay>);

BOOST_AUTO_TEST_SUITE(erased_problem)

BOOST_AUTO_TEST_CASE(of_which_a_scheme_leaves_something_behind_is_refused_at_the_start) {
  const auto refuses = [](const Problem& problem, State state) {
    VelocityVerlet scheme;
    const State start = state;
    CHECK_REFUSED(run(problem, state, 1.0, scheme, FixedStep{.step = 0.1}),
                  "the scheme must be able to advance all that the problem has");
    BOOST_TEST(state.t == 0.0);
    BOOST_TEST(close(flat(state), flat(start), {}));
  };
  const Damped damped;
  const Decay decay;
  const Manufactured both;
  const Blind blind;
  refuses(damped, displaced());
  refuses(decay, one());
  refuses(both, Manufactured::at(0.0));
  refuses(blind, Manufactured::at(0.0));
}

BOOST_AUTO_TEST_CASE(is_solved_to_the_same_bits_as_with_its_type) {
  const Manufactured problem;
  State typed = Manufactured::at(0.0), erased = typed;
  const Outcome first = run(problem, typed, 1.0, Collocation<Gauss<3>>(), FixedStep{.step = 0.125});
  const Outcome second = run(Problem(problem), erased, 1.0, Collocation<Gauss<3>>(), FixedStep{.step = 0.125});
  BOOST_TEST(first.evaluations == second.evaluations);
  BOOST_TEST(close(flat(typed), flat(erased), {}));
}

BOOST_AUTO_TEST_SUITE_END()

// --- Values by jumps -------------------------------------------------------------------------------------------------

struct Carrying : Spring {
  static constexpr bool values_by_jumps = true;
};
static_assert(Advances<VelocityVerlet, Carrying>);

State carried() {
  return {.r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Constant(1, 0.5), .y = Eigen::Vector2d(0.1, -1e300)};
}

// The motion is that of the problem without values, to the bit, and y stays.
template <class S>
void carries(const S& made) {
  State plain = carried(), state = carried();
  plain.y.resize(0);
  const Outcome without = run(Spring{}, plain, 1.0, S(made), FixedStep{.step = 0.125});
  const Outcome with = run(Carrying{}, state, 1.0, S(made), FixedStep{.step = 0.125});
  BOOST_TEST(with.reason == "");
  BOOST_TEST(with.evaluations == without.evaluations);
  plain.y = carried().y;
  BOOST_TEST(close(flat(state), flat(plain), {}));
}

// A spring as stiff as y says, which the end of every step makes stiffer by one. It reports no impact.
struct Stiffening {
  static constexpr bool values_by_jumps = true, ignores_velocities = true;
  bool rates(double, In r, In, In y, Out a, Out) const {
    a = -y[0] * r;
    return true;
  }
  Jump jump(State& at, double) const {
    at.y[0] += 1.0;
    return {};
  }
};

// Four steps of springs of stiffness 1 to 4, each with a scheme that knows of none before.
template <class S>
void sees_what_has_jumped(const S& made) {
  State state = displaced(Eigen::VectorXd::Ones(1)), by_hand = state;
  by_hand.y.resize(0);
  FixedStep control{.step = 0.25};
  BOOST_TEST(run(Stiffening{}, state, 1.0, S(made), control).steps == 4);
  BOOST_TEST(state.y[0] == 5.0);
  for (int k = 1; k <= 4; ++k) {
    BOOST_TEST(run(Spring{static_cast<double>(k)}, by_hand, 0.25 * k, S(made), control).steps == 1);
  }
  state.y.resize(0);
  BOOST_TEST(close(flat(state), flat(by_hand), {.relative = 1e-14}));
}

BOOST_AUTO_TEST_SUITE(values_by_jumps_)

BOOST_AUTO_TEST_CASE(are_carried_along_unchanged_by_every_scheme) {
  carries(ForwardEuler());
  carries(RungeKutta4());
  carries(VelocityVerlet());
  carries(PhiFamily<>(1.0));
  carries(PhiFamily<>(0.5));
  carries(PhiFamily<Anderson>(0.5));
  carries(Collocation<Gauss<3>>());
  carries(Collocation<Gauss<3>, Picard>());
  carries(Collocation<Gauss<3>, Anderson>());
  carries(Collocation<Gauss<3>, Newton<>>());
  carries(Collocation<Radau<3>>({.compensated = false}));
}

BOOST_AUTO_TEST_CASE(are_carried_along_by_dense_output) {
  const State from = carried();
  State there;
  Collocation<Gauss<3>> scheme;
  swept(scheme, Carrying{}, from, 0.5, 40);
  for (const double theta : {0.0, 0.3, 1.0}) {
    scheme.at(from, 0.5, theta, there);
    BOOST_TEST(close(there.y, from.y, {}));
  }
}

BOOST_AUTO_TEST_CASE(are_those_after_the_last_jump_where_forces_look_at_them) {
  sees_what_has_jumped(ForwardEuler());
  sees_what_has_jumped(RungeKutta4());
  sees_what_has_jumped(VelocityVerlet());
  sees_what_has_jumped(PhiFamily<>(0.5));
  sees_what_has_jumped(Collocation<Gauss<3>>());
}

BOOST_AUTO_TEST_CASE(must_be_announced_and_places_must_have_forces) {
  State both = carried();
  CHECK_REFUSED(run(Spring{}, both, 1.0, RungeKutta4(), FixedStep{.step = 0.1}),
                "the problem has no rate for values, so the state must have none, got 2: give it rates(t, "
                "r, v, y, a, dy), or the constant values_by_jumps if they change by jumps alone");
  CHECK_REFUSED(run(Decay{}, both, 1.0, RungeKutta4(), FixedStep{.step = 0.1}),
                "a rate of values alone, so the state must have no places, got 1: they go into y");
}

BOOST_AUTO_TEST_SUITE_END()

// --- Parts, each in its own measure ----------------------------------------------------------------------------------

// Two decaying values that do not know of each other, and a body that looks at neither: each part contracts as if it
// were alone, by Dt times its rate, the body by Dt^2.
struct Apart {
  static constexpr bool ignores_velocities = true;
  Eigen::Vector2d decay{1.0, 4.0};
  double charge_TOL = 1.0;
  bool rates(double, In r, In, In y, Out a, Out dy) const {
    a = -r;
    dy = -decay.cwiseProduct(y);
    return true;
  }
  std::vector<Range> ranges() const {
    return {{.name = "heat", .first = 0, .size = 1}, {.name = "charge", .first = 1, .size = 1, .TOL = charge_TOL}};
  }
};
State apart() { return displaced(Eigen::Vector2d(1.0, 1e6)); }

// PhiControl, which keeps what it was shown.
struct Watched {
  PhiControl control;
  std::vector<std::vector<Iteration>> fields = {};
  double dt() const { return control.dt(); }
  bool goes_on(const Iteration& it) const { return control.goes_on(it); }
  Decision judge(const Attempt& made) {
    fields.emplace_back(made.fields.begin(), made.fields.end());
    return control.judge(made);
  }
};
void validate(const Watched& watched) { validate(watched.control); }

template <class S>
Watched stepped(S scheme, const Apart& problem, double dt) {
  Watched watched{.control = {.TOL = 1e-6, .K_d = 30, .step = dt, .limit = 10.0, .growth = 100.0}};
  State state = apart();
  BOOST_TEST(integrate(problem, state, dt, scheme, watched).reason == "");
  return watched;
}

BOOST_AUTO_TEST_SUITE(parts_of_a_state)

BOOST_AUTO_TEST_CASE(are_measured_each_by_itself) {
  const Apart problem;
  const State from = apart();
  PhiFamily<> scheme;
  State to = swept(scheme, problem, from, 0.05, 1);
  const Iteration worst = scheme.sweep(problem, from, 0.05, to);
  BOOST_TEST(worst.field == "charge");
  BOOST_TEST_REQUIRE(scheme.iterations().size() == 3U);
  const std::vector<Iteration> of(scheme.iterations().begin(), scheme.iterations().end());
  BOOST_TEST((of[0].field == "motion" && of[1].field == "heat" && of[2].field == "charge"));
  BOOST_TEST((of[0].p == 2 && of[1].p == 1 && of[2].p == 1));
  // A large value in other units does not drown the small ones: every first sweep changes all that it displaces.
  for (const Iteration& it : of) BOOST_TEST(std::abs(it.w_0 - 1.0) <= 1e-12);
  BOOST_TEST(std::abs(of[0].w_K - 0.0025) <= 1e-12);
  BOOST_TEST(std::abs(of[1].w_K - 0.05) <= 1e-12);
  BOOST_TEST(std::abs(of[2].w_K - 0.2) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(let_the_one_rule_that_asks_for_the_smallest_step) {
  const auto rules = [](const Apart& problem, const char* name) {
    const Watched watched = stepped(PhiFamily<>(), problem, 0.05);
    BOOST_TEST(watched.control.controlling == name);
    double wish = 100.0;
    for (const Iteration& it : watched.fields[0]) wish = std::min(wish, phi_K(it, 1e-6, 30));
    BOOST_TEST(std::abs(watched.control.step - 0.05 * wish) <= 1e-14);
  };
  rules({}, "charge");
  rules({.decay = {4.0, 1.0}}, "heat");
  rules({.decay = {1e-3, 1e-3}}, "motion");
}

BOOST_AUTO_TEST_CASE(go_on_until_the_worst_has_met_its_own_tolerance) {
  const Watched loose = stepped(PhiFamily<>(), {.charge_TOL = 1e4}, 0.05);
  const Watched tight = stepped(PhiFamily<>(), {.charge_TOL = 1e-4}, 0.05);
  // 0.2^K <= TOL of the charge, 0.05^K <= 1e-6 of the heat: the latter rules where the charge may be inaccurate.
  BOOST_TEST(loose.fields[0][2].K == 5);
  BOOST_TEST(stepped(PhiFamily<>(), {}, 0.05).fields[0][2].K == 9);
  BOOST_TEST(tight.fields[0][2].K == 15);
  // They are given in units of their tolerance.
  BOOST_TEST(std::abs(tight.fields[0][2].w_0 / 1e4 - 1.0) <= 1e-12);
  BOOST_TEST(std::abs(loose.fields[0][2].w_0 / 1e-4 - 1.0) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(are_measured_each_by_itself_by_collocation) {
  const std::vector<Iteration> of = stepped(Collocation<Gauss<2>, Picard>(), Apart{}, 0.05).fields[0];
  BOOST_TEST_REQUIRE(of.size() == 3U);
  BOOST_TEST((of[0].field == "motion" && of[1].field == "heat" && of[2].field == "charge"));
  BOOST_TEST((of[0].p == 2 && of[1].p == 1 && of[2].p == 1));
  // The values contract by their rates' ratio: 4 times as much a sweep.
  BOOST_TEST(of[1].K == of[2].K);
  BOOST_TEST(std::abs(std::pow((of[2].w_K / of[2].w_0) / (of[1].w_K / of[1].w_0), 1.0 / of[1].K) - 4.0) <= 0.1);
}

BOOST_AUTO_TEST_CASE(say_which_of_them_has_not_met_its_tolerance) {
  State state = apart();
  BOOST_TEST(contains(
      run(Apart{.decay = {1.0, 40.0}}, state, 1.0, PhiFamily<>(), FixedStep{.step = 0.05, .contractions = 20}).reason,
      "the sweeps of field charge diverge"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::coupled_problem_test
