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

/// The time mean of the relative energy of a run, by Gauss's rule of four points in each step: at the stages of Gauss
/// 4, and so of its order. [J/kg]
class MeanRelativeEnergy {
 public:
  explicit MeanRelativeEnergy(const Eigen::VectorXd& mass) : mass_(mass) {}
  template <class S>
  bool operator()(const particulate::schemes::State& from, const particulate::schemes::State&, double dt,
                  const S& scheme) {
    constexpr double point[] = {0.3399810435848563, 0.8611363115940526},
                     weight[] = {0.6521451548625461, 0.3478548451374538};
    for (const int k : {0, 1}) {
      for (const double x : {point[k], -point[k]}) {
        scheme.at(from, dt, 0.5 * (1.0 + x), there_);
        integral_ +=
            0.5 * weight[k] * dt * particulate::kinematics::split_kinetic_energy(mass_, rows_of(there_.v)).relative;
      }
    }
    time_ += dt;
    return true;
  }
  double value() const { return integral_ / time_; }

 private:
  const Eigen::VectorXd& mass_;
  double integral_ = 0.0, time_ = 0.0;
  particulate::schemes::State there_;
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
  MeanRelativeEnergy mean(mass);
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
