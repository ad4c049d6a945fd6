//! @page ch02_contact Chapter 2: Contact
//! @brief What happens when particles touch: restitution, friction, energy, and many contacts at once.
//! @tableofcontents
//!
//! @section ch02_question What an impact keeps, and what it takes
//!
//! Chapter 2 of the monograph @cite zohdi2007 writes the motion of every particle as
//!
//! \f{equation}{ m_i \ddot r_i = \Psi_i^{nf} + \Psi_i^{con} + \Psi_i^{fric}, \tag{2.1} \label{eq:flow} \f}
//!
//! and asks for the last two forces, which act only while particles touch. They are enormous and brief, so the chapter
//! never resolves them in time: it asks what velocities are left afterwards. With \f$ n \f$ the unit vector from i to
//! j, \f$ u = v_{in} - v_{jn} \f$ the approach speed and \f$ m^* \f$ the reduced mass, all of it follows from one
//! impulse on i,
//!
//! \f{equation}{ J = -(1 + e)\, m^* (u + \Delta_1), \tag{J} \label{eq:impulse} \f}
//!
//! where \f$ \Delta_1 \f$ is what the other forces add to the approach while it lasts. This program follows one impact
//! through its two phases, lets spheres meet head-on and obliquely, finds how much friction is too much, resolves
//! several contacts at once, and closes the books of a colliding cloud. Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch02_contact
//! build/release/bin/ch02_contact --out ch02
//! @endverbatim
//!
//! It takes a second or two, with `--quick` half of that. Every parameter below is an option (`--help` lists them), a
//! run writes the `parameters.toml` that repeats it, and the exit status says whether every check at the end of this
//! page held.
//!
//! @section ch02_program The program
//!
//! It needs the laws of contact, scenes to put them in, a scheme that moves the cloud, and the report.

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/impact.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

namespace {

using namespace particulate;

//! @subsection ch02_parameters Parameters
//!
//! Restitution, friction and the duration of an impact are those of the monograph's simulations in chapter 4. The near
//! field of the cloud is weaker and of shorter reach than there: attraction and repulsion balance where two spheres of
//! the cloud touch.

using report::between;
constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  double& e =
      line.field(0.5, {"e", "restitution of every impact but the elastic ones", "-", between(0.0, 1.0), "chapter 4"});
  double& mu_s =
      line.field(0.2, {"mu_s", "static friction in the cloud, at least mu_d", "-", between(0.0, 10.0), "chapter 4"});
  double& mu_d = line.field(0.1, {"mu_d", "dynamic friction in the cloud", "-", between(0.0, 10.0), "chapter 4"});
  double& v_star =
      line.field(10.0, {"v_star", "speed at which restitution has fallen", "m/s", between(0.01, 1e4), "chapter 4"});
  double& e_minus =
      line.field(0.1, {"e_minus", "floor of restitution, at most e", "-", between(0.0, 1.0), "chapter 4"});
  double& gamma =
      line.field(0.01, {"gamma", "duration of an impact over the step", "-", between(1e-9, 0.1), "chapter 4"});
  double& push = line.field(
      0.4, {"push", "other forces during an impact, as a share of the approach speed", "-", between(-0.9, 2.0), ours});
  double& angle = line.field(30.0, {"angle", "oblique impact, from the normal", "degrees", between(1.0, 89.0), ours});
  double& alpha1 = line.field(0.1, {"alpha1", "attraction in the cloud", "N m/kg^2", between(0.0, 1.0), ours});
  double& alpha2 = line.field(0.01, {"alpha2", "repulsion in the cloud", "N m^2/kg^2", between(0.0, 1.0), ours});
  double& step = line.field(2e-4, {"step", "step of the cloud", "s", between(1e-5, 5e-3), ours});
  double& duration = line.field(0.8, {"duration", "duration of the cloud's motion", "s", between(0.01, 1.0), ours});
  int& side = line.field(4, {"side", "spheres along each edge of the cloud", "-", between(2, 8), ours});
};

contact::Friction friction_of(const Parameters& p) { return {.mu_s = p.mu_s, .mu_d = p.mu_d}; }

contact::Restitution falling_of(const Parameters& p) { return {.e_o = p.e, .v_star = p.v_star, .e_minus = p.e_minus}; }

void validate(const Parameters& p) {
  const auto refuse_above = [](const char* lower, double below, const char* upper, double above) {
    if (below <= above) return;
    throw std::invalid_argument(fmt::format("{} must be at most {}, got {} and {}: give --{} {} too", lower, upper,
                                            below, above, lower, above));
  };
  refuse_above("e_minus", p.e_minus, "e", p.e);
  refuse_above("mu_d", p.mu_d, "mu_s", p.mu_s);
}

//! @subsection ch02_helpers Spheres, a cloud, and what is claimed
//!
//! Spheres of one kilogram and one metre across, at given places; and a cloud of small ones near the points of a cubic
//! lattice, whose velocities are a common drift and a random part. Equal seeds give equal clouds on every machine.

kinematics::Particles at_rest(const kinematics::Vectors& position) {
  const Eigen::Index count = position.rows();
  return {.position = position,
          .velocity = kinematics::Vectors::Zero(count, 3),
          .mass = Eigen::VectorXd::Ones(count),
          .radius = Eigen::VectorXd::Constant(count, 0.5)};
}

kinematics::Particles cloud_of(int side, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_real_distribution<double> uniform(-1.0, 1.0);
  kinematics::Particles cloud = at_rest(kinematics::Vectors(Eigen::Index{side} * side * side, 3));
  cloud.radius.setConstant(0.05);
  for (Eigen::Index k = 0; k < cloud.size(); ++k) {
    const std::array<Eigen::Index, 3> point{k % side, k / side % side, k / side / side};
    for (Eigen::Index c = 0; c < 3; ++c) {
      cloud.position(k, c) = 0.2 * static_cast<double>(point[static_cast<std::size_t>(c)]) + 0.02 * uniform(engine);
      cloud.velocity(k, c) = uniform(engine) + (c == 0 ? 1.0 : 0.0);
    }
  }
  return cloud;
}

// Where the spheres are, and how fast each moves about the centre of them all.
void add_places(report::Table& places, const schemes::State& state, Eigen::Index count) {
  const kinematics::Vectors r = state.r.reshaped(count, 3), v = state.v.reshaped(count, 3);
  const Eigen::RowVector3d bulk = v.colwise().mean();
  for (Eigen::Index i = 0; i < count; ++i) {
    places.add({state.t, r(i, 0), r(i, 1), r(i, 2), (v.row(i) - bulk).norm()});
  }
}

//! What a run claims is kept in one table, a particulate::report::Checks, with the error that was seen and the error
//! that is allowed. Comparisons are written so that a NaN fails them.

void run(const Parameters& p, report::Chapter& chapter) {
  const contact::Friction friction = friction_of(p);
  const contact::Restitution falling = falling_of(p);
  const report::Output& output = chapter.output();
  const Eigen::Vector3d n = Eigen::Vector3d::UnitX(), none = Eigen::Vector3d::Zero();
  constexpr double rounding = 1e-14;
  report::Checks& checks = chapter.claims("checks");

  //! @section ch02_phases 1. Compression and recovery
  //!
  //! An impact lasts \f$ \delta t = \gamma\,\Delta t \f$, a small part of the step. First the spheres press into each
  //! other until both move alike; then they recover, for \f$ \delta t_2 = e\,\delta t_1 \f$. The balance of momentum of
  //! each body over each phase, with \f$ \mathcal{E} \f$ for the impulses of all other forces, leaves two things to
  //! know:
  //!
  //! \f{equation}{ \Delta_1 = \frac{\mathcal{E}_{in}(t, t+\delta t_1)}{m_i} -
  //! \frac{\mathcal{E}_{jn}(t, t+\delta t_1)}{m_j}, \tag{2.15} \f}
  //!
  //! and \f$ \Delta_2 \f$ likewise over the recovery. The contact must stop the approach \f$ u \f$ and whatever the
  //! other forces, the partner's near field included, add to it, which takes the impulse \f$ -m^*(u + \Delta_1) \f$.
  //! Recovery gives back the share e of that impulse, hence \f$\eqref{eq:impulse}\f$. We let a force push the heavier
  //! of two bodies all the while, far harder than a near field would, so that it shows.

  const contact::Body heavy{.velocity = n, .inverse_mass = 0.5}, light{.velocity = -0.5 * n, .inverse_mass = 1.0};
  const double u = (heavy.velocity - light.velocity).dot(n), reduced = 1.0 / (heavy.inverse_mass + light.inverse_mass);
  const double lasts = p.gamma * p.step;
  const contact::Phases parts = contact::phases(lasts, p.e);

  report::Table phases({"time [impacts]", "i pushed [m/s]", "j pushed [m/s]", "i alone [m/s]", "j alone [m/s]"});
  std::array<contact::Rebound, 2> met;
  std::array<double, 2> turn_i{}, turn_j{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Eigen::Vector3d a = (k == 0 ? p.push * u / lasts : 0.0) * n;
    met[k] = contact::impact(heavy, light, n, p.e, a, none, lasts, contact::Frictionless{});
    const double stops = met[k].impulse.normal / (1.0 + p.e);
    turn_i[k] = heavy.velocity.dot(n) + heavy.inverse_mass * stops + a.dot(n) * parts.compression;
    turn_j[k] = light.velocity.dot(n) - light.inverse_mass * stops;
  }
  const auto along = [&](const Eigen::Vector3d& v) { return v.dot(n); };
  const double at_i = along(heavy.velocity), at_j = along(light.velocity);
  phases.add({0.0, at_i, at_j, at_i, at_j});
  phases.add({parts.compression / lasts, turn_i[0], turn_j[0], turn_i[1], turn_j[1]});
  phases.add(
      {1.0, along(met[0].velocity_i), along(met[0].velocity_j), along(met[1].velocity_i), along(met[1].velocity_j)});
  output.write("phases", phases);
  checks.add("both bodies move alike when compression ends [m/s]", turn_i[0] - turn_j[0], rounding);
  checks.add("they part with e u, whatever pushes them [m/s]", along(met[0].velocity_j - met[0].velocity_i) - p.e * u,
             rounding);

  //! @figure{ch02_phases, Normal velocities through one impact: compression until both move alike\, then recovery. Solid: one body is pushed all the while; dashed: no other forces.}
  //!
  //! The push shifts where the two lines meet, and both bodies leave faster to the same side. Yet they part with
  //! exactly \f$ e\,u \f$: a constant force gives \f$ \Delta_2 = e\,\Delta_1 \f$, and the extra impulse of the contact
  //! undoes in relative motion what the force did. Restitution put in is restitution got out.
  //!
  //! The formula needs one guard. If the other forces pull the pair apart, \f$ \Delta_1 < 0 \f$, faster than it
  //! approaches, there is nothing to compress, and \f$\eqref{eq:impulse}\f$ alone would glue the two together:

  report::Table pull({"other forces / approach [-]", "formula alone [N s]", "contact [N s]"});
  double strongest_pull = -1.0;
  for (const double share : {-1.5, -1.25, -1.0, -0.75, -0.5, 0.0, 0.5}) {
    const double J = contact::normal_impulse(u, share * u, p.e, reduced);
    pull.add({share, (1.0 + p.e) * reduced * (-1.0 - share) * u, J});
    strongest_pull = report::worse_of(strongest_pull, J);
  }
  output.write("pull", pull);
  checks.add("a contact never pulls: largest impulse towards the other [N s]", std::max(strongest_pull, 0.0), 0.0);

  //! @table{ch02_pull}
  //!
  //! Impulses on i along n: negative pushes it back. A contact acts if \f$ u > 0 \f$ and \f$ u + \Delta_1 > 0 \f$, and
  //! a positive entry in the last column would be a pull.
  //!
  //! @section ch02_head_on 2. Two identical spheres head-on
  //!
  //! With equal masses, opposite velocities and no other forces each sphere goes back with the share e of its speed.
  //! So their kinetic energy falls to the share \f$ e^2 \f$; for any pair
  //!
  //! \f[ T' - T = -\tfrac12\, m^* (1 - e^2)\, u^2, \f]
  //!
  //! the energy of the relative motion along n alone. What moves along with the pair is not touched.

  const auto meet = [&](const Eigen::Vector3d& v, double e, const contact::Friction& law) {
    return contact::impact({.velocity = v, .inverse_mass = 1.0}, {.velocity = -v, .inverse_mass = 1.0}, n, e, none,
                           none, 0.0, law);
  };
  const auto kept_of = [](const contact::Rebound& after) {  // of unit speeds
    return 0.5 * (after.velocity_i.squaredNorm() + after.velocity_j.squaredNorm());
  };
  report::Table head_on({"e [-]", "velocity of i [m/s]", "velocity of j [m/s]", "energy kept [-]"});
  double off_square = 0.0;
  for (int k = 0; k <= 50; ++k) {
    const double e = 0.02 * k;
    const contact::Rebound after = meet(n, e, {});
    head_on.add({e, along(after.velocity_i), along(after.velocity_j), kept_of(after)});
    off_square = report::worse_of(off_square, std::abs(kept_of(after) - e * e));
  }
  output.write("head_on", head_on);
  checks.add("head-on, equal spheres keep the share e^2 of their energy", off_square, rounding);

  //! @figure{ch02_head_on, Two identical spheres head-on: velocities after the impact\, and the share of energy that is left.}
  //!
  //! @section ch02_oblique 3. Two identical spheres obliquely, with friction
  //!
  //! If they also slide along each other, friction acts. It sticks if the impulse that stops the sliding is at most
  //! \f$ \mu_s |J| \f$; else it slides with \f$ \mu_d |J| \f$. For the symmetric pair, with speeds \f$ v_n, v_t \f$
  //! each,
  //!
  //! \f[ v_t' = v_t - (1 + e)\, v_n\, \mu_d, \qquad \mu_d \le \mu_d^* = \frac{v_t}{(1 + e)\, v_n}. \f]
  //!
  //! At \f$ \mu_d^* \f$ (2.49) the sliding just stops. Beyond it the formula would turn the sliding round, which
  //! friction cannot do; with \f$ \mu_d \le \mu_s \f$ the pair sticks there instead.

  const auto aimed = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return Eigen::Vector3d{std::cos(angle), std::sin(angle), 0.0};
  };
  const auto stopping = [&](double degrees) {
    return contact::stopping_friction(aimed(degrees).y(), aimed(degrees).x(), p.e);
  };
  report::Table oblique({"mu_d [-]", "mu_s = mu_d [m/s]", "mu_s = 2 mu_d [m/s]", "sliding formula alone [m/s]"});
  double reversed = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const double mu = 0.005 * k * stopping(p.angle);
    const double even = meet(aimed(p.angle), p.e, {.mu_s = mu, .mu_d = mu}).velocity_i.y();
    const double doubled = meet(aimed(p.angle), p.e, {.mu_s = 2.0 * mu, .mu_d = mu}).velocity_i.y();
    oblique.add({mu, even, doubled, aimed(p.angle).y() - (1.0 + p.e) * aimed(p.angle).x() * mu});
    reversed = std::min({reversed, even, doubled});
  }
  output.write("oblique", oblique);
  checks.add("friction never turns the sliding round [m/s]", reversed, rounding);

  //! @figure{ch02_oblique, Tangential speed of each sphere after an oblique impact. With a larger static coefficient the pair sticks earlier\, and what slid stops at once.}
  //!
  //! The energy after the impact tells why \f$ \mu_d^* \f$ is a limit. While the pair slides, the energy is a parabola
  //! in \f$ \mu_d \f$. Three sliding impacts fix it; its bottom is where friction takes most, and lies at
  //! \f$ \mu_d^* \f$. A sliding law that is followed further gives energy back, as the broken lines do.

  report::Table limits({"angle [degrees]", "mu_d [-]", "energy kept [-]", "sliding formula alone [-]"});
  report::Table bottoms({"angle [degrees]", "mu_d* [-]", "bottom of the parabola [-]", "energy kept there [-]"});
  double off_bottom = 0.0;
  for (const double degrees : {30.0, 45.0, 60.0}) {
    const auto kept = [&](double mu) { return kept_of(meet(aimed(degrees), p.e, {.mu_s = mu, .mu_d = mu})); };
    const double stop = stopping(degrees), h = 0.4 * stop;
    const double slope = (kept(2.0 * h) - kept(0.0)) / (2.0 * h);
    const double bend = (kept(2.0 * h) - 2.0 * kept(h) + kept(0.0)) / (h * h);
    const double bottom = h - slope / bend;
    for (int k = 0; k <= 140; ++k) {
      const double mu = 0.01 * k;
      limits.add({degrees, mu, kept(mu), kept(h) + slope * (mu - h) + 0.5 * bend * (mu - h) * (mu - h)});
    }
    bottoms.add({degrees, stop, bottom, kept(stop)});
    off_bottom = report::worse_of(off_bottom, std::abs(bottom / stop - 1.0));
  }
  output.write("limits", limits);
  output.write("bottoms", bottoms);
  checks.add("friction takes most energy at mu_d*, relative", off_bottom, 1e-12);

  //! @table{ch02_bottoms}
  //!
  //! @figure{ch02_limits, Energy kept against friction for three angles from the normal; discs mark mu_d*. Beyond it the pair sticks and nothing changes\, while the sliding formula alone (broken) would give energy back.}
  //!
  //! The flatter the impact, the more friction it takes to stop the sliding, and the more energy there is to lose.
  //! Steeper than the smallest angle shown, coefficients that look harmless are beyond the limit: the reason why the
  //! monograph asks for moderate ones.
  //!
  //! Friction has a price that is easily overlooked. The impulses on i and j are opposite, so momentum is kept; but
  //! they act across the line of centres, and the monograph's spheres have no spin that could take up their moment.
  //! Every impact changes the angular momentum by \f$ -(r_j - r_i) \times P_t \f$, with \f$ P_t \f$ the tangential
  //! impulse on i.

  const contact::Rebound rubbed = meet(aimed(p.angle), p.e, friction);
  const Eigen::Vector3d spun = n.cross(rubbed.velocity_j + aimed(p.angle));  // about i, where j alone has an arm
  checks.add("friction changes the angular momentum by its moment, no more [kg m^2/s]",
             (spun + n.cross(rubbed.impulse.tangential)).norm(), rounding);
  checks.add("friction changes no momentum [kg m/s]", (rubbed.velocity_i + rubbed.velocity_j).norm(), rounding);

  //! @section ch02_severity 4. Restitution that falls with speed
  //!
  //! Restitution is no constant of a material. Gentle impacts give back most, severe ones deform what they hit. The
  //! monograph idealizes the measured curve; we write it as
  //!
  //! \f[ e = \max\!\left(e_o\left(1 - \frac{|v_{in} - v_{jn}|}{v^*}\right),\; e^-\right). \f]

  report::Table severity(
      {"approach speed [m/s]", "e falling [-]", "e constant [-]", "parting, falling [m/s]", "parting, constant [m/s]"});
  for (int k = 0; k <= 150; ++k) {
    const double speed = 0.01 * k * p.v_star;
    const double e = restitution_at(falling, speed), same = restitution_at(contact::ConstantRestitution{p.e}, speed);
    severity.add({speed, e, same, e * speed, same * speed});
  }
  output.write("severity", severity);

  //! @figure{ch02_severity, Restitution against approach speed: a constant and a falling law\, and the speeds at which a pair parts.}
  //!
  //! The lower picture shows what a falling law implies: a pair that meets harder may part more slowly. The parting
  //! speed has its top at half the critical speed, and rises again only where the floor has taken over.
  //!
  //! @section ch02_several 5. Several contacts at once
  //!
  //! The monograph adds the impulses of all contacts of a particle, each computed from the velocities before. With two
  //! particles that is right. With three it is a choice, and it does not know the energy: every contact spends the same
  //! approach again. The library's default resolves contacts in sequence instead, the fastest approach first and equal
  //! ones together, until no pair approaches; friction is then decided for all contacts that have pushed together. We
  //! hit five elastic spheres in a row (Newton's cradle), one from both sides, and a pair with a third, and let both ways
  //! act until nothing approaches.

  constexpr double pressed = 31.0 / 32.0;  // spheres one metre across that touch for certain
  const double third = std::sqrt(0.75);
  kinematics::Vectors row(5, 3), trio(3, 3), wedge(3, 3);
  row << 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0;
  trio << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  wedge << 0, 0, 0, third, 0.5, 0, third, -0.5, 0;
  std::vector<std::pair<std::string, kinematics::Particles>> hits{{"cradle", at_rest(pressed * row)},
                                                                  {"one between two", at_rest(pressed * trio)},
                                                                  {"one into two", at_rest(pressed * wedge)}};
  for (auto& [name, start] : hits) start.velocity(0, 0) = 1.0;
  hits[1].second.velocity(2, 0) = -1.0;
  const auto resolved = [&](const kinematics::Particles& start, contact::Resolution how, int rounds) {
    const scenes::Scene scene{start, kinematics::Space{}, contact::Contact<>{.gamma = p.gamma, .resolution = how}};
    schemes::State state = scenes::start(scene);
    while (rounds-- > 0 && scene.jump(state, p.step).impacts > 0) continue;
    return kinematics::Vectors(velocities(state));
  };
  report::Table several(
      {"hit", "sphere", "before [m/s]", "summed, once [m/s]", "summed, repeated [m/s]", "sequential [m/s]"});
  report::Table several_energy({"hit", "summed, once [-]", "summed, repeated [-]", "sequential [-]"});
  double gained = 0.0, renumbered = 0.0;
  for (const auto& [name, start] : hits) {
    const kinematics::Vectors once = resolved(start, contact::Resolution::summed, 1);
    const kinematics::Vectors often = resolved(start, contact::Resolution::summed, 50);
    const kinematics::Vectors in_turn = resolved(start, contact::Resolution::sequential, 1);
    kinematics::Particles backwards = start;
    backwards.position = start.position.colwise().reverse();
    backwards.velocity = start.velocity.colwise().reverse();
    const kinematics::Vectors other_way = resolved(backwards, contact::Resolution::sequential, 1);
    for (Eigen::Index k = 0; k < start.size(); ++k) {
      several.add({name, k + 1, start.velocity(k, 0), once(k, 0), often(k, 0), in_turn(k, 0)});
    }
    const auto share = [&](const kinematics::Vectors& v) { return v.squaredNorm() / start.velocity.squaredNorm(); };
    several_energy.add({name, share(once), share(often), share(in_turn)});
    gained = report::worse_of(gained, std::abs(share(in_turn) - 1.0));
    renumbered = report::worse_of(renumbered, (other_way.colwise().reverse() - in_turn).cwiseAbs().maxCoeff());
  }
  output.write("several", several);
  output.write("several_energy", several_energy);
  checks.add("elastic hits resolved in sequence keep the energy, relative", gained, rounding);
  checks.add("numbering the spheres backwards changes nothing [m/s]", renumbered, rounding);

  //! Velocities along the hit, zeros up to rounding, and the energy after it over the energy before:
  //!
  //! @table{ch02_several}
  //!
  //! @table{ch02_several_energy}
  //!
  //! In the cradle adding does no harm, because contacts come into play one after the other, but it needs as many
  //! steps as there are contacts. Between two spheres the impulses on the middle one cancel while the outer ones have
  //! spent theirs, so an elastic hit stops dead. One into two is the dangerous case: both contacts take the whole
  //! approach, and energy appears from nowhere. In sequence, the equal contacts of the last two hits are resolved
  //! together, which keeps their symmetry, and the energy with it.
  //!
  //! @section ch02_stepped 6. What a step sees of a contact
  //!
  //! A scene looks for contacts at the end of each step. Spheres have then already sunk into each other a little, and
  //! the impulse comes late by part of a step: contact is a jump of velocities, in first order of the step, whatever
  //! the scheme between. Two spheres on a line tell by how much. Their true separation is known, and steps are
  //! quartered so that the contact falls on the same part of a step each time.

  kinematics::Particles pair = at_rest(kinematics::Vectors::Zero(2, 3));
  pair.position(1, 0) = 2.0;
  pair.velocity(0, 0) = 1.0;
  const scenes::Scene meeting{pair, kinematics::Space{}, contact::Contact<>{.restitution = {p.e}, .gamma = p.gamma}};
  report::Table stepped({"step [s]", "overlap [m]", "error of the separation [m]", "order [-]"});
  double last = 0.0, off_order = 0.0;
  for (int quarters = 0; quarters < 5; ++quarters) {
    schemes::State state = scenes::start(meeting);
    schemes::VelocityVerlet verlet;
    schemes::FixedStep control{.step = 0.15 * std::pow(0.25, quarters)};
    const schemes::Outcome outcome = schemes::integrate(meeting, state, 3.0, verlet, control);
    const double error = std::abs(position(state, 1).x() - position(state, 0).x() - (1.0 + 2.0 * p.e));
    const double order = std::log(last / error) / std::log(4.0);
    stepped.add({control.step, outcome.overlap, error, quarters == 0 ? report::Cell() : report::Cell(order)});
    if (quarters > 0) off_order = report::worse_of(off_order, std::abs(order - 1.0));
    last = error;
  }
  output.write("stepped", stepped);
  checks.add("stepped contact converges with order 1", off_order, 1e-6);

  //! @table{ch02_stepped}
  //!
  //! Every run reports its largest overlap, so nobody needs to guess whether the step was small enough. The impulse
  //! needs \f$ \Delta_1 \f$ over \f$ \gamma\,\Delta t \f$ only, a correction that fades with the step, so results
  //! hardly depend on \f$ \gamma \f$ (@ref verify_ch02_gamma_insensitive "measured"). But they add up where a ball
  //! bounces or rests for long: the step that follows applies the same forces again. So the library's own default is
  //! \f$ \gamma = 0 \f$, under which an elastic ball keeps its height and what rests is held
  //! (@ref verify_ch02_rest_and_elastic_bounces "measured" too).
  //!
  //! @section ch02_cloud 7. A colliding cloud and its books
  //!
  //! Everything together: spheres with a near field that draws them together, falling restitution and friction. The
  //! kinetic energy splits into the motion of the whole and the motion about it; the potential is that of chapter 1
  //! over all pairs; every step says what its impacts took. The sum must not change, but for the error of the scheme.
  //! Verlet's method keeps, to fourth order in the step, the energy of a neighbouring motion @cite hairer2006, which
  //! differs by
  //!
  //! \f[ \Delta t^2 \left( \tfrac{1}{12}\, v \cdot V'' v - \tfrac{1}{24} \sum_i m_i a_i^2 \right),
  //!     \qquad V'' v = -m\, \frac{da}{dt}, \f]
  //!
  //! from ours, so the sum may wander by as much and no more. An impact changes v at once, and with it the first term,
  //! by about the share of itself that it takes of the relative motion. What the books may miss so follows from the
  //! forces and velocities that the run meets, whatever the parameters.

  const kinematics::Particles cloud = cloud_of(p.side, chapter.common().seed);
  const laws::NearField near_field{.alpha1 = p.alpha1, .alpha2 = p.alpha2};
  const scenes::Scene scene{cloud, kinematics::Space{}, near_field,
                            contact::Contact<contact::Restitution, contact::Friction>{
                                .restitution = falling, .friction = friction, .gamma = p.gamma}};
  const double total_mass = cloud.mass.sum();
  schemes::State state = scenes::start(scene);
  schemes::VelocityVerlet verlet;
  schemes::FixedStep control{.step = (chapter.common().quick ? 2.0 : 1.0) * p.step};
  report::Table ledger(
      {"time [s]", "bulk [J]", "relative [J]", "potential [J]", "dissipated [J]", "total [J]", "impacts"});
  report::Table places({"time [s]", "x [m]", "y [m]", "z [m]", "speed about the centre [m/s]"});
  report::Progress progress("cloud", p.duration);
  double dissipated = 0.0, drift = 0.0, overlap = 0.0, travel = 0.0, total_before = 0.0, restored = 0.0;
  double omega_squared = 0.0, moving = 0.0, pushed = 0.0;  // largest v.V''v over m v.v, of it, and of m a.a
  Eigen::VectorXd a(state.r.size()), ahead(state.r.size());
  long impacts = 0;
  const double potential_before = scene.potential_energy(state);
  for (int k = 0; k <= 150; ++k) {
    const schemes::Outcome outcome = schemes::integrate(scene, state, k * p.duration / 150.0, verlet, control);
    if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
    dissipated -= outcome.energy_change;
    restored = report::worse_of(restored, outcome.energy_change);
    overlap = std::max({overlap, outcome.overlap, outcome.overlap_at_start});
    travel = report::worse_of(travel, outcome.travel);
    impacts += outcome.impacts;
    const kinematics::KineticEnergy kinetic = kinematics::split_kinetic_energy(cloud.mass, velocities(state));
    const double potential = scene.potential_energy(state) - potential_before;
    const double total = total_mass * (kinetic.bulk + kinetic.relative) + potential + dissipated;
    if (k == 0) total_before = total;
    const double twice_relative = 2.0 * total_mass * kinetic.relative;
    if (scene.acceleration(state.t, state.r, a) &&
        scene.acceleration(state.t, state.r + control.step * state.v, ahead)) {  // of one kilogram each
      omega_squared =
          report::worse_of(omega_squared, std::abs(state.v.dot(ahead - a)) / (control.step * twice_relative));
      pushed = report::worse_of(pushed, a.squaredNorm());
    }
    moving = report::worse_of(moving, twice_relative);
    drift = report::worse_of(drift, std::abs(total - total_before));
    ledger.add(
        {state.t, total_mass * kinetic.bulk, total_mass * kinetic.relative, potential, dissipated, total, impacts});
    if (k % 75 == 0) add_places(places, state, cloud.size());
    progress.at(state.t);
  }
  progress.wipe();
  output.write("ledger", ledger);
  output.write("places", places);
  report::Table& summary = chapter.summary();
  summary.add({"spheres", static_cast<double>(cloud.size())});
  summary.add({"impacts", static_cast<double>(impacts)});
  summary.add({"largest overlap, as a share of the radius", overlap / cloud.radius[0]});
  summary.add({"energy at the start [J]", total_before});
  summary.add({"energy that impacts took [J]", dissipated});
  summary.add({"largest error of the books [J]", drift});
  constexpr double deep = 0.1;  // shares of the radius
  if (!(overlap < deep * cloud.radius[0] && travel < 1.0)) {
    chapter.note(fmt::format(
        "the spheres of the cloud enter each other by up to {:.2g} of their radius, and move by up to {:.2g} "
        "of it in a step of {:.3g} s. Beyond {} and 1 they meet too late, or never: lower --step, or "
        "--alpha1.",
        overlap / cloud.radius[0], travel, control.step, deep));
  }
  const Eigen::Vector3d momentum = kinematics::linear_momentum(cloud.mass, velocities(state)) -
                                   kinematics::linear_momentum(cloud.mass, cloud.velocity);
  checks.add("the cloud's momentum stays [kg m/s]", momentum.norm(), 1e-10);
  const double neighbouring =
      control.step * control.step * (omega_squared * (moving + dissipated) / 6.0 + pushed / 12.0);
  checks.add("the cloud's books close [J]", drift, neighbouring + rounding * (total_before + dissipated));
  checks.add("impacts never give energy, in any interval [J]", restored, 0.0);
}

}  // namespace

//! @figure{ch02_places, The cloud at the start\, half-way and at the end\, seen along z. Colour: speed about the centre of them all.}
//!
//! @figure{ch02_ledger, A colliding cloud. Above: energy of its bulk and relative motion\, potential since the start\, what impacts took\, and the sum. Below: impacts so far.}
//!
//! @table{ch02_summary}
//!
//! The cloud falls together: potential turns into relative motion, and relative motion is what impacts take. Bulk
//! motion is left alone, because every force in the scene comes in pairs. At last the spheres lie on each other in a
//! clump, and impacts grow by orders of magnitude, although hardly any energy is left to take: a contact at rest is
//! an impact in every step, which undoes what the near field did in that step. Velocities stay right that way;
//! positions sink by a little in each step, and the overlap keeps count. With \f$ \gamma = 0 \f$ they would be held.

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch02_contact",
                              .summary = "Chapter 2: impact, restitution, friction, simultaneous contacts, a cloud.",
                              .out = "ch02",
                              .figures = "chapters/ch02_contact/figures.gp"},
                             laws::name(laws::best_kernel()), run);
}

//! @section ch02_results What held
//!
//! Where an identity is claimed, rounding is all that is allowed.
//!
//! @table{ch02_checks}
//!
//! The parameters of the run that made this page:
//!
//! @parameters{ch02}
//!
//! @section ch02_cost What a feature costs
//!
//! A scene is composed when it is compiled, so a law that it leaves out should cost nothing. The verification program
//! counts instructions, allocations and bytes of whole runs of 64 particles, with each feature absent, present but
//! idle, and used, beside the same forces written by hand. The count runs under valgrind, which hides AVX-512 from a
//! program: the near field is counted with its kernel for AVX2, where the processor has that.
//!
//! @table{ch02_feature_cost}
//!
//! Read a row against the others with its surroundings. An absent feature costs what the problem written by hand costs,
//! but for some ten instructions a particle that look after the lengths and the layout of the state, whatever the laws:
//! composition is free. What remains above the shortest loop is the run's own care, the checks that every state is
//! finite and the history that an observer may ask for; beside a near field whose pairs are taken four at once it is a
//! quarter, and falls with the number of particles. Contact is dear when idle because every pair is looked at;
//! where friction or a falling restitution is used, fewer impacts happen, so their rows are not the price of the law
//! alone (@ref verify_ch02_feature_cost "the rows").
//!
//! @section ch02_exercises Exercises
//!
//! 1. Derive \f$\eqref{eq:impulse}\f$ from the two balances of momentum, then let one mass grow without bound: what
//!    remains is the impact on a wall. Which of the library's functions had to know?
//! 2. Let three equal spheres with velocities 1, 0, -1 meet two by two, again and again. Show that the energy can fall
//!    below the share \f$ e^2 \f$ although no single impact takes that much.
//! 3. Give the spheres of section 3 a spin. What else must friction know, and which of the checks becomes a balance?
//! 4. Raise `--step` of the cloud and watch the overlap and the error of the books. Which grows with which power?
//! 5. Resolve the cloud's contacts with particulate::contact::Resolution::summed. How often do three spheres meet at
//!    once, and does it show in the ledger?
//! 6. Choose `--alpha1 0`. Which parts of the ledger can still change, and in which direction?
