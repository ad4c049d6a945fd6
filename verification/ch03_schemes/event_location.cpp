// Events on the spring r = cos t, whose every passage through a level is known, and the same events by CVODE.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/events.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "linear_problems.hpp"

namespace verification::event_location {

using namespace particulate;
using schemes::Direction;
using schemes::Events;
using schemes::Hit;

constexpr double pi = std::numbers::pi;

struct Run {
  schemes::Outcome outcome;
  schemes::State state;
  std::vector<Hit> hits;
};

// r = cos t from t = 0.
template <class Scheme>
Run spring_by(Scheme scheme, double t_end, double step, const Events& events) {
  const Oscillators spring = oscillator(1.0);
  Run run{.outcome = {}, .state = motion(1.0, 0.0), .hits = {}};
  schemes::FixedStep control{.step = step};
  schemes::Watch watch(events);
  run.outcome = schemes::integrate(spring, run.state, t_end, scheme, control, watch);
  run.hits = watch.hits();
  return run;
}
template <int S>
Run spring_until(double t_end, double step, const Events& events) {
  return spring_by(schemes::Collocation<schemes::Gauss<S>>(), t_end, step, events);
}

Events level(double of, Direction direction, schemes::Action action = schemes::Action::record) {
  return {
      {.function = [of](const schemes::State& at) { return at.r[0] - of; }, .direction = direction, .action = action}};
}

// Passages of cos t through a level: falling at acos, rising at 2 pi - acos, and so on.
std::vector<double> passages(double of, Direction direction, double t_end) {
  std::vector<double> times;
  for (double turn = 0.0; turn < t_end; turn += 2.0 * pi) {
    if (direction != Direction::rising) times.push_back(turn + std::acos(of));
    if (direction != Direction::falling) times.push_back(turn + 2.0 * pi - std::acos(of));
  }
  std::erase_if(times, [&](double t) { return t > t_end; });
  return times;
}

double worst_time(const std::vector<Hit>& hits, const std::vector<double>& times) {
  if (hits.size() != times.size()) return missing;
  double worst = 0.0;
  for (std::size_t k = 0; k < times.size(); ++k) keep_worst(worst, std::abs(hits[k].t - times[k]));
  return worst;
}

const char* const to_rounding =
    "six stages leave 1e-15 of a phase a step; a passage moves by the rounding of positions over the speed there";

void directions(Rows& rows) {
  for (const auto& [direction, name] :
       {std::pair{Direction::falling, "falling"}, {Direction::rising, "rising"}, {Direction::either, "either way"}}) {
    const Run run = spring_until<6>(20.0, 0.3, level(0.3, direction));
    rows.equal(fmt::format("passages {} in 20 s", name), {.expected = passages(0.3, direction, 20.0).size(),
                                                          .computed = run.hits.size(),
                                                          .because = "counted by the inverse cosine"});
    rows.at_most(
        fmt::format("worst time of a passage {} [s]", name),
        {.limit = 2e-13, .computed = worst_time(run.hits, passages(0.3, direction, 20.0)), .because = to_rounding});
  }
}

// Three functions, of which two have a zero in common; the third's come between, several in each long step.
Events three_functions() {
  using schemes::Action, schemes::State;
  return {{.function = [](const State& at) { return at.r[0] - 0.3; }, .action = Action::record, .name = "place"},
          {.function = [](const State& at) { return 0.6 - 2.0 * at.r[0]; },
           .direction = Direction::rising,
           .action = Action::record,
           .name = "twin"},
          {.function = [](const State& at) { return at.v[0] + 0.7; }, .action = Action::record, .name = "speed"}};
}

std::string in_words(const std::vector<Hit>& hits) {
  std::string words;
  for (const Hit& hit : hits) words += (words.empty() ? "" : ", ") + describe(three_functions(), hit);
  return words;
}

void several(Rows& rows) {
  // v = -sin t passes -0.7 falling at asin 0.7 = 0.775 and rising at pi less that, 2.366; r passes 0.3 at 1.266
  // and 5.017.
  const std::string expected = "speed falling, place falling, twin rising, speed rising, place rising";
  for (const double step : {0.1, 1.5}) {
    const Run run = spring_until<8>(6.0, step, three_functions());
    rows.equal(fmt::format("events of three functions in 6 s, steps of {} s", step),
               {.expected = expected,
                .computed = in_words(run.hits),
                .because = "in the order of their times, those of one time in the order of the functions"});
    rows.at_most(fmt::format("their worst time, steps of {} s [s]", step),
                 {.limit = 1e-14,
                  .computed = worst_time(run.hits, {std::asin(0.7), std::acos(0.3), std::acos(0.3), pi - std::asin(0.7),
                                                    2.0 * pi - std::acos(0.3)}),
                  .because = "eight stages leave (8!)^2/(16! 17!) h^17 of a phase a step: 2e-16 in one of 1.5 s"});
  }
}

void against_cvode(Rows& rows) {
  const Run ours = spring_until<6>(20.0, 0.3, three_functions());
  Oscillators spring = oscillator(1.0);
  schemes::State state = motion(1.0, 0.0);
  reference::Integrator integrator(spring, state, reference::Adams{.relative = 1e-13, .absolute = 1e-14},
                                   three_functions());
  std::vector<Hit> theirs;
  while (integrator.advance(state, 20.0).status == schemes::Status::stopped && theirs.size() < 1000) {
    theirs.insert(theirs.end(), integrator.hits().begin(), integrator.hits().end());
  }
  std::vector<double> times;
  for (const Hit& hit : theirs) times.push_back(hit.t);
  rows.equal("events in 20 s, and their order, as CVODE finds them from the same object",
             {.expected = in_words(theirs), .computed = in_words(ours.hits), .because = "each is a plain sign change"});
  rows.at_most("worst difference of a time from CVODE's [s]",
               {.limit = 1e-10,
                .computed = worst_time(ours.hits, times),
                .because = "CVODE starts afresh at each event, and each start leaves some 1e-12"});
}

void at_the_ends(Rows& rows) {
  const Events moving{
      {.function = [](const schemes::State& at) { return at.r[0] - 1.0 + 1e-3; }, .action = schemes::Action::record},
      {.function = [](const schemes::State& at) { return at.v[0]; }, .action = schemes::Action::record}};
  const Run started = spring_until<6>(10.0, 0.3, moving);
  std::vector<Hit> speed;
  std::copy_if(started.hits.begin(), started.hits.end(), std::back_inserter(speed),
               [](const Hit& hit) { return hit.event == 1; });
  rows.at_most("zeros of a speed that starts at zero: those after the start [s]",
               {.limit = 2e-13, .computed = worst_time(speed, {pi, 2.0 * pi, 3.0 * pi}), .because = to_rounding});
  const double end = std::acos(0.3);
  for (const double step : {0.3, end / 8.0}) {
    const Run ended = spring_until<6>(end, step, level(0.3, Direction::falling));
    rows.equal(fmt::format("events where a run ends at one to rounding, steps of {:.3g} s", step),
               {.expected = 1, .computed = ended.hits.size(), .because = "what the end has reached has happened"});
  }
  rows.none("events where a run ends 1e-9 s before one",
            spring_until<6>(end - 1e-9, 0.3, level(0.3, Direction::falling)).hits.size(),
            "a millionth of a step is seen");
}

void stop(Rows& rows) {
  for (const double step : {0.05, 0.3, 2.0}) {
    Events events = level(-0.4, Direction::falling, schemes::Action::stop);
    events[0].name = "the place -0.4";
    const Run run = spring_until<6>(50.0, step, events);
    const std::string which = fmt::format(", steps of {} s", step);
    rows.equal("a run that ends at a condition" + which,
               {.expected = "the place -0.4 falling",
                .computed = run.outcome.status == schemes::Status::stopped ? run.outcome.reason : "not stopped",
                .because = "the reason names the event"});
    rows.at_most("distance of its state from the condition [m]" + which,
                 {.limit = 1e-14 * step + 1e-15,
                  .computed = std::abs(run.state.r[0] + 0.4),
                  .because = "the step stands to 1e-14 of itself; and rounding"});
    rows.compare("its time [s]" + which,
                 {.expected = std::acos(-0.4),
                  .computed = run.state.t,
                  .tolerance = absolute(step < 1.0 ? 1e-14 : 2e-9),
                  .because = "six stages leave (6!)^2/(12! 13!) h^13 of a phase a step: 1e-9 in "
                             "one of 2 s, rounding in the others"});
  }
}

const Case location{
    {.name = "event_location",
     .claim = "events of either direction, several in a step, at the start and at the end of a run are found at "
              "their times",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      directions(rows);
      several(rows);
      at_the_ends(rows);
      stop(rows);
    }};

const Case by_cvode{{.name = "event_location_cvode",
                     .claim = "the same events, given to CVODE, are the same in number, order and time",
                     .equation = "R 3.4",
                     .reference = Reference::sundials},
                    against_cvode};

// How many events a run over one touch of zero at pi has, for many places of the touch within its step.
struct Grazes {
  int fewest = 1000, most = 0;
  double worst_time = 0.0;
};
Grazes grazes(double of, Direction direction, const std::vector<double>& times, int runs) {
  Grazes all;
  for (int k = 0; k < runs; ++k) {
    const Run run = spring_until<6>(5.0, 0.25 + 0.5 * k / runs, level(of, direction));
    const auto count = static_cast<int>(run.hits.size());
    all.fewest = std::min(all.fewest, count);
    all.most = std::max(all.most, count);
    keep_worst(all.worst_time, worst_time(run.hits, times));
  }
  return all;
}

void prove_grazing(Rows& rows) {
  const int runs = rows.quick() ? 40 : 400;
  const auto exactly = [&](const std::string& what, int expected, const Grazes& seen) {
    rows.equal(fmt::format("{}: fewest and most events of {} runs", what, runs),
               {.expected = fmt::format("{} and {}", expected, expected),
                .computed = fmt::format("{} and {}", seen.fewest, seen.most),
                .because = "wherever in its step it falls"});
  };
  const Grazes touch = grazes(-1.0, Direction::either, {pi}, runs);
  exactly("touch of -1 at pi", 1, touch);
  rows.at_most("touch of -1 at pi: worst time [s]",
               {.limit = 1e-7,
                .computed = touch.worst_time,
                .because = "a touch is only as sharp as its value: the rounding of the place, 2e-16, is 2e-8 s of the "
                           "time; and some such"});
  exactly("touch of -1, asked for falling", 1, grazes(-1.0, Direction::falling, {pi}, runs));
  exactly("touch of -1, asked for rising", 0, grazes(-1.0, Direction::rising, {}, runs));
  exactly("miss by 1e-9", 0, grazes(-1.0 - 1e-9, Direction::either, {}, runs));
  const double half = std::acos(1.0 - 1e-9);
  const Grazes two = grazes(-1.0 + 1e-9, Direction::either, {pi - half, pi + half}, runs);
  exactly("dip of 1e-9 below zero", 2, two);
  rows.at_most("dip of 1e-9: worst time of its two roots [s]",
               {.limit = 1e-10,
                .computed = two.worst_time,
                .because = "the rounding of positions, 1e-15, over the speed of 4.5e-5 there, and a few such"});
}

const Case grazing{
    {.name = "event_grazing",
     .claim = "a double root is one event, of the direction it came from; two roots beside each other are two, a near "
              "miss none",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    prove_grazing};

// The second passage of a level, in the middle of its step, and what it costs to find it there.
template <class Scheme>
void order_of_time(Rows& rows, report::Table& table, const std::string& name, double nominal, const Scheme& scheme,
                   const std::vector<long>& counts) {
  const double exact = 2.0 * pi + std::acos(0.3);
  std::vector<double> steps, errors;
  double dearest = 0.0;
  for (const long n : counts) {
    const double step = exact / (static_cast<double>(n) + 0.5);
    const Run run = spring_by(scheme, 8.0, step, level(0.3, Direction::falling));
    const Run without = spring_by(scheme, 8.0, step, {});
    steps.push_back(step);
    errors.push_back(run.hits.size() == 2 ? std::abs(run.hits[1].t - exact) : missing);
    const double each = static_cast<double>(without.outcome.evaluations) / static_cast<double>(without.outcome.steps);
    keep_worst(dearest, static_cast<double>(run.outcome.evaluations - without.outcome.evaluations) / (2.0 * each));
    table.add({name, step, errors.back(), run.outcome.evaluations, without.outcome.evaluations});
  }
  rows.order(
      "order of the time of an event, " + name,
      {.nominal = nominal,
       .steps = steps,
       .errors = errors,
       .floor = 1e-14,
       .because =
           "the event lies in the middle of its step; solved anew to end there it has the order of the scheme, on "
           "dense output it would have a lower one"});
  rows.at_most("right-hand sides for an event over those of a step, " + name,
               {.limit = 8.0,
                .computed = dearest,
                .because = "a step is solved anew some four times, from a worse guess than the last step's, and the "
                           "rest of it is a step more"});
}

const Case order{
    {.name = "event_order",
     .claim = "the time of an event has the order of the scheme, not the lower one of its dense output, for the price "
              "of some steps",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      report::Table table({"scheme", "step [s]", "error of the time [s]", "right-hand sides [-]",
                           "right-hand sides without the event [-]"});
      using schemes::Collocation, schemes::Gauss;
      order_of_time(rows, table, "2 stages", 4.0, Collocation<Gauss<2>>(), {16, 21, 27, 35, 46, 60});
      order_of_time(rows, table, "3 stages", 6.0, Collocation<Gauss<3>>(), {8, 11, 14, 18, 23, 29});
      order_of_time(rows, table, "4 stages", 8.0, Collocation<Gauss<4>>(), {6, 8, 11, 14, 18, 23});
      order_of_time(rows, table, "RK4", 4.0, schemes::RungeKutta4(), {16, 27, 46, 78, 132, 224});
      order_of_time(rows, table, "velocity Verlet", 2.0, schemes::VelocityVerlet(), {78, 132, 224, 380, 646, 1098});
      rows.write("event_order", table);
    }};

}  // namespace verification::event_location
