#include <particulate/schemes/integrate.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

void validate_times(double t, double t_end) {
  if (!std::isfinite(t)) throw std::invalid_argument(fmt::format("run: the start time must be finite, got {} s", t));
  if (!(t_end >= t && std::isfinite(t_end))) {
    throw std::invalid_argument(
        fmt::format("run: the end time must be finite and not before the start at {} s, got {} s", t, t_end));
  }
}

void validate_finite(const Eigen::VectorXd& x, const char* what) {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (!std::isfinite(x[k])) {
      throw std::invalid_argument(fmt::format("run: {} must start finite, got {} in entry {}", what, x[k], k));
    }
  }
}

}  // namespace

void validate_run(const Motion& state, double t_end) {
  validate_times(state.t, t_end);
  if (state.r.size() != state.v.size()) {
    throw std::invalid_argument(fmt::format("run: positions and velocities must have one length, got {} and {}",
                                            state.r.size(), state.v.size()));
  }
  validate_finite(state.r, "positions");
  validate_finite(state.v, "velocities");
}

void validate_run(const Values& state, double t_end) {
  validate_times(state.t, t_end);
  validate_finite(state.y, "values");
}

bool is_finite(const Motion& state) { return std::isfinite(state.t) && state.r.allFinite() && state.v.allFinite(); }

bool is_finite(const Values& state) { return std::isfinite(state.t) && state.y.allFinite(); }

std::string too_small(double t, double dt, const std::string& refusal) {
  if (!refusal.empty()) {
    return fmt::format(
        "at t = {} s no step is small enough, down to Dt = {:.3g} s that changes the time no more; the "
        "last one refused: {}",
        t, dt, refusal);
  }
  return fmt::format(
      "the step must change the time, but t + Dt = t with t = {} s and Dt = {} s: choose a larger step, or count time "
      "from nearer the start",
      t, dt);
}

std::string not_located(double t, double dt, double off) {
  return fmt::format(
      "from t = {} s on a jump or an event was seen in the step, but no shorter step ends there: solved anew, a step "
      "of "
      "{:.3g} s still moves by {:.3g} of itself; take smaller steps, or a smaller tolerance of the sweeps",
      t, dt, off);
}

std::string accumulating(double t, long most) {
  return fmt::format(
      "{} jumps or events in a row passed no time: they accumulate at t = {} s, and no step gets beyond it; end the "
      "run "
      "before, or change the state there",
      most, t);
}

}  // namespace particulate::schemes
