// Three bodies that attract and repel one another and collide: stepped contact against CVODE with root finding.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/three_body.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::three_body_near_field {

using namespace particulate;

// Amid flights for every start below.
constexpr double t_end = 2.9;

double difference(const schemes::State& one, const schemes::State& other) {
  return std::max((one.r - other.r).lpNorm<Eigen::Infinity>(), (one.v - other.v).lpNorm<Eigen::Infinity>());
}

struct ByRoots {
  schemes::State state;
  schemes::Outcome outcome;
};

ByRoots by_roots(double closer, double relative) {
  ThreeBodyScene scene = three_body_scene(closer);
  ByRoots run{.state = scenes::start(scene), .outcome = {}};
  run.outcome = three_bodies_by_roots(scene, run.state, t_end, relative);
  if (run.outcome.status != schemes::Status::reached) throw std::runtime_error(run.outcome.reason);
  return run;
}

template <class S>
ByRoots by_steps(double closer, long steps) {
  ThreeBodyScene scene = three_body_scene(closer);
  ByRoots run{.state = scenes::start(scene), .outcome = {}};
  S scheme;
  schemes::FixedStep control{.step = t_end / static_cast<double>(steps)};
  run.outcome = schemes::integrate(scene, run.state, t_end, scheme, control);
  if (run.outcome.status != schemes::Status::reached) throw std::runtime_error(run.outcome.reason);
  return run;
}

// Starts a little apart, so that where within a step each impact falls is as good as random from one to the next.
std::vector<double> starts(int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(0.01 * (k + 0.5) / count);
  return all;
}

template <class S>
void compare_order(Rows& rows, const std::string& name, const std::vector<double>& all,
                   const std::vector<ByRoots>& exact) {
  std::vector<double> steps, errors;
  bool same_impacts = true;
  for (long n = 2000; steps.size() < (rows.quick() ? 5U : 7U); n *= 2) {
    double mean = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const ByRoots run = by_steps<S>(all[k], n);
      mean += difference(run.state, exact[k].state) / static_cast<double>(all.size());
      same_impacts = same_impacts && run.outcome.impacts == exact[k].outcome.impacts;
    }
    steps.push_back(t_end / static_cast<double>(n));
    errors.push_back(mean);
  }
  rows.order(
      name + ": order of the mean error over the starts",
      {.nominal = 1.0,
       .steps = steps,
       .errors = errors,
       .floor = 1e-9,
       .because = fmt::format("an impact is seen up to a step late, as good as at random: the mean over {} starts "
                              "is of first order, whatever the scheme",
                              all.size())});
  rows.equal(name + ": every run has the impacts that CVODE finds",
             {.expected = true, .computed = same_impacts, .because = "no impact here is a graze"});
}

const Case three_body_near_field{
    {.name = "three_body_near_field",
     .claim = "stepped contact converges at first order to three bodies that attract one another and collide",
     .equation = "R 2.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const std::vector<double> all = starts(rows.quick() ? 24 : 96);
      std::vector<ByRoots> exact;
      double agreement = 0.0;
      long fewest = 1000;
      for (const double closer : all) {
        exact.push_back(by_roots(closer, 1e-13));
        agreement = std::max(agreement, difference(exact.back().state, by_roots(closer, 1e-11).state));
        fewest = std::min(fewest, exact.back().outcome.impacts);
      }
      rows.at_most("CVODE at relative tolerance 1e-11 against 1e-13 [m, m/s]",
                   {.limit = 1e-8,
                    .computed = agreement,
                    .because = "a thousand times the looser tolerance, through several impacts; far below what stepped "
                               "contact reaches"});
      rows.at_least("impacts in each motion",
                    {.limit = 3.0, .computed = static_cast<double>(fewest), .because = "else nothing collides"});
      compare_order<schemes::VelocityVerlet>(rows, "velocity Verlet", all, exact);
      compare_order<schemes::RungeKutta4>(rows, "RK4", all, exact);
    }};

}  // namespace verification::three_body_near_field
