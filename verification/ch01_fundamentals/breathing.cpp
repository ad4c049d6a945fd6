// Bodies that move to and fro along fixed directions: closed form, schemes and references.

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <harness/turning_pair.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "fifty_digits.hpp"
#include "references.hpp"

namespace verification::breathing {

using namespace particulate;

// What moves a scene to a time.
using Move = std::function<void(NearFieldScene& scene, schemes::State& state, double t_end)>;

template <class S>
Move in_steps(long steps) {
  return [=](NearFieldScene& scene, schemes::State& state, double t_end) { advance<S>(scene, state, t_end, steps); };
}
Move by_reference(const reference::Method& method) {
  return [=](NearFieldScene& scene, schemes::State& state, double t_end) { advance_by(method, scene, state, t_end); };
}

// Bodies that start at rest on a shape, and what they should do.
struct Bodies {
  ExactBreathing exact;
  kinematics::Vectors shape;
  Eigen::VectorXd mass;
  laws::NearField law;
};

laws::NearField near_field(double alpha1, double alpha2) {
  return {.alpha1 = alpha1, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0};
}

void compare_run(Rows& rows, const Bodies& bodies, int tenths, const std::string& which, const Allowed& allowed,
                 const Move& move) {
  NearFieldScene scene(at_rest(bodies.shape, 1.0, bodies.mass), {}, bodies.law);
  const BreathingErrors worst =
      errors_at_tenths(bodies.exact, bodies.shape, scenes::start(scene), tenths,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  compare_errors(rows, which, worst, allowed);
}

// Two unit masses under (beta1, beta2) = (2, 3), released at rest at 1 m: Kepler's equation gives every moment.

// The table of the catalogue: alpha1 = 1, unit masses, r_0 = 1; the exact r_min is 1/(2/alpha2 - 1).
struct Line {
  double alpha2, r_min, period, peak;
  double r_min_exact;
};
const Line lines[] = {
    {.alpha2 = 0.5, .r_min = 1.0 / 3.0, .period = 2.4183991523123, .peak = 4.5, .r_min_exact = 1.0 / 3.0},
    {.alpha2 = 0.1, .r_min = 0.0526315789474, .period = 1.6964242387647, .peak = 324.9, .r_min_exact = 1.0 / 19.0},
    {.alpha2 = 0.01,
     .r_min = 0.00502512562814,
     .period = 1.5826513622677,
     .peak = 39204.99,
     .r_min_exact = 1.0 / 199.0},
    {.alpha2 = 0.001,
     .r_min = 0.000500250125063,
     .period = 1.5719751607805,
     .peak = 3992004.999,
     .r_min_exact = 1.0 / 1999.0}};

ExactBreathing exact_pair(double alpha2) {
  return {.force = kinematics::breathing_pair(1.0, alpha2, 1.0, 1.0), .r_0 = 1.0};
}

void compare_table(Rows& rows, const Line& line) {
  const ExactBreathing exact = exact_pair(line.alpha2);
  const std::string which = fmt::format(", alpha2 = {}", line.alpha2);
  rows.compare("r_min [m]" + which, {.expected = line.r_min,
                                     .computed = exact.motion.nearest(),
                                     .tolerance = relative(1.1e-12),
                                     .because = "12 digits of the reference"});
  // alpha2 itself is rounded to eps/2, and so is r_min = alpha2/(2 - alpha2).
  rows.compare("r_min as a fraction [m]" + which, {.expected = line.r_min_exact,
                                                   .computed = exact.motion.nearest(),
                                                   .tolerance = relative(5e-16),
                                                   .because = "alpha2, B and the result are rounded"});
  rows.compare("period [s]" + which, {.expected = line.period,
                                      .computed = exact.motion.period(),
                                      .tolerance = relative(4e-14),
                                      .because = "14 digits of the reference"});
  rows.compare(
      "peak force [N]" + which,
      {.expected = line.peak,
       .computed = -strength(laws::pair_law(near_field(1.0, line.alpha2), 1.0, 1.0), exact.motion.nearest()),
       .tolerance = relative(2e-15),
       .because = "-C(r_min) = (1 - alpha2) (2 - alpha2)^2/alpha2^2 by hand; the rounding of r_min counts thrice"});
}

BreathingErrors errors_of_closed_form(double alpha2) {
  const ExactBreathing exact = exact_pair(alpha2);
  BreathingErrors worst;
  for (int k = 0; k <= 60; ++k) {
    const double t = exact.motion.period() * k / 20.0;
    const kinematics::Radial computed = exact.motion.at(t), expected = breathing_in_fifty_digits(alpha2, t);
    worst.position = std::max(worst.position, std::abs(computed.r - expected.r));
    worst.velocity = std::max(worst.velocity, std::abs(computed.v - expected.v) / exact.largest_speed());
  }
  return worst;
}

void compare_closed_form(Rows& rows, const Line& line) {
  const BreathingErrors worst = errors_of_closed_form(line.alpha2);
  const std::string which = fmt::format(", alpha2 = {}", line.alpha2);
  rows.at_most("closed form against 50 digits, r/r_0" + which,
               {.limit = 1e-15, .computed = worst.position, .because = "a few roundings of the largest value"});
  rows.at_most(
      "closed form against 50 digits, dr/dt over its largest" + which,
      {.limit = 1e-15 + errors_of_shift(exact_pair(line.alpha2), 6.6e-19).velocity,
       .computed = worst.velocity,
       .because = "a few roundings of the largest value, and three periods kept to 2^-63: a shift in time that "
                  "counts where the force is largest"});
}

void compare_pair(Rows& rows, double alpha2, const std::string& method, const Allowed& allowed, const Move& move) {
  compare_run(rows, {exact_pair(alpha2), pair_shape(1.0, 1.0), Eigen::Vector2d::Ones(), near_field(1.0, alpha2)}, 30,
              fmt::format(" at thirty tenths of a period, {}, alpha2 = {}", method, alpha2), allowed, move);
}

template <class S>
void compare_steps(Rows& rows, double alpha2, const std::string& method, long steps_a_tenth) {
  const ExactBreathing exact = exact_pair(alpha2);
  const double h = exact.motion.period() / 10.0 / static_cast<double>(steps_a_tenth);
  compare_pair(rows, alpha2, method, allowed_to_steps(exact, S::order, h), in_steps<S>(steps_a_tenth));
}

void compare_reference(Rows& rows, double alpha2, const std::string& name, double global,
                       const reference::Method& method) {
  compare_pair(rows, alpha2, name, allowed_to_tolerance(exact_pair(alpha2), global), by_reference(method));
}

const Case breathing_pair{
    {.name = "breathing_pair",
     .claim = "a pair released at rest under (beta1, beta2) = (2, 3) follows Kepler's equation, whatever its stiffness",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const Line& line : lines) {
        compare_table(rows, line);
        compare_closed_form(rows, line);
      }
      compare_steps<schemes::RungeKutta4>(rows, 0.5, "RK4", 500);
      compare_steps<schemes::RungeKutta4>(rows, 0.1, "RK4", 2000);
      compare_steps<schemes::RungeKutta4>(rows, 0.01, "RK4", rows.quick() ? 50000 : 100000);
      compare_steps<schemes::VelocityVerlet>(rows, 0.5, "velocity Verlet", 5000);
      compare_steps<schemes::VelocityVerlet>(rows, 0.1, "velocity Verlet", rows.quick() ? 20000 : 100000);
      for (const double alpha2 : {0.5, 0.1, 0.01, 0.001}) {
        compare_reference(rows, alpha2, "CVODE Adams", global_of_adams, adams);
        compare_reference(rows, alpha2, "ARKODE Fehlberg 13(7,8)", global_of_runge_kutta, fehlberg);
      }
      compare_reference(rows, 0.5, "ARKODE Dormand-Prince", global_of_runge_kutta, dormand_prince);
    }};

// The breathing pair with unequal masses: the separation knows their sum alone, each body its share.

// alpha is chosen so that alpha1 (m_i + m_j) is the same 4 for every pair: A = 4, B = 2, a = 2/3 and T = 2 pi
// sqrt(2/27).
constexpr double period_of_masses = 1.710066440215819;

struct Pair {
  double m_i, m_j, alpha1;
};

void compare_masses(Rows& rows, const Pair& pair) {
  const Bodies bodies{
      .exact{.force = kinematics::breathing_pair(pair.alpha1, 0.5 * pair.alpha1, pair.m_i, pair.m_j), .r_0 = 1.0},
      .shape = pair_shape(pair.m_i, pair.m_j),
      .mass = Eigen::Vector2d{pair.m_i, pair.m_j},
      .law = near_field(pair.alpha1, 0.5 * pair.alpha1)};
  const std::string masses = fmt::format("masses {} and {}", pair.m_i, pair.m_j);
  rows.compare("period [s], " + masses, {.expected = period_of_masses,
                                         .computed = bodies.exact.motion.period(),
                                         .tolerance = relative(1e-15),
                                         .because = "alpha1 (m_i + m_j) is rounded twice"});
  compare_run(rows, bodies, 30, " of each body, RK4, " + masses,
              allowed_to_steps(bodies.exact, 4, period_of_masses / 5000.0), in_steps<schemes::RungeKutta4>(500));
  // The heavy body moves by 1e-12 m only: the absolute tolerance must lie below that.
  reference::ExplicitRungeKutta fine = fehlberg;
  fine.absolute = 1e-26;
  compare_run(rows, bodies, 30, " of each body, ARKODE Fehlberg 13(7,8), " + masses,
              allowed_to_tolerance(bodies.exact, global_of_runge_kutta), by_reference(fine));
}

const Case breathing_masses{
    {.name = "breathing_masses",
     .claim = "T = 2 pi sqrt(a^3/(alpha1 (m_i + m_j))), and each body moves in inverse proportion to its mass",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Pair pairs[] = {{.m_i = 1.0, .m_j = 3.0, .alpha1 = 1.0},
                            {.m_i = 0.07, .m_j = 0.01, .alpha1 = 50.0},
                            {.m_i = 1.0, .m_j = 1e12, .alpha1 = 4.0 / (1e12 + 1.0)},
                            {.m_i = 1e-6, .m_j = 1e-18, .alpha1 = 4.0 / (1e-6 + 1e-18)}};
      for (const Pair& pair : pairs) compare_masses(rows, pair);
    }};

// A breathing pair that also turns: its angular momentum stiffens the repulsion.

// A = 4, B = 0.25 * 4 + 1.5^2 = 3.25, 2|E| = 8 - 3.25 = 4.75, a = 4/4.75 = 16/19.
constexpr double radial_period = 2.427724746595934;
constexpr double r_min = 3.25 / 4.75;

// Errors of the separation's length, its rate and its angle against the closed form.
struct TurningErrors {
  double distance = 0.0, rate = 0.0, angle = 0.0;
};

TurningErrors errors_at_tenths(const kinematics::Breathing& exact, const Move& move) {
  NearFieldScene scene = turning::pair();
  schemes::State state = scenes::start(scene);
  TurningErrors worst;
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
void compare_rotating(Rows& rows, const std::string& method, double share, const std::string& because,
                      const Move& move) {
  const ExactBreathing exact{.force = turning::force(), .r_0 = 1.0};
  const TurningErrors worst = errors_at_tenths(exact.motion, move);
  const double dt = share * radial_period;
  rows.at_most("distance [m], " + method,
               {.limit = dt * exact.largest_speed(), .computed = worst.distance, .because = because});
  rows.at_most("its rate [m/s], " + method,
               {.limit = dt * exact.largest_acceleration(), .computed = worst.rate, .because = because});
  rows.at_most("angle [rad], " + method,
               {.limit = dt * turning::l_z / (r_min * r_min), .computed = worst.angle, .because = because});
}

void prove_breathing_rotating(Rows& rows) {
  const kinematics::Breathing exact(turning::force(), 1.0);
  rows.compare("radial period [s]", {.expected = radial_period,
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
  compare_rotating(rows, "RK4", 4e-12,
                   "5.5/s at r_min times h = 4.9e-4 s gives 3e-12 in three periods, and 1e-12 of rounding",
                   in_steps<schemes::RungeKutta4>(500));
  compare_rotating(rows, "CVODE Adams", global_of_adams, "its global error with a tolerance of 1e-14",
                   by_reference(adams));
}

const Case breathing_rotating{
    {.name = "breathing_rotating",
     .claim =
         "angular momentum adds Lz^2/m* to the pair's alpha2, and the radial period is that of a pair at rest with it",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    prove_breathing_rotating};

// Equal bodies at the corners of a regular polygon breathe as one.

constexpr double alpha1 = 1.0, alpha2 = 0.5;

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

void compare_polygon_runs(Rows& rows, int N, int periods) {
  const Bodies polygon{.exact = exact_polygon(N),
                       .shape = kinematics::regular_polygon(N),
                       .mass = Eigen::VectorXd::Ones(N),
                       .law = near_field(1.0, alpha2)};
  const auto compare = [&](const std::string& method, const Allowed& allowed, const Move& move) {
    compare_run(rows, polygon, 10 * periods,
                fmt::format(" at {} tenths of a period, {}, N = {}", 10 * periods, method, N),
                with_growth(allowed, periods), move);
  };
  compare("RK4", allowed_to_steps(polygon.exact, 4, polygon.exact.motion.period() / 5000.0),
          in_steps<schemes::RungeKutta4>(500));
  compare("ARKODE Fehlberg 13(7,8)", allowed_to_tolerance(polygon.exact, global_of_runge_kutta),
          by_reference(fehlberg));
  compare("CVODE Adams", allowed_to_tolerance(polygon.exact, global_of_adams), by_reference(adams));
}

void prove_breathing_polygon(Rows& rows) {
  for (const int N : {2, 3, 4, 5, 6, 7, 12}) compare_constants(rows, N);
  for (const auto& [N, period] : {std::pair{3, 3.693698908296404}, {5, 2.557674818374453}}) {
    rows.compare(fmt::format("period [s], N = {}", N), {.expected = period,
                                                        .computed = exact_polygon(N).motion.period(),
                                                        .tolerance = relative(2e-15),
                                                        .because = "A and B to some eps, 16 digits of the reference"});
  }
  for (const int N : {3, 5, 7}) {
    for (const int periods : {1, 2}) compare_polygon_runs(rows, N, periods);
  }
}

const Case breathing_polygon{{.name = "breathing_polygon",
                              .claim = "regular polygons of equal bodies breathe with R'' = -A/R^2 + B/R^3",
                              .equation = "D 1.4.1",
                              .reference = Reference::closed_form},
                             prove_breathing_polygon};

// Equal bodies at the corners of the five regular solids breathe as one.

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

// One period, because the motion is unstable.
void compare_solid_runs(Rows& rows, const Solid& solid) {
  const kinematics::Vectors corners = kinematics::regular_solid(solid.faces);
  const Bodies bodies{.exact{.force = from_chords(solid), .r_0 = 1.0},
                      .shape = corners,
                      .mass = Eigen::VectorXd::Ones(corners.rows()),
                      .law = near_field(alpha1, alpha2)};
  const auto compare = [&](const std::string& method, const Allowed& allowed, const Move& move) {
    compare_run(rows, bodies, 10, fmt::format(" at ten tenths of a period, {}, {} faces", method, solid.faces), allowed,
                move);
  };
  compare("RK4", allowed_to_steps(bodies.exact, 4, bodies.exact.motion.period() / 5000.0),
          in_steps<schemes::RungeKutta4>(500));
  compare("ARKODE Fehlberg 13(7,8)", allowed_to_tolerance(bodies.exact, global_of_runge_kutta), by_reference(fehlberg));
}

void prove_breathing_solids(Rows& rows) {
  for (const Solid& solid : solids()) {
    const kinematics::RadialForce expected = from_chords(solid);
    const kinematics::RadialForce computed =
        kinematics::breathing_body(alpha1, alpha2, 1.0, kinematics::regular_solid(solid.faces));
    const char* const because = "corners rounded to eps/2 see up to 19 chords";
    rows.compare(fmt::format("A [m^3/s^2], {} faces", solid.faces),
                 {.expected = expected.A, .computed = computed.A, .tolerance = relative(2e-15), .because = because});
    rows.compare(fmt::format("B [m^4/s^2], {} faces", solid.faces),
                 {.expected = expected.B, .computed = computed.B, .tolerance = relative(2e-15), .because = because});
    compare_solid_runs(rows, solid);
  }
}

const Case breathing_solids{{.name = "breathing_solids",
                             .claim = "regular solids of equal bodies breathe with R'' = -A/R^2 + B/R^3",
                             .equation = "D 1.4.1",
                             .reference = Reference::independent_method},
                            prove_breathing_solids};

}  // namespace verification::breathing
