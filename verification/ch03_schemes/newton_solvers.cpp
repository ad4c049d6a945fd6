// Simplified Newton on a chain with one spring a million times stiffer than the others, however it comes by its
// Jacobian, and on a stiff damper.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <Eigen/SparseCore>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/linear_algebra.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/collocation.hpp>

#include "linear_problems.hpp"
#include "pade.hpp"

namespace verification::newton_solvers {

using namespace particulate::schemes;

constexpr Eigen::Index masses = 20;
constexpr double stiffer = 1e6, step = 0.1, t_end = 2.0;

// Springs of stiffness 1 between unit masses and two walls, but for one in the middle.
double spring(Eigen::Index i) { return i == masses / 2 ? stiffer : 1.0; }

struct Chain {
  bool acceleration(double, In r, Out a) const {
    for (Eigen::Index i = 0; i < masses; ++i) {
      const double left = i > 0 ? r[i - 1] : 0.0, right = i + 1 < masses ? r[i + 1] : 0.0;
      a[i] = spring(i) * (left - r[i]) + spring(i + 1) * (right - r[i]);
    }
    return true;
  }
};

template <class Matrix, class Set>
void fill(Matrix& K, const Set& set) {
  for (Eigen::Index j = 0; j < masses; ++j) {
    if (j > 0) set(K, j - 1, j, spring(j));
    set(K, j, j, -spring(j) - spring(j + 1));
    if (j + 1 < masses) set(K, j + 1, j, spring(j + 1));
  }
}
Eigen::MatrixXd stiffness() {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(masses, masses);
  fill(K, [](Eigen::MatrixXd& of, Eigen::Index i, Eigen::Index j, double value) { of(i, j) = value; });
  return K;
}

struct GivenChain : Chain {
  long jacobians = 0;  // asked for so far

  void jacobian(double, In, Eigen::MatrixXd& K) {
    ++jacobians;
    K = stiffness();
  }
};
struct BandedChain : Chain {
  Bandwidth bandwidth() const { return {.lower = 1, .upper = 1}; }
};
struct SparseChain : Chain {
  void sparse_jacobian(double, In, Eigen::SparseMatrix<double>& K) const { K = stiffness().sparseView(); }
};

// The stiffest spring of the Jacobian is not that of the forces.
struct MistakenChain : Chain {
  double share = 1.0;
  void sparse_jacobian(double, In, Eigen::SparseMatrix<double>& K) const {
    Eigen::MatrixXd mistaken = stiffness();
    const Eigen::Index m = masses / 2;
    mistaken.block(m - 1, m - 1, 2, 2) -= (share - 1.0) * stiffer * Eigen::Matrix2d{{1.0, -1.0}, {-1.0, 1.0}};
    K = mistaken.sparseView();
  }
};

// The slowest modes of the chain, of amplitudes 1, 1/2 and 1/3, all at their farthest at the start.
State exact(double t) {
  const Modes modes = symmetric_modes(-stiffness());
  State at{.t = t, .r = Eigen::VectorXd::Zero(masses), .v = Eigen::VectorXd::Zero(masses)};
  for (Eigen::Index m = 0; m < 3; ++m) {
    const double omega = std::sqrt(modes.values[m]), amplitude = 1.0 / static_cast<double>(m + 1);
    at.r += amplitude * std::cos(omega * t) * modes.vectors.col(m);
    at.v -= amplitude * omega * std::sin(omega * t) * modes.vectors.col(m);
  }
  return at;
}

struct Run {
  State end;
  long evaluations = 0;
};
template <class Linear, class Nodes = Gauss<3>>
Run run(const Problem& problem) {
  Run of{.end = exact(0.0)};
  of.evaluations =
      reached(problem, of.end, t_end, Collocation<Nodes, Newton<Linear>>(), FixedStep{.step = step}).evaluations;
  return of;
}

double apart(const State& one, const State& other) { return (one.r - other.r).lpNorm<Eigen::Infinity>(); }

void compare(Rows& rows, const std::string& how, const Run& of, const Run& given, double tolerance) {
  rows.at_most(
      "chain, " + how + ", largest distance from the Jacobian given, positions",
      {.limit = tolerance,
       .computed = apart(of.end, given.end),
       .because = "the equations are the same; 20 steps of rounding, which a system of condition 1e4 (dt^2 1e6) "
                  "magnifies"});
}

const Case newton_solvers{
    {.name = "newton_solvers",
     .claim =
         "Newton takes steps a hundred times beyond the stiffest spring's period alike with a Jacobian given, by "
         "differences, banded or sparse, asks for one right-hand side an unknown or a diagonal, and keeps the Jacobian "
         "where it serves",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      GivenChain given_chain;
      const Chain chain;
      const BandedChain banded_chain;
      const SparseChain sparse_chain;
      const Run given = run<DenseStages>(given_chain);
      const long jacobians = given_chain.jacobians;
      const Run differences = run<DenseStages>(chain);
      const Run banded = run<DenseStages>(banded_chain), sparse = run<SparseStages>(sparse_chain);
      const Run sparse_band = run<SparseStages>(banded_chain);
      rows.at_most("chain, largest error of a position at t = 2 s, Gauss 3, Jacobian given",
                   {.limit = 1e-9,
                    .computed = apart(given.end, exact(t_end)),
                    .because = "(omega dt)^6/2016000 a radian of the modes with omega < 0.5/s, and rounding"});
      compare(rows, "dense, by differences", differences, given, 1e-10);
      compare(rows, "banded, by differences", banded, given, 1e-10);
      compare(rows, "sparse", sparse, given, 1e-10);
      compare(rows, "sparse from a band, by differences", sparse_band, given, 1e-10);
      rows.equal("Jacobians in 20 steps, given", {.expected = 1, .computed = jacobians, .because = "it is constant"});
      rows.none("right-hand sides with the sparse one over those with the dense one",
                sparse.evaluations - given.evaluations, "the same sweeps");
      rows.at_least("right-hand sides that a Jacobian by differences costs",
                    {.limit = static_cast<double>(masses),
                     .computed = static_cast<double>(differences.evaluations - given.evaluations),
                     .because = "one for each unknown"});
      rows.at_most("right-hand sides that a banded one saves, less than those of the dense one",
                   {.limit = -static_cast<double>(masses - 3) + 6.0,
                    .computed = static_cast<double>(banded.evaluations - differences.evaluations),
                    .because = "three in place of twenty, but for a sweep or two"});
      const Run radau = run<DenseStages, Radau<3>>(given_chain);
      rows.at_most("chain, largest error of a position at t = 2 s, Radau 3, Jacobian given",
                   {.limit = 1e-8,
                    .computed = apart(radau.end, exact(t_end)),
                    .because = "(omega dt)^5/7200 a radian of the modes with omega < 0.5/s"});
      const MistakenChain mistaken{{}, 0.9};
      const Run near = run<SparseStages>(mistaken);
      compare(rows, "sparse, with the stiffest spring at nine tenths", near, given, 1e-10);
      rows.at_least("right-hand sides that this mistake costs, over those without it",
                    {.limit = 1.5,
                     .computed = static_cast<double>(near.evaluations) / static_cast<double>(sparse.evaluations),
                     .because = "Newton then contracts by a ninth a sweep, and goes on until it is there"});
      rows.must_be_refused("chain, a sparse Jacobian with the stiffest spring at a tenth", "diverge Dt", [] {
        MistakenChain problem{{}, 0.1};
        State state = exact(0.0);
        Collocation<Gauss<3>, Newton<SparseStages>> scheme;
        FixedStep control{.step = step};
        return ending_of(integrate(problem, state, t_end, scheme, control));
      });
      rows.must_be_refused("chain, omega dt = 141 by sequential sweeps", "diverge Dt", [] {
        const Chain problem;
        State state = exact(0.0);
        Collocation<Gauss<3>> scheme;
        FixedStep control{.step = step};
        return ending_of(integrate(problem, state, t_end, scheme, control));
      });
    }};

// One step of v' = -c v by Radau with c dt = 1e4, in the form r'' = a(v): v is multiplied by R, r moves by v dt (R -
// 1)/z.
void prove_newton_damper(Rows& rows) {
  const double z = -1e4, dt = 0.5;
  Drag drag{.c = -z / dt, .m = 1.0};
  State state = motion(0.25, 3.0);
  reach(drag, state, dt, Collocation<Radau<3>, Newton<>>(), FixedStep{.step = dt});
  const double factor = pade(2, 3, z).real();
  rows.compare("v after a step of c dt = 1e4, Radau 3 [m/s]", {.expected = 3.0 * factor,
                                                               .computed = state.v[0],
                                                               .tolerance = absolute(64.0 * 3.0 * eps),
                                                               .because = "roundings of sums of terms as large as v"});
  rows.compare("r likewise [m]", {.expected = 0.25 + 3.0 * dt * (factor - 1.0) / z,
                                  .computed = state.r[0],
                                  .tolerance = absolute(64.0 * eps),
                                  .because = "roundings of sums of terms as large as v dt"});
}

const Case newton_damper{{.name = "newton_damper",
                          .claim = "Newton solves forces that depend on velocities, with both Jacobians by differences",
                          .equation = "D 3.4",
                          .reference = Reference::closed_form},
                         prove_newton_damper};

}  // namespace verification::newton_solvers
