// The monograph's scheme, backward Euler by fixed point from free flight, is the one-stage member of the family.

#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "bits.hpp"
#include "linear_problems.hpp"

namespace verification::collocation_is_the_scheme {

using namespace particulate;
using namespace particulate::schemes;

using OneStage = Collocation<Radau<1>, Picard>;

OneStage one_stage() { return OneStage({.guess = Guess::free_flight, .compensated = false}); }

long differing(const Iteration& one, const Iteration& other) {
  return static_cast<long>(one.w_0 != other.w_0) + static_cast<long>(one.w_K != other.w_K) +
         static_cast<long>(one.change != other.change) + static_cast<long>(one.rate != other.rate) +
         static_cast<long>(one.K != other.K) + static_cast<long>(one.p != other.p) +
         static_cast<long>(one.evaluated != other.evaluated) + static_cast<long>(one.rounding != other.rounding);
}

std::string counts(const Outcome& one) { return fmt::format("{} {} {}", one.steps, one.rejections, one.sweeps); }

// Iterate by iterate, with the error measure of every sweep.
void compare_sweeps(Rows& rows, const std::string& which, const Problem& problem, const State& start, double dt) {
  constexpr int sweeps = 8;
  const Sweeps book = sweep_by_hand(BackwardEuler{}, problem, start, dt, sweeps);
  const Sweeps family = sweep_by_hand(one_stage(), problem, start, dt, sweeps);
  long iterates = 0, iterations = 0;
  for (std::size_t k = 0; k < book.iterates.size(); ++k) {
    iterates += verification::differing(book.iterates[k], family.iterates.at(k));
  }
  for (std::size_t k = 0; k < book.iterations.size(); ++k) {
    iterations += differing(book.iterations[k], family.iterations.at(k));
  }
  const char* const because = "the same operations in the same order";
  rows.equal(fmt::format("{}: numbers that differ in the guess and {} iterates", which, sweeps),
             {.expected = 0, .computed = iterates, .because = because});
  rows.equal(fmt::format("{}: numbers that differ in the error measures of {} sweeps", which, sweeps),
             {.expected = 0, .computed = iterations, .because = because});
  const double moved = book.iterations.front().w_K / book.iterations.back().w_K;
  rows.at_least(which + ": contraction over the sweeps compared",
                {.limit = 10.0, .computed = moved, .because = "iterates that move, or nothing is compared"});
}

// Whole runs under the monograph's controller.
void compare_runs(Rows& rows, const std::string& which, const Problem& problem, const State& start, double t_end,
                  const PhiControl& control) {
  State by_book = start, by_family = start;
  BackwardEuler book;
  OneStage family = one_stage();
  PhiControl of_book = control, of_family = control;
  const Outcome first = integrate(problem, by_book, t_end, book, of_book);
  const Outcome second = integrate(problem, by_family, t_end, family, of_family);
  require_reached(first);
  rows.equal(
      which + ": numbers that differ at the end of a run under Phi_K control",
      {.expected = 0,
       .computed = verification::differing(by_book, by_family) + static_cast<long>(of_book.dt() != of_family.dt()) +
                   static_cast<long>(first.contraction != second.contraction),
       .because = "the same operations in the same order"});
  rows.equal(which + ": steps, refusals, sweeps",
             {.expected = counts(first), .computed = counts(second), .because = "the same decisions"});
  // On values the family estimates the error of its steps with a right-hand side more for some of them.
  if (problem.traits().motion) {
    rows.equal(which + ": right-hand sides",
               {.expected = first.evaluations, .computed = second.evaluations, .because = "one a sweep"});
  }
  rows.at_least(
      which + ": steps refused",
      {.limit = 1.0, .computed = static_cast<double>(first.rejections), .because = "refusals are compared too"});
}

const Case collocation_is_the_scheme{
    {.name = "collocation_is_the_scheme",
     .claim = "Radau collocation of one stage, swept from free flight, is the monograph's scheme to the last bit: "
              "iterates, error measures, steps and refusals",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      NearFieldScene cloud(random_cloud({.N = 8}, rows.case_seed()), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
      compare_sweeps(rows, "near field", cloud, scenes::start(cloud), 0.2);
      const Drag drag{.c = 2.0};
      const DragRate rate{.c = 2.0};
      compare_sweeps(rows, "drag, a force by velocity", drag, motion(0.3, 1.7), 0.2);
      compare_sweeps(rows, "drag, as a problem of first order", rate,
                     State{.t = 0.5, .y = Eigen::Vector3d{1.0, -0.3, 2.0}}, 0.2);

      NearFieldScene pair(pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = 0.1, .beta1 = 2.0, .beta2 = 3.0});
      compare_runs(rows, "near field", pair, scenes::start(pair), 1.5,
                   {.TOL = 1e-8, .K_d = 3, .step = 0.05, .limit = 0.05, .growth = 4.0});
      compare_runs(rows, "drag, a force by velocity", drag, motion(0.3, 1.7), 2.0,
                   {.TOL = 1e-8, .K_d = 4, .step = 0.4, .limit = 0.4});
      compare_runs(rows, "drag, as a problem of first order", rate, State{.t = 0.0, .y = Eigen::Vector2d{1.0, -0.3}},
                   2.0, {.TOL = 1e-8, .K_d = 4, .step = 0.4, .limit = 0.4});
    }};

}  // namespace verification::collocation_is_the_scheme
