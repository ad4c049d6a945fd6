// Compensated summation: what rounding takes from the state in one step is given back in the next.

#include <cmath>
#include <string>
#include <type_traits>

#include <ch01_fundamentals/motions.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/collocation.hpp>

#include "linear_problems.hpp"

namespace {

using namespace particulate::schemes;
using namespace verification;

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

// The largest error of position and velocity of (cos t, -sin t) at the ends of the last hundred steps.
template <class P, class State>
double largest_error(const P& of, const State& start, bool compensated) {
  P problem = of;
  State state = start;
  using Scheme = Collocation<Gauss<4>>;
  Scheme scheme({.compensated = compensated});
  double worst = 0.0;
  const auto watch = [&](const State&, const State& to, double, const Scheme&) {
    if (to.t < t_end - 100.0 * step) return true;
    if constexpr (std::is_same_v<State, Values>) {
      keep_worst(worst, std::hypot(to.y[0] - std::cos(to.t), to.y[1] + std::sin(to.t)));
    } else {
      keep_worst(worst, std::hypot(to.r[0] - std::cos(to.t), to.v[0] + std::sin(to.t)));
    }
    return true;
  };
  FixedStep control{.step = step};
  require_reached(integrate(problem, state, t_end, scheme, control, watch));
  return worst;
}

template <class P, class State>
void compare(Rows& rows, const std::string& which, const P& problem, const State& start) {
  const double with = largest_error(problem, start, true), without = largest_error(problem, start, false);
  rows.at_most(
      "error after 131072 steps, " + which,
      {.limit = 16.0 * eps, .computed = with, .because = "t = 16 s with coefficients rounded to half an epsilon"});
  rows.at_least("the same without compensation, over it, " + which,
                {.limit = 4.0, .computed = without / with, .because = "a rounding of the state a step shows"});
}

const Case collocation_compensated{
    {.name = "collocation_compensated",
     .claim = "with compensated summation a hundred thousand steps of a closed orbit stay at rounding",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare(rows, "motion", oscillator(1.0), motion(1.0, 0.0));
      compare(rows, "values", Rotation{}, Values{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.0}});
    }};

}  // namespace
