//! @page ch08_particle_steps Chapter 8: Steps and cells for particles in a fluid
//! @brief Which step the monograph's algorithm takes with particles, what rules it, and what results depend on.
//! @tableofcontents
//!
//! @section ch08_particle_steps_question Five fields in turn
//!
//! Particles, their temperatures, density, momentum and energy are solved in turn until they agree (8.4). The fields
//! are many, and so are the reasons for which sweeps may need a shorter step. Which is it?
//!
//! @figure{ch08_particle_step, The step that the algorithm takes with and without near fields\, and the steps that it was refused: Figure 8.6. Broken: what sound allows sweeps that converge.}
//!
//! @section ch08_particle_steps_program The program

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>

#include "ch08_fluid.hpp"

namespace ch08 {
namespace {

//! @section ch08_particle_limits What each mechanism allows
//!
//! A particle that is solved with its own drag implicit, and hands over to the fluid what it got, does not limit sweeps
//! by how fast it relaxes. It does by its weight: where particles weigh more than the fluid that their hats
//! cover, by a factor \f$ \Lambda > 1 \f$, sweeps contract by \f$ \Lambda\, a/(1 + a) \f$ with
//! \f$ a = \Delta t/\tau \f$ (particulate::fluid::Suspension::step_limits).

void write_limits(const Element& element, report::Table& table) {
  const schemes::Staggered sweeps = all_in_turn(1);
  for (const schemes::TimeScale& one : element.step_limits(start_of(element))) {
    table.add({one.name, step_of(schemes::RungeKutta4::spans(one.kind, 0), one),
               step_of(sweeps.spans(one.kind, 1), one), step_of(sweeps.spans(one.kind, 0), one)});
  }
}

//! @section ch08_attempts The step in time (8.6)
//!
//! A control that keeps a list of what was tried:

struct Try {
  double t, dt;
  bool accepted;
};

struct Told : schemes::PhiControl {
  std::vector<Try>* tries = nullptr;
  double t = 0.0;

  schemes::Decision judge(const schemes::Attempt& made) {
    const schemes::Decision decision = schemes::PhiControl::judge(made);
    tries->push_back({t, made.dt, decision.accepted});
    if (decision.accepted) t += made.dt;
    return decision;
  }
};

//! The monograph's control aims at exactly \f$ K_d \f$ contractions. Ours may aim at fewer than it allows
//! (particulate::schemes::PhiControl::spare), so that a step which needs one more than the last is not refused.
//!
//! It also must be told to which power p of the step a sweep contracts. For fields that only damp each other that is 1.
//! Sound contracts by \f$ z^2 \f$. Taken for 1, the control answers an error e of the logarithm of its step by -2e,
//! and then has the error -e: steps that are too short and too long in turn, for ever.

struct Swept {
  const char* field;  // with or without a near field
  double near, Y;
  int spare, p;
  std::vector<Try> tries = {};
  schemes::Outcome outcome = {};
  double sound = 0.0;  // the step that it allows at the start [s]
};

constexpr Eigen::Index coarse = 12;

double sound_of(double Y) { return std::sqrt(Y / 1000.0); }

void sweep(const Parameters& p, double end, Swept& run) {
  const Element element = element_of(p, {.n = coarse, .near = run.near, .Y = run.Y});
  State state = start_of(element);
  run.sound = element.step_limits(state).front().seconds;
  Told control{{.TOL = 1.0, .K_d = 10, .step = 0.3 * run.sound, .limit = end, .spare = run.spare}};
  control.tries = &run.tries;
  run.outcome = integrate(element, state, end, all_in_turn(run.p), control);
  if (run.outcome.status != schemes::Status::reached) throw std::runtime_error("sweeps: " + describe(run.outcome));
}

void figure_of_steps(const Parameters& p, report::Chapter& chapter) {
  const double end = chapter.common().quick ? 0.1 : 1.0;
  std::vector<Swept> runs{{"without", 0.0, 1e5, 0, 1},
                          {"with", p.near, 1e5, 0, 1},
                          {"without", 0.0, 1e5, 0, 2},
                          {"without", 0.0, 1e5, 2, 2},
                          {"with", p.near, 1e5, 2, 2}};
  if (!chapter.common().quick) runs.push_back({"without", 0.0, 1e5, 2, 1});
  report::for_each_run("sweeps with particles", static_cast<int>(runs.size()), p.line.common().threads,
                       [&](int k) { sweep(p, end, runs[static_cast<std::size_t>(k)]); });
  report::Table tries({"near field", "spare", "p", "t [s]", "step [s]", "accepted", "sound allows [s]"});
  report::Table spared({"near field", "aims at", "p", "steps", "refused", "sweeps", "mean step [s]"});
  for (const Swept& run : runs) {
    for (const Try& one : run.tries) {
      tries.add({run.field, run.spare, run.p, one.t, one.dt, one.accepted ? 1 : 0, run.sound});
    }
    spared.add({run.field, 10 - run.spare, run.p, run.outcome.steps, run.outcome.rejections, run.outcome.sweeps,
                end / static_cast<double>(run.outcome.steps)});
  }
  chapter.output().write("particle_step", tries);
  chapter.output().write("spared", spared);
}

//! @section ch08_stiffer Stiffer liquids
//!
//! In both cases the step is ruled by sound. If that is so, it must be the same number of h/c for a liquid of any
//! stiffness, and for all of them the element takes as many steps to let sound pass six cells.

void stiffer(const Parameters& p, report::Chapter& chapter) {
  std::vector<Swept> runs;
  for (int k = 5; k <= 10; ++k)
    runs.push_back({.field = "with", .near = p.near, .Y = std::pow(10.0, k), .spare = 2, .p = 2});
  const auto cell = [](const Swept& run) { return 1.0 / (static_cast<double>(coarse) * sound_of(run.Y)); };
  report::for_each_run("stiffer liquids", static_cast<int>(runs.size()), p.line.common().threads, [&](int k) {
    Swept& run = runs[static_cast<std::size_t>(k)];
    sweep(p, 6.0 * cell(run), run);
  });
  report::Table table({"Y [Pa]", "c_s [m/s]", "mean step [s]", "mean step c_s/h", "refused", "sweeps"});
  for (const Swept& run : runs) {
    const double mean = 6.0 * cell(run) / static_cast<double>(run.outcome.steps);
    table.add({run.Y, sound_of(run.Y), mean, mean / cell(run), run.outcome.rejections, run.outcome.sweeps});
  }
  chapter.output().write("stiffer", table);
}

//! @section ch08_cells Cells, and how far a particle reaches
//!
//! On grids of more and more cells, with a half-width w that stays, and with w = h, which is the linear interpolation
//! between the middles of cells.

struct Resolved {
  Eigen::Index n;
  bool fixed;
  double v = 0.0, theta = 0.0;
};

void resolve(const Parameters& p, Resolved& run) {
  const Element element = element_of(p, {.n = run.n, .w = run.fixed ? 1.0 / 8 : 1.0 / static_cast<double>(run.n)});
  State state = start_of(element);
  follow("cells", element, state, {0.0, 0.2}, [](const State&) {});
  run.v = velocities(state).col(0).mean();
  run.theta = state.y.tail(element.particles().size()).mean();
}

void cells(const Parameters& p, report::Chapter& chapter) {
  std::vector<Resolved> runs;
  std::vector<Eigen::Index> grids{8, 12, 16, 20, 24};
  if (!chapter.common().quick) grids.insert(grids.end(), {32, 40});
  for (const Eigen::Index n : grids) {
    for (const bool fixed : {true, false}) runs.push_back({.n = n, .fixed = fixed});
  }
  report::for_each_run("cells", static_cast<int>(runs.size()), p.line.common().threads,
                       [&](int k) { resolve(p, runs[runs.size() - 1 - static_cast<std::size_t>(k)]); });
  report::Table table({"w", "cells along an edge", "mean of v_x [m/s]", "mean theta [K]"});
  for (const Resolved& run : runs) table.add({run.fixed ? "1/8 m" : "h", run.n, run.v, run.theta});
  chapter.output().write("cells", table);
}

//! @section ch08_particle_order The step of the result
//!
//! And with shorter and shorter steps, against the classical Runge-Kutta scheme in very short ones.

struct Stepped {
  const char* scheme;
  double step;
  State state = {};
};

void take_steps(const Parameters& p, Stepped& run) {
  constexpr double end = 0.096;
  const Element element = element_of(p, {.n = coarse});
  run.state = start_of(element);
  const std::string scheme = run.scheme;
  const schemes::Outcome outcome =
      scheme == "RK4" ? integrate(element, run.state, end, schemes::RungeKutta4{}, schemes::FixedStep{.step = run.step})
                      : integrate(element, run.state, end, all_in_turn(1),
                                  schemes::FixedSweeps{.step = run.step, .sweeps = scheme == "one sweep" ? 1 : 6});
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(scheme + ": " + describe(outcome));
}

void shorter(const Parameters& p, report::Chapter& chapter) {
  std::vector<Stepped> runs{{"RK4", 1e-3},        {"RK4", 8e-3},       {"RK4", 4e-3},       {"RK4", 2e-3},
                            {"one sweep", 4e-3},  {"one sweep", 2e-3}, {"one sweep", 1e-3}, {"one sweep", 0.5e-3},
                            {"six sweeps", 2e-3}, {"six sweeps", 1e-3}};
  report::for_each_run("shorter steps", static_cast<int>(runs.size()), p.line.common().threads,
                       [&](int k) { take_steps(p, runs[static_cast<std::size_t>(k)]); });
  const State& exact = runs.front().state;
  const Eigen::Index N = p.particles;
  report::Table table({"scheme", "step [s]", "error of velocities, relative", "error of temperatures, relative"});
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const State& at = runs[k].state;
    table.add({runs[k].scheme, runs[k].step, (at.v - exact.v).norm() / exact.v.norm(),
               (at.y.tail(N) - exact.y.tail(N)).norm() / exact.y.tail(N).norm()});
  }
  chapter.output().write("shorter", table);
  const auto order = [&](std::size_t longer) {
    const auto error = [&](std::size_t k) { return (runs[k].state.v - exact.v).norm(); };
    return std::log2(error(longer) / error(longer + 1));
  };
  chapter.claims("checks").add("one sweep with particles: order of its error, less 1", order(6) - 1.0, 0.15);
}

}  // namespace

void steps_with_particles(const Parameters& p, report::Chapter& chapter) {
  report::Table limits({"mechanism", "RK4 [s]", "one sweep [s]", "converged sweeps [s]"});
  write_limits(element_of(p, {.n = coarse}), limits);
  chapter.output().write("limits", limits);
  figure_of_steps(p, chapter);
  stiffer(p, chapter);
  cells(p, chapter);
  shorter(p, chapter);
}

}  // namespace ch08

//! @section ch08_particle_steps_results What rules, and what it costs
//!
//! @table{ch08_limits}
//!
//! Each mechanism alone, at the start, in the element of the following runs, which has twelve cells along an edge.
//! Nothing stands where it does not matter. Particles would allow any scheme a step many times as long as sound does,
//! and near fields are not seen at all: *Figure 8.6 is one of sound, in both cases.* The monograph's liquid can be a
//! hundred thousand times as stiff as ours.
//!
//! @table{ch08_stiffer}
//!
//! In units of the time in which sound passes a cell the step is the same for all of them. In such a step of the
//! stiffest liquid a particle does next to nothing: a fluid whose sound does not matter is better computed by a method
//! that has none.
//!
//! @table{ch08_spared}
//!
//! The original control is refused nearly every second step, as its steps are too long and too short in turn. Told that
//! p is 2, it still aims at a line that half of its steps must miss. With two contractions to spare as well, hardly a
//! step is refused; it needs half of the sweeps, and its steps are nearly as long. A quick run shows the first tenth of
//! a second, a full one all of it, and there also what sparing alone does: it calms the control for a while only.
//!
//! @section ch08_particle_cells What a result depends on
//!
//! @figure{ch08_cells, Mean velocity of the particles after 0.2 s\, on grids of more and more cells.}
//!
//! With a w that stays, results converge as fast as the fluid does, and twelve cells are enough. *With w = h they do
//! not converge.* The fluid that a particle sees is more and more the one that it has pushed itself; with fine enough
//! cells each takes its own cell along, as if there were no drag. So w is a part of the model and not of the grid: it
//! says over which distance a particle disturbs the fluid. Five radii are the default. Slow particles can be corrected
//! for what they do to themselves (particulate::fluid::Spreading).
//!
//! @figure{ch08_shorter, Error of the particles' velocities\, over the step.}
//!
//! @table{ch08_shorter}
//!
//! Staggering is of first order, be it by one sweep or by many, and more sweeps do not make its error smaller. RK4
//! starts with the fourth order and loses some of it: hats have kinks, and a particle that moves by a cell meets
//! several.
//!
//! @section ch08_particle_discussion What we found (8.6, 8.7)
//!
//! The monograph's scheme is to adapt its step to whatever mechanism asks for it. It does. What asks here is sound, at
//! any time and in all cases, and the scheme finds a number that could be written down beforehand. It pays with ten
//! sweeps a step for a result of first order, which one sweep has as well, and exactly as conservative. Where particles
//! do outweigh their fluid, or react within a step, it is another matter: then sweeps find a step that no table like
//! ours has.
//!
//! @section ch08_particle_steps_exercises Exercises
//!
//! 1. Particles of which density make \f$ \Lambda > 1 \f$ in the element? Which step do sweeps then take?
//! 2. Derive the two-cycle of the control with a wrong p. What happens with p = 3?
//! 3. One particle in a large box, pushed by a steady force: how does its speed depend on w/b? Compare it with
//!    \f$ 1 + 6 \pi b/(g\, w) \f$, and try the correction.
