// The near field's kernel for every processor of this architecture, and what it does to a few particles.

#include <particulate/laws/detail/near_field_pairs.hpp>

namespace particulate::laws::detail {

const AddPairs add_pairs_baseline = add_pairs;
const AddPairsWithin add_pairs_within_baseline = add_pairs_within;
const AddPairsChosen add_pairs_chosen_baseline = add_pairs_chosen;

namespace {

// One particle and a handful of partners, without vector registers.
template <class Powers>
void add_row(const Powers& powers, const PairForce& law, const Columns& c, std::int64_t i, std::int64_t N,
             Range<double>& range) {
  const Row row = row_of(law, c, i);
  double x = 0.0, y = 0.0, z = 0.0;
  for (std::int64_t j = i + 1; j < N; ++j) {
    const double dx = c.x[j] - row.x, dy = c.y[j] - row.y, dz = c.z[j] - row.z;
    const double square = dx * dx + dy * dy + dz * dz;
    range.include(square);
    const double over_d = force_over_distance(powers, row, c.factor[j], square);
    x += over_d * dx, y += over_d * dy, z += over_d * dz;
    c.reaction_x[j] -= over_d * dx, c.reaction_y[j] -= over_d * dy, c.reaction_z[j] -= over_d * dz;
  }
  c.action_x[i] += x, c.action_y[i] += y, c.action_z[i] += z;
}

}  // namespace

bool add_few_pairs(const PairForce& law, const Columns& c, std::int64_t N) {
  return by_powers(law, [&](const auto& powers) {
    Range<double> range;
    for (std::int64_t i = 0; i < N; ++i) add_row(powers, law, c, i, N, range);
    return is_full(law, 1.0, range);
  });
}

}  // namespace particulate::laws::detail
