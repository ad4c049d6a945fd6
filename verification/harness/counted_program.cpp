#include <harness/counted_program.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <particulate/report/guarded.hpp>

// Without its header the program still builds, but callgrind finds no marks, and instruction_count.cpp says so.
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name)
#endif

// Eigen asks malloc, the standard library asks operator new, which asks malloc: all of them come through here.
namespace {
long allocations = 0, bytes = 0;
void count(std::size_t size) {
  ++allocations;
  bytes += static_cast<long>(size);
}
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t n, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* malloc(std::size_t size) {
  count(size);
  return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
  count(n * size);
  return __libc_calloc(n, size);
}
void* realloc(void* old, std::size_t size) {
  count(size);
  return __libc_realloc(old, size);
}
}

namespace verification {
namespace {

template <class Work>
bool attempt(const CountedScene& scene, const Work& work) {
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "counted: %s failed: %s\n", scene.name, error.what());
    return false;
  }
}

void measure(const CountedScene& scene, long steps) {
  const std::string mark = std::string(scene.name) + " " + std::to_string(steps);
  const long before = allocations, bytes_before = bytes;
  CALLGRIND_ZERO_STATS;
  const CountedRun run = scene.run(steps);
  CALLGRIND_DUMP_STATS_AT(mark.c_str());
  const long asked = allocations - before, held = bytes - bytes_before;
  std::printf("counted %s particles %ld steps %ld impacts %ld allocations %ld bytes %ld sum %.17g\n", scene.name,
              run.particles, steps, run.impacts, asked, held, run.sum);
}

// Each run begins with the same heap, because what malloc does depends on what was freed before.
int in_a_process_of_its_own(const CountedScene& scene, long steps) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const bool done = attempt(scene, [&] { measure(scene, steps); });
    _exit(std::fflush(stdout) == 0 && done ? 0 : 1);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0 ? 0 : 1;
}

int refused(const char* what) {
  std::fprintf(
      stderr, "counted: expected numbers of steps from 1 to 1000000, got %s; without arguments the scenes are listed\n",
      what);
  return 2;
}

}  // namespace

namespace {

int counted(int argc, const char* const* argv, std::span<const CountedScene> scenes) {
  std::vector<long> lengths;
  for (int i = 1; i < argc; ++i) {
    char* rest = nullptr;
    lengths.push_back(std::strtol(argv[i], &rest, 10));
    if (rest == argv[i] || *rest != '\0' || lengths.back() < 1 || lengths.back() > 1'000'000) return refused(argv[i]);
  }
  for (const CountedScene& scene : scenes) {
    if (lengths.empty()) std::printf("%s\n", scene.name);
    if (!lengths.empty() && !attempt(scene, [&] { scene.run(1); })) return 1;
  }
  int failed = 0;
  for (const CountedScene& scene : scenes) {
    for (const long steps : lengths) failed += in_a_process_of_its_own(scene, steps);
  }
  return failed == 0 ? 0 : 1;
}

}  // namespace

int counted_program(int argc, const char* const* argv, std::span<const CountedScene> scenes) {
  return particulate::report::guarded("counted", [&] { return counted(argc, argv, scenes); });
}

}  // namespace verification
