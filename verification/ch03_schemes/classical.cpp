// Problems of the literature: their Jacobians, and their published digits by CVODE, ARKODE and collocation.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/integrate.hpp>

#include "classical_problems.hpp"

namespace verification::classical {

using namespace particulate;
using namespace particulate::schemes;

// There is an answer at the end only.
void compare_ending(Rows& rows, const std::string& ended, const Outcome& out) {
  rows.equal(ended, {.expected = "reached",
                     .computed = out.reason.empty() ? "reached" : out.reason,
                     .because = "there is an answer at the end only"});
}

// The first of the Pleiades, to the published digits.
void compare_first_star(Rows& rows, const std::string& how, const State& end, double tolerance, const char* because) {
  const auto compare = [&](const char* name, double expected, double computed) {
    rows.compare(how + name,
                 {.expected = expected, .computed = computed, .tolerance = relative(tolerance), .because = because});
  };
  compare("x1", 0.3706139143970502, end.r[0]);
  compare("y1", -3.943437585517392, end.r[7]);
}

// The Jacobians of the classical problems against differences of their rates.

Eigen::VectorXd rate_at(const Problem& problem, const Eigen::VectorXd& y) {
  particulate::schemes::Rates rates;
  problem.rates({.y = y}, rates);
  return rates.dy;
}

// Central differences over h = y_j/4 and over 2 h, extrapolated: exact for polynomials of degree four, whatever h is.
Eigen::MatrixXd by_differences(const Problem& problem, const Eigen::VectorXd& y) {
  Eigen::MatrixXd J(y.size(), y.size());
  for (Eigen::Index j = 0; j < y.size(); ++j) {
    const auto difference = [&](double h) -> Eigen::VectorXd {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(y.size(), j);
      return (rate_at(problem, y + step) - rate_at(problem, y - step)) / (2.0 * h);
    };
    J.col(j) = (4.0 * difference(0.25 * y[j]) - difference(0.5 * y[j])) / 3.0;
  }
  return J;
}

// Each row over its largest entry: a row holds the derivatives of one rate.
void compare_jacobian(Rows& rows, const std::string& name, const Problem& problem, const Eigen::VectorXd& y) {
  Eigen::MatrixXd given;
  problem.jacobian({0.0, {nullptr, 0}, {nullptr, 0}, {y.data(), y.size()}}, given);
  const Eigen::MatrixXd seen = by_differences(problem, y);
  const Eigen::VectorXd largest = seen.rowwise().lpNorm<Eigen::Infinity>();
  const Eigen::MatrixXd error = ((given - seen).array().colwise() / largest.array()).matrix();
  rows.at_most(name + ": given Jacobian against differences, over the largest of a row",
               {.limit = 1e-13,
                .computed = error.hasNaN() ? missing : error.lpNorm<Eigen::Infinity>(),
                .because = "the rates are polynomials of degree 3 at most, for which the differences are exact but for "
                           "some hundred roundings"});
}

const Case classical_jacobians{
    {.name = "classical_jacobians",
     .claim = "the Jacobians given with the classical problems are the derivatives of their rates",
     .equation = "R 3.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const Robertson robertson;
      const VanDerPol van_der_pol;
      const Oregonator oregonator;
      compare_jacobian(rows, "Robertson", robertson, Eigen::Vector3d{0.7, 3e-5, 0.3});
      compare_jacobian(rows, "van der Pol", van_der_pol, Eigen::Vector2d{1.7, -0.9});
      compare_jacobian(rows, "Oregonator", oregonator, Eigen::Vector3d{20.0, 1200.0, 130.0});
    }};

// The Pleiades, a near-field scene with published digits, by two reference methods of different families.

void compare_pleiades(Rows& rows, const std::string& how, const reference::Method& method) {
  const auto scene = pleiades();
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = reference::integrate(scene, state, pleiades_end, method);
  compare_ending(rows, how + ": ended", out);
  const char* const because = "1e-14 a step, which the close passages amplify some 1e4-fold";
  compare_first_star(rows, how + ": ", state, 2e-10, because);
}

const Case classical_pleiades{
    {.name = "classical_pleiades",
     .claim = "seven stars under a near field without repulsion end where the literature says",
     .equation = "M 2.3",
     .reference = Reference::published},
    [](Rows& rows) {
      compare_pleiades(rows, "CVODE Adams", reference::Adams{.relative = 1e-14, .absolute = 1e-15});
      compare_pleiades(rows, "ARKODE Fehlberg 8(7)",
                       reference::ExplicitRungeKutta{
                           .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-15});
    }};

// Stiff problems of the literature by CVODE's backward differentiation formulas, to the published digits.

// Two tolerances of a step, and what they may cost over the whole run.
struct Tolerances {
  double relative, absolute;  // of a step
  double tolerance;           // of the digits
  std::string because;
};

void compare_by_cvode(Rows& rows, const std::string& how, const schemes::Problem& problem, schemes::State state,
                      const schemes::State& known, const Tolerances& allowed) {
  const reference::Bdf method{.relative = allowed.relative, .absolute = allowed.absolute};
  const schemes::Outcome out = reference::integrate(problem, state, known.t, method);
  compare_ending(rows, how + ": ended", out);
  for (Eigen::Index k = 0; k < known.y.size(); ++k) {
    rows.compare(fmt::format("{}: y{}", how, k + 1), {.expected = known.y[k],
                                                      .computed = state.y[k],
                                                      .tolerance = relative(allowed.tolerance),
                                                      .because = allowed.because});
  }
}

template <class P>
void compare_both(Rows& rows, const P& problem, const Tolerances& allowed) {
  compare_by_cvode(rows, "given Jacobian", problem, P::start(), P::published(), allowed);
  const WithoutJacobian<P> without{problem};
  compare_by_cvode(rows, "difference quotients", without, P::start(), P::published(), allowed);
}

Claim claim_of_cvode(const std::string& name, const std::string& problem) {
  return {.name = "classical_" + name,
          .claim = "CVODE's stiff method meets the published digits of " + problem,
          .equation = "R 3.2",
          .reference = Reference::published};
}

const Case classical_robertson{
    claim_of_cvode("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
      compare_both(rows, Robertson{},
                   {.relative = 1e-10,
                    .absolute = 1e-24,
                    .tolerance = 1e-8,
                    .because = "100 times the tolerance of a step: y1 and y2 fall as 1/t, which keeps "
                               "relative errors, and y2 reaches 8e-14, far above the absolute 1e-24"});
    }};

Tolerances of_shifted(const std::string& what) {
  return {.relative = 1e-11,
          .absolute = 1e-13,
          .tolerance = 1e-8,
          .because = "1000 times the tolerance of a step: their errors shift the " + what +
                     " in time, and nothing damps a shift"};
}

const Case classical_van_der_pol{claim_of_cvode("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"),
                                 [](Rows& rows) { compare_both(rows, VanDerPol{}, of_shifted("leaps")); }};
const Case classical_oregonator{claim_of_cvode("oregonator", "the Oregonator at t = 360"),
                                [](Rows& rows) { compare_both(rows, Oregonator{}, of_shifted("pulses")); }};

// Problems of the literature by the library's own methods, to ten published digits.

// Its digits, and what a step may cost.
struct Published {
  State start, end;
  Eigen::Vector3d sizes;  // below which errors of a step count as absolute; so many as there are digits
  double TOL;             // of a step
};

// Counts its Jacobians.
template <class P>
struct Counting : P {
  long jacobians = 0;

  void jacobian(double t, In y, Eigen::MatrixXd& J) {
    ++jacobians;
    P::jacobian(t, y, J);
  }
};

template <class Nodes>
void compare_by_radau(Rows& rows, const std::string& how, const Problem& problem, const Published& known,
                      const long* jacobians = nullptr) {
  const long before = jacobians ? *jacobians : 0;
  const Eigen::Index n = known.start.y.size();
  Collocation<Nodes, Newton<>> scheme({.sizes = known.sizes.head(n)});
  ErrorControl control{.TOL = known.TOL,
                       .sweep_TOL = std::max(1e-3 * known.TOL, 1e-14),
                       .K_d = 3,
                       .step = 1e-6,
                       .limit = known.end.t,
                       .growth = 8.0,
                       .worth = 1.2};
  State state = known.start;
  const Outcome out = integrate(problem, state, known.end.t, scheme, control);
  compare_ending(rows, how + ": ended", out);
  if (jacobians) {
    const auto asked = static_cast<double>(*jacobians - before);
    rows.at_least(how + ": Jacobians", {.limit = 10.0, .computed = asked, .because = "it changes by decades"});
    rows.at_most(how + ": Jacobians, over steps", {.limit = 0.9,
                                                   .computed = asked / static_cast<double>(out.steps),
                                                   .because = "kept where the sweeps contract fast"});
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    rows.compare(fmt::format("{}: y{}", how, k + 1), {.expected = known.end.y[k],
                                                      .computed = state.y[k],
                                                      .tolerance = relative(1e-10),
                                                      .because = "ten digits, the catalogue's goal"});
  }
}

// Radau 3 needs more and smaller steps: its estimate has order 3, so that the steps, not the errors, follow TOL.
template <class P>
void compare_by_both_radau(Rows& rows, const Eigen::Vector3d& sizes) {
  Counting<P> given;
  const WithoutJacobian<P> without;
  Published known{.start = P::start(), .end = P::published(), .sizes = sizes, .TOL = 1e-7};
  compare_by_radau<Radau<5>>(rows, "Radau 5, given Jacobian", given, known, &given.jacobians);
  compare_by_radau<Radau<5>>(rows, "Radau 5, difference quotients", without, known);
  known.TOL = 1e-9;
  compare_by_radau<Radau<3>>(rows, "Radau 3, given Jacobian", given, known, &given.jacobians);
  compare_by_radau<Radau<3>>(rows, "Radau 3, difference quotients", without, known);
}

Claim claim_of_radau(const std::string& name, const std::string& problem) {
  return {.name = "collocation_" + name,
          .claim = "Radau collocation with Newton meets ten published digits of " + problem,
          .equation = "D 3.4",
          .reference = Reference::published};
}

const Case collocation_robertson{claim_of_radau("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
                                   compare_by_both_radau<Robertson>(rows, {1e-10, 1e-16, 1e-10});
                                 }};

const Case collocation_van_der_pol{claim_of_radau("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"),
                                   [](Rows& rows) {
                                     compare_by_both_radau<VanDerPol>(rows, {1.0, 1e-3, 1.0});
                                   }};

const Case collocation_oregonator{claim_of_radau("oregonator", "the Oregonator at t = 360"), [](Rows& rows) {
                                    compare_by_both_radau<Oregonator>(rows, {1.0, 1.0, 1.0});
                                  }};

void prove_collocation_pleiades(Rows& rows) {
  auto scene = pleiades();
  State state = scenes::start(scene);
  Collocation<Gauss<8>> scheme;
  ErrorControl control{.TOL = 1e-11, .sweep_TOL = 1e-14, .step = 1e-3, .limit = 0.3};
  const Outcome out = integrate(scene, state, pleiades_end, scheme, control);
  compare_ending(rows, "ended", out);
  const char* const because = "ten digits, the catalogue's goal";
  compare_first_star(rows, "", state, 1e-10, because);
}

const Case collocation_pleiades{
    {.name = "collocation_pleiades",
     .claim = "adaptive Gauss collocation meets ten published digits of seven stars under a near field",
     .equation = "D 3.4",
     .reference = Reference::published},
    prove_collocation_pleiades};

}  // namespace verification::classical
