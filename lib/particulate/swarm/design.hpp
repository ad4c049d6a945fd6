#pragma once

#include <functional>
#include <string>
#include <vector>

#include <particulate/identification/cost.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/swarm/flight.hpp>
#include <particulate/swarm/linear_drag.hpp>
#include <particulate/swarm/objective.hpp>
#include <particulate/swarm/speed_limit.hpp>
#include <particulate/swarm/target.hpp>

/// @file
/// What is designed, where it flies, and what is to be small: section 6.2.
///
///     const Course course = fence();
///     const Trial trial = fly(design, course, start);
///     evolve(objective({start}, course), design_bounds(), {.S = 20, .K = 6}, {.generations = 30}, population);

namespace particulate::swarm {

/// What the genetic algorithm chooses: strengths and exponents of the three interactions, in the order of its strings.
///
/// \f[ \Psi_i^{mm} = \frac{m_i}{M} \sum_{j \ne i} m_j \left(\alpha_1 d_{ij}^{\beta_1} - \alpha_2 d_{ij}^{-\beta_2}
///     \right) n_{ij} \f]
///
/// @equation{R 6.1} With M the mass of the whole swarm at its start, so that one design serves all sizes; of equal
/// members it is \f$ m_i \tfrac1N \sum_j \f$. Attraction grows with distance, so that beta1 is minus the near field's.
struct Design {
  double alpha1 = 0.0;   ///< attraction of members, >= 0 [N m^-beta1/kg]
  double alpha2 = 0.0;   ///< their repulsion, >= 0 [N m^beta2/kg]
  double beta1 = 0.0;    ///< exponent of attraction, <= 1; below 0 it falls with distance [-]
  double beta2 = 1.0;    ///< of repulsion, >= -1 [-]
  double alpha_o = 0.0;  ///< repulsion of obstacles, >= 0 [N m^beta_o/kg]
  double beta_o = 2.0;   ///< its exponent, > 0 [-]
  double alpha_t = 0.0;  ///< attraction of the target, >= 0 [N m^-beta_t/kg]
  double beta_t = 0.0;   ///< its exponent, 0 to 1 [-]
};

/// Refuses a design that is none. Called by fly().
///
/// @param design  a design
/// @throws std::invalid_argument naming the parameter, what must hold and what was given
void validate(const Design& design);

/// @param string  eight parameters, in the order of Design
/// @return the design
/// @throws std::invalid_argument for another number of them
Design design_of(const Eigen::VectorXd& string);
/// @param design  a design
/// @return its eight parameters, in their order
Eigen::VectorXd string_of(const Design& design);

/// Where designs are searched.
///
/// @equation{R 6.3} alpha1, alpha2, beta1 in [0, 1], beta2 in [0.5, 3], alpha_o in [0, 5], beta_o in [0.5, 4], alpha_t
/// in [0, 5], beta_t in [0, 1].
/// @return the bounds
identification::Box design_bounds();

/// Where a swarm flies, and how that is computed.
struct Course {
  std::vector<Eigen::Vector3d> obstacles = {};  ///< centres; none: nobody is lost [m]
  std::vector<double> radii = {};               ///< of the obstacles [m]
  Eigen::Vector3d target = {10.0, 0.0, 0.0};    ///< [m]
  double c_d = 1.0;                             ///< of LinearDrag, >= 0 [1/s]
  double v_max = 3.0;                           ///< of SpeedLimit, >= 0 [m/s]
  double duration = 15.0;                       ///< T, > 0 [s]
  double step = 0.02;                           ///< Dt, > 0 [s]
  double loss_penalty = 1.0;                    ///< on the objective if all are lost, >= 0 [-]
  laws::Kernel kernel = laws::Kernel::best;     ///< what adds the forces
};

/// The obstacle fence of section 6.3: nine obstacles of radius 0.5 at (5, 2i, 2j), i, j = -1 to 1, the target behind it
/// at (10, 0, 0). The centre obstacle, number 4, is at (5, 0, 0).
///
/// @equation{R 6.3}
/// @return the course
Course fence();

/// Refuses a course that cannot be flown. Called by fly().
///
/// @param course  a course
/// @throws std::invalid_argument naming what must hold and what was given: also where the target is inside an obstacle
void validate(const Course& course);

/// What members do to each other.
///
/// @equation{R 6.1}
/// @param design  a design
/// @param mass    M, of the whole swarm at its start, > 0 [kg]
/// @param kernel  what adds the forces
/// @return a near field
laws::NearField members_law(const Design& design, double mass, laws::Kernel kernel = laws::Kernel::best);

/// How a design flew.
struct Trial {
  /// \f$ \Pi \f$, the mean distance and the penalty for the lost; NaN: the flight failed [-]
  double objective;
  Flight flight;  ///< what became of the swarm
};

/// Is shown the whole swarm at the end of each step.
using Watcher = std::function<void(const schemes::State& swarm)>;

/// Flies a design over a course, by symplectic Euler.
///
/// \f[ \Pi = \frac1T \int_0^T \frac{\sum_i d_i(t)}{\sum_i d_i(0)}\,dt + w\, \frac{N_{lost}}{N} \f]
///
/// @equation{R 6.2} Objective and its penalty, w = Course::loss_penalty.
/// @param design   a design
/// @param course   where
/// @param start    the members
/// @param watcher  of the flight; none: nobody watches
/// @return the objective, and the flight
/// @throws std::invalid_argument for a design, a course or a start that cannot be meant
Trial fly(const Design& design, const Course& course, const kinematics::Particles& start, const Watcher& watcher = {});

/// What the genetic algorithm is to make small: the mean objective over several starts.
///
/// @equation{R 6.2}
/// @param starts  one at least
/// @param course  where
/// @return a cost of the strings of design_of(); without value where a flight fails
/// @throws std::invalid_argument for no start, and a course or a start that cannot be meant
identification::Cost objective(std::vector<kinematics::Particles> starts, Course course);

}  // namespace particulate::swarm
