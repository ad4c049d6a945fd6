// Two unit masses under (beta1, beta2) = (2, 3), released at rest at 1 m: Kepler's equation gives every moment.

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "fifty_digits.hpp"
#include "references.hpp"

namespace verification::breathing_pair {

using namespace particulate;

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

laws::NearField near_field(double alpha2) { return {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}; }

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
       .computed = -strength(laws::pair_law(near_field(line.alpha2), 1.0, 1.0), exact.motion.nearest()),
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

template <class Move>
void compare_run(Rows& rows, double alpha2, const std::string& method, const Allowed& allowed, const Move& move) {
  NearFieldScene scene(pair_at_rest(1.0, 1.0, 1.0), {}, near_field(alpha2));
  const BreathingErrors worst =
      errors_at_tenths(exact_pair(alpha2), pair_shape(1.0, 1.0), scenes::start(scene), 30,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  compare_errors(rows, fmt::format(" at thirty tenths of a period, {}, alpha2 = {}", method, alpha2), worst, allowed);
}

template <class S>
void compare_steps(Rows& rows, double alpha2, const std::string& method, long steps_a_tenth) {
  const ExactBreathing exact = exact_pair(alpha2);
  const double h = exact.motion.period() / 10.0 / static_cast<double>(steps_a_tenth);
  compare_run(
      rows, alpha2, method, allowed_to_steps(exact, S::order, h),
      [&](auto& scene, schemes::State& state, double t_end) { advance<S>(scene, state, t_end, steps_a_tenth); });
}

void compare_reference(Rows& rows, double alpha2, const std::string& name, double global,
                       const reference::Method& method) {
  compare_run(rows, alpha2, name, allowed_to_tolerance(exact_pair(alpha2), global),
              [&](auto& scene, schemes::State& state, double t_end) { advance_by(method, scene, state, t_end); });
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

}  // namespace verification::breathing_pair
