#include "collocation_orders.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace verification {

double apart(const particulate::schemes::State& one, const particulate::schemes::State& other) {
  return std::hypot(std::hypot((one.r - other.r).norm(), (one.v - other.v).norm()), (one.y - other.y).norm());
}

namespace collocation_orders {

using namespace particulate::schemes;

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

}  // namespace collocation_orders

void compare_collocation_orders(Rows& rows, const particulate::schemes::Problem& problem,
                                const std::function<particulate::schemes::State(double)>& exact,
                                const std::vector<CollocationSteps>& at) {
  using namespace collocation_orders;
  const Known known{.problem = problem, .exact = exact};
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

}  // namespace verification
