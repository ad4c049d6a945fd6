// The central force: its curl, its potential, where it vanishes and how a pair swings there.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/central_force.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "differences.hpp"
#include "fifty_digits.hpp"

namespace verification::central_force {

using namespace particulate;

// The force towards a centre has no curl; a swirl of a millionth of its gradient is seen.

using Eigen::Vector3d;

// Row i, column j: the slope of component i along axis j.
template <class Field>
Eigen::Matrix3d gradient(const Field& field, const Vector3d& r, double h) {
  Eigen::Matrix3d slopes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      slopes(i, j) = slope_at_zero([&](double x) { return field(r + x * Vector3d::Unit(j))[i]; }, h);
    }
  }
  return slopes;
}

Vector3d curl(const Eigen::Matrix3d& of) { return {of(2, 1) - of(1, 2), of(0, 2) - of(2, 0), of(1, 0) - of(0, 1)}; }

struct Seen {
  double curl;   // of the force, over its largest slope
  double swirl;  // error of the curl of a swirl that is added, over that curl
};

Seen look(const kinematics::CentralForce& law, const Vector3d& r) {
  const Vector3d r_o{0.3, -0.2, 0.1};
  const double h = 2e-3 * (r - r_o).norm();
  const Eigen::Matrix3d slopes = gradient([&](const Vector3d& x) { return force(law, x, r_o); }, r, h);
  const double largest = slopes.cwiseAbs().maxCoeff();

  // The field w x (r - r_o) has the curl 2 w.
  const Vector3d w = 1e-6 * largest * Vector3d{1.0, -2.0, 2.0} / 3.0;
  const auto swirling = [&](const Vector3d& x) -> Vector3d { return force(law, x, r_o) + w.cross(x - r_o); };
  return {.curl = curl(slopes).norm() / largest,
          .swirl = (curl(gradient(swirling, r, h)) - 2.0 * w).norm() / (2.0 * w).norm()};
}

void prove_central_force_curl(Rows& rows) {
  const kinematics::CentralForce laws[] = {{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0},
                                           {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
                                           {.alpha1 = 1.0, .alpha2 = 0.4, .beta1 = 0.0, .beta2 = 1.7},
                                           {.alpha1 = 0.0, .alpha2 = 2.0, .beta1 = 1.0, .beta2 = 13.0},
                                           {.alpha1 = 3.0, .alpha2 = 0.0, .beta1 = 0.6, .beta2 = 1.0}};
  const Vector3d places[] = {{1.1, 0.7, -0.4}, {-0.6, 0.9, 1.3}, {0.35, -0.5, 0.6}, {2.0, -1.0, 3.0}};
  for (const kinematics::CentralForce& law : laws) {
    Seen worst{.curl = 0.0, .swirl = 0.0};
    for (const Vector3d& r : places) {
      const Seen here = look(law, r);
      worst = {.curl = std::max(worst.curl, here.curl), .swirl = std::max(worst.swirl, here.swirl)};
    }
    const std::string which = fmt::format("beta = ({}, {})", law.beta1, law.beta2);
    rows.at_most("|curl Psi| / max slope, " + which,
                 {.limit = 1e-12,
                  .computed = worst.curl,
                  .because = "differences over h = 0.002 d of values rounded to eps carry about 4 eps/0.002 = 4e-13; "
                             "truncation is below 1e-14 for beta = 13"});
    rows.at_most("error of the curl of an added swirl, " + which,
                 {.limit = 1e-6,
                  .computed = worst.swirl,
                  .because = "the noise of 1e-12 of the slope, over a swirl of 1e-6 of it: the check has teeth"});
  }
}

const Case central_force_curl{{.name = "central_force_curl",
                               .claim = "the curl of a central force vanishes, whatever its exponents",
                               .equation = "M 1.20",
                               .reference = Reference::identity},
                              prove_central_force_curl};

// The potential's slope is the force's strength, and its difference the strength's integral.

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

void prove_potential_slope(Rows& rows) {
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
    rows.at_most("strength C, " + which,
                 {.limit = 4e-15,
                  .computed = worst.strength,
                  .because = "1/d is rounded and raised to the power 13 at most: 13/2 eps, and as much for products"});
    rows.at_most("slope of V, " + which,
                 {.limit = 2e-12,
                  .computed = worst.slope,
                  .because = "V is of the size of C d, rounded in expm1's argument to 2 eps: over h = 0.002 d that "
                             "leaves 4e-13"});
    rows.at_most("integral of C, " + which,
                 {.limit = 2e-14,
                  .computed = worst.integral,
                  .because = "(1 - beta) ln(d/d_ref) reaches 12 ln 40 = 44 and is rounded to eps/2 of itself, twice: "
                             "44 eps = 1e-14 in V"});
  }
}

const Case potential_slope{{.name = "potential_slope",
                            .claim = "V' = C for every pair of exponents, and V(d) - V(d_ref) is the integral of C",
                            .equation = "M 1.33",
                            .reference = Reference::independent_method},
                           prove_potential_slope};

// The potential's difference joins smoothly where an exponent passes through 1.

constexpr double near = 0.5;
constexpr double beyond = 0.75;

double attraction_alone(double beta) {
  return kinematics::potential({.alpha1 = 1.0, .alpha2 = 0.0, .beta1 = beta, .beta2 = 2.0}, near, beyond);
}

double repulsion_alone(double beta) {
  return kinematics::potential({.alpha1 = 0.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = beta}, near, beyond);
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
                     {.expected = potential_in_fifty_digits(near, beyond, 1.0 + offset),
                      .computed = attraction_alone(1.0 + offset),
                      .tolerance = relative(1e-15),
                      .because = "1 - beta is exact, and four functions are rounded"});
        rows.compare(fmt::format("repulsion alone [J], beta = 1 {:+}", offset),
                     {.expected = -potential_in_fifty_digits(near, beyond, 1.0 + offset),
                      .computed = repulsion_alone(1.0 + offset),
                      .tolerance = relative(1e-15),
                      .because = "1 - beta is exact, and four functions are rounded"});
      }
    }};

// Where attraction and repulsion balance, what holds the pair there, and what does not.

const kinematics::CentralForce book{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0};
const kinematics::CentralForce reversed{.alpha1 = 0.25, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 1.0};
const kinematics::CentralForce real{.alpha1 = 3.0, .alpha2 = 0.7, .beta1 = 1.3, .beta2 = 2.9};

// The curvature of a pair's total potential energy when one body moves along a direction.
double stiffness(const kinematics::CentralForce& law, double d, const Eigen::Vector3d& direction) {
  const NearFieldScene scene(pair_at_rest(1.0, 1.0, d), {},
                             {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2});
  const schemes::State start = scenes::start(scene);
  const auto energy = [&](double x) {
    schemes::State moved = start;
    for (Eigen::Index axis = 0; axis < 3; ++axis) moved.r[2 * axis + 1] += x * direction[axis];
    return scene.potential_energy(moved);
  };
  return curvature_at_zero(energy, 0.01 * d);
}

void compare_place(Rows& rows) {
  rows.compare("d_e [m], beta = (1, 2)", {.expected = 0.5,
                                          .computed = equilibrium_distance(book),
                                          .tolerance = relative(2.3e-16),
                                          .because = "(0.25/0.5)^1, one power"});
  rows.compare("d_e [m], beta = (2, 1)", {.expected = 0.5,
                                          .computed = equilibrium_distance(reversed),
                                          .tolerance = relative(2.3e-16),
                                          .because = "(0.5/0.25)^-1, one power"});
  rows.compare("d_e [m], beta = (1.3, 2.9)",
               {.expected = equilibrium_in_fifty_digits(real.alpha1, real.alpha2, real.beta1, real.beta2),
                .computed = equilibrium_distance(real),
                .tolerance = relative(1e-15),
                .because = "ratio and exponent are rounded twice each, ln(0.7/3)/1.6 is of size 1"});
}

void compare_sign(Rows& rows) {
  rows.equal("stable, beta = (1, 2)", {.expected = true, .computed = is_stable(book), .because = "beta2 > beta1"});
  rows.equal("stable, beta = (2, 1)", {.expected = false, .computed = is_stable(reversed), .because = "beta2 < beta1"});
  // alpha1 d_e^(-beta1 - 1) (beta2 - beta1), by hand: 0.5 * 4 * 1 and 0.25 * 8 * (-1).
  rows.compare("V''(d_e) [N/m], beta = (1, 2)", {.expected = 2.0,
                                                 .computed = normal_stiffness(book, 0.5),
                                                 .tolerance = relative(4e-16),
                                                 .because = "powers of two throughout"});
  rows.compare("V''(d_e) [N/m], beta = (2, 1)", {.expected = -2.0,
                                                 .computed = normal_stiffness(reversed, 0.5),
                                                 .tolerance = relative(4e-16),
                                                 .because = "powers of two throughout"});
}

// At 0.25, 0.5, 1 and 2 m, by hand: V'' = -0.5/d^2 + 0.5/d^3 along, C/d = 0.5/d^2 - 0.25/d^3 across.
void compare_hessian(Rows& rows) {
  const struct {
    double d, along, across;
  } points[] = {{.d = 0.25, .along = 24.0, .across = -8.0},
                {.d = 0.5, .along = 2.0, .across = 0.0},
                {.d = 1.0, .along = 0.0, .across = 0.25},
                {.d = 2.0, .along = -0.0625, .across = 0.09375}};
  const Eigen::Vector3d across{3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0};
  const char* const because =
      "differences over h = 0.01 d of energies rounded to 1e-16 carry 4e-16/(0.01 d)^2, "
      "6e-11 at 0.25 m; truncation is below 1e-12";
  for (const auto& at : points) {
    const std::string where = fmt::format(" [N/m], d = {} m", at.d);
    const auto compare = [&](const std::string& what, double expected, double computed, Tolerance tolerance,
                             const char* reason) {
      rows.compare(what + where,
                   {.expected = expected, .computed = computed, .tolerance = tolerance, .because = reason});
    };
    compare("normal_stiffness", at.along, normal_stiffness(book, at.d), absolute(1e-14), "a few roundings of up to 32");
    compare("transverse_stiffness", at.across, transverse_stiffness(book, at.d), absolute(1e-14),
            "a few roundings of up to 16");
    compare("energy's curvature along", at.along, stiffness(book, at.d, slanted()), absolute(2e-10), because);
    compare("energy's curvature across", at.across, stiffness(book, at.d, across), absolute(2e-10), because);
  }
}

// How often the transverse stiffness changes its sign over twelve decades.
int sign_changes(const kinematics::CentralForce& law) {
  int changes = 0;
  double before = 0.0;
  for (double d = 1e-6; d < 1e6; d *= 1.01) {
    const double here = transverse_stiffness(law, d);
    if (before * here < 0.0) ++changes;
    before = here;
  }
  return changes;
}

const Case equilibrium{
    {.name = "equilibrium",
     .claim =
         "a pair balances at d_e, stable along the line of centres iff beta2 > beta1, neutral across it at d_e only",
     .equation = "M 1.36",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_place(rows);
      compare_sign(rows);
      compare_hessian(rows);
      rows.equal("zeros of the transverse stiffness in 1e-6 ... 1e6 m",
                 {.expected = 1, .computed = sign_changes(book), .because = "C vanishes at d_e alone"});
    }};

// Small oscillations about the equilibrium distance take pi seconds; larger ones tend to it.

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

void prove_small_oscillation_period(Rows& rows) {
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
  rows.at_least("lengthening at amplitude 0.02 m [s]",
                {.limit = 1e-4, .computed = periods[0] - std::numbers::pi, .because = "else nothing is extrapolated"});
  rows.compare("measured period, amplitude to zero [s]",
               {.expected = std::numbers::pi,
                .computed = extrapolated(periods),
                .tolerance = absolute(2e-9),
                .because = "the next power of A/d_e, 0.04^5/1024 = 1e-10, with a constant of about 4; RK4 adds "
                           "T (2 pi/1000)^4/120 = 4e-11"});
}

const Case small_oscillation_period{
    {.name = "small_oscillation_period",
     .claim = "unit masses with alpha = (0.5, 0.25), beta = (1, 2) oscillate with period pi about d_e = 0.5",
     .equation = "D 1.36",
     .reference = Reference::closed_form},
    prove_small_oscillation_period};

}  // namespace verification::central_force
