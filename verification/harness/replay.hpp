#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// Recording a right-hand side and handing its answers out again, so that an integrator takes exactly the same path
/// without the cost of the problem: what remains is the integrator's own work.

namespace verification {

namespace schemes = particulate::schemes;

/// Every answer that a right-hand side gave during one run, in order.
struct Recording {
  std::vector<Eigen::VectorXd> answers;    ///< rates or accelerations, as asked for
  std::vector<bool> values;                ///< whether the problem had a value there
  std::vector<Eigen::MatrixXd> jacobians;  ///< Jacobians, as asked for
};

/// A problem that writes its answers down, and passes on everything else it can do.
template <class P>
struct Recorded {
  P& problem;                ///< the problem that answers; must outlive this
  Recording recording = {};  ///< what it has answered so far
  long by_jumps = 0;         ///< right-hand sides that its jumps asked for themselves; a replay makes the jumps anew

  /// @return how many right-hand sides were asked for, by the integrator and by jumps
  long evaluations() const { return static_cast<long>(recording.answers.size()) + by_jumps; }

  /// Answers and records. @see particulate::schemes::PositionProblem
  bool acceleration(double t, schemes::In r, schemes::Out a) requires schemes::PositionProblem<P> {
    return keep(problem.acceleration(t, r, a), a);
  }
  /// Answers and records. @see particulate::schemes::StateProblem
  bool acceleration(double t, schemes::In r, schemes::In v, schemes::Out a) requires schemes::StateProblem<P> {
    return keep(problem.acceleration(t, r, v, a), a);
  }
  /// Answers and records. @see particulate::schemes::FirstOrderProblem
  bool rate(double t, schemes::In y, schemes::Out dy) requires schemes::FirstOrderProblem<P> {
    return keep(problem.rate(t, y, dy), dy);
  }
  /// Answers and records. @see particulate::schemes::Splits
  bool rate_slow(double t, schemes::In y, schemes::Out dy) requires schemes::Splits<P> {
    return keep(problem.rate_slow(t, y, dy), dy);
  }
  /// Answers and records. @see particulate::schemes::Splits
  bool rate_fast(double t, schemes::In y, schemes::Out dy) requires schemes::Splits<P> {
    return keep(problem.rate_fast(t, y, dy), dy);
  }
  /// Answers and records. @see particulate::schemes::HasJacobian
  void jacobian(double t, schemes::In y, Eigen::MatrixXd& J) requires schemes::HasJacobian<P> {
    problem.jacobian(t, y, J);
    recording.jacobians.push_back(J);
  }
  /// Forwards. @see particulate::schemes::Banded
  schemes::Bandwidth bandwidth() const requires schemes::Banded<P> { return problem.bandwidth(); }
  /// Forwards. @see particulate::schemes::Measures
  double distance(schemes::In x, schemes::In y) const requires schemes::Measures<P> { return problem.distance(x, y); }
  /// Forwards, and counts what the jump asked for. @see particulate::schemes::Jumps
  schemes::Jump jump(schemes::State& at, double dt) requires schemes::Jumps<P> {
    const schemes::Jump jump = problem.jump(at, dt);
    by_jumps += jump.evaluations;
    return jump;
  }
  /// Forwards. @see particulate::schemes::LocatesJumps
  template <class Path>
  std::optional<double> first_jump(const Path& path, double end) requires schemes::LocatesJumps<P, Path> {
    return problem.first_jump(path, end);
  }

 private:
  bool keep(bool value, schemes::Out answer) {
    recording.answers.emplace_back(answer);
    recording.values.push_back(value);
    return value;
  }
};

/// The problem of a recording: the same answers in the same order, by copying alone, whatever state is asked about.
///
/// Distances, bandwidths and jumps come from the problem itself: they are the integrator's questions, not right-hand
/// sides.
template <class P>
class Replayed {
 public:
  /// @param problem    the problem that was recorded; asked for distances, bandwidths and jumps only
  /// @param recording  its answers; must outlive this
  Replayed(P& problem, const Recording& recording) : problem_(problem), recording_(recording) {}

  /// Goes back to the first answer, for another run.
  void rewind() { next_ = next_jacobian_ = 0; }
  /// @return how many right-hand sides were asked for since the start or the last rewind()
  long evaluations() const { return static_cast<long>(next_); }

  /// Copies the next answer. @see particulate::schemes::PositionProblem
  bool acceleration(double, schemes::In, schemes::Out a) requires schemes::PositionProblem<P> { return hand_out(a); }
  /// Copies the next answer. @see particulate::schemes::StateProblem
  bool acceleration(double, schemes::In, schemes::In, schemes::Out a) requires schemes::StateProblem<P> {
    return hand_out(a);
  }
  /// Copies the next answer. @see particulate::schemes::FirstOrderProblem
  bool rate(double, schemes::In, schemes::Out dy) requires schemes::FirstOrderProblem<P> { return hand_out(dy); }
  /// Copies the next answer. @see particulate::schemes::Splits
  bool rate_slow(double, schemes::In, schemes::Out dy) requires schemes::Splits<P> { return hand_out(dy); }
  /// Copies the next answer. @see particulate::schemes::Splits
  bool rate_fast(double, schemes::In, schemes::Out dy) requires schemes::Splits<P> { return hand_out(dy); }
  /// Copies the next Jacobian. @see particulate::schemes::HasJacobian
  void jacobian(double, schemes::In, Eigen::MatrixXd& J) requires schemes::HasJacobian<P> {
    if (next_jacobian_ == recording_.jacobians.size()) refuse("Jacobians");
    J = recording_.jacobians[next_jacobian_++];
  }
  /// Forwards. @see particulate::schemes::Banded
  schemes::Bandwidth bandwidth() const requires schemes::Banded<P> { return problem_.bandwidth(); }
  /// Forwards. @see particulate::schemes::Measures
  double distance(schemes::In x, schemes::In y) const requires schemes::Measures<P> { return problem_.distance(x, y); }
  /// Forwards. @see particulate::schemes::Jumps
  schemes::Jump jump(schemes::State& at, double dt) requires schemes::Jumps<P> { return problem_.jump(at, dt); }
  /// Forwards. @see particulate::schemes::LocatesJumps
  template <class Path>
  std::optional<double> first_jump(const Path& path, double end) requires schemes::LocatesJumps<P, Path> {
    return problem_.first_jump(path, end);
  }

 private:
  bool hand_out(schemes::Out answer) {
    if (next_ == recording_.answers.size()) refuse("right-hand sides");
    answer = recording_.answers[next_];
    return recording_.values[next_++];
  }
  [[noreturn]] static void refuse(const char* what) {
    throw std::logic_error(std::string("a replayed run must ask for no more ") + what +
                           " than the recorded one did, but it asked for another; rewind() before each run, and make "
                           "it the same run");
  }

  P& problem_;
  const Recording& recording_;
  std::size_t next_ = 0, next_jacobian_ = 0;
};

}  // namespace verification
