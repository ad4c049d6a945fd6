#include <particulate/report/files.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

namespace particulate::report {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, int reason) {
  throw std::runtime_error(
      fmt::format("{} cannot be written: {}. Name a folder that takes files.", path.native(), std::strerror(reason)));
}

// The temporary file of one write. It goes when the object does, unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& target) : target_(target) {
    for (int number = 0; descriptor_ < 0; ++number) {
      name_ = target.parent_path() / fmt::format(".{}.{}.{}", target.filename().native(), ::getpid(), number);
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) refuse(target_, errno);
    }
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse(target_, errno);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void become_target() {
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) refuse(target_, errno);
    if (::rename(name_.c_str(), target_.c_str()) != 0) refuse(target_, errno);
    name_.clear();
  }

 private:
  fs::path target_, name_;
  int descriptor_ = -1;
};

}  // namespace

void write_whole(const fs::path& path, std::string_view content) {
  Temporary file(path);
  file.write(content);
  file.become_target();
}

std::string read_whole(const fs::path& path) {
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  std::string content;
  bool fine = file != nullptr;
  char block[65536];
  while (fine) {
    const std::size_t got = std::fread(block, 1, sizeof block, file.get());
    content.append(block, got);
    fine = std::ferror(file.get()) == 0;
    if (got < sizeof block) break;
  }
  if (!fine) {
    throw std::runtime_error(
        fmt::format("{} cannot be read: {}. Name a file that exists.", path.native(), std::strerror(errno)));
  }
  return content;
}

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw std::runtime_error(fmt::format("{} cannot be made a folder for results: {}. Name another folder.",
                                         folder.native(), error.message()));
  }
  Temporary probe(folder / "probe");
  probe.write("x");
}

}  // namespace particulate::report
