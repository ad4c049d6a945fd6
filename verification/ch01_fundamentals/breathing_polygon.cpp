// Equal bodies at the corners of a regular polygon breathe as one.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "references.hpp"

namespace verification::breathing_polygon {

using namespace particulate;

constexpr double alpha2 = 0.5;

ExactBreathing exact_polygon(int N) {
  return {.force = kinematics::breathing_body(1.0, alpha2, 1.0, kinematics::regular_polygon(N)), .r_0 = 1.0};
}

// A = (alpha1/4) sum csc(pi k/N), B = (alpha2/8)(N^2 - 1)/3.
void compare_constants(Rows& rows, int N) {
  long double cosecants = 0.0L;
  for (int k = 1; k < N; ++k) cosecants += 1.0L / std::sin(std::numbers::pi_v<long double> * k / N);
  const kinematics::RadialForce force = exact_polygon(N).force;
  const char* const because = "corners rounded to eps/2 see N - 1 chords";
  rows.compare(fmt::format("A [m^3/s^2], N = {}", N), {.expected = static_cast<double>(0.25L * cosecants),
                                                       .computed = force.A,
                                                       .tolerance = relative(4e-15),
                                                       .because = because});
  rows.compare(
      fmt::format("B [m^4/s^2], N = {}", N),
      {.expected = alpha2 / 24.0 * (N * N - 1), .computed = force.B, .tolerance = relative(4e-15), .because = because});
}

// The motion is unstable: what rounding puts across it grows about a thousandfold a period.
Allowed with_growth(Allowed allowed, int periods) {
  const double grown = 1e-15 * std::pow(1e3, periods);
  allowed.errors.position += grown;
  allowed.errors.velocity += grown;
  allowed.because += fmt::format("; rounding grown to {:g}", grown);
  return allowed;
}

template <class Move>
void compare_run(Rows& rows, int N, const std::string& method, int periods, const Allowed& allowed, const Move& move) {
  const kinematics::Vectors corners = kinematics::regular_polygon(N);
  NearFieldScene scene(at_rest(corners, 1.0, Eigen::VectorXd::Ones(N)), {},
                       {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0});
  const BreathingErrors worst =
      errors_at_tenths(exact_polygon(N), corners, scenes::start(scene), 10 * periods,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  compare_errors(rows, fmt::format(" at {} tenths of a period, {}, N = {}", 10 * periods, method, N), worst,
                 with_growth(allowed, periods));
}

void compare_runs(Rows& rows, int N, int periods) {
  const ExactBreathing exact = exact_polygon(N);
  compare_run(rows, N, "RK4", periods, allowed_to_steps(exact, 4, exact.motion.period() / 5000.0),
              [](auto& scene, schemes::State& state, double t_end) {
                advance<schemes::RungeKutta4>(scene, state, t_end, 500);
              });
  compare_run(rows, N, "ARKODE Fehlberg 13(7,8)", periods, allowed_to_tolerance(exact, global_of_runge_kutta),
              [](auto& scene, schemes::State& state, double t_end) { advance_by(fehlberg, scene, state, t_end); });
  compare_run(rows, N, "CVODE Adams", periods, allowed_to_tolerance(exact, global_of_adams),
              [](auto& scene, schemes::State& state, double t_end) { advance_by(adams, scene, state, t_end); });
}

const Case breathing_polygon{
    {.name = "breathing_polygon",
     .claim = "regular polygons of equal bodies breathe with R'' = -A/R^2 + B/R^3",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const int N : {2, 3, 4, 5, 6, 7, 12}) compare_constants(rows, N);
      for (const auto& [N, period] : {std::pair{3, 3.693698908296404}, {5, 2.557674818374453}}) {
        rows.compare(fmt::format("period [s], N = {}", N),
                     {.expected = period,
                      .computed = exact_polygon(N).motion.period(),
                      .tolerance = relative(2e-15),
                      .because = "A and B to some eps, 16 digits of the reference"});
      }
      for (const int N : {3, 5, 7}) {
        for (const int periods : {1, 2}) compare_runs(rows, N, periods);
      }
    }};

}  // namespace verification::breathing_polygon
