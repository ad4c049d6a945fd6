// Error against run time of heat: cooling from 1e4 K, a runaway, and a bound cluster that cools.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <harness/races.hpp>
#include <harness/stiff_races.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/thermo/arrhenius.hpp>
#include <particulate/thermo/cooling.hpp>

#include "spheres.hpp"

namespace verification::work_precision_thermo {

using namespace particulate;

// A sphere of 1 mm, 2000 kg/m^3 and 1000 J/(kg K): m c/a_s = 2000/3 J/(m^2 K).
constexpr double per_area = 2000.0 / 3.0;

// The temperature of that sphere as a field of a scene. Nobody is given its Jacobian, so that who wants it pays a
// right-hand side for it.
template <class... Laws>
struct OneTemperature {
  scenes::Scene<kinematics::Space, Laws...> scene;
  schemes::State at = scenes::start(scene);

  bool rate(double t, schemes::In y, schemes::Out dy) const { return scene.temperature_rates(t, at.r, at.v, y, dy); }
  schemes::Bandwidth bandwidth() const { return {}; }
};
template <class... Laws>
OneTemperature<Laws...> one_temperature(double theta_0, const Laws&... laws) {
  const double mass = per_area * thermo::surface(1e-3) / 1000.0;
  const kinematics::Particles sphere =
      warmed(kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = mass, .radius = 1e-3}}), theta_0, 1000.0);
  return {scenes::Scene<kinematics::Space, Laws...>(sphere, {}, laws...)};
}

// In two parts: radiation is fast, convection slow.
struct InParts : OneTemperature<thermo::Cooling, thermo::Cooling> {
  OneTemperature<thermo::Cooling> slow, fast;

  bool rate_slow(double t, schemes::In y, schemes::Out dy) const { return slow.rate(t, y, dy); }
  bool rate_fast(double t, schemes::In y, schemes::Out dy) const { return fast.rate(t, y, dy); }
};

// Temperatures from the times at which they are reached, by Newton's method on a quadrature or closed form.
std::function<schemes::State(double)> inverted(std::function<double(double)> time_to,
                                               std::function<double(double)> rate, double theta_0) {
  return [=](double t) {
    double theta = theta_0;
    for (int k = 0; k < 200; ++k) theta += std::clamp((t - time_to(theta)) * rate(theta), -0.3 * theta, 0.1 * theta);
    return schemes::State{.t = t, .y = Eigen::VectorXd::Constant(1, theta)};
  };
}

const Case cooling{
    {.name = "work_precision_cooling",
     .claim = "error against run time of a sphere that cools from 1e4 K: RK4 has order 4 at least, Radau collocation "
              "takes no more evaluations to 1e-8 than CVODE BDF",
     .equation = "R 7.4.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      constexpr double theta_0 = 1e4;
      const thermo::Cooling convection{.h_c = 50.0}, radiation{.emissivity = 0.8};
      const InParts problem{{one_temperature(theta_0, convection, radiation)},
                            one_temperature(theta_0, convection),
                            one_temperature(theta_0, radiation)};
      const auto rate = [](double theta) {
        const double B = 5.670374419e-8;
        return -(50.0 * (theta - 300.0) + 0.8 * B * (std::pow(theta, 4) - 8.1e9)) / per_area;
      };
      const auto time_to = [=](double theta) {
        const auto slowness = [&](double x) { return std::exp(x) / rate(std::exp(x)); };
        return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(slowness, std::log(theta_0),
                                                                             std::log(theta), 3, 1e-15);
      };
      const Race race{.problem = problem,
                      .start = {.t = 0.0, .y = Eigen::VectorXd::Constant(1, theta_0)},
                      .outputs = {0.01, 0.1, 1.0},
                      .truth = inverted(time_to, rate, theta_0)};
      std::vector<Competitor> all = stiff_ones(race, rows.quick());
      all.push_back(with_slope(
          4.0, competitor("RK4", race, step_sizes(0.01, {10, 1.3, 5}), at_fixed_step<schemes::RungeKutta4>()),
          "1e4 K fall in a few steps, whose errors are of higher orders too"));
      all.push_back(
          competitor("ARKODE IMEX", race, tolerances(rows.quick() ? 1e-8 : 1e-12), by(reference::ImplicitExplicit{})));
      all.push_back(
          competitor("backward Euler, fixed point", race, step_sizes(0.01, {1, 2.0, rows.quick() ? 5 : 8}),
                     sweeping_at_fixed_step(schemes::BackwardEuler(), {.order = 1, .share = 1e-3, .T = 1.0})));
      rows.work_precision({.problem = "cooling",
                           .reference = "quadrature of the time over the temperature, inverted",
                           .floor = 1e-14,
                           .competitors = std::move(all)});
      compare_at_1e_8(rows, "cooling");
    }};

const Case radiation{
    {.name = "work_precision_radiation",
     .claim = "Radau collocation takes no more evaluations to 1e-8 than CVODE BDF where a sphere radiates "
              "from 1e4 K",
     .equation = "R 7.4.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double k = thermo::stefan_boltzmann / per_area;
      const Race race{.problem = one_temperature(1e4, thermo::Cooling{.emissivity = 1.0, .theta_s = 0.0}),
                      .start = {.t = 0.0, .y = Eigen::VectorXd::Constant(1, 1e4)},
                      .outputs = {0.01, 0.1, 1.0},
                      .truth = [](double t) {
                        return schemes::State{
                            .t = t, .y = Eigen::VectorXd::Constant(1, std::cbrt(1.0 / (1e-12 + 3.0 * k * t)))};
                      }};
      rows.work_precision({.problem = "radiation",
                           .reference = "closed form",
                           .floor = rounding_floor,
                           .competitors = stiff_ones(race, rows.quick()),
                           .timed = rows.full(),
                           .no_ruler = "that of cooling serves"});
      compare_at_1e_8(rows, "radiation");
    }};

// To 350 K, half a minute before the end of all. To 398 K, a second before it, three stages take an eighth more than
// BDF, and five a third of it.
const Case runaway{
    {.name = "work_precision_runaway",
     .claim = "error against run time of a reaction that runs away: RK4 has order 4, Radau collocation takes "
              "no more evaluations to 1e-8 than CVODE BDF",
     .equation = "R 7.4.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto time_to = [](double theta) { return thermo::runaway_time(1e12, 1e4, 300.0, std::max(theta, 300.0)); };
      const auto rate = [](double theta) { return 1e12 * std::exp(-1e4 / theta); };
      const double t_end = std::floor(time_to(350.0));
      Race race{.problem = one_temperature(300.0, thermo::Arrhenius{.power = 1e15, .T_a = 1e4}),
                .start = {.t = 0.0, .y = Eigen::VectorXd::Constant(1, 300.0)},
                .outputs = {t_end},
                .truth = inverted(time_to, rate, 300.0)};
      std::vector<Competitor> all = stiff_ones(race, rows.quick());
      all.push_back(with_slope(
          4.0, competitor("RK4", race, step_sizes(t_end, {1000, 1.3, 4}), at_fixed_step<schemes::RungeKutta4>())));
      all.push_back(
          competitor("backward Euler, fixed point", race, step_sizes(t_end, {500, 2.0, rows.quick() ? 5 : 8}),
                     sweeping_at_fixed_step(schemes::BackwardEuler(), {.order = 1, .share = 1e-5, .T = 1.0})));
      rows.work_precision(
          {.problem = "runaway", .reference = "closed form, inverted", .floor = 1e-14, .competitors = std::move(all)});
      compare_at_1e_8(rows, "runaway");
    }};

// Motion and temperatures solved in turn, each by one sweep of backward Euler: the monograph's staggered fixed point.
struct InTurn {
  schemes::Problem whole;
  schemes::Rates rates = {};

  std::size_t fields() const { return 2; }
  schemes::Part part(std::size_t k) const {
    return k == 0 ? schemes::Part{.motion = true} : schemes::Part{.first = 0, .size = 13};
  }
  bool solve(std::size_t k, const schemes::State& from, double dt, const schemes::State& seen, schemes::State& to) {
    if (!whole.rates(seen, rates)) return false;
    if (k == 0) {
      to.v = from.v + dt * rates.a;
      to.r = from.r + dt * to.v;
    } else {
      to.y = from.y + dt * rates.dy;
    }
    return true;
  }
};
Begin in_turn() {
  return [](const schemes::Problem& problem, const schemes::State&, double step) -> Advance {
    return [problem, step](schemes::State& state, double t_end) {
      InTurn fields{.whole = problem};
      const schemes::Staggered scheme({{.name = "motion", .TOL = 1e-4}, {.name = "temperatures", .TOL = 1e-4}});
      schemes::Staggered own = scheme;
      schemes::FixedStep control{.step = step, .TOL = 1.0};
      return schemes::integrate(fields, state, t_end, own, control);
    };
  };
}

// A sphere and twelve about it at the corners of an icosahedron, all within reach of their bonds, that tremble.
kinematics::Particles cluster_of_13() {
  Uniform uniform(1);
  const double golden = 0.5 * (1.0 + std::sqrt(5.0)), edge = 0.057 / std::sqrt(1.0 + golden * golden);
  kinematics::Vectors places = kinematics::Vectors::Zero(13, 3);
  for (int k = 0; k < 12; ++k) {
    const int axis = k / 4;
    places(k, axis) = k & 1 ? 1.0 : -1.0;
    places(k, (axis + 1) % 3) = k & 2 ? golden : -golden;
  }
  return warmed({.position = edge * places,
                 .velocity = 0.1 * (2.0 * random_places(uniform, 13).array() - 1.0),
                 .mass = Eigen::VectorXd::Constant(13, book_mass),
                 .radius = Eigen::VectorXd::Constant(13, book_radius)},
                1000.0, 10.0);
}

const Case cluster{
    {.name = "work_precision_bound_cluster",
     .claim = "error against run time of a bound cluster of thirteen spheres that cools: RK4 has order 4",
     .equation = "R 7.5.1",
     .reference = Reference::sundials},
    [](Rows& rows) {
      laws::NearField near = book_near_field;
      near.cutoff = 1.0, near.taper = 0.25;
      const scenes::Scene scene(cluster_of_13(), kinematics::Space{}, near, book_binding,
                                thermo::Cooling{.h_c = 50.0, .emissivity = 1.0});
      const double t_end = 0.13;
      Race race{.problem = scene,
                .start = scenes::start(scene),
                .outputs = {0.5 * t_end, t_end},
                .truth = {},
                .length = 0.05,
                .speed = 0.1};
      const reference::ExplicitRungeKutta fehlberg{
          .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14};
      race.truth = [handed = handed_by(race, fehlberg)](double t) {
        return t < handed.back().t ? handed[0] : handed[1];
      };
      const double floor = errors_of(race, handed_by(race, reference::Adams{.relative = 1e-14, .absolute = 1e-14})).max;
      const double leg = race.outputs.front();
      const Begin radau = under(schemes::Collocation<schemes::Radau<3>, schemes::Newton<>>(), [=](double TOL) {
        return schemes::ErrorControl{.TOL = TOL, .sweep_TOL = 0.1 * TOL, .limit = t_end};
      });
      rows.work_precision(
          {.problem = "bound_cluster",
           .reference = "ARKODE Fehlberg 8(7) at 1e-14, checked by CVODE Adams",
           .floor = std::max(floor, rounding_floor),
           .competitors = {
               with_slope(
                   4.0, competitor("RK4", race, step_sizes(leg, {20, 1.5, 5}), at_fixed_step<schemes::RungeKutta4>())),
               competitor("CVODE BDF", race, tolerances(rows.quick() ? 1e-7 : 1e-11), by(reference::Bdf{})),
               competitor("CVODE Adams", race, tolerances(rows.quick() ? 1e-8 : 1e-12), by(reference::Adams{})),
               competitor("Radau 5", race, tolerances(rows.quick() ? 1e-5 : 1e-9, 1e-2), radau),
               competitor("staggered fixed point", race, step_sizes(leg, {4, 2.0, rows.quick() ? 6 : 9}), in_turn())}});
    }};

}  // namespace verification::work_precision_thermo
