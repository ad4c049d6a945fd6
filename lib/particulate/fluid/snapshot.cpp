#include <particulate/fluid/snapshot.hpp>

#include <iterator>
#include <ostream>
#include <string>

#include <fmt/format.h>

namespace particulate::fluid {

namespace {

// Three numbers where there are fewer directions: the others are zero, or one.
template <int Dim>
std::string padded(const Vector<Dim>& x, double rest = 0.0) {
  Eigen::Vector3d all = Eigen::Vector3d::Constant(rest);
  all.head<Dim>() = x;
  return fmt::format("{} {} {}", all[0], all[1], all[2]);
}

// value(n) of each cell, in the order of its number: x fastest, as VTK has it.
template <class Value>
void add_array(std::string& text, const char* name, int components, Eigen::Index N, const Value& value) {
  text += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", name,
                      components);
  for (Eigen::Index n = 0; n < N; ++n) fmt::format_to(std::back_inserter(text), "{}\n", value(n));
  text += "</DataArray>\n";
}

}  // namespace

template <int Dim, class E, class V>
void write_vtk(std::ostream& out, const Flow<Dim, E, V>& flow, const schemes::State& state) {
  using Kind = Flow<Dim, E, V>;
  const Grid<Dim>& grid = flow.grid();
  const Eigen::Index N = grid.size();
  flow.require_size(state.y.size());
  std::string extent;  // in corners of cells; a direction that is not there has one
  Vector<Dim> h;
  for (int a = 0; a < 3; ++a) {
    extent += fmt::format("{}0 {}", a == 0 ? "" : " ", a < Dim ? grid.cells[static_cast<std::size_t>(a)] : 0);
    if (a < Dim) h[a] = grid.h(a);
  }
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\">\n"
      "<ImageData WholeExtent=\"{0}\" Origin=\"{1}\" Spacing=\"{2}\">\n<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{3}</DataArray>\n"
      "</FieldData>\n<Piece Extent=\"{0}\">\n<CellData Scalars=\"pressure\" Vectors=\"velocity\">\n",
      extent, padded(grid.corner), padded(h, 1.0), state.t);
  add_array(text, "rho", 1, N, [&](Eigen::Index n) { return state.y[n]; });
  add_array(text, "velocity", 3, N, [&](Eigen::Index n) { return padded(flow.local(state, n).v); });
  add_array(text, "pressure", 1, N, [&](Eigen::Index n) {
    if constexpr (Kind::has_heat) return pressure(flow.fluid().state, state.y[n], flow.local(state, n).theta);
    if constexpr (!Kind::has_heat) return pressure(flow.fluid().state, state.y[n]);
  });
  if constexpr (Kind::has_heat) {
    add_array(text, "temperature", 1, N, [&](Eigen::Index n) { return flow.local(state, n).theta; });
  }
  out << text << "</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

template void write_vtk(std::ostream&, const BarotropicFlow<1>&, const schemes::State&);
template void write_vtk(std::ostream&, const BarotropicFlow<2>&, const schemes::State&);
template void write_vtk(std::ostream&, const BarotropicFlow<3>&, const schemes::State&);
template void write_vtk(std::ostream&, const LiquidFlow<1>&, const schemes::State&);
template void write_vtk(std::ostream&, const LiquidFlow<2>&, const schemes::State&);
template void write_vtk(std::ostream&, const LiquidFlow<3>&, const schemes::State&);
template void write_vtk(std::ostream&, const GasFlow<1>&, const schemes::State&);
template void write_vtk(std::ostream&, const GasFlow<2>&, const schemes::State&);
template void write_vtk(std::ostream&, const GasFlow<3>&, const schemes::State&);
template void write_vtk(std::ostream&, const ThinningFlow<2>&, const schemes::State&);
template void write_vtk(std::ostream&, const ThinningFlow<3>&, const schemes::State&);

}  // namespace particulate::fluid
