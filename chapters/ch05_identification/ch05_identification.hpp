//! @page ch05_shared Chapter 5: What its pages share
//! @brief The parameters of the chapter, and the clouds whose near field is to be found.
//! @tableofcontents
//!
//! @section ch05_parameters Parameters
//!
//! Values marked 4.1 are believed to be those of the monograph's simulations. Of this chapter's own numbers none were
//! at hand: S and K are those of the algorithm as its author has published it elsewhere, all others are our choice.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/identification/history_cost.hpp>
#include <particulate/kinematics/central_force.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/report/chapter.hpp>

namespace ch05 {

using namespace particulate;
using namespace particulate::identification;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& alpha1 =
      line.field(0.5, {"alpha1", "strength of attraction, to be found", "N m^beta1/kg^2", between(0.3, 0.8), "4.1"});
  double& alpha2 = line.field(0.25, {"alpha2", "of repulsion, likewise", "N m^beta2/kg^2", between(0.15, 0.5), "4.1"});
  double& beta1 = line.field(1.0, {"beta1", "exponent of attraction, likewise", "-", between(0.5, 1.5), "4.1"});
  double& beta2 = line.field(2.0, {"beta2", "of repulsion, likewise", "-", between(1.75, 2.5), "4.1"});
  int& particles =
      line.field(60, {"particles", "spheres of a measured cloud, a third with --quick", "-", between(24, 90), ours});
  int& starts = line.field(5, {"starts", "measured clouds, each with a start of its own", "-", between(2, 8), ours});
  double& duration = line.field(0.5, {"duration", "of what is measured", "s", between(0.3, 0.8), ours});
  double& noise = line.field(0.01, {"noise", "a share of each value measured", "-", between(1e-3, 0.02), ours});
  int& few =
      line.field(20, {"few", "spheres of clouds computed often, two fifths with --quick", "-", between(15, 40), ours});
  double& longer =
      line.field(2.0, {"longer", "the other duration of a cost that is drawn", "s", between(1.0, 2.5), ours});
  int& map = line.field(48, {"map", "points along its edge, half with --quick", "-", between(24, 80), ours});
  int& S = line.field(20, {"strings", "of the genetic algorithm, S", "-", between(20, 40), "R 5.1"});
  int& K = line.field(6, {"parents", "that it keeps, K, even", "-", between(2, 10), "R 5.1"});
  int& generations = line.field(40, {"generations", "of a run, half with --quick", "-", between(20, 80), ours});
  int& runs = line.field(31, {"runs", "of each variant, a sixth with --quick", "-", between(12, 62), ours});
};

//! What no algorithm can be made of, such as an odd number of parents, is refused before anything is written:

void validate(const Parameters& p);

GeneticAlgorithm algorithm_of(const Parameters& p);

//! @section ch05_strings Strings
//!
//! A set of parameters is a *string*, \f$ \Lambda = (\ln\alpha_1, \ln\alpha_2, \beta_1, \beta_2) \f$: strengths by
//! their logarithms, since of them one knows the order of magnitude, if anything.

Eigen::VectorXd truth_of(const Parameters& p);
kinematics::CentralForce law_of(const Eigen::VectorXd& string);
Box box_of_search();

//! @section ch05_clouds Measured clouds
//!
//! What stands for a measurement is computed with strengths and exponents that we know: whatever is not found again is
//! then the fault of the search, or of what was measured. The seeds of the clouds follow each other, so that the next
//! one is a start that no fit has seen.

struct Clouds {
  int particles, starts;
  double duration;     // [s]
  std::uint64_t seed;  // of the first
};

std::vector<double> moments(double duration);
HistoryModel model_of(const Clouds& clouds);
Eigen::MatrixXd histories_of(const HistoryModel& model, int starts, const Eigen::VectorXd& string);

// Of the clouds that are computed often, without noise.
Clouds few_of(const report::Chapter& chapter, const Parameters& p, double duration);
HistoryCost exact_cost(const Parameters& p, const Clouds& clouds);

//! A page is a function. It writes its tables and adds what it claims.

void landscapes(const Parameters& p, report::Chapter& chapter, report::Checks& checks);
void searches(const Parameters& p, report::Chapter& chapter, report::Checks& checks);
void identify(const Parameters& p, report::Chapter& chapter, report::Checks& checks);

}  // namespace ch05
