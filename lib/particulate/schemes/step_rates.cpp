#include <particulate/schemes/step_rates.hpp>

#include <cmath>
#include <utility>

namespace particulate::schemes {

bool KeptRates::hold_at(const State& state) const {
  return state.t == at.t && state.r.size() == at.r.size() && state.r == at.r && state.y.size() == at.y.size() &&
         state.y == at.y && (at.v.size() == 0 || (state.v.size() == at.v.size() && state.v == at.v));
}

void StepRates::begin(const Problem& problem, const State& state, bool ask) {
  const bool goes_on = problem.identity() == of_ && end.hold_at(state);
  if (!goes_on || (ask && !problem.rates(state, end.rates))) forget();
  of_ = problem.identity();
}

bool StepRates::find_start(const State& from) {
  if (!end.hold_at(from)) {
    if (start.hold_at(from)) return true;
    begin_anew();
    return false;
  }
  before_ = watched_ ? last_dt_ : 0.0;
  if (watched_) std::swap(third_, start.rates);
  start.rates.a.swap(end.rates.a);
  start.rates.dy.swap(end.rates.dy);
  swap(start.at, end.at);
  end.forget();
  return true;
}

void StepRates::forget() {
  begin_anew();
  end.forget();
  watched_ = false;
}

void second_difference(const Eigen::VectorXd& start, const Eigen::VectorXd& end, const Eigen::VectorXd& other,
                       double place, Eigen::VectorXd& to) {
  to = (2.0 / (1.0 - place)) * ((end - start) - (other - start) / place);
}

Truncation estimated(double error, int order) {
  return {.error = std::isnan(error) ? std::numeric_limits<double>::infinity() : error, .order = order};
}

Truncation over_a_change(double error, int p) { return estimated(std::pow(error, p / (p + 1.0)), p - 1); }

}  // namespace particulate::schemes
