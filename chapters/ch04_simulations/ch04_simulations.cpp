//! @page ch04_simulations Chapter 4: Representative numerical simulations
//! @brief A cloud of spheres with a near field and contact: what becomes of its energy, and how far one may trust it.
//! @tableofcontents
//!
//! @section ch04_question What becomes of a cloud
//!
//! Chapter 4 of the monograph @cite zohdi2007 lets a thousand spheres fly together through space. Each has a velocity of
//! its own on top of the common one, and where two of them meet, the impact takes energy; a near field may let them feel
//! each other from afar. The monograph asks how the energy divides between the motion of the whole, which nothing in the
//! cloud can change, and the motion about it, and how that depends on the strength of the near field.
//!
//! @figure{ch04_start, A cloud at the start: the spheres in their true size\, with what each moves by in a twentieth of a second\, seen along z.}
//!
//! We draw its figures, and then ask what a careful reader would ask of them: how much of what they show is physics, and
//! how much the step?
//!
//! - What becomes of the energy with four near fields, by the monograph's own way? @subpage ch04_clouds
//! - And what, when the step is made smaller, or contacts are located? @subpage ch04_steps
//! - Without a near field, what does kinetic theory foretell, and where does it fail? @subpage ch04_gas
//! - What does it take to cut such a run short, and go on? @subpage ch04_journal
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch04_simulations
//! build/release/bin/ch04_simulations --out ch04
//! @endverbatim
//!
//! With a thousand spheres that takes some ten minutes, with `--quick` and two hundred some twenty seconds, a good part of
//! them for the hundred thousand spheres of a gas.
//! `--checkpoint 0.1` saves the runs after every tenth of a second of their motion, and `--restart ch04/checkpoint.bin`
//! goes on from there.
//! `--snapshots "0 0.5 1"` writes `cloud.xyz` for OVITO and `cloud_000.vtp` and so on for ParaView.
//!
//! @section ch04_program The program
//!
//! The parameters, and what the pages share, stand on @subpage ch04_shared.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/starts.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/scenes/snapshot.hpp>

#include "ch04_simulations.hpp"

namespace ch04 {

//! @section ch04_start_of_it The start
//!
//! Centres are drawn one after the other in a cube with edges of one metre, each anew until its sphere overlaps none
//! before it (particulate::kinematics::random_addition). The radius follows from the length ratio
//! \f$ L = b/V^{1/3} \f$, in which \f$ V \f$ is the share of the cube that a sphere has for itself; so the spheres fill
//! the fraction \f$ \tfrac43 \pi L^3 \f$ of it. Velocities are \f$ (1, 0.1, 0.1) \f$ m/s, and about that uniformly
//! distributed within as much.

kinematics::Particles cloud_of(const Parameters& p, int count, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_01<double> uniform;
  const double b = p.L * std::cbrt(1.0 / count);
  const Eigen::VectorXd radius = Eigen::VectorXd::Constant(count, b);
  kinematics::Particles cloud{
      .position = kinematics::random_addition(radius, {}, [&] { return uniform(engine); }).position,
      .velocity = kinematics::Vectors(count, 3),
      .mass = Eigen::VectorXd::Constant(count, p.density * 4.0 / 3.0 * std::numbers::pi * b * b * b),
      .radius = radius};
  const Eigen::Vector3d mean{1.0, 0.1, 0.1};
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index c = 0; c < 3; ++c) cloud.velocity(i, c) = 2.0 * mean[c] * uniform(engine);
  }
  return cloud;
}

//! What that means for the energy per mass is known beforehand, up to what chance does with so many spheres:
//! \f$ \tfrac12 (1 - 1/N_p)\,(\tfrac13 + \tfrac{2}{300}) \f$ of relative motion, and some
//! \f$ \tfrac12 (1 + 0.02) \f$ of bulk motion. A wrong start would be off by more than four standard deviations.

void check_start(const kinematics::Particles& cloud, report::Checks& checks) {
  const auto N = static_cast<double>(cloud.size());
  const kinematics::KineticEnergy energy = kinematics::split_kinetic_energy(cloud.mass, cloud.velocity);
  const double relative = 0.5 * (1.0 - 1.0 / N) * (1.0 / 3.0 + 2.0 / 300.0);
  const double of_square = std::sqrt(4.0 / 45.0), of_velocity = std::sqrt(1.0 / 3.0);  // uniform in (-1, 1)
  checks.add("relative energy at the start, off what is expected [J/kg]", energy.relative - relative,
             4.0 * 0.5 * of_square / std::sqrt(N) + 2.0 / N);
  checks.add("bulk energy at the start, off what is expected [J/kg]", energy.bulk - 0.5 * 1.02,
             4.0 * of_velocity / std::sqrt(N) + 4.0 / N);
}

//! @section ch04_snapshots Snapshots
//!
//! Pictures of the page are drawn from a table; other programs get files of their own kind.

void add_places(report::Table& places, const schemes::State& state, const kinematics::Particles& cloud) {
  const kinematics::Vectors r = positions(state), v = velocities(state);
  const Eigen::RowVector3d centre = r.colwise().mean(), bulk = v.colwise().mean();
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const Eigen::RowVector3d about = r.row(i) - centre, moves = v.row(i) - bulk;
    places.add({state.t, about[0], about[1], about[2], cloud.radius[i], moves[0], moves[1], moves.norm()});
  }
}

void write_snapshots(const Parameters& p, const Journal& journal, const report::Output& output) {
  const kinematics::Space space;
  report::Table places({"time [s]", "x [m]", "y [m]", "z [m]", "radius [m]", "velocity x [m/s]", "velocity y [m/s]",
                        "speed about the centre [m/s]"});
  const std::vector<double> pictures = picture_times(p), snapshots = snapshot_times(p);
  std::ostringstream film;
  int number = 0;
  for (const Moment& at : journal.moments()) {
    const schemes::State state{.t = at.t, .r = at.r, .v = at.v};
    if (std::binary_search(pictures.begin(), pictures.end(), at.t)) add_places(places, state, journal.cloud());
    if (!std::binary_search(snapshots.begin(), snapshots.end(), at.t)) continue;
    scenes::write_xyz(film, journal.cloud(), space, state);
    std::ostringstream file;
    scenes::write_vtk(file, journal.cloud(), space, state);
    output.write_file(fmt::format("cloud_{:03}.vtp", number++), file.str());
  }
  output.write("places", places);
  if (number > 0) output.write_file("cloud.xyz", film.str());
}

void run(const Parameters& p, report::Chapter& chapter) {
  const int count = chapter.common().quick ? std::max(10, p.particles / 5) : p.particles;
  const kinematics::Particles cloud = cloud_of(p, count, chapter.common().seed);
  Journal journal(p, chapter, cloud);
  report::Checks& checks = chapter.claims("checks");
  check_start(cloud, checks);
  clouds(p, journal, chapter.output(), checks);
  steps(p, journal, chapter, checks);
  gas(p, chapter, checks);
  write_snapshots(p, journal, chapter.output());
}

}  // namespace ch04

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch04_simulations",
                              .summary = "Chapter 4: clouds with a near field and contact, and how far to trust them.",
                              .out = "ch04",
                              .figures = "chapters/ch04_simulations/figures.gp"},
                             laws::name(laws::best_kernel()), ch04::run);
}

//! @section ch04_film The cloud in motion
//!
//! @animation{ch04_film, The watched cloud\, with located contacts\, about its centre and seen along z. Colour: speed about the centre.}
//!
//! @section ch04_results What held
//!
//! @table{ch04_checks}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch04}
//!
//! @section ch04_exercises Exercises
//!
//! 1. Why can nothing that happens in the cloud change its bulk energy? Which forces could?
//! 2. Without a near field and in the limit of small steps every impact takes a share of the relative motion along the
//!    line of centres alone. Estimate from the volume fraction how many impacts a sphere has in a second, and compare.
//! 3. Give the attraction of the strongest case to the weakest repulsion. What becomes of the distance at which the two
//!    balance, and does the cloud hold together?
//! 4. Halve `--limit` until the largest overlap is a hundredth of the radius. Which of the two stepped ways gets there
//!    with fewer evaluations of the forces, and which is nearer to the located one then?
//! 5. Take `--seed 2` to 6. How far do the final energies scatter, and which differences between the four cases are
//!    larger than that?
