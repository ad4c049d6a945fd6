//! @page ch05_landscapes Chapter 5: What a cost looks like
//! @brief The cost over both strengths, after a short time and a long one: one valley, and then many.
//! @tableofcontents
//!
//! @section ch05_landscapes_question Two of four parameters
//!
//! A cost of four parameters cannot be drawn. Let the exponents be known: then it is a landscape over both strengths,
//! and its lowest place, of height zero, is where we took the target from.
//!
//! @figure{ch05_landscape, Cost over the strengths\, each over the true one\, of a short motion (left) and a longer one (right). Circles: minima. Grey: no value\, the run would take too many steps. Figure 5.1.}
//!
//! @section ch05_landscapes_program The program

#include <algorithm>
#include <cmath>

#include <particulate/identification/polishing.hpp>

#include "ch05_identification.hpp"

namespace ch05 {
namespace {

//! The map reaches from half to twice the true strengths, which lie between four of its points.

struct Map {
  Eigen::MatrixXd height;                    // NaN: no value
  std::vector<Eigen::VectorXd> minima = {};  // points lower than their eight neighbours
  Eigen::Vector2d at(Eigen::Index i, Eigen::Index j) const {
    return std::log(2.0) * (2.0 * Eigen::Array2d(i, j) / static_cast<double>(height.rows() - 1) - 1.0);
  }
};

Map map_of(const Cost& cost, int points) {
  Map map{.height = Eigen::MatrixXd(points, points)};
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) map.height(i, j) = cost(map.at(i, j)).cost;
  }
  for (int i = 1; i + 1 < points; ++i) {
    for (int j = 1; j + 1 < points; ++j) {
      const Eigen::Matrix3d around = map.height.block<3, 3>(i - 1, j - 1);
      if ((around.array() > map.height(i, j)).count() == 8) map.minima.push_back(map.at(i, j));
    }
  }
  return map;
}

//! A narrow valley that crosses the points of a map aslant looks like a chain of minima. From each of them we therefore
//! go on downhill by particulate::identification::polish; ends that lie within two per cent are one. It minimizes the
//! sum of squares and not the cost, but a place where all differences are small is low in both.

struct Minimum {
  Eigen::VectorXd at;  // ln(alpha/true)
  double squares;
};

std::vector<Minimum> downhill(const Residuals& residuals, const Map& map) {
  const Box box{.lower = map.at(0, 0), .upper = map.at(map.height.rows() - 1, map.height.cols() - 1)};
  std::vector<Minimum> ends;
  for (const Eigen::VectorXd& start : map.minima) {
    const Polished end = polish(residuals, box, start);
    const bool inside = end.parameters.cwiseAbs().maxCoeff() < 0.99 * std::log(2.0);
    const bool known = std::any_of(ends.begin(), ends.end(),
                                   [&](const Minimum& other) { return (other.at - end.parameters).norm() < 0.02; });
    if (inside && !known) ends.push_back({end.parameters, end.after});
  }
  std::sort(ends.begin(), ends.end(), [](const Minimum& a, const Minimum& b) { return a.squares < b.squares; });
  return ends;
}

}  // namespace

void landscapes(const Parameters& p, report::Chapter& chapter, report::Checks& checks) {
  const int points = chapter.common().quick ? p.map / 2 : p.map;
  report::Table heights({"duration [s]", "alpha1 over true [-]", "alpha2 over true [-]", "cost [-]"});
  report::Table lowest({"duration [s]", "alpha1 over true [-]", "alpha2 over true [-]", "cost [-]", "squares [-]"});
  report::Table counts({"duration [s]", "minima of the map", "minima downhill of them", "lowest cost [-]", "next [-]"});
  for (const double duration : {p.duration, p.longer}) {
    const HistoryCost of_four = exact_cost(p, few_of(chapter, p, duration));
    const auto string = [&](const Eigen::VectorXd& x) {
      Eigen::VectorXd all = truth_of(p);
      all.head(2) += x;
      return all;
    };
    const Cost cost = [&](const Eigen::VectorXd& x) { return of_four(string(x)); };
    const Map map = map_of(cost, points);
    for (Eigen::Index i = 0; i < points; ++i) {
      for (Eigen::Index j = 0; j < points; ++j) {
        heights.add({duration, std::exp(map.at(i, j)[0]), std::exp(map.at(i, j)[1]), map.height(i, j)});
      }
    }
    const std::vector<Minimum> ends = downhill([&](const auto& x) { return of_four.residuals(string(x)); }, map);
    for (const auto& [at, squares] : ends) {
      lowest.add({duration, std::exp(at[0]), std::exp(at[1]), cost(at).cost, squares});
    }
    counts.add({duration, map.minima.size(), ends.size(), ends.empty() ? report::Cell() : cost(ends[0].at).cost,
                ends.size() > 1 ? cost(ends[1].at).cost : report::Cell()});
    if (duration == p.duration) {
      checks.add("lowest minimum of the shorter motion, off the true strengths, relative",
                 ends.empty() ? NAN : ends.front().at.cwiseAbs().maxCoeff(), 1e-5);
    }
  }
  chapter.output().write("landscape", heights);
  chapter.output().write("minima", lowest);
  chapter.output().write("minima_counted", counts);
}

}  // namespace ch05

//! @section ch05_landscapes_results One valley, and many
//!
//! @table{ch05_minima_counted}
//!
//! In a short time the spheres move as they are pushed at the start. Along the valley attraction and repulsion grow
//! together, so that they balance at nearly the same distance: whoever knows where the valley is knows little yet of
//! where in it the truth lies. In a longer time spheres swing, and what swings with another period is alike now and
//! then: so there are minima in which nothing is right, and a search that only goes downhill ends in whichever is near.
//! Where strong attraction lets spheres collapse there is no value at all. And if the lowest cost in the table is not
//! zero, the map has missed the one minimum that is right: its valley has become so narrow that it runs between the
//! points.
//!
//! That it is so for other clouds, and how deep the valleys are, is verified in @ref verify_ch05_landscape. We take the
//! shorter time from here on. It makes the search easier, and does not make the answer worse.
//!
//! @section ch05_landscapes_exercises Exercises
//!
//! 1. Along which line of the left landscape does \f$ d_e = (\alpha_2/\alpha_1)^{1/(\beta_2 - \beta_1)} \f$ not change?
//!    Draw it, and compare it with the valley.
//! 2. How long may the motion be, before there is a second minimum?
