#include <particulate/schemes/mixing.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/QR>

namespace particulate::schemes {

Anderson::Anderson(int depth) : depth_(depth) {
  if (depth < 1) {
    throw std::invalid_argument(
        fmt::format("Anderson: depth must be at least 1, got {}; Picard is the iteration without mixing", depth));
  }
}

void Anderson::next(Eigen::VectorXd& x, Eigen::VectorXd& gx) {
  const Eigen::VectorXd residual = gx - x;
  if (seen_ < 0) {
    residual_steps_.resize(x.size(), depth_);
    map_steps_.resize(x.size(), depth_);
  } else {
    residual_steps_.col(seen_ % depth_) = residual - residual_;
    map_steps_.col(seen_ % depth_) = gx - map_;
  }
  ++seen_;
  residual_ = residual;
  map_ = gx;
  x.swap(gx);
  if (seen_ == 0) return;
  const Eigen::Index used = std::min<Eigen::Index>(seen_, depth_);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(residual_steps_.leftCols(used));
  const Eigen::VectorXd gamma = decomposition.solve(residual);
  if (gamma.allFinite()) x -= map_steps_.leftCols(used) * gamma;
}

}  // namespace particulate::schemes
