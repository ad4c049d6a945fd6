// Motions with a closed form, by adaptive Gauss collocation.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <harness/turning_pair.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

#include "linear_problems.hpp"

namespace verification::collocation_exact_motions {

using namespace particulate;

// One setting for all: no case is tuned.
constexpr double TOL = 1e-11, sweep_TOL = 1e-14;
constexpr double goal = 1e-10;  // of the farthest place, of the largest speed

// One run whose legs end at the tenths of a period.
struct Mover {
  schemes::Collocation<schemes::Gauss<8>> scheme = schemes::Collocation<schemes::Gauss<8>>();
  schemes::ErrorControl control;
  long evaluations = 0;

  explicit Mover(double period)
      : control{.TOL = TOL, .sweep_TOL = sweep_TOL, .step = period / 1000.0, .limit = period / 10.0} {}

  void operator()(NearFieldScene& scene, schemes::State& state, double t_end) {
    const schemes::Outcome out = integrate(scene, state, t_end, scheme, control);
    require_reached(out);
    evaluations += out.evaluations;
  }
};

// Errors of a breathing body at tenths of a period, those of the passages at the inner turning point apart.
struct Seen {
  BreathingErrors elsewhere, passing;
  long evaluations = 0;
};

Seen follow(const ExactBreathing& exact, NearFieldScene& scene, const kinematics::Vectors& shape, int tenths) {
  const double period = exact.motion.period();
  Mover move(period);
  schemes::State state = scenes::start(scene);
  Seen seen;
  for (int k = 1; k <= tenths; ++k) {
    move(scene, state, period * k / 10.0);
    compare_with(exact, shape, state, k % 10 == 5 ? seen.passing : seen.elsewhere);
  }
  seen.evaluations = move.evaluations;
  return seen;
}

void write(Rows& rows, const std::string& which, const ExactBreathing& exact, const Seen& seen) {
  const char* const asked = "the catalogue's goal";
  rows.at_most("positions over the farthest place, " + which,
               {.limit = goal, .computed = std::max(seen.elsewhere.position, seen.passing.position), .because = asked});
  rows.at_most("velocities over the largest speed, " + which,
               {.limit = goal, .computed = seen.elsewhere.velocity, .because = asked});
  const double shift = 1e-14 * exact.depth() * exact.motion.period();
  const double stands = shift * exact.largest_acceleration() / exact.largest_speed();
  rows.at_most("velocities over the largest speed at the inner turning point, " + which,
               {.limit = std::max(goal, stands),
                .computed = seen.passing.velocity,
                .because = fmt::format("the goal, or what a shift of the motion by {:.1g} s makes there: fifty "
                                       "roundings of energies {:.2g} times the total change the period by as much",
                                       shift, exact.depth())});
}

void compare_pair(Rows& rows, double m_i, double m_j, double alpha1, double alpha2) {
  const ExactBreathing exact{.force = kinematics::breathing_pair(alpha1, alpha2, m_i, m_j), .r_0 = 1.0};
  NearFieldScene scene(pair_at_rest(m_i, m_j, 1.0), {},
                       {.alpha1 = alpha1, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0});
  const std::string which = fmt::format("masses {:g} and {:g}, alpha2 = {:.3g}", m_i, m_j, alpha2);
  write(rows, which, exact, follow(exact, scene, pair_shape(m_i, m_j), 30));
}

const Case collocation_breathing_pair{
    {.name = "collocation_breathing_pair",
     .claim = "adaptive Gauss collocation keeps breathing pairs of any stiffness and any masses within 1e-10 of "
              "Kepler's equation at thirty tenths of a period",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double alpha2 : {0.5, 0.1, 0.01, 0.001}) compare_pair(rows, 1.0, 1.0, 1.0, alpha2);
      compare_pair(rows, 1.0, 3.0, 1.0, 0.5);
      compare_pair(rows, 0.07, 0.01, 50.0, 25.0);
      compare_pair(rows, 1.0, 1e12, 4.0 / (1e12 + 1.0), 2.0 / (1e12 + 1.0));
    }};

const Case collocation_breathing_polygon{
    {.name = "collocation_breathing_polygon",
     .claim = "adaptive Gauss collocation keeps breathing polygons within 1e-10 of R'' = -A/R^2 + B/R^3 at twenty "
              "tenths of a period, though they are unstable",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const int N : {3, 5}) {
        const kinematics::Vectors corners = kinematics::regular_polygon(N);
        const ExactBreathing exact{.force = kinematics::breathing_body(1.0, 0.5, 1.0, corners), .r_0 = 1.0};
        NearFieldScene scene(at_rest(corners, 1.0, Eigen::VectorXd::Ones(N)), {},
                             {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0});
        write(rows, fmt::format("N = {}", N), exact, follow(exact, scene, corners, 20));
      }
    }};

// Body 1 seen from body 0, and its velocity, at an angle phi = int l_z/r^2 dt that has been integrated apart.
void compare_turned(const kinematics::Radial& at, double phi, const schemes::State& state, double fastest,
                    BreathingErrors& worst) {
  const Eigen::Vector3d along = std::cos(phi) * slanted() + std::sin(phi) * turning::across();
  const Eigen::Vector3d around = std::cos(phi) * turning::across() - std::sin(phi) * slanted();
  const Eigen::Vector3d r = (rows_of(state.r).row(1) - rows_of(state.r).row(0)).transpose();
  const Eigen::Vector3d v = (rows_of(state.v).row(1) - rows_of(state.v).row(0)).transpose();
  keep_worst(worst.position, (r - at.r * along).norm());
  keep_worst(worst.velocity, (v - at.v * along - turning::l_z / at.r * around).norm() / fastest);
}

const Case collocation_rotating_pair{
    {.name = "collocation_rotating_pair",
     .claim = "adaptive Gauss collocation keeps a breathing pair that turns within 1e-10 of its closed form",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Breathing exact(turning::force(), 1.0);
      NearFieldScene scene = turning::pair();
      schemes::State state = scenes::start(scene);
      Mover move(exact.period());
      BreathingErrors worst;
      double phi = 0.0;
      const double fastest = turning::l_z / exact.nearest();  // around, where there is no speed along
      for (int k = 1; k <= 30; ++k) {
        move(scene, state, exact.period() * k / 10.0);
        phi += turning::turned(exact, k);
        compare_turned(exact.at(state.t), phi, state, fastest, worst);
      }
      const char* const asked = "the catalogue's goal";
      rows.at_most("separation over the largest [-]", {.limit = goal, .computed = worst.position, .because = asked});
      rows.at_most("its velocity over the largest [-]", {.limit = goal, .computed = worst.velocity, .because = asked});
    }};

}  // namespace verification::collocation_exact_motions
