#include <particulate/schemes/problem.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

bool Problem::ask_hook(Hook::Side side, const Where& at, const Answers& to) const {
  return hook_->rates(bare(), side, at, to);
}

double Problem::distance(const In& x, const In& y) const {
  return can_->distance ? can_->distance(self_, x, y) : (x - y).lpNorm<1>();
}

double Problem::distance(std::size_t k, const In& x, const In& y) const {
  return can_->field_distance ? can_->field_distance(self_, k, x, y) : (x - y).lpNorm<1>();
}

double Problem::size(std::size_t k, const State& at, const In& x) const {
  const double own = distance(k, x, Eigen::VectorXd::Zero(x.size()));
  return can_->field_size ? std::max(own, can_->field_size(self_, k, at)) : own;
}

std::vector<Range> Problem::ranges(Eigen::Index size) const {
  if (!can_->ranges) return {Range{.first = 0, .size = size}};
  std::vector<Range> all = can_->ranges(self_);
  Eigen::Index next = 0;
  for (const Range& range : all) {
    if (range.first != next || range.size < 1 || !(range.TOL > 0.0)) {
      throw std::invalid_argument(
          fmt::format("problem: ranges of y must follow one another, hold a value each and have a positive TOL; {} "
                      "begins at {} where {} is next, holds {} and has TOL = {}",
                      range.name, range.first, next, range.size, range.TOL));
    }
    next += range.size;
  }
  if (next != size) {
    throw std::invalid_argument(
        fmt::format("problem: its ranges must hold all {} values of the state, they hold {}", size, next));
  }
  return all;
}

}  // namespace particulate::schemes
