// Dimensionless groups, and motions that share them.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::similarity {

using namespace particulate;

// The dimensionless groups of a scene, by hand, and that scaling keeps them.

const kinematics::Dimensional dimensional_scene{.law = {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.5},
                                                .mass = 2.0,
                                                .speed = 1.5,
                                                .radius = 0.2,
                                                .step = 0.06};

void compare_groups(Rows& rows, const std::string& which, const kinematics::SimilarityGroups& computed,
                    double tolerance, const std::string& because) {
  // L = 4, tau = 3: pi_1 = 0.5 * 2 * 9 / 4^2, pi_2 = 0.25 * 2 * 9 / 4^3.5, 1.5 * 3/4, 0.2/4, 0.06/3.
  const struct {
    const char* name;
    double expected, got;
  } groups[] = {{"pi_1", 0.5625, computed.attraction},
                {"pi_2", 0.03515625, computed.repulsion},
                {"v tau/L", 1.125, computed.speed},
                {"b/L", 0.05, computed.radius},
                {"Dt/tau", 0.02, computed.step}};
  for (const auto& group : groups) {
    rows.compare(
        std::string(group.name) + which,
        {.expected = group.expected, .computed = group.got, .tolerance = relative(tolerance), .because = because});
  }
}

void prove_similarity_groups(Rows& rows) {
  const kinematics::Scales units{.length = 4.0, .time = 3.0, .mass = 1.0};
  compare_groups(rows, " [-]", kinematics::similarity_groups(dimensional_scene, units), 1e-15,
                 "five roundings and a power");

  const kinematics::Scales by{.length = 0.3, .time = 7.0, .mass = 1.7};
  const kinematics::Dimensional other{.law = scaled(dimensional_scene.law, by),
                                      .mass = 1.7 * dimensional_scene.mass,
                                      .speed = 0.3 / 7.0 * dimensional_scene.speed,
                                      .radius = 0.3 * dimensional_scene.radius,
                                      .step = 7.0 * dimensional_scene.step};
  compare_groups(rows, " of the scene scaled by L = 0.3, tau = 7, M = 1.7 [-]",
                 kinematics::similarity_groups(other, {.length = 1.2, .time = 21.0, .mass = 1.0}), 4e-15,
                 "0.3 has no exact double, and its power 3.5 carries that rounding; some ten roundings more");
}

const Case similarity_groups{{.name = "similarity_groups",
                              .claim = "five numbers make a scene dimensionless, and scaling keeps them",
                              .equation = "D 1.4.3",
                              .reference = Reference::closed_form},
                             prove_similarity_groups};

// Scenes with equal groups move alike: to the last bit where every scale is a power of two.

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
Difference compare_motions(const kinematics::Particles& start, const kinematics::CentralForce& law,
                           const kinematics::CentralForce& scaled_law, const kinematics::Scales& scales, double t_end) {
  const schemes::State plain = moved<S>(start, law, t_end);
  const schemes::State other = moved<S>(kinematics::scaled(start, scales), scaled_law, t_end * scales.time);
  Difference seen;
  look(seen, scales.length * plain.r, other.r);
  look(seen, (scales.length / scales.time) * plain.v, other.v);
  return seen;
}

void prove_similarity_bits(Rows& rows) {
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
      const std::string where =
          fmt::format("beta = ({}, {}), L = {}, tau = {}, M = {}", law.beta1, law.beta2, by.length, by.time, by.mass);
      const char* const because = "scaling by powers of two commutes with every rounding";
      rows.none("components that differ, RK4, " + where,
                compare_motions<schemes::RungeKutta4>(start, law, with, by, 1.0).differing, because);
      rows.none("components that differ, Verlet, " + where,
                compare_motions<schemes::VelocityVerlet>(start, law, with, by, 1.0).differing, because);
    }
  }

  const kinematics::CentralForce real{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.3, .beta2 = 2.7};
  const kinematics::Scales odd{.length = 3.0, .time = 0.7, .mass = 1.1};
  for (const kinematics::CentralForce& law : {whole[0], real}) {
    rows.at_most(fmt::format("deviation, RK4, beta = ({}, {}), L = 3, tau = 0.7, M = 1.1", law.beta1, law.beta2),
                 {.limit = 1e-13,
                  .computed = compare_motions<schemes::RungeKutta4>(start, law, scaled(law, odd), odd, 0.25).deviation,
                  .because = "128 steps of a smooth motion, each with some roundings of 1e-16"});
  }
  kinematics::CentralForce wrong = scaled(whole[0], scales[0]);
  wrong.alpha2 *= 1.0 + 1e-12;
  rows.at_least("components that differ if alpha2 is off by 1e-12",
                {.limit = 60.0,
                 .computed = static_cast<double>(
                     compare_motions<schemes::RungeKutta4>(start, whole[0], wrong, scales[0], 1.0).differing),
                 .because = "half of the 120 components: else equal bits would prove nothing"});
}

const Case similarity_bits{
    {.name = "similarity_bits",
     .claim = "scenes with equal groups have the same dimensionless motion, to the last bit under powers of two",
     .equation = "D 1.4.3",
     .reference = Reference::identity},
    prove_similarity_bits};

}  // namespace verification::similarity
