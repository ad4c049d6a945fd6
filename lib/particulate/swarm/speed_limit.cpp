#include <particulate/swarm/speed_limit.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::swarm {

void validate(const SpeedLimit& law) {
  if (law.v_max >= 0.0) return;
  throw std::invalid_argument(
      fmt::format("speed limit: v_max must not be negative, got {} m/s; leave the law out for none", law.v_max));
}

schemes::Jump limit_speeds(const SpeedLimit& law, const laws::At<laws::Velocity>& at, laws::Forces velocity) {
  schemes::Jump done;
  // A velocity that was shortened may be too long by its roundings: it is not shortened again for them.
  const double allowed = law.v_max * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Eigen::Vector3d before = at.velocity.row(i);
    const double speed = kinematics::length(before);
    if (speed <= allowed || at.inverse_mass[i] == 0.0) continue;
    const Eigen::Vector3d slowed = (law.v_max / speed) * before;
    velocity.row(i) = slowed;
    done.energy_change += 0.5 * at.mass[i] * (slowed - before).dot(slowed + before);
    ++done.impacts;
  }
  return done;
}

}  // namespace particulate::swarm
