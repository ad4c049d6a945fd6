#include <particulate/scattering/trace.hpp>

#include <exception>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::scattering {

void validate(const TraceSettings& settings) {
  const auto require = [](bool holds, const char* what, auto given) {
    if (!holds) throw std::invalid_argument(fmt::format("tracing: {}, got {}", what, given));
  };
  require(settings.most_hits >= 0, "most_hits must not be negative", settings.most_hits);
  require(settings.least_share >= 0.0 && settings.least_share < 1.0, "least_share must lie in [0, 1)",
          settings.least_share);
  require(settings.path_length > 0.0, "path_length must be positive", settings.path_length);
  require(settings.threads >= 1 && settings.threads <= 1024, "threads must be from 1 to 1024", settings.threads);
}

void validate(const Rays& rays) {
  const Eigen::Index N = rays.size();
  if (rays.place.rows() != N || rays.direction.rows() != N) {
    throw std::invalid_argument(fmt::format("rays: each must have a place, a direction and a power, got {}, {} and {}",
                                            rays.place.rows(), rays.direction.rows(), N));
  }
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Vector3d place = rays.place.row(i), d = rays.direction.row(i);
    if (!place.allFinite()) {
      throw std::invalid_argument(
          fmt::format("rays: places must be finite, ray {} is at ({}, {}, {}) m", i, place[0], place[1], place[2]));
    }
    if (!(std::abs(d.norm() - 1.0) <= 1e-12)) {
      throw std::invalid_argument(
          fmt::format("rays: directions must be unit vectors, that of ray {} is ({}, {}, {}): divide it by its length",
                      i, d[0], d[1], d[2]));
    }
    if (!(rays.power[i] > 0.0 && std::isfinite(rays.power[i]))) {
      throw std::invalid_argument(
          fmt::format("rays: powers must be positive and finite, ray {} has {} W", i, rays.power[i]));
    }
  }
}

namespace detail {

std::pair<double, Face> way_out(const kinematics::Box& box, const Ray& ray) {
  double enter = 0.0, leave = nowhere;
  Face face = Face::x_high;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis], low = box.corner[axis] - ray.place[axis], high = low + box.lengths[axis];
    if (d == 0.0) continue;
    const double out = (d > 0.0 ? high : low) / d;
    enter = std::max(enter, (d > 0.0 ? low : high) / d);
    if (out < leave) leave = out, face = static_cast<Face>(2 * axis + (d > 0.0 ? 1 : 0));
  }
  // A ray that misses the box is already beyond it.
  return {leave >= enter ? std::max(leave, 0.0) : 0.0, face};
}

void require_inside(std::size_t i, const Bound& bound, const kinematics::Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double rounding = 1e-12 * (box.lengths[axis] + std::abs(box.corner[axis]));
    const double low = bound.centre[axis] - bound.half_extents[axis],
                 high = bound.centre[axis] + bound.half_extents[axis];
    const double begin = box.corner[axis], end = begin + box.lengths[axis];
    if (low >= begin - rounding && high <= end + rounding) continue;
    throw std::invalid_argument(fmt::format(
        "cloud: the box must contain every body, and body {} reaches from {} to {} m in direction {}, the box from {} "
        "to {} m: take a larger box",
        i, low, high, "xyz"[axis], begin, end));
  }
}

void refuse_overlap(std::int32_t one, std::int32_t other, double distance) {
  throw std::invalid_argument(fmt::format(
      "cloud: bodies must not overlap, though they may touch, and bodies {} and {}, whose centres are {} m apart, do: "
      "move one of them, or make it smaller",
      one, other, distance));
}

void refuse_start(Eigen::Index ray, std::int32_t body) {
  throw std::invalid_argument(
      fmt::format("rays: they must start outside of all bodies, and ray {} starts inside of body {}", ray, body));
}

void each_block(Eigen::Index blocks, [[maybe_unused]] int threads, const std::function<void(Eigen::Index)>& block) {
  std::exception_ptr failure;
  Eigen::Index failed = blocks;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1)
  for (Eigen::Index k = 0; k < blocks; ++k) {
    try {
      block(k);
    } catch (...) {
#pragma omp critical
      if (k < failed) failed = k, failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

void close(const std::vector<Fate>& fates, const std::vector<BlockOfRays>& blocks, Traced& traced) {
  Ledger& ledger = traced.ledger;
  for (std::size_t i = 0; i < fates.size(); ++i) {
    const auto ray = static_cast<Eigen::Index>(i);
    const double power = traced.rays.power[ray], along = traced.rays.direction(ray, 0);
    switch (fates[i].end) {
      case Fate::End::left:
        ledger.left[static_cast<std::size_t>(fates[i].face)] += power;
        break;
      case Fate::End::cut_off:
        ledger.cut_off += power;
        break;
      case Fate::End::inside:
        ledger.inside += power;
        break;
    }
    ledger.x += power * along;
    if (along > 0.0) ledger.forward += power * along;
    ledger.hits += fates[i].hits;
    ledger.hits_again += fates[i].again;
    ledger.segments += fates[i].hits + (fates[i].end == Fate::End::cut_off ? 0 : 1);
  }
  for (const BlockOfRays& block : blocks) {
    for (const Absorbed& one : block.absorbed) traced.absorbed[one.body] += one.power;
    traced.paths.insert(traced.paths.end(), block.paths.begin(), block.paths.end());
  }
  ledger.absorbed = traced.absorbed.sum();
}

}  // namespace detail

}  // namespace particulate::scattering
