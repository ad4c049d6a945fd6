// Collocation against closed forms, and against the monograph's scheme.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <harness/turning_pair.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "bits.hpp"
#include "linear_problems.hpp"

namespace verification::collocation_motions {

using namespace particulate;
using namespace particulate::schemes;

// Motions with a closed form, by adaptive Gauss collocation.

// One setting for all: no case is tuned.
constexpr double TOL = 1e-11, sweep_TOL = 1e-14;
constexpr double goal = 1e-10;  // of the farthest place, of the largest speed

// One run whose legs end at the tenths of a period.
struct Mover {
  schemes::Collocation<schemes::Gauss<8>> scheme = schemes::Collocation<schemes::Gauss<8>>();
  schemes::ErrorControl control;
  long evaluations = 0;

  explicit Mover(double period)
      : control{.TOL = TOL, .sweep_TOL = sweep_TOL, .step = period / 1000.0, .limit = period / 10.0} {}

  void operator()(NearFieldScene& scene, schemes::State& state, double t_end) {
    const schemes::Outcome out = integrate(scene, state, t_end, scheme, control);
    require_reached(out);
    evaluations += out.evaluations;
  }
};

// Errors of a breathing body at tenths of a period, those of the passages at the inner turning point apart.
struct Seen {
  BreathingErrors elsewhere, passing;
  long evaluations = 0;
};

Seen follow(const ExactBreathing& exact, NearFieldScene& scene, const kinematics::Vectors& shape, int tenths) {
  const double period = exact.motion.period();
  Mover move(period);
  schemes::State state = scenes::start(scene);
  Seen seen;
  for (int k = 1; k <= tenths; ++k) {
    move(scene, state, period * k / 10.0);
    compare_with(exact, shape, state, k % 10 == 5 ? seen.passing : seen.elsewhere);
  }
  seen.evaluations = move.evaluations;
  return seen;
}

void write(Rows& rows, const std::string& which, const ExactBreathing& exact, const Seen& seen) {
  const char* const asked = "the catalogue's goal";
  rows.at_most("positions over the farthest place, " + which,
               {.limit = goal, .computed = std::max(seen.elsewhere.position, seen.passing.position), .because = asked});
  rows.at_most("velocities over the largest speed, " + which,
               {.limit = goal, .computed = seen.elsewhere.velocity, .because = asked});
  const double shift = 1e-14 * exact.depth() * exact.motion.period();
  const double stands = shift * exact.largest_acceleration() / exact.largest_speed();
  rows.at_most("velocities over the largest speed at the inner turning point, " + which,
               {.limit = std::max(goal, stands),
                .computed = seen.passing.velocity,
                .because = fmt::format("the goal, or what a shift of the motion by {:.1g} s makes there: fifty "
                                       "roundings of energies {:.2g} times the total change the period by as much",
                                       shift, exact.depth())});
}

void compare_pair(Rows& rows, double m_i, double m_j, double alpha1, double alpha2) {
  const ExactBreathing exact{.force = kinematics::breathing_pair(alpha1, alpha2, m_i, m_j), .r_0 = 1.0};
  NearFieldScene scene(pair_at_rest(m_i, m_j, 1.0), {},
                       {.alpha1 = alpha1, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0});
  const std::string which = fmt::format("masses {:g} and {:g}, alpha2 = {:.3g}", m_i, m_j, alpha2);
  write(rows, which, exact, follow(exact, scene, pair_shape(m_i, m_j), 30));
}

const Case collocation_breathing_pair{
    {.name = "collocation_breathing_pair",
     .claim = "adaptive Gauss collocation keeps breathing pairs of any stiffness and any masses within 1e-10 of "
              "Kepler's equation at thirty tenths of a period",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double alpha2 : {0.5, 0.1, 0.01, 0.001}) compare_pair(rows, 1.0, 1.0, 1.0, alpha2);
      compare_pair(rows, 1.0, 3.0, 1.0, 0.5);
      compare_pair(rows, 0.07, 0.01, 50.0, 25.0);
      compare_pair(rows, 1.0, 1e12, 4.0 / (1e12 + 1.0), 2.0 / (1e12 + 1.0));
    }};

const Case collocation_breathing_polygon{
    {.name = "collocation_breathing_polygon",
     .claim = "adaptive Gauss collocation keeps breathing polygons within 1e-10 of R'' = -A/R^2 + B/R^3 at twenty "
              "tenths of a period, though they are unstable",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const int N : {3, 5}) {
        const kinematics::Vectors corners = kinematics::regular_polygon(N);
        const ExactBreathing exact{.force = kinematics::breathing_body(1.0, 0.5, 1.0, corners), .r_0 = 1.0};
        NearFieldScene scene(at_rest(corners, 1.0, Eigen::VectorXd::Ones(N)), {},
                             {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0});
        write(rows, fmt::format("N = {}", N), exact, follow(exact, scene, corners, 20));
      }
    }};

// Body 1 seen from body 0, and its velocity, at an angle phi = int l_z/r^2 dt that has been integrated apart.
void compare_turned(const kinematics::Radial& at, double phi, const schemes::State& state, double fastest,
                    BreathingErrors& worst) {
  const Eigen::Vector3d along = std::cos(phi) * slanted() + std::sin(phi) * turning::across();
  const Eigen::Vector3d around = std::cos(phi) * turning::across() - std::sin(phi) * slanted();
  const Eigen::Vector3d r = (rows_of(state.r).row(1) - rows_of(state.r).row(0)).transpose();
  const Eigen::Vector3d v = (rows_of(state.v).row(1) - rows_of(state.v).row(0)).transpose();
  keep_worst(worst.position, (r - at.r * along).norm());
  keep_worst(worst.velocity, (v - at.v * along - turning::l_z / at.r * around).norm() / fastest);
}

const Case collocation_rotating_pair{
    {.name = "collocation_rotating_pair",
     .claim = "adaptive Gauss collocation keeps a breathing pair that turns within 1e-10 of its closed form",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Breathing exact(turning::force(), 1.0);
      NearFieldScene scene = turning::pair();
      schemes::State state = scenes::start(scene);
      Mover move(exact.period());
      BreathingErrors worst;
      double phi = 0.0;
      const double fastest = turning::l_z / exact.nearest();  // around, where there is no speed along
      for (int k = 1; k <= 30; ++k) {
        move(scene, state, exact.period() * k / 10.0);
        phi += turning::turned(exact, k);
        compare_turned(exact.at(state.t), phi, state, fastest, worst);
      }
      const char* const asked = "the catalogue's goal";
      rows.at_most("separation over the largest [-]", {.limit = goal, .computed = worst.position, .because = asked});
      rows.at_most("its velocity over the largest [-]", {.limit = goal, .computed = worst.velocity, .because = asked});
    }};

// The monograph's scheme, backward Euler by fixed point from free flight, is the one-stage member of the family.

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
  rows.none(fmt::format("{}: numbers that differ in the guess and {} iterates", which, sweeps), iterates, because);
  rows.none(fmt::format("{}: numbers that differ in the error measures of {} sweeps", which, sweeps), iterations,
            because);
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
  rows.none(which + ": numbers that differ at the end of a run under Phi_K control",
            verification::differing(by_book, by_family) + static_cast<long>(of_book.dt() != of_family.dt()) +
                static_cast<long>(first.contraction != second.contraction),
            "the same operations in the same order");
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

}  // namespace verification::collocation_motions
