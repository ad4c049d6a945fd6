// What a flight costs beside the sums of its forces.

#include <algorithm>
#include <ctime>
#include <vector>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/report/table.hpp>

#include "swarms.hpp"

namespace verification::flight_races {

using namespace particulate;

// Of the processor, so that what else a machine does is not counted.
double seconds_of(const auto& run) {
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Times {
  double flight = infinite, sums = infinite;  // the least of some, in turn [s]
};

// A flight of 750 steps with its losses, its drag, its limit and its objective; and the sums over pairs and obstacles
// at the same 750 places.
Times times_of(Eigen::Index N, int repeats) {
  const swarm::Course course = swarm::fence();
  const kinematics::Particles start = swarm_at_rest(N, 1);
  std::vector<schemes::State> places{{.t = 0.0, .r = start.position.reshaped(), .v = start.velocity.reshaped()}};
  (void)swarm::fly(passing, course, start, [&](const schemes::State& swarm) { places.push_back(swarm); });
  places.pop_back();
  const scenes::Scene sums(start, kinematics::Space{}, members_law(passing, start.mass.sum()),
                           obstacles_of(course, passing));
  Eigen::VectorXd force(3 * N);
  Times least;
  bool has_value = places.size() == 750;
  for (int k = 0; k < repeats; ++k) {
    least.flight = std::min(least.flight, seconds_of([&] { (void)swarm::fly(passing, course, start); }));
    least.sums = std::min(least.sums, seconds_of([&] {
                            for (const schemes::State& at : places)
                              has_value = sums.total_force(at, force) && has_value;
                          }));
  }
  return has_value ? least : Times{missing, missing};
}

const Case flight{
    {.name = "flight_over_its_sums",
     .claim = "a flight of 128 members takes at most twice as long as its sums over pairs and obstacles alone",
     .equation = "R 6.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      report::Table table({"members", "flight of 750 steps [s]", "its sums alone [s]", "ratio"});
      double ratio = missing;
      for (const Eigen::Index N : {8, 32, 128}) {
        const Times taken = times_of(N, rows.quick() ? 5 : 15);
        ratio = taken.flight / taken.sums;
        table.add({N, taken.flight, taken.sums, ratio});
      }
      rows.at_most("128 members: flight over its sums",
                   {.limit = 2.0,
                    .computed = ratio,
                    .because = "what is not a sum is of order N; the least of a few, in turn, in one run"});
      rows.write("flight_over_its_sums", table);
    }};

}  // namespace verification::flight_races
