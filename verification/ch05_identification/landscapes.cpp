// What costs of histories look like: one valley or several minima, and what contacts make of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <ch04_simulations/clouds.hpp>
#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/verlet.hpp>

#include "fits.hpp"

namespace verification::identification_landscapes {

using namespace particulate;
using namespace particulate::identification;

// A cost on a grid of (ln alpha1, ln alpha2), each from half to twice the true one, which is a point of it.
struct Landscape {
  // Of clouds of N from three starts, over a time.
  Landscape(Eigen::Index N, std::uint64_t seed, double T, int size)
      : cost(own_cost(cloud_model(book_clouds(N, 3, seed), moments(T, 40)), 3, moments(T, 40),
                      true_parameters().head(2))),
        values(size, size) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) values(i, j) = height(at(i, j));
    }
  }
  double spacing() const { return 2.0 * std::log(2.0) / static_cast<double>(values.rows() - 1); }
  Eigen::Vector2d at(Eigen::Index i, Eigen::Index j) const {
    return true_parameters().head(2).array() - std::log(2.0) + spacing() * Eigen::Array2d(i, j);
  }
  double height(const Eigen::VectorXd& p) const {
    const Value value = cost(p);
    return value.reason.empty() ? value.cost : std::numeric_limits<double>::infinity();
  }
  // Points inside the grid that are lower than their eight neighbours.
  std::vector<Eigen::Vector2d> minima() const {
    std::vector<Eigen::Vector2d> found;
    for (Eigen::Index i = 1; i + 1 < values.rows(); ++i) {
      for (Eigen::Index j = 1; j + 1 < values.cols(); ++j) {
        const Eigen::Matrix3d around = values.block<3, 3>(i - 1, j - 1);
        if ((around.array() <= values(i, j)).count() == 1) found.push_back(at(i, j));
      }
    }
    return found;
  }

  HistoryCost cost;
  Eigen::MatrixXd values;
};

// The simplex of Nelder and Mead: downhill without derivatives, until it is smaller than 1e-4.
Eigen::Vector2d downhill(const Landscape& of, const Eigen::Vector2d& start, double size) {
  struct Corner {
    Eigen::Vector2d at;
    double height;
  };
  const auto corner = [&](const Eigen::Vector2d& at) { return Corner{at, of.height(at)}; };
  std::array all{corner(start), corner(start + Eigen::Vector2d(size, 0.0)), corner(start + Eigen::Vector2d(0.0, size))};
  for (int step = 0; step < 300; ++step) {
    std::sort(all.begin(), all.end(), [](const Corner& a, const Corner& b) { return a.height < b.height; });
    if ((all[2].at - all[0].at).norm() < 1e-4) break;
    const Eigen::Vector2d middle = 0.5 * (all[0].at + all[1].at), across = middle - all[2].at;
    const Corner reflected = corner(middle + across);
    if (reflected.height < all[0].height) {
      const Corner farther = corner(middle + 2.0 * across);
      all[2] = farther.height < reflected.height ? farther : reflected;
    } else if (reflected.height < all[1].height) {
      all[2] = reflected;
    } else {
      const Corner nearer = corner(middle + (reflected.height < all[2].height ? 0.5 : -0.5) * across);
      if (nearer.height < std::min(reflected.height, all[2].height)) {
        all[2] = nearer;
      } else {
        for (const std::size_t k : {1, 2}) all[k] = corner(0.5 * (all[0].at + all[k].at));
      }
    }
  }
  return all[0].at;
}

// The ends of all ways down from the minima of the grid that lie within it and are 2 % apart. A grid takes a narrow
// valley that crosses it for several minima: those run together.
std::vector<Eigen::Vector2d> valleys(const Landscape& of) {
  std::vector<Eigen::Vector2d> ends;
  for (const Eigen::Vector2d& start : of.minima()) {
    const Eigen::Vector2d end = downhill(of, start, 0.5 * of.spacing());
    const bool inside = ((end - true_parameters().head(2)).array().abs() < std::log(2.0)).all();
    const bool known =
        std::any_of(ends.begin(), ends.end(), [&](const auto& other) { return (other - end).norm() < 0.02; });
    if (inside && !known) ends.push_back(end);
  }
  return ends;
}

const Case landscape{
    {.name = "landscape",
     .claim = "over half a second the cost of a cloud's relative energy has one valley in the box of half to twice the "
              "true strengths; over two seconds it has several local minima",
     .equation = "R 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      const Eigen::Index N = rows.quick() ? 8 : 20;
      const int sets = rows.quick() ? 1 : 3, size = rows.quick() ? 13 : 17;
      report::Table heights({"time [s]", "ln alpha1", "ln alpha2", "cost"});
      report::Table counts({"first seed", "time [s]", "minima of the grid", "valleys"});
      std::vector<double> over_short, over_long;
      double off = 0.0;
      for (int set = 0; set < sets; ++set) {
        for (const double T : {0.5, 2.0}) {
          const Landscape of(N, 1 + 3 * static_cast<std::uint64_t>(set), T, size);
          const std::vector<Eigen::Vector2d> ends = valleys(of);
          counts.add({1.0 + 3.0 * set, T, static_cast<double>(of.minima().size()), static_cast<double>(ends.size())});
          (T < 1.0 ? over_short : over_long).push_back(static_cast<double>(ends.size()));
          for (Eigen::Index k = 0; set == 0 && k < of.values.size(); ++k) {
            const Eigen::Vector2d at = of.at(k % size, k / size);
            heights.add({T, at[0], at[1], of.values(k % size, k / size)});
          }
          if (T > 1.0) continue;
          for (const Eigen::Vector2d& end : ends) off = report::worse_of(off, (end - true_parameters().head(2)).norm());
        }
      }
      rows.write("landscape", heights);
      rows.write("valleys", counts);
      rows.at_most("valleys over 0.5 s, most of all sets",
                   {.limit = 1.0,
                    .computed = *std::max_element(over_short.begin(), over_short.end()),
                    .because = "bodies have met once or twice, and three starts are averaged"});
      rows.at_most("end of that valley, off the truth [-]",
                   {.limit = 2e-3, .computed = off, .because = "the search ends at 1e-4, the valley is narrow"});
      rows.at_least("valleys over 2 s, fewest of all sets",
                    {.limit = 2.0,
                     .computed = *std::min_element(over_long.begin(), over_long.end()),
                     .because = "more than one"});
    }};

// A cloud with weak near field, whose bodies meet or pass through each other, and how far its relative energy is from
// that with twice the attraction: of ln alpha1.
HistoryCost meeting(Eigen::Index N, bool contacts, std::uint64_t seed) {
  const std::vector<double> times = moments(1.0, 20);
  const kinematics::Particles start = book_cloud(N, seed);
  const HistoryModel model = [=](const Eigen::VectorXd& p, Eigen::Index) -> Simulated {
    const laws::NearField law{.alpha1 = 0.1 * std::exp(p[0]), .alpha2 = 0.05};
    if (!contacts) return relative_energy_history(scenes::Scene(start, kinematics::Space{}, law), times);
    const scenes::Scene scene(start, kinematics::Space{}, law, contact::Contact<>{.restitution = {0.5}});
    scenes::History history(scene, times);
    schemes::State state = scenes::start(scene);
    require_reached(schemes::integrate(scene, state, times.back(), schemes::VelocityVerlet{},
                                       schemes::FixedStep{.step = 5e-3}, history));
    return {.histories = {{times, history.rows().col(2)}}};
  };
  return own_cost(model, 1, times, Eigen::VectorXd::Constant(1, std::log(2.0)));
}

// How far changes from point to point, at equal distances of ln alpha1 about 0, are from the middle of the five about
// them: what the cost jumps by, whatever its slope and curvature.
Eigen::ArrayXd jumps(const HistoryCost& cost, double distance, int points) {
  Eigen::ArrayXd values(points), sizes(points - 5);
  for (int k = 0; k < points; ++k) values[k] = cost(Eigen::VectorXd::Constant(1, distance * (k - points / 2))).cost;
  const Eigen::ArrayXd change = values.tail(points - 1) - values.head(points - 1);
  for (Eigen::Index k = 0; k < sizes.size(); ++k) {
    Eigen::Array<double, 5, 1> about = change.segment<5>(k);
    std::nth_element(about.begin(), about.begin() + 2, about.end());
    sizes[k] = std::abs(change[k + 2] - about[2]);
  }
  return sizes;
}

// Central differences at some places: how many are off by more than half from the secant over 2 % to either side, and
// how many have the other sign.
struct Misled {
  int off = 0, sign = 0;
};
void count_misled(const HistoryCost& cost, double step, int places, Misled& count) {
  const SampledModel model = [&](const Eigen::VectorXd& p) { return Eigen::VectorXd::Constant(1, cost(p).cost); };
  for (int k = 0; k < places; ++k) {
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, 0.2 * (k + 0.5) / places - 0.1);
    const double secant = sensitivities(model, at, absolute_steps(1, 0.02)).jacobian(0, 0);
    const double found = sensitivities(model, at, absolute_steps(1, step)).jacobian(0, 0);
    if (!(std::abs(found / secant - 1.0) <= 0.5)) ++count.off;
    if (found * secant <= 0.0) ++count.sign;
  }
}

void compare_jumps(Rows& rows, Eigen::Index N, int points) {
  constexpr double distance = 2e-4, least = 1e-5;
  const auto count = [&](const Eigen::ArrayXd& sizes) { return (sizes > least).count(); };
  const Eigen::ArrayXd sizes = jumps(meeting(N, true, 1), distance, points);
  const double apart = distance * static_cast<double>(sizes.size()) / static_cast<double>(count(sizes));
  rows.none("jumps by more than 1e-5 without contacts", count(jumps(meeting(N, false, 1), distance, points)),
            "the cost is smooth");
  rows.at_least("largest jump of the cost [-]",
                {.limit = 1e-4, .computed = sizes.maxCoeff(), .because = "as much as it changes in between over 2e-4"});
  rows.at_least("mean distance in ln alpha1 of jumps by more than 1e-5 [-]",
                {.limit = 1e-4, .computed = apart, .because = "as claimed"});
  rows.at_most("mean distance in ln alpha1 of jumps by more than 1e-5, from above [-]",
               {.limit = 1e-3, .computed = apart, .because = "as claimed"});
}

const Case contacts{
    {.name = "contacts_make_the_cost_jump",
     .claim = "contacts make the cost jump where a parameter moves by 1e-4 to 1e-3 of itself; differences over such "
              "steps often mislead, over a hundredth less often, and without contacts never",
     .equation = "R 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      constexpr Eigen::Index N = 60;
      compare_jumps(rows, N, rows.quick() ? 51 : 401);
      const int starts = rows.quick() ? 2 : 5, places = rows.quick() ? 10 : 20, all = starts * places;
      report::Table shown({"step [-]", "off by half [-]", "wrong sign [-]", "off by half without contacts [-]"});
      double shares[2] = {missing, missing};  // of differences off, over 1e-4 and 1e-2
      int calm_off = 0;
      for (const double step : {1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2}) {
        if (rows.quick() && step != 1e-4 && step != 1e-2) continue;
        Misled with, without;
        for (int start = 1; start <= starts; ++start) {
          count_misled(meeting(N, true, static_cast<std::uint64_t>(start)), step, places, with);
        }
        count_misled(meeting(N, false, 1), step, places, without);
        calm_off += without.off;
        shown.add({step, static_cast<double>(with.off) / all, static_cast<double>(with.sign) / all,
                   static_cast<double>(without.off) / places});
        if (step == 1e-4) shares[0] = static_cast<double>(with.off) / all;
        if (step == 1e-2) shares[1] = static_cast<double>(with.off) / all;
      }
      rows.write("differences_that_mislead", shown);
      rows.at_least("share of differences that are off by half, step 1e-4 [-]",
                    {.limit = 0.25, .computed = shares[0], .because = "often"});
      rows.at_most("the same with step 1e-2, over it [-]",
                   {.limit = 0.8, .computed = shares[1] / shares[0], .because = "jumps average out over more of them"});
      rows.none("differences that are off by half without contacts", calm_off, "the cost is smooth");
    }};

}  // namespace verification::identification_landscapes
