// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions. But where a mistake says otherwise, cells are those of variant 1.

#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using Cells = std::vector<Cell>;
using Pairs = std::vector<Pair>;

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  Eigen::Vector3d (*nearest_image)(const Eigen::Vector3d&, const Box&) = right::nearest_image;
  Cell (*cells_across)(const Box&, double) = right::cells_across<1>;
  Cell (*cell_of)(const Eigen::Vector3d&, const Box&, const Cell&) = right::cell_of;
  Pairs (*near_pairs)(const Cells&, const Cell&, const Box&, const IsNear&) = right::near_pairs<1>;
};

// Vectors, one direction at a time.
template <class OfAxis>
Eigen::Vector3d image_where(const Eigen::Vector3d& d, const Box& box, const OfAxis& of_axis) {
  Eigen::Vector3d image = d;
  for (int k = 0; k < 3; ++k) {
    if (box.periodic[static_cast<std::size_t>(k)]) image[k] = of_axis(d[k], box.length[k]);
  }
  return image;
}

// Cells from their numbers before anything is wrapped, one direction at a time.
template <class OfAxis>
Cell cell_where(const Eigen::Vector3d& place, const Box& box, const Cell& cells, const OfAxis& of_axis) {
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Index axis = static_cast<Eigen::Index>(k);
    cell[k] = of_axis(place[axis] / box.length[axis] * cells[k], cells[k], box.periodic[k]);
  }
  return cell;
}

int floored(double x) { return static_cast<int>(std::floor(x)); }

// Right pairs but for which neighbours are looked at.
Pairs pairs_around(const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near, int layers,
                   right::Around around) {
  Pairs pairs = right::pairs_where(
      cell, cells, box, layers, [&](int i, int j) { return i < j && is_near(i, j); }, around);
  right::sort(pairs);
  return pairs;
}

// Neighbours with repetitions where the box has few cells.
std::vector<int> around_repeated(int cell, int cells, bool periodic, int layers) {
  std::vector<int> all;
  for (int c = cell - layers; c <= cell + layers; ++c) {
    if (periodic || (c >= 0 && c < cells)) all.push_back(right::wrapped(c, cells));
  }
  return all;
}

// Every pair that passes a test, from two loops over all bodies.
template <class Takes>
Pairs all_pairs(const Cells& cell, const Takes& takes) {
  Pairs pairs;
  const int N = static_cast<int>(cell.size());
  for (int i = 0; i < N; ++i) {
    for (int j = i + 1; j < N; ++j) {
      if (takes(i, j)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

const std::vector<Mistake<Functions>> mistakes{
    // The image is taken to the wrong side.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: sign of the image
    {"image_sign", &Functions::nearest_image,
     [](const Eigen::Vector3d& d, const Box& box) {
       return image_where(d, box, [](double x, double length) { return x + length * std::round(x / length); });
     }},

    // The separation stays as it is.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: no image was taken
    {"no_image", &Functions::nearest_image, [](const Eigen::Vector3d& d, const Box&) { return d; }},

    // Whole lengths are cut off.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: rounding, not cutting off
    {"image_truncated", &Functions::nearest_image,
     [](const Eigen::Vector3d& d, const Box& box) {
       return image_where(d, box, [](double x, double length) { return std::fmod(x, length); });
     }},

    // A separation is taken for a place.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: that is a place in the box
    {"image_in_box", &Functions::nearest_image,
     [](const Eigen::Vector3d& d, const Box& box) {
       return image_where(d, box, [](double x, double length) { return x - length * std::floor(x / length); });
     }},

    // One side is forgotten.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: two sides
    {"image_one_side", &Functions::nearest_image,
     [](const Eigen::Vector3d& d, const Box& box) {
       return image_where(d, box, [](double x, double length) { return x > 0.5 * length ? x - length : x; });
     }},

    // One length comes off at most.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: more than one length may have to come off
    {"image_once", &Functions::nearest_image,
     [](const Eigen::Vector3d& d, const Box& box) {
       return image_where(d, box, [](double x, double length) {
         return x > 0.5 * length ? x - length : x < -0.5 * length ? x + length : x;
       });
     }},

    // Every direction repeats itself.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: has no images: leave d as it is
    {"image_everywhere", &Functions::nearest_image,
     [](const Eigen::Vector3d& d, const Box& box) {
       return right::nearest_image(d, {.length = box.length, .periodic = {true, true, true}});
     }},

    // Cells are shorter than they may be.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: cells shorter than they may be
    {"short_cells", &Functions::cells_across,
     [](const Box& box, double reach) {
       Cell cells{};
       for (std::size_t k = 0; k < 3; ++k) {
         cells[k] = static_cast<int>(std::ceil(box.length[static_cast<Eigen::Index>(k)] / reach));
       }
       return cells;
     }},

    // A short box has no cell at all.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: at least 1
    {"no_cell", &Functions::cells_across,
     [](const Box& box, double reach) {
       Cell cells{};
       for (std::size_t k = 0; k < 3; ++k) cells[k] = floored(box.length[static_cast<Eigen::Index>(k)] / reach);
       return cells;
     }},

    // Cells of the other variant.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: these are the cells of the other variant
    {"half_cells", &Functions::cells_across, right::cells_across<2>},

    // A cast, which cuts off towards 0, before a remainder that is right.
    // graded: --variant 1 --student anna|bob@school.edu -> 15
    // hint: a cast to int cuts off towards 0
    {"truncated", &Functions::cell_of,
     [](const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
       return cell_where(place, box, cells, [](double x, int n, bool periodic) {
         return periodic ? right::wrapped(static_cast<int>(x), n) : std::clamp(static_cast<int>(x), 0, n - 1);
       });
     }},

    // A place that has left the box has no cell.
    // graded: --variant 1 --student anna|bob@school.edu -> 15
    // hint: not wrapped
    {"not_wrapped", &Functions::cell_of,
     [](const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
       return cell_where(place, box, cells, [](double x, int, bool) { return floored(x); });
     }},

    // The remainder of a negative number.
    // graded: --variant 1 --student anna|bob@school.edu -> 15
    // hint: the remainder % of a negative number
    {"negative_remainder", &Functions::cell_of,
     [](const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
       return cell_where(place, box, cells, [](double x, int n, bool periodic) {
         return periodic ? floored(x) % n : std::clamp(floored(x), 0, n - 1);
       });
     }},

    // Every direction repeats itself.
    // graded: --variant 1 --student anna|bob@school.edu -> 15
    // hint: what lies beyond belongs to the first or the last cell
    {"wrapped_everywhere", &Functions::cell_of,
     [](const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
       return right::cell_of(place, {.length = box.length, .periodic = {true, true, true}}, cells);
     }},

    // The place is wrapped, by rounding to the far face.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: wrap the number of the cell
    {"wrapped_place", &Functions::cell_of,
     [](const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
       return cell_where(place, box, cells, [](double x, int n, bool periodic) {
         return periodic ? floored(x - n * std::floor(x / n)) : std::clamp(floored(x), 0, n - 1);
       });
     }},

    // Behind the last cell comes none.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: neighbours are not wrapped
    {"neighbours_not_wrapped", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       return right::near_pairs<1>(cell, cells, {.length = box.length, .periodic = {}}, is_near);
     }},

    // Where there are few cells, the same one is met on both sides.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: few cells: where there are fewer than 3
    {"few_cells", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       return pairs_around(cell, cells, box, is_near, 1, around_repeated);
     }},

    // Both bodies find each other.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: each pair is named by its smaller number first
    {"both_ways", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       Pairs pairs = right::pairs_where(cell, cells, box, 1, [&](int i, int j) { return i != j && is_near(i, j); });
       right::sort(pairs);
       return pairs;
     }},

    // Both bodies find each other, and the names are put in order.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: each pair was found from both of its cells
    {"twice", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       Pairs pairs = right::pairs_where(cell, cells, box, 1, [&](int i, int j) { return i != j && is_near(i, j); });
       for (Pair& pair : pairs) pair = {std::min(pair.i, pair.j), std::max(pair.i, pair.j)};
       right::sort(pairs);
       return pairs;
     }},

    // A body finds itself.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: a body is no pair with itself
    {"itself", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       Pairs pairs = right::pairs_where(cell, cells, box, 1, [&](int i, int j) { return i <= j && is_near(i, j); });
       right::sort(pairs);
       return pairs;
     }},

    // The own cell is forgotten.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: the own cell is forgotten
    {"own_cell", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       Pairs pairs = right::pairs_where(cell, cells, box, 1, [&](int i, int j) {
         return i < j && cell[static_cast<std::size_t>(i)] != cell[static_cast<std::size_t>(j)] && is_near(i, j);
       });
       right::sort(pairs);
       return pairs;
     }},

    // Half of the neighbours, of which some lie opposite one another.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: half of them will do if it holds one of any two that lie opposite
    {"half_stencil", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       const auto forward = [](int c, int n, bool periodic, int) {
         std::vector<int> all{c};
         if (c + 1 < n || (periodic && n > 1)) all.push_back((c + 1) % n);
         return all;
       };
       Pairs pairs = right::pairs_where(
           cell, cells, box, 1, [&](int i, int j) { return i != j && is_near(i, j); }, forward);
       for (Pair& pair : pairs) pair = {std::min(pair.i, pair.j), std::max(pair.i, pair.j)};
       right::sort(pairs);
       const auto same = [](const Pair& a, const Pair& b) { return a.i == b.i && a.j == b.j; };
       pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
       return pairs;
     }},

    // One layer of cells that are half as long as the reach.
    // graded: --variant 2 --student anna|bob@school.edu -> 11
    // hint: two layers of neighbours
    {"one_layer", &Functions::cells_across, right::cells_across<2>},

    // Pairs as they are found.
    // graded: --variant 1 --student anna|bob@school.edu -> 14
    // hint: sort what you have found
    {"unsorted", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       return right::pairs_where(cell, cells, box, 1, [&](int i, int j) { return i < j && is_near(i, j); });
     }},

    // Candidates, of which no distance was asked.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: only if is_near() says so
    {"candidates", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear&) {
       Pairs pairs = right::pairs_where(cell, cells, box, 1, [](int i, int j) { return i < j; });
       right::sort(pairs);
       return pairs;
     }},

    // All pairs: right, at their cost.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: that is the cost of all pairs
    // hint: far too much work
    {"all_pairs", &Functions::near_pairs,
     [](const Cells& cell, const Cell&, const Box&, const IsNear& is_near) { return all_pairs(cell, is_near); }},

    // All pairs, of which most are left out by their cells: no distance too many, but two loops over all bodies.
    // graded: --variant 1 --student anna -> 19
    // hint: far too much work
    {"all_cells", &Functions::near_pairs,
     [](const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
       return all_pairs(cell, [&](int i, int j) {
         const Cell &a = cell[static_cast<std::size_t>(i)], &b = cell[static_cast<std::size_t>(j)];
         for (std::size_t k = 0; k < 3; ++k) {
           const int d = std::abs(a[k] - b[k]);
           if (d > 1 && !(box.periodic[k] && d == cells[k] - 1)) return false;
         }
         return is_near(i, j);
       });
     }},
};

const Functions handed_in = made(mistakes);

}  // namespace

Eigen::Vector3d nearest_image(const Eigen::Vector3d& d, const Box& box) { return handed_in.nearest_image(d, box); }

Cell cells_across(const Box& box, double reach) { return handed_in.cells_across(box, reach); }

Cell cell_of(const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
  return handed_in.cell_of(place, box, cells);
}

Pairs near_pairs(const Cells& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
  return handed_in.near_pairs(cell, cells, box, is_near);
}
