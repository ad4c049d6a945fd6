// A contact never pulls: where the other forces part a pair that approaches, nothing acts.

#include <harness/case.hpp>

#include <particulate/laws/near_field.hpp>

#include "encounters.hpp"

namespace verification::no_pull {

using namespace particulate;

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
  rows.equal("scene: impacts at u = 0.999999 m/s, where repulsion takes 1 m/s",
             {.expected = 0, .computed = impacts(0.999999), .because = "u + D1 < 0: it would pull"});
  rows.equal("scene: impacts at u = 1.000001 m/s",
             {.expected = 1, .computed = impacts(1.000001), .because = "u + D1 > 0"});
  rows.equal("scene: impacts at u = -1 m/s", {.expected = 0, .computed = impacts(-1.0), .because = "the pair parts"});
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

const Case no_pull{
    {.name = "no_pull",
     .claim = "a contact acts if and only if u > 0 and u + D1 > 0, and never pulls",
     .equation = "D 2.13",
     .reference = Reference::identity},
    [](Rows& rows) {
      Encounters drawn({.decades = 3.0, .mu = 1.0, .acceleration = 3000.0, .only_approaching = false},
                       rows.case_seed());
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
      rows.equal(
          "encounters that act and must not, or the other way round",
          {.expected = 0, .computed = seen.wrong, .because = "none is drawn so near u + D1 = 0 that rounding decides"});
      rows.at_most("largest normal impulse over m* |v|, positive pulls",
                   {.limit = 0.0, .computed = seen.largest, .because = "contacts push"});
      rows.at_most(
          "velocity left by no contact, against v + a dt, in eps max|v|",
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
    }};

}  // namespace verification::no_pull
