#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/sampling.hpp>

namespace particulate::scenes {

/// What becomes of a scene in time: an observer for integrate() that writes a row at each of the given times, without
/// cutting a step for them.
///
///     History history(scene, schemes::multiples(0.01, 0.0, 1.0));
///     integrate(scene, state, 1.0, scheme, control, history);
///
/// Energies are those of all particles over their mass, so that the monograph's Figures 4.2 and 4.3 are columns:
///
/// - `time [s]`: the time of the row
/// - `bulk [J/kg]`, `relative [J/kg]`: kinetic energy of the motion of the whole, and about it: split_kinetic_energy()
/// - `potential [J/kg]`: of all laws; only of a scene in which each has one
/// - `lost [J/kg]`: kinetic energy that impacts, and other jumps, took so far: it closes the books
/// - `momentum x [kg m/s]` and `y`, `z`: linear_momentum()
/// - `impacts`: pairs that exchanged an impulse so far
/// - `overlap [m]`: the deepest overlap at the end of a step so far
/// - `heat [J/kg]`, `released [J/kg]`, `temperature [K]`, only with temperatures: thermal energy that impacts added so
///   far, chemical energy of which it came, and the mean temperature of the particles
///
/// A row at the end of a step is written after its jump, so that the last one agrees with the Outcome. A row inside a
/// step is dense output, of whose order it is. To do more at other times, wrap it: `Sampling(times, receive,
/// std::ref(history))`.
class History {
 public:
  /// @param scene  whose run it is; it must outlive the history
  /// @param times  finite, each later than the one before [s]
  /// @throws std::invalid_argument for times that are not in order
  template <kinematics::Domain D, class... Laws>
  History(const Scene<D, Laws...>& scene, std::vector<double> times) : History(scene.particles(), std::move(times)) {
    if constexpr (requires(const schemes::State& at) { scene.potential_energy(at); }) {
      potential_ = [&scene](const schemes::State& at) { return scene.potential_energy(at); };
    }
    has_temperatures_ = Scene<D, Laws...>::has_temperatures;
    name_columns();
  }
  /// A scene that ends with its line has no history that outlives it.
  template <kinematics::Domain D, class... Laws>
  History(const Scene<D, Laws...>&& scene, std::vector<double> times) = delete;

  /// One step of a run.
  ///
  /// @param from    its start
  /// @param to      its end
  /// @param dt      its length [s]
  /// @param scheme  that made it, with dense output
  /// @return true: go on
  /// @throws std::invalid_argument if a time lies before the start of the run
  template <class S>
  bool operator()(const schemes::State& from, const schemes::State& to, double dt, const S& scheme) {
    times_.visit(from, to, dt, scheme, [&](const schemes::State& at) { add_row(at); });
    return true;
  }
  /// @param after  the state after a jump
  /// @param jump   what it did
  void jumped(const schemes::State& after, const schemes::Jump& jump);

  /// @return the columns' names with their units
  const std::vector<std::string>& columns() const { return columns_; }
  /// A row a time, a column a name.
  using Rows = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  /// @return the rows so far: a view that the next step of the run ends
  Rows rows() const;

  /// @return all that it knows, for a Checkpoint
  std::vector<double> memory() const;
  /// Goes on where another history was.
  ///
  /// @param memory  of a history of the same scene and times
  /// @throws std::invalid_argument if it is of others
  void remember(const std::vector<double>& memory);

 private:
  History(const kinematics::Particles& particles, std::vector<double> times);
  void name_columns();
  void add_row(const schemes::State& at);

  const kinematics::Particles* particles_;
  std::function<double(const schemes::State&)> potential_ = {};  // none: the scene has no potential
  std::vector<double> all_times_;
  schemes::detail::SampleTimes times_;
  std::vector<std::string> columns_;
  std::vector<double> values_;  // row by row
  bool has_temperatures_ = false;
  double impacts_ = 0.0, lost_ = 0.0, overlap_ = 0.0, heat_ = 0.0, released_ = 0.0;
};

}  // namespace particulate::scenes
