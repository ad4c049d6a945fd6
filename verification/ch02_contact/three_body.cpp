// Three bodies that meet at once, by impacts and by near fields.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/three_body.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::three_body {

using namespace particulate;

// One sphere strikes two at once: added impulses make energy, impulses in sequence cannot.

using contact::Resolution;

// Three unit spheres of diameter 1 at the corners of a triangle with sides slightly shorter; 0 flies at 1 m/s between
// 1 and 2, which rest beside one another, 1e-3 apart so that they do not touch.
kinematics::Particles three() {
  kinematics::Particles all{.position = kinematics::Vectors::Zero(3, 3),
                            .velocity = kinematics::Vectors::Zero(3, 3),
                            .mass = Eigen::VectorXd::Ones(3),
                            .radius = Eigen::VectorXd::Constant(3, 0.5)};
  const double aside = 0.5005, ahead = std::sqrt(1.0 - aside * aside) * (1.0 - 1e-12);
  all.position.row(1) << ahead, aside, 0.0;
  all.position.row(2) << ahead, -aside, 0.0;
  all.velocity(0, 0) = 1.0;
  return all;
}

// c = n_x of both contacts. Summed: J = (1 + e) c/2 each. Together: W = ((2, n_1.n_2), (n_1.n_2, 2)), n_1.n_2 = 2 c^2 -
// 1, so J = (1 + e) c/(1 + 2 c^2) each.
double share_left(double e, Resolution how) {
  const double c = std::sqrt(1.0 - 0.5005 * 0.5005);
  const double J = (1.0 + e) * c / (how == Resolution::summed ? 2.0 : 1.0 + 2.0 * c * c);
  return std::pow(1.0 - 2.0 * J * c, 2) + 2.0 * J * J;
}

kinematics::Particles renumbered(const kinematics::Particles& all, const std::vector<Eigen::Index>& order) {
  return {.position = all.position(order, Eigen::all),
          .velocity = all.velocity(order, Eigen::all),
          .mass = all.mass(order),
          .radius = all.radius(order)};
}

// Largest velocity difference between a scene and the same one renumbered, over all orders or some at random [m/s].
template <class L>
double worst_renumbering(const kinematics::Particles& all, const L& law, Encounters& drawn, int orders) {
  const kinematics::Vectors first = jump_of(contact_scene(all, law), 1e-3).v;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(all.size()));
  std::iota(order.begin(), order.end(), 0);
  double worst = 0.0;
  for (int k = 0; k < orders; ++k) {
    for (std::size_t i = order.size(); i > 1; --i) {
      const auto other = std::min(static_cast<std::size_t>(drawn.positive() * static_cast<double>(i)), i - 1);
      std::swap(order[i - 1], order[other]);
    }
    const kinematics::Vectors again = jump_of(contact_scene(renumbered(all, order), law), 1e-3).v;
    keep_worst(worst, (again - kinematics::Vectors(first(order, Eigen::all))).cwiseAbs().maxCoeff());
  }
  return worst;
}

void symmetric_hit(Rows& rows) {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const auto& [how, name] : resolutions) {
      const Jumped after = jump_of(contact_scene(three(), smooth(e, how)), 1e-3);
      rows.compare(
          fmt::format("T'/T, e = {}, {}", e, name),
          {.expected = share_left(e, how),
           .computed = after.v.squaredNorm(),
           .tolerance = absolute(1e-11),
           .because = "the overlap of 1e-12 turns the normals by as much; a 2 x 2 system, some twenty roundings"});
      rows.at_most(fmt::format("asymmetry of bodies 1 and 2, e = {}, {} [m/s]", e, name),
                   {.limit = 1e-15,
                    .computed = std::abs(after.v(1, 0) - after.v(2, 0)) + std::abs(after.v(1, 1) + after.v(2, 1)) +
                                std::abs(after.v(0, 1)),
                    .because = "mirrored numbers round alike, but for the elimination of the 2 x 2 system"});
    }
  }
  rows.at_least("T'/T, e = 1, summed",
                {.limit = 1.7,
                 .computed = jump_of(contact_scene(three(), smooth(1.0, Resolution::summed)), 1e-3).v.squaredNorm(),
                 .because = "7/4 where the two touch: summed impulses create energy"});
}

// A sphere of mass m slides with w between two of mass M that close on it from both sides. The friction of either would
// take all slip against that one, and both together would turn the slip round. Both stick: the energy is least
// where all three share the momentum m w.
void squeezed(Rows& rows) {
  constexpr double w = 0.3, m = 1.0, M = 5.0;
  kinematics::Particles all{.position = kinematics::Vectors::Zero(3, 3),
                            .velocity = kinematics::Vectors::Zero(3, 3),
                            .mass = Eigen::Vector3d{m, M, M},
                            .radius = Eigen::VectorXd::Constant(3, 0.5)};
  all.position.col(0) << 0.0, 1.0, -1.0;
  all.velocity.col(0) << 0.0, -1.0, 1.0;
  all.velocity(0, 1) = w;
  const Jumped after = jump_of(contact_scene(all, rough(0.5, {.mu_s = 0.4, .mu_d = 0.3})), 1e-3);
  for (const Eigen::Index i : {0, 1, 2}) {
    rows.compare(fmt::format("speed across of body {} when two squeeze a sliding one, m w/(m + 2 M) [m/s]", i),
                 {.expected = m * w / (m + 2.0 * M),
                  .computed = after.v(i, 1),
                  .tolerance = absolute(2e-16),
                  .because = "some roundings of impulses up to 0.25 and of speeds up to 0.3"});
  }
}

struct Clusters {
  double gain = -1.0, summed_gain = -1.0;  // largest (T' - T)/T
  double momentum = 0.0, approach = 0.0, renumbered = 0.0;
  long contacts = 0;
};

double energy_change(const kinematics::Particles& all, const Jumped& after) {
  const double T = kinematics::kinetic_energy(all.mass, all.velocity);
  return (kinematics::kinetic_energy(all.mass, after.v) - T) / T;
}

// The fastest approach of any pair that touches, after a jump [m/s].
double fastest_approach(const kinematics::Particles& all, const kinematics::Vectors& v) {
  double fastest = 0.0;
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    for (Eigen::Index j = i + 1; j < all.size(); ++j) {
      const Eigen::RowVector3d towards = all.position.row(j) - all.position.row(i);
      if (towards.norm() <= all.radius[i] + all.radius[j])
        keep_worst(fastest, (v.row(i) - v.row(j)).dot(towards) / towards.norm());
    }
  }
  return fastest;
}

Clusters random_clusters(std::uint64_t seed, int count, bool with_friction) {
  Encounters drawn({}, seed);
  Clusters seen;
  for (int k = 0; k < count; ++k) {
    const kinematics::Particles all = cluster(drawn, 3 + k % 6, 1.0);
    const double e = k % 3 == 0 ? 1.0 : drawn.positive();
    const contact::Friction friction =
        with_friction ? contact::Friction{.mu_s = 0.4, .mu_d = 0.3} : contact::Friction{};
    const Jumped after = jump_of(contact_scene(all, rough(e, friction)), 1e-3);
    seen.contacts += after.jump.impacts;
    keep_worst(seen.gain, energy_change(all, after));
    keep_worst(seen.summed_gain,
               energy_change(all, jump_of(contact_scene(all, rough(e, friction, Resolution::summed)), 1e-3)));
    const Eigen::Vector3d moved =
        kinematics::linear_momentum(all.mass, after.v) - kinematics::linear_momentum(all.mass, all.velocity);
    keep_worst(seen.momentum, moved.norm() / all.mass.dot(all.velocity.rowwise().norm()));
    keep_worst(seen.approach, fastest_approach(all, after.v));
    keep_worst(seen.renumbered, worst_renumbering(all, rough(e, friction), drawn, 3));
  }
  return seen;
}

void prove_three_body_hit(Rows& rows) {
  symmetric_hit(rows);
  squeezed(rows);
  Encounters drawn({}, rows.case_seed());
  rows.at_most("symmetric hit renumbered, sequential [m/s]",
               {.limit = 4e-15,
                .computed = worst_renumbering(three(), smooth(0.7), drawn, 12),
                .because = "the same 2 x 2 system with its rows in another order"});
  rows.at_most("symmetric hit renumbered, sequential with friction [m/s]",
               {.limit = 4e-15,
                .computed = worst_renumbering(three(), rough(0.7, {.mu_s = 0.4, .mu_d = 0.3}), drawn, 12),
                .because = "the same 2 x 2 system with its rows in another order"});
  for (const bool with_friction : {false, true}) {
    const Clusters seen = random_clusters(rows.case_seed(), rows.quick() ? 300 : 3000, with_friction);
    const std::string which = with_friction ? ", random clusters with friction" : ", random clusters";
    rows.at_least("impacts" + which, {.limit = 500.0,
                                      .computed = static_cast<double>(seen.contacts),
                                      .because = "most spheres touch several others"});
    rows.at_most("largest energy gain over T, sequential" + which,
                 {.limit = 4e-15,
                  .computed = seen.gain,
                  .because = "up to some hundred impulses in turn, 4 eps of T each, and none can gain"});
    rows.at_least(
        "largest energy gain over T, summed" + which,
        {.limit = 0.05, .computed = seen.summed_gain, .because = "spheres that meet several at once: it must show"});
    rows.at_most("change of momentum over sum m|v|, sequential" + which,
                 {.limit = 4e-15,
                  .computed = seen.momentum,
                  .because = "up to some hundred impulses in turn, eps/2 of the speeds each"});
    rows.at_most("fastest approach left among those that touch [m/s]" + which,
                 {.limit = 1e-12,
                  .computed = seen.approach,
                  .because = "impulses act until none is faster than 1e-13 of the first, which is at most 3.5 m/s"});
    rows.at_most(
        "velocities after renumbering [m/s]" + which,
        {.limit = 1e-12,
         .computed = seen.renumbered,
         .because = "contacts resolved one by one repeat their bits; groups solved together are rounded in another "
                    "order, which later impulses between masses a hundred times apart amplify"});
  }
}

const Case three_body_hit{
    {.name = "three_body_hit",
     .claim = "summed impulses can create energy; sequential ones never do, keep a symmetric hit symmetric and do not "
              "depend on the numbering",
     .equation = "D 2.2",
     .reference = Reference::closed_form},
    prove_three_body_hit};

// Three bodies that attract and repel one another and collide: stepped contact against CVODE with root finding.

// Amid flights for every start below.
constexpr double t_end = 2.9;

double difference(const schemes::State& one, const schemes::State& other) {
  return std::max((one.r - other.r).lpNorm<Eigen::Infinity>(), (one.v - other.v).lpNorm<Eigen::Infinity>());
}

struct ByRoots {
  schemes::State state;
  schemes::Outcome outcome;
};

ByRoots by_roots(double closer, double relative) {
  ThreeBodyScene scene = three_body_scene(closer);
  ByRoots run{.state = scenes::start(scene), .outcome = {}};
  run.outcome = three_bodies_by_roots(scene, run.state, t_end, relative);
  require_reached(run.outcome);
  return run;
}

template <class S>
ByRoots by_steps(double closer, long steps) {
  ThreeBodyScene scene = three_body_scene(closer);
  ByRoots run{.state = scenes::start(scene), .outcome = {}};
  run.outcome = reached(scene, run.state, t_end, S(), schemes::FixedStep{.step = t_end / static_cast<double>(steps)});
  return run;
}

// Starts a little apart, so that where within a step each impact falls is as good as random from one to the next.
std::vector<double> starts(int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(0.01 * (k + 0.5) / count);
  return all;
}

template <class S>
void compare_order(Rows& rows, const std::string& name, const std::vector<double>& all,
                   const std::vector<ByRoots>& exact) {
  std::vector<double> steps, errors;
  bool same_impacts = true;
  for (long n = 2000; steps.size() < (rows.quick() ? 5U : 7U); n *= 2) {
    double mean = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const ByRoots run = by_steps<S>(all[k], n);
      mean += difference(run.state, exact[k].state) / static_cast<double>(all.size());
      same_impacts = same_impacts && run.outcome.impacts == exact[k].outcome.impacts;
    }
    steps.push_back(t_end / static_cast<double>(n));
    errors.push_back(mean);
  }
  rows.order(
      name + ": order of the mean error over the starts",
      {.nominal = 1.0,
       .steps = steps,
       .errors = errors,
       .floor = 1e-9,
       .because = fmt::format("an impact is seen up to a step late, as good as at random: the mean over {} starts "
                              "is of first order, whatever the scheme",
                              all.size())});
  rows.equal(name + ": every run has the impacts that CVODE finds",
             {.expected = true, .computed = same_impacts, .because = "no impact here is a graze"});
}

const Case three_body_near_field{
    {.name = "three_body_near_field",
     .claim = "stepped contact converges at first order to three bodies that attract one another and collide",
     .equation = "R 2.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const std::vector<double> all = starts(rows.quick() ? 24 : 96);
      std::vector<ByRoots> exact;
      double agreement = 0.0;
      long fewest = 1000;
      for (const double closer : all) {
        exact.push_back(by_roots(closer, 1e-13));
        agreement = report::worse_of(agreement, difference(exact.back().state, by_roots(closer, 1e-11).state));
        fewest = std::min(fewest, exact.back().outcome.impacts);
      }
      rows.at_most("CVODE at relative tolerance 1e-11 against 1e-13 [m, m/s]",
                   {.limit = 1e-8,
                    .computed = agreement,
                    .because = "a thousand times the looser tolerance, through several impacts; far below what stepped "
                               "contact reaches"});
      rows.at_least("impacts in each motion",
                    {.limit = 3.0, .computed = static_cast<double>(fewest), .because = "else nothing collides"});
      compare_order<schemes::VelocityVerlet>(rows, "velocity Verlet", all, exact);
      compare_order<schemes::RungeKutta4>(rows, "RK4", all, exact);
    }};

}  // namespace verification::three_body
