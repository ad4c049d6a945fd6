//! @page appB_cells Appendix B: Light through red blood cells
//! @brief Rays among thousands of biconcave discs: how much goes on, against the number of cells and against time.
//! @tableofcontents
//!
//! @section appB_cell A red blood cell
//!
//! At rest a red blood cell is a biconcave disc (B.2.1). Half of its thickness at the distance \f$ \rho = x R_0 \f$
//! from the axis is, after Evans and Fung,
//!
//! \f[ z = \frac{R_0}{2} \sqrt{1 - x^2}\, (C_0 + C_1 x^2 + C_2 x^4), \qquad R_0 = 3.91\ \mu\mathrm{m}, \f]
//!
//! with \f$ C_0 = 0.81/3.91 \f$, \f$ C_1 = 7.83/3.91 \f$, \f$ C_2 = -4.39/3.91 \f$ (particulate::scattering::RedCell).
//! We *count* a cell as opaque, as the monograph does: what is not reflected is lost to the beam.
//!
//! @figure{appB_cell, A cell in section\, rays in its plane that meet it\, and the normals there: Figure B.4. One ray (green) meets the cell twice.}
//!
//! @section appB_computation How rays meet it
//!
//! Put a ray into the squared form, and its places of entry are roots of a polynomial of degree ten (B.2.2). A march
//! along the ray would step over the shallow ones. Here the polynomial is written in Bernstein's form, whose
//! coefficients tell by their signs whether a part of the ray can hold a root; parts are halved until each holds one or
//! none, and Newton's iteration finishes. A ray that has just been reflected starts at a root, which is divided out: a
//! cell is not convex, and the ray may meet it again.
//!
//! @section appB_cells_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scattering/snapshot.hpp>

#include "appB_scattering.hpp"

namespace appB {
namespace {

//! One cell in section, its axis along x, and rays in the plane of the section. One of them is looked for: of those
//! that meet the cell twice the one that grazes it least.

struct Line {
  Eigen::Vector3d from, direction;
};

Line meets_twice(const RedCell& cell) {
  Line best{};
  double steepest = 0.0;
  for (int tilt = 1; tilt < 89; ++tilt) {
    const double angle = tilt * std::acos(0.0) / 90.0;
    const Eigen::Vector3d d(std::cos(angle), -std::sin(angle), 0.0);
    for (double height = -3e-6; height <= 3e-6; height += 0.1e-6) {
      const Eigen::Vector3d from = Eigen::Vector3d(-1e-6, height, 0.0) - 5e-6 * d;
      const double first = first_entry(cell, from, d);
      if (first == nowhere) continue;
      const Eigen::Vector3d place = from + first * d, n = outward_normal(cell, place);
      const Eigen::Vector3d on = (d - 2.0 * d.dot(n) * n).normalized();
      const double next = next_entry(cell, place, on);
      if (next == nowhere) continue;
      const double steep = std::min(-d.dot(n), -on.dot(outward_normal(cell, place + next * on)));
      if (steep > steepest) best = {from, d};
      steepest = std::max(steep, steepest);
    }
  }
  return best;
}

void write_section(const report::Output& output) {
  const RedCell cell{.axis = Eigen::Vector3d::UnitX()};
  report::Table outline({"rho [um]", "half thickness [um]"});
  for (int k = -200; k <= 200; ++k) {
    const double rho = std::sin(k * std::acos(0.0) / 200.0) * cell.radius;
    outline.add({1e6 * rho, 1e6 * half_thickness(cell, std::abs(rho))});
  }
  output.write("outline", outline);
  const kinematics::Box box{.lengths = Eigen::Vector3d::Constant(20e-6), .corner = Eigen::Vector3d::Constant(-10e-6)};
  const Cloud<RedCell> alone({cell}, box);
  std::vector<Line> lines{meets_twice(cell)};
  for (const double height : {-3.6e-6, -1.05e-6, 1.6e-6, 3.2e-6}) {  // [m]
    lines.push_back({{-6e-6, height + 1.5e-6, 0.0}, {0.96, -0.28, 0.0}});
  }
  const auto n = static_cast<Eigen::Index>(lines.size());
  Rays rays{
      .place = kinematics::Vectors(n, 3), .direction = kinematics::Vectors(n, 3), .power = Eigen::VectorXd::Ones(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    rays.place.row(i) = lines[static_cast<std::size_t>(i)].from.transpose();
    rays.direction.row(i) = lines[static_cast<std::size_t>(i)].direction.transpose();
  }
  report::Table turns({"ray", "x [um]", "y [um]", "n_x", "n_y"});
  for (const PathPoint& point : trace(alone, Fresnel{}, rays, {.keeps_paths = true}).paths) {
    const Eigen::Vector3d normal = outward_normal(cell, point.place);
    turns.add({point.ray, 1e6 * point.place[0], 1e6 * point.place[1], normal[0], normal[1]});
  }
  output.write("section", turns);
}

//! @section appB_time Time
//!
//! The monograph's example (B.2.3) draws \f$ I_x(t)/\|I(0)\| \f$ for growing numbers of cells in the same volume. As
//! all rays are as fast, time is the length of their paths; we stop them at lengths up to where all have left.

constexpr std::array<double, 16> lengths{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7,
                                         0.8,  0.9, 1.0, 1.1, 1.2, 1.4, 1.7, 2.0};  // over the edge [-]

struct Crossing {
  Eigen::Index cells;
  std::array<std::vector<double>, lengths.size()> x = {};  // I_x over I(0), a number for each cloud
  std::vector<double> absorbed = {}, missed = {};          // at the end; share of the power that hit nothing
  double unaccounted = 0.0, again = 0.0, segments = 0.0;
};

void cross(const Parameters& p, int k, Crossing& crossing) {
  const std::function<double()> uniform = uniform_from(p.line.common().seed + static_cast<std::uint64_t>(k));
  const Cloud<RedCell> cloud = cells_in(p, crossing.cells, uniform);
  const Rays rays = rays_of(beam_of(p), p.rays, uniform);
  const int threads = p.line.common().threads;
  for (std::size_t j = 0; j < lengths.size(); ++j) {
    const Ledger now =
        trace(cloud, Fresnel{p.n_hat}, rays, {.path_length = lengths[j] * p.edge, .threads = threads}).ledger;
    crossing.x[j].push_back(now.x / now.incident);
    crossing.unaccounted = report::worse_of(crossing.unaccounted, std::abs(now.accounted() / now.incident - 1.0));
  }
  const Ledger end = trace(cloud, Fresnel{p.n_hat}, rays, {.threads = threads}).ledger;
  const Ledger direct = trace(cloud, Fresnel{p.n_hat}, rays, {.most_hits = 0, .threads = threads}).ledger;
  crossing.absorbed.push_back(end.absorbed / end.incident);
  crossing.missed.push_back(direct.forward_face() / direct.incident);
  crossing.again += static_cast<double>(end.hits_again);
  crossing.segments += static_cast<double>(end.segments);
}

//! Beside it stands what Beer and Lambert's law has: a cell is on the way of a ray with the chance
//! \f$ p = A \langle 1/((D - 2 h_y)(D - 2 h_z)) \rangle \f$, where A is the mean shadow of a cell, a quarter of the
//! surface of its convex hull, and h are the half extents, by orientation, by which cells keep away from the faces. Of
//! independent cells, all miss a ray with the chance \f$ e^{-Np} \f$. But cells do not overlap. The same number lies
//! less one behind another, and shades more. To second order in their density
//!
//! \f[ \ln T = -N p - \frac{(N p)^2}{2} \Big\langle \frac{X}{D - 2 h_x} \Big\rangle , \f]
//!
//! where X is how much of a ray two cells, both on its way, keep each other from: along that length they would overlap.
//! We draw cells on a ray at random for both means; the shadow is known, so that these are known well.

constexpr double mean_shadow = 32.7609034191427e-12;  // [m^2]

struct Chances {
  double p, exclusion;  // that a cell is on the way of a ray; <X/(D - 2 h_x)>
};

Chances chances(const Parameters& p) {
  const std::function<double()> uniform = uniform_from(1);
  double per_area = 0.0, excluded = 0.0;
  int hits = 0;
  const double reach = 2.0 * bounding_spheroid({}).equatorial;
  RedCell last{.centre = Eigen::Vector3d::Constant(nowhere)};
  while (hits < 40000) {
    RedCell cell{.axis = random_direction(uniform)};
    for (const int k : {1, 2}) cell.centre[k] = (2.0 * uniform() - 1.0) * cell.radius;
    if (first_entry(cell, {-2.0 * cell.radius, 0.0, 0.0}, Eigen::Vector3d::UnitX()) == nowhere) continue;
    const Eigen::Array3d room = p.edge - 2.0 * half_extents(bounding_spheroid(cell)).array();
    per_area += 1.0 / (room[1] * room[2]);
    RedCell moved = cell;
    moved.centre[0] = (2.0 * uniform() - 1.0) * reach;
    if (hits++ > 0 && !are_apart(last, moved)) excluded += 2.0 * reach / room[0];
    last = cell;
  }
  return {mean_shadow * per_area / hits, excluded / (hits - 1)};
}

void write_crossings(const Parameters& p, const std::vector<Crossing>& all, report::Chapter& chapter) {
  report::Table curves({"cells", "c t / D", "I_x/I(0)", "standard error"});
  report::Table table({"cells", "I_x/I(0) at the end", "standard error", "hit nothing", "its standard error",
                       "Beer-Lambert", "without overlap", "absorbed", "segments that meet the same cell again"});
  const Chances chance = chances(p);
  double worst = 0.0, farthest = 0.0;
  for (const Crossing& one : all) {
    curves.add({one.cells, 0.0, 1.0, 0.0});
    for (std::size_t j = 0; j < lengths.size(); ++j) {
      const report::Mean x = report::mean_of(one.x[j]);
      curves.add({one.cells, lengths[j], x.value, x.standard_error});
    }
    const report::Mean end = report::mean_of(one.x.back()), missed = report::mean_of(one.missed);
    const double depth = static_cast<double>(one.cells) * chance.p;
    const double law = std::exp(-depth - 0.5 * depth * depth * chance.exclusion);
    table.add({one.cells, end.value, end.standard_error, missed.value, missed.standard_error, std::exp(-depth), law,
               report::mean_of(one.absorbed).value, one.again / one.segments});
    worst = report::worse_of(worst, one.unaccounted);
    farthest = report::worse_of(farthest, std::abs(missed.value - law) / missed.standard_error);
  }
  chapter.output().write("crossing", curves);
  chapter.output().write("crossed", table);
  chapter.claims("checks").add("cells: share of a beam's power that is nowhere", worst, 1e-12);
  chapter.claims("checks").add("share that hits no cell, off the law of cells without overlap, in standard errors",
                               farthest, 4.0);
}

//! @section appB_drawn Rays and cells to look at
//!
//! `rays.vtp` and `cells.vtp` are for ParaView. For the figure, rays are taken as they are at four times.

template <class What>
std::string as_vtk(const std::vector<What>& what) {
  std::ostringstream out;
  write_vtk(out, what);
  return out.str();
}

// Where a plane at half height cuts cells: pieces of lines along x that lie inside of a cell.
report::Table cut_at_half_height(const Parameters& p, const Cloud<RedCell>& cloud) {
  report::Table pieces({"x / D", "to x / D", "y / D"});
  constexpr int steps = 40;  // in a radius
  for (const RedCell& cell : cloud.bodies()) {
    if (std::abs(cell.centre[2] - 0.5 * p.edge) > cell.radius) continue;
    const double h = cell.radius / steps;
    for (int j = -steps; j <= steps; j += 4) {
      int begin = steps + 1;
      for (int i = -steps; i <= steps + 1; ++i) {
        const Eigen::Vector3d place(cell.centre[0] + i * h, cell.centre[1] + j * h, 0.5 * p.edge);
        const bool inside = contains(cell, place);
        if (inside && begin > steps) begin = i;
        if (inside || begin > steps) continue;
        pieces.add({(cell.centre[0] + begin * h) / p.edge, place[0] / p.edge, place[1] / p.edge});
        begin = steps + 1;
      }
    }
  }
  return pieces;
}

void write_pictures(const Parameters& p, const report::Output& output) {
  const std::function<double()> uniform = uniform_from(p.line.common().seed);
  const Cloud<RedCell> cloud = cells_in(p, p.cells, uniform);
  const Rays rays = rays_of(beam_of(p), p.rays, uniform);
  report::Table moments({"c t / D", "x / D", "y / D", "z / D", "d_x", "d_y", "power over that at the start"});
  for (const double length : {0.15, 0.3, 0.45, 0.6}) {
    const Rays now = trace(cloud, Fresnel{p.n_hat}, rays, {.path_length = length * p.edge}).rays;
    for (Eigen::Index i = 0; i < now.size(); ++i) {
      moments.add({length, now.place(i, 0) / p.edge, now.place(i, 1) / p.edge, now.place(i, 2) / p.edge,
                   now.direction(i, 0), now.direction(i, 1), now.power[i] / rays.power[i]});
    }
  }
  output.write("moments", moments);
  output.write("slice", cut_at_half_height(p, cloud));
  output.write_file("rays.vtp", as_vtk(trace(cloud, Fresnel{p.n_hat}, rays, {.keeps_paths = true}).paths));
  output.write_file("cells.vtp", as_vtk(cloud.bodies()));
}

//! @section appB_colours Two colours
//!
//! What else could be asked of the model (B.2.4)? Light of 420 nm (violet) and of 710 nm (red) differs in what blood
//! does to it by \f$ \hat n \f$, in a model that has no more than that. We do not know the values that the monograph
//! took, and have none of its measurements; so we show what \f$ \hat n \f$ does at all. All values get the same clouds
//! and rays, so that differences between them are known far better than each of them.

void write_indices(const Parameters& p, const report::Output& output) {
  report::Table table({"n^", "I_x/I(0)", "standard error", "more than at n^ = 1.01", "its standard error"});
  std::vector<Cloud<RedCell>> clouds;
  std::vector<Rays> beams;
  for (int k = 0; k < (p.line.common().quick ? 4 : 12); ++k) {
    const std::function<double()> uniform = uniform_from(p.line.common().seed + static_cast<std::uint64_t>(k));
    clouds.push_back(cells_in(p, p.cells, uniform));
    beams.push_back(rays_of(beam_of(p), p.rays, uniform));
  }
  std::vector<double> first;
  for (const double n_hat : {1.01, 1.03, 1.05, 1.075, 1.1, 1.15, 1.2, 1.3}) {
    std::vector<double> x, more;
    for (std::size_t k = 0; k < clouds.size(); ++k) {
      const Ledger ledger = trace(clouds[k], Fresnel{n_hat}, beams[k], {.threads = p.line.common().threads}).ledger;
      x.push_back(ledger.x / ledger.incident);
      if (first.size() < clouds.size()) first.push_back(x.back());
      more.push_back(x.back() - first[k]);
    }
    const report::Mean mean = report::mean_of(x), gain = report::mean_of(more);
    table.add({n_hat, mean.value, mean.standard_error, gain.value, gain.standard_error});
  }
  output.write("indices", table);
}

}  // namespace

void cells(const Parameters& p, report::Chapter& chapter) {
  write_section(chapter.output());
  std::vector<Crossing> all;
  for (const int share : {8, 4, 2, 1}) all.push_back({.cells = p.cells / share});
  const int realizations = p.line.common().quick ? p.realizations / 4 : p.realizations;
  report::Progress progress("red cells", 4.0 * realizations);
  double done = 0.0;
  for (Crossing& one : all) {
    for (int k = 0; k < realizations; ++k) {
      cross(p, k, one);
      progress.at(++done);
    }
  }
  write_crossings(p, all, chapter);
  write_pictures(p, chapter.output());
  write_indices(p, chapter.output());
}

}  // namespace appB

//! @section appB_cells_results How much goes on
//!
//! @figure{appB_progress, Rays among the cells at four times\, cut at half height: Figure B.5. Drawn are the rays within 0.05 D of the cut; an arrow is as long as the power of its ray.}
//!
//! @figure{appB_forward, What is left along the beam against time\, for growing numbers of cells: Figure B.6.}
//!
//! @table{appB_crossed}
//!
//! Cells hardly reflect: their \f$ \hat n \f$ is near 1. What goes on is what hits nothing, to within a few parts in a
//! thousand. Each doubling of the number of cells nearly squares it, as Beer and Lambert's law has it; at 8000 cells,
//! which fill 1.6 % of the box, that law has 7 % more than what is seen, and the law of cells without overlap agrees
//! within the errors. What light a cell
//! does reflect it reflects at grazing incidence, and forward.
//!
//! @section appB_colours_results Two colours: our curve only
//!
//! @figure{appB_indices, What n^ adds to what is left along the beam\, in the same clouds\, for the largest number of cells. Figure B.7 compares such numbers with laboratory results for 420 and 710 nm\, which we do not have.}
//!
//! The monograph compares its computations with measurements in two colours, four trials each. **We have no such data,
//! and make no such comparison.** What can be said of the model: in this range \f$ \hat n \f$ changes little of what
//! goes on along the beam, so that a difference between colours would have to come from what it leaves out,
//! absorption within cells above all.
//!
//! @section appB_cells_exercises Exercises
//!
//! 1. Which share of the volume do the cells fill? At which share does Beer and Lambert's law begin to fail? (`--edge`)
//! 2. Whole blood has a share of about 45 %. Why can this program not place so many?
//! 3. Let cells transmit what they do not reflect, without bending it. What is left along the beam then?
