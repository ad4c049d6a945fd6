// The additive Runge-Kutta pairs of ARKODE on a problem in two parts, against its closed form.

#include <cmath>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>

namespace verification::reference_implicit_explicit {

using namespace particulate;

// An oscillator under strong drag, r'' = -r - c r': the drag is fast, the rest slow.
struct DraggedOscillator {
  double c = 100.0;  // drag [1/s]

  bool rate(double t, schemes::In y, schemes::Out dy) const {
    Eigen::VectorXd fast(2);
    rate_slow(t, y, dy);
    rate_fast(t, y, fast);
    dy += fast;
    return true;
  }
  bool rate_slow(double, schemes::In y, schemes::Out dy) const {
    dy[0] = y[1];
    dy[1] = -y[0];
    return true;
  }
  bool rate_fast(double, schemes::In y, schemes::Out dy) const {
    dy[0] = 0.0;
    dy[1] = -c * y[1];
    return true;
  }

  // Released at rest from r = 1: r = (s2 exp(s1 t) - s1 exp(s2 t))/(s2 - s1), s^2 + c s + 1 = 0, with the small root
  // s1 = 1/s2 formed without cancellation.
  Eigen::Vector2d released(double t) const {
    const double s2 = -0.5 * (c + std::sqrt(c * c - 4.0)), s1 = 1.0 / s2;
    return {(s2 * std::exp(s1 * t) - s1 * std::exp(s2 * t)) / (s2 - s1),
            (std::exp(s1 * t) - std::exp(s2 * t)) / (s2 - s1)};
  }
};

const Case implicit_explicit{
    {.name = "reference_implicit_explicit",
     .claim = "the additive pairs of ARKODE follow an oscillator under strong drag to its closed form",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double t_end = 10.0, tolerance = 1e-8;
      DraggedOscillator problem;
      for (const reference::AdditiveTable table : reference::additive_tables) {
        schemes::State state{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.0}};
        const schemes::Outcome out = reference::integrate(
            problem, state, t_end,
            reference::ImplicitExplicit{.table = table, .relative = tolerance, .absolute = 1e-3 * tolerance});
        rows.equal(fmt::format("{}: ended", name(table)), {.expected = "reached",
                                                           .computed = out.reason.empty() ? "reached" : out.reason,
                                                           .because = "there is an answer at the end only"});
        const Eigen::Vector2d exact = problem.released(t_end);
        rows.at_most(fmt::format("{}: error of both unknowns, each relative", name(table)),
                     {.limit = 100.0 * tolerance,
                      .computed = mixed_error({state.y.data(), 2}, {exact.data(), 2}, 1e-12),
                      .because = "a hundred tolerances of a step; drag damps what a step leaves in the velocity"});
      }
    }};

}  // namespace verification::reference_implicit_explicit
