// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions.

#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using Eigen::Vector3d;

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  Vector3d (*normal)(double) = right::normal;
  double (*normal_impulse)(const Body&, const Body&, const Vector3d&, double) = right::normal_impulse;
  Vector3d (*friction_impulse)(const Body&, const Body&, const Vector3d&, const Surface&) = right::friction_impulse;
  Velocities (*impact)(const Body&, const Body&, const Vector3d&, const Surface&) = right::impact;
};

const std::vector<Mistake<Functions>> mistakes{
    // Degrees are taken for radians.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: the angle is in degrees
    {"degrees", &Functions::normal, [](double degrees) { return Vector3d(std::cos(degrees), std::sin(degrees), 0.0); }},

    // pi has six digits.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: pi has more digits
    {"six_digits", &Functions::normal,
     [](double degrees) { return right::normal(degrees / std::numbers::pi * 3.14159); }},

    // The sum of the inverses is taken for m* itself, in J and, since both call one function, in P.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: m* is upside down
    // never: factor
    // never: restitution: along n
    // never: friction:
    {"not_inverted", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) {
       return right::normal_impulse(i, j, n, e) * right::not_inverted(i, j) / right::reduced_mass(i, j);
     },
     &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return right::friction(i, j, n, surface, right::slip(i, j, n),
                              -right::not_inverted(i, j) * right::slip(i, j, n));
     }},

    // The same in P alone, which writes m* out once more.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: m* is upside down
    // never: factor
    {"not_inverted_in_friction", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return right::friction(i, j, n, surface, right::slip(i, j, n),
                              -right::not_inverted(i, j) * right::slip(i, j, n));
     }},

    // The first variant's map, where j is driven.
    // graded: --variant 2 --student anna|bob@school.edu -> 8
    // hint: this is the map of the other variant
    {"other_variant"},

    // The normal is thought to point from j to i, so that those who meet seem to part.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: sign of n: it points from i to j
    {"sign_of_normal", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) { return right::normal_impulse(i, j, -n, e); }},

    // The impulse on i is positive, and j gets the opposite.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: sign of J: contacts push
    // never: restitution: along n
    {"pushes_back", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) { return -right::normal_impulse(i, j, n, e); }},

    // e stands where 1 + e belongs.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: forgotten 1 + e
    // never: restitution: along n
    {"forgotten_one", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) { return right::normal_impulse(i, j, n, e - 1.0); }},

    // What no mistake explains.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: compare with the formula of the brief
    // hint: restitution: along n
    {"unexplained", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) { return 1.1 * right::normal_impulse(i, j, n, e); }},

    // e is taken for the share of the energy that is kept.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: e is a ratio of velocities, not of energies
    {"energy", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) {
       return right::normal_impulse(i, j, n, std::sqrt(e));
     }},

    // Nobody asks whether the bodies approach.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: bodies that part exchange nothing
    {"pulls", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) {
       return -(1.0 + e) * right::reduced_mass(i, j) * (i.v - j.v).dot(n);
     }},

    // A small mass keeps the reduced mass from being 0/0.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: no small number belongs
    {"softened", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) {
       return right::normal_impulse(i, j, n, e) * (i.m + j.m) / (i.m + j.m + 1e-12);
     }},

    // Half the reduced mass.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: factor 1/2: m*
    {"half", &Functions::normal_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, double e) { return 0.5 * right::normal_impulse(i, j, n, e); },
     &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d slip = right::slip(i, j, n), to_stick = -0.5 * right::reduced_mass(i, j) * slip;
       const double J = normal_impulse(i, j, n, surface.e);
       return to_stick.norm() <= -surface.mu_s * J ? to_stick : Vector3d(surface.mu_d * J / slip.norm() * slip);
     }},

    // J stands where |J| belongs.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: the impulse J is negative, friction is proportional
    {"forgotten_bars", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d slip = right::slip(i, j, n), to_stick = -right::reduced_mass(i, j) * slip;
       const double J = normal_impulse(i, j, n, surface.e);
       return to_stick.norm() <= surface.mu_s * J ? to_stick : Vector3d(-surface.mu_d * J / slip.norm() * slip);
     }},

    // J stands where |J| belongs, once it slides.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: the impulse J is negative, friction is proportional
    {"forgotten_bars_sliding", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d slip = right::slip(i, j, n), to_stick = -right::reduced_mass(i, j) * slip;
       const double J = normal_impulse(i, j, n, surface.e);
       return to_stick.norm() <= -surface.mu_s * J ? to_stick : Vector3d(-surface.mu_d * J / slip.norm() * slip);
     }},

    // The whole relative velocity is taken for the slip.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: take the normal part from the relative velocity
    // never: restitution: along n
    {"whole_velocity", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d w = i.v - j.v;
       return right::friction(i, j, n, surface, w, -right::reduced_mass(i, j) * w);
     }},

    // It slides against the whole relative velocity.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: not along w/|w|
    // never: restitution: along n
    {"whole_direction", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return right::friction(i, j, n, surface, i.v - j.v, -right::reduced_mass(i, j) * right::slip(i, j, n));
     }},

    // The whole relative velocity says whether it sticks.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: the slip alone has to be stopped
    {"whole_length", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d slip = right::slip(i, j, n), w = i.v - j.v;
       const double size = std::abs(normal_impulse(i, j, n, surface.e));
       if (right::reduced_mass(i, j) * w.norm() <= surface.mu_s * size)
         return Vector3d(-right::reduced_mass(i, j) * slip);
       return Vector3d(-surface.mu_d * size / slip.norm() * slip);
     }},

    // mu_s says how strongly it slides.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: once it slides the coefficient is mu_d
    {"slides_by_static", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return right::friction_impulse(i, j, n, {.e = surface.e, .mu_s = surface.mu_s, .mu_d = surface.mu_s});
     }},

    // mu_d says whether it sticks.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: whether it sticks is decided by mu_s
    {"sticks_by_dynamic", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return right::friction_impulse(i, j, n, {.e = surface.e, .mu_s = surface.mu_d, .mu_d = surface.mu_d});
     }},

    // Equality slides, which is 0/0 where nothing slips and nothing rubs.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: equality included
    {"sticks_strictly", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d slip = right::slip(i, j, n), to_stick = -right::reduced_mass(i, j) * slip;
       const double J = normal_impulse(i, j, n, surface.e);
       return to_stick.norm() < -surface.mu_s * J ? to_stick : Vector3d(surface.mu_d * J / slip.norm() * slip);
     }},

    // Friction slides always, however small the slip, and reverses it.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: friction is not capped
    // hint: friction does not reverse the sliding
    {"never_sticks", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return Vector3d(surface.mu_d * normal_impulse(i, j, n, surface.e) * right::slip(i, j, n).normalized());
     }},

    // Friction drives the sliding on.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: sign of friction
    // hint: no energy is gained
    {"friction_pushes", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return Vector3d(-right::friction_impulse(i, j, n, surface));
     }},

    // The two coefficients of friction are swapped.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: mu_s and mu_d are swapped
    // hint: mu_d how strongly it slides
    {"swapped_coefficients", &Functions::friction_impulse,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       return right::friction_impulse(i, j, n, {.e = surface.e, .mu_s = surface.mu_d, .mu_d = surface.mu_s});
     }},

    // Both bodies get the same impulse.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: momentum: j gets the opposite
    {"same_direction", &Functions::impact,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d impulse = right::impulse(i, j, n, surface);
       return Velocities{.i = i.v + impulse / i.m, .j = j.v + impulse / j.m};
     }},

    // Each impulse is divided by the other body's mass.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: swapped indices: the change of v_i
    {"swapped_masses", &Functions::impact,
     [](const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
       const Vector3d impulse = right::impulse(i, j, n, surface);
       return Velocities{.i = i.v + impulse / j.m, .j = j.v - impulse / i.m};
     }},
};

const Functions handed_in = made(mistakes);

}  // namespace

Vector3d normal(double degrees) { return handed_in.normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Vector3d& n, double e) {
  return handed_in.normal_impulse(i, j, n, e);
}

Vector3d friction_impulse(const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
  return handed_in.friction_impulse(i, j, n, surface);
}

Velocities impact(const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
  return handed_in.impact(i, j, n, surface);
}
