#include <particulate/contact/located_contact.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/schemes/crossing.hpp>

namespace particulate::contact {

void validate_touching(double touching) {
  if (!(touching > 0.0 && touching <= 1e-3)) {
    throw std::invalid_argument(fmt::format("contact: touching must lie in (0, 1e-3], got {}", touching));
  }
}

namespace detail {

namespace {

// Two bodies that have met and will meet again and again.
struct Rest {
  Touch touch;
  double parting;  // speed after the impact [m/s]
  double rises;    // the widest gap before they meet again [m]
  double over;     // time at which all their impacts are over; infinite: they never are [s]
};

// The first contact whose bodies are pressed together again before they have parted by more than can be told from none.
std::optional<Rest> first_at_rest(const Touching& touching, const ClosedGap& gap, const laws::At<laws::Velocity>& at,
                                  const kinematics::VectorsIn& after, schemes::In force,
                                  const std::function<double(double)>& to_come) {
  constexpr double indistinct = 100.0, rounding = 1e-13;
  constexpr double indistinct_for_ever = 4.0;  // what accumulates nowhere goes on as long as it can be followed
  const Eigen::Map<const kinematics::Vectors> f(force.data(), at.mass.size(), 3);
  for (const Touch& touch : touching.contacts) {
    const double met = approach_speed(touch, at.velocity);
    const double pressed = touch.acceleration.dot(touch.n);
    double felt = at.inverse_mass[touch.i] * f.row(touch.i).norm();
    if (touch.j >= 0) felt += at.inverse_mass[touch.j] * f.row(touch.j).norm();
    if (!(met > 0.0 && pressed > rounding * felt)) continue;
    const double parting = std::max(0.0, -approach_speed(touch, after));
    const double rises = parting * parting / (2.0 * pressed);
    const double slack = gap.between(at.position, at.radius, touch.i, touch.j);
    if (rises > indistinct * slack) continue;
    const double flights = 2.0 * to_come(parting) / pressed;
    if (std::isinf(flights) && rises > indistinct_for_ever * slack) continue;
    return Rest{.touch = touch, .parting = parting, .rises = rises, .over = at.t + flights};
  }
  return {};
}

std::string comes_to_rest(const Rest& rest, double t) {
  const std::string who = rest.touch.j < 0 ? fmt::format("particle {} and a wall", rest.touch.i)
                                           : fmt::format("particles {} and {}", rest.touch.i, rest.touch.j);
  return fmt::format(
      "{} come to rest on each other: after their impact at t = {} s they part at {:.3g} m/s, the other forces press "
      "them together again before they are {:.3g} m apart, and their impacts {}; located contacts cannot hold what "
      "rests: end the run before, or take stepped contacts (Contact)",
      who, t, rest.parting, rest.rises,
      std::isinf(rest.over) ? std::string("go on for ever, ever smaller or as small as these")
                            : fmt::format("are over at t = {} s", rest.over));
}

// A gap that may close: between two spheres, or between one and a wall.
struct Gap {
  Eigen::Index i;
  Eigen::Index j;  // negative: the wall
  const kinematics::Wall* wall;
};

// All gaps along one step.
class Gaps {
 public:
  Gaps(const AnyDomain& domain, const Eigen::VectorXd& radius, const Eigen::VectorXd& inverse_mass,
       const schemes::StepPath& path, double end)
      : domain_(domain),
        radius_(radius),
        inverse_mass_(inverse_mass),
        path_(path),
        places_(schemes::chebyshev_points(path.intervals, end)),
        states_(places_.size()) {
    Eigen::VectorXd fastest = Eigen::VectorXd::Zero(radius.size());
    for (std::size_t k = 0; k < places_.size(); ++k) {
      path_(places_[k], states_[k]);
      fastest = fastest.cwiseMax(rows(states_[k].v).rowwise().norm());
    }
    // The samples are dense enough that no speed between them is sqrt(2) times as large.
    travel_ = std::sqrt(2.0) * end * path.dt * fastest;
  }

  // The first place at which one of them closes.
  std::optional<double> first_closing(const ClosedGap& tolerance, laws::Neighbours& neighbours) {
    std::optional<double> first;
    const Rows start = rows(states_[0].r);
    const auto look_at = [&](const Gap& gap) {
      const double slack = tolerance.between(start, radius_, gap.i, gap.j);
      if (!(width(gap, states_[0]) <= travel_[gap.i] + (gap.j >= 0 ? travel_[gap.j] : 0.0) + slack)) return;
      const std::optional<double> closes = closing(gap, slack);
      if (closes && !(first && *first <= *closes)) first = closes;
    };
    laws::Candidates pairs{radius_.size(), nullptr, nullptr};
    if (domain_.space) {
      const Eigen::VectorXd size = radius_ + travel_ + tolerance.shares(start, radius_);
      pairs = neighbours.candidates(*domain_.space, start, size);
    }
    for (Eigen::Index i = 0; i < radius_.size(); ++i) {
      pairs.behind(i, [&](Eigen::Index j) {
        const bool points = radius_[i] + radius_[j] == 0.0;
        if (!points && (inverse_mass_[i] > 0.0 || inverse_mass_[j] > 0.0)) look_at({.i = i, .j = j, .wall = nullptr});
      });
      if (!(inverse_mass_[i] > 0.0)) continue;
      for (const kinematics::Wall& wall : domain_.planes) look_at({.i = i, .j = -1, .wall = &wall});
    }
    return first;
  }

 private:
  using Rows = Eigen::Map<const kinematics::Vectors>;
  static Rows rows(const Eigen::VectorXd& flat) { return {flat.data(), flat.size() / 3, 3}; }

  double width(const Gap& gap, const schemes::State& there) const {
    const Rows r = rows(there.r);
    if (gap.wall) return kinematics::height_above(*gap.wall, r.row(gap.i).transpose()) - radius_[gap.i];
    return kinematics::length(domain_.between(domain_.self, r.row(gap.i).transpose(), r.row(gap.j).transpose())) -
           (radius_[gap.i] + radius_[gap.j]);
  }

  // Its derivative by theta.
  double opening(const Gap& gap, const schemes::State& there) const {
    const Rows r = rows(there.r), v = rows(there.v);
    const Eigen::Vector3d v_i = v.row(gap.i);
    if (gap.wall) return path_.dt * v_i.dot(gap.wall->normal);
    const Eigen::Vector3d towards = domain_.between(domain_.self, r.row(gap.i).transpose(), r.row(gap.j).transpose());
    const Eigen::Vector3d v_j = v.row(gap.j);
    return path_.dt * (v_j - v_i).dot(towards.stableNormalized());
  }

  std::optional<double> closing(const Gap& gap, double slack) {
    std::vector<schemes::Sample> samples;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      samples.push_back({.theta = places_[k], .value = width(gap, states_[k]), .slope = opening(gap, states_[k])});
    }
    if (!may_close(samples, slack)) return {};
    const schemes::Along along{.value =
                                   [&](double theta) {
                                     path_(theta, there_);
                                     return width(gap, there_);
                                   },
                               .slope =
                                   [&](double theta) {
                                     path_(theta, there_);
                                     return opening(gap, there_);
                                   }};
    // What dense output only brings near a touch is solved anew to see.
    const double reach = radius_[gap.i] + (gap.wall ? 0.0 : radius_[gap.j]);
    const double at_start = samples.front().value;
    // Touching bodies meet again where they come closer by the tolerance, and once they have parted, where they touch.
    const schemes::ZeroRules rules{.direction = schemes::Direction::falling,
                                   .leave = slack,
                                   .graze = slack,
                                   .doubt = 1e-4 * reach,
                                   .floor = std::min(at_start, 0.0) - slack};
    int side = at_start > slack ? 1 : 0;
    const std::optional<schemes::Crossing> found = schemes::first_crossing(samples, along, rules, side);
    return found ? std::optional(found->theta) : std::nullopt;
  }

  // The gap between two paths is convex but for what forces bend them: two of its tangents meet below it. Where they
  // meet above a quarter of its smaller end it stays open.
  static bool may_close(const std::vector<schemes::Sample>& samples, double slack) {
    for (std::size_t k = 1; k < samples.size(); ++k) {
      const schemes::Sample &a = samples[k - 1], &b = samples[k];
      const double smaller = std::min(a.value, b.value);
      if (smaller <= slack) return true;
      if (!(a.slope < 0.0 && b.slope > 0.0)) continue;
      const double meet = (b.value - a.value - b.slope * (b.theta - a.theta)) / (a.slope - b.slope);
      if (a.value + a.slope * meet < 0.25 * smaller) return true;
    }
    return false;
  }

  const AnyDomain& domain_;
  const Eigen::VectorXd& radius_;
  const Eigen::VectorXd& inverse_mass_;
  const schemes::StepPath& path_;
  std::vector<double> places_;
  std::vector<schemes::State> states_;
  Eigen::VectorXd travel_;  // the farthest that each body can get within the step [m]
  schemes::State there_;
};

}  // namespace

std::optional<double> first_closing(const AnyDomain& domain, const ClosedGap& tolerance, const Eigen::VectorXd& radius,
                                    const Eigen::VectorXd& inverse_mass, laws::Neighbours& neighbours,
                                    const schemes::StepPath& path, double end) {
  return Gaps(domain, radius, inverse_mass, path, end).first_closing(tolerance, neighbours);
}

void tell_rest(const Touching& touching, const ClosedGap& gap, const laws::At<laws::Velocity>& at, schemes::In after,
               schemes::In force, const std::function<double(double)>& to_come, schemes::Jump& jump) {
  const Eigen::Map<const kinematics::Vectors> parting(after.data(), at.mass.size(), 3);
  const std::optional<Rest> rest = first_at_rest(touching, gap, at, parting, force, to_come);
  if (!rest) return;
  jump.unsettled = comes_to_rest(*rest, at.t);
  if (std::isfinite(rest->over)) jump.accumulates = rest->over;
}

}  // namespace detail

}  // namespace particulate::contact
