// How the sweeps of collocation contract, and how its steps damp.

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>
#include <boost/math/special_functions/legendre.hpp>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/linear_algebra.hpp>
#include <particulate/report/table.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "linear_problems.hpp"
#include "pade.hpp"

namespace verification::collocation_contraction {

using namespace particulate::schemes;

// How fast the sweeps of collocation come nearer on a spring, and where they cease to, against matrices put together
// without the library.

using Square = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

std::vector<long double> gauss_points(int s) {
  std::vector<long double> c;
  for (const long double x : boost::math::legendre_p_zeros<long double>(s)) {
    c.push_back((1.0L + x) / 2.0L);
    if (x != 0.0L) c.push_back((1.0L - x) / 2.0L);
  }
  std::sort(c.begin(), c.end());
  return c;
}

// Of the polynomial that is 1 at node j and 0 at the others, the coefficients of 1, x, x^2, ...
std::vector<long double> lagrange(const std::vector<long double>& c, std::size_t j) {
  std::vector<long double> of{1.0L};
  for (std::size_t m = 0; m < c.size(); ++m) {
    if (m == j) continue;
    std::vector<long double> next(of.size() + 1, 0.0L);
    for (std::size_t k = 0; k < of.size(); ++k) {
      next[k] -= c[m] * of[k] / (c[j] - c[m]);
      next[k + 1] += of[k] / (c[j] - c[m]);
    }
    of = std::move(next);
  }
  return of;
}

// The weights of Gauss collocation, integrals of those polynomials up to the nodes, multiplied by themselves.
Square weights_twice(int s) {
  const std::vector<long double> c = gauss_points(s);
  Square A(s, s);
  for (Eigen::Index j = 0; j < s; ++j) {
    const std::vector<long double> l = lagrange(c, static_cast<std::size_t>(j));
    for (Eigen::Index i = 0; i < s; ++i) {
      A(i, j) = 0.0L;
      long double power = 1.0L;
      for (std::size_t k = 0; k < l.size(); ++k) {
        power *= c[static_cast<std::size_t>(i)];
        A(i, j) += l[k] * power / static_cast<long double>(k + 1);
      }
    }
  }
  return A.lazyProduct(A);
}

// The limit of |M^n|^(1/n), by squaring: after 50 of them what the norm is does not matter.
double spectral_radius(Square matrix) {
  long double logarithm = 0.0L, share_of = 1.0L;
  for (int k = 0; k < 50; ++k) {
    const long double size = matrix.cwiseAbs().maxCoeff();
    logarithm += share_of * std::log(size);
    matrix /= size;
    matrix = matrix.lazyProduct(matrix).eval();
    share_of /= 2.0L;
  }
  return static_cast<double>(std::exp(logarithm));
}

// Errors e of the rates. All at once: e' = -x^2 A A e. In turn, with the part L of A A below the diagonal already new:
// e' = -x^2 (L e' + (A A - L) e), solved for e' row by row.
double by_theory(int s, bool sequential, double x) {
  const long double z = -static_cast<long double>(x) * x;
  const Square all = weights_twice(s);
  Square next = z * all;
  for (Eigen::Index i = 1; sequential && i < s; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) next.row(i) += z * all(i, j) * (next.row(j) - Square::Identity(s, s).row(j));
  }
  return spectral_radius(next);
}

// The smallest omega dt at which the sweeps contract no more.
double limit_by_theory(int s, bool sequential) {
  double low = 0.0, high = 0.125;
  while (by_theory(s, sequential, high) < 1.0) low = std::exchange(high, high + 0.125);
  while (high - low > 1e-13 * high) {
    const double middle = 0.5 * (low + high);
    (by_theory(s, sequential, middle) < 1.0 ? low : high) = middle;
  }
  return low;
}

constexpr double omega = 8.0;

// A spring, of which the first answer may be a false one: from rest at zero, the sweeps then go back to zero itself,
// and their changes stay exact however small they are.
struct Spring {
  bool deceives = false;

  bool acceleration(double, In r, Out a) {
    a[0] = deceives ? 1.0 : -omega * omega * r[0];
    deceives = false;
    return true;
  }
};

// The largest eigenvalue by which changes x go down, which may be one of a pair: x'' = p x' + q x.
double largest_factor(const std::vector<State>& iterates, std::size_t at) {
  const auto change = [&](std::size_t k) { return iterates[at + k + 1].r[0] - iterates[at + k].r[0]; };
  // Two equations for p and q by Cramer's rule.
  const double unit = change(0), x1 = change(1) / unit, x2 = change(2) / unit, x3 = change(3) / unit;
  const double determinant = x1 * x1 - x2;
  if (std::abs(determinant) < 1e-10 * x1 * x1) return std::abs(x1);  // one leads alone
  const double p = (x1 * x2 - x3) / determinant, q = (x1 * x3 - x2 * x2) / determinant;
  const std::complex<double> root = std::sqrt(std::complex<double>(0.25 * p * p + q));
  return std::max(std::abs(0.5 * p + root), std::abs(0.5 * p - root));
}

template <int S, class Solver>
double compare_factor(Rows& rows, const std::string& how, double x, const Tolerance& tolerance) {
  const double expected = by_theory(S, std::is_same_v<Solver, Sequential>, x);
  // As many as there are powers of ten down to the smallest double.
  const int sweeps = static_cast<int>(std::min(4000.0, -280.0 / std::log10(expected)));
  Spring deceiver{.deceives = true};
  const Sweeps seen = sweep_by_hand(Collocation<Gauss<S>, Solver>(), deceiver, motion(0.0, 0.0), x / omega, sweeps);
  const auto last = static_cast<std::size_t>(sweeps);
  rows.compare(fmt::format("factor of a sweep, {}, s = {}, omega dt = {:.6g}", how, S, x),
               {.expected = expected,
                .computed = largest_factor(seen.iterates, last - 4),
                .tolerance = tolerance,
                .because = "the eigenvalues next in size die out with their own powers; of a pair, two equations tell "
                           "the size"});
  const double whole = seen.iterations[last - 1].change / seen.iterations[last / 4].change;
  const double reported = std::pow(whole, 1.0 / static_cast<double>(last - 1 - last / 4));
  rows.compare(
      fmt::format("mean of the changes that the scheme reports, {}, s = {}, omega dt = {:.6g}", how, S, x),
      {.expected = expected,
       .computed = reported,
       .tolerance = relative(std::pow(1e3, 4.0 / (3.0 * sweeps)) - 1.0),
       .because = "that of the end of the step: where a pair of eigenvalues leads it goes up and down, within a "
                  "factor of a thousand over all the sweeps"});
  return reported;
}

// One step, against the Pade approximation of exp(i omega dt), by which omega r - i v turns.
template <int S, class Solver>
Ending spring(double x, const Solver& solver, FixedStep control, double tolerance, const std::string& because) {
  Spring problem;
  State to = motion(0.8, -0.6 * omega);
  Collocation<Gauss<S>, Solver> scheme({}, solver);
  const Outcome out = integrate(problem, to, x / omega, scheme, control);
  if (out.status != Status::reached) return Ending::refused(out.reason);
  const std::complex<double> exact = pade(S, S, {0.0, x}) * std::complex<double>(0.8, 0.6);
  return Ending::solved({.error = std::abs(std::complex<double>(to.r[0], -to.v[0] / omega) - exact),
                         .tolerance = tolerance,
                         .because = because});
}

template <int S, class Solver>
void compare_limit(Rows& rows, const std::string& how, double limit) {
  const auto at = [=](double x) {
    // Rounding, repeated by 1/(1 - 0.998), is above 1e-12 of the displacement.
    const FixedStep control{.step = x / omega, .TOL = 1e-10, .contractions = 30000};
    return spring<S>(
        x, Solver(), control, 1e-6,
        "sweeps stop where a change is at most TOL = 1e-10; their limit is 1/(1 - 0.998) such changes away, in some "
        "powers of ten for s = 8");
  };
  rows.must_be_solved(fmt::format("s = {}, {}, omega dt = {:.6g} (1 - 1e-3)", S, how, limit),
                      [=] { return at(limit * (1.0 - 1e-3)); });
  rows.must_be_refused(fmt::format("s = {}, {}, omega dt = {:.6g} (1 + 1e-3)", S, how, limit), "diverge Dt needs",
                       [=] { return at(limit * (1.0 + 1e-3)); });
}

template <int S>
void compare(Rows& rows, particulate::report::Table& table) {
  const std::string together = "all stages at once", in_turn = "in turn";
  const double all = limit_by_theory(S, false), turn = limit_by_theory(S, true);
  compare_factor<S, Picard>(rows, together, 0.97 * all, relative(1e-10));
  compare_factor<S, Sequential>(rows, in_turn, 0.97 * turn, relative(1e-10));
  const double small = compare_factor<S, Picard>(rows, together, 0.5, relative(1e-2));
  const double smaller = compare_factor<S, Sequential>(rows, in_turn, 0.5, relative(1e-2));
  compare_limit<S, Picard>(rows, together, all);
  compare_limit<S, Sequential>(rows, in_turn, turn);
  if (S > 1) {
    rows.at_most(fmt::format("factor in turn over that of all at once, omega dt = 0.5, s = {}", S),
                 {.limit = 0.62, .computed = smaller / small, .because = "new rates are used at once: about half"});
    rows.at_most(fmt::format("limit in turn over that of all at once, s = {}", S),
                 {.limit = 0.86, .computed = turn / all, .because = "the price: four fifths, where steps are large"});
  }
  table.add({static_cast<double>(S), all, turn, small, smaller});
}

const Case collocation_contraction{
    {.name = "collocation_contraction",
     .claim = "on a spring sweeps over all stages contract by (omega dt)^2 times the largest eigenvalue of A A, those "
              "through the stages in turn by that of their own matrix: twice as fast at small steps, up to a smaller "
              "omega dt",
     .equation = "D 3.4",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      particulate::report::Table table({"s [-]", "limit of omega dt, all at once [-]", "limit of omega dt, in turn [-]",
                                        "factor at omega dt = 0.5, all at once [-]",
                                        "factor at omega dt = 0.5, in turn [-]"});
      compare<1>(rows, table);
      compare<2>(rows, table);
      compare<3>(rows, table);
      compare<4>(rows, table);
      compare<6>(rows, table);
      compare<8>(rows, table);
      const double beyond = 2.0 * limit_by_theory(3, true);
      rows.must_be_solved(fmt::format("s = 3, Anderson, omega dt = {:.6g}, twice the limit in turn", beyond), [=] {
        return spring<3>(beyond, Anderson(3), FixedStep{.step = beyond / omega}, 1e-12,
                         "three unknowns: three differences of a linear map end at rounding, which one with slopes of "
                         "forty magnifies");
      });
      rows.write("collocation_contraction", table);
    }};

// What one step of collocation makes of linear problems, against the Pade approximations that it should be.

using Complex = std::complex<double>;

// A power of two, so that lambda dt is what it should be to the last bit.
constexpr double dt = 1.0 / 64.0;

// y' = lambda y in the plane of complex numbers.
struct Turning {
  Complex lambda;

  bool rate(double, In y, Out dy) const {
    dy[0] = lambda.real() * y[0] - lambda.imag() * y[1];
    dy[1] = lambda.imag() * y[0] + lambda.real() * y[1];
    return true;
  }
  void jacobian(double, In, Eigen::MatrixXd& J) const {
    J.resize(2, 2);
    J << lambda.real(), -lambda.imag(), lambda.imag(), lambda.real();
  }
};

// To rounding, by hand.
template <class S>
Complex one_step(S scheme, const Turning& problem, const State& from) {
  State to = from;
  if (!scheme.predict(problem, from, dt, to)) throw std::runtime_error("a linear problem has a value everywhere");
  Iteration it;
  do { it = scheme.sweep(problem, from, dt, to); } while (it.evaluated && !at_rounding(it) && it.K < 100);
  if (!at_rounding(it)) throw std::runtime_error("Newton ought to solve a linear problem");
  return {to.y[0], to.y[1]};
}

// From y = 1 + 0 i.
template <class Nodes>
Complex measured(Complex z) {
  const Turning problem{.lambda = z / dt};
  const State from{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.0}};
  return one_step(Collocation<Nodes, Newton<>>(), problem, from);
}

// The end of a step is 1 + sum_j b_j h k_j, where h k solves (I - z A) h k = z: what rounding leaves of the sum.
template <class Nodes>
double rounding(Complex z) {
  const CollocationTable of = collocation_table(Nodes::nodes());
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(Nodes::stages, Nodes::stages) - z * of.A;
  const Eigen::VectorXcd terms =
      of.b.cast<Complex>().cwiseProduct(solve(system, Eigen::VectorXcd::Constant(Nodes::stages, z)));
  return eps * (1.0 + terms.cwiseAbs().sum());
}

template <class Nodes>
void compare_decay(Rows& rows, const std::string& method) {
  constexpr int s = Nodes::stages, numerator = Nodes::order - s;
  const std::string roundings = "the rounding of 1 + sum b_j h k_j, sixteen times: stages end within some roundings";
  for (const Complex z : {Complex(-0.5, 0.0), Complex(-3.0, 4.0), Complex(2.0, -1.0), Complex(0.0, 0.75),
                          Complex(0.0, -20.0), Complex(-1e3, 1e3), Complex(-1e6, 0.0)}) {
    rows.at_most(
        fmt::format("{}, distance from the Pade approximation, lambda dt = {} + {} i", method, z.real(), z.imag()),
        {.limit = 16.0 * rounding<Nodes>(z),
         .computed = std::abs(measured<Nodes>(z) - pade(numerator, s, z)),
         .because = roundings});
  }
  const bool symmetric = numerator == s;
  for (const double y : {0.1, 1.0, 10.0, 1e4}) {
    const double size = std::abs(measured<Nodes>({0.0, y}));
    const std::string what = fmt::format("{}, |R|, lambda dt = {} i", method, y);
    if (symmetric) {
      rows.compare(what, {.expected = 1.0,
                          .computed = size,
                          .tolerance = absolute(16.0 * rounding<Nodes>({0.0, y})),
                          .because = roundings});
    } else {
      rows.at_most(what, {.limit = 1.0 + 16.0 * rounding<Nodes>({0.0, y}), .computed = size, .because = roundings});
    }
  }
  // The leading terms of numerator and denominator: (-1)^s for Gauss, (-1)^s s/z for Radau.
  const double limit = (s % 2 == 0 ? 1.0 : -1.0) * (symmetric ? 1.0 : -s / 1e6);
  rows.compare(fmt::format("{}, R far to the left, lambda dt = -1e6", method),
               {.expected = limit,
                .computed = measured<Nodes>(-1e6).real(),
                .tolerance = absolute((symmetric ? 4.0 * s * (s + 1) / 1e6 : 4.0 * s * s * s / 1e12) +
                                      16.0 * rounding<Nodes>(-1e6)),
                .because = "the next term is smaller by about s^2/|lambda dt|"});
}

const Case collocation_stability{
    {.name = "collocation_stability",
     .claim =
         "on y' = lambda y Gauss makes of a step the diagonal Pade approximation of exp(lambda dt), with |R| = 1 on "
         "the imaginary axis, and Radau IIA the one below it, which vanishes far to the left",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_decay<Gauss<1>>(rows, "Gauss 1");
      compare_decay<Gauss<2>>(rows, "Gauss 2");
      compare_decay<Gauss<3>>(rows, "Gauss 3");
      compare_decay<Gauss<4>>(rows, "Gauss 4");
      compare_decay<Gauss<5>>(rows, "Gauss 5");
      compare_decay<Gauss<6>>(rows, "Gauss 6");
      compare_decay<Gauss<7>>(rows, "Gauss 7");
      compare_decay<Gauss<8>>(rows, "Gauss 8");
      compare_decay<Radau<1>>(rows, "Radau 1");
      compare_decay<Radau<2>>(rows, "Radau 2");
      compare_decay<Radau<3>>(rows, "Radau 3");
      compare_decay<Radau<5>>(rows, "Radau 5");
    }};

}  // namespace verification::collocation_contraction
