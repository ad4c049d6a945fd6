#pragma once

#include <iosfwd>

#include <particulate/fluid/flow.hpp>

/// @file
/// A fluid at a moment, for other programs to show: a few lines of text whose numbers have the digits that give back
/// their bits.
///
///     std::ofstream file(folder / "flow_000.vti");
///     write_vtk(file, flow, state);

namespace particulate::fluid {

/// Writes a file of VTK's XML ImageData (`.vti`), one a moment: for ParaView, which plays `flow_000.vti`,
/// `flow_001.vti` and so on as a film. Cells have rho [kg/m^3], velocity [m/s], pressure [Pa] and, with heat,
/// temperature [K]; a velocity has three components whatever Dim. For arrows, take Cell Centers, then Glyph.
///
/// @tparam Dim  as E and V: a combination that the library compiles
/// @param out    where to
/// @param flow   whose grid and laws
/// @param state  of it; its time is the field TimeValue
/// @throws std::invalid_argument if the state is not of this flow
template <int Dim, class E, class V>
void write_vtk(std::ostream& out, const Flow<Dim, E, V>& flow, const schemes::State& state);

}  // namespace particulate::fluid
