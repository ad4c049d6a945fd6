#include <particulate/kinematics/starts.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "close.hpp"
#include "clouds.hpp"

namespace tests::starts_test {

using namespace particulate::kinematics;

Added put(const Eigen::VectorXd& radius, const Addition& to, unsigned seed = 1) {
  return random_addition(radius, to, Uniform(seed));
}

// The largest overlap of two of them, and of one with an edge if it counts: all pairs.
double overlap(const Added& added, const Eigen::VectorXd& radius, const Addition& to) {
  double deepest = -infinity;
  for (Eigen::Index i = 0; i < radius.size(); ++i) {
    const Eigen::Vector3d a = vector(added.position, i);
    for (Eigen::Index j = 0; j < i; ++j) {
      const double apart = separation(to.domain, a, vector(added.position, j)).norm();
      deepest = std::max(deepest, radius[i] + radius[j] - apart);
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const bool edge = to.inside == Inside::spheres && std::isinf(to.domain.lengths[axis]);
      const double stay = edge ? radius[i] : 0.0, above = a[axis] - to.box.corner[axis];
      deepest = std::max({deepest, stay - above, stay + above - to.box.lengths[axis]});
    }
  }
  return deepest;
}

const Box oblong{.lengths = {2.0, 1.0, 0.5}, .corner = {-1.0, 3.0, 0.0}};

BOOST_AUTO_TEST_SUITE(uniform_from_)

// The standard says what the 10000th number of mt19937_64 with its default seed is: of it the upper 53 bits.
BOOST_AUTO_TEST_CASE(gives_the_upper_bits_of_a_known_generator) {
  const auto draw = uniform_from(5489);
  double last = 0.0;
  for (int k = 0; k < 10000; ++k) last = draw();
  BOOST_TEST(last == static_cast<double>(9981545732273789042u >> 11) / 9007199254740992.0);
}

BOOST_AUTO_TEST_CASE(lies_in_its_interval_and_has_the_same_bits_for_the_same_seed) {
  const auto draw = uniform_from(7), again = uniform_from(7), other = uniform_from(8);
  int same = 0, at_the_ends = 0;
  for (int k = 0; k < 10000; ++k) {
    const double u = draw();
    BOOST_TEST_REQUIRE((u >= 0.0 && u < 1.0));
    BOOST_TEST_REQUIRE(u == again());
    same += u == other() ? 1 : 0;
    at_the_ends += u < 1e-3 || u >= 0.999 ? 1 : 0;
  }
  BOOST_TEST(same == 0);
  BOOST_TEST(at_the_ends > 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(random_addition_)

BOOST_AUTO_TEST_CASE(puts_spheres_where_they_overlap_nothing) {
  const double b = 0.045;  // at 300 a fraction of 0.115
  Eigen::VectorXd equal = Eigen::VectorXd::Constant(300, b), several = equal;
  for (Eigen::Index i = 0; i < 300; i += 7) several[i] = i % 2 == 0 ? 0.1 * b : 2.0 * b;
  several[1] = 0.0;
  for (const Inside inside : {Inside::centres, Inside::spheres}) {
    for (const bool repeats : {false, true}) {
      Addition to{.box = oblong, .inside = inside};
      if (repeats) to.domain.lengths = {infinity, 1.0, 0.6};
      for (const Eigen::VectorXd& radius : {equal, several}) {
        const Added added = put(radius, to);
        BOOST_TEST(overlap(added, radius, to) <= 1e-15);
        BOOST_TEST(added.attempts > 300);
      }
    }
  }
}

// 1000 of a fraction of 0.3 fill the box up to its edges: some centre lies within b of each of them, some sphere sticks
// out where it may.
BOOST_AUTO_TEST_CASE(keeps_inside_what_it_is_told_to) {
  const Eigen::VectorXd radius = Eigen::VectorXd::Constant(500, 0.05);
  for (const Inside inside : {Inside::centres, Inside::spheres}) {
    const Added added = put(radius, {.inside = inside});
    const double least = added.position.minCoeff(), most = added.position.maxCoeff();
    BOOST_TEST(least >= (inside == Inside::spheres ? 0.05 : 0.0));
    BOOST_TEST(least < (inside == Inside::spheres ? 0.06 : 0.01));
    BOOST_TEST(most > 1.0 - (inside == Inside::spheres ? 0.06 : 0.01));
  }
}

// Points overlap nothing: each is put at once, at independent uniform places. Chi-square of 8 x 8 x 8 cells with 511
// degrees of freedom: mean 511, deviation sqrt(2 511) = 32; five deviations are allowed.
BOOST_AUTO_TEST_CASE(draws_its_places_evenly) {
  const Eigen::Index N = 20000;
  const Added added = put(Eigen::VectorXd::Zero(N), {.box = oblong});
  BOOST_TEST(added.attempts == N);
  std::vector<double> count(512, 0.0);
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Vector3d at = 8.0 * (vector(added.position, i) - oblong.corner).cwiseQuotient(oblong.lengths);
    count.at(static_cast<std::size_t>(64 * std::floor(at[0]) + 8 * std::floor(at[1]) + std::floor(at[2]))) += 1.0;
  }
  const double expected = static_cast<double>(N) / 512.0;
  double chi_square = 0.0;
  for (const double n : count) chi_square += (n - expected) * (n - expected) / expected;
  BOOST_TEST(std::abs(chi_square - 511.0) < 5.0 * std::sqrt(2.0 * 511.0));
}

// In a periodic cube no place is special, and n spheres of volume v leave 1 - 8 n v for the next centre as long as
// their spheres of exclusion are apart: of the second of two, each try fails with probability 8 v. Of 4000 pairs, tries
// beyond two are 4000 q/(1 - q) with a deviation of sqrt(4000 q)/(1 - q); five are allowed.
BOOST_AUTO_TEST_CASE(tries_as_often_as_the_free_room_asks) {
  const double b = 0.2, q = 8.0 * 4.0 / 3.0 * pi * b * b * b;
  Addition to;
  to.domain.lengths.setOnes();
  Uniform uniform(3);
  long beyond = 0;
  for (int k = 0; k < 4000; ++k) {
    beyond += random_addition(Eigen::Vector2d(b, b), to, [&] { return uniform(); }).attempts - 2;
  }
  BOOST_TEST(std::abs(static_cast<double>(beyond) - 4000.0 * q / (1.0 - q)) < 5.0 * std::sqrt(4000.0 * q) / (1.0 - q));
}

BOOST_AUTO_TEST_CASE(has_the_same_bits_for_the_same_numbers) {
  const Eigen::VectorXd radius = Eigen::VectorXd::Constant(100, 0.05);
  BOOST_TEST((put(radius, {}).position == put(radius, {}).position));
  BOOST_TEST((put(radius, {}).position != put(radius, {}, 2).position));
}

BOOST_AUTO_TEST_CASE(puts_none_one_and_what_just_fits) {
  BOOST_TEST(put(Eigen::VectorXd(0), {}).attempts == 0);
  BOOST_TEST(put(Eigen::VectorXd::Constant(1, 0.3), {}).attempts == 1);
  const Added tight = put(Eigen::VectorXd::Constant(1, 0.5), {.inside = Inside::spheres});
  BOOST_TEST(vector(tight.position, 0) == Eigen::Vector3d::Constant(0.5));
}

// In a bounded number of attempts, each a draw of three numbers.
BOOST_AUTO_TEST_CASE(gives_up_where_there_is_no_room_and_says_how_far_it_came) {
  const Eigen::VectorXd radius = Eigen::VectorXd::Constant(64, std::cbrt(0.6 * 3.0 / (4.0 * pi * 64.0)));
  Addition to{.most_attempts = 20000};
  to.domain.lengths.setOnes();
  long drawn = 0;
  Uniform uniform(1);
  const auto counted = [&] { return ++drawn, uniform(); };
  std::string said;
  try {
    (void)random_addition(radius, to, counted);
  } catch (const std::invalid_argument& error) { said = error.what(); }
  BOOST_TEST(drawn == 60000);
  BOOST_TEST(contains(said, " of 64 did in 20000 attempts, which is a volume fraction of 0.3"));
  BOOST_TEST(contains(said, " of 0.6000 asked for. At random they come to a standstill at 0.384 "));
  BOOST_TEST(contains(said, "near 0.35 if they lie wholly inside"));
  BOOST_TEST(contains(said, "take fewer or smaller ones, start from a lattice, or below that raise most_attempts"));
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_meant) {
  const Eigen::VectorXd radius = Eigen::VectorXd::Constant(2, 0.1);
  for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
    Addition to;
    to.box.lengths[1] = bad;
    CHECK_REFUSED(put(radius, to), "positive and finite, got ");
  }
  CHECK_REFUSED(put(radius, {.box = {.corner = {0.0, 0.0, not_a_number}}}), "from nan m in z");
  CHECK_REFUSED(put(Eigen::Vector2d(0.1, -0.1), {}), "not negative, got -0.1 m for sphere 1");
  CHECK_REFUSED(put(Eigen::Vector2d(0.1, not_a_number), {}), "not negative, got nan m for sphere 1");
  CHECK_REFUSED(put(radius, {.most_attempts = -1}), "or 0 for the default, got -1");
  CHECK_REFUSED(put(Eigen::VectorXd::Constant(1, 0.3), {.box = oblong, .inside = Inside::spheres}),
                "a sphere must fit into the box, got a radius of 0.3 m for a shortest edge of 0.5 m");
  Addition to{.box = oblong};
  to.domain.lengths = {1.5, infinity, infinity};
  CHECK_REFUSED(put(radius, to), "not be longer than the period, got 2 m for a period of 1.5 m in x");
  to = {};
  to.domain.lengths[0] = 1.0;
  CHECK_REFUSED(put(Eigen::VectorXd::Constant(1, 0.3), to), "two diameters");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(volume_fraction_)

// 1000 spheres of L = 0.25 in the unit cube: b = 0.025, 4/3 pi 0.25^3.
BOOST_AUTO_TEST_CASE(follows_from_the_length_ratio) {
  const double v_f = volume_fraction(Eigen::VectorXd::Constant(1000, 0.025), {});
  BOOST_TEST(v_f == 4.0 / 3.0 * pi * 0.25 * 0.25 * 0.25, tolerance(1e-13));
  BOOST_TEST(volume_fraction(Eigen::Vector2d(0.1, 0.2), oblong) == 4.0 / 3.0 * pi * 0.009, tolerance(1e-15));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(lattice_)

// Distances of the nearest in a lattice that repeats itself after n cells, and how many there are of them.
BOOST_AUTO_TEST_CASE(has_its_nearest_neighbours_and_goes_on_beyond_its_edges) {
  const struct {
    Lattice kind;
    Eigen::Index N;
    double apart;
    int neighbours;
  } cases[] = {{Lattice::simple_cubic, 27, 0.5, 6}, {Lattice::face_centred_cubic, 108, 0.5 / std::sqrt(2.0), 12}};
  for (const auto& [kind, N, apart, neighbours] : cases) {
    const Vectors at = lattice(kind, N, 0.5);
    Space space;
    space.lengths.setConstant(1.5);
    BOOST_TEST(at.minCoeff() > 0.0);
    BOOST_TEST(at.maxCoeff() < 1.5);
    for (Eigen::Index i = 0; i < N; ++i) {
      int near = 0;
      for (Eigen::Index j = 0; j < N; ++j) {
        const double d = separation(space, vector(at, i), vector(at, j)).norm();
        BOOST_TEST((i == j || d >= apart * (1.0 - 1e-12)));
        near += d > 0.0 && d < apart * (1.0 + 1e-12) ? 1 : 0;
      }
      BOOST_TEST(near == neighbours);
    }
  }
}

BOOST_AUTO_TEST_CASE(is_filled_in_the_order_of_x_y_z) {
  const Vectors simple = lattice(Lattice::simple_cubic, 6, 2.0);
  BOOST_TEST(vector(simple, 0) == Eigen::Vector3d(1.0, 1.0, 1.0));
  BOOST_TEST(vector(simple, 1) == Eigen::Vector3d(3.0, 1.0, 1.0));
  BOOST_TEST(vector(simple, 2) == Eigen::Vector3d(1.0, 3.0, 1.0));
  BOOST_TEST(vector(simple, 5) == Eigen::Vector3d(3.0, 1.0, 3.0));
  const Vectors faces = lattice(Lattice::face_centred_cubic, 5, 4.0);
  BOOST_TEST(vector(faces, 3) == Eigen::Vector3d(1.0, 3.0, 3.0));
  BOOST_TEST(vector(faces, 4) == Eigen::Vector3d(5.0, 1.0, 1.0));
  BOOST_TEST(lattice(Lattice::simple_cubic, 0, 1.0).rows() == 0);
  BOOST_TEST(lattice(Lattice::simple_cubic, 1000, 1.0).maxCoeff() == 9.5);
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_meant) {
  CHECK_REFUSED(lattice(Lattice::simple_cubic, -1, 1.0), "got -1 and 1 m");
  CHECK_REFUSED(lattice(Lattice::simple_cubic, 8, 0.0), "got 8 and 0 m");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(particles_from_)

using Lines = std::vector<std::vector<std::string>>;
const std::vector<std::string> header = {"x", "y", "z", "vx", "vy", "vz", "m", "b"};
const std::vector<std::string> with_immovable = {"x", "y", "z", "vx", "vy", "vz", "m", "b", "immovable"};

BOOST_AUTO_TEST_CASE(reads_a_particle_a_line) {
  const Particles two = particles_from(
      {header, {"1", "2", "3", "-1e-3", "0", "0.5", "2", "0.1"}, {"0.1", " 4 ", "5", "0", "0", "0", "3", "0"}},
      "start.csv");
  BOOST_TEST(two.size() == 2);
  BOOST_TEST(vector(two.position, 0) == Eigen::Vector3d(1.0, 2.0, 3.0));
  BOOST_TEST(vector(two.position, 1) == Eigen::Vector3d(0.1, 4.0, 5.0));
  BOOST_TEST(vector(two.velocity, 0) == Eigen::Vector3d(-1e-3, 0.0, 0.5));
  BOOST_TEST(two.mass == Eigen::Vector2d(2.0, 3.0));
  BOOST_TEST(two.radius == Eigen::Vector2d(0.1, 0.0));
  BOOST_TEST(two.immovable.empty());
  BOOST_TEST(particles_from({header}, "start.csv").size() == 0);
  const Particles held = particles_from({with_immovable,
                                         {"1", "2", "3", "0", "0", "0", "2", "0.1", "0"},
                                         {"4", "5", "6", "0", "0", "0", "2", "0.1", "1"}},
                                        "start.csv");
  BOOST_TEST((held.immovable == std::vector<bool>{false, true}));
}

BOOST_AUTO_TEST_CASE(names_file_and_line_of_what_it_cannot_read) {
  const std::vector<std::string> good = {"1", "2", "3", "0", "0", "0", "2", "0.1"};
  const auto with = [&](std::size_t column, const char* text) {
    std::vector<std::string> line = good;
    line[column] = text;
    return Lines{header, good, line};
  };
  CHECK_REFUSED(particles_from(with(3, "fast"), "start.csv"), "start.csv:3: vx must be a finite number, got \"fast\"");
  CHECK_REFUSED(particles_from(with(0, "1.5x"), "start.csv"), "start.csv:3: x must be a finite number, got \"1.5x\"");
  CHECK_REFUSED(particles_from(with(2, ""), "start.csv"), "start.csv:3: z must be a finite number, got \"\"");
  CHECK_REFUSED(particles_from(with(1, "nan"), "start.csv"), "start.csv:3: y must be a finite number, got \"nan\"");
  CHECK_REFUSED(particles_from(with(6, "0"), "start.csv"), "start.csv:3: m must be positive, in kg, got 0");
  CHECK_REFUSED(particles_from(with(7, "-0.1"), "start.csv"), "start.csv:3: b must not be negative, in m, got -0.1");
  CHECK_REFUSED(particles_from({header, {"1", "2", "3"}}, "start.csv"),
                "start.csv:2: must hold 8 columns, x,y,z,vx,vy,vz,m,b, got 3: write one particle a line");
  CHECK_REFUSED(particles_from({with_immovable, {"1", "2", "3", "0", "0", "0", "2", "0.1", "yes"}}, "start.csv"),
                "start.csv:2: immovable must be a finite number, got \"yes\"");
  CHECK_REFUSED(particles_from({with_immovable, {"1", "2", "3", "0", "0", "0", "2", "0.1", "2"}}, "start.csv"),
                "start.csv:2: immovable must be 0 or 1, got 2");
  CHECK_REFUSED(particles_from({good}, "start.csv"),
                "start.csv:1: a file of particles must begin with the line \"x,y,z,vx,vy,vz,m,b\", and \",immovable\" "
                "if some do not move, got \"1,2,3,0,0,0,2,0.1\": write it above the numbers");
  CHECK_REFUSED(particles_from({}, "start.csv"), "start.csv:1: a file of particles must begin with");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_apart_)

// Radii 1, 1 and 0.5 in a row; the first is 0.25 m into the wall on its other side, or not.
Particles row_of_three(double second, double third, double first = 0.0) {
  return particles({{.position = {first, 0.0, 0.0}, .mass = 1.0, .radius = 1.0},
                    {.position = {second, 0.0, 0.0}, .mass = 1.0, .radius = 1.0},
                    {.position = {third, 0.0, 0.0}, .mass = 1.0, .radius = 0.5}});
}

BOOST_AUTO_TEST_CASE(names_the_deepest_overlap) {
  const Space open, between{.walls = {{.point = {-1.0, 0.0, 0.0}, .normal = {1.0, 0.0, 0.0}}}};
  BOOST_TEST(validate_apart(row_of_three(2.0, 3.5), between) == 0.0);
  BOOST_TEST(validate_apart(row_of_three(2.0 - 0x1p-39, 3.5), between) == 0x1p-39);
  CHECK_REFUSED(validate_apart(row_of_three(2.0 - 0x1p-36, 3.5), between), "spheres 0 and 1 overlap by 1.45");
  CHECK_REFUSED(validate_apart(row_of_three(1.9, 3.0), open),
                "no two spheres may overlap, nor a sphere and a wall; spheres 1 and 2 overlap by 0.3999");
  CHECK_REFUSED(validate_apart(row_of_three(1.5, 3.0), open), "spheres 0 and 1 overlap by 0.5 m, deepest of all");
  CHECK_REFUSED(validate_apart(row_of_three(2.0, 3.5, -0.25), between), "sphere 0 and wall 0 overlap by 0.25 m");
  CHECK_REFUSED(validate_apart(row_of_three(2.0, 3.5), Space{.lengths = {4.75, infinity, infinity}}),
                "spheres 0 and 2 overlap by 0.25 m");
  Particles nowhere = row_of_three(2.0, 3.5);
  nowhere.position(0, 1) = not_a_number;
  CHECK_REFUSED(validate_apart(nowhere, open), "must be finite");
}

BOOST_AUTO_TEST_CASE(takes_no_notice_of_roundings_and_of_what_cannot_move) {
  Particles far = row_of_three(2.0, 3.5);
  far.position.col(0).array() = (far.position.col(0).array() + 1e6) * 1e-7;
  far.radius *= 1e-7;
  validate_apart(far, Space{});
  Particles held = row_of_three(1.5, 3.0);
  held.immovable = {true, true, false};
  validate_apart(held, Space{});
  validate_apart(Particles{}, Space{});
  held.radius.setZero();
  held.position.setZero();
  validate_apart(held, Space{});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(order_)

// The eight cells of a cube, two bodies in each: x first, then y, then z, as the curve begins.
BOOST_AUTO_TEST_CASE(goes_cell_by_cell) {
  Vectors at(16, 3);
  for (int k = 0; k < 16; ++k) at.row(k) << (k & 1) * 1.0 + 0.3, (k >> 1 & 1) * 1.0, (k >> 2 & 1) * 1.0 + 0.01 * k;
  const std::vector<Eigen::Index> order = order_by_cells(at, 1.0);
  BOOST_TEST(order == std::vector<Eigen::Index>({0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15}),
             boost::test_tools::per_element());
  BOOST_TEST(order_by_cells(Vectors(0, 3), 1.0).empty());
  CHECK_REFUSED(order_by_cells(at, 0.0), "must have a positive edge, got 0 m");
}

// Of 4096 points at random, one and the next: a mean distance of a few edges, not half the box.
BOOST_AUTO_TEST_CASE(brings_neighbours_together) {
  const Added added = put(Eigen::VectorXd::Zero(4096), {});
  const std::vector<Eigen::Index> order = order_by_cells(added.position, 1.0 / 16.0);
  double sum = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    sum += (added.position.row(order[k]) - added.position.row(order[k - 1])).norm();
  }
  BOOST_TEST(sum / 4095.0 < 2.0 / 16.0);
}

BOOST_AUTO_TEST_CASE(moves_all_of_a_particle) {
  const Particles three =
      particles({{.position = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.1},
                 {.position = {2.0, 0.0, 0.0}, .velocity = {0.0, 2.0, 0.0}, .mass = 2.0, .radius = 0.2},
                 {.position = {3.0, 0.0, 0.0}, .mass = 3.0, .radius = 0.3, .immovable = true}});
  const Particles moved = reordered(three, {2, 0, 1});
  BOOST_TEST(moved.position.col(0) == Eigen::Vector3d(3.0, 1.0, 2.0));
  BOOST_TEST(vector(moved.velocity, 2) == Eigen::Vector3d(0.0, 2.0, 0.0));
  BOOST_TEST(moved.mass == Eigen::Vector3d(3.0, 1.0, 2.0));
  BOOST_TEST(moved.radius == Eigen::Vector3d(0.3, 0.1, 0.2));
  BOOST_TEST((moved.immovable == std::vector<bool>{true, false, false}));
  for (const std::vector<Eigen::Index>& bad : {std::vector<Eigen::Index>{0, 1}, {0, 1, 1}, {0, 1, 3}}) {
    CHECK_REFUSED(reordered(three, bad), "must name each of 3 particles once");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::starts_test
