// Heated bodies that must be borne, however extreme, and those that must be refused.

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/scattering/beam.hpp>

#include "heated.hpp"

namespace verification::heat_extremes {

using namespace particulate;
using namespace particulate::scattering;
using Eigen::Vector2d, Eigen::Vector3d;

Ending within(double error, double tolerance, const char* because) {
  return Ending::solved({.error = error, .tolerance = tolerance, .because = because});
}

// n^ = 10: what a sphere reflects of a beam. One of 1 mm and 2e6 J/(m^3 K) cools by k (theta^4 - theta_s^4).
constexpr double F = 0.640174994374749, rho_c = 2e6, B = 5.670374419e-8, k = B * 3.0 / 2e3;
const thermo::Cooling radiation{.emissivity = 1.0};

Cloud<Sphere> lone(double b = 1e-3) {
  return Cloud<Sphere>({{.radius = b}},
                       {.lengths = Vector3d::Constant(4.0 * b), .corner = Vector3d::Constant(-2.0 * b)});
}

HeatedBodies lone_in_beam(double irradiance, double b = 1e-3, const thermo::Cooling& cooling = radiation) {
  HeatedBodies bodies = heated_bodies(lone(b), rho_c, cooling);
  bodies.power[0] = (1.0 - F) * irradiance * std::numbers::pi * b * b;
  return bodies;
}

schemes::State run(const HeatedBodies& bodies, const schemes::State& from, double t) {
  return heated(bodies, from, t, 1e-10);
}
double after(const HeatedBodies& bodies, double theta_0, double t) {
  return run(bodies, start(bodies, theta_0), t).y[0];
}

// The time that radiation takes from one temperature to another that is above its end, by quadrature [s].
double time_between(double theta_0, double theta, double theta_end) {
  const auto slowness = [=](double s) {
    const double x = theta_end + std::exp(s);
    return 1.0 / (k * (x + theta_end) * (x * x + theta_end * theta_end));
  };
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(slowness, std::log(theta - theta_end),
                                                                       std::log(theta_0 - theta_end), 8, 1e-13);
}

void solve_temperatures(Rows& rows) {
  const auto solve = [&](const std::string& name, double irradiance, double theta_0, double t, double expected,
                         const char* because) {
    rows.must_be_solved(name, [=] {
      return within(std::abs(after(lone_in_beam(irradiance), theta_0, t) / expected - 1.0), 1e-8, because);
    });
  };
  const char* end = "it has got there";
  solve("1e9 s in a beam of 1e4 W/m^2, from 1e5 K", 1e4, 1e5, 1e9, 393.451288231247, end);
  solve("1e9 s in a beam of 1e6 W/m^2, from 1e-6 K", 1e6, 1e-6, 1e9, 1123.71932603170, end);
  solve("1e-6 K in a beam of 1e4 W/m^2 for 2 s", 1e4, 1e-6, 2.0,
        1e-6 + 2.0 * (k * 8.1e9 + 0.75 * (1.0 - F) * 1e4 / 2e3), "its own radiation is nothing");
  rows.must_be_solved("1e5 K in a beam of 1e6 W/m^2 for 2 s", [] {
    const double t = time_between(1e5, after(lone_in_beam(1e6), 1e5, 2.0), 1123.71932603170);
    return within(std::abs(t / 2.0 - 1.0), 1e-7, "1e-10 of a step, in a hundred steps");
  });
  // All time scales are proportional to the radius.
  for (const double b : {1e-6, 1e-9}) {
    rows.must_be_solved(fmt::format("a sphere of {} m in a beam of 1e6 W/m^2, 300 K to 1000 K", b), [b] {
      return within(std::abs(after(lone_in_beam(1e6, b), 300.0, 6.68720530188183e3 * b) / 1000.0 - 1.0), 1e-8,
                    "1e-10 of a step, in a hundred steps");
    });
  }
}

void solve_darkness(Rows& rows) {
  rows.must_be_solved("1e9 s without light at the temperature of the surroundings", [] {
    return within(std::abs(after(lone_in_beam(0.0), 300.0, 1e9) - 300.0), 0.0, "nothing flows");
  });
  rows.must_be_solved("a sphere in the dark beside one in a beam of 1e6 W/m^2", [] {
    const Cloud<Sphere> two({{{-1.5e-3, 0.0, 0.0}, 1e-3}, {{1.5e-3, 0.0, 0.0}, 1e-3}},
                            {.lengths = Vector3d::Constant(6e-3), .corner = Vector3d::Constant(-3e-3)});
    HeatedBodies bodies = heated_bodies(two, rho_c, radiation);
    bodies.power[0] = lone_in_beam(1e6).power[0];
    const Eigen::VectorXd theta = run(bodies, start(bodies, 1000.0), 29.319567692972).y;
    return within(std::abs(theta[1] / 500.0 - 1.0) + (theta[0] > 1000.0 ? 0.0 : 1.0), 1e-8,
                  "the one cools as if the other were not there");
  });
  rows.must_be_solved("no body", [] {
    const Cloud<Sphere> none({}, {});
    const HeatedBodies bodies = heated_bodies(none, rho_c, radiation);
    const Eigen::VectorXd theta = run(bodies, start(bodies, 300.0), 1.0).y;
    return within(static_cast<double>(theta.size() + equilibrium_temperatures(bodies).size()), 0.0,
                  "nothing comes of nothing");
  });
}

// A pulse through a disc that the sphere fills, in regular rays.
Eigen::VectorXd absorbed_of(double fluence, const auto& law) {
  const Beam beam{.shape = Beam::Shape::disc,
                  .centre = {-2e-3, 0.0, 0.0},
                  .width = 2e-3,
                  .irradiance = fluence,
                  .points = Beam::Points::regular};
  return trace(lone(), law, rays_of(beam, 400, {})).absorbed;
}

void solve_pulses(Rows& rows) {
  const HeatedBodies bodies = lone_in_beam(0.0);
  const schemes::State cold = start(bodies, 300.0);
  rows.must_be_solved("a pulse of no energy", [=] {
    return within((warmed_by(bodies, cold.y, Eigen::VectorXd::Zero(1)) - cold.y).norm(), 0.0, "no bit changes");
  });
  rows.must_be_solved("a pulse on a sphere that reflects all of it", [=] {
    return within(absorbed_of(1e12, FluidFluid{.Z_hat = 1e300}).norm(), 0.0, "R = 1 to the last bit");
  });
  rows.must_be_solved("a ray beyond the critical angle", [=] {
    // At 60 degrees, of which the sine is above n^ = 1/2.
    const Rays ray{.place = Vector3d(-2e-3, std::sqrt(0.75) * 1e-3, 0.0).transpose(),
                   .direction = Vector3d::UnitX().transpose(),
                   .power = Eigen::VectorXd::Constant(1, 1e12)};
    const Traced traced = trace(lone(), Fresnel{0.5}, ray);
    return within(traced.absorbed.norm() + (traced.ledger.hits == 1 ? 0.0 : 1.0), 0.0, "R = 1 to the last bit");
  });
  for (const double t : {1e-15, 1.0, 100.0}) {
    rows.must_be_solved(fmt::format("{} s after a pulse of 1e12 J/m^2", t), [=] {
      schemes::State hot = cold;
      hot.y = warmed_by(bodies, cold.y, absorbed_of(1e12, Fresnel{10.0}));
      const double rise = 0.75 * (1.0 - F) * 1e12 / 2e3, off = hot.y[0] / rise - 1.0;
      const double took = time_between(hot.y[0], run(bodies, hot, t).y[0], 300.0);
      return within(std::abs(took / t - 1.0) + (std::abs(off) < 0.01 ? 0.0 : 1.0), 1e-7,
                    "a thousand times the tolerance of a step, from 1.35e8 K on, which 400 rays tell to a hundredth");
    });
  }
}

const Case solved{{.name = "heat_extremes_solved",
                   .claim = "bodies in the dark, near 0 K and from 1e8 K, for 1e9 s, micrometres and nanometres small, "
                            "and those that absorb nothing are solved",
                   .equation = "R 9.5",
                   .reference = Reference::closed_form},
                  [](Rows& rows) {
                    solve_temperatures(rows);
                    solve_darkness(rows);
                    solve_pulses(rows);
                  }};

// A call that must not come to its end.
void refuse(Rows& rows, const std::string& name, const std::string& key_words, const std::function<void()>& call) {
  rows.must_be_refused(name, key_words, [&] {
    call();
    return accepted();
  });
}

void refuse_bodies(Rows& rows) {
  const auto cooled = [](const thermo::Cooling& cooling) {
    return [=] { (void)heated_bodies(lone(), rho_c, cooling); };
  };
  refuse(rows, "an emissivity of 1.01", "emissivity between 0 and 1 1.01", cooled({.emissivity = 1.01}));
  refuse(rows, "an emissivity of -0.1", "emissivity between 0 and 1 -0.1", cooled({.emissivity = -0.1}));
  refuse(rows, "an emissivity of nan", "emissivity nan", cooled({.emissivity = not_a_number}));
  refuse(rows, "surroundings of -1 K", "theta_s not negative -1", cooled({.theta_s = -1.0}));
  for (const double bad : {0.0, -1.0, not_a_number, infinite}) {
    refuse(rows, fmt::format("rho c = {}", bad), "heat capacities positive finite body 0",
           [=] { (void)heated_bodies(lone(), bad); });
  }
  for (const double bad : {0.0, -5.0, not_a_number, infinite}) {
    refuse(rows, fmt::format("a start at {} K", bad), fmt::format("start positive finite {} K", bad),
           [=] { (void)start(lone_in_beam(0.0), bad); });
  }
  for (const double bad : {-1.0, not_a_number, infinite}) {
    refuse(rows, fmt::format("a power of {} W", bad), "powers negative finite body 0", [=] {
      HeatedBodies bodies = lone_in_beam(0.0);
      bodies.power[0] = bad;
      (void)start(bodies, 300.0);
    });
  }
  refuse(rows, "powers of other bodies", "capacity surface power 1, 1 and 2", [] {
    HeatedBodies bodies = lone_in_beam(0.0);
    bodies.power = Vector2d::Zero();
    validate(bodies);
  });
}

void refuse_light(Rows& rows) {
  refuse(rows, "a beam of 0 W/m^2", "irradiance positive 0", [] { (void)absorbed_of(0.0, Fresnel{10.0}); });
  refuse(rows, "a pulse of nan J/m^2", "irradiance finite nan", [] { (void)absorbed_of(not_a_number, Fresnel{10.0}); });
  refuse(rows, "an end without losses", "h_c emissivity",
         [] { (void)equilibrium_temperatures(lone_in_beam(1e6, 1e-3, {})); });
  const auto warm = [](const Eigen::VectorXd& theta, const Eigen::VectorXd& energy) {
    return [=] { (void)warmed_by(lone_in_beam(0.0), theta, energy); };
  };
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  refuse(rows, "energies of other bodies", "each of 1 temperature energy 1 and 2", warm(one, Vector2d::Zero()));
  refuse(rows, "an energy of nan J", "energies finite body 0", warm(one, not_a_number * one));
  refuse(rows, "an energy of -1 J", "energies negative body 0", warm(one, -one));
  refuse(rows, "a temperature of inf K", "temperatures finite body 0", warm(infinite * one, one));
  rows.must_be_refused("a state below 0 K", "value", [] {
    const HeatedBodies bodies = lone_in_beam(1e6);
    schemes::State below = start(bodies, 300.0);
    below.y[0] = -1.0;
    schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>> scheme;
    schemes::ErrorControl control{.TOL = 1e-6};
    return ending_of(schemes::integrate(bodies, below, 1.0, scheme, control));
  });
}

const Case refused{{.name = "heat_extremes_refused",
                    .claim = "heat capacities, temperatures, powers, emissivities and light that cannot be meant are "
                             "refused, with the reason",
                    .equation = "R 9.5",
                    .reference = Reference::design},
                   [](Rows& rows) {
                     refuse_bodies(rows);
                     refuse_light(rows);
                   }};

}  // namespace verification::heat_extremes
