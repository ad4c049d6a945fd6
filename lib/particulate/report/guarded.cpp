#include <particulate/report/guarded.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace particulate::report {
namespace {

// A closed stream becomes one that refuses: reading ends of what is written, a writing end of what is read.
void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    const bool closed = ::fcntl(stream, F_GETFD) < 0 && errno == EBADF;
    // The lowest free number is given, which is this one.
    if (closed) static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

// Whether all that was printed has left this process.
bool has_arrived(std::string_view name) {
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  const char* const reason = flushed ? "an earlier line was lost" : std::strerror(errno);
  const bool fine = flushed && std::ferror(stdout) == 0 && std::cout.good();
  if (!fine) {
    std::cerr << name << ": not all that was printed could be written to the standard output: " << reason
              << ". Send it where there is room for it.\n";
  }
  return fine;
}

}  // namespace

int guarded(std::string_view name, const std::function<int()>& body) {
  hold_standard_streams();
  int status = 2;
  try {
    status = body();
  } catch (const std::exception& error) { std::cerr << name << ": " << error.what() << '\n'; }
  return has_arrived(name) ? status : 2;
}

}  // namespace particulate::report
