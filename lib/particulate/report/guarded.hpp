#pragma once

#include <functional>
#include <string_view>

namespace particulate::report {

/// Runs a program's body, turns what it throws into a message and exit status 2, and does the same where what it
/// printed has not all arrived: the disk is full, the standard output is closed, or its reader has gone.
///
/// Standard streams that are closed are held first, so that no file of results takes the place of one. The body prints
/// with stdio, fmt or std::cout, and need not look at what became of it.
/// @param name  the program, which begins the message
/// @param body  everything main() does; returns the exit status
/// @return what body returned, or 2 after an exception or a loss
int guarded(std::string_view name, const std::function<int()>& body);

}  // namespace particulate::report
