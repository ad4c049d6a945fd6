#include <particulate/schemes/integrate.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <particulate/schemes/first_step.hpp>
#include <particulate/schemes/iteration.hpp>

namespace particulate::schemes {

namespace {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

void validate_finite(const Eigen::VectorXd& x, const char* what) {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (!std::isfinite(x[k])) {
      throw std::invalid_argument(fmt::format("run: {} must start finite, got {} in entry {}", what, x[k], k));
    }
  }
}

// What a run would leave where it stands.
void validate_parts(const Traits& of, const State& state) {
  if (!of.staggered && !of.motion && state.r.size() > 0) {
    throw std::invalid_argument(fmt::format(
        "run: the problem has a rate of values alone, so the state must have no places, got {}: they go into y",
        state.r.size()));
  }
  if (!of.staggered && !of.values && !of.carries && state.y.size() > 0) {
    throw std::invalid_argument(fmt::format(
        "run: the problem has no rate for values, so the state must have none, got {}: give it rates(t, r, v, "
        "y, a, dy), or the constant values_by_jumps if they change by jumps alone",
        state.y.size()));
  }
}

std::string too_small(double t, double dt, const std::string& refusal = {}) {
  if (!refusal.empty()) {
    return fmt::format(
        "at t = {} s no step is small enough, down to Dt = {:.3g} s that changes the time no more; the "
        "last one refused: {}",
        t, dt, refusal);
  }
  return fmt::format(
      "the step must change the time, but t + Dt = t with t = {} s and Dt = {} s: choose a larger step, or count time "
      "from nearer the start",
      t, dt);
}

std::string not_located(double t, double dt, double off) {
  return fmt::format(
      "from t = {} s on a jump or an event was seen in the step, but no shorter step ends there: solved anew, a step "
      "of "
      "{:.3g} s still moves by {:.3g} of itself; take smaller steps, or a smaller tolerance of the sweeps",
      t, dt, off);
}

std::string accumulating(double t, long most) {
  return fmt::format(
      "{} jumps or events in a row passed no time: they accumulate at t = {} s, and no step gets beyond it; end the "
      "run "
      "before, or change the state there",
      most, t);
}

// A fixed step cannot be cut.
// The longest step that time scales allow, and which of them rules; none: no such limit.
struct Limit {
  const TimeScale* scale = nullptr;
  double spans = 0.0, step = std::numeric_limits<double>::infinity();
  const TimeScale* beside = nullptr;  // takes its share of the step
};

std::string beyond_limit(double dt, const Limit& limit) {
  const std::string beside =
      limit.beside ? fmt::format(" (with {} beside it, {:.6g} s, fewer)", limit.beside->name, limit.beside->seconds)
                   : "";
  return fmt::format(
      "a step must span at most {:.6g} of the time scale of {}, which is {:.6g} s{}, but the fixed step is {:.6g} s: "
      "take at most {:.6g} s, or a control that adapts its step",
      limit.spans, limit.scale->name, limit.scale->seconds, beside, dt, limit.step);
}

}  // namespace

void validate_run(const Traits& of, const State& state, double t_end) {
  if (!std::isfinite(state.t)) {
    throw std::invalid_argument(fmt::format("run: the start time must be finite, got {} s", state.t));
  }
  if (!(t_end >= state.t && std::isfinite(t_end))) {
    throw std::invalid_argument(
        fmt::format("run: the end time must be finite and not before the start at {} s, got {} s", state.t, t_end));
  }
  if (state.r.size() != state.v.size()) {
    throw std::invalid_argument(fmt::format("run: positions and velocities must have one length, got {} and {}",
                                            state.r.size(), state.v.size()));
  }
  validate_finite(state.r, "positions");
  validate_finite(state.v, "velocities");
  validate_finite(state.y, "values");
  validate_parts(of, state);
}

double rounding_of_time(long steps, double t, double t_end) {
  return static_cast<double>(steps + 1) * rounding_unit * std::max(std::abs(t), std::abs(t_end));
}

double step_towards_end(double wished, double left, double rounding) {
  const double slack = std::min(1e-9 * wished + rounding, 1e-3 * wished);
  return wished + slack < left ? wished : left;
}

namespace detail {
namespace {

class Run {
 public:
  explicit Run(const Task& task)
      : task_(task),
        problem_(task.problem.counted_by(out_.evaluations)),
        state_(task.state),
        to_(task.state),
        locates_(task.watch || task.problem.locates_jumps()) {
    if (!task_.scheme_can.advances(problem_.traits())) {
      throw std::invalid_argument(
          "run: the scheme must be able to advance all that the problem has, and this one leaves something behind: "
          "take "
          "another scheme, or leave out the forces that ask for velocities, or the values that have rates");
    }
    if (locates_ && !task_.scheme_can.at) {
      throw std::invalid_argument(
          "run: events and located jumps need a scheme with dense output, at(from, dt, theta, "
          "there); this one has none");
    }
  }

  Outcome go() {
    const Overlap overlap = problem_.overlap(state_);
    out_.overlap_at_start = overlap.deepest, out_.contacts_at_start = overlap.contacts;
    bool goes_on = true;
    task_.scheme_can.begin(task_.scheme, problem_, state_);
    if (task_.control_can.waits_for_step(task_.control) && state_.t < task_.t_end) begin_control();
    while (goes_on && state_.t < task_.t_end) goes_on = step();
    out_.t = state_.t;
    return out_;
  }

 private:
  // A step is solved anew so often at most to end at a jump or an event; by halves alone 50 times would do.
  static constexpr int max_location_iterations = 64;
  // It ends there if it does so within this part of itself, or so many roundings of the whole,
  static constexpr double location_tolerance = 1e-14, location_roundings = 4.0;
  // or, where solving it anew brings it no nearer, as rounding or the tolerance of its sweeps keep it from, of itself.
  static constexpr double stagnation_tolerance = 1e-6;
  // or where a function touches zero.
  static constexpr double touch_tolerance = 1e-9;
  // Its length is looked for so often by secants, then by halves.
  static constexpr int secants = 6;
  // How far beyond its end a step that was shortened is looked at again.
  static constexpr double search_limit = 1.1;
  // A scheme cannot extrapolate from so small a part of a step to the next whole one.
  static constexpr double extrapolation_limit = 0.5;
  // So many roundings of a whole step do not pass time.
  static constexpr double time_resolution = 1000.0;

  void forget() { task_.scheme_can.forget(task_.scheme); }

  void begin_control() {
    const Traits& of = problem_.traits();
    if (of.staggered && !of.motion && !of.values) {
      throw std::invalid_argument(
          "run: the first step of staggered fields must be given, as no rates tell one, but the control has step = 0");
    }
    task_.control_can.begin(task_.control, first_step(problem_, state_, task_.t_end));
  }

  bool end(Status status, std::string reason, Failure failure = Failure::none) {
    if (failure == Failure::no_value) reason += why_no_value();
    out_.status = status;
    out_.reason = std::move(reason);
    out_.failure = failure;
    return false;
  }

  // At the start of the step, else at its last iterate, else where its bodies are heading.
  std::string why_no_value() const {
    std::string why = problem_.why_no_value(state_);
    if (why.empty()) why = problem_.why_no_value(to_);
    if (why.empty() && state_.r.size() > 0) {
      State ahead = state_;
      advance_time(state_, dt_, ahead);
      ahead.r += dt_ * ahead.v;
      why = problem_.why_no_value(ahead);
    }
    return why.empty() ? why : ": " + why;
  }

  // Tries one step; returns whether the run goes on.
  bool step() {
    choose();
    if (problem_.has_step_limits() && task_.scheme_can.spans && !within_limits()) return false;
    if (!(state_.t + dt_ > state_.t)) {
      return last_.refusal.empty() ? end(Status::failed, too_small(state_.t, dt_), Failure::time_stands_still)
                                   : end(Status::failed, too_small(state_.t, dt_, last_.refusal), last_.failure);
    }
    whole_ = dt_;
    Decision decision = attempt_with(task_.control_can.judge);
    stop_ = {};
    if (locates_ && decision.accepted) decision = land();
    if (!decision.impossible.empty()) {
      out_.workable_step = decision.workable;
      return end(Status::failed, std::move(decision.impossible), decision.failure);
    }
    if (!decision.accepted) {
      ++out_.rejections;
      last_ = std::move(decision);
      return true;
    }
    if (!last_.refusal.empty()) last_ = {};
    return accept();
  }

  // The controller's step, or what is left to the end. Where these differ by rounding the step is the controller's, so
  // that a run in two legs makes the steps of one: the time carries the difference.
  void choose() {
    const double wished = task_.control_can.dt(task_.control), left = (task_.t_end - state_.t) - state_.t_carry;
    const double rounding = rounding_of_time(1, state_.t, task_.t_end);
    dt_ = step_towards_end(wished, left, rounding);
    const bool ends = dt_ == left;
    if (ends && std::abs(left - wished) <= std::min(rounding, 1e-9 * wished)) dt_ = wished;
    to_the_end_ = ends ? dt_ : std::numeric_limits<double>::quiet_NaN();
  }

  // Cuts the step to what the problem's time scales allow, or refuses it where it is fixed.
  bool within_limits() {
    const std::vector<TimeScale> scales = problem_.step_limits(state_);
    const Limit limit = tightest(scales);
    if (dt_ <= limit.step) return true;
    if (task_.control_can.fixes_step || !(limit.step > 0.0)) {
      out_.workable_step = limit.step;
      return end(Status::failed, beyond_limit(dt_, limit), Failure::beyond_limit);
    }
    dt_ = limit.step;
    out_.ruled = limit.scale->name;
    return true;
  }

  Limit tightest(const std::vector<TimeScale>& scales) const {
    using Kind = TimeScale::Kind;
    Limit all, waves, decays;
    for (const TimeScale& scale : scales) {
      if (!(scale.seconds > 0.0)) {
        throw std::invalid_argument(
            fmt::format("problem: the time scale of {} must be positive, got {} s", scale.name, scale.seconds));
      }
      const double spans = task_.scheme_can.spans(task_.scheme, scale.kind, task_.control_can.sweeps(task_.control));
      const Limit limit{.scale = &scale, .spans = spans, .step = spans * scale.seconds};
      for (Limit* each : {&all, &waves, &decays}) {
        if (each == &waves && scale.kind != Kind::waves) continue;
        if (each == &decays && scale.kind != Kind::decays && scale.kind != Kind::loads) continue;
        if (limit.step < each->step) *each = limit;
      }
    }
    if (!task_.scheme_can.adds_limits || !waves.scale || !decays.scale) return all;
    // (dt/w)^2 + dt/d = 1.
    const double together =
        2.0 / (1.0 / decays.step + std::sqrt(1.0 / (decays.step * decays.step) + 4.0 / (waves.step * waves.step)));
    if (!(together < all.step)) return all;
    const bool waves_rule = waves.step < decays.step;
    Limit shared = waves_rule ? waves : decays;
    shared.beside = waves_rule ? decays.scale : waves.scale;
    shared.step = together;
    return shared;
  }

  Decision attempt_with(Decision (*judge)(void*, const Attempt&)) {
    const Attempt made = attempt();
    Decision decision = judge(task_.control, made);
    if (decision.accepted && !made.iteration.evaluated) {
      throw std::logic_error("a controller must refuse a step on which the problem had no value, but it accepted one");
    }
    return decision;
  }

  // The guess, then sweeps for as long as the controller asks for them.
  Attempt attempt() {
    const SchemeTable& can = task_.scheme_can;
    Attempt made{.dt = dt_, .iteration = {}, .within_limits = problem_.has_step_limits() && can.spans};
    Iteration& it = made.iteration;
    it.evaluated = can.predict(task_.scheme, problem_, state_, dt_, to_);
    if (can.sweep) {
      while (it.evaluated && (it.K < 0 || task_.control_can.goes_on(task_.control, it))) {
        it = can.sweep(task_.scheme, problem_, state_, dt_, to_);
        ++out_.sweeps;
        if (shows_contraction(it)) out_.contraction = std::max(out_.contraction, it.rate);
      }
    }
    advance_time(state_, dt_, to_);
    if (dt_ == to_the_end_) to_.t_carry += to_.t - task_.t_end, to_.t = task_.t_end;
    if (can.iterations) made.fields = can.iterations(task_.scheme);
    it.evaluated = it.evaluated && is_finite(to_);
    if (can.truncation && it.evaluated && !task_.control_can.ignores_truncation) {
      made.truncation = can.truncation(task_.scheme, problem_, state_, dt_, to_);
    }
    return made;
  }

  // Takes the step that stands, and the jump and the events at its end.
  bool accept() {
    task_.scheme_can.accept(task_.scheme, dt_);
    if (dt_ < extrapolation_limit * whole_) forget();
    const std::size_t events = task_.watch ? task_.watch->happen(to_, stop_) : 0;
    const bool go_on = task_.observe(task_.observer, state_, to_, dt_);
    if (problem_.jumps() && !book(problem_.jump(to_, dt_))) return false;
    if (events > 0 && !change(events)) return false;
    swap(state_, to_);
    ++out_.steps;
    if (locates_ && accumulates()) return false;
    if (events > 0 && task_.watch->stops(events)) return end(Status::stopped, task_.watch->last());
    return go_on || end(Status::stopped, "the observer asked for it");
  }

  bool change(std::size_t events) {
    bool settled = true;
    for (Jump& jump : task_.watch->change(events, to_)) {
      forget();
      settled = settled && book(std::move(jump));
    }
    return settled;
  }

  bool book(Jump jump) {
    if (task_.jumped) task_.jumped(task_.observer, to_, jump);
    out_.impacts += jump.impacts;
    out_.energy_change += jump.energy_change;
    out_.heat += jump.heat;
    out_.released += jump.released;
    out_.overlap = std::max(out_.overlap, jump.overlap);
    out_.penetration = std::max(out_.penetration, jump.penetration);
    out_.travel = std::max(out_.travel, jump.travel);
    out_.evaluations += jump.evaluations;
    if (out_.jumps_by_law.size() < jump.by_law.size()) out_.jumps_by_law.resize(jump.by_law.size());
    for (std::size_t k = 0; k < jump.by_law.size(); ++k) {
      out_.jumps_by_law[k].impacts += jump.by_law[k].impacts;
      out_.jumps_by_law[k].energy_change += jump.by_law[k].energy_change;
    }
    if (jump.impacts > 0 || !jump.unsettled.empty()) forget();
    if (jump.unsettled.empty()) return true;
    out_.accumulation = jump.accumulates;
    return end(Status::failed, std::move(jump.unsettled),
               std::isnan(jump.accumulates) ? Failure::unsettled_jump : Failure::accumulating);
  }

  bool accumulates() {
    const bool no_time = dt_ <= time_resolution * rounding_unit * whole_ || (task_.watch && task_.watch->stands());
    long& at_once = task_.watch ? task_.watch->at_once() : at_once_;
    at_once = stop_ && no_time ? at_once + 1 : 0;
    if (at_once <= (task_.watch ? task_.watch->settings() : WatchSettings{}).most_at_once) return false;
    out_.accumulation = state_.t;
    return !end(Status::failed, accumulating(state_.t, at_once), Failure::accumulating);
  }

  StepPath path() const {
    return {task_.scheme, task_.scheme_can.at, state_, dt_, std::max(4, task_.scheme_can.order), &to_};
  }

  // The first place of the step made last at which the state jumps or an event happens.
  std::optional<Stop> first_stop(double until) {
    const bool last = dt_ == to_the_end_;
    if (last) until = 1.0;
    std::optional<Stop> first;
    if (problem_.locates_jumps()) {
      if (const std::optional<double> jump = problem_.first_jump(path(), until)) first = {*jump, true, true};
    }
    if (task_.watch) {
      const std::optional<Stop> event = task_.watch->first(path(), until, last);
      if (event && !(first && first->theta < event->theta)) first = event;
    }
    return first;
  }

  // Shortens the step until it ends at the first jump or event, if there is one: by secants, since the distance of its
  // end from the event is nearly linear in its length whatever the event is, and between a length that was too short
  // and one that was too long. The controller judges the shortened step, but keeps the step that it has chosen.
  Decision land() {
    if (task_.watch) task_.watch->start(path());
    double too_short = 0.0, too_long = dt_, off = 0.0, dt = 0.0, margin = rounding_unit * whole_;
    bool bracketed = false;
    for (int solves = 0; solves < max_location_iterations; ++solves) {
      stop_ = first_stop(solves == 0 ? 1.0 : search_limit);
      // Nothing happens in it: what a longer step has shown is looked for again from its end, if it is there at all.
      if (!stop_ && !bracketed) return {.accepted = true};
      const double before = std::exchange(off, stop_ ? (stop_->theta - 1.0) * dt_ : margin);
      const bool stagnates = solves > 1 && solves <= secants && std::abs(off) >= 0.5 * std::abs(before);
      if (stop_ && lands(off, stagnates)) return {.accepted = true};
      (off < 0.0 ? too_long : too_short) = dt_;
      bracketed = bracketed || (stop_ && stop_->reached && stop_->sharp);
      const bool closed = too_long - too_short <= resolution();
      if (closed && dt_ == too_long && stop_->reached) return {.accepted = true};
      // A secant that goes much farther than it should is not trusted. Beyond what it is to reach by rounding, which
      // may be more than expected.
      const double secant = solves > 0 && off != before ? off * (dt - dt_) / (off - before) : off;
      if (off > 0.0 && (stagnates || off <= 8.0 * margin)) margin = std::max(8.0 * margin, off);
      double next = dt_ + (std::abs(secant - off) < 0.5 * std::abs(off) ? secant : off) + margin;
      // Beyond the whole step: it was not in there after all, but at the start of the next one.
      if (off > 0.0 && too_long == whole_ && next >= whole_) return stop_.reset(), Decision{.accepted = true};
      if (closed && dt_ != too_long) {
        next = too_long;
      } else if (!(next > too_short && next < too_long) || solves >= secants) {
        next = 0.5 * (too_short + too_long);
      }
      dt = std::exchange(dt_, next);
      const Decision decision = attempt_with(task_.control_can.judge_apart);
      if (!decision.accepted) return decision;
    }
    return {.impossible = not_located(state_.t, dt, std::abs(off) / dt), .failure = Failure::not_located};
  }

  double resolution() const { return std::max(location_tolerance * dt_, location_roundings * rounding_unit * whole_); }
  bool lands(double off, bool stagnates) const {
    const double slack = stagnates ? stagnation_tolerance : stop_->sharp ? 0.0 : touch_tolerance;
    return stop_->reached && std::abs(off) <= std::max(resolution(), slack * dt_);
  }

  const Task& task_;
  Outcome out_;
  Problem problem_;  // counts into the outcome
  State& state_;
  State to_, there_;
  bool locates_;
  Decision last_;                  // why the step that is tried again was refused
  double dt_ = 0.0, whole_ = 0.0;  // the step, and as it was before it was shortened [s]
  double to_the_end_ = 0.0;        // the step that ends the run; not a number: the next one does not [s]
  std::optional<Stop> stop_;       // the jump or the event at which the step that stands ends
  long at_once_ = 0;               // located steps in a row that passed no time, where no watch counts them
};

}  // namespace

void refuse_tolerance_of_sweeps() {
  throw std::invalid_argument(
      "run: a TOL bounds what the sweeps of a step leave, and this scheme makes none: leave it out, or take a scheme "
      "that sweeps");
}

Outcome run(const Task& task) {
  validate_run(task.problem.traits(), task.state, task.t_end);
  task.control_can.validate(task.control);
  return Run(task).go();
}

}  // namespace detail

}  // namespace particulate::schemes
