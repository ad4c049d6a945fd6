#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <particulate/contact/contact.hpp>
#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/laws/law.hpp>
#include <particulate/schemes/problem.hpp>

namespace particulate::scenes {

namespace detail {

// Outside the scene, whose own member of that name would hide what stands beside the law.
template <class L, class D>
double energy_of(const L& law, const D& domain, const laws::At<>& at) {
  if constexpr (laws::Conservative<L, D>) return potential_energy(law, domain, at);
  return 0.0;
}

template <class L, class D>
std::string why_of(const L& law, const D& domain, const laws::At<>& at) {
  if constexpr (laws::SaysWhy<L, D>) return why_no_force(law, domain, at);
  return {};
}

template <class L>
auto tolerance_of(const L& law) {
  using contact::touching_tolerance;
  return touching_tolerance(law);
}

template <class L, class D>
schemes::Jump jump_of(const L& law, const D& domain, const laws::At<laws::Velocity>& at, double dt,
                      schemes::Out velocity) {
  return jump(law, domain, at, dt, velocity);
}

template <class L>
double heat_of_impact(const L& law, const laws::At<laws::Temperature>& at, const contact::ImpactRecord& impact,
                      schemes::Out heat) {
  if constexpr (contact::HeatsImpacts<L>) return add_heat_of_impact(law, at, impact, heat);
  return 0.0;
}

// Adds what one law did to what all have done.
void add_jump(schemes::Jump one, schemes::Jump& all);

[[noreturn]] void refuse_length(Eigen::Index given, Eigen::Index N);

// The distance of the nearest two that are apart, of the positions of all bodies, column by column.
template <class D>
double closest(const D& domain, schemes::In r) {
  const Eigen::Map<const kinematics::Vectors> at(r.data(), r.size() / 3, 3);
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < at.rows(); ++i) {
    const Eigen::Vector3d here = at.row(i);
    for (Eigen::Index j = i + 1; j < at.rows(); ++j) {
      const double apart = kinematics::length(separation(domain, here, at.row(j)));
      if (apart > 0.0) nearest = std::min(nearest, apart);
    }
  }
  return std::isfinite(nearest) ? nearest : 0.0;
}

// The same by search.
double closest(const kinematics::Space& domain, schemes::In r);

// Which temperature is negative or no number; empty: none.
std::string why_no_temperature(schemes::In y);

// Refuses particles without temperatures, or another number of them.
void require_temperatures(const kinematics::Particles& particles);
void require_temperatures(Eigen::Index given, Eigen::Index N);

// A vector of another length would be read beyond its end.
inline void require_length(Eigen::Index given, Eigen::Index N) {
  if (given != 3 * N) refuse_length(given, N);
}

}  // namespace detail

/// The problem that a set of particles, a domain and a pack of laws pose.
///
/// \f[ m_i \ddot r_i = \Psi_i^{tot}(r_1, \dots, r_{N_p}) \f]
///
/// @equation{M 2.1} Composed at compile time: absent laws leave no code, no loops and no arrays. If a law asks for
/// velocities the scene is a MotionProblem, else a PositionProblem. A law that the scene does not understand does not
/// compile. A state of another length than 3 N is a caller's mistake and throws std::invalid_argument. A scene
/// serves one run at a time, because its laws share its scratch; a copy is cheap, and threads take copies.
template <kinematics::Domain D, class... Laws>
class Scene {
  static_assert(
      ((laws::Force<Laws, D> || laws::AddsHeat<Laws, D> || contact::Impacts<Laws> || contact::HeatsImpacts<Laws> ||
        laws::ChangesVelocities<Laws, D>)&&...),
      "a law of this scene has no add_force(law, domain, at, forces) for this domain, nor add_heat(law, domain, at, "
      "heat), nor resolves or heats impacts, nor jumps");
  static_assert((contact::Impacts<Laws> || ...) || !(contact::HeatsImpacts<Laws> || ...),
                "a law of this scene turns impacts into heat, and no law resolves any: add a contact");
  static_assert(
      (0 + ... + static_cast<int>(contact::Impacts<Laws>)) <= 1,
      "a scene has at most one law that resolves impacts: several would each settle what the other unsettles");

 public:
  /// Checks particles and laws once, where they enter.
  ///
  /// @param particles  the start, and what stays with each particle
  /// @param domain     forms the separations
  /// @param laws       the laws, in the order in which their forces are added
  /// @throws std::invalid_argument from the first part that refuses itself
  Scene(kinematics::Particles particles, D domain, Laws... laws)
      : particles_(std::move(particles)), domain_(std::move(domain)), laws_(std::move(laws)...) {
    validate(particles_);
    check(domain_);
    if constexpr (std::same_as<D, kinematics::Space>) validate_periods(domain_, particles_.radius);
    std::apply(
        [&](const auto&... law) {
          (check(law), ...), (check_with(particles_, law), ...), (check_in(domain_, law), ...);
        },
        laws_);
    inverse_mass_ = inverse_masses(particles_);
    if constexpr (has_temperatures) detail::require_temperatures(particles_);
  }

  /// Whether a law heats or cools, so that temperatures have a rate.
  static constexpr bool has_heat_flow = (laws::AddsHeat<Laws, D> || ...);
  /// Whether a law turns impacts into heat.
  static constexpr bool heats_impacts = (contact::HeatsImpacts<Laws> || ...);
  /// Whether the particles have temperatures, which are then the y of the scene's states [K].
  static constexpr bool has_temperatures =
      has_heat_flow || heats_impacts || ((laws::needs_temperature<Laws, D> || contact::Softens<Laws>) || ...);
  /// Whether they change by impacts alone. @see schemes::CoupledProblem
  static constexpr bool values_by_jumps = has_temperatures && !has_heat_flow;
  /// Whether motion and temperatures act on each other at every moment.
  static constexpr bool is_coupled = has_heat_flow || (laws::needs_temperature<Laws, D> || ...);

  /// Whether a law has a potential energy: one that exerts no force has none to speak of, and counts with zero.
  template <class L>
  static constexpr bool has_potential = laws::Conservative<L, D> || !laws::Force<L, D>;

  /// Whether a law asks for velocities.
  static constexpr bool needs_velocity = ((laws::needs_velocity<Laws, D> || laws::heat_needs_velocity<Laws, D>) || ...);
  /// Whether none does. @see schemes::CoupledProblem
  static constexpr bool ignores_velocities = !needs_velocity;
  /// Whether a law changes velocities at once at the end of a step.
  template <class L>
  static constexpr bool jumps = contact::Impacts<L> || laws::ChangesVelocities<L, D>;
  /// How many do.
  static constexpr int jumping_laws = (0 + ... + static_cast<int>(jumps<Laws>));

  /// @return the start, and what stays with each particle
  const kinematics::Particles& particles() const { return particles_; }
  /// @return the domain
  const D& domain() const { return domain_; }

  /// @tparam L  which of its laws
  /// @return that law
  template <class L>
  const L& law() const {
    return std::get<L>(laws_);
  }

  /// Accelerations at given positions. @see schemes::PositionProblem
  ///
  /// @param t  time [s]
  /// @param r  positions, 3 N numbers, column by column [m]
  /// @param a  receives the accelerations, as long as r [m/s^2]
  /// @return whether they have a finite value there
  bool acceleration(double t, schemes::In r, schemes::Out a) const requires(!needs_velocity && !is_coupled) {
    return force(places(t, r), a) && divide_by_mass(a);
  }
  /// Accelerations at given positions and velocities. @see schemes::MotionProblem
  ///
  /// @param t  time [s]
  /// @param r  positions, 3 N numbers, column by column [m]
  /// @param v  velocities, as long as r [m/s]
  /// @param a  receives the accelerations, as long as r [m/s^2]
  /// @return whether they have a finite value there
  bool acceleration(double t, schemes::In r, schemes::In v, schemes::Out a) const
      requires(needs_velocity && !is_coupled) {
    return force(moving(t, r, v), a) && divide_by_mass(a);
  }
  /// Accelerations, and rates of the temperatures,
  ///
  /// \f[ m_i c_i\, \dot\theta_i = \dot Q_i . \f]
  ///
  /// @see schemes::CoupledProblem
  /// @param t   time [s]
  /// @param r   positions, 3 N numbers, column by column [m]
  /// @param v   velocities, as long as r; not looked at where no law asks for them [m/s]
  /// @param y   temperatures, N numbers [K]
  /// @param a   receives the accelerations, as long as r [m/s^2]
  /// @param dy  receives the rates, N numbers; empty where temperatures change by impacts alone [K/s]
  /// @return whether all have a finite value there: not where a temperature is negative
  bool rates(double t, schemes::In r, schemes::In v, schemes::In y, schemes::Out a,
             schemes::Out dy) const requires is_coupled {
    const auto at = view(t, r, v, y);
    return (y.array() >= 0.0).all() && force(at, a) && divide_by_mass(a) && heat(at, dy);
  }
  /// The accelerations of rates() alone, as of a field whose temperatures are frozen.
  ///
  /// @param t  time [s]
  /// @param r  positions, 3 N numbers, column by column [m]
  /// @param v  velocities, as long as r; not looked at where no law asks for them [m/s]
  /// @param y  temperatures, N numbers [K]
  /// @param a  receives the accelerations, as long as r [m/s^2]
  /// @return whether all have a finite value there
  bool motion_rates(double t, schemes::In r, schemes::In v, schemes::In y, schemes::Out a) const requires is_coupled {
    return (y.array() >= 0.0).all() && force(view(t, r, v, y), a) && divide_by_mass(a);
  }
  /// The rates of the temperatures alone, as of a field whose places are frozen.
  ///
  /// @param t   time [s]
  /// @param r   positions, 3 N numbers, column by column [m]
  /// @param v   velocities, as long as r; not looked at where no law asks for them [m/s]
  /// @param y   temperatures, N numbers [K]
  /// @param dy  receives the rates, N numbers; empty where temperatures change by impacts alone [K/s]
  /// @return whether all have a finite value there: not where a temperature is negative
  bool temperature_rates(double t, schemes::In r, schemes::In v, schemes::In y,
                         schemes::Out dy) const requires is_coupled {
    return (y.array() >= 0.0).all() && heat(view(t, r, v, y), dy);
  }
  /// How these rates change with the temperatures, where every law that heats knows it.
  ///
  /// @param t  time [s]
  /// @param r  positions, 3 N numbers, column by column [m]
  /// @param v  velocities, as long as r [m/s]
  /// @param y  temperatures, N numbers [K]
  /// @param J  receives \f$ \partial \dot\theta_i/\partial \theta_j \f$, N x N [1/s]
  void temperature_jacobian(double t, schemes::In r, schemes::In v, schemes::In y, schemes::SparseJacobian& J) const
      requires(has_heat_flow && ((!laws::AddsHeat<Laws, D> || laws::HasHeatSlopes<Laws, D>)&&...)) {
    const laws::At<laws::Velocity, laws::Temperature> at{moving(t, r, v), temperatures(y)};
    laws::HeatSlopes slopes;
    std::apply([&](const auto&... law) { (add_slopes(law, at, slopes), ...); }, laws_);
    J.resize(y.size(), y.size());
    J.setFromTriplets(slopes.begin(), slopes.end());
    J = Eigen::VectorXd((particles_.mass.array() * particles_.heat_capacity.array()).inverse()).asDiagonal() * J;
  }
  /// @return one range, of temperatures @see schemes::HasRanges
  std::vector<schemes::Range> ranges() const requires has_temperatures {
    return {{.name = "temperatures", .first = 0, .size = particles_.size()}};
  }

  /// How many laws have a part that changes fast.
  static constexpr int splitting_laws = (0 + ... + static_cast<int>(laws::SplitsForce<Laws, D>));

  /// Chooses the pairs whose forces change fast over a step. @see schemes::SplitsMotion
  ///
  /// @param state  a state of this scene, the start of the step
  /// @param dt     the step, > 0 [s]
  /// @return false: they are too many for so long a step
  bool split(const schemes::State& state, double dt) const requires(!needs_velocity && splitting_laws == 1) {
    const laws::At<laws::Velocity> at = moving(state.t, state.r, state.v);
    return std::apply([&](const auto&... law) { return (choose(law, at, dt) && ...); }, laws_);
  }
  /// The part of acceleration() that these pairs make. @see schemes::SplitsMotion
  ///
  /// @param t  time [s]
  /// @param r  positions, 3 N numbers, column by column [m]
  /// @param a  receives the accelerations, as long as r [m/s^2]
  /// @return whether they have a finite value there
  bool acceleration_fast(double t, schemes::In r, schemes::Out a) const
      requires(!needs_velocity && splitting_laws == 1) {
    const laws::At<> at = places(t, r);
    return force_of(a, [&](const auto& law, laws::Forces sum) { return add_fast(law, at, sum); }) && divide_by_mass(a);
  }

  /// Total force on every particle, \f$ \Psi_i^{tot} \f$.
  ///
  /// @param state  a state of this scene
  /// @param f      receives the forces, 3 N numbers, column by column [N]
  /// @return whether they have a value there
  bool total_force(const schemes::State& state, schemes::Out f) const {
    return force(view(state.t, state.r, state.v, state.y), f);
  }

  /// The same, and the potential energy of all laws; a near field in Space finds both in one pass over its pairs.
  ///
  /// @param state   a state of this scene
  /// @param f       receives the forces, 3 N numbers, column by column [N]
  /// @param energy  receives the potential energy [J]
  /// @return whether they have a value there
  bool total_force(const schemes::State& state, schemes::Out f, double& energy) const
      requires(has_potential<Laws>&&...) {
    const auto at = view(state.t, state.r, state.v, state.y);
    energy = 0.0;
    return force_of(f, [&](const auto& law, laws::Forces sum) {
      if constexpr (requires { add_force_and_energy(law, domain_, at, sum, energy); }) {
        return add_force_and_energy(law, domain_, at, sum, energy);
      } else {
        energy += detail::energy_of(law, domain_, at);
        return add(law, at, sum);
      }
    });
  }

  /// Potential energy of all laws; a scene with a law that has none does not offer it.
  ///
  /// @param state  a state of this scene
  /// @return energy [J]
  double potential_energy(const schemes::State& state) const requires(has_potential<Laws>&&...) {
    const laws::At<> at = places(state.t, state.r);
    return std::apply([&](const auto&... law) { return (0.0 + ... + detail::energy_of(law, domain_, at)); }, laws_);
  }

  /// What the laws change at once at the end of a step, one after the other: contacts, limits. The other forces are
  /// asked for only where bodies meet.
  ///
  /// @param state  a state of this scene; its velocities are changed
  /// @param dt     the step that ends there [s]
  /// @return impacts, change of kinetic energy, overlap, and where several laws jump those of each; unsettled if a
  ///         direction or a force is missing
  schemes::Jump jump(schemes::State& state, double dt) const requires(jumping_laws > 0) {
    schemes::Jump all;
    const auto do_one = [&](const auto& law) {
      if constexpr (jumps<std::decay_t<decltype(law)>>) {
        if (all.unsettled.empty()) add_jump(jump_by(law, state, dt), all);
      }
    };
    std::apply([&](const auto&... law) { (do_one(law), ...); }, laws_);
    return all;
  }

  /// @param state  a state of this scene
  /// @return how many bodies overlap each other or a wall there, and how deep
  schemes::Overlap overlap(const schemes::State& state) const requires(contact::Impacts<Laws> || ...) {
    return contact::overlap_of(contact::find_touching(domain_, moving(state.t, state.r, state.v)));
  }

  /// Why a law has no force somewhere. @see schemes::SaysWhy
  ///
  /// @param state  a state of this scene
  /// @return which particles are the reason and what to do: by their temperatures, else by the first law that can tell;
  ///         empty where none is
  std::string why_no_value(const schemes::State& state) const {
    const laws::At<> at = places(state.t, state.r);
    std::string why;
    if constexpr (is_coupled) why = detail::why_no_temperature(state.y);
    const auto ask = [&](const auto& law) {
      if (why.empty()) why = detail::why_of(law, domain_, at);
    };
    std::apply([&](const auto&... law) { (ask(law), ...); }, laws_);
    return why;
  }

  /// The first place of a step at which bodies touch; only a scene with located contacts offers it.
  /// @see schemes::LocatesJumps
  ///
  /// @param path  the step
  /// @param end   how far to look [-]
  /// @return its place, in (0, end]; none if there is none
  std::optional<double> first_jump(const schemes::StepPath& path, double end) const
      requires(contact::LocatesImpacts<Laws, D> || ...) {
    std::optional<double> first;
    const auto locate = [&](const auto& law) {
      if constexpr (contact::LocatesImpacts<std::decay_t<decltype(law)>, D>) {
        first = first_impact(law, domain_, particles_.radius, inverse_mass_, scratch_.neighbours, path, end);
      }
    };
    std::apply([&](const auto&... law) { (locate(law), ...); }, laws_);
    return first;
  }

  /// The monograph's measure, the sum over particles of \f$ \|x_i - y_i\| \f$. @see schemes::Measures
  ///
  /// @param x  one set of positions, 3 N numbers
  /// @param y  another
  /// @return their distance [m]
  double distance(schemes::In x, schemes::In y) const { return (shaped(x) - shaped(y)).rowwise().norm().sum(); }

  /// The distance of the two bodies that are nearest to one another, of those apart. @see schemes::HasScales
  ///
  /// @param r  positions, 3 N numbers
  /// @return distance of their centres; 0 where there are no two [m]
  double spacing(schemes::In r) const { return detail::closest(domain_, r); }
  /// The mean velocity of the bodies, each counting once. One body alone shares its motion with none.
  /// @see schemes::HasScales
  ///
  /// @param v       velocities, 3 N numbers [m/s]
  /// @param shared  receives the mean, for every body, 3 N numbers [m/s]
  void common_motion(schemes::In v, schemes::Out shared) const {
    const Eigen::Index N = particles_.size();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      shared.segment(axis * N, N).setConstant(N > 1 ? v.segment(axis * N, N).mean() : 0.0);
    }
  }

 private:
  using Shaped = Eigen::Map<const kinematics::Vectors>;

  static void add_jump(schemes::Jump one, schemes::Jump& all) {
    if constexpr (jumping_laws == 1) {
      all = std::move(one);
    } else {
      detail::add_jump(std::move(one), all);
    }
  }
  template <class L>
  schemes::Jump jump_by(const L& law, schemes::State& state, double dt) const {
    const laws::At<laws::Velocity> here = moving(state.t, state.r, state.v);
    if constexpr (contact::Impacts<L>) {
      schemes::Jump jump = impacts_by(law, here, state, dt);
      if constexpr (!contact::LocatesImpacts<L, D>) jump.travel = contact::travel(domain_, here, dt);
      return jump;
    } else {
      Eigen::VectorXd& after = scratch_.after;
      after = state.v;
      schemes::Jump jump = detail::jump_of(law, domain_, here, dt, after);
      state.v = after;
      return jump;
    }
  }

  template <class L>
  schemes::Jump impacts_by(const L& law, const laws::At<laws::Velocity>& here, schemes::State& state, double dt) const {
    contact::Touching touching = contact::find_touching(domain_, here, detail::tolerance_of(law));
    if (!contact::any_approach(touching, here)) {
      return {.overlap = touching.overlap, .penetration = touching.penetration, .unsettled = {}};
    }
    Eigen::VectorXd &others = scratch_.others, &after = scratch_.after;
    others.resize(state.r.size());
    if (!total_force(state, others)) {
      const std::string why = why_no_value(state);
      return {.overlap = touching.overlap,
              .penetration = touching.penetration,
              .evaluations = 1,
              .unsettled = "the forces have no value where bodies touch" + (why.empty() ? "" : ": " + why)};
    }
    after = state.v;
    schemes::Jump jump = resolve(law, here, std::move(touching), dt, state.y);
    jump.evaluations = 1;
    state.v.swap(after);
    return jump;
  }

  // Resolves what touches, from the other forces to the velocities after in the scratch; what becomes heat goes to the
  // temperatures.
  template <class L>
  schemes::Jump resolve(const L& law, const laws::At<laws::Velocity>& here, contact::Touching touching, double dt,
                        schemes::Out y) const {
    Eigen::VectorXd &others = scratch_.others, &after = scratch_.after;
    if constexpr (contact::Softens<L>) contact::soften(law.restitution, y, touching);
    if constexpr (!heats_impacts) {
      return resolve_impacts(law, here, std::move(touching), others, dt, after);
    } else {
      const laws::At<laws::Temperature> at{here, temperatures(y)};
      Eigen::VectorXd& heat = scratch_.heat;
      heat.setZero(y.size());
      double released = 0.0;
      L told = law;
      told.recorder = [&](const contact::ImpactRecord& one) {
        if (law.recorder) law.recorder(one);
        const auto heated_by = [&](const auto& each) { return detail::heat_of_impact(each, at, one, heat); };
        std::apply([&](const auto&... each) { ((released += heated_by(each)), ...); }, laws_);
      };
      schemes::Jump jump = resolve_impacts(told, here, std::move(touching), others, dt, after);
      if (!jump.unsettled.empty()) return jump;
      y.array() += heat.array() / (particles_.mass.array() * particles_.heat_capacity.array());
      jump.heat = heat.sum();
      jump.released = released;
      return jump;
    }
  }

  template <class L>
  static void check(const L& law) {
    if constexpr (laws::Validated<L>) validate(law);
  }
  template <class L>
  static void check_with(const kinematics::Particles& particles, const L& law) {
    if constexpr (laws::ValidatedWith<L>) validate(law, particles);
  }
  template <class L>
  static void check_in(const D& domain, const L& law) {
    if constexpr (laws::ValidatedIn<L, D>) validate(law, domain);
  }
  Shaped shaped(const schemes::In& x) const {
    detail::require_length(x.size(), particles_.size());
    return {x.data(), particles_.size(), 3};
  }
  laws::At<> places(double t, const schemes::In& r) const {
    return {.t = t,
            .position = shaped(r),
            .mass = particles_.mass,
            .radius = particles_.radius,
            .inverse_mass = inverse_mass_,
            .scratch = scratch_};
  }
  laws::At<laws::Velocity> moving(double t, const schemes::In& r, const schemes::In& v) const {
    return {places(t, r), shaped(v)};
  }

  Eigen::Map<const Eigen::VectorXd> temperatures(const schemes::In& y) const {
    detail::require_temperatures(y.size(), particles_.size());
    return {y.data(), y.size()};
  }
  // As much of a moment as the laws ask for.
  auto view(double t, const schemes::In& r, const schemes::In& v, const schemes::In& y) const {
    if constexpr (is_coupled && needs_velocity) {
      return laws::At<laws::Velocity, laws::Temperature>{moving(t, r, v), temperatures(y)};
    } else if constexpr (is_coupled) {
      return laws::At<laws::Temperature>{places(t, r), temperatures(y)};
    } else if constexpr (needs_velocity) {
      return moving(t, r, v);
    } else {
      return places(t, r);
    }
  }

  template <class L, class Here>
  bool add_flow(const L& law, const Here& at, laws::Heats sum) const {
    if constexpr (laws::AddsHeat<L, D>) return add_heat(law, domain_, at, sum);
    return true;
  }
  template <class L>
  void add_slopes(const L& law, const laws::At<laws::Velocity, laws::Temperature>& at, laws::HeatSlopes& slopes) const {
    if constexpr (laws::HasHeatSlopes<L, D>) add_heat_slopes(law, domain_, at, slopes);
  }
  template <class Here>
  bool heat(const Here& at, schemes::Out dy) const {
    if constexpr (has_heat_flow) {
      dy.setZero();
      const laws::Heats sum(dy.data(), dy.size());
      const bool all = std::apply([&](const auto&... law) { return (add_flow(law, at, sum) && ...); }, laws_);
      dy.array() /= particles_.mass.array() * particles_.heat_capacity.array();
      return all && dy.allFinite();
    }
    return true;
  }

  template <class L, class Here>
  bool add(const L& law, const Here& at, laws::Forces sum) const {
    if constexpr (laws::Force<L, D>) return add_force(law, domain_, at, sum);
    return true;
  }
  template <class L>
  bool choose(const L& law, const laws::At<laws::Velocity>& at, double dt) const {
    if constexpr (laws::SplitsForce<L, D>) return choose_close(law, domain_, at, dt);
    return true;
  }
  template <class L>
  bool add_fast(const L& law, const laws::At<>& at, laws::Forces sum) const {
    if constexpr (laws::SplitsForce<L, D>) return add_close_force(law, domain_, at, sum);
    return true;
  }
  template <class AddTo>
  bool force_of(schemes::Out f, const AddTo& add_to) const {
    detail::require_length(f.size(), particles_.size());
    f.setZero();
    const laws::Forces sum(f.data(), particles_.size(), 3);
    return std::apply([&](const auto&... law) { return (add_to(law, sum) && ...); }, laws_);
  }
  template <class Here>
  bool force(const Here& at, schemes::Out f) const {
    return force_of(f, [&](const auto& law, laws::Forces sum) { return add(law, at, sum); });
  }
  bool divide_by_mass(schemes::Out a) const {
    laws::Forces(a.data(), particles_.size(), 3).array().colwise() *= inverse_mass_.array();
    return a.allFinite();
  }

  kinematics::Particles particles_;
  Eigen::VectorXd inverse_mass_;
  D domain_;
  std::tuple<Laws...> laws_;
  mutable laws::Scratch scratch_;  // a scene serves one run at a time
};

/// Where a scene starts.
///
/// @param scene  the scene
/// @return its particles' positions, velocities and, with heat, temperatures at t = 0
template <kinematics::Domain D, class... Laws>
schemes::State start(const Scene<D, Laws...>& scene) {
  schemes::State state{
      .t = 0.0, .r = scene.particles().position.reshaped(), .v = scene.particles().velocity.reshaped()};
  if constexpr (Scene<D, Laws...>::has_temperatures) state.y = scene.particles().temperature;
  return state;
}

}  // namespace particulate::scenes
