// The granular gas: a gas of hard spheres against kinetic theory, elastic and cooling.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/report/spread.hpp>

#include "granular_gas.hpp"

namespace verification::granular_gas {

using namespace particulate;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Eigen::Index N = 4000;
constexpr double phi = 0.1;

// An elastic gas in which each sphere has had ten impacts, and where it is.
struct Equilibrium {
  contact::HardSpheres<> gas;
  schemes::State state;
};
Equilibrium in_equilibrium(const GranularGas& of, std::uint64_t seed) {
  contact::HardSpheres<> gas = elastic_gas(of, seed);
  schemes::State state = start(gas);
  require_reached(gas.advance(state, 10.0 / of.impact_rate(1.0)));
  state.t = state.t_carry = 0.0;
  return {gas, state};
}

// What theory and a gas say at some times of a run, over each other.
void compare(Rows& rows, const std::string& name, const Sample& ratio, double allowed, const char* because) {
  rows.compare(name, {.expected = 1.0, .computed = ratio.mean(), .tolerance = absolute(allowed), .because = because});
  rows.at_most("standard error of " + name,
               {.limit = 0.5 * allowed, .computed = ratio.error(), .because = "else the claim says nothing"});
}

const Case elastic{
    {.name = "gas_elastic",
     .claim = "an elastic gas becomes Maxwell's, keeps its energy, and meets as often and as fast as Enskog says",
     .equation = "D 4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const GranularGas of{.N = N, .phi = phi, .e = 1.0};
      const std::uint64_t seeds = rows.quick() ? 4 : 16;
      constexpr double impacts = 20.0;
      constexpr std::size_t bins = 24;
      Sample rate, speed;
      std::array<double, bins> count{};
      double energy_off = 0.0, momentum_off = 0.0, overlap = 0.0;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        auto [gas, state] = in_equilibrium(of, rows.case_seed() + seed);
        const double T = temperature(state), t_end = impacts / of.impact_rate(T);
        double fast = 0.0;
        const schemes::Outcome outcome =
            gas.advance(state, t_end, [&](const contact::Collision& one) { fast += one.approach_speed; });
        require_reached(outcome);
        const double n = static_cast<double>(outcome.impacts);
        rate.values.push_back(2.0 * n / static_cast<double>(N) / impacts);
        speed.values.push_back(fast / n / std::sqrt(std::numbers::pi * T));
        energy_off = report::worse_of(energy_off, std::abs(temperature(state) / T - 1.0));
        momentum_off = report::worse_of(momentum_off, rows_of(state.v).colwise().mean().cwiseAbs().maxCoeff());
        overlap = report::worse_of(overlap, outcome.overlap / of.diameter());
        for (const double v : state.v) {
          // The normal distribution's integral is even there.
          const double place = 0.5 * std::erfc(-v / std::sqrt(2.0 * T)) * static_cast<double>(bins);
          ++count[std::min(bins - 1, static_cast<std::size_t>(place))];
        }
      }
      compare(rows, "impacts over Enskog's", rate, 0.01,
              "cases of some 1e5 impacts; Carnahan and Starling's chi is good to 0.1 %");
      compare(rows, "mean normal speed of impacts over sqrt(pi T/m)", speed, 0.01, "as that of the rate");
      const double expected = 3.0 * static_cast<double>(N) * static_cast<double>(seeds) / bins;
      double chi_square = 0.0;
      for (const double n : count) chi_square += (n - expected) * (n - expected) / expected;
      rows.compare("chi-square of velocities in 24 classes, Maxwell's [-]",
                   {.expected = bins - 1.0,
                    .computed = chi_square,
                    .tolerance = absolute(4.0 * std::sqrt(2.0 * (bins - 1.0))),
                    .because = "four standard deviations of chi-square"});
      rows.at_most("change of the energy over it",
                   {.limit = 200.0 * eps,
                    .computed = energy_off,
                    .because = "40000 impacts, each with some roundings of either sign"});
      rows.at_most("mean velocity [m/s]",
                   {.limit = 100.0 * eps, .computed = momentum_off, .because = "roundings of either sign"});
      rows.at_most("deepest overlap over the diameter",
                   {.limit = 1e-13, .computed = overlap, .because = "roundings of places and periods"});
    }};

// When, in tau, a particle has had so many impacts by Haff's law.
double of_tau(double impacts, double e) { return std::expm1(impacts * (1.0 - e * e) / 6.0); }

// What a cooling gas has been through at some moments.
struct Cooling {
  double e, most_impacts;  // a particle, up to which T_g is claimed
  double temperature_off;  // allowed [-]
};

const Case cooling{
    {.name = "gas_cooling",
     .claim = "a granular gas cools by Haff's law until velocities become correlated; its impacts and impulses add up "
              "as kinetic theory has it",
     .equation = "D 4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const std::uint64_t seeds = rows.quick() ? 4 : 16;
      std::vector<Equilibrium> starts;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        starts.push_back(in_equilibrium({.N = N, .phi = phi, .e = 1.0}, rows.case_seed() + seed));
      }
      report::Table shown({"restitution [-]", "impacts a particle [-]", "time / tau [-]", "T / T_0 [-]", "T / Haff [-]",
                           "standard error [-]"});
      for (const auto& [e, most, off] :
           {Cooling{0.95, 36.0, 0.01}, Cooling{0.9, 12.0, 0.015}, Cooling{0.8, 6.0, 0.02}}) {
        const GranularGas of{.N = N, .phi = phi, .e = e};
        const double last = rows.quick() ? 36.0 : 60.0;
        std::vector<double> moments;  // in impacts a particle
        for (double c = 3.0; c <= last; c += 3.0) moments.push_back(c);
        std::vector<Sample> T(moments.size()), impacts(moments.size()), impulses(moments.size());
        for (const auto& [before, equilibrium] : starts) {
          contact::HardSpheres<> gas(before.particles(), before.domain(), {e});
          schemes::State state = equilibrium;
          const double T_0 = temperature(state), tau = of.cooling_time(T_0), nu = of.impact_rate(T_0);
          long met = 0;
          double impulse = 0.0;
          for (std::size_t k = 0; k < moments.size(); ++k) {
            const double x = of_tau(moments[k], e);
            require_reached(gas.advance(state, x * tau, [&](const contact::Collision& one) {
              ++met;
              impulse += std::abs(one.impulse.normal);
            }));
            T[k].values.push_back(temperature(state) / T_0 * (1.0 + x) * (1.0 + x));
            impacts[k].values.push_back(2.0 * static_cast<double>(met) / static_cast<double>(N) / moments[k]);
            // pi (1 + e) n s^2 chi T_0 tau x/(1 + x), with the rate 4 sqrt(pi) n s^2 chi sqrt(T_0)
            const double expected = 0.25 * std::sqrt(std::numbers::pi * T_0) * (1.0 + e) * nu * tau * x / (1.0 + x);
            impulses[k].values.push_back(impulse / static_cast<double>(N) / expected);
          }
        }
        for (std::size_t k = 0; k < moments.size(); ++k) {
          const double x = of_tau(moments[k], e);
          shown.add({e, moments[k], x, T[k].mean() / ((1.0 + x) * (1.0 + x)), T[k].mean(), T[k].error()});
        }
        const auto worst = [&](const std::vector<Sample>& samples, double from, double to) {
          const Sample* found = nullptr;
          for (std::size_t k = 0; k < moments.size(); ++k) {
            if (moments[k] < from || moments[k] > to) continue;
            if (!found || std::abs(samples[k].mean() - 1.0) > std::abs(found->mean() - 1.0)) found = &samples[k];
          }
          return *found;
        };
        const std::string which = fmt::format(", e = {}", e);
        compare(rows, fmt::format("T over Haff's, farthest off up to {} impacts{}", most, which), worst(T, 0.0, most),
                off, "velocities become correlated, the more the less elastic: beyond, the law does not hold");
        compare(rows, "impacts over 6/(1 - e^2) ln(1 + t/tau), farthest off from 12 on" + which,
                worst(impacts, 12.0, 60.0), 0.015, "the leading order in Sonine's polynomials, and correlations");
        compare(rows, "summed impulses over theory, farthest off from 12 impacts on" + which,
                worst(impulses, 12.0, 60.0), 0.015, "the leading order in Sonine's polynomials, and correlations");
      }
      rows.write("gas_cooling", shown);
    }};

}  // namespace verification::granular_gas
