// Newton's cradle: a row of equal spheres that touch.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

#include "encounters.hpp"

namespace verification::cradle {

using namespace particulate;

// Spheres of diameter 1 m and mass 1 kg on a line, each touching the next; no rounding in their places.
kinematics::Particles row_of(const Eigen::VectorXd& speeds) {
  const Eigen::Index N = speeds.size();
  kinematics::Particles row{.position = kinematics::Vectors::Zero(N, 3),
                            .velocity = kinematics::Vectors::Zero(N, 3),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.5)};
  row.position.col(0) = Eigen::VectorXd::LinSpaced(N, 0.0, static_cast<double>(N - 1));
  row.velocity.col(0) = speeds;
  return row;
}

Eigen::VectorXd speeds(std::initializer_list<double> of) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(of.size()));
  std::copy(of.begin(), of.end(), values.begin());
  return values;
}

Eigen::VectorXd after_one_jump(const Eigen::VectorXd& before, double e, contact::Resolution resolution) {
  return jump_of(contact_scene(row_of(before), smooth(e, resolution)), 1e-3).v.col(0);
}

double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

// As many leave on the far side as came, with their speed.
void as_many_leave(Rows& rows) {
  const std::pair<Eigen::VectorXd, Eigen::VectorXd> known[] = {
      {speeds({1, 0, 0, 0, 0}), speeds({0, 0, 0, 0, 1})},   {speeds({1, 1, 0, 0, 0}), speeds({0, 0, 0, 1, 1})},
      {speeds({1, 1, 1, 0, 0}), speeds({0, 0, 1, 1, 1})},   {speeds({1, 1, 1, 1, 0}), speeds({0, 1, 1, 1, 1})},
      {speeds({1, 0, 0, 0, -1}), speeds({-1, 0, 0, 0, 1})}, {speeds({1, 0, -1}), speeds({-1, 0, 1})}};
  for (const auto& [before, after] : known) {
    std::string came;
    for (const double v : before) came += fmt::format("{}{}", came.empty() ? "" : ", ", v);
    rows.at_most(fmt::format("({}) m/s, e = 1, sequential: largest deviation from what must leave [m/s]", came),
                 {.limit = 8e-15,
                  .computed = largest_difference(after_one_jump(before, 1.0, contact::Resolution::sequential), after),
                  .because = "at most ten impacts in turn, each rounded a few times"});
  }
}

// Both ends strike the middle one of three at once. Each contact alone would exchange velocities; added, the impulses
// stop all three.
void three_at_once(Rows& rows) {
  const Eigen::VectorXd before = speeds({1, 0, -1});
  const char* const because = "impulses of 1 N s, without rounding";
  const auto energy = [&](double e, contact::Resolution how) {
    return 0.5 * after_one_jump(before, e, how).squaredNorm();
  };
  rows.compare("T'/T, (1, 0, -1) m/s, e = 1, summed: the ends stop",
               {.expected = 0.0,
                .computed = energy(1.0, contact::Resolution::summed),
                .tolerance = absolute(1e-15),
                .because = because});
  rows.compare("T'/T, (1, 0, -1) m/s, e = 1, sequential",
               {.expected = 1.0,
                .computed = energy(1.0, contact::Resolution::sequential),
                .tolerance = relative(4e-15),
                .because = "impulses from a 2 x 2 system, some ten roundings"});
  rows.compare("T'/T, (1, 0, -1) m/s, e = 1/2, summed: J = 3/4", {.expected = 0.0625,
                                                                  .computed = energy(0.5, contact::Resolution::summed),
                                                                  .tolerance = relative(1e-15),
                                                                  .because = because});
  rows.compare("T'/T, (1, 0, -1) m/s, e = 1/2, sequential: e^2",
               {.expected = 0.25,
                .computed = energy(0.5, contact::Resolution::sequential),
                .tolerance = relative(4e-15),
                .because = "impulses from a 2 x 2 system, some ten roundings"});
}

struct InTime {
  Eigen::VectorXd v;
  double energy_change;
};

// The first sphere comes from 0.05 m away; what happens at the row is stepped through.
InTime in_time(double e, contact::Resolution resolution) {
  kinematics::Particles row = row_of(speeds({1, 0, 0, 0, 0}));
  row.position(0, 0) = -0.05;
  auto scene = contact_scene(row, smooth(e, resolution));
  schemes::State state = scenes::start(scene);
  const schemes::Outcome outcome =
      reached(scene, state, 1.0, schemes::VelocityVerlet(), schemes::FixedStep{.step = 1e-3});
  return {.v = state.v.head(5), .energy_change = outcome.energy_change};
}

void compare_in_time(Rows& rows, contact::Resolution resolution, const char* name) {
  const InTime elastic = in_time(1.0, resolution);
  rows.at_most(fmt::format("in time, e = 1, {}: largest deviation from (0, 0, 0, 0, 1) m/s", name),
               {.limit = 8e-15,
                .computed = largest_difference(elastic.v, speeds({0, 0, 0, 0, 1})),
                .because = "four impacts in turn, each rounded a few times"});
  for (const double e : {0.0, 0.5, 0.9}) {
    const InTime lossy = in_time(e, resolution);
    rows.compare(fmt::format("in time, e = {}, {}: momentum [kg m/s]", e, name),
                 {.expected = 1.0,
                  .computed = lossy.v.sum(),
                  .tolerance = relative(1e-13),
                  .because = "a few hundred impulses at most, each rounded to eps/2"});
    rows.at_least(fmt::format("in time, e = {}, {}: energy taken [J]", e, name),
                  {.limit = 0.0,
                   .computed = -lossy.energy_change,
                   .because = "every impact of a row moving one way takes energy"});
    if (e == 0.0) {
      rows.compare(
          fmt::format("in time, e = 0, {}: energy taken until all move as one [J]", name),
          {.expected = 0.4,
           .computed = -lossy.energy_change,
           .tolerance = relative(1e-12),
           .because = "five masses at 1/5 m/s keep 0.1 of 0.5 J; approaches are followed down to 1e-13 of the first"});
    }
    double approach = 0.0;
    for (Eigen::Index k = 0; k + 1 < 5; ++k) keep_worst(approach, lossy.v[k] - lossy.v[k + 1]);
    rows.at_most(fmt::format("in time, e = {}, {}: fastest approach left [m/s]", e, name),
                 {.limit = 1e-12,
                  .computed = approach,
                  .because = "spheres that touch are resolved until none approaches, to 1e-13 of the first speed"});
  }
}

const Case cradle{{.name = "cradle",
                   .claim = "a row of equal spheres passes its motion on, with energy and momentum, if impulses act in "
                            "sequence; summed ones lose it where two hit at once",
                   .equation = "D 2.2",
                   .reference = Reference::closed_form},
                  [](Rows& rows) {
                    as_many_leave(rows);
                    three_at_once(rows);
                    compare_in_time(rows, contact::Resolution::sequential, "sequential");
                    compare_in_time(rows, contact::Resolution::summed, "summed");
                  }};

}  // namespace verification::cradle
