#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <particulate/schemes/problem.hpp>

/// @file
/// Events: zeros of functions of the solution, at which an advance stops so that the caller can change the state.

namespace particulate::reference {

/// Which way an event function must pass zero.
enum class Direction {
  falling = -1,  ///< from positive to negative
  either = 0,    ///< both ways
  rising = 1     ///< from negative to positive
};

/// Functions \f$ g_k(t, y) \f$ whose zeros are events.
///
/// All are evaluated together: `functions(t, y, g)` writes as many numbers as there are directions. For a second-order
/// problem \f$ y = (r, v) \f$. A zero is found where a function changes its sign within a step, to some 100 roundings
/// of the time; two sign changes within one step are missed, which largest_step can prevent. What the functions throw
/// comes out of the advance as it was thrown.
struct Events {
  std::function<void(double t, schemes::In y, schemes::Out g)> functions = {};  ///< writes every g_k; all finite
  std::vector<Direction> directions = {};                                       ///< one a function; none: no events
};

/// An event at which an advance stopped.
struct Hit {
  std::size_t event = 0;                    ///< which function, counted from 0
  Direction crossing = Direction::falling;  ///< which way it passed zero: falling or rising
};

/// Refuses events that cannot be meant. Called once, where they enter an integrator.
///
/// @param events  functions and directions; neither means no events
/// @throws std::invalid_argument naming what must hold and what was given
void validate(const Events& events);

}  // namespace particulate::reference
