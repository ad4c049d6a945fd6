#include <particulate/fluid/suspension.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::fluid::detail {

Eigen::VectorXd half_widths(const kinematics::Particles& particles, const Spreading& spreading) {
  if (spreading.w) return Eigen::VectorXd::Constant(particles.size(), *spreading.w);
  return 5.0 * particles.radius;
}

void require_corrected(const Eigen::VectorXd& half_width, const Eigen::VectorXd& radius) {
  for (Eigen::Index i = 0; i < radius.size(); ++i) {
    if (half_width[i] >= 2.0 * radius[i]) continue;
    throw std::invalid_argument(fmt::format(
        "suspension: the correction of the disturbance that a particle sees of itself needs a half-width of at least "
        "two radii, got {:.6g} m for particle {} of radius {:.6g} m: take a larger w, or no correction",
        half_width[i], i, radius[i]));
  }
}

void require_no_overlap(const kinematics::Space& domain, const kinematics::Particles& particles) {
  laws::Scratch scratch;
  const Eigen::VectorXd inverse_mass = inverse_masses(particles);
  const laws::At<laws::Velocity> at{{.t = 0.0,
                                     .position = {particles.position.data(), particles.size(), 3},
                                     .mass = particles.mass,
                                     .radius = particles.radius,
                                     .inverse_mass = inverse_mass,
                                     .scratch = scratch},
                                    {particles.velocity.data(), particles.size(), 3}};
  const contact::Touching touching = contact::find_touching(domain, at);
  const auto deepest = std::max_element(touching.contacts.begin(), touching.contacts.end(),
                                        [](const auto& a, const auto& b) { return a.overlap < b.overlap; });
  if (deepest == touching.contacts.end()) return;
  const double smaller = std::min(particles.radius[deepest->i],
                                  deepest->j < 0 ? particles.radius[deepest->i] : particles.radius[deepest->j]);
  if (deepest->overlap <= 1e-12 * smaller) return;
  throw std::invalid_argument(fmt::format(
      "suspension: no two particles may overlap at the start, nor a particle and a wall; particle {} overlaps {} by "
      "{:.6g} m: place them apart",
      deepest->i, deepest->j < 0 ? "a wall" : fmt::format("particle {}", deepest->j), deepest->overlap));
}

void refuse_size(Eigen::Index r, Eigen::Index v, Eigen::Index y, Eigen::Index N, Eigen::Index expected) {
  throw std::invalid_argument(fmt::format(
      "suspension: a state of {} particles must hold {} numbers of places and as many of velocities, and in "
      "y {} of the fluid and of temperatures, got {}, {} and {}",
      N, 3 * N, expected, r, v, y));
}

void refuse_order(std::size_t k) {
  throw std::invalid_argument(
      fmt::format("suspension: fields must be solved in their order in each sweep, from the particles on, because the "
                  "fluid gets what they just lost; got field {} of a step whose particles were not solved",
                  k));
}

void refuse_viscosity(double mu) {
  throw std::invalid_argument(
      fmt::format("suspension: drag asks for the viscosity of the fluid, which must be positive, got {} Pa s", mu));
}

std::string outside(Eigen::Index particle, const Eigen::Vector3d& place) {
  return fmt::format(
      "particle {} at ({:.6g}, {:.6g}, {:.6g}) m is outside of the box, which does not begin again there, or too far "
      "away to tell its cell: end the run where it leaves, take a larger box, or keep it in by a contact with the "
      "box's "
      "walls",
      particle, place.x(), place.y(), place.z());
}

template <int Dim>
kinematics::Space domain_of(const Grid<Dim>& grid, const Boundaries<Dim>& boundaries) {
  kinematics::Space space;
  for (int face = 0; face < 2 * Dim; ++face) {
    const int a = face / 2;
    const Boundary<Dim>& here = boundaries[static_cast<std::size_t>(face)];
    if (std::holds_alternative<Periodic>(here)) space.lengths[a] = grid.lengths[a];
    if (!std::holds_alternative<Wall<Dim>>(here)) continue;
    kinematics::Wall wall{.point = Eigen::Vector3d::Zero(), .normal = Eigen::Vector3d::Zero()};
    wall.point[a] = grid.corner[a] + (face % 2 == 1 ? grid.lengths[a] : 0.0);
    wall.normal[a] = face % 2 == 1 ? -1.0 : 1.0;
    space.walls.push_back(wall);
  }
  return space;
}

template <int Dim>
Loads loads(const Exchange::Rates& rates, const Hats<Dim>& hats, const Eigen::MatrixX2d& weight) {
  const Eigen::Index N = hats.size(), cells = weight.rows();
  const int columns = rates.heat.size() > 0 ? 4 : 2;
  Eigen::MatrixXd of_particles(columns, N), of_cells = Eigen::MatrixXd::Zero(cells, columns);
  of_particles.row(0) = rates.mass, of_particles.row(1) = rates.drag;
  if (columns == 4) of_particles.row(2) = rates.capacity, of_particles.row(3) = rates.heat;
  hats.spread(of_particles.data(), columns, columns, 1.0, of_cells.data());
  for (int c = 0; c < columns; ++c) of_cells.col(c).array() /= weight.col(c / 2).array();
  hats.gather(hats.columns(of_cells.data(), columns), of_particles.data());
  Loads all;
  const auto load = [](double Lambda, double R) { return Lambda > 1.0 ? R * (1.0 - 1.0 / Lambda) : 0.0; };
  for (Eigen::Index i = 0; i < N; ++i) {
    all.relaxes = std::max(all.relaxes, rates.relaxes[i] + of_particles(1, i));
    all.loads = std::max(all.loads, load(of_particles(0, i), of_particles(1, i)));
    if (columns == 2) continue;
    all.cools = std::max(all.cools, rates.cools[i] + of_particles(3, i));
    all.warms = std::max(all.warms, load(of_particles(2, i), of_particles(3, i)));
  }
  return all;
}

void add_scales(const Loads& loads, std::vector<schemes::TimeScale>& scales) {
  using Kind = schemes::TimeScale::Kind;
  const auto add = [&](const char* name, Kind kind, double rate) {
    if (rate > 0.0) scales.push_back({.name = name, .kind = kind, .seconds = 1.0 / rate});
  };
  add("drag", Kind::relaxes, loads.relaxes);
  add("mass of the particles against their fluid's", Kind::loads, loads.loads);
  add("heat of the particles", Kind::relaxes, loads.cools);
  add("heat capacity of the particles against their fluid's", Kind::loads, loads.warms);
}

template kinematics::Space domain_of(const Grid<1>&, const Boundaries<1>&);
template kinematics::Space domain_of(const Grid<2>&, const Boundaries<2>&);
template kinematics::Space domain_of(const Grid<3>&, const Boundaries<3>&);
template Loads loads(const Exchange::Rates&, const Hats<1>&, const Eigen::MatrixX2d&);
template Loads loads(const Exchange::Rates&, const Hats<2>&, const Eigen::MatrixX2d&);
template Loads loads(const Exchange::Rates&, const Hats<3>&, const Eigen::MatrixX2d&);

}  // namespace particulate::fluid::detail
