#include "collocation_races.hpp"

#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace verification {
namespace collocation_races {

template <class Scheme, class State, class Problem, class Control>
Advance<State> begin(Problem problem, const schemes::CollocationSettings& settings, Control control) {
  return [problem = std::move(problem), scheme = Scheme(settings), control](State& state, double t_end) mutable {
    return schemes::integrate(problem, state, t_end, scheme, control);
  };
}

template <class Control>
Advance<schemes::State> begin_gauss(int stages, AnyMotion problem, const schemes::CollocationSettings& settings,
                                     const Control& control) {
  using schemes::Collocation, schemes::Gauss, schemes::State;
  switch (stages) {
    case 4:
      return begin<Collocation<Gauss<4>>, Motion>(std::move(problem), settings, control);
    case 8:
      return begin<Collocation<Gauss<8>>, Motion>(std::move(problem), settings, control);
    default:
      throw std::invalid_argument(fmt::format("Gauss collocation races with 4 or 8 stages, got {}", stages));
  }
}

}  // namespace collocation_races

Advance<schemes::State> gauss(int stages, AnyMotion problem, const schemes::CollocationSettings& settings,
                               const schemes::FixedSweeps& control) {
  return collocation_races::begin_gauss(stages, std::move(problem), settings, control);
}

Advance<schemes::State> gauss(int stages, AnyMotion problem, const schemes::CollocationSettings& settings,
                               const schemes::ErrorControl& control) {
  return collocation_races::begin_gauss(stages, std::move(problem), settings, control);
}

Advance<schemes::State> radau(int stages, AnyValues problem, const schemes::CollocationSettings& settings,
                               const schemes::ErrorControl& control) {
  using schemes::Collocation, schemes::Newton, schemes::Radau, schemes::State;
  switch (stages) {
    case 3:
      return collocation_races::begin<Collocation<Radau<3>, Newton<>>, Values>(std::move(problem), settings, control);
    case 5:
      return collocation_races::begin<Collocation<Radau<5>, Newton<>>, Values>(std::move(problem), settings, control);
    default:
      throw std::invalid_argument(fmt::format("Radau collocation races with 3 or 5 stages, got {}", stages));
  }
}

}  // namespace verification
