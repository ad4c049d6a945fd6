// Motion and values that act on each other: every scheme that can advance both, its order, and CVODE beside it.

#include <cmath>
#include <string>

#include <harness/case.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "collocation_orders.hpp"

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

}  // namespace verification::order_coupled
