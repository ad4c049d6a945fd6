#include <particulate/laws/central_field.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "close.hpp"
#include "clouds.hpp"
#include "contact/moment.hpp"

namespace tests::central_field_test {

using namespace particulate::kinematics;
using namespace particulate::laws;

// N particles of different masses in a box of unit side about the origin.
Moment some_particles(Eigen::Index N) {
  Particles cloud = random_cloud(N, Eigen::Vector3d::Ones(), 0.1, 0.1);
  cloud.position.array() -= 0.5;
  for (Eigen::Index i = 0; i < N; ++i) cloud.mass[i] = 0.5 + 0.25 * static_cast<double>(i % 7);
  return {cloud};
}

Moment one_at(const Eigen::Vector3d& place, double mass = 1.0) {
  return {particles({{.position = place, .mass = mass, .radius = 0.0}})};
}

// The first of them is the origin, where the padding of the particles stands as well.
std::vector<Eigen::Vector3d> centres(std::size_t count) {
  std::vector<Eigen::Vector3d> all;
  for (std::size_t k = 0; k < count; ++k) {
    const double a = static_cast<double>(k);
    all.emplace_back(2.0 * std::sin(a), 1.5 * std::sin(1.7 * a), 3.0 * std::sin(0.6 * a));
  }
  return all;
}

struct Pulled {
  Vectors force;
  bool has_value;
};

template <class D>
Pulled forces(const CentralField& field, const D& domain, const Moment& moment) {
  Vectors force = Vectors::Zero(moment.particles.size(), 3);
  const bool has_value = add_field(field, domain, moment.at(), Forces(force.data(), force.rows(), 3));
  return {force, has_value};
}

struct Plain {
  Vectors force;          // the sums
  Eigen::VectorXd terms;  // and those of the sizes of their terms
};

// The formula as it is printed, in extended precision with std::pow.
Plain plain_double_loop(const CentralField& field, const Moment& moment) {
  const CentralForce& law = field.per_mass;
  const Eigen::Index N = moment.particles.size();
  Plain plain{Vectors(N, 3), Eigen::VectorXd(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    std::array<long double, 3> sum{};
    long double terms = 0.0L;
    for (const Eigen::Vector3d& centre : field.centre) {
      std::array<long double, 3> n{};
      long double square = 0.0L;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto axis = static_cast<Eigen::Index>(c);
        n[c] = static_cast<long double>(centre[axis]) - moment.particles.position(i, axis);
        square += n[c] * n[c];
      }
      const long double d = std::sqrt(square), m = moment.particles.mass[i];
      const long double pull = m * law.alpha1 * std::pow(d, -static_cast<long double>(law.beta1)),
                        push = m * law.alpha2 * std::pow(d, -static_cast<long double>(law.beta2));
      for (std::size_t c = 0; c < 3; ++c) sum[c] += (pull - push) * n[c] / d;
      terms += pull + push;
    }
    for (std::size_t c = 0; c < 3; ++c) plain.force(i, static_cast<Eigen::Index>(c)) = static_cast<double>(sum[c]);
    plain.terms[i] = static_cast<double>(terms);
  }
  return plain;
}

std::vector<Kernel> kernels() {
  std::vector<Kernel> all{Kernel::baseline};
  for (const Kernel one : {Kernel::avx2, Kernel::avx512}) {
    if (is_available(one)) all.push_back(one);
  }
  return all;
}

const CentralForce both_ways{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 1.0, .beta2 = 2.0};

BOOST_AUTO_TEST_SUITE(add_field_)

// 3 kg at distance 2 from the one centre: 3 (4/2 - 5/4) = 2.25 towards it, on top of what is there.
BOOST_AUTO_TEST_CASE(is_strength_times_mass_along_the_line_to_the_centre) {
  const std::vector<Eigen::Vector3d> centre{{0.0, 2.0, 0.0}};
  const CentralField field{.per_mass = {.alpha1 = 4.0, .alpha2 = 5.0, .beta1 = 1.0, .beta2 = 2.0}, .centre = centre};
  const Moment moment = one_at({0.0, 0.0, 0.0}, 3.0);
  Vectors force{{1.0, 1.0, 1.0}};
  BOOST_TEST(add_field(field, Space{}, moment.at(), Forces(force.data(), 1, 3)));
  BOOST_TEST(close(force, Vectors{{1.0, 3.25, 1.0}}, {.relative = 4 * eps}));
}

// Each power and each reciprocal distance costs a few roundings: as in the near field, whose kernels these are.
BOOST_AUTO_TEST_CASE(agrees_with_the_formula_for_every_kernel_exponent_and_number) {
  const std::vector<std::array<double, 2>> exponents{{1.0, 2.0}, {0.0, 3.0},  {-1.0, 2.0},
                                                     {2.0, 7.0}, {-0.3, 1.5}, {0.5, 2.7}};
  for (const std::size_t count : {1U, 9U, 16U, 17U, 40U}) {
    const std::vector<Eigen::Vector3d> centre = centres(count);
    for (Eigen::Index N = 1; N <= 40; N += N < 18 ? 1 : 5) {
      const Moment moment = some_particles(N);
      for (const auto& [beta1, beta2] : exponents) {
        CentralField field{.per_mass = {0.7, 0.3, beta1, beta2}, .centre = centre};
        const Plain plain = plain_double_loop(field, moment);
        const double bound = (2.75 * std::max(beta1, beta2) + 6.0 + 0.5 * std::sqrt(static_cast<double>(count))) * eps;
        for (const Kernel kernel : kernels()) {
          field.kernel = kernel;
          const Pulled pulled = forces(field, Space{}, moment);
          const Eigen::VectorXd off = (pulled.force - plain.force).rowwise().norm();
          BOOST_TEST_CONTEXT(N << " particles, " << count << " centres, beta " << beta1 << " and " << beta2
                               << ", kernel " << name(kernel)) {
            BOOST_TEST(pulled.has_value);
            BOOST_TEST(off.cwiseQuotient(plain.terms).maxCoeff() <= bound);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(of_no_centre_and_on_no_particle_is_nothing) {
  for (const Kernel kernel : kernels()) {
    const CentralField field{.per_mass = both_ways, .kernel = kernel};
    const Pulled pulled = forces(field, Space{}, some_particles(12));
    BOOST_TEST(pulled.has_value);
    BOOST_TEST(pulled.force.isZero(0.0));
    const std::vector<Eigen::Vector3d> nine = centres(9);
    BOOST_TEST(forces({.per_mass = both_ways, .centre = nine, .kernel = kernel}, Space{}, some_particles(0)).has_value);
  }
}

// Powers of such distances, or their squares, leave the range of a double: pair by pair there is an answer.
BOOST_AUTO_TEST_CASE(holds_at_extreme_distances_too) {
  for (const double far : {1e-160, 1e-100, 1e100, 1e160}) {
    const std::vector<Eigen::Vector3d> centre{{far, 0.0, 0.0}};
    const CentralField field{.per_mass = {.alpha1 = 2.0, .alpha2 = 0.0, .beta1 = 1.0}, .centre = centre};
    const Pulled pulled = forces(field, Space{}, one_at({0.0, 0.0, 0.0}));
    BOOST_TEST(pulled.has_value);
    BOOST_TEST(close(pulled.force, Vectors{{2.0 / far, 0.0, 0.0}}, {.relative = 8 * eps}));
  }
}

BOOST_AUTO_TEST_CASE(goes_to_the_nearest_image_of_a_centre) {
  const std::vector<Eigen::Vector3d> centre{{0.25, 0.0, 0.0}};
  const CentralField field{.per_mass = {.alpha1 = 1.0, .alpha2 = 0.0, .beta1 = 1.0}, .centre = centre};
  const Space ring{.lengths = {4.0, infinity, infinity}};
  // From 3.75 + 8 on to the image at 4.25 + 8: 1/2 ahead.
  const Pulled pulled = forces(field, ring, one_at({11.75, 0.0, 0.0}));
  BOOST_TEST(close(pulled.force, Vectors{{2.0, 0.0, 0.0}}, {.relative = 4 * eps}));
}

// Those that do not coincide are given their forces all the same, where the centre exerts nothing at itself.
BOOST_AUTO_TEST_CASE(at_a_centre_has_a_value_only_where_it_is_said_to_vanish) {
  for (const Eigen::Index N : {2, 12}) {
    Moment moment = some_particles(N);
    const std::vector<Eigen::Vector3d> centre{moment.particles.position.row(1)};
    CentralField field{.per_mass = both_ways, .centre = centre};
    BOOST_TEST(!forces(field, Space{}, moment).has_value);
    field.vanishes_at_centre = true;
    const Pulled pulled = forces(field, Space{}, moment);
    BOOST_TEST(pulled.has_value);
    BOOST_TEST(pulled.force.row(1).isZero(0.0));
    BOOST_TEST(close(pulled.force.row(0),
                     forces(field, Space{}, one_at(moment.particles.position.row(0), moment.particles.mass[0])).force,
                     {.relative = 16 * eps}));
  }
}

BOOST_AUTO_TEST_CASE(that_is_too_large_for_a_double_has_no_value) {
  const std::vector<Eigen::Vector3d> centre{{1.0, 0.0, 0.0}};
  const CentralField field{.per_mass = {.alpha1 = 1e200, .alpha2 = 0.0, .beta1 = 1.0}, .centre = centre};
  for (const Eigen::Index N : {1, 12}) {
    Moment moment = some_particles(N);
    moment.particles.mass.setConstant(1e200);
    BOOST_TEST(!forces(field, Space{}, moment).has_value);
  }
}

// Nor where a particle at a centre would feel nothing: it is not there.
BOOST_AUTO_TEST_CASE(of_a_particle_that_is_nowhere_has_no_value) {
  const std::vector<Eigen::Vector3d> centre = centres(9);
  for (const Eigen::Index N : {1, 12}) {
    for (const double nowhere : {not_a_number, infinity}) {
      Moment moment = some_particles(N);
      moment.particles.position(0, 1) = nowhere;
      for (const bool vanishes : {false, true}) {
        const CentralField field{.per_mass = both_ways, .centre = centre, .vanishes_at_centre = vanishes};
        BOOST_TEST(!forces(field, Space{}, moment).has_value);
        BOOST_TEST(!forces(field, Space{.lengths = {9.0, infinity, infinity}}, moment).has_value);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(refuses_a_kernel_that_is_not_there) {
  const std::vector<Eigen::Vector3d> centre = centres(1);
  const CentralField field{.per_mass = both_ways, .centre = centre, .kernel = static_cast<Kernel>(7)};
  CHECK_REFUSED(forces(field, Space{}, some_particles(1)), "kernel must be best or one that this build has");
}

// A domain of one's own, whose distances are twice ours: pair by pair.
struct Doubled {};
Eigen::Vector3d separation(const Doubled&, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return 2.0 * (to - from);
}

BOOST_AUTO_TEST_CASE(asks_the_domain_for_the_way) {
  const std::vector<Eigen::Vector3d> centre{{1.0, 0.0, 0.0}};
  const CentralField field{.per_mass = {.alpha1 = 1.0, .alpha2 = 0.0, .beta1 = 1.0}, .centre = centre};
  BOOST_TEST(close(forces(field, Doubled{}, one_at({0.0, 0.0, 0.0})).force, Vectors{{0.5, 0.0, 0.0}}, {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(energy_in_field_)

// Of 2 kg at distance 3 in the pull 4/d, zero at 1: 2 4 ln 3.
BOOST_AUTO_TEST_CASE(counts_from_where_it_is_zero) {
  const std::vector<Eigen::Vector3d> centre{{3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  const CentralField field{.per_mass = {.alpha1 = 4.0, .alpha2 = 0.0, .beta1 = 1.0}, .centre = centre};
  const Moment moment = one_at({0.0, 0.0, 0.0}, 2.0);
  BOOST_TEST(energy_in_field(field, Space{}, moment.at()) == 8.0 * std::log(3.0), tolerance(4 * eps));
}

// Differences over 2 h of five-point formulae leave h^4 and the roundings over h.
BOOST_AUTO_TEST_CASE(has_the_force_as_its_negative_gradient) {
  const std::vector<Eigen::Vector3d> centre = centres(9);
  const CentralField field{.per_mass = {0.7, 0.3, -0.3, 1.5}, .centre = centre};
  const Eigen::Vector3d place(0.3, -0.4, 0.2);
  const Pulled pulled = forces(field, Space{}, one_at(place, 1.5));
  const double h = 1e-3;
  for (Eigen::Index c = 0; c < 3; ++c) {
    const auto energy = [&](double steps) {
      const Moment moved = one_at(place + steps * h * Eigen::Vector3d::Unit(c), 1.5);
      return energy_in_field(field, Space{}, moved.at());
    };
    const double slope = (8.0 * (energy(1.0) - energy(-1.0)) - (energy(2.0) - energy(-2.0))) / (12.0 * h);
    BOOST_TEST(std::abs(pulled.force(0, c) + slope) <= 1e-8);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::central_field_test
