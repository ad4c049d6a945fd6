// Becker's shock: a viscous gas that conducts heat, of which all is known, at rest and on its way.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification::shocks {

using namespace particulate;
using namespace particulate::fluid;

// Pr = 3/4, gamma = 1.4. Units: density and speed of the gas that comes are one, so is mu; R = 1.
struct Shock {
  double M;
  double moves = 0.0;  // towards lower x [rho_1 and mu as units]

  static constexpr double gamma = 1.4, c = 2.5;

  double behind() const { return ((gamma - 1.0) + 2.0 / (M * M)) / (gamma + 1.0); }
  // Place of a speed v, x = 8 gamma/(3 (gamma + 1)) (ln(1 - v) - v_f ln(v - v_f))/(1 - v_f).
  double place(double ahead, double over) const {
    const double v_f = behind();
    return 8.0 * gamma / (3.0 * (gamma + 1.0)) * (std::log(ahead) - v_f * std::log(over)) / (1.0 - v_f);
  }
  // Speed at a place, 0 being that of the mean speed: Newton's method for q, 1 - v = (1 - v_f)/(1 + e^-q).
  double speed(double x) const {
    const double v_f = behind(), range = 1.0 - v_f, middle = place(0.5 * range, 0.5 * range);
    double q = 0.0;
    for (int k = 0; k < 60; ++k) {
      const double share = 1.0 / (1.0 + std::exp(-q));  // of 1 - v
      const double rest = 1.0 / (1.0 + std::exp(q));
      const double slope = 8.0 * gamma / (3.0 * (gamma + 1.0)) * (rest + v_f * share) / range;
      const double change = (place(range * share, range * rest) - middle - x) / slope;
      q -= change;
      if (std::abs(change) < 1e-14) break;
    }
    return 1.0 - range / (1.0 + std::exp(-q));
  }
  // gamma c theta + v^2/2 stays.
  Local<1> at(double t, double x) const {
    const double v = speed(x + moves * t);
    return {
        .rho = 1.0 / v, .v = Vector<1>(v - moves), .theta = 1.0 / (M * M * gamma) + (1.0 - v * v) / (2.0 * gamma * c)};
  }
};

// What n cells around a shock hold after a time, started and fed with the exact profile.
struct Run {
  GasFlow<1> flow;
  schemes::State state;
};
Run run(const Shock& shock, double width, double end, Eigen::Index n) {
  const Given<1> known{[&shock](double t, const Vector<1>& x) { return shock.at(t, x[0]); }};
  const Fluid<continuum::IdealGas> gas{
      .state = {.R = 1.0}, .viscosity = {.mu = 1.0}, .c = Shock::c, .K = Shock::gamma * Shock::c / 0.75};
  // The shock is in the middle half-way through.
  Grid<1> grid{.cells = {n}};
  grid.lengths[0] = width;
  grid.corner[0] = -0.5 * width - 0.5 * shock.moves * end;
  Run made{GasFlow<1>(grid, gas, {known, known}), {}};
  made.state = made.flow.start([&](const Vector<1>& x) { return shock.at(0.0, x[0]); });
  const double h = width / static_cast<double>(n);
  advance<schemes::RungeKutta4>(made.flow, made.state, end, static_cast<long>(end / (0.3 * h * h)) + 1);
  return made;
}

// Where the profile falls to a speed, by the polynomial through the six cells around.
double place_of(const Run& made, double v) {
  Eigen::Index i = 2;
  while (made.flow.local(made.state, i + 1).v[0] > v) ++i;
  std::array<double, 6> x{}, at{};
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Index cell = i - 2 + static_cast<Eigen::Index>(k);
    x[k] = made.flow.grid().centre({cell})[0], at[k] = made.flow.local(made.state, cell).v[0];
  }
  double place = 0.0;
  for (std::size_t k = 0; k < 6; ++k) {
    double weight = 1.0;
    for (std::size_t m = 0; m < 6; ++m) weight *= m == k ? 1.0 : (v - at[m]) / (at[k] - at[m]);
    place += weight * x[k];
  }
  return place;
}

struct Setting {
  double M, width, end, from, to, span;
};
constexpr std::array settings{Setting{1.5, 20.0, 3.0, 0.95, 0.6, 10.3807429854605},
                              Setting{3.0, 10.0, 4.0, 0.9, 0.4, 4.58791228875445}};
const std::vector<Eigen::Index> grids{40, 50, 64, 80, 100};

const Case profile{
    {.name = "becker_shock",
     .claim = "a shock keeps its profile, whether it stands or runs into a gas at rest, but for an error of order two",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto check = [&](const char* how, const Setting& of, double moves) {
        const Shock shock{.M = of.M, .moves = moves};
        std::vector<double> steps;
        std::array<std::vector<double>, 3> errors;
        for (const Eigen::Index n : grids) {
          const Run made = run(shock, of.width, of.end, n);
          std::array<double, 3> worst{};
          for (Eigen::Index i = 0; i < n; ++i) {
            const Local<1> is = made.flow.local(made.state, i);
            const Local<1> must = shock.at(of.end, made.flow.grid().centre({i})[0]);
            worst[0] = std::max(worst[0], std::abs(is.rho - must.rho) * shock.behind());
            worst[1] = std::max(worst[1], std::abs(is.v[0] - must.v[0]));
            worst[2] = std::max(worst[2], std::abs(is.theta / must.theta - 1.0));
          }
          steps.push_back(of.width / static_cast<double>(n));
          for (std::size_t f = 0; f < 3; ++f) errors[f].push_back(worst[f]);
        }
        const std::array names{"density", "velocity", "temperature"};
        for (std::size_t f = 0; f < 3; ++f) {
          rows.order(
              fmt::format("M = {}, {}: {}, largest", of.M, how, names[f]),
              {.nominal = 2.0, .steps = steps, .errors = errors[f], .floor = 1e-12, .because = "central differences"});
        }
      };
      for (const Setting& of : settings) {
        check("at rest", of, 0.0);
        check("into a gas at rest", of, 1.0);
      }
    }};

const Case thickness{
    {.name = "becker_shock_thickness",
     .claim = "between two speeds a shock is as thick as its closed form says",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const Setting& of : settings) {
        std::vector<double> steps, thick, errors;
        for (const Eigen::Index n : grids) {
          const Run made = run({.M = of.M}, of.width, 12.0, n);  // near rest again
          steps.push_back(of.width / static_cast<double>(n));
          thick.push_back(place_of(made, of.to) - place_of(made, of.from));
          errors.push_back(std::abs(thick.back() / of.span - 1.0));
        }
        rows.order(
            fmt::format("M = {}: distance", of.M),
            {.nominal = 2.0, .steps = steps, .errors = errors, .floor = 1e-12, .because = "central differences"});
        const double ratio = std::pow(steps[3] / steps[4], 2);
        rows.compare(fmt::format("M = {}: distance, extrapolated [mu/(rho_1 u_1)]", of.M),
                     {.expected = of.span,
                      .computed = (ratio * thick[4] - thick[3]) / (ratio - 1.0),
                      .tolerance = relative(1e-5),
                      .because = "h^4; the finest grid is off by 1e-5 to 1e-4"});
      }
    }};

}  // namespace verification::shocks
