#pragma once

#include <iosfwd>
#include <vector>

#include <particulate/scattering/red_cell.hpp>
#include <particulate/scattering/trace.hpp>

/// @file
/// Paths of rays and the bodies that they meet, as files of VTK's XML PolyData (`.vtp`) for ParaView: a few lines of
/// text, whose numbers have the digits that give back their bits.

namespace particulate::scattering {

/// Writes paths: a line for each ray, and at its places `power` [W] and `length` of the path up to there [m]. In
/// ParaView draw them with Tube, or colour them by their power.
///
/// @param out    where to
/// @param paths  of Traced, by ray
void write_vtk(std::ostream& out, const std::vector<PathPoint>& paths);

/// Writes bodies: a point for each, with its `axis` and its `radii` along the axis, across and across [m]. In ParaView
/// draw them as Glyphs: a sphere of radius 1, oriented by the axis and scaled by the radii.
///
/// @param out     where to
/// @param bodies  in their order
void write_vtk(std::ostream& out, const std::vector<Sphere>& bodies);
/// @copydoc write_vtk(std::ostream&, const std::vector<Sphere>&)
void write_vtk(std::ostream& out, const std::vector<Spheroid>& bodies);
/// Writes red cells likewise, with half of their largest thickness and R_0 for radii: what is drawn is a spheroid
/// without dimples.
///
/// @param out     where to
/// @param bodies  in their order
void write_vtk(std::ostream& out, const std::vector<RedCell>& bodies);

}  // namespace particulate::scattering
