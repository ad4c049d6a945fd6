#include <harness/replay.hpp>

#include <cmath>
#include <stdexcept>

#include "says.hpp"

namespace tests::replay_test {

using namespace verification;
using schemes::Problem;
using Side = schemes::Hook::Side;

// A first-order problem that can do everything a problem may do.
struct Able {
  long asked = 0;
  bool rate(double t, schemes::In y, schemes::Out dy) {
    ++asked;
    dy = -y;
    return t < 2.0;
  }
  bool rate_slow(double, schemes::In y, schemes::Out dy) {
    ++asked;
    dy = 3.0 * y;
    return true;
  }
  bool rate_fast(double, schemes::In y, schemes::Out dy) {
    ++asked;
    dy = -4.0 * y;
    return true;
  }
  void jacobian(double t, schemes::In y, Eigen::MatrixXd& J) {
    ++asked;
    J = -t * Eigen::MatrixXd::Identity(y.size(), y.size());
  }
  schemes::Bandwidth bandwidth() const { return {.lower = 0, .upper = 1}; }
  double distance(schemes::In x, schemes::In y) const { return (x - y).norm(); }
  schemes::Jump jump(schemes::State&, double) { return {.impacts = 5, .evaluations = 2, .unsettled = {}}; }
  std::optional<double> first_jump(const schemes::StepPath&, double end) { return 0.5 * end; }
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
struct Coupled {
  bool rates(double, schemes::In r, schemes::In v, schemes::In y, schemes::Out a, schemes::Out dy) {
    a = -r - v;
    dy = 5.0 * y;
    return true;
  }
};

const Eigen::VectorXd none, one = Eigen::VectorXd::Ones(2);

// What a problem answers.
struct Answer {
  bool value;
  Eigen::VectorXd a, dy;
};
Answer answer(const Problem& problem, double t, const Eigen::VectorXd& r, const Eigen::VectorXd& v,
              const Eigen::VectorXd& y) {
  schemes::Rates rates;
  const bool value = problem.rates(t, r, v, y, rates);
  return {value, rates.a, rates.dy};
}
Answer rate(const Problem& problem, double t, const Eigen::VectorXd& y, Side side = Side::whole) {
  if (side == Side::whole) return answer(problem, t, none, none, y);
  Eigen::VectorXd dy(y.size());
  const schemes::Where at{t, {nullptr, 0}, {nullptr, 0}, {y.data(), y.size()}};
  const schemes::Answers to{{nullptr, 0}, {dy.data(), dy.size()}};
  const bool value = side == Side::slow ? problem.rate_slow(at, to) : problem.rate_fast(at, to);
  return {value, {}, dy};
}
double last_entry_of_jacobian(const Problem& problem, double t) {
  Eigen::MatrixXd J(2, 2);
  const Eigen::Map<const Eigen::VectorXd> all(one.data(), 2);
  problem.jacobian({t, all, all, all}, J);
  return J(1, 1);
}

BOOST_AUTO_TEST_SUITE(replayed)

BOOST_AUTO_TEST_CASE(gives_the_recorded_answers_in_order_without_asking_the_problem) {
  Able problem;
  Replay tape;
  const Problem seen = Problem(problem).with(tape);
  BOOST_TEST(rate(seen, 0.0, one).value);
  BOOST_TEST(!rate(seen, 3.0, 2.0 * one).value);
  rate(seen, 0.0, one, Side::slow);
  rate(seen, 0.0, one, Side::fast);
  BOOST_TEST(tape.evaluations() == 4);

  tape.rewind();
  const Eigen::VectorXd anything = 99.0 * one;
  const Answer first = rate(seen, 7.0, anything), second = rate(seen, 7.0, anything);
  BOOST_TEST(first.value);
  BOOST_TEST((first.dy == -one));
  BOOST_TEST(!second.value);
  BOOST_TEST((second.dy == -2.0 * one));
  BOOST_TEST((rate(seen, 7.0, anything, Side::slow).dy == 3.0 * one));
  BOOST_TEST((rate(seen, 7.0, anything, Side::fast).dy == -4.0 * one));
  BOOST_TEST(tape.evaluations() == 4);
  BOOST_TEST(problem.asked == 4);
}

BOOST_AUTO_TEST_CASE(starts_again_after_rewind_and_refuses_to_be_asked_more_often) {
  Able problem;
  Replay tape;
  const Problem seen = Problem(problem).with(tape);
  rate(seen, 0.0, one);
  tape.rewind();
  rate(seen, 0.0, one);
  BOOST_CHECK_EXCEPTION(rate(seen, 0.0, one), std::logic_error, says("no more right-hand sides than the recorded one"));
  BOOST_CHECK_EXCEPTION(last_entry_of_jacobian(seen, 0.0), std::logic_error, says("no more Jacobians"));
  tape.rewind();
  BOOST_TEST(tape.evaluations() == 0);
  BOOST_TEST(rate(seen, 0.0, one).value);
}

BOOST_AUTO_TEST_CASE(serves_motions_and_coupled_problems_too) {
  ByPosition by_position;
  Replay positions;
  const Problem of_positions = Problem(by_position).with(positions);
  answer(of_positions, 0.0, one, one, none);
  BOOST_TEST(last_entry_of_jacobian(of_positions, 0.0) == -2.0);
  positions.rewind();
  BOOST_TEST((answer(of_positions, 0.0, 5.0 * one, one, none).a == -2.0 * one));
  BOOST_TEST(last_entry_of_jacobian(of_positions, 0.0) == -2.0);

  ByMotion by_motion;
  Replay motions;
  const Problem of_motions = Problem(by_motion).with(motions);
  answer(of_motions, 0.0, one, one, none);
  motions.rewind();
  BOOST_TEST((answer(of_motions, 0.0, 5.0 * one, one, none).a == -3.0 * one));

  Coupled coupled;
  Replay both;
  const Problem of_both = Problem(coupled).with(both);
  answer(of_both, 0.0, one, one, one);
  BOOST_TEST(both.evaluations() == 1);
  both.rewind();
  const Answer again = answer(of_both, 0.0, 7.0 * one, one, 7.0 * one);
  BOOST_TEST((again.a == -2.0 * one));
  BOOST_TEST((again.dy == 5.0 * one));
}

BOOST_AUTO_TEST_CASE(replays_jacobians_and_leaves_all_else_to_the_problem) {
  Able problem;
  Replay tape;
  const Problem seen = Problem(problem).with(tape);
  BOOST_TEST(last_entry_of_jacobian(seen, 3.0) == -3.0);
  tape.rewind();
  BOOST_TEST(last_entry_of_jacobian(seen, 8.0) == -3.0);
  BOOST_TEST(problem.asked == 1);
  BOOST_TEST(seen.bandwidth().value().upper == 1);
  BOOST_TEST(seen.distance(one, 2.0 * one) == std::sqrt(2.0));
  const schemes::State from;
  const schemes::StepPath path{.scheme = nullptr, .at = nullptr, .from = from, .dt = 1.0, .intervals = 1};
  BOOST_TEST(seen.first_jump(path, 1.0).value() == 0.5);

  ByMotion plain;
  const Problem less = Problem(plain).with(tape);
  BOOST_TEST((!less.has_jacobian() && !less.splits() && !less.jumps() && !less.bandwidth()));
}

BOOST_AUTO_TEST_CASE(counts_what_jumps_ask_for_in_the_recording_and_in_the_replay) {
  Able problem;
  Replay tape;
  const Problem seen = Problem(problem).with(tape);
  schemes::State at;
  rate(seen, 0.0, one);
  BOOST_TEST(seen.jump(at, 0.1).impacts == 5);
  BOOST_TEST(tape.evaluations() == 3);
  tape.rewind();
  rate(seen, 0.0, one);
  BOOST_TEST(seen.jump(at, 0.1).impacts == 5);
  BOOST_TEST(tape.evaluations() == 3);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::replay_test
