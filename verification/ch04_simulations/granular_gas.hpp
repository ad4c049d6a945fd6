#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include <particulate/contact/hard_spheres.hpp>
#include <particulate/kinematics/starts.hpp>

#include "clouds.hpp"

/// @file
/// A homogeneous gas of hard spheres in a periodic cube with edges of 1 m, and what theory says of it.

namespace verification {

/// A gas of unit masses: how many, how dense, how elastic. Temperatures are energies, per mass.
struct GranularGas {
  Eigen::Index N;  ///< spheres [-]
  double phi;      ///< volume fraction [-]
  double e;        ///< restitution [-]

  /// @return diameter s [m]
  double diameter() const { return 2.0 * std::cbrt(3.0 * phi / (4.0 * std::numbers::pi * static_cast<double>(N))); }
  /// Of Carnahan and Starling. @return chi, by which impacts are more frequent than between points [-]
  double pair_correlation() const { return (1.0 - 0.5 * phi) / ((1.0 - phi) * (1.0 - phi) * (1.0 - phi)); }
  /// Of Enskog's theory. @param T temperature [J/kg] @return impacts of a particle in a second [1/s]
  double impact_rate(double T) const {
    const double s = diameter();
    return 4.0 * std::sqrt(std::numbers::pi) * static_cast<double>(N) * s * s * pair_correlation() * std::sqrt(T);
  }
  /// tau = 2/zeta_0 of Haff's law. @param T temperature at the start [J/kg] @return time [s]
  double cooling_time(double T) const { return 6.0 / ((1.0 - e * e) * impact_rate(T)); }
};

/// @return velocities about their mean: T = (1/3) <(v - <v>)^2> [J/kg]
inline double temperature(const particulate::schemes::State& state) {
  const particulate::kinematics::Vectors v = velocities(state);
  const Eigen::RowVector3d mean = v.colwise().mean();
  return (v.rowwise() - mean).squaredNorm() / (3.0 * static_cast<double>(v.rows()));
}

/// Spheres at random, with evenly distributed velocities of the temperature 1 and without common motion: no equilibrium
/// yet.
inline particulate::contact::HardSpheres<> elastic_gas(const GranularGas& of, std::uint64_t seed) {
  Uniform uniform(seed);
  const particulate::kinematics::Space cube{.lengths = Eigen::Vector3d::Ones()};
  particulate::kinematics::Particles all{.position = {},
                                         .velocity = random_places(uniform, of.N).array() - 0.5,
                                         .mass = Eigen::VectorXd::Ones(of.N),
                                         .radius = Eigen::VectorXd::Constant(of.N, 0.5 * of.diameter())};
  all.position =
      particulate::kinematics::random_addition(all.radius, {.domain = cube}, [&] { return uniform(); }).position;
  all.velocity.rowwise() -= all.velocity.colwise().mean().eval();
  all.velocity *= std::sqrt(3.0 * static_cast<double>(of.N) / all.velocity.squaredNorm());
  return particulate::contact::HardSpheres<>(std::move(all), cube);
}

/// Values of several runs of the same kind.
struct Sample {
  std::vector<double> values;  ///< at least two

  /// @return their mean
  double mean() const { return Eigen::Map<const Eigen::ArrayXd>(values.data(), size()).mean(); }
  /// @return standard error of the mean
  double error() const {
    const double n = static_cast<double>(values.size());
    return std::sqrt((Eigen::Map<const Eigen::ArrayXd>(values.data(), size()) - mean()).square().sum() /
                     (n * (n - 1.0)));
  }

 private:
  Eigen::Index size() const { return static_cast<Eigen::Index>(values.size()); }
};

/// Three on a line, of unit mass and diameter: with the first at 0 it touches the second and parts from it, and the
/// third approaches that one at 1 m/s from 1 m away.
///
/// @param first    place of the first [m]
/// @param parting  its speed, away from the others [m/s]
/// @return the three
inline particulate::kinematics::Particles three_on_a_line(double first, double parting) {
  const auto one = [](double x, double v) {
    return particulate::kinematics::Particle{
        .position = {x, 0.0, 0.0}, .velocity = {v, 0.0, 0.0}, .mass = 1.0, .radius = 0.5};
  };
  return particulate::kinematics::particles({one(first, -parting), one(1.0, 0.0), one(3.0, -1.0)});
}

}  // namespace verification
