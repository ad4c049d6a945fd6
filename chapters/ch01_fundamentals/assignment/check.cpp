#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/kinematics/central_force.hpp>

#include "grading.hpp"

using grading::Answers;
using grading::Draw;
using grading::Finding;
using grading::Line;
using grading::Mistake;
using grading::Question;

namespace {

namespace kinematics = particulate::kinematics;

// The constants as the student gets them, and the law they belong to.
struct Pair {
  int variant = 1;
  double alpha1 = 0.0, alpha2 = 0.0, beta1 = 0.0, beta2 = 0.0;
};

// C = alpha1 d^p - alpha2 d^q, whatever the signs of the exponents.
struct Powers {
  double alpha1 = 0.0, p = 0.0, alpha2 = 0.0, q = 0.0;
};

Powers powers(const Pair& pair) {
  return {pair.alpha1, pair.variant == 1 ? -pair.beta1 : pair.beta1, pair.alpha2, -pair.beta2};
}

kinematics::CentralForce library_law(const Pair& pair) {
  return {.alpha1 = pair.alpha1, .alpha2 = pair.alpha2, .beta1 = pair.beta1, .beta2 = pair.beta2};
}

double sum(const Powers& law, double d) { return law.alpha1 * std::pow(d, law.p) - law.alpha2 * std::pow(d, law.q); }

double strength(const Pair& pair, double d) {
  return pair.variant == 1 ? kinematics::strength(library_law(pair), d) : sum(powers(pair), d);
}

// The work against the force by quadrature: Gauss's three points on many short pieces of ln d.
double work_by_quadrature(const Powers& law, double d, double d_ref) {
  constexpr int pieces = 4000;
  const double node = std::sqrt(0.6), half = 0.5 * std::log(d / d_ref) / pieces;
  double work = 0.0;
  for (int k = 0; k < pieces; ++k) {
    const double middle = std::log(d_ref) + (2 * k + 1) * half;
    for (const auto& [x, weight] :
         {std::pair{-node, 5.0 / 9.0}, std::pair{0.0, 8.0 / 9.0}, std::pair{node, 5.0 / 9.0}}) {
      const double at = std::exp(middle + x * half);
      work += weight * half * at * sum(law, at);
    }
  }
  return work;
}

double integral_of_power(double exponent, double d, double d_ref) {
  const double next = exponent + 1.0, logarithm = std::log(d / d_ref);
  return next == 0.0 ? logarithm : std::pow(d_ref, next) * std::expm1(next * logarithm) / next;
}

// The library does not know the second variant's law: its closed form stands here, and quadrature vouches for it.
double potential(const Pair& pair, double d, double d_ref) {
  if (pair.variant == 1) return kinematics::potential(library_law(pair), d, d_ref);
  const Powers law = powers(pair);
  const double attraction = law.alpha1 * integral_of_power(law.p, d, d_ref);
  const double repulsion = law.alpha2 * integral_of_power(law.q, d, d_ref);
  const double closed = attraction - repulsion, size = std::abs(attraction) + std::abs(repulsion);
  const double work = work_by_quadrature(law, d, d_ref);
  if (!(std::abs(work - closed) <= 1e-11 * size)) {
    throw std::logic_error(fmt::format("the check is wrong: quadrature gives {}, the closed form {}", work, closed));
  }
  return closed;
}

double equilibrium_distance(const Pair& pair) {
  if (pair.variant == 1) return kinematics::equilibrium_distance(library_law(pair));
  return std::pow(pair.alpha2 / pair.alpha1, 1.0 / (pair.beta1 + pair.beta2));
}

double stiffness(const Pair& pair) {
  const double d_e = equilibrium_distance(pair);
  if (pair.variant == 1) return kinematics::normal_stiffness(library_law(pair), d_e);
  return pair.alpha1 * pair.beta1 * std::pow(d_e, pair.beta1 - 1.0) +
         pair.alpha2 * pair.beta2 * std::pow(d_e, -pair.beta2 - 1.0);
}

double period_of(double mass, double stiffness) { return 2.0 * std::numbers::pi * std::sqrt(mass / stiffness); }

double period(const Pair& pair, double m_i, double m_j) {
  if (pair.variant == 1) return kinematics::small_oscillation_period(library_law(pair), m_i, m_j);
  return period_of(kinematics::reduced_mass(m_i, m_j), stiffness(pair));
}

std::vector<double> inputs(const Pair& pair, std::vector<double> more = {}) {
  std::vector<double> all{pair.alpha1, pair.alpha2, pair.beta1, pair.beta2};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// The same constants under the law of the other variant.
Pair other(Pair pair) {
  pair.variant = 3 - pair.variant;
  return pair;
}

const std::string other_variant =
    "this is the law of the other variant: the head of the table says which one belongs to this student";

Question ask_strength(const Pair& pair, double d) {
  const Powers law = powers(pair);
  return {.function = "strength",
          .inputs = inputs(pair, {d}),
          .expected = {strength(pair, d)},
          .mistakes = {
              {{sum({law.alpha1, law.p, -law.alpha2, law.q}, d)}, "sign: repulsion is subtracted from attraction"},
              {{-strength(pair, d)}, "sign of the whole: attraction is positive, so C is positive at large distances"},
              {{sum({law.alpha1, law.q, law.alpha2, law.p}, d)},
               "swapped exponents: beta1 belongs to alpha1, beta2 to alpha2"},
              {{sum({law.alpha1, -law.p, law.alpha2, -law.q}, d)},
               "signs of the exponents: compare them with the formula of your variant"},
              {{strength(other(pair), d)}, other_variant}}};
}

// Both terms of the potential without what is subtracted at d_ref.
double without_reference(const Powers& law, double d) {
  return law.alpha1 * std::pow(d, law.p + 1.0) / (law.p + 1.0) - law.alpha2 * std::pow(d, law.q + 1.0) / (law.q + 1.0);
}

std::vector<Mistake> mistakes_of_potential(const Pair& pair, double d, double d_ref) {
  const Powers law = powers(pair);
  const double right = potential(pair, d, d_ref);
  const double attraction = law.alpha1 * integral_of_power(law.p, d, d_ref);
  const auto bare = [&](double at) {
    return law.alpha1 * std::pow(at, law.p) / (law.p + 1.0) - law.alpha2 * std::pow(at, law.q) / (law.q + 1.0);
  };
  const auto undivided = [&](double at) {
    return law.alpha1 * std::pow(at, law.p + 1.0) - law.alpha2 * std::pow(at, law.q + 1.0);
  };
  const std::string reference = "V is measured from d_ref: subtract V(d_ref), so that potential(law, d_ref, d_ref) = 0";
  return {{{-right}, "sign of the whole: V grows where C attracts, V' = C"},
          {{2.0 * attraction - right}, "sign: the integral of the repulsion is subtracted"},
          {{without_reference(law, d)}, reference},
          {{potential(pair, d, 1.0)}, reference + "; d_ref is not always 1"},
          {{bare(d) - bare(d_ref)}, "exponent: integrating a power raises it by one, d^(1 - beta) for d^-beta"},
          {{undivided(d) - undivided(d_ref)}, "integrating a power divides it by its new exponent"},
          {{potential(other(pair), d, d_ref)}, other_variant}};
}

Question ask_potential(const Pair& pair, double d, double d_ref) {
  return {.function = "potential",
          .inputs = inputs(pair, {d, d_ref}),
          .expected = {potential(pair, d, d_ref)},
          .mistakes = mistakes_of_potential(pair, d, d_ref)};
}

// Where a power of d integrates to a logarithm, or almost.
Question ask_potential_at_limit(const Pair& pair, double d, double d_ref) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string at_one = "beta = 1 divides by zero: the integral of 1/d is a logarithm";
  Question question{
      .function = "potential",
      .inputs = inputs(pair, {d, d_ref}),
      .expected = {potential(pair, d, d_ref)},
      .mistakes = {{{nan}, at_one}, {{infinity}, at_one}, {{-infinity}, at_one}},
      .otherwise =
          "close to beta = 1 a difference of powers cancels, and away from it a logarithm alone is wrong: "
          "write d^x - d_ref^x as d_ref^x (e^(x ln(d/d_ref)) - 1), and use std::expm1"};
  for (const Mistake& mistake : mistakes_of_potential(pair, d, d_ref)) question.mistakes.push_back(mistake);
  return question;
}

std::vector<Mistake> mistakes_of_equilibrium(const Pair& pair) {
  const double d_e = equilibrium_distance(pair), ratio = pair.alpha2 / pair.alpha1;
  const Powers law = powers(pair);
  return {{{1.0 / d_e}, "d_e is upside down: more repulsion (alpha2) or less attraction pushes further apart"},
          {{ratio}, "C = 0 gives a power of d_e: take the root"},
          {{std::pow(ratio, law.p - law.q)}, "the exponent of alpha2/alpha1 in d_e is upside down"},
          {{equilibrium_distance(other(pair))}, other_variant}};
}

Question ask_equilibrium(const Pair& pair) {
  return {.function = "equilibrium_distance",
          .inputs = inputs(pair),
          .expected = {equilibrium_distance(pair)},
          .mistakes = mistakes_of_equilibrium(pair)};
}

// C'(d), its terms multiplied by numbers of their own.
double slope(const Powers& law, double d, double of_attraction, double of_repulsion) {
  return of_attraction * law.alpha1 * std::pow(d, law.p - 1.0) - of_repulsion * law.alpha2 * std::pow(d, law.q - 1.0);
}

std::vector<Mistake> mistakes_of_stiffness(const Pair& pair) {
  const double k = stiffness(pair), d_e = equilibrium_distance(pair);
  const Powers law = powers(pair);
  const double one = std::copysign(1.0, law.p);
  const std::string missing = "differentiating a power multiplies it by its exponent: ";
  std::vector<Mistake> all{
      {{-k},
       "sign: at a stable equilibrium V'' is positive; each term is multiplied by its own exponent, with its sign"},
      {{slope(law, d_e, one, law.q)}, missing + "the factor beta1 is missing in V''"},
      {{slope(law, d_e, law.p, -1.0)}, missing + "the factor beta2 is missing in V''"},
      {{slope(law, d_e, one, -1.0)}, missing + "the factors beta1 and beta2 are missing in V''"},
      {{slope(law, d_e, -law.p, law.q)}, "sign of the first term of V'': differentiate alpha1 d^p, p with its sign"},
      {{slope(law, d_e, law.p, -law.q)}, "sign of the second term of V'': the slope of -alpha2 d^-beta2 is positive"},
      {{k * d_e}, "exponent: differentiating a power lowers it by one"},
      {{strength(pair, d_e)}, "this is V', the strength: V'' is its slope"},
      {{stiffness(other(pair))}, other_variant}};
  for (const Mistake& mistake : mistakes_of_equilibrium(pair)) {
    all.push_back({{slope(law, mistake.gives.front(), law.p, law.q)}, mistake.hint});
  }
  return all;
}

// With the student's own d_e.
Question ask_stiffness(const Pair& pair) {
  return {
      .function = "stiffness",
      .inputs = inputs(pair),
      .expected = {stiffness(pair)},
      .mistakes = mistakes_of_stiffness(pair),
      .built_on = 1,
      .with_own = [law = powers(pair)](const Answers& own) { return Answers{{slope(law, own[0][0], law.p, law.q)}}; }};
}

// With the student's own stiffness.
Question ask_period(const Pair& pair, double m_i, double m_j) {
  const double T = period(pair, m_i, m_j), k = stiffness(pair);
  const std::string reduced =
      "both bodies move: take the reduced mass m_i m_j / (m_i + m_j), not one mass or their sum";
  Question question{
      .function = "period",
      .inputs = inputs(pair, {m_i, m_j}),
      .expected = {T},
      .mistakes = {{{period_of(m_i, k)}, reduced},
                   {{period_of(m_j, k)}, reduced},
                   {{period_of(m_i + m_j, k)}, reduced},
                   {{period_of(0.5 * (m_i + m_j), k)}, reduced},
                   {{T / std::numbers::sqrt2}, "factor sqrt 2: the reduced mass holds no factor 1/2 of its own"},
                   {{T * std::numbers::sqrt2}, "factor sqrt 2: the reduced mass is m/2 for equal masses m"},
                   {{0.5 * T / std::numbers::pi}, "factor 2 pi: the period is 2 pi over the angular frequency"},
                   {{1.0 / T}, "this is the frequency: the period is its inverse"},
                   {{2.0 * std::numbers::pi / T}, "this is the angular frequency: the period is 2 pi over it"},
                   {{T * T / (2.0 * std::numbers::pi)}, "the root is missing: T = 2 pi sqrt(m*/V'')"},
                   {{period(other(pair), m_i, m_j)}, other_variant}},
      .built_on = 1,
      .with_own = [pair, m_i, m_j](const Answers& own) {
        return Answers{{period_of(kinematics::reduced_mass(m_i, m_j), own[0][0])}};
      }};
  for (const Mistake& mistake :
       grading::rough_pi([&](double pi) { return std::vector<double>{T * pi / std::numbers::pi}; })) {
    question.mistakes.push_back(mistake);
  }
  // A wrong stiffness shows here too.
  for (const Mistake& mistake : mistakes_of_stiffness(pair)) {
    const double wrong = T * std::sqrt(k / mistake.gives.front());
    if (std::isfinite(wrong)) question.mistakes.push_back({{wrong}, mistake.hint});
  }
  return question;
}

// Asked for what is built on it: it has lines of its own.
Question unjudged(Question question) {
  question.is_judged = false;
  return question;
}

void add_stiffness(Line& line, const Pair& pair) {
  line.questions.push_back(unjudged(ask_equilibrium(pair)));
  line.questions.push_back(ask_stiffness(pair));
}

void add_period(Line& line, const Pair& pair, double m_i, double m_j) {
  line.questions.push_back(unjudged(ask_stiffness(pair)));
  line.questions.push_back(ask_period(pair, m_i, m_j));
}

// Whole exponents, to be checked by hand. Neither they nor what integration makes of them is 1, so that no factor can
// be left out; with beta2 = 2 beta1 - 1 a stiffness without beta2 would look like a wrong sign.
Pair plain_pair(int variant, Draw& draw) {
  const double beta1 = variant == 1 ? 3.0 : 2.0;
  const double beta2 = variant == 1 ? 7.0 + draw.one_of(2) : 3.0 + 3.0 * draw.one_of(2);
  return {variant, draw.between(1.0, 2.0), draw.between(3.0, 5.0), beta1, beta2};
}

Line plain(const char* name, double points, std::vector<Question> questions = {}) {
  return {.name = name, .points = points, .relative = 1e-10, .questions = std::move(questions)};
}

Line plain_strength(int variant, Draw& draw) {
  const Pair pair = plain_pair(variant, draw);
  return plain("strength: close and far", 2.0,
               {ask_strength(pair, draw.between(0.4, 0.7)), ask_strength(pair, draw.between(6.0, 9.0))});
}

Line plain_potential(int variant, Draw& draw) {
  const Pair pair = plain_pair(variant, draw);
  const double d = draw.between(0.4, 0.7);
  return plain("potential: whole exponents", 3.0, {ask_potential(pair, d, draw.between(1.2, 1.6))});
}

Line plain_equilibrium(int variant, Draw& draw) {
  const Pair pair = plain_pair(variant, draw), close{variant, pair.alpha1, 1e-12 * pair.alpha2, pair.beta1, 13.0};
  return plain("equilibrium_distance: far and close", 2.0, {ask_equilibrium(pair), ask_equilibrium(close)});
}

Line plain_stiffness(int variant, Draw& draw) {
  Line line = plain("stiffness: whole exponents", 2.0);
  add_stiffness(line, plain_pair(variant, draw));
  return line;
}

Line plain_period(int variant, Draw& draw) {
  Line line = plain("period: whole exponents", 2.0);
  const Pair pair = plain_pair(variant, draw);
  const double m_i = draw.between(1.0, 2.0);
  add_period(line, pair, m_i, draw.between(3.0, 6.0));
  return line;
}

Line potential_at_one(int variant, Draw& draw) {
  const double alpha1 = draw.between(1.0, 2.0), alpha2 = draw.between(3.0, 5.0), d_ref = draw.between(1.2, 1.6);
  const double d = draw.between(0.3, 0.5);
  const double other_beta = variant == 1 ? draw.between(2.5, 3.5) : draw.between(1.5, 2.5);
  Line line{.name = "potential: exponents at and near 1", .points = 3.0, .relative = 1e-8};
  for (const double beta : {1.0, 1.0 - 1e-11, 1.0 + 1e-6}) {
    const Pair pair =
        variant == 1 ? Pair{1, alpha1, alpha2, beta, other_beta} : Pair{2, alpha1, alpha2, other_beta, beta};
    line.questions.push_back(ask_potential_at_limit(pair, d, d_ref));
  }
  const Pair repelling{variant, alpha1, alpha2, 0.5, 1.0};
  line.questions.push_back(ask_potential_at_limit(repelling, d, d_ref));
  return line;
}

// Centred differences of the student's own potential at h and h/2, extrapolated: the error left is of order (h/d)^4.
// The strength is answer `first`, the potentials stand behind it.
std::optional<Finding> slope_is_strength(const Answers& answers, std::size_t first, const Pair& pair, double d,
                                         double d_ref, double h) {
  const double C = answers[first][0];
  const double wide = (answers[first + 1][0] - answers[first + 2][0]) / (2.0 * h);
  const double narrow = (answers[first + 3][0] - answers[first + 4][0]) / h;
  const double slope = (4.0 * narrow - wide) / 3.0;
  const Powers law = powers(pair);
  const double tolerance = 1e-6 * (law.alpha1 * std::pow(d, law.p) + law.alpha2 * std::pow(d, law.q));
  if (std::abs(slope - C) <= tolerance) return std::nullopt;
  const bool opposite = std::abs(slope + C) <= tolerance;
  return Finding{
      .expected = fmt::format("slope of potential() there, with d_ref = {}, is your strength() = {:.10g}", d_ref, C),
      .obtained = fmt::format("slope {:.10g}, by differences of your potential() at d +- {}", slope, h),
      .hint = opposite ? "sign of the whole: V' = C, so that energy is conserved"
                       : "energy is not conserved: differentiate your V by hand, it must give your C"};
}

Line conservation(int variant, Draw& draw) {
  const double alpha1 = draw.between(1.0, 2.0), alpha2 = draw.between(3.0, 5.0), d_ref = draw.between(0.8, 1.6);
  const Pair pair{variant, alpha1, alpha2, draw.between(1.2, 1.8), draw.between(2.5, 3.5)};
  const std::array<double, 3> distances{draw.between(0.4, 0.8), draw.between(1.0, 2.0), draw.between(5.0, 9.0)};
  constexpr double h = 0.0078125;
  Line line{.name = "conservation: the potential's slope is the strength", .points = 2.0, .relative = 1e-9};
  // Where the two terms cancel, their rounding is left.
  line.absolute = 1e-11;
  for (const double d : distances) {
    line.questions.push_back(ask_strength(pair, d));
    line.questions.back().holds = [pair, d, d_ref](const Answers& answers, std::size_t first) {
      return slope_is_strength(answers, first, pair, d, d_ref, h);
    };
    for (const double at : {d + h, d - h, d + 0.5 * h, d - 0.5 * h}) {
      line.questions.push_back({.function = "potential", .inputs = inputs(pair, {at, d_ref})});
    }
  }
  return line;
}

// A steep law whose values span forty orders of magnitude.
Pair steep_pair(int variant, Draw& draw) {
  return {variant, draw.between(1.0, 2.0), draw.between(0.1, 0.5), variant == 1 ? 6.0 : 3.0, 13.0};
}

Line extreme(const char* name) {
  Line line = plain(name, 1.0);
  line.otherwise =
      "compare with the formula of the brief, term by term; where the other lines are right: values span forty orders "
      "of magnitude, so use double and std::pow, add no small number to d, and replace no derivative or integral by "
      "differences or sums";
  return line;
}

// Far out one term alone is left: what is wrong with the other shows nearby.
std::array<double, 3> steep_distances(Draw& draw) { return {draw.between(1.1, 1.3), 1e-3, 1e3}; }

Line extreme_strength(int variant, Draw& draw) {
  Line line = extreme("strength: exponent 13, distances from 0.001 to 1000");
  const Pair pair = steep_pair(variant, draw);
  for (const double d : steep_distances(draw)) line.questions.push_back(ask_strength(pair, d));
  return line;
}

Line extreme_potential(int variant, Draw& draw) {
  Line line = extreme("potential: exponent 13, distances from 0.001 to 1000");
  const Pair pair = steep_pair(variant, draw);
  for (const double d : steep_distances(draw)) line.questions.push_back(ask_potential(pair, d, 1.5));
  return line;
}

Pair close_pair(int variant, Draw& draw) {
  Pair pair = steep_pair(variant, draw);
  pair.alpha2 *= 1e-12;
  return pair;
}

Line extreme_stiffness(int variant, Draw& draw) {
  Line line = extreme("stiffness: exponent 13, bodies close together");
  add_stiffness(line, close_pair(variant, draw));
  return line;
}

Line extreme_period(int variant, Draw& draw) {
  Line line = extreme("period: one mass far greater, masses of dust");
  const Pair close = close_pair(variant, draw);
  const double m_i = draw.between(1.0, 2.0);
  add_period(line, close, m_i, 1e30);
  add_period(line, close, 1e-15 * m_i, draw.between(1e-12, 2e-12));
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string law = "alpha1 alpha2 beta1 beta2";
  return grading::run(
      argc, argv,
      {.title = "Chapter 1: potential and equilibrium of a pair",
       .variants = {"C(d) = alpha1 d^-beta1 - alpha2 d^-beta2", "C(d) = alpha1 d^beta1 - alpha2 d^-beta2"},
       .lines = {plain_strength, extreme_strength, plain_potential, potential_at_one, extreme_potential,
                 plain_equilibrium, plain_stiffness, extreme_stiffness, plain_period, extreme_period, conservation},
       .calls = {{"strength", law + " d -> C"},
                 {"potential", law + " d d_ref -> V"},
                 {"equilibrium_distance", law + " -> d_e"},
                 {"stiffness", law + " -> V''"},
                 {"period", law + " m_i m_j -> T"}}});
}
