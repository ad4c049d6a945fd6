#include <particulate/contact/resolution.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "close.hpp"

namespace tests::resolution_test {

using namespace particulate::contact;
using particulate::contact::Resolved;
using namespace particulate::kinematics;

// Bodies that touch, without a place: directions are all that impulses ask for.
struct Cluster {
  Vectors velocity;
  Eigen::VectorXd inverse_mass;
  std::vector<Touch> contacts{};

  double energy() const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < velocity.rows(); ++i) {
      if (inverse_mass[i] > 0.0) sum += 0.5 * velocity.row(i).squaredNorm() / inverse_mass[i];
    }
    return sum;
  }
  Eigen::Vector3d momentum() const { return velocity.transpose() * inverse_mass.cwiseInverse(); }
  double fastest_approach() const {
    double fastest = 0.0;
    for (const Touch& touch : contacts) {
      Eigen::Vector3d approach = velocity.row(touch.i);
      if (touch.j >= 0) approach -= velocity.row(touch.j).transpose();
      fastest = std::max(fastest, approach.dot(touch.n));
    }
    return fastest;
  }
  template <class R, class F>
  Resolved resolve(const ContactResolver<R, F>& law, double duration = 0.0) {
    return law(contacts, inverse_mass, duration, velocity);
  }
};

template <class F = Frictionless>
ContactResolver<ConstantRestitution, F> with(double e, F friction = {}, Resolution order = Resolution::sequential) {
  return {{e}, friction, order};
}

// Equal unit masses in a row along x, the first on its way to the others at 1 m/s.
Cluster row_of(Eigen::Index n) {
  Cluster row{.velocity = Vectors::Zero(n, 3), .inverse_mass = Eigen::VectorXd::Ones(n)};
  row.velocity(0, 0) = 1.0;
  for (Eigen::Index k = 0; k + 1 < n; ++k) row.contacts.push_back({.i = k, .j = k + 1, .n = Eigen::Vector3d::UnitX()});
  return row;
}

// Particle 0 hits 1 and 2 at once, 60 degrees apart: centres of equal spheres that touch one another pairwise.
Cluster symmetric_hit() {
  const double c = std::sqrt(0.75);
  Cluster hit{.velocity = Vectors::Zero(3, 3), .inverse_mass = Eigen::VectorXd::Ones(3)};
  hit.velocity(0, 0) = 1.0;
  hit.contacts = {{.i = 0, .j = 1, .n = {c, 0.5, 0.0}},
                  {.i = 0, .j = 2, .n = {c, -0.5, 0.0}},
                  {.i = 1, .j = 2, .n = {0.0, -1.0, 0.0}}};
  return hit;
}

// Bodies of random places, masses and velocities, of which most pairs touch, perhaps on tilted floors. There is always
// a way to part: away from the middle, and up.
Cluster random_cluster(std::mt19937& engine, bool floors) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Eigen::Index n = 2 + static_cast<Eigen::Index>(engine() % 5);
  Cluster cluster{.velocity = Vectors::NullaryExpr(n, 3, [&] { return uniform(engine); }),
                  .inverse_mass = Eigen::VectorXd::NullaryExpr(n, [&] { return std::pow(10.0, uniform(engine)); })};
  const Vectors place = Vectors::NullaryExpr(n, 3, [&] { return uniform(engine); });
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 1; j < n; ++j) {
      if (engine() % 3 != 0) {
        cluster.contacts.push_back({.i = i, .j = j, .n = (place.row(j) - place.row(i)).normalized()});
      }
    }
    const Eigen::Vector3d down(0.5 * uniform(engine), 0.5 * uniform(engine), -1.0);
    if (floors && engine() % 3 == 0) cluster.contacts.push_back({.i = i, .j = -1, .n = down.normalized()});
  }
  return cluster;
}

// The same bodies under other numbers, their contacts in reverse order and seen from the other side.
Cluster renumbered(const Cluster& cluster, const std::vector<Eigen::Index>& number) {
  Cluster other = cluster;
  for (Eigen::Index i = 0; i < cluster.velocity.rows(); ++i) {
    const Eigen::Index to = number[static_cast<std::size_t>(i)];
    other.velocity.row(to) = cluster.velocity.row(i);
    other.inverse_mass[to] = cluster.inverse_mass[i];
  }
  std::reverse(other.contacts.begin(), other.contacts.end());
  for (Touch& touch : other.contacts) {
    touch.i = number[static_cast<std::size_t>(touch.i)];
    if (touch.j < 0) continue;
    touch = {.i = number[static_cast<std::size_t>(touch.j)],
             .j = touch.i,
             .n = -touch.n,
             .acceleration = -touch.acceleration};
  }
  return other;
}

template <class R, class F>
void check_numbering(const Cluster& start, const ContactResolver<R, F>& law, double relative) {
  std::vector<Eigen::Index> number(static_cast<std::size_t>(start.velocity.rows()));
  std::iota(number.begin(), number.end(), 0);
  Cluster first = start;
  first.resolve(law);
  do {
    Cluster other = renumbered(start, number);
    other.resolve(law);
    Vectors back = other.velocity;
    for (std::size_t i = 0; i < number.size(); ++i) {
      back.row(static_cast<Eigen::Index>(i)) = other.velocity.row(number[i]);
    }
    BOOST_REQUIRE(close(back, first.velocity, {.relative = relative, .absolute = relative}));
  } while (std::next_permutation(number.begin(), number.end()));
}

BOOST_AUTO_TEST_SUITE(sequential)

BOOST_AUTO_TEST_CASE(passes_a_hit_through_a_cradle) {
  Cluster cradle = row_of(5);
  const Resolved done = cradle.resolve(with(1.0));
  Vectors expected = Vectors::Zero(5, 3);
  expected(4, 0) = 1.0;
  BOOST_TEST(close(cradle.velocity, expected, {.absolute = 4.0 * eps}));
  BOOST_TEST(done.impacts == 4);
  BOOST_TEST(done.largest_impulse == 1.0);
  BOOST_TEST(done.unsettled.empty());
}

// At e = 0 a row moves on as one body with the momentum of the first.
BOOST_AUTO_TEST_CASE(joins_a_row_without_restitution) {
  for (const Eigen::Index n : {2, 3, 8}) {
    Cluster row = row_of(n);
    BOOST_TEST(row.resolve(with(0.0)).unsettled.empty());
    Vectors expected = Vectors::Zero(n, 3);
    expected.col(0).setConstant(1.0 / static_cast<double>(n));
    BOOST_TEST(close(row.velocity, expected, {.absolute = 1e-12}));
  }
}

// By symmetry both pushes are P: u = c for each, W = (2, c^2 - 1/4; .., 2) = (2, 1/2; 1/2, 2), so P = 2 c/2.5 = 0.8 c,
// c^2 = 3/4: v_0 = 1 - 2 (0.8) (3/4) = -0.2, v_1 = 0.8 c (c, 1/2) = (0.6, 0.4 c).
BOOST_AUTO_TEST_CASE(keeps_the_symmetry_and_the_energy_of_a_symmetric_hit) {
  Cluster hit = symmetric_hit();
  const Resolved done = hit.resolve(with(1.0));
  const double across = 0.4 * std::sqrt(0.75);
  BOOST_TEST(close(hit.velocity, Vectors{{-0.2, 0.0, 0.0}, {0.6, across, 0.0}, {0.6, -across, 0.0}},
                   {.relative = 1e-14, .absolute = 1e-15}));
  BOOST_TEST(hit.energy() == 0.5, tolerance(1e-14));
  BOOST_TEST(done.impacts == 2);
  BOOST_TEST(done.largest_impulse == 0.8 * std::sqrt(0.75), tolerance(1e-14));
}

// Of a group, (1 - e^2)/2 u^T W^-1 u: u^T W^-1 u = 2 (3/4)/2.5 = 0.6.
BOOST_AUTO_TEST_CASE(takes_the_energy_of_the_closed_form_from_a_group) {
  for (const double e : {0.0, 0.5, 0.9}) {
    Cluster hit = symmetric_hit();
    hit.resolve(with(e));
    BOOST_TEST(hit.energy() == 0.5 - 0.3 * (1.0 - e * e), tolerance(1e-14));
  }
}

// (1, 0, -1) with e = 0.5: both contacts of the middle body close at 1 m/s, W = (2, -1; -1, 2), wanted 1.5: P = 1.5.
BOOST_AUTO_TEST_CASE(resolves_ties_at_once) {
  Cluster row = row_of(3);
  row.velocity(2, 0) = -1.0;
  BOOST_TEST(row.resolve(with(0.5)).impacts == 2);
  BOOST_TEST(close(row.velocity.col(0), Eigen::Vector3d(-0.5, 0.0, 0.5), {.absolute = 1e-15}));
}

// (1, 0, -0.5): the first contact closes faster, gives (0.25, 0.75, -0.5) at e = 0.5, then the second closes at 1.25:
// 0.75 - 0.9375 = -0.1875 and 0.4375; the first again, at 0.4375: 0.25 - 0.328125 and 0.140625.
BOOST_AUTO_TEST_CASE(takes_the_fastest_first) {
  Cluster row = row_of(3);
  row.velocity(2, 0) = -0.5;
  std::reverse(row.contacts.begin(), row.contacts.end());
  BOOST_TEST(row.resolve(with(0.5)).impacts == 3);
  BOOST_TEST(close(row.velocity.col(0), Eigen::Vector3d(-0.078125, 0.140625, 0.4375), {.absolute = 1e-15}));
}

BOOST_AUTO_TEST_CASE(does_not_depend_on_the_numbering) {
  std::mt19937 engine(7);
  check_numbering(symmetric_hit(), with(0.7), 1e-13);
  check_numbering(symmetric_hit(), with(0.7, Friction{.mu_s = 0.4, .mu_d = 0.2}), 1e-13);
  check_numbering(row_of(5), with(0.7), 1e-12);
  for (int k = 0; k < 4; ++k) {
    check_numbering(random_cluster(engine, true), with(0.5, Friction{.mu_s = 0.3, .mu_d = 0.2}), 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(never_gains_energy_nor_loses_momentum_and_ends_without_approach) {
  std::mt19937 engine(1);
  for (int k = 0; k < 1500; ++k) {
    const double e = k % 3 == 0 ? 1.0 : static_cast<double>(k % 7) / 7.0;
    const double mu = static_cast<double>(k % 5) / 4.0;
    const bool floors = k % 2 == 0;
    Cluster cluster = random_cluster(engine, floors);
    const double energy = cluster.energy();
    const Eigen::Vector3d momentum = cluster.momentum();
    const Resolved done = cluster.resolve(with(e, Friction{.mu_s = mu, .mu_d = 0.5 * mu}));
    BOOST_REQUIRE(done.unsettled == "");
    BOOST_REQUIRE_LE(cluster.energy(), energy * (1.0 + 1e-13));
    BOOST_REQUIRE_LE(cluster.fastest_approach(), 1e-12);
    if (!floors) BOOST_REQUIRE(close(cluster.momentum(), momentum, {.absolute = 1e-12}));
  }
}

// Symmetric hits with friction: both contacts of the hitting body rub it, at rest or not across the hit.
BOOST_AUTO_TEST_CASE(takes_energy_by_friction_from_a_group) {
  for (const double mu : {0.01, 0.1, 1.0, 100.0}) {
    for (const double side : {0.0, 0.3, 5.0}) {
      Cluster smooth = symmetric_hit(), rough = symmetric_hit();
      smooth.velocity(0, 2) = rough.velocity(0, 2) = side;
      smooth.resolve(with(0.8));
      const Eigen::Vector3d momentum = rough.momentum();
      const Resolved done = rough.resolve(with(0.8, Friction{.mu_s = mu, .mu_d = mu}));
      BOOST_TEST(done.unsettled == "");
      BOOST_TEST(rough.energy() < smooth.energy());
      BOOST_TEST(close(rough.momentum(), momentum, {.absolute = 1e-14}));
      BOOST_TEST(rough.velocity(1, 0) == rough.velocity(2, 0), tolerance(1e-13));
    }
  }
}

// Four walls of a funnel, each at 60 degrees from the hit: restitution makes -0.8 m/s of 1 m/s. Against each wall
// sticking stops the slip -0.8 (x - n/2), together 0.8 (4 - 4/4) = 2.4 m/s: three times what there is, so a third acts.
BOOST_AUTO_TEST_CASE(lets_friction_of_a_group_stop_no_more_than_there_is) {
  const double c = std::sqrt(0.75);
  Cluster funnel{.velocity = Vectors{{1.0, 0.0, 0.0}}, .inverse_mass = Eigen::VectorXd::Constant(1, 0.5)};
  for (const Eigen::Vector3d& n : {Eigen::Vector3d(0.5, c, 0.0), Eigen::Vector3d(0.5, -c, 0.0),
                                   Eigen::Vector3d(0.5, 0.0, c), Eigen::Vector3d(0.5, 0.0, -c)}) {
    funnel.contacts.push_back({.i = 0, .j = -1, .n = n});
  }
  const Resolved done = funnel.resolve(with(0.8, Friction{.mu_s = 100.0, .mu_d = 100.0}));
  BOOST_TEST(done.impacts == 4);
  BOOST_TEST(close(funnel.velocity, Vectors::Zero(1, 3), {.absolute = 1e-15}));
}

// A heap at rest on itself stays at rest: nothing approaches.
BOOST_AUTO_TEST_CASE(leaves_bodies_at_rest_and_parting_bodies_alone) {
  Cluster heap = symmetric_hit();
  heap.velocity.setZero();
  BOOST_TEST(heap.resolve(with(0.5, Friction{.mu_s = 1.0, .mu_d = 1.0})).impacts == 0);
  BOOST_TEST(close(heap.velocity, Vectors::Zero(3, 3), {}));
  heap.velocity(0, 0) = -1.0;
  const Vectors before = heap.velocity;
  BOOST_TEST(heap.resolve(with(0.5, Friction{.mu_s = 1.0, .mu_d = 1.0})).impacts == 0);
  BOOST_TEST(close(heap.velocity, before, {}));
  Cluster none{.velocity = Vectors(0, 3), .inverse_mass = Eigen::VectorXd(0)};
  BOOST_TEST(none.resolve(with(0.5)).impacts == 0);
}

BOOST_AUTO_TEST_CASE(does_not_take_the_rounding_of_a_common_velocity_for_an_approach) {
  Cluster row = row_of(8);
  const Eigen::Vector3d along = Eigen::Vector3d(1.0, 2.0, -3.0).normalized();
  row.velocity.row(0) = 1e-6 * along.transpose();
  for (Touch& touch : row.contacts) touch.n = along;
  row.velocity.rowwise() += Eigen::RowVector3d(1e6, -3e6, 1e5) / 3.0;
  const Resolved done = row.resolve(with(0.0));
  BOOST_TEST(done.unsettled.empty());
  BOOST_TEST(done.impacts < 300);
  BOOST_TEST(row.fastest_approach() <= 4.0 * eps * 1.1e6);
}

// In a corner: both walls are met at once or in turn, and each reverses its own component.
BOOST_AUTO_TEST_CASE(reverses_both_components_in_a_corner) {
  for (const double down : {1.0, 0.5}) {
    Cluster corner{.velocity = Vectors{{-1.0, 2.0, -down}}, .inverse_mass = Eigen::VectorXd::Constant(1, 0.25)};
    corner.contacts = {{.i = 0, .j = -1, .n = {-1.0, 0.0, 0.0}}, {.i = 0, .j = -1, .n = {0.0, 0.0, -1.0}}};
    BOOST_TEST(corner.resolve(with(0.5)).impacts == 2);
    BOOST_TEST(close(corner.velocity, Vectors{{0.5, 2.0, 0.5 * down}}, {}));
  }
}

// Two walls in one plane are one wall met twice: W is singular, and the pushes share.
BOOST_AUTO_TEST_CASE(shares_among_more_contacts_than_the_body_can_move_in) {
  Cluster doubled{.velocity = Vectors{{0.0, 2.0, -1.0}}, .inverse_mass = Eigen::VectorXd::Ones(1)};
  doubled.contacts = {{.i = 0, .j = -1, .n = {0.0, 0.0, -1.0}}, {.i = 0, .j = -1, .n = {0.0, 0.0, -1.0}}};
  const Resolved done = doubled.resolve(with(0.5));
  BOOST_TEST(close(doubled.velocity, Vectors{{0.0, 2.0, 0.5}}, {.relative = 1e-15}));
  BOOST_TEST(done.largest_impulse == 0.75, tolerance(1e-15));
}

// Slow bodies are not at rest because others elsewhere are fast.
BOOST_AUTO_TEST_CASE(settles_each_cluster_by_itself) {
  Cluster alone = row_of(3);
  alone.velocity *= 1e-16;
  Cluster both{.velocity = Vectors::Zero(5, 3), .inverse_mass = Eigen::VectorXd::Ones(5)};
  both.velocity.topRows(3) = alone.velocity;
  both.velocity(3, 0) = 1.0;
  both.contacts = alone.contacts;
  both.contacts.push_back({.i = 3, .j = 4, .n = Eigen::Vector3d::UnitX()});
  alone.resolve(with(0.5));
  BOOST_TEST(both.resolve(with(0.5)).unsettled.empty());
  BOOST_TEST(close(both.velocity.topRows(3), alone.velocity, {}));
  BOOST_TEST(close(both.velocity.bottomRows(2).col(0), Eigen::Vector2d(0.25, 0.75), {}));
}

// A light body between a heavy one and a driven one bounces off both; nothing moves the driven one.
BOOST_AUTO_TEST_CASE(does_not_move_what_is_immovable) {
  Cluster pinched = row_of(3);
  pinched.inverse_mass << 0.01, 1.0, 0.0;
  pinched.velocity(2, 0) = -0.25;
  BOOST_TEST(pinched.resolve(with(0.5)).unsettled.empty());
  BOOST_TEST(close(pinched.velocity.row(2), Eigen::RowVector3d(-0.25, 0.0, 0.0), {}));
  BOOST_TEST(pinched.velocity(0, 0) < pinched.velocity(1, 0) + 1e-12);
  BOOST_TEST(pinched.velocity(1, 0) <= -0.25 + 1e-12);
}

BOOST_AUTO_TEST_CASE(exchanges_nothing_between_two_immovable_bodies) {
  for (const Resolution order : {Resolution::sequential, Resolution::summed}) {
    Cluster driven = row_of(2);
    driven.inverse_mass.setZero();
    driven.contacts.push_back({.i = 0, .j = -1, .n = Eigen::Vector3d::UnitX()});
    const Vectors before = driven.velocity;
    const Resolved done = driven.resolve(with(0.5, Friction{.mu_s = 1.0, .mu_d = 1.0}, order));
    BOOST_TEST(done.impacts == 0);
    BOOST_TEST(done.unsettled.empty());
    BOOST_TEST(close(driven.velocity, before, {}));
  }
}

// Masses apart by 1e12 in one group: the light body turns between two heavy ones that close on it equally fast.
BOOST_AUTO_TEST_CASE(takes_mass_ratios_of_a_million_millions_in_a_group) {
  Cluster row = row_of(3);
  row.velocity(2, 0) = -1.0;
  row.inverse_mass << 1e-12, 1.0, 1e-12;
  // Symmetric: W = (1 + d, -1; -1, 1 + d), wanted 1.5, so P = 1.5/d with d = 1e-12: each heavy one turns to -+0.5.
  BOOST_TEST(row.resolve(with(0.5)).unsettled.empty());
  BOOST_TEST(close(row.velocity.col(0), Eigen::Vector3d(-0.5, 0.0, 0.5), {.absolute = 2e-4}));
}

// A light body carries the momentum of a heavy one to another in as many hits as their ratio: too many.
BOOST_AUTO_TEST_CASE(says_when_it_gives_up) {
  Cluster pinched = row_of(3);
  pinched.inverse_mass[1] = 1e7;
  pinched.contacts[1].overlap = 0.25;
  const Resolved done = pinched.resolve(with(0.0));
  BOOST_TEST(done.unsettled.starts_with(
      "after 10800 rounds of impulses some of 2 contacts that hang together, up to 0.25 m deep, still approach"));
  BOOST_TEST(contains(done.unsettled, "particle 1 is pinched between particle"));
  BOOST_TEST(contains(done.unsettled, "less unequal masses"));
}

// A row of 11 that sticks takes 2947 rounds, of 100 multiplications at least.
BOOST_AUTO_TEST_CASE(gives_up_before_it_crawls) {
  for (const double most_work : {1e4, 1e6}) {
    ContactResolver<ConstantRestitution, Frictionless> law = with(0.0);
    law.most_work = most_work;
    const Resolved done = row_of(11).resolve(law);
    BOOST_TEST(done.unsettled.empty() == (most_work > 3e5), done.unsettled);
    const bool says_so = done.unsettled.find("rounds of impulses some of 10 contacts") != std::string::npos;
    BOOST_TEST((most_work > 3e5 || (says_so && done.impacts < 200)), done.impacts);
  }
}

// Between opposite walls that it touches both, an elastic body approaches one of them whatever happens; another comes
// to rest.
BOOST_AUTO_TEST_CASE(gives_up_on_an_elastic_body_that_is_jammed) {
  for (const double e : {0.5, 1.0}) {
    Cluster jammed{.velocity = Vectors{{1.0, 0.0, 0.0}}, .inverse_mass = Eigen::VectorXd::Ones(1)};
    jammed.contacts = {{.i = 0, .j = -1, .n = {-1.0, 0.0, 0.0}}, {.i = 0, .j = -1, .n = {1.0, 0.0, 0.0}}};
    BOOST_TEST(jammed.resolve(with(e)).unsettled.empty() == (e < 1.0));
    if (e < 1.0) BOOST_TEST(jammed.fastest_approach() <= 1e-13);
  }
}

// Delta_1 = a dt/(1 + e) = 3 0.5/1.5 = 1: 1.5 (2 + 1) of approach are turned into 2 - 4.5.
BOOST_AUTO_TEST_CASE(counts_the_other_forces_in) {
  for (const Resolution order : {Resolution::sequential, Resolution::summed}) {
    Cluster falling{.velocity = Vectors{{0.0, 0.0, -2.0}}, .inverse_mass = Eigen::VectorXd::Ones(1)};
    falling.contacts = {{.i = 0, .j = -1, .n = {0.0, 0.0, -1.0}, .acceleration = {0.0, 0.0, -3.0}}};
    BOOST_TEST(falling.resolve(with(0.5, Frictionless{}, order), 0.5).largest_impulse == 4.5);
    BOOST_TEST(falling.velocity(0, 2) == 2.5);
    falling = {.velocity = Vectors{{0.0, 0.0, -2.0}}, .inverse_mass = Eigen::VectorXd::Ones(1)};
    falling.contacts = {{.i = 0, .j = -1, .n = {0.0, 0.0, -1.0}, .acceleration = {0.0, 0.0, 6.0}}};
    BOOST_TEST(falling.resolve(with(0.5, Frictionless{}, order), 0.5).impacts == 0);
    BOOST_TEST(falling.velocity(0, 2) == -2.0);
  }
}

// e = 1 - 2/4 at 2 m/s; a contact at its second hit has its own.
BOOST_AUTO_TEST_CASE(asks_the_restitution_law_at_each_speed) {
  const ContactResolver<Restitution, Frictionless> law{{.e_o = 1.0, .v_star = 4.0}, {}, Resolution::sequential};
  Cluster row = row_of(3);
  row.velocity(0, 0) = 2.0;
  row.resolve(law);
  // (2, 0): e = 0.5: 0.5 and 1.5. (1.5, 0): e = 0.625: 0.28125 and 1.21875. (0.5, 0.28125) closes at 0.21875 with
  // e = 0.9453125.
  const double push = 0.5 * 1.9453125 * 0.21875;
  BOOST_TEST(close(row.velocity.col(0), Eigen::Vector3d(0.5 - push, 0.28125 + push, 1.21875), {.relative = 1e-14}));
}

// A ball of 1 kg falls at 1 m/s into a groove of 90 degrees whose walls are turned by an angle about it, e = 0, and
// slides along it: the pushes are the cosines of the walls, 1/sqrt 2 each if it is upright, and 0.8 and 0.6, which are
// no tie.
struct Groove {
  double left = std::sqrt(0.5), right = std::sqrt(0.5);  // pushes [N s]
  Eigen::Vector3d wall(double down, double aside) const { return {0.0, aside, -down}; }
  Eigen::RowVector3d after(double along, const Friction& friction) const {
    Cluster ball{.velocity = Vectors{{along, 0.0, -1.0}}, .inverse_mass = Eigen::VectorXd::Ones(1)};
    ball.contacts = {{.i = 0, .j = -1, .n = wall(left, right)}, {.i = 0, .j = -1, .n = wall(right, -left)}};
    const double energy = ball.energy();
    const Resolved done = ball.resolve(with(0.0, friction));
    BOOST_TEST(done.unsettled == "");
    BOOST_TEST(done.energy_change == ball.energy() - energy, tolerance(1e-13));
    return ball.velocity.row(0);
  }
};

// mu_s 1.4 N s holds 0.7 N s: 0.5 m/s stop and 0.71 m/s slide with mu_d 1.4142 N s; alike, 0.7 and 0.71 m/s, with 0.8
// and 0.6 N s of push.
BOOST_AUTO_TEST_CASE(decides_together_which_contacts_of_a_groove_stick) {
  const Friction friction{.mu_s = 0.5, .mu_d = 0.1};
  for (const Groove& groove : {Groove{}, Groove{0.8, 0.6}, Groove{0.6, 0.8}, Groove{1.0, 0.0}}) {
    const double sum = groove.left + groove.right;
    for (const double along : {0.49 * sum, 0.51 * sum, -0.51 * sum, 1e3}) {
      const double left = std::abs(along) < 0.5 * sum ? 0.0 : along - std::copysign(0.1 * sum, along);
      BOOST_TEST(close(groove.after(along, friction), Eigen::RowVector3d(left, 0.0, 0.0),
                       {.relative = 1e-13, .absolute = 1e-14}));
    }
  }
  BOOST_TEST(close(Groove{}.after(0.5, friction), Eigen::RowVector3d::Zero().eval(), {.absolute = 1e-15}));
}

// Down the diagonal of a corner at 1 m/s: P = (1 + e)/sqrt 3 at each of three walls, and e m/s back. Each wall sees e
// sqrt(2/3) of slip; all three can stop it, or each takes mu_d P sqrt(2/3) from the way back.
BOOST_AUTO_TEST_CASE(rubs_at_three_walls_of_a_corner) {
  const double e = 0.5, third = 1.0 / std::sqrt(3.0);
  const auto after = [&](const Friction& friction) {
    Cluster corner{.velocity = Vectors{{-third, -third, -third}}, .inverse_mass = Eigen::VectorXd::Ones(1)};
    for (const Eigen::Index k : {0, 1, 2}) corner.contacts.push_back({.i = 0, .j = -1, .n = -Eigen::Vector3d::Unit(k)});
    BOOST_TEST(corner.resolve(with(e, friction)).impacts == 3);
    return corner.velocity.row(0).sum() * third;
  };
  BOOST_TEST(std::abs(after({.mu_s = 10.0, .mu_d = 0.1})) <= 1e-15);
  BOOST_TEST(after({.mu_s = 0.1, .mu_d = 0.1}) == e - 3.0 * 0.1 * (1.0 + e) * third * std::sqrt(2.0 / 3.0),
             tolerance(1e-13));
}

// A ball between two, c^2 = 3/4, s = 1/2, e = 0: P = c/(2 c^2 + 1) = 0.4 c each leaves it 1 - 2 P c = 0.4 m/s and a
// slip of 0.4 s at both. To stop it takes 0.2/(2 s^2 + 1) = 2/15 N s, 0.385 P, and leaves the ball 0.4 - 2 s 2/15, the
// others half of the rest, and P s - c 2/15 aside. Friction parts the contacts, so nothing follows.
BOOST_AUTO_TEST_CASE(rubs_a_ball_between_two) {
  const double c = std::sqrt(0.75);
  for (const auto& [mu_s, P_t] : {std::pair{0.39, 2.0 / 15.0}, std::pair{0.38, 0.1 * 0.4 * c}}) {
    Cluster hit = symmetric_hit();
    BOOST_TEST(hit.resolve(with(0.0, Friction{.mu_s = mu_s, .mu_d = 0.1})).impacts == 2);
    const double aside = 0.2 * c - c * P_t, ahead = 0.3 + 0.5 * P_t;
    BOOST_TEST(close(hit.velocity, Vectors{{0.4 - P_t, 0.0, 0.0}, {ahead, aside, 0.0}, {ahead, -aside, 0.0}},
                     {.relative = 1e-13, .absolute = 1e-15}));
  }
}

// A row of three that is hit aslant: with e = 0 the ends move as one, each contact pushed by 2/3 and 1/3 N s; friction
// that holds makes them move as one across the row too, and no answer depends on which contact was first.
BOOST_AUTO_TEST_CASE(sticks_through_contacts_that_are_hit_one_after_the_other) {
  Cluster row = row_of(3);
  row.velocity(0, 1) = 0.3;
  BOOST_TEST(row.resolve(with(0.0, Friction{.mu_s = 0.5, .mu_d = 0.1})).unsettled == "");
  BOOST_TEST(
      close(row.velocity, Vectors{{1.0, 0.3, 0.0}, {1.0, 0.3, 0.0}, {1.0, 0.3, 0.0}} / 3.0, {.absolute = 1e-12}));
}

// Two contacts that are hit equally fast stay so where rounding of a common velocity parts their speeds by 4e-9.
BOOST_AUTO_TEST_CASE(knows_a_symmetric_hit_in_a_moving_frame) {
  const Eigen::Matrix3d turn = Eigen::Quaterniond(1.0, 2.0, 3.0, 4.0).normalized().toRotationMatrix();
  const Eigen::RowVector3d frame = 7.0 * Eigen::RowVector3d(2e4, -1e4, 3e4) / 3.0;
  Cluster hit = symmetric_hit();
  hit.velocity *= 1e-3 * turn.transpose();
  for (Touch& touch : hit.contacts) touch.n = turn * touch.n;
  Cluster moving = hit;
  moving.velocity.rowwise() += frame;
  hit.resolve(with(1.0));
  moving.resolve(with(1.0));
  moving.velocity.rowwise() -= frame;
  BOOST_TEST(close(moving.velocity, hit.velocity, {.absolute = 1e-10}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(summed)

// Each of two contacts acts as if alone: P = 2 c/2 = c, v_0 = 1 - 2 c^2 = -0.5, v_1 = c (c, 1/2): energy
// (0.25 + 2 (3/4))/2 = 0.875, a gain of 0.375.
BOOST_AUTO_TEST_CASE(gains_three_quarters_of_the_energy_of_a_symmetric_hit) {
  Cluster hit = symmetric_hit();
  const Resolved done = hit.resolve(with(1.0, Frictionless{}, Resolution::summed));
  BOOST_TEST(done.impacts == 2);
  BOOST_TEST(hit.velocity(0, 0) == -0.5, tolerance(1e-15));
  BOOST_TEST(hit.energy() == 0.5 + 0.375, tolerance(1e-15));
  BOOST_TEST(close(hit.momentum(), Eigen::Vector3d(1.0, 0.0, 0.0), {.relative = 1e-15, .absolute = 1e-15}));
}

BOOST_AUTO_TEST_CASE(stops_a_cradle_after_one_impact) {
  Cluster cradle = row_of(5);
  BOOST_TEST(cradle.resolve(with(1.0, Frictionless{}, Resolution::summed)).impacts == 1);
  Vectors expected = Vectors::Zero(5, 3);
  expected(1, 0) = 1.0;
  BOOST_TEST(close(cradle.velocity, expected, {}));
}

// A single contact leaves no choice.
BOOST_AUTO_TEST_CASE(agrees_with_sequential_on_one_contact) {
  Cluster one = row_of(2), other = row_of(2);
  one.velocity(0, 1) = other.velocity(0, 1) = 0.75;
  one.inverse_mass[1] = other.inverse_mass[1] = 3.0;
  const Friction rough{.mu_s = 0.3, .mu_d = 0.1};
  const Resolved summed = one.resolve(with(0.5, rough, Resolution::summed));
  const Resolved sequential = other.resolve(with(0.5, rough));
  BOOST_TEST(close(one.velocity, other.velocity, {.relative = 1e-15, .absolute = 1e-16}));
  BOOST_TEST(summed.largest_impulse == sequential.largest_impulse, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(keeps_the_momentum) {
  std::mt19937 engine(3);
  for (int k = 0; k < 200; ++k) {
    Cluster cluster = random_cluster(engine, false);
    const Eigen::Vector3d momentum = cluster.momentum();
    cluster.resolve(with(0.5, Friction{.mu_s = 0.5, .mu_d = 0.25}, Resolution::summed));
    BOOST_REQUIRE(close(cluster.momentum(), momentum, {.absolute = 1e-13}));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::resolution_test
