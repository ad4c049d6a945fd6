#include <particulate/reference/integrator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <sundials/sundials_context.hpp>

#include <particulate/reference/detail/arkode.hpp>
#include <particulate/reference/detail/callback.hpp>
#include <particulate/reference/detail/cvode.hpp>
#include <particulate/reference/detail/handles.hpp>
#include <particulate/reference/detail/stepper.hpp>
#include <particulate/schemes/integrate.hpp>

namespace particulate::reference {

namespace {

using schemes::Outcome;
using schemes::State;
using schemes::Status;

// What a flag means and what to do. CVODE and ARKODE share these numbers.
std::string_view meaning(int flag) {
  switch (flag) {
    case CV_TOO_MUCH_ACC:
      return "the tolerances ask for more digits than a double has; enlarge relative or absolute";
    case CV_ERR_FAILURE:
      return "no step is small enough for the tolerances, the solution is not smooth here; stop before this time, or "
             "enlarge the tolerances";
    case CV_CONV_FAILURE:
      return "the iteration for the new state does not converge at any step; stop before this time, take smaller fixed "
             "steps, or, if the problem is stiff here, a method that is made for that: Bdf or ImplicitExplicit";
    case CV_FIRST_RHSFUNC_ERR:
    case CV_REPTD_RHSFUNC_ERR:
    case CV_UNREC_RHSFUNC_ERR:
    case CV_RHSFUNC_FAIL:
      return "no step leads on from here to where the problem has a value; stop before this time, or take smaller "
             "steps up to it";
    case CV_RTFUNC_FAIL:
      return "an event function has no finite value; write one for every state that the solution may come near";
    case CV_ILL_INPUT:
    case CV_TOO_CLOSE:
      return "SUNDIALS refuses the times of this advance; choose an end further from the start";
    default:
      return "see the SUNDIALS manual under this name";
  }
}

// In the order of Method.
constexpr std::array kinds{"Adams", "explicit Runge-Kutta", "BDF", "implicit-explicit Runge-Kutta"};
static_assert(kinds.size() == std::variant_size_v<Method>);

// What a method needs of the problem, its size and its events.
void validate_match(const schemes::Problem& problem, const State& start, const Method& method, const Events& events) {
  const Eigen::Index n = start.r.size() + start.v.size() + start.y.size();
  const auto* const bdf = std::get_if<Bdf>(&method);
  const bool of_cvode = bdf || std::holds_alternative<Adams>(method);
  if (!events.empty() && !(of_cvode && n > 0)) {
    throw std::invalid_argument(
        fmt::format("integrator: events need the Adams or BDF methods and at least one unknown, got {} and {} unknowns",
                    kinds.at(method.index()), n));
  }
  if (std::holds_alternative<ImplicitExplicit>(method) && !(problem.splits() && !problem.traits().motion)) {
    throw std::invalid_argument(
        "integrator: an implicit-explicit method needs a first-order problem in two parts, got one that does not "
        "split; give it rate_slow and rate_fast, or take Bdf");
  }
  const auto* const band = bdf ? std::get_if<BandedJacobian>(&bdf->jacobian) : nullptr;
  if (band && n > 0 && (band->lower >= n || band->upper >= n)) {
    throw std::invalid_argument(
        fmt::format("integrator: the half-bandwidths must be below the number of unknowns, {}, got lower {} and upper "
                    "{}; choose narrower ones, or DenseJacobian",
                    n, band->lower, band->upper));
  }
}

}  // namespace

struct Integrator::Machinery {
  sundials::Context context;
  detail::Callback callback;
  detail::Flat last;      // the last accepted state: what SUNDIALS leaves of a failing step does not touch it
  Eigen::VectorXd x;      // what SUNDIALS writes a step's end to
  detail::Vector vector;  // x, as SUNDIALS sees it
  std::variant<detail::NothingToSolve, detail::Cvode, detail::Arkode> memory;
  long max_steps = 0;
  bool stands_at_last = true;  // false: SUNDIALS must start afresh before it goes on
  std::vector<Hit> hits;       // events that ended the last advance

  Machinery(const schemes::Problem& problem, const State& start, const Method& method, const Events& events)
      : callback{.problem = problem,
                 .at = start,
                 .events = events,
                 .residue = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(events.size())),
                 .armed = std::vector<bool>(events.size(), false)},
        last{.t = start.t, .x = flat(start)},
        x(last.x) {
    std::visit([this](const auto& settings) { max_steps = settings.max_steps; }, method);
    if (x.size() == 0) return;
#if SUNDIALS_VERSION_MAJOR >= 7
    SUNContext_ClearErrHandlers(context);
    // What it warns of, a step too small to change the time, is said in the outcome.
    SUNLogger logger = nullptr;
    detail::check(SUNContext_GetLogger(context, &logger), "SUNContext_GetLogger");
    detail::check(SUNLogger_SetWarningFilename(logger, "/dev/null"), "SUNLogger_SetWarningFilename");
#endif
    vector.reset(detail::made(N_VMake_Serial(x.size(), x.data(), context), "N_VMake_Serial"));
    std::visit(
        [this](const auto& settings) {
          using Memory = std::conditional_t<std::is_constructible_v<detail::Cvode, decltype(settings),
                                                                    detail::Callback&, double, N_Vector, SUNContext>,
                                            detail::Cvode, detail::Arkode>;
          memory.emplace<Memory>(settings, callback, last.t, vector.get(), context);
        },
        method);
  }

  void start_at(const State& state) {
    Eigen::VectorXd given = flat(state);
    if (stands_at_last && state.t == last.t && given == last.x) return;
    last = {.t = state.t, .x = std::move(given)};
    x = last.x;
    callback.armed.assign(callback.armed.size(), false);
    std::visit([this](auto& solver) { solver.restart(last.t, vector.get()); }, memory);
    stands_at_last = true;
  }

  // Steps until t_end or until it goes no further.
  template <class Memory>
  Outcome run(Memory& solver, double t_end) {
    const detail::Counts before = solver.counts();
    const long evaluations_before = callback.evaluations;
    std::string reason = last.t < t_end ? head_for(solver, t_end) : "";
    hits.clear();
    for (long n = 0; last.t < t_end && reason.empty() && hits.empty(); ++n) {
      reason = n < max_steps ? step(solver, t_end)
                             : fmt::format(
                                   "max_steps = {} were not enough to get beyond t = {} s; allow more, or widen "
                                   "the tolerances or the fixed step",
                                   max_steps, last.t);
    }
    const detail::Counts after = solver.counts();
    Outcome out;
    out.status = !hits.empty() ? Status::stopped : reason.empty() ? Status::reached : Status::failed;
    out.reason = hits.empty() ? std::move(reason) : what_happened();
    out.t = last.t;
    out.steps = after.steps - before.steps;
    out.rejections = after.rejections - before.rejections;
    out.sweeps = after.sweeps - before.sweeps;
    out.evaluations = callback.evaluations - evaluations_before;
    return out;
  }

  // Both libraries refuse a leg that is shorter than the rounding of its ends.
  template <class Memory>
  std::string head_for(Memory& solver, double t_end) {
    const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(last.t), std::abs(t_end));
    if (!(t_end - last.t > rounding)) {
      return fmt::format(
          "the end {} s lies within rounding of the state's time {} s; choose an end more than {} s later", t_end,
          last.t, rounding);
    }
    solver.stop_at(t_end);
    return {};
  }

  // One accepted step; returns why there is none.
  template <class Memory>
  std::string step(Memory& solver, double t_end) {
    stands_at_last = false;
    callback.no_value_at.reset();
    callback.no_jacobian_at.reset();
    callback.no_event_at.reset();
    double t = last.t;
    const int flag = solver.step(last, t_end, vector.get(), t);
    if (callback.thrown) std::rethrow_exception(std::exchange(callback.thrown, nullptr));
    if (flag < 0) return stuck(fmt::format("{}: {}", Memory::name_of(flag), meaning(flag)));
    if (flag == CV_ROOT_RETURN) return stop_at_event(solver, t);
    if (!(t > last.t)) {
      return stuck(
          "the step became too small to change the time: t + Dt = t; stop before this time, where the solution or "
          "its right-hand side is not smooth");
    }
    if (!x.allFinite()) return stuck("the step led to a value that is not finite; stop before, or take smaller steps");
    last.t = t;
    last.x = x;
    stands_at_last = true;
    return {};
  }

  // The state is interpolated and SUNDIALS itself is beyond it: whatever the caller makes of it, the next advance
  // starts afresh.
  template <class Memory>
  std::string stop_at_event(const Memory& solver, double t) {
    last.t = t;
    last.x = x;
    hits = solver.hits();
    callback.at.t = t;
    unflatten(x, callback.at);
    Eigen::VectorXd here(callback.residue.size());
    for (Eigen::Index k = 0; k < here.size(); ++k) {
      here[k] = std::abs(callback.events[static_cast<std::size_t>(k)].function(callback.at));
    }
    callback.residue = (here.array() <= callback.residue.array()).select(callback.residue, 0.0);
    for (Hit& hit : hits) {
      hit.t = t;
      const auto k = static_cast<Eigen::Index>(hit.event);
      callback.residue[k] = 2.0 * here[k];
    }
    return {};
  }

  std::string what_happened() const {
    std::string all;
    for (const Hit& hit : hits) all += (all.empty() ? "" : ", ") + describe(callback.events, hit);
    return all;
  }

  std::string stuck(std::string_view why) const {
    std::string asked;
    if (callback.no_value_at) {
      asked = fmt::format("; the problem had no finite value at t = {} s", *callback.no_value_at);
    }
    if (callback.no_jacobian_at) {
      asked += fmt::format("; its Jacobian was not finite at t = {} s", *callback.no_jacobian_at);
    }
    if (callback.no_event_at) {
      asked += fmt::format("; an event function had no finite value at t = {} s", *callback.no_event_at);
    }
    return fmt::format("at t = {} s: {}{}", last.t, why, asked);
  }
};

Integrator::Integrator(const schemes::Problem& problem, const State& start, const Method& method,
                       const Events& events) {
  std::visit([](const auto& settings) { validate(settings); }, method);
  validate(events);
  schemes::validate_run(problem.traits(), start, start.t);
  validate_match(problem, start, method, events);
  machinery_ = std::make_unique<Machinery>(problem, start, method, events);
}

Integrator::Integrator(Integrator&&) noexcept = default;
Integrator& Integrator::operator=(Integrator&&) noexcept = default;
Integrator::~Integrator() = default;

Outcome Integrator::advance(State& state, double t_end) {
  Machinery& at = *machinery_;
  schemes::validate_run(at.callback.problem.traits(), state, t_end);
  if (state.r.size() != at.callback.at.r.size() || state.y.size() != at.callback.at.y.size()) {
    throw std::invalid_argument(
        fmt::format("integrator: the state must keep the {} unknowns that the integrator was made for, got {}",
                    at.last.x.size(), flat(state).size()));
  }
  at.start_at(state);
  Outcome out = std::visit([&](auto& solver) { return at.run(solver, t_end); }, at.memory);
  state.t = at.last.t;
  state.t_carry = 0.0;
  unflatten(at.last.x, state);
  return out;
}

const std::vector<Hit>& Integrator::hits() const { return machinery_->hits; }

std::array<int, 2> sundials_version() {
  std::array<int, 2> version{};
  int patch = 0;
  std::array<char, 32> label{};
  detail::check(
      SUNDIALSGetVersionNumber(&version[0], &version[1], &patch, label.data(), static_cast<int>(label.size())),
      "SUNDIALSGetVersionNumber");
  return version;
}

Outcome integrate(const schemes::Problem& problem, State& state, double t_end, const Method& method) {
  return Integrator(problem, state, method).advance(state, t_end);
}

long Integrator::evaluations_by_sundials() const {
  return std::visit([](const auto& solver) { return solver.counts().evaluations; }, machinery_->memory);
}

}  // namespace particulate::reference
