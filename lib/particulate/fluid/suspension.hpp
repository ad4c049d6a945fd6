#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <particulate/fluid/exchange.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// Particles in a fluid that they move: a problem for every scheme, and a staggered one.

namespace particulate::fluid {

struct NoHeat {};  ///< Particles and fluid exchange no heat.

/// What a closed suspension keeps.
struct Totals {
  double mass = 0.0;                                   ///< of the fluid [kg]
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< of fluid and particles [kg m/s]
  double energy = 0.0;  ///< of both: kinetic, and where there is a temperature inner energy; of no near field [J]
};

namespace detail {

// Brings into a scene what the suspension has worked out.
template <bool heats>
struct FromFluid {
  mutable Eigen::VectorXd force = {};  // 3 N [N]
  mutable Eigen::VectorXd heat = {};   // N [W]
};
template <bool heats, kinematics::Domain D>
bool add_force(const FromFluid<heats>& law, const D&, const laws::At<laws::Velocity>&, laws::Forces force) {
  force.reshaped() += law.force;
  return true;
}
template <bool heats, kinematics::Domain D>
bool add_heat(const FromFluid<heats>& law, const D&, const laws::At<laws::Temperature>&,
              laws::Heats heat) requires(heats) {
  heat += law.heat;
  return true;
}

Eigen::VectorXd half_widths(const kinematics::Particles& particles, const Spreading& spreading);
void require_corrected(const Eigen::VectorXd& half_width, const Eigen::VectorXd& radius);
void require_no_overlap(const kinematics::Space& domain, const kinematics::Particles& particles);
[[noreturn]] void refuse_size(Eigen::Index r, Eigen::Index v, Eigen::Index y, Eigen::Index N, Eigen::Index expected);
[[noreturn]] void refuse_order(std::size_t k);
[[noreturn]] void refuse_viscosity(double mu);
std::string outside(Eigen::Index particle, const Eigen::Vector3d& place);

// The box of a flow as a domain: it begins again where the flow does, and has the flow's walls.
template <int Dim>
kinematics::Space domain_of(const Grid<Dim>& grid, const Boundaries<Dim>& boundaries);

// Rates of particles as the fluid around them feels them.
struct Loads {
  double relaxes = 0.0, loads = 0.0, cools = 0.0, warms = 0.0;
};
// `weight`: of each cell, its mass and its heat capacity.
template <int Dim>
Loads loads(const Exchange::Rates& rates, const Hats<Dim>& hats, const Eigen::MatrixX2d& weight);
void add_scales(const Loads& loads, std::vector<schemes::TimeScale>& scales);

}  // namespace detail

/// Particles in a fluid that they move.
///
/// \f[ m_i\, \ddot r_i = \Psi_i^{drag} + \Psi_i^{other}, \qquad
///     \Psi_i^{drag} = \tfrac12 C_D\, \rho_f\, \|v_f - v_i\|\, (v_f - v_i)\, \pi b_i^2 \f]
/// \f[ m_i\, c_i\, \dot\theta_i = h_c\, a_s\, (\theta_f - \theta_i)
///     - B\,\varepsilon\, a_s\, (\theta_i^4 - \theta_s^4) + a_v\, \Psi_i^{drag} \cdot (v_f - v_i) \f]
/// \f[ \frac{d}{dt} \begin{pmatrix} \rho v \\ E \end{pmatrix}_q
///     = \dots - \sum_i \frac{w_{iq}}{V_q} \begin{pmatrix} \Psi_i^{drag}
///     \\ \Psi_i^{drag} \cdot v_i + h_c\, a_s\, (\theta_f - \theta_i) + a_v\, \Psi_i^{drag} \cdot (v_f - v_i)
///     \end{pmatrix} \f]
///
/// @equation{R 8.1.2} What a particle feels of the fluid is the mean of Hats around it, and by the same weights the
/// fluid loses what the particle gets: impulse, work and heat. So momentum and energy are kept, and of what drag
/// dissipates the fluid is left with \f$ 1 - a_v \f$. Particles take no room from the fluid.
///
/// Its state is r, v and \f$ y = (\rho \mid \rho v \mid E \mid \theta_p) \f$; without exchange of heat, and without
/// another law of heat, there is no \f$ \theta_p \f$. Places are not wrapped. Where the fluid has fewer than three
/// directions, the box is a metre wide across, and particles move freely there.
///
/// Staggered (8.4) it has the fields: particles, their temperatures if they have any, density, momentum, energy. The
/// first two solve their drag and their heat implicitly, with coefficients of the iterate, and the last two then get
/// exactly what these just lost: mass, momentum and energy are kept to rounding whatever the number of sweeps. To be
/// solved in this order. Relaxation moves fields apart from each other, and keeps neither.
///
/// Near fields, contacts and the heat of chapter 7 act among the particles as in a scenes::Scene, in a space that
/// begins again where the flow does, and has the flow's walls. It is copied where threads ask at once.
/// @tparam F     a Flow
/// @tparam Heat  NoHeat or HeatExchange
/// @tparam Laws  further laws of the particles
template <class F, class Heat = NoHeat, class... Laws>
class Suspension {
  static constexpr bool exchanges_heat = std::same_as<Heat, HeatExchange>;
  static_assert(exchanges_heat || std::same_as<Heat, NoHeat>,
                "the fourth part of a suspension is NoHeat or HeatExchange");
  static_assert(F::has_heat || !exchanges_heat, "a barotropic fluid has no temperature: it exchanges no heat");
  using FromFluid = detail::FromFluid<exchanges_heat>;
  using Particles = scenes::Scene<kinematics::Space, FromFluid, Laws...>;

 public:
  /// Directions of the fluid.
  static constexpr int Dim = F::directions;
  /// Whether the particles have temperatures in the state.
  static constexpr bool has_temperatures = Particles::has_temperatures;

  /// @param flow       the fluid
  /// @param particles  in it; none are allowed
  /// @param spreading  how far a particle reaches
  /// @param heat       that both exchange
  /// @param laws       of the particles
  /// @throws std::invalid_argument from the first part that refuses itself, for a hat that does not fit the grid,
  ///         particles outside of a box that does not begin again or that overlap, and a fluid without viscosity
  Suspension(F flow, kinematics::Particles particles, Spreading spreading = {}, Heat heat = {}, Laws... laws)
      : flow_(std::move(flow)),
        particles_(std::move(particles), detail::domain_of(flow_.grid(), flow_.boundaries()), FromFluid{},
                   std::move(laws)...),
        hats_(flow_.grid(), flow_.boundaries(), detail::half_widths(particles_.particles(), spreading),
              flow_.threads()),
        exchange_(particles_.particles(), Dim, hats_.half_width(), spreading.corrected, exchange_of(heat)) {
    if (spreading.corrected) detail::require_corrected(hats_.half_width(), particles_.particles().radius);
    for (Eigen::Index i = 0; i < count(); ++i) {
      const Eigen::Vector3d place = kinematics::vector(particles_.particles().position, i);
      if (!hats_.contains(place)) throw std::invalid_argument("suspension: " + detail::outside(i, place));
    }
    detail::require_no_overlap(particles_.domain(), particles_.particles());
    if constexpr (!F::varies) {
      const double mu = viscosity(flow_.fluid().viscosity);
      if (!(mu > 0.0) && count() > 0) detail::refuse_viscosity(mu);
    }
  }

  /// Accelerations, and rates of the fluid and of the temperatures. @see schemes::CoupledProblem
  ///
  /// @param t   time [s]
  /// @param r   places, 3 N numbers, column by column [m]
  /// @param v   velocities, as long as r [m/s]
  /// @param y   fluid and temperatures
  /// @param a   receives the accelerations, as long as r [m/s^2]
  /// @param dy  receives the rates, as long as y
  /// @return whether all have a finite value there
  bool rates(double t, schemes::In r, schemes::In v, schemes::In y, schemes::Out a, schemes::Out dy) const {
    require_size(r.size(), v.size(), y.size());
    const schemes::In theta = y.tail(temperatures());
    if (!flow_.rate(t, y.head(flow_.size()), dy.head(flow_.size())) || !look(r)) return false;
    if (!exchange_.rates(v, theta, law().force, law().heat)) return false;
    spread(0, Dim + (F::has_heat ? 1 : 0), -1.0 / volume(), dy);
    if constexpr (Particles::has_heat_flow) {
      return particles_.rates(t, r, v, theta, a, dy.tail(count()));
    } else {
      dy.tail(temperatures()).setZero();
      if constexpr (Particles::is_coupled) return particles_.motion_rates(t, r, v, theta, a);
      if constexpr (!Particles::is_coupled) return particles_.acceleration(t, r, v, a);
    }
  }

  /// @return 3, of a barotropic fluid, to 5
  std::size_t fields() const { return first_fluid + flow_.fields(); }
  /// @param k  which field
  /// @return where it stands in a state
  schemes::Part part(std::size_t k) const {
    if (k == 0) return {.motion = true};
    return k < first_fluid ? schemes::Part{.first = flow_.size(), .size = count()} : flow_.part(k - first_fluid);
  }
  /// One field, one step of backward Euler, the others frozen. @see schemes::StaggeredProblem
  ///
  /// @equation{R 8.4}
  /// @param k     which field, in their order
  /// @param from  state at the start of the step
  /// @param dt    step [s]
  /// @param seen  the newest values of all fields
  /// @param to    receives the field
  /// @return whether there is a value
  /// @throws std::invalid_argument if what the fluid is to lose in this step is not known yet
  bool solve(std::size_t k, const schemes::State& from, double dt, const schemes::State& seen,
             schemes::State& to) const {
    require_size(from), require_size(seen), require_size(to);
    if (k == 0) return solve_motion(from, dt, seen, to);
    if (from.t != solved_t_ || dt != solved_dt_ || from.v != solved_v_) detail::refuse_order(k);
    if (k < first_fluid) return solve_temperatures(from, dt, seen, to);
    const std::size_t field = k - first_fluid;
    const auto head = [&](auto& y) { return y.head(flow_.size()); };
    if (!flow_.solve(field, from.t, head(from.y), dt, head(seen.y), head(to.y))) return false;
    if (field == 1) spread(0, Dim, -1.0 / volume(), to.y);
    if (field == 2) spread(Dim, 1, -1.0 / volume(), to.y);
    return true;
  }
  /// @param k  which field
  /// @param x  one set of its values
  /// @param y  another
  /// @return of places the sum over particles of their distances [m]; else the sum of absolute differences
  double distance(std::size_t k, schemes::In x, schemes::In y) const {
    return k == 0 ? particles_.distance(x, y) : (x - y).template lpNorm<1>();
  }
  /// @param k   which field
  /// @param at  a state
  /// @return what its rounding is measured by @see Flow::field_size
  double field_size(std::size_t k, const schemes::State& at) const {
    if (k == 0) return at.r.template lpNorm<1>();
    if (k < first_fluid) return at.y.tail(temperatures()).template lpNorm<1>();
    return flow_.field_size(k - first_fluid, schemes::In(at.y.head(flow_.size())));
  }
  /// The distance of places of the particles. @see scenes::Scene::distance
  ///
  /// @param x  one set of places
  /// @param y  another
  /// @return the sum over particles of their distances [m]
  double distance(schemes::In x, schemes::In y) const { return particles_.distance(x, y); }
  /// @param r  places @return the distance of the nearest two @see scenes::Scene::spacing [m]
  double spacing(schemes::In r) const { return particles_.spacing(r); }
  /// @param v       velocities
  /// @param shared  receives what they share @see scenes::Scene::common_motion [m/s]
  void common_motion(schemes::In v, schemes::Out shared) const { particles_.common_motion(v, shared); }

  /// The times that limit a step: of the flow, and of what it exchanges with the particles.
  ///
  /// \f[ \frac1{t_{drag}} = \max_i \Big( \frac{\xi_i}{m_i} + R_i \Big), \qquad
  ///     \frac1{t_{load}} = \max_{\Lambda_i > 1} R_i \Big(1 - \frac1{\Lambda_i}\Big) \f]
  /// \f[ R_i = \sum_q \frac{w_{iq}}{\rho_q V_q} \sum_j w_{jq}\, \xi_j, \qquad
  ///     \Lambda_i = \sum_q \frac{w_{iq}}{\rho_q V_q} \sum_j w_{jq}\, m_j \f]
  ///
  /// @equation{D 8.4} and of heat the same with \f$ m c \f$, \f$ h_c a_s \f$ and \f$ \rho\, c \f$. Lambda is what the
  /// particles around weigh against their fluid: sweeps between both contract by \f$ \Lambda a/(1 + a) \f$,
  /// \f$ a = \Delta t\, \xi/m \f$. Near fields and contacts have none: what they do not allow, sweeps find out.
  /// @param at  a state
  /// @return those that there are
  std::vector<schemes::TimeScale> step_limits(const schemes::State& at) const {
    require_size(at);
    std::vector<schemes::TimeScale> scales = flow_.step_limits(schemes::In(at.y.head(flow_.size())));
    if (count() == 0 || !flow_.measure(at.t, at.y.head(flow_.size())) || !look(at.r)) return scales;
    Eigen::MatrixX2d weight(flow_.grid().size(), 2);
    weight.col(0) = volume() * at.y.head(flow_.grid().size());
    weight.col(1) = flow_.fluid().c * weight.col(0);
    const Exchange::Rates rates = exchange_.step_rates(at.v, at.y.tail(temperatures()));
    detail::add_scales(detail::loads(rates, hats_, weight), scales);
    return scales;
  }
  /// @param at  a state
  /// @return why it has no value: which cell, or which particle; empty: it has
  std::string why_no_value(const schemes::State& at) const {
    require_size(at);
    for (Eigen::Index i = 0; i < count(); ++i) {
      const Eigen::Vector3d place = schemes::position(at, i);
      if (!hats_.contains(place)) return detail::outside(i, place);
    }
    const std::string why = flow_.why_no_value(schemes::In(at.y.head(flow_.size())));
    return why.empty() ? particles_.why_no_value(of_particles(at)) : why;
  }
  /// @return density, momentum, energy and temperatures of particles, those that there are
  std::vector<schemes::Range> ranges() const {
    std::vector<schemes::Range> all = flow_.ranges();
    if (has_temperatures) all.push_back({.name = "particle temperatures", .first = flow_.size(), .size = count()});
    return all;
  }

  /// What contacts and other laws change at once at the end of a step; drag counts among the forces of an impact.
  ///
  /// @param at  a state; velocities and temperatures are changed
  /// @param dt  the step that ends there [s]
  /// @return impacts and what they did @see scenes::Scene::jump
  schemes::Jump jump(schemes::State& at, double dt) const requires(Particles::jumping_laws > 0) {
    require_size(at);
    if (!flow_.measure(at.t, at.y.head(flow_.size())) || !look(at.r) ||
        !exchange_.rates(at.v, at.y.tail(temperatures()), law().force, law().heat)) {
      return {.unsettled = "the fluid has no value where bodies touch: " + why_no_value(at)};
    }
    schemes::State own = of_particles(at);
    schemes::Jump jump = particles_.jump(own, dt);
    at.v = own.v;
    at.y.tail(temperatures()) = own.y;
    return jump;
  }
  /// @param at  a state
  /// @return how many particles overlap each other or a wall, and how deep
  schemes::Overlap overlap(const schemes::State& at) const requires requires(const Particles& p) { p.overlap(at); }
  { return particles_.overlap(of_particles(at)); }
  /// @param path  a step
  /// @param end   how far to look [-]
  /// @return the first place of it at which particles touch, with located contacts @see scenes::Scene::first_jump
  std::optional<double> first_jump(const schemes::StepPath& path, double end) const requires
      requires(const Particles& p) {
    p.first_jump(path, end);
  }
  { return particles_.first_jump(path, end); }

  /// A start: the particles as they were given, in a fluid.
  ///
  /// @param fluid  at a place
  /// @return the state at t = 0
  /// @throws std::invalid_argument naming the place where it cannot be
  schemes::State start(const std::function<Local<Dim>(const Vector<Dim>& x)>& fluid) const {
    schemes::State both = scenes::start(particles_), flow = flow_.start(fluid);
    Eigen::VectorXd y(flow_.size() + temperatures());
    y << flow.y, both.y;
    both.y = std::move(y);
    return both;
  }
  /// @param at    a state
  /// @param cell  of the grid, by its number
  /// @return the fluid there
  Local<Dim> local(const schemes::State& at, Eigen::Index cell) const {
    return flow_.local(schemes::In(at.y.head(flow_.size())), cell);
  }
  /// @param at  a state
  /// @return the fluid alone, a state of flow(): for snapshots
  schemes::State of_fluid(const schemes::State& at) const {
    require_size(at);
    return {.t = at.t, .y = at.y.head(flow_.size())};
  }
  /// @param at  a state
  /// @return the particles alone, with their temperatures: for snapshots, and for a scene of the same
  schemes::State of_particles(const schemes::State& at) const {
    require_size(at);
    return {.t = at.t, .r = at.r, .v = at.v, .y = at.y.tail(temperatures())};
  }
  /// What the particles feel.
  ///
  /// @param at  a state
  /// @return the fluid around each, as it is read
  /// @throws std::invalid_argument if there is none
  std::vector<Stream> streams(const schemes::State& at) const {
    require_size(at);
    if (!flow_.measure(at.t, at.y.head(flow_.size())) || !look(at.r)) throw std::invalid_argument(why_no_value(at));
    return exchange_.around;
  }
  /// @param at  a state
  /// @return Reynolds numbers of what flows past each particle [-]
  /// @throws std::invalid_argument if there is no fluid
  Eigen::VectorXd reynolds(const schemes::State& at) const {
    streams(at);
    Eigen::VectorXd all(count());
    for (Eigen::Index i = 0; i < count(); ++i) all[i] = exchange_.reynolds(i, schemes::velocity(at, i));
    return all;
  }
  /// @return which roots implicit drag took where there were two, in the sweep made last
  RootsTaken roots_taken() const { return exchange_.roots(); }
  /// @param at  a state
  /// @return its mass, momentum and energy
  Totals totals(const schemes::State& at) const {
    require_size(at);
    const Eigen::Index N = flow_.grid().size();
    const kinematics::Particles& p = particles_.particles();
    Totals all{.mass = volume() * at.y.head(N).sum()};
    for (int a = 0; a < Dim; ++a) all.momentum[a] = volume() * at.y.segment((1 + a) * N, N).sum();
    all.momentum += schemes::velocities(at).transpose() * p.mass;
    if constexpr (F::has_heat) all.energy = volume() * at.y.segment((1 + Dim) * N, N).sum();
    all.energy += 0.5 * p.mass.dot(schemes::velocities(at).rowwise().squaredNorm());
    if constexpr (has_temperatures) {
      all.energy += (p.mass.array() * p.heat_capacity.array() * at.y.tail(count()).array()).sum();
    }
    return all;
  }

  /// @return the fluid
  const F& flow() const { return flow_; }
  /// @return the particles as they started, and what stays with each
  const kinematics::Particles& particles() const { return particles_.particles(); }
  /// @return the space of the particles: the box of the flow
  const kinematics::Space& domain() const { return particles_.domain(); }

 private:
  static constexpr std::size_t first_fluid = has_temperatures ? 2 : 1;

  static std::optional<HeatExchange> exchange_of(const Heat& heat) {
    if constexpr (exchanges_heat) {
      validate(heat);
      return heat;
    } else {
      return std::nullopt;
    }
  }
  Eigen::Index count() const { return particles_.particles().size(); }
  Eigen::Index temperatures() const { return has_temperatures ? count() : 0; }
  double volume() const {
    double all = 1.0;
    for (int a = 0; a < Dim; ++a) all *= flow_.grid().h(a);
    return all;
  }
  // What is shorter would be read beyond its end.
  void require_size(Eigen::Index r, Eigen::Index v, Eigen::Index y) const {
    const Eigen::Index values = flow_.size() + temperatures();
    if (r != 3 * count() || v != r || y != values) detail::refuse_size(r, v, y, count(), values);
  }
  void require_size(const schemes::State& at) const { require_size(at.r.size(), at.v.size(), at.y.size()); }
  const FromFluid& law() const { return particles_.template law<FromFluid>(); }
  // Reads the fluid that was measured last. What a step gave is then no longer known.
  bool look(schemes::In r) const {
    solved_t_ = std::numeric_limits<double>::quiet_NaN();
    if (!hats_.place(r)) return false;
    flow_.gather(hats_, exchange_.around);
    return true;
  }
  // Some of what the particles got, from the number `first` on, added to columns from momentum or energy on.
  void spread(int first, int numbers, double scale, schemes::Out to) const {
    if (count() == 0) return;
    hats_.spread(exchange_.given().data() + first, Dim + 1, numbers, scale,
                 to.data() + (1 + first) * flow_.grid().size());
  }
  void add_nothing() const {
    law().force.setZero(3 * count());
    law().heat.setZero(count());
  }
  bool solve_motion(const schemes::State& from, double dt, const schemes::State& seen, schemes::State& to) const {
    if (!flow_.measure(from.t + dt, seen.y.head(flow_.size())) || !look(seen.r)) return false;
    add_nothing();
    schemes::State own = of_particles(seen);
    own.t = from.t + dt;
    others_.resize(own.r.size());
    if (!particles_.total_force(own, others_)) return false;
    to.v = own.v;
    if (!exchange_.move(from, others_, dt, to.v, to.r)) return false;
    solved_t_ = from.t, solved_dt_ = dt, solved_v_ = from.v;
    return true;
  }
  bool solve_temperatures(const schemes::State& from, double dt, const schemes::State& seen, schemes::State& to) const {
    const Eigen::Index N = count();
    const Eigen::VectorXd before = from.y.tail(N);
    Eigen::VectorXd theta = seen.y.tail(N), other = Eigen::VectorXd::Zero(N);
    if constexpr (Particles::has_heat_flow) {
      add_nothing();
      if (!particles_.temperature_rates(from.t + dt, seen.r, seen.v, theta, other)) return false;
      other.array() *= particles().mass.array() * particles().heat_capacity.array();
    }
    if constexpr (exchanges_heat) {
      if (!exchange_.warm(before, other, dt, theta)) return false;
    } else {
      theta = before.array() + dt * other.array() / (particles().mass.array() * particles().heat_capacity.array());
    }
    to.y.tail(N) = theta;
    return theta.allFinite();
  }

  F flow_;
  Particles particles_;
  mutable Hats<Dim> hats_;
  mutable Exchange exchange_;
  mutable Eigen::VectorXd others_;
  // The step whose particles were solved last.
  mutable double solved_t_ = std::numeric_limits<double>::quiet_NaN(), solved_dt_ = 0.0;
  mutable Eigen::VectorXd solved_v_;
};

}  // namespace particulate::fluid
