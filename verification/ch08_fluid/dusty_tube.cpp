// A tube of dusty gas whose dust follows it within a small part of the time in which sound crosses a cell: who gets
// through, and at what cost; and the speed of sound of the mixture.

#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/report/table.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "suspensions.hpp"

namespace verification::dusty_tube {

using namespace particulate;
using namespace particulate::fluid;
using suspensions::in_turn;

constexpr double dense = 0.01, theta_0 = 300.0, R = 100.0 / 420.0, c_gas = 100.0 / 168.0;  // sound at 10 m/s
constexpr double length = 100.0, c_dust = 0.6;
constexpr Eigen::Index cells = 16;

// One sphere a cell, its mass that of the gas around it times the loading. Of no real dust: a tube a metre wide has
// room for any number of spheres, and that their drag is large is all that matters.
struct Tube {
  double loading = 0.5, into = 0.0;  // and how far from the middle of each cell they stand, in cells
  double h = length / static_cast<double>(cells), b = 25.0, mu = 0.03, h_c = 4e-4;
  double mass = loading * dense * h, tau = mass / (6.0 * std::numbers::pi * mu * b);

  GasFlow<1> flow() const {
    return {Grid<1>{.cells = {cells}, .lengths = Vector<1>(length)},
            {.state = {.R = R}, .viscosity = {.mu = mu}, .c = c_gas, .K = 0.0},
            {}};
  }
  kinematics::Particles dust() const {
    std::vector<kinematics::Particle> all;
    for (Eigen::Index i = 0; i < cells; ++i) {
      const auto k = static_cast<double>(i);
      all.push_back({.position = {(k + 0.5 + into) * h, 100.0 * k, 0.0}, .mass = mass, .radius = b});
      all.back().temperature = theta_0, all.back().heat_capacity = c_dust;
    }
    return kinematics::particles(all);
  }
  auto suspension(double cells_wide) const {
    return Suspension(flow(), dust(), Spreading{.w = cells_wide * h}, HeatExchange{.h_c = h_c});
  }
  // A standing wave, at rest and as warm everywhere at the start: part of it is not sound, and does not move.
  Local<1> wave(double amplitude, const Vector<1>& x) const {
    return {.rho = dense * (1.0 + amplitude * std::cos(2.0 * std::numbers::pi * x[0] / length)), .theta = theta_0};
  }
};

// The same as one vector (r | v | y) in two parts: what dust and gas exchange is fast, all else slow.
class InParts {
 public:
  InParts(const Tube& tube, double cells_wide)
      : suspension_(tube.suspension(cells_wide)),
        flow_(tube.flow()),
        hats_(flow_.grid(), flow_.boundaries(), Eigen::VectorXd::Constant(cells, cells_wide * tube.h)),
        exchange_(suspension_.particles(), 1, hats_.half_width(), false, HeatExchange{.h_c = tube.h_c}) {}

  bool rate(double t, schemes::In y, schemes::Out dy) const {
    dy.head(N) = y.segment(N, N);
    return suspension_.rates(t, y.head(N), y.segment(N, N), y.tail(y.size() - 2 * N), dy.segment(N, N),
                             dy.tail(y.size() - 2 * N));
  }
  bool rate_slow(double t, schemes::In y, schemes::Out dy) const {
    dy.setZero();
    dy.head(N) = y.segment(N, N);
    return flow_.rate(t, y.segment(2 * N, flow_.size()), dy.segment(2 * N, flow_.size()));
  }
  bool rate_fast(double t, schemes::In y, schemes::Out dy) const {
    dy.setZero();
    if (!flow_.measure(t, y.segment(2 * N, flow_.size())) || !hats_.place(y.head(N))) return false;
    flow_.gather(hats_, exchange_.around);
    if (!exchange_.rates(y.segment(N, N), y.tail(cells), force_, heat_)) return false;
    hats_.spread(exchange_.given().data(), 2, 2, -1.0 / flow_.grid().h(0), dy.data() + 2 * N + cells);
    const kinematics::Particles& p = suspension_.particles();
    dy.segment(N, N).array() = force_.array() / p.mass.replicate(3, 1).array();
    dy.tail(cells).array() = heat_.array() / (p.mass.array() * p.heat_capacity.array());
    return true;
  }
  static schemes::State joined(const schemes::State& at) {
    schemes::State one{.t = at.t, .r = {}, .v = {}, .y = Eigen::VectorXd(2 * N + at.y.size())};
    one.y << at.r, at.v, at.y;
    return one;
  }
  static schemes::State parted(const schemes::State& at) {
    return {.t = at.t, .r = at.y.head(N), .v = at.y.segment(N, N), .y = at.y.tail(at.y.size() - 2 * N)};
  }

 private:
  static constexpr Eigen::Index N = 3 * cells;
  decltype(Tube{}.suspension(1.0)) suspension_;
  GasFlow<1> flow_;
  mutable Hats<1> hats_;
  mutable Exchange exchange_;
  mutable Eigen::VectorXd force_, heat_;
};

// A wave of a tenth for as long as the gas alone carries sound through six cells; no sphere crosses the middle of a
// cell.
struct Race {
  Tube tube{.into = 0.5};
  InParts parts{tube, 2.0};
  decltype(tube.suspension(2.0)) suspension = tube.suspension(2.0);
  schemes::State start = suspension.start([this](const Vector<1>& x) { return tube.wave(0.1, x); });
  double t_end = 4.0;
  schemes::State truth = start;

  double settle() {
    const reference::ExplicitRungeKutta fehlberg{
        .table = reference::Table::fehlberg_13_7_8, .relative = 1e-13, .absolute = 1e-14};
    require_reached(reference::integrate(suspension, truth, t_end, fehlberg));
    schemes::State other = InParts::joined(start);
    require_reached(reference::integrate(parts, other, t_end, reference::Bdf{.relative = 1e-11, .absolute = 1e-13}));
    return error(InParts::parted(other));
  }
  double error(const schemes::State& at) const { return suspensions::error(suspension, at, truth); }

  // How a method ends, its error and what it took.
  struct Run {
    schemes::Outcome outcome;
    double error, seconds;
  };
  Run run(const std::function<schemes::Outcome(schemes::State&)>& method, bool as_one = false) const {
    schemes::State state = as_one ? InParts::joined(start) : start;
    const auto began = std::chrono::steady_clock::now();
    const schemes::Outcome outcome = method(state);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    return {outcome, error(as_one ? InParts::parted(state) : state), took.count()};
  }
  template <class Scheme, class Control>
  Run ours(Scheme scheme, Control control) const {
    return run([&](schemes::State& state) { return integrate(suspension, state, t_end, scheme, control); });
  }
  Run theirs(const reference::Method& method) const {
    return run([&](schemes::State& state) { return reference::integrate(parts, state, t_end, method); }, true);
  }
};

using Radau = schemes::Collocation<schemes::Radau<3>, schemes::Newton<>>;

void tabulate(const Race& race, report::Table& table, bool quick) {
  const auto add = [&](const char* method, double setting, const Race::Run& run) {
    const bool solved = run.outcome.status == schemes::Status::reached;
    table.add({method, setting, solved ? "solved" : std::string(name(run.outcome.failure)), run.error,
               run.outcome.steps, run.outcome.evaluations, run.seconds});
  };
  for (const double TOL : quick ? std::vector{1e-4} : std::vector{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    add("CVODE BDF", TOL, race.theirs(reference::Bdf{.relative = TOL, .absolute = 1e-3 * TOL}));
    add("ARKODE IMEX", TOL, race.theirs(reference::ImplicitExplicit{.relative = TOL, .absolute = 1e-3 * TOL}));
    add("ARKODE explicit", TOL, race.theirs(reference::ExplicitRungeKutta{.relative = TOL, .absolute = 1e-3 * TOL}));
    add("Radau 3, Newton", TOL,
        race.ours(Radau(), schemes::ErrorControl{.TOL = TOL, .sweep_TOL = 0.01 * TOL, .limit = race.t_end}));
  }
  for (const double over : quick ? std::vector{100.0} : std::vector{100.0, 50.0, 25.0, 10.0, 1.0}) {
    const double step = over * race.tube.tau;
    add("one sweep", step, race.ours(in_turn(race.suspension), schemes::FixedSweeps{.step = step, .sweeps = 1}));
    add("staggering", step,
        race.ours(in_turn(race.suspension),
                  schemes::PhiControl{.TOL = 1.0, .step = 0.1 * step, .limit = step, .spare = 2}));
  }
  for (const double over : {1.0, 0.5, 0.25}) {
    const double step = over * race.tube.tau;
    add("RK4", step, race.ours(schemes::RungeKutta4(), schemes::FixedStep{.step = step}));
  }
}

void compare_long_steps(Rows& rows, const Race& race) {
  const double step = 100.0 * race.tube.tau;
  const auto within = [&](const std::string& who, double most, const Race::Run& run, const char* because) {
    rows.must_be_solved(who + ", steps of 100 tau_p", [&] {
      return run.outcome.status == schemes::Status::reached
                 ? Ending::solved({.error = run.error, .tolerance = most, .because = because})
                 : Ending::refused(run.outcome.reason);
    });
  };
  within("ARKODE IMEX", 0.05, race.theirs(reference::ImplicitExplicit{.fixed_step = step}),
         "of order 4, with c Dt/h = 0.35");
  within("Radau 3, Newton", 0.05, race.ours(Radau(), schemes::FixedStep{.step = step}),
         "of order 5, with c Dt/h = 0.35");
  within("one sweep", 1.0, race.ours(in_turn(race.suspension), schemes::FixedSweeps{.step = step, .sweeps = 1}),
         "of order 1: it stays stable, no more is claimed");
  rows.must_be_refused("RK4, steps of 100 tau_p", "span 2.78529 drag take at most", [&] {
    return ending_of(race.ours(schemes::RungeKutta4(), schemes::FixedStep{.step = step}).outcome);
  });
  rows.must_be_refused("ARKODE explicit, steps of 100 tau_p", "no value", [&] {
    return ending_of(race.theirs(reference::ExplicitRungeKutta{.fixed_step = step}).outcome);
  });
  const Race::Run bdf = race.theirs(reference::Bdf{.relative = 1e-3, .absolute = 1e-6});
  rows.at_least("CVODE BDF at 1e-3, mean step over tau_p",
                {.limit = 10.0,
                 .computed = race.t_end / static_cast<double>(bdf.outcome.steps) / race.tube.tau,
                 .because = "it follows sound alone"});
}

const Case stiff{
    {.name = "dusty_tube",
     .claim = "where drag is stiff, IMEX, Radau collocation and one sweep make steps of a hundred tau_p, and "
              "BDF steps that sound alone bounds; explicit schemes do not",
     .equation = "R 8.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      Race race;
      const schemes::State one = InParts::joined(race.start);
      Eigen::VectorXd whole(one.y.size()), slow(one.y.size()), fast(one.y.size());
      Eigen::VectorXd moved = one.y;
      moved.segment(3 * cells, cells).setConstant(0.02);
      (void)race.parts.rate(0.0, moved, whole);
      (void)race.parts.rate_slow(0.0, moved, slow);
      (void)race.parts.rate_fast(0.0, moved, fast);
      rows.compare("slow and fast parts, against the suspension",
                   {.expected = 0.0,
                    .computed = (slow + fast - whole).lpNorm<Eigen::Infinity>() / whole.lpNorm<Eigen::Infinity>(),
                    .tolerance = absolute(1e-14),
                    .because = "rounding"});
      rows.at_most("unknowns", {.limit = 300.0,
                                .computed = static_cast<double>(one.y.size()),
                                .because = "Jacobians of difference quotients"});
      rows.at_most("CVODE BDF against ARKODE",
                   {.limit = 1e-7, .computed = race.settle(), .because = "BDF has a floor of some 1e-9"});
      compare_long_steps(rows, race);
      report::Table table({"method", "setting", "ends", "error", "steps", "evaluations", "seconds"});
      tabulate(race, table, rows.quick());
      rows.write("dusty_tube", table);
    }};

// --- Sound. Dust that follows at once adds its mass and its heat capacity: gamma = 1 + R/(c + Z c_p), and
// c^2 = gamma R theta/(1 + Z). Spheres that stand between two cells feel the mean of both, and give each a half: of a
// wave they feel cos(k h/2), and so much less they weigh, twice. Viscosity damps, w^2 + i w nu K - (c k')^2 = 0: the
// product of both roots stays (c k')^2.
double measured_frequency(const Tube& tube) {
  constexpr double amplitude = 1e-6;
  const auto suspension = tube.suspension(1.0);
  schemes::State state = suspension.start([&](const Vector<1>& x) { return tube.wave(amplitude, x); });
  std::vector<double> seen;
  constexpr double first = 1.0, apart = 2.0;
  for (int k = 0; k < 4; ++k) {
    reach(suspension, state, first + k * apart, schemes::Collocation<schemes::Radau<5>, schemes::Newton<>>(),
          schemes::FixedStep{.step = 0.25, .TOL = 1e-8});
    double sum = 0.0;
    for (Eigen::Index i = 0; i < cells; ++i) {
      sum += state.y[cells + i] / dense *
             std::sin(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(cells));
    }
    seen.push_back(sum / amplitude);
  }
  // x_{k+2} = p x_{k+1} - q x_k with q = exp(-2 d T), p = 2 exp(-d T) cos(w T).
  const double below = seen[0] * seen[2] - seen[1] * seen[1];
  const double q = (seen[1] * seen[3] - seen[2] * seen[2]) / below, p = (seen[0] * seen[3] - seen[1] * seen[2]) / below;
  const double decay = -0.5 * std::log(q) / apart, w = std::acos(0.5 * p / std::sqrt(q)) / apart;
  return std::hypot(w, decay);
}

const Case mixture{
    {.name = "sound_of_a_dusty_gas",
     .claim = "sound in a gas whose dust follows at once has the speed of a heavier gas of another gamma: "
              "c^2 = (1 + R/(c + Z c_p)) R theta/(1 + Z)",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double loading : {0.01, 0.5, 3.0}) {
        const Tube tube{.loading = loading, .into = 0.5};
        const double Z = loading * std::pow(std::cos(std::numbers::pi * tube.h / length), 2);
        const double gamma = 1.0 + R / (c_gas + Z * c_dust), c = std::sqrt(gamma * R * theta_0 / (1.0 + Z));
        const double k = std::sin(2.0 * std::numbers::pi * tube.h / length) / tube.h;
        rows.compare(
            fmt::format("frequency, loading {}, tau_p = {:.3g} s [rad/s]", loading, tube.tau),
            {.expected = c * k,
             .computed = measured_frequency(tube),
             .tolerance = relative(3e-5),
             .because = "squares of the lag, w tau_p up to 0.0025, and of that of temperatures, twice as much"});
      }
    }};

}  // namespace verification::dusty_tube
