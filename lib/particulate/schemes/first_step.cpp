#include <particulate/schemes/first_step.hpp>

#include <algorithm>
#include <cmath>

#include <particulate/schemes/scales.hpp>

namespace particulate::schemes {

namespace {

constexpr double share = 0.01;

// The shortest of some times.
class Shortest {
 public:
  explicit Shortest(double time) : time_(time) {}
  // (what/rate)^power, where both say something.
  void look(double what, double rate, double power) {
    const double time = std::pow(what / rate, power);
    if (what > 0.0 && time > 0.0) time_ = std::min(time_, time);
  }
  double time() const { return time_; }

 private:
  double time_;
};

double speed_of(const Problem& problem, const State& state) {
  Eigen::VectorXd shared;
  problem.common_motion(state.v, shared);
  return largest(state.v - shared);
}

}  // namespace

double first_step(const Problem& problem, const State& start, double t_end) {
  Shortest shortest((t_end - start.t) - start.t_carry);
  Rates rates, later;
  if (!problem.rates(start, rates)) return share * shortest.time();
  const bool moves = start.r.size() > 0, has_values = problem.traits().values;
  double length = 0.0, speed = 0.0;
  if (moves) {
    length = problem.spacing(start.r) > 0.0 ? problem.spacing(start.r) : largest(start.r);
    speed = speed_of(problem, start);
    shortest.look(length, speed, 1.0);
    shortest.look(length, largest(rates.a), 0.5);
    shortest.look(speed, largest(rates.a), 1.0);
  }
  const auto look_at_values = [&](const Eigen::VectorXd& changes, double power) {
    for (const Range& range : problem.ranges(start.y.size())) {
      shortest.look(largest(start.y.segment(range.first, range.size)),
                    largest(changes.segment(range.first, range.size)), power);
    }
  };
  if (has_values) look_at_values(rates.dy, 1.0);

  const double dt = share * shortest.time();
  State there = start;
  advance_time(start, dt, there);
  if (moves) there.r += dt * start.v, there.v += dt * rates.a;
  if (has_values) there.y += dt * rates.dy;
  if (!problem.rates(there, later)) return share * dt;
  if (moves) shortest.look(length, largest(later.a - rates.a) / dt, 1.0 / 3.0);
  if (has_values) look_at_values((later.dy - rates.dy) / dt, 0.5);
  return share * shortest.time();
}

}  // namespace particulate::schemes
