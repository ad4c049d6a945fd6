#include <particulate/schemes/events.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

// Of the difference that gives a slope: its errors, of truncation and of rounding, are then both some 1e-11.
constexpr double difference_width = 1e-5;
// Over the largest value in the step: dense output that resolves a motion at all is nearer to it than this.
constexpr double doubt = 1e-4;
// What is so near to the start of a step, in parts of it, is there.
constexpr double at_start = 1e-14;
// A slope so small at the start of a step, over the slope a little later, is that of a turn.
constexpr double soon = 0.1, at_turn = 1e-2;
// So many roundings of the state are no change of it.
constexpr double roundings = 16.0 * std::numeric_limits<double>::epsilon();

int sign(double x) { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; }

bool same(const State& a, const State& b) {
  const auto equal = [](const Eigen::VectorXd& x, const Eigen::VectorXd& y) { return x.size() == y.size() && x == y; };
  return equal(a.r, b.r) && equal(a.v, b.v) && equal(a.y, b.y);
}

std::string name_of(const Events& events, std::size_t k) {
  return events[k].name.empty() ? fmt::format("event {}", k) : events[k].name;
}

// Where a path goes from a place, along the velocity there: the slope of dense positions is not as good as that, even
// at the end of a step.
void move_along(const StepPath& path, double theta, const State& there, double by, State& beside) {
  path(theta + by, beside);
  if (there.r.size() > 0) beside.r = there.r + (by * path.dt) * there.v;
}

}  // namespace

void validate(const Events& events) {
  for (std::size_t k = 0; k < events.size(); ++k) {
    if (!events[k].function)
      throw std::invalid_argument(fmt::format("events: {} needs a function", name_of(events, k)));
    const auto number = static_cast<int>(events[k].direction);
    if (number < -1 || number > 1) {
      throw std::invalid_argument(fmt::format(
          "events: the direction of {} must be falling, either or rising, got number {}", name_of(events, k), number));
    }
  }
}

std::string describe(const Events& events, const Hit& hit) {
  return name_of(events, hit.event) + (hit.crossing == Direction::falling  ? " falling"
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
  left_.resize(events_.size());
  begun_.resize(events_.size());
  found_.resize(events_.size());
}

double Watch::value(std::size_t k, const State& at) const {
  const double g = events_[k].function(at);
  if (std::isfinite(g)) return g;
  throw std::invalid_argument(
      fmt::format("events: the function of {} must be finite, got {} at t = {} s", name_of(events_, k), g, at.t));
}

double Watch::slope(std::size_t k, const StepPath& path, double theta, double end) {
  const double middle = std::clamp(theta, 0.5 * difference_width, end - 0.5 * difference_width);
  path(middle, there_);
  move_along(path, middle, there_, -0.5 * difference_width, beside_);
  const double before = value(k, beside_);
  move_along(path, middle, there_, 0.5 * difference_width, beside_);
  return (value(k, beside_) - before) / difference_width;
}

void Watch::start(const StepPath& path) {
  path(0.0, there_);
  const bool changed = !same(there_, last_);
  for (std::size_t k = 0; k < events_.size(); ++k) begun_[k] = {.value = value(k, there_)};
  beside_.t = there_.t * (1.0 + roundings);
  beside_.r = there_.r * (1.0 + roundings);
  beside_.v = there_.v * (1.0 + roundings);
  beside_.y = there_.y * (1.0 + roundings);
  for (std::size_t k = 0; k < events_.size(); ++k) begun_[k].rounding = std::abs(value(k, beside_) - begun_[k].value);
  move_along(path, 0.0, there_, difference_width, beside_);
  for (std::size_t k = 0; k < events_.size(); ++k) begun_[k] = begin(k, changed, value(k, beside_) - begun_[k].value);
  for (std::size_t k = 0; k < events_.size(); ++k) {
    Beginning& begun = begun_[k];
    if (left_[k].side != 0 || std::abs(begun.value) > begun.rounding) continue;
    const double here = slope(k, path, 0.0, 1.0), later = slope(k, path, soon, 1.0);
    // It turns where the step starts: rounding may show it on either side of zero.
    if (std::abs(here) <= at_turn * std::abs(later)) begun.side = begun.from = 0;
  }
}

// Tells whether a function is at zero, and whether it leaves that or goes back to where it came from.
Watch::Beginning Watch::begin(std::size_t k, bool changed, double moves) const {
  Beginning begun = begun_[k];
  const Left& left = left_[k];
  const double size = std::abs(begun.value),
               band = std::max(begun.rounding, at_start / difference_width * std::abs(moves));
  begun.from = std::abs(moves) > begun.rounding ? sign(moves) : 0;
  bool at_zero = size == 0.0;
  if (left.side == 0) {
    at_zero = at_zero || (fresh_ && size <= band);
  } else if (left.back) {
    at_zero = at_zero || size <= left.band;
    begun.from = left.side;
    begun.changed = left.changed;
  } else if (changed) {
    at_zero = at_zero || size <= std::max(left.band, band);
    begun.changed = at_zero;
    if (begun.from == 0) begun.from = left.side;
  } else {
    // Short of zero, by rounding, where a run has ended.
    at_zero = at_zero || (left.side * begun.value > 0.0 && size <= left.band);
    begun.from = 0;
  }
  begun.side = at_zero ? 0 : sign(begun.value);
  return begun;
}

std::vector<std::vector<Sample>> Watch::samples_of(const StepPath& path, double end) {
  std::vector<std::vector<Sample>> samples(events_.size());
  std::vector<double> places = chebyshev_points(path.intervals, 1.0);
  if (end > 1.0) places.push_back(end);
  for (const double theta : places) {
    const double by = theta < 0.5 ? difference_width : -difference_width;
    path(theta, there_);
    move_along(path, theta, there_, by, beside_);
    for (std::size_t k = 0; k < events_.size(); ++k) {
      const double g = value(k, there_);
      samples[k].push_back({.theta = theta, .value = g, .slope = (value(k, beside_) - g) / by});
    }
  }
  return samples;
}

ZeroRules Watch::rules_of(std::size_t k, const std::vector<Sample>& samples, bool last) const {
  const Beginning& begun = begun_[k];
  double largest = 0.0;
  for (const Sample& sample : samples) largest = std::max(largest, std::abs(sample.value));
  ZeroRules rules{.direction = events_[k].direction,
                  .reach = last ? std::max(begun.rounding, at_start * std::abs(samples.back().slope)) : 0.0,
                  .graze = std::max(settings_.graze * largest, begun.rounding),
                  .touches = true,
                  .doubt = doubt * largest};
  if (begun.from == 0) {
    rules.leave = std::abs(begun.value);
  } else {
    rules.floor = -begun.from * std::max(std::abs(begun.value), left_[k].band);
  }
  return rules;
}

std::optional<Stop> Watch::first(const StepPath& path, double end, bool last) {
  std::optional<Stop> earliest;
  if (events_.empty()) return earliest;
  const std::vector<std::vector<Sample>> samples = samples_of(path, end);
  for (std::size_t k = 0; k < events_.size(); ++k) {
    const Along along{
        .value =
            [&](double theta) {
              path(theta, there_);
              return value(k, there_);
            },
        .slope = [&](double theta) { return slope(k, path, theta, std::max(end, theta + difference_width)); }};
    int side = begun_[k].side;
    const ZeroRules rules = rules_of(k, samples[k], last);
    begun_[k].graze = rules.graze;
    begun_[k].farthest = 0.0;
    for (const Sample& sample : samples[k]) {
      begun_[k].farthest = std::max(begun_[k].farthest, begun_[k].from * sample.value);
    }
    found_[k] = first_crossing(samples[k], along, rules, side);
    const std::optional<Crossing>& found = found_[k];
    if (!found || (earliest && earliest->theta <= found->theta)) continue;
    const double at_end = found->from * samples[k][static_cast<std::size_t>(path.intervals)].value;
    const bool touches = found->way == Direction::either;
    earliest = {.theta = found->theta,
                .reached = touches || found->theta == 1.0 || (found->theta < 1.0 && at_end <= 0.0),
                .sharp = !touches};
  }
  return earliest;
}

std::size_t Watch::happen(const State& to, const std::optional<Stop>& stop) {
  fresh_ = stands_ = false;
  const std::size_t before = hits_.size();
  for (std::size_t k = 0; k < events_.size(); ++k) {
    const Beginning& begun = begun_[k];
    const bool touched = found_[k] && found_[k]->way == Direction::either;
    if (stop && found_[k] && found_[k]->counts && found_[k]->theta <= (touched ? std::max(1.0, stop->theta) : 1.0)) {
      stands_ = stands_ || (begun.changed && begun.farthest <= begun.rounding);
      hits_.push_back({.event = k, .crossing = found_[k]->way, .t = to.t});
      const double size = std::abs(value(k, to));
      left_[k] = {.side = found_[k]->from, .band = touched ? std::max(size, begun.graze) : size, .back = touched};
    } else if (begun.side == 0 && begun.from != 0 && std::abs(value(k, to)) <= left_[k].band) {
      left_[k] = {.side = begun.from, .band = left_[k].band, .back = true, .changed = begun.changed};
    } else {
      left_[k] = {};
    }
  }
  if (hits_.size() > before) last_ = to;
  return hits_.size() - before;
}

std::vector<Jump> Watch::change(std::size_t many, State& at) const {
  std::vector<Jump> jumps;
  for (std::size_t h = hits_.size() - many; h < hits_.size(); ++h) {
    const std::size_t k = hits_[h].event;
    if (!events_[k].change) continue;
    const State before{.t = at.t, .r = at.r, .v = at.v, .y = at.y, .t_carry = at.t_carry};
    jumps.push_back(events_[k].change(at));
    if (at.t != before.t || at.t_carry != before.t_carry || at.r.size() != before.r.size() ||
        at.v.size() != before.v.size() || at.y.size() != before.y.size() || !is_finite(at)) {
      throw std::invalid_argument(fmt::format(
          "events: the change of {} must leave the time and the number of places, velocities and values, all finite, "
          "but left {}, {} and {} of them, {}, at t = {} s, before {}, {} and {} at t = {} s",
          name_of(events_, k), at.r.size(), at.v.size(), at.y.size(), is_finite(at) ? "all finite" : "not all finite",
          at.t, before.r.size(), before.v.size(), before.y.size(), before.t));
    }
  }
  return jumps;
}

bool Watch::stops(std::size_t many) const {
  return std::any_of(hits_.end() - static_cast<std::ptrdiff_t>(many), hits_.end(),
                     [&](const Hit& hit) { return events_[hit.event].action == Action::stop; });
}

std::string Watch::last() const {
  std::string all;
  for (const Hit& hit : hits_) {
    if (hit.t == hits_.back().t) all += (all.empty() ? "" : ", ") + describe(events_, hit);
  }
  return all;
}

}  // namespace particulate::schemes
