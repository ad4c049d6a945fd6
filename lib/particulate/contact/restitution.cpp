#include <particulate/contact/restitution.hpp>

#include <cmath>
#include <limits>
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

double speeds_to_come(const ConstantRestitution& law, double speed) {
  if (!(speed > 0.0)) return 0.0;
  return law.e < 1.0 ? speed / (1.0 - law.e) : std::numeric_limits<double>::infinity();
}

double speeds_to_come(const Restitution& law, double speed) {
  // A series so slow that this many terms do not end it is that of e_o by then.
  constexpr int most = 1000000;
  const ConstantRestitution gentle{law.e_o};
  if (law.e_o == 1.0) return speeds_to_come(gentle, speed);
  double sum = 0.0;
  for (int k = 0; k < most && speed > 1e-16 * (1.0 - law.e_o) * law.v_star; ++k) {
    sum += speed;
    speed *= restitution_at(law, speed);
  }
  return sum + speeds_to_come(gentle, speed);
}

void validate(const ConstantRestitution& law) {
  if (!(law.e >= 0.0 && law.e <= 1.0)) {
    throw std::invalid_argument(fmt::format("restitution: e must lie in [0, 1], got {}", law.e));
  }
}

void validate(const SofteningRestitution& law) {
  validate(law.cold);
  if (!(law.theta_r >= 0.0 && std::isfinite(law.theta_r))) {
    throw std::invalid_argument(
        fmt::format("restitution: theta_r must be finite and not negative, got {} K", law.theta_r));
  }
  if (!(law.theta_star > law.theta_r && std::isfinite(law.theta_star))) {
    throw std::invalid_argument(fmt::format("restitution: theta_star must be finite and above theta_r = {} K, got {} K",
                                            law.theta_r, law.theta_star));
  }
}

}  // namespace particulate::contact
