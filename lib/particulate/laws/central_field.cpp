#include <particulate/laws/central_field.hpp>

#include <algorithm>
#include <cstddef>

#include <particulate/laws/detail/near_field_kernels.hpp>

namespace particulate::laws {

namespace {

// Centres side by side. Their number is rounded up by copies that exert nothing.
class PaddedCentres {
 public:
  static constexpr std::size_t most = 16;
  static_assert(most % detail::padded_to == 0);

  // As many of the first ones as there is room for.
  explicit PaddedCentres(std::span<const Eigen::Vector3d> centre) : size_(std::min(centre.size(), most)) {
    for (std::size_t k = 0; k < most; ++k) {
      const Eigen::Vector3d& c = centre[std::min(k, size_ - 1)];
      x_[k] = c.x(), y_[k] = c.y(), z_[k] = c.z();
      factor_[k] = k < size_ ? 1.0 : 0.0;
    }
  }
  std::size_t size() const { return size_; }
  detail::Columns columns() { return {x_, y_, z_, factor_, unused_, unused_, unused_, unused_, unused_, unused_}; }

 private:
  std::size_t size_;
  alignas(64) double x_[most], y_[most], z_[most], factor_[most], unused_[most] = {};
};

// Particles side by side, and what is added to them.
detail::Columns filled_with(const At<>& at) {
  const Eigen::Index N = at.mass.size();
  double* const first = at.scratch.columns(8, N);
  const std::size_t stride = Scratch::stride(N);
  const auto column = [&](std::size_t k) { return first + k * stride; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(at.position.data() + static_cast<Eigen::Index>(axis) * N, N, column(axis));
  }
  std::copy_n(at.mass.data(), N, column(3));
  return {column(0), column(1), column(2), column(3), column(7), column(7), column(7), column(4), column(5), column(6)};
}

}  // namespace

bool add_field(const CentralField& field, const kinematics::Space& domain, const At<>& at, Forces force) {
  const auto pair_by_pair = [&] { return add_field<kinematics::Space>(field, domain, at, force); };
  const Eigen::Index N = at.mass.size();
  const kinematics::CentralForce& law = field.per_mass;
  if (N == 0 || field.centre.empty() || (law.alpha1 == 0.0 && law.alpha2 == 0.0)) return true;
  if (kinematics::has_periods(domain)) return pair_by_pair();
  const detail::PairForce pair{law.alpha1, law.alpha2, law.beta1, law.beta2, field.d_ref};
  const detail::AddPairs add_pairs = detail::add_pairs_of(field.kernel, N);
  const detail::Columns particles = filled_with(at);
  for (std::span<const Eigen::Vector3d> left = field.centre; !left.empty();) {
    PaddedCentres centres(left);
    const detail::Block block{.row = centres.columns(),
                              .partner = particles,
                              .rows = static_cast<std::int64_t>(centres.size()),
                              .partners = N,
                              .same = false};
    if (!add_pairs(pair, block, nullptr)) return pair_by_pair();
    left = left.subspan(centres.size());
  }
  double* const f = force.data();
  const double* const added[] = {particles.reaction_x, particles.reaction_y, particles.reaction_z};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (Eigen::Index i = 0; i < N; ++i) f[axis * N + i] += added[axis][i];
  }
  return force.allFinite();
}

}  // namespace particulate::laws
