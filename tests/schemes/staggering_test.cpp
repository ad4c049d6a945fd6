#include <particulate/schemes/staggering.hpp>

#include <limits>

#include <Eigen/LU>

#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::staggering_test {

using namespace particulate::schemes;

static_assert(Iterative<Staggered> && Measured<Staggered> && Advances<Staggered, FirstOrderPair>);

const FirstOrderPair pair{.a = (Eigen::Matrix2d() << 1.0, 2.0, 4.0, 3.0).finished()};
const State start{.t = 0.0, .y = Eigen::Vector2d(5.0, 2.0)};

std::vector<Field> fields(double TOL = 1e-12) { return {{"one", TOL, 2}, {"two", TOL, 2}}; }

// (1 + Dt a) y = y^L, solved for both fields at once.
Eigen::Vector2d coupled_step(const Eigen::Matrix2d& a, double dt) {
  const Eigen::Matrix2d M = Eigen::Matrix2d::Identity() + dt * a;
  return M.inverse() * start.y;
}

Outcome stepped(Staggered scheme, FirstOrderPair problem, double dt, State& state) {
  state = start;
  return run(problem, state, dt, scheme, FixedStep{.step = dt, .TOL = 1.0, .contractions = 200});
}

// A body that heat brakes, heat that grows with its place, and a charge that doubles each second, each by one step of
// semi-implicit Euler with the others frozen.
struct Carriage {
  std::vector<Part> parts{{.motion = true}, {.first = 0, .size = 1}, {.first = 1, .size = 1}};
  std::size_t fields() const { return parts.size(); }
  Part part(std::size_t k) const { return parts[k]; }
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const {
    if (k == 0) {
      to.v = from.v - dt * seen.y.head(1);
      to.r = from.r + dt * to.v;
    } else {
      to.y[k == 1 ? 0 : 1] = k == 1 ? from.y[0] + dt * seen.r[0] : from.y[1] / (1.0 - dt);
    }
    return true;
  }
  static State start() {
    State state = body(1.0, 2.0);
    state.y = Eigen::Vector2d(5.0, 4.0);
    return state;
  }
};

// Two fields that drive each other, y' = i y; the second has the size of the whole.
struct Wave {
  std::size_t fields() const { return 2; }
  Part part(std::size_t k) const { return {.first = static_cast<Eigen::Index>(k), .size = 1}; }
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const {
    to.y[k == 0 ? 0 : 1] = k == 0 ? from.y[0] - dt * seen.y[1] : from.y[1] + dt * seen.y[0];
    return true;
  }
  double field_size(std::size_t k, const State& at) const { return k == 0 ? 0.0 : at.y.norm(); }
};

// A body of the weight Lambda against the fluid around it, which it relaxes to in a second by backward Euler, and which
// then gets what it lost.
struct Body {
  double Lambda;
  std::size_t fields() const { return 2; }
  Part part(std::size_t k) const { return {.first = static_cast<Eigen::Index>(k), .size = 1}; }
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const {
    if (k == 0) to.y[0] = (from.y[0] + dt * seen.y[1]) / (1.0 + dt);
    if (k == 1) to.y[1] = from.y[1] - Lambda * (seen.y[0] - from.y[0]);
    return true;
  }
};

// The larger of both numbers after so many steps.
template <class P>
double after_steps(const P& fields, Staggered scheme, double dt, int sweeps, int steps) {
  State state{.y = Eigen::Vector2d(1.0, 1.0 - 1e-3)}, to;
  for (int step = 0; step < steps; ++step) {
    scheme.predict(Problem(fields), state, dt, to);
    for (int sweep = 0; sweep < sweeps; ++sweep) scheme.sweep(Problem(fields), state, dt, to);
    state = to;
  }
  return state.y.cwiseAbs().maxCoeff();
}

BOOST_AUTO_TEST_SUITE(Aitken_)

// x = g(x) = 3 - 2 x from 0: f_0 = 3; from 3: f_1 = -6; omega = -3 (-9)/81 = 1/3, and 3 - 6/3 = 1 is the fixed point.
BOOST_AUTO_TEST_CASE(solves_a_linear_map_of_one_unknown) {
  Aitken relaxation;
  BOOST_TEST(relaxation.factor(Eigen::VectorXd::Constant(1, 3.0)) == 1.0);
  BOOST_TEST(relaxation.factor(Eigen::VectorXd::Constant(1, -6.0)) == 1.0 / 3.0, tolerance(1e-15));
  relaxation.forget();
  BOOST_TEST(relaxation.factor(Eigen::VectorXd::Constant(1, -6.0)) == 1.0);
}

BOOST_AUTO_TEST_CASE(keeps_its_factor_where_the_residual_stands_still) {
  Aitken relaxation;
  relaxation.factor(Eigen::Vector2d(1.0, 2.0));
  BOOST_TEST(relaxation.factor(Eigen::Vector2d(1.0, 2.0)) == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Staggered_)

// Dt = 1/2 from (5, 2): Gauss-Seidel w_1 = (5 - 2)/(3/2) = 2, w_2 = (2 - 2 * 2)/(5/2) = -0.8; Jacobi sees w_1 = 5.
BOOST_AUTO_TEST_CASE(solves_each_field_with_the_newest_or_the_previous_values) {
  Staggered newest(fields());
  State to = predicted(newest, pair, start, 0.5);
  BOOST_TEST(close(to.y, start.y, {}));
  BOOST_TEST(to.t == 0.5);
  newest.sweep(pair, start, 0.5, to);
  BOOST_TEST(close(to.y, Eigen::Vector2d(2.0, -0.8), {.relative = 1e-15}));
  to = swept(Staggered(fields(), Seen::previous), pair, start, 0.5, 1);
  BOOST_TEST(close(to.y, Eigen::Vector2d(2.0, -3.2), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(comes_to_the_coupled_step_either_way) {
  for (const Seen seen : {Seen::newest, Seen::previous}) {
    State state;
    BOOST_TEST(stepped(Staggered(fields(), seen), pair, 0.25, state).reason == "");
    BOOST_TEST(close(state.y, coupled_step(pair.a, 0.25), {.relative = 1e-11}));
  }
}

// The first sweep changes w_1 by 3 and w_2 by 2.8; both are displacements too, so w_0 = 1 of each. The second makes
// w_1 = 5.8/1.5, changing it by 5.6/3, and w_2 = (2 - 2 * 5.8/1.5)/2.5.
BOOST_AUTO_TEST_CASE(measures_each_field_in_units_of_its_tolerance_and_returns_the_worst) {
  Staggered scheme({{"one", 1e-2, 2}, {"two", 1e-3, 4}});
  State to = predicted(scheme, pair, start, 0.5);
  const Iteration first = scheme.sweep(pair, start, 0.5, to);
  BOOST_TEST(first.field == "two");
  BOOST_TEST(first.w_0 == 1e3, tolerance(1e-14));
  BOOST_TEST(first.p == 4);
  scheme.sweep(pair, start, 0.5, to);
  BOOST_TEST_REQUIRE(scheme.iterations().size() == 2U);
  BOOST_TEST(scheme.iterations()[0].field == "one");
  BOOST_TEST(scheme.iterations()[0].w_K == 1e2 * 5.6 / 9.0, tolerance(1e-14));
  BOOST_TEST(scheme.iterations()[0].K == 1);
  BOOST_TEST(scheme.iterations()[1].rate == (0.8 * 5.6 / 3.0) / 2.8, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(is_cured_of_divergence_by_relaxation) {
  const FirstOrderPair driven{.a = (Eigen::Matrix2d() << 1.0, 3.0, -3.0, 1.0).finished()};
  State state;
  BOOST_TEST(contains(stepped(Staggered(fields()), driven, 2.0, state).reason, "diverge"));
  const Outcome cured = stepped(Staggered(fields(), Seen::newest, Aitken{}), driven, 2.0, state);
  BOOST_TEST(cured.reason == "");
  BOOST_TEST(cured.sweeps <= 5);
  BOOST_TEST(close(state.y, coupled_step(driven.a, 2.0), {.relative = 1e-12}));
}

BOOST_AUTO_TEST_CASE(brings_nothing_of_one_step_into_the_next) {
  Staggered used(fields(), Seen::newest, Aitken{}), fresh(fields(), Seen::newest, Aitken{});
  const State elsewhere{.t = 0.0, .y = Eigen::Vector2d(-7.0, 3.0)};
  swept(used, pair, elsewhere, 0.25, 2);
  State to = predicted(used, pair, start, 0.5), again = predicted(fresh, pair, start, 0.5);
  for (int k = 0; k < 3; ++k) {
    used.sweep(pair, start, 0.5, to);
    fresh.sweep(pair, start, 0.5, again);
    BOOST_TEST(close(to.y, again.y, {}));
  }
}

// One sweep is leapfrog: trace 2 - z^2, determinant 1. Of more, and of those that converge, z^2 is the contraction.
// With the last sweep's values one sweep is forward Euler.
BOOST_AUTO_TEST_CASE(spans_of_a_wave_what_its_sweeps_allow_and_no_more) {
  const Staggered newest(fields()), previous(fields(), Seen::previous);
  using Kind = TimeScale::Kind;
  BOOST_TEST((newest.spans(Kind::waves, 1) == 2.0 && newest.spans(Kind::waves, 2) == 1.0));
  BOOST_TEST((newest.spans(Kind::waves, 0) == 1.0 && newest.spans(Kind::decays, 0) == 1.0));
  BOOST_TEST((previous.spans(Kind::waves, 1) == 0.0 && previous.spans(Kind::waves, 2) == 1.0));
  BOOST_TEST((newest.spans(Kind::drifts, 1) == 1.0 && newest.spans(Kind::drifts, 2) == infinity));
  BOOST_TEST(after_steps(Wave{}, newest, 2.0 - 1e-3, 1, 3000) < 100.0);
  BOOST_TEST(after_steps(Wave{}, newest, 2.0 + 1e-3, 1, 3000) > 1e6);
  BOOST_TEST(after_steps(Wave{}, newest, 1.0 - 1e-3, 2, 3000) < 1.0);
  BOOST_TEST(after_steps(Wave{}, newest, 1.0 + 1e-3, 2, 3000) > 100.0);
  BOOST_TEST(after_steps(Wave{}, previous, 0.1, 1, 3000) > 1e5);
}

// The slip of a Body is multiplied by 1 - (1 + Lambda) a/(1 + a) in a step of one sweep, with a = Dt over a second;
// more sweeps contract by Lambda a/(1 + a). So a may be 2 and 1 over Lambda - 1, and a lighter body bears any step.
BOOST_AUTO_TEST_CASE(spans_of_a_load_what_its_sweeps_allow_and_of_what_relaxes_anything) {
  const Staggered newest(fields());
  using Kind = TimeScale::Kind;
  const Body heavy{4.0}, light{0.9};
  for (const int sweeps : {1, 2}) {
    BOOST_TEST(newest.spans(Kind::relaxes, sweeps) == infinity);
    const double limit = newest.spans(Kind::loads, sweeps) / 3.0;
    BOOST_TEST(after_steps(heavy, newest, (1.0 - 1e-3) * limit, sweeps, 10000) < 1.5);
    BOOST_TEST(after_steps(heavy, newest, (1.0 + 1e-3) * limit, sweeps, 30000) > 1e3);
    BOOST_TEST(after_steps(light, newest, 1e6, sweeps, 3000) < 1.5);
  }
  BOOST_TEST((newest.spans(Kind::relaxes, 0) == infinity && newest.spans(Kind::loads, 0) == 1.0));
}

// One rounding of the whole, over the displacement of the first sweep: eps (1 + 0.1)/0.1 in units of 1e-6.
BOOST_AUTO_TEST_CASE(measures_rounding_by_the_size_that_a_field_is_given) {
  const Wave wave;
  const State from{.y = Eigen::Vector2d(1.0, 0.0)};
  Staggered scheme(fields(1e-6));
  State to;
  scheme.predict(Problem(wave), from, 0.1, to);
  scheme.sweep(Problem(wave), from, 0.1, to);
  BOOST_TEST(scheme.iterations()[1].rounding == 1.1 / 0.1 * std::numeric_limits<double>::epsilon() * 1e6,
             tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(says_that_a_field_has_no_value) {
  const FirstOrderPair growing{.a = (Eigen::Matrix2d() << 0.0, 1.0, 1.0, -2.0).finished()};
  Staggered scheme(fields());
  State to = predicted(scheme, growing, start, 0.5);
  const Iteration it = scheme.sweep(growing, start, 0.5, to);
  BOOST_TEST(!it.evaluated);
  BOOST_TEST(it.field == "two");
}

BOOST_AUTO_TEST_CASE(counts_every_field_that_is_solved) {
  State state;
  const Outcome outcome = stepped(Staggered(fields()), pair, 0.25, state);
  BOOST_TEST(outcome.sweeps > 2);
  BOOST_TEST(outcome.evaluations == 2 * outcome.sweeps);
}

// r = (w_1 + Dt w_1' - Dt^2 c w_2), and likewise: a 2 x 2 system, solved here by elimination.
BOOST_AUTO_TEST_CASE(solves_fields_of_second_order) {
  State state{.t = 0.0, .y = Eigen::Vector4d(1.0, 3.0, -2.0, 5.0)};
  Staggered scheme({{"one", 1e-14, 4}, {"two", 1e-14, 4}});
  BOOST_TEST(
      run(SecondOrderPair{.c12 = 2.0, .c21 = 4.0}, state, 0.25, scheme, FixedStep{.step = 0.25, .TOL = 1.0}).reason ==
      "");
  const double free_1 = 1.75, free_2 = -0.75, h12 = 0.125, h21 = 0.25;
  const double w_1 = (free_1 - h12 * free_2) / (1.0 - h12 * h21), w_2 = free_2 - h21 * w_1;
  BOOST_TEST(close(state.y, Eigen::Vector4d(w_1, (w_1 - 1.0) / 0.25, w_2, (w_2 + 2.0) / 0.25), {.relative = 1e-13}));
}

// By hand, Dt = 1/2, motion first, from r = 1, v = 2, y = (5, 4) with everything seen as it was: v = 2 - 5/2,
// r = 1 - 1/4; then y_0 = 5 + (1/2) (3/4), with the new place; y_1 = 8, without either.
BOOST_AUTO_TEST_CASE(solves_the_motion_as_one_field_and_ranges_of_values_as_others) {
  const Carriage problem;
  Staggered scheme({{"motion", 1e-6, 2}, {"heat", 1e-6, 1}, {"charge", 1e-6, 1}});
  State to = predicted(scheme, problem, Carriage::start(), 0.5);
  const Iteration first = scheme.sweep(problem, Carriage::start(), 0.5, to);
  BOOST_TEST(first.evaluated);
  BOOST_TEST(close(flat(to), Eigen::Vector4d(0.75, -0.5, 5.375, 8.0), {}));
  // Motion is measured by its places: it moved by 1/4, and that it changed by.
  BOOST_TEST(scheme.iterations()[0].field == "motion");
  BOOST_TEST(scheme.iterations()[0].change == 0.25);
  scheme.sweep(problem, Carriage::start(), 0.5, to);
  BOOST_TEST(scheme.iterations()[0].change == 0.09375);  // 5.375/2 more of a speed, half of it a place, than 5/2
  BOOST_TEST(scheme.iterations()[2].change == 0.0);
}

// v = 2 - y_0/2, r = 1 + v/2, y_0 = 5 + r/2: r = (2 - 5/4)/(1 + 1/8) = 2/3.
BOOST_AUTO_TEST_CASE(comes_to_the_coupled_step_of_motion_and_values) {
  const Carriage problem;
  for (const bool relaxed : {false, true}) {
    Staggered scheme({{"motion", 1e-13, 2}, {"heat", 1e-13, 1}, {"charge", 1e-13, 1}}, Seen::newest,
                     relaxed ? std::optional(Aitken{}) : std::nullopt);
    State state = Carriage::start();
    BOOST_TEST(run(problem, state, 0.5, scheme, FixedStep{.step = 0.5, .TOL = 1.0}).reason == "");
    BOOST_TEST(close(flat(state), Eigen::Vector4d(2.0 / 3.0, -2.0 / 3.0, 16.0 / 3.0, 8.0), {.relative = 1e-12}));
  }
}

BOOST_AUTO_TEST_CASE(refuses_fields_that_do_not_own_all_of_the_state_each_once) {
  const auto refuses = [](std::vector<Part> given, const char* words) {
    Carriage problem;
    problem.parts = std::move(given);
    Staggered scheme({{"motion", 1e-6, 2}, {"heat", 1e-6, 1}, {"charge", 1e-6, 1}});
    State to;
    CHECK_REFUSED(scheme.predict(problem, Carriage::start(), 0.5, to), words);
  };
  const Part motion{.motion = true}, heat{.first = 0, .size = 1}, charge{.first = 1, .size = 1}, none{};
  refuses({motion, heat, none}, "fields must own all of the state, 1 places and 2 values, each once; they own 1 and 1");
  refuses({none, heat, charge}, "they own 0 and 2");
  refuses({motion, motion, {.first = 0, .size = 2}}, "they own 2 and 2");
  refuses({motion, heat, {.first = 0, .size = 2}}, "each number once; field charge owns value 0, which another owns");
  refuses({motion, heat, {.first = 2, .size = 1}},
          "field charge must own a range of the 2 values of the state, got 1 from 2 on");
  refuses({motion, {.first = -1, .size = 1}, charge}, "field heat must own a range of the 2 values");
  refuses({motion, heat, heat}, "each number once; field charge owns value 0, which another owns");
}

BOOST_AUTO_TEST_CASE(refuses_settings_that_cannot_be_meant) {
  const auto refuses = [](std::vector<Field> given, const char* words) {
    CHECK_REFUSED(Staggered(std::move(given)), words);
  };
  refuses({}, "there must be at least one field, got none");
  refuses({{"heat", 0.0, 1}}, "staggering: field heat: TOL must be finite and at least");
  refuses({{"heat", 1e-6, 0}}, "field heat: p must be at least 1, got 0");
  CHECK_REFUSED(Staggered(fields(), Seen::previous, Aitken{}), "relaxation needs Seen::newest");
  Staggered one({{"one", 1e-6, 1}});
  State to;
  CHECK_REFUSED(one.predict(pair, start, 0.5, to), "settings for each of the problem's 2 fields, got 1");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::staggering_test
