// A law of one's own with a charge for each particle, of either sign. Two opposite charges go round an ellipse and are
// back where they were after Kepler's period, T = 2 pi (m* a^3/(k |q_1 q_2|))^(1/2); equal charges repel one another as
// under the near field with one strength for all pairs.

#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include <fmt/core.h>

#include <particulate/kinematics/central_force.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>

using namespace particulate;

// [law]
namespace mine {

struct Coulomb {
  Eigen::VectorXd q;          // a charge for each particle [C]
  double k = 8.9875517923e9;  // 1/(4 pi epsilon_0) [N m^2/C^2]
};

void validate(const Coulomb& law) {
  if (!law.q.allFinite()) throw std::invalid_argument("coulomb: every charge q must be finite");
}

// Calls pair(i, j, r_j - r_i) for every two particles.
void each_pair(const Coulomb& law, const kinematics::Domain auto& domain, const laws::At<>& at, auto&& pair) {
  if (law.q.size() != at.mass.size())
    throw std::invalid_argument(
        fmt::format("coulomb: q must hold a charge for each of {} particles, got {}", at.mass.size(), law.q.size()));
  for (Eigen::Index i = 0; i < law.q.size(); ++i) {
    for (Eigen::Index j = i + 1; j < law.q.size(); ++j)
      pair(i, j, separation(domain, at.position.row(i), at.position.row(j)));
  }
}

// What i feels towards j is -k q_i q_j/d^2: equal signs repel. Charges that coincide have no force.
bool add_force(const Coulomb& law, const kinematics::Domain auto& domain, const laws::At<>& at, laws::Forces force) {
  each_pair(law, domain, at, [&](Eigen::Index i, Eigen::Index j, const Eigen::Vector3d& towards) {
    const double over_d = -law.k * law.q[i] * law.q[j] / std::pow(towards.norm(), 3);
    force.row(i) += over_d * towards.transpose();
    force.row(j) -= over_d * towards.transpose();
  });
  return force.allFinite();
}

double potential_energy(const Coulomb& law, const kinematics::Domain auto& domain, const laws::At<>& at) {
  double sum = 0.0;
  each_pair(law, domain, at, [&](Eigen::Index i, Eigen::Index j, const Eigen::Vector3d& towards) {
    sum += law.k * law.q[i] * law.q[j] / towards.norm();
  });
  return sum;
}

}  // namespace mine
// [law]

// The accelerations of particles under a law alone; NaN where it has none.
Eigen::VectorXd accelerations(const kinematics::Particles& of, const auto& law) {
  const scenes::Scene scene(of, kinematics::Space{}, law);
  const schemes::State at = scenes::start(scene);
  Eigen::VectorXd a = at.r;
  if (!scene.acceleration(at.t, at.r, a)) a.setConstant(NAN);
  return a;
}

// [use]
int main() {
  const double q = 1e-6, m = 1e-3, d = 0.1, v = 10.0;
  const auto pair =
      kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = m, .radius = 0.0},
                             {.position = {d, 0.0, 0.0}, .velocity = {0.0, v, 0.0}, .mass = m, .radius = 0.0}});
  const mine::Coulomb opposite{.q = Eigen::Vector2d(q, -q)};
  const scenes::Scene scene(pair, kinematics::Space{}, opposite);

  const double strength = opposite.k * q * q, reduced_mass = kinematics::reduced_mass(m, m);
  const double a = 1.0 / (2.0 / d - reduced_mass * v * v / strength);  // half the long axis, from the energy
  const double period = 2.0 * std::numbers::pi * std::sqrt(reduced_mass * a * a * a / strength);

  schemes::State state = scenes::start(scene);
  const double energy = scene.potential_energy(state);
  schemes::RungeKutta4 scheme;
  schemes::FixedStep control{.step = period / 4000.0};
  const schemes::Outcome outcome = schemes::integrate(scene, state, period, scheme, control);
  const double off = (position(state, 1) - position(state, 0) - Eigen::Vector3d(d, 0.0, 0.0)).norm() / d;
  // [use]

  const laws::NearField repulsion{.alpha2 = strength, .beta2 = 2.0, .scaling = laws::Scaling::pair};
  const Eigen::VectorXd near_field = accelerations(pair, repulsion);
  const Eigen::VectorXd equal = accelerations(pair, mine::Coulomb{.q = Eigen::Vector2d(q, q)});
  const double unlike = (equal - near_field).norm() / near_field.norm();
  fmt::print("after a period off by {:.1e} of the distance, equal charges from the near field by {:.1e}\n{}\n", off,
             unlike, describe(outcome));
  const bool right = outcome.status == schemes::Status::reached && off < 1e-9 && unlike < 1e-14 &&
                     std::abs(energy / (-strength / d) - 1.0) < 1e-14;
  return right && std::fflush(stdout) == 0 ? 0 : 1;
}
