#include <particulate/identification/history_cost.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <particulate/kinematics/breathing.hpp>
#include <particulate/laws/near_field.hpp>

#include "close.hpp"

namespace tests::history_cost_test {

using namespace particulate;
using namespace particulate::identification;

// Two starts of one quantity, three times at unequal distances: the trapezoidal rule weighs them 0.5, 1.5, 1.
Target energy() {
  Eigen::MatrixXd values(3, 2);
  values << 1.0, 2.0,  //
      2.0, -2.0,       //
      4.0, 1.0;
  return {.name = "energy", .times = {0.0, 1.0, 3.0}, .values = values, .weight = 3.0};
}
Target momentum() {
  Eigen::MatrixXd values(2, 2);
  values << 1.0, 2.0,  //
      3.0, 6.0;
  return {.name = "momentum", .times = {0.0, 2.0}, .values = values};
}

// Both histories moved up by a parameter each, in the second start by twice as much.
Simulated moved(const Eigen::VectorXd& by, Eigen::Index start) {
  const double times = start == 0 ? 1.0 : 2.0;
  return {.histories = {{energy().times, energy().values.col(start).array() + times * by[0]},
                        {momentum().times, momentum().values.col(start).array() + times * by[1]}}};
}
const HistoryCost both({energy(), momentum()}, moved);

BOOST_AUTO_TEST_SUITE(HistoryCost_)

BOOST_AUTO_TEST_CASE(is_zero_for_what_is_the_target) {
  BOOST_TEST(both(Eigen::Vector2d::Zero()).cost == 0.0);
  BOOST_TEST(close(both.sampled(Eigen::Vector2d::Zero()), both.data(), {}));
}

// Over 3 s and 2 s: int |dA| = 3 x and 6 x, 2 y and 4 y; int |A*| = 0.5 + 3 + 4 = 7.5 and 1 + 3 + 1 = 5, 1 + 3 = 4 and
// 2 + 6 = 8. With x = 0.5, y = 1: distances 0.2, 0.6, 0.5, 0.5; shares 3/8 and 1/8.
BOOST_AUTO_TEST_CASE(weighs_normalized_distances_of_all_histories_and_starts) {
  const Eigen::Vector2d at{0.5, 1.0};
  const Parts all = both.parts(at);
  BOOST_REQUIRE(all.parts.size() == 4u);
  const std::vector<std::string> names{"energy, start 0", "energy, start 1", "momentum, start 0", "momentum, start 1"};
  const std::vector<double> distances{0.2, 0.6, 0.5, 0.5}, shares{0.375, 0.375, 0.125, 0.125};
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(all.parts[k].name == names[k]);
    BOOST_TEST(all.parts[k].distance == distances[k], tolerance(1e-15));
    BOOST_TEST(all.parts[k].share == shares[k]);
  }
  BOOST_TEST(both(at).cost == 0.375 * 0.8 + 0.125 * 1.0, tolerance(1e-15));
}

// int A*^2 = 0.5 + 6 + 16 = 22.5 and 2 + 6 + 1 = 9, 1 + 9 = 10 and 4 + 36 = 40; int dA^2 = 3 x^2 and 12 x^2, 2 y^2 and
// 8 y^2.
BOOST_AUTO_TEST_CASE(has_residuals_whose_squares_sum_to_normalized_squares) {
  const Eigen::VectorXd residuals = both.residuals(Eigen::Vector2d(0.5, 1.0));
  BOOST_TEST(residuals.size() == 10);
  BOOST_TEST(residuals.squaredNorm() == 0.375 * (0.75 / 22.5 + 3.0 / 9.0) + 0.125 * (2.0 / 10.0 + 8.0 / 40.0),
             tolerance(1e-15));
  // The first of the second start: sqrt(3/8 0.5/9) times the difference 2 x.
  BOOST_TEST(residuals[3] == std::sqrt(0.375 * 0.5 / 9.0), tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(does_not_count_a_target_of_weight_zero) {
  Target ignored = momentum();
  ignored.weight = 0.0;
  const HistoryCost cost({energy(), ignored}, moved);
  BOOST_TEST(cost(Eigen::Vector2d(0.5, 100.0)).cost == 0.5 * (0.2 + 0.6), tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(has_no_value_where_a_start_has_none_and_says_why) {
  const Eigen::VectorXd at = Eigen::Vector2d::Zero();
  const auto check = [&](const HistoryModel& second, const char* reason) {
    const HistoryCost cost({energy(), momentum()}, [&](const Eigen::VectorXd& p, Eigen::Index start) {
      return start == 0 ? moved(p, start) : second(p, start);
    });
    BOOST_TEST(cost(at).reason == reason);
    BOOST_TEST(cost.parts(at).reason == reason);
    BOOST_TEST(cost.parts(at).parts.empty());
    BOOST_TEST(cost.residuals(at).size() == 0);
    BOOST_TEST(cost.sampled(at).size() == 0);
  };
  check([](const auto&, auto) { return Simulated{.reason = "too dense"}; }, "too dense");
  check([](const auto&, auto) -> Simulated { throw std::runtime_error("out of luck"); }, "out of luck");
  check([](const auto&, auto start) { return moved(Eigen::Vector2d(0.0, not_a_number), start); },
        "a history is not finite");
}

BOOST_AUTO_TEST_CASE(refuses_a_model_of_other_histories) {
  const Eigen::VectorXd at = Eigen::Vector2d::Zero();
  const auto gives = [&](const auto& change) {
    return HistoryCost({energy(), momentum()}, [&](const Eigen::VectorXd& p, Eigen::Index start) {
      Simulated simulated = moved(p, start);
      change(simulated);
      return simulated;
    })(at);
  };
  CHECK_REFUSED(gives([](Simulated& s) { s.histories.pop_back(); }), "must give one a target, 2, got 1");
  CHECK_REFUSED(gives([](Simulated& s) { s.histories[0].times[1] += 1e-15; }),
                "target \"energy\": the model's history must be at the times of its target");
  CHECK_REFUSED(gives([](Simulated& s) { s.histories[1].values.conservativeResize(1); }), "target \"momentum\"");
}

BOOST_AUTO_TEST_CASE(refuses_targets_that_do_not_go_together) {
  CHECK_REFUSED(HistoryCost({}, moved), "must have a target at least, got none");
  Target one_start = momentum();
  one_start.values.conservativeResize(2, 1);
  CHECK_REFUSED(HistoryCost({energy(), one_start}, moved), "as many starts, it has 1 and the first has 2");
  Target weightless = energy();
  weightless.weight = 0.0;
  CHECK_REFUSED(HistoryCost({weightless}, moved), "must not all be zero");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_target)

template <class Change>
void refuse(const Change& change, const char* words) {
  Target target = energy();
  change(target);
  CHECK_REFUSED(validate(target), words);
}

BOOST_AUTO_TEST_CASE(names_what_is_no_history) {
  refuse([](Target& t) { t = {.name = "energy", .times = {}, .values = {}}; },
         "target \"energy\": it must have two times at least, got 0");
  refuse([](Target& t) { t.times[1] = 3.0; }, "times must be finite and rise, time 2 is 3 s");
  refuse([](Target& t) { t.times[2] = infinity; }, "time 2 is inf s");
  refuse([](Target& t) { t.times.push_back(4.0); },
         "it must have 4 values, one a time, from one start at least, got 3");
  refuse([](Target& t) { t.values.resize(3, 0); }, "got 3 from 0");
  refuse([](Target& t) { t.values(1, 1) = not_a_number; }, "its values must be finite");
  refuse([](Target& t) { t.weight = -1.0; }, "its weight must be finite and not negative, got -1");
  refuse([](Target& t) { t.weight = not_a_number; }, "got nan");
}

BOOST_AUTO_TEST_CASE(refuses_zeros_and_what_does_not_vary) {
  refuse([](Target& t) { t.values.col(1).setZero(); }, "start 1: it is zero throughout");
  refuse([](Target& t) { t.values.col(1).setConstant(0.51); }, "it must vary by more than 1e-09 of its size, got 0");
  refuse([](Target& t) { t.values.col(1) = 0.51 * (1.0 + 1e-14 * t.values.col(1).array()); },
         "choose the relative energy");
  Target little = energy();
  little.values.col(1) = 0.51 * (1.0 + 1e-8 * little.values.col(1).array());
  BOOST_CHECK_NO_THROW(validate(little));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(relative_energy_history_)

// Masses 1 and 3 kg that part by the closed form r(t): per unit mass (1 3/4) r'^2/2/4.
BOOST_AUTO_TEST_CASE(of_a_breathing_pair_is_that_of_its_closed_form) {
  const kinematics::Particles pair = kinematics::particles({{.position = {-1.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                                            {.position = {0.5, 0.0, 0.0}, .mass = 3.0, .radius = 0.0}});
  const kinematics::Breathing exact(kinematics::breathing_pair(0.5, 0.25, 1.0, 3.0), 2.0);
  const scenes::Scene scene(pair, kinematics::Space{},
                            laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 2.0, .beta2 = 3.0});
  const std::vector<double> times{0.0, 0.3 * exact.period(), 0.9 * exact.period()};
  const Simulated simulated = relative_energy_history(scene, times, {.TOL = 1e-12});
  BOOST_TEST(relative_energy_history(scene, times, {.most_steps = 3}).reason == "the run takes too many steps");
  BOOST_REQUIRE(simulated.reason == "");
  BOOST_TEST((simulated.histories.front().times == times));
  Eigen::Vector3d expected;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double v = exact.at(times[static_cast<std::size_t>(k)]).v;
    expected[k] = 0.75 * 0.5 * v * v / 4.0;
  }
  BOOST_TEST(close(simulated.histories.front().values, expected, {.absolute = 1e-10}));
}

BOOST_AUTO_TEST_CASE(of_a_run_that_fails_says_how_it_fails) {
  const kinematics::Particles two = kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.1},
                                                           {.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.1}});
  const scenes::Scene scene(two, kinematics::Space{}, laws::NearField{.alpha1 = 1.0, .alpha2 = 1.0});
  const Simulated simulated = relative_energy_history(scene, {0.5, 1.0});
  BOOST_TEST(simulated.histories.empty());
  BOOST_TEST(simulated.reason == "the run does not reach its end: no value");
  CHECK_REFUSED(relative_energy_history(scene, {}), "a time after the start");
  CHECK_REFUSED(relative_energy_history(scene, {0.0}), "a time after the start");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::history_cost_test
