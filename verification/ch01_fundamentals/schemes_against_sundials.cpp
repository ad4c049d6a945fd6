// A cloud under near fields: two reference integrators of different families agree, and then our schemes with them.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "references.hpp"

namespace verification::schemes_against_sundials {

using namespace particulate;

constexpr double t_end = 2.3;

// Largest difference of positions over the cloud's size, and of velocities over the largest speed.
double difference(const schemes::State& one, const schemes::State& other) {
  return std::max((one.r - other.r).lpNorm<Eigen::Infinity>() / other.r.lpNorm<Eigen::Infinity>(),
                  (one.v - other.v).lpNorm<Eigen::Infinity>() / other.v.lpNorm<Eigen::Infinity>());
}

template <class S>
schemes::State by_steps(NearFieldScene& scene, long steps) {
  schemes::State state = scenes::start(scene);
  advance<S>(scene, state, t_end, steps);
  return state;
}

schemes::State by_reference(NearFieldScene& scene, const reference::Method& method) {
  schemes::State state = scenes::start(scene);
  advance_by(method, scene, state, t_end);
  return state;
}

// A scheme may be as far from the judge as halving its steps moves it, times 1/(1 - 2^-order) and a fifth; and no
// farther than `worst`, so that a scheme cannot excuse itself by being coarse.
template <class S>
void compare_scheme(Rows& rows, const std::string& what, NearFieldScene& scene, const schemes::State& judge, long steps,
                    double worst) {
  const schemes::State coarse = by_steps<S>(scene, steps), fine = by_steps<S>(scene, 2 * steps);
  const double moved = difference(coarse, fine);
  rows.at_most(
      what, {.limit = std::min(worst, 1.2 * moved / (1.0 - std::pow(0.5, S::order)) + 1e-10),
             .computed = difference(coarse, judge),
             .because = fmt::format("halving the step moves it by {:.2g}, which bounds its error; references agree to "
                                    "1e-10; at most {:g}",
                                    moved, worst)});
}

void compare(Rows& rows, const laws::NearField& law) {
  NearFieldScene scene(random_cloud({.N = 20}, smooth), {}, law);
  const schemes::State judge = by_reference(scene, fehlberg);
  const std::string which = fmt::format(" against ARKODE Fehlberg, beta = ({}, {})", law.beta1, law.beta2);
  const char* const because =
      "tolerances of 1e-13 and 1e-14 with global errors some hundred times larger, in a motion "
      "that amplifies them tenfold";
  rows.at_least("start" + which, {.limit = 0.1,
                                  .computed = difference(scenes::start(scene), judge),
                                  .because = "else there is nothing to agree on"});
  rows.at_most("CVODE Adams" + which,
               {.limit = 1e-10, .computed = difference(by_reference(scene, adams), judge), .because = because});
  rows.at_most(
      "ARKODE Dormand-Prince" + which,
      {.limit = 1e-10, .computed = difference(by_reference(scene, dormand_prince), judge), .because = because});
  compare_scheme<schemes::RungeKutta4>(rows, "RK4" + which, scene, judge, 4000, 1e-6);
  compare_scheme<schemes::VelocityVerlet>(rows, "velocity Verlet" + which, scene, judge, rows.quick() ? 10000 : 40000,
                                          1e-4);
}

const Case schemes_against_sundials{{.name = "schemes_against_sundials",
                                     .claim = "RK4 and velocity Verlet move a cloud as CVODE and ARKODE do",
                                     .equation = "M 2.1",
                                     .reference = Reference::sundials},
                                    [](Rows& rows) {
                                      compare(rows, {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0});
                                      compare(rows, {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.3, .beta2 = 2.7});
                                    }};

}  // namespace verification::schemes_against_sundials
