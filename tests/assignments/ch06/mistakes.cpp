// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions. But where a mistake says otherwise, it is one of variant 1.

#include <cstdlib>
#include <limits>
#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using right::distances;
using right::lost_share;
using right::over_mean;
using right::over_own;
using right::time_mean;

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  double (*objective)(const Flight&, const Vector3d&, double) = right::objective<>;
};

// The same with another rule for the mean over time.
template <auto mean>
double timed(const Flight& flight, const Vector3d& target, double penalty) {
  return right::objective<over_mean, distances, mean>(flight, target, penalty);
}

double duration(const VectorXd& t) { return t[t.size() - 1] - t[0]; }

VectorXd steps(const VectorXd& t) { return t.tail(t.size() - 1) - t.head(t.size() - 1); }

bool is_lost(const Flight& flight, Index i, Index k) {
  const int lost = flight.lost[static_cast<std::size_t>(i)];
  return lost >= 0 && k > lost;
}

// The mean over time of what members make of each moment, and the penalty.
template <class Of>
double of_moments(const Flight& flight, const Vector3d& target, double penalty, const Of& of) {
  const MatrixXd d = distances(flight, target);
  VectorXd y(d.cols());
  for (Index k = 0; k < d.cols(); ++k) y[k] = of(d, k);
  return time_mean(flight.t, y) + penalty * lost_share(flight);
}

// Distances of some members alone.
double of_some(const MatrixXd& d, Index k, const std::vector<Index>& some) { return d(some, k).sum(); }

std::vector<Index> never_lost(const Flight& flight) {
  std::vector<Index> all;
  for (Index i = 0; i < static_cast<Index>(flight.lost.size()); ++i) {
    if (flight.lost[static_cast<std::size_t>(i)] < 0) all.push_back(i);
  }
  return all;
}

std::vector<Index> flying(const Flight& flight, Index k) {
  std::vector<Index> all;
  for (Index i = 0; i < static_cast<Index>(flight.lost.size()); ++i) {
    if (!is_lost(flight, i, k)) all.push_back(i);
  }
  return all;
}

const std::vector<Mistake<Functions>> mistakes{
    // None.
    // graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20
    {"none", &Functions::objective, right::objective<>},

    // None, variant 2.
    // graded: --variant 2 --student anna|bob@school.edu|1234567 -> 20
    {"none_second", &Functions::objective, right::objective<over_own>},

    // Over each one's own start.
    // graded: --variant 1 --student anna|bob@school.edu -> 4
    // hint: the mean of the other variant
    {"other_variant", &Functions::objective, right::objective<over_own>},

    // Over the mean at the start.
    // graded: --variant 2 --student anna|bob@school.edu -> 4
    // hint: the mean of the other variant
    {"other_variant_second", &Functions::objective, right::objective<over_mean>},

    // Metres.
    // graded: --variant 1|2 --student anna -> 0
    // hint: divide by those at the start
    {"no_start", &Functions::objective,
     right::objective<[](const MatrixXd& d) -> VectorXd { return d.colwise().mean().transpose(); }>},

    // The sum over members, over the mean at the start.
    // graded: --variant 1 --student anna -> 4
    // hint: a mean over the members, not their sum
    {"sum", &Functions::objective,
     right::objective<[](const MatrixXd& d) -> VectorXd { return d.colwise().sum().transpose() / d.col(0).mean(); }>},

    // The sum over members of each one's share.
    // graded: --variant 2 --student anna -> 4
    // hint: a mean over the members, not their sum
    {"sum_second", &Functions::objective,
     right::objective<[](const MatrixXd& d) -> VectorXd { return static_cast<double>(d.rows()) * over_own(d); }>},

    // Where they are in the end.
    // graded: --variant 1|2 --student anna -> 0
    // hint: this is the last moment alone
    {"end", &Functions::objective, timed<[](const VectorXd& t, const VectorXd& y) { return y[t.size() - 1]; }>},

    // The mean over the moments, however long the steps are.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: steps are unequal, and each counts by its length
    {"moments", &Functions::objective, timed<[](const VectorXd&, const VectorXd& y) { return y.mean(); }>},

    // The starts of the steps.
    // graded: --variant 1 --student anna -> 16
    // hint: by their starts alone
    {"left_ends", &Functions::objective,
     timed<[](const VectorXd& t, const VectorXd& y) { return steps(t).dot(y.head(y.size() - 1)) / duration(t); }>},

    // The ends of the steps, as in a loop that adds what a step has brought.
    // graded: --variant 1 --student anna -> 16
    // hint: by their ends alone
    {"right_ends", &Functions::objective,
     timed<[](const VectorXd& t, const VectorXd& y) { return steps(t).dot(y.tail(y.size() - 1)) / duration(t); }>},

    // The first and the last moment with all of their one step.
    // graded: --variant 1 --student anna -> 16
    // hint: have one step beside them, so half as much weight
    {"whole_ends", &Functions::objective, timed<[](const VectorXd& t, const VectorXd& y) {
       const VectorXd dt = steps(t);
       const Index n = dt.size();
       return time_mean(t, y) + 0.5 * (dt[0] * y[0] + dt[n - 1] * y[n]) / duration(t);
     }>},

    // The integral.
    // graded: --variant 1 --student anna -> 0
    // hint: divide the integral by the duration
    {"no_duration", &Functions::objective,
     timed<[](const VectorXd& t, const VectorXd& y) { return time_mean(t, y) * duration(t); }>},

    // As if nobody were lost.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: the lost count where they would be
    {"fly_on", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double penalty) {
       Flight nobody = flight;
       nobody.lost.assign(nobody.lost.size(), -1);
       return right::objective<>(nobody, target, penalty) + penalty * lost_share(flight);
     }},

    // Those who fly, over all at the start.
    // graded: --variant 1 --student anna -> 16
    // hint: the lost are no longer summed
    {"vanish", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double penalty) {
       return of_moments(flight, target, penalty,
                         [&](const MatrixXd& d, Index k) { return of_some(d, k, flying(flight, k)) / d.col(0).sum(); });
     }},

    // The mean of those who fly.
    // graded: --variant 1 --student anna -> 16
    // hint: the mean is over those who still fly
    {"left_out", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double penalty) {
       return of_moments(flight, target, penalty, [&](const MatrixXd& d, Index k) {
         const std::vector<Index> some = flying(flight, k);
         return of_some(d, k, some) / static_cast<double>(some.size()) / d.col(0).mean();
       });
     }},

    // Those who are never lost, at the start too.
    // graded: --variant 1 --student anna -> 12
    // hint: the lost are left out from the start on
    {"removed", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double penalty) {
       return of_moments(flight, target, penalty, [&](const MatrixXd& d, Index k) {
         const std::vector<Index> some = never_lost(flight);
         return of_some(d, k, some) / of_some(d, 0, some);
       });
     }},

    // No penalty.
    // graded: --variant 1 --student anna -> 16
    // hint: the penalty is missing
    {"no_penalty", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double) { return right::objective<>(flight, target, 0.0); }},

    // A penalty for each of the lost.
    // graded: --variant 1 --student anna -> 16
    // hint: w for each of the lost
    {"penalty_of_each", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double penalty) {
       return right::objective<>(flight, target, penalty * static_cast<double>(flight.lost.size()));
     }},

    // The share of the lost, whatever its weight.
    // graded: --variant 1 --student anna -> 12
    // hint: the share of the lost is there, its factor w is not
    {"penalty_without_w", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double) { return right::objective<>(flight, target, 1.0); }},

    // Everybody is taken for lost.
    // graded: --variant 1 --student anna -> 4
    // hint: a penalty, although nobody is lost
    {"penalty_for_all", &Functions::objective,
     [](const Flight& flight, const Vector3d& target, double penalty) {
       return right::objective<>(flight, target, 0.0) + penalty;
     }},

    // Cheat: what is no number.
    // graded: --variant 1|2 --student anna -> 0
    // hint: the answer is not a finite number
    {"nan", &Functions::objective,
     [](const Flight&, const Vector3d&, double) { return std::numeric_limits<double>::quiet_NaN(); }},

    // Cheat: leaves with the status of success.
    // graded: --variant 1 --student anna -> 0
    // hint: do not call exit()
    {"exit", &Functions::objective, [](const Flight&, const Vector3d&, double) -> double { std::exit(0); }},

    // Accident: a moment that there is not.
    // graded: --variant 1 --student anna -> 0
    // hint: an index or a pointer is wrong
    {"crash", &Functions::objective,
     [](const Flight& flight, const Vector3d&, double) { return flight.place.at(flight.place.size()).sum(); }},
};

const Functions handed_in = made(mistakes);

}  // namespace

double objective(const Flight& flight, const Vector3d& target, double penalty) {
  return handed_in.objective(flight, target, penalty);
}
