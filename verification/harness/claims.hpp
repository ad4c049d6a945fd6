#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace verification {

/// Stands where a case forgot a number; it fails every comparison.
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// How far a computed value may be from the expected one: |computed - expected| <= max(relative |expected|, absolute).
///
/// Its error is measured in the same unit: relative to |expected|, where |expected| counts as at least
/// absolute / relative. A row passes if and only if this error does not exceed the tolerance written beside it.
struct Tolerance {
  double relative = missing;  ///< share of |expected| [-]
  double absolute = missing;  ///< floor below which nothing is asked, in the unit of the quantity
};
/// @param tolerance  > 0; a row that expects 0 fails with it, because it would ask for the last bit
/// @return a tolerance relative to |expected|, without a floor
Tolerance relative(double tolerance);
/// @param tolerance  >= 0, in the unit of the quantity; 0 asks for the last bit
/// @return a tolerance that does not look at |expected|
Tolerance absolute(double tolerance);
/// @param relative  > 0, share of |expected|
/// @param absolute  > 0, the floor, in the unit of the quantity
/// @return the larger of the two
Tolerance mixed(double relative, double absolute);

/// One number against an independent reference.
struct Comparison {
  double expected = missing;  ///< the reference's digits, or an independent evaluation
  double computed = missing;  ///< what the library gives
  Tolerance tolerance;        ///< relative(), absolute() or mixed()
  std::string because;        ///< why the tolerance has this size; empty fails
};

/// A one-sided claim: nothing is expected but a bound.
struct Bound {
  double limit = missing;     ///< the bound itself passes
  double computed = missing;  ///< what the library gives
  std::string because;        ///< why the bound is where it is; empty fails
};

/// A whole number or a text that must be met exactly. There is no exact comparison of doubles here: see absolute(0).
class Exactly {
 public:
  /// Stands where a case forgot the value; it fails every comparison.
  Exactly() = default;
  /// @param whole  a count; true and false count as 1 and 0
  template <std::integral T>
  Exactly(T whole) : text_(std::to_string(whole)), given_(true) {}
  /// @param text  any text
  Exactly(std::string text) : text_(std::move(text)), given_(true) {}
  /// @param text  any text
  Exactly(const char* text) : text_(text), given_(true) {}
  template <std::floating_point T>
  Exactly(T) = delete;

  /// @return the value as text
  const std::string& text() const { return text_; }
  /// @return whether there is a value
  bool given() const { return given_; }

 private:
  std::string text_;
  bool given_ = false;
};

/// A count or a text against the one it must be.
struct Equality {
  Exactly expected;     ///< by reasoning, by definition or from the reference
  Exactly computed;     ///< what the library gives
  std::string because;  ///< why no other value will do; empty fails
};

/// Errors at successive refinements, for an order of accuracy. At least five points (four refinements), each step
/// between 1.25 and 16 times smaller than the one before, every error between 1000 floors and 1e-2.
///
/// The end time should be generic (no multiple of a period: symmetric methods superconverge there), the forces smooth
/// and implicit sweeps iterated to rounding.
struct Convergence {
  double nominal = missing;        ///< the order that theory gives
  std::span<const double> steps;   ///< step or mesh sizes, falling
  std::span<const double> errors;  ///< attained errors, one a step
  double floor = missing;          ///< error that rounding or the reference puts under every point, > 0
  std::string because;             ///< why this order; empty fails
};

/// How an extreme case ended.
class Ending {
 public:
  /// How good an answer was.
  struct Answer {
    double error = missing;      ///< against an independent reference
    double tolerance = missing;  ///< above it the answer is wrong
    std::string because;         ///< why the tolerance has this size; empty fails
  };
  /// @param answer  its error, and what error makes it wrong
  /// @return the ending of a run that gave an answer, right or wrong
  static Ending solved(Answer answer);
  /// @param reason  what the library gave as its reason
  /// @return the ending of a run that gave none
  static Ending refused(std::string reason);

  /// @return the answer, or nullptr if there is none
  const Answer* answer() const { return std::get_if<Answer>(&how_); }
  /// @return the reason for giving none, or nullptr if there is an answer
  const std::string* reason() const { return std::get_if<std::string>(&how_); }

 private:
  explicit Ending(std::variant<Answer, std::string> how) : how_(std::move(how)) {}
  std::variant<Answer, std::string> how_;
};

/// Largest error of a vector's components, each relative to its expected value, or to the scale where that is smaller.
/// @param computed  what the library gives
/// @param expected  as many components
/// @param scale     > 0: below it a component's error counts as absolute, divided by the scale
/// @return max over i of |computed_i - expected_i| / max(|expected_i|, scale); NaN as soon as one component is
/// @throws std::invalid_argument if the sizes differ, there is no component, or scale is not positive
double mixed_error(std::span<const double> computed, std::span<const double> expected, double scale);

/// Slope of log(error) over log(step) by least squares; logarithms to base two, so that powers of two fit exactly.
/// @param steps   positive, not all alike
/// @param errors  positive, as many
/// @return the slope: the observed order
/// @throws std::invalid_argument if there are fewer than two points, the sizes differ, or a number is not positive
double fitted_order(std::span<const double> steps, std::span<const double> errors);

}  // namespace verification
