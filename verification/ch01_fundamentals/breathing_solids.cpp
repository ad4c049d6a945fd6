// Equal bodies at the corners of the five regular solids breathe as one.

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "references.hpp"

namespace verification::breathing_solids {

using namespace particulate;

constexpr double alpha1 = 1.0, alpha2 = 0.5;

// How many of the other corners lie at the square of which chord, on the unit sphere. Squares follow from the cosines
// of the angles between corners: 2 - 2 cos.
struct Chords {
  int count;
  double square;
};
struct Solid {
  int faces;
  std::vector<Chords> seen;
};

std::vector<Solid> solids() {
  const double sqrt5 = std::sqrt(5.0);
  return {
      {.faces = 4, .seen = {{3, 8.0 / 3.0}}},
      {.faces = 6, .seen = {{3, 4.0 / 3.0}, {3, 8.0 / 3.0}, {1, 4.0}}},
      {.faces = 8, .seen = {{4, 2.0}, {1, 4.0}}},
      {.faces = 12,
       .seen = {{3, 2.0 - 2.0 * sqrt5 / 3.0}, {6, 4.0 / 3.0}, {6, 8.0 / 3.0}, {3, 2.0 + 2.0 * sqrt5 / 3.0}, {1, 4.0}}},
      {.faces = 20, .seen = {{5, 2.0 - 2.0 / sqrt5}, {5, 2.0 + 2.0 / sqrt5}, {1, 4.0}}}};
}

// Each chord pulls with C(R s) along itself, of which s/2 is radial: A = sum s^-2 s/2, B = alpha2 sum s^-3 s/2.
kinematics::RadialForce from_chords(const Solid& solid) {
  kinematics::RadialForce force;
  for (const Chords& chords : solid.seen) {
    force.A += alpha1 * chords.count * 0.5 / std::sqrt(chords.square);
    force.B += alpha2 * chords.count * 0.5 / chords.square;
  }
  return force;
}

template <class Move>
void compare_run(Rows& rows, const Solid& solid, const std::string& method, const Allowed& allowed, const Move& move) {
  const kinematics::Vectors corners = kinematics::regular_solid(solid.faces);
  NearFieldScene scene(at_rest(corners, 1.0, Eigen::VectorXd::Ones(corners.rows())), {},
                       {.alpha1 = alpha1, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0});
  // One period, because the motion is unstable.
  const BreathingErrors worst =
      errors_at_tenths({.force = from_chords(solid), .r_0 = 1.0}, corners, scenes::start(scene), 10,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  compare_errors(rows, fmt::format(" at ten tenths of a period, {}, {} faces", method, solid.faces), worst, allowed);
}

void compare_runs(Rows& rows, const Solid& solid) {
  const ExactBreathing exact{.force = from_chords(solid), .r_0 = 1.0};
  compare_run(rows, solid, "RK4", allowed_to_steps(exact, 4, exact.motion.period() / 5000.0),
              [](auto& scene, schemes::State& state, double t_end) {
                advance<schemes::RungeKutta4>(scene, state, t_end, 500);
              });
  compare_run(rows, solid, "ARKODE Fehlberg 13(7,8)", allowed_to_tolerance(exact, global_of_runge_kutta),
              [](auto& scene, schemes::State& state, double t_end) { advance_by(fehlberg, scene, state, t_end); });
}

const Case breathing_solids{
    {.name = "breathing_solids",
     .claim = "regular solids of equal bodies breathe with R'' = -A/R^2 + B/R^3",
     .equation = "D 1.4.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      for (const Solid& solid : solids()) {
        const kinematics::RadialForce expected = from_chords(solid);
        const kinematics::RadialForce computed =
            kinematics::breathing_body(alpha1, alpha2, 1.0, kinematics::regular_solid(solid.faces));
        const char* const because = "corners rounded to eps/2 see up to 19 chords";
        rows.compare(
            fmt::format("A [m^3/s^2], {} faces", solid.faces),
            {.expected = expected.A, .computed = computed.A, .tolerance = relative(2e-15), .because = because});
        rows.compare(
            fmt::format("B [m^4/s^2], {} faces", solid.faces),
            {.expected = expected.B, .computed = computed.B, .tolerance = relative(2e-15), .because = because});
        compare_runs(rows, solid);
      }
    }};

}  // namespace verification::breathing_solids
