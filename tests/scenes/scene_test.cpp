#include <particulate/scenes/scene.hpp>

#include <limits>
#include <stdexcept>

#include <particulate/contact/near_field.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"

using particulate::contact::Forces;
using particulate::contact::Moving;
using particulate::contact::NearField;
using particulate::contact::Places;
using particulate::kinematics::CentralForce;
using particulate::kinematics::Open;
using particulate::kinematics::Particles;
using particulate::kinematics::Scales;
using particulate::kinematics::Vectors;
using particulate::scenes::Scene;
using particulate::scenes::start;
using particulate::schemes::FixedStep;
using particulate::schemes::integrate;
using particulate::schemes::Measures;
using particulate::schemes::Motion;
using particulate::schemes::MotionProblem;
using particulate::schemes::PositionProblem;
using particulate::schemes::VelocityVerlet;
using tests::close;
using tests::says;

namespace {

// A uniform field along -z that grows with time; its potential is that of the moment.
struct Weight {
  double g;
};
bool add_force(const Weight& law, const Open&, const Places& at, Forces force) {
  force.col(2) -= law.g * (1.0 + at.t) * at.mass;
  return true;
}
double potential_energy(const Weight& law, const Open&, const Places& at) {
  return law.g * (1.0 + at.t) * at.mass.dot(at.position.col(2));
}
void validate(const Weight& law) {
  if (!(law.g >= 0.0)) throw std::invalid_argument("weight: g must not be negative");
}

struct Drag {
  double c;
};
bool add_force(const Drag& law, const Open&, const Moving& at, Forces force) {
  force -= law.c * at.velocity;
  return true;
}

// Has no value outside a slab.
struct Slab {};
bool add_force(const Slab&, const Open&, const Places& at, Forces) { return (at.position.col(0).array() < 10.0).all(); }

template <class S>
concept HasPotential = requires(const S& scene, const Motion& state) {
  scene.potential_energy(state);
};

using Falling = Scene<Open, Weight>;
using Dragged = Scene<Open, Weight, Drag>;

static_assert(PositionProblem<Falling> && !MotionProblem<Falling> && !Falling::needs_velocity);
static_assert(MotionProblem<Dragged> && !PositionProblem<Dragged> && Dragged::needs_velocity);
static_assert(MotionProblem<Scene<Open, Drag, Weight>>, "whichever law comes first");
static_assert(PositionProblem<const Falling> && MotionProblem<const Dragged>, "a scene is not changed by its motion");
static_assert(PositionProblem<Scene<Open>>, "no law at all is a law of free flight");
static_assert(Measures<Falling> && Measures<Dragged>);
static_assert(HasPotential<Scene<Open>> && HasPotential<Falling> && HasPotential<Scene<Open, NearField, Weight>>);
static_assert(!HasPotential<Dragged> && !HasPotential<Scene<Open, Weight, Slab>>,
              "one law without a potential is enough");

Particles two_particles() {
  return {.position = Vectors{{1.0, 2.0, 3.0}, {3.0, 2.0, 3.0}},
          .velocity = Vectors{{0.5, 0.0, -1.0}, {0.0, 0.25, 2.0}},
          .mass = Eigen::Vector2d(2.0, 3.0),
          .radius = Eigen::Vector2d(0.5, 0.5)};
}

Particles no_particles() { return {Vectors(0, 3), Vectors(0, 3), Eigen::VectorXd(0), Eigen::VectorXd(0)}; }

// At a distance of 2 it pulls with 6 (1/2 - 0.5/4) = 2.25.
const NearField monograph{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 1.0, .beta2 = 2.0};

template <class S>
Eigen::VectorXd total_force(const S& scene) {
  Eigen::VectorXd f(3 * scene.particles().size());
  BOOST_TEST(scene.total_force(start(scene), f));
  return f;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(Scene_)

BOOST_AUTO_TEST_CASE(checks_its_particles_and_its_laws) {
  Particles bad = two_particles();
  bad.mass[1] = -1.0;
  BOOST_CHECK_EXCEPTION(Scene(bad, Open{}, Weight{1.0}), std::invalid_argument, says("masses must be positive"));
  BOOST_CHECK_EXCEPTION(Scene(two_particles(), Open{}, Drag{1.0}, Weight{-1.0}), std::invalid_argument,
                        says("weight: g must not be negative"));
  BOOST_CHECK_EXCEPTION(Scene(two_particles(), Open{}, Weight{1.0}, NearField{.beta1 = -1.0}), std::invalid_argument,
                        says("beta1 must be finite and not negative"));
  BOOST_CHECK_NO_THROW(Scene(two_particles(), Open{}, Drag{-1.0}));  // a law without validate() is taken as it is
}

BOOST_AUTO_TEST_CASE(keeps_its_particles) {
  const Scene scene(two_particles(), Open{}, Weight{1.0});
  BOOST_TEST(close(scene.particles().position, two_particles().position, {}));
  BOOST_TEST(close(scene.particles().mass, two_particles().mass, {}));
}

// Weight 2 m (1 + t) at t = 0 is 4 and 6; along x the near field's 2.25.
BOOST_AUTO_TEST_CASE(adds_the_forces_of_its_laws) {
  const Scene scene(two_particles(), Open{}, monograph, Weight{2.0});
  Eigen::VectorXd expected(6);
  expected << 2.25, -2.25, 0.0, 0.0, -4.0, -6.0;
  BOOST_TEST(close(total_force(scene), expected, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(gives_velocities_to_the_law_that_asks_and_places_to_the_other) {
  const Scene scene(two_particles(), Open{}, Weight{2.0}, Drag{4.0});
  Eigen::VectorXd expected(6);
  expected << -2.0, 0.0, 0.0, -1.0, -4.0 + 4.0, -6.0 - 8.0;
  BOOST_TEST(close(total_force(scene), expected, {}));
}

BOOST_AUTO_TEST_CASE(starts_its_sum_from_nothing) {
  const Scene scene(two_particles(), Open{}, Weight{2.0});
  Eigen::VectorXd f = Eigen::VectorXd::Constant(6, std::numeric_limits<double>::quiet_NaN());
  BOOST_TEST(scene.total_force(start(scene), f));
  BOOST_TEST(f.allFinite());
}

// g (1 + t) = 6 at t = 2, whatever the mass; 2.25/2 and 2.25/3.
BOOST_AUTO_TEST_CASE(divides_by_each_particles_own_mass_at_its_own_time) {
  const Scene scene(two_particles(), Open{}, monograph, Weight{2.0});
  const Motion state = start(scene);
  Eigen::VectorXd a(6), expected(6);
  BOOST_TEST(scene.acceleration(2.0, state.r, a));
  expected << 1.125, -0.75, 0.0, 0.0, -6.0, -6.0;
  BOOST_TEST(close(a, expected, {.relative = 1e-15}));
  const Scene dragged(two_particles(), Open{}, Drag{6.0});
  BOOST_TEST(dragged.acceleration(0.0, state.r, state.v, a));
  expected << -1.5, 0.0, 0.0, -0.5, 3.0, -4.0;
  BOOST_TEST(close(a, expected, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(has_no_value_where_one_of_its_laws_has_none) {
  Particles outside = two_particles();
  outside.position(1, 0) = 11.0;
  Eigen::VectorXd a(6);
  const Scene first(outside, Open{}, Slab{}, Weight{1.0});
  const Scene last(outside, Open{}, Weight{1.0}, Slab{});
  BOOST_TEST(!first.acceleration(0.0, start(first).r, a));
  BOOST_TEST(!last.acceleration(0.0, start(last).r, a));
  BOOST_TEST(!last.total_force(start(last), a));
  Particles together = two_particles();
  together.position.row(1) = together.position.row(0);
  const Scene coincident(together, Open{}, monograph);
  BOOST_TEST(!coincident.acceleration(0.0, start(coincident).r, a));
}

BOOST_AUTO_TEST_CASE(has_no_value_where_an_acceleration_is_too_large) {
  Particles light = two_particles();
  light.mass[0] = 1e-300;
  const Scene scene(light, Open{}, NearField{.alpha1 = 1e300, .scaling = particulate::contact::Scaling::pair});
  Eigen::VectorXd a(6);
  BOOST_TEST(scene.total_force(start(scene), a));
  BOOST_TEST(!scene.acceleration(0.0, start(scene).r, a));
}

BOOST_AUTO_TEST_CASE(refuses_vectors_of_another_length) {
  const Scene scene(two_particles(), Open{}, Weight{1.0});
  const Eigen::VectorXd right = Eigen::VectorXd::Zero(6), wrong = Eigen::VectorXd::Zero(5);
  Eigen::VectorXd a(6), short_a(3);
  BOOST_CHECK_EXCEPTION((void)scene.acceleration(0.0, wrong, a), std::invalid_argument,
                        says("vectors of 2 particles must hold 6 numbers, got 5"));
  BOOST_CHECK_EXCEPTION((void)scene.acceleration(0.0, right, short_a), std::invalid_argument, says("got 3"));
  BOOST_CHECK_EXCEPTION((void)scene.distance(right, wrong), std::invalid_argument, says("got 5"));
}

// ln 2 - 0.25 per unit mass squared, and g (2 3 + 3 3) = 30.
BOOST_AUTO_TEST_CASE(adds_the_potential_energies_of_its_laws) {
  const Scene scene(two_particles(), Open{}, monograph, Weight{2.0});
  const double ln2 = 0.693147180559945309;
  BOOST_TEST(scene.potential_energy(start(scene)) == 6.0 * (ln2 - 0.25) + 30.0, boost::test_tools::tolerance(1e-15));
  const Scene free(two_particles(), Open{});
  BOOST_TEST(free.potential_energy(start(free)) == 0.0);
}

// (3, 4, 0) and (0, 0, 2): 5 + 2. A flat norm would make sqrt 29 or 9 of it.
BOOST_AUTO_TEST_CASE(measures_by_the_sum_over_particles) {
  const Scene scene(two_particles(), Open{});
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6), y = x;
  x << 3.0, 0.0, 4.0, 0.0, 0.0, 2.0;
  BOOST_TEST(scene.distance(x, y) == 7.0);
  BOOST_TEST(scene.distance(y, x) == 7.0);
  BOOST_TEST(scene.distance(x, x) == 0.0);
}

BOOST_AUTO_TEST_CASE(without_particles_and_without_laws_is_a_scene) {
  const Scene empty(no_particles(), Open{}, monograph, Weight{1.0});
  Eigen::VectorXd none(0);
  BOOST_TEST(empty.acceleration(0.0, none, none));
  BOOST_TEST(empty.potential_energy(start(empty)) == 0.0);
  const Scene free(two_particles(), Open{});
  BOOST_TEST(close(total_force(free), Eigen::VectorXd::Zero(6), {}));
}

// Thirty steps of the scene and of its image under powers of two, whose strengths are scaled with it.
BOOST_AUTO_TEST_CASE(moves_alike_to_the_last_bit_when_scaled_by_powers_of_two) {
  const Scales by{.length = 8.0, .time = 0.25, .mass = 2.0};
  const CentralForce law{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 2.0, .beta2 = 3.0};
  const CentralForce big_law = scaled(law, by);
  const Scene small(two_particles(), Open{}, NearField{law.alpha1, law.alpha2, law.beta1, law.beta2});
  const Scene big(scaled(two_particles(), by), Open{},
                  NearField{big_law.alpha1, big_law.alpha2, big_law.beta1, big_law.beta2, by.length});
  Motion state = start(small), image = start(big);
  VelocityVerlet scheme, its_scheme;
  FixedStep control{.step = 0.01}, its_control{.step = 0.01 * by.time};
  BOOST_TEST(integrate(small, state, 0.3, scheme, control).steps == 30);
  BOOST_TEST(integrate(big, image, 0.3 * by.time, its_scheme, its_control).steps == 30);
  BOOST_TEST(close(image.r, by.length * state.r, {}));
  BOOST_TEST(close(image.v, (by.length / by.time) * state.v, {}));
  BOOST_TEST(!close(state.r, start(small).r, {.absolute = 0.01}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(start_)

BOOST_AUTO_TEST_CASE(reads_positions_and_velocities_column_by_column) {
  const Scene scene(two_particles(), Open{});
  const Motion state = start(scene);
  Eigen::VectorXd r(6), v(6);
  r << 1.0, 3.0, 2.0, 2.0, 3.0, 3.0;
  v << 0.5, 0.0, 0.0, 0.25, -1.0, 2.0;
  BOOST_TEST(state.t == 0.0);
  BOOST_TEST(close(state.r, r, {}));
  BOOST_TEST(close(state.v, v, {}));
}

BOOST_AUTO_TEST_SUITE_END()
