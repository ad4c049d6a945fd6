// Claims that hold, one of every kind: the tests compare the files of this run to the letter.

#include <array>
#include <cmath>
#include <stdexcept>

#include <harness/case.hpp>

namespace {

using namespace verification;

const Case two_sided{
    {.name = "two_sided",
     .claim = "numbers, \"counts\" and texts agree",
     .equation = "M 1.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.compare("relative [m]",
                   {.expected = -2.0, .computed = -2.5, .tolerance = relative(0.25), .because = "a quarter, exactly"});
      rows.compare("absolute [m]",
                   {.expected = 0.0, .computed = 0.125, .tolerance = absolute(0.5), .because = "half, around zero"});
      rows.compare("mixed [m]",
                   {.expected = 1e-9, .computed = 0.0, .tolerance = mixed(0.5, 1.0), .because = "the floor is one"});
      rows.compare("last bit [m]",
                   {.expected = 0.1, .computed = 0.1, .tolerance = absolute(0.0), .because = "the same digits"});
      rows.equal("count", {.expected = 3, .computed = 3L, .because = "counted by hand"});
      rows.equal("text", {.expected = "a, b", .computed = "a, b", .because = "by definition"});
    }};

const Case one_sided{{.name = "one_sided",
                      .claim = "bounds hold, the bound itself included",
                      .equation = "D 1.2",
                      .reference = Reference::identity},
                     [](Rows& rows) {
                       rows.at_most("below", {.limit = 1.0, .computed = 0.5, .because = "half is less than one"});
                       rows.at_least("at it", {.limit = 1.0, .computed = 1.0, .because = "the bound belongs to it"});
                     }};

const Case converging{
    {.name = "converging",
     .claim = "errors fall with the fourth power of the step",
     .equation = "R 3.1",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const std::array steps{0.25, 0.125, 0.0625, 0.03125, 0.015625};
      std::array<double, 5> errors{};
      for (std::size_t i = 0; i < steps.size(); ++i) errors[i] = std::pow(steps[i], 4);
      rows.order("order", {.nominal = 4.0, .steps = steps, .errors = errors, .floor = 1e-12, .because = "h^4 exactly"});
      rows.order_at_least("least order",
                          {.nominal = 2.0, .steps = steps, .errors = errors, .floor = 1e-12, .because = "h^4 exactly"});
    }};

const Case extremes{{.name = "extremes",
                     .claim = "extreme cases end as they must",
                     .equation = "D 2.1",
                     .reference = Reference::design},
                    [](Rows& rows) {
                      rows.must_be_solved("nearly parabolic", [] {
                        return Ending::solved({.error = 0.25, .tolerance = 0.5, .because = "half is enough"});
                      });
                      rows.must_be_refused("coincident", "must differ", []() -> Ending {
                        throw std::invalid_argument("positions must differ, got twice 0");
                      });
                      rows.must_be_refused("diverging", "contraction", [] {
                        return Ending::refused("the contraction is 1.001, which is not below 1");
                      });
                    }};

// A method of order 4 that takes 4 evaluations a step of size h over a unit of time.
Prepared runge_kutta(double h) {
  const Counts counts{.evaluations = std::lround(4.0 / h)};
  return {.task = {.start = {1.0}, .rate = {-1.0}, .outputs = {1.0}},
          .run = [counts] { return counts; },
          .errors = [h] { return Errors{.end = std::pow(h, 4), .max = 2.0 * std::pow(h, 4)}; },
          .replay = [counts] { return counts; }};
}

Prepared stiff(double tolerance) {
  Prepared prepared = runge_kutta(tolerance);
  prepared.run = [] { return Counts{.evaluations = 7, .failure = "the step fell below its least"}; };
  if (tolerance < 0.3) prepared.run = prepared.replay = [] { return Counts{.evaluations = 9, .iterations = 3}; };
  if (tolerance < 0.3) prepared.errors = [] { return Errors{.end = 5e-12, .max = 6e-12}; };
  return prepared;
}

const Case measured{
    {.name = "measured",
     .claim = "a measurement keeps its promises",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.work_precision(
          {.problem = "decay",
           .reference = "exp(-1)",
           .floor = 1e-12,
           .competitors = {{.name = "RK4",
                            .slope = 4.0,
                            .settings = {0.25, 0.125, 0.0625, 0.03125, 0.015625},
                            .prepare = runge_kutta},
                           {.name = "stiff", .tuned = true, .settings = {0.5, 0.25}, .prepare = stiff}}});
    }};

}  // namespace
