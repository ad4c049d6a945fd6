#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <particulate/thermo/cooling.hpp>

#include "grading.hpp"

using grading::Draw;
using grading::Line;
using grading::Question;

namespace thermo = particulate::thermo;

namespace {

// A sphere and its surroundings, in the order of the driver's inputs.
struct Case {
  double b, m, c, h_c, theta_o, emissivity, theta_s, theta;

  std::vector<double> inputs() const { return {b, m, c, h_c, theta_o, emissivity, theta_s, theta}; }
  double radiation() const { return thermo::stefan_boltzmann * emissivity * thermo::surface(b) / (m * c); }
  double convection() const { return h_c * thermo::surface(b) / (m * c); }
};

double expected_rate(const Case& x) {
  const thermo::Cooling law{.h_c = x.h_c, .theta_o = x.theta_o, .emissivity = x.emissivity, .theta_s = x.theta_s};
  return thermo::surface(x.b) * thermo::heat_flux(law, x.theta) / (x.m * x.c);
}

// One thing that can be wrong with the rate.
struct Flaw {
  double area = 4.0;  // times pi b^2
  bool is_volume = false, without_m = false, without_c = false;
  double sign = 1.0, power = 4.0, zero = 0.0, B = thermo::stefan_boltzmann, pi = std::numbers::pi;
  bool is_grey = false, swaps = false, o_alone = false, s_alone = false, to_nothing = false;
};

double with_flaw(const Flaw& flaw, const Case& x) {
  const double surface = flaw.is_volume ? 4.0 / 3.0 * flaw.pi * std::pow(x.b, 3.0) : flaw.area * flaw.pi * x.b * x.b;
  const double theta_o = flaw.swaps || flaw.s_alone ? x.theta_s : x.theta_o;
  const double theta_s = flaw.swaps || flaw.o_alone ? x.theta_o : x.theta_s;
  const auto raised = [&](double theta) { return std::pow(theta + flaw.zero, flaw.power); };
  const double convection = x.h_c * (x.theta - theta_o) * (flaw.is_grey ? x.emissivity : 1.0);
  const double radiation = flaw.B * x.emissivity * (raised(x.theta) - (flaw.to_nothing ? 0.0 : raised(theta_s)));
  return -flaw.sign * surface * (convection + radiation) / (flaw.without_m ? 1.0 : x.m) / (flaw.without_c ? 1.0 : x.c);
}

std::vector<grading::Mistake> mistakes_in_rate(const Case& x) {
  static const std::string kelvin = "temperatures are in kelvin already: nothing is added to them, nothing taken off";
  static const std::string constant = "the constant B has more digits, or another power of ten: 5.670374419e-8";
  const std::vector<std::pair<Flaw, std::string>> flaws{
      {{.sign = -1.0}, "the sign: what is hotter than its surroundings cools"},
      {{.swaps = true}, "theta_o and theta_s are exchanged: the fluid convects, what is seen radiates"},
      {{.o_alone = true}, "radiation goes to theta_s, and you took theta_o there"},
      {{.s_alone = true}, "convection goes to theta_o, and you took theta_s there"},
      {{.to_nothing = true}, "what the sphere receives is missing: theta^4 - theta_s^4"},
      {{.power = 3.0}, "radiation grows with the fourth power of a temperature, not the third"},
      {{.zero = 273.15}, kelvin},
      {{.zero = -273.15}, kelvin},
      {{.area = 1.0}, "the area of a disc: the surface of a sphere is 4 pi b^2"},
      {{.area = 16.0}, "b is the radius, not the diameter"},
      {{.is_volume = true}, "this is its volume: the surface of a sphere is 4 pi b^2"},
      {{.without_m = true}, "the mass is missing: m c theta' is what flows"},
      {{.without_c = true}, "the heat capacity is missing: m c theta' is what flows"},
      {{.without_m = true, .without_c = true}, "this is the heat flow in W: divide it by m c"},
      {{.is_grey = true}, "the emissivity belongs to radiation alone, not to convection"},
      {{.B = 5.67e-8}, constant},
      {{.B = 5.6704e-8}, constant},
      {{.B = 5.670374e-8}, constant},
      {{.B = 5.670374419e-5}, constant}};
  const auto give = [&](const Flaw& flaw) -> std::vector<double> { return {with_flaw(flaw, x)}; };
  std::vector<grading::Mistake> all = grading::mistakes(flaws, give);
  const auto rough = grading::rough_pi([&](double pi) { return give({.pi = pi}); });
  all.insert(all.end(), rough.begin(), rough.end());
  return all;
}

Case drawn(Draw& draw) {
  return {.b = 1e-3 * draw.between(0.5, 3.0),
          .m = 1e-5 * draw.between(1.0, 9.0),
          .c = draw.between(400.0, 2000.0),
          .h_c = draw.between(20.0, 80.0),
          .theta_o = draw.between(320.0, 390.0),
          .emissivity = draw.between(0.4, 0.9),
          .theta_s = draw.between(240.0, 290.0),
          .theta = draw.between(600.0, 1200.0)};
}

// Hotter than its surroundings, colder, and between the two.
Line rate_line(int, Draw& draw) {
  Line line{.name = "rate: of convection and radiation together", .points = 4.0};
  for (const double share : {1.0, 0.1, 0.3}) {
    Case x = drawn(draw);
    x.theta *= share;
    line.questions.push_back({.function = "temperature_rate",
                              .inputs = x.inputs(),
                              .expected = {expected_rate(x)},
                              .mistakes = mistakes_in_rate(x)});
  }
  return line;
}

// Temperatures that a closed form knows; what is wrong, a rate tells at once, so that the first question is for one.
constexpr double cooling_relative = 1e-9;

void ask_cooling(Line& line, const Case& x, double t, double theta) {
  if (line.questions.empty()) {
    line.questions.push_back({.function = "temperature_rate",
                              .inputs = x.inputs(),
                              .expected = {expected_rate(x)},
                              .mistakes = mistakes_in_rate(x)});
  }
  std::vector<double> inputs = x.inputs();
  inputs.push_back(t);
  line.questions.push_back(
      {.function = "cooled",
       .inputs = inputs,
       .expected = {theta},
       .otherwise = "your rate was integrated over time: compare it with the formula of the brief, term by term"});
}

Line convection_line(int, Draw& draw) {
  Line line{.name = "convection alone: an exponential", .points = 4.0, .relative = cooling_relative};
  for (int k = 0; k < 2; ++k) {
    Case x = drawn(draw);
    x.emissivity = 0.0;
    const double tau = 1.0 / x.convection(), t = tau * draw.between(0.5, 2.0);
    ask_cooling(line, x, t, thermo::convected_temperature(x.theta, x.theta_o, tau, t));
  }
  return line;
}

// A sphere of 1 mm, 2000 kg/m^3 and 1000 J/(kg K) in surroundings of 300 K, from 1000 K to 500 K, and one of the ID's.
// The time under both is known by quadrature.
Line radiation_line(int, Draw& draw) {
  Line line{.name = "radiation: from 1000 K to 500 K in a known time", .points = 4.0, .relative = cooling_relative};
  const double m = 8000.0 / 3.0 * std::numbers::pi * 1e-9;
  const Case black{1e-3, m, 1000.0, 0.0, 300.0, 1.0, 300.0, 1000.0},
      into_nothing{1e-3, m, 1000.0, 0.0, 300.0, 1.0, 0.0, 1000.0};
  ask_cooling(line, black, 29.319567692972, 500.0);
  ask_cooling(line, into_nothing, 27.433030706813, 500.0);
  ask_cooling(line, {1e-3, m, 1000.0, 50.0, 300.0, 0.8, 300.0, 1000.0}, 10.9556577809934, 500.0);
  Case x = drawn(draw);
  x.h_c = 0.0;
  const double theta = x.theta_s + 0.4 * (x.theta - x.theta_s);
  ask_cooling(line, x, thermo::radiation_time(x.radiation(), x.theta, theta, x.theta_s), theta);
  return line;
}

// A step of the rate k a (1 - (theta/a)^p), as in the driver.
struct Step {
  double k, a, p, theta, dt;

  double rate(double x) const { return k * a * (1.0 - std::pow(x / a, p)); }
  double slope(double x) const { return -k * p * std::pow(x / a, p - 1.0); }
};

// Where the share of the rate at the end is phi: what is missing grows with x, and its root is bisected.
double step_of(const Step& s, double phi) {
  double low = 0.0, high = 10.0 * (s.a + s.theta);
  while (true) {
    const double x = 0.5 * (low + high);
    if (!(x > low && x < high)) return x;
    const double misses = x - s.theta - s.dt * (phi * s.rate(x) + (1.0 - phi) * s.rate(s.theta));
    (misses > 0.0 ? high : low) = x;
  }
}

// One step of Newton's method from the start.
double once(const Step& s, double phi) {
  return s.theta + s.dt * s.rate(s.theta) / (1.0 - phi * s.dt * s.slope(s.theta));
}

double swept(const Step& s, double phi, int sweeps) {
  double x = s.theta;
  for (int k = 0; k < sweeps; ++k) x = s.theta + s.dt * (phi * s.rate(x) + (1.0 - phi) * s.rate(s.theta));
  return x;
}

Question ask_step(const Step& s, int variant) {
  const double phi = variant == 1 ? 1.0 : 0.5;
  return {.function = "next_temperature",
          .inputs = {s.k, s.a, s.p, s.theta, s.dt},
          .expected = {step_of(s, phi)},
          .mistakes = {{{s.theta + s.dt * s.rate(s.theta)}, "an explicit step: the rate at its end is asked for"},
                       {{step_of(s, 1.5 - phi)}, "this is the step of the other variant"},
                       {{s.theta}, "the temperature does not move: how far does your iteration go?"},
                       {{once(s, phi)}, "one iteration of Newton's method: repeat it until nothing changes"},
                       {{once(s, 1.5 - phi)}, "one iteration, and of the other variant"},
                       {{swept(s, phi, 2)}, "two sweeps: repeat them until nothing changes"}},
          .otherwise =
              "put your answer into the equation of the brief: what is left over? Where dt |f'| is above 1, a "
              "fixed-point iteration runs away, and Newton's method does not"};
}

constexpr double solved = 1e-10;

// Linear, then of the fourth power, and short enough that every iteration converges.
Line mild_line(int variant, Draw& draw) {
  Line line{.name = "step: the equation solved to rounding", .points = 4.0, .relative = solved};
  for (const double p : {1.0, 4.0, 4.0}) {
    const double k = draw.between(0.5, 2.0), a = draw.between(250.0, 350.0);
    line.questions.push_back(
        ask_step({k, a, p, a * draw.between(0.3, 0.7), draw.between(0.1, 0.15) / (p * k)}, variant));
  }
  return line;
}

// Heating that is much faster than the step, then cooling.
Line stiff_line(int variant, Draw& draw) {
  Line line{.name = "step: where the rate changes much faster", .points = 4.0, .relative = solved};
  for (const auto& [start, steps] : {std::pair{0.3, 50.0}, std::pair{0.1, 5.0}, std::pair{1.2, 1.5}}) {
    const double k = draw.between(0.5, 2.0), a = draw.between(800.0, 1500.0);
    line.questions.push_back(ask_step({k, a, 4.0, a * start * draw.between(0.9, 1.0), steps / k}, variant));
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  return grading::run(argc, argv,
                      {.title = "Chapter 7: the temperature of a sphere",
                       .variants = {"a step of backward Euler, with the rate at its end",
                                    "a step of the trapezoidal rule, with the mean of the rates at both ends"},
                       .lines = {rate_line, convection_line, radiation_line, mild_line, stiff_line},
                       .calls = {{"temperature_rate", "b m c h_c theta_o emissivity theta_s theta -> rate"},
                                 {"cooled", "b m c h_c theta_o emissivity theta_s theta t -> theta"},
                                 {"next_temperature", "k a p theta dt -> theta"}}});
}
