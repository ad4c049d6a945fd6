//! @page ch04_gas Chapter 4: The gas of hard spheres
//! @brief Spheres without forces, followed exactly from impact to impact, against the kinetic theory of gases.
//! @tableofcontents
//!
//! @section ch04_gas_question A cloud without end
//!
//! Case (1) has no near field. Let such a cloud fill a box that repeats itself without end, and it is a *gas*, of which
//! kinetic theory foretells how often its spheres meet, how hard, and what they lose by it. The monograph goes no further
//! than the energy in time; here is what that must be.
//!
//! @figure{ch04_clusters, A slice through a gas that has cooled\, two diameters thick: spheres in their true size. Colour: velocity along the horizontal axis\, over that of the thermal motion.}
//!
//! There is nothing to integrate in such a gas. particulate::contact::HardSpheres flies each sphere straight to its next
//! impact, the root of a quadratic equation, and knows neither step nor tolerance. When it takes over from located
//! contacts is said @ref ch03_located "where these are introduced".
//!
//! @section ch04_gas_theory What theory says
//!
//! Take spheres of the mass \f$ m \f$ and the diameter \f$ s \f$, \f$ n \f$ of them in a unit of volume, which fill the
//! fraction \f$ \phi \f$ of it, and as their temperature \f$ T = \tfrac13 m \langle \delta v^2 \rangle \f$, an energy.
//! Enskog's theory gives the rate of impacts of each, and from that the energy lost,
//!
//! \f[ \nu = 4\sqrt{\pi}\, n s^2 \chi \sqrt{T/m}, \qquad \chi = \frac{1 - \phi/2}{(1 - \phi)^3}, \qquad
//!     \dot T = -\frac{1 - e^2}{3}\, \nu\, T . \f]
//!
//! So a gas at rest as a whole cools by Haff's law, and in the time in which each sphere should have had \f$ c \f$ impacts
//!
//! \f[ T = \frac{T_0}{(1 + t/\tau)^2} = T_0\, e^{-2q}, \qquad \tau = \frac{6}{(1 - e^2)\, \nu_0}, \qquad
//!     t = \tau\,(e^q - 1), \qquad q = \frac{1 - e^2}{6}\, c . \f]
//!
//! Spheres that meet are faster than others: along the line of centres, with \f$ \sqrt{\pi T/m} \f$ in the mean. Each impact
//! at the normal speed \f$ u \f$ has the impulse \f$ J = \tfrac12 (1 + e)\, m u \f$ and takes
//! \f$ \tfrac14 (1 - e^2)\, m u^2 = \frac{1 - e}{1 + e} J^2/m \f$ of energy: the book of energy follows from that of impulses.
//!
//! @section ch04_gas_program The program
//!
//! Lengths are in diameters, masses in those of a sphere, energies in the temperature at the start.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/contact/hard_spheres.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/starts.hpp>
#include <particulate/report/checks.hpp>
#include <particulate/report/progress.hpp>

#include "ch04_simulations.hpp"

namespace ch04 {
namespace {

using Gas = contact::HardSpheres<>;

double impact_rate(double fraction, double T) {
  const double n = 6.0 * fraction / std::numbers::pi, chi = (1.0 - 0.5 * fraction) / std::pow(1.0 - fraction, 3);
  return 4.0 * std::sqrt(std::numbers::pi) * n * chi * std::sqrt(T);
}

double temperature(const Gas& gas, const schemes::State& state) {
  return 2.0 / 3.0 * kinematics::split_kinetic_energy(gas.particles().mass, velocities(state)).relative;
}

//! Spheres begin on a lattice, with velocities that are evenly distributed in a cube, of the temperature 1. After ten
//! impacts each, elastic ones, neither is left.

Gas gas_of(int side, double fraction, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_01<double> uniform;
  const double edge = std::cbrt(std::numbers::pi / (6.0 * fraction));
  const Eigen::Index N = Eigen::Index{side} * side * side;
  kinematics::Particles all{.position = lattice(kinematics::Lattice::simple_cubic, N, edge),
                            .velocity = kinematics::Vectors::NullaryExpr(N, 3, [&] { return uniform(engine) - 0.5; }),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.5)};
  all.velocity.rowwise() -= all.velocity.colwise().mean().eval();
  all.velocity *= std::sqrt(3.0 * static_cast<double>(N) / all.velocity.squaredNorm());
  return Gas(std::move(all), {.lengths = Eigen::Vector3d::Constant(edge * side)});
}

void fly(Gas& gas, schemes::State& state, double t_end, const contact::CollisionRecorder& recorder = {}) {
  const schemes::Outcome outcome = gas.advance(state, t_end, recorder);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
}

//! Speeds are sorted into classes, once those of the spheres, component by component, and once those of impacts.

struct Classes {
  static constexpr double width = 0.2;
  std::array<double, 30> count{};
  double all = 0.0;
  void add(double speed) {
    const auto k = static_cast<std::size_t>(std::abs(speed) / width);
    if (k < count.size()) ++count[k];
    ++all;
  }
  double density(std::size_t k) const { return count[k] / (all * width); }
};

struct Speeds {
  Classes components, approaches;  // over sqrt(T/m)
};

//! A gas is followed to times at which theory expects equal numbers of impacts, \f$ c \f$ in the end. In the sum over
//! all impacts, each counted once, theory has
//! \f$ \sum J = \tfrac14 N (1 + e) \sqrt{\pi m T_0}\; \nu_0 \tau\, (1 - e^{-q}) \f$.

struct Cooling {
  double e, contact_time;  // the latter in mean times between impacts of a sphere, at the start
  double c;
  int parts;
};

struct Cooled {
  Gas gas;
  schemes::State state;
  double impacts, impulses;  // over theory's
  double off_book;           // energy, over that of the start
};

double grown(double q) { return q == 0.0 ? 1.0 : std::expm1(q) / q; }

Cooled cool(const Gas& settled, schemes::State state, const Cooling& of, double fraction, report::Table& haff,
            Speeds& speeds) {
  const double T_0 = temperature(settled, state), nu = impact_rate(fraction, T_0);
  const double N = static_cast<double>(settled.particles().size()), q_of_c = (1.0 - of.e * of.e) / 6.0;
  Gas gas(settled.particles(), settled.domain(), {of.e}, {}, of.contact_time / nu);
  state.t = state.t_carry = 0.0;
  report::Progress progress(fmt::format("gas of {} spheres, e = {}", N, of.e), 0.5 * N * of.c);
  long impacts = 0;
  double impulses = 0.0, lost = 0.0;
  for (int k = 1; k <= of.parts; ++k) {
    const double c = of.c * k / of.parts, q = q_of_c * c;
    fly(gas, state, c / nu * grown(q), [&](const contact::Collision& one) {
      const double J = std::abs(one.impulse.normal);
      impulses += J;
      if (!one.elastic) lost += (1.0 - of.e) / (1.0 + of.e) * J * J;
      speeds.approaches.add(one.approach_speed / std::sqrt(T_0));
      if (++impacts % 1024 == 0) progress.at(static_cast<double>(impacts));
    });
    for (const double v : state.v) speeds.components.add(v / std::sqrt(T_0));
    const double T = temperature(gas, state) / T_0;
    haff.add({of.e, c, std::expm1(q), T, T * std::exp(2.0 * q)});
  }
  const double expected = 0.25 * N * (1.0 + of.e) * std::sqrt(std::numbers::pi * T_0) * of.c * grown(-q_of_c * of.c);
  const double kept = temperature(gas, state) / T_0;
  return {gas, state, 2.0 * static_cast<double>(impacts) / (N * of.c), impulses / expected,
          1.0 - kept - lost / (1.5 * N * T_0)};
}

//! In a slice that is two diameters thick each sphere can be seen.

report::Table slice(const Gas& gas, const schemes::State& state) {
  report::Table seen({"x [diameters]", "y [diameters]", "z [diameters]", "velocity x over sqrt(T/m) [-]"});
  const kinematics::Vectors r = positions(state), v = velocities(state);
  const double thermal = std::sqrt(temperature(gas, state));
  for (Eigen::Index i = 0; i < r.rows(); ++i) {
    const Eigen::Vector3d at = wrapped(gas.domain(), r.row(i).transpose());
    if (at[2] < 2.0) seen.add({at[0], at[1], at[2], v(i, 0) / thermal});
  }
  return seen;
}

}  // namespace

//! Four gases start alike: one stays elastic, three cool. A fifth, larger and less elastic, is for the picture, after
//! three elastic impacts each. Where it is dense its impacts come so fast after each other that three spheres may meet
//! without end; a contact time, of a ten-thousandth of the time between two impacts at the start, forbids that.

void gas(const Parameters& p, report::Chapter& chapter, report::Checks& checks) {
  report::Table haff({"restitution [-]", "c [-]", "t / tau [-]", "T / T_0 [-]", "T over Haff's [-]"});
  report::Table books({"restitution [-]", "spheres", "c [-]", "impacts over c [-]", "impulses over theory [-]",
                       "energy off the book of impulses [-]"});
  double off_book = 0.0;
  const auto follow = [&](int side, double settling, const Cooling& of, Speeds& speeds) {
    Gas gas = gas_of(side, p.gas_fraction, chapter.common().seed);
    schemes::State state = start(gas);
    fly(gas, state, settling / impact_rate(p.gas_fraction, 1.0));
    Cooled end = cool(gas, state, of, p.gas_fraction, haff, speeds);
    books.add({of.e, gas.particles().size(), of.c, end.impacts, end.impulses, end.off_book});
    off_book += std::abs(end.off_book);
    return end;
  };
  Speeds elastic, unused;
  const Cooled kept = follow(p.gas_side, 10.0, {.e = 1.0, .contact_time = 0.0, .c = 20.0, .parts = 20}, elastic);
  for (const double e : {0.95, 0.9, 0.8}) {
    follow(p.gas_side, 10.0, {.e = e, .contact_time = 0.0, .c = 40.0, .parts = 20}, unused);
  }
  const Cooled seen =
      follow(p.picture_side, 3.0, {.e = p.picture_e, .contact_time = 1e-4, .c = p.picture_impacts, .parts = 5}, unused);

  report::Table speeds({"speed over sqrt(T/m) [-]", "components [-]", "impacts [-]"});
  for (std::size_t k = 0; k < elastic.components.count.size(); ++k) {
    speeds.add({(static_cast<double>(k) + 0.5) * Classes::width, elastic.components.density(k),
                elastic.approaches.density(k)});
  }
  chapter.output().write("clusters", slice(seen.gas, seen.state));
  chapter.output().write("haff", haff);
  chapter.output().write("books", books);
  chapter.output().write("speeds", speeds);
  const double scatter = 4.0 / std::sqrt(elastic.approaches.all);
  checks.add("gases: energy that their impulses take, off what they lose, over all", off_book, 1e-11);
  checks.add("elastic gas: impacts over Enskog's, less one", kept.impacts - 1.0, 0.01 + scatter);
  checks.add("elastic gas: mean normal speed of impacts over sqrt(pi T/m), less one",
             kept.impulses / kept.impacts - 1.0, 0.01 + 0.53 * scatter);
}

}  // namespace ch04

//! @section ch04_gas_elastic An elastic gas
//!
//! @figure{ch04_speeds, Speeds in an elastic gas\, in units of the thermal one: components of velocities\, and normal speeds at impact. Lines: theory.}
//!
//! The gas has forgotten that its velocities were evenly distributed: they follow Maxwell's law, and so do the speeds at
//! impact, which weigh each pair by the speed at which it closes.
//!
//! @section ch04_gas_cooling Gases that cool
//!
//! @figure{ch04_haff, Above: temperature in time\, and Haff's law (grey). Below: the same over Haff's law\, against the impacts of a sphere that theory expects.}
//!
//! @table{ch04_books}
//!
//! Haff's law holds while each sphere meets strangers. But a pair that has lost its normal velocity moves on together, and
//! so, after some impacts, do neighbourhoods: the figure at the top of the page shows currents in which spheres fly
//! alike. They hardly meet each other and lose less; what is left of the temperature is the motion of the currents. That
//! is why the less elastic gases leave the law first, and always upwards, whatever the number of spheres. Where currents
//! drive spheres together, clusters begin. The size of all of that is verified in @ref verify_ch04_gas_cooling and
//! @ref verify_ch04_gas_elastic; that the impacts are those of located contacts, one by one, in
//! @ref verify_ch04_gas_like_located_contacts.
//!
//! In the table theory's number of impacts is exact for the elastic gas, up to chance. In the others it is met as long
//! as the temperature is. The last column is no theory but the book of impacts: it closes to rounding, however far the
//! gas has left the law.
//!
//! @section ch04_gas_cost What exactness costs
//!
//! @table{ch04_gas_run_time}
//!
//! Clouds of case (1), followed in three ways; the error is that of the relative energy in the mean over the time
//! (@ref verify_ch04_work_precision_gas). Located contacts and the gas share their impacts to the last bits, at any
//! tolerance, as a scheme flies straight without error. But a scene looks for the next contact of all pairs in each step,
//! the gas for that of one pair after each impact: so the exact answer is also the cheapest one.
//!
//! @section ch04_gas_exercises Exercises
//!
//! 1. Derive Haff's law from the rate of impacts and the loss in each.
//! 2. Take `--picture_e 0.8`. How many impacts does it take until there are currents, and how does that number depend on
//!    \f$ e \f$?
//! 3. Take `--gas_fraction 0.01`. Which of the numbers in the table do not change, and why?
