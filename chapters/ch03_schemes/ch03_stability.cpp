//! @page ch03_stability Chapter 3: What an implicit step buys
//! @brief Stability belongs to the equation of an implicit step, not to the sweeps that solve it.
//! @tableofcontents
//!
//! An implicit step is stable whatever its length, but somebody must solve it. This page takes one step of each scheme
//! over a whole plane of problems, and shows where a step does not grow, and where the sweeps that solve it contract:
//! for plain ones a disc, no larger than what an explicit scheme allows. Then it shows what a sweep over particles is,
//! and by how much it contracts.
//!
//! @section ch03_stability_program The program

#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include <Eigen/Core>

#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sweeps.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! The springs of @ref ch03_shared "the shared header" as values of first order, \f$ y = (r, v) \f$, so that a sweep takes
//! the velocities as they were:

struct SpringsAsRates {
  Springs springs;
  bool rate(double t, schemes::In y, schemes::Out dy) const {
    const Eigen::Index n = y.size() / 2;
    dy.head(n) = y.tail(n);
    return springs.acceleration(t, y.head(n), dy.tail(n));
  }
};

//! @section ch03_bargain 1. The bargain of an implicit step
//!
//! To move \f$ \dot y = f(t, y) \f$ over a step, the forward Euler scheme takes f at its start, the backward Euler
//! scheme at its end,
//!
//! \f[ y^{L+1} = y^L + \Delta t\,f(t^L, y^L), \tag{about 3.3} \f]
//! \f{equation}{ y^{L+1} = y^L + \Delta t\,f(t^{L+1}, y^{L+1}). \tag{3.5} \label{eq:euler} \f}
//!
//! A particle that is slowed down by \f$ m \dot v = -c v \f$ (section 3.2) shows the difference. Forward, each step
//! multiplies v by \f$ 1 - c\,\Delta t/m \f$, which changes sign if the step is long, and grows beyond
//! \f$ \Delta t = 2m/c \f$. Backward, the factor is \f$ 1/(1 + c\,\Delta t/m) \f$: never above one, whatever the
//! step. But somebody must solve for \f$ v^{L+1} \f$. Sweeps that put the last iterate into f multiply their error by
//! \f$ -c\,\Delta t/m \f$ each, so they settle only if that is below one: *less* than what the explicit scheme
//! allows. We take one step of the library's schemes, and sweep to rounding.
//!
//! Real and imaginary part of one complex unknown are two real ones, so \f$ \dot y = \lambda y \f$ is a
//! particulate::schemes::FirstOrderPair. Here \f$ \lambda\,\Delta t = -c\,\Delta t/m \f$ is real; the next section
//! needs the rest of the plane.

void stability(const Parameters& p, const report::Output& output, bool quick, report::Checks& checks) {
  const schemes::State one{.t = 0.0, .y = Eigen::Vector2d(1.0, 0.0)};
  const auto step_once = [&](auto scheme, std::complex<double> z) {
    schemes::FirstOrderPair problem = plane(z);
    schemes::State y = one;
    schemes::FixedStep control{.step = 1.0, .contractions = 5000};
    const schemes::Outcome outcome = schemes::integrate(problem, y, 1.0, scheme, control);
    return std::pair(outcome,
                     outcome.status == schemes::Status::reached ? y.y : Eigen::VectorXd::Constant(2, no_number));
  };
  const auto contraction_at = [&](double phi, std::complex<double> z) {
    const schemes::FirstOrderPair problem = plane(z);
    const schemes::Sweeps made = schemes::sweep_by_hand(schemes::PhiFamily<>(phi), problem, one, 1.0, 3);
    return change(made, 2) / change(made, 1);
  };
  const schemes::PhiFamily<schemes::Anderson> backward_mixed(1.0, schemes::Anderson(2));

  report::Table factors({"c Dt/m [-]", "forward [-]", "backward [-]", "its sweeps", "contraction [-]", "outcome",
                         "backward, Anderson [-]", "Anderson's sweeps"});
  double off_factor = 0.0, off_range = 0.0;
  for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.01, 1.5, 1.9, 2.1, 2.5}) {
    const auto [forward, after_forward] = step_once(schemes::ForwardEuler{}, -x);
    const auto [backward, after_backward] = step_once(schemes::BackwardEuler{}, -x);
    const auto [mixed, after_mixed] = step_once(backward_mixed, -x);
    const bool solved = backward.status == schemes::Status::reached;
    factors.add({x, after_forward[0], solved ? report::Cell(after_backward[0]) : report::Cell(),
                 solved ? report::Cell(backward.sweeps) : report::Cell(), contraction_at(1.0, -x),
                 solved ? "solved" : "refused", after_mixed[0], mixed.sweeps});
    off_factor = larger(off_factor, std::abs(after_forward[0] - (1.0 - x)));
    off_factor = larger(off_factor, std::abs(after_mixed[0] - 1.0 / (1.0 + x)));
    if (solved) off_factor = larger(off_factor, std::abs(after_backward[0] - 1.0 / (1.0 + x)));
    off_range += solved != (x < 1.0);
  }
  output.write("factors", factors);
  checks.add("factors of an Euler step on m v' = -c v", off_factor, 1e-14);
  checks.add("backward Euler is solved if c Dt/m < 1, refused otherwise: steps where not", off_range, 0.0);

  //! @figure{ch03_stability, Factor of one step on m v' = -c v. Backward Euler's curve ends for plain sweeps where they stop to contract; mixed sweeps go on.}
  //!
  //! @table{ch03_factors}
  //!
  //! This is the trade-off of the whole chapter: unconditional stability belongs to the *equation* of an implicit step,
  //! not to the iteration that solves it. The library never hands back an iterate that has not settled: the outcome is a
  //! refusal with its reason. Sweeps may also be mixed, each guess made from the last few
  //! (particulate::schemes::Anderson, @cite walker2011), which solves a linear equation in little more sweeps than it has
  //! different eigenvalues, whether they contract or not.
  //!
  //! @section ch03_regions 2. Regions of stability, regions of contraction
  //!
  //! Any linear motion is a sum of \f$ e^{\lambda t} \f$ with complex \f$ \lambda \f$, decay to the left, oscillation
  //! up and down. So we scan the plane of \f$ z = \lambda\,\Delta t \f$ and take one step of the real scheme at each
  //! point. The implicit schemes belong to one family: \f$ \phi \f$ is the weight of the end of the step,
  //! \f$ 1 - \phi \f$ that of its start. With \f$ \phi = 1 \f$ it is backward Euler, with \f$ \phi = 1/2 \f$ the
  //! trapezoidal rule, which is of second order. Theory says
  //!
  //! \f[ |y^{L+1}/y^L| = \left|\frac{1 + (1-\phi) z}{1 - \phi z}\right|, \qquad
  //!     \frac{|y^{K+1} - y^K|}{|y^K - y^{K-1}|} = \phi\,|z|, \f]
  //!
  //! and for Runge-Kutta the exponential series up to \f$ z^4 \f$.

  const double spacing = quick ? 0.1 : 0.05;
  report::Table regions({"Re z", "Im z", "forward Euler", "Runge-Kutta", "phi = 1", "phi = 1/2", "contraction, phi = 1",
                         "contraction, phi = 1/2"});
  double off_amplification = 0.0, off_contraction = 0.0;
  for (double x = -4.0 + 0.5 * spacing; x < 3.0; x += spacing) {
    for (double y = -3.5 + 0.5 * spacing; y < 3.5; y += spacing) {
      const std::complex<double> z(x, y), series = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
      const std::array<double, 4> theory{std::abs(1.0 + z), std::abs(series), std::abs(1.0 / (1.0 - z)),
                                         std::abs((1.0 + 0.5 * z) / (1.0 - 0.5 * z))};
      const schemes::PhiFamily<schemes::Anderson> middle(0.5, schemes::Anderson(2));
      const std::array<double, 4> seen{step_once(schemes::ForwardEuler{}, z).second.norm(),
                                       step_once(schemes::RungeKutta4{}, z).second.norm(),
                                       step_once(backward_mixed, z).second.norm(), step_once(middle, z).second.norm()};
      const double eta = contraction_at(1.0, z), eta_middle = contraction_at(0.5, z);
      regions.add({x, y, seen[0], seen[1], seen[2], seen[3], eta, eta_middle});
      for (std::size_t k = 0; k < 4; ++k) {
        off_amplification = larger(off_amplification, std::abs(seen[k] / theory[k] - 1.0));
      }
      off_contraction = larger(off_contraction, std::abs(eta / std::abs(z) - 1.0));
      off_contraction = larger(off_contraction, std::abs(2.0 * eta_middle / std::abs(z) - 1.0));
    }
  }
  output.write("regions", regions);
  checks.add("growth of a step in the plane of z, relative to theory", off_amplification, 1e-10);
  checks.add("contraction of a sweep in the plane of z, relative to theory", off_contraction, 1e-10);

  //! @figure{ch03_regions, The plane of z. Left: a step does not grow inside the curves of the explicit schemes\, outside the circle of backward Euler\, and left of the axis for the trapezoidal rule. Right: sweeps contract inside the circles; shaded is what neither grows nor fails to contract\, dashed are the explicit schemes again.}
  //!
  //! On the left the implicit schemes look far superior: half the plane and more. On the right is what plain sweeps
  //! leave of it, a disc no larger than the regions of the explicit schemes. Halving \f$ \phi \f$ doubles its radius
  //! and raises the order at no cost.
  //!
  //! @section ch03_sweep 3. A sweep over particles
  //!
  //! For particles the family reads
  //!
  //! \f{equation}{ \begin{aligned}
  //!     v_i^{L+1} &= v_i^L + \frac{\Delta t}{m_i}\left(\phi\,\Psi_i^{L+1} + (1-\phi)\,\Psi_i^L\right),
  //!     \\ r_i^{L+1} &= r_i^L + \Delta t\left(\phi\,v_i^{L+1} + (1-\phi)\,v_i^L\right). \end{aligned} \tag{R 3.3} \label{eq:phi} \f}
  //!
  //! The first iterate is free flight. A sweep takes all forces at the last positions, then the velocities from the
  //! forces, then the positions from these velocities; so the error of the positions passes through the force once and
  //! through time twice, and a sweep multiplies it by about \f$ \eta = \phi^2 \Delta t^2 \|\partial\Psi/\partial r\|/m
  //! \f$. On a spring that is \f$ (\phi\,\omega\,\Delta t)^2 \f$ exactly. If a sweep took the velocities, too, as they
  //! were, it would be \f$ \phi\,\omega\,\Delta t \f$. Progress is measured by
  //!
  //! \f{equation}{ w_K = \frac{\sum_i \|r_i^{K+1} - r_i^K\|}{\sum_i \|r_i^1 - r_i^L\|}, \tag{$w_K$} \label{eq:w} \f}
  //!
  //! a denominator that stays the one of the first sweep. Only so is \f$ w_{K+1}/w_K \f$ the contraction: over a
  //! displacement that changes from sweep to sweep the ratio would mix the two.

  report::Table limits(
      {"omega Dt [-]", "phi = 1 [-]", "phi = 1/2 [-]", "phi = 1, velocities lag [-]", "Verlet, growth per step [-]"});
  Springs spring{Eigen::VectorXd::Ones(1)};
  const SpringsAsRates spring_as_rates{spring};
  const schemes::State drawn{.t = 0.0, .r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)};
  double off_spring = 0.0;
  for (const double dt : {0.5, 0.999, 1.001, 1.5, 1.999, 2.001}) {
    const double eta = contraction_of(schemes::sweep_by_hand(schemes::BackwardEuler{}, spring, drawn, dt, 4));
    const double eta_middle = contraction_of(schemes::sweep_by_hand(schemes::PhiFamily<>(0.5), spring, drawn, dt, 4));
    const schemes::State drawn_values{.t = 0.0, .y = Eigen::Vector2d(1.0, 0.0)};
    const double lagging =
        contraction_of(schemes::sweep_by_hand(schemes::BackwardEuler{}, spring_as_rates, drawn_values, dt, 4));
    Eigen::Matrix2d step;
    for (Eigen::Index k = 0; k < 2; ++k) {
      const Eigen::Vector2d unit = Eigen::Vector2d::Unit(k);
      schemes::State to;
      schemes::VelocityVerlet{}.predict(spring, {.t = 0.0, .r = unit.head(1), .v = unit.tail(1)}, dt, to);
      step.col(k) << to.r, to.v;
    }
    // Its larger eigenvalue; two complex ones both have the modulus sqrt(det).
    const double mean = 0.5 * step.trace(), determinant = step.determinant(), square = mean * mean - determinant;
    const double growth = square < 0.0 ? std::sqrt(determinant) : std::abs(mean) + std::sqrt(square);
    limits.add({dt, eta, eta_middle, lagging, growth});
    off_spring = larger(off_spring, std::abs(eta / (dt * dt) - 1.0));
    off_spring = larger(off_spring, std::abs(eta_middle / (0.25 * dt * dt) - 1.0));
    off_spring = larger(off_spring, std::abs(lagging / dt - 1.0));
  }
  output.write("limits", limits);
  checks.add("contraction on a spring, relative to (phi omega Dt)^2 and, velocities lagging, phi omega Dt", off_spring,
             1e-11);

  //! @table{ch03_limits}
  //!
  //! Backward Euler's limit is \f$ \omega\,\Delta t < 1 \f$; that of \f$ \phi = 1/2 \f$ is \f$ \omega\,\Delta t < 2
  //! \f$, and there also ends the explicit velocity Verlet method, which is of second order as well and needs one force a
  //! step instead of one a sweep. At second order sweeps buy no accuracy on a smooth problem. What they buy is a
  //! built-in test of the step, which the next section uses, freedom in what the forces depend on, and, in
  //! @ref ch03_family "the family", order.
  //!
  //! Now several springs in one problem, their frequencies evenly spaced up to \f$ \omega \f$. The softer ones settle
  //! first, then the stiffest sets the slope, for the whole system:

  Springs springs{(Eigen::VectorXd::LinSpaced(p.springs, 1.0, p.springs) / p.springs).cwiseAbs2()};
  const SpringsAsRates springs_as_rates{springs};
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(p.springs), zeros = Eigen::VectorXd::Zero(p.springs);
  const schemes::State start{.t = 0.0, .r = ones, .v = zeros};
  schemes::State start_values{.t = 0.0, .y = Eigen::VectorXd(2 * p.springs)};
  start_values.y << ones, zeros;
  report::Table histories({"omega Dt [-]", "K", "phi = 1", "phi = 1/2", "velocities lag", "Anderson"});
  for (const double dt : {0.5, 0.9, 1.1}) {
    const std::array<schemes::Sweeps, 4> of{
        schemes::sweep_by_hand(schemes::BackwardEuler{}, springs, start, dt, p.sweeps),
        schemes::sweep_by_hand(schemes::PhiFamily<>(0.5), springs, start, dt, p.sweeps),
        schemes::sweep_by_hand(schemes::BackwardEuler{}, springs_as_rates, start_values, dt, p.sweeps),
        schemes::sweep_by_hand(schemes::PhiFamily<schemes::Anderson>(1.0, schemes::Anderson(3)), springs, start, dt,
                               p.sweeps)};
    for (std::size_t K = 0; K < of[0].iterations.size(); ++K) {
      histories.add(
          {dt, K, of[0].iterations[K].w_K, of[1].iterations[K].w_K, of[2].iterations[K].w_K, of[3].iterations[K].w_K});
    }
  }
  output.write("histories", histories);
}

}  // namespace ch03

//! @figure{ch03_histories, Error of the sweeps on springs of different stiffness\, for steps below\, near and above the limit of backward Euler.}
//!
//! With \f$ \phi = 1/2 \f$ a step twice as long does what \f$ \phi = 1 \f$ does. Velocities that lag cost twice the
//! sweeps. Mixing makes the most of several springs at once. What a run says whose sweeps diverge, and what it makes of
//! that, is @ref ch03_control "the next page".
//!
//! @section ch03_stability_exercises Exercises
//!
//! 1. Show that a sweep of \f$\eqref{eq:phi}\f$ on a spring contracts by \f$ (\phi\,\omega\,\Delta t)^2 \f$. Which
//!    order of force, velocity and position makes it \f$ \phi\,\omega\,\Delta t \f$, and why do its errors then come in
//!    pairs?
