#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <particulate/reference/detail/callback.hpp>
#include <particulate/reference/detail/handles.hpp>
#include <particulate/reference/detail/stepper.hpp>
#include <particulate/reference/method.hpp>

/// @file
/// CVODE: the multistep methods.

namespace particulate::reference::detail {

void free_cvode(void* memory);

/// CVODE with the Adams methods and a functional corrector, or with BDF and Newton's method.
class Cvode {
 public:
  Cvode(const Adams& method, Callback& callback, double t, N_Vector y, SUNContext context);
  Cvode(const Bdf& method, Callback& callback, double t, N_Vector y, SUNContext context);

  void restart(double t, N_Vector y);
  void stop_at(double t_end);
  int step(const Flat& from, double t_end, N_Vector y, double& t);
  Counts counts() const;
  std::vector<Hit> hits() const;
  static std::string name_of(int flag);

 private:
  template <class Settings>
  void begin(const Settings& method, Callback& callback, double t, N_Vector y);
  void watch_for(const Events& events);

  NonlinearSolver corrector_;  // of Adams
  LinearSolver linear_;        // of BDF
  std::unique_ptr<void, Freed<free_cvode>> memory_;
  std::size_t events_ = 0;
};

}  // namespace particulate::reference::detail
