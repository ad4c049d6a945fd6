// The potential's difference joins smoothly where an exponent passes through 1.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/central_force.hpp>

#include "fifty_digits.hpp"

namespace verification::potential_limit {

using namespace particulate;

constexpr double d = 0.5;
constexpr double d_ref = 0.75;

double attraction_alone(double beta) {
  return kinematics::potential({.alpha1 = 1.0, .alpha2 = 0.0, .beta1 = beta, .beta2 = 2.0}, d, d_ref);
}

double repulsion_alone(double beta) {
  return kinematics::potential({.alpha1 = 0.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = beta}, d, d_ref);
}

const Case potential_limit{
    {.name = "potential_limit",
     .claim = "V(d) - V(d_ref) tends to alpha ln(d/d_ref) as its exponent tends to 1, from both sides",
     .equation = "D 1.33",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double logarithm = -0.405465108108164;  // ln(0.5/0.75)
      rows.compare("V(0.5) - V(0.75) [J], beta = 1", {.expected = logarithm,
                                                      .computed = attraction_alone(1.0),
                                                      .tolerance = absolute(1e-15),
                                                      .because = "the reference has 15 decimals, each rounding 1e-16"});
      for (const double beta : {1.0 - 1e-12, 1.0 + 1e-12}) {
        rows.compare(fmt::format("V(0.5) - V(0.75) [J], beta = {}", beta),
                     {.expected = logarithm,
                      .computed = attraction_alone(beta),
                      .tolerance = absolute(5e-13),
                      .because = "12 digits; the true difference from the limit is 2e-13"});
      }
      for (const double offset : {-1e-3, -1e-6, -1e-9, -1e-12, 1e-12, 1e-9, 1e-6, 1e-3}) {
        rows.compare(fmt::format("attraction alone [J], beta = 1 {:+}", offset),
                     {.expected = potential_in_fifty_digits(d, d_ref, 1.0 + offset),
                      .computed = attraction_alone(1.0 + offset),
                      .tolerance = relative(1e-15),
                      .because = "1 - beta is exact, and four functions are rounded"});
        rows.compare(fmt::format("repulsion alone [J], beta = 1 {:+}", offset),
                     {.expected = -potential_in_fifty_digits(d, d_ref, 1.0 + offset),
                      .computed = repulsion_alone(1.0 + offset),
                      .tolerance = relative(1e-15),
                      .because = "1 - beta is exact, and four functions are rounded"});
      }
    }};

}  // namespace verification::potential_limit
