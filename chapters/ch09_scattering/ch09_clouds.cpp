//! @page ch09_clouds Chapter 9: Clouds, their spacing and shape
//! @brief How much of a beam goes on, against the size of spheres and of ellipsoids, for light and for sound.
//! @tableofcontents
//!
//! @section ch09_clouds_question Forward, and how much
//!
//! The question of section 9.3: what is left of a beam's irradiance in its own direction, once all rays have left? The
//! monograph draws \f$ I_x/\|I(0)\| \f$ against the *length ratio* \f$ L = b/(V/N_p)^{1/3} \f$, radius over spacing.
//!
//! @figure{ch09_forward, What is left along the beam\, signed\, against L for spheres\, with standard errors: Figure 9.7.}
//!
//! \f$ I_x = \sum_r I_r\, d_{r,x} \f$ is *signed*: what comes back counts against what goes on. Beside it stands the
//! sum over rays that go on, \f$ d_{r,x} > 0 \f$, alone.
//!
//! @section ch09_clouds_program The program
//!
//! Of each answer we want the mean over many clouds and its standard error.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>

#include "ch09_scattering.hpp"

namespace ch09 {
namespace {

template <class Law>
struct Series {
  double L;
  Law law;
  std::vector<double> x = {}, forward = {}, absorbed = {};  // shares of the beam, a number for each cloud
  double unaccounted = 0.0;                                 // the largest share of a ledger that is nowhere
};

template <class Law>
void add(const Ledger& ledger, Series<Law>& to) {
  to.x.push_back(ledger.x / ledger.incident);
  to.forward.push_back(ledger.forward / ledger.incident);
  to.absorbed.push_back(ledger.absorbed / ledger.incident);
  to.unaccounted = report::worse_of(to.unaccounted, std::abs(ledger.accounted() / ledger.incident - 1.0));
}

//! One cloud serves all laws, and each gets the same rays: their answers differ by the law alone.

template <class Law, class Place>
std::vector<Series<Law>> follow(const Parameters& p, const std::string& label, const std::vector<double>& sizes,
                                const std::vector<Law>& laws, const Place& place) {
  std::vector<Series<Law>> all;
  report::Progress progress(label, static_cast<double>(sizes.size()));
  for (const double L : sizes) {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    for (const Law& law : laws) all.push_back({.L = L, .law = law});
    for (int k = 0; k < realizations_of(p); ++k) {
      const std::function<double()> uniform = uniform_from(seed_of(p, k));
      const auto cloud = place(L, uniform);
      const Rays rays = rays_of(beam, p.rays, uniform);
      std::for_each(all.begin() + first, all.end(), [&](Series<Law>& one) {
        add(trace(cloud, one.law, rays, {.threads = p.line.common().threads}).ledger, one);
      });
    }
    progress.at(static_cast<double>(all.size()) / static_cast<double>(laws.size()));
  }
  return all;
}

//! The monograph averages until nothing changes any more. Our reading: the running mean has settled with the first
//! realization at which its last three changes were all below a tolerance.

std::size_t settled_after(const std::vector<double>& x, double tolerance) {
  double sum = 0.0, mean = 0.0;
  for (std::size_t k = 1, calm = 0; k <= x.size(); ++k) {
    sum += x[k - 1];
    const double next = sum / static_cast<double>(k);
    calm = k > 1 && std::abs(next - mean) <= tolerance ? calm + 1 : 0;
    mean = next;
    if (calm == 3) return k;
  }
  return 0;
}

double mean_of_first(const std::vector<double>& x, std::size_t n) {
  return std::accumulate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n), 0.0) / static_cast<double>(n);
}

std::string with_error(const report::Mean& mean) {
  return fmt::format("{:+.4f} ± {:.4f}", mean.value, mean.standard_error);
}

//! A line for each size and law goes into a file for figures; readers get one line a size.

std::string name(const Fresnel& law) { return fmt::format("n^ = {:g}", law.n_hat); }
std::string name(const FluidFluid& law) { return fmt::format("Z^ = {:g} and c^ = {:g}", law.Z_hat, law.c_hat); }

template <class Law>
void write(const Parameters& p, const std::string& file, const std::vector<Series<Law>>& all, double share_of_ball,
           const report::Output& output) {
  report::Table table({"law", "L [-]", "volume fraction [-]", "I_x/I(0) [-]", "standard error [-]", "forward sum [-]",
                       "its standard error [-]", "absorbed [-]", "settled after", "running mean then [-]"});
  for (const Series<Law>& one : all) {
    const report::Mean x = report::mean_of(one.x), forward = report::mean_of(one.forward);
    const std::size_t settled = settled_after(one.x, p.settled);
    const double v_f = 4.0 / 3.0 * std::numbers::pi * one.L * one.L * one.L * share_of_ball;
    table.add({name(one.law), one.L, v_f, x.value, x.standard_error, forward.value, forward.standard_error,
               report::mean_of(one.absorbed).value, settled > 0 ? report::Cell(settled) : report::Cell(),
               settled > 0 ? report::Cell(mean_of_first(one.x, settled)) : report::Cell()});
  }
  output.write(file, table);
}

template <class Law>
void write_short(const std::string& file, const std::vector<Series<Law>>& all, const report::Output& output) {
  std::vector<std::string> columns{"L"};
  for (const Series<Law>& one : all) {
    if (one.L == all.front().L) columns.push_back(name(one.law));
  }
  report::Table table(columns);
  for (std::size_t k = 0; k < all.size(); k += columns.size() - 1) {
    std::vector<report::Cell> row{all[k].L};
    for (std::size_t j = k; j < k + columns.size() - 1; ++j) row.push_back(with_error(report::mean_of(all[j].x)));
    table.add(row);
  }
  output.write(file, table);
}

template <class Law>
double worst_unaccounted(const std::vector<Series<Law>>& all) {
  double worst = 0.0;
  for (const Series<Law>& one : all) worst = report::worse_of(worst, one.unaccounted);
  return worst;
}

//! @section ch09_spheres Spheres: what is claimed
//!
//! Whether a difference is more than chance is judged by the clouds, in pairs: those of the same seed share their
//! uncertainty. By how much is the mean of a difference away from zero, in standard errors?

double in_standard_errors(const std::vector<double>& x) {
  const report::Mean mean = report::mean_of(x);
  return mean.value / mean.standard_error;
}

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::minus<>{});
  return a;
}

const Series<Fresnel>& at(const std::vector<Series<Fresnel>>& all, double L, double n_hat) {
  return *std::find_if(all.begin(), all.end(),
                       [&](const Series<Fresnel>& one) { return one.L == L && one.law.n_hat == n_hat; });
}

// What a number lacks of a bound.
double missing_to(double bound, double number) { return number >= bound ? 0.0 : bound - number; }

void claim_of_spheres(const std::vector<Series<Fresnel>>& all, report::Checks& checks) {
  const Series<Fresnel>&ten = at(all, 0.325, 10.0), &four = at(all, 0.325, 4.0), &hundred = at(all, 0.325, 100.0);
  checks.add("spheres, L = 0.325, n^ = 10: more comes back than goes on; lacks of 4 standard errors [-]",
             missing_to(4.0, in_standard_errors(difference(std::vector<double>(ten.x.size(), 0.0), ten.x))), 0.0);
  checks.add("spheres, L = 0.325: with larger n^, 4, 10 and 100, I_x is less; lacks of 4 standard errors [-]",
             std::max(missing_to(4.0, in_standard_errors(difference(four.x, ten.x))),
                      missing_to(4.0, in_standard_errors(difference(ten.x, hundred.x)))),
             0.0);
  checks.add("spheres, n^ = 10: from L = 0.25 to 0.425 the forward sum falls; lacks of 4 standard errors [-]",
             missing_to(4.0, in_standard_errors(difference(at(all, 0.25, 10.0).forward, at(all, 0.425, 10.0).forward))),
             0.0);
}

//! @section ch09_shapes Ellipsoids
//!
//! Scatterers of another shape (9.3.3): oblate spheroids, 4:1, with the semi-axes L, L and L/4 times the spacing, in
//! random orientation. They are a quarter as bulky at the same L, which is why L may be larger.

Cloud<Spheroid> oblates(double L, const std::function<double()>& uniform) {
  const Spheroid like{.equatorial = radius_of(L), .polar = radius_of(L) / 4.0};
  return {place_spheroids(scatterers, like, into_cube, uniform).bodies, {}};
}

//! @section ch09_sound Sound
//!
//! The same rays may be sound of short waves, between fluids (particulate::scattering::FluidFluid), with
//! \f$ \hat Z = Z_t/Z_i \f$ and \f$ \hat c = c_t/c_i \f$. It is an analogue in the strict sense: sound is reflected as
//! light whose electric field lies across the plane of incidence is, with \f$ \hat Z = \hat\mu/\hat n \f$ and
//! \f$ \hat c = 1/\hat n \f$, which is the \f$ 1/\tilde c \f$ of the monograph's caption.

double worst_of_analogue() {
  double worst = 0.0;
  for (const Fresnel light : {Fresnel{1.5, 1.0}, Fresnel{10.0, 1.0}, Fresnel{2.0, 2.0}, Fresnel{4.0, 10.0}}) {
    const FluidFluid sound{.Z_hat = light.mu_hat / light.n_hat, .c_hat = 1.0 / light.n_hat};
    for (int k = 0; k <= 100; ++k) {
      const double cosine = k / 100.0;
      worst = report::worse_of(worst, std::abs(r_pressure(sound, cosine) - r_perpendicular(light, cosine)));
    }
  }
  return worst;
}

}  // namespace

void clouds(const Parameters& p, report::Chapter& chapter) {
  const std::vector<double> sizes{0.25, 0.275, 0.3, 0.325, 0.35, 0.375, 0.4, 0.425};
  std::vector<double> oblate_sizes{0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.54, 0.58, 0.6, 0.62};
  if (p.line.common().quick) oblate_sizes.resize(8);  // the densest take most of the time
  const std::vector<Fresnel> light{{1.5}, {2.0}, {4.0}, {10.0}, {100.0}};
  const std::vector<FluidFluid> sound{{2.0, 0.5}, {2.0, 2.0}, {10.0, 0.5}, {10.0, 2.0}};
  const auto of_spheres = follow(p, "spheres", sizes, light, spheres);
  const auto of_oblates = follow(p, "ellipsoids", oblate_sizes, light, oblates);
  const auto of_sound = follow(p, "sound", {sizes.begin(), sizes.end() - 1}, sound, spheres);
  const report::Output& output = chapter.output();
  write(p, "spheres", of_spheres, 1.0, output);
  write(p, "oblates", of_oblates, 0.25, output);
  write(p, "sound", of_sound, 1.0, output);
  write_short("spheres_x", of_spheres, output);
  write_short("oblates_x", of_oblates, output);
  write_short("sound_x", of_sound, output);
  report::Checks& checks = chapter.claims("checks");
  checks.add("all clouds: share of a beam's power that is nowhere",
             std::max({worst_unaccounted(of_spheres), worst_unaccounted(of_oblates), worst_unaccounted(of_sound)}),
             1e-12);
  claim_of_spheres(of_spheres, checks);
  checks.add("sound against light polarized across the plane of incidence: difference of amplitudes",
             worst_of_analogue(), 4e-15);
}

}  // namespace ch09

//! @section ch09_clouds_results Spheres
//!
//! \f$ I_x/\|I(0)\| \f$, signed, with its standard error (9.3.2):
//!
//! @table{ch09_spheres_x}
//!
//! @figure{ch09_forward_sum, The forward sum alone\, and what is absorbed\, for spheres.}
//!
//! A thin cloud lets part of the beam pass between its spheres, whatever they are made of; that part falls with L and
//! is soon gone. What is left is scattered light. With small \f$ \hat n \f$ spheres absorb nearly all of it at the
//! first two or three hits, and \f$ I_x \f$ goes to zero. With large \f$ \hat n \f$ they are mirrors: the cloud turns
//! more and more of the beam back, and \f$ I_x \f$ is *negative*. A forward sum cannot show that. It falls towards zero
//! for any \f$ \hat n \f$, whether a cloud sends back what does not come through, or keeps it.
//!
//! **When to stop.** The table of the run (`spheres.csv`) has the realization at which the running mean had settled,
//! and where it stood. A mean of k numbers moves by about \f$ \sigma/k \f$ with the next one, while it is off by about
//! \f$ \sigma/\sqrt k \f$: whoever stops when the mean changes by no more than a tolerance is off by about
//! \f$ \sqrt k \f$ times that. Ten to twenty realizations suffice for the eye; a number needs its standard error.
//!
//! @figure{ch09_settling, Where the running mean had settled\, and the mean of all realizations\, n^ = 10. Numbers: after how many realizations; no mark: not within the run.}
//!
//! @section ch09_oblates_results Ellipsoids
//!
//! @figure{ch09_oblates, Oblate ellipsoids 4:1 in random orientation\, against L: Figure 9.9.}
//!
//! @table{ch09_oblates_x}
//!
//! At equal L ellipsoids shade less than spheres, as they are seen from the side as often as from above. At equal
//! volume they shade more: there is more surface to it. Their volume fraction is \f$ \pi L^3/3 \f$; see the
//! @ref errata "errata candidates". They cannot be put at random much more densely than the largest L here.
//!
//! @section ch09_sound_results Sound
//!
//! @figure{ch09_sound, Sound: what is left along the beam for four pairs of fluids: Figure 9.10.}
//!
//! @table{ch09_sound_x}
//!
//! With \f$ \hat c > 1 \f$ all is reflected beyond the critical angle, \f$ \sin\theta_c = 1/\hat c \f$. Light does so
//! only out of the denser medium. Grazing reflection turns a ray little, and a cloud of such scatterers passes sound on
//! from one to the other instead of keeping it.
//!
//! @section ch09_clouds_exercises Exercises
//!
//! 1. Which share of the beam passes a cloud without any hit, at which L? Find it with `most_hits = 0`, and compare
//!    with \f$ e^{-\pi b^2 n x} \f$. Why is it less?
//! 2. Let \f$ \hat n \to \infty \f$. Where does the power go, and what does the cloud's reflection depend on then?
//! 3. Replace the ellipsoids by prolate ones of the same volume. Are they nearer to spheres, or farther?
//! 4. How many realizations does a standard error of 1e-4 take? What is better: more clouds or more rays?
