//! @page ch08_element Chapter 8: Hot particles in an element
//! @brief A swarm of hot particles drags a cold fluid along, with and without near fields: Figures 8.3 to 8.5.
//! @tableofcontents
//!
//! @section ch08_element_question A swarm that stirs
//!
//! Hot particles come into a cold fluid that is at rest. How fast do both come to one velocity and one temperature?
//! And what does it matter that particles attract and repel each other?
//!
//! @figure{ch08_snapshots, Particles in a slice of the element\, with the arrows of their velocities\, and how fast the fluid is: Figure 8.3.}
//!
//! @section ch08_element_model Particles in a fluid (8.1.2)
//!
//! A particle is dragged, warmed and cooled (@ref ch08_drag has the drag),
//!
//! \f[ m_i\, \dot v_i = \Psi_i^{drag} + \Psi_i^{near} , \f]
//! \f[ m_i\, c_i\, \dot\theta_i = h_c\, a_s\, (\theta_f - \theta_i)
//!     - B\,\varepsilon\, a_s\, (\theta_i^4 - \theta_s^4) + a_v\, D_i, \qquad
//!     D_i = \Psi_i^{drag} \cdot (v_f - v_i) \ge 0 , \f]
//!
//! with the share \f$ a_v \f$ of what drag dissipates. The fluid loses the impulse, the work and the heat that the
//! particle gets; so it keeps the rest of the dissipation. Radiation leaves them both. Around a particle a fluid is
//! read as a mean with weights, products of hats of the half-width w, and by the same weights it is pushed. So what one
//! gets the other loses, to the last digit.
//!
//! At the end everything moves with one velocity and has one temperature. Momentum and energy know them beforehand,
//! with M for masses and C for heat capacities of all:
//!
//! \f[ v^* = \frac1M \Big( \int \rho v + \sum_i m_i v_i \Big), \qquad
//!     \theta^* = \frac1C \Big( E - \tfrac12 M\, v^* \cdot v^* \Big) . \f]
//!
//! @section ch08_element_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/fluid/snapshot.hpp>
#include <particulate/kinematics/starts.hpp>
#include <particulate/scenes/snapshot.hpp>
#include <particulate/thermo/cooling.hpp>

#include "ch08_fluid.hpp"

namespace ch08 {
namespace {

kinematics::Particles hot_particles(const Parameters& p) {
  const std::function<double()> uniform = kinematics::uniform_from(p.line.common().seed);
  const double b = 0.25 / std::cbrt(p.particles), m = 2000.0 * 4.0 / 3.0 * std::numbers::pi * b * b * b;
  kinematics::Space space;
  space.lengths = {1.0, 1.0, 1.0};
  const kinematics::Vectors places =
      kinematics::random_addition(Eigen::VectorXd::Constant(p.particles, b), {.domain = space}, uniform).position;
  std::vector<kinematics::Particle> all;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    const Eigen::Vector3d way(2.0 * uniform(), 0.2 * uniform(), 0.2 * uniform());
    all.push_back({.position = places.row(i),
                   .velocity = way,
                   .mass = m,
                   .radius = b,
                   .temperature = 600.0,
                   .heat_capacity = 1000.0});
  }
  return kinematics::particles(all);
}

}  // namespace

Element element_of(const Parameters& p, const Makeup& makeup) {
  const Eigen::Index n = makeup.n;
  return {
      LiquidFlow<3>(Grid<3>{.cells = {n, n, n}},
                    {.state = {.Y = makeup.Y}, .viscosity = {p.mu}, .c = 2500.0, .K = 2500.0 * p.mu}, {}),
      hot_particles(p), Spreading{.w = makeup.w}, HeatExchange{.h_c = p.h_c, .emissivity = 1.0, .a_v = 0.5},
      laws::NearField{.alpha1 = 0.5 * makeup.near, .alpha2 = 0.1 * makeup.near, .cutoff = makeup.d_c, .taper = 0.15}};
}

State start_of(const Element& element) {
  return element.start([](const Vector<3>&) { return Local<3>{.rho = 1000.0, .theta = 300.0}; });
}

namespace {

//! A second of each: without a near field, with it, and with one that ends where its attraction is strongest, at the
//! distance \f$ d^* = 2 d_e \f$ of @ref ch07_truncation "chapter 7". The classical Runge-Kutta scheme is the cheapest
//! here (@ref ch08_particle_steps).

struct Course {
  const char* name;
  double near, d_c;
  std::optional<Element> element = {};
  std::vector<State> moments = {};
};

constexpr int moments = 40;

void run_course(const Parameters& p, Eigen::Index n, Course& course) {
  course.element.emplace(element_of(p, {.n = n, .near = course.near, .d_c = course.d_c}));
  State state = start_of(*course.element);
  follow("hot particles", *course.element, state, equal_times(1.0, moments),
         [&](const State& at) { course.moments.push_back(at); });
}

Eigen::VectorXd temperatures(const Element& element, const State& at) { return at.y.tail(element.particles().size()); }

//! What they come to, from momentum and energy alone:

struct Common {
  Eigen::Vector3d v;
  double theta;
};

Common common_of(const Element& element, const State& at) {
  const Totals all = element.totals(at);
  const kinematics::Particles& p = element.particles();
  const double M = all.mass + p.mass.sum(), C = element.flow().fluid().c * all.mass + p.mass.dot(p.heat_capacity);
  const Eigen::Vector3d v = all.momentum / M;
  return {v, (all.energy - 0.5 * M * v.squaredNorm()) / C};
}

double fluid_temperature(const Element& element, const State& at) {
  double sum = 0.0;
  for (Eigen::Index q = 0; q < element.flow().grid().size(); ++q) sum += element.local(at, q).theta;
  return sum / static_cast<double>(element.flow().grid().size());
}

void add_means(const Course& course, report::Table& table) {
  for (const State& at : course.moments) {
    const kinematics::Vectors v = velocities(at);
    const Eigen::Vector3d mean = v.colwise().mean();
    const Common common = common_of(*course.element, at);
    table.add({course.name, at.t, mean[0], mean[1], mean[2], v.rowwise().norm().mean(),
               temperatures(*course.element, at).mean(), fluid_temperature(*course.element, at), common.v[0],
               common.v[1], common.v[2], common.theta});
  }
}

//! Pictures are of a slice a fifth of a metre thick, particles where they are in the first period, and of the fluid's
//! cells in its middle.

double rounded(double x) { return std::round(1000.0 * x) / 1000.0; }

void add_pictures(const Course& course, report::Table& particles, report::Table& fluid) {
  const Grid<3>& grid = course.element->flow().grid();
  int picture = 0;
  for (const State& at : course.moments) {
    const kinematics::Vectors r = positions(at), v = velocities(at);
    const Eigen::VectorXd theta = temperatures(*course.element, at);
    for (Eigen::Index i = 0; i < r.rows(); ++i) {
      const Eigen::Vector3d x = (r.row(i).array() - r.row(i).array().floor()).matrix();
      if (std::abs(x[2] - 0.5) > 0.1) continue;
      particles.add(
          {course.name, picture, rounded(x[0]), rounded(x[1]), rounded(v(i, 0)), rounded(v(i, 1)), rounded(theta[i])});
    }
    for (Eigen::Index k = 0; k < grid.cells[0] * grid.cells[1]; ++k) {
      const Eigen::Index i = k % grid.cells[0], j = k / grid.cells[0];
      const Vector<3> x = grid.centre({i, j, 0});
      const double speed = course.element->local(at, grid.index({i, j, grid.cells[2] / 2})).v.norm();
      fluid.add({course.name, picture, rounded(x[0]), rounded(x[1]), rounded(speed)});
    }
    ++picture;
  }
}

//! @section ch08_element_files Files for ParaView
//!
//! `element_00.vti` is the fluid and `particles_00.vtp` the particles in it, at one time, of the run with near fields.
//! Open both groups of files: they have the same numbers and times, and ParaView plays them side by side. Show the
//! fluid as a *slice* coloured by velocity, and particles as *Point Gaussian*, scaled by `radius` and coloured by
//! `temperature`.

void write_files(const Parameters& p, const Course& course, const report::Output& output) {
  for (std::size_t k = 0; p.files > 0 && k < course.moments.size(); k += static_cast<std::size_t>(p.files)) {
    const State& at = course.moments[k];
    const Element& element = *course.element;
    std::ostringstream fluid, particles;
    write_vtk(fluid, element.flow(), element.of_fluid(at));
    scenes::write_vtk(particles, element.particles(), element.domain(), element.of_particles(at));
    output.write_file(fmt::format("element_{:02}.vti", k), fluid.str());
    output.write_file(fmt::format("particles_{:02}.vtp", k), particles.str());
  }
}

//! @section ch08_element_books What is kept
//!
//! Mass and momentum, to rounding. Of energy, without a near field, all but what is radiated; that power is known at
//! each moment, and Simpson's rule adds it up.

double radiated(const Course& course) {
  const kinematics::Particles& p = course.element->particles();
  double sum = 0.0;
  for (std::size_t k = 0; k < course.moments.size(); ++k) {
    const Eigen::ArrayXd theta = temperatures(*course.element, course.moments[k]);
    const Eigen::ArrayXd fluxes = thermo::stefan_boltzmann * (theta.pow(4) - std::pow(300.0, 4));
    const double weight = k == 0 || k + 1 == course.moments.size() ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum += weight * thermo::surface(p.radius[0]) * fluxes.sum();
  }
  return sum * course.moments.back().t / (3.0 * moments);
}

void claim_books(const std::array<Course, 3>& courses, report::Checks& checks) {
  double mass = 0.0, momentum = 0.0;
  for (const Course& course : courses) {
    const Totals first = course.element->totals(course.moments.front()),
                 last = course.element->totals(course.moments.back());
    mass = report::worse_of(mass, std::abs(last.mass / first.mass - 1.0));
    momentum = report::worse_of(momentum, (last.momentum - first.momentum).norm() / first.momentum.norm());
    if (&course != courses.data()) continue;
    checks.add("particles and fluid: energy that is lost over what is radiated, less 1",
               (first.energy - last.energy) / radiated(course) - 1.0, 1e-5);
  }
  checks.add("particles and fluid: mass over that at the start, less 1", mass, 1e-13);
  checks.add("particles and fluid: change of momentum over what it was", momentum, 1e-12);
}

}  // namespace

void element_with_particles(const Parameters& p, report::Chapter& chapter) {
  constexpr double d_star = 0.4;  // [m]
  std::array<Course, 3> courses{{{"none", 0.0, 0.45}, {"as it is", p.near, 0.45}, {"ended at d*", p.near, d_star}}};
  report::for_each_run("hot particles", 3, p.line.common().threads, [&](int k) {
    run_course(p, chapter.common().quick ? 16 : 32, courses[static_cast<std::size_t>(k)]);
  });
  report::Table means({"near field", "t [s]", "v_x [m/s]", "v_y [m/s]", "v_z [m/s]", "speed [m/s]", "theta [K]",
                       "theta of the fluid [K]", "common v_x [m/s]", "common v_y [m/s]", "common v_z [m/s]",
                       "common theta [K]"});
  report::Table particles({"near field", "picture", "x", "y", "v_x", "v_y", "theta"}),
      fluid({"near field", "picture", "x", "y", "speed"});
  report::Table end({"near field", "mean of v_x [m/s]", "common v_x [m/s]", "mean speed [m/s]", "mean theta [K]",
                     "common theta [K]"});
  for (const Course& course : courses) {
    add_means(course, means);
    if (course.d_c != d_star) add_pictures(course, particles, fluid);
    const State& at = course.moments.back();
    const Common common = common_of(*course.element, at);
    end.add({course.name, velocities(at).col(0).mean(), common.v[0], velocities(at).rowwise().norm().mean(),
             temperatures(*course.element, at).mean(), common.theta});
  }
  claim_books(courses, chapter.claims("checks"));
  write_files(p, courses[1], chapter.output());
  chapter.output().write("means", means);
  chapter.output().write("snapshots", particles);
  chapter.output().write("slice", fluid);
  chapter.output().write("end", end);
}

}  // namespace ch08

//! @section ch08_element_results Velocity and temperature in time
//!
//! @figure{ch08_means, Means of the particles\, with near fields on the left and without on the right: Figures 8.4 and 8.5. Grey: the velocity and the temperature that both would have in common.}
//!
//! @table{ch08_end}
//!
//! Particles slow down fast at first, as drag grows faster than the slip does, and ever more slowly after. Heat goes by
//! an exponential, as convection is linear; radiation takes a share that no figure would show. Both fall to what
//! momentum and energy demand.
//!
//! With near fields the mean *velocity* and the mean temperature hardly differ: a force between two particles cancels
//! in the sum. The mean *speed* does. It falls as it does without, turns, and rises; in the snapshots the swarm has
//! gathered into clumps. That is no property of the fluid. A swarm in which attraction outweighs repulsion, summed over
//! all distances, is not stable, and most of what is left over here comes from beyond \f$ d^* \f$. There
//! @ref ch07_truncation "chapter 7" advises a near field to end. Ended so, the same one leaves the swarm as even as it
//! was, for this second at least, and the swarm comes to rest in the fluid. What near fields do to means is decided by
//! where they end.
//!
//! How far clumping gets within the second depends on the start. Other seeds give mean speeds that differ by tens of
//! percent, and mean velocities that differ as the momentum at the start does.
//!
//! @section ch08_element_film In motion
//!
//! @animation{ch08_swarm, The slice of the first figure in motion\, without (left) and with (right) near fields.}
//!
//! @section ch08_element_exercises Exercises
//!
//! 1. Take `--near 2`. Which of the means change? What would contact (particulate::contact::Contact), as a further law
//!    of the suspension, do to clumps?
//! 2. Take `--convection 0`. Do particles still cool? What heats them?
//! 3. Which \f$ a_v \f$ would you need to see the heat of drag in the temperatures? Estimate it from the kinetic
//!    energy.
//! 4. Ten times as heavy particles in the same fluid: which velocity do they come to, and how long does it take?
