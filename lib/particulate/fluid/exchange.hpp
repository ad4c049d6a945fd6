#pragma once

#include <optional>
#include <string>
#include <vector>

#include <particulate/fluid/heat_exchange.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/schemes/state.hpp>

/// @file
/// What particles and the fluid around them give to each other, particle by particle.

namespace particulate::fluid {

/// How what acts at a particle is spread over cells, and read from them: see Hats.
struct Spreading {
  std::optional<double> w = {};  ///< half-width of all particles; none: five radii of each [m]
  /// Whether the velocity that a particle feels is corrected for what it does itself to the cells around it,
  ///
  /// \f[ v_f \to v_f + \frac{\Psi}{g\, \mu_f\, w}, \qquad g = 13.9586 . \f]
  ///
  /// @equation{D 8.1.2} Of Stokes flow around a spread force, in a wide box, w much larger than h: there it is exact,
  /// and the slip is then \f$ 1 - 1.3504\, b/w \f$ of what is read without it. At larger Reynolds numbers of the hat a
  /// particle disturbs less than this says.
  bool corrected = false;
};

/// Which of two roots the implicit drag of particles took, where there were two: beside drag_crisis.
struct RootsTaken {
  long slow = 0;  ///< the slower one, of the larger drag
  long fast = 0;  ///< the faster one
};

/// Drag and heat between particles and a fluid that is known at each of them.
///
/// It holds what the particles got from the fluid, in a second or over a step: what the fluid then loses is the same.
class Exchange {
 public:
  /// @param particles   radii, masses and, with heat, heat capacities
  /// @param axes        directions that the fluid has, 1 to 3: across them no drag acts
  /// @param half_width  of the hats [m]
  /// @param corrected   see Spreading
  /// @param heat        none: no heat is exchanged
  Exchange(const kinematics::Particles& particles, int axes, const Eigen::VectorXd& half_width, bool corrected,
           std::optional<HeatExchange> heat);

  std::vector<Stream> around;  ///< the fluid at each particle

  /// Forces and heat flows, and what the fluid gives by them in a second.
  ///
  /// @equation{R 8.1.2}
  /// @param v      velocities, 3 N numbers [m/s]
  /// @param theta  temperatures, N; empty without heat [K]
  /// @param force  receives drag, 3 N [N]
  /// @param heat   receives heat flows, N; not touched without heat [W]
  /// @return whether all are finite
  bool rates(schemes::In v, schemes::In theta, Eigen::VectorXd& force, Eigen::VectorXd& heat);

  /// Motion over a step of backward Euler, its drag implicit with the coefficient of the iterate.
  ///
  /// \f[ v = v_0 + \frac{J + \Delta t\, \Psi^{other}}m, \qquad J = \Delta t\, \xi(v^K)\, (v_f - v), \qquad
  ///     r = r_0 + \Delta t\, v \f]
  ///
  /// @equation{R 8.4} The work is that of the mean velocity, so that it is the change of the kinetic energy.
  /// @param from   start of the step
  /// @param other  all other forces, 3 N [N]
  /// @param dt     step [s]
  /// @param v      velocities of the iterate; receives the new ones [m/s]
  /// @param r      receives the new places [m]
  /// @return whether all are finite
  bool move(const schemes::State& from, const Eigen::VectorXd& other, double dt, schemes::Out v, schemes::Out r);
  /// Temperatures over a step of backward Euler, convection implicit and radiation by its tangent at the iterate. After
  /// move().
  ///
  /// @equation{R 8.4}
  /// @param from   at the start of the step, N [K]
  /// @param other  all other heat flows, N [W]
  /// @param dt     step [s]
  /// @param theta  those of the iterate; receives the new ones [K]
  /// @return whether all are positive and finite
  bool warm(schemes::In from, const Eigen::VectorXd& other, double dt, schemes::Out theta);

  /// What each particle got from the fluid, in a second after rates(), over the step after move() and warm(): as many
  /// components of impulse as directions, then work and heat.
  ///
  /// @return axes + 1 numbers a particle [N s or N, J or W]
  const std::vector<double>& given() const { return given_; }
  /// @return what move() met
  const RootsTaken& roots() const { return roots_; }

  /// What limits a step, particle by particle.
  struct Rates {
    Eigen::VectorXd mass;      ///< m, beyond any fluid's where immovable [kg]
    Eigen::VectorXd drag;      ///< xi [kg/s]
    Eigen::VectorXd capacity;  ///< m c [J/K]
    Eigen::VectorXd heat;      ///< h_c a_s [W/K]
    Eigen::VectorXd relaxes;   ///< xi/m [1/s]
    Eigen::VectorXd cools;     ///< of convection and radiation, over m c [1/s]
  };
  /// @param v      velocities, 3 N [m/s]
  /// @param theta  temperatures, N; empty without heat [K]
  /// @return at these
  Rates step_rates(schemes::In v, schemes::In theta) const;

  /// @param i  particle @param v its velocity [m/s] @return Reynolds number of what flows past it [-]
  double reynolds(Eigen::Index i, const Eigen::Vector3d& v) const;

 private:
  Eigen::Vector3d past(Eigen::Index i, const Eigen::Vector3d& v) const;
  // Drag over the velocity of what is read of the fluid past a particle.
  double coefficient(Eigen::Index i, double u) const;
  double* given_to(Eigen::Index i) { return given_.data() + i * (axes_ + 1); }
  void count_roots(Eigen::Index i, double coming, double u, double dt);

  int axes_;
  std::optional<HeatExchange> heat_;
  Eigen::VectorXd b_, mass_, inverse_mass_, capacity_, amplified_;
  std::vector<double> given_;
  Eigen::VectorXd dissipated_;  // over the step, by drag
  RootsTaken roots_;
};

}  // namespace particulate::fluid
