// Extreme cases: what must be refused, and what must be solved.

#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "quadrature.hpp"
#include "references.hpp"

namespace verification::extremes {

using namespace particulate;

// Input that cannot be meant, and motions that cannot go on, are refused with the reason.

const laws::NearField book{.alpha1 = 0.5, .alpha2 = 0.25};

template <class S>
Ending run(const kinematics::Particles& start, const laws::NearField& law, double step, double t_end) {
  NearFieldScene scene(start, {}, law);
  schemes::State state = scenes::start(scene);
  S scheme;
  schemes::FixedStep control{.step = step};
  // An end that should have been refused must not keep the case for ever.
  long steps = 0;
  const auto for_a_while = [&steps](const auto&, const auto&, double, const S&) { return ++steps < 1000; };
  return ending_of(integrate(scene, state, t_end, scheme, control, for_a_while));
}

Ending run_by(const reference::Method& method, const kinematics::Particles& start, double t_end) {
  NearFieldScene scene(start, {}, book);
  schemes::State state = scenes::start(scene);
  return ending_of(reference::integrate(scene, state, t_end, method));
}

// Every number of a value set to something bad in turn.
template <class T>
struct Entry {
  const char* name;
  std::function<double&(T&)> of;
  bool may_be_zero = true;
  bool may_be_negative = false;
};

template <class T, class Accept>
void refuse_entries(Rows& rows, const std::string& what, const T& good, std::initializer_list<Entry<T>> entries,
                    const Accept& accept) {
  for (const Entry<T>& entry : entries) {
    const auto refuse = [&](double bad) {
      rows.must_be_refused(fmt::format("{}, {} = {}", what, entry.name, bad),
                           fmt::format("must {}", fmt::format("{}", bad)), [&] {
                             T spoilt = good;
                             entry.of(spoilt) = bad;
                             accept(spoilt);
                             return accepted();
                           });
    };
    refuse(not_a_number);
    refuse(infinite);
    refuse(-infinite);
    if (!entry.may_be_negative) refuse(-1.5);
    if (!entry.may_be_zero) refuse(0.0);
  }
}

void refuse_particles(Rows& rows) {
  using P = kinematics::Particles;
  refuse_entries<P>(
      rows, "particles", pair_at_rest(1.0, 1.0, 1.0),
      {{.name = "position", .of = [](P& p) -> double& { return p.position(1, 2); }, .may_be_negative = true},
       {.name = "velocity", .of = [](P& p) -> double& { return p.velocity(0, 1); }, .may_be_negative = true},
       {.name = "mass", .of = [](P& p) -> double& { return p.mass[1]; }, .may_be_zero = false},
       {.name = "radius", .of = [](P& p) -> double& { return p.radius[0]; }}},
      [](const P& spoilt) { NearFieldScene(spoilt, {}, book); });
  rows.must_be_refused("particles, one radius too few", "radius must entry", [] {
    P spoilt = pair_at_rest(1.0, 1.0, 1.0);
    spoilt.radius.resize(1);
    NearFieldScene(spoilt, {}, book);
    return accepted();
  });
}

void refuse_laws(Rows& rows) {
  using L = laws::NearField;
  refuse_entries<L>(rows, "near field", book,
                    {{.name = "alpha1", .of = [](L& l) -> double& { return l.alpha1; }},
                     {.name = "alpha2", .of = [](L& l) -> double& { return l.alpha2; }},
                     {.name = "beta1", .of = [](L& l) -> double& { return l.beta1; }},
                     {.name = "beta2", .of = [](L& l) -> double& { return l.beta2; }},
                     {.name = "d_ref", .of = [](L& l) -> double& { return l.d_ref; }, .may_be_zero = false}},
                    [](const L& spoilt) { NearFieldScene(pair_at_rest(1.0, 1.0, 1.0), {}, spoilt); });
  using C = kinematics::CentralForce;
  refuse_entries<C>(rows, "central force", {.alpha1 = 0.5, .alpha2 = 0.25},
                    {{.name = "alpha1", .of = [](C& l) -> double& { return l.alpha1; }},
                     {.name = "alpha2", .of = [](C& l) -> double& { return l.alpha2; }},
                     {.name = "beta1", .of = [](C& l) -> double& { return l.beta1; }},
                     {.name = "beta2", .of = [](C& l) -> double& { return l.beta2; }}},
                    [](const C& spoilt) { validate(spoilt); });
  using S = kinematics::Scales;
  refuse_entries<S>(rows, "scales", {},
                    {{.name = "length", .of = [](S& s) -> double& { return s.length; }, .may_be_zero = false},
                     {.name = "time", .of = [](S& s) -> double& { return s.time; }, .may_be_zero = false},
                     {.name = "mass", .of = [](S& s) -> double& { return s.mass; }, .may_be_zero = false}},
                    [](const S& spoilt) { kinematics::scaled(kinematics::CentralForce{.alpha1 = 1.0}, spoilt); });
}

// A start, a step and an end that no run can have.
void refuse_runs(Rows& rows) {
  using S = schemes::FixedStep;
  const kinematics::Particles start = pair_at_rest(1.0, 1.0, 1.0);
  refuse_entries<S>(
      rows, "fixed step", {.step = 0.1},
      {{.name = "step", .of = [](S& s) -> double& { return s.step; }, .may_be_zero = false}},
      [&](const S& spoilt) { static_cast<void>(run<schemes::RungeKutta4>(start, book, spoilt.step, 1.0)); });
  for (const double t_end : {not_a_number, infinite, -infinite, -1.0}) {
    rows.must_be_refused(fmt::format("run, t_end = {}", t_end), fmt::format("end time {}", t_end),
                         [&] { return run<schemes::VelocityVerlet>(start, book, 0.1, t_end); });
    rows.must_be_refused(fmt::format("CVODE run, t_end = {}", t_end), fmt::format("end time {}", t_end),
                         [&] { return run_by(adams, start, t_end); });
  }
  using M = schemes::State;
  NearFieldScene scene(start, {}, book);
  refuse_entries<M>(rows, "state of a run", scenes::start(scene),
                    {{.name = "t", .of = [](M& m) -> double& { return m.t; }, .may_be_negative = true},
                     {.name = "r", .of = [](M& m) -> double& { return m.r[4]; }, .may_be_negative = true},
                     {.name = "v", .of = [](M& m) -> double& { return m.v[5]; }, .may_be_negative = true}},
                    [&](const M& spoilt) {
                      M state = spoilt;
                      advance<schemes::RungeKutta4>(scene, state, 1.0, 10);
                    });
}

// Two particles that meet: at the start, or within a fixed step.
void refuse_coincidence(Rows& rows) {
  const kinematics::Particles together = pair_at_rest(1.0, 1.0, 0.0);
  rows.must_be_refused("coincident particles, RK4", "no finite value step",
                       [&] { return run<schemes::RungeKutta4>(together, book, 0.1, 1.0); });
  rows.must_be_refused("coincident particles, velocity Verlet", "no finite value step",
                       [&] { return run<schemes::VelocityVerlet>(together, book, 0.1, 1.0); });
  rows.must_be_refused("coincident particles, CVODE", "CV_ value", [&] { return run_by(adams, together, 1.0); });
  rows.must_be_refused("coincident particles, ARKODE", "ARK_ value", [&] { return run_by(fehlberg, together, 1.0); });
  rows.must_be_refused("particle at the centre of a central force", "must lie apart centre", [] {
    kinematics::force({.alpha1 = 1.0}, Eigen::Vector3d::Ones(), Eigen::Vector3d::Ones());
    return accepted();
  });

  // With hardly a force the two would pass through each other; the first step ends where they meet.
  kinematics::Particles meeting = pair_at_rest(1.0, 1.0, 2.0);
  meeting.velocity = -meeting.position;
  const laws::NearField idle{.alpha1 = 1e-200, .alpha2 = 0.0};
  rows.must_be_refused("fixed step that leaps into coincidence, velocity Verlet", "no finite value smaller step",
                       [&] { return run<schemes::VelocityVerlet>(meeting, idle, 1.0, 4.0); });
  rows.must_be_refused("fixed step that leaps into coincidence, RK4", "no finite value smaller step",
                       [&] { return run<schemes::RungeKutta4>(meeting, idle, 1.0, 4.0); });

  rows.must_be_refused("distance whose square is no double", "no finite value",
                       [] { return run<schemes::RungeKutta4>(pair_at_rest(1.0, 1.0, 1e200), book, 0.1, 1.0); });
  rows.must_be_refused("forces too large for a double", "no finite value", [] {
    return run<schemes::RungeKutta4>(pair_at_rest(1.0, 1.0, 1e-100),
                                     {.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 13.0}, 0.1, 1.0);
  });
}

template <class F>
void refuse(Rows& rows, const std::string& name, const std::string& key_words, const F& attempt) {
  rows.must_be_refused(name, key_words, [&] {
    attempt();
    return accepted();
  });
}

// Questions without an answer.
void refuse_questions(Rows& rows) {
  using kinematics::equilibrium_distance, kinematics::small_oscillation_period, kinematics::Breathing;
  refuse(rows, "equilibrium without repulsion", "equilibrium alpha2 > 0",
         [] { equilibrium_distance({.alpha1 = 1.0, .alpha2 = 0.0}); });
  refuse(rows, "equilibrium without attraction", "equilibrium alpha1 > 0",
         [] { equilibrium_distance({.alpha1 = 0.0, .alpha2 = 1.0}); });
  refuse(rows, "equilibrium of equal exponents", "equilibrium beta1 != beta2",
         [] { equilibrium_distance({.alpha1 = 1.0, .alpha2 = 2.0, .beta1 = 2.0, .beta2 = 2.0}); });
  refuse(rows, "equilibrium beyond all doubles", "equilibrium representable",
         [] { equilibrium_distance({.alpha1 = 1e-200, .alpha2 = 1e200, .beta1 = 1.0, .beta2 = 1.5}); });
  refuse(rows, "small oscillations about an unstable equilibrium", "stable beta2 > beta1",
         [] { small_oscillation_period({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 1.0}, 1.0, 1.0); });
  refuse(rows, "stability without an equilibrium", "equilibrium",
         [] { kinematics::is_stable({.alpha1 = 1.0, .alpha2 = 0.0}); });
  for (const double m : {not_a_number, infinite, -1.0, 0.0}) {
    refuse(rows, fmt::format("small oscillations, mass = {}", m), fmt::format("masses must {}", m),
           [&] { small_oscillation_period({.alpha1 = 1.0, .alpha2 = 1.0}, m, 1.0); });
    refuse(rows, fmt::format("breathing, A = {}", m), fmt::format("A must {}", m),
           [&] { Breathing({.A = m, .B = 1.0}, 1.0); });
    refuse(rows, fmt::format("breathing, B = {}", m), fmt::format("B must {}", m),
           [&] { Breathing({.A = 1.0, .B = m}, 1.0); });
    refuse(rows, fmt::format("breathing, r_0 = {}", m), fmt::format("r_0 must {}", m),
           [&] { Breathing({.A = 1.0, .B = 1.0}, m); });
  }
  refuse(rows, "breathing from where the pair flies apart", "bounded starts beyond",
         [] { Breathing({.A = 1.0, .B = 2.0}, 1.0); });
  refuse(rows, "centre of mass of nothing", "at least one particle", [] {
    const kinematics::Particles none = random_cloud({.N = 0}, 1);
    kinematics::split_kinetic_energy(none.mass, none.velocity);
  });
}

const Case extremes_refused{{.name = "extremes_refused",
                             .claim = "what cannot be meant or cannot go on is refused, with the reason",
                             .equation = "M 2.1",
                             .reference = Reference::design},
                            [](Rows& rows) {
                              refuse_particles(rows);
                              refuse_laws(rows);
                              refuse_runs(rows);
                              refuse_coincidence(rows);
                              refuse_questions(rows);
                            }};

// Extreme cases that must give an answer.

NearFieldScene free_flight(Eigen::Index N) { return {random_cloud({.N = N}, 1), {}, {.alpha1 = 0.5, .alpha2 = 0.25}}; }

// A scene with one particle or none: uniform motion, no energy but its own, no moment.
Ending fly_free(Eigen::Index N) {
  NearFieldScene scene = free_flight(N);
  double worst = 0.0;
  const schemes::State start = scenes::start(scene);
  const auto fly = [&](const auto& move) {
    schemes::State state = start;
    move(state);
    const Eigen::VectorXd expected = start.r + 2.0 * start.v;
    worst = std::max(
        {worst, std::abs(state.t - 2.0), (state.r - expected).cwiseAbs().sum(), (state.v - start.v).cwiseAbs().sum()});
  };
  fly([&](schemes::State& state) { advance<schemes::RungeKutta4>(scene, state, 2.0, 8); });
  fly([&](schemes::State& state) { advance<schemes::VelocityVerlet>(scene, state, 2.0, 8); });
  if (N > 0) fly([&](schemes::State& state) { advance_by(adams, scene, state, 2.0); });
  worst = std::max({worst, std::abs(scene.potential_energy(start)), std::abs(scene.distance(start.r, start.r))});
  return Ending::solved(
      {.error = worst, .tolerance = 1e-14, .because = "uniform motion, a few roundings of values near 1"});
}

// Momenta and energy of nothing are nothing.
Ending sum_nothing() {
  const kinematics::Particles none = random_cloud({.N = 0}, 1);
  validate(none);
  const double sum = kinematics::kinetic_energy(none.mass, none.velocity) +
                     kinematics::linear_momentum(none.mass, none.velocity).norm() +
                     kinematics::angular_momentum(none.mass, none.position, none.velocity).norm();
  return Ending::solved({.error = std::abs(sum), .tolerance = 0.0, .because = "empty sums are zero"});
}

// The breathing pair over three periods; errors in units of what is allowed.
template <class Move>
Ending breathe(const kinematics::Particles& start, const ExactBreathing& exact, double alpha1, const Allowed& allowed,
               const Move& move) {
  NearFieldScene scene(start, {}, {.alpha1 = alpha1, .alpha2 = alpha1 / exact.depth(), .beta1 = 2.0, .beta2 = 3.0});
  const BreathingErrors worst =
      errors_at_tenths(exact, pair_shape(start.mass[0], start.mass[1]), scenes::start(scene), 30,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  return Ending::solved(
      {.error = std::max(worst.position / allowed.errors.position, worst.velocity / allowed.errors.velocity),
       .tolerance = 1.0,
       .because = "in units of " + allowed.because});
}

// Masses whose attraction is A = 2 whatever they are, by RK4.
Ending breathe_by_rk4(double m_i, double radius) {
  kinematics::Particles start = pair_at_rest(m_i, 1.0, 1.0);
  start.radius << radius, (radius > 0.0 ? 1.0 - radius : 0.0);
  const ExactBreathing exact{.force = {.A = 2.0, .B = 1.0}, .r_0 = 1.0};
  return breathe(start, exact, 2.0 / (m_i + 1.0), allowed_to_steps(exact, 4, exact.motion.period() / 5000.0),
                 [](auto& scene, schemes::State& state, double t_end) {
                   advance<schemes::RungeKutta4>(scene, state, t_end, 500);
                 });
}

Ending breathe_stiffly(const reference::Method& method, double global) {
  const ExactBreathing exact{.force = kinematics::breathing_pair(1.0, 0.001, 1.0, 1.0), .r_0 = 1.0};
  return breathe(pair_at_rest(1.0, 1.0, 1.0), exact, 1.0, allowed_to_tolerance(exact, global),
                 [&](auto& scene, schemes::State& state, double t_end) { advance_by(method, scene, state, t_end); });
}

// A pair under extreme exponents: inner turning point and period against its energy.
Ending steep(const kinematics::CentralForce& law, double start, long double inside, double step) {
  const ReleasedPair by_energy{.law = law, .reduced_mass = 0.5L, .start = start};
  const long double near = by_energy.nearest(inside, equilibrium_distance(law));
  const auto period = static_cast<double>(by_energy.period(near, 2000));
  NearFieldScene scene(pair_at_rest(1.0, 1.0, start), {},
                       {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2});
  const std::vector<Turning> found = turnings<schemes::RungeKutta4>(scene, scenes::start(scene), step, 2);
  // The pair's own frequency where its force is largest: V''(r_min)/m*.
  const double omega = std::sqrt(2.0 * normal_stiffness(law, static_cast<double>(near)));
  const double tolerance = 4.0 * std::pow(omega * step, 4) / 120.0 + 1e-11;
  const double error =
      std::max(std::abs(found[0].distance / static_cast<double>(near) - 1.0), std::abs(found[1].t / period - 1.0));
  return Ending::solved(
      {.error = error,
       .tolerance = tolerance,
       .because = "two passages of r_min, two radians each, with (omega h)^4/120 a radian, and 1e-11 of rounding: "
                  "powers 30 times larger than their difference"});
}

// The force is 1e-300 N: straight lines.
Ending far_apart() {
  kinematics::Particles start = pair_at_rest(1.0, 1.0, 1e150);
  kinematics::set_vector(start.velocity, 1, {1.0, 0.0, 0.0});
  NearFieldScene scene(start, {}, {.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 3.0});
  schemes::State state = scenes::start(scene);
  const schemes::State before = state;
  advance<schemes::RungeKutta4>(scene, state, 1.0, 4);
  return Ending::solved({.error = (state.v - before.v).cwiseAbs().maxCoeff(),
                         .tolerance = 1e-299,
                         .because = "1e-300 N on 1 kg for 1 s"});
}

const Case extremes_solved{
    {.name = "extremes_solved",
     .claim = "no particle, one, two just touching, masses, stiffness and exponents at their limits: all get an answer",
     .equation = "M 2.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.must_be_solved("no particle, motion", [] { return fly_free(0); });
      rows.must_be_solved("no particle, sums", sum_nothing);
      rows.must_be_solved("one particle", [] { return fly_free(1); });
      rows.must_be_solved("two particles just touching", [] { return breathe_by_rk4(1.0, 0.25); });
      rows.must_be_solved("two particles 1e150 m apart", far_apart);
      for (const double m_i : {1e12, 1e-12}) {
        rows.must_be_solved(fmt::format("mass ratio {}", m_i), [=] { return breathe_by_rk4(m_i, 0.0); });
      }
      rows.must_be_solved("alpha2 = 0.001, ARKODE Fehlberg 13(7,8)",
                          [] { return breathe_stiffly(fehlberg, global_of_runge_kutta); });
      rows.must_be_solved("alpha2 = 0.001, CVODE Adams", [] { return breathe_stiffly(adams, global_of_adams); });
      rows.must_be_solved("beta = (7, 13)", [] {
        return steep({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 7.0, .beta2 = 13.0}, 1.5, 0.5L, 1e-4);
      });
      rows.must_be_solved("beta = (0, 13)", [] {
        return steep({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 0.0, .beta2 = 13.0}, 1.5, 0.5L, 1e-4);
      });
      rows.must_be_solved("beta = (12.5, 12.9)", [] {
        return steep({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 12.5, .beta2 = 12.9}, 1.2, 0.5L, 1e-4);
      });
    }};

}  // namespace verification::extremes
