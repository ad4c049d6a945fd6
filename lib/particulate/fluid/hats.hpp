#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <particulate/fluid/boundary.hpp>
#include <particulate/schemes/state.hpp>

/// @file
/// How much each cell of a grid counts for each particle.

namespace particulate::fluid {

/// Columns of numbers of cells: where the first cell's first number stands, and how far it is to the next cell in each
/// direction and to the next column.
struct Columns {
  const double* first = nullptr;            ///< of the cell with the least numbers
  std::array<Eigen::Index, 3> stride = {};  ///< to the next cell in each direction; 1 along x
  std::array<Eigen::Index, 6> offset = {};  ///< where each column begins, from `first`
  int count = 0;                            ///< how many there are, up to 6
};

namespace detail {

// The cells of one place along one direction, and their weights.
struct Run {
  const int* cell;
  const double* weight;
  int count;
};

}  // namespace detail

/// Hats around places, for reading values of cells there and for spreading what acts there over cells.
///
/// \f[ w_q = \frac{\prod_a h_{qa}}{\sum_q \prod_a h_{qa}}, \qquad
///     h_{qa} = \max\Big(0,\ 1 - \frac{|x_a - x_{qa}|}{w}\Big) \f]
///
/// @equation{D 8.1.2} Of half-width w; w = h is the trilinear interpolation that the monograph names. The same weights
/// read and spread, so that a force has the same power on both sides. Their sum is one, next to the faces of a box that
/// does not begin again too, where they are those of the cells inside. Each place has its nearest image.
/// @tparam Dim  1, 2 or 3
template <int Dim>
class Hats {
 public:
  /// @param grid        cells
  /// @param boundaries  which directions begin again
  /// @param half_width  w of each place, from the largest edge of a cell to half the shortest edge of the box [m]
  /// @param threads     that share the work, 1 to 1024; the same bits for any number
  /// @throws std::invalid_argument naming the place, what must hold, what was given and what to do
  Hats(const Grid<Dim>& grid, const Boundaries<Dim>& boundaries, Eigen::VectorXd half_width, int threads = 1);

  /// Finds the weights around places.
  ///
  /// @param r  as many places as half-widths, column by column: all x, then all y, then all z [m]
  /// @return whether contains() all of them
  /// @throws std::invalid_argument if they are more or fewer
  bool place(schemes::In r);
  /// @param x  a place [m]
  /// @return whether it is in the box, or where that begins again less than 4e15 cells away
  bool contains(const Eigen::Vector3d& x) const;

  /// Reads columns at the places: \f$ \sum_q w_q f_q \f$.
  ///
  /// @param from  what cells have
  /// @param out   receives, place after place, one number for each column
  void gather(const Columns& from, double* out) const;
  /// Spreads numbers over cells: each gets \f$ w_q \f$ of them.
  ///
  /// @param from   numbers, place after place
  /// @param apart  from one place to the next [numbers]
  /// @param count  how many of them are spread
  /// @param scale  what they are multiplied by
  /// @param to     columns one after the other, x fastest, to which they are added
  void spread(const double* from, Eigen::Index apart, int count, double scale, double* to) const;

  /// Columns without ghosts, as spread() writes them.
  ///
  /// @param first  of the first
  /// @param count  how many, 0 to 6
  /// @return what gather() reads
  Columns columns(const double* first, int count) const;

  /// @return number of places
  Eigen::Index size() const { return half_width_.size(); }
  /// @return of each place [m]
  const Eigen::VectorXd& half_width() const { return half_width_; }

 private:
  detail::Run run(Eigen::Index i, int axis) const {
    const std::size_t at = static_cast<std::size_t>(i) * Dim + static_cast<std::size_t>(axis);
    return {cell_.data() + at * room_, weight_.data() + at * room_, count_[at]};
  }
  void place_along(Eigen::Index i, int axis, double x);

  Grid<Dim> grid_;
  std::array<bool, Dim> periodic_{};
  Eigen::VectorXd half_width_;
  int threads_;
  std::size_t room_ = 1;  // for the cells of a run
  std::vector<int> cell_, count_;
  std::vector<double> weight_;
};

}  // namespace particulate::fluid
