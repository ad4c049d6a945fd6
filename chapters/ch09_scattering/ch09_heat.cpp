//! @page ch09_heat Chapter 9: Light that heats
//! @brief Scatterers are as warm as the light that they absorb makes them: by a pulse, and in a steady beam.
//! @tableofcontents
//!
//! @section ch09_heat_question Where the rest of the power goes
//!
//! What a ray loses where it is reflected, the scatterer gains (9.5). How warm do scatterers become, and when?
//!
//! @figure{ch09_hot, A pulse at four lengths of path. Spheres that lie below the middle are coloured from 300 K to the hottest of all at the end; a line shows where a ray goes\, as long as its irradiance. Figure 9.14.}
//!
//! @figure{ch09_hot_mean, The same\, coloured from 300 K to the mean temperature at the end: every warmer sphere looks alike. Figure 9.15.}
//!
//! The same temperatures, twice. Absorption is so uneven that the first picture has hardly any warm sphere, and the
//! second nearly none between cold and hot.
//!
//! @section ch09_heat_model The balance of one scatterer
//!
//! @figure{ch09_balance, What a sphere gets and gives: Figure 9.11.}
//!
//! \f[ m\,c\,\dot\theta = P - a_s \left[h_c\,(\theta - \theta_o) + B\,\varepsilon\,(\theta^4 - \theta_s^4)\right],
//!     \qquad a_s = 4\pi b^2, \f]
//!
//! with \f$ P = \sum (1 - R)\, I_r \f$ over the rays that hit it (particulate::scattering::HeatedBodies). Each sphere
//! has one temperature. None lights or shades another but by the rays: what it radiates is lost to surroundings of
//! \f$ \theta_s \f$. Here \f$ \varepsilon = 1 \f$, nothing flows around the spheres, \f$ h_c = 0 \f$, and all begin
//! with \f$ \theta_0 = \theta_s = 300 \f$ K.
//!
//! @figure{ch09_length_scale, A scatterer is measured by the edge of the cube that is its own: Figure 9.12.}
//!
//! Rays know no lengths: the cloud of the other pages may be of any size. Heat does. A sphere of radius b is warmed in
//! proportion to its shadow, and holds heat in proportion to its volume; a pulse of fluence H warms a lone sphere by
//! \f$ 3\,(1 - F)\,H/(4\,\varrho\,c\,b) \f$. The edge of the cube is now one millimetre.
//!
//! @section ch09_heat_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <particulate/scattering/heat.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/integrate.hpp>

#include "ch09_scattering.hpp"

namespace ch09 {
namespace {

constexpr double theta_0 = 300.0;  // of all spheres, and of what they radiate to [K]
const thermo::Cooling radiation{.emissivity = 1.0, .theta_s = theta_0};
constexpr Eigen::Index many_rays = 65536;

//! A pulse through one cloud. Every hit is a jump of temperature at its time of flight
//! (particulate::scattering::heat_jumps).

struct Pulse {
  Cloud<Sphere> cloud;
  HeatedBodies bodies;
  Rays rays;
  Traced traced = {};
  std::vector<Path> paths = {};
  std::vector<HeatJump> jumps = {};
};

Pulse pulse(const Parameters& p, int k) {
  const std::function<double()> uniform = uniform_from(seed_of(p, k));
  const Cloud<Sphere> cloud = small_spheres(p.L, uniform);
  Pulse one{cloud, heated_bodies(cloud, p.rho_c, radiation), rays_of(small_beam(p.fluence), p.rays, uniform)};
  one.traced = trace(cloud, Fresnel{p.n_hat}, one.rays, {.keeps_paths = true, .threads = p.line.common().threads});
  one.paths = split(one.traced.paths, p.rays);
  one.jumps = heat_jumps(one.traced.paths);
  return one;
}

// Calls visit(k, theta) with the temperatures when light has gone the k-th of these ways, which grow.
template <class Visit>
Eigen::VectorXd warm(const Pulse& pulse, const std::vector<double>& ways, const Visit& visit) {
  Eigen::VectorXd theta = start(pulse.bodies, theta_0).y;
  auto jump = pulse.jumps.begin();
  for (std::size_t k = 0; k < ways.size(); ++k) {
    for (; jump != pulse.jumps.end() && jump->t <= ways[k] / speed_of_light; ++jump) {
      theta[jump->body] += jump->energy / pulse.bodies.capacity[jump->body];
    }
    visit(k, theta);
  }
  return theta;
}

//! For the pictures four moments will do.

void write_pictures(const Pulse& pulse, const report::Output& output) {
  const std::vector<double> ways{0.15 * edge, 0.4 * edge, 0.8 * edge, 1.4 * edge};
  report::Table rays({"picture", "c t/D", "x/D", "y/D", "z/D", "v_x/c", "v_y/c", "I/I(0)"});
  report::Table spheres({"picture", "x/D", "y/D", "z/D", "radius/D", "temperature [K]"});
  warm(pulse, ways, [&](std::size_t k, const Eigen::VectorXd& theta) {
    for (std::size_t i = 0; i < std::min<std::size_t>(pulse.paths.size(), 300); ++i) {
      const Moment now = moment_of(pulse.paths[i], pulse.traced.rays, ways[k]);
      const Eigen::Vector3d place = now.place / edge;
      rays.add({k + 1, ways[k] / edge, place[0], place[1], place[2], now.velocity[0], now.velocity[1],
                now.power / pulse.paths[i].front().power});
    }
    for (Eigen::Index i = 0; i < theta.size(); ++i) {
      const Sphere& body = pulse.cloud.bodies()[static_cast<std::size_t>(i)];
      const Eigen::Vector3d centre = body.centre / edge;
      spheres.add({k + 1, centre[0], centre[1], centre[2], body.radius / edge, theta[i]});
    }
  });
  output.write("pulse_rays", rays);
  output.write("pulse_spheres", spheres);
}

//! @section ch09_heat_histories Histories
//!
//! The monograph's figures 9.16 to 9.18 are means over all rays, and over all scatterers, against time. Here they are
//! means over clouds as well. After they have left, rays go straight on. The radiation is the net one, what spheres
//! give less what they get from surroundings of \f$ \theta_s \f$: that alone cools them, and it begins at zero.

const std::array<std::string, 14> followed{"x/D",
                                           "y/D",
                                           "z/D",
                                           "v_x/c",
                                           "v_y/c",
                                           "v_z/c",
                                           "||v||/c",
                                           "I_x/I(0)",
                                           "I_y/I(0)",
                                           "I_z/I(0)",
                                           "||I||/I(0)",
                                           "mean temperature [K]",
                                           "hottest scatterer [K]",
                                           "net radiation [W/m^2]"};
using Followed = Eigen::Array<double, 1, 14>;

double net_radiation(const Eigen::VectorXd& theta) {
  double sum = 0.0;
  for (const double one : theta) sum -= thermo::heat_flux(radiation, one);
  return sum / static_cast<double>(theta.size());
}

// A row a way.
std::vector<Followed> history(const Pulse& pulse, const std::vector<double>& ways) {
  std::vector<Followed> rows;
  warm(pulse, ways, [&](std::size_t k, const Eigen::VectorXd& theta) {
    Followed sums = Followed::Zero();
    for (const Path& path : pulse.paths) {
      const Moment now = moment_of(path, pulse.traced.rays, ways[k]);
      const double share = now.power / path.front().power;
      Followed one = Followed::Zero();
      one.head<11>() << now.place.transpose() / edge, now.velocity.transpose(), now.velocity.norm(),
          share * now.velocity.transpose(), share * now.velocity.norm();
      sums += one;
    }
    rows.push_back(sums / static_cast<double>(pulse.paths.size()));
    rows.back().tail<3>() << theta.mean(), theta.maxCoeff(), net_radiation(theta);
  });
  return rows;
}

struct Ensemble {
  std::vector<std::vector<Followed>> histories = {};
  double longest = 0.0;                                       // path until its ray has left [m]
  double energy_off = 0.0, jumps_off = 0.0, speed_off = 0.0;  // the worst
};

void add(const Pulse& one, const std::vector<double>& ways, Ensemble& to) {
  to.histories.push_back(history(one, ways));
  for (const Followed& row : to.histories.back()) to.speed_off = std::max(to.speed_off, std::abs(row[6] - 1.0));
  for (const Path& path : one.paths) to.longest = std::max(to.longest, path.back().length);
  const Eigen::VectorXd cold = start(one.bodies, theta_0).y, theta = warm(one, {nowhere}, [](auto&&...) {});
  const double lost = one.rays.power.sum() - one.traced.rays.power.sum();
  to.energy_off = std::max(to.energy_off, std::abs(one.bodies.capacity.dot(theta - cold) / lost - 1.0));
  const Eigen::ArrayXd at_once = warmed_by(one.bodies, cold, one.traced.absorbed);
  to.jumps_off = std::max(to.jumps_off, (theta.array() / at_once - 1.0).abs().maxCoeff());
}

void write_histories(const Ensemble& all, const std::vector<double>& ways, const report::Output& output) {
  const auto mean = [&](std::size_t k, std::size_t q) {
    std::vector<double> numbers;
    for (const std::vector<Followed>& one : all.histories) numbers.push_back(one[k][static_cast<Eigen::Index>(q)]);
    return report::mean_of(numbers);
  };
  std::vector<std::string> columns{"c t/D"};
  columns.insert(columns.end(), followed.begin(), followed.end());
  report::Table table(columns);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    std::vector<report::Cell> row{ways[k] / edge};
    for (std::size_t q = 0; q < followed.size(); ++q) row.emplace_back(mean(k, q).value);
    table.add(row);
  }
  output.write("history", table);
  report::Table numbers({"mean of", "at c t = D/4", "D/2", "D", "3 D", "standard error then"});
  for (std::size_t q = 0; q < followed.size(); ++q) {
    const report::Mean end = mean(60, q);
    numbers.add({followed[q], mean(5, q).value, mean(10, q).value, mean(20, q).value, end.value, end.standard_error});
  }
  output.write("histories", numbers);
}

//! @section ch09_heat_sampling How hot is the hottest?
//!
//! The hottest of a thousand spheres is an extreme, and extremes of samples are biased: with few rays one sphere or
//! another gets far more than its share by chance. Mean temperatures do not mind. We send more rays through the same
//! clouds.

void write_sampling(const Parameters& p, const report::Output& output) {
  report::Table table(
      {"rays", "mean rise [K]", "standard error [K]", "rise of the hottest over that", "standard error"});
  for (Eigen::Index rays = 1024; rays <= many_rays; rays *= 4) {
    std::vector<double> mean, hottest;
    for (int k = 0; k < realizations_of(p); ++k) {
      const std::function<double()> uniform = uniform_from(seed_of(p, k));
      const Cloud<Sphere> cloud = small_spheres(p.L, uniform);
      const Traced traced = trace(cloud, Fresnel{p.n_hat}, rays_of(small_beam(p.fluence), rays, uniform),
                                  {.threads = p.line.common().threads});
      const Eigen::ArrayXd rise = traced.absorbed.cwiseQuotient(heated_bodies(cloud, p.rho_c).capacity);
      mean.push_back(rise.mean());
      hottest.push_back(rise.maxCoeff() / rise.mean());
    }
    const report::Mean of_mean = report::mean_of(mean), of_hottest = report::mean_of(hottest);
    table.add({rays, of_mean.value, of_mean.standard_error, of_hottest.value, of_hottest.standard_error});
  }
  output.write("sampling", table);
}

//! @section ch09_heat_staggering Why nothing is staggered
//!
//! Section 9.6 solves rays and temperatures in turn within each time step, until they agree, with step control after
//! chapter 3. That is needed where heat acts back on light. Here \f$ \hat n \f$ is a constant, so that rays find
//! the same spheres however warm they are: the first sweep is right, and the second finds nothing to change. We do it
//! all the same:

Fresnel law_at(const Parameters& p, const Eigen::VectorXd& /*theta*/) { return {p.n_hat}; }

int sweeps(const Parameters& p, const Pulse& pulse) {
  const Eigen::VectorXd cold = start(pulse.bodies, theta_0).y;
  Eigen::VectorXd theta = cold, before;
  int sweep = 0;
  do {
    before = theta;
    const Traced traced = trace(pulse.cloud, law_at(p, theta), pulse.rays, {.threads = 1 + sweep % 2});
    theta = warmed_by(pulse.bodies, cold, traced.absorbed);
  } while (++sweep < 20 && theta != before);
  return sweep;
}

//! Nor is there a time step that rays and cooling could share. Light is through with the cloud long before any sphere
//! has noticed that it radiates more:

// In which a sphere loses its rise of temperature, at the rate at first.
double cooling_time(const HeatedBodies& bodies, double theta) {
  return bodies.capacity[0] * (theta - theta_0) / (-bodies.surface[0] * thermo::heat_flux(radiation, theta));
}

void write_times(const Ensemble& all, const HeatedBodies& bodies, const report::Output& output) {
  double mean = 0.0, hottest = 0.0;
  for (const std::vector<Followed>& one : all.histories) mean += one.back()[11], hottest += one.back()[12];
  const auto n = static_cast<double>(all.histories.size());
  report::Table table({"what takes the time", "time [s]"});
  table.add({"light, to cross the cube", edge / speed_of_light});
  table.add({"the last ray of all clouds, to leave", all.longest / speed_of_light});
  table.add({"the hottest sphere, to lose its rise", cooling_time(bodies, hottest / n)});
  table.add({"a sphere of mean temperature, to lose its rise", cooling_time(bodies, mean / n)});
  output.write("times", table);
}

//! So a pulse is a fluence: all that counts of it is the energy that each sphere has absorbed. It would be otherwise if
//! the index, the size or the place of a sphere depended on temperature, and the light came as slowly as that changes.
//!
//! @section ch09_heat_seconds Seconds
//!
//! On the scale of seconds rays are no longer seen. After the pulse spheres cool; or a beam that stays on gives each
//! sphere its watts, and temperatures go where it radiates as much. Rates fall by orders of magnitude on the way:
//! Radau's nodes with Newton iteration, as for @ref ch07_heat "Stage II of chapter 7".

std::vector<Eigen::VectorXd> integrated(const HeatedBodies& bodies, const Eigen::VectorXd& theta,
                                        const std::vector<double>& times) {
  schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>> scheme;
  schemes::ErrorControl control{.TOL = 1e-8, .sweep_TOL = 1e-10};
  schemes::State state{.y = theta};
  std::vector<Eigen::VectorXd> at_times;
  for (const double t : times) {
    const schemes::Outcome outcome = integrate(bodies, state, t, scheme, control);
    if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
    at_times.push_back(state.y);
  }
  return at_times;
}

// The same bodies, with the power that they absorb of a steady beam.
HeatedBodies lit(const Parameters& p, const Pulse& pulse) {
  Beam steady = small_beam(p.irradiance);
  steady.points = Beam::Points::stratified;
  const Rays rays = rays_of(steady, many_rays, uniform_from(seed_of(p, 0)));
  HeatedBodies bodies = pulse.bodies;
  bodies.power = trace(pulse.cloud, Fresnel{p.n_hat}, rays, {.threads = p.line.common().threads}).absorbed;
  return bodies;
}

void write_depth(const Parameters& p, const Cloud<Sphere>& cloud, const Eigen::VectorXd& theta,
                 const report::Output& output) {
  const double absorbed = (1.0 - sphere_reflectance(Fresnel{p.n_hat})) * p.irradiance / 4.0;
  const double lone = std::pow(std::pow(theta_0, 4) + absorbed / thermo::stefan_boltzmann, 0.25);
  report::Table table({"x/D", "from the middle of the beam, of y or z the larger, over D", "temperature [K]",
                       "that of a lone sphere [K]"});
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    const Eigen::Vector3d centre = cloud.bodies()[static_cast<std::size_t>(i)].centre / edge;
    table.add({centre[0], (centre.tail<2>().array() - 0.5).abs().maxCoeff(), theta[i], lone});
  }
  output.write("depth", table);
}

double write_seconds(const Parameters& p, const Pulse& pulse, const report::Output& output) {
  std::vector<double> times;
  for (int k = 0; k <= 60; ++k) times.push_back(std::pow(10.0, 0.1 * k - 3.0));
  const HeatedBodies steady = lit(p, pulse);
  const auto cooling = integrated(pulse.bodies, warm(pulse, {nowhere}, [](auto&&...) {}), times);
  const auto heating = integrated(steady, start(steady, theta_0).y, times);
  report::Table table(
      {"t [s]", "mean after the pulse [K]", "hottest [K]", "mean in the steady beam [K]", "hottest there [K]"});
  for (std::size_t k = 0; k < times.size(); ++k) {
    table.add({times[k], cooling[k].mean(), cooling[k].maxCoeff(), heating[k].mean(), heating[k].maxCoeff()});
  }
  output.write("seconds", table);
  const Eigen::VectorXd end = equilibrium_temperatures(steady);
  write_depth(p, pulse.cloud, end, output);
  return (heating.back().array() / end.array() - 1.0).abs().maxCoeff();
}

}  // namespace

void heat(const Parameters& p, report::Chapter& chapter) {
  std::vector<double> ways;
  for (int k = 0; k <= 60; ++k) ways.push_back(0.05 * k * edge);
  Ensemble all;
  for (int k = 0; k < realizations_of(p); ++k) add(pulse(p, k), ways, all);
  const Pulse first = pulse(p, 0);
  const report::Output& output = chapter.output();
  write_pictures(first, output);
  write_histories(all, ways, output);
  write_sampling(p, output);
  write_times(all, first.bodies, output);
  report::Checks& checks = chapter.claims("checks");
  checks.add("pulse: heat of all spheres over the energy that rays have lost, less 1", all.energy_off, 1e-12);
  checks.add("pulse: temperatures hit by hit over those of all hits at once, less 1", all.jumps_off, 1e-13);
  checks.add("pulse: mean speed of its rays over c, less 1, at any time", all.speed_off, 1e-12);
  checks.add("rays and temperatures in turn: sweeps beyond two", sweeps(p, first) - 2, 0.0);
  checks.add("steady beam: temperatures at the end of a run over those of equilibrium, less 1",
             write_seconds(p, first, output), 1e-8);
}

}  // namespace ch09
