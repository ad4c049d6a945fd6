#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace particulate::report {

/// The known words that somebody who wrote another one may have meant.
///
/// A known word is near if it can be reached by few enough insertions, deletions and substitutions (a third of its
/// length, at least one), or if one of the two contains the other.
/// @param given  what was written
/// @param known  what would have been understood
/// @return at most three, the nearest first
std::vector<std::string> near_matches(std::string_view given, const std::vector<std::string>& known);

/// @param words  any number of words
/// @return them in one phrase, `a, b or c`; empty for none
std::string either(const std::vector<std::string>& words);

}  // namespace particulate::report
