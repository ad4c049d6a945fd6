#pragma once

#include <Eigen/SparseCore>

#include <particulate/schemes/stage_solver.hpp>

namespace particulate::schemes {

/// Sparse matrices, whose columns are ordered to fill in little; banded matrices too.
using SparseStages = LinearStages<Eigen::SparseMatrix<double>>;
extern template class LinearStages<Eigen::SparseMatrix<double>>;

}  // namespace particulate::schemes
