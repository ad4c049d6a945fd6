//! @page ch09_heat Chapter 9: Light that heats
//! @brief A pulse crosses the cloud, and each scatterer is as warm as the light that it absorbed has made it.
//! @tableofcontents
//!
//! @section ch09_heat_question Where the rest of the power goes
//!
//! What a ray loses where it is reflected, the scatterer gains (9.5). How warm does it become?
//!
//! @figure{ch09_hot, A pulse at four lengths of path\, and the spheres below the middle of the cube\, coloured from 300 K to the hottest. A line shows where a ray goes\, as long as its irradiance. Figure 9.14.}
//!
//! @figure{ch09_hot_mean, The same\, coloured from 300 K to the mean temperature of the last picture: what is warmer is as dark. Figure 9.15.}
//!
//! These are the same temperatures, twice. Absorption is so uneven that no one scale shows it. In the first picture
//! most spheres look cold, those in the light apart; in the second nearly all that the beam has met look equally hot.
//!
//! @animation{ch09_heat_film, The pulse in motion\, with the colours of the first picture.}
//!
//! @section ch09_heat_model The balance of one scatterer
//!
//! @figure{ch09_balance, What a sphere gets and what it gives: Figure 9.11.}
//!
//! \f[ m\,c\,\dot\theta = P - a_s \left[h_c\,(\theta - \theta_o) + B\,\varepsilon\,(\theta^4 - \theta_s^4)\right],
//!     \qquad a_s = 4\pi b^2, \f]
//!
//! with \f$ P = \sum (1 - R)\, I_r \f$ over the rays that hit it (particulate::scattering::HeatedBodies). Each sphere
//! has one temperature, and none lights another but by the rays: what it radiates is lost to surroundings of
//! \f$ \theta_s \f$. Here \f$ \varepsilon = 1 \f$, nothing flows around the spheres, \f$ h_c = 0 \f$, and all begin
//! with \f$ \theta_0 = \theta_s = 300 \f$ K.
//!
//! @figure{ch09_length_scale, A scatterer is measured by the edge of a cube as large as its share of space: Figure 9.12.}
//!
//! Rays know no lengths, and the cloud of the other pages may be of any size. Heat does: a sphere is warmed as its
//! shadow is large, and holds heat as its volume is. A pulse of fluence H warms a lone sphere by
//! \f$ 3\,(1 - F)\,H/(4\,\varrho\,c\,b) \f$, with F of @ref ch09_one_results "one scatterer". The cube now has
//! an @ref ch09_parameters "edge", D.
//!
//! @section ch09_heat_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/report/spread.hpp>
#include <particulate/scattering/heat.hpp>

#include "ch09_scattering.hpp"

namespace ch09 {

//! Rays of a beam whose irradiance is a fluence carry joules. Nothing else is new.

Pulse pulse(const Parameters& p, int k) {
  const std::function<double()> uniform = uniform_from(seed_of(p, k));
  const Cloud<Sphere> cloud = small_spheres(p, uniform);
  const Rays rays = rays_of(small_beam(p, p.fluence), p.rays, uniform);
  return {cloud, heated_bodies(cloud, p.rho_c, radiation), rays,
          trace(cloud, Fresnel{p.n_hat}, rays, {.keeps_paths = true, .threads = p.line.common().threads})};
}

//! Every hit is a jump of temperature at its time of flight (particulate::scattering::heat_jumps). To watch temperatures
//! is to make the jumps in their order.

namespace {

// Calls visit(k, theta) when light has gone the k-th of these ways, which grow.
template <class Visit>
Eigen::VectorXd warm(const Pulse& pulse, const std::vector<double>& ways, const Visit& visit) {
  const std::vector<HeatJump> jumps = heat_jumps(pulse.traced.paths);
  Eigen::VectorXd theta = start(pulse.bodies, theta_0).y;
  auto jump = jumps.begin();
  for (std::size_t k = 0; k < ways.size(); ++k) {
    for (; jump != jumps.end() && jump->t <= ways[k] / speed_of_light; ++jump) {
      theta[jump->body] += jump->energy / pulse.bodies.capacity[jump->body];
    }
    visit(k, theta);
  }
  return theta;
}

//! Places need not be written again: but for its size the cloud is the one of @ref ch09_rays "a beam on its way", and so
//! are the rays. Rounding, which each hit makes many times larger, tells the two apart after a dozen hits, when next to
//! nothing is left of a ray.

void write_temperatures(const Parameters& p, const Pulse& pulse, const report::Output& output) {
  std::vector<double> ways;
  std::vector<std::string> columns;
  for (int k = 0; k < 25; ++k) {
    ways.push_back(0.1 * k * p.edge);
    columns.push_back(fmt::format("temperature at c t = {:.1f} D [K]", 0.1 * k));
  }
  std::vector<Eigen::VectorXd> theta;
  warm(pulse, ways, [&](std::size_t, const Eigen::VectorXd& now) { theta.push_back(now); });
  report::Table table(columns);
  for (Eigen::Index i = 0; i < theta.front().size(); ++i) {
    std::vector<report::Cell> row;
    for (const Eigen::VectorXd& now : theta) row.emplace_back(now[i]);
    table.add(row);
  }
  output.write("temperatures", table);
}

//! @section ch09_heat_histories Histories
//!
//! The monograph's figures 9.16 to 9.18 show means over all rays, and over all scatterers, against time. Here they are
//! means over clouds as well. Rays that have left go straight on. Radiation is the net one, what spheres give less what
//! they get from surroundings of \f$ \theta_s \f$: that is what the balance holds, and it begins at zero.

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
std::vector<Followed> history(const Parameters& p, const Pulse& pulse, const std::vector<double>& ways) {
  const std::vector<Path> paths = split(pulse.traced.paths, pulse.rays.size());
  std::vector<Followed> rows;
  warm(pulse, ways, [&](std::size_t k, const Eigen::VectorXd& theta) {
    Followed sums = Followed::Zero();
    for (const Path& path : paths) {
      const Moment now = moment_of(path, pulse.traced.rays, ways[k]);
      const double share = now.power / path.front().power, speed = now.velocity.norm();
      Followed one = Followed::Zero();
      one.head<11>() << now.place.transpose() / p.edge, now.velocity.transpose(), speed,
          share * now.velocity.transpose(), share * speed;
      sums += one;
    }
    rows.push_back(sums / static_cast<double>(paths.size()));
    rows.back().tail<3>() << theta.mean(), theta.maxCoeff(), net_radiation(theta);
  });
  return rows;
}

void write_histories(const Parameters& p, const std::vector<std::vector<Followed>>& all,
                     const std::vector<double>& ways, const report::Output& output) {
  const auto mean = [&](std::size_t k, std::size_t q) {
    std::vector<double> numbers;
    for (const std::vector<Followed>& one : all) numbers.push_back(one[k][static_cast<Eigen::Index>(q)]);
    return report::mean_of(numbers);
  };
  std::vector<std::string> columns{"c t/D"};
  columns.insert(columns.end(), followed.begin(), followed.end());
  report::Table against_time(columns), numbers({"mean", "at c t = D/4", "D/2", "D", "3 D", "standard error then"});
  for (std::size_t k = 0; k < ways.size(); ++k) {
    std::vector<report::Cell> row{ways[k] / p.edge};
    for (std::size_t q = 0; q < followed.size(); ++q) row.emplace_back(mean(k, q).value);
    against_time.add(row);
  }
  for (std::size_t q = 0; q < followed.size(); ++q) {
    const report::Mean end = mean(60, q);
    numbers.add({followed[q], mean(5, q).value, mean(10, q).value, mean(20, q).value, end.value, end.standard_error});
  }
  output.write("history", against_time);
  output.write("histories", numbers);
}

//! @section ch09_heat_sampling How hot is the hottest?
//!
//! The hottest of a thousand spheres is an extreme, and with few rays it is one that was hit often by chance. More rays
//! through the same clouds tell by how much.

std::string with_error(const std::vector<double>& numbers, int digits) {
  const report::Mean mean = report::mean_of(numbers);
  return fmt::format("{:.{}f} ± {:.{}f}", mean.value, digits, mean.standard_error, digits);
}

void write_sampling(const Parameters& p, const report::Output& output) {
  report::Table table({"rays", "mean rise [K]", "hottest, rise over the mean", "net radiation [W/m^2]"});
  for (const Eigen::Index rays : {1000, 4000, 16000, 64000}) {
    std::vector<double> mean, hottest, radiated;
    for (int k = 0; k < realizations_of(p); ++k) {
      const std::function<double()> uniform = uniform_from(seed_of(p, k));
      const Cloud<Sphere> cloud = small_spheres(p, uniform);
      const Traced traced = trace(cloud, Fresnel{p.n_hat}, rays_of(small_beam(p, p.fluence), rays, uniform),
                                  {.threads = p.line.common().threads});
      const Eigen::ArrayXd rise = traced.absorbed.cwiseQuotient(heated_bodies(cloud, p.rho_c).capacity);
      mean.push_back(rise.mean());
      hottest.push_back(rise.maxCoeff() / rise.mean());
      radiated.push_back(net_radiation(theta_0 + rise));
    }
    table.add({rays, with_error(mean, 2), with_error(hottest, 2), with_error(radiated, 0)});
  }
  output.write("sampling", table);
}

}  // namespace

void heat(const Parameters& p, report::Chapter& chapter) {
  std::vector<double> ways;
  for (int k = 0; k <= 60; ++k) ways.push_back(0.05 * k * p.edge);
  std::vector<std::vector<Followed>> histories;
  double energy_off = 0.0, jumps_off = 0.0, speed_off = 0.0;
  for (int k = 0; k < realizations_of(p); ++k) {
    const Pulse one = pulse(p, k);
    histories.push_back(history(p, one, ways));
    for (const Followed& row : histories.back()) speed_off = report::worse_of(speed_off, std::abs(row[6] - 1.0));
    const Eigen::VectorXd cold = start(one.bodies, theta_0).y, theta = warm(one, {nowhere}, [](auto&&...) {});
    const double lost = one.rays.power.sum() - one.traced.rays.power.sum();
    energy_off = report::worse_of(energy_off, std::abs(one.bodies.capacity.dot(theta - cold) / lost - 1.0));
    const Eigen::ArrayXd at_once = warmed_by(one.bodies, cold, one.traced.absorbed);
    jumps_off = report::worse_of(jumps_off, (theta.array() / at_once - 1.0).abs().maxCoeff());
  }
  write_histories(p, histories, ways, chapter.output());
  write_temperatures(p, pulse(p, 0), chapter.output());
  write_sampling(p, chapter.output());
  report::Checks& checks = chapter.claims("checks");
  checks.add("pulse: heat of all spheres over the energy that rays have lost, less 1", energy_off, 1e-12);
  checks.add("pulse: temperatures, hit by hit, over those after all hits at once, less 1", jumps_off, 1e-13);
  checks.add("pulse: mean speed of rays over c, less 1, at any time", speed_off, 1e-12);
}

}  // namespace ch09

//! @section ch09_heat_results What the means tell
//!
//! @figure{ch09_motion, Mean position and velocity of rays: Figure 9.16.}
//!
//! @figure{ch09_spent, Mean irradiance of rays\, and temperatures of scatterers: Figure 9.17.}
//!
//! @figure{ch09_radiated, Mean net radiation of scatterers\, per area of their surface: Figure 9.18.}
//!
//! @table{ch09_histories}
//!
//! At first all rays go on, and their mean place with them. It turns round where as many come back as go on; from the
//! time when most have left, the mean velocity is that of straight lines. Each ray is as fast as light throughout,
//! which the *mean* velocity hides, as it hides how much light there is: \f$ I_x \f$ falls to zero and below while rays
//! still have a good part of their power. The mean across the beam is zero but for chance, which the standard errors
//! measure; those of few clouds are rough themselves.
//!
//! Temperatures rise as irradiance falls: what rays lose warms the spheres. The hottest one, at the front, has most of
//! its heat at once. What spheres radiate goes with the fourth power: most of it comes from a few, and the mean is several
//! times what spheres of the mean temperature would radiate.
//!
//! @table{ch09_sampling}
//!
//! The mean rise needs no more rays than there are at first. The hottest sphere does: with few rays it comes out too
//! hot, always, and more clouds do not mend that. So it is with the mean radiation, whose fourth power prefers spheres
//! that were hit too often to those that were hit too rarely.
//!
//! @section ch09_heat_exercises Exercises
//!
//! 1. By how much does the pulse warm a lone sphere? The hottest sphere of a cloud is warmer, though none gets more
//!    light from the beam itself. Where does the rest come from?
//! 2. With \f$ \hat n = 100 \f$ rather than 10, a sphere absorbs less of each hit. What happens to the mean temperature,
//!    and what to the hottest? Guess, then try `--n_hat 100`.
//! 3. Draw the mean net radiation over that of a sphere of the mean temperature, against time. Why does it fall, and to
//!    what could it fall at best?
//! 4. How many rays does it take until the hottest sphere is known to one per cent, drawn at random or in equal parts
//!    of the beam (particulate::scattering::Beam::Points)?
