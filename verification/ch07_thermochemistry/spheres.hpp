#pragma once

#include <limits>

#include <harness/motions.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/thermo/binding.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "../ch04_simulations/clouds.hpp"

/// @file
/// The spheres of this chapter's cases: the values of section 7.5.3, clouds that can become warm, and their energy.

namespace verification {

namespace contact = particulate::contact;
namespace kinematics = particulate::kinematics;
namespace laws = particulate::laws;
namespace scenes = particulate::scenes;
namespace schemes = particulate::schemes;
namespace thermo = particulate::thermo;

inline constexpr laws::NearField book_near_field{.alpha1 = 0.5, .alpha2 = 0.25};
inline constexpr thermo::Binding book_binding{.F_b = 200.0, .d_b = 0.08};
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double book_radius = 0.025, book_mass = 0.130899693899575;

/// e = 0.5 and friction with the coefficients of the captions.
using BookContact = contact::Contact<contact::ConstantRestitution, contact::Friction>;
inline BookContact book_contact() { return {.restitution = {0.5}, .friction = {.mu_s = 0.2, .mu_d = 0.1}}; }

/// The same particles with one temperature and heat capacity for all.
inline kinematics::Particles warmed(kinematics::Particles particles, double theta = 300.0, double c = 4000.0) {
  particles.temperature = Eigen::VectorXd::Constant(particles.size(), theta);
  particles.heat_capacity = Eigen::VectorXd::Constant(particles.size(), c);
  return particles;
}

/// Two equal spheres of the chapter, a distance apart along slanted(), that part along it with a relative speed.
inline kinematics::Particles book_pair(double apart, double parting = 0.0) {
  const auto one = [&](double side) {
    const Eigen::Vector3d towards = 0.5 * side * Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0;
    return kinematics::Particle{
        .position = apart * towards, .velocity = parting * towards, .mass = book_mass, .radius = book_radius};
  };
  return kinematics::particles({one(-1.0), one(1.0)});
}

/// Heat that particles hold beyond their start [J].
inline double heat_gained(const kinematics::Particles& start, const Eigen::VectorXd& theta) {
  return start.mass.cwiseProduct(start.heat_capacity).dot(theta - start.temperature);
}

/// Kinetic, potential and thermal energy of a scene with heat, the last one beyond the start [J].
inline double total_energy(const auto& scene, const schemes::State& at) {
  const kinematics::Particles& start = scene.particles();
  return kinematics::kinetic_energy(start.mass, rows_of(at.v)) + scene.potential_energy(at) + heat_gained(start, at.y);
}

/// Kinetic energy per unit mass about the mean motion [J/kg].
inline double relative_energy(const kinematics::Particles& of, const schemes::State& at) {
  return kinematics::split_kinetic_energy(of.mass, rows_of(at.v)).relative;
}

}  // namespace verification
