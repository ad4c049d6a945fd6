//! @page ch01_fundamentals Chapter 1: Fundamentals
//! @brief A force that attracts from afar and repels near by: its potential, its equilibrium, its motion, its scaling.
//! @tableofcontents
//!
//! @section ch01_question What holds two particles apart, and together
//!
//! Chapter 1 of the monograph @cite zohdi2007 asks what a particle does under a force that points to a centre, and
//! picks the force that all later chapters build on. With \f$ d = \|r - r_o\| \f$ the distance to the centre,
//!
//! \f{equation}{ \Psi = C(d)\, n, \qquad n = \frac{r_o - r}{d}, \tag{1.26} \label{eq:central} \f}
//! \f{equation}{ C(d) = \alpha_1 d^{-\beta_1} - \alpha_2 d^{-\beta_2}. \tag{1.30} \label{eq:strength} \f}
//!
//! The first power attracts, the second repels. If \f$ \beta_2 > \beta_1 \f$, repulsion wins near by and attraction far
//! away, so the two balance at one distance. Four questions follow, and this program answers them in turn: what do
//! force and potential look like, is the balance stable, how does a pair move about it, and what must two scenes of
//! different size share to move alike?
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch01_fundamentals
//! build/release/bin/ch01_fundamentals --out ch01
//! @endverbatim
//!
//! It takes less than a second. Every parameter below is an option (`--help` lists them), a run writes the
//! `parameters.toml` that repeats it, and the exit status says whether every check at the end of this page held.
//!
//! @section ch01_program The program
//!
//! It needs the laws, a scene to put them in, two schemes that move the scene, and the report.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <particulate/kinematics/breathing.hpp>
#include <particulate/kinematics/central_force.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/similarity.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace {

using namespace particulate;

//! @subsection ch01_parameters Parameters
//!
//! The constants of the first half are the monograph's fourth near-field case of chapter 4. Those of the second half
//! belong to the one pair of exponents for which the motion has a closed form.

using report::between;
constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& alpha1 =
      line.field(0.5, {"alpha1", "attraction", "N m^beta1/kg^2", between(1e-6, 1e6), "figure 4.2, case 4"});
  double& alpha2 =
      line.field(0.25, {"alpha2", "repulsion", "N m^beta2/kg^2", between(1e-6, 1e6), "figure 4.2, case 4"});
  double& beta1 = line.field(1.0, {"beta1", "exponent of attraction", "-", between(0.0, 13.0), "chapter 4"});
  double& beta2 =
      line.field(2.0, {"beta2", "exponent of repulsion, above beta1", "-", between(0.0, 13.0), "chapter 4"});
  double& displacement = line.field(0.1, {"displacement", "displacement from the balance, as a share of its distance",
                                          "-", between(1e-3, 0.3), ours});
  double& stiffness = line.field(
      0.5, {"stiffness", "repulsion of the breathing pair, attraction 1", "N m^3/kg^2", between(0.1, 0.9), ours});
  int& steps = line.field(200, {"steps", "steps a period of the breathing pair", "-", between(20, 1e4), ours});
  int& scale =
      line.field(10, {"scale", "power of two by which the large scene is longer", "-", between(-20, 20), ours});
};

void validate(const Parameters& p) {
  if (p.beta2 > p.beta1) return;
  throw std::invalid_argument(
      fmt::format("beta2 must be above beta1 for a stable balance, got {} and {}", p.beta2, p.beta1));
}

//! @subsection ch01_helpers Two bodies, and what becomes of them
//!
//! Two bodies of one kilogram on the x axis are all the matter this chapter needs. A scene is particles, a domain and a
//! pack of laws; here the only law is the near field (2.3), which is \f$\eqref{eq:strength}\f$ between every two
//! particles with the strengths multiplied by both masses.

kinematics::Particles two_bodies(double distance) {
  return kinematics::particles({{.position = {-0.5 * distance, 0.0, 0.0}, .mass = 1.0, .radius = 0.01},
                                {.position = {0.5 * distance, 0.0, 0.0}, .mass = 1.0, .radius = 0.01}});
}

//! A scheme, a step control and a state go into one loop, which comes back with an outcome. Here every run must reach
//! its end; what it did and why it did not is printed if one does not.

template <class Scene, class Scheme>
void advance(const Scene& scene, schemes::State& state, double t_end, Scheme& scheme, double step) {
  schemes::FixedStep control{.step = step};
  const schemes::Outcome outcome = schemes::integrate(scene, state, t_end, scheme, control);
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
}

//! What a run claims is kept in one table, a particulate::report::Checks, with the error that was seen and the error
//! that is allowed. Comparisons are written so that a NaN fails them.

void run(const Parameters& p, report::Chapter& chapter) {
  const report::Output& output = chapter.output();
  report::Checks& checks = chapter.claims("checks");

  //! @section ch01_curves 1. Force and potential
  //!
  //! The potential is defined by \f$ \Psi = -\nabla V \f$, so \f$ V' = C \f$. The printed formula (1.33) divides by
  //! \f$ 1 - \beta \f$ and has no limit at \f$ \beta = 1 \f$, the very exponent that chapter 4 uses. The difference to
  //! a reference distance has one; it is what particulate::kinematics::potential computes, without cancellation,
  //!
  //! \f[ V(d) - V(d_{ref}) = \alpha\, d_{ref}^{1-\beta}\,\frac{e^{(1-\beta)\ln(d/d_{ref})} - 1}{1-\beta}
  //!     \;\longrightarrow\; \alpha \ln\frac{d}{d_{ref}} \quad (\beta \to 1). \f]

  const kinematics::CentralForce law{.alpha1 = p.alpha1, .alpha2 = p.alpha2, .beta1 = p.beta1, .beta2 = p.beta2};
  const double d_e = kinematics::equilibrium_distance(law);

  report::Table curves({"distance [m]", "attraction [N]", "repulsion [N]", "strength [N]", "potential [J]"});
  for (int k = 0; k <= 300; ++k) {
    const double d = d_e * (0.4 + 0.012 * k);
    const double repulsion = p.alpha2 * kinematics::power(d, -p.beta2);
    const double strength = kinematics::strength(law, d);
    curves.add({d, strength + repulsion, -repulsion, strength, kinematics::potential(law, d, d_e)});
  }
  output.write("curves", curves);

  //! @figure{ch01_curves, Attraction and repulsion\, their sum\, and its potential measured from the balance.}
  //!
  //! The sum changes sign once, at
  //!
  //! \f[ d_e = \left(\frac{\alpha_2}{\alpha_1}\right)^{1/(\beta_2-\beta_1)}, \f]
  //!
  //! where the potential has its minimum. Its walls are unequal: pressing costs more than pulling, and with
  //! \f$ \beta_1 = 1 \f$ no pull is ever enough, because the logarithm grows without bound. Such a pair never parts.
  //!
  //! @section ch01_stability 2. Stable along the line of centres, neutral across it
  //!
  //! The second derivatives of V tell what a small displacement does. Along the line of centres the stiffness is
  //! \f$ V''(d_e) = \alpha_1 d_e^{-\beta_1-1}(\beta_2-\beta_1) \f$, positive because \f$ \beta_2 > \beta_1 \f$. Across
  //! it, it is \f$ V'(d)/d \f$, which vanishes at the balance, and only there: the monograph's neutral direction. We
  //! displace one body by u along, across, and round the other, and look at the energy.

  report::Table landscape({"displacement [m]", "along [J]", "across [J]", "round [J]"});
  const auto energy_at = [&](const Eigen::Vector3d& place) { return kinematics::potential(law, place.norm(), d_e); };
  for (int k = -60; k <= 60; ++k) {
    const double u = 0.01 * k * d_e;
    const double angle = u / d_e;
    landscape.add({u, energy_at({d_e + u, 0.0, 0.0}), energy_at({d_e, u, 0.0}),
                   energy_at({d_e * std::cos(angle), d_e * std::sin(angle), 0.0})});
  }
  output.write("landscape", landscape);

  const double u = 1e-4 * d_e;
  const double bending =
      (energy_at({d_e + u, 0, 0}) - 2.0 * energy_at({d_e, 0, 0}) + energy_at({d_e - u, 0, 0})) / (u * u);
  const double stiffness = kinematics::normal_stiffness(law, d_e);
  checks.add("stiffness along the line of centres is the curvature of V", bending / stiffness - 1.0, 1e-6);
  checks.add("stiffness across it vanishes at the balance, relative to the one along it",
             kinematics::transverse_stiffness(law, d_e) / stiffness, 1e-14);

  //! @figure{ch01_landscape, Energy of a displaced body: a parabola along the line of centres\, a flat fourth power across it\, nothing round it.}
  //!
  //! Across, the distance grows only as \f$ u^2/(2 d_e) \f$, so the energy grows as \f$ u^4 \f$: too slowly for a
  //! stiffness. Round the centre it does not grow at all. The motion shows the same. Displaced along, a pair swings
  //! back and forth with the period \f$ 2\pi\sqrt{m^*/V''(d_e)} \f$ of a small oscillation; kicked across, it leaves
  //! for good and goes round.

  const double small_period = kinematics::small_oscillation_period(law, 1.0, 1.0);
  kinematics::Particles displaced = two_bodies(d_e * (1.0 + p.displacement));
  kinematics::Particles kicked = two_bodies(d_e);
  const double kick = std::numbers::pi * p.displacement * d_e / small_period;  // each body, opposite ways
  kicked.velocity.col(1) << -kick, kick;

  const laws::NearField near_field{.alpha1 = p.alpha1, .alpha2 = p.alpha2, .beta1 = p.beta1, .beta2 = p.beta2};
  const scenes::Scene swings{displaced, kinematics::Space{}, near_field};
  const scenes::Scene leaves{kicked, kinematics::Space{}, near_field};
  report::Table paths({"time [s]", "x displaced [m]", "y displaced [m]", "x kicked [m]", "y kicked [m]"});
  schemes::State swing = scenes::start(swings), leave = scenes::start(leaves);
  schemes::RungeKutta4 first, second;
  double turned_back = 0.0, last_angle = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const double t = 0.02 * k * small_period;
    advance(swings, swing, t, first, 0.005 * small_period);
    advance(leaves, leave, t, second, 0.005 * small_period);
    const Eigen::Vector3d bound = position(swing, 1) - position(swing, 0),
                          free = position(leave, 1) - position(leave, 0);
    paths.add({t, bound.x(), bound.y(), free.x(), free.y()});
    const double angle = std::atan2(free.y(), free.x());
    turned_back = report::worse_of(turned_back, -std::remainder(angle - last_angle, 2.0 * std::numbers::pi));
    last_angle = angle;
  }
  output.write("paths", paths);
  checks.add("a displaced pair stays on its line of centres", swing.r.tail(4).lpNorm<Eigen::Infinity>(), 0.0);
  checks.add("a pair kicked across never turns back: largest step back [rad]", turned_back, 0.0);

  //! @figure{ch01_paths, One body as seen from the other: displaced along the line of centres it returns\, kicked across it goes round.}
  //!
  //! @section ch01_breathing 3. A pair that breathes, against its closed form
  //!
  //! For \f$ (\beta_1, \beta_2) = (2, 3) \f$ the separation of two bodies that start at rest is a Kepler orbit in
  //! disguise (the inverse cube acts like a centrifugal force):
  //!
  //! \f[ r = a (1 - \varepsilon\cos\xi), \qquad \sqrt{a^3/A}\,(\xi - \varepsilon\sin\xi) = t + \text{const}, \f]
  //!
  //! with \f$ A = \alpha_1(m_i + m_j) \f$ and the period \f$ 2\pi\sqrt{a^3/A} \f$. The strength of the repulsion is a
  //! stiffness knob with a known answer: the smaller it is, the nearer the bodies come, and the harder they turn. We
  //! follow three periods with the classical Runge-Kutta method and with velocity Verlet, four times as many steps for
  //! Verlet, so that both ask for the force equally often.

  const kinematics::Breathing exact(kinematics::breathing_pair(1.0, p.stiffness, 1.0, 1.0), 1.0);
  const scenes::Scene breathes{two_bodies(1.0), kinematics::Space{},
                               laws::NearField{.alpha1 = 1.0, .alpha2 = p.stiffness, .beta1 = 2.0, .beta2 = 3.0}};
  const double step = exact.period() / p.steps;
  const double turn_rate = std::sqrt(3.0 * 2.0 * p.stiffness / std::pow(exact.nearest(), 4));  // of the wall met there
  if (!(step * turn_rate < 0.5)) {
    throw std::invalid_argument(
        fmt::format("the turn must be resolved, step times its rate below 0.5, got {:.3g}; choose --steps {} or more",
                    step * turn_rate, std::ceil(2.0 * exact.period() * turn_rate)));
  }
  const auto separation = [](const schemes::State& m) { return position(m, 1).x() - position(m, 0).x(); };
  report::Table breathing({"time [periods]", "closed form [m]", "Runge-Kutta [m]", "Verlet [m]",
                           "error Runge-Kutta [m]", "error Verlet [m]"});
  schemes::State by_runge_kutta = scenes::start(breathes), by_verlet = by_runge_kutta;
  schemes::RungeKutta4 runge_kutta;
  schemes::VelocityVerlet verlet;
  double worst_runge_kutta = 0.0, worst_verlet = 0.0;
  for (int k = 0; k <= 120; ++k) {
    const double t = k * exact.period() / 40.0;
    advance(breathes, by_runge_kutta, t, runge_kutta, step);
    advance(breathes, by_verlet, t, verlet, 0.25 * step);
    const double r = exact.at(t).r;
    const double off = std::abs(separation(by_runge_kutta) - r), verlet_off = std::abs(separation(by_verlet) - r);
    breathing.add({t / exact.period(), r, separation(by_runge_kutta), separation(by_verlet), off, verlet_off});
    worst_runge_kutta = report::worse_of(worst_runge_kutta, off);
    worst_verlet = report::worse_of(worst_verlet, verlet_off);
  }
  output.write("breathing", breathing);

  //! @figure{ch01_breathing, The separation through three periods\, and the error of both schemes for equally many forces.}
  //!
  //! The error jumps at every closest approach, where the force is largest, and Runge-Kutta's order of four pays as
  //! soon as the step resolves the turn. Both errors grow from period to period because both get the period slightly
  //! wrong. Halving the step three times shows the orders:

  report::Table orders(
      {"steps a period [-]", "error Runge-Kutta [m]", "error Verlet [m]", "order Runge-Kutta [-]", "order Verlet [-]"});
  const double generic = 0.83 * exact.period();  // no multiple of a period, where symmetric methods look too good
  double last = 0.0, last_verlet = 0.0;
  for (int n = p.steps; n <= 8 * p.steps; n *= 2) {
    schemes::State a = scenes::start(breathes), b = a;
    advance(breathes, a, generic, runge_kutta, generic / n);
    advance(breathes, b, generic, verlet, generic / n);
    const double off = std::abs(separation(a) - exact.at(generic).r),
                 verlet_off = std::abs(separation(b) - exact.at(generic).r);
    const bool first_row = n == p.steps;
    orders.add({n, off, verlet_off, first_row ? report::Cell() : report::Cell(std::log2(last / off)),
                first_row ? report::Cell() : report::Cell(std::log2(last_verlet / verlet_off))});
    last = off;
    last_verlet = verlet_off;
  }
  output.write("orders", orders);

  //! @table{ch01_orders}
  //!
  //! The verification program goes further down this road: much stiffer pairs, unequal masses, rotation, polygons and
  //! solids, and error against run time beside CVODE and ARKODE (@ref verify_ch01).
  //!
  //! @section ch01_similarity 4. Two scales, one motion
  //!
  //! Written with \f$ r = L r^* \f$, \f$ t = \tau t^* \f$ and masses in units of M, the equation of motion keeps two
  //! numbers of its own, \f$ \pi_k = \alpha_k m \tau^2 L^{-\beta_k-1} \f$. A scene that is \f$ 2^{10} \f$ times as long,
  //! \f$ 2^5 \f$ times as slow and \f$ 2^{20} \f$ times as heavy moves alike if its strengths keep both, and not
  //! otherwise. Because these factors are powers of two and whole-number powers are formed by multiplication, alike
  //! means here: to the last bit.

  const kinematics::Scales scales{
      .length = std::ldexp(1.0, p.scale), .time = std::ldexp(1.0, p.scale / 2), .mass = std::ldexp(1.0, 2 * p.scale)};
  const kinematics::CentralForce small_law{.alpha1 = 1.0, .alpha2 = p.stiffness, .beta1 = 2.0, .beta2 = 3.0};
  const kinematics::CentralForce large_law = kinematics::scaled(small_law, scales);
  const kinematics::Particles large = kinematics::scaled(two_bodies(1.0), scales);
  const scenes::Scene scaled_scene{large, kinematics::Space{},
                                   laws::NearField{large_law.alpha1, large_law.alpha2, 2.0, 3.0}};
  const scenes::Scene unscaled_law{large, kinematics::Space{}, laws::NearField{1.0, p.stiffness, 2.0, 3.0}};

  report::Table similar(
      {"dimensionless time [-]", "small scene [-]", "large scene, scaled law [-]", "large scene, same law [-]"});
  schemes::State small_state = scenes::start(breathes), large_state = scenes::start(scaled_scene);
  schemes::State wrong_state = scenes::start(unscaled_law);
  schemes::VelocityVerlet for_small, for_large, for_wrong;
  double difference = 0.0;
  for (int k = 0; k <= 160; ++k) {
    const double t = k / 64.0;  // in units of tau, a power of two again
    advance(breathes, small_state, t, for_small, 1.0 / 1024.0);
    advance(scaled_scene, large_state, t * scales.time, for_large, scales.time / 1024.0);
    advance(unscaled_law, wrong_state, t * scales.time, for_wrong, scales.time / 1024.0);
    similar.add(
        {t, separation(small_state), separation(large_state) / scales.length, separation(wrong_state) / scales.length});
    difference =
        report::worse_of(difference, (large_state.r / scales.length - small_state.r).lpNorm<Eigen::Infinity>());
  }
  output.write("similarity", similar);

  const kinematics::SimilarityGroups groups_small =
      kinematics::similarity_groups({.law = small_law, .mass = 1.0, .radius = 0.01, .step = 1.0 / 1024.0}, {});
  const kinematics::SimilarityGroups groups_large = kinematics::similarity_groups(
      {.law = large_law, .mass = scales.mass, .radius = large.radius[0], .step = scales.time / 1024.0}, scales);
  report::Table groups({"group", "small scene [-]", "large scene [-]"});
  groups.add({"pi_1, attraction", groups_small.attraction, groups_large.attraction});
  groups.add({"pi_2, repulsion", groups_small.repulsion, groups_large.repulsion});
  groups.add({"radius / L", groups_small.radius, groups_large.radius});
  groups.add({"step / tau", groups_small.step, groups_large.step});
  output.write("groups", groups);
  checks.add("scenes with equal groups move alike, to the last bit", difference, 0.0);

  //! @table{ch01_groups}
  //!
  //! @figure{ch01_similarity, Equal groups\, equal motion; the large scene with the small scene's law does something else.}
  //!
  //! @section ch01_results What held
  //!
  //! A scheme of order p is allowed an error proportional to \f$ (\omega\,\Delta t)^p \f$, with \f$ \omega \f$ the rate at which the
  //! repulsion turns the pair round; a run that does not resolve the turn is refused above. Every step rounds once more,
  //! which is all that is left where steps are many. The curvature of V is a second difference, good to the square of
  //! its displacement.

  const double resolution = step * turn_rate;
  const double rounded = 3.0 * p.steps * std::numeric_limits<double>::epsilon();
  checks.add("Runge-Kutta follows the breathing pair through three periods [m]", worst_runge_kutta,
             0.25 * std::pow(resolution, 4) + rounded);
  checks.add("Verlet follows it through three periods [m]", worst_verlet,
             0.05 * std::pow(0.25 * resolution, 2) + 4.0 * rounded);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch01_fundamentals",
                              .summary = "Chapter 1: potential, equilibrium, a breathing pair, similarity.",
                              .out = "ch01",
                              .figures = "chapters/ch01_fundamentals/figures.gp"},
                             laws::name(laws::best_kernel()), run);
}

//! @table{ch01_checks}
//!
//! The parameters of the run that made this page:
//!
//! @parameters{ch01}
//!
//! @section ch01_exercises Exercises
//!
//! 1. Choose \f$ \beta_1 = 3 \f$, \f$ \beta_2 = 2 \f$ in particulate::kinematics::is_stable and explain the answer with
//!    the second derivative. Why does this program refuse to start?
//! 2. Lower `--stiffness` and watch both errors of the breathing pair. How must the number of steps grow to keep them?
//!    Look at the nearest approach, and at the time that the pair spends there.
//! 3. Give the pair a specific angular momentum and compare the radial period with particulate::kinematics::breathing_pair.
//! 4. Show that three equal bodies at the corners of a triangle breathe by the same equation with other constants, and
//!    find the constants of the cube in particulate::kinematics::breathing_body.
//! 5. Scale a scene whose exponents are not whole numbers. How many digits agree, and where do the others go?
