// Long-range instabilities: a chain and a lattice of particles that attract and repel, with and without truncation.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/linear_algebra.hpp>
#include <harness/motions.hpp>
#include <particulate/kinematics/central_force.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>

namespace verification::lattice {

using namespace particulate;

// d_e = 0.5, which is the spacing, and d* = 1.
constexpr double spacing = 0.5;
const kinematics::CentralForce pair_of_unit_masses{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0};

// How many spacings two particles of a ring are apart, the shorter way.
Eigen::Index steps_between(Eigen::Index i, Eigen::Index j, Eigen::Index N) {
  const Eigen::Index k = std::abs(i - j);
  return std::min(k, N - k);
}

// The stiffness of a ring whose pairs up to so many spacings act, from the law's stiffness along the line of centres.
Eigen::VectorXd ring_modes(Eigen::Index N, Eigen::Index most) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(N, N);
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index j = 0; j < N; ++j) {
      const Eigen::Index k = steps_between(i, j, N);
      if (k == 0 || k > most) continue;
      const double stiffness = normal_stiffness(pair_of_unit_masses, static_cast<double>(k) * spacing);
      K(i, j) -= stiffness;
      K(i, i) += stiffness;
    }
  }
  return symmetric_modes(K).values;
}

// The same from the forces of a scene, by differences of fourth order.
Eigen::VectorXd ring_modes_of_scene(Eigen::Index N, double cutoff, double taper) {
  kinematics::Particles ring{.position = kinematics::Vectors::Zero(N, 3),
                             .velocity = kinematics::Vectors::Zero(N, 3),
                             .mass = Eigen::VectorXd::Ones(N),
                             .radius = Eigen::VectorXd::Zero(N)};
  ring.position.col(0) = Eigen::VectorXd::LinSpaced(N, 0.0, static_cast<double>(N - 1) * spacing);
  kinematics::Space space;
  space.lengths[0] = static_cast<double>(N) * spacing;
  const scenes::Scene scene(ring, space,
                            laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25, .cutoff = cutoff, .taper = taper});
  const double h = 1e-4;
  Eigen::MatrixXd K(N, N);
  Eigen::VectorXd force(3 * N);
  for (Eigen::Index j = 0; j < N; ++j) {
    const auto moved = [&](double by) -> Eigen::VectorXd {
      schemes::State state = scenes::start(scene);
      state.r[j] += by;
      if (!scene.total_force(state, force)) force.setConstant(missing);
      return force.head(N);
    };
    K.col(j) = -(8.0 * (moved(h) - moved(-h)) - (moved(2.0 * h) - moved(-2.0 * h))) / (12.0 * h);
  }
  return symmetric_modes(0.5 * (K + K.transpose())).values;
}

// sum V''(k a) (2 - 2 cos q k) at all q of the ring, rising.
Eigen::VectorXd dispersion(Eigen::Index N, Eigen::Index most) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(N);
  for (Eigen::Index n = 0; n < N; ++n) {
    for (Eigen::Index k = 1; k <= most; ++k) {
      const double d = static_cast<double>(k) * spacing, stiffness = -0.5 / (d * d) + 0.5 / (d * d * d);
      const double q = 2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(N);
      values[n] += stiffness * (2.0 - 2.0 * std::cos(q * static_cast<double>(k)));
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

const Case chain{
    {.name = "chain_modes",
     .claim =
         "a chain of pairs at rest is unstable if all of them act, the more the longer it is, and stable once those "
         "beyond the inflection do not",
     .equation = "D 7.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      struct Known {
        Eigen::Index N;
        double all, cut;  // smallest eigenvalue; smallest but for the translation
      };
      const auto row = [&](const std::string& what, double expected, double computed, double off, const char* because) {
        rows.compare(what,
                     {.expected = expected, .computed = computed, .tolerance = absolute(off), .because = because});
      };
      row("inflection [m]", 1.0, kinematics::inflection_distance(pair_of_unit_masses), 1e-15, "twice d_e");
      const char *printed = "printed to four digits", *differences = "differences of forces near 100, over 1e-4 m";
      for (const auto& [N, all, cut] : {Known{16, -0.3302, 0.3045}, {32, -0.5848, 0.0769}, {64, -0.6956, 0.0193}}) {
        const std::string of = fmt::format(", {} particles [N/m]", N);
        row("smallest, all pairs" + of, all, ring_modes(N, N / 2)[0], 5e-5, printed);
        const Eigen::VectorXd held = ring_modes(N, 2);
        row("translation, cut" + of, 0.0, held[0], 1e-13, "rounding of numbers up to 8");
        row("next, cut" + of, cut, held[1], 5e-5, printed);
        // In Space a pair meets in its nearest image alone, so that of the two opposite ones there is none.
        const Eigen::VectorXd far = ring_modes_of_scene(N, (0.5 * static_cast<double>(N) - 0.1) * spacing, 0.0);
        const Eigen::VectorXd near = ring_modes_of_scene(N, 0.95, 0.25);
        row("farthest mode from the dispersion, forces of a scene, all pairs" + of, 0.0,
            (far - dispersion(N, N / 2 - 1)).lpNorm<Eigen::Infinity>(), 1e-8, differences);
        row("farthest mode from the dispersion, forces of a scene, cut off" + of, 0.0,
            (near - dispersion(N, 1)).lpNorm<Eigen::Infinity>(), 1e-8, differences);
      }
    }};

// The response of a cubic lattice to a wave: the stiffness seen by the three directions in which it can move.
struct Wave {
  std::array<int, 3> number;  // of waves along each edge
  double radius;              // pairs up to it act [m]
};

// From the forces on the particle at the origin when all are moved along the wave.
Eigen::Matrix3d stiffness_of_scene(const Wave& wave, int n) {
  std::vector<kinematics::Particle> sites;
  for (int k = 0; k < n * n * n; ++k) {
    sites.push_back({.position = spacing * Eigen::Vector3d(k % n, k / n % n, k / n / n), .mass = 1.0, .radius = 0.0});
  }
  const kinematics::Space space{.lengths = Eigen::Vector3d::Constant(n * spacing)};
  const scenes::Scene scene(kinematics::particles(sites), space,
                            laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25, .cutoff = wave.radius});
  const Eigen::Vector3d q =
      2.0 * std::numbers::pi / (n * spacing) * Eigen::Vector3d(wave.number[0], wave.number[1], wave.number[2]);
  const Eigen::Index N = n * n * n;
  Eigen::VectorXd force(3 * N);
  Eigen::Matrix3d D;
  const double h = 1e-4;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto response = [&](double by) -> Eigen::Vector3d {
      schemes::State state = scenes::start(scene);
      for (Eigen::Index i = 0; i < N; ++i) {
        state.r[axis * N + i] += by * std::cos(q.dot(sites[static_cast<std::size_t>(i)].position));
      }
      if (!scene.total_force(state, force)) force.setConstant(missing);
      return rows_of(force).row(0);
    };
    D.col(axis) = -(8.0 * (response(h) - response(-h)) - (response(2.0 * h) - response(-2.0 * h))) / (12.0 * h);
  }
  return D;
}

// Attracting pairs hold each other across the line of centres, V'/d > 0. The repulsion of beta2 = 2 has no Laplacian
// there, and the attraction's, alpha1 (2 - beta1) d^(-beta1 - 1), is positive: so is the sum of the three stiffnesses.
const Case cubic{
    {.name = "lattice_modes",
     .claim =
         "in space the transverse stiffness of attracting pairs opposes the instability: what the three stiffnesses "
         "of a lattice add up to is positive for every wave, whether far pairs act or not",
     .equation = "D 7.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      report::Table shown({"waves along x, y, z", "pairs act up to [m]", "stiffness 1 [N/m]", "stiffness 2 [N/m]",
                           "stiffness 3 [N/m]", "their sum [N/m]"});
      constexpr int n = 8;
      double least = std::numeric_limits<double>::infinity(), sum_off = 0.0;
      for (const double radius : {0.95, 1.95}) {
        for (const auto& number : {std::array{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {4, 0, 0}, {2, 1, 0}, {4, 4, 4}}) {
          const Wave wave{number, radius};
          const Eigen::Matrix3d D = stiffness_of_scene(wave, n);
          const Eigen::VectorXd values = symmetric_modes(0.5 * (D + D.transpose())).values;
          least = std::min(least, values.sum());
          double laplacian = 0.0;
          for (int k = 1; k < n * n * n; ++k) {
            const auto centred = [](int x) { return x > n / 2 ? x - n : x; };
            const Eigen::Vector3d R(centred(k % n), centred(k / n % n), centred(k / n / n));
            const double d = spacing * R.norm();
            if (d >= radius) continue;
            const double phase = 2.0 * std::numbers::pi / n * R.dot(Eigen::Vector3d(number[0], number[1], number[2]));
            laplacian += (1.0 - std::cos(phase)) * 0.5 / (d * d);
          }
          sum_off = report::worse_of(sum_off, std::abs(values.sum() / laplacian - 1.0));
          shown.add({fmt::format("{} {} {}", number[0], number[1], number[2]), radius, values[0], values[1], values[2],
                     values.sum()});
        }
      }
      rows.at_most("largest relative distance of a sum from the attraction's Laplacian",
                   {.limit = 1e-7, .computed = sum_off, .because = "the repulsion has none"});
      rows.at_least("least sum of three stiffnesses [N/m]",
                    {.limit = 1e-3, .computed = least, .because = "every term of the Laplacian is positive"});
      rows.write("lattice_modes", shown);
    }};

}  // namespace verification::lattice
