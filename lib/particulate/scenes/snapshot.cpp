#include <particulate/scenes/snapshot.hpp>

#include <cmath>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace particulate::scenes {

namespace {

// Places in the first period, N x 3.
kinematics::Vectors shown(const kinematics::Particles& particles, const kinematics::Space& domain,
                          const schemes::State& state) {
  const Eigen::Index N = particles.size();
  if (state.r.size() != 3 * N || state.v.size() != 3 * N) {
    throw std::invalid_argument(
        fmt::format("snapshot: a state of {} particles must hold {} places and as many velocities, got {} and {}", N,
                    3 * N, state.r.size(), state.v.size()));
  }
  kinematics::Vectors places = positions(state);
  for (Eigen::Index i = 0; i < N; ++i)
    kinematics::set_vector(places, i, wrapped(domain, kinematics::vector(places, i)));
  return places;
}

// The y of a scene's state, where its particles have temperatures.
bool has_temperatures(const kinematics::Particles& particles, const schemes::State& state) {
  return particles.temperature.size() > 0 && state.y.size() == particles.size();
}

// Three numbers of a particle.
template <class Row>
std::string three(const Row& x) {
  return fmt::format("{} {} {}", x[0], x[1], x[2]);
}

// The cell that repeats itself: in directions without a period, what the particles span.
std::string cell(const kinematics::Space& domain, const kinematics::Vectors& places, const Eigen::VectorXd& radius) {
  Eigen::Vector3d corner = Eigen::Vector3d::Zero(), edges = domain.lengths;
  std::string repeats;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const bool period = std::isfinite(domain.lengths[axis]);
    repeats += period ? " T" : " F";
    if (period) continue;
    corner[axis] = places.rows() > 0 ? (places.col(axis) - radius).minCoeff() : 0.0;
    edges[axis] = places.rows() > 0 ? (places.col(axis) + radius).maxCoeff() - corner[axis] : 1.0;
  }
  const std::string pbc = fmt::format("pbc=\"{}\"", repeats.substr(1));
  if (repeats == " F F F") return pbc;
  return fmt::format("Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{}\" {}", edges[0], edges[1], edges[2], three(corner),
                     pbc);
}

template <class Value>
void data_array(std::string& text, const char* type, const char* name, int components, Eigen::Index N, Value&& value) {
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name,
                      components);
  for (Eigen::Index i = 0; i < N; ++i) fmt::format_to(std::back_inserter(text), "{}\n", value(i));
  text += "</DataArray>\n";
}

}  // namespace

void write_xyz(std::ostream& out, const kinematics::Particles& particles, const kinematics::Space& domain,
               const schemes::State& state) {
  const kinematics::Vectors places = shown(particles, domain, state);
  const schemes::VectorsOf v = velocities(state);
  const bool warm = has_temperatures(particles, state);
  std::string text =
      fmt::format("{}\n{} Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:immovable:I:1{} Time={}\n",
                  particles.size(), cell(domain, places, particles.radius), warm ? ":temperature:R:1" : "", state.t);
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    const bool held = !particles.immovable.empty() && particles.immovable[static_cast<std::size_t>(i)];
    // X: a particle of no element, for readers that look it up.
    fmt::format_to(std::back_inserter(text), "X {} {} {} {} {} {}", three(places.row(i)), three(v.row(i)),
                   particles.radius[i], particles.mass[i], i, held ? 1 : 0);
    if (warm) fmt::format_to(std::back_inserter(text), " {}", state.y[i]);
    text += '\n';
  }
  out << text;
}

void write_vtk(std::ostream& out, const kinematics::Particles& particles, const kinematics::Space& domain,
               const schemes::State& state) {
  const kinematics::Vectors places = shown(particles, domain, state);
  const schemes::VectorsOf v = velocities(state);
  const Eigen::Index N = particles.size();
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\">\n<PolyData>\n<FieldData>\n";
  text += fmt::format(
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n</FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\">\n<PointData Scalars=\"radius\" Vectors=\"velocity\">\n",
      state.t, N, N);
  data_array(text, "Float64", "velocity", 3, N, [&](Eigen::Index i) { return three(v.row(i)); });
  data_array(text, "Float64", "radius", 1, N, [&](Eigen::Index i) { return particles.radius[i]; });
  data_array(text, "Float64", "mass", 1, N, [&](Eigen::Index i) { return particles.mass[i]; });
  if (has_temperatures(particles, state)) {
    data_array(text, "Float64", "temperature", 1, N, [&](Eigen::Index i) { return state.y[i]; });
  }
  data_array(text, "Int64", "id", 1, N, [](Eigen::Index i) { return i; });
  text += "</PointData>\n<Points>\n";
  data_array(text, "Float64", "Points", 3, N, [&](Eigen::Index i) { return three(places.row(i)); });
  text += "</Points>\n<Verts>\n";
  data_array(text, "Int64", "connectivity", 1, N, [](Eigen::Index i) { return i; });
  data_array(text, "Int64", "offsets", 1, N, [](Eigen::Index i) { return i + 1; });
  out << text << "</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace particulate::scenes
