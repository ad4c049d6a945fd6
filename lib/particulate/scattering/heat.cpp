#include <particulate/scattering/heat.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <Eigen/SparseCore>

namespace particulate::scattering {

bool HeatedBodies::rate(double, schemes::In theta, schemes::Out d) const {
  bool has_value = true;
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    d[i] = (power[i] + surface[i] * thermo::heat_flux(cooling, theta[i])) / capacity[i];
    has_value = has_value && theta[i] >= 0.0 && std::isfinite(d[i]);
  }
  return has_value;
}

void HeatedBodies::sparse_jacobian(double, schemes::In theta, schemes::SparseJacobian& J) const {
  J.resize(theta.size(), theta.size());
  J.setIdentity();
  for (int i = 0; i < J.rows(); ++i) {
    J.valuePtr()[i] = surface[i] * thermo::heat_flux_slope(cooling, theta[i]) / capacity[i];
  }
}

void validate(const HeatedBodies& bodies) {
  const Eigen::Index N = bodies.capacity.size();
  if (bodies.surface.size() != N || bodies.power.size() != N) {
    throw std::invalid_argument(
        fmt::format("heated bodies: each must have a heat capacity, a surface and a power, got {}, {} and {}", N,
                    bodies.surface.size(), bodies.power.size()));
  }
  const auto require = [](bool holds, const char* what, double value, const char* unit, Eigen::Index i) {
    if (holds && std::isfinite(value)) return;
    throw std::invalid_argument(
        fmt::format("heated bodies: {} and finite, that of body {} is {} {}", what, i, value, unit));
  };
  for (Eigen::Index i = 0; i < N; ++i) {
    const double capacity = bodies.capacity[i], surface = bodies.surface[i], power = bodies.power[i];
    require(capacity > 0.0, "heat capacities, rho c times the volume, must be positive", capacity, "J/K", i);
    require(surface > 0.0, "surfaces must be positive", surface, "m^2", i);
    require(power >= 0.0, "powers must not be negative", power, "W", i);
  }
  thermo::validate(bodies.cooling);
}

schemes::State start(const HeatedBodies& bodies, double theta_0) {
  validate(bodies);
  if (!(theta_0 > 0.0 && std::isfinite(theta_0))) {
    throw std::invalid_argument(
        fmt::format("heated bodies: the temperature at the start must be positive and finite, got {} K", theta_0));
  }
  return {.y = Eigen::VectorXd::Constant(bodies.capacity.size(), theta_0)};
}

Eigen::VectorXd equilibrium_temperatures(const HeatedBodies& bodies) {
  validate(bodies);
  Eigen::VectorXd theta(bodies.power.size());
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    theta[i] = thermo::equilibrium_temperature(bodies.cooling, bodies.power[i] / bodies.surface[i]);
  }
  return theta;
}

Eigen::VectorXd warmed_by(const HeatedBodies& bodies, const Eigen::VectorXd& theta, const Eigen::VectorXd& energy) {
  const Eigen::Index N = bodies.capacity.size();
  if (theta.size() != N || energy.size() != N) {
    throw std::invalid_argument(
        fmt::format("heated bodies: each of {} must have a temperature and an energy, got {} and {}", N, theta.size(),
                    energy.size()));
  }
  for (Eigen::Index i = 0; i < N; ++i) {
    if (std::isfinite(theta[i]) && std::isfinite(energy[i]) && energy[i] >= 0.0) continue;
    throw std::invalid_argument(
        fmt::format("heated bodies: temperatures and energies must be finite and energies not negative, body {} has {} "
                    "K and gets {} J",
                    i, theta[i], energy[i]));
  }
  return theta + energy.cwiseQuotient(bodies.capacity);
}

std::vector<HeatJump> heat_jumps(const std::vector<PathPoint>& paths) {
  std::vector<HeatJump> jumps;
  for (std::size_t k = 1; k < paths.size(); ++k) {
    const PathPoint& hit = paths[k];
    if (hit.body < 0) continue;
    jumps.push_back({.t = hit.length / speed_of_light, .body = hit.body, .energy = paths[k - 1].power - hit.power});
  }
  std::sort(jumps.begin(), jumps.end(),
            [](const HeatJump& a, const HeatJump& b) { return a.t < b.t || (a.t == b.t && a.body < b.body); });
  return jumps;
}

}  // namespace particulate::scattering
