#include <particulate/laws/law.hpp>

#include "close.hpp"

namespace tests::law_test {

using particulate::laws::Conservative;
using particulate::laws::Forces;
using particulate::contact::MotionForce;
using particulate::laws::At<laws::Velocity>;
using particulate::laws::At<>;
using particulate::contact::PositionForce;
using particulate::laws::Validated;
using particulate::kinematics::Space;
using particulate::kinematics::Vectors;

// A uniform field.
struct Weight {};
bool add_force(const Weight&, const Open&, const Places& at, Forces force) {
  force.col(2) -= at.mass;
  return true;
}
[[maybe_unused]] double potential_energy(const Weight&, const Open&, const Places& at) {
  return at.mass.dot(at.position.col(2));
}
[[maybe_unused]] void validate(const Weight&) {}

// A drag that reads velocities.
struct Drag {};
bool add_force(const Drag&, const Open&, const Moving& at, Forces force) {
  force -= at.velocity;
  return true;
}

// Both would be ambiguous: what can do without velocities does.
struct Either {};
[[maybe_unused]] bool add_force(const Either&, const Open&, const Places&, Forces) { return true; }
[[maybe_unused]] bool add_force(const Either&, const Open&, const Moving&, Forces) { return true; }

struct Silent {};
[[maybe_unused]] void add_force(const Silent&, const Open&, const Places&, Forces) {}

struct Nothing {};
struct Elsewhere {};

static_assert(PositionForce<Weight, Open> && !MotionForce<Weight, Open> && Conservative<Weight, Open> &&
              Validated<Weight>);
static_assert(MotionForce<Drag, Open> && !PositionForce<Drag, Open> && !Conservative<Drag, Open> && !Validated<Drag>);
static_assert(PositionForce<Either, Open> && !MotionForce<Either, Open>);
static_assert(!PositionForce<Silent, Open> && !MotionForce<Silent, Open>, "a law says whether it has a value");
static_assert(!PositionForce<Nothing, Open> && !MotionForce<Nothing, Open>);
static_assert(!PositionForce<Weight, Elsewhere>, "a law is one for its own domains only");

BOOST_AUTO_TEST_SUITE(Moving_)

BOOST_AUTO_TEST_CASE(is_taken_by_a_law_that_asks_for_places_only) {
  const Vectors position{{1.0, 2.0, 3.0}}, velocity{{4.0, 5.0, 6.0}};
  const Eigen::VectorXd mass = Eigen::VectorXd::Constant(1, 2.0), radius = Eigen::VectorXd::Zero(1);
  const Eigen::VectorXd inverse_mass = mass.cwiseInverse();
  const Moving at{
      {.t = 0.5, .position = Eigen::Map<const Vectors>(position.data(), 1, 3), .mass = mass, .radius = radius},
      Eigen::Map<const Vectors>(velocity.data(), 1, 3),
      inverse_mass};
  Vectors force = Vectors::Zero(1, 3);
  BOOST_TEST(add_force(Weight{}, Open{}, at, Forces(force.data(), 1, 3)));
  BOOST_TEST(add_force(Drag{}, Open{}, at, Forces(force.data(), 1, 3)));
  BOOST_TEST(close(force, Vectors{{-4.0, -5.0, -8.0}}, {}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::law_test
