#include <particulate/kinematics/domain.hpp>

#include "close.hpp"

using particulate::kinematics::Domain;
using particulate::kinematics::Open;
using tests::close;

namespace {

struct WithoutSeparation {};

// Single precision would lose what the laws are entitled to.
struct Coarse {};
[[maybe_unused]] Eigen::Vector3f separation(const Coarse&, const Eigen::Vector3d&, const Eigen::Vector3d&) {
  return Eigen::Vector3f::Zero();
}

static_assert(Domain<Open>);
static_assert(!Domain<WithoutSeparation>, "a type is no domain without a separation");
static_assert(!Domain<Coarse>, "a separation is a Vector3d");

}  // namespace

BOOST_AUTO_TEST_SUITE(separation_)

BOOST_AUTO_TEST_CASE(leads_from_the_first_place_to_the_second) {
  const Eigen::Vector3d from(1.0, -2.0, 0.5), to(4.0, 2.0, 0.25);
  BOOST_TEST(close(separation(Open{}, from, to), Eigen::Vector3d(3.0, 4.0, -0.25), {}));
  BOOST_TEST(close(separation(Open{}, from, to), -separation(Open{}, to, from), {}));
}

BOOST_AUTO_TEST_CASE(vanishes_between_a_place_and_itself) {
  const Eigen::Vector3d here(1e300, -1e-300, 0.1);
  BOOST_TEST(close(separation(Open{}, here, here), Eigen::Vector3d::Zero(), {}));
}

BOOST_AUTO_TEST_SUITE_END()
