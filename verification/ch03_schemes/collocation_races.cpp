#include "collocation_races.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/schemes/fixed_sweeps.hpp>

namespace verification {
namespace collocation_races {

// By sweeps through the stages in turn.
template <class Control>
Begin gauss(int stages, const schemes::CollocationSettings& settings, const Control& control) {
  using schemes::Collocation, schemes::Gauss;
  switch (stages) {
    case 4:
      return under(Collocation<Gauss<4>>(settings), control);
    case 8:
      return under(Collocation<Gauss<8>>(settings), control);
    default:
      throw std::invalid_argument(fmt::format("Gauss collocation races with 4 or 8 stages, got {}", stages));
  }
}

Begin gauss_at_fixed_step(int stages, int sweeps) {
  return gauss(stages, {}, [sweeps](double step) { return schemes::FixedSweeps{.step = step, .sweeps = sweeps}; });
}

// What is chosen for an adaptive collocation method, other than its tolerance.
struct Choice {
  int stages;            // s
  double share = 1.0;    // tolerance of the sweeps over that of the step [-]
  double growth = 3.0;   // largest, from step to step [-]
  double first = 0.125;  // the first step, of the run [-]
};

// The setting is TOL; the race tells the sizes of positions and velocities, and how long the run is.
Begin gauss_under_control(const Choice& choice, const Race& race) {
  const double T = race.outputs.back();
  return gauss(choice.stages, {.size = race.length, .speed = race.speed, .sizes = {}}, [choice, T](double tolerance) {
    return schemes::ErrorControl{.TOL = tolerance,
                                 .sweep_TOL = std::max(choice.share * tolerance, 2.3e-16),
                                 .step = choice.first * T,
                                 .limit = T,
                                 .safety = 0.7,
                                 .growth = choice.growth};
  });
}

}  // namespace collocation_races

Begin radau(int stages, const schemes::CollocationSettings& settings,
            const std::function<schemes::ErrorControl(double)>& control) {
  using schemes::Collocation, schemes::Newton, schemes::Radau;
  switch (stages) {
    case 3:
      return under(Collocation<Radau<3>, Newton<>>(settings), control);
    case 5:
      return under(Collocation<Radau<5>, Newton<>>(settings), control);
    default:
      throw std::invalid_argument(fmt::format("Radau collocation races with 3 or 5 stages, got {}", stages));
  }
}

std::vector<Competitor> by_collocation(const Race& race, const Steps& steps, double tightest) {
  using namespace collocation_races;
  constexpr Choice few_stages{.stages = 4, .share = 1.0, .growth = 1.5}, many_stages{.stages = 8, .share = 1e3};
  const std::vector<double> TOL = tolerances(tightest, 1.0);
  std::vector<Competitor> all{tuned(competitor("Gauss 4", race, TOL, gauss_under_control(few_stages, race))),
                              tuned(competitor("Gauss 8", race, TOL, gauss_under_control(many_stages, race)))};
  if (steps.first == 0) return all;
  const std::vector<double> sizes = step_sizes(race.outputs.front(), steps);
  all.push_back(tuned(competitor("Gauss 4, 2 sweeps", race, sizes, gauss_at_fixed_step(4, 2))));
  all.push_back(tuned(competitor("Gauss 8, 3 sweeps", race, sizes, gauss_at_fixed_step(8, 3))));
  return all;
}

}  // namespace verification
