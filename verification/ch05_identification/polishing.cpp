// Polishing: against textbook sums and a known minimum on a bound, and what its differences make of jumps.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/identification/polishing.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/report/table.hpp>

#include "test_functions.hpp"

namespace verification::polishing {

using namespace particulate::identification;

double rastrigin_as_printed(const Eigen::VectorXd& x) {
  double sum = 10.0 * static_cast<double>(x.size());
  for (const double one : x) sum += one * one - 10.0 * std::cos(2.0 * std::numbers::pi * one);
  return sum;
}
double rosenbrock_as_printed(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    sum += 100.0 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1.0 - x[i], 2);
  }
  return sum;
}

const Case roots{
    {.name = "polishing_roots_of_squares",
     .claim = "the residuals of Rastrigin's and Rosenbrock's functions have them as their sums of squares",
     .equation = "R 5.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Places places(rows.case_seed());
      double off_rastrigin = 0.0, off_rosenbrock = 0.0;
      for (int n = 0; n < 1000; ++n) {
        const TestFunction one = rastrigin(2 + n % 7), other = rosenbrock(2 + n % 7);
        const Eigen::VectorXd x = places.in(one.box), y = places.in(other.box);
        const double printed = rastrigin_as_printed(x), valley = rosenbrock_as_printed(y);
        off_rastrigin =
            particulate::report::worse_of(off_rastrigin, std::abs(one.residuals(x).squaredNorm() - printed));
        off_rosenbrock =
            particulate::report::worse_of(off_rosenbrock, std::abs(other.residuals(y).squaredNorm() / valley - 1.0));
      }
      rows.at_most("Rastrigin, 2 to 8 parameters, difference",
                   {.limit = 1e-12,
                    .computed = off_rastrigin,
                    .because = "sums of up to 500, whose terms are rounded to 1e-14, with pi x"});
      rows.at_most("Rosenbrock, 2 to 8 parameters, relative difference",
                   {.limit = 1e-14, .computed = off_rosenbrock, .because = "a sum of squares, each rounded"});
    }};

const Case never_worse{
    {.name = "polishing_never_worse",
     .claim =
         "polishing never gives back what is worse than its start, outside the box or not allowed, and counts every "
         "evaluation",
     .equation = "R 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      Places places(rows.case_seed());
      long worse = 0, outside = 0, refused = 0, uncounted = 0, better = 0, runs = 0;
      for (const TestFunction& f : {rosenbrock(4), rastrigin(4)}) {
        for (int n = 0; n < 200; ++n) {
          // Small boxes about the start, half of a plane, and a residual that is noise in every fourth run.
          const Eigen::VectorXd start = places.in(f.box);
          Box box{.lower = start.array() - 0.3, .upper = start.array() + 0.3};
          if (n % 2 == 1) box.allows = [&](const Eigen::VectorXd& x) { return x.sum() <= start.sum() + 0.1; };
          long calls = 0;
          const Residuals residuals = [&](const Eigen::VectorXd& x) {
            ++calls;
            Eigen::VectorXd all = f.residuals(x);
            if (n % 4 == 3) all.array() += 3.0 * (1e7 * x.sum() + all.array()).sin();
            return all;
          };
          const Polished one = polish(residuals, box, start, {.central = n % 3 == 0, .most_evaluations = 150});
          uncounted += one.evaluations == calls ? 0 : 1;
          worse += residuals(one.parameters).squaredNorm() <= residuals(start).squaredNorm() ? 0 : 1;
          better += one.after < one.before ? 1 : 0;
          outside +=
              (one.parameters.array() < box.lower.array()).any() || (one.parameters.array() > box.upper.array()).any();
          refused += box.allows && !box.allows(one.parameters) ? 1 : 0;
          ++runs;
        }
      }
      rows.none(fmt::format("of {} runs worse than their start", runs), worse, "the best that is met is kept");
      rows.none("outside the box", outside, "angles have no bounds, and their sine has");
      rows.none("not allowed", refused, "what is not allowed has no residuals");
      rows.none("with another count than the residuals'", uncounted, "each call is counted");
      rows.at_least("runs that gain", {.limit = 0.75 * static_cast<double>(runs),
                                       .computed = static_cast<double>(better),
                                       .because = "else nothing was polished: at least those without noise"});
    }};

// (1/2, 1/4) of the valley with x <= 1/2: the first residual vanishes, the second is 1/2, and grows to the left.
const Case on_bound{
    {.name = "polishing_on_a_bound",
     .claim = "a minimum on a bound is found, and a start on a bound is left",
     .equation = "R 5.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      TestFunction f = rosenbrock(2);
      f.box.upper[0] = 0.5;
      const Polished one = polish(f.residuals, f.box, Eigen::Vector2d(-1.2, 1.0), {.tolerance = 1e-12});
      rows.compare("sum of squares on the bound", {.expected = 0.25,
                                                   .computed = one.after,
                                                   .tolerance = relative(1e-6),
                                                   .because = "the distance from the bound goes with the "
                                                              "square of the angle's"});
      const TestFunction whole = rosenbrock(2);
      for (const Eigen::VectorXd& corner : {whole.box.lower, whole.box.upper}) {
        const Polished other = polish(whole.residuals, whole.box, corner, {});
        rows.at_most(
            fmt::format("sum of squares from the corner at {:g}", corner[0]),
            {.limit = 1e-12, .computed = other.after, .because = "residuals of zero: steps converge quadratically"});
      }
    }};

// The parameters in terraces of a thousandth of their value: what contacts make of a history, which jumps where an
// impact comes or goes.
const Case jumps{
    {.name = "polishing_over_jumps",
     .claim =
         "differences shorter than the jumps of a cost see no slope; ten times as long ones get down to the terrace",
     .equation = "R 5.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      constexpr double terrace = 1e-3;  // of the box's width
      const TestFunction f = rosenbrock(4);
      const Eigen::ArrayXd step = terrace * (f.box.upper - f.box.lower).array();
      const Residuals in_terraces = [&](const Eigen::VectorXd& x) {
        return f.residuals((step * (x.array() / step).floor()).matrix());
      };
      particulate::report::Table table({"step over the terrace", "sum of squares before", "after", "evaluations"});
      Places places(rows.case_seed());
      Eigen::ArrayXXd gain(20, 4);
      for (Eigen::Index n = 0; n < gain.rows(); ++n) {
        const Eigen::VectorXd start = places.in(f.box);
        for (Eigen::Index k = 0; k < gain.cols(); ++k) {
          const double ratio = std::pow(10.0, static_cast<double>(k) - 2.0);
          const Polished one = polish(in_terraces, f.box, start, {.step = ratio * terrace, .central = true});
          gain(n, k) = one.after / one.before;
          table.add({ratio, one.before, one.after, one.evaluations});
        }
      }
      rows.write("polishing_over_jumps", table);
      const auto median = [&](Eigen::Index k) {
        Eigen::ArrayXd sorted = gain.col(k);
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
      };
      rows.at_least(
          "median of after over before, steps of a hundredth of a terrace",
          {.limit = 0.99,
           .computed = median(0),
           .because = "of eight differences none crosses an edge in 92 of 100 starts, and the gradient is 0"});
      rows.at_most(
          "median of after over before, steps of ten terraces",
          {.limit = 1e-2, .computed = median(3), .because = "the slope over ten terraces is right within a tenth"});
    }};

}  // namespace verification::polishing
