//! @page ch07_meetings Chapter 7: Two charged clouds
//! @brief Clouds that attract each other merge if they meet slowly, and disperse if they meet fast.
//! @tableofcontents
//!
//! @section ch07_meetings_question Merging and dispersing
//!
//! Two clouds of a hundred spheres each, in cubes of 0.5 m whose centres are 0.6 m apart, meet with \f$ \pm U \f$. They
//! attract each other, and their spheres each other, by the near field alone. After two seconds we count the spheres of
//! the largest component, linked up to a distance that is somewhat more than that of neighbours at rest.
//!
//! @figure{ch07_slow, A slow impact\, U = 1 m/s: the clouds merge. Figure 7.16.}
//!
//! @figure{ch07_fast, A fast one\, U = 8 m/s: they disperse. Figure 7.17.}
//!
//! @section ch07_meetings_program The program

#include <algorithm>
#include <array>

#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/clusters.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {
namespace {

constexpr std::array<double, 6> speeds{0.5, 1.0, 2.0, 3.0, 4.0, 8.0};                          // [m/s]
constexpr double drawn_slow = 1.0, drawn_fast = 8.0, meeting_time = 2.0, meeting_link = 0.35;  // [m/s], [s], [m]

struct Meeting {
  double U;
  std::uint64_t seed;
  double largest = 0.0;  // component over all [-]
  std::vector<schemes::State> moments = {};
};

void meet(const Parameters& p, Meeting& meeting) {
  const Eigen::Vector3d still = Eigen::Vector3d::Zero(), half = Eigen::Vector3d::Constant(0.5);
  const kinematics::Particles both =
      together(cloud_in({half, {-0.55, -0.25, -0.25}}, 100, {meeting.U, 0.0, 0.0}, still, p.c, meeting.seed),
               cloud_in({half, {0.05, -0.25, -0.25}}, 100, {-meeting.U, 0.0, 0.0}, still, p.c, meeting.seed + 1000));
  const scenes::Scene scene(both, kinematics::Space{}, near_field, contact_with(cold));
  schemes::State state = start(scene);
  const auto keep = [&](const schemes::State& at) { meeting.moments.push_back(at); };
  require_end(integrate(scene, state, meeting_time, schemes::VelocityVerlet{}, schemes::FixedStep{.step = charged_step},
                        schemes::Sampling(evenly(pictures, meeting_time), keep)));
  const thermo::Clusters linked = thermo::find_clusters(scene.domain(), positions(state), meeting_link);
  meeting.largest = static_cast<double>(linked.largest()) / static_cast<double>(both.size());
}

}  // namespace

void meetings(const Parameters& p, report::Chapter& chapter) {
  std::vector<Meeting> all;
  for (const double U : speeds) {
    for (int k = 0; k < seeds_of(p); ++k) all.push_back({.U = U, .seed = seed_of(p, k)});
  }
  report::for_each_run("two clouds", static_cast<int>(all.size()), p.line.common().threads,
                       [&](int k) { meet(p, all[static_cast<std::size_t>(k)]); });
  report::Table table({"U [m/s]", "largest component, least [-]", "median [-]", "largest [-]"});
  report::Table places({"U [m/s]", "time [s]", "cloud", "x [m]", "y [m]", "z [m]"});
  double merged = 1.0, dispersed = 0.0;
  for (const double U : speeds) {
    std::vector<double> shares;
    for (const Meeting& one : all) {
      if (one.U == U) shares.push_back(one.largest);
    }
    const report::Spread spread = report::spread_of(shares);
    table.add({U, spread.least, spread.median, spread.largest});
    if (U <= 2.0) merged = std::min(merged, spread.least);
    if (U == drawn_fast) dispersed = spread.largest;
  }
  for (const Meeting& one : all) {
    if (one.seed != seed_of(p, 0) || (one.U != drawn_slow && one.U != drawn_fast)) continue;
    for (const schemes::State& at : one.moments) {
      const kinematics::Vectors r = positions(at);
      for (Eigen::Index i = 0; i < r.rows(); ++i) {
        places.add({one.U, at.t, i < r.rows() / 2 ? 1 : 2, r(i, 0), r(i, 1), r(i, 2)});
      }
    }
  }
  chapter.output().write("meetings", table);
  chapter.output().write("meeting_places", places);
  claim_of_own(p, chapter, "share of the spheres that slow clouds (U up to 2 m/s) leave out of the largest component",
               1.0 - merged, 0.05);
  claim_of_own(p, chapter, "share of the spheres in the largest component after a fast impact (U = 8 m/s)", dispersed,
               0.05);
}

}  // namespace ch07

//! @section ch07_meetings_results What becomes of them
//!
//! @table{ch07_meetings}
//!
//! Slow clouds become one, in which spheres of both are mixed evenly, spaced by the balance of the near field. Fast
//! ones go through each other and leave nothing together. In between is no threshold but a gradual loss. And
//! *dispersed* means at this time: with \f$ \beta_1 = 1 \f$ the potential of the attraction grows like \f$ \ln d \f$,
//! without end, so that nothing ever escapes. Whoever waits long enough sees every cloud come back.
//!
//! @section ch07_meetings_exercises Exercises
//!
//! 1. Estimate from the logarithmic potential how far two clouds of U = 8 m/s fly apart, and when they are back.
//! 2. Change the link in the program. Which speeds does the answer depend on?
