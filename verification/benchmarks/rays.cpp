// Incoherent rays through a cloud: the first hit against Embree's user geometry, which asks the same test in double
// precision; all paths by two threads against one; red cells against spheres of the same number and fraction. Each
// ratio is the median of pairs that alternate within this run.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/core.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/red_cell.hpp>
#include <particulate/scattering/trace.hpp>

namespace scattering = particulate::scattering;

namespace {

using Eigen::Vector3d;
using Spheres = std::vector<scattering::Sphere>;

const particulate::kinematics::Addition within{.inside = particulate::kinematics::Inside::spheres};

template <class Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The median over nine pairs of the time that the other takes, in units of that of one.
template <class One, class Other>
double compare(const One& one, const Other& other) {
  std::vector<double> ratio;
  for (int k = 0; k < 9; ++k) {
    const double first = seconds(one);
    ratio.push_back(seconds(other) / first);
  }
  std::nth_element(ratio.begin(), ratio.begin() + 4, ratio.end());
  return ratio[4];
}

// A ray on its way through Embree, and what it met so far, in double precision.
struct Query {
  RTCIntersectContext context;
  Vector3d from, direction;
  double distance = scattering::nowhere;
  std::int32_t body = -1;
};

const scattering::Sphere& sphere_of(void* all, unsigned k) { return (*static_cast<const Spheres*>(all))[k]; }

void bound(const RTCBoundsFunctionArguments* given) {
  const scattering::Sphere& sphere = sphere_of(given->geometryUserPtr, given->primID);
  const auto r = static_cast<float>(sphere.radius) * (1.0f + 1e-6f);
  const Eigen::Vector3f c = sphere.centre.cast<float>();
  *given->bounds_o = {c[0] - r, c[1] - r, c[2] - r, 0.0f, c[0] + r, c[1] + r, c[2] + r, 0.0f};
}

void intersect(const RTCIntersectFunctionNArguments* given) {
  if (!given->valid[0]) return;
  auto& query = *reinterpret_cast<Query*>(given->context);
  const double t = first_entry(sphere_of(given->geometryUserPtr, given->primID), query.from, query.direction);
  if (!(t < query.distance)) return;
  query.distance = t, query.body = static_cast<std::int32_t>(given->primID);
  auto& ray = *reinterpret_cast<RTCRayHit*>(given->rayhit);
  // Rounded up, so that Embree leaves nothing out that is nearer.
  ray.ray.tfar = std::nextafter(static_cast<float>(t), std::numeric_limits<float>::infinity());
  ray.hit.geomID = given->geomID, ray.hit.primID = given->primID;
}

// Spheres, sorted by Embree as well as it can.
class Peer {
 public:
  explicit Peer(Spheres& spheres) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres.size()));
    rtcSetGeometryUserData(geometry, &spheres);
    rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  ~Peer() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }

  std::int32_t first_hit(const Vector3d& from, const Vector3d& d) const {
    Query query{.context = {}, .from = from, .direction = d};
    rtcInitIntersectContext(&query.context);
    RTCRayHit ray{};
    const Eigen::Vector3f x = from.cast<float>(), y = d.cast<float>();
    ray.ray.org_x = x[0], ray.ray.org_y = x[1], ray.ray.org_z = x[2];
    ray.ray.dir_x = y[0], ray.ray.dir_y = y[1], ray.ray.dir_z = y[2];
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &query.context, &ray);
    return query.body;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

template <class Uniform>
void first_hits(Eigen::Index N, const Uniform& uniform) {
  constexpr std::size_t rays = 200000;
  Spheres spheres = scattering::place_spheres(N, 0.325 / std::cbrt(static_cast<double>(N)), within, uniform).bodies;
  const scattering::Cloud<scattering::Sphere> cloud(spheres, {});
  const Peer peer(spheres);
  std::vector<Vector3d> from, direction;
  while (from.size() < rays) {
    const double x = uniform(), y = uniform(), z = uniform();
    if (cloud.body_at({x, y, z}) >= 0) continue;
    from.emplace_back(x, y, z), direction.push_back(scattering::random_direction(uniform));
  }
  std::vector<std::int32_t> ours(rays), theirs(rays);
  const double ratio = compare(
      [&] {
        for (std::size_t k = 0; k < rays; ++k) ours[k] = cloud.first_hit(from[k], direction[k]).body;
      },
      [&] {
        for (std::size_t k = 0; k < rays; ++k) theirs[k] = peer.first_hit(from[k], direction[k]);
      });
  long different = 0;
  for (std::size_t k = 0; k < rays; ++k) different += ours[k] != theirs[k] ? 1 : 0;
  fmt::print("first hits among {} spheres: Embree takes {:.2f} times as long; {} of {} hits differ\n", N, ratio,
             different, rays);
}

template <class Uniform>
void paths(const Uniform& uniform) {
  constexpr Eigen::Index N = 1000;
  const scattering::RedCell cell{.radius = 0.02};
  // As many spheres, of the volume of a cell.
  const double radius = std::cbrt(volume(cell) / volume(scattering::Sphere{.radius = 1.0}));
  const scattering::Cloud<scattering::RedCell> cells(scattering::place_red_cells(N, cell, within, uniform).bodies, {});
  const scattering::Cloud<scattering::Sphere> spheres(scattering::place_spheres(N, radius, within, uniform).bodies, {});
  const scattering::Beam beam{.centre = {0.0, 0.5, 0.5}};
  const scattering::Rays rays = rays_of(beam, 100000, uniform);
  const scattering::Fresnel law{.n_hat = 1.5};
  std::int64_t by_spheres = 0, by_cells = 0;
  const auto through_spheres = [&](int threads) {
    return trace(spheres, law, rays, {.threads = threads}).ledger.segments;
  };
  const double longer =
      compare([&] { by_spheres = through_spheres(1); }, [&] { by_cells = trace(cells, law, rays).ledger.segments; });
  fmt::print("red cells, segments a second in units of those of spheres of equal volume: {:.2f}\n",
             static_cast<double>(by_cells) / static_cast<double>(by_spheres) / longer);
  fmt::print("two threads in units of one, time: {:.2f}\n",
             compare([&] { by_spheres = through_spheres(1); }, [&] { by_spheres = through_spheres(2); }));
}

}  // namespace

int main() {
  boost::random::mt19937_64 engine(1);
  boost::random::uniform_01<double> distribution;
  const auto uniform = [&] { return distribution(engine); };
  for (const Eigen::Index N : {1000, 10000}) first_hits(N, uniform);
  paths(uniform);
}
