#pragma once

#include <exception>
#include <string>

#include <boost/test/unit_test.hpp>

namespace tests {

/// Whether an exception's text holds these words:
///
///     BOOST_CHECK_EXCEPTION(validate(law), std::invalid_argument, says("must be positive, got -1"));
inline auto says(const std::string& words) {
  return [words](const std::exception& error) {
    const bool found = std::string(error.what()).find(words) != std::string::npos;
    if (!found) BOOST_TEST_MESSAGE("it says: " << error.what());
    return found;
  };
}

}  // namespace tests
