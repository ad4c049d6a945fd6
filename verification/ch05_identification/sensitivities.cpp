// How much the relative energy of a cloud says of its near field: sensitivities, and what follows from them.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <ch04_simulations/clouds.hpp>
#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/identification/near_field_shape.hpp>
#include <particulate/reference/integrator.hpp>

#include "fits.hpp"

namespace verification::identification_sensitivities {

using namespace particulate;
using namespace particulate::identification;

constexpr double T = 0.5;

// The motion of a cloud together with its derivatives by (ln alpha1, ln alpha2, beta1, beta2): the variational
// equations, by a plain double loop of their own.
struct Varied {
  Eigen::VectorXd mass;
  Eigen::Vector4d p;

  // Rows of r: the places of all bodies, and then four times their derivatives.
  bool acceleration(double, schemes::In flat, schemes::Out to) const {
    const Eigen::Index N = mass.size();
    const Eigen::Map<const kinematics::Vectors> r(flat.data(), 5 * N, 3);
    to.setZero();
    Eigen::Map<kinematics::Vectors> a(to.data(), 5 * N, 3);
    for (Eigen::Index i = 0; i < N; ++i) {
      for (Eigen::Index j = 0; j < i; ++j) {
        const Eigen::RowVector3d apart = r.row(j) - r.row(i);
        const double d = apart.norm(), log_d = std::log(d);
        const double attraction = std::exp(p[0] - (p[2] + 1.0) * log_d);
        const double repulsion = std::exp(p[1] - (p[3] + 1.0) * log_d);
        // The force over the distance, its slope over the distance, and its derivatives by the parameters.
        const double force = attraction - repulsion;
        const double slope = ((p[3] + 1.0) * repulsion - (p[2] + 1.0) * attraction) / (d * d);
        const std::array by{attraction, -repulsion, -log_d * attraction, log_d * repulsion};
        add(a, i, j, force * apart);
        for (Eigen::Index k = 1; k <= 4; ++k) {
          const Eigen::RowVector3d moved = r.row(k * N + j) - r.row(k * N + i);
          add(a, k * N + i, k * N + j,
              slope * apart.dot(moved) * apart + force * moved + by[static_cast<std::size_t>(k - 1)] * apart);
        }
      }
    }
    return true;
  }
  void add(Eigen::Map<kinematics::Vectors>& a, Eigen::Index i, Eigen::Index j, const Eigen::RowVector3d& force) const {
    a.row(i) += mass[j % mass.size()] * force;
    a.row(j) -= mass[i % mass.size()] * force;
  }
};

// Derivatives of the relative energy at some times, by CVODE.
Eigen::MatrixXd by_variation(const kinematics::Particles& cloud, const std::vector<double>& times) {
  const Eigen::Index N = cloud.size();
  Varied varied{.mass = cloud.mass, .p = true_parameters()};
  kinematics::Vectors r = kinematics::Vectors::Zero(5 * N, 3), v = r;
  r.topRows(N) = cloud.position;
  v.topRows(N) = cloud.velocity;
  schemes::State state{.t = 0.0, .r = r.reshaped(), .v = v.reshaped()};
  reference::Integrator cvode(varied, state, reference::Adams{.relative = 1e-11, .absolute = 1e-13});
  Eigen::MatrixXd J(static_cast<Eigen::Index>(times.size()), 4);
  for (Eigen::Index row = 0; row < J.rows(); ++row) {
    require_reached(cvode.advance(state, times[static_cast<std::size_t>(row)]));
    const kinematics::Vectors all = rows_of(state.v);
    const Eigen::RowVector3d mean = cloud.mass.transpose() * all.topRows(N) / cloud.mass.sum();
    const kinematics::Vectors about = cloud.mass.asDiagonal() * (all.topRows(N).rowwise() - mean);
    for (Eigen::Index k = 0; k < 4; ++k) {
      J(row, k) = about.cwiseProduct(all.middleRows((k + 1) * N, N)).sum() / cloud.mass.sum();
    }
  }
  return J;
}

// The largest error of a column, over its size.
double error_of(const Eigen::MatrixXd& J, const Eigen::MatrixXd& exact) {
  return ((J - exact).colwise().norm().array() / exact.colwise().norm().array()).maxCoeff();
}

const Case variational{
    {.name = "sensitivities_variational",
     .claim = "central differences of the relative energy are its derivatives by the parameters, to order 2",
     .equation = "D 5.1",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const std::vector<double> times = moments(T, 20);
      const auto differences = [&](Eigen::Index N, double step) {
        const HistoryCost cost = own_cost(cloud_model(book_clouds(N, 1, 1), times), 1, times, true_parameters());
        return sensitivities(sampled(cost), true_parameters(), absolute_steps(4, step)).jacobian;
      };
      const Eigen::MatrixXd exact = by_variation(book_cloud(20, 1), times);
      std::vector<double> steps, errors;
      for (double step = 8e-3; steps.size() < 6; step *= 0.5) {
        steps.push_back(step);
        errors.push_back(error_of(differences(20, step), exact));
      }
      rows.order("differences of a cloud of 20", {.nominal = 2.0,
                                                  .steps = steps,
                                                  .errors = errors,
                                                  .floor = 1e-9,
                                                  .because = "central differences leave the third derivative"});
      const Eigen::Index N = rows.quick() ? 50 : 100;
      rows.at_most(fmt::format("error of differences over the derivative, {} particles, step 1e-5 [-]", N),
                   {.limit = 1e-5,
                    .computed = error_of(differences(N, 1e-5), by_variation(book_cloud(N, 1), times)),
                    .because = "some 1e-10 of the histories over the step"});
    }};

// Six numbers: standard deviations of ln alpha1, ln alpha2, beta1, beta2, ln d_e, ln V''.
Eigen::VectorXd deviations_of(std::uint64_t first_seed) {
  constexpr int starts = 5;
  const std::vector<double> times = moments(T, 20);
  const HistoryCost cost =
      own_cost(cloud_model(book_clouds(100, starts, first_seed), times), starts, times, true_parameters());
  const Eigen::MatrixXd J = sensitivities(sampled(cost), true_parameters(), absolute_steps(4, 1e-4)).jacobian;
  const Eigen::VectorXd noise = 0.01 * cost.data();
  const Eigen::Matrix4d to_shape = derivative_of_log_shape({.alpha1 = 0.5, .alpha2 = 0.25});
  Eigen::VectorXd all(6);
  all << uncertainty(J, noise).deviation, uncertainty(to_other_parameters(J, to_shape), noise).deviation.head(2);
  return all;
}

const Case of_a_cloud{
    {.name = "sensitivities_of_a_cloud",
     .claim = "the relative energy of a cloud determines where its near field balances and how stiff it is there, and "
              "neither its strengths nor its exponents",
     .equation = "D 5.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      struct Expected {
        const char* name;
        double value;
      };
      constexpr std::array expected{Expected{"ln alpha1", 0.08}, Expected{"ln alpha2", 0.16},
                                    Expected{"beta1", 0.06},     Expected{"beta2", 0.05},
                                    Expected{"ln d_e", 0.0013},  Expected{"ln V''", 0.007}};
      const int sets = rows.quick() ? 2 : 8;
      Eigen::ArrayXXd all(6, sets);
      report::Table shown({"first seed", "ln alpha1", "ln alpha2", "beta1", "beta2", "ln d_e", "ln V''"});
      for (int set = 0; set < sets; ++set) {
        all.col(set) = deviations_of(1 + 5 * static_cast<std::uint64_t>(set));
        std::vector<report::Cell> line{1.0 + 5.0 * set};
        for (const double deviation : all.col(set)) line.emplace_back(deviation);
        shown.add(line);
      }
      rows.write("sensitivities", shown);
      // Five starts scatter by 22 % in all but ln d_e, so that one set alone may be off by twice that.
      const Eigen::ArrayXd mean = all.log().rowwise().mean().exp();
      for (std::size_t k = 0; k < expected.size(); ++k) {
        rows.compare(
            fmt::format("standard deviation of {}, geometric mean over sets of five starts [-]", expected[k].name),
            {.expected = expected[k].value,
             .computed = mean[static_cast<Eigen::Index>(k)],
             .tolerance = relative(0.3),
             .because = "sets of starts scatter by 22 %, and what is expected is one of them"});
      }
    }};

}  // namespace verification::identification_sensitivities
