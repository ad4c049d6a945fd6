//! @page appA_continuum Appendix A: Continuum mechanics
//! @brief How matter deforms that fills space, what keeps it in balance, and what makes it a fluid.
//! @tableofcontents
//!
//! @section appA_question From particles to a continuum
//!
//! Chapter 8 of the monograph @cite zohdi2007 puts particles into a fluid. Appendix A states what a fluid is: matter
//! without gaps, each point of which moves. Where it was tells where it is, \f$ x = x(X, t) \f$, and all else follows
//! from how that changes from point to point.
//!
//! @figure{appA_motion, A sheet before (thin) and after a motion. Circles become ellipses\, as F says. On the right edge: what was the normal\, carried along like a line (orange)\, and the normal that is one (green).}
//!
//! Only the titles of the appendix were at hand. What stands here is textbook mechanics in the monograph's notation, and
//! where the fluid's laws are ours the [equation index](@ref equation_index) says so. Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target appA_continuum
//! build/release/bin/appA_continuum --out appA
//! @endverbatim
//!
//! It takes less than a second.
//!
//! @section appA_program The program

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include <particulate/continuum/equation_of_state.hpp>
#include <particulate/continuum/stress.hpp>
#include <particulate/report/chapter.hpp>

namespace {

using namespace particulate;
using namespace particulate::continuum;

using report::between;
constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& stretch = line.field(1.3, {"stretch", "of the sheet along x", "-", between(0.7, 1.5), ours});
  double& bend_x =
      line.field(0.4, {"bend_x", "how far the motion bends lines along y", "1/m", between(0.1, 0.45), ours});
  double& bend_y = line.field(0.25, {"bend_y", "and lines along x", "1/m", between(0.1, 0.45), ours});
  double& mu = line.field(1.0, {"mu", "viscosity", "Pa s", between(1e-6, 1e6), ours});
  double& rate =
      line.field(2.0, {"rate", "of shear, turning or growth, in the table of flows", "1/s", between(1e-3, 1e3), ours});
  double& P_R = line.field(1e5, {"pressure", "pressure of the state that is known", "Pa", between(1e4, 1e7), ours});
  double& Y = line.field(1e5, {"bulk_modulus", "bulk modulus of the linear fluid", "Pa", between(1e5, 1e10), ours});
};

//! @section appA_deformation Lines, areas, volumes (A.1, A.2)
//!
//! Near a point a motion is linear. Its derivative, the **deformation gradient**, and its determinant say what becomes
//! of a short line, of a small area with its normal, and of a volume:
//!
//! \f[ F = \frac{\partial x}{\partial X}, \quad J = \det F, \qquad
//!     dx = F\, dX, \qquad n\, da = J F^{-T} N\, dA, \qquad dv = J\, dV . \f]
//!
//! That of areas is Nanson's formula (particulate::continuum::deformed_area). A normal is *not* carried along as a line
//! is, as the figure shows: it must stay normal to lines that are. The program has no derivatives typed in; it takes a
//! complex step, \f$ f'(s) = \operatorname{Im} f(s + i h)/h \f$ with h as small as one likes, since nothing is
//! subtracted (particulate::continuum::gradient). The motion of the figure:

struct Motion {
  double stretch, k, b;

  template <class S>
  Vector<S> operator()(const Vector<S>& X) const {
    return {stretch * X[0] + k * X[1] * X[1], X[1] / stretch + b * X[0] * X[0], X[2] * (1.0 + 0.5 * X[0])};
  }
  Tensor<double> F(const Vector<double>& X) const {
    return gradient([this](const Vector<std::complex<double>>& at) { return (*this)(at); }, X);
  }
  // By hand, to hold F against.
  double J(const Vector<double>& X) const { return (1.0 - 4.0 * k * b * X[0] * X[1]) * (1.0 + 0.5 * X[0]); }
};

void write_sheet(const Motion& motion, report::Chapter& chapter) {
  report::Table lines({"line", "X [m]", "Y [m]", "x [m]", "y [m]"});
  const auto add = [&](int line, const Vector<double>& X, const Vector<double>& x) {
    lines.add({line, X[0], X[1], x[0], x[1]});
  };
  for (int k = 0; k <= 4; ++k) {
    for (int j = 0; j <= 20; ++j) {
      const Vector<double> up(0.25 * k, 0.05 * j, 0.0), along(0.05 * j, 0.25 * k, 0.0);
      add(k, up, motion(up));
      add(5 + k, along, motion(along));
    }
  }
  double off = 0.0;
  for (int k = 0; k < 16; ++k) {
    const int row = k / 4, column = k % 4;
    const Vector<double> middle(0.25 * column + 0.125, 0.25 * row + 0.125, 0.0);
    const Tensor<double> F = motion.F(middle);
    off += std::abs(jacobian(F) / motion.J(middle) - 1.0);
    for (int j = 0; j <= 36; ++j) {
      const double angle = j * std::numbers::pi / 18.0;
      const Vector<double> dX = 0.09 * Vector<double>(std::cos(angle), std::sin(angle), 0.0);
      add(10 + k, middle + dX, motion(middle) + deformed_line(F, dX));
    }
  }
  chapter.output().write("lines", lines);
  chapter.claims("checks").add("J by complex steps over that by hand, less 1, sixteen times", off, 1e-14);
}

void write_normals(const Motion& motion, report::Chapter& chapter) {
  report::Table normals({"x [m]", "y [m]", "kind", "u [m]", "v [m]"});
  double slanted = 0.0;
  for (int k = 0; k <= 4; ++k) {
    const Vector<double> X(1.0, 0.25 * k, 0.0), N(0.2, 0.0, 0.0), T(0.0, 1.0, 0.0), x = motion(X);
    const Tensor<double> F = motion.F(X);
    const Vector<double> carried = deformed_line(F, N), n = deformed_area(F, N), edge = deformed_line(F, T);
    normals.add({x[0], x[1], 1, carried[0], carried[1]});
    normals.add({x[0], x[1], 2, n[0], n[1]});
    slanted += std::abs(n.dot(edge)) / (n.norm() * edge.norm());
  }
  chapter.output().write("normals", normals);
  chapter.claims("checks").add("cosines between mapped normals and the deformed edge", slanted, 1e-14);
}

//! How small is small? A tetrahedron of edge h, deformed corner by corner, says by how much these maps miss its edge, a
//! face and its volume.

void write_elements(const Motion& motion, report::Chapter& chapter) {
  report::Table table({"h [m]", "edge", "face", "volume"});
  const Vector<double> X(0.3, 0.4, 0.2), a(1.0, 0.2, 0.1), b(-0.1, 1.0, 0.3), c(0.2, -0.3, 1.0);
  const Tensor<double> F = motion.F(X);
  std::vector<Eigen::Array3d> off;
  for (int k = 2; k <= 10; ++k) {
    const double h = std::ldexp(1.0, -k);
    const Vector<double> x = motion(X), to_a = motion(Vector<double>(X + h * a)) - x,
                         to_b = motion(Vector<double>(X + h * b)) - x, to_c = motion(Vector<double>(X + h * c)) - x;
    const Vector<double> face = deformed_area<double>(F, 0.5 * h * h * a.cross(b));
    const double volume = to_a.dot(to_b.cross(to_c)) / 6.0;
    off.emplace_back((to_a - deformed_line<double>(F, h * a)).norm() / to_a.norm(),
                     (0.5 * to_a.cross(to_b) - face).norm() / face.norm(),
                     std::abs(deformed_volume(F, h * h * h * a.dot(b.cross(c)) / 6.0) / volume - 1.0));
    table.add({h, off.back()[0], off.back()[1], off.back()[2]});
  }
  chapter.output().write("elements", table);
  const Eigen::Array3d order = (off[off.size() - 2] / off.back()).log() / std::log(2.0);
  chapter.claims("checks").add("orders of the errors of edge, face and volume, less 1, in all",
                               (order - 1.0).abs().sum(), 0.02);
}

//! @figure{appA_elements, By how much the maps miss a body of size h\, relative\, with a slope of 1 (grey).}
//!
//! In time, the **velocity gradient** \f$ L = \nabla v = \dot F F^{-1} \f$ does for rates what F does for places. Its
//! symmetric part D stretches, its antisymmetric part W turns, and volumes grow as \f$ \dot J = J\, \nabla \cdot v \f$
//! (particulate::continuum::jacobian_rate). Strain that no rotation touches is \f$ E = \tfrac12 (F^T F - I) \f$.
//!
//! @section appA_stress Forces inside (A.3, A.4)
//!
//! On a plane in the matter acts a force per area, the **traction** t, which depends on the plane's normal n. How, a
//! tetrahedron tells. Its faces grow as h squared, its mass as h cubed; so as it shrinks the forces on its faces must
//! balance by themselves, whatever the motion. The face across n has \f$ n_j \f$ of its area before each plane of the
//! axes, and therefore
//!
//! \f[ t = \sigma\, n, \f]
//!
//! with the **stress** \f$ \sigma_{ij} \f$: force along i, on the plane across j (particulate::continuum::traction).
//!
//! @figure{appA_tetrahedron, Cauchy's tetrahedron\, a material point in section: Figure A.1.}
//!
//! @section appA_balance What stays (A.5 to A.7)
//!
//! For any part of the matter its mass stays; its momentum changes by tractions and by forces from outside, f per
//! volume; so does its angular momentum; and its energy changes by the power of both, by the flow h of heat, and by q
//! from elsewhere. With \f$ \int \sigma n\, da = \int \nabla \cdot \sigma\, dv \f$ each of these holds at a point:
//!
//! \f[ \rho J = \rho_0 \;\text{ or }\; \dot\rho + \rho\, \nabla \cdot v = 0, \qquad
//!     \rho\, \dot v = \nabla \cdot \sigma + f, \qquad \sigma = \sigma^T, \qquad
//!     \rho\, \dot e = \sigma : \nabla v - \nabla \cdot h + q . \f]
//!
//! A dot is the rate that moves along, \f$ \partial/\partial t + v \cdot \nabla \f$. The third follows as Cauchy's
//! relation did: on a cube of edge h the torque of what is not symmetric is as h cubed, its moment of
//! inertia as h to the fifth. Of the last, the energy of motion is gone already, as momentum times v. The library holds
//! each law as what is left over (particulate::continuum::momentum_residual and its neighbours), and the verification
//! of this appendix shows that nothing is in flows that are known, a shock among them.
//!
//! @section appA_fluid What makes it a fluid (A.8)
//!
//! A Newtonian fluid resists the rate of its deformation, in proportion, and alike in all directions:
//!
//! \f[ \sigma = -P I + \lambda \operatorname{tr}(D)\, I + 2 \mu D . \f]
//!
//! What it takes from the motion becomes heat, and may not be negative: \f$ \mu \ge 0 \f$ and
//! \f$ \lambda + \tfrac23 \mu \ge 0 \f$ (particulate::continuum::dissipation). The program has the simplest flows, with
//! \f$ \lambda = 0 \f$.

void write_flows(const Parameters& p, report::Chapter& chapter) {
  report::Table table(
      {"flow", "sigma_xx + P [Pa]", "sigma_yy + P [Pa]", "sigma_xy [Pa]", "div v [1/s]", "dissipation [W/m^3]"});
  const Newtonian law{.mu = p.mu, .lambda = 0.0};
  validate(law);
  Tensor<double> shear = Tensor<double>::Zero();
  shear(0, 1) = p.rate;
  const Tensor<double> turning = shear - shear.transpose(), growth = p.rate * Tensor<double>::Identity();
  const Tensor<double> pull = p.rate * Tensor<double>(Vector<double>(1.0, -0.5, -0.5).asDiagonal());
  double off = 0.0;
  const auto add = [&](const char* name, const Tensor<double>& L) {
    const Tensor<double> D = rate_of_deformation(L), tau = viscous_stress(law, D);
    table.add({name, tau(0, 0), tau(1, 1), tau(0, 1), D.trace(), dissipation(law, D)});
    off += std::abs(stress_power(tau, L) - dissipation(law, D)) / (p.mu * p.rate * p.rate);
  };
  add("simple shear, v_x = rate y", shear);
  add("rotation", turning);
  add("expansion, v = rate x", growth);
  add("a thread that is pulled", pull);
  chapter.output().write("flows", table);
  chapter.claims("checks").add("power of the viscous stress, over mu rate^2, less what is dissipated", off, 1e-14);
}

//! An **equation of state** closes the set. The monograph's fluid is linear about a known state,
//! \f$ P = P_R + Y (\rho/\rho_R - 1 + a_{th} (\theta - \theta_R)) \f$; we add the ideal gas. Both get the energy
//! \f$ e = c\, \theta \f$. Compressed without heat or friction, all work then shows as temperature,
//! \f$ d\theta/d\rho = P/(\rho^2 c) \f$, along which sound runs (particulate::continuum::speed_of_sound). Thermodynamics
//! would have \f$ \theta\, (\partial P/\partial\theta)/(\rho^2 c) \f$ there (Gibbs). The two agree for a gas alone.
//! Viscosity may fall as a liquid warms, \f$ \mu = \mu_R e^{c_\mu (\theta_R/\theta - 1)} \f$
//! (particulate::continuum::ExponentialViscosity).

struct Compressed {
  double by_work, by_gibbs;  // warming by 1 % of compression [K]
};
template <class Law>
Compressed compressed(const Law& law, double rho, double theta, double c) {
  // Halfway; as pressure is linear in temperature, any difference is a derivative.
  const double P = pressure(law, 1.005 * rho, theta),
               per_kelvin = (pressure(law, 1.005 * rho, theta + 100.0) - P) / 100.0;
  return {0.01 * P / (rho * c), 0.01 * theta * per_kelvin / (rho * c)};
}

void write_states(const Parameters& p, report::Chapter& chapter) {
  const double c = 717.5, theta = 300.0;
  const LinearizedState fluid{.P_R = p.P_R, .Y = p.Y}, water{.P_R = 1e5, .Y = 2.2e9, .a_th = 2e-4};
  const LinearizedState stiff{.P_R = p.P_R, .Y = 1e10};
  const IdealGas air{.R = 287.0};
  validate(fluid);
  validate(air);
  const double rho_air = p.P_R / (air.R * theta);
  report::Table table({"fluid", "speed of sound [m/s]", "warms by 1 % of compression [K]", "after Gibbs [K]"});
  const auto add = [&](const char* name, const auto& law, double rho, double heat_capacity) {
    const Compressed warm = compressed(law, rho, theta, heat_capacity);
    table.add({name, speed_of_sound(law, rho, theta, heat_capacity), warm.by_work, warm.by_gibbs});
    return warm;
  };
  add("linear", fluid, 1000.0, 2500.0);
  add("the same with Y = 1e10 Pa", stiff, 1000.0, 2500.0);
  add("like water", water, 1000.0, 4180.0);
  const Compressed gas = add("air", air, rho_air, c);
  chapter.output().write("fluids", table);
  chapter.claims("checks").add("air: warming by work over that after Gibbs, less 1", gas.by_work / gas.by_gibbs - 1.0,
                               1e-12);

  report::Table curves({"rho/rho_R", "linear", "linear, stiffer", "gas at one temperature", "gas without heat"});
  const LinearizedState stiffer{.P_R = p.P_R, .Y = 3.0 * p.Y};
  for (int k = 0; k <= 150; ++k) {
    const double ratio = 0.5 + 0.01 * k, rho = 1000.0 * ratio, warm = theta * std::pow(ratio, air.R / c);
    curves.add({ratio, pressure(fluid, rho, theta) / p.P_R, pressure(stiffer, rho, theta) / p.P_R,
                pressure(air, rho_air * ratio, theta) / p.P_R, pressure(air, rho_air * ratio, warm) / p.P_R});
  }
  chapter.output().write("pressures", curves);
}

void run(const Parameters& p, report::Chapter& chapter) {
  const Motion motion{p.stretch, p.bend_x, p.bend_y};
  write_sheet(motion, chapter);
  write_normals(motion, chapter);
  write_elements(motion, chapter);
  write_flows(p, chapter);
  write_states(p, chapter);
}

}  // namespace

int main(int argc, char** argv) {
  return report::run_chapter(argc, argv,
                             {.name = "appA_continuum",
                              .summary = "Appendix A: deformation, balance laws, a Newtonian fluid.",
                              .out = "appA",
                              .figures = "chapters/appA_continuum/figures.gp"},
                             "none", run);
}

//! @section appA_results What comes of it
//!
//! @table{appA_flows}
//!
//! Rotation costs nothing, and a simple shear is half of one. A thread feels three times what a shear of the same rate
//! does, \f$ \sigma_{xx} - \sigma_{yy} = 3 \mu \dot\epsilon \f$ (Trouton).
//!
//! @figure{appA_pressures, Pressure against density: the linear fluid\, and a gas at one temperature and without heat.}
//!
//! With \f$ Y = P_R \f$ the linear fluid *is* a gas at one temperature, so far as pressure goes. A stiffer one holds
//! together where a gas would spread: below \f$ \rho/\rho_R = 1 - P_R/Y \f$ its pressure is negative, and nothing in the
//! law makes it boil.
//!
//! @table{appA_fluids}
//!
//! With the smallest Y that we believe the monograph uses, sound is no faster than a cyclist. That makes it affordable to
//! compute, and flows must be much slower to count as incompressible. Warming by work and after Gibbs differ for every
//! liquid. It is little either way; what drives a liquid's temperature is friction and conduction.
//!
//! @section appA_held What held
//!
//! @table{appA_checks}
//!
//! The parameters of the run that made this page:
//!
//! @parameters{appA}
//!
//! @section appA_exercises Exercises
//!
//! 1. Show that \f$ J F^{-T} \f$ has the cross products of F's columns for columns, and so needs no inverse. What does
//!    it make of areas when \f$ J = 0 \f$?
//! 2. Areas of a closed surface add up to zero before and after any motion. Which identity for \f$ J F^{-T} \f$ is that?
//! 3. For which flow is \f$ D = 0 \f$ everywhere, but \f$ L \f$ not? Are there others?
//! 4. Derive \f$ c_s \f$ of an ideal gas from \f$ d\theta/d\rho = P/(\rho^2 c) \f$. What did Newton get, who kept
//!    \f$ \theta \f$?
//! 5. Find an energy \f$ e(\rho, \theta) \f$ that makes the linear fluid agree with Gibbs.
