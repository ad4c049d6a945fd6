#include <particulate/swarm/target.hpp>

#include <cmath>

#include "close.hpp"
#include "contact/moment.hpp"

namespace tests::target_test {

using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::swarm;

Moment two_members() {
  return {particles({{.position = {0.0, 0.0, 1.0}, .mass = 2.0, .radius = 0.0},
                     {.position = {0.0, 3.0, 5.0}, .mass = 3.0, .radius = 0.0}})};
}

Vectors pull_on(const Target& law, const Moment& moment) {
  Vectors force = Vectors::Zero(moment.particles.size(), 3);
  BOOST_TEST(add_force(law, Space{}, moment.at(), Forces(force.data(), force.rows(), 3)));
  return force;
}

BOOST_AUTO_TEST_SUITE(target_force)

// 4 sqrt(d) towards (0, 0, 1) of 3 kg at distance 5: 12 sqrt(5) (0, -3/5, -4/5); the one that is there feels nothing.
BOOST_AUTO_TEST_CASE(grows_by_its_exponent_and_is_nothing_at_the_target) {
  const Target law{.place = {0.0, 0.0, 1.0}, .alpha = 4.0, .beta = 0.5};
  const double pull = 12.0 * std::sqrt(5.0);
  BOOST_TEST(close(pull_on(law, two_members()), Vectors{{0.0, 0.0, 0.0}, {0.0, -0.6 * pull, -0.8 * pull}},
                   {.relative = 8 * eps}));
}

BOOST_AUTO_TEST_CASE(of_exponent_zero_is_constant_and_of_one_a_spring) {
  for (const double d : {1e-3, 1.0, 1e3}) {
    const Moment moment{particles({{.position = {d, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}})};
    BOOST_TEST(close(pull_on({.alpha = 4.0, .beta = 0.0}, moment), Vectors{{-4.0, 0.0, 0.0}}, {.relative = 8 * eps}));
    BOOST_TEST(
        close(pull_on({.alpha = 4.0, .beta = 1.0}, moment), Vectors{{-4.0 * d, 0.0, 0.0}}, {.relative = 8 * eps}));
  }
}

BOOST_AUTO_TEST_CASE(goes_to_the_nearest_image) {
  const Moment moment{particles({{.position = {0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}})};
  Vectors force = Vectors::Zero(1, 3);
  const Target law{.place = {3.5, 0.0, 0.0}, .alpha = 1.0, .beta = 1.0};
  BOOST_TEST(add_force(law, Space{.lengths = {4.0, infinity, infinity}}, moment.at(), Forces(force.data(), 1, 3)));
  BOOST_TEST(close(force, Vectors{{-1.0, 0.0, 0.0}}, {.relative = 4 * eps}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(target_potential)

// Of 3 kg at distance 5: 3 4 5^1.5/1.5.
BOOST_AUTO_TEST_CASE(is_the_work_from_the_target) {
  const Target law{.place = {0.0, 0.0, 1.0}, .alpha = 4.0, .beta = 0.5};
  BOOST_TEST(potential_energy(law, Space{}, two_members().at()) == 8.0 * std::pow(5.0, 1.5), tolerance(8 * eps));
  BOOST_TEST(
      potential_energy({.place = {0.0, 0.0, 1.0}, .alpha = 4.0, .beta = 0.0}, Space{}, two_members().at()) == 60.0,
      tolerance(8 * eps));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(target_validate)

BOOST_AUTO_TEST_CASE(names_the_constant_what_must_hold_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(Target{.alpha = 0.0, .beta = 0.0}));
  CHECK_REFUSED(validate(Target{.place = {0.0, not_a_number, 0.0}}), "target: place must be finite, got (0, nan, 0) m");
  CHECK_REFUSED(validate(Target{.alpha = -1.0}), "target: alpha must be finite and not negative, got -1");
  CHECK_REFUSED(validate(Target{.alpha = infinity}), "got inf");
  CHECK_REFUSED(validate(Target{.beta = -0.1}), "target: beta must lie between 0 and 1, got -0.1");
  CHECK_REFUSED(validate(Target{.beta = 1.5}), "got 1.5");
  CHECK_REFUSED(validate(Target{.beta = not_a_number}), "got nan");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::target_test
