// A sphere strikes a fixed wall obliquely.

#include <fmt/format.h>

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::oblique_wall {

using namespace particulate;

struct After {
  double normal, tangential;  // [m/s]
};

// The same strike told to the library in three ways; the wall lies at x = 0, the tangential direction is slanted in it.
enum class Told { impact, wall, rock };

After strike(Told how, double normal, double tangential, double e, const contact::Friction& friction) {
  const Eigen::Vector3d along = Eigen::Vector3d{0.0, 3.0, 4.0} / 5.0;
  const Encounter at{.i = {.velocity = -normal * Eigen::Vector3d::UnitX() + tangential * along, .inverse_mass = 2.0},
                     .n = -Eigen::Vector3d::UnitX(),
                     .e = e,
                     .friction = friction};
  Eigen::Vector3d v;
  if (how == Told::impact) {
    v = library_impact(at).velocity_i;
  } else if (how == Told::rock) {
    v = jump_of(contact_scene(touching_pair(at), rough(e, friction)), 1e-3).v.row(0).transpose();
  } else {
    using Room = scenes::Scene<kinematics::Space, contact::Contact<contact::ConstantRestitution, contact::Friction>>;
    kinematics::Particles one{.position = kinematics::Vectors::Zero(1, 3),
                              .velocity = at.i.velocity.transpose(),
                              .mass = Eigen::VectorXd::Constant(1, 0.5),
                              .radius = Eigen::VectorXd::Constant(1, 0.1)};
    const Room room{
        one, {{kinematics::Wall{.point = {-0.1, 0.0, 0.0}, .normal = {1.0, 0.0, 0.0}}}}, rough(e, friction)};
    v = jump_of(room, 1e-3).v.row(0).transpose();
  }
  return {.normal = v.x(), .tangential = v.dot(along)};
}

const char* name_of_way(Told how) {
  return how == Told::impact ? "contact::impact" : how == Told::wall ? "scene, wall" : "scene, immovable sphere";
}

// The angle at which sliding begins, by bisection on what the library does.
double sticking_angle(double e, double mu) {
  double low = 0.0, high = 0.5 * std::numbers::pi;
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.5 * (low + high);
    const bool sticks =
        std::abs(strike(Told::impact, std::cos(angle), std::sin(angle), e, {.mu_s = mu, .mu_d = mu}).tangential) <=
        4.0 * eps;
    (sticks ? low : high) = angle;
  }
  return low * 180.0 / std::numbers::pi;
}

// E'/E for unit speed, in extended precision.
Wide share_left(Wide degrees, Wide e, Wide mu) {
  const Wide angle = degrees * std::numbers::pi_v<Wide> / 180, slide = std::sin(angle) - mu * (1 + e) * std::cos(angle);
  return std::pow(e * std::cos(angle), 2) + (slide > 0 ? slide * slide : 0);
}

void along_the_angles(Rows& rows, Told how) {
  const double digits[][2] = {{30.0, 0.48}, {60.0, 0.33307714}, {76.0, 0.60381239}, {85.0, 0.8471349}};
  for (const auto& [degrees, expected] : digits) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const After after = strike(how, std::cos(angle), std::sin(angle), 0.8, {.mu_s = 0.5, .mu_d = 0.5});
    const double left = after.normal * after.normal + after.tangential * after.tangential;
    const std::string what = fmt::format("E'/E at {} degrees, {}", degrees, name_of_way(how));
    rows.compare(what, {.expected = expected,
                        .computed = left,
                        .tolerance = absolute(5.1e-9),
                        .because = "half of the eighth decimal, the last one printed"});
    rows.compare(what + ", extended precision", {.expected = static_cast<double>(share_left(degrees, 0.8L, 0.5L)),
                                                 .computed = left,
                                                 .tolerance = absolute(2e-15),
                                                 .because = "sine, cosine and some ten roundings of numbers up to 1"});
  }
}

const Case oblique_wall{
    {.name = "oblique_wall",
     .claim = "a sphere on a fixed wall returns e v_n, and loses mu_d (1 + e) v_n of its tangential speed or all of it",
     .equation = "M 2.46",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const Told how : {Told::impact, Told::wall, Told::rock}) {
        // It slides as 3.1947 > 0.3 * 1.98 * 2.2369; from then on mu_s no longer counts.
        const After after = strike(how, 2.2369, 3.1947, 0.98, {.mu_s = 0.3, .mu_d = 0.092});
        // 0.98 * 2.2369, and 3.1947 - 0.092 * 1.98 * 2.2369, multiplied out by hand.
        rows.compare(fmt::format("v_n after, {} [m/s]", name_of_way(how)),
                     {.expected = 2.192162,
                      .computed = after.normal,
                      .tolerance = relative(2e-15),
                      .because = "four roundings of numbers twice as large"});
        rows.compare(fmt::format("v_t after, {} [m/s]", name_of_way(how)),
                     {.expected = 2.787226296,
                      .computed = after.tangential,
                      .tolerance = relative(2e-15),
                      .because = "some eight roundings, no cancellation"});
        along_the_angles(rows, how);
      }
      const double limit = sticking_angle(0.98, 0.092);
      rows.compare("angle below which it sticks [degrees]",
                   {.expected = 10.324,
                    .computed = limit,
                    .tolerance = absolute(5.1e-4),
                    .because = "half of the third decimal, the last one printed"});
      rows.compare("angle below which it sticks, atan(mu_s (1 + e)) [degrees]",
                   {.expected = static_cast<double>(std::atan(0.092L * 1.98L) * 180 / std::numbers::pi_v<Wide>),
                    .computed = limit,
                    .tolerance = relative(3e-14),
                    .because = "within 4 eps of sliding counts as sticking: 5e-15 of this angle; the velocities' own "
                               "rounding moves it as much"});
    }};

}  // namespace verification::oblique_wall
