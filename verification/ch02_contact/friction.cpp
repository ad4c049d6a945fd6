// Friction: oblique strikes, and friction that stops what slides.

#include <fmt/format.h>

#include <harness/case.hpp>

#include "encounters.hpp"

namespace verification::friction {

using namespace particulate;

// A sphere strikes a fixed wall obliquely.

struct After {
  double normal, tangential;  // [m/s]
};

// The same strike told to the library in three ways; the wall lies at x = 0, the tangential direction is slanted in it.
enum class Told { impact, wall, rock };

After strike(Told how, double normal, double tangential, double e, const contact::Friction& friction) {
  const Eigen::Vector3d along = Eigen::Vector3d{0.0, 3.0, 4.0} / 5.0;
  const Encounter at{.i = {.velocity = -normal * Eigen::Vector3d::UnitX() + tangential * along, .inverse_mass = 2.0},
                     .n = -Eigen::Vector3d::UnitX(),
                     .e = e,
                     .friction = friction};
  Eigen::Vector3d v;
  if (how == Told::impact) {
    v = library_impact(at).velocity_i;
  } else if (how == Told::rock) {
    v = jump_of(contact_scene(touching_pair(at), rough(e, friction)), 1e-3).v.row(0).transpose();
  } else {
    using Room = scenes::Scene<kinematics::Space, contact::Contact<contact::ConstantRestitution, contact::Friction>>;
    kinematics::Particles one{.position = kinematics::Vectors::Zero(1, 3),
                              .velocity = at.i.velocity.transpose(),
                              .mass = Eigen::VectorXd::Constant(1, 0.5),
                              .radius = Eigen::VectorXd::Constant(1, 0.1)};
    const Room room{
        one, {{kinematics::Wall{.point = {-0.1, 0.0, 0.0}, .normal = {1.0, 0.0, 0.0}}}}, rough(e, friction)};
    v = jump_of(room, 1e-3).v.row(0).transpose();
  }
  return {.normal = v.x(), .tangential = v.dot(along)};
}

const char* name_of_way(Told how) {
  return how == Told::impact ? "contact::impact" : how == Told::wall ? "scene, wall" : "scene, immovable sphere";
}

// The angle at which sliding begins, by bisection on what the library does.
double sticking_angle(double e, double mu) {
  double low = 0.0, high = 0.5 * std::numbers::pi;
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.5 * (low + high);
    const bool sticks =
        std::abs(strike(Told::impact, std::cos(angle), std::sin(angle), e, {.mu_s = mu, .mu_d = mu}).tangential) <=
        4.0 * eps;
    (sticks ? low : high) = angle;
  }
  return low * 180.0 / std::numbers::pi;
}

// E'/E for unit speed, in extended precision.
Wide share_left(Wide degrees, Wide e, Wide mu) {
  const Wide angle = degrees * std::numbers::pi_v<Wide> / 180, slide = std::sin(angle) - mu * (1 + e) * std::cos(angle);
  return std::pow(e * std::cos(angle), 2) + (slide > 0 ? slide * slide : 0);
}

void along_the_angles(Rows& rows, Told how) {
  const double digits[][2] = {{30.0, 0.48}, {60.0, 0.33307714}, {76.0, 0.60381239}, {85.0, 0.8471349}};
  for (const auto& [degrees, expected] : digits) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const After after = strike(how, std::cos(angle), std::sin(angle), 0.8, {.mu_s = 0.5, .mu_d = 0.5});
    const double left = after.normal * after.normal + after.tangential * after.tangential;
    const std::string what = fmt::format("E'/E at {} degrees, {}", degrees, name_of_way(how));
    rows.compare(what, {.expected = expected,
                        .computed = left,
                        .tolerance = absolute(5.1e-9),
                        .because = "half of the eighth decimal, the last one printed"});
    rows.compare(what + ", extended precision", {.expected = static_cast<double>(share_left(degrees, 0.8L, 0.5L)),
                                                 .computed = left,
                                                 .tolerance = absolute(2e-15),
                                                 .because = "sine, cosine and some ten roundings of numbers up to 1"});
  }
}

void prove_oblique_wall(Rows& rows) {
  for (const Told how : {Told::impact, Told::wall, Told::rock}) {
    // It slides as 3.1947 > 0.3 * 1.98 * 2.2369; from then on mu_s no longer counts.
    const After after = strike(how, 2.2369, 3.1947, 0.98, {.mu_s = 0.3, .mu_d = 0.092});
    // 0.98 * 2.2369, and 3.1947 - 0.092 * 1.98 * 2.2369, multiplied out by hand.
    rows.compare(fmt::format("v_n after, {} [m/s]", name_of_way(how)),
                 {.expected = 2.192162,
                  .computed = after.normal,
                  .tolerance = relative(2e-15),
                  .because = "four roundings of numbers twice as large"});
    rows.compare(fmt::format("v_t after, {} [m/s]", name_of_way(how)),
                 {.expected = 2.787226296,
                  .computed = after.tangential,
                  .tolerance = relative(2e-15),
                  .because = "some eight roundings, no cancellation"});
    along_the_angles(rows, how);
  }
  const double limit = sticking_angle(0.98, 0.092);
  rows.compare("angle below which it sticks [degrees]", {.expected = 10.324,
                                                         .computed = limit,
                                                         .tolerance = absolute(5.1e-4),
                                                         .because = "half of the third decimal, the last one printed"});
  rows.compare("angle below which it sticks, atan(mu_s (1 + e)) [degrees]",
               {.expected = static_cast<double>(std::atan(0.092L * 1.98L) * 180 / std::numbers::pi_v<Wide>),
                .computed = limit,
                .tolerance = relative(3e-14),
                .because = "within 4 eps of sliding counts as sticking: 5e-15 of this angle; the velocities' own "
                           "rounding moves it as much"});
}

const Case oblique_wall{
    {.name = "oblique_wall",
     .claim = "a sphere on a fixed wall returns e v_n, and loses mu_d (1 + e) v_n of its tangential speed or all of it",
     .equation = "M 2.46",
     .reference = Reference::closed_form},
    prove_oblique_wall};

// The coefficient that just stops the sliding takes the most energy; more of it changes nothing, and nothing reverses.

WideVector parting(const Encounter& at, double mu) {
  Encounter with = at;
  with.friction = {.mu_s = mu, .mu_d = mu};
  const contact::Rebound after = library_impact(with);
  return after.velocity_i.cast<Wide>() - after.velocity_j.cast<Wide>();
}

// Energy of the relative motion after an impact with mu_s = mu_d = mu, over that before.
Wide energy_left(const Encounter& at, double mu) {
  const WideVector before = at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>();
  return parting(at, mu).squaredNorm() / before.squaredNorm();
}

// While it slides the energy is a parabola in mu: its vertex from three energies that the library leaves.
double vertex(const Encounter& at, double step) {
  const Wide E_0 = energy_left(at, 0.0), E_1 = energy_left(at, step), E_2 = energy_left(at, 2.0 * step);
  return static_cast<double>(step * (3 * E_0 - 4 * E_1 + E_2) / (2 * (E_0 - 2 * E_1 + E_2)));
}

struct Worst {
  double vertex = 0.0;  // distance of the parabola's vertex from mu_d*, relative
  double rise = 0.0;    // energy at mu = f mu_d* against the minimum plus its parabola, f from 0 to 4, over eps
  double least = 0.0;   // how far any energy lies below the one at mu_d*, over eps
};

void look(const Encounter& at, Worst& worst) {
  const WideVector n = at.n.cast<Wide>(), v = at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>();
  const Wide u_n = v.dot(n), u_t = (v - u_n * n).norm();
  const double star = contact::stopping_friction(static_cast<double>(u_t), static_cast<double>(u_n), at.e);
  keep_worst(worst.vertex, std::abs(vertex(at, 0.4 * star) / star - 1.0));
  const Wide smallest = at.e * static_cast<Wide>(at.e) * u_n * u_n / v.squaredNorm(),
             sliding = u_t * u_t / v.squaredNorm();
  const Wide here = energy_left(at, star);
  for (const double f : {0.0, 0.3, 0.7, 0.95, 1.05, 1.5, 4.0}) {
    const Wide seen = energy_left(at, f * star), expected = smallest + (f < 1.0 ? (1 - f) * (1 - f) * sliding : 0);
    keep_worst(worst.rise, static_cast<double>(std::abs(seen - expected) / eps));
    keep_worst(worst.least, static_cast<double>((here - seen) / eps));
  }
}

// Two equal bodies that meet at v_n and v_t each: with friction below mu_d* each keeps v_t - (1 + e) v_n mu_d.
void symmetric_pair(Rows& rows) {
  const double v_n = 1.3, v_t = 0.9, e = 0.6;
  const Encounter at{.i = {.velocity = {v_n, v_t, 0.0}, .inverse_mass = 0.2},
                     .j = {.velocity = {-v_n, -v_t, 0.0}, .inverse_mass = 0.2},
                     .e = e};
  rows.compare("mu_d* of a symmetric pair, v_t/((1 + e) v_n)",
               {.expected = 0.432692307692307692,
                .computed = contact::stopping_friction(2.0 * v_t, 2.0 * v_n, e),
                .tolerance = relative(4e-16),
                .because = "0.9/2.08: one sum, one product, one division"});
  // 0.9 - 1.6 * 1.3 * mu_d
  for (const auto& [mu, kept] :
       {std::pair{0.1, 0.692}, std::pair{0.4, 0.068}, std::pair{0.43269231, 0.0}, std::pair{0.6, 0.0}}) {
    rows.compare(fmt::format("v_t after of a symmetric pair, mu_d = {} [m/s]", mu),
                 {.expected = kept,
                  .computed = static_cast<double>(parting(at, mu).y()) / 2.0,
                  .tolerance = absolute(1e-15),
                  .because = "differences of numbers near 1, each rounded a few times"});
  }
}

// Sliding along or against what it was, after random impacts with mu_d <= mu_s: over eps max|v|.
double worst_reversal(const Drawn& of, std::uint64_t seed, int count) {
  Encounters drawn(of, seed);
  double worst = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const contact::Rebound after = library_impact(at);
    const WideVector n = at.n.cast<Wide>();
    const auto across = [&](const WideVector& v) -> WideVector { return v - v.dot(n) * n; };
    const WideVector pushed = static_cast<Wide>(at.duration) * (at.acceleration_i - at.acceleration_j).cast<Wide>();
    const WideVector slip = across(at.i.velocity.cast<Wide>() - at.j.velocity.cast<Wide>() + pushed);
    const WideVector left = across(after.velocity_i.cast<Wide>() - after.velocity_j.cast<Wide>());
    const double against = static_cast<double>(-left.dot(slip) / slip.norm());
    keep_worst(worst, against / (eps * (largest_speed(at, after.velocity_i, after.velocity_j) +
                                        static_cast<double>(pushed.norm()))));
  }
  return worst;
}

void prove_stopping_friction(Rows& rows) {
  symmetric_pair(rows);
  const int count = rows.quick() ? 5000 : 50000;
  Encounters drawn({.decades = 6.0, .bulk = 0.0}, rows.case_seed());
  Worst worst;
  for (int k = 0; k < count; ++k) {
    const Encounter at = drawn.next();
    const double u_n = (at.i.velocity - at.j.velocity).dot(at.n), speed = (at.i.velocity - at.j.velocity).norm();
    // At 76 degrees and between: sliding and approach both hold digits to compare.
    if (u_n > 0.05 * speed && u_n < 0.95 * speed) look(at, worst);
  }
  rows.at_most("vertex of the energy's parabola against mu_d*, relative",
               {.limit = 1e-12,
                .computed = worst.vertex,
                .because = "second difference of energies of 3 eps each, sliding 0.1 of the energy or more, step "
                           "0.4 mu_d*: 3 * 8 eps/(0.16 * 0.1) = 3e-13, and mu_d* itself"});
  rows.at_most("energy at 0 to 4 mu_d* against e^2 u_n^2 + (1 - f)^2 u_t^2, over eps of the whole",
               {.limit = 16.0,
                .computed = worst.rise,
                .because = "velocities after carry some 8 roundings, the energy is quadratic in them"});
  rows.at_most("how far any energy lies below the one at mu_d*, over eps of the whole",
               {.limit = 16.0, .computed = worst.least, .because = "as above: equal beyond mu_d*, where it sticks"});
  const char* const because =
      "u_t + P/m* with |P| <= m* |u_t|: exact arithmetic never passes zero; some ten roundings of speeds";
  rows.at_most("sliding reversed, in eps max|v|",
               {.limit = 12.0,
                .computed = worst_reversal({.decades = 6.0, .mu = 5.0}, rows.case_seed(), 4 * count),
                .because = because});
  rows.at_most(
      "sliding reversed with other forces, in eps max|v|",
      {.limit = 12.0,
       .computed = worst_reversal({.decades = 6.0, .mu = 5.0, .acceleration = 3000.0}, rows.case_seed(), 4 * count),
       .because = because});
}

const Case stopping_friction{
    {.name = "stopping_friction",
     .claim = "mu_d* = |u_t|/((1 + e) u_n) leaves the least energy whatever the masses, and friction with mu_d <= mu_s "
              "never reverses the sliding",
     .equation = "M 2.49",
     .reference = Reference::closed_form},
    prove_stopping_friction};

// A ball in a groove of two walls at right angles, which it meets at unlike speeds with e = 0: what stops it is decided
// from the sum of both pushes.
void prove_friction_of_a_groove(Rows& rows) {
  using Groove = scenes::Scene<kinematics::Space, contact::Contact<contact::ConstantRestitution, contact::Friction>>;
  Encounters drawn({}, rows.case_seed());
  double left_over = 0.0, off = 0.0, account = 0.0;
  long stuck = 0;
  const int count = rows.quick() ? 500 : 5000;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d along = drawn.direction(), one = along.cross(drawn.direction()).normalized(),
                          other = along.cross(one);
    const double first = drawn.positive(), second = k % 3 == 0 ? first : drawn.positive(), slip = 2.0 * drawn.uniform();
    const double mu_s = drawn.positive(), mu_d = mu_s * drawn.positive(), mass = std::pow(10.0, 3.0 * drawn.uniform());
    const Eigen::Vector3d v = slip * along - first * one - second * other;
    const kinematics::Particles ball{.position = kinematics::Vectors::Zero(1, 3),
                                     .velocity = v.transpose(),
                                     .mass = Eigen::VectorXd::Constant(1, mass),
                                     .radius = Eigen::VectorXd::Constant(1, 0.1)};
    const Groove groove{ball,
                        {{{.point = -0.099 * one, .normal = one}, {.point = -0.099 * other, .normal = other}}},
                        rough(0.0, {.mu_s = mu_s, .mu_d = mu_d})};
    const Jumped after = jump_of(groove, 1e-3);
    const double push = first + second, size = std::abs(slip);
    const bool sticks = size <= mu_s * push;
    const double expected = sticks ? 0.0 : size - mu_d * push;
    stuck += sticks ? 1 : 0;
    const Eigen::Vector3d w = after.v.row(0).transpose();
    keep_worst(sticks ? left_over : off, (w - std::copysign(expected, slip) * along).norm() / eps);
    const double change = 0.5 * mass * (expected * expected - v.squaredNorm());
    keep_worst(account, std::abs(after.jump.energy_change - change) / (eps * 0.5 * mass * v.squaredNorm()));
  }
  const char* const because = "speeds up to 2.5 m/s, some ten roundings each";
  rows.at_least("share of balls that stick",
                {.limit = 0.2, .computed = static_cast<double>(stuck) / count, .because = "else little is compared"});
  rows.at_most("speed left where mu_s times both pushes holds the ball, in eps m/s",
               {.limit = 32.0, .computed = left_over, .because = because});
  rows.at_most("velocity where it slides on, against |u_t| - mu_d (P_1 + P_2)/m, in eps m/s",
               {.limit = 32.0, .computed = off, .because = because});
  rows.at_most("energy taken against half the mass times the squares, in eps T",
               {.limit = 32.0, .computed = account, .because = "some ten roundings of impulses and mean velocities"});
}

const Case friction_of_a_groove{
    {.name = "friction_of_a_groove",
     .claim =
         "contacts of one moment stick or slide together: a groove stops a ball if mu_s (P_1 + P_2) can, else takes "
         "mu_d (P_1 + P_2), also where both walls are met at unlike speeds",
     .equation = "D 2.30",
     .reference = Reference::closed_form},
    prove_friction_of_a_groove};

}  // namespace verification::friction
