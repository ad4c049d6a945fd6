#include <particulate/laws/central_field.hpp>

#include <algorithm>
#include <cstddef>

#include <particulate/laws/detail/columns.hpp>

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

}  // namespace

bool add_field(const CentralField& field, const kinematics::Space& domain, const At<>& at, Forces force) {
  const auto pair_by_pair = [&] { return add_field<kinematics::Space>(field, domain, at, force); };
  const Eigen::Index N = at.mass.size();
  const kinematics::CentralForce& law = field.per_mass;
  if (N == 0 || field.centre.empty() || (law.alpha1 == 0.0 && law.alpha2 == 0.0)) return true;
  if (kinematics::has_periods(domain)) return pair_by_pair();
  const detail::PairForce pair{law.alpha1, law.alpha2, law.beta1, law.beta2, field.d_ref};
  const detail::AddPairs add_pairs = detail::add_pairs_of(field.kernel, N);
  const detail::Columns particles = detail::filled(at.scratch, at.position.data(), at.mass.data(), N);
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
  return detail::add_components(particles, N, force);
}

}  // namespace particulate::laws
