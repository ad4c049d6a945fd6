#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <particulate/contact/impact.hpp>

#include "grading.hpp"

using Eigen::Vector3d;
using grading::Answers;
using grading::Draw;
using grading::Finding;
using grading::Line;
using grading::mistakes;
using grading::Question;
using grading::rough_pi;

namespace {

namespace contact = particulate::contact;

// An impact as the student gets it, and the variant that says whether j is driven.
struct Hit {
  int variant = 1;
  double m_i = 1.0, m_j = 1.0;
  Vector3d v_i = Vector3d::Zero(), v_j = Vector3d::Zero(), n = Vector3d::UnitX();
  double e = 0.0;
  contact::Friction friction = {};
};

double approach(const Hit& hit) { return (hit.v_i - hit.v_j).dot(hit.n); }

double reduced_mass(const Hit& hit) { return hit.variant == 1 ? hit.m_i * hit.m_j / (hit.m_i + hit.m_j) : hit.m_i; }

contact::Rebound by_library(const Hit& hit) {
  const contact::Body i{.velocity = hit.v_i, .inverse_mass = 1.0 / hit.m_i};
  const contact::Body j{.velocity = hit.v_j, .inverse_mass = hit.variant == 1 ? 1.0 / hit.m_j : 0.0};
  const Vector3d none = Vector3d::Zero();
  return contact::impact(i, j, hit.n, hit.e, none, none, 0.0, hit.friction);
}

// What can be wrong in one of the formulas. Where several give the same answer, the first one's hint is shown.
struct Flaw {
  bool approach_reversed = false, impulse_reversed = false, forgotten_one = false, forgotten_e = false, loses_e = false,
       energy = false, half = false, twice = false, other_variant = false, not_inverted = false, sum_of_masses = false,
       mass_of_i = false, mass_of_j = false, whole_velocity = false, whole_direction = false, whole_length = false,
       sticks_strictly = false, never_sticks = false, forgotten_bars = false, friction_pushes = false,
       slides_by_static = false, swapped_coefficients = false, sticks_by_dynamic = false, always_sticks = false,
       no_friction = false, swapped_masses = false, same_direction = false, pulls = false;
};

const std::vector<std::pair<Flaw, std::string>> flaws{
    {{.approach_reversed = true}, "sign of n: it points from i to j, so the bodies approach where (v_i - v_j).n > 0"},
    {{.impulse_reversed = true},
     "sign of J: contacts push, and n points from i to j, so the impulse on i is against n"},
    {{.forgotten_one = true}, "forgotten 1 + e: compression takes m* u, recovery e m* u more"},
    {{.forgotten_e = true}, "forgotten e: compression takes m* u, recovery e m* u more"},
    {{.loses_e = true}, "sign of e: recovery adds to the impulse of compression, 1 + e"},
    {{.energy = true}, "e is a ratio of velocities, not of energies: no square root"},
    {{.half = true}, "factor 1/2: m* = 1/(1/m_i + 1/m_j) holds no other factor; it is m/2 for equal masses m"},
    {{.twice = true}, "factor 2: m* = 1/(1/m_i + 1/m_j), which is m/2 for equal masses m"},
    {{.other_variant = true},
     "this is the map of the other variant: in variant 1 both bodies move, in variant 2 j is driven and 1/m_j counts "
     "as 0"},
    {{.not_inverted = true},
     "m* is upside down: 1/m_i + 1/m_j is 1/m*, so m* = 1/(1/m_i + 1/m_j), which has the unit of a mass"},
    {{.sum_of_masses = true}, "m* is not the sum of the masses: its inverse is the sum of their inverses"},
    {{.mass_of_i = true}, "m* is not the mass of one body: 1/m* = 1/m_i + 1/m_j"},
    {{.mass_of_j = true}, "swapped indices: the mass of j stands where that of i belongs"},
    {{.whole_direction = true},
     "friction acts across n, against the slip: it slides along w_t/|w_t|, not along w/|w|; w_t = w - (w.n) n"},
    {{.whole_velocity = true},
     "friction acts across n, on the slip: take the normal part from the relative velocity, w_t = w - (w.n) n"},
    {{.sticks_strictly = true},
     "it sticks where m* |slip| <= mu_s |J|, equality included: where nothing slips and nothing rubs, sliding is 0/0"},
    {{.sticks_by_dynamic = true}, "whether it sticks is decided by mu_s, not by mu_d"},
    {{.whole_length = true}, "the slip alone has to be stopped: compare m* |w_t| with mu_s |J|, not m* |w|"},
    {{.never_sticks = true},
     "friction is not capped: it can stop the slip, never reverse it; stick if m* |slip| <= mu_s |J|, with |J| since J "
     "is negative, and where nothing slips slip/|slip| is 0/0"},
    {{.forgotten_bars = true}, "|J|, not J: the impulse J is negative, friction is proportional to its size"},
    {{.friction_pushes = true}, "sign of friction: on i it acts against the slip of i over j"},
    {{.slides_by_static = true}, "once it slides the coefficient is mu_d, not mu_s"},
    {{.swapped_coefficients = true},
     "mu_s and mu_d are swapped: mu_s says whether it sticks, mu_d how strongly it slides"},
    {{.always_sticks = true}, "friction cannot stop every slip: it slides where sticking needs more than mu_s |J|"},
    {{.no_friction = true}, "friction is missing: add P across n to J along n"},
    {{.swapped_masses = true}, "swapped indices: the change of v_i is the impulse over m_i, that of v_j over m_j"},
    {{.same_direction = true}, "momentum: j gets the opposite of the impulse on i"},
    {{.pulls = true}, "bodies that part exchange nothing: J = 0 unless u > 0, and then no friction either"}};

struct Outcome {
  double J = 0.0;
  Vector3d P = Vector3d::Zero(), v_i = Vector3d::Zero(), v_j = Vector3d::Zero();
};

double flawed_mass(const Hit& hit, const Flaw& flaw) {
  Hit other = hit;
  other.variant = 3 - hit.variant;
  if (flaw.half) return 0.5 * reduced_mass(hit);
  if (flaw.twice) return 2.0 * reduced_mass(hit);
  if (flaw.not_inverted) return 1.0 / reduced_mass(hit);
  if (flaw.sum_of_masses) return hit.m_i + hit.m_j;
  if (flaw.mass_of_i) return hit.m_i;
  if (flaw.mass_of_j) return hit.m_j;
  return reduced_mass(flaw.other_variant ? other : hit);
}

double flawed_impulse(const Hit& hit, const Flaw& flaw, double mass) {
  const double u = flaw.approach_reversed ? -approach(hit) : approach(hit);
  if (!(u > 0.0 || flaw.pulls)) return 0.0;
  double factor = 1.0 + hit.e;
  if (flaw.forgotten_one) factor = hit.e;
  if (flaw.forgotten_e) factor = 1.0;
  if (flaw.loses_e) factor = 1.0 - hit.e;
  if (flaw.energy) factor = 1.0 + std::sqrt(hit.e);
  return (flaw.impulse_reversed ? 1.0 : -1.0) * factor * mass * u;
}

Vector3d flawed_friction(const Hit& hit, const Flaw& flaw, double mass, double J) {
  if (flaw.no_friction) return Vector3d::Zero();
  const Vector3d relative = hit.v_i - hit.v_j;
  const Vector3d across = relative - relative.dot(hit.n) * hit.n;
  const Vector3d slip = flaw.whole_velocity ? relative : across;
  const bool swapped = flaw.swapped_coefficients;
  const double to_stick = swapped || flaw.sticks_by_dynamic ? hit.friction.mu_d : hit.friction.mu_s;
  const double to_slide = swapped || flaw.slides_by_static ? hit.friction.mu_s : hit.friction.mu_d;
  const Vector3d sliding = flaw.whole_direction ? relative : slip;
  const double size = std::abs(J), needed = mass * (flaw.whole_length ? relative : slip).norm();
  const double limit = to_stick * (flaw.forgotten_bars ? J : size);
  const bool can_stick = flaw.sticks_strictly ? needed < limit : needed <= limit;
  const bool sticks = flaw.always_sticks || (can_stick && !flaw.never_sticks);
  const double against = flaw.forgotten_bars ? J : size;
  const Vector3d P = sticks ? Vector3d(-mass * slip) : Vector3d(-to_slide * against / sliding.norm() * sliding);
  return flaw.friction_pushes ? Vector3d(-P) : P;
}

Outcome flawed(const Hit& hit, const Flaw& flaw) {
  Outcome out;
  const double mass = flawed_mass(hit, flaw);
  out.J = flawed_impulse(hit, flaw, mass);
  out.P = flawed_friction(hit, flaw, mass, out.J);
  const Vector3d impulse = out.J * hit.n + out.P;
  const bool swapped = flaw.swapped_masses;
  const bool both_move = (hit.variant == 1) != flaw.other_variant;
  const Vector3d change = impulse / (swapped ? hit.m_i : hit.m_j);
  out.v_i = hit.v_i + impulse / (swapped ? hit.m_j : hit.m_i);
  out.v_j = hit.v_j;
  if (both_move) out.v_j += flaw.same_direction ? change : Vector3d(-change);
  return out;
}

std::vector<double> numbers(const Vector3d& a) { return {a.x(), a.y(), a.z()}; }

std::vector<double> numbers(const Vector3d& a, const Vector3d& b) { return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}; }

// In the order in which the driver takes them.
std::vector<double> inputs(const Hit& hit) {
  std::vector<double> all{hit.m_i, hit.v_i.x(), hit.v_i.y(), hit.v_i.z(), hit.m_j, hit.v_j.x(), hit.v_j.y()};
  all.insert(all.end(), {hit.v_j.z(), hit.n.x(), hit.n.y(), hit.n.z(), hit.e, hit.friction.mu_s, hit.friction.mu_d});
  return all;
}

Question ask_normal(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0, inverse = degrees * 180.0 / std::numbers::pi;
  const double c = std::cos(angle), s = std::sin(angle);
  const std::string in_degrees = "the angle is in degrees, std::cos and std::sin take radians: times pi/180";
  Question question{.function = "normal", .inputs = {degrees}, .expected = {c, s, 0.0}};
  question.mistakes = rough_pi([&](double pi) {
    return std::vector<double>{std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0), 0.0};
  });
  question.mistakes.insert(question.mistakes.begin(),
                           {{{std::cos(degrees), std::sin(degrees), 0.0}, in_degrees},
                            {{std::cos(inverse), std::sin(inverse), 0.0}, in_degrees + ", not over it"},
                            {{s, c, 0.0}, "the angle is measured from the x axis: the cosine is the x component"},
                            {{c, -s, 0.0}, "sign: the angle turns from the x axis towards the y axis"},
                            {{-c, -s, 0.0}, "sign of n: it points along (cos, sin, 0)"}});
  return question;
}

Question ask_normal_impulse(const Hit& hit) {
  return {.function = "normal_impulse",
          .inputs = inputs(hit),
          .expected = {by_library(hit).impulse.normal},
          .mistakes = mistakes(flaws, [&](const Flaw& flaw) { return std::vector<double>{flawed(hit, flaw).J}; })};
}

// With the student's own J. If J is wrong because m* is, the m* that it holds will do.
Question ask_friction_impulse(const Hit& hit) {
  return {.function = "friction_impulse",
          .inputs = inputs(hit),
          .expected = numbers(by_library(hit).impulse.tangential),
          .mistakes = mistakes(flaws, [&](const Flaw& flaw) { return numbers(flawed(hit, flaw).P); }),
          .built_on = 1,
          .with_own = [hit](const Answers& own) {
            const double J = own[0][0], held = -J / ((1.0 + hit.e) * approach(hit));
            return Answers{numbers(flawed_friction(hit, {}, reduced_mass(hit), J)),
                           numbers(flawed_friction(hit, {}, held, J))};
          }};
}

// With the student's own J and P.
Question ask_impact(const Hit& hit) {
  const contact::Rebound after = by_library(hit);
  return {.function = "impact",
          .inputs = inputs(hit),
          .expected = numbers(after.velocity_i, after.velocity_j),
          .mistakes = mistakes(flaws,
                               [&](const Flaw& flaw) {
                                 const Outcome out = flawed(hit, flaw);
                                 return numbers(out.v_i, out.v_j);
                               }),
          .built_on = 2,
          .with_own = [hit](const Answers& own) {
            const Vector3d impulse = own[0][0] * hit.n + Vector3d(own[1][0], own[1][1], own[1][2]);
            const double share = hit.variant == 1 ? 1.0 / hit.m_j : 0.0;
            return Answers{numbers(hit.v_i + impulse / hit.m_i, hit.v_j - share * impulse)};
          }};
}

// The impulses of a hit, which each have lines of their own, for what is built on them.
void add_unjudged(Line& line, Question question) {
  question.is_judged = false;
  line.questions.push_back(std::move(question));
}

void add_normal_impulse(Line& line, const Hit& hit) { line.questions.push_back(ask_normal_impulse(hit)); }

void add_friction_impulse(Line& line, const Hit& hit) {
  add_unjudged(line, ask_normal_impulse(hit));
  line.questions.push_back(ask_friction_impulse(hit));
}

void add_impact(Line& line, const Hit& hit) {
  add_unjudged(line, ask_normal_impulse(hit));
  add_unjudged(line, ask_friction_impulse(hit));
  line.questions.push_back(ask_impact(hit));
}

Vector3d direction(Draw& draw) {
  const double azimuth = draw.between(0.3, 1.2), height = draw.between(0.2, 0.7),
               level = std::sqrt(1.0 - height * height);
  return {level * std::cos(azimuth), level * std::sin(azimuth), height};
}

// Surfaces and masses far enough from one another that no mistake looks like another one.
Hit some_pair(int variant, Draw& draw) {
  Hit hit{.variant = variant, .m_i = draw.between(1.0, 2.0), .m_j = draw.between(4.5, 6.0), .n = direction(draw)};
  hit.e = draw.between(0.6, 0.8);
  hit.friction = {.mu_s = draw.between(0.5, 0.7), .mu_d = draw.between(0.15, 0.3)};
  return hit;
}

// Sets velocities: u of approach, and a slip that needs `share` of the friction that sticking may use.
Hit with_velocities(Hit hit, double u, double share, Draw& draw) {
  const Vector3d across = hit.n.cross(Vector3d{draw.between(0.5, 1.0), -draw.between(0.5, 1.0), 0.4}).normalized();
  const double slip = share * hit.friction.mu_s * (1.0 + hit.e) * u;
  hit.v_j = Vector3d{draw.between(-2.0, -1.0), draw.between(0.5, 1.5), draw.between(0.5, 1.5)};
  hit.v_i = hit.v_j + u * hit.n + slip * across;
  return hit;
}

Hit oblique(int variant, double share, Draw& draw) {
  const Hit pair = some_pair(variant, draw);
  const double u = draw.between(1.0, 3.0);
  return with_velocities(pair, u, share, draw);
}

// Numbers for a calculation by hand; both go on along y together, so that nothing slips. The ratios of these masses, of
// sums with e, and the coefficients of friction all differ.
Hit head_on(int variant, Draw& draw) {
  constexpr std::array<double, 3> restitutions{0.6, 0.7, 0.8}, masses{7.0, 11.0, 13.0};
  Hit hit{.variant = variant, .m_i = 1.0 + draw.one_of(3), .m_j = masses[static_cast<std::size_t>(draw.one_of(3))]};
  const double a = 2.0 + draw.one_of(3), b = 1.0 + draw.one_of(3), along = 1.0 + draw.one_of(4);
  hit.v_i = {a, along, 0.0};
  hit.v_j = {-b, along, 0.0};
  hit.e = restitutions[static_cast<std::size_t>(draw.one_of(3))];
  hit.friction = {.mu_s = 0.5, .mu_d = 0.3};
  return hit;
}

// It sticks, whatever of w is compared, and by either coefficient: who slides here never sticks.
Hit rough(int variant, Draw& draw) {
  Hit pair = some_pair(variant, draw);
  pair.friction.mu_s = 4.0;
  return with_velocities(pair, draw.between(1.0, 3.0), 0.02, draw);
}

// It sticks by either coefficient, but would not if all of w had to be stopped.
Hit gentle(int variant, Draw& draw) {
  Hit pair = some_pair(variant, draw);
  pair.friction.mu_s = 0.4;
  const double u = draw.between(1.0, 3.0);
  return with_velocities(pair, u, draw.between(0.1, 0.2), draw);
}

std::vector<Hit> plain_hits(int variant, Draw& draw) {
  const Hit straight = head_on(variant, draw), rather_rough = rough(variant, draw), slow = gentle(variant, draw);
  const Hit sticking = oblique(variant, draw.between(0.7, 0.9), draw);
  const Hit sliding = oblique(variant, draw.between(1.5, 2.5), draw);
  return {straight, rather_rough, slow, sticking, sliding};
}

// A hit after which the bodies part already: who has n the wrong way round has impulses here, and nowhere else.
Hit parted(int variant, Draw& draw) {
  Hit hit = oblique(variant, 1.5, draw);
  std::swap(hit.v_i, hit.v_j);
  return hit;
}

Line plain(const char* name, double points, const std::vector<Hit>& hits, void (*add)(Line&, const Hit&),
           const Hit& last) {
  Line line{.name = name, .points = points, .relative = 1e-10, .absolute = 1e-12};
  for (const Hit& hit : hits) add(line, hit);
  for (const Question& question : {ask_normal_impulse(last), ask_friction_impulse(last)}) add_unjudged(line, question);
  return line;
}

Line normal_line(int, Draw& draw) {
  return {.name = "normal: of an acute and of an obtuse angle",
          .points = 2.0,
          .relative = 1e-10,
          .absolute = 1e-12,
          .questions = {ask_normal(draw.between(20.0, 35.0)), ask_normal(draw.between(100.0, 170.0))}};
}

Line plain_normal_impulse(int variant, Draw& draw) {
  const std::vector<Hit> hits = plain_hits(variant, draw);
  return plain("normal_impulse: head-on and oblique", 3.0, hits, add_normal_impulse, parted(variant, draw));
}

Line plain_friction_impulse(int variant, Draw& draw) {
  std::vector<Hit> hits = plain_hits(variant, draw);
  // Head-on many mistakes give the same, 0/0: others before it tell them apart.
  std::rotate(hits.begin(), hits.begin() + 1, hits.begin() + 3);
  return plain("friction_impulse: nothing slips, sticking and sliding", 4.0, hits, add_friction_impulse,
               parted(variant, draw));
}

Line plain_impact(int variant, Draw& draw) {
  const std::vector<Hit> hits = plain_hits(variant, draw);
  return plain("impact: head-on, sticking and sliding", 3.0, hits, add_impact, parted(variant, draw));
}

std::vector<Hit> limit_hits(int variant, Draw& draw) {
  Hit smooth = oblique(variant, draw.between(1.5, 2.5), draw);
  smooth.friction = {};
  const Hit rather_rough = rough(variant, draw);
  Hit against_wall = gentle(variant, draw);
  against_wall.m_j = 1e12 * against_wall.m_i;
  Hit of_wall = oblique(variant, draw.between(0.7, 0.9), draw);
  of_wall.m_i = 1e12 * of_wall.m_j;
  Hit elastic = oblique(variant, draw.between(1.5, 2.5), draw);
  elastic.e = 1.0;
  Hit plastic = oblique(variant, draw.between(0.4, 0.9), draw);
  plastic.e = 0.0;
  plastic.friction.mu_s = 4.0;
  return {rather_rough, against_wall, smooth, of_wall, elastic, plastic};
}

// What any answer to a hit must obey, from the velocities alone. NaN obeys nothing.
struct Facts {
  Hit hit;
  Vector3d v_i, v_j;

  Facts(const Hit& before, const std::vector<double>& answer) : hit(before) {
    v_i = Eigen::Map<const Vector3d>(answer.data());
    v_j = Eigen::Map<const Vector3d>(answer.data() + 3);
  }

  std::optional<Finding> momentum() const {
    const Vector3d gained_i = hit.m_i * (v_i - hit.v_i), gained_j = hit.m_j * (v_j - hit.v_j);
    if (hit.variant == 2) {
      if ((v_j - hit.v_j).norm() <= 1e-9) return std::nullopt;
      return Finding{"the velocity of j, which is driven, stays as it is",
                     fmt::format("it changes by {:.6g} m/s", (v_j - hit.v_j).norm()), hint_of(&Flaw::other_variant)};
    }
    const double lost = (gained_i + gained_j).norm();
    if (lost <= 1e-9) return std::nullopt;
    return Finding{"momentum is kept: m_i v_i + m_j v_j is the same before and after",
                   fmt::format("it changes by {:.6g} N s", lost), momentum_hint(gained_i, gained_j)};
  }

  std::optional<Finding> restitution() const {
    const double out = (v_j - v_i).dot(hit.n), in = approach(hit);
    if (std::abs(out - hit.e * in) <= 1e-9) return std::nullopt;
    const std::string expected = fmt::format("the bodies part at e u = {:.10g} m/s", hit.e * in);
    const std::string obtained = fmt::format("{:.10g} m/s", out);
    if (out < -in - 1e-9) return Finding{expected, obtained, hint_of(&Flaw::impulse_reversed)};
    if (std::abs(out + in) <= 1e-9) return Finding{expected, obtained, hint_of(&Flaw::approach_reversed)};
    return Finding{expected, obtained,
                   "restitution: along n the speed of parting is e times that of approach; look at 1 + e, at the "
                   "masses, and that e compares velocities, not energies"};
  }

  // Of the motion of i over j, which alone an impact can change.
  std::optional<Finding> energy() const {
    const double before = 0.5 * reduced_mass(hit) * (hit.v_i - hit.v_j).squaredNorm();
    const double after = 0.5 * reduced_mass(hit) * (v_i - v_j).squaredNorm();
    if (after <= before * (1.0 + 1e-9)) return std::nullopt;
    return Finding{fmt::format("no energy is gained: of the relative motion there was {:.10g} J", before),
                   fmt::format("{:.10g} J", after), hint_of(&Flaw::friction_pushes) + "; J is negative, so take |J|"};
  }

  std::optional<Finding> friction() const {
    const Vector3d before = across(hit.v_i - hit.v_j), after = across(v_i - v_j);
    const double J = std::abs(hit.m_i * (v_i - hit.v_i).dot(hit.n));
    const double P = hit.m_i * across(v_i - hit.v_i).norm(), needed = reduced_mass(hit) * before.norm();
    if (!(after.dot(before) >= -1e-9)) {
      return Finding{"friction does not reverse the sliding", fmt::format("{:.6g} m/s backwards", after.norm()),
                     hint_of(&Flaw::never_sticks)};
    }
    const bool sticks = needed <= hit.friction.mu_s * J;
    const double right = sticks ? needed : hit.friction.mu_d * J;
    const bool is_straight = std::abs(after.norm() * before.norm() - after.dot(before)) <= 1e-9;
    if (std::abs(P - right) <= 1e-9 && is_straight) return std::nullopt;
    return Finding{fmt::format("it {} with |P| = {:.10g} N s against the slip", sticks ? "sticks" : "slides", right),
                   fmt::format("|P| = {:.10g} N s", P),
                   "friction: mu_s decides whether it sticks, mu_d how strongly it slides; P is against the slip"};
  }

  std::optional<Finding> all() const {
    for (const auto fact : {&Facts::momentum, &Facts::restitution, &Facts::energy, &Facts::friction}) {
      if (const std::optional<Finding> wrong = (this->*fact)()) return wrong;
    }
    return std::nullopt;
  }

 private:
  Vector3d across(const Vector3d& a) const { return a - a.dot(hit.n) * hit.n; }

  std::string momentum_hint(const Vector3d& gained_i, const Vector3d& gained_j) const {
    if ((gained_i - gained_j).norm() <= 1e-9) return hint_of(&Flaw::same_direction);
    if ((gained_i / (hit.m_i * hit.m_i) + gained_j / (hit.m_j * hit.m_j)).norm() <= 1e-9) {
      return hint_of(&Flaw::swapped_masses);
    }
    return "momentum: j gets the opposite of the impulse on i, each velocity changes by it over its own mass";
  }

  static std::string hint_of(bool Flaw::*wanted) {
    return std::find_if(flaws.begin(), flaws.end(), [&](const auto& entry) { return entry.first.*wanted; })->second;
  }
};

Line conservation(int variant, Draw& draw) {
  Line line{.name = "conservation: momentum, restitution, energy, Coulomb's law", .points = 2.0};
  line.relative = 1e-9;
  std::vector<Hit> hits{rough(variant, draw), gentle(variant, draw)};
  for (const double share : {0.8, 1.3, 3.0}) hits.push_back(oblique(variant, share, draw));
  for (const Hit& hit : hits) {
    Question question = ask_impact(hit);
    question.expected = {};
    question.count = 6;
    question.holds = [hit](const Answers& answers, std::size_t own) { return Facts(hit, answers[own]).all(); };
    line.questions.push_back(std::move(question));
  }
  return line;
}

Hit grazing(int variant, double degrees, Draw& draw) {
  const double angle = degrees * std::numbers::pi / 180.0, speed = draw.between(5.0, 10.0);
  const Hit pair = some_pair(variant, draw);
  const double u = speed * std::cos(angle);
  const double share = speed * std::sin(angle) / (pair.friction.mu_s * (1.0 + pair.e) * u);
  return with_velocities(pair, u, share, draw);
}

std::vector<Hit> extreme_hits(int variant, Draw& draw) {
  const Hit graze = grazing(variant, 89.9, draw);
  const Hit parting = grazing(variant, 120.0, draw);
  Hit touching = head_on(variant, draw);
  touching.v_j = touching.v_i + Vector3d(0.0, 1.0, 1.0);
  // Head-on, where nothing slips: without friction, and where J = 0.
  Hit smooth = head_on(variant, draw), leaving = head_on(variant, draw);
  smooth.friction = {};
  std::swap(leaving.v_i, leaving.v_j);
  const Hit just_sticks = oblique(variant, 1.0 - 1e-6, draw), just_slides = oblique(variant, 1.0 + 1e-6, draw);
  Hit dust = oblique(variant, 0.15, draw);
  dust.m_i *= 1e-15;
  dust.m_j *= 1e-14;
  return {dust, just_sticks, graze, parting, touching, just_slides, smooth, leaving};
}

Line extreme(const char* name, double absolute, void (*add)(Line&, const Hit&), int variant, Draw& draw) {
  Line line{.name = name, .points = 2.0, .relative = 1e-10, .absolute = absolute};
  line.otherwise =
      "compare u with 0 and m* |w_t| with mu_s |J| as they are: no small number belongs into a comparison, a mass or a "
      "length";
  for (const Hit& hit : limit_hits(variant, draw)) add(line, hit);
  for (const Hit& hit : extreme_hits(variant, draw)) add(line, hit);
  return line;
}

// Impulses of dust, 1e-15 N s, are compared too: no more than their rounding is allowed.
constexpr double rounding_of_dust = 1e-27;

Line extreme_normal_impulse(int variant, Draw& draw) {
  return extreme("normal_impulse: limits and extremes", rounding_of_dust, add_normal_impulse, variant, draw);
}

Line extreme_friction_impulse(int variant, Draw& draw) {
  return extreme("friction_impulse: limits and extremes", rounding_of_dust, add_friction_impulse, variant, draw);
}

Line extreme_impact(int variant, Draw& draw) {
  return extreme("impact: limits and extremes", 1e-12, add_impact, variant, draw);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string hit = "m_i v_i[3] m_j v_j[3] n[3] e mu_s mu_d";
  return grading::run(argc, argv,
                      {.title = "Chapter 2: the impact of two bodies with friction",
                       .variants = {"both bodies move", "body j is driven, its velocity stays as it is"},
                       .lines = {normal_line, plain_normal_impulse, extreme_normal_impulse, plain_friction_impulse,
                                 extreme_friction_impulse, plain_impact, extreme_impact, conservation},
                       .calls = {{"normal", "degrees -> n[3]"},
                                 {"normal_impulse", hit + " -> J"},
                                 {"friction_impulse", hit + " -> P[3]"},
                                 {"impact", hit + " -> v_i'[3] v_j'[3]"}}});
}
