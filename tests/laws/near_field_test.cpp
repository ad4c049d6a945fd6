#include <particulate/laws/near_field.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>
#ifdef __x86_64__
#include <cpuid.h>
#endif

#include <particulate/kinematics/momentum.hpp>

#include "close.hpp"

namespace tests::near_field_test {

using namespace particulate::kinematics;
using namespace particulate::laws;

struct Cloud {
  Vectors position;
  Eigen::VectorXd mass, radius;
  Eigen::VectorXd inverse_mass = mass.cwiseInverse();
  mutable particulate::laws::Scratch scratch = {};

  At<> places() const {
    return {.t = 0.0,
            .position = Eigen::Map<const Vectors>(position.data(), position.rows(), 3),
            .mass = mass,
            .radius = radius,
            .inverse_mass = inverse_mass,
            .scratch = scratch};
  }
};

// Numbers in [0, 1) from bits, the same everywhere.
class Uniform {
 public:
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_{20070101};
};

// N particles in a box of unit side, masses and radii of order one.
Cloud cloud_of(Eigen::Index N) {
  Uniform uniform;
  Cloud cloud{Vectors(N, 3), Eigen::VectorXd(N), Eigen::VectorXd(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index c = 0; c < 3; ++c) cloud.position(i, c) = uniform();
    cloud.mass[i] = 0.5 + uniform();
    cloud.radius[i] = 0.2 + 0.3 * uniform();
  }
  cloud.inverse_mass = cloud.mass.cwiseInverse();
  return cloud;
}

// A pair on the x axis with masses 2 and 3 and equal radii of 1/2.
Cloud pair_at(double distance) {
  Vectors position = Vectors::Zero(2, 3);
  position(1, 0) = distance;
  return {position, Eigen::Vector2d(2.0, 3.0), Eigen::Vector2d(0.5, 0.5)};
}

struct Added {
  Vectors force;
  bool has_value;
};

template <class D>
Added forces(const NearField& law, const D& domain, const Cloud& cloud) {
  Vectors force = Vectors::Zero(cloud.position.rows(), 3);
  const bool has_value = add_force(law, domain, cloud.places(), Forces(force.data(), force.rows(), 3));
  return {force, has_value};
}

long double factor(const NearField& law, const Cloud& cloud, Eigen::Index i) {
  switch (law.scaling) {
    case Scaling::mass:
      return cloud.mass[i];
    case Scaling::area:
      return 4.0L * std::numbers::pi_v<long double> * cloud.radius[i] * cloud.radius[i];
    case Scaling::pair:
      break;
  }
  return 1.0L;
}

struct Plain {
  Vectors force;          // the sums
  Eigen::VectorXd terms;  // and those of the sizes of their terms
};

// The formula as it is printed: every ordered pair for itself, in extended precision, with std::pow.
Plain plain_double_loop(const NearField& law, const Cloud& cloud) {
  const Eigen::Index N = cloud.position.rows();
  Plain plain{Vectors(N, 3), Eigen::VectorXd(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    std::array<long double, 3> sum{};
    long double terms = 0.0L;
    for (Eigen::Index j = 0; j < N; ++j) {
      if (j == i) continue;
      std::array<long double, 3> n{};
      long double square = 0.0L;
      for (int c = 0; c < 3; ++c) {
        const auto k = static_cast<std::size_t>(c);
        n[k] = static_cast<long double>(cloud.position(j, c)) - cloud.position(i, c);
        square += n[k] * n[k];
      }
      const long double d = std::sqrt(square), both = factor(law, cloud, i) * factor(law, cloud, j);
      const long double attraction = both * law.alpha1 * std::pow(d, -static_cast<long double>(law.beta1));
      const long double repulsion = both * law.alpha2 * std::pow(d, -static_cast<long double>(law.beta2));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += (attraction - repulsion) * n[k] / d;
      terms += attraction + repulsion;
    }
    for (int c = 0; c < 3; ++c) plain.force(i, c) = static_cast<double>(sum[static_cast<std::size_t>(c)]);
    plain.terms[i] = static_cast<double>(terms);
  }
  return plain;
}

// The reciprocal distance is good to 2.25 eps with every kernel, each factor of a power costs that and half an eps
// more; 6 eps are left for the products, the difference of places and the sum.
double bound(const NearField& law) { return (2.75 * std::max(law.beta1, law.beta2) + 6.0) * eps; }

void agrees_with_the_plain_loop(const NearField& law, const Cloud& cloud, const Added& added) {
  const Plain plain = plain_double_loop(law, cloud);
  BOOST_TEST_CONTEXT("kernel " << name(law.kernel)) { BOOST_TEST(added.has_value); }
  for (Eigen::Index i = 0; i < cloud.position.rows(); ++i) {
    const double error = (added.force.row(i) - plain.force.row(i)).norm();
    BOOST_TEST_CONTEXT("particle " << i << " of " << cloud.position.rows() << ", beta = (" << law.beta1 << ", "
                                   << law.beta2 << "), kernel " << name(law.kernel)) {
      BOOST_TEST(error <= bound(law) * plain.terms[i]);
    }
  }
}

const std::vector<std::array<double, 2>> exponents{{0.0, 1.0},  {1.0, 2.0}, {2.0, 3.0}, {3.0, 2.0},   {0.0, 2.0},
                                                   {7.0, 13.0}, {1.5, 2.5}, {0.5, 1.3}, {64.0, 65.0}, {1.0, 63.5}};

NearField with_exponents(const std::array<double, 2>& beta) {
  return {.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = beta[0], .beta2 = beta[1]};
}

// Those that can be run here: at least the one that every processor runs.
std::vector<Kernel> kernels() {
  std::vector<Kernel> all{Kernel::baseline};
  for (const Kernel more : {Kernel::avx2, Kernel::avx512}) {
    if (is_available(more)) all.push_back(more);
  }
  return all;
}

NearField with_kernel(Kernel kernel, NearField law) {
  law.kernel = kernel;
  return law;
}

// Unbounded space once more, as a type that the kernel does not know, and which counts what it is asked.
struct Asked {
  long* times;
};
Eigen::Vector3d separation(const Asked& domain, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  ++*domain.times;
  return to - from;
}

// A world whose distances are twice ours.
struct Doubled {};
Eigen::Vector3d separation(const Doubled&, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return 2.0 * (to - from);
}

const NearField monograph{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 1.0, .beta2 = 2.0};

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_the_defaults) { BOOST_CHECK_NO_THROW(validate(NearField{})); }

BOOST_AUTO_TEST_CASE(names_the_constant_what_must_hold_and_what_was_given) {
  CHECK_REFUSED(validate(NearField{.alpha1 = -1.0}), "alpha1 must be finite and not negative, got -1");
  CHECK_REFUSED(validate(NearField{.alpha2 = infinity}), "alpha2 must be finite and not negative, got inf");
  CHECK_REFUSED(validate(NearField{.beta1 = not_a_number}), "beta1 must be finite and at least -1, got nan");
  CHECK_REFUSED(validate(NearField{.beta2 = -2.0}), "beta2 must be finite and at least -1, got -2");
  BOOST_CHECK_NO_THROW(validate(NearField{.beta1 = -1.0}));
  for (const int bad : {-1, 0, 1025}) {
    CHECK_REFUSED(validate(NearField{.threads = bad}), "near field: threads must be from 1 to 1024, got");
  }
  for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
    CHECK_REFUSED(validate(NearField{.d_ref = bad}), "d_ref must be positive and finite, got");
  }
  CHECK_REFUSED(validate(NearField{.scaling = static_cast<Scaling>(7)}),
                "scaling must be mass, area or pair, got number 7");
}

BOOST_AUTO_TEST_CASE(refuses_a_kernel_that_is_not_there_and_names_those_that_are) {
  for (const Kernel kernel : {Kernel::best, Kernel::baseline, Kernel::avx2, Kernel::avx512, static_cast<Kernel>(7)}) {
    const NearField law{.kernel = kernel};
    if (is_available(kernel)) {
      BOOST_CHECK_NO_THROW(validate(law));
      continue;
    }
    const std::string given = std::string("), got ").append(name(kernel)).append("; take best");
    CHECK_REFUSED(validate(law), "kernel must be best or one that this build has");
    CHECK_REFUSED(validate(law), "for this processor (baseline");
    CHECK_REFUSED(validate(law), given);
    const Cloud pair = pair_at(1.0);
    CHECK_REFUSED(forces(law, Space{}, pair), given);
    Vectors force = Vectors::Zero(2, 3);
    double energy = 0.0;
    CHECK_REFUSED(add_force_and_energy(law, Space{}, pair.places(), Forces(force.data(), 2, 3), energy), given);
    BOOST_TEST(energy == 0.0);
    CHECK_REFUSED(add_close_force(law, Space{}, pair.places(), Forces(force.data(), 2, 3)), given);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(kernel)

BOOST_AUTO_TEST_CASE(baseline_is_everywhere_and_what_is_none_is_nowhere) {
  BOOST_TEST(is_available(Kernel::best));
  BOOST_TEST(is_available(Kernel::baseline));
  BOOST_TEST(!is_available(static_cast<Kernel>(7)));
}

// Every processor with AVX-512 has AVX2, and kernels() begins with the slowest.
BOOST_AUTO_TEST_CASE(best_is_the_last_of_those_available) { BOOST_TEST((best_kernel() == kernels().back())); }

#if defined(__x86_64__) && defined(__GNUC__)
BOOST_AUTO_TEST_CASE(avx2_and_avx512_are_there_where_the_processor_has_them) {
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  BOOST_TEST(is_available(Kernel::avx2) == avx2);
  BOOST_TEST(is_available(Kernel::avx512) == (avx2 && __builtin_cpu_supports("avx512dq") &&
                                              __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")));
}
#endif

BOOST_AUTO_TEST_CASE(names_are_those_of_the_enumeration) {
  BOOST_TEST(name(Kernel::best) == "best");
  BOOST_TEST(name(Kernel::baseline) == "baseline");
  BOOST_TEST(name(Kernel::avx2) == "avx2");
  BOOST_TEST(name(Kernel::avx512) == "avx512");
  BOOST_TEST(name(static_cast<Kernel>(7)) == "none");
}

// On either side of the number up to which pairs are taken one by one.
BOOST_AUTO_TEST_CASE(gives_the_same_bits_every_time_and_as_best) {
  for (const Eigen::Index N : {5, 130}) {
    const Cloud cloud = cloud_of(N);
    for (const Kernel kernel : kernels()) {
      const NearField law = with_kernel(kernel, with_exponents({2.0, 3.0}));
      const Vectors once = forces(law, Space{}, cloud).force;
      forces(law, Space{}, cloud_of(300));  // leaves something else behind
      BOOST_TEST(close(forces(law, Space{}, cloud).force, once, {}));
      if (kernel != best_kernel()) continue;
      BOOST_TEST(close(forces(with_kernel(Kernel::best, law), Space{}, cloud).force, once, {}));
    }
  }
}

// Each adds in another order, so some of 390 components are rounded otherwise; ten particles are taken pair by pair.
BOOST_AUTO_TEST_CASE(is_the_one_that_is_asked_for_but_for_a_handful_of_particles) {
  const Cloud many = cloud_of(130), few = cloud_of(10);
  const NearField law = with_exponents({2.0, 3.0});
  for (const Kernel one : kernels()) {
    for (const Kernel other : kernels()) {
      const NearField by_one = with_kernel(one, law), by_other = with_kernel(other, law);
      BOOST_TEST((forces(by_one, Space{}, many).force == forces(by_other, Space{}, many).force) == (one == other));
      BOOST_TEST((forces(by_one, Space{}, few).force == forces(by_other, Space{}, few).force));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(pair_law_)

BOOST_AUTO_TEST_CASE(multiplies_both_strengths_by_both_scaling_factors) {
  const CentralForce law = pair_law({.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 3.0, .beta2 = 5.0}, 2.0, 8.0);
  BOOST_TEST(law.alpha1 == 8.0);
  BOOST_TEST(law.alpha2 == 4.0);
  BOOST_TEST(law.beta1 == 3.0);
  BOOST_TEST(law.beta2 == 5.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(scaling_factors_)

// 4 pi (1/2)^2 = pi.
BOOST_AUTO_TEST_CASE(are_masses_surfaces_or_one) {
  const Cloud pair = pair_at(1.0);
  BOOST_TEST(close(scaling_factors({.scaling = Scaling::mass}, pair.places()), Eigen::Vector2d(2.0, 3.0), {}));
  BOOST_TEST(
      close(scaling_factors({.scaling = Scaling::area}, pair.places()), Eigen::Vector2d(pi, pi), {.relative = eps}));
  BOOST_TEST(close(scaling_factors({.scaling = Scaling::pair}, pair.places()), Eigen::Vector2d(1.0, 1.0), {}));
}

BOOST_AUTO_TEST_CASE(refuse_a_scaling_that_is_none) {
  CHECK_REFUSED(scaling_factors({.scaling = static_cast<Scaling>(7)}, pair_at(1.0).places()),
                "scaling must be mass, area or pair");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(is_full_)

BOOST_AUTO_TEST_CASE(holds_for_normal_finite_numbers_only) {
  BOOST_TEST(is_full(1.0));
  BOOST_TEST(is_full(1e-307));
  BOOST_TEST(is_full(1e308));
  for (const double bad : {0.0, 1e-308, infinity, not_a_number}) BOOST_TEST(!is_full(bad));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(add_force_)

// C(2) = 1/2 - 0.5/4 = 3/8, times 2 3 for masses, pi^2 for surfaces, 1 for pairs; towards each other.
BOOST_AUTO_TEST_CASE(pulls_a_pair_as_multiplied_out_by_hand) {
  const Eigen::RowVector3d along(0.375, 0.0, 0.0);
  const auto pulls = [&](Scaling scaling, double factor) {
    NearField law = monograph;
    law.scaling = scaling;
    Vectors expected(2, 3);
    expected << factor * along, -factor * along;
    const Added added = forces(law, Space{}, pair_at(2.0));
    BOOST_TEST(added.has_value);
    BOOST_TEST(close(added.force, expected, {.relative = 4.0 * eps}));
  };
  pulls(Scaling::mass, 6.0);
  pulls(Scaling::area, pi * pi);
  pulls(Scaling::pair, 1.0);
}

BOOST_AUTO_TEST_CASE(adds_to_what_the_forces_hold) {
  const Cloud pair = pair_at(2.0);
  Vectors force{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  BOOST_TEST(add_force(monograph, Space{}, pair.places(), Forces(force.data(), 2, 3)));
  BOOST_TEST(close(force, Vectors{{3.25, 2.0, 3.0}, {1.75, 5.0, 6.0}}, {}));
  BOOST_TEST(add_force(monograph, Doubled{}, pair_at(1.0).places(), Forces(force.data(), 2, 3)));
  BOOST_TEST(close(force, Vectors{{5.5, 2.0, 3.0}, {-0.5, 5.0, 6.0}}, {}));
}

// Up to 10 particles are taken pair by pair; beyond, registers hold 2, 4 or 8 partners and the last may be partly
// empty.
BOOST_AUTO_TEST_CASE(agrees_with_the_plain_double_loop_for_any_number_of_particles) {
  for (const Eigen::Index N :
       {0, 1, 2, 3, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 64, 100, 129}) {
    const Cloud cloud = cloud_of(N);
    for (const Kernel kernel : kernels()) {
      for (const auto& beta : exponents) {
        const NearField law = with_kernel(kernel, with_exponents(beta));
        agrees_with_the_plain_loop(law, cloud, forces(law, Space{}, cloud));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(agrees_with_the_plain_double_loop_for_all_scalings) {
  for (const Eigen::Index N : {6, 40}) {
    for (const Kernel kernel : kernels()) {
      for (const Scaling scaling : {Scaling::mass, Scaling::area, Scaling::pair}) {
        NearField law = with_kernel(kernel, with_exponents({2.0, 3.0}));
        law.scaling = scaling;
        agrees_with_the_plain_loop(law, cloud_of(N), forces(law, Space{}, cloud_of(N)));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(asks_any_other_domain_once_a_pair) {
  for (const Eigen::Index N : {2, 17, 129}) {
    const Cloud cloud = cloud_of(N);
    for (const auto& beta : exponents) {
      NearField law = with_exponents(beta);
      law.scaling = Scaling::area;
      long times = 0;
      agrees_with_the_plain_loop(law, cloud, forces(law, Asked{&times}, cloud));
      BOOST_TEST(times == N * (N - 1) / 2);
    }
  }
}

BOOST_AUTO_TEST_CASE(is_nothing_for_one_particle_and_for_none) {
  long times = 0;
  for (const Eigen::Index N : {0, 1}) {
    const Added open = forces(monograph, Space{}, cloud_of(N)), other = forces(monograph, Asked{&times}, cloud_of(N));
    BOOST_TEST(open.has_value);
    BOOST_TEST(other.has_value);
    BOOST_TEST(close(open.force, Vectors::Zero(N, 3), {}));
    BOOST_TEST(close(other.force, Vectors::Zero(N, 3), {}));
  }
  BOOST_TEST(times == 0);
}

BOOST_AUTO_TEST_CASE(leaves_no_total_force_and_no_total_moment) {
  for (const Eigen::Index N : {2, 9, 13, 200}) {
    const Cloud cloud = cloud_of(N);
    for (const auto& beta : exponents) {
      const double terms = plain_double_loop(with_exponents(beta), cloud).terms.sum();
      for (const Kernel kernel : kernels()) {
        const Added added = forces(with_kernel(kernel, with_exponents(beta)), Space{}, cloud);
        const double sizes = added.force.rowwise().norm().sum();
        const double arms = added.force.rowwise().norm().dot(cloud.position.rowwise().norm());
        BOOST_TEST_CONTEXT("N = " << N << ", beta = (" << beta[0] << ", " << beta[1] << "), kernel " << name(kernel)) {
          BOOST_TEST(sizes > 0.0);
          BOOST_TEST(arms > 0.0);
          BOOST_TEST(added.force.colwise().sum().norm() <= 4.0 * eps * terms);
          BOOST_TEST(moment(cloud.position, added.force).norm() <= 4.0 * eps * terms);
        }
      }
    }
  }
}

// Central differences of order 2 with h = 1e-5: h^2/6 of the third derivative, rounding eps V/h.
BOOST_AUTO_TEST_CASE(is_minus_the_gradient_of_the_potential_energy) {
  const double h = 1e-5;
  const Cloud cloud{Vectors{{0.0, 0.0, 0.0}, {1.1, 0.2, 0.0}, {-0.3, 0.9, 0.4}, {0.5, -0.2, -1.2}},
                    Eigen::Vector4d(1.0, 2.0, 0.5, 1.5), Eigen::Vector4d(0.1, 0.2, 0.3, 0.4)};
  for (const auto& beta : exponents) {
    if (beta[1] > 13.0) continue;  // too steep for differences
    const NearField law = with_exponents(beta);
    const Added added = forces(law, Space{}, cloud);
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        Cloud ahead = cloud, behind = cloud;
        ahead.position(i, c) += h;
        behind.position(i, c) -= h;
        const double uphill =
            (potential_energy(law, Space{}, ahead.places()) - potential_energy(law, Space{}, behind.places())) /
            (2.0 * h);
        BOOST_TEST(std::abs(added.force(i, c) + uphill) < 1e-7);
      }
    }
  }
}

// Wherever the two stand: in one register or two, in the first or the last, which may be partly empty.
BOOST_AUTO_TEST_CASE(has_no_value_where_two_particles_coincide) {
  long times = 0;
  for (const Eigen::Index N : {2, 3, 10, 21, 29}) {
    const Cloud apart = cloud_of(N);
    for (Eigen::Index i = 0; i < N; ++i) {
      for (Eigen::Index j = i + 1; j < N; ++j) {
        Cloud cloud = apart;
        cloud.position.row(j) = cloud.position.row(i);
        for (const Kernel kernel : kernels()) {
          BOOST_TEST_CONTEXT("particles " << i << " and " << j << " of " << N << ", kernel " << name(kernel)) {
            BOOST_TEST(!forces(with_kernel(kernel, monograph), Space{}, cloud).has_value);
          }
        }
        BOOST_TEST(!forces(monograph, Asked{&times}, cloud).has_value);
      }
    }
  }
}

// Two that are immovable, or that have no surface to count strengths per: the others feel what they would without.
BOOST_AUTO_TEST_CASE(does_not_mind_coincident_particles_that_feel_nothing_of_each_other) {
  long times = 0;
  NearField by_area = monograph;
  by_area.scaling = Scaling::area;
  for (const Eigen::Index N : {3, 10, 11, 29}) {
    Cloud fixed = cloud_of(N), points = cloud_of(N);
    fixed.position.row(2) = fixed.position.row(1), points.position.row(2) = points.position.row(1);
    fixed.inverse_mass[1] = fixed.inverse_mass[2] = 0.0;
    points.radius[1] = points.radius[2] = 0.0;
    Cloud once = fixed;  // one of twice the mass in their place, the other too far to be felt
    once.mass[1] *= 2.0, once.mass[2] = 0.0, once.position(2, 0) = 1e9;
    fixed.mass[2] = fixed.mass[1];
    for (const Kernel kernel : kernels()) {
      Vectors force = Vectors::Ones(N, 3);
      BOOST_TEST(add_force(with_kernel(kernel, monograph), Space{}, fixed.places(), Forces(force.data(), N, 3)));
      const Vectors one = forces(with_kernel(kernel, monograph), Space{}, once).force;
      BOOST_TEST(close(force.row(0), one.row(0).array() + 1.0, {.relative = 1e-12}));
      BOOST_TEST(forces(with_kernel(kernel, by_area), Space{}, points).has_value);
    }
    BOOST_TEST(forces(monograph, Asked{&times}, fixed).has_value);
    BOOST_TEST(std::isfinite(potential_energy(monograph, Space{}, fixed.places())));
    BOOST_TEST(why_no_force(monograph, Space{}, fixed.places()).empty());
    fixed.inverse_mass[2] = 1.0;
    BOOST_TEST(!forces(monograph, Space{}, fixed).has_value);
    BOOST_TEST(contains(why_no_force(monograph, Space{}, fixed.places()),
                        "particles 1 and 2 must be some 1.5e-154 to 1.3e154 m apart, but are 0 m apart"));
  }
  BOOST_TEST(forces(NearField{}, Space{}, pair_at(0.0)).has_value);
}

// What fills the last register stands nowhere: a particle at the origin meets nothing there, and neither do particles
// whose distance from the origin has no square.
BOOST_AUTO_TEST_CASE(has_a_value_where_only_the_origin_is_too_near_or_too_far) {
  for (const Eigen::Index N : {9, 11, 13, 20, 23}) {
    for (const double shift : {0.0, 1e160}) {
      Cloud cloud = cloud_of(N);
      cloud.position *= shift == 0.0 ? 1.0 : 1e148;
      cloud.position.col(0).array() += shift;
      cloud.position.row(N / 2) << shift, 0.0, 0.0;
      for (const Kernel kernel : kernels()) {
        const NearField constant{
            .alpha1 = 1.0, .alpha2 = 0.25, .beta1 = 0.0, .beta2 = 0.0, .scaling = Scaling::pair, .kernel = kernel};
        agrees_with_the_plain_loop(constant, cloud, forces(constant, Space{}, cloud));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(has_no_value_where_a_place_is_none_or_a_force_is_too_large) {
  const NearField steep{.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 7.0, .beta2 = 13.0};
  for (const Eigen::Index N : {2, 20, 23}) {
    for (Eigen::Index i = 0; i < N; ++i) {
      Cloud nowhere = cloud_of(N), near = cloud_of(N);
      nowhere.position(i, 1) = not_a_number;
      const Eigen::Index j = i == 0 ? N - 1 : 0;
      near.position.row(i).setZero();
      near.position.row(j) << 1e-50, 0.0, 0.0;
      for (const Kernel kernel : kernels()) {
        BOOST_TEST(!forces(with_kernel(kernel, monograph), Space{}, nowhere).has_value);
        BOOST_TEST(!forces(with_kernel(kernel, steep), Space{}, near).has_value);
      }
      BOOST_TEST(!forces(monograph, Doubled{}, nowhere).has_value);
      BOOST_TEST(!forces(steep, Doubled{}, near).has_value);
    }
  }
}

// Squares of 1e-100 and 1e100 are held to full precision, those of 1e-158 and 1e160 are not. Two particles, and a row
// of twelve that is long enough for vector registers, where a force is 0.75 times the particles on one side less those
// on the other.
BOOST_AUTO_TEST_CASE(is_exact_at_extreme_distances_or_has_no_value) {
  for (const Kernel kernel : kernels()) {
    const NearField constant{
        .alpha1 = 1.0, .alpha2 = 0.25, .beta1 = 0.0, .beta2 = 0.0, .scaling = Scaling::pair, .kernel = kernel};
    Cloud row = cloud_of(12);
    const auto row_at = [&](double d) -> const Cloud& {
      row.position.setZero();
      row.position.col(0) = d * Eigen::VectorXd::LinSpaced(12, 0.0, 11.0);
      return row;
    };
    for (const double d : {1e-150, 1e-100, 1e100, 1e150}) {
      BOOST_TEST(forces(constant, Space{}, pair_at(d)).force(0, 0) == 0.75, tolerance(4.0 * eps));
      BOOST_TEST(forces(constant, Doubled{}, pair_at(d)).force(0, 0) == 0.75, tolerance(4.0 * eps));
      const Added added = forces(constant, Space{}, row_at(d));
      BOOST_TEST(added.has_value);
      for (Eigen::Index i = 0; i < 12; ++i) {
        BOOST_TEST(std::abs(added.force(i, 0) - 0.75 * static_cast<double>(11 - 2 * i)) <= 40.0 * eps);
      }
    }
    for (const double d : {1e-300, 1e-158, 1e160, 1e300}) {
      BOOST_TEST(!forces(constant, Space{}, pair_at(d)).has_value);
      BOOST_TEST(!forces(constant, Doubled{}, pair_at(d)).has_value);
      BOOST_TEST(!forces(constant, Space{}, row_at(d)).has_value);
    }
  }
}

BOOST_AUTO_TEST_CASE(keeps_its_bits_under_powers_of_two) {
  for (const Eigen::Index N : {6, 140}) {
    const Cloud cloud = cloud_of(N);
    Cloud big = cloud;
    big.position *= 8.0;
    for (const Kernel kernel : kernels()) {
      const NearField law = with_kernel(kernel, with_exponents({2.0, 3.0}));
      NearField scaled = law;
      scaled.alpha1 *= 64.0;
      scaled.alpha2 *= 512.0;
      BOOST_TEST(close(forces(scaled, Space{}, big).force, forces(law, Space{}, cloud).force, {}));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(potential_energy_)

// 6 (ln 2 - 0.5 (1 - 1/2)).
BOOST_AUTO_TEST_CASE(of_a_pair_is_as_integrated_by_hand) {
  BOOST_TEST(potential_energy(monograph, Space{}, pair_at(2.0).places()) == 6.0 * (std::numbers::ln2 - 0.25),
             tolerance(8.0 * eps));
}

BOOST_AUTO_TEST_CASE(vanishes_at_the_reference_distance) {
  NearField law = monograph;
  law.d_ref = 0.7;
  BOOST_TEST(potential_energy(law, Space{}, pair_at(0.7).places()) == 0.0);
  BOOST_TEST(potential_energy(law, Doubled{}, pair_at(0.35).places()) == 0.0);
}

// Three on a line at 0, 1, 3, per pair: distances 1, 2 and 3 with V(d) = ln d - 0.5 (1 - 1/d).
BOOST_AUTO_TEST_CASE(sums_over_all_pairs_once) {
  NearField law = monograph;
  law.scaling = Scaling::pair;
  const Cloud line{Vectors{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 3.0, 0.0}}, Eigen::Vector3d(1.0, 2.0, 3.0),
                   Eigen::Vector3d::Zero()};
  BOOST_TEST(potential_energy(law, Space{}, line.places()) == std::log(6.0) - 0.25 - 1.0 / 3.0, tolerance(8.0 * eps));
}

BOOST_AUTO_TEST_CASE(is_nothing_for_one_particle_and_for_none) {
  BOOST_TEST(potential_energy(monograph, Space{}, cloud_of(0).places()) == 0.0);
  BOOST_TEST(potential_energy(monograph, Space{}, cloud_of(1).places()) == 0.0);
}

BOOST_AUTO_TEST_CASE(is_no_finite_number_where_particles_coincide) {
  BOOST_TEST(!std::isfinite(potential_energy(monograph, Space{}, pair_at(0.0).places())));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(real_exponents)

// Of twelve particles only the first and one other have mass: the force of that pair alone, as vectors form it.
BOOST_AUTO_TEST_CASE(err_by_less_than_1e_14_of_attraction_and_repulsion_at_any_distance) {
  Uniform uniform;
  std::vector<double> betas{-1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.5, 7.0, 13.0, 2.0, 3.0};
  for (int k = 0; k < 6; ++k) betas.push_back(14.0 * uniform() - 1.0);
  Cloud cloud = cloud_of(12);
  cloud.mass.setZero();
  cloud.mass[0] = cloud.mass[7] = 1.0;
  int compared = 0;
  double worst = 0.0;
  for (const Kernel kernel : kernels()) {
    for (std::size_t k = 0; k < betas.size(); ++k) {
      const NearField law = with_kernel(kernel, with_exponents({betas[k], betas[(k + 4) % betas.size()]}));
      for (int decade = -150; decade <= 150; decade += std::abs(decade) < 12 ? 1 : 6) {
        const double d = std::pow(10.0, decade + uniform());
        cloud.position.setZero();
        for (Eigen::Index i = 0; i < 12; ++i) cloud.position(i, 1) = d * (1.0 + static_cast<double>(i));
        cloud.position.row(0).setZero(), cloud.position.row(7) << d, 0.0, 0.0;
        const auto term = [&](double alpha, double beta) {
          return static_cast<long double>(alpha) *
                 std::pow(static_cast<long double>(d), -static_cast<long double>(beta));
        };
        const long double attraction = term(law.alpha1, law.beta1), repulsion = term(law.alpha2, law.beta2);
        const Added added = forces(law, Space{}, cloud);
        BOOST_TEST_CONTEXT("beta = (" << law.beta1 << ", " << law.beta2 << "), d = " << d << ", kernel "
                                      << name(kernel)) {
          if (attraction + repulsion > 1e308L) {
            BOOST_TEST(!added.has_value);
          } else if (attraction + repulsion > 1e-290L && attraction + repulsion < 1e300L) {
            BOOST_TEST(added.has_value);
            const double error =
                static_cast<double>(std::abs(added.force(0, 0) - (attraction - repulsion)) / (attraction + repulsion));
            worst = std::max(worst, error), ++compared;
            BOOST_TEST(error < 1e-14);
            BOOST_TEST(added.force(7, 0) == -added.force(0, 0));
          }
        }
      }
    }
  }
  BOOST_TEST(compared > 500);
  BOOST_TEST_MESSAGE("largest error " << worst << " of " << compared);
}

BOOST_AUTO_TEST_CASE(agree_with_the_plain_double_loop_for_any_number_of_particles) {
  for (const Eigen::Index N : {11, 13, 64, 521}) {
    const Cloud cloud = cloud_of(N);
    for (const Kernel kernel : kernels()) {
      for (const auto& [beta1, beta2] : {std::pair{-1.0, 2.0}, {1.0, 2.5}, {0.37, 12.9}, {1.0, 2.0}, {4.0, 6.0}}) {
        const NearField law = with_kernel(kernel, with_exponents({beta1, beta2}));
        agrees_with_the_plain_loop(law, cloud, forces(law, Space{}, cloud));
      }
    }
  }
}

// d^-2 is 1e-300 at 1e150 m, and 1e-450, nothing, over that distance.
BOOST_AUTO_TEST_CASE(and_whole_ones_lose_nothing_to_a_division_by_the_distance) {
  for (const Kernel kernel : kernels()) {
    for (const Eigen::Index N : {2, 12}) {
      Cloud cloud = cloud_of(N);
      for (const auto& [beta, d] : {std::pair{2.0, 1e150}, {1.9, 1e150}, {1.5, 1e-150}, {2.0, 1e-150}}) {
        cloud.position.setZero();
        for (Eigen::Index i = 0; i < N; ++i) cloud.position(i, 0) = d * static_cast<double>(i);
        const NearField law{.alpha1 = 1.0, .beta1 = beta, .beta2 = beta, .scaling = Scaling::pair, .kernel = kernel};
        const Added added = forces(law, Space{}, cloud);
        double expected = 0.0;
        for (Eigen::Index i = 1; i < N; ++i) expected += std::pow(d * static_cast<double>(i), -beta);
        BOOST_TEST(added.has_value);
        BOOST_TEST(added.force(0, 0) == expected, tolerance(1e-12));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

#ifdef __x86_64__
// Upper halves of vector registers that hold something slow down all that follows and does not know of them. Where a
// processor tells: bit 2 of what it would have to save.
BOOST_AUTO_TEST_CASE(kernels_leave_nothing_in_the_upper_halves_of_registers) {
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (!__get_cpuid_count(0xd, 1, &a, &b, &c, &d) || (a & 4U) == 0) return;
  const Cloud cloud = cloud_of(30);
  for (const Kernel kernel : kernels()) {
    for (const double cutoff : {infinity, 0.5}) {
      for (const auto& [beta1, beta2] : {std::pair{1.0, 2.0}, {2.0, 3.0}, {7.0, 13.0}, {0.5, 2.5}}) {
        NearField law = with_kernel(kernel, with_exponents({beta1, beta2}));
        law.cutoff = cutoff;
        Vectors force = Vectors::Zero(30, 3);
        double energy = 0.0;
        unsigned in_use = 0;
        add_force(law, Space{}, cloud.places(), Forces(force.data(), 30, 3));
        asm volatile("xgetbv" : "=a"(in_use), "=d"(d) : "c"(1));
        BOOST_TEST((in_use & 4U) == 0U);
        add_force_and_energy(law, Space{}, cloud.places(), Forces(force.data(), 30, 3), energy);
        asm volatile("xgetbv" : "=a"(in_use), "=d"(d) : "c"(1));
        BOOST_TEST((in_use & 4U) == 0U);
      }
    }
  }
}
#endif

BOOST_AUTO_TEST_SUITE(threads)

Added by_threads(int threads, NearField law, const Space& space, const Cloud& cloud) {
  law.threads = threads;
  return forces(law, space, cloud);
}

// One block, two of which the second is small, and an odd and an even number of them.
BOOST_AUTO_TEST_CASE(give_the_same_bits_whatever_their_number) {
  for (const Kernel kernel : kernels()) {
    for (const Eigen::Index N : {20, 514, 1300, 2000}) {
      const Cloud cloud = cloud_of(N);
      for (const auto& [beta1, beta2] : {std::pair{2.0, 3.0}, {0.7, 2.5}}) {
        NearField law = with_kernel(kernel, with_exponents({beta1, beta2}));
        const Added alone = by_threads(1, law, {}, cloud);
        const double energy = potential_energy(law, Space{}, cloud.places());
        for (const int many : {2, 3, 5}) {
          BOOST_TEST((by_threads(many, law, {}, cloud).force == alone.force));
          law.threads = many;
          BOOST_TEST(potential_energy(law, Space{}, cloud.places()) == energy);
        }
      }
    }
  }
}

// Pair by pair: in three and in four blocks each meets every other once.
BOOST_AUTO_TEST_CASE(add_every_pair_once) {
  for (const Eigen::Index N : {1300, 1600}) {
    const Cloud cloud = cloud_of(N);
    long times = 0;
    const NearField law = with_exponents({1.0, 2.0});
    const Vectors expected = forces(law, Asked{&times}, cloud).force;
    BOOST_TEST(close(by_threads(2, law, {}, cloud).force, expected, {1e-9, 1e-12 * expected.cwiseAbs().maxCoeff()}));
  }
}

BOOST_AUTO_TEST_CASE(refuse_what_one_refuses) {
  const NearField law = with_exponents({0.7, 2.5});
  Cloud cloud = cloud_of(1100);
  cloud.position.row(1090) = cloud.position.row(3);
  BOOST_TEST(!by_threads(2, law, {}, cloud).has_value);
  cloud.inverse_mass[3] = cloud.inverse_mass[1090] = 0.0;
  const Added shared = by_threads(2, law, {}, cloud);
  BOOST_TEST(shared.has_value);
  BOOST_TEST((shared.force == by_threads(1, law, {}, cloud).force));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(add_force_and_energy_)

// Integrals of the two powers in extended precision: their sum, and that of the sizes of their terms.
std::array<double, 2> plain_energy(const NearField& law, const Cloud& cloud) {
  long double sum = 0.0L, sizes = 0.0L;
  const auto integral = [&](long double beta, long double d) {
    const long double e = 1.0L - beta, log = std::log(d / law.d_ref);
    return e == 0.0L ? log : std::pow(static_cast<long double>(law.d_ref), e) * std::expm1(e * log) / e;
  };
  for (Eigen::Index i = 0; i < cloud.position.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < cloud.position.rows(); ++j) {
      long double square = 0.0L;
      for (Eigen::Index c = 0; c < 3; ++c) {
        const long double apart = static_cast<long double>(cloud.position(i, c)) - cloud.position(j, c);
        square += apart * apart;
      }
      const long double d = std::sqrt(square), both = factor(law, cloud, i) * factor(law, cloud, j);
      const long double pull = both * law.alpha1 * integral(law.beta1, d);
      const long double push = both * law.alpha2 * integral(law.beta2, d);
      sum += pull - push, sizes += std::abs(pull) + std::abs(push);
    }
  }
  return {static_cast<double>(sum), static_cast<double>(sizes)};
}

BOOST_AUTO_TEST_CASE(adds_what_the_two_add_one_by_one) {
  for (const Kernel kernel : kernels()) {
    for (const Eigen::Index N : {2, 11, 29, 521}) {
      const Cloud cloud = cloud_of(N);
      for (const auto& [beta1, beta2] :
           {std::pair{1.0, 2.0}, {2.0, 3.0}, {7.0, 13.0}, {-1.0, 2.0}, {1.0 + 1e-9, 0.999}, {0.37, 2.5}, {0.0, 1.0}}) {
        NearField law = with_kernel(kernel, with_exponents({beta1, beta2}));
        law.d_ref = 0.7;
        Vectors force = Vectors::Zero(N, 3);
        double energy = 2.0;
        BOOST_TEST(add_force_and_energy(law, Space{}, cloud.places(), Forces(force.data(), N, 3), energy));
        BOOST_TEST((force == forces(law, Space{}, cloud).force));
        const auto [expected, sizes] = plain_energy(law, cloud);
        // What a pair may err by, and half a rounding of the sum a term: one close pair makes it so large that others
        // are lost in it.
        const double pairs = 0.5 * static_cast<double>(N * (N - 1)), allowed = (1e-14 + 0.5 * eps * pairs) * sizes;
        BOOST_TEST_CONTEXT("N = " << N << ", beta = (" << beta1 << ", " << beta2 << "), kernel " << name(kernel)) {
          BOOST_TEST(std::abs(energy - 2.0 - expected) <= allowed + 2.0 * eps);
          BOOST_TEST(std::abs(potential_energy(law, Space{}, cloud.places()) - expected) <= allowed);
          long times = 0;
          double asked = 0.0;
          BOOST_TEST(add_force_and_energy(law, Asked{&times}, cloud.places(), Forces(force.data(), N, 3), asked));
          BOOST_TEST(std::abs(asked - expected) <= allowed);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(has_no_value_where_one_of_them_has_none) {
  for (const Kernel kernel : kernels()) {
    for (const Eigen::Index N : {12, 300}) {
      const NearField law = with_kernel(kernel, with_exponents({0.5, 2.5}));
      Cloud same = cloud_of(N), nowhere = same, apart = same;
      same.position.row(5) = same.position.row(2);
      nowhere.position(3, 2) = not_a_number;
      apart.position.row(4) << 1e160, 0.0, 0.0;
      Vectors force = Vectors::Zero(N, 3);
      double energy = 0.0;
      for (const Cloud* cloud : {&same, &nowhere, &apart}) {
        BOOST_TEST(!add_force_and_energy(law, Space{}, cloud->places(), Forces(force.data(), N, 3), energy));
      }
      BOOST_TEST(!std::isfinite(potential_energy(law, Space{}, same.places())));
      BOOST_TEST(!std::isfinite(potential_energy(law, Space{}, nowhere.places())));
    }
  }
}

// Powers and reference distances that come near the ends of what a double holds are taken pair by pair.
BOOST_AUTO_TEST_CASE(holds_at_extreme_distances) {
  for (const double d : {1e-100, 1e100}) {
    Cloud cloud = cloud_of(20);
    cloud.position *= d;
    NearField law = with_exponents({0.5, 1.5});
    law.d_ref = d;
    const auto [expected, sizes] = plain_energy(law, cloud);
    BOOST_TEST(std::abs(potential_energy(law, Space{}, cloud.places()) - expected) <= 1e-13 * sizes);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(cutoff)

// Chapter 7's: alpha = (0.5, 0.25), beta = (1, 2), tapered from 0.6 to 1.
const NearField tapered{
    .alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0, .scaling = Scaling::pair, .cutoff = 1.0, .taper = 0.4};

NearField ending(double cutoff, double taper, double beta1 = 1.0, double beta2 = 2.0) {
  return {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = beta1, .beta2 = beta2, .cutoff = cutoff, .taper = taper};
}

// Space, with its type unknown to the near field: all pairs, by hand.
struct Hidden {
  Space space;
};
Eigen::Vector3d separation(const Hidden& hidden, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return separation(hidden.space, from, to);
}

BOOST_AUTO_TEST_CASE(must_be_positive_and_the_taper_within_it) {
  BOOST_CHECK_NO_THROW(validate(ending(1.0, 0.0)));
  BOOST_CHECK_NO_THROW(validate(NearField{.alpha1 = 0.5, .cutoff = 1.0, .taper = 1.0}));
  CHECK_REFUSED(validate(ending(0.0, 0.0)), "near field: cutoff must be positive, got 0 m; leave it out");
  CHECK_REFUSED(validate(ending(not_a_number, 0.0)), "near field: cutoff must be positive, got nan m");
  for (const double bad : {-0.1, 1.1, not_a_number}) {
    CHECK_REFUSED(validate(ending(1.0, bad)), "near field: taper must lie between 0 and the cutoff");
  }
  CHECK_REFUSED(validate(ending(infinity, 0.1)), "needs a finite one, got 0.1 m with cutoff inf m");
  // d_e = 0.5 m, d* = 1 m. At d* and beyond is allowed, and so is any cut-off without attraction or equilibrium.
  CHECK_REFUSED(validate(ending(0.5, 0.0)),
                "cutoff - taper > d_e, or nothing attracts; got cutoff d_c = 0.5 m and taper w = 0 m");
  CHECK_REFUSED(validate(ending(0.9, 0.4)), "equilibrium distance d_e = 0.5 m");
  CHECK_REFUSED(validate(ending(0.9, 0.4)), "up to the inflection d* = 1 m");
  for (const Scaling other : {Scaling::pair, Scaling::area}) {
    NearField law = ending(0.9, 0.4);
    law.scaling = other;
    CHECK_REFUSED(validate(law), "equilibrium distance d_e = 0.5 m");
  }
  validate(ending(0.9, 0.39));
  validate(ending(2.0, 0.5));
  validate(NearField{.alpha2 = 0.25, .cutoff = 0.01});
  validate(NearField{.alpha1 = 0.5, .cutoff = 0.01});
}

BOOST_AUTO_TEST_CASE(must_be_within_half_the_shortest_period) {
  const Space box{.lengths = {2.0, infinity, 1.0}};
  BOOST_CHECK_NO_THROW(validate(ending(0.5, 0.0), box));
  BOOST_CHECK_NO_THROW(validate(NearField{}, Space{}));
  CHECK_REFUSED(validate(ending(0.51, 0.0), box),
                "half the shortest period, 0.5 m, as each pair meets in its nearest "
                "image alone; it reaches 0.51 m: set cutoff");
  CHECK_REFUSED(validate(NearField{}, box), "it reaches inf m");
}

// u = 1/4 at 0.7: 1 - (3 - 1/2)/16; 1/2 in the middle.
BOOST_AUTO_TEST_CASE(tapers_from_one_to_zero) {
  BOOST_TEST(tapering(tapered, 0.6) == 1.0);
  BOOST_TEST(tapering(tapered, 0.7) == 0.84375, tolerance(1e-14));
  BOOST_TEST(tapering(tapered, 0.8) == 0.5, tolerance(1e-14));
  BOOST_TEST(tapering(tapered, 1.0) == 0.0);
  BOOST_TEST(tapering(ending(1.0, 0.0), 0.999) == 1.0);
  BOOST_TEST(tapering(ending(1.0, 0.0), 1.0) == 0.0);
  BOOST_TEST(tapering(NearField{}, 1e300) == 1.0);
  BOOST_TEST(reach(tapered) == 1.0);
  BOOST_TEST(std::isinf(reach(NearField{})));
}

// By quadrature in many digits.
BOOST_AUTO_TEST_CASE(has_the_potential_of_the_tapered_force) {
  const CentralForce pair = pair_law(tapered, 1.0, 1.0);
  BOOST_TEST(potential(tapered, pair, 0.5) == -0.0483486289836249, tolerance(1e-13));
  BOOST_TEST(potential(tapered, pair, 0.05) == 3.30035882451935, tolerance(1e-13));
  BOOST_TEST(potential(tapered, pair, 1.0) == 0.0);
  BOOST_TEST(potential(tapered, pair, 7.0) == 0.0);
  // Cut off at once: alpha1 ln d + alpha2 (1/d - 1).
  BOOST_TEST(potential(ending(1.0, 0.0), pair, 0.5) == 0.5 * std::log(0.5) + 0.25, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(has_a_potential_whose_slope_is_the_force) {
  for (const auto& [beta1, beta2] : {std::pair{1.0, 2.0}, {7.0, 13.0}, {0.3, 1.7}}) {
    for (const double taper : {0.4, 1.0}) {
      const NearField law = ending(1.0, taper, beta1, beta2);
      const CentralForce pair = pair_law(law, 1.0, 1.0);
      for (const double d : {0.3, 0.55, 0.65, 0.8, 0.99}) {
        const double h = 1e-5;
        const double slope = (potential(law, pair, d + h) - potential(law, pair, d - h)) / (2.0 * h);
        const double C = tapering(law, d) * strength(pair, d);
        const double scale = 0.5 * std::pow(d, -beta1) + 0.25 * std::pow(d, -beta2);
        BOOST_TEST(std::abs(slope - C) <= 1e-6 * scale);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(adds_the_forces_of_pairs_within_it) {
  for (const Kernel kernel : kernels()) {
    for (const auto& [beta1, beta2] : {std::pair{1.0, 2.0}, {2.0, 3.0}, {7.0, 13.0}, {0.3, 1.7}}) {
      for (const Eigen::Index N : {1, 2, 9, 150}) {
        for (const Space& space : {Space{}, Space{.lengths = {1.0, infinity, 0.9}}}) {
          for (const double cutoff : {0.2, 0.45}) {
            NearField law = ending(cutoff, cutoff == 0.2 ? 0.0 : 0.2, beta1, beta2);
            law.kernel = kernel;
            const Cloud cloud = cloud_of(N);
            const Added found = forces(law, space, cloud), by_hand = forces(law, Hidden{space}, cloud);
            BOOST_TEST(found.has_value);
            BOOST_TEST(close(found.force, by_hand.force, {1e-12, 1e-14 * by_hand.force.cwiseAbs().maxCoeff()}));
            BOOST_TEST(
                potential_energy(law, space, cloud.places()) == potential_energy(law, Hidden{space}, cloud.places()),
                tolerance(1e-12));
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(has_the_same_bits_whatever_the_neighbours_remember) {
  const Space box{.lengths = {1.0, 1.0, 1.0}};
  for (const Kernel kernel : kernels()) {
    NearField law = ending(0.15, 0.05);
    law.kernel = kernel;
    Cloud moving = cloud_of(500);
    Uniform uniform;
    const Vectors velocity = 0.01 * Vectors::NullaryExpr(500, 3, [&] { return uniform(); });
    int other_bits = 0;
    for (int k = 0; k < 20; ++k) {
      moving.position += velocity;
      Cloud fresh = moving;
      fresh.scratch = {};
      if (k % 3 == 0) {
        // Another law asks for more.
        fresh.scratch.neighbours.candidates(box, fresh.position, Eigen::VectorXd::Constant(500, 0.11));
      }
      other_bits += forces(law, box, moving).force != forces(law, box, fresh).force ? 1 : 0;
    }
    BOOST_TEST(other_bits == 0);
    BOOST_TEST(moving.scratch.neighbours.searches() < 10);
  }
}

BOOST_AUTO_TEST_CASE(leaves_out_what_is_beyond_and_has_no_value_where_particles_within_it_coincide) {
  BOOST_TEST(forces(ending(1.0, 0.5), Space{}, pair_at(1.0)).force.isZero(0.0));
  BOOST_TEST(forces(ending(1.0, 0.5), Space{}, pair_at(1e200)).has_value);
  BOOST_TEST(!forces(ending(1.0, 0.5), Space{}, pair_at(0.0)).has_value);
  Cloud many = cloud_of(100);
  many.position.row(70) = many.position.row(20);
  BOOST_TEST(!forces(ending(0.2, 0.1), Space{}, many).has_value);
  BOOST_TEST(contains(why_no_force(ending(0.2, 0.1), Space{}, many.places()), "particles 20 and 70"));
  many.inverse_mass[20] = many.inverse_mass[70] = 0.0;
  BOOST_TEST(forces(ending(0.2, 0.1), Space{}, many).has_value);
  many.position(33, 0) = not_a_number;
  BOOST_TEST(!forces(ending(0.2, 0.1), Space{}, many).has_value);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::near_field_test
