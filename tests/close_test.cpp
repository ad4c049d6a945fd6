#include "close.hpp"

#include <stdexcept>

namespace tests::close_test {

const Eigen::Matrix2d a{{1.0, -2.0}, {0.0, 1e6}};

Eigen::Matrix2d a_with(Eigen::Index i, Eigen::Index j, double entry) {
  Eigen::Matrix2d changed = a;
  changed(i, j) = entry;
  return changed;
}

BOOST_AUTO_TEST_SUITE(close_)

BOOST_AUTO_TEST_CASE(takes_matrices_vectors_and_expressions) {
  BOOST_TEST(close(a, a, {}));
  BOOST_TEST(close(a.col(0), Eigen::Vector2d(1.0, 0.0), {}));
  BOOST_TEST(close(2.0 * a, a + a, {}));
}

BOOST_AUTO_TEST_CASE(bounds_each_entry_by_its_own_size) {
  BOOST_TEST(close(a, a_with(1, 1, 1e6 + 1.0), {.relative = 1.01e-6}));
  BOOST_TEST(!close(a, a_with(0, 0, 1.0 + 1e-5), {.relative = 1.01e-6}));
}

BOOST_AUTO_TEST_CASE(needs_an_absolute_tolerance_beside_a_zero) {
  BOOST_TEST(!close(a, a_with(1, 0, 1e-300), {.relative = 0.5}));
  BOOST_TEST(close(a, a_with(1, 0, 1e-300), {.absolute = 1e-299}));
}

BOOST_AUTO_TEST_CASE(never_accepts_a_nan) {
  BOOST_TEST(!close(a, a_with(0, 0, not_a_number), {.absolute = infinity}));
  BOOST_TEST(!close(a_with(1, 1, not_a_number), a_with(1, 1, not_a_number), {.absolute = 1.0}));
}

BOOST_AUTO_TEST_CASE(accepts_an_infinity_beside_its_equal_only) {
  BOOST_TEST(close(a_with(0, 1, infinity), a_with(0, 1, infinity), {}));
  BOOST_TEST(!close(a_with(0, 1, infinity), a_with(0, 1, -infinity), {.relative = 1.0}));
  BOOST_TEST(!close(a_with(0, 1, infinity), a, {.relative = 1.0, .absolute = 1.0}));
}

BOOST_AUTO_TEST_CASE(refuses_other_shapes) {
  BOOST_TEST(close(a, a.col(0), {}).message().str() == "shapes 2 x 2 and 2 x 1");
}

BOOST_AUTO_TEST_CASE(names_the_worst_entry_a_nan_first) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  BOOST_TEST(close(zero, Eigen::Vector3d(1.0, 3.0, 2.0), {}).message().str().starts_with("entry (1, 0) is off by 3"));
  BOOST_TEST(close(zero, Eigen::Vector3d(1.0, not_a_number, 2.0), {})
                 .message()
                 .str()
                 .starts_with("entry (1, 0) is off by nan"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(says_)

BOOST_AUTO_TEST_CASE(looks_for_words_in_an_exceptions_text) {
  BOOST_TEST(says("must be positive")(std::invalid_argument("mass must be positive, got 0")));
  BOOST_TEST(!says("must be negative")(std::invalid_argument("mass must be positive, got 0")));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::close_test
