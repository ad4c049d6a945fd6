#pragma once

#include <vector>

#include <particulate/contact/resolution.hpp>

namespace particulate::contact {

/// What a body is hit with in one window of time.
struct WindowImpulse {
  double normal = 0.0;      ///< sum of the normal impulses [N s]
  double tangential = 0.0;  ///< sum of the sizes of those of friction [N s]
  double largest = 0.0;     ///< largest normal impulse of one impact [N s]
};

/// The impulses on one body, gathered over windows of time of a fixed length.
///
/// \f[ \bar F_k = \frac1\tau \sum_{k \tau < t \le (k+1) \tau} J \f]
///
/// @equation{R 7.5.3} A force J/(gamma Dt) of one impact would depend on the step; a mean over a fixed window does not.
/// It listens to a contact, and is told the time by whoever observes the run, as an impact knows none:
///
///     ImpulseWindows on_wall(0, 0.02);
///     contact.recorder = std::ref(on_wall);
///     ... integrate(..., [&](const auto&, const schemes::State& to, double, const auto&) { on_wall.until(to.t); ...
///     });
///
/// Observers see a step before its jump, so what comes after until() belongs to the window in which that step ends.
class ImpulseWindows {
 public:
  /// @param body    the particle; -1: the walls, all of them
  /// @param length  tau, > 0 and finite [s]
  /// @throws std::invalid_argument for a length that cannot be meant
  ImpulseWindows(Eigen::Index body, double length);

  /// Tells it where the run is.
  ///
  /// @param t  time, >= 0; not before the one it was told last [s]
  /// @throws std::invalid_argument for a time that cannot be meant
  void until(double t);
  /// @param impact  at that time, of any bodies
  void operator()(const ImpactRecord& impact);

  /// @return the windows so far, the last one as far as the run has come
  const std::vector<WindowImpulse>& windows() const { return windows_; }
  /// @return tau [s]
  double length() const { return length_; }
  /// @return the sum of all normal impulses, and of those of friction, and the largest normal impulse of one impact
  WindowImpulse whole() const;
  /// @return the largest mean normal force of a window [N]
  double largest_force() const;

 private:
  Eigen::Index body_;
  double length_;
  double t_ = 0.0;
  std::vector<WindowImpulse> windows_ = {{}};
};

}  // namespace particulate::contact
