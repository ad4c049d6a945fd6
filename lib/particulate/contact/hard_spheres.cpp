#include <particulate/contact/hard_spheres.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/detail/event_queue.hpp>
#include <particulate/contact/detail/moving_cells.hpp>

namespace particulate::contact::detail {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double rounding_unit = std::numeric_limits<double>::epsilon();
// An approach within so many roundings of the velocities is none.
constexpr double still = 4.0;
// It may come closer by so many roundings of the places before it is stopped.
constexpr double closer = 8.0;
// A flight within so many roundings of places and time is none.
constexpr double no_flight = 32.0;
// So many impacts without a flight in between, the last so much slower than the first, or within so many roundings of
// the velocities, are a collapse; so are very many in any case.
constexpr long collapsing = 5, endless = 100000;
constexpr double slower = 1e-8, slow = 1000.0;

constexpr std::int32_t nobody = -1;
constexpr std::int32_t first_wall = -2;  // and the next one is -3

// What a pair is tested by: one line of the cache.
struct alignas(64) Sphere {
  Eigen::Vector3d r, v;
  double t, b;  // of r; radius
};

// What a body will do next.
struct Plan {
  double meets = never;
  std::int32_t partner = nobody;
  std::uint32_t impacts = 0;                        // of the partner, when it was planned: one more, and it is off
  Eigen::Vector3d image = Eigen::Vector3d::Zero();  // periods between the two, of places that are not wrapped
  double leaves = never;                            // its cell
  Eigen::Index axis = 0;
  double next() const { return std::min(meets, leaves); }
};

struct Past {
  std::uint32_t impacts = 0;
  double last = -never;                               // impact
  double elastic_until = -never;                      // impacts before are
  long without_flight = 0;                            // impacts in a row
  double first_speed = 0.0;                           // of the first of them
  Eigen::Vector3d periods = Eigen::Vector3d::Zero();  // by which its place was wrapped
};

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

class Flight {
 public:
  Flight(const Gas& gas, const schemes::State& state, double t_end, const CollisionRecorder& recorder, Tally& tally)
      : gas_(gas),
        recorder_(recorder),
        tally_(tally),
        N_(static_cast<std::int32_t>(gas.particles.size())),
        lengths_(gas.domain.lengths.unaryExpr([](double L) { return std::isfinite(L) ? L : 0.0; })),
        t_end_(t_end),
        spheres_(at(N_)),
        plans_(at(N_)),
        past_(at(N_)),
        queue_(N_) {
    epoch_.t = state.t;
    epoch_.t_carry = state.t_carry;
    end_ = left();
    const schemes::VectorsOf r = positions(state), v = velocities(state);
    for (std::int32_t i = 0; i < N_; ++i) {
      Past& past = past_[at(i)];
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (lengths_[k] > 0.0) past.periods[k] = std::floor(r(i, k) / lengths_[k]);
      }
      const Eigen::Vector3d here = r.row(i).transpose() - past.periods.cwiseProduct(lengths_);
      spheres_[at(i)] = {.r = here, .v = v.row(i), .t = 0.0, .b = gas.particles.radius[i]};
      if (state.y.size() > 0 && state.y[i] > 0.0) past.elastic_until = state.y[i];
    }
    if (N_ > 1) sort();
  }

  void refuse_overlap(const schemes::State& state) {
    const ClosedGap rounding{.relative = 1e-12, .roundings = 32.0};
    const schemes::VectorsOf r = positions(state);
    Touch deepest;
    std::int32_t wall = nobody;
    const auto look_at = [&](Eigen::Index i, Eigen::Index j, double depth, std::int32_t of) {
      outcome_.overlap = std::max(outcome_.overlap, depth);
      if (depth <= rounding.between(r, gas_.particles.radius, i, j) || depth <= deepest.overlap) return;
      deepest = {.i = i, .j = j, .overlap = depth};
      wall = of;
    };
    for (std::int32_t i = 0; i < N_; ++i) {
      for (std::int32_t k = 0; gas_.inverse_mass[i] > 0.0 && k < walls(); ++k) look_at(i, -1, -height(i, k), k);
      if (!cells_) continue;
      cells_->near(i, [&](std::int32_t j, const Eigen::Vector3d& image) {
        const double reach = spheres_[at(i)].b + spheres_[at(j)].b;
        if (j <= i || reach == 0.0 || !can_meet(i, j)) return;
        look_at(i, j, reach - kinematics::length(towards(i, j, image)), nobody);
      });
    }
    outcome_.overlap_at_start = outcome_.overlap;
    if (deepest.overlap == 0.0) return;
    const std::string who = wall < 0 ? fmt::format("particles {} and {}", deepest.i, deepest.j)
                                     : fmt::format("particle {} and wall {}", deepest.i, wall);
    throw std::invalid_argument(fmt::format(
        "hard spheres must not overlap at the start, but {} do by {:.6g} m: move them apart, or take stepped contacts "
        "(Contact)",
        who, deepest.overlap));
  }

  schemes::Outcome run(schemes::State& state) {
    plan_all();
    try {
      const std::int64_t renewal = std::max<std::int64_t>(64, N_);
      for (std::int64_t events = 0; N_ > 0 && queue_.first_time() <= end_ && outcome_.reason.empty();) {
        if (++events % renewal == 0) renew();
        now_ = std::max(now_, queue_.first_time());
        happen(queue_.first());
      }
    } catch (...) {
      leave(state);
      throw;
    }
    if (outcome_.reason.empty()) now_ = end_;
    leave(state);
    return outcome_;
  }

 private:
  std::int32_t walls() const { return static_cast<std::int32_t>(gas_.domain.walls.size()); }
  const kinematics::Wall& wall(std::int32_t k) const { return gas_.domain.walls[at(k)]; }
  bool can_meet(std::int32_t i, std::int32_t j) const {
    return gas_.inverse_mass[i] > 0.0 || gas_.inverse_mass[j] > 0.0;
  }
  double left() const { return (t_end_ - epoch_.t) - epoch_.t_carry; }

  Eigen::Vector3d place(const Sphere& of) const { return of.r + (now_ - of.t) * of.v; }
  // From i to an image of j: the same bits, with the other sign, from j to i.
  Eigen::Vector3d towards(std::int32_t i, std::int32_t j, const Eigen::Vector3d& image) const {
    return (place(spheres_[at(j)]) - place(spheres_[at(i)])) + image.cwiseProduct(lengths_);
  }
  double height(std::int32_t i, std::int32_t k) const {
    return kinematics::height_above(wall(k), place(spheres_[at(i)])) - spheres_[at(i)].b;
  }
  // Size of the places that a gap is the difference of.
  double extent(std::int32_t i, std::int32_t j) const {
    const double own = place(spheres_[at(i)]).lpNorm<Eigen::Infinity>() + spheres_[at(i)].b;
    return j < 0 ? own : own + place(spheres_[at(j)]).lpNorm<Eigen::Infinity>() + spheres_[at(j)].b;
  }
  double noise(std::int32_t i, std::int32_t j) const {
    return still * rounding_unit * (spheres_[at(i)].v.norm() + (j < 0 ? 0.0 : spheres_[at(j)].v.norm()));
  }
  // When two that touch meet, if they approach at speed u.
  double touching(std::int32_t i, std::int32_t j, double u) const {
    return u > noise(i, j) ? now_ : now_ + closer * rounding_unit * extent(i, j) / u;
  }

  std::pair<std::int32_t, std::int32_t> numbers(std::int32_t i) const {
    const Plan& plan = plans_[at(i)];
    if (plan.leaves < plan.meets) return {i, std::numeric_limits<std::int32_t>::max()};
    if (plan.partner >= 0) return std::minmax({i, plan.partner});
    return {i, N_ + (first_wall - plan.partner)};
  }
  // Which of two events at one time comes first.
  auto ties() const {
    return [this](std::int32_t a, std::int32_t b) {
      const auto [a_low, a_high] = numbers(a);
      const auto [b_low, b_high] = numbers(b);
      return a_low != b_low ? a_low < b_low : a_high < b_high;
    };
  }

  // Sorts all bodies into cells; their places must be those of now.
  void sort() {
    kinematics::Vectors r(N_, 3);
    for (std::int32_t i = 0; i < N_; ++i) r.row(i) = spheres_[at(i)].r;
    Eigen::Vector3d wide;
    const double edge = cell_edge(gas_.domain, r, gas_.particles.radius, wide);
    if (cells_ && edge < 2.0 * edge_ && edge > 0.4 * edge_) return;
    edge_ = edge;
    cells_.emplace(gas_.domain, wide, edge, gas_.particles.radius);
    for (std::int32_t i = 0; i < N_; ++i) cells_->insert(i, spheres_[at(i)].r);
    for (Plan& plan : plans_) plan.leaves = -never;
  }

  // Counts time from now on, so that no digit of what is to come is lost to what has been.
  void renew() {
    for (std::int32_t i = 0; i < N_; ++i) {
      bring(i);
      spheres_[at(i)].t = 0.0;
      plans_[at(i)].meets -= now_;
      plans_[at(i)].leaves -= now_;
      past_[at(i)].last -= now_;
      past_[at(i)].elastic_until -= now_;
    }
    advance_time(schemes::State(epoch_), now_, epoch_);
    end_ = left();
    now_ = 0.0;
    if (!lengths_.all() && cells_) sort();
    if (cells_ && plans_.front().leaves == -never) {
      plan_all();
    } else {
      fill_queue();
    }
  }
  void plan_all() {
    for (std::int32_t i = 0; i < N_; ++i) {
      plan_meeting(i);
      plan_leaving(i);
    }
    fill_queue();
  }
  void fill_queue() {
    queue_.fill([&](std::int32_t i) { return plans_[at(i)].next(); }, ties());
  }
  void enqueue(std::int32_t i) { queue_.update(i, plans_[at(i)].next(), ties()); }
  void bring(std::int32_t i) {
    Sphere& one = spheres_[at(i)];
    one.r = place(one);
    one.t = now_;
  }

  void plan_meeting(std::int32_t i) {
    Plan& plan = plans_[at(i)];
    plan.meets = never;
    plan.partner = nobody;
    if (gas_.inverse_mass[i] > 0.0) {
      for (std::int32_t k = 0; k < walls(); ++k) plan_wall(i, k, plan);
    }
    if (!cells_) return;
    ++tally_.predictions;
    const Eigen::Vector3d here = place(spheres_[at(i)]);
    cells_->near(i, [&](std::int32_t j, const Eigen::Vector3d& image) { plan_pair(i, here, j, image, plan); });
  }
  void plan_wall(std::int32_t i, std::int32_t k, Plan& plan) const {
    const double u = -spheres_[at(i)].v.dot(wall(k).normal);
    if (!(u > 0.0)) return;
    const double gap = height(i, k);
    const double t = gap > 0.0 ? now_ + gap / u : touching(i, -1, u);
    if (t < plan.meets) {
      plan.meets = t;
      plan.partner = first_wall - k;
    }
  }
  void plan_pair(std::int32_t i, const Eigen::Vector3d& here, std::int32_t j, const Eigen::Vector3d& image,
                 Plan& plan) const {
    const Sphere &a = spheres_[at(i)], &b = spheres_[at(j)];
    const Eigen::Vector3d r = (place(b) - here) + image.cwiseProduct(lengths_), v = b.v - a.v;
    const double beta = r.dot(v), reach = a.b + b.b;
    if (!(beta < 0.0) || j == i) return;
    const double c = r.squaredNorm() - reach * reach;
    double t = now_;
    if (c > 0.0) {
      const double root = beta * beta - v.squaredNorm() * c;
      if (!(root >= 0.0)) return;
      t += c / (std::sqrt(root) - beta);
    } else {
      t = touching(i, j, -beta / r.norm());
    }
    const bool later = t > plan.meets || (t == plan.meets && plan.partner >= 0 && j > plan.partner);
    if (later || reach == 0.0 || !can_meet(i, j)) return;
    plan.meets = t;
    plan.partner = j;
    plan.impacts = past_[at(j)].impacts;
    plan.image = image - past_[at(j)].periods + past_[at(i)].periods;
  }
  void plan_leaving(std::int32_t i) {
    Plan& plan = plans_[at(i)];
    plan.leaves = never;
    if (!cells_) return;
    const Sphere& one = spheres_[at(i)];
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (one.v[k] == 0.0) continue;
      const double edge = one.v[k] > 0.0 ? cells_->high(i, k) : cells_->low(i, k);
      const double t = std::max(now_, one.t + (edge - one.r[k]) / one.v[k]);
      if (t < plan.leaves) {
        plan.leaves = t;
        plan.axis = k;
      }
    }
  }

  void happen(std::int32_t i) {
    const Plan plan = plans_[at(i)];
    if (plan.leaves < plan.meets) {
      cross(i, plan.axis);
    } else if (plan.partner >= 0 && past_[at(plan.partner)].impacts != plan.impacts) {
      plan_meeting(i);
    } else {
      meet(i, plan);
      if (plan.partner >= 0) plan_again(plan.partner);
      plan_again(i);
      return;
    }
    enqueue(i);
  }
  void cross(std::int32_t i, Eigen::Index axis) {
    ++tally_.crossings;
    Sphere& one = spheres_[at(i)];
    const bool upwards = one.v[axis] > 0.0;
    const double periods = cells_->cross(i, axis, upwards);
    one.r[axis] += periods * lengths_[axis];
    past_[at(i)].periods[axis] -= periods;
    const Eigen::Vector3d here = place(one);
    Plan& plan = plans_[at(i)];
    cells_->news(i, axis, upwards,
                 [&](std::int32_t j, const Eigen::Vector3d& image) { plan_pair(i, here, j, image, plan); });
    plan_leaving(i);
  }

  // What body i does at the time of its plan: it meets a body or a wall.
  void meet(std::int32_t i, const Plan& plan) {
    Touch touch{.i = i, .j = plan.partner >= 0 ? plan.partner : -1};
    bring(i);
    if (plan.partner >= 0) {
      bring(plan.partner);
      if (plan.partner < i) std::swap(touch.i, touch.j);
      const Past &a = past_[at(i)], &b = past_[at(plan.partner)];
      const Eigen::Vector3d image = plan.image + b.periods - a.periods;
      const auto low = static_cast<std::int32_t>(touch.i), high = static_cast<std::int32_t>(touch.j);
      const Eigen::Vector3d r = towards(low, high, plan.partner < i ? Eigen::Vector3d(-image) : image);
      const double d = kinematics::length(r);
      touch.n = r / d;
      touch.overlap = spheres_[at(low)].b + spheres_[at(high)].b - d;
      collide(touch, nobody);
      part(touch, r);
    } else {
      const std::int32_t k = first_wall - plan.partner;
      touch.n = -wall(k).normal;
      touch.overlap = -height(i, k);
      collide(touch, k);
      part(touch, touch.n);
    }
  }
  void plan_again(std::int32_t i) {
    ++past_[at(i)].impacts;
    plan_meeting(i);
    plan_leaving(i);
    enqueue(i);
  }

  Body body(Eigen::Index i) const {
    return i < 0 ? Body{}
                 : Body{.velocity = spheres_[static_cast<std::size_t>(i)].v, .inverse_mass = gas_.inverse_mass[i]};
  }
  Eigen::Vector3d relative(const Touch& touch) const { return body(touch.i).velocity - body(touch.j).velocity; }
  void push(const Touch& touch, const Eigen::Vector3d& impulse) {
    spheres_[static_cast<std::size_t>(touch.i)].v += gas_.inverse_mass[touch.i] * impulse;
    if (touch.j >= 0) spheres_[static_cast<std::size_t>(touch.j)].v -= gas_.inverse_mass[touch.j] * impulse;
  }

  void collide(const Touch& touch, std::int32_t wall) {
    outcome_.overlap = std::max(outcome_.overlap, touch.overlap);
    const auto i = static_cast<std::int32_t>(touch.i), j = static_cast<std::int32_t>(touch.j);
    const Eigen::Vector3d before = relative(touch);
    const double u = before.dot(touch.n), noise_now = noise(i, j);
    if (!(u > noise_now)) return;
    const bool elastic =
        gas_.contact_time > 0.0 && (now_ < past_[at(i)].elastic_until || (j >= 0 && now_ < past_[at(j)].elastic_until));
    const Impulse impulse = gas_.impulse(gas_.laws, body(i), body(j), touch.n, elastic);
    const Eigen::Vector3d total = impulse.total(touch.n);
    push(touch, total);
    const Eigen::Vector3d after = relative(touch);
    const double change = 0.5 * total.dot(before + after);
    ++outcome_.impacts;
    outcome_.energy_change += change;
    tally_.wall_impacts += wall >= 0 ? 1 : 0;
    tally_.elastic_impacts += elastic ? 1 : 0;
    const bool loses = -after.dot(touch.n) < (1.0 - 1e-10) * u;
    const double nearly = no_flight * rounding_unit * (extent(i, j) / u + now_);
    note(i, u, nearly, loses, noise_now);
    if (j >= 0) note(j, u, nearly, loses, noise_now);
    if (!recorder_) return;
    schemes::State moment;
    advance_time(epoch_, now_, moment);
    recorder_({.t = moment.t,
               .t_carry = moment.t_carry,
               .i = i,
               .j = j,
               .wall = wall,
               .n = touch.n,
               .impulse = impulse,
               .approach_speed = u,
               .energy_change = change,
               .elastic = elastic});
  }

  // Has a pair not approach, to the last bit: seen along r as whoever plans its next meeting sees it.
  void part(const Touch& touch, const Eigen::Vector3d& r) {
    const double m = 1.0 / (body(touch.i).inverse_mass + body(touch.j).inverse_mass);
    for (double more = 1.0; more < 1e6; more *= 2.0) {
      const double u = relative(touch).dot(r) / r.norm();
      if (!(u > 0.0)) return;
      push(touch, (-m * more * u) * touch.n);
    }
  }

  // Books an impact of a body at speed u; nearly is a time that cannot be told from none.
  void note(std::int32_t i, double u, double nearly, bool loses, double noise_now) {
    Past& past = past_[at(i)];
    const bool at_once = now_ - past.last <= nearly;
    if (!at_once) past.first_speed = u;
    past.without_flight = at_once ? past.without_flight + 1 : 0;
    past.last = now_;
    past.elastic_until = now_ + gas_.contact_time;
    if (gas_.inverse_mass[i] == 0.0 || past.without_flight < collapsing) return;
    const bool collapses = loses && u <= std::max(slower * past.first_speed, slow * noise_now);
    if (collapses || past.without_flight >= endless) collapse(collapses, nearly);
  }
  void collapse(bool slows_down, double nearly) {
    std::vector<std::int32_t> bodies;
    for (std::int32_t i = 0; i < N_; ++i) {
      if (past_[at(i)].without_flight > 0 && now_ - past_[at(i)].last <= nearly && bodies.size() < 10)
        bodies.push_back(i);
    }
    schemes::State moment;
    advance_time(epoch_, now_, moment);
    outcome_.status = schemes::Status::failed;
    outcome_.failure = schemes::Failure::accumulating;
    outcome_.accumulation = moment.t;
    outcome_.reason = fmt::format(
        "particles {} meet {} by t = {} s{}: end the run before, or take a contact time t_c > 0, within which impacts "
        "that follow are elastic",
        fmt::join(bodies, ", "), slows_down ? "infinitely often" : "without end", moment.t,
        slows_down ? ", ever more slowly: inelastic collapse" : ", held from opposite sides");
  }

  // Writes the state of now.
  void leave(schemes::State& state) {
    schemes::State moment;
    advance_time(epoch_, now_, moment);
    const bool reached = outcome_.reason.empty() && now_ == end_;
    state.t = reached ? t_end_ : moment.t;
    state.t_carry = reached ? 0.0 : moment.t_carry;
    outcome_.t = state.t;
    schemes::MutableVectorsOf r = positions(state), v = velocities(state);
    if (gas_.contact_time > 0.0) state.y.setZero(N_);
    for (std::int32_t i = 0; i < N_; ++i) {
      bring(i);
      const Past& past = past_[at(i)];
      r.row(i) = spheres_[at(i)].r + past.periods.cwiseProduct(lengths_);
      v.row(i) = spheres_[at(i)].v;
      if (gas_.contact_time > 0.0) state.y[i] = std::max(0.0, past.elastic_until - now_);
    }
  }

  const Gas& gas_;
  const CollisionRecorder& recorder_;
  Tally& tally_;
  std::int32_t N_;
  Eigen::Vector3d lengths_;  // periods; 0: there is none
  double t_end_, end_ = 0.0, now_ = 0.0;
  schemes::State epoch_;  // from which now_ counts
  std::vector<Sphere> spheres_;
  std::vector<Plan> plans_;
  std::vector<Past> past_;
  EventQueue queue_;
  std::optional<MovingCells> cells_;  // none: no two bodies
  double edge_ = 0.0;
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
  Flight flight(gas, state, t_end, recorder, tally);
  flight.refuse_overlap(state);
  return flight.run(state);
}

}  // namespace particulate::contact::detail
