#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// Recording a right-hand side and handing its answers out again, so that an integrator takes exactly the same path
/// without the cost of the problem: what remains is the integrator's own work.

namespace verification {

namespace schemes = particulate::schemes;

/// Every answer that a problem gave during one run, in order.
struct Recording {
  /// Of one right-hand side.
  struct Answer {
    schemes::Rates rates;  ///< as asked for: all rates, or a slow or fast part
    bool value;            ///< whether the problem had a value there
  };
  std::vector<Answer> answers;             ///< right-hand sides
  std::vector<Eigen::MatrixXd> jacobians;  ///< dense ones, as asked for
};

/// Stands between a problem and an integrator: writes down what the problem answers, and after rewind() gives the same
/// answers in the same order, by copying alone, whatever state is asked about.
///
/// Distances, bandwidths, sparse Jacobians and jumps come from the problem itself, in a replay too: they are no
/// right-hand sides, and a jump asks for its own.
class Replay : public schemes::Hook {
 public:
  /// Goes back to the first answer, for a run that is not to ask the problem.
  void rewind();
  /// @return how many right-hand sides were asked for since the start or the last rewind(), by the integrator and by
  ///         jumps
  long evaluations() const { return static_cast<long>(next_) + by_jumps_; }
  /// @return what the problem answered
  const Recording& recording() const { return recording_; }

  /// Records, or copies the next answer. @see particulate::schemes::Hook
  /// @throws std::logic_error if a replay asks for more than was recorded
  bool rates(const schemes::Problem& problem, Side side, const schemes::Where& at, const schemes::Answers& to) override;
  /// Records, or copies the next Jacobian. @see particulate::schemes::Hook
  /// @throws std::logic_error if a replay asks for more than were recorded
  void jacobian(const schemes::Problem& problem, const schemes::Where& at, Eigen::MatrixXd& J) override;
  /// Counts what a jump asked for. @see particulate::schemes::Hook
  void jumped(const schemes::Jump& jump) override { by_jumps_ += jump.evaluations; }

 private:
  bool replays_ = false;
  Recording recording_;
  std::size_t next_ = 0, next_jacobian_ = 0;
  long by_jumps_ = 0;
};

}  // namespace verification
