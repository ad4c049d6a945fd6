// The share gamma of a step that an impact is said to last hardly matters, with near fields on.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::gamma_insensitive {

using namespace particulate;

using Cloud = scenes::Scene<kinematics::Space, laws::NearField,
                            contact::Contact<contact::ConstantRestitution, contact::Friction>>;

struct End {
  schemes::State state;
  long impacts;
  double energy;  // kinetic
};

constexpr double t_end = 0.8;
constexpr long steps = 800;

End run(const kinematics::Particles& start, double gamma) {
  contact::Contact<contact::ConstantRestitution, contact::Friction> law = rough(0.5, {.mu_s = 0.2, .mu_d = 0.1});
  law.gamma = gamma;
  Cloud cloud{start, {}, book_near_field, law};
  schemes::State state = scenes::start(cloud);
  const long impacts = march<schemes::VelocityVerlet>(cloud, state, t_end, steps).impacts;
  return {.state = state, .impacts = impacts, .energy = kinematics::kinetic_energy(start.mass, as_rows(state.v))};
}

// Two unit masses 1 m apart under alpha1 = 3 N, alpha2 = 1 N attract with 2 N each: the approach gains 4 gamma Dt/(1 +
// e) in compression, and each velocity after is 1 - (1 + e)/2 (u + D1): exactly linear in gamma.
void one_impact(Rows& rows, double gamma) {
  const double dt = 0.25, u = 1.5, e = 0.6;
  const Encounter at{.i = {.velocity = {u, 0.0, 0.0}, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}};
  contact::Contact<> law = smooth(e);
  law.gamma = gamma;
  const scenes::Scene<kinematics::Space, laws::NearField, contact::Contact<>> pair{
      touching_pair(at), {}, laws::NearField{.alpha1 = 3.0, .alpha2 = 1.0}, law};
  const double without = u * (1.0 + e) / 2.0;
  rows.compare(fmt::format("one impact, gamma = {}: v_j' - (1 + e) u/2 = 2 gamma Dt [m/s]", gamma),
               {.expected = 2.0 * gamma * dt,
                .computed = jump_of(pair, dt).v(1, 0) - without,
                .tolerance = absolute(1e-15),
                .because = "differences of numbers near 1, each rounded a few times"});
}

const Case gamma_insensitive{
    {.name = "gamma_insensitive",
     .claim = "with near fields on, results for gamma = 1e-2 to 1e-6 approach their limit in proportion to gamma",
     .equation = "M 2.18",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const std::vector<double> gammas{1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
      for (const double gamma : gammas) one_impact(rows, gamma);
      const kinematics::Particles start = closing_cloud(rows.case_seed(), 8, 1.0);
      const End limit = run(start, 1e-12);
      std::vector<double> off;
      for (const double gamma : gammas) {
        const End seen = run(start, gamma);
        off.push_back((seen.state.r - limit.state.r).norm() / limit.state.r.norm());
        rows.equal(fmt::format("cloud, gamma = {}: impacts", gamma),
                   {.expected = limit.impacts,
                    .computed = seen.impacts,
                    .because = "the same contacts as at gamma = 1e-12, else the results are not comparable"});
        rows.at_most(fmt::format("cloud, gamma = {}: final kinetic energy against gamma = 1e-12, over gamma", gamma),
                     {.limit = 1.0,
                      .computed = std::abs(seen.energy - limit.energy) / limit.energy / gamma,
                      .because = "each impact moves velocities by a gamma Dt, with accelerations up to some 10 m/s^2, "
                                 "a step of 1 ms and speeds near 1: 1e-2 gamma an impact, tens of impacts"});
      }
      rows.at_least("cloud: impacts", {.limit = 8.0,
                                       .computed = static_cast<double>(limit.impacts),
                                       .because = "as many as particles at least, else gamma is hardly tried"});
      rows.order("cloud: positions at the end against gamma = 1e-12, order in gamma",
                 {.nominal = 1.0,
                  .steps = gammas,
                  .errors = off,
                  .floor = 1e-15,
                  .because = "D1 and D2 are linear in gamma; the limit's own gamma is a millionth of the smallest"});
    }};

}  // namespace verification::gamma_insensitive
