#include <harness/replay.hpp>

#include <stdexcept>
#include <string>

namespace verification {
namespace {

bool asked(const schemes::Problem& problem, schemes::Hook::Side side, const schemes::Where& at,
           const schemes::Answers& to) {
  switch (side) {
    case schemes::Hook::Side::slow:
      return problem.rate_slow(at, to);
    case schemes::Hook::Side::fast:
      return problem.rate_fast(at, to);
    default:
      return problem.rates(at, to);
  }
}

[[noreturn]] void refuse(const char* what) {
  throw std::logic_error(std::string("a replayed run must ask for no more ") + what +
                         " than the recorded one did, but it asked for another; rewind() before each run, and make it "
                         "the same run");
}

}  // namespace

void Replay::rewind() {
  replays_ = true;
  next_ = next_jacobian_ = 0;
  by_jumps_ = 0;
}

bool Replay::rates(const schemes::Problem& problem, Side side, const schemes::Where& at, const schemes::Answers& to) {
  auto a = to.a;
  auto dy = to.dy;
  if (!replays_) {
    const bool value = asked(problem, side, at, to);
    recording_.answers.push_back({{.a = a, .dy = dy}, value});
    ++next_;
    return value;
  }
  if (next_ == recording_.answers.size()) refuse("right-hand sides");
  const Recording::Answer& answer = recording_.answers[next_++];
  a = answer.rates.a;
  dy = answer.rates.dy;
  return answer.value;
}

void Replay::jacobian(const schemes::Problem& problem, const schemes::Where& at, Eigen::MatrixXd& J) {
  if (!replays_) {
    problem.jacobian(at, J);
    recording_.jacobians.push_back(J);
    return;
  }
  if (next_jacobian_ == recording_.jacobians.size()) refuse("Jacobians");
  J = recording_.jacobians[next_jacobian_++];
}

}  // namespace verification
