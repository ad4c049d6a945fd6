// Bodies that attract and repel one another and collide: located contacts against CVODE with root finding.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/three_body.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "linear_problems.hpp"

namespace verification::located_contact_roots {

using namespace particulate;

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
  const reference::Events events{.functions =
                                     [&](const schemes::State& at, schemes::Out g) {
                                       for (std::size_t k = 0; k < pairs.size(); ++k) {
                                         const auto& [i, j] = pairs[k];
                                         g[static_cast<Eigen::Index>(k)] = (row_of(at.r, j) - row_of(at.r, i)).norm() -
                                                                           bodies.radius[i] - bodies.radius[j];
                                       }
                                     },
                                 .directions = std::vector(pairs.size(), reference::Direction::falling)};
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
  if (run.outcome.status != schemes::Status::reached) throw std::runtime_error(run.outcome.reason);
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
  if (run.outcome.status != schemes::Status::reached) throw std::runtime_error(run.outcome.reason);
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
                  .because = "CVODE's own floor of 1e-11; " + by_impacts});
    rows.at_most("state at the end against CVODE's [m, m/s]" + which + how,
                 {.limit = bounds.location,
                  .computed = difference(*run, exact),
                  .because = "CVODE's own floor of 1e-11; " + by_impacts});
    rows.at_most("deepest overlap [m]" + which + how,
                 {.limit = 1e-12, .computed = run->outcome.overlap, .because = "the rounding of a contact's place"});
  }
  rows.at_most("fixed against adaptive steps [m, m/s]" + which,
               {.limit = 0.1 * bounds.location,
                .computed = difference(fixed, adaptive),
                .because = "both are resolved to the last digits, which the impacts magnify"});
}

const Case roots{
    {.name = "located_contact_roots",
     .claim = "three and ten bodies that attract one another and collide meet as CVODE with root finding lets them",
     .equation = "R 2.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      compare(rows, ", three bodies", three_body_scene().particles(), 2.9, {.cvode = 1e-8, .location = 1e-9});
      for (std::uint64_t seed = 1; seed <= (rows.quick() ? 2U : 6U); ++seed) {
        compare(rows, fmt::format(", ten bodies, seed {}", seed), ten_bodies(seed), 1.5,
                {.cvode = 1e-8, .location = 1e-9});
      }
    }};

}  // namespace verification::located_contact_roots
