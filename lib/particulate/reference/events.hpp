#pragma once

#include <particulate/schemes/events.hpp>

/// @file
/// Events as the schemes know them: CVODE is given the same list. It stops at every event, whatever its action, and
/// leaves the change of the state to the caller; it finds zeros where a function changes its sign within a step, to
/// some 100 roundings of the time, and misses two sign changes within one step, which largest_step can prevent, and
/// grazes.

namespace particulate::reference {

using schemes::describe;
using schemes::Direction;
using schemes::Event;
using schemes::Events;
using schemes::Hit;

}  // namespace particulate::reference
