#include <particulate/contact/restitution.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::contact {

// Every comparison is one that a NaN fails.
void validate(const Restitution& law) {
  if (!(law.e_o >= 0.0 && law.e_o <= 1.0)) {
    throw std::invalid_argument(fmt::format("restitution: e_o must lie in [0, 1], got {}", law.e_o));
  }
  if (!(law.e_minus >= 0.0 && law.e_minus <= law.e_o)) {
    throw std::invalid_argument(
        fmt::format("restitution: e_minus must lie in [0, e_o = {}], got {}", law.e_o, law.e_minus));
  }
  if (!(law.v_star > 0.0)) {
    throw std::invalid_argument(fmt::format(
        "restitution: v_star must be positive, infinite for a restitution that does not fall, got {} m/s", law.v_star));
  }
}

void validate(const ConstantRestitution& law) {
  if (!(law.e >= 0.0 && law.e <= 1.0)) {
    throw std::invalid_argument(fmt::format("restitution: e must lie in [0, 1], got {}", law.e));
  }
}

}  // namespace particulate::contact
