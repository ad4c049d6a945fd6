// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions. But where a mistake says otherwise, it is one of variant 1.

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using Eigen::Vector3d;
using right::Amplitudes;

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  double (*reflectance)(double, double) = right::from_normal;
  Ray (*bounce)(const Ray&, const Sphere&, const Share&) = right::bounce;
};

// Another share of two amplitudes.
template <auto share>
double shares(double n, double angle) {
  return right::share_of<share>(n, std::cos(angle), std::sin(angle));
}

// Another angle for the same formula.
template <auto change>
double at(double n, double angle) {
  return right::from_normal(n, change(angle));
}

// Without a question whether all is reflected: what stands under the root goes through `changed`.
template <auto changed>
double unasked(double n, double angle) {
  const double sine = std::sin(angle), root = std::sqrt(changed(n * n - sine * sine));
  return right::mean_of_squares(right::amplitudes(n, std::cos(angle), root));
}

// The right power in another direction: of d and n, which is a unit vector.
template <auto direction>
Ray turned(const Ray& ray, const Sphere& sphere, const Share& share) {
  Ray out = right::bounce(ray, sphere, share);
  out.direction = direction(ray.direction, right::normal(ray, sphere));
  return out;
}

// The right direction with another power: of the share at an angle, the angle and the power.
template <auto power>
Ray keeps(const Ray& ray, const Sphere& sphere, const Share& share) {
  Ray out = right::bounce(ray, sphere, share);
  out.power = power(share, right::incidence(ray, sphere), ray.power);
  return out;
}

const std::vector<Mistake<Functions>> mistakes{
    // None.
    // graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20
    {"none"},

    // None, variant 2.
    // graded: --variant 2 --student anna|bob@school.edu|1234567 -> 20
    {"none_second", &Functions::reflectance, right::from_surface, &Functions::bounce, right::bounce_from_surface},

    // One polarization alone.
    // graded: --variant 1 --student anna|bob@school.edu -> 8
    // hint: one polarization, that in the plane of incidence
    {"in_plane", &Functions::reflectance, shares<[](const Amplitudes& r) { return r.along * r.along; }>},

    // And the other one.
    // graded: --variant 1 --student anna -> 8
    // hint: one polarization, that across the plane of incidence
    {"across_plane", &Functions::reflectance, shares<[](const Amplitudes& r) { return r.across * r.across; }>},

    // Both in full.
    // graded: --variant 1 --student anna -> 8
    // hint: you took the sum of both polarizations
    {"sum", &Functions::reflectance,
     shares<[](const Amplitudes& r) { return r.along * r.along + r.across * r.across; }>},

    // The mean squared.
    // graded: --variant 1 --student anna -> 8
    // hint: the mean of the amplitudes: square each of them first
    {"mean_first", &Functions::reflectance,
     shares<[](const Amplitudes& r) { return 0.25 * (r.along + r.across) * (r.along + r.across); }>},

    // The same with the other sign of one amplitude, which books differ in.
    // graded: --variant 1 --student anna -> 8
    // hint: the mean of the amplitudes: square each of them first
    {"mean_first_other_sign", &Functions::reflectance,
     shares<[](const Amplitudes& r) { return 0.25 * (r.along - r.across) * (r.along - r.across); }>},

    // Amplitudes for shares.
    // graded: --variant 1 --student anna -> 8
    // hint: the square of an amplitude
    {"not_squared", &Functions::reflectance,
     shares<[](const Amplitudes& r) { return 0.5 * (std::abs(r.along) + std::abs(r.across)); }>},

    // What passes.
    // graded: --variant 1 --student anna -> 8
    // hint: R is what comes back
    {"transmitted", &Functions::reflectance,
     shares<[](const Amplitudes& r) { return 1.0 - right::mean_of_squares(r); }>},

    // The index before the interface over that behind it.
    // graded: --variant 1 --student anna|bob@school.edu -> 8
    // hint: n^ is inverted
    {"inverted", &Functions::reflectance, [](double n, double angle) { return right::from_normal(1.0 / n, angle); }},

    // Not squared under the root.
    // graded: --variant 1 --student anna -> 8
    // hint: under the root stands the square of n^
    {"n_not_squared", &Functions::reflectance,
     [](double n, double angle) {
       const double sine = std::sin(angle), square = n - sine * sine;
       return square < 0.0 ? 1.0 : right::mean_of_squares(right::amplitudes(n, std::cos(angle), std::sqrt(square)));
     }},

    // Sine for cosine.
    // graded: --variant 1 --student anna|bob@school.edu -> 8
    // hint: sine and cosine are exchanged
    {"sine", &Functions::reflectance, right::from_surface},

    // And the other way round.
    // graded: --variant 2 --student anna|bob@school.edu -> 8
    // hint: sine and cosine are exchanged
    {"cosine", &Functions::reflectance, right::from_normal, &Functions::bounce, right::bounce_from_surface},

    // As if it got degrees.
    // graded: --variant 1 --student anna -> 8
    // hint: the angle is in radians
    {"degrees", &Functions::reflectance, at<[](double angle) { return angle * std::numbers::pi / 180.0; }>},

    // Turned into degrees.
    // graded: --variant 1 --student anna -> 8
    // hint: the angle is in radians
    {"to_degrees", &Functions::reflectance, at<[](double angle) { return angle * 180.0 / std::numbers::pi; }>},

    // The root of what is negative.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: total reflection is missing
    {"no_total", &Functions::reflectance, unasked<[](double square) { return square; }>},

    // Its sign removed.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: total reflection is missing
    {"no_total_turned", &Functions::reflectance, unasked<[](double square) { return std::abs(square); }>},

    // The normal part taken off once.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: slides along the surface
    {"slides", &Functions::bounce,
     turned<[](const Vector3d& d, const Vector3d& n) -> Vector3d { return d - d.dot(n) * n; }>},

    // The sign.
    // graded: --variant 1 --student anna -> 12
    // hint: the sign: what points into the sphere is turned round
    {"sign", &Functions::bounce,
     turned<[](const Vector3d& d, const Vector3d& n) -> Vector3d { return d + 2.0 * d.dot(n) * n; }>},

    // All turned round.
    // graded: --variant 1 --student anna -> 12
    // hint: this is minus the direction
    {"into", &Functions::bounce,
     turned<[](const Vector3d& d, const Vector3d& n) -> Vector3d { return 2.0 * d.dot(n) * n - d; }>},

    // Back along its way.
    // graded: --variant 1 --student anna -> 12
    // hint: goes back where it came from
    {"back", &Functions::bounce, turned<[](const Vector3d& d, const Vector3d&) -> Vector3d { return -d; }>},

    // Not turned.
    // graded: --variant 1 --student anna -> 12
    // hint: as if there were no sphere
    {"through", &Functions::bounce, turned<[](const Vector3d& d, const Vector3d&) -> Vector3d { return d; }>},

    // The radius vector for the normal.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: your normal is no unit vector
    {"no_unit", &Functions::bounce,
     [](const Ray& ray, const Sphere& sphere, const Share& share) {
       Ray out = right::bounce(ray, sphere, share);
       const Vector3d n = ray.place - sphere.centre;
       out.direction = ray.direction - 2.0 * ray.direction.dot(n) * n;
       return out;
     }},

    // What is absorbed.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: what the sphere absorbs
    {"absorbed", &Functions::bounce,
     keeps<[](const Share& share, double angle, double power) { return (1.0 - share(angle)) * power; }>},

    // Nothing is absorbed.
    // graded: --variant 1 --student anna -> 12
    // hint: nothing is absorbed
    {"all_kept", &Functions::bounce, keeps<[](const Share&, double, double power) { return power; }>},

    // A ray of 1 W.
    // graded: --variant 1 --student anna -> 12
    // hint: the share, not the power
    {"share", &Functions::bounce, keeps<[](const Share& share, double angle, double) { return share(angle); }>},

    // The angle of the other variant.
    // graded: --variant 1 --student anna -> 12
    // hint: from where does your variant count it
    {"other_angle", &Functions::bounce, right::bounce_from_surface},

    // And the other way round.
    // graded: --variant 2 --student anna|bob@school.edu -> 12
    // hint: from where does your variant count it
    {"other_angle_second", &Functions::reflectance, right::from_surface},

    // The angle between two vectors that point at each other.
    // graded: --variant 1 --student anna -> 12
    // hint: the angle is obtuse
    {"obtuse", &Functions::bounce,
     keeps<[](const Share& share, double angle, double power) { return share(std::numbers::pi - angle) * power; }>},

    // The same from the surface.
    // graded: --variant 2 --student anna -> 12
    // hint: the angle is negative
    {"negative", &Functions::reflectance, right::from_surface, &Functions::bounce,
     keeps<[](const Share& share, double angle, double power) {
       return share(angle - 0.5 * std::numbers::pi) * power;
     }>},

    // A cosine for an angle.
    // graded: --variant 1 --student anna -> 12
    // hint: not for its cosine
    {"asks_cosine", &Functions::bounce,
     keeps<[](const Share& share, double angle, double power) { return share(std::cos(angle)) * power; }>},

    // An angle in degrees.
    // graded: --variant 1 --student anna -> 12
    // hint: share() is asked for an angle in radians
    {"asks_degrees", &Functions::bounce, keeps<[](const Share& share, double angle, double power) {
       return share(angle * 180.0 / std::numbers::pi) * power;
     }>},

    // Cheat: what is no number.
    // graded: --variant 1 --student anna -> 8
    // hint: the answer is not a finite number
    {"nan", &Functions::reflectance, [](double, double) { return std::numeric_limits<double>::quiet_NaN(); }},

    // Cheat: leaves with the status of success.
    // graded: --variant 1 --student anna -> 0
    // hint: do not call exit()
    {"exit", &Functions::reflectance, [](double, double) -> double { std::exit(0); }, &Functions::bounce,
     [](const Ray&, const Sphere&, const Share&) -> Ray { std::exit(0); }},
};

const Functions handed_in = made(mistakes);

}  // namespace

double reflectance(double n_hat, double angle) { return handed_in.reflectance(n_hat, angle); }

Ray bounce(const Ray& ray, const Sphere& sphere, const Share& share) { return handed_in.bounce(ray, sphere, share); }
