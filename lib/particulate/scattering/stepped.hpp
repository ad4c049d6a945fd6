#pragma once

#include <functional>

#include <particulate/scattering/trace.hpp>

namespace particulate::scattering {

/// What the monograph's stepped tracing is asked for.
struct SteppedSettings {
  double xi = 0.1;                     ///< step over the least bounding radius of a body, 0 < xi <= 0.5 [-]
  TraceSettings bounds = {};           ///< as for trace(); paths are kept at reflections
  std::function<double()> phase = {};  ///< draws the share of a step, in [0, 1), that a ray has made at its start, in
                                       ///< the order of the rays; empty: none
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const SteppedSettings& settings);

namespace detail {

// Follows one ray in steps. A ray that has come to lie in a body, and goes deeper, is reflected where it is.
template <class B, class Law>
Fate step_along(const Cloud<B>& cloud, const Law& law, const TraceSettings& bounds, double step, double first,
                std::int32_t number, Ray& ray, BlockOfRays& block) {
  Fate fate;
  const double least = bounds.least_share * ray.power;
  const auto keep = [&](std::int32_t body) {
    if (bounds.keeps_paths) block.paths.push_back({number, ray.place, ray.length, ray.power, body});
  };
  const auto go = [&](double distance) {
    ray.place += distance * ray.direction;
    ray.length += distance;
  };
  keep(-1);
  double next = first;
  std::int32_t last = -1;
  for (;; next = step) {
    const auto [to_face, face] = way_out(cloud.box(), ray);
    const double distance = std::min(next, to_face);
    if (ray.length + distance > bounds.path_length) {
      go(bounds.path_length - ray.length);
      fate.end = Fate::End::inside;
      break;
    }
    go(distance);
    if (next >= to_face) {
      fate.face = face;
      break;
    }
    const std::int32_t body = cloud.body_at(ray.place);
    if (body < 0) continue;
    const Eigen::Vector3d normal = outward_normal(cloud.bodies()[static_cast<std::size_t>(body)], ray.place);
    if (!reflect(law, normal, body, body == last, ray, fate, block)) continue;
    last = body;
    if (fate.hits > bounds.most_hits || !(ray.power > least)) {
      fate.end = Fate::End::cut_off;
      break;
    }
    keep(body);
  }
  keep(fate.end == Fate::End::cut_off ? last : -1);
  return fate;
}

// The length that steps are counted in.
template <class B>
double least_radius(const Cloud<B>& cloud) {
  double least = cloud.box().lengths.minCoeff();
  for (const B& body : cloud.bodies()) least = std::min(least, bounding_radius(body));
  return least;
}

}  // namespace detail

/// Traces rays in steps, as the monograph does: a ray moves on by \f$ s = \xi\, b \f$, and where it then lies inside of
/// a body and goes deeper, \f$ d \cdot n < 0 \f$, it is reflected there as at the surface.
///
/// @equation{R 9.3} With the ledger of trace(), to which its I_x converges with order 1: for a lone sphere
/// \f$ I_x(\xi) = I_x(0) + \xi S \f$ with stepping_slope(), where rays start at a random phase.
/// @param cloud     bodies in a box
/// @param law       constants that validate() accepts
/// @param rays      which start outside of all bodies
/// @param settings  see SteppedSettings
/// @return what became of the power
/// @throws std::invalid_argument as trace(), and for xi outside of (0, 0.5]
template <Body B, class Law>
Traced trace_in_steps(const Cloud<B>& cloud, const Law& law, const Rays& rays, const SteppedSettings& settings) {
  validate(settings);
  const double step = settings.xi * detail::least_radius(cloud);
  Eigen::VectorXd first = Eigen::VectorXd::Constant(rays.size(), step);
  if (settings.phase) {
    for (double& each : first) each *= 1.0 - settings.phase();
  }
  return detail::trace_each(cloud, law, rays, settings.bounds, [&](std::int32_t i, auto& ray, auto& block) {
    return detail::step_along(cloud, law, settings.bounds, step, first[i], i, ray, block);
  });
}

}  // namespace particulate::scattering
