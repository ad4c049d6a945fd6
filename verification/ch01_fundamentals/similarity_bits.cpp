// Scenes with equal groups move alike: to the last bit where every scale is a power of two.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::similarity_bits {

using namespace particulate;

struct Difference {
  long differing = 0;      // components that are not the scaled ones to the last bit
  double deviation = 0.0;  // largest difference over the largest component
};

laws::NearField near_field(const kinematics::CentralForce& law) {
  return {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2};
}

template <class S>
schemes::State moved(const kinematics::Particles& start, const kinematics::CentralForce& law, double t_end) {
  NearFieldScene scene(start, {}, near_field(law));
  schemes::State state = scenes::start(scene);
  advance<S>(scene, state, t_end, 128);
  return state;
}

void look(Difference& seen, const Eigen::VectorXd& expected, const Eigen::VectorXd& computed) {
  seen.differing += (expected.array() != computed.array()).count();
  seen.deviation =
      std::max(seen.deviation, (expected - computed).lpNorm<Eigen::Infinity>() / expected.lpNorm<Eigen::Infinity>());
}

// The start is scaled before the run, the result of the plain start after it.
template <class S>
Difference compare(const kinematics::Particles& start, const kinematics::CentralForce& law,
                   const kinematics::CentralForce& scaled_law, const kinematics::Scales& scales, double t_end) {
  const schemes::State plain = moved<S>(start, law, t_end);
  const schemes::State other = moved<S>(kinematics::scaled(start, scales), scaled_law, t_end * scales.time);
  Difference seen;
  look(seen, scales.length * plain.r, other.r);
  look(seen, (scales.length / scales.time) * plain.v, other.v);
  return seen;
}

const Case similarity_bits{
    {.name = "similarity_bits",
     .claim = "scenes with equal groups have the same dimensionless motion, to the last bit under powers of two",
     .equation = "D 1.4.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      const kinematics::Particles start = random_cloud({.N = 20}, rows.case_seed());
      const kinematics::Scales scales[] = {{.length = 4.0, .time = 0.5, .mass = 8.0},
                                           {.length = 1.0 / 1024.0, .time = 16.0, .mass = 0.125},
                                           {.length = 1.0, .time = 1.0, .mass = 1048576.0}};
      const kinematics::CentralForce whole[] = {{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0},
                                                {.alpha1 = 0.1, .alpha2 = 0.05, .beta1 = 2.0, .beta2 = 3.0},
                                                {.alpha1 = 0.1, .alpha2 = 1e-5, .beta1 = 0.0, .beta2 = 13.0}};
      for (const kinematics::CentralForce& law : whole) {
        for (const kinematics::Scales& by : scales) {
          const auto with = scaled(law, by);
          const std::string where = fmt::format("beta = ({}, {}), L = {}, tau = {}, M = {}", law.beta1, law.beta2,
                                                by.length, by.time, by.mass);
          const char* const because = "scaling by powers of two commutes with every rounding";
          rows.equal("components that differ, RK4, " + where,
                     {.expected = 0,
                      .computed = compare<schemes::RungeKutta4>(start, law, with, by, 1.0).differing,
                      .because = because});
          rows.equal("components that differ, Verlet, " + where,
                     {.expected = 0,
                      .computed = compare<schemes::VelocityVerlet>(start, law, with, by, 1.0).differing,
                      .because = because});
        }
      }

      const kinematics::CentralForce real{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.3, .beta2 = 2.7};
      const kinematics::Scales odd{.length = 3.0, .time = 0.7, .mass = 1.1};
      for (const kinematics::CentralForce& law : {whole[0], real}) {
        rows.at_most(fmt::format("deviation, RK4, beta = ({}, {}), L = 3, tau = 0.7, M = 1.1", law.beta1, law.beta2),
                     {.limit = 1e-13,
                      .computed = compare<schemes::RungeKutta4>(start, law, scaled(law, odd), odd, 0.25).deviation,
                      .because = "128 steps of a smooth motion, each with some roundings of 1e-16"});
      }
      kinematics::CentralForce wrong = scaled(whole[0], scales[0]);
      wrong.alpha2 *= 1.0 + 1e-12;
      rows.at_least("components that differ if alpha2 is off by 1e-12",
                    {.limit = 60.0,
                     .computed = static_cast<double>(
                         compare<schemes::RungeKutta4>(start, whole[0], wrong, scales[0], 1.0).differing),
                     .because = "half of the 120 components: else equal bits would prove nothing"});
    }};

}  // namespace verification::similarity_bits
