#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/continuum/equation_of_state.hpp>

#include "grading.hpp"

using grading::Answers;
using grading::Draw;
using grading::Finding;
using grading::Line;
using grading::Question;

namespace {

using Found = std::optional<Finding>;
using Numbers = std::vector<double>;

// A cell, and what a gas of R and c does there.
struct Cell {
  double rho, u, theta;
};
struct Gas {
  double R, c;
  double P(const Cell& x) const { return pressure(particulate::continuum::IdealGas{R}, x.rho, x.theta); }
  double E(const Cell& x) const { return x.rho * (c * x.theta + 0.5 * x.u * x.u); }
};

enum class Mass { of_means, of_products };
enum class Momentum { split, divergence, without_P };
enum class Motion { product, square_of_mean, mean_of_squares, none };
enum class Work { crossed, of_means, straight, none };

// What a flux is made of; without more it is that of variant 1.
struct Form {
  Mass mass = Mass::of_means;
  Momentum momentum = Momentum::split;
  Motion motion = Motion::product;
  Work work = Work::crossed;
  bool divergence = false, without_heat = false;
  double sign = 1.0;
};

double mean(double a, double b) { return 0.5 * (a + b); }

Numbers flux_of(const Form& form, const Gas& gas, const Cell& l, const Cell& r) {
  const double u = mean(l.u, r.u), P = mean(gas.P(l), gas.P(r));
  const double products = mean(l.rho * l.u, r.rho * r.u);
  const double m = form.mass == Mass::of_means ? mean(l.rho, r.rho) * u : products;
  const double straight = mean(l.u * gas.P(l), r.u * gas.P(r));
  if (form.divergence) {
    return {products, mean(l.rho * l.u * l.u, r.rho * r.u * r.u) + P, mean(l.u * gas.E(l), r.u * gas.E(r)) + straight};
  }
  double momentum = m * u + P;
  if (form.momentum == Momentum::divergence) momentum = mean(l.rho * l.u * l.u, r.rho * r.u * r.u) + P;
  if (form.momentum == Momentum::without_P) momentum = m * u;
  const double motion = form.motion == Motion::product           ? 0.5 * l.u * r.u
                        : form.motion == Motion::square_of_mean  ? 0.5 * u * u
                        : form.motion == Motion::mean_of_squares ? 0.5 * mean(l.u * l.u, r.u * r.u)
                                                                 : 0.0;
  const double work = form.work == Work::crossed    ? mean(l.u * gas.P(r), r.u * gas.P(l))
                      : form.work == Work::of_means ? u * P
                      : form.work == Work::straight ? straight
                                                    : 0.0;
  const double heat = form.without_heat ? 0.0 : gas.c * mean(l.theta, r.theta);
  return {form.sign * m, form.sign * momentum, form.sign * (m * (heat + motion) + work)};
}

Form right_form(int variant) { return {.mass = variant == 1 ? Mass::of_means : Mass::of_products}; }

// All from the cell on the left.
Numbers one_sided(const Gas& gas, const Cell& l) {
  return {l.rho * l.u, l.rho * l.u * l.u + gas.P(l), l.u * (gas.E(l) + gas.P(l))};
}

std::vector<grading::Mistake> mistakes_in_flux(int variant, const Gas& gas, const Cell& l, const Cell& r) {
  const auto with = [&](auto member, auto value) {
    Form form = right_form(variant);
    form.*member = value;
    return form;
  };
  const std::vector<std::pair<Form, std::string>> flaws{
      {right_form(3 - variant),
       "the mass flux is that of the other variant: mean of rho times mean of u, or mean of rho u"},
      {with(&Form::divergence, true),
       "the plain divergence form: each flux is the mean of that in both cells. Split them: m carries the means"},
      {with(&Form::work, Work::none), "the work of pressure is missing in the energy: (u_0 P_1 + u_1 P_0)/2"},
      {with(&Form::work, Work::of_means),
       "the work of pressure takes u and P of opposite cells, not the means of both"},
      {with(&Form::work, Work::straight), "the work of pressure takes u and P of opposite cells, not of the same one"},
      {with(&Form::motion, Motion::square_of_mean),
       "kinetic energy is carried as u_0 u_1/2: the product of both velocities, not the square of their mean"},
      {with(&Form::motion, Motion::mean_of_squares),
       "kinetic energy is carried as u_0 u_1/2: the product of both velocities, not the mean of their squares"},
      {with(&Form::motion, Motion::none), "the kinetic energy that is carried along is missing: m u_0 u_1/2"},
      {with(&Form::without_heat, true), "the heat that is carried along is missing: m c (theta_0 + theta_1)/2"},
      {with(&Form::momentum, Momentum::divergence),
       "momentum as the mean of rho u^2 makes kinetic energy of nothing: m times the mean velocity"},
      {with(&Form::momentum, Momentum::without_P), "the pressure is missing in the flux of momentum"},
      {with(&Form::sign, -1.0), "the sign: fluxes count from left to right"}};
  std::vector<grading::Mistake> all =
      grading::mistakes(flaws, [&](const Form& form) { return flux_of(form, gas, l, r); });
  const std::string both = "a one-sided mean: both cells count alike";
  all.push_back({one_sided(gas, l), both});
  all.push_back({one_sided(gas, r), both});
  return all;
}

Gas drawn_gas(Draw& draw) { return {draw.between(0.2, 0.8), draw.between(1.2, 2.5)}; }
Cell drawn_cell(Draw& draw) { return {draw.between(0.5, 2.0), draw.between(0.3, 1.5), draw.between(1.0, 3.0)}; }

Question ask_flux(int variant, const Gas& gas, const Cell& l, const Cell& r) {
  return {.function = "face_flux",
          .inputs = {gas.R, gas.c, l.rho, l.u, l.theta, r.rho, r.u, r.theta},
          .expected = flux_of(right_form(variant), gas, l, r),
          .mistakes = mistakes_in_flux(variant, gas, l, r)};
}

// Where both cells are equal nothing is left to choose: rho u, rho u^2 + P, u (E + P).
Line equal_line(int variant, Draw& draw) {
  Line line{.name = "equal cells: the flux of the gas itself", .points = 2.0};
  for (const double sign : {1.0, -1.0}) {
    const Gas gas = drawn_gas(draw);
    Cell x = drawn_cell(draw);
    x.u *= sign;
    Question question = ask_flux(variant, gas, x, x);
    question.expected = one_sided(gas, x);
    line.questions.push_back(std::move(question));
  }
  return line;
}

constexpr double rounding = 1e-12;

// Seen from behind, left is right and velocities change sign; so do the fluxes of mass and energy, not of momentum.
Found mirrors(const Answers& answers, std::size_t own) {
  const Numbers &there = answers[own - 1], &behind = answers[own];
  double worst = 0.0, size = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double misses = std::abs(there[k] + (k == 1 ? -1.0 : 1.0) * behind[k]);
    if (!(misses <= worst)) worst = misses;
    size += std::abs(there[k]);
  }
  if (worst <= rounding * size && size > 0.0) return {};
  return Finding{.expected = "seen from behind, mass and energy pass with the opposite sign, momentum with the same",
                 .obtained = fmt::format("{} {} {}, and from behind {} {} {}", there[0], there[1], there[2], behind[0],
                                         behind[1], behind[2]),
                 .hint = "both cells count alike: a one-sided mean, or one cell's number for both, is seen here"};
}

Line mirror_line(int, Draw& draw) {
  Line line{.name = "mirror: the face seen from behind", .points = 3.0};
  for (int k = 0; k < 2; ++k) {
    const Gas gas = drawn_gas(draw);
    const Cell l = drawn_cell(draw), r = drawn_cell(draw);
    line.questions.push_back(
        {.function = "face_flux", .inputs = {gas.R, gas.c, l.rho, l.u, l.theta, r.rho, r.u, r.theta}, .count = 3});
    line.questions.push_back({.function = "face_flux",
                              .inputs = {gas.R, gas.c, r.rho, -r.u, r.theta, l.rho, -l.u, l.theta},
                              .count = 3,
                              .holds = mirrors});
  }
  return line;
}

Line flux_line(int variant, Draw& draw) {
  Line line{.name = "flux: between cells that differ", .points = 4.0};
  for (int k = 0; k < 3; ++k) {
    const Gas gas = drawn_gas(draw);
    const Cell l = drawn_cell(draw), r = drawn_cell(draw);
    line.questions.push_back(ask_flux(variant, gas, l, r));
  }
  return line;
}

Found makes_none(const Answers& answers, std::size_t own) {
  const double made = answers[own][0], moved = answers[own][1];
  if (std::abs(made) <= rounding * moved && moved > 0.0) return {};
  return Finding{.expected = "no kinetic energy is made of nothing, and some moves",
                 .obtained = fmt::format("{} W are made, while {} W move", made, moved),
                 .hint =
                     "the momentum that passes must be the mass that passes, the same m, times the mean of both "
                     "velocities: the plain divergence form, the mean of rho u^2, makes kinetic energy of nothing"};
}

Line convection_line(int, Draw& draw) {
  Line line{.name = "convection makes no kinetic energy", .points = 4.0};
  for (const int n : {5, 8}) {
    const Gas gas = drawn_gas(draw);
    Question question{.function = "convection", .inputs = {gas.R, gas.c}, .count = 2, .holds = makes_none};
    for (int i = 0; i < n; ++i) {
      const Cell x = drawn_cell(draw);
      question.inputs.insert(question.inputs.end(), {x.rho, i % 3 == 0 ? -x.u : x.u});
    }
    line.questions.push_back(std::move(question));
  }
  return line;
}

// -df/dx of the wave of the driver, of which the period is 1 m, by a complex step.
Numbers exact_rates(double x, double a, const Gas& gas) {
  constexpr double step = 1e-30;
  const std::complex<double> angle(2.0 * std::numbers::pi * x, step);
  const std::complex<double> rho = 1.0 + a * std::sin(angle), u = 0.5 + a * std::cos(angle),
                             theta = 2.0 + a * std::sin(2.0 * angle), P = rho * gas.R * theta;
  const std::complex<double> energy = rho * (gas.c * theta + 0.5 * u * u);
  const double slope = -2.0 * std::numbers::pi / step;
  return {slope * (rho * u).imag(), slope * (rho * u * u + P).imag(), slope * (u * (energy + P)).imag()};
}

// Root mean squares of the errors of the rates, of mass, momentum and energy.
Numbers errors(const Numbers& rates, double a, const Gas& gas) {
  const std::size_t n = rates.size() / 3;
  Numbers all(3, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const Numbers exact = exact_rates((static_cast<double>(i) + 0.5) / static_cast<double>(n), a, gas);
    for (std::size_t k = 0; k < 3; ++k) all[k] += std::pow(rates[3 * i + k] - exact[k], 2.0);
  }
  for (double& one : all) one = std::sqrt(one / static_cast<double>(n));
  return all;
}

Found converges(const Numbers& coarse, const Numbers& fine) {
  static const std::vector<std::string> names{"mass", "momentum", "energy"};
  for (std::size_t k = 0; k < 3; ++k) {
    const double order = std::log2(coarse[k] / fine[k]);
    if (std::abs(order - 2.0) <= 0.1) continue;
    return Finding{.expected = fmt::format("of {}: with cells half as long a quarter of the error, order 2", names[k]),
                   .obtained = fmt::format("errors {:.3g} and {:.3g}, order {:.2f}", coarse[k], fine[k], order),
                   .hint = order > 0.5
                               ? "order 1 is that of a one-sided mean: both cells count alike"
                               : "the error stays: something is missing in the flux, such as u P in that of energy"};
  }
  return {};
}

Line order_line(int, Draw& draw) {
  Line line{.name = "order: half as long cells, a quarter of the error", .points = 3.0};
  const Gas gas = drawn_gas(draw);
  const double a = draw.between(0.1, 0.2);
  for (const std::size_t n : {std::size_t{32}, std::size_t{64}}) {
    line.questions.push_back({.function = "wave", .inputs = {static_cast<double>(n), a, gas.R, gas.c}, .count = 3 * n});
  }
  line.questions[1].holds = [a, gas](const Answers& answers, std::size_t own) {
    return converges(errors(answers[own - 1], a, gas), errors(answers[own], a, gas));
  };
  return line;
}

enum class Ring { closed, open, ahead, turned };

Numbers rates_of(const std::vector<Cell>& cells, double h, Ring form) {
  const std::size_t n = cells.size();
  const auto flux = [&](std::size_t i) -> Numbers {  // between i - 1 and i
    const Cell &left = cells[(i + n - 1) % n], &right = cells[i % n];
    if (form == Ring::open && i % n == 0) return {0.0, 0.0, 0.0};
    if (form == Ring::turned) return {right.rho + 2.0 * left.u, right.u - 3.0 * left.theta, right.theta * left.rho};
    return {left.rho + 2.0 * right.u, left.u - 3.0 * right.theta, left.theta * right.rho};
  };
  Numbers all;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = form == Ring::ahead ? i + 1 : i;
    for (std::size_t k = 0; k < 3; ++k) all.push_back((flux(first)[k] - flux(first + 1)[k]) / h);
  }
  return all;
}

Numbers times(Numbers x, double factor) {
  for (double& one : x) one *= factor;
  return x;
}

std::vector<Cell> add_cells(Question& question, int n, Draw& draw) {
  std::vector<Cell> cells;
  for (int i = 0; i < n; ++i) {
    const Cell x = drawn_cell(draw);
    cells.push_back(x);
    question.inputs.insert(question.inputs.end(), {x.rho, x.u, x.theta});
  }
  return cells;
}

Line ring_line(int, Draw& draw) {
  Line line{.name = "ring: rates from the fluxes at both faces", .points = 2.0, .absolute = rounding};
  for (const int n : {2, 4, 5}) {
    const double h = draw.between(0.1, 0.6);
    Question question{.function = "ring_rates", .inputs = {h}};
    const std::vector<Cell> cells = add_cells(question, n, draw);
    const Numbers right = rates_of(cells, h, Ring::closed);
    question.expected = right;
    question.mistakes = {{times(right, -1.0), "the sign: what comes in at the left minus what leaves at the right"},
                         {times(right, h), "the length is missing: rates are per volume, so divide by h"},
                         {times(right, h * h), "multiplied by the length: divide by h"},
                         {rates_of(cells, h, Ring::open), "the ring is open: the last cell's neighbour is the first"},
                         {rates_of(cells, h, Ring::ahead), "these are the rates of the next cell: off by one"},
                         {rates_of(cells, h, Ring::turned), "left and right are exchanged in the call of flux"}};
    line.questions.push_back(std::move(question));
  }
  return line;
}

Found conserves(const Answers& answers, std::size_t own) {
  static const std::vector<std::string> names{"mass", "momentum", "energy"};
  for (std::size_t k = 0; k < 3; ++k) {
    const double made = answers[own][k], moved = answers[own][k + 3];
    if (std::abs(made) <= rounding * moved && moved > 0.0) continue;
    return Finding{.expected = fmt::format("the {} of the ring stays, and moves from cell to cell", names[k]),
                   .obtained = fmt::format("rates whose sum is {} and whose sizes add up to {}", made, moved),
                   .hint =
                       "what leaves one cell enters the next, by one flux for both; and the last cell's next is "
                       "the first"};
  }
  return {};
}

Line conservation_line(int, Draw& draw) {
  Line line{.name = "conservation: mass, momentum and energy of a ring", .points = 2.0};
  for (const int n : {3, 7}) {
    const Gas gas = drawn_gas(draw);
    Question question{
        .function = "conservation", .inputs = {draw.between(0.1, 0.6), gas.R, gas.c}, .count = 6, .holds = conserves};
    add_cells(question, n, draw);
    line.questions.push_back(std::move(question));
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  return grading::run(
      argc, argv,
      {.title = "Chapter 8: the flux between two cells",
       .variants = {"the mass flux of means, mean of rho times mean of u", "the mass flux of products, mean of rho u"},
       .lines = {equal_line, mirror_line, flux_line, convection_line, order_line, ring_line, conservation_line},
       .calls = {{"face_flux", "R c left[3] right[3] -> flux[3]"},
                 {"convection", "R c ... rho u -> made moved"},
                 {"wave", "n a R c -> ... rates[3]"},
                 {"ring_rates", "h ... cell[3] -> ... rates[3]"},
                 {"conservation", "h R c ... cell[3] -> made[3] moved[3]"}}});
}
