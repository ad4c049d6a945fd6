#include <particulate/contact/impulse_windows.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::contact {

namespace {

// More windows are a mistake of units, and take some hundred megabytes.
constexpr double most_windows = 1e7;

}  // namespace

ImpulseWindows::ImpulseWindows(Eigen::Index body, double length) : body_(body), length_(length) {
  if (!(length > 0.0 && std::isfinite(length))) {
    throw std::invalid_argument(
        fmt::format("impulse windows: their length must be positive and finite, got {} s", length));
  }
}

void ImpulseWindows::until(double t) {
  if (!(t >= t_ && t <= most_windows * length_)) {
    throw std::invalid_argument(fmt::format(
        "impulse windows: times must follow one another from 0 on, up to {} windows of {} s, got {} s after {} s",
        most_windows, length_, t, t_));
  }
  t_ = t;
  // A step that ends where a window does, to the rounding of a sum of steps, belongs to that window.
  const double before = std::ceil(t / length_ * (1.0 - 1e-9));
  windows_.resize(static_cast<std::size_t>(std::max(before, 1.0)));
}

void ImpulseWindows::operator()(const ImpactRecord& impact) {
  if (impact.i != body_ && impact.j != body_) return;
  WindowImpulse& now = windows_.back();
  now.normal += impact.push;
  now.tangential += impact.tangential.norm();
  now.largest = std::max(now.largest, impact.push);
}

WindowImpulse ImpulseWindows::whole() const {
  WindowImpulse all;
  for (const WindowImpulse& each : windows_) {
    all.normal += each.normal;
    all.tangential += each.tangential;
    all.largest = std::max(all.largest, each.largest);
  }
  return all;
}

double ImpulseWindows::largest_force() const {
  double largest = 0.0;
  for (const WindowImpulse& each : windows_) largest = std::max(largest, each.normal / length_);
  return largest;
}

}  // namespace particulate::contact
