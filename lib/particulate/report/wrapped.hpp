#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace particulate::report {

/// How many columns what a program prints may take.
inline constexpr std::size_t screen_width = 100;

/// Breaks a text at its blanks, so that it fits the screen; a longer word stays whole.
/// @param text    words with blanks between them
/// @param indent  blanks before every line but the first
/// @return the lines, without a line break at the end
std::string wrapped(std::string_view text, std::size_t indent = 0);

}  // namespace particulate::report
