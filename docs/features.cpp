// features <out.md> <lib/particulate> <verification> <cases.csv>...
//
// Which header of the library is exercised by which cases, and against what kind of reference: read off the includes of
// the cases' sources and the tables that the verification programs wrote.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/report/files.hpp>
#include <particulate/report/guarded.hpp>
#include <particulate/report/output.hpp>

namespace {

namespace fs = std::filesystem;
namespace report = particulate::report;

struct Case {
  std::string chapter, name, reference;
};

// From the topic's folder on: "contact/impact.hpp".
using Header = std::string;

// What an #include line names, without its brackets or quotes; empty for any other line.
std::string included(const std::string& line) {
  if (line.rfind("#include ", 0) != 0) return {};
  const std::size_t end = line.find_first_of(">\"", 10);
  return end == std::string::npos ? "" : line.substr(10, end - 10);
}

// The headers of the library that a source includes, itself or by the headers beside it and in other chapters. What the
// harness includes is machinery.
void collect(const fs::path& verification, const fs::path& source, std::set<fs::path>& seen, std::set<Header>& used) {
  if (!seen.insert(source).second) return;
  std::ifstream in(source);
  if (!in) throw std::runtime_error(fmt::format("{} cannot be read: run the verification again", source.string()));
  const std::string prefix = "particulate/";
  for (std::string line; std::getline(in, line);) {
    const std::string name = included(line);
    if (name.rfind(prefix, 0) == 0) {
      used.insert(name.substr(prefix.size()));
    } else if (fs::exists(source.parent_path() / name) && !name.empty()) {
      collect(verification, source.parent_path() / name, seen, used);
    } else if (name.rfind("ch", 0) == 0 && fs::exists(verification / name)) {
      collect(verification, verification / name, seen, used);
    }
  }
}

std::map<Header, std::vector<Case>> users(const fs::path& verification, const std::vector<std::string>& tables) {
  std::map<Header, std::vector<Case>> found;
  for (const std::string& table : tables) {
    const auto lines = report::parse_csv(report::read_whole(table), table);
    for (std::size_t k = 1; k < lines.size(); ++k) {
      const Case one{.chapter = lines[k].at(0), .name = lines[k].at(1), .reference = lines[k].at(4)};
      std::set<fs::path> seen;
      std::set<Header> used;
      collect(verification, verification / lines[k].at(5), seen, used);
      for (const Header& header : used) found[header].push_back(one);
    }
  }
  return found;
}

std::string kinds(const std::vector<Case>& cases) {
  std::map<std::string, int> counts;
  for (const Case& one : cases) ++counts[one.reference];
  std::string text;
  for (const auto& [kind, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  return text;
}

std::string links(const std::vector<Case>& cases) {
  std::string text;
  for (const Case& one : cases) {
    text += fmt::format("{}@ref verify_{}_{} \"{}\"", text.empty() ? "" : ", ", one.chapter, one.name, one.name);
  }
  return text;
}

std::vector<Header> headers_of(const fs::path& topic) {
  std::vector<Header> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(topic)) {
    if (entry.path().extension() != ".hpp") continue;
    all.push_back((topic.filename() / entry.path().filename()).generic_string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string page(const fs::path& library, const std::map<Header, std::vector<Case>>& found) {
  std::string text = R"(# Features and cases {#feature_matrix}

For every header of the library the cases that use it, and what they are checked against: read off the includes of the
cases' sources. A case that uses several features counts for each of them. Command line, tables and the wrapper around
SUNDIALS are the verification's own tools, and are tested instead.

)";
  for (const std::string topic : {"kinematics", "contact", "schemes", "scenes"}) {
    text += fmt::format("## {}\n\n| Header | Checked against | Cases |\n| :--- | :--- | :--- |\n", topic);
    std::string reached;
    for (const Header& header : headers_of(library / topic)) {
      const auto cases = found.find(header);
      if (cases == found.end()) {
        reached += fmt::format("{}`{}`", reached.empty() ? "" : ", ", header);
      } else {
        text += fmt::format("| `{}` | {} | {} |\n", header, kinds(cases->second), links(cases->second));
      }
    }
    if (!reached.empty()) text += fmt::format("\nOnly by way of the headers above: {}.\n", reached);
    text += '\n';
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  return report::guarded("features", [&] {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() < 4)
      throw std::runtime_error("usage: features <out.md> <lib/particulate> <verification> <cases.csv>...");
    const std::vector<std::string> tables(arguments.begin() + 3, arguments.end());
    for (const std::string& table : tables) report::require_finished(fs::path(table).parent_path());
    const auto found = users(arguments[2], tables);
    report::write_whole(arguments[0], page(arguments[1], found));
    return 0;
  });
}
