#include <particulate/identification/identifiability.hpp>

#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace particulate::identification {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void require_noise(Eigen::Index data, const Eigen::VectorXd& noise) {
  if (noise.size() != data || !noise.allFinite() || !(noise.array() > 0.0).all()) {
    throw std::invalid_argument(fmt::format(
        "noise must be a standard deviation for each of the {} data, positive and finite, got {} numbers of which the "
        "least is {}",
        data, noise.size(), noise.size() == 0 ? 0.0 : noise.minCoeff()));
  }
}

Eigen::VectorXd steps_of(const Differences& by, const Eigen::VectorXd& at) {
  const Eigen::VectorXd size = by.size.size() == 0 ? at.cwiseAbs() : by.size;
  const bool fits = at.size() > 0 && size.size() == at.size() && (size.array() > 0.0).all() && size.allFinite();
  if (!fits || !(by.step > 0.0 && std::isfinite(by.step))) {
    throw std::invalid_argument(fmt::format(
        "differences must have a positive step and a positive size for each of {} parameters, got a step of {} and {} "
        "sizes, the least {}: give sizes where a parameter is 0",
        at.size(), by.step, size.size(), size.size() == 0 ? 0.0 : size.minCoeff()));
  }
  return by.step * size;
}

// What a model gives; nothing where it throws or is not finite.
Eigen::VectorXd value_of(const SampledModel& model, const Eigen::VectorXd& parameters) {
  try {
    Eigen::VectorXd values = model(parameters);
    return values.allFinite() ? values : Eigen::VectorXd();
  } catch (const std::exception&) { return {}; }
}

// A sum over directions of v v^T: of the seen ones each over s^2.
Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& directions, const Eigen::VectorXd& singular_values) {
  const Eigen::MatrixXd scaled = directions * singular_values.cwiseInverse().asDiagonal();
  return scaled * scaled.transpose();
}

// Adds what is not seen: covariances without bound, of which the share in unseen directions says the sign and, of two
// of them, the correlation.
void add_unseen(const Eigen::MatrixXd& unseen, Uncertainty& of) {
  constexpr double rounding = 1e-13;  // of entries of directions, which have length 1
  const Eigen::MatrixXd share = unseen * unseen.transpose();
  for (Eigen::Index i = 0; i < share.rows(); ++i) {
    for (Eigen::Index j = 0; j < share.cols(); ++j) {
      const bool both = share(i, i) > rounding && share(j, j) > rounding;
      if (!both && (share(i, i) > rounding || share(j, j) > rounding)) of.correlation(i, j) = 0.0;
      if (!both) continue;
      of.correlation(i, j) = share(i, j) / std::sqrt(share(i, i) * share(j, j));
      if (std::abs(share(i, j)) > rounding) of.covariance(i, j) = std::copysign(infinite, share(i, j));
    }
  }
}

// A vector with one entry more, or less.
Eigen::VectorXd with(const Eigen::VectorXd& others, Eigen::Index which, double value) {
  Eigen::VectorXd all(others.size() + 1);
  all << others.head(which), value, others.tail(others.size() - which);
  return all;
}
Eigen::VectorXd without(const Eigen::VectorXd& all, Eigen::Index which) {
  Eigen::VectorXd others(all.size() - 1);
  others << all.head(which), all.tail(others.size() - which);
  return others;
}

double sum_of_squares(const Residuals& residuals, const Eigen::VectorXd& parameters) {
  const Eigen::VectorXd values = value_of(residuals, parameters);
  return values.size() == 0 ? infinite : values.squaredNorm();
}

// The parameters with one of them held and the others fitted.
Eigen::VectorXd refitted(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start, Eigen::Index which,
                         double value, const Refit& refit) {
  if (start.size() == 1) return Eigen::VectorXd::Constant(1, value);
  Box others{.lower = without(box.lower, which), .upper = without(box.upper, which)};
  if (box.allows) others.allows = [&](const Eigen::VectorXd& p) { return box.allows(with(p, which, value)); };
  const Residuals held = [&](const Eigen::VectorXd& p) { return residuals(with(p, which, value)); };
  return with(refit(held, others, without(start, which)), which, value);
}

void validate_profile(const Box& box, const Eigen::VectorXd& best, Eigen::Index which, const Eigen::VectorXd& at,
                      double rise) {
  validate(box);
  if (best.size() != box.lower.size() || which < 0 || which >= best.size()) {
    throw std::invalid_argument(fmt::format("a profile must be of one of the box's {} parameters, got number {} of {}",
                                            box.lower.size(), which, best.size()));
  }
  bool rises = at.size() >= 2 && at[0] < best[which] && best[which] < at[at.size() - 1];
  for (Eigen::Index k = 1; k < at.size(); ++k) rises = rises && at[k - 1] < at[k];
  if (!rises || !(at[0] >= box.lower[which] && at[at.size() - 1] <= box.upper[which])) {
    throw std::invalid_argument(fmt::format(
        "values of a profile must rise within the bounds [{:g}, {:g}], from below the best, {:g}, to above it",
        box.lower[which], box.upper[which], best[which]));
  }
  if (!(rise > 0.0)) throw std::invalid_argument(fmt::format("rise of a profile must be positive, got {}", rise));
}

// Where the cost, followed from the best outwards, has risen by so much; infinite if it has not.
double crossing(const Profile& of, double best, double least, Eigen::Index first, Eigen::Index step, double rise) {
  double x = best, root = 0.0;
  for (Eigen::Index k = first; k >= 0 && k < of.at.size(); k += step) {
    const double next = std::sqrt(std::max(0.0, of.cost[k] - least)), wanted = std::sqrt(rise);
    if (next >= wanted) {
      // Where there is no value the interval ends at the last one that has one: no farther can be said.
      return std::isfinite(next) ? x + (of.at[k] - x) * (wanted - root) / (next - root) : x;
    }
    x = of.at[k], root = next;
  }
  return step > 0 ? infinite : -infinite;
}

}  // namespace

Sensitivities sensitivities(const SampledModel& model, const Eigen::VectorXd& at, const Differences& by) {
  const Eigen::VectorXd steps = steps_of(by, at);
  Sensitivities found;
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    Eigen::VectorXd side[2];
    for (const int k : {0, 1}) {
      Eigen::VectorXd moved = at;
      moved[j] += k == 0 ? -steps[j] : steps[j];
      side[k] = value_of(model, moved);
      ++found.evaluations;
      if (side[k].size() > 0) continue;
      ++found.failures;
      found.reason = fmt::format("parameter {} has no value at {:g}: move it by less", j, moved[j]);
    }
    if (found.failures > 0) continue;
    if (side[0].size() != side[1].size() || (j > 0 && side[0].size() != found.jacobian.rows())) {
      throw std::invalid_argument("a model must give as many numbers for all parameters");
    }
    if (j == 0) found.jacobian.resize(side[0].size(), at.size());
    found.jacobian.col(j) = (side[1] - side[0]) / (2.0 * steps[j]);
  }
  if (found.failures > 0) found.jacobian.resize(0, 0);
  return found;
}

Eigen::MatrixXd to_other_parameters(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& derivative) {
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(derivative);
  if (derivative.rows() != derivative.cols() || jacobian.cols() != derivative.rows() || !lu.isInvertible()) {
    throw std::invalid_argument(fmt::format(
        "other parameters must determine the {} of the Jacobian: their derivative must be square and invertible, got "
        "{} x {} of rank {}",
        jacobian.cols(), derivative.rows(), derivative.cols(), lu.rank()));
  }
  return jacobian * lu.inverse();
}

Uncertainty uncertainty(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& noise, double unseen) {
  require_noise(jacobian.rows(), noise);
  if (jacobian.size() == 0 || !jacobian.allFinite()) {
    throw std::invalid_argument(
        fmt::format("a Jacobian must have entries, all of them finite, got {} x {}", jacobian.rows(), jacobian.cols()));
  }
  if (!(unseen >= 0.0 && unseen < 1.0)) {
    throw std::invalid_argument(fmt::format("unseen must lie in [0, 1), got {}", unseen));
  }
  // All directions, also those that fewer data than parameters leave without a singular value.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(noise.cwiseInverse().asDiagonal() * jacobian, Eigen::ComputeFullV);
  const Eigen::Index parameters = jacobian.cols();
  Uncertainty found{.singular_values = Eigen::VectorXd::Zero(parameters), .directions = svd.matrixV()};
  found.singular_values.head(svd.singularValues().size()) = svd.singularValues();
  const double least = unseen * found.singular_values[0];
  while (found.rank < parameters && found.singular_values[found.rank] > least) ++found.rank;
  found.covariance = covariance_of(found.directions.leftCols(found.rank), found.singular_values.head(found.rank));
  found.correlation.setIdentity(parameters, parameters);
  const Eigen::VectorXd seen = found.covariance.diagonal().cwiseSqrt();
  for (Eigen::Index i = 0; i < parameters; ++i) {
    for (Eigen::Index j = 0; j < parameters; ++j) {
      if (i != j && seen[i] * seen[j] > 0.0) found.correlation(i, j) = found.covariance(i, j) / (seen[i] * seen[j]);
    }
  }
  add_unseen(found.directions.rightCols(parameters - found.rank), found);
  found.deviation = found.covariance.diagonal().cwiseSqrt();
  return found;
}

Residuals in_deviations(SampledModel model, Eigen::VectorXd data, Eigen::VectorXd noise) {
  require_noise(data.size(), noise);
  return [model = std::move(model), data = std::move(data),
          noise = std::move(noise)](const Eigen::VectorXd& parameters) -> Eigen::VectorXd {
    const Eigen::VectorXd values = model(parameters);
    if (values.size() == 0) return values;
    if (values.size() != data.size()) {
      throw std::invalid_argument(
          fmt::format("a model must give as many numbers as there are data, {}, got {}", data.size(), values.size()));
    }
    return (values - data).cwiseQuotient(noise);
  };
}

Profile profile(const Residuals& residuals, const Box& box, const Eigen::VectorXd& best, Eigen::Index which,
                const Eigen::VectorXd& at, const Refit& refit, double rise) {
  validate_profile(box, best, which, at, rise);
  Profile found{.at = at,
                .cost = Eigen::VectorXd::Constant(at.size(), infinite),
                .parameters = Eigen::MatrixXd(best.size(), at.size()),
                .lower = -infinite,
                .upper = infinite,
                .evaluations = 0};
  const Residuals counted = [&](const Eigen::VectorXd& p) { return ++found.evaluations, residuals(p); };
  const double at_best = sum_of_squares(counted, best);
  if (!std::isfinite(at_best)) throw std::invalid_argument("the best of a profile must have residuals, it has none");
  const Eigen::Index above = (at.array() <= best[which]).count();
  const auto follow = [&](Eigen::Index k, Eigen::Index step) {
    for (Eigen::VectorXd from = best; k >= 0 && k < at.size(); k += step) {
      found.parameters.col(k) = refitted(counted, box, from, which, at[k], refit);
      found.cost[k] = sum_of_squares(counted, found.parameters.col(k));
      if (std::isfinite(found.cost[k])) from = found.parameters.col(k);
    }
  };
  follow(above, 1);
  follow(above - 1, -1);
  const double least = std::min(at_best, found.cost.minCoeff());
  found.upper = crossing(found, best[which], least, above, 1, rise);
  found.lower = crossing(found, best[which], least, above - 1, -1, rise);
  return found;
}

}  // namespace particulate::identification
