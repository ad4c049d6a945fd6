#include <particulate/kinematics/momentum.hpp>

#include <cmath>

#include "close.hpp"

namespace tests::momentum_test {

using namespace particulate::kinematics;

const Eigen::Vector2d mass(1.0, 3.0);
const Vectors position{{1.0, 0.0, 2.0}, {0.0, -1.0, 0.0}};
const Vectors velocity{{2.0, -1.0, 0.0}, {0.0, 1.0, 4.0}};

BOOST_AUTO_TEST_SUITE(linear_momentum_)

// 1 (2, -1, 0) + 3 (0, 1, 4).
BOOST_AUTO_TEST_CASE(sums_mass_times_velocity) {
  BOOST_TEST(close(linear_momentum(mass, velocity), Eigen::Vector3d(2.0, 2.0, 12.0), {}));
}

BOOST_AUTO_TEST_CASE(vanishes_without_particles) {
  BOOST_TEST(close(linear_momentum(Eigen::VectorXd(0), Vectors(0, 3)), Eigen::Vector3d::Zero(), {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(angular_momentum_)

// (1, 0, 2) x (2, -1, 0) = (2, 4, -1) and (0, -1, 0) x (0, 3, 12) = (-12, 0, 0).
BOOST_AUTO_TEST_CASE(sums_place_cross_momentum) {
  BOOST_TEST(close(angular_momentum(mass, position, velocity), Eigen::Vector3d(-10.0, 4.0, -1.0), {}));
}

// About another origin: H_o + shift x G with G = (2, 2, 12); (1, 0, 0) x G = (0, -12, 2).
BOOST_AUTO_TEST_CASE(changes_by_shift_cross_momentum_where_the_origin_moves) {
  const Vectors shifted = position.rowwise() + Eigen::RowVector3d(1.0, 0.0, 0.0);
  BOOST_TEST(close(angular_momentum(mass, shifted, velocity), Eigen::Vector3d(-10.0, -8.0, 1.0), {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(moment_)

// (1, 0, 2) x (0, 0, 1) = (0, -1, 0) and (0, -1, 0) x (1, 0, 0) = (0, 0, 1).
BOOST_AUTO_TEST_CASE(sums_place_cross_force) {
  const Vectors force{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}};
  BOOST_TEST(close(moment(position, force), Eigen::Vector3d(0.0, -1.0, 1.0), {}));
}

BOOST_AUTO_TEST_CASE(vanishes_for_opposite_forces_along_the_line_between_their_places) {
  const Eigen::RowVector3d along = position.row(1) - position.row(0);
  Vectors force(2, 3);
  force << along, -along;
  BOOST_TEST(close(moment(position, force), Eigen::Vector3d::Zero(), {}));
}

BOOST_AUTO_TEST_CASE(vanishes_without_particles) {
  BOOST_TEST(close(moment(Vectors(0, 3), Vectors(0, 3)), Eigen::Vector3d::Zero(), {}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(centre_of_mass_)

// (1 (1, 0, 2) + 3 (0, -1, 0))/4.
BOOST_AUTO_TEST_CASE(is_the_mean_over_the_mass) {
  BOOST_TEST(close(centre_of_mass(mass, position), Eigen::Vector3d(0.25, -0.75, 0.5), {}));
}

BOOST_AUTO_TEST_CASE(of_one_particle_is_its_own_place) {
  const Vectors alone = position.topRows(1);
  BOOST_TEST(close(centre_of_mass(Eigen::VectorXd::Constant(1, 8.0), alone), Eigen::Vector3d(1.0, 0.0, 2.0), {}));
}

BOOST_AUTO_TEST_CASE(refuses_no_particle) {
  CHECK_REFUSED(centre_of_mass(Eigen::VectorXd(0), Vectors(0, 3)), "must be at least one particle, got none");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(impulse_between_)

// 1/2 ((1, 0, 2) + (2, -1, 0)) 0.5 and 1/2 ((0, -1, 0) + (0, 1, 4)) 0.5.
BOOST_AUTO_TEST_CASE(is_the_mean_force_times_the_time) {
  BOOST_TEST(close(impulse_between(position, velocity, 0.5), Vectors{{0.75, -0.25, 0.5}, {0.0, 0.0, 1.0}}, {}));
}

// A force cos(t) from 0 to 1 gives sin(1); one interval of size h errs by h^3/12 times a mean of cos, so n of them by
// sin(1)/(12 n^2) to leading order.
BOOST_AUTO_TEST_CASE(converges_to_the_integral_with_order_two) {
  const auto force = [](double t) { return Vectors::Constant(1, 3, std::cos(t)).eval(); };
  for (const int n : {10, 20, 40}) {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      const double from = static_cast<double>(k) / n, to = static_cast<double>(k + 1) / n;
      sum += impulse_between(force(from), force(to), to - from)(0, 2);
    }
    BOOST_TEST((std::sin(1.0) - sum) * 12.0 * n * n == std::sin(1.0), boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(radius_of_gyration_)

BOOST_AUTO_TEST_CASE(is_1_of_a_pair_two_apart) {
  Vectors r(2, 3);
  r << 3, 4, 5, 5, 4, 5;
  BOOST_TEST(radius_of_gyration(r) == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(lengths_of_momenta)

BOOST_AUTO_TEST_CASE(that_differ_are_refused) {
  const Vectors two = Vectors::Ones(2, 3), three = Vectors::Ones(3, 3);
  const Eigen::VectorXd masses = Eigen::VectorXd::Ones(2);
  CHECK_REFUSED(linear_momentum(masses, three), "got 2 and 3");
  CHECK_REFUSED(angular_momentum(masses, two, three), "got 2 and 3");
  CHECK_REFUSED(angular_momentum(masses, three, two), "got 3 and 2");
  CHECK_REFUSED(moment(two, three), "got 2 and 3");
  CHECK_REFUSED(centre_of_mass(masses, three), "got 2 and 3");
  CHECK_REFUSED(impulse_between(two, three, 1.0), "got 2 and 3");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::momentum_test
