#pragma once

#include <functional>
#include <string>
#include <vector>

#include <particulate/continuum/equation_of_state.hpp>
#include <particulate/continuum/viscosity.hpp>
#include <particulate/fluid/boundary.hpp>
#include <particulate/fluid/drag.hpp>
#include <particulate/fluid/hats.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// A compressible, viscous fluid on a grid, in fluxes that conserve what they should: a problem of first order.

namespace particulate::fluid {

namespace detail {
struct Cells;
struct Rates;
}  // namespace detail

/// What a fluid is made of.
template <class EquationOfState, class Viscosity = continuum::ConstantViscosity>
struct Fluid {
  EquationOfState state = {};          ///< its pressure
  Viscosity viscosity = {};            ///< mu
  double lambda_over_mu = -2.0 / 3.0;  ///< second viscosity over the first, >= -2/3 [-]
  double c = 4000.0;                   ///< heat capacity per mass, > 0; barotropic: none [J/(kg K)]
  double K = 0.6;                      ///< heat conductivity, >= 0; barotropic: none [W/(m K)]
};

/// Whether an equation of state asks for a temperature.
template <class EquationOfState>
concept HasTemperature = requires(const EquationOfState& law, double x) {
  { pressure(law, x, x) } -> std::same_as<double>;
};

/// A fluid in a box: density, momentum and, unless it is barotropic, energy of each cell.
///
/// \f[ \frac{d}{dt} \begin{pmatrix} \rho \\ \rho v \\ E \end{pmatrix}_{cell}
///     = -\sum_a \frac{f^a_{+1/2} - f^a_{-1/2}}{h_a} \f]
/// \f[ E = \rho \left(c\,\theta + \tfrac12 v^2\right) \f]
///
/// Between the cells 0 and 1, with bars for means and the normal a,
///
/// \f[ m = \bar\rho\, \bar u_a \f]
/// \f[ f_i = m\, \bar u_i + \bar P\, \delta_{ia} - \tau_{ia} \f]
/// \f[ f_E = m \left(c\, \bar\theta + \tfrac12 u_0 \cdot u_1\right) - \tau_{ia} \bar u_i + w + q \f]
/// \f[ w = \tfrac12 (u_{a0} P_1 + u_{a1} P_0), \qquad q = -K\, \frac{\theta_1 - \theta_0}{h_a} \f]
///
/// @equation{D 8.2} Beyond the monograph: its central differences, split so that they conserve mass, momentum and
/// energy, and make no kinetic energy by convection (Kennedy and Gruber). Stresses and conduction stand at the same
/// faces: normal differences across them, transverse ones as means of central differences. Order 2 in h.
///
/// Asked for a rate it writes into scratch of its own: threads that ask at once need a copy each.
///
/// Its state is y = (rho | rho v | E), field by field, x fastest.
/// @tparam Dim  1, 2 or 3
template <int Dim, class EquationOfState, class Viscosity = continuum::ConstantViscosity>
class Flow {
 public:
  static constexpr int directions = Dim;                                                  ///< 1, 2 or 3
  static constexpr bool has_heat = HasTemperature<EquationOfState>;                       ///< whether there is an E
  static constexpr bool varies = !std::same_as<Viscosity, continuum::ConstantViscosity>;  ///< whether mu does
  static constexpr int numbers = 1 + Dim + (has_heat ? 1 : 0);                            ///< of a cell in the state

  /// @param grid        at least four cells in each direction
  /// @param fluid       its laws
  /// @param boundaries  of all faces
  /// @param threads     that share the cells, 1 to 1024; the same bits for any number
  /// @param kernel      the code that adds the fluxes; one kernel gives the same bits every time
  /// @throws std::invalid_argument naming what cannot be meant, what must hold and what was given
  Flow(Grid<Dim> grid, Fluid<EquationOfState, Viscosity> fluid, Boundaries<Dim> boundaries, int threads = 1,
       laws::Kernel kernel = laws::Kernel::best);

  /// @param t   time, for boundaries that are given [s]
  /// @param y   state
  /// @param dy  receives its rate
  /// @return whether there is one: densities and temperatures are positive, all is finite
  /// @throws std::invalid_argument if y is not of this flow
  bool rate(double t, schemes::In y, schemes::Out dy) const;
  /// Looks at a state, for gather(), without its rates.
  ///
  /// @param t  time, for boundaries that are given [s]
  /// @param y  state
  /// @return whether densities and temperatures are positive, and all is finite
  /// @throws std::invalid_argument if y is not of this flow
  bool measure(double t, schemes::In y) const;
  /// The times that limit a step, over all cells: of sound carried along, viscosity, conduction, and of advection.
  ///
  /// \f[ \frac1{t_w} = \max \Big( U + s\,\Big(\sum_a \frac1{h_a^2}\Big)^{1/2} \Big),\qquad
  ///     U = \sum_a \frac{|u_a|}{h_a} \f]
  /// \f[ \frac1{t_\mu} = \max \frac{4\mu}{\rho} \Big(\sum_a \frac1{h_a^2}
  ///     + \Big(1 + \frac\lambda\mu\Big) \max_a \frac1{h_a^2}\Big) \f]
  /// \f[ \frac1{t_K} = \max \frac{4K}{\rho c} \sum_a \frac1{h_a^2} \f]
  /// \f[ \frac1{t_d} = \max \frac{3 \min_a L_a}s \left(U^2 + \tfrac12 U S\right) \f]
  ///
  /// @equation{D 8.4} with the speed of sound s, and S for the second term of the first. RungeKutta4 spans 2 sqrt 2
  /// of the first and 2.785 of what diffuses, one sweep of Staggered 2 and 2, sweeps that converge 1 and 1:
  /// schemes::AddsLimits. One sweep takes a step of forward Euler along the flow, which no step makes stable without
  /// diffusion: with t_d sound grows at most e-fold while it crosses the box. On a supersonic stream sweeps contract
  /// less than this says; a control that looks at them refuses those that diverge. Cells without a value are left out.
  ///
  /// @param y  a state
  /// @return those that there are
  /// @throws std::invalid_argument if y is not of this flow
  std::vector<schemes::TimeScale> step_limits(schemes::In y) const;
  /// @param at  a state @return the same
  std::vector<schemes::TimeScale> step_limits(const schemes::State& at) const { return step_limits(schemes::In(at.y)); }
  /// @param y  a state
  /// @return which cell has no value, and of what
  /// @throws std::invalid_argument if y is not of this flow
  std::string why_no_value(schemes::In y) const;
  /// @param at  a state @return the same
  std::string why_no_value(const schemes::State& at) const { return why_no_value(schemes::In(at.y)); }
  /// @return density, momentum and energy
  std::vector<schemes::Range> ranges() const;

  /// @return how many fields a staggering scheme solves in turn: density, momentum and, if there is one, energy
  std::size_t fields() const { return has_heat ? 3 : 2; }
  /// @param k  which field
  /// @return where it stands in y
  schemes::Part part(std::size_t k) const;
  /// What the size of a field is, for rounding: of momentum that of sound, \f$ \rho s \f$ in every cell, because a
  /// fluid that comes to rest still has the rounding of its pressure. @see schemes::HasFieldSizes
  ///
  /// @param k  which field
  /// @param y  a state
  /// @return sum over cells of the absolute values
  double field_size(std::size_t k, schemes::In y) const;
  /// @param k  which field @param at a state @return the same
  double field_size(std::size_t k, const schemes::State& at) const { return field_size(k, schemes::In(at.y)); }
  /// One field, one step of Euler's, the others frozen. @see schemes::StaggeredProblem
  ///
  /// @equation{R 8.4} \f$ y_k(t + \Delta t) = y_k(t) + \Delta t\,\dot y_k(t + \Delta t, y) \f$, with y as the sweep has
  /// it
  /// @param k     which field
  /// @param from  state at the start of the step
  /// @param dt    step [s]
  /// @param seen  the newest values of all fields
  /// @param to    receives the field
  /// @return whether there is a rate
  bool solve(std::size_t k, const schemes::State& from, double dt, const schemes::State& seen,
             schemes::State& to) const {
    return solve(k, from.t, from.y, dt, seen.y, to.y);
  }
  /// The same, of y alone.
  ///
  /// @param k     which field
  /// @param t     time at the start of the step [s]
  /// @param from  y there
  /// @param dt    step [s]
  /// @param seen  the newest values of all fields
  /// @param to    receives the field
  /// @return whether there is a rate
  bool solve(std::size_t k, double t, schemes::In from, double dt, schemes::In seen, schemes::Out to) const;

  /// A start.
  ///
  /// @param fluid  at a place
  /// @return the state at t = 0 with that at the middle of each cell
  /// @throws std::invalid_argument naming the place where it cannot be
  schemes::State start(const std::function<Local<Dim>(const Vector<Dim>& x)>& fluid) const;
  /// @param y     a state
  /// @param cell  of the grid, by its number
  /// @return what is there
  Local<Dim> local(schemes::In y, Eigen::Index cell) const;
  /// @param at  a state @param cell of the grid @return the same
  Local<Dim> local(const schemes::State& at, Eigen::Index cell) const { return local(schemes::In(at.y), cell); }

  /// @return the grid
  const Grid<Dim>& grid() const { return grid_; }
  /// @return the laws
  const Fluid<EquationOfState, Viscosity>& fluid() const { return fluid_; }
  /// @return what happens at its faces
  const Boundaries<Dim>& boundaries() const { return boundaries_; }
  /// @return how many threads share the cells
  int threads() const { return threads_; }
  /// @return how many numbers a state has
  Eigen::Index size() const { return grid_.size() * numbers; }
  /// @param size  of a state
  /// @throws std::invalid_argument if that is not size()
  void require_size(Eigen::Index size) const;
  /// The fluid at places, as it was measured last.
  ///
  /// @equation{D 8.1.2}
  /// @param hats     their weights, of this grid
  /// @param streams  receives the fluid at each, as many; what a direction or a fluid does not have stays
  void gather(const Hats<Dim>& hats, std::vector<Stream>& streams) const;

 private:
  detail::Cells cells() const;
  double* row_of(Eigen::Index row) const;
  const double* measured_row(Eigen::Index row, const double* y) const;
  bool apply_laws(double* rho) const;
  void look_at_row(const double* rho, detail::Rates& all) const;
  void fill_face(double t, int face) const;
  void fill_row(double t, int face, std::array<Eigen::Index, 3> cell, Eigen::Index count) const;
  bool add_fluxes(unsigned wanted, double* dy) const;

  Grid<Dim> grid_;
  Fluid<EquationOfState, Viscosity> fluid_;
  Boundaries<Dim> boundaries_;
  int threads_;
  laws::Kernel kernel_;
  std::array<Eigen::Index, 3> cells_{}, ghosts_{}, stride_{};  // one cell and no ghost in a direction that is not there
  Eigen::Index padded_ = 0, buffer_size_ = 0;
  mutable std::vector<double> measured_, buffers_, gathered_;  // see detail::Cells
};

/// What is compiled once, in the library; another combination does not link.
template <int Dim>
using BarotropicFlow = Flow<Dim, continuum::Barotropic>;
template <int Dim>
using LiquidFlow = Flow<Dim, continuum::LinearizedState>;  ///< its pressure hardly asks for its temperature
template <int Dim>
using GasFlow = Flow<Dim, continuum::IdealGas>;  ///< the only law for which c theta is all of its inner energy
/// A liquid that is thinner where it is warmer: in two and three dimensions.
template <int Dim>
using ThinningFlow = Flow<Dim, continuum::LinearizedState, continuum::ExponentialViscosity>;

}  // namespace particulate::fluid
