#include <particulate/reference/detail/arkode.hpp>

#include <algorithm>

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_butcher_dirk.h>
#include <arkode/arkode_butcher_erk.h>

#include <particulate/schemes/integrate.hpp>

// From SUNDIALS 7.1 on the functions that all steppers of ARKODE share have one name; the old ones are deprecated.
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 1)
#define PARTICULATE_ARK(function) ARKode##function
#else
#define PARTICULATE_ARK(function) ARKStep##function
#endif

namespace particulate::reference::detail {

namespace {

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

struct Pair {
  ARKODE_DIRKTableID implicit_half;
  ARKODE_ERKTableID explicit_half;
};

Pair ids(AdditiveTable table) {
  switch (table) {
    case AdditiveTable::ark324l2sa_4_2_3:
      return {ARKODE_ARK324L2SA_DIRK_4_2_3, ARKODE_ARK324L2SA_ERK_4_2_3};
    case AdditiveTable::ark436l2sa_6_3_4:
      return {ARKODE_ARK436L2SA_DIRK_6_3_4, ARKODE_ARK436L2SA_ERK_6_3_4};
    case AdditiveTable::ark437l2sa_7_3_4:
      return {ARKODE_ARK437L2SA_DIRK_7_3_4, ARKODE_ARK437L2SA_ERK_7_3_4};
    case AdditiveTable::ark548l2sa_8_4_5:
      return {ARKODE_ARK548L2SA_DIRK_8_4_5, ARKODE_ARK548L2SA_ERK_8_4_5};
    case AdditiveTable::ark548l2sab_8_4_5:
      return {ARKODE_ARK548L2SAb_DIRK_8_4_5, ARKODE_ARK548L2SAb_ERK_8_4_5};
  }
  return {ARKODE_DIRK_NONE, ARKODE_ERK_NONE};
}

long right_hand_sides(void* m) {
  long of_explicit = 0, of_implicit = 0;
  // From SUNDIALS 7.2 on asked for by the number of the part.
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 2)
  check(ARKodeGetNumRhsEvals(m, 0, &of_explicit), "ARKodeGetNumRhsEvals");
  check(ARKodeGetNumRhsEvals(m, 1, &of_implicit), "ARKodeGetNumRhsEvals");
#else
  check(ARKStepGetNumRhsEvals(m, &of_explicit, &of_implicit), "ARKStepGetNumRhsEvals");
#endif
  return of_explicit + of_implicit;
}

}  // namespace

void free_arkode(void* memory) { PARTICULATE_ARK(Free)(&memory); }

Arkode::Arkode(const ExplicitRungeKutta& method, Callback& callback, double t, N_Vector y, SUNContext context)
    : explicit_part_(evaluate),
      implicit_part_(nullptr),
      fixed_step_(method.fixed_step),
      first_step_(method.first_step),
      callback_(&callback),
      memory_(made(ARKStepCreate(explicit_part_, implicit_part_, t, y, context), "ARKStepCreate")) {
  begin(method);
  check(ARKStepSetTableNum(memory_.get(), ARKODE_DIRK_NONE, id(method.table)), "ARKStepSetTableNum");
}

// The pair is named by both its halves: asked for by its order alone, SUNDIALS 6.4 takes another one for order 2.
Arkode::Arkode(const ImplicitExplicit& method, Callback& callback, double t, N_Vector y, SUNContext context)
    : explicit_part_(evaluate_slow),
      implicit_part_(evaluate_fast),
      fixed_step_(method.fixed_step),
      first_step_(method.first_step),
      callback_(&callback),
      linear_(linear_solver(DenseJacobian{}, y, context)),
      memory_(made(ARKStepCreate(explicit_part_, implicit_part_, t, y, context), "ARKStepCreate")) {
  begin(method);
  void* const m = memory_.get();
  const Pair pair = ids(method.table);
  check(ARKStepSetTableNum(m, pair.implicit_half, pair.explicit_half), "ARKStepSetTableNum");
  check(PARTICULATE_ARK(SetLinearSolver)(m, linear_.solver.get(), linear_.matrix.get()), "ARKStepSetLinearSolver");
  // A fixed step cannot shrink, and from the state before it the default of three does not lead to tight tolerances.
  check(PARTICULATE_ARK(SetMaxNonlinIters)(m, 10), "ARKStepSetMaxNonlinIters");
  // A step too large may leave a stiff solution so far off that seven smaller ones, the default, do not bring it back.
  check(PARTICULATE_ARK(SetMaxErrTestFails)(m, 30), "ARKStepSetMaxErrTestFails");
}

template <class Settings>
void Arkode::begin(const Settings& method) {
  void* const m = memory_.get();
#if SUNDIALS_VERSION_MAJOR < 7
  check(ARKStepSetErrFile(m, nullptr), "ARKStepSetErrFile");
#endif
  check(PARTICULATE_ARK(SetUserData)(m, callback_), "ARKStepSetUserData");
  check(PARTICULATE_ARK(SStolerances)(m, method.relative, method.absolute), "ARKStepSStolerances");
  // The default, Hermite's interpolant, would cost a right-hand side at the end of every step. Nothing here
  // interpolates.
  check(PARTICULATE_ARK(SetInterpolantType)(m, ARK_INTERP_LAGRANGE), "ARKStepSetInterpolantType");
  check(PARTICULATE_ARK(SetInterpolantDegree)(m, 1), "ARKStepSetInterpolantDegree");
  if (!method.fixed_step) {
    check(PARTICULATE_ARK(SetInitStep)(m, method.first_step.value_or(0.0)), "ARKStepSetInitStep");
    check(PARTICULATE_ARK(SetMaxStep)(m, method.largest_step.value_or(0.0)), "ARKStepSetMaxStep");
  }
}

void Arkode::restart(double t, N_Vector y) {
  check(ARKStepReInit(memory_.get(), explicit_part_, implicit_part_, t, y), "ARKStepReInit");
  if (!fixed_step_) {
    check(PARTICULATE_ARK(SetInitStep)(memory_.get(), first_step_.value_or(0.0)), "ARKStepSetInitStep");
  }
}

void Arkode::stop_at(double t_end) {
  check(PARTICULATE_ARK(SetStopTime)(memory_.get(), t_end), "ARKStepSetStopTime");
  fixed_steps_ = 0;
}

int Arkode::step(const Flat& from, double t_end, N_Vector y, double& t) {
  return fixed_step_ ? fixed_step(t_end - from.t, t_end, y, t) : adapted_step(from, t_end, y, t);
}

Counts Arkode::counts() const {
  void* const m = memory_.get();
  Counts is;
  check(PARTICULATE_ARK(GetNumSteps)(m, &is.steps), "ARKStepGetNumSteps");
  check(PARTICULATE_ARK(GetNumErrTestFails)(m, &is.rejections), "ARKStepGetNumErrTestFails");
  is.rejections += retries_;
  is.evaluations = right_hand_sides(m);
  if (!linear_.solver) return is;
  long unsolved = 0, by_quotients = 0;
  check(PARTICULATE_ARK(GetNumStepSolveFails)(m, &unsolved), "ARKStepGetNumStepSolveFails");
  check(PARTICULATE_ARK(GetNumNonlinSolvIters)(m, &is.sweeps), "ARKStepGetNumNonlinSolvIters");
  check(PARTICULATE_ARK(GetNumLinRhsEvals)(m, &by_quotients), "ARKStepGetNumLinRhsEvals");
  is.rejections += unsolved;
  // Counted apart; a new start resets this count no sooner than with its first right-hand side.
  if (is.evaluations > 0) is.evaluations += by_quotients;
  return is;
}

std::string Arkode::name_of(int flag) { return owned(PARTICULATE_ARK(GetReturnFlagName)(flag)); }

int Arkode::evolve(double t_end, N_Vector y, double& t) {
  return PARTICULATE_ARK(Evolve)(memory_.get(), t_end, y, &t, ARK_ONE_STEP);
}

// As in schemes::integrate(), so that n steps of 1/n are n steps: ARKODE alone adds one of the size of its rounding.
int Arkode::fixed_step(double left, double t_end, N_Vector y, double& t) {
  const double rounding = schemes::rounding_of_time(fixed_steps_++, t_end - left, t_end);
  const double dt = schemes::step_towards_end(*fixed_step_, left, rounding);
  check(PARTICULATE_ARK(SetFixedStep)(memory_.get(), dt), "ARKStepSetFixedStep");
  return evolve(t_end, y, t);
}

// A step of ARKODE ends for good where the explicit part of a stage has no value. It is tried again, four times smaller
// each time, until it is too small to change the time.
int Arkode::adapted_step(const Flat& from, double t_end, N_Vector y, double& t) {
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
double Arkode::tried(double left) const {
  double dt = 0.0;
  check(PARTICULATE_ARK(GetCurrentStep)(memory_.get(), &dt), "ARKStepGetCurrentStep");
  return dt > 0.0 ? std::min(dt, left) : left;
}

void Arkode::begin_again(const Flat& from, N_Vector y, double dt) {
  Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(y), from.x.size()) = from.x;
  check(PARTICULATE_ARK(Reset)(memory_.get(), from.t, y), "ARKStepReset");
  check(PARTICULATE_ARK(SetInitStep)(memory_.get(), dt), "ARKStepSetInitStep");
}

}  // namespace particulate::reference::detail
