#include <particulate/schemes/events.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

// Over the largest value so far. Rounding of what a function is made of is some of these.
constexpr double zero_tolerance = 1e-14;
// A function that an event has left at some value has left zero beyond so many times that.
constexpr double leave_factor = 10.0;
// Of the difference that gives a slope: its errors, of truncation and of rounding, are then both some 1e-11.
constexpr double difference_width = 1e-5;
// Over the largest value in the step: dense output that resolves a motion at all is nearer to it than this.
constexpr double doubt = 1e-4;
// Events so many roundings of the time apart happen together.
constexpr double tie_roundings = 100.0;

void require_one_each(std::size_t given, std::size_t n, const char* what) {
  if (given != 0 && given != n) {
    throw std::invalid_argument(
        fmt::format("events: {} must be given for each of {} functions or for none, got {}", what, n, given));
  }
}

// Places within the step for a difference about theta.
double inside(double theta, double end) {
  return std::clamp(theta, 0.5 * difference_width, end - 0.5 * difference_width);
}

}  // namespace

void validate(const Events& events) {
  const std::size_t n = events.directions.size();
  if ((n > 0) != static_cast<bool>(events.functions)) {
    throw std::invalid_argument(
        fmt::format("events: functions and a direction for each of them must be given together, got {} and {} "
                    "directions; leave both out for no events",
                    events.functions ? "functions" : "no functions", n));
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto number = static_cast<int>(events.directions[k]);
    if (number < -1 || number > 1) {
      throw std::invalid_argument(
          fmt::format("events: direction {} must be falling, either or rising, got number {}", k, number));
    }
  }
  require_one_each(events.names.size(), n, "a name");
  require_one_each(events.actions.size(), n, "an action");
}

std::string describe(const Events& events, const Hit& hit) {
  const std::string name = events.names.empty() ? fmt::format("event {}", hit.event) : events.names[hit.event];
  return name + (hit.crossing == Direction::falling  ? " falling"
                 : hit.crossing == Direction::rising ? " rising"
                                                     : " touching zero");
}

void validate(const WatchSettings& settings) {
  if (!(settings.graze >= 0.0 && settings.graze <= 1e-3)) {
    throw std::invalid_argument(fmt::format("watch: graze must lie in [0, 1e-3], got {}", settings.graze));
  }
  if (!(settings.most_at_once >= 1)) {
    throw std::invalid_argument(fmt::format("watch: most_at_once must be at least 1, got {}", settings.most_at_once));
  }
}

Watch::Watch(Events events, const WatchSettings& settings) : events_(std::move(events)), settings_(settings) {
  validate(events_);
  validate(settings_);
  const std::size_t n = events_.directions.size();
  side_.assign(n, 0);
  scale_.assign(n, 0.0);
  left_.assign(n, 0.0);
  residue_.assign(n, 0.0);
  found_.resize(n);
}

std::optional<double> Watch::first(const StepPath& path, State& there, double end) {
  const Evaluate evaluate_at = [&](double theta, double moved, Eigen::VectorXd& g) {
    path(theta + moved, there);
    // Along the velocity: the slope of dense positions is not as good as that, even at the end of a step.
    if (moved != 0.0 && there.r.size() > 0) {
      path(theta, beside_);
      there.r = beside_.r + moved * path.dt * beside_.v;
    }
    events_.functions(there, g);
    return there.t;
  };
  return first_of(evaluate_at, path.intervals, end);
}

std::vector<std::vector<Sample>> Watch::samples_of(const Evaluate& at, int intervals, double end) const {
  const std::size_t n = side_.size();
  Eigen::VectorXd g(static_cast<Eigen::Index>(n)), before = g, after = g;
  std::vector<std::vector<Sample>> samples(n);
  for (const double theta : chebyshev_points(intervals, end)) {
    const double t = at(theta, 0.0, g);
    const double middle = inside(theta, end);
    at(middle, -0.5 * difference_width, before);
    at(middle, 0.5 * difference_width, after);
    for (std::size_t k = 0; k < n; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      if (!std::isfinite(g[row])) {
        throw std::invalid_argument(
            fmt::format("events: function {} must be finite, got {} at t = {} s", k, g[row], t));
      }
      samples[k].push_back({.theta = theta, .value = g[row], .slope = (after[row] - before[row]) / difference_width});
    }
  }
  return samples;
}

// Brings the side on which a function stands up to date: a jump may have taken it across, an event has left it at zero.
ZeroRules Watch::rules_of(std::size_t k, const std::vector<Sample>& samples) {
  double largest = 0.0;
  for (const Sample& sample : samples) largest = std::max(largest, std::abs(sample.value));
  scale_[k] = std::max(scale_[k], largest);
  const ZeroRules rules{.direction = events_.directions[k],
                        .reach = zero_tolerance * scale_[k],
                        .leave = leave_factor * std::max(zero_tolerance * scale_[k], left_[k]),
                        .graze = settings_.graze * scale_[k],
                        .touches = true,
                        .doubt = doubt * largest};
  const double start = samples.front().value;
  if (std::abs(start) > rules.leave) side_[k] = start > 0.0 ? 1 : -1;
  if (!(side_[k] * start > rules.reach)) side_[k] = 0;
  return rules;
}

std::optional<double> Watch::first_of(const Evaluate& at, int intervals, double end) {
  if (side_.empty()) return {};
  const std::vector<std::vector<Sample>> samples = samples_of(at, intervals, end);
  Eigen::VectorXd g(static_cast<Eigen::Index>(side_.size())), h = g;
  std::optional<double> earliest;
  for (std::size_t k = 0; k < side_.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const Along one{.value =
                        [&](double theta) {
                          at(theta, 0.0, g);
                          return g[row];
                        },
                    .slope =
                        [&](double theta) {
                          const double middle = inside(theta, end);
                          at(middle, -0.5 * difference_width, g);
                          at(middle, 0.5 * difference_width, h);
                          return (h[row] - g[row]) / difference_width;
                        }};
    const ZeroRules rules = rules_of(k, samples[k]);
    int side = side_[k];
    found_[k] = first_crossing(samples[k], one, rules, side);
    if (!found_[k]) continue;
    residue_[k] = std::abs(one.value(1.0));
    if (!earliest || found_[k]->theta < *earliest) earliest = found_[k]->theta;
  }
  return earliest;
}

bool Watch::happen(double theta, double t, double dt) {
  const double tie = tie_roundings * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(t) / dt);
  bool stops = false;
  for (std::size_t k = 0; k < side_.size(); ++k) {
    if (!(found_[k] && found_[k]->theta <= theta + tie)) continue;
    hits_.push_back({.event = k, .crossing = found_[k]->way, .t = t});
    side_[k] = 0;
    left_[k] = residue_[k];
    stops = stops || events_.actions.empty() || events_.actions[k] == Action::stop;
  }
  return stops;
}

std::string Watch::last() const {
  std::string all;
  for (const Hit& hit : hits_) {
    if (hit.t == hits_.back().t) all += (all.empty() ? "" : ", ") + describe(events_, hit);
  }
  return all;
}

}  // namespace particulate::schemes
