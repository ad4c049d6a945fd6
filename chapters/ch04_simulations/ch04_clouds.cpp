//! @page ch04_clouds Chapter 4: Energy with four near fields
//! @brief Bulk and relative energy of a cloud in time, as the monograph computes and draws it.
//! @tableofcontents
//!
//! The near fields of the monograph attract with \f$ \alpha_1 \f$ and repel with \f$ \alpha_2 = \alpha_1/2 \f$, in
//! \f$ \alpha_1 d^{-1} - \alpha_2 d^{-2} \f$ per masses, so that all three balance at the same distance of half a metre.
//! The mean spacing is a fifth of that: *every near neighbour repels*, and what attracts is the cloud as a whole. Nothing
//! binds two spheres that touch; clusters need a force of shorter reach, which is chapter 7's.
//!
//! @section ch04_clouds_program The program

#include <cmath>

#include <Eigen/Core>

#include <particulate/report/checks.hpp>
#include <particulate/report/spread.hpp>

#include "ch04_simulations.hpp"

namespace ch04 {

//! We follow the cloud four times as the monograph does: backward Euler, solved by sweeps to TOL, with steps up to
//! \f$ \Delta t_{lim} \f$ and contacts resolved at their ends.

void clouds(const Parameters& p, Journal& journal, const report::Output& output, report::Checks& checks) {
  report::Table energies(
      {"case", "time [s]", "bulk share [-]", "relative share [-]", "total [J/kg]", "relative [J/kg]"});
  double momentum_change = 0.0, rises = 0.0;
  const kinematics::Particles& cloud = journal.cloud();
  const double scale = (cloud.velocity.rowwise().norm().array() * cloud.mass.array()).sum();
  for (std::size_t k = 0; k < near_fields.size(); ++k) {
    const Followed& run = journal.follow({k, Way::backward_euler, p.limit});
    double before = run.column("relative", 0);
    for (Eigen::Index row = 0; row < run.history.rows(); ++row) {
      const double bulk = run.column("bulk", row), relative = run.column("relative", row);
      energies.add({near_fields[k].name, run.column("time", row), bulk / (bulk + relative),
                    relative / (bulk + relative), bulk + relative, relative});
      if (k == 0) rises = report::worse_of(rises, relative - before);
      before = relative;
      for (const char* component : {"momentum x", "momentum y", "momentum z"}) {
        const double change = run.column(component, row) - run.column(component, 0);
        momentum_change = std::isnan(change) ? change : std::max(momentum_change, std::abs(change) / scale);
      }
    }
  }
  output.write("energies", energies);
  checks.add("momentum of the cloud, relative to that of its spheres one by one", momentum_change, 1e-13);
  checks.add("without a near field the relative energy never rises [J/kg]", rises, 1e-15);
}

}  // namespace ch04

//! @section ch04_clouds_figures What the monograph draws
//!
//! @figure{ch04_proportions, Shares of bulk and relative motion in the kinetic energy\, by backward Euler at the limit of the step: Figure 4.2.}
//!
//! @figure{ch04_total, Kinetic energy per mass of the same four runs: Figure 4.3.}
//!
//! The bulk energy is a constant, as it must be: forces come in pairs. So the shares say no more than the relative energy
//! does. Without a near field it can only fall, by impacts. With one, spheres that are too close push each other apart,
//! and the potential of the start turns into motion, until the cloud has room; then impacts take over.
//!
//! By these figures the strongest near field gains most at first, and in the end has lost it again. Whether it does is the
//! question of @ref ch04_steps "the next page".
