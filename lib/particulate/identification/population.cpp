#include <particulate/identification/population.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/scenes/checkpoint.hpp>

namespace particulate::identification {

namespace {

// A text as numbers, one a byte: reasons are whatever a cost says.
std::vector<double> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

std::string text_from(const std::vector<double>& bytes) {
  std::string text;
  for (const double byte : bytes) text += static_cast<char>(byte);
  return text;
}

}  // namespace

Best best_of(const Population& population) {
  Best best{.parameters = population.aside, .cost = population.aside_cost};
  for (std::size_t k = 0; k < population.values.size(); ++k) {
    const double cost = population.values[k].cost;
    if (cost < best.cost || (std::isnan(best.cost) && !std::isnan(cost))) {
      best = {.parameters = population.strings.col(static_cast<Eigen::Index>(k)), .cost = cost};
    }
  }
  return best;
}

double mean_of_best(const Population& population, std::size_t n) {
  std::vector<double> costs;
  for (const Value& value : population.values) {
    if (value.reason.empty()) costs.push_back(value.cost);
  }
  std::sort(costs.begin(), costs.end());
  costs.resize(std::min(n, costs.size()));
  return std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
}

void rank(Population& population) {
  std::vector<std::size_t> order(population.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double one = population.values[a].cost, other = population.values[b].cost;
    if (one == other || (std::isnan(one) && std::isnan(other))) return a < b;
    return std::isnan(other) || one < other;
  });
  const Eigen::MatrixXd strings = population.strings;
  const std::vector<Value> values = population.values;
  for (std::size_t k = 0; k < order.size(); ++k) {
    population.strings.col(static_cast<Eigen::Index>(k)) = strings.col(static_cast<Eigen::Index>(order[k]));
    population.values[k] = values[order[k]];
  }
}

std::string to_bytes(const Population& population, std::string_view problem) {
  scenes::Checkpoint mark;
  mark.scene = problem;
  mark.engine = scenes::text_of(population.engine);
  const auto strings = population.strings.reshaped();
  mark.more["strings"] = {strings.begin(), strings.end()};
  mark.more["history"] = population.history;
  mark.more["aside"] = {population.aside.begin(), population.aside.end()};
  // Counts are whole numbers that a double holds.
  mark.more["numbers"] = {static_cast<double>(population.strings.cols()), static_cast<double>(population.generation),
                          static_cast<double>(population.evaluations), static_cast<double>(population.restarts),
                          population.aside_cost};
  std::vector<double>& reasons = mark.more["reasons"];
  std::map<std::string, double> number_of;  // from 1, of a reason
  for (const auto& [reason, count] : population.without_value) {
    reasons.push_back(static_cast<double>(count));
    number_of[reason] = static_cast<double>(reasons.size());
    mark.more[fmt::format("reason.{}", reasons.size())] = bytes_of(reason);
  }
  for (const Value& value : population.values) {
    mark.more["costs"].push_back(value.cost);
    mark.more["reason_of_each"].push_back(value.reason.empty() ? 0.0 : number_of.at(value.reason));
  }
  return scenes::to_bytes(mark);
}

Population population_from(std::string_view bytes, const std::string& origin, std::string_view problem) {
  const scenes::Checkpoint mark = scenes::checkpoint_from(bytes, origin, problem, 0);
  try {
    const std::vector<double>&strings = mark.more.at("strings"), &numbers = mark.more.at("numbers");
    const auto S = static_cast<Eigen::Index>(numbers.at(0)), all = static_cast<Eigen::Index>(strings.size());
    Population population{.strings = Eigen::Map<const Eigen::MatrixXd>(strings.data(), all / S, S),
                          .generation = static_cast<long>(numbers.at(1)),
                          .evaluations = static_cast<long>(numbers.at(2)),
                          .restarts = static_cast<long>(numbers.at(3)),
                          .history = mark.more.at("history"),
                          .aside_cost = numbers.at(4)};
    const std::vector<double>&aside = mark.more.at("aside"), &reasons = mark.more.at("reasons");
    population.aside = Eigen::Map<const Eigen::VectorXd>(aside.data(), static_cast<Eigen::Index>(aside.size()));
    const auto reason = [&](std::size_t n) { return text_from(mark.more.at(fmt::format("reason.{}", n))); };
    for (std::size_t n = 1; n <= reasons.size(); ++n) {
      population.without_value[reason(n)] = static_cast<long>(reasons[n - 1]);
    }
    // A first population that has not been evaluated has no costs.
    for (std::size_t k = 0; mark.more.contains("costs") && k < mark.more.at("costs").size(); ++k) {
      const auto n = static_cast<std::size_t>(mark.more.at("reason_of_each").at(k));
      population.values.push_back(n == 0 ? Value(mark.more.at("costs")[k]) : Value(reason(n)));
    }
    scenes::set_engine(mark.engine, population.engine);
    return population;
  } catch (const std::out_of_range&) {
    throw std::runtime_error(
        fmt::format("{}: must hold a population, and holds another checkpoint: name the file of a population", origin));
  }
}

}  // namespace particulate::identification
