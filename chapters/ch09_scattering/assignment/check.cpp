#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <particulate/scattering/interface.hpp>

#include "grading.hpp"

using grading::Draw;
using grading::Line;

namespace scattering = particulate::scattering;

namespace {

constexpr double right_angle = 0.5 * std::numbers::pi, degree = std::numbers::pi / 180.0;

// From the normal, or from the surface: each is a right angle less the other.
double angle_of(int variant, double theta) { return variant == 1 ? theta : right_angle - theta; }

struct Amplitudes {
  double along, across;
};
Amplitudes amplitudes(double n, double cosine, double root) {
  return {(n * n * cosine - root) / (n * n * cosine + root), (cosine - root) / (cosine + root)};
}

// One thing that can be wrong with the reflectance.
struct Flaw {
  std::function<double(const Amplitudes&)> share = [](const Amplitudes& r) {
    return 0.5 * (r.along * r.along + r.across * r.across);
  };
  bool inverts = false, swaps = false;
  double unit = 1.0;     // times the angle
  double squared = 2.0;  // the power of n^ under the root
  double beyond = 1.0;   // the share under total reflection
  bool turns = false;    // what is negative under the root turned round there
};

double with_flaw(const Flaw& flaw, int variant, double n, double angle) {
  const double given = flaw.unit * angle;
  const bool from_normal = (variant == 1) != flaw.swaps;
  const double cosine = from_normal ? std::cos(given) : std::sin(given);
  const double sine = from_normal ? std::sin(given) : std::cos(given);
  const double n_hat = flaw.inverts ? 1.0 / n : n, square = std::pow(n_hat, flaw.squared) - sine * sine;
  if (square < 0.0 && !flaw.turns) return flaw.beyond;
  return flaw.share(amplitudes(n_hat, cosine, std::sqrt(std::abs(square))));
}

std::vector<grading::Mistake> mistakes_in_reflectance(int variant, double n, double angle) {
  static const std::string degrees = "the angle is in radians, as those of std::cos() are";
  static const std::string before = "you took the mean of the amplitudes: square each of them first";
  static const std::string total = "total reflection is missing: where sin theta > n^, R is 1";
  const std::vector<std::pair<Flaw, std::string>> flaws{
      {{.inverts = true}, "n^ is inverted: the index behind the interface over that before it"},
      {{.swaps = true}, "sine and cosine are exchanged: from where does your variant count the angle?"},
      {{.unit = degree}, degrees},
      {{.unit = 1.0 / degree}, degrees},
      {{.squared = 1.0}, "under the root stands the square of n^"},
      {{.share = [](const Amplitudes& r) { return r.along * r.along; }},
       "this is the share of one polarization, that in the plane of incidence: half of the light has it"},
      {{.share = [](const Amplitudes& r) { return r.across * r.across; }},
       "this is the share of one polarization, that across the plane of incidence: half of the light has it"},
      {{.share = [](const Amplitudes& r) { return r.along * r.along + r.across * r.across; }},
       "you took the sum of both polarizations: each has half of the light"},
      {{.share = [](const Amplitudes& r) { return 0.25 * (r.along + r.across) * (r.along + r.across); }}, before},
      {{.share = [](const Amplitudes& r) { return 0.25 * (r.along - r.across) * (r.along - r.across); }}, before},
      {{.share = [](const Amplitudes& r) { return 0.5 * (std::abs(r.along) + std::abs(r.across)); }},
       "the share of the power is the square of an amplitude"},
      {{.share = [](const Amplitudes& r) { return 1.0 - 0.5 * (r.along * r.along + r.across * r.across); }},
       "this is what passes through the interface: R is what comes back"},
      {{.beyond = std::numeric_limits<double>::quiet_NaN()}, total},
      {{.turns = true}, total}};
  return grading::mistakes(
      flaws, [&](const Flaw& flaw) -> std::vector<double> { return {with_flaw(flaw, variant, n, angle)}; });
}

void ask_reflectance(Line& line, int variant, double n, double theta) {
  const double angle = angle_of(variant, theta);
  line.questions.push_back({.function = "reflectance",
                            .inputs = {n, angle},
                            .expected = {scattering::reflectance(scattering::Fresnel{n}, std::cos(theta))},
                            .mistakes = mistakes_in_reflectance(variant, n, angle)});
}

// Into what is denser, and into what is thinner, where all passes that comes at a small angle.
Line reflectance_line(int variant, Draw& draw) {
  Line line{.name = "reflectance: into denser and thinner media", .points = 4.0};
  for (const double n : {draw.between(1.2, 3.0), draw.between(3.0, 12.0), draw.between(0.5, 0.9)}) {
    const double most = n < 1.0 ? scattering::critical_angle(n) : right_angle;
    ask_reflectance(line, variant, n, most * draw.between(0.5, 0.8));
  }
  return line;
}

// Three known values, and what no cosine beyond the critical angle can give.
Line total_line(int variant, Draw& draw) {
  Line line{.name = "reflectance: known values, total reflection", .points = 4.0};
  for (const auto& [theta, R] :
       {std::pair{30.0, 0.041522625975822}, std::pair{60.0, 0.089186712802213}, std::pair{85.0, 0.61279964526483}}) {
    ask_reflectance(line, variant, 1.5, theta * degree);
    line.questions.back().expected = {R};
  }
  for (int k = 0; k < 2; ++k) {
    const double n = draw.between(0.3, 0.9), critical = scattering::critical_angle(n);
    ask_reflectance(line, variant, n, critical + (right_angle - critical) * draw.between(0.2, 0.8));
  }
  return line;
}

// A ray that comes to a sphere, at cos theta from the normal, and the share a + b angle that is reflected.
struct Arrival {
  Eigen::Vector3d direction, normal, centre;
  double radius, power, a, b, cosine;

  std::vector<double> inputs() const {
    const Eigen::Vector3d place = centre + radius * normal;
    return {direction[0], direction[1], direction[2], place[0], place[1], place[2], centre[0],
            centre[1],    centre[2],    radius,       power,    a,        b};
  }
};

Arrival drawn(Draw& draw) {
  const auto vector = [&] {
    const double x = draw.between(-1.0, 1.0), y = draw.between(-1.0, 1.0), z = draw.between(0.3, 1.0);
    return Eigen::Vector3d(x, y, z);
  };
  Arrival x{.direction = vector().normalized(),
            .normal = -vector().normalized(),
            .centre = vector(),
            .radius = draw.between(0.2, 0.8),
            .power = draw.between(1.0, 9.0),
            .a = draw.between(0.1, 0.3),
            .b = draw.between(0.2, 0.4),
            .cosine = 0.0};
  if (x.direction.dot(x.normal) > 0.0) x.normal = -x.normal;
  x.cosine = -x.direction.dot(x.normal);
  return x;
}

std::vector<double> numbers(const Eigen::Vector3d& x) { return {x[0], x[1], x[2]}; }

Line direction_line(int, Draw& draw) {
  Line line{.name = "bounce: the direction of a mirror", .points = 4.0, .absolute = 1e-12};
  for (int k = 0; k < 3; ++k) {
    const Arrival x = drawn(draw);
    const Eigen::Vector3d into = -x.cosine * x.normal, d = x.direction, spoke = x.radius * x.normal;
    const std::vector<std::pair<Eigen::Vector3d, std::string>> mistakes{
        {d - into, "this slides along the surface: twice the normal part is taken off, d - 2 (d.n) n"},
        {d + 2.0 * into, "the sign: what points into the sphere is turned round, d - 2 (d.n) n"},
        {d + into, "the sign and the factor: d - 2 (d.n) n"},
        {2.0 * into - d, "this is minus the direction: it points into the sphere"},
        {-d, "the ray goes back where it came from: only its normal part is turned round"},
        {d, "the ray goes on as if there were no sphere"},
        {x.normal, "this is the normal: is it not the direction that is asked for?"},
        {d - 2.0 * d.dot(spoke) * spoke, "your normal is no unit vector: divide the radius vector by its length"},
        {d - 2.0 * d.dot(spoke) * x.normal, "one of the two normals is no unit vector"}};
    line.questions.push_back(
        {.function = "direction_after", .inputs = x.inputs(), .expected = numbers(d - 2.0 * into)});
    for (const auto& [gives, hint] : mistakes) line.questions.back().mistakes.push_back({numbers(gives), hint});
  }
  return line;
}

Line power_line(int variant, Draw& draw) {
  Line line{.name = "bounce: the power that is kept", .points = 4.0};
  for (int k = 0; k < 3; ++k) {
    const Arrival x = drawn(draw);
    const auto share = [&](double angle) { return x.a + x.b * angle; };
    const double theta = std::acos(x.cosine), angle = angle_of(variant, theta), R = share(angle);
    line.questions.push_back(
        {.function = "power_after",
         .inputs = x.inputs(),
         .expected = {R * x.power},
         .mistakes = {{{(1.0 - R) * x.power}, "this is what the sphere absorbs: the ray keeps what is reflected"},
                      {{x.power}, "nothing is absorbed: the ray keeps the share R of its power"},
                      {{R}, "this is the share, not the power: R times what the ray carried"},
                      {{share(right_angle - angle) * x.power},
                       "the other angle: from where does your variant count it, and is it a sine or a cosine?"},
                      {{share(std::numbers::pi - theta) * x.power}, "the angle is obtuse: the ray comes against n"},
                      {{share(right_angle - (std::numbers::pi - theta)) * x.power},
                       "the angle is negative: the ray comes against the normal, d.n < 0"},
                      {{share(x.cosine) * x.power}, "share() is asked for an angle, not for its cosine"},
                      {{share(angle / degree) * x.power}, "share() is asked for an angle in radians"},
                      {{R * R * x.power}, "R is a share of the power: it is not squared once more"},
                      {{std::sqrt(R) * x.power}, "R is a share of the power, not of an amplitude"}}});
  }
  return line;
}

// F and I_x/I of a sphere, in closed form; both functions are asked together.
Line sphere_line(int, Draw&) {
  struct Known {
    double n_hat, F, x;
  };
  Line line{.name = "both: a sphere in a beam, n^ = 1.5, 2, 4, 10", .points = 4.0, .relative = 1e-10};
  for (const auto& [n_hat, F, x] :
       {Known{1.5, 0.091777959342351, 0.0393268730564126}, Known{2.0, 0.160596637069606, 0.0367182622878926},
        Known{4.0, 0.366638056497679, 0.00684355927494563}, Known{10.0, 0.640174994374749, -0.0198041189561911}}) {
    line.questions.push_back({.function = "sphere",
                              .inputs = {n_hat},
                              .expected = {F, x},
                              .mistakes = {{{1.0 - F, F}, "the sphere's share and the ray's are exchanged"},
                                           {{F, -x}, "the reflected rays go the wrong way along x"}},
                              .otherwise = "a beam along x: F is the sum of the powers that your bounce() leaves with "
                                           "your reflectance(), I_x that of power times d_x: see the lines before"});
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  return grading::run(
      argc, argv,
      {.title = "Chapter 9: one bounce of a ray of light",
       .variants = {"the angle of a ray is counted from the normal", "the angle of a ray is counted from the surface"},
       .lines = {reflectance_line, total_line, direction_line, power_line, sphere_line},
       .calls = {{"reflectance", "n_hat angle -> R"},
                 {"direction_after", "d[3] place[3] centre[3] radius power a b -> d'[3]"},
                 {"power_after", "d[3] place[3] centre[3] radius power a b -> power'"},
                 {"sphere", "n_hat -> F I_x"}}});
}
