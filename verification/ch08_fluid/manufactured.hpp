#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>

#include <particulate/fluid/flow.hpp>

#include "jet.hpp"

/// @file
/// Flows that are made up, the sources that keep them going, and a flow that has such sources.

namespace verification {

/// What happens at both faces of a direction. At one of the last two kinds the fluid leaves, at the other it is given.
enum class Faces { periodic, held, adiabatic, moving, slips, given, leaves_high, leaves_low };

/// A fluid whose constants are about one.
struct MadeOf {
  bool gas = false, has_heat = true;
  double Y = 4.0, a_th = 0.2, R = 1.0, c = 2.5, K = 0.04, mu = 0.02, c_mu = 0.0, lambda_over_mu = -0.4;
};

/// Density at a pressure and a temperature: the equations of state, solved for it.
template <class S>
S density(const MadeOf& fluid, const S& P, const S& theta) {
  if (fluid.gas) return P / (fluid.R * theta);
  const S heavy = 1.0 + 1.0 / fluid.Y * (P - 1.0);
  return fluid.has_heat ? heavy - fluid.a_th * (theta - 1.0) : heavy;
}

/// A flow that is made up, in a box of edges 1, of pressures and temperatures about 1: of each field a constant and a
/// product of functions of one coordinate each, which do what they must at the faces.
template <int Dim>
struct MadeUp {
  std::array<Faces, Dim> faces{};
  bool steady = false;

  static constexpr std::array<double, 2> wall_speeds{0.3, -0.2};  ///< of moving walls, in all directions along them

  template <class S>
  struct At {
    S P, theta;
    std::array<S, Dim> v;
  };

  template <class S>
  At<S> operator()(const S& t, const std::array<S, Dim>& x) const {
    using std::sin;
    const auto field = [&](What what, std::size_t component, double size, double phase) {
      S product = steady ? S(size) : size * (1.0 + 0.3 * sin(2.3 * t + phase));
      for (std::size_t a = 0; a < Dim; ++a) {
        const What here = what == What::across && a != component ? What::along : what;
        product = product * factor(faces[a], here, phase + static_cast<double>(a), x[a]);
      }
      return product;
    };
    At<S> at{.P = 1.0 + field(What::push, 0, 0.1, 0.3), .theta = 1.0 + field(What::warmth, 0, 0.1, 1.1), .v = {}};
    for (std::size_t i = 0; i < Dim; ++i)
      at.v[i] = carried(i, x) + field(What::across, i, 0.15, 1.9 + static_cast<double>(i));
    return at;
  }

 private:
  enum class What { across, along, warmth, push };  // velocities across faces and along them, theta, P

  template <class S>
  static S factor(Faces faces, What what, double phase, const S& s) {
    using std::cos, std::sin;
    constexpr double pi = std::numbers::pi;
    if (faces == Faces::periodic) return 1.0 + 0.4 * sin(2.0 * pi * s + phase);
    // Where it leaves nothing has a second derivative, and the pressure is that outside.
    if (faces == Faces::leaves_high) return sin(2.2 * (1.0 - s));
    if (faces == Faces::leaves_low) return sin(2.2 * s);
    if (faces == Faces::given || what == What::push) return 0.5 + sin(2.0 * s + phase);
    const bool flat = faces == Faces::slips ? what != What::across : faces == Faces::adiabatic && what == What::warmth;
    if (flat) return 0.5 + cos(pi * s) + 0.3 * cos(2.0 * pi * s);
    return sin(pi * s) * (1.0 + 0.3 * s);
  }

  // What a component of the velocity is, apart from that.
  template <class S>
  S carried(std::size_t i, const std::array<S, Dim>& x) const {
    S result = i == 0 ? 0.4 : -0.3;
    for (std::size_t a = 0; a < Dim; ++a) {
      if (faces[a] == Faces::held || faces[a] == Faces::adiabatic) return 0.0;
      if (a == i && (faces[a] == Faces::slips || faces[a] == Faces::moving)) return 0.0;
      if (a == i && faces[a] == Faces::leaves_high) result = 0.5;
      if (a == i && faces[a] == Faces::leaves_low) result = -0.5;
      if (faces[a] == Faces::moving) result = wall_speeds[0] + (wall_speeds[1] - wall_speeds[0]) * x[a];
    }
    return result;
  }
};

/// What has to be added to the rates of density, momentum and energy at a place, so that a made-up flow is one: what
/// the equations leave over,
///
/// \f[ \partial_t \rho + \nabla \cdot (\rho v), \qquad \partial_t (\rho v) + \nabla \cdot (\rho v \otimes v - \sigma),
///     \qquad \partial_t E + \nabla \cdot (E v - \sigma v - K \nabla \theta) . \f]
template <int Dim>
std::array<double, Dim + 2> sources(const MadeOf& fluid, const MadeUp<Dim>& exact, double t,
                                    const std::array<double, Dim>& x) {
  using Number = Jet<Dim + 1>;
  std::array<Number, Dim> at;
  for (std::size_t a = 0; a < Dim; ++a) at[a] = Number::variable(x[a], a + 1);
  const auto [P, theta, v] = exact(Number::variable(t, 0), at);
  const Number rho = density(fluid, P, theta), mu = fluid.mu * exp(fluid.c_mu * (1.0 / theta - 1.0));
  Number expansion, per_mass = fluid.c * theta;
  for (std::size_t i = 0; i < Dim; ++i) {
    expansion = expansion + v[i].derivative(i + 1);
    per_mass = per_mass + 0.5 * (v[i] * v[i]);
  }
  const Number E = rho * per_mass;
  std::array<double, Dim + 2> left{rho.first[0]};
  left[Dim + 1] = E.first[0];
  for (std::size_t a = 0; a < Dim; ++a) {
    left[0] += (rho * v[a]).first[a + 1];
    Number of_energy = E * v[a] - fluid.K * theta.derivative(a + 1);
    for (std::size_t i = 0; i < Dim; ++i) {
      Number sigma = mu * (v[i].derivative(a + 1) + v[a].derivative(i + 1));
      if (i == a) sigma = sigma - P + fluid.lambda_over_mu * (mu * expansion);
      left[1 + i] += (rho * v[i] * v[a] - sigma).first[a + 1];
      of_energy = of_energy - sigma * v[i];
    }
    left[1 + a] += (rho * v[a]).first[0];
    left[Dim + 1] += of_energy.first[a + 1];
  }
  return left;
}

/// A flow with the sources of a made-up one, on a grid of n cells in each direction.
template <class Flow>
class Sourced;
template <int D, class E, class V>
class Sourced<particulate::fluid::Flow<D, E, V>> {
 public:
  using Flow = particulate::fluid::Flow<D, E, V>;
  using Place = particulate::fluid::Vector<D>;
  static constexpr int Dim = D;
  static constexpr bool thins = !std::same_as<V, particulate::continuum::ConstantViscosity>;

  Sourced(const MadeUp<D>& exact, Eigen::Index n, MadeOf of = {}) : exact_(exact), of_(of) {
    of_.has_heat = Flow::has_heat;
    of_.gas = std::same_as<E, particulate::continuum::IdealGas>;
    of_.c_mu = thins ? 2.0 : 0.0;
    particulate::fluid::Grid<D> grid;
    grid.cells.fill(n);
    particulate::fluid::Boundaries<D> boundaries;
    for (std::size_t face = 0; face < 2 * D; ++face) boundaries[face] = boundary(face);
    flow_.emplace(grid, fluid(), boundaries);
  }
  Sourced(const Sourced&) = delete;  // its boundaries ask it
  Sourced& operator=(const Sourced&) = delete;

  bool rate(double t, particulate::schemes::In y, particulate::schemes::Out dy) {
    if (!flow_->rate(t, y, dy)) return false;
    if (!added_at_ || (*added_at_ != t && !exact_.steady)) add_up(t);
    dy += added_;
    return true;
  }
  /// @return what the made-up flow is at a time
  particulate::schemes::State exact(double t) const {
    return flow_->start([&](const Place& x) { return local(t, x); });
  }
  const Flow& flow() const { return *flow_; }

 private:
  static std::array<double, D> numbers_of(const Place& x) {
    std::array<double, D> all{};
    std::copy_n(x.data(), D, all.begin());
    return all;
  }
  particulate::fluid::Local<D> local(double t, const Place& x) const {
    const auto at = exact_(t, numbers_of(x));
    return {.rho = density(of_, at.P, at.theta), .v = Place(at.v.data()), .theta = at.theta};
  }
  void add_up(double t) {
    const auto& grid = flow_->grid();
    added_.resize(grid.size() * Flow::numbers);
    std::array<Eigen::Index, D> cell{};
    for (Eigen::Index n = 0; n < grid.size(); ++n) {
      Eigen::Index rest = n;
      for (std::size_t a = 0; a < D; ++a) cell[a] = rest % grid.cells[a], rest /= grid.cells[a];
      const std::array<double, D + 2> source = sources<D>(of_, exact_, t, numbers_of(grid.centre(cell)));
      for (int f = 0; f < Flow::numbers; ++f) added_[n + f * grid.size()] = source[static_cast<std::size_t>(f)];
    }
    added_at_ = t;
  }
  particulate::fluid::Fluid<E, V> fluid() const {
    particulate::fluid::Fluid<E, V> fluid{.lambda_over_mu = of_.lambda_over_mu, .c = of_.c, .K = of_.K};
    if constexpr (std::same_as<E, particulate::continuum::IdealGas>) {
      fluid.state.R = of_.R;
    } else {
      fluid.state.P_R = fluid.state.rho_R = 1.0;
      fluid.state.Y = of_.Y;
      if constexpr (Flow::has_heat) fluid.state.theta_R = 1.0, fluid.state.a_th = of_.a_th;
    }
    if constexpr (thins) {
      fluid.viscosity = {.mu_R = of_.mu, .c_mu = of_.c_mu, .theta_R = 1.0};
    } else {
      fluid.viscosity.mu = of_.mu;
    }
    return fluid;
  }
  particulate::fluid::Boundary<D> boundary(std::size_t face) const {
    using Wall = particulate::fluid::Wall<D>;
    const Faces faces = exact_.faces[face / 2];
    const bool high = face % 2 == 1;
    const std::optional<double> warm = Flow::has_heat ? std::optional(1.0) : std::nullopt;
    if (faces == Faces::periodic) return particulate::fluid::Periodic{};
    if (faces == Faces::held) return Wall{.theta = warm};
    if (faces == Faces::adiabatic) return Wall{};
    if (faces == Faces::slips) return Wall{.slips = true};
    if (faces == Faces::moving) {
      Wall wall{.velocity = Place::Constant(MadeUp<D>::wall_speeds[high ? 1 : 0]), .theta = warm};
      wall.velocity[static_cast<Eigen::Index>(face / 2)] = 0.0;
      return wall;
    }
    if (faces == (high ? Faces::leaves_high : Faces::leaves_low)) return particulate::fluid::Outflow{.P = 1.0};
    return particulate::fluid::Given<D>{[this](double t, const Place& x) { return local(t, x); }};
  }

  MadeUp<D> exact_;
  MadeOf of_;
  std::optional<Flow> flow_;
  Eigen::VectorXd added_;
  std::optional<double> added_at_;
};

}  // namespace verification
