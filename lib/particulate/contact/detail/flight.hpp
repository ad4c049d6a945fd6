#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <particulate/contact/detail/event_queue.hpp>
#include <particulate/contact/detail/moving_cells.hpp>
#include <particulate/contact/hard_spheres.hpp>

namespace particulate::contact::detail {

// Two that meet, the number of i the lower one, or a body and a wall. Bodies are named by their places in memory.
struct Meeting {
  std::int32_t i, j = -1, wall = -1;  // one of the last two is negative
  Eigen::Vector3d r, n;               // along r approaches are seen; unit vector
  double overlap;
};

// The free flight of hard spheres: who meets whom, and when. Bodies are kept in an order in which those near each other
// are so in memory, which changes nothing that is told: at one time the lower number comes first.
class Flight {
 public:
  Flight(const Gas& gas, const schemes::State& state, double t_end)
      : gas_(gas),
        N_(static_cast<std::int32_t>(gas.particles.size())),
        lengths_(gas.domain.lengths.unaryExpr([](double L) { return std::isfinite(L) ? L : 0.0; })),
        t_end_(t_end),
        queue_(N_) {
    epoch_.t = state.t;
    epoch_.t_carry = state.t_carry;
    end_ = (t_end - epoch_.t) - epoch_.t_carry;
    const schemes::VectorsOf r = positions(state), v = velocities(state);
    for (std::int32_t i = 0; i < N_; ++i) {
      Eigen::Vector3d periods = Eigen::Vector3d::Zero();
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (lengths_[k] > 0.0) periods[k] = std::floor(r(i, k) / lengths_[k]);
      }
      const Eigen::Vector3d here = r.row(i).transpose() - periods.cwiseProduct(lengths_);
      spheres_.push_back({.r = here, .v = v.row(i), .t = 0.0, .b = gas.particles.radius[i]});
      plans_.push_back({.number = i});
      periods_.push_back(periods);
    }
    sort();
    plan_all();
  }

  bool has_ended() const { return N_ == 0 || queue_.first_time() > end_; }
  // Lets the next event happen: if two meet, the caller has them part, and flies on with both.
  std::optional<Meeting> happen() {
    now_ = std::max(now_, queue_.first_time());
    const std::int32_t i = queue_.first();
    const Plan& plan = plans_[at(i)];
    for (const std::int32_t k : queue_.soon()) {
      if (k < 0 || k == i) continue;
      __builtin_prefetch(&spheres_[at(k)]);
      __builtin_prefetch(&plans_[at(k)]);
      if (cells_) __builtin_prefetch(cells_->where(k));
    }
    if (plan.leaves < plan.meets) {
      cross(i);
    } else if (plan.partner >= 0 && plans_[at(plan.partner)].own_impacts != plan.impacts) {
      plan_meeting(i);
    } else {
      return meeting(i);
    }
    enqueue(i);
    return std::nullopt;
  }
  // The partner first: what it plans with i is off as soon as i has its turn.
  void fly_on(const Meeting& after) {
    const std::int32_t i = queue_.first();
    if (after.j >= 0) plan_again(i == after.i ? after.j : after.i);
    plan_again(i);
  }
  // Counts time from now on, so that no digit of what is to come is lost to what has been: returns what now was.
  double renew() {
    const double before = now_;
    for (std::int32_t i = 0; i < N_; ++i) {
      bring(i);
      spheres_[at(i)].t = 0.0;
      plans_[at(i)].meets -= before;
      plans_[at(i)].leaves -= before;
    }
    advance_time(schemes::State(epoch_), before, epoch_);
    end_ = (t_end_ - epoch_.t) - epoch_.t_carry;
    now_ = 0.0;
    if (!lengths_.all()) sort();
    if (cells_ && plans_.front().leaves == -never) {
      plan_all();
    } else {
      if (cells_ && ++renewals_ % lined_up == 0) line_up();
      fill_queue();
    }
    return before;
  }
  void end() { now_ = end_; }

  double now() const { return now_; }
  bool is_at_end() const { return now_ == end_; }
  schemes::State moment() const {
    schemes::State moment;
    advance_time(epoch_, now_, moment);
    return moment;
  }
  std::int32_t number(std::int32_t i) const { return plans_[at(i)].number; }
  Body body(std::int32_t i) const {
    return i < 0 ? Body{} : Body{.velocity = spheres_[at(i)].v, .inverse_mass = gas_.inverse_mass[number(i)]};
  }
  void push(const Meeting& who, const Eigen::Vector3d& impulse) {
    spheres_[at(who.i)].v += gas_.inverse_mass[number(who.i)] * impulse;
    if (who.j >= 0) spheres_[at(who.j)].v -= gas_.inverse_mass[number(who.j)] * impulse;
  }
  // Size of the places that a gap is the difference of.
  double extent(std::int32_t i, std::int32_t j) const {
    const double own = place(spheres_[at(i)]).lpNorm<Eigen::Infinity>() + spheres_[at(i)].b;
    return j < 0 ? own : own + place(spheres_[at(j)]).lpNorm<Eigen::Infinity>() + spheres_[at(j)].b;
  }
  // An approach as fast is none.
  double noise(std::int32_t i, std::int32_t j) const {
    return still * rounding_unit * (spheres_[at(i)].v.norm() + (j < 0 ? 0.0 : spheres_[at(j)].v.norm()));
  }
  // Writes places and velocities of now.
  void leave(schemes::State& state) {
    schemes::MutableVectorsOf r = positions(state), v = velocities(state);
    for (std::int32_t i = 0; i < N_; ++i) {
      bring(i);
      r.row(number(i)) = spheres_[at(i)].r + periods_[at(i)].cwiseProduct(lengths_);
      v.row(number(i)) = spheres_[at(i)].v;
    }
  }

  long crossings = 0, predictions = 0;

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  static constexpr double rounding_unit = std::numeric_limits<double>::epsilon();
  // An approach within so many roundings of the velocities is none.
  static constexpr double still = 4.0;
  // It may come closer by so many roundings of the places before it is stopped.
  static constexpr double closer = 8.0;
  // Bodies are lined up anew after so many renewals of the time.
  static constexpr long lined_up = 16;

  static constexpr std::int32_t nobody = -1;
  static constexpr std::int32_t first_wall = -2;  // and the next one is -3

  // What a pair is tested by: one line of the cache.
  struct alignas(64) Sphere {
    Eigen::Vector3d r, v;
    double t, b;  // of r; radius
  };
  // What a body will do next.
  struct alignas(64) Plan {
    double meets = never, leaves = never;             // its cell
    Eigen::Vector3d image = Eigen::Vector3d::Zero();  // periods between the two, of places that are not wrapped
    std::int32_t partner = nobody;
    std::uint32_t impacts = 0;  // of the partner, when it was planned: one more, and it is off
    std::int32_t axis = 0;
    std::int32_t number = 0;        // of this body, for the user
    std::uint32_t own_impacts = 0;  // of this body
    double next() const { return std::min(meets, leaves); }
  };
  struct Candidate {
    std::int32_t j;
    Eigen::Vector3d image;
  };
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

  Eigen::Vector3d place(const Sphere& of) const { return of.r + (now_ - of.t) * of.v; }
  void note(std::int32_t j, const Eigen::Vector3d& image) {
    __builtin_prefetch(&spheres_[at(j)]);
    candidates_.push_back({j, image});
  }
  double height(std::int32_t i, std::int32_t k) const {
    return kinematics::height_above(gas_.domain.walls[at(k)], place(spheres_[at(i)])) - spheres_[at(i)].b;
  }
  bool can_meet(std::int32_t i, std::int32_t j) const {
    return gas_.particles.immovable.empty() || gas_.inverse_mass[number(i)] > 0.0 || gas_.inverse_mass[number(j)] > 0.0;
  }
  // When two that touch meet, if they approach at speed u.
  double touching(std::int32_t i, std::int32_t j, double u) const {
    return u > noise(i, j) ? now_ : now_ + closer * rounding_unit * extent(i, j) / u;
  }
  std::pair<std::int32_t, std::int32_t> numbers(std::int32_t i) const {
    const Plan& plan = plans_[at(i)];
    const std::int32_t own = number(i);
    if (plan.leaves < plan.meets) return {own, std::numeric_limits<std::int32_t>::max()};
    if (plan.partner >= 0) return std::minmax({own, number(plan.partner)});
    return {own, N_ + (first_wall - plan.partner)};
  }
  // Which of two events at one time comes first.
  bool is_first(std::int32_t a, std::int32_t b) const {
    const auto of_a = numbers(a), of_b = numbers(b);
    return of_a != of_b ? of_a < of_b : number(a) < number(b);
  }

  // Sorts all bodies into cells, anew only where they have flown far apart; their places must be those of now.
  void sort() {
    if (N_ < 2) return;
    kinematics::Vectors r(N_, 3);
    for (std::int32_t i = 0; i < N_; ++i) r.row(number(i)) = spheres_[at(i)].r;
    Eigen::Vector3d wide;
    const double edge = cell_edge(gas_.domain, r, gas_.particles.radius, wide);
    if (cells_ && edge < 2.0 * edge_ && edge > 0.4 * edge_) return;
    edge_ = edge;
    cells_.emplace(gas_.domain, wide, edge, gas_.particles.radius);
    for (const Sphere& one : spheres_) cells_->add(one.r, one.b);
    line_up();
    for (Plan& plan : plans_) plan.leaves = -never;
  }
  // Numbers bodies by the cells that they are in.
  void line_up() {
    const std::vector<std::int32_t> order = cells_->in_order();
    const auto permute = [&](auto& all) {
      const auto old = all;
      for (std::size_t k = 0; k < order.size(); ++k) all[k] = old[at(order[k])];
    };
    permute(spheres_);
    permute(plans_);
    permute(periods_);
    cells_->renumber(order);
    std::vector<std::int32_t> place_of(order.size());
    for (std::int32_t k = 0; k < N_; ++k) place_of[at(order[at(k)])] = k;
    for (Plan& plan : plans_) {
      if (plan.partner >= 0) plan.partner = place_of[at(plan.partner)];
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
    queue_.fill([&](std::int32_t i) { return plans_[at(i)].next(); },
                [this](std::int32_t a, std::int32_t b) { return is_first(a, b); });
  }
  void enqueue(std::int32_t i) {
    queue_.update(i, plans_[at(i)].next(), [this](std::int32_t a, std::int32_t b) { return is_first(a, b); });
  }
  void bring(std::int32_t i) {
    Sphere& one = spheres_[at(i)];
    one.r = place(one);
    one.t = now_;
  }
  void plan_again(std::int32_t i) {
    ++plans_[at(i)].own_impacts;
    plan_meeting(i);
    plan_leaving(i);
    enqueue(i);
  }
  void plan_meeting(std::int32_t i) {
    Plan& plan = plans_[at(i)];
    plan.meets = never;
    plan.partner = nobody;
    const auto walls = static_cast<std::int32_t>(gas_.domain.walls.size());
    if (walls > 0 && gas_.inverse_mass[number(i)] > 0.0) {
      for (std::int32_t k = 0; k < walls; ++k) plan_wall(i, k, plan);
    }
    if (!cells_) return;
    ++predictions;
    candidates_.clear();
    cells_->near(i, [&](std::int32_t j, const Eigen::Vector3d& image) { note(j, image); });
    plan_pairs(i);
  }
  void plan_wall(std::int32_t i, std::int32_t k, Plan& plan) const {
    const double u = -spheres_[at(i)].v.dot(gas_.domain.walls[at(k)].normal);
    if (!(u > 0.0)) return;
    const double gap = height(i, k);
    const double t = gap > 0.0 ? now_ + gap / u : touching(i, -1, u);
    if (t < plan.meets) {
      plan.meets = t;
      plan.partner = first_wall - k;
    }
  }
  // Of the candidates, the one that is met first, if before what is planned.
  void plan_pairs(std::int32_t i) {
    Plan& plan = plans_[at(i)];
    const Sphere a = spheres_[at(i)];
    const Eigen::Vector3d here = place(a);
    const Candidate* first = nullptr;
    for (const Candidate& candidate : candidates_) {
      const std::int32_t j = candidate.j;
      const Sphere& b = spheres_[at(j)];
      const Eigen::Vector3d r = (place(b) - here) + candidate.image.cwiseProduct(lengths_), v = b.v - a.v;
      const double beta = r.dot(v), reach = a.b + b.b;
      if (!(beta < 0.0) || j == i) continue;
      const double c = r.squaredNorm() - reach * reach;
      double t = now_;
      if (c > 0.0) {
        const double root = beta * beta - v.squaredNorm() * c;
        if (!(root >= 0.0)) continue;
        t += c / (std::sqrt(root) - beta);
      } else {
        t = touching(i, j, -beta / r.norm());
      }
      const bool later = t > plan.meets || (t == plan.meets && plan.partner >= 0 && number(j) > number(plan.partner));
      if (later || reach == 0.0 || !can_meet(i, j)) continue;
      plan.meets = t;
      plan.partner = j;
      first = &candidate;
    }
    if (!first) return;
    plan.impacts = plans_[at(first->j)].own_impacts;
    plan.image = first->image - periods_[at(first->j)] + periods_[at(i)];
  }
  void plan_leaving(std::int32_t i) {
    Plan& plan = plans_[at(i)];
    plan.leaves = never;
    if (!cells_) return;
    const Sphere& one = spheres_[at(i)];
    for (std::int32_t k = 0; k < 3; ++k) {
      if (one.v[k] == 0.0) continue;
      const double t = std::max(now_, one.t + (cells_->end(i, k, one.v[k] > 0.0) - one.r[k]) / one.v[k]);
      if (t < plan.leaves) {
        plan.leaves = t;
        plan.axis = k;
      }
    }
  }
  void cross(std::int32_t i) {
    ++crossings;
    Sphere& one = spheres_[at(i)];
    const std::int32_t axis = plans_[at(i)].axis;
    const bool upwards = one.v[axis] > 0.0;
    const double periods = cells_->cross(i, axis, upwards);
    if (periods != 0.0) {
      one.r[axis] += periods * lengths_[axis];
      periods_[at(i)][axis] -= periods;
    }
    candidates_.clear();
    cells_->news(i, axis, upwards, [&](std::int32_t j, const Eigen::Vector3d& image) { note(j, image); });
    plan_pairs(i);
    plan_leaving(i);
  }
  // What body i does at the time of its plan: it meets a body or a wall.
  Meeting meeting(std::int32_t i) {
    const Plan& plan = plans_[at(i)];
    bring(i);
    if (plan.partner < 0) {
      const std::int32_t k = first_wall - plan.partner;
      const Eigen::Vector3d n = -gas_.domain.walls[at(k)].normal;
      return {.i = i, .wall = k, .r = n, .n = n, .overlap = -height(i, k)};
    }
    bring(plan.partner);
    const bool first = number(i) < number(plan.partner);
    const std::int32_t low = first ? i : plan.partner, high = first ? plan.partner : i;
    const Eigen::Vector3d image = (first ? 1.0 : -1.0) * (plan.image + periods_[at(plan.partner)] - periods_[at(i)]);
    const Sphere &a = spheres_[at(low)], &b = spheres_[at(high)];
    const Eigen::Vector3d r = (b.r - a.r) + image.cwiseProduct(lengths_);
    const double d = kinematics::length(r);
    return {.i = low, .j = high, .r = r, .n = r / d, .overlap = a.b + b.b - d};
  }

  const Gas& gas_;
  std::int32_t N_;
  Eigen::Vector3d lengths_;  // periods; 0: there is none
  double end_ = 0.0, now_ = 0.0, edge_ = 0.0;
  schemes::State epoch_;  // from which now_ counts
  double t_end_;
  std::vector<Sphere> spheres_;
  std::vector<Plan> plans_;
  std::vector<Eigen::Vector3d> periods_;  // by which places were wrapped
  std::vector<Candidate> candidates_;
  EventQueue queue_;
  std::optional<MovingCells> cells_;  // none: no two bodies
  long renewals_ = 0;
};

}  // namespace particulate::contact::detail
