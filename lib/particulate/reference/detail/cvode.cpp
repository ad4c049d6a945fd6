#include <particulate/reference/detail/cvode.hpp>

#include <variant>

#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

namespace particulate::reference::detail {

void free_cvode(void* memory) { CVodeFree(&memory); }

Cvode::Cvode(const Adams& method, Callback& callback, double t, N_Vector y, SUNContext context)
    : corrector_(made(SUNNonlinSol_FixedPoint(y, method.anderson, context), "SUNNonlinSol_FixedPoint")),
      memory_(made(CVodeCreate(CV_ADAMS, context), "CVodeCreate")) {
  begin(method, callback, t, y);
  // Without this CVODE would solve for a Newton step, whatever the method.
  check(CVodeSetNonlinearSolver(memory_.get(), corrector_.get()), "CVodeSetNonlinearSolver");
}

Cvode::Cvode(const Bdf& method, Callback& callback, double t, N_Vector y, SUNContext context)
    : linear_(std::visit([&](const auto& form) { return linear_solver(form, y, context); }, method.jacobian)),
      memory_(made(CVodeCreate(CV_BDF, context), "CVodeCreate")) {
  begin(method, callback, t, y);
  check(CVodeSetLinearSolver(memory_.get(), linear_.solver.get(), linear_.matrix.get()), "CVodeSetLinearSolver");
  // Otherwise difference quotients; for a band always: a full matrix would cost more than the few that it saves.
  if (std::holds_alternative<DenseJacobian>(method.jacobian) && has_jacobian(callback.problem)) {
    check(CVodeSetJacFn(memory_.get(), fill_jacobian), "CVodeSetJacFn");
  }
}

template <class Settings>
void Cvode::begin(const Settings& method, Callback& callback, double t, N_Vector y) {
  void* const m = memory_.get();
#if SUNDIALS_VERSION_MAJOR < 7
  check(CVodeSetErrFile(m, nullptr), "CVodeSetErrFile");
#endif
  check(CVodeInit(m, evaluate, t, y), "CVodeInit");
  check(CVodeSetUserData(m, &callback), "CVodeSetUserData");
  check(CVodeSStolerances(m, method.relative, method.absolute), "CVodeSStolerances");
  check(CVodeSetMaxOrd(m, method.max_order), "CVodeSetMaxOrd");
  check(CVodeSetInitStep(m, method.first_step.value_or(0.0)), "CVodeSetInitStep");
  check(CVodeSetMaxStep(m, method.largest_step.value_or(0.0)), "CVodeSetMaxStep");
  watch_for(callback.events);
}

void Cvode::watch_for(const Events& events) {
  events_ = events.size();
  if (events_ == 0) return;
  void* const m = memory_.get();
  std::vector<int> directions;
  for (const Event& event : events) directions.push_back(static_cast<int>(event.direction));
  check(CVodeRootInit(m, static_cast<int>(events_), find_events), "CVodeRootInit");
  check(CVodeSetRootDirection(m, directions.data()), "CVodeSetRootDirection");
  check(CVodeSetNoInactiveRootWarn(m), "CVodeSetNoInactiveRootWarn");
}

void Cvode::restart(double t, N_Vector y) { check(CVodeReInit(memory_.get(), t, y), "CVodeReInit"); }

void Cvode::stop_at(double t_end) { check(CVodeSetStopTime(memory_.get(), t_end), "CVodeSetStopTime"); }

int Cvode::step(const Flat&, double t_end, N_Vector y, double& t) {
  return CVode(memory_.get(), t_end, y, &t, CV_ONE_STEP);
}

Counts Cvode::counts() const {
  void* const m = memory_.get();
  long failed_tests = 0, unsolved = 0, by_quotients = 0;
  Counts is;
  check(CVodeGetNumSteps(m, &is.steps), "CVodeGetNumSteps");
  check(CVodeGetNumErrTestFails(m, &failed_tests), "CVodeGetNumErrTestFails");
  check(CVodeGetNumStepSolveFails(m, &unsolved), "CVodeGetNumStepSolveFails");
  check(CVodeGetNumNonlinSolvIters(m, &is.sweeps), "CVodeGetNumNonlinSolvIters");
  check(CVodeGetNumRhsEvals(m, &is.evaluations), "CVodeGetNumRhsEvals");
  is.rejections = failed_tests + unsolved;
  // Counted apart; a new start resets this count no sooner than with its first right-hand side.
  if (linear_.solver) check(CVodeGetNumLinRhsEvals(m, &by_quotients), "CVodeGetNumLinRhsEvals");
  if (is.evaluations > 0) is.evaluations += by_quotients;
  return is;
}

std::vector<Hit> Cvode::hits() const {
  std::vector<int> found(events_);
  check(CVodeGetRootInfo(memory_.get(), found.data()), "CVodeGetRootInfo");
  std::vector<Hit> all;
  for (std::size_t k = 0; k < events_; ++k) {
    if (found[k] != 0) all.push_back({.event = k, .crossing = static_cast<Direction>(found[k])});
  }
  return all;
}

std::string Cvode::name_of(int flag) { return owned(CVodeGetReturnFlagName(flag)); }

}  // namespace particulate::reference::detail
