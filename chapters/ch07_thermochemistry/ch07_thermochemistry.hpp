//! @page ch07_shared Chapter 7: What its pages share
//! @brief The parameters of the chapter, its spheres, and one flight of a cloud with bonds and heat.
//! @tableofcontents
//!
//! @section ch07_parameters Parameters
//!
//! Of the monograph, captions tell restitution, friction, the strengths of the near fields and the four energies of the
//! reaction. All other numbers are our choice, and so is the shape of what they enter.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/friction.hpp>
#include <particulate/contact/restitution.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/kinematics/starts.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/outcome.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/thermo/clusters.hpp>

namespace ch07 {

using namespace particulate;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  int& particles = line.field(
      1000, {"particles", "spheres of a cloud, seven tenths of them with --quick", "-", between(600, 1400), "4.1"});
  int& seeds = line.field(8, {"seeds", "starts of every comparison, half with --quick", "-", between(4, 10), ours});
  double& duration = line.field(1.0, {"duration", "of the flight of a cloud", "s", between(0.2, 1.2), "4.1"});
  double& step = line.field(0.0025, {"step", "of it, Dt", "s", between(0.001, 0.004), ours});
  double& F_b = line.field(200.0, {"bond_strength", "of the bonds, F_b", "N/kg^2", between(50.0, 300.0), ours});
  double& d_b = line.field(0.08, {"d_b", "distance at which a bond ends", "m", between(0.04, 0.1), ours});
  double& link =
      line.field(0.07, {"link", "distance up to which two spheres count as linked", "m", between(0.055, 0.08), ours});
  double& kappa = line.field(
      8e6, {"kappa", "energy of a full reaction per area, the largest of four", "J/m^2", between(1e6, 1e9), "7.5.3"});
  double& J_star = line.field(0.1, {"impulse", "of a full reaction, J*", "N s", between(0.02, 1.0), ours});
  double& c = line.field(4000.0, {"c", "heat capacity of the spheres", "J/(kg K)", between(500.0, 5000.0), ours});
  double& theta_star = line.field(
      600.0, {"theta_star", "temperature at which restitution has softened away", "K", between(300.0, 2000.0), ours});
  double& charge = line.field(10.0, {"charge", "of the obstacle, as a mass", "kg", between(2.0, 20.0), ours});
  double& window = line.field(0.02, {"window", "over which impulses are gathered", "s", between(0.005, 0.1), ours});
};

//! What no flight can be made of, such as bonds that end where spheres touch, is refused before anything is written:

void validate(const Parameters& p);

//! @section ch07_spheres Spheres
//!
//! Spheres are those of chapter 4's thousand. A cloud of fewer fills a smaller cube as densely, so that they stay what
//! they are.

inline constexpr double radius = 0.025, theta_0 = 300.0;                     // 4.1 [m]; at the start [K]
inline constexpr laws::NearField near_field{.alpha1 = 0.5, .alpha2 = 0.25};  // 7.5.3

// So many spheres in a box, with a velocity each, uniformly distributed within `spread` of the mean.
kinematics::Particles cloud_in(const kinematics::Box& box, int count, const Eigen::Vector3d& mean,
                               const Eigen::Vector3d& spread, double c, std::uint64_t seed);

// One set after the other, without heat.
kinematics::Particles together(const kinematics::Particles& a, const kinematics::Particles& b);

//! Charged clouds are fast, and take shorter steps than the parameter. Each is drawn at so many times.

inline constexpr double charged_step = 0.001;  // [s]
inline constexpr int pictures = 20;

//! Contacts are those of chapter 4, too. Whether restitution softens as spheres warm is left open.

template <class R>
contact::Contact<R, contact::Friction> contact_with(const R& restitution) {
  return {.restitution = restitution, .friction = {.mu_s = 0.2, .mu_d = 0.1}};  // 7.5.3
}
inline constexpr contact::Restitution cold{.e_o = 0.5, .v_star = 10.0, .e_minus = 0.1};  // 7.5.3, 4.1

//! @section ch07_flights A flight of a cloud

struct Flight {
  std::uint64_t seed;
  double kappa, step;  // [J/m^2], [s]
  bool bonds = true, softens = false, watched = false;
  std::vector<schemes::State> moments = {};  // if it is watched
  schemes::State end = {};
  schemes::Outcome outcome = {};
  Eigen::MatrixXd history = {};      // rows of scenes::History
  double relative = NAN;             // energy at the end [J/kg]
  double deepest = NAN, left = NAN;  // overlap over a diameter, of the flight and at its end [-]
  double rise = NAN;                 // of the mean temperature [K]
  thermo::Clusters linked = {};
};

//! With bonds every start is flown with other steps as well, of which these are the shares:

inline constexpr std::array<double, 3> steps{2.0, 1.0, 0.5};

//! @section ch07_shared_runs Many runs
//!
//! Starts share nothing, so that threads share them (particulate::report::for_each_run). A table lists what came of them
//! in their order.

int seeds_of(const Parameters& p);  // of this run: fewer with --quick
int particles_of(const Parameters& p);
std::uint64_t seed_of(const Parameters& p, int k);
void require_end(const schemes::Outcome& outcome);  // std::runtime_error otherwise

// The numbers from 0 to the last one, in so many equal parts.
std::vector<double> evenly(int parts, double last);

using report::worse_of;

// Those that have something in common, in their order.
template <class Has>
std::vector<Flight> those(const std::vector<Flight>& all, const Has& has) {
  std::vector<Flight> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), has);
  return some;
}

// Of all starts, with the whole reaction and the step of the parameters.
std::vector<Flight> alike(const Parameters& p, const std::vector<Flight>& all, bool bonds, bool softens);

// A number that each has, and the standard deviation of several.
Eigen::VectorXd numbers_of(const std::vector<Flight>& flights, double Flight::*number);
double scatter_of(const Eigen::VectorXd& numbers);

inline const char* yes_or_no(bool is) { return is ? "yes" : "no"; }

//! A page is a function. It writes its tables and adds what it claims.

std::vector<Flight> energies(const Parameters& p, report::Chapter& chapter);
void clusters(const Parameters& p, const std::vector<Flight>& all, report::Chapter& chapter);
void truncation(const report::Output& output, report::Checks& checks);
void heat(const Parameters& p, report::Chapter& chapter);
void obstacle(const Parameters& p, report::Chapter& chapter);
void meetings(const Parameters& p, report::Chapter& chapter);

//! Some of what the captions tell is seen with the chapter's own numbers, and claimed of them. With others a run says
//! what came of it.

void claim_of_own(const Parameters& p, report::Chapter& chapter, const std::string& claim, double error,
                  double allowed);

}  // namespace ch07
