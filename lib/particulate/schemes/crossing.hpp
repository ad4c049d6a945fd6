#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

/// @file
/// Where a function along a step first passes zero. The step is measured by theta, 0 at its start and 1 at its end.

namespace particulate::schemes {

/// Which way a function must pass zero.
enum class Direction {
  falling = -1,  ///< from positive to negative
  either = 0,    ///< both ways
  rising = 1     ///< from negative to positive
};

/// A function at one place of a step.
struct Sample {
  double theta = 0.0;  ///< the place [-]
  double value = 0.0;  ///< the function, in its own unit
  double slope = 0.0;  ///< its derivative by theta, in its own unit
};

/// A function along a step, to be asked between its samples.
struct Along {
  std::function<double(double theta)> value;  ///< the function
  std::function<double(double theta)> slope;  ///< its derivative by theta
};

/// What counts as zero, and as having left it. All lengths in the unit of the function.
struct ZeroRules {
  Direction direction = Direction::either;  ///< which passages count
  double reach = 0.0;                       ///< a function whose last sample is so near to zero has reached it, >= 0
  double leave = 0.0;                       ///< one that was zero has left it beyond this, >= 0
  double graze = 0.0;                       ///< an extreme value so near to zero touches it, >= 0
  bool touches = false;                     ///< whether a touch counts, in the direction in which the function came
  double doubt = 0.0;  ///< how far dense output may be off in the middle of the step, >= 0: an extreme value that stops
                       ///< short of zero by no more than 4 theta |1 - theta| of it, beyond theta = 1e-4, is given as a
                       ///< touch; not where it is within 1e-6 of the end
  double floor = -std::numeric_limits<double>::infinity();  ///< one that has not left zero passes it by going beyond
                                                            ///< this, down where it is negative (or -0), up where it is
                                                            ///< positive, and leaves zero to the other side alone;
                                                            ///< infinite: it passes nothing, and leaves to either
};

/// Where a function passes zero.
struct Crossing {
  double theta = 0.0;                  ///< the place; never 0 [-]
  Direction way = Direction::falling;  ///< falling, rising, or either: it touches zero and turns back
  int from = 0;                        ///< the side on which it was before, +1 or -1
  bool counts = true;                  ///< false: it passes the other way, and comes back within the step
};

/// Places of a step that lie densest at its ends.
///
/// \f[ \theta_k = \tfrac12 \theta_{end} \left(1 - \cos\frac{\pi k}{n}\right), \quad k = 0, \dots, n \f]
///
/// A polynomial of degree d < n is nowhere larger than \f$ 1/\cos(\pi d/(2n)) \f$ times its largest value there: with n
/// = 2 d, \f$ \sqrt2 \f$ times. Source: @cite ehlich1964.
///
/// @param intervals  n, >= 1 [-]
/// @param end        the last place, > 0 [-]
/// @return n + 1 places, the first 0 and the last `end`, both exactly
std::vector<double> chebyshev_points(int intervals, double end);

/// A root between two places where a function has different signs, to two roundings of 1. Where the function is zero
/// over a stretch it is the near end of that, where it jumps across zero the place of the jump.
///
/// The method ITP: regula falsi, drawn towards the middle of the bracket by so much that it never takes more than one
/// evaluation above what bisection takes. Source: @cite oliveira2021.
///
/// @param f  the function
/// @param a  one place, a < b
/// @param fa f(a), not zero
/// @param b  the other
/// @param fb f(b), of the other sign or zero
/// @return the far end b of the last bracket, at most \f$ 2^{-52} \f$ wide: beyond the root by no more than that, and
///         never a
double bracketed_root(const std::function<double(double)>& f, double a, double fa, double b, double fb);

/// The first passage of a function through zero that counts. Where one that does not count comes before it, that is
/// given: dense output alone does not tell whether there are two of them or none.
///
/// From one sample to the next a change of sign shows a root. Where the slope changes its sign in between, and the
/// function either heads for zero or has not left it, the turning point is found as the root of the slope, and what
/// lies before and after it is looked at apart: so two roots between two samples are seen, and one that is double. A
/// function that has two turning points or more between two samples may pass zero twice unseen.
///
/// A function that turns back so close to zero that dense output cannot tell whether it reaches it is given there, as
/// touching; once the step has been solved anew to end there its value is the scheme's own, and clear.
///
/// A function counts only once it has left zero: one that starts there passes nothing by leaving. Which side it starts
/// on is the caller's to say.
///
/// @param samples  at least two, by theta, of finite numbers
/// @param f        the same function between them
/// @param rules    what counts
/// @param side     +1: it was positive at the start, -1: negative, 0: at zero and has not left it yet; brought up to
///                 date as far as passages do not count
/// @return the passage, none if there is none that counts
std::optional<Crossing> first_crossing(const std::vector<Sample>& samples, const Along& f, const ZeroRules& rules,
                                       int& side);

}  // namespace particulate::schemes
