// Made-up flows: for every law, field and kind of boundary, in one, two and three dimensions, the error falls as h^2.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "manufactured.hpp"

namespace verification::manufactured_flows {

using namespace particulate;
using enum Faces;

constexpr std::array names{"periodic", "held", "adiabatic", "moving", "slipping", "given", "out high", "out low"};
constexpr std::array axes{"x", "y", "z"};

// Errors of one field on one grid: root of the mean square, and the largest.
struct Errors {
  std::vector<double> mean, largest;
};

// What a made-up flow has become at its end, less what it should, field by field: density, momentum along each axis,
// energy over c.
template <class Flow>
void add_errors(const MadeUp<Sourced<Flow>::Dim>& exact, Eigen::Index n, const MadeOf& of,
                std::array<Errors, Flow::numbers>& errors) {
  constexpr double dim = Sourced<Flow>::Dim, end = dim > 1 ? 0.3 : 0.4;
  const double cells = static_cast<double>(n);
  Sourced<Flow> problem(exact, n, of);
  schemes::State state = problem.exact(0.0);
  // Sound, and what decays: both well within the stability of the steps.
  const double step = std::min(0.6 / (cells * std::sqrt(dim)), 0.375 / (of.mu * cells * cells * dim));
  advance<schemes::RungeKutta4>(problem, state, end, static_cast<long>(std::ceil(end / step)));
  const Eigen::VectorXd off = state.y - problem.exact(end).y;
  const Eigen::Index size = problem.flow().grid().size();
  for (int f = 0; f < Flow::numbers; ++f) {
    const Eigen::VectorXd of_field = off.segment(f * size, size) / (f == 1 + Sourced<Flow>::Dim ? of.c : 1.0);
    Errors& here = errors[static_cast<std::size_t>(f)];
    here.mean.push_back(of_field.norm() / std::sqrt(static_cast<double>(size)));
    here.largest.push_back(of_field.lpNorm<Eigen::Infinity>());
  }
}

template <class Flow>
void converge(Rows& rows, const std::array<Faces, std::size_t{Sourced<Flow>::Dim}>& faces) {
  constexpr int dim = Sourced<Flow>::Dim;
  // Grids of which each is at least 5/4 of the one before.
  const std::array<std::vector<Eigen::Index>, 3> quick{
      {{24, 32, 40, 52, 66}, {12, 15, 19, 24, 30}, {8, 10, 13, 17, 22}}};
  const double finer = rows.quick() ? 1.0 : dim == 3 ? 1.5 : 2.0;
  // Where more is given than a flow needs, what it does not need comes back from the faces in sawteeth, which decay.
  const bool all_given = std::ranges::all_of(faces, [](Faces here) { return here == given; });
  const MadeOf of = all_given ? MadeOf{.K = 0.2, .mu = 0.1} : MadeOf{};
  std::vector<double> steps;
  std::array<Errors, Flow::numbers> errors;
  for (const Eigen::Index cells : quick[dim - 1]) {
    const auto n = static_cast<Eigen::Index>(finer * static_cast<double>(cells));
    add_errors<Flow>({.faces = faces, .steady = dim > 1}, n, of, errors);
    steps.push_back(1.0 / static_cast<double>(n));
  }
  std::string where;
  for (std::size_t a = 0; a < dim; ++a)
    where += fmt::format("{} {}, ", axes[a], names[static_cast<std::size_t>(faces[a])]);
  const auto row = [&](const std::string& what, const std::vector<double>& off) {
    rows.order(fmt::format("{}-D, {}{}", dim, where, what),
               {.nominal = 2.0, .steps = steps, .errors = off, .floor = 1e-14, .because = "central differences"});
  };
  for (int f = 0; f < Flow::numbers; ++f) {
    const Errors& here = errors[static_cast<std::size_t>(f)];
    const std::string field = f == 0     ? "density"
                              : f <= dim ? fmt::format("momentum in {}", axes[static_cast<std::size_t>(f - 1)])
                                         : "energy";
    row(field, here.mean);
    if (dim == 1) row(field + ", largest", here.largest);
  }
}

template <class Flow>
void in_a_line(Rows& rows) {
  for (const Faces faces : {periodic, held, adiabatic, moving, slips, given, leaves_high, leaves_low}) {
    converge<Flow>(rows, {faces});
  }
}
template <class Flow>
void in_a_plane(Rows& rows) {
  using Both = std::array<Faces, 2>;
  for (const Both& faces : {Both{held, slips},
                            {slips, held},
                            {adiabatic, periodic},
                            {periodic, adiabatic},
                            {moving, periodic},
                            {periodic, moving},
                            {given, leaves_high},
                            {leaves_low, given},
                            {given, given}}) {
    converge<Flow>(rows, faces);
  }
}

Claim claim(const char* fluid, const char* text) {
  return {
      .name = fmt::format("manufactured_{}", fluid),
      .claim = fmt::format("{}: at every kind of boundary every field converges with the square of the cells", text),
      .equation = "D 8.2",
      .reference = Reference::convergence};
}

const Case gas{claim("gas", "an ideal gas"), [](Rows& rows) {
                 in_a_line<fluid::GasFlow<1>>(rows);
                 in_a_plane<fluid::GasFlow<2>>(rows);
                 converge<fluid::GasFlow<3>>(rows, {held, slips, adiabatic});
               }};
const Case liquid{claim("liquid", "a liquid near a known state"), [](Rows& rows) {
                    in_a_line<fluid::LiquidFlow<1>>(rows);
                    in_a_plane<fluid::LiquidFlow<2>>(rows);
                    converge<fluid::LiquidFlow<3>>(rows, {leaves_high, given, periodic});
                  }};
const Case barotropic{claim("barotropic", "a fluid without temperature"), [](Rows& rows) {
                        in_a_line<fluid::BarotropicFlow<1>>(rows);
                        in_a_plane<fluid::BarotropicFlow<2>>(rows);
                        converge<fluid::BarotropicFlow<3>>(rows, {periodic, moving, periodic});
                      }};
const Case thinning{claim("thinning_liquid", "a liquid that thins as it warms"), [](Rows& rows) {
                      in_a_plane<fluid::ThinningFlow<2>>(rows);
                      converge<fluid::ThinningFlow<3>>(rows, {adiabatic, periodic, held});
                    }};

}  // namespace verification::manufactured_flows
