// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions. But where a mistake says otherwise, it is one of variant 1.

#include <cstdlib>
#include <limits>
#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using right::between;
using right::by_twos;
using right::in_a_row;
using right::mate_where;

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  void (*mate)(MatrixXd&, Index, const Uniform&) = right::mate<by_twos>;
};

// A Phi for each parameter, kept for later children.
class Kept {
 public:
  double drawn(Index k, const Uniform& uniform) { return phi_.at(static_cast<std::size_t>(k)) = uniform(); }
  double last(Index k) const { return phi_.at(static_cast<std::size_t>(k)); }

 private:
  std::vector<double> phi_ = std::vector<double>(3);
};

const std::vector<Mistake<Functions>> mistakes{
    // None.
    // graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20
    {"none", &Functions::mate, right::mate<by_twos>},

    // None, variant 2.
    // graded: --variant 2 --student anna|bob@school.edu|1234567 -> 20
    {"none_second", &Functions::mate, right::mate<in_a_row>},

    // The pairs of variant 2.
    // graded: --variant 1 --student anna -> 12
    // hint: these are the pairs of the other variant
    // hint: what children of the other variant's pairs have in common
    {"other_variant", &Functions::mate, right::mate<in_a_row>},

    // The pairs of variant 1.
    // graded: --variant 2 --student anna -> 12
    // hint: these are the pairs of the other variant
    // hint: what children of the other variant's pairs have in common
    {"other_variant_second", &Functions::mate, right::mate<by_twos>},

    // The first in rank mates with the last.
    // graded: --variant 1|2 --student anna -> 12
    // hint: its parents are not neighbours in rank
    {"first_with_last", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       const auto pairs = [](Index child, Index of) { return std::pair(child, of - 1 - child); };
       mate_where(strings, K, pairs, [&](Index, Index, double a, double b) { return between(a, b, uniform()); });
     }},

    // One Phi for all parameters of a child.
    // graded: --variant 1 --student anna -> 16
    // hint: 7/15: Phi is shared by the parameters of a child
    {"phi_shared_by_parameters", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       double phi = 0.0;
       mate_where(strings, K, by_twos, [&](Index, Index k, double a, double b) {
         if (k == 0) phi = uniform();
         return between(a, b, phi);
       });
     }},

    // One Phi for both children of a pair.
    // graded: --variant 1 --student anna -> 16
    // hint: Phi is shared by children
    {"phi_shared_by_siblings", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       Kept phi;
       mate_where(strings, K, by_twos, [&](Index child, Index k, double a, double b) {
         return between(a, b, child % 2 == 0 ? phi.drawn(k, uniform) : phi.last(k));
       });
     }},

    // One Phi for all children.
    // graded: --variant 2 --student anna -> 16
    // hint: Phi is shared by children
    {"phi_shared_by_all", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       Kept phi;
       mate_where(strings, K, in_a_row, [&](Index child, Index k, double a, double b) {
         return between(a, b, child == 0 ? phi.drawn(k, uniform) : phi.last(k));
       });
     }},

    // One Phi for everything.
    // graded: --variant 1 --student anna -> 12
    // hint: shared by the parameters
    // hint: shared by children
    {"phi_shared", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       right::mate<by_twos>(strings, K, [phi = uniform()] { return phi; });
     }},

    // The second child takes what the first has left.
    // graded: --variant 1 --student anna -> 16
    // hint: takes 1 - Phi of the first
    {"complements", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       Kept phi;
       mate_where(strings, K, by_twos, [&](Index child, Index k, double a, double b) {
         return between(a, b, child % 2 == 0 ? phi.drawn(k, uniform) : 1.0 - phi.last(k));
       });
     }},

    // Phi lies in [-1/2, 3/2].
    // graded: --variant 2 --student anna -> 9
    // hint: Phi must lie in [0, 1]
    // hint: Phi lies outside [0, 1], in [-1/2, 3/2]
    {"phi_outside", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       mate_where(strings, K, in_a_row,
                  [&](Index, Index, double a, double b) { return a == b ? a : b + (2.0 * uniform() - 0.5) * (a - b); });
     }},

    // Phi lies in [-1, 1], as what many generators call uniform.
    // graded: --variant 1 --student anna -> 3
    // hint: Phi must lie in [0, 1]
    // hint: in an interval of length 2
    {"phi_signed", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       mate_where(strings, K, by_twos, [&](Index, Index, double a, double b) {
         const double phi = 2.0 * uniform() - 1.0;
         return phi * a + (1.0 - phi) * b;
       });
     }},

    // A Phi for each of the two terms.
    // graded: --variant 1 --student anna -> 14
    // hint: the two shares must be Phi and 1 - Phi
    // hint: the two shares must add up to 1
    {"two_phi", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       mate_where(strings, K, by_twos, [&](Index, Index, double a, double b) {
         const double share = uniform() * a;
         return share + uniform() * b;
       });
     }},

    // One term.
    // graded: --variant 1 --student anna -> 3
    // hint: one of the two terms
    {"one_term", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       mate_where(strings, K, by_twos, [&](Index, Index, double a, double) { return uniform() * a; });
     }},

    // The middle of the parents.
    // graded: --variant 2 --student anna -> 13
    // hint: Phi is always 1/2
    {"middle", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform&) {
       mate_where(strings, K, in_a_row, [&](Index, Index, double a, double b) { return between(a, b, 0.5); });
     }},

    // Each parameter of the one parent or of the other.
    // graded: --variant 1 --student anna -> 13
    // hint: of the one parent or of the other
    {"crossing", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       mate_where(strings, K, by_twos, [&](Index, Index, double a, double b) { return uniform() < 0.5 ? a : b; });
     }},

    // A rounding leads out of the box.
    // graded: --variant 1 --student anna -> 18
    // hint: off by a rounding
    {"rounded", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       mate_where(strings, K, by_twos, [&](Index, Index, double a, double b) {
         const double phi = uniform();
         return phi * a + (1.0 - phi) * b;
       });
     }},

    // The first child stands in the place of its first parent as well.
    // graded: --variant 1 --student anna -> 13
    // hint: a parent was changed in place
    // hint: the second child of a pair is made of the first
    {"in_place", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       for (Index child = 0; child < K; ++child) {
         const auto [i, j] = by_twos(child, K);
         auto a = strings.col(i), b = strings.col(j);
         for (Index k = 0; k < strings.rows(); ++k) a[k] = between(a[k], b[k], uniform());
         strings.col(K + child) = a;
       }
     }},

    // One child a pair.
    // graded: --variant 1 --student anna -> 0
    // hint: fewer children than asked for
    // hint: this child was not made
    {"one_child", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       MatrixXd all = strings;
       right::mate<by_twos>(all, K, uniform);
       for (Index pair = 0; 2 * pair < K; ++pair) strings.col(K + pair) = all.col(K + 2 * pair);
     }},

    // Children to the end of the strings.
    // graded: --variant 1 --student anna -> 17
    // hint: more children than asked for
    {"too_many", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       right::mate<by_twos>(strings, K, uniform);
       for (Index n = 2 * K; n < strings.cols(); ++n) strings.col(n) = strings.col(n - K);
     }},

    // Children behind all that there is.
    // graded: --variant 1 --student anna -> 0
    // hint: resize none
    {"appended", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform& uniform) {
       MatrixXd all = strings;
       right::mate<by_twos>(all, K, uniform);
       strings.conservativeResize(Eigen::NoChange, strings.cols() + K);
       strings.rightCols(K) = all.middleCols(K, K);
     }},

    // Cheat: children that are not numbers.
    // graded: --variant 1 --student anna -> 0
    // hint: a string that is not finite
    // hint: the answer is not a finite number
    {"nan", &Functions::mate,
     [](MatrixXd& strings, Index K, const Uniform&) {
       strings.middleCols(K, K).setConstant(std::numeric_limits<double>::quiet_NaN());
     }},

    // Cheat: leaves with the status of success.
    // graded: --variant 1 --student anna -> 0
    // hint: do not call exit()
    {"exit", &Functions::mate, [](MatrixXd&, Index, const Uniform&) { std::exit(0); }},

    // Accident: a string that there is not.
    // graded: --variant 1 --student anna -> 0
    // hint: an index or a pointer is wrong
    {"crash", &Functions::mate, [](MatrixXd&, Index, const Uniform&) { std::vector<double>().at(1) = 0.0; }},
};

const Functions handed_in = made(mistakes);

}  // namespace

void mate(MatrixXd& strings, Index K, const Uniform& uniform) { handed_in.mate(strings, K, uniform); }
