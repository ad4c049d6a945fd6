//! @page ch05_identification Chapter 5: Inverse problems
//! @brief Which near field makes a cloud move as it was seen to move, how one finds it, and how sure one may be.
//! @tableofcontents
//!
//! @section ch05_question The question, backwards
//!
//! Chapter 4 of the monograph @cite zohdi2007 computes a motion from a near field. Chapter 5 turns that round: the
//! motion was seen, and the near field is wanted. Since nobody can solve for it, one guesses, simulates, and calls it a
//! *cost* how far the guess was off; what remains is to make the cost small.
//!
//! @figure{ch05_history, Relative energy of a cloud that no fit has seen: what it does\, what it does by the near field that was found\, and by the best of the first strings: Figure 5.3.}
//!
//! - What does such a cost look like? @subpage ch05_landscapes
//! - How does the monograph's genetic algorithm make it small, where does it stop, and what helps? @subpage ch05_search
//! - Which near field comes out, how sure is each of its numbers, and does it foretell? @subpage ch05_errors
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch05_identification
//! build/release/bin/ch05_identification --out ch05
//! @endverbatim
//!
//! That takes some minutes, with `--quick` some ten seconds.
//!
//! @section ch05_cost The cost
//!
//! With \f$ A \f$ a history of the simulation and \f$ A^* \f$ the one that was seen, from each of \f$ R \f$ starts,
//!
//! \f[ \Pi(\Lambda) = \frac1R \sum_{r=1}^R \frac{\int_0^T |A_r(\Lambda) - A_r^*|\,dt}{\int_0^T |A_r^*|\,dt} . \f]
//!
//! That is particulate::identification::HistoryCost, and what this chapter does is a *reconstruction*: the monograph's
//! own text of it was not at hand, so cost, bounds and numbers are ours, and the algorithm follows what its author has
//! published elsewhere (@ref provenance "mark R 5.1").
//!
//! As history we take the kinetic energy per mass *about the centre of the cloud*. The monograph's other energy, that
//! of the bulk, would be no target at all: nothing in the cloud can change it, so every near field repeats it. A
//! library that took it would give back some near field, with a cost of zero; ours refuses, and the run that made these
//! pages was told
//!
//! @table{ch05_refusal}
//!
//! There are no contacts here. They make a cost jump wherever an impact more or less happens
//! (@ref verify_ch05_contacts_make_the_cost_jump); the algorithm does not mind, but then no derivative means anything.
//!
//! @section ch05_program The program
//!
//! The parameters, and what the pages share, stand on @subpage ch05_shared.

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/kinematics/starts.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch05_identification.hpp"

namespace ch05 {

void validate(const Parameters& p) { identification::validate(algorithm_of(p)); }

GeneticAlgorithm algorithm_of(const Parameters& p) { return {.S = p.S, .K = p.K, .threads = p.line.common().threads}; }

Eigen::VectorXd truth_of(const Parameters& p) {
  return Eigen::Vector4d(std::log(p.alpha1), std::log(p.alpha2), p.beta1, p.beta2);
}

kinematics::CentralForce law_of(const Eigen::VectorXd& string) {
  return {.alpha1 = std::exp(string[0]), .alpha2 = std::exp(string[1]), .beta1 = string[2], .beta2 = string[3]};
}

//! Strings are sought within a decade or more of each strength. What repels must do so more steeply than what attracts:
//! other strings are drawn again.

Box box_of_search() {
  return {.lower = Eigen::Vector4d(std::log(0.1), std::log(0.05), 0.0, 1.0),
          .upper = Eigen::Vector4d(0.0, 0.0, 2.0, 3.0),
          .allows = [](const Eigen::VectorXd& string) { return string[3] > string[2]; }};
}

//! The start is chapter 4's: spheres at random in a cube of one metre, as small as \f$ L = b/V^{1/3} = 0.25 \f$ says,
//! of 2000 kg/m^3, with velocities of \f$ (1, 0.1, 0.1) \f$ m/s and as much again at random.

kinematics::Particles cloud_of(int count, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_01<double> uniform;
  const double b = 0.25 / std::cbrt(count), mass = 2000.0 * 4.0 / 3.0 * std::numbers::pi * b * b * b;
  kinematics::Particles cloud{.position = {},
                              .velocity = kinematics::Vectors(count, 3),
                              .mass = Eigen::VectorXd::Constant(count, mass),
                              .radius = Eigen::VectorXd::Constant(count, b)};
  cloud.position = kinematics::random_addition(cloud.radius, {}, [&] { return uniform(engine); }).position;
  const Eigen::Vector3d mean{1.0, 0.1, 0.1};
  for (double& v : cloud.velocity.reshaped()) v = 2.0 * uniform(engine);
  cloud.velocity *= mean.asDiagonal();
  return cloud;
}

laws::NearField near_field_of(const Eigen::VectorXd& string) {
  const kinematics::CentralForce law = law_of(string);
  return {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2};
}

std::vector<double> moments(double duration) {
  std::vector<double> all;
  for (int k = 1; k <= 20; ++k) all.push_back(duration * k / 20);
  return all;
}

//! Strings that let the cloud collapse ask for ever smaller steps. Beyond 200 steps in a second a string has no value,
//! which is no mishap: the algorithm ranks it last, and counts it.

HistoryModel model_of(const Clouds& clouds) {
  std::vector<kinematics::Particles> all;
  for (int k = 0; k < clouds.starts; ++k) {
    all.push_back(cloud_of(clouds.particles, clouds.seed + static_cast<std::uint64_t>(k)));
  }
  const HistoryRun run{.most_steps = static_cast<long>(200.0 * clouds.duration)};
  return [all, run, times = moments(clouds.duration)](const Eigen::VectorXd& string, Eigen::Index start) {
    const scenes::Scene scene(all[static_cast<std::size_t>(start)], kinematics::Space{}, near_field_of(string));
    return relative_energy_history(scene, times, run);
  };
}

Eigen::MatrixXd histories_of(const HistoryModel& model, int starts, const Eigen::VectorXd& string) {
  Eigen::MatrixXd all(20, starts);
  for (int start = 0; start < starts; ++start) {
    const Simulated simulated = model(string, start);
    if (!simulated.reason.empty())
      throw std::runtime_error("what should be measured has no value: " + simulated.reason);
    all.col(start) = simulated.histories.front().values;
  }
  return all;
}

Clouds few_of(const report::Chapter& chapter, const Parameters& p, double duration) {
  const report::Common& common = chapter.common();
  return {.particles = common.quick ? 2 * p.few / 5 : p.few, .starts = 3, .duration = duration, .seed = common.seed};
}

HistoryCost exact_cost(const Parameters& p, const Clouds& clouds) {
  const HistoryModel model = model_of(clouds);
  return HistoryCost({{.name = "relative energy [J/kg]",
                       .times = moments(clouds.duration),
                       .values = histories_of(model, clouds.starts, truth_of(p))}},
                     model);
}

//! The bulk energy, as a target, is asked for once:

void refuse_bulk_energy(const Parameters& p, report::Chapter& chapter, report::Checks& checks) {
  const scenes::Scene scene(cloud_of(p.few, chapter.common().seed), kinematics::Space{}, near_field_of(truth_of(p)));
  const std::vector<double> times = moments(p.duration);
  scenes::History history(scene, times);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome outcome = schemes::integrate(scene, state, times.back(), schemes::VelocityVerlet{},
                                                      schemes::FixedStep{.step = 1e-3}, history);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
  report::Table refusal({"refused"});
  try {
    validate(Target{.name = "bulk energy [J/kg]", .times = times, .values = history.rows().col(1)});
  } catch (const std::invalid_argument& refused) { refusal.add({refused.what()}); }
  chapter.output().write("refusal", refusal);
  checks.add("bulk energy is no target: refusals, less one", static_cast<double>(refusal.rows().size()) - 1.0, 0.0);
}

void run(const Parameters& p, report::Chapter& chapter) {
  report::Checks& checks = chapter.claims("checks");
  refuse_bulk_energy(p, chapter, checks);
  landscapes(p, chapter, checks);
  searches(p, chapter, checks);
  identify(p, chapter, checks);
}

}  // namespace ch05

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(
      argc, argv,
      {.name = "ch05_identification",
       .summary = "Chapter 5: the near field of a cloud, found from how it moved, and how surely.",
       .out = "ch05",
       .figures = "chapters/ch05_identification/figures.gp"},
      laws::name(laws::best_kernel()), ch05::run);
}

//! @section ch05_results What held
//!
//! @table{ch05_checks}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch05}
//!
//! @section ch05_exercises Exercises
//!
//! 1. Why is the cost not zero at the true string, once there is noise? Which value would you expect there?
//! 2. Take `--duration 0.8`. Which error bars shrink most, and does the search still find the near field?
//! 3. Take `--seed 2` to 6. How often does the plain algorithm end in the same place, and how often a polished one?
//! 4. In \f$ (\ln\alpha_1, \ln\alpha_2, \beta_1, \beta_2) \f$ the weakest direction moves all four at once. Show that
//!    it leaves \f$ d_e \f$ and \f$ V''(d_e) \f$ almost alone.
//! 5. What would have to be measured besides, so that \f$ \alpha_1 \f$ becomes sure? Try a denser cloud: change
//!    \f$ L \f$ in `cloud_of`.
