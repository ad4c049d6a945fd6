#include <particulate/laws/law.hpp>

#include "close.hpp"

namespace tests::law_test {

using namespace particulate::kinematics;
using namespace particulate::laws;

// A uniform field.
struct Weight {};
bool add_force(const Weight&, const Space&, const At<>& at, Forces force) {
  force.col(2) -= at.mass;
  return true;
}
[[maybe_unused]] double potential_energy(const Weight&, const Space&, const At<>& at) {
  return at.mass.dot(at.position.col(2));
}
[[maybe_unused]] void validate(const Weight&) {}

// A drag that reads velocities.
struct Drag {};
bool add_force(const Drag&, const Space&, const At<Velocity>& at, Forces force) {
  force -= at.velocity;
  return true;
}

// A push that grows with temperature.
struct Push {};
bool add_force(const Push&, const Space&, const At<Temperature>& at, Forces force) {
  force.col(0) += at.temperature;
  return true;
}

// A drag that grows with temperature.
struct HotDrag {};
bool add_force(const HotDrag&, const Space&, const At<Velocity, Temperature>& at, Forces force) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) force.col(axis) -= at.temperature.cwiseProduct(at.velocity.col(axis));
  return true;
}

// Both would do: what can do without velocities does.
struct Either {};
[[maybe_unused]] bool add_force(const Either&, const Space&, const At<>&, Forces) { return true; }
[[maybe_unused]] bool add_force(const Either&, const Space&, const At<Velocity>&, Forces) { return true; }

struct Silent {};
[[maybe_unused]] void add_force(const Silent&, const Space&, const At<>&, Forces) {}

struct Nothing {};
struct Elsewhere {};

template <class L>
constexpr bool needs(bool velocity, bool temperature) {
  return Force<L, Space> && needs_velocity<L, Space> == velocity && needs_temperature<L, Space> == temperature;
}
static_assert(needs<Weight>(false, false) && needs<Either>(false, false));
static_assert(needs<Drag>(true, false) && needs<Push>(false, true) && needs<HotDrag>(true, true));
static_assert(Conservative<Weight, Space> && Validated<Weight>);
static_assert(!Conservative<Drag, Space> && !Validated<Drag>);
static_assert(!Force<Silent, Space>, "a law says whether it has a value");
static_assert(!Force<Nothing, Space>);
static_assert(!Force<Weight, Elsewhere>, "a law is one for its own domains only");

BOOST_AUTO_TEST_SUITE(At_)

// Mass 2 kg, velocity (4, 5, 6) m/s, temperature 10 K.
BOOST_AUTO_TEST_CASE(is_taken_by_laws_that_ask_for_less) {
  const Vectors position{{1.0, 2.0, 3.0}}, velocity{{4.0, 5.0, 6.0}};
  const Eigen::VectorXd mass = Eigen::VectorXd::Constant(1, 2.0), radius = Eigen::VectorXd::Zero(1);
  const Eigen::VectorXd inverse_mass = mass.cwiseInverse(), temperature = Eigen::VectorXd::Constant(1, 10.0);
  Scratch scratch;
  const At<Velocity, Temperature> at{{{.t = 0.5,
                                       .position = Eigen::Map<const Vectors>(position.data(), 1, 3),
                                       .mass = mass,
                                       .radius = radius,
                                       .inverse_mass = inverse_mass,
                                       .scratch = scratch},
                                      Eigen::Map<const Vectors>(velocity.data(), 1, 3)},
                                     Eigen::Map<const Eigen::VectorXd>(temperature.data(), 1)};
  const auto force_of = [&](const auto& law) {
    Vectors force = Vectors::Zero(1, 3);
    BOOST_TEST(add_force(law, Space{}, at, Forces(force.data(), 1, 3)));
    return force;
  };
  BOOST_TEST(close(force_of(Weight{}), Vectors{{0.0, 0.0, -2.0}}, {}));
  BOOST_TEST(close(force_of(Drag{}), Vectors{{-4.0, -5.0, -6.0}}, {}));
  BOOST_TEST(close(force_of(Push{}), Vectors{{10.0, 0.0, 0.0}}, {}));
  BOOST_TEST(close(force_of(HotDrag{}), Vectors{{-40.0, -50.0, -60.0}}, {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Scratch_)

BOOST_AUTO_TEST_CASE(gives_columns_of_whole_cache_lines_filled_with_zeros) {
  Scratch scratch;
  double* const first = scratch.columns(3, 9);
  BOOST_TEST(Scratch::stride(9) == 16U);
  first[0] = 1.0, first[47] = 2.0;
  const double* const again = scratch.columns(3, 9);
  BOOST_TEST(again[0] == 0.0);
  BOOST_TEST(again[47] == 0.0);
  BOOST_TEST(reinterpret_cast<std::uintptr_t>(again) % 64 == 0U);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::law_test
