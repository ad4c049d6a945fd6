//! @page ch06_shared Chapter 6: What its pages share
//! @brief The parameters of the chapter, how a design is tuned, and what is watched of a flight.
//! @tableofcontents
//!
//! @section ch06_parameters Parameters
//!
//! Of the monograph's swarm, captions tell the number of members, the centre obstacle and the target. S and K are those
//! of the algorithm of chapter 5. All other numbers are our choice.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/swarm/design.hpp>

namespace ch06 {

using namespace particulate;
using namespace particulate::swarm;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  int& members = line.field(128, {"members", "of the swarm that flies; with --quick it is tuned on half as many", "-",
                                  between(64, 160), "6.3"});
  int& seeds = line.field(5, {"seeds", "of the algorithm for each size of swarm", "-", between(5, 8), ours});
  int& starts = line.field(3, {"starts", "that one design is averaged over", "-", between(2, 5), ours});
  int& others = line.field(
      10, {"others", "starts that a design is flown from besides, half with --quick", "-", between(5, 20), ours});
  int& S = line.field(20, {"strings", "of the genetic algorithm, S", "-", between(20, 30), "R 5.1"});
  int& K = line.field(6, {"parents", "that it keeps, K, even", "-", between(4, 8), "R 5.1"});
  int& generations =
      line.field(30, {"generations", "of a search, two fifths with --quick", "-", between(20, 40), ours});
  double& c_d = line.field(1.0, {"c_d", "drag per unit mass", "1/s", between(0.8, 1.2), ours});
  double& v_max = line.field(3.0, {"v_max", "the largest speed", "m/s", between(2.5, 3.5), ours});
  double& duration = line.field(15.0, {"duration", "of a flight, T", "s", between(14.0, 18.0), ours});
  double& step = line.field(0.02, {"step", "of a flight, Dt", "s", between(0.01, 0.025), ours});
};

//! What no algorithm can be made of, such as an odd number of parents, is refused before anything is written:

void validate(const Parameters& p);

identification::GeneticAlgorithm algorithm_of(const Parameters& p);
Course course_of(const Parameters& p);

//! Starts are numbered by their seeds: designs are tuned on the first ones, and tried on others.

std::vector<kinematics::Particles> starts_of(int members, std::uint64_t first, int count);

//! @section ch06_tuned Designs that were tuned

struct Tuned {
  int members, starts;
  std::uint64_t seed;  // of the algorithm
  Design design = {};
  double cost = NAN;
  std::vector<double> best = {}, mean = {};  // by generation: the best string, and the mean of the best six
  long evaluations = 0;
  double seconds = 0.0;
};

Tuned tune(const Parameters& p, const Course& course, int members, int starts, std::uint64_t seed);

//! @section ch06_seen What is watched of a flight
//!
//! The centre and the radius of gyration \f$ \sqrt{\tfrac1N \sum_i |r_i - \bar r|^2} \f$ say where the swarm is and how
//! large; what drag and cap take is counted step by step.

struct Moment {
  double t;
  Eigen::Vector3d centre;
  double gyration;            // [m]
  double distance;            // of the members from the target, mean [m]
  double kinetic, drag, cap;  // energy now, taken by the drag and by the cap so far, all per mass [J/kg]
};

// What the captions tell of a flight; NaN, but for the distance, where the centre never passed the fence.
struct Captions {
  double height = NAN;                       // of the centre in the plane of the fence [m]
  double bunched = NAN, unpacked = NAN;      // least gyration before the fence, largest after it [m]
  double overshoot = NAN, undershoot = NAN;  // of the centre, along x [m]
  double distance = NAN;                     // of the members from the target at the end, mean [m]
};

struct Seen {
  Trial trial;
  std::vector<Moment> moments;  // the start, and the end of every step
  // Numbers of the moments that the captions are about, in their order; all 0 where there are none.
  std::size_t bunched = 0, passed = 0, unpacked = 0, over = 0, under = 0;
  Captions captions;
};

Seen watch(const Design& design, const Course& course, const kinematics::Particles& start, const Watcher& also = {});

//! A page is a function. It writes its tables and adds what it claims.

std::vector<Tuned> designs(const Parameters& p, report::Chapter& chapter);
void captions(const Parameters& p, const std::vector<Tuned>& designs, report::Chapter& chapter);
void drag(const Parameters& p, const std::vector<Tuned>& designs, report::Chapter& chapter);

//! Some of what the captions tell every swarm does that we have seen, and that is claimed of any. The rest depends on
//! the start and on luck: it is claimed of the chapter's own numbers and seed. With others a run says what came of it.

void claim_of_own(const Parameters& p, report::Chapter& chapter, const std::string& claim, double error,
                  double allowed);

}  // namespace ch06
