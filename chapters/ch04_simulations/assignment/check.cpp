#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/kinematics/cells.hpp>
#include <particulate/kinematics/domain.hpp>

#include "cloud.hpp"
#include "grading.hpp"

using Eigen::Vector3d;
using grading::Answers;
using grading::Draw;
using grading::Finding;
using grading::Line;
using grading::mistakes;
using grading::Question;

namespace {

namespace kinematics = particulate::kinematics;
using Cell = cloud::Three<int>;
using Numbers = std::vector<double>;

struct Box {
  Vector3d length = Vector3d::Ones();
  cloud::Three<bool> periodic = {};
};

constexpr cloud::Three<bool> everywhere{true, true, true}, nowhere{false, false, false}, slab{true, true, false};

kinematics::Space space(const Box& box) {
  kinematics::Space space;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Index axis = static_cast<Eigen::Index>(k);
    if (box.periodic[k]) space.lengths[axis] = box.length[axis];
  }
  return space;
}

void append(Numbers& all, const Vector3d& a) { all.insert(all.end(), {a.x(), a.y(), a.z()}); }
void append(Numbers& all, const Cell& cell) { all.insert(all.end(), cell.begin(), cell.end()); }
void append(Numbers& all, const Box& box) {
  append(all, box.length);
  for (const bool repeats : box.periodic) all.push_back(repeats ? 1.0 : 0.0);
}

// In the order in which the driver takes them.
template <class... Parts>
Numbers numbers(const Parts&... parts) {
  Numbers all;
  (append(all, parts), ...);
  return all;
}

// One direction of what is asked: a number, the length of the box, whether it repeats itself, and its cells.
struct Axis {
  double x, length;
  bool periodic;
  int cells = 1;
};

// The answer with a mistake that each direction makes for itself.
template <class OfAxis>
Numbers along_each(const Vector3d& x, const Box& box, const Cell& cells, const OfAxis& of_axis) {
  Numbers all;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Index axis = static_cast<Eigen::Index>(k);
    all.push_back(of_axis(Axis{x[axis], box.length[axis], box.periodic[k], cells[k]}));
  }
  return all;
}

using OfAxis = double (*)(const Axis&);

// Mistakes of the nearest image.
const std::vector<std::pair<OfAxis, std::string>> image_flaws{
    {[](const Axis& a) { return a.x; }, "no image was taken: in periodic directions whole lengths come off d"},
    {[](const Axis& a) { return a.periodic ? a.x + a.length * std::round(a.x / a.length) : a.x; },
     "sign of the image: whole lengths come off d, d - length round(d/length)"},
    {[](const Axis& a) { return a.periodic ? -std::remainder(a.x, a.length) : -a.x; },
     "the sign of d itself is turned: it leads from one body to the other, and so must its image"},
    {[](const Axis& a) { return a.periodic ? a.x - a.length * std::trunc(a.x / a.length) : a.x; },
     "rounding, not cutting off: the nearest image is d - length round(d/length), where trunc(), a cast to int and "
     "fmod() leave more than half a length"},
    {[](const Axis& a) { return a.periodic ? a.x - a.length * std::floor(a.x / a.length) : a.x; },
     "that is a place in the box, from 0 to a length; a separation lies between minus half a length and half of one"},
    {[](const Axis& a) { return std::remainder(a.x, a.length); },
     "a direction in which the box does not repeat itself has no images: leave d as it is there"},
    {[](const Axis& a) { return a.periodic && a.x > 0.5 * a.length ? a.x - a.length : a.x; },
     "two sides: where d < -length/2 a length has to be added"},
    {[](const Axis& a) {
       if (!a.periodic || std::abs(a.x) <= 0.5 * a.length) return a.x;
       return a.x > 0.0 ? a.x - a.length : a.x + a.length;
     },
     "more than one length may have to come off: bodies are not put back into the box when they leave it"},
    {[](const Axis& a) {
       if (!a.periodic || std::abs(a.x) <= a.length) return a.x;
       return std::remainder(a.x, a.length);
     },
     "half a length, not a whole one, is the most that a separation can have"},
    {[](const Axis& a) { return a.periodic ? std::abs(std::remainder(a.x, a.length)) : a.x; },
     "the sign is lost: a component of d may be negative, and so may that of its image"}};

// Mistakes of the number of a cell.
const std::vector<std::pair<OfAxis, std::string>> cell_flaws{
    {[](const Axis& a) {
       const double c = std::trunc(a.x * a.cells / a.length), n = a.cells;
       return a.periodic ? c - n * std::floor(c / n) : std::clamp(c, 0.0, n - 1.0);
     },
     "a cast to int cuts off towards 0: -0.5 belongs to cell -1, not 0; write std::floor() before the cast"},
    {[](const Axis& a) { return std::floor(a.x * a.cells / a.length); },
     "not wrapped: a place may have left the box; in periodic directions it has the cell of its image, in others the "
     "first or the last one"},
    {[](const Axis& a) {
       const double c = std::floor(a.x * a.cells / a.length), n = a.cells;
       return a.periodic ? std::fmod(c, n) : std::clamp(c, 0.0, n - 1.0);
     },
     "the remainder % of a negative number is negative or 0: add the number of cells once more and take it again"},
    {[](const Axis& a) {
       const double c = std::trunc(a.x * a.cells / a.length), n = a.cells;
       return a.periodic ? std::fmod(c, n) : std::clamp(c, 0.0, n - 1.0);
     },
     "negative places: a cast to int cuts off towards 0, where std::floor() is meant, and the remainder % of a "
     "negative "
     "number is negative"},
    {[](const Axis& a) {
       const double c = std::floor(a.x * a.cells / a.length), n = a.cells;
       return c - n * std::floor(c / n);
     },
     "a direction in which the box does not repeat itself has no images: what lies beyond belongs to the first or the "
     "last cell"},
    {[](const Axis& a) {
       const double c = std::floor(a.x * a.cells / a.length), n = a.cells;
       return std::clamp(c, 0.0, n - 1.0);
     },
     "a place that has left the box in a periodic direction has an image in it, in the cell behind the other face"},
    {[](const Axis& a) {
       const double c = std::floor(a.x * a.cells / a.length), n = a.cells;
       return a.periodic ? c - n * std::floor(c / n) : c;
     },
     "where the box does not repeat itself, a place beyond it belongs to the first or the last cell"},
    {[](const Axis& a) {
       const double c = std::round(a.x * a.cells / a.length), n = a.cells;
       return a.periodic ? c - n * std::floor(c / n) : std::clamp(c, 0.0, n - 1.0);
     },
     "cell c reaches from c to c + 1 lengths of a cell: std::floor(), not rounding"},
    {[](const Axis& a) {
       const double c = std::floor(a.x * a.cells / a.length), n = a.cells;
       return 1.0 + (a.periodic ? c - n * std::floor(c / n) : std::clamp(c, 0.0, n - 1.0));
     },
     "cells are counted from 0"}};

// Mistakes of how many cells there are, from the length of the box over that of the shortest cell; those of the two
// variants are mixed up in the last ones.
using Count = double (*)(double exact, int variant);
const std::vector<std::pair<Count, std::string>> count_flaws{
    {[](double x, int) { return std::max(1.0, std::ceil(x)); },
     "cells shorter than they may be: round down, or bodies within reach lie farther apart than the cells that are "
     "looked at"},
    {[](double x, int) { return std::max(1.0, std::round(x)); },
     "cells shorter than they may be: round down, not to the nearest, or bodies within reach lie farther apart than "
     "the "
     "cells that are looked at"},
    {[](double x, int) { return std::floor(x) + 1.0; }, "one cell too many: round down, and take at least 1"},
    {[](double x, int) { return std::max(1.0, std::ceil(x) - 1.0); },
     "one cell too few: where a whole number of cells fits exactly, it fits"},
    {[](double x, int) { return std::floor(x); }, "at least 1: a box shorter than the reach is one cell"},
    {[](double x, int variant) { return std::max(1.0, std::floor(variant == 1 ? 2.0 * x : 0.5 * x)); },
     "these are the cells of the other variant: in variant 1 a cell is at least as long as the reach, in variant 2 as "
     "half of it"},
    {[](double x, int variant) { return std::max(1.0, std::floor(variant == 1 ? 0.5 * x : 0.25 * x)); },
     "cells longer than they need be: the reach is compared with the length of a cell, not with half of it"}};

Question ask_image(const Vector3d& d, const Box& box) {
  return {.function = "nearest_image",
          .inputs = numbers(d, box),
          .expected = numbers(separation(space(box), Vector3d::Zero(), d)),
          .mistakes = mistakes(image_flaws, [&](const OfAxis& flaw) { return along_each(d, box, Cell{}, flaw); }),
          .otherwise = "in a periodic direction d - length round(d/length), with the length of that direction"};
}

Question ask_count(const Box& box, double reach, int variant) {
  const auto with = [&](const Count& count) {
    return along_each(box.length, box, Cell{},
                      [&](const Axis& a) { return count(variant * a.length / reach, variant); });
  };
  Question question{.function = "cells_across", .inputs = numbers(box)};
  question.inputs.push_back(reach);
  question.expected = with([](double x, int) { return std::max(1.0, std::floor(x)); });
  question.mistakes = mistakes(count_flaws, with);
  question.otherwise = "the length of the box over that of the shortest cell, rounded down, and at least 1";
  return question;
}

Question ask_cell(const Vector3d& place, const Box& box, const Cell& cells) {
  const Vector3d home = wrapped(space(box), place);
  return {.function = "cell_of",
          .inputs = numbers(place, box, cells),
          .expected = along_each(
              home, box, cells,
              [](const Axis& a) { return std::clamp(std::floor(a.x * a.cells / a.length), 0.0, a.cells - 1.0); }),
          .mistakes = mistakes(cell_flaws, [&](const OfAxis& flaw) { return along_each(place, box, cells, flaw); }),
          .otherwise = "cell c reaches from c up to c + 1 lengths of a cell, length/cells, in that direction"};
}

// Three lengths of which no two are alike.
Box some_box(const cloud::Three<bool>& periodic, Draw& draw) {
  return {.length = {draw.between(1.0, 1.4), draw.between(2.0, 2.5), draw.between(3.2, 4.0)}, .periodic = periodic};
}

// A vector whose components are so many lengths.
Vector3d lengths(const Box& box, double x, double y, double z) { return box.length.cwiseProduct(Vector3d{x, y, z}); }

Line image_line(int, Draw& draw) {
  Line line{.name = "nearest_image: inside, across faces and corners", .points = 2.0, .absolute = 1e-12};
  const Box all = some_box(everywhere, draw), two = some_box(slab, draw), none = some_box(nowhere, draw);
  const auto share = [&] { return draw.between(0.55, 0.95); };
  const double a = share(), b = share(), c = share();
  line.questions = {ask_image(lengths(all, a, -b, 0.3), all), ask_image(lengths(all, -a, -c, -b), all),
                    ask_image(lengths(all, 0.2, -0.45, 0.4), all), ask_image(lengths(two, -b, c, a), two),
                    ask_image(lengths(none, b, -a, c), none)};
  return line;
}

Line far_image_line(int, Draw& draw) {
  Line line{.name = "nearest_image: many lengths apart", .points = 2.0, .relative = 1e-9, .absolute = 1e-12};
  const Box all = some_box(everywhere, draw), two = some_box(slab, draw);
  const double a = draw.between(0.1, 0.4);
  line.questions = {ask_image(lengths(all, 3.0 + a, -2.0 - a, 1.5 + a), all),
                    ask_image(lengths(two, -7.5 - a, 1.0 - a, 5.0 + a), two),
                    ask_image(lengths(all, -1.0 - a, 2.0 - a, 0.0), all)};
  return line;
}

// A box into which so many times the reach fit in each direction, exactly if they are eighths.
Box box_of(double reach, double x, double y, double z, const cloud::Three<bool>& periodic) {
  return {.length = reach * Vector3d{x, y, z}, .periodic = periodic};
}

double some_reach(Draw& draw) { return (4.0 + draw.one_of(8)) / 8.0; }

Line count_line(int variant, Draw& draw) {
  Line line{.name = "cells_across: long boxes, exact ones, short ones", .points = 2.0};
  const double reach = some_reach(draw), more = 0.125 * draw.one_of(2);
  line.questions = {ask_count(box_of(reach, 5.375 + more, 8.875 - more, 12.125 + more, everywhere), reach, variant),
                    ask_count(box_of(reach, 4.0 + draw.one_of(3), 9.0, 13.0, slab), reach, variant),
                    ask_count(box_of(reach, 0.25, 2.75, 1.0, nowhere), reach, variant)};
  return line;
}

Line cell_line(int, Draw& draw) {
  Line line{.name = "cell_of: inside the box and next to it", .points = 3.0};
  const Box all = some_box(everywhere, draw), two = some_box(slab, draw), none = some_box(nowhere, draw);
  const double a = draw.between(0.02, 0.08);
  const Cell cells{4, 5, 7}, others{6, 3, 4};
  line.questions = {ask_cell(lengths(all, 0.25 + a, 0.8 + a, 3.0 / 7.0 + a), all, cells),
                    ask_cell(lengths(all, -a, -0.2 - a, 1.0 + a), all, cells),
                    ask_cell(lengths(two, 1.0 + a, -0.4 - a, -0.3 - a), two, others),
                    ask_cell(lengths(none, -0.4 - a, 0.9 + a, 1.3 + a), none, others)};
  return line;
}

// A place that is only just behind a face: whether it is rounded into the first or the last cell, it must be a cell.
Question ask_brink(const Box& box, const Cell& cells) {
  Question question = ask_cell(Vector3d::Constant(-1e-20), box, cells);
  question.expected = {};
  question.mistakes = {};
  question.count = 3;
  question.holds = [cells](const Answers& answers, std::size_t own) -> std::optional<Finding> {
    for (std::size_t k = 0; k < 3; ++k) {
      const double c = answers[own][k];
      if (c == 0.0 || c == cells[k] - 1.0) continue;
      return Finding{"the first or the last cell in each direction", fmt::format("cell {} of {}", c, cells[k]),
                     "-1e-20 and a length are a length, by rounding: wrap the number of the cell, after std::floor(), "
                     "rather than the place"};
    }
    return std::nullopt;
  };
  return question;
}

Line far_cell_line(int, Draw& draw) {
  Line line{.name = "cell_of: far outside, on faces and just behind them", .points = 2.0};
  const Box all = some_box(everywhere, draw), two = some_box(slab, draw);
  const Box whole{.length = {4.0, 5.0, 8.0}, .periodic = everywhere};
  const double a = draw.between(0.02, 0.08);
  const Cell cells{4, 5, 8};
  line.questions = {ask_cell(lengths(all, -7.25 - a, 1e5 + 0.4 + a, -1e5 + 0.5 + a), all, cells),
                    ask_cell(lengths(two, 12.5 + a, -3.2 - a, 40.0 + a), two, cells),
                    ask_cell(Vector3d{-1.0, 5.0, 6.0}, whole, cells), ask_brink(all, cells)};
  return line;
}

// A random cloud as it is asked for.
struct Cloud {
  Box box;
  Cell cells;
  double reach;
  int seed, N;
};

using Pairs = std::vector<std::pair<int, int>>;

Pairs pairs_by_library(const Cloud& of) {
  const kinematics::Space domain = space(of.box);
  const auto shares = cloud::shares(static_cast<std::uint64_t>(of.seed), static_cast<std::size_t>(of.N));
  kinematics::Cells cells(domain, of.box.length, of.reach, of.N);
  std::vector<Vector3d> places;
  for (const auto& one : shares) {
    places.push_back(lengths(of.box, one[0], one[1], one[2]));
    cells.insert(static_cast<Eigen::Index>(places.size()) - 1, places.back(), 0.5 * of.reach);
  }
  Pairs pairs;
  for (int i = 0; i < of.N; ++i) {
    const Vector3d& place = places[static_cast<std::size_t>(i)];
    cells.near(place, 0.5 * of.reach, 0, [&](const kinematics::Cells::Body& body) {
      const bool is_near = body.index > i && kinematics::length(separation(domain, place, body.place)) <= of.reach;
      if (is_near) pairs.emplace_back(i, body.index);
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// What is wrong with a list of pairs, and where to look for it.
class Judge {
 public:
  Judge(const Cloud& of, int layers) : cloud_(of), layers_(layers), right_(pairs_by_library(of)) {
    for (const auto& share : cloud::shares(static_cast<std::uint64_t>(of.seed), static_cast<std::size_t>(of.N))) {
      cells_.push_back(cloud::cell(share, of.cells));
    }
  }

  std::optional<Finding> operator()(const Numbers& answer) const {
    const double given = answer.front();
    const std::string expected = fmt::format("{} pairs", right_.size()), obtained = fmt::format("{} pairs", given);
    if (given == 0.0 && !right_.empty()) return Finding{expected, "none", "no pair was found: is this still the stub?"};
    Pairs pairs;
    for (std::size_t k = 1; k + 1 < answer.size() && static_cast<double>(pairs.size()) < given; k += 2) {
      pairs.emplace_back(static_cast<int>(answer[k]), static_cast<int>(answer[k + 1]));
    }
    if (given == static_cast<double>(right_.size()) && pairs == right_) return std::nullopt;
    for (const auto& [i, j] : pairs) {
      const std::string pair = fmt::format("i = {}, j = {}", i, j);
      if (i == j) return Finding{"i < j", pair, "a body is no pair with itself, though it lies in its own cell"};
      if (i > j) return Finding{"i < j", pair, "each pair is named by its smaller number first"};
    }
    Pairs sorted = pairs;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) return Finding{"each pair once", named(*twice) + " twice or more", hint_to_twice()};
    for (const auto& pair : pairs) {
      if (std::binary_search(right_.begin(), right_.end(), pair)) continue;
      return Finding{expected, named(pair) + ", which are not within reach",
                     "a pair belongs into the list only if is_near() says so, with the numbers of the bodies"};
    }
    Pairs lost;
    std::set_difference(right_.begin(), right_.end(), sorted.begin(), sorted.end(), std::back_inserter(lost));
    if (!lost.empty()) return Finding{expected, obtained + ", without " + named(lost.front()), hint_to_lost(lost)};
    return Finding{"pairs ascending by i, then by j", "the right pairs in another order", "sort what you have found"};
  }

 private:
  const Cell& cell(int i) const { return cells_[static_cast<std::size_t>(i)]; }

  std::string named(const std::pair<int, int>& pair) const {
    const auto text = [&](int i) {
      if (i < 0 || i >= cloud_.N) return fmt::format("{}, which is no body", i);
      return fmt::format("{} in cell ({}, {}, {})", i, cell(i)[0], cell(i)[1], cell(i)[2]);
    };
    return fmt::format("i = {}, j = {}", text(pair.first), text(pair.second));
  }

  std::string hint_to_twice() const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cloud_.box.periodic[k] && cloud_.cells[k] < 2 * layers_ + 1) {
        return fmt::format(
            "few cells: where there are fewer than {} in a periodic direction, the same one is met on both sides, or "
            "again as the own one; visit each cell once",
            2 * layers_ + 1);
      }
    }
    return "each pair was found from both of its cells: keep it only where i < j, or look at half of the neighbours";
  }

  // How many cells apart, at most of all directions; across faces of the box where it repeats itself, or not.
  int apart(const std::pair<int, int>& pair, bool wraps) const {
    int most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int d = std::abs(cell(pair.first)[k] - cell(pair.second)[k]);
      most = std::max(most, wraps && cloud_.box.periodic[k] ? std::min(d, cloud_.cells[k] - d) : d);
    }
    return most;
  }

  // The one mistake that all lost pairs have in common.
  std::string hint_to_lost(const Pairs& lost) const {
    const auto all = [&](const auto& test) { return std::all_of(lost.begin(), lost.end(), test); };
    if (all([&](const auto& pair) { return apart(pair, false) == 0; })) {
      return "the own cell is forgotten: bodies in the same cell are pairs, too";
    }
    if (all([&](const auto& pair) { return apart(pair, false) > layers_; })) {
      return "neighbours are not wrapped: behind the last cell of a periodic direction comes the first, and before the "
             "first the last";
    }
    if (all([&](const auto& pair) { return apart(pair, true) > 1; })) {
      return "cells are half as long as the reach here: two layers of neighbours, 5 x 5 x 5 cells, must be looked at";
    }
    return "some neighbours are not looked at: there are 26 around a cell, over faces, edges and corners (124 in two "
           "layers); half of them will do if it holds one of any two that lie opposite";
  }

  Cloud cloud_;
  int layers_;
  Pairs right_;
  std::vector<Cell> cells_;
};

// Room for more pairs than any of the small clouds has.
constexpr std::size_t room = 1201;

Numbers inputs(const Cloud& of) {
  Numbers all = numbers(of.box, of.cells);
  all.insert(all.end(), {of.reach, static_cast<double>(of.seed), static_cast<double>(of.N)});
  return all;
}

Question ask_pairs(const Cloud& of, int variant) {
  Question question{.function = "near_pairs", .inputs = inputs(of), .count = room};
  question.inputs.push_back(static_cast<double>(room));
  question.holds = [judge = Judge(of, variant)](const Answers& answers, std::size_t own) {
    return judge(answers[own]);
  };
  return question;
}

// A cloud in a box of so many cells.
Cloud in_cells(const Cell& cells, const cloud::Three<bool>& periodic, int N, int variant, Draw& draw) {
  const double reach = some_reach(draw);
  const Box box = box_of(reach / variant, cells[0], cells[1], cells[2], periodic);
  return {.box = box, .cells = cells, .reach = reach, .seed = 1 + draw.one_of(1000000), .N = N};
}

Line pairs_line(int variant, Draw& draw) {
  Line line{.name = "near_pairs: boxes of many cells, periodic or not", .points = 3.0};
  const int n = variant == 1 ? 4 : 6;
  for (const auto& periodic : {nowhere, everywhere, slab}) {
    const Cell cells{n + draw.one_of(2), n + 2, n + 1};
    line.questions.push_back(ask_pairs(in_cells(cells, periodic, 80, variant, draw), variant));
  }
  return line;
}

Line few_cells_line(int variant, Draw& draw) {
  Line line{.name = "near_pairs: one, two or three cells a side, few bodies", .points = 3.0};
  const int n = variant == 1 ? 4 : 6;
  for (const Cell& cells : {Cell{n, n + 1, 2 * variant}, Cell{2, n, 3}, Cell{3, 3, 3}, Cell{2, 2, 2}, Cell{1, 2, 3},
                            Cell{1, 1, 1}, Cell{4, 5, 1}}) {
    for (const auto& periodic : {everywhere, slab}) {
      line.questions.push_back(ask_pairs(in_cells(cells, periodic, 30, variant, draw), variant));
    }
  }
  for (const int N : {0, 1, 2}) {
    line.questions.push_back(ask_pairs(in_cells({1, 2, 1}, everywhere, N, variant, draw), variant));
  }
  return line;
}

// A cloud of N bodies in a periodic box of n^3 cells, of which the distances are counted that were asked for.
Question ask_counted(int n, int N, int variant, Draw& draw) {
  const Cloud of{.box = {.length = Vector3d::Constant(n), .periodic = everywhere},
                 .cells = {n, n, n},
                 .reach = static_cast<double>(variant),
                 .seed = 1 + draw.one_of(1000000),
                 .N = N};
  Numbers right{0.0, 0.0};
  for (const auto& [i, j] : pairs_by_library(of)) {
    right[0] += 1.0;
    right[1] += (i + 1.0) * j;
  }
  Question question{.function = "near_pairs_counted", .inputs = inputs(of), .count = 3};
  question.holds = [right](const Answers& answers, std::size_t own) -> std::optional<Finding> {
    const Numbers& answer = answers[own];
    if (answer[1] == right[0] && answer[2] == right[1]) return std::nullopt;
    const std::string expected = fmt::format("the {} pairs within reach", right[0]);
    if (answer[1] == 0.0) return Finding{expected, "none", "no pair was found: is this still the stub?"};
    return Finding{expected, fmt::format("{} pairs, or others", answer[1]),
                   "the lines above ask for the same of small clouds: mend what they say first"};
  };
  return question;
}

Line cost_line(int variant, Draw& draw) {
  Line line{.name = "cost: distances asked for grow as the number of bodies", .points = 2.0};
  for (const int n : {8, 12, 16}) line.questions.push_back(ask_counted(n, n * n * n, variant, draw));
  line.questions.back().holds = [right = line.questions.back().holds](const Answers& answers,
                                                                      std::size_t own) -> std::optional<Finding> {
    if (const std::optional<Finding> wrong = right(answers, own)) return wrong;
    const double slope = std::log(answers[own][0] / answers[0][0]) / std::log(8.0);
    if (slope < 1.1) return std::nullopt;
    return Finding{
        "a slope of log distances against log N below 1.1, from 512 to 4096 bodies",
        fmt::format("a slope of {:.2f}: {} distances for 512, {} for 4096", slope, answers[0][0], answers[own][0]),
        slope > 1.8 ? "that is the cost of all pairs: sort the bodies into lists, one a cell, and ask only for "
                      "pairs in cells next to one another"
                    : "only pairs in cells next to one another need their distance"};
  };
  return line;
}

// Too many for loops over all pairs, even for those that do no more than compare cells, which no count tells.
Line large_line(int variant, Draw& draw) {
  return {.name = "cost: 64000 bodies", .points = 1.0, .questions = {ask_counted(40 * variant, 64000, variant, draw)}};
}

}  // namespace

int main(int argc, char** argv) {
  const std::string box = "length[3] periodic[3]", search = box + " cells[3] reach seed N";
  return grading::run(argc, argv,
                      {.title = "Chapter 4: the cell list",
                       .variants = {"cells at least as long as the reach, one layer of neighbours",
                                    "cells at least half as long as the reach, two layers of neighbours"},
                       .lines = {image_line, far_image_line, count_line, cell_line, far_cell_line, pairs_line,
                                 few_cells_line, cost_line, large_line},
                       .calls = {{"nearest_image", "d[3] " + box + " -> d[3]"},
                                 {"cells_across", box + " reach -> cells[3]"},
                                 {"cell_of", "place[3] " + box + " cells[3] -> cell[3]"},
                                 {"near_pairs", search + " room -> pairs ... i j"},
                                 {"near_pairs_counted", search + " -> distances pairs sum"}}});
}
