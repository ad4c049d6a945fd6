// Kinetic energy per unit mass is that of the centre of mass and that about it.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/energy.hpp>

namespace verification::kinetic_energy_split {

using namespace particulate;

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

}  // namespace verification::kinetic_energy_split
