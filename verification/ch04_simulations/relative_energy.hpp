#pragma once

#include <harness/motions.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

/// @file
/// The relative energy of a cloud with near field (2) and e = 0.5, in the mean over a time.

namespace verification {

/// Chapter 4's start with contacts that are located.
inline auto located_cloud(Eigen::Index N, std::uint64_t seed) {
  return particulate::scenes::Scene(book_cloud(N, seed), particulate::kinematics::Space{}, weak_near_field,
                                    particulate::contact::LocatedContact<>{.restitution = {0.5}});
}

/// The same with contacts at the ends of steps.
inline auto stepped_cloud(Eigen::Index N, std::uint64_t seed) {
  return particulate::scenes::Scene(book_cloud(N, seed), particulate::kinematics::Space{}, weak_near_field,
                                    particulate::contact::Contact<>{.restitution = {0.5}});
}

/// The time mean of the relative energy of a run, by the trapezoidal rule over its steps, before and after impacts
/// apart. [J/kg]
class MeanRelativeEnergy {
 public:
  MeanRelativeEnergy(const Eigen::VectorXd& mass, const particulate::schemes::State& start)
      : mass_(mass), last_(energy(start)) {}
  template <class S>
  bool operator()(const particulate::schemes::State&, const particulate::schemes::State& to, double dt, const S&) {
    const double now = energy(to);
    integral_ += 0.5 * dt * (last_ + now), time_ += dt;
    last_ = now;
    return true;
  }
  void jumped(const particulate::schemes::State& after, const particulate::schemes::Jump&) { last_ = energy(after); }
  double value() const { return integral_ / time_; }

 private:
  double energy(const particulate::schemes::State& at) const {
    return particulate::kinematics::split_kinetic_energy(mass_, rows_of(at.v)).relative;
  }
  const Eigen::VectorXd& mass_;
  double last_, integral_ = 0.0, time_ = 0.0;
};

/// A mean, and what it took.
struct MeanOfRun {
  double energy;
  particulate::schemes::Outcome outcome;
};

/// Runs a problem from its start. @return the time mean of its relative energy
template <class S, class C>
MeanOfRun mean_of_run(const particulate::schemes::Problem& problem, const Eigen::VectorXd& mass,
                      particulate::schemes::State state, double t_end, S scheme, C control) {
  MeanRelativeEnergy mean(mass, state);
  particulate::schemes::Outcome outcome = particulate::schemes::integrate(problem, state, t_end, scheme, control, mean);
  require_reached(outcome);
  return {mean.value(), std::move(outcome)};
}

/// The same of a scene.
template <class Scene, class S, class C>
MeanOfRun mean_of_run(const Scene& scene, double t_end, S scheme, C control) {
  return mean_of_run(scene, scene.particles().mass, particulate::scenes::start(scene), t_end, scheme, control);
}

}  // namespace verification
