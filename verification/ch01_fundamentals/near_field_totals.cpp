// Near fields act in pairs, so their sum and their moment vanish.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/momentum.hpp>

namespace verification::near_field_totals {

using namespace particulate;

struct Totals {
  double force, moment;  // over sum |Psi| and sum |r| |Psi|
};

Totals totals(const kinematics::Particles& cloud, const laws::NearField& law) {
  const NearFieldScene scene(cloud, {}, law);
  Eigen::VectorXd flat(3 * cloud.size());
  if (!scene.total_force(scenes::start(scene), flat)) throw std::runtime_error("the cloud has no forces");
  const kinematics::Vectors force = rows_of(flat);
  const Eigen::VectorXd size = force.rowwise().norm();
  return {.force = force.colwise().sum().norm() / size.sum(),
          .moment = kinematics::moment(cloud.position, force).norm() / cloud.position.rowwise().norm().dot(size)};
}

const Case near_field_totals{
    {.name = "near_field_totals",
     .claim = "total force and total moment of near fields vanish, whatever masses and exponents",
     .equation = "M 2.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      const laws::NearField laws[] = {
          {.alpha1 = 0.5, .alpha2 = 0.25},
          {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
          {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 0.0, .beta2 = 13.0},
          {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = 0.7, .beta2 = 2.6, .scaling = laws::Scaling::area},
          {.alpha1 = 1.0, .alpha2 = 0.3, .beta1 = 1.5, .beta2 = 4.5, .scaling = laws::Scaling::pair}};
      for (const Eigen::Index N : {2, 20, 300}) {
        const kinematics::Particles cloud = random_cloud({.N = N, .decades = 6.0}, rows.case_seed());
        const double limit = 1.2e-16 * static_cast<double>(N + 10);
        for (const laws::NearField& law : laws) {
          const Totals seen = totals(cloud, law);
          const std::string which = fmt::format(", N = {}, beta = ({}, {})", N, law.beta1, law.beta2);
          const char* const because =
              "each particle's force is a sum of N - 1 terms, every sum rounded to eps/2; "
              "masses over twelve decades";
          rows.at_most("|sum Psi| / sum |Psi|" + which, {.limit = limit, .computed = seen.force, .because = because});
          rows.at_most("|sum r x Psi| / sum |r||Psi|" + which,
                       {.limit = limit, .computed = seen.moment, .because = because});
        }
      }
    }};

}  // namespace verification::near_field_totals
