// Histories that say nothing of parameters, and are refused as targets.

#include <cmath>
#include <string>
#include <vector>

#include <ch04_simulations/clouds.hpp>
#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

#include "fits.hpp"

namespace verification::identification_targets {

using namespace particulate;
using namespace particulate::identification;

// Column `column` of the history of an isolated cloud: 1 its bulk energy, 2 the relative one.
Target energy_of_cloud(Eigen::Index column) {
  const std::vector<double> times = moments(0.5, 20);
  const scenes::Scene scene(book_cloud(50, 1), kinematics::Space{}, weak_near_field);
  scenes::History history(scene, times);
  schemes::State state = scenes::start(scene);
  require_reached(schemes::integrate(scene, state, times.back(), schemes::Collocation<schemes::Gauss<4>>(),
                                     schemes::ErrorControl{.TOL = 1e-6}, history));
  return {.name = history.columns()[static_cast<std::size_t>(column)],
          .times = times,
          .values = history.rows().col(column)};
}

const Case targets{
    {.name = "targets_that_say_nothing",
     .claim = "a target that says nothing of the parameters is refused, with the reason and what to do",
     .equation = "R 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      const auto refuse = [&](const std::string& name, const std::string& key_words, const auto& change) {
        rows.must_be_refused(name, key_words, [&] {
          Target target = energy_of_cloud(2);
          change(target);
          validate(target);
          return accepted();
        });
      };
      refuse("the bulk energy of an isolated cloud", "bulk must vary constant relative energy",
             [](Target& target) { target = energy_of_cloud(1); });
      refuse("an empty target", "relative two times 0", [](Target& target) { target.times.clear(); });
      refuse("a target of zeros", "zero throughout", [](Target& target) { target.values.setZero(); });
      refuse("a target that is no number", "finite", [](Target& target) { target.values(3, 0) = not_a_number; });
      refuse("a target whose times do not rise", "times rise",
             [](Target& target) { target.times[3] = target.times[2]; });
      refuse("a negative weight", "weight negative -1", [](Target& target) { target.weight = -1.0; });
      rows.must_be_solved("the relative energy of an isolated cloud", [] {
        const Target target = energy_of_cloud(2);
        const HistoryModel itself = [&](const auto&, Eigen::Index) -> Simulated {
          return {.histories = {{target.times, target.values}}};
        };
        return Ending::solved({.error = HistoryCost({target}, itself)(Eigen::VectorXd::Zero(1)).cost,
                               .tolerance = 0.0,
                               .because = "it is its own simulation"});
      });
    }};

}  // namespace verification::identification_targets
