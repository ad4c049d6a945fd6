// Neighbours against all pairs and all images, at every age of a list; what a search looks at; points of the unit cube.

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/kinematics/cells.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>

#include "clouds.hpp"

namespace verification::neighbours {

using namespace particulate;

using Wide = long double;
using WideVector = Eigen::Matrix<Wide, 3, 1>;

constexpr double eps = std::numeric_limits<double>::epsilon();

// A set of particles, what its laws see of it, and what they remember.
struct Moment {
  kinematics::Particles all;
  kinematics::Space domain;
  laws::Scratch scratch = {};
  Eigen::VectorXd inverse_mass = kinematics::inverse_masses(all);

  laws::At<laws::Velocity> at() {
    return {{.t = 0.0,
             .position = {all.position.data(), all.size(), 3},
             .mass = all.mass,
             .radius = all.radius,
             .inverse_mass = inverse_mass,
             .scratch = scratch},
            {all.velocity.data(), all.size(), 3}};
  }
  kinematics::Vectors forces(const laws::NearField& law) {
    kinematics::Vectors sum = kinematics::Vectors::Zero(all.size(), 3);
    const laws::At<laws::Velocity> here = at();
    if (!add_force(law, domain, here, laws::Forces(sum.data(), all.size(), 3))) throw std::runtime_error("no force");
    return sum;
  }
  contact::Touching touching() { return contact::find_touching(domain, at()); }
};

// A cloud in which many overlap, its places many periods away from the first.
Moment crowd(std::uint64_t seed, Eigen::Index N, const kinematics::Space& domain, const Eigen::Vector3d& box,
             double largest_over_smallest) {
  Uniform uniform(seed);
  const double spacing = std::cbrt(box.prod() / static_cast<double>(N));
  kinematics::Particles all{.position = random_places(uniform, N, box),
                            .velocity = random_places(uniform, N).array() - 0.5,
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    all.mass[i] += uniform();
    all.radius[i] = 0.2 * spacing * std::pow(largest_over_smallest, uniform() - 0.5);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (std::isfinite(domain.lengths[axis])) {
        all.position(i, axis) += domain.lengths[axis] * std::floor(9.0 * uniform() - 4.0);
      }
    }
  }
  return {std::move(all), domain};
}

// The book's law between every body and every image of every other, in extended precision.
struct Images {
  std::map<std::pair<Eigen::Index, Eigen::Index>, Wide> depth;  // of pairs that overlap, walls as j = -1
  Eigen::Matrix<Wide, Eigen::Dynamic, 3> force;
  Eigen::Matrix<Wide, Eigen::Dynamic, 1> magnitude;  // sum of |Psi_ij|
  Wide nearest = 1.0;
};

void take_image(const Moment& of, const laws::NearField& law, Eigen::Index i, Eigen::Index j, const WideVector& towards,
                Images& all) {
  const Wide d = towards.norm();
  all.nearest = std::min(all.nearest, d);
  const Wide depth = static_cast<Wide>(of.all.radius[i]) + of.all.radius[j] - d;
  if (depth >= 0.0) all.depth[{i, j}] = depth;
  if (!(d < law.cutoff)) return;
  const Wide into = law.taper > 0.0 ? std::max(Wide{0.0}, (d - law.cutoff + law.taper) / law.taper) : Wide{0.0};
  const Wide kept = 1.0 - into * into * (3.0 - 2.0 * into);
  const Wide mass = static_cast<Wide>(of.all.mass[i]) * of.all.mass[j];
  const Wide attraction = mass * law.alpha1 / d, repulsion = mass * law.alpha2 / (d * d);
  const WideVector psi = kept * (attraction - repulsion) / d * towards;
  all.force.row(i) += psi;
  all.force.row(j) -= psi;
  all.magnitude[i] += attraction + repulsion;
  all.magnitude[j] += attraction + repulsion;
}

Images by_all_images(const Moment& of, const laws::NearField& law) {
  const Eigen::Index N = of.all.size();
  Images all;
  all.force.setZero(N, 3);
  all.magnitude.setZero(N);
  const auto images = [&](Eigen::Index axis) { return std::isfinite(of.domain.lengths[axis]) ? 1 : 0; };
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index j = i + 1; j < N; ++j) {
      WideVector home = (of.all.position.row(j).cast<Wide>() - of.all.position.row(i).cast<Wide>()).transpose();
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (images(axis)) home[axis] -= of.domain.lengths[axis] * std::floor(home[axis] / of.domain.lengths[axis]);
      }
      for (int x = -images(0); x <= 0; ++x) {
        for (int y = -images(1); y <= 0; ++y) {
          for (int z = -images(2); z <= 0; ++z) {
            WideVector towards = home;
            if (x) towards[0] -= of.domain.lengths[0];
            if (y) towards[1] -= of.domain.lengths[1];
            if (z) towards[2] -= of.domain.lengths[2];
            take_image(of, law, i, j, towards, all);
          }
        }
      }
    }
    for (const kinematics::Wall& wall : of.domain.walls) {
      const Wide depth = of.all.radius[i] - (of.all.position.row(i).transpose() - wall.point).dot(wall.normal);
      if (depth >= 0.0) all.depth[{i, -1}] = depth;
    }
  }
  return all;
}

struct Surroundings {
  const char* name;
  kinematics::Space domain;
  Eigen::Vector3d box;
  double sizes;  // largest over smallest radius
};
const double none = std::numeric_limits<double>::infinity();
const std::array surroundings{Surroundings{"unbounded, radii 1 to 20", {}, {1.0, 1.0, 1.0}, 20.0},
                              Surroundings{"periods, radii 1 to 3", {.lengths = {1.0, 0.9, 1.1}}, {1.0, 0.9, 1.1}, 3.0},
                              Surroundings{"periods of a flat box", {.lengths = {2.0, 2.0, 0.4}}, {2.0, 2.0, 0.4}, 1.0},
                              Surroundings{"two periods and a floor, radii 1 to 5",
                                           {.walls = {kinematics::Wall{}}, .lengths = {1.0, 1.0, none}},
                                           {1.0, 1.0, 1.0},
                                           5.0}};

const Case all_pairs{
    {.name = "neighbours_all_pairs",
     .claim = "a search finds the contacts and the cut-off forces of all pairs and all images, each once",
     .equation = "M 2.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      for (const auto& [name, domain, box, sizes] : surroundings) {
        const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.05, .cutoff = 0.19, .taper = 0.08};
        Moment cloud = crowd(rows.case_seed(), rows.quick() ? 500 : 2000, domain, box, sizes);
        const Images exact = by_all_images(cloud, law);
        const contact::Touching found = cloud.touching();
        long wrong = std::abs(static_cast<long>(found.contacts.size()) - static_cast<long>(exact.depth.size()));
        double worst = 0.0;
        for (const contact::Touch& touch : found.contacts) {
          const auto there = exact.depth.find({touch.i, touch.j});
          wrong += there == exact.depth.end() ? 1 : 0;
          if (there != exact.depth.end()) {
            worst = report::worse_of(worst, static_cast<double>(std::abs(touch.overlap - there->second)));
          }
        }
        rows.at_least(
            fmt::format("contacts, {}", name),
            {.limit = 50.0, .computed = static_cast<double>(exact.depth.size()), .because = "else little is compared"});
        rows.none(fmt::format("contacts that are not those of all images, {}", name), wrong, "each stands once");
        const double extent = cloud.all.position.cwiseAbs().maxCoeff();
        rows.at_most(fmt::format("depths [m], {}", name),
                     {.limit = 8.0 * eps * extent,
                      .computed = worst,
                      .because = "places that far from the origin are subtracted, with a rounding of each component"});
        const kinematics::Vectors force = cloud.forces(law);
        double off = 0.0;
        for (Eigen::Index i = 0; i < force.rows(); ++i) {
          const Wide error = (force.row(i).cast<Wide>() - exact.force.row(i)).norm();
          off = report::worse_of(off, static_cast<double>(error / std::max(exact.magnitude[i], Wide{1e-300})));
        }
        rows.at_most(fmt::format("forces over the sum of their magnitudes, {}", name),
                     {.limit = 16.0 * eps * (1.0 + extent / static_cast<double>(exact.nearest)),
                      .computed = off,
                      .because = "the rounding of the nearest pair's distance, to the powers 1 and 2"});
      }
    }};

long differing(const kinematics::Vectors& one, const kinematics::Vectors& other) {
  return (one.array() != other.array()).count();
}

long differing(const contact::Touching& one, const contact::Touching& other) {
  if (one.contacts.size() != other.contacts.size()) return 1 + std::abs(static_cast<long>(one.contacts.size()));
  long count = 0;
  for (std::size_t k = 0; k < one.contacts.size(); ++k) {
    const contact::Touch &a = one.contacts[k], &b = other.contacts[k];
    count += a.i != b.i || a.j != b.j || a.overlap != b.overlap || a.n != b.n ? 1 : 0;
  }
  return count;
}

const Case ages{
    {.name = "neighbours_every_age",
     .claim = "however old a list is, contacts and forces are to the bit those of a list that was made at that moment",
     .equation = "M 2.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      for (const auto& [name, domain, box, sizes] : surroundings) {
        const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.04, .cutoff = 0.15, .taper = 0.05};
        Moment aged = crowd(rows.case_seed(), 400, domain, box, sizes);
        const long moments = rows.quick() ? 60 : 300;
        long forces = 0, contacts = 0;
        for (long k = 0; k < moments; ++k) {
          aged.all.position += 0.004 * aged.all.velocity;
          aged.all.position.col(0).array() += 0.4;  // a common motion makes no list older
          Moment fresh{aged.all, domain};
          contacts += differing(aged.touching(), fresh.touching());
          forces += differing(aged.forces(law), fresh.forces(law));
        }
        rows.none(fmt::format("contacts that differ, {}", name), contacts,
                  "pairs within reach are taken in ascending order, whatever else the list holds");
        rows.none(fmt::format("numbers of forces that differ, {}", name), forces,
                  "sums run over the pairs within reach alone, in ascending order");
        rows.at_least(
            fmt::format("moments for each search, {}", name),
            {.limit = 3.0,
             .computed = static_cast<double>(moments) / static_cast<double>(aged.scratch.neighbours.searches()),
             .because = "else no list grew old"});
      }
    }};

// With cells of edge h that fill the box exactly, and sizes h/2, each body looks at 3^3 cells. Of N independent points
// any two share such a neighbourhood with probability p = 27/k^3, wherever one of them is: the pairs are uncorrelated,
// and their number has the mean C(N, 2) p and the variance C(N, 2) p (1 - p).
const Case cost{
    {.name = "neighbours_cost",
     .claim =
         "a body is tested against as many others however many there are, and one ten times as large changes little",
     .equation = "R 4.1",
     .reference = Reference::statistics},
    [](Rows& rows) {
      std::vector<double> per_body;
      const std::vector<int> edges = rows.quick() ? std::vector{12, 24, 54} : std::vector{12, 24, 54, 116};
      for (const int k : edges) {
        // 0.1 of the volume is filled by spheres of radius h/3, which are searched half as wide again.
        const double h = 1.0 / k, edge = h * (1.0 - 1e-9), size = 0.5 * edge, cells = std::pow(k, 3.0);
        const auto N = static_cast<Eigen::Index>(0.1 * cells * 27.0 / (4.0 / 3.0 * std::numbers::pi));
        const kinematics::Space periods{.lengths = Eigen::Vector3d::Ones()};
        Uniform uniform(rows.case_seed());
        const kinematics::Vectors places = random_places(uniform, N);
        const auto tests = [&](bool with_large) {
          kinematics::Cells all(periods, Eigen::Vector3d::Ones(), edge, N + 1);
          long count = 0;
          if (with_large) all.insert(N, Eigen::Vector3d::Constant(0.5), 10.0 * size);
          for (Eigen::Index i = 0; i < N; ++i) all.insert(i, places.row(i).transpose(), size);
          for (Eigen::Index i = 0; i < N; ++i) {
            all.near(places.row(i).transpose(), size, 0, [&](const kinematics::Cells::Body& other) {
              count += other.index > i ? 1 : 0;  // each pair once, and none with itself
            });
          }
          return static_cast<double>(count);
        };
        const double n = static_cast<double>(N), pairs = 0.5 * n * (n - 1.0), p = 27.0 / cells;
        const double alone = tests(false);
        rows.compare(fmt::format("tests of {} bodies", N),
                     {.expected = pairs * p,
                      .computed = alone,
                      .tolerance = absolute(5.0 * std::sqrt(pairs * p * (1.0 - p))),
                      .because = "five standard deviations of a sum of uncorrelated pairs"});
        per_body.push_back(alone / n);
        rows.at_most(fmt::format("tests a body with a large one among {}, beyond those without", N),
                     {.limit = 1.0, .computed = (tests(true) - alone) / n, .because = "each meets the large one once"});
      }
      const auto [least, most] = std::minmax_element(per_body.begin(), per_body.end());
      rows.at_most(
          "most over least tests a body, from a thousand on",
          {.limit = 1.5,
           .computed = *most / *least,
           .because = "as many bodies a cell at any size, but for what cells leave over at the ends of a period"});
    }};

// Mean and standard error of numbers that are drawn alike.
struct Mean {
  double value, error;
};
Mean mean_of(const std::vector<double>& drawn) {
  const Eigen::Map<const Eigen::ArrayXd> x(drawn.data(), static_cast<Eigen::Index>(drawn.size()));
  const double n = static_cast<double>(drawn.size()), mean = x.mean();
  return {mean, std::sqrt((x - mean).square().sum() / (n * (n - 1.0)))};
}

const Case unit_cube{
    {.name = "neighbours_unit_cube",
     .claim = "of independent points of the unit cube as many pairs are near, and as near, as geometry has it",
     .equation = "D 4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr Eigen::Index N = 1000;
      constexpr double all = 0.5 * N * (N - 1);
      std::array<std::vector<double>, 5> drawn;
      const std::uint64_t seeds = rows.quick() ? 30 : 300;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        Uniform uniform(rows.case_seed() + seed);
        const kinematics::Particles points{.position = random_places(uniform, N),
                                           .velocity = kinematics::Vectors::Zero(N, 3),
                                           .mass = Eigen::VectorXd::Ones(N),
                                           .radius = Eigen::VectorXd::Constant(N, 0.05)};
        Moment moment{points, {}};
        double d_sum = 0.0, inverse_sum = 0.0, log_sum = 0.0;
        for (Eigen::Index i = 0; i < N; ++i) {
          for (Eigen::Index j = i + 1; j < N; ++j) {
            const double d = (points.position.row(i) - points.position.row(j)).norm();
            d_sum += d, inverse_sum += 1.0 / d, log_sum += std::log(d);
          }
        }
        const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.25};
        drawn[0].push_back(static_cast<double>(moment.touching().contacts.size()));
        drawn[1].push_back(d_sum / all);
        drawn[2].push_back(inverse_sum / all);
        drawn[3].push_back(log_sum / all);
        drawn[4].push_back(potential_energy(law, moment.domain, moment.at()) / all);
      }
      const std::array expected{1864.826, 0.661707182267176, 1.88231264438966, -0.501813730207506, -0.0303287040063377};
      const std::array names{"pairs nearer than 0.1", "mean distance [m]", "mean inverse distance [1/m]",
                             "mean logarithm of the distance [-]", "potential energy of a pair over m^2 [J/kg^2]"};
      for (std::size_t k = 0; k < drawn.size(); ++k) {
        const Mean mean = mean_of(drawn[k]);
        rows.compare(names[k], {.expected = expected[k],
                                .computed = mean.value,
                                .tolerance = absolute(4.0 * mean.error),
                                .because = fmt::format("four standard errors, from the scatter of {} clouds: one such "
                                                       "claim in some thousand fails by chance",
                                                       seeds)});
        rows.at_most(fmt::format("standard error over the value: {}", names[k]),
                     {.limit = k == 4 ? 0.1 : 0.01,
                      .computed = mean.error / std::abs(expected[k]),
                      .because = "else the claim says little; the energy is a small difference"});
      }
    }};

// V(d) - V(d_c) by quadrature in 25 digits, at d_c = 1 and w = 0.4.
const Case taper{{.name = "near_field_taper",
                  .claim = "a near field that ends has the potential of its tapered force",
                  .equation = "R 7.3",
                  .reference = Reference::closed_form},
                 [](Rows& rows) {
                   const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.25, .cutoff = 1.0, .taper = 0.4};
                   const auto V = [&](double d) { return potential(law, pair_law(law, 1.0, 1.0), d); };
                   const char* const because = "a quadrature over the taper, to some 1e-13";
                   rows.compare("V(0.5) - V(d_c) [J]", {.expected = -0.0483486289836249,
                                                        .computed = V(0.5) - V(1.0),
                                                        .tolerance = relative(1e-12),
                                                        .because = because});
                   rows.compare("V(0.05) - V(d_c) [J]", {.expected = 3.30035882451935,
                                                         .computed = V(0.05) - V(1.0),
                                                         .tolerance = relative(1e-12),
                                                         .because = because});
                   double slope = 0.0, beyond = 0.0;
                   for (const double d : {0.3, 0.55, 0.599, 0.61, 0.7, 0.8, 0.95, 0.99, 1.0, 1.2}) {
                     const double h = 5e-4, near = (V(d + h) - V(d - h)) / (2.0 * h),
                                  far = (V(d + 2.0 * h) - V(d - 2.0 * h)) / (4.0 * h);
                     Moment pair{
                         kinematics::particles({{.position = Eigen::Vector3d::Zero(), .mass = 1.0, .radius = 0.0},
                                                {.position = {d, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}}),
                         {}};
                     const double force = pair.forces(law)(0, 0);
                     const double u = std::clamp((d - 0.6) / 0.4, 0.0, 1.0), S = 1.0 - u * u * (3.0 - 2.0 * u);
                     const double given = S * (0.5 / d - 0.25 / (d * d));
                     slope = report::worse_of(slope, std::abs((4.0 * near - far) / 3.0 - given));
                     beyond = report::worse_of(beyond, std::abs(force - given));
                   }
                   rows.at_most("V' against S C [N]",
                                {.limit = 2e-7,
                                 .computed = slope,
                                 .because = "differences of order 4 over 5e-4 m, across the ends of the taper of "
                                            "order 2, where the second derivative of S jumps by 37/m^2 at "
                                            "forces of a quarter of a newton"});
                   rows.at_most("force of a pair against S C [N]",
                                {.limit = 1e-15, .computed = beyond, .because = "a few roundings of half a newton"});
                 }};

}  // namespace verification::neighbours
