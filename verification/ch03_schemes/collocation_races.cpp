#include "collocation_races.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace verification {
namespace collocation_races {

template <class Scheme, class Control>
Advance begin(const schemes::Problem& problem, const schemes::CollocationSettings& settings, const Control& control) {
  return [problem, scheme = Scheme(settings), now = control](schemes::State& state, double t_end) mutable {
    return schemes::integrate(problem, state, t_end, scheme, now);
  };
}

template <class Control>
Advance begin_gauss(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
                    const Control& control) {
  using schemes::Collocation, schemes::Gauss;
  switch (stages) {
    case 4:
      return begin<Collocation<Gauss<4>>>(problem, settings, control);
    case 8:
      return begin<Collocation<Gauss<8>>>(problem, settings, control);
    default:
      throw std::invalid_argument(fmt::format("Gauss collocation races with 4 or 8 stages, got {}", stages));
  }
}

}  // namespace collocation_races

Advance gauss(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
              const schemes::FixedSweeps& control) {
  return collocation_races::begin_gauss(stages, problem, settings, control);
}

Advance gauss(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
              const schemes::ErrorControl& control) {
  return collocation_races::begin_gauss(stages, problem, settings, control);
}

Advance radau(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
              const schemes::ErrorControl& control) {
  using schemes::Collocation, schemes::Newton, schemes::Radau;
  switch (stages) {
    case 3:
      return collocation_races::begin<Collocation<Radau<3>, Newton<>>>(problem, settings, control);
    case 5:
      return collocation_races::begin<Collocation<Radau<5>, Newton<>>>(problem, settings, control);
    default:
      throw std::invalid_argument(fmt::format("Radau collocation races with 3 or 5 stages, got {}", stages));
  }
}

}  // namespace verification
