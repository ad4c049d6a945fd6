#include <harness/front.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/reference/integrator.hpp>
#include <particulate/report/table.hpp>

namespace verification {
namespace {

using Cost = std::function<double(const WorkPrecisionPoint&)>;

// Points of which no cheaper one has a smaller error, from the cheapest on.
std::vector<FrontPoint> envelope(const std::vector<WorkPrecisionPoint>& points, const std::string& problem,
                                 const std::string& method, const Cost& cost) {
  std::vector<FrontPoint> all, best;
  for (const WorkPrecisionPoint& point : points) {
    const bool solved = !point.status.starts_with("failed");
    if (point.problem == problem && point.method == method && solved)
      all.push_back({.error = point.errors->max, .cost = cost(point), .method = method});
  }
  std::sort(all.begin(), all.end(), [](const FrontPoint& a, const FrontPoint& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.error < b.error);
  });
  for (const FrontPoint& point : all) {
    if (best.empty() || point.error < best.back().error) best.push_back(point);
  }
  return best;
}

std::optional<FrontPoint> on(const std::vector<FrontPoint>& envelope, double error) {
  const auto there =
      std::find_if(envelope.begin(), envelope.end(), [=](const FrontPoint& p) { return p.error <= error; });
  if (there == envelope.end()) return std::nullopt;
  if (there == envelope.begin()) return *there;
  const FrontPoint& before = *(there - 1);
  const double part = std::log(before.error / error) / std::log(before.error / there->error);
  return FrontPoint{
      .error = error, .cost = before.cost * std::pow(there->cost / before.cost, part), .method = there->method};
}

struct Measure {
  const char* name;
  Cost cost;
};

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"evaluations", [](const WorkPrecisionPoint& p) { return static_cast<double>(p.counts.evaluations); }},
      {"seconds", [](const WorkPrecisionPoint& p) { return p.seconds_min.value_or(missing); }},
      {"overhead", [](const WorkPrecisionPoint& p) { return p.seconds_overhead.value_or(missing); }}};
  return all;
}

// A claim about a competitor is about the versions with which it was seen.
void claim(Rows& rows, const std::string& quantity, Bound bound) {
  const std::array version = particulate::reference::sundials_version();
  if (version < std::array{7, 2}) return rows.at_least(quantity, bound);
  bound.because = fmt::format("claimed of SUNDIALS before 7.2, this is {}.{}", version[0], version[1]);
  rows.leave_out(quantity, bound);
}

}  // namespace

std::optional<FrontPoint> front(const std::vector<WorkPrecisionPoint>& points, const std::string& problem,
                                const Party& party, double error, const Cost& cost) {
  std::optional<FrontPoint> best;
  for (const std::string& method : party.methods) {
    const std::optional<FrontPoint> point = on(envelope(points, problem, method, cost), error);
    if (point && !(best && best->cost <= point->cost)) best = point;
  }
  return best;
}

void compare_fronts(Rows& rows, const std::string& problem, const Party& sundials,
                    const std::vector<FrontClaim>& claims) {
  particulate::report::Table table(
      {"problem", "error", "measure", "party", "method", "cost", "SUNDIALS", "cost of SUNDIALS", "ratio"});
  for (const FrontClaim& of : claims) {
    if (of.at_least.size() != std::size(front_errors)) {
      throw std::invalid_argument(
          fmt::format("compare_fronts: a claim must have one ratio for each of {} errors, got {}",
                      std::size(front_errors), of.at_least.size()));
    }
    for (std::size_t i = 0; i < of.at_least.size(); ++i) {
      const double error = front_errors[i];
      for (const Measure& measure : measures()) {
        const std::optional<FrontPoint> own = front(rows.points(), problem, of.party, error, measure.cost);
        const std::optional<FrontPoint> other = front(rows.points(), problem, sundials, error, measure.cost);
        const double ratio = own && other ? other->cost / own->cost : missing;
        if (own && other) {
          table.add(
              {problem, error, measure.name, of.party.name, own->method, own->cost, other->method, other->cost, ratio});
        }
        if (measure.name != measures().front().name || of.at_least[i] == 0.0) continue;
        claim(rows,
              fmt::format("{}, {}: times as many evaluations of SUNDIALS at its best, at an error of {:.0e}", problem,
                          of.party.name, error),
              {.limit = of.at_least[i], .computed = ratio, .because = of.because});
      }
    }
  }
  rows.write("front_" + problem, table);
}

double cost_over(const std::vector<WorkPrecisionPoint>& points, const std::string& problem, const std::string& method,
                 const std::string& ruler, double error, const std::function<double(const WorkPrecisionPoint&)>& cost) {
  const auto by = front(points, problem, {method, {method}}, error, cost),
             over = front(points, problem, {ruler, {ruler}}, error, cost);
  return by && over ? by->cost / over->cost : missing;
}

}  // namespace verification
