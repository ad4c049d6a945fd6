// The ledger of a colliding cloud: kinetic and potential energy, and what contacts took, sum to a constant.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::colliding_cloud_ledger {

using namespace particulate;

using Cloud =
    scenes::Scene<kinematics::Space, laws::NearField, contact::Contact<contact::Restitution, contact::Friction>>;

constexpr double t_end = 1.1;

Cloud cloud_of(const kinematics::Particles& start) {
  return {start,
          {},
          book_near_field,
          {.restitution = {.e_o = 0.8, .v_star = 5.0, .e_minus = 0.1}, .friction = {.mu_s = 0.3, .mu_d = 0.2}}};
}

struct Ledger {
  double residual;  // (T + V + taken) at the end against T + V at the start, over T at the start
  double taken;     // by contacts, over T at the start
  double momentum;  // change over sum m|v|
};

template <class S>
Ledger ledger(const kinematics::Particles& start, long steps) {
  Cloud cloud = cloud_of(start);
  schemes::State state = scenes::start(cloud);
  const double T = kinematics::kinetic_energy(start.mass, start.velocity), V = cloud.potential_energy(state);
  const schemes::Outcome outcome = march<S>(cloud, state, t_end, steps);
  const double T_end = kinematics::kinetic_energy(start.mass, as_rows(state.v)), V_end = cloud.potential_energy(state);
  const Eigen::Vector3d gained = kinematics::linear_momentum(start.mass, as_rows(state.v)) -
                                 kinematics::linear_momentum(start.mass, start.velocity);
  return {.residual = std::abs(T_end + V_end - outcome.energy_change - T - V) / T,
          .taken = -outcome.energy_change / T,
          .momentum = gained.norm() / start.mass.dot(start.velocity.rowwise().norm())};
}

// Impacts act at the end of a step, so every step size makes another history of them and the residual of one cloud
// scatters about its order: it is the root mean square over several clouds that converges.
constexpr std::uint64_t clouds = 16;

template <class S>
Ledger ledger_of_many(std::uint64_t seed, long steps) {
  Ledger all{.residual = 0.0, .taken = std::numeric_limits<double>::infinity(), .momentum = 0.0};
  for (std::uint64_t k = 0; k < clouds; ++k) {
    const Ledger one = ledger<S>(closing_cloud(seed + k, 8, 1.0), steps);
    all.residual += one.residual * one.residual / static_cast<double>(clouds);
    all.taken = std::min(all.taken, one.taken);
    keep_worst(all.momentum, one.momentum);
  }
  all.residual = std::sqrt(all.residual);
  return all;
}

template <class S>
void compare(Rows& rows, std::uint64_t seed, const char* name, const std::vector<long>& steps, double nominal,
             double largest) {
  std::vector<double> h, residuals;
  for (const long n : steps) {
    const Ledger seen = ledger_of_many<S>(seed, n);
    h.push_back(t_end / static_cast<double>(n));
    residuals.push_back(seen.residual);
    rows.at_most(fmt::format("{}, {} steps: largest change of momentum over sum m|v|", name, n),
                 {.limit = 1e-14,
                  .computed = seen.momentum,
                  .because = "one rounding of eps/2 a velocity, step and impulse, adding as a random walk"});
    rows.at_least(fmt::format("{}, {} steps: least energy taken by contacts over T", name, n),
                  {.limit = 0.5, .computed = seen.taken, .because = "a lossless cloud would prove nothing"});
  }
  rows.order(fmt::format("{}: T + V + taken by contacts against T + V at the start, over T, rms of 16 clouds", name),
             {.nominal = nominal,
              .steps = h,
              .errors = residuals,
              .floor = 1e-16,
              .because = "between jumps the scheme's own order; a jump's account is exact at the place where it acts"});
  rows.at_most(fmt::format("{}: the same at the smallest step", name),
               {.limit = largest,
                .computed = residuals.back(),
                .because = "(omega h)^2/12 under Verlet, (omega h)^4/120 under RK4, with omega = 3 rad/s where spheres "
                           "touch, of 28 pairs"});
}

const Case colliding_cloud_ledger{
    {.name = "colliding_cloud_ledger",
     .claim = "T + V + energy taken by contacts is constant to the scheme's order, momentum to rounding, with near "
              "field, friction and restitution that falls",
     .equation = "D 2.22",
     .reference = Reference::convergence},
    [](Rows& rows) {
      compare<schemes::VelocityVerlet>(rows, rows.case_seed(), "velocity Verlet", {200, 400, 800, 1600, 3200}, 2.0,
                                       2.5e-6);
      compare<schemes::RungeKutta4>(rows, rows.case_seed(), "RK4", {50, 75, 112, 168, 252}, 4.0, 1e-8);
    }};

}  // namespace verification::colliding_cloud_ledger
