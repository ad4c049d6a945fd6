// Scenes of 64 particles, for the table of what a feature costs: feature_cost <steps>... runs all of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <harness/counted_program.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/contact/hard_spheres.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/legs.hpp>
#include <particulate/schemes/verlet.hpp>

namespace {

using namespace particulate;
using contact::Contact;
using kinematics::Space;
using kinematics::Wall;
using laws::Gravity;
using scenes::Scene;
using verification::CountedRun;
using verification::CountedScene;

constexpr Eigen::Index side = 4, N = side * side * side, many = 27 * N;
constexpr double dt = 4e-3;

// Spheres on a lattice of spacing 1 with unrelated velocities: thin ones do not meet within the run, thick ones soon
// do.
kinematics::Particles cloud(double radius, double speed, Eigen::Index count = N, Eigen::Index edge = side) {
  kinematics::Particles all{.position = kinematics::Vectors(count, 3),
                            .velocity = kinematics::Vectors(count, 3),
                            .mass = Eigen::VectorXd::Ones(count),
                            .radius = Eigen::VectorXd::Constant(count, radius)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::array<Eigen::Index, 3> corner{i % edge, i / edge % edge, i / (edge * edge)};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      // Multiples of an irrational number modulo 1 are spread evenly.
      const double mixed = std::fmod(0.6180339887498949 * static_cast<double>(3 * i + axis + 1), 1.0);
      all.position(i, axis) = static_cast<double>(corner[k]) + 0.02 * (mixed - 0.5);
      all.velocity(i, axis) = 2.0 * speed * (mixed - 0.5);
    }
    all.mass[i] = 1.0 + 0.01 * static_cast<double>(i);
  }
  return all;
}
const kinematics::Particles thin = cloud(0.1, 0.01), thick = cloud(0.46, 1.0);
// So many that their neighbours are searched: once where they hardly move, every few steps where they fly apart.
const kinematics::Particles slow_many = cloud(0.1, 1e-4, many, 3 * side), fast_many = cloud(0.1, 20.0, many, 3 * side);

// Walls half a spacing outside the lattice, or farther.
Space box(double away) {
  const double low = -0.5 - away, high = static_cast<double>(side) - 0.5 + away;
  Space space;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d n = Eigen::Vector3d::Unit(axis);
    space.walls.push_back(Wall{.point = low * n, .normal = n});
    space.walls.push_back(Wall{.point = high * n, .normal = -n});
  }
  return space;
}

// Space that repeats itself: within the cloud's own size, or far beyond it.
Space repeated(double period) { return {.lengths = Eigen::Vector3d::Constant(period)}; }

const Gravity weight{.g = {0.0, 0.0, -0.1}};
const Gravity weightless{.g = Eigen::Vector3d::Zero()};
const laws::NearField field{.alpha1 = 0.01, .alpha2 = 0.005, .beta1 = 1.0, .beta2 = 2.0};
const laws::NearField cut_off{.alpha1 = 0.01, .alpha2 = 0.005, .beta1 = 1.0, .beta2 = 2.0, .cutoff = 1.9, .taper = 0.5};
const laws::NearField no_field{.alpha1 = 0.0, .alpha2 = 0.0, .beta1 = 1.0, .beta2 = 2.0};

schemes::State start_of(const kinematics::Particles& particles) {
  return {.t = 0.0, .r = particles.position.reshaped(), .v = particles.velocity.reshaped()};
}

template <class P, class Observer = schemes::Unobserved>
CountedRun by_library(P problem, const kinematics::Particles& particles, long steps, Observer&& observer = {}) {
  schemes::State motion = start_of(particles);
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = dt};
  const schemes::Outcome out =
      schemes::integrate(problem, motion, dt * static_cast<double>(steps), scheme, control, observer);
  if (out.status != schemes::Status::reached || out.steps != steps) throw std::runtime_error(out.reason);
  return {.particles = particles.size(), .impacts = out.impacts, .sum = motion.r.sum()};
}

template <class D, class... Laws>
CountedRun scene(const kinematics::Particles& particles, const D& domain, long steps, const Laws&... laws) {
  return by_library(Scene<D, Laws...>(particles, domain, laws...), particles, steps);
}

// A scene with a history of which a row is due every so often; far apart: never.
CountedRun with_history(long steps, double apart) {
  const Scene observed(thin, Space{}, weight, field);
  const double end = std::min(dt * static_cast<double>(steps), 1e6);
  scenes::History history(observed, apart > end ? std::vector{apart} : schemes::multiples(apart, 0.0, end));
  CountedRun run = by_library(observed, thin, steps, history);
  run.sum += history.rows().sum();
  return run;
}

// The forces of a near field as often as there are steps, with their potential energy or without.
CountedRun forces(long steps, bool with_energy) {
  const Scene attracted(thin, Space{}, field);
  const schemes::State at = scenes::start(attracted);
  Eigen::VectorXd f(at.r.size());
  CountedRun run{.particles = N, .impacts = 0, .sum = 0.0};
  for (long step = 0; step < steps; ++step) {
    double energy = 0.0;
    if (!(with_energy ? attracted.total_force(at, f, energy) : attracted.total_force(at, f))) {
      throw std::runtime_error("no force");
    }
    run.sum += f[0] + energy;
  }
  return run;
}

// A gas of hard spheres, which has no steps: as long as so many of a scene would take.
template <class FrictionLaw = contact::Frictionless>
CountedRun gas(const Space& space, long steps, const FrictionLaw& friction = {}, double contact_time = 0.0,
               const contact::CollisionRecorder& recorder = {}) {
  contact::HardSpheres spheres(thick, space, contact::ConstantRestitution{0.9}, friction, contact_time);
  schemes::State motion = start(spheres);
  const schemes::Outcome out = spheres.advance(motion, dt * static_cast<double>(steps), recorder);
  if (out.status != schemes::Status::reached) throw std::runtime_error(out.reason);
  return {.particles = N, .impacts = out.impacts, .sum = motion.r.sum()};
}

// With a recorder that adds up what impacts take, or does not.
CountedRun recorded_gas(long steps, bool adds) {
  double taken = 0.0;
  const auto nothing = [](const contact::Collision&) {};
  const auto add = [&](const contact::Collision& one) { taken += one.energy_change; };
  CountedRun run = gas(box(0.0), steps, contact::Frictionless{}, 0.0,
                       adds ? contact::CollisionRecorder(add) : contact::CollisionRecorder(nothing));
  run.sum += taken;
  return run;
}

// What a reader would write without a library: Verlet over three arrays of components, the forces in place, no checks.
template <class Force>
CountedRun by_hand(const kinematics::Particles& particles, long steps, const Force& add) {
  schemes::State motion = start_of(particles);
  auto& [t, r, v, y, t_carry] = motion;
  Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * N), inverse(3 * N);
  for (Eigen::Index axis = 0; axis < 3; ++axis) inverse.segment(axis * N, N) = particles.mass.cwiseInverse();
  add(r, f);
  for (long step = 0; step < steps; ++step) {
    v += (0.5 * dt) * f.cwiseProduct(inverse);
    r += dt * v;
    f.setZero();
    add(r, f);
    v += (0.5 * dt) * f.cwiseProduct(inverse);
    t += dt;
  }
  return {.particles = N, .impacts = 0, .sum = r.sum()};
}

void weigh(const kinematics::Particles& particles, schemes::Out f) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) f.segment(axis * N, N) += weight.g[axis] * particles.mass;
}

void attract(const kinematics::Particles& particles, schemes::In r, schemes::Out f) {
  static laws::Scratch scratch;
  static const Eigen::VectorXd inverse_mass = kinematics::inverse_masses(particles);
  const laws::At<> at{.t = 0.0,
                      .position = {r.data(), N, 3},
                      .mass = particles.mass,
                      .radius = particles.radius,
                      .inverse_mass = inverse_mass,
                      .scratch = scratch};
  if (!add_force(field, Space{}, at, laws::Forces(f.data(), N, 3))) throw std::runtime_error("no force");
}

// The same forces as a problem of its own, for the library's loop: what a scene adds to it is the composition alone.
template <class Force>
struct HandWritten {
  const kinematics::Particles& particles;
  Eigen::VectorXd inverse_mass;
  Force add;
  bool acceleration(double, schemes::In r, schemes::Out a) const {
    a.setZero();
    add(r, a);
    for (Eigen::Index axis = 0; axis < 3; ++axis) a.segment(axis * N, N).array() *= inverse_mass.array();
    return a.allFinite();
  }
};
template <class Force>
CountedRun problem_by_hand(const kinematics::Particles& particles, long steps, const Force& add) {
  return by_library(HandWritten<Force>{particles, particles.mass.cwiseInverse(), add}, particles, steps);
}

using Elastic = Contact<>;
using Rubbing = Contact<contact::ConstantRestitution, contact::Friction>;
using Varying = Contact<contact::Restitution>;

const auto only_weight = [](schemes::In, schemes::Out f) { weigh(thin, f); };
const auto only_field = [](schemes::In r, schemes::Out f) { attract(thin, r, f); };
const auto both = [](schemes::In r, schemes::Out f) { weigh(thin, f), attract(thin, r, f); };

// A feature is absent, or present but idle, or used; where two of these are one scene it stands once.
const std::array all{
    CountedScene{"hand_loop_gravity", [](long n) { return by_hand(thin, n, only_weight); }},
    CountedScene{"hand_loop_near_field", [](long n) { return by_hand(thin, n, only_field); }},
    CountedScene{"hand_loop_both", [](long n) { return by_hand(thin, n, both); }},
    CountedScene{"hand_problem_gravity", [](long n) { return problem_by_hand(thin, n, only_weight); }},
    CountedScene{"hand_problem_near_field", [](long n) { return problem_by_hand(thin, n, only_field); }},
    CountedScene{"hand_problem_both", [](long n) { return problem_by_hand(thin, n, both); }},

    CountedScene{"near_field_absent", [](long n) { return scene(thin, Space{}, n, weight); }},
    CountedScene{"near_field_idle", [](long n) { return scene(thin, Space{}, n, weight, no_field); }},
    CountedScene{"near_field_used", [](long n) { return scene(thin, Space{}, n, weight, field); }},

    CountedScene{"gravity_absent", [](long n) { return scene(thin, Space{}, n, field); }},
    CountedScene{"gravity_idle", [](long n) { return scene(thin, Space{}, n, weightless, field); }},

    CountedScene{"energy_absent", [](long n) { return forces(n, false); }},
    CountedScene{"energy_used", [](long n) { return forces(n, true); }},

    CountedScene{"contact_absent", [](long n) { return scene(thin, box(0.0), n, weight, field); }},
    CountedScene{"contact_idle", [](long n) { return scene(thin, box(0.0), n, weight, field, Elastic{}); }},
    CountedScene{"contact_used", [](long n) { return scene(thick, box(0.0), n, weight, field, Elastic{}); }},

    CountedScene{"wall_absent", [](long n) { return scene(thick, Space{}, n, weight, field, Elastic{}); }},
    CountedScene{"wall_idle", [](long n) { return scene(thick, box(100.0), n, weight, field, Elastic{}); }},

    CountedScene{"friction_idle", [](long n) { return scene(thick, box(0.0), n, weight, field, Rubbing{}); }},
    CountedScene{"friction_used",
                 [](long n) {
                   return scene(thick, box(0.0), n, weight, field, Rubbing{.friction = {.mu_s = 0.02, .mu_d = 0.01}});
                 }},

    CountedScene{"restitution_law_idle", [](long n) { return scene(thick, box(0.0), n, weight, field, Varying{}); }},
    CountedScene{"restitution_law_used",
                 [](long n) {
                   return scene(thick, box(0.0), n, weight, field,
                                Varying{.restitution = {.e_o = 1.0, .v_star = 500.0}});
                 }},

    CountedScene{"periods_absent", [](long n) { return scene(thick, Space{}, n, cut_off, Elastic{}); }},
    CountedScene{"periods_idle", [](long n) { return scene(thick, repeated(1e3), n, cut_off, Elastic{}); }},
    CountedScene{"periods_used", [](long n) { return scene(thick, repeated(side), n, cut_off, Elastic{}); }},

    CountedScene{"neighbours_absent", [](long n) { return scene(slow_many, Space{}, n, weight); }},
    CountedScene{"neighbours_idle", [](long n) { return scene(slow_many, Space{}, n, weight, Elastic{}); }},
    CountedScene{"neighbours_used", [](long n) { return scene(fast_many, Space{}, n, weight, Elastic{}); }},

    CountedScene{"history_absent", [](long n) { return scene(thin, Space{}, n, weight, field); }},
    CountedScene{"history_idle", [](long n) { return with_history(n, 1e9); }},
    CountedScene{"history_used", [](long n) { return with_history(n, dt); }},

    CountedScene{"gas_wall_absent", [](long n) { return gas(Space{}, n); }},
    CountedScene{"gas_wall_idle", [](long n) { return gas(box(100.0), n); }},
    CountedScene{"gas_wall_used", [](long n) { return gas(box(0.0), n); }},
    CountedScene{"gas_friction_idle", [](long n) { return gas(box(0.0), n, contact::Friction{}); }},
    CountedScene{"gas_friction_used",
                 [](long n) { return gas(box(0.0), n, contact::Friction{.mu_s = 0.02, .mu_d = 0.01}); }},
    CountedScene{"gas_contact_time_idle", [](long n) { return gas(box(0.0), n, contact::Frictionless{}, 1e-12); }},
    CountedScene{"gas_contact_time_used", [](long n) { return gas(box(0.0), n, contact::Frictionless{}, 0.02); }},
    CountedScene{"gas_recorder_idle", [](long n) { return recorded_gas(n, false); }},
    CountedScene{"gas_recorder_used", [](long n) { return recorded_gas(n, true); }}};

}  // namespace

int main(int argc, char** argv) { return verification::counted_program(argc, argv, all); }
