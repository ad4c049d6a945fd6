// Near-field forces pair by pair and in total.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/momentum.hpp>

namespace verification::near_field {

using namespace particulate;

// Near-field forces and energies against a plain double loop in extended precision.

// Unbounded space once more, as a domain that the library does not know: its general loop over pairs is used.
struct AnotherOpen {};
Eigen::Vector3d separation(const AnotherOpen&, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return to - from;
}

using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 3>;

// Forces, the size of what was added to each of them, and the energy with its size.
struct Expected {
  Extended force;
  Eigen::Matrix<long double, Eigen::Dynamic, 1> size;
  long double energy = 0.0L, energy_size = 0.0L;
};

long double factor(const laws::NearField& law, const kinematics::Particles& of, Eigen::Index i) {
  const long double b = of.radius[i];
  switch (law.scaling) {
    case laws::Scaling::mass:
      return of.mass[i];
    case laws::Scaling::area:
      return 4.0L * std::numbers::pi_v<long double> * b * b;
    default:
      return 1.0L;
  }
}

// The integral of x^-beta from d_ref to d.
long double integral(long double beta, long double d, long double d_ref) {
  if (beta == 1.0L) return std::log(d / d_ref);
  return (std::pow(d, 1.0L - beta) - std::pow(d_ref, 1.0L - beta)) / (1.0L - beta);
}

void add_pair(Expected& sum, const laws::NearField& law, const kinematics::Particles& of, Eigen::Index i,
              Eigen::Index j) {
  const Eigen::Matrix<long double, 1, 3> r_i = of.position.row(i).cast<long double>();
  const Eigen::Matrix<long double, 1, 3> r_j = of.position.row(j).cast<long double>();
  const long double d = (r_j - r_i).norm();
  const long double factors = factor(law, of, i) * factor(law, of, j);
  const long double attraction = law.alpha1 * factors * std::pow(d, -static_cast<long double>(law.beta1));
  const long double repulsion = law.alpha2 * factors * std::pow(d, -static_cast<long double>(law.beta2));
  sum.force.row(i) += (attraction - repulsion) * (r_j - r_i) / d;
  sum.size[i] += attraction + repulsion;
  if (i > j) return;
  const long double gain = law.alpha1 * factors * integral(law.beta1, d, law.d_ref);
  const long double loss = law.alpha2 * factors * integral(law.beta2, d, law.d_ref);
  sum.energy += gain - loss;
  sum.energy_size += std::abs(gain) + std::abs(loss);
}

Expected expected(const laws::NearField& law, const kinematics::Particles& of) {
  Expected sum{.force = Extended::Zero(of.size(), 3),
               .size = Eigen::Matrix<long double, Eigen::Dynamic, 1>::Zero(of.size())};
  for (Eigen::Index i = 0; i < of.size(); ++i) {
    for (Eigen::Index j = 0; j < of.size(); ++j) {
      if (i != j) add_pair(sum, law, of, i, j);
    }
  }
  return sum;
}

// Largest error of a particle's force over the size of what was added to it.
double error_of_forces(const Expected& expected, const Eigen::VectorXd& computed) {
  const Extended difference = rows_of(computed).cast<long double>() - expected.force;
  return static_cast<double>((difference.rowwise().norm().array() / expected.size.array()).maxCoeff());
}

template <class Domain>
void compare_domain(Rows& rows, const std::string& which, const Domain& domain, const laws::NearField& law,
                    const kinematics::Particles& cloud, const Expected& expected, double limit) {
  const scenes::Scene<Domain, laws::NearField> scene(cloud, domain, law);
  const schemes::State start = scenes::start(scene);
  Eigen::VectorXd force(start.r.size()), acceleration(start.r.size());
  if (!scene.total_force(start, force) || !scene.acceleration(0.0, start.r, acceleration)) {
    throw std::runtime_error("the cloud has no forces");
  }
  acceleration.array() *= cloud.mass.replicate(3, 1).array();
  const char* const because = "13 roundings of a power and a few more, then N sums rounded to eps/2 each";
  rows.at_most("forces" + which, {.limit = limit, .computed = error_of_forces(expected, force), .because = because});
  rows.at_most("m times accelerations" + which,
               {.limit = limit, .computed = error_of_forces(expected, acceleration), .because = because});
  const auto claim_energy = [&](const std::string& what, double energy) {
    const double error = static_cast<double>(std::abs(energy - expected.energy) / expected.energy_size);
    rows.at_most(
        what + which,
        {.limit = limit, .computed = error, .because = "as the forces, summed over pairs: fewer eps of their sizes"});
  };
  claim_energy("potential energy", scene.potential_energy(start));
  double energy = 0.0;
  Eigen::VectorXd once_more(force.size());
  if (!scene.total_force(start, once_more, energy)) throw std::runtime_error("the cloud has no forces");
  claim_energy("potential energy, in one pass with the forces", energy);
  rows.compare("numbers of those forces that differ" + which,
               {.expected = 0.0,
                .computed = static_cast<double>((once_more.array() != force.array()).count()),
                .tolerance = absolute(0.0),
                .because = "the same sums in the same order"});
}

void compare(Rows& rows, const laws::NearField& law, Eigen::Index N, const std::string& scaling) {
  const kinematics::Particles cloud = random_cloud({.N = N, .decades = 2.0}, rows.case_seed());
  const Expected by_pairs = expected(law, cloud);
  const double limit = 1.2e-16 * static_cast<double>(N + 30);
  const std::string which = fmt::format(", per {}, beta = ({}, {}), N = {}", scaling, law.beta1, law.beta2, N);
  compare_domain(rows, which, kinematics::Space{}, law, cloud, by_pairs, limit);
  compare_domain(rows, which + ", general loop", AnotherOpen{}, law, cloud, by_pairs, limit);
}

// A law adds to what is there: twice the same forces are twice the forces.
double error_of_adding(const laws::NearField& law, const kinematics::Particles& cloud) {
  laws::Scratch scratch;
  const Eigen::VectorXd inverse_mass = kinematics::inverse_masses(cloud);
  const laws::At<> at{.t = 0.0,
                      .position{cloud.position.data(), cloud.size(), 3},
                      .mass = cloud.mass,
                      .radius = cloud.radius,
                      .inverse_mass = inverse_mass,
                      .scratch = scratch};
  Eigen::VectorXd once = Eigen::VectorXd::Zero(3 * cloud.size());
  Eigen::VectorXd onto = Eigen::VectorXd::Constant(3 * cloud.size(), 1.0);
  const bool had_values = add_force(law, kinematics::Space{}, at, laws::Forces(once.data(), cloud.size(), 3)) &&
                          add_force(law, kinematics::Space{}, at, laws::Forces(onto.data(), cloud.size(), 3));
  if (!had_values) throw std::runtime_error("the cloud has no forces");
  return (onto - once).cwiseAbs().maxCoeff() - 1.0;
}

const Case near_field_pairs{
    {.name = "near_field_pairs",
     .claim = "near-field forces and energies are those of a plain loop over pairs, for each scaling of the strengths",
     .equation = "M 2.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      using laws::Scaling;
      // The library takes a few particles pair by pair, more in vectors of up to 8: full ones, and with 1 or 2 left
      // over, and more than 512 in blocks.
      for (const Eigen::Index N : {2, 3, 128, 129, 257, 514}) {
        compare(rows, {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0}, N, "mass");
      }
      compare(rows, {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0, .d_ref = 0.7}, 40, "mass");
      compare(rows, {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 0.0, .beta2 = 13.0, .scaling = Scaling::pair}, 40, "pair");
      compare(rows, {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = 0.7, .beta2 = 2.6, .d_ref = 2.0, .scaling = Scaling::area},
              40, "area");
      compare(rows, {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = 1.5, .beta2 = 4.5, .scaling = Scaling::pair}, 40, "pair");
      compare(rows, {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = -1.0, .beta2 = 2.0}, 40, "mass");
      compare(rows, {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = -0.7, .beta2 = 12.9, .scaling = Scaling::pair}, 40, "pair");
      const kinematics::Particles cloud = random_cloud({.N = 40}, rows.case_seed());
      rows.at_most("adding to forces of 1 N, error [N]",
                   {.limit = 1e-13,
                    .computed = std::abs(error_of_adding({.alpha1 = 0.5, .alpha2 = 0.25}, cloud)),
                    .because = "forces up to some hundred N rounded to 1e-16 of themselves, 40 sums"});
    }};

const Case near_field_threads{
    {.name = "near_field_threads",
     .claim = "forces and energies are the same to the last bit for any number of threads",
     .equation = "M 2.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      // An odd and an even number of blocks of 512, the last of them a small one.
      for (const Eigen::Index N : {1100, 1540}) {
        for (const auto& [beta1, beta2] : {std::pair{1.0, 2.0}, {0.5, 2.5}}) {
          const auto run = [&, cloud = random_cloud({.N = N}, rows.case_seed())](int threads) {
            const laws::NearField law{
                .alpha1 = 0.5, .alpha2 = 0.25, .beta1 = beta1, .beta2 = beta2, .threads = threads};
            const NearFieldScene scene(cloud, {}, law);
            Eigen::VectorXd found(3 * N + 1);
            if (!scene.total_force(scenes::start(scene), found.head(3 * N), found[3 * N])) {
              throw std::runtime_error("the cloud has no forces");
            }
            return found;
          };
          const Eigen::VectorXd alone = run(1);
          for (const int threads : {2, 3, 8}) {
            rows.compare(
                fmt::format("numbers that differ, {} threads, N = {}, beta = ({}, {})", threads, N, beta1, beta2),
                {.expected = 0.0,
                 .computed = static_cast<double>((run(threads).array() != alone.array()).count()),
                 .tolerance = absolute(0.0),
                 .because = "blocks meet in the same rounds, and energies are summed in their order"});
          }
        }
      }
    }};

// Near fields act in pairs, so their sum and their moment vanish.

struct Totals {
  double force, moment;  // over sum |Psi| and sum |r| |Psi|
};

Totals totals(const kinematics::Particles& cloud, const laws::NearField& law) {
  const NearFieldScene scene(cloud, {}, law);
  Eigen::VectorXd flat(3 * cloud.size());
  if (!scene.total_force(scenes::start(scene), flat)) throw std::runtime_error("the cloud has no forces");
  const kinematics::Vectors force = rows_of(flat);
  const Eigen::VectorXd size = force.rowwise().norm();
  return {.force = force.colwise().sum().norm() / size.sum(),
          .moment = kinematics::moment(cloud.position, force).norm() / cloud.position.rowwise().norm().dot(size)};
}

const Case near_field_totals{
    {.name = "near_field_totals",
     .claim = "total force and total moment of near fields vanish, whatever masses and exponents",
     .equation = "M 2.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      const laws::NearField laws[] = {
          {.alpha1 = 0.5, .alpha2 = 0.25},
          {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
          {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 0.0, .beta2 = 13.0},
          {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = 0.7, .beta2 = 2.6, .scaling = laws::Scaling::area},
          {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = 1.5, .beta2 = 4.5, .scaling = laws::Scaling::pair}};
      for (const Eigen::Index N : {2, 20, 300}) {
        const kinematics::Particles cloud = random_cloud({.N = N, .decades = 6.0}, rows.case_seed());
        const double limit = 1.2e-16 * static_cast<double>(N + 10);
        for (const laws::NearField& law : laws) {
          const Totals seen = totals(cloud, law);
          const std::string which = fmt::format(", N = {}, beta = ({}, {})", N, law.beta1, law.beta2);
          const char* const because =
              "each particle's force is a sum of N - 1 terms, every sum rounded to eps/2; "
              "masses over twelve decades";
          rows.at_most("|sum Psi| / sum |Psi|" + which, {.limit = limit, .computed = seen.force, .because = because});
          rows.at_most("|sum r x Psi| / sum |r||Psi|" + which,
                       {.limit = limit, .computed = seen.moment, .because = because});
        }
      }
    }};

}  // namespace verification::near_field
