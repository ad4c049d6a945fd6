// Clouds under a near field by multirate collocation, against SUNDIALS.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/multirate.hpp>
#include <particulate/schemes/sampling.hpp>

#include "clouds.hpp"

namespace verification::multirate {

using namespace particulate;

constexpr double t_end = 0.25;
constexpr laws::NearField strong_near_field{.alpha1 = 0.5, .alpha2 = 0.25};
using Cloud = scenes::Scene<kinematics::Space, laws::NearField>;

// Counts the right-hand sides, whole and fast apart.
struct Count : schemes::Hook {
  long whole = 0, fast = 0;
  bool rates(const schemes::Problem& problem, Side side, const schemes::Where& at,
             const schemes::Answers& to) override {
    ++(side == Side::fast ? fast : whole);
    return side == Side::fast ? problem.rate_fast(at, to) : problem.rates(at, to);
  }
  void jacobian(const schemes::Problem& problem, const schemes::Where& at, Eigen::MatrixXd& J) override {
    problem.jacobian(at, J);
  }
  void jumped(const schemes::Jump&) override {}
};

double error(const Eigen::VectorXd& one, const Eigen::VectorXd& other) { return (one - other).cwiseAbs().maxCoeff(); }

// The places at some times, by SUNDIALS.
std::vector<Eigen::VectorXd> places_by(const Cloud& cloud, const std::vector<double>& times,
                                       const reference::Method& method) {
  std::vector<Eigen::VectorXd> places;
  schemes::State state = scenes::start(cloud);
  for (const double t : times) {
    (void)reference::integrate(cloud, state, t, method);
    places.push_back(state.r);
  }
  return places;
}

// The fewest right-hand sides by which a method of SUNDIALS comes as near, in steps of half a decade of its tolerance.
template <class Method>
long fewest(const Cloud& cloud, Method method, const Eigen::VectorXd& truth, double as_near) {
  for (int half = 10; half < 24; ++half) {
    method.relative = method.absolute = std::pow(10.0, -0.5 * half);
    schemes::State state = scenes::start(cloud);
    const schemes::Outcome outcome = reference::integrate(cloud, state, t_end, method);
    if (error(state.r, truth) <= as_near) return outcome.evaluations;
  }
  return std::numeric_limits<long>::max();
}

const Case clouds{
    {.name = "multirate_clouds",
     .claim =
         "a cloud follows its near pairs in short steps and the rest in long ones, to the accuracy of SUNDIALS at a "
         "fraction of the sums over all pairs",
     .equation = "D 3.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const Eigen::Index N = rows.quick() ? 400 : 2000;
      const Cloud cloud(book_cloud(N, 3), {}, strong_near_field);
      const std::vector<double> times{0.037, 0.11, 0.1903, t_end};
      const auto truth =
          places_by(cloud, times,
                    reference::ExplicitRungeKutta{
                        .table = reference::Table::fehlberg_13_7_8, .relative = 1e-11, .absolute = 1e-11});
      Count count;
      const schemes::Problem problem = schemes::Problem(cloud).with(count);
      schemes::State state = scenes::start(cloud);
      double between = 0.0;
      std::size_t next = 0;
      const schemes::Outcome outcome =
          schemes::integrate(problem, state, t_end, schemes::Multirate<6>({.TOL = 1e-7, .size = 1.0, .speed = 1.0}),
                             schemes::FixedSweeps{.step = rows.quick() ? 0.04 : 0.025, .sweeps = 2},
                             schemes::Sampling(times, [&](const schemes::State& at) {
                               between = report::worse_of(between, error(at.r, truth[next++]));
                             }));
      rows.equal("status",
                 {.expected = "reached", .computed = std::string(name(outcome.status)), .because = "it ends"});
      const double at_end = error(state.r, truth.back());
      rows.at_most("places at the end, in a cube of 1 m [m]",
                   {.limit = 1e-6, .computed = at_end, .because = "what the step and the tolerance are chosen for"});
      rows.at_most("places on the way, by dense output [m]",
                   {.limit = 1e-6, .computed = between, .because = "dense output is that of the short steps"});
      const Eigen::Vector3d before = kinematics::linear_momentum(cloud.particles().mass, cloud.particles().velocity);
      const Eigen::Map<const kinematics::Vectors> v(state.v.data(), N, 3);
      rows.at_most(
          "change of momentum over momentum",
          {.limit = 1e-13,
           .computed = (kinematics::linear_momentum(cloud.particles().mass, v) - before).norm() / before.norm(),
           .because = "the slow part of opposite forces is opposite"});
      const long sundials =
          std::min(fewest(cloud, reference::ExplicitRungeKutta{.table = reference::Table::fehlberg_13_7_8},
                          truth.back(), at_end),
                   fewest(cloud, reference::Adams{}, truth.back(), at_end));
      rows.at_most("sums over all pairs, over those of SUNDIALS",
                   {.limit = 0.3,
                    .computed = static_cast<double>(count.whole) / static_cast<double>(sundials),
                    .because = "two sweeps of six nodes a step, and the first guess; SUNDIALS follows each encounter "
                               "by sums over all"});
    }};

// A motion that looks the same: in micrometres, in a frame that moves, and late.
const Case elsewhere{
    {.name = "multirate_elsewhere",
     .claim = "the steps of multirate collocation do not depend on units, frame or date",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      constexpr Eigen::Index N = 80;
      const kinematics::Particles here = book_cloud(N, 5);
      struct Seen {
        Eigen::VectorXd r;
        long steps;
      };
      const auto follow = [&](double length, double speed, double t, const laws::NearField& law) {
        kinematics::Particles there = here;
        there.position *= length;
        there.radius *= length;
        there.velocity *= length;
        there.velocity.rowwise() += Eigen::RowVector3d(speed, -speed, 0.0);
        const Cloud cloud(there, {}, law);
        schemes::State state = scenes::start(cloud);
        state.t = t;
        const schemes::Outcome outcome =
            schemes::integrate(cloud, state, t + 0.125, schemes::Multirate<6>({.TOL = 1e-9}),
                               schemes::ErrorControl{.TOL = 1e-6, .sweep_TOL = 1e-8, .step = 0.015625});
        Eigen::Map<kinematics::Vectors> r(state.r.data(), N, 3);
        r.rowwise() -= 0.125 * Eigen::RowVector3d(speed, -speed, 0.0);
        return Seen{state.r / length, outcome.steps};
      };
      const Seen truth = follow(1.0, 0.0, 0.0, strong_near_field);
      const auto compare = [&](const std::string& where, const Seen& seen, double limit, const char* because) {
        rows.equal("steps, " + where,
                   {.expected = truth.steps, .computed = seen.steps, .because = "every error is a plain number"});
        rows.at_most("places, " + where, {.limit = limit, .computed = error(seen.r, truth.r), .because = because});
      };
      constexpr double small = 0x1p-20;  // d^-1 and d^-2 of it are compensated by the strengths
      compare("lengths of 2^-20 m",
              follow(small, 0.0, 0.0, {.alpha1 = 0.5 * small * small, .alpha2 = 0.25 * small * small * small}), 1e-13,
              "all lengths are scaled by a power of two");
      compare("a frame at 100 m/s", follow(1.0, 100.0, 0.0, strong_near_field), 1e-10,
              "places of up to 12.5 m round 100 times as much, and encounters multiply it");
      compare("at 1e6 s", follow(1.0, 0.0, 1e6, strong_near_field), 1e-8,
              "the length of a step is rounded to 1e-10 s at this date");
    }};

// Particles in a cube of 1 m by both.
Ending against_sundials(const kinematics::Particles& start, const laws::NearField& law) {
  const Cloud cloud(start, {}, law);
  schemes::State ours = scenes::start(cloud), theirs = ours;
  require_reached(schemes::integrate(cloud, ours, 0.2, schemes::Multirate<6>({.TOL = 1e-8}),
                                     schemes::ErrorControl{.TOL = 1e-8, .sweep_TOL = 1e-8}));
  const Eigen::Index n = ours.r.size();
  if (n > 0) {
    require_reached(
        reference::integrate(cloud, theirs, 0.2,
                             reference::ExplicitRungeKutta{
                                 .table = reference::Table::fehlberg_13_7_8, .relative = 1e-12, .absolute = 1e-12}));
  }
  return Ending::solved({.error = n > 0 ? error(ours.r, theirs.r) : 0.0,
                         .tolerance = 1e-7 * (1.0 + start.velocity.cwiseAbs().sum()),
                         .because = "the tolerance of a step, some ten steps, and encounters that multiply an error"});
}

kinematics::Particles some(Eigen::Index N) {
  kinematics::Particles all = book_cloud(N, 7);
  all.mass.setOnes();
  return all;
}

const Case extremes{
    {.name = "multirate_extremes",
     .claim =
         "multirate collocation solves scenes of none, of two, of unlike masses, stiff and hot ones, and refuses what "
         "it cannot split",
     .equation = "D 3.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const laws::NearField weak{.alpha1 = 0.05, .alpha2 = 0.01};
      for (const Eigen::Index N : {0, 1, 2, 40}) {
        rows.must_be_solved(fmt::format("{} particles", N), [&] { return against_sundials(some(N), weak); });
      }
      rows.must_be_solved("one of 1e6 kg among 30", [] {
        kinematics::Particles all = some(31);
        all.mass[0] = 1e6;
        return against_sundials(all, {.alpha1 = 1e-7, .alpha2 = 1e-8});
      });
      rows.must_be_solved("one immovable among 30", [&] {
        kinematics::Particles all = some(31);
        all.immovable.assign(31, false);
        all.immovable[5] = true;
        all.velocity.row(5).setZero();
        return against_sundials(all, weak);
      });
      rows.must_be_solved("exponents 7 and 13", [] {
        return against_sundials(some(30), {.alpha1 = 1e-7, .alpha2 = 1e-13, .beta1 = 7.0, .beta2 = 13.0});
      });
      rows.must_be_solved("an attraction that grows with distance", [] {
        return against_sundials(some(30), {.alpha1 = 1.0, .alpha2 = 0.01, .beta1 = -1.0, .beta2 = 2.0});
      });
      rows.must_be_solved("a thousand times as fast", [&] {
        kinematics::Particles all = some(60);
        all.velocity *= 1e3;
        return against_sundials(all, weak);
      });
      rows.must_be_refused("a cut-off", "to be split into close pairs",
                           [&] { return against_sundials(some(5), {.alpha1 = 0.1, .alpha2 = 0.04, .cutoff = 0.5}); });
      rows.must_be_refused("two in one place", "are 0 m apart", [&] {
        kinematics::Particles all = some(5);
        all.position.row(1) = all.position.row(0);
        return against_sundials(all, weak);
      });
    }};

}  // namespace verification::multirate
