#include <particulate/schemes/problem.hpp>

#include <optional>

#include <Eigen/SparseCore>

#include "close.hpp"

namespace tests::problem_test {

using particulate::schemes::Banded;
using particulate::schemes::Bandwidth;
using particulate::schemes::Counted;
using particulate::schemes::distance;
using particulate::schemes::FirstOrderForm;
using particulate::schemes::FirstOrderProblem;
using particulate::schemes::HasJacobian;
using particulate::schemes::HasSparseJacobian;
using particulate::schemes::In;
using particulate::schemes::Jump;
using particulate::schemes::Jumps;
using particulate::schemes::LocatesJumps;
using particulate::schemes::Measures;
using particulate::schemes::MeasuresFields;
using particulate::schemes::State;
using particulate::schemes::StateProblem;
using particulate::schemes::Out;
using particulate::schemes::PositionProblem;
using particulate::schemes::SecondOrderProblem;
using particulate::schemes::Splits;
using particulate::schemes::StaggeredProblem;
using particulate::schemes::State;

using Path = double (*)(double, const Motion&);
using Sparse = Eigen::SparseMatrix<double>;

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
  void sparse_jacobian(double t, In y, Sparse& J) {
    J.resize(y.size(), y.size());
    J.insert(0, 1) = t * y[1];
  }
  Bandwidth bandwidth() const { return {.lower = 4, .upper = 7}; }
  double distance(In x, In y) const { return 10.0 * (x - y).norm(); }
};

// Everything a second-order problem can offer.
struct EverySecondOrderAbility {
  bool acceleration(double t, In r, Out a) {
    a = -t * r;
    return t >= 0.0;
  }
  void jacobian(double t, In r, Eigen::MatrixXd& K) { K = -t * r.asDiagonal().toDenseMatrix(); }
  double distance(In x, In y) const { return 20.0 * (x - y).norm(); }
  Jump jump(Motion& at, double dt) {
    at.v = -at.v;
    return {.impacts = 3, .energy_change = -dt, .unsettled = "not yet"};
  }
  template <class P>
  std::optional<double> first_jump(const P&, double end) {
    return 0.5 * end;
  }
};

// a = -r - v.
struct Damped {
  bool acceleration(double t, In r, In v, Out a) {
    a = -r - v;
    return t >= 0.0;
  }
};

// A right-hand side that forgets to say whether it has a value is none.
struct Silent {
  void rate(double, In, Out) {}
  void acceleration(double, In, Out) {}
};

static_assert(FirstOrderProblem<EveryFirstOrderAbility> && !SecondOrderProblem<EveryFirstOrderAbility>);
static_assert(PositionProblem<EverySecondOrderAbility> && !MotionProblem<EverySecondOrderAbility>);
static_assert(MotionProblem<Damped> && !PositionProblem<Damped> && SecondOrderProblem<Damped>);
static_assert(!FirstOrderProblem<Silent> && !PositionProblem<Silent>);

// Three staggered fields of one value each; a solve adds the field's number and the step. No value for field 2.
struct Fields {
  std::size_t fields() const { return 3; }
  bool solve(std::size_t k, const Values& from, double dt, const Values& seen, Values& to) {
    const auto at = static_cast<Eigen::Index>(k);
    to.y[at] = from.y[at] + 10.0 * seen.y[at] + dt;
    return k != 2;
  }
  Out part(std::size_t k, Values& state) const { return state.y.segment(static_cast<Eigen::Index>(k), 1); }
  double distance(std::size_t k, In x, In y) const { return static_cast<double>(k) * (x - y).norm(); }
};
static_assert(StaggeredProblem<Counted<Fields>, Values> && MeasuresFields<Counted<Fields>> &&
              !FirstOrderProblem<Counted<Fields>> && !Measures<Counted<Fields>>);
static_assert(!StaggeredProblem<Counted<Damped>, Values> && !MeasuresFields<Counted<Damped>>);

static_assert(FirstOrderProblem<Counted<EveryFirstOrderAbility>> && Splits<Counted<EveryFirstOrderAbility>> &&
              HasJacobian<Counted<EveryFirstOrderAbility>> &&
              HasSparseJacobian<Counted<EveryFirstOrderAbility>, Sparse> && Banded<Counted<EveryFirstOrderAbility>> &&
              Measures<Counted<EveryFirstOrderAbility>>);
static_assert(PositionProblem<Counted<EverySecondOrderAbility>> && HasJacobian<Counted<EverySecondOrderAbility>> &&
              Measures<Counted<EverySecondOrderAbility>> && Jumps<Counted<EverySecondOrderAbility>> &&
              LocatesJumps<Counted<EverySecondOrderAbility>, Path>);
static_assert(MotionProblem<Counted<Damped>> && !PositionProblem<Counted<Damped>> && !Measures<Counted<Damped>> &&
                  !Jumps<Counted<Damped>> && !HasJacobian<Counted<Damped>> &&
                  !HasSparseJacobian<Counted<Damped>, Sparse> && !Banded<Counted<Damped>> && !Splits<Counted<Damped>> &&
                  !LocatesJumps<Counted<Damped>, Path> && !FirstOrderProblem<Counted<Damped>>,
              "a counter offers nothing that its problem lacks");
static_assert(MotionProblem<Counted<Counted<Damped>>>);
static_assert(FirstOrderProblem<FirstOrderForm<Damped>> && FirstOrderProblem<FirstOrderForm<EverySecondOrderAbility>>);

const Eigen::Vector2d x(3.0, -4.0), y(0.0, 0.0);

BOOST_AUTO_TEST_SUITE(distance_)

BOOST_AUTO_TEST_CASE(is_the_problems_own_measure) { BOOST_TEST(distance(EveryFirstOrderAbility{}, x, y) == 50.0); }

BOOST_AUTO_TEST_CASE(is_the_sum_of_absolute_values_without_one) { BOOST_TEST(distance(Damped{}, x, y) == 7.0); }

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Counted_)

BOOST_AUTO_TEST_CASE(counts_and_forwards_every_first_order_right_hand_side) {
  EveryFirstOrderAbility problem;
  Counted<EveryFirstOrderAbility> counted{problem};
  Eigen::VectorXd dy(2);
  BOOST_TEST(counted.rate(2.0, x, dy));
  BOOST_TEST(close(dy, 2.0 * x, {}));
  BOOST_TEST(counted.evaluations == 1);
  BOOST_TEST(counted.rate_slow(2.0, x, dy));
  BOOST_TEST(close(dy, 4.0 * x, {}));
  BOOST_TEST(counted.evaluations == 2);
  BOOST_TEST(counted.rate_fast(2.0, x, dy));
  BOOST_TEST(close(dy, 6.0 * x, {}));
  BOOST_TEST(counted.evaluations == 3);
  BOOST_TEST(counted.jacobians == 0);
}

BOOST_AUTO_TEST_CASE(counts_and_forwards_the_solves_of_staggered_fields) {
  Fields problem;
  Counted<Fields> counted{problem};
  const Values from{0.0, Eigen::Vector3d(1.0, 2.0, 3.0)}, seen{0.0, Eigen::Vector3d(4.0, 5.0, 6.0)};
  Values to = from;
  BOOST_TEST(counted.fields() == 3U);
  BOOST_TEST(counted.solve(1, from, 0.5, seen, to));
  BOOST_TEST(!counted.solve(2, from, 0.5, seen, to));
  BOOST_TEST(counted.evaluations == 2);
  BOOST_TEST(counted.part(1, to)[0] == 52.5);
  BOOST_TEST(distance(counted, 2, Eigen::Vector2d(3.0, 4.0), Eigen::Vector2d(0.0, 0.0)) == 10.0);
  BOOST_TEST(distance(Damped{}, 2, Eigen::Vector2d(3.0, 4.0), Eigen::Vector2d(0.0, 0.0)) == 7.0);
}

BOOST_AUTO_TEST_CASE(counts_jacobians_apart) {
  EveryFirstOrderAbility problem;
  Counted<EveryFirstOrderAbility> counted{problem};
  Eigen::MatrixXd J;
  counted.jacobian(2.0, x, J);
  BOOST_TEST(close(J, Eigen::Matrix2d{{6.0, 0.0}, {0.0, -8.0}}, {}));
  BOOST_TEST(counted.jacobians == 1);
  Sparse sparse;
  counted.sparse_jacobian(2.0, x, sparse);
  BOOST_TEST(sparse.coeff(0, 1) == -8.0);
  BOOST_TEST(counted.jacobians == 2);
  BOOST_TEST(counted.evaluations == 0);

  EverySecondOrderAbility second;
  Counted<EverySecondOrderAbility> of_second{second};
  of_second.jacobian(2.0, x, J);
  BOOST_TEST(close(J, Eigen::Matrix2d{{-6.0, 0.0}, {0.0, 8.0}}, {}));
  BOOST_TEST(of_second.jacobians == 1);
}

BOOST_AUTO_TEST_CASE(counts_both_kinds_of_acceleration) {
  EverySecondOrderAbility position;
  Damped damped;
  Counted<EverySecondOrderAbility> of_position{position};
  Counted<Damped> of_motion{damped};
  Eigen::VectorXd a(2);
  BOOST_TEST(of_position.acceleration(2.0, x, a));
  BOOST_TEST(close(a, -2.0 * x, {}));
  BOOST_TEST(of_motion.acceleration(0.0, x, Eigen::Vector2d(1.0, 1.0), a));
  BOOST_TEST(close(a, Eigen::Vector2d(-4.0, 3.0), {}));
  BOOST_TEST(of_position.evaluations == 1);
  BOOST_TEST(of_motion.evaluations == 1);
}

BOOST_AUTO_TEST_CASE(passes_on_that_there_is_no_value_and_counts_it) {
  EveryFirstOrderAbility first;
  EverySecondOrderAbility second;
  Damped damped;
  Counted<EveryFirstOrderAbility> of_first{first};
  Counted<EverySecondOrderAbility> of_second{second};
  Counted<Damped> of_motion{damped};
  Eigen::VectorXd out(2);
  BOOST_TEST(!of_first.rate(-1.0, x, out));
  BOOST_TEST(!of_first.rate_slow(-1.0, x, out));
  BOOST_TEST(!of_first.rate_fast(-1.0, x, out));
  BOOST_TEST(!of_second.acceleration(-1.0, x, out));
  BOOST_TEST(!of_motion.acceleration(-1.0, x, y, out));
  BOOST_TEST(of_first.evaluations == 3);
  BOOST_TEST(of_second.evaluations == 1);
  BOOST_TEST(of_motion.evaluations == 1);
}

BOOST_AUTO_TEST_CASE(forwards_the_bandwidth_without_counting_it) {
  EveryFirstOrderAbility problem;
  const Counted<EveryFirstOrderAbility> counted{problem};
  BOOST_TEST(counted.bandwidth().lower == 4);
  BOOST_TEST(counted.bandwidth().upper == 7);
  BOOST_TEST(counted.evaluations == 0);
}

BOOST_AUTO_TEST_CASE(forwards_distance_and_jumps_without_counting_them) {
  EverySecondOrderAbility problem;
  Counted<EverySecondOrderAbility> counted{problem};
  BOOST_TEST(counted.distance(x, y) == 100.0);
  BOOST_TEST(distance(counted, x, y) == 100.0);
  Motion at{.t = 0.0, .r = x, .v = x};
  const Jump jump = counted.jump(at, 0.25);
  BOOST_TEST(jump.impacts == 3);
  BOOST_TEST(jump.energy_change == -0.25);
  BOOST_TEST(jump.unsettled == "not yet");
  BOOST_TEST(close(at.v, -x, {}));
  const Path path = [](double theta, const Motion&) { return theta; };
  BOOST_TEST(counted.first_jump(path, 0.5).value() == 0.25);
  BOOST_TEST(counted.evaluations == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(FirstOrderForm_)

BOOST_AUTO_TEST_CASE(puts_velocities_before_accelerations) {
  const Eigen::Vector4d state(1.0, 2.0, 3.0, 4.0);
  Eigen::VectorXd rate(4);
  EverySecondOrderAbility position;
  BOOST_TEST(FirstOrderForm<EverySecondOrderAbility>{position}.rate(2.0, state, rate));
  BOOST_TEST(close(rate, Eigen::Vector4d(3.0, 4.0, -2.0, -4.0), {}));
  Damped damped;
  BOOST_TEST(FirstOrderForm<Damped>{damped}.rate(0.0, state, rate));
  BOOST_TEST(close(rate, Eigen::Vector4d(3.0, 4.0, -4.0, -6.0), {}));
}

BOOST_AUTO_TEST_CASE(passes_on_that_there_is_no_value) {
  Eigen::VectorXd rate(4);
  EverySecondOrderAbility position;
  Damped damped;
  BOOST_TEST(!FirstOrderForm<EverySecondOrderAbility>{position}.rate(-1.0, Eigen::Vector4d::Ones(), rate));
  BOOST_TEST(!FirstOrderForm<Damped>{damped}.rate(-1.0, Eigen::Vector4d::Ones(), rate));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::problem_test
