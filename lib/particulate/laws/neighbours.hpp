#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>

namespace particulate::laws {

/// Pairs that may be near each other, each once, by its smaller number: what a Neighbours has found, until it is asked
/// again.
struct Candidates {
  Eigen::Index N;               ///< bodies [-]
  const std::uint32_t* first;   ///< where the partners of each body begin, N + 1 numbers; null: all pairs
  const std::int32_t* partner;  ///< partners, rising for each body

  /// Visits those partners of a body whose numbers are larger, in ascending order.
  ///
  /// @param i      the body
  /// @param visit  is called with the number of each
  template <class F>
  void behind(Eigen::Index i, F&& visit) const {
    if (!first) {
      for (Eigen::Index j = i + 1; j < N; ++j) visit(j);
      return;
    }
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) visit(static_cast<Eigen::Index>(partner[k]));
  }
};

/// Pairs that somebody has chosen, each once, by its smaller number.
struct ChosenPairs {
  std::vector<std::int32_t> row;      ///< one of each pair, rising
  std::vector<std::int32_t> partner;  ///< the other, larger
};

/// Finds pairs of bodies that may be near each other, for all laws of a scene, and remembers them while it can.
///
/// A law asks with a size for every body: a pair is near where its distance is at most the sum of the two sizes. What
/// is searched is wider by a skin, and holds until some body has moved, relative to the mean of all, or grown by half
/// of it. Pairs are found anew for the largest of what was asked since the last time, so that one search serves all
/// laws. A law tests which candidates are within its reach before it uses them, in ascending order: so results do not
/// depend on how old the list is.
///
/// The skin adapts itself to how long lists last, up to about half the spacing of the bodies. Few bodies, and bodies of
/// which most are near each other, are all candidates without being searched. Memory: some 60 bytes a body and 4 a
/// pair; while it searches, 60 a body and 8 a pair more.
class Neighbours {
 public:
  static constexpr Eigen::Index few = 64;  ///< so many bodies are not searched [-]

  /// Candidates of all pairs that are near.
  ///
  /// @param domain    forms the separations
  /// @param position  r_i, N x 3 [m]
  /// @param size      of each body, >= 0, N [m]
  /// @return pairs of which none that is near is left out, until the next call
  Candidates candidates(const kinematics::Space& domain, const kinematics::VectorsIn& position,
                        const kinematics::ScalarsIn& size);

  /// @return how often pairs were searched [-]
  long searches() const { return searches_; }

 private:
  bool holds(const kinematics::Space& domain, const kinematics::VectorsIn& position,
             const kinematics::ScalarsIn& size) const;
  void adapt_skin(double mean_size);
  void search(const kinematics::Space& domain, const kinematics::VectorsIn& position);

  Eigen::Vector3d lengths_ = Eigen::Vector3d::Zero();
  kinematics::Vectors position_;  // of the last search [m]
  Eigen::VectorXd size_;          // then searched for [m]
  Eigen::VectorXd asked_;         // the largest since, or before the first search [m]
  double skin_ = 0.0;             // [m]
  long searches_ = 0, uses_ = 0;  // in all; of this list
  bool all_ = false;              // most pairs are near
  std::vector<std::uint32_t> first_;
  std::vector<std::int32_t> partner_;
};

}  // namespace particulate::laws
