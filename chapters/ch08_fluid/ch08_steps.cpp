//! @page ch08_steps Chapter 8: Which step a fluid allows
//! @brief What each mechanism allows each scheme, what sweeps choose for themselves, and what they cost.
//! @tableofcontents
//!
//! @section ch08_steps_question Why is my step so small?
//!
//! Every user of a flow code asks that some day. This one answers: it says what rules the step, and knows it
//! beforehand.
//!
//! @figure{ch08_step, The step that the monograph's algorithm takes\, in units of z. Dashed: where ten contractions should give a millionth.}
//!
//! @section ch08_steps_program The program

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <particulate/kinematics/starts.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/staggering.hpp>

#include "ch08_fluid.hpp"

namespace ch08 {
namespace {

//! @section ch08_limits What limits a step (8.4)
//!
//! Each mechanism has a time in which it does something to one cell: sound, carried along by the flow, crosses it;
//! viscosity and conduction even it out (particulate::fluid::Flow::step_limits). A scheme knows how many of these times
//! a step may span. A fixed step beyond that is refused, with the step that would do. An adaptive one is cut, and the
//! run says by what (particulate::schemes::Outcome::ruled).
//!
//! The monograph advances one field after another, each with the others frozen (particulate::schemes::Staggered):
//! density, then momentum, then energy. *One sweep* is explicit, and for sound a leapfrog; what the flow carries along
//! it drives, a little each step. *Swept until nothing changes* it is backward Euler, stable at any step. But sweeps
//! get there only if they contract, and the error of a wave they multiply by
//!
//! \f[ (c_s\, \Delta t)^2 \sum_a \frac{\sin^2 k_a h_a}{h_a^2} \le z^2, \qquad
//!     z = c_s\, \Delta t\, \Big( \sum_a \frac1{h_a^2} \Big)^{1/2} . \f]
//!
//! So the implicit scheme, made to take large steps, may take none above z = 1, where the explicit ones go to 2 and to
//! \f$ 2\sqrt2 \f$.

const schemes::Staggered in_turn({{.name = "density"}, {.name = "momentum"}, {.name = "energy"}});

template <class F>
void add_steps(const char* fluid, const F& flow, double rho, report::Table& table) {
  const State moving = flow.start([&](const Vector<3>&) { return Local<3>{.rho = rho, .v = {1.0, 0.0, 0.0}}; });
  for (const schemes::TimeScale& one : flow.step_limits(moving)) {
    table.add({fluid, one.name, step_of(schemes::RungeKutta4::spans(one.kind, 0), one),
               step_of(in_turn.spans(one.kind, 1), one), step_of(in_turn.spans(one.kind, 0), one)});
  }
}

LiquidFlow<3> element(const Parameters& p, Eigen::Index n, double Y) {
  return {Grid<3>{.cells = {n, n, n}},
          {.state = {.Y = Y}, .viscosity = {p.mu}, .c = 2500.0, .K = 2500.0 * p.mu},
          {},
          p.line.common().threads};
}

void write_steps(const Parameters& p, report::Chapter& chapter) {
  const Grid<3> grid{.cells = {24, 24, 24}};
  const LiquidFlow<3> water(grid, {.state = {.Y = 2.2e9}, .viscosity = {1e-3}, .c = 4181.0, .K = 0.6}, {});
  const GasFlow<3> air(grid, {.viscosity = {1.8e-5}, .c = 717.6, .K = 0.026}, {});
  report::Table table({"fluid", "mechanism", "RK4 [s]", "one sweep [s]", "converged sweeps [s]"});
  add_steps("liquid of the element", element(p, 24, p.Y), 1000.0, table);
  add_steps("the same, Y = 1e10 Pa", element(p, 24, 1e10), 1000.0, table);
  add_steps("water", water, 1000.0, table);
  add_steps("air", air, 1.2, table);
  chapter.output().write("steps", table);
}

//! @table{ch08_steps}
//!
//! Each mechanism alone, for a metre in 24 cells that moves at 1 m/s. Nothing stands where it does not matter. Sound
//! rules, in stiff fluids by orders of magnitude: hence the element's liquid is a soft one. As long as it moves slowly
//! against its sound, it does what a stiffer one would. In it alone one sweep has another limit: what a step of forward
//! Euler adds to whatever the flow carries must stay small.
//!
//! @section ch08_sweeps What sweeps cost
//!
//! The monograph's step adapts: it shall be such that sweeps meet a tolerance TOL after \f$ K_d \f$ contractions, here
//! a millionth after ten (particulate::schemes::PhiControl). If each contracts by \f$ z^2 \f$, that should settle at
//! \f$ z = TOL^{1/(2 K_d)} \f$. We let sound run through the element, with a little noise in every cell, and count.

struct Taken {
  State state;
  schemes::Outcome outcome;
};

template <class S, class C, class Observer = schemes::Unobserved>
Taken taken(const LiquidFlow<3>& flow, const State& start, double end, S scheme, C control, Observer observer = {}) {
  State state = start;
  schemes::Outcome outcome = integrate(flow, state, end, scheme, control, observer);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error("the element: " + describe(outcome));
  return {std::move(state), std::move(outcome)};
}

State disturbed(const LiquidFlow<3>& flow, double c_s, const std::function<double()>& uniform) {
  return flow.start([&](const Vector<3>& x) {
    const Vector<3> noise(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5),
        wave = (2.0 * std::numbers::pi * x).array().sin();
    return Local<3>{.rho = 1000.0, .v = 1e-3 * c_s * (wave + 0.01 * noise)};
  });
}

void adaptive(const Parameters& p, report::Chapter& chapter) {
  const Eigen::Index n = chapter.common().quick ? 16 : 24, N = n * n * n;
  const LiquidFlow<3> flow = element(p, n, p.Y);
  const double c_s = std::sqrt(p.Y / 1000.0), end = 0.9 / c_s,
               unit = 1.0 / (c_s * std::sqrt(3.0) * static_cast<double>(n));  // of z [s]
  const State start = disturbed(flow, c_s, kinematics::uniform_from(chapter.common().seed));
  report::Progress progress("sound in the element, adaptive steps", end);
  report::Table chosen({"t c_s/D", "z"}),
      cost({"scheme", "z", "steps", "refused", "sweeps", "right-hand sides", "error, relative"});
  const Taken exact = taken(flow, start, end, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.25 * unit});
  const auto add = [&](const char* scheme, const Taken& run) {
    const auto momentum = [&](const State& at) { return at.y.segment(N, 3 * N); };
    const schemes::Outcome& did = run.outcome;
    cost.add({scheme, end / unit / static_cast<double>(did.steps), did.steps, did.rejections, did.sweeps,
              did.evaluations, (momentum(run.state) - momentum(exact.state)).norm() / momentum(exact.state).norm()});
  };
  add("RK4", taken(flow, start, end, schemes::RungeKutta4{}, schemes::FixedStep{.step = 2.0 * unit}));
  add("one sweep", taken(flow, start, end, in_turn, schemes::FixedSweeps{.step = 1.6 * unit, .sweeps = 1}));
  // Tolerances are the fields' own, a millionth each; of these the control allows one.
  const schemes::PhiControl by_sweeps{.TOL = 1.0, .K_d = 10, .step = 0.1 * unit, .limit = end};
  const Taken swept =
      taken(flow, start, end, in_turn, by_sweeps, [&](const State& from, const State&, double dt, const auto&) {
        chosen.add({from.t * c_s, dt / unit});
        progress.at(from.t);
        return true;
      });
  add("sweeps, adaptive", swept);
  chapter.output().write("cost", cost);
  chapter.output().write("step", chosen);
  const auto energy = [&](const State& at) { return at.y.tail(N).sum(); };
  chapter.claims("checks").add("sound in the element, swept: energy over that at the start, less 1",
                               energy(swept.state) / energy(start) - 1.0, 1e-13);
}

}  // namespace

void steps(const Parameters& p, report::Chapter& chapter) {
  write_steps(p, chapter);
  adaptive(p, chapter);
}

}  // namespace ch08

//! @section ch08_steps_results A short step, and a dear one
//!
//! @table{ch08_cost}
//!
//! Errors are those of momentum, against the same system in small steps. A right-hand side is one of all fields for
//! RK4, and of one field for sweeps, of which three are about as much work.
//!
//! - *A step is short.* It settles near what the formula says, a fifth of what RK4 may take.
//! - *A step is dear.* RK4 has four right-hand sides, ten contractions cost eleven sweeps.
//! - *Steps are refused.* The algorithm aims at exactly \f$ K_d \f$ contractions. A step that meets its tolerance makes
//!   the next one longer, until one does not, and is made again. @ref ch08_attempts "Later pages" have the
//!   remedy.
//! - *It is of first order,* and damps waves as it goes, whatever the tolerance of its sweeps.
//!
//! What is bought is that the scheme needs no formula for any limit: it finds them by itself, of any number of fields
//! that are coupled in any way. For a fluid alone, where formulas are at hand, one sweep does as well by a fraction of
//! the work, and RK4 does better.
//!
//! @section ch08_steps_exercises Exercises
//!
//! 1. `PhiControl` with `K_d` of 4, 10 and 30: which is the cheapest? Derive the best from \f$ z = TOL^{1/(2 K_d)} \f$,
//!    with a step's costs as \f$ K_d + 1 \f$.
//! 2. Let the element's fluid move at 10 m/s. Which of the three schemes notices, and by which mechanism?
//! 3. How large must the viscosity be to rule the step of RK4? And of swept steps, in the same element?
