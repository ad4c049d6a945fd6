#include <particulate/report/progress.hpp>

#include <array>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "says.hpp"

namespace tests::progress_test {

using namespace particulate::report;

const std::string clear_line = "\r\x1b[K";

// A terminal and a clock in the test's hand.
struct Watched {
  double time = 100.0;
  std::vector<std::string> printed;
  Progress::Surroundings surroundings() {
    return {.shown = true,
            .print = [this](const std::string& text) { printed.push_back(text); },
            .now = [this] { return time; }};
  }
};

BOOST_AUTO_TEST_SUITE(progress)

BOOST_AUTO_TEST_CASE(is_silent_where_nobody_looks) {
  int asked = 0;
  {
    Progress loop("loop", 10.0, 0.0,
                  {.shown = false,
                   .print = [&](const std::string&) { ++asked; },
                   .now =
                       [&] {
                         ++asked;
                         return 0.0;
                       }});
    for (int i = 0; i <= 10; ++i) loop.at(i);
  }
  BOOST_TEST(asked == 0);
}

BOOST_AUTO_TEST_CASE(waits_before_its_first_line_and_between_lines) {
  Watched watched;
  Progress loop("loop", 100.0, 1.0, watched.surroundings());
  watched.time = 100.9, loop.at(10.0);
  BOOST_TEST(watched.printed.empty());
  watched.time = 101.0, loop.at(20.0);
  watched.time = 101.05, loop.at(25.0);
  BOOST_TEST(watched.printed.size() == 1U);
  watched.time = 101.2, loop.at(30.0);
  BOOST_TEST(watched.printed.size() == 2U);
}

// A quarter in 2 s leaves three quarters, 6 s.
BOOST_AUTO_TEST_CASE(tells_label_percent_and_time_left) {
  Watched watched;
  Progress loop("orbit", 4.0, 1.0, watched.surroundings());
  watched.time = 102.0, loop.at(1.0);
  BOOST_TEST(watched.printed.back() == clear_line + "orbit  25 %, 6 s left");
  watched.time = 1100.0, loop.at(2.0);
  BOOST_TEST(watched.printed.back() == clear_line + "orbit  50 %, 16 min 40 s left");
}

BOOST_AUTO_TEST_CASE(never_goes_back_nor_beyond_the_end) {
  Watched watched;
  Progress loop("loop", 4.0, 0.0, watched.surroundings());
  watched.time = 102.0, loop.at(2.0);
  for (const double done : {1.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    watched.time += 1.0, loop.at(done);
    BOOST_TEST(contains(watched.printed.back(), " 50 %"));
  }
  watched.time += 1.0, loop.at(9.0);
  BOOST_TEST(watched.printed.back() == clear_line + "loop 100 %, 0 s left");
}

BOOST_AUTO_TEST_CASE(promises_nothing_before_anything_is_done) {
  Watched watched;
  Progress loop("loop", 4.0, 0.0, watched.surroundings());
  watched.time = 200.0, loop.at(0.0);
  BOOST_TEST(watched.printed.back() == clear_line + "loop   0 %");
}

BOOST_AUTO_TEST_CASE(wipes_its_line_when_it_ends_and_only_if_there_is_one) {
  Watched watched;
  { const Progress loop("loop", 4.0, 1.0, watched.surroundings()); }
  BOOST_TEST(watched.printed.empty());
  {
    Progress loop("loop", 4.0, 0.0, watched.surroundings());
    loop.at(1.0);
    loop.wipe();
    BOOST_TEST(watched.printed.back() == clear_line);
    loop.at(1.0);
    BOOST_TEST(watched.printed.size() == 3U);
  }
  BOOST_TEST(watched.printed.size() == 4U);
  BOOST_TEST(watched.printed.back() == clear_line);
}

BOOST_AUTO_TEST_CASE(refuses_a_total_of_nothing) {
  CHECK_REFUSED(Progress("loop", 0.0), "the total must be positive, got 0");
  BOOST_CHECK_THROW(Progress("loop", std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(for_each_run_)

BOOST_AUTO_TEST_CASE(makes_every_run_once_whatever_the_number_of_threads) {
  for (const int threads : {1, 3, 9}) {
    std::array<std::atomic<int>, 5> made{};
    for_each_run("runs", 5, threads, [&](int k) { ++made[static_cast<std::size_t>(k)]; });
    for (const std::atomic<int>& times : made) BOOST_TEST(times == 1);
  }
}

BOOST_AUTO_TEST_CASE(passes_on_what_a_run_throws) {
  for (const int threads : {1, 2}) {
    BOOST_CHECK_THROW(for_each_run("runs", 2, threads,
                                   [](int k) {
                                     if (k == 1) throw std::runtime_error("no end");
                                   }),
                      std::runtime_error);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::progress_test
