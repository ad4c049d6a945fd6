#include <particulate/kinematics/energy.hpp>

#include <cmath>

#include "close.hpp"

namespace tests::energy_test {

using namespace particulate::kinematics;

const Eigen::Vector2d mass(1.0, 3.0);
const Vectors velocity{{2.0, -1.0, 0.0}, {0.0, 1.0, 4.0}};

BOOST_AUTO_TEST_SUITE(kinetic_energy_)

// (1 (4 + 1) + 3 (1 + 16))/2 = 28.
BOOST_AUTO_TEST_CASE(is_half_the_mass_times_the_speed_squared) { BOOST_TEST(kinetic_energy(mass, velocity) == 28.0); }

BOOST_AUTO_TEST_CASE(vanishes_without_particles) {
  BOOST_TEST(kinetic_energy(Eigen::VectorXd(0), Vectors(0, 3)) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(split_kinetic_energy_)

// v_cm = (2, 2, 12)/4, half its square is (0.25 + 0.25 + 9)/2 = 4.75; the whole is 28/4 = 7.
BOOST_AUTO_TEST_CASE(adds_up_to_the_energy_per_unit_mass) {
  const KineticEnergy split = split_kinetic_energy(mass, velocity);
  BOOST_TEST(split.bulk == 4.75);
  BOOST_TEST(split.relative == 2.25);
}

BOOST_AUTO_TEST_CASE(gives_a_rigid_translation_no_relative_part) {
  const Vectors together = Eigen::RowVector3d(0.5, -0.25, 2.0).replicate(2, 1);
  BOOST_TEST(split_kinetic_energy(mass, together).relative == 0.0);
}

// A common velocity of 2^20 m/s over relative speeds of 1 m/s: energies of 5e11 J/kg, whose difference would err by
// 1e-4.
BOOST_AUTO_TEST_CASE(keeps_the_relative_part_of_a_fast_cloud) {
  const Vectors fast = velocity.rowwise() + Eigen::RowVector3d(1048576.0, 0.0, 0.0);
  BOOST_TEST(split_kinetic_energy(mass, fast).relative == 2.25, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(refuses_no_particle) {
  CHECK_REFUSED(split_kinetic_energy(Eigen::VectorXd(0), Vectors(0, 3)), "at least one particle");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(power_of_)

// (1, 1, 1).(2, -1, 0) + (0, -2, 0.5).(0, 1, 4) = 1 + 0.
BOOST_AUTO_TEST_CASE(sums_force_times_velocity) {
  const Vectors force{{1.0, 1.0, 1.0}, {0.0, -2.0, 0.5}};
  BOOST_TEST(power_of(force, velocity) == 1.0);
  BOOST_TEST(power_of(Vectors(0, 3), Vectors(0, 3)) == 0.0);
}

BOOST_AUTO_TEST_CASE(vanishes_for_forces_across_the_motion) {
  const Vectors across{{1.0, 2.0, 7.0}, {5.0, -4.0, 1.0}};
  BOOST_TEST(power_of(across, velocity) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(work_between_)

// 1/2 ((1, 0, 2) + (3, 0, 0)).(1, 5, -1) = (2, 0, 1).(1, 5, -1).
BOOST_AUTO_TEST_CASE(is_the_mean_force_along_the_displacement) {
  const Vectors force_1{{1.0, 0.0, 2.0}}, force_2{{3.0, 0.0, 0.0}}, from{{0.0, 1.0, 0.0}}, to{{1.0, 6.0, -1.0}};
  BOOST_TEST(work_between(force_1, from, force_2, to) == 1.0);
  BOOST_TEST(work_between(force_2, to, force_1, from) == -1.0);
}

// Psi = -r over the quarter circle (cos s, 2 sin s, 0): the work is minus the growth of r^2/2, here -(4 - 1)/2. The
// trapezoidal rule is exact for a linear force on any chord.
BOOST_AUTO_TEST_CASE(of_a_spring_is_exact_on_every_chord) {
  const auto place = [](double s) { return Vectors{{std::cos(s), 2.0 * std::sin(s), 0.0}}; };
  double sum = 0.0;
  for (int k = 0; k < 7; ++k) {
    const Vectors from = place(k * std::acos(0.0) / 7.0), to = place((k + 1) * std::acos(0.0) / 7.0);
    sum += work_between(-from, from, -to, to);
  }
  BOOST_TEST(sum == -1.5, boost::test_tools::tolerance(1e-14));
}

// Psi = r^3 from 0 to 1 along x: 1/4, and the rule adds h^2/12 (Psi'(1) - Psi'(0)) = h^2/4.
BOOST_AUTO_TEST_CASE(converges_with_order_two) {
  const auto place = [](double x) { return Vectors{{x, 0.0, 0.0}}; };
  for (const int n : {4, 8, 16}) {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      const double a = static_cast<double>(k) / n, b = static_cast<double>(k + 1) / n;
      sum += work_between(place(a * a * a), place(a), place(b * b * b), place(b));
    }
    BOOST_TEST((sum - 0.25) * 4.0 * n * n == 1.0, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(lengths_of_energies)

// Read against each other, two masses and three velocities gave 3 J.
BOOST_AUTO_TEST_CASE(that_differ_are_refused) {
  const Vectors two = Vectors::Ones(2, 3), three = Vectors::Ones(3, 3);
  const Eigen::VectorXd masses = Eigen::VectorXd::Ones(2);
  CHECK_REFUSED(kinetic_energy(masses, three), "must hold one entry a particle each, got 2 and 3");
  CHECK_REFUSED(split_kinetic_energy(masses, three), "got 2 and 3");
  CHECK_REFUSED(power_of(three, two), "got 3 and 2");
  CHECK_REFUSED(work_between(two, two, three, two), "got 2 and 2 and 3 and 2");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::energy_test
