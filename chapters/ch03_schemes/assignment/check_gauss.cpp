#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "grading.hpp"

using grading::Draw;
using grading::Line;
using grading::Question;

namespace {

using Two = std::array<long double, 2>;

// A motion in one dimension, and the step that the student makes of it: a(r) = B/r^3 - A/r^2 - k r.
struct Motion {
  double r = 0.0, v = 0.0, dt = 0.0;
  int sweeps = 0;
  double A = 0.0, B = 0.0, k = 0.0;
  long double acceleration(long double x) const { return (B / x - A) / (x * x) - k * x; }
};

// A method of two stages.
struct Coefficients {
  Two c, b, b_bar;
  std::array<Two, 2> A_bar;
};

struct Flaw {
  bool A_for_A_bar = false, transposed = false, swapped_weights = false, mean_acceleration = false, trapezoidal = false,
       one_sweep = false, one_more_sweep = false, in_turn = false, other_guess = false, no_drift = false,
       dt_for_its_square = false;
  long double root = 0.0L;  // taken for sqrt(3)
};

const std::string more_digits = "sqrt(3) has more digits than you gave it: write std::sqrt(3.0)";

const std::vector<std::pair<Flaw, std::string>> flaws{
    {{.A_for_A_bar = true}, "the places of the stages take A_bar = A A, not A: the rates of positions are velocities"},
    {{.transposed = true}, "row i of A_bar belongs to stage i: rows and columns are swapped"},
    {{.swapped_weights = true}, "b_bar_i = b_i (1 - c_i): the earlier stage moves the position for longer"},
    {{.mean_acceleration = true}, "the position ends with b_bar = A^T b, not with dt^2/2 times the mean acceleration"},
    {{.trapezoidal = true}, "these are the nodes 0 and 1 of the trapezoidal rule: Gauss nodes lie inside the step"},
    {{.one_sweep = true}, "one sweep is not enough: make as many as `sweeps` says"},
    {{.one_more_sweep = true}, "a sweep too many: the guess a_1 = a_2 = 0 is none"},
    {{.in_turn = true}, "all at once: a sweep takes both places from the accelerations of the sweep before"},
    {{.other_guess = true}, "the sweeps start from free flight, a_1 = a_2 = 0"},
    {{.no_drift = true}, "the stages drift: their places begin with r + c_i dt v"},
    {{.dt_for_its_square = true}, "accelerations move positions by dt^2, velocities by dt"},
    {{.root = 1.73L}, more_digits},
    {{.root = 1.732L}, more_digits},
    {{.root = 1.73205L}, more_digits},
    {{.root = 1.7320508L}, more_digits}};

Coefficients coefficients(const Flaw& flaw) {
  if (flaw.trapezoidal) {
    return {.c = {0.0L, 1.0L}, .b = {0.5L, 0.5L}, .b_bar = {0.25L, 0.25L}, .A_bar = {{{0.0L, 0.0L}, {0.25L, 0.25L}}}};
  }
  const long double root = flaw.root > 0.0L ? flaw.root : std::sqrt(3.0L);
  Coefficients of{.c = {0.5L - root / 6, 0.5L + root / 6},
                  .b = {0.5L, 0.5L},
                  .b_bar = {0.25L + root / 12, 0.25L - root / 12},
                  .A_bar = {{{1.0L / 24, 0.125L - root / 12}, {0.125L + root / 12, 1.0L / 24}}}};
  if (flaw.A_for_A_bar) of.A_bar = {{{0.25L, 0.25L - root / 6}, {0.25L + root / 6, 0.25L}}};
  if (flaw.transposed) std::swap(of.A_bar[0][1], of.A_bar[1][0]);
  if (flaw.swapped_weights) std::swap(of.b_bar[0], of.b_bar[1]);
  if (flaw.mean_acceleration) of.b_bar = {0.25L, 0.25L};
  return of;
}

// The step in extended precision, right or with a flaw.
std::vector<double> step(const Motion& of, const Flaw& flaw) {
  const Coefficients method = coefficients(flaw);
  const long double dt = of.dt, by_place = flaw.dt_for_its_square ? dt : dt * dt;
  const int sweeps = flaw.one_sweep ? 1 : flaw.one_more_sweep ? of.sweeps + 1 : of.sweeps;
  Two a{};
  if (flaw.other_guess) a.fill(of.acceleration(of.r));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    Two next = a;
    for (std::size_t i = 0; i < 2; ++i) {
      const Two& seen = flaw.in_turn ? next : a;
      const long double drift = flaw.no_drift ? 0.0L : method.c[i] * dt * of.v;
      next[i] =
          of.acceleration(of.r + drift + by_place * (method.A_bar[i][0] * seen[0] + method.A_bar[i][1] * seen[1]));
    }
    a = next;
  }
  return {static_cast<double>(of.r + dt * of.v + by_place * (method.b_bar[0] * a[0] + method.b_bar[1] * a[1])),
          static_cast<double>(of.v + dt * (method.b[0] * a[0] + method.b[1] * a[1]))};
}

// On a spring, in closed form: the factor (1 + z/2 + z^2/12)/(1 - z/2 + z^2/12) at z = i omega dt has the size one, so
// that energy stays, and turns (r, v/omega) by an angle that is off by a term in dt^5, as order four has it.
std::vector<double> spring_step(const Motion& of) {
  const long double omega = std::sqrt(static_cast<long double>(of.k)), z = omega * of.dt;
  const long double angle = 2.0L * std::atan2(z / 2, 1.0L - z * z / 12);
  return {static_cast<double>(of.r * std::cos(angle) + of.v / omega * std::sin(angle)),
          static_cast<double>(of.v * std::cos(angle) - of.r * omega * std::sin(angle))};
}

Question ask(const Motion& of, std::vector<double> expected) {
  return {.function = "gauss2_step",
          .inputs = {of.r, of.v, of.dt, static_cast<double>(of.sweeps), of.A, of.B, of.k},
          .expected = std::move(expected),
          .mistakes = grading::mistakes(flaws, [&](const Flaw& flaw) { return step(of, flaw); })};
}

constexpr int enough = 60;

Motion of_pair(Draw& draw) {
  return {.r = draw.between(0.9, 1.1),
          .v = draw.between(0.2, 0.4),
          .dt = draw.between(0.2, 0.3),
          .sweeps = enough,
          .A = draw.between(0.8, 1.2),
          .B = draw.between(0.3, 0.5)};
}

Line line(const char* name, double points, std::vector<Question> questions) {
  return {.name = name,
          .points = points,
          .relative = 1e-11,
          .otherwise =
              "compare your c, A_bar and b_bar with A A and A^T b on paper: sum over a row of A_bar is c_i^2/2, "
              "b_bar sums to 1/2",
          .questions = std::move(questions)};
}

}  // namespace

Line gauss_step(int, Draw& draw) {
  const Motion spring{.r = draw.between(0.6, 1.4),
                      .v = draw.between(0.6, 1.4),
                      .dt = draw.between(0.4, 0.6),
                      .sweeps = enough,
                      .k = draw.between(1.5, 2.5)};
  const Motion pair = of_pair(draw);
  Motion back = pair;
  const std::vector<double> there = step(pair, {});
  back.r = there[0];
  back.v = there[1];
  back.dt = -pair.dt;
  return line("gauss2_step: sweeps enough, of a spring, of a pair, and back again", 3.0,
              {ask(spring, spring_step(spring)), ask(pair, there), ask(back, {pair.r, pair.v})});
}

Line gauss_sweeps(int, Draw& draw) {
  Motion one = of_pair(draw), two = of_pair(draw);
  one.sweeps = 1;
  two.sweeps = 2;
  return line("gauss2_step: one sweep, and two", 2.0, {ask(two, step(two, {})), ask(one, step(one, {}))});
}
