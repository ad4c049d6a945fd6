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

void judge(Rows& rows, const std::string& problem, const Offenders& offenders) {
  const auto none = [&](const char* what, const std::vector<std::string>& names, const char* because) {
    rows.equal(fmt::format("{}: {}", problem, what),
               {.expected = "none",
                .computed = names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, ", ")),
                .because = because});
  };
  none("runs with another right-hand side, start or output times", offenders.other_task,
       "only the same task can be compared");
  none("methods whose settings rise or are more than half a decade apart", offenders.coarse,
       "a coarser sweep hides where a curve bends");
  none("runs whose counts change between repeats or in the replay", offenders.changing,
       "the same run does the same work, bit for bit");
  none("answers without a finite error", offenders.without_error, "what claims to be solved can be measured");
  none("methods that solve nothing", offenders.hopeless, "they are no competitors");
}

void judge_slope(Rows& rows, const WorkPrecision& what, const Competitor& who,
                 const std::vector<WorkPrecisionPoint>& points) {
  const Slope slope = slope_points(points);
  const std::string quantity =
      fmt::format("{}, {}: slope of the error at the end against evaluations", what.problem, who.name);
  Convergence convergence{.nominal = *who.slope,
                          .steps = slope.steps,
                          .errors = slope.errors,
                          .floor = what.floor,
                          .because = "fixed steps: the method's order, over the points between 1000 floors and 1e-2"};
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
  std::size_t total = 0, done = 0, rulers = 0;
  for (const Competitor& who : competitors) total += who.settings.size(), rulers += who.slope ? 1 : 0;
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
  judge(*this, problem, offenders);
  at_least(problem + ": rulers, fixed steps of known slope",
           {.limit = no_ruler.empty() ? 1.0 : 0.0,
            .computed = static_cast<double>(rulers),
            .because = no_ruler.empty() ? "a diagram without a ruler has no scale" : "none is asked for: " + no_ruler});
}

}  // namespace verification
