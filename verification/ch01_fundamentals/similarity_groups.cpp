// The dimensionless groups of a scene, by hand, and that scaling keeps them.

#include <string>

#include <harness/case.hpp>
#include <particulate/kinematics/similarity.hpp>

namespace verification::similarity_groups {

using namespace particulate;

const kinematics::Dimensional scene{.law = {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.5},
                                    .mass = 2.0,
                                    .speed = 1.5,
                                    .radius = 0.2,
                                    .step = 0.06};

void compare(Rows& rows, const std::string& which, const kinematics::SimilarityGroups& computed, double tolerance,
             const std::string& because) {
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

const Case similarity_groups{
    {.name = "similarity_groups",
     .claim = "five numbers make a scene dimensionless, and scaling keeps them",
     .equation = "D 1.4.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Scales units{.length = 4.0, .time = 3.0, .mass = 1.0};
      compare(rows, " [-]", kinematics::similarity_groups(scene, units), 1e-15, "five roundings and a power");

      const kinematics::Scales by{.length = 0.3, .time = 7.0, .mass = 1.7};
      const kinematics::Dimensional other{.law = scaled(scene.law, by),
                                          .mass = 1.7 * scene.mass,
                                          .speed = 0.3 / 7.0 * scene.speed,
                                          .radius = 0.3 * scene.radius,
                                          .step = 7.0 * scene.step};
      compare(rows, " of the scene scaled by L = 0.3, tau = 7, M = 1.7 [-]",
              kinematics::similarity_groups(other, {.length = 1.2, .time = 21.0, .mass = 1.0}), 4e-15,
              "0.3 has no exact double, and its power 3.5 carries that rounding; some ten roundings more");
    }};

}  // namespace verification::similarity_groups
