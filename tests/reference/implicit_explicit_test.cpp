#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <particulate/reference/integrator.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::implicit_explicit_test {

using namespace particulate::reference;
using namespace particulate::schemes;

// y' = -sin t/(2 + cos t) y - cos t/(2 + cos t) y^2, y = (2 + cos t)/(2 + sin t): with y = 1/w it is linear,
// ((2 + cos t) w)' = cos t. Both parts depend on the time.
struct Bernoulli {
  bool rate(double t, In y, Out dy) const {
    Eigen::VectorXd fast(1);
    const bool has_value = rate_slow(t, y, dy) && rate_fast(t, y, fast);
    dy += fast;
    return has_value;
  }
  static bool rate_slow(double t, In y, Out dy) {
    dy[0] = -std::sin(t) / (2.0 + std::cos(t)) * y[0];
    return true;
  }
  static bool rate_fast(double t, In y, Out dy) {
    dy[0] = -std::cos(t) / (2.0 + std::cos(t)) * y[0] * y[0];
    return true;
  }
  static double exact(double t) { return (2.0 + std::cos(t)) / (2.0 + std::sin(t)); }
};

// y' = -1e6 (y - cos t) - sin t, y = cos t: the first term is fast.
struct Stiff {
  static bool rate(double t, In y, Out dy) {
    dy[0] = -1e6 * (y[0] - std::cos(t)) - std::sin(t);
    return true;
  }
  static bool rate_slow(double t, In, Out dy) {
    dy[0] = -std::sin(t);
    return true;
  }
  static bool rate_fast(double t, In y, Out dy) {
    dy[0] = -1e6 * (y[0] - std::cos(t));
    return true;
  }
};

// y' = -2 sqrt(y) from 1, y = (1 - t)^2, in two parts of which one has no value for y < 0.
template <bool slow_has_none>
struct Draining {
  long refused = 0;
  bool root(In y, Out dy) {
    dy[0] = -std::sqrt(y[0]);
    if (y[0] >= 0.0) return true;
    ++refused;
    return false;
  }
  static bool shy(In y, Out dy) {
    dy[0] = -std::sqrt(std::max(y[0], 0.0));
    return true;
  }
  bool rate_slow(double, In y, Out dy) { return slow_has_none ? root(y, dy) : shy(y, dy); }
  bool rate_fast(double, In y, Out dy) { return slow_has_none ? shy(y, dy) : root(y, dy); }
  bool rate(double, In y, Out dy) {
    dy[0] = -2.0 * std::sqrt(y[0]);
    return y[0] >= 0.0;
  }
};

template <bool slow_has_none>
void drains() {
  Draining<slow_has_none> problem;
  long evaluations = 0;
  const Problem counted(problem, &evaluations);
  State state = one(1.0);
  Integrator integrator(counted, state,
                        ImplicitExplicit{.table = AdditiveTable::ark324l2sa_4_2_3, .relative = 1e-6, .absolute = 1e-8});
  const Outcome out = integrator.advance(state, 0.9999);
  BOOST_TEST((out.status == Status::reached), out.reason);
  BOOST_TEST(problem.refused > 0);
  BOOST_TEST(out.rejections > 0);
  BOOST_TEST(out.evaluations == evaluations);
  BOOST_TEST(out.evaluations == integrator.evaluations_by_sundials());
  BOOST_TEST(std::abs(state.y[0] - 1e-8) < 1e-6);
}

BOOST_AUTO_TEST_SUITE(implicit_explicit)

// Least squares over six refinements by 1.25, where the errors lie between 1e3 roundings and 1e-2.
BOOST_AUTO_TEST_CASE(every_pair_shows_its_order_at_fixed_steps_from_both_sides) {
  for (const AdditiveTable table : additive_tables) {
    const double coarsest = order(table) == 5 ? 40.0 : 80.0;
    Eigen::VectorXd log_steps(6), log_error(6);
    for (Eigen::Index k = 0; k < 6; ++k) {
      const long n = std::lround(coarsest * std::pow(1.25, static_cast<double>(k)));
      Bernoulli problem;
      State state = one(Bernoulli::exact(0.0));
      const Outcome out = integrate(
          problem, state, 3.0,
          ImplicitExplicit{
              .table = table, .relative = 1e-13, .absolute = 1e-13, .fixed_step = 3.0 / static_cast<double>(n)});
      BOOST_TEST((out.status == Status::reached));
      BOOST_TEST(out.steps == n);
      const double error = std::abs(state.y[0] - Bernoulli::exact(3.0));
      BOOST_TEST(error > 3e-13);
      BOOST_TEST(error < 1e-2);
      log_steps[k] = std::log(static_cast<double>(n));
      log_error[k] = std::log(error);
    }
    const Eigen::VectorXd x = log_steps.array() - log_steps.mean();
    const double slope = -x.dot(log_error) / x.squaredNorm();
    BOOST_TEST_CONTEXT(name(table)) { BOOST_TEST(std::abs(slope - order(table)) <= 0.2, "order " << slope); }
  }
}

// The second node of each pair, by which no two are alike: C. A. Kennedy, M. H. Carpenter, Appl. Numer. Math. 44 (2003)
// and 136 (2019). Both halves share it.
BOOST_AUTO_TEST_CASE(every_pair_asks_both_parts_at_its_own_nodes) {
  struct Timed : Bernoulli {
    std::set<double> slow, fast;
    bool rate_slow(double t, In y, Out dy) {
      slow.insert(t);
      return Bernoulli::rate_slow(t, y, dy);
    }
    bool rate_fast(double t, In y, Out dy) {
      fast.insert(t);
      return Bernoulli::rate_fast(t, y, dy);
    }
  };
  const std::array nodes{1767732205903.0 / 2027836641118.0, 0.5, 0.247, 0.41, 4.0 / 9.0};
  for (std::size_t k = 0; k < additive_tables.size(); ++k) {
    Timed problem;
    State state = one(Bernoulli::exact(0.0));
    const Outcome out =
        integrate(problem, state, 1.0, ImplicitExplicit{.table = additive_tables[k], .fixed_step = 1.0});
    BOOST_TEST((out.status == Status::reached));
    const auto has_node = [&](const std::set<double>& times) {
      return std::any_of(times.begin(), times.end(), [&](double t) { return std::abs(t - nodes[k]) < 1e-12; });
    };
    BOOST_TEST((has_node(problem.slow) && has_node(problem.fast)), name(additive_tables[k]));
  }
}

BOOST_AUTO_TEST_CASE(adapted_steps_meet_the_closed_form_to_their_tolerance) {
  for (const AdditiveTable table : additive_tables) {
    BOOST_TEST_CONTEXT(name(table)) {
      double coarse = 0.0;
      for (const double tolerance : {1e-6, 1e-9}) {
        Bernoulli problem;
        State state = one(Bernoulli::exact(0.0));
        const Outcome out = integrate(problem, state, 3.0,
                                      ImplicitExplicit{.table = table, .relative = tolerance, .absolute = tolerance});
        const double error = std::abs(state.y[0] - Bernoulli::exact(3.0));
        BOOST_TEST((out.status == Status::reached));
        BOOST_TEST(error < 1e2 * tolerance);
        if (tolerance < 1e-6) BOOST_TEST(error < 0.1 * coarse);
        coarse = error;
      }
    }
  }
}

// At h lambda = 1e5 the explicit half would multiply an error by 1e15 a step or more. Stiffness leaves the pairs an
// order of two or more: h^2 = 0.01.
BOOST_AUTO_TEST_CASE(the_fast_part_is_the_implicit_one) {
  for (const AdditiveTable table : additive_tables) {
    Stiff problem;
    State state = one(1.0);
    const Outcome out = integrate(problem, state, 3.0, ImplicitExplicit{.table = table, .fixed_step = 0.1});
    BOOST_TEST((out.status == Status::reached));
    BOOST_TEST(out.steps == 30);
    BOOST_TEST(std::abs(state.y[0] - std::cos(3.0)) < 1e-2, name(table));
  }
  Stiff problem;
  State state = one(1.0);
  const Outcome out = integrate(problem, state, 3.0, ImplicitExplicit{.relative = 1e-6, .absolute = 1e-6});
  BOOST_TEST((out.status == Status::reached), out.reason);
  BOOST_TEST(out.steps < 1000);
  BOOST_TEST(std::abs(state.y[0] - std::cos(3.0)) < 1e-4);
}

BOOST_AUTO_TEST_CASE(asks_for_the_parts_and_never_for_the_whole_rate_or_its_jacobian) {
  struct Parts : Bernoulli {
    long whole = 0, slow = 0, fast = 0;
    bool rate(double, In, Out) {
      ++whole;
      return false;
    }
    bool rate_slow(double t, In y, Out dy) {
      ++slow;
      return Bernoulli::rate_slow(t, y, dy);
    }
    bool rate_fast(double t, In y, Out dy) {
      ++fast;
      return Bernoulli::rate_fast(t, y, dy);
    }
    void jacobian(double, In, Eigen::MatrixXd&) { ++whole; }
  };
  Parts problem;
  State state = one(Bernoulli::exact(0.0));
  Integrator integrator(problem, state,
                        ImplicitExplicit{.table = AdditiveTable::ark436l2sa_6_3_4, .fixed_step = 0.125});
  const Outcome first = integrator.advance(state, 2.0), second = integrator.advance(state, 4.0);
  BOOST_TEST(problem.whole == 0);
  // Six stages a step, of which five are implicit. Whether the start costs one more is up to SUNDIALS.
  BOOST_TEST(problem.slow >= 32 * 6);
  BOOST_TEST(problem.slow <= 32 * 6 + 1);
  BOOST_TEST(problem.fast > problem.slow + 32 * 5);
  BOOST_TEST(first.evaluations + second.evaluations == problem.slow + problem.fast);
  BOOST_TEST(integrator.evaluations_by_sundials() == problem.slow + problem.fast);
  BOOST_TEST((first.sweeps >= 5 * first.steps && second.sweeps >= 5 * second.steps));
}

BOOST_AUTO_TEST_CASE(every_setting_reaches_arkode) {
  const auto steps_with = [](const ImplicitExplicit& method) {
    Bernoulli problem;
    State state = one(Bernoulli::exact(0.0));
    const Outcome out = integrate(problem, state, 2.0, method);
    BOOST_TEST((out.status == Status::reached));
    return out.steps;
  };
  const long steps = steps_with({.relative = 1e-6, .absolute = 1e-6});
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e-6, .first_step = 1e-12}) > steps);
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e-6, .largest_step = 0.002}) >= 1000);
  BOOST_TEST(steps_with({.relative = 1e-9, .absolute = 1e-9}) > steps);
  BOOST_TEST(steps_with({.relative = 1e-6, .absolute = 1e3}) < steps);
  BOOST_TEST(steps_with({.fixed_step = 0.002}) == 1000);
  Bernoulli problem;
  State state = one(Bernoulli::exact(0.0));
  const Outcome cut = integrate(problem, state, 2.0, ImplicitExplicit{.max_steps = 7});
  BOOST_TEST((cut.status == Status::failed && cut.steps == 7));
}

BOOST_AUTO_TEST_CASE(goes_on_from_the_state_it_left_and_starts_afresh_from_another) {
  const ImplicitExplicit fixed{.fixed_step = 1.0 / 64}, adapted{.relative = 1e-8, .absolute = 1e-8};
  Bernoulli problem;
  State whole = one(Bernoulli::exact(0.0)), legs = whole;
  BOOST_TEST((integrate(problem, whole, 3.0, fixed).steps == 192));
  Integrator in_legs(problem, legs, fixed);
  const Outcome first = in_legs.advance(legs, 1.25), second = in_legs.advance(legs, 3.0);
  BOOST_TEST(first.steps + second.steps == 192);
  BOOST_TEST(legs.y[0] == whole.y[0], tolerance(1e-12));

  Integrator integrator(problem, legs, adapted);
  BOOST_TEST((integrator.advance(legs, 4.0).status == Status::reached));
  legs.y[0] *= 2.0;
  State copy = legs;
  const Outcome changed = integrator.advance(legs, 6.0), afresh = integrate(problem, copy, 6.0, adapted);
  BOOST_TEST(changed.evaluations == afresh.evaluations);
  BOOST_TEST(integrator.evaluations_by_sundials() == changed.evaluations);
  BOOST_TEST((legs.t == copy.t && legs.y == copy.y));
}

BOOST_AUTO_TEST_CASE(a_step_on_which_a_part_has_no_value_is_tried_again_smaller) {
  drains<true>();
  drains<false>();
}

// y' = 1 is exact in every step, so that only the equation of a step can fail.
BOOST_AUTO_TEST_CASE(steps_whose_equation_has_no_solution_are_rejections) {
  struct Walled {
    long refused = 0;
    bool rate(double, In y, Out dy) {
      dy[0] = 1.0;
      if (y[0] <= 1.0) return true;
      ++refused;
      return false;
    }
    static bool rate_slow(double, In, Out dy) {
      dy[0] = 0.0;
      return true;
    }
    bool rate_fast(double t, In y, Out dy) { return rate(t, y, dy); }
  } problem;
  State state = one(0.0);
  const Outcome out = integrate(problem, state, 2.0, ImplicitExplicit{.relative = 1e-6, .absolute = 1e-8});
  BOOST_TEST((out.status == Status::failed));
  BOOST_TEST(problem.refused > 10);
  // A step is refused once, or twice if Newton's method had an old Jacobian and tries again with a new one.
  BOOST_TEST(out.rejections >= problem.refused / 2);
  BOOST_TEST(contains(out.reason, "the problem had no finite value at t = "));
  BOOST_TEST(state.t == 1.0, tolerance(1e-3));
  BOOST_TEST(state.y[0] == state.t, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(what_a_part_throws_comes_out_and_the_integrator_goes_on) {
  struct Mistaken : Stiff {
    bool slow = false, fast = false;
    bool rate_slow(double t, In y, Out dy) const {
      if (slow && t > 0.5) throw std::domain_error("the slow part is lost");
      return Stiff::rate_slow(t, y, dy);
    }
    bool rate_fast(double t, In y, Out dy) const {
      if (fast && t > 0.5) throw std::domain_error("the fast part is lost");
      return Stiff::rate_fast(t, y, dy);
    }
  };
  Mistaken problem;
  State state = one(1.0);
  Integrator integrator(problem, state, ImplicitExplicit{.relative = 1e-6, .absolute = 1e-6});
  problem.slow = true;
  BOOST_CHECK_EXCEPTION((void)integrator.advance(state, 1.0), std::domain_error, says("the slow part is lost"));
  problem = Mistaken{};
  problem.fast = true;
  BOOST_CHECK_EXCEPTION((void)integrator.advance(state, 1.0), std::domain_error, says("the fast part is lost"));
  BOOST_TEST((state.t == 0.0 && state.y[0] == 1.0));
  problem = Mistaken{};
  BOOST_TEST((integrator.advance(state, 1.0).status == Status::reached));
  BOOST_TEST(std::abs(state.y[0] - std::cos(1.0)) < 1e-4);
}

// y = z + h y^2 with h = 1 has no root near y = 1.
BOOST_AUTO_TEST_CASE(a_fixed_step_whose_equation_has_no_solution_fails_and_says_what_to_do) {
  struct Exploding {
    static bool rate(double, In y, Out dy) {
      dy[0] = y[0] * y[0];
      return true;
    }
    static bool rate_slow(double, In, Out dy) {
      dy[0] = 0.0;
      return true;
    }
    static bool rate_fast(double t, In y, Out dy) { return rate(t, y, dy); }
  } problem;
  State state = one(1.0);
  const Outcome out = integrate(problem, state, 3.0, ImplicitExplicit{.fixed_step = 3.0});
  BOOST_TEST((out.status == Status::failed));
  BOOST_TEST(contains(out.reason, "does not converge at any step; stop before this time, take smaller fixed steps"));
  BOOST_TEST((state.t == 0.0 && state.y[0] == 1.0));
}

BOOST_AUTO_TEST_CASE(nothing_to_solve_takes_no_step) {
  Bernoulli problem;
  State state{.t = 1.0, .y = Eigen::VectorXd(0)};
  const Outcome out = integrate(problem, state, 3.0, ImplicitExplicit{});
  BOOST_TEST((out.status == Status::reached && out.evaluations == 0 && state.t == 3.0));
}

BOOST_AUTO_TEST_CASE(a_problem_that_does_not_split_is_refused) {
  Decay whole;
  struct Moving : Spring {
    static bool rate_slow(double t, In y, Out dy) { return Stiff::rate_slow(t, y, dy); }
    static bool rate_fast(double t, In y, Out dy) { return Stiff::rate_fast(t, y, dy); }
  } moving;
  const char* words = "needs a first-order problem in two parts, got one that does not split; give it rate_slow";
  CHECK_REFUSED(Integrator(whole, one(1.0), ImplicitExplicit{}), words);
  const State motion = displaced();
  CHECK_REFUSED(Integrator(moving, motion, ImplicitExplicit{}), words);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::implicit_explicit_test
