#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include "grading.hpp"

using grading::Answers;
using grading::Draw;
using grading::Finding;
using grading::Line;
using grading::Mistake;
using grading::Question;

namespace {

using Eigen::Index;
using Found = std::optional<Finding>;

// More than what the rounding of parameters of about 1 comes to.
constexpr double rounding = 1e-12;

// How many strings are asked for.
struct Numbers {
  Index K, S;
};

// What came of one call: strings before and after it, one a column, of three parameters.
struct Mated {
  Index K, S;
  bool is_resized;
  Eigen::MatrixXd before, after;

  Mated(const Numbers& of, const std::vector<double>& answer)
      : K(of.K),
        S(of.S),
        is_resized(answer[0] != 3.0 || answer[1] != static_cast<double>(of.S)),
        before(Eigen::Map<const Eigen::MatrixXd>(answer.data() + 2, 3, of.S)),
        after(Eigen::Map<const Eigen::MatrixXd>(answer.data() + 2 + 3 * of.S, 3, of.S)) {}

  bool is_made(Index child) const { return after.col(K + child) != before.col(K + child); }
};

// The parents of a child, all counted from 0.
std::pair<Index, Index> parents_of(int variant, Index child, Index K) {
  if (variant == 1) return {child - child % 2, child - child % 2 + 1};
  return {child, (child + 1) % K};
}

// Where a child is farthest outside the box that two strings span, and how far; no farther than 0: inside.
struct Place {
  Index parameter;
  double outside;
};

Place place_of(const Mated& mated, Index child, const std::pair<Index, Index>& parents) {
  const Eigen::Array3d c = mated.after.col(mated.K + child), a = mated.before.col(parents.first),
                       b = mated.before.col(parents.second);
  Place place{0, -1.0};
  for (Index k = 0; k < 3; ++k) {
    const double outside = std::max(std::min(a[k], b[k]) - c[k], c[k] - std::max(a[k], b[k]));
    // What is no number is outside.
    if (!(outside <= place.outside)) {
      place = {k, std::isnan(outside) ? std::numeric_limits<double>::infinity() : outside};
    }
  }
  return place;
}

// Every child between its parents but for so much, or what is wrong with the first that is not, with a hint of how far
// it is outside.
template <class Hint>
Found between_parents(const Mated& mated, int variant, double but_for, const Hint& hint) {
  for (Index child = 0; child < mated.K; ++child) {
    const auto [i, j] = parents_of(variant, child, mated.K);
    const auto [k, outside] = place_of(mated, child, {i, j});
    if (outside <= but_for) continue;
    return Finding{
        .expected =
            fmt::format("parameter {} of child {}, string {}, between {:.17g} and {:.17g} of the parents {} and {}", k,
                        child, mated.K + child, mated.before(k, i), mated.before(k, j), i, j),
        .obtained = fmt::format("{:.17g}", mated.after(k, mated.K + child)),
        .hint = mated.is_made(child) ? hint(outside) : "this child was not made: mend the first line of the table"};
  }
  return std::nullopt;
}

// Who is there after the call: its own line, whatever the children are.
Found children_and_others(const Mated& mated) {
  const auto [K, S] = Numbers{mated.K, mated.S};
  const std::string expected =
      fmt::format("{} children in the strings {} to {}, and all others as they were", K, K, 2 * K - 1);
  if (mated.is_resized) return Finding{expected, "strings of another number", "children replace strings: resize none"};
  if (mated.after == mated.before) return Finding{expected, "no string was changed", "is this still the stub?"};
  if (!mated.after.allFinite()) return Finding{expected, "a string that is not finite", "look for 0/0 and overflow"};
  for (Index n = 0; n < S; ++n) {
    const bool is_child = n >= K && n < 2 * K, is_changed = mated.after.col(n) != mated.before.col(n);
    if (is_child == is_changed) continue;
    const std::string obtained = fmt::format("string {} was {}", n, is_changed ? "changed" : "left as it was");
    if (is_child) return Finding{expected, obtained, "fewer children than asked for: there are as many as parents"};
    if (n < K) {
      return Finding{expected, obtained,
                     "a parent was changed in place: parents are kept, that the best cost may never rise. Where you "
                     "write `auto a = strings.col(i)`, a is no copy: write Eigen::VectorXd"};
    }
    return Finding{expected, obtained, "more children than asked for: what lies behind them is not yours"};
  }
  return std::nullopt;
}

// With two parents a child can be wrong by its shares alone. With more, it may be another pair's.
std::string hint_to_pairs(const Mated& mated, int variant) {
  if (mated.K == 2) {
    return "a child outside the box of its parents: Phi must lie in [0, 1], and the two shares must be Phi and 1 - Phi";
  }
  const int other = 3 - variant;
  if (between_parents(mated, other, rounding, [](double) { return std::string(); })) {
    return "its parents are not neighbours in rank, or not those of this child: the brief says whose child is which";
  }
  return "these are the pairs of the other variant";
}

Found between_its_parents(const Mated& mated, int variant) {
  return between_parents(mated, variant, rounding, [&](double) { return hint_to_pairs(mated, variant); });
}

// Parents that are all alike have one child: themselves, to the last bit.
Found same_as_its_parents(const Mated& mated, int variant) {
  return between_parents(mated, variant, 0.0, [](double outside) -> std::string {
    if (outside > rounding) return "of parents that are alike the child is the same: the two shares must add up to 1";
    return "off by a rounding, which takes a string out of bounds: std::clamp() keeps each parameter between those of "
           "the parents";
  });
}

template <class Holds>
Question ask(const Numbers& of, double spread, Draw& draw, const Holds& holds) {
  Question question{
      .function = "mate",
      .inputs = {static_cast<double>(of.K), static_cast<double>(of.S), spread, 1.0 + draw.one_of(1000000)},
      .count = static_cast<std::size_t>(2 + 6 * of.S)};
  question.holds = [of, holds](const Answers& answers, std::size_t own) { return holds(Mated(of, answers[own])); };
  return question;
}

// Both variants, where one alone takes an odd number of parents.
Numbers some(int variant) { return variant == 1 ? Numbers{10, 24} : Numbers{9, 24}; }

Line children_line(int variant, Draw& draw) {
  Line line{.name = "children: as many as parents, and nothing else changed", .points = 3.0, .relative = 0.0};
  for (const Numbers& of : {Numbers{2, 4}, Numbers{6, 20}, some(variant)}) {
    line.questions.push_back(ask(of, 1.0, draw, children_and_others));
  }
  return line;
}

// Two parents thrice: two children of parents in three parameters could lie between them by chance.
Line pairs_line(int variant, Draw& draw) {
  Line line{.name = "pairs: each child between its own parents", .points = 4.0, .relative = 0.0, .absolute = rounding};
  for (const Numbers& of : {Numbers{2, 4}, Numbers{2, 4}, Numbers{2, 4}, Numbers{6, 20}, some(variant)}) {
    line.questions.push_back(
        ask(of, 1.0, draw, [variant](const Mated& mated) { return between_its_parents(mated, variant); }));
  }
  return line;
}

// A rounding shows in every other parameter of such parents.
Line alike_line(int variant, Draw& draw) {
  Line line{.name = "parents that are alike: the same child, to the last bit", .points = 2.0, .relative = 0.0};
  for (const Numbers& of : {Numbers{2, 4}, Numbers{20, 40}}) {
    line.questions.push_back(
        ask(of, 0.0, draw, [variant](const Mated& mated) { return same_as_its_parents(mated, variant); }));
  }
  return line;
}

// A mean over children that are independent of one another, and its law. A right answer is farther than six standard
// errors from it once in 500 million.
Line law_line(const char* name, double points, const char* function, double expected, double variance,
              const std::vector<Mistake>& mistakes, Draw& draw) {
  constexpr double K = 20.0, calls = 10000.0;
  Line line{.name = name, .points = points, .relative = 0.0, .absolute = 6.0 * std::sqrt(2.0 * variance / (K * calls))};
  line.questions = {{.function = function,
                     .inputs = {K, calls, 1.0 + draw.one_of(1000000)},
                     .expected = {expected},
                     .mistakes = mistakes,
                     .otherwise =
                         "mend what the lines above say first; then Phi must be uniform in [0, 1], drawn anew for "
                         "each parameter of each child"}};
  return line;
}

// With parameters a, b of 1 or -1 by chance, c = Phi a + (1 - Phi) b has E[c^2] = E[Phi^2 + (1 - Phi)^2] = 2/3 and
// E[c^4] = E[Phi^4 + (1 - Phi)^4 + 6 Phi^2 (1 - Phi)^2] = 2/5 + 6/30 = 3/5.
Line variance_line(int, Draw& draw) {
  const std::vector<Mistake> mistakes{
      {{1.0 / 2.0}, "Phi is always 1/2: it must be drawn"},
      {{1.0}, "children have each parameter of the one parent or of the other: Phi is any number from 0 to 1"},
      {{7.0 / 6.0}, "Phi lies outside [0, 1], in [-1/2, 3/2]: children leave the box of their parents"},
      {{5.0 / 3.0}, "Phi lies outside [0, 1], in an interval of length 2: children leave the box of their parents"},
      {{1.0 / 3.0},
       "half of what must be: one of the two terms, Phi a and (1 - Phi) b, or every other child is missing"}};
  return law_line("spread: a child has 2/3 of its parents' variance", 3.0, "mean_of_squares", 2.0 / 3.0,
                  3.0 / 5.0 - 4.0 / 9.0, mistakes, draw);
}

// Two parameters are independent, so that moments are products of theirs. With one Phi for both, E[c1^2 c2^2] =
// E[(Phi^2 + (1 - Phi)^2)^2] = 2/5 + 2/30 = 7/15.
Line parameters_line(int, Draw& draw) {
  const std::vector<Mistake> mistakes{
      {{7.0 / 15.0}, "7/15: Phi is shared by the parameters of a child; draw it anew for each of them"}};
  return law_line("parameters: each has a Phi of its own, 4/9", 4.0, "mean_of_squares_of_two_parameters", 4.0 / 9.0,
                  9.0 / 25.0 - 16.0 / 81.0, mistakes, draw);
}

// Variant 1: siblings c, c' have E[c c'] = E[Phi Phi' + (1 - Phi)(1 - Phi')] = 1/2. With p = 2 Phi - 1, c c' is 1 where
// a = b, and p p' where not, so that E[(c c')^2] = (1 + 1/9)/2 = 5/9. Variant 2: they share b alone, E[c c'] =
// E[(1 - Phi) Phi'] = 1/4, and of the products of signs in (c c')^2 none but squares have a mean: (2/3)^2.
Line children_apart_line(int variant, Draw& draw) {
  const std::string shared = "Phi is shared by children: draw it anew for each of them",
                    other = "this is what children of the other variant's pairs have in common, or of one parent alone";
  const std::vector<Mistake> siblings{
      {{2.0 / 3.0}, shared},
      {{1.0 / 3.0}, "the second child of a pair takes 1 - Phi of the first: draw it anew"},
      {{1.0 / 4.0}, other},
      {{7.0 / 12.0}, "the second child of a pair is made of the first: a parent was changed in place"}};
  const std::vector<Mistake> in_a_row{{{1.0 / 6.0}, shared}, {{1.0 / 2.0}, other}};
  const bool is_first = variant == 1;
  return law_line(is_first ? "siblings: each has a Phi of its own, 1/2" : "children: each has a Phi of its own, 1/4",
                  4.0, "mean_product_of_two_children", is_first ? 1.0 / 2.0 : 1.0 / 4.0,
                  is_first ? 5.0 / 9.0 - 1.0 / 4.0 : 4.0 / 9.0 - 1.0 / 16.0, is_first ? siblings : in_a_row, draw);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mean = "K calls seed -> mean";
  return grading::run(
      argc, argv,
      {.title = "Chapter 5: the mating step",
       .variants = {"parents mate by twos, 0 and 1, 2 and 3, ...: two children a pair",
                    "all neighbours mate, and the last with the first: one child a pair"},
       .lines = {children_line, pairs_line, alike_line, variance_line, parameters_line, children_apart_line},
       .calls = {{"mate", "K S spread seed -> parameters strings ... x"},
                 {"mean_of_squares", mean},
                 {"mean_of_squares_of_two_parameters", mean},
                 {"mean_product_of_two_children", mean}}});
}
