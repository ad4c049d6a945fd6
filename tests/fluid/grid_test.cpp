#include <particulate/fluid/grid.hpp>

#include "close.hpp"

namespace tests::grid_test {

using namespace particulate::fluid;

// Cells of 0.5 m x 0.25 m x 2 m.
const Grid<3> box{.cells = {4, 8, 5}, .lengths = {2.0, 2.0, 10.0}, .corner = {-1.0, 3.0, 0.0}};

BOOST_AUTO_TEST_SUITE(grid)

BOOST_AUTO_TEST_CASE(has_as_many_cells_as_the_product_and_edges_that_fill_its_lengths) {
  BOOST_TEST(box.size() == 160);
  BOOST_TEST(box.h(0) == 0.5);
  BOOST_TEST(box.h(1) == 0.25);
  BOOST_TEST(box.h(2) == 2.0);
  BOOST_TEST((Grid<1>{.cells = {7}}.size()) == 7);
}

BOOST_AUTO_TEST_CASE(has_middles_of_cells_also_beyond_its_faces) {
  BOOST_TEST(close(box.centre({0, 0, 0}), Eigen::Vector3d(-0.75, 3.125, 1.0), {.relative = 1e-15}));
  BOOST_TEST(close(box.centre({3, 7, 4}), Eigen::Vector3d(0.75, 4.875, 9.0), {.relative = 1e-15}));
  BOOST_TEST(close(box.centre({-1, 8, 4}), Eigen::Vector3d(-1.25, 5.125, 9.0), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(numbers_its_cells_along_x_then_y_then_z) {
  BOOST_TEST(box.index({0, 0, 0}) == 0);
  BOOST_TEST(box.index({1, 0, 0}) == 1);
  BOOST_TEST(box.index({0, 1, 0}) == 4);
  BOOST_TEST(box.index({0, 0, 1}) == 32);
  BOOST_TEST(box.index({3, 7, 4}) == 159);
  BOOST_TEST((Grid<2>{.cells = {4, 5}}.index({2, 3})) == 14);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_a_box_of_four_cells_a_direction) {
  BOOST_CHECK_NO_THROW(validate(box));
  BOOST_CHECK_NO_THROW(validate(Grid<1>{.cells = {4}}));
}

BOOST_AUTO_TEST_CASE(refuses_fewer_than_four_cells_in_a_direction) {
  CHECK_REFUSED(validate(Grid<1>{.cells = {3}}), "grid: there must be at least 4 cells in each direction, got 3 in x");
  CHECK_REFUSED(validate(Grid<2>{.cells = {4, 0}}), "at least 4 cells in each direction, got 0 in y");
  CHECK_REFUSED(validate(Grid<3>{.cells = {4, 4, -4}}), "at least 4 cells in each direction, got -4 in z");
}

BOOST_AUTO_TEST_CASE(refuses_a_box_that_is_none) {
  const auto refuses = [](double length, double corner, const char* words) {
    CHECK_REFUSED(validate(Grid<2>{.cells = {4, 4}, .lengths = {1.0, length}, .corner = {0.0, corner}}), words);
  };
  refuses(0.0, 0.0, "grid: its corner must be finite and its lengths positive and finite, got 0 m from 0 m in y");
  refuses(-1.0, 2.0, "got -1 m from 2 m in y");
  refuses(infinity, 0.0, "got inf m from 0 m in y");
  refuses(not_a_number, 0.0, "got nan m from 0 m in y");
  refuses(1.0, infinity, "got 1 m from inf m in y");
  refuses(1.0, not_a_number, "got 1 m from nan m in y");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::grid_test
