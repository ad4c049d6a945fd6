#include <particulate/report/checks.hpp>

#include <cmath>

namespace particulate::report {

void Checks::add(const std::string& claim, double error, double allowed) {
  const bool holds = std::abs(error) <= allowed;
  all_hold_ = all_hold_ && holds;
  table_.add({claim, std::abs(error), allowed, holds ? "holds" : "FAILS"});
}

}  // namespace particulate::report
