#pragma once

#include <vector>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>

namespace particulate::thermo {

/// What hangs together: the connected components of the graph whose links are pairs at most a link length apart.
struct Clusters {
  std::vector<Eigen::Index> of;     ///< the cluster of each body; clusters are numbered by their first body
  std::vector<Eigen::Index> sizes;  ///< bodies in each, 1 for one alone
  long links = 0;                   ///< pairs that are linked

  /// @return bodies in the largest cluster; 0 where there are none
  Eigen::Index largest() const;
  /// @return share of all bodies that are linked to another, 0 to 1; 0 where there are none [-]
  double linked_share() const;
};

/// Finds the clusters of bodies.
///
/// @equation{R 7.2} Pairs by a neighbour search, components by union-find: a cost that grows with N.
/// @param domain    forms the separations
/// @param position  r_i, N x 3, finite [m]
/// @param link      link length, >= 0 and finite [m]
/// @return which bodies hang together
/// @throws std::invalid_argument for a length that cannot be meant, and for a position that is not finite
Clusters find_clusters(const kinematics::Space& domain, const kinematics::VectorsIn& position, double link);

}  // namespace particulate::thermo
