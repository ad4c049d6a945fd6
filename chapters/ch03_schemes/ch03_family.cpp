//! @page ch03_family Chapter 3: The same idea at high order
//! @brief Collocation: more stages, the same sweeps, a far higher order.
//! @tableofcontents
//!
//! @section ch03_family_question What the monograph's scheme is the first member of
//!
//! The sweeps of @ref ch03_control "the steered pair" pay for one digit with ten times the steps, because the equation
//! that they solve is backward Euler's. Nothing in the sweeps asks for that equation. *Collocation* looks for the
//! polynomial whose rates are right at s moments of the step, its nodes,
//!
//! \f{equation}{ k_i = f\Big(t + c_i\,\Delta t,\ y^L + \Delta t \sum_{j=1}^s A_{ij}\,k_j\Big), \qquad
//!     y^{L+1} = y^L + \Delta t \sum_{j=1}^s b_j\,k_j, \tag{D 3.4} \label{eq:collocation} \f}
//!
//! @cite hairer1993. A sweep puts the last rates into the right-hand sides, as before. With one node at the end of the
//! step this *is* backward Euler. With s Gauss nodes the order is 2 s, with s Radau nodes, of which the last is the end,
//! 2 s - 1. What becomes of the sweeps? This page shows the orders, and how far sweeps reach that use one another's rates
//! at once or in turn; @ref ch03_errors asks the same of stiffness and of the control, @ref ch03_contacts of contacts
//! and of energy.
//!
//! @section ch03_family_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "ch03_schemes.hpp"

namespace ch03 {

//! Of the sweeps of one step, the change made by each over the displacement of the first; and by which factor a sweep
//! changes the changes, above rounding.

template <class Scheme>
std::vector<double> changes(const Scheme& scheme, const schemes::Problem& problem, const schemes::State& from,
                            double dt, int count) {
  std::vector<double> w;
  for (const schemes::Iteration& it : schemes::sweep_by_hand(scheme, problem, from, dt, count).iterations) {
    w.push_back(it.w_K);
  }
  return w;
}

// From the largest of the second third of them to that of the last, since complex eigenvalues make single ones swing,
// even to zero.
double contraction_of(const std::vector<double>& w) {
  const auto last = std::find_if(w.rbegin(), w.rend(), [](double x) { return x > 1e-11; });
  const std::ptrdiff_t m = std::max<std::ptrdiff_t>(1, (w.rend() - last) / 3);
  const auto largest = [&](std::ptrdiff_t from) { return *std::max_element(w.begin() + from, w.begin() + from + m); };
  return std::pow(largest(2 * m - 1) / largest(m - 1), 1.0 / static_cast<double>(m));
}

//! @section ch03_orders 7. The family, and its orders
//!
//! First the claim that the monograph's scheme is a member. One Radau node, all rates from the sweep before, free
//! flight for a guess: iterate for iterate that must be backward Euler.

void family(const Parameters& p, const report::Output& output, bool quick, report::Checks& checks) {
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
             4.0 * std::numeric_limits<double>::epsilon());

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
    for (const std::vector<double>& of : errors) {
      row.emplace_back();
      if (!std::isnan(of[i])) row.back() = of[i];
    }
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
}

}  // namespace ch03

//! @figure{ch03_family_regions, Upper half of the plane of z: sweeps contract inside the curves. Left all stages at once\, right in turn.}
//!
//! The regions grow with s: high order is not bought with shorter steps. In turn, sweeps contract faster as long as
//! steps are short, and cease to contract sooner, above all on the left. No region holds the far left of the plane:
//! stiff problems are beyond sweeps, however good the guess.
//!
//! @section ch03_family_exercises Exercises
//!
//! 1. Show that the equations \f$\eqref{eq:collocation}\f$ for \f$ \ddot r = a(r) \f$ become \f$ r_i = r +
//!    c_i\,\Delta t\,v + \Delta t^2 \sum_j \bar A_{ij}\,a_j \f$ with \f$ \bar A = A A \f$. Why is only one force a
//!    stage left to iterate? The assignment asks for the step of two stages.
//! 2. Compute the region of contraction of simultaneous sweeps for s = 2 by hand. By what does it shrink for
//!    \f$ \ddot r = -\omega^2 r \f$, in \f$ \omega\,\Delta t \f$?
