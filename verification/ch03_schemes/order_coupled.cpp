// Motion and values that act on each other: every scheme that can advance both, its order, and CVODE beside it; how
// their sweeps are measured apart and solved by Newton, and values that change by jumps alone.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/LU>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "collocation_orders.hpp"
#include "endings.hpp"
#include "pade.hpp"

namespace verification::order_coupled {

using namespace particulate::schemes;

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
    S fresh = scheme;
    FixedStep control{.step = t_end / static_cast<double>(n)};
    require_reached(integrate(problem, state, t_end, fresh, control));
    steps.push_back(t_end / static_cast<double>(n));
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
      compare_collocation_orders(rows, problem,
                                 {{.t_end = 2.3, .coarsest = 60, .dense_end = 2.3, .dense_coarse = 60},
                                  {.t_end = 2.3, .coarsest = 12, .dense_end = 2.3, .dense_coarse = 200},
                                  {.t_end = 28.3, .coarsest = 76, .dense_end = 2.3, .dense_coarse = 16},
                                  {.t_end = 28.3, .coarsest = 36, .dense_end = 2.3, .dense_coarse = 12},
                                  {.t_end = 28.3, .coarsest = 20, .dense_end = 2.3, .dense_coarse = 8},
                                  {.t_end = 28.3, .coarsest = 15, .dense_end = 4.6, .dense_coarse = 8},
                                  {.t_end = 28.3, .coarsest = 11, .dense_end = 7.9, .dense_coarse = 8},
                                  {.t_end = 2.3, .coarsest = 3000, .dense_end = 2.3, .dense_coarse = 3000},
                                  {.t_end = 2.3, .coarsest = 40, .dense_end = 2.3, .dense_coarse = 40},
                                  {.t_end = 2.3, .coarsest = 16, .dense_end = 2.3, .dense_coarse = 24}});
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

const Case coupled_against_sundials{
    {.name = "coupled_against_sundials",
     .claim = "a ball whose drag heats it, and whose heat changes its drag, ends where CVODE and ARKODE end",
     .equation = "D 3.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      namespace reference = particulate::reference;
      DragAndHeat problem;
      constexpr double t_end = 4.0;
      const State start{.t = 0.0,
                        .r = Eigen::Vector2d{0.0, 3.0},
                        .v = Eigen::Vector2d{2.0, 0.5},
                        .y = Eigen::VectorXd::Constant(1, 0.3)};
      const auto by_sundials = [&](const reference::Method& method) {
        State state = start;
        require_reached(reference::integrate(problem, state, t_end, method));
        return state;
      };
      const State arkode = by_sundials(reference::ExplicitRungeKutta{
          .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14});
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
        FixedStep control{.step = t_end / 400.0};
        require_reached(integrate(problem, state, t_end, scheme, control));
        rows.compare(
            method + " from ARKODE",
            {.expected = 0.0, .computed = apart(state, arkode), .tolerance = absolute(tolerance), .because = because});
      };
      compare("RK4", RungeKutta4{}, 1e-9, "order 4: (1/100)^4 over some hundreds");
      compare("phi = 1/2", BackwardEuler(0.5), 1e-4, "order 2: (1/100)^2");
      compare("Gauss 4", Collocation<Gauss<4>>{}, 2e-12, "order 8: rounding, and that of ARKODE");
      compare("Radau 3, Newton", Collocation<Radau<3>, Newton<>>{}, 2e-12, "order 5: (1/100)^5 over some hundreds");
    }};

// A body on a stiff spring that a value pulls, and the value, which place and speed drive. Over the step below every
// block of the Jacobian outweighs 1.
struct StiffBoth {
  static constexpr double step = 0.1;
  Eigen::Matrix3d A{{0.0, 1.0, 0.0}, {-4000.0, -30.0, 900.0}, {-250.0, -20.0, -100.0}};

  bool rates(double, In r, In v, In y, Out a, Out dy) const {
    const Eigen::Vector3d rate = A * Eigen::Vector3d{r[0], v[0], y[0]};
    a[0] = rate[1];
    dy[0] = rate[2];
    return true;
  }
};
struct GivenBoth : StiffBoth {
  void jacobian(double, In, In, In, Eigen::MatrixXd& J) const { J = A.bottomRows(2); }
};

State start_of_both() { return {.r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1), .y = motion(-2, 0).r}; }

// The Pade approximation of exp(step A) applied to the start.
Eigen::Vector3d pade_step(int k, int j, const State& from) {
  const Eigen::Matrix3d Z = StiffBoth::step * StiffBoth{}.A;
  const auto at = [](const std::vector<long double>& of, const Eigen::Matrix3d& X) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (auto c = of.rbegin(); c != of.rend(); ++c) {
      sum = sum * X + static_cast<double>(*c) * Eigen::Matrix3d::Identity();
    }
    return sum;
  };
  return at(pade_numerator(j, k), -Z).partialPivLu().solve(at(pade_numerator(k, j), Z) * flat(from));
}

template <class Nodes>
void compare_newton(Rows& rows, const std::string& which, const Problem& problem, const Eigen::Vector3d& expected) {
  State state = start_of_both();
  Collocation<Nodes, Newton<>> scheme;
  FixedStep control{.step = StiffBoth::step, .TOL = 1e-9};
  const Outcome out = integrate(problem, state, control.step, scheme, control);
  require_reached(out);
  rows.compare("state after a step, from the Pade approximation, over it, " + which,
               {.expected = 0.0,
                .computed = (flat(state) - expected).norm() / expected.norm(),
                .tolerance = absolute(1e-12),
                .because = "a few thousand roundings: the condition of the system is some 1e4"});
  rows.equal("sweeps of that step, to 1e-9, " + which,
             {.expected = 2,
              .computed = out.sweeps,
              .because = "the first solves what is linear, differences of which are exact, the second sees it"});
}

const Case newton_coupled{
    {.name = "newton_coupled",
     .claim =
         "where motion and values act on each other Newton solves what is linear in one sweep, with the Jacobian of "
         "all rates by all of places, velocities and values, given or by differences",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const StiffBoth differences;
      const GivenBoth given;
      const Eigen::Vector3d gauss = pade_step(2, 2, start_of_both()), radau = pade_step(2, 3, start_of_both());
      compare_newton<Gauss<2>>(rows, "Gauss 2, by differences", differences, gauss);
      compare_newton<Gauss<2>>(rows, "Gauss 2, given", given, gauss);
      compare_newton<Radau<3>>(rows, "Radau 3, by differences", differences, radau);
      compare_newton<Radau<3>>(rows, "Radau 3, given", given, radau);
      rows.must_be_refused("the same by sequential sweeps", "diverge Dt", [&] {
        State state = start_of_both();
        Collocation<Gauss<2>> scheme;
        FixedStep control{.step = StiffBoth::step};
        return ending_of(integrate(differences, state, control.step, scheme, control));
      });
    }};

// Three parts that do not see one another, of very different units and at rest but for what they do by themselves: a
// sweep of backward Euler over 1 s brings each nearer to its end by its own q, from w_0 = 1.
struct ThreeParts {
  static constexpr bool ignores_velocities = true;
  double q_motion = 0.01, q_heat = 0.01, q_charge = 0.01, TOL_charge = 1.0;

  bool rates(double, In r, In, In y, Out a, Out dy) const {
    a = -q_motion * r;
    dy[0] = -q_heat * y[0];
    dy[1] = -q_charge * y[1];
    return true;
  }
  std::vector<Range> ranges() const {
    return {{.name = "heat", .first = 0, .size = 1}, {.name = "charge", .first = 1, .size = 1, .TOL = TOL_charge}};
  }
};

void compare_parts(Rows& rows, const std::string& which, const ThreeParts& problem) {
  constexpr double TOL = 1e-6;
  PhiControl control{.TOL = TOL, .K_d = 40, .step = 1.0, .limit = 1e6, .growth = 1e6};
  double contractions = 0.0, smallest = control.growth;
  const auto part = [&](double q, double tolerance, double p) {
    contractions = std::max(contractions, std::ceil(std::log(tolerance) / std::log(q)));
    smallest = std::min(smallest, std::pow(std::pow(tolerance, 1.0 / control.K_d) / q, 1.0 / p));
  };
  part(problem.q_motion, TOL, 2.0);
  part(problem.q_heat, TOL, 1.0);
  part(problem.q_charge, TOL * problem.TOL_charge, 1.0);
  State state{.r = Eigen::VectorXd::Constant(1, 1e-3), .v = Eigen::VectorXd::Zero(1), .y = Eigen::Vector2d{1e3, -1e-9}};
  BackwardEuler scheme;
  const Outcome out = integrate(problem, state, 1.0, scheme, control);
  require_reached(out);
  rows.equal("sweeps of a step, " + which, {.expected = std::lround(contractions) + 1,
                                            .computed = out.sweeps,
                                            .because = "w_K = q^K of each part, until the last meets its tolerance"});
  rows.compare("Phi_K, " + which, {.expected = smallest,
                                   .computed = control.step,
                                   .tolerance = relative(1e-8),
                                   .because = "the smallest of the parts; a change of 1e-6 keeps nine digits"});
}

const Case parts_measured_apart{
    {.name = "parts_measured_apart",
     .claim = "the motion and each range of values is swept until its own error, in its own unit, meets its own "
              "tolerance, and the smallest Phi_K of them chooses the step",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_parts(rows, "the motion contracts slowest", {.q_motion = 0.4});
      compare_parts(rows, "the first range contracts slowest", {.q_heat = 0.3});
      compare_parts(rows, "the second range contracts slowest, its tolerance 1e-2",
                    {.q_charge = 0.4, .TOL_charge = 1e4});
      compare_parts(rows, "the second rules the step, the first the sweeps",
                    {.q_heat = 0.2, .q_charge = 0.4, .TOL_charge = 1e4});
    }};

// A spring whose body loses a share of its speed at the end of every step; y counts the steps and keeps the energy.
struct BrakedSpring {
  static constexpr bool values_by_jumps = true;
  bool acceleration(double, In r, Out a) const {
    a = -r;
    return true;
  }
  Jump jump(State& at, double) const {
    const double before = at.v.squaredNorm();
    at.v *= 0.99;
    const double lost = 0.5 * (before - at.v.squaredNorm());
    at.y += Eigen::Vector2d{1.0, lost};
    return {.energy_change = -lost, .unsettled = {}};
  }
};

const Case carried_by_jumps{
    {.name = "carried_by_jumps",
     .claim = "values that change by jumps alone are carried from step to step by every scheme",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto compare = [&](const std::string& method, auto scheme, double tolerance, const std::string& because) {
        const BrakedSpring problem;
        State state{.r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1), .y = Eigen::Vector2d::Zero()};
        FixedStep control{.step = 0.01};
        const Outcome out = integrate(problem, state, 5.0, scheme, control);
        require_reached(out);
        rows.equal("steps that the values have counted, " + method,
                   {.expected = out.steps, .computed = std::lround(state.y[0]), .because = "one is added a step"});
        rows.compare("energy left, and that taken [J], " + method,
                     {.expected = 0.5,
                      .computed = 0.5 * (state.r.squaredNorm() + state.v.squaredNorm()) + state.y[1],
                      .tolerance = absolute(tolerance),
                      .because = because});
      };
      const std::string rounding = "kept by each step but for some roundings, of which there are 500";
      compare("forward Euler", ForwardEuler{}, 2.5e-2,
              "grows by dt^2 of itself a step: 500 times 1e-4 of half a joule");
      compare("Verlet", VelocityVerlet{}, 1e-4, "off by (omega dt)^2/8 of itself, here and there");
      compare("phi = 1/2", BackwardEuler(0.5), 1e-13, rounding);
      compare("RK4", RungeKutta4{}, 1e-10, "off by dt^5 of itself a step at most");
      compare("Gauss 3", Collocation<Gauss<3>>{}, 1e-13, rounding);
      compare("Gauss 2, Newton", Collocation<Gauss<2>, Newton<>>{}, 1e-13, rounding);
    }};

}  // namespace verification::order_coupled
