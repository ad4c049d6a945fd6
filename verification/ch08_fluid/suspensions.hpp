#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <harness/rows.hpp>
#include <particulate/fluid/suspension.hpp>
#include <particulate/schemes/staggering.hpp>

#include "../ch04_simulations/clouds.hpp"

/// @file
/// Suspensions that several cases look at.

namespace verification::suspensions {

using namespace particulate;

/// @return the staggering of a suspension: its fields in their order, each to TOL; those of the fluid contract as the
/// square of a step that sound rules
template <class S>
schemes::Staggered in_turn(const S& both, double TOL = 1e-6) {
  std::vector<schemes::Field> fields{{.name = "particles", .TOL = TOL}};
  if (S::has_temperatures) fields.push_back({.name = "particle temperatures", .TOL = TOL});
  for (const char* name : {"density", "momentum", "energy"}) fields.push_back({.name = name, .TOL = TOL, .p = 2});
  fields.resize(both.fields());
  return schemes::Staggered(fields);
}

/// One number against another that is known, within a share of it.
inline void match(Rows& rows, const std::string& what, double expected, double computed, double tolerance,
                  const std::string& because) {
  rows.compare(what,
               {.expected = expected, .computed = computed, .tolerance = relative(tolerance), .because = because});
}

/// The largest error of places, velocities and each kind of values, in units of the largest of its kind.
///
/// @param suspension  any @param at a state @param truth the state that it should be @return error [-]
template <class S>
double error(const S& suspension, const schemes::State& at, const schemes::State& truth) {
  const auto apart = [](const auto& one, const auto& other) {
    return (one - other).template lpNorm<Eigen::Infinity>() / other.template lpNorm<Eigen::Infinity>();
  };
  double worst = std::max(apart(at.r, truth.r), apart(at.v, truth.v));
  for (const schemes::Range& range : suspension.ranges()) {
    worst = std::max(worst, apart(at.y.segment(range.first, range.size), truth.y.segment(range.first, range.size)));
  }
  return worst;
}

/// A cube of a liquid at rest, 1 m wide and periodic, in which sound has 10 m/s, and in it the cloud of chapter 4 at
/// 600 K: the monograph's volume element.
struct VolumeElement {
  fluid::LiquidFlow<3> flow;
  kinematics::Particles particles;

  VolumeElement(Eigen::Index cells, Eigen::Index count, std::uint64_t seed, int threads = 1)
      : flow(cube(cells), {.state = {.Y = 1e5}, .viscosity = {.mu = 1.0}, .c = 2500.0, .K = 2500.0}, {}, threads),
        particles(book_cloud(count, seed, kinematics::Space{.lengths = Eigen::Vector3d::Ones()})) {
    particles.temperature = Eigen::VectorXd::Constant(count, 600.0);
    particles.heat_capacity = Eigen::VectorXd::Constant(count, 1000.0);
  }
  /// @param laws  that act among the particles @return all of it, hats of 1/8 m
  template <class... Laws>
  auto with(const Laws&... laws) const {
    return fluid::Suspension(flow, particles, fluid::Spreading{.w = 0.125},
                             fluid::HeatExchange{.h_c = 33333.0, .emissivity = 1.0, .a_v = 0.5}, laws...);
  }

 private:
  static fluid::Grid<3> cube(Eigen::Index cells) { return {.cells = {cells, cells, cells}}; }
};

/// What the liquid of the element is like at the start.
inline fluid::Local<3> still_water(const fluid::Vector<3>&) { return {.rho = 1000.0}; }

/// The near field of the element, tapered so that it ends below half of the box.
inline constexpr laws::NearField near_field{.alpha1 = 0.5, .alpha2 = 0.1, .cutoff = 0.45, .taper = 0.15};

}  // namespace verification::suspensions
