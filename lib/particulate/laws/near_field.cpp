#include <particulate/laws/near_field.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/laws/detail/columns.hpp>

namespace particulate::laws {

namespace {

// What __builtin_cpu_supports() knows includes whether the operating system saves the registers.
bool processor_has(Kernel kernel) {
#ifdef __x86_64__
  if (kernel == Kernel::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (kernel == Kernel::avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  }
#endif
  return kernel == Kernel::baseline;
}

// Code of a kernel; null where this build has none.
struct Built {
  detail::AddPairs all = nullptr;
  detail::AddPairsWithin within = nullptr;
  detail::AddPairsChosen chosen = nullptr;
};

Built built(Kernel kernel) {
  switch (kernel) {
    case Kernel::best:
      break;
    case Kernel::baseline:
      return {detail::add_pairs_baseline, detail::add_pairs_within_baseline, detail::add_pairs_chosen_baseline};
    case Kernel::avx2:
      return {detail::add_pairs_avx2, detail::add_pairs_within_avx2, detail::add_pairs_chosen_avx2};
    case Kernel::avx512:
      return {detail::add_pairs_avx512, detail::add_pairs_within_avx512, detail::add_pairs_chosen_avx512};
  }
  return {};
}

std::string refusal(Kernel kernel) {
  std::string available;
  for (const Kernel each : {Kernel::baseline, Kernel::avx2, Kernel::avx512}) {
    if (is_available(each)) available.append(available.empty() ? "" : ", ").append(name(each));
  }
  return fmt::format(
      "near field: kernel must be best or one that this build has for this processor ({}), got {}; "
      "take best",
      available, name(kernel));
}

static_assert(detail::padded_to == Scratch::line);

// All pairs of many particles in blocks of so many against so many.
constexpr Eigen::Index edge = 512;
static_assert(edge % detail::padded_to == 0);

// Particles from the first one on.
detail::Columns part(const detail::Columns& all, Eigen::Index first) {
  return {.x = all.x + first,
          .y = all.y + first,
          .z = all.z + first,
          .factor = all.factor + first,
          .action_x = all.action_x + first,
          .action_y = all.action_y + first,
          .action_z = all.action_z + first,
          .reaction_x = all.reaction_x + first,
          .reaction_y = all.reaction_y + first,
          .reaction_z = all.reaction_z + first};
}

// Blocks meet in rounds: in each every block of particles meets one other, or itself, so that threads write nothing of
// each other's, and sums are formed in the order of the rounds, however many threads there are.
bool add_in_rounds(detail::AddPairs add_pairs, const detail::PairForce& pair, const detail::Columns& all,
                   Eigen::Index N, int threads, double* energy) {
  const Eigen::Index blocks = (N + edge - 1) / edge;
  std::vector<double> found(energy ? static_cast<std::size_t>(blocks * blocks) : 0);
  threads = static_cast<int>(std::clamp<Eigen::Index>(threads, 1, (blocks + 1) / 2));
  bool full = true;
#pragma omp parallel num_threads(threads) reduction(&& : full) if (threads > 1)
  for (Eigen::Index round = 0; round < blocks; ++round) {
#pragma omp for schedule(dynamic, 1)
    for (Eigen::Index row = 0; row < blocks; ++row) {
      const Eigen::Index partner = (round + blocks - row) % blocks;
      if (partner < row) continue;
      const detail::Block block{.row = part(all, row * edge),
                                .partner = part(all, partner * edge),
                                .rows = std::min(edge, N - row * edge),
                                .partners = std::min(edge, N - partner * edge),
                                .same = row == partner};
      const bool all_full =
          add_pairs(pair, block, energy ? &found[static_cast<std::size_t>(round * blocks + row)] : nullptr);
      full = full && all_full;
    }
  }
  for (const double of_block : found) *energy += of_block;
  return full;
}

// Adds one component of the forces; false if one of them is not finite, which is what times zero is not zero.
bool add_component(const double* action, const double* reaction, Eigen::Index N, double* force) {
  double zero = 0.0;
#pragma omp simd reduction(+ : zero)
  for (Eigen::Index i = 0; i < N; ++i) {
    force[i] += action[i] + reaction[i];
    zero += 0.0 * force[i];
  }
  return zero == 0.0;
}

}  // namespace

std::string_view name(Kernel kernel) {
  switch (kernel) {
    case Kernel::best:
      return "best";
    case Kernel::baseline:
      return "baseline";
    case Kernel::avx2:
      return "avx2";
    case Kernel::avx512:
      return "avx512";
  }
  return "none";
}

bool is_available(Kernel kernel) { return kernel == Kernel::best || (built(kernel).all && processor_has(kernel)); }

Kernel best_kernel() {
  if (is_available(Kernel::avx512)) return Kernel::avx512;
  return is_available(Kernel::avx2) ? Kernel::avx2 : Kernel::baseline;
}

detail::Columns detail::filled(Scratch& scratch, const double* position, const double* factor, Eigen::Index N) {
  double* const first = scratch.columns(10, N);
  const std::size_t stride = Scratch::stride(N);
  const auto column = [&](std::size_t k) { return first + k * stride; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(position + static_cast<Eigen::Index>(axis) * N, N, column(axis));
  }
  std::copy_n(factor, N, column(3));
  return {.x = column(0),
          .y = column(1),
          .z = column(2),
          .factor = column(3),
          .action_x = column(4),
          .action_y = column(5),
          .action_z = column(6),
          .reaction_x = column(7),
          .reaction_y = column(8),
          .reaction_z = column(9)};
}

bool detail::add_components(const Columns& c, Eigen::Index N, Forces force) {
  double* const f = force.data();
  return add_component(c.action_x, c.reaction_x, N, f) && add_component(c.action_y, c.reaction_y, N, f + N) &&
         add_component(c.action_z, c.reaction_z, N, f + 2 * N);
}

detail::AddPairs detail::add_pairs_of(Kernel kernel, std::int64_t N) {
  if (!is_available(kernel)) throw std::invalid_argument(refusal(kernel));
  if (N <= few) return add_pairs_baseline;
  return built(kernel == Kernel::best ? best_kernel() : kernel).all;
}

namespace {

// Where attraction and repulsion hold particles apart, the whole of both must act there: below d_e nothing attracts.
void validate_cutoff(const NearField& law) {
  const bool holds = law.alpha1 > 0.0 && law.alpha2 > 0.0 && law.beta2 > law.beta1;
  if (!std::isfinite(law.cutoff) || !holds) return;
  const kinematics::CentralForce pair = pair_law(law, 1.0, 1.0);
  const double d_e = kinematics::equilibrium_distance(pair);
  if (law.cutoff - law.taper > d_e) return;
  throw std::invalid_argument(fmt::format(
      "near field: it must act whole beyond its equilibrium distance d_e = {} m, cutoff - taper > d_e, or nothing "
      "attracts; got cutoff d_c = {} m and taper w = {} m: put the taper behind d_e, and up to the inflection "
      "d* = {} m if the law is to stay convex along the line of centres",
      d_e, law.cutoff, law.taper, kinematics::inflection_distance(pair)));
}

}  // namespace

void validate(const NearField& law) {
  validate(kinematics::CentralForce{.alpha1 = law.alpha1, .alpha2 = law.alpha2});
  for (const auto& [constant, beta] : {std::pair{"beta1", law.beta1}, {"beta2", law.beta2}}) {
    if (beta >= -1.0 && std::isfinite(beta)) continue;
    throw std::invalid_argument(fmt::format("near field: {} must be finite and at least -1, got {}", constant, beta));
  }
  if (!(law.threads >= 1 && law.threads <= 1024)) {
    throw std::invalid_argument(fmt::format("near field: threads must be from 1 to 1024, got {}", law.threads));
  }
  if (!(law.d_ref > 0.0 && std::isfinite(law.d_ref))) {
    throw std::invalid_argument(fmt::format("near field: d_ref must be positive and finite, got {} m", law.d_ref));
  }
  if (law.scaling != Scaling::mass && law.scaling != Scaling::area && law.scaling != Scaling::pair) {
    throw std::invalid_argument(
        fmt::format("near field: scaling must be mass, area or pair, got number {}", static_cast<int>(law.scaling)));
  }
  if (!(law.cutoff > 0.0)) {
    throw std::invalid_argument(fmt::format(
        "near field: cutoff must be positive, got {} m; leave it out for forces between all pairs", law.cutoff));
  }
  if (!(law.taper >= 0.0 && law.taper <= (std::isfinite(law.cutoff) ? law.cutoff : 0.0))) {
    throw std::invalid_argument(fmt::format(
        "near field: taper must lie between 0 and the cutoff, and needs a finite one, got {} m with cutoff {} m",
        law.taper, law.cutoff));
  }
  validate_cutoff(law);
  if (!is_available(law.kernel)) throw std::invalid_argument(refusal(law.kernel));
}

void validate(const NearField& law, const kinematics::Space& domain) {
  const double half = 0.5 * domain.lengths.minCoeff();
  if (reach(law) <= half) return;
  throw std::invalid_argument(fmt::format(
      "near field: where space repeats itself it must reach no farther than half the shortest period, {} m, as each "
      "pair meets in its nearest image alone; it reaches {} m: set cutoff, and a taper if the force is to end smoothly",
      half, reach(law)));
}

double potential(const NearField& law, const kinematics::CentralForce& pair, double d) {
  if (!std::isfinite(law.cutoff)) return potential(pair, d, law.d_ref);
  if (d >= law.cutoff) return 0.0;
  const double full = law.cutoff - law.taper, from = std::max(d, full);
  // Gauss's rule of eight points in ln d, in which powers are exponentials, panel by panel.
  constexpr double point[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  constexpr double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  const double length = std::log(law.cutoff / from), steepest = std::max(pair.beta1, pair.beta2) + 4.0;
  const double panels = std::clamp(std::ceil(length * steepest / 3.0), 1.0, 1000.0), half = 0.5 * length / panels;
  double tapered = 0.0;
  for (double panel = 0.0; panel < panels; ++panel) {
    const auto at = [&](double x) {
      const double there = from * std::exp((2.0 * panel + 1.0 + x) * half);
      return there * tapering(law, there) * strength(pair, there);
    };
    for (int k = 0; k < 4; ++k) tapered += half * weight[k] * (at(point[k]) + at(-point[k]));
  }
  return d < full ? potential(pair, d, full) - tapered : -tapered;
}

Candidates candidates(const NearField& law, const kinematics::Space& domain, const At<>& at) {
  const Eigen::Index N = at.mass.size();
  if (!std::isfinite(law.cutoff)) return {N, nullptr, nullptr};
  return at.scratch.neighbours.candidates(domain, at.position, Eigen::VectorXd::Constant(N, 0.5 * law.cutoff));
}

kinematics::CentralForce pair_law(const NearField& law, double factor_i, double factor_j) {
  return {.alpha1 = law.alpha1 * factor_i * factor_j,
          .alpha2 = law.alpha2 * factor_i * factor_j,
          .beta1 = law.beta1,
          .beta2 = law.beta2};
}

Eigen::VectorXd scaling_factors(const NearField& law, const At<>& at) {
  switch (law.scaling) {
    case Scaling::mass:
      return at.mass;
    case Scaling::area:
      return (4.0 * std::numbers::pi) * at.radius.cwiseAbs2();
    case Scaling::pair:
      return Eigen::VectorXd::Ones(at.mass.size());
  }
  throw std::invalid_argument("near field: scaling must be mass, area or pair");
}

std::string why_no_force(const NearField& law, const At<>& at,
                         const std::function<double(Eigen::Index, Eigen::Index)>& apart) {
  const Eigen::VectorXd factor = scaling_factors(law, at);
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    for (Eigen::Index j = i + 1; j < at.mass.size(); ++j) {
      const double d = apart(i, j);
      if (is_full(d * d) || (d >= law.cutoff && std::isfinite(law.cutoff)) || !feels(law, at, factor, i, j)) continue;
      return fmt::format(
          "near field: particles {} and {} must be some 1.5e-154 to 1.3e154 m apart, but are {} m apart: place them "
          "otherwise, or let a contact keep them apart",
          i, j, d);
    }
  }
  return {};
}

namespace {

Kernel chosen(const NearField& law) { return law.kernel == Kernel::best ? best_kernel() : law.kernel; }

detail::PairForce pair_force(const NearField& law) {
  return {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2, .d_ref = law.d_ref};
}

// scaling_factors(), but masses are not copied.
class Factors {
 public:
  Factors(const NearField& law, const At<>& at)
      : formed_(law.scaling == Scaling::mass ? Eigen::VectorXd() : scaling_factors(law, at)),
        data_(law.scaling == Scaling::mass ? at.mass.data() : formed_.data()) {}
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  const double* data() const { return data_; }

 private:
  Eigen::VectorXd formed_;
  const double* data_;
};

// All pairs of more than a few particles, and where energy is given their energy; the forces are left in the columns.
bool add_many(const NearField& law, const At<>& at, const Factors& factor, detail::Columns& c, double* energy) {
  const Eigen::Index N = at.mass.size();
  const detail::AddPairs add_pairs = built(chosen(law)).all;
  const detail::PairForce pair = pair_force(law);
  c = detail::filled(at.scratch, at.position.data(), factor.data(), N);
  if (N <= edge) return add_pairs(pair, {.row = c, .partner = c, .rows = N, .partners = N, .same = true}, energy);
  return add_in_rounds(add_pairs, pair, c, N, law.threads, energy);
}

// Forces of the pairs within reach, by the vectors of a kernel as well.
bool add_within(const NearField& law, const kinematics::Space& space, const At<>& at, const double* factor,
                Forces force) {
  const Eigen::Index N = at.mass.size();
  if (!at.position.allFinite()) return false;
  const Candidates near = candidates(law, space, at);
  const detail::Within within{.first = near.first,
                              .partner = near.partner,
                              .N = N,
                              .cutoff = law.cutoff,
                              .taper = law.taper,
                              .lengths = {space.lengths.x(), space.lengths.y(), space.lengths.z()}};
  const detail::AddPairsWithin add_pairs = built(N <= detail::few ? Kernel::baseline : chosen(law)).within;
  const detail::Columns c = detail::filled(at.scratch, at.position.data(), factor, N);
  return add_pairs(pair_force(law), within, c) ? detail::add_components(c, N, force)
                                               : add_force<kinematics::Space>(law, space, at, force);
}

// Of pairs that change much over a step: see choose_close().
constexpr double stiff = 0.07, passes = 3.0;

// Of a pair of unit strength, \sum_k (1 + \beta_k) \alpha_k d^{-\beta_k - 1}.
double stiffness_of(const NearField& law, double d) {
  return (1.0 + law.beta1) * law.alpha1 * std::pow(d, -law.beta1 - 1.0) +
         (1.0 + law.beta2) * law.alpha2 * std::pow(d, -law.beta2 - 1.0);
}

// The largest distance at which a near field is stiff, of any pair: the force changes by a share of the motion over dt.
double stiff_distance(const NearField& law, double strength, double dt) {
  const auto stiffness = [&](double d) { return dt * dt * strength * stiffness_of(law, d); };
  double low = 1e-300, high = 1e300;
  for (int k = 0; k < 100; ++k) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (stiffness(middle) > stiff ? low : high) = middle;
  }
  return low > 1e-300 ? high : 0.0;
}

}  // namespace

bool add_force(const NearField& law, const kinematics::Space& space, const At<>& at, Forces force) {
  if (!is_available(law.kernel)) throw std::invalid_argument(refusal(law.kernel));
  const Eigen::Index N = at.mass.size();
  const Factors factor(law, at);
  if (std::isfinite(law.cutoff)) return add_within(law, space, at, factor.data(), force);
  // Some pair may have no force, which matters only if it feels one.
  const auto add_those_that_feel = [&] { return add_force<kinematics::Space>(law, space, at, force); };
  if (N <= detail::few) {
    // By the baseline, so that a small scene has the same bits whatever the processor.
    const Eigen::Matrix<double, Eigen::Dynamic, 3, 0, detail::few, 3> before = force;
    const double* const r = at.position.data();
    double *const f_x = force.data(), *const f_y = f_x + N, *const f_z = f_y + N;
    const detail::Columns in_place{r, r + N, r + 2 * N, factor.data(), f_x, f_y, f_z, f_x, f_y, f_z};
    if (detail::add_few_pairs(pair_force(law), in_place, N)) return force.allFinite();
    force = before;
    return add_those_that_feel();
  }
  detail::Columns c{};
  if (!add_many(law, at, factor, c, nullptr)) return add_those_that_feel();
  return detail::add_components(c, N, force);
}

double potential_energy(const NearField& law, const kinematics::Space& space, const At<>& at) {
  if (!is_available(law.kernel)) throw std::invalid_argument(refusal(law.kernel));
  const auto pair_by_pair = [&] { return potential_energy<kinematics::Space>(law, space, at); };
  if (std::isfinite(law.cutoff) || at.mass.size() <= detail::few || !at.position.allFinite()) return pair_by_pair();
  detail::Columns c{};
  double energy = 0.0;
  const bool full = add_many(law, at, Factors(law, at), c, &energy);
  return full ? energy : pair_by_pair();
}

bool add_force_and_energy(const NearField& law, const kinematics::Space& space, const At<>& at, Forces force,
                          double& energy) {
  if (!is_available(law.kernel)) throw std::invalid_argument(refusal(law.kernel));
  if (!std::isfinite(law.cutoff) && at.mass.size() > detail::few) {
    detail::Columns c{};
    double sum = 0.0;
    if (add_many(law, at, Factors(law, at), c, &sum)) {
      energy += sum;
      return detail::add_components(c, at.mass.size(), force);
    }
  }
  energy += potential_energy<kinematics::Space>(law, space, at);
  return add_force(law, space, at, force);
}

bool choose_close(const NearField& law, const kinematics::Space& domain, const At<Velocity>& at, double dt) {
  if (std::isfinite(law.cutoff)) {
    throw std::invalid_argument(fmt::format(
        "near field: to be split into close pairs and the rest it must reach everywhere, got a cutoff of {} m: it has "
        "few pairs already, take a scheme that needs no split",
        law.cutoff));
  }
  if (!at.position.allFinite() || !at.velocity.allFinite()) return false;
  const Eigen::Index N = at.mass.size();
  const Eigen::VectorXd factor = scaling_factors(law, at), pull = factor.cwiseProduct(at.inverse_mass);
  // f_i f_j (w_i + w_j) of any pair is at most this.
  const double strongest = N > 0 ? 2.0 * factor.maxCoeff() * pull.maxCoeff() : 0.0;
  const double far = stiff_distance(law, strongest, dt);
  // A pair that comes near enough in the step is so near at its start that the sum of these sizes reaches it.
  const Eigen::RowVector3d mean = at.velocity.colwise().mean();
  const Eigen::VectorXd size =
      0.5 * far + ((1.0 + 0.5 * passes) * dt * (at.velocity.rowwise() - mean).rowwise().norm()).array();
  const Candidates near = at.scratch.approaching.candidates(domain, at.position, size);
  const auto is_close = [&](Eigen::Index i, Eigen::Index j) {
    const Eigen::Vector3d apart = separation(domain, at.position.row(i), at.position.row(j));
    const Eigen::Vector3d speed = at.velocity.row(j) - at.velocity.row(i);
    const double fast = speed.squaredNorm(), moment = fast > 0.0 ? std::clamp(-apart.dot(speed) / fast, 0.0, dt) : 0.0;
    const double d = (apart + moment * speed).norm();
    if (d < passes * 0.5 * dt * std::sqrt(fast)) return true;
    return d < far && dt * dt * (factor[i] * pull[j] + pull[i] * factor[j]) * stiffness_of(law, d) > stiff;
  };
  ChosenPairs& close = at.scratch.close;
  close.row.clear();
  close.partner.clear();
  for (Eigen::Index i = 0; i < N; ++i) {
    near.behind(i, [&](Eigen::Index j) {
      if (!is_close(i, j)) return;
      close.row.push_back(static_cast<std::int32_t>(i));
      close.partner.push_back(static_cast<std::int32_t>(j));
    });
  }
  return true;
}

bool add_close_force(const NearField& law, const kinematics::Space& domain, const At<>& at, Forces force) {
  if (!is_available(law.kernel)) throw std::invalid_argument(refusal(law.kernel));
  if (!at.position.allFinite()) return false;
  const Eigen::Index N = at.mass.size();
  const Factors factor(law, at);
  const ChosenPairs& close = at.scratch.close;
  const detail::Columns c = detail::filled(at.scratch, at.position.data(), factor.data(), N);
  const detail::Chosen pairs{
      .row = close.row.data(), .partner = close.partner.data(), .n = static_cast<std::int64_t>(close.row.size())};
  if (built(chosen(law)).chosen(pair_force(law), pairs, c)) return detail::add_components(c, N, force);
  const Eigen::VectorXd factors = scaling_factors(law, at);
  bool all_full = true;
  for (std::size_t k = 0; k < close.row.size(); ++k) {
    all_full = add_pair(law, domain, at, factors, close.row[k], close.partner[k], force) && all_full;
  }
  return all_full && force.allFinite();
}

}  // namespace particulate::laws
