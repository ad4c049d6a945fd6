#include <particulate/reference/integrator.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_butcher_erk.h>
#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <sundials/sundials_context.hpp>

#include <particulate/schemes/integrate.hpp>

// From SUNDIALS 7.1 on the functions that all steppers of ARKODE share have one name; the old ones are deprecated.
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 1)
#define PARTICULATE_ARK(function) ARKode##function
#else
#define PARTICULATE_ARK(function) ARKStep##function
#endif

namespace particulate::reference {

namespace {

using schemes::Outcome;
using schemes::Status;
using schemes::Values;

// What SUNDIALS hands back to its callback. It sees only C: exceptions wait here until the call has returned.
struct Callback {
  Rate rate;
  long evaluations = 0;
  std::exception_ptr thrown;
  std::optional<double> no_value_at;  // where the step being tried was last told so
  Events events;
  std::optional<double> no_event_at;  // where an event function was not finite
  Eigen::VectorXd residue;            // how far from zero each function may still stand on an event that has stopped
  std::vector<bool> armed;            // whether it has been farther away since the method last started afresh
};

// Returns 0, +1 for "no value here, try a smaller step", or -1 for "give up".
int evaluate(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  // The fixed-point solver of SUNDIALS 6 takes -1 for a lack of convergence and asks again: it gets no further.
  if (callback.thrown) return -1;
  try {
    const auto size = static_cast<Eigen::Index>(N_VGetLength(y));
    const Eigen::Map<const Eigen::VectorXd> in(N_VGetArrayPointer(y), size);
    Eigen::Map<Eigen::VectorXd> out(N_VGetArrayPointer(dy), size);
    ++callback.evaluations;
    if (callback.rate(t, in, out) && out.allFinite()) return 0;
    callback.no_value_at = t;
    return 1;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

// Returns 0, or -1 for "give up". The state at an event is beyond it by rounding, and may pass it again on its way
// back. So a function that has stopped an advance is handed over as an exact zero, which CVODE disregards at a start,
// until it has once been farther away.
int find_events(sunrealtype t, N_Vector y, sunrealtype* g, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  if (callback.thrown) return -1;
  try {
    const Eigen::Map<const Eigen::VectorXd> in(N_VGetArrayPointer(y), static_cast<Eigen::Index>(N_VGetLength(y)));
    Eigen::Map<Eigen::VectorXd> out(g, static_cast<Eigen::Index>(callback.events.directions.size()));
    callback.events.functions(t, in, out);
    if (!out.allFinite()) {
      callback.no_event_at = t;
      return -1;
    }
    for (std::size_t k = 0; k < callback.armed.size(); ++k) {
      if (callback.armed[k]) continue;
      callback.armed[k] = std::abs(g[k]) > callback.residue[static_cast<Eigen::Index>(k)];
      if (!callback.armed[k]) g[k] = 0.0;
    }
    return 0;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

// Settings are validated before they come here, so that what fails now is a lack of memory or a defect of ours.
void check(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(fmt::format("SUNDIALS: {} failed with flag {}", call, flag));
}

template <class Handle>
Handle made(Handle handle, const char* call) {
  if (!handle) throw std::runtime_error(fmt::format("SUNDIALS: {} returned nothing", call));
  return handle;
}

template <auto free>
struct Freed {
  template <class T>
  void operator()(T* handle) const {
    free(handle);
  }
};

void free_cvode(void* memory) { CVodeFree(&memory); }
void free_arkode(void* memory) { PARTICULATE_ARK(Free)(&memory); }

using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Freed<N_VDestroy>>;
using FixedPoint = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Freed<SUNNonlinSolFree>>;

// Both libraries hand their flags' names out as memory of ours.
std::string owned(char* text) {
  const std::unique_ptr<char, Freed<std::free>> owner(text);
  return text;
}

struct Counts {
  long steps = 0, rejections = 0, sweeps = 0, evaluations = 0;
};

// No unknowns: time passes. The norms of SUNDIALS would divide by the number of unknowns.
struct NothingToSolve {
  void restart(double, N_Vector) {}
  void stop_at(double) {}
  static int step(const Values&, double t_end, N_Vector, double& t) {
    t = t_end;
    return CV_SUCCESS;
  }
  static Counts counts() { return {}; }
  static std::vector<Hit> hits() { return {}; }
  static std::string name_of(int flag) { return fmt::format("flag {}", flag); }
};

// CVODE with the Adams methods.
class AdamsMemory {
 public:
  AdamsMemory(const Adams& method, Callback& callback, double t, N_Vector y, SUNContext context)
      : memory_(made(CVodeCreate(CV_ADAMS, context), "CVodeCreate")),
        corrector_(made(SUNNonlinSol_FixedPoint(y, method.anderson, context), "SUNNonlinSol_FixedPoint")) {
    void* const m = memory_.get();
#if SUNDIALS_VERSION_MAJOR < 7
    check(CVodeSetErrFile(m, nullptr), "CVodeSetErrFile");
#endif
    check(CVodeInit(m, evaluate, t, y), "CVodeInit");
    check(CVodeSetUserData(m, &callback), "CVodeSetUserData");
    check(CVodeSStolerances(m, method.relative, method.absolute), "CVodeSStolerances");
    // Without this CVODE would solve for a Newton step, whatever the method.
    check(CVodeSetNonlinearSolver(m, corrector_.get()), "CVodeSetNonlinearSolver");
    check(CVodeSetMaxOrd(m, method.max_order), "CVodeSetMaxOrd");
    check(CVodeSetInitStep(m, method.first_step.value_or(0.0)), "CVodeSetInitStep");
    check(CVodeSetMaxStep(m, method.largest_step.value_or(0.0)), "CVodeSetMaxStep");
    watch_for(callback.events);
  }

  void restart(double t, N_Vector y) { check(CVodeReInit(memory_.get(), t, y), "CVodeReInit"); }
  void stop_at(double t_end) { check(CVodeSetStopTime(memory_.get(), t_end), "CVodeSetStopTime"); }
  int step(const Values&, double t_end, N_Vector y, double& t) {
    return CVode(memory_.get(), t_end, y, &t, CV_ONE_STEP);
  }
  Counts counts() const {
    void* const m = memory_.get();
    long failed_tests = 0, unconverged = 0;
    Counts is;
    check(CVodeGetNumSteps(m, &is.steps), "CVodeGetNumSteps");
    check(CVodeGetNumErrTestFails(m, &failed_tests), "CVodeGetNumErrTestFails");
    check(CVodeGetNumNonlinSolvConvFails(m, &unconverged), "CVodeGetNumNonlinSolvConvFails");
    check(CVodeGetNumNonlinSolvIters(m, &is.sweeps), "CVodeGetNumNonlinSolvIters");
    check(CVodeGetNumRhsEvals(m, &is.evaluations), "CVodeGetNumRhsEvals");
    is.rejections = failed_tests + unconverged;
    return is;
  }
  std::vector<Hit> hits() const {
    std::vector<int> found(events_);
    check(CVodeGetRootInfo(memory_.get(), found.data()), "CVodeGetRootInfo");
    std::vector<Hit> all;
    for (std::size_t k = 0; k < events_; ++k) {
      if (found[k] != 0) all.push_back({.event = k, .crossing = static_cast<Direction>(found[k])});
    }
    return all;
  }
  static std::string name_of(int flag) { return owned(CVodeGetReturnFlagName(flag)); }

 private:
  void watch_for(const Events& events) {
    events_ = events.directions.size();
    if (events_ == 0) return;
    void* const m = memory_.get();
    std::vector<int> directions;
    for (const Direction direction : events.directions) directions.push_back(static_cast<int>(direction));
    check(CVodeRootInit(m, static_cast<int>(events_), find_events), "CVodeRootInit");
    check(CVodeSetRootDirection(m, directions.data()), "CVodeSetRootDirection");
    check(CVodeSetNoInactiveRootWarn(m), "CVodeSetNoInactiveRootWarn");
  }

  std::unique_ptr<void, Freed<free_cvode>> memory_;
  FixedPoint corrector_;
  std::size_t events_ = 0;
};

ARKODE_ERKTableID id(Table table) {
  switch (table) {
    case Table::heun_euler_2_1_2:
      return ARKODE_HEUN_EULER_2_1_2;
    case Table::bogacki_shampine_4_2_3:
      return ARKODE_BOGACKI_SHAMPINE_4_2_3;
    case Table::ark324l2sa_erk_4_2_3:
      return ARKODE_ARK324L2SA_ERK_4_2_3;
    case Table::zonneveld_5_3_4:
      return ARKODE_ZONNEVELD_5_3_4;
    case Table::ark436l2sa_erk_6_3_4:
      return ARKODE_ARK436L2SA_ERK_6_3_4;
    case Table::sayfy_aburub_6_3_4:
      return ARKODE_SAYFY_ABURUB_6_3_4;
    case Table::cash_karp_6_4_5:
      return ARKODE_CASH_KARP_6_4_5;
    case Table::fehlberg_6_4_5:
      return ARKODE_FEHLBERG_6_4_5;
    case Table::dormand_prince_7_4_5:
      return ARKODE_DORMAND_PRINCE_7_4_5;
    case Table::ark548l2sa_erk_8_4_5:
      return ARKODE_ARK548L2SA_ERK_8_4_5;
    case Table::verner_8_5_6:
      return ARKODE_VERNER_8_5_6;
    case Table::fehlberg_13_7_8:
      return ARKODE_FEHLBERG_13_7_8;
    case Table::knoth_wolke_3_3:
      return ARKODE_KNOTH_WOLKE_3_3;
    case Table::ark437l2sa_erk_7_3_4:
      return ARKODE_ARK437L2SA_ERK_7_3_4;
    case Table::ark548l2sab_erk_8_4_5:
      return ARKODE_ARK548L2SAb_ERK_8_4_5;
  }
  return ARKODE_ERK_NONE;
}

// ARKODE with an explicit table. Always through ARKStep: ERKStep of SUNDIALS 6.4 takes every table whose last node is 1
// for one whose last stage is the next step's first, and loses half the order of Verner's and of the additive tables.
class ExplicitMemory {
 public:
  ExplicitMemory(const ExplicitRungeKutta& method, Callback& callback, double t, N_Vector y, SUNContext context)
      : method_(method),
        callback_(&callback),
        memory_(made(ARKStepCreate(evaluate, nullptr, t, y, context), "ARKStepCreate")) {
    void* const m = memory_.get();
#if SUNDIALS_VERSION_MAJOR < 7
    check(ARKStepSetErrFile(m, nullptr), "ARKStepSetErrFile");
#endif
    check(PARTICULATE_ARK(SetUserData)(m, &callback), "ARKStepSetUserData");
    check(PARTICULATE_ARK(SStolerances)(m, method.relative, method.absolute), "ARKStepSStolerances");
    check(ARKStepSetTableNum(m, ARKODE_DIRK_NONE, id(method.table)), "ARKStepSetTableNum");
    // The default, Hermite's interpolant, would cost a right-hand side at the end of every step. Nothing here
    // interpolates.
    check(PARTICULATE_ARK(SetInterpolantType)(m, ARK_INTERP_LAGRANGE), "ARKStepSetInterpolantType");
    check(PARTICULATE_ARK(SetInterpolantDegree)(m, 1), "ARKStepSetInterpolantDegree");
    if (!method.fixed_step) {
      check(PARTICULATE_ARK(SetInitStep)(m, method.first_step.value_or(0.0)), "ARKStepSetInitStep");
      check(PARTICULATE_ARK(SetMaxStep)(m, method.largest_step.value_or(0.0)), "ARKStepSetMaxStep");
    }
  }

  void restart(double t, N_Vector y) {
    check(ARKStepReInit(memory_.get(), evaluate, nullptr, t, y), "ARKStepReInit");
    if (!method_.fixed_step) {
      check(PARTICULATE_ARK(SetInitStep)(memory_.get(), method_.first_step.value_or(0.0)), "ARKStepSetInitStep");
    }
  }
  void stop_at(double t_end) {
    check(PARTICULATE_ARK(SetStopTime)(memory_.get(), t_end), "ARKStepSetStopTime");
    fixed_steps_ = 0;
  }

  int step(const Values& from, double t_end, N_Vector y, double& t) {
    return method_.fixed_step ? fixed_step(t_end - from.t, t_end, y, t) : adapted_step(from, t_end, y, t);
  }
  Counts counts() const {
    void* const m = memory_.get();
    Counts is;
    check(PARTICULATE_ARK(GetNumSteps)(m, &is.steps), "ARKStepGetNumSteps");
    check(PARTICULATE_ARK(GetNumErrTestFails)(m, &is.rejections), "ARKStepGetNumErrTestFails");
    is.rejections += retries_;
    // One count for explicit evaluations, from SUNDIALS 7.2 on asked for by the number of the part.
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 2)
    check(ARKodeGetNumRhsEvals(m, 0, &is.evaluations), "ARKodeGetNumRhsEvals");
#else
    long implicit = 0;
    check(ARKStepGetNumRhsEvals(m, &is.evaluations, &implicit), "ARKStepGetNumRhsEvals");
#endif
    return is;
  }
  static std::vector<Hit> hits() { return {}; }
  static std::string name_of(int flag) { return owned(PARTICULATE_ARK(GetReturnFlagName)(flag)); }

 private:
  int evolve(double t_end, N_Vector y, double& t) {
    return PARTICULATE_ARK(Evolve)(memory_.get(), t_end, y, &t, ARK_ONE_STEP);
  }

  // As in schemes::integrate(), so that n steps of 1/n are n steps: ARKODE alone adds one of the size of its rounding.
  int fixed_step(double left, double t_end, N_Vector y, double& t) {
    const double rounding = schemes::rounding_of_time(fixed_steps_++, t_end - left, t_end);
    const double dt = schemes::step_towards_end(*method_.fixed_step, left, rounding);
    check(PARTICULATE_ARK(SetFixedStep)(memory_.get(), dt), "ARKStepSetFixedStep");
    return evolve(t_end, y, t);
  }

  // An explicit step of ARKODE ends for good where a stage has no value. It is tried again, four times smaller each
  // time, until it is too small to change the time.
  int adapted_step(const Values& from, double t_end, N_Vector y, double& t) {
    double dt = 0.0;
    for (;;) {
      const int flag = evolve(t_end, y, t);
      if (flag != ARK_UNREC_RHSFUNC_ERR || callback_->thrown) return flag;
      dt = 0.25 * (dt > 0.0 ? dt : tried(t_end - from.t));
      if (!(from.t + dt > from.t)) return flag;
      ++retries_;
      begin_again(from, y, dt);
      stop_at(t_end);
    }
  }

  // The step that ARKODE has just tried, at most what is left.
  double tried(double left) const {
    double dt = 0.0;
    check(PARTICULATE_ARK(GetCurrentStep)(memory_.get(), &dt), "ARKStepGetCurrentStep");
    return dt > 0.0 ? std::min(dt, left) : left;
  }
  void begin_again(const Values& from, N_Vector y, double dt) {
    Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(y), from.y.size()) = from.y;
    check(PARTICULATE_ARK(Reset)(memory_.get(), from.t, y), "ARKStepReset");
    check(PARTICULATE_ARK(SetInitStep)(memory_.get(), dt), "ARKStepSetInitStep");
  }

  ExplicitRungeKutta method_;
  Callback* callback_;
  std::unique_ptr<void, Freed<free_arkode>> memory_;
  long retries_ = 0;      // steps on which the problem had no value, since the method was made
  long fixed_steps_ = 0;  // since the end was set
};

// What a flag means and what to do. CVODE and ARKODE share these numbers.
std::string_view meaning(int flag) {
  switch (flag) {
    case CV_TOO_MUCH_ACC:
      return "the tolerances ask for more digits than a double has; enlarge relative or absolute";
    case CV_ERR_FAILURE:
      return "no step is small enough for the tolerances, the solution is not smooth here; stop before this time, or "
             "enlarge the tolerances";
    case CV_CONV_FAILURE:
      return "the corrector's iteration does not contract at any step; stop before this time, or, if the problem is "
             "stiff "
             "here, take an implicit method that is made for that";
    case CV_FIRST_RHSFUNC_ERR:
    case CV_REPTD_RHSFUNC_ERR:
    case CV_UNREC_RHSFUNC_ERR:
    case CV_RHSFUNC_FAIL:
      return "no step leads on from here to where the problem has a value; stop before this time, or take smaller "
             "steps "
             "up to it";
    case CV_RTFUNC_FAIL:
      return "an event function has no finite value; write one for every state that the solution may come near";
    case CV_ILL_INPUT:
    case CV_TOO_CLOSE:
      return "SUNDIALS refuses the times of this advance; choose an end further from the start";
    default:
      return "see the SUNDIALS manual under this name";
  }
}

}  // namespace

schemes::Values first_order_form(const schemes::Motion& motion) {
  Values form{.t = motion.t, .y = Eigen::VectorXd(motion.r.size() + motion.v.size())};
  form.y << motion.r, motion.v;
  return form;
}

struct Integrator::Machinery {
  sundials::Context context;
  Callback callback;
  Values last;        // the last accepted state: what SUNDIALS leaves of a failing step does not touch it
  Eigen::VectorXd y;  // what SUNDIALS writes a step's end to
  Vector vector;      // y, as SUNDIALS sees it
  std::variant<NothingToSolve, AdamsMemory, ExplicitMemory> memory;
  long max_steps = 0;
  bool stands_at_last = true;  // false: SUNDIALS must start afresh before it goes on
  std::vector<Hit> hits;       // events that ended the last advance

  Machinery(Rate rate, const Values& start, const Method& method, const Events& events)
      : callback{.rate = std::move(rate),
                 .thrown = nullptr,
                 .no_value_at = {},
                 .events = events,
                 .no_event_at = {},
                 .residue = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(events.directions.size())),
                 .armed = std::vector<bool>(events.directions.size(), false)},
        last(start),
        y(start.y) {
    std::visit([this](const auto& settings) { max_steps = settings.max_steps; }, method);
    if (y.size() == 0) return;
#if SUNDIALS_VERSION_MAJOR >= 7
    SUNContext_ClearErrHandlers(context);
#endif
    vector.reset(made(N_VMake_Serial(y.size(), y.data(), context), "N_VMake_Serial"));
    if (const auto* const adams = std::get_if<Adams>(&method)) {
      memory.emplace<AdamsMemory>(*adams, callback, last.t, vector.get(), context);
    } else {
      memory.emplace<ExplicitMemory>(std::get<ExplicitRungeKutta>(method), callback, last.t, vector.get(), context);
    }
  }

  void start_at(const Values& state) {
    if (stands_at_last && state.t == last.t && state.y == last.y) return;
    last = state;
    y = state.y;
    callback.armed.assign(callback.armed.size(), false);
    std::visit([this](auto& solver) { solver.restart(last.t, vector.get()); }, memory);
    stands_at_last = true;
  }

  // Steps until t_end or until it goes no further.
  template <class Memory>
  Outcome run(Memory& solver, double t_end) {
    const Counts before = solver.counts();
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
    const Counts after = solver.counts();
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
    if (!y.allFinite()) return stuck("the step led to a value that is not finite; stop before, or take smaller steps");
    last.t = t;
    last.y = y;
    stands_at_last = true;
    return {};
  }

  // The state is interpolated and SUNDIALS itself is beyond it: whatever the caller makes of it, the next advance
  // starts afresh.
  template <class Memory>
  std::string stop_at_event(const Memory& solver, double t) {
    last.t = t;
    last.y = y;
    hits = solver.hits();
    Eigen::VectorXd here(callback.residue.size());
    callback.events.functions(t, y, here);
    callback.residue = (here.array().abs() <= callback.residue.array()).select(callback.residue, 0.0);
    for (const Hit& hit : hits) {
      const auto k = static_cast<Eigen::Index>(hit.event);
      callback.residue[k] = 2.0 * std::abs(here[k]);
    }
    return {};
  }

  std::string what_happened() const {
    std::string all;
    for (const Hit& hit : hits) {
      all += fmt::format("{}event {} {}", all.empty() ? "" : ", ", hit.event,
                         hit.crossing == Direction::falling ? "falling" : "rising");
    }
    return all;
  }

  std::string stuck(std::string_view why) const {
    std::string asked;
    if (callback.no_value_at) {
      asked = fmt::format("; the problem had no finite value at t = {} s", *callback.no_value_at);
    }
    if (callback.no_event_at) {
      asked += fmt::format("; an event function had no finite value at t = {} s", *callback.no_event_at);
    }
    return fmt::format("at t = {} s: {}{}", last.t, why, asked);
  }
};

Integrator::Integrator(Rate rate, const Values& start, const Method& method, const Events& events) {
  std::visit([](const auto& settings) { validate(settings); }, method);
  validate(events);
  schemes::validate_run(start, start.t);
  if (!events.directions.empty() && !(std::holds_alternative<Adams>(method) && start.y.size() > 0)) {
    throw std::invalid_argument(
        fmt::format("integrator: events need the Adams methods and at least one unknown, got {} and {} unknowns",
                    std::holds_alternative<Adams>(method) ? "Adams" : "explicit Runge-Kutta", start.y.size()));
  }
  machinery_ = std::make_unique<Machinery>(std::move(rate), start, method, events);
}

Integrator::Integrator(Integrator&&) noexcept = default;
Integrator& Integrator::operator=(Integrator&&) noexcept = default;
Integrator::~Integrator() = default;

Values Integrator::checked_form(const schemes::Motion& start) {
  schemes::validate_run(start, start.t);
  return first_order_form(start);
}

Outcome Integrator::advance(Values& state, double t_end) {
  schemes::validate_run(state, t_end);
  Machinery& at = *machinery_;
  if (state.y.size() != at.last.y.size()) {
    throw std::invalid_argument(
        fmt::format("integrator: the state must keep the {} unknowns that the integrator was made for, got {}",
                    at.last.y.size(), state.y.size()));
  }
  at.start_at(state);
  Outcome out = std::visit([&](auto& solver) { return at.run(solver, t_end); }, at.memory);
  state = at.last;
  return out;
}

Outcome Integrator::advance(schemes::Motion& state, double t_end) {
  schemes::validate_run(state, t_end);
  Values form = first_order_form(state);
  Outcome out = advance(form, t_end);
  state.t = form.t;
  state.v = form.y.tail(state.v.size());
  state.r = form.y.head(state.r.size());
  return out;
}

const std::vector<Hit>& Integrator::hits() const { return machinery_->hits; }

long Integrator::evaluations_by_sundials() const {
  return std::visit([](const auto& solver) { return solver.counts().evaluations; }, machinery_->memory);
}

}  // namespace particulate::reference
