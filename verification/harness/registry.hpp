#pragma once

#include <vector>

#include <harness/case.hpp>

namespace verification {

/// @return every case linked into this program, in the order of their construction
std::vector<const Case*>& registry();

}  // namespace verification
