// Input that cannot be meant, and motions that cannot go on, are refused with the reason.

#include <functional>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "references.hpp"

namespace verification::extremes_refused {

using namespace particulate;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

// What ends an attempt that should not have got so far.
Ending accepted() { return Ending::solved({.error = 0.0, .tolerance = 0.0, .because = "it was accepted"}); }

Ending ending_of(const schemes::Outcome& outcome) {
  return outcome.status == schemes::Status::failed ? Ending::refused(outcome.reason) : accepted();
}

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

  // Without forces the two would pass through each other; the first step ends where they meet.
  kinematics::Particles meeting = pair_at_rest(1.0, 1.0, 2.0);
  meeting.velocity = -meeting.position;
  const laws::NearField idle{.alpha1 = 0.0, .alpha2 = 0.0};
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

}  // namespace verification::extremes_refused
