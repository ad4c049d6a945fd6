#pragma once

#include <complex>

#include <Eigen/Core>

/// @file
/// What cases need of small matrices, compiled once. Complex equations are solved by elimination written out, apart
/// from the decompositions that the library uses.

namespace verification {

/// What a symmetric matrix multiplies, and by how much.
struct Modes {
  Eigen::VectorXd values;   ///< eigenvalues, ascending
  Eigen::MatrixXd vectors;  ///< orthonormal eigenvectors, one a column
};

/// @param A  symmetric; only the triangle below the diagonal is read
/// @return its eigenvalues and eigenvectors
Modes symmetric_modes(const Eigen::MatrixXd& A);

/// @param A  square
/// @return its determinant
std::complex<double> determinant(const Eigen::MatrixXcd& A);

/// @param A  square and regular
/// @param b  as many rows as A
/// @return x with \f$ A x = b \f$
Eigen::VectorXcd solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b);

}  // namespace verification
