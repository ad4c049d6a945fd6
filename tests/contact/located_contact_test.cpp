#include <particulate/contact/located_contact.hpp>

#include <cmath>

#include "close.hpp"
#include "clouds.hpp"
#include "moment.hpp"

namespace tests::located_contact_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::schemes;

const Space ground{{Wall{}}};

// Every particle on its own parabola.
struct Flight {
  Particles particles;
  Vectors acceleration = Vectors::Zero(particles.size(), 3);
  double dt = 1.0;
  int intervals = 8;
  void operator()(double theta, State& there) const {
    const double t = theta * dt;
    there.t = t;
    there.r = (particles.position + t * particles.velocity + 0.5 * t * t * acceleration).reshaped();
    there.v = (particles.velocity + t * acceleration).reshaped();
  }
};

static_assert(Impacts<LocatedContact<>> && Impacts<LocatedContact<Restitution, Friction>> &&
              Validated<LocatedContact<>> && Conservative<LocatedContact<>, Space>);
static_assert(LocatesImpacts<LocatedContact<>, Space> && !LocatesImpacts<Contact<>, Space>);

Particles spheres(const Vectors& position, const Vectors& velocity, double radius = 0.5) {
  const Eigen::Index N = position.rows();
  return {.position = position,
          .velocity = velocity,
          .mass = Eigen::VectorXd::Ones(N),
          .radius = Eigen::VectorXd::Constant(N, radius)};
}

template <class D>
std::optional<double> first(const Flight& flight, const D& domain, double end = 1.0) {
  const State start;  // the flight knows its own
  const StepPath path{.scheme = &flight,
                      .at = [](const void* of, const State&, double, double theta,
                               State& there) { (*static_cast<const Flight*>(of))(theta, there); },
                      .from = start,
                      .dt = flight.dt,
                      .intervals = flight.intervals};
  Neighbours neighbours;
  return first_impact(LocatedContact{}, domain, flight.particles.radius, inverse_masses(flight.particles), neighbours,
                      path, end);
}

template <class L, class D>
tests::Resolved resolved(const L& law, const Moment& moment, const D& domain, const Vectors& force) {
  return tests::resolved(law, moment, find_touching(domain, moment.at(), touching_tolerance(law)), force, 0.1);
}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_the_defaults_and_refuses_what_its_parts_refuse) {
  BOOST_CHECK_NO_THROW(validate(LocatedContact{}));
  CHECK_REFUSED(validate(LocatedContact<>{.restitution = {1.5}}), "restitution: e must lie in [0, 1], got 1.5");
  CHECK_REFUSED(validate(LocatedContact<>{.resolution = static_cast<Resolution>(7)}),
                "contact: resolution must be summed or sequential, got number 7");
  for (const double bad : {0.0, -1.0, 0.1, not_a_number}) {
    CHECK_REFUSED(validate(LocatedContact<>{.touching = bad}), "contact: touching must lie in (0, 1e-3], got ");
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(ClosedGap_)

BOOST_AUTO_TEST_CASE(is_a_part_of_the_radii_and_some_roundings_of_the_places) {
  Moment pair{spheres(Vectors{{0.0, 3.0, 4.0}, {0.0, 3.0, 5.0}}, Vectors::Zero(2, 3))};
  const ClosedGap gap = touching_tolerance(LocatedContact<>{.touching = 1e-9});
  BOOST_TEST(
      gap.between(pair.particles.position, pair.particles.radius, 0, 1) == 1e-9 + 16.0 * eps * (5.0 + std::sqrt(34.0)),
      tolerance(1e-12));
  BOOST_TEST(gap.between(pair.particles.position, pair.particles.radius, 0, -1) == 0.5e-9 + 16.0 * eps * 5.0,
             tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(lets_a_gap_below_it_touch_and_counts_no_overlap_for_it) {
  for (const double gap : {1e-13, -1e-13}) {
    const Moment pair{spheres(Vectors{{0.0, 0.0, 0.0}, {1.0 + gap, 0.0, 0.0}}, Vectors::Zero(2, 3))};
    const Touching found = find_touching(Space{}, pair.at(), touching_tolerance(LocatedContact{}));
    BOOST_TEST(found.contacts.size() == 1U);
    BOOST_TEST(found.overlap == std::max(0.0, -gap), tolerance(1e-2));
  }
  const Moment apart{spheres(Vectors{{0.0, 0.0, 0.0}, {1.0 + 1e-10, 0.0, 0.0}}, Vectors::Zero(2, 3))};
  BOOST_TEST(find_touching(Space{}, apart.at(), touching_tolerance(LocatedContact{})).contacts.empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(first_impact_)

// Space, with its type unknown to the search for gaps: all pairs.
struct Hidden {
  Space space;
};
Eigen::Vector3d separation(const Hidden& hidden, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return separation(hidden.space, from, to);
}

BOOST_AUTO_TEST_CASE(is_the_same_among_neighbours_as_among_all_pairs) {
  for (const Space& space : {Space{}, Space{.lengths = {1.0, infinity, 1.0}}}) {
    int found = 0;
    for (unsigned seed = 1; seed <= 15; ++seed) {
      Flight flight{random_cloud(90, {1.0, 1.0, 1.0}, 5e-3, 0.03, seed)};
      flight.dt = 0.1;
      flight.acceleration = 20.0 * random_cloud(90, {1.0, 1.0, 1.0}, 1.0, 1.0, seed + 100).velocity;
      const std::optional<double> all = first(flight, Hidden{space});
      BOOST_TEST((first(flight, space) == all));
      found += all ? 1 : 0;
    }
    BOOST_TEST(found > 4);
  }
}

BOOST_AUTO_TEST_CASE(may_be_across_a_period) {
  const Flight flight{spheres(Vectors{{0.5, 0.0, 0.0}, {9.0, 0.0, 0.0}}, Vectors{{-2.0, 0.0, 0.0}, {0.5, 0.0, 0.0}})};
  BOOST_TEST(first(flight, Space{.lengths = {10.0, infinity, infinity}}).value() == 0.2, tolerance(1e-14));
  BOOST_TEST(!first(flight, Space{}).has_value());
}

// A gap of 1 closes at 2 + 3 m/s.
BOOST_AUTO_TEST_CASE(is_where_two_spheres_touch) {
  const Flight flight{spheres(Vectors{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, Vectors{{2.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}})};
  BOOST_TEST(first(flight, Space{}).value() == 0.2, tolerance(1e-15));
  Flight slow = flight;
  slow.dt = 0.1;
  BOOST_TEST(!first(slow, Space{}).has_value());
  slow.dt = 0.19;
  BOOST_TEST(first(slow, Space{}, 1.1).value() == 0.2 / 0.19, tolerance(1e-15));
}

// From 1.25 m above the ground with g = 10: 0.75 = 5 t^2 for the lowest point.
BOOST_AUTO_TEST_CASE(is_where_a_sphere_touches_a_wall) {
  Flight flight{spheres(Vectors{{0.0, 0.0, 1.25}}, Vectors{{3.0, 1.0, 0.0}})};
  flight.acceleration(0, 2) = -10.0;
  BOOST_TEST(first(flight, ground).value() == std::sqrt(0.15), tolerance(1e-15));
  BOOST_TEST(!first(flight, Space{}).has_value());
}

BOOST_AUTO_TEST_CASE(is_the_earliest_of_all) {
  const Flight flight{spheres(Vectors{{0.0, 0.0, 9.0}, {2.0, 0.0, 9.0}, {0.0, 0.0, 5.0}},
                              Vectors{{2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, -6.0}})};
  BOOST_TEST(first(flight, Space{}).value() == 0.5, tolerance(1e-15));
  BOOST_TEST(first(flight, ground).value() == 0.5, tolerance(1e-15));
  Flight longer = flight;
  longer.particles.velocity(2, 2) = -10.0;
  BOOST_TEST(first(longer, ground).value() == 0.45, tolerance(1e-15));
}

// Passes at 1 m - 5e-7 m, so that the spheres overlap for 0.002 of the step, far from any sample but not from a slope.
BOOST_AUTO_TEST_CASE(sees_a_short_overlap_between_samples) {
  const double miss = 1.0 - 5e-7;
  Flight flight{spheres(Vectors{{-0.47, miss, 0.0}, {0.0, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
  flight.dt = 0.47;
  BOOST_TEST(first(flight, Space{}, 1.1).value() == 1.0 - std::sqrt(1.0 - miss * miss) / 0.47, tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(is_none_for_a_near_miss_and_for_a_touch_without_approach) {
  for (const double miss : {1.0 + 1e-9, 1.0}) {
    Flight flight{spheres(Vectors{{-0.47, miss, 0.0}, {0.0, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
    flight.dt = 0.47;  // the scheme's own end is no doubt
    BOOST_TEST(!first(flight, Space{}, 1.1).has_value());
  }
}

// Within a step dense output is not trusted to tell a near miss from a graze: 4 0.47 0.53 1e-4 = 0.9964e-4.
BOOST_AUTO_TEST_CASE(is_where_bodies_come_nearest_as_long_as_it_is_in_doubt) {
  for (const double miss : {1.0 + 1e-9, 1.0 + 9e-5}) {
    const Flight flight{
        spheres(Vectors{{-0.47, miss, 0.0}, {0.0, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
    BOOST_TEST(first(flight, Space{}).value() == 0.47, tolerance(1e-14));
  }
  const Flight far{spheres(Vectors{{-0.47, 1.0002, 0.0}, {0.0, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
  BOOST_TEST(!first(far, Space{}).has_value());
}

BOOST_AUTO_TEST_CASE(is_none_for_bodies_that_touch_or_overlap_and_part) {
  for (const double d : {1.0, 1.0 - 1e-13, 0.5}) {
    const Flight flight{spheres(Vectors{{0.0, 0.0, 0.0}, {d, 0.0, 0.0}}, Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}})};
    BOOST_TEST(!first(flight, Space{}).has_value());
  }
}

BOOST_AUTO_TEST_CASE(comes_at_once_for_bodies_that_touch_or_overlap_and_approach) {
  for (const double d : {1.0, 1.0 - 1e-13, 0.5}) {
    const Flight flight{spheres(Vectors{{0.0, 0.0, 0.0}, {d, 0.0, 0.0}}, Vectors{{0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}})};
    const double theta = first(flight, Space{}).value();
    BOOST_TEST(theta > 0.0);
    BOOST_TEST(theta < 2e-12);
  }
}

// Up from the ground and back, within the first of its intervals.
BOOST_AUTO_TEST_CASE(is_the_end_of_a_hop) {
  for (const double speed : {1.0, 1e-2, 1e-4}) {
    Flight flight{spheres(Vectors{{0.0, 0.0, 0.5}}, Vectors{{0.0, 0.0, speed}})};
    flight.acceleration(0, 2) = -10.0;
    BOOST_TEST(std::abs(first(flight, ground).value() - speed / 5.0) < 2e-16 / speed);
  }
}

// Parts from an overlap of 0.1 with 1 m/s and comes back under 10 m/s^2: it was apart for a while, then touches again.
BOOST_AUTO_TEST_CASE(is_where_bodies_touch_once_they_have_been_apart) {
  Flight flight{spheres(Vectors{{0.0, 0.0, 0.49}}, Vectors{{0.0, 0.0, 1.0}})};
  flight.acceleration(0, 2) = -10.0;
  BOOST_TEST(first(flight, ground).value() == 0.1 + std::sqrt(0.01 - 0.002), tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(leaves_alone_what_cannot_move_and_what_does_not_exist) {
  Flight flight{spheres(Vectors{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, Vectors{{2.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}})};
  flight.particles.immovable = {true, true};
  BOOST_TEST(!first(flight, Space{}).has_value());
  flight.particles.immovable = {true, false};
  BOOST_TEST(first(flight, Space{}).has_value());
  const Flight nobody{spheres(Vectors(0, 3), Vectors(0, 3))};
  BOOST_TEST(!first(nobody, ground).has_value());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(resolve_impacts_)

// Half of 2 m/s is left; the force, which would count in an impact of some duration, does not.
BOOST_AUTO_TEST_CASE(sends_back_at_once) {
  const LocatedContact law{.restitution = ConstantRestitution{0.5}};
  const Moment ball{spheres(Vectors{{0.0, 0.0, 0.5}}, Vectors{{1.0, 0.0, -2.0}})};
  const auto [jump, velocity] = resolved(law, ball, ground, Vectors{{0.0, 0.0, -10.0}});
  BOOST_TEST(close(velocity, Vectors{{1.0, 0.0, 1.0}}, {.relative = 1e-15}));
  BOOST_TEST(jump.impacts == 1);
  BOOST_TEST(jump.energy_change == -1.5, tolerance(1e-15));
  BOOST_TEST(jump.unsettled.empty());
  BOOST_TEST(std::isnan(jump.accumulates));
}

BOOST_AUTO_TEST_CASE(resolves_a_symmetric_hit_as_one_group) {
  const Moment three{spheres(Vectors{{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0 + 1e-14, 0.0, 0.0}},
                             Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}})};
  const auto [jump, velocity] = resolved(LocatedContact{}, three, Space{}, Vectors::Zero(3, 3));
  BOOST_TEST(close(velocity, Vectors{{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {.absolute = 1e-15}));
  BOOST_TEST(jump.impacts == 2);
}

// 1e-6 m/s are left, under 10 m/s^2: a hop of 5e-14 m, below 1e-10 0.5 m. It would end after 2e-7 s, all after twice
// that.
BOOST_AUTO_TEST_CASE(refuses_what_comes_to_rest_and_tells_when) {
  const LocatedContact law{.restitution = ConstantRestitution{0.5}};
  const Moment ball{spheres(Vectors{{0.0, 0.0, 0.5}}, Vectors{{0.0, 0.0, -2e-6}})};
  const Jump jump = resolved(law, ball, ground, Vectors{{0.0, 0.0, -10.0}}).jump;
  BOOST_TEST(jump.accumulates == 3.0 + 4e-7, tolerance(1e-14));
  BOOST_TEST(jump.unsettled.find("particle 0 and a wall come to rest on each other: after their impact at t = 3 s they "
                                 "part at 1e-06 m/s") == 0U,
             jump.unsettled);
  BOOST_TEST(contains(jump.unsettled, "take stepped contacts (Contact)"));
}

// e = 0.25 at 2e-6 m/s leaves 5e-7 m/s, of which the next impact keeps nearly 0.5, and half of that the next.
BOOST_AUTO_TEST_CASE(counts_in_how_restitution_rises_as_impacts_grow_gentle) {
  const LocatedContact law{.restitution = Restitution{.e_o = 0.5, .v_star = 4e-6}};
  const Moment ball{spheres(Vectors{{0.0, 0.0, 0.5}}, Vectors{{0.0, 0.0, -2e-6}})};
  const Jump jump = resolved(law, ball, ground, Vectors{{0.0, 0.0, -10.0}}).jump;
  BOOST_TEST(jump.accumulates - 3.0 == 0.2 * speeds_to_come(law.restitution, 5e-7), tolerance(1e-7));
  BOOST_TEST(jump.accumulates - 3.0 < 0.2 * 1e-6);
}

// With e -> 1 impacts never end: hops of 5e-13 (1 - 2e-6 m/s / v*)^2 m/2 go on; what the tolerance hides does not.
BOOST_AUTO_TEST_CASE(does_not_end_what_does_not_accumulate) {
  const auto law = [](double touching) {
    return LocatedContact<Restitution>{.restitution = {.v_star = 1.0}, .touching = touching};
  };
  const Moment ball{spheres(Vectors{{0.0, 0.0, 0.5}}, Vectors{{0.0, 0.0, -1e-5}})};
  const Vectors weight{{0.0, 0.0, -10.0}};
  BOOST_TEST(resolved(law(1e-12), ball, ground, weight).jump.unsettled.empty());
  const Jump jump = resolved(law(1e-11), ball, ground, weight).jump;
  BOOST_TEST(contains(jump.unsettled, "their impacts go on for ever"), jump.unsettled);
  BOOST_TEST(std::isnan(jump.accumulates));
}

BOOST_AUTO_TEST_CASE(refuses_what_stays_pressed_without_restitution) {
  const LocatedContact law{.restitution = ConstantRestitution{0.0}};
  const Moment pair{spheres(Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
  const Jump jump = resolved(law, pair, Space{}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}).jump;
  BOOST_TEST(jump.unsettled.find("particles 0 and 1 come to rest on each other") == 0U);
  BOOST_TEST(jump.accumulates == 3.0);
}

// Pulled apart, or by one field that moves both alike, the same bodies go on together.
BOOST_AUTO_TEST_CASE(lets_bodies_stay_together_that_nothing_presses) {
  const LocatedContact law{.restitution = ConstantRestitution{0.0}};
  const Moment pair{spheres(Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, Vectors{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
  for (const Vectors& force : {Vectors{{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, Vectors{{0.3, 0.1, 0.7}, {0.3, 0.1, 0.7}},
                               Vectors{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}}) {
    const auto [jump, velocity] = resolved(law, pair, Space{}, force);
    BOOST_TEST(jump.unsettled.empty());
    BOOST_TEST(close(velocity, Vectors{{0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}}, {}));
  }
}

BOOST_AUTO_TEST_CASE(tells_of_two_particles_with_the_same_centre) {
  const Moment pair{spheres(Vectors{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, Vectors::Zero(2, 3))};
  BOOST_TEST(resolved(LocatedContact{}, pair, Space{}, Vectors::Zero(2, 3))
                 .jump.unsettled.find("particles 0 and 1 touch with the same centre") == 0U);
}

BOOST_AUTO_TEST_CASE(hands_on_its_friction) {
  const LocatedContact law{.restitution = ConstantRestitution{0.5}, .friction = Friction{.mu_s = 0.1, .mu_d = 0.1}};
  const Moment ball{spheres(Vectors{{0.0, 0.0, 0.5}}, Vectors{{1.0, 0.0, -2.0}})};
  BOOST_TEST(
      close(resolved(law, ball, ground, Vectors::Zero(1, 3)).velocity, Vectors{{0.7, 0.0, 1.0}}, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::located_contact_test
