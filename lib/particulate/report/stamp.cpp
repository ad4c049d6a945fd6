#include <particulate/report/stamp.hpp>

#include <ctime>
#include <fstream>

#include <fmt/format.h>

// Written into the build tree by lib/cmake/revision.cmake, before this file is compiled.
#include "build_facts.hpp"

namespace particulate::report {
namespace {

// Linux names the processor on a line "model name : ..."; some architectures have no such line.
std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text, length};
}

}  // namespace

Stamp make_stamp(std::string options, std::uint64_t seed, std::string kernel) {
  return {.revision = build_facts::revision,
          .compiler = build_facts::compiler,
          .flags = build_facts::flags,
          .build_type = build_facts::build_type,
          .processor = processor_name(),
          .kernel = std::move(kernel),
          .options = std::move(options),
          .seed = seed,
          .date = utc_now()};
}

std::string one_line(const Stamp& stamp) {
  return fmt::format("revision {}, {} ({}), {}, kernel {}, seed {}, {}", stamp.revision, stamp.compiler,
                     stamp.build_type, stamp.processor, stamp.kernel, stamp.seed, stamp.date);
}

}  // namespace particulate::report
