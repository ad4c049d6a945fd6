// Extreme cases: clouds that must be solved, and starts that must be refused.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/contact/hard_spheres.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/checkpoint.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"
#include "granular_gas.hpp"

namespace verification::cloud_extremes {

using namespace particulate;

const kinematics::Space periods{.lengths = Eigen::Vector3d::Ones()};
const laws::NearField cut_off{.alpha1 = 0.1, .alpha2 = 0.01, .cutoff = 0.3, .taper = 0.1};

template <class Scene>
schemes::Outcome flown(const Scene& scene, schemes::State& state, double t_end, double step) {
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = step};
  return schemes::integrate(scene, state, t_end, scheme, control);
}

Ending few(Eigen::Index N) {
  kinematics::Particles all{.position = kinematics::Vectors::Constant(N, 3, 0.25),
                            .velocity = kinematics::Vectors::Constant(N, 3, 0.5),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.1)};
  const scenes::Scene scene(all, periods, cut_off, contact::Contact<>{});
  schemes::State state = scenes::start(scene);
  require_reached(flown(scene, state, 1.0, 0.125));
  return Ending::solved({.error = (state.r.array() - 0.75).abs().sum(),
                         .tolerance = 0.0,
                         .because = "free flight in steps that are powers of two has no rounding"});
}

// Two that touch to the last bit across a corner of the box, and exchange what they have of the line of centres.
Ending just_touching() {
  const double along = 0.125;
  const kinematics::Particles pair = kinematics::particles(
      {{.position = {along, 0.25, 0.25}, .velocity = {-1.0, 0.0, 0.0}, .mass = 1.0, .radius = along},
       {.position = {1.0 - along, 5.25, -2.75}, .velocity = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = along}});
  const scenes::Scene scene(pair, periods, contact::Contact<>{});
  schemes::State state = scenes::start(scene);
  const schemes::Jump jump = scene.jump(state, 1e-3);
  return Ending::solved({.error = std::abs(state.v[0] - 1.0) + std::abs(state.v[1] + 1.0) +
                                  std::abs(static_cast<double>(jump.impacts) - 1.0),
                         .tolerance = 1e-15,
                         .because = "equal masses exchange velocities: one impulse, two roundings"});
}

// Along the diagonal 0.2 (sqrt(3) - 1) apart, at 0.2 m/s; with e = 1/2 they part at half of that.
Ending across_a_corner() {
  const Eigen::Vector3d diagonal = Eigen::Vector3d::Ones() / std::numbers::sqrt3;
  const kinematics::Particles pair = kinematics::particles(
      {{.position = Eigen::Vector3d::Constant(0.1), .velocity = -0.1 * diagonal, .mass = 1.0, .radius = 0.1},
       {.position = Eigen::Vector3d::Constant(0.9), .velocity = 0.1 * diagonal, .mass = 1.0, .radius = 0.1}});
  const scenes::Scene scene(pair, periods, contact::LocatedContact<>{.restitution = {0.5}});
  schemes::State state = scenes::start(scene);
  schemes::Collocation<schemes::Gauss<2>> scheme;
  schemes::FixedStep control{.step = 0.3};
  require_reached(schemes::integrate(scene, state, 1.0, scheme, control));
  const auto r = rows_of(state.r);
  const double apart = separation(periods, r.row(0), r.row(1)).norm();
  return Ending::solved({.error = std::abs(apart - (0.2 + 0.1 * (2.0 - std::numbers::sqrt3))),
                         .tolerance = 1e-12,
                         .because = "the contact is located to 1e-12 of the radii"});
}

// Chapter 4's cloud without near field: what the bodies lose, the impacts take.
Ending cloud(double e, double mass_ratio) {
  kinematics::Particles all = book_cloud(100, 3, periods);
  for (Eigen::Index i = 0; i < all.size(); i += 2) all.mass[i] *= mass_ratio;
  const scenes::Scene scene(all, periods, contact::LocatedContact<>{.restitution = {e}});
  const auto energy = [&](const schemes::State& at) { return kinematics::kinetic_energy(all.mass, rows_of(at.v)); };
  schemes::State state = scenes::start(scene);
  const double before = energy(state);
  schemes::Collocation<schemes::Gauss<2>> scheme;
  schemes::FixedStep control{.step = 0.02};
  const schemes::Outcome outcome = schemes::integrate(scene, state, 0.5, scheme, control);
  require_reached(outcome);
  if (outcome.impacts < 20) throw std::runtime_error("too few impacts to say anything");
  const double lost = e == 1.0 ? 0.0 : outcome.energy_change;
  return Ending::solved({.error = std::abs(energy(state) - before - lost) / before,
                         .tolerance = 1e-13,
                         .because = "the energy that impacts take is booked, and at e = 1 they take none; some hundred "
                                    "impacts, each with the rounding of its velocities"});
}

// Too thin to meet: each flies r + v t, while contacts are searched for after every step.
Ending many(Eigen::Index N) {
  Uniform uniform(5);
  const double edge = std::cbrt(1.0 / static_cast<double>(N));
  kinematics::Particles all{.position = lattice(kinematics::Lattice::simple_cubic, N, edge),
                            .velocity = edge * (random_places(uniform, N).array() - 0.5),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.1 * edge)};
  const scenes::Scene scene(all, kinematics::Space{}, contact::Contact<>{});
  schemes::State state = scenes::start(scene);
  const schemes::Outcome outcome = flown(scene, state, 0.5, 0.125);
  require_reached(outcome);
  const Eigen::VectorXd exact = all.position.reshaped() + 0.5 * all.velocity.reshaped();
  return Ending::solved(
      {.error = (state.r - exact).lpNorm<Eigen::Infinity>() + static_cast<double>(outcome.impacts),
       .tolerance = 1e-15,
       .because =
           "four steps, each with a rounding of places up to 1 m; from 1 edge apart none comes nearer than half"});
}

// Places in 2^-20 m, so that a million periods away they are exact: the same contacts, whatever the image.
Ending a_million_periods_away() {
  Uniform uniform(6);
  constexpr Eigen::Index N = 300;
  kinematics::Particles home{.position = (random_places(uniform, N) * 0x1p20).array().floor() * 0x1p-20,
                             .velocity = kinematics::Vectors::Zero(N, 3),
                             .mass = Eigen::VectorXd::Ones(N),
                             .radius = Eigen::VectorXd::Constant(N, 0.05)};
  kinematics::Particles away = home;
  away.velocity = (random_places(uniform, N).array() * 2001.0 - 1000.0).floor();
  const scenes::Scene near(home, periods, contact::Contact<>{});
  const scenes::Scene far(away, periods, laws::NearField{.cutoff = 0.2});
  schemes::State there = scenes::start(far);
  require_reached(flown(far, there, 1000.0, 250.0));
  const schemes::Overlap here = near.overlap(scenes::start(near)), same = near.overlap(there);
  const auto r = rows_of(there.r);
  double off = std::abs(static_cast<double>(here.contacts - same.contacts)) + std::abs(here.deepest - same.deepest);
  if (here.contacts < 50) throw std::runtime_error("too few contacts to say anything");
  for (Eigen::Index i = 0; i < N; ++i) {
    off += (wrapped(periods, r.row(i).transpose()) - home.position.row(i).transpose()).norm();
  }
  return Ending::solved({.error = off, .tolerance = 0.0, .because = "every number on the way is exact"});
}

// Side by side, at the same velocity.
Ending few_in_a_gas(Eigen::Index N) {
  kinematics::Particles all{.position = kinematics::Vectors::Constant(N, 3, 0.25),
                            .velocity = kinematics::Vectors::Constant(N, 3, 0.5),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.1)};
  if (N == 2) all.position.row(1).setConstant(0.75);
  contact::HardSpheres<> gas(all, periods);
  schemes::State state = start(gas);
  const schemes::Outcome outcome = gas.advance(state, 1.0);
  require_reached(outcome);
  const Eigen::VectorXd exact = (all.position.array() + 0.5).reshaped();
  return Ending::solved({.error = (state.r - exact).lpNorm<1>() + static_cast<double>(outcome.impacts),
                         .tolerance = 0.0,
                         .because = "none meets another, and free flight over powers of two has no rounding"});
}

// One rests between two that come to touch it at the same moment. In turn, with equal masses and e = 1/2, along x:
// (1, 0, -1) -> (1/4, 3/4, -1) -> (1/4, -9/16, 5/16) -> (-23/64, 3/64, 5/16).
Ending three_meet() {
  kinematics::Particles all = kinematics::particles(
      {{.position = {0.25, 0.5, 0.5}, .velocity = {0.25, 0.0, 0.0}, .mass = 1.0, .radius = 0.0625},
       {.position = {0.5, 0.5, 0.5}, .velocity = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0625},
       {.position = {0.75, 0.5, 0.5}, .velocity = {-0.25, 0.0, 0.0}, .mass = 1.0, .radius = 0.0625}});
  contact::HardSpheres<> gas(all, periods, {0.5});
  schemes::State state = start(gas);
  const schemes::Outcome outcome = gas.advance(state, 1.0);
  require_reached(outcome);
  const Eigen::Vector3d exact = 0.25 * Eigen::Vector3d(-23.0, 3.0, 20.0) / 64.0;
  return Ending::solved(
      {.error = (state.v.head(3) - exact).lpNorm<1>() + std::abs(static_cast<double>(outcome.impacts) - 3.0),
       .tolerance = 0.0,
       .because = "resolved pair by pair in the order of their numbers until none approach; every number is exact"});
}

// Large spheres with a hundred times the radius and a million times the mass of the small ones between them, slower, so
// that both carry energy.
kinematics::Particles mixed(Eigen::Index large, Eigen::Index small) {
  Uniform uniform(7);
  constexpr double b = 0.002;
  const Eigen::Index N = large + small;
  kinematics::Particles all{.position = {},
                            .velocity = random_places(uniform, N).array() - 0.5,
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, b)};
  all.velocity.topRows(large) *= 0.1;
  all.radius.head(large).setConstant(100.0 * b);
  all.mass.head(large).setConstant(1e6);
  all.position = kinematics::random_addition(all.radius, {.domain = periods}, [&] { return uniform(); }).position;
  return all;
}

// Over all pairs, by the nearest images of their places alone. [m]
double deepest_of_all(const Eigen::VectorXd& radius, const schemes::State& state) {
  const auto r = rows_of(state.r);
  double deepest = 0.0;
  for (Eigen::Index i = 0; i < radius.size(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const auto apart = [&](Eigen::Index axis) { return std::remainder(r(i, axis) - r(j, axis), 1.0); };
      deepest = report::worse_of(deepest, radius[i] + radius[j] - std::hypot(apart(0), apart(1), apart(2)));
    }
  }
  return deepest;
}

Ending size_ratio_100(Eigen::Index large, Eigen::Index small) {
  const kinematics::Particles all = mixed(large, small);
  contact::HardSpheres<> gas(all, periods);
  schemes::State state = start(gas);
  long of_large = 0, of_small = 0;
  const schemes::Outcome outcome =
      gas.advance(state, 4.0, [&](const contact::Collision& one) { (one.i < large ? of_large : of_small) += 1; });
  require_reached(outcome);
  if (of_large < 500 || of_small < 50) {
    throw std::runtime_error(fmt::format("too few impacts to say anything, {} and {}", of_large, of_small));
  }
  const double before = kinematics::kinetic_energy(all.mass, all.velocity);
  const Eigen::Vector3d momentum = kinematics::linear_momentum(all.mass, all.velocity);
  const double off_energy = std::abs(kinematics::kinetic_energy(all.mass, rows_of(state.v)) / before - 1.0);
  const double off_momentum = (kinematics::linear_momentum(all.mass, rows_of(state.v)) - momentum).norm() /
                              all.mass.dot(all.velocity.rowwise().norm());
  const double overlap = deepest_of_all(all.radius, state) / all.radius.minCoeff();
  return Ending::solved({.error = std::max({off_energy, off_momentum, overlap}),
                         .tolerance = 1e-12,
                         .because =
                             "thousands of impacts, each with the roundings of its velocities; places of a metre "
                             "are rounded to 1e-13 of the small radius"});
}

const Case solved{
    {.name = "clouds_extremes_solved",
     .claim =
         "clouds and gases of none, of a million, of any restitution, of sizes and masses far apart and across any "
         "number of periods are solved",
     .equation = "R 4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.must_be_solved("no particle", [] { return few(0); });
      rows.must_be_solved("one particle", [] { return few(1); });
      rows.must_be_solved("two just touching, across a period", just_touching);
      rows.must_be_solved("a pair across a corner of the box", across_a_corner);
      rows.must_be_solved("e = 0", [] { return cloud(0.0, 1.0); });
      rows.must_be_solved("e = 1", [] { return cloud(1.0, 1.0); });
      rows.must_be_solved("mass ratio 1e6", [] { return cloud(0.5, 1e6); });
      rows.must_be_solved("a million in free flight (quick: 1e5)",
                          [&] { return many(rows.quick() ? 100'000 : 1'000'000); });
      rows.must_be_solved("free flight over a million periods", a_million_periods_away);
      for (const Eigen::Index N : {0, 1, 2}) {
        rows.must_be_solved(fmt::format("a gas of {}", N), [&] { return few_in_a_gas(N); });
      }
      rows.must_be_solved("a gas of three that meet in one moment", three_meet);
      rows.must_be_solved("a gas of sizes 1:100 and masses 1:1e6, one large among 2000",
                          [] { return size_ratio_100(1, 2000); });
      rows.must_be_solved("the same, eight among 8000 (quick: 2000)",
                          [&] { return size_ratio_100(8, rows.quick() ? 2000 : 8000); });
    }};

void refuse_spaces(Rows& rows) {
  const auto refuse = [&](const std::string& name, const std::string& key_words, double length,
                          const laws::NearField& law) {
    rows.must_be_refused(name, key_words, [&] {
      const kinematics::Space domain{.lengths = {1.0, length, 1.0}};
      scenes::Scene(book_cloud(10, 1), domain, law, contact::Contact<>{});
      return accepted();
    });
  };
  refuse("a period of zero", "length y must positive 0", 0.0, cut_off);
  refuse("a negative period", "length y must positive -1", -1.0, cut_off);
  refuse("a period that is none", "length y must positive nan", not_a_number, cut_off);
  refuse("a period shorter than two diameters", "length y at least two diameters 0.4", 0.4, cut_off);
  refuse("a reach beyond half a period", "near field half shortest period 0.5 0.51 cutoff", 1.0,
         {.alpha1 = 0.1, .cutoff = 0.51});
  refuse("a near field without end in periods", "near field half shortest period inf cutoff", 1.0, {.alpha1 = 0.1});
}

void refuse_starts(Rows& rows) {
  rows.must_be_refused("coincident particles under a near field", "particles 3 7 apart 0 contact", [] {
    kinematics::Particles all = book_cloud(100, 1, periods);
    all.position.row(7) = all.position.row(3);
    all.radius.setZero();
    const scenes::Scene scene(all, periods, cut_off);
    schemes::State state = scenes::start(scene);
    return ending_of(flown(scene, state, 0.1, 0.01));
  });
  for (const double L : {0.49, 1.0}) {
    rows.must_be_refused(fmt::format("L = {}", L), "room volume fraction 0.384 asked", [&] {
      Uniform uniform(1);
      const Eigen::VectorXd radius = Eigen::VectorXd::Constant(200, L / std::cbrt(200.0));
      (void)kinematics::random_addition(radius, {.domain = periods, .most_attempts = 20'000},
                                        [&] { return uniform(); });
      return accepted();
    });
  }
  rows.must_be_refused("a start in which two overlap across a period", "no two spheres overlap 3 7 0.05", [] {
    kinematics::Particles all = book_cloud(100, 1, periods);
    all.position.row(7) = all.position.row(3) + Eigen::RowVector3d(1.0 - 2.0 * all.radius[3] + 0.05, 0.0, 0.0);
    validate_apart(all, periods);
    return accepted();
  });
  const auto flown_as_gas = [&](double first, double e) {
    contact::HardSpheres<> gas(three_on_a_line(first, 0.125), {}, {e});
    schemes::State state = start(gas);
    return ending_of(gas.advance(state, 2.0));
  };
  rows.must_be_refused("a gas of which two overlap", "no two spheres overlap 0 1 0.25",
                       [&] { return flown_as_gas(0.25, 0.5); });
  rows.must_be_refused("a gas that collapses",
                       "particles 0, 1, 2 infinitely often 1.4545 inelastic collapse contact time",
                       [&] { return flown_as_gas(0.0, 0.05); });
  const std::vector<std::string> header{"x", "y", "z", "vx", "vy", "vz", "m", "b"};
  rows.must_be_refused("a start file with a column too few", "start.csv:2 must 8 columns 7", [&] {
    kinematics::particles_from({header, {"0", "0", "0", "0", "0", "0", "1"}}, "start.csv");
    return accepted();
  });
  rows.must_be_refused("a start file with a word for a number", "start.csv:2 vx must finite number fast", [&] {
    kinematics::particles_from({header, {"0", "0", "0", "fast", "0", "0", "1", "0"}}, "start.csv");
    return accepted();
  });
}

void refuse_checkpoints(Rows& rows) {
  const schemes::State state{.t = 0.5, .r = Eigen::VectorXd::Ones(6), .v = Eigen::VectorXd::Ones(6)};
  const std::string whole = scenes::to_bytes({.scene = "cloud", .state = state, .step = 0.1});
  const auto refuse = [&](const std::string& name, const std::string& key_words, const std::string& bytes,
                          const std::string& scene = "cloud") {
    rows.must_be_refused(name, key_words, [&] {
      scenes::checkpoint_from(bytes, "old.checkpoint", scene, 2);
      return accepted();
    });
  };
  std::string altered = whole;
  altered[whole.size() / 2] = static_cast<char>(altered[whole.size() / 2] ^ 1);
  refuse("a checkpoint of which one bit is altered", "old.checkpoint checksum altered", altered);
  refuse("a checkpoint cut short", "old.checkpoint cut short", whole.substr(0, whole.size() / 2));
  refuse("what is no checkpoint", "old.checkpoint must begin particulate", "x,y,z\n");
  refuse("a checkpoint of another scene", "old.checkpoint same scene cloud other", whole, "other");
}

const Case refused{{.name = "clouds_extremes_refused",
                    .claim = "spaces, starts and checkpoints that cannot be meant are refused, with the reason",
                    .equation = "R 4.1",
                    .reference = Reference::design},
                   [](Rows& rows) {
                     refuse_spaces(rows);
                     refuse_starts(rows);
                     refuse_checkpoints(rows);
                   }};

}  // namespace verification::cloud_extremes
