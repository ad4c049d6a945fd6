#pragma once

#include <functional>
#include <vector>

/// @file
/// The header to keep: write these functions in step_control.cpp, and change nothing here. Only your variant is to be
/// coded, which the head of the score table names: run the check once to learn it.

/// How the sweeps over one field went, in one attempted step.
struct Sweeps {
  double w_0 = 0.0;  ///< change made by the first sweep, normalized; 0 if nothing moves, infinite if it overflowed [-]
  double w_K = 0.0;  ///< change made by the last sweep, normalized; infinite or NaN if the sweeps overflowed [-]
  int K = 0;         ///< contractions between them, one less than sweeps; 0 after a single sweep [-]
  int p = 2;         ///< exponent of the step in the contraction: 2 for r'' = f(r), 1 for y' = f(y) [-]
  double TOL = 0.0;  ///< tolerance on w_K, > 0 [-]
};

/// How steps may be chosen.
struct Settings {
  int K_d = 1;          ///< contractions that are desired, and at most allowed [-]
  double limit = 0.0;   ///< no step is larger than this one [s]
  double growth = 2.0;  ///< after an accepted step the next is at most so many times as large, > 1 [-]
  double retry = 0.9;   ///< after a refused step the next is at most so many times as large, in (0, 1) [-]
  double shrink = 0.1;  ///< and at least so many times, in (0, retry) [-]
};

/// What to do with an attempted step.
struct Decision {
  bool accepted = false;  ///< whether it stands
  double next = 0.0;      ///< the step to try next: the following one if it stands, else the same once more [s]
};

/// Factor between the step that was made and the one that would have met the tolerance in exactly K_d contractions.
/// @param sweeps  of the step that was made; w_K is finite, and so is w_0; w_0 = 0 only where w_K = 0
/// @param K_d     contractions that are desired, >= 1 [-]
/// @return Phi_K; infinite if w_K = 0 or K = 0, where no contraction was seen that could be extrapolated [-]
double step_factor(const Sweeps& sweeps, int K_d);

/// Judges an attempted step and chooses the next.
/// @param dt        the step that was made, at most settings.limit [s]
/// @param fields    its sweeps: of one field in variant 1, of two staggered fields in variant 2
/// @param settings  how steps may be chosen
/// @return the decision
Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings);

/// Acceleration of a body on a line, at a place [m/s^2].
using Acceleration = std::function<double(double r)>;

/// A body on a line.
struct State {
  double r = 0.0;  ///< place [m]
  double v = 0.0;  ///< velocity [m/s]
};

/// One step of the Gauss method of two stages, solved by sweeps.
/// @param a       acceleration
/// @param from    state at the start
/// @param dt      step; a negative one goes back [s]
/// @param sweeps  so many, no more and no fewer, from the guess of free flight a_1 = a_2 = 0; each renews both
///                accelerations from those of the sweep before, >= 1 [-]
/// @return state at the end
State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps);
