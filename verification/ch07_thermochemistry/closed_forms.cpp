// Bonds, tapered potentials, cooling and runaway in closed form.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <particulate/scenes/staggered_scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/thermo/arrhenius.hpp>
#include <particulate/thermo/cooling.hpp>

#include "spheres.hpp"

namespace verification::thermo_closed_forms {

using namespace particulate;

// What draws the first of a pair to the second, as the forces of a scene have it [N].
template <class... Laws>
double pull_at(double d, const kinematics::Particles& pair_at_1, const Laws&... laws) {
  kinematics::Particles pair = pair_at_1;
  pair.position *= d;
  const scenes::Scene scene(pair, kinematics::Space{}, laws...);
  Eigen::VectorXd force(6);
  if (!scene.total_force(scenes::start(scene), force)) return missing;
  return rows_of(force).row(0).dot(pair_at_1.position.row(1) - pair_at_1.position.row(0));
}

double book_pull(double d) { return pull_at(d, book_pair(1.0), book_near_field, book_binding); }

double root(const std::function<double(double)>& f, double low, double high) {
  const bool rises = f(high) > 0.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == rises ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

// Fourth-order differences.
double slope(const std::function<double(double)>& f, double x, double h) {
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

constexpr double at_rest = 0.0555182484196815, barrier = 0.0763627069013835, to_escape = 1.0065096803911;

auto bound_pair(double apart, double parting) {
  return scenes::Scene(book_pair(apart, parting), kinematics::Space{}, book_near_field, book_binding);
}

const Case bond{
    {.name = "bound_pair",
     .claim = "a bound pair of chapter 4's spheres rests, oscillates and is held as its energy has it",
     .equation = "R 7.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto row = [&](const std::string& what, double expected, double computed, double off, const char* because) {
        rows.compare(what,
                     {.expected = expected, .computed = computed, .tolerance = relative(off), .because = because});
      };
      row("equilibrium [m]", at_rest, root(book_pull, 0.052, 0.06), 1e-13,
          "forces of 1 N/kg^2 that cancel to rounding");
      row("barrier [m]", barrier, root(book_pull, 0.07, 0.08), 1e-13, "likewise");
      row("stiffness over m^2 [N/(m kg^2)]", 23001.8434894926,
          slope(book_pull, at_rest, 1e-5) / (book_mass * book_mass), 1e-10, "differences of fourth order over 1e-5 m");
      const auto scene = bound_pair(at_rest * (1.0 + 1e-4), 0.0);
      const std::vector<Turning> turns = turnings<schemes::RungeKutta4>(scene, scenes::start(scene), 2e-4, 3);
      row("small period, measured [s]", 0.0809681530916857, turns[2].t - turns[0].t, 1e-6,
          "the square of the amplitude over the width of the bond, and the rounding of a turning");
      const auto energy = [](double d) {
        const auto pair = bound_pair(d, 0.0);
        return pair.potential_energy(scenes::start(pair));
      };
      row("escape by energies [m/s]", to_escape, std::sqrt(4.0 * (energy(barrier) - energy(at_rest)) / book_mass),
          1e-12, "differences of energies");
      for (const double off : {1e-3, -1e-3}) {
        const auto parting_pair = bound_pair(at_rest, to_escape * (1.0 + off));
        schemes::State state = scenes::start(parting_pair);
        advance<schemes::RungeKutta4>(parting_pair, state, 0.2, 2000);
        rows.equal(fmt::format("escapes, faster by {:+}", off),
                   {.expected = off > 0.0,
                    .computed = distance_of_pair(state) > barrier,
                    .because = "it is as far from the barrier in energy, and RK4 makes 1e-8"});
      }
    }};

// Between unit masses, d_c = 1 and w = 0.4.
const Case taper{{.name = "tapered_potential",
                  .claim = "the potential of a tapered force is its integral: V' = S C, zero from the cut-off on",
                  .equation = "D 7.3",
                  .reference = Reference::independent_method},
                 [](Rows& rows) {
                   const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.25, .cutoff = 1.0, .taper = 0.4};
                   kinematics::Particles unit = book_pair(1.0);
                   unit.mass.setOnes();
                   const auto pull = [&](double d) { return pull_at(d, unit, law); };
                   const auto V = [&](double d) {
                     kinematics::Particles pair = unit;
                     pair.position *= d;
                     const scenes::Scene scene(pair, kinematics::Space{}, law);
                     return scene.potential_energy(scenes::start(scene));
                   };
                   for (const auto& [d, expected] : {std::pair{0.5, -0.0483486289836249}, {0.05, 3.30035882451935}}) {
                     rows.compare(fmt::format("V({}) - V(d_c) [J]", d),
                                  {.expected = expected,
                                   .computed = V(d) - V(1.0),
                                   .tolerance = relative(1e-13),
                                   .because = "Gauss's rule over the taper, to 1e-13"});
                   }
                   using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
                   for (const double d : {0.3, 0.61, 0.8, 0.97}) {
                     const double u = std::max(0.0, (d - 0.6) / 0.4), S = 1.0 - u * u * (3.0 - 2.0 * u);
                     rows.compare(fmt::format("force at {} m [N]", d), {.expected = S * (0.5 / d - 0.25 / (d * d)),
                                                                        .computed = pull(d),
                                                                        .tolerance = relative(1e-13),
                                                                        .because = "rounding, of places too"});
                     rows.compare(fmt::format("V at {} m [J]", d),
                                  {.expected = -Quadrature::integrate(pull, d, std::max(d, 0.6), 0) -
                                               Quadrature::integrate(pull, std::max(d, 0.6), 1.0, 0),
                                   .computed = V(d),
                                   .tolerance = mixed(1e-12, 1e-13),
                                   .because = "polynomials over d, by 31 points"});
                   }
                   rows.none("V at 1 and 2 m that are not 0", (V(1.0) != 0.0) + (V(2.0) != 0.0), "the force has ended");
                 }};

// A sphere of 1 mm, 2000 kg/m^3 and 1000 J/(kg K).
kinematics::Particles small_sphere(double theta) {
  const double mass = 2000.0 * thermo::surface(1e-3) * 1e-3 / 3.0;
  return warmed(kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = mass, .radius = 1e-3}}), theta, 1000.0);
}

double temperature_after(const thermo::Cooling& law, double theta_0, double t) {
  const scenes::Scene scene(small_sphere(theta_0), kinematics::Space{}, law);
  schemes::State state = scenes::start(scene);
  advance<schemes::Collocation<schemes::Gauss<4>>>(scene, state, t, 60);
  return state.y[0];
}

const Case cooling{
    {.name = "cooling_times",
     .claim = "a sphere cools by convection, radiation and both in the times that quadrature gives, and ends where "
              "both balance",
     .equation = "D 7.4.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto compare = [&](const std::string& what, const thermo::Cooling& law, double theta, double t) {
        rows.compare(what + fmt::format(" from 1000 K after {} s [K]", t),
                     {.expected = theta,
                      .computed = temperature_after(law, 1000.0, t),
                      .tolerance = relative(1e-12),
                      .because = "sixty steps of order 8, and rounding"});
      };
      const thermo::Cooling both{.h_c = 50.0, .theta_o = 300.0, .emissivity = 0.8, .theta_s = 300.0};
      compare("convection and radiation", both, 500.0, 10.9556577809934);
      thermo::Cooling apart = both;
      apart.theta_o = 350.0;
      compare("convection to 350 K, radiation to 300 K", apart, 400.0, 23.5197060124263);
      compare("radiation to 300 K", {.emissivity = 1.0, .theta_s = 300.0}, 500.0, 29.319567692972);
      compare("radiation to 0 K", {.emissivity = 1.0, .theta_s = 0.0}, 500.0, 27.433030706813);
      const double tau = 2000.0 / 3.0 / 50.0;
      compare("convection to 300 K", {.h_c = 50.0}, 300.0 + 700.0 * std::exp(-1.5), 1.5 * tau);
      const double k = thermo::stefan_boltzmann * 3.0 / 2000.0;
      for (const auto& [theta_s, t] : {std::pair{300.0, 29.319567692972}, {0.0, 27.433030706813}}) {
        rows.compare(fmt::format("closed form of radiation to {} K [s]", theta_s),
                     {.expected = t,
                      .computed = thermo::radiation_time(k, 1000.0, 500.0, theta_s),
                      .tolerance = relative(1e-13),
                      .because = "rounding"});
      }
      const thermo::Cooling balanced{.h_c = 100.0, .theta_o = 600.0, .emissivity = 1.0, .theta_s = 300.0};
      const double balance = 551.961402904145;
      rows.compare("where both balance [K]", {.expected = balance,
                                              .computed = thermo::equilibrium_temperature(balanced),
                                              .tolerance = relative(1e-14),
                                              .because = "bisection to rounding"});
      rows.compare("where a run ends [K]", {.expected = balance,
                                            .computed = temperature_after(balanced, 400.0, 200.0),
                                            .tolerance = relative(1e-12),
                                            .because = "after forty times what it takes"});
    }};

// Where a sphere that heats itself is at a time, by Radau collocation of order 5 and Newton's method [K].
double runaway_to(double t) {
  const scenes::Scene scene(small_sphere(300.0), kinematics::Space{}, thermo::Arrhenius{.power = 1e15, .T_a = 1e4});
  const schemes::State start = scenes::start(scene);
  const scenes::Temperatures<decltype(scene)> field{.scene = scene, .at = start};
  schemes::State own{.t = 0.0, .y = start.y};
  reach(field, own, t, schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>(),
        schemes::ErrorControl{.TOL = 1e-13, .sweep_TOL = 1e-14});
  return own.y[0];
}

const Case runaway{
    {.name = "thermal_runaway",
     .claim = "a reaction that heats itself takes most of an hour to become warm, and then 3 microseconds",
     .equation = "D 7.4.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const auto& [theta, t] : {std::pair{1000.0, 2874.42326588661}, {3000.0, 2874.42326874214}}) {
        // Times, because at the end no double tells the time within which the temperature does not change.
        const double reached = runaway_to(t), rate = 1e12 * std::exp(-1e4 / theta);
        rows.compare(fmt::format("a run comes to {} K [s]", theta),
                     {.expected = t,
                      .computed = t - (reached - theta) / rate,
                      .tolerance = absolute(2e-10),
                      .because = "rounding of 1e4/300 in an exponent makes 1e-11 s"});
        rows.compare(fmt::format("closed form to {} K [s]", theta),
                     {.expected = t,
                      .computed = thermo::runaway_time(1e12, 1e4, 300.0, theta),
                      .tolerance = relative(1e-14),
                      .because = "rounding"});
      }
      const auto inverse_rate = [](double theta) { return 1e-12 * std::exp(1e4 / theta); };
      rows.compare(
          "closed form from 1000 to 3000 K [s]",
          {.expected = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(inverse_rate, 1e3, 3e3, 8),
           .computed = thermo::runaway_time(1e12, 1e4, 1000.0, 3000.0),
           .tolerance = relative(1e-12),
           .because = "a difference of two numbers of the same size"});
    }};

}  // namespace verification::thermo_closed_forms
