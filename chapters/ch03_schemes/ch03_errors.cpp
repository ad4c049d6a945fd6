//! @page ch03_errors Chapter 3: Stiffness, and two errors of one step
//! @brief Newton's method in place of sweeps, and a control that sees what the step leaves as well as what they leave.
//! @tableofcontents
//!
//! No sweep reaches the far left of the plane. This page solves the same stages by Newton's method, which leaves the
//! step to accuracy alone, and follows an oscillator whose rates span decades. Then it steers by both errors of a step,
//! that of the sweeps and that of its equation, and shows which of them rules through a close passage.
//!
//! @section ch03_errors_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! The stiff problem of this page, van der Pol's oscillator, is slow but for two leaps a period:

struct VanDerPol {
  double mu;
  bool rate(double, schemes::In y, schemes::Out dy) const {
    dy << y[1], mu * (1.0 - y[0] * y[0]) * y[1] - y[0];
    return true;
  }
  void jacobian(double, schemes::In y, Eigen::MatrixXd& J) const {
    J << 0.0, 1.0, -2.0 * mu * y[0] * y[1] - 1.0, mu * (1.0 - y[0] * y[0]);
  }
};

//! @section ch03_stiff 9. Stiffness: Newton in place of sweeps
//!
//! The *equation* of a step is another matter, as in @ref ch03_bargain "section 1". The factor of a step on
//! \f$ \dot y = \lambda y \f$ is a rational function R(z). We solve by Newton's method, which
//! particulate::schemes::Newton does at the cost of one decomposition for a step size, and measure it on both axes:

void stiffness_and_errors(const Parameters& p, const report::Output& output, report::Checks& checks) {
  const schemes::State one{.t = 0.0, .y = Eigen::Vector2d(1.0, 0.0)};
  const auto factor = [&](auto scheme, std::complex<double> z) {
    schemes::FirstOrderPair problem = plane(z);
    schemes::State y = one;
    schemes::FixedStep control{.step = 1.0};
    const bool reached = schemes::integrate(problem, y, 1.0, scheme, control).status == schemes::Status::reached;
    return reached ? y.y.norm() : no_number;
  };
  using Stiff = schemes::Newton<>;
  report::Table stability({"|z|", "Gauss 2, Re z < 0", "Radau 1, Re z < 0", "Radau 2, Re z < 0", "Gauss 2, Re z = 0",
                           "Radau 1, Re z = 0", "Radau 2, Re z = 0"});
  double off_stability = 0.0;
  for (int k = -4; k <= 12; ++k) {
    const double x = std::pow(10.0, 0.25 * k);
    std::vector<report::Cell> row{x};
    for (const std::complex<double> z : {std::complex(-x, 0.0), std::complex(0.0, x)}) {
      const std::array<double, 3> seen{factor(schemes::Collocation<schemes::Gauss<2>, Stiff>(), z),
                                       factor(schemes::Collocation<schemes::Radau<1>, Stiff>(), z),
                                       factor(schemes::Collocation<schemes::Radau<2>, Stiff>(), z)};
      const std::array<double, 3> theory{std::abs((1.0 + z / 2.0 + z * z / 12.0) / (1.0 - z / 2.0 + z * z / 12.0)),
                                         std::abs(1.0 / (1.0 - z)),
                                         std::abs((1.0 + z / 3.0) / (1.0 - 2.0 * z / 3.0 + z * z / 6.0))};
      for (std::size_t i = 0; i < 3; ++i) {
        row.emplace_back(seen[i]);
        off_stability = larger(off_stability, std::abs(seen[i] - theory[i]));
      }
    }
    stability.add(std::move(row));
  }
  output.write("family_stability", stability);
  checks.add("factor of a step on both axes, against R(z)", off_stability, 1e-12);

  //! @figure{ch03_family_stability, Size of the factor of one step. Left: decay\, right: oscillation.}
  //!
  //! Gauss keeps the size of what oscillates, exactly, and of what decays fast it keeps nearly all. Radau damps both,
  //! the faster the more. So Gauss is for motion that conserves energy, Radau for what is to die out. Van der Pol's
  //! oscillator \f$ \ddot y = \mu (1 - y^2)\,\dot y - y \f$ from its test set @cite mazzia2008 needs the latter: five
  //! Radau stages, of order nine, steered as in the next section.

  VanDerPol oscillator{p.mu};
  schemes::State leaping{.t = 0.0, .y = Eigen::Vector2d(2.0, 0.0)};
  schemes::Collocation<schemes::Radau<5>, Stiff> radau({.sizes = Eigen::Vector2d(1.0, 1e-3)});
  schemes::ErrorControl patient{
      .TOL = 1e-6, .sweep_TOL = 1e-8, .K_d = 3, .step = 1e-3, .limit = 2.0 * p.mu, .growth = 8.0};
  report::Table leaps({"t [s]", "y [-]", "step [s]", "step x fastest rate [-]"});
  double stiffest = 0.0;
  const schemes::Outcome leapt = schemes::integrate(oscillator, leaping, 2.0 * p.mu, radau, patient,
                                                    [&](const auto&, const auto& to, double dt, const auto&) {
                                                      const double fastest = std::abs(p.mu * (1.0 - to.y[0] * to.y[0]));
                                                      stiffest = larger(stiffest, dt * fastest);
                                                      leaps.add({to.t, to.y[0], dt, dt * fastest});
                                                      return true;
                                                    });
  output.write("family_leaps", leaps);
  report::Table stiff({"steps", "refused", "right-hand sides", "longest step x rate [-]", "y(2 mu) [-]"});
  stiff.add({leapt.steps, leapt.rejections, leapt.evaluations, stiffest, leaping.y[0]});
  output.write("family_stiff", stiff);
  if (p.mu == 1000.0) {
    checks.add("van der Pol at t = 2000, against the published digits", leaping.y[0] - 1.706167732170483, 1e-8);
  }

  //! @figure{ch03_family_leaps, Van der Pol's oscillator and the steps that follow it.}
  //!
  //! @table{ch03_family_stiff}
  //!
  //! An explicit scheme, or a sweep, would need a step times rate of about one at all times. Newton leaves the step to
  //! accuracy alone: it spans decades, from the leaps to the slow way between them.
  //!
  //! @section ch03_both 10. Two errors, one step
  //!
  //! @ref ch03_truncation "Section 5" showed what \f$ \Phi_K \f$ cannot see. A polynomial through s rates can: if its
  //! leading coefficient is small beside the rates the step resolves them. From their ratio follows an estimate of
  //! what the step leaves, with no further force (particulate::schemes::Collocation). One-step schemes compare the
  //! rates of this step with those of the last one (particulate::schemes::VelocityVerlet, PhiFamily), or with the rate
  //! that the next one begins with (particulate::schemes::RungeKutta4). The control then takes the smaller of two
  //! wishes,
  //!
  //! \f[ \Delta t^{new} = \min\left\{\Phi_K,\ 0.9 \left(\frac{TOL}{\text{estimate}}\right)^{1/(p+1)}\right\}
  //!     \Delta t. \f]
  //!
  //! A pair with much less repulsion than before falls much closer. Four Gauss stages follow it through its passage:

  const Pair close(p.closeness);
  const double orbit = close.exact.period();
  Logged<schemes::ErrorControl> log{
      .control = {.TOL = p.accuracy, .sweep_TOL = p.accuracy, .step = 0.01 * orbit, .limit = 0.1 * orbit}};
  const auto [passed, error_of_passage] = follow(close, schemes::Collocation<schemes::Gauss<4>>(), log, orbit);
  report::Table passage({"time from the passage [periods]", "accepted step [periods]", "refused step [periods]",
                         "estimate/TOL [-]", "Phi_K [-]", "wish of the estimate [-]"});
  double above = 0.0, shortest = orbit, longest = 0.0;
  for (const auto& entry : log.entries) {
    const double dt = entry.made.dt / orbit, estimate = entry.made.truncation.error / p.accuracy;
    const double Phi_K = schemes::phi_K(entry.made.iteration, p.accuracy, log.control.K_d);
    passage.add({entry.t / orbit - 0.5, entry.accepted ? report::Cell(dt) : report::Cell(),
                 entry.accepted ? report::Cell() : report::Cell(dt), estimate,
                 std::isfinite(Phi_K) ? report::Cell(Phi_K) : report::Cell(), 0.9 * std::pow(estimate, -1.0 / 9.0)});
    if (!entry.accepted) continue;
    above = larger(above, estimate - 1.0);
    if (entry.t + entry.made.dt >= orbit) continue;  // cut short to land on the end
    shortest = std::min(shortest, dt);
    longest = std::max(longest, dt);
  }
  output.write("family_passage", passage);
  report::Table counted({"steps", "refused", "sweeps", "forces", "longest/shortest step", "largest error [m]"});
  counted.add(
      {passed.steps, passed.rejections, passed.sweeps, passed.evaluations, longest / shortest, error_of_passage});
  output.write("family_counted", counted);
  checks.add("estimates of steps that stand meet TOL: estimate/TOL - 1 at most", above, 0.0);
  checks.add("error of a close passage at TOL [m]", error_of_passage, 100.0 * p.accuracy);
}

}  // namespace ch03

//! @figure{ch03_family_passage, A close passage: steps (refused ones as crosses)\, the estimate they were judged by\, and by which factor either error would change them. The smaller factor rules.}
//!
//! @table{ch03_family_counted}
//!
//! The step follows the curvature of the path down to the passage and up again, mirrored, and nobody has named a
//! \f$ \Delta t_{lim} \f$ that had to be right. Refusals come where repulsion takes over from attraction and the
//! leading coefficient passes zero: for a step or two the estimate is small, the next step is tried too long. The
//! sweeps would bear longer steps nearly everywhere, and short ones need few of them. The estimate is the upper one of
//! two that the polynomial allows, so the error attained lies below TOL: how the two go together is measured for every
//! method (@ref verify_ch03_tolerance_proportionality "tolerance_proportionality").
//!
//! @section ch03_errors_exercises Exercises
//!
//! 1. Lower `--closeness` by ten. How do steps, refusals and forces grow, and how would they at a fixed step?
//! 2. Take sweeps from Guess::free_flight in section 10. Which of the two errors rules now, and what does it cost?
