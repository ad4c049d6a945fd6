#include <harness/instruction_count.hpp>

#include <stdexcept>
#include <string>

#include "harness/child.hpp"
#include "says.hpp"

namespace instruction_count_test {
namespace {

using tests::says;
using verification::step_costs;
using verification::StepCosts;

const std::string counted = std::string(PROGRAMS) + "/harness_counted";

BOOST_AUTO_TEST_SUITE(step_costs_suite)

BOOST_AUTO_TEST_CASE(are_those_of_the_steps_alone) {
  const StepCosts costs = step_costs(counted, {.few = 5, .many = 25});
  const double more = costs.of("three_more").instructions - costs.of("idle").instructions;
  BOOST_TEST(more == 3.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(costs.of("idle").allocations == 0.0);
  BOOST_TEST(costs.of("idle").impacts == 0.0);
  BOOST_TEST(costs.of("three_more").impacts == 2.0);
  BOOST_TEST(costs.of("asks").allocations == 2.0);
  BOOST_TEST(costs.of("asks").bytes == 25.0);
  CHECK_REFUSED(costs.of("none"), "must be one of the program's, got \"none\"");
}

BOOST_AUTO_TEST_CASE(are_not_made_up_when_a_scene_fails) {
  BOOST_CHECK_EXCEPTION(step_costs(counted, {.few = 5, .many = 13}), std::runtime_error,
                        says("fails_at_thirteen failed: the thirteenth step is refused"));
}

BOOST_AUTO_TEST_CASE(are_not_made_up_without_a_program) {
  BOOST_CHECK_EXCEPTION(step_costs(counted + "_missing", {}), std::runtime_error,
                        says("valgrind (with its tool callgrind"));
}

BOOST_AUTO_TEST_CASE(name_the_arguments_that_a_program_refuses) {
  const tests::Ended ended = tests::run("harness_counted", "5 0");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("expected numbers of steps from 1 to 1000000, got 0"));
  BOOST_TEST(tests::run("harness_counted", "").has("idle\nthree_more\nasks\nfails_at_thirteen\n"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace instruction_count_test
