// Compensated summation: what rounding takes from the state in one step is given back in the next.

#include <cmath>
#include <string>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/collocation.hpp>

#include "linear_problems.hpp"

namespace verification::collocation_compensated {

using namespace particulate::schemes;

// y' = (y2, -y1), the oscillator as a problem of first order.
struct Rotation {
  bool rate(double, In y, Out dy) const {
    dy[0] = y[1];
    dy[1] = -y[0];
    return true;
  }
};

// A power of two, so that the time is exact; so small that roundings of the state outweigh all else, and so short a run
// that the rounding of the coefficients, a shift in frequency, does not count.
constexpr double step = 1.0 / 8192.0, t_end = 16.0;

// The largest error of position and velocity of (cos, -sin)(t + phase) at the ends of the last hundred steps.
double largest_error(const Problem& problem, double phase, bool compensated) {
  const double r = std::cos(phase), v = -std::sin(phase);
  State state = problem.traits().motion ? motion(r, v) : State{.t = 0.0, .y = Eigen::Vector2d{r, v}};
  using Scheme = Collocation<Gauss<4>>;
  Scheme scheme({.compensated = compensated});
  double worst = 0.0;
  const auto watch = [&](const State&, const State& to, double, const Scheme&) {
    if (to.t < t_end - 100.0 * step) return true;
    const Eigen::VectorXd at = flat(to);
    keep_worst(worst, std::hypot(at[0] - std::cos(to.t + phase), at[1] + std::sin(to.t + phase)));
    return true;
  };
  FixedStep control{.step = step};
  require_reached(integrate(problem, state, t_end, scheme, control, watch));
  return worst;
}

// From six phases: how roundings add up is a matter of luck.
void compare(Rows& rows, const std::string& which, const Problem& problem) {
  double with = 0.0, without = 0.0;
  for (const double phase : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5}) {
    keep_worst(with, largest_error(problem, phase, true));
    keep_worst(without, largest_error(problem, phase, false));
  }
  rows.at_most("largest error after 131072 steps, " + which,
               {.limit = 16.0 * eps,
                .computed = with,
                .because = "t = 16 s with coefficients rounded to half an epsilon, from a start rounded once"});
  rows.at_least("the same without compensation, over it, " + which,
                {.limit = 4.0, .computed = without / with, .because = "a rounding of the state a step shows"});
}

const Case collocation_compensated{
    {.name = "collocation_compensated",
     .claim = "with compensated summation a hundred thousand steps of a closed orbit stay at rounding",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Oscillators spring = oscillator(1.0);
      const Rotation rotation;
      compare(rows, "motion", spring);
      compare(rows, "values", rotation);
    }};

}  // namespace verification::collocation_compensated
