// The force towards a centre has no curl; a swirl of a millionth of its gradient is seen.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <harness/case.hpp>
#include <particulate/kinematics/central_force.hpp>

#include "differences.hpp"

namespace verification::central_force_curl {

using namespace particulate;
using Eigen::Vector3d;

// Row i, column j: the slope of component i along axis j.
template <class Field>
Eigen::Matrix3d gradient(const Field& field, const Vector3d& r, double h) {
  Eigen::Matrix3d slopes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      slopes(i, j) = slope_at_zero([&](double x) { return field(r + x * Vector3d::Unit(j))[i]; }, h);
    }
  }
  return slopes;
}

Vector3d curl(const Eigen::Matrix3d& of) { return {of(2, 1) - of(1, 2), of(0, 2) - of(2, 0), of(1, 0) - of(0, 1)}; }

struct Seen {
  double curl;   // of the force, over its largest slope
  double swirl;  // error of the curl of a swirl that is added, over that curl
};

Seen look(const kinematics::CentralForce& law, const Vector3d& r) {
  const Vector3d r_o{0.3, -0.2, 0.1};
  const double h = 2e-3 * (r - r_o).norm();
  const Eigen::Matrix3d slopes = gradient([&](const Vector3d& x) { return force(law, x, r_o); }, r, h);
  const double largest = slopes.cwiseAbs().maxCoeff();

  // The field w x (r - r_o) has the curl 2 w.
  const Vector3d w = 1e-6 * largest * Vector3d{1.0, -2.0, 2.0} / 3.0;
  const auto swirling = [&](const Vector3d& x) -> Vector3d { return force(law, x, r_o) + w.cross(x - r_o); };
  return {.curl = curl(slopes).norm() / largest,
          .swirl = (curl(gradient(swirling, r, h)) - 2.0 * w).norm() / (2.0 * w).norm()};
}

const Case central_force_curl{
    {.name = "central_force_curl",
     .claim = "the curl of a central force vanishes, whatever its exponents",
     .equation = "M 1.20",
     .reference = Reference::identity},
    [](Rows& rows) {
      const kinematics::CentralForce laws[] = {{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0},
                                               {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
                                               {.alpha1 = 1.0, .alpha2 = 0.4, .beta1 = 0.0, .beta2 = 1.7},
                                               {.alpha1 = 0.0, .alpha2 = 2.0, .beta1 = 1.0, .beta2 = 13.0},
                                               {.alpha1 = 3.0, .alpha2 = 0.0, .beta1 = 0.6, .beta2 = 1.0}};
      const Vector3d places[] = {{1.1, 0.7, -0.4}, {-0.6, 0.9, 1.3}, {0.35, -0.5, 0.6}, {2.0, -1.0, 3.0}};
      for (const kinematics::CentralForce& law : laws) {
        Seen worst{.curl = 0.0, .swirl = 0.0};
        for (const Vector3d& r : places) {
          const Seen here = look(law, r);
          worst = {.curl = std::max(worst.curl, here.curl), .swirl = std::max(worst.swirl, here.swirl)};
        }
        const std::string which = fmt::format("beta = ({}, {})", law.beta1, law.beta2);
        rows.at_most(
            "|curl Psi| / max slope, " + which,
            {.limit = 1e-12,
             .computed = worst.curl,
             .because = "differences over h = 0.002 d of values rounded to eps carry about 4 eps/0.002 = 4e-13; "
                        "truncation is below 1e-14 for beta = 13"});
        rows.at_most("error of the curl of an added swirl, " + which,
                     {.limit = 1e-6,
                      .computed = worst.swirl,
                      .because = "the noise of 1e-12 of the slope, over a swirl of 1e-6 of it: the check has teeth"});
      }
    }};

}  // namespace verification::central_force_curl
