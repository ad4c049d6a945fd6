// Near-field strengths counted per surface area instead of mass.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::surface_area {

using namespace particulate;
using laws::NearField, laws::Scaling;

using Cloud =
    scenes::Scene<kinematics::Space, NearField, contact::Contact<contact::ConstantRestitution, contact::Friction>>;

// Force on the first of two spheres at a distance d along x, by (2.3) with alpha (4 pi b_i^2)(4 pi b_j^2).
Wide book_force(const NearField& law, Wide b_i, Wide b_j, Wide d) {
  const Wide areas = 16 * std::numbers::pi_v<Wide> * std::numbers::pi_v<Wide> * b_i * b_i * b_j * b_j;
  return areas * (law.alpha1 * std::pow(d, -static_cast<Wide>(law.beta1)) -
                  law.alpha2 * std::pow(d, -static_cast<Wide>(law.beta2)));
}

double library_force(const NearField& law, double b_i, double b_j, double d, double mass) {
  kinematics::Particles pair{.position = kinematics::Vectors::Zero(2, 3),
                             .velocity = kinematics::Vectors::Zero(2, 3),
                             .mass = Eigen::Vector2d{mass, 2.0 * mass},
                             .radius = Eigen::Vector2d{b_i, b_j}};
  pair.position(1, 0) = d;
  const scenes::Scene<kinematics::Space, NearField> scene{pair, {}, law};
  Eigen::VectorXd f(6);
  if (!scene.total_force(scenes::start(scene), f)) throw std::runtime_error("the pair has no forces");
  return f[0];
}

schemes::State end_of(const kinematics::Particles& start, const NearField& law, long steps) {
  Cloud cloud{start, {}, law, rough(0.5, {.mu_s = 0.2, .mu_d = 0.1})};
  schemes::State state = scenes::start(cloud);
  if (march<schemes::VelocityVerlet>(cloud, state, 0.8, steps).impacts < 4)
    throw std::runtime_error("hardly any impacts");
  return state;
}

const Case surface_area{
    {.name = "surface_area",
     .claim = "strengths per area act like strengths per mass where masses are proportional to areas, and as b_i^2 "
              "b_j^2 everywhere",
     .equation = "M 2.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      const NearField law{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 1.5, .beta2 = 2.5, .scaling = Scaling::area};
      for (const auto& [b_i, b_j] : {std::pair{0.2, 0.2}, std::pair{0.2, 0.4}, std::pair{1e-3, 5.0}}) {
        for (const double mass : {1.0, 1e-6}) {
          rows.compare(fmt::format("force of radii {} and {}, masses {} and twice that [N]", b_i, b_j, mass),
                       {.expected = static_cast<double>(book_force(law, b_i, b_j, 0.8L)),
                        .computed = library_force(law, b_i, b_j, 0.8, mass),
                        .tolerance = relative(8e-15),
                        .because = "two powers, their difference a third of them, four products for the areas"});
        }
      }
      rows.compare("force of doubled radii over that of single ones",
                   {.expected = 16.0,
                    .computed = library_force(law, 0.4, 0.6, 0.8, 1.0) / library_force(law, 0.2, 0.3, 0.8, 1.0),
                    .tolerance = relative(1e-15),
                    .because = "powers of two: no rounding but the quotient's"});

      kinematics::Particles start = closing_cloud(rows.case_seed(), 8, 1.0);
      const double per_area = 3.7;
      start.mass = per_area * 4.0 * std::numbers::pi * start.radius.cwiseAbs2();
      NearField by_mass = law;
      by_mass.scaling = Scaling::mass, by_mass.alpha1 /= per_area * per_area, by_mass.alpha2 /= per_area * per_area;
      const long steps = rows.quick() ? 400 : 4000;
      const schemes::State area = end_of(start, law, steps), mass = end_of(start, by_mass, steps);
      rows.at_most(
          "colliding cloud: positions by area and by mass, largest difference [m]",
          {.limit = 1e-11,
           .computed = (area.r - mass.r).cwiseAbs().maxCoeff(),
           .because =
               "strengths differ by 4 eps; roundings of the steps and impacts after them grow some thousandfold"});
      rows.at_least("colliding cloud: difference if areas were counted as masses [m]",
                    {.limit = 1e-3,
                     .computed =
                         [&] {
                           NearField as_mass = law;
                           as_mass.scaling = Scaling::mass;
                           return (area.r - end_of(start, as_mass, steps).r).cwiseAbs().maxCoeff();
                         }(),
                     .because = "else the near field would hardly act here"});
    }};

}  // namespace verification::surface_area
