// A law of one's own beside the library's: a harmonic trap that holds a cloud together. Whatever the particles do to
// one another, their centre of mass then swings like a single body, r_cm = r_0 cos(w t) + (v_0/w) sin(w t).

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <fmt/core.h>

#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>

using namespace particulate;

// [law]
namespace mine {

struct Trap {
  double rate = 1.0;  // angular frequency of one particle alone in the trap [1/s]
};

void validate(const Trap& trap) {
  if (!(trap.rate > 0.0)) throw std::invalid_argument(fmt::format("trap: rate must be positive, got {}", trap.rate));
}

template <kinematics::Domain D>
bool add_force(const Trap& trap, const D& domain, const laws::At<>& at, laws::Forces force) {
  const Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Eigen::Vector3d towards = separation(domain, at.position.row(i), centre);
    force.row(i) += at.mass[i] * trap.rate * trap.rate * towards.transpose();
  }
  return true;
}

template <kinematics::Domain D>
double potential_energy(const Trap& trap, const D& domain, const laws::At<>& at) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Eigen::Vector3d away = separation(domain, Eigen::Vector3d::Zero(), at.position.row(i));
    sum += 0.5 * at.mass[i] * trap.rate * trap.rate * away.squaredNorm();
  }
  return sum;
}

}  // namespace mine
// [law]

// [use]
int main() {
  const auto cloud =
      kinematics::particles({{.position = {1.0, 0.0, 0.0}, .velocity = {0.0, 1.0, 0.0}, .mass = 1.0, .radius = 0.0},
                             {.position = {2.0, 0.5, 0.0}, .velocity = {0.0, 0.0, 0.5}, .mass = 2.0, .radius = 0.0},
                             {.position = {1.5, 0.0, 1.0}, .velocity = {0.2, 0.0, 0.0}, .mass = 3.0, .radius = 0.0}});
  const mine::Trap trap{.rate = 2.0};
  const laws::NearField near_field{.alpha1 = 0.5, .alpha2 = 0.25};
  const scenes::Scene scene(cloud, kinematics::Space{}, near_field, trap);

  const double t = 2.9;  // no multiple of a period
  schemes::State state = scenes::start(scene);
  schemes::RungeKutta4 scheme;
  schemes::FixedStep control{.step = 1e-3};
  const auto energy = [&] {
    return scene.potential_energy(state) + kinematics::kinetic_energy(cloud.mass, velocities(state));
  };
  const double energy_before = energy();
  const schemes::Outcome outcome = schemes::integrate(scene, state, t, scheme, control);

  const Eigen::Vector3d r_0 = kinematics::centre_of_mass(cloud.mass, cloud.position);
  const Eigen::Vector3d v_0 = kinematics::centre_of_mass(cloud.mass, cloud.velocity);
  const Eigen::Vector3d swung = r_0 * std::cos(trap.rate * t) + v_0 / trap.rate * std::sin(trap.rate * t);
  const double error = (kinematics::centre_of_mass(cloud.mass, positions(state)) - swung).norm();
  const double gained = energy() - energy_before;
  fmt::print("centre of mass off by {:.1e} m, energy by {:.1e} J\n{}\n", error, gained, describe(outcome));

  // A fixed step of order 4: (w dt)^4 = 1.6e-11 a unit of time. The pair forces bend faster than the trap.
  const bool right = outcome.status == schemes::Status::reached && error < 1e-11 && std::abs(gained) < 1e-8;
  return right && std::fflush(stdout) == 0 ? 0 : 1;
}
// [use]
