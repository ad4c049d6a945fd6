#include <particulate/fluid/drag.hpp>

#include <array>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::fluid {

namespace {

// C_D = factor Re^power from one Reynolds number to the next.
struct Branch {
  double to, factor, power;
};
constexpr std::array<Branch, 5> branches = {{{1.0, 24.0, -1.0},
                                             {400.0, 24.0, -0.646},
                                             {drag_crisis, 0.5, 0.0},
                                             {2e6, 0.000366, 0.4275},
                                             {std::numeric_limits<double>::infinity(), 0.18, 0.0}}};

std::string text_of(const Stream& stream) {
  return fmt::format("{} kg/m^3, {} Pa s, {} K and ({}, {}, {}) m/s", stream.rho, stream.mu, stream.theta, stream.v.x(),
                     stream.v.y(), stream.v.z());
}

}  // namespace

void validate(const Stream& stream) {
  if (is_value(stream)) return;
  throw std::invalid_argument("stream: density, viscosity and temperature must be positive, and all finite, got " +
                              text_of(stream));
}

double drag_coefficient(double Re) {
  for (const Branch& branch : branches) {
    if (Re <= branch.to) return branch.factor * std::pow(Re, branch.power);
  }
  return Re;  // NaN
}

double drag_rate(const Stream& fluid, double b, double u) {
  const double Re = 2.0 * b * fluid.rho * u / fluid.mu;
  if (Re <= 1.0) return 6.0 * std::numbers::pi * fluid.mu * b;
  return 0.5 * drag_coefficient(Re) * fluid.rho * u * std::numbers::pi * b * b;
}

// On each branch 8 rho F/(pi mu^2) = C_D Re^2 is a power of Re. Roots factor by factor: it may be beyond a double.
std::vector<double> steady_speeds(const Stream& fluid, double b, double force) {
  validate(fluid);
  if (!(b > 0.0 && std::isfinite(b) && force >= 0.0 && std::isfinite(force))) {
    throw std::invalid_argument(fmt::format(
        "steady speeds: the radius must be positive, the force not negative, and both finite, got {} m and {} N", b,
        force));
  }
  const double unit = fluid.mu / fluid.rho;
  std::vector<double> speeds;
  double from = -1.0;
  for (const Branch& branch : branches) {
    const double root = 1.0 / (2.0 + branch.power), mu = std::pow(fluid.mu, root);
    const double Re =
        std::pow(8.0 * force / (std::numbers::pi * branch.factor), root) * std::pow(fluid.rho, root) / mu / mu;
    if (Re > from && Re <= branch.to) speeds.push_back(Re * unit / (2.0 * b));
    from = branch.to;
  }
  return speeds;
}

void detail::require_finite_gravity(const Eigen::Vector3d& g) {
  if (g.allFinite()) return;
  throw std::invalid_argument(fmt::format("buoyancy: g must be finite, got ({}, {}, {}) m/s^2", g.x(), g.y(), g.z()));
}

std::string detail::no_stream(Eigen::Index particle, const Eigen::Vector3d& place, const Stream& there) {
  return fmt::format("particle {} at ({:.6g}, {:.6g}, {:.6g}) m is where there is no fluid, or none that can be: {}",
                     particle, place.x(), place.y(), place.z(), text_of(there));
}

}  // namespace particulate::fluid
