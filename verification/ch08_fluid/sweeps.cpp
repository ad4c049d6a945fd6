// Sweeps over the fields of a fluid: how they contract, which steps they bear, and which they settle at.

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>

namespace verification::fluid_sweeps {

using namespace particulate;

constexpr double rho_R = 1000.0;

// A periodic box of 1 m, as many cells in each direction, inviscid and without conduction unless said otherwise.
template <int Dim, class E>
fluid::Flow<Dim, E> boxed(const E& law, Eigen::Index cells, double mu = 0.0, double K = 0.0) {
  fluid::Grid<Dim> grid;
  grid.cells.fill(cells);
  return {grid, {.state = law, .viscosity = {.mu = mu}, .c = 2500.0, .K = K}, {}};
}

continuum::Barotropic barotropic(double Y = 1e5) { return {.Y = Y, .rho_R = rho_R}; }

schemes::Staggered in_turn(bool has_heat) {
  std::vector<schemes::Field> fields{{.name = "density", .p = 2}, {.name = "momentum", .p = 2}};
  if (has_heat) fields.push_back({.name = "energy", .p = 2});
  return schemes::Staggered(fields);
}

// A sound wave that travels, of 4 cells a wavelength along the first few axes, of so small an amplitude that it is
// linear.
template <int Dim, class E>
schemes::State wave(const fluid::Flow<Dim, E>& flow, double rho, double c, int axes) {
  constexpr double amplitude = 1e-7;
  const double k = 0.5 * std::numbers::pi / flow.grid().h(0);
  return flow.start([&](const fluid::Vector<Dim>& x) {
    const double here = amplitude * std::cos(k * x.head(axes).sum());
    fluid::Local<Dim> at{.rho = rho * (1.0 + here)};
    at.v.head(axes).setConstant(c * here / std::sqrt(axes));
    return at;
  });
}

// Of all fields the contraction in the last of four sweeps that is furthest from what is expected.
template <int Dim, class E>
double contraction(const fluid::Flow<Dim, E>& flow, const schemes::State& from, double dt, double expected) {
  const schemes::Problem problem(flow);
  schemes::Staggered scheme = in_turn(flow.has_heat);
  schemes::State to;
  (void)scheme.predict(problem, from, dt, to);
  for (int sweep = 0; sweep < 4; ++sweep) (void)scheme.sweep(problem, from, dt, to);
  double furthest = expected;
  for (const schemes::Iteration& it : scheme.iterations()) {
    if (!(std::abs(it.rate - expected) <= std::abs(furthest - expected))) furthest = it.rate;
  }
  return furthest;
}

template <int Dim, class E>
void compare_contraction(Rows& rows, const std::string& name, const E& law, double rho, double c, double z, int axes) {
  const fluid::Flow<Dim, E> flow = boxed<Dim>(law, 4);
  const double expected = axes * z * z;
  rows.compare(fmt::format("{}, {}-D, z = {}, along {} of the axes", name, Dim, z, axes),
               {.expected = expected,
                .computed = contraction(flow, wave(flow, rho, c, axes), z * flow.grid().h(0) / c, expected),
                .tolerance = relative(1e-5),
                .because = "an amplitude of 1e-7, and its rounding after four sweeps"});
}

const Case contractions{
    {.name = "contraction_of_sweeps",
     .claim =
         "a sweep over density, momentum and energy of a fluid at rest contracts by (c Dt/h)^2 for each axis along "
         "which a wave has 4 cells, whatever its stiffness",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double Y : {1e5, 1e6, 1e7, 1e8, 1e9, 1e10}) {
        compare_contraction<1>(rows, fmt::format("barotropic, Y = {:g}", Y), barotropic(Y), rho_R, std::sqrt(Y / rho_R),
                               0.5, 1);
      }
      const double c = std::sqrt(1e9 / rho_R);
      for (const double z : {0.25, 0.999})
        compare_contraction<1>(rows, "barotropic, Y = 1e9", barotropic(1e9), rho_R, c, z, 1);
      for (const int axes : {1, 2})
        compare_contraction<2>(rows, "barotropic, Y = 1e9", barotropic(1e9), rho_R, c, 0.5, axes);
      for (const int axes : {1, 2, 3})
        compare_contraction<3>(rows, "barotropic, Y = 1e9", barotropic(1e9), rho_R, c, 0.5, axes);
      for (const double Y : {1e5, 1e10}) {
        const continuum::LinearizedState liquid{.Y = Y, .a_th = 0.0};
        compare_contraction<1>(rows, fmt::format("liquid, Y = {:g}", Y), liquid, rho_R, std::sqrt(Y / rho_R), 0.5, 1);
        compare_contraction<3>(rows, fmt::format("liquid, Y = {:g}", Y), liquid, rho_R, std::sqrt(Y / rho_R), 0.5, 3);
      }
      // Momentum sees the energy, which sees momentum: the sound is that of gamma = 1 + R/c.
      const continuum::IdealGas air;
      const double sound = std::sqrt((1.0 + air.R / 2500.0) * air.R * 300.0);
      compare_contraction<1>(rows, "gas", air, 1.2, sound, 0.5, 1);
      compare_contraction<3>(rows, "gas", air, 1.2, sound, 0.5, 3);
    }};

// One step, made by hand: no limit is in the way.
using Step =
    std::function<void(const schemes::Problem& problem, const schemes::State& from, double dt, schemes::State& to)>;
Step sweeping(int sweeps, bool has_heat = false) {
  return [sweeps, scheme = in_turn(has_heat)](const schemes::Problem& problem, const schemes::State& from, double dt,
                                              schemes::State& to) mutable {
    (void)scheme.predict(problem, from, dt, to);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      if (!scheme.sweep(problem, from, dt, to).evaluated) throw std::runtime_error("a sweep without a value");
    }
  };
}
Step by_rk4() {
  return [scheme = schemes::RungeKutta4()](const schemes::Problem& problem, const schemes::State& from, double dt,
                                           schemes::State& to) mutable {
    if (!scheme.predict(problem, from, dt, to)) throw std::runtime_error("a step without a value");
  };
}

double spectral_radius(const Eigen::Matrix2d& A) {
  const double half = 0.5 * A.trace(), product = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0), apart = half * half - product;
  return apart < 0.0 ? std::sqrt(product) : std::abs(half) + std::sqrt(apart);
}

// Four cells in one dimension, and in them a standing wave of sound: density as cos kx, momentum as sin kx.
struct Standing {
  fluid::BarotropicFlow<1> flow = boxed<1>(barotropic(), 4);
  double c = 10.0, k = 2.0 * std::numbers::pi, amplitude = 1e-7;

  schemes::State start(double density, double momentum) const {
    return flow.start([&](const fluid::Vector<1>& x) {
      const double rho = rho_R * (1.0 + amplitude * density * std::cos(k * x[0]));
      return fluid::Local<1>{.rho = rho, .v = fluid::Vector<1>(c * amplitude * momentum * std::sin(k * x[0]))};
    });
  }
  Eigen::Vector2d of(const schemes::State& at) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double x = flow.grid().centre({i})[0];
      sum[0] += 0.5 / amplitude * (at.y[i] / rho_R - 1.0) * std::cos(k * x);
      sum[1] += 0.5 / amplitude * at.y[4 + i] / (rho_R * c) * std::sin(k * x);
    }
    return sum;
  }
  // What so many steps make of a start.
  Eigen::Vector2d after(Step step, double z, long steps, double density, double momentum) const {
    const schemes::Problem problem(flow);
    schemes::State from = start(density, momentum), to;
    for (long n = 0; n < steps; ++n, std::swap(from, to)) step(problem, from, z * flow.grid().h(0) / c, to);
    return of(from);
  }
  // The same of any start: its map of (density, momentum), column by column.
  Eigen::Matrix2d map(const Step& step, double z, long steps) const {
    Eigen::Matrix2d columns;
    columns << after(step, z, steps, 1.0, 0.0), after(step, z, steps, 0.0, 1.0);
    return columns;
  }
};

// The same of one step after the scheme's formula, from rho' = rho_0 - z u and u' = u_0 + z rho'.
Eigen::Matrix2d sweeps_by_formula(double z, int sweeps) {
  Eigen::Matrix2d columns;
  for (int column = 0; column < 2; ++column) {
    const double rho_0 = column == 0, u_0 = column == 1;
    double rho = rho_0, u = u_0;
    for (int sweep = 0; sweep < sweeps; ++sweep) rho = rho_0 - z * u, u = u_0 + z * rho;
    columns.col(column) = Eigen::Vector2d(rho, u);
  }
  return columns;
}
Eigen::Matrix2d rk4_by_formula(double z) {
  const double even = 1.0 - z * z / 2.0 + std::pow(z, 4) / 24.0, odd = z - std::pow(z, 3) / 6.0;
  return Eigen::Matrix2d{{even, -odd}, {odd, even}};
}

// Growth a step, over as many steps as change the amplitude by a factor of some three.
void compare_growth(Rows& rows, const std::string& name, const Step& step, double z, const Eigen::Matrix2d& formula) {
  const double expected = spectral_radius(formula);
  const auto steps = static_cast<long>(1.0 / std::max(1e-3, std::abs(std::log(expected))));
  const double computed = std::pow(spectral_radius(Standing{}.map(step, z, steps)), 1.0 / static_cast<double>(steps));
  rows.compare(fmt::format("growth a step, {}, z = {:.6g}", name, z),
               {.expected = expected,
                .computed = computed,
                .tolerance = absolute(1e-7),
                .because = fmt::format("an amplitude of 1e-7 and its rounding, over {} steps", steps)});
}

void compare_limit(Rows& rows, const std::string& name, const Step& step, double limit, double most,
                   const std::function<Eigen::Matrix2d(double)>& formula, long steps) {
  for (const double share : {0.999, 1.001}) compare_growth(rows, name, step, share * limit, formula(share * limit));
  rows.at_most(fmt::format("amplitude after {} steps over the first, {}, z = {:.6g}", steps, name, 0.999 * limit),
               {.limit = most,
                .computed = Standing{}.after(step, 0.999 * limit, steps, 1.0, 1.0).norm() / std::numbers::sqrt2,
                .because = "rho^2 + u^2 - z rho u is kept by one sweep, and falls by the others"});
}

const Case stability{
    {.name = "stability_of_sweeps",
     .claim =
         "sound is stable to z = c Dt/h = 2 with one sweep, to 1 with two to twelve, to 2 sqrt 2 by RK4, and grows "
         "beyond as the formula of the scheme says",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const int sweeps : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}) {
        compare_limit(
            rows, fmt::format("{} sweeps", sweeps), sweeping(sweeps), sweeps == 1 ? 2.0 : 1.0, sweeps == 1 ? 45.0 : 2.0,
            [=](double z) { return sweeps_by_formula(z, sweeps); }, rows.full() || sweeps <= 2 ? 10000 : 300);
      }
      compare_limit(rows, "RK4", by_rk4(), 2.0 * std::numbers::sqrt2, 2.0, rk4_by_formula, 10000);
      // Digits of the catalogue.
      const auto digits = [&](int sweeps, double growth) {
        rows.compare(fmt::format("growth a step at z = 1.001, {} sweeps", sweeps),
                     {.expected = growth,
                      .computed = spectral_radius(Standing{}.map(sweeping(sweeps), 1.001, 1)),
                      .tolerance = absolute(5e-4),
                      .because = "three digits are known"});
      };
      digits(2, 1.002);
      digits(3, 1.001);
      digits(12, 1.012);
    }};

// What diffuses fastest in one dimension: cells that alternate. Sound does not feel them: no pressure changes with
// velocities that alternate, nor with temperatures where a_th = 0.
template <class E>
struct Alternating {
  fluid::Flow<1, E> flow;
  Eigen::Index field;  // which of (rho, rho v, E)
  double rate;         // at which they fade, by formula [1/s]

  schemes::State start() const {
    schemes::State at = flow.start([](const fluid::Vector<1>&) { return fluid::Local<1>{.rho = rho_R}; });
    for (Eigen::Index i = 0; i < 4; ++i) at.y[4 * field + i] += i % 2 == 0 ? 1.0 : -1.0;
    return at;
  }
  double of(const schemes::State& at) const {
    const auto y = at.y.segment<4>(4 * field);
    return 0.25 * (y[0] - y[1] + y[2] - y[3]);
  }
  double growth(Step step, double D, long steps) const {
    const schemes::Problem problem(flow);
    schemes::State from = start(), to;
    const double before = of(from);
    for (long n = 0; n < steps; ++n, std::swap(from, to)) step(problem, from, D / rate, to);
    return std::pow(std::abs(of(from) / before), 1.0 / static_cast<double>(steps));
  }
  double contraction(double D) const {
    const schemes::Problem problem(flow);
    const schemes::State from = start();
    schemes::Staggered scheme = in_turn(flow.has_heat);
    schemes::State to;
    (void)scheme.predict(problem, from, D / rate, to);
    double seen = 0.0;
    for (int sweep = 0; sweep < 4; ++sweep) seen = scheme.sweep(problem, from, D / rate, to).rate;
    return seen;
  }
};

const Case diffusion{
    {.name = "stability_of_diffusion",
     .claim = "viscosity and conduction are stable to lambda Dt = 2 with one sweep and to 2.785 by RK4, and sweeps "
              "contract by lambda Dt, lambda = 4/h^2 times (2 mu + lambda)/rho or K/(rho c)",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto check = [&](const std::string& name, const auto& alternating) {
        const auto compare = [&](const std::string& quantity, double expected, double computed) {
          rows.compare(name + ", " + quantity, {.expected = expected,
                                                .computed = computed,
                                                .tolerance = absolute(1e-6),
                                                .because = "an amplitude of 1e-9 of what there is at least"});
        };
        const bool has_heat = alternating.flow.has_heat;
        for (const double D : {1.998, 2.002}) {
          compare(fmt::format("growth a step, one sweep, lambda Dt = {}", D), std::abs(1.0 - D),
                  alternating.growth(sweeping(1, has_heat), D, 1000));
        }
        for (const double share : {0.999, 1.001}) {
          const double D = share * 2.785293563405282;
          compare(fmt::format("growth a step, RK4, lambda Dt = {:.6g}", D),
                  1.0 - D + D * D / 2.0 - std::pow(D, 3) / 6.0 + std::pow(D, 4) / 24.0,
                  alternating.growth(by_rk4(), D, 1000));
        }
        for (const double D : {0.25, 0.999, 1.001})
          compare(fmt::format("contraction, lambda Dt = {}", D), D, alternating.contraction(D));
      };
      // h = 1/4 m: 4/h^2 = 64 per square metre.
      check("viscosity",
            Alternating<continuum::Barotropic>{
                .flow = boxed<1>(barotropic(), 4, 3.0), .field = 1, .rate = 64.0 * (4.0 / 3.0) * 3.0 / rho_R});
      const continuum::LinearizedState liquid{.Y = 1e5, .a_th = 0.0};
      check("conduction",
            Alternating<continuum::LinearizedState>{
                .flow = boxed<1>(liquid, 4, 0.0, 500.0), .field = 2, .rate = 64.0 * 500.0 / (rho_R * 2500.0)});
    }};

// A map of states that leaves one unmoved, as a matrix: what becomes of a small change of each number, by central
// differences in units that make densities, momenta and energies alike.
using Map = std::function<void(const schemes::State& from, schemes::State& to)>;
Eigen::MatrixXd linearized(const Map& map, const schemes::State& at, const Eigen::VectorXd& units) {
  constexpr double small = 1e-5;
  const Eigen::Index N = at.y.size();
  Eigen::MatrixXd columns(N, N);
  schemes::State moved = at, up, down;
  for (Eigen::Index i = 0; i < N; ++i) {
    moved.y[i] = at.y[i] + small * units[i];
    map(moved, up);
    moved.y[i] = at.y[i] - small * units[i];
    map(moved, down);
    moved.y[i] = at.y[i];
    columns.col(i) = ((up.y - down.y).array() / (2.0 * small * units.array())).matrix();
  }
  return columns;
}

// Growth at each application of a matrix, in the mean of 2^26: above its spectral radius by 1e-7 at most.
double growth_of(Eigen::MatrixXd A) {
  double logarithm = 0.0, applied = 1.0;
  for (int k = 0; k <= 26; ++k) {
    const double size = A.norm();
    logarithm += std::log(size) / applied;
    A = ((A / size) * (A / size)).eval();
    applied *= 2.0;
  }
  return std::exp(logarithm);
}

// A gas that drifts as a whole; c = 17 m/s.
template <int Dim>
struct Drifting {
  fluid::GasFlow<Dim> flow;
  schemes::State at;
  Eigen::VectorXd units;

  Drifting(double mach, double mu, double K)
      : flow(boxed<Dim>(continuum::IdealGas{.R = 1.0}, Dim == 1 ? 8 : 4, mu, K)) {
    at = flow.start([=](const auto&) {
      fluid::Local<Dim> here{.rho = 1.0};
      for (int a = 0; a < Dim; ++a) here.v[a] = mach * std::sqrt(300.0) / (1.0 + a);
      return here;
    });
    const Eigen::Index N = flow.grid().size();
    units.resize(at.y.size());
    units.head(N).setConstant(1.0);
    units.segment(N, Dim * N).setConstant(std::sqrt(300.0));
    units.tail(N).setConstant(2500.0 * 300.0);
  }
  // The time scale of that name.
  double scale(std::string_view name) const {
    for (const schemes::TimeScale& each : flow.step_limits(at)) {
      if (each.name.starts_with(name)) return each.seconds;
    }
    return std::numeric_limits<double>::infinity();
  }
  // How long sound takes through the box of 1 m [s].
  double crossing() const { return 1.0 / std::sqrt(300.0 * (1.0 + 1.0 / 2500.0)); }
  // The largest fixed step that is not refused.
  template <class S, class C>
  double workable(S scheme, C control) const {
    schemes::State state = at;
    control.step = 1e6;
    return schemes::integrate(flow, state, 1e6, scheme, control).workable_step;
  }
  double growth(Step step, double dt) const {
    const schemes::Problem problem(flow);
    return growth_of(linearized([&](const auto& from, auto& to) { step(problem, from, dt, to); }, at, units));
  }
  // Of sweeps: what becomes of a change of the values that they see.
  double contraction(double dt) const {
    const schemes::Problem problem(flow);
    const auto sweep = [&](const schemes::State& seen, schemes::State& to) {
      schemes::Staggered scheme = in_turn(true);
      (void)scheme.predict(problem, at, dt, to);
      to.y = seen.y;
      if (!scheme.sweep(problem, at, dt, to).evaluated) throw std::runtime_error("a sweep without a value");
    };
    return growth_of(linearized(sweep, at, units));
  }
};

// The worst over streams and over how much of the step viscosity and conduction ask for themselves.
template <int Dim, class Seen>
double worst_of(bool quick, const std::vector<double>& machs, Seen&& seen) {
  const std::vector<double> coarse{0.0, 0.3, 1.0}, fine{0.0, 0.03, 0.3, 1.0, 3.0}, ends{0.0, 1.0}, all{0.0, 0.3, 1.0};
  double worst = 0.0;
  for (const double mach : machs) {
    for (const double viscous : quick ? coarse : fine) {
      for (const double conducts : quick ? ends : all) {
        const Drifting<Dim> unit(mach, 1.0, 1.0);
        const double sound = unit.scale("sound");
        const Drifting<Dim> flow(mach, viscous * unit.scale("viscosity") / sound,
                                 conducts * unit.scale("conduction") / sound);
        const double growth = seen(flow);
        if (!(growth <= worst)) worst = growth;
      }
    }
  }
  return worst;
}

template <int Dim>
void scan(Rows& rows) {
  const std::vector<double> at_rest{0.0}, streams{0.1, 0.5}, all{0.0, 0.1, 0.5};
  const auto compare = [&](const std::string& name, double limit, const std::vector<double>& machs, auto seen) {
    rows.at_most(fmt::format("{}-D, {}, just within the limit", Dim, name),
                 {.limit = limit + 1e-6,
                  .computed = worst_of<Dim>(rows.quick(), machs, seen),
                  .because = "differences of 1e-5, and the mean of 2^26 applications"});
  };
  compare("growth a step by RK4", 1.0, all, [](const Drifting<Dim>& of) {
    return of.growth(by_rk4(), 0.999 * of.workable(schemes::RungeKutta4(), schemes::FixedStep{}));
  });
  for (const int sweeps : {1, 2, 3}) {
    const auto step = [=](const Drifting<Dim>& of) {
      return 0.999 * of.workable(in_turn(true), schemes::FixedSweeps{.sweeps = sweeps});
    };
    compare(fmt::format("growth a step with {} sweeps, at rest", sweeps), 1.0, at_rest,
            [=](const Drifting<Dim>& of) { return of.growth(sweeping(sweeps, true), step(of)); });
    compare(fmt::format("growth with {} sweeps while sound crosses the box", sweeps), std::numbers::e, streams,
            [=](const Drifting<Dim>& of) {
              return std::pow(of.growth(sweeping(sweeps, true), step(of)), of.crossing() / step(of));
            });
  }
  compare("contraction of sweeps", 1.0, all, [](const Drifting<Dim>& of) {
    return of.contraction(0.999 * of.workable(in_turn(true), schemes::FixedStep{}));
  });
}

const Case combined{
    {.name = "limits_of_sound_and_diffusion",
     .claim = "just within the step that its limits allow no scheme lets a disturbance of a viscous gas that conducts "
              "heat grow, or on a stream below the speed of sound by less than e while sound crosses the box; and "
              "sweeps contract",
     .equation = "D 8.4",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      scan<1>(rows);
      scan<2>(rows);
    }};

// The changes that sweep after sweep makes of a wave that travels, over that of the first, the worse of density and
// momentum: after the formula, from rho' = rho_0 - i z u and u' = u_0 - i z rho'.
double error_by_formula(double z, int K_d) {
  const std::complex<double> start = 1.0, iz(0.0, z);
  std::complex<double> rho = start, u = start;
  double first_rho = 0.0, first_u = 0.0, worst = 0.0;
  for (int K = 0; K <= K_d; ++K) {
    const std::complex<double> newer_rho = start - iz * u, newer_u = start - iz * newer_rho;
    const double change_rho = std::abs(newer_rho - rho), change_u = std::abs(newer_u - u);
    if (K == 0) first_rho = change_rho, first_u = change_u;
    worst = std::max(change_rho / first_rho, change_u / first_u);
    rho = newer_rho, u = newer_u;
  }
  return worst;
}
double settling_by_formula(double TOL, int K_d) {
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) (error_by_formula(0.5 * (low + high), K_d) < TOL ? low : high) = 0.5 * (low + high);
  return low;
}

const Case settling{
    {.name = "step_that_sweeps_settle_at",
     .claim = "the monograph's control makes steps up to that at which the sweeps over a sound wave meet TOL in K_d "
              "contractions, about half of what sound crosses a cell in",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const fluid::BarotropicFlow<1> flow = boxed<1>(barotropic(), 16);
      for (const auto& [TOL, K_d] :
           {std::pair(1e-6, 10), std::pair(1e-4, 10), std::pair(1e-6, 6), std::pair(1e-5, 15)}) {
        schemes::State state = wave(flow, rho_R, 10.0, 1);
        const schemes::Staggered scheme(
            {{.name = "density", .TOL = TOL, .p = 2}, {.name = "momentum", .TOL = TOL, .p = 2}});
        const double h_over_c = flow.grid().h(0) / 10.0;
        double longest = 0.0;
        require_reached(
            schemes::integrate(flow, state, 30.0 * h_over_c, schemes::Staggered(scheme),
                               schemes::PhiControl{.TOL = 1.0, .K_d = K_d, .step = 0.1 * h_over_c, .limit = 1.0},
                               [&](const auto&, const auto&, double dt, const auto&) {
                                 longest = std::max(longest, dt / h_over_c);
                                 return true;
                               }));
        rows.compare(
            fmt::format("longest c Dt/h, TOL = {:g}, K_d = {}", TOL, K_d),
            {.expected = settling_by_formula(TOL, K_d),
             .computed = longest,
             .tolerance = relative(0.03),
             .because = "how the wave lies in the cells changes its sums by a seventh, and those to the power 1/20"});
      }
    }};

// What ends an adaptive step that would grow and grow, of sweeps that are hardly asked to converge.
template <int Dim, class E>
std::string ruled(const fluid::Flow<Dim, E>& flow, const fluid::Local<Dim>& local, double t_end) {
  schemes::State state = flow.start([&](const auto&) { return local; });
  std::vector<schemes::Field> fields(flow.fields(), {.name = "field", .TOL = 1e3});
  return schemes::integrate(flow, state, t_end, schemes::Staggered(fields),
                            schemes::PhiControl{.TOL = 1.0, .step = 1e-3 * t_end, .limit = t_end})
      .ruled;
}

const Case names{
    {.name = "what_rules_a_step",
     .claim = "an adaptive run tells which mechanism cut its step, and a fixed step beyond is refused with "
              "the one that works, to the digits of the formula",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // h = 1/8 m; c = 10 m/s.
      const fluid::BarotropicFlow<1> quiet = boxed<1>(barotropic(), 8), thick = boxed<1>(barotropic(), 8, 1e6);
      const fluid::LiquidFlow<1> conducting = boxed<1>(continuum::LinearizedState{.Y = 1e5, .a_th = 0.0}, 8, 0.0, 1e8);
      const auto name = [&](const std::string& of, const std::string& expected, const std::string& computed) {
        rows.equal(of + ", ruled by",
                   {.expected = expected, .computed = computed, .because = "it asks for the shortest step by far"});
      };
      const fluid::Local<1> rest{.rho = rho_R};
      name("hardly viscous", "sound, carried along", ruled(quiet, rest, 10.0));
      name("thick", "viscosity", ruled(thick, rest, 1e-4));
      name("conducting", "conduction", ruled(conducting, rest, 0.01));
      const auto workable = [&](const std::string& of, const auto& flow, double expected, auto scheme, auto control) {
        schemes::State state = flow.start([&](const auto&) { return rest; });
        control.step = 1e3;
        const schemes::Outcome outcome = schemes::integrate(flow, state, 1e3, scheme, control);
        rows.compare(of + ", the step that works [s]", {.expected = expected,
                                                        .computed = outcome.workable_step,
                                                        .tolerance = relative(1e-12),
                                                        .because = "rounding"});
      };
      const double wave = 0.125 / 10.0, decay = rho_R * 0.125 * 0.125 / (4.0 * 4.0 / 3.0 * 1e6);
      workable("sound, RK4", quiet, 2.0 * std::numbers::sqrt2 * wave, schemes::RungeKutta4(), schemes::FixedStep{});
      workable("sound, one sweep", quiet, 2.0 * wave, in_turn(false), schemes::FixedSweeps{.sweeps = 1});
      workable("sound, two sweeps", quiet, wave, in_turn(false), schemes::FixedSweeps{.sweeps = 2});
      workable("sound, converged sweeps", quiet, wave, in_turn(false), schemes::FixedStep{});
      workable("Y = 1e10, RK4", boxed<1>(barotropic(1e10), 8), 2.0 * std::numbers::sqrt2 * 0.125 / std::sqrt(1e7),
               schemes::RungeKutta4(), schemes::FixedStep{});
      // With sound beside it: (Dt/waves)^2 + Dt/decays = 1.
      const auto both = [](double w, double d) { return 2.0 / (1.0 / d + std::sqrt(1.0 / (d * d) + 4.0 / (w * w))); };
      workable("viscosity, RK4", thick, 2.785293563405282 * decay, schemes::RungeKutta4(), schemes::FixedStep{});
      workable("viscosity, one sweep", thick, both(2.0 * wave, 2.0 * decay), in_turn(false),
               schemes::FixedSweeps{.sweeps = 1});
      workable("viscosity, converged sweeps", thick, both(wave, decay), in_turn(false), schemes::FixedStep{});
    }};

}  // namespace verification::fluid_sweeps
