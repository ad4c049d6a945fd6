#include <particulate/contact/resolution.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Dense>

namespace particulate::contact {

namespace {

// Approach speeds nearer to one another than this, relative to the fastest, are resolved together.
constexpr double tie = 1e-10;
// A pair approaches no more once it is this much slower than the fastest was at first: impacts then change no digit.
constexpr double rest = 1e-13;
// Nor does it where its approach is rounding of the velocities that it is the difference of.
constexpr double roundings = 4.0;

struct Motions {
  const Eigen::VectorXd& inverse_mass;
  kinematics::VectorsOut& velocity;

  Body body(Eigen::Index k) const {
    return k < 0 ? Body{} : Body{.velocity = kinematics::vector(velocity, k), .inverse_mass = inverse_mass[k]};
  }
  double approach(const Touch& touch) const { return relative(touch).dot(touch.n); }
  bool can_move(const Touch& touch) const {
    return inverse_mass[touch.i] > 0.0 || (touch.j >= 0 && inverse_mass[touch.j] > 0.0);
  }
  Eigen::Vector3d relative(const Touch& touch) const { return body(touch.i).velocity - body(touch.j).velocity; }
  void push(const Touch& touch, const Eigen::Vector3d& impulse) {
    velocity.row(touch.i) += inverse_mass[touch.i] * impulse.transpose();
    if (touch.j >= 0) velocity.row(touch.j) -= inverse_mass[touch.j] * impulse.transpose();
  }
};

External changes_of(const Touch& touch, double duration, double e) {
  return external_changes(touch.acceleration, Eigen::Vector3d::Zero(), phases(duration, e));
}

// One contact as the resolver sees it now; all zero: it does not act.
struct Meeting {
  double speed = 0.0;   // approach speed u
  double met = 0.0;     // u + Delta_1
  double wanted = 0.0;  // change of u that restitution asks for: (1 + e)(u + Delta_1)
};

template <class R, class F>
Meeting meeting_of(const ContactResolver<R, F>& law, const Motions& motions, const Touch& touch, double duration) {
  const double u = motions.approach(touch);
  if (!(u > 0.0) || !motions.can_move(touch)) return {};
  const double e = restitution_at(law.restitution, u);
  const double delta1 = changes_of(touch, duration, e).compression.dot(touch.n);
  constexpr double unit_mass = 1.0;  // the impulse on it is the change of speed that restitution asks for
  const double wanted = -normal_impulse(u, delta1, e, unit_mass);
  return wanted > 0.0 ? Meeting{.speed = u, .met = u + delta1, .wanted = wanted} : Meeting{};
}

template <class R, class F>
std::vector<Meeting> meetings_of(const ContactResolver<R, F>& law, const Motions& motions,
                                 const std::vector<Touch>& contacts, double duration) {
  std::vector<Meeting> meetings;
  meetings.reserve(contacts.size());
  for (const Touch& touch : contacts) meetings.push_back(meeting_of(law, motions, touch, duration));
  return meetings;
}

double fastest_met(const std::vector<Meeting>& meetings) {
  double fastest = 0.0;
  for (const Meeting& meeting : meetings) fastest = std::max(fastest, meeting.met);
  return fastest;
}

// The speed of approach below which nothing is left to resolve.
double speed_of_rest(const Motions& motions, const std::vector<Touch>& contacts, double fastest) {
  double largest = 0.0;
  for (const Touch& touch : contacts) {
    largest = std::max({largest, motions.body(touch.i).velocity.norm(), motions.body(touch.j).velocity.norm()});
  }
  return std::max(rest * fastest, roundings * std::numeric_limits<double>::epsilon() * largest);
}

// How the normal impulse of contact b changes the approach speed of contact a: the shared bodies carry it.
double coupling(const Touch& a, const Touch& b, const Eigen::VectorXd& inverse_mass) {
  const auto shared = [&](Eigen::Index p, Eigen::Index q) { return p >= 0 && p == q ? inverse_mass[p] : 0.0; };
  return a.n.dot(b.n) * (shared(a.i, b.i) + shared(a.j, b.j) - shared(a.i, b.j) - shared(a.j, b.i));
}

// W: inverse masses as the normals of a group see them.
Eigen::MatrixXd couplings(const std::vector<Touch>& group, const Eigen::VectorXd& inverse_mass) {
  const auto n = static_cast<Eigen::Index>(group.size());
  Eigen::MatrixXd W(n, n);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      W(a, b) = coupling(group[static_cast<std::size_t>(a)], group[static_cast<std::size_t>(b)], inverse_mass);
    }
  }
  return W;
}

// Pushes P >= 0 that make every contact of a group part as it should: W P = wanted, those that would pull left out.
// More contacts than the bodies can move in make W singular; W is scaled by its diagonal, so that unequal masses do not
// look like that.
Eigen::VectorXd group_pushes(const std::vector<Touch>& group, const Eigen::VectorXd& inverse_mass,
                             const Eigen::VectorXd& wanted) {
  const Eigen::MatrixXd W = couplings(group, inverse_mass);
  if (group.size() == 1) return (wanted / W(0, 0)).cwiseMax(0.0);
  const Eigen::VectorXd scale = W.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * W * scale.asDiagonal();
  const Eigen::VectorXd target = scale.cwiseProduct(wanted);
  std::vector<Eigen::Index> active(group.size());
  std::iota(active.begin(), active.end(), 0);
  Eigen::VectorXd pushes = Eigen::VectorXd::Zero(wanted.size());
  while (!active.empty()) {
    const Eigen::MatrixXd seen = scaled(active, active);
    const Eigen::VectorXd given = target(active);
    const Eigen::VectorXd P = seen.completeOrthogonalDecomposition().solve(given);
    const double pull = -1e-12 * P.cwiseAbs().maxCoeff();
    if (P.minCoeff() >= pull) {
      pushes(active) = P.cwiseMax(0.0);
      break;
    }
    std::vector<Eigen::Index> kept;
    for (Eigen::Index a = 0; a < P.size(); ++a) {
      if (P[a] >= pull) kept.push_back(active[static_cast<std::size_t>(a)]);
    }
    active = std::move(kept);
  }
  return scale.cwiseProduct(pushes);
}

// Contacts that hang together through bodies that can move: each part is resolved by itself.
std::vector<std::vector<Touch>> connected(const std::vector<Touch>& contacts, const Eigen::VectorXd& inverse_mass) {
  std::vector<std::size_t> above(contacts.size());
  std::iota(above.begin(), above.end(), 0U);
  const auto root = [&](std::size_t k) {
    while (above[k] != k) k = above[k] = above[above[k]];
    return k;
  };
  std::unordered_map<Eigen::Index, std::size_t> first_of_body;
  const auto join = [&](Eigen::Index body, std::size_t contact) {
    if (body < 0 || inverse_mass[body] == 0.0) return;
    const std::size_t first = first_of_body.try_emplace(body, contact).first->second;
    above[root(contact)] = root(first);
  };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    join(contacts[k].i, k);
    join(contacts[k].j, k);
  }
  std::vector<std::vector<Touch>> parts;
  std::unordered_map<std::size_t, std::size_t> part_of_root;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::size_t part = part_of_root.try_emplace(root(k), parts.size()).first->second;
    if (part == parts.size()) parts.emplace_back();
    parts[part].push_back(contacts[k]);
  }
  return parts;
}

// Friction of several contacts acts on bodies that they share, and together it can stop more than there is. Along the
// sum of their impulses the kinetic energy is a parabola: it is never followed beyond its minimum.
double safe_share(const Motions& motions, const std::vector<Touch>& part,
                  const std::vector<Eigen::Vector3d>& impulses) {
  std::map<Eigen::Index, Eigen::Vector3d> on_body;
  double slope = 0.0;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Touch& touch = part[k];
    slope += impulses[k].dot(motions.body(touch.i).velocity - motions.body(touch.j).velocity);
    on_body.try_emplace(touch.i, Eigen::Vector3d::Zero()).first->second += impulses[k];
    if (touch.j >= 0) on_body.try_emplace(touch.j, Eigen::Vector3d::Zero()).first->second -= impulses[k];
  }
  double bend = 0.0;
  for (const auto& [body, impulse] : on_body) bend += motions.inverse_mass[body] * impulse.squaredNorm();
  return bend > 0.0 ? std::clamp(-slope / bend, 0.0, 1.0) : 1.0;
}

// Returns the impulses of friction, one a contact.
template <class R>
std::vector<Eigen::Vector3d> rub(const ContactResolver<R, Friction>& law, Motions& motions,
                                 const std::vector<Touch>& part, const Eigen::VectorXd& pushes,
                                 const std::vector<Meeting>& meetings, double duration) {
  std::vector<Eigen::Vector3d> impulses;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Touch& touch = part[k];
    const Body i = motions.body(touch.i), j = motions.body(touch.j);
    const External external = changes_of(touch, duration, restitution_at(law.restitution, meetings[k].speed));
    const Eigen::Vector3d slip = i.velocity - j.velocity + external.compression + external.recovery;
    impulses.push_back(tangential_impulse(law.friction, slip - slip.dot(touch.n) * touch.n,
                                          1.0 / (i.inverse_mass + j.inverse_mass),
                                          pushes[static_cast<Eigen::Index>(k)]));
  }
  const double share = part.size() == 1 ? 1.0 : safe_share(motions, part, impulses);
  for (std::size_t k = 0; k < part.size(); ++k) {
    impulses[k] *= share;
    motions.push(part[k], impulses[k]);
  }
  return impulses;
}

template <class R>
std::vector<Eigen::Vector3d> rub(const ContactResolver<R, Frictionless>&, Motions&, const std::vector<Touch>&,
                                 const Eigen::VectorXd&, const std::vector<Meeting>&, double) {
  return {};
}

// The velocities of i as seen from j; empty where nobody wants to know.
std::vector<Eigen::Vector3d> relative_velocities(const ImpactRecorder& recorder, const Motions& motions,
                                                 const std::vector<Touch>& part) {
  std::vector<Eigen::Vector3d> all;
  if (!recorder) return all;
  for (const Touch& touch : part) all.push_back(motions.relative(touch));
  return all;
}

// All impulses from the velocities before, then added.
template <class R, class F>
Resolved resolve_summed(const ContactResolver<R, F>& law, Motions& motions, const std::vector<Touch>& touching,
                        double duration) {
  Resolved done;
  std::vector<Touch> pushed;
  std::vector<Impulse> impulses;
  for (const Touch& touch : touching) {
    const Meeting meeting = meeting_of(law, motions, touch, duration);
    if (meeting.wanted == 0.0) continue;
    const double e = restitution_at(law.restitution, meeting.speed);
    const Impulse impulse = impact_impulse(motions.body(touch.i), motions.body(touch.j), touch.n, e,
                                           changes_of(touch, duration, e), law.friction);
    pushed.push_back(touch);
    impulses.push_back(impulse);
    done.largest_impulse = std::max(done.largest_impulse, -impulse.normal);
    ++done.impacts;
  }
  const std::vector<Eigen::Vector3d> before = relative_velocities(law.recorder, motions, pushed);
  for (std::size_t k = 0; k < pushed.size(); ++k) motions.push(pushed[k], impulses[k].total(pushed[k].n));
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Touch& touch = pushed[k];
    const Impulse& impulse = impulses[k];
    law.recorder({touch.i, touch.j, touch.n, -impulse.normal, impulse.tangential, before[k], motions.relative(touch)});
  }
  return done;
}

// Resolves contacts that approach equally fast and hang together, at once.
template <class R, class F>
void resolve_part(const ContactResolver<R, F>& law, Motions& motions, const std::vector<Touch>& part, double duration,
                  Resolved& done) {
  const std::vector<Meeting> meetings = meetings_of(law, motions, part, duration);
  Eigen::VectorXd wanted(static_cast<Eigen::Index>(part.size()));
  for (std::size_t k = 0; k < part.size(); ++k) wanted[static_cast<Eigen::Index>(k)] = meetings[k].wanted;
  const std::vector<Eigen::Vector3d> before = relative_velocities(law.recorder, motions, part);
  const Eigen::VectorXd pushes = group_pushes(part, motions.inverse_mass, wanted);
  for (std::size_t k = 0; k < part.size(); ++k) {
    const double push = pushes[static_cast<Eigen::Index>(k)];
    motions.push(part[k], -push * part[k].n);
    done.largest_impulse = std::max(done.largest_impulse, push);
    if (push > 0.0) ++done.impacts;
  }
  const std::vector<Eigen::Vector3d> friction = rub(law, motions, part, pushes, meetings, duration);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double push = pushes[static_cast<Eigen::Index>(k)];
    const Eigen::Vector3d tangential = friction.empty() ? Eigen::Vector3d::Zero().eval() : friction[k];
    if (push > 0.0) {
      law.recorder({part[k].i, part[k].j, part[k].n, push, tangential, before[k], motions.relative(part[k])});
    }
  }
}

// Those of some contacts that approach fastest, ties together; none once all are at rest.
std::vector<Touch> fastest_group(const std::vector<Touch>& contacts, const std::vector<Meeting>& meetings,
                                 double at_rest) {
  double fastest = 0.0;
  for (const Meeting& meeting : meetings) {
    if (meeting.met > at_rest) fastest = std::max(fastest, meeting.speed);
  }
  std::vector<Touch> group;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (meetings[k].met > at_rest && meetings[k].speed >= fastest * (1.0 - tie)) group.push_back(contacts[k]);
  }
  return group;
}

// Goes on until no contact of a cluster approaches.
template <class R, class F>
void settle(const ContactResolver<R, F>& law, Motions& motions, const std::vector<Touch>& cluster, double duration,
            Resolved& done) {
  std::vector<Meeting> meetings = meetings_of(law, motions, cluster, duration);
  const double at_rest = speed_of_rest(motions, cluster, fastest_met(meetings));
  const auto contacts = static_cast<long>(cluster.size());
  const long most_rounds = 10000 + 200 * contacts * contacts;
  for (long round = 0; round < most_rounds; ++round) {
    const std::vector<Touch> group = fastest_group(cluster, meetings, at_rest);
    if (group.empty()) return;
    for (const std::vector<Touch>& part : connected(group, motions.inverse_mass)) {
      resolve_part(law, motions, part, duration, done);
    }
    meetings = meetings_of(law, motions, cluster, duration);
  }
  done.unsettled = fmt::format(
      "after {} rounds of impulses some of {} contacts that hang together still approach, at up to {} m/s: take a "
      "smaller step, so that fewer bodies touch at once, or less unequal masses",
      most_rounds, contacts, fastest_met(meetings));
}

}  // namespace

template <class RestitutionLaw, class FrictionLaw>
Resolved ContactResolver<RestitutionLaw, FrictionLaw>::operator()(const std::vector<Touch>& touching,
                                                                  const Eigen::VectorXd& inverse_mass, double duration,
                                                                  kinematics::VectorsOut velocity) const {
  Motions motions{.inverse_mass = inverse_mass, .velocity = velocity};
  if (resolution == Resolution::summed) return resolve_summed(*this, motions, touching, duration);
  Resolved done;
  for (const std::vector<Touch>& cluster : connected(touching, inverse_mass)) {
    settle(*this, motions, cluster, duration, done);
  }
  return done;
}

template struct ContactResolver<ConstantRestitution, Frictionless>;
template struct ContactResolver<ConstantRestitution, Friction>;
template struct ContactResolver<Restitution, Frictionless>;
template struct ContactResolver<Restitution, Friction>;

}  // namespace particulate::contact
