// Flows that are known in closed form: sound, conduction, Couette's flows, Taylor and Green's vortices.

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification::known_flows {

using namespace particulate;
using namespace particulate::fluid;
using Complex = std::complex<double>;
using schemes::RungeKutta4;

constexpr double pi = std::numbers::pi;

// An order of two, of errors on five grids.
void order_2(Rows& rows, const std::string& what, const std::vector<double>& steps, const std::vector<double>& errors,
             double floor = 1e-13) {
  rows.order(what,
             {.nominal = 2.0, .steps = steps, .errors = errors, .floor = floor, .because = "central differences"});
}

// --- Sound in a viscous fluid, w^2 + i w nu K - (c k')^2 = 0 with c = 1, nu = 4/3 0.01 and k = 2 pi.

Complex frequency(double k_squared, double k_dash) {
  const Complex half = Complex(0.0, -0.5 * 4.0 / 300.0 * k_squared);
  return half + std::sqrt(half * half + k_dash * k_dash);
}

template <class E>
constexpr E soft{};
template <>
constexpr continuum::Barotropic soft<continuum::Barotropic>{.P_R = 1e5, .Y = 1000.0, .rho_R = 1000.0};
template <>
constexpr continuum::LinearizedState soft<continuum::LinearizedState>{.Y = 1000.0, .rho_R = 1000.0, .a_th = 0.0};

// The frequency that a wave along an axis shows in a periodic box of n cells along it and four elsewhere.
template <int Dim, class E>
Complex frequency_of_wave(int axis, Eigen::Index n) {
  Grid<Dim> grid;
  grid.cells.fill(4);
  grid.cells[static_cast<std::size_t>(axis)] = n;
  const Flow<Dim, E> flow(grid, {.state = soft<E>, .viscosity = {.mu = 10.0}}, {});
  const double k = 2.0 * pi, h = grid.h(axis), small = 1e-6, end = 0.4;
  const Complex i(0.0, 1.0), w = frequency((2.0 - 2.0 * std::cos(k * h)) / (h * h), std::sin(k * h) / h);
  const Complex denser = std::sin(k * h) / h / w;  // of its own over the velocity, from the balance of mass
  schemes::State state = flow.start([&](const Vector<Dim>& x) {
    const Complex wave = small * std::exp(i * k * x[axis]);
    Local<Dim> there{.rho = 1000.0 * (1.0 + (denser * wave).real())};
    there.v[axis] = wave.real();
    return there;
  });
  const auto seen = [&] {
    Complex sum = 0.0;
    for (Eigen::Index cell = 0; cell < grid.size(); ++cell) {
      Eigen::Index at = cell;
      for (int a = 0; a < axis; ++a) at /= grid.cells[static_cast<std::size_t>(a)];
      const double x = (static_cast<double>(at % n) + 0.5) * h;
      sum += flow.local(state, cell).v[axis] * std::exp(-i * k * x);
    }
    return sum;
  };
  const Complex before = seen();
  advance<RungeKutta4>(flow, state, end, 100 + 5 * n);
  return i * std::log(seen() / before) / end;
}

const Case sound{
    {.name = "viscous_sound_of_a_grid",
     .claim = "sound in eight cells decays and turns as the differences of its equations say",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto check = [&](const char* where, Complex w) {
        const auto row = [&](const char* what, double expected, double computed) {
          rows.compare(fmt::format("{}: {} [1/s]", where, what), {.expected = expected,
                                                                  .computed = computed,
                                                                  .tolerance = relative(1e-7),
                                                                  .because = "rounding of a wave of 1e-6, and RK4"});
        };
        row("decay", 0.2499355467208128, -w.imag());
        row("frequency", 5.651330128605598, w.real());
      };
      check("a line", frequency_of_wave<1, continuum::Barotropic>(0, 8));
      check("along y in a liquid that does not expand", frequency_of_wave<2, continuum::LinearizedState>(1, 8));
      check("along z", frequency_of_wave<3, continuum::Barotropic>(2, 8));
    }};

const Case sound_converges{{.name = "viscous_sound",
                            .claim = "decay and frequency of sound converge to those of the fluid itself",
                            .equation = "D 8.2",
                            .reference = Reference::closed_form},
                           [](Rows& rows) {
                             std::vector<double> steps, decay, turns;
                             for (const Eigen::Index n : {32, 40, 50, 64, 80}) {
                               const Complex w = frequency_of_wave<1, continuum::Barotropic>(0, n);
                               steps.push_back(1.0 / static_cast<double>(n));
                               decay.push_back(std::abs(-w.imag() / 0.263189450696 - 1.0));
                               turns.push_back(std::abs(w.real() / 6.27767066016 - 1.0));
                             }
                             order_2(rows, "decay", steps, decay, 1e-9);
                             order_2(rows, "frequency", steps, turns, 1e-9);
                           }};

// --- Conduction in a liquid at rest that does not expand: rho c = 1, K = 0.5.

const Fluid<continuum::LinearizedState> still{
    .state = {.Y = 1.0, .rho_R = 1.0, .theta_R = 1.0, .a_th = 0.0}, .viscosity = {.mu = 0.5}, .c = 1.0, .K = 0.5};

// How far temperatures on a line of n cells are from base(x) + 0.1 decay shape(x) after 0.1 s.
template <class Base, class Shape>
double off_by_conduction(const Boundaries<1>& boundaries, Eigen::Index n, double decay, const Base& base,
                         const Shape& shape) {
  const LiquidFlow<1> flow({.cells = {n}}, still, boundaries);
  schemes::State state =
      flow.start([&](const Vector<1>& x) { return Local<1>{.theta = base(x[0]) + 0.1 * shape(x[0])}; });
  const double end = 0.1;
  advance<RungeKutta4>(flow, state, end, 2 * n * n);
  double worst = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = flow.grid().centre({i})[0];
    worst = std::max(worst, std::abs(flow.local(state, i).theta - base(x) - 0.1 * std::exp(-decay * end) * shape(x)));
  }
  return worst;
}

const Case conduction{
    {.name = "conduction",
     .claim = "warmth between walls and round a ring goes as its differences say, and converges to the heat equation",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto check = [&](const char* where, const Boundaries<1>& boundaries, double k, double tilt, auto shape) {
        const auto base = [&](double x) { return 1.0 + tilt * x; };
        const auto wave = [&](double x) { return shape(k * x); };
        const double h = 1.0 / 8.0, of_grid = 0.5 * (2.0 - 2.0 * std::cos(k * h)) / (h * h);
        rows.compare(fmt::format("{}, eight cells: off [K]", where),
                     {.expected = 0.0,
                      .computed = off_by_conduction(boundaries, 8, of_grid, base, wave),
                      .tolerance = absolute(1e-10),
                      .because = "128 steps of order four"});
        std::vector<double> steps, errors;
        for (const Eigen::Index n : {10, 13, 17, 22, 28}) {
          steps.push_back(1.0 / static_cast<double>(n));
          errors.push_back(off_by_conduction(boundaries, n, 0.5 * k * k, base, wave));
        }
        order_2(rows, where, steps, errors);
      };
      const auto sine = [](double x) { return std::sin(x); };
      const auto cosine = [](double x) { return std::cos(x); };
      check("walls of 1 and 1.5 K", {Wall<1>{.theta = 1.0}, Wall<1>{.theta = 1.5}}, pi, 0.5, sine);
      check("walls that let no heat through", {Wall<1>{}, Wall<1>{}}, pi, 0.0, cosine);
      check("a ring", {Periodic{}, Periodic{}}, 2.0 * pi, 0.0, cosine);
    }};

// --- Couette's flows: x along the walls, the one at y = 0 at rest, the one at y = 1 moves.

Grid<2> between_walls(Eigen::Index n) { return {.cells = {4, n}, .lengths = Vector<2>(4.0, 1.0)}; }
Boundaries<2> sheared(double U, std::optional<double> cold, std::optional<double> hot) {
  return {Periodic{}, Periodic{}, Wall<2>{.theta = cold}, Wall<2>{.velocity = Vector<2>(U, 0.0), .theta = hot}};
}
// The cell at x = 0 in a row of cells.
Eigen::Index in_row(Eigen::Index j) { return 4 * j; }

const Case starting{
    {.name = "starting_couette",
     .claim = "a wall that is set in motion drags a fluid along as the series of the transient says",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // u/U = y + sum 2/(n pi) (-1)^n exp(-n^2 pi^2 nu t) sin(n pi y), nu = 1, from rest.
      const double U = 0.3, end = 0.06;
      const auto exact = [&](double y) {
        double sum = y;
        for (int n = 1; n < 12; ++n) {
          sum += (n % 2 == 0 ? 2.0 : -2.0) / (n * pi) * std::exp(-n * n * pi * pi * end) * std::sin(n * pi * y);
        }
        return U * sum;
      };
      std::vector<double> steps, errors;
      for (const Eigen::Index n : {16, 20, 26, 33, 42}) {
        const BarotropicFlow<2> flow(between_walls(n), {.state = {.Y = 1.0, .rho_R = 1.0}, .viscosity = {.mu = 1.0}},
                                     sheared(U, {}, {}));
        schemes::State state = flow.start([](const Vector<2>&) { return Local<2>{}; });
        advance<RungeKutta4>(flow, state, end, n * n / 4);
        double worst = 0.0;
        for (Eigen::Index j = 0; j < n; ++j) {
          const double y = flow.grid().centre({0, j})[1];
          worst = std::max(worst, std::abs(flow.local(state, in_row(j)).v[0] - exact(y)) / U);
        }
        steps.push_back(1.0 / static_cast<double>(n));
        errors.push_back(worst);
      }
      order_2(rows, "largest error over U", steps, errors);
    }};

const Case heated_couette{
    {.name = "couette_that_heats_itself",
     .claim = "between walls a sheared fluid is warmer than a still one by mu U^2/(2 K) y (1 - y)",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double U = 1.2;
      const auto exact = [&](double y) { return 1.0 + 0.2 * y + 0.5 * U * U * y * (1.0 - y); };  // mu = K
      std::vector<double> steps, errors;
      double sheared_off = 0.0;
      for (const Eigen::Index n : {8, 10, 13, 17, 22}) {
        const LiquidFlow<2> flow(between_walls(n), still, sheared(U, 1.0, 1.2));
        schemes::State state = flow.start(
            [&](const Vector<2>& x) { return Local<2>{.v = Vector<2>(U * x[1], 0.0), .theta = exact(x[1])}; });
        advance<RungeKutta4>(flow, state, 1.0, 2 * n * n);
        double worst = 0.0;
        for (Eigen::Index j = 0; j < n; ++j) {
          const double y = flow.grid().centre({0, j})[1];
          const Local<2> there = flow.local(state, in_row(j));
          worst = std::max(worst, std::abs(there.theta - exact(y)));
          sheared_off = std::max(sheared_off, std::abs(there.v[0] - U * y));
        }
        steps.push_back(1.0 / static_cast<double>(n));
        errors.push_back(worst);
      }
      order_2(rows, "temperature", steps, errors);
      rows.compare("velocity off a straight line [m/s]", {.expected = 0.0,
                                                          .computed = sheared_off,
                                                          .tolerance = absolute(1e-12),
                                                          .because = "rounding: differences are exact on lines"});
    }};

const Case thinning_couette{
    {.name = "couette_that_thins",
     .claim = "between walls of 300 and 400 K a liquid that thins as it warms has the known stress and velocity",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // So slow that friction heats nothing.
      const double U = 1e-6;
      const auto fluidity = [](double y) { return std::exp(-5.0 * (300.0 / (300.0 + 100.0 * y) - 1.0)); };
      const auto sum = [&](double y) {
        return boost::math::quadrature::gauss<double, 20>::integrate(fluidity, 0.0, y);
      };
      const Fluid<continuum::LinearizedState, continuum::ExponentialViscosity> fluid{
          .state = {.Y = 1.0, .rho_R = 1.0, .a_th = 0.0}, .viscosity = {.mu_R = 1.0, .c_mu = 5.0}, .c = 1.0, .K = 0.5};
      std::vector<double> steps, middle, stress;
      for (const Eigen::Index n : {9, 13, 17, 23, 29}) {
        const ThinningFlow<2> flow(between_walls(n), fluid, sheared(U, 300.0, 400.0));
        schemes::State state = flow.start([&](const Vector<2>& x) {
          return Local<2>{.v = Vector<2>(U * sum(x[1]) / sum(1.0), 0.0), .theta = 300.0 + 100.0 * x[1]};
        });
        advance<RungeKutta4>(flow, state, 1.0, 3 * n * n);
        steps.push_back(1.0 / static_cast<double>(n));
        middle.push_back(flow.local(state, in_row(n / 2)).v[0] / U);
        stress.push_back(flow.local(state, 0).v[0] / U * 2.0 *
                         static_cast<double>(n));  // mu_R u/(h/2), at the cold wall
      }
      const auto check = [&](const char* what, double expected, const std::vector<double>& computed) {
        std::vector<double> errors;
        for (const double value : computed) errors.push_back(std::abs(value - expected));
        order_2(rows, what, steps, errors, 1e-11);
        const double ratio = std::pow(steps[3] / steps[4], 2);
        rows.compare(fmt::format("{}, extrapolated", what),
                     {.expected = expected,
                      .computed = (ratio * computed[4] - computed[3]) / (ratio - 1.0),
                      .tolerance = absolute(1e-5),
                      .because = "h^4, and a hundredth of what the finest grid is off"});
      };
      check("u(1/2)/U", 0.352179212961142, middle);
      check("stress over mu_R U", 0.473834491838658, stress);
    }};

// --- Taylor and Green's vortices, which drift: u = U + (sin X cos Y, -cos X sin Y) e^{-2 k^2 nu t}, X = k (x - U t).

// How far velocities are from that at t = 0.2, mean square; and how large the vortices are, by their product with it.
struct Vortices {
  double off, size;
};
Vortices vortices(Eigen::Index n, double mach) {
  const double k = 2.0 * pi, nu = 0.01, end = 0.2;
  const Vector<2> U(0.7, -0.4);
  const auto exact = [&](double t, const Vector<2>& x) {
    const double X = k * (x[0] - U[0] * t), Y = k * (x[1] - U[1] * t), left = std::exp(-2.0 * k * k * nu * t);
    // P = rho/4 (cos 2X + cos 2Y) e^{...}, as a barotropic fluid has it.
    return Local<2>{.rho = 1.0 + 0.25 * mach * mach * left * left * (std::cos(2.0 * X) + std::cos(2.0 * Y)),
                    .v = U + left * Vector<2>(std::sin(X) * std::cos(Y), -std::cos(X) * std::sin(Y))};
  };
  const double c = 1.0 / mach;
  const BarotropicFlow<2> flow({.cells = {n, n}}, {.state = {.Y = c * c, .rho_R = 1.0}, .viscosity = {.mu = nu}}, {});
  schemes::State state = flow.start([&](const Vector<2>& x) { return exact(0.0, x); });
  const double cells = static_cast<double>(n);
  advance<RungeKutta4>(flow, state, end, static_cast<long>(end * cells * (c + 2.0) / 0.7) + 1);
  double off = 0.0, product = 0.0, squares = 0.0;
  for (Eigen::Index cell = 0; cell < flow.grid().size(); ++cell) {
    const Vector<2> expected = exact(end, flow.grid().centre({cell % n, cell / n})).v, v = flow.local(state, cell).v;
    off += (v - expected).squaredNorm();
    product += (v - U).dot(expected - U);
    squares += (expected - U).squaredNorm();
  }
  return {.off = std::sqrt(off) / cells, .size = product / squares};
}

const Case taylor_green{
    {.name = "drifting_vortices",
     .claim =
         "Taylor and Green's vortices drift and decay as in a fluid that cannot be compressed, but for Ma^2 and h^2",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      std::vector<double> steps, errors;
      for (const Eigen::Index n : {24, 30, 38, 48, 60}) {
        steps.push_back(1.0 / static_cast<double>(n));
        errors.push_back(vortices(n, 2.4 / static_cast<double>(n)).off);
      }
      order_2(rows, "velocities, Ma = 2.4 h", steps, errors);
      // On one grid, less what it is there without sound: Ma = 0.005 leaves 1e-6.
      const double incompressible = vortices(16, 0.005).size;
      const std::vector<double> mach{0.5, 0.38, 0.29, 0.22, 0.165};
      std::vector<double> larger;
      for (const double Ma : mach) larger.push_back(vortices(16, Ma).size - incompressible);
      rows.order(
          "their size on 16 cells, by Ma",
          {.nominal = 2.0, .steps = mach, .errors = larger, .floor = 8e-7, .because = "densities change by Ma^2"});
    }};

}  // namespace verification::known_flows
