#include <particulate/contact/resolution.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
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
// So often friction and the pushes that it calls for are decided one after the other.
constexpr int most_frictions = 1000;
// After so many times it is kept if it presses nothing faster than this share of the first approach: pushes alone end
// it.
constexpr int patience = 100;
constexpr double nearly = 1e-9;
// What a look at a contact costs, in multiplications. So many rounds are made whatever they cost.
constexpr double look = 10.0;
constexpr long fewest_rounds = 50;

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

// A contact that is held: it approaches no faster than the other forces can have made it, or anything that it carries,
// within one step, or it would not part for as long as one step.
bool rests(const Touch& touch, double u, double e) {
  return touch.slow > 0.0 && (u <= touch.slow || e * u <= touch.parting);
}

template <class R>
double restitution_of(const R& law, const Touch& touch, double u) {
  if constexpr (std::is_same_v<R, SofteningRestitution>) {
    return restitution_at(law, u, touch.softened);
  } else {
    return restitution_at(law, u);
  }
}

template <class R, class F>
Meeting meeting_of(const ContactResolver<R, F>& law, const Motions& motions, const Touch& touch, double duration) {
  const double u = motions.approach(touch);
  if (!(u > 0.0) || !motions.can_move(touch)) return {};
  const double e = restitution_of(law.restitution, touch, u);
  if (rests(touch, u, e)) return {};
  const double delta1 = changes_of(touch, duration, e).compression.dot(touch.n);
  constexpr double unit_mass = 1.0;  // the impulse on it is the change of speed that restitution asks for
  const double wanted = -normal_impulse(u, delta1, e, unit_mass);
  return wanted > 0.0 ? Meeting{.speed = u, .met = u + delta1, .wanted = wanted} : Meeting{};
}

// One that is held, if it parts too slowly.
Meeting held(const Motions& motions, const Touch& touch) {
  const double met = motions.approach(touch) + touch.parting;
  return motions.can_move(touch) ? Meeting{.speed = met, .met = met, .wanted = met} : Meeting{.met = -1.0};
}

template <class R, class F>
std::vector<Meeting> meetings_of(const ContactResolver<R, F>& law, const Motions& motions,
                                 const std::vector<Touch>& contacts, double duration) {
  std::vector<Meeting> meetings;
  meetings.reserve(contacts.size());
  for (const Touch& touch : contacts) {
    meetings.push_back(law.holding ? held(motions, touch) : meeting_of(law, motions, touch, duration));
  }
  return meetings;
}

double fastest_met(const std::vector<Meeting>& meetings) {
  double fastest = 0.0;
  for (const Meeting& meeting : meetings) fastest = std::max(fastest, meeting.met);
  return fastest;
}

// What rounding makes of the velocity of one body as another sees it.
double noise_of(const Motions& motions, const std::vector<Touch>& contacts) {
  double largest = 0.0;
  for (const Touch& touch : contacts) {
    largest = std::max({largest, motions.body(touch.i).velocity.norm(), motions.body(touch.j).velocity.norm()});
  }
  return roundings * std::numeric_limits<double>::epsilon() * largest;
}

// How an impulse at contact b changes the relative velocity at contact a: the shared bodies carry it.
double coupling(const Touch& a, const Touch& b, const Eigen::VectorXd& inverse_mass) {
  const auto shared = [&](Eigen::Index p, Eigen::Index q) { return p >= 0 && p == q ? inverse_mass[p] : 0.0; };
  return shared(a.i, b.i) + shared(a.j, b.j) - shared(a.i, b.j) - shared(a.j, b.i);
}

// W: inverse masses as directions at the contacts of a group see them, which stand in as many columns a contact.
Eigen::MatrixXd couplings(const std::vector<Touch>& group, const Eigen::Matrix3Xd& directions,
                          const Eigen::VectorXd& inverse_mass) {
  const auto n = static_cast<Eigen::Index>(group.size()), each = directions.cols() / n;
  Eigen::MatrixXd W = directions.transpose() * directions;
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      W.block(each * a, each * b, each, each) *=
          coupling(group[static_cast<std::size_t>(a)], group[static_cast<std::size_t>(b)], inverse_mass);
    }
  }
  return W;
}

// Pushes P >= 0 that make every contact of a group part as it should: W P = wanted, those that would pull left out.
// More contacts than the bodies can move in make W singular; W is scaled by its diagonal, so that unequal masses do not
// look like that.
Eigen::VectorXd group_pushes(const std::vector<Touch>& group, const Eigen::VectorXd& inverse_mass,
                             const Eigen::VectorXd& wanted) {
  if (group.size() == 1) return (wanted / coupling(group[0], group[0], inverse_mass)).cwiseMax(0.0);
  Eigen::Matrix3Xd normals(3, wanted.size());
  for (std::size_t k = 0; k < group.size(); ++k) normals.col(static_cast<Eigen::Index>(k)) = group[k].n;
  const Eigen::MatrixXd W = couplings(group, normals, inverse_mass);
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

std::vector<Touch> chosen(const std::vector<Touch>& contacts, const std::vector<std::size_t>& which) {
  std::vector<Touch> group;
  group.reserve(which.size());
  for (const std::size_t k : which) group.push_back(contacts[k]);
  return group;
}

// Those of some contacts that hang together through bodies that can move: each part is resolved by itself.
std::vector<std::vector<std::size_t>> connected(const std::vector<Touch>& contacts,
                                                const std::vector<std::size_t>& which,
                                                const Eigen::VectorXd& inverse_mass) {
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
  for (const std::size_t k : which) {
    join(contacts[k].i, k);
    join(contacts[k].j, k);
  }
  std::vector<std::vector<std::size_t>> parts;
  std::unordered_map<std::size_t, std::size_t> part_of_root;
  for (const std::size_t k : which) {
    const std::size_t part = part_of_root.try_emplace(root(k), parts.size()).first->second;
    if (part == parts.size()) parts.emplace_back();
    parts[part].push_back(k);
  }
  return parts;
}

// An impulse of those that act together, and the relative velocity that they found.
struct Action {
  const Touch* touch;
  Impulse impulse;
  Eigen::Vector3d before;
};

// Books impulses that acted together: each works on the mean of the relative velocities before and after, which no
// common motion of the bodies enters. A body that nothing moves keeps its own energy: what it gives the other is
// gained.
void book(const ImpactRecorder& recorder, const Motions& motions, double duration, std::vector<Action>& actions,
          Resolved& done) {
  for (const auto& [touch, impulse, before] : actions) {
    const Eigen::Vector3d after = motions.relative(*touch);
    const Body i = motions.body(touch->i), j = motions.body(touch->j);
    Eigen::Vector3d seen = 0.5 * (before + after);
    if (i.inverse_mass == 0.0) seen -= i.velocity;
    if (j.inverse_mass == 0.0) seen += j.velocity;
    done.energy_change += impulse.total(touch->n).dot(seen);
    done.largest_impulse = std::max(done.largest_impulse, -impulse.normal);
    if (impulse.normal < 0.0) ++done.impacts;
    if (recorder) {
      recorder({touch->i, touch->j, touch->n, std::abs(impulse.normal), impulse.tangential, before, after,
                duration * touch->acceleration});
    }
  }
  actions.clear();
}

// How long the other forces act meanwhile: what holds takes no time, whatever friction looks ahead.
template <class R, class F>
double lasts(const ContactResolver<R, F>& law, double duration) {
  return law.holding ? 0.0 : duration;
}

// All impulses from the velocities before, each as if alone, then added.
template <class R, class F>
void resolve_each(const ContactResolver<R, F>& law, Motions& motions, const std::vector<Touch>& touching,
                  double duration, double at_rest, Resolved& done) {
  std::vector<Action> actions;
  for (const Touch& touch : touching) {
    const Meeting meeting = meeting_of(law, motions, touch, duration);
    if (!(meeting.met > at_rest)) continue;
    const double e = restitution_of(law.restitution, touch, meeting.speed);
    const Body i = motions.body(touch.i), j = motions.body(touch.j);
    actions.push_back({&touch, impact_impulse(i, j, touch.n, e, changes_of(touch, duration, e), law.friction),
                       i.velocity - j.velocity});
  }
  for (const Action& action : actions) motions.push(*action.touch, action.impulse.total(action.touch->n));
  book(law.recorder, motions, lasts(law, duration), actions, done);
}

// Contacts that hang together, and what they have exchanged at this moment.
struct Cluster {
  std::vector<Touch> contacts;
  std::vector<Impulse> impulses;
};

// Pushes contacts that approach equally fast and hang together apart, at once.
void push_apart(Motions& motions, Cluster& cluster, const std::vector<std::size_t>& part,
                const std::vector<Meeting>& meetings, std::vector<Action>& actions) {
  Eigen::VectorXd wanted(static_cast<Eigen::Index>(part.size()));
  for (std::size_t k = 0; k < part.size(); ++k) wanted[static_cast<Eigen::Index>(k)] = meetings[part[k]].wanted;
  const Eigen::VectorXd pushes = group_pushes(chosen(cluster.contacts, part), motions.inverse_mass, wanted);
  const std::size_t first = actions.size();
  for (std::size_t k = 0; k < part.size(); ++k) {
    const double push = pushes[static_cast<Eigen::Index>(k)];
    if (!(push > 0.0)) continue;
    const Touch& touch = cluster.contacts[part[k]];
    cluster.impulses[part[k]].normal -= push;
    actions.push_back({&touch, {.normal = -push}, motions.relative(touch)});
  }
  for (std::size_t k = first; k < actions.size(); ++k) {
    motions.push(*actions[k].touch, actions[k].impulse.normal * actions[k].touch->n);
  }
}

// Two tangents a contact, in which its friction lies.
Eigen::Matrix3Xd tangents_of(const std::vector<Touch>& group) {
  Eigen::Matrix3Xd tangents(3, 2 * static_cast<Eigen::Index>(group.size()));
  for (std::size_t k = 0; k < group.size(); ++k) {
    const auto at = 2 * static_cast<Eigen::Index>(k);
    tangents.col(at) = group[k].n.unitOrthogonal();
    tangents.col(at + 1) = group[k].n.cross(tangents.col(at));
  }
  return tangents;
}

// Friction of contacts that hang together, decided anew from all that they have exchanged so far: what the sum of it
// is to be now. Empty: no answer was found.
std::vector<Eigen::Vector3d> friction_of(const Friction& law, const Motions& motions, const std::vector<Touch>& group,
                                         const std::vector<Impulse>& so_far, double duration) {
  const auto slip_of = [&](const Touch& touch) -> Eigen::Vector3d {
    return motions.relative(touch) + duration * touch.acceleration;
  };
  if (group.size() == 1 && so_far[0].tangential.isZero(0.0)) {
    const Eigen::Vector3d slip = slip_of(group[0]);
    const double reduced_mass = 1.0 / coupling(group[0], group[0], motions.inverse_mass);
    return {tangential_impulse(law, slip - slip.dot(group[0].n) * group[0].n, reduced_mass, -so_far[0].normal)};
  }
  const Eigen::Matrix3Xd tangents = tangents_of(group);
  const Eigen::MatrixXd W = couplings(group, tangents, motions.inverse_mass);
  Eigen::VectorXd slip(W.rows()), given(W.rows()), pushes(W.rows() / 2);
  for (Eigen::Index k = 0; k < pushes.size(); ++k) {
    const auto of = static_cast<std::size_t>(k);
    const auto across = tangents.middleCols<2>(2 * k).transpose();
    slip.segment<2>(2 * k) = across * slip_of(group[of]);
    given.segment<2>(2 * k) = across * so_far[of].tangential;
    pushes[k] = -so_far[of].normal;
  }
  const Eigen::VectorXd P = tangential_impulses(law, W, slip, pushes, given);
  std::vector<Eigen::Vector3d> all;
  for (Eigen::Index k = 0; 2 * k < P.size(); ++k) all.emplace_back(tangents.middleCols<2>(2 * k) * P.segment<2>(2 * k));
  return all;
}

// Lets the contacts of a cluster rub that have pushed. Together with the pushes of the last round where no others
// have, else after them. Returns whether an answer was found.
template <class R>
bool rub(const ContactResolver<R, Friction>& law, Motions& motions, Cluster& cluster, double duration,
         std::vector<Action>& actions, Resolved& done) {
  std::vector<std::size_t> pushed;
  for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
    if (cluster.impulses[k].normal < 0.0) pushed.push_back(k);
  }
  if (pushed.size() > actions.size()) {
    book(law.recorder, motions, lasts(law, duration), actions, done);
    for (const std::size_t k : pushed) {
      actions.push_back({&cluster.contacts[k], {}, motions.relative(cluster.contacts[k])});
    }
  }
  for (const std::vector<std::size_t>& part : connected(cluster.contacts, pushed, motions.inverse_mass)) {
    std::vector<Impulse> so_far;
    so_far.reserve(part.size());
    for (const std::size_t k : part) so_far.push_back(cluster.impulses[k]);
    const std::vector<Eigen::Vector3d> friction =
        friction_of(law.friction, motions, chosen(cluster.contacts, part), so_far, duration);
    if (friction.empty()) return false;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Touch& touch = cluster.contacts[part[k]];
      const Eigen::Vector3d more = friction[k] - so_far[k].tangential;
      motions.push(touch, more);
      cluster.impulses[part[k]].tangential = friction[k];
      for (Action& action : actions) {
        if (action.touch == &touch) action.impulse.tangential = more;
      }
    }
  }
  return true;
}

template <class R>
bool rub(const ContactResolver<R, Frictionless>&, Motions&, Cluster&, double, std::vector<Action>&, Resolved&) {
  return true;
}

// Those of some contacts that approach fastest, ties together; none once all are at rest. What is held is held at once,
// those that the fastest would press next with them: a stack takes one round, not hundreds.
std::vector<std::size_t> fastest_group(const std::vector<Meeting>& meetings, double at_rest, double noise,
                                       bool holding) {
  double fastest = 0.0;
  for (const Meeting& meeting : meetings) {
    if (meeting.met > at_rest) fastest = std::max(fastest, meeting.speed);
  }
  std::vector<std::size_t> group;
  for (std::size_t k = 0; k < meetings.size(); ++k) {
    const Meeting& meeting = meetings[k];
    const bool ties = meeting.met > at_rest && meeting.speed >= fastest * (1.0 - tie) - noise;
    if (ties || (holding && fastest > 0.0 && meeting.met >= -at_rest)) group.push_back(k);
  }
  return group;
}

std::string name_of(Eigen::Index body) { return body < 0 ? "a wall" : fmt::format("particle {}", body); }

// Why a cluster does not come to rest: who is pressed from both sides, and by how much it has too little room.
std::string pinched(const Motions& motions, const Cluster& cluster) {
  const auto& contacts = cluster.contacts;
  const Touch& worst = *std::max_element(contacts.begin(), contacts.end(), [&](const Touch& a, const Touch& b) {
    return motions.approach(a) < motions.approach(b);
  });
  Eigen::Index body = -1, one = -1, other = -1;
  double least = -0.5, overlap = 0.0;
  for (const bool first : {true, false}) {
    const Eigen::Index k = first ? worst.i : worst.j;
    if (k < 0 || motions.inverse_mass[k] == 0.0) continue;
    for (const Touch& touch : contacts) {
      if (touch.i != k && touch.j != k) continue;
      const double along = (touch.i == k) == first ? touch.n.dot(worst.n) : -touch.n.dot(worst.n);
      if (along >= least) continue;
      least = along, overlap = worst.overlap + touch.overlap;
      body = k, one = first ? worst.j : worst.i, other = touch.i == k ? touch.j : touch.i;
    }
  }
  if (body < 0) return "take a smaller step, so that fewer bodies touch at once";
  return fmt::format(
      "particle {} is pinched between {} and {}, which it overlaps by {:.3g} m together: give it that much more room, "
      "let impacts take energy (e < 1), or take less unequal masses where a light one is held between heavy ones",
      body, name_of(one), name_of(other), overlap + 0.0);
}

// How many they are, and how deep.
std::string cluster_of(const std::vector<Touch>& contacts) {
  double deepest = 0.0;
  for (const Touch& touch : contacts) deepest = std::max(deepest, touch.overlap);
  return fmt::format("{} contacts that hang together, up to {:.3g} m deep,", contacts.size(), deepest);
}

std::string without_balance(const std::vector<Touch>& contacts, int rubbed) {
  return fmt::format(
      "friction of {} and their pushes do not come to agree, after deciding {} times which stick: take a smaller step, "
      "so that fewer bodies touch at once, or a smaller mu_s",
      cluster_of(contacts), rubbed);
}

// A system of equations for as many unknowns.
double work_of(std::size_t unknowns) { return std::pow(static_cast<double>(unknowns), 3.0); }

// Goes on until no contact of a cluster approaches: pushes, then friction, which may press others together.
template <class R, class F>
void settle(const ContactResolver<R, F>& law, Motions& motions, std::vector<Touch> contacts, double duration,
            Resolved& done) {
  const double noise = noise_of(motions, contacts);
  if (contacts.size() == 1 && !law.holding) return resolve_each(law, motions, contacts, duration, noise, done);
  std::vector<Meeting> meetings = meetings_of(law, motions, contacts, duration);
  const double first = fastest_met(meetings), at_rest = std::max(rest * first, noise);
  const auto n = static_cast<long>(contacts.size());
  const long most_rounds = 10000 + 200 * n * n;
  std::vector<Impulse> none(contacts.size());
  Cluster cluster{.contacts = std::move(contacts), .impulses = std::move(none)};
  std::vector<Action> actions;
  double pressed = first;  // by the friction decided last
  int rubbed = 0;
  long round = 0;
  double work = 0.0;
  for (; round < fewest_rounds || (round < most_rounds && work < law.most_work); ++round) {
    work += look * static_cast<double>(n);
    if (law.holding && round == n + 10) {  // there is no room to work off overlap: what only holds always has an answer
      for (Touch& touch : cluster.contacts) touch.parting = duration * touch.acceleration.dot(touch.n);
      meetings = meetings_of(law, motions, cluster.contacts, duration);
    }
    const std::vector<std::size_t> group = fastest_group(meetings, at_rest, noise, law.holding);
    if (group.empty()) return;
    for (const std::vector<std::size_t>& part : connected(cluster.contacts, group, motions.inverse_mass)) {
      push_apart(motions, cluster, part, meetings, actions);
      work += work_of(part.size());
    }
    meetings = meetings_of(law, motions, cluster.contacts, duration);
    const bool agree = rubbed >= patience && pressed <= nearly * first;
    const bool rubs = std::is_same_v<F, Friction> && fastest_met(meetings) <= at_rest && !agree;
    if (rubs && (++rubbed > most_frictions || !rub(law, motions, cluster, duration, actions, done))) {
      done.unsettled = without_balance(cluster.contacts, rubbed);
      return;
    }
    if (rubs) work += work_of(2 * cluster.contacts.size());  // each in two directions
    book(law.recorder, motions, lasts(law, duration), actions, done);
    if (!rubs) continue;
    meetings = meetings_of(law, motions, cluster.contacts, duration);
    pressed = fastest_met(meetings);
  }
  done.unsettled = fmt::format("after {} rounds of impulses some of {} still approach, at up to {:.3g} m/s; {}", round,
                               cluster_of(cluster.contacts), fastest_met(meetings), pinched(motions, cluster));
}

// The fastest approach in a cluster that the other forces can have made within one step; 0: nothing is held.
double slowest_impact(const std::vector<Touch>& contacts, const std::vector<std::size_t>& which) {
  double slow = 0.0;
  for (const std::size_t k : which) slow = std::max(slow, contacts[k].slow);
  return slow;
}

bool any_approaches(const Motions& motions, const std::vector<Touch>& contacts, const std::vector<std::size_t>& which) {
  return std::any_of(which.begin(), which.end(), [&](std::size_t k) { return motions.approach(contacts[k]) > 0.0; });
}

}  // namespace

template <class RestitutionLaw, class FrictionLaw>
Resolved ContactResolver<RestitutionLaw, FrictionLaw>::operator()(const std::vector<Touch>& touching,
                                                                  const Eigen::VectorXd& inverse_mass, double duration,
                                                                  kinematics::VectorsOut velocity) const {
  Motions motions{.inverse_mass = inverse_mass, .velocity = velocity};
  Resolved done;
  if (resolution == Resolution::summed) {
    resolve_each(*this, motions, touching, duration, 0.0, done);
    return done;
  }
  std::vector<std::size_t> all(touching.size());
  std::iota(all.begin(), all.end(), 0U);
  const ContactResolver<ConstantRestitution, FrictionLaw> holds{{0.0}, friction, resolution, recorder, true, most_work};
  for (const std::vector<std::size_t>& cluster : connected(touching, all, inverse_mass)) {
    if (!any_approaches(motions, touching, cluster)) continue;
    std::vector<Touch> contacts = chosen(touching, cluster);
    const double slow = slowest_impact(touching, cluster), hold = contacts.front().hold;
    for (Touch& touch : contacts) touch.slow = slow;
    settle(*this, motions, std::move(contacts), duration, done);
    if (!done.unsettled.empty()) break;
    if (slow > 0.0) settle(holds, motions, chosen(touching, cluster), 0.5 * hold, done);
  }
  return done;
}

template struct ContactResolver<ConstantRestitution, Frictionless>;
template struct ContactResolver<ConstantRestitution, Friction>;
template struct ContactResolver<Restitution, Frictionless>;
template struct ContactResolver<Restitution, Friction>;
template struct ContactResolver<SofteningRestitution, Frictionless>;
template struct ContactResolver<SofteningRestitution, Friction>;

}  // namespace particulate::contact
