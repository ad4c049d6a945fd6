#include <particulate/schemes/crossing.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace particulate::schemes {

namespace {

// A turn so soon touches nothing and is not doubted: one after another, each nearer to the start, would shorten a step
// to nothing. One that lies so soon after the end of a step is told there, from its slopes.
constexpr double near_start = 1e-4, beyond_end = 1e-3;
// Nor is one so near to the end, which is the scheme's own.
constexpr double near_end = 1e-6;
// Two roundings of 1, the length of a step.
constexpr double narrowest = 2.0 * std::numeric_limits<double>::epsilon();

// Not by a product, which can underflow.
bool opposite(double a, double b) { return (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0); }

class Scan {
 public:
  Scan(const Along& f, const ZeroRules& rules, int& side) : f_(f), rules_(rules), side_(side) {}

  // From one sample to the next, in two pieces if the function turns in between.
  std::optional<Crossing> over(const Sample& a, const Sample& b) {
    if (!turns(a, b)) return along(a, b, false);
    const double theta = bracketed_root(f_.slope, a.theta, a.slope, b.theta, b.slope);
    const Sample turn{.theta = theta, .value = f_.value(theta), .slope = 0.0};
    const std::optional<Crossing> before = along(a, turn, true);
    return before ? before : along(turn, b, false);
  }

  // What counts, or what must be seen before it does.
  std::optional<Crossing> before(const std::optional<Crossing>& found) const {
    return found && other_way_ ? other_way_ : found;
  }

  // At the last sample, where a function has come to zero, is short of it by no more than rounding, or about to turn.
  std::optional<Crossing> at_end(const Sample& last) const {
    if (side_ == 0 || !counts(passing())) return {};
    if (zero_) return Crossing{root(zero_->first, zero_->second, 0.0), passing(), side_};
    const double height = side_ * last.value;
    if (!opposite(side_, last.slope) || last.theta != 1.0) return {};
    if (height <= rules_.reach) return Crossing{1.0, passing(), side_};
    const bool touches = rules_.touches && height <= rules_.graze && opposite(last.slope, f_.slope(1.0 + beyond_end));
    return touches ? std::optional(Crossing{1.0, Direction::either, side_}) : std::nullopt;
  }

 private:
  // A turn is of interest where the function heads for zero first, or has yet to show on which side it leaves zero; and
  // not where it could not leave it.
  bool turns(const Sample& a, const Sample& b) const {
    if (side_ != 0) {
      return opposite(side_, a.slope) && (opposite(a.slope, b.slope) || (b.slope == 0.0 && b.value != 0.0));
    }
    if (!opposite(a.slope, b.slope)) return false;
    return std::max(std::abs(a.slope), std::abs(b.slope)) * (b.theta - a.theta) > rules_.leave;
  }

  // Over a piece without a turn inside.
  std::optional<Crossing> along(const Sample& a, const Sample& b, bool turns_at_end) {
    if (side_ == 0) return from_zero(a, b);
    const double height = side_ * b.value;
    if (turns_at_end && std::abs(height) <= rules_.graze) {
      return rules_.touches && b.theta >= near_start && counts(passing())
                 ? std::optional(Crossing{b.theta, Direction::either, side_})
                 : std::nullopt;
    }
    const bool in_doubt = turns_at_end && b.theta >= near_start && std::abs(1.0 - b.theta) > near_end &&
                          height <= 4.0 * rules_.doubt * b.theta * std::abs(1.0 - b.theta);
    if (in_doubt && height > 0.0) return Crossing{b.theta, Direction::either, side_};
    if (height == 0.0) {
      if (!zero_) zero_ = {a, b};
      return {};
    }
    const auto zero = std::exchange(zero_, std::nullopt);
    if (height > 0.0) return zero && rules_.touches && counts(passing()) ? touch(*zero) : std::nullopt;
    const Crossing passes{zero ? root(zero->first, zero->second, 0.0) : root(a, b, 0.0), passing(), side_};
    if (counts(passing())) return passes;
    side_ = -side_;
    other_way_ = passes;
    other_way_->counts = false;
    return {};
  }

  // Of a function that is zero at a sample and turns back: there, unless it is zero over a stretch.
  std::optional<Crossing> touch(const std::pair<Sample, Sample>& zero) const {
    const double first = root(zero.first, zero.second, 0.0), there = zero.second.theta;
    return Crossing{there - first > near_end ? first : there, Direction::either, side_};
  }

  // The same, of a function that has not left zero yet.
  std::optional<Crossing> from_zero(const Sample& a, const Sample& b) {
    const int from = std::signbit(rules_.floor) ? 1 : -1;
    if (from * b.value < from * rules_.floor) {
      side_ = from;
      if (counts(passing())) return Crossing{root(a, b, rules_.floor), passing(), from};
      side_ = -from;
    } else if (std::abs(b.value) > rules_.leave && (std::isinf(rules_.floor) || from * b.value > 0.0)) {
      side_ = b.value > 0.0 ? 1 : -1;
    }
    return {};
  }

  Direction passing() const { return side_ > 0 ? Direction::falling : Direction::rising; }
  bool counts(Direction way) const { return rules_.direction == Direction::either || rules_.direction == way; }

  double root(const Sample& a, const Sample& b, double level) const {
    // What starts at the level was a little on this side of it.
    const double before = a.value == level ? side_ * std::numeric_limits<double>::min() : a.value - level;
    return bracketed_root([&](double theta) { return f_.value(theta) - level; }, a.theta, before, b.theta,
                          b.value - level);
  }

  const Along& f_;
  const ZeroRules& rules_;
  int& side_;
  std::optional<Crossing> other_way_ = {};              // the last passage that did not count
  std::optional<std::pair<Sample, Sample>> zero_ = {};  // the samples before and at a zero that has yet to be told
};

}  // namespace

std::vector<double> chebyshev_points(int intervals, double end) {
  std::vector<double> points{0.0};
  for (int k = 1; k < intervals; ++k) points.push_back(0.5 * end * (1.0 - std::cos(std::numbers::pi * k / intervals)));
  points.push_back(end);
  return points;
}

double bracketed_root(const std::function<double(double)>& f, double a, double fa, double b, double fb) {
  const double pull = 0.2 / (b - a);
  const double halvings = std::max(0.0, std::ceil(std::log2((b - a) / narrowest)));
  for (double room = 0.5 * narrowest * std::exp2(halvings + 1.0); b - a > narrowest; room *= 0.5) {
    const double middle = 0.5 * (a + b);
    const double falsi = a + (b - a) * (fa / (fa - fb));
    const double towards = middle >= falsi ? 1.0 : -1.0;
    const double drawn = falsi + towards * std::min(pull * (b - a) * (b - a), std::abs(middle - falsi));
    const double within = std::max(0.0, room - 0.5 * (b - a));
    double x = std::abs(drawn - middle) <= within ? drawn : middle - towards * within;
    if (!(x > a && x < b)) x = middle;
    if (!(x > a && x < b)) break;
    double fx = f(x);
    if (fx == 0.0 && x - narrowest > a) {  // here alone, or over a stretch
      fx = f(x -= narrowest);
      if ((fx > 0.0) == (fa > 0.0) && fx != 0.0) return x + narrowest;
    }
    const bool beyond = !(fx != 0.0 && (fx > 0.0) == (fa > 0.0));
    (beyond ? b : a) = x;
    (beyond ? fb : fa) = fx;
  }
  return b;
}

std::optional<Crossing> first_crossing(const std::vector<Sample>& samples, const Along& f, const ZeroRules& rules,
                                       int& side) {
  Scan scan(f, rules, side);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const std::optional<Crossing> found = scan.over(samples[k - 1], samples[k]);
    if (found) return scan.before(found);
  }
  return scan.before(scan.at_end(samples.back()));
}

}  // namespace particulate::schemes
