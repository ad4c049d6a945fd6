//! @page ch07_heat Chapter 7: What becomes of heat
//! @brief After the impact: convection, radiation and a reaction that runs away, against closed forms; and staggering.
//! @tableofcontents
//!
//! @section ch07_heat_question Stage II
//!
//! Between impacts a sphere exchanges heat with what surrounds it (particulate::thermo::Cooling),
//!
//! \f[ m\,c\,\dot\theta = -h_c\, a_s\, (\theta - \theta_o) - B\,\varepsilon\, a_s\, (\theta^4 - \theta_s^4), \qquad
//!     a_s = 4\pi b^2, \f]
//!
//! by convection and by radiation. Each alone has a closed form: an exponential, and of radiation the time that a
//! temperature takes (particulate::thermo::radiation_time),
//!
//! \f[ 4 k\, \theta_s^3\, t = F(\theta_0) - F(\theta), \qquad
//!     F(x) = \ln\left|\frac{x - \theta_s}{x + \theta_s}\right| - 2 \arctan\frac{x}{\theta_s}, \qquad
//!     k = \frac{B \varepsilon a_s}{m c}. \f]
//!
//! What heats itself is the opposite extreme. A reaction after Arrhenius (particulate::thermo::Arrhenius),
//! \f$ \dot\theta = B_r\, e^{-T_a/\theta} \f$, hardly goes on for a long time, and then is over at once. It reaches a
//! temperature at the time (particulate::thermo::runaway_time)
//!
//! \f[ t = G(\theta) - G(\theta_0), \qquad
//!     G(x) = \frac1{B_r} \left(x\, e^{T_a/x} - T_a \operatorname{Ei}(T_a/x)\right). \f]
//!
//! Both are stiff: 1e4 K cool at a rate that falls by a factor of many thousands on the way. Temperatures are then a
//! field of their own, and collocation at Radau's three nodes with Newton iteration (Radau 5) takes steps that the
//! slope at the start does not bound.
//!
//! @section ch07_heat_program The program

#include <cmath>
#include <numbers>
#include <type_traits>

#include <particulate/contact/contact.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/scenes/staggered_scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/arrhenius.hpp>
#include <particulate/thermo/cooling.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {
namespace {

//! A grain of 1 mm is enough. It runs for as long as the closed form says, and should then be as warm as that.

kinematics::Particles grain(double theta) {
  return kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                 .mass = 2000.0 * 4.0 / 3.0 * std::numbers::pi * 1e-9,
                                 .radius = 1e-3,
                                 .temperature = theta,
                                 .heat_capacity = 1000.0}});
}

struct Ran {
  double theta;
  long steps, evaluations;
};

template <class Law>
Ran run_for(double seconds, double theta_start, const Law& law) {
  const scenes::Scene scene(grain(theta_start), kinematics::Space{}, law);
  scenes::Temperatures<std::remove_cvref_t<decltype(scene)>> field{scene, start(scene)};
  schemes::State state{.t = 0.0, .y = field.at.y};
  const schemes::Outcome outcome = integrate(
      field, state, seconds, schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>{},
      schemes::ErrorControl{.TOL = 1e-10, .sweep_TOL = 1e-12});
  require_end(outcome);
  return {state.y[0], outcome.steps, outcome.evaluations};
}

void after_the_impact(const report::Output& output, report::Checks& checks) {
  report::Table table({"case", "from [K]", "to [K]", "time by the closed form [s]", "relative error of the run there",
                       "steps", "evaluations"});
  double worst = 0.0;
  const auto add = [&](const char* name, double from, double to, double seconds, const auto& law) {
    const Ran ran = run_for(seconds, from, law);
    table.add({name, from, to, seconds, ran.theta / to - 1.0, ran.steps, ran.evaluations});
    worst = worse_of(worst, std::abs(ran.theta / to - 1.0));
  };
  const kinematics::Particles one = grain(theta_0);
  const double capacity = one.mass[0] * one.heat_capacity[0], a_s = thermo::surface(one.radius[0]);
  const double tau = capacity / (50.0 * a_s), k = thermo::stefan_boltzmann * a_s / capacity;
  add("convection", 1000.0, thermo::convected_temperature(1000.0, 350.0, tau, 2.0 * tau), 2.0 * tau,
      thermo::Cooling{.h_c = 50.0, .theta_o = 350.0});
  for (const double theta_s : {0.0, 300.0}) {
    add(theta_s > 0.0 ? "radiation to 300 K" : "radiation to 0 K", 1e4, 500.0,
        thermo::radiation_time(k, 1e4, 500.0, theta_s), thermo::Cooling{.emissivity = 1.0, .theta_s = theta_s});
  }
  for (const double theta : {310.0, 400.0, 500.0}) {
    add("runaway", 300.0, theta, thermo::runaway_time(1e12, 1e4, 300.0, theta),
        thermo::Arrhenius{.power = 1e12 * one.heat_capacity[0], .T_a = 1e4});
  }
  output.write("stage_two", table);
  checks.add("Stage II and runaway: relative error of a temperature where the closed form says when", worst, 1e-8);
}

//! @section ch07_heat_staggering Motion and temperatures in turn
//!
//! A general scheme solves the fields in turn until they agree. @ref ch03_fields "Chapter 3" shows it, with the two
//! semi-analytical examples of section 7.5.2: how fast such sweeps contract, and where they diverge although the
//! physics is stable. It is not done again here. *In this chapter heat does not act back within a step*: no force asks
//! for a temperature, and softening changes only what an impact at the end of a step does. The first sweep then is
//! right, and the second finds nothing to change. We let a cloud show it:

double sweeps_beyond_two(const Parameters& p) {
  const scenes::Scene scene(cloud_in({}, 50, {1.0, 0.1, 0.1}, {1.0, 0.1, 0.1}, p.c, seed_of(p, 0)), kinematics::Space{},
                            near_field, contact_with(cold), thermo::Cooling{.h_c = 10.0, .emissivity = 1.0});
  auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::PhiFamily(0.5));
  schemes::State state = start(scene);
  const schemes::Outcome outcome =
      integrate(fields, state, 20.0 * p.step, schemes::Staggered({{.name = "motion"}, {.name = "temperatures"}}),
                schemes::FixedStep{.step = p.step, .TOL = 1.0});
  require_end(outcome);
  return static_cast<double>(outcome.sweeps - 2 * outcome.steps);
}

}  // namespace

void heat(const Parameters& p, report::Chapter& chapter) {
  report::Checks& checks = chapter.claims("checks");
  after_the_impact(chapter.output(), checks);
  checks.add("motion and temperatures in turn: sweeps beyond two a step", sweeps_beyond_two(p), 0.0);
  const kinematics::Particles one = cloud_in({}, 1, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, p.c, 1);
  chapter.summary().add({"time in which convection of 10 W/(m^2 K) cools a sphere of the cloud [s]",
                         one.mass[0] * p.c / (10.0 * thermo::surface(radius))});
}

}  // namespace ch07

//! @section ch07_heat_results What comes of it
//!
//! @table{ch07_stage_two}
//!
//! Each line is a run to the time that a closed form gives. A runaway takes most of that time for its first few
//! kelvins, and hardly any for the rest. An error made early grows as the rate does, by
//! \f$ e^{T_a/\theta_0 - T_a/\theta} \f$, which is why its lines err more and more, for all that every step was held to
//! the same tolerance.
//!
//! For the clouds of this chapter Stage II is of no importance. The time in which convection cools one of their spheres
//! stands @ref ch07_results "among the results", and a flight lasts a second. It matters where grains are small, and in
//! chapter 8, where a fluid carries their heat away.
//!
//! @section ch07_heat_exercises Exercises
//!
//! 1. How large must a sphere be for convection and radiation to cool it equally fast at 1000 K? Does the radius
//!    matter?
//! 2. Which temperature does a sphere end at with \f$ \theta_o = 350 \f$ K and \f$ \theta_s = 300 \f$ K? Find it by
//!    @ref particulate::thermo::equilibrium_temperature "the library's function", and from a run.
//! 3. How exactly can a run know its temperature at the time at which the runaway reaches 1000 K? At which temperature
//!    can rounding alone make any answer worthless?
//! 4. Let a force depend on temperature, as a spring that softens. How many sweeps does a step take now?
