// A breathing pair that also turns: its angular momentum stiffens the repulsion.

#include <cmath>

#include <Eigen/Geometry>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <harness/turning_pair.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "references.hpp"

namespace verification::breathing_rotating {

using namespace particulate;

// A = 4, B = 0.25 * 4 + 1.5^2 = 3.25, 2|E| = 8 - 3.25 = 4.75, a = 4/4.75 = 16/19.
constexpr double period = 2.427724746595934;
constexpr double r_min = 3.25 / 4.75;

// Errors of the separation's length, its rate and its angle against the closed form.
struct Errors {
  double distance = 0.0, rate = 0.0, angle = 0.0;
};

template <class Move>
Errors errors_at_tenths(const kinematics::Breathing& exact, const Move& move) {
  NearFieldScene scene = turning::pair();
  schemes::State state = scenes::start(scene);
  Errors worst;
  double phi = 0.0;
  for (int k = 1; k <= 30; ++k) {
    move(scene, state, exact.period() * k / 10.0);
    phi += turning::turned(exact, k);
    const kinematics::Radial at = exact.at(state.t);
    const Eigen::Vector3d r = (rows_of(state.r).row(1) - rows_of(state.r).row(0)).transpose();
    const Eigen::Vector3d expected = std::cos(phi) * slanted() + std::sin(phi) * turning::across();
    worst.distance = std::max(worst.distance, std::abs(r.norm() - at.r));
    worst.rate = std::max(worst.rate, std::abs(parting(state) / r.norm() - at.v));
    worst.angle = std::max(worst.angle, (r.normalized() - expected).norm());
  }
  return worst;
}

// A shift in time by a share of the period moves the distance, its rate and the angle at their largest rates.
template <class Move>
void compare(Rows& rows, const std::string& method, double share, const std::string& because, const Move& move) {
  const ExactBreathing exact{.force = turning::force(), .r_0 = 1.0};
  const Errors worst = errors_at_tenths(exact.motion, move);
  const double dt = share * period;
  rows.at_most("distance [m], " + method,
               {.limit = dt * exact.largest_speed(), .computed = worst.distance, .because = because});
  rows.at_most("its rate [m/s], " + method,
               {.limit = dt * exact.largest_acceleration(), .computed = worst.rate, .because = because});
  rows.at_most("angle [rad], " + method,
               {.limit = dt * turning::l_z / (r_min * r_min), .computed = worst.angle, .because = because});
}

const Case breathing_rotating{
    {.name = "breathing_rotating",
     .claim =
         "angular momentum adds Lz^2/m* to the pair's alpha2, and the radial period is that of a pair at rest with it",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Breathing exact(turning::force(), 1.0);
      rows.compare("radial period [s]", {.expected = period,
                                         .computed = exact.period(),
                                         .tolerance = relative(4e-16),
                                         .because = "A and B are exact here"});
      rows.compare("r_min [m]", {.expected = r_min,
                                 .computed = exact.nearest(),
                                 .tolerance = relative(4e-16),
                                 .because = "A and B are exact here"});

      // Lz = m* l_z with m* = 3/4, about slanted() x across().
      const NearFieldScene scene = turning::pair();
      const Eigen::Vector3d expected = 0.75 * turning::l_z * slanted().cross(turning::across());
      const Eigen::Vector3d computed =
          kinematics::angular_momentum(scene.particles().mass, scene.particles().position, scene.particles().velocity);
      rows.at_most("error of the start's angular momentum [kg m^2/s]",
                   {.limit = 5e-16, .computed = (computed - expected).norm(), .because = "products near 1, rounded"});
      // (omega h)^4/120 over 6 radians, with 4.4/s along and 3.2/s around at r_min: 5.5/s, h = 4.9e-4 s.
      compare(rows, "RK4", 4e-12,
              "5.5/s at r_min times h = 4.9e-4 s gives 3e-12 in three periods, and 1e-12 of rounding",
              [](auto& moving, schemes::State& state, double t_end) {
                advance<schemes::RungeKutta4>(moving, state, t_end, 500);
              });
      compare(rows, "CVODE Adams", global_of_adams, "its global error with a tolerance of 1e-14",
              [](auto& moving, schemes::State& state, double t_end) { advance_by(adams, moving, state, t_end); });
    }};

}  // namespace verification::breathing_rotating
