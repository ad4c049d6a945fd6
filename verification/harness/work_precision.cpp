#include <harness/rows.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <particulate/report/progress.hpp>

namespace verification {
namespace {

constexpr double half_a_decade = 3.1622776601683795;
constexpr double floors_at_floor = 10.0;  // points nearer to the reference's error say nothing

// How often a run is timed after the first time, and for how long at least. A quick run shows that seconds can be
// measured and that counts repeat; a full one shows their spread.
struct Effort {
  int repeats;
  double shortest_batch;  // [s], far above the clock's resolution
};
constexpr Effort full_effort{.repeats = 5, .shortest_batch = 1e-3};
constexpr Effort quick_effort{.repeats = 1, .shortest_batch = 1e-4};

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Timing {
  bool repeats = true;                 // every run had the counts that were expected
  double minimum = 0.0, median = 0.0;  // [s] per run
};

// Runs once to see how long it takes, which warms up as well, then measures. A run that is over too soon for the clock
// is measured in batches.
Timing time_of(const std::function<Counts()>& run, const Counts& expected, const Effort& effort) {
  Timing timing;
  const auto once = [&] { timing.repeats = run() == expected && timing.repeats; };
  const double alone = seconds_of(once);
  const int batch = static_cast<int>(std::clamp(std::ceil(effort.shortest_batch / std::max(alone, 1e-9)), 1.0, 1e6));
  std::vector<double> seconds;
  if (batch == 1) seconds.push_back(alone);
  for (int repeat = 0; repeat < effort.repeats; ++repeat) {
    seconds.push_back(seconds_of([&] {
                        for (int i = 0; i < batch; ++i) once();
                      }) /
                      batch);
  }
  std::sort(seconds.begin(), seconds.end());
  timing.minimum = seconds.front();
  timing.median = seconds[seconds.size() / 2];
  return timing;
}

void require_complete(const Prepared& prepared, const std::string& method) {
  if (prepared.task.start.empty() || prepared.task.rate.empty() || prepared.task.outputs.empty()) {
    throw std::invalid_argument(
        fmt::format("work_precision: {} must tell its task: start, right-hand side there, output times", method));
  }
  if (prepared.run && prepared.errors && prepared.replay) return;
  throw std::invalid_argument(fmt::format(
      "work_precision: {} must give run, errors and replay, got an empty one. Three numbers are owed for every method: "
      "evaluations, seconds, and seconds without the right-hand side.",
      method));
}

std::string status_of(const WorkPrecisionPoint& point) {
  if (!point.counts.failure.empty()) return "failed: " + point.counts.failure;
  if (!std::isfinite(point.errors->end) || !std::isfinite(point.errors->max)) return "failed: its error is no number";
  const bool at_floor = std::min(point.errors->end, point.errors->max) <= floors_at_floor * point.floor;
  return at_floor ? "at floor" : "solved";
}

WorkPrecisionPoint measured(const WorkPrecision& what, const Competitor& who, double setting, const Prepared& prepared,
                            const Effort& effort) {
  WorkPrecisionPoint point{.problem = what.problem,
                           .method = who.name,
                           .setting = setting,
                           .tuned = who.tuned,
                           .errors = {},
                           .floor = what.floor,
                           .reference = what.reference,
                           .seconds_min = {},
                           .seconds_median = {},
                           .seconds_overhead = {},
                           .counts = prepared.run(),
                           .status = {},
                           .timed = what.timed};
  if (point.counts.failure.empty()) { point.errors = prepared.errors(); }
  if (point.counts.failure.empty() && what.timed) {
    const Timing run = time_of(prepared.run, point.counts, effort);
    const Timing replay = time_of(prepared.replay, point.counts, effort);
    point.repeats = run.repeats && replay.repeats;
    point.seconds_min = run.minimum, point.seconds_median = run.median, point.seconds_overhead = replay.minimum;
  } else {
    point.repeats = (point.errors ? prepared.replay() : prepared.run()) == point.counts;
  }
  point.status = status_of(point);
  return point;
}

bool is_fine_enough(const std::vector<double>& settings) {
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const double ratio = i == 0 ? 1.0 : settings[i - 1] / settings[i];
    if (!(settings[i] > 0.0 && ratio >= 1.0 && ratio <= half_a_decade * (1.0 + 1e-9))) return false;
  }
  return true;
}

// The points that may carry a slope: see the rule for orders of accuracy.
struct Slope {
  std::vector<double> steps, errors;
};
Slope slope_points(const std::vector<WorkPrecisionPoint>& points) {
  Slope slope;
  for (const WorkPrecisionPoint& point : points) {
    if (point.status.starts_with("failed") || !(point.errors->end >= 1e3 * point.floor && point.errors->end <= 1e-2))
      continue;
    slope.steps.push_back(1.0 / static_cast<double>(point.counts.evaluations));
    slope.errors.push_back(point.errors->end);
  }
  return slope;
}

// What breaks one of the rules of a measurement, by name.
struct Offenders {
  std::vector<std::string> other_task, coarse, changing, without_error, hopeless;
};

void collect(const Competitor& who, const std::vector<WorkPrecisionPoint>& points, Offenders& offenders) {
  bool solved = false;
  for (const WorkPrecisionPoint& point : points) {
    const std::string run = fmt::format("{} at {}", who.name, point.setting);
    const bool failed = point.status.starts_with("failed");
    if (!point.repeats) offenders.changing.push_back(run);
    if (failed && point.counts.failure.empty()) offenders.without_error.push_back(run);
    solved = solved || !failed;
  }
  if (!solved) offenders.hopeless.push_back(who.name);
  if (!is_fine_enough(who.settings)) offenders.coarse.push_back(who.name);
}

// One row: what a measurement owes before it says anything about methods is no result of theirs.
void judge(Rows& rows, const WorkPrecision& what, const Offenders& offenders) {
  std::vector<std::string> faults;
  const auto none = [&](const char* fault, const std::vector<std::string>& who) {
    if (!who.empty()) faults.push_back(fmt::format("{}: {}", fault, fmt::join(who, ", ")));
  };
  none("runs with another start, right-hand side or output times than the first", offenders.other_task);
  none("methods whose settings rise or are more than half a decade apart", offenders.coarse);
  none("runs that do other work when they are repeated", offenders.changing);
  none("runs that claim an answer whose error is no number", offenders.without_error);
  none("methods that give no answer at any setting", offenders.hopeless);
  const bool has_scale = std::any_of(what.competitors.begin(), what.competitors.end(),
                                     [](const Competitor& who) { return who.slope.has_value(); });
  if (!has_scale && what.no_ruler.empty()) faults.emplace_back("no method of fixed step and known order");
  rows.equal(what.problem + ": what is wrong with the measurement itself",
             {.expected = "nothing",
              .computed = faults.empty() ? std::string("nothing") : fmt::format("{}", fmt::join(faults, "; ")),
              .because = "methods can be compared that do the same task, at settings without gaps, with the same work "
                         "whenever they are run, and with errors that can be measured, beside one whose order is " +
                         (what.no_ruler.empty() ? "known" : "known; none here: " + what.no_ruler)});
}

void judge_slope(Rows& rows, const WorkPrecision& what, const Competitor& who,
                 const std::vector<WorkPrecisionPoint>& points) {
  const Slope slope = slope_points(points);
  const std::string quantity =
      fmt::format("{}, {}: order fitted to the errors at the end, against evaluations", what.problem, who.name);
  Convergence convergence{.nominal = *who.slope,
                          .steps = slope.steps,
                          .errors = slope.errors,
                          .floor = what.floor,
                          .because =
                              "at fixed steps the error falls with the method's order; fitted where it is below 1e-2 "
                              "and more than 1000 times that of the reference"};
  if (who.steeper.empty()) {
    rows.order(quantity, convergence);
  } else {
    convergence.because += "; from below, because " + who.steeper;
    rows.order_at_least(quantity, convergence);
  }
}

}  // namespace

void Rows::work_precision(const WorkPrecision& measurement) {
  const auto& [problem, reference, floor, competitors, timed, no_ruler] = measurement;
  std::size_t total = 0, done = 0;
  for (const Competitor& who : competitors) total += who.settings.size();
  if (!(floor > 0.0) || total == 0) {
    throw std::invalid_argument(
        fmt::format("work_precision {}: the floor must be positive and there must be settings, got {} and {}", problem,
                    floor, total));
  }
  const Effort& effort = quick() ? quick_effort : full_effort;
  particulate::report::Progress progress(problem, static_cast<double>(total));
  std::optional<Task> task;
  Offenders offenders;
  for (const Competitor& who : competitors) {
    std::vector<WorkPrecisionPoint> points;
    for (const double setting : who.settings) {
      progress.label(fmt::format("{}, {}", problem, who.name));
      progress.at(static_cast<double>(done++));
      const Prepared prepared = who.prepare(setting);
      require_complete(prepared, who.name);
      if (!task) task = prepared.task;
      if (prepared.task != *task) offenders.other_task.push_back(fmt::format("{} at {}", who.name, setting));
      points.push_back(measured(measurement, who, setting, prepared, effort));
    }
    collect(who, points, offenders);
    if (who.slope) judge_slope(*this, measurement, who, points);
    points_.insert(points_.end(), points.begin(), points.end());
  }
  judge(*this, measurement, offenders);
}

}  // namespace verification
