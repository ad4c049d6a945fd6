// Small oscillations about the equilibrium distance take pi seconds; larger ones tend to it.

#include <numbers>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/central_force.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification::small_oscillation_period {

using namespace particulate;

// Time between two turnings on the same side, released at rest at d_e + amplitude.
double measured_period(double amplitude) {
  NearFieldScene scene(pair_at_rest(1.0, 1.0, 0.5 + amplitude), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
  return turnings<schemes::RungeKutta4>(scene, scenes::start(scene), std::numbers::pi / 1000.0, 2).back().t;
}

// T(A) = T(0) + c2 A^2 + c3 A^3 + c4 A^4 + ...: a release on one side leaves odd powers. Amplitudes halve.
double extrapolated(std::vector<double> periods) {
  for (double weight = 4.0; periods.size() > 1; weight *= 2.0) {
    for (std::size_t k = 0; k + 1 < periods.size(); ++k)
      periods[k] = periods[k + 1] + (periods[k + 1] - periods[k]) / (weight - 1.0);
    periods.pop_back();
  }
  return periods.front();
}

const Case small_oscillation_period{
    {.name = "small_oscillation_period",
     .claim = "unit masses with alpha = (0.5, 0.25), beta = (1, 2) oscillate with period pi about d_e = 0.5",
     .equation = "D 1.36",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::CentralForce law{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0};
      rows.compare("period [s]", {.expected = std::numbers::pi,
                                  .computed = kinematics::small_oscillation_period(law, 1.0, 1.0),
                                  .tolerance = relative(4e-16),
                                  .because = "2 pi sqrt((1/2)/2) is exact but for the product and a rounding"});
      // m* = 3/4 instead of 1/2.
      rows.compare("period of masses 1 and 3 [s]", {.expected = 3.847649490485592,
                                                    .computed = kinematics::small_oscillation_period(law, 1.0, 3.0),
                                                    .tolerance = relative(4e-16),
                                                    .because = "pi sqrt(3/2), four roundings"});
      const std::vector<double> periods{measured_period(0.02), measured_period(0.01), measured_period(0.005),
                                        measured_period(0.0025)};
      rows.at_least(
          "lengthening at amplitude 0.02 m [s]",
          {.limit = 1e-4, .computed = periods[0] - std::numbers::pi, .because = "else nothing is extrapolated"});
      rows.compare("measured period, amplitude to zero [s]",
                   {.expected = std::numbers::pi,
                    .computed = extrapolated(periods),
                    .tolerance = absolute(2e-9),
                    .because = "the next power of A/d_e, 0.04^5/1024 = 1e-10, with a constant of about 4; RK4 adds "
                               "T (2 pi/1000)^4/120 = 4e-11"});
    }};

}  // namespace verification::small_oscillation_period
