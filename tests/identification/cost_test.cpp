#include <particulate/identification/cost.hpp>

#include <limits>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "says.hpp"

namespace cost_test {

using namespace particulate::identification;

BOOST_AUTO_TEST_SUITE(evaluate_cost)

BOOST_AUTO_TEST_CASE(what_is_thrown_and_what_is_not_finite_is_no_value_with_its_reason) {
  const Eigen::VectorXd at = Eigen::VectorXd::Ones(2);
  BOOST_TEST(evaluate([](const auto& x) { return Value(x.sum()); }, at).cost == 2.0);
  BOOST_TEST(evaluate([](const auto&) -> Value { throw std::runtime_error("out of luck"); }, at).reason ==
             "out of luck");
  BOOST_TEST(evaluate([](const auto&) -> Value { throw 7; }, at).reason == "the cost threw what is no std::exception");
  BOOST_TEST(evaluate([](const auto&) { return Value(std::numeric_limits<double>::quiet_NaN()); }, at).reason ==
             "the cost is not a number");
  BOOST_TEST(evaluate([](const auto&) { return Value(-std::numeric_limits<double>::infinity()); }, at).reason ==
             "the cost is infinite");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace cost_test
