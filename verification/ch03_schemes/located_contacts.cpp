// Impacts at the moment they happen, against closed forms and against CVODE with root finding.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <harness/bouncing.hpp>
#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <harness/three_body.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "bits.hpp"
#include "linear_problems.hpp"

namespace verification::located_contacts {

using namespace particulate;

// Bodies that attract and repel one another and collide: located contacts against CVODE with root finding.

constexpr laws::NearField field{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0};

using Colliding = scenes::Scene<kinematics::Space, laws::NearField, contact::LocatedContact<>>;
Colliding scene_of(const kinematics::Particles& bodies) {
  return {bodies, kinematics::Space{}, field, contact::LocatedContact<>{.restitution = {three_body_restitution}}};
}

// Ten bodies of different sizes on a jittered lattice 0.7 m wide, with gaps of some tenths, in random motion.
kinematics::Particles ten_bodies(std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_real_distribution<double> any(-1.0, 1.0);
  constexpr Eigen::Index N = 10;
  kinematics::Particles bodies{.position = kinematics::Vectors(N, 3),
                               .velocity = kinematics::Vectors(N, 3),
                               .mass = Eigen::VectorXd(N),
                               .radius = Eigen::VectorXd(N)};
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Vector3d corner(static_cast<double>(i % 3), static_cast<double>(i / 3 % 3),
                                 static_cast<double>(i / 9));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      bodies.position(i, axis) = corner[axis] + 0.1 * any(engine);
      bodies.velocity(i, axis) = 0.7 * any(engine);
    }
    bodies.mass[i] = 0.5 + 0.15 * any(engine);
    bodies.radius[i] = 0.3 + 0.06 * any(engine);
  }
  return bodies;
}

struct Motions {
  schemes::State state;
  schemes::Outcome outcome;
  std::vector<double> times;  // of the impacts
};

double difference(const Motions& one, const Motions& other) {
  return std::max((one.state.r - other.state.r).lpNorm<Eigen::Infinity>(),
                  (one.state.v - other.state.v).lpNorm<Eigen::Infinity>());
}

double worst_time(const Motions& one, const Motions& other) {
  if (one.times.size() != other.times.size()) return missing;
  double worst = 0.0;
  for (std::size_t k = 0; k < one.times.size(); ++k) keep_worst(worst, std::abs(one.times[k] - other.times[k]));
  return worst;
}

// Every pair's gap is an event; the impact map of section 2.2 acts at once.
Motions by_roots(const kinematics::Particles& bodies, double t_end, double tolerance) {
  Colliding scene = scene_of(bodies);
  std::vector<Pair> pairs;
  for (Eigen::Index i = 0; i < bodies.size(); ++i) {
    for (Eigen::Index j = i + 1; j < bodies.size(); ++j) pairs.push_back({i, j});
  }
  reference::Events events;
  for (const Pair& pair : pairs) {
    events.push_back({.function =
                          [&bodies, pair](const schemes::State& at) {
                            const auto& [i, j] = pair;
                            return (row_of(at.r, j) - row_of(at.r, i)).norm() - bodies.radius[i] - bodies.radius[j];
                          },
                      .direction = reference::Direction::falling});
  }
  Motions run{.state = scenes::start(scene), .outcome = {}, .times = {}};
  reference::Integrator integrator(scene, run.state,
                                   reference::Adams{.relative = tolerance, .absolute = 0.1 * tolerance}, events);
  const auto collide = [&](schemes::State& state, const std::vector<reference::Hit>& hits) {
    for (const reference::Hit& hit : hits) {
      const auto& [i, j] = pairs[hit.event];
      const contact::Rebound after =
          contact::impact({.velocity = row_of(state.v, i), .inverse_mass = 1.0 / bodies.mass[i]},
                          {.velocity = row_of(state.v, j), .inverse_mass = 1.0 / bodies.mass[j]},
                          (row_of(state.r, j) - row_of(state.r, i)).normalized(), three_body_restitution,
                          Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.0, contact::Frictionless{});
      set_row(state.v, i, after.velocity_i);
      set_row(state.v, j, after.velocity_j);
      run.times.push_back(state.t);
    }
  };
  run.outcome = advance_through_impacts(integrator, run.state, t_end, collide);
  require_reached(run.outcome);
  return run;
}

// A pair in touch at the end of a step is an impact there.
template <class C>
Motions by_location(const kinematics::Particles& bodies, double t_end, C control) {
  const Colliding scene = scene_of(bodies);
  Motions run{.state = scenes::start(scene), .outcome = {}, .times = {}};
  schemes::Collocation<schemes::Gauss<6>> scheme;
  const auto watch = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
    for (Eigen::Index i = 0; i < bodies.size(); ++i) {
      for (Eigen::Index j = i + 1; j < bodies.size(); ++j) {
        const double gap = (row_of(to.r, j) - row_of(to.r, i)).norm() - bodies.radius[i] - bodies.radius[j];
        if (std::abs(gap) <= 1e-12) run.times.push_back(to.t);
      }
    }
    return true;
  };
  run.outcome = schemes::integrate(scene, run.state, t_end, scheme, control, watch);
  require_reached(run.outcome);
  return run;
}

struct Bounds {
  double cvode;     // agreement of CVODE with itself
  double location;  // agreement with CVODE
};

void compare(Rows& rows, const std::string& which, const kinematics::Particles& bodies, double t_end,
             const Bounds& bounds) {
  const Motions exact = by_roots(bodies, t_end, 1e-13);
  const Motions fixed = by_location(bodies, t_end, schemes::FixedStep{.step = 0.025});
  const Motions adaptive =
      by_location(bodies, t_end, schemes::ErrorControl{.TOL = 1e-13, .sweep_TOL = 1e-14, .step = 0.01, .limit = 0.1});
  const std::string by_impacts =
      fmt::format("{} impacts, each of which magnifies what came before it", exact.times.size());
  rows.at_most("CVODE at relative tolerance 1e-11 against 1e-13 [m, m/s]" + which,
               {.limit = bounds.cvode,
                .computed = difference(by_roots(bodies, t_end, 1e-11), exact),
                .because = "a hundred times the looser tolerance; " + by_impacts});
  rows.at_least("impacts" + which,
                {.limit = 4.0, .computed = static_cast<double>(exact.times.size()), .because = "else little collides"});
  for (const auto& [run, how] : {std::pair(&fixed, ", fixed steps"), std::pair(&adaptive, ", adaptively")}) {
    rows.equal(
        "impacts" + which + how,
        {.expected = exact.outcome.impacts, .computed = run->outcome.impacts, .because = "no impact here is a graze"});
    rows.at_most("worst contact time against CVODE's [s]" + which + how,
                 {.limit = bounds.location,
                  .computed = worst_time(*run, exact),
                  .because = "CVODE's own error of 1e-11; " + by_impacts});
    rows.at_most("state at the end against CVODE's [m, m/s]" + which + how,
                 {.limit = bounds.location,
                  .computed = difference(*run, exact),
                  .because = "CVODE's own error of 1e-11; " + by_impacts});
    rows.at_most("deepest overlap [m]" + which + how,
                 {.limit = 1e-12, .computed = run->outcome.overlap, .because = "the rounding of a contact's place"});
  }
  rows.at_most("fixed against adaptive steps [m, m/s]" + which,
               {.limit = 0.1 * bounds.location,
                .computed = difference(fixed, adaptive),
                .because = "both are resolved to the last digits, which the impacts magnify"});
}

void prove_roots(Rows& rows) {
  compare(rows, ", three bodies", three_body_scene().particles(), 2.9, {.cvode = 1e-8, .location = 1e-9});
  for (std::uint64_t seed = 1; seed <= (rows.quick() ? 2U : 6U); ++seed) {
    compare(rows, fmt::format(", ten bodies, seed {}", seed), ten_bodies(seed), 1.5, {.cvode = 1e-8, .location = 1e-9});
  }
}

const Case roots{
    {.name = "located_contact_roots",
     .claim = "three and ten bodies that attract one another and collide meet as CVODE with root finding lets them",
     .equation = "R 2.2",
     .reference = Reference::sundials},
    prove_roots};

// Impacts at the moment they happen: walls, balls that bounce to rest, a pair that breathes, against closed forms.

constexpr double height = 0.4;

// The scene of chapter 2, with its contacts located; the ground may slope.
using Located = scenes::Scene<kinematics::Space, laws::Gravity, contact::LocatedContact<>>;
Located bouncing(double e, const Eigen::Vector3d& ground_normal, const Eigen::Vector3d& velocity) {
  kinematics::Particles ball{.position = ((ball_radius + height) * ground_normal).transpose(),
                             .velocity = velocity.transpose(),
                             .mass = Eigen::VectorXd::Constant(1, 2.0),
                             .radius = Eigen::VectorXd::Constant(1, ball_radius)};
  return {ball, kinematics::Space{{kinematics::Wall{.normal = ground_normal}}}, laws::Gravity{},
          contact::LocatedContact<>{.restitution = {e}}};
}

// What a run met.
struct Met {
  schemes::Outcome outcome;
  schemes::State state;
  int impacts = 0;
  double worst_time = 0.0, worst_speed = 0.0;
};

// Follows a ball, and compares every impact with the closed form.
Met follow(const Located& scene, const Eigen::Vector3d& normal, const Bouncing& exact, double t_end, double step) {
  Met met{.outcome = {}, .state = scenes::start(scene)};
  schemes::Collocation<schemes::Gauss<4>> scheme;
  schemes::FixedStep control{.step = step};
  const auto watch = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
    const double speed = to.v.dot(normal);
    if (!(std::abs(to.r.dot(normal) - ball_radius) <= 1e-12 && speed < 0.0)) return true;
    keep_worst(met.worst_time, std::abs(to.t - exact.impact_time(met.impacts)));
    keep_worst(met.worst_speed, std::abs(-speed - exact.impact_speed(met.impacts)));
    ++met.impacts;
    return true;
  };
  met.outcome = schemes::integrate(scene, met.state, t_end, scheme, control, watch);
  return met;
}

// Along the slope the ball is accelerated evenly; across it, it bounces under the part of the weight that presses.
const Case wall{
    {.name = "located_contact_wall",
     .claim = "a ball meets a sloping wall at the times, speeds and places of the closed form, however long the steps",
     .equation = "R 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Eigen::Vector3d normal(0.6, 0.0, 0.8), along(0.8, 0.0, -0.6);
      const Bouncing exact{.h = height, .e = 0.8, .g = 0.8 * 9.81};
      const Located scene = bouncing(exact.e, normal, 0.7 * along + 0.3 * Eigen::Vector3d::UnitY());
      constexpr double t_end = 2.0;
      int expected = 0;
      while (exact.impact_time(expected) < t_end) ++expected;
      for (const double step : {1.0, 0.1, 0.01}) {
        const Met met = follow(scene, normal, exact, t_end, step);
        const std::string which = fmt::format(", steps of {} s", step);
        rows.equal("impacts in 2 s" + which,
                   {.expected = expected, .computed = met.impacts, .because = "counted by the closed form"});
        const char* const because =
            "exact for constant forces but for rounding: of positions, over the speeds, and handed "
            "on by each impact";
        rows.at_most("worst time of an impact [s]" + which,
                     {.limit = 2e-14, .computed = met.worst_time, .because = because});
        rows.at_most("worst speed of an impact [m/s]" + which,
                     {.limit = 1e-13, .computed = met.worst_speed, .because = because});
        const Bouncing::Moment there = exact.at(t_end);
        const Eigen::Vector3d place = (ball_radius + there.z) * normal +
                                      (0.7 * t_end + 0.5 * 0.6 * 9.81 * t_end * t_end) * along +
                                      0.3 * t_end * Eigen::Vector3d::UnitY();
        rows.at_most("place after 2 s [m]" + which,
                     {.limit = 1e-13, .computed = (met.state.r - place).norm(), .because = because});
      }
    }};

struct Known {
  double e, total_time;
};

void to_rest(Rows& rows, const Known& known) {
  const Bouncing exact{.h = height, .e = known.e};
  const Located scene = bouncing(known.e, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero());
  for (const double step : {0.5, 0.05}) {
    const Met met = follow(scene, Eigen::Vector3d::UnitZ(), exact, 2.0 * known.total_time, step);
    const std::string which = fmt::format(", e = {}, steps of {} s", known.e, step);
    const std::string because = fmt::format(
        "down to hops of 5e-12 m, which the rounding of 0.05 m moves by 1e-6 of their time; {} impacts", met.impacts);
    rows.at_least("impacts before the ball counts as resting" + which,
                  {.limit = std::ceil(std::log(1e-5 / exact.impact_speed(0)) / std::log(known.e)),
                   .computed = static_cast<double>(met.impacts),
                   .because = "all that are faster than 1e-5 m/s, by logarithms"});
    rows.at_most("worst time of an impact [s]" + which,
                 {.limit = 1e-11, .computed = met.worst_time, .because = because});
    rows.at_most("worst speed of an impact [m/s]" + which,
                 {.limit = 1e-11, .computed = met.worst_speed, .because = because});
    rows.compare("time at which its impacts accumulate [s]" + which,
                 {.expected = known.total_time,
                  .computed = met.outcome.accumulation,
                  .tolerance = relative(1e-11),
                  .because = "the expected value is given to 12 digits"});
    rows.must_be_refused("a ball at rest under located contacts" + which, "come to rest each other stepped",
                         [&] { return ending_of(met.outcome); });
  }
}

const Case rest{
    {.name = "bouncing_to_rest_located",
     .claim = "located contacts meet every impact of a ball that bounces to rest, and tell when they are over",
     .equation = "R 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      to_rest(rows, {.e = 0.5, .total_time = 0.856705873756});
      to_rest(rows, {.e = 0.9, .total_time = 5.42580386712});
    }};

// Two unit masses, alpha1 = 1, alpha2 = 1/2, at rest 1 m apart: d = 2/3 (1 + cos(xi)/2), t = sqrt(4/27) (xi +
// sin(xi)/2). With radii of 1/4 m they meet where cos(xi) = -1/2, and without loss the motion runs backwards from
// there.
auto colliding_pair() {
  kinematics::Particles two = pair_at_rest(1.0, 1.0, 1.0);
  two.radius.setConstant(0.25);
  return scenes::Scene(two, kinematics::Space{},
                       laws::NearField{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
                       contact::LocatedContact{});
}

template <int S>
void pair_order(Rows& rows, const std::vector<long>& counts) {
  const double contact_time = std::sqrt(4.0 / 27.0) * (2.0 * std::numbers::pi / 3.0 + 0.25 * std::numbers::sqrt3);
  const auto scene = colliding_pair();
  const auto apart = [](const schemes::State& there) { return (position(there, 0) - position(there, 1)).norm(); };
  const kinematics::Breathing motion(kinematics::breathing_pair(1.0, 0.5, 1.0, 1.0), 1.0);
  std::vector<double> steps, times, places;
  bool one_each = true;
  for (const long n : counts) {
    const double step = contact_time / (static_cast<double>(n) + 0.5);
    schemes::State state = scenes::start(scene);
    schemes::Collocation<schemes::Gauss<S>> scheme;
    schemes::FixedStep control{.step = step};
    double met = missing;
    const auto watch = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
      if (std::abs(apart(to) - 0.5) <= 1e-13) met = to.t;
      return true;
    };
    const schemes::Outcome out = schemes::integrate(scene, state, 1.8 * contact_time, scheme, control, watch);
    one_each = one_each && out.impacts == 1;
    steps.push_back(step);
    times.push_back(std::abs(met - contact_time));
    places.push_back(std::abs(apart(state) - motion.at(0.2 * contact_time).r));
  }
  rows.equal(fmt::format("one impact in every run, {} stages", S),
             {.expected = true, .computed = one_each, .because = "they meet once"});
  const char* const because =
      "the contact lies in the middle of its step, which is solved anew to end there: the order of "
      "the scheme";
  rows.order(fmt::format("order of the contact time, {} stages", S),
             {.nominal = 2.0 * S, .steps = steps, .errors = times, .floor = 1e-15, .because = because});
  if (S > 2) return;  // the errors of the way there and back cancel, here more and there less
  rows.order(fmt::format("order of the distance at 1.8 contact times, {} stages", S),
             {.nominal = 2.0 * S, .steps = steps, .errors = places, .floor = 1e-15, .because = because});
}

const Case order{{.name = "located_contact_order",
                  .claim = "contact times and the motion after them have the order 2 s of the scheme",
                  .equation = "D 3.4",
                  .reference = Reference::convergence},
                 [](Rows& rows) {
                   // These make 0.8 (n + 1/2), the steps after the contact, a whole number.
                   pair_order<2>(rows, {137, 172, 217, 272, 342});
                   pair_order<3>(rows, {22, 28, 36, 46, 58});
                 }};

// To the contact, and from there on: with the scheme that came there, or with one that has made no step.
const Case forgets{
    {.name = "located_contact_forgets",
     .claim = "after an impact a scheme goes on, to the bit and at the same cost, as if it started there",
     .equation = "R 2.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto scene = colliding_pair();
      using Scheme = schemes::Collocation<schemes::Gauss<3>>;
      schemes::State state = scenes::start(scene);
      Scheme scheme;
      schemes::FixedStep control{.step = 0.055};
      double last = 0.0;
      const auto to_the_contact = [&](const schemes::State&, const schemes::State&, double dt, const Scheme&) {
        const bool whole = dt == control.step;
        last = dt;
        return whole;
      };
      const schemes::Outcome met = schemes::integrate(scene, state, 2.0, scheme, control, to_the_contact);
      rows.equal("impacts at the end of the first step that is cut short",
                 {.expected = 1, .computed = met.impacts, .because = "only a contact cuts a step before the end"});
      rows.at_least(
          "its share of the step [-]",
          {.limit = 0.5, .computed = last / control.step, .because = "a shorter one is forgotten for another reason"});
      schemes::State afresh = state;
      Scheme none;
      const schemes::Outcome one = schemes::integrate(scene, state, state.t + 0.3, scheme, control);
      const schemes::Outcome other = schemes::integrate(scene, afresh, afresh.t + 0.3, none, control);
      rows.none("numbers that differ 0.3 s later", differing(state, afresh), "nothing from before may be left");
      rows.equal("right-hand sides of these 0.3 s", {.expected = other.evaluations,
                                                     .computed = one.evaluations,
                                                     .because = "a guess that was not forgotten takes other sweeps"});
    }};

}  // namespace verification::located_contacts
