// What heat costs a step of ten thousand bound spheres whose near field is cut off.

#include <algorithm>
#include <cmath>
#include <ctime>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/uniform.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/table.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/binding.hpp>
#include <particulate/thermo/cooling.hpp>
#include <particulate/thermo/impact_heat.hpp>

namespace verification::heated_step_races {

using namespace particulate;
using kinematics::Space;

constexpr Eigen::Index N = 10000;
constexpr double spacing = 1.0, radius = 0.4;  // the mean spacing of a unit density [m]

// Spheres near the places of a lattice, so that none overlap, with random velocities.
kinematics::Particles spheres() {
  Uniform uniform(7);
  const auto edge = static_cast<Eigen::Index>(std::ceil(std::cbrt(static_cast<double>(N))));
  kinematics::Particles all{.position = kinematics::Vectors(N, 3),
                            .velocity = kinematics::Vectors(N, 3),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, radius),
                            .temperature = Eigen::VectorXd::Constant(N, 300.0),
                            .heat_capacity = Eigen::VectorXd::Ones(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    const std::array<Eigen::Index, 3> place{i % edge, i / edge % edge, i / (edge * edge)};
    for (Eigen::Index k = 0; k < 3; ++k) {
      all.position(i, k) = spacing * static_cast<double>(place[static_cast<std::size_t>(k)]) + 0.19 * (uniform() - 0.5);
      all.velocity(i, k) = 2.0 * (uniform() - 0.5);
    }
  }
  return all;
}

const laws::NearField near_field{.alpha1 = 0.05, .alpha2 = 0.025, .cutoff = 3.0 * spacing, .taper = spacing};
const thermo::Binding binding{.F_b = 1.0, .d_b = 1.2 * spacing};
const contact::Contact<contact::Restitution> meeting{.restitution = {.e_o = 0.5}};
const thermo::ImpactHeat heat{.kappa = 1.0, .J_star = 1.0};
const thermo::Cooling cooling{.h_c = 1e-3, .emissivity = 0.5};

// Processor time of a step [s]: others on the machine are not counted. Impacts of all steps.
struct Taken {
  double seconds = infinite;
  long impacts = 0;
};
template <class Scheme, class... Laws>
void step(const kinematics::Particles& start, int steps, Scheme scheme, Taken& least, const Laws&... laws) {
  const scenes::Scene<Space, Laws...> scene(start, Space{}, laws...);
  schemes::State state = scenes::start(scene);
  const std::clock_t begin = std::clock();
  const schemes::Outcome out = schemes::integrate(scene, state, 0.01 * steps, scheme, schemes::FixedStep{.step = 0.01});
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps;
  least.seconds = out.status == schemes::Status::reached ? std::min(least.seconds, seconds) : missing;
  least.impacts = out.impacts;
}

const Case heated_step{
    {.name = "heated_step",
     .claim =
         "heat makes a step of 10,000 bound spheres with a cut-off at three mean spacings at most 1.5 times as long",
     .equation = "R 7.4",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const kinematics::Particles start = spheres();
      const int steps = rows.quick() ? 3 : 20;
      Taken cold, by_impacts, flowing_cold, flowing;
      for (int k = 0; k < (rows.quick() ? 3 : 7); ++k) {
        step(start, steps, schemes::VelocityVerlet{}, cold, near_field, binding, meeting);
        step(start, steps, schemes::VelocityVerlet{}, by_impacts, near_field, binding, meeting, heat);
        step(start, steps, schemes::RungeKutta4{}, flowing_cold, near_field, binding, meeting);
        step(start, steps, schemes::RungeKutta4{}, flowing, near_field, binding, meeting, heat, cooling);
      }
      report::Table table({"scheme", "heat", "processor time a step [s]", "over that without heat", "impacts a step"});
      const auto add = [&](const char* scheme, const char* what, const Taken& taken, const Taken& without) {
        table.add(
            {scheme, what, taken.seconds, taken.seconds / without.seconds, static_cast<double>(taken.impacts) / steps});
      };
      add("velocity Verlet", "none", cold, cold);
      add("velocity Verlet", "of impacts", by_impacts, cold);
      add("RK4", "none", flowing_cold, flowing_cold);
      add("RK4", "of impacts, convection, radiation", flowing, flowing_cold);
      const char* const because = "heat is of order N, and of the impacts; the least of a few, in turn, in one run";
      rows.at_most("heat of impacts, velocity Verlet: a step with over one without",
                   {.limit = 1.5, .computed = by_impacts.seconds / cold.seconds, .because = because});
      rows.at_most("heat of impacts and flows, RK4: a step with over one without",
                   {.limit = 1.5, .computed = flowing.seconds / flowing_cold.seconds, .because = because});
      rows.equal("impacts with heat",
                 {.expected = cold.impacts, .computed = by_impacts.impacts, .because = "heat does not act back"});
      rows.write("heated_step", table);
    }};

}  // namespace verification::heated_step_races
