//! @page ch09_slow_heat Chapter 9: Fast light and slow heat
//! @brief Why rays and temperatures need not be solved in turn, how scatterers cool, and how warm a steady beam keeps them.
//! @tableofcontents
//!
//! @section ch09_slow_question Two times
//!
//! Section 9.6 solves for rays and temperatures in turn within each time step, until they agree, with step control
//! after chapter 3. What is there to agree on?
//!
//! @figure{ch09_seconds, Temperatures in seconds: after the pulse\, and in a beam that stays on.}
//!
//! @section ch09_slow_program The program

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <particulate/scattering/heat.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/integrate.hpp>

#include "ch09_scattering.hpp"

namespace ch09 {
namespace {

//! @section ch09_heat_staggering Why nothing is staggered
//!
//! Fields are solved in turn where they act on each other. Light acts on heat. For heat to act on light, what rays meet
//! must depend on temperature: the index, the size or the place of a sphere. Here \f$ \hat n \f$ is a constant. The
//! first sweep then is right, and the second finds nothing to change. We do it all the same, until temperatures agree to
//! the last bit:

Fresnel law_at(const Parameters& p, const Eigen::VectorXd& /*theta*/) { return {p.n_hat}; }

int sweeps(const Parameters& p, const Pulse& pulse) {
  const Eigen::VectorXd cold = start(pulse.bodies, theta_0).y;
  Eigen::VectorXd theta = cold, before;
  int sweep = 0;
  do {
    before = theta;
    const Traced traced = trace(pulse.cloud, law_at(p, theta), pulse.rays, {.threads = 1 + sweep % 2});
    theta = warmed_by(pulse.bodies, cold, traced.absorbed);
  } while (++sweep < 20 && theta != before);
  return sweep;
}

//! Nor is there a time step that both could share. Light has left the cloud before a sphere has noticed that it is
//! warm:

// In which a sphere would lose its rise of temperature at the rate at which it cools at first.
double cooling_time(const HeatedBodies& bodies, double theta) {
  return -bodies.capacity[0] * (theta - theta_0) / (bodies.surface[0] * thermo::heat_flux(radiation, theta));
}

void write_times(const Parameters& p, const Pulse& pulse, const Eigen::VectorXd& theta, const report::Output& output) {
  double longest = 0.0;
  for (const PathPoint& one : pulse.traced.paths) longest = std::max(longest, one.length);
  report::Table table({"what takes the time", "time [s]"});
  table.add({"light, to cross the cube", p.edge / speed_of_light});
  table.add({"the last ray, to leave it", longest / speed_of_light});
  table.add({"the hottest sphere, to cool", cooling_time(pulse.bodies, theta.maxCoeff())});
  table.add({"a sphere of the mean temperature, to cool", cooling_time(pulse.bodies, theta.mean())});
  output.write("times", table);
}

//! So a pulse is a fluence. All that counts of it is the energy that each sphere has absorbed.
//!
//! @section ch09_slow_seconds Seconds
//!
//! What is left is an equation for each sphere, after the pulse with \f$ P = 0 \f$, in a beam that stays on with the
//! watts that tracing gives. Rates fall by orders of magnitude on the way: Radau's nodes with Newton iteration, as for
//! @ref ch07_heat "Stage II of chapter 7".

std::vector<Eigen::VectorXd> temperatures(const HeatedBodies& bodies, const Eigen::VectorXd& theta,
                                          const std::vector<double>& times) {
  schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>> scheme;
  schemes::ErrorControl control{.TOL = 1e-8, .sweep_TOL = 1e-10};
  schemes::State state{.y = theta};
  std::vector<Eigen::VectorXd> at_times;
  for (const double t : times) {
    const schemes::Outcome outcome = integrate(bodies, state, t, scheme, control);
    if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
    at_times.push_back(state.y);
  }
  return at_times;
}

//! The power of each sphere comes from many rays in equal parts of the beam, so that spheres differ by where they are,
//! and not by chance.

HeatedBodies lit(const Parameters& p, const Pulse& pulse) {
  Beam steady = small_beam(p, p.irradiance);
  steady.points = Beam::Points::stratified;
  const Rays rays = rays_of(steady, 250 * 250, uniform_from(seed_of(p, 0)));
  HeatedBodies bodies = pulse.bodies;
  bodies.power = trace(pulse.cloud, Fresnel{p.n_hat}, rays, {.threads = p.line.common().threads}).absorbed;
  return bodies;
}

//! A lone sphere absorbs \f$ (1 - F)\, I\, \pi b^2 \f$, and radiates from four times its shadow:
//! \f$ \theta^4 = \theta_s^4 + (1 - F)\, I/(4 B) \f$, whatever its size.

void write_depth(const Parameters& p, const Cloud<Sphere>& cloud, const Eigen::VectorXd& theta,
                 report::Chapter& chapter) {
  const double F = sphere_reflectance(Fresnel{p.n_hat});
  const double lone =
      std::pow(std::pow(theta_0, 4) + (1.0 - F) * p.irradiance / (4.0 * thermo::stefan_boltzmann), 0.25);
  report::Table table({"x/D", "from the middle of the beam, the larger of y and z, over D", "temperature [K]",
                       "that of a lone sphere [K]"});
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    const Eigen::Vector3d centre = cloud.bodies()[static_cast<std::size_t>(i)].centre / p.edge;
    table.add({centre[0], (centre.tail<2>().array() - 0.5).abs().maxCoeff(), theta[i], lone});
  }
  chapter.output().write("depth", table);
  chapter.summary().add({"a lone sphere in the steady beam [K]", lone});
  chapter.summary().add({"the hottest of the cloud there [K]", theta.maxCoeff()});
}

}  // namespace

void slow_heat(const Parameters& p, report::Chapter& chapter) {
  const Pulse first = pulse(p, 0);
  const HeatedBodies steady = lit(p, first);
  const Eigen::VectorXd cold = start(first.bodies, theta_0).y;
  const Eigen::VectorXd warm = warmed_by(first.bodies, cold, first.traced.absorbed);
  write_times(p, first, warm, chapter.output());
  std::vector<double> times;
  for (int k = 0; k <= 60; ++k) times.push_back(std::pow(10.0, 0.1 * k - 3.0));
  const auto cooling = temperatures(first.bodies, warm, times), heating = temperatures(steady, cold, times);
  report::Table table({"t [s]", "mean after the pulse [K]", "hottest after the pulse [K]",
                       "mean in the steady beam [K]", "hottest in the steady beam [K]"});
  for (std::size_t k = 0; k < times.size(); ++k) {
    table.add({times[k], cooling[k].mean(), cooling[k].maxCoeff(), heating[k].mean(), heating[k].maxCoeff()});
  }
  chapter.output().write("seconds", table);
  const Eigen::VectorXd end = equilibrium_temperatures(steady);
  write_depth(p, first.cloud, end, chapter);
  report::Checks& checks = chapter.claims("checks");
  checks.add("rays and temperatures in turn: sweeps beyond two", sweeps(p, first) - 2, 0.0);
  checks.add("steady beam: temperatures at the end of the run over those of equilibrium, less 1",
             (heating.back().array() / end.array() - 1.0).abs().maxCoeff(), 1e-8);
}

}  // namespace ch09

//! @section ch09_slow_results Fast light, slow heat
//!
//! @table{ch09_times}
//!
//! To cool means: to lose the rise of temperature, at the rate at which that begins. Many orders of magnitude lie
//! between light and the quickest of the spheres.
//!
//! After the pulse, the hottest sphere is the first to cool. Radiation evens out what absorption made uneven, and the
//! mean falls at its own, slower rate. In the steady beam it is the other way round: the hottest is at its end first,
//! as what radiates more settles sooner.
//!
//! @figure{ch09_depth, Where temperatures end in a steady beam\, against depth. The line is the closed form for a lone sphere.}
//!
//! Spheres at the front get the whole beam, as a lone one does, and are hotter: those behind them send light back. Farther
//! in each is shaded by those before it, until those at the far end of the beam are hardly warmer than those beside it,
//! which have little but scattered light.
//!
//! @section ch09_slow_exercises Exercises
//!
//! 1. Let `law_at` return an index that falls with the mean temperature. How many sweeps until temperatures agree to
//!    the last bit? By how much does each sweep shrink the change? Compare with @ref ch03_fields "chapter 3".
//! 2. How long may a pulse be for the hottest sphere to lose one per cent of its rise meanwhile? From which length on is
//!    it rather a steady beam?
//! 3. Half the edge of the cube, with everything in it. Which of the curves and tables change, and how?
//! 4. A sphere radiates to its neighbours as well. Give each the surroundings that its neighbours make. Is the front
//!    hotter or colder then?
