//! @page ch07_thermochemistry Chapter 7: Bonds, heat and charges
//! @brief Clouds whose spheres bind each other, warm where they hit, and keep away from what is charged alike.
//! @tableofcontents
//!
//! @section ch07_question What is added to a cloud
//!
//! Chapter 7 of the monograph @cite zohdi2007 adds to the clouds of chapter 4 what many particulate flows live by: a
//! force of short reach that binds spheres once they are near; heat, which impacts make of motion and of a reaction on
//! the surfaces; and charges.
//!
//! @figure{ch07_bond, Force and potential of a bond\, from touching to its end: what makes spheres cluster\, Figure 7.1.}
//!
//! - What do bonds do to the energy of a cloud and to its temperature? @subpage ch07_energies
//! - What are clusters like, and how far may stepped contact be trusted within them? @subpage ch07_clusters
//! - Where may a near field be cut off, and why? @subpage ch07_truncation
//! - What becomes of heat between impacts, and who drives whom? @subpage ch07_heat
//! - What does an obstacle feel of a cloud that is charged as it is? @subpage ch07_obstacle
//! - When do two clouds that meet merge, and when do they disperse? @subpage ch07_meetings
//!
//! Build and run it alone with
//!
//! @verbatim
//! cmake --preset release && cmake --build --preset release --target ch07_thermochemistry
//! build/release/bin/ch07_thermochemistry --out ch07 --threads 2
//! @endverbatim
//!
//! On two threads that takes half a minute, with `--quick` some fifteen seconds on one.
//!
//! @section ch07_model Bonds and heat
//!
//! All forms below are *reconstructions* (@ref provenance "marks R 7.2, 7.4.1 and 7.4.2"): subject and parameters are
//! the monograph's, the expressions are ours.
//!
//! A **bond** (particulate::thermo::Binding) attracts from the distance \f$ d_b \f$ to touching,
//! \f$ d_0 = b_i + b_j \f$:
//!
//! \f[ \Psi_i^b = \sum_j F_b\, m_i m_j\, W(x_{ij})\, n_{ij}, \qquad W = 16\, x^2 (1-x)^2, \qquad
//!     x = \frac{d - d_0}{d_b - d_0}, \quad 0 \le x \le 1 . \f]
//!
//! It vanishes at touching. An attraction that acts there would draw spheres into each other, as contact at the end of
//! a step takes an approach away but not an overlap.
//!
//! @figure{ch07_impact, An impact: what it takes from the motion\, q\, and what its impulse J sets free by reaction\, H\, warms both spheres: Figure 7.4.}
//!
//! **Heat of an impact**, Stage I (particulate::thermo::ImpactHeat): two spheres that hit keep their places and gain
//!
//! \f[ m_i c_i\, \Delta\theta_i + m_j c_j\, \Delta\theta_j = q + H, \qquad
//!     H = \kappa \min\!\left(\frac{J}{J^*}, 1\right) \pi \min(b_i, b_j)^2, \f]
//!
//! half each, where \f$ q \f$ is the kinetic energy that is lost and \f$ H \f$ the chemical energy that the normal
//! impulse \f$ J \f$ sets free, all of it from \f$ J^* \f$ on. The scale is an impulse and no force: with a force the
//! heat would depend on the step. Between impacts follows Stage II, @ref ch07_heat "on its page".
//!
//! **Softening**, ours and off unless it is said: restitution may fall with the mean temperature of the two
//! (particulate::contact::SofteningRestitution),
//!
//! \f[ e = \max\!\left(e_o \max\!\left(1 - \frac{u}{v^*}, 0\right)
//!     s(\theta_m),\; e^-\right), \qquad
//!     s = \min\!\left(\max\!\left(1 - \frac{\theta_m - \theta_r}{\theta^* - \theta_r}, 0\right), 1\right) . \f]
//!
//! @section ch07_program The program
//!
//! The parameters, and what the pages share, stand on @subpage ch07_shared.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/report/progress.hpp>
#include <particulate/thermo/binding.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {

//! Velocities are drawn after all places, from the same engine.

kinematics::Particles cloud_in(const kinematics::Box& box, int count, const Eigen::Vector3d& mean,
                               const Eigen::Vector3d& spread, double c, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_01<double> uniform;
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(count), b = radius * one;
  kinematics::Particles cloud{
      .position = kinematics::random_addition(b, {.box = box}, [&] { return uniform(engine); }).position,
      .velocity = kinematics::Vectors(count, 3),
      .mass = 2000.0 * 4.0 / 3.0 * std::numbers::pi * b.array().cube(),  // 4.1: 2000 kg/m^3
      .radius = b,
      .temperature = theta_0 * one,
      .heat_capacity = c * one};
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) cloud.velocity(i, k) = mean[k] + spread[k] * (2.0 * uniform(engine) - 1.0);
  }
  return cloud;
}

kinematics::Particles together(const kinematics::Particles& a, const kinematics::Particles& b) {
  const Eigen::Index N = a.size() + b.size();
  kinematics::Particles both{.position = kinematics::Vectors(N, 3),
                             .velocity = kinematics::Vectors(N, 3),
                             .mass = Eigen::VectorXd(N),
                             .radius = Eigen::VectorXd(N)};
  both.position << a.position, b.position;
  both.velocity << a.velocity, b.velocity;
  both.mass << a.mass, b.mass;
  both.radius << a.radius, b.radius;
  return both;
}

void validate(const Parameters& p) {
  const kinematics::Particles two =
      kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = radius},
                             {.position = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = radius}});
  thermo::validate(thermo::Binding{.F_b = p.F_b, .d_b = p.d_b}, two);
  contact::validate(contact::SofteningRestitution{.cold = cold, .theta_r = theta_0, .theta_star = p.theta_star});
}

int particles_of(const Parameters& p) { return p.line.common().quick ? 7 * p.particles / 10 : p.particles; }
int seeds_of(const Parameters& p) { return p.line.common().quick ? p.seeds / 2 : p.seeds; }
std::uint64_t seed_of(const Parameters& p, int k) { return p.line.common().seed + static_cast<std::uint64_t>(k); }

void require_end(const schemes::Outcome& outcome) {
  if (outcome.status != schemes::Status::reached) throw std::runtime_error(describe(outcome));
}

std::vector<double> evenly(int parts, double last) {
  std::vector<double> numbers;
  for (int k = 0; k <= parts; ++k) numbers.push_back(k * last / parts);
  return numbers;
}

std::vector<Flight> alike(const Parameters& p, const std::vector<Flight>& all, bool bonds, bool softens) {
  return those(all, [&](const Flight& one) {
    return one.bonds == bonds && one.softens == softens && one.kappa == p.kappa && one.step == p.step;
  });
}

Eigen::VectorXd numbers_of(const std::vector<Flight>& flights, double Flight::*number) {
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(flights.size()));
  std::transform(flights.begin(), flights.end(), numbers.begin(), [&](const Flight& one) { return one.*number; });
  return numbers;
}

double scatter_of(const Eigen::VectorXd& numbers) {
  return std::sqrt((numbers.array() - numbers.mean()).square().sum() / static_cast<double>(numbers.size() - 1));
}

//! A run with the chapter's own numbers is one that was given none:

void claim_of_own(const Parameters& p, report::Chapter& chapter, const std::string& claim, double error,
                  double allowed) {
  if (p.line.has_defaults()) return chapter.claims("checks").add(claim, error, allowed);
  chapter.note(fmt::format("{}: {:.3g}; with the chapter's own numbers at most {:.3g}.", claim, error, allowed));
}

void run(const Parameters& p, report::Chapter& chapter) {
  clusters(p, energies(p, chapter), chapter);
  truncation(chapter.output(), chapter.claims("checks"));
  heat(p, chapter);
  obstacle(p, chapter);
  meetings(p, chapter);
}

}  // namespace ch07

int main(int argc, char** argv) {
  using namespace particulate;
  return report::run_chapter(argc, argv,
                             {.name = "ch07_thermochemistry",
                              .summary = "Chapter 7: clouds with bonds, heat of impacts, and charges.",
                              .out = "ch07",
                              .figures = "chapters/ch07_thermochemistry/figures.gp"},
                             laws::name(laws::best_kernel()), ch07::run);
}

//! @section ch07_film The bound cloud in motion
//!
//! @animation{ch07_film, The cloud with bonds about its centre\, seen along z. Colour: temperature\, from 300 K (blue) to 400 K and above (red).}
//!
//! @section ch07_results What held
//!
//! @table{ch07_checks}
//!
//! @table{ch07_summary}
//!
//! The parameters of the run that made these pages:
//!
//! @parameters{ch07}
//!
//! @section ch07_discussion Discussion
//!
//! Ours, from what these pages show:
//!
//! - *Bonds cool the motion and heat the matter.* They take relative energy because they make spheres hit again and
//!   again, and each hit heats. Both follow the number of impacts.
//! - *Here heat is a passenger.* It is carried along, and acts on nothing within a step; a staggered scheme has nothing
//!   to iterate. Two-way coupling is chapter 3's pair of fields, and chapter 8's fluid.
//! - *One start proves little.* Every comparison is one over several starts, as impacts amplify any difference.
//! - *Stepped contact is a matter of the step.* Overlap shrinks with it, in proportion; the answers hardly move.
//! - *A sign may belong to a parameter.* That charges protect an obstacle is true of like charges.
