#include <particulate/report/output.hpp>

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <particulate/report/files.hpp>

namespace particulate::report {
namespace {

namespace fs = std::filesystem;

constexpr const char *unfinished = "unfinished.txt", *stamped = "stamp.json", *parameters = "parameters.toml";
constexpr std::string_view heading = "Of a run that has not ended, or was cut short:\n";

bool is_table(const std::string& name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

// Whatever a list says, nothing but the results of runs is ever taken down.
bool is_result(const std::string& file) {
  const std::size_t dot = std::min(file.find('.'), file.size());
  const std::string ending = file.substr(dot);
  return file == parameters || (is_table(file.substr(0, dot)) &&
                                (ending == ".csv" || ending == ".xyz" || ending == ".vtp" || ending == ".vti"));
}

// What the run at work, or one that was cut short, has written so far.
std::vector<std::string> listed(const fs::path& folder) {
  std::vector<std::string> files;
  if (!fs::exists(folder / unfinished)) return files;
  std::istringstream lines(read_whole(folder / unfinished));
  for (std::string line; std::getline(lines, line);) {
    if (is_result(line)) files.push_back(line);
  }
  return files;
}

void list(const fs::path& folder, const std::vector<std::string>& files) {
  write_whole(folder / unfinished, fmt::format("{}{}{}", heading, fmt::join(files, "\n"), files.empty() ? "" : "\n"));
}

// What is in the way of a run that begins.
std::vector<std::string> left_before(const fs::path& folder) {
  std::vector<std::string> files = listed(folder);
  if (!fs::exists(folder / stamped)) return files;
  for (const std::string& file : files_of_stamp(read_whole(folder / stamped))) {
    if (is_result(file)) files.push_back(file);
  }
  return files;
}

// One run at a time: the system takes the lock back from a process that ends, however it does. Where folders cannot be
// locked, nobody is kept out.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor);
    throw std::runtime_error(
        fmt::format("{} must be written by one run at a time, and another is at work there. Wait for its end, or name "
                    "another folder.",
                    folder.native()));
  }
  return descriptor;
}

}  // namespace

Output::Output(fs::path folder) : folder_(std::move(folder)) {
  prepare_folder(folder_);
  lock_ = locked(folder_);
  try {
    const std::vector<std::string> before = left_before(folder_);
    list(folder_, before);  // first: what is taken down by half looks so
    fs::remove(folder_ / stamped);
    for (const std::string& file : before) fs::remove(folder_ / file);
    list(folder_, {});
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

Output::~Output() {
  if (lock_ >= 0) ::close(lock_);
}

void Output::add(const std::string& file, std::string_view content) const {
  std::vector<std::string> files = listed(folder_);
  if (std::find(files.begin(), files.end(), file) == files.end()) {
    files.push_back(file);
    list(folder_, files);
  }
  write_whole(folder_ / file, content);
}

void Output::write(const std::string& name, const Table& table) const {
  if (!is_table(name)) {
    throw std::invalid_argument(fmt::format(
        "output: a table's name must be lower-case letters, digits and underscores, without .csv, got \"{}\"", name));
  }
  add(name + ".csv", table.csv());
}

void Output::write_file(const std::string& file, std::string_view content) const {
  if (!is_result(file)) {
    throw std::invalid_argument(fmt::format(
        "output: a file's name must be lower-case letters, digits and underscores, with .xyz, .vtp or .vti, got \"{}\"",
        file));
  }
  add(file, content);
}

void Output::write_parameters(std::string_view toml) const { add(parameters, toml); }

std::size_t Output::finish(Stamp stamp) const {
  stamp.files = listed(folder_);
  write_whole(folder_ / stamped, json(stamp));
  fs::remove(folder_ / unfinished);
  return stamp.files.size() + 1;
}

void require_finished(const fs::path& folder) {
  if (fs::exists(folder / stamped) && !fs::exists(folder / unfinished)) return;
  throw std::runtime_error(
      fmt::format("{} must hold the results of a run that ended, with a {} and without {}. Run the program again.",
                  folder.native(), stamped, unfinished));
}

}  // namespace particulate::report
