#pragma once

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace particulate::report {

/// Of several numbers the median and the ends; those that are none, NaN, stand at the end.
struct Spread {
  double least;    ///< the first in order
  double median;   ///< the middle one; of an even number the second of the two
  double largest;  ///< the last: NaN if there is one
};

/// @param numbers  one at least
/// @return their spread
/// @throws std::invalid_argument for none
Spread spread_of(std::vector<double> numbers);

/// The spread of a number that several things have.
///
/// @param all     the things, one at least
/// @param number  a function, or a member, that gives it of each
/// @return its spread
/// @throws std::invalid_argument for no thing
template <class T, class Number>
Spread spread_over(const std::vector<T>& all, const Number& number) {
  std::vector<double> numbers;
  for (const T& one : all) numbers.push_back(std::invoke(number, one));
  return spread_of(std::move(numbers));
}

/// The larger of two errors. One that is not a number is larger than all others, and stays: std::max would lose it.
///
/// @param worst  so far
/// @param error  another
/// @return the worse of the two
inline double worse_of(double worst, double error) { return std::isnan(worst) || error <= worst ? worst : error; }

/// Of several independent numbers the mean, and how far it is likely to be off.
struct Mean {
  double value;           ///< the mean
  double standard_error;  ///< standard deviation of the numbers over the root of their count; NaN of one number
};

/// @param numbers  one at least
/// @return \f$ \bar x \f$ and \f$ \sqrt{\sum (x - \bar x)^2/(n (n - 1))} \f$
/// @throws std::invalid_argument for none
Mean mean_of(const std::vector<double>& numbers);

}  // namespace particulate::report
