//! @page ch03_family Chapter 3, continued: The same idea at high order
//! @brief Collocation: more stages, the same sweeps, steps chosen by both errors, contacts where they happen.
//! @tableofcontents
//!
//! @section ch03_family_question What the monograph's scheme is the first member of
//!
//! The sweeps of @ref ch03_schemes "the first half" pay for one digit with ten times the steps, because the equation
//! that they solve is backward Euler's. Nothing in the sweeps asks for that equation. *Collocation* looks for the
//! polynomial whose rates are right at s moments of the step, its nodes,
//!
//! \f{equation}{ k_i = f\Big(t + c_i\,\Delta t,\ y^L + \Delta t \sum_{j=1}^s A_{ij}\,k_j\Big), \qquad
//!     y^{L+1} = y^L + \Delta t \sum_{j=1}^s b_j\,k_j, \tag{D 3.4} \label{eq:collocation} \f}
//!
//! @cite hairer1993. A sweep puts the last rates into the right-hand sides, as before. With one node at the end of the
//! step this *is* backward Euler. With s Gauss nodes the order is 2 s, with s Radau nodes, of which the last is the end,
//! 2 s - 1. What becomes of the sweeps, of the control by \f$ \Phi_K \f$, of stiffness, of contacts and of energy? This
//! half of the program asks in turn; it is run with the first.
//!
//! @section ch03_family_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <Eigen/Core>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/crossing.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch03_family.hpp"
#include "logged.hpp"

using namespace particulate;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

//! Most of it follows two bodies of mass one that fall together and part again. All that moves is their separation,
//! whose exact motion is known (@ref ch01_breathing "chapter 1"), and so is its energy:

struct Separation {
  kinematics::RadialForce force;
  bool acceleration(double, schemes::In r, schemes::Out a) const {
    a[0] = (force.B / r[0] - force.A) / (r[0] * r[0]);
    return r[0] > 0.0;
  }
  double energy(const schemes::State& at) const {
    return 0.5 * at.v[0] * at.v[0] - (force.A - 0.5 * force.B / at.r[0]) / at.r[0];
  }
};

struct Pair {
  Separation problem;
  kinematics::Breathing exact{problem.force, 1.0};
  explicit Pair(double repulsion) : problem{kinematics::breathing_pair(1.0, repulsion, 1.0, 1.0)} {}
  static schemes::State start() { return {.t = 0.0, .r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)}; }
};

//! The stiff problem of this half, van der Pol's oscillator, is slow but for two leaps a period:

struct VanDerPol {
  double mu;
  bool rate(double, schemes::In y, schemes::Out dy) const {
    dy << y[1], mu * (1.0 - y[0] * y[0]) * y[1] - y[0];
    return true;
  }
  void jacobian(double, schemes::In y, Eigen::MatrixXd& J) const {
    J << 0.0, 1.0, -2.0 * mu * y[0] * y[1] - 1.0, mu * (1.0 - y[0] * y[0]);
  }
};

double larger(double worst, double x) { return x <= worst || std::isnan(worst) ? worst : x; }

// Largest error of the separation at any step of a run, NaN if it does not reach its end.
template <class Scheme, class Control>
std::pair<schemes::Outcome, double> follow(const Pair& pair, Scheme scheme, Control&& control, double t_end) {
  schemes::State state = Pair::start();
  double worst = 0.0;
  const schemes::Outcome outcome = schemes::integrate(
      pair.problem, state, t_end, scheme, control, [&](const auto&, const auto& to, double, const auto&) {
        worst = larger(worst, std::abs(to.r[0] - pair.exact.at(to.t).r));
        return true;
      });
  return {outcome, outcome.status == schemes::Status::reached ? worst : no_number};
}

// Changes made by the sweeps of one step, each over the displacement of the first.
template <class Scheme>
std::vector<double> changes(const Scheme& scheme, const schemes::Problem& problem, const schemes::State& from,
                            double dt, int count) {
  std::vector<double> w;
  for (const schemes::Iteration& it : schemes::sweep_by_hand(scheme, problem, from, dt, count).iterations) {
    w.push_back(it.w_K);
  }
  return w;
}

// By which factor a sweep changes the changes, above rounding: from the largest of the second third of them to that of
// the last, since complex eigenvalues make single ones swing, even to zero.
double contraction_of(const std::vector<double>& w) {
  const auto last = std::find_if(w.rbegin(), w.rend(), [](double x) { return x > 1e-11; });
  const std::ptrdiff_t m = std::max<std::ptrdiff_t>(1, (w.rend() - last) / 3);
  const auto largest = [&](std::ptrdiff_t from) { return *std::max_element(w.begin() + from, w.begin() + from + m); };
  return std::pow(largest(2 * m - 1) / largest(m - 1), 1.0 / static_cast<double>(m));
}

}  // namespace

void ch03::describe(report::CommandLine& line, Family& p) {
  const std::string ours = "our choice";
  line.field(p.mildness, {"mildness", "repulsion of the pair whose errors are looked at, attraction 1", "N m^3/kg^2",
                          report::between(0.6, 0.95), ours});
  line.field(p.closeness, {"closeness", "repulsion of the pair that passes close by, attraction 1", "N m^3/kg^2",
                           report::between(1e-3, 0.5), ours});
  line.field(p.accuracy,
             {"accuracy", "of its steps, for truncation and sweeps", "-", report::between(1e-12, 1e-4), ours});
  line.field(p.mu, {"mu", "damping of van der Pol's oscillator", "-", report::between(1.0, 1e5), "its test set"});
  line.field(p.drop, {"drop", "height that a ball falls", "m", report::between(0.01, 100.0), ours});
  line.field(p.e, {"restitution", "of the ball", "-", report::between(0.1, 0.9), "chapter 4"});
  line.field(p.periods, {"periods", "over which energy is watched", "-", report::between(20, 10000), ours});
}

report::Checks ch03::run(const Family& p, const report::Output& output, bool quick) {
  report::Checks checks;

  //! @section ch03_orders 7. The family, and its orders
  //!
  //! First the claim that the monograph's scheme is a member. One Radau node, all rates from the sweep before, free
  //! flight for a guess: iterate for iterate that must be backward Euler.

  const Pair mild(p.mildness);
  const double period = mild.exact.period();
  const double off_member = [&] {
    schemes::BackwardEuler euler;
    schemes::Collocation<schemes::Radau<1>, schemes::Picard> radau(
        {.guess = schemes::Guess::free_flight, .compensated = false});
    const schemes::State from = Pair::start();
    schemes::State by_euler, by_radau;
    double off = 0.0;
    euler.predict(mild.problem, from, 0.05 * period, by_euler);
    radau.predict(mild.problem, from, 0.05 * period, by_radau);
    for (int K = 0; K < 10; ++K) {
      off = larger(off, std::abs(by_radau.r[0] - by_euler.r[0]) + std::abs(by_radau.v[0] - by_euler.v[0]));
      euler.sweep(mild.problem, from, 0.05 * period, by_euler);
      radau.sweep(mild.problem, from, 0.05 * period, by_radau);
    }
    return off;
  }();
  checks.add("iterates of the one-stage Radau method are those of backward Euler [m], [m/s]", off_member,
             4.0 * epsilon);

  //! Then all members through one period of the mild pair, swept to rounding at fixed steps:

  report::Table orders({"steps per period", "Gauss 1", "Gauss 2", "Gauss 3", "Gauss 4", "Gauss 5", "Gauss 6", "Gauss 7",
                        "Gauss 8", "Radau 1", "Radau 2", "Radau 3"});
  report::Table slopes({"method", "order by theory", "order seen"});
  std::array<std::vector<double>, 11> errors;
  std::vector<double> counts;
  for (int n = 5; n <= 2600; n = std::max(n + 1, n * 5 / 4)) counts.push_back(n);
  const auto measure = [&](auto scheme, std::size_t k) {
    for (const double n : counts) {
      errors[k].push_back(follow(mild, scheme, schemes::FixedStep{.step = period / n}, period).second);
    }
  };
  [&]<int... S>(std::integer_sequence<int, S...>) { (measure(schemes::Collocation<schemes::Gauss<S + 1>>(), S), ...); }
  (std::make_integer_sequence<int, 8>());
  measure(schemes::Collocation<schemes::Radau<1>>(), 8);
  measure(schemes::Collocation<schemes::Radau<2>>(), 9);
  measure(schemes::Collocation<schemes::Radau<3>>(), 10);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    std::vector<report::Cell> row{counts[i]};
    for (const std::vector<double>& of : errors)
      row.emplace_back(std::isnan(of[i]) ? report::Cell() : report::Cell(of[i]));
    orders.add(std::move(row));
  }
  output.write("family_orders", orders);
  double off_order = 0.0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const int s = static_cast<int>(k < 8 ? k + 1 : k - 7), theory = k < 8 ? 2 * s : 2 * s - 1;
    if (s > 4) continue;
    // At the finest steps whose error rounding leaves alone.
    std::size_t fine = counts.size() - 1;
    while (fine > 3 && !(errors[k][fine] > 1e-12)) --fine;
    const double seen = std::log(errors[k][fine - 3] / errors[k][fine]) / std::log(counts[fine] / counts[fine - 3]);
    slopes.add({fmt::format("{} {}", k < 8 ? "Gauss" : "Radau", s), theory, seen});
    off_order = larger(off_order, std::abs(seen / theory - 1.0));
  }
  output.write("family_slopes", slopes);
  checks.add("orders seen, relative to theory", off_order, 0.1);

  //! @figure{ch03_family_orders, Largest error of the mild pair's separation through one period\, for Gauss methods of one to eight stages and the Radau methods (dashed). The topmost curve is the monograph's scheme.}
  //!
  //! @table{ch03_family_slopes}
  //!
  //! A digit costs backward Euler ten times the steps, and eight Gauss stages \f$ 10^{1/16} \f$ times, a step more in
  //! seven. A curve begins where its sweeps begin to contract. With more than four stages rounding is met before the
  //! slope is straight: their orders are claimed on a longer way (@ref verify_ch03_order_collocation_values
  //! "order_collocation_values").
  //!
  //! @section ch03_guess 8. Better sweeps from a better guess
  //!
  //! A step of s stages costs s forces a sweep, so sweeps had better be few. Two things help. A sweep may use each new
  //! rate for the stages that follow it, in turn (*sequential*), rather than renew all stages at once from the last
  //! sweep (*simultaneous*; the method of Everhart @cite everhart1985 is of the first kind). And the polynomial of the
  //! step before, run on, is a better guess than free flight. One step of four Gauss stages, after some others:

  const double step = period / 8.0;
  const auto after_some = [&](auto scheme) {
    schemes::State state = Pair::start();
    schemes::FixedStep control{.step = step};
    const schemes::Outcome outcome = schemes::integrate(mild.problem, state, 4.0 * step, scheme, control);
    return outcome.status == schemes::Status::reached ? changes(scheme, mild.problem, state, step, 16)
                                                      : std::vector<double>(16, no_number);
  };
  const schemes::CollocationSettings flies{.guess = schemes::Guess::free_flight};
  using Four = schemes::Gauss<4>;
  const std::array<std::vector<double>, 4> settling{
      after_some(schemes::Collocation<Four, schemes::Picard>(flies)), after_some(schemes::Collocation<Four>(flies)),
      after_some(schemes::Collocation<Four, schemes::Picard>()), after_some(schemes::Collocation<Four>())};
  report::Table guesses({"sweep", "simultaneous, free flight", "sequential, free flight", "simultaneous, extrapolated",
                         "sequential, extrapolated"});
  for (std::size_t K = 0; K < settling[0].size(); ++K) {
    guesses.add({K + 1, settling[0][K], settling[1][K], settling[2][K], settling[3][K]});
  }
  output.write("family_guesses", guesses);
  const auto needed = [](const std::vector<double>& w) {
    return std::find_if(w.begin(), w.end(), [](double x) { return x <= 1e-12; }) - w.begin();
  };
  const auto others = std::min({needed(settling[0]), needed(settling[1]), needed(settling[2])});
  checks.add("sweeps in turn from an extrapolated guess are the fewest: how many more than another way they are",
             std::max(0.0, static_cast<double>(needed(settling[3]) - others)), 0.0);

  //! @figure{ch03_family_guesses, Change made by each sweep of a four-stage step\, from two guesses.}
  //!
  //! The guess sets where a curve begins, the kind of sweep its slope. How far sweeps reach at all is a region in the
  //! plane of \f$ z = \lambda\,\Delta t \f$ again. Simultaneous sweeps multiply the rates by \f$ z A \f$; in sequence,
  //! with L the part of A below its diagonal, by \f$ (I - z L)^{-1} z (A - L) \f$:

  const auto plane = [](std::complex<double> z) {
    return schemes::FirstOrderPair{.a = Eigen::Matrix2d{{-z.real(), z.imag()}, {-z.imag(), -z.real()}}};
  };
  const schemes::State one{.t = 0.0, .y = Eigen::Vector2d(1.0, 0.0)};
  // The limit of |M^n|^(1/n), by squaring: after 40 of them what the norm is does not matter.
  const auto spectral_radius = [](Eigen::MatrixXcd M) {
    double logarithm = 0.0, share = 1.0;
    for (int k = 0; k < 40; ++k, share /= 2.0) {
      const double size = M.cwiseAbs().maxCoeff();
      if (!(size > 0.0)) return size;
      logarithm += share * std::log(size);
      M /= size;
      M = M.lazyProduct(M).eval();
    }
    return std::exp(logarithm);
  };
  report::Table regions({"Re z", "Im z", "s = 1", "simultaneous, s = 2", "simultaneous, s = 4", "simultaneous, s = 8",
                         "sequential, s = 2", "sequential, s = 4", "sequential, s = 8"});
  long wrong = 0;
  const auto contraction = [&]<class Nodes, class Solver>(std::complex<double> z, Nodes, Solver) {
    const Eigen::MatrixXcd A = schemes::table_of<Nodes>().A.template cast<std::complex<double>>();
    Eigen::MatrixXcd L = Eigen::MatrixXcd::Zero(A.rows(), A.cols());
    if constexpr (std::is_same_v<Solver, schemes::Sequential>) L = A.template triangularView<Eigen::StrictlyLower>();
    Eigen::MatrixXcd next = z * (A - L);  // the inverse is applied row by row
    for (Eigen::Index i = 1; i < A.rows(); ++i) {
      for (Eigen::Index j = 0; j < i; ++j) next.row(i) += z * L(i, j) * next.row(j);
    }
    const double theory = spectral_radius(next);
    const schemes::Collocation<Nodes, Solver> scheme({.guess = schemes::Guess::free_flight});
    const schemes::FirstOrderPair problem = plane(z);
    const double seen = contraction_of(changes(scheme, problem, one, 1.0, 80));
    if (std::abs(theory - 1.0) > 0.1) wrong += !((seen < 1.0) == (theory < 1.0));
    return seen;
  };
  const double spacing = quick ? 0.5 : 0.25;
  for (double x = -13.0; x <= 6.0; x += spacing) {
    for (double y = 0.0; y <= 14.0; y += spacing) {
      const std::complex<double> z(x, y + 1e-3);
      const schemes::Picard picard;
      const schemes::Sequential turn;
      regions.add({x, y, contraction(z, schemes::Gauss<1>{}, turn), contraction(z, schemes::Gauss<2>{}, picard),
                   contraction(z, Four{}, picard), contraction(z, schemes::Gauss<8>{}, picard),
                   contraction(z, schemes::Gauss<2>{}, turn), contraction(z, Four{}, turn),
                   contraction(z, schemes::Gauss<8>{}, turn)});
    }
  }
  output.write("family_regions", regions);
  checks.add("sweeps contract inside the regions of theory and diverge outside: points where not",
             static_cast<double>(wrong), 0.0);

  //! @figure{ch03_family_regions, Upper half of the plane of z: sweeps contract inside the curves. Left all stages at once\, right in turn.}
  //!
  //! The regions grow with s: high order is not bought with shorter steps. In turn, sweeps contract faster as long as
  //! steps are short, and cease to contract sooner, above all on the left. No region holds the far left of the plane:
  //! stiff problems are beyond sweeps, however good the guess.
  //!
  //! @section ch03_stiff 9. Stiffness: Newton in place of sweeps
  //!
  //! The *equation* of a step is another matter, as in section 1. The factor of a step on \f$ \dot y = \lambda y \f$ is
  //! a rational function R(z). We solve by Newton's method, which particulate::schemes::Newton does at the cost of one
  //! decomposition for a step size, and measure it on both axes:

  const auto factor = [&](auto scheme, std::complex<double> z) {
    schemes::FirstOrderPair problem = plane(z);
    schemes::State y = one;
    schemes::FixedStep control{.step = 1.0};
    const bool reached = schemes::integrate(problem, y, 1.0, scheme, control).status == schemes::Status::reached;
    return reached ? y.y.norm() : no_number;
  };
  using Stiff = schemes::Newton<>;
  report::Table stability({"|z|", "Gauss 2, Re z < 0", "Radau 1, Re z < 0", "Radau 2, Re z < 0", "Gauss 2, Re z = 0",
                           "Radau 1, Re z = 0", "Radau 2, Re z = 0"});
  double off_stability = 0.0;
  for (int k = -4; k <= 12; ++k) {
    const double x = std::pow(10.0, 0.25 * k);
    std::vector<report::Cell> row{x};
    for (const std::complex<double> z : {std::complex(-x, 0.0), std::complex(0.0, x)}) {
      const std::array<double, 3> seen{factor(schemes::Collocation<schemes::Gauss<2>, Stiff>(), z),
                                       factor(schemes::Collocation<schemes::Radau<1>, Stiff>(), z),
                                       factor(schemes::Collocation<schemes::Radau<2>, Stiff>(), z)};
      const std::array<double, 3> theory{std::abs((1.0 + z / 2.0 + z * z / 12.0) / (1.0 - z / 2.0 + z * z / 12.0)),
                                         std::abs(1.0 / (1.0 - z)),
                                         std::abs((1.0 + z / 3.0) / (1.0 - 2.0 * z / 3.0 + z * z / 6.0))};
      for (std::size_t i = 0; i < 3; ++i) {
        row.emplace_back(seen[i]);
        off_stability = larger(off_stability, std::abs(seen[i] - theory[i]));
      }
    }
    stability.add(std::move(row));
  }
  output.write("family_stability", stability);
  checks.add("factor of a step on both axes, against R(z)", off_stability, 1e-12);

  //! @figure{ch03_family_stability, Size of the factor of one step. Left: decay\, right: oscillation.}
  //!
  //! Gauss keeps the size of what oscillates, exactly, and of what decays fast it keeps nearly all. Radau damps both,
  //! the faster the more. So Gauss is for motion that conserves energy, Radau for what is to die out. Van der Pol's
  //! oscillator \f$ \ddot y = \mu (1 - y^2)\,\dot y - y \f$ from its test set @cite mazzia2008 needs the latter: five
  //! Radau stages, of order nine, steered as in the next section.

  VanDerPol oscillator{p.mu};
  schemes::State leaping{.t = 0.0, .y = Eigen::Vector2d(2.0, 0.0)};
  schemes::Collocation<schemes::Radau<5>, Stiff> radau({.sizes = Eigen::Vector2d(1.0, 1e-3)});
  schemes::ErrorControl patient{
      .TOL = 1e-6, .sweep_TOL = 1e-8, .K_d = 3, .step = 1e-3, .limit = 2.0 * p.mu, .growth = 8.0};
  report::Table leaps({"t [s]", "y [-]", "step [s]", "step x fastest rate [-]"});
  double stiffest = 0.0;
  const schemes::Outcome leapt = schemes::integrate(oscillator, leaping, 2.0 * p.mu, radau, patient,
                                                    [&](const auto&, const auto& to, double dt, const auto&) {
                                                      const double fastest = std::abs(p.mu * (1.0 - to.y[0] * to.y[0]));
                                                      stiffest = larger(stiffest, dt * fastest);
                                                      leaps.add({to.t, to.y[0], dt, dt * fastest});
                                                      return true;
                                                    });
  output.write("family_leaps", leaps);
  report::Table stiff({"steps", "refused", "right-hand sides", "longest step x rate [-]", "y(2 mu) [-]"});
  stiff.add({leapt.steps, leapt.rejections, leapt.evaluations, stiffest, leaping.y[0]});
  output.write("family_stiff", stiff);
  if (p.mu == 1000.0) {
    checks.add("van der Pol at t = 2000, against the published digits", leaping.y[0] - 1.706167732170483, 1e-8);
  }

  //! @figure{ch03_family_leaps, Van der Pol's oscillator and the steps that follow it.}
  //!
  //! @table{ch03_family_stiff}
  //!
  //! An explicit scheme, or a sweep, would need a step times rate of about one at all times. Newton leaves the step to
  //! accuracy alone: it spans decades, from the leaps to the slow way between them.
  //!
  //! @section ch03_both 10. Two errors, one step
  //!
  //! Section 5 showed what \f$ \Phi_K \f$ cannot see. A polynomial through s rates can: if its leading coefficient is
  //! small beside the rates the step resolves them. From their ratio follows an estimate of what the step leaves, with
  //! no further force (particulate::schemes::Collocation). The control then takes the smaller of two wishes,
  //!
  //! \f[ \Delta t^{new} = \min\left\{\Phi_K,\ 0.9 \left(\frac{TOL}{\text{estimate}}\right)^{1/(p+1)}\right\}
  //!     \Delta t. \f]
  //!
  //! A pair with much less repulsion than before falls much closer. Four Gauss stages follow it through its passage:

  const Pair close(p.closeness);
  const double orbit = close.exact.period();
  ch03::Logged<schemes::ErrorControl> log{
      .control = {.TOL = p.accuracy, .sweep_TOL = p.accuracy, .step = 0.01 * orbit, .limit = 0.1 * orbit}};
  const auto [passed, error_of_passage] = follow(close, schemes::Collocation<Four>(), log, orbit);
  report::Table passage({"time from the passage [periods]", "accepted step [periods]", "refused step [periods]",
                         "estimate/TOL [-]", "Phi_K [-]", "wish of the estimate [-]"});
  double above = 0.0, shortest = orbit, longest = 0.0;
  for (const auto& entry : log.entries) {
    const double dt = entry.made.dt / orbit, estimate = entry.made.truncation.error / p.accuracy;
    const double Phi_K = schemes::phi_K(entry.made.iteration, p.accuracy, log.control.K_d);
    passage.add({entry.t / orbit - 0.5, entry.accepted ? report::Cell(dt) : report::Cell(),
                 entry.accepted ? report::Cell() : report::Cell(dt), estimate,
                 std::isfinite(Phi_K) ? report::Cell(Phi_K) : report::Cell(), 0.9 * std::pow(estimate, -1.0 / 9.0)});
    if (!entry.accepted) continue;
    above = larger(above, estimate - 1.0);
    if (entry.t + entry.made.dt >= orbit) continue;  // cut short to land on the end
    shortest = std::min(shortest, dt);
    longest = std::max(longest, dt);
  }
  output.write("family_passage", passage);
  report::Table counted({"steps", "refused", "sweeps", "forces", "longest/shortest step", "largest error [m]"});
  counted.add(
      {passed.steps, passed.rejections, passed.sweeps, passed.evaluations, longest / shortest, error_of_passage});
  output.write("family_counted", counted);
  checks.add("estimates of steps that stand meet TOL: estimate/TOL - 1 at most", above, 0.0);
  checks.add("error of a close passage at TOL [m]", error_of_passage, 100.0 * p.accuracy);

  //! @figure{ch03_family_passage, A close passage: steps (refused ones as crosses)\, the estimate they were judged by\, and by which factor either error would change them. The smaller factor rules.}
  //!
  //! @table{ch03_family_counted}
  //!
  //! The step follows the curvature of the path down to the passage and up again, mirrored, and nobody has named a
  //! \f$ \Delta t_{lim} \f$ that had to be right. Refusals come where repulsion takes over from attraction and the
  //! leading coefficient passes zero: for a step or two the estimate is small, the next step is tried too long. The
  //! sweeps would bear longer steps nearly everywhere, and short ones need few of them. The estimate is the upper one of
  //! two that the polynomial allows, so the error attained lies below TOL: how the two go together is measured for every
  //! method (@ref verify_ch03_tolerance_proportionality "tolerance_proportionality").
  //!
  //! @section ch03_located 11. Contacts where they happen
  //!
  //! Between its ends a step is a polynomial, so the moment at which something happens can be read off it. That reading
  //! is of lower order than the end of the step. But the step can be shortened to the moment, solved again, and read
  //! again until it stands: then the moment has the order of the method (particulate::schemes::Watch). We ask when the
  //! mild pair is half-way to its closest, in three ways:

  const double level = 0.5 * (1.0 + mild.exact.nearest());
  const double moment = [&] {
    const auto over = [&](double t) { return mild.exact.at(t).r - level; };
    return schemes::bracketed_root(over, 0.0, over(0.0), 0.5 * period, over(0.5 * period));
  }();
  report::Table events({"steps per period", "end of the step [s]", "read off [s]", "located [s]"});
  std::vector<std::array<double, 3>> off_moment;
  for (int n = 16; n <= 200; n = n * 5 / 4) {
    std::array<double, 3> off{no_number, no_number, no_number};
    schemes::State state = Pair::start(), there;
    schemes::Collocation<Four> scheme;
    schemes::FixedStep control{.step = period / n};
    const auto read = [&](const auto& from, const auto& to, double dt, const auto& made) {
      if (to.r[0] >= level) return true;
      const auto over = [&](double theta) {
        made.at(from, dt, theta, there);
        return there.r[0] - level;
      };
      off[0] = std::abs(to.t - moment);
      off[1] = std::abs(from.t + dt * schemes::bracketed_root(over, 0.0, over(0.0), 1.0, over(1.0)) - moment);
      return false;
    };
    schemes::Outcome outcome = schemes::integrate(mild.problem, state, period, scheme, control, read);
    state = Pair::start();
    scheme.forget();
    schemes::Watch watch({.functions = [&](const schemes::State& at, schemes::Out g) { g[0] = at.r[0] - level; },
                          .directions = {schemes::Direction::falling},
                          .names = {"near"}});
    outcome = schemes::integrate(mild.problem, state, period, scheme, control, watch);
    if (outcome.status == schemes::Status::stopped) off[2] = std::abs(state.t - moment);
    events.add({n, off[0], off[1], off[2]});
    off_moment.push_back(off);
  }
  output.write("family_events", events);
  checks.add("a located event, with eight steps to the passage and more, is off by [s]", off_moment.front()[2], 1e-6);
  checks.add("and with the finest by [s]", off_moment.back()[2], 1e-13);

  //! The same with contact. A ball falls on a floor and rises again with e times its speed, so the moments of its
  //! impacts, \f$ t_1 (1 + 2 e + 2 e^2 + \dots) \f$ with \f$ t_1 = \sqrt{2h/g} \f$, come ever closer and end at
  //! \f$ t_1 (1+e)/(1-e) \f$. A stepped contact, that of @ref ch02_stepped "chapter 2", is found at the end of a step; a
  //! particulate::contact::LocatedContact ends the step.

  const double g = 9.81, first_impact = std::sqrt(2.0 * p.drop / g);
  const kinematics::Particles ball{.position = kinematics::Vectors{{0.0, 0.0, p.drop + 0.1}},
                                   .velocity = kinematics::Vectors::Zero(1, 3),
                                   .mass = Eigen::VectorXd::Ones(1),
                                   .radius = Eigen::VectorXd::Constant(1, 0.1)};
  const kinematics::Space floor{{kinematics::Wall{}}};
  const laws::Gravity gravity{.g = {0.0, 0.0, -g}};
  const scenes::Scene stepped(ball, floor, gravity, contact::Contact<>{.restitution = {p.e}});
  const scenes::Scene located(ball, floor, gravity, contact::LocatedContact<>{.restitution = {p.e}});
  struct Bounce {
    schemes::Outcome outcome;
    double off;  // of the first three impacts, the largest [s]
  };
  const auto bounce = [&](const auto& scene, auto scheme, double dt, double t_end) {
    schemes::State state = scenes::start(scene);
    schemes::FixedStep control{.step = dt};
    int impacts = 0;
    double off = 0.0, due = first_impact;
    const schemes::Outcome outcome =
        schemes::integrate(scene, state, t_end, scheme, control, [&](const auto&, const auto& to, double, const auto&) {
          if (impacts == 3 || !(to.r[2] - 0.1 <= 1e-11 && to.v[2] < 0.0)) return true;
          off = larger(off, std::abs(to.t - due));
          due += 2.0 * std::pow(p.e, ++impacts) * first_impact;
          return true;
        });
    return Bounce{outcome, impacts == 3 ? off : no_number};
  };
  const double third = first_impact * (1.0 + 2.0 * p.e + 2.0 * p.e * p.e);
  report::Table bounces({"step [s]", "stepped [s]", "located [s]"});
  double off_located = 0.0, off_stepped = 0.0;
  for (int k = 0; k < 24; ++k) {
    const double dt = 0.0973 * std::pow(10.0, -0.125 * k) * first_impact;
    const double late = bounce(stepped, schemes::VelocityVerlet{}, dt, third + 3.0 * dt).off;
    const double off = bounce(located, schemes::Collocation<schemes::Gauss<2>>(), dt, third + 0.5 * dt).off;
    bounces.add({dt, late, off});
    off_located = larger(off_located, off);
    off_stepped = larger(off_stepped, late / dt);
  }
  output.write("family_bounces", bounces);
  checks.add("moments of located impacts, whatever the step [s]", off_located, 1e-11);
  checks.add("those of stepped ones, over the step, are off by a few at most", off_stepped, 5.0);
  const schemes::Outcome rest =
      bounce(located, schemes::Collocation<schemes::Gauss<2>>(), 0.1 * first_impact, 1e3 * first_impact).outcome;
  report::Table resting({"what the run says"});
  resting.add({rest.reason});
  output.write("family_resting", resting);
  checks.add("a ball that comes to rest ends a located run: runs where not",
             rest.failure == schemes::Failure::accumulating ? 0.0 : 1.0, 0.0);
  checks.add("and the run knows when [s]", rest.accumulation - first_impact * (1.0 + p.e) / (1.0 - p.e), 1e-9);

  //! @figure{ch03_family_located, Left: error of the moment at which a separation is reached. Right: largest error of a ball's first three impacts.}
  //!
  //! @table{ch03_family_resting}
  //!
  //! The end of a step is late by up to a step, whatever the method. Reading the polynomial is better by orders, and
  //! solving anew restores the order of the method, or for the ball, whose flight the method solves exactly, leaves
  //! rounding alone. Infinitely many impacts no run can follow: it says so, and when they are over.
  //!
  //! @section ch03_structure 12. What long runs keep
  //!
  //! An error of energy that grows makes a cloud boil or freeze, however small it is in a step. Gauss methods are
  //! symplectic @cite hairer2006 if their equations are solved: energy errs by a bounded amount, for ever. So does
  //! Verlet's. We follow the mild pair for many periods and write down the largest relative error of its energy in each:

  const int periods = quick ? std::min(p.periods, 100) : p.periods;
  report::Table energies({"period", "Gauss 4, to rounding", "Gauss 4, two sweeps", "Verlet", "backward Euler"});
  report::Table drifts({"method", "steps per period", "forces per period", "largest in the first period [-]",
                        "largest in the last period [-]"});
  std::vector<std::vector<double>> largest;
  const auto drift = [&](const std::string& name, auto scheme, auto control, double n) {
    schemes::State state = Pair::start();
    const double E_0 = mild.problem.energy(state);
    Separation problem = mild.problem;
    std::vector<double> of(static_cast<std::size_t>(periods), 0.0);
    const schemes::Outcome outcome = schemes::integrate(
        problem, state, periods * period, scheme, control, [&](const auto&, const auto& to, double dt, const auto&) {
          const auto k = std::min(of.size() - 1, static_cast<std::size_t>((to.t - 0.5 * dt) / period));
          of[k] = larger(of[k], std::abs(problem.energy(to) / E_0 - 1.0));
          return true;
        });
    if (outcome.status != schemes::Status::reached) of.assign(of.size(), no_number);
    drifts.add({name, n, static_cast<double>(outcome.evaluations) / periods, of.front(), of.back()});
    largest.push_back(std::move(of));
  };
  drift("Gauss 4, to rounding", schemes::Collocation<Four>(), schemes::FixedStep{.step = period / 25.0}, 25);
  drift("Gauss 4, two sweeps", schemes::Collocation<Four>(), schemes::FixedSweeps{.step = period / 50.0, .sweeps = 2},
        50);
  drift("Verlet", schemes::VelocityVerlet{}, schemes::FixedStep{.step = period / 400.0}, 400);
  drift("backward Euler", schemes::BackwardEuler{}, schemes::FixedStep{.step = period / 160.0, .TOL = 1e-6}, 160);
  for (std::size_t k = 0; k < largest[0].size(); ++k) {
    energies.add({k + 1, largest[0][k], largest[1][k], largest[2][k], largest[3][k]});
  }
  output.write("family_energies", energies);
  output.write("family_drifts", drifts);
  // The largest of a quarter of all periods: where in its orbit a step falls differs from period to period.
  const auto growth = [&](const std::vector<double>& of) {
    const auto quarter = static_cast<std::ptrdiff_t>(of.size() / 4);
    return *std::max_element(of.end() - quarter, of.end()) / *std::max_element(of.begin(), of.begin() + quarter);
  };
  checks.add("Gauss, solved to rounding: error of energy in the last quarter over that in the first, less one",
             growth(largest[0]) - 1.0, 0.05);
  checks.add("Verlet: the same", growth(largest[2]) - 1.0, 0.05);
  checks.add("Gauss cut off after two sweeps: by how much less than twofold it grows",
             std::max(0.0, 2.0 - growth(largest[1])), 0.0);

  //! @figure{ch03_family_energies, Largest relative error of the energy of the mild pair in each period\, at about equal numbers of forces.}
  //!
  //! @table{ch03_family_drifts}
  //!
  //! Backward Euler loses the motion within a few periods. Verlet and Gauss keep a level, Gauss a much lower one for
  //! the same forces. Cut off after two sweeps the same method is no longer symplectic, and its error grows in
  //! proportion to time: the cheapest way to a short, accurate run is not the one to a long one. Momentum and more
  //! bodies, over far longer times and beside CVODE, are the verification's (@ref verify_ch03_drift "drift").
  //!
  //! @section ch03_work 13. Error against run time
  //!
  //! The verification program races all of these, with velocity Verlet, Runge-Kutta and SUNDIALS, from one spring to a
  //! thousand bodies: attained error against seconds and against right-hand sides, @ref guide_ch03_work. Five things are
  //! worth looking for. The slopes: backward Euler pays one digit with ten times the steps, \f$ \phi = 1/2 \f$ and
  //! Verlet with about three times as many. The distance between these two: a sweep costs what a step of Verlet costs.
  //! Collocation: flat curves, which cross all others after a few digits; at fixed steps, cut off after two or three
  //! sweeps, where motion is smooth, steered where bodies pass close by one another. The front against CVODE and ARKODE:
  //! its ratios in each decade of the error are claims there, settings chosen on one seed and reported on others, and
  //! where a goal is missed the case says so. And stiff problems, where Newton's method meets that of CVODE.
  //!
  //! @section ch03_family_results What held
  //!
  //! Where an identity is claimed, the allowance is rounding. Orders are claimed from both sides.

  output.write("family_checks", checks.table());
  return checks;
}

//! @table{ch03_family_checks}
//!
//! @section ch03_family_exercises Exercises
//!
//! 1. Show that the equations \f$\eqref{eq:collocation}\f$ for \f$ \ddot r = a(r) \f$ become \f$ r_i = r +
//!    c_i\,\Delta t\,v + \Delta t^2 \sum_j \bar A_{ij}\,a_j \f$ with \f$ \bar A = A A \f$. Why is only one force a
//!    stage left to iterate? The assignment asks for the step of two stages.
//! 2. Compute the region of contraction of simultaneous sweeps for s = 2 by hand. By what does it shrink for
//!    \f$ \ddot r = -\omega^2 r \f$, in \f$ \omega\,\Delta t \f$?
//! 3. Lower `--closeness` by ten. How do steps, refusals and forces grow, and how would they at a fixed step?
//! 4. Take sweeps from Guess::free_flight in section 10. Which of the two errors rules now, and what does it cost?
//! 5. Give the ball of section 11 a spring to the floor. Does a stepped contact still converge, and with which order?
//! 6. Cut Gauss off after one, two, three, four sweeps in section 12. When is the growth of the error of energy lost in
//!    rounding over `--periods`?
