#pragma once

#include <iosfwd>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/schemes/state.hpp>

/// @file
/// A moment of a run for other programs to show. Both formats are a few lines of text a moment, written by hand: the
/// libraries that write them are hundreds of megabytes. Numbers have the digits that give back their bits, and places
/// are those in the first period where space repeats itself.
///
///     std::ofstream film(folder / "cloud.xyz");
///     Sampling snapshots(multiples(0.1, 0.0, 1.0), [&](const State& at) { write_xyz(film, scene, at); });
///     integrate(scene, state, 1.0, scheme, control, snapshots);

namespace particulate::scenes {

/// Writes a frame of extended XYZ, of which one file holds a run: for OVITO, and ASE.
///
/// A frame has a line with N, one with what belongs to all (`Lattice`, `Origin`, `pbc`, `Time`), and a line a particle:
/// species (X, of no element), pos, velo, radius, mass, id, immovable (1 or 0), and the temperature of a scene with
/// heat. `Lattice` is there if space repeats itself in some direction; in the others it spans the particles.
///
/// @param out        where to; left as it is after the frame
/// @param particles  whose radii, masses and numbers
/// @param domain     whose periods
/// @param state      places and velocities
/// @throws std::invalid_argument if the state is not of these particles
void write_xyz(std::ostream& out, const kinematics::Particles& particles, const kinematics::Space& domain,
               const schemes::State& state);

/// Writes a file of VTK's XML PolyData (`.vtp`), one a moment: for ParaView, which plays `cloud_000.vtp`,
/// `cloud_001.vtp` and so on as a film. Points with velocity, radius, mass, id and, with heat, temperature; draw them
/// as Point Gaussian, or as Glyphs scaled by the radius.
///
/// @param out        where to
/// @param particles  whose radii, masses and numbers
/// @param domain     whose periods
/// @param state      places and velocities; its time is the field TimeValue
/// @throws std::invalid_argument if the state is not of these particles
void write_vtk(std::ostream& out, const kinematics::Particles& particles, const kinematics::Space& domain,
               const schemes::State& state);

/// Writes a frame of a scene in extended XYZ.
///
/// @param out    where to
/// @param scene  in Space
/// @param state  of it
template <class S>
void write_xyz(std::ostream& out, const S& scene, const schemes::State& state) {
  write_xyz(out, scene.particles(), scene.domain(), state);
}
/// Writes a moment of a scene as a file of VTK.
///
/// @param out    where to
/// @param scene  in Space
/// @param state  of it
template <class S>
void write_vtk(std::ostream& out, const S& scene, const schemes::State& state) {
  write_vtk(out, scene.particles(), scene.domain(), state);
}

}  // namespace particulate::scenes
