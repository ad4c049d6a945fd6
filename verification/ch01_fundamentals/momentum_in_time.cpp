// Momenta of a cloud in time: what each scheme keeps to rounding, and what it keeps to its order.

#include <algorithm>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::momentum_in_time {

using namespace particulate;

constexpr double t_end = 3.7;

// Largest change of both momenta over a run, over sum m |v| and sum m |r||v| at the start.
struct Drift {
  double linear = 0.0, angular = 0.0;
};

template <class S>
Drift drift(NearFieldScene& scene, long steps) {
  const kinematics::Particles& start = scene.particles();
  const Eigen::VectorXd size = start.mass.cwiseProduct(start.velocity.rowwise().norm());
  const Eigen::Vector3d G = kinematics::linear_momentum(start.mass, start.velocity);
  const Eigen::Vector3d H = kinematics::angular_momentum(start.mass, start.position, start.velocity);
  Drift worst;
  for (const schemes::State& at : path<S>(scene, scenes::start(scene), t_end, steps)) {
    const Eigen::Vector3d G_t = kinematics::linear_momentum(start.mass, rows_of(at.v));
    const Eigen::Vector3d H_t = kinematics::angular_momentum(start.mass, rows_of(at.r), rows_of(at.v));
    worst.linear = std::max(worst.linear, (G_t - G).norm() / size.sum());
    worst.angular = std::max(worst.angular, (H_t - H).norm() / start.position.rowwise().norm().dot(size));
  }
  return worst;
}

// The drift at the end time of a close pair, where RK4's truncation stands clear of rounding.
std::vector<double> angular_drifts(const std::vector<double>& steps) {
  kinematics::Particles start = pair_at_rest(1.0, 3.0, 1.0);
  kinematics::set_vector(start.velocity, 1, {0.6, -1.2, 0.4});
  NearFieldScene scene(start, {}, {.alpha1 = 1.0, .alpha2 = 0.25, .beta1 = 2.0, .beta2 = 3.0});
  const Eigen::Vector3d H = kinematics::angular_momentum(start.mass, start.position, start.velocity);
  std::vector<double> drifts;
  for (const double step : steps) {
    schemes::State state = scenes::start(scene);
    advance<schemes::RungeKutta4>(scene, state, t_end, std::lround(t_end / step));
    drifts.push_back((kinematics::angular_momentum(start.mass, rows_of(state.r), rows_of(state.v)) - H).norm() /
                     H.norm());
  }
  return drifts;
}

const Case momentum_in_time{
    {.name = "momentum_in_time",
     .claim = "near fields keep linear momentum to rounding under any scheme, and angular momentum to rounding under "
              "Verlet, to its order under RK4",
     .equation = "M 1.39",
     .reference = Reference::identity},
    [](Rows& rows) {
      NearFieldScene scene(random_cloud({.N = 20}, rows.case_seed()), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
      const long steps = 1000;
      const Drift rk4 = drift<schemes::RungeKutta4>(scene, steps);
      const Drift verlet = drift<schemes::VelocityVerlet>(scene, steps);
      const char* const because =
          "1000 steps, each rounding 60 velocities of a few times the start's by eps/2 = 1e-16, "
          "add as a random walk to some 1e-14";
      rows.at_most("linear momentum over sum m|v|, RK4", {.limit = 5e-14, .computed = rk4.linear, .because = because});
      rows.at_most("linear momentum over sum m|v|, velocity Verlet",
                   {.limit = 5e-14, .computed = verlet.linear, .because = because});
      rows.at_most(
          "angular momentum over sum m|r||v|, velocity Verlet",
          {.limit = 5e-14,
           .computed = verlet.angular,
           .because = "each half of a Verlet step conserves it under central pair forces; roundings as above"});

      std::vector<double> h;
      for (long n = 60; n <= 960; n *= 2) h.push_back(t_end / static_cast<double>(n));
      const std::vector<double> drifts = angular_drifts(h);
      rows.order("angular momentum at t = 3.7 s, RK4, a turning pair",
                 {.nominal = 5.0,
                  .steps = h,
                  .errors = drifts,
                  .floor = 1e-15,
                  .because = "RK4 keeps quadratic invariants one order better than itself: in extended precision one "
                             "step's error falls as h^6, for two bodies and for three"});
    }};

}  // namespace verification::momentum_in_time
