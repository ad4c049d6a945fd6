// Motion and temperatures that act on each other: at once, and in turn.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/staggered_scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/cooling.hpp>

#include "spheres.hpp"

namespace verification::thermo_staggering {

using namespace particulate;

// Springs between all pairs, of unit length, which become softer as their ends become warmer; heat goes along them, the
// more the closer their ends are.
struct WarmSprings {
  double stiffness = 3.0, softening = 1e-3, conductance = 2.0;
};
template <class Visit>
void each_spring(const kinematics::Space& space, const laws::At<laws::Temperature>& at, const Visit& visit) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    for (Eigen::Index j = i + 1; j < at.mass.size(); ++j) {
      visit(i, j, separation(space, at.position.row(i), at.position.row(j)));
    }
  }
}
bool add_force(const WarmSprings& law, const kinematics::Space& space, const laws::At<laws::Temperature>& at,
               laws::Forces force) {
  each_spring(space, at, [&](Eigen::Index i, Eigen::Index j, const Eigen::Vector3d& towards) {
    const double d = towards.norm(), theta = 0.5 * (at.temperature[i] + at.temperature[j]) - 300.0;
    const Eigen::Vector3d pull = law.stiffness * (1.0 - law.softening * theta) * (1.0 - 1.0 / d) * towards;
    force.row(i) += pull;
    force.row(j) -= pull;
  });
  return true;
}
bool add_heat(const WarmSprings& law, const kinematics::Space& space, const laws::At<laws::Temperature>& at,
              laws::Heats heat) {
  each_spring(space, at, [&](Eigen::Index i, Eigen::Index j, const Eigen::Vector3d& towards) {
    const double flow = law.conductance * (at.temperature[j] - at.temperature[i]) / towards.squaredNorm();
    heat[i] += flow;
    heat[j] -= flow;
  });
  return true;
}

// Four bodies off their corners of a tetrahedron, some warm and some cold, that move.
kinematics::Particles four() {
  const auto body = [](const Eigen::Vector3d& at, const Eigen::Vector3d& v, double mass, double theta) {
    return kinematics::Particle{
        .position = at, .velocity = v, .mass = mass, .radius = 0.0, .temperature = theta, .heat_capacity = 1.5};
  };
  return kinematics::particles(
      {body({0.0, 0.0, 0.0}, {0.1, 0.2, 0.0}, 1.0, 300.0), body({1.1, 0.1, 0.0}, {0.0, -0.3, 0.2}, 1.5, 600.0),
       body({0.4, 0.8, 0.1}, {0.2, 0.0, -0.1}, 0.8, 250.0), body({0.5, 0.2, 0.9}, {-0.1, 0.1, 0.1}, 1.2, 450.0)});
}

constexpr double t_end = 1.7;

// Where SUNDIALS finds the whole: two families, of which one judges the other.
schemes::State known(const auto& scene) {
  schemes::State state = scenes::start(scene);
  const reference::ExplicitRungeKutta fehlberg{
      .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14};
  require_reached(reference::integrate(scene, state, t_end, fehlberg));
  return state;
}

double apart(const schemes::State& one, const schemes::State& other) {
  return std::max({(one.r - other.r).lpNorm<Eigen::Infinity>(), (one.v - other.v).lpNorm<Eigen::Infinity>(),
                   (one.y - other.y).lpNorm<Eigen::Infinity>() / 300.0});
}

template <class Advanced>
void compare_order(Rows& rows, const std::string& by, double order, long coarsest, const auto& scene,
                   const Advanced& advanced, const std::string& because) {
  const schemes::State end = known(scene);
  std::vector<double> steps, errors;
  for (long n = coarsest; steps.size() < 5; n = n * 3 / 2) {
    steps.push_back(t_end / static_cast<double>(n));
    errors.push_back(apart(advanced(steps.back()), end));
  }
  rows.order(by, {.nominal = order, .steps = steps, .errors = errors, .floor = 1e-13, .because = because});
}

const scenes::Scene two_way(four(), kinematics::Space{}, WarmSprings{});

template <class S>
auto by(const auto& scene, S scheme) {
  return [&scene, scheme](double step) {
    schemes::State state = scenes::start(scene);
    reach(scene, state, t_end, scheme, schemes::FixedStep{.step = step});
    return state;
  };
}

const Case orders{
    {.name = "order_of_temperatures",
     .claim =
         "where places, velocities and temperatures act on each other every scheme that can advance all of them has "
         "its order, neither less nor more",
     .equation = "D 7.5",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const char* smooth = "smooth forces and flows, sweeps to rounding";
      compare_order(rows, "RK4", 4.0, 24, two_way, by(two_way, schemes::RungeKutta4{}), smooth);
      compare_order(rows, "backward Euler", 1.0, 400, two_way, by(two_way, schemes::BackwardEuler{}), smooth);
      compare_order(rows, "phi = 1/2", 2.0, 30, two_way, by(two_way, schemes::BackwardEuler(0.5)), smooth);
      compare_order(rows, "Gauss 2", 4.0, 10, two_way, by(two_way, schemes::Collocation<schemes::Gauss<2>>{}), smooth);
      compare_order(rows, "Radau 2, Newton", 3.0, 16, two_way,
                    by(two_way, schemes::Collocation<schemes::Radau<2>, schemes::Newton<>>{}), smooth);
    }};

// A staggered run, both fields to the same tolerance.
template <class Motion, class Heat>
schemes::Outcome in_turn(const auto& scene, double step, schemes::State& state) {
  auto fields = scenes::staggered(scene, Motion{}, Heat{});
  const schemes::Staggered scheme({{.name = "motion", .TOL = 1e-12}, {.name = "temperatures", .TOL = 1e-12}});
  return reached(fields, state, t_end, scheme, schemes::FixedStep{.step = step, .TOL = 1.0});
}

template <class Motion, class Heat>
auto staggered_by(const auto& scene) {
  return [&scene](double step) {
    schemes::State state = scenes::start(scene);
    (void)in_turn<Motion, Heat>(scene, step, state);
    return state;
  };
}

const Case both_ways{
    {.name = "staggered_both_ways",
     .claim = "motion and temperatures that act on each other and are solved in turn come to what CVODE and ARKODE "
              "find of the whole, at order 1 whatever schemes the two have",
     .equation = "R 7.5.1",
     .reference = Reference::sundials},
    [](Rows& rows) {
      schemes::State by_cvode = scenes::start(two_way);
      require_reached(
          reference::integrate(two_way, by_cvode, t_end, reference::Adams{.relative = 1e-13, .absolute = 1e-13}));
      rows.at_most("CVODE from ARKODE, the whole",
                   {.limit = 1e-10, .computed = apart(by_cvode, known(two_way)), .because = "Adams is good to 1e-11"});
      const char* because = "each field sees the other frozen at the end of the step";
      compare_order(rows, "velocity Verlet and RK4", 1.0, 200, two_way,
                    staggered_by<schemes::VelocityVerlet, schemes::RungeKutta4>(two_way), because);
      compare_order(
          rows, "Gauss 2 and Radau 2", 1.0, 200, two_way,
          staggered_by<schemes::Collocation<schemes::Gauss<2>>, schemes::Collocation<schemes::Radau<2>>>(two_way),
          because);
    }};

// Springs that do not feel temperatures: those change by cooling alone, and nothing sees them.
struct Springs {
  double stiffness = 3.0;
};
bool add_force(const Springs& law, const kinematics::Space& space, const laws::At<>& at, laws::Forces force) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    for (Eigen::Index j = i + 1; j < at.mass.size(); ++j) {
      const Eigen::Vector3d towards = separation(space, at.position.row(i), at.position.row(j));
      const Eigen::Vector3d pull = law.stiffness * (1.0 - 1.0 / towards.norm()) * towards;
      force.row(i) += pull;
      force.row(j) -= pull;
    }
  }
  return true;
}

const Case one_way{
    {.name = "staggered_one_way",
     .claim = "where no force depends on temperature staggering is trivial: the second sweep changes nothing, and the "
              "order is that of the schemes",
     .equation = "R 7.5.1",
     .reference = Reference::sundials},
    [](Rows& rows) {
      kinematics::Particles bodies = four();
      bodies.radius.setConstant(0.05);
      const scenes::Scene scene(bodies, kinematics::Space{}, Springs{},
                                thermo::Cooling{.h_c = 20.0, .emissivity = 1.0});
      compare_order(rows, "RK4 and RK4", 4.0, 24, scene,
                    staggered_by<schemes::RungeKutta4, schemes::RungeKutta4>(scene), "each field is alone");
      schemes::State state = scenes::start(scene);
      const schemes::Outcome outcome = in_turn<schemes::RungeKutta4, schemes::RungeKutta4>(scene, t_end / 50.0, state);
      rows.equal("sweeps in 50 steps", {.expected = 100,
                                        .computed = outcome.sweeps,
                                        .because = "one to solve both, one to see that nothing changes"});
      schemes::State coupled = by(scene, schemes::RungeKutta4{})(t_end / 50.0);
      rows.at_most("largest distance from the coupled run, RK4",
                   {.limit = 1e-14, .computed = apart(state, coupled), .because = "the same steps, but for rounding"});
    }};

}  // namespace verification::thermo_staggering
