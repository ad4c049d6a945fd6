// Orders of Gauss and Radau IIA collocation, of the state and of the dense output, and of the family on a coupled
// problem.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/rows.hpp>
#include <harness/starts.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "linear_problems.hpp"

namespace verification::collocation_orders {

using namespace particulate::schemes;
using namespace particulate;

// Orders of the collocation family on a problem that knows its exact motion.
//
// Orders above ten leave few steps between 1e-2 and rounding, and those are long. All problems here have uniform
// circular motions: along them every step meets the same derivatives, and errors follow their leading power though
// steps are long. The problems are not linear, so that all conditions of order count.

// Distance of two states: positions, velocities and values, whichever there are.
double apart(const State& one, const State& other) {
  return std::hypot(std::hypot((one.r - other.r).norm(), (one.v - other.v).norm()), (one.y - other.y).norm());
}

// Where to measure one method: coarsest steps for the order at the end, and for that of the dense output.
struct CollocationSteps {
  double t_end;       // [s]
  long coarsest;      // steps to there, refined four times by 5/4 or a little more
  double dense_end;   // [s]
  long dense_coarse;  // steps to there
};

// A problem and its motion.
struct Known {
  const Problem& problem;
  const std::function<State(double)>& exact;
};

// Errors of one run in equal steps.
struct CollocationErrors {
  double at_end = 0.0;  // of the last state
  double inside = 0.0;  // the largest of the dense output, inside of all steps
  double joints = 0.0;  // the largest distance of the dense output from both ends of its step
};

// One run of a method.
template <class Nodes>
CollocationErrors collocation_errors(const Known& known, double t_end, long steps) {
  Collocation<Nodes> scheme;
  State state = known.exact(0.0);
  State there = state;
  CollocationErrors errors;
  const auto watch = [&](const State& from, const State& to, double dt, const Collocation<Nodes>& made) {
    for (const double theta : {0.13, 0.38, 0.61, 0.88}) {
      made.at(from, dt, theta, there);
      keep_worst(errors.inside, apart(there, known.exact(there.t)));
    }
    made.at(from, dt, 0.0, there);
    keep_worst(errors.joints, apart(there, from));
    made.at(from, dt, 1.0, there);
    keep_worst(errors.joints, apart(there, to));
    return true;
  };
  FixedStep control{.step = t_end / static_cast<double>(steps)};
  require_reached(integrate(known.problem, state, t_end, scheme, control, watch));
  errors.at_end = apart(state, known.exact(t_end));
  return errors;
}

// Writes the rows of one method.
template <class Nodes>
void compare_collocation_order(Rows& rows, const std::string& method, const Known& known, const CollocationSteps& at) {
  const auto refine = [&](double t_end, long coarsest, double CollocationErrors::*which, double nominal,
                          const std::string& quantity, const std::string& because) {
    std::vector<double> steps, errors;
    for (long n = coarsest; steps.size() < 5; n = (n * 5 + 3) / 4) {
      steps.push_back(t_end / static_cast<double>(n));
      errors.push_back(collocation_errors<Nodes>(known, t_end, n).*which);
    }
    rows.order(method + ": " + quantity,
               {.nominal = nominal, .steps = steps, .errors = errors, .floor = 1e-16, .because = because});
  };
  refine(at.t_end, at.coarsest, &CollocationErrors::at_end, Nodes::order, "state at the end",
         "2 s for Gauss, 2 s - 1 for Radau IIA: the order of the quadrature, on a smooth right-hand side, at no "
         "multiple of the period; sweeps to rounding");
  const int uniform = std::min(Nodes::stages + 1, Nodes::order);
  refine(at.dense_end, at.dense_coarse, &CollocationErrors::inside, uniform, "largest error inside the steps",
         "a polynomial of degree s misses the motion by a power s + 1 of the step, unless the ends are worse");
  rows.at_most(method + ": dense output off the ends of its step",
               {.limit = 16.0 * eps,
                .computed = collocation_errors<Nodes>(known, at.dense_end, 4 * at.dense_coarse).joints,
                .because = "the polynomial passes through both, its sums rounded once more in states near 1"});
}

// All methods on one problem that knows its motion, `exact(t)`; one line each for Gauss 1 ... 7, Radau 1, 2, 3 and, if
// it is there, Gauss 8.
template <class P>
void compare_collocation_orders(Rows& rows, const P& problem, const std::vector<CollocationSteps>& at) {
  const Problem seen(problem);
  const std::function<State(double)> exact = [&](double t) { return problem.exact(t); };
  const Known known{.problem = seen, .exact = exact};
  compare_collocation_order<Gauss<1>>(rows, "Gauss 1", known, at.at(0));
  compare_collocation_order<Gauss<2>>(rows, "Gauss 2", known, at.at(1));
  compare_collocation_order<Gauss<3>>(rows, "Gauss 3", known, at.at(2));
  compare_collocation_order<Gauss<4>>(rows, "Gauss 4", known, at.at(3));
  compare_collocation_order<Gauss<5>>(rows, "Gauss 5", known, at.at(4));
  compare_collocation_order<Gauss<6>>(rows, "Gauss 6", known, at.at(5));
  compare_collocation_order<Gauss<7>>(rows, "Gauss 7", known, at.at(6));
  compare_collocation_order<Radau<1>>(rows, "Radau 1", known, at.at(7));
  compare_collocation_order<Radau<2>>(rows, "Radau 2", known, at.at(8));
  compare_collocation_order<Radau<3>>(rows, "Radau 3", known, at.at(9));
  if (at.size() > 10) compare_collocation_order<Gauss<8>>(rows, "Gauss 8", known, at[10]);
}

// Orders of Gauss and Radau IIA collocation under a near field, forces that depend on positions only.

const Eigen::Vector3d across{3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0};
constexpr double alpha2 = 0.3;

// Two unit masses that circle each other at the distance 1: omega^2 = A - B with A = 2 and B = 2 alpha2.
struct CirclingPair {
  NearFieldScene scene{pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
  double omega = std::sqrt(2.0 - 2.0 * alpha2);

  bool acceleration(double t, schemes::In r, schemes::Out a) const { return scene.acceleration(t, r, a); }
  double distance(schemes::In x, schemes::In y) const { return scene.distance(x, y); }
  schemes::State exact(double t) const {
    const Eigen::Vector3d r = std::cos(omega * t) * slanted() + std::sin(omega * t) * across;
    const Eigen::Vector3d v = omega * (std::cos(omega * t) * across - std::sin(omega * t) * slanted());
    kinematics::Vectors places(2, 3), velocities(2, 3);
    kinematics::set_vector(places, 0, -0.5 * r);
    kinematics::set_vector(places, 1, 0.5 * r);
    kinematics::set_vector(velocities, 0, -0.5 * v);
    kinematics::set_vector(velocities, 1, 0.5 * v);
    return {.t = t, .r = places.reshaped(), .v = velocities.reshaped()};
  }
};

const Case order_collocation_near_field{
    {.name = "order_collocation_near_field",
     .claim = "under a near field Gauss collocation has order 2 s and Radau IIA 2 s - 1, neither less nor more, and "
              "their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      CirclingPair pair;
      compare_collocation_orders(rows, pair,
                                 {{.t_end = 2.3, .coarsest = 60, .dense_end = 2.3, .dense_coarse = 60},
                                  {.t_end = 2.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 200},
                                  {.t_end = 20.3, .coarsest = 24, .dense_end = 2.3, .dense_coarse = 16},
                                  {.t_end = 20.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 12},
                                  {.t_end = 20.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 8},
                                  {.t_end = 20.3, .coarsest = 10, .dense_end = 4.6, .dense_coarse = 8},
                                  {.t_end = 20.3, .coarsest = 8, .dense_end = 7.9, .dense_coarse = 8},
                                  {.t_end = 2.3, .coarsest = 3000, .dense_end = 2.3, .dense_coarse = 3000},
                                  {.t_end = 2.3, .coarsest = 40, .dense_end = 2.3, .dense_coarse = 40},
                                  {.t_end = 2.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 24},
                                  {.t_end = 20.9, .coarsest = 6, .dense_end = 11.3, .dense_coarse = 8}});
    }};

// Steps on the unit circle for all but Gauss 8; only those of Gauss 7 differ between its problems.
std::vector<CollocationSteps> on_the_unit_circle(long gauss_7) {
  return {{.t_end = 2.3, .coarsest = 60, .dense_end = 2.3, .dense_coarse = 60},
          {.t_end = 2.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 200},
          {.t_end = 28.3, .coarsest = 76, .dense_end = 2.3, .dense_coarse = 16},
          {.t_end = 28.3, .coarsest = 36, .dense_end = 2.3, .dense_coarse = 12},
          {.t_end = 28.3, .coarsest = 20, .dense_end = 2.3, .dense_coarse = 8},
          {.t_end = 28.3, .coarsest = 15, .dense_end = 4.6, .dense_coarse = 8},
          {.t_end = 28.3, .coarsest = gauss_7, .dense_end = 7.9, .dense_coarse = 8},
          {.t_end = 2.3, .coarsest = 3000, .dense_end = 2.3, .dense_coarse = 3000},
          {.t_end = 2.3, .coarsest = 40, .dense_end = 2.3, .dense_coarse = 40},
          {.t_end = 2.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 24}};
}

// Orders of Gauss and Radau IIA collocation on a problem of first order whose rate depends on time.

// A body about an attracting centre that is driven by a turning push: y = (r, v) with
// r'' = -(1 - q) r/|r|^3 - q (cos t, sin t). The push agrees with the circle of radius 1.
struct DrivenOrbit {
  double q = 0.2;

  bool rate(double t, In y, Out dy) const {
    const double d = std::hypot(y[0], y[1]), pull = (1.0 - q) / (d * d * d);
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = -pull * y[0] - q * std::cos(t);
    dy[3] = -pull * y[1] - q * std::sin(t);
    return true;
  }
  State exact(double t) const {
    return {.t = t, .y = Eigen::Vector4d{std::cos(t), std::sin(t), -std::sin(t), std::cos(t)}};
  }
};

const Case order_collocation_values{
    {.name = "order_collocation_values",
     .claim = "on a problem of first order whose rate depends on time Gauss collocation has order 2 s and Radau IIA "
              "2 s - 1, neither less nor more, and their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      DrivenOrbit orbit;
      std::vector<CollocationSteps> at = on_the_unit_circle(10);
      at.push_back({.t_end = 28.3, .coarsest = 8, .dense_end = 11.3, .dense_coarse = 8});
      compare_collocation_orders(rows, orbit, at);
    }};

// Orders of Gauss and Radau IIA collocation under a force that depends on velocities.

// A charge about an attracting centre in a magnetic field that decays from it: r'' = -(1 - q) r/|r|^3 + q J v/|r|^2,
// with J a quarter turn. On the unit circle both parts pull inwards, and the sum is 1.
struct ChargeInField {
  double q = 0.4;

  bool acceleration(double, In r, In v, Out a) const {
    const double d = r.norm();
    a = -(1.0 - q) / (d * d * d) * r + q / (d * d) * Eigen::Vector2d{-v[1], v[0]};
    return true;
  }
  State exact(double t) const {
    return {.t = t, .r = Eigen::Vector2d{std::cos(t), std::sin(t)}, .v = Eigen::Vector2d{-std::sin(t), std::cos(t)}};
  }
};

const Case order_collocation_velocity{
    {.name = "order_collocation_velocity",
     .claim = "under a force that depends on velocities Gauss collocation has order 2 s and Radau IIA 2 s - 1, neither "
              "less nor more, and their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      ChargeInField charge;
      std::vector<CollocationSteps> at = on_the_unit_circle(11);
      at.push_back({.t_end = 28.3, .coarsest = 7, .dense_end = 11.3, .dense_coarse = 6});
      compare_collocation_orders(rows, charge, at);
    }};

// Motion and values that act on each other: every scheme that can advance both, its order, and CVODE beside it.

// A charge on the unit circle, as in order_collocation_velocity, in a field that a dipole y makes stronger, and the
// dipole, which follows the charge: with |r| = 1 and y = v the field pulls inwards by q, and y' = -r. Off the circle
// each feels the other, and the force feels the velocity. Errors of the start grow by 30 in 28 s.
struct ChargeAndDipole {
  double q = 0.4, k = 0.5, l = -0.3;

  bool rates(double, In r, In v, In y, Out a, Out dy) const {
    const double d = r.norm(), field = q * (0.7 + 0.3 * y.dot(v));
    a = -(1.0 - q) / (d * d * d) * r + field / (d * d) * Eigen::Vector2d{-v[1], v[0]};
    dy = (0.2 * y.squaredNorm() - 1.2) * r + k * (v - y) + l * r.dot(y) * v;
    return true;
  }
  State exact(double t) const {
    const Eigen::Vector2d r{std::cos(t), std::sin(t)}, v{-std::sin(t), std::cos(t)};
    return {.t = t, .r = r, .v = v, .y = v};
  }
};

// The same without velocities: a body about a centre whose pull is y.r, and y that is drawn to r.
struct PlaceAndDipole {
  static constexpr bool ignores_velocities = true;
  double k = 0.5, l = 0.3;

  bool rates(double, In r, In, In y, Out a, Out dy) const {
    const double d = r.norm();
    a = -y.dot(r) / (d * d * d) * r;
    dy = y.squaredNorm() * Eigen::Vector2d{-r[1], r[0]} + k * (r - y) + l * (d - 1.0) * r;
    return true;
  }
  State exact(double t) const {
    const Eigen::Vector2d r{std::cos(t), std::sin(t)}, v{-std::sin(t), std::cos(t)};
    return {.t = t, .r = r, .v = v, .y = r};
  }
};

template <class P, class S>
void compare_order(Rows& rows, const std::string& method, double order, long coarsest, const P& problem,
                   const S& scheme) {
  constexpr double t_end = 2.3;
  std::vector<double> steps, errors;
  for (long n = coarsest; steps.size() < 5; n = n * 3 / 2) {
    State state = problem.exact(0.0);
    steps.push_back(t_end / static_cast<double>(n));
    reach(problem, state, t_end, scheme, FixedStep{.step = steps.back()});
    errors.push_back(apart(state, problem.exact(t_end)));
  }
  rows.order(method, {.nominal = order,
                      .steps = steps,
                      .errors = errors,
                      .floor = 1e-15,
                      .because = "places, velocities and values together, smooth, sweeps to rounding"});
}

template <class P>
void compare_orders(Rows& rows, const std::string& problem_name, const P& problem) {
  const auto compare = [&](const std::string& method, double order, long coarsest, const auto& scheme) {
    compare_order(rows, problem_name + ", " + method, order, coarsest, problem, scheme);
  };
  compare("forward Euler", 1.0, 4000, ForwardEuler{});
  compare("backward Euler", 1.0, 4000, BackwardEuler{});
  compare("phi = 0.7, Anderson", 1.0, 4000, PhiFamily<Anderson>(0.7));
  compare("phi = 1/2", 2.0, 100, BackwardEuler(0.5));
  compare("RK4", 4.0, 30, RungeKutta4{});
  compare("Gauss 2, all stages at once", 4.0, 16, Collocation<Gauss<2>, Picard>{});
  compare("Gauss 2, Anderson", 4.0, 16, Collocation<Gauss<2>, Anderson>{});
  compare("Gauss 2, Newton", 4.0, 16, Collocation<Gauss<2>, Newton<>>{});
  compare("Radau 2, Newton", 3.0, 40, Collocation<Radau<2>, Newton<>>{});
}

const Case order_coupled{
    {.name = "order_coupled",
     .claim =
         "where motion and values act on each other every scheme that can advance both has its order, neither less "
         "nor more",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      compare_orders(rows, "charge and dipole", ChargeAndDipole{});
      compare_orders(rows, "place and dipole, forces ignore velocities", PlaceAndDipole{});
    }};

const Case order_collocation_coupled{
    {.name = "order_collocation_coupled",
     .claim = "where motion and values act on each other Gauss collocation of up to seven stages has order 2 s "
              "and Radau IIA 2 s - 1, neither less nor more, and their dense output has error s + 1",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      ChargeAndDipole problem;
      compare_collocation_orders(rows, problem, on_the_unit_circle(11));
    }};

// A hot ball that falls through what drags it and that it heats: m = c = 1, the drag grows with its temperature and all
// that it takes becomes heat, of which a share is lost.
struct DragAndHeat {
  bool rates(double, In, In v, In y, Out a, Out dy) const {
    const double drag = 0.2 * (1.0 + 0.5 * y[0]);
    a = -drag * v;
    a[1] -= 1.0;
    dy[0] = drag * v.squaredNorm() - 0.7 * y[0];
    return true;
  }
};

void prove_coupled_against_sundials(Rows& rows) {
  namespace reference = particulate::reference;
  DragAndHeat problem;
  constexpr double t_end = 4.0;
  const State start{
      .t = 0.0, .r = Eigen::Vector2d{0.0, 3.0}, .v = Eigen::Vector2d{2.0, 0.5}, .y = Eigen::VectorXd::Constant(1, 0.3)};
  const auto by_sundials = [&](const reference::Method& method) {
    State state = start;
    require_reached(reference::integrate(problem, state, t_end, method));
    return state;
  };
  const State arkode = by_sundials(
      reference::ExplicitRungeKutta{.table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14});
  const State cvode = by_sundials(reference::Adams{.relative = 1e-13, .absolute = 1e-13});
  const State bdf = by_sundials(reference::Bdf{.relative = 1e-11, .absolute = 1e-11});
  rows.compare("CVODE, Adams, from ARKODE", {.expected = 0.0,
                                             .computed = apart(cvode, arkode),
                                             .tolerance = absolute(1e-10),
                                             .because = "two families at their tightest; Adams is good to 1e-11"});
  rows.compare("CVODE, BDF, from ARKODE", {.expected = 0.0,
                                           .computed = apart(bdf, arkode),
                                           .tolerance = absolute(2e-8),
                                           .because = "BDF is good to some 1e-9"});
  const auto compare = [&](const std::string& method, auto scheme, double tolerance, const std::string& because) {
    State state = start;
    reach(problem, state, t_end, scheme, FixedStep{.step = t_end / 400.0});
    rows.compare(
        method + " from ARKODE",
        {.expected = 0.0, .computed = apart(state, arkode), .tolerance = absolute(tolerance), .because = because});
  };
  compare("RK4", RungeKutta4{}, 1e-9, "order 4: (1/100)^4 over some hundreds");
  compare("phi = 1/2", BackwardEuler(0.5), 1e-4, "order 2: (1/100)^2");
  compare("Gauss 4", Collocation<Gauss<4>>{}, 2e-12, "order 8: rounding, and that of ARKODE");
  compare("Radau 3, Newton", Collocation<Radau<3>, Newton<>>{}, 2e-12, "order 5: (1/100)^5 over some hundreds");
}

const Case coupled_against_sundials{
    {.name = "coupled_against_sundials",
     .claim = "a ball whose drag heats it, and whose heat changes its drag, ends where CVODE and ARKODE end",
     .equation = "D 3.4",
     .reference = Reference::sundials},
    prove_coupled_against_sundials};

}  // namespace verification::collocation_orders
