// The near field's kernel without its loads and stores: what the arithmetic alone costs, for the instructions that the
// including source is compiled with.

// What the kernel does beyond it is not needed here.
#pragma GCC diagnostic ignored "-Wunused-function"
#include <particulate/laws/detail/near_field_pairs.hpp>

namespace particulate::laws::detail {
namespace {

// As many meetings of all rows with a vector of partners as N particles have; partners stand in registers, and nothing
// is known of them from one meeting to the next.
template <class Powers>
__attribute__((flatten)) double meet_bare(const Powers& powers, const PairForce& law, std::int64_t N) {
  Vector x{}, y{}, z{}, factor = Vector{} + 1.0, reaction_x{}, reaction_y{}, reaction_z{};
  for (int k = 0; k < lanes; ++k) x[k] = 0.1 + 0.05 * k, y[k] = 0.7 - 0.03 * k, z[k] = 0.2 + 0.02 * k;
  Row row[rows];
  Sums action[rows];
  Range<Vector> range;
  for (int k = 0; k < rows; ++k) row[k] = {0.5 + 0.1 * k, 0.3, 0.9, law.alpha1, law.alpha2};
  for (std::int64_t i = 0; i < N; i += rows) {
    for (std::int64_t j = i / lanes * lanes; j < N; j += lanes) {
      asm volatile("" : "+x"(x), "+x"(y), "+x"(z), "+x"(factor));
#pragma GCC unroll 4
      for (int k = 0; k < rows; ++k) {
        const Vector dx = x - row[k].x, dy = y - row[k].y, dz = z - row[k].z;
        const Vector square = dx * dx + dy * dy + dz * dz;
        range.include(square);
        const Vector over_d = force_over_distance(powers, row[k], factor, square);
        action[k].x += over_d * dx, action[k].y += over_d * dy, action[k].z += over_d * dz;
        reaction_x -= over_d * dx, reaction_y -= over_d * dy, reaction_z -= over_d * dz;
      }
    }
  }
  Vector all = reaction_x + reaction_y + reaction_z + range.smallest + range.largest;
  for (const Sums& sums : action) all += sums.x + sums.y + sums.z;
  return sum(all);
}

double bare_force(const PairForce& law, std::int64_t N) {
  double found = 0.0;
  by_powers(law, [&](const auto& powers) {
    found = meet_bare(powers, law, N);
    return true;
  });
  return found;
}

}  // namespace
}  // namespace particulate::laws::detail

// One for each set of instructions: BARE names it.
double BARE(const particulate::laws::detail::PairForce& law, std::int64_t N) {
  return particulate::laws::detail::bare_force(law, N);
}
