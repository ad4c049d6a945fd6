// Total energy in time, at the integrator's order.

#include <cmath>
#include <vector>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::energy_in_time {

using namespace particulate;

double total_energy(const NearFieldScene& scene, const schemes::State& at) {
  return kinematics::kinetic_energy(scene.particles().mass, rows_of(at.v)) + scene.potential_energy(at);
}

// Errors of the total energy at t_end, over the kinetic energy there at the finest step.
template <class S>
std::vector<double> energy_errors(NearFieldScene& scene, double t_end, const std::vector<double>& steps) {
  const schemes::State start = scenes::start(scene);
  std::vector<double> errors;
  double kinetic = 0.0;
  for (const double step : steps) {
    schemes::State state = start;
    advance<S>(scene, state, t_end, std::lround(t_end / step));
    errors.push_back(std::abs(total_energy(scene, state) - total_energy(scene, start)));
    kinetic = kinematics::kinetic_energy(scene.particles().mass, rows_of(state.v));
  }
  for (double& error : errors) error /= kinetic;
  return errors;
}

std::vector<double> halved(double t_end, long coarsest, int count) {
  std::vector<double> steps;
  for (int k = 0; k < count; ++k) steps.push_back(t_end / static_cast<double>(coarsest << k));
  return steps;
}

const Case energy_in_time{
    {.name = "energy_in_time",
     .claim = "kinetic plus potential energy is kept to the order of the scheme",
     .equation = "M 1.24",
     .reference = Reference::convergence},
    [](Rows& rows) {
      NearFieldScene pair(pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0});
      NearFieldScene cloud(random_cloud({.N = 20}, smooth), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
      const auto compare = [&]<class S>(const std::string& what, S, NearFieldScene& scene, double t_end, long coarsest,
                                        double nominal, const char* because) {
        const std::vector<double> steps = halved(t_end, coarsest, 5);
        const std::vector<double> errors = energy_errors<S>(scene, t_end, steps);
        rows.order(what, {.nominal = nominal, .steps = steps, .errors = errors, .floor = 1e-15, .because = because});
      };
      compare(
          "RK4, pair, t = 1.7 s", schemes::RungeKutta4{}, pair, 1.7, 80, 5,
          "the part of order 4 is a bounded oscillation with a small constant: in extended precision one step's error "
          "falls as h^5.2 near h = 0.004 and as h^5.01 near 1e-4; above, the drift of order 5 prevails");
      compare("velocity Verlet, pair, t = 1.7 s", schemes::VelocityVerlet{}, pair, 1.7, 200, 2,
              "a symplectic scheme of order 2 keeps a neighbouring energy, h^2 away");
      compare("velocity Verlet, cloud, t = 1.3 s", schemes::VelocityVerlet{}, cloud, 1.3, 200, 2,
              "a symplectic scheme of order 2 keeps a neighbouring energy, h^2 away");
      const std::vector<double> steps = halved(1.3, 80, 5);
      const std::vector<double> errors = energy_errors<schemes::RungeKutta4>(cloud, 1.3, steps);
      rows.order_at_least("RK4, cloud, t = 1.3 s",
                          {.nominal = 4.0,
                           .steps = steps,
                           .errors = errors,
                           .floor = 1e-15,
                           .because = "the scheme's order; as for the pair, most of the error is of order 5 here"});
    }};

}  // namespace verification::energy_in_time
