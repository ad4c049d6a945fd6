// Rings of members about their target, and how they leave the plane of the ring.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/swarm/target.hpp>

namespace verification::ring {

using namespace particulate;

constexpr double a = 3.0, b = 0.5, mass = 2.0;  // attraction a d [N], repulsion b/d [N]
const Eigen::Vector3d target{1.0, -2.0, 0.0};

// R^2 = b (N - 1)/(2 a): of the repulsion by the member k places on, b/(2 R sin(pi k/N)) times sin(pi k/N) points away
// from the middle, the same for every k.
auto ring_of(Eigen::Index N) {
  const double R = std::sqrt(b * static_cast<double>(N - 1) / (2.0 * a));
  kinematics::Particles ring{.position = kinematics::Vectors(N, 3),
                             .velocity = kinematics::Vectors::Zero(N, 3),
                             .mass = Eigen::VectorXd::Constant(N, mass),
                             .radius = Eigen::VectorXd::Zero(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(N);
    ring.position.row(i) = target.transpose() + R * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0.0);
  }
  const laws::NearField repulsion{
      .alpha1 = 0.0, .alpha2 = b, .beta1 = 1.0, .beta2 = 1.0, .scaling = laws::Scaling::pair};
  return scenes::Scene(ring, kinematics::Space{}, repulsion,
                       swarm::Target{.place = target, .alpha = a / mass, .beta = 1.0});
}

const Case equilibrium{{.name = "ring_equilibrium",
                        .claim = "members that a target pulls by a d and that repel each other by b/d rest on a ring "
                                 "of radius sqrt(b (N - 1)/(2 a))",
                        .equation = "D 6.1",
                        .reference = Reference::closed_form},
                       [](Rows& rows) {
                         for (const Eigen::Index N : {2, 3, 4, 7, 16, 33, 128}) {
                           const auto scene = ring_of(N);
                           const schemes::State state = scenes::start(scene);
                           Eigen::VectorXd force(3 * N);
                           const bool has_value = scene.total_force(state, force);
                           const double pull = std::sqrt(a * b * static_cast<double>(N - 1) / 2.0);
                           rows.at_most(fmt::format("N = {}: largest force over the target's pull", N),
                                        {.limit = 2e-14,
                                         .computed = has_value ? force.lpNorm<Eigen::Infinity>() / pull : missing,
                                         .because = "rounding of places 2 m from the origin, and of the sums"});
                         }
                       }};

// z_i = amplitude cos(2 pi m i/N) has the stiffness a [1 - m (N - m)/(N - 1)], because sum_k sin^2(pi m k/N)/sin^2(pi
// k/N) = m (N - m). Where it is negative the amplitude grows as cosh(rate t), else it swings as cos(rate t).
double amplitude_after(Eigen::Index N, Eigen::Index m, double t_end) {
  constexpr double amplitude = 1e-6;
  const auto scene = ring_of(N);
  schemes::State state = scenes::start(scene);
  Eigen::VectorXd mode(N);
  for (Eigen::Index i = 0; i < N; ++i) {
    mode[i] = std::cos(2.0 * std::numbers::pi * static_cast<double>(m * i) / static_cast<double>(N));
  }
  state.r.tail(N) += amplitude * mode;
  advance<schemes::RungeKutta4>(scene, state, t_end, 1000);
  return mode.dot(state.r.tail(N)) / mode.squaredNorm() / amplitude;
}

void compare_mode(Rows& rows, Eigen::Index N, Eigen::Index m) {
  const double stiffness = a * (1.0 - static_cast<double>(m * (N - m)) / static_cast<double>(N - 1));
  const double rate = std::sqrt(std::abs(stiffness) / mass), t_end = 1.0;
  const double after = amplitude_after(N, m, t_end);
  const std::string mode = fmt::format("N = {}, mode {}", N, m);
  const char* because =
      "amplitudes of 1e-6 leave a linear motion but for 1e-12; places round by 1e-16, a 1e-10th of them, in each of "
      "1000 steps";
  if (std::abs(stiffness) < 1e-12) {
    rows.compare(mode + ": amplitude after 1 s",
                 {.expected = 1.0, .computed = after, .tolerance = relative(1e-9), .because = because});
    return;
  }
  rows.compare(mode + (stiffness < 0.0 ? ": rate of growth [1/s]" : ": rate of its swing [1/s]"),
               {.expected = rate,
                .computed = (stiffness < 0.0 ? std::acosh(after) : std::acos(after)) / t_end,
                .tolerance = relative(1e-9),
                .because = because});
}

const Case modes{{.name = "ring_modes",
                  .claim = "out of its plane a ring of 4 members or more is unstable: mode m has the stiffness a [1 - "
                           "m (N - m)/(N - 1)]",
                  .equation = "D 6.1",
                  .reference = Reference::closed_form},
                 [](Rows& rows) {
                   for (const Eigen::Index N : {3, 4, 5, 8}) {
                     for (Eigen::Index m = 0; m <= N / 2; ++m) compare_mode(rows, N, m);
                   }
                 }};

}  // namespace verification::ring
