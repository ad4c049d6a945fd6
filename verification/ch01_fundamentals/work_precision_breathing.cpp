// Error against run time for bodies that breathe, pairs of growing stiffness and the pentagon, against the closed form.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/competitors.hpp>
#include <particulate/contact/near_field.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace {

using namespace particulate;
using namespace verification;
using contact::NearField;
using BreathingScene = scenes::Scene<kinematics::Open, NearField>;

constexpr double attraction = 1.0;

// Unit masses at `corners`, at rest, breathing with radius R(t): places and velocities are R and R' times the corners.
Race<BreathingScene> breathing_race(const kinematics::Vectors& corners, const kinematics::RadialForce& radial,
                                    double alpha2, double r_0) {
  const Eigen::Index N = corners.rows();
  const kinematics::Breathing exact(radial, r_0);
  const kinematics::Particles start{.position = r_0 * corners,
                                    .velocity = kinematics::Vectors::Zero(N, 3),
                                    .mass = Eigen::VectorXd::Ones(N),
                                    .radius = Eigen::VectorXd::Zero(N)};
  const BreathingScene scene{start, kinematics::Open{},
                             NearField{.alpha1 = attraction, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
  Race<BreathingScene> race{.problem = scene, .start = scenes::start(scene), .outputs = {}, .truth = {}};
  for (int tenth = 1; tenth <= 9; ++tenth) race.outputs.push_back(tenth * exact.period() / 10.0);
  race.truth = [corners, exact](double t) {
    const kinematics::Radial now = exact.at(t);
    return schemes::Motion{.t = t, .r = (now.r * corners).reshaped(), .v = (now.v * corners).reshaped()};
  };
  // |dr/dt| is largest where A/r^2 = B/r^3: v^2 = A^2/B - 2 A/r_0 + B/r_0^2.
  const double fastest = std::sqrt(radial.A * radial.A / radial.B - 2.0 * radial.A / r_0 + radial.B / (r_0 * r_0));
  race.length = r_0 * corners.rowwise().norm().maxCoeff();
  race.speed = fastest * corners.rowwise().norm().maxCoeff();
  return race;
}

// Steps in a tenth of a period: the first, and by what factor they grow how often.
struct Steps {
  int first;
  double factor;
  int times;
};

std::vector<double> step_sizes(double tenth, const Steps& steps, int multiple) {
  std::vector<double> sizes;
  for (int k = 0; k <= steps.times; ++k) {
    sizes.push_back(tenth / std::round(multiple * steps.first * std::pow(steps.factor, k)));
  }
  return sizes;
}

// Two tolerances a decade, from 1e-4 on.
std::vector<double> tolerances(double tightest) {
  std::vector<double> all;
  for (double exponent = -4.0; exponent >= std::log10(tightest) - 1e-9; exponent -= 0.5) {
    all.push_back(std::pow(10.0, exponent));
  }
  return all;
}

// A reference method whose absolute tolerance is a multiple of its relative one.
template <class Settings>
auto by(Settings settings, double absolute_share = 1.0) {
  return [=](auto& problem, const schemes::Motion& start, double tolerance) {
    Settings now = settings;
    now.relative = tolerance;
    now.absolute = absolute_share * tolerance;
    return [integrator = reference::Integrator(problem, start, now)](schemes::Motion& state, double t_end) mutable {
      return integrator.advance(state, t_end);
    };
  };
}

Competitor with_slope(double slope, Competitor who, std::string steeper = {}) {
  who.slope = slope;
  who.steeper = std::move(steeper);
  return who;
}

// Two-sided orders are claimed by order_rk4 and order_verlet, before the bodies turn.
const char* const symmetric_turn = "the motion is symmetric in time about its turn, which cancels RK4's leading error";

Competitor tuned(Competitor who) {
  who.tuned = true;
  return who;
}

// Tuned on the softest pair and reported on all: orders above 8 cost CVODE more than they gain, and ARKODE gains from
// an absolute tolerance above the relative one.
std::vector<Competitor> everybody(const Race<BreathingScene>& race, const Steps& steps, double tightest) {
  using reference::ExplicitRungeKutta, reference::Table;
  const double tenth = race.outputs.front();
  const std::vector<double> tight = tolerances(tightest);
  const ExplicitRungeKutta dormand_prince{.table = Table::dormand_prince_7_4_5};
  const ExplicitRungeKutta fehlberg{.table = Table::fehlberg_13_7_8};
  return {with_slope(4.0, competitor("RK4", race, step_sizes(tenth, steps, 1), at_fixed_step<schemes::RungeKutta4>()),
                     symmetric_turn),
          with_slope(2.0, competitor("velocity Verlet", race, step_sizes(tenth, steps, 4),
                                     at_fixed_step<schemes::VelocityVerlet>())),
          competitor("CVODE Adams", race, tight, by(reference::Adams{})),
          tuned(competitor("CVODE Adams, orders to 8", race, tight, by(reference::Adams{.max_order = 8}))),
          competitor("ARKODE Dormand-Prince 5(4)", race, tight, by(dormand_prince)),
          competitor("ARKODE Fehlberg 8(7)", race, tight, by(fehlberg)),
          tuned(competitor("ARKODE Fehlberg 8(7), absolute 1000 relative", race, tight, by(fehlberg, 1e3)))};
}

void measure(Rows& rows, const std::string& problem, const Race<BreathingScene>& race, Steps steps) {
  if (rows.full()) steps.times += 1;
  // The closed form is rounded to doubles; its own error, in extended precision, lies below.
  rows.work_precision({.problem = problem,
                       .reference = "closed form in extended precision, rounded",
                       .floor = 2e-16,
                       .competitors = everybody(race, steps, rows.quick() ? 1e-13 : 1e-15)});
}

void measure_pair(Rows& rows, const std::string& problem, double alpha2, const Steps& steps) {
  const kinematics::Vectors halves{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}};
  measure(rows, problem, breathing_race(halves, kinematics::breathing_pair(attraction, alpha2, 1.0, 1.0), alpha2, 1.0),
          steps);
}

Claim claim_of(const std::string& problem, const std::string& bodies) {
  return {.name = "work_precision_" + problem,
          .claim = "error against run time of " + bodies + ", to 0.9 of a period",
          .equation = "D 1.4.1",
          .reference = Reference::closed_form};
}

const Case soft{claim_of("breathing_pair_soft", "a breathing pair, alpha2 = 0.5"), [](Rows& rows) {
                  measure_pair(rows, "breathing_pair_soft", 0.5, {2, 2.0, 7});
                }};
const Case stiff{claim_of("breathing_pair_stiff", "a breathing pair, alpha2 = 0.1"), [](Rows& rows) {
                   measure_pair(rows, "breathing_pair_stiff", 0.1, {64, 2.0, 5});
                 }};
const Case stiffest{claim_of("breathing_pair_stiffest", "a breathing pair, alpha2 = 0.01"), [](Rows& rows) {
                      measure_pair(rows, "breathing_pair_stiffest", 0.01, {4096, std::numbers::sqrt2, 4});
                    }};
const Case pentagon{claim_of("pentagon", "five bodies that breathe, alpha2 = 0.5"), [](Rows& rows) {
                      const kinematics::Vectors corners = kinematics::regular_polygon(5);
                      const kinematics::RadialForce radial = kinematics::breathing_body(attraction, 0.5, 1.0, corners);
                      measure(rows, "pentagon", breathing_race(corners, radial, 0.5, 1.0), {2, 2.0, 7});
                    }};

// RK4 that moves by 1.001 steps and calls it one: the smallest kind of defect that a diagram must show.
struct TooLongSteps : schemes::RungeKutta4 {
  template <class P>
  bool predict(P& problem, const schemes::Motion& from, double dt, schemes::Motion& to) {
    const bool value = schemes::RungeKutta4::predict(problem, from, 1.001 * dt, to);
    to.t = from.t + dt;
    return value;
  }
};

const Case defect{
    {.name = "work_precision_shows_a_defect",
     .claim = "a step that is 0.1 % too long moves the curve of RK4 by orders of magnitude",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Vectors halves{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}};
      const Race<BreathingScene> race =
          breathing_race(halves, kinematics::breathing_pair(attraction, 0.5, 1.0, 1.0), 0.5, 1.0);
      const std::vector<double> sizes = step_sizes(race.outputs.front(), {2, 2.0, 6}, 1);
      rows.work_precision(
          {.problem = "planted_defect",
           .reference = "closed form in extended precision, rounded",
           .floor = 2e-16,
           .competitors = {
               with_slope(4.0, competitor("RK4", race, sizes, at_fixed_step<schemes::RungeKutta4>()), symmetric_turn),
               competitor("RK4, steps 0.1 % too long", race, sizes, at_fixed_step<TooLongSteps>())}});
      const double right = rows.points()[sizes.size() - 1].errors->end;
      const double wrong = rows.points()[2 * sizes.size() - 1].errors->end;
      rows.at_least("error with the defect over the error without, smallest step",
                    {.limit = 1e4,
                     .computed = wrong / right,
                     .because = "0.1 % of a period against an error of 1e-9: five decades and more"});
    }};

}  // namespace
