#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace particulate::report {

/// What a result was made with.
struct Stamp {
  std::string revision;    ///< git commit, "-dirty" after it if files differ from it; "unknown" outside git
  std::string compiler;    ///< name and version
  std::string flags;       ///< as the library was compiled
  std::string build_type;  ///< Release, Debug, ...
  std::string processor;   ///< model name as the system gives it
  std::string kernel;      ///< the variant of the force kernel that ran
  std::string options;     ///< the command line
  std::uint64_t seed = 0;  ///< of the random numbers
  std::string date;        ///< UTC, ISO 8601
  std::vector<std::string> files = {};  ///< that the run wrote, in their order; Output::finish() tells
};

/// Takes down revision, compiler, flags and build type of this build, the processor and the time now.
/// @param options  the command line, CommandLine::line()
/// @param seed     of the random numbers
/// @param kernel   the variant of the force kernel that runs
/// @return the stamp
Stamp make_stamp(std::string options, std::uint64_t seed, std::string kernel);

/// @param stamp  what a result was made with
/// @return one line for a terminal
std::string one_line(const Stamp& stamp);

/// @param stamp  what a result was made with
/// @return a JSON object with one key a field
std::string json(const Stamp& stamp);

/// @param json  of a stamp, or any other text
/// @return the files that it names; none if it names none
std::vector<std::string> files_of_stamp(const std::string& json);

}  // namespace particulate::report
