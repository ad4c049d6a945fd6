#include <particulate/scattering/snapshot.hpp>

#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>

#include <fmt/format.h>

namespace particulate::scattering {

namespace {

std::string spaced(const Eigen::Vector3d& x) { return fmt::format("{} {} {}", x[0], x[1], x[2]); }

// One value a line, value(k) of each.
template <class Value>
void add_values(std::string& text, const char* type, const char* name, int components, std::size_t count,
                const Value& value) {
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name,
                      components);
  for (std::size_t k = 0; k < count; ++k) fmt::format_to(std::back_inserter(text), "{}\n", value(k));
  text += "</DataArray>\n";
}

// The head of a file, up to the values of its points.
template <class Place>
std::string begun(std::size_t points, std::size_t vertices, std::size_t lines, const Place& place) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\">\n<Points>\n",
      points, vertices, lines);
  add_values(text, "Float64", "places", 3, points, place);
  return text + "</Points>\n";
}

// Cells of consecutive points, of which ends[k] is the first point after cell k.
void add_cells(std::string& text, const char* kind, std::size_t points, const std::vector<std::size_t>& ends) {
  text += fmt::format("<{}>\n", kind);
  add_values(text, "Int64", "connectivity", 1, points, [](std::size_t k) { return k; });
  add_values(text, "Int64", "offsets", 1, ends.size(), [&](std::size_t k) { return ends[k]; });
  text += fmt::format("</{}>\n", kind);
}

constexpr const char* the_end = "</Piece>\n</PolyData>\n</VTKFile>\n";

template <class B, class Axis, class Radii>
void write_bodies(std::ostream& out, const std::vector<B>& bodies, const Axis& axis, const Radii& radii) {
  const std::size_t N = bodies.size();
  std::string text = begun(N, N, 0, [&](std::size_t k) { return spaced(bodies[k].centre); });
  text += "<PointData>\n";
  add_values(text, "Float64", "axis", 3, N, [&](std::size_t k) { return spaced(axis(bodies[k])); });
  add_values(text, "Float64", "radii", 3, N, [&](std::size_t k) { return spaced(radii(bodies[k])); });
  text += "</PointData>\n";
  std::vector<std::size_t> ends(N);
  for (std::size_t k = 0; k < N; ++k) ends[k] = k + 1;
  add_cells(text, "Verts", N, ends);
  out << text << the_end;
}

}  // namespace

void write_vtk(std::ostream& out, const std::vector<PathPoint>& paths) {
  const std::size_t N = paths.size();
  std::vector<std::size_t> ends;
  for (std::size_t k = 1; k <= N; ++k) {
    if (k == N || paths[k].ray != paths[k - 1].ray) ends.push_back(k);
  }
  std::string text = begun(N, 0, ends.size(), [&](std::size_t k) { return spaced(paths[k].place); });
  text += "<PointData>\n";
  add_values(text, "Float64", "power", 1, N, [&](std::size_t k) { return paths[k].power; });
  add_values(text, "Float64", "length", 1, N, [&](std::size_t k) { return paths[k].length; });
  text += "</PointData>\n";
  add_cells(text, "Lines", N, ends);
  out << text << the_end;
}

void write_vtk(std::ostream& out, const std::vector<Sphere>& bodies) {
  const auto any_axis = [](const Sphere&) -> Eigen::Vector3d { return Eigen::Vector3d::UnitX(); };
  write_bodies(out, bodies, any_axis,
               [](const Sphere& body) -> Eigen::Vector3d { return Eigen::Vector3d::Constant(body.radius); });
}

void write_vtk(std::ostream& out, const std::vector<Spheroid>& bodies) {
  write_bodies(
      out, bodies, [](const Spheroid& body) { return body.axis; },
      [](const Spheroid& body) { return Eigen::Vector3d(body.polar, body.equatorial, body.equatorial); });
}

void write_vtk(std::ostream& out, const std::vector<RedCell>& bodies) {
  // Where the half thickness has its largest value, at 0.7002 of R_0, it hardly depends on the place.
  write_bodies(
      out, bodies, [](const RedCell& body) { return body.axis; },
      [](const RedCell& body) {
        return Eigen::Vector3d(half_thickness(body, 0.7002 * body.radius), body.radius, body.radius);
      });
}

}  // namespace particulate::scattering
