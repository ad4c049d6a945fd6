//! @page ch07_obstacle Chapter 7: A charged cloud and an obstacle
//! @brief What an obstacle feels of a cloud with and without charges: largest and whole impulse, over several starts.
//! @tableofcontents
//!
//! @section ch07_obstacle_question What charges do
//!
//! A near field with \f$ \beta_2 = 2 \f$ that only repels is that of like charges. A cloud meets an immovable obstacle.
//! Without a near field its spheres hit it; if cloud and obstacle are charged alike they are turned aside.
//!
//! @figure{ch07_ahead, A cloud on its way to an obstacle\, seen from the side: Figure 7.12.}
//!
//! @figure{ch07_passing, The same somewhat later\, uncharged (above) and charged alike (below): Figure 7.13.}
//!
//! What counts is what the obstacle feels. The force of one impact, \f$ J/(\gamma\,\Delta t) \f$, would be as large as
//! its duration is short, and so a matter of the step. Impulses do not depend on it, and a mean force is one over a
//! fixed window of time (particulate::contact::ImpulseWindows).
//!
//! @section ch07_obstacle_program The program

#include <array>
#include <functional>

#include <particulate/contact/impulse_windows.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {
namespace {

constexpr double R = 0.25;  // of the obstacle [m]
const Eigen::Vector3d obstacle_at{1.35, 0.5, 0.5};

//! @section ch07_obstacle_three Three clouds against an obstacle
//!
//! Two hundred spheres in a unit cube fly at 3 m/s, give or take a tenth, towards a sphere of 0.25 m that is 0.1 m
//! ahead. The near field counts strengths per mass, so that the charge of the obstacle is its mass, which does nothing
//! else to what is immovable. A third cloud has the attraction that the captions tell, and an obstacle without charge.

struct Cloud {
  const char* name;
  double alpha1, alpha2;
  bool charged;
};

constexpr std::array<Cloud, 3> three{
    {{"uncharged", 0.0, 0.0, false}, {"charged alike", 0.0, 0.25, true}, {"as the captions", 0.5, 0.25, false}}};

struct Shot {
  Cloud cloud;
  std::uint64_t seed;
  std::vector<contact::WindowImpulse> windows = {};
  contact::WindowImpulse whole = {};
  double force = 0.0;  // the largest mean of a window [N]
  std::vector<schemes::State> moments = {};
};

kinematics::Particles shot_of(const Parameters& p, const Shot& shot) {
  const double charge = shot.cloud.charged ? p.charge : 1e-9;
  kinematics::Particles all = together(cloud_in({}, 200, {3.0, 0.0, 0.0}, {0.3, 0.3, 0.3}, p.c, shot.seed),
                                       kinematics::particles({{.position = obstacle_at, .mass = charge, .radius = R}}));
  all.immovable.assign(static_cast<std::size_t>(all.size()), false);
  all.immovable.back() = true;
  return all;
}

void fly(const Parameters& p, Shot& shot) {
  const kinematics::Particles all = shot_of(p, shot);
  contact::ImpulseWindows felt(all.size() - 1, p.window);
  auto contact = contact_with(cold);
  contact.recorder = std::ref(felt);
  const scenes::Scene scene(all, kinematics::Space{},
                            laws::NearField{.alpha1 = shot.cloud.alpha1, .alpha2 = shot.cloud.alpha2}, contact);
  const auto tell = [&](const auto&, const schemes::State& to, double, const auto&) {
    felt.until(to.t);
    return true;
  };
  const auto keep = [&](const schemes::State& at) { shot.moments.push_back(at); };
  schemes::State state = start(scene);
  require_end(integrate(scene, state, 1.0, schemes::VelocityVerlet{}, schemes::FixedStep{.step = charged_step},
                        schemes::Sampling(evenly(pictures, 1.0), keep, tell)));
  shot.windows = felt.windows();
  shot.whole = felt.whole();
  shot.force = felt.largest_force();
}

void write_first(const Parameters& p, const std::vector<Shot>& shots, const report::Output& output) {
  report::Table windows({"cloud", "time [s]", "largest impulse [N s]", "normal force [N]", "friction [N]"});
  report::Table places({"cloud", "time [s]", "x [m]", "y [m]", "z [m]", "radius [m]"});
  for (std::size_t k = 0; k < three.size(); ++k) {
    const Shot& shot = shots[k];
    for (std::size_t n = 0; n < shot.windows.size(); ++n) {
      const contact::WindowImpulse& one = shot.windows[n];
      windows.add({shot.cloud.name, (static_cast<double>(n) + 0.5) * p.window, one.largest, one.normal / p.window,
                   one.tangential / p.window});
    }
    for (const schemes::State& at : shot.moments) {
      const kinematics::Vectors r = positions(at);
      for (Eigen::Index i = 0; i < r.rows(); ++i) {
        places.add({shot.cloud.name, at.t, r(i, 0), r(i, 1), r(i, 2), i + 1 < r.rows() ? radius : R});
      }
    }
  }
  output.write("windows", windows);
  output.write("shots", places);
}

}  // namespace

void obstacle(const Parameters& p, report::Chapter& chapter) {
  std::vector<Shot> shots;
  for (int k = 0; k < seeds_of(p); ++k) {
    for (const Cloud& cloud : three) shots.push_back({.cloud = cloud, .seed = seed_of(p, k)});
  }
  report::for_each_run("clouds against an obstacle", static_cast<int>(shots.size()), p.line.common().threads,
                       [&](int k) { fly(p, shots[static_cast<std::size_t>(k)]); });
  write_first(p, shots, chapter.output());
  report::Table table({"seed", "cloud", "largest impulse [N s]", "largest force over a window [N]",
                       "whole impulse [N s]", "of friction [N s]"});
  for (const Shot& s : shots) {
    table.add({s.seed, s.cloud.name, s.whole.largest, s.force, s.whole.normal, s.whole.tangential});
  }
  chapter.output().write("obstacle", table);

  const auto not_lower = [&](std::size_t cloud, const auto& number) {
    double count = 0.0;
    for (std::size_t k = 0; k < shots.size(); k += three.size()) {
      count += number(shots[k + cloud]) < number(shots[k]) ? 0.0 : 1.0;
    }
    return count;
  };
  const auto largest = [](const Shot& s) { return s.whole.largest; };
  const auto whole = [](const Shot& s) { return s.whole.normal; };
  claim_of_own(p, chapter, "starts whose largest impulse charges alike do not lower", not_lower(1, largest), 0.0);
  claim_of_own(p, chapter, "starts whose largest force over a window they do not lower",
               not_lower(1, [](const Shot& s) { return s.force; }), 0.0);
  claim_of_own(p, chapter, "starts whose whole impulse they do not lower", not_lower(1, whole), 0.0);
  claim_of_own(p, chapter, "starts whose whole friction they do not lower",
               not_lower(1, [](const Shot& s) { return s.whole.tangential; }), 0.0);
  claim_of_own(p, chapter, "starts whose whole impulse the captions' attraction does lower",
               seeds_of(p) - not_lower(2, whole), 0.0);
}

}  // namespace ch07

//! @section ch07_obstacle_results What the obstacle feels
//!
//! @figure{ch07_impulse, Largest impulse on the obstacle in every window of time: Figure 7.14.}
//!
//! @figure{ch07_force, Mean normal force on the obstacle (full) and friction (broken) in the same windows: Figure 7.15.}
//!
//! @table{ch07_obstacle}
//!
//! Like charges lower all of it in every start: the largest impulse, as spheres are slowed down before they hit; and
//! far more the whole, as most are turned aside and never do. This is what the captions say. It holds for *like
//! charges*, that is for a near field without attraction and an obstacle with a charge of its own. The captions tell
//! attraction and repulsion, and no charge of the obstacle. Taken at their word, with an obstacle that the near field
//! does not see, the cloud draws itself together on its way and hits *more*: the whole impulse then is larger than
//! without a near field in every start. So the sign belongs to the charges, and we say which (@ref errata).
//!
//! @section ch07_obstacle_exercises Exercises
//!
//! 1. Take `--window 0.005` and 0.1. Which columns of the table change, and which cannot?
//! 2. Take `--charge 2` and 20. From which charge on is the obstacle never hit?
//! 3. Give the cloud of the captions an obstacle with a charge. Which strengths let it hit less?
