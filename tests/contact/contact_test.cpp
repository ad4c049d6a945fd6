#include <particulate/contact/contact.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "close.hpp"
#include "clouds.hpp"
#include "moment.hpp"

namespace tests::contact_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::schemes;

const Space room{{Wall{.point = {0.0, 0.0, -1.0}, .normal = {0.0, 0.0, 1.0}},
                  Wall{.point = {4.0, 9.0, 9.0}, .normal = {-1.0, 0.0, 0.0}}}};

static_assert(Impacts<Contact<>> && Impacts<Contact<Restitution, Friction>> && Validated<Contact<>>);
static_assert(!Force<Contact<>, Space>, "a contact is no force");
static_assert(!Impacts<Friction>);
static_assert(Conservative<Contact<>, Space>, "a scene with contacts can book its energy");

// A domain of one's own that is what Space is.
struct Own {
  Space space;
};
Eigen::Vector3d separation(const Own& own, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return separation(own.space, from, to);
}
std::span<const Wall> walls(const Own& own) { return own.space.walls; }

// Three spheres along x: the first two overlap by 0.5, the last touches the second.
Moment in_a_row() {
  return {{.position = Vectors{{0.0, 0.0, 0.0}, {1.5, 0.0, 0.0}, {3.0, 0.0, 0.0}},
           .velocity = Vectors{{2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}},
           .mass = Eigen::Vector3d(1.0, 2.0, 4.0),
           .radius = Eigen::Vector3d(1.0, 1.0, 0.5)}};
}

template <class C, class D>
tests::Resolved resolved(const C& law, const Moment& moment, const D& domain, const Vectors& force, double dt) {
  return tests::resolved(law, moment, find_touching(domain, moment.at()), force, dt);
}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_the_defaults_and_every_combination) {
  BOOST_CHECK_NO_THROW(validate(Contact{}));
  const Friction rough{.mu_s = 0.2, .mu_d = 0.1};
  BOOST_CHECK_NO_THROW(validate(Contact<ConstantRestitution, Friction>{.friction = rough}));
  BOOST_CHECK_NO_THROW(validate(Contact<Restitution, Friction>{.restitution = {.e_o = 0.5}, .friction = rough}));
  BOOST_CHECK_NO_THROW(validate(Contact<Restitution>{.resolution = Resolution::summed}));
}

BOOST_AUTO_TEST_CASE(refuses_what_its_parts_refuse) {
  const auto refuses = [](const auto& law, const char* words) { CHECK_REFUSED(validate(law), words); };
  refuses(Contact<>{.restitution = {1.5}}, "restitution: e must lie in [0, 1], got 1.5");
  refuses(Contact<Restitution>{.restitution = {.v_star = -1.0}}, "restitution: v_star must be positive");
  refuses(Contact<ConstantRestitution, Friction>{.friction = {.mu_s = 0.1, .mu_d = 0.2}},
          "friction: mu_s must be finite and at least mu_d = 0.2, got 0.1");
}

BOOST_AUTO_TEST_CASE(refuses_a_duration_beyond_the_step_and_a_resolution_that_is_none) {
  for (const double gamma : {-0.01, 1.0, not_a_number}) {
    CHECK_REFUSED(validate(Contact<>{.gamma = gamma}), "contact: gamma must lie in [0, 1), got ");
  }
  CHECK_REFUSED(validate(Contact<>{.resolution = static_cast<Resolution>(7)}),
                "contact: resolution must be summed or sequential, got number 7");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(potential_energy_)

BOOST_AUTO_TEST_CASE(is_none_however_deep_the_overlap) {
  BOOST_TEST(potential_energy(Contact{}, Space{}, in_a_row().at()) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(find_touching_)

BOOST_AUTO_TEST_CASE(finds_pairs_that_overlap_or_just_touch_and_the_deepest) {
  const Touching found = find_touching(Space{}, in_a_row().at());
  BOOST_REQUIRE(found.contacts.size() == 2U);
  BOOST_TEST(found.contacts[0].i == 0);
  BOOST_TEST(found.contacts[0].j == 1);
  BOOST_TEST(close(found.contacts[0].n, Eigen::Vector3d(1.0, 0.0, 0.0), {}));
  BOOST_TEST(found.contacts[1].i == 1);
  BOOST_TEST(found.contacts[1].j == 2);
  BOOST_TEST(found.overlap == 0.5);
  BOOST_TEST(found.directed);
}

BOOST_AUTO_TEST_CASE(finds_nothing_apart_and_among_no_particle) {
  Moment apart = in_a_row();
  apart.particles.position.col(1) << 0.0, 5.0, 10.0;
  BOOST_TEST(find_touching(Space{}, apart.at()).contacts.empty());
  BOOST_TEST(find_touching(Space{}, apart.at()).overlap == 0.0);
  const Moment none{{Vectors(0, 3), Vectors(0, 3), Eigen::VectorXd(0), Eigen::VectorXd(0)}};
  BOOST_TEST(find_touching(room, none.at()).contacts.empty());
}

BOOST_AUTO_TEST_CASE(points_from_the_first_to_the_second) {
  Moment pair = in_a_row();
  pair.particles.position.row(1) << 0.6, -0.8, 0.0;
  BOOST_TEST(
      close(find_touching(Space{}, pair.at()).contacts[0].n, Eigen::Vector3d(0.6, -0.8, 0.0), {.relative = 1e-15}));
}

// The floor at z = -1 is touched by the first two; the wall at x = 4 is 1 away from the last.
BOOST_AUTO_TEST_CASE(finds_walls_that_are_touched) {
  Moment cloud = in_a_row();
  Touching found = find_touching(room, cloud.at());
  BOOST_TEST(found.contacts.size() == 4U);
  BOOST_TEST(found.contacts[1].i == 0);
  BOOST_TEST(found.contacts[1].j == -1);
  BOOST_TEST(close(found.contacts[1].n, Eigen::Vector3d(0.0, 0.0, -1.0), {}));
  cloud.particles.position.row(2) << 5.0, 0.0, 0.0;
  found = find_touching(room, cloud.at());
  BOOST_TEST(close(found.contacts.back().n, Eigen::Vector3d(1.0, 0.0, 0.0), {}));
  BOOST_TEST(found.overlap == 1.5);  // 1 behind the wall, and its radius
}

// Depth over the smaller diameter: of radii 1 and 0.25, of a sphere and a point in it, of a sphere in a wall. A point
// in a wall has no diameter at all.
BOOST_AUTO_TEST_CASE(tells_the_depth_by_the_smaller_diameter) {
  const auto penetration = [](double first, double second, double distance) {
    const Moment pair{particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = first},
                                 {.position = {distance, 0.0, 0.0}, .mass = 1.0, .radius = second}})};
    const Touching found =
        find_touching(Space{.walls = {{.point = {-1.0, 0.0, 0.0}, .normal = {1.0, 0.0, 0.0}}}}, pair.at());
    return std::pair{found.overlap, found.penetration};
  };
  BOOST_TEST((penetration(0.75, 0.25, 0.875) == std::pair{0.125, 0.25}));
  BOOST_TEST((penetration(0.25, 0.75, 0.875) == std::pair{0.125, 0.25}));
  BOOST_TEST((penetration(0.5, 0.0, 0.25) == std::pair{0.25, 0.25}));
  BOOST_TEST((penetration(1.25, 0.25, 4.0) == std::pair{0.25, 0.1}));
  BOOST_TEST((penetration(0.0, 0.25, 4.0) == std::pair{0.0, 0.0}));
  BOOST_TEST((penetration(0.0, 0.0, -1.5) == std::pair{0.5, 0.0}));
}

BOOST_AUTO_TEST_CASE(says_when_a_direction_is_missing) {
  Moment cloud = in_a_row();
  cloud.particles.position.row(2) = cloud.particles.position.row(1);
  const Touching found = find_touching(Space{}, cloud.at());
  BOOST_TEST(!found.directed);
  BOOST_TEST(found.overlap == 1.5);
  BOOST_TEST(any_approach(found, cloud.at()));
}

// 1e-200 m has a square of 0, and 1e200 m none.
BOOST_AUTO_TEST_CASE(finds_bodies_of_any_size_and_no_points) {
  for (const double size : {1e-200, 1.0, 1e200}) {
    Moment pair{{.position = Vectors{{0.0, 0.0, 0.0}, {0.6 * size, 0.8 * size, 0.0}},
                 .velocity = Vectors::Zero(2, 3),
                 .mass = Eigen::Vector2d::Ones(),
                 .radius = Eigen::Vector2d::Constant(0.75 * size)}};
    const Touching found = find_touching(Space{}, pair.at());
    BOOST_REQUIRE(found.contacts.size() == 1U);
    BOOST_TEST(close(found.contacts[0].n, Eigen::Vector3d(0.6, 0.8, 0.0), {.relative = 1e-15}));
    BOOST_TEST(found.overlap == 0.5 * size, tolerance(1e-14));
    pair.particles.radius.setConstant(0.25 * size);
    BOOST_TEST(find_touching(Space{}, pair.at()).contacts.empty());
  }
  const Moment points{{.position = Vectors::Zero(2, 3),
                       .velocity = Vectors::Zero(2, 3),
                       .mass = Eigen::Vector2d::Ones(),
                       .radius = Eigen::Vector2d::Zero()}};
  BOOST_TEST(find_touching(Space{}, points.at()).contacts.empty());
}

// Twenty-seven spheres on a crooked lattice, some of which overlap, between a floor and a wall.
BOOST_AUTO_TEST_CASE(finds_the_same_in_a_domain_of_ones_own) {
  Moment cloud{{.position = Vectors::Zero(27, 3),
                .velocity = Vectors::Zero(27, 3),
                .mass = Eigen::VectorXd::Ones(27),
                .radius = Eigen::VectorXd::Constant(27, 0.5)}};
  for (Eigen::Index i = 0; i < 27; ++i) {
    const auto k = static_cast<double>(i);
    cloud.particles.position.row(i) << static_cast<double>(i % 3) + 0.1 * std::sin(k),
        static_cast<double>(i / 3 % 3) + 0.1 * std::sin(2.0 * k), static_cast<double>(i / 9) + 0.1 * std::sin(3.0 * k);
  }
  const std::vector<Wall> planes{Wall{.point = {0.0, 0.0, -0.5}},
                                 {.point = {2.5, 0.0, 0.0}, .normal = {-1.0, 0.0, 0.0}}};
  for (const ClosedGap& tolerance : {ClosedGap{}, ClosedGap{.relative = 0.02, .roundings = 16.0}}) {
    const Touching found = find_touching(Own{{.walls = planes}}, cloud.at(), tolerance);
    const Touching by_space = find_touching(Space{.walls = planes}, cloud.at(), tolerance);
    BOOST_TEST(found.contacts.size() > 10U);
    BOOST_TEST(found.contacts.size() < 72U);  // not all neighbours and all that stand at a wall
    BOOST_TEST(found.overlap == by_space.overlap);
    BOOST_REQUIRE(found.contacts.size() == by_space.contacts.size());
    for (std::size_t k = 0; k < found.contacts.size(); ++k) {
      BOOST_TEST(found.contacts[k].i == by_space.contacts[k].i);
      BOOST_TEST(found.contacts[k].j == by_space.contacts[k].j);
      BOOST_TEST(close(found.contacts[k].n, by_space.contacts[k].n, {}));
    }
  }
}

// Spheres and points of all sizes at random, some of them immovable, found among all pairs and by search, at every age
// of what the search remembers.
BOOST_AUTO_TEST_CASE(finds_the_same_among_neighbours_as_among_all_pairs) {
  const Wall ground{.normal = {0.0, 0.0, 1.0}};
  const Space spaces[] = {Space{}, Space{.walls = {ground}, .lengths = {1.0, 1.0, infinity}},
                          Space{.lengths = {1.0, 1.0, 1.0}}};
  for (const Space& space : spaces) {
    for (const double largest : {0.02, 0.15}) {
      Moment cloud{random_cloud(200, {1.0, 1.0, 1.0}, 0.02, largest)};
      for (Eigen::Index i = 0; i < 200; i += 5) cloud.particles.radius[i] = 0.0, cloud.inverse_mass[199 - i] = 0.0;
      std::size_t contacts = 0;
      int others = 0;
      for (int k = 0; k < 25; ++k) {
        const ClosedGap tolerance = k % 2 == 0 ? ClosedGap{} : ClosedGap{.relative = 0.02, .roundings = 16.0};
        const Touching all = find_touching(Own{space}, cloud.at(), tolerance);
        const Touching found = find_touching(space, cloud.at(), tolerance);
        const auto same = [](const Touch& a, const Touch& b) {
          return a.i == b.i && a.j == b.j && a.n == b.n && a.overlap == b.overlap;
        };
        others +=
            std::equal(all.contacts.begin(), all.contacts.end(), found.contacts.begin(), found.contacts.end(), same) &&
                    all.overlap == found.overlap
                ? 0
                : 1;
        contacts += found.contacts.size();
        cloud.particles.position += 0.004 * cloud.particles.velocity;
        cloud.particles.position.col(1).array() += 0.7;
      }
      BOOST_TEST(others == 0);
      BOOST_TEST(contacts > 25U);
      BOOST_TEST(cloud.scratch.neighbours.searches() < 20);
    }
  }
}

BOOST_AUTO_TEST_CASE(takes_no_notice_of_what_cannot_move_on_either_side) {
  Moment fixed = in_a_row();
  fixed.particles.position.row(1) = fixed.particles.position.row(0);
  fixed.inverse_mass.head<2>().setZero();
  const Touching found = find_touching(room, fixed.at());
  BOOST_TEST(found.contacts.empty());
  BOOST_TEST(found.directed);
  BOOST_TEST(found.overlap == 0.0);
  fixed.inverse_mass[1] = 1.0;
  BOOST_TEST(find_touching(Space{}, fixed.at()).contacts.size() == 1U);
  fixed.inverse_mass.head<2>() << 1.0, 0.0;
  BOOST_TEST(find_touching(Space{}, fixed.at()).contacts.size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(travel_)

// Means are taken off: +-1.5 m/s along x. The floor is approached at 2 m/s, by the body of radius 0.5.
BOOST_AUTO_TEST_CASE(is_the_largest_move_over_the_radius_seen_from_the_others_and_from_walls) {
  Moment pair{{.position = Vectors{{0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}},
               .velocity = Vectors{{2e4 + 3.0, 0.0, 0.0}, {2e4, 0.0, 0.0}},
               .mass = Eigen::Vector2d(1.0, 9.0),
               .radius = Eigen::Vector2d(0.25, 0.5)}};
  BOOST_TEST(travel(Space{}, pair.at(), 0.1) == 0.6, tolerance(1e-9));
  pair.particles.radius[0] = 0.0;
  BOOST_TEST(travel(Space{}, pair.at(), 0.1) == 0.3, tolerance(1e-9));
  pair.particles.velocity << 0.0, 0.0, -2.0, 0.0, 0.0, -2.0;
  BOOST_TEST(travel(Space{}, pair.at(), 0.1) == 0.0);
  BOOST_TEST(travel(room, pair.at(), 0.1) == 0.4);
  pair.particles.radius.setZero();
  BOOST_TEST(travel(room, pair.at(), 0.1) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(any_approach_)

BOOST_AUTO_TEST_CASE(asks_for_relative_velocities_along_the_contacts) {
  Moment cloud = in_a_row();
  const auto approaches = [&] { return any_approach(find_touching(room, cloud.at()), cloud.at()); };
  BOOST_TEST(approaches());
  cloud.particles.velocity.col(0) << 2.0, 2.0, 2.0;  // together
  BOOST_TEST(!approaches());
  cloud.particles.velocity.col(0) << -1.0, 0.0, 1.0;  // apart
  BOOST_TEST(!approaches());
  cloud.particles.velocity.col(2) << 0.0, 1.0, 0.0;  // up from the floor
  BOOST_TEST(!approaches());
  cloud.particles.velocity.col(2) << 0.0, -1.0, 0.0;  // into it
  BOOST_TEST(approaches());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(resolve_impacts_)

// Masses 1 and 2 close at 2 m/s: J = -1.5 (2/3) 2 = -2: v_0 = 0, v_1 = 1. Then 2 and 4 close at 1: J = -1.5 (4/3) = -2:
// v_1 = 0, v_2 = 0.5. Energy 2 + 1 before, (4 0.25)/2 + 1 after.
BOOST_AUTO_TEST_CASE(changes_velocities_and_reports_what_it_did) {
  const auto [jump, velocity] =
      resolved(Contact{.restitution = ConstantRestitution{0.5}}, in_a_row(), Space{}, Vectors::Zero(3, 3), 0.1);
  BOOST_TEST(close(velocity, Vectors{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.5, 0.0, 0.0}}, {.absolute = 1e-15}));
  BOOST_TEST(jump.impacts == 2);
  BOOST_TEST(jump.energy_change == -1.5, tolerance(1e-15));
  BOOST_TEST(jump.overlap == 0.5);
  BOOST_TEST(jump.unsettled.empty());
}

// The forces 3 and -2 N give (3/1 + 2/2) = 4 m/s^2 of approach over gamma dt/(1 + e) = 0.25/1.25 s: Delta_1 = 0.8,
// J = -1.25 (2/3) 2.8 = -7/3.
BOOST_AUTO_TEST_CASE(divides_the_other_forces_by_each_mass_and_acts_for_gamma_dt) {
  Moment cloud = in_a_row();
  cloud.particles.position.row(2) << 0.0, 9.0, 0.0;
  const Vectors force{{3.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}, {50.0, 50.0, 50.0}};
  const auto [jump, velocity] =
      resolved(Contact{.restitution = ConstantRestitution{0.25}, .gamma = 0.5}, cloud, Space{}, force, 0.5);
  BOOST_TEST(velocity(0, 0) == 2.0 - 7.0 / 3.0, tolerance(1e-14));
  BOOST_TEST(velocity(1, 0) == 7.0 / 6.0, tolerance(1e-14));
  BOOST_TEST(jump.impacts == 1);
}

// A force on what is immovable moves it as little as an impact does.
BOOST_AUTO_TEST_CASE(takes_no_acceleration_from_what_is_immovable) {
  Moment cloud = in_a_row();
  cloud.inverse_mass[1] = 0.0;
  cloud.particles.velocity.row(1).setZero();
  const Vectors force{{0.0, 0.0, 0.0}, {-1000.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  const auto [jump, velocity] =
      resolved(Contact{.restitution = ConstantRestitution{0.5}, .gamma = 0.5}, cloud, Space{}, force, 0.5);
  BOOST_TEST(close(velocity, Vectors{{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {}));
  BOOST_TEST(jump.energy_change == -1.5);
}

BOOST_AUTO_TEST_CASE(hands_on_its_friction_and_its_resolution) {
  Moment cloud = in_a_row();
  cloud.particles.velocity.row(1).setZero();
  cloud.particles.velocity(0, 2) = 0.5;
  const Vectors none = Vectors::Zero(3, 3);
  // |J| = 4/3 at e = 0, so sliding with mu_d = 0.1 takes 2/15 of the 0.5 m/s.
  Contact<ConstantRestitution, Friction> law{.restitution = {0.0}, .friction = {.mu_s = 0.1, .mu_d = 0.1}};
  law.resolution = Resolution::summed;
  const auto [jump, velocity] = resolved(law, cloud, Space{}, none, 0.1);
  BOOST_TEST(velocity(0, 2) == 0.5 - 2.0 / 15.0, tolerance(1e-14));
  BOOST_TEST(jump.impacts == 1);  // the hit is not passed on to the third
  BOOST_TEST(resolved(Contact{.restitution = ConstantRestitution{0.0}}, cloud, Space{}, none, 0.1).jump.impacts > 1);
}

BOOST_AUTO_TEST_CASE(names_two_particles_with_the_same_centre) {
  Moment cloud = in_a_row();
  cloud.particles.position.row(2) = cloud.particles.position.row(1);
  const auto [jump, velocity] = resolved(Contact{}, cloud, Space{}, Vectors::Zero(3, 3), 0.1);
  BOOST_TEST(jump.unsettled ==
             "particles 1 and 2 touch with the same centre, so there is no direction to part them in: start them "
             "apart, or take a smaller step");
  BOOST_TEST(jump.impacts == 0);
  BOOST_TEST(jump.overlap == 1.5);
  BOOST_TEST(close(velocity, cloud.particles.velocity, {}));
}

BOOST_AUTO_TEST_CASE(hands_on_what_could_not_be_settled) {
  Moment jammed{{.position = Vectors{{0.0, 0.0, 0.0}},
                 .velocity = Vectors{{0.0, 0.0, 1.0}},
                 .mass = Eigen::VectorXd::Ones(1),
                 .radius = Eigen::VectorXd::Ones(1)}};
  const Space slot{{Wall{.point = {0.0, 0.0, -1.0}, .normal = {0.0, 0.0, 1.0}},
                    Wall{.point = {0.0, 0.0, 1.0}, .normal = {0.0, 0.0, -1.0}}}};
  const Jump jump = resolved(Contact{}, jammed, slot, Vectors::Zero(1, 3), 0.1).jump;
  BOOST_TEST(contains(jump.unsettled, "of 2 contacts that hang together, up to 0 m deep, still approach"));
  BOOST_TEST(
      contains(jump.unsettled, "particle 0 is pinched between a wall and a wall, which it overlaps by 0 m together"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(ImpactRecorder_)

// The work of all impulses: each over the mean of its relative velocities, in whatever frame.
double work_of(const std::vector<ImpactRecord>& impacts) {
  double work = 0.0;
  for (const ImpactRecord& impact : impacts) {
    work += (impact.tangential - impact.push * impact.n).dot(0.5 * (impact.before + impact.after));
  }
  return work;
}

// The impacts of changes_velocities_and_reports_what_it_did: 2 N s each.
BOOST_AUTO_TEST_CASE(is_told_of_every_impact_as_it_was_resolved) {
  std::vector<ImpactRecord> impacts;
  const Contact law{.restitution = ConstantRestitution{0.5},
                    .recorder = [&](const ImpactRecord& impact) { impacts.push_back(impact); }};
  const Jump jump = resolved(law, in_a_row(), Space{}, Vectors::Zero(3, 3), 0.1).jump;
  BOOST_REQUIRE(impacts.size() == 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(impacts[k].i == static_cast<Eigen::Index>(k));
    BOOST_TEST(impacts[k].j == static_cast<Eigen::Index>(k) + 1);
    BOOST_TEST(impacts[k].push == 2.0, tolerance(1e-15));
    BOOST_TEST(close(impacts[k].n, Eigen::Vector3d::UnitX(), {}));
    BOOST_TEST(close(impacts[k].tangential, Eigen::Vector3d::Zero(), {}));
  }
  BOOST_TEST(close(impacts[0].before, Eigen::Vector3d(2.0, -1.0, 0.0), {}));
  BOOST_TEST(close(impacts[0].after, Eigen::Vector3d(-1.0, -1.0, 0.0), {.relative = 1e-15}));
  BOOST_TEST(close(impacts[1].before, Eigen::Vector3d(1.0, 1.0, 0.0), {.relative = 1e-15}));
  BOOST_TEST(close(impacts[1].after, Eigen::Vector3d(-0.5, 1.0, 0.0), {.relative = 1e-15}));
  BOOST_TEST(work_of(impacts) == jump.energy_change, tolerance(1e-14));
}

// A sphere that falls between two others, which stand on a floor, so that several contacts are resolved at once and
// rub.
BOOST_AUTO_TEST_CASE(accounts_for_all_energy_that_impacts_take) {
  const Moment three{{.position = Vectors{{-0.75, 0.0, 0.0}, {0.75, 0.0, 0.0}, {0.0, 0.0, 1.0}},
                      .velocity = Vectors{{0.0, 0.0, -1.0}, {0.0, 0.5, -1.0}, {0.5, 0.25, -3.0}},
                      .mass = Eigen::Vector3d(1.0, 2.0, 3.0),
                      .radius = Eigen::Vector3d(1.0, 1.0, 1.0)}};
  for (const Resolution order : {Resolution::sequential, Resolution::summed}) {
    std::vector<ImpactRecord> impacts;
    const Contact<ConstantRestitution, Friction> law{
        .restitution = {0.5},
        .friction = {.mu_s = 0.2, .mu_d = 0.1},
        .resolution = order,
        .recorder = [&](const ImpactRecord& impact) { impacts.push_back(impact); }};
    const Jump jump = resolved(law, three, room, Vectors::Zero(3, 3), 0.1).jump;
    BOOST_TEST(jump.unsettled.empty());
    BOOST_TEST(impacts.size() >= 4U);
    BOOST_TEST(std::abs(jump.energy_change) > 0.1);
    BOOST_TEST(work_of(impacts) == jump.energy_change, tolerance(1e-12));
    const auto pushes = [](const ImpactRecord& impact) { return impact.push > 0.0; };
    BOOST_TEST(std::count_if(impacts.begin(), impacts.end(), pushes) == jump.impacts);
  }
}

// A piston of 1 m/s that nothing stops and a ball of 2 kg at rest: it leaves with 2 m/s, and its 4 J are gained. What
// the records see, from the piston, is an elastic impact.
BOOST_AUTO_TEST_CASE(books_what_a_body_that_nothing_moves_gives) {
  for (const Eigen::Index piston : {0, 1}) {
    Particles both{.position = Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}},
                   .velocity = Vectors::Zero(2, 3),
                   .mass = Eigen::Vector2d::Constant(2.0),
                   .radius = Eigen::Vector2d::Constant(0.5),
                   .immovable = {piston == 0, piston == 1}};
    both.velocity(piston, 0) = piston == 0 ? 1.0 : -1.0;
    for (const Resolution order : {Resolution::sequential, Resolution::summed}) {
      const Jump jump = resolved(Contact{.resolution = order}, Moment{both}, Space{}, Vectors::Zero(2, 3), 0.1).jump;
      BOOST_TEST(jump.energy_change == 4.0, tolerance(1e-15));
    }
  }
}

// (1/2) m* (1 - e^2) u^2 = 0.25 0.75 1e-6 J are gone from 4e8 J, of which a double keeps 6e-8 J: the difference of two
// kinetic energies has no digit of it. Relative velocities are right to 3.6e-12 of 2.5e-4 m/s, their mean. A slip of
// 2e-4 m/s sticks and takes 0.25 4e-8 J more.
BOOST_AUTO_TEST_CASE(knows_the_loss_of_a_slow_impact_of_fast_bodies) {
  const Moment pair{{.position = Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}},
                     .velocity = Vectors{{2e4 + 1e-3, 2e4, 2e-4}, {2e4, 2e4, 0.0}},
                     .mass = Eigen::Vector2d::Ones(),
                     .radius = Eigen::Vector2d::Constant(0.5)}};
  for (const Resolution order : {Resolution::sequential, Resolution::summed}) {
    std::vector<ImpactRecord> impacts;
    const Contact<ConstantRestitution, Friction> law{
        .restitution = {0.5},
        .friction = {.mu_s = 0.5, .mu_d = 0.1},
        .resolution = order,
        .recorder = [&](const ImpactRecord& impact) { impacts.push_back(impact); }};
    const Jump jump = resolved(law, pair, Space{}, Vectors::Zero(2, 3), 0.1).jump;
    BOOST_TEST(jump.impacts == 1);
    BOOST_TEST(jump.energy_change == -1.975e-7, tolerance(3e-8));
    BOOST_TEST(work_of(impacts) == jump.energy_change, tolerance(1e-15));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::contact_test
