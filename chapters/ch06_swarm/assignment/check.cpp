#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <particulate/swarm/objective.hpp>

#include "cloud.hpp"
#include "grading.hpp"

using grading::Draw;
using grading::Line;
using grading::Question;

namespace {

using Eigen::Index;

// What the driver is asked for, in the order of its inputs.
struct Paths {
  double N, n, p, T, lost, when, w, seed;

  std::vector<double> inputs() const { return {N, n, p, T, lost, when, w, seed}; }
  double share(Index k) const { return std::pow(static_cast<double>(k) / n, p); }
  Index moments() const { return static_cast<Index>(n) + 1; }
  Index lost_at() const { return static_cast<Index>(when * n); }
};

const Eigen::Vector3d target(12.0, 5.0, 5.0);

// Where the members would be if nobody were lost, as in the driver: a row each.
class Places {
 public:
  explicit Places(const Paths& of) {
    const auto N = static_cast<Index>(of.N);
    const auto at = cloud::shares(static_cast<std::uint64_t>(of.seed), static_cast<std::size_t>(2 * N));
    Eigen::Matrix3Xd share(3, 2 * N);
    for (Index i = 0; i < 2 * N; ++i) share.col(i) = Eigen::Vector3d(at[static_cast<std::size_t>(i)].data());
    from_ = share.leftCols(N).transpose();
    to_ = share.rightCols(N).transpose();
  }
  particulate::kinematics::Vectors at(double s) const { return 10.0 * (from_ + s * (to_ - from_)); }

 private:
  particulate::kinematics::Vectors from_, to_;
};

// The library's mean over time and these members, of whom the first ones are lost.
double mean_of(const Paths& of, Index first, Index count) {
  using namespace particulate;
  const Places places(of);
  const auto some = [&](Index k) {
    const Index lost = std::clamp(static_cast<Index>(of.lost) - first, Index{0}, count);
    kinematics::Vectors now = places.at(of.share(k)).middleRows(first, count);
    if (k > of.lost_at()) now.topRows(lost) = places.at(of.share(of.lost_at())).middleRows(first, lost);
    return now;
  };
  kinematics::Particles start{.position = some(0),
                              .velocity = kinematics::Vectors::Zero(count, 3),
                              .mass = Eigen::VectorXd::Ones(count),
                              .radius = Eigen::VectorXd::Zero(count)};
  swarm::Objective objective(target, start);
  for (Index k = 1; k < of.moments(); ++k) {
    const schemes::State to{.r = some(k).reshaped(), .v = start.velocity.reshaped()};
    objective(to, to, of.T * (of.share(k) - of.share(k - 1)), 0);
  }
  return objective.mean();
}

// Variant 2 is the mean of what each member would have alone.
double expected(const Paths& of, int variant) {
  const Index N = static_cast<Index>(of.N);
  double mean = variant == 1 ? mean_of(of, 0, N) : 0.0;
  for (Index i = 0; variant == 2 && i < N; ++i) mean += mean_of(of, i, 1) / of.N;
  return mean + of.w * of.lost / of.N;
}

enum class Over { start, other_variant, nothing, start_of_one };
enum class Time { right, moments, left_ends, right_ends, whole_ends, end_alone, no_duration };
enum class Lost { stay, fly_on, vanish, left_out, removed };
enum class Penalty { right, none, of_each, without_w };

// One thing that can be wrong.
struct Flaw {
  Over over = Over::start;
  Time time = Time::right;
  Lost lost = Lost::stay;
  Penalty penalty = Penalty::right;
};

// The share of each moment in a mean over time.
Eigen::VectorXd weights(const Eigen::VectorXd& t, Time flaw) {
  const Index n = t.size() - 1;
  const Eigen::VectorXd dt = t.tail(n) - t.head(n);
  Eigen::VectorXd w = Eigen::VectorXd::Zero(n + 1);
  if (flaw == Time::moments) return Eigen::VectorXd::Constant(n + 1, 1.0 / static_cast<double>(n + 1));
  if (flaw == Time::end_alone) return Eigen::VectorXd::Unit(n + 1, n);
  w.head(n) += (flaw == Time::left_ends ? 1.0 : flaw == Time::right_ends ? 0.0 : 0.5) * dt;
  w.tail(n) += (flaw == Time::left_ends ? 0.0 : flaw == Time::right_ends ? 1.0 : 0.5) * dt;
  if (flaw == Time::whole_ends) w[0] = dt[0], w[n] = dt[n - 1];
  return flaw == Time::no_duration ? w : w / (t[n] - t[0]);
}

// Distances, a row a member and a column a moment, with what is counted of the lost.
Eigen::MatrixXd distances(const Paths& of, Lost flaw) {
  const Index N = static_cast<Index>(of.N), lost = static_cast<Index>(of.lost);
  const Places places(of);
  Eigen::MatrixXd d(N, of.moments());
  for (Index k = 0; k < of.moments(); ++k) {
    d.col(k) = (places.at(of.share(k)).rowwise() - target.transpose()).rowwise().norm();
    if (k <= of.lost_at()) continue;
    if (flaw == Lost::stay) d.col(k).head(lost) = d.col(of.lost_at()).head(lost);
    if (flaw == Lost::vanish || flaw == Lost::left_out) d.col(k).head(lost).setZero();
    if (flaw == Lost::left_out) d.col(k) *= of.N / (of.N - of.lost);
  }
  if (flaw == Lost::removed) d = d.bottomRows(N - lost).eval();
  return d;
}

double with_flaw(const Flaw& flaw, const Paths& of, int variant) {
  Eigen::VectorXd t(of.moments());
  for (Index k = 0; k < t.size(); ++k) t[k] = of.T * of.share(k);
  const Eigen::MatrixXd d = distances(of, flaw.lost);
  const Eigen::VectorXd w = weights(t, flaw.time);
  const bool of_its_own = (variant == 2) != (flaw.over == Over::other_variant);
  double mean = of_its_own ? (d * w).cwiseQuotient(d.col(0)).mean() : (d * w).sum() / d.col(0).sum();
  if (flaw.over == Over::nothing) mean = (d * w).mean();
  if (flaw.over == Over::start_of_one) mean *= static_cast<double>(d.rows());
  if (flaw.penalty == Penalty::none) return mean;
  return mean +
         (flaw.penalty == Penalty::without_w ? 1.0 : of.w) * of.lost / (flaw.penalty == Penalty::of_each ? 1.0 : of.N);
}

std::vector<grading::Mistake> mistakes_in(const Paths& of, int variant) {
  std::vector<std::pair<Flaw, std::string>> flaws{
      {{.over = Over::other_variant}, "this is the mean of the other variant: over whose start is it taken?"},
      {{.over = Over::nothing}, "distances in metres: divide by those at the start"},
      {{.over = Over::start_of_one}, "N times too much: a mean over the members, not their sum"},
      {{.time = Time::end_alone}, "this is the last moment alone: take the mean over time"},
      {{.time = Time::moments}, "the mean over the moments: steps are unequal, and each counts by its length"},
      {{.time = Time::left_ends}, "steps count by their starts alone: take the mean of both ends of each"},
      {{.time = Time::right_ends}, "steps count by their ends alone: take the mean of both ends of each"},
      {{.time = Time::whole_ends}, "the first and the last moment have one step beside them, so half as much weight"},
      {{.time = Time::no_duration}, "T times too much: divide the integral by the duration"},
      {{.lost = Lost::fly_on}, "the lost count where they would be: they stay where they were lost"},
      {{.lost = Lost::vanish}, "the lost are no longer summed: their distance stays what it was"}};
  if (of.lost < of.N) {
    flaws.push_back({{.lost = Lost::left_out}, "the mean is over those who still fly: the lost stay in it"});
    flaws.push_back({{.lost = Lost::removed}, "the lost are left out from the start on: they stay in the mean"});
  }
  flaws.push_back({{.penalty = Penalty::none}, "the penalty is missing"});
  flaws.push_back({{.penalty = Penalty::of_each}, "w for each of the lost: the penalty is w if all are lost"});
  flaws.push_back({{.penalty = Penalty::without_w}, "the share of the lost is there, its factor w is not"});
  return grading::mistakes(flaws,
                           [&](const Flaw& flaw) -> std::vector<double> { return {with_flaw(flaw, of, variant)}; });
}

Question ask(const Paths& of, int variant) {
  return {.function = "straight_paths",
          .inputs = of.inputs(),
          .expected = {expected(of, variant)},
          .mistakes = mistakes_in(of, variant)};
}

// So many steps that any rule for the mean over time is right to a thousandth.
constexpr double many = 2000.0, thousandth = 1e-3;

double seed(Draw& draw) { return 1.0 + draw.one_of(1000000); }

// With the distance d = 10 - 2 t^2 up to 0.75 s, and falling by 3 m/s from there on: (7.21875 + 12.375)/30.
Line closed_line(int, Draw&) {
  Line line{.name = "closed form: one member under a constant pull and a cap, 0.653125",
            .points = 4.0,
            .relative = thousandth};
  line.questions = {{.function = "capped_fall",
                     .inputs = {many},
                     .expected = {0.653125},
                     .mistakes = {{{6.53125}, "distances in metres: divide by those at the start"},
                                  {{0.2125}, "this is the last moment alone: take the mean over time"},
                                  {{1.959375}, "T times too much: divide the integral by the duration"},
                                  {{1.653125}, "a penalty, although nobody is lost: -1 is no moment"}}}};
  return line;
}

Line members_line(int variant, Draw& draw) {
  Line line{.name = "members: their mean, over that at the start", .points = 4.0, .relative = thousandth};
  for (const double N : {2.0, 5.0, 12.0}) {
    line.questions.push_back(ask({N, many, 1.0, draw.between(2.0, 9.0), 0.0, 0.0, 1.0, seed(draw)}, variant));
  }
  return line;
}

Line time_line(int variant, Draw& draw) {
  Line line{.name = "time: steps, also unequal ones, by the trapezoidal rule", .points = 4.0};
  for (const double n : {4.0, 7.0, 1.0}) {
    line.questions.push_back(ask({3.0, n, 2.0, draw.between(2.0, 9.0), 0.0, 0.0, 1.0, seed(draw)}, variant));
  }
  return line;
}

Line lost_line(int variant, Draw& draw) {
  Line line{.name = "lost: they count where they were lost", .points = 4.0, .relative = thousandth};
  for (const double lost : {1.0, 2.0, 4.0}) {
    line.questions.push_back(
        ask({4.0, many, 1.0, draw.between(2.0, 9.0), lost, draw.between(0.2, 0.5), 0.0, seed(draw)}, variant));
  }
  return line;
}

// Lost in the last moment, so that it does not matter where they stay.
Line penalty_line(int variant, Draw& draw) {
  Line line{.name = "penalty: w times the share of the lost", .points = 4.0, .relative = thousandth};
  for (const double lost : {1.0, 3.0, 5.0}) {
    line.questions.push_back(
        ask({5.0, many, 1.0, draw.between(2.0, 9.0), lost, 1.0, draw.between(1.5, 4.0), seed(draw)}, variant));
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  return grading::run(
      argc, argv,
      {.title = "Chapter 6: the objective of a swarm",
       .variants = {"the mean distance of the members, over their mean distance at the start",
                    "the mean over the members of each one's distance over its own at the start"},
       .lines = {closed_line, members_line, time_line, lost_line, penalty_line},
       .calls = {{"straight_paths", "N n p T lost when w seed -> objective"}, {"capped_fall", "n -> objective"}}});
}
