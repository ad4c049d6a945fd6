// A gas of hard spheres against what finds impacts in other ways: located contacts, and CVODE with root finding.

#include <algorithm>
#include <cmath>
#include <vector>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/impacts_by_events.hpp>
#include <harness/motions.hpp>
#include <harness/three_body.hpp>
#include <particulate/contact/friction.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

#include "granular_gas.hpp"

namespace verification::gas_exact {

using namespace particulate;

const contact::Restitution restitution{.e_o = 0.9, .v_star = 10.0, .e_minus = 0.1};
const contact::Friction friction{.mu_s = 0.2, .mu_d = 0.1};

// Of different sizes and masses, in a tenth of the cube, flying in all directions.
kinematics::Particles unlike(Eigen::Index N, const kinematics::Space& domain, std::uint64_t seed) {
  Uniform uniform(seed);
  const double b = std::cbrt(0.1 * 3.0 / (4.0 * std::numbers::pi * static_cast<double>(N)));
  kinematics::Particles all{.position = {},
                            .velocity = random_places(uniform, N).array() - 0.5,
                            .mass = Eigen::VectorXd::LinSpaced(N, 2.0, 1.0),
                            .radius = Eigen::VectorXd::LinSpaced(N, 1.3 * b, 0.6 * b)};
  all.position = kinematics::random_addition(all.radius, {.domain = domain}, [&] { return uniform(); }).position;
  return all;
}

struct Met {
  Eigen::Index i, j;
  Eigen::Vector3d n;
  double impulse;
};

const Case located{
    {.name = "gas_like_located_contacts",
     .claim = "a gas of hard spheres has the impacts of located contacts, one by one, with restitution and friction",
     .equation = "R 2.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      constexpr Eigen::Index N = 30;
      const kinematics::Space cube{.lengths = Eigen::Vector3d::Ones()};
      const kinematics::Space box{.walls = {{.point = {0.0, 0.0, -0.2}, .normal = {0.0, 0.0, 1.0}},
                                            {.point = {0.0, 0.0, 1.2}, .normal = {0.0, 0.0, -1.0}}},
                                  .lengths = {1.0, 1.0, std::numeric_limits<double>::infinity()}};
      for (const auto& [name, domain] : {std::pair{"periods", cube}, std::pair{"periods and walls", box}}) {
        const kinematics::Particles all = unlike(N, domain, rows.case_seed());
        std::vector<Met> by_gas, by_scene;
        contact::HardSpheres gas(all, domain, restitution, friction);
        schemes::State one = start(gas);
        constexpr double t_end = 1.5;
        require_reached(gas.advance(one, t_end, [&](const contact::Collision& met) {
          by_gas.push_back({met.i, met.j, met.n, std::abs(met.impulse.normal)});
        }));
        contact::LocatedContact<contact::Restitution, contact::Friction> law{restitution, friction};
        law.recorder = [&](const contact::ImpactRecord& met) { by_scene.push_back({met.i, met.j, met.n, met.push}); };
        const scenes::Scene scene(all, domain, law);
        schemes::State other = scenes::start(scene);
        schemes::Collocation<schemes::Gauss<4>> scheme;
        schemes::ErrorControl control{.TOL = 1e-10, .sweep_TOL = 1e-12, .limit = 0.05};
        require_reached(schemes::integrate(scene, other, t_end, scheme, control));
        rows.equal(std::string("impacts, ") + name, {.expected = static_cast<long>(by_scene.size()),
                                                     .computed = static_cast<long>(by_gas.size()),
                                                     .because = "the same motion"});
        long others = 0;
        double off = 0.0;
        for (std::size_t k = 0; k < std::min(by_gas.size(), by_scene.size()); ++k) {
          others += by_gas[k].i == by_scene[k].i && by_gas[k].j == by_scene[k].j ? 0 : 1;
          off =
              std::max({off, (by_gas[k].n - by_scene[k].n).norm(), std::abs(by_gas[k].impulse - by_scene[k].impulse)});
        }
        rows.at_least(std::string("impacts a body, ") + name, {.limit = 2.0,
                                                               .computed = 2.0 * static_cast<double>(by_gas.size()) / N,
                                                               .because = "else the claim is nearly empty"});
        rows.none(std::string("impacts of another pair, ") + name, others, "the same motion");
        rows.at_most(std::string("largest difference of a normal or an impulse [-, Ns], ") + name,
                     {.limit = 1e-10,
                      .computed = off,
                      .because = "an impact multiplies a difference by some ten times; roundings after a few impacts a "
                                 "body, and 1e-12 of the diameter in which a located gap counts as closed"});
      }
    }};

// Ten bodies that fly towards their middle, and apart again.
const Case by_roots{
    {.name = "gas_like_cvode_roots",
     .claim = "ten hard spheres move as by CVODE, which finds the roots of their gaps",
     .equation = "R 2.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      constexpr Eigen::Index N = 10;
      constexpr double e = 0.8, t_end = 1.0;
      kinematics::Particles all = unlike(N, {}, rows.case_seed());
      all.velocity = (0.5 - all.position.array()) + 0.2 * all.velocity.array();
      contact::HardSpheres<> gas(all, {}, {e});
      schemes::State exact = start(gas);
      const schemes::Outcome outcome = gas.advance(exact, t_end);
      require_reached(outcome);

      scenes::Scene<kinematics::Space> flight(all, {});
      std::vector<Pair> pairs;
      for (Eigen::Index i = 0; i < N; ++i) {
        for (Eigen::Index j = i + 1; j < N; ++j) pairs.push_back({i, j});
      }
      schemes::State state = scenes::start(flight);
      reference::Integrator integrator(flight, state, reference::Adams{.relative = 1e-13, .absolute = 1e-14},
                                       gap_events(all.radius));
      const schemes::Outcome by_cvode =
          advance_through_impacts(integrator, state, t_end, [&](schemes::State& at, const auto& hits) {
            for (const reference::Hit& hit : hits) {
              const auto& [i, j] = pairs[hit.event];
              const Eigen::Vector3d n = (row_of(at.r, j) - row_of(at.r, i)).normalized();
              const double approach = (row_of(at.v, i) - row_of(at.v, j)).dot(n);
              const double impulse = (1.0 + e) * approach / (1.0 / all.mass[i] + 1.0 / all.mass[j]);
              set_row(at.v, i, row_of(at.v, i) - impulse / all.mass[i] * n);
              set_row(at.v, j, row_of(at.v, j) + impulse / all.mass[j] * n);
            }
          });
      require_reached(by_cvode);
      rows.at_least(
          "impacts",
          {.limit = 8.0, .computed = static_cast<double>(outcome.impacts), .because = "else the claim is empty"});
      rows.equal("impacts", {.expected = by_cvode.impacts, .computed = outcome.impacts, .because = "the same motion"});
      rows.at_most("largest difference of a place [m]",
                   {.limit = 1e-9,
                    .computed = (exact.r - state.r).lpNorm<Eigen::Infinity>(),
                    .because = "CVODE at a relative tolerance of 1e-13; each impact multiplies by some ten times"});
      rows.at_most("largest difference of a velocity [m/s]", {.limit = 1e-9,
                                                              .computed = (exact.v - state.v).lpNorm<Eigen::Infinity>(),
                                                              .because = "as that of the places"});
    }};

struct Three {
  schemes::Outcome outcome;
  schemes::State state;
  contact::Tally tally;
};
Three three(double e, double parting, double contact_time = 0.0) {
  contact::HardSpheres gas(three_on_a_line(0.0, parting), {}, contact::ConstantRestitution{e}, contact::Frictionless{},
                           contact_time);
  Three run{.outcome = {}, .state = start(gas), .tally = {}};
  run.outcome = gas.advance(run.state, 100.0);
  run.tally = gas.tally();
  return run;
}

const Case collapse{
    {.name = "gas_collapse",
     .claim = "three spheres on a line collapse only if e < 7 - 4 sqrt 3, and when they should; a contact time takes "
              "them beyond",
     .equation = "D 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Three whole = three(0.05, 0.125);
      rows.compare("runs that end so, e = 0.05",
                   {.expected = 1.0,
                    .computed = whole.outcome.failure == schemes::Failure::accumulating ? 1.0 : 0.0,
                    .tolerance = absolute(0.0),
                    .because = "said by the outcome, not guessed from a time"});
      rows.compare("its time, e = 0.05 [s]",
                   {.expected = 16.0 / 11.0,
                    .computed = whole.outcome.accumulation,
                    .tolerance = relative(1e-8),
                    .because = "each impact leaves the mirror image of the one before, speeds 0.4 and times 0.3125 as "
                               "large; what is left of gaps in the rounding of places would take 1e-9 s"});
      const Three beyond = three(0.05, 0.125, 1e-3);
      require_reached(beyond.outcome);
      rows.at_least(
          "impacts that a contact time made elastic",
          {.limit = 1.0, .computed = static_cast<double>(beyond.tally.elastic_impacts), .because = "else none"});
      rows.at_most("momentum of x then, error",
                   {.limit = 1e-14,
                    .computed = std::abs(beyond.state.v.head(3).sum() + 1.125),
                    .because = "some ten impacts, each with a rounding or two of velocities up to 1"});
      rows.at_least("speed at which the first two part then, and the last two",
                    {.limit = 0.0,
                     .computed = std::min(beyond.state.v[1] - beyond.state.v[0], beyond.state.v[2] - beyond.state.v[1]),
                     .because = "none approaches another, so it is over"});
      constexpr int starts = 400;
      const auto collapsed = [](double e) {
        int count = 0;
        for (int k = 1; k < starts; ++k) {
          const schemes::Outcome outcome = three(e, static_cast<double>(k) / starts).outcome;
          count += outcome.failure == schemes::Failure::accumulating ? 1 : 0;
        }
        return static_cast<double>(count);
      };
      const double critical = 7.0 - 4.0 * std::sqrt(3.0);
      rows.compare("of 399 starts those that collapse, e 2 % above",
                   {.expected = 0.0,
                    .computed = collapsed(1.02 * critical),
                    .tolerance = absolute(0.0),
                    .because = "the matrix of two impacts has complex eigenvalues: speeds change sign, and they part"});
      rows.at_least("e 2 % below", {.limit = 1.0,
                                    .computed = collapsed(0.98 * critical),
                                    .because = "the eigenvalues are real: some start is drawn to the eigenvector"});
    }};

}  // namespace verification::gas_exact
