#include <particulate/schemes/iteration.hpp>

#include <cmath>

#include "close.hpp"
#include "problems.hpp"

namespace tests::iteration_test {

using namespace particulate::schemes;

// One step of displacement 4 from a start of size 12, whose sweeps change the state by 2, 1 and 1/4.
IterationMeasure three_sweeps() {
  IterationMeasure measure;
  measure.begin(2);
  measure.normalize(4.0, 12.0);
  for (const double change : {2.0, 1.0, 0.25}) measure.record(change);
  return measure;
}

Attempt attempt_with(const Iteration& it) { return {.dt = 0.5, .iteration = it}; }

BOOST_AUTO_TEST_SUITE(IterationMeasure_)

BOOST_AUTO_TEST_CASE(divides_every_change_by_the_first_displacement) {
  const Iteration it = three_sweeps().iteration();
  BOOST_TEST(it.w_0 == 0.5);
  BOOST_TEST(it.w_K == 0.0625);
  BOOST_TEST(it.K == 2);
  BOOST_TEST(it.p == 2);
  BOOST_TEST(it.evaluated);
}

BOOST_AUTO_TEST_CASE(takes_the_contraction_from_changes_that_are_not_normalized) {
  const Iteration it = three_sweeps().iteration();
  BOOST_TEST(it.change == 0.25);
  BOOST_TEST(it.rate == 0.25);
}

BOOST_AUTO_TEST_CASE(knows_what_one_rounding_of_the_state_is) {
  BOOST_TEST(three_sweeps().iteration().rounding == eps * 16.0 / 4.0);
}

BOOST_AUTO_TEST_CASE(forgets_the_last_step_when_the_next_begins) {
  IterationMeasure measure = three_sweeps();
  measure.begin(1, "heat");
  BOOST_TEST(measure.waits_for_first());
  const Iteration& it = measure.iteration();
  BOOST_TEST(it.w_0 + it.w_K + it.change + it.rate + it.rounding == 0.0);
  BOOST_TEST(it.K == -1);
  BOOST_TEST(it.p == 1);
  BOOST_TEST(it.field == "heat");
  measure.normalize(2.0, 0.0);
  measure.record(1.0);
  BOOST_TEST(it.w_0 == 0.5);
  BOOST_TEST(it.rate == 0.0);
}

BOOST_AUTO_TEST_CASE(counts_no_change_over_no_displacement_as_none) {
  IterationMeasure measure;
  measure.begin(2);
  measure.normalize(0.0, 0.0);
  const Iteration it = measure.record(0.0);
  BOOST_TEST(it.w_0 == 0.0);
  BOOST_TEST(it.w_K == 0.0);
  BOOST_TEST(it.K == 0);
  BOOST_TEST(it.evaluated);
}

// A displacement below 1e-8 of the state is met at its rounding, one above by the tolerance alone.
BOOST_AUTO_TEST_CASE(lets_rounding_do_for_a_motion_that_is_all_but_at_rest) {
  for (const bool rests : {true, false}) {
    IterationMeasure measure;
    measure.begin(2);
    measure.normalize(rests ? 0.9e-8 : 1.1e-8, 1.0);
    measure.record(1e-9);
    BOOST_TEST(!met(measure.iteration(), 1e-12));
    measure.record(eps);
    BOOST_TEST(met(measure.iteration(), 1e-12) == rests);
  }
}

BOOST_AUTO_TEST_CASE(divides_by_no_less_than_one_rounding_of_the_state) {
  IterationMeasure measure;
  measure.begin(2);
  measure.normalize(0.0, 2.0);
  BOOST_TEST(measure.unit() == 2.0 * eps);
  BOOST_TEST(measure.record(1.0).w_0 == 0.5 / eps);
  BOOST_TEST(measure.iteration().rounding == 1.0);
}

BOOST_AUTO_TEST_CASE(begins_to_count_with_the_first_sweep_that_changes_anything) {
  IterationMeasure measure;
  measure.begin(1);
  measure.normalize(0.0, 1.0);
  measure.record(0.0);
  BOOST_TEST(measure.waits_for_first());
  measure.normalize(4.0, 1.0);
  BOOST_TEST(measure.record(2.0).w_0 == 0.5);
  BOOST_TEST(!measure.waits_for_first());
  BOOST_TEST(measure.iteration().K == 0);
  BOOST_TEST(measure.record(1.0).K == 1);
}

BOOST_AUTO_TEST_CASE(takes_no_infinite_change_for_a_value_and_keeps_the_last_finite_one) {
  for (const double change : {infinity, not_a_number}) {
    IterationMeasure measure = three_sweeps();
    const Iteration it = measure.record(change);
    BOOST_TEST(!it.evaluated);
    BOOST_TEST(it.w_K == 0.0625);
    BOOST_TEST(it.K == 2);
  }
}

// A distance that overflows measures nothing: w = 0 of it would be neither a first sweep nor a settled one, for ever.
BOOST_AUTO_TEST_CASE(takes_no_infinite_displacement_for_a_measure) {
  for (const auto& [displacement, size] : {std::pair(infinity, 1.0), std::pair(1.0, infinity)}) {
    IterationMeasure measure;
    measure.begin(1);
    measure.normalize(displacement, size);
    BOOST_TEST(!measure.record(0.0).evaluated);
  }
}

BOOST_AUTO_TEST_CASE(remembers_after_an_overflow_that_the_sweeps_were_diverging) {
  IterationMeasure measure;
  measure.begin(1);
  measure.normalize(1.0, 1.0);
  measure.record(1.0);
  measure.record(1e200);
  BOOST_TEST(measure.record(not_a_number).rate == 1e200);
}

BOOST_AUTO_TEST_CASE(books_that_there_is_no_value) { BOOST_TEST(!three_sweeps().no_value().evaluated); }

BOOST_AUTO_TEST_SUITE_END()

// A body and three values in two ranges; the second range is content with a hundredth of the tolerance.
struct Parted {
  static constexpr bool ignores_velocities = true;
  bool rates(double, In, In, In, Out, Out) const { return true; }
  std::vector<Range> ranges() const {
    return {{.name = "heat", .first = 0, .size = 1}, {.name = "charge", .first = 1, .size = 2, .TOL = 0.01}};
  }
  PartMeasures begun() const {
    PartMeasures parts;
    parts.begin(*this, displaced(Eigen::VectorXd::Ones(3)), 2);
    return parts;
  }
};

BOOST_AUTO_TEST_SUITE(PartMeasures_)

// Motion moves by 4 and changes by 1; heat from 1 by 2 and by 2; charge from (10, -20) by 100, then by 3 of that.
BOOST_AUTO_TEST_CASE(keep_every_part_in_its_own_unit_and_know_the_worst) {
  const Parted problem;
  PartMeasures parts = problem.begun();
  parts.motion().normalize(4.0, 12.0);
  parts.motion().record(1.0);
  const Eigen::VectorXd start = Eigen::Vector3d(1.0, 10.0, -20.0), moved = Eigen::Vector3d(3.0, 60.0, -70.0);
  parts.record_values(problem, start, start, moved);
  const Iteration first = parts.worst();
  BOOST_TEST(first.field == "charge");
  BOOST_TEST(first.w_0 == 100.0);
  parts.motion().record(0.5);
  parts.record_values(problem, start, moved, Eigen::Vector3d(3.5, 61.0, -72.0));
  BOOST_TEST(parts.worst().field == "charge");
  BOOST_TEST_REQUIRE(parts.iterations().size() == 3U);
  const Iteration &motion = parts.iterations()[0], &heat = parts.iterations()[1], &charge = parts.iterations()[2];
  BOOST_TEST((motion.field == "motion" && motion.p == 2 && motion.K == 1));
  BOOST_TEST((heat.field == "heat" && heat.p == 1 && heat.K == 1));
  BOOST_TEST((motion.w_0 == 0.25 && motion.w_K == 0.125));
  BOOST_TEST((heat.w_0 == 1.0 && heat.w_K == 0.25));
  BOOST_TEST(charge.w_K == 0.03 / 0.01, tolerance(1e-15));
  BOOST_TEST(heat.rounding == eps * 3.0 / 2.0);
  BOOST_TEST(charge.rounding == eps * 130.0 / 100.0 / 0.01, tolerance(1e-15));
  BOOST_TEST(heat.change == 0.5);
  BOOST_TEST(charge.change == 3.0);
}

// Of two combinations of rates the larger change counts, in each range for itself.
BOOST_AUTO_TEST_CASE(take_the_larger_of_two_changes_of_a_range) {
  const Parted problem;
  PartMeasures parts = problem.begun();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(3);
  parts.motion().normalize(1.0, 1.0);
  parts.motion().record(0.0);
  parts.record_values(problem, zero, zero, Eigen::Vector3d(2.0, 1.0, 0.0), zero, Eigen::Vector3d(1.0, 0.0, 5.0));
  parts.worst();
  BOOST_TEST(parts.iterations()[1].change == 2.0);
  BOOST_TEST(parts.iterations()[2].change == 5.0);
}

// A hundredth of a tolerance is one of its own too where there is a single part.
BOOST_AUTO_TEST_CASE(of_a_single_part_are_that_of_the_problem) {
  struct Values {
    double TOL;
    bool rate(double, In, Out) const { return true; }
    double distance(In x, In y) const { return 10.0 * (x - y).norm(); }
    std::vector<Range> ranges() const { return {{.name = "heat", .first = 0, .size = 2, .TOL = TOL}}; }
  };
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2), moved = Eigen::Vector2d(3.0, 4.0);
  for (const double TOL : {1.0, 0.01}) {
    const Values problem{TOL};
    PartMeasures parts;
    parts.begin(problem, {.y = zero}, 2);
    parts.record_values(problem, zero, zero, moved);
    const Iteration it = parts.worst();
    BOOST_TEST(it.change == 50.0);
    BOOST_TEST(it.w_0 == 1.0 / TOL);
    BOOST_TEST(it.p == 1);
    BOOST_TEST(it.field.empty());
    BOOST_TEST(parts.iterations().empty() == (TOL == 1.0));
  }
}

BOOST_AUTO_TEST_CASE(have_no_value_where_the_problem_has_none) {
  PartMeasures parts = Parted{}.begun();
  BOOST_TEST(!parts.no_value().evaluated);
  for (const Iteration& it : parts.iterations()) BOOST_TEST(!it.evaluated);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(worst_of_)

BOOST_AUTO_TEST_CASE(is_the_largest_error_and_none_is_worse_than_any) {
  const std::vector<Iteration> all{
      {.w_K = 1.0, .field = "one"}, {.w_K = 2.0, .field = "two"}, {.w_K = 2.0, .field = "three"}};
  BOOST_TEST(worst_of(all).field == "two");
  const std::vector<Iteration> none{{.w_K = 2.0}, {.w_K = 1.0, .evaluated = false, .field = "none"}};
  BOOST_TEST(worst_of(none).field == "none");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(phi_K_)

// w_0 = 1/2, w_2 = 1/32: two contractions by 1/4, that is by (S Dt^2) with S Dt^2 = 1/4. TOL = 1/2^9 in four
// contractions needs (S Dt^2)^4 = 2^-8, a contraction by 1/4: the step is right. In two it needs 1/16, half the step.
BOOST_AUTO_TEST_CASE(is_what_the_model_says_when_multiplied_out_by_hand) {
  const Iteration it{.w_0 = 0.5, .w_K = 0.03125, .K = 2, .p = 2};
  BOOST_TEST(phi_K(it, std::ldexp(1.0, -9), 4) == 1.0, tolerance(1e-15));
  BOOST_TEST(phi_K(it, std::ldexp(1.0, -9), 2) == 0.5, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(moves_the_step_of_a_first_order_problem_by_the_square_of_that) {
  const Iteration it{.w_0 = 0.5, .w_K = 0.03125, .K = 2, .p = 1};
  BOOST_TEST(phi_K(it, std::ldexp(1.0, -9), 2) == 0.25, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(shrinks_the_step_where_the_sweeps_diverge) {
  const Iteration it{.w_0 = 1.0, .w_K = 16.0, .K = 2, .p = 2};
  BOOST_TEST(phi_K(it, std::ldexp(1.0, -8), 2) == 0.125, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(is_infinite_at_the_fixed_point_and_unknown_without_a_contraction) {
  BOOST_TEST(phi_K({.w_0 = 0.5, .w_K = 0.0, .K = 1}, 1e-6, 10) == infinity);
  BOOST_TEST(std::isnan(phi_K({.w_0 = 0.5, .w_K = 0.5, .K = 0}, 1e-6, 10)));
  BOOST_TEST(std::isnan(phi_K({}, 1e-6, 10)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(at_rounding_)

BOOST_AUTO_TEST_CASE(is_one_rounding_or_some_that_fall_no_more) {
  BOOST_TEST(at_rounding({.w_K = 1e-12, .K = 3, .rounding = 1e-12}));
  BOOST_TEST(!at_rounding({.w_K = 2e-12, .rate = 0.9, .K = 3, .rounding = 1e-12}));
  BOOST_TEST(at_rounding({.w_0 = 1.0, .w_K = 2e-12, .rate = 1.0, .K = 3, .rounding = 1e-12}));
  BOOST_TEST(!at_rounding({.w_0 = 1.0, .w_K = 65e-12, .rate = 1.0, .K = 3, .rounding = 1e-12}));
  BOOST_TEST(!at_rounding({.w_0 = 1e-12, .w_K = 2e-12, .rate = 1.0, .K = 3, .rounding = 1e-12}));
  BOOST_TEST(at_rounding({}));
  BOOST_TEST(at_rounding({.w_0 = 1.0, .w_K = 60.0, .rate = 1.0, .K = 3, .rounding = 1.0, .rests = true}));
  BOOST_TEST(!at_rounding({.w_0 = 1.0, .w_K = 65.0, .rate = 1.0, .K = 3, .rounding = 1.0, .rests = true}));
  BOOST_TEST(!at_rounding({.w_0 = 1.0, .w_K = 60.0, .rate = 0.9, .K = 3, .rounding = 1.0, .rests = true}));
}

// A factor of 1/2 every hundred sweeps is one of 0.993 each, which repeats a rounding 145 times.
BOOST_AUTO_TEST_CASE(allows_for_roundings_that_slow_sweeps_repeat) {
  BOOST_TEST(at_rounding({.w_0 = 1.0, .w_K = std::ldexp(1.0, -40), .rate = 1.0, .K = 4000, .rounding = 1e-16}));
  BOOST_TEST(!at_rounding({.w_0 = 1.0, .w_K = std::ldexp(1.0, -40), .rate = 1.0, .K = 40, .rounding = 1e-16}));
}

BOOST_AUTO_TEST_CASE(is_far_from_where_ratios_show_a_contraction) {
  BOOST_TEST(shows_contraction({.w_K = 1001e-12, .rounding = 1e-12}));
  BOOST_TEST(!shows_contraction({.w_K = 999e-12, .rounding = 1e-12}));
  BOOST_TEST(shows_contraction({.w_K = 0.0, .evaluated = false}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(unmet_)

BOOST_AUTO_TEST_CASE(says_how_slowly_the_sweeps_contract_and_what_would_do) {
  const Decision refused = unmet(attempt_with({.w_0 = 0.5, .w_K = 0.03125, .rate = 0.25, .K = 2, .p = 2}), 1e-4, 2);
  BOOST_TEST(!refused.accepted);
  BOOST_TEST((refused.failure == Failure::slow));
  BOOST_TEST(contains(refused.impossible, "contract by a factor of 0.25 each at Dt = 0.5 s"));
  BOOST_TEST(contains(refused.impossible, "TOL = 0.0001 in 2 contractions needs about Dt = "));
  BOOST_TEST(refused.workable == std::pow(2e-4, 0.25) / std::sqrt(0.25) * 0.5, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(tells_divergence_from_slowness_and_names_the_field) {
  const Decision refused =
      unmet(attempt_with({.w_0 = 1.0, .w_K = 16.0, .rate = 4.0, .K = 2, .p = 1, .field = "heat"}), 1e-4, 2);
  BOOST_TEST((refused.failure == Failure::diverging));
  BOOST_TEST(contains(refused.impossible, "the sweeps of field heat diverge by a factor of 4 each"));
  BOOST_TEST(refused.workable == 0.01 / 4.0 * 0.5, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(knows_an_overflow_for_divergence) {
  const Decision refused =
      unmet(attempt_with({.w_0 = 1.0, .w_K = 1e300, .rate = infinity, .K = 3, .evaluated = false}), 1e-4, 10);
  BOOST_TEST((refused.failure == Failure::diverging));
  BOOST_TEST(refused.workable < 0.5e-50);
}

BOOST_AUTO_TEST_CASE(says_that_the_problem_had_no_value) {
  const Decision refused = unmet(attempt_with({.evaluated = false}), 1e-4, 2);
  BOOST_TEST((refused.failure == Failure::no_value));
  BOOST_TEST(contains(refused.impossible, "no finite value within this step of 0.5 s"));
  BOOST_TEST(std::isnan(refused.workable));
}

BOOST_AUTO_TEST_CASE(says_that_a_tolerance_is_below_rounding) {
  const Decision refused =
      unmet(attempt_with({.w_0 = 0.5, .w_K = 2e-12, .rate = 1.0, .K = 9, .rounding = 1e-12}), 1e-14, 10);
  BOOST_TEST((refused.failure == Failure::rounding));
  BOOST_TEST(contains(refused.impossible, "TOL = 1e-14 is below rounding"));
  BOOST_TEST(contains(refused.impossible, "choose a larger TOL, or larger steps"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::iteration_test
