// The potential's slope is the force's strength, and its difference the strength's integral.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <particulate/kinematics/central_force.hpp>

#include "differences.hpp"

namespace verification::potential_slope {

using namespace particulate;

struct Parts {
  long double attraction, repulsion;
};

// The two powers of (1.30) in extended precision.
Parts parts(const kinematics::CentralForce& law, long double d) {
  return {.attraction = law.alpha1 * std::pow(d, -static_cast<long double>(law.beta1)),
          .repulsion = law.alpha2 * std::pow(d, -static_cast<long double>(law.beta2))};
}

struct Errors {
  double strength = 0.0, slope = 0.0, integral = 0.0;
};

// Errors relative to the sum of both powers, so that the zero at equilibrium asks for nothing impossible.
Errors errors_at(const kinematics::CentralForce& law, double d) {
  const auto [attraction, repulsion] = parts(law, d);
  const double expected = static_cast<double>(attraction - repulsion);
  const double scale = static_cast<double>(attraction + repulsion);
  const double measured = slope_at_zero([&](double x) { return potential(law, d + x, 0.9 * d); }, 2e-3 * d);
  return {.strength = std::abs(strength(law, d) - expected) / scale, .slope = std::abs(measured - expected) / scale};
}

// V(d) - V(d_ref) against the integral of C, relative to the integral of both powers.
double error_of_integral(const kinematics::CentralForce& law, double d, double d_ref) {
  using Rule = boost::math::quadrature::gauss_kronrod<long double, 61>;
  // The logarithm of the distance as variable makes every power an exponential.
  const auto integral = [&](double sign) {
    const auto f = [&](long double s) {
      const long double x = std::exp(s);
      const auto [attraction, repulsion] = parts(law, x);
      return x * (attraction + sign * repulsion);
    };
    return Rule::integrate(f, std::log(static_cast<long double>(d_ref)), std::log(static_cast<long double>(d)), 2u,
                           1e-16L);
  };
  const long double expected = integral(-1.0);
  const long double scale = std::abs(integral(1.0));
  return static_cast<double>(std::abs(potential(law, d, d_ref) - expected) / scale);
}

Errors worst_errors(const kinematics::CentralForce& law) {
  Errors worst;
  for (double d = 0.1; d < 12.0; d *= 1.37) {
    const Errors here = errors_at(law, d);
    worst.strength = std::max(worst.strength, here.strength);
    worst.slope = std::max(worst.slope, here.slope);
    for (const double d_ref : {1.0, 0.3}) worst.integral = std::max(worst.integral, error_of_integral(law, d, d_ref));
  }
  return worst;
}

const Case potential_slope{
    {.name = "potential_slope",
     .claim = "V' = C for every pair of exponents, and V(d) - V(d_ref) is the integral of C",
     .equation = "M 1.33",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const kinematics::CentralForce laws[] = {{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0},
                                               {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
                                               {.alpha1 = 0.3, .alpha2 = 1.1, .beta1 = 2.0, .beta2 = 1.0},
                                               {.alpha1 = 2.0, .alpha2 = 0.3, .beta1 = 1.5, .beta2 = 2.7},
                                               {.alpha1 = 1.0, .alpha2 = 0.7, .beta1 = 0.0, .beta2 = 0.3},
                                               {.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 1.0 + 1e-9, .beta2 = 1.0 - 1e-9},
                                               {.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 7.0, .beta2 = 13.0},
                                               {.alpha1 = 0.0, .alpha2 = 2.0, .beta1 = 1.0, .beta2 = 13.0},
                                               {.alpha1 = 2.0, .alpha2 = 0.0, .beta1 = 12.5, .beta2 = 1.0}};
      for (const kinematics::CentralForce& law : laws) {
        const Errors worst = worst_errors(law);
        const std::string which =
            fmt::format("alpha = ({}, {}), beta = ({}, {})", law.alpha1, law.alpha2, law.beta1, law.beta2);
        rows.at_most(
            "strength C, " + which,
            {.limit = 4e-15,
             .computed = worst.strength,
             .because = "1/d is rounded and raised to the power 13 at most: 13/2 eps, and as much for products"});
        rows.at_most("slope of V, " + which,
                     {.limit = 2e-12,
                      .computed = worst.slope,
                      .because = "V is of the size of C d, rounded in expm1's argument to 2 eps: over h = 0.002 d that "
                                 "leaves 4e-13"});
        rows.at_most(
            "integral of C, " + which,
            {.limit = 2e-14,
             .computed = worst.integral,
             .because = "(1 - beta) ln(d/d_ref) reaches 12 ln 40 = 44 and is rounded to eps/2 of itself, twice: "
                        "44 eps = 1e-14 in V"});
      }
    }};

}  // namespace verification::potential_slope
