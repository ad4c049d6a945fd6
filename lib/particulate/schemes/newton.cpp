#include <particulate/schemes/newton.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/LU>
#include <Eigen/SparseLU>

namespace particulate::schemes {

namespace detail {

// By (v, y), and by r; what a problem does not have is empty.
template <class Matrix>
struct Derivatives {
  Matrix J, K;
};

}  // namespace detail

namespace {

using detail::Derivatives;
using Complex = std::complex<double>;

// `set(i, j, quotient)` is called column by column.
template <class Set>
bool difference_quotients(const RatesOf& rates, const Eigen::VectorXd& at, const Eigen::VectorXd& f,
                          const Eigen::VectorXd& sizes, std::optional<Bandwidth> band, const Set& set) {
  const Eigen::Index n = at.size(), rows = f.size();
  const Bandwidth within = band.value_or(Bandwidth{.lower = rows - 1, .upper = n - 1});
  const Eigen::Index together = std::min(n, within.lower + within.upper + 1);
  Eigen::VectorXd x = at;
  std::vector<Eigen::VectorXd> moved(static_cast<std::size_t>(together), Eigen::VectorXd(rows));
  for (Eigen::Index group = 0; group < together; ++group) {
    for (Eigen::Index j = group; j < n; j += together) x[j] += difference_step(at[j], sizes[j]);
    if (!rates(x, moved[static_cast<std::size_t>(group)])) return false;
    for (Eigen::Index j = group; j < n; j += together) x[j] = at[j];
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXd& there = moved[static_cast<std::size_t>(j % together)];
    const double step = (at[j] + difference_step(at[j], sizes[j])) - at[j];
    const Eigen::Index first = std::max<Eigen::Index>(0, j - within.upper);
    for (Eigen::Index i = first; i <= std::min(rows - 1, j + within.lower); ++i) set(i, j, (there[i] - f[i]) / step);
  }
  return true;
}

// The rates (a, dy) of a problem as one vector, with one part of the state replaced.
class RatesBy {
 public:
  RatesBy(const Problem& problem, State at) : problem_(problem), at_(std::move(at)) {}

  bool operator()(Eigen::VectorXd& f) {
    if (!problem_.rates(at_, rates_)) return false;
    f.resize(rates_.a.size() + rates_.dy.size());
    f.head(rates_.a.size()) = rates_.a;
    f.tail(rates_.dy.size()) = rates_.dy;
    return true;
  }
  RatesOf part(Eigen::VectorXd State::*which) {
    return [this, which](const Eigen::VectorXd& x, Eigen::VectorXd& f) {
      const Eigen::VectorXd kept = std::exchange(at_.*which, x);
      const bool value = (*this)(f);
      at_.*which = kept;
      return value;
    };
  }

 private:
  const Problem& problem_;
  State at_;
  Rates rates_;
};

Where where(const State& at) {
  return {at.t, {at.r.data(), at.r.size()}, {at.v.data(), at.v.size()}, {at.y.data(), at.y.size()}};
}

bool is_finite(const Eigen::MatrixXd& matrix) { return std::isfinite((0.0 * matrix).sum()); }
bool is_finite(const SparseJacobian& matrix) { return matrix.nonZeros() == 0 || std::isfinite((0.0 * matrix).sum()); }

// Of a problem that has places or values: its own Jacobian.
template <class Matrix, class Ask>
Derivatives<Matrix> given(const Problem& problem, const State& from, const Ask& ask) {
  Derivatives<Matrix> by;
  Matrix& J = problem.traits().motion ? by.K : by.J;
  const Eigen::Index n = problem.traits().motion ? from.r.size() : from.y.size();
  J.resize(n, n);
  ask(J);
  return by;
}

// Of a problem that has all of (r, v, y).
Derivatives<Eigen::MatrixXd> whole(const Problem& problem, const State& from) {
  const Eigen::Index n = from.r.size(), m = problem.traits().values ? from.y.size() : 0;
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(n + m, 2 * n + m);
  problem.jacobian(where(from), W);
  if (W.rows() != n + m || W.cols() != 2 * n + m) {
    throw std::invalid_argument(
        "problem: jacobian(t, r, v, y, J) must leave its matrix as large as it gets it, with a row "
        "for each rate in (a, dy) and a column for each number in (r, v, y)");
  }
  Derivatives<Eigen::MatrixXd> by{.J = W.rightCols(n + m), .K = Eigen::MatrixXd::Zero(n + m, n + m)};
  by.K.leftCols(n) = W.leftCols(n);
  return by;
}

// Below which increments are absolute.
struct Increments {
  const Eigen::VectorXd& sizes;  // of the unknowns (r, y)
  double speed;                  // of velocities
};

// The band, if there is one, is that of places or of values alone.
template <class Matrix>
bool by_differences(const Problem& problem, const State& from, const Increments& step, Derivatives<Matrix>& by) {
  const Eigen::VectorXd& sizes = step.sizes;
  const Traits& has = problem.traits();
  RatesBy rates(problem, from);
  Eigen::VectorXd f;
  if (!rates(f)) return false;
  if (!has.motion) { return difference_jacobian(rates.part(&State::y), from.y, f, sizes, problem.bandwidth(), by.J); }
  if (!difference_jacobian(rates.part(&State::r), from.r, f, sizes, problem.bandwidth(), by.K)) return false;
  if (!has.velocities) return true;
  return difference_jacobian(rates.part(&State::v), from.v, f, Eigen::VectorXd::Constant(from.v.size(), step.speed),
                             problem.bandwidth(), by.J);
}

// Of motion and values that act on each other.
bool by_all_differences(const Problem& problem, const State& from, const Increments& step,
                        Derivatives<Eigen::MatrixXd>& by) {
  const Eigen::Index n = from.r.size(), m = from.y.size();
  RatesBy rates(problem, from);
  Eigen::VectorXd f;
  Eigen::MatrixXd by_r, by_v = Eigen::MatrixXd::Zero(n + m, n), by_y;
  if (!rates(f) || !difference_jacobian(rates.part(&State::r), from.r, f, step.sizes.head(n), {}, by_r) ||
      (problem.traits().velocities &&
       !difference_jacobian(rates.part(&State::v), from.v, f, Eigen::VectorXd::Constant(n, step.speed), {}, by_v)) ||
      !difference_jacobian(rates.part(&State::y), from.y, f, step.sizes.tail(m), {}, by_y)) {
    return false;
  }
  by.K = Eigen::MatrixXd::Zero(n + m, n + m);
  by.K.leftCols(n) = by_r;
  by.J.resize(n + m, n + m);
  by.J << by_v, by_y;
  return true;
}

std::optional<Derivatives<Eigen::MatrixXd>> dense_derivatives(const Problem& problem, const State& from,
                                                              const Increments& step) {
  Derivatives<Eigen::MatrixXd> by;
  if (problem.has_whole_jacobian()) {
    by = whole(problem, from);
  } else if (problem.has_jacobian()) {
    by = given<Eigen::MatrixXd>(problem, from, [&](Eigen::MatrixXd& J) { problem.jacobian(where(from), J); });
  } else if (problem.traits().motion && problem.traits().values) {
    if (!by_all_differences(problem, from, step, by)) return {};
  } else if (!by_differences(problem, from, step, by)) {
    return {};
  }
  if (!is_finite(by.J) || !is_finite(by.K)) return {};
  return by;
}

std::optional<Derivatives<SparseJacobian>> sparse_derivatives(const Problem& problem, const State& from,
                                                              const Increments& step) {
  Derivatives<SparseJacobian> by;
  if (problem.traits().motion && problem.traits().values) {
    throw std::invalid_argument(
        "Newton: sparse matrices are for problems of motion or of values, got one of both: take "
        "DenseStages, or stagger the two");
  }
  if (problem.has_sparse_jacobian()) {
    by = given<SparseJacobian>(problem, from, [&](SparseJacobian& J) { problem.sparse_jacobian(where(from), J); });
  } else if (!problem.bandwidth()) {
    throw std::invalid_argument(
        "Newton: sparse matrices need a problem with sparse_jacobian() or bandwidth(), got one "
        "with neither: take DenseStages");
  } else if (!by_differences(problem, from, step, by)) {
    return {};
  }
  if (!is_finite(by.J) || !is_finite(by.K)) return {};
  return by;
}

using SparseComplex = Eigen::SparseMatrix<Complex>;

template <class System, class Matrix>
System system(const Derivatives<Matrix>& by, Complex shift) {
  const Eigen::Index n = std::max(by.J.rows(), by.K.rows());
  System of(n, n);
  of.setIdentity();
  if (by.J.rows() > 0) of -= System(by.J.template cast<Complex>() * shift);
  if (by.K.rows() > 0) of -= System(by.K.template cast<Complex>() * (shift * shift));
  return of;
}

}  // namespace

double difference_step(double value, double size) {
  const double step = std::sqrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(value), size);
  return std::copysign(std::exp2(std::round(std::log2(step))), value);
}

bool difference_jacobian(const RatesOf& rates, const Eigen::VectorXd& x, const Eigen::VectorXd& f,
                         const Eigen::VectorXd& sizes, std::optional<Bandwidth> band, Eigen::MatrixXd& J) {
  J = Eigen::MatrixXd::Zero(f.size(), x.size());
  return difference_quotients(rates, x, f, sizes, band,
                              [&](Eigen::Index i, Eigen::Index j, double quotient) { J(i, j) = quotient; });
}

bool difference_jacobian(const RatesOf& rates, const Eigen::VectorXd& x, const Eigen::VectorXd& f,
                         const Eigen::VectorXd& sizes, std::optional<Bandwidth> band, SparseJacobian& J) {
  J.resize(f.size(), x.size());
  J.setZero();
  return difference_quotients(rates, x, f, sizes, band, [&](Eigen::Index i, Eigen::Index j, double quotient) {
    if (quotient != 0.0) J.insert(i, j) = quotient;
  });
}

struct NewtonSteps::Jacobians {
  std::variant<Derivatives<Eigen::MatrixXd>, Derivatives<SparseJacobian>> by;
};

struct NewtonSteps::Factors {
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXcd>> dense;  // one an eigenvalue, of one kind or the other
  std::vector<std::unique_ptr<Eigen::SparseLU<SparseComplex>>> sparse;

  void add(const Derivatives<Eigen::MatrixXd>& by, Complex shift) {
    dense.emplace_back().compute(system<Eigen::MatrixXcd>(by, shift));
  }
  void add(const Derivatives<SparseJacobian>& by, Complex shift) {
    const SparseComplex of = system<SparseComplex>(by, shift);
    sparse.push_back(std::make_unique<Eigen::SparseLU<SparseComplex>>());
    if (of.cols() > 0) sparse.back()->compute(of);  // which divides by the number of columns
  }
  Eigen::VectorXcd solve(std::size_t i, const Eigen::VectorXcd& right) const {
    if (right.size() == 0) return right;
    if (!dense.empty()) return dense[i].solve(right);
    if (sparse[i]->info() == Eigen::Success) return sparse[i]->solve(right);
    return Eigen::VectorXcd::Constant(right.size(), std::numeric_limits<double>::quiet_NaN());
  }
};

// At known_at_.
bool NewtonSteps::take(const Problem& problem) {
  const auto keep = [&](auto by) {
    if (by) jacobians_ = std::make_shared<Jacobians>(Jacobians{std::move(*by)});
  };
  jacobians_.reset();
  factorized_ = 0.0;
  const Increments by{sizes_, speed_};
  sparse_ ? keep(sparse_derivatives(problem, known_at_, by)) : keep(dense_derivatives(problem, known_at_, by));
  return jacobians_ != nullptr;
}

bool NewtonSteps::prepare(const Problem& problem, const State& from, double dt, const StageEquations& step) {
  if (!eigenvalues_) eigenvalues_ = std::make_shared<StageEigenvalues>(step.A);
  if (!jacobians_ || sizes_.size() != step.sizes.size() || (step.bad && known_at_.t != from.t)) {
    known_at_ = from;
    sizes_ = step.sizes;
    speed_ = step.speed;
    if (!take(problem)) return false;
  }
  if (dt == factorized_) return true;
  const auto factors = std::make_shared<Factors>();
  for (const Complex& value : eigenvalues_->values()) {
    std::visit([&](const auto& by) { factors->add(by, value * dt); }, jacobians_->by);
  }
  factors_ = factors;
  factorized_ = dt;
  return true;
}

Eigen::MatrixXd NewtonSteps::solve(const Eigen::Ref<const Eigen::MatrixXd>& residual) const {
  Eigen::MatrixXcd apart = eigenvalues_->apart(residual);
  for (Eigen::Index i = 0; i < apart.cols(); ++i) {
    const Eigen::VectorXcd right = apart.col(i);
    apart.col(i) = factors_->solve(static_cast<std::size_t>(i), right);
  }
  return eigenvalues_->together(apart);
}

Eigen::VectorXd NewtonSteps::filtered(const Eigen::VectorXd& defect, double dt) const {
  const std::size_t i = eigenvalues_->real();
  const Eigen::VectorXcd right = (eigenvalues_->values()[i] * dt) * defect;
  return factors_->solve(i, right).real();
}

}  // namespace particulate::schemes
