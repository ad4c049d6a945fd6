#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <particulate/reference/detail/callback.hpp>
#include <particulate/reference/detail/handles.hpp>
#include <particulate/reference/detail/stepper.hpp>
#include <particulate/reference/method.hpp>

/// @file
/// ARKODE: the Runge-Kutta methods.

namespace particulate::reference::detail {

void free_arkode(void* memory);

/// ARKODE with an explicit table, or with an additive pair and Newton's method.
///
/// Always through ARKStep: ERKStep of SUNDIALS 6.4 takes every table whose last node is 1 for one whose last stage is
/// the next step's first, and loses half the order of Verner's and of the additive tables.
class Arkode {
 public:
  Arkode(const ExplicitRungeKutta& method, Callback& callback, double t, N_Vector y, SUNContext context);
  Arkode(const ImplicitExplicit& method, Callback& callback, double t, N_Vector y, SUNContext context);

  void restart(double t, N_Vector y);
  void stop_at(double t_end);
  int step(const Flat& from, double t_end, N_Vector y, double& t);
  Counts counts() const;
  static std::vector<Hit> hits() { return {}; }
  static std::string name_of(int flag);

 private:
  using Evaluate = int (*)(sunrealtype t, N_Vector y, N_Vector dy, void* data);

  template <class Settings>
  void begin(const Settings& method);
  int evolve(double t_end, N_Vector y, double& t);
  int fixed_step(double left, double t_end, N_Vector y, double& t);
  int adapted_step(const Flat& from, double t_end, N_Vector y, double& t);
  double tried(double left) const;
  void begin_again(const Flat& from, N_Vector y, double dt);

  Evaluate explicit_part_;
  Evaluate implicit_part_;
  std::optional<double> fixed_step_, first_step_;
  Callback* callback_;
  LinearSolver linear_;  // of the implicit part
  std::unique_ptr<void, Freed<free_arkode>> memory_;
  long retries_ = 0;      // steps on which the problem had no value, since the method was made
  long fixed_steps_ = 0;  // since the end was set
};

}  // namespace particulate::reference::detail
