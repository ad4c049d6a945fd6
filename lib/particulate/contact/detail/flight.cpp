#include <particulate/contact/detail/flight.hpp>

#include <algorithm>
#include <cmath>

namespace particulate::contact::detail {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double rounding_unit = std::numeric_limits<double>::epsilon();
// An approach within so many roundings of the velocities is none.
constexpr double still = 4.0;
// It may come closer by so many roundings of the places before it is stopped.
constexpr double closer = 8.0;
// Bodies are lined up anew after so many renewals of the time.
constexpr long lined_up = 16;

constexpr std::int32_t nobody = -1;
constexpr std::int32_t first_wall = -2;  // and the next one is -3

}  // namespace

Flight::Flight(const Gas& gas, const schemes::State& state, double t_end)
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
    plans_.push_back({.meets = never, .leaves = never, .partner = nobody, .impacts = 0, .number = i});
    periods_.push_back(periods);
  }
  sort();
  plan_all();
}

double Flight::height(std::int32_t i, std::int32_t k) const {
  return kinematics::height_above(gas_.domain.walls[at(k)], place(spheres_[at(i)])) - spheres_[at(i)].b;
}
double Flight::extent(std::int32_t i, std::int32_t j) const {
  const double own = place(spheres_[at(i)]).lpNorm<Eigen::Infinity>() + spheres_[at(i)].b;
  return j < 0 ? own : own + place(spheres_[at(j)]).lpNorm<Eigen::Infinity>() + spheres_[at(j)].b;
}
double Flight::noise(std::int32_t i, std::int32_t j) const {
  return still * rounding_unit * (spheres_[at(i)].v.norm() + (j < 0 ? 0.0 : spheres_[at(j)].v.norm()));
}
// When two that touch meet, if they approach at speed u.
double Flight::touching(std::int32_t i, std::int32_t j, double u) const {
  return u > noise(i, j) ? now_ : now_ + closer * rounding_unit * extent(i, j) / u;
}

std::pair<std::int32_t, std::int32_t> Flight::numbers(std::int32_t i) const {
  const Plan& plan = plans_[at(i)];
  const std::int32_t own = number(i);
  if (plan.leaves < plan.meets) return {own, std::numeric_limits<std::int32_t>::max()};
  if (plan.partner >= 0) return std::minmax({own, number(plan.partner)});
  return {own, N_ + (first_wall - plan.partner)};
}
// Which of two events at one time comes first.
auto Flight::ties() const {
  return [this](std::int32_t a, std::int32_t b) {
    const auto of_a = numbers(a), of_b = numbers(b);
    return of_a != of_b ? of_a < of_b : number(a) < number(b);
  };
}

// Sorts all bodies into cells, anew only where they have flown far apart; their places must be those of now.
void Flight::sort() {
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
void Flight::line_up() {
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

double Flight::renew() {
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

void Flight::plan_all() {
  for (std::int32_t i = 0; i < N_; ++i) {
    plan_meeting(i);
    plan_leaving(i);
  }
  fill_queue();
}
void Flight::fill_queue() {
  queue_.fill([&](std::int32_t i) { return plans_[at(i)].next(); }, ties());
}
void Flight::bring(std::int32_t i) {
  Sphere& one = spheres_[at(i)];
  one.r = place(one);
  one.t = now_;
}

void Flight::plan_meeting(std::int32_t i) {
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
void Flight::plan_wall(std::int32_t i, std::int32_t k, Plan& plan) const {
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
void Flight::plan_pairs(std::int32_t i) {
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
void Flight::plan_leaving(std::int32_t i) {
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

std::optional<Meeting> Flight::happen() {
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
  queue_.update(i, plan.next(), ties());
  return std::nullopt;
}
void Flight::cross(std::int32_t i) {
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
Meeting Flight::meeting(std::int32_t i) {
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
// The partner first: what it plans with i is off as soon as i has its turn.
void Flight::fly_on(const Meeting& after) {
  const std::int32_t i = queue_.first();
  if (after.j >= 0) plan_again(i == after.i ? after.j : after.i);
  plan_again(i);
}
void Flight::plan_again(std::int32_t i) {
  ++plans_[at(i)].own_impacts;
  plan_meeting(i);
  plan_leaving(i);
  queue_.update(i, plans_[at(i)].next(), ties());
}

void Flight::push(const Meeting& who, const Eigen::Vector3d& impulse) {
  spheres_[at(who.i)].v += gas_.inverse_mass[number(who.i)] * impulse;
  if (who.j >= 0) spheres_[at(who.j)].v -= gas_.inverse_mass[number(who.j)] * impulse;
}

schemes::State Flight::moment() const {
  schemes::State moment;
  advance_time(epoch_, now_, moment);
  return moment;
}
void Flight::leave(schemes::State& state) {
  schemes::MutableVectorsOf r = positions(state), v = velocities(state);
  for (std::int32_t i = 0; i < N_; ++i) {
    bring(i);
    r.row(number(i)) = spheres_[at(i)].r + periods_[at(i)].cwiseProduct(lengths_);
    v.row(number(i)) = spheres_[at(i)].v;
  }
}

}  // namespace particulate::contact::detail
