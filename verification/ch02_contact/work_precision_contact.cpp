// Error against run time where bodies collide: stepped contact by two schemes, and CVODE with root finding.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harness/bouncing.hpp>
#include <harness/case.hpp>
#include <harness/impacts_by_events.hpp>
#include <harness/motions.hpp>
#include <harness/races.hpp>
#include <harness/three_body.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::work_precision_contact {

using namespace particulate;

// From the largest on, each half the one before.
std::vector<double> halved(double largest, int count) {
  std::vector<double> sizes;
  for (int k = 0; k < count; ++k) sizes.push_back(std::ldexp(largest, -k));
  return sizes;
}

// CVODE with the absolute tolerance a tenth of the relative one.
template <class Change>
Begin by_roots(const reference::Events& events, const Change& change) {
  return [=](const schemes::Problem& problem, const schemes::State& start, double tolerance) -> Advance {
    const reference::Adams settings{.relative = tolerance, .absolute = 0.1 * tolerance};
    return
        [integrator = std::make_shared<reference::Integrator>(problem, start, settings, events), change](
            schemes::State& state, double t_end) { return advance_through_impacts(*integrator, state, t_end, change); };
  };
}

const Case bouncing{
    {.name = "work_precision_bouncing",
     .claim = "error against run time of sixteen balls that bounce: stepped contact has order 1, what finds the "
              "impacts is not held to it",
     .equation = "R 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double e = 0.5;
      std::vector<double> heights;
      for (int k = 0; k < 16; ++k) heights.push_back(0.4 * (0.98 + 0.04 * (k + 0.5) / 16.0));
      const BouncingScene scene = bouncing_scene(heights, e);
      Race race{.problem = scene, .start = scenes::start(scene), .outputs = {0.15, 0.4, 0.65}, .truth = {}};
      race.truth = [=](double t) { return bouncing_truth(scene, heights, e, t); };
      race.length = 0.4;
      race.speed = Bouncing{.h = 0.4, .e = e}.impact_speed(0);
      const std::vector<double> steps = halved(1e-3, rows.quick() ? 6 : 10);
      // The worst of sixteen impacts is late by nearly a whole step, so that the slope shows without scatter.
      rows.work_precision({.problem = "bouncing",
                           .reference = "closed form, rounded",
                           .floor = 1e-15,
                           .competitors = {with_slope(1.0, competitor("RK4, stepped contact", race, steps,
                                                                      at_fixed_step<schemes::RungeKutta4>())),
                                           with_slope(1.0, competitor("velocity Verlet, stepped contact", race, steps,
                                                                      at_fixed_step<schemes::VelocityVerlet>())),
                                           competitor("CVODE Adams with roots", race, tolerances(1e-13),
                                                      by_roots(ground_events(16), rebound(e)))}});
    }};

// The earliest of the three pairs to touch, and its gap.
struct Gap {
  std::size_t pair;
  double width;
};
Gap smallest_gap(const ThreeBodyScene& scene, const schemes::State& at) {
  const Eigen::VectorXd& radius = scene.particles().radius;
  Gap smallest{.pair = 0, .width = 1e300};
  for (std::size_t k = 0; k < three_pairs.size(); ++k) {
    const auto& [i, j] = three_pairs[k];
    const double width = (row_of(at.r, j) - row_of(at.r, i)).norm() - radius[i] - radius[j];
    if (width < smallest.width) smallest = {.pair = k, .width = width};
  }
  return smallest;
}

schemes::State flown(ThreeBodyScene& scene, schemes::State state, double t_end) {
  const reference::ExplicitRungeKutta fehlberg{
      .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-15};
  const schemes::Outcome out = reference::integrate(scene, state, t_end, fehlberg);
  require_reached(out);
  return state;
}

// Another family, without root finding: ARKODE, an impact's time bisected to rounding from flights of their own.
schemes::State by_bisection(ThreeBodyScene& scene, schemes::State state, double t_end) {
  constexpr double piece = 1.0 / 64.0;
  while (state.t < t_end) {
    const double to = std::min(state.t + piece, t_end);
    schemes::State there = flown(scene, state, to);
    if (smallest_gap(scene, there).width < 0.0) {
      double before = state.t, after = to;
      while (after - before > 1e-14) {
        const double middle = 0.5 * (before + after);
        schemes::State halfway = flown(scene, state, middle);
        const bool touches = smallest_gap(scene, halfway).width < 0.0;
        (touches ? after : before) = middle;
        if (touches) there = halfway;
      }
      impact_of_pair(scene.particles().mass)(there, {{.event = smallest_gap(scene, there).pair}});
    }
    state = there;
  }
  return state;
}

const Case three_bodies{
    {.name = "work_precision_three_bodies",
     .claim = "error against run time of three bodies that collide: stepped contact has order 1, what finds the "
              "impacts is not held to it",
     .equation = "R 2.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      ThreeBodyScene scene = three_body_scene();
      Race race{.problem = scene, .start = scenes::start(scene), .outputs = {0.6, 1.2, 2.0, 2.9}, .truth = {}};
      std::vector<schemes::State> exact;
      double disagreement = 0.0;
      for (const double t : race.outputs) {
        schemes::State by_cvode = scenes::start(scene);
        const schemes::Outcome out = three_bodies_by_roots(scene, by_cvode, t, 1e-14);
        require_reached(out);
        exact.push_back(by_bisection(scene, scenes::start(scene), t));
        disagreement = std::max({disagreement, (exact.back().r - by_cvode.r).lpNorm<Eigen::Infinity>(),
                                 (exact.back().v - by_cvode.v).lpNorm<Eigen::Infinity>()});
      }
      rows.at_most("CVODE with roots against ARKODE with bisected impacts [m, m/s]",
                   {.limit = 1e-10,
                    .computed = disagreement,
                    .because = "tolerances of 1e-14 with global errors some thousand times larger"});
      race.truth = [exact](double t) {
        return *std::find_if(exact.begin(), exact.end(), [t](const schemes::State& at) { return at.t == t; });
      };
      const std::vector<double> steps = halved(1e-3, rows.quick() ? 7 : 11);
      const char* const scatter =
          "four impacts each fall anywhere within a step, so that single errors scatter about the first order, which "
          "three_body_near_field claims two-sided of their means";
      rows.work_precision(
          {.problem = "three_bodies",
           .reference = "ARKODE Fehlberg 8(7) with bisected impacts, checked by CVODE with root finding",
           .floor = std::max(disagreement, 1e-14),
           .competitors = {
               with_slope(1.0, competitor("RK4, stepped contact", race, steps, at_fixed_step<schemes::RungeKutta4>()),
                          scatter),
               with_slope(1.0,
                          competitor("velocity Verlet, stepped contact", race, steps,
                                     at_fixed_step<schemes::VelocityVerlet>()),
                          scatter),
               competitor("CVODE Adams with roots", race, tolerances(1e-13),
                          by_roots(gap_events(scene.particles().radius), impact_of_pair(scene.particles().mass)))}});
    }};

}  // namespace verification::work_precision_contact
