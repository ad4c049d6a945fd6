#include <particulate/schemes/problem.hpp>

#include <optional>
#include <vector>

#include <Eigen/SparseCore>

#include "close.hpp"
#include "problems.hpp"

namespace tests::problem_test {

using namespace particulate::schemes;

// Everything a first-order problem can offer; every answer is another number. No value before t = 0.
struct EveryFirstOrderAbility {
  bool rate(double t, In y, Out dy) {
    dy = t * y;
    return t >= 0.0;
  }
  bool rate_slow(double t, In y, Out dy) {
    dy = 2.0 * t * y;
    return t >= 0.0;
  }
  bool rate_fast(double t, In y, Out dy) {
    dy = 3.0 * t * y;
    return t >= 0.0;
  }
  void jacobian(double t, In y, Eigen::MatrixXd& J) { J = t * y.asDiagonal().toDenseMatrix(); }
  void sparse_jacobian(double t, In y, SparseJacobian& J) {
    J.resize(y.size(), y.size());
    J.insert(0, 1) = t * y[1];
  }
  Bandwidth bandwidth() const { return {.lower = 4, .upper = 7}; }
  double distance(In x, In y) const { return 10.0 * (x - y).norm(); }
};

// Everything a problem of forces by position can offer.
struct EverySecondOrderAbility {
  bool acceleration(double t, In r, Out a) {
    a = -t * r;
    return t >= 0.0;
  }
  void jacobian(double t, In r, Eigen::MatrixXd& K) { K = -t * r.asDiagonal().toDenseMatrix(); }
  void sparse_jacobian(double t, In r, SparseJacobian& K) {
    K.resize(r.size(), r.size());
    K.insert(1, 0) = t * r[0];
  }
  double distance(In x, In y) const { return 20.0 * (x - y).norm(); }
  Jump jump(State& at, double dt) {
    at.v = -at.v;
    return {.impacts = 3, .energy_change = -dt, .unsettled = "not yet"};
  }
  std::optional<double> first_jump(const StepPath& path, double end) { return path.dt * end; }
  std::vector<TimeScale> step_limits(const State& at) {
    return {{.name = "spring", .seconds = 0.5}, {.name = "heat", .kind = TimeScale::Kind::decays, .seconds = at.t}};
  }
};

// a = -r - v.
struct Damped {
  bool acceleration(double t, In r, In v, Out a) {
    a = -r - v;
    return t >= 0.0;
  }
  void jacobian(double t, In r, In v, In, Eigen::MatrixXd& J) { J << t, r[0], v[1]; }
};

// Everything at once, of all that there is: a = (t + 10 r + 100 v) y_0, y' = (r_0, v_0).
struct Coupled {
  bool rates(double t, In r, In v, In y, Out a, Out dy) {
    a = (t + 10.0 * r.array() + 100.0 * v.array()) * y[0];
    dy << r[0], v[0];
    return t >= 0.0;
  }
  std::vector<Range> ranges() const { return given; }
  std::vector<Range> given{{.name = "heat", .first = 0, .size = 1}, {.name = "charge", .first = 1, .size = 1}};
};
struct Blind : Coupled {
  static constexpr bool ignores_velocities = true;
};
struct Remembering : Coupled {
  static constexpr bool values_by_jumps = true;
};
// y counts what has jumped; positions alone decide the rest.
struct Counting : EverySecondOrderAbility {
  static constexpr bool values_by_jumps = true;
};
// Sees how many rates it is given to write.
struct Carrying {
  static constexpr bool values_by_jumps = true;
  Eigen::Index written = -1;
  bool rates(double, In r, In, In, Out a, Out dy) {
    a = r;
    written = dy.size();
    return true;
  }
};
struct Undecided : Coupled {
  static constexpr bool ignores_velocities = false, values_by_jumps = false;
};

// A right-hand side that forgets to say whether it has a value is none.
struct Silent {
  void rate(double, In, Out) {}
  void acceleration(double, In, Out) {}
  void rates(double, In, In, In, Out, Out) {}
};

// Three staggered fields of one value each; a solve adds the field's number and the step. No value for field 2.
struct Fields {
  std::size_t fields() const { return 3; }
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) {
    const auto at = static_cast<Eigen::Index>(k);
    to.y[at] = from.y[at] + 10.0 * seen.y[at] + dt;
    return k != 2;
  }
  Part part(std::size_t k) const { return {.first = static_cast<Eigen::Index>(k), .size = 1}; }
  double distance(std::size_t k, In x, In y) const { return static_cast<double>(k) * (x - y).norm(); }
};

static_assert(FirstOrderProblem<EveryFirstOrderAbility> && !SecondOrderProblem<EveryFirstOrderAbility>);
static_assert(PositionProblem<EverySecondOrderAbility> && !MotionProblem<EverySecondOrderAbility>);
static_assert(MotionProblem<Damped> && !PositionProblem<Damped> && SecondOrderProblem<Damped>);
static_assert(CoupledProblem<Coupled> && !FirstOrderProblem<Coupled> && !SecondOrderProblem<Coupled>);
static_assert(StaggeredProblem<Fields> && MeasuresFields<Fields> && !FirstOrderProblem<Fields> && !Measures<Fields>);
static_assert(!StaggeredProblem<Damped> && !MeasuresFields<Damped>);
static_assert(!AnyProblem<Silent> && !AnyProblem<int>, "a right-hand side says whether it has a value");

static_assert(Splits<EveryFirstOrderAbility> && HasJacobian<EveryFirstOrderAbility> &&
              HasSparseJacobian<EveryFirstOrderAbility> && Banded<EveryFirstOrderAbility> &&
              Measures<EveryFirstOrderAbility>);
static_assert(HasJacobian<EverySecondOrderAbility> && Measures<EverySecondOrderAbility> &&
              Jumps<EverySecondOrderAbility> && LocatesJumps<EverySecondOrderAbility> &&
              HasStepLimits<EverySecondOrderAbility>);
static_assert(HasWholeJacobian<Damped> && !HasJacobian<Damped> && !HasSparseJacobian<Damped> && !Measures<Damped> &&
              !Jumps<Damped> && !Banded<Damped> && !Splits<Damped> && !LocatesJumps<Damped> && !HasRanges<Damped> &&
              !HasStepLimits<Damped>);
static_assert(HasRanges<Coupled>);

constexpr bool same(const Traits& a, const Traits& b) {
  return a.motion == b.motion && a.velocities == b.velocities && a.values == b.values && a.carries == b.carries &&
         a.staggered == b.staggered;
}
static_assert(same(traits_of<EveryFirstOrderAbility>(), {.values = true}));
static_assert(same(traits_of<EverySecondOrderAbility>(), {.motion = true}));
static_assert(same(traits_of<Damped>(), {.motion = true, .velocities = true}));
static_assert(same(traits_of<Coupled>(), {.motion = true, .velocities = true, .values = true}));
static_assert(same(traits_of<Blind>(), {.motion = true, .values = true}));
static_assert(same(traits_of<Remembering>(), {.motion = true, .velocities = true, .carries = true}));
static_assert(same(traits_of<Counting>(), {.motion = true, .carries = true}));
static_assert(same(traits_of<Undecided>(), traits_of<Coupled>()), "a constant that is false says nothing");
static_assert(same(traits_of<Fields>(), {.staggered = true}));

const Eigen::Vector2d x(3.0, -4.0), zero(0.0, 0.0);

State values_at(double t) { return {.t = t, .y = x}; }
State motion_at(double t) { return {.t = t, .r = x, .v = Eigen::Vector2d(1.0, 1.0)}; }

Where where(const State& at) {
  return {at.t, {at.r.data(), at.r.size()}, {at.v.data(), at.v.size()}, {at.y.data(), at.y.size()}};
}
Answers answers(Rates& to) { return {{to.a.data(), to.a.size()}, {to.dy.data(), to.dy.size()}}; }

BOOST_AUTO_TEST_SUITE(traits_)

BOOST_AUTO_TEST_CASE(are_the_same_of_a_problem_and_of_it_erased) {
  Coupled coupled;
  const Problem erased(coupled);
  BOOST_TEST(same(traits(coupled), traits_of<Coupled>()));
  BOOST_TEST(same(traits(erased), traits_of<Coupled>()));
  BOOST_TEST(same(erased.traits(), traits_of<Coupled>()));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(distance_)

BOOST_AUTO_TEST_CASE(is_the_problems_own_measure) {
  EveryFirstOrderAbility first;
  EverySecondOrderAbility second;
  BOOST_TEST(Problem(first).distance(x, zero) == 50.0);
  BOOST_TEST(Problem(second).distance(x, zero) == 100.0);
}

BOOST_AUTO_TEST_CASE(is_the_sum_of_absolute_values_without_one) {
  Damped damped;
  BOOST_TEST(Problem(damped).distance(x, zero) == 7.0);
  BOOST_TEST(Problem(damped).distance(2, x, zero) == 7.0);
}

BOOST_AUTO_TEST_CASE(of_a_field_is_that_fields) {
  Fields fields;
  BOOST_TEST(Problem(fields).distance(2, x, zero) == 10.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Problem_)

BOOST_AUTO_TEST_CASE(counts_and_asks_for_every_first_order_right_hand_side) {
  EveryFirstOrderAbility first;
  long evaluations = 0;
  const Problem problem(first, &evaluations);
  Rates rates;
  BOOST_TEST(problem.rates(values_at(2.0), rates));
  BOOST_TEST(close(rates.dy, 2.0 * x, {}));
  BOOST_TEST(rates.a.size() == 0);
  BOOST_TEST(evaluations == 1);
  BOOST_TEST(problem.splits());
  BOOST_TEST(problem.rate_slow(where(values_at(2.0)), answers(rates)));
  BOOST_TEST(close(rates.dy, 4.0 * x, {}));
  BOOST_TEST(evaluations == 2);
  BOOST_TEST(problem.rate_fast(where(values_at(2.0)), answers(rates)));
  BOOST_TEST(close(rates.dy, 6.0 * x, {}));
  BOOST_TEST(evaluations == 3);
}

BOOST_AUTO_TEST_CASE(counts_and_asks_for_both_kinds_of_acceleration) {
  EverySecondOrderAbility position;
  Damped damped;
  long of_position = 0, of_damped = 0;
  Rates rates;
  BOOST_TEST(Problem(position, &of_position).rates(motion_at(2.0), rates));
  BOOST_TEST(close(rates.a, -2.0 * x, {}));
  BOOST_TEST(Problem(damped, &of_damped).rates(motion_at(0.0), rates));
  BOOST_TEST(close(rates.a, Eigen::Vector2d(-4.0, 3.0), {}));
  BOOST_TEST(rates.dy.size() == 0);
  BOOST_TEST(of_position == 1);
  BOOST_TEST(of_damped == 1);
  BOOST_TEST(!Problem(damped).splits());
}

// At t = 1, y_0 = 2: a = (1 + 10 (3, -4) + 100) 2.
BOOST_AUTO_TEST_CASE(asks_once_for_all_rates_of_a_coupled_problem) {
  Coupled coupled;
  State at = motion_at(1.0);
  at.y = Eigen::Vector2d(2.0, 0.0);
  long evaluations = 0;
  Rates rates;
  BOOST_TEST(Problem(coupled, &evaluations).rates(at, rates));
  BOOST_TEST(close(rates.a, Eigen::Vector2d(262.0, 122.0), {}));
  BOOST_TEST(close(rates.dy, Eigen::Vector2d(3.0, 1.0), {}));
  BOOST_TEST(evaluations == 1);
}

BOOST_AUTO_TEST_CASE(has_no_place_for_rates_of_values_that_change_by_jumps_alone) {
  Carrying carrying;
  State at = motion_at(1.0);
  at.y = x;
  Rates rates;
  BOOST_TEST(Problem(carrying).rates(at, rates));
  BOOST_TEST(carrying.written == 0);
}

BOOST_AUTO_TEST_CASE(passes_on_that_there_is_no_value_and_counts_it) {
  EveryFirstOrderAbility first;
  EverySecondOrderAbility second;
  Damped damped;
  Coupled coupled;
  long evaluations = 0;
  Rates rates;
  const Problem of_first(first, &evaluations);
  BOOST_TEST(!of_first.rates(values_at(-1.0), rates));
  BOOST_TEST(!of_first.rate_slow(where(values_at(-1.0)), answers(rates)));
  BOOST_TEST(!of_first.rate_fast(where(values_at(-1.0)), answers(rates)));
  BOOST_TEST(evaluations == 3);
  BOOST_TEST(!Problem(second, &evaluations).rates(motion_at(-1.0), rates));
  BOOST_TEST(!Problem(damped, &evaluations).rates(motion_at(-1.0), rates));
  State both = motion_at(-1.0);
  both.y = x;
  BOOST_TEST(!Problem(coupled, &evaluations).rates(both, rates));
  BOOST_TEST(evaluations == 6);
}

BOOST_AUTO_TEST_CASE(counts_and_solves_staggered_fields) {
  Fields fields;
  long evaluations = 0;
  const Problem problem(fields, &evaluations);
  const State from{.y = Eigen::Vector3d(1.0, 2.0, 3.0)}, seen{.y = Eigen::Vector3d(4.0, 5.0, 6.0)};
  State to = from;
  BOOST_TEST(problem.fields() == 3U);
  BOOST_TEST(problem.solve(1, from, 0.5, seen, to));
  BOOST_TEST(!problem.solve(2, from, 0.5, seen, to));
  BOOST_TEST(evaluations == 2);
  BOOST_TEST(to.y[problem.part(1).first] == 52.5);
  BOOST_TEST(problem.part(1).size == 1);
}

BOOST_AUTO_TEST_CASE(gives_jacobians_without_counting_them) {
  EveryFirstOrderAbility first;
  EverySecondOrderAbility second;
  long evaluations = 0;
  const Problem of_values(first, &evaluations), of_places(second, &evaluations);
  Eigen::MatrixXd J;
  BOOST_TEST((of_values.has_jacobian() && !of_values.has_whole_jacobian() && of_values.has_sparse_jacobian()));
  of_values.jacobian(where(values_at(2.0)), J);
  BOOST_TEST(close(J, Eigen::Matrix2d{{6.0, 0.0}, {0.0, -8.0}}, {}));
  SparseJacobian sparse;
  of_values.sparse_jacobian(where(values_at(2.0)), sparse);
  BOOST_TEST(sparse.coeff(0, 1) == -8.0);
  BOOST_TEST((of_places.has_jacobian() && !of_places.has_whole_jacobian()));
  of_places.jacobian(where(motion_at(2.0)), J);
  BOOST_TEST(close(J, Eigen::Matrix2d{{-6.0, 0.0}, {0.0, 8.0}}, {}));
  of_places.sparse_jacobian(where(motion_at(2.0)), sparse);
  BOOST_TEST(sparse.coeff(1, 0) == 6.0);
  BOOST_TEST(evaluations == 0);
}

BOOST_AUTO_TEST_CASE(knows_a_jacobian_of_everything_from_one_of_places_or_values) {
  Damped damped;
  Coupled coupled;
  const Problem problem(damped);
  Eigen::MatrixXd J(1, 3);
  BOOST_TEST((problem.has_jacobian() && problem.has_whole_jacobian() && !problem.has_sparse_jacobian()));
  problem.jacobian(where(motion_at(2.0)), J);
  BOOST_TEST(close(J, Eigen::RowVector3d(2.0, 3.0, 1.0), {}));
  BOOST_TEST((!Problem(coupled).has_jacobian() && !Problem(coupled).bandwidth()));
}

BOOST_AUTO_TEST_CASE(gives_the_bandwidth_without_counting_it) {
  EveryFirstOrderAbility first;
  long evaluations = 0;
  const Problem problem(first, &evaluations);
  BOOST_TEST_REQUIRE(problem.bandwidth().has_value());
  BOOST_TEST(problem.bandwidth()->lower == 4);
  BOOST_TEST(problem.bandwidth()->upper == 7);
  BOOST_TEST(evaluations == 0);
}

BOOST_AUTO_TEST_CASE(jumps_without_counting_it) {
  EverySecondOrderAbility second;
  Damped damped;
  long evaluations = 0;
  const Problem problem(second, &evaluations);
  BOOST_TEST((problem.jumps() && problem.locates_jumps()));
  State at = motion_at(0.0);
  const Jump jump = problem.jump(at, 0.25);
  BOOST_TEST(jump.impacts == 3);
  BOOST_TEST(jump.energy_change == -0.25);
  BOOST_TEST(jump.unsettled == "not yet");
  BOOST_TEST(close(at.v, Eigen::Vector2d(-1.0, -1.0), {}));
  const StepPath path{.scheme = nullptr, .at = nullptr, .from = at, .dt = 0.5, .intervals = 4};
  BOOST_TEST(problem.first_jump(path, 0.5).value() == 0.25);
  BOOST_TEST(evaluations == 0);
  BOOST_TEST((!Problem(damped).jumps() && !Problem(damped).locates_jumps()));
}

BOOST_AUTO_TEST_CASE(gives_the_time_scales_of_a_state) {
  EverySecondOrderAbility second;
  Damped damped;
  BOOST_TEST((Problem(second).has_step_limits() && !Problem(damped).has_step_limits()));
  const std::vector<TimeScale> limits = Problem(second).step_limits(motion_at(2.0));
  BOOST_TEST_REQUIRE(limits.size() == 2U);
  BOOST_TEST(limits[0].name == "spring");
  BOOST_TEST((limits[0].kind == TimeScale::Kind::oscillates && limits[1].kind == TimeScale::Kind::decays));
  BOOST_TEST(limits[1].seconds == 2.0);
}

BOOST_AUTO_TEST_CASE(serves_a_problem_that_is_constant) {
  const Spring constant{3.0};
  Spring changing{3.0};
  const Problem of_constant(constant), of_changing(changing);
  changing.stiffness = 5.0;  // nothing was copied
  Rates rates;
  BOOST_TEST(of_constant.rates(motion_at(0.0), rates));
  BOOST_TEST(close(rates.a, -3.0 * x, {}));
  BOOST_TEST(of_changing.rates(motion_at(0.0), rates));
  BOOST_TEST(close(rates.a, -5.0 * x, {}));
  BOOST_TEST(same(of_constant.traits(), {.motion = true}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(ranges_)

BOOST_AUTO_TEST_CASE(are_the_problems_or_one) {
  Coupled coupled;
  EveryFirstOrderAbility first;
  const std::vector<Range> own = Problem(coupled).ranges(2), one = Problem(first).ranges(5);
  BOOST_TEST_REQUIRE(own.size() == 2U);
  BOOST_TEST(own[1].name == "charge");
  BOOST_TEST(own[1].first == 1);
  BOOST_TEST_REQUIRE(one.size() == 1U);
  BOOST_TEST(one[0].name == "values");
  BOOST_TEST((one[0].first == 0 && one[0].size == 5 && one[0].TOL == 1.0));
}

BOOST_AUTO_TEST_CASE(that_do_not_make_up_the_values_are_refused) {
  const auto refuses = [](std::vector<Range> given, const char* words) {
    Coupled coupled;
    coupled.given = std::move(given);
    CHECK_REFUSED(Problem(coupled).ranges(3), words);
  };
  const Range heat{.name = "heat", .first = 0, .size = 1};
  refuses({heat, {.name = "charge", .first = 2, .size = 1}}, "charge begins at 2 where 1 is next");
  refuses({heat, {.name = "charge", .first = 0, .size = 2}}, "charge begins at 0 where 1 is next");
  refuses({heat, {.name = "charge", .first = 1, .size = 0}}, "hold a value each and have a positive TOL; charge");
  refuses({heat, {.name = "charge", .first = 1, .size = 2, .TOL = 0.0}}, "has TOL = 0");
  refuses({heat, {.name = "charge", .first = 1, .size = 1}}, "must hold all 3 values of the state, they hold 2");
  refuses({}, "must hold all 3 values of the state, they hold 0");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Hook_)

// Counts what passes, and lets the problem answer, each answer doubled.
struct Doubling : Hook {
  int whole = 0, slow = 0, fast = 0, jacobians = 0, impacts = 0;
  bool rates(const Problem& problem, Side side, const Where& at, const Answers& to) override {
    ++(side == Side::whole ? whole : side == Side::slow ? slow : fast);
    const bool value = side == Side::whole  ? problem.rates(at, to)
                       : side == Side::slow ? problem.rate_slow(at, to)
                                            : problem.rate_fast(at, to);
    Answers doubled = to;
    doubled.dy *= 2.0;
    return value;
  }
  void jacobian(const Problem& problem, const Where& at, Eigen::MatrixXd& J) override {
    ++jacobians;
    problem.jacobian(at, J);
  }
  void jumped(const Jump& jump) override { impacts += static_cast<int>(jump.impacts); }
};

BOOST_AUTO_TEST_CASE(stands_between_and_counts_go_on) {
  EveryFirstOrderAbility first;
  Doubling hook;
  long evaluations = 0;
  const Problem problem = Problem(first, &evaluations).with(hook);
  Rates rates;
  BOOST_TEST(problem.rates(values_at(2.0), rates));
  BOOST_TEST(close(rates.dy, 4.0 * x, {}));
  BOOST_TEST(problem.rate_slow(where(values_at(2.0)), answers(rates)));
  BOOST_TEST(close(rates.dy, 8.0 * x, {}));
  BOOST_TEST(!problem.rate_fast(where(values_at(-1.0)), answers(rates)));
  BOOST_TEST((hook.whole == 1 && hook.slow == 1 && hook.fast == 1));
  BOOST_TEST(evaluations == 3);  // not those that the hook has asked for as well
  Eigen::MatrixXd J;
  problem.jacobian(where(values_at(2.0)), J);
  BOOST_TEST(close(J, Eigen::Matrix2d{{6.0, 0.0}, {0.0, -8.0}}, {}));
  BOOST_TEST(hook.jacobians == 1);
  BOOST_TEST(evaluations == 3);
}

BOOST_AUTO_TEST_CASE(hears_of_every_jump) {
  EverySecondOrderAbility second;
  Doubling hook;
  State at = motion_at(0.0);
  BOOST_TEST(Problem(second).with(hook).jump(at, 0.25).impacts == 3);
  BOOST_TEST(hook.impacts == 3);
}

BOOST_AUTO_TEST_CASE(is_left_out_of_a_bare_problem_as_is_the_count) {
  EveryFirstOrderAbility first;
  Doubling hook;
  long evaluations = 0, others = 0;
  const Problem problem = Problem(first, &evaluations).with(hook);
  Rates rates;
  BOOST_TEST(problem.bare().rates(values_at(2.0), rates));
  BOOST_TEST(close(rates.dy, 2.0 * x, {}));
  BOOST_TEST((hook.whole == 0 && evaluations == 0));
  BOOST_TEST(problem.counted_by(others).rates(values_at(2.0), rates));
  BOOST_TEST((hook.whole == 1 && evaluations == 0 && others == 1));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::problem_test
