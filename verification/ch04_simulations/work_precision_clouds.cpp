// Error against run time of a cloud's relative energy, the mean of several starts: stepped contacts and located ones,
// and without near field the gas of hard spheres.

#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <harness/case.hpp>
#include <harness/competitors.hpp>
#include <harness/races.hpp>
#include <harness/replay.hpp>
#include <particulate/contact/hard_spheres.hpp>

#include "relative_energy.hpp"

namespace verification::work_precision_clouds {

using namespace particulate;

constexpr Eigen::Index N = 60;
constexpr double t_end = 0.3;

std::vector<double> numbers_of(const schemes::State& state) {
  const Eigen::VectorXd all = schemes::flat(state);
  return {all.begin(), all.end()};
}

// One competitor's clouds, and what it found last.
template <class Scene, class Run>
struct Lane {
  std::vector<Scene> clouds;
  Run run;  // (problem, cloud, setting) -> MeanOfRun
  double setting, truth;
  std::vector<Replay> tapes = std::vector<Replay>(clouds.size());
  double mean = missing;

  Counts follow(bool hooked) {
    Counts counts;
    mean = 0.0;
    for (std::size_t k = 0; k < clouds.size(); ++k) {
      const schemes::Problem cloud(clouds[k]);
      const MeanOfRun one = run(hooked ? cloud.with(tapes[k]) : cloud, clouds[k], setting);
      mean += one.energy / static_cast<double>(clouds.size());
      counts.evaluations += one.outcome.evaluations;
      counts.iterations += one.outcome.sweeps;
    }
    return counts;
  }
  Counts replay() {
    for (Replay& tape : tapes) tape.rewind();
    return follow(true);
  }
  Task task() const {
    const schemes::State start = scenes::start(clouds.front());
    schemes::Rates rates;
    if (!schemes::Problem(clouds.front()).rates(start, rates)) rates.a.setConstant(missing);
    return {.start = numbers_of(start), .rate = {rates.a.begin(), rates.a.end()}, .outputs = {t_end}};
  }
};

template <class Make, class Run>
Competitor clouds_by(std::string name, const Make& make, std::vector<double> settings, const Run& run,
                     const std::vector<std::uint64_t>& seeds, double truth) {
  using Scene = decltype(make(N, std::uint64_t{}));
  const auto prepare = [=](double setting) {
    std::vector<Scene> clouds;
    for (const std::uint64_t seed : seeds) clouds.push_back(make(N, seed));
    const auto lane = std::make_shared<Lane<Scene, Run>>(
        Lane<Scene, Run>{.clouds = std::move(clouds), .run = run, .setting = setting, .truth = truth});
    (void)lane->follow(true);
    return Prepared{.task = lane->task(),
                    .run = [=] { return lane->follow(false); },
                    .errors =
                        [=] {
                          const double error = std::abs(lane->mean - lane->truth) / lane->truth;
                          return Errors{.end = error, .max = error};
                        },
                    .replay = [=] { return lane->replay(); }};
  };
  return {.name = std::move(name), .settings = std::move(settings), .prepare = prepare};
}

template <class Scene, class S, class C>
MeanOfRun follow(const schemes::Problem& problem, const Scene& cloud, S scheme, C control) {
  return mean_of_run(problem, cloud.particles().mass, scenes::start(cloud), t_end, scheme, control);
}

template <int S>
MeanOfRun located(const schemes::Problem& problem, const auto& cloud, double tolerance) {
  return follow(problem, cloud, schemes::Collocation<schemes::Gauss<S>>(),
                schemes::ErrorControl{.TOL = tolerance, .sweep_TOL = 0.1 * tolerance, .limit = 0.05});
}

// Case (1) of chapter 4: without near field.
template <class Contact>
auto forceless(Eigen::Index n, std::uint64_t seed) {
  return scenes::Scene(book_cloud(n, seed), kinematics::Space{}, Contact{.restitution = {0.5}});
}

// The same as a gas, whose relative energy is constant from impact to impact.
struct GasLane {
  std::vector<contact::HardSpheres<>> clouds = {};
  double truth = 0.0, mean = missing;
  long impacts = 0;

  Counts follow() {
    Counts counts;
    mean = 0.0, impacts = 0;
    for (contact::HardSpheres<>& cloud : clouds) {
      schemes::State state = start(cloud);
      double taken = 0.0;  // in the mean over the time
      const schemes::Outcome outcome = cloud.advance(
          state, t_end, [&](const contact::Collision& one) { taken -= one.energy_change * (t_end - one.t) / t_end; });
      require_reached(outcome);
      const Eigen::VectorXd& mass = cloud.particles().mass;
      const double before = kinematics::split_kinetic_energy(mass, cloud.particles().velocity).relative;
      mean += (before - taken / mass.sum()) / static_cast<double>(clouds.size());
      counts.evaluations += cloud.tally().predictions;
      impacts += outcome.impacts;
    }
    return counts;
  }
};

GasLane gas_lane(const std::vector<std::uint64_t>& seeds) {
  GasLane lane;
  for (const std::uint64_t seed : seeds) {
    lane.clouds.emplace_back(book_cloud(N, seed), kinematics::Space{}, contact::ConstantRestitution{0.5});
  }
  return lane;
}

// It has no setting, and no right-hand side: instead of these the bodies are counted whose next impact was predicted.
Competitor by_gas(const std::vector<std::uint64_t>& seeds, double truth) {
  const auto prepare = [=](double) {
    const auto lane = std::make_shared<GasLane>(gas_lane(seeds));
    return Prepared{.task = {.start = numbers_of(start(lane->clouds.front())),
                             .rate = std::vector<double>(3 * N, 0.0),
                             .outputs = {t_end}},
                    .run = [=] { return lane->follow(); },
                    .errors =
                        [=] {
                          const double error = std::abs(lane->mean - truth) / truth;
                          return Errors{.end = error, .max = error};
                        },
                    .replay = [=] { return lane->follow(); }};
  };
  return {.name = "hard spheres (counted: predictions)", .settings = {1.0}, .prepare = prepare};
}

std::vector<std::uint64_t> some_seeds(int count) {
  std::vector<std::uint64_t> seeds(static_cast<std::size_t>(count));
  std::iota(seeds.begin(), seeds.end(), 100);
  return seeds;
}

std::vector<double> halved_steps(int count) {
  std::vector<double> steps;
  for (int k = 0; k < count; ++k) steps.push_back(std::ldexp(4e-3, -k));
  return steps;
}

const auto by_verlet = [](const schemes::Problem& problem, const auto& cloud, double step) {
  return follow(problem, cloud, schemes::VelocityVerlet(), schemes::FixedStep{.step = step});
};
const auto by_gauss = [](const schemes::Problem& problem, const auto& cloud, double tolerance) {
  return located<4>(problem, cloud, tolerance);
};

const Case clouds{
    {.name = "work_precision_clouds",
     .claim =
         "error against run time of the mean relative energy of clouds: stepped contact has order 1, located is not "
         "held to it",
     .equation = "R 2.2",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const std::vector<std::uint64_t> seeds = some_seeds(rows.quick() ? 8 : 64);
      double truth = 0.0, other = 0.0;
      for (const std::uint64_t seed : seeds) {
        const auto cloud = located_cloud(N, seed);
        const schemes::Problem problem(cloud);
        truth += located<4>(problem, cloud, 1e-12).energy / static_cast<double>(seeds.size());
        other += located<6>(problem, cloud, 1e-11).energy / static_cast<double>(seeds.size());
      }
      const auto stepped_clouds = [](Eigen::Index n, std::uint64_t seed) { return stepped_cloud(n, seed); };
      const auto located_clouds = [](Eigen::Index n, std::uint64_t seed) { return located_cloud(n, seed); };
      rows.work_precision(
          {.problem = "clouds",
           .reference = "Gauss 4 with located contacts at a tolerance of 1e-12, checked by Gauss 6 at 1e-11",
           .floor = std::max(std::abs(other - truth) / truth, 1e-14),
           .competitors = {with_slope(1.0, clouds_by("velocity Verlet, stepped contact", stepped_clouds,
                                                     halved_steps(rows.quick() ? 6 : 9), by_verlet, seeds, truth)),
                           clouds_by("Gauss 4, located contact", located_clouds,
                                     tolerances(rows.quick() ? 1e-6 : 1e-9, 1e-3), by_gauss, seeds, truth)}});
    }};

const Case gas{
    {.name = "work_precision_gas",
     .claim =
         "error against run time of the mean relative energy of clouds without near field: the gas of hard spheres "
         "and located contacts agree at any tolerance, stepped contact has order 1",
     .equation = "R 2.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const std::vector<std::uint64_t> seeds = some_seeds(rows.quick() ? 8 : 16);
      using Located = contact::LocatedContact<>;
      double truth = 0.0;
      long impacts = 0;
      for (const std::uint64_t seed : seeds) {
        const auto cloud = forceless<Located>(N, seed);
        const MeanOfRun one = located<4>(schemes::Problem(cloud), cloud, 1e-12);
        truth += one.energy / static_cast<double>(seeds.size());
        impacts += one.outcome.impacts;
      }
      GasLane exact = gas_lane(seeds);
      (void)exact.follow();
      rows.equal("impacts", {.expected = impacts, .computed = exact.impacts, .because = "the same motion"});
      rows.at_most("difference of the two references over the energy",
                   {.limit = 1e-11,
                    .computed = std::abs(exact.mean - truth) / truth,
                    .because = "a gap counts as closed within 1e-12 of the diameter, which some impacts multiply"});
      rows.work_precision(
          {.problem = "gas",
           .reference = "Gauss 4 with located contacts at a tolerance of 1e-12, checked by the gas of hard spheres",
           .floor = std::max(std::abs(exact.mean - truth) / truth, 1e-14),
           .competitors = {with_slope(1.0, clouds_by("velocity Verlet, stepped contact", forceless<contact::Contact<>>,
                                                     halved_steps(rows.quick() ? 6 : 7), by_verlet, seeds, truth)),
                           clouds_by("Gauss 4, located contact", forceless<Located>,
                                     tolerances(rows.quick() ? 1e-6 : 1e-9, 1e-3), by_gauss, seeds, truth),
                           by_gas(seeds, truth)}});
      // The first and the last of each.
      report::Table shown({"way", "step [s] or tolerance [-]", "error over the energy [-]", "seconds",
                           "right-hand sides, or predictions"});
      const std::vector<WorkPrecisionPoint>& all = rows.points();
      for (std::size_t k = 0; k < all.size(); ++k) {
        const bool inside = k > 0 && k + 1 < all.size() && all[k - 1].method == all[k + 1].method;
        if (inside || !all[k].errors) continue;
        shown.add({all[k].method, all[k].setting, all[k].errors->end, all[k].seconds_min.value_or(missing),
                   all[k].counts.evaluations});
      }
      rows.write("gas_run_time", shown);
    }};

}  // namespace verification::work_precision_clouds
