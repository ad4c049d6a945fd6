#pragma once

#include <exception>
#include <stdexcept>
#include <string>

#include <boost/test/unit_test.hpp>

namespace tests {

/// Whether a text holds these words; the message shows the text.
///
///     BOOST_TEST(contains(outcome.reason, "choose a larger step"));
inline boost::test_tools::predicate_result contains(const std::string& text, const std::string& words) {
  boost::test_tools::predicate_result found(text.find(words) != std::string::npos);
  if (!found) found.message() << "\"" << words << "\" is not in \"" << text << "\"";
  return found;
}

/// Whether an exception's text holds these words:
///
///     BOOST_CHECK_EXCEPTION(scene.step(), std::runtime_error, says("is not finite"));
inline auto says(const std::string& words) {
  return [words](const std::exception& error) {
    const bool found = std::string(error.what()).find(words) != std::string::npos;
    if (!found) BOOST_TEST_MESSAGE("it says: " << error.what());
    return found;
  };
}

}  // namespace tests

/// Checks that an expression is refused as the caller's mistake, std::invalid_argument, in these words:
///
///     CHECK_REFUSED(validate(law), "must be positive, got -1");
#define CHECK_REFUSED(expression, words) \
  BOOST_CHECK_EXCEPTION((void)(expression), std::invalid_argument, ::tests::says(words))
