// The books of a swarm's energy and momentum: what drag and the speed limit take.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/symplectic_euler.hpp>

#include "swarms.hpp"

namespace verification::swarm_energy {

using namespace particulate;

// A flight over the fence whose energy and work of drag are known.
struct Books {
  double before, change, drag, cap;  // energy at the start, its change, and what drag and cap did to it [J]
  double open() const { return std::abs(change - drag - cap) / std::abs(before); }
};

// The power of the drag rides along. The laws with a potential make a scene of their own, which knows their energy.
template <class S, class... Cap>
Books books_of(const kinematics::Particles& start, double t_end, long steps, const Cap&... cap) {
  const double c_d = 1.0;
  const swarm::Course course = swarm::fence();
  const Riding flight{scene_of(start, passing, course, swarm::LinearDrag{.c_d = c_d}, cap...),
                      std::function([&](schemes::In, schemes::In v) {
                        return -c_d * start.mass.dot(vectors_in(v).rowwise().squaredNorm());
                      })};
  const auto conservative = scene_of(start, passing, course);
  const auto energy = [&](const schemes::State& at) {
    return kinematics::kinetic_energy(start.mass, rows_of(at.v)) + conservative.potential_energy(at);
  };
  schemes::State state = start_of(flight);
  const double before = energy(state);
  const schemes::Outcome outcome =
      reached(flight, state, t_end, S(), schemes::FixedStep{.step = t_end / static_cast<double>(steps)});
  if (sizeof...(Cap) > 0 && outcome.impacts < 100) throw std::runtime_error("the cap took too little to say anything");
  return {before, energy(state) - before, state.y[0], outcome.energy_change};
}

template <class S, class... Cap>
void close_books(Rows& rows, const std::string& by, const kinematics::Particles& start, double t_end, long coarsest,
                 double order, const std::string& because, const Cap&... cap) {
  std::vector<double> steps, errors;
  for (long n = coarsest; steps.size() < 5; n = n * 3 / 2) {
    steps.push_back(t_end / static_cast<double>(n));
    errors.push_back(books_of<S>(start, t_end, n, cap...).open());
  }
  rows.order(by, {.nominal = order, .steps = steps, .errors = errors, .floor = 1e-13, .because = because});
}

const Case balance{
    {.name = "swarm_energy",
     .claim =
         "the energy of a swarm changes by the work of its drag and by what the speed limit takes, at the scheme's "
         "order",
     .equation = "D 6.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      const kinematics::Particles few = swarm_at_rest(16, 1);  // no close encounter: steps resolve the motion
      const char* smooth = "smooth forces";
      close_books<schemes::SymplecticEuler>(rows, "symplectic Euler, without cap", few, 2.1, 600, 1.0, smooth);
      close_books<schemes::RungeKutta4>(rows, "RK4, without cap", few, 2.1, 60, 4.0, smooth);
      close_books<schemes::SymplecticEuler>(rows, "symplectic Euler with the cap, 128 members over the fence",
                                            swarm_at_rest(128, 1), 15.0, rows.quick() ? 750 : 1500, 1.0,
                                            "the order of the scheme, and of the cap at the ends of steps",
                                            swarm::SpeedLimit{.v_max = 3.0});
    }};

const Case momentum{
    {.name = "members_momentum",
     .claim = "what members do to each other leaves momentum and angular momentum of the swarm as they are",
     .equation = "R 6.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      kinematics::Particles start = swarm_at_rest(48, rows.case_seed());
      for (Eigen::Index i = 0; i < start.size(); ++i) {
        start.mass[i] = 1.0 + 0.05 * static_cast<double>(i);
        start.velocity.row(i) = Eigen::RowVector3d(0.3, -0.2, 0.1) + 0.1 * start.position.row(i);
      }
      const scenes::Scene scene(start, kinematics::Space{}, members_law(passing, start.mass.sum()));
      schemes::State state = scenes::start(scene);
      advance<schemes::SymplecticEuler>(scene, state, 10.0, 1000);
      const auto r = rows_of(state.r), v = rows_of(state.v);
      const char* because = "a thousand steps of symplectic Euler, which keeps both, each with its rounding";
      const Eigen::Vector3d linear = kinematics::linear_momentum(start.mass, start.velocity);
      rows.at_most("change of momentum over it",
                   {.limit = 1e-12,
                    .computed = (kinematics::linear_momentum(start.mass, v) - linear).norm() / linear.norm(),
                    .because = because});
      const Eigen::Vector3d angular = kinematics::angular_momentum(start.mass, start.position, start.velocity);
      rows.at_most("change of angular momentum over it",
                   {.limit = 1e-12,
                    .computed = (kinematics::angular_momentum(start.mass, r, v) - angular).norm() / angular.norm(),
                    .because = because});
    }};

}  // namespace verification::swarm_energy
