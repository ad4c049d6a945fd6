// The pair of the monograph's default law, released at rest at 0.75 m: how near it comes, and when it is back.

#include <algorithm>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "quadrature.hpp"
#include "references.hpp"

namespace verification::released_pair {

using namespace particulate;

constexpr double d_min = 0.34980807456;
constexpr double period = 3.396184587;
constexpr double released_at = 0.75;

const ReleasedPair by_energy{
    .law = {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0}, .reduced_mass = 0.5L, .start = released_at};

NearFieldScene released() { return {pair_at_rest(1.0, 1.0, released_at), {}, {.alpha1 = 0.5, .alpha2 = 0.25}}; }

// How near the pair came, and the moment at which it is back.
struct Found {
  double nearest, period;
};

template <class S>
Found by_scheme(double step) {
  NearFieldScene scene = released();
  const std::vector<Turning> found = turnings<S>(scene, scenes::start(scene), step, 2);
  return {.nearest = found[0].distance, .period = found[1].t};
}

// The state near the inner turning point, moved there by one Newton step on the rate of the distance.
Found by_adams() {
  NearFieldScene scene = released();
  schemes::State state = scenes::start(scene);
  advance_by(adams, scene, state, 0.5 * period);
  const double d = distance_of_pair(state);
  const double rate = parting(state) / d;
  const double acceleration = 2.0 * (0.25 / (d * d) - 0.5 / d);  // -C/m*
  const double left = -rate / acceleration;
  return {.nearest = d + 0.5 * rate * left, .period = 2.0 * (state.t + left)};
}

void compare(Rows& rows, const std::string& method, const Found& found, double tolerance, const std::string& because) {
  rows.compare("d_min by " + method + " [m]",
               {.expected = d_min, .computed = found.nearest, .tolerance = absolute(tolerance), .because = because});
  rows.compare("period by " + method + " [s]", {.expected = period,
                                                .computed = found.period,
                                                .tolerance = absolute(std::max(tolerance, 6e-10)),
                                                .because = because});
}

const Case released_pair{
    {.name = "released_pair",
     .claim = "unit masses with alpha = (0.5, 0.25), beta = (1, 2), released at rest at 0.75 m, come as near and take "
              "as long as energy says",
     .equation = "M 1.33",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const long double near = by_energy.nearest(0.3L, 0.5L);
      const Found quadrature{.nearest = static_cast<double>(near),
                             .period = static_cast<double>(by_energy.period(near, 64))};
      compare(rows, "quadrature", quadrature, 6e-12, "the reference has 11 decimals of d_min and 9 of the period");
      rows.compare("quadrature with twice the points [s]",
                   {.expected = static_cast<double>(by_energy.period(near, 128)),
                    .computed = quadrature.period,
                    .tolerance = relative(1e-15),
                    .because = "the midpoint rule of a smooth periodic integrand has converged"});
      compare(rows, "RK4", by_scheme<schemes::RungeKutta4>(1e-3), 2e-11,
              "omega up to 5/s at d_min: (5e-3)^4/120 = 5e-12 a radian, and 11 decimals of the reference");
      const double h = rows.quick() ? 4e-4 : 1e-4;
      compare(rows, "velocity Verlet", by_scheme<schemes::VelocityVerlet>(h), 5.0 * h * h,
              "order 2: T (omega h)^2/24 with omega up to 5/s is 3.5 h^2");
      compare(rows, "CVODE", by_adams(), 1e-10, "tolerances of 1e-13, of which a global error is some hundred");
    }};

}  // namespace verification::released_pair
