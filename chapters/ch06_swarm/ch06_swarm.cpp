//! @page ch06_swarm Chapter 6: Swarms
//! @brief A swarm that is told nothing but three central forces, and finds its way through a fence to a target.
//! @tableofcontents
//!
//! @section ch06_question A swarm without a leader
//!
//! Chapter 6 of the monograph @cite zohdi2007 lets particles become *members*: they attract and repel each other, are
//! repelled by obstacles, and drawn to a target. None of them knows of a plan. That they pass a fence unharmed and
//! gather behind it is the work of a few strengths and exponents, which the genetic algorithm of chapter 5 has chosen.
//!
//! @figure{ch06_way, One flight\, seen from the side: the swarm at the start\, bunched\, in the plane of the fence\, unpacked\, and at its target. Line: path of its centre.}
//!
//! - How are strengths and exponents found, and what do they owe to the start and to the size of the swarm?
//!   @subpage ch06_designs
//! - What does the swarm do on its way, and does every design do it? @subpage ch06_captions
//! - Why does it come to rest? @subpage ch06_drag
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch06_swarm
//! build/release/bin/ch06_swarm --out ch06 --threads 2
//! @endverbatim
//!
//! On two threads that takes a minute or two, with `--quick` some twenty seconds.
//!
//! @section ch06_model Members, obstacles, a target
//!
//! @figure{ch06_interactions, What acts on a member: other members\, which attract from afar and repel from near by\, obstacles\, and the target. Figure 6.1.}
//!
//! The monograph writes \f$ m_i \dot v_i = \Psi_i^{mm} + \Psi_i^{mo} + \Psi_i^{mt} \f$. With \f$ d \f$ the distance
//! and \f$ n \f$ the unit vector from a member to what acts on it, our forms, a *reconstruction* (@ref provenance
//! "mark R 6.1"), are
//!
//! \f[ \frac{\Psi_i^{mm}}{m_i} = \frac1N \sum_{j \ne i} \left(\alpha_1 d_{ij}^{\beta_1} - \alpha_2 d_{ij}^{-\beta_2}
//!     \right) n_{ij}, \qquad
//!     \frac{\Psi_i^{mo}}{m_i} = -\sum_k \alpha_o\, d_{ik}^{-\beta_o}\, n_{ik}, \qquad
//!     \frac{\Psi_i^{mt}}{m_i} = \alpha_t\, d_i^{\beta_t}\, n_i . \f]
//!
//! Attraction among members grows with their distance, otherwise than in a near field: who strays is called back. The
//! sum is divided by \f$ N \f$, so that a design that was found for few members may be tried on many. Three things are
//! added, which the forces alone would not give:
//!
//! - a linear drag \f$ -c_d\, v_i \f$ per unit mass (particulate::swarm::LinearDrag), without which nothing could come
//!   to rest: @ref ch06_drag shows what happens then;
//! - a largest speed. At the end of a step who is faster is slowed down to it (particulate::swarm::SpeedLimit), and the
//!   energy that this takes is counted;
//! - loss. A member whose step ends inside an obstacle is lost: it stays there, acts on nobody, and is counted at its
//!   place (particulate::swarm::Flight).
//!
//! @section ch06_start The start
//!
//! @figure{ch06_start, The start: from the side\, and from the target\, through the fence. Grey: obstacles in their true size. Cross: target. Figure 6.2.}
//!
//! Nine obstacles of radius 0.5 m make the fence, at \f$ (5, 2i, 2j) \f$, \f$ i, j = -1, 0, 1 \f$, with the monograph's
//! centre obstacle among them. The target is at \f$ (10, 0, 0) \f$ behind it, and the centre obstacle is in the way.
//! Members start at rest, evenly at random in a cube of 2 m about \f$ (0, 0, -1) \f$.
//!
//! @section ch06_program The program
//!
//! The parameters, and what the pages share, stand on @subpage ch06_shared.

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/kinematics/starts.hpp>
#include <particulate/laws/near_field.hpp>

#include "ch06_swarm.hpp"

namespace ch06 {

void validate(const Parameters& p) { identification::validate(algorithm_of(p)); }

identification::GeneticAlgorithm algorithm_of(const Parameters& p) {
  return {.S = p.S, .K = p.K, .threads = p.line.common().threads};
}

Course course_of(const Parameters& p) {
  Course course = fence();
  course.c_d = p.c_d;
  course.v_max = p.v_max;
  course.duration = p.duration;
  course.step = p.step;
  return course;
}

//! Members are points of unit mass: whatever their mass, they fly alike. Their places are drawn apart from the strings
//! of the algorithm, which begins with the same seeds.

namespace {

kinematics::Particles start_of(int members, std::uint64_t seed) {
  boost::random::mt19937_64 engine(300 + seed);
  boost::random::uniform_01<double> uniform;
  const kinematics::Box cube{.lengths = {2.0, 2.0, 2.0}, .corner = {-1.0, -1.0, -2.0}};
  kinematics::Particles swarm{.position = {},
                              .velocity = kinematics::Vectors::Zero(members, 3),
                              .mass = Eigen::VectorXd::Ones(members),
                              .radius = Eigen::VectorXd::Zero(members)};
  swarm.position = kinematics::random_addition(swarm.radius, {.box = cube}, [&] { return uniform(engine); }).position;
  return swarm;
}

}  // namespace

std::vector<kinematics::Particles> starts_of(int members, std::uint64_t first, int count) {
  std::vector<kinematics::Particles> starts;
  for (int k = 0; k < count; ++k) starts.push_back(start_of(members, first + static_cast<std::uint64_t>(k)));
  return starts;
}

void write_course(const Course& course, const report::Output& output) {
  report::Table places({"what", "x [m]", "y [m]", "z [m]", "radius [m]"});
  for (std::size_t k = 0; k < course.obstacles.size(); ++k) {
    const Eigen::Vector3d& at = course.obstacles[k];
    places.add({"obstacle", at.x(), at.y(), at.z(), course.radii[k]});
  }
  places.add({"target", course.target.x(), course.target.y(), course.target.z(), 0.0});
  output.write("course", places);
}

//! A run with the chapter's own numbers is one that was given none:

void claim_of_own(const Parameters& p, report::Chapter& chapter, const std::string& claim, double error,
                  double allowed) {
  if (p.line.has_defaults()) return chapter.claims("checks").add(claim, error, allowed);
  chapter.note(fmt::format("{}: {:.3g}; with the chapter's own numbers at most {:.3g}.", claim, error, allowed));
}

void run(const Parameters& p, report::Chapter& chapter) {
  write_course(course_of(p), chapter.output());
  const std::vector<Tuned> best = designs(p, chapter);
  captions(p, best, chapter);
  drag(p, best, chapter);
}

}  // namespace ch06

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch06_swarm",
                              .summary = "Chapter 6: swarms that pass a fence to a target, and how they are designed.",
                              .out = "ch06",
                              .figures = "chapters/ch06_swarm/figures.gp"},
                             laws::name(laws::best_kernel()), ch06::run);
}

//! @section ch06_cost What a flight costs
//!
//! Nearly all of it are the sums over pairs and obstacles, which the near field's kernels form
//! (@ref verify_ch06_flight_over_its_sums "the rows"):
//!
//! @table{ch06_flight_over_its_sums}
//!
//! What a swarm leaves out costs nothing, and what it has but does not use hardly anything. Instructions counted with 64
//! members, where 2016 pairs take most (@ref verify_ch06_swarm_cost "the rows"):
//!
//! @table{ch06_swarm_cost}
//!
//! @section ch06_results What held
//!
//! @table{ch06_checks}
//!
//! @table{ch06_summary}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch06}
//!
//! @section ch06_exercises Exercises
//!
//! 1. Midway between two obstacles of the fence, what force of these two does a member feel? What pushes the swarm down,
//!    and not up or aside?
//! 2. Start the swarm about \f$ (0, 0, 0) \f$: change the corner in `start_of`. Which way does it choose, and does every
//!    seed choose the same?
//! 3. Take the sum over members without \f$ 1/N \f$, and try a design for 32 on 128 members.
//! 4. Take `--v_max 3.5` and 2.5. What does the cap take, and what the drag?
//! 5. Give each member a mass of its own. Which of the forces then no longer let all fly alike?
