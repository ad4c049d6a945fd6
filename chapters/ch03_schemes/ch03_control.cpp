//! @page ch03_control Chapter 3: The sweeps choose the step
//! @brief The control of section 3.4: what it does well, and what it cannot see.
//! @tableofcontents
//!
//! If the sweeps settle too slowly the step was too long, if they settle at once it could have been longer. This page
//! steers a pair of bodies by that through a close turn, whose exact motion is known. Then it steers a pair whose every
//! step meets the tolerance, and whose answer is wrong.
//!
//! @section ch03_control_program The program

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! @section ch03_adaptive 4. The sweeps choose the step
//!
//! What a run says when its step is too long for the sweeps, and cannot shrink:

void control(const Parameters& p, const report::Output& output, report::Checks& checks) {
  Springs spring{Eigen::VectorXd::Ones(1)};
  const schemes::State drawn{.t = 0.0, .r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)};
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
    const auto two = kinematics::particles({{.position = {-0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                            {.position = {0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}});
    return scenes::Scene(two, kinematics::Space{},
                         laws::NearField{.alpha1 = 1.0, .alpha2 = stiffness, .beta1 = 2.0, .beta2 = 3.0});
  };
  const auto exact_of = [](double stiffness) {
    return kinematics::Breathing(kinematics::breathing_pair(1.0, stiffness, 1.0, 1.0), 1.0);
  };
  const auto separation = [](const schemes::State& m) { return position(m, 1).x() - position(m, 0).x(); };
  // Largest error of the separation at any step until t_end, and how the run went.
  const auto follow_scene = [&](double stiffness, double phi, double t_end, auto& control,
                                report::Table* path = nullptr) {
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
    return std::pair(outcome, outcome.status == schemes::Status::reached ? worst : no_number);
  };

  const double period = exact_of(p.stiffness).period();
  Steered log{.control = {.TOL = p.TOL, .K_d = p.K_d, .step = p.limit * period, .limit = p.limit * period}};
  report::Table path({"time [periods]", "separation [m]", "closed form [m]"});
  const auto [steered, error_of_steered] = follow_scene(p.stiffness, 0.5, period, log, &path);
  output.write("path", path);
  report::Table steps(
      {"time [periods]", "accepted step [periods]", "refused step [periods]", "contraction [-]", "aimed at [-]"});
  double above_TOL = 0.0;
  for (const Steered::Entry& entry : log.entries) {
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
      Steered of{.control = {.TOL = TOL, .K_d = K_d, .step = p.limit * period, .limit = p.limit * period}};
      const auto [outcome, error] = follow_scene(p.stiffness, 0.5, period, of);
      double least = of.control.limit;
      for (const Steered::Entry& entry : of.entries) {
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
    Steered of{.control = {.TOL = TOL, .K_d = 20, .step = rough, .limit = rough}};
    const auto [outcome, error] = follow_scene(p.softness, 1.0, soft_period, of);
    double largest = 0.0;
    for (const Steered::Entry& entry : of.entries) {
      if (entry.accepted) largest = larger(largest, entry.made.iteration.w_K / TOL);
    }
    promise.add({TOL, outcome.steps, largest, error});
    missing = larger(missing, std::max(0.1 - error, 0.0));
    broken = larger(broken, largest - 1.0);
  }
  output.write("promise", promise);
  checks.add("TOL is met in each step of the runs that are wrong: w_K/TOL - 1 at most", broken, 0.0);
  checks.add("the answer of these runs is off by a tenth or more: what is missing", missing, 0.0);

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
        row.emplace_back(follow_scene(p.softness, phi, soft_period, control).second);
      }
    }
    truncation.add(std::move(row));
  }
  output.write("truncation", truncation);
}

}  // namespace ch03

//! @figure{ch03_truncation, Largest error of the pair's separation through one period against the limit of the step. Dotted: slopes one and two.}
//!
//! Where \f$ \Delta t_{lim} \f$ rules, all tolerances fall on one line, of slope one for \f$ \phi = 1 \f$ and two for
//! \f$ \phi = 1/2 \f$. They part on the right, where a tight tolerance shortens the steps by itself and the error
//! falls by accident; and on the far left, where the coarsest begins to show in an error as small as that. So a
//! result of the algorithm needs two runs with different \f$ \Delta t_{lim} \f$ before anybody should believe it: the
//! verification holds the library to that (@ref verify_ch03_iteration_error_only "iteration_error_only").
//!
//! @section ch03_control_exercises Exercises
//!
//! 1. Give \f$ \phi = 1/2 \f$ and velocity Verlet the same number of forces on the soft pair. Which is more accurate,
//!    and by which factor? Where would you still take \f$ \phi = 1/2 \f$?
//! 2. Derive \f$\eqref{eq:phik}\f$, and with it the step at which a spring needs exactly \f$ K_d \f$ contractions.
//!    Compare with the table of refusals for another `--desired`.
//! 3. Lower `--stiffness`. How do refused steps and sweeps grow, and does a smaller first guess of the step help? Try a
//!    control of your own that also looks at how the contraction changed from step to step.
//! 4. Raise `--rough`, then `--tolerance`. Which of the two does the table of section 5 notice? How small must
//!    \f$ \Delta t_{lim} \f$ be for an error below a hundredth, with \f$ \phi = 1 \f$ and with \f$ \phi = 1/2 \f$?
