//! @page ch03_schemes Chapter 3: Iterative solution schemes
//! @brief Implicit steps solved by sweeps: when the sweeps contract, and how that chooses the step.
//! @tableofcontents
//!
//! @section ch03_question What a step costs, and what it may be
//!
//! Chapter 3 of the monograph @cite zohdi2007 moves the particles of the first two chapters in time. Its schemes are
//! implicit: the forces that move a particle over a step are those at the end of the step, which nobody knows yet. So
//! they are guessed, the step is made, the forces are taken where it ended, and the step is made again. One such pass
//! over all particles is a *sweep*. The chapter's idea is to let the sweeps choose the step: if they settle too slowly
//! the step was too long, if they settle at once it could have been longer.
//!
//! Four questions follow. What does implicitness buy, if it is solved in this way? How fast do the sweeps settle? What
//! does a step that is steered by them promise about the answer, and what not? And what changes when several fields
//! are solved in turn (7.5.1, 7.5.2)? The second half of the program, @subpage ch03_family, takes the same sweeps to
//! high order. Build and run both with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch03_schemes
//! build/release/bin/ch03_schemes --out ch03
//! @endverbatim
//!
//! It takes some seconds. Every parameter below is an option (`--help` lists them), a run writes the `parameters.toml`
//! that repeats it, and the exit status says whether every check at the end of either page held.
//!
//! @section ch03_program The program
//!
//! It needs the schemes, the two coupled fields of section 7.5.2, a scene, its exact motion, and the report.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <Eigen/LU>

#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/checks.hpp>
#include <particulate/report/command_line.hpp>
#include <particulate/report/stamp.hpp>
#include <particulate/report/table.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/sweeps.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch03_family.hpp"
#include "logged.hpp"

namespace {

using namespace particulate;

//! @subsection ch03_parameters Parameters

struct Parameters {
  double TOL = 1e-6;       // tolerance of the sweeps [-], ours
  int K_d = 5;             // desired contractions [-], ours
  double limit = 0.01;     // Dt_lim, as a share of the pair's period [-], ours
  double stiffness = 0.1;  // repulsion of the pair that is steered, attraction being 1 [N m^3/kg^2], ours
  double softness = 0.5;   // repulsion of the pair whose error is looked at [N m^3/kg^2], ours
  double rough = 0.004;    // Dt_lim of the run that meets TOL and is wrong, as a share of the period [-], ours
  int springs = 8;         // of different stiffness, in one problem [-], ours
  int sweeps = 21;         // whose errors are drawn [-], ours
  double coupling = 3.0;   // a_12 = -a_21 of two decaying fields, a_11 = a_22 = 1 [1/s], ours
  double beyond = 1.002;   // their step, over the one at which staggering stops to contract [-], ours
  double duration = 4.0;   // of their decay [s], ours
};

void describe(report::CommandLine& line, Parameters& p) {
  const std::string ours = "our choice";
  line.field(p.TOL, {"tolerance", "of the sweeps, TOL", "-", report::between(1e-6, 1e-2), ours});
  line.field(p.K_d, {"desired", "contractions a step should take, K_d", "-", report::between(3, 100), ours});
  line.field(p.limit, {"limit", "Dt_lim, as a share of the pair's period", "-", report::between(1e-3, 0.1), ours});
  line.field(p.stiffness, {"stiffness", "repulsion of the steered pair, attraction 1", "N m^3/kg^2",
                           report::between(0.05, 0.6), ours});
  line.field(p.softness,
             {"softness", "repulsion where errors are looked at", "N m^3/kg^2", report::between(0.2, 0.5), ours});
  line.field(p.rough, {"rough", "Dt_lim of the run that is wrong, as a share of the period", "-",
                       report::between(0.004, 0.1), ours});
  line.field(p.springs, {"springs", "of different stiffness, in one problem", "-", report::between(1, 100), ours});
  line.field(p.sweeps, {"sweeps", "whose errors are drawn", "-", report::between(10, 60), ours});
  line.field(p.coupling, {"coupling", "a_12 = -a_21 of two decaying fields", "1/s", report::between(1.5, 20.0), ours});
  line.field(p.beyond, {"beyond", "their step over the last that contracts", "-", report::between(1.001, 2.0), ours});
  line.field(p.duration, {"duration", "of their decay", "s", report::between(1.0, 20.0), ours});
}

//! @subsection ch03_helpers A problem, a record, a single step
//!
//! Problems are small structs. These springs pull unit masses to the origin, the stiffest with the frequency
//! \f$ \omega = 1 \f$ per second, so that \f$ \omega\,\Delta t \f$ is the step:

struct Springs {
  Eigen::VectorXd squared;  // frequencies squared [1/s^2]
  bool acceleration(double, schemes::In r, schemes::Out a) const {
    a = -squared.cwiseProduct(r);
    return true;
  }
};

//! A step control is a value that answers three questions. Logged lets the algorithm of section 3.4 decide, and writes
//! down every attempt, the refused ones too:

using Logged = ch03::Logged<schemes::PhiControl>;

//! The same springs as values of first order, \f$ y = (r, v) \f$, so that a sweep takes the velocities as they were:

struct SpringsAsRates {
  Springs springs;
  bool rate(double t, schemes::In y, schemes::Out dy) const {
    const Eigen::Index n = y.size() / 2;
    dy.head(n) = y.tail(n);
    return springs.acceleration(t, y.head(n), dy.tail(n));
  }
};

//! A single step by hand is the guess, then so many sweeps. What is looked at is the change of the state in each of them,
//! as a Euclidean length, and beside it the library's own measure.

double change(const schemes::Sweeps& made, std::size_t k) {
  const schemes::State &before = made.iterates[k], &after = made.iterates[k + 1];
  return (after.r - before.r).norm() + (after.y - before.y).norm();
}

//! What a run claims is kept in one table, a particulate::report::Checks, with the error that was seen and the error
//! that is allowed. Comparisons are written so that a NaN fails them.

int run(int argc, char** argv) {
  Parameters p;
  ch03::Family family;
  report::CommandLine line(
      {.name = "ch03_schemes",
       .summary = "Chapter 3: implicit steps, their sweeps, their control, staggered fields, high order.",
       .out = "ch03"});
  describe(line, p);
  ch03::describe(line, family);
  if (const std::optional<int> status = line.parse(argc, argv)) return *status;
  const report::Output output(line.common().out);
  const bool quick = line.common().quick;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  report::Checks checks;
  const auto larger = [](double worst, double x) { return x <= worst || std::isnan(worst) ? worst : x; };
  const auto contraction_of = [](const schemes::Sweeps& made) { return std::sqrt(change(made, 3) / change(made, 1)); };

  //! @section ch03_stability 1. The bargain of an implicit step
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

  const auto plane = [](std::complex<double> z) {
    return schemes::FirstOrderPair{.a = Eigen::Matrix2d{{-z.real(), z.imag()}, {-z.imag(), -z.real()}}};
  };
  const schemes::State one{.t = 0.0, .y = Eigen::Vector2d(1.0, 0.0)};
  const auto step_once = [&](auto scheme, std::complex<double> z) {
    schemes::FirstOrderPair problem = plane(z);
    schemes::State y = one;
    schemes::FixedStep control{.step = 1.0, .contractions = 5000};
    const schemes::Outcome outcome = schemes::integrate(problem, y, 1.0, scheme, control);
    return std::pair(outcome, outcome.status == schemes::Status::reached ? y.y : Eigen::VectorXd::Constant(2, nan));
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
  //! \f{equation}{ v_i^{L+1} = v_i^L + \frac{\Delta t}{m_i}\left(\phi\,\Psi_i^{L+1} + (1-\phi)\,\Psi_i^L\right), \qquad
  //!     r_i^{L+1} = r_i^L + \Delta t\left(\phi\,v_i^{L+1} + (1-\phi)\,v_i^L\right). \tag{R 3.3} \label{eq:phi} \f}
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
  //! @ref ch03_family "the second half", order.
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

  //! @figure{ch03_histories, Error of the sweeps on springs of different stiffness\, for steps below\, near and above the limit of backward Euler.}
  //!
  //! With \f$ \phi = 1/2 \f$ a step twice as long does what \f$ \phi = 1 \f$ does. Velocities that lag cost twice the
  //! sweeps. Mixing makes the most of several springs at once. What a run says when its step is too long and cannot
  //! shrink:

  report::Table refusals({"omega Dt [-]", "what the run says"});
  int refused = 0;
  for (const double dt : {1.001, 1.5}) {
    schemes::State state = drawn;
    schemes::BackwardEuler scheme;
    schemes::FixedStep control{.step = dt, .TOL = p.TOL, .contractions = p.K_d};
    const schemes::Outcome outcome = schemes::integrate(spring, state, 10.0, scheme, control);
    refused += outcome.failure == schemes::Failure::diverging && outcome.workable_step < 1.0;
    refusals.add({dt, outcome.reason});
  }
  output.write("refusals", refusals);
  checks.add("diverging sweeps are refused with a step that works: runs where not", 2.0 - refused, 0.0);

  //! @table{ch03_refusals}
  //!
  //! @section ch03_adaptive 4. The sweeps choose the step
  //!
  //! The step that the refusal names is the algorithm of section 3.4. Each sweep multiplies w by
  //! \f$ \eta = S\,\Delta t^p \f$, with \f$ p = 2 \f$ for forces that depend on positions and an S that depends on the
  //! problem, so after K of them \f$ w_K = (S\,\Delta t^p)^K\,w_0 \f$. One step tells S, and S tells which step would
  //! have met a tolerance TOL after exactly \f$ K_d \f$ contractions:
  //!
  //! \f{equation}{ \Delta t^{new} = \Phi_K\,\Delta t, \qquad
  //!     \Phi_K = \frac{(TOL/w_0)^{1/(p K_d)}}{(w_K/w_0)^{1/(p K)}}. \tag{$\Phi_K$} \label{eq:phik} \f}
  //!
  //! Sweep until \f$ w_K \le TOL \f$, at most \f$ K_d \f$ contractions. If that is met, the step stands and the next
  //! one is \f$ \min(\Phi_K\,\Delta t, \Delta t_{lim}) \f$; if not, the state at the start of the step is restored and
  //! the step made again, with \f$ \Phi_K\,\Delta t \f$, which is then smaller. How much a step may grow or shrink at
  //! once is bounded; particulate::schemes::PhiControl names the bounds and their reasons.
  //!
  //! Two bodies in the near field of chapter 1, exponents two and three, are a hard test with a known answer: they fall
  //! together from rest, turn in a fraction of the time of the fall, and part again.

  const auto scene_of = [](double stiffness) {
    const kinematics::Particles two{.position = kinematics::Vectors{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}},
                                    .velocity = kinematics::Vectors::Zero(2, 3),
                                    .mass = Eigen::VectorXd::Ones(2),
                                    .radius = Eigen::VectorXd::Zero(2)};
    return scenes::Scene(two, kinematics::Space{},
                         laws::NearField{.alpha1 = 1.0, .alpha2 = stiffness, .beta1 = 2.0, .beta2 = 3.0});
  };
  const auto exact_of = [](double stiffness) {
    return kinematics::Breathing(kinematics::breathing_pair(1.0, stiffness, 1.0, 1.0), 1.0);
  };
  const auto separation = [](const schemes::State& m) { return m.r[1] - m.r[0]; };
  // Largest error of the separation at any step until t_end, and how the run went.
  const auto follow = [&](double stiffness, double phi, double t_end, auto& control, report::Table* path = nullptr) {
    const scenes::Scene scene = scene_of(stiffness);
    const kinematics::Breathing exact = exact_of(stiffness);
    schemes::State state = scenes::start(scene);
    schemes::PhiFamily<> scheme(phi);
    double worst = 0.0;
    const schemes::Outcome outcome =
        schemes::integrate(scene, state, t_end, scheme, control, [&](const auto&, const auto& to, double, const auto&) {
          const double r = exact.at(to.t).r, t = to.t / exact.period();
          worst = larger(worst, std::abs(separation(to) - r));
          if (path != nullptr) path->add({t, separation(to), r});
          return true;
        });
    return std::pair(outcome, outcome.status == schemes::Status::reached ? worst : nan);
  };

  const double period = exact_of(p.stiffness).period();
  Logged log{.control = {.TOL = p.TOL, .K_d = p.K_d, .step = p.limit * period, .limit = p.limit * period}};
  report::Table path({"time [periods]", "separation [m]", "closed form [m]"});
  const auto [steered, error_of_steered] = follow(p.stiffness, 0.5, period, log, &path);
  output.write("path", path);
  report::Table steps(
      {"time [periods]", "accepted step [periods]", "refused step [periods]", "contraction [-]", "aimed at [-]"});
  double above_TOL = 0.0;
  for (const Logged::Entry& entry : log.entries) {
    const schemes::Iteration& it = entry.made.iteration;
    const double aim = std::pow(p.TOL / it.w_0, 1.0 / p.K_d),
                 seen = it.K > 0 ? std::pow(it.w_K / it.w_0, 1.0 / it.K) : 0.0;
    const double t = entry.t / period, dt = entry.made.dt / period;
    steps.add({t, entry.accepted ? report::Cell(dt) : report::Cell(),
               entry.accepted ? report::Cell() : report::Cell(dt), seen, aim});
    if (entry.accepted) above_TOL = larger(above_TOL, it.w_K / p.TOL - 1.0);
  }
  output.write("steps", steps);
  checks.add("a steered run reaches its end [s]", steered.t - period, 0.0);
  checks.add("every step that stands meets TOL: w_K/TOL - 1 at most", above_TOL, 0.0);

  const schemes::Sweeps on_spring = schemes::sweep_by_hand(schemes::BackwardEuler{}, spring, drawn, 0.3, 4);
  const schemes::Iteration& it = on_spring.iterations.back();
  checks.add("on a spring Phi_K Dt = (TOL/w_0)^(1/(2 K_d))/omega, relative",
             schemes::phi_K(it, p.TOL, p.K_d) * 0.3 / std::pow(p.TOL / it.w_0, 1.0 / (2.0 * p.K_d)) - 1.0, 1e-8);

  //! @figure{ch03_steps, A steered pair about its turn: its separation\, the steps (accepted\, and refused ones as crosses)\, and the contraction of the sweeps beside the one that the controller aims at.}
  //!
  //! While the bodies fall, \f$ \Delta t_{lim} \f$ rules. On the way in the repulsion stiffens from step to step, and
  //! \f$ \Phi_K \f$ knows only the step it has seen: each one is tried too long, refused and made again. On the way out
  //! steps grow as fast as they may. In between they are what the sweeps can bear, \f$ \Delta t \propto 1/\omega \f$,
  //! without anybody having named a frequency: that is what the algorithm is for. The same run with other tolerances and
  //! other \f$ K_d \f$:

  report::Table counts({"TOL [-]", "K_d", "steps", "refused", "sweeps", "sweeps per step", "shortest step [periods]",
                        "largest error [m]"});
  for (const double TOL : {1e-3, 1e-6, 1e-9}) {
    for (const int K_d : {5, 10, 20}) {
      Logged of{.control = {.TOL = TOL, .K_d = K_d, .step = p.limit * period, .limit = p.limit * period}};
      const auto [outcome, error] = follow(p.stiffness, 0.5, period, of);
      double least = of.control.limit;
      for (const Logged::Entry& entry : of.entries) {
        if (entry.accepted && entry.t + entry.made.dt < period) least = std::min(least, entry.made.dt);
      }
      counts.add({TOL, K_d, outcome.steps, outcome.rejections, outcome.sweeps,
                  static_cast<double>(outcome.sweeps) / static_cast<double>(outcome.steps), least / period, error});
    }
  }
  output.write("counts", counts);

  //! @table{ch03_counts}
  //!
  //! Sweeps that are wanted longer make steps longer, a tighter tolerance makes them shorter where the sweeps rule, and
  //! both cost what one expects. Only the last column follows no rule. It is the subject of the next section.
  //!
  //! @section ch03_truncation 5. The tolerance is met, and the answer is wrong
  //!
  //! Nothing so far has asked whether the equation of a step is any good. The sweeps solve it to TOL; but a step of
  //! backward Euler is off by a term in \f$ \Delta t^2 \f$ even if it is solved exactly, and no \f$ w_K \f$ can see
  //! that. We follow a softer pair with the monograph's \f$ \phi = 1 \f$, limit its step to a small part of the period,
  //! and compare with the closed form:

  const double soft_period = exact_of(p.softness).period();
  const double rough = p.rough * soft_period;
  report::Table promise({"TOL [-]", "steps", "largest w_K/TOL [-]", "largest error / initial separation [-]"});
  double missing = 0.0, broken = 0.0;
  for (const double TOL : {1e-3, 1e-6, 1e-9}) {
    Logged of{.control = {.TOL = TOL, .K_d = 20, .step = rough, .limit = rough}};
    const auto [outcome, error] = follow(p.softness, 1.0, soft_period, of);
    double largest = 0.0;
    for (const Logged::Entry& entry : of.entries) {
      if (entry.accepted) largest = larger(largest, entry.made.iteration.w_K / TOL);
    }
    promise.add({TOL, outcome.steps, largest, error});
    missing = larger(missing, std::max(0.1 - error, 0.0));
    broken = larger(broken, largest - 1.0);
  }
  output.write("promise", promise);
  checks.add("TOL is met in each step of the runs that are wrong: w_K/TOL - 1 at most", broken, 0.0);
  checks.add("and their answer is off by a tenth or more: what is missing", missing, 0.0);

  //! @table{ch03_promise}
  //!
  //! Every tolerance is met in every step, and every answer is off by more than a tenth. Tightening TOL changes
  //! nothing, because the iteration is not where the error is: backward Euler damps the motion, as it damps everything.
  //! Only \f$ \Delta t_{lim} \f$ helps, or a better \f$ \phi \f$:

  report::Table truncation({"Dt_lim [periods]", "phi = 1, TOL 1e-2 [m]", "phi = 1, TOL 1e-6 [m]",
                            "phi = 1, TOL 1e-10 [m]", "phi = 1/2, TOL 1e-2 [m]", "phi = 1/2, TOL 1e-6 [m]",
                            "phi = 1/2, TOL 1e-10 [m]"});
  for (int k = 0; k < 9; ++k) {
    const double limit = 0.1 * std::pow(0.5, k);
    std::vector<report::Cell> row{limit};
    for (const double phi : {1.0, 0.5}) {
      for (const double TOL : {1e-2, 1e-6, 1e-10}) {
        schemes::PhiControl control{
            .TOL = TOL, .K_d = p.K_d, .step = limit * soft_period, .limit = limit * soft_period};
        row.emplace_back(follow(p.softness, phi, soft_period, control).second);
      }
    }
    truncation.add(std::move(row));
  }
  output.write("truncation", truncation);

  //! @figure{ch03_truncation, Largest error of the pair's separation through one period against the limit of the step. Dotted: slopes one and two.}
  //!
  //! Where \f$ \Delta t_{lim} \f$ rules, all tolerances fall on one line, of slope one for \f$ \phi = 1 \f$ and two for
  //! \f$ \phi = 1/2 \f$. They part on the right, where a tight tolerance shortens the steps by itself and the error
  //! falls by accident; and on the far left, where the coarsest begins to show in an error as small as that. So a
  //! result of the algorithm needs two runs with different \f$ \Delta t_{lim} \f$ before anybody should believe it: the
  //! verification holds the library to that (@ref verify_ch03_iteration_error_only "iteration_error_only").
  //!
  //! @section ch03_staggering 6. Fields solved in turn
  //!
  //! Section 7.5.1 carries the same idea to fields of different kinds, temperature beside motion: solve one with the
  //! others frozen, then the next, and sweep over all of them until none changes. Each field has its own measure
  //! \f$\eqref{eq:w}\f$ of progress, tolerance and exponent; a step stands if every field meets its own, and the
  //! smallest \f$ \Phi_K \f$ rules. Section 7.5.2 tries it on two pairs of equations,
  //!
  //! \f[ a\,\dot w_1 + w_2 = 0,\quad b\,\dot w_2 + w_1 = 0 \qquad\text{and}\qquad a\,\ddot w_1 + w_2 = 0,\quad
  //!     b\,\ddot w_2 + w_1 = 0, \f]
  //!
  //! where everything is known. With backward Euler in each field, a sweep that uses the newest values (Gauss-Seidel)
  //! contracts by \f$ \Delta t^2/(ab) \f$ and \f$ \Delta t^4/(ab) \f$; one that uses those of the last sweep (Jacobi),
  //! by the square roots. We add a third pair, which decays and turns:
  //!
  //! \f{equation}{ \dot w_1 = -a_{11} w_1 - a_{12} w_2, \quad \dot w_2 = -a_{21} w_1 - a_{22} w_2, \qquad
  //!     \eta = \left|\frac{\Delta t^2\,a_{12}\,a_{21}}{(1 + \Delta t\,a_{11})(1 + \Delta t\,a_{22})}\right|.
  //!     \tag{R 7.5.2} \label{eq:stagger} \f}

  const schemes::FirstOrderPair first{.a = Eigen::Matrix2d{{0.0, 1.0}, {1.0, 0.0}}};
  const schemes::SecondOrderPair second{.c12 = 1.0, .c21 = 1.0};
  const schemes::FirstOrderPair decaying{.a = Eigen::Matrix2d{{1.0, p.coupling}, {-p.coupling, 1.0}}};
  const auto fields = [&](int exponent, double TOL_1, double TOL_2) {
    return std::vector<schemes::Field>{{.name = "w_1", .TOL = TOL_1, .p = exponent},
                                       {.name = "w_2", .TOL = TOL_2, .p = exponent}};
  };
  const auto staggered_contraction = [&](const auto& pair, int unknowns, schemes::Seen seen, double dt) {
    const schemes::State from{.t = 0.0, .y = Eigen::VectorXd::LinSpaced(unknowns, 1.0, 2.0)};
    return contraction_of(schemes::sweep_by_hand(schemes::Staggered(fields(1, p.TOL, p.TOL), seen), pair, from, dt, 4));
  };
  report::Table staggering({"Dt [s]", "first order, newest", "first order, previous", "second order, newest",
                            "second order, previous", "decaying, newest", "decaying, theory"});
  double off_staggering = 0.0;
  for (int k = 0; k <= 20; ++k) {
    const double dt = 0.2 * std::pow(10.0, 0.05 * k), turn = p.coupling * dt / (1.0 + dt);
    const std::array<double, 5> theory{dt * dt, dt, std::pow(dt, 4), dt * dt, turn * turn};
    const std::array<double, 5> seen{staggered_contraction(first, 2, schemes::Seen::newest, dt),
                                     staggered_contraction(first, 2, schemes::Seen::previous, dt),
                                     staggered_contraction(second, 4, schemes::Seen::newest, dt),
                                     staggered_contraction(second, 4, schemes::Seen::previous, dt),
                                     staggered_contraction(decaying, 2, schemes::Seen::newest, dt)};
    staggering.add({dt, seen[0], seen[1], seen[2], seen[3], seen[4], theory[4]});
    for (std::size_t i = 0; i < 5; ++i) off_staggering = larger(off_staggering, std::abs(seen[i] / theory[i] - 1.0));
  }
  output.write("staggering", staggering);
  checks.add("contraction of staggered fields, relative to theory", off_staggering, 1e-6);

  //! @figure{ch03_staggering, Contraction of a staggered sweep: measured (points) and by theory (lines). Above one the sweeps diverge.}
  //!
  //! The third pair is stable in every sense: with \f$ a_{11} = a_{22} = 1 \f$ and \f$ a_{12} = -a_{21} \f$ both fields
  //! go round each other and die out like \f$ e^{-t} \f$, and backward Euler damps them at any step. Yet its sweeps
  //! diverge beyond \f$ \Delta t = 1/(a_{12} - 1) \f$. The physics is stable, the implicit scheme is stable, the
  //! staggering is not. We take a step a little longer than that, and try what there is: a fixed step, the same with
  //! the sweeps relaxed by Aitken's method (@cite kuettler2008), and steered steps with either field's tolerance
  //! tightened.

  const double last_step = 1.0 / (p.coupling - 1.0), too_long = p.beyond * last_step;
  const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
  const Eigen::Vector2d before(1.0, 0.5);
  report::Table cures(
      {"run", "outcome", "steps", "refused", "sweeps", "longest [s]", "w_1 ruled", "w_2 ruled", "apart [-]"});
  std::string says;
  double off_at_once = 0.0;
  const auto cure = [&](const std::string& name, schemes::Staggered scheme, auto control) {
    schemes::FirstOrderPair problem = decaying;
    schemes::State w{.t = 0.0, .y = before};
    Eigen::Vector2d at_once = before;
    double longest = 0.0;
    const schemes::Outcome outcome = schemes::integrate(problem, w, p.duration, scheme, control,
                                                        [&](const auto&, const auto&, double dt, const auto&) {
                                                          at_once = (identity + dt * decaying.a).inverse() * at_once;
                                                          longest = std::max(longest, dt);
                                                          return true;
                                                        });
    const bool reached = outcome.status == schemes::Status::reached;
    std::array<report::Cell, 2> ruled;
    if constexpr (requires { control.entries; }) {
      long by_first = 0;
      for (const Logged::Entry& entry : control.entries) by_first += entry.accepted && entry.after.controlling == "w_1";
      ruled = {by_first, outcome.steps - by_first};
    }
    cures.add({name, reached ? "reached" : "refused", outcome.steps, outcome.rejections, outcome.sweeps,
               reached ? report::Cell(longest) : report::Cell(), ruled[0], ruled[1],
               reached ? report::Cell((w.y - at_once).norm()) : report::Cell()});
    if (reached) {
      off_at_once = larger(off_at_once, (w.y - at_once).norm());
    } else {
      says = outcome.reason;
    }
    return reached;
  };
  const schemes::FixedStep fixed{.step = too_long, .TOL = 1.0, .contractions = p.K_d};
  const Logged steered_fields{.control = {.TOL = 1.0, .K_d = p.K_d, .step = too_long, .limit = too_long}};
  const bool plain = cure("fixed step", schemes::Staggered(fields(2, p.TOL, p.TOL)), fixed);
  const std::array<bool, 4> cured{
      cure("fixed step, Aitken", schemes::Staggered(fields(2, p.TOL, p.TOL), schemes::Seen::newest, schemes::Aitken{}),
           fixed),
      cure("steered", schemes::Staggered(fields(2, p.TOL, p.TOL)), steered_fields),
      cure("steered, w_1 tighter", schemes::Staggered(fields(2, 0.1 * p.TOL, p.TOL)), steered_fields),
      cure("steered, w_2 tighter", schemes::Staggered(fields(2, p.TOL, 0.1 * p.TOL)), steered_fields)};
  output.write("cures", cures);
  report::Table diagnosis({"quantity", "value"});
  diagnosis.add(
      {"contraction by the formula", fmt::format("{:.6f}", std::pow(p.coupling * too_long / (1.0 + too_long), 2))});
  diagnosis.add({"what the run says", says});
  output.write("diagnosis", diagnosis);
  checks.add("staggering beyond its limit at a fixed step is refused: runs where not", plain ? 1.0 : 0.0, 0.0);
  checks.add("relaxed or steered it reaches the end: runs where not",
             static_cast<double>(std::count(cured.begin(), cured.end(), false)), 0.0);
  checks.add("and gives what both fields solved at once give", off_at_once, 100.0 * p.TOL);

  //! @table{ch03_diagnosis}
  //!
  //! @table{ch03_cures}
  //!
  //! At the fixed step the run refuses, with the contraction it measured, which is the formula's, and the step it
  //! needs. Relaxation solves the step as it stands: only one number is carried from sweep to sweep, so Aitken's method
  //! is the secant method, which does not ask for a contraction. Steering shortens the step until the sweeps do their
  //! work in \f$ K_d \f$ contractions; many are tried a hair too long. With equal tolerances the first field rules most
  //! steps; tighten one, and that one does. The last column is the distance from both fields solved at once over the same
  //! steps: whatever the way, it is the same backward Euler step, of which section 5 holds unchanged.
  //!
  //! @section ch03_results What held
  //!
  //! Where an identity is claimed, the allowance is rounding, magnified by what stands between: a step near the pole of
  //! an implicit scheme, a contraction measured as a ratio of small changes of numbers of size one. The staggered runs
  //! stop at TOL in each of their steps, so their sum may be off by many TOL.

  output.write("checks", checks.table());
  const report::Checks of_family = ch03::run(family, output, quick);
  line.write_parameters();
  const std::string kernel(laws::name(laws::best_kernel()));
  report::write_stamp(output.folder(), report::make_stamp(line.line(), line.common().seed, kernel));
  fmt::print("{}\n{}", checks.table().text(), of_family.table().text());
  return checks.all_hold() && of_family.all_hold() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  return particulate::report::guarded("ch03_schemes", [&] { return run(argc, argv); });
}

//! @table{ch03_checks}
//!
//! The parameters of the run that made this page:
//!
//! @parameters{ch03}
//!
//! @section ch03_exercises Exercises
//!
//! 1. Show that a sweep of \f$\eqref{eq:phi}\f$ on a spring contracts by \f$ (\phi\,\omega\,\Delta t)^2 \f$. Which
//!    order of force, velocity and position makes it \f$ \phi\,\omega\,\Delta t \f$, and why do its errors then come in
//!    pairs?
//! 2. Give \f$ \phi = 1/2 \f$ and velocity Verlet the same number of forces on the soft pair. Which is more accurate,
//!    and by which factor? Where would you still take \f$ \phi = 1/2 \f$?
//! 3. Derive \f$\eqref{eq:phik}\f$, and with it the step at which a spring needs exactly \f$ K_d \f$ contractions.
//!    Compare with the table of refusals for another `--desired`.
//! 4. Lower `--stiffness`. How do refused steps and sweeps grow, and does a smaller first guess of the step help? Try a
//!    control of your own that also looks at how the contraction changed from step to step.
//! 5. Raise `--rough`, then `--tolerance`. Which of the two does the table of section 5 notice? How small must
//!    \f$ \Delta t_{lim} \f$ be for an error below a hundredth, with \f$ \phi = 1 \f$ and with \f$ \phi = 1/2 \f$?
//! 6. Choose \f$ a_{12} = +a_{21} \f$ for the decaying pair. When is the physics stable, when do the sweeps contract,
//!    and is there a case where they contract although the physics grows?
