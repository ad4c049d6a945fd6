#pragma once

#include <stdexcept>
#include <vector>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

/// @file
/// Runs whose only interest is the motion: whatever does not reach its end ends the case.

namespace verification {

/// Throws unless a run got where it should.
inline void require_reached(const particulate::schemes::Outcome& outcome) {
  if (outcome.status != particulate::schemes::Status::reached) throw std::runtime_error(outcome.reason);
}

/// Moves a state to t_end by a scheme under a control, both of which are copied. @return what it took
template <class S, class C>
particulate::schemes::Outcome reached(const particulate::schemes::Problem& problem, particulate::schemes::State& state,
                                      double t_end, S scheme, C control) {
  const particulate::schemes::Outcome outcome = integrate(problem, state, t_end, scheme, control);
  require_reached(outcome);
  return outcome;
}

/// The same where nobody asks what it took.
template <class S, class C>
void reach(const particulate::schemes::Problem& problem, particulate::schemes::State& state, double t_end, S scheme,
           C control) {
  require_reached(integrate(problem, state, t_end, scheme, control));
}

/// Moves a state to t_end in equal steps of a scheme.
template <class S>
void advance(const particulate::schemes::Problem& problem, particulate::schemes::State& state, double t_end,
             long steps) {
  const double step = (t_end - state.t) / static_cast<double>(steps);
  reach(problem, state, t_end, S(), particulate::schemes::FixedStep{.step = step});
}

/// The states of a run at equal steps, the start and the end included.
template <class S, class P>
std::vector<particulate::schemes::State> path(P& problem, particulate::schemes::State state, double t_end, long steps) {
  std::vector<particulate::schemes::State> states{state};
  S scheme;
  particulate::schemes::FixedStep control{.step = (t_end - state.t) / static_cast<double>(steps)};
  const auto keep = [&](const auto&, const particulate::schemes::State& to, double, const S&) {
    states.push_back(to);
    return true;
  };
  require_reached(integrate(problem, state, t_end, scheme, control, keep));
  return states;
}

/// Three numbers a particle as rows.
inline Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>> rows_of(const Eigen::VectorXd& flat) {
  return {flat.data(), flat.size() / 3, 3};
}

/// A moment at which two bodies stop approaching or parting.
struct Turning {
  double t;         ///< [s]
  double distance;  ///< [m]
};

/// Half the rate of the squared distance of bodies 0 and 1.
inline double parting(const particulate::schemes::State& at) {
  const auto r = rows_of(at.r);
  const auto v = rows_of(at.v);
  return (r.row(1) - r.row(0)).dot(v.row(1) - v.row(0));
}

/// Distance of bodies 0 and 1.
inline double distance_of_pair(const particulate::schemes::State& at) {
  const auto r = rows_of(at.r);
  return (r.row(1) - r.row(0)).norm();
}

/// The moment within one step at which the pair turns, by bisection on the size of that step.
template <class S, class P>
Turning turning_within(P& problem, const particulate::schemes::State& from, double dt) {
  particulate::schemes::State there = from;
  double low = 0.0, high = dt;
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    S scheme;
    if (!scheme.predict(problem, from, middle, there)) throw std::runtime_error("no value within a step that had one");
    (parting(there) * parting(from) > 0.0 ? low : high) = middle;
  }
  return {.t = from.t + low, .distance = distance_of_pair(there)};
}

/// The first turnings of a pair under a scheme at a fixed step.
template <class S, class P>
std::vector<Turning> turnings(P& problem, particulate::schemes::State state, double step, std::size_t count) {
  std::vector<Turning> found;
  S scheme;
  particulate::schemes::FixedStep control{.step = step};
  const auto watch = [&](const auto& from, const auto& to, double dt, const S&) {
    if (parting(from) * parting(to) < 0.0) found.push_back(turning_within<S>(problem, from, dt));
    return found.size() < count;
  };
  const double far_beyond = state.t + 1e6 * step;
  const auto outcome = integrate(problem, state, far_beyond, scheme, control, watch);
  if (found.size() < count) throw std::runtime_error("the pair did not turn often enough: " + outcome.reason);
  return found;
}

}  // namespace verification
