// The heat of impacts: per contact, over a colliding cloud, and in the energy of a run.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/verlet.hpp>

#include "spheres.hpp"

namespace verification::impacts_heat {

using namespace particulate;

// Constant accelerations of two particles.
struct Pushes {
  Eigen::Matrix<double, 2, 3> acceleration;
};
template <kinematics::Domain D>
bool add_force(const Pushes& law, const D&, const laws::At<>& at, laws::Forces force) {
  force += at.mass.asDiagonal() * law.acceleration;
  return true;
}

// Two that touch along x, and what happens to them.
struct Encounter {
  kinematics::Particles pair;
  double e, duration;
  Pushes pushes;
};

// Kinetic energy lost, and the work of the other forces, while the impulses act as constant forces: both bodies are
// moved in small steps through both phases, whatever the formulas of the library say [J].
double lost_and_worked(const Encounter& of, const contact::ImpactRecord& impact) {
  const Eigen::Vector3d impulse = impact.tangential - impact.push * impact.n;
  kinematics::Vectors v = of.pair.velocity;
  const double before = kinematics::kinetic_energy(of.pair.mass, v);
  double work = 0.0;
  constexpr int steps = 64;
  for (int k = 0; k < steps; ++k) {
    const kinematics::Vectors old = v;
    for (const Eigen::Index i : {0, 1}) {
      v.row(i) += of.duration / steps * of.pushes.acceleration.row(i);
      v.row(i) += (i == 0 ? 1.0 : -1.0) / steps / of.pair.mass[i] * impulse.transpose();
      work += of.duration / steps * of.pair.mass[i] * of.pushes.acceleration.row(i).dot(0.5 * (old.row(i) + v.row(i)));
    }
  }
  return before - kinematics::kinetic_energy(of.pair.mass, v) + work;
}

Encounter random_encounter(Uniform& uniform, double duration) {
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * (2.0 * Eigen::Array3d(uniform(), uniform(), uniform()) - 1.0));
  };
  const auto body = [&](double x, double v) {
    return kinematics::Particle{.position = {x, 0.0, 0.0},
                                .velocity = Eigen::Vector3d(v, 0.0, 0.0) + vector(0.5),
                                .mass = std::pow(10.0, 2.0 * uniform() - 1.0),
                                .radius = 0.5,
                                .temperature = 250.0 + 100.0 * uniform(),
                                .heat_capacity = 1.0 + uniform()};
  };
  Encounter of{.pair = kinematics::particles({body(0.0, 1.0), body(1.0, -1.0)}),
               .e = uniform(),
               .duration = duration,
               .pushes = {}};
  for (const Eigen::Index i : {0, 1}) of.pushes.acceleration.row(i) = vector(1.0);
  return of;
}

// What the heat of an encounter is, by the scene, and by what it may be compared with [J].
struct Heats {
  double by_temperatures, by_motion, by_formulas, reaction;
};
Heats heats_of(const Encounter& of, const thermo::ImpactHeat& law) {
  contact::ImpactRecord seen;
  BookContact contact{.restitution = {of.e}, .friction = {.mu_s = 0.2, .mu_d = 0.1}, .gamma = of.duration};
  contact.recorder = [&](const contact::ImpactRecord& one) { seen = one; };
  const scenes::Scene scene(of.pair, kinematics::Space{}, contact, of.pushes, law);
  schemes::State state = scenes::start(scene);
  // Over a short step, as what other forces press together within one is held.
  if (scene.jump(state, of.duration > 0.0 ? 1.0 : 1e-9).impacts != 1) throw std::runtime_error("the two did not meet");
  const double m_red = kinematics::reduced_mass(of.pair.mass[0], of.pair.mass[1]);
  const double delta1 = seen.meanwhile.dot(seen.n) / (1.0 + of.e), delta2 = of.e * delta1;
  const double slip = -seen.tangential.dot(0.5 * (seen.before + seen.after + seen.meanwhile));
  return {.by_temperatures = heat_gained(of.pair, state.y),
          .by_motion = lost_and_worked(of, seen),
          .by_formulas = contact::normal_heat(seen.before.dot(seen.n), delta1, delta2, of.e, m_red) + slip,
          .reaction = law.kappa * std::min(seen.push / law.J_star, 1.0) * std::numbers::pi * 0.25};
}

const Case contacts{
    {.name = "heat_of_a_contact",
     .claim = "what two bodies gain in heat in an impact is the kinetic energy that they lose, the work of the other "
              "forces meanwhile, and the energy of the reaction",
     .equation = "D 7.4.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      for (const double duration : {0.0, 0.3}) {
        double motion_off = 0.0, formulas_off = 0.0, least = infinity;
        for (int k = 0; k < 1000; ++k) {
          const Encounter of = random_encounter(uniform, duration);
          const Heats heat = heats_of(of, {.kappa = 0.4, .J_star = 0.5});
          const double size = kinematics::kinetic_energy(of.pair.mass, of.pair.velocity) + heat.by_temperatures +
                              of.pair.mass.cwiseProduct(of.pair.heat_capacity).dot(of.pair.temperature);
          motion_off =
              report::worse_of(motion_off, std::abs(heat.by_temperatures - heat.by_motion - heat.reaction) / size);
          formulas_off =
              std::max(formulas_off, std::abs(heat.by_temperatures - heat.by_formulas - heat.reaction) / size);
          least = std::min(least, heat.by_temperatures - heat.reaction);
        }
        const std::string during = fmt::format(", 1000 impacts of {} s, over the energies", duration);
        rows.at_most("off from both phases, step by step" + during,
                     {.limit = 1e-14, .computed = motion_off, .because = "rounding of 64 steps"});
        rows.at_most("off from q_n and the work of friction" + during,
                     {.limit = 1e-14, .computed = formulas_off, .because = "rounding"});
        rows.at_least("least heat but for the reaction [J]" + during,
                      {.limit = 0.0, .computed = least, .because = "no impact cools"});
      }
      rows.compare("m = 1 and 3 kg, u = 2, D1 = 0.1, D2 = 0.05 m/s, e = 0.5 [J]",
                   {.expected = 1.18125,
                    .computed = contact::normal_heat(2.0, 0.1, 0.05, 0.5, 0.75),
                    .tolerance = relative(1e-15),
                    .because = "rounding"});
    }};

// Energy that jumps took, from the states around them: observers see a step before its jump.
class Jumped {
 public:
  explicit Jumped(const Eigen::VectorXd& mass) : mass_(mass) {}
  template <class S>
  bool operator()(const schemes::State& from, const schemes::State& to, double, const S&) {
    if (from.t > 0.0) taken_ += before_ - kinematics::kinetic_energy(mass_, rows_of(from.v));
    before_ = kinematics::kinetic_energy(mass_, rows_of(to.v));
    return true;
  }
  double taken(const schemes::State& end) const {
    return taken_ + before_ - kinematics::kinetic_energy(mass_, rows_of(end.v));
  }

 private:
  const Eigen::VectorXd& mass_;
  double before_ = 0.0, taken_ = 0.0;
};

const Case cloud{
    {.name = "heat_of_a_cloud",
     .claim = "over all contacts of a colliding cloud the heat is what impacts took and the reactions released, and an "
              "immovable partner takes none of it",
     .equation = "D 7.4.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      for (const bool immovable : {false, true}) {
        kinematics::Particles start = warmed(book_cloud(100, rows.case_seed()));
        if (immovable) {
          start.immovable = std::vector<bool>(100, false), start.immovable[0] = true;
          start.velocity.row(0).setZero();
        }
        const thermo::ImpactHeat law{.kappa = 1e5, .J_star = 0.1};
        double released = 0.0;
        BookContact contact = book_contact();
        contact.recorder = [&](const contact::ImpactRecord& one) {
          released +=
              law.kappa * std::min(one.push / law.J_star, 1.0) * std::numbers::pi * std::pow(start.radius[0], 2);
        };
        const scenes::Scene scene(start, kinematics::Space{}, book_near_field, contact, law);
        schemes::State state = scenes::start(scene);
        Jumped jumped(start.mass);
        schemes::VelocityVerlet scheme;
        schemes::FixedStep control{.step = 2.5e-3};
        const schemes::Outcome outcome = schemes::integrate(scene, state, 2.0, scheme, control, std::ref(jumped));
        require_reached(outcome);
        const std::string of = immovable ? ", one immovable" : "";
        rows.at_least("impacts" + of,
                      {.limit = 60.0, .computed = static_cast<double>(outcome.impacts), .because = "many a contact"});
        rows.compare("heat [J]" + of, {.expected = jumped.taken(state) + released,
                                       .computed = heat_gained(start, state.y),
                                       .tolerance = relative(1e-11),
                                       .because = "roundings of temperatures of 300 K, of 4e5 J a body"});
        rows.compare("outcome, released [J]" + of, {.expected = released,
                                                    .computed = outcome.released,
                                                    .tolerance = relative(1e-12),
                                                    .because = "the same sum"});
        if (immovable) rows.none("immovable body is warmer", state.y[0] != 300.0, "the other takes all");
      }
    }};

// A few spheres that fall in upon each other, attracted and repelled.
auto few(double e, const auto& contact_of) {
  const kinematics::Particles start = warmed(book_cloud(27, 3), 300.0, 1.0);
  return scenes::Scene(start, kinematics::Space{}, weak_near_field, contact_of(e),
                       thermo::ImpactHeat{.kappa = 10.0, .J_star = 1.0});
}

struct Drift {
  double energy;  // change of all energies less what was released, over the kinetic energy at the start [-]
  long impacts;
};
template <class S>
Drift drift_of(const auto& scene, double t_end, long steps, S scheme) {
  schemes::State state = scenes::start(scene);
  const double before = total_energy(scene, state),
               kinetic = kinematics::kinetic_energy(scene.particles().mass, rows_of(state.v));
  const schemes::Outcome outcome =
      reached(scene, state, t_end, scheme, schemes::FixedStep{.step = t_end / static_cast<double>(steps)});
  return {(total_energy(scene, state) - before - outcome.released) / kinetic, outcome.impacts};
}

const Case in_time{
    {.name = "total_energy_in_time",
     .claim = "kinetic, potential and thermal energy less what was released stays: to order 2 with velocity Verlet, to "
              "order 1 with the monograph's scheme, to rounding with located contacts",
     .equation = "D 7.4.1",
     .reference = Reference::convergence},
    [](Rows& rows) {
      constexpr double t_end = 1.37;
      const auto stepped = few(0.5, [](double e) { return contact::Contact<>{.restitution = {e}}; });
      const auto summed = few(0.5, [](double e) {
        return contact::Contact<>{.restitution = {e}, .gamma = 0.01, .resolution = contact::Resolution::summed};
      });
      const auto located = few(0.5, [](double e) { return contact::LocatedContact<>{.restitution = {e}}; });
      const auto order = [&](const std::string& by, double nominal, const auto& scene, auto scheme, long coarsest) {
        std::vector<double> steps, errors;
        for (long n = coarsest; steps.size() < 5; n *= 2) {
          const Drift drift = drift_of(scene, t_end, n, scheme);
          steps.push_back(t_end / static_cast<double>(n)), errors.push_back(std::abs(drift.energy));
        }
        rows.order(by, {.nominal = nominal,
                        .steps = steps,
                        .errors = errors,
                        .floor = 1e-13,
                        .because = "smooth forces between impacts"});
      };
      order("velocity Verlet", 2.0, stepped, schemes::VelocityVerlet{}, 200);
      order("backward Euler, contacts summed", 1.0, summed, schemes::BackwardEuler{}, 3000);
      const Drift exact = drift_of(located, t_end, 400, schemes::Collocation<schemes::Gauss<6>>{});
      rows.at_most(
          "located contacts, Gauss 6, over the kinetic energy",
          {.limit = 1e-12, .computed = std::abs(exact.energy), .because = "rounding of temperatures of 300 K"});
      rows.at_least("impacts",
                    {.limit = 5.0, .computed = static_cast<double>(exact.impacts), .because = "else nothing"});
    }};

}  // namespace verification::impacts_heat
