#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>

#include "close.hpp"
#include "clouds.hpp"
#include "says.hpp"

namespace tests::close_pairs_test {

using namespace particulate;

// N particles of 1 kg in a unit box, and the scratch that pairs are chosen into.
struct Cloud {
  explicit Cloud(Eigen::Index N)
      : particles(tests::random_cloud(N, Eigen::Vector3d::Ones(), 0.01, 0.02)),
        inverse_mass(inverse_masses(particles)) {}

  laws::At<laws::Velocity> at() const {
    const auto shaped = [](const kinematics::Vectors& x) {
      return Eigen::Map<const kinematics::Vectors>(x.data(), x.rows(), 3);
    };
    return {{.t = 0.0,
             .position = shaped(particles.position),
             .mass = particles.mass,
             .radius = particles.radius,
             .inverse_mass = inverse_mass,
             .scratch = scratch},
            shaped(particles.velocity)};
  }
  kinematics::Particles particles;
  Eigen::VectorXd inverse_mass;
  mutable laws::Scratch scratch = {};
};

kinematics::Vectors sum(const laws::NearField& law, const Cloud& cloud) {
  kinematics::Vectors force = kinematics::Vectors::Zero(cloud.particles.size(), 3);
  BOOST_TEST_REQUIRE(
      add_close_force(law, kinematics::Space{}, cloud.at(), laws::Forces(force.data(), force.rows(), 3)));
  return force;
}

kinematics::Vectors sum_by_pairs(const laws::NearField& law, const Cloud& cloud) {
  kinematics::Vectors force = kinematics::Vectors::Zero(cloud.particles.size(), 3);
  const laws::ChosenPairs& close = cloud.scratch.close;
  for (std::size_t k = 0; k < close.row.size(); ++k) {
    const Eigen::Vector3d apart =
        cloud.particles.position.row(close.partner[k]) - cloud.particles.position.row(close.row[k]);
    const double d = apart.norm(), both = cloud.particles.mass[close.row[k]] * cloud.particles.mass[close.partner[k]];
    const double pull = both * (law.alpha1 * std::pow(d, -law.beta1) - law.alpha2 * std::pow(d, -law.beta2)) / d;
    force.row(close.row[k]) += pull * apart;
    force.row(close.partner[k]) -= pull * apart;
  }
  return force;
}

BOOST_AUTO_TEST_SUITE(choose_close_)

// With unit masses and alpha2 = 1, beta2 = 2 the force of a pair is stiff over dt = 0.1 s where 0.01 * 2 * 3/d^3 >
// 0.07, at d < (6/7)^(1/3) = 0.9499.
BOOST_AUTO_TEST_CASE(takes_pairs_that_are_stiff) {
  const laws::NearField law{.alpha1 = 0.0, .alpha2 = 1.0};
  for (const double d : {0.94, 0.96}) {
    Cloud cloud(2);
    cloud.particles.position << 0.0, 0.0, 0.0, d, 0.0, 0.0;
    cloud.particles.velocity.setOnes();
    BOOST_TEST_REQUIRE(choose_close(law, kinematics::Space{}, cloud.at(), 0.1));
    BOOST_TEST(cloud.scratch.close.row.size() == (d < 0.95 ? 1U : 0U));
  }
}

// At 2 m/s towards each other for 0.5 s, past each other at d: near where d < 3 * 0.25 * 2 = 1.5 m. From 2.5 m apart
// they come within 1.5 m along the path; leaving each other they do not.
BOOST_AUTO_TEST_CASE(takes_pairs_that_pass_each_other) {
  const laws::NearField law{.alpha1 = 1e-9, .alpha2 = 1e-9};
  const auto pairs = [&](double along, double across, double speed) {
    Cloud cloud(2);
    cloud.particles.position << 0.0, 0.0, 0.0, along, across, 0.0;
    cloud.particles.velocity << 0.5 * speed, 7.0, 0.0, -0.5 * speed, 7.0, 0.0;
    BOOST_TEST_REQUIRE(choose_close(law, kinematics::Space{}, cloud.at(), 0.5));
    return cloud.scratch.close.row.size();
  };
  BOOST_TEST(pairs(0.3, 1.49, 2.0) == 1U);
  BOOST_TEST(pairs(0.3, 1.51, 2.0) == 0U);
  BOOST_TEST(pairs(2.49, 0.0, 2.0) == 1U);
  BOOST_TEST(pairs(2.51, 0.0, 2.0) == 0U);
  BOOST_TEST(pairs(1.51, 0.0, -2.0) == 0U);
}

// By search and by all pairs.
BOOST_AUTO_TEST_CASE(leaves_none_out_of_many) {
  const laws::NearField law{.alpha1 = 1e-3, .alpha2 = 1e-3};
  Cloud many(300);
  BOOST_TEST_REQUIRE(choose_close(law, kinematics::Space{}, many.at(), 0.02));
  std::vector<std::array<int, 2>> found, expected;
  for (std::size_t k = 0; k < many.scratch.close.row.size(); ++k) {
    found.push_back({many.scratch.close.row[k], many.scratch.close.partner[k]});
  }
  for (int i = 0; i < 300; ++i) {
    for (int j = i + 1; j < 300; ++j) {
      Cloud two(2);
      two.particles.position << many.particles.position.row(i), many.particles.position.row(j);
      two.particles.velocity << many.particles.velocity.row(i), many.particles.velocity.row(j);
      BOOST_TEST_REQUIRE(choose_close(law, kinematics::Space{}, two.at(), 0.02));
      if (!two.scratch.close.row.empty()) expected.push_back({i, j});
    }
  }
  BOOST_TEST(expected.size() > 20U);
  BOOST_TEST(found == expected);
}

BOOST_AUTO_TEST_CASE(refuses_a_near_field_that_is_cut_off) {
  BOOST_CHECK_EXCEPTION((void)choose_close({.alpha1 = 1.0, .cutoff = 2.0}, kinematics::Space{}, Cloud(2).at(), 0.1),
                        std::invalid_argument, says("got a cutoff of 2 m"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(add_close_force_)

// Of 1 to 17 pairs, so that the last register is filled in every way, and many.
BOOST_AUTO_TEST_CASE(is_the_sum_over_the_chosen_pairs_in_every_kernel) {
  for (const auto& [beta1, beta2] : {std::array{1.0, 2.0}, {2.0, 3.0}, {7.0, 13.0}, {0.5, 2.25}}) {
    for (const laws::Kernel kernel : {laws::Kernel::baseline, laws::Kernel::avx2, laws::Kernel::avx512}) {
      if (!is_available(kernel)) continue;
      const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = beta1, .beta2 = beta2, .kernel = kernel};
      Cloud cloud(60);
      for (Eigen::Index i = 0; i < 60; ++i) cloud.particles.mass[i] = 0.5 + 0.02 * static_cast<double>(i);
      for (int pairs = 0; pairs < 40; ++pairs) {
        BOOST_TEST(close(sum(law, cloud), sum_by_pairs(law, cloud), {.relative = 1e-12, .absolute = 1e-13}));
        cloud.scratch.close.row.push_back(pairs / 3);
        cloud.scratch.close.partner.push_back(20 + pairs);
      }
    }
  }
}

// Squares of 1e-160 m are none: pair by pair they feel each other, and there is no force.
BOOST_AUTO_TEST_CASE(has_no_value_where_chosen_particles_coincide) {
  const laws::NearField law{.alpha1 = 1.0, .alpha2 = 1.0};
  Cloud cloud(2);
  cloud.particles.position.setZero();
  cloud.scratch.close = {.row = {0}, .partner = {1}};
  kinematics::Vectors force = kinematics::Vectors::Zero(2, 3);
  BOOST_TEST(!add_close_force(law, kinematics::Space{}, cloud.at(), laws::Forces(force.data(), 2, 3)));
  cloud.inverse_mass.setZero();
  BOOST_TEST(add_close_force(law, kinematics::Space{}, cloud.at(), laws::Forces(force.data(), 2, 3)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(a_scene_that_splits)

BOOST_AUTO_TEST_CASE(gives_the_accelerations_of_the_close_pairs) {
  const Cloud cloud(50);
  const laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.25};
  const scenes::Scene scene(cloud.particles, kinematics::Space{}, law);
  const schemes::State state = start(scene);
  BOOST_TEST_REQUIRE(scene.split(state, 0.02));
  BOOST_TEST_REQUIRE(choose_close(law, kinematics::Space{}, cloud.at(), 0.02));
  BOOST_TEST(cloud.scratch.close.row.size() > 10U);
  Eigen::VectorXd fast(150);
  BOOST_TEST_REQUIRE(scene.acceleration_fast(0.0, state.r, fast));
  BOOST_TEST(close(fast, sum(law, cloud).reshaped().eval(), {.relative = 1e-14}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::close_pairs_test
