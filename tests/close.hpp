#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>

#include "numbers.hpp"
#include "says.hpp"

namespace tests {

using boost::test_tools::tolerance;

/// What close() allows between two entries: |a - b| <= absolute + relative max(|a|, |b|).
struct Tolerance {
  double relative = 0.0;
  double absolute = 0.0;
};

/// By how much two numbers differ beyond their tolerance: not positive if they are close, NaN if one of them is.
/// An infinity is close to its equal alone, although a relative tolerance of it is infinite too.
inline double excess(double a, double b, const Tolerance& tolerance) {
  if (a == b) return 0.0;
  const double bound = tolerance.absolute + tolerance.relative * std::max(std::abs(a), std::abs(b));
  return std::isinf(a) || std::isinf(b) ? std::abs(a - b) : std::abs(a - b) - bound;
}

/// Whether two matrices or vectors, or expressions of them, agree in shape and in every entry; a NaN agrees with
/// nothing. Boost.Test alone prints no entries of a vector and does not compile for a matrix. The message names the
/// worst entry and shows both operands.
///
///     BOOST_TEST(close(position, expected, {.relative = 1e-14}));
template <class A, class B>
boost::test_tools::predicate_result close(const Eigen::DenseBase<A>& a, const Eigen::DenseBase<B>& b,
                                          const Tolerance& tolerance) {
  boost::test_tools::predicate_result verdict(true);
  if (a.rows() != b.rows() || a.cols() != b.cols()) {
    verdict = false;
    verdict.message() << "shapes " << a.rows() << " x " << a.cols() << " and " << b.rows() << " x " << b.cols();
    return verdict;
  }

  const Eigen::MatrixXd left = a.derived(), right = b.derived();
  Eigen::Index row = 0, column = 0;
  double worst = 0.0;
  for (Eigen::Index j = 0; j < left.cols(); ++j) {
    for (Eigen::Index i = 0; i < left.rows(); ++i) {
      const double beyond = excess(left(i, j), right(i, j), tolerance);
      if (beyond <= worst || std::isnan(worst)) continue;  // a NaN is the worst there is
      worst = beyond, row = i, column = j;
    }
  }
  if (worst == 0.0) return verdict;

  const Eigen::IOFormat digits(Eigen::FullPrecision, 0, ", ", "; ", "", "", "[", "]");
  verdict = false;
  verdict.message() << "entry (" << row << ", " << column << ") is off by " << worst
                    << " beyond its tolerance\n  a = " << left.format(digits) << "\n  b = " << right.format(digits);
  return verdict;
}

}  // namespace tests
