#pragma once

#include <particulate/report/checks.hpp>
#include <particulate/report/command_line.hpp>
#include <particulate/report/table.hpp>

/// @file
/// The second half of chapter 3's program.

namespace ch03 {

/// Parameters of the second half.
struct Family {
  double mildness = 0.8;    ///< repulsion of the pair whose errors are looked at, attraction 1 [N m^3/kg^2], ours
  double closeness = 0.01;  ///< repulsion of the pair that passes close by [N m^3/kg^2], ours
  double accuracy = 1e-9;   ///< tolerance of its steps, for truncation and sweeps alike [-], ours
  double mu = 1000.0;       ///< damping of van der Pol's oscillator [-], its test set
  double drop = 1.0;        ///< from which a ball falls, its lowest point over the floor [m], ours
  double e = 0.5;           ///< its restitution [-], chapter 4
  int periods = 200;        ///< over which energy is watched [-], ours
};

/// Tells the command line of them.
/// @param line    the command line
/// @param family  receives what is given
void describe(particulate::report::CommandLine& line, Family& family);

/// Runs it.
/// @param p       the parameters
/// @param output  receives the tables
/// @param quick   whether fewer points and periods will do
/// @return what it claims of itself
particulate::report::Checks run(const Family& p, const particulate::report::Output& output, bool quick);

}  // namespace ch03
