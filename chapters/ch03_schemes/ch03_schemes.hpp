//! @page ch03_shared Chapter 3: What its pages share
//! @brief The parameters of the chapter, its problems, and a control that keeps a log.
//! @tableofcontents
//!
//! @section ch03_parameters Parameters
//!
//! A parameter stands once: its default, the name of its option, its meaning, unit, range and source.

#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <particulate/kinematics/breathing.hpp>
#include <particulate/report/checks.hpp>
#include <particulate/report/command_line.hpp>
#include <particulate/report/output.hpp>
#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/sweeps.hpp>

namespace ch03 {

using namespace particulate;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& TOL = line.field(1e-6, {"tolerance", "tolerance of the sweeps, TOL", "-", between(1e-6, 1e-2), ours});
  int& K_d = line.field(5, {"desired", "contractions a step should take, K_d", "-", between(3, 100), ours});
  double& limit = line.field(
      0.01, {"limit", "longest step Dt_lim, as a share of the pair's period", "-", between(1e-3, 0.1), ours});
  double& stiffness = line.field(
      0.1, {"stiffness", "repulsion of the steered pair, attraction 1", "N m^3/kg^2", between(0.05, 0.6), ours});
  double& softness =
      line.field(0.5, {"softness", "repulsion where errors are looked at", "N m^3/kg^2", between(0.2, 0.5), ours});
  double& rough = line.field(0.004, {"rough", "longest step of the run that is wrong, as a share of the period", "-",
                                     between(0.004, 0.1), ours});
  int& springs =
      line.field(8, {"springs", "springs of different stiffness in one problem", "-", between(1, 100), ours});
  int& sweeps = line.field(21, {"sweeps", "sweeps whose errors are drawn", "-", between(10, 60), ours});
  double& coupling =
      line.field(3.0, {"coupling", "a_12 = -a_21 of two decaying fields", "1/s", between(1.5, 20.0), ours});
  double& beyond = line.field(
      1.002, {"beyond", "step of these fields over the last that contracts", "-", between(1.001, 2.0), ours});
  double& duration = line.field(4.0, {"duration", "duration of their decay", "s", between(1.0, 20.0), ours});
  double& mildness = line.field(0.8, {"mildness", "repulsion of the pair whose errors are looked at, attraction 1",
                                      "N m^3/kg^2", between(0.6, 0.95), ours});
  double& closeness = line.field(0.01, {"closeness", "repulsion of the pair that passes close by, attraction 1",
                                        "N m^3/kg^2", between(1e-3, 0.5), ours});
  double& accuracy = line.field(
      1e-9, {"accuracy", "accuracy of that pair's steps, for truncation and sweeps", "-", between(1e-12, 1e-4), ours});
  double& mu =
      line.field(1000.0, {"mu", "damping of van der Pol's oscillator", "-", between(1.0, 1e5), "its test set"});
  double& drop = line.field(1.0, {"drop", "height from which a ball falls", "m", between(0.01, 100.0), ours});
  double& e = line.field(0.5, {"restitution", "restitution of the ball", "-", between(0.1, 0.9), "chapter 4"});
  int& periods = line.field(200, {"periods", "periods over which energy is watched", "-", between(20, 10000), ours});
};

//! A page is a function of these. It writes its tables, and adds what it claims to a particulate::report::Checks: the
//! error that was seen and the error that is allowed. Comparisons are written so that a NaN fails them.

void stability(const Parameters& p, const report::Output& output, bool quick, report::Checks& checks);
void control(const Parameters& p, const report::Output& output, report::Checks& checks);
void staggering(const Parameters& p, const report::Output& output, report::Checks& checks);
void family(const Parameters& p, const report::Output& output, bool quick, report::Checks& checks);
void stiffness_and_errors(const Parameters& p, const report::Output& output, report::Checks& checks);
void contacts(const Parameters& p, const report::Output& output, bool quick, report::Checks& checks);

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

inline double larger(double worst, double x) { return x <= worst || std::isnan(worst) ? worst : x; }

//! @section ch03_problems Problems
//!
//! Problems are small structs. These springs pull unit masses to the origin, the stiffest with the frequency
//! \f$ \omega = 1 \f$ per second, so that \f$ \omega\,\Delta t \f$ is the step:

struct Springs {
  Eigen::VectorXd squared;  // frequencies squared [1/s^2]
  bool acceleration(double, schemes::In r, schemes::Out a) const {
    a = -squared.cwiseProduct(r);
    return true;
  }
};

//! Real and imaginary part of one complex unknown are two real ones, so \f$ \dot y = \lambda y \f$ is a
//! particulate::schemes::FirstOrderPair, with \f$ z = \lambda\,\Delta t \f$ over a step of one second:

inline schemes::FirstOrderPair plane(std::complex<double> z) {
  return {.a = Eigen::Matrix2d{{-z.real(), z.imag()}, {-z.imag(), -z.real()}}};
}

//! Two bodies of mass one fall together and part again. All that moves is their separation, whose exact motion is known
//! (@ref ch01_breathing "chapter 1"), and so is its energy:

struct Separation {
  kinematics::RadialForce force;
  bool acceleration(double, schemes::In r, schemes::Out a) const {
    a[0] = (force.B / r[0] - force.A) / (r[0] * r[0]);
    return r[0] > 0.0;
  }
  double energy(const schemes::State& at) const {
    return 0.5 * at.v[0] * at.v[0] - (force.A - 0.5 * force.B / at.r[0]) / at.r[0];
  }
};

struct Pair {
  Separation problem;
  kinematics::Breathing exact{problem.force, 1.0};
  explicit Pair(double repulsion) : problem{kinematics::breathing_pair(1.0, repulsion, 1.0, 1.0)} {}
  static schemes::State start() { return {.t = 0.0, .r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)}; }
};

//! Largest error of its separation at any step of a run, NaN if the run does not reach its end:

template <class Scheme, class Control>
std::pair<schemes::Outcome, double> follow(const Pair& pair, Scheme scheme, Control&& control, double t_end) {
  schemes::State state = Pair::start();
  double worst = 0.0;
  const schemes::Outcome outcome = schemes::integrate(
      pair.problem, state, t_end, scheme, control, [&](const auto&, const auto& to, double, const auto&) {
        worst = larger(worst, std::abs(to.r[0] - pair.exact.at(to.t).r));
        return true;
      });
  return {outcome, outcome.status == schemes::Status::reached ? worst : no_number};
}

//! @section ch03_watched Sweeps and controls, watched
//!
//! A single step by hand is the guess, then so many sweeps. What is looked at is the change of the state in each of them,
//! as a Euclidean length, and by how much two sweeps made it smaller:

inline double change(const schemes::Sweeps& made, std::size_t k) {
  const schemes::State &before = made.iterates[k], &after = made.iterates[k + 1];
  return (after.r - before.r).norm() + (after.y - before.y).norm();
}

inline double contraction_of(const schemes::Sweeps& made) { return std::sqrt(change(made, 3) / change(made, 1)); }

//! A step control is a value that answers three questions. This one lets another one decide, and writes down every
//! attempt, the refused ones too:

template <class Control>
struct Logged {
  struct Entry {
    double t;               // its start [s]
    schemes::Attempt made;  // as the control saw it
    bool accepted;          // whether it stands
    Control after;          // the control, as it left the attempt
  };
  static constexpr bool ignores_truncation = schemes::IgnoresTruncation<Control>;
  Control control;
  std::vector<Entry> entries = {};
  double t = 0.0;  // start of the next one [s]

  double dt() const { return control.dt(); }
  bool goes_on(const schemes::Iteration& it) const { return control.goes_on(it); }
  schemes::Decision judge(const schemes::Attempt& made) {
    schemes::Decision decision = control.judge(made);
    entries.push_back({t, made, decision.accepted, control});
    entries.back().made.fields = {};  // these are the scheme's, and change
    if (decision.accepted) t += made.dt;
    return decision;
  }
};

template <class Control>
void validate(const Logged<Control>& log) {
  validate(log.control);
}

using Steered = Logged<schemes::PhiControl>;  // that of section 3.4

}  // namespace ch03
