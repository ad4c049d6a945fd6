//! @page ch08_shared Chapter 8: What its pages share
//! @brief The parameters of the chapter, and how a flow is followed.
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
#include <particulate/report/chapter.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sampling.hpp>

namespace ch08 {

using namespace particulate;
using namespace particulate::fluid;
using schemes::State;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& Y = line.field(1e5, {"bulk_modulus", "Y of the liquid of the element", "Pa", between(1e5, 1e10), "8.1"});
  double& mu = line.field(1.0, {"mu", "viscosity of the same", "Pa s", between(1e-3, 10.0), ours});
  double& c_mu = line.field(
      5.0, {"thinning", "c_mu, how fast a liquid between walls thins as it gets warmer", "-", between(0.0, 8.0), ours});
  int& vortices =
      line.field(64, {"vortices", "cells along an edge of the box with many vortices", "-", between(32, 128), ours});
  int& files = line.field(
      10, {"files", "of that box for ParaView: one every so many of 40 pictures; 0: none", "-", between(0, 40), ours});
};

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

}  // namespace ch08
