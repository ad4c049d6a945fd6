#include <particulate/schemes/crossing.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace particulate::schemes {

namespace {

// A turn so soon is not doubted: one after another, each nearer to the start, would shorten a step to nothing.
constexpr double near_start = 1e-4;
// Two roundings of 1, the length of a step.
constexpr double narrowest = 2.0 * std::numeric_limits<double>::epsilon();

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

 private:
  // A turn is of interest where the function heads for zero first, or has yet to show on which side it leaves zero; and
  // not where it could not leave it.
  bool turns(const Sample& a, const Sample& b) const {
    if (!(a.slope * b.slope < 0.0)) return false;
    if (side_ != 0) return side_ * a.slope < 0.0;
    return std::max(std::abs(a.slope), std::abs(b.slope)) * (b.theta - a.theta) > rules_.leave;
  }

  // Over a piece without a turn inside.
  std::optional<Crossing> along(const Sample& a, const Sample& b, bool turns_at_end) {
    if (side_ == 0) {
      if (b.value < rules_.floor) return Crossing{root(a, b, rules_.floor), Direction::falling};
      if (std::abs(b.value) > rules_.leave) side_ = b.value > 0.0 ? 1 : -1;
      return {};
    }
    const double height = side_ * b.value;
    const Direction way = side_ > 0 ? Direction::falling : Direction::rising;
    if (turns_at_end && std::abs(height) <= rules_.graze) {
      return rules_.touches && counts(way) ? std::optional(Crossing{b.theta, Direction::either}) : std::nullopt;
    }
    const bool in_doubt =
        turns_at_end && b.theta >= near_start && height <= 4.0 * rules_.doubt * b.theta * std::abs(1.0 - b.theta);
    if (in_doubt && height > 0.0) return Crossing{b.theta, Direction::either};
    if (!(height <= rules_.reach)) return {};
    if (counts(way)) return Crossing{height < 0.0 ? root(a, b, 0.0) : b.theta, way};
    if (height < -rules_.leave) side_ = -side_;
    return {};
  }

  bool counts(Direction way) const { return rules_.direction == Direction::either || rules_.direction == way; }

  double root(const Sample& a, const Sample& b, double level) const {
    if ((a.value - level) * (b.value - level) >= 0.0) return b.theta;
    return bracketed_root([&](double theta) { return f_.value(theta) - level; }, a.theta, a.value - level, b.theta,
                          b.value - level);
  }

  const Along& f_;
  const ZeroRules& rules_;
  int& side_;
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
    const double falsi = (fb * a - fa * b) / (fb - fa);
    const double towards = middle >= falsi ? 1.0 : -1.0;
    const double drawn = falsi + towards * std::min(pull * (b - a) * (b - a), std::abs(middle - falsi));
    const double within = std::max(0.0, room - 0.5 * (b - a));
    double x = std::abs(drawn - middle) <= within ? drawn : middle - towards * within;
    if (!(x > a && x < b)) x = middle;
    if (!(x > a && x < b)) break;
    const double fx = f(x);
    if (fx == 0.0) return x;
    const bool beyond = (fx > 0.0) == (fa < 0.0);
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
    if (found) return found;
  }
  return {};
}

}  // namespace particulate::schemes
