#include <particulate/contact/friction.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Dense>

namespace particulate::contact {

void validate(const Friction& law) {
  if (!(law.mu_d >= 0.0 && std::isfinite(law.mu_d))) {
    throw std::invalid_argument(fmt::format("friction: mu_d must be finite and not negative, got {}", law.mu_d));
  }
  if (!(law.mu_s >= law.mu_d && std::isfinite(law.mu_s))) {
    throw std::invalid_argument(
        fmt::format("friction: mu_s must be finite and at least mu_d = {}, got {}", law.mu_d, law.mu_s));
  }
}

Eigen::Vector3d tangential_impulse(const Friction& law, const Eigen::Vector3d& slip, double reduced_mass,
                                   double normal_impulse) {
  const double speed = slip.stableNorm();
  const double sticking = reduced_mass * speed;
  if (sticking <= law.mu_s * normal_impulse) return -reduced_mass * slip;
  return (-law.mu_d * normal_impulse / speed) * slip;
}

namespace {

// Several contacts that rub, in units in which every one has unit mass: impulses over, slips times the root of it.
struct Rubbing {
  Eigen::MatrixXd W;     // how impulses change the slips
  Eigen::VectorXd slip;  // without friction
  Eigen::VectorXd most;  // how large each impulse may be

  Eigen::Index size() const { return most.size(); }
  Eigen::VectorXd left(const Eigen::VectorXd& P) const { return slip + W * P; }
  double energy(const Eigen::VectorXd& P) const { return P.dot(slip + 0.5 * (W * P)); }
  bool holds(const Eigen::VectorXd& P) const {
    constexpr double slack = 1e-12;
    for (Eigen::Index k = 0; k < size(); ++k) {
      if (P.segment<2>(2 * k).norm() > most[k] * (1.0 + slack)) return false;
    }
    return true;
  }
  // The impulse of contact k where it alone would come to rest, or as near as it may.
  Eigen::Vector2d alone(Eigen::Index k, const Eigen::Vector2d& wanted) const {
    const double size = wanted.norm();
    return size > most[k] ? Eigen::Vector2d(wanted * (most[k] / size)) : wanted;
  }
};

// The impulses that stop all slip; of many, those that ask all contacts for the least of what they can hold.
Eigen::VectorXd sticking(const Rubbing& all) {
  Eigen::VectorXd scale(all.slip.size());
  for (Eigen::Index k = 0; k < all.size(); ++k) scale.segment<2>(2 * k).setConstant(std::sqrt(all.most[k]));
  const Eigen::MatrixXd scaled = scale.asDiagonal() * all.W * scale.asDiagonal();
  const Eigen::VectorXd target = scale.cwiseProduct(all.slip);
  return -scale.cwiseProduct(scaled.completeOrthogonalDecomposition().solve(target));
}

// One step of Newton's method towards impulses of which each is what the contact alone would take.
Eigen::VectorXd newton_step(const Rubbing& all, const Eigen::VectorXd& P) {
  const Eigen::VectorXd wanted = P - all.left(P);
  Eigen::MatrixXd J = all.W;
  Eigen::VectorXd miss(P.size());
  for (Eigen::Index k = 0; k < all.size(); ++k) {
    const Eigen::Vector2d z = wanted.segment<2>(2 * k);
    miss.segment<2>(2 * k) = all.alone(k, z) - P.segment<2>(2 * k);
    const double size = z.norm();
    if (size <= all.most[k]) continue;
    const Eigen::Matrix2d turn = all.most[k] / size * (Eigen::Matrix2d::Identity() - z * z.transpose() / (size * size));
    J.middleRows<2>(2 * k) = turn * all.W.middleRows<2>(2 * k);
    J.block<2, 2>(2 * k, 2 * k) += Eigen::Matrix2d::Identity() - turn;
  }
  Eigen::VectorXd to = P + J.completeOrthogonalDecomposition().solve(miss);
  for (Eigen::Index k = 0; k < all.size(); ++k) to.segment<2>(2 * k) = all.alone(k, to.segment<2>(2 * k));
  return to;
}

// How far the impulses are from what each contact alone would take.
double miss_of(const Rubbing& all, const Eigen::VectorXd& P) {
  const Eigen::VectorXd wanted = P - all.left(P);
  double worst = 0.0;
  for (Eigen::Index k = 0; k < all.size(); ++k) {
    worst = std::max(worst, (all.alone(k, wanted.segment<2>(2 * k)) - P.segment<2>(2 * k)).norm());
  }
  return worst;
}

// Lets the kinetic energy fall to its minimum over impulses up to the most: all at once where that comes nearer or
// lower, else one contact after the other, which always falls. Returns whether it is reached.
bool minimise(const Rubbing& all, Eigen::VectorXd& P) {
  constexpr int most_rounds = 2000, turns = 10;
  constexpr double roundings = 16.0 * std::numeric_limits<double>::epsilon();
  const double largest = all.slip.cwiseAbs().maxCoeff();
  for (int round = 0; round < most_rounds; ++round) {
    const double miss = miss_of(all, P);
    if (miss <= roundings * (largest + P.cwiseAbs().maxCoeff())) return true;
    const Eigen::VectorXd to = newton_step(all, P);
    if (miss_of(all, to) < 0.5 * miss || all.energy(to) < all.energy(P) - 1e-12 * all.slip.squaredNorm()) {
      P = to;
      continue;
    }
    for (Eigen::Index turn = 0; turn < turns * all.size(); ++turn) {
      const Eigen::Index k = turn % all.size();
      const Eigen::Vector2d left = all.slip.segment<2>(2 * k) + all.W.middleRows<2>(2 * k) * P;
      P.segment<2>(2 * k) = all.alone(k, P.segment<2>(2 * k) - left);
    }
  }
  return false;
}

// Contacts that slip although they hold all they can may from now on hold less. Returns whether there are new ones.
bool let_slide(Rubbing& all, const Eigen::VectorXd& P, const Eigen::VectorXd& mass, const Eigen::VectorXd& sliding,
               std::vector<bool>& slides) {
  constexpr double stopped = 1e-10;
  const auto speed = [&](const Eigen::VectorXd& of, Eigen::Index k) {
    return of.segment<2>(2 * k).norm() / mass[2 * k];
  };
  double fastest = 0.0;
  for (Eigen::Index k = 0; k < all.size(); ++k) fastest = std::max(fastest, speed(all.slip, k));
  const Eigen::VectorXd left = all.left(P);
  bool more = false;
  for (Eigen::Index k = 0; k < all.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (slides[at] || speed(left, k) <= stopped * fastest) continue;
    slides[at] = more = true;
    all.most[k] = sliding[k];
  }
  return more;
}

}  // namespace

Eigen::VectorXd tangential_impulses(const Friction& law, const Eigen::MatrixXd& W, const Eigen::VectorXd& slip,
                                    const Eigen::VectorXd& normal_impulses, const Eigen::VectorXd& given) {
  const Eigen::VectorXd mass = W.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::VectorXd before = given.cwiseQuotient(mass);
  Eigen::VectorXd push(normal_impulses.size());
  for (Eigen::Index k = 0; k < push.size(); ++k) push[k] = normal_impulses[k] / mass[2 * k];
  Rubbing all{.W = mass.asDiagonal() * W * mass.asDiagonal(), .slip = mass.cwiseProduct(slip), .most = law.mu_s * push};
  all.slip -= all.W * before;
  Eigen::VectorXd held = sticking(all);
  if (all.holds(held)) return mass.cwiseProduct(held);
  if (!minimise(all, held)) return {};
  std::vector<bool> slides(static_cast<std::size_t>(push.size()), false);
  Eigen::VectorXd P = held;
  while (let_slide(all, P, mass, law.mu_d * push, slides)) {
    if (!minimise(all, P)) return {};
  }
  const double allowed = all.energy(before) + 1e-10 * all.slip.squaredNorm();
  return mass.cwiseProduct(all.energy(P) > allowed ? held : P);
}

}  // namespace particulate::contact
