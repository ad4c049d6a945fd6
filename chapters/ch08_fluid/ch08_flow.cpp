//! @page ch08_flow Chapter 8: A fluid on a grid
//! @brief Sound, vortices, a liquid between walls, and a shock, beside what closed forms know of them.
//! @tableofcontents
//!
//! @section ch08_flow_question What a fluid does by itself
//!
//! Before particles come into it, the fluid alone must do what fluids do.
//!
//! @figure{ch08_vortices, Sixteen vortices in a periodic box\, every second one turning the other way. Slightly disturbed\, those that turn alike merge. Colour: vorticity.}
//!
//! We ask of it what can be answered: do sound, friction, heat and a shock come out as closed forms have them? And does
//! what should stay do so, to the last digit?
//!
//! @section ch08_flow_model The model (8.1)
//!
//! A fluid has a density, a velocity and a temperature at every place. @ref appA_balance "Appendix A" derives what they
//! obey: mass, momentum and energy change by what passes, with forces f and heat q from elsewhere,
//!
//! \f[ \frac{\partial \rho}{\partial t} = -\nabla \cdot (\rho v), \qquad
//!     \rho \left( \frac{\partial v}{\partial t} + v \cdot \nabla v \right) = \nabla \cdot \sigma + f, \qquad
//!     \rho c \left( \frac{\partial \theta}{\partial t} + v \cdot \nabla \theta \right)
//!     = \sigma : \nabla v + \nabla \cdot (K \nabla \theta) + q , \f]
//!
//! \f[ \sigma = -P I + \lambda \operatorname{tr}(D)\, I + 2 \mu D . \f]
//!
//! Pressure is that of a liquid near a state that is known, or of an ideal gas,
//!
//! \f[ P = P_R + Y \left( \frac{\rho}{\rho_R} - 1 + a_{th} (\theta - \theta_R) \right) \quad\text{or}\quad
//!     P = \rho R\, \theta . \f]
//!
//! On this page f and q are zero. A fluid that is barotropic knows no temperature, and leaves out the last equation.
//! The monograph's fluid fills a *representative element* that repeats itself (@ref ch08_question "figure 8.2"):
//! periodic faces. We add walls, at rest or sliding, of a temperature or letting no heat through; faces beyond which
//! the fluid is known; and faces through which it leaves (particulate::fluid::Boundary).
//!
//! @section ch08_flow_scheme On a grid (8.2)
//!
//! A box in equal cells; numbers stand for their middles. The monograph takes central differences. So do we, but not of
//! the equations above: of those for \f$ \rho, \rho v \f$ and \f$ E = \rho\,(c\,\theta + \tfrac12 v^2) \f$, as *fluxes*
//! across faces. What leaves a cell enters its neighbour, so that sums over the box stay as they are to rounding.
//!
//! A product can be averaged in several ways, and one of them is good. Across a face between the cells 0 and 1, with
//! bars for means, mass passes as \f$ m = \bar\rho\,\bar u_a \f$ and carries momentum as \f$ m \bar u \f$ (Kennedy and
//! Gruber). Cell 0 then loses by convection the kinetic energy
//!
//! \f[ u_0 \cdot (m\, \bar u) - \tfrac12 u_0^2\, m = \tfrac12\, m\, u_0 \cdot u_1 , \f]
//!
//! which is symmetric in 0 and 1, and therefore just what cell 1 gains. Plain differences of \f$ \rho v v \f$ make
//! energy of nothing, until they blow up. The rest of the fluxes, and viscous stresses, stand with
//! particulate::fluid::Flow. Errors fall as the square of the cells' edge h.
//!
//! What remains is a problem of first order, as @ref ch03_schemes "chapter 3" has them: any of its schemes will do
//! (8.3).
//!
//! @section ch08_flow_program The program

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/fluid/snapshot.hpp>

#include "ch08_fluid.hpp"

namespace ch08 {
namespace {

//! @section ch08_sound Sound
//!
//! A pulse runs through a closed tube with the speed \f$ c_s = \sqrt{Y/\rho_R} \f$, and back. On its way viscosity
//! spreads it: waves of number k fade as \f$ e^{-\nu_L k^2 t/2} \f$ with \f$ \nu_L = (\lambda + 2 \mu)/\rho \f$, so a
//! Gaussian stays one, and the square of its width grows by \f$ \nu_L t \f$. Walls do what mirrors do.

struct Pulse {
  double c, nu_L, width, start;  // [m/s], [m^2/s], [m], [m]

  // In a tube of length 1, over the height at the start.
  double operator()(double t, double x) const {
    const double square = width * width + nu_L * t;
    double sum = 0.0;
    for (int k = -4; k <= 4; ++k) {
      for (const double place : {start + c * t, -start - c * t})
        sum += std::exp(-0.5 * std::pow(x - place + 2.0 * k, 2) / square);
    }
    return width / std::sqrt(square) * sum;
  }
};

double sound(Eigen::Index n, report::Table& table) {
  constexpr double height = 1e-4;  // of the density, over rho_R
  const continuum::Barotropic liquid{.P_R = 1e5, .Y = 1e5, .rho_R = 1000.0};
  const double mu = 5.0, c = speed_of_sound(liquid, liquid.rho_R);
  const BarotropicFlow<1> tube(Grid<1>{.cells = {n}}, {.state = liquid, .viscosity = {mu}}, {Wall<1>{}, Wall<1>{}});
  const Pulse pulse{.c = c, .nu_L = 4.0 / 3.0 * mu / liquid.rho_R, .width = 0.04, .start = 0.2};
  State state = tube.start([&](const Vector<1>& x) {
    const double denser = height * pulse(0.0, x[0]);
    return Local<1>{.rho = liquid.rho_R * (1.0 + denser), .v = Vector<1>(c * denser)};
  });
  double off = 0.0;
  int profile = 0;
  follow("sound", tube, state, equal_times(0.3, 15), [&](const State& at) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = tube.grid().centre({i})[0], P = (pressure(liquid, at.y[i]) - liquid.P_R) / (height * liquid.Y);
      if (i % (n / 128) == 0) table.add({n, profile, at.t, x, P, pulse(at.t, x)});
      off = report::worse_of(off, std::abs(P - pulse(at.t, x)));
    }
    ++profile;
  });
  return off;
}

void sounds(report::Chapter& chapter) {
  report::Table table({"cells", "profile", "t [s]", "x [m]", "P - P_R over that at the start", "closed form"});
  const double coarse = sound(256, table), fine = sound(512, table);
  chapter.output().write("sound", table);
  chapter.claims("checks").add("sound: order of its error, less 2", std::log2(coarse / fine) - 2.0, 0.2);
}

//! @figure{ch08_sound, A pulse of pressure in a tube\, again and again\, later ones higher up. Grey: the closed form.}
//!
//! At a wall the pulse is for a moment twice as high. On a grid short waves are slower than long ones, so that a pulse
//! lags a little behind, the less the finer the grid.
//!
//! @section ch08_eddies Vortices
//!
//! Taylor and Green's vortices, in two dimensions,
//!
//! \f[ v = \left( \sin kx\, \cos ky,\; -\cos kx\, \sin ky \right), \qquad
//!     P = P_R + \tfrac14 \rho_R \left( \cos 2kx + \cos 2ky \right) , \f]
//!
//! stand still, and without compression lose kinetic energy as \f$ e^{-4 \nu k^2 t} \f$; without viscosity none. Here
//! sound is ten times as fast as they are, and what they do differs from that by the order of a hundredth.

BarotropicFlow<2> box(const Parameters& p, Eigen::Index n, double mu) {
  const double edge = 2.0 * std::numbers::pi;
  return {Grid<2>{.cells = {n, n}, .lengths = {edge, edge}},
          {.state = {.P_R = 100.0, .Y = 100.0, .rho_R = 1.0}, .viscosity = {mu}},
          {},
          p.line.common().threads};
}

Local<2> taylor_green(const BarotropicFlow<2>& flow, double k, const Vector<2>& x) {
  const double a = k * x[0], b = k * x[1];
  return {.rho = 1.0 + 0.25 * (std::cos(2.0 * a) + std::cos(2.0 * b)) / flow.fluid().state.Y,
          .v = {std::sin(a) * std::cos(b), -std::cos(a) * std::sin(b)}};
}

double kinetic_energy(const BarotropicFlow<2>& flow, const State& at) {
  double sum = 0.0;
  for (Eigen::Index n = 0; n < flow.grid().size(); ++n) {
    const Local<2> here = flow.local(at, n);
    sum += 0.5 * here.rho * here.v.squaredNorm();
  }
  return sum;
}

void decay(const Parameters& p, report::Chapter& chapter) {
  report::Table table({"viscosity", "t", "kinetic energy over that at the start", "closed form"});
  double lost = 0.0;
  for (const double mu : {0.0, 0.01, 0.03, 0.1}) {
    const BarotropicFlow<2> flow = box(p, 32, mu);
    State state = flow.start([&](const Vector<2>& x) { return taylor_green(flow, 1.0, x); });
    const double at_first = kinetic_energy(flow, state);
    follow("vortices", flow, state, equal_times(20.0, 40), [&](const State& at) {
      const double left = kinetic_energy(flow, at) / at_first;
      table.add({mu, at.t, left, std::exp(-4.0 * mu * at.t)});
      if (mu == 0.0) lost = report::worse_of(lost, std::abs(left - 1.0));
    });
  }
  chapter.output().write("decay", table);
  chapter.claims("checks").add("vortices without viscosity: kinetic energy over that at the start, less 1", lost, 1e-3);
}

//! @figure{ch08_decay, What is left of the kinetic energy of vortices. Grey: the closed form.}
//!
//! Many of them do not stand still for long. Sixteen, with a weak flow on top that is as large as the box, are those of
//! the first figure. Files `vortices_00.vti` and so on show them in ParaView (particulate::fluid::write_vtk).

double vorticity(const BarotropicFlow<2>& flow, const State& at, Eigen::Index i, Eigen::Index j) {
  const Grid<2>& grid = flow.grid();
  const auto v = [&](Eigen::Index x, Eigen::Index y) {
    return flow.local(at, grid.index({(x + grid.cells[0]) % grid.cells[0], (y + grid.cells[1]) % grid.cells[1]})).v;
  };
  return (v(i + 1, j)[1] - v(i - 1, j)[1]) / (2.0 * grid.h(0)) - (v(i, j + 1)[0] - v(i, j - 1)[0]) / (2.0 * grid.h(1));
}

void add_picture(const BarotropicFlow<2>& flow, const State& at, int picture, report::Table& table) {
  const auto shown = [](double x) { return std::round(1000.0 * x) / 1000.0; };
  const Grid<2>& grid = flow.grid();
  const Eigen::Index every = grid.cells[0] / 32;
  for (Eigen::Index j = 0; j < grid.cells[1]; j += every) {
    for (Eigen::Index i = 0; i < grid.cells[0]; i += every) {
      const Vector<2> x = grid.centre({i, j}), v = flow.local(at, grid.index({i, j})).v;
      table.add({picture, at.t, shown(x[0]), shown(x[1]), shown(vorticity(flow, at, i, j)), shown(v[0]), shown(v[1])});
    }
  }
}

void merging(const Parameters& p, report::Chapter& chapter) {
  const BarotropicFlow<2> flow = box(p, p.vortices, 1e-3);
  State state = flow.start([&](const Vector<2>& x) {
    Local<2> here = taylor_green(flow, 2.0, x);
    here.v += 0.05 * Vector<2>(std::sin(x[1] + 0.3), std::sin(x[0] + 1.0));
    return here;
  });
  const auto mass = [&](const State& at) { return at.y.head(flow.grid().size()).sum(); };
  const double at_first = mass(state);
  report::Table table({"picture", "t", "x", "y", "vorticity", "u", "v"});
  int picture = 0;
  follow("vortices that merge", flow, state, equal_times(30.0, 40), [&](const State& at) {
    add_picture(flow, at, picture, table);
    if (p.files > 0 && picture % p.files == 0) {
      std::ostringstream text;
      write_vtk(text, flow, at);
      chapter.output().write_file(fmt::format("vortices_{:02}.vti", picture), text.str());
    }
    ++picture;
  });
  chapter.output().write("vortices", table);
  chapter.claims("checks").add("vortices that merge: mass over that at the start, less 1", mass(state) / at_first - 1.0,
                               1e-13);
}

//! @section ch08_couette Between two walls
//!
//! One wall slides, the other rests, and friction sets the liquid in motion, layer by layer. With one viscosity the
//! velocity ends as a straight line. Where the sliding wall is hot and the resting one cold, and the liquid thins,
//! \f$ \mu = \mu_R e^{c_\mu (\theta_R/\theta - 1)} \f$, it shears most where it is thinnest: friction is the same
//! everywhere, so that \f$ u \f$ grows as \f$ \int dy/\mu \f$. Temperature itself is a straight line, as walls move too
//! slowly to heat the liquid by friction.

double thinned(double c_mu, double y) {
  const auto fluidity = [&](double at) { return std::exp(c_mu * (1.0 - 300.0 / (300.0 + 100.0 * at))); };
  const auto integral = [&](double to) {  // Simpson's rule
    constexpr int pieces = 200;
    double sum = fluidity(0.0) + fluidity(to);
    for (int k = 1; k < pieces; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * fluidity(to * k / pieces);
    return sum * to / (3.0 * pieces);
  };
  return integral(y) / integral(1.0);
}

//! While the liquid is being set in motion, a Fourier series knows what it does, at \f$ \tau = \nu t/h^2 \f$:

double dragged_along(double tau, double y) {
  double u = y;
  for (int k = 1; k <= 60; ++k) {
    const double a = k * std::numbers::pi;
    u += (k % 2 == 0 ? 2.0 : -2.0) / a * std::exp(-a * a * tau) * std::sin(a * y);
  }
  return u;
}

constexpr double U = 0.1, nu = 0.1;  // [m/s], [m^2/s]

template <class F, class Expected>
State between_walls(const char* liquid, const F& flow, const std::vector<double>& taus, const Expected& expected,
                    report::Table& table) {
  const Grid<2>& grid = flow.grid();
  State state = flow.start([](const Vector<2>& x) { return Local<2>{.rho = 1000.0, .theta = 300.0 + 100.0 * x[1]}; });
  std::vector<double> times = taus;
  for (double& t : times) t /= nu;
  follow("between walls", flow, state, times, [&](const State& at) {
    for (Eigen::Index j = 0; j < grid.cells[1]; ++j) {
      const double y = grid.centre({0, j})[1];
      table.add({liquid, nu * at.t, y, flow.local(at, grid.index({0, j})).v[0] / U, expected(nu * at.t, y)});
    }
  });
  return state;
}

void couette(const Parameters& p, report::Chapter& chapter) {
  constexpr Eigen::Index n = 32;
  const Grid<2> grid{.cells = {4, n}, .lengths = {4.0, 1.0}};
  const continuum::LinearizedState law{.Y = 1e5, .a_th = 0.0};
  const double mu = nu * law.rho_R, c = 2500.0;
  const Boundaries<2> walls{Periodic{}, Periodic{}, Wall<2>{.theta = 300.0},
                            Wall<2>{.velocity = {U, 0.0}, .theta = 400.0}};
  const LiquidFlow<2> even(grid, {.state = law, .viscosity = {mu}, .c = c, .K = mu * c}, walls);
  const ThinningFlow<2> thin(grid, {.state = law, .viscosity = {.mu_R = mu, .c_mu = p.c_mu}, .c = c, .K = mu * c},
                             walls);
  report::Table table({"liquid", "t nu/h^2", "y/h", "u/U", "closed form"});
  between_walls("even", even, {0.005, 0.02, 0.05, 0.1, 0.2, 2.0}, dragged_along, table);
  const auto at_the_end = [&](double, double y) { return thinned(p.c_mu, y); };
  const State end = between_walls("thin", thin, {3.0}, at_the_end, table);
  chapter.output().write("couette", table);
  const auto u = [&](Eigen::Index j) { return thin.local(end, grid.index({0, j})).v[0] / U; };
  const double middle = 0.5 * (u(n / 2 - 1) + u(n / 2)), expected = thinned(p.c_mu, 0.5);
  chapter.summary().add({"thinning liquid, u/U halfway between the walls", middle});
  chapter.summary().add({"the same, closed form", expected});
  chapter.claims("checks").add("thinning liquid: u/U halfway between the walls, less that of the closed form",
                               middle - expected, 1e-4);
}

//! @figure{ch08_couette, Left: a liquid of one viscosity is set in motion\, at six times. Right: where it ends\, and where a liquid does that thins. Grey lines: closed forms.}
//!
//! @section ch08_shock A shock
//!
//! Seen from a shock, gas comes in at \f$ u_1 \f$, faster than sound by the factor M, and leaves denser, hotter and
//! slow. What is in between only friction and conduction decide. For \f$ Pr = \tfrac34 \f$ Becker found, with
//! \f$ v = u/u_1 \f$ and far behind the shock \f$ v_f = (\gamma - 1 + 2/M^2)/(\gamma + 1) \f$,
//!
//! \f[ x = \frac{8 \gamma}{3 (\gamma + 1)} \frac{\mu}{\rho_1 u_1}
//!     \frac{\ln(1 - v) - v_f \ln(v - v_f)}{1 - v_f}, \qquad c_p\, \theta + \tfrac12 u^2 = \text{const} . \f]
//!
//! Here lengths are in \f$ \mu/(\rho_1 u_1) \f$ and velocities in \f$ u_1 \f$. At both ends the fluid is given; in
//! between it finds its way from the closed form, at which it begins, to where the grid wants it.

struct Becker {
  double M;
  static constexpr double gamma = 1.4, c = 2.5, c_p = gamma * c;
  double v_f = (gamma - 1.0 + 2.0 / (M * M)) / (gamma + 1.0);
  double width = 8.0 * gamma / (3.0 * (gamma + 1.0) * (1.0 - v_f));
  double theta_1 = 1.0 / (gamma * M * M);

  double x(double v) const { return width * (std::log(1.0 - v) - v_f * std::log(v - v_f)); }
  Local<1> operator()(double at) const {
    double slow = v_f, fast = 1.0;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (slow + fast);
      (x(middle) > at ? slow : fast) = middle;
    }
    const double v = 0.5 * (slow + fast);
    return {.rho = 1.0 / v, .v = Vector<1>(v), .theta = theta_1 + 0.5 * (1.0 - v * v) / c_p};
  }
};

double shock(double M, Eigen::Index n, report::Table& table) {
  const Becker exact{.M = M};
  const Grid<1> grid{.cells = {n}, .lengths = Vector<1>(8.0 * exact.width), .corner = Vector<1>(-5.0 * exact.width)};
  const Local<1> before = exact(grid.centre({-1})[0]), behind = exact(grid.centre({n})[0]);
  const Given<1> known{[&](double, const Vector<1>& x) { return x[0] < 0.0 ? before : behind; }};
  const GasFlow<1> flow(grid, {.state = {.R = 1.0}, .viscosity = {1.0}, .c = Becker::c, .K = Becker::c_p / 0.75},
                        {known, known});
  State state = flow.start([&](const Vector<1>& x) { return exact(x[0]); });
  double off = 0.0;
  follow("a shock", flow, state, {100.0}, [&](const State& at) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = grid.centre({i})[0];
      const Local<1> here = flow.local(at, i), there = exact(x);
      table.add({M, n, x, here.v[0], here.theta / exact.theta_1, there.v[0], there.theta / exact.theta_1});
      off = report::worse_of(off, std::abs(here.v[0] - there.v[0]));
    }
  });
  return off;
}

void shocks(report::Chapter& chapter) {
  report::Table table(
      {"M", "cells", "x", "u/u_1", "theta/theta_1", "closed form of u/u_1", "closed form of theta/theta_1"});
  for (const double M : {1.5, 3.0}) {
    const double coarse = shock(M, 64, table), fine = shock(M, 128, table);
    const std::string name = fmt::format("shock of M = {}: ", M);
    chapter.summary().add({name + "velocity on 128 cells, off the closed form, over u_1", fine});
    chapter.claims("checks").add(name + "order of the error of its velocity, less 2", std::log2(coarse / fine) - 2.0,
                                 0.2);
  }
  chapter.output().write("shock", table);
}

//! @figure{ch08_shock, Two shocks: the gas comes from the left. Points: cells. Grey: Becker's closed form.}
//!
//! A shock without friction has no width, and central differences have no answer to it. This fluid is for flows in
//! which friction is resolved.

}  // namespace

void flow_alone(const Parameters& p, report::Chapter& chapter) {
  sounds(chapter);
  decay(p, chapter);
  merging(p, chapter);
  couette(p, chapter);
  shocks(chapter);
}

}  // namespace ch08

//! @section ch08_flow_exercises Exercises
//!
//! 1. Which viscosity makes the pulse in the tube too weak to be seen when it is back? Estimate it, then try.
//! 2. Give the sixteen vortices no disturbance. How long do they stand? What disturbs them in the end?
//! 3. Take the heat that friction makes into account: let the wall slide at 100 m/s. Where is the liquid hottest, and
//!    by how much? The closed form for one viscosity is \f$ \theta - \theta_{line} = \mu U^2 y (h - y)/(2 K h^2) \f$.
