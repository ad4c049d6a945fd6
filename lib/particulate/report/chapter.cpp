#include <particulate/report/chapter.hpp>

#include <algorithm>
#include <iostream>

#include <particulate/report/stamp.hpp>

namespace particulate::report {

Chapter::Chapter(const CommandLine& line) : line_(line), output_(line.common().out) {
  output_.write_parameters(line.parameters_toml());
}

Checks& Chapter::claims(const std::string& table) {
  const auto found = std::find_if(claims_.begin(), claims_.end(), [&](const auto& of) { return of.first == table; });
  return found != claims_.end() ? found->second : claims_.emplace_back(table, Checks()).second;
}

int Chapter::end(std::string_view kernel) const {
  bool all_hold = !claims_.empty();
  for (const auto& [table, checks] : claims_) {
    output_.write(table, checks.table());
    std::cout << (&table == &claims_.front().first ? "" : "\n") << checks.table().text();
    all_hold = all_hold && checks.all_hold() && !checks.table().rows().empty();
  }
  std::cout.flush();
  output_.finish(make_stamp(line_.line(), common().seed, std::string(kernel)));
  return all_hold ? 0 : 1;
}

}  // namespace particulate::report
