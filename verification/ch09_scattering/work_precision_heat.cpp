// Error against run time of heat: the spheres of a cloud in a steady beam, and after a pulse, from 1e4 K.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <harness/races.hpp>
#include <harness/stiff_races.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/heat.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification::work_precision_heat {

using namespace particulate;
using namespace particulate::scattering;
using scattering::Cloud;

// Spheres of 1 mm and 2e6 J/(m^3 K), which radiate to 300 K: a temperature changes by k (theta_e^4 - theta^4).
constexpr double b = 1e-3, rho_c = 2e6, B = 5.670374419e-8, k = 3.0 * B / (rho_c * b), theta_s = 300.0;

// Nobody is given the Jacobian, so that who wants it pays a right-hand side for it.
struct Heated {
  HeatedBodies bodies;

  bool rate(double t, schemes::In theta, schemes::Out d) const { return bodies.rate(t, theta, d); }
  schemes::Bandwidth bandwidth() const { return bodies.bandwidth(); }
};

// Fifty spheres of a cloud of L = 0.325 in a beam over half of its face: what they absorb ranges over a factor of 72.
HeatedBodies lit_cloud(double irradiance) {
  const Eigen::Index N = 50;
  const double edge = b * std::cbrt(static_cast<double>(N)) / 0.325;
  Uniform uniform(1);
  const auto draw = [&] { return uniform(); };
  const kinematics::Box box{.lengths = Eigen::Vector3d::Constant(edge)};
  const Cloud<Sphere> cloud(place_spheres(N, b, {.box = box, .inside = kinematics::Inside::spheres}, draw).bodies, box);
  const Beam beam{.centre = {0.0, 0.5 * edge, 0.5 * edge}, .width = 0.5 * edge, .irradiance = irradiance};
  HeatedBodies bodies = heated_bodies(cloud, rho_c, {.emissivity = 1.0, .theta_s = theta_s});
  bodies.power = trace(cloud, Fresnel{10.0}, rays_of(beam, 10000, draw)).absorbed;
  return bodies;
}

// Where radiation leads in a time t to the end theta_e: by Newton's method on the quadrature of the time over the
// logarithm s of theta - theta_e.
double radiated(double theta_0, double theta_e, double t) {
  if (!(theta_0 > theta_e)) return theta_0;
  const auto rate = [=](double s) {
    const double theta = theta_e + std::exp(s);
    return k * (theta + theta_e) * (theta * theta + theta_e * theta_e);
  };
  const double s_0 = std::log(theta_0 - theta_e);
  double s = s_0;
  for (int i = 0; i < 60; ++i) {
    const auto slowness = [&](double x) { return 1.0 / rate(x); };
    const double took = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(slowness, s, s_0, 3, 1e-15);
    s += std::max((took - t) * rate(s), -0.5);
  }
  return theta_e + std::exp(s);
}

// Temperatures from a start on, of which each goes its own way.
Race race_of(const HeatedBodies& bodies, const Eigen::VectorXd& theta_0) {
  Race race{.problem = Heated{bodies}, .start = {.t = 0.0, .y = theta_0}, .outputs = {0.01, 0.1, 1.0}, .truth = {}};
  std::vector<schemes::State> truth;
  for (const double t : race.outputs) {
    truth.push_back({.t = t, .y = theta_0});
    for (Eigen::Index i = 0; i < theta_0.size(); ++i) {
      const double fourth = std::pow(theta_s, 4) + bodies.power[i] / (B * 4.0 * std::numbers::pi * b * b);
      truth.back().y[i] = radiated(theta_0[i], std::sqrt(std::sqrt(fourth)), t);
    }
  }
  race.truth = [truth](double t) {
    return *std::find_if(truth.begin(), truth.end(), [=](const auto& at) { return at.t == t; });
  };
  return race;
}

void race(Rows& rows, const std::string& problem, const Race& of, bool timed) {
  const reference::Bdf diagonal{.jacobian = reference::BandedJacobian{.lower = 0, .upper = 0}};
  std::vector<Competitor> all = stiff_ones(of, rows.quick(), diagonal);
  all.push_back(with_slope(4.0,
                           competitor("RK4", of, step_sizes(0.01, {10, 1.3, 5}), at_fixed_step<schemes::RungeKutta4>()),
                           "1e4 K fall in a few steps, whose errors are of higher orders too"));
  rows.work_precision({.problem = problem,
                       .reference = "quadrature of the time over the temperature, inverted",
                       .floor = 1e-14,
                       .competitors = std::move(all),
                       .timed = timed});
  compare_at_1e_8(rows, problem);
}

const Case steady{
    {.name = "work_precision_steady_beam",
     .claim = "error against run time of fifty bodies in a steady beam, from 1e4 K: RK4 has order 4 at least, Radau "
              "collocation takes no more evaluations to 1e-8 than CVODE BDF",
     .equation = "R 9.5",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const HeatedBodies bodies = lit_cloud(1e6);
      race(rows, "steady_beam", race_of(bodies, Eigen::VectorXd::Constant(50, 1e4)), true);
    }};

const Case pulse{
    {.name = "work_precision_pulse",
     .claim = "error against run time of fifty bodies after a pulse that has brought the hottest to 1e4 K: RK4 has "
              "order 4 at least, Radau collocation takes no more evaluations to 1e-8 than CVODE BDF",
     .equation = "R 9.5",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      HeatedBodies bodies = lit_cloud(1.0);
      const Eigen::VectorXd cold = Eigen::VectorXd::Constant(50, theta_s);
      const Eigen::VectorXd energy =
          bodies.power * ((1e4 - theta_s) / bodies.power.cwiseQuotient(bodies.capacity).maxCoeff());
      bodies.power.setZero();
      race(rows, "pulse", race_of(bodies, warmed_by(bodies, cold, energy)), rows.full());
    }};

}  // namespace verification::work_precision_heat
