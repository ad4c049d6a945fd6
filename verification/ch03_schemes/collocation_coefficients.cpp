// Every coefficient of the collocation methods against fifty digits, and against the conditions that make their order.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <harness/case.hpp>
#include <particulate/schemes/collocation_table.hpp>

#include "linear_problems.hpp"

namespace verification::collocation_coefficients_ {

using namespace particulate::schemes;
using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Polynomial = std::vector<Digits50>;  // coefficients of 1, x, x^2, ...

Digits50 at(const Polynomial& p, const Digits50& x) {
  Digits50 sum = 0;
  for (auto k = p.rbegin(); k != p.rend(); ++k) sum = sum * x + *k;
  return sum;
}
Polynomial times(const Polynomial& p, const Polynomial& q) {
  Polynomial product(p.size() + q.size() - 1, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
  }
  return product;
}
Polynomial derivative(const Polynomial& p) {
  Polynomial slope;
  for (std::size_t k = 1; k < p.size(); ++k) slope.push_back(p[k] * k);
  return slope;
}
Polynomial integral(const Polynomial& p) {
  Polynomial area{0};
  for (std::size_t k = 0; k < p.size(); ++k) area.push_back(p[k] / (k + 1));
  return area;
}

// Rodrigues: the nodes are the zeros of the derivative of order `low` of x^low (x - 1)^s; low = s makes Gauss, s - 1
// makes Radau IIA.
Polynomial nodal_polynomial(int low, int s) {
  Polynomial p{1};
  for (int k = 0; k < low; ++k) p = times(p, {0, 1});
  for (int k = 0; k < s; ++k) p = times(p, {-1, 1});
  for (int k = 0; k < low; ++k) p = derivative(p);
  return p;
}

// The zeros, found by Newton's method in fifty digits; where it begins does not matter as long as all are found.
std::vector<Digits50> zeros(const Polynomial& p, const Eigen::VectorXd& guesses) {
  const Polynomial slope = derivative(p);
  std::vector<Digits50> found;
  for (const double guess : guesses) {
    Digits50 x = guess;
    for (int k = 0; k < 8; ++k) x -= at(p, x) / at(slope, x);
    found.push_back(x);
  }
  return found;
}

using Matrix50 = std::vector<std::vector<Digits50>>;

// A method in fifty digits, by Lagrange polynomials written out in powers.
struct Exact {
  std::vector<Digits50> c, b, b_bar;
  Matrix50 A, A_bar;
};

Exact exact_method(const std::vector<Digits50>& c) {
  const std::size_t s = c.size();
  Exact of{.c = c, .b = {}, .b_bar = std::vector<Digits50>(s, 0), .A = Matrix50(s), .A_bar = Matrix50(s)};
  for (std::size_t j = 0; j < s; ++j) {
    Polynomial l{1};
    for (std::size_t m = 0; m < s; ++m) {
      if (m != j) l = times(l, {-c[m] / (c[j] - c[m]), 1 / (c[j] - c[m])});
    }
    const Polynomial area = integral(l);
    of.b.push_back(at(area, 1));
    for (std::size_t i = 0; i < s; ++i) of.A[i].push_back(at(area, c[i]));
  }
  for (std::size_t i = 0; i < s; ++i) {
    of.A_bar[i].assign(s, 0);
    for (std::size_t j = 0; j < s; ++j) {
      for (std::size_t m = 0; m < s; ++m) of.A_bar[i][j] += of.A[i][m] * of.A[m][j];
      of.b_bar[j] += of.b[i] * of.A[i][j];
    }
  }
  return of;
}

// Relative to the coefficient, or to 0.01 where it is smaller: some of b_bar are zero, and extended precision leaves
// 1e-20 of them.
double relative_error(double computed, const Digits50& exact) {
  const double size = std::max(std::abs(static_cast<double>(exact)), 0.01);
  return std::abs(static_cast<double>(Digits50(computed) - exact)) / size;
}
double worst(const Eigen::VectorXd& computed, const std::vector<Digits50>& exact) {
  double largest = 0.0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    keep_worst(largest, relative_error(computed[static_cast<Eigen::Index>(k)], exact[k]));
  }
  return largest;
}
double worst(const Eigen::MatrixXd& computed, const Matrix50& exact) {
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    keep_worst(largest, worst(Eigen::VectorXd(computed.row(static_cast<Eigen::Index>(i)).transpose()), exact[i]));
  }
  return largest;
}

// One method by its name.
struct Method {
  std::string name;
  int s;
  bool gauss;

  std::vector<long double> nodes() const { return gauss ? gauss_nodes(s) : radau_nodes(s); }
  CollocationTable coefficients() const { return collocation_table(nodes()); }
};

std::vector<Method> methods() {
  std::vector<Method> all;
  for (int s = 1; s <= 8; ++s) all.push_back({fmt::format("Gauss {}", s), s, true});
  for (const int s : {1, 2, 3, 5}) all.push_back({fmt::format("Radau {}", s), s, false});
  return all;
}

void compare_digits(Rows& rows, const Method& method) {
  const CollocationTable of = method.coefficients();
  const Exact exact = exact_method(zeros(nodal_polynomial(method.gauss ? method.s : method.s - 1, method.s), of.c));
  long rising = 0;
  for (std::size_t j = 0; j < exact.c.size(); ++j) {
    rising += static_cast<long>(exact.c[j] > (j > 0 ? exact.c[j - 1] : Digits50(0)) && exact.c[j] <= 1);
  }
  rows.equal(method.name + ": nodes that rise in (0, 1]",
             {.expected = method.s, .computed = rising, .because = "a polynomial of degree s has all its zeros there"});
  const auto digits = [&](const std::string& what, double error) {
    rows.at_most(fmt::format("{}: relative error of {}", method.name, what),
                 {.limit = 1.01 * eps / 2.0,
                  .computed = error,
                  .because = "rounded once from extended precision, whose own error counts a hundredth of that"});
  };
  digits("c", worst(of.c, exact.c));
  digits("b", worst(of.b, exact.b));
  digits("A", worst(of.A, exact.A));
  digits("b_bar", worst(of.b_bar, exact.b_bar));
  digits("A_bar = A A", worst(of.A_bar, exact.A_bar));
}

// A sum of products of coefficients that must vanish, over what half a rounding of each coefficient makes of it.
struct Defect {
  long double sum = 0.0L, rounding = 0.0L;

  // Adds a term in which so many coefficients are multiplied.
  void add(long double term, int factors) {
    sum += term;
    rounding += std::abs(term) * factors * static_cast<long double>(eps) / 2.0L;
  }
  double over_rounding() const { return static_cast<double>(std::abs(sum) / rounding); }
};

long double power(double x, int q) { return std::pow(static_cast<long double>(x), q); }

// sum_j weights_j c_j^(q-1) = value for q = 1 ... highest; value(q) is a product of so many coefficients.
template <class Value>
void keep_conditions(double& largest, const Eigen::VectorXd& weights, const Eigen::VectorXd& c, int highest,
                     const Value& value) {
  for (int q = 1; q <= highest; ++q) {
    Defect defect;
    for (Eigen::Index j = 0; j < c.size(); ++j) defect.add(weights[j] * power(c[j], q - 1), q);
    value(q, defect);
    keep_worst(largest, defect.over_rounding());
  }
}

// B: quadrature at the end, C: quadrature at the stages, D: what the stages' errors make at the end.
struct Conditions {
  double B = 0.0, C = 0.0, D = 0.0, positions = 0.0, place = 0.0;
};

Conditions conditions(const Method& method) {
  const CollocationTable of = method.coefficients();
  const int s = method.s, order = method.gauss ? 2 * s : 2 * s - 1;
  Conditions worst;
  keep_conditions(worst.B, of.b, of.c, order, [](int q, Defect& defect) { defect.add(-1.0L / q, 0); });
  keep_conditions(worst.place, of.b_bar, of.c, order - 1,
                  [](int q, Defect& defect) { defect.add(-1.0L / (q * (q + 1)), 0); });
  for (Eigen::Index i = 0; i < s; ++i) {
    keep_conditions(worst.C, of.A.row(i), of.c, s,
                    [&](int q, Defect& defect) { defect.add(-power(of.c[i], q) / q, q); });
    keep_conditions(worst.positions, of.A_bar.row(i), of.c, s - 1,
                    [&](int q, Defect& defect) { defect.add(-power(of.c[i], q + 1) / (q * (q + 1)), q + 1); });
    const Eigen::VectorXd column = of.b.cwiseProduct(of.A.col(i));  // rounded itself: one factor more
    for (int q = 1; q <= order - s; ++q) {
      Defect defect;
      for (Eigen::Index k = 0; k < s; ++k) defect.add(column[k] * power(of.c[k], q - 1), q + 2);
      defect.add(-of.b[i] / static_cast<long double>(q), 1);
      defect.add(of.b[i] * power(of.c[i], q) / q, q + 1);
      keep_worst(worst.D, defect.over_rounding());
    }
  }
  return worst;
}

void compare_conditions(Rows& rows, const Method& method) {
  const Conditions seen = conditions(method);
  const int s = method.s, order = method.gauss ? 2 * s : 2 * s - 1;
  const auto holds = [&](const std::string& condition, int highest, double over_rounding) {
    if (highest < 1) return;
    rows.at_most(fmt::format("{}: {} up to q = {}, over rounding", method.name, condition, highest),
                 {.limit = 1.0,
                  .computed = over_rounding,
                  .because = "half a rounding of each coefficient moves the sum by as much"});
  };
  holds("B, sum b_i c_i^(q-1) = 1/q", order, seen.B);
  holds("C, sum a_ij c_j^(q-1) = c_i^q/q", s, seen.C);
  holds("D, sum b_i c_i^(q-1) a_ij = b_j (1 - c_j^q)/q", order - s, seen.D);
  holds("positions, sum abar_ij c_j^(q-1) = c_i^(q+1)/(q (q+1))", s - 1, seen.positions);
  holds("positions, sum bbar_i c_i^(q-1) = 1/(q (q+1))", order - 1, seen.place);
}

// Symmetric and symplectic, as Gauss is.
void compare_structure(Rows& rows, const Method& method) {
  const CollocationTable of = method.coefficients();
  double symplectic = 0.0, symmetric = 0.0;
  const Eigen::Index last = method.s - 1;
  for (Eigen::Index i = 0; i <= last; ++i) {
    for (Eigen::Index j = 0; j <= last; ++j) {
      Defect area, mirror;
      area.add(static_cast<long double>(of.b[i]) * of.A(i, j), 2);
      area.add(static_cast<long double>(of.b[j]) * of.A(j, i), 2);
      area.add(-static_cast<long double>(of.b[i]) * of.b[j], 2);
      keep_worst(symplectic, area.over_rounding());
      mirror.add(of.A(i, j), 1);
      mirror.add(of.A(last - i, last - j), 1);
      mirror.add(-static_cast<long double>(of.b[j]), 1);
      keep_worst(symmetric, mirror.over_rounding());
    }
  }
  rows.at_most(method.name + ": symplectic, b_i a_ij + b_j a_ji = b_i b_j, over rounding",
               {.limit = 1.0, .computed = symplectic, .because = "half a rounding of each coefficient"});
  rows.at_most(method.name + ": symmetric, a_ij + a_(s+1-i)(s+1-j) = b_j, over rounding",
               {.limit = 1.0, .computed = symmetric, .because = "half a rounding of each coefficient"});
}

// Nodes that have a closed form.
void compare_published(Rows& rows) {
  const auto compare = [&](const Method& method, const std::vector<double>& known) {
    for (std::size_t j = 0; j < known.size(); ++j) {
      rows.compare(fmt::format("{}: c{}", method.name, j + 1),
                   {.expected = known[j],
                    .computed = method.coefficients().c[static_cast<Eigen::Index>(j)],
                    .tolerance = absolute(2.0 * eps),
                    .because = "roots evaluated in double precision, some roundings of 1"});
    }
  };
  const double third = std::sqrt(3.0) / 6.0, fifth = std::sqrt(15.0) / 10.0, six = std::sqrt(6.0);
  compare({"Gauss 1", 1, true}, {0.5});
  compare({"Gauss 2", 2, true}, {0.5 - third, 0.5 + third});
  compare({"Gauss 3", 3, true}, {0.5 - fifth, 0.5, 0.5 + fifth});
  compare({"Radau 1", 1, false}, {1.0});
  compare({"Radau 2", 2, false}, {1.0 / 3.0, 1.0});
  compare({"Radau 3", 3, false}, {(4.0 - six) / 10.0, (4.0 + six) / 10.0, 1.0});
}

const Case collocation_coefficients_case{
    {.name = "collocation_coefficients",
     .claim = "the coefficients of Gauss and Radau IIA collocation are right to the last digit, in first-order and in "
              "Nystrom form",
     .equation = "D 3.4",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      compare_published(rows);
      for (const Method& method : methods()) {
        compare_digits(rows, method);
        compare_conditions(rows, method);
        if (method.gauss) compare_structure(rows, method);
      }
    }};

// Powers of theta from their values at the nodes, inside the step and as far beyond as guesses are extrapolated.
struct Polynomials {
  double basis = 0.0, once = 0.0, twice = 0.0;
};

// Over what their sums are made of: rounding counts so many times.
template <class Nodes>
Polynomials polynomials(double theta) {
  const CollocationTable& table = table_of<Nodes>();
  const auto l = table.basis(theta), area = table.once(theta), place = table.twice(theta);
  const double size = std::max(1.0, std::pow(theta, Nodes::stages)) * (1.0 + l.cwiseAbs().sum());
  Polynomials worst;
  for (int q = 1; q <= Nodes::stages; ++q) {
    const Eigen::VectorXd powers = table.c.array().pow(q - 1.0);
    keep_worst(worst.basis, std::abs(l.dot(powers) - std::pow(theta, q - 1)) / size);
    keep_worst(worst.once, std::abs(area.dot(powers) - std::pow(theta, q) / q) / size);
    if (q < Nodes::stages) {
      keep_worst(worst.twice, std::abs(place.dot(powers) - std::pow(theta, q + 1) / (q * (q + 1))) / size);
    }
  }
  return worst;
}

template <class Nodes>
void compare_polynomials(Rows& rows, const std::string& name) {
  Polynomials largest;
  for (const double theta : {0.0, 0.1, 0.31, 0.5, 0.77, 1.0, 1.3, 2.0, 3.9}) {
    const Polynomials seen = polynomials<Nodes>(theta);
    keep_worst(largest.basis, seen.basis);
    keep_worst(largest.once, seen.once);
    keep_worst(largest.twice, seen.twice);
  }
  const auto exact = [&](const std::string& what, double error) {
    rows.at_most(name + ": " + what,
                 {.limit = 4.0 * Nodes::stages * eps,
                  .computed = error,
                  .because = "products of s differences, each rounded, over the sum of what they make"});
  };
  exact("powers of theta from the nodes", largest.basis);
  exact("their integrals", largest.once);
  exact("the integrals of those", largest.twice);
}

const Case collocation_polynomials{
    {.name = "collocation_polynomials",
     .claim = "the polynomial through the nodes and its integrals reproduce every power up to their degree, inside the "
              "step and beyond",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      compare_polynomials<Gauss<1>>(rows, "Gauss 1");
      compare_polynomials<Gauss<2>>(rows, "Gauss 2");
      compare_polynomials<Gauss<4>>(rows, "Gauss 4");
      compare_polynomials<Gauss<8>>(rows, "Gauss 8");
      compare_polynomials<Radau<3>>(rows, "Radau 3");
      compare_polynomials<Radau<5>>(rows, "Radau 5");
    }};

}  // namespace verification::collocation_coefficients_
