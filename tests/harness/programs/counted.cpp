// Scenes whose cost is known, for the harness's own tests.

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <harness/counted_program.hpp>

namespace {

using verification::CountedRun;

// Three instructions a step and particle beyond the loop itself, whatever the compiler makes of that.
template <int particles>
CountedRun idle(long steps) {
  for (long k = 0; k < steps * particles; ++k) asm volatile("" ::: "memory");
  return {.particles = particles, .impacts = 0, .sum = 0.0};
}
template <int particles>
CountedRun three_more(long steps) {
  for (long k = 0; k < steps * particles; ++k) asm volatile("nop\n nop\n nop" ::: "memory");
  return {.particles = particles, .impacts = 2 * steps, .sum = 0.0};
}
// Two blocks a step.
CountedRun asks(long steps) {
  for (long k = 0; k < 2 * steps; ++k) {
    void* block = std::malloc(50);
    asm volatile("" : : "g"(block) : "memory");
    std::free(block);
  }
  return {.particles = 4, .impacts = 0, .sum = 0.0};
}
CountedRun fails_when_long(long steps) {
  if (steps == 13) throw std::runtime_error("the thirteenth step is refused");
  return {.particles = 1, .impacts = 0, .sum = 0.0};
}

}  // namespace

int main(int argc, char** argv) {
  static constexpr verification::CountedScene scenes[] = {
      {"idle", idle<8>}, {"three_more", three_more<8>}, {"asks", asks}, {"fails_at_thirteen", fails_when_long}};
  return verification::counted_program(argc, argv, scenes);
}
