// The heat of a gas whose impacts are far weaker than a full reaction.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/verlet.hpp>

#include "../ch04_simulations/granular_gas.hpp"
#include "spheres.hpp"

namespace verification::gas_heat {

using namespace particulate;

constexpr thermo::ImpactHeat weak{.kappa = 1.0, .J_star = 1e3};

// What the impacts of an event-driven gas become, by the law of the library [J].
struct Sums {
  double released = 0.0, dissipated = 0.0, impulses = 0.0;
};
contact::CollisionRecorder into(Sums& sums, double e, double radius) {
  return [&sums, e, radius](const contact::Collision& one) {
    contact::ImpactRecord record{.i = one.i, .j = one.j, .n = one.n, .push = std::abs(one.impulse.normal)};
    record.before = one.approach_speed * one.n, record.after = -e * one.approach_speed * one.n;
    sums.released += thermo::released_energy(weak, record.push, radius);
    sums.dissipated += thermo::dissipated_energy(record);
    sums.impulses += record.push;
  };
}

// An elastic gas after ten impacts a sphere.
schemes::State settled(contact::HardSpheres<>& gas, const GranularGas& of) {
  schemes::State state = start(gas);
  require_reached(gas.advance(state, 10.0 / of.impact_rate(1.0)));
  state.t = state.t_carry = 0.0;
  return state;
}

const Case theory{
    {.name = "heat_of_a_gas",
     .claim = "a granular gas whose impacts are far weaker than J* becomes as warm as kinetic theory's sum of impulses "
              "says, and dissipates (3/2) (T_0 - T) a particle",
     .equation = "D 7.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const GranularGas of{.N = 4000, .phi = 0.1, .e = 0.9}, elastic{.N = 4000, .phi = 0.1, .e = 1.0};
      Sample ratio;
      double off = 0.0;
      for (std::uint64_t seed = 0; seed < (rows.quick() ? 3u : 8u); ++seed) {
        contact::HardSpheres<> before = elastic_gas(elastic, rows.case_seed() + seed);
        schemes::State state = settled(before, elastic);
        contact::HardSpheres<> gas(before.particles(), before.domain(), {of.e});
        const double T_0 = temperature(state), tau = of.cooling_time(T_0), radius = 0.5 * of.diameter();
        const double x = std::expm1(12.0 * (1.0 - of.e * of.e) / 6.0);  // twelve impacts a sphere, in tau
        Sums sums;
        require_reached(gas.advance(state, x * tau, into(sums, of.e, radius)));
        // (kappa pi b^2/J*) pi (1 + e) n s^2 chi T_0 tau x/(1 + x) a particle, n = N in the unit cube.
        const double s = of.diameter(), N = 4000.0;
        const double impulse =
            std::numbers::pi * (1.0 + of.e) * N * s * s * of.pair_correlation() * T_0 * tau * x / (1.0 + x);
        const double expected = weak.kappa * std::numbers::pi * radius * radius / weak.J_star * impulse;
        ratio.values.push_back(sums.released / N / expected);
        off = report::worse_of(off, std::abs(sums.dissipated / (1.5 * N * (T_0 - temperature(state))) - 1.0));
      }
      rows.compare("mean heat of the reaction over (kappa pi b^2/J*) (1/N) sum J of theory",
                   {.expected = 1.0,
                    .computed = ratio.mean(),
                    .tolerance = absolute(0.015),
                    .because = "the leading order in Sonine's polynomials, and correlations"});
      rows.at_most("its standard error",
                   {.limit = 0.0075, .computed = ratio.error(), .because = "else it says nothing"});
      rows.at_most("farthest dissipated energy from (3/2) N (T_0 - T), relative",
                   {.limit = 1e-12, .computed = off, .because = "rounding of 24000 impacts, each a part of 1e-5"});
    }};

// The same by a scene with located contacts, from the same start, as long as rounding has not parted the two.
const Case scene{
    {.name = "heat_of_a_gas_in_a_scene",
     .claim = "a scene with located contacts heats its gas as the event-driven gas has it, impact by impact",
     .equation = "R 7.4.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const GranularGas of{.N = 64, .phi = 0.1, .e = 0.8};
      const contact::HardSpheres<> first = elastic_gas(of, rows.case_seed());
      contact::HardSpheres<> gas(first.particles(), first.domain(), {of.e});
      const double t_end = 3.0 / of.impact_rate(1.0), radius = 0.5 * of.diameter();
      schemes::State by_events = start(gas);
      Sums sums;
      const schemes::Outcome known = gas.advance(by_events, t_end, into(sums, of.e, radius));
      require_reached(known);
      const scenes::Scene warm(warmed(gas.particles(), 1.0, 1.0), gas.domain(),
                               contact::LocatedContact<>{.restitution = {of.e}}, weak);
      schemes::State state = scenes::start(warm);
      const schemes::Outcome outcome =
          reached(warm, state, t_end, schemes::VelocityVerlet{}, schemes::FixedStep{.step = t_end / 32.0});
      rows.equal("impacts", {.expected = known.impacts, .computed = outcome.impacts, .because = "the same motion"});
      rows.at_least("impacts",
                    {.limit = 50.0, .computed = static_cast<double>(known.impacts), .because = "else it says little"});
      const char* because = "rounding grows with every impact";
      rows.compare(
          "heat of the reaction [J]",
          {.expected = sums.released, .computed = outcome.released, .tolerance = relative(1e-7), .because = because});
      rows.compare("heat of the gas [J]", {.expected = sums.released + sums.dissipated,
                                           .computed = heat_gained(warm.particles(), state.y),
                                           .tolerance = relative(1e-7),
                                           .because = because});
    }};

}  // namespace verification::gas_heat
