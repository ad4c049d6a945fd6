// How much nearer every sweep comes, against theory to five digits.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "linear_problems.hpp"

namespace verification::contraction_spring {

using namespace particulate::schemes;

// Changes are differences of numbers near 1: at 1e-10 they are good to 4 eps/1e-10.
constexpr double above_rounding = 1e-10, tolerance = 4.0 * eps / above_rounding;
constexpr auto because = "ratios of changes that are above 1e-10 of numbers near 1, four roundings each";

// The ratio over `stride` sweeps, as a factor per sweep, that is farthest from what is expected.
struct Ratio {
  double expected;
  double farthest = missing;
  double reported = missing;  // what the scheme itself says, where one sweep shows the factor
  int seen = 0;
};

void keep_farthest(double& farthest, double expected, double ratio) {
  if (std::isnan(farthest) || std::abs(ratio - expected) > std::abs(farthest - expected)) farthest = ratio;
}

Ratio ratio_of(const Sweeps& swept, std::size_t stride, double expected) {
  const std::vector<double> change = changes(swept.iterates);
  Ratio ratio{.expected = expected};
  for (std::size_t k = stride; k < change.size() && change[k] > above_rounding; ++k) {
    keep_farthest(ratio.farthest, expected,
                  std::pow(change[k] / change[k - stride], 1.0 / static_cast<double>(stride)));
    if (stride == 1) keep_farthest(ratio.reported, expected, swept.iterations[k].rate);
    ++ratio.seen;
  }
  return ratio;
}

void write(Rows& rows, const std::string& which, const Ratio& ratio, int& fewest) {
  rows.compare(
      which,
      {.expected = ratio.expected, .computed = ratio.farthest, .tolerance = relative(tolerance), .because = because});
  fewest = std::min(fewest, ratio.seen);
}

constexpr double phis[] = {1.0, 0.5, 0.7};
constexpr double steps_over_limit[] = {0.2, 0.5, 0.9};

// Positions alone are carried from sweep to sweep.
void compare_positions(Rows& rows, double phi, double x, int& fewest) {
  const double omega = 20.0, dt = x / (phi * omega);
  const Oscillators spring = oscillator(omega);
  const Sweeps swept = sweep_by_hand(BackwardEuler(phi), spring, motion(0.6, 0.4 / dt), dt, 40);
  const Ratio ratio = ratio_of(swept, 1, x * x);
  const std::string which = fmt::format("factor of a sweep, phi = {}, phi omega Dt = {}", phi, x);
  write(rows, which, ratio, fewest);
  rows.compare(which + ", as the scheme reports it",
               {.expected = x * x, .computed = ratio.reported, .tolerance = relative(tolerance), .because = because});
}

// A spring as y = (r, v).
struct AsValues {
  Oscillators spring;

  bool rate(double t, In y, Out dy) const {
    dy[0] = y[1];
    return spring.acceleration(t, y.head(1), dy.tail(1));
  }
};

// The velocity of the old sweep moves the position. The factor has two imaginary
// eigenvalues, so that the changes go down by its square over two sweeps, and by no law in one.
void compare_lagging(Rows& rows, double phi, double x, int& fewest) {
  const double omega = 20.0, dt = x / (phi * omega);
  const AsValues spring{.spring = oscillator(omega)};
  const State start{.t = 0.0, .y = Eigen::Vector2d(0.6, 0.4 * omega)};
  const Sweeps swept = sweep_by_hand(BackwardEuler(phi), spring, start, dt, 40);
  write(rows, fmt::format("factor of a sweep if velocities lag, phi = {}, phi omega Dt = {}", phi, x),
        ratio_of(swept, 2, x), fewest);
}

void compare_drag(Rows& rows, double phi, double z, int& fewest) {
  const DragRate drag{.c = 4.0, .m = 2.0};
  const double dt = z / (phi * 2.0);
  const State start{.t = 0.0, .y = Eigen::VectorXd::Constant(1, 0.8)};
  write(rows, fmt::format("factor of a sweep on drag, phi = {}, phi c Dt/m = {}", phi, z),
        ratio_of(sweep_by_hand(BackwardEuler(phi), drag, start, dt, 40), 1, z), fewest);
}

const Case contraction_spring{
    {.name = "contraction_spring",
     .claim = "a sweep contracts by (phi omega dt)^2 on a spring, by phi omega dt if velocities lag, and by phi c dt/m "
              "on drag",
     .equation = "R 3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      int fewest = 1000;
      for (const double phi : phis) {
        for (const double x : steps_over_limit) {
          compare_positions(rows, phi, x, fewest);
          compare_lagging(rows, phi, x, fewest);
          compare_drag(rows, phi, x, fewest);
        }
      }
      rows.at_least("sweeps compared, the fewest of all",
                    {.limit = 4, .computed = static_cast<double>(fewest), .because = "one ratio alone shows no law"});
    }};

// Every oscillator contracts on its own; of the sum of all only the slowest to converge is left.
const Case contraction_many{
    {.name = "contraction_many",
     .claim = "of several oscillators the one with the largest omega dt rules the contraction",
     .equation = "R 3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double dt = 0.01;
      const Eigen::Vector3d x{0.3, 0.9, 0.1};
      const Oscillators springs{.omega = x / dt};
      const State start{.t = 0.0, .r = Eigen::Vector3d{0.5, 0.2, 0.7}, .v = Eigen::Vector3d::Zero()};
      for (const double phi : phis) {
        const auto swept = sweep_by_hand(BackwardEuler(phi), springs, start, dt, 12);
        const std::vector<double> change = changes(swept.iterates);
        const double slowest = std::pow(phi * 0.9, 2);
        const std::size_t last = phi == 1.0 ? 11 : 7;
        rows.compare(fmt::format("last factor of a sweep over three springs, phi = {}", phi),
                     {.expected = slowest,
                      .computed = change[last] / change[last - 1],
                      .tolerance = relative(1e-5),
                      .because = "after seven sweeps the next spring is down to 9^-7 = 2e-7 of the slowest, and "
                                 "changes are above 1e-10"});
        const std::vector<double> one = changes(sweep_by_hand(BackwardEuler(phi), springs, start, dt, 2).iterates);
        rows.at_most(fmt::format("first factor over the slowest's, phi = {}", phi),
                     {.limit = 0.9,
                      .computed = one[1] / one[0] / slowest,
                      .because = "at first the springs that converge at once have a share: the mean over all is "
                                 "smaller than the largest"});
      }
    }};

}  // namespace verification::contraction_spring
