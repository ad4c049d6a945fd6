#include <particulate/report/checks.hpp>

#include <cmath>

#include <fmt/format.h>

#include <particulate/report/wrapped.hpp>

namespace particulate::report {

void Checks::add(const std::string& claim, double error, double allowed) {
  const bool holds = std::abs(error) <= allowed;
  all_hold_ = all_hold_ && holds;
  table_.add({claim, std::abs(error), allowed, holds ? "holds" : "FAILS"});
}

std::string Checks::text() const {
  const std::string head = fmt::format("{:7}  {:>8}  {:>8}  ", "verdict", "error", "allowed");
  std::string lines = head + "claim\n";
  for (const std::vector<Cell>& row : table_.rows()) {
    const auto digits = [&](std::size_t k) { return fmt::format("{:.3g}", std::get<double>(row[k].value())); };
    lines += wrapped(fmt::format("{:7}  {:>8}  {:>8}  {}", row[3].exact(), digits(1), digits(2), row[0].exact()),
                     head.size()) +
             '\n';
  }
  return lines;
}

}  // namespace particulate::report
