//! @page ch03_staggering Chapter 3: Fields solved in turn
//! @brief Staggered fields: how fast their sweeps contract, where they diverge, and what helps.
//! @tableofcontents
//!
//! Sections 7.5.1 and 7.5.2 belong here: sweeps over several fields, each solved with the others frozen. This page
//! measures how fast such sweeps contract, and shows a pair of fields that is stable, under an implicit scheme that is
//! stable, whose staggering diverges all the same; then what cures it.
//!
//! @section ch03_staggering_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>

#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! @section ch03_fields 6. Fields solved in turn
//!
//! Section 7.5.1 carries the same idea to fields of different kinds, temperature beside motion: solve one with the
//! others frozen, then the next, and sweep over all of them until none changes. Each field has its own measure of
//! progress (@ref ch03_sweep "section 3"), tolerance and exponent; a step stands if every field meets its own, and the
//! smallest \f$ \Phi_K \f$ rules. Section 7.5.2 tries it on two pairs of equations,
//!
//! \f[ a\,\dot w_1 + w_2 = 0,\quad b\,\dot w_2 + w_1 = 0 \qquad\text{and}\qquad a\,\ddot w_1 + w_2 = 0,\quad
//!     b\,\ddot w_2 + w_1 = 0, \f]
//!
//! where everything is known. With backward Euler in each field, a sweep that uses the newest values (Gauss-Seidel)
//! contracts by \f$ \Delta t^2/(ab) \f$ and \f$ \Delta t^4/(ab) \f$; one that uses those of the last sweep (Jacobi),
//! by the square roots. We add a third pair, which decays and turns:
//!
//! \f{equation}{ \begin{aligned}
//!     &\dot w_1 = -a_{11} w_1 - a_{12} w_2, \quad \dot w_2 = -a_{21} w_1 - a_{22} w_2,
//!     \\ &\eta = \left|\frac{\Delta t^2\,a_{12}\,a_{21}}{(1 + \Delta t\,a_{11})(1 + \Delta t\,a_{22})}\right|. \end{aligned}
//!     \tag{R 7.5.2} \label{eq:stagger} \f}

void staggering(const Parameters& p, const report::Output& output, report::Checks& checks) {
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
      for (const Steered::Entry& entry : control.entries)
        by_first += entry.accepted && entry.after.controlling == "w_1";
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
  const Steered steered_fields{.control = {.TOL = 1.0, .K_d = p.K_d, .step = too_long, .limit = too_long}};
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
  checks.add("staggering relaxed or steered reaches the end: runs where not",
             static_cast<double>(std::count(cured.begin(), cured.end(), false)), 0.0);
  checks.add("staggering gives what both fields solved at once give", off_at_once, 100.0 * p.TOL);
}

}  // namespace ch03

//! @table{ch03_diagnosis}
//!
//! @table{ch03_cures}
//!
//! At the fixed step the run refuses, with the contraction it measured, which is the formula's, and the step it
//! needs. Relaxation solves the step as it stands: only one number is carried from sweep to sweep, so Aitken's method
//! is the secant method, which does not ask for a contraction. Steering shortens the step until the sweeps do their
//! work in \f$ K_d \f$ contractions; many are tried a hair too long. With equal tolerances the first field rules most
//! steps; tighten one, and that one does. The last column is the distance from both fields solved at once over the same
//! steps: whatever the way, it is the same backward Euler step, of which @ref ch03_truncation "section 5" holds unchanged.
//!
//! @section ch03_staggering_exercises Exercises
//!
//! 1. Choose \f$ a_{12} = +a_{21} \f$ for the decaying pair. When is the physics stable, when do the sweeps contract,
//!    and is there a case where they contract although the physics grows?
