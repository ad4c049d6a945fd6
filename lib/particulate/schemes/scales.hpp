#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// What the error of a step is compared with.

namespace particulate::schemes {

/// @param x  numbers @return the largest of their absolute values; NaN if one of them is, 0 of none
double largest(const Eigen::VectorXd& x);

/// Sizes that a caller gives. What is left out follows from the motion itself: see ErrorScales.
struct Sizes {
  std::optional<double> size = {};   ///< errors of values and places count relative above it, > 0 [their unit]
  std::optional<double> speed = {};  ///< errors of velocities likewise, > 0 [m/s]
  Eigen::VectorXd each = {};         ///< one size for each number in (r, y), instead of `size`; empty: none
};

/// Refuses sizes that cannot be meant.
///
/// @param whose  the setting's owner, for the message
/// @param sizes  the sizes
/// @throws std::invalid_argument naming the size, what must hold and what was given
void validate(std::string_view whose, const Sizes& sizes);

/// By what the error of one step is divided, so that a tolerance is a plain number.
///
/// Nothing here has a unit of its own: a problem in other units, of other masses, or seen from a moving frame takes the
/// same steps. Both ends of the step count, the larger of them:
///
/// - velocities: by the largest |v|, of a problem that HasScales relative to the motion that its bodies share;
/// - places: by the spacing of the bodies, without that ability by the largest |r|;
/// - values: by the largest |y| of their Range, which has one unit.
///
/// A step that moves everything by less than 1e-8 of that length is as good as none, and its velocities are compared
/// with 1e-8 of it over the step: rounding of forces that cancel at rest is no motion. Sizes that the caller gives rule
/// instead, of numbers that are larger themselves those.
///
/// Nothing is remembered from one step to the next: what was large once does not loosen what is small now.
class ErrorScales {
 public:
  /// Nothing is compared with less: below it numbers lose digits.
  static constexpr double smallest = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();

  /// A step that moves everything by less than this share of its size is as good as none.
  static constexpr double at_rest = 1e-8;

  ErrorScales() = default;
  /// @param given  valid
  explicit ErrorScales(Sizes given) : given_(std::move(given)) {}

  /// @param unknowns  numbers in (r, y)
  /// @throws std::invalid_argument if sizes were given for another number
  void check(Eigen::Index unknowns) const;

  /// Takes the sizes of a step.
  ///
  /// @param problem  says what it has, and its scales
  /// @param from     the start
  /// @param dt       the step, > 0 [s]
  /// @param to       the end
  /// @throws std::invalid_argument if sizes were given for another number of unknowns
  void look(const Problem& problem, const State& from, double dt, const State& to);

  /// @param x  errors of places [m] @return the largest, of its size [-]
  double of_places(const Eigen::VectorXd& x) const;
  /// @param x  errors of velocities [m/s] @return the largest, of its size [-]
  double of_speeds(const Eigen::VectorXd& x) const;
  /// Errors of accelerations, as they move velocities and, over a step, places.
  ///
  /// @param a   errors of accelerations [m/s^2]
  /// @param dt  the step [s]
  /// @return the larger of the two; times dt it is an error of the step [1/s]
  double of_accelerations(const Eigen::VectorXd& a, double dt) const;
  /// @param x  errors of values @return the largest, of its size [-]
  double of_values(const Eigen::VectorXd& x) const;
  /// The error of a step.
  ///
  /// @param error  of each part of the state; its time is ignored, y too where values have no rates
  /// @return the largest of the above [-]
  double relative(const State& error) const;

  /// @return sizes of the unknowns of a stage, one for each number in (r, y), > 0: of Newton's changes and increments
  Eigen::VectorXd unknowns() const;
  /// @return size of velocities, > 0 [m/s]
  double speed() const { return speed_; }

 private:
  void look_at_motion(const Problem& problem, const State& from, double dt, const State& to);
  void look_at_values(const Problem& problem, const State& from, const State& to);

  Sizes given_;
  Eigen::Index n_ = 0;
  double length_ = 0.0, speed_ = 0.0;
  bool values_ = false;
  Eigen::VectorXd places_, of_y_;  // one a number; places_ only where the caller gave them
  Eigen::VectorXd shared_;         // scratch
};

}  // namespace particulate::schemes
