#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace particulate::contact::detail {

// The next event of each of N bodies, the first of all on top: a tree in which the earliest of four goes up. Bodies
// next to each other by number are so in memory. Ties say which of two bodies goes first at one time.
class EventQueue {
 public:
  explicit EventQueue(std::int32_t N)
      : N_(N),
        inner_(static_cast<std::size_t>(N + 1) / 3),
        fours_(inner_ + 1, Four{nothing, nothing, nothing, nothing}) {}

  double first_time() const { return at(top).t; }
  std::int32_t first() const { return at(top).body; }

  // Gives every body a new time.
  template <class Time, class Ties>
  void fill(Time&& time, const Ties& ties) {
    for (std::int32_t i = 0; i < N_; ++i) at(leaf(i)) = {time(i), i};
    for (std::size_t k = inner_; k > 0; --k) at(k - 1 + top) = earliest(fours_[k], ties);
  }
  // Gives one body a new time.
  template <class Ties>
  void update(std::int32_t body, double t, const Ties& ties) {
    std::size_t k = leaf(body);
    at(k) = {t, body};
    while (k != top) {
      const Entry& first = earliest(fours_[k / 4], ties);
      k = k / 4 - 1 + top;
      const bool as_before = at(k).body != body && first.body != body;
      if (as_before) return;
      at(k) = first;
    }
  }

  // Of which one is likely to be next; negative: none.
  std::array<std::int32_t, 4> soon() const {
    const Four& four = fours_[inner_ > 0 ? 1 : 0];
    return {four[0].body, four[1].body, four[2].body, four[3].body};
  }

 private:
  struct Entry {
    double t;
    std::int32_t body;
  };
  // One line of the cache.
  struct alignas(64) Four : std::array<Entry, 4> {};
  static constexpr Entry nothing{std::numeric_limits<double>::infinity(), -1};
  static constexpr std::size_t top = 3;  // the only entry of the first four; below entry k + top are the fours k + 1

  std::size_t leaf(std::int32_t body) const { return inner_ + top + static_cast<std::size_t>(body); }
  Entry& at(std::size_t k) { return fours_[k / 4][k % 4]; }
  const Entry& at(std::size_t k) const { return fours_[k / 4][k % 4]; }
  // Which is first cannot be foreseen, so it is found without branches, and that two times are equal is rare.
  template <class Ties>
  static const Entry& earliest(const Four& of, const Ties& ties) {
    const auto second_of = [&](std::size_t a, std::size_t b) {
      const bool equal = of[a].t == of[b].t && of[a].t < nothing.t;
      return equal ? ties(of[b].body, of[a].body) : of[b].t < of[a].t;
    };
    const std::size_t a = second_of(0, 1) ? 1 : 0, b = second_of(2, 3) ? 3 : 2;
    return of[second_of(a, b) ? b : a];
  }

  std::int32_t N_;
  std::size_t inner_;
  std::vector<Four> fours_;
};

}  // namespace particulate::contact::detail
