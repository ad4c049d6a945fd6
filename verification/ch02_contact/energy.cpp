// Energy that impacts take: of a pair, of a group, as heat, and in the ledger of a cloud.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"
#include "encounters.hpp"

namespace verification::energy {

using namespace particulate;

// What an impact takes from the kinetic energy.

// Change of the kinetic energy in closed form: restitution's share, and the work of Coulomb friction, which sticks and
// takes all of the sliding or slides and takes less.
Wide change_in_closed_form(const Encounter& at) {
  const WideVector n = at.n.cast<Wide>().normalized(),
                   relative = at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>();
  const Wide reduced = 1 / (static_cast<Wide>(at.i.inverse_mass) + at.j.inverse_mass), e = at.e;
  const Wide u = relative.dot(n), u_t = (relative - u * n).norm(), J = (1 + e) * reduced * u;
  const Wide normal = -reduced * (1 - e * e) * u * u / 2;
  if (reduced * u_t <= at.friction.mu_s * J) return normal - reduced * u_t * u_t / 2;
  const Wide slide = at.friction.mu_d * J;
  return normal - slide * u_t + slide * slide / (2 * reduced);
}

template <class After>
double worst_of(const Drawn& of, std::uint64_t seed, int count, const After& after) {
  Encounters drawn(of, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const auto [v_i, v_j] = after(at);
    const Wide before = pair_energy(at, at.i.velocity.cast<Wide>(), at.j.velocity.cast<Wide>());
    const Wide seen = pair_energy(at, v_i.template cast<Wide>(), v_j.template cast<Wide>()) - before;
    const double error = static_cast<double>(std::abs(seen - change_in_closed_form(at)) / (eps * before));
    keep_worst(worst, error);
  }
  return worst;
}

// The scene's own account of the change, against the closed form, over eps m* v V with the relative velocity v and the
// largest speed V = (1 + bulk) v that this is the difference of.
double worst_account(const Drawn& of, std::uint64_t seed, int count) {
  Encounters drawn(of, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const double told = jump_of(contact_scene(touching_pair(at), rough(at.e, at.friction)), 1e-3).jump.energy_change;
    const double speed = (at.i.velocity - at.j.velocity).norm();
    const double unit = eps * speed * (1.0 + of.bulk) * speed / (at.i.inverse_mass + at.j.inverse_mass);
    keep_worst(worst, std::abs(told - change_in_closed_form(at)) / unit);
  }
  return worst;
}

const Case energy_loss{
    {.name = "energy_loss",
     .claim = "an impact takes 1/2 m* (1 - e^2) u_n^2 and the work of friction from the kinetic energy",
     .equation = "D 2.22",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const int count = rows.quick() ? 20000 : 200000;
      const char* const because =
          "velocities after carry up to 8 roundings, and T is quadratic in them; masses within six decades, speeds of "
          "the "
          "centre of mass up to the closing speed";
      const Drawn smooth_pairs{.decades = 3.0}, rough_pairs{.decades = 3.0, .mu = 2.0};
      const auto row = [&](const char* what, double computed) {
        rows.at_most(what, {.limit = 16.0, .computed = computed, .because = because});
      };
      row("T' - T against the closed form, frictionless, in eps T",
          worst_of(smooth_pairs, rows.case_seed(), count, by_impact));
      row("T' - T against the closed form, with friction, in eps T",
          worst_of(rough_pairs, rows.case_seed(), count, by_impact));
      const auto in_a_scene = [](const Encounter& at) { return by_scene(at, rough(at.e, at.friction)); };
      row("T' - T against the closed form, scene with friction, in eps T",
          worst_of(rough_pairs, rows.case_seed(), count / 4, in_a_scene));
      for (const double bulk : {0.0, 1.0, 2e7}) {
        rows.at_most(
            fmt::format("energy_change of the scene's jump, both moving {} times as fast, in eps m* v V", bulk),
            {.limit = 16.0,
             .computed = worst_account({.decades = 3.0, .bulk = bulk, .mu = 2.0}, rows.case_seed(), count / 4),
             .because = "impulses and relative velocities carry some 8 roundings of the largest speed V, and are "
                        "multiplied: the energy of the common motion never enters"});
      }
      for (const double e : {0.0, 0.3, 0.75, 1.0}) {
        const Encounter head_on{.i = {.velocity = {1.7, 0.0, 0.0}, .inverse_mass = 0.4},
                                .j = {.velocity = {-1.7, 0.0, 0.0}, .inverse_mass = 0.4},
                                .e = e};
        const contact::Rebound after = library_impact(head_on);
        rows.compare(
            "T'/T of an identical pair head-on, e = " + std::to_string(e),
            {.expected = e * e,
             .computed = (after.velocity_i.squaredNorm() + after.velocity_j.squaredNorm()) / (2.0 * 1.7 * 1.7),
             .tolerance = absolute(2e-15),
             .because = "velocities after are differences of 1.7 m/s and its (1 + e)-fold, rounded three times each"});
      }
    }};

// Bounds on what a group of particles loses when each meets at most one other, and a group that goes below them.

// Pairs ten metres apart that touch; a fifth of them parts.
kinematics::Particles pairs(Encounters& drawn, Eigen::Index count) {
  kinematics::Particles group{.position = kinematics::Vectors(2 * count, 3),
                              .velocity = kinematics::Vectors(2 * count, 3),
                              .mass = Eigen::VectorXd(2 * count),
                              .radius = Eigen::VectorXd::Constant(2 * count, 0.5 + 1e-9)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const double speed = (at.i.velocity - at.j.velocity).norm();
    const Eigen::Vector3d place{10.0 * static_cast<double>(k), 0.0, 0.0};
    for (Eigen::Index side = 0; side < 2; ++side) {
      const contact::Body& body = side == 0 ? at.i : at.j;
      const Eigen::Vector3d centre = place + static_cast<double>(side) * at.n;
      group.position.row(2 * k + side) = centre.transpose();
      group.velocity.row(2 * k + side) = body.velocity.transpose() / speed;
      group.mass[2 * k + side] = 1.0 / body.inverse_mass;
    }
  }
  return group;
}

struct Range {
  double above_lower = std::numeric_limits<double>::infinity();  // smallest (T' - T)/T - (e^2 - 1)
  double highest = -std::numeric_limits<double>::infinity();     // largest (T' - T)/T
};

Range changes(std::uint64_t seed, int groups, double e, contact::Resolution resolution) {
  Encounters drawn({.decades = 2.0, .only_approaching = false}, seed);
  Range range;
  for (int k = 0; k < groups; ++k) {
    const kinematics::Particles group = pairs(drawn, 1 + k % 6);
    const Jumped after = jump_of(contact_scene(group, smooth(e, resolution)), 1e-3);
    const double T = kinematics::kinetic_energy(group.mass, group.velocity);
    const double change = (kinematics::kinetic_energy(group.mass, after.v) - T) / T;
    range.above_lower = std::min(range.above_lower, change - (e * e - 1.0));
    keep_worst(range.highest, change);
  }
  return range;
}

// Momentum-free head-on pairs in slanted directions: the lower bound is attained.
double change_of_head_on_pairs(std::uint64_t seed, double e) {
  Encounters drawn({.decades = 2.0}, seed);
  kinematics::Particles group = pairs(drawn, 5);
  for (Eigen::Index k = 0; k < 5; ++k) {
    const Eigen::RowVector3d n = group.position.row(2 * k + 1) - group.position.row(2 * k);
    group.velocity.row(2 * k) = n / group.mass[2 * k];
    group.velocity.row(2 * k + 1) = -n / group.mass[2 * k + 1];
  }
  const Jumped after = jump_of(contact_scene(group, smooth(e)), 1e-3);
  const double T = kinematics::kinetic_energy(group.mass, group.velocity);
  return (kinematics::kinetic_energy(group.mass, after.v) - T) / T;
}

// Three equal bodies at 1, 0 and -1 m/s, e = 1/2, hit in turn: 1 and 2, 2 and 3, 1 and 2 again, then all part.
// Velocities are (1/4, 3/4, -1), (1/4, -9/16, 5/16), (-23/64, 3/64, 5/16): T'/T = (529 + 9 + 400)/8192.
constexpr double left_in_turn = 938.0 / 8192.0;

double in_turn_by_impacts() {
  std::array<contact::Body, 3> body;
  for (int k = 0; k < 3; ++k)
    body[static_cast<std::size_t>(k)] = {.velocity = {1.0 - k, 0.0, 0.0}, .inverse_mass = 1.0};
  for (const std::size_t first : {0U, 1U, 0U}) {
    const contact::Rebound after =
        contact::impact(body[first], body[first + 1], {1.0, 0.0, 0.0}, 0.5, Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Zero(), 0.0, contact::Frictionless{});
    body[first].velocity = after.velocity_i, body[first + 1].velocity = after.velocity_j;
  }
  return 0.5 * (body[0].velocity.squaredNorm() + body[1].velocity.squaredNorm() + body[2].velocity.squaredNorm());
}

// The same in time: gaps of 0.1 and 0.3 m make them meet in that order.
struct InTime {
  double share;
  long impacts;
};

InTime in_turn_by_scene() {
  kinematics::Particles three{.position = kinematics::Vectors::Zero(3, 3),
                              .velocity = kinematics::Vectors::Zero(3, 3),
                              .mass = Eigen::VectorXd::Ones(3),
                              .radius = Eigen::VectorXd::Constant(3, 0.5)};
  three.position.col(0) << -1.1, 0.0, 1.3;
  three.velocity.col(0) << 1.0, 0.0, -1.0;
  auto scene = contact_scene(three, smooth(0.5));
  schemes::State state = scenes::start(scene);
  const schemes::Outcome outcome =
      reached(scene, state, 3.0, schemes::VelocityVerlet(), schemes::FixedStep{.step = 1e-3});
  return {.share = 0.5 * state.v.squaredNorm(), .impacts = outcome.impacts};
}

const Case group_energy_bounds{
    {.name = "group_energy_bounds",
     .claim = "e^2 - 1 <= (T' - T)/T <= 0 for a group in which each meets at most one other; repeated impacts go below",
     .equation = "M 2.29",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const int groups = rows.quick() ? 4000 : 40000;
      const char* const because =
          "the bound itself, less the rounding of T and T': some 30 roundings of sums of positive terms";
      for (const double e : {0.0, 0.5, 0.9, 1.0}) {
        for (const auto& [resolution, name] : resolutions) {
          const Range range = changes(rows.case_seed(), groups, e, resolution);
          rows.at_least(fmt::format("smallest (T' - T)/T - (e^2 - 1), e = {}, {}", e, name),
                        {.limit = -4e-15, .computed = range.above_lower, .because = because});
          rows.at_most(fmt::format("largest (T' - T)/T, e = {}, {}", e, name),
                       {.limit = 4e-15, .computed = range.highest, .because = because});
        }
        rows.compare(fmt::format("(T' - T)/T of pairs without momentum, head-on, e = {}", e),
                     {.expected = e * e - 1.0,
                      .computed = change_of_head_on_pairs(rows.case_seed(), e),
                      .tolerance = absolute(4e-15),
                      .because = because});
      }
      rows.compare("T'/T, hit in turn, by impacts", {.expected = left_in_turn,
                                                     .computed = in_turn_by_impacts(),
                                                     .tolerance = relative(1e-15),
                                                     .because = "all velocities are multiples of 1/64: no rounding"});
      rows.compare("T'/T, hit in turn, four digits", {.expected = 0.1145,
                                                      .computed = in_turn_by_impacts(),
                                                      .tolerance = absolute(5e-5),
                                                      .because = "half of the fourth decimal"});
      const InTime seen = in_turn_by_scene();
      rows.compare("T'/T, hit in turn, scene", {.expected = left_in_turn,
                                                .computed = seen.share,
                                                .tolerance = relative(4e-15),
                                                .because = "as above; the resolver divides by its own inverse masses"});
      rows.equal("impacts, hit in turn, scene",
                 {.expected = 3, .computed = seen.impacts, .because = "1 and 2, 2 and 3, 1 and 2; then all part"});
    }};

// Heat of a contact: kinetic energy lost plus work of the other forces, against its closed form.

// Impulses of the other forces on both bodies along n, over both phases [N s].
struct Pushes {
  Wide i_1 = 0, j_1 = 0, i_2 = 0, j_2 = 0;
};

// q = T - T' + W_E along n: the phases in turn, each from its own balance of momentum, the other forces' work with the
// mean velocity of each body in each phase.
Wide heat_by_phases(Wide m_i, Wide m_j, Wide v_i, Wide v_j, Wide e, const Pushes& E) {
  const Wide common = (m_i * v_i + m_j * v_j + E.i_1 + E.j_1) / (m_i + m_j);
  const Wide compression = m_i * (v_i - common) + E.i_1;  // the impulse that pushes i back
  const Wide after_i = common + (E.i_2 - e * compression) / m_i, after_j = common + (E.j_2 + e * compression) / m_j;
  const Wide work = E.i_1 * (v_i + common) / 2 + E.j_1 * (v_j + common) / 2 + E.i_2 * (common + after_i) / 2 +
                    E.j_2 * (common + after_j) / 2;
  return (m_i * (v_i * v_i - after_i * after_i) + m_j * (v_j * v_j - after_j * after_j)) / 2 + work;
}

// Largest deviation of normal_heat() from the phases, over eps m* (u + D1)(u + |D2|) which bounds every term of it.
// It does not depend on the observer's speed: that of the centre of mass cancels least.
double worst_by_phases(std::uint64_t seed, int count, double pushed) {
  Encounters drawn({.decades = 0.5}, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const Wide m_i = 1 / static_cast<Wide>(at.i.inverse_mass), m_j = 1 / static_cast<Wide>(at.j.inverse_mass);
    const Wide closing = (at.i.velocity - at.j.velocity).dot(at.n), scale = pushed * closing;
    const Wide v_i = m_j / (m_i + m_j) * closing, v_j = -m_i / (m_i + m_j) * closing;
    const Pushes E{.i_1 = m_i * scale * drawn.uniform(),
                   .j_1 = m_j * scale * drawn.uniform(),
                   .i_2 = m_i * scale * drawn.uniform(),
                   .j_2 = m_j * scale * drawn.uniform()};
    const Wide u = v_i - v_j, delta1 = E.i_1 / m_i - E.j_1 / m_j, delta2 = E.i_2 / m_i - E.j_2 / m_j,
               reduced = 1 / (1 / m_i + 1 / m_j);
    if (!(u > 0 && u + delta1 > 0)) continue;
    const double lib = contact::normal_heat(static_cast<double>(u), static_cast<double>(delta1),
                                            static_cast<double>(delta2), at.e, static_cast<double>(reduced));
    const Wide unit = reduced * (u + std::abs(delta1)) * (u + std::abs(delta1) + std::abs(delta2));
    keep_worst(worst, static_cast<double>(std::abs(lib - heat_by_phases(m_i, m_j, v_i, v_j, at.e, E)) / (eps * unit)));
  }
  return worst;
}

// The same from the velocities that the library's impact leaves, under constant accelerations.
double worst_by_velocities(std::uint64_t seed, int count, double acceleration) {
  Encounters drawn({.decades = 2.0, .acceleration = acceleration}, seed);
  double worst = 0.0;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const WideImpact book = monograph_impact(at);
    if (!book.acts) continue;
    const contact::Rebound after = contact::impact(at.i, at.j, at.n, at.e, at.acceleration_i, at.acceleration_j,
                                                   at.duration, contact::Frictionless{});
    const contact::Phases split = contact::phases(at.duration, at.e);
    const WideVector n = at.n.cast<Wide>();
    Wide lost = 0, work = 0, size = 0;
    const auto add = [&](const contact::Body& body, const Eigen::Vector3d& v_after, const Eigen::Vector3d& pushed,
                         Wide common) {
      const Wide m = 1 / static_cast<Wide>(body.inverse_mass), v = body.velocity.cast<Wide>().dot(n),
                 w = v_after.cast<Wide>().dot(n), a = pushed.cast<Wide>().dot(n);
      lost += m * (v * v - w * w) / 2;
      work += m * a * (split.compression * (v + common) + split.recovery * (common + w)) / 2;
      size += m * (body.velocity.cast<Wide>().squaredNorm() + v_after.cast<Wide>().squaredNorm());
    };
    const Wide m_i = 1 / static_cast<Wide>(at.i.inverse_mass), m_j = 1 / static_cast<Wide>(at.j.inverse_mass);
    const auto met = [&](const contact::Body& body, const Eigen::Vector3d& a) {
      return body.velocity.cast<Wide>().dot(n) + split.compression * a.cast<Wide>().dot(n);
    };
    const Wide common = (m_i * met(at.i, at.acceleration_i) + m_j * met(at.j, at.acceleration_j)) / (m_i + m_j);
    add(at.i, after.velocity_i, at.acceleration_i, common);
    add(at.j, after.velocity_j, at.acceleration_j, common);
    const double lib =
        contact::normal_heat(static_cast<double>(book.u), static_cast<double>(book.delta1),
                             static_cast<double>(book.delta2), at.e, static_cast<double>(1 / (1 / m_i + 1 / m_j)));
    keep_worst(worst, static_cast<double>(std::abs(lib - (lost + work)) / (eps * size)));
  }
  return worst;
}

// Heat of every contact of a frictionless cloud without other forces, summed apart before each jump.
struct HeatLedger {
  double heat = 0.0, told = 0.0;
  long contacts = 0, impacts = 0;
};

HeatLedger cloud_ledger(std::uint64_t seed, double e) {
  const kinematics::Particles start = closing_cloud(seed, 27, 1.0);
  auto cloud = contact_scene(start, smooth(e));
  HeatLedger ledger;
  const auto sum_heat = [&](const schemes::State&, const schemes::State& to, double, const schemes::VelocityVerlet&) {
    const auto r = rows_of(to.r), v = rows_of(to.v);
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      for (Eigen::Index j = i + 1; j < start.size(); ++j) {
        const Eigen::RowVector3d towards = r.row(j) - r.row(i);
        const double u = (v.row(i) - v.row(j)).dot(towards) / towards.norm();
        if (!(towards.norm() <= start.radius[i] + start.radius[j] && u > 0.0)) continue;
        ledger.heat += contact::normal_heat(u, 0.0, 0.0, e, kinematics::reduced_mass(start.mass[i], start.mass[j]));
        ++ledger.contacts;
      }
    }
    return true;
  };
  schemes::State state = scenes::start(cloud);
  const schemes::Outcome outcome = march<schemes::VelocityVerlet>(cloud, state, 2.0, 20000, sum_heat);
  ledger.told = -outcome.energy_change, ledger.impacts = outcome.impacts;
  return ledger;
}

void prove_heat_identity(Rows& rows) {
  // m* = 1.2 kg, u = 5, D1 = 3, D2 = 1.5 m/s, e = 1/2: 0.5 * 1.2 * 8 * (5 - 0.5 * 2.5); without others 0.6 * 0.75
  // * 25.
  rows.compare("heat by hand [J]", {.expected = 18.0,
                                    .computed = contact::normal_heat(5.0, 3.0, 1.5, 0.5, 1.2),
                                    .tolerance = relative(1e-15),
                                    .because = "six roundings"});
  rows.compare("heat by hand, no other forces [J]", {.expected = 11.25,
                                                     .computed = contact::normal_heat(5.0, 0.0, 0.0, 0.5, 1.2),
                                                     .tolerance = relative(1e-15),
                                                     .because = "five roundings"});
  const int count = rows.quick() ? 20000 : 200000;
  for (const double pushed : {0.0, 0.4, 5.0}) {
    rows.at_most(fmt::format("heat against both phases, other impulses up to {} m u, in eps of its terms", pushed),
                 {.limit = 6.0,
                  .computed = worst_by_phases(rows.case_seed(), count, pushed),
                  .because = "six roundings of sums and products, and of the values handed over"});
  }
  for (const double acceleration : {0.0, 30.0, 1000.0}) {
    rows.at_most(
        fmt::format(
            "heat against T - T' + W_E of contact::impact, accelerations up to {} m/s^2, in eps sum m (v^2 + v'^2)",
            acceleration),
        {.limit = 16.0,
         .computed = worst_by_velocities(rows.case_seed(), count, acceleration),
         .because = "velocities after carry some 8 roundings, energy is quadratic in them"});
  }
  for (const double e : {0.5, 1.0}) {
    const HeatLedger ledger = cloud_ledger(rows.case_seed(), e);
    rows.equal(fmt::format("cloud of 27, e = {}: impacts", e),
               {.expected = ledger.contacts,
                .computed = ledger.impacts,
                .because = "one a contact where no particle has two at once"});
    rows.at_least(
        fmt::format("cloud of 27, e = {}: contacts", e),
        {.limit = 20.0, .computed = static_cast<double>(ledger.contacts), .because = "else there is little to sum"});
    rows.compare(fmt::format("cloud of 27, e = {}: kinetic energy taken by all jumps [J]", e),
                 {.expected = ledger.heat,
                  .computed = ledger.told,
                  .tolerance = mixed(1e-12, 1e-12),
                  .because = "some 50 impulses, each over a mean of velocities of some 1 m/s, rounded a few times"});
  }
}

const Case heat_identity{
    {.name = "heat_identity",
     .claim = "heat of a contact in closed form is the kinetic energy lost plus the work of the other forces, per "
              "contact and summed over a cloud",
     .equation = "D 7.4.1",
     .reference = Reference::identity},
    prove_heat_identity};

// The ledger of a colliding cloud: kinetic and potential energy, and what contacts took, sum to a constant.

using Cloud =
    scenes::Scene<kinematics::Space, laws::NearField, contact::Contact<contact::Restitution, contact::Friction>>;

constexpr double t_end = 1.1;

Cloud cloud_of(const kinematics::Particles& start) {
  return {start,
          {},
          book_near_field,
          {.restitution = {.e_o = 0.8, .v_star = 5.0, .e_minus = 0.1}, .friction = {.mu_s = 0.3, .mu_d = 0.2}}};
}

struct Ledger {
  double residual;  // (T + V + taken) at the end against T + V at the start, over T at the start
  double taken;     // by contacts, over T at the start
  double momentum;  // change over sum m|v|
};

template <class S>
Ledger ledger(const kinematics::Particles& start, long steps) {
  Cloud cloud = cloud_of(start);
  schemes::State state = scenes::start(cloud);
  const double T = kinematics::kinetic_energy(start.mass, start.velocity), V = cloud.potential_energy(state);
  const schemes::Outcome outcome = march<S>(cloud, state, t_end, steps);
  const double T_end = kinematics::kinetic_energy(start.mass, rows_of(state.v)), V_end = cloud.potential_energy(state);
  const Eigen::Vector3d gained = kinematics::linear_momentum(start.mass, rows_of(state.v)) -
                                 kinematics::linear_momentum(start.mass, start.velocity);
  return {.residual = std::abs(T_end + V_end - outcome.energy_change - T - V) / T,
          .taken = -outcome.energy_change / T,
          .momentum = gained.norm() / start.mass.dot(start.velocity.rowwise().norm())};
}

// Impacts act at the end of a step, so every step size makes another history of them and the residual of one cloud
// scatters about its order: it is the root mean square over several clouds that converges.
constexpr std::uint64_t clouds = 16;

template <class S>
Ledger ledger_of_many(std::uint64_t seed, long steps) {
  Ledger all{.residual = 0.0, .taken = std::numeric_limits<double>::infinity(), .momentum = 0.0};
  for (std::uint64_t k = 0; k < clouds; ++k) {
    const Ledger one = ledger<S>(closing_cloud(seed + k, 8, 1.0), steps);
    all.residual += one.residual * one.residual / static_cast<double>(clouds);
    all.taken = std::min(all.taken, one.taken);
    keep_worst(all.momentum, one.momentum);
  }
  all.residual = std::sqrt(all.residual);
  return all;
}

template <class S>
void compare(Rows& rows, std::uint64_t seed, const char* name, const std::vector<long>& steps, double nominal,
             double largest) {
  std::vector<double> h, residuals;
  for (const long n : steps) {
    const Ledger seen = ledger_of_many<S>(seed, n);
    h.push_back(t_end / static_cast<double>(n));
    residuals.push_back(seen.residual);
    rows.at_most(fmt::format("{}, {} steps: largest change of momentum over sum m|v|", name, n),
                 {.limit = 1e-14,
                  .computed = seen.momentum,
                  .because = "one rounding of eps/2 a velocity, step and impulse, adding as a random walk"});
    rows.at_least(fmt::format("{}, {} steps: least energy taken by contacts over T", name, n),
                  {.limit = 0.5, .computed = seen.taken, .because = "a lossless cloud would prove nothing"});
  }
  rows.order(fmt::format("{}: T + V + taken by contacts against T + V at the start, over T, rms of 16 clouds", name),
             {.nominal = nominal,
              .steps = h,
              .errors = residuals,
              .floor = 1e-16,
              .because = "between jumps the scheme's own order; a jump's account is exact at the place where it acts"});
  rows.at_most(fmt::format("{}: the same at the smallest step", name),
               {.limit = largest,
                .computed = residuals.back(),
                .because = "(omega h)^2/12 under Verlet, (omega h)^4/120 under RK4, with omega = 3 rad/s where spheres "
                           "touch, of 28 pairs"});
}

void prove_colliding_cloud_ledger(Rows& rows) {
  compare<schemes::VelocityVerlet>(rows, rows.case_seed(), "velocity Verlet", {200, 400, 800, 1600, 3200}, 2.0, 2.5e-6);
  compare<schemes::RungeKutta4>(rows, rows.case_seed(), "RK4", {50, 75, 112, 168, 252}, 4.0, 1e-8);
}

const Case colliding_cloud_ledger{
    {.name = "colliding_cloud_ledger",
     .claim = "T + V + energy taken by contacts is constant to the scheme's order, momentum to rounding, with near "
              "field, friction and restitution that falls",
     .equation = "D 2.22",
     .reference = Reference::convergence},
    prove_colliding_cloud_ledger};

}  // namespace verification::energy
