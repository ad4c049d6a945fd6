#include <particulate/scenes/scene.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "clouds.hpp"
#include "problems.hpp"

namespace tests::scene_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::scenes;
using namespace particulate::schemes;

// A uniform field along -z that grows with time; its potential is that of the moment.
struct Weight {
  double g;
};
bool add_force(const Weight& law, const Space&, const At<>& at, Forces force) {
  force.col(2) -= law.g * (1.0 + at.t) * at.mass;
  return true;
}
double potential_energy(const Weight& law, const Space&, const At<>& at) {
  return law.g * (1.0 + at.t) * at.mass.dot(at.position.col(2));
}
void validate(const Weight& law) {
  if (!(law.g >= 0.0)) throw std::invalid_argument("weight: g must not be negative");
}

struct Drag {
  double c;
};
template <class D>
bool add_force(const Drag& law, const D&, const At<Velocity>& at, Forces force) {
  force -= law.c * at.velocity;
  return true;
}

// Slows what is faster than allowed.
struct SpeedLimit {
  double most;
};
template <class D>
Jump jump(const SpeedLimit& law, const D&, const At<Velocity>& at, double, Out velocity) {
  Jump done;
  Forces v(velocity.data(), at.mass.size(), 3);
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const double speed = v.row(i).norm();
    if (!(speed > law.most)) continue;
    v.row(i) *= law.most / speed;
    done.energy_change += 0.5 * at.mass[i] * (law.most - speed) * (law.most + speed);
    ++done.impacts;
  }
  return done;
}

// Has no value outside a slab.
struct Slab {};
bool add_force(const Slab&, const Space&, const At<>& at, Forces) { return (at.position.col(0).array() < 10.0).all(); }

template <class S>
concept HasPotential = requires(const S& scene, const State& state) {
  scene.potential_energy(state);
};

using Falling = Scene<Space, Weight>;
using Dragged = Scene<Space, Weight, Drag>;
using Colliding = Scene<Space, Gravity, Contact<>>;

static_assert(PositionProblem<Falling> && !MotionProblem<Falling> && !Falling::needs_velocity);
static_assert(MotionProblem<Dragged> && !PositionProblem<Dragged> && Dragged::needs_velocity);
static_assert(MotionProblem<Scene<Space, Drag, Weight>>, "whichever law comes first");
static_assert(PositionProblem<const Falling> && MotionProblem<const Dragged>, "a scene is not changed by its motion");
static_assert(PositionProblem<Scene<Space>>, "no law at all is a law of free flight");
static_assert(Measures<Falling> && Measures<Dragged>);
static_assert(HasPotential<Scene<Space>> && HasPotential<Falling> && HasPotential<Scene<Space, NearField, Weight>>);
static_assert(HasPotential<Colliding>, "a contact stores no energy");
static_assert(!HasPotential<Dragged> && !HasPotential<Scene<Space, Weight, Slab>>,
              "one law without a potential is enough");

static_assert(Jumps<Colliding> && Jumps<const Colliding> && Colliding::jumping_laws == 1);
static_assert(PositionProblem<Colliding>, "a contact asks for velocities after steps, not within them");
static_assert(!Jumps<Falling> && !Jumps<Dragged> && Falling::jumping_laws == 0,
              "a scene without contact does not jump");
static_assert(MotionProblem<Scene<Space, Drag, Contact<Restitution, Friction>>>);
static_assert(Jumps<Scene<Space, SpeedLimit>> && Scene<Space, SpeedLimit>::jumping_laws == 1);
static_assert(Scene<Space, SpeedLimit, Gravity, Contact<>>::jumping_laws == 2);
static_assert(PositionProblem<Scene<Space, SpeedLimit>>, "a limit is no force");

Particles two_particles() {
  return {.position = Vectors{{1.0, 2.0, 3.0}, {3.0, 2.0, 3.0}},
          .velocity = Vectors{{0.5, 0.0, -1.0}, {0.0, 0.25, 2.0}},
          .mass = Eigen::Vector2d(2.0, 3.0),
          .radius = Eigen::Vector2d(0.5, 0.5)};
}

Particles no_particles() { return {Vectors(0, 3), Vectors(0, 3), Eigen::VectorXd(0), Eigen::VectorXd(0)}; }

// At a distance of 2 it pulls with 6 (1/2 - 0.5/4) = 2.25.
const NearField monograph{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 1.0, .beta2 = 2.0};

// A sphere of radius 0.5 and mass 2 whose centre lies h above the floor z = 0.
Particles ball(double h, const Eigen::RowVector3d& velocity) {
  return {.position = Vectors{{0.0, 0.0, h}},
          .velocity = velocity,
          .mass = Eigen::VectorXd::Constant(1, 2.0),
          .radius = Eigen::VectorXd::Constant(1, 0.5)};
}
const Space floor_at_zero{{Wall{}}};

// Unit spheres in a row that touch, the first on its way to the others at 1 m/s.
Particles cradle() {
  Particles row{.position = Vectors::Zero(5, 3),
                .velocity = Vectors::Zero(5, 3),
                .mass = Eigen::VectorXd::Ones(5),
                .radius = Eigen::VectorXd::Ones(5)};
  row.position.col(0) = Eigen::VectorXd::LinSpaced(5, 0.0, 8.0);
  row.velocity(0, 0) = 1.0;
  return row;
}

template <class S>
Eigen::VectorXd total_force(const S& scene) {
  Eigen::VectorXd f(3 * scene.particles().size());
  BOOST_TEST(scene.total_force(start(scene), f));
  return f;
}

BOOST_AUTO_TEST_SUITE(Scene_)

BOOST_AUTO_TEST_CASE(checks_its_particles_and_its_laws) {
  Particles bad = two_particles();
  bad.mass[1] = -1.0;
  CHECK_REFUSED(Scene(bad, Space{}, Weight{1.0}), "masses must be positive");
  CHECK_REFUSED(Scene(two_particles(), Space{}, Drag{1.0}, Weight{-1.0}), "weight: g must not be negative");
  CHECK_REFUSED(Scene(two_particles(), Space{}, Weight{1.0}, NearField{.beta1 = -2.0}),
                "beta1 must be finite and at least -1");
  BOOST_CHECK_NO_THROW(Scene(two_particles(), Space{}, Drag{-1.0}));  // a law without validate() is taken as it is
}

BOOST_AUTO_TEST_CASE(keeps_its_particles) {
  const Scene scene(two_particles(), Space{}, Weight{1.0});
  BOOST_TEST(close(scene.particles().position, two_particles().position, {}));
  BOOST_TEST(close(scene.particles().mass, two_particles().mass, {}));
}

BOOST_AUTO_TEST_CASE(shows_each_of_its_laws) {
  const Scene scene(two_particles(), Space{}, monograph, Weight{2.0}, Drag{0.25});
  BOOST_TEST((scene.law<Weight>().g == 2.0 && scene.law<Drag>().c == 0.25));
  BOOST_TEST(&scene.law<NearField>() == &scene.law<NearField>());
  BOOST_TEST(scene.law<NearField>().alpha2 == 0.5);
}

// Weight 2 m (1 + t) at t = 0 is 4 and 6; along x the near field's 2.25.
BOOST_AUTO_TEST_CASE(adds_the_forces_of_its_laws) {
  const Scene scene(two_particles(), Space{}, monograph, Weight{2.0});
  Eigen::VectorXd expected(6);
  expected << 2.25, -2.25, 0.0, 0.0, -4.0, -6.0;
  BOOST_TEST(close(total_force(scene), expected, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(gives_velocities_to_the_law_that_asks_and_places_to_the_other) {
  const Scene scene(two_particles(), Space{}, Weight{2.0}, Drag{4.0});
  Eigen::VectorXd expected(6);
  expected << -2.0, 0.0, 0.0, -1.0, -4.0 + 4.0, -6.0 - 8.0;
  BOOST_TEST(close(total_force(scene), expected, {}));
}

BOOST_AUTO_TEST_CASE(starts_its_sum_from_nothing) {
  const Scene scene(two_particles(), Space{}, Weight{2.0});
  Eigen::VectorXd f = Eigen::VectorXd::Constant(6, not_a_number);
  BOOST_TEST(scene.total_force(start(scene), f));
  BOOST_TEST(f.allFinite());
}

// g (1 + t) = 6 at t = 2, whatever the mass; 2.25/2 and 2.25/3.
BOOST_AUTO_TEST_CASE(divides_by_each_particles_own_mass_at_its_own_time) {
  const Scene scene(two_particles(), Space{}, monograph, Weight{2.0});
  const State state = start(scene);
  Eigen::VectorXd a(6), expected(6);
  BOOST_TEST(scene.acceleration(2.0, state.r, a));
  expected << 1.125, -0.75, 0.0, 0.0, -6.0, -6.0;
  BOOST_TEST(close(a, expected, {.relative = 1e-15}));
  const Scene dragged(two_particles(), Space{}, Drag{6.0});
  BOOST_TEST(dragged.acceleration(0.0, state.r, state.v, a));
  expected << -1.5, 0.0, 0.0, -0.5, 3.0, -4.0;
  BOOST_TEST(close(a, expected, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(has_no_value_where_one_of_its_laws_has_none) {
  Particles outside = two_particles();
  outside.position(1, 0) = 11.0;
  Eigen::VectorXd a(6);
  const Scene first(outside, Space{}, Slab{}, Weight{1.0});
  const Scene last(outside, Space{}, Weight{1.0}, Slab{});
  BOOST_TEST(!first.acceleration(0.0, start(first).r, a));
  BOOST_TEST(!last.acceleration(0.0, start(last).r, a));
  BOOST_TEST(!last.total_force(start(last), a));
  Particles together = two_particles();
  together.position.row(1) = together.position.row(0);
  const Scene coincident(together, Space{}, monograph);
  BOOST_TEST(!coincident.acceleration(0.0, start(coincident).r, a));
}

BOOST_AUTO_TEST_CASE(has_no_value_where_an_acceleration_is_too_large) {
  Particles light = two_particles();
  light.mass[0] = 1e-300;
  const Scene scene(light, Space{}, NearField{.alpha1 = 1e300, .scaling = particulate::laws::Scaling::pair});
  Eigen::VectorXd a(6);
  BOOST_TEST(scene.total_force(start(scene), a));
  BOOST_TEST(!scene.acceleration(0.0, start(scene).r, a));
}

BOOST_AUTO_TEST_CASE(refuses_vectors_of_another_length) {
  const Scene scene(two_particles(), Space{}, Weight{1.0});
  const Eigen::VectorXd right = Eigen::VectorXd::Zero(6), wrong = Eigen::VectorXd::Zero(5);
  Eigen::VectorXd a(6), short_a(3);
  CHECK_REFUSED(scene.acceleration(0.0, wrong, a), "vectors of 2 particles must hold 6 numbers, got 5");
  CHECK_REFUSED(scene.acceleration(0.0, right, short_a), "got 3");
  CHECK_REFUSED(scene.distance(right, wrong), "got 5");
}

// ln 2 - 0.25 per unit mass squared, and g (2 3 + 3 3) = 30.
BOOST_AUTO_TEST_CASE(adds_the_potential_energies_of_its_laws) {
  const Scene scene(two_particles(), Space{}, monograph, Weight{2.0});
  const double ln2 = 0.693147180559945309;
  BOOST_TEST(scene.potential_energy(start(scene)) == 6.0 * (ln2 - 0.25) + 30.0, tolerance(1e-15));
  const Scene free(two_particles(), Space{});
  BOOST_TEST(free.potential_energy(start(free)) == 0.0);
}

// As each alone: a near field in one pass, a weight after it.
BOOST_AUTO_TEST_CASE(adds_forces_and_energies_at_once) {
  Particles row{.position = Vectors::Zero(12, 3),
                .velocity = Vectors::Zero(12, 3),
                .mass = Eigen::VectorXd::Ones(12),
                .radius = Eigen::VectorXd::Zero(12)};
  row.position.col(0) = Eigen::VectorXd::LinSpaced(12, 0.0, 11.0);
  row.position.col(2) = row.position.col(0).cwiseAbs2();
  const Scene scene(row, Space{}, monograph, Weight{2.0});
  Eigen::VectorXd f(36);
  double energy = not_a_number;
  BOOST_TEST(scene.total_force(start(scene), f, energy));
  BOOST_TEST((f == total_force(scene)));
  BOOST_TEST(energy == scene.potential_energy(start(scene)), tolerance(1e-14));
}

// (3, 4, 0) and (0, 0, 2): 5 + 2. A flat norm would make sqrt 29 or 9 of it.
BOOST_AUTO_TEST_CASE(measures_by_the_sum_over_particles) {
  const Scene scene(two_particles(), Space{});
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6), y = x;
  x << 3.0, 0.0, 4.0, 0.0, 0.0, 2.0;
  BOOST_TEST(scene.distance(x, y) == 7.0);
  BOOST_TEST(scene.distance(y, x) == 7.0);
  BOOST_TEST(scene.distance(x, x) == 0.0);
}

BOOST_AUTO_TEST_CASE(without_particles_and_without_laws_is_a_scene) {
  const Scene empty(no_particles(), Space{}, monograph, Weight{1.0});
  Eigen::VectorXd none(0);
  BOOST_TEST(empty.acceleration(0.0, none, none));
  BOOST_TEST(empty.potential_energy(start(empty)) == 0.0);
  const Scene free(two_particles(), Space{});
  BOOST_TEST(close(total_force(free), Eigen::VectorXd::Zero(6), {}));
}

// Thirty steps of the scene and of its image under powers of two, whose strengths are scaled with it.
BOOST_AUTO_TEST_CASE(moves_alike_to_the_last_bit_when_scaled_by_powers_of_two) {
  const Scales by{.length = 8.0, .time = 0.25, .mass = 2.0};
  const CentralForce law{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 2.0, .beta2 = 3.0};
  const CentralForce big_law = scaled(law, by);
  const Scene small(two_particles(), Space{}, NearField{law.alpha1, law.alpha2, law.beta1, law.beta2});
  const Scene big(scaled(two_particles(), by), Space{},
                  NearField{big_law.alpha1, big_law.alpha2, big_law.beta1, big_law.beta2, by.length});
  State state = start(small), image = start(big);
  VelocityVerlet scheme, its_scheme;
  FixedStep control{.step = 0.01}, its_control{.step = 0.01 * by.time};
  BOOST_TEST(integrate(small, state, 0.3, scheme, control).steps == 30);
  BOOST_TEST(integrate(big, image, 0.3 * by.time, its_scheme, its_control).steps == 30);
  BOOST_TEST(close(image.r, by.length * state.r, {}));
  BOOST_TEST(close(image.v, (by.length / by.time) * state.v, {}));
  BOOST_TEST(!close(state.r, start(small).r, {.absolute = 0.01}));
}

// Scenes keep working memory from call to call: a copy has its own, so that steps of one do not show in the other.
BOOST_AUTO_TEST_CASE(copied_runs_to_the_same_bits_whatever_the_original_does_meanwhile) {
  const auto advance = [](const auto& scene, State& state, double t_end) {
    BOOST_TEST((run(scene, state, t_end, VelocityVerlet(), FixedStep{.step = 0.01}).status == Status::reached));
  };
  const Scene scene(cradle(), Space{}, NearField{.alpha1 = 0.1, .alpha2 = 0.2}, Contact{});
  State whole = start(scene);
  advance(scene, whole, 0.4);
  const Scene copy = scene;
  State by_scene = start(scene), by_copy = start(copy);
  for (const double t_end : {0.2, 0.4}) {
    advance(scene, by_scene, t_end);
    advance(copy, by_copy, t_end);
  }
  advance(scene, by_scene, 0.5);
  advance(copy, by_copy, 0.5);
  advance(scene, whole, 0.5);
  BOOST_TEST(close(flat(by_copy), flat(by_scene), {}));
  BOOST_TEST(close(by_copy.r, whole.r, {}));
  BOOST_TEST(!close(by_copy.r, start(scene).r, {.absolute = 0.01}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(start_)

BOOST_AUTO_TEST_CASE(reads_positions_and_velocities_column_by_column) {
  const Scene scene(two_particles(), Space{});
  const State state = start(scene);
  Eigen::VectorXd r(6), v(6);
  r << 1.0, 3.0, 2.0, 2.0, 3.0, 3.0;
  v << 0.5, 0.0, 0.0, 0.25, -1.0, 2.0;
  BOOST_TEST(state.t == 0.0);
  BOOST_TEST(close(state.r, r, {}));
  BOOST_TEST(close(state.v, v, {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(immovable)

// Without flags the near field would move them.
BOOST_AUTO_TEST_CASE(particles_are_not_accelerated_but_pull_with_their_mass) {
  Particles held = two_particles();
  held.immovable = {true, false};
  const Scene scene(held, Space{}, monograph, Drag{6.0});
  Eigen::VectorXd a(6), expected(6), f(6);
  BOOST_TEST(scene.acceleration(0.0, start(scene).r, start(scene).v, a));
  expected << 0.0, -0.75, 0.0, -0.5, 0.0, -4.0;
  BOOST_TEST(close(a, expected, {.relative = 1e-15}));
  BOOST_TEST(scene.total_force(start(scene), f));
  BOOST_TEST(f[0] == 2.25 - 3.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(flags_are_checked) {
  Particles held = two_particles();
  held.immovable = {true};
  CHECK_REFUSED(Scene(held, Space{}), "immovable must be empty or hold one entry");
}

// The second sphere overlaps an immovable first: at e = 0.5 it turns, and takes all the change of energy.
BOOST_AUTO_TEST_CASE(particles_send_others_back) {
  Particles held = two_particles();
  held.position(1, 0) = 1.75;
  held.velocity = Vectors{{0.0, 0.0, 0.0}, {-2.0, 1.0, 0.0}};
  held.immovable = {true, false};
  const Scene scene(held, Space{}, Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Jump jump = scene.jump(state, 0.1);
  Eigen::VectorXd expected(6);
  expected << 0.0, 1.0, 0.0, 1.0, 0.0, 0.0;
  BOOST_TEST(close(state.v, expected, {}));
  BOOST_TEST(jump.energy_change == 0.5 * 3.0 * (1.0 - 4.0), tolerance(1e-15));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Space_)

BOOST_AUTO_TEST_CASE(domain_is_checked) {
  const Space crooked{{Wall{.normal = {0.0, 0.0, 2.0}}}};
  CHECK_REFUSED(Scene(ball(1.0, {0.0, 0.0, 0.0}), crooked, Gravity{}),
                "wall 0: its normal must be a unit vector, got (0, 0, 2) of length 2");
}

BOOST_AUTO_TEST_CASE(periods_hold_two_diameters_and_the_reach_of_every_law_twice) {
  const Space narrow{.lengths = {infinity, 1.9, infinity}}, wide{.lengths = {infinity, 4.0, infinity}};
  CHECK_REFUSED(Scene(two_particles(), narrow, Contact<>{}),
                "space: its length in direction y must be at least two diameters of the largest body, 2 m");
  CHECK_REFUSED(Scene(two_particles(), wide, monograph), "must reach no farther than half the shortest period, 2 m");
  NearField near = monograph;
  near.cutoff = 2.0;
  BOOST_CHECK_NO_THROW(Scene(two_particles(), wide, near));
}

// Across two faces: (0.2, 0, 0.3) apart.
BOOST_AUTO_TEST_CASE(spacing_is_that_of_the_nearest_images) {
  Particles pair = two_particles();
  pair.radius.setConstant(0.1);
  pair.position << 0.1, 5.0, 0.1, 9.9, 5.0, 9.8;
  const Space box{.lengths = {10.0, 10.0, 10.0}};
  const Scene two(pair, box, Contact<>{});
  BOOST_TEST(two.spacing(start(two).r) == std::sqrt(0.13), tolerance(1e-13));
  // Of many, one pair of which is nearest across a face.
  Particles many = random_cloud(300, {10.0, 10.0, 10.0}, 0.01, 0.01);
  many.position.row(17) << 0.001, 5.0, 5.0;
  many.position.row(211) << 9.999, 5.0, 5.001;
  const Scene cloud(many, box, Contact<>{}), open(many, Space{}, Contact<>{});
  BOOST_TEST(cloud.spacing(start(cloud).r) == std::sqrt(5e-6), tolerance(1e-9));
  double nearest = infinity;
  for (Eigen::Index i = 0; i < 300; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      nearest = std::min(nearest, (many.position.row(i) - many.position.row(j)).norm());
    }
  }
  BOOST_TEST(open.spacing(start(open).r) == nearest, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(periods_let_bodies_meet_across_a_corner) {
  Particles pair = two_particles();
  pair.position << 0.5, 0.5, 0.5, 9.5, 9.5, 9.5;
  pair.velocity << -1.0, -1.0, -1.0, 0.0, 0.0, 0.0;
  const Scene scene(pair, Space{.lengths = {10.0, 10.0, 10.0}}, LocatedContact<>{});
  State state = start(scene);
  VelocityVerlet scheme;
  FixedStep control{.step = 0.1};
  const Outcome outcome = integrate(scene, state, 2.0, scheme, control);
  BOOST_TEST(outcome.impacts == 1);
  BOOST_TEST(close(velocities(state).transpose() * pair.mass, Eigen::Vector3d(-2.0, -2.0, -2.0), {1e-14, 0.0}));
  // A gap of sqrt(3) - 1 closes at sqrt(3); then 2.4/5 of the speed stays with the second, of mass 3.
  BOOST_TEST(velocity(state, 1).x() == -0.8, tolerance(1e-12));
}

// Half of a run in a copy, whose neighbours begin anew.
BOOST_AUTO_TEST_CASE(continued_by_a_copy_has_the_same_bits) {
  const Particles cloud = random_cloud(300, {1.0, 1.0, 1.0}, 0.02, 0.04);
  NearField near = monograph;
  near.cutoff = 0.2, near.taper = 0.1, near.alpha1 = 1e-6, near.alpha2 = 1e-8;
  const Scene scene(cloud, Space{.walls = {Wall{}}, .lengths = {1.0, 1.0, infinity}}, near,
                    Contact<>{.restitution = {0.9}});
  const auto run = [](const auto& whose, State& state, double t_end) {
    VelocityVerlet scheme;
    FixedStep control{.step = 1e-3};
    return integrate(whose, state, t_end, scheme, control).impacts;
  };
  State state = start(scene);
  BOOST_TEST(run(scene, state, 0.05) > 10);
  State other = state;
  const auto copy = scene;
  BOOST_TEST(run(scene, state, 0.1) == run(copy, other, 0.1));
  BOOST_TEST((state.r == other.r && state.v == other.v));
}

BOOST_AUTO_TEST_CASE(domain_is_not_felt_by_near_fields) {
  const Scene open(two_particles(), Space{}, monograph);
  const Scene walled(two_particles(), floor_at_zero, monograph);
  BOOST_TEST(close(total_force(open), total_force(walled), {}));
  BOOST_TEST(open.potential_energy(start(open)) == walled.potential_energy(start(walled)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(jump_)

BOOST_AUTO_TEST_CASE(checks_its_law) {
  CHECK_REFUSED(Scene(two_particles(), Space{}, Contact{.restitution = ConstantRestitution{-0.5}}),
                "e must lie in [0, 1], got -0.5");
  CHECK_REFUSED(Scene(two_particles(), Space{}, Contact{.gamma = 2.0}), "gamma must lie in [0, 1), got 2");
}

// The normal part of (1, 0, -2) turns at e = 0.5; a position does not change.
BOOST_AUTO_TEST_CASE(bounces_off_a_wall) {
  const Scene scene(ball(0.375, {1.0, 0.0, -2.0}), floor_at_zero, Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Jump jump = scene.jump(state, 0.1);
  BOOST_TEST(close(state.v, Eigen::Vector3d(1.0, 0.0, 1.0), {}));
  BOOST_TEST(close(state.r, start(scene).r, {}));
  BOOST_TEST(jump.impacts == 1);
  BOOST_TEST(jump.overlap == 0.125);
  BOOST_TEST(jump.energy_change == -3.0);
  BOOST_TEST(jump.evaluations == 1);
  BOOST_TEST(jump.unsettled.empty());
}

// |J| = 2 1.5 2 = 6, so mu_d = 0.1 takes 0.6/2 m/s of the sliding.
BOOST_AUTO_TEST_CASE(rubs_on_a_wall) {
  const Contact law{.restitution = ConstantRestitution{0.5}, .friction = Friction{.mu_s = 0.1, .mu_d = 0.1}};
  const Scene scene(ball(0.375, {1.0, 0.0, -2.0}), floor_at_zero, law);
  State state = start(scene);
  BOOST_TEST(scene.jump(state, 0.1).impacts == 1);
  BOOST_TEST(close(state.v, Eigen::Vector3d(0.7, 0.0, 1.0), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(turns_in_a_corner) {
  const Space corner{{Wall{}, Wall{.point = {-0.25, 0.0, 0.0}, .normal = {1.0, 0.0, 0.0}}}};
  const Scene scene(ball(0.375, {-4.0, 3.0, -2.0}), corner, Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Jump jump = scene.jump(state, 0.1);
  BOOST_TEST(close(state.v, Eigen::Vector3d(2.0, 3.0, 1.0), {}));
  BOOST_TEST(jump.impacts == 2);
  BOOST_TEST(jump.overlap == 0.25);
}

// Even far behind a wall: what leaves is not sent back, and no force is asked for.
BOOST_AUTO_TEST_CASE(leaves_alone_what_is_on_its_way_out) {
  for (const double h : {0.25, -3.0}) {
    const Scene scene(ball(h, {1.0, 0.0, 2.0}), floor_at_zero, Gravity{}, Contact{});
    State state = start(scene);
    const Jump jump = scene.jump(state, 0.1);
    BOOST_TEST(close(state.v, Eigen::Vector3d(1.0, 0.0, 2.0), {}));
    BOOST_TEST(jump.impacts == 0);
    BOOST_TEST(jump.overlap == 0.5 - h);
    BOOST_TEST(jump.evaluations == 0);
    BOOST_TEST(jump.energy_change == 0.0);
  }
}

// Delta_1 = 10 0.01 0.5/1.5 = 1/30: the ball leaves with 0.5 2 + 1.5/30.
BOOST_AUTO_TEST_CASE(counts_in_the_forces_of_the_other_laws) {
  const Scene scene(ball(0.375, {0.0, 0.0, -2.0}), floor_at_zero, Gravity{{0.0, 0.0, -10.0}},
                    Contact{.restitution = ConstantRestitution{0.5}, .gamma = 0.01});
  State state = start(scene);
  BOOST_TEST(scene.jump(state, 0.5).evaluations == 1);
  BOOST_TEST(state.v[2] == 1.05, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(shows_velocities_to_the_law_that_asks) {
  const Scene scene(ball(0.375, {0.0, 0.0, -2.0}), floor_at_zero, Drag{10.0},
                    Contact{.restitution = ConstantRestitution{0.5}, .gamma = 0.01});
  State state = start(scene);
  BOOST_TEST(scene.jump(state, 0.5).impacts == 1);
  BOOST_TEST(state.v[2] == 0.95, tolerance(1e-14));  // the drag gives +10 m/s^2
}

// The limit sees what contact left, and nothing where contact could not be settled.
BOOST_AUTO_TEST_CASE(is_made_by_one_law_after_the_other) {
  const Contact contact{.restitution = ConstantRestitution{0.5}};
  const Scene scene(ball(0.375, {0.0, 0.0, -4.0}), floor_at_zero, contact, SpeedLimit{1.0});
  State state = start(scene);
  const Jump jump = scene.jump(state, 0.1);  // to 2 m/s, then to 1
  BOOST_TEST(close(state.v, Eigen::Vector3d(0.0, 0.0, 1.0), {}));
  BOOST_TEST(jump.impacts == 2);
  BOOST_TEST(jump.energy_change == 1.0 - 16.0);
  BOOST_TEST(jump.overlap == 0.125);
  BOOST_TEST(jump.evaluations == 1);
  BOOST_REQUIRE(jump.by_law.size() == 2U);
  BOOST_TEST(jump.by_law[0].energy_change == 4.0 - 16.0);
  BOOST_TEST(jump.by_law[1].energy_change == 1.0 - 4.0);

  Particles together = two_particles();
  together.position.row(1) = together.position.row(0);
  const Scene coincident(together, Space{}, contact, SpeedLimit{0.1});
  state = start(coincident);
  BOOST_TEST(!coincident.jump(state, 0.1).unsettled.empty());
  BOOST_TEST(close(state.v, start(coincident).v, {}));
}

BOOST_AUTO_TEST_CASE(is_unsettled_where_forces_have_no_value_or_centres_coincide) {
  Particles outside = two_particles();
  outside.position << 11.0, 0.0, 0.0, 11.5, 0.0, 0.0;
  const Scene valueless(outside, Space{}, Slab{}, Contact{});
  State state = start(valueless);
  BOOST_TEST(valueless.jump(state, 0.1).unsettled == "the forces have no value where bodies touch");
  BOOST_TEST(close(state.v, start(valueless).v, {}));
  outside.position.row(1) = outside.position.row(0);
  const Scene coincident(outside, Space{}, Contact{});
  state = start(coincident);
  BOOST_TEST(coincident.jump(state, 0.1).unsettled.find("particles 0 and 1 touch with the same centre") == 0U);
}

BOOST_AUTO_TEST_CASE(refuses_vectors_of_another_length) {
  const Scene scene(two_particles(), Space{}, Contact{});
  State state = start(scene);
  state.v.resize(3);
  CHECK_REFUSED(scene.jump(state, 0.1), "must hold 6 numbers, got 3");
}

BOOST_AUTO_TEST_CASE(does_nothing_without_particles) {
  const Scene empty(no_particles(), floor_at_zero, Gravity{}, Contact{});
  State state = start(empty);
  BOOST_TEST(empty.jump(state, 0.1).impacts == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(integrate_)

// Sequential contacts pass the hit on in one step; summed ones need a step each, after which the next pair overlaps.
BOOST_AUTO_TEST_CASE(lets_a_cradle_swing) {
  for (const Resolution order : {Resolution::sequential, Resolution::summed}) {
    const Scene scene(cradle(), Space{}, Contact<>{.resolution = order});
    State state = start(scene);
    const Outcome outcome = run(scene, state, 0.1, VelocityVerlet(), FixedStep{.step = 0.01});
    BOOST_TEST((outcome.status == Status::reached));
    BOOST_TEST(outcome.impacts == 4);
    BOOST_TEST(outcome.energy_change == 0.0);
    BOOST_TEST(state.v[4] == 1.0);
    BOOST_TEST(outcome.overlap == 0.01, tolerance(1e-12));
    // Until the last moves, one step of the first, and of each that takes the hit over, passed.
    BOOST_TEST(state.r[4] == (order == Resolution::sequential ? 8.09 : 8.06), tolerance(1e-14));
  }
}

// From z = 1 at 4 m/s without gravity, steps of 0.0625: the floor is reached at 0.5 exactly after two, so the ball
// turns there; e = 0.5 leaves 2 m/s.
BOOST_AUTO_TEST_CASE(reports_impacts_overlap_and_energy) {
  const Scene scene(ball(1.0, {0.0, 0.0, -4.0}), floor_at_zero, Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 0.5, VelocityVerlet(), FixedStep{.step = 0.0625});
  BOOST_TEST(outcome.impacts == 1);
  BOOST_TEST(outcome.energy_change == 4.0 - 16.0);
  BOOST_TEST(outcome.overlap == 0.0);
  BOOST_TEST(state.r[2] == 0.5 + 6 * 0.0625 * 2.0);
}

// Limited to 3 m/s at the end of the first step, 16 J become 9 (at z = 0.75); two steps later contact at z = 0.375
// makes 2.25 of them, and 1.5 m/s.
BOOST_AUTO_TEST_CASE(reports_what_each_law_that_jumps_did) {
  const Contact contact{.restitution = ConstantRestitution{0.5}};
  const auto outcome_of = [](const auto& scene) {
    State state = start(scene);
    const Outcome outcome = run(scene, state, 0.5, VelocityVerlet(), FixedStep{.step = 0.0625});
    BOOST_TEST(state.r[2] == 0.375 + 5 * 0.0625 * 1.5);
    BOOST_TEST(outcome.impacts == 2);
    BOOST_TEST(outcome.energy_change == -13.75);
    BOOST_TEST(outcome.overlap == 0.125);
    return outcome;
  };
  const Particles falling = ball(1.0, {0.0, 0.0, -4.0});
  const Outcome contact_first = outcome_of(Scene(falling, floor_at_zero, contact, SpeedLimit{3.0}));
  const Outcome limit_first = outcome_of(Scene(falling, floor_at_zero, SpeedLimit{3.0}, contact));
  BOOST_REQUIRE(contact_first.jumps_by_law.size() == 2U);
  BOOST_REQUIRE(limit_first.jumps_by_law.size() == 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(contact_first.jumps_by_law[k].impacts == 1);
    BOOST_TEST(contact_first.jumps_by_law[k].energy_change == (k == 0 ? -6.75 : -7.0));
    BOOST_TEST(limit_first.jumps_by_law[k].energy_change == (k == 0 ? -7.0 : -6.75));
  }
  const Scene alone(falling, floor_at_zero, contact);
  State state = start(alone);
  // All of it is this law's.
  BOOST_TEST(run(alone, state, 0.5, VelocityVerlet(), FixedStep{.step = 0.0625}).jumps_by_law.empty());
}

// 4 m/s for steps of 1 s pass a body of radius 0.5 unseen.
BOOST_AUTO_TEST_CASE(says_that_a_start_overlaps_and_that_a_step_was_too_long) {
  Particles pair = two_particles();
  pair.position = Vectors{{0.0, 0.0, 0.0}, {0.9, 0.0, 0.0}};
  pair.velocity = Vectors{{2e4, 0.0, 0.0}, {2e4 + 4.0, 0.0, 0.0}};
  const Scene scene(pair, Space{}, Contact{});
  State state = start(scene);
  Outcome outcome = run(scene, state, 2.0, VelocityVerlet(), FixedStep{.step = 1.0});
  BOOST_TEST(outcome.overlap_at_start == 0.1, tolerance(1e-14));
  BOOST_TEST(outcome.contacts_at_start == 1);
  BOOST_TEST(outcome.travel == 4.0);
  BOOST_TEST(outcome.overlap == 0.0);
  outcome = run(scene, state, 2.1, VelocityVerlet(), FixedStep{.step = 0.1});
  BOOST_TEST(outcome.overlap_at_start == 0.0);
  BOOST_TEST(outcome.contacts_at_start == 0);
  BOOST_TEST(outcome.travel == 0.4, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(names_the_particles_that_have_no_force) {
  Particles together = two_particles();
  together.position.row(1) = together.position.row(0);
  const Scene scene(together, Space{}, Weight{1.0}, NearField{.alpha1 = 1.0});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.1});
  BOOST_TEST((outcome.failure == Failure::no_value));
  BOOST_TEST(contains(outcome.reason, "near field: particles 0 and 1 must be"), outcome.reason);
  together.immovable = {true, true};
  const Scene fixed(together, Space{}, Weight{1.0}, NearField{.alpha1 = 1.0}, Contact{});
  state = start(fixed);
  BOOST_TEST((run(fixed, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.1}).status == Status::reached));
}

BOOST_AUTO_TEST_CASE(fails_where_a_jump_is_not_settled) {
  Particles together = two_particles();
  together.position = Vectors{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}};
  together.velocity = Vectors{{2.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}};
  const Scene scene(together, Space{}, Contact{});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 2.0, VelocityVerlet(), FixedStep{.step = 1.0});
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST(outcome.reason.find("particles 0 and 1 touch with the same centre") == 0U);
  BOOST_TEST(outcome.overlap == 1.0);
}

// A ball that rests: after each step it approaches with u = g Dt - u_out, u_out = e u + gamma g Dt, so
// u = (1 - gamma) g Dt/(1 + e), and sinks by u Dt - g Dt^2/2 a step. It never has more energy than at the start.
BOOST_AUTO_TEST_CASE(gains_no_energy_in_a_resting_contact) {
  const double g = 9.81, dt = 1e-3, gamma = 0.01;
  for (const double e : {0.0, 0.5, 0.9}) {
    const Scene scene(ball(0.5, {0.0, 0.0, 0.0}), floor_at_zero, Gravity{{0.0, 0.0, -g}},
                      Contact{.restitution = ConstantRestitution{e}, .gamma = gamma});
    State state = start(scene);
    const double energy = scene.potential_energy(state);
    double most = -1.0, last_sink = 0.0, approach = 0.0;
    const auto observe = [&](const State& from, const State& to, double, const VelocityVerlet&) {
      most = std::max(most, from.v.squaredNorm() + scene.potential_energy(from) - energy);
      last_sink = from.r[2] - to.r[2];
      approach = -to.v[2];
      return true;
    };
    const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = dt}, observe);
    BOOST_TEST((outcome.status == Status::reached));
    BOOST_TEST(most <= 1e-12);
    BOOST_TEST(approach == (1.0 - gamma) * g * dt / (1.0 + e), tolerance(1e-9));
    BOOST_TEST(last_sink == 0.5 * g * dt * dt * (1.0 - e - 2.0 * gamma) / (1.0 + e), tolerance(1e-8));
  }
}

// Falls by g Dt^2/2 in the first step, and stays there.
BOOST_AUTO_TEST_CASE(holds_what_rests) {
  const double g = 9.81, dt = 1e-3;
  for (const double e : {0.0, 0.5, 1.0}) {
    const Scene scene(ball(0.5, {0.0, 0.0, 0.0}), floor_at_zero, Gravity{{0.0, 0.0, -g}},
                      Contact{.restitution = ConstantRestitution{e}});
    State state = start(scene);
    const Outcome outcome = run(scene, state, 1.0, RungeKutta4(), FixedStep{.step = dt});
    BOOST_TEST((outcome.status == Status::reached));
    BOOST_TEST(0.5 - state.r[2] == 0.5 * g * dt * dt, tolerance(1e-7));
    BOOST_TEST(state.v[2] == 0.5 * g * dt, tolerance(1e-7));
    BOOST_TEST(std::abs(outcome.energy_change) < 1e-4);  // the fall of the first step, 1e-3 m/s
  }
}

// Between balls of one weight the forces make no approach: those below carry all of it.
BOOST_AUTO_TEST_CASE(holds_a_stack_and_what_a_changed_step_pressed_in) {
  Particles balls{.position = Vectors::Zero(5, 3),
                  .velocity = Vectors::Zero(5, 3),
                  .mass = Eigen::VectorXd::LinSpaced(5, 1.0, 3.0),
                  .radius = Eigen::VectorXd::Constant(5, 0.5)};
  for (Eigen::Index k = 0; k < 5; ++k) balls.position(k, 2) = 0.5 + static_cast<double>(k);
  for (const double e : {0.0, 0.5, 0.9}) {
    const Scene scene(balls, floor_at_zero, Gravity{}, Contact{.restitution = ConstantRestitution{e}});
    State state = start(scene);
    BOOST_TEST((run(scene, state, 0.2, VelocityVerlet(), FixedStep{.step = 1e-3}).status == Status::reached));
    const Eigen::VectorXd before = state.r;
    BOOST_TEST((run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 1e-3}).status == Status::reached));
    BOOST_TEST(close(state.r, before, {.absolute = 1e-13}));
    for (const double dt : {2e-3, 1e-3, 5e-4, 3e-3}) {
      BOOST_TEST((run(scene, state, state.t + 1.0, VelocityVerlet(), FixedStep{.step = dt}).status == Status::reached));
    }
    BOOST_TEST(state.r[10] > 0.5 - 2.0 * 9.81 * 9e-6);
    BOOST_TEST(state.r[14] < 4.5);
  }
}

// A million times as heavy, it would come to rest on the light one in as many hits.
BOOST_AUTO_TEST_CASE(holds_a_heavy_ball_on_a_light_one) {
  const Particles balls{.position = Vectors{{0.0, 0.0, 0.5}, {0.0, 0.0, 1.5}},
                        .velocity = Vectors::Zero(2, 3),
                        .mass = Eigen::Vector2d(1.0, 1e6),
                        .radius = Eigen::Vector2d::Constant(0.5)};
  const Scene scene(balls, floor_at_zero, Gravity{}, Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 1e-3});
  BOOST_TEST((outcome.status == Status::reached), outcome.reason);
  BOOST_TEST(state.r[5] > 1.5 - 4.0 * 9.81e-6);
}

// Too narrow by 0.05, there is no room to work the overlap off: it stays.
BOOST_AUTO_TEST_CASE(holds_a_ball_that_is_pinched) {
  const Space slot{{Wall{}, Wall{.point = {0.0, 0.0, 0.95}, .normal = {0.0, 0.0, -1.0}}}};
  const Scene scene(ball(0.48, {0.0, 0.0, -1.0}), slot, Gravity{}, Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 1e-3});
  BOOST_TEST((outcome.status == Status::reached), outcome.reason);
  BOOST_TEST(outcome.overlap_at_start == 0.03, tolerance(1e-12));
  BOOST_TEST(std::abs(state.r[2] - 0.48) < 2e-3);
}

// Elastic balls of 0.6 m in a slot of 0.8 m: each overlaps the other by 0.2 and a wall by 0.1.
BOOST_AUTO_TEST_CASE(gives_up_on_balls_without_room_and_says_how_deep_they_are_in_each_other) {
  Particles crowd = two_particles();
  crowd.position = Vectors{{0.0, 0.0, 0.2}, {0.0, 0.0, 0.6}};
  crowd.velocity = Vectors{{0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}};
  crowd.radius = Eigen::Vector2d(0.3, 0.3);
  const Space slot{{Wall{}, Wall{.point = {0.0, 0.0, 0.8}, .normal = {0.0, 0.0, -1.0}}}};
  const Scene scene(crowd, slot, Contact{});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 1e-6});
  BOOST_TEST((outcome.failure == particulate::schemes::Failure::unsettled_jump));
  BOOST_TEST(
      outcome.reason.find("of 3 contacts that hang together, up to 0.2 m deep, still approach") != std::string::npos,
      outcome.reason);
  BOOST_TEST(outcome.contacts_at_start == 3);
  BOOST_TEST(outcome.overlap_at_start == 0.2, tolerance(1e-12));
}

// On a slope of tan = 3/4: mu_s g cos >= g sin holds; with mu_d = 0.5 it slides at g (0.6 - 0.5 0.8).
BOOST_AUTO_TEST_CASE(lets_a_ball_stick_to_a_slope_or_slide_down_it) {
  const Space slope{{Wall{.point = {0.0, 0.0, 0.0}, .normal = {0.6, 0.0, 0.8}}}};
  Particles resting = ball(0.4, {0.0, 0.0, 0.0});
  resting.position(0, 0) = 0.3;
  for (const double e : {0.0, 0.5}) {
    for (const double mu_s : {0.7501, 0.7499}) {
      const Contact law{.restitution = ConstantRestitution{e}, .friction = Friction{.mu_s = mu_s, .mu_d = 0.5}};
      const Scene scene(resting, slope, Gravity{}, law);
      State state = start(scene);
      BOOST_TEST((run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 1e-3}).status == Status::reached));
      const double moved = 0.8 * (state.r[0] - 0.3) - 0.6 * (state.r[2] - 0.4);
      if (mu_s > 0.75) {
        BOOST_TEST(std::abs(moved) < 1e-5);
      } else {
        BOOST_TEST(moved == 0.5 * 9.81 * (0.6 - 0.5 * 0.8), tolerance(5e-3));
      }
    }
  }
}

// Two spheres that a near field draws together stay where they touch.
BOOST_AUTO_TEST_CASE(holds_what_a_near_field_presses_together) {
  Particles pair = two_particles();
  pair.position = Vectors{{0.0, 0.0, 0.0}, {1.05, 0.0, 0.0}};
  pair.velocity.setZero();
  pair.velocity.col(1).setConstant(2e4);
  const Scene scene(pair, Space{}, NearField{.alpha1 = 1.0, .alpha2 = 0.1},
                    Contact{.restitution = ConstantRestitution{0.5}});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 10.0, VelocityVerlet(), FixedStep{.step = 1e-3});
  const double apart = (state.r.reshaped(2, 3).row(1) - state.r.reshaped(2, 3).row(0)).norm();
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.overlap < 1e-3);
  BOOST_TEST(apart > 1.0 - 1e-5);
  BOOST_TEST(apart <= 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::scene_test
