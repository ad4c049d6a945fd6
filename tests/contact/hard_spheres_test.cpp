#include <particulate/contact/hard_spheres.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>

#include "close.hpp"
#include "clouds.hpp"

namespace tests::hard_spheres_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::schemes;

using Eigen::Vector3d;

const Space open;

Space periodic(double x, double y = infinity, double z = infinity) { return {.walls = {}, .lengths = {x, y, z}}; }

// Bodies on the x axis, of 1 kg and 1 m of diameter.
Particles row_of(const std::vector<double>& x, const std::vector<double>& v) {
  std::vector<Particle> all;
  for (std::size_t i = 0; i < x.size(); ++i) {
    all.push_back({.position = {x[i], 0.0, 0.0}, .velocity = {v[i], 0.0, 0.0}, .mass = 1.0, .radius = 0.5});
  }
  return particles(all);
}

// Those of a random cloud in a periodic cube that overlap none before them.
Particles apart(const Particles& cloud, double length) {
  std::vector<Particle> kept;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Particle one{.position = cloud.position.row(i),
                       .velocity = cloud.velocity.row(i),
                       .mass = cloud.mass[i],
                       .radius = cloud.radius[i]};
    if (std::all_of(kept.begin(), kept.end(), [&](const Particle& other) {
          return separation(periodic(length, length, length), one.position, other.position).norm() >
                 1.01 * (one.radius + other.radius);
        })) {
      kept.push_back(one);
    }
  }
  return particles(kept);
}

// The next collision of a periodic gas, from all pairs and all images next to them, by the plain formula for roots.
struct Next {
  double t = infinity;
  Eigen::Index i = -1, j = -1;
  Vector3d r = Vector3d::Zero();
};
Next next_of_all(const Particles& p, double length) {
  Next next;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    for (Eigen::Index j = i + 1; j < p.size(); ++j) {
      const Vector3d v = p.velocity.row(j) - p.velocity.row(i);
      const Vector3d nearest = separation(periodic(length, length, length), p.position.row(i), p.position.row(j));
      for (int k = 0; k < 27; ++k) {
        const Vector3d r = nearest + length * Vector3d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        const double a = v.squaredNorm(), b = r.dot(v), reach = p.radius[i] + p.radius[j];
        const double root = b * b - a * (r.squaredNorm() - reach * reach);
        if (b >= 0.0 || root < 0.0) continue;
        const double t = (-b - std::sqrt(root)) / a;
        if (t < next.t) next = {t, i, j, r + t * v};
      }
    }
  }
  return next;
}

// Collisions of a gas by that, with equal restitution at any speed.
std::vector<Collision> collisions_of_all(Particles p, double length, double e, std::size_t how_many) {
  std::vector<Collision> all;
  double t = 0.0;
  while (all.size() < how_many) {
    const Next next = next_of_all(p, length);
    t += next.t;
    p.position += next.t * p.velocity;
    const Vector3d n = next.r.normalized(), before = p.velocity.row(next.i) - p.velocity.row(next.j);
    const double push = (1.0 + e) * before.dot(n) / (1.0 / p.mass[next.i] + 1.0 / p.mass[next.j]);
    p.velocity.row(next.i) -= push / p.mass[next.i] * n.transpose();
    p.velocity.row(next.j) += push / p.mass[next.j] * n.transpose();
    all.push_back({.t = t, .i = next.i, .j = next.j, .n = n, .impulse = {.normal = -push}});
  }
  return all;
}

void happens_as_with_all_pairs(const Particles& p, double length, double e, std::size_t how_many, double t_end) {
  const std::vector<Collision> expected = collisions_of_all(p, length, e, how_many);
  std::vector<Collision> seen;
  HardSpheres gas(p, periodic(length, length, length), ConstantRestitution{e});
  State state = start(gas);
  BOOST_TEST(gas.advance(state, t_end, [&](const Collision& one) { seen.push_back(one); }).reason == "");
  BOOST_TEST_REQUIRE(seen.size() >= how_many);
  for (std::size_t k = 0; k < how_many; ++k) {
    BOOST_TEST_CONTEXT("collision " << k) {
      BOOST_TEST_REQUIRE(seen[k].i == expected[k].i);
      BOOST_TEST_REQUIRE(seen[k].j == expected[k].j);
      BOOST_TEST(std::abs(seen[k].t - expected[k].t) < 1e-9);
      BOOST_TEST(close(seen[k].n, expected[k].n, {.absolute = 1e-8}));
      BOOST_TEST(seen[k].impulse.normal == expected[k].impulse.normal, tolerance(1e-7));
    }
  }
}

BOOST_AUTO_TEST_SUITE(HardSpheres_)

// dx = 0.8, dy = 0.6 at t = 2.2: u = 0.8, m* = 2/3, J = -1.5 (2/3) 0.8 = -0.8, loss (1/2)(2/3)(1 - 0.25) 0.64 = 0.16.
BOOST_AUTO_TEST_CASE(has_two_bodies_meet_as_by_hand_and_tells_of_it) {
  HardSpheres gas(particles({{.position = {0, 0, 0}, .velocity = {1, 0, 0}, .mass = 1, .radius = 0.5},
                             {.position = {3, 0.6, 0}, .mass = 2, .radius = 0.5}}),
                  open, ConstantRestitution{0.5});
  State state = start(gas);
  std::vector<Collision> seen;
  const Outcome outcome = gas.advance(state, 3.2, [&](const Collision& one) { seen.push_back(one); });
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.impacts == 1);
  BOOST_TEST(outcome.energy_change == -0.16, tolerance(1e-14));
  BOOST_TEST(outcome.overlap < 1e-15);
  BOOST_TEST(close(velocities(state), Vectors{{0.36, -0.48, 0}, {0.32, 0.24, 0}}, {.absolute = 1e-15}));
  BOOST_TEST(close(positions(state), Vectors{{2.56, -0.48, 0}, {3.32, 0.84, 0}}, {.absolute = 1e-14}));
  BOOST_TEST_REQUIRE(seen.size() == 1U);
  BOOST_TEST(seen[0].t == 2.2, tolerance(1e-15));
  BOOST_TEST(seen[0].i == 0);
  BOOST_TEST(seen[0].j == 1);
  BOOST_TEST(seen[0].wall == -1);
  BOOST_TEST(close(seen[0].n, Vector3d(0.8, 0.6, 0), {.absolute = 1e-15}));
  BOOST_TEST(seen[0].impulse.normal == -0.8, tolerance(1e-14));
  BOOST_TEST(seen[0].approach_speed == 0.8, tolerance(1e-14));
  BOOST_TEST(seen[0].energy_change == -0.16, tolerance(1e-14));
}

// Slip (0.36, -0.48), 0.6 long: sticking takes (2/3) 0.6 = 0.4 = 0.5 |J| of Restitution at e(0.8) = 0.5.
BOOST_AUTO_TEST_CASE(takes_restitution_and_friction_of_the_library) {
  HardSpheres gas(particles({{.position = {0, 0, 0}, .velocity = {1, 0, 0}, .mass = 1, .radius = 0.5},
                             {.position = {3, 0.6, 0}, .mass = 2, .radius = 0.5}}),
                  open, Restitution{.e_o = 1.0, .v_star = 1.6}, Friction{.mu_s = 0.3, .mu_d = 0.25});
  State state = start(gas);
  std::vector<Collision> seen;
  BOOST_TEST(gas.advance(state, 3.2, [&](const Collision& one) { seen.push_back(one); }).impacts == 1);
  BOOST_TEST(seen[0].impulse.normal == -0.8, tolerance(1e-14));
  BOOST_TEST(close(seen[0].impulse.tangential, 0.25 * 0.8 * Vector3d(-0.6, 0.8, 0), {.absolute = 1e-15}));
  BOOST_TEST(close(velocity(state, 0), Vector3d(0.36 - 0.12, -0.48 + 0.16, 0), {.absolute = 1e-15}));
}

BOOST_AUTO_TEST_CASE(bounces_between_walls_beside_periods_and_tells_what_they_get) {
  const Space slit{.walls = {Wall{}, Wall{.point = {0, 0, 4}, .normal = {0, 0, -1}}},
                   .lengths = {4, infinity, infinity}};
  HardSpheres gas(particles({{.position = {1, 0, 1}, .velocity = {0.5, 0, -1}, .mass = 2, .radius = 0.5},
                             {.position = {3, 50, 1}, .mass = 1, .radius = 0.5}}),
                  slit, ConstantRestitution{0.5});
  State state = start(gas);
  std::vector<Collision> seen;
  BOOST_TEST(gas.advance(state, 10.5, [&](const Collision& one) { seen.push_back(one); }).impacts == 2);
  BOOST_TEST(gas.tally().wall_impacts == 2);
  BOOST_TEST(close(position(state, 0), Vector3d(6.25, 0, 2.5), {.absolute = 1e-14}));
  BOOST_TEST(close(velocity(state, 0), Vector3d(0.5, 0, -0.25), {.absolute = 0.0}));
  const double times[] = {0.5, 6.5};
  const Vector3d impulses[] = {{0, 0, 3}, {0, 0, -1.5}};
  for (const std::size_t k : {0U, 1U}) {
    BOOST_TEST(seen[k].t == times[k], tolerance(1e-15));
    BOOST_TEST(seen[k].j == -1);
    BOOST_TEST(seen[k].wall == static_cast<Eigen::Index>(k));
    BOOST_TEST(close(seen[k].impulse.total(seen[k].n), impulses[k], {.absolute = 1e-15}));
  }
}

// Gaps of 0.1 and 0.2 by turns close at 1 m/s.
BOOST_AUTO_TEST_CASE(meets_images_on_both_sides_of_the_shortest_periods) {
  HardSpheres gas(row_of({0.05, 1.15}, {1.0, 0.0}), periodic(2.2));
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 1.05);
  BOOST_TEST(outcome.impacts == 5);
  BOOST_TEST(outcome.overlap < 1e-15);
  BOOST_TEST(close(state.v, (Eigen::VectorXd(6) << 0, 1, 0, 0, 0, 0).finished(), {.absolute = 1e-15}));
  BOOST_TEST(position(state, 0).x() == 0.15 + 0.4, tolerance(1e-14));
  BOOST_TEST(position(state, 1).x() == 1.15 + 0.4 + 0.15, tolerance(1e-14));
}

// In turn: (0.25, 0.75, -1), (0.25, -0.5625, 0.3125), (-0.359375, 0.046875, 0.3125), all exact.
BOOST_AUTO_TEST_CASE(resolves_three_at_one_moment_pair_by_pair_by_number) {
  HardSpheres gas(row_of({-2, 0, 2}, {1, 0, -1}), open, ConstantRestitution{0.5});
  State state = start(gas);
  BOOST_TEST(gas.advance(state, 2.0).impacts == 3);
  BOOST_TEST(close(state.v.head(3), Vector3d(-0.359375, 0.046875, 0.3125), {.absolute = 0.0}));
}

// Numbers fall from place to place.
BOOST_AUTO_TEST_CASE(has_many_pairs_meet_at_one_moment_by_number) {
  constexpr std::size_t pairs = 30;
  std::vector<double> x(2 * pairs), v(2 * pairs);
  for (std::size_t k = 0; k < pairs; ++k) {
    x[k] = -10.0 * static_cast<double>(k), v[k] = 1.0;
    x[2 * pairs - 1 - k] = x[k] + 2.0, v[2 * pairs - 1 - k] = -1.0;
  }
  HardSpheres gas(row_of(x, v));
  State state = start(gas);
  std::vector<Eigen::Index> seen;
  BOOST_TEST(gas.advance(state, 1.0, [&](const Collision& one) { seen.push_back(one.i); }).impacts == pairs);
  for (std::size_t k = 0; k < pairs; ++k) BOOST_TEST(seen.at(k) == static_cast<Eigen::Index>(k));
}

BOOST_AUTO_TEST_CASE(passes_an_impact_through_a_row_that_touches) {
  HardSpheres gas(row_of({-3, 0, 1, 2, 3}, {1, 0, 0, 0, 0}));
  State state = start(gas);
  BOOST_TEST(gas.advance(state, 3.0).impacts == 4);
  BOOST_TEST(state.v[4] == 1.0);
  BOOST_TEST(state.v.head(4).norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(collides_as_all_pairs_and_images_do) {
  happens_as_with_all_pairs(apart(random_cloud(14, Vector3d::Constant(4.0), 0.3, 0.4), 4.0), 4.0, 0.9, 25, 10.0);
}

// Radii over a factor of 100, so masses over 1e6.
BOOST_AUTO_TEST_CASE(collides_so_with_sizes_and_masses_far_apart) {
  Particles cloud = random_cloud(40, Vector3d::Constant(4.0), 0.01, 0.05, 3);
  cloud.radius.head(2).setOnes();
  cloud.position.topRows(2) << 1.0, 1.0, 1.0, 3.0, 3.0, 3.0;
  cloud.mass = 1e6 * cloud.radius.array().cube();
  happens_as_with_all_pairs(apart(cloud, 4.0), 4.0, 1.0, 20, 6.0);
}

// Some are larger than the cells of most, and few cells apart.
BOOST_AUTO_TEST_CASE(misses_nobody_of_sizes_in_cells_of_two_kinds) {
  const Particles cloud = apart(random_cloud(400, Vector3d::Constant(1.0), 0.05, 0.08), 1.0);
  HardSpheres gas(cloud, periodic(1, 1, 1));
  State state = start(gas);
  BOOST_TEST(gas.advance(state, 20.0).overlap < 1e-13);
}

BOOST_AUTO_TEST_CASE(keeps_energy_and_momentum_of_an_elastic_gas_and_its_spheres_apart) {
  const Particles cloud = apart(random_cloud(60, Vector3d::Constant(5.0), 0.3, 0.4), 5.0);
  HardSpheres gas(cloud, periodic(5, 5, 5));
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 20.0);
  BOOST_TEST(outcome.impacts > 300);
  BOOST_TEST(outcome.overlap < 1e-13);
  BOOST_TEST(kinetic_energy(cloud.mass, velocities(state)) == kinetic_energy(cloud.mass, cloud.velocity),
             tolerance(1e-13));
  BOOST_TEST(close(linear_momentum(cloud.mass, velocities(state)), linear_momentum(cloud.mass, cloud.velocity),
                   {.absolute = 1e-12}));
}

BOOST_AUTO_TEST_CASE(has_no_unit_of_length_or_time_and_loses_nothing_late) {
  const Particles cloud = apart(random_cloud(30, Vector3d::Constant(4.0), 0.3, 0.4), 4.0);
  Particles small = cloud;
  small.position *= 0x1p-20, small.radius *= 0x1p-20, small.velocity *= 0x1p-50;
  HardSpheres gas(cloud, periodic(4, 4, 4), ConstantRestitution{0.9});
  HardSpheres slow(small, periodic(0x1p-18, 0x1p-18, 0x1p-18), ConstantRestitution{0.9});
  State state = start(gas), late = state, scaled = start(slow);
  late.t = 1e9;
  BOOST_TEST(gas.advance(state, 2.0).impacts > 10);
  BOOST_TEST(gas.advance(late, 1e9 + 2.0).impacts > 10);
  BOOST_TEST(slow.advance(scaled, 0x1p31).impacts > 10);
  BOOST_TEST(close(late.r, state.r, {.absolute = 0.0}));
  BOOST_TEST(close(0x1p20 * scaled.r, state.r, {.absolute = 0.0}));
  BOOST_TEST(close(0x1p50 * scaled.v, state.v, {.absolute = 0.0}));
}

BOOST_AUTO_TEST_CASE(goes_on_from_a_state_with_the_same_bits) {
  const Particles cloud = apart(random_cloud(60, Vector3d::Constant(5.0), 0.3, 0.4), 5.0);
  const auto gas = [&] { return HardSpheres(cloud, periodic(5, 5, 5), ConstantRestitution{0.5}, Frictionless{}, 0.3); };
  auto whole = gas();
  State state = start(whole);
  BOOST_TEST(whole.advance(state, 1.0).impacts > 10);
  BOOST_TEST(state.y.maxCoeff() > 0.0);
  State written = state;
  BOOST_TEST(whole.advance(state, 2.0).impacts > 10);
  BOOST_TEST(whole.tally().elastic_impacts > 0);
  BOOST_TEST(gas().advance(written, 2.0).impacts > 10);
  BOOST_TEST(close(flat(written), flat(state), {.absolute = 0.0}));
}

// 0 approaches 1 by a rounding: 2^-52 s^-1 of their distance, and none of the 8 (0.5 + 1.5) of these roundings is
// passed.
BOOST_AUTO_TEST_CASE(stops_an_approach_of_a_rounding_without_an_impact) {
  HardSpheres gas(row_of({0, 1}, {1, 1 - 0x1p-52}));
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 1e4);
  BOOST_TEST(outcome.impacts == 0);
  BOOST_TEST(outcome.overlap < 1e-14);
  BOOST_TEST(state.v[0] <= state.v[1]);
  BOOST_TEST(state.v[1] == 1.0, tolerance(1e-15));
}

// Parting two by a rounding can have one approach its other neighbour by another, round the period.
BOOST_AUTO_TEST_CASE(does_not_stop_such_approaches_at_one_moment_without_end) {
  Particles ring = row_of({0, 1, 2}, {1, 1 - 0x1p-52, 1 + 0x1p-52});
  ring.mass = Vector3d(1, 2, 3);
  HardSpheres gas(ring, periodic(3));
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 64.0);
  BOOST_TEST(outcome.impacts == 0);
  BOOST_TEST(outcome.overlap < 1e-13);
  BOOST_TEST(gas.tally().predictions < 100);
}

// Times of the state are 1.2e-7 s apart, and are left every 64 impacts.
BOOST_AUTO_TEST_CASE(loses_no_time_where_it_is_counted_anew) {
  HardSpheres gas(row_of({1}, {0.7}),
                  {.walls = {Wall{.normal = {1, 0, 0}}, Wall{.point = {3, 0, 0}, .normal = {-1, 0, 0}}}});
  State state = start(gas), late = state;
  late.t = 1e9;
  Collision last, last_late;
  BOOST_TEST(gas.advance(state, 4096.0, [&](const Collision& one) { last = one; }).impacts == 1433);
  BOOST_TEST(gas.advance(late, 1e9 + 4096.0, [&](const Collision& one) { last_late = one; }).impacts == 1433);
  BOOST_TEST(std::abs(late.r[0] - state.r[0]) < 1e-11);
  BOOST_TEST(std::abs((last_late.t - 1e9) + last_late.t_carry - last.t) < 1e-11);
}

// Pair by pair what 0 brings is halved between two again and again: speeds of approach are 1/2^k.
BOOST_AUTO_TEST_CASE(tells_that_three_that_touch_and_stick_are_never_done) {
  HardSpheres gas(row_of({-2, 0, 1}, {1, 0, 0}), open, ConstantRestitution{0.0});
  State state = start(gas);
  std::vector<double> speeds;
  const Outcome outcome = gas.advance(state, 2.0, [&](const Collision& one) { speeds.push_back(one.approach_speed); });
  BOOST_TEST((outcome.failure == Failure::accumulating));
  BOOST_TEST(outcome.accumulation == 1.0);
  BOOST_TEST(contains(outcome.reason, "particles 0, 1, 2 meet infinitely often by t = 1 s"));
  for (std::size_t k = 0; k < 20; ++k)
    BOOST_TEST(speeds.at(k) == std::ldexp(1.0, -static_cast<int>(k)), tolerance(1e-9));
  BOOST_TEST(close(state.v.head(3), Vector3d::Constant(1.0 / 3.0), {.absolute = 1e-8}));
}

// The first that is hit does not come back to the other: 0 and 1 lie below 2, hit from above.
BOOST_AUTO_TEST_CASE(is_done_with_three_that_stick_but_part) {
  HardSpheres gas(particles({{.position = {0, 0, 0}, .mass = 1, .radius = 0.5},
                             {.position = {1, 0, 0}, .mass = 1, .radius = 0.5},
                             {.position = {0.5, 3, 0}, .velocity = {0, -1, 0}, .mass = 1, .radius = 0.5}}),
                  open, ConstantRestitution{0.0});
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 5.0);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.impacts == 2);
  BOOST_TEST(outcome.overlap < 1e-15);
}

// Just after 0 has hit 1, gap and closing speed of 1 and 2 are 1 m and 1 m/s. Every hit makes of gap g, closing speed u
// and parting speed w of the other pair w g/u, (1 + e) u/2 - w and e u. For e = 0.05 and w = u/8 that is the mirror
// image, speeds 0.4 and times 0.3125 as large: t = 1/(1 - 0.3125) = 16/11. Gaps fall to an eighth: what is left of them
// when they are lost in the rounding of places would have taken 1e-9 s at the 1e-7 m/s of then.
BOOST_AUTO_TEST_CASE(finds_the_collapse_of_three_and_when) {
  HardSpheres gas(row_of({0, 1, 3}, {-0.125, 0, -1}), open, ConstantRestitution{0.05});
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 2.0);
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST((outcome.failure == Failure::accumulating));
  BOOST_TEST(outcome.accumulation == 16.0 / 11.0, tolerance(1e-8));
  BOOST_TEST(state.t == outcome.accumulation);
  BOOST_TEST(contains(outcome.reason, "particles 0, 1, 2 meet infinitely often by t = 1.45454545"));
  BOOST_TEST(contains(outcome.reason, "inelastic collapse: end the run before, or take a contact time t_c > 0"));
  BOOST_TEST(outcome.impacts > 30);
  BOOST_TEST(outcome.overlap < 1e-14);
}

BOOST_AUTO_TEST_CASE(goes_on_beyond_a_collapse_with_a_contact_time) {
  HardSpheres gas(row_of({0, 1, 3}, {-0.125, 0, -1}), open, ConstantRestitution{0.05}, Frictionless{}, 1e-3);
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 2.0);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.impacts < 20);
  BOOST_TEST(gas.tally().elastic_impacts > 0);
  BOOST_TEST(gas.tally().elastic_impacts < outcome.impacts);
  BOOST_TEST((state.v[0] < state.v[1] && state.v[1] < state.v[2]));
  BOOST_TEST(state.v.head(3).sum() == -1.125, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(gives_up_a_body_held_between_two_that_cannot_move) {
  Particles held = row_of({-1, 0, 1}, {0, 1, 0});
  held.immovable = {true, false, true};
  HardSpheres gas(held);
  State state = start(gas);
  BOOST_TEST(contains(gas.advance(state, 1.0).reason, "meet without end by t = 0 s, held from opposite sides"));
}

BOOST_AUTO_TEST_CASE(keeps_what_sticks_together_without_end) {
  HardSpheres gas(particles({{.position = {0.1, 0.2, 0.3}, .velocity = {1.1, 1.3, 0.7}, .mass = 1, .radius = 0.3},
                             {.position = {1.1, 1.2, 1.3}, .velocity = {0.1, 0.3, -0.3}, .mass = 3, .radius = 0.3}}),
                  periodic(2, 2, 2), ConstantRestitution{0.0});
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 1e4);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.impacts == 1);
  BOOST_TEST(outcome.overlap < 1e-12);
  BOOST_TEST(separation(gas.domain(), position(state, 0), position(state, 1)).norm() == 0.6, tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(solves_what_is_least) {
  HardSpheres none(Particles{.position = Vectors(0, 3), .velocity = Vectors(0, 3), .mass = {}, .radius = {}});
  State state = start(none);
  BOOST_TEST((none.advance(state, 1.0).status == Status::reached));
  BOOST_TEST(state.t == 1.0);
  HardSpheres one(row_of({0.25}, {1.0}), periodic(2));
  state = start(one);
  BOOST_TEST(one.advance(state, 1e6).impacts == 0);
  BOOST_TEST(state.r[0] == 1e6 + 0.25);
  HardSpheres rest(row_of({0, 1, 2}, {0, 0, 0}));
  state = start(rest);
  BOOST_TEST(rest.advance(state, 1e9).impacts == 0);
  BOOST_TEST(close(state.r.head(3), Vector3d(0, 1, 2), {.absolute = 0.0}));
  HardSpheres two(particles({{.position = {0.5, 0.25, 0}, .velocity = {1, 0, 0}, .mass = 1, .radius = 0.1},
                             {.position = {0.5, 0.75, 0}, .mass = 1, .radius = 0.1}}),
                  periodic(1, 1, 1));
  state = start(two);
  BOOST_TEST(two.advance(state, 1e4).impacts == 0);
  BOOST_TEST(state.r[0] == 1e4 + 0.5, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(expands_without_end_in_open_space) {
  Particles cloud = apart(random_cloud(60, Vector3d::Constant(5.0), 0.3, 0.4), 50.0);
  HardSpheres gas(cloud);
  State state = start(gas);
  const Outcome outcome = gas.advance(state, 1e9);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.impacts > 5);
  BOOST_TEST(gas.tally().crossings < 100000);
  BOOST_TEST(kinetic_energy(cloud.mass, velocities(state)) == kinetic_energy(cloud.mass, cloud.velocity),
             tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(leaves_the_moment_of_an_impact_whose_recorder_throws) {
  HardSpheres gas(row_of({0, 3}, {1, 0}));
  State state = start(gas);
  const auto refuse = [](const Collision&) { throw std::runtime_error("enough"); };
  BOOST_CHECK_EXCEPTION((void)gas.advance(state, 4.0, refuse), std::runtime_error, says("enough"));
  BOOST_TEST(state.t == 2.0);
  BOOST_TEST(close(state.r.head(2), Eigen::Vector2d(2, 3), {.absolute = 0.0}));
  BOOST_TEST(close(state.v.head(2), Eigen::Vector2d(0, 1), {.absolute = 0.0}));
  BOOST_TEST((gas.advance(state, 4.0).status == Status::reached));
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_meant) {
  HardSpheres gas(row_of({0, 0.75, 3}, {0, 0, 0}));
  State state = start(gas);
  CHECK_REFUSED(gas.advance(state, 1.0), "spheres 0 and 1 overlap by 0.25 m, deepest of all: move them apart");
  HardSpheres low(row_of({0}, {0}), {.walls = {Wall{}}});
  state = start(low);
  CHECK_REFUSED(low.advance(state, 1.0), "sphere 0 and wall 0 overlap by 0.5 m, deepest of all");
  CHECK_REFUSED(low.advance(state, -1.0), "end time must be finite and not before 0 s, got -1 s");
  state.y.setZero(1);
  CHECK_REFUSED(low.advance(state, 1.0), "y must be empty");
  state = {.t = 0.0, .r = Eigen::VectorXd::Zero(6), .v = Eigen::VectorXd::Zero(3)};
  CHECK_REFUSED(low.advance(state, 1.0), "r and v of 1 particles must hold 3 numbers, got 6 and 3");
  state = start(low);
  state.v[0] = not_a_number;
  CHECK_REFUSED(low.advance(state, 1.0), "the state must be finite");
  CHECK_REFUSED(HardSpheres(row_of({0}, {0}), periodic(1.9)), "must be at least two diameters of the largest body");
  CHECK_REFUSED(HardSpheres(row_of({0}, {0}), open, ConstantRestitution{1.5}), "e must lie in [0, 1], got 1.5");
  CHECK_REFUSED(HardSpheres(row_of({0}, {0}), open, Restitution{}, Friction{.mu_s = -1.0}), "friction: mu_s");
  CHECK_REFUSED(HardSpheres(row_of({0}, {0}), open, Restitution{}, Frictionless{}, -1.0),
                "contact_time must be finite and not negative, got -1 s");
  for (const double length : {1e-80, 1e80}) {
    Particles far = row_of({0, 3}, {1, 0});
    far.position *= length, far.velocity *= length, far.radius *= length;
    HardSpheres other(far);
    state = start(other);
    CHECK_REFUSED(other.advance(state, 4.0), "places and speeds must be at most 1e+70 m and m/s");
  }
  Particles bad = row_of({0}, {0});
  bad.radius[0] = -1.0;
  CHECK_REFUSED(HardSpheres(bad), "radii must be finite and not negative, got -1 m");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::hard_spheres_test
