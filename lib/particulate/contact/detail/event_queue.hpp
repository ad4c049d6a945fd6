#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace particulate::contact::detail {

// The next event of each of N bodies, the first of all in front: a heap that knows where each body stands in it.
// Ties say which of two bodies goes first at one time.
class EventQueue {
 public:
  explicit EventQueue(std::int32_t N) : heap_(static_cast<std::size_t>(N)), where_(heap_.size()) {}

  double first_time() const { return heap_.front().t; }
  std::int32_t first() const { return heap_.front().body; }

  // Gives every body a new time.
  template <class Time, class Ties>
  void fill(Time&& time, const Ties& ties) {
    for (std::size_t k = 0; k < heap_.size(); ++k) {
      heap_[k] = {time(static_cast<std::int32_t>(k)), static_cast<std::int32_t>(k)};
      where_[k] = static_cast<std::uint32_t>(k);
    }
    for (std::size_t k = heap_.size(); k-- > 0;) sink(k, heap_[k], ties);
  }
  // Gives one body a new time.
  template <class Ties>
  void update(std::int32_t body, double t, const Ties& ties) {
    const std::size_t k = where_[static_cast<std::size_t>(body)];
    const Entry entry{t, body};
    if (k > 0 && before(entry, heap_[(k - 1) / width], ties)) {
      rise(k, entry, ties);
    } else {
      sink(k, entry, ties);
    }
  }

 private:
  struct Entry {
    double t;
    std::int32_t body;
  };
  static constexpr std::size_t width = 4;  // children of an entry

  template <class Ties>
  static bool before(const Entry& a, const Entry& b, const Ties& ties) {
    return a.t != b.t ? a.t < b.t : ties(a.body, b.body);
  }
  void put(std::size_t k, const Entry& entry) {
    heap_[k] = entry;
    where_[static_cast<std::size_t>(entry.body)] = static_cast<std::uint32_t>(k);
  }
  template <class Ties>
  void rise(std::size_t k, const Entry& entry, const Ties& ties) {
    for (; k > 0 && before(entry, heap_[(k - 1) / width], ties); k = (k - 1) / width) put(k, heap_[(k - 1) / width]);
    put(k, entry);
  }
  template <class Ties>
  void sink(std::size_t k, Entry entry, const Ties& ties) {
    for (std::size_t child = width * k + 1; child < heap_.size(); child = width * k + 1) {
      const std::size_t end = std::min(child + width, heap_.size());
      std::size_t first = child;
      while (++child < end) {
        if (before(heap_[child], heap_[first], ties)) first = child;
      }
      if (!before(heap_[first], entry, ties)) break;
      put(k, heap_[first]);
      k = first;
    }
    put(k, entry);
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> where_;
};

}  // namespace particulate::contact::detail
