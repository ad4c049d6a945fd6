#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <harness/rows.hpp>
#include <particulate/fluid/suspension.hpp>
#include <particulate/schemes/staggering.hpp>

/// @file
/// What cases of particles in a fluid share.

namespace verification {

/// One number against another that is known, within a share of it.
inline void match(Rows& rows, const std::string& what, double expected, double computed, double tolerance,
                  const std::string& because) {
  rows.compare(what,
               {.expected = expected, .computed = computed, .tolerance = relative(tolerance), .because = because});
}

/// @return the larger of two errors, and no number if one of them is none
inline double worse(double x, double y) { return std::isnan(x) || y <= x ? x : y; }

/// @return the staggering of a suspension: its fields in their order, each to TOL
template <class S>
particulate::schemes::Staggered in_turn(const S& both, double TOL) {
  std::vector<particulate::schemes::Field> fields{{.name = "particles", .TOL = TOL}};
  if (S::has_temperatures) fields.push_back({.name = "particle temperatures", .TOL = TOL});
  for (const char* name : {"density", "momentum", "energy"}) fields.push_back({.name = name, .TOL = TOL});
  fields.resize(both.fields());
  return particulate::schemes::Staggered(fields);
}

}  // namespace verification
