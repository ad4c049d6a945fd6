#include <particulate/kinematics/particles.hpp>

#include <string>
#include <vector>

#include "close.hpp"

namespace tests::particles_test {

using namespace particulate::kinematics;

Particles two_particles() {
  return {.position = Vectors{{1.0, 2.0, 3.0}, {4.0, 6.0, 8.0}},
          .velocity = Vectors{{0.0, -1.0, 0.5}, {0.25, 1.0, 0.5}},
          .mass = Eigen::Vector2d(1.0, 2.0),
          .radius = Eigen::Vector2d(0.0, 0.5)};
}

BOOST_AUTO_TEST_SUITE(particles_)

BOOST_AUTO_TEST_CASE(makes_arrays_of_a_list) {
  const Particles listed =
      particles({{.position = {1.0, 2.0, 3.0}, .mass = 1.0, .radius = 0.0},
                 {.position = {4.0, 6.0, 8.0}, .velocity = {0.25, 1.0, 0.5}, .mass = 2.0, .radius = 0.5}});
  Particles same = two_particles();
  same.velocity.row(0).setZero();  // left out: at rest
  BOOST_TEST((listed.position == same.position));
  BOOST_TEST((listed.velocity == same.velocity));
  BOOST_TEST((listed.mass == same.mass));
  BOOST_TEST((listed.radius == same.radius));
  BOOST_TEST(listed.immovable.empty());
  const Particles fixed = particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                     {.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0, .immovable = true}});
  BOOST_TEST((fixed.immovable == std::vector<bool>{false, true}));
  BOOST_TEST(particles({}).size() == 0);
}

BOOST_AUTO_TEST_CASE(refuses_what_is_not_given_and_what_cannot_be) {
  const Particle whole{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.1};
  CHECK_REFUSED(particles({whole, {.mass = 1.0, .radius = 0.1}}), "particle 1 has no position");
  CHECK_REFUSED(particles({{.position = {0.0, 0.0, 0.0}, .radius = 0.1}}), "particle 0 has no mass");
  CHECK_REFUSED(particles({whole, whole, {.position = {0.0, 0.0, 0.0}, .mass = 1.0}}), "particle 2 has no radius");
  Particle wrong = whole;
  wrong.mass = -1.0;
  CHECK_REFUSED(particles({whole, wrong}), "masses must be positive and finite, got -1 kg for particle 1");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_particles_without_size_and_no_particle_at_all) {
  BOOST_CHECK_NO_THROW(validate(two_particles()));
  BOOST_CHECK_NO_THROW(validate(Particles{}));
}

BOOST_AUTO_TEST_CASE(names_all_lengths_where_one_differs) {
  const auto refuses = [](const Particles& particles, const char* words) { CHECK_REFUSED(validate(particles), words); };
  Particles particles = two_particles();
  particles.position.resize(3, 3);
  refuses(particles, "must hold one entry a particle, got 3, 2, 2 and 2");
  particles = two_particles();
  particles.velocity.resize(1, 3);
  refuses(particles, "got 2, 1, 2 and 2");
  particles = two_particles();
  particles.mass.resize(4);
  refuses(particles, "got 2, 2, 4 and 2");
  particles = two_particles();
  particles.radius.resize(0);
  refuses(particles, "got 2, 2, 2 and 0");
}

BOOST_AUTO_TEST_CASE(names_the_particle_that_is_not_finite) {
  Particles particles = two_particles();
  particles.position(1, 2) = not_a_number;
  CHECK_REFUSED(validate(particles), "positions must be finite, got (4, 6, nan) m for particle 1");
  particles = two_particles();
  particles.velocity(0, 0) = -infinity;
  CHECK_REFUSED(validate(particles), "velocities must be finite, got (-inf, -1, 0.5) m/s for particle 0");
}

BOOST_AUTO_TEST_CASE(names_the_particle_whose_mass_is_none) {
  for (const double mass : {0.0, -1.0, infinity, not_a_number}) {
    Particles particles = two_particles();
    particles.mass[1] = mass;
    CHECK_REFUSED(validate(particles), "masses must be positive and finite, got ");
    CHECK_REFUSED(validate(particles), "kg for particle 1");
  }
}

BOOST_AUTO_TEST_CASE(names_the_particle_whose_radius_is_none) {
  for (const double radius : {-1e-300, infinity, not_a_number}) {
    Particles particles = two_particles();
    particles.radius[0] = radius;
    CHECK_REFUSED(validate(particles), "radii must be finite and not negative");
    CHECK_REFUSED(validate(particles), "m for particle 0");
  }
}

BOOST_AUTO_TEST_CASE(wants_no_flag_or_one_a_particle) {
  Particles particles = two_particles();
  particles.immovable = {false, true};
  BOOST_CHECK_NO_THROW(validate(particles));
  for (const std::size_t flags : {1U, 3U}) {
    particles.immovable.assign(flags, true);
    CHECK_REFUSED(validate(particles),
                  "immovable must be empty or hold one entry a particle, got " + std::to_string(flags) + " for 2");
  }
}

// Its mass still scales the near field.
BOOST_AUTO_TEST_CASE(wants_heat_of_all_or_of_none) {
  Particles warm = particles(
      {{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0, .temperature = 300.0, .heat_capacity = 4.0},
       {.position = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0, .temperature = 310.0, .heat_capacity = 5.0}});
  BOOST_TEST((warm.temperature == Eigen::Vector2d(300.0, 310.0)));
  BOOST_TEST((chosen(warm, {1}).heat_capacity == Eigen::VectorXd::Constant(1, 5.0)));
  warm.temperature[1] = -1.0;
  CHECK_REFUSED(validate(warm), "temperatures must be positive and finite, got -1 K for particle 1");
  warm.temperature[1] = 1.0;
  warm.heat_capacity[0] = 0.0;
  CHECK_REFUSED(validate(warm), "heat capacities must be positive and finite, got 0 J/(kg K) for particle 0");
  warm.heat_capacity.resize(0);
  CHECK_REFUSED(validate(warm), "must both be empty or hold one entry a particle, got 2 and 0 for 2");
  CHECK_REFUSED(particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0, .temperature = 300.0}}),
                "heat capacities must be positive and finite, got nan");
}

BOOST_AUTO_TEST_CASE(wants_a_mass_of_what_is_immovable_too) {
  Particles particles = two_particles();
  particles.immovable = {true, true};
  particles.mass[1] = infinity;
  CHECK_REFUSED(validate(particles), "masses must be positive and finite");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(chosen_)

BOOST_AUTO_TEST_CASE(are_those_named_in_the_order_in_which_they_are) {
  Particles all = two_particles();
  all.immovable = {true, false};
  const Particles turned = chosen(all, {1, 0, 1});
  BOOST_TEST(close(turned.position, Vectors{{4.0, 6.0, 8.0}, {1.0, 2.0, 3.0}, {4.0, 6.0, 8.0}}, {}));
  BOOST_TEST(close(turned.velocity, Vectors{{0.25, 1.0, 0.5}, {0.0, -1.0, 0.5}, {0.25, 1.0, 0.5}}, {}));
  BOOST_TEST(close(turned.mass, Eigen::Vector3d(2.0, 1.0, 2.0), {}));
  BOOST_TEST(close(turned.radius, Eigen::Vector3d(0.5, 0.0, 0.5), {}));
  BOOST_TEST((turned.immovable == std::vector<bool>{false, true, false}));
}

BOOST_AUTO_TEST_CASE(may_be_none_and_are_flagged_only_where_all_are) {
  BOOST_TEST(chosen(two_particles(), {}).size() == 0);
  BOOST_CHECK_NO_THROW(validate(chosen(two_particles(), {})));
  BOOST_TEST(chosen(two_particles(), {1}).immovable.empty());
}

BOOST_AUTO_TEST_CASE(are_refused_where_one_is_not_there) {
  CHECK_REFUSED(chosen(two_particles(), {0, 2}), "there is no particle 2 among 2: choose others");
  CHECK_REFUSED(chosen(two_particles(), {-1}), "there is no particle -1 among 2");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(inverse_masses_)

BOOST_AUTO_TEST_CASE(vanish_for_what_is_immovable) {
  Particles particles = two_particles();
  BOOST_TEST(close(inverse_masses(particles), Eigen::Vector2d(1.0, 0.5), {}));
  particles.immovable = {true, false};
  BOOST_TEST(close(inverse_masses(particles), Eigen::Vector2d(0.0, 0.5), {}));
  particles.immovable = {false, true};
  BOOST_TEST(close(inverse_masses(particles), Eigen::Vector2d(1.0, 0.0), {}));
  BOOST_TEST(inverse_masses(Particles{}).size() == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(vector_)

BOOST_AUTO_TEST_CASE(reads_the_row_of_a_particle) {
  BOOST_TEST(close(vector(two_particles().position, 1), Eigen::Vector3d(4.0, 6.0, 8.0), {}));
}

BOOST_AUTO_TEST_CASE(reads_one_contiguous_column_a_component) {
  const Vectors position = two_particles().position;
  BOOST_TEST(position.data()[0] == 1.0);
  BOOST_TEST(position.data()[1] == 4.0);
  BOOST_TEST(position.data()[2] == 2.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(set_vector_)

BOOST_AUTO_TEST_CASE(writes_one_particle_and_no_other) {
  Vectors position = two_particles().position;
  set_vector(position, 0, {-1.0, -2.0, -3.0});
  BOOST_TEST(close(position, Vectors{{-1.0, -2.0, -3.0}, {4.0, 6.0, 8.0}}, {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(relative_motion_)

// (1, 2, 3) - (4, 6, 8) and (0, -1, 0.5) - (0.25, 1, 0.5).
BOOST_AUTO_TEST_CASE(is_the_first_as_seen_from_the_second) {
  const RelativeMotion seen = relative_motion(two_particles(), 0, 1);
  BOOST_TEST(close(seen.position, Eigen::Vector3d(-3.0, -4.0, -5.0), {}));
  BOOST_TEST(close(seen.velocity, Eigen::Vector3d(-0.25, -2.0, 0.0), {}));
}

BOOST_AUTO_TEST_CASE(turns_its_sign_when_the_particles_are_exchanged) {
  const RelativeMotion there = relative_motion(two_particles(), 0, 1), back = relative_motion(two_particles(), 1, 0);
  BOOST_TEST(close(there.position, -back.position, {}));
  BOOST_TEST(close(there.velocity, -back.velocity, {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(relative_motion_of_others)

BOOST_AUTO_TEST_CASE(is_refused_for_a_particle_that_is_not_there) {
  CHECK_REFUSED(relative_motion(two_particles(), 0, 2), "must be one of 2, counted from 0, got 2");
  CHECK_REFUSED(relative_motion(two_particles(), -1, 0), "got -1");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::particles_test
