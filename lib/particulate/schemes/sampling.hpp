#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <particulate/schemes/integrate.hpp>

namespace particulate::schemes {

namespace detail {

// The times that are still to come, and the state at them.
class SampleTimes {
 public:
  explicit SampleTimes(std::vector<double> times);
  std::size_t left() const { return times_.size() - next_; }
  // Hands on the state at each that lies in a step; throws if one was missed.
  template <class S, class Receive>
  void visit(const State& from, const State& to, double dt, const S& scheme, Receive&& receive) {
    static_assert(Dense<S>, "states at requested times need a scheme with dense output, at(from, dt, theta, there)");
    while (in_step(from, to)) {
      const double t = times_[next_++];
      if (t == from.t || t == to.t) {
        receive(t == to.t ? to : from);
      } else {
        scheme.at(from, dt, ((t - from.t) - from.t_carry) / dt, there_);
        there_.t = t;
        there_.t_carry = 0.0;
        receive(std::as_const(there_));
      }
    }
  }

 private:
  bool in_step(const State& from, const State& to) const;

  std::vector<double> times_;
  std::size_t next_ = 0;
  State there_;
};

}  // namespace detail

/// States at requested times, without cutting a step for them: an observer for integrate().
///
/// A time inside a step is given the dense output of the scheme, of whose order it is; an end of a step the state that
/// the run has there. The first state counts, and so does the last; at a jump or an event with an action it is the
/// state before it. A run that makes no step gives none. One object serves a run in several parts, and what its end
/// left over is still to come.
///
///     Sampling samples({0.0, 0.5, 1.0}, [&](const State& at) { plot(at.t, at.r[0]); });
///     integrate(problem, state, t_end, scheme, control, samples);
template <class Receive, class Observer = Unobserved>
class Sampling {
 public:
  /// @param times     finite, each later than the one before; those beyond the end of a run are not reached [s]
  /// @param receive   is given the state at each, by reference
  /// @param observer  gets every step as well, after the states in it, and returns whether to go on
  /// @throws std::invalid_argument for times that are not in order
  explicit Sampling(std::vector<double> times, Receive receive, Observer observer = {})
      : times_(std::move(times)), receive_(std::move(receive)), observer_(std::forward<Observer>(observer)) {}

  /// One step of a run.
  ///
  /// @param from    its start
  /// @param to      its end
  /// @param dt      its length [s]
  /// @param scheme  that made it, with dense output
  /// @return what the observer answers
  /// @throws std::invalid_argument if a time lies before the start of the run
  template <class S>
  bool operator()(const State& from, const State& to, double dt, const S& scheme) {
    times_.visit(from, to, dt, scheme, receive_);
    return observer_(from, to, dt, scheme);
  }

  /// @param after  the state after a jump
  /// @param jump   what it did; the observer is told
  void jumped(const State& after, const Jump& jump) requires SeesJumps<Observer> { observer_.jumped(after, jump); }

  /// @return how many times are still to come [-]
  std::size_t left() const { return times_.left(); }

 private:
  detail::SampleTimes times_;
  Receive receive_;
  Observer observer_;
};

/// An observer in std::ref() is not copied.
template <class Receive, class Observer>
Sampling(std::vector<double>, Receive, std::reference_wrapper<Observer>) -> Sampling<Receive, Observer&>;

}  // namespace particulate::schemes
