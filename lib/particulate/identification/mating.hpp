#pragma once

#include <functional>

#include <Eigen/Core>

namespace particulate::identification {

/// A child of two strings.
///
/// \f[ \Lambda^c_k = \Phi_k \Lambda^a_k + (1 - \Phi_k) \Lambda^b_k, \qquad 0 \le \Phi_k \le 1 \f]
///
/// @equation{R 5.1} \f$ \Phi_k \f$ is drawn anew for every component and child, so a child lies anywhere in the box
/// that its parents span, and never outside, roundings included.
/// @param a, b     parents, of one size
/// @param uniform  draws a number in [0, 1), one a component
/// @return the child
Eigen::VectorXd mated(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const std::function<double()>& uniform);

}  // namespace particulate::identification
