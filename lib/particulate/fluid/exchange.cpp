#include <particulate/fluid/exchange.hpp>

#include <cmath>
#include <numbers>

namespace particulate::fluid {

namespace {

// More than any fluid around weighs.
constexpr double unmoved = 1e200;

// Of the velocity that a force spread by hats makes at its own place, F/(g mu w).
constexpr double self_mobility = 13.9586;

Eigen::Vector3d at(schemes::In x, Eigen::Index i) {
  const Eigen::Index N = x.size() / 3;
  return {x[i], x[i + N], x[i + 2 * N]};
}

}  // namespace

Exchange::Exchange(const kinematics::Particles& particles, int axes, const Eigen::VectorXd& half_width, bool corrected,
                   std::optional<HeatExchange> heat)
    : around(static_cast<std::size_t>(particles.size())),
      axes_(axes),
      heat_(heat),
      b_(particles.radius),
      mass_(particles.mass),
      inverse_mass_(inverse_masses(particles)),
      amplified_(Eigen::VectorXd::Ones(particles.size())),
      given_(static_cast<std::size_t>(particles.size() * (axes + 1))),
      dissipated_(Eigen::VectorXd::Zero(particles.size())) {
  if (heat_) capacity_ = particles.mass.array() * particles.heat_capacity.array();
  // v_f' - v = (v_f - v)/(1 - 6 pi b/(g w)), with the drag of Stokes in the correction.
  if (corrected) {
    amplified_ = (1.0 - 6.0 * std::numbers::pi / self_mobility * b_.array() / half_width.array()).inverse();
  }
}

Eigen::Vector3d Exchange::past(Eigen::Index i, const Eigen::Vector3d& v) const {
  Eigen::Vector3d u = around[static_cast<std::size_t>(i)].v - v;
  for (int a = axes_; a < 3; ++a) u[a] = 0.0;
  return u;
}

double Exchange::coefficient(Eigen::Index i, double u) const {
  return amplified_[i] * drag_rate(around[static_cast<std::size_t>(i)], b_[i], amplified_[i] * u);
}

double Exchange::reynolds(Eigen::Index i, const Eigen::Vector3d& v) const {
  const Stream& fluid = around[static_cast<std::size_t>(i)];
  return 2.0 * b_[i] * fluid.rho * amplified_[i] * kinematics::length(past(i, v)) / fluid.mu;
}

bool Exchange::rates(schemes::In v, schemes::In theta, Eigen::VectorXd& force, Eigen::VectorXd& heat) {
  const Eigen::Index N = b_.size();
  force.resize(3 * N);
  if (heat_) heat.resize(N);
  bool finite = true;
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Vector3d own = at(v, i), u = past(i, own), drag = coefficient(i, kinematics::length(u)) * u;
    double work = drag.dot(own);
    for (int a = 0; a < 3; ++a) force[i + a * N] = drag[a];
    if (heat_) {
      const double area = thermo::surface(b_[i]), shared = heat_->a_v * drag.dot(u);
      const double convected = area * heat_->h_c * (around[static_cast<std::size_t>(i)].theta - theta[i]);
      heat[i] = shared + area * heat_flux(cooling(*heat_, around[static_cast<std::size_t>(i)].theta), theta[i]);
      work += convected + shared;
      finite = finite && std::isfinite(heat[i]);
    }
    double* const given = given_to(i);
    for (int a = 0; a < axes_; ++a) given[a] = drag[a];
    given[axes_] = work;
    finite = finite && drag.allFinite() && std::isfinite(work);
  }
  return finite;
}

bool Exchange::move(const schemes::State& from, const Eigen::VectorXd& other, double dt, schemes::Out v,
                    schemes::Out r) {
  const Eigen::Index N = b_.size();
  roots_ = {};
  bool finite = true;
  for (Eigen::Index i = 0; i < N; ++i) {
    const double lighter = inverse_mass_[i];
    const Eigen::Vector3d before = at(from.v, i), pushed = dt * at(other, i);
    const double xi = coefficient(i, kinematics::length(past(i, at(v, i)))), a = dt * lighter * xi;
    const Eigen::Vector3d coming = past(i, before + lighter * pushed), slip = coming / (1.0 + a);
    const Eigen::Vector3d J = dt * xi * slip, after = before + lighter * (J + pushed), mean = 0.5 * (before + after);
    count_roots(i, kinematics::length(coming), kinematics::length(slip), dt);
    double* const given = given_to(i);
    for (int c = 0; c < axes_; ++c) given[c] = J[c];
    given[axes_] = J.dot(mean);
    dissipated_[i] = J.dot(past(i, mean));
    for (int c = 0; c < 3; ++c) {
      v[i + c * N] = after[c];
      r[i + c * N] = from.r[i + c * N] + dt * after[c];
    }
    finite = finite && after.allFinite() && std::isfinite(given[axes_]) && at(r, i).allFinite();
  }
  return finite;
}

// Backward Euler is u (1 + dt xi(u)/m) = coming. On either side of the jump the left side grows with u; it falls at it.
void Exchange::count_roots(Eigen::Index i, double coming, double u, double dt) {
  const Stream& fluid = around[static_cast<std::size_t>(i)];
  const double at_crisis = drag_crisis * fluid.mu / (2.0 * b_[i] * fluid.rho * amplified_[i]);
  if (coming <= at_crisis) return;  // spares most particles two coefficients: the left side is more than its speed
  const auto left_side = [&](double speed) { return speed * (1.0 + dt * inverse_mass_[i] * coefficient(i, speed)); };
  if (coming < left_side(at_crisis * (1.0 - 1e-9)) && coming > left_side(at_crisis * (1.0 + 1e-9))) {
    ++(u <= at_crisis ? roots_.slow : roots_.fast);
  }
}

bool Exchange::warm(schemes::In from, const Eigen::VectorXd& other, double dt, schemes::Out theta) {
  bool good = true;
  for (Eigen::Index i = 0; i < b_.size(); ++i) {
    const thermo::Cooling law = cooling(*heat_, around[static_cast<std::size_t>(i)].theta);
    const double area = dt * thermo::surface(b_[i]), shared = heat_->a_v * dissipated_[i],
                 slope = heat_flux_slope(law, theta[i]);
    const double flux = heat_flux(law, theta[i]) + slope * (from[i] - theta[i]);
    theta[i] = from[i] + (area * flux + dt * other[i] + shared) / (capacity_[i] - area * slope);
    given_to(i)[axes_] += area * law.h_c * (law.theta_o - theta[i]) + shared;
    good = good && theta[i] > 0.0 && std::isfinite(theta[i]);
  }
  return good;
}

Exchange::Rates Exchange::step_rates(schemes::In v, schemes::In theta) const {
  const Eigen::Index N = b_.size(), heated = heat_ ? N : 0;
  Rates all{.mass = mass_,
            .drag = Eigen::VectorXd(N),
            .capacity = capacity_,
            .heat = Eigen::VectorXd(heated),
            .relaxes = Eigen::VectorXd(N),
            .cools = Eigen::VectorXd(heated)};
  for (Eigen::Index i = 0; i < N; ++i) {
    all.drag[i] = coefficient(i, kinematics::length(past(i, at(v, i))));
    all.relaxes[i] = all.drag[i] * inverse_mass_[i];
    if (inverse_mass_[i] == 0.0) all.mass[i] = unmoved;
  }
  for (Eigen::Index i = 0; i < heated; ++i) {
    const double area = thermo::surface(b_[i]);
    all.heat[i] = heat_->h_c * area;
    all.cools[i] =
        -area * heat_flux_slope(cooling(*heat_, around[static_cast<std::size_t>(i)].theta), theta[i]) / capacity_[i];
  }
  return all;
}

}  // namespace particulate::fluid
