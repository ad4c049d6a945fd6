#include <particulate/schemes/outcome.hpp>

#include <set>
#include <sstream>
#include <string>

#include "says.hpp"

namespace tests::outcome_test {

using namespace particulate::schemes;

BOOST_AUTO_TEST_SUITE(name_)

// An enumerator without a name does not compile (-Wswitch); one named like another fails here.
BOOST_AUTO_TEST_CASE(tells_every_status_and_every_failure_from_the_others) {
  std::set<std::string_view> names;
  for (int k = 0; k <= static_cast<int>(Failure::beyond_limit); ++k) names.insert(name(static_cast<Failure>(k)));
  BOOST_TEST(names.size() == 11U);
  BOOST_TEST(!names.contains("unknown"));
  BOOST_TEST(name(Failure::time_stands_still) == "time stands still");
  BOOST_TEST(name(Status::reached) == "reached");
  BOOST_TEST(name(Status::stopped) == "stopped");
  BOOST_TEST(name(Status::failed) == "failed");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(sum_)

BOOST_AUTO_TEST_CASE(adds_counts_and_keeps_what_is_largest) {
  Outcome run;
  run += Outcome{.overlap_at_start = 0.5};  // no step: the next leg starts there
  run += Outcome{.t = 1.0,
                 .steps = 3,
                 .rejections = 1,
                 .sweeps = 9,
                 .evaluations = 12,
                 .impacts = 2,
                 .contraction = 0.5,
                 .overlap = 0.25,
                 .overlap_at_start = 0.125,
                 .penetration = 0.375,
                 .travel = 2.0,
                 .energy_change = -1.0,
                 .heat = 3.0,
                 .released = 2.0,
                 .jumps_by_law = {{.impacts = 2, .energy_change = -1.0}},
                 .ruled = "spring"};
  run += Outcome{.status = Status::failed,
                 .reason = "why",
                 .failure = Failure::slow,
                 .workable_step = 0.5,
                 .t = 2.0,
                 .steps = 4,
                 .rejections = 2,
                 .sweeps = 10,
                 .evaluations = 20,
                 .impacts = 3,
                 .contraction = 0.25,
                 .overlap = 0.5,
                 .overlap_at_start = 0.75,
                 .penetration = 0.25,
                 .travel = 1.0,
                 .energy_change = -0.5,
                 .heat = 0.5,
                 .jumps_by_law = {{.impacts = 3, .energy_change = -0.5}, {.impacts = 1, .energy_change = 2.0}}};
  BOOST_TEST((run.status == Status::failed && run.failure == Failure::slow));
  BOOST_TEST(run.reason == "why");
  BOOST_TEST(run.workable_step == 0.5);
  BOOST_TEST(run.t == 2.0);
  BOOST_TEST(run.steps == 7);
  BOOST_TEST(run.rejections == 3);
  BOOST_TEST(run.sweeps == 19);
  BOOST_TEST(run.evaluations == 32);
  BOOST_TEST(run.impacts == 5);
  BOOST_TEST(run.contraction == 0.5);
  BOOST_TEST(run.overlap == 0.5);
  BOOST_TEST(run.overlap_at_start == 0.125);
  BOOST_TEST(run.travel == 2.0);
  BOOST_TEST(run.energy_change == -1.5);
  BOOST_TEST(run.penetration == 0.375);
  BOOST_TEST(run.heat == 3.5);
  BOOST_TEST(run.released == 2.0);
  BOOST_TEST_REQUIRE(run.jumps_by_law.size() == 2U);
  BOOST_TEST(run.jumps_by_law[0].impacts == 5);
  BOOST_TEST(run.jumps_by_law[0].energy_change == -1.5);
  BOOST_TEST(run.jumps_by_law[1].impacts == 1);
  BOOST_TEST(run.ruled == "spring");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(describe_)

BOOST_AUTO_TEST_CASE(leaves_out_what_is_zero_or_unknown) {
  BOOST_TEST(describe(Outcome{}) == "reached t = 0 s");
  BOOST_TEST(describe(Outcome{.t = 0.1, .steps = 1, .evaluations = 2}) ==
             "reached t = 0.1 s\n  1 step, 2 right-hand sides");
}

BOOST_AUTO_TEST_CASE(says_why_when_and_what_was_done_and_breaks_long_lines) {
  const Outcome outcome{.status = Status::failed,
                        .reason =
                            "the sweeps must contract, and the largest contraction seen was 1.5; take a smaller "
                            "step or another fixed point",
                        .failure = Failure::diverging,
                        .workable_step = 0.25,
                        .t = 1.5,
                        .steps = 12,
                        .rejections = 3,
                        .sweeps = 70,
                        .evaluations = 71,
                        .impacts = 2,
                        .contraction = 1.5,
                        .overlap = 1e-7,
                        .energy_change = -0.125,
                        .ruled = "spring"};
  std::ostringstream printed;
  printed << outcome;
  BOOST_TEST(printed.str() ==
             "failed at t = 1.5 s (diverging): the sweeps must contract, and the largest contraction seen was 1.5;\n"
             "  take a smaller step or another fixed point\n"
             "  12 steps, 3 rejected, 70 sweeps, 71 right-hand sides, 2 impacts, largest contraction 1.5, deepest\n"
             "  overlap 1e-07 m, energy changed by jumps -0.125 J, a step that would have worked 0.25 s, steps cut\n"
             "  by spring");
  std::istringstream lines(printed.str());
  for (std::string line; std::getline(lines, line);) BOOST_TEST(line.size() <= 100U);
}

BOOST_AUTO_TEST_CASE(says_how_many_bodies_overlapped_at_the_start_and_how_deep) {
  BOOST_TEST(describe(Outcome{.overlap_at_start = 0.25, .contacts_at_start = 7}) ==
             "reached t = 0 s\n  7 overlaps at the start, up to 0.25 m deep");
}

BOOST_AUTO_TEST_CASE(says_what_stopped_it_and_where_events_pile_up) {
  BOOST_TEST(describe(Outcome{.status = Status::stopped, .reason = "floor", .t = 2.0}) == "stopped at t = 2 s: floor");
  BOOST_TEST(contains(describe(Outcome{.failure = Failure::accumulating, .accumulation = 3.0}),
                      "(accumulating)\n  accumulating at t = 3 s"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::outcome_test
