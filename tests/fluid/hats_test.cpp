#include <particulate/fluid/hats.hpp>

#include <cmath>
#include <random>

#include "close.hpp"

namespace tests::hats_test {

using namespace particulate::fluid;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

const Grid<1> line{.cells = {8}, .lengths = Vector<1>(8.0)};
const Boundaries<1> ring{}, walls{Wall<1>{}, Wall<1>{}};
const Grid<2> sheet{.cells = {8, 10}, .lengths = {2.0, 5.0}, .corner = {-1.0, 0.25}};
const Grid<3> brick{.cells = {8, 6, 10}, .lengths = {2.0, 3.0, 5.0}, .corner = {-1.0, 0.25, 4.0}};

VectorXd one(double w) { return VectorXd::Constant(1, w); }

// What each cell counts for one place.
template <int Dim>
VectorXd weights(const Grid<Dim>& grid, const Boundaries<Dim>& faces, double w, const Vector3d& x) {
  Hats<Dim> hats(grid, faces, one(w));
  BOOST_TEST_REQUIRE(hats.place(x));
  VectorXd cells = VectorXd::Zero(grid.size());
  const double unit = 1.0;
  hats.spread(&unit, 1, 1, 1.0, cells.data());
  return cells;
}
VectorXd along(const Boundaries<1>& faces, double w, double x) { return weights<1>(line, faces, w, {x, 0.0, 0.0}); }

// What is read at a place of a function of the cells' middles.
template <int Dim, class F>
double read(const Grid<Dim>& grid, const Boundaries<Dim>& faces, double w, const Vector3d& x, const F& function) {
  const VectorXd weight = weights(grid, faces, w, x);
  double sum = 0.0;
  for (Eigen::Index q = 0; q < grid.size(); ++q) {
    std::array<Eigen::Index, Dim> cell{};
    for (Eigen::Index a = 0, rest = q; a < Dim; rest /= grid.cells[static_cast<std::size_t>(a)], ++a) {
      cell[static_cast<std::size_t>(a)] = rest % grid.cells[static_cast<std::size_t>(a)];
    }
    sum += weight[q] * function(grid.centre(cell));
  }
  return sum;
}

// Places everywhere in a box and, along x where that begins again, far beyond it.
template <int Dim>
VectorXd places(const Grid<Dim>& grid, Eigen::Index N) {
  std::mt19937 random(7);
  VectorXd r(3 * N);
  for (Eigen::Index i = 0; i < N; ++i) {
    for (int a = 0; a < 3; ++a) {
      const double u = static_cast<double>(random()) / 4294967296.0;
      r[i + a * N] = a < Dim ? grid.corner[a] + grid.lengths[a] * u : 100.0 * u;
    }
    r[i] += grid.lengths[0] * static_cast<double>(i % 5 - 2);
  }
  return r;
}
template <int Dim>
Boundaries<Dim> open_but_along_x() {
  Boundaries<Dim> faces{};
  for (std::size_t face = 2; face < faces.size(); ++face) faces[face] = Wall<Dim>{};
  return faces;
}

BOOST_AUTO_TEST_SUITE(Hats_place)

// The middles of cells lie at 0.5, 1.5, ...: of those within 2 m of 3.25 the distances are 1.75 0.75 0.25 1.25, the
// hats 1/8 5/8 7/8 3/8, their sum 2.
BOOST_AUTO_TEST_CASE(finds_the_cells_within_the_half_width) {
  VectorXd expected(8);
  expected << 0.0, 1.0, 5.0, 7.0, 3.0, 0.0, 0.0, 0.0;
  BOOST_TEST(close(along(ring, 2.0, 3.25), expected / 16.0, {.absolute = 1e-16}));
  BOOST_TEST(close(along(walls, 2.0, 3.25), expected / 16.0, {.absolute = 1e-16}));
}

BOOST_AUTO_TEST_CASE(goes_on_across_the_end_of_a_box_that_begins_again) {
  VectorXd expected(8);
  expected << 7.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 5.0;
  BOOST_TEST(close(along(ring, 2.0, 0.25), expected / 16.0, {.absolute = 1e-16}));
  for (const double periods : {-1.0, 3.0, 1e9, -1e9}) {
    BOOST_TEST(close(along(ring, 2.0, 0.25 + 8.0 * periods), expected / 16.0, {.absolute = 1e-16}));
  }
  // A hair to the left of a face is where the face is.
  BOOST_TEST(close(along(ring, 2.0, -1e-17), along(ring, 2.0, 8.0), {.absolute = 1e-15}));
}

// Of the cells within 2 m of 0.25 those inside have hats of 7/8 and 3/8.
BOOST_AUTO_TEST_CASE(takes_the_cells_inside_next_to_a_wall) {
  VectorXd expected = VectorXd::Zero(8);
  expected.head(2) << 0.7, 0.3;
  BOOST_TEST(close(along(walls, 2.0, 0.25), expected, {.absolute = 1e-15}));
  BOOST_TEST(close(along(walls, 2.0, 7.75), expected.reverse(), {.absolute = 1e-15}));
  BOOST_TEST(along(walls, 1.0, 0.0)[0] == 1.0);
  BOOST_TEST(along(walls, 1.0, 8.0)[7] == 1.0);
}

BOOST_AUTO_TEST_CASE(tells_what_is_outside_and_what_is_no_number) {
  Hats<1> open(line, walls, one(1.0)), closed(line, ring, one(1.0));
  for (const double x : {-1e-15, 8.0 * (1.0 + eps), infinity, not_a_number}) {
    BOOST_TEST(!open.place(Vector3d(x, 0.0, 0.0)));
    BOOST_TEST(!open.contains({x, 0.0, 0.0}));
  }
  BOOST_TEST((closed.place(Vector3d(-3.0, 1e300, 0.0)) && closed.contains({17.0, 0.0, -1e300})));
  // Cells beyond 4e15 of them are no numbers that a double tells apart.
  for (const double x : {4.1e15, 1.7e308, -1.7e308}) BOOST_TEST(!closed.place(Vector3d(x, 0.0, 0.0)));
  BOOST_TEST((!closed.place(Vector3d(infinity, 0.0, 0.0)) && !closed.place(Vector3d(1.0, not_a_number, 0.0))));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Hats_weights)

template <int Dim>
void sum_to_one(const Grid<Dim>& grid, double w) {
  const VectorXd r = places(grid, 50);
  for (const Boundaries<Dim>& faces : {Boundaries<Dim>{}, open_but_along_x<Dim>()}) {
    for (Eigen::Index i = 0; i < 50; ++i) {
      const VectorXd all = weights(grid, faces, w, {r[i], r[i + 50], r[i + 100]});
      BOOST_TEST(all.sum() == 1.0, tolerance(1e-14));
      BOOST_TEST(all.minCoeff() >= 0.0);
    }
  }
}
BOOST_AUTO_TEST_CASE(sum_to_one_whatever_the_half_width_and_the_walls) {
  for (const double w : {1.0, 1.37, 2.0, 4.0}) sum_to_one(line, w);
  for (const double w : {0.5, 0.83, 1.0}) sum_to_one(sheet, w), sum_to_one(brick, w);
}

// w = h: the cell alone in whose middle a place is. w = D/2: all cells, also where roundings make the hat wider than
// the box and its ends would meet in one cell, whose weight is next to nothing.
BOOST_AUTO_TEST_CASE(are_there_at_both_bounds_of_the_half_width) {
  BOOST_TEST(close(along(ring, 1.0, 3.5), VectorXd::Unit(8, 3), {}));
  VectorXd expected(8);
  expected << 1.0, 2.0, 3.0, 4.0, 3.0, 2.0, 1.0, 0.0;
  for (const double w : {4.0, 4.0 * (1.0 - 5e-13), 4.0 * (1.0 + 5e-13)}) {
    BOOST_TEST(close(along(ring, w, 3.5), expected / 16.0, {.absolute = 1e-12}));
    BOOST_TEST(close(along(ring, w, 3.5 + 8e-14), expected / 16.0, {.absolute = 1e-12}));
  }
  BOOST_TEST(close(along(ring, 1.0 - 5e-13, 3.5), VectorXd::Unit(8, 3), {.absolute = 1e-12}));
}

// On a whole number of cells they reproduce what is linear. On others, and where a wall cuts a hat, they do not: of
// w = 3/2 h a quarter off a middle hats 1/6 5/6 1/2 at -1 0 1 read 2/9 instead of 1/4.
BOOST_AUTO_TEST_CASE(read_what_is_linear_on_whole_cells_away_from_walls_alone) {
  const auto linear = [](const Vector<3>& q) { return 2.0 - 3.0 * q[0] + 0.5 * q[1] + 7.0 * q[2]; };
  const Vector3d x{-0.05, 1.6, 6.27};
  for (const double w : {0.5, 1.0}) {
    BOOST_TEST(read(brick, open_but_along_x<3>(), w, x, linear) == linear(x), tolerance(1e-14));
  }
  const auto itself = [](const Vector<1>& middle) { return middle[0]; };
  BOOST_TEST(read(line, ring, 1.5, {3.75, 0.0, 0.0}, itself) == 3.5 + 2.0 / 9.0, tolerance(1e-14));
  BOOST_TEST(read(line, walls, 2.0, {0.25, 0.0, 0.0}, itself) == 0.7 * 0.5 + 0.3 * 1.5, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(in_two_and_three_directions_are_products) {
  const Vector3d x{-0.9, 1.0, 6.27};
  const Grid<1> first{.cells = {8}, .lengths = Vector<1>(2.0), .corner = Vector<1>(-1.0)};
  const Grid<1> second{.cells = {6}, .lengths = Vector<1>(3.0), .corner = Vector<1>(0.25)};
  const Grid<1> third{.cells = {10}, .lengths = Vector<1>(5.0), .corner = Vector<1>(4.0)};
  const VectorXd a = weights(first, ring, 0.9, x), b = weights(second, walls, 0.9, {x[1], 0.0, 0.0}),
                 c = weights(third, walls, 0.9, {x[2], 0.0, 0.0});
  const VectorXd all = weights(brick, open_but_along_x<3>(), 0.9, x);
  for (Eigen::Index q = 0; q < all.size(); ++q) {
    BOOST_TEST(std::abs(all[q] - a[q % 8] * b[q / 8 % 6] * c[q / 48]) < 1e-15);
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Hats_gather_and_spread)

// sum_i g_i sum_q w_iq f_q both ways, with half-widths of their own, of two columns, a scale, and on top of what is
// there.
template <int Dim>
void is_the_transpose(const Grid<Dim>& grid) {
  constexpr Eigen::Index N = 40;
  const VectorXd r = places(grid, N), w = VectorXd::LinSpaced(N, 0.5, 1.0);
  Hats<Dim> hats(grid, open_but_along_x<Dim>(), w);
  BOOST_TEST_REQUIRE(hats.place(r));
  const MatrixXd f = MatrixXd::Random(grid.size(), 2), g = MatrixXd::Random(3, N),
                 there = MatrixXd::Ones(grid.size(), 2);
  MatrixXd read(2, N), spread = there;
  hats.gather(hats.columns(f.data(), 2), read.data());
  hats.spread(g.data(), 3, 2, -0.5, spread.data());
  const double by_places = -0.5 * (read.array() * g.topRows(2).array()).sum();
  BOOST_TEST(by_places == ((spread - there).array() * f.array()).sum(), tolerance(1e-12));
  for (int c = 0; c < 2; ++c) BOOST_TEST((spread - there).col(c).sum() == -0.5 * g.row(c).sum(), tolerance(1e-12));
}
BOOST_AUTO_TEST_CASE(have_the_same_power_on_both_sides) {
  is_the_transpose(Grid<1>{.cells = {8}, .lengths = Vector<1>(2.0)});
  is_the_transpose(sheet);
  is_the_transpose(brick);
}

template <int Dim>
void is_the_same_for(const Grid<Dim>& grid, int threads) {
  constexpr Eigen::Index N = 200;
  const VectorXd r = places(grid, N), w = VectorXd::Constant(N, 0.8);
  Hats<Dim> alone(grid, open_but_along_x<Dim>(), w), shared(grid, open_but_along_x<Dim>(), w, threads);
  BOOST_TEST_REQUIRE((alone.place(r) && shared.place(r)));
  const MatrixXd f = MatrixXd::Random(grid.size(), 3), g = MatrixXd::Random(3, N);
  const auto both = [&](const Hats<Dim>& hats) {
    MatrixXd all(3, N + grid.size());
    MatrixXd read(3, N), spread = MatrixXd::Ones(grid.size(), 3);
    hats.gather(hats.columns(f.data(), 3), read.data());
    hats.spread(g.data(), 3, 3, 1.0 / 3.0, spread.data());
    all << read, spread.transpose();
    return all;
  };
  BOOST_TEST((both(alone).array() == both(shared).array()).all());
}
BOOST_AUTO_TEST_CASE(are_the_same_to_the_bit_for_any_number_of_threads) {
  for (const int threads : {2, 3, 20}) {
    is_the_same_for(Grid<1>{.cells = {8}, .lengths = Vector<1>(2.0)}, threads);
    is_the_same_for(sheet, threads);
    is_the_same_for(brick, threads);
  }
}

BOOST_AUTO_TEST_CASE(of_no_place_are_nothing) {
  Hats<2> none(sheet, {}, VectorXd());
  VectorXd cells = VectorXd::Zero(sheet.size());
  BOOST_TEST(none.place(VectorXd()));
  none.gather(none.columns(cells.data(), 1), nullptr);
  none.spread(nullptr, 1, 1, 1.0, cells.data());
  BOOST_TEST(cells.isZero(0.0));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Hats_refusals)

BOOST_AUTO_TEST_CASE(name_the_place_the_bounds_and_what_to_do) {
  const auto refuses = [](double w, const char* words) {
    CHECK_REFUSED(Hats<2>(sheet, {}, Eigen::Vector2d(0.7, w)), words);
  };
  refuses(0.49,
          "the half-width w must lie between the largest edge of a cell, 0.5 m, and half the shortest edge of the "
          "box, 1 m, got 0.49 m for particle 1: take smaller cells, or a larger w");
  refuses(1.01, "got 1.01 m for particle 1: take a larger box, or a smaller w");
  for (const double w : {0.0, -0.7}) refuses(w, "take smaller cells, or a larger w");
  refuses(infinity, "got inf m for particle 1");
  refuses(not_a_number, "got nan m for particle 1");
  CHECK_REFUSED(Hats<1>({.cells = {3}}, {}, one(0.4)), "at least 4 cells");
}

BOOST_AUTO_TEST_CASE(of_other_places_than_it_was_made_for) {
  Hats<1> hats(line, ring, one(1.0));
  CHECK_REFUSED(hats.place(Eigen::VectorXd::Zero(2)), "hats: 1 places must hold 3 numbers, whatever directions there");
}

BOOST_AUTO_TEST_CASE(of_threads_that_cannot_be_meant) {
  for (const int threads : {0, -1, 1025}) {
    CHECK_REFUSED(Hats<1>(line, ring, one(1.0), threads), "threads must be from 1 to 1024, got ");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::hats_test
