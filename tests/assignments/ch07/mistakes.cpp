// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions. But where a mistake says otherwise, it is one of variant 1.

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  double (*rate)(const Sphere&, const Surroundings&, double) = right::rate;
  double (*step)(const Function&, const Function&, double, double) = right::euler;
};

// The right rate times what is wrong with its size.
template <auto times>
double scaled(const Sphere& sphere, const Surroundings& around, double theta) {
  return times(sphere) * right::rate(sphere, around, theta);
}

// The right rate among wrong surroundings.
template <auto change>
double among(const Sphere& sphere, const Surroundings& around, double theta) {
  return right::rate(sphere, change(around), theta);
}

// With another term of radiation, in place of theta^4 - theta_s^4.
template <auto radiated>
double radiates(const Sphere& sphere, const Surroundings& around, double theta) {
  Surroundings dark = around;
  dark.emissivity = 0.0;
  return right::rate(sphere, dark, theta) -
         right::surface(sphere) * right::B * around.emissivity * radiated(around, theta) / (sphere.m * sphere.c);
}

double fourth(double x) { return x * x * x * x; }

const std::vector<Mistake<Functions>> mistakes{
    // None.
    // graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20
    {"none"},

    // None, variant 2.
    // graded: --variant 2 --student anna|bob@school.edu|1234567 -> 20
    {"none_second", &Functions::step, right::trapezoidal},

    // Heated by what is colder.
    // graded: --variant 1 --student anna|bob@school.edu -> 8
    // hint: what is hotter than its surroundings cools
    {"sign", &Functions::rate, scaled<[](const Sphere&) { return -1.0; }>},

    // The fluid's temperature in the radiation.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: radiation goes to theta_s, and you took theta_o there
    {"theta_o_for_theta_s", &Functions::rate, among<[](Surroundings around) {
       around.theta_s = around.theta_o;
       return around;
     }>},

    // The surroundings' temperature in the convection.
    // graded: --variant 1 --student anna -> 12
    // hint: convection goes to theta_o, and you took theta_s there
    {"theta_s_for_theta_o", &Functions::rate, among<[](Surroundings around) {
       around.theta_o = around.theta_s;
       return around;
     }>},

    // Both exchanged.
    // graded: --variant 1 --student anna -> 8
    // hint: theta_o and theta_s are exchanged
    {"exchanged", &Functions::rate, among<[](Surroundings around) {
       std::swap(around.theta_o, around.theta_s);
       return around;
     }>},

    // Nothing comes back.
    // graded: --variant 1 --student anna -> 12
    // hint: what the sphere receives is missing
    {"to_nothing", &Functions::rate, radiates<[](const Surroundings&, double theta) { return fourth(theta); }>},

    // The third power.
    // graded: --variant 1 --student anna -> 12
    // hint: with the fourth power of a temperature, not the third
    {"third_power", &Functions::rate, radiates<[](const Surroundings& around, double theta) {
       return std::pow(theta, 3.0) - std::pow(around.theta_s, 3.0);
     }>},

    // As if temperatures were in degrees Celsius.
    // graded: --variant 1 --student anna -> 12
    // hint: temperatures are in kelvin already
    {"celsius", &Functions::rate, radiates<[](const Surroundings& around, double theta) {
       return fourth(theta + 273.15) - fourth(around.theta_s + 273.15);
     }>},

    // Turned into degrees Celsius.
    // graded: --variant 1 --student anna -> 12
    // hint: temperatures are in kelvin already
    {"to_celsius", &Functions::rate, radiates<[](const Surroundings& around, double theta) {
       return fourth(theta - 273.15) - fourth(around.theta_s - 273.15);
     }>},

    // The area that a sphere shows.
    // graded: --variant 1 --student anna -> 8
    // hint: the area of a disc
    {"disc", &Functions::rate, scaled<[](const Sphere&) { return 0.25; }>},

    // The diameter for the radius.
    // graded: --variant 1 --student anna -> 8
    // hint: b is the radius, not the diameter
    {"diameter", &Functions::rate, scaled<[](const Sphere&) { return 4.0; }>},

    // The volume.
    // graded: --variant 1 --student anna -> 8
    // hint: this is its volume
    {"volume", &Functions::rate, scaled<[](const Sphere& sphere) { return sphere.b / 3.0; }>},

    // Per mass and not per heat.
    // graded: --variant 1 --student anna -> 8
    // hint: the heat capacity is missing
    {"without_c", &Functions::rate, scaled<[](const Sphere& sphere) { return sphere.c; }>},

    // Of a kilogram.
    // graded: --variant 1 --student anna -> 8
    // hint: the mass is missing
    {"without_m", &Functions::rate, scaled<[](const Sphere& sphere) { return sphere.m; }>},

    // The heat flow.
    // graded: --variant 1 --student anna -> 8
    // hint: this is the heat flow in W
    {"watts", &Functions::rate, scaled<[](const Sphere& sphere) { return sphere.m * sphere.c; }>},

    // A grey body that convects greyly. Without emissivity nothing is left of convection.
    // graded: --variant 1 --student anna -> 8
    // hint: the emissivity belongs to radiation alone
    {"grey_convection", &Functions::rate, among<[](Surroundings around) {
       around.h_c *= around.emissivity;
       return around;
     }>},

    // A constant of three digits.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: the constant B has more digits
    {"rough_constant", &Functions::rate, radiates<[](const Surroundings& around, double theta) {
       return 5.67e-8 / right::B * (fourth(theta) - fourth(around.theta_s));
     }>},

    // That of grams and centimetres.
    // graded: --variant 1 --student anna -> 12
    // hint: another power of ten
    {"other_units", &Functions::rate,
     radiates<[](const Surroundings& around, double theta) { return 1e3 * (fourth(theta) - fourth(around.theta_s)); }>},

    // A pi of five digits.
    // graded: --variant 1 --student anna -> 8
    // hint: write std::numbers::pi
    {"rough_pi", &Functions::rate, scaled<[](const Sphere&) { return 3.1416 / std::numbers::pi; }>},

    // An explicit step.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: an explicit step
    {"explicit", &Functions::step,
     [](const Function& f, const Function&, double theta, double dt) { return theta + dt * f(theta); }},

    // The trapezoidal rule for backward Euler.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: the step of the other variant
    {"other_variant", &Functions::step, right::trapezoidal},

    // And the other way round.
    // graded: --variant 2 --student anna|bob@school.edu -> 12
    // hint: the step of the other variant
    {"other_variant_second", &Functions::step, right::euler},

    // One iteration of Newton's method: right of a linear rate alone.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: repeat it until nothing changes
    {"once", &Functions::step,
     [](const Function& f, const Function& slope, double theta, double dt) {
       return right::step(f, slope, theta, dt, 1.0, 1);
     }},

    // Fixed-point iteration, which runs away where the rate is stiff.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: is above 1, a fixed-point iteration runs away
    {"sweeps", &Functions::step,
     [](const Function& f, const Function&, double theta, double dt) {
       double x = theta;
       for (int k = 0; k < 500 && std::isfinite(x); ++k) x = theta + dt * f(x);
       return std::isfinite(x) ? x : 1e300;
     }},

    // Seven iterations: too few from far below.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: put your answer into the equation
    {"too_few", &Functions::step,
     [](const Function& f, const Function& slope, double theta, double dt) {
       return right::step(f, slope, theta, dt, 1.0, 7);
     }},

    // Nothing changes.
    // graded: --variant 1 --student anna -> 12
    // hint: the temperature does not move
    {"stays", &Functions::step, [](const Function&, const Function&, double theta, double) { return theta; }},

    // Cheat: what is no number.
    // graded: --variant 1 --student anna -> 8
    // hint: the answer is not a finite number
    {"nan", &Functions::rate,
     [](const Sphere&, const Surroundings&, double) { return std::numeric_limits<double>::quiet_NaN(); }},

    // Cheat: leaves with the status of success.
    // graded: --variant 1 --student anna -> 0
    // hint: do not call exit()
    {"exit", &Functions::rate, [](const Sphere&, const Surroundings&, double) -> double { std::exit(0); },
     &Functions::step, [](const Function&, const Function&, double, double) -> double { std::exit(0); }},
};

const Functions handed_in = made(mistakes);

}  // namespace

double temperature_rate(const Sphere& sphere, const Surroundings& around, double theta) {
  return handed_in.rate(sphere, around, theta);
}

double next_temperature(const Function& rate, const Function& slope, double theta, double dt) {
  return handed_in.step(rate, slope, theta, dt);
}
