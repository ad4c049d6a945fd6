#include <harness/replay.hpp>

#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "says.hpp"

namespace tests::replay_test {

using namespace verification;

// A first-order problem that can do everything a problem may do.
struct Able {
  long asked = 0;
  bool rate(double t, schemes::In y, schemes::Out dy) {
    ++asked;
    dy = -y;
    return t < 2.0;
  }
  bool rate_slow(double, schemes::In y, schemes::Out dy) {
    dy = 3.0 * y;
    return true;
  }
  bool rate_fast(double, schemes::In y, schemes::Out dy) {
    dy = -4.0 * y;
    return true;
  }
  void jacobian(double t, schemes::In y, Eigen::MatrixXd& J) { J = -t * Eigen::MatrixXd::Identity(y.size(), y.size()); }
  schemes::Bandwidth bandwidth() const { return {.lower = 0, .upper = 1}; }
  double distance(schemes::In x, schemes::In y) const { return (x - y).norm(); }
  schemes::Jump jump(schemes::State&, double) { return {.impacts = 5, .energy_change = 0.0, .unsettled = {}}; }
  template <class Path>
  std::optional<double> first_jump(const Path&, double end) {
    return 0.5 * end;
  }
};

struct ByPosition {
  bool acceleration(double, schemes::In r, schemes::Out a) {
    a = -2.0 * r;
    return true;
  }
  void jacobian(double, schemes::In r, Eigen::MatrixXd& K) { K = -2.0 * Eigen::MatrixXd::Identity(r.size(), r.size()); }
};
struct ByMotion {
  bool acceleration(double, schemes::In r, schemes::In v, schemes::Out a) {
    a = -2.0 * r - v;
    return true;
  }
};

const Eigen::VectorXd one = Eigen::VectorXd::Ones(2);

BOOST_AUTO_TEST_SUITE(replayed)

BOOST_AUTO_TEST_CASE(gives_the_recorded_answers_in_order_without_asking_the_problem) {
  Able problem;
  Recorded<Able> recorded{problem};
  Eigen::VectorXd dy(2);
  recorded.rate(0.0, one, dy);
  recorded.rate(3.0, 2.0 * one, dy);
  recorded.rate_slow(0.0, one, dy);
  recorded.rate_fast(0.0, one, dy);
  BOOST_TEST(recorded.evaluations() == 4);

  Replayed<Able> replayed(problem, recorded.recording);
  const Eigen::VectorXd anything = 99.0 * one;
  BOOST_TEST(replayed.rate(7.0, anything, dy));
  BOOST_TEST((dy == -one));
  BOOST_TEST(!replayed.rate(7.0, anything, dy));
  BOOST_TEST((dy == -2.0 * one));
  BOOST_TEST(replayed.rate_slow(7.0, anything, dy));
  BOOST_TEST((dy == 3.0 * one));
  BOOST_TEST(replayed.rate_fast(7.0, anything, dy));
  BOOST_TEST((dy == -4.0 * one));
  BOOST_TEST(replayed.evaluations() == 4);
  BOOST_TEST(problem.asked == 2);
}

BOOST_AUTO_TEST_CASE(starts_again_after_rewind_and_refuses_to_be_asked_more_often) {
  Able problem;
  Recorded<Able> recorded{problem};
  Eigen::VectorXd dy(2);
  Eigen::MatrixXd J;
  recorded.rate(0.0, one, dy);
  Replayed<Able> replayed(problem, recorded.recording);
  replayed.rate(0.0, one, dy);
  BOOST_CHECK_EXCEPTION(replayed.rate(0.0, one, dy), std::logic_error,
                        says("no more right-hand sides than the recorded one"));
  BOOST_CHECK_EXCEPTION(replayed.jacobian(0.0, one, J), std::logic_error, says("no more Jacobians"));
  replayed.rewind();
  BOOST_TEST(replayed.evaluations() == 0);
  BOOST_TEST(replayed.rate(0.0, one, dy));
}

BOOST_AUTO_TEST_CASE(serves_second_order_problems_too) {
  Eigen::VectorXd a(2);
  ByPosition by_position;
  Recorded<ByPosition> positions{by_position};
  positions.acceleration(0.0, one, a);
  Replayed<ByPosition> from_positions(by_position, positions.recording);
  BOOST_TEST(from_positions.acceleration(0.0, 5.0 * one, a));
  BOOST_TEST((a == -2.0 * one));
  Eigen::MatrixXd K;
  positions.jacobian(0.0, one, K);
  Replayed<ByPosition>(by_position, positions.recording).jacobian(0.0, 5.0 * one, K);
  BOOST_TEST(K(1, 1) == -2.0);

  ByMotion by_motion;
  Recorded<ByMotion> motions{by_motion};
  motions.acceleration(0.0, one, one, a);
  Replayed<ByMotion> from_motions(by_motion, motions.recording);
  BOOST_TEST(from_motions.acceleration(0.0, 5.0 * one, one, a));
  BOOST_TEST((a == -3.0 * one));
}

BOOST_AUTO_TEST_CASE(has_the_abilities_of_its_problem_and_no_others) {
  const auto path = [](double, schemes::State&) {};
  static_assert(schemes::FirstOrderProblem<Replayed<Able>> && schemes::FirstOrderProblem<Recorded<Able>>);
  static_assert(schemes::Splits<Replayed<Able>> && schemes::Splits<Recorded<Able>>);
  static_assert(schemes::HasJacobian<Replayed<Able>> && schemes::HasJacobian<Recorded<Able>>);
  static_assert(schemes::Banded<Replayed<Able>> && schemes::Banded<Recorded<Able>>);
  static_assert(schemes::Measures<Replayed<Able>> && schemes::Measures<Recorded<Able>>);
  static_assert(schemes::LocatesJumps<Replayed<Able>, decltype(path)>);
  static_assert(schemes::LocatesJumps<Recorded<Able>, decltype(path)>);
  static_assert(schemes::PositionProblem<Replayed<ByPosition>> && !schemes::StateProblem<Replayed<ByPosition>>);
  static_assert(schemes::StateProblem<Recorded<ByMotion>> && !schemes::PositionProblem<Recorded<ByMotion>>);
  static_assert(!schemes::Measures<Replayed<ByPosition>> && !schemes::Jumps<Recorded<ByPosition>>);
  static_assert(schemes::HasJacobian<Recorded<ByPosition>> && schemes::HasJacobian<Replayed<ByPosition>>);
  static_assert(!schemes::HasJacobian<Recorded<ByMotion>> && !schemes::Splits<Replayed<ByPosition>>);
  static_assert(!schemes::Banded<Replayed<ByPosition>>);

  Able problem;
  Recorded<Able> recorded{problem};
  Eigen::MatrixXd J;
  recorded.jacobian(3.0, one, J);
  Replayed<Able> replayed(problem, recorded.recording);
  replayed.jacobian(8.0, one, J);
  BOOST_TEST(J(1, 1) == -3.0);
  BOOST_TEST(recorded.bandwidth().upper == 1);
  BOOST_TEST(replayed.bandwidth().upper == 1);
  schemes::State at;
  BOOST_TEST(replayed.jump(at, 0.1).impacts == 5);
  BOOST_TEST(replayed.first_jump(path, 1.0).value() == 0.5);
  BOOST_TEST(replayed.distance(one, 2.0 * one) == std::sqrt(2.0));
  BOOST_TEST(recorded.distance(one, 2.0 * one) == std::sqrt(2.0));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::replay_test
