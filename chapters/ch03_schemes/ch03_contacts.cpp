//! @page ch03_contacts Chapter 3: Contacts where they happen, and what long runs keep
//! @brief The moment of a contact to the order of the method, and the energy of a motion over many periods.
//! @tableofcontents
//!
//! Between its ends a step of the family is a polynomial. This page reads the moment of an event off it, and shows that
//! an impact may be located to rounding where a step of fixed length is late by a part of itself. Then it watches the
//! error of energy over many periods, which some methods keep within bounds and others let grow.
//!
//! @section ch03_contacts_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/crossing.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! @section ch03_located 11. Contacts where they happen
//!
//! Between its ends a step is a polynomial, so the moment at which something happens can be read off it. That reading
//! is of lower order than the end of the step. But the step can be shortened to the moment, solved again, and read
//! again until it stands: then the moment has the order of the method (particulate::schemes::Watch). We ask when the
//! mild pair is half-way to its closest, in three ways:

void contacts(const Parameters& p, const report::Output& output, bool quick, report::Checks& checks) {
  const Pair mild(p.mildness);
  const double period = mild.exact.period();
  using Four = schemes::Gauss<4>;
  const double level = 0.5 * (1.0 + mild.exact.nearest());
  const double moment = [&] {
    const auto over = [&](double t) { return mild.exact.at(t).r - level; };
    return schemes::bracketed_root(over, 0.0, over(0.0), 0.5 * period, over(0.5 * period));
  }();
  report::Table events({"steps per period", "end of the step [s]", "read off [s]", "located [s]"});
  std::vector<std::array<double, 3>> off_moment;
  for (int n = 16; n <= 200; n = n * 5 / 4) {
    std::array<double, 3> off{no_number, no_number, no_number};
    schemes::State state = Pair::start(), there;
    schemes::Collocation<Four> scheme;
    schemes::FixedStep control{.step = period / n};
    const auto read = [&](const auto& from, const auto& to, double dt, const auto& made) {
      if (to.r[0] >= level) return true;
      const auto over = [&](double theta) {
        made.at(from, dt, theta, there);
        return there.r[0] - level;
      };
      off[0] = std::abs(to.t - moment);
      off[1] = std::abs(from.t + dt * schemes::bracketed_root(over, 0.0, over(0.0), 1.0, over(1.0)) - moment);
      return false;
    };
    schemes::Outcome outcome = schemes::integrate(mild.problem, state, period, scheme, control, read);
    state = Pair::start();
    scheme.forget();
    schemes::Watch watch({{.function = [&](const schemes::State& at) { return at.r[0] - level; },
                           .direction = schemes::Direction::falling,
                           .name = "near"}});
    outcome = schemes::integrate(mild.problem, state, period, scheme, control, watch);
    if (outcome.status == schemes::Status::stopped) off[2] = std::abs(state.t - moment);
    events.add({n, off[0], off[1], off[2]});
    off_moment.push_back(off);
  }
  output.write("family_events", events);
  checks.add("a located event with eight steps to the passage is off by [s]", off_moment.front()[2], 1e-6);
  checks.add("and a located event with the finest steps is off by [s]", off_moment.back()[2], 1e-13);

  //! The same with contact. A ball falls on a floor and rises again with e times its speed, so the moments of its
  //! impacts, \f$ t_1 (1 + 2 e + 2 e^2 + \dots) \f$ with \f$ t_1 = \sqrt{2h/g} \f$, come ever closer and end at
  //! \f$ t_1 (1+e)/(1-e) \f$. A stepped contact, that of @ref ch02_stepped "chapter 2", is found at the end of a step; a
  //! particulate::contact::LocatedContact ends the step. It is for bodies that forces act on between their impacts. Without
  //! any, from impact to impact they fly straight, and the gas of hard spheres of @ref ch04_gas "chapter 4" takes over:
  //! the same impacts, without a scheme.

  const double g = 9.81, first_impact = std::sqrt(2.0 * p.drop / g);
  const auto ball = kinematics::particles({{.position = {0.0, 0.0, p.drop + 0.1}, .mass = 1.0, .radius = 0.1}});
  const kinematics::Space floor{{kinematics::Wall{}}};
  const laws::Gravity gravity{.g = {0.0, 0.0, -g}};
  const scenes::Scene stepped(ball, floor, gravity, contact::Contact<>{.restitution = {p.e}});
  const scenes::Scene located(ball, floor, gravity, contact::LocatedContact<>{.restitution = {p.e}});
  struct Bounce {
    schemes::Outcome outcome;
    double off;  // of the first three impacts, the largest [s]
  };
  const auto bounce = [&](const auto& scene, auto scheme, double dt, double t_end) {
    schemes::State state = scenes::start(scene);
    schemes::FixedStep control{.step = dt};
    int impacts = 0;
    double off = 0.0, due = first_impact;
    const schemes::Outcome outcome =
        schemes::integrate(scene, state, t_end, scheme, control, [&](const auto&, const auto& to, double, const auto&) {
          if (impacts == 3 || !(position(to, 0).z() - 0.1 <= 1e-11 && velocity(to, 0).z() < 0.0)) return true;
          off = larger(off, std::abs(to.t - due));
          due += 2.0 * std::pow(p.e, ++impacts) * first_impact;
          return true;
        });
    return Bounce{outcome, impacts == 3 ? off : no_number};
  };
  const double third = first_impact * (1.0 + 2.0 * p.e + 2.0 * p.e * p.e);
  report::Table bounces({"step [s]", "stepped [s]", "located [s]"});
  double off_located = 0.0, off_stepped = 0.0;
  for (int k = 0; k < 24; ++k) {
    const double dt = 0.0973 * std::pow(10.0, -0.125 * k) * first_impact;
    const double late = bounce(stepped, schemes::VelocityVerlet{}, dt, third + 3.0 * dt).off;
    const double off = bounce(located, schemes::Collocation<schemes::Gauss<2>>(), dt, third + 0.5 * dt).off;
    bounces.add({dt, late, off});
    off_located = larger(off_located, off);
    off_stepped = larger(off_stepped, late / dt);
  }
  output.write("family_bounces", bounces);
  checks.add("moments of located impacts, whatever the step [s]", off_located, 1e-11);
  // A flight that begins as deep as a step of the fall lacks 1/e steps of its rise, in each of the two that count.
  checks.add("moments of stepped impacts are off by a few steps at most", off_stepped, 1.0 + 2.0 / p.e);
  const schemes::Outcome rest =
      bounce(located, schemes::Collocation<schemes::Gauss<2>>(), 0.1 * first_impact, 1e3 * first_impact).outcome;
  report::Table resting({"what the run says"});
  resting.add({rest.reason});
  output.write("family_resting", resting);
  checks.add("a ball that comes to rest ends a located run: runs where not",
             rest.failure == schemes::Failure::accumulating ? 0.0 : 1.0, 0.0);
  checks.add("that run knows when the ball rests [s]", rest.accumulation - first_impact * (1.0 + p.e) / (1.0 - p.e),
             1e-9);

  //! @figure{ch03_family_located, Left: error of the moment at which a separation is reached. Right: largest error of a ball's first three impacts.}
  //!
  //! @table{ch03_family_resting}
  //!
  //! The end of a step is late by up to a step, whatever the method. Reading the polynomial is better by orders, and
  //! solving anew restores the order of the method, or for the ball, whose flight the method solves exactly, leaves
  //! rounding alone. Infinitely many impacts no run can follow: it says so, and when they are over.
  //!
  //! @section ch03_structure 12. What long runs keep
  //!
  //! An error of energy that grows makes a cloud boil or freeze, however small it is in a step. Gauss methods are
  //! symplectic @cite hairer2006 if their equations are solved: energy errs by a bounded amount, for ever. So does
  //! Verlet's. We follow the mild pair for many periods and write down the largest relative error of its energy in each:

  const int periods = quick ? std::min(p.periods, 100) : p.periods;
  report::Table energies({"period", "Gauss 4, to rounding", "Gauss 4, two sweeps", "Verlet", "backward Euler"});
  report::Table drifts({"method", "steps per period", "forces per period", "largest in the first period [-]",
                        "largest in the last period [-]"});
  std::vector<std::vector<double>> largest;
  const auto drift = [&](const std::string& name, auto scheme, auto control, double n) {
    schemes::State state = Pair::start();
    const double E_0 = mild.problem.energy(state);
    Separation problem = mild.problem;
    std::vector<double> of(static_cast<std::size_t>(periods), 0.0);
    const schemes::Outcome outcome = schemes::integrate(
        problem, state, periods * period, scheme, control, [&](const auto&, const auto& to, double dt, const auto&) {
          const auto k = std::min(of.size() - 1, static_cast<std::size_t>((to.t - 0.5 * dt) / period));
          of[k] = larger(of[k], std::abs(problem.energy(to) / E_0 - 1.0));
          return true;
        });
    if (outcome.status != schemes::Status::reached) of.assign(of.size(), no_number);
    drifts.add({name, n, static_cast<double>(outcome.evaluations) / periods, of.front(), of.back()});
    largest.push_back(std::move(of));
  };
  drift("Gauss 4, to rounding", schemes::Collocation<Four>(), schemes::FixedStep{.step = period / 25.0}, 25);
  drift("Gauss 4, two sweeps", schemes::Collocation<Four>(), schemes::FixedSweeps{.step = period / 50.0, .sweeps = 2},
        50);
  drift("Verlet", schemes::VelocityVerlet{}, schemes::FixedStep{.step = period / 400.0}, 400);
  drift("backward Euler", schemes::BackwardEuler{}, schemes::FixedStep{.step = period / 160.0, .TOL = 1e-6}, 160);
  for (std::size_t k = 0; k < largest[0].size(); ++k) {
    energies.add({k + 1, largest[0][k], largest[1][k], largest[2][k], largest[3][k]});
  }
  output.write("family_energies", energies);
  output.write("family_drifts", drifts);
  // The largest of a quarter of all periods: where in its orbit a step falls differs from period to period.
  const auto growth = [&](const std::vector<double>& of) {
    const auto quarter = static_cast<std::ptrdiff_t>(of.size() / 4);
    return *std::max_element(of.end() - quarter, of.end()) / *std::max_element(of.begin(), of.begin() + quarter);
  };
  checks.add("Gauss solved to rounding: growth of the error of energy, less one", growth(largest[0]) - 1.0, 0.05);
  checks.add("Verlet: growth of the error of energy, less one", growth(largest[2]) - 1.0, 0.05);
  checks.add("Gauss after two sweeps: by how much less than twofold that error grows",
             std::max(0.0, 2.0 - growth(largest[1])), 0.0);
}

}  // namespace ch03

//! @figure{ch03_family_energies, Largest relative error of the energy of the mild pair in each period\, at about equal numbers of forces.}
//!
//! @table{ch03_family_drifts}
//!
//! Backward Euler loses the motion within a few periods. Verlet and Gauss keep a level, Gauss a much lower one for
//! the same forces. Cut off after two sweeps the same method is no longer symplectic, and its error grows in
//! proportion to time: the cheapest way to a short, accurate run is not the one to a long one. Momentum and more
//! bodies, over far longer times and beside CVODE, are the verification's (@ref verify_ch03_drift "drift").
//!
//! @section ch03_work 13. Error against run time
//!
//! The verification program races all of these, with velocity Verlet, Runge-Kutta and SUNDIALS, from one spring to a
//! thousand bodies: attained error against seconds and against right-hand sides, @ref guide_ch03_work. Five things are
//! worth looking for. The slopes: backward Euler pays one digit with ten times the steps, \f$ \phi = 1/2 \f$ and
//! Verlet with about three times as many. The distance between these two: a sweep costs what a step of Verlet costs.
//! Collocation: flat curves, which cross all others after a few digits; at fixed steps, cut off after two or three
//! sweeps, where motion is smooth, steered where bodies pass close by one another. The front against CVODE and ARKODE:
//! its ratios in each decade of the error are claims there, settings chosen on one seed and reported on others, and
//! where a goal is missed the case says so; they are claimed of SUNDIALS before 7.2, and of a later one shown and left
//! out. And stiff problems, where Newton's method meets that of CVODE.
//!
//! @section ch03_contacts_exercises Exercises
//!
//! 1. Give the ball of section 11 a spring to the floor. Does a stepped contact still converge, and with which order?
//! 2. Cut Gauss off after one, two, three, four sweeps in section 12. When is the growth of the error of energy lost in
//!    rounding over `--periods`?
