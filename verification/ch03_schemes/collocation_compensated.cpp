// Compensated summation: what rounding takes from the state, or from the time, in one step is given back in the next.

#include <cmath>
#include <string>

#include <ch01_fundamentals/motions.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

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

// The largest error of the time after k steps of 0.1 s, over k times that, in epsilons.
template <class S>
void compare_time(Rows& rows, const std::string& method, S scheme) {
  constexpr double tenth = 0.1;
  constexpr long steps = 100000;
  const Oscillators spring = oscillator(1e-3);
  State state = motion(1.0, 0.0);
  FixedStep control{.step = tenth};
  double worst = 0.0;
  long k = 0;
  const auto watch = [&](const State&, const State& to, double, const S&) {
    const long double exact = static_cast<long double>(++k) * tenth;
    keep_worst(worst, static_cast<double>(std::abs(to.t - exact) / (eps * exact)));
    return k < steps;
  };
  (void)integrate(spring, state, 1e9, scheme, control, watch);
  rows.equal("steps of 0.1 s, " + method, {.expected = steps, .computed = k, .because = "as many as were asked for"});
  rows.at_most("largest error of the time after k of them, over eps k 0.1 s, " + method,
               {.limit = 1.0,
                .computed = worst,
                .because = "half a rounding of the time, and half a rounding of the step k times"});
}

const Case time_compensated{
    {.name = "time_compensated",
     .claim = "the time of any scheme after a hundred thousand steps of a tenth of a second is right to one rounding",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      compare_time(rows, "forward Euler", ForwardEuler{});
      compare_time(rows, "backward Euler", BackwardEuler{});
      compare_time(rows, "Verlet", VelocityVerlet{});
      compare_time(rows, "RK4", RungeKutta4{});
      compare_time(rows, "Gauss 2", Collocation<Gauss<2>>{});
    }};

}  // namespace verification::collocation_compensated
