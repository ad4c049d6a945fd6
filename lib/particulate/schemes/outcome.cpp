#include <particulate/schemes/outcome.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes {

std::string_view name(Status status) {
  switch (status) {
    case Status::reached:
      return "reached";
    case Status::stopped:
      return "stopped";
    case Status::failed:
      return "failed";
  }
  return "unknown";
}

std::string_view name(Failure failure) {
  switch (failure) {
    case Failure::none:
      return "none";
    case Failure::no_value:
      return "no value";
    case Failure::diverging:
      return "diverging";
    case Failure::slow:
      return "slow";
    case Failure::rounding:
      return "rounding";
    case Failure::time_stands_still:
      return "time stands still";
    case Failure::inaccurate:
      return "inaccurate";
    case Failure::unsettled_jump:
      return "unsettled jump";
    case Failure::not_located:
      return "not located";
    case Failure::accumulating:
      return "accumulating";
    case Failure::beyond_limit:
      return "beyond limit";
  }
  return "unknown";
}

Outcome& operator+=(Outcome& run, const Outcome& leg) {
  Outcome all = leg;
  if (run.steps > 0) {
    all.overlap_at_start = run.overlap_at_start;
    all.contacts_at_start = run.contacts_at_start;
  }
  all.steps += run.steps;
  all.rejections += run.rejections;
  all.sweeps += run.sweeps;
  all.evaluations += run.evaluations;
  all.impacts += run.impacts;
  all.energy_change = run.energy_change + leg.energy_change;
  all.heat = run.heat + leg.heat;
  all.released = run.released + leg.released;
  all.contraction = std::max(run.contraction, leg.contraction);
  all.overlap = std::max(run.overlap, leg.overlap);
  all.penetration = std::max(run.penetration, leg.penetration);
  all.travel = std::max(run.travel, leg.travel);
  if (all.jumps_by_law.size() < run.jumps_by_law.size()) all.jumps_by_law.resize(run.jumps_by_law.size());
  for (std::size_t k = 0; k < run.jumps_by_law.size(); ++k) {
    all.jumps_by_law[k].impacts += run.jumps_by_law[k].impacts;
    all.jumps_by_law[k].energy_change += run.jumps_by_law[k].energy_change;
  }
  if (all.ruled.empty()) all.ruled = run.ruled;
  return run = std::move(all);
}

namespace {

constexpr std::size_t columns = 100;

// Lines that break at blanks and go on two columns in.
std::string broken(std::string_view text, std::string line) {
  std::string lines;
  for (bool begins = true; !text.empty(); begins = false) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (!begins && line.size() + 1 + word.size() > columns) {
      lines += line + '\n';
      line = " ";
    }
    line += (begins ? "" : " ") + std::string(word);
  }
  return lines + line;
}

// Counts and measures, apart from those that are zero or unknown.
class Facts {
 public:
  void count(long n, std::string_view one, std::string_view many) {
    if (n != 0) add(fmt::format("{} {}", n, n == 1 ? one : many));
  }
  void measure(std::string_view what, double x, std::string_view unit) {
    if (x != 0.0 && !std::isnan(x)) add(fmt::format("{} {:.6g}{}", what, x, unit));
  }
  void add(const std::string& fact) { text_ += (text_.empty() ? "" : ", ") + fact; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

std::string describe(const Outcome& outcome) {
  const char* const when = outcome.status == Status::reached ? "" : "at ";
  std::string end = fmt::format("{} {}t = {} s", name(outcome.status), when, outcome.t);
  if (outcome.failure != Failure::none) end += fmt::format(" ({})", name(outcome.failure));
  if (!outcome.reason.empty()) end += fmt::format(": {}", outcome.reason);

  Facts facts;
  facts.count(outcome.steps, "step", "steps");
  facts.count(outcome.rejections, "rejected", "rejected");
  facts.count(outcome.sweeps, "sweep", "sweeps");
  facts.count(outcome.evaluations, "right-hand side", "right-hand sides");
  facts.count(outcome.impacts, "impact", "impacts");
  facts.measure("largest contraction", outcome.contraction, "");
  facts.count(outcome.contacts_at_start, "overlap at the start", "overlaps at the start");
  facts.measure("up to", outcome.overlap_at_start, " m deep");
  facts.measure("deepest overlap", outcome.overlap, " m");
  if (outcome.travel > 1.0) facts.measure("a body moved in a step by", outcome.travel, " of its radius");
  facts.measure("energy changed by jumps", outcome.energy_change, " J");
  facts.measure("heat from impacts", outcome.heat, " J");
  facts.measure("of it released", outcome.released, " J");
  facts.measure("a step that would have worked", outcome.workable_step, " s");
  facts.measure("accumulating at t =", outcome.accumulation, " s");
  if (!outcome.ruled.empty()) facts.add(fmt::format("steps cut by {}", outcome.ruled));
  if (outcome.penetration > 0.1) {
    end += fmt::format(
        "; spheres overlap by up to {:.3g} % of a diameter: take a smaller step; where a force draws them together as "
        "they touch, one that vanishes there, as a bond does",
        100.0 * outcome.penetration);
  }
  return broken(end, "") + (facts.text().empty() ? "" : "\n" + broken(facts.text(), "  "));
}

std::ostream& operator<<(std::ostream& out, const Outcome& outcome) { return out << describe(outcome); }

}  // namespace particulate::schemes
