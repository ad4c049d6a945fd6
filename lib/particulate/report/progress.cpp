#include <particulate/report/progress.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <future>
#include <stdexcept>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>

namespace particulate::report {
namespace {

constexpr double between_lines = 0.1;           // [s]
constexpr std::size_t widest_label = 48;        // with what follows, the line stays below 80 columns
constexpr const char* clear_line = "\r\x1b[K";  // back to the left, erase to the right

Progress::Surroundings terminal() {
  return {
      .shown = ::isatty(STDERR_FILENO) == 1,
      .print = [](const std::string& text) { fmt::print(stderr, "{}", text), std::fflush(stderr); },
      .now = [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }};
}

std::string duration(double seconds) {
  if (!(seconds < 360000.0)) return "more than 100 h";
  const int whole = static_cast<int>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(std::string label, double total, double patience)
    : Progress(std::move(label), total, patience, terminal()) {}

Progress::Progress(std::string label, double total, double patience, Surroundings surroundings)
    : label_(std::move(label)), total_(total), surroundings_(std::move(surroundings)) {
  if (!(total > 0.0)) {
    throw std::invalid_argument(fmt::format("progress of {}: the total must be positive, got {}", label_, total));
  }
  if (!surroundings_.shown) return;
  started_ = surroundings_.now();
  due_ = started_ + patience;
}

Progress::~Progress() { wipe(); }

void Progress::wipe() {
  if (!line_is_there_) return;
  surroundings_.print(clear_line);
  line_is_there_ = false;
  due_ = started_;
}

void Progress::show(double done) {
  if (done > fraction_ * total_) fraction_ = std::min(done / total_, 1.0);
  const double now = surroundings_.now();
  if (now < due_) return;
  due_ = now + between_lines;
  line_is_there_ = true;
  const std::string left =
      fraction_ > 0.0 ? fmt::format(", {} left", duration((now - started_) * (1.0 - fraction_) / fraction_)) : "";
  surroundings_.print(
      fmt::format("{}{} {:3.0f} %{}", clear_line, label_.substr(0, widest_label), std::floor(100.0 * fraction_), left));
}

void for_each_run(const std::string& label, int count, int threads, const std::function<void(int)>& run) {
  std::atomic<int> next = 0;
  const auto work = [&](const std::function<void(int)>& tell) {
    for (int k = next++; k < count; k = next++) {
      tell(k);
      run(k);
    }
  };
  Progress progress(label, count);
  std::vector<std::future<void>> others;
  for (int n = 1; n < std::min(threads, count); ++n) {
    others.push_back(std::async(std::launch::async, work, [](int) {}));
  }
  work([&](int k) { progress.at(k); });
  for (std::future<void>& other : others) other.get();
}

}  // namespace particulate::report
