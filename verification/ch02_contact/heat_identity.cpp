// Heat of a contact: kinetic energy lost plus work of the other forces, against its closed form.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::heat_identity {

using namespace particulate;

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
struct Ledger {
  double heat = 0.0, told = 0.0;
  long contacts = 0, impacts = 0;
};

Ledger cloud_ledger(std::uint64_t seed, double e) {
  const kinematics::Particles start = closing_cloud(seed, 27, 1.0);
  auto cloud = contact_scene(start, smooth(e));
  Ledger ledger;
  const auto sum_heat = [&](const schemes::State&, const schemes::State& to, double, const schemes::VelocityVerlet&) {
    const auto r = as_rows(to.r), v = as_rows(to.v);
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

const Case heat_identity{
    {.name = "heat_identity",
     .claim = "heat of a contact in closed form is the kinetic energy lost plus the work of the other forces, per "
              "contact and summed over a cloud",
     .equation = "D 7.4.1",
     .reference = Reference::identity},
    [](Rows& rows) {
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
        const Ledger ledger = cloud_ledger(rows.case_seed(), e);
        rows.equal(fmt::format("cloud of 27, e = {}: impacts", e),
                   {.expected = ledger.contacts,
                    .computed = ledger.impacts,
                    .because = "one a contact where no particle has two at once"});
        rows.at_least(fmt::format("cloud of 27, e = {}: contacts", e),
                      {.limit = 20.0,
                       .computed = static_cast<double>(ledger.contacts),
                       .because = "else there is little to sum"});
        rows.compare(
            fmt::format("cloud of 27, e = {}: kinetic energy taken by all jumps [J]", e),
            {.expected = ledger.heat,
             .computed = ledger.told,
             .tolerance = mixed(1e-12, 1e-12),
             .because = "some 50 jumps, each a difference of energies of some 10 J, rounded to 27 eps/2 of it"});
      }
    }};

}  // namespace verification::heat_identity
