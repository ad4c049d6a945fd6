// The rate of a flow, written down plainly once more: cell by cell, face by face, whatever stands beyond a face found
// by recursion. The library's kernels must agree with it.

#include <particulate/fluid/flow.hpp>

#include <array>
#include <cmath>
#include <utility>

#include "close.hpp"

namespace tests::flow_reference_test {

using namespace particulate::fluid;
using Eigen::Vector3d;
using Eigen::VectorXd;
using particulate::laws::Kernel;
using particulate::schemes::State;
using Cell = std::array<Eigen::Index, 3>;

struct Values {
  double rho, P, theta, mu;
  Vector3d v;
};

template <class E, class V>
class Plain {
 public:
  Plain(const Flow<3, E, V>& flow, const Boundaries<3>& faces, const State& at) : flow_(flow), faces_(faces), at_(at) {}

  VectorXd rate() const {
    VectorXd dy = VectorXd::Zero(at_.y.size());
    const Eigen::Index N = grid().size();
    Cell i{};
    for (i[2] = 0; i[2] < grid().cells[2]; ++i[2]) {
      for (i[1] = 0; i[1] < grid().cells[1]; ++i[1]) {
        for (i[0] = 0; i[0] < grid().cells[0]; ++i[0]) {
          for (int a = 0; a < 3; ++a) {
            const VectorXd change = (flux(moved(i, a, -1), a) - flux(i, a)) / grid().h(a);
            for (int f = 0; f < change.size(); ++f) dy[grid().index(i) + f * N] += change[f];
          }
        }
      }
    }
    return dy;
  }

 private:
  const Grid<3>& grid() const { return flow_.grid(); }
  static Cell moved(Cell i, int a, Eigen::Index by) { return i[static_cast<std::size_t>(a)] += by, i; }
  double pressure_of(double rho, double theta) const {
    if constexpr (HasTemperature<E>) {
      return pressure(flow_.fluid().state, rho, theta);
    } else {
      return pressure(flow_.fluid().state, rho);
    }
  }
  Values of(const Local<3>& x) const {
    return {x.rho, pressure_of(x.rho, x.theta), x.theta, viscosity(flow_.fluid().viscosity, x.theta), x.v};
  }

  // Of a cell in the box or around it. What lies beyond faces of several directions belongs to the last of them.
  Values at(const Cell& i) const {
    for (int a = 2; a >= 0; --a) {
      const Eigen::Index n = grid().cells[static_cast<std::size_t>(a)], here = i[static_cast<std::size_t>(a)];
      if (here < 0) return beyond(i, a, 2 * a, 1);
      if (here >= n) return beyond(i, a, 2 * a + 1, -1);
    }
    return of(flow_.local(at_, grid().index(i)));
  }
  Values beyond(const Cell& i, int a, int face, int inwards) const {
    const Boundary<3>& boundary = faces_[static_cast<std::size_t>(face)];
    if (std::holds_alternative<Periodic>(boundary)) {
      return at(moved(i, a, inwards * grid().cells[static_cast<std::size_t>(a)]));
    }
    if (const auto* given = std::get_if<Given<3>>(&boundary)) return of(given->fluid(at_.t, grid().centre(i)));
    const Values in = at(moved(i, a, inwards)), next = at(moved(i, a, 2 * inwards));
    if (const auto* out = std::get_if<Outflow>(&boundary)) {
      const Values third = at(moved(i, a, 3 * inwards));
      // The cubic a + b x + c x^3 through three cells, x from the face.
      const auto on = [&](const auto& value) { return (7.0 * value(in) - 5.0 * value(next) + value(third)) / 3.0; };
      Values is;
      is.rho = on([](const Values& x) { return x.rho; });
      is.P = 2.0 * out->P - in.P;
      is.theta = on([](const Values& x) { return x.theta; });
      is.mu = on([](const Values& x) { return x.mu; });
      for (int c = 0; c < 3; ++c) is.v[c] = on([c](const Values& x) { return x.v[c]; });
      return is;
    }
    const auto& wall = std::get<Wall<3>>(boundary);
    Values is = in;
    is.P = 2.0 * in.P - next.P;
    is.v = 2.0 * wall.velocity - in.v;
    for (int c = 0; c < 3; ++c) {
      if (wall.slips && c != a) is.v[c] = in.v[c];
    }
    if (wall.theta) {
      is.theta = 2.0 * *wall.theta - in.theta;
      is.mu = 2.0 * viscosity(flow_.fluid().viscosity, *wall.theta) - in.mu;
    }
    return is;
  }
  bool is_wall(const Cell& i, int a) const {
    const Eigen::Index n = grid().cells[static_cast<std::size_t>(a)], here = i[static_cast<std::size_t>(a)];
    const int face = here < 0 ? 2 * a : 2 * a + 1;
    return (here < 0 || here == n - 1) && std::holds_alternative<Wall<3>>(faces_[static_cast<std::size_t>(face)]);
  }

  // Across the face between a cell and the next along a.
  VectorXd flux(const Cell& i, int a) const {
    const Cell j = moved(i, a, 1);
    const Values p = at(i), q = at(j);
    Eigen::Matrix3d L;  // dv_c/dx_b in row c, column b
    for (int b = 0; b < 3; ++b) {
      L.col(b) =
          b == a
              ? Vector3d((q.v - p.v) / grid().h(a))
              : Vector3d((at(moved(i, b, 1)).v - at(moved(i, b, -1)).v + at(moved(j, b, 1)).v - at(moved(j, b, -1)).v) /
                         (4.0 * grid().h(b)));
    }
    const double mu = 0.5 * (p.mu + q.mu), m = 0.25 * (p.rho + q.rho) * (p.v[a] + q.v[a]);
    Vector3d tau = mu * (L.row(a).transpose() + L.col(a));
    tau[a] += mu * flow_.fluid().lambda_over_mu * L.trace();
    const Vector3d mean = 0.5 * (p.v + q.v);
    VectorXd f(flow_.numbers);
    f[0] = m;
    f.segment(1, 3) = m * mean - tau;
    f[1 + a] += 0.5 * (p.P + q.P);
    if (flow_.has_heat) {
      const double work = is_wall(i, a) ? 0.0 : 0.5 * (p.v[a] * q.P + q.v[a] * p.P);
      f[f.size() - 1] = m * (0.5 * flow_.fluid().c * (p.theta + q.theta) + 0.5 * p.v.dot(q.v)) + work - tau.dot(mean) -
                        flow_.fluid().K * (q.theta - p.theta) / grid().h(a);
    }
    return f;
  }

  const Flow<3, E, V>& flow_;
  const Boundaries<3>& faces_;
  const State& at_;
};

const Grid<3> brick{.cells = {5, 4, 6}, .lengths = {2.5, 1.6, 3.6}, .corner = {-1.0, 0.5, 2.0}};
// Longer than a vector and than the blocks of rows and planes in which a kernel goes through cells.
const Grid<3> large{.cells = {13, 10, 34}, .lengths = {6.5, 4.0, 20.4}};

// No symmetry, and a roughness that no smooth field has.
Local<3> anything(double t, const Vector3d& x) {
  const double s = x.dot(Vector3d(11.3, 27.1, 17.9)) + t;
  return {.rho = 1.0 + 0.2 * std::sin(s),
          .v = {0.3 * std::sin(1.7 * s), 0.4 * std::cos(2.3 * s), 0.2 + 0.5 * std::sin(3.1 * s)},
          .theta = 1.5 + 0.3 * std::cos(2.9 * s)};
}

const Given<3> given{anything};
const Wall<3> still{}, smooth{.slips = true};
const Wall<3> cold{.velocity = {0.0, 0.4, -0.3}, .theta = 1.3}, hot{.velocity = {0.2, 0.7, 0.0}, .theta = 1.8},
    sliding{.velocity = {0.5, 0.0, 0.1}}, smooth_cold{.slips = true, .theta = 1.2};
const Outflow out{.P = 1.3};
// Every kind at faces of every direction.
const std::array<Boundaries<3>, 5> kinds{{{},
                                          {given, out, sliding, smooth_cold, Periodic{}, Periodic{}},
                                          {cold, still, given, out, out, smooth},
                                          {Periodic{}, Periodic{}, smooth, given, hot, given},
                                          {smooth_cold, out, out, still, given, still}}};

Boundaries<3> without_heat(Boundaries<3> faces) {
  for (Boundary<3>& face : faces) {
    if (auto* wall = std::get_if<Wall<3>>(&face)) wall->theta.reset();
  }
  return faces;
}

template <class F, class Law>
void agrees(const Law& fluid, const Grid<3>& grid = brick) {
  for (Boundaries<3> faces : kinds) {
    if (!F::has_heat) faces = without_heat(faces);
    const F any(grid, fluid, faces);
    State state = any.start([](const Vector3d& x) { return anything(0.0, x); });
    state.t = 0.6;
    const VectorXd plain = Plain(any, faces, state).rate();
    for (const Kernel kernel : {Kernel::baseline, Kernel::avx2, Kernel::avx512}) {
      if (!particulate::laws::is_available(kernel)) continue;
      VectorXd dy = VectorXd::Constant(state.y.size(), not_a_number);
      BOOST_TEST_REQUIRE(F(grid, fluid, faces, 1, kernel).rate(state.t, state.y, dy));
      const Eigen::Index N = grid.size();
      for (int f = 0; f < F::numbers; ++f) {
        const VectorXd field = plain.segment(N * f, N);
        BOOST_TEST(close(dy.segment(N * f, N), field, {.absolute = 1e-13 * field.cwiseAbs().maxCoeff()}));
      }
    }
  }
}

const Fluid<particulate::continuum::IdealGas> gas{
    .state = {.R = 1.0}, .viscosity = {.mu = 0.3}, .lambda_over_mu = 0.4, .c = 2.0, .K = 0.5};

BOOST_AUTO_TEST_SUITE(rate)

BOOST_AUTO_TEST_CASE(of_a_gas_is_that_of_a_plain_loop_over_faces) { agrees<GasFlow<3>>(gas); }
BOOST_AUTO_TEST_CASE(of_many_cells_is_that_of_a_plain_loop_over_faces) { agrees<GasFlow<3>>(gas, large); }
BOOST_AUTO_TEST_CASE(of_a_barotropic_fluid_is_that_of_a_plain_loop_over_faces) {
  agrees<BarotropicFlow<3>>(Fluid<particulate::continuum::Barotropic>{
      .state = {.P_R = 1.0, .Y = 4.0, .rho_R = 1.0}, .viscosity = {.mu = 0.3}, .lambda_over_mu = 0.4});
}
BOOST_AUTO_TEST_CASE(of_a_liquid_is_that_of_a_plain_loop_over_faces) {
  agrees<LiquidFlow<3>>(Fluid<particulate::continuum::LinearizedState>{
      .state = {.P_R = 1.0, .Y = 4.0, .rho_R = 1.0, .theta_R = 1.4, .a_th = 0.2},
      .viscosity = {.mu = 0.3},
      .c = 2.0,
      .K = 0.5});
}
BOOST_AUTO_TEST_CASE(of_a_liquid_that_thins_is_that_of_a_plain_loop_over_faces) {
  agrees<ThinningFlow<3>>(Fluid<particulate::continuum::LinearizedState, particulate::continuum::ExponentialViscosity>{
      .state = {.P_R = 1.0, .Y = 4.0, .rho_R = 1.0, .theta_R = 1.4, .a_th = 0.2},
      .viscosity = {.mu_R = 0.3, .c_mu = 1.2, .theta_R = 1.5},
      .c = 2.0,
      .K = 0.5});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::flow_reference_test
