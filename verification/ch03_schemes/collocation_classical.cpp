// Problems of the literature by the library's own methods, to ten published digits.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/integrate.hpp>

#include "classical_problems.hpp"

namespace {

using namespace particulate;
using namespace particulate::schemes;
using namespace verification;

// Any problem of first order behind one type, so that each method is compiled once.
struct AnyRate {
  std::function<bool(double, In, Out)> f;

  bool rate(double t, In y, Out dy) const { return f(t, y, dy); }
};
struct AnyRateWithJacobian : AnyRate {
  std::function<void(double, In, Eigen::MatrixXd&)> df;

  void jacobian(double t, In y, Eigen::MatrixXd& J) const { df(t, y, J); }
};

// A problem with its digits, and what a step may cost.
struct Published {
  AnyRateWithJacobian problem;
  Values start;
  double t_end;                // [s]
  std::vector<double> digits;  // at t_end
  Eigen::Vector3d sizes;       // below which errors of a step count as absolute; so many as there are digits
  double TOL;                  // of a step
  double limit;                // [s]
};

template <class P>
Published published(const P& problem, double t_end, std::vector<double> digits, const Eigen::Vector3d& sizes,
                    double TOL) {
  return {.problem = {{[problem](double t, In y, Out dy) { return problem.rate(t, y, dy); }},
                      [problem](double t, In y, Eigen::MatrixXd& J) { problem.jacobian(t, y, J); }},
          .start = P::start(),
          .t_end = t_end,
          .digits = std::move(digits),
          .sizes = sizes,
          .TOL = TOL,
          .limit = t_end};
}

template <class Nodes, class P>
void compare(Rows& rows, const std::string& how, P problem, const Published& known) {
  const Eigen::Index n = known.start.y.size();
  Collocation<Nodes, Newton<>> scheme({.sizes = known.sizes.head(n)});
  ErrorControl control{.TOL = known.TOL,
                       .sweep_TOL = std::max(1e-3 * known.TOL, 1e-14),
                       .K_d = 3,
                       .step = 1e-6,
                       .limit = known.limit,
                       .growth = 8.0,
                       .worth = 1.2};
  Values state = known.start;
  const Outcome out = integrate(problem, state, known.t_end, scheme, control);
  rows.equal(how + ": ended", {.expected = "reached",
                               .computed = out.reason.empty() ? "reached" : out.reason,
                               .because = "there is an answer at the end only"});
  for (std::size_t k = 0; k < known.digits.size(); ++k) {
    rows.compare(fmt::format("{}: y{}", how, k + 1), {.expected = known.digits[k],
                                                      .computed = state.y[static_cast<Eigen::Index>(k)],
                                                      .tolerance = relative(1e-10),
                                                      .because = "ten digits, the catalogue's goal"});
  }
}

// Radau 3 needs more and smaller steps: its estimate has order 3, so that the steps, not the errors, follow TOL.
void compare_all(Rows& rows, Published known, double TOL_of_three) {
  const AnyRate without = known.problem;
  compare<Radau<5>>(rows, "Radau 5, given Jacobian", known.problem, known);
  compare<Radau<5>>(rows, "Radau 5, difference quotients", without, known);
  known.TOL = TOL_of_three;
  compare<Radau<3>>(rows, "Radau 3, given Jacobian", known.problem, known);
  compare<Radau<3>>(rows, "Radau 3, difference quotients", without, known);
}

Claim claim_of(const std::string& name, const std::string& problem) {
  return {.name = "collocation_" + name,
          .claim = "Radau collocation with Newton meets ten published digits of " + problem,
          .equation = "D 3.4",
          .reference = Reference::published};
}

const Case robertson{
    claim_of("robertson", "Robertson's reactions at t = 1e11"), [](Rows& rows) {
      compare_all(rows,
                  published(Robertson{}, 1e11, {2.083340149701255e-8, 8.333360770334713e-14, 0.9999999791665050},
                            {1e-10, 1e-16, 1e-10}, 1e-7),
                  1e-9);
    }};
const Case van_der_pol{
    claim_of("van_der_pol", "van der Pol's oscillator, mu = 1000, at t = 2000"), [](Rows& rows) {
      compare_all(rows,
                  published(VanDerPol{}, 2000.0, {1.706167732170469, -8.928097010248125e-4}, {1.0, 1e-3, 1.0}, 1e-7),
                  1e-9);
    }};
const Case oregonator{claim_of("oregonator", "the Oregonator at t = 360"), [](Rows& rows) {
                        compare_all(
                            rows,
                            published(Oregonator{}, 360.0, {1.000814870318523, 1228.178521549917, 132.0554942846706},
                                      {1.0, 1.0, 1.0}, 1e-7),
                            1e-9);
                      }};

const Case pleiades_case{
    {.name = "collocation_pleiades",
     .claim = "adaptive Gauss collocation meets ten published digits of seven stars under a near field",
     .equation = "D 3.4",
     .reference = Reference::published},
    [](Rows& rows) {
      auto scene = pleiades();
      Motion state = scenes::start(scene);
      Collocation<Gauss<8>> scheme;
      ErrorControl control{.TOL = 1e-11, .sweep_TOL = 1e-14, .step = 1e-3, .limit = 0.3};
      const Outcome out = integrate(scene, state, pleiades_end, scheme, control);
      rows.equal("ended", {.expected = "reached",
                           .computed = out.reason.empty() ? "reached" : out.reason,
                           .because = "there is an answer at the end only"});
      const char* const because = "ten digits, the catalogue's goal";
      rows.compare(
          "x1",
          {.expected = 0.3706139143970502, .computed = state.r[0], .tolerance = relative(1e-10), .because = because});
      rows.compare(
          "y1",
          {.expected = -3.943437585517392, .computed = state.r[7], .tolerance = relative(1e-10), .because = because});
    }};

}  // namespace
