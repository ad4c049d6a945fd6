// Heat, bonds and cut-offs that must be borne, however extreme, and those that must be refused.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/contact/impulse_windows.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/scenes/staggered_scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/arrhenius.hpp>
#include <particulate/thermo/clusters.hpp>
#include <particulate/thermo/cooling.hpp>

#include "spheres.hpp"

namespace verification::thermo_extremes {

using namespace particulate;
using kinematics::Space;

Ending within(double error, double tolerance, const char* because) {
  return Ending::solved({.error = error, .tolerance = tolerance, .because = because});
}

// A sphere of 1 mm, 2000 kg/m^3 and 1000 J/(kg K): 3 B/2000 of radiation, a third of a kelvin by 222 J/m^2.
constexpr double k = thermo::stefan_boltzmann * 3.0 / 2000.0;
kinematics::Particles speck(double theta) {
  return warmed(kinematics::particles(
                    {{.position = {0.0, 0.0, 0.0}, .mass = 8.0 / 3.0 * std::numbers::pi * 1e-6, .radius = 1e-3}}),
                theta, 1000.0);
}

// Stiff or not, temperatures alone, by Radau collocation of order 5 and Newton's method.
template <class Law>
double temperature_after(const Law& law, double theta_0, double t) {
  const scenes::Scene scene(speck(theta_0), Space{}, law);
  const schemes::State start = scenes::start(scene);
  const scenes::Temperatures<decltype(scene)> field{.scene = scene, .at = start};
  schemes::State own{.t = 0.0, .y = start.y};
  reach(field, own, t, schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>(),
        schemes::ErrorControl{.TOL = 1e-10, .sweep_TOL = 1e-11});
  return own.y[0];
}

void solve_temperatures(Rows& rows) {
  const auto solve = [&](const std::string& name, const auto& law, double theta_0, double t, double expected,
                         const char* because) {
    rows.must_be_solved(name, [&, theta_0, t, expected] {
      return within(std::abs(temperature_after(law, theta_0, t) / expected - 1.0), 1e-8, because);
    });
  };
  const thermo::Cooling to_nothing{.emissivity = 1.0, .theta_s = 0.0}, to_300{.emissivity = 1.0};
  solve("1e-6 K that is warmed by surroundings of 300 K", to_300, 1e-6, 2.0, 1e-6 + 2.0 * k * 8.1e9,
        "its own radiation is nothing");
  solve("1e5 K that radiates into nothing for 2 s", to_nothing, 1e5, 2.0, std::cbrt(1.0 / (1e-15 + 6.0 * k)),
        "1e-10 of a step, in a hundred steps");
  solve("1e5 K that radiates into nothing for 1e9 s", to_nothing, 1e5, 1e9, std::cbrt(1.0 / (1e-15 + 3e9 * k)),
        "1e-10 of a step, in a hundred steps");
  solve("1e9 s in equilibrium with 300 K", to_300, 1e5, 1e9, 300.0, "it has got there");
  solve("a reaction at 1 K", thermo::Arrhenius{.power = 1e15}, 1.0, 1e9, 1.0, "exp(-1e4) is nothing");
  solve("a surface that does not radiate", thermo::Cooling{.emissivity = 0.0}, 1e5, 1e9, 1e5, "nothing flows");
}

// Two spheres of a metre that meet at 2 m/s, m = 1 and 3 kg [J].
struct Meeting {
  double e = 0.5, kappa = 0.0;
  bool immovable = false;
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();  // of the frame [m/s]
  double length = 1.0;                              // unit of it [m]
};
Eigen::Vector2d warmth_of(const Meeting& of) {
  const auto body = [&](double x, double v, double mass, bool immovable) {
    return kinematics::Particle{.position = {of.length * x, 0.0, 0.0},
                                .velocity = of.length * Eigen::Vector3d(v, 0.0, 0.0) + of.drift,
                                .mass = mass,
                                .radius = 0.5 * of.length,
                                .immovable = immovable,
                                .temperature = 300.0,
                                .heat_capacity = of.length * of.length};
  };
  const kinematics::Particles pair =
      kinematics::particles({body(-0.75, of.immovable ? 0.0 : 1.0, 1.0, of.immovable), body(0.75, -1.0, 3.0, false)});
  const scenes::Scene scene(pair, Space{}, contact::Contact<>{.restitution = {of.e}},
                            thermo::ImpactHeat{.kappa = of.kappa, .J_star = of.length});
  schemes::State state = scenes::start(scene);
  advance<schemes::VelocityVerlet>(scene, state, 1.0, 64);
  return state.y - pair.temperature;
}

void solve_impacts(Rows& rows) {
  const auto solve = [&](const std::string& name, const Meeting& of, double first, double second, const char* because) {
    rows.must_be_solved(name, [=] {
      const Eigen::Vector2d off = warmth_of(of) - Eigen::Vector2d(first, second);
      return within(off.lpNorm<Eigen::Infinity>() / std::max(300.0, second), 1e-14, because);
    });
  };
  // 1/2 m* (1 - e^2) u^2 with m* = 3/4 and u = 2, a half to each; pi/4 of kappa of the reaction, which is full.
  const double quarter = 0.25 * std::numbers::pi;
  solve("e = 0", {.e = 0.0}, 0.75, 0.25, "rounding of 300 K");
  solve("e = 1 without a reaction", {.e = 1.0}, 0.0, 0.0, "nothing is lost");
  solve("kappa = 1e9", {.e = 1.0, .kappa = 1e9}, 0.5e9 * quarter, 0.5e9 * quarter / 3.0, "rounding");
  solve("kappa = 1e9 and e = 0", {.e = 0.0, .kappa = 1e9}, 0.5e9 * quarter + 0.75, 0.5e9 * quarter / 3.0 + 0.25,
        "rounding");
  // 1/2 * 3 (1 - 1/4) 1^2 of the other, at rest and immovable.
  solve("an immovable partner", {.immovable = true}, 0.0, 1.125 / 3.0, "the other gets all of it");
  solve("an immovable partner, kappa = 1", {.kappa = 1.0, .immovable = true}, 0.0, (1.125 + quarter) / 3.0,
        "the other gets all of it");
  solve("a frame that moves by (2^10, -3, 5) m/s", {.drift = {1024.0, -3.0, 5.0}}, 0.5625, 0.1875,
        "roundings of 1e3 m/s, a thousandth of one of 300 K each");
  rows.must_be_solved("lengths of 2^-20 m", [] {
    const Meeting metres{.kappa = 1.0}, micrometres{.kappa = 1.0, .length = 0x1p-20};
    return within((warmth_of(metres) - warmth_of(micrometres)).lpNorm<1>(), 0.0, "powers of two change no bit");
  });
  rows.must_be_solved("no contact", [] {
    const kinematics::Particles apart = warmed(book_pair(1.0, 1.0));
    const scenes::Scene scene(apart, Space{}, book_contact(), thermo::ImpactHeat{.kappa = 8e6});
    schemes::State state = scenes::start(scene);
    advance<schemes::VelocityVerlet>(scene, state, 1.0, 10);
    return within((state.y - apart.temperature).lpNorm<1>(), 0.0, "nothing happens");
  });
  rows.must_be_solved("the same scene flown twice, and its copy", [] {
    const kinematics::Particles start = warmed(book_cloud(100, 1));
    const scenes::Scene scene(start, Space{}, book_near_field, thermo::Binding{.F_b = 2.0, .d_b = 0.15}, book_contact(),
                              thermo::ImpactHeat{.kappa = 1e6, .J_star = 0.1});
    const auto flown = [](const auto& of) {
      schemes::State state = scenes::start(of);
      advance<schemes::VelocityVerlet>(of, state, 0.5, 200);
      return state.y;
    };
    const auto copy = scene;
    const Eigen::VectorXd first = flown(scene);
    return within((flown(scene) - first).lpNorm<1>() + (flown(copy) - first).lpNorm<1>(), 0.0, "the same bits");
  });
}

const Case solved{
    {.name = "thermo_extremes_solved",
     .claim = "temperatures near 0 K and of 1e5 K, 1e9 s, no heat and 1e9 J/m^2, no contact, soft and elastic ones, "
              "immovable partners, other units and frames are solved",
     .equation = "R 7.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      solve_temperatures(rows);
      solve_impacts(rows);
    }};

// What a run says whose spheres rest on each other under a pressure that their own near field makes.
const Case sinking{
    {.name = "sinking_is_said",
     .claim =
         "spheres whose near field attracts at touching sink into each other under stepped contact, and the outcome "
         "says so and what to do; one that repels there does not let them",
     .equation = "R 7.2",
     .reference = Reference::design},
    [](Rows& rows) {
      const auto outcome_of = [](const auto&... laws) {
        kinematics::Particles start = book_cloud(27, 1);
        start.velocity.setZero();
        const scenes::Scene scene(start, Space{}, laws..., contact::Contact<>{.restitution = {0.5}});
        schemes::State state = scenes::start(scene);
        schemes::VelocityVerlet scheme;
        schemes::FixedStep control{.step = 2.5e-3};
        schemes::Outcome outcome = schemes::integrate(scene, state, 1.0, scheme, control);
        require_reached(outcome);
        return outcome;
      };
      const schemes::Outcome attracted = outcome_of(laws::NearField{.alpha1 = 5.0});
      const schemes::Outcome bound = outcome_of(laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25});
      rows.equal("said of what is attracted",
                 {.expected = true,
                  .computed = schemes::describe(attracted).find("of a diameter") != std::string::npos,
                  .because = "beyond a tenth it is said"});
      rows.at_least("largest overlap over the diameter, attracted",
                    {.limit = 0.1, .computed = attracted.penetration, .because = "the cloud falls in upon itself"});
      rows.at_most("largest overlap over the diameter, near field that repels at touching",
                   {.limit = 0.1, .computed = bound.penetration, .because = "it lets nothing rest on another"});
    }};

void refuse_laws(Rows& rows) {
  const kinematics::Particles pair = warmed(book_pair(0.2));
  const auto refuse = [&](const std::string& name, const std::string& key_words, const auto&... laws) {
    rows.must_be_refused(name, key_words, [&] {
      const scenes::Scene scene(pair, Space{}, laws...);
      return scene.particles().size() == 2 ? accepted() : Ending::refused("");
    });
  };
  using thermo::Arrhenius, thermo::Binding, thermo::Cooling, thermo::ImpactHeat, contact::SofteningRestitution;
  const auto soft = [](double theta_r, double theta_star) {
    return contact::Contact<SofteningRestitution>{.restitution = {.theta_r = theta_r, .theta_star = theta_star}};
  };
  const double nan = not_a_number;
  refuse("bonds that end at touching", "binding d_b above sum radii 0.05", Binding{.F_b = 1.0, .d_b = 0.05});
  refuse("bonds that end nowhere", "binding d_b finite inf", Binding{.F_b = 1.0, .d_b = infinite});
  refuse("bonds of nan m", "binding d_b nan", Binding{.F_b = 1.0, .d_b = nan});
  refuse("bonds that push", "binding F_b not negative -1", Binding{.F_b = -1.0, .d_b = 0.08});
  refuse("bonds of nan N/kg^2", "binding F_b nan", Binding{.F_b = nan, .d_b = 0.08});
  const auto cut = [](double cutoff, double taper) {
    laws::NearField law = book_near_field;
    law.cutoff = cutoff, law.taper = taper;
    return law;
  };
  refuse("a taper that begins at d_e", "d_e 0.5 d_c 0.75 d* 1 taper 0.25", cut(0.75, 0.25));
  refuse("a cut-off within d_e", "d_e 0.5 d_c 0.4 d* 1", cut(0.4, 0.0));
  refuse("a cut-off of nan m", "cutoff positive nan", cut(nan, 0.0));
  refuse("a taper of nan m", "taper nan", cut(1.0, nan));
  refuse("a taper longer than the cut-off", "taper between 0 and the cutoff", cut(1.0, 1.5));
  const auto reaction = [&](double kappa, double J_star) { return ImpactHeat{.kappa = kappa, .J_star = J_star}; };
  const contact::Contact<> contact;
  refuse("J* = 0", "J_star positive 0", contact, reaction(1.0, 0.0));
  refuse("J* = -1", "J_star positive -1", contact, reaction(1.0, -1.0));
  refuse("J* = nan", "J_star nan", contact, reaction(1.0, nan));
  refuse("kappa = -1", "kappa not negative -1", contact, reaction(-1.0, 1.0));
  refuse("kappa = nan", "kappa nan", contact, reaction(nan, 1.0));
  refuse("an emissivity of 1.01", "emissivity between 0 and 1 1.01", Cooling{.emissivity = 1.01});
  refuse("an emissivity of -0.1", "emissivity between 0 and 1 -0.1", Cooling{.emissivity = -0.1});
  refuse("an emissivity of nan", "emissivity nan", Cooling{.emissivity = nan});
  refuse("surroundings of -1 K", "theta_s not negative -1", Cooling{.theta_s = -1.0});
  refuse("a flow of -1 K", "theta_o not negative -1", Cooling{.theta_o = -1.0});
  refuse("convection of nan", "h_c nan", Cooling{.h_c = nan});
  refuse("an activation at 0 K", "T_a positive 0", Arrhenius{.power = 1.0, .T_a = 0.0});
  refuse("a reaction that takes heat", "power not negative -1", Arrhenius{.power = -1.0});
  refuse("a softening temperature at the reference", "theta_star above theta_r = 300 300", soft(300.0, 300.0));
  refuse("a softening temperature below it", "theta_star above theta_r = 300 200", soft(300.0, 200.0));
  refuse("a softening temperature of nan", "theta_star nan", soft(300.0, nan));
  refuse("a reference of -1 K", "theta_r not negative -1", soft(-1.0, 300.0));
}

void refuse_starts(Rows& rows) {
  const auto refuse = [&](const std::string& name, const std::string& key_words, const auto& change) {
    rows.must_be_refused(name, key_words, [&] {
      kinematics::Particles pair = warmed(book_pair(0.2));
      change(pair);
      const scenes::Scene scene(pair, Space{}, thermo::Cooling{.h_c = 1.0});
      return scene.particles().size() == 2 ? accepted() : Ending::refused("");
    });
  };
  refuse("a start below 0 K", "temperature positive -5", [](auto& p) { p.temperature[1] = -5.0; });
  refuse("a start at 0 K", "temperature positive 0", [](auto& p) { p.temperature[1] = 0.0; });
  refuse("a start at nan K", "temperature nan", [](auto& p) { p.temperature[1] = not_a_number; });
  refuse("a heat capacity of 0", "heat capacities positive 0", [](auto& p) { p.heat_capacity[0] = 0.0; });
  refuse("a heat capacity of -1", "heat capacities positive -1", [](auto& p) { p.heat_capacity[0] = -1.0; });
  refuse("a heat capacity of nan", "heat capacities nan", [](auto& p) { p.heat_capacity[0] = not_a_number; });
  refuse("no temperatures", "temperature", [](auto& p) { p.temperature.resize(0), p.heat_capacity.resize(0); });
}

void refuse_runs(Rows& rows) {
  rows.must_be_refused("coincident particles under a near field", "particles 0 and 1 apart", [] {
    kinematics::Particles pair = warmed(book_pair(0.2));
    pair.position.setZero();
    const scenes::Scene scene(pair, Space{}, book_near_field, book_binding, book_contact(), thermo::ImpactHeat{});
    schemes::State state = scenes::start(scene);
    schemes::VelocityVerlet scheme;
    schemes::FixedStep control{.step = 1e-3};
    return ending_of(schemes::integrate(scene, state, 1.0, scheme, control));
  });
  rows.must_be_refused("a state below 0 K", "particle 1 temperature not negative -1", [] {
    const scenes::Scene scene(warmed(book_pair(0.2)), Space{}, thermo::Cooling{.h_c = 1.0});
    schemes::State state = scenes::start(scene);
    state.y[1] = -1.0;
    schemes::RungeKutta4 scheme;
    schemes::FixedStep control{.step = 1e-3};
    return ending_of(schemes::integrate(scene, state, 1.0, scheme, control));
  });
  rows.must_be_refused("temperatures missing in a state", "temperature a particle 2 0", [] {
    const scenes::Scene scene(warmed(book_pair(0.2)), Space{}, thermo::Cooling{.h_c = 1.0});
    schemes::State state = scenes::start(scene);
    state.y.resize(0);
    schemes::RungeKutta4 scheme;
    schemes::FixedStep control{.step = 1e-3};
    return ending_of(schemes::integrate(scene, state, 1.0, scheme, control));
  });
  const auto refuse = [&](const std::string& name, const std::string& key_words, const auto& call) {
    rows.must_be_refused(name, key_words, [&] {
      (void)call();
      return accepted();
    });
  };
  refuse("radiation beyond its surroundings", "between 250",
         [] { return thermo::radiation_time(1.0, 1e3, 250.0, 300.0); });
  refuse("a runaway that cools", "theta_0 <= theta", [] { return thermo::runaway_time(1.0, 1e4, 400.0, 300.0); });
  refuse("a link of nan m", "finite nan",
         [] { return thermo::find_clusters({}, book_pair(1.0).position, not_a_number); });
  refuse("windows of 0 s", "positive 0", [] { return contact::ImpulseWindows(0, 0.0); });
}

const Case refused{
    {.name = "thermo_extremes_refused",
     .claim = "heat, bonds, cut-offs, starts and states that cannot be meant are refused, with the reason",
     .equation = "R 7.4",
     .reference = Reference::design},
    [](Rows& rows) {
      refuse_laws(rows);
      refuse_starts(rows);
      refuse_runs(rows);
    }};

}  // namespace verification::thermo_extremes
