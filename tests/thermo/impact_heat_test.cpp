#include <particulate/thermo/impact_heat.hpp>

#include <numbers>
#include <vector>

#include <particulate/contact/located_contact.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "clouds.hpp"
#include "says.hpp"

namespace tests::impact_heat_test {

using boost::test_tools::tolerance;
using namespace particulate;
using contact::ConstantRestitution;
using contact::Contact;
using contact::Friction;
using kinematics::Space;
using thermo::ImpactHeat;

BOOST_AUTO_TEST_SUITE(released_energy_)

// 1e6 J/m^2 on pi 0.01^2 m^2 is 314.159 J; half the impulse sets free half of it, three times the impulse all.
BOOST_AUTO_TEST_CASE(grows_with_the_impulse_up_to_all_of_it) {
  const ImpactHeat law{.kappa = 1e6, .J_star = 0.2};
  BOOST_TEST(released_energy(law, 0.1, 0.01) == 50.0 * std::numbers::pi, tolerance(1e-15));
  BOOST_TEST(released_energy(law, 0.6, 0.01) == 100.0 * std::numbers::pi, tolerance(1e-15));
  BOOST_TEST(released_energy(law, 0.0, 0.01) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(dissipated_energy_)

// Masses 1 and 3 kg approach at 2 m/s and part at half of it: 1/2 (3/4) (1 - 1/4) 4 = 1.125 J.
BOOST_AUTO_TEST_CASE(is_that_of_the_reduced_mass) {
  const contact::ImpactRecord impact{
      .n = {1.0, 0.0, 0.0}, .push = 0.75 * 3.0, .before = {2.0, 0.5, 0.0}, .after = {-1.0, 0.5, 0.0}};
  BOOST_TEST(thermo::dissipated_energy(impact) == 1.125, tolerance(1e-15));
}

// An impact that lasts 0.15 s, while other forces press 1 kg and 3 kg together with 1 m/s^2: Delta_1 = 0.1 m/s over the
// compression and e Delta_1 = 0.05 m/s over the recovery, so q_n = 1/2 (3/4) 2.1 (2 - 0.5 (1.05 - 0.05)) = 1.18125 J.
struct Presses {};
template <kinematics::Domain D>
bool add_force(const Presses&, const D&, const laws::At<>& at, laws::Forces force) {
  force.col(0) += 0.5 * Eigen::Vector2d(at.mass[0], -at.mass[1]);
  return true;
}
BOOST_AUTO_TEST_CASE(counts_the_work_of_other_forces_where_an_impact_lasts) {
  const auto two =
      kinematics::particles({{.position = {0.0, 0.0, 0.0}, .velocity = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.5},
                             {.position = {1.0, 0.0, 0.0}, .velocity = {-1.0, 0.0, 0.0}, .mass = 3.0, .radius = 0.5}});
  double q = 0.0;
  const scenes::Scene scene(
      two, Space{},
      Contact<ConstantRestitution>{
          .restitution = {0.5},
          .gamma = 0.15,
          .recorder = [&](const contact::ImpactRecord& one) { q += thermo::dissipated_energy(one); }},
      Presses{});
  schemes::State state = scenes::start(scene);
  BOOST_TEST(scene.jump(state, 1.0).impacts == 1);
  BOOST_TEST(q == 1.18125, tolerance(1e-15));
}

// Random impacts, oblique and with friction, on which random forces act meanwhile. The contact pushes evenly over each
// phase, by m* (u + Delta_1) and e times that, and rubs evenly over both: its power, by the midpoint of a thousand
// steps. Heat is negative only where the forces turn the slip around.
struct PullsEach {
  Eigen::Vector3d acceleration_i, acceleration_j;
};
template <kinematics::Domain D>
bool add_force(const PullsEach& law, const D&, const laws::At<>& at, laws::Forces force) {
  force.row(0) += at.mass[0] * law.acceleration_i.transpose();
  force.row(1) += at.mass[1] * law.acceleration_j.transpose();
  return true;
}
double heat_in_small_steps(const contact::ImpactRecord& impact, double e, double reduced_mass, double duration) {
  constexpr int steps = 1000;
  const Eigen::Vector3d acceleration = impact.meanwhile / duration;
  Eigen::Vector3d v = impact.before;
  double heat = 0.0;
  for (const double phase : {1.0, e}) {
    const double dt = duration * phase / (1.0 + e) / steps;
    const Eigen::Vector3d force = (impact.tangential - impact.push * impact.n) / duration;
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector3d next = v + dt * (force / reduced_mass + acceleration);
      heat -= dt * force.dot(0.5 * (v + next));
      v = next;
    }
  }
  return heat;
}
BOOST_AUTO_TEST_CASE(is_the_work_of_random_impacts_done_in_small_steps) {
  Uniform uniform(3);
  const auto vector = [&] {
    return Eigen::Vector3d(2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0);
  };
  int impacts = 0, negative = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Eigen::Vector3d n = vector().normalized();
    const auto pair = kinematics::particles(
        {{.position = {0.0, 0.0, 0.0}, .velocity = vector(), .mass = 0.1 + uniform(), .radius = 0.5},
         {.position = n, .velocity = vector(), .mass = 1.0 + uniform(), .radius = 0.5}});
    const double e = uniform(), duration = 0.01 + uniform(), mu = uniform();
    std::vector<contact::ImpactRecord> records;
    const scenes::Scene scene(pair, Space{},
                              Contact<ConstantRestitution, Friction>{
                                  .restitution = {e},
                                  .friction = {.mu_s = mu, .mu_d = mu * uniform()},
                                  .gamma = 0.5,
                                  .recorder = [&](const contact::ImpactRecord& one) { records.push_back(one); }},
                              PullsEach{vector(), vector()});
    schemes::State state = scenes::start(scene);
    BOOST_TEST(scene.jump(state, 2.0 * duration).unsettled == "");
    if (records.empty()) continue;
    const contact::ImpactRecord& one = records.front();
    const double q = thermo::dissipated_energy(one), reduced = 1.0 / (1.0 / pair.mass[0] + 1.0 / pair.mass[1]);
    const double scale = 0.5 * reduced * one.before.squaredNorm();
    BOOST_TEST(excess(q, heat_in_small_steps(one, e, reduced, duration), {.absolute = 1e-12 * scale}) <= 0.0);
    const Eigen::Vector3d slip = one.before - one.n * one.n.dot(one.before);
    const bool turns = slip.dot(slip + one.meanwhile - one.n * one.n.dot(one.meanwhile)) < 0.0;
    BOOST_TEST((turns || q >= 0.0));
    negative += q < 0.0;
    ++impacts;
  }
  BOOST_TEST(impacts > 100);
  BOOST_TEST(negative < impacts / 50);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(add_heat_of_impact_)

// The same two, of heat capacities 4 and 2 J/(kg K): half of 1.125 J warms 4 J/K and 6 J/K.
kinematics::Particles two(bool first_is_immovable) {
  return kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                 .velocity = {first_is_immovable ? 0.0 : 1.0, 0.0, 0.0},
                                 .mass = 1.0,
                                 .radius = 0.5,
                                 .immovable = first_is_immovable,
                                 .temperature = 300.0,
                                 .heat_capacity = 4.0},
                                {.position = {1.0, 0.0, 0.0},
                                 .velocity = {-1.0, 0.0, 0.0},
                                 .mass = 3.0,
                                 .radius = 0.5,
                                 .temperature = 280.0,
                                 .heat_capacity = 2.0}});
}

schemes::State after_a_step(const kinematics::Particles& particles, const Space& space, const ImpactHeat& law) {
  const scenes::Scene scene(particles, space, Contact<ConstantRestitution>{.restitution = {0.5}}, law);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out =
      integrate(scene, state, 1e-9, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 1e-9});
  BOOST_TEST(out.heat == out.released - out.energy_change, tolerance(1e-14));
  return state;
}

BOOST_AUTO_TEST_CASE(warms_both_by_half) {
  const Eigen::VectorXd theta = after_a_step(two(false), {}, {}).y;
  BOOST_TEST(close(theta, Eigen::Vector2d(300.0 + 0.5625 / 4.0, 280.0 + 0.5625 / 6.0), {.relative = 1e-15}));
}

// At rest and immovable it meets 3 kg at 1 m/s, which lose 3/4 of 1.5 J; the reaction adds its own, pi/4 J.
BOOST_AUTO_TEST_CASE(warms_one_alone_where_the_other_is_immovable) {
  const Eigen::VectorXd theta = after_a_step(two(true), {}, {.kappa = 1.0, .J_star = 1.0}).y;
  BOOST_TEST(theta[0] == 300.0);
  BOOST_TEST(theta[1] == 280.0 + (1.125 + 0.25 * std::numbers::pi) / 6.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(warms_what_hits_a_wall_by_all_of_it) {
  kinematics::Particles one = chosen(two(false), {1});
  one.position.row(0) << 0.5, 0.0, 0.0;
  const Eigen::VectorXd theta = after_a_step(one, {.walls = {{.normal = {1.0, 0.0, 0.0}}}}, {}).y;
  BOOST_TEST(theta[0] == 280.0 + 1.125 / 6.0, tolerance(1e-15));
}

// Friction, groups of contacts and both ways to resolve them: what impacts take is what becomes warm.
BOOST_AUTO_TEST_CASE(closes_the_books_of_a_cloud) {
  for (const auto resolution : {contact::Resolution::sequential, contact::Resolution::summed}) {
    kinematics::Particles cloud = random_cloud(60, {1.0, 1.0, 1.0}, 0.05, 0.1);
    cloud.temperature = Eigen::VectorXd::Constant(60, 300.0);
    cloud.heat_capacity = Eigen::VectorXd::LinSpaced(60, 1.0, 3.0);
    const scenes::Scene scene(
        cloud, Space{},
        Contact<ConstantRestitution, Friction>{
            .restitution = {0.5}, .friction = {.mu_s = 0.2, .mu_d = 0.1}, .resolution = resolution},
        ImpactHeat{.kappa = 10.0, .J_star = 0.1});
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out =
        integrate(scene, state, 0.2, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.01});
    const double thermal = cloud.mass.cwiseProduct(cloud.heat_capacity).dot(state.y - cloud.temperature);
    BOOST_TEST(out.impacts > 20);
    BOOST_TEST(out.released > 0.0);
    BOOST_TEST(out.heat == out.released - out.energy_change, tolerance(1e-12));
    BOOST_TEST(thermal == out.heat, tolerance(1e-12));
  }
}

// Located contact: no overlap, and the same heat a pair as by its reduced mass, 1/2 (3/4) (1 - 1/4) 4 J.
BOOST_AUTO_TEST_CASE(is_the_same_where_impacts_are_located) {
  kinematics::Particles apart = two(false);
  apart.position(1, 0) = 1.75;
  const scenes::Scene scene(apart, Space{}, contact::LocatedContact<>{.restitution = {0.5}}, ImpactHeat{});
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out =
      integrate(scene, state, 1.0, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.25});
  BOOST_TEST(out.impacts == 1);
  BOOST_TEST(out.heat == 1.125, tolerance(1e-12));
  BOOST_TEST(state.y[0] == 300.0 + 0.5625 / 4.0, tolerance(1e-13));
}

// A ball that falls by 1 m, hops and comes to rest: all that it fell has become heat, but for a part of a step. What
// rests is warmed no further.
BOOST_AUTO_TEST_CASE(is_the_whole_fall_of_a_ball_that_comes_to_rest) {
  const auto ball = kinematics::particles(
      {{.position = {0.0, 0.0, 1.5}, .mass = 2.0, .radius = 0.5, .temperature = 300.0, .heat_capacity = 3.0}});
  const auto heat = [&](double t, double dt) {
    const scenes::Scene scene(ball, Space{.walls = {{}}}, laws::Gravity{{0.0, 0.0, -10.0}},
                              Contact<ConstantRestitution>{.restitution = {0.5}}, ImpactHeat{});
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out = integrate(scene, state, t, schemes::VelocityVerlet{}, schemes::FixedStep{.step = dt});
    BOOST_TEST(2.0 * 3.0 * (state.y[0] - 300.0) == out.heat, tolerance(1e-11));
    return out.heat;
  };
  BOOST_TEST(heat(4.0, 1e-3) == 20.0, tolerance(1e-2));
  BOOST_TEST(heat(4.0, 1e-4) == 20.0, tolerance(1e-3));
  BOOST_TEST(heat(8.0, 1e-3) == heat(4.0, 1e-3), tolerance(1e-12));
}

// What lies on the ground is pressed by 20 N, at 2 J/m^2 and 4 N s: 20/4 2 pi/4 W, whatever the step.
BOOST_AUTO_TEST_CASE(goes_on_where_a_force_holds_two_together) {
  const auto ball = kinematics::particles(
      {{.position = {0.0, 0.0, 0.5}, .mass = 2.0, .radius = 0.5, .temperature = 300.0, .heat_capacity = 3.0}});
  for (const double dt : {1e-2, 1e-3}) {
    const scenes::Scene scene(ball, Space{.walls = {{}}}, laws::Gravity{{0.0, 0.0, -10.0}},
                              Contact<ConstantRestitution>{.restitution = {0.5}},
                              ImpactHeat{.kappa = 2.0, .J_star = 4.0});
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out =
        integrate(scene, state, 2.0, schemes::VelocityVerlet{}, schemes::FixedStep{.step = dt});
    BOOST_TEST(out.released == 2.0 * 2.5 * std::numbers::pi, tolerance(dt));
  }
}

// Nothing looks at temperatures, so that the motion has the same bits with them and without.
BOOST_AUTO_TEST_CASE(leaves_the_motion_alone) {
  kinematics::Particles cloud = random_cloud(40, {1.0, 1.0, 1.0}, 0.05, 0.1);
  const Contact<ConstantRestitution> contact{.restitution = {0.5}};
  const scenes::Scene cold(cloud, Space{}, contact);
  cloud.temperature = cloud.heat_capacity = Eigen::VectorXd::Ones(40);
  const scenes::Scene warm(cloud, Space{}, contact, ImpactHeat{.kappa = 5.0});
  schemes::State one = scenes::start(cold), other = scenes::start(warm);
  (void)integrate(cold, one, 0.2, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.01});
  (void)integrate(warm, other, 0.2, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.01});
  BOOST_TEST(one.y.size() == 0);
  BOOST_TEST((one.r == other.r && one.v == other.v));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_heat) {
  CHECK_REFUSED(validate(ImpactHeat{.kappa = -1.0}), "kappa must be finite and not negative, got -1 J/m^2");
  CHECK_REFUSED(validate(ImpactHeat{.J_star = 0.0}), "J_star must be positive and finite, got 0 N s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::impact_heat_test
