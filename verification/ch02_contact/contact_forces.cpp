// How contact joins the forces: when it counts, that it never pulls, and areas.

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"
#include "encounters.hpp"

namespace verification::contact_forces {

using namespace particulate;

// The share gamma of a step that an impact is said to last hardly matters, with near fields on.

using Cloud = scenes::Scene<kinematics::Space, laws::NearField,
                            contact::Contact<contact::ConstantRestitution, contact::Friction>>;

struct End {
  schemes::State state;
  long impacts;
  double energy;  // kinetic
};

constexpr double cloud_end = 0.8;
constexpr long cloud_steps = 800;

End run(const kinematics::Particles& start, double gamma) {
  contact::Contact<contact::ConstantRestitution, contact::Friction> law = rough(0.5, {.mu_s = 0.2, .mu_d = 0.1});
  law.gamma = gamma;
  Cloud cloud{start, {}, book_near_field, law};
  schemes::State state = scenes::start(cloud);
  const long impacts = march<schemes::VelocityVerlet>(cloud, state, cloud_end, cloud_steps).impacts;
  return {.state = state, .impacts = impacts, .energy = kinematics::kinetic_energy(start.mass, rows_of(state.v))};
}

// Two unit masses 1 m apart under alpha1 = 3 N, alpha2 = 1 N attract with 2 N each: the approach gains 4 gamma Dt/(1 +
// e) in compression, and each velocity after is 1 - (1 + e)/2 (u + D1): exactly linear in gamma.
void one_impact(Rows& rows, double gamma) {
  const double dt = 0.25, u = 1.5, e = 0.6;
  const Encounter at{.i = {.velocity = {u, 0.0, 0.0}, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}};
  contact::Contact<> law = smooth(e);
  law.gamma = gamma;
  const scenes::Scene<kinematics::Space, laws::NearField, contact::Contact<>> pair{
      touching_pair(at), {}, laws::NearField{.alpha1 = 3.0, .alpha2 = 1.0}, law};
  const double without = u * (1.0 + e) / 2.0;
  rows.compare(fmt::format("one impact, gamma = {}: v_j' - (1 + e) u/2 = 2 gamma Dt [m/s]", gamma),
               {.expected = 2.0 * gamma * dt,
                .computed = jump_of(pair, dt).v(1, 0) - without,
                .tolerance = absolute(1e-15),
                .because = "differences of numbers near 1, each rounded a few times"});
}

const Case gamma_insensitive{
    {.name = "gamma_insensitive",
     .claim = "with near fields on, results for gamma = 1e-2 to 1e-6 approach their limit in proportion to gamma",
     .equation = "M 2.18",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const std::vector<double> gammas{1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
      for (const double gamma : gammas) one_impact(rows, gamma);
      const kinematics::Particles start = closing_cloud(rows.case_seed(), 8, 1.0);
      const End limit = run(start, 1e-12);
      std::vector<double> off;
      for (const double gamma : gammas) {
        const End seen = run(start, gamma);
        off.push_back((seen.state.r - limit.state.r).norm() / limit.state.r.norm());
        rows.equal(fmt::format("cloud, gamma = {}: impacts", gamma),
                   {.expected = limit.impacts,
                    .computed = seen.impacts,
                    .because = "the same contacts as at gamma = 1e-12, else the results are not comparable"});
        rows.at_most(fmt::format("cloud, gamma = {}: final kinetic energy against gamma = 1e-12, over gamma", gamma),
                     {.limit = 1.0,
                      .computed = std::abs(seen.energy - limit.energy) / limit.energy / gamma,
                      .because = "each impact moves velocities by a gamma Dt, with accelerations up to some 10 m/s^2, "
                                 "a step of 1 ms and speeds near 1: 1e-2 gamma an impact, tens of impacts"});
      }
      rows.at_least("cloud: impacts", {.limit = 8.0,
                                       .computed = static_cast<double>(limit.impacts),
                                       .because = "as many as particles at least, else gamma is hardly tried"});
      rows.order("cloud: positions at the end against gamma = 1e-12, order in gamma",
                 {.nominal = 1.0,
                  .steps = gammas,
                  .errors = off,
                  .floor = 1e-15,
                  .because = "D1 and D2 are linear in gamma; the limit's own gamma is a millionth of the smallest"});
    }};

// A contact never pulls: where the other forces part a pair that approaches, nothing acts.

struct Counts {
  long act = 0, parted_by_forces = 0, parting_anyway = 0;     // encounters of each kind
  long wrong = 0;                                             // acting although they must not, or the other way round
  double largest = -std::numeric_limits<double>::infinity();  // normal impulse over m* |v|: positive pulls
  double moved = 0.0;  // largest deviation from motion under the other forces alone, where no contact acts
};

void count(const Encounter& at, Counts& so_far) {
  const WideImpact book = monograph_impact(at);
  const contact::Rebound lib = library_impact(at);
  const bool acts = lib.impulse.normal != 0.0 || lib.impulse.tangential != Eigen::Vector3d::Zero();
  ++(book.acts ? so_far.act : book.u > 0 ? so_far.parted_by_forces : so_far.parting_anyway);
  if (acts != book.acts) ++so_far.wrong;
  const double unit = at.i.velocity.norm() / (at.i.inverse_mass + at.j.inverse_mass);
  keep_worst(so_far.largest, lib.impulse.normal / unit);
  if (book.acts) return;
  const double off = std::max((lib.velocity_i - at.i.velocity - at.duration * at.acceleration_i).norm(),
                              (lib.velocity_j - at.j.velocity - at.duration * at.acceleration_j).norm());
  keep_worst(so_far.moved, off / (eps * largest_speed(at, lib.velocity_i, lib.velocity_j)));
}

// Two unit masses one metre apart that repel by F newton each: the approach loses 2 F gamma Dt/(1 + e) in compression.
struct Repelled {
  double F, u, e;
  double dt = 0.1;

  Jumped jump() const {
    using Repulsion = scenes::Scene<kinematics::Space, laws::NearField, contact::Contact<>>;
    const Encounter at{.i = {.velocity = {u, 0.0, 0.0}, .inverse_mass = 1.0}, .j = {.inverse_mass = 1.0}};
    const Repulsion scene{
        touching_pair(at), {}, laws::NearField{.alpha1 = 0.0, .alpha2 = F, .beta1 = 1.0, .beta2 = 2.0}, smooth(e)};
    return jump_of(scene, dt);
  }
  Wide met() const {
    return u - 2 * static_cast<Wide>(F) * static_cast<Wide>(0.01) * static_cast<Wide>(dt) / (1 + static_cast<Wide>(e));
  }
};

// e = 1/2 and F = 750 N: u + D1 = u - 1 m/s.
void in_a_scene(Rows& rows) {
  const auto impacts = [](double u) { return Repelled{.F = 750.0, .u = u, .e = 0.5}.jump().jump.impacts; };
  rows.none("scene: impacts at u = 0.999999 m/s, where repulsion takes 1 m/s", impacts(0.999999),
            "u + D1 < 0: it would pull");
  rows.equal("scene: impacts at u = 1.000001 m/s",
             {.expected = 1, .computed = impacts(1.000001), .because = "u + D1 > 0"});
  rows.none("scene: impacts at u = -1 m/s", impacts(-1.0), "the pair parts");
  const Jumped untouched = Repelled{.F = 750.0, .u = 0.5, .e = 0.5}.jump();
  rows.equal("scene: velocities keep their bits where no contact acts",
             {.expected = true,
              .computed = untouched.v(0, 0) == 0.5 && untouched.v.cwiseAbs().sum() == 0.5,
              .because = "nothing was added to them"});
  for (const double u : {1.001, 2.0, 30.0}) {
    const Repelled pair{.F = 750.0, .u = u, .e = 0.5};
    rows.compare("scene: velocity of j after, u = " + std::to_string(u) + " [m/s]",
                 {.expected = static_cast<double>(1.5L * 0.5L * pair.met()),
                  .computed = pair.jump().v(1, 0),
                  .tolerance = mixed(4e-15, 8e-15),
                  .because = "(1 + e) m* (u + D1): D1 = -1 m/s is rounded some eight times before it is taken from u"});
  }
}

void prove_no_pull(Rows& rows) {
  Encounters drawn({.decades = 3.0, .mu = 1.0, .acceleration = 3000.0, .only_approaching = false}, rows.case_seed());
  Counts seen;
  const int count_of = rows.quick() ? 40000 : 400000;
  for (int k = 0; k < count_of; ++k) count(drawn.next(), seen);
  const double share = 0.02 * count_of;
  rows.at_least("encounters with u > 0 that the forces part",
                {.limit = share,
                 .computed = static_cast<double>(seen.parted_by_forces),
                 .because = "one in fifty at least, else the claim is not tried"});
  rows.at_least("encounters in which the contact acts",
                {.limit = share,
                 .computed = static_cast<double>(seen.act),
                 .because = "one in fifty at least, else the claim is not tried"});
  rows.at_least("encounters with u <= 0", {.limit = share,
                                           .computed = static_cast<double>(seen.parting_anyway),
                                           .because = "one in fifty at least, else the claim is not tried"});
  rows.none("encounters that act and must not, or the other way round", seen.wrong,
            "none is drawn so near u + D1 = 0 that rounding decides");
  rows.at_most("largest normal impulse over m* |v|, positive pulls",
               {.limit = 0.0, .computed = seen.largest, .because = "contacts push"});
  rows.at_most("velocity left by no contact, against v + a dt, in eps max|v|",
               {.limit = 4.0, .computed = seen.moved, .because = "one product and one sum, here and in the library"});

  const Encounter touching{.i = {.velocity = Eigen::Vector3d::Zero(), .inverse_mass = 1.0},
                           .j = {.inverse_mass = 1.0},
                           .acceleration_i = {5.0, 0.0, 0.0}};
  rows.compare("impulse at u = 0 with forces that press together [N s]",
               {.expected = 0.0,
                .computed = library_impact(touching).impulse.normal,
                .tolerance = absolute(0.0),
                .because = "u > 0 fails"});
  // dt1 = 1/2 s, D1 = -1 m/s, u = 1 m/s: no rounding anywhere.
  Encounter balanced = touching;
  balanced.i.velocity = {1.0, 0.0, 0.0}, balanced.acceleration_i = {-2.0, 0.0, 0.0}, balanced.duration = 1.0;
  rows.compare("impulse at u + D1 = 0 exactly [N s]", {.expected = 0.0,
                                                       .computed = library_impact(balanced).impulse.normal,
                                                       .tolerance = absolute(0.0),
                                                       .because = "u + D1 > 0 fails"});
  in_a_scene(rows);
}

const Case no_pull{{.name = "no_pull",
                    .claim = "a contact acts if and only if u > 0 and u + D1 > 0, and never pulls",
                    .equation = "D 2.13",
                    .reference = Reference::identity},
                   prove_no_pull};

// Near-field strengths counted per surface area instead of mass.

using laws::NearField, laws::Scaling;

using AreaCloud =
    scenes::Scene<kinematics::Space, NearField, contact::Contact<contact::ConstantRestitution, contact::Friction>>;

// Force on the first of two spheres at a distance d along x, by (2.3) with alpha (4 pi b_i^2)(4 pi b_j^2).
Wide book_force(const NearField& law, Wide b_i, Wide b_j, Wide d) {
  const Wide areas = 16 * std::numbers::pi_v<Wide> * std::numbers::pi_v<Wide> * b_i * b_i * b_j * b_j;
  return areas * (law.alpha1 * std::pow(d, -static_cast<Wide>(law.beta1)) -
                  law.alpha2 * std::pow(d, -static_cast<Wide>(law.beta2)));
}

double library_force(const NearField& law, double b_i, double b_j, double d, double mass) {
  kinematics::Particles pair{.position = kinematics::Vectors::Zero(2, 3),
                             .velocity = kinematics::Vectors::Zero(2, 3),
                             .mass = Eigen::Vector2d{mass, 2.0 * mass},
                             .radius = Eigen::Vector2d{b_i, b_j}};
  pair.position(1, 0) = d;
  const scenes::Scene<kinematics::Space, NearField> scene{pair, {}, law};
  Eigen::VectorXd f(6);
  if (!scene.total_force(scenes::start(scene), f)) throw std::runtime_error("the pair has no forces");
  return f[0];
}

schemes::State end_of(const kinematics::Particles& start, const NearField& law, long steps) {
  AreaCloud cloud{start, {}, law, rough(0.5, {.mu_s = 0.2, .mu_d = 0.1})};
  schemes::State state = scenes::start(cloud);
  if (march<schemes::VelocityVerlet>(cloud, state, 0.8, steps).impacts < 4)
    throw std::runtime_error("hardly any impacts");
  return state;
}

void prove_surface_area(Rows& rows) {
  const NearField law{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 1.5, .beta2 = 2.5, .scaling = Scaling::area};
  for (const auto& [b_i, b_j] : {std::pair{0.2, 0.2}, std::pair{0.2, 0.4}, std::pair{1e-3, 5.0}}) {
    for (const double mass : {1.0, 1e-6}) {
      rows.compare(fmt::format("force of radii {} and {}, masses {} and twice that [N]", b_i, b_j, mass),
                   {.expected = static_cast<double>(book_force(law, b_i, b_j, 0.8L)),
                    .computed = library_force(law, b_i, b_j, 0.8, mass),
                    .tolerance = relative(8e-15),
                    .because = "two powers, their difference a third of them, four products for the areas"});
    }
  }
  rows.compare("force of doubled radii over that of single ones",
               {.expected = 16.0,
                .computed = library_force(law, 0.4, 0.6, 0.8, 1.0) / library_force(law, 0.2, 0.3, 0.8, 1.0),
                .tolerance = relative(1e-15),
                .because = "powers of two: no rounding but the quotient's"});

  kinematics::Particles start = closing_cloud(rows.case_seed(), 8, 1.0);
  const double per_area = 3.7;
  start.mass = per_area * 4.0 * std::numbers::pi * start.radius.cwiseAbs2();
  NearField by_mass = law;
  by_mass.scaling = Scaling::mass, by_mass.alpha1 /= per_area * per_area, by_mass.alpha2 /= per_area * per_area;
  const long steps = rows.quick() ? 400 : 4000;
  const schemes::State area = end_of(start, law, steps), mass = end_of(start, by_mass, steps);
  rows.at_most(
      "colliding cloud: positions by area and by mass, largest difference [m]",
      {.limit = 1e-11,
       .computed = (area.r - mass.r).cwiseAbs().maxCoeff(),
       .because = "strengths differ by 4 eps; roundings of the steps and impacts after them grow some thousandfold"});
  rows.at_least("colliding cloud: difference if areas were counted as masses [m]",
                {.limit = 1e-3,
                 .computed =
                     [&] {
                       NearField as_mass = law;
                       as_mass.scaling = Scaling::mass;
                       return (area.r - end_of(start, as_mass, steps).r).cwiseAbs().maxCoeff();
                     }(),
                 .because = "else the near field would hardly act here"});
}

const Case surface_area{
    {.name = "surface_area",
     .claim = "strengths per area act like strengths per mass where masses are proportional to areas, and as b_i^2 "
              "b_j^2 everywhere",
     .equation = "M 2.3",
     .reference = Reference::identity},
    prove_surface_area};

}  // namespace verification::contact_forces
