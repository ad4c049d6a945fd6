#pragma once

#include <functional>
#include <vector>

/// @file
/// The header to keep: write these functions in flux.cpp, and change nothing here. Only your variant is to be coded,
/// which the head of the score table names: run the check once to learn it.

/// A gas.
struct Gas {
  double R = 0.0;  ///< gas constant: P = rho R theta [J/(kg K)]
  double c = 0.0;  ///< heat capacity: c theta is its heat per mass [J/(kg K)]
};

/// The gas in a cell.
struct Cell {
  double rho = 0.0;    ///< density [kg/m^3]
  double u = 0.0;      ///< velocity, to the right [m/s]
  double theta = 0.0;  ///< temperature [K]
};

/// Mass, momentum and energy: what a square metre of a face lets through in a second, or how fast they grow in a cubic
/// metre of a cell.
struct Three {
  double mass = 0.0;
  double momentum = 0.0;
  double energy = 0.0;
};

/// What passes the face between two cells, from left to right, without friction and conduction.
/// @param gas    what fills them
/// @param left   the cell to the left of the face
/// @param right  the cell to the right of it
/// @return the flux of the brief, of your variant
Three face_flux(const Gas& gas, const Cell& left, const Cell& right);

/// Any flux from left to right between two cells.
using Flux = std::function<Three(const Cell& left, const Cell& right)>;

/// How fast mass, momentum and energy grow in cells that form a ring: right of the last one the first one begins again.
/// @param flux   what passes a face
/// @param cells  at least two, from left to right
/// @param h      length of each [m]
/// @return of each cell
std::vector<Three> ring_rates(const Flux& flux, const std::vector<Cell>& cells, double h);
