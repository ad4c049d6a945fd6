// Swarms of 64 members, for the table of what a feature costs: swarm_cost <steps>... runs all of them.

#include <array>
#include <cmath>
#include <stdexcept>

#include <harness/counted_program.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/symplectic_euler.hpp>
#include <particulate/swarm/flight.hpp>
#include <particulate/swarm/linear_drag.hpp>
#include <particulate/swarm/speed_limit.hpp>
#include <particulate/swarm/target.hpp>

namespace {

using namespace particulate;
using kinematics::Space;
using swarm::LinearDrag;
using swarm::Obstacles;
using swarm::SpeedLimit;
using swarm::Target;
using verification::CountedRun;
using verification::CountedScene;

constexpr Eigen::Index N = 64;
constexpr double dt = 1e-3;

// Places that fill a cube evenly, and one member more, a step away from an obstacle that the others do not meet.
kinematics::Particles members(bool one_is_lost) {
  const Eigen::Index count = one_is_lost ? N + 1 : N;
  kinematics::Particles all{.position = kinematics::Vectors(count, 3),
                            .velocity = kinematics::Vectors::Constant(count, 3, 0.1),
                            .mass = Eigen::VectorXd::Ones(count),
                            .radius = Eigen::VectorXd::Zero(count)};
  const Eigen::RowVector3d irrational{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k)
      all.position(i, k) = std::fmod(static_cast<double>(i + 1) * irrational[k], 1.0);
  }
  if (one_is_lost) {
    all.position.row(N) << 8.999, 0.0, 0.0;
    all.velocity.row(N) << 100.0, 0.0, 0.0;
  }
  return all;
}
const kinematics::Particles swarm_of_all = members(false), one_more = members(true);

const laws::NearField together{.alpha1 = 0.01, .alpha2 = 0.001, .beta1 = -0.6, .beta2 = 1.3};
const Obstacles none{};
const Obstacles far{.centre = {{10.0, 0.0, 0.0}}, .radius = {1.0}, .alpha = 0.1, .beta = 3.4};
const Obstacles nine = [] {
  Obstacles all{.alpha = 0.1, .beta = 3.4};
  for (int k = 0; k < 9; ++k) all.centre.emplace_back(10.0, k / 3, k % 3), all.radius.push_back(0.4);
  return all;
}();
const Target away{.place = {20.0, 0.0, 0.0}, .alpha = 0.1, .beta = 0.6}, no_pull{.alpha = 0.0};

schemes::FixedStep control() { return {.step = dt}; }

CountedRun counted(const kinematics::Particles& start, const schemes::Outcome& out, long steps, double sum) {
  if (out.status != schemes::Status::reached || out.steps != steps) throw std::runtime_error(out.reason);
  return {.particles = start.size(), .impacts = out.impacts, .sum = sum};
}

template <class... Laws>
CountedRun scene(long steps, const Laws&... laws) {
  const scenes::Scene<Space, Laws...> swarm(swarm_of_all, Space{}, laws...);
  schemes::State state = scenes::start(swarm);
  const schemes::Outcome out =
      schemes::integrate(swarm, state, dt * static_cast<double>(steps), schemes::SymplecticEuler{}, control());
  return counted(swarm_of_all, out, steps, state.r.sum());
}

// The same as a flight, in which somebody may be lost.
CountedRun flight(const kinematics::Particles& start, long steps) {
  const swarm::Flight flown = swarm::fly(start, Space{}, dt * static_cast<double>(steps), schemes::SymplecticEuler{},
                                         control(), schemes::Unobserved{}, together, far);
  if (flown.lost.size() != static_cast<std::size_t>(start.size() - N)) throw std::runtime_error("lost others");
  return counted(start, flown.outcome, steps, flown.state.r.sum());
}

const std::array all{CountedScene{"members_alone", [](long n) { return scene(n, together); }},
                     CountedScene{"obstacles_idle", [](long n) { return scene(n, together, none); }},
                     CountedScene{"obstacles_used", [](long n) { return scene(n, together, nine); }},
                     CountedScene{"target_idle", [](long n) { return scene(n, together, no_pull); }},
                     CountedScene{"target_used", [](long n) { return scene(n, together, away); }},
                     CountedScene{"drag_idle", [](long n) { return scene(n, together, LinearDrag{.c_d = 0.0}); }},
                     CountedScene{"drag_used", [](long n) { return scene(n, together, LinearDrag{.c_d = 1.0}); }},
                     CountedScene{"limit_idle", [](long n) { return scene(n, together, SpeedLimit{}); }},
                     CountedScene{"limit_used", [](long n) { return scene(n, together, SpeedLimit{.v_max = 1e-6}); }},
                     CountedScene{"loss_absent", [](long n) { return scene(n, together, far); }},
                     CountedScene{"loss_idle", [](long n) { return flight(swarm_of_all, n); }},
                     CountedScene{"loss_used", [](long n) { return flight(one_more, n); }}};

}  // namespace

int main(int argc, char** argv) { return verification::counted_program(argc, argv, all); }
