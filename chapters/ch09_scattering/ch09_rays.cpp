//! @page ch09_rays Chapter 9: A beam on its way
//! @brief Where the rays of a beam are, what they carry, and what has become of their power, at times on the way.
//! @tableofcontents
//!
//! @section ch09_rays_question Rays on their way
//!
//! Before we ask what is left, we look at what happens. All rays are as fast, so that the length of a path *is* time,
//! \f$ c\,t \f$. We stop all rays at one length and look where they are: Figure 9.6.
//!
//! @figure{ch09_progress, Rays of a beam in a cloud at four lengths of path\, seen from the side. The darker\, the more power a ray still has; a short line shows where it goes\, as long as its power.}
//!
//! @section ch09_rays_program The program

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include <particulate/report/spread.hpp>
#include <particulate/scattering/snapshot.hpp>

#include "ch09_scattering.hpp"

namespace ch09 {

//! Of what @ref ch09_way "the pages share": a path, and a ray on it.

std::vector<Path> split(const std::vector<PathPoint>& points, Eigen::Index rays) {
  std::vector<Path> paths(static_cast<std::size_t>(rays));
  for (const PathPoint& point : points) paths[static_cast<std::size_t>(point.ray)].push_back(point);
  return paths;
}

Moment moment_of(const Path& path, const Rays& at_the_end, double length) {
  const auto next =
      std::find_if(path.begin() + 1, path.end(), [&](const PathPoint& one) { return one.length > length; });
  const PathPoint& from = *(next - 1);
  Eigen::Vector3d velocity = at_the_end.direction.row(from.ray);
  if (next != path.end()) velocity = (next->place - from.place) / (next->length - from.length);
  return {from.place + (length - from.length) * velocity, velocity, from.power};
}

namespace {

void write_moments(const Traced& traced, const std::vector<Path>& paths, const report::Output& output) {
  constexpr int pictures = 48;
  constexpr double step = 0.05;  // between two pictures [m]
  report::Table table({"picture", "path length [m]", "x [m]", "y [m]", "z [m]", "d_x [-]", "d_y [-]",
                       "power over that at the start [-]"});
  for (int k = 0; k <= pictures; ++k) {
    for (std::size_t i = 0; i < std::min<std::size_t>(paths.size(), 300); ++i) {
      const Moment now = moment_of(paths[i], traced.rays, k * step);
      table.add({k, k * step, now.place[0], now.place[1], now.place[2], now.velocity[0], now.velocity[1],
                 now.power / paths[i].front().power});
    }
  }
  output.write("moments", table);
}

//! What has become of the power by then is a matter of the ledger, which counts it where it is: on its way in the
//! cloud, out through a face, or in the scatterers.

void write_ledgers(const Parameters& p, const Cloud<Sphere>& cloud, const Rays& rays, report::Chapter& chapter) {
  report::Table table({"path length [m]", "inside", "forward", "backward", "at the sides", "absorbed", "I_x/I(0)"});
  double nowhere_at_all = 0.0, off = 0.0;
  for (const double length : {0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.6, 2.0, 3.0}) {
    const Traced traced =
        trace(cloud, Fresnel{p.n_hat}, rays, {.path_length = length, .threads = p.line.common().threads});
    const Ledger& now = traced.ledger;
    const double I = now.incident;
    table.add({length, now.inside / I, now.forward_face() / I, now.backward_face() / I, now.lateral_faces() / I,
               now.absorbed / I, now.x / I});
    nowhere_at_all = report::worse_of(nowhere_at_all, std::abs(now.accounted() / I - 1.0));
    off = report::worse_of(off, (traced.rays.direction.rowwise().norm().array() - 1.0).abs().maxCoeff());
  }
  chapter.output().write("ledger", table);
  chapter.claims("checks").add("on the way: share of the beam's power that is nowhere", nowhere_at_all, 1e-12);
  chapter.claims("checks").add("on the way: speed of a ray over c, less 1", off, 1e-15);
}

//! @section ch09_paths Single rays
//!
//! To see what one ray does, we draw few, and of the spheres only those that they hit. Of the rays with two hits or
//! more those are chosen that leave their height least on so long a way, as the picture has no depth.

double slant(const Path& path) {
  const auto [low, high] = std::minmax_element(
      path.begin(), path.end(), [](const PathPoint& a, const PathPoint& b) { return a.place[2] < b.place[2]; });
  return (high->place[2] - low->place[2]) / path.back().length;
}

// A ray comes from outside of the cube, and goes on when it has left.
void write_paths(const Cloud<Sphere>& cloud, const Traced& traced, std::vector<Path> paths,
                 const report::Output& output) {
  constexpr double beyond = 0.15;  // [m]
  paths.erase(std::remove_if(paths.begin(), paths.end(), [](const Path& one) { return one.size() < 4; }), paths.end());
  std::sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return slant(a) < slant(b); });
  paths.resize(std::min<std::size_t>(paths.size(), 6));
  report::Table turns({"ray", "x [m]", "y [m]", "power over that at the start [-]"});
  report::Table hit({"x [m]", "y [m]", "radius that is seen at the height of the hit [m]"});
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Path& path = paths[i];
    const Eigen::Vector3d end = path.back().place + beyond * traced.rays.direction.row(path.back().ray).transpose();
    turns.add({i, path.front().place[0] - beyond, path.front().place[1], 1.0});
    for (std::size_t k = 0; k < path.size(); ++k) {
      turns.add({i, path[k].place[0], path[k].place[1], path[k].power / path.front().power});
      if (path[k].body < 0) continue;
      const Sphere& body = cloud.bodies()[static_cast<std::size_t>(path[k].body)];
      const double above = path[k].place[2] - body.centre[2];
      hit.add({body.centre[0], body.centre[1], std::sqrt(std::max(body.radius * body.radius - above * above, 0.0))});
    }
    turns.add({i, end[0], end[1], path.back().power / path.front().power});
  }
  output.write("turns", turns);
  output.write("hit", hit);
}

//! @section ch09_paraview The whole cloud in ParaView
//!
//! `rays.vtp` holds all paths as lines with their power, `scatterers.vtp` the spheres as points with their radii
//! (@ref snapshot.hpp "how to draw them").

template <class What>
std::string as_vtk(const std::vector<What>& what) {
  std::ostringstream out;
  write_vtk(out, what);
  return out.str();
}

}  // namespace

void progress(const Parameters& p, report::Chapter& chapter) {
  const std::function<double()> uniform = uniform_from(seed_of(p, 0));
  const Cloud<Sphere> cloud = spheres(p.L, uniform);
  const Rays rays = rays_of(beam, p.rays, uniform);
  const Traced traced = trace(cloud, Fresnel{p.n_hat}, rays, {.keeps_paths = true, .threads = p.line.common().threads});
  const std::vector<Path> paths = split(traced.paths, rays.size());
  write_moments(traced, paths, chapter.output());
  write_ledgers(p, cloud, rays, chapter);
  write_paths(cloud, traced, paths, chapter.output());
  report::Table places({"x [m]", "y [m]", "z [m]", "radius [m]"});
  for (const Sphere& body : cloud.bodies()) {
    places.add({body.centre[0], body.centre[1], body.centre[2], body.radius});
  }
  chapter.output().write("scatterers", places);
  chapter.output().write_file("rays.vtp", as_vtk(traced.paths));
  chapter.output().write_file("scatterers.vtp", as_vtk(cloud.bodies()));
  chapter.summary().add({"hits a ray in the cloud that is drawn",
                         static_cast<double>(traced.ledger.hits) / static_cast<double>(rays.size())});
}

}  // namespace ch09

//! @section ch09_rays_results What becomes of the power
//!
//! @figure{ch09_ledger, What has become of the power of the beam\, against the length of the paths.}
//!
//! @table{ch09_ledger}
//!
//! Shares of the power of the beam, save the last column. The front of the beam is eaten up within a few spacings; by
//! the time it could have crossed the cloud, about a tenth is still on its way.
//!
//! @figure{ch09_paths, Six rays and the spheres that they hit\, each cut at the height of the hit. The thinner a ray\, the less power it has.}
//!
//! @section ch09_rays_exercises Exercises
//!
//! 1. Watch the beam with `--n_hat 1.5` and `--n_hat 100`. What is the same, and what is not?
//! 2. At which length has half of the beam hit something? Compare with the mean free path, \f$ 1/(\pi b^2 n) \f$.
//! 3. Open the files in ParaView, and find a ray that is caught between two spheres for long.
