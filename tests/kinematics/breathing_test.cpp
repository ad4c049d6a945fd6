#include <particulate/kinematics/breathing.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <particulate/kinematics/central_force.hpp>

#include "close.hpp"

namespace tests::breathing_test {

using namespace particulate::kinematics;

double acceleration(const RadialForce& force, double r) { return -force.A / (r * r) + force.B / (r * r * r); }

// Fourth-order central difference.
template <class F>
double slope(const F& f, double x, double h) {
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

// What kinetic and potential energy fail to add up to, relative to their sizes.
double energy_defect(const RadialForce& force, double r_0, const Radial& at) {
  const double kinetic = 0.5 * at.v * at.v, attraction = force.A / at.r, repulsion = 0.5 * force.B / (at.r * at.r);
  const double start = -force.A / r_0 + 0.5 * force.B / (r_0 * r_0);
  return std::abs(kinetic - attraction + repulsion - start) / (kinetic + attraction + repulsion);
}

Eigen::VectorXd distances_from(const Vectors& corners, Eigen::Index i) {
  return (corners.rowwise() - corners.row(i)).rowwise().norm();
}

BOOST_AUTO_TEST_SUITE(breathing_pair_)

// Two bodies: r'' = -C/m* with C = m_i m_j (alpha1/r^2 - alpha2/r^3) and m* = m_i m_j/(m_i + m_j).
BOOST_AUTO_TEST_CASE(multiplies_by_the_sum_of_the_masses) {
  const RadialForce force = breathing_pair(0.5, 0.25, 2.0, 6.0);
  BOOST_TEST(force.A == 4.0);
  BOOST_TEST(force.B == 2.0);
}

// r'' - r phi'^2 = ..., r phi'^2 = l_z^2/r^3.
BOOST_AUTO_TEST_CASE(adds_the_centrifugal_term_to_the_repulsion) {
  const RadialForce force = breathing_pair(0.5, 0.25, 2.0, 6.0, 3.0);
  BOOST_TEST(force.A == 4.0);
  BOOST_TEST(force.B == 11.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(breathing_body_)

// Chords of an N-gon are 2 sin(pi k/N): A = (alpha1/4) sum csc(pi k/N), B = (alpha2/8) (N^2 - 1)/3.
BOOST_AUTO_TEST_CASE(agrees_with_the_closed_form_of_polygons) {
  for (const int N : {2, 3, 4, 5, 6, 7, 101}) {
    double csc = 0.0;
    for (int k = 1; k < N; ++k) csc += 1.0 / std::sin(pi * k / N);
    const RadialForce force = breathing_body(0.7, 0.3, 1.0, regular_polygon(N));
    BOOST_TEST(force.A == 0.7 / 4.0 * csc, tolerance(1e-13));
    BOOST_TEST(force.B == 0.3 / 24.0 * (N * N - 1.0), tolerance(1e-13));
  }
}

// Four neighbours at sqrt(2) and one at 2: sums 2 sqrt(2) + 1/2 and 2 + 1/4.
BOOST_AUTO_TEST_CASE(of_the_octahedron_is_as_summed_by_hand) {
  const RadialForce force = breathing_body(3.0, 5.0, 0.5, regular_solid(8));
  BOOST_TEST(force.A == 0.75 * (2.0 * std::numbers::sqrt2 + 0.5), tolerance(4.0 * eps));
  BOOST_TEST(force.B == 1.25 * 2.25, tolerance(4.0 * eps));
}

BOOST_AUTO_TEST_CASE(takes_every_regular_solid_and_puts_the_force_on_its_corners) {
  const particulate::kinematics::CentralForce law{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 2.0, .beta2 = 3.0};
  const double R = 1.7;
  for (const int faces : {4, 6, 8, 12, 20}) {
    const Vectors places = R * regular_solid(faces);
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 1; k < places.rows(); ++k) {
      pull += particulate::kinematics::force(law, vector(places, 0), vector(places, k));
    }
    const RadialForce radial = breathing_body(law.alpha1, law.alpha2, 1.0, regular_solid(faces));
    BOOST_TEST(close(pull, acceleration(radial, R) * places.row(0).transpose() / R, {.absolute = 1e-13}));
  }
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_body) {
  const Vectors alone = regular_polygon(3).topRows(1);
  CHECK_REFUSED(breathing_body(1.0, 1.0, 1.0, alone), "at least two corners, got 1");
  Vectors corners = regular_polygon(3);
  corners.row(1) *= 1.001;
  CHECK_REFUSED(breathing_body(1.0, 1.0, 1.0, corners), "on the unit sphere");
  corners = regular_polygon(3);
  corners(2, 2) = not_a_number;
  BOOST_CHECK_THROW(breathing_body(1.0, 1.0, 1.0, corners), std::invalid_argument);
  corners.row(2) = corners.row(1);
  BOOST_CHECK_THROW(breathing_body(1.0, 1.0, 1.0, corners), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(refuses_corners_that_see_different_sums) {
  const Vectors uneven{{0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}};
  CHECK_REFUSED(breathing_body(1.0, 1.0, 1.0, uneven),
                "see the others alike and be pulled along its radius; corner 1 at (1, 0, 0) does not");
}

// A rectangle looks the same from every corner, yet its long sides pull less than its short ones.
BOOST_AUTO_TEST_CASE(refuses_corners_that_are_pulled_across_their_radius) {
  const Vectors rectangle{{0.8, 0.6, 0.0}, {-0.8, 0.6, 0.0}, {-0.8, -0.6, 0.0}, {0.8, -0.6, 0.0}};
  CHECK_REFUSED(breathing_body(1.0, 1.0, 1.0, rectangle), "corner 0 at (0.8, 0.6, 0)");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(regular_polygon_)

BOOST_AUTO_TEST_CASE(has_equal_sides_on_the_unit_circle) {
  for (const int N : {2, 3, 8, 25}) {
    const Vectors corners = regular_polygon(N);
    BOOST_REQUIRE(corners.rows() == N);
    BOOST_TEST(close(corners.rowwise().norm(), Eigen::VectorXd::Ones(N), {.relative = 2.0 * eps}));
    BOOST_TEST(close(corners.col(2), Eigen::VectorXd::Zero(N), {}));
    for (int k = 0; k < N; ++k) {
      BOOST_TEST((corners.row((k + 1) % N) - corners.row(k)).norm() == 2.0 * std::sin(pi / N), tolerance(1e-14));
    }
  }
}

BOOST_AUTO_TEST_CASE(refuses_less_than_two_corners) {
  CHECK_REFUSED(regular_polygon(1), "N must be at least 2, got 1");
  CHECK_REFUSED(regular_polygon(-3), "N must be at least 2, got -3");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(regular_solid_)

struct Solid {
  int faces, corners, neighbours;
  double edge;
};

// Edges over circumradius, as in any table of the Platonic solids.
const std::vector<Solid> solids{{4, 4, 3, std::sqrt(8.0 / 3.0)},
                                {6, 8, 3, 2.0 / std::numbers::sqrt3},
                                {8, 6, 4, std::numbers::sqrt2},
                                {12, 20, 3, 4.0 / (std::numbers::sqrt3 * (1.0 + std::sqrt(5.0)))},
                                {20, 12, 5, 1.0 / std::sin(0.4 * pi)}};

BOOST_AUTO_TEST_CASE(has_its_corners_on_the_unit_sphere_about_the_origin) {
  for (const Solid& solid : solids) {
    const Vectors corners = regular_solid(solid.faces);
    BOOST_REQUIRE(corners.rows() == solid.corners);
    BOOST_TEST(close(corners.rowwise().norm(), Eigen::VectorXd::Ones(solid.corners), {.relative = 2.0 * eps}));
    BOOST_TEST(close(corners.colwise().sum(), Eigen::RowVector3d::Zero(), {.absolute = 20.0 * eps}));
  }
}

BOOST_AUTO_TEST_CASE(gives_every_corner_its_neighbours_at_one_distance) {
  for (const Solid& solid : solids) {
    const Vectors corners = regular_solid(solid.faces);
    for (Eigen::Index i = 0; i < corners.rows(); ++i) {
      const Eigen::VectorXd d = distances_from(corners, i);
      BOOST_TEST(((d.array() - solid.edge).abs() < 1e-14).count() == solid.neighbours);
      BOOST_TEST((d.array() < solid.edge - 1e-14).count() == 1);  // itself
    }
  }
}

BOOST_AUTO_TEST_CASE(refuses_other_numbers_of_faces) {
  CHECK_REFUSED(regular_solid(5), "4, 6, 8, 12 or 20 faces, got 5");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Breathing_)

struct Released {
  double alpha2, nearest, period, peak_force;
};

// Unit masses released at rest one metre apart, alpha1 = 1. Turning points r^2 - 2 a r + B/(2|E|) = 0 give
// r_min = alpha2/(2 - alpha2); the force there is 1/r_min^2 - alpha2/r_min^3. Periods by quadrature with 25 digits.
const std::vector<Released> table{{0.5, 1.0 / 3.0, 2.4183991523123, 4.5},
                                  {0.1, 0.0526315789474, 1.6964242387647, 324.9},
                                  {0.01, 0.00502512562814, 1.5826513622677, 3.92e4},
                                  {0.001, 0.000500250125063, 1.5719751607805, 3.99e6}};

BOOST_AUTO_TEST_CASE(has_the_tabulated_turning_points_periods_and_forces) {
  for (const Released& row : table) {
    const Breathing breathing(breathing_pair(1.0, row.alpha2, 1.0, 1.0), 1.0);
    BOOST_TEST(breathing.nearest() == row.nearest, tolerance(1e-12));
    BOOST_TEST(breathing.farthest() == 1.0);
    BOOST_TEST(breathing.period() == row.period, tolerance(3e-14));
    const double peak =
        strength({.alpha1 = 1.0, .alpha2 = row.alpha2, .beta1 = 2.0, .beta2 = 3.0}, breathing.nearest());
    BOOST_TEST(-peak == row.peak_force, tolerance(2e-3));
  }
}

BOOST_AUTO_TEST_CASE(has_the_tabulated_periods_of_polygons) {
  BOOST_TEST(Breathing(breathing_body(1.0, 0.5, 1.0, regular_polygon(3)), 1.0).period() == 3.693698908296404,
             tolerance(1e-14));
  BOOST_TEST(Breathing(breathing_body(1.0, 0.5, 1.0, regular_polygon(5)), 1.0).period() == 2.557674818374453,
             tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(starts_at_rest_and_turns_after_half_a_period) {
  for (const Released& row : table) {
    const Breathing breathing(breathing_pair(1.0, row.alpha2, 1.0, 1.0), 1.0);
    const Radial start = breathing.at(0.0), turn = breathing.at(0.5 * breathing.period());
    BOOST_TEST(start.r == 1.0);
    BOOST_TEST(std::abs(start.v) < 1e-15);
    // T/2 is rounded, and the bodies pass r_min with the acceleration (peak force)/m*.
    BOOST_TEST(turn.r == row.nearest, tolerance(1e-12));
    BOOST_TEST(std::abs(turn.v) <= 2.0 * row.peak_force * eps * breathing.period());
  }
}

BOOST_AUTO_TEST_CASE(keeps_its_energy) {
  for (const Released& row : table) {
    const RadialForce force = breathing_pair(1.0, row.alpha2, 1.0, 1.0);
    const Breathing breathing(force, 1.0);
    for (int k = 0; k <= 100; ++k) {
      BOOST_TEST(energy_defect(force, 1.0, breathing.at(k * breathing.period() / 97.0)) < 8.0 * eps);
    }
  }
}

// h = T/2000 makes the differences err by h^4 f^(5)/30 < 1e-9.
BOOST_AUTO_TEST_CASE(moves_by_its_own_radial_equation) {
  const RadialForce force = breathing_pair(1.0, 0.5, 1.0, 1.0);
  const Breathing breathing(force, 1.0);
  const double h = breathing.period() / 2000.0;
  for (int k = 0; k < 23; ++k) {
    const double t = k * breathing.period() / 11.3;
    const Radial now = breathing.at(t);
    BOOST_TEST(std::abs(slope([&](double s) { return breathing.at(s).r; }, t, h) - now.v) < 1e-8);
    BOOST_TEST(std::abs(slope([&](double s) { return breathing.at(s).v; }, t, h) - acceleration(force, now.r)) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(repeats_itself_and_runs_backwards_alike) {
  const Breathing breathing({.A = 2.0, .B = 0.3}, 0.9);
  for (const double t : {0.1, 0.4, 0.9}) {
    const Radial now = breathing.at(t), later = breathing.at(t + 3.0 * breathing.period()), before = breathing.at(-t);
    BOOST_TEST(later.r == now.r, tolerance(1e-13));
    BOOST_TEST(later.v == now.v, tolerance(1e-13));
    BOOST_TEST(before.r == now.r, tolerance(1e-14));
    BOOST_TEST(before.v == -now.v, tolerance(1e-14));
  }
}

// A = 2, B = 1 balance at 1/2. From rest at 0.3: 2|E| = 4/0.3 - 1/0.09 = 20/9, a = 0.9, and the other end lies at 1.5.
BOOST_AUTO_TEST_CASE(has_no_place_at_a_time_that_is_none) {
  for (const double t : {not_a_number, infinity}) {
    CHECK_REFUSED(Breathing({.A = 2.0, .B = 1.0}, 1.0).at(t), "breathing: the time must be finite");
  }
}

BOOST_AUTO_TEST_CASE(starts_outwards_from_inside_its_equilibrium) {
  const Breathing inside({.A = 2.0, .B = 1.0}, 0.3), outside({.A = 2.0, .B = 1.0}, 1.5);
  BOOST_TEST(inside.nearest() == 0.3);
  BOOST_TEST(inside.farthest() == 1.5, tolerance(4.0 * eps));
  BOOST_TEST(inside.period() == 2.0 * pi * std::sqrt(0.729 / 2.0), tolerance(4.0 * eps));
  BOOST_TEST(inside.at(0.01).v > 0.0);
  for (const double t : {0.0, 0.3, 1.1, 2.9}) {
    const Radial a = inside.at(t), b = outside.at(t + 0.5 * outside.period());
    BOOST_TEST(a.r == b.r, tolerance(1e-14));
    BOOST_TEST(std::abs(a.v - b.v) < 1e-14);
  }
}

// 2 pi sqrt(0.5^3/2) = pi/2, which is also the period of small oscillations.
BOOST_AUTO_TEST_CASE(stays_at_rest_in_equilibrium) {
  const Breathing still({.A = 2.0, .B = 1.0}, 0.5);
  BOOST_TEST(still.period() == 0.5 * pi);
  const particulate::kinematics::CentralForce law{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0};
  BOOST_TEST(small_oscillation_period(law, 1.0, 1.0) == still.period(), tolerance(4.0 * eps));
  for (const double t : {0.0, 0.1, 0.7, 1e3}) {
    BOOST_TEST(still.at(t).r == 0.5);
    BOOST_TEST(still.at(t).v == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(refuses_a_start_from_which_the_body_flies_apart) {
  CHECK_REFUSED(Breathing({.A = 2.0, .B = 1.0}, 0.25), "starts beyond B/(2A) = 0.25 m, got r_0 = 0.25 m");
  CHECK_REFUSED(Breathing({.A = 2.0, .B = 1.0}, 0.1), "got r_0 = 0.1 m");
  BOOST_CHECK_NO_THROW(Breathing({.A = 2.0, .B = 1.0}, 0.2501));
}

BOOST_AUTO_TEST_CASE(refuses_constants_that_do_not_breathe) {
  CHECK_REFUSED(Breathing({.A = 0.0, .B = 1.0}, 1.0), "A must be positive and finite, got 0");
  CHECK_REFUSED(Breathing({.A = 1.0, .B = not_a_number}, 1.0), "B must be positive and finite, got nan");
  CHECK_REFUSED(Breathing({.A = 1.0, .B = 1.0}, -1.0), "r_0 must be positive and finite, got -1");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::breathing_test
