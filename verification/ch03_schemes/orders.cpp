// Orders of the monograph's schemes, on a near field, with time in the right-hand side, and staggered.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/scheme_order.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>

#include "linear_problems.hpp"

namespace verification::orders {

using namespace particulate::schemes;

// Orders of the monograph's schemes on a near field. RK4 and velocity Verlet have theirs in chapter 1.

// The family's members by their own names and orders.
template <class Mixing>
struct Trapezoidal : particulate::schemes::PhiFamily<Mixing> {
  static constexpr int order = 2;
  Trapezoidal() : particulate::schemes::PhiFamily<Mixing>(0.5) {}
};
struct Weighted : particulate::schemes::PhiFamily<Picard> {
  Weighted() : PhiFamily(0.7) {}
};

constexpr auto first_order =
    "Euler schemes agree with the motion to the first power, on a smooth force, at no multiple "
    "of the period; sweeps to rounding";
constexpr auto second_order =
    "the trapezoidal rule is symmetric, on a smooth force, at no multiple of the period; "
    "sweeps to rounding";

template <class S>
auto proof(long coarsest, const char* because) {
  return [=](Rows& rows) { compare_order<S>(rows, coarsest, because); };
}

const Case order_forward_euler{{.name = "order_forward_euler",
                                .claim = "forward Euler has order 1 on a near field, neither less nor more",
                                .equation = "M 3.3",
                                .reference = Reference::convergence},
                               proof<particulate::schemes::ForwardEuler>(30000, first_order)};
const Case order_backward_euler{{.name = "order_backward_euler",
                                 .claim = "backward Euler has order 1 on a near field, neither less nor more",
                                 .equation = "M 3.5",
                                 .reference = Reference::convergence},
                                proof<particulate::schemes::BackwardEuler>(30000, first_order)};
const Case order_backward_euler_anderson{
    {.name = "order_backward_euler_anderson",
     .claim = "backward Euler solved by Anderson's iteration has order 1 on a near field, neither less nor more",
     .equation = "M 3.5",
     .reference = Reference::convergence},
    proof<particulate::schemes::PhiFamily<Anderson>>(30000, first_order)};
const Case order_phi{{.name = "order_phi",
                      .claim = "phi = 0.7 has order 1 on a near field, neither less nor more",
                      .equation = "R 3.3",
                      .reference = Reference::convergence},
                     proof<Weighted>(20000, first_order)};
const Case order_trapezoidal{{.name = "order_trapezoidal",
                              .claim = "phi = 1/2 has order 2 on a near field, neither less nor more",
                              .equation = "R 3.3",
                              .reference = Reference::convergence},
                             proof<Trapezoidal<Picard>>(480, second_order)};
const Case order_trapezoidal_anderson{
    {.name = "order_trapezoidal_anderson",
     .claim = "phi = 1/2 solved by Anderson's iteration has order 2 on a near field, neither less nor more",
     .equation = "R 3.3",
     .reference = Reference::convergence},
    proof<Trapezoidal<Anderson>>(480, second_order)};

// Orders where time enters the right-hand side, and of staggered fields.

// y' = -2 t y^2 with y(0) = 1: y = 1/(1 + t^2). Both t and y must be taken where the scheme says.
struct Bell {
  bool rate(double t, In y, Out dy) const {
    dy = -2.0 * t * y.array().square();
    return true;
  }
};

// The same curve as a motion: r'' = (6 t^2 - 2) r^3 with r(0) = 1 and v(0) = 0.
struct ForcedBell {
  bool acceleration(double t, In r, Out a) const {
    a = (6.0 * t * t - 2.0) * r.array().cube();
    return true;
  }
};

const Eigen::VectorXd& unknowns(const State& state) { return state.y.size() > 0 ? state.y : state.r; }

// Errors at the end of five refinements by 3/2.
struct Errors {
  std::vector<double> steps, errors;
};

template <class S>
Errors refine(const Problem& problem, const State& start, const Eigen::VectorXd& exact, double t_end, long coarsest,
              const S& scheme) {
  Errors found;
  for (long n = coarsest; found.steps.size() < 5; n = n * 3 / 2) {
    State state = start;
    found.steps.push_back(t_end / static_cast<double>(n));
    reach(problem, state, t_end, scheme, FixedStep{.step = found.steps.back()});
    found.errors.push_back((unknowns(state) - exact).norm() / exact.norm());
  }
  return found;
}

template <class S>
void compare_bell(Rows& rows, const std::string& method, const Problem& problem, const State& start, double order,
                  long coarsest, const S& scheme) {
  constexpr double t_end = 1.7;
  const Eigen::VectorXd exact = Eigen::VectorXd::Constant(1, 1.0 / (1.0 + t_end * t_end));
  const Errors found = refine(problem, start, exact, t_end, coarsest, scheme);
  rows.order(method, {.nominal = order,
                      .steps = found.steps,
                      .errors = found.errors,
                      .floor = 1e-15,
                      .because = "a smooth right-hand side that depends on time, sweeps to rounding"});
}

void prove_order_values(Rows& rows) {
  const auto compare = [&](const char* method, double order, long coarsest, const auto& scheme) {
    const Bell bell;
    const State start{.t = 0.0, .y = Eigen::VectorXd::Ones(1)};
    compare_bell(rows, method, bell, start, order, coarsest, scheme);
  };
  compare("forward Euler", 1.0, 200, ForwardEuler{});
  compare("backward Euler", 1.0, 200, BackwardEuler{});
  compare("backward Euler, Anderson", 1.0, 200, PhiFamily<Anderson>{});
  compare("phi = 0.7", 1.0, 200, BackwardEuler(0.7));
  compare("phi = 1/2", 2.0, 100, BackwardEuler(0.5));
  compare("phi = 1/2, Anderson", 2.0, 100, PhiFamily<Anderson>(0.5));
  compare("RK4", 4.0, 20, RungeKutta4{});
}

const Case order_values{{.name = "order_values",
                         .claim = "on a problem of first order every scheme has its order, neither less nor more",
                         .equation = "M 3.3",
                         .reference = Reference::convergence},
                        prove_order_values};

const Case order_forced{
    {.name = "order_forced",
     .claim = "under a force that depends on time every scheme has its order, neither less nor more",
     .equation = "M 3.1",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const auto compare = [&](const char* method, double order, long coarsest, const auto& scheme) {
        const ForcedBell bell;
        compare_bell(rows, method, bell, motion(1.0, 0.0), order, coarsest, scheme);
      };
      compare("forward Euler", 1.0, 4000, ForwardEuler{});
      compare("backward Euler", 1.0, 4000, BackwardEuler{});
      compare("phi = 0.7", 1.0, 4000, BackwardEuler(0.7));
      compare("phi = 1/2", 2.0, 100, BackwardEuler(0.5));
      compare("velocity Verlet", 2.0, 100, VelocityVerlet{});
      compare("RK4", 4.0, 40, RungeKutta4{});
    }};

// exp(-A t) y for a matrix whose eigenvalues are mean -+ i spin.
Eigen::Vector2d decayed(const Eigen::Matrix2d& A, double t, const Eigen::Vector2d& y) {
  const double mean = 0.5 * A.trace();
  const double spin = std::sqrt(A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0) - mean * mean);
  const Eigen::Vector2d turned = A * y - mean * y;
  return std::exp(-mean * t) * (std::cos(spin * t) * y - std::sin(spin * t) / spin * turned);
}

// Of w1'' = -c12 w2, w2'' = -c21 w1: the sum of w1 and sqrt(c12/c21) w2 oscillates, their difference grows and decays.
Eigen::Vector4d swung(double c12, double c21, double t, const Eigen::Vector4d& y) {
  const double share = std::sqrt(c12 / c21), k = std::pow(c12 * c21, 0.25);
  const double sum = y[0] + share * y[2], sum_rate = y[1] + share * y[3];
  const double rest = y[0] - share * y[2], rest_rate = y[1] - share * y[3];
  const double s = sum * std::cos(k * t) + sum_rate / k * std::sin(k * t);
  const double s_rate = -sum * k * std::sin(k * t) + sum_rate * std::cos(k * t);
  const double d = rest * std::cosh(k * t) + rest_rate / k * std::sinh(k * t);
  const double d_rate = rest * k * std::sinh(k * t) + rest_rate * std::cosh(k * t);
  return {(s + d) / 2.0, (s_rate + d_rate) / 2.0, (s - d) / (2.0 * share), (s_rate - d_rate) / (2.0 * share)};
}

void compare_staggered(Rows& rows, const std::string& how, Seen seen, const std::optional<Aitken>& relaxation) {
  constexpr double t_end = 0.9;
  const Staggered scheme({{.name = "first"}, {.name = "second"}}, seen, relaxation);
  const auto write = [&](const std::string& what, const Errors& found) {
    rows.order(what + ", " + how, {.nominal = 1.0,
                                   .steps = found.steps,
                                   .errors = found.errors,
                                   .floor = 1e-15,
                                   .because = "each field by backward Euler, sweeps to rounding"});
  };
  FirstOrderPair first;
  first.a << 1.0, 3.0, -2.0, 0.5;
  const Eigen::Vector2d two{1.0, 0.7};
  write("first-order pair", refine(first, State{.t = 0.0, .y = two}, decayed(first.a, t_end, two), t_end, 400, scheme));
  const SecondOrderPair second{.c12 = 2.0, .c21 = 0.5};
  const Eigen::Vector4d four{1.0, 0.4, 0.7, -0.3};
  write("second-order pair",
        refine(second, State{.t = 0.0, .y = four}, swung(2.0, 0.5, t_end, four), t_end, 400, scheme));
}

const Case order_staggered{
    {.name = "order_staggered",
     .claim = "fields staggered to rounding are coupled with order 1 of the Euler scheme that solves each",
     .equation = "R 7.5.2",
     .reference = Reference::convergence},
    [](Rows& rows) {
      compare_staggered(rows, "Gauss-Seidel", Seen::newest, {});
      compare_staggered(rows, "Gauss-Seidel with Aitken", Seen::newest, Aitken{});
      compare_staggered(rows, "Jacobi", Seen::previous, {});
    }};

}  // namespace verification::orders
