#include <particulate/report/chapter.hpp>

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include <particulate/report/stamp.hpp>
#include <particulate/report/wrapped.hpp>

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
    std::cout << checks.text() << '\n';
    all_hold = all_hold && checks.all_hold() && !checks.table().rows().empty();
  }
  if (!summary_.rows().empty()) {
    output_.write("summary", summary_);
    std::cout << summary_.text() << '\n';
  }
  for (const std::string& note : notes_) std::cout << wrapped("Note: " + note, 2) << "\n\n";
  const std::size_t files = output_.finish(make_stamp(line_.line(), common().seed, std::string(kernel)));
  std::cout << fmt::format("{} The results are {} files in {}.",
                           all_hold ? "Every claim holds." : "NOT every claim holds.", files, output_.folder().native())
            << line_.how_to_draw() << std::endl;
  return all_hold ? 0 : 1;
}

}  // namespace particulate::report
