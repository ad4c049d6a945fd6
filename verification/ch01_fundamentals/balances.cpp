// Energy and momentum: at an instant, along a motion, and against work and impulse.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/central_force.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/laws/law.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "differences.hpp"

namespace verification::balances {

using namespace particulate;

// A law of the cases' own, as in section 1.2 of the monograph: every particle is pulled towards a place that does not
// move, so that momenta are not conserved.
struct FixedCentre {
  Eigen::Vector3d place;         // [m]
  kinematics::CentralForce law;  // the same for every particle
};

bool add_force(const FixedCentre& centre, const kinematics::Space&, const laws::At<>& at, laws::Forces force) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    force.row(i) += kinematics::force(centre.law, at.position.row(i).transpose(), centre.place).transpose();
  }
  return force.allFinite();
}

// A cloud about a fixed centre, at equal times, of which the sums over work and impulse take every second, fourth, ...
// moment; for them it counts as exact.
struct SampledMotion {
  double t_end = 1.3;                                          // [s]
  Eigen::VectorXd mass;                                        // [kg]
  std::vector<kinematics::Vectors> position, velocity, force;  // at each moment
};

// The motion of a cloud of 20 by RK4.
SampledMotion sampled_motion(std::uint64_t seed, long steps) {
  scenes::Scene scene(
      random_cloud({.N = 20}, seed), kinematics::Space{}, laws::NearField{.alpha1 = 0.1, .alpha2 = 0.05},
      FixedCentre{.place{0.4, 2.0, -1.0}, .law{.alpha1 = 2.0, .alpha2 = 0.1, .beta1 = 0.5, .beta2 = 1.5}});
  SampledMotion fine;
  fine.mass = scene.particles().mass;
  Eigen::VectorXd flat(3 * fine.mass.size());
  for (const schemes::State& at : path<schemes::RungeKutta4>(scene, scenes::start(scene), fine.t_end, steps)) {
    if (!scene.total_force(at, flat)) throw std::runtime_error("the cloud has no forces");
    fine.position.emplace_back(rows_of(at.r));
    fine.velocity.emplace_back(rows_of(at.v));
    fine.force.emplace_back(rows_of(flat));
  }
  return fine;
}

// Relative errors of sums where every 64th, 32nd, ... 2nd moment is taken; `error(stride)` gives one.
template <class F>
void compare_sums(Rows& rows, const std::string& what, const SampledMotion& fine, const char* because, const F& error) {
  std::vector<double> steps, errors;
  for (std::size_t stride = 64; stride >= 2; stride /= 2) {
    steps.push_back(fine.t_end * static_cast<double>(stride) / static_cast<double>(fine.force.size() - 1));
    errors.push_back(error(fine, stride));
  }
  rows.order(what, {.nominal = 2.0, .steps = steps, .errors = errors, .floor = 1e-13, .because = because});
  rows.at_most(
      what + ", 4096 pieces",
      {.limit = 1e-5, .computed = errors.back(), .because = "order 2 from below 1e-2 at 128 pieces: 32^2 times less"});
}

// Kinetic energy per unit mass is that of the centre of mass and that about it.

struct Expected {
  double bulk, relative, total;
};

// Relative motion as the sum over pairs m_i m_j |v_i - v_j|^2 / (2 M^2), without any mean velocity.
Expected by_pairs(const kinematics::Particles& of) {
  using Row = Eigen::Matrix<long double, 1, 3>;
  long double M = 0.0L, total = 0.0L, relative = 0.0L;
  Row G = Row::Zero();
  for (Eigen::Index i = 0; i < of.size(); ++i) {
    const Row v_i = of.velocity.row(i).cast<long double>();
    const long double m_i = of.mass[i];
    M += m_i;
    G += m_i * v_i;
    total += 0.5L * m_i * v_i.squaredNorm();
    for (Eigen::Index j = 0; j < i; ++j)
      relative += m_i * of.mass[j] * (v_i - of.velocity.row(j).cast<long double>()).squaredNorm();
  }
  return {.bulk = static_cast<double>(0.5L * (G / M).squaredNorm()),
          .relative = static_cast<double>(0.5L * relative / (M * M)),
          .total = static_cast<double>(total / M)};
}

void compare(Rows& rows, const kinematics::Particles& of, const std::string& which, double shift) {
  const Expected expected = by_pairs(of);
  const kinematics::KineticEnergy computed = kinematics::split_kinetic_energy(of.mass, of.velocity);
  const char* const because = "sums over N = 200 particles rounded to eps/2 each, squared";
  rows.compare(
      "bulk [J/kg]" + which,
      {.expected = expected.bulk, .computed = computed.bulk, .tolerance = relative(4e-14), .because = because});
  rows.compare("relative [J/kg]" + which,
               {.expected = expected.relative,
                .computed = computed.relative,
                .tolerance = mixed(4e-14, 1e-15 * shift),
                .because = "as bulk; velocities rounded to eps/2 of the shift, times relative speeds below 1 m/s"});
  rows.compare("bulk + relative [J/kg]" + which, {.expected = expected.total,
                                                  .computed = computed.bulk + computed.relative,
                                                  .tolerance = relative(4e-14),
                                                  .because = because});
  rows.compare("T [J]" + which, {.expected = expected.total * of.mass.sum(),
                                 .computed = kinematics::kinetic_energy(of.mass, of.velocity),
                                 .tolerance = relative(4e-14),
                                 .because = because});
}

const Case kinetic_energy_split{
    {.name = "kinetic_energy_split",
     .claim = "T/M is the bulk plus the relative part, and a moving observer sees the same relative part",
     .equation = "M 2.28",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      kinematics::Particles cloud = random_cloud({.N = 200, .speed = 0.4, .decades = 3.0}, rows.case_seed());
      cloud.velocity.rowwise() += Eigen::RowVector3d{0.1, -0.3, 0.2};
      compare(rows, cloud, "", 1.0);
      const double before = kinematics::split_kinetic_energy(cloud.mass, cloud.velocity).relative;
      for (const double shift : {1.0, 1e4}) {
        kinematics::Particles seen = cloud;
        seen.velocity.rowwise() += shift * slanted().transpose();
        const std::string which = fmt::format(", seen at {} m/s", shift);
        compare(rows, seen, which, shift);
        rows.compare(
            "relative as before [J/kg]" + which,
            {.expected = before,
             .computed = kinematics::split_kinetic_energy(seen.mass, seen.velocity).relative,
             .tolerance = absolute(1e-15 * shift),
             .because = "each shifted velocity is rounded to eps/2 of the shift, times relative speeds below 1 m/s"});
      }
    }};

// At one instant the kinetic energy changes by the power of the forces, the angular momentum by their moment.

constexpr double h = 0.01;

// What a function of the state does in time at the middle one of nine states, h apart.
template <class F>
double rate_at_middle(const std::vector<schemes::State>& states, const F& of) {
  return slope_at_zero([&](double t) { return of(states[static_cast<std::size_t>(4 + std::lround(t / h))]); }, h);
}

// Sums over particles written out, so that a mistake in the library's own sums does not meet itself.
struct Sums {
  double energy = 0.0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), about_origin = Eigen::Vector3d::Zero();
};

Sums sums_of(const Eigen::VectorXd& mass, const schemes::State& at) {
  const Eigen::Index N = mass.size();
  Sums sums;
  for (Eigen::Index i = 0; i < N; ++i) {
    const double m = mass[i], x = at.r[i], y = at.r[N + i], z = at.r[2 * N + i];
    const double u = at.v[i], v = at.v[N + i], w = at.v[2 * N + i];
    sums.energy += 0.5 * m * (u * u + v * v + w * w);
    sums.momentum += m * Eigen::Vector3d{u, v, w};
    sums.about_origin += m * Eigen::Vector3d{y * w - z * v, z * u - x * w, x * v - y * u};
  }
  return sums;
}

void prove_energy_rate(Rows& rows) {
  scenes::Scene scene(
      random_cloud({.N = 20}, rows.case_seed()), kinematics::Space{}, laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25},
      FixedCentre{.place{0.4, 2.0, -1.0}, .law{.alpha1 = 2.0, .alpha2 = 0.1, .beta1 = 0.5, .beta2 = 1.5}});
  constexpr long fine = 20;
  const std::vector<schemes::State> states = path<schemes::RungeKutta4>(scene, scenes::start(scene), 8.0 * h, 8 * fine);
  std::vector<schemes::State> nine;
  for (std::size_t k = 0; k <= 8; ++k) nine.push_back(states[k * fine]);

  const Eigen::VectorXd& mass = scene.particles().mass;
  const schemes::State& middle = nine[4];
  Eigen::VectorXd flat(middle.r.size());
  if (!scene.total_force(middle, flat)) throw std::runtime_error("the cloud has no forces");
  const kinematics::Vectors force = rows_of(flat), r = rows_of(middle.r), v = rows_of(middle.v);

  const Sums written_out = sums_of(mass, middle);
  const auto distance_from = [](const Eigen::Vector3d& computed, const Eigen::Vector3d& expected) {
    return (computed - expected).norm() / expected.norm();
  };
  const char* const summed = "sums over 20 particles rounded to eps/2 each";
  rows.compare("T [J]", {.expected = written_out.energy,
                         .computed = kinematics::kinetic_energy(mass, v),
                         .tolerance = relative(5e-15),
                         .because = summed});
  rows.at_most("error of G", {.limit = 5e-14,
                              .computed = distance_from(kinematics::linear_momentum(mass, v), written_out.momentum),
                              .because = summed});
  rows.at_most("error of H_o",
               {.limit = 5e-14,
                .computed = distance_from(kinematics::angular_momentum(mass, r, v), written_out.about_origin),
                .because = summed});

  const char* const because =
      "sums near 10 rounded to 1e-16 carry 2e-13 in differences over h = 0.01; truncation h^8 and "
      "RK4's (h/20)^4 lie below";
  rows.compare("dT/dt [W]", {.expected = rate_at_middle(nine, [&](const auto& at) { return sums_of(mass, at).energy; }),
                             .computed = kinematics::power_of(force, v),
                             .tolerance = relative(2e-12),
                             .because = because});
  const Eigen::Vector3d dG = force.colwise().sum().transpose(), dH = kinematics::moment(r, force);
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    rows.compare("dG_" + name + "/dt [N]",
                 {.expected = rate_at_middle(nine, [&](const auto& at) { return sums_of(mass, at).momentum[axis]; }),
                  .computed = dG[axis],
                  .tolerance = absolute(1e-12 * dG.norm()),
                  .because = because});
    rows.compare(
        "dH_" + name + "/dt [N m]",
        {.expected = rate_at_middle(nine, [&](const auto& at) { return sums_of(mass, at).about_origin[axis]; }),
         .computed = dH[axis],
         .tolerance = absolute(1e-12 * dH.norm()),
         .because = because});
  }
  rows.at_least(
      "power [W]",
      {.limit = 1e-2, .computed = std::abs(kinematics::power_of(force, v)), .because = "else nothing was compared"});
}

const Case energy_rate{{.name = "energy_rate",
                        .claim = "dT/dt = sum Psi . v, dG/dt = sum Psi and dH/dt = sum r x Psi at one instant",
                        .equation = "M 1.16",
                        .reference = Reference::identity},
                       prove_energy_rate};

// Total energy in time, at the integrator's order.

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

void prove_energy_in_time(Rows& rows) {
  NearFieldScene pair(pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0});
  NearFieldScene cloud(random_cloud({.N = 20}, smooth), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
  const auto compare = [&]<class S>(const std::string& what, S, NearFieldScene& scene, double t_end, long coarsest,
                                    double nominal, const char* because) {
    const std::vector<double> steps = halved(t_end, coarsest, 5);
    const std::vector<double> errors = energy_errors<S>(scene, t_end, steps);
    rows.order(what, {.nominal = nominal, .steps = steps, .errors = errors, .floor = 1e-15, .because = because});
  };
  compare("RK4, pair, t = 1.7 s", schemes::RungeKutta4{}, pair, 1.7, 80, 5,
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
}

const Case energy_in_time{{.name = "energy_in_time",
                           .claim = "kinetic plus potential energy is kept to the order of the scheme",
                           .equation = "M 1.24",
                           .reference = Reference::convergence},
                          prove_energy_in_time};

// Momenta of a cloud in time: what each scheme keeps to rounding, and what it keeps to its order.

constexpr double t_end = 3.7;

// Largest change of both momenta over a run, over sum m |v| and sum m |r||v| at the start.
struct Drift {
  double linear = 0.0, angular = 0.0;
};

template <class S>
Drift drift(NearFieldScene& scene, long steps) {
  const kinematics::Particles& start = scene.particles();
  const Eigen::VectorXd size = start.mass.cwiseProduct(start.velocity.rowwise().norm());
  const Eigen::Vector3d G = kinematics::linear_momentum(start.mass, start.velocity);
  const Eigen::Vector3d H = kinematics::angular_momentum(start.mass, start.position, start.velocity);
  Drift worst;
  for (const schemes::State& at : path<S>(scene, scenes::start(scene), t_end, steps)) {
    const Eigen::Vector3d G_t = kinematics::linear_momentum(start.mass, rows_of(at.v));
    const Eigen::Vector3d H_t = kinematics::angular_momentum(start.mass, rows_of(at.r), rows_of(at.v));
    worst.linear = std::max(worst.linear, (G_t - G).norm() / size.sum());
    worst.angular = std::max(worst.angular, (H_t - H).norm() / start.position.rowwise().norm().dot(size));
  }
  return worst;
}

// The drift at the end time of a close pair, where RK4's truncation stands clear of rounding.
std::vector<double> angular_drifts(const std::vector<double>& steps) {
  kinematics::Particles start = pair_at_rest(1.0, 3.0, 1.0);
  kinematics::set_vector(start.velocity, 1, {0.6, -1.2, 0.4});
  NearFieldScene scene(start, {}, {.alpha1 = 1.0, .alpha2 = 0.25, .beta1 = 2.0, .beta2 = 3.0});
  const Eigen::Vector3d H = kinematics::angular_momentum(start.mass, start.position, start.velocity);
  std::vector<double> drifts;
  for (const double step : steps) {
    schemes::State state = scenes::start(scene);
    advance<schemes::RungeKutta4>(scene, state, t_end, std::lround(t_end / step));
    drifts.push_back((kinematics::angular_momentum(start.mass, rows_of(state.r), rows_of(state.v)) - H).norm() /
                     H.norm());
  }
  return drifts;
}

void prove_momentum_in_time(Rows& rows) {
  NearFieldScene scene(random_cloud({.N = 20}, rows.case_seed()), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
  const long steps = 1000;
  const Drift rk4 = drift<schemes::RungeKutta4>(scene, steps);
  const Drift verlet = drift<schemes::VelocityVerlet>(scene, steps);
  const char* const because =
      "1000 steps, each rounding 60 velocities of a few times the start's by eps/2 = 1e-16, "
      "add as a random walk to some 1e-14";
  rows.at_most("linear momentum over sum m|v|, RK4", {.limit = 5e-14, .computed = rk4.linear, .because = because});
  rows.at_most("linear momentum over sum m|v|, velocity Verlet",
               {.limit = 5e-14, .computed = verlet.linear, .because = because});
  rows.at_most("angular momentum over sum m|r||v|, velocity Verlet",
               {.limit = 5e-14,
                .computed = verlet.angular,
                .because = "each half of a Verlet step conserves it under central pair forces; roundings as above"});

  std::vector<double> sizes;
  for (long n = 60; n <= 960; n *= 2) sizes.push_back(t_end / static_cast<double>(n));
  const std::vector<double> drifts = angular_drifts(sizes);
  rows.order("angular momentum at t = 3.7 s, RK4, a turning pair",
             {.nominal = 5.0,
              .steps = sizes,
              .errors = drifts,
              .floor = 1e-15,
              .because = "RK4 keeps quadratic invariants one order better than itself: in extended precision one "
                         "step's error falls as h^6, for two bodies and for three"});
}

const Case momentum_in_time{
    {.name = "momentum_in_time",
     .claim = "near fields keep linear momentum to rounding under any scheme, and angular momentum to rounding under "
              "Verlet, to its order under RK4",
     .equation = "M 1.39",
     .reference = Reference::identity},
    prove_momentum_in_time};

// Work summed along a motion is the change of kinetic energy.

// Particle by particle, because the errors of many could cancel in their sum.
double error_of_work(const SampledMotion& fine, std::size_t stride) {
  const Eigen::Index N = fine.mass.size();
  Eigen::VectorXd error(N), gained(N);
  for (Eigen::Index i = 0; i < N; ++i) {
    double work = 0.0;
    for (std::size_t k = stride; k < fine.force.size(); k += stride) {
      work += kinematics::work_between(fine.force[k - stride].row(i), fine.position[k - stride].row(i),
                                       fine.force[k].row(i), fine.position[k].row(i));
    }
    const Eigen::VectorXd mass = fine.mass.segment(i, 1);
    gained[i] = kinematics::kinetic_energy(mass, fine.velocity.back().row(i)) -
                kinematics::kinetic_energy(mass, fine.velocity.front().row(i));
    error[i] = work - gained[i];
  }
  return error.norm() / gained.norm();
}

// All particles at once, against the sum of what they gain one by one.
double difference_of_sum(const SampledMotion& fine) {
  double at_once = 0.0, one_by_one = 0.0, size = 0.0;
  for (std::size_t k = 1; k < fine.force.size(); ++k) {
    at_once += kinematics::work_between(fine.force[k - 1], fine.position[k - 1], fine.force[k], fine.position[k]);
    for (Eigen::Index i = 0; i < fine.mass.size(); ++i) {
      const double work = kinematics::work_between(fine.force[k - 1].row(i), fine.position[k - 1].row(i),
                                                   fine.force[k].row(i), fine.position[k].row(i));
      one_by_one += work;
      size += std::abs(work);
    }
  }
  return std::abs(at_once - one_by_one) / size;
}

const Case work_energy{
    {.name = "work_energy",
     .claim =
         "the work of all forces on a particle along its motion is the change of its kinetic energy, summed to order 2",
     .equation = "M 1.15",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const SampledMotion fine = sampled_motion(smooth, 8192);
      compare_sums(rows, "work on each particle against its T_2 - T_1", fine,
                   "the trapezoidal rule along a smooth path; RK4's own error is below 1e-12", error_of_work);
      rows.at_most("work on all at once against one by one",
                   {.limit = 1e-13,
                    .computed = difference_of_sum(fine),
                    .because = "8192 times 20 terms in another order, each rounded to 1e-16"});
    }};

// The impulse on each particle, summed in time, is the change of its momentum.

double error_of_impulse(const SampledMotion& fine, std::size_t stride) {
  const double dt = fine.t_end * static_cast<double>(stride) / static_cast<double>(fine.force.size() - 1);
  kinematics::Vectors impulse = kinematics::Vectors::Zero(fine.mass.size(), 3);
  for (std::size_t k = stride; k < fine.force.size(); k += stride) {
    impulse += kinematics::impulse_between(fine.force[k - stride], fine.force[k], dt);
  }
  const kinematics::Vectors gained = fine.mass.asDiagonal() * (fine.velocity.back() - fine.velocity.front());
  return (impulse - gained).norm() / gained.norm();
}

const Case impulse_momentum{
    {.name = "impulse_momentum",
     .claim = "the impulse of the forces on each particle is the change of its momentum, summed to order 2",
     .equation = "M 1.38",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const SampledMotion fine = sampled_motion(smooth, 8192);
      compare_sums(rows, "impulses against m (v_2 - v_1)", fine,
                   "the trapezoidal rule in time; RK4's own error is below 1e-12", error_of_impulse);
    }};

}  // namespace verification::balances
