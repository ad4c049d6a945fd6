// Right-hand sides of a flow on 16 x 16 x 16 cells, and of particles in it, for the table of what a feature costs:
// fluid_cost <rates>... asks all of them so often. One kernel, for every processor, so that the counts are those of
// every machine.

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <harness/counted_program.hpp>
#include <particulate/fluid/suspension.hpp>

namespace {

using namespace particulate;
using namespace particulate::fluid;
using verification::CountedRun;
using verification::CountedScene;

const Grid<3> cube{.cells = {16, 16, 16}};

Local<3> start(const Vector<3>& x) {
  const Vector<3> s = (6.283185307179586 * x).array().sin();
  return {.rho = 1000.0 + s[0], .v = {s[1], 0.5 * s[2], s[0]}, .theta = 300.0 + s[1]};
}

using Barotropic = continuum::Barotropic;
using Liquid = continuum::LinearizedState;
using Thinning = continuum::ExponentialViscosity;
template <class E, class V>
using Flow3 = Flow<3, E, V>;

template <class E, class V>
Flow3<E, V> flow_of(const Grid<3>& grid, const Fluid<E, V>& fluid, const Boundaries<3>& faces = {}) {
  return {grid, fluid, faces, 1, laws::Kernel::baseline};
}

// A step of the counter is one right-hand side.
template <class E, class V>
CountedRun rates(long times, const Fluid<E, V>& fluid, const Boundaries<3>& faces = {}) {
  const Flow3<E, V> flow = flow_of(cube, fluid, faces);
  const schemes::State state = flow.start(start);
  Eigen::VectorXd dy(state.y.size());
  CountedRun run{.particles = cube.size()};
  for (long k = 0; k < times; ++k) {
    if (!flow.rate(0.0, state.y, dy)) throw std::runtime_error("there is no rate");
    run.sum += dy[k % dy.size()];
  }
  return run;
}

// Here it is one staggered sweep over all fields.
CountedRun sweeps(long times) {
  const LiquidFlow<3> flow = flow_of(cube, Fluid<Liquid>{});
  const schemes::State from = flow.start(start);
  schemes::State state = from;
  CountedRun run{.particles = cube.size()};
  for (long k = 0; k < times; ++k) {
    for (std::size_t field = 0; field < flow.fields(); ++field) {
      if (!flow.solve(field, from, 1e-9, state, state)) throw std::runtime_error("there is no rate");
    }
    run.sum += state.y[k % state.y.size()];
  }
  return run;
}

// 64 particles on a lattice off the middles of cells, each of which reaches two cells.
kinematics::Particles lattice(int along) {
  std::vector<kinematics::Particle> all;
  for (int i = 0; i < along * along * along; ++i) {
    const Eigen::Vector3d node(i % along, i / along % along, i / (along * along));
    all.push_back({.position = (node.array() + 0.3) / along,
                   .velocity = {0.1, 0.2, -0.1},
                   .mass = 1.0,
                   .radius = 0.02,
                   .temperature = 600.0,
                   .heat_capacity = 1000.0});
  }
  return kinematics::particles(all);
}

// A right-hand side of particles and fluid.
template <class Heat, class... Laws>
CountedRun suspended(long times, int along, const Heat& heat, const Laws&... laws) {
  const Suspension both(flow_of(cube, Fluid<Liquid>{}), lattice(along), Spreading{.w = 0.125}, heat, laws...);
  const schemes::State state = both.start(start);
  Eigen::VectorXd a(state.v.size()), dy(state.y.size());
  CountedRun run{.particles = cube.size()};
  for (long k = 0; k < times; ++k) {
    if (!both.rates(0.0, state.r, state.v, state.y, a, dy)) throw std::runtime_error("there is no rate");
    run.sum += dy[k % dy.size()];
  }
  return run;
}

// Here it is a flow that is made, of so many cells that ghosts hardly count.
template <class E, class V>
CountedRun made(long times, const Fluid<E, V>& fluid) {
  const Grid<3> grid{.cells = {32, 32, 32}};
  CountedRun run{.particles = grid.size()};
  for (long k = 0; k < times; ++k) run.sum += flow_of(grid, fluid).grid().h(0);
  return run;
}

// What nobody can leave out: the two-point fluxes of density and momentum between the cells of a periodic box without
// viscosity, each formed once, and the differences that they leave.
void bare_rate(const Barotropic& law, const std::vector<double>& y, std::vector<double>& v, std::vector<double>& dy) {
  constexpr std::size_t n = 16, N = n * n * n;
  constexpr double over_h = 16.0;
  for (std::size_t i = 0; i < N; ++i) {
    const double over = 1.0 / y[i];
    for (std::size_t c = 0; c < 3; ++c) v[i + c * N] = y[i + (1 + c) * N] * over;
    v[i + 3 * N] = pressure(law, y[i]);
  }
  dy.assign(4 * N, 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t stride = a == 0 ? 1 : a == 1 ? n : n * n;
    for (std::size_t i = 0; i < N; ++i) {
      const std::size_t j = i / stride % n + 1 < n ? i + stride : i - (n - 1) * stride;
      const double m = 0.25 * (y[i] + y[j]) * (v[i + a * N] + v[j + a * N]) * over_h;
      dy[i] -= m, dy[j] += m;
      for (std::size_t c = 0; c < 3; ++c) {
        double f = 0.5 * m * (v[i + c * N] + v[j + c * N]);
        if (c == a) f += 0.5 * over_h * (v[i + 3 * N] + v[j + 3 * N]);
        dy[i + (1 + c) * N] -= f, dy[j + (1 + c) * N] += f;
      }
    }
  }
}
CountedRun bare(long times) {
  const Fluid<Barotropic> fluid{.viscosity = {.mu = 0.0}};
  const BarotropicFlow<3> flow = flow_of(cube, fluid);
  const schemes::State state = flow.start(start);
  const std::vector<double> y(state.y.begin(), state.y.end());
  std::vector<double> v(y.size()), dy(y.size());
  CountedRun run{.particles = cube.size()};
  for (long k = 0; k < times; ++k) {
    bare_rate(fluid.state, y, v, dy);
    run.sum += dy[static_cast<std::size_t>(k) % dy.size()];
  }
  Eigen::VectorXd same(state.y.size());
  if (!flow.rate(0.0, state.y, same)) throw std::runtime_error("there is no rate");
  const Eigen::VectorXd own = Eigen::Map<const Eigen::VectorXd>(dy.data(), same.size()), off = same - own;
  for (Eigen::Index f = 0; f < 4; ++f) {
    const auto size = [&](const auto& all) { return all.segment(f * cube.size(), cube.size()).cwiseAbs().maxCoeff(); };
    if (!(size(off) < 1e-9 * size(own))) throw std::runtime_error("the bare loop computes something else");
  }
  return run;
}

const Fluid<Barotropic> ideal{.viscosity = {.mu = 0.0}}, barotropic{};
const Fluid<Liquid> still_liquid{.state = {.a_th = 0.0}, .K = 0.0}, liquid{};
const Fluid<Liquid, Thinning> same_everywhere{.viscosity = {.c_mu = 0.0}}, thinning{};

const HeatExchange no_heat{}, heated{.h_c = 100.0, .emissivity = 1.0, .a_v = 0.5};
const laws::NearField used{
    .alpha1 = 0.5, .alpha2 = 0.1, .kernel = laws::Kernel::baseline, .cutoff = 0.45, .taper = 0.15};
laws::NearField idle() {
  laws::NearField none = used;
  none.alpha1 = 0.0, none.cutoff = 0.2, none.taper = 0.05;
  return none;
}

Boundaries<3> walls(const Wall<3>& wall) { return {wall, wall, wall, wall, wall, wall}; }
const Boundaries<3> smooth = walls({.slips = true}), warm = walls({.theta = 310.0});

const std::array all{CountedScene{"bare", bare},
                     CountedScene{"inviscid", [](long n) { return rates(n, ideal); }},
                     CountedScene{"barotropic", [](long n) { return rates(n, barotropic); }},
                     CountedScene{"heat_idle", [](long n) { return rates(n, still_liquid); }},
                     CountedScene{"liquid", [](long n) { return rates(n, liquid); }},
                     CountedScene{"sweep", sweeps},
                     CountedScene{"walls_idle", [](long n) { return rates(n, liquid, smooth); }},
                     CountedScene{"walls_used", [](long n) { return rates(n, liquid, warm); }},
                     CountedScene{"thinning_idle", [](long n) { return rates(n, same_everywhere); }},
                     CountedScene{"thinning_used", [](long n) { return rates(n, thinning); }},
                     CountedScene{"particles_none", [](long n) { return suspended(n, 0, NoHeat{}); }},
                     CountedScene{"particles", [](long n) { return suspended(n, 4, NoHeat{}); }},
                     CountedScene{"exchange_idle", [](long n) { return suspended(n, 4, no_heat); }},
                     CountedScene{"exchange", [](long n) { return suspended(n, 4, heated); }},
                     CountedScene{"near_idle", [](long n) { return suspended(n, 4, heated, idle()); }},
                     CountedScene{"near_used", [](long n) { return suspended(n, 4, heated, used); }},
                     CountedScene{"made_barotropic", [](long n) { return made(n, barotropic); }},
                     CountedScene{"made_liquid", [](long n) { return made(n, liquid); }},
                     CountedScene{"made_thinning", [](long n) { return made(n, thinning); }}};

}  // namespace

int main(int argc, char** argv) { return verification::counted_program(argc, argv, all); }
