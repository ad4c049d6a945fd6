// The breathing pair with unequal masses: the separation knows their sum alone, each body its share.

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "references.hpp"

namespace verification::breathing_masses {

using namespace particulate;

// alpha is chosen so that alpha1 (m_i + m_j) is the same 4 for every pair: A = 4, B = 2, a = 2/3 and T = 2 pi
// sqrt(2/27).
constexpr double period = 1.710066440215819;

struct Pair {
  double m_i, m_j, alpha1;
};

template <class Move>
void compare(Rows& rows, const Pair& pair, const ExactBreathing& exact, const std::string& method,
             const Allowed& allowed, const Move& move) {
  NearFieldScene scene(pair_at_rest(pair.m_i, pair.m_j, 1.0), {},
                       {.alpha1 = pair.alpha1, .alpha2 = 0.5 * pair.alpha1, .beta1 = 2.0, .beta2 = 3.0});
  const BreathingErrors worst =
      errors_at_tenths(exact, pair_shape(pair.m_i, pair.m_j), scenes::start(scene), 30,
                       [&](schemes::State& state, double t_end) { move(scene, state, t_end); });
  compare_errors(rows, fmt::format(" of each body, {}, masses {} and {}", method, pair.m_i, pair.m_j), worst, allowed);
}

void compare(Rows& rows, const Pair& pair) {
  const ExactBreathing exact{.force = kinematics::breathing_pair(pair.alpha1, 0.5 * pair.alpha1, pair.m_i, pair.m_j),
                             .r_0 = 1.0};
  rows.compare(fmt::format("period [s], masses {} and {}", pair.m_i, pair.m_j),
               {.expected = period,
                .computed = exact.motion.period(),
                .tolerance = relative(1e-15),
                .because = "alpha1 (m_i + m_j) is rounded twice"});
  compare(rows, pair, exact, "RK4", allowed_to_steps(exact, 4, period / 5000.0),
          [](auto& scene, schemes::State& state, double t_end) {
            advance<schemes::RungeKutta4>(scene, state, t_end, 500);
          });
  // The heavy body moves by 1e-12 m only: the absolute tolerance must lie below that.
  reference::ExplicitRungeKutta fine = fehlberg;
  fine.absolute = 1e-26;
  compare(rows, pair, exact, "ARKODE Fehlberg 13(7,8)", allowed_to_tolerance(exact, global_of_runge_kutta),
          [&](auto& scene, schemes::State& state, double t_end) { advance_by(fine, scene, state, t_end); });
}

const Case breathing_masses{
    {.name = "breathing_masses",
     .claim = "T = 2 pi sqrt(a^3/(alpha1 (m_i + m_j))), and each body moves in inverse proportion to its mass",
     .equation = "D 1.4.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Pair pairs[] = {{.m_i = 1.0, .m_j = 3.0, .alpha1 = 1.0},
                            {.m_i = 0.07, .m_j = 0.01, .alpha1 = 50.0},
                            {.m_i = 1.0, .m_j = 1e12, .alpha1 = 4.0 / (1e12 + 1.0)},
                            {.m_i = 1e-6, .m_j = 1e-18, .alpha1 = 4.0 / (1e-6 + 1e-18)}};
      for (const Pair& pair : pairs) compare(rows, pair);
    }};

}  // namespace verification::breathing_masses
