#include <particulate/contact/hard_spheres.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <particulate/contact/detail/flight.hpp>
#include <particulate/kinematics/starts.hpp>

namespace particulate::contact::detail {

namespace {

// A flight within so many roundings of places and time is none.
constexpr double no_flight = 32.0;
// So many impacts without a flight in between, the last so much slower than the first, or within so many roundings of
// the velocities, are a collapse; so are very many in any case.
constexpr long collapsing = 5, endless = 100000;
constexpr double slower = 1e-8, slow = 1000.0;

// What impacts have left of a body.
struct Past {
  double last = -std::numeric_limits<double>::infinity();  // impact
  double elastic_until = last;                             // impacts before are
  double first_speed = 0.0;                                // of those without flight
  long without_flight = 0;                                 // impacts in a row
};

// A flight from impact to impact.
class Run {
 public:
  Run(const Gas& gas, schemes::State& state, double t_end, const CollisionRecorder& recorder, Tally& tally)
      : gas_(gas),
        recorder_(recorder),
        tally_(tally),
        state_(state),
        t_end_(t_end),
        past_(static_cast<std::size_t>(gas.particles.size())),
        flight_(gas, state, t_end) {
    for (Eigen::Index i = 0; i < state.y.size(); ++i) {
      if (state.y[i] > 0.0) past(i).elastic_until = state.y[i];
    }
  }

  schemes::Outcome go(double overlap) {
    outcome_.overlap = outcome_.overlap_at_start = overlap;
    try {
      const long renewal = std::max(64L, static_cast<long>(past_.size()));
      for (long events = 0; !flight_.has_ended() && outcome_.reason.empty();) {
        if (++events % renewal == 0) renew();
        const std::optional<Meeting> met = flight_.happen();
        if (!met) continue;
        collide(*met);
        part(*met);
        flight_.fly_on(*met);
      }
    } catch (...) {
      leave();
      throw;
    }
    if (outcome_.reason.empty()) flight_.end();
    leave();
    return outcome_;
  }

 private:
  Past& past(Eigen::Index i) { return past_[static_cast<std::size_t>(i)]; }
  Eigen::Vector3d relative(const Meeting& met) const {
    return flight_.body(met.i).velocity - flight_.body(met.j).velocity;
  }

  void renew() {
    const double by = flight_.renew();
    for (Past& past : past_) {
      past.last -= by;
      past.elastic_until -= by;
    }
  }

  void collide(const Meeting& met) {
    outcome_.overlap = std::max(outcome_.overlap, met.overlap);
    const Eigen::Vector3d before = relative(met);
    const double u = before.dot(met.n), noise = flight_.noise(met.i, met.j), now = flight_.now();
    if (!(u > noise)) return;
    const Eigen::Index i = flight_.number(met.i), j = met.j < 0 ? -1 : flight_.number(met.j);
    const bool elastic =
        gas_.contact_time > 0.0 && (now < past(i).elastic_until || (j >= 0 && now < past(j).elastic_until));
    const Impulse impulse = gas_.impulse(gas_.laws, flight_.body(met.i), flight_.body(met.j), met.n, elastic);
    const Eigen::Vector3d total = impulse.total(met.n);
    flight_.push(met, total);
    const Eigen::Vector3d after = relative(met);
    const double change = 0.5 * total.dot(before + after);
    ++outcome_.impacts;
    outcome_.energy_change += change;
    tally_.wall_impacts += met.wall >= 0 ? 1 : 0;
    tally_.elastic_impacts += elastic ? 1 : 0;
    const bool loses = -after.dot(met.n) < (1.0 - 1e-10) * u;
    const double nearly = no_flight * std::numeric_limits<double>::epsilon() * (flight_.extent(met.i, met.j) / u + now);
    book(i, u, nearly, loses, noise);
    if (j >= 0) book(j, u, nearly, loses, noise);
    if (!recorder_) return;
    const schemes::State moment = flight_.moment();
    recorder_({.t = moment.t,
               .t_carry = moment.t_carry,
               .i = i,
               .j = j,
               .wall = met.wall,
               .n = met.n,
               .impulse = impulse,
               .approach_speed = u,
               .energy_change = change,
               .elastic = elastic});
  }

  // Has a pair not approach, to the last bit: seen along r as whoever plans its next meeting sees it.
  void part(const Meeting& met) {
    const double m = 1.0 / (flight_.body(met.i).inverse_mass + flight_.body(met.j).inverse_mass);
    for (double more = 1.0; more < 1e6; more *= 2.0) {
      const double u = relative(met).dot(met.r) / met.r.norm();
      if (!(u > 0.0)) return;
      flight_.push(met, (-m * more * u) * met.n);
    }
  }

  // Books an impact of a body at speed u; nearly is a time that cannot be told from none.
  void book(Eigen::Index i, double u, double nearly, bool loses, double noise) {
    const double now = flight_.now();
    Past& one = past(i);
    const bool at_once = now - one.last <= nearly;
    if (!at_once) one.first_speed = u;
    one.without_flight = at_once ? one.without_flight + 1 : 0;
    one.last = now;
    one.elastic_until = now + gas_.contact_time;
    if (gas_.inverse_mass[i] == 0.0 || one.without_flight < collapsing) return;
    const bool collapses = loses && u <= std::max(slower * one.first_speed, slow * noise);
    if (collapses || one.without_flight >= endless) collapse(collapses, nearly);
  }
  void collapse(bool slows_down, double nearly) {
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < past_.size() && bodies.size() < 10; ++i) {
      if (past_[i].without_flight > 0 && flight_.now() - past_[i].last <= nearly) bodies.push_back(i);
    }
    outcome_.status = schemes::Status::failed;
    outcome_.failure = schemes::Failure::accumulating;
    outcome_.accumulation = flight_.moment().t;
    outcome_.reason = fmt::format(
        "particles {} meet {} by t = {} s{}: end the run before, or take a contact time t_c > 0, within which impacts "
        "that follow are elastic",
        fmt::join(bodies, ", "), slows_down ? "infinitely often" : "without end", outcome_.accumulation,
        slows_down ? ", ever more slowly: inelastic collapse" : ", held from opposite sides");
  }

  // Writes the state of now.
  void leave() {
    const bool reached = outcome_.reason.empty() && flight_.is_at_end();
    const schemes::State moment = flight_.moment();
    state_.t = reached ? t_end_ : moment.t;
    state_.t_carry = reached ? 0.0 : moment.t_carry;
    outcome_.t = state_.t;
    flight_.leave(state_);
    tally_.crossings = flight_.crossings;
    tally_.predictions = flight_.predictions;
    if (!(gas_.contact_time > 0.0)) return;
    state_.y.resize(gas_.particles.size());
    for (Eigen::Index i = 0; i < state_.y.size(); ++i) {
      state_.y[i] = std::max(0.0, past(i).elastic_until - flight_.now());
    }
  }

  const Gas& gas_;
  const CollisionRecorder& recorder_;
  Tally& tally_;
  schemes::State& state_;
  double t_end_;
  std::vector<Past> past_;
  Flight flight_;
  schemes::Outcome outcome_;
};

void validate_start(const Gas& gas, const schemes::State& state, double t_end) {
  const Eigen::Index N = gas.particles.size();
  if (state.r.size() != 3 * N || state.v.size() != 3 * N) {
    throw std::invalid_argument(fmt::format("hard spheres: r and v of {} particles must hold {} numbers, got {} and {}",
                                            N, 3 * N, state.r.size(), state.v.size()));
  }
  if (state.y.size() != 0 && !(gas.contact_time > 0.0 && state.y.size() == N)) {
    throw std::invalid_argument(
        fmt::format("hard spheres: y must be empty, or with a contact time hold its rest for each of {} particles, got "
                    "{} values",
                    N, state.y.size()));
  }
  if (!is_finite(state)) throw std::invalid_argument("hard spheres: the state must be finite");
  if (!(std::isfinite(t_end) && t_end >= state.t)) {
    throw std::invalid_argument(
        fmt::format("hard spheres: the end time must be finite and not before {} s, got {} s", state.t, t_end));
  }
  // Fourth powers of them stay numbers.
  constexpr double most = 1e70, least = 1e-70;
  const auto size = [](const auto& of) { return of.size() > 0 ? of.cwiseAbs().maxCoeff() : 0.0; };
  const double radius = size(gas.particles.radius), speed = size(state.v), place = std::max(size(state.r), radius);
  const auto is_small = [](double x) { return x > 0.0 && x < least; };
  if (place > most || speed > most || is_small(radius) || is_small(speed)) {
    throw std::invalid_argument(
        fmt::format("hard spheres: places and speeds must be at most {0:g} m and m/s, and the largest radius and speed "
                    "at least {1:g} m and m/s or 0, got {2:g} m, {3:g} m/s and a radius of {4:g} m: take other units",
                    most, least, place, speed, radius));
  }
}

}  // namespace

void validate(const Gas& gas) {
  kinematics::validate(gas.particles);
  kinematics::validate(gas.domain);
  validate_periods(gas.domain, gas.particles.radius);
  if (!(gas.contact_time >= 0.0 && std::isfinite(gas.contact_time))) {
    throw std::invalid_argument(
        fmt::format("hard spheres: contact_time must be finite and not negative, got {} s", gas.contact_time));
  }
}

schemes::Outcome advance(const Gas& gas, schemes::State& state, double t_end, const CollisionRecorder& recorder,
                         Tally& tally) {
  validate_start(gas, state, t_end);
  tally = {};
  kinematics::Particles now = gas.particles;
  now.position = positions(state);
  const double overlap = kinematics::validate_apart(now, gas.domain);
  return Run(gas, state, t_end, recorder, tally).go(overlap);
}

}  // namespace particulate::contact::detail
