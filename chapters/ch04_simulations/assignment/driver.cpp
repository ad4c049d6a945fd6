#include "driver.hpp"

#include "cell_list.hpp"
#include "cloud.hpp"

namespace {

using Numbers = std::vector<double>;

Eigen::Vector3d vector_at(const Numbers& x, std::size_t k) { return {x[k], x[k + 1], x[k + 2]}; }

Cell cell_at(const Numbers& x, std::size_t k) {
  return {static_cast<int>(x[k]), static_cast<int>(x[k + 1]), static_cast<int>(x[k + 2])};
}

Box box_at(const Numbers& x, std::size_t k) {
  return {.length = vector_at(x, k), .periodic = {x[k + 3] != 0.0, x[k + 4] != 0.0, x[k + 5] != 0.0}};
}

Numbers numbers(const Cell& cell) { return {cell.begin(), cell.end()}; }

// The pairs of a random cloud, and how often the student asked for a distance.
struct Search {
  std::vector<Pair> pairs;
  double looks = 0.0;
};

// Inputs: length[3] periodic[3] cells[3] reach seed N.
Search search(const Numbers& x) {
  const Box box = box_at(x, 0);
  const Cell cells = cell_at(x, 6);
  const auto at = cloud::shares(static_cast<std::uint64_t>(x[10]), static_cast<std::size_t>(x[11]));
  std::vector<Cell> cell;
  for (const auto& share : at) cell.push_back(cloud::cell(share, cells));
  Search result;
  result.pairs = near_pairs(cell, cells, box, [&](int i, int j) {
    result.looks += 1.0;
    const auto &a = at.at(static_cast<std::size_t>(i)), &b = at.at(static_cast<std::size_t>(j));
    return cloud::squared_distance(a, b, std::array{box.length.x(), box.length.y(), box.length.z()}, box.periodic) <=
           x[9] * x[9];
  });
  return result;
}

// As many numbers as asked for, the first of them how many pairs there are; zeros fill them up.
Numbers listed(const Search& found, std::size_t room) {
  Numbers all{static_cast<double>(found.pairs.size())};
  for (const Pair& pair : found.pairs) {
    all.push_back(pair.i);
    all.push_back(pair.j);
  }
  all.resize(room, 0.0);
  return all;
}

// How many distances, how many pairs, and a sum that tells whether they are the right ones.
Numbers counted(const Search& found) {
  double sum = 0.0;
  for (const Pair& pair : found.pairs) sum += static_cast<double>(pair.i + 1) * pair.j;
  return {found.looks, static_cast<double>(found.pairs.size()), sum};
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(
      argc, argv,
      {{"nearest_image",
        [](const Numbers& x) -> Numbers {
          const Eigen::Vector3d d = nearest_image(vector_at(x, 0), box_at(x, 3));
          return {d.x(), d.y(), d.z()};
        }},
       {"cells_across", [](const Numbers& x) -> Numbers { return numbers(cells_across(box_at(x, 0), x[6])); }},
       {"cell_of",
        [](const Numbers& x) -> Numbers { return numbers(cell_of(vector_at(x, 0), box_at(x, 3), cell_at(x, 9))); }},
       {"near_pairs", [](const Numbers& x) -> Numbers { return listed(search(x), static_cast<std::size_t>(x[12])); }},
       {"near_pairs_counted", [](const Numbers& x) -> Numbers { return counted(search(x)); }}});
}
