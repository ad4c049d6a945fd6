// Claims that fail, each in a way of its own: the tests run them one at a time and look for the reason.

#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include <harness/case.hpp>

namespace {

using namespace verification;

constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

// A case of one claim under the given name.
Case one(const char* name, void (*proof)(Rows&)) {
  return {{.name = name, .claim = "something false", .equation = "M 0.0", .reference = Reference::identity}, proof};
}

const Case beyond_tolerance = one("beyond_tolerance", [](Rows& rows) {
  rows.compare("x", {.expected = 1.0, .computed = 1.0000000000000002, .tolerance = relative(1e-16), .because = "b"});
});
const Case one_of_two = one("one_of_two", [](Rows& rows) {
  rows.equal("good", {.expected = 1, .computed = 1, .because = "b"});
  rows.equal("bad", {.expected = 1, .computed = 2, .because = "b"});
});
const Case some_of_none = one("some_of_none", [](Rows& rows) { rows.none("x", 1, "b"); });
const Case seven_of_seven = one("seven_of_seven", [](Rows& rows) {
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g"}) {
    rows.equal(name, {.expected = 1,
                      .computed = 2,
                      .because = "a reason that is longer than a line of a terminal is "
                                 "broken at its blanks, so that nothing is cut off"});
  }
});
const Case computed_nan = one("computed_nan", [](Rows& rows) {
  rows.compare("x", {.expected = 1.0, .computed = nan_, .tolerance = relative(1.0), .because = "b"});
});
const Case expected_nan = one("expected_nan", [](Rows& rows) {
  rows.compare("x", {.expected = nan_, .computed = nan_, .tolerance = absolute(1.0), .because = "b"});
});
const Case tolerance_nan = one("tolerance_nan", [](Rows& rows) {
  rows.compare("x", {.expected = 1.0, .computed = 1.0, .tolerance = mixed(nan_, 1.0), .because = "b"});
});
const Case infinite = one("infinite", [](Rows& rows) {
  rows.compare("x", {.expected = inf, .computed = inf, .tolerance = absolute(1.0), .because = "b"});
});
const Case infinite_bound =
    one("infinite_bound", [](Rows& rows) { rows.at_most("x", {.limit = 1.0, .computed = -inf, .because = "b"}); });
const Case nan_bound =
    one("nan_bound", [](Rows& rows) { rows.at_least("x", {.limit = 1.0, .computed = nan_, .because = "b"}); });
const Case above_bound = one("above_bound", [](Rows& rows) {
  rows.at_most("x", {.limit = 1.0, .computed = 1.0000000000000002, .because = "b"});
});
const Case below_bound = one("below_bound", [](Rows& rows) {
  rows.at_least("x", {.limit = 1.0, .computed = 0.9999999999999999, .because = "b"});
});
const Case without_reason = one("without_reason", [](Rows& rows) {
  rows.compare("x", {.expected = 1.0, .computed = 1.0, .tolerance = absolute(0.0), .because = " "});
});
const Case relative_to_zero = one("relative_to_zero", [](Rows& rows) {
  rows.compare("x", {.expected = 0.0, .computed = 0.0, .tolerance = relative(1e-9), .because = "b"});
});
const Case unset = one("unset", [](Rows& rows) {
  Equality equality;
  equality.because = "b";
  rows.equal("x", equality);
});
const Case empty = one("empty", [](Rows&) {});
const Case throwing = one("throwing", [](Rows& rows) {
  rows.equal("good", {.expected = 1, .computed = 1, .because = "b"});
  throw std::runtime_error("the integrator stopped");
});
const Case out_of_memory = one("out_of_memory", [](Rows&) { throw std::bad_alloc(); });
const Case throwing_a_number = one("throwing_a_number", [](Rows&) { throw 7; });

const Case refused_but_solvable = one("refused_but_solvable", [](Rows& rows) {
  rows.must_be_solved("x", []() -> Ending { throw std::invalid_argument("no step is small enough"); });
});
const Case solved_but_impossible = one("solved_but_impossible", [](Rows& rows) {
  rows.must_be_refused("x", "coincide",
                       [] { return Ending::solved({.error = 0.0, .tolerance = 1.0, .because = "b"}); });
});
const Case wrongly_solved = one("wrongly_solved", [](Rows& rows) {
  rows.must_be_solved("x", [] { return Ending::solved({.error = 2.0, .tolerance = 1.0, .because = "b"}); });
});
const Case solved_with_nan = one("solved_with_nan", [](Rows& rows) {
  rows.must_be_solved("x", [] { return Ending::solved({.error = nan_, .tolerance = 1.0, .because = "b"}); });
});
const Case wrong_words = one("wrong_words", [](Rows& rows) {
  rows.must_be_refused("x", "particles coincide", [] { return Ending::refused("particles overlap"); });
});
const Case no_words = one("no_words", [](Rows& rows) {
  rows.must_be_refused("x", " ", [] { return Ending::refused("particles overlap"); });
});

// The order of errors h^p, claimed to be 4.
void claim_order_4(Rows& rows, double p, double first_step, std::size_t points, double floor) {
  std::array<double, 5> steps{}, errors{};
  for (std::size_t i = 0; i < points; ++i) {
    steps[i] = first_step / std::pow(2.0, i);
    errors[i] = std::pow(steps[i], p);
  }
  rows.order("x", {.nominal = 4.0,
                   .steps = std::span(steps).first(points),
                   .errors = std::span(errors).first(points),
                   .floor = floor,
                   .because = "b"});
}
const Case order_too_low = one("order_too_low", [](Rows& rows) { claim_order_4(rows, 3.79, 0.25, 5, 1e-12); });
const Case order_too_high = one("order_too_high", [](Rows& rows) { claim_order_4(rows, 4.21, 0.25, 5, 1e-12); });
const Case too_few_points = one("too_few_points", [](Rows& rows) { claim_order_4(rows, 4.0, 0.25, 4, 1e-12); });
const Case error_too_large = one("error_too_large", [](Rows& rows) { claim_order_4(rows, 4.0, 0.5, 5, 1e-12); });
const Case error_at_floor = one("error_at_floor", [](Rows& rows) { claim_order_4(rows, 4.0, 0.25, 5, 1e-10); });
const Case order_of_nan = one("order_of_nan", [](Rows& rows) { claim_order_4(rows, nan_, 0.25, 5, 1e-12); });
const Case order_not_reached = one("order_not_reached", [](Rows& rows) {
  const std::array steps{0.1, 0.05, 0.025, 0.0125, 0.00625};
  std::array<double, 5> errors{};
  for (std::size_t i = 0; i < steps.size(); ++i) errors[i] = 0.01 * steps[i];
  rows.order_at_least("x", {.nominal = 2.0, .steps = steps, .errors = errors, .floor = 1e-12, .because = "b"});
});
const Case steps_not_refined = one("steps_not_refined", [](Rows& rows) {
  const std::array steps{0.1, 0.09, 0.08, 0.07, 0.06};
  const std::array errors{1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
  rows.order("x", {.nominal = 4.0, .steps = steps, .errors = errors, .floor = 1e-12, .because = "b"});
});

// A ruler that is in order; the cases below spoil one thing each.
Prepared sound(double h) {
  const Counts counts{.evaluations = std::lround(4.0 / h)};
  return {.task = {.start = {1.0}, .rate = {-1.0}, .outputs = {1.0}},
          .run = [counts] { return counts; },
          .errors = [h] { return Errors{.end = std::pow(h, 4), .max = std::pow(h, 4)}; },
          .replay = [counts] { return counts; }};
}
WorkPrecision ruler(std::function<Prepared(double)> prepare) {
  return {.problem = "decay",
          .reference = "exp(-1)",
          .floor = 1e-12,
          .competitors = {{.name = "RK4",
                           .slope = 4.0,
                           .settings = {0.25, 0.125, 0.0625, 0.03125, 0.015625},
                           .prepare = std::move(prepare)}}};
}
const Case counts_do_not_repeat = one("counts_do_not_repeat", [](Rows& rows) {
  rows.work_precision(ruler([calls = 0L](double h) mutable {
    Prepared prepared = sound(h);
    if (h == 0.0625) prepared.run = [&calls] { return Counts{.evaluations = 64 + (++calls == 5 ? 1 : 0)}; };
    return prepared;
  }));
});
const Case replay_takes_another_path = one("replay_takes_another_path", [](Rows& rows) {
  rows.work_precision(ruler([](double h) {
    Prepared prepared = sound(h);
    prepared.replay = [] { return Counts{.evaluations = 1}; };
    return prepared;
  }));
});
const Case without_replay = one("without_replay", [](Rows& rows) {
  rows.work_precision(ruler([](double h) {
    Prepared prepared = sound(h);
    prepared.replay = nullptr;
    return prepared;
  }));
});
const Case without_task = one("without_task", [](Rows& rows) {
  rows.work_precision(ruler([](double h) {
    Prepared prepared = sound(h);
    prepared.task.start.clear();
    return prepared;
  }));
});
const Case another_start = one("another_start", [](Rows& rows) {
  rows.work_precision(ruler([](double h) {
    Prepared prepared = sound(h);
    if (h < 0.02) prepared.task.start = {1.0000000000000002};
    return prepared;
  }));
});
const Case error_of_nan = one("error_of_nan", [](Rows& rows) {
  rows.work_precision(ruler([](double h) {
    Prepared prepared = sound(h);
    if (h < 0.02) prepared.errors = [] { return Errors{.end = nan_, .max = 1.0}; };
    return prepared;
  }));
});
const Case nothing_solved = one("nothing_solved", [](Rows& rows) {
  WorkPrecision measurement = ruler(sound);
  measurement.competitors.push_back({.name = "hopeless", .settings = {0.1}, .prepare = [](double h) {
                                       Prepared prepared = sound(h);
                                       prepared.run = [] { return Counts{.failure = "diverges"}; };
                                       return prepared;
                                     }});
  rows.work_precision(measurement);
});
const Case coarse_settings = one("coarse_settings", [](Rows& rows) {
  WorkPrecision measurement = ruler(sound);
  measurement.competitors.push_back({.name = "coarse", .settings = {1e-2, 1e-3}, .prepare = sound});
  rows.work_precision(measurement);
});
const Case rising_settings = one("rising_settings", [](Rows& rows) {
  WorkPrecision measurement = ruler(sound);
  measurement.competitors.push_back({.name = "rising", .settings = {1e-3, 2e-3}, .prepare = sound});
  rows.work_precision(measurement);
});
const Case without_ruler = one("without_ruler", [](Rows& rows) {
  WorkPrecision measurement = ruler(sound);
  measurement.competitors.front().slope.reset();
  rows.work_precision(measurement);
});
const Case wrong_slope = one("wrong_slope", [](Rows& rows) {
  WorkPrecision measurement = ruler(sound);
  measurement.competitors.front().slope = 5.0;
  rows.work_precision(measurement);
});
const Case slope_below_its_bound = one("slope_below_its_bound", [](Rows& rows) {
  WorkPrecision measurement = ruler(sound);
  measurement.competitors.front().slope = 5.0;
  measurement.competitors.front().steeper = "errors may cancel";
  rows.work_precision(measurement);
});

}  // namespace
