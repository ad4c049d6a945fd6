#include <harness/races.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/scene.hpp>

namespace verification {

using namespace particulate;

Race breathing_race(const kinematics::Vectors& corners, const kinematics::RadialForce& radial, double alpha2,
                    double r_0) {
  const Eigen::Index N = corners.rows();
  const kinematics::Breathing exact(radial, r_0);
  const kinematics::Particles start{.position = r_0 * corners,
                                    .velocity = kinematics::Vectors::Zero(N, 3),
                                    .mass = Eigen::VectorXd::Ones(N),
                                    .radius = Eigen::VectorXd::Zero(N)};
  const NearFieldScene scene{start, kinematics::Space{},
                             laws::NearField{.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
  Race race{.problem = scene, .start = scenes::start(scene), .outputs = {}, .truth = {}};
  for (int tenth = 1; tenth <= 9; ++tenth) race.outputs.push_back(tenth * exact.period() / 10.0);
  // Every run is asked about the same few times, and the closed form takes longer than many a run.
  race.truth = [corners, exact, known = std::make_shared<std::map<double, schemes::State>>()](double t) {
    const auto [at, is_new] = known->try_emplace(t);
    if (is_new) {
      const kinematics::Radial now = exact.at(t);
      at->second = {.t = t, .r = (now.r * corners).reshaped(), .v = (now.v * corners).reshaped()};
    }
    return at->second;
  };
  // |dr/dt| is largest where A/r^2 = B/r^3: v^2 = A^2/B - 2 A/r_0 + B/r_0^2.
  const double fastest = std::sqrt(radial.A * radial.A / radial.B - 2.0 * radial.A / r_0 + radial.B / (r_0 * r_0));
  race.length = r_0 * corners.rowwise().norm().maxCoeff();
  race.speed = fastest * corners.rowwise().norm().maxCoeff();
  return race;
}

Race breathing_pair_race(double alpha2) {
  const kinematics::Vectors halves{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}};
  return breathing_race(halves, kinematics::breathing_pair(1.0, alpha2, 1.0, 1.0), alpha2, 1.0);
}

Race pentagon_race() {
  const kinematics::Vectors corners = kinematics::regular_polygon(5);
  return breathing_race(corners, kinematics::breathing_body(1.0, 0.5, 1.0, corners), 0.5, 1.0);
}

std::vector<schemes::State> handed_by(const Race& race, const reference::Method& method) {
  std::vector<schemes::State> states;
  schemes::State state = race.start;
  reference::Integrator integrator(race.problem.seen(), race.start, method);
  for (const double t : race.outputs) {
    const schemes::Outcome out = integrator.advance(state, t);
    if (out.status != schemes::Status::reached) throw std::runtime_error("a reference failed: " + out.reason);
    states.push_back(state);
  }
  return states;
}

JudgedRace judged_race(const NearFieldScene& scene, double t_end, int legs) {
  JudgedRace judged{.race = {.problem = scene, .start = scenes::start(scene), .outputs = {}, .truth = {}}, .floor = {}};
  Race& race = judged.race;
  for (int leg = 1; leg <= legs; ++leg) race.outputs.push_back(t_end * leg / legs);
  const std::vector<schemes::State> truth = handed_by(
      race,
      reference::ExplicitRungeKutta{.table = reference::Table::fehlberg_13_7_8, .relative = 1e-15, .absolute = 1e-15});
  race.length = race.start.r.lpNorm<Eigen::Infinity>();
  race.speed = 0.0;
  for (const schemes::State& at : truth) race.speed = std::max(race.speed, at.v.lpNorm<Eigen::Infinity>());
  race.truth = [truth](double t) {
    return *std::find_if(truth.begin(), truth.end(), [t](const schemes::State& at) { return at.t >= t; });
  };
  judged.floor = errors_of(race, handed_by(race, reference::Adams{.relative = 1e-15, .absolute = 1e-15})).max;
  return judged;
}

std::vector<double> step_sizes(double leg, const Steps& steps, int multiple) {
  std::vector<double> sizes;
  for (int k = 0; k <= steps.times; ++k) {
    sizes.push_back(leg / std::round(multiple * steps.first * std::pow(steps.factor, k)));
  }
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

std::vector<double> tolerances(double tightest, double loosest) {
  std::vector<double> all;
  for (double exponent = std::log10(loosest); exponent >= std::log10(tightest) - 1e-9; exponent -= 0.5) {
    all.push_back(std::pow(10.0, exponent));
  }
  return all;
}

Begin by(const reference::Method& method, double absolute_share) {
  return [=](const schemes::Problem& problem, const schemes::State& start, double tolerance) -> Advance {
    reference::Method now = method;
    std::visit([&](auto& settings) { settings.relative = tolerance, settings.absolute = absolute_share * tolerance; },
               now);
    return [integrator = std::make_shared<reference::Integrator>(problem, start, now)](
               schemes::State& state, double t_end) { return integrator->advance(state, t_end); };
  };
}

Competitor with_slope(double slope, Competitor who, std::string steeper) {
  who.slope = slope;
  who.steeper = std::move(steeper);
  return who;
}

Competitor tuned(Competitor who) {
  who.tuned = true;
  return who;
}

}  // namespace verification
