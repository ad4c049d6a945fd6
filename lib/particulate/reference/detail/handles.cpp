#include <particulate/reference/detail/handles.hpp>

#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace particulate::reference::detail {

LinearSolver linear_solver(const DenseJacobian&, N_Vector y, SUNContext context) {
  const sunindextype n = N_VGetLength(y);
  LinearSolver is;
  is.matrix.reset(made(SUNDenseMatrix(n, n, context), "SUNDenseMatrix"));
  is.solver.reset(made(SUNLinSol_Dense(y, is.matrix.get(), context), "SUNLinSol_Dense"));
  return is;
}

LinearSolver linear_solver(const BandedJacobian& band, N_Vector y, SUNContext context) {
  LinearSolver is;
  is.matrix.reset(made(SUNBandMatrix(N_VGetLength(y), band.upper, band.lower, context), "SUNBandMatrix"));
  is.solver.reset(made(SUNLinSol_Band(y, is.matrix.get(), context), "SUNLinSol_Band"));
  return is;
}

}  // namespace particulate::reference::detail
