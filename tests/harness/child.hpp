#pragma once

#include <cstdio>
#include <string>

#include <sys/wait.h>

#include <fmt/format.h>
#include <boost/test/unit_test.hpp>

namespace tests {

/// How a child process ended.
struct Ended {
  int status;          ///< the exit status, -1 after a signal
  std::string output;  ///< both streams

  /// @param words  what should have been printed
  /// @return whether it was; the output is logged if not
  bool has(const std::string& words) const {
    const bool found = output.find(words) != std::string::npos;
    if (!found) BOOST_TEST_MESSAGE("it printed: " << output);
    return found;
  }
};

/// Runs one of the programs built for these tests.
/// @param program    its name
/// @param arguments  as a shell takes them
/// @return how it ended
inline Ended run(const std::string& program, const std::string& arguments) {
  const std::string command = fmt::format("{}/{} {} 2>&1", PROGRAMS, program, arguments);
  std::FILE* pipe = ::popen(command.c_str(), "r");
  Ended ended{.status = -1, .output = {}};
  char block[4096];
  for (std::size_t got = 0; (got = std::fread(block, 1, sizeof block, pipe)) > 0;) ended.output.append(block, got);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  return ended;
}

}  // namespace tests
