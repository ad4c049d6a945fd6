// Extreme cases that must give an answer.

#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "quadrature.hpp"
#include "references.hpp"

namespace verification::extremes_solved {

using namespace particulate;

NearFieldScene free_flight(Eigen::Index N) { return {random_cloud({.N = N}, 1), {}, {.alpha1 = 0.5, .alpha2 = 0.25}}; }

// A scene with one particle or none: uniform motion, no energy but its own, no moment.
Ending fly_free(Eigen::Index N) {
  NearFieldScene scene = free_flight(N);
  double worst = 0.0;
  const schemes::State start = scenes::start(scene);
  const auto fly = [&](const auto& move) {
    schemes::State state = start;
    move(state);
    const Eigen::VectorXd expected = start.r + 2.0 * start.v;
    worst = std::max(
        {worst, std::abs(state.t - 2.0), (state.r - expected).cwiseAbs().sum(), (state.v - start.v).cwiseAbs().sum()});
  };
  fly([&](schemes::State& state) { advance<schemes::RungeKutta4>(scene, state, 2.0, 8); });
  fly([&](schemes::State& state) { advance<schemes::VelocityVerlet>(scene, state, 2.0, 8); });
  if (N > 0) fly([&](schemes::State& state) { advance_by(adams, scene, state, 2.0); });
  worst = std::max({worst, std::abs(scene.potential_energy(start)), std::abs(scene.distance(start.r, start.r))});
  return Ending::solved(
      {.error = worst, .tolerance = 1e-14, .because = "uniform motion, a few roundings of values near 1"});
}

// Momenta and energy of nothing are nothing.
Ending sum_nothing() {
  const kinematics::Particles none = random_cloud({.N = 0}, 1);
  validate(none);
  const double sum = kinematics::kinetic_energy(none.mass, none.velocity) +
                     kinematics::linear_momentum(none.mass, none.velocity).norm() +
                     kinematics::angular_momentum(none.mass, none.position, none.velocity).norm();
  return Ending::solved({.error = std::abs(sum), .tolerance = 0.0, .because = "empty sums are zero"});
}

// The breathing pair over three periods; errors in units of what is allowed.
template <class Move>
Ending breathe(const kinematics::Particles& start, const ExactBreathing& exact, double alpha1, const Allowed& allowed,
               const Move& move) {
  NearFieldScene scene(start, {}, {.alpha1 = alpha1, .alpha2 = alpha1 / exact.depth(), .beta1 = 2.0, .beta2 = 3.0});
  const BreathingErrors worst =
      errors_at_tenths(exact, pair_shape(start.mass[0], start.mass[1]), scenes::start(scene), 30,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  return Ending::solved(
      {.error = std::max(worst.position / allowed.errors.position, worst.velocity / allowed.errors.velocity),
       .tolerance = 1.0,
       .because = "in units of " + allowed.because});
}

// Masses whose attraction is A = 2 whatever they are, by RK4.
Ending breathe_by_rk4(double m_i, double radius) {
  kinematics::Particles start = pair_at_rest(m_i, 1.0, 1.0);
  start.radius << radius, (radius > 0.0 ? 1.0 - radius : 0.0);
  const ExactBreathing exact{.force = {.A = 2.0, .B = 1.0}, .r_0 = 1.0};
  return breathe(start, exact, 2.0 / (m_i + 1.0), allowed_to_steps(exact, 4, exact.motion.period() / 5000.0),
                 [](auto& scene, schemes::State& state, double t_end) {
                   advance<schemes::RungeKutta4>(scene, state, t_end, 500);
                 });
}

Ending breathe_stiffly(const reference::Method& method, double global) {
  const ExactBreathing exact{.force = kinematics::breathing_pair(1.0, 0.001, 1.0, 1.0), .r_0 = 1.0};
  return breathe(pair_at_rest(1.0, 1.0, 1.0), exact, 1.0, allowed_to_tolerance(exact, global),
                 [&](auto& scene, schemes::State& state, double t_end) { advance_by(method, scene, state, t_end); });
}

// A pair under extreme exponents: inner turning point and period against its energy.
Ending steep(const kinematics::CentralForce& law, double start, long double inside, double step) {
  const ReleasedPair by_energy{.law = law, .reduced_mass = 0.5L, .start = start};
  const long double near = by_energy.nearest(inside, equilibrium_distance(law));
  const auto period = static_cast<double>(by_energy.period(near, 2000));
  NearFieldScene scene(pair_at_rest(1.0, 1.0, start), {},
                       {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2});
  const std::vector<Turning> found = turnings<schemes::RungeKutta4>(scene, scenes::start(scene), step, 2);
  // The pair's own frequency where its force is largest: V''(r_min)/m*.
  const double omega = std::sqrt(2.0 * normal_stiffness(law, static_cast<double>(near)));
  const double tolerance = 4.0 * std::pow(omega * step, 4) / 120.0 + 1e-11;
  const double error =
      std::max(std::abs(found[0].distance / static_cast<double>(near) - 1.0), std::abs(found[1].t / period - 1.0));
  return Ending::solved(
      {.error = error,
       .tolerance = tolerance,
       .because = "two passages of r_min, two radians each, with (omega h)^4/120 a radian, and 1e-11 of rounding: "
                  "powers 30 times larger than their difference"});
}

// The force is 1e-300 N: straight lines.
Ending far_apart() {
  kinematics::Particles start = pair_at_rest(1.0, 1.0, 1e150);
  kinematics::set_vector(start.velocity, 1, {1.0, 0.0, 0.0});
  NearFieldScene scene(start, {}, {.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 3.0});
  schemes::State state = scenes::start(scene);
  const schemes::State before = state;
  advance<schemes::RungeKutta4>(scene, state, 1.0, 4);
  return Ending::solved({.error = (state.v - before.v).cwiseAbs().maxCoeff(),
                         .tolerance = 1e-299,
                         .because = "1e-300 N on 1 kg for 1 s"});
}

const Case extremes_solved{
    {.name = "extremes_solved",
     .claim = "no particle, one, two just touching, masses, stiffness and exponents at their limits: all get an answer",
     .equation = "M 2.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.must_be_solved("no particle, motion", [] { return fly_free(0); });
      rows.must_be_solved("no particle, sums", sum_nothing);
      rows.must_be_solved("one particle", [] { return fly_free(1); });
      rows.must_be_solved("two particles just touching", [] { return breathe_by_rk4(1.0, 0.25); });
      rows.must_be_solved("two particles 1e150 m apart", far_apart);
      for (const double m_i : {1e12, 1e-12}) {
        rows.must_be_solved(fmt::format("mass ratio {}", m_i), [=] { return breathe_by_rk4(m_i, 0.0); });
      }
      rows.must_be_solved("alpha2 = 0.001, ARKODE Fehlberg 13(7,8)",
                          [] { return breathe_stiffly(fehlberg, global_of_runge_kutta); });
      rows.must_be_solved("alpha2 = 0.001, CVODE Adams", [] { return breathe_stiffly(adams, global_of_adams); });
      rows.must_be_solved("beta = (7, 13)", [] {
        return steep({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 7.0, .beta2 = 13.0}, 1.5, 0.5L, 1e-4);
      });
      rows.must_be_solved("beta = (0, 13)", [] {
        return steep({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 0.0, .beta2 = 13.0}, 1.5, 0.5L, 1e-4);
      });
      rows.must_be_solved("beta = (12.5, 12.9)", [] {
        return steep({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 12.5, .beta2 = 12.9}, 1.2, 0.5L, 1e-4);
      });
    }};

}  // namespace verification::extremes_solved
