// The book's clouds: how they start, what they keep, and located contacts as what stepped ones approach.

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/contact/friction.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"
#include "relative_energy.hpp"

namespace verification::clouds {

using namespace particulate;

constexpr double eps = std::numeric_limits<double>::epsilon();

// A velocity's component, uniform in +-w, has the variance w^2/3; the bulk keeps 1/N of it.
const Case start_energies{
    {.name = "start_energies",
     .claim = "the start has the energies of its distribution, split between the bulk and the motion about it",
     .equation = "M 2.28",
     .reference = Reference::statistics},
    [](Rows& rows) {
      constexpr Eigen::Index N = 1000;
      const std::uint64_t seeds = rows.quick() ? 50 : 500;
      Eigen::ArrayXd relative(static_cast<Eigen::Index>(seeds)), bulk(static_cast<Eigen::Index>(seeds));
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const kinematics::Particles cloud = book_cloud(N, rows.case_seed() + seed);
        const kinematics::KineticEnergy energy = kinematics::split_kinetic_energy(cloud.mass, cloud.velocity);
        relative[static_cast<Eigen::Index>(seed)] = energy.relative;
        bulk[static_cast<Eigen::Index>(seed)] = energy.bulk;
      }
      const double spread = 1.0 / 3.0 + 2.0 / 300.0, n = static_cast<double>(seeds);
      const auto compare = [&](const char* name, const Eigen::ArrayXd& x, double expected) {
        rows.compare(name, {.expected = expected,
                            .computed = x.mean(),
                            .tolerance = absolute(4.0 * std::sqrt((x - x.mean()).square().sum() / (n * (n - 1.0)))),
                            .because = "four standard errors, from the scatter of the starts"});
      };
      compare("relative energy per mass [J/kg]", relative, 0.5 * (1.0 - 1.0 / N) * spread);
      compare("bulk energy per mass [J/kg]", bulk, 0.5 * (1.0 + 0.01 + 0.01 + spread / N));
    }};

// How near the nearest two of a start are, over the sum of their radii, by all images.
double nearest(const kinematics::Vectors& place, const Eigen::VectorXd& radius, double period) {
  double least = 1e300;
  for (Eigen::Index i = 0; i < place.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < place.rows(); ++j) {
      Eigen::Array3d d = (place.row(i) - place.row(j)).transpose().array().abs();
      if (period > 0.0) d = d.min(period - d);
      least = std::min(least, d.matrix().norm() / (radius[i] + radius[j]));
    }
  }
  return least;
}

// Of two spheres in a periodic cube the second finds each place taken with the probability q = (4/3) pi (2 b)^3: its
// tries are distributed geometrically.
void count_tries(Rows& rows) {
  constexpr double b = 0.2, q = 32.0 / 3.0 * std::numbers::pi * b * b * b;
  const int pairs = rows.quick() ? 4000 : 40000;
  const kinematics::Space periods{.lengths = Eigen::Vector3d::Ones()};
  Uniform uniform(rows.case_seed());
  long tries = 0;
  for (int k = 0; k < pairs; ++k) {
    tries += kinematics::random_addition(Eigen::Vector2d::Constant(b), {.domain = periods}, [&] { return uniform(); })
                 .attempts -
             1;
  }
  rows.compare("mean tries of the second of two spheres [-]",
               {.expected = 1.0 / (1.0 - q),
                .computed = static_cast<double>(tries) / pairs,
                .tolerance = absolute(4.0 * std::sqrt(q / pairs) / (1.0 - q)),
                .because = "four standard errors of a geometric distribution"});
}

const Case random_addition_case{
    {.name = "random_addition",
     .claim =
         "spheres added at random overlap nowhere, across periods neither, and take the tries that chance asks for",
     .equation = "R 4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Eigen::Index N = rows.quick() ? 500 : 2000;
      const double at_30_percent = std::cbrt(0.3 * 3.0 / (4.0 * std::numbers::pi * static_cast<double>(N)));
      Eigen::VectorXd sizes = Eigen::VectorXd::LinSpaced(N, 1.6, 0.4) * at_30_percent;
      const kinematics::Space periods{.lengths = Eigen::Vector3d::Ones()};
      struct Start {
        const char* name;
        Eigen::VectorXd radius;
        kinematics::Addition to;
      };
      const std::array starts{
          Start{"periodic, phi = 0.3", Eigen::VectorXd::Constant(N, at_30_percent), {.domain = periods}},
          Start{"periodic, radii 4 to 1", 0.8 * sizes, {.domain = periods}},
          Start{"wholly inside", 0.85 * sizes, {.inside = kinematics::Inside::spheres}}};
      for (const auto& [name, radius, to] : starts) {
        Uniform uniform(rows.case_seed());
        const kinematics::Added added = kinematics::random_addition(radius, to, [&] { return uniform(); });
        rows.at_least(fmt::format("least distance over the sum of radii, {}", name),
                      {.limit = 1.0 - 4.0 * eps,
                       .computed = nearest(added.position, radius, has_periods(to.domain) ? 1.0 : 0.0),
                       .because = "none overlaps another, but for the rounding of the distance"});
        const double margin = to.inside == kinematics::Inside::spheres ? 1.0 : 0.0;
        double out = 0.0;
        for (Eigen::Index i = 0; i < N; ++i) {
          out =
              report::worse_of(out, (added.position.row(i).array() - 0.5).abs().maxCoeff() + margin * radius[i] - 0.5);
        }
        rows.at_most(fmt::format("farthest outside the box [m], {}", name),
                     {.limit = eps, .computed = out, .because = "one rounding of the place"});
      }
      rows.compare("volume fraction of the book's cloud [-]",
                   {.expected = 0.0654498469497874,
                    .computed = volume_fraction(book_cloud(100, 1).radius, kinematics::Box{}),
                    .tolerance = relative(1e-13),
                    .because = "(4/3) pi (1/4)^3; a sum of a hundred numbers"});
      count_tries(rows);
    }};

// The first of the four is without near field.
constexpr std::array near_fields{laws::NearField{}, laws::NearField{.alpha1 = 0.1, .alpha2 = 0.05},
                                 laws::NearField{.alpha1 = 0.25, .alpha2 = 0.125},
                                 laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25}};

const contact::Contact<contact::Restitution, contact::Friction> book_contact{
    .restitution = {.e_o = 0.5, .v_star = 10.0, .e_minus = 0.1}, .friction = {.mu_s = 0.2, .mu_d = 0.1}, .gamma = 0.01};

const Case kept{
    {.name = "clouds_keep_momentum",
     .claim =
         "a cloud keeps its momentum and the energy of its bulk; without near field its relative energy only falls",
     .equation = "M 2.28",
     .reference = Reference::identity},
    [](Rows& rows) {
      const Eigen::Index N = rows.quick() ? 200 : 1000;
      for (std::size_t k = 0; k < near_fields.size(); ++k) {
        const scenes::Scene scene(book_cloud(N, rows.case_seed()), kinematics::Space{}, near_fields[k], book_contact);
        const Eigen::VectorXd& mass = scene.particles().mass;
        schemes::State state = scenes::start(scene);
        const Eigen::Vector3d momentum = kinematics::linear_momentum(mass, rows_of(state.v));
        const auto energy = [&](const schemes::State& at) {
          return kinematics::split_kinetic_energy(mass, rows_of(at.v));
        };
        const double bulk = energy(state).bulk;
        double off = 0.0, bulk_off = 0.0, rise = 0.0, relative = energy(state).relative;
        const auto watch = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
          off = report::worse_of(off, (kinematics::linear_momentum(mass, rows_of(to.v)) - momentum).norm());
          const kinematics::KineticEnergy now = energy(to);
          bulk_off = report::worse_of(bulk_off, std::abs(now.bulk - bulk) / bulk);
          rise = report::worse_of(rise, now.relative / relative - 1.0);
          relative = now.relative;
          return true;
        };
        schemes::VelocityVerlet scheme;
        schemes::FixedStep control{.step = 2e-3};
        const schemes::Outcome outcome = schemes::integrate(scene, state, 1.0, scheme, control, watch);
        require_reached(outcome);
        const std::string which = fmt::format(", near field ({})", k + 1);
        const char* const because = "roundings of every velocity in 500 steps, of either sign and a few eps together";
        rows.at_least("impacts" + which, {.limit = 0.5 * static_cast<double>(N),
                                          .computed = static_cast<double>(outcome.impacts),
                                          .because = "else the claim is empty"});
        rows.at_most("change of momentum over its size" + which,
                     {.limit = 16.0 * eps, .computed = off / momentum.norm(), .because = because});
        rows.at_most("change of the bulk energy over its size" + which,
                     {.limit = 32.0 * eps, .computed = bulk_off, .because = because});
        if (k > 0) continue;
        rows.at_most("largest rise of the relative energy in a step, over it" + which,
                     {.limit = 8.0 * eps, .computed = rise, .because = "rounding of the sum"});
      }
    }};

// Near field (2), located contacts.
const Case located{{.name = "clouds_located",
                    .claim = "located contacts let no two spheres of a cloud overlap, and its books close",
                    .equation = "R 2.2",
                    .reference = Reference::identity},
                   [](Rows& rows) {
                     const Eigen::Index N = rows.quick() ? 200 : 1000;
                     const double t_end = rows.quick() ? 0.5 : 1.0;
                     const scenes::Scene scene = located_cloud(N, rows.case_seed());
                     const Eigen::VectorXd& mass = scene.particles().mass;
                     schemes::State state = scenes::start(scene);
                     const auto total = [&](const schemes::State& at) {
                       return kinematics::kinetic_energy(mass, rows_of(at.v)) + scene.potential_energy(at);
                     };
                     const double before = total(state), kinetic = kinematics::kinetic_energy(mass, rows_of(state.v));
                     const Eigen::Vector3d momentum = kinematics::linear_momentum(mass, rows_of(state.v));
                     schemes::Collocation<schemes::Gauss<4>> scheme;
                     schemes::ErrorControl control{.TOL = 1e-12, .sweep_TOL = 1e-13, .limit = 0.02};
                     const schemes::Outcome outcome = schemes::integrate(scene, state, t_end, scheme, control);
                     require_reached(outcome);
                     rows.at_least("impacts", {.limit = 0.4 * t_end * static_cast<double>(N),
                                               .computed = static_cast<double>(outcome.impacts),
                                               .because = "else the claim is empty"});
                     rows.at_most("largest overlap over the sum of the radii",
                                  {.limit = 1e-12,
                                   .computed = outcome.overlap / (2.0 * scene.particles().radius[0]),
                                   .because = "the width within which a gap counts as closed"});
                     rows.at_most("T + V + what impacts took, less what was at the start, over T",
                                  {.limit = 1e-12,
                                   .computed = std::abs(total(state) - outcome.energy_change - before) / kinetic,
                                   .because = "steps at a tolerance of 1e-12, of order 8"});
                     rows.at_most("change of momentum over its size",
                                  {.limit = 1e-12,
                                   .computed = (kinematics::linear_momentum(mass, rows_of(state.v)) - momentum).norm() /
                                               momentum.norm(),
                                   .because = "forces cancel in each pair; roundings of some thousand steps"});
                   }};

// The time mean of the relative energy takes every impact at its moment, which the energy at one moment does not: only
// the few impacts that are late there would count, at random. A stepped impact is late by anything up to a step: by
// half of it in the mean, which is the first order.
const Case approach{
    {.name = "clouds_stepped_approach_located",
     .claim = "stepped contacts approach located ones at order 1 in the mean relative energy of many clouds",
     .equation = "R 2.2",
     .reference = Reference::convergence},
    [](Rows& rows) {
      constexpr double t_end = 0.3;
      constexpr Eigen::Index N = 100;
      const std::uint64_t seeds = rows.quick() ? 16 : 160;
      const std::array counts{75, 150, 300, 600, 1200};
      std::array<double, counts.size()> steps{}, errors{};
      std::vector<Eigen::ArrayXd> off(counts.size(), Eigen::ArrayXd(static_cast<Eigen::Index>(seeds)));
      const schemes::ErrorControl tight{.TOL = 1e-8, .sweep_TOL = 1e-9, .limit = 0.02};
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const auto stepped = stepped_cloud(N, rows.case_seed() + seed);
        const double limit = mean_of_run(located_cloud(N, rows.case_seed() + seed), t_end,
                                         schemes::Collocation<schemes::Gauss<4>>(), tight)
                                 .energy;
        for (std::size_t k = 0; k < counts.size(); ++k) {
          off[k][static_cast<Eigen::Index>(seed)] =
              mean_of_run(stepped, t_end, schemes::VelocityVerlet(),
                          schemes::FixedStep{.step = t_end / static_cast<double>(counts[k])})
                  .energy -
              limit;
        }
      }
      for (std::size_t k = 0; k < counts.size(); ++k) {
        steps[k] = t_end / static_cast<double>(counts[k]);
        errors[k] = off[k].mean();
        const double n = static_cast<double>(seeds);
        rows.at_most(
            fmt::format("standard error over the error, steps of {} s", steps[k]),
            {.limit = 0.25,
             .computed = std::sqrt((off[k] - errors[k]).square().sum() / (n * (n - 1.0))) / errors[k],
             .because = "runs of one start share their impacts, so that the slope scatters less than each error"});
      }
      rows.order("mean relative energy, stepped against located",
                 {.nominal = 1.0,
                  .steps = steps,
                  .errors = errors,
                  .floor = 1e-8,
                  .because = "impacts are late by half a step in the mean; located at a tolerance of 1e-8"});
    }};

}  // namespace verification::clouds
