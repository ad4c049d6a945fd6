// Spheres with heat, bonds and what they meet, for the table of what a feature costs: thermo_cost <steps>... runs all
// of them.

#include <array>
#include <functional>
#include <stdexcept>

#include <harness/counted_program.hpp>
#include <particulate/contact/impulse_windows.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/binding.hpp>
#include <particulate/thermo/cooling.hpp>
#include <particulate/thermo/impact_heat.hpp>

namespace {

using namespace particulate;
using contact::Contact;
using contact::Restitution;
using contact::SofteningRestitution;
using kinematics::Space;
using verification::CountedRun;
using verification::CountedScene;

constexpr double dt = 1e-3, radius = 0.02, spacing = 0.1;

// 128 spheres at rest, apart from one another: in a cube, or on a floor that carries them.
kinematics::Particles spheres(bool on_floor, double temperature) {
  constexpr Eigen::Index N = 128;
  kinematics::Particles all{.position = kinematics::Vectors(N, 3),
                            .velocity = kinematics::Vectors::Zero(N, 3),
                            .mass = Eigen::VectorXd::Constant(N, 0.1),
                            .radius = Eigen::VectorXd::Constant(N, radius),
                            .temperature = Eigen::VectorXd::Constant(N, temperature),
                            .heat_capacity = Eigen::VectorXd::Ones(N)};
  const Eigen::Index edge = on_floor ? 12 : 6;
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::RowVector3d at(static_cast<double>(i % edge), static_cast<double>(i / edge % edge),
                                static_cast<double>(i / (edge * edge)));
    all.position.row(i) = spacing * at + Eigen::RowVector3d(0.0, 0.0, radius);
  }
  return all;
}
const kinematics::Particles apart = spheres(false, 300.0), resting = spheres(true, 300.0), hot = spheres(true, 450.0);

// One sphere more, which nothing moves: far above the others, or in touch with the first of them.
kinematics::Particles with_obstacle(bool touches) {
  kinematics::Particles all = spheres(true, 300.0);
  const Eigen::Index N = all.size();
  all.position.conservativeResize(N + 1, 3);
  all.velocity = kinematics::Vectors::Zero(N + 1, 3);
  all.mass.conservativeResize(N + 1);
  all.radius.conservativeResize(N + 1);
  all.position.row(N) << 0.0, 0.0, touches ? 2.0 * radius + 0.5 : 50.0;
  all.mass[N] = 1.0, all.radius[N] = 0.5;
  all.immovable.assign(static_cast<std::size_t>(N), false);
  all.immovable.push_back(true);
  all.temperature.resize(0), all.heat_capacity.resize(0);
  return all;
}

const Contact<Restitution> stiff{.restitution = {.e_o = 0.5}};
const Contact<SofteningRestitution> soft{.restitution = {.cold = {.e_o = 0.5}}};
const laws::Gravity weight{}, upwards{.g = {0.0, 0.0, 9.81}};
const thermo::ImpactHeat heat{.kappa = 1.0, .J_star = 1.0};
const thermo::Binding bound{.F_b = 1.0, .d_b = 1.1 * spacing}, beyond{.F_b = 1.0, .d_b = 0.6 * spacing};
const laws::NearField all_pairs{.alpha1 = 0.05, .alpha2 = 0.002};
laws::NearField ending(double cutoff) {
  laws::NearField law = all_pairs;
  law.cutoff = cutoff, law.taper = 0.5 * spacing;
  return law;
}

template <class Scheme, class... Laws>
CountedRun run(const kinematics::Particles& start, const Space& space, Scheme scheme, long steps, const Laws&... laws) {
  const scenes::Scene<Space, Laws...> scene(start, space, laws...);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out =
      schemes::integrate(scene, state, dt * static_cast<double>(steps), scheme, schemes::FixedStep{.step = dt});
  if (out.status != schemes::Status::reached || out.steps != steps) throw std::runtime_error(out.reason);
  return {.particles = start.size(), .impacts = out.impacts, .sum = state.r.sum() + state.y.sum()};
}

template <class... Laws>
CountedRun verlet(const kinematics::Particles& start, long steps, const Laws&... laws) {
  return run(start, Space{.walls = {kinematics::Wall{}}}, schemes::VelocityVerlet{}, steps, laws...);
}
template <class... Laws>
CountedRun runge_kutta(long steps, const Laws&... laws) {
  return run(apart, Space{}, schemes::RungeKutta4{}, steps, laws...);
}

// What it is hit with is gathered. The first sphere is pressed against it, the others fly on.
CountedRun against_obstacle(long steps, bool touches) {
  contact::ImpulseWindows windows(resting.size(), 0.02);
  Contact<Restitution> telling = stiff;
  telling.recorder = std::ref(windows);
  const CountedRun done = verlet(with_obstacle(touches), steps, upwards, telling);
  if ((windows.whole().normal > 0.0) != touches) throw std::runtime_error("the obstacle was hit otherwise");
  return done;
}

const std::array all{
    CountedScene{"heat_absent", [](long n) { return verlet(apart, n, upwards, stiff); }},
    CountedScene{"heat_idle", [](long n) { return verlet(apart, n, upwards, stiff, heat); }},
    CountedScene{"impacts_alone", [](long n) { return verlet(resting, n, weight, stiff); }},
    CountedScene{"heat_used", [](long n) { return verlet(resting, n, weight, stiff, heat); }},
    CountedScene{"cooling_absent", [](long n) { return runge_kutta(n, weight); }},
    CountedScene{"cooling_idle", [](long n) { return runge_kutta(n, weight, thermo::Cooling{}); }},
    CountedScene{"cooling_used",
                 [](long n) { return runge_kutta(n, weight, thermo::Cooling{.h_c = 5.0, .emissivity = 0.5}); }},
    CountedScene{"binding_absent", [](long n) { return verlet(apart, n, upwards); }},
    CountedScene{"binding_idle", [](long n) { return verlet(apart, n, upwards, beyond); }},
    CountedScene{"binding_used", [](long n) { return verlet(apart, n, upwards, bound); }},
    CountedScene{"cutoff_absent", [](long n) { return verlet(apart, n, all_pairs); }},
    CountedScene{"cutoff_idle", [](long n) { return verlet(apart, n, ending(100.0 * spacing)); }},
    CountedScene{"cutoff_used", [](long n) { return verlet(apart, n, ending(1.2 * spacing)); }},
    CountedScene{"softening_idle", [](long n) { return verlet(resting, n, weight, soft, heat); }},
    CountedScene{"softening_used", [](long n) { return verlet(hot, n, weight, soft, heat); }},
    CountedScene{"obstacle_absent", [](long n) { return verlet(resting, n, upwards, stiff); }},
    CountedScene{"obstacle_idle", [](long n) { return against_obstacle(n, false); }},
    CountedScene{"obstacle_used", [](long n) { return against_obstacle(n, true); }}};

}  // namespace

int main(int argc, char** argv) { return verification::counted_program(argc, argv, all); }
