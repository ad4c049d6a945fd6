#pragma once

#include <array>
#include <concepts>
#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/laws/neighbours.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// What a law of a scene may be asked, and what it sees. Laws are plain structs; what they do are free functions found
/// beside them.

namespace particulate::laws {

/// Working memory of one scene, kept from one call to the next: a scene serves one run at a time. A copy begins empty,
/// so that a scene is cheap to copy; threads take copies.
class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch&) {}                            ///< Begins empty.
  Scratch& operator=(const Scratch&) { return *this; }  ///< Keeps its own. @return this

  Neighbours neighbours;   ///< of the bodies of the scene, for all its laws
  Neighbours approaching;  ///< of bodies that come close in a step, for ChosenPairs
  ChosenPairs close;       ///< pairs whose forces change fast: see SplitsForce
  Eigen::VectorXd others;  ///< forces of the other laws on bodies that meet, 3 N [N]
  Eigen::VectorXd after;   ///< velocities after they have met, 3 N [m/s]
  Eigen::VectorXd heat;    ///< what they gain by that, N [J]

  static constexpr std::size_t line = 8;  ///< numbers of a cache line [-]

  /// Columns side by side, each on a cache line of its own and padded with zeros.
  ///
  /// @param columns  how many
  /// @param N        numbers in each
  /// @return the first number of the first column; the next ones follow after stride(N)
  double* columns(std::size_t columns, Eigen::Index N) {
    lines_.assign(columns * lines(N), Line{});
    return lines_.front().number.data();
  }
  /// @param N  numbers in a column
  /// @return from one column to the next [numbers]
  static std::size_t stride(Eigen::Index N) { return line * lines(N); }

 private:
  struct alignas(64) Line {
    std::array<double, line> number{};
  };
  static std::size_t lines(Eigen::Index N) { return (static_cast<std::size_t>(N) + line - 1) / line; }
  std::vector<Line> lines_;
};

struct Velocity;
struct Temperature;

/// What a law sees of a moment: time, places, masses, radii and what is immovable, and the parts that it names:
/// `Velocity`, the velocities and inverse masses, `Temperature`, the temperatures. Nothing is copied. A view with more
/// parts converts to one with fewer.
template <class... Parts>
struct At;

/// Time, places, masses, radii and what is immovable.
template <>
struct At<> {
  double t;                                        ///< time [s]
  Eigen::Map<const kinematics::Vectors> position;  ///< r_i, N x 3 [m]
  const Eigen::VectorXd& mass;                     ///< m_i, N [kg]
  const Eigen::VectorXd& radius;                   ///< b_i, N [m]
  const Eigen::VectorXd& inverse_mass;             ///< 1/m_i, 0 for what is immovable, N [1/kg]
  Scratch& scratch;                                ///< the scene's
};

/// The same with velocities.
template <>
struct At<Velocity> : At<> {
  Eigen::Map<const kinematics::Vectors> velocity;  ///< v_i, N x 3 [m/s]
};

/// The same with temperatures.
template <>
struct At<Temperature> : At<> {
  Eigen::Map<const Eigen::VectorXd> temperature;  ///< theta_i, N [K]
};

/// All of it.
template <>
struct At<Velocity, Temperature> : At<Velocity> {
  Eigen::Map<const Eigen::VectorXd> temperature;  ///< theta_i, N [K]

  /// @return the same without velocities
  operator At<Temperature>() const { return {static_cast<const At<>&>(*this), temperature}; }
};

using Forces = Eigen::Map<kinematics::Vectors>;  ///< forces on the particles, N x 3, that a law adds to [N]

/// A law that adds forces, given such a view: `add_force(law, domain, at, forces)` returns whether they have a value
/// there.
template <class L, class D, class View>
concept AddsForce = requires(const L& law, const D& domain, const View& at, Forces force) {
  { add_force(law, domain, at, force) } -> std::same_as<bool>;
};

/// A law that adds forces, whatever it needs for them.
template <class L, class D>
concept Force = AddsForce<L, D, At<>> || AddsForce<L, D, At<Velocity>> || AddsForce<L, D, At<Temperature>> ||
    AddsForce<L, D, At<Velocity, Temperature>>;

/// Whether the forces of a law ask for velocities: it has none without them.
template <class L, class D>
inline constexpr bool needs_velocity = Force<L, D> && !AddsForce<L, D, At<>> && !AddsForce<L, D, At<Temperature>>;

/// Whether the forces of a law ask for temperatures.
template <class L, class D>
inline constexpr bool needs_temperature = Force<L, D> && !AddsForce<L, D, At<>> && !AddsForce<L, D, At<Velocity>>;

using Heats = Eigen::Map<Eigen::VectorXd>;  ///< heat flows into the particles, N, that a law adds to [W]

/// A law that heats or cools, given such a view: `add_heat(law, domain, at, heat)` returns whether the flows have a
/// value there.
template <class L, class D, class View>
concept AddsHeatGiven = requires(const L& law, const D& domain, const View& at, Heats heat) {
  { add_heat(law, domain, at, heat) } -> std::same_as<bool>;
};

/// A law that heats or cools: the temperatures of its scene have a rate.
template <class L, class D>
concept AddsHeat = AddsHeatGiven<L, D, At<Temperature>> || AddsHeatGiven<L, D, At<Velocity, Temperature>>;

/// Whether the heat of a law asks for velocities.
template <class L, class D>
inline constexpr bool heat_needs_velocity = AddsHeat<L, D> && !AddsHeatGiven<L, D, At<Temperature>>;

/// How heat flows change with temperatures, entry by entry: \f$ \partial \dot Q_i/\partial \theta_j \f$ [W/K].
using HeatSlopes = std::vector<Eigen::Triplet<double>>;

/// A law that knows the slopes of its heat: `add_heat_slopes(law, domain, at, slopes)` appends them, of a view with
/// velocities and temperatures.
template <class L, class D>
concept HasHeatSlopes = AddsHeat<L, D> &&
    requires(const L& law, const D& domain, const At<Velocity, Temperature>& at, HeatSlopes& slopes) {
  add_heat_slopes(law, domain, at, slopes);
};

/// A law whose force falls into a part of few pairs, which changes fast, and the rest: `choose_close(law, domain, at,
/// dt)` chooses the pairs for a step of size dt that starts there, in the scratch, and returns whether it could;
/// `add_close_force(law, domain, at, forces)` adds what they exert.
template <class L, class D>
concept SplitsForce = requires(const L& law, const D& domain, const At<Velocity>& at, double dt, Forces force) {
  { choose_close(law, domain, at, dt) } -> std::same_as<bool>;
  { add_close_force(law, domain, at, force) } -> std::same_as<bool>;
};

/// A law with a potential: `potential_energy(law, domain, at)` [J], of which its forces are the negative gradient.
template <class L, class D>
concept Conservative = requires(const L& law, const D& domain, const At<>& at) {
  { potential_energy(law, domain, at) } -> std::same_as<double>;
};

/// A law that changes velocities at once at the end of every step: `jump(law, domain, at, dt, velocity)`, with a copy
/// of the velocities, 3 N numbers, to change in place. What it counts as an impact makes a scheme forget. It books the
/// change of the kinetic energy, best as \f$ \tfrac12 m\,(v' - v) \cdot (v' + v) \f$, which keeps the digits that a
/// difference of squares loses, and between bodies as the impulse times the mean of their relative velocities.
template <class L, class D>
concept ChangesVelocities = requires(const L& law, const D& domain, const At<Velocity>& at, double dt,
                                     schemes::Out velocity) {
  { jump(law, domain, at, dt, velocity) } -> std::same_as<schemes::Jump>;
};

/// A law that can say why it has no force somewhere: `why_no_force(law, domain, at)`; empty: it has one.
template <class L, class D>
concept SaysWhy = requires(const L& law, const D& domain, const At<>& at) {
  { why_no_force(law, domain, at) } -> std::same_as<std::string>;
};

/// A law that can be checked where it enters a scene: `validate(law)` throws std::invalid_argument.
template <class L>
concept Validated = requires(const L& law) {
  validate(law);
};

/// A law that can be checked against the particles of the scene it enters: `validate(law, particles)` throws
/// std::invalid_argument.
template <class L>
concept ValidatedWith = requires(const L& law, const kinematics::Particles& particles) {
  validate(law, particles);
};

/// A law that can be checked against the domain it enters: `validate(law, domain)` throws std::invalid_argument.
template <class L, class D>
concept ValidatedIn = requires(const L& law, const D& domain) {
  validate(law, domain);
};

}  // namespace particulate::laws
