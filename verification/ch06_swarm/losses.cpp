// Losses: none is missed, and the lost do not act.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/legs.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/symplectic_euler.hpp>

#include "swarms.hpp"

namespace verification::losses {

using namespace particulate;

// Obstacles that hardly push: many members fly into them.
const swarm::Design careless = [] {
  swarm::Design design = passing;
  design.alpha_o = 0.05;
  return design;
}();

// Until all who are going to be lost are.
swarm::Course short_course(double v_max) {
  swarm::Course course = swarm::fence();
  course.v_max = v_max;
  course.duration = 5.0;
  return course;
}

std::vector<swarm::Loss> by_number(std::vector<swarm::Loss> lost) {
  std::sort(lost.begin(), lost.end(), [](const auto& a, const auto& b) { return a.member < b.member; });
  return lost;
}

std::vector<swarm::Loss> losses_at(const kinematics::Particles& start, swarm::Course course, double step) {
  course.step = step;
  return by_number(swarm::fly(careless, course, start).flight.lost);
}

// Who is lost where, in words.
std::string names_of(const std::vector<swarm::Loss>& lost) {
  std::string names;
  for (const swarm::Loss& one : lost) names += fmt::format("{} in {}, ", one.member, one.obstacle);
  return names;
}

// Those who still fly, by hand: their numbers in the start, and where they are.
struct Few {
  std::vector<Eigen::Index> number;
  schemes::State state;

  explicit Few(const kinematics::Particles& start)
      : number(static_cast<std::size_t>(start.size())),
        state{.t = 0.0, .r = start.position.reshaped(), .v = start.velocity.reshaped()} {
    std::iota(number.begin(), number.end(), 0);
  }
  swarm::Loss take_out(Eigen::Index k, std::size_t obstacle) {
    const swarm::Loss loss{.member = number[static_cast<std::size_t>(k)],
                           .obstacle = obstacle,
                           .t = state.t,
                           .place = schemes::position(state, k),
                           .velocity = schemes::velocity(state, k)};
    number.erase(number.begin() + k);
    for (Eigen::VectorXd* x : {&state.r, &state.v}) {
      std::vector<double> all(x->begin(), x->end());
      for (Eigen::Index axis = 2; axis >= 0; --axis) all.erase(all.begin() + axis * x->size() / 3 + k);
      *x = Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    }
    return loss;
  }
};

// How far a member is from the surface of the nearest obstacle, and which that is.
std::pair<double, std::size_t> surface_near(const swarm::Course& course, const Eigen::Vector3d& place) {
  std::pair<double, std::size_t> nearest{infinite, 0};
  for (std::size_t k = 0; k < course.radii.size(); ++k) {
    nearest = std::min(nearest, {(place - course.obstacles[k]).norm() - course.radii[k], k});
  }
  return nearest;
}

// What those who fly do to each other is counted by the mass of all who started.
template <class... Cap>
auto scene_of_few(const Few& few, const kinematics::Particles& start, const swarm::Course& course, const Cap&... cap) {
  return scenes::Scene(chosen(start, few.number), kinematics::Space{}, members_law(careless, start.mass.sum()),
                       obstacles_of(course, careless), target_of(course, careless),
                       swarm::LinearDrag{.c_d = course.c_d}, cap...);
}

// The same swarm by CVODE: a root is where a member comes to the surface of an obstacle. There it is taken out.
std::vector<swarm::Loss> losses_by_cvode(const kinematics::Particles& start, const swarm::Course& course) {
  std::vector<swarm::Loss> lost;
  Few few(start);
  while (few.state.t < course.duration) {
    const Gliding flight{scene_of_few(few, start, course), course.v_max};
    schemes::Events events;
    for (Eigen::Index i = 0; i < flight.scene.particles().size(); ++i) {
      events.push_back({.function = [&course, i](const schemes::State& at) {
        return surface_near(course, schemes::position(at, i)).first;
      }});
    }
    reference::Integrator integrator(flight, few.state, reference::Adams{.relative = 1e-12, .absolute = 1e-12}, events);
    if (integrator.advance(few.state, course.duration).status != schemes::Status::stopped) break;
    const auto hit = static_cast<Eigen::Index>(integrator.hits().front().event);
    lost.push_back(few.take_out(hit, surface_near(course, schemes::position(few.state, hit)).second));
  }
  return by_number(lost);
}

// Means over the losses of how late they are, and how far from where they should be.
struct Delay {
  double time, place;
};
Delay delay_of(const std::vector<swarm::Loss>& lost, const std::vector<swarm::Loss>& exact) {
  Delay mean{};
  if (names_of(lost) != names_of(exact)) return {missing, missing};
  for (std::size_t k = 0; k < lost.size(); ++k) {
    mean.time += std::abs(lost[k].t - exact[k].t) / static_cast<double>(lost.size());
    mean.place += (lost[k].place - exact[k].place).norm() / static_cast<double>(lost.size());
  }
  return mean;
}

void compare_losses(Rows& rows, const std::string& limit, const swarm::Course& course) {
  const kinematics::Particles start = swarm_at_rest(32, 1);
  const std::vector<swarm::Loss> exact = losses_by_cvode(start, course);
  rows.at_least(limit + ": lost by CVODE",
                {.limit = 10.0, .computed = static_cast<double>(exact.size()), .because = "fewer would say little"});
  std::vector<double> steps, times, places;
  for (double step = 0.02; steps.size() < 6; step *= 0.5) {
    const std::vector<swarm::Loss> lost = losses_at(start, course, step);
    if (step > 0.002) {
      rows.equal(fmt::format("{}, Dt = {}: who is lost, in which obstacle", limit, step),
                 {.expected = names_of(exact),
                  .computed = names_of(lost),
                  .because = "a step of a decimetre at most, in obstacles of half a metre"});
    }
    if (step > 0.005) continue;
    steps.push_back(step);
    times.push_back(delay_of(lost, exact).time);
    places.push_back(delay_of(lost, exact).place);
  }
  const char* because = "the path is of order 1, and the end of the step comes up to Dt late; mean of all losses";
  rows.order(limit + ": times [s]",
             {.nominal = 1.0, .steps = steps, .errors = times, .floor = 1e-8, .because = because});
  rows.order(limit + ": places [m]",
             {.nominal = 1.0, .steps = steps, .errors = places, .floor = 1e-8, .because = because});
}

const Case converge{
    {.name = "losses_converge",
     .claim = "no loss is missed: the same members are lost in the same obstacles as by CVODE, which stops at their "
              "surface, whatever the step, at times and places of order 1",
     .equation = "R 6.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      compare_losses(rows, "without limit", short_course(infinite));
      compare_losses(rows, "speed limit", short_course(3.0));
    }};

// Members a micrometre off the surface of every obstacle, at poles and elsewhere, that one step takes two micrometres
// inwards, or outwards.
long lost_at_surfaces(double speed) {
  swarm::Course course = swarm::fence();
  course.c_d = 0.0, course.duration = course.step;
  Uniform uniform(5);
  std::vector<kinematics::Particle> list;
  std::vector<std::size_t> obstacle;
  for (std::size_t k = 0; k < course.radii.size(); ++k) {
    for (int n = 0; n < 30; ++n) {
      Eigen::Vector3d normal = 2.0 * Eigen::Vector3d(uniform(), uniform(), uniform()).array() - 1.0;
      if (n < 6) normal = (n % 2 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(n / 2);
      normal.normalize();
      list.push_back({.position = course.obstacles[k] + (course.radii[k] + 1e-6) * normal,
                      .velocity = speed * normal,
                      .mass = 1.0,
                      .radius = 0.0});
      obstacle.push_back(k);
    }
  }
  long right = 0;
  for (const swarm::Loss& one : swarm::fly({}, course, kinematics::particles(list)).flight.lost) {
    right += one.obstacle == obstacle[static_cast<std::size_t>(one.member)];
  }
  return right;
}

const Case surfaces{
    {.name = "losses_at_every_surface",
     .claim = "a member that comes into an obstacle from any side is lost there, one that leaves is not",
     .equation = "R 6.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double speed = 2e-6 / swarm::Course{}.step;
      rows.equal("lost of 270 that come in, each in its own obstacle",
                 {.expected = 270, .computed = lost_at_surfaces(-speed), .because = "a step ends a micrometre inside"});
      rows.none("lost of 270 that leave", lost_at_surfaces(speed), "no step ends inside");
    }};

// A flight by hand: a run of those who still fly, that its observer ends where someone is inside an obstacle.
swarm::Flight flown_by_hand(const kinematics::Particles& start, const swarm::Course& course) {
  Few few(start);
  swarm::Flight flight;
  flight.state = few.state;
  while (few.state.t < course.duration && !few.number.empty()) {
    const auto scene = scene_of_few(few, start, course, swarm::SpeedLimit{.v_max = course.v_max});
    const auto inside = [&](const schemes::State& at, Eigen::Index i) {
      return surface_near(course, schemes::position(at, i)).first < 0.0;
    };
    const auto nobody_is_lost = [&](const schemes::State&, const schemes::State& to, double, const auto&) {
      for (Eigen::Index i = 0; i < scene.particles().size(); ++i) {
        if (inside(to, i)) return false;
      }
      return true;
    };
    (void)schemes::integrate(scene, few.state, course.duration, schemes::SymplecticEuler{},
                             schemes::FixedStep{.step = course.step}, nobody_is_lost);
    for (Eigen::Index i = scene.particles().size() - 1; i >= 0; --i) {
      const Eigen::Index member = few.number[static_cast<std::size_t>(i)];
      const bool lost = inside(few.state, i);
      schemes::set_position(flight.state, member, schemes::position(few.state, i));
      schemes::set_velocity(flight.state, member, lost ? Eigen::Vector3d::Zero() : schemes::velocity(few.state, i));
      if (lost) flight.lost.push_back(few.take_out(i, 0));
    }
  }
  flight.lost = by_number(flight.lost);
  return flight;
}

const Case inactive{
    {.name = "the_lost_do_not_act",
     .claim =
         "from a loss on the others fly as if the lost had never been, to the last bit, and keep their numbers; the "
         "lost stay where they are",
     .equation = "R 6.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const kinematics::Particles start = swarm_at_rest(32, 1);
      const swarm::Course course = short_course(3.0);
      const swarm::Trial trial = swarm::fly(careless, course, start);
      const swarm::Flight by_hand = flown_by_hand(start, course);
      const schemes::State& state = trial.flight.state;
      const std::vector<swarm::Loss> lost = by_number(trial.flight.lost);
      long other_members = 0, other_times = 0, moved = 0;
      for (std::size_t k = 0; k < std::min(lost.size(), by_hand.lost.size()); ++k) {
        other_members += lost[k].member != by_hand.lost[k].member;
        other_times += lost[k].t != by_hand.lost[k].t;
        moved += schemes::position(state, lost[k].member) != lost[k].place;
      }
      const char* same = "the same runs of the same scenes";
      rows.equal("lost", {.expected = by_hand.lost.size(), .computed = lost.size(), .because = same});
      rows.at_least("lost",
                    {.limit = 10.0, .computed = static_cast<double>(lost.size()), .because = "fewer would say little"});
      rows.none("losses of another member", other_members, same);
      rows.none("losses at another time", other_times, same);
      rows.none(
          "places and velocities at the end that differ in a bit",
          (state.r.array() != by_hand.state.r.array()).count() + (state.v.array() != by_hand.state.v.array()).count(),
          same);
      rows.none("lost members that have moved", moved, "they stay where they were lost");
    }};

// Under the pull 4 a member at rest at x_0 is after n steps at x_0 + 2 Dt^2 n (n + 1), and lost beyond 4.5.
const Case all_lost{
    {.name = "all_are_lost",
     .claim = "if all are lost the objective is the mean distance of where they stay, and the whole penalty",
     .equation = "R 6.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      swarm::Course course = swarm::fence();
      course.c_d = 0.0, course.v_max = infinite;
      course.duration = 4.0, course.step = 0x1p-5, course.loss_penalty = 0.75;
      kinematics::Particles start = kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                                           {.position = {3.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}});
      const swarm::Trial trial = swarm::fly({.alpha_t = 4.0, .beta_t = 0.0}, course, start);
      double sum = 0.0;
      const double n_end = course.duration / course.step;
      for (const double x_0 : {0.0, 3.0}) {
        double x = x_0;
        for (double n = 0.0; n < n_end; ++n) {
          const double before = 10.0 - x;
          if (x <= 4.5) x = x_0 + 2.0 * course.step * course.step * (n + 1.0) * (n + 2.0);
          sum += 0.5 * course.step * (before + 10.0 - x);
        }
      }
      rows.equal("lost", {.expected = 2, .computed = trial.flight.lost.size(), .because = "both fly at obstacle 4"});
      rows.compare("objective", {.expected = sum / course.duration / 17.0 + 0.75,
                                 .computed = trial.objective,
                                 .tolerance = relative(1e-14),
                                 .because = "rounding of 128 steps"});
      rows.compare("end of the flight [s]", {.expected = 4.0,
                                             .computed = trial.flight.state.t,
                                             .tolerance = absolute(0.0),
                                             .because = "the time goes on when nobody flies"});
    }};

const Case observers{
    {.name = "observers_of_losses",
     .claim = "samples and histories of a flight see the whole swarm, the lost at rest at their places",
     .equation = "R 6.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const kinematics::Particles start = swarm_at_rest(32, 1);
      const swarm::Course course = short_course(3.0);
      const auto scene = scene_of(start, careless, course, swarm::SpeedLimit{.v_max = course.v_max});
      const std::vector<double> times = schemes::multiples(0.0625, 0.0, course.duration);
      std::vector<schemes::State> seen;
      scenes::History history(scene, times);
      schemes::Sampling samples(
          times, [&](const schemes::State& at) { seen.push_back(at); }, std::ref(history));
      const swarm::Flight flight = swarm::fly(start, kinematics::Space{}, course.duration, schemes::SymplecticEuler{},
                                              schemes::FixedStep{.step = course.step}, samples,
                                              members_law(careless, start.mass.sum()), obstacles_of(course, careless),
                                              target_of(course, careless), swarm::SpeedLimit{.v_max = course.v_max});
      long elsewhere = 0, moving = 0;
      for (const schemes::State& at : seen) {
        for (const swarm::Loss& one : flight.lost) {
          if (at.t <= one.t) continue;
          elsewhere += schemes::position(at, one.member) != one.place;
          moving += !schemes::velocity(at, one.member).isZero(0.0);
        }
      }
      const char* because = "they stay where they were lost";
      rows.equal("samples", {.expected = times.size(), .computed = seen.size(), .because = "one a time"});
      rows.none("lost members that are elsewhere", elsewhere, because);
      rows.none("lost members that move", moving, because);
      const Eigen::RowVectorXd last =
          history.rows().bottomRows<1>();  // time, bulk, relative, potential, lost, momentum
      const double mass = start.mass.sum();
      rows.compare("history: what the speed limit took [J/kg]", {.expected = -flight.outcome.energy_change / mass,
                                                                 .computed = last[4],
                                                                 .tolerance = relative(1e-13),
                                                                 .because = "the same jumps, added in another order"});
      rows.compare("history: momentum of the whole swarm [kg m/s]",
                   {.expected = kinematics::linear_momentum(start.mass, rows_of(flight.state.v)).x(),
                    .computed = last[5],
                    .tolerance = relative(1e-13),
                    .because = "the lost count, and have none"});
    }};

}  // namespace verification::losses
