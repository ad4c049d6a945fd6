//! @page ch08_shared Chapter 8: What its pages share
//! @brief The parameters of the chapter, an element with particles, and how a run is followed.
//! @tableofcontents
//!
//! @section ch08_parameters Parameters
//!
//! Of the monograph's liquid the range of its bulk modulus was at hand, and its thermal expansion. All other numbers
//! are our choice: a thick liquid, as heavy as water, whose sound is slow enough to be followed by a desk computer.

#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <particulate/fluid/flow.hpp>
#include <particulate/fluid/suspension.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/staggering.hpp>

namespace ch08 {

using namespace particulate;
using namespace particulate::fluid;
using schemes::State;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& Y =
      line.field(1e5, {"bulk_modulus", "Y of the element's liquid where it is alone", "Pa", between(1e5, 1e10), "8.1"});
  double& mu = line.field(1.0, {"mu", "viscosity of the same", "Pa s", between(1e-3, 10.0), ours});
  double& c_mu = line.field(
      5.0, {"thinning", "c_mu, how fast a liquid between walls thins as it gets warmer", "-", between(0.0, 8.0), ours});
  int& vortices =
      line.field(64, {"vortices", "cells along an edge of the box with many vortices", "-", between(32, 128), ours});
  int& particles = line.field(1000, {"particles", "in an element", "-", between(100, 2000), "4.1"});
  double& h_c =
      line.field(33333.0, {"convection", "h_c between them and the fluid", "W/(m^2 K)", between(0.0, 1e5), ours});
  double& near = line.field(1.0, {"near", "strength of their near field, over 0.5 of attraction and 0.1 of repulsion",
                                  "-", between(0.0, 2.0), ours});
  int& files =
      line.field(10, {"files", "for ParaView: one every so many of 40 pictures; 0: none", "-", between(0, 40), ours});
};

//! @section ch08_hot An element with hot particles (8.5)
//!
//! A periodic cube of 1 m, \f$ N_p \f$ spheres of 2000 kg/m^3 and of the radius \f$ b = \tfrac14 N_p^{-1/3} \f$ m, put
//! in at random (@ref ch04_simulations "chapter 4"), at 600 K, and with the velocities (1, 0.1, 0.1) m/s, each
//! component give or take as much again. The fluid is the soft liquid of the next pages, at rest and at 300 K. A near
//! field attracts as 1/d and repels as \f$ 1/d^2 \f$, in balance at \f$ d_e = 0.2 \f$ m, twice the mean spacing. It
//! ends softly at 0.45 m, before half the edge of the box, as each sees the nearest image of another only. Spheres do
//! not collide: there are few of them.
//!
//! The coefficient \f$ h_c \f$ is not physical at this size: no liquid carries heat off so fast. It is chosen so that
//! particles cool within the second that is shown, and one picture shows how they slow down and cool.

using Element = Suspension<LiquidFlow<3>, HeatExchange, laws::NearField>;

struct Makeup {
  Eigen::Index n = 16;  // cells along an edge
  double near = 0.0;    // strength of the near field, over 0.5 and 0.1
  double d_c = 0.45;    // where it ends [m]
  double w = 1.0 / 8;   // half-width of hats [m]
  double Y = 1e5;       // [Pa]
};

Element element_of(const Parameters& p, const Makeup& makeup);
State start_of(const Element& element);

// p: a sweep contracts as its step to this power, as far as density, momentum and energy tell.
inline schemes::Staggered all_in_turn(int p) {
  return schemes::Staggered({{.name = "particles"},
                             {.name = "particle temperatures"},
                             {.name = "density", .p = p},
                             {.name = "momentum", .p = p},
                             {.name = "energy", .p = p}});
}

//! The step that a mechanism allows a scheme; nothing where the scheme does not mind.

inline report::Cell step_of(double spans, const schemes::TimeScale& one) {
  return std::isfinite(spans) ? report::Cell(spans * one.seconds) : report::Cell();
}

//! @section ch08_following Following a flow
//!
//! Runs that are about the flow, and not about steps, take three quarters of a step that all mechanisms together allow
//! the classical Runge-Kutta scheme: \f$ 1/\Delta t = \sum_k 1/\Delta t_k \f$ over the fluid's time scales
//! (particulate::fluid::Flow::step_limits) is on the safe side of any combination.

template <class F>
double modest_step(const F& flow, const State& at) {
  double rate = 0.0;
  for (const schemes::TimeScale& one : flow.step_limits(at)) {
    rate += 1.0 / (schemes::RungeKutta4::spans(one.kind, 0) * one.seconds);
  }
  return 0.75 / rate;
}

//! `receive` gets the state at each of the times.

template <class F, class Receive>
void follow(const char* what, const F& flow, State& state, const std::vector<double>& times, const Receive& receive) {
  report::Progress progress(what, times.back());
  schemes::Sampling samples(times, [&](const State& at) {
    receive(at);
    progress.at(at.t);
  });
  const schemes::Outcome outcome = integrate(flow, state, times.back(), schemes::RungeKutta4{},
                                             schemes::FixedStep{.step = modest_step(flow, state)}, samples);
  if (outcome.status != schemes::Status::reached)
    throw std::runtime_error(std::string(what) + ": " + describe(outcome));
}

inline std::vector<double> equal_times(double end, int pieces) {
  std::vector<double> times;
  for (int k = 0; k <= pieces; ++k) times.push_back(end * k / pieces);
  return times;
}

//! A page is a function. It writes its tables and adds what it claims.

void flow_alone(const Parameters& p, report::Chapter& chapter);
void steps(const Parameters& p, report::Chapter& chapter);
void drag(const Parameters& p, report::Chapter& chapter);
void element_with_particles(const Parameters& p, report::Chapter& chapter);
void steps_with_particles(const Parameters& p, report::Chapter& chapter);

}  // namespace ch08
