#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <particulate/kinematics/particles.hpp>
#include <particulate/scattering/body.hpp>
#include <particulate/scattering/grid.hpp>
#include <particulate/scattering/interface.hpp>

namespace particulate::scattering {

/// Rays: where they are, where they go, and the power that each carries. Tracing asks for nothing but shares of it: in
/// a pulse it is an energy, and all powers below are energies.
struct Rays {
  kinematics::Vectors place = {};      ///< N x 3 [m]
  kinematics::Vectors direction = {};  ///< unit vectors, N x 3 [-]
  Eigen::VectorXd power = {};          ///< > 0, N [W]

  /// @return how many
  Eigen::Index size() const { return power.size(); }
};

/// The faces of a box by their outward normals.
enum class Face { x_low, x_high, y_low, y_high, z_low, z_high };

/// What became of the power of rays. All of it is somewhere: incident() is the sum of what left through the faces, was
/// absorbed, was cut off and is still inside, to the rounding of that sum.
struct Ledger {
  double incident = 0.0;         ///< power of all rays at the start [W]
  std::array<double, 6> left{};  ///< through each Face [W]
  double absorbed = 0.0;         ///< by bodies [W]
  double cut_off = 0.0;          ///< of rays that were given up after too many hits, or below a power [W]
  double inside = 0.0;           ///< of rays that are still on their way at the end [W]
  double x = 0.0;                ///< signed: power times the x component of the direction, of all rays at the end [W]
  double forward = 0.0;          ///< of that what points forward, d_x > 0 [W]
  std::int64_t hits = 0;         ///< reflections [-]
  std::int64_t hits_again = 0;   ///< of those by the body that the ray has just left [-]
  std::int64_t segments = 0;     ///< straight parts of all paths [-]

  /// @return what left through the face that the beam points to [W]
  double forward_face() const { return left[static_cast<std::size_t>(Face::x_high)]; }
  /// @return what came back [W]
  double backward_face() const { return left[static_cast<std::size_t>(Face::x_low)]; }
  /// @return what left at the sides [W]
  double lateral_faces() const { return left[2] + left[3] + left[4] + left[5]; }
  /// @return all that is somewhere: incident, but for rounding [W]
  double accounted() const { return forward_face() + backward_face() + lateral_faces() + absorbed + cut_off + inside; }
};

/// A place of a ray's path.
struct PathPoint {
  std::int32_t ray;       ///< its number
  Eigen::Vector3d place;  ///< [m]
  double length;          ///< of the path up to there [m]
  double power;           ///< after the reflection there [W]
  std::int32_t body;      ///< that it was reflected by there; negative: none
};

/// Bounds of tracing, and what is kept.
struct TraceSettings {
  std::int64_t most_hits =
      10000;                     ///< after which a ray is cut off, >= 0: between bodies that touch there is no end [-]
  double least_share = 0.0;      ///< of its power at the start, below which a ray is cut off, in [0, 1) [-]
  double path_length = nowhere;  ///< after which all rays are stopped, where they are; > 0 [m]
  bool keeps_paths = false;      ///< whether Traced::paths are written
  int threads = 1;               ///< that share the rays, 1 to 1024; the same bits for any number [-]
};

/// What tracing gives.
struct Traced {
  Ledger ledger;                      ///< what became of the power
  Eigen::VectorXd absorbed = {};      ///< by each body [W]
  Rays rays = {};                     ///< at the end: at the face that each left through, or where it was stopped
  std::vector<PathPoint> paths = {};  ///< by ray, from its start to its end; if they were asked for
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const TraceSettings& settings);

/// Refuses rays of which one has no place, no unit vector or no power.
///
/// @param rays  the rays
/// @throws std::invalid_argument naming the ray, what must hold and what was given
void validate(const Rays& rays);

namespace detail {

// What one ray did.
struct Fate {
  enum class End { left, cut_off, inside } end = End::left;
  Face face = Face::x_high;
  std::int64_t hits = 0, again = 0;
};

struct Absorbed {
  std::int32_t body;
  double power;
};

// What a block of rays writes, so that blocks may be traced in any order.
struct BlockOfRays {
  std::vector<Absorbed> absorbed;
  std::vector<PathPoint> paths;
};

constexpr Eigen::Index rays_a_block = 256;

// A ray on its way.
struct Ray {
  Eigen::Vector3d place, direction;
  double power, length = 0.0;
};

// The distance after which a ray leaves the box, and through which face; 0 where it points away from a box that it is
// not in.
std::pair<double, Face> way_out(const kinematics::Box& box, const Ray& ray);

// Adds up what rays have become, in their order.
void close(const std::vector<Fate>& fates, const std::vector<BlockOfRays>& blocks, Traced& traced);

// Runs block(k) for every block; of several that throw, the first is heard.
void each_block(Eigen::Index blocks, int threads, const std::function<void(Eigen::Index)>& block);

void require_inside(std::size_t i, const Bound& bound, const kinematics::Box& box);
[[noreturn]] void refuse_overlap(std::int32_t one, std::int32_t other, double distance);
[[noreturn]] void refuse_start(Eigen::Index ray, std::int32_t body);

}  // namespace detail

/// Bodies in a box, sorted once, in which rays are traced as often as one likes.
///
/// @tparam B  a Body
template <Body B>
class Cloud {
 public:
  /// @param bodies   which may touch, and do not overlap
  /// @param box      which contains them
  /// @param threads  that sort them, >= 1
  /// @throws std::invalid_argument naming the body that is none or lies outside of the box, and two that overlap;
  ///         for a box that is none
  Cloud(std::vector<B> bodies, kinematics::Box box, int threads = 1)
      : bodies_(std::move(bodies)), box_(std::move(box)), grid_(box_, bounds(), threads) {
    grid_.each_pair([this](std::int32_t i, std::int32_t j) {
      const B &one = bodies_[static_cast<std::size_t>(i)], &other = bodies_[static_cast<std::size_t>(j)];
      if (!are_apart(one, other)) detail::refuse_overlap(i, j, (one.centre - other.centre).norm());
    });
  }

  /// @return the bodies
  const std::vector<B>& bodies() const { return bodies_; }
  /// @return the box
  const kinematics::Box& box() const { return box_; }

  /// What a ray meets first.
  struct Hit {
    double distance = nowhere;  ///< [m]
    std::int32_t body = -1;     ///< its number; negative: nothing
  };
  /// The first body on a ray's way.
  ///
  /// @equation{D 9.3} Exact: bodies are asked for the distance at which the ray enters them, cell by cell, until one is
  /// entered before the ray leaves a cell. Bodies that are met in several cells may be asked several times.
  /// @param from       a place outside of all bodies, or on the one that was left [m]
  /// @param direction  a unit vector
  /// @param left       the body whose surface the ray has just left; negative: none
  /// @return the nearest
  Hit first_hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, std::int32_t left = -1) const {
    Hit nearest;
    grid_.walk(from, direction, [&](std::span<const std::int32_t> here, double end) {
      for (const std::int32_t i : here) {
        const B& body = bodies_[static_cast<std::size_t>(i)];
        const double t = i == left ? next_entry(body, from, direction) : first_entry(body, from, direction);
        if (t < nearest.distance) nearest = {t, i};
      }
      return nearest.distance > end;
    });
    return nearest;
  }

  /// The body that contains a place.
  ///
  /// @param place  any [m]
  /// @return its number; negative: none
  std::int32_t body_at(const Eigen::Vector3d& place) const {
    for (const std::int32_t i : grid_.near(place)) {
      if (contains(bodies_[static_cast<std::size_t>(i)], place)) return i;
    }
    return -1;
  }

 private:
  std::vector<Bound> bounds() const {
    std::vector<Bound> all;
    all.reserve(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      validate(bodies_[i]);
      all.push_back({bodies_[i].centre, bounding_radius(bodies_[i]), half_extents(bodies_[i])});
      detail::require_inside(i, all.back(), box_);
    }
    return all;
  }

  std::vector<B> bodies_;
  kinematics::Box box_;
  Grid grid_;
};

namespace detail {

// Reflects a ray at a surface: the ray keeps R of its power, the body gets the rest. False: it leads away from the
// surface already.
template <class Law>
bool reflect(const Law& law, const Eigen::Vector3d& normal, std::int32_t body, bool again, Ray& ray, Fate& fate,
             BlockOfRays& block) {
  const double approach = -ray.direction.dot(normal);
  if (!(approach >= 0.0)) return false;
  const double R = reflectance(law, std::min(approach, 1.0));
  block.absorbed.push_back({body, (1.0 - R) * ray.power});
  ray.power *= R;
  ray.direction = (ray.direction + 2.0 * approach * normal).normalized();
  ++fate.hits;
  fate.again += again ? 1 : 0;
  return true;
}

// Follows one ray from body to body.
template <class B, class Law>
Fate follow(const Cloud<B>& cloud, const Law& law, const TraceSettings& settings, std::int32_t number, Ray& ray,
            BlockOfRays& block) {
  Fate fate;
  const double least = settings.least_share * ray.power;
  const auto keep = [&](std::int32_t body) {
    if (settings.keeps_paths) block.paths.push_back({number, ray.place, ray.length, ray.power, body});
  };
  const auto go = [&](double distance) {
    ray.place += distance * ray.direction;
    ray.length += distance;
  };
  keep(-1);
  std::int32_t left = -1;
  while (true) {
    const auto [distance, body] = cloud.first_hit(ray.place, ray.direction, left);
    const auto [way, face] = body < 0 ? way_out(cloud.box(), ray) : std::pair{distance, Face::x_low};
    if (ray.length + way > settings.path_length) {
      go(settings.path_length - ray.length);
      fate.end = Fate::End::inside;
      break;
    }
    go(way);
    if (body < 0) {
      fate.face = face;
      break;
    }
    // At grazing incidence rounding may turn the normal by more than the angle.
    const Eigen::Vector3d normal = outward_normal(cloud.bodies()[static_cast<std::size_t>(body)], ray.place);
    if (!reflect(law, normal, body, body == left, ray, fate, block)) ++fate.hits;
    left = body;
    if (fate.hits > settings.most_hits || !(ray.power > least)) {
      fate.end = Fate::End::cut_off;
      break;
    }
    keep(body);
  }
  keep(fate.end == Fate::End::cut_off ? left : -1);
  return fate;
}

// Follows all rays, block by block: follow_one(number, ray, block).
template <class B, class Law, class FollowOne>
Traced trace_each(const Cloud<B>& cloud, const Law& law, const Rays& rays, const TraceSettings& settings,
                  const FollowOne& follow_one) {
  validate(law);
  validate(rays);
  validate(settings);
  const Eigen::Index N = rays.size(), blocks = (N + rays_a_block - 1) / rays_a_block;
  Traced traced{
      .ledger = {}, .absorbed = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(cloud.bodies().size())), .rays = rays};
  traced.ledger.incident = rays.power.sum();
  std::vector<Fate> fates(static_cast<std::size_t>(N));
  std::vector<BlockOfRays> written(static_cast<std::size_t>(blocks));
  each_block(blocks, settings.threads, [&](Eigen::Index k) {
    const Eigen::Index end = std::min(N, (k + 1) * rays_a_block);
    for (Eigen::Index i = k * rays_a_block; i < end; ++i) {
      Ray ray{.place = rays.place.row(i), .direction = rays.direction.row(i), .power = rays.power[i]};
      if (const std::int32_t body = cloud.body_at(ray.place); body >= 0) refuse_start(i, body);
      fates[static_cast<std::size_t>(i)] =
          follow_one(static_cast<std::int32_t>(i), ray, written[static_cast<std::size_t>(k)]);
      traced.rays.place.row(i) = ray.place;
      traced.rays.direction.row(i) = ray.direction;
      traced.rays.power[i] = ray.power;
    }
  });
  close(fates, written, traced);
  return traced;
}

}  // namespace detail

/// Traces rays through a cloud of opaque bodies until they have left its box.
///
/// At a body a ray keeps R I of its power I, the body absorbs (1 - R) I, and the direction is that of a mirror. Each
/// ray is followed from event to event, without steps.
///
/// @equation{R 9.3} The monograph's quantity is Ledger::x over Ledger::incident.
/// @tparam B    a Body
/// @tparam Law  with reflectance(law, cos_incidence)
/// @param cloud     bodies in a box
/// @param law       constants that validate() accepts
/// @param rays      which start outside of all bodies; those that miss the box leave at once
/// @param settings  see TraceSettings
/// @return what became of the power; sums are formed in the order of the rays
/// @throws std::invalid_argument for a law, rays or settings that cannot be meant, and naming a ray that starts inside
///         of a body, and that body
template <Body B, class Law>
Traced trace(const Cloud<B>& cloud, const Law& law, const Rays& rays, const TraceSettings& settings = {}) {
  return detail::trace_each(cloud, law, rays, settings, [&](std::int32_t i, auto& ray, auto& block) {
    return detail::follow(cloud, law, settings, i, ray, block);
  });
}

}  // namespace particulate::scattering
