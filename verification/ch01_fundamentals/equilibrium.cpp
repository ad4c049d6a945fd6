// Where attraction and repulsion balance, what holds the pair there, and what does not.

#include <cmath>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/central_force.hpp>

#include "differences.hpp"
#include "fifty_digits.hpp"

namespace verification::equilibrium {

using namespace particulate;

const kinematics::CentralForce book{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0};
const kinematics::CentralForce reversed{.alpha1 = 0.25, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 1.0};
const kinematics::CentralForce real{.alpha1 = 3.0, .alpha2 = 0.7, .beta1 = 1.3, .beta2 = 2.9};

// The curvature of a pair's total potential energy when one body moves along a direction.
double stiffness(const kinematics::CentralForce& law, double d, const Eigen::Vector3d& direction) {
  const NearFieldScene scene(pair_at_rest(1.0, 1.0, d), {},
                             {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2});
  const schemes::State start = scenes::start(scene);
  const auto energy = [&](double x) {
    schemes::State moved = start;
    for (Eigen::Index axis = 0; axis < 3; ++axis) moved.r[2 * axis + 1] += x * direction[axis];
    return scene.potential_energy(moved);
  };
  return curvature_at_zero(energy, 0.01 * d);
}

void compare_place(Rows& rows) {
  rows.compare("d_e [m], beta = (1, 2)", {.expected = 0.5,
                                          .computed = equilibrium_distance(book),
                                          .tolerance = relative(2.3e-16),
                                          .because = "(0.25/0.5)^1, one power"});
  rows.compare("d_e [m], beta = (2, 1)", {.expected = 0.5,
                                          .computed = equilibrium_distance(reversed),
                                          .tolerance = relative(2.3e-16),
                                          .because = "(0.5/0.25)^-1, one power"});
  rows.compare("d_e [m], beta = (1.3, 2.9)",
               {.expected = equilibrium_in_fifty_digits(real.alpha1, real.alpha2, real.beta1, real.beta2),
                .computed = equilibrium_distance(real),
                .tolerance = relative(1e-15),
                .because = "ratio and exponent are rounded twice each, ln(0.7/3)/1.6 is of size 1"});
}

void compare_sign(Rows& rows) {
  rows.equal("stable, beta = (1, 2)", {.expected = true, .computed = is_stable(book), .because = "beta2 > beta1"});
  rows.equal("stable, beta = (2, 1)", {.expected = false, .computed = is_stable(reversed), .because = "beta2 < beta1"});
  // alpha1 d_e^(-beta1 - 1) (beta2 - beta1), by hand: 0.5 * 4 * 1 and 0.25 * 8 * (-1).
  rows.compare("V''(d_e) [N/m], beta = (1, 2)", {.expected = 2.0,
                                                 .computed = normal_stiffness(book, 0.5),
                                                 .tolerance = relative(4e-16),
                                                 .because = "powers of two throughout"});
  rows.compare("V''(d_e) [N/m], beta = (2, 1)", {.expected = -2.0,
                                                 .computed = normal_stiffness(reversed, 0.5),
                                                 .tolerance = relative(4e-16),
                                                 .because = "powers of two throughout"});
}

// At 0.25, 0.5, 1 and 2 m, by hand: V'' = -0.5/d^2 + 0.5/d^3 along, C/d = 0.5/d^2 - 0.25/d^3 across.
void compare_hessian(Rows& rows) {
  const struct {
    double d, along, across;
  } points[] = {{.d = 0.25, .along = 24.0, .across = -8.0},
                {.d = 0.5, .along = 2.0, .across = 0.0},
                {.d = 1.0, .along = 0.0, .across = 0.25},
                {.d = 2.0, .along = -0.0625, .across = 0.09375}};
  const Eigen::Vector3d across{3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0};
  const char* const because =
      "differences over h = 0.01 d of energies rounded to 1e-16 carry 4e-16/(0.01 d)^2, "
      "6e-11 at 0.25 m; truncation is below 1e-12";
  for (const auto& at : points) {
    const std::string where = fmt::format(" [N/m], d = {} m", at.d);
    const auto compare = [&](const std::string& what, double expected, double computed, Tolerance tolerance,
                             const char* reason) {
      rows.compare(what + where,
                   {.expected = expected, .computed = computed, .tolerance = tolerance, .because = reason});
    };
    compare("normal_stiffness", at.along, normal_stiffness(book, at.d), absolute(1e-14), "a few roundings of up to 32");
    compare("transverse_stiffness", at.across, transverse_stiffness(book, at.d), absolute(1e-14),
            "a few roundings of up to 16");
    compare("energy's curvature along", at.along, stiffness(book, at.d, slanted()), absolute(2e-10), because);
    compare("energy's curvature across", at.across, stiffness(book, at.d, across), absolute(2e-10), because);
  }
}

// How often the transverse stiffness changes its sign over twelve decades.
int sign_changes(const kinematics::CentralForce& law) {
  int changes = 0;
  double before = 0.0;
  for (double d = 1e-6; d < 1e6; d *= 1.01) {
    const double here = transverse_stiffness(law, d);
    if (before * here < 0.0) ++changes;
    before = here;
  }
  return changes;
}

const Case equilibrium{
    {.name = "equilibrium",
     .claim =
         "a pair balances at d_e, stable along the line of centres iff beta2 > beta1, neutral across it at d_e only",
     .equation = "M 1.36",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_place(rows);
      compare_sign(rows);
      compare_hessian(rows);
      rows.equal("zeros of the transverse stiffness in 1e-6 ... 1e6 m",
                 {.expected = 1, .computed = sign_changes(book), .because = "C vanishes at d_e alone"});
    }};

}  // namespace verification::equilibrium
