#include <particulate/contact/located_contact.hpp>

#include <cmath>
#include <vector>

#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/events.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "problems.hpp"
#include "schemes/exact_fall.hpp"

namespace tests::located_contact_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::scenes;
using namespace particulate::schemes;

using Bouncing = Scene<Space, Gravity, LocatedContact<>>;
static_assert(LocatesJumps<Bouncing> && LocatesJumps<const Bouncing>);
static_assert(!LocatesJumps<Scene<Space, Gravity, Contact<>>>, "stepped contacts are looked for after steps");

const Space ground{{Wall{}}};

// Has no value below 1 m.
struct Above {};
bool add_force(const Above&, const Space&, const particulate::laws::At<>& at, particulate::laws::Forces) {
  return (at.position.col(2).array() > 1.0).all();
}

Particles spheres(const Vectors& position, const Vectors& velocity, double radius) {
  const Eigen::Index N = position.rows();
  return {.position = position,
          .velocity = velocity,
          .mass = Eigen::VectorXd::Ones(N),
          .radius = Eigen::VectorXd::Constant(N, radius)};
}

// Dropped from 0.4 m under 9.81 m/s^2.
Bouncing dropped(double e) {
  return {spheres(Vectors{{0.0, 0.0, 0.45}}, Vectors::Zero(1, 3), 0.05), ground, Gravity{},
          LocatedContact<>{.restitution = {e}}};
}
const double fall = std::sqrt(0.8 / 9.81);

template <class S>
Vectors velocities(const S& scene, double t_end, double dt) {
  State state = start(scene);
  BOOST_TEST((run(scene, state, t_end, ExactFall(), FixedStep{.step = dt}).status == Status::reached));
  return state.v.reshaped(state.v.size() / 3, 3);
}

// Under gravity alone each is exact, and so is its path inside of a step.
template <class S>
void bounces_as_exactly(S scheme) {
  const Bouncing scene = dropped(0.8);
  State ball = start(scene), exact = ball;
  const Outcome outcome = run(scene, ball, 1.5, scheme, equal_steps<S>(0.13, 1e-15));
  BOOST_TEST(run(scene, exact, 1.5, ExactFall(), FixedStep{.step = 0.13}).impacts == outcome.impacts);
  BOOST_TEST(outcome.reason == "");
  BOOST_TEST(close(flat(ball), flat(exact), {.absolute = 1e-11}));
}

BOOST_AUTO_TEST_SUITE(located_contact)

BOOST_AUTO_TEST_CASE(is_checked_where_it_enters_a_scene) {
  CHECK_REFUSED(dropped(1.5), "e must lie in [0, 1], got 1.5");
}

BOOST_AUTO_TEST_CASE(is_met_by_explicit_and_one_step_schemes) {
  bounces_as_exactly(RungeKutta4());
  bounces_as_exactly(VelocityVerlet());
  bounces_as_exactly(PhiFamily<>(0.5));
}

// Impact k at fall (1 + 2 (e + ... + e^k)), with e^k of the first speed; however long the steps are.
BOOST_AUTO_TEST_CASE(meets_every_impact_of_a_bouncing_ball) {
  constexpr double e = 0.8;
  for (const double dt : {0.7, 0.1, 0.013}) {
    const Bouncing scene = dropped(e);
    State ball = start(scene);
    ExactFall scheme{.blur = 0.5};
    FixedStep control{.step = dt};
    double t = fall, speed = 9.81 * fall;
    int impacts = 0;
    const auto observe = [&](const State&, const State& to, double, const ExactFall&) {
      if (std::abs(to.r[2] - 0.05) > 1e-12) return true;
      BOOST_TEST(to.t == t, tolerance(1e-13));
      BOOST_TEST(to.v[2] == -speed, tolerance(1e-12));
      speed *= e;
      t += 2.0 * speed / 9.81;
      ++impacts;
      return true;
    };
    const Outcome outcome = integrate(scene, ball, 2.0, scheme, control, observe);
    BOOST_TEST((outcome.status == Status::reached));
    BOOST_TEST(impacts == 7);
    BOOST_TEST(outcome.impacts == 7);
    BOOST_TEST(scheme.forgotten >= 7);
    BOOST_TEST(outcome.overlap < 1e-13);
    BOOST_TEST(control.step == dt);
  }
}

BOOST_AUTO_TEST_CASE(ends_where_the_impacts_of_a_bouncing_ball_accumulate) {
  for (const double e : {0.0, 0.5, 0.9}) {
    const Bouncing scene = dropped(e);
    State ball = start(scene);
    const Outcome outcome = run(scene, ball, 100.0, ExactFall(), FixedStep{.step = 0.1});
    BOOST_TEST((outcome.status == Status::failed));
    BOOST_TEST((outcome.failure == Failure::accumulating));
    // Each impact is found where the gap first rounds to zero: 1e-16 m early, at the end over 4e-5 m/s, some 20 times.
    BOOST_TEST(outcome.accumulation == fall * (1.0 + e) / (1.0 - e), tolerance(5e-11));
    BOOST_TEST(outcome.reason.find("particle 0 and a wall come to rest on each other") == 0U);
    BOOST_TEST(outcome.t == ball.t);
  }
}

BOOST_AUTO_TEST_CASE(keeps_an_elastic_ball_bouncing) {
  const Bouncing scene = dropped(1.0);
  State ball = start(scene);
  const Outcome outcome = run(scene, ball, 20.0 * fall, ExactFall(), FixedStep{.step = 0.1});
  BOOST_TEST(outcome.impacts == 10);
  BOOST_TEST(std::abs(ball.r[2] - 0.45) < 1e-13);
  BOOST_TEST(std::abs(ball.v[2]) < 1e-12);
}

// Both balls fall on the ground at once, and a third, dropped later, not: one step ends at two impacts.
BOOST_AUTO_TEST_CASE(takes_impacts_of_one_time_together) {
  const Scene scene(spheres(Vectors{{0.0, 0.0, 0.45}, {1.0, 0.0, 0.45}, {2.0, 0.0, 0.5}}, Vectors::Zero(3, 3), 0.05),
                    ground, Gravity{}, LocatedContact{});
  State balls = start(scene);
  const Outcome outcome = run(scene, balls, 0.3, ExactFall(), FixedStep{.step = 1.0});
  BOOST_TEST(outcome.impacts == 2);
  BOOST_TEST(outcome.steps == 2);
}

BOOST_AUTO_TEST_CASE(keeps_a_symmetric_hit_symmetric_whatever_the_numbering) {
  const Vectors r{{-2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const Vectors v{{0.3, 0.0, 0.0}, {0.0, 0.0, 0.0}, {-0.3, 0.0, 0.0}};
  for (const std::vector<int>& order : {std::vector{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}) {
    const Scene scene(spheres(r(order, Eigen::all), v(order, Eigen::all), 0.5), Space{}, LocatedContact{});
    BOOST_TEST(close(velocities(scene, 5.0, 1.0), -v(order, Eigen::all), {.absolute = 1e-15}));
  }
}

// The hit is passed on to the last of the touching row, at the moment it comes.
BOOST_AUTO_TEST_CASE(lets_a_cradle_swing) {
  Vectors r = Vectors::Zero(4, 3), v = Vectors::Zero(4, 3);
  r.col(0) << -1.0, 1.0, 2.0, 3.0;
  v(0, 0) = 2.0;
  const Scene scene(spheres(r, v, 0.5), Space{}, LocatedContact{});
  State row = start(scene);
  BOOST_TEST(run(scene, row, 2.0, ExactFall(), FixedStep{.step = 3.0}).impacts == 3);
  BOOST_TEST(row.v[3] == 2.0);
  BOOST_TEST(row.r[3] == 6.0, tolerance(1e-15));  // 1.5 s at 2 m/s
  BOOST_TEST(row.r[0] == 0.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(parts_bodies_that_start_touching_or_overlapped_and_approach) {
  for (const double d : {1.0, 0.9}) {
    const Scene scene(spheres(Vectors{{0.0, 0.0, 0.0}, {d, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, 0.5),
                      Space{}, LocatedContact{});
    BOOST_TEST(close(velocities(scene, 1.0, 0.25), Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {}));
  }
}

BOOST_AUTO_TEST_CASE(turns_at_what_is_immovable) {
  Particles pair = spheres(Vectors{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}}, Vectors{{0.0, 0.0, 0.0}, {-4.0, 0.0, 0.0}}, 0.5);
  pair.immovable = {true, false};
  const Scene scene(pair, Space{}, LocatedContact{.restitution = ConstantRestitution{0.5}});
  BOOST_TEST(close(velocities(scene, 2.0, 0.3), Vectors{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(is_unsettled_where_forces_have_no_value) {
  const Scene scene(spheres(Vectors{{0.0, 0.0, 1.2}}, Vectors{{0.0, 0.0, -1.0}}, 1.0), ground, Above{},
                    LocatedContact{});
  State ball = start(scene);
  const Outcome outcome = run(scene, ball, 2.0, ExactFall(), FixedStep{.step = 0.5});
  BOOST_TEST((outcome.failure == Failure::unsettled_jump));
  BOOST_TEST(outcome.reason == "the forces have no value where bodies touch");
  BOOST_TEST(ball.t == 0.0);
}

// The top of each hop, and each impact, end a step.
BOOST_AUTO_TEST_CASE(goes_with_events) {
  const Bouncing scene = dropped(1.0);
  State ball = start(scene);
  Watch watch({{.function = [](const State& at) { return at.v[2]; },
                .direction = Direction::falling,
                .action = particulate::schemes::Action::record}});
  const Outcome outcome = run(scene, ball, 5.5 * fall, ExactFall(), FixedStep{.step = 0.5}, watch);
  BOOST_TEST(outcome.impacts == 3);
  BOOST_REQUIRE(watch.hits().size() == 2U);
  BOOST_TEST(watch.hits()[0].t == 2.0 * fall, tolerance(1e-14));
  BOOST_TEST(watch.hits()[1].t == 4.0 * fall, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(does_nothing_without_particles) {
  const Scene scene(spheres(Vectors(0, 3), Vectors(0, 3), 1.0), ground, Gravity{}, LocatedContact{});
  State nobody = start(scene);
  BOOST_TEST((run(scene, nobody, 2.0, ExactFall(), FixedStep{.step = 0.5}).status == Status::reached));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::located_contact_test
