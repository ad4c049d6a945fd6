// Motion and values that act on each other: how Newton solves both, how their sweeps are measured apart, and values
// that change by jumps alone.

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/linear_algebra.hpp>
#include <harness/motions.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "linear_problems.hpp"
#include "pade.hpp"

namespace verification::coupled {

using namespace particulate::schemes;

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
  const Eigen::Vector3d right = at(pade_numerator(k, j), Z) * flat(from);
  return solve(at(pade_numerator(j, k), -Z).cast<std::complex<double>>(), right.cast<std::complex<double>>()).real();
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
    contractions = particulate::report::worse_of(contractions, std::ceil(std::log(tolerance) / std::log(q)));
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

}  // namespace verification::coupled
