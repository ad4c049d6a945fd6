#include "fits.hpp"

#include <cmath>
#include <stdexcept>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <ch04_simulations/clouds.hpp>
#include <particulate/identification/polishing.hpp>
#include <particulate/laws/near_field.hpp>

namespace verification {

using namespace particulate;
using namespace particulate::identification;

std::vector<double> moments(double T, int n) {
  std::vector<double> all;
  for (int k = 1; k <= n; ++k) all.push_back(T * k / n);
  return all;
}

std::vector<kinematics::Particles> book_clouds(Eigen::Index N, int starts, std::uint64_t first) {
  std::vector<kinematics::Particles> all;
  for (int k = 0; k < starts; ++k) all.push_back(book_cloud(N, first + static_cast<std::uint64_t>(k)));
  return all;
}

HistoryModel cloud_model(std::vector<kinematics::Particles> starts, std::vector<double> times, double beta1,
                         double beta2, double TOL) {
  return [starts = std::move(starts), times = std::move(times), beta1, beta2, TOL](const Eigen::VectorXd& p,
                                                                                   Eigen::Index start) {
    const laws::NearField law{.alpha1 = std::exp(p[0]),
                              .alpha2 = std::exp(p[1]),
                              .beta1 = p.size() > 2 ? p[2] : beta1,
                              .beta2 = p.size() > 2 ? p[3] : beta2};
    return relative_energy_history(scenes::Scene(starts[static_cast<std::size_t>(start)], kinematics::Space{}, law),
                                   times, {.TOL = TOL});
  };
}

HistoryCost own_cost(const HistoryModel& model, int starts, const std::vector<double>& times,
                     const Eigen::VectorXd& parameters) {
  Target target{.name = "relative [J/kg]", .times = times, .values = {}};
  target.values.resize(static_cast<Eigen::Index>(times.size()), starts);
  for (int start = 0; start < starts; ++start) {
    const Simulated simulated = model(parameters, start);
    if (!simulated.reason.empty()) throw std::runtime_error("a target has no value: " + simulated.reason);
    target.values.col(start) = simulated.histories.front().values;
  }
  return HistoryCost({target}, model);
}

SampledModel sampled(const HistoryCost& cost) {
  return [cost](const Eigen::VectorXd& parameters) { return cost.sampled(parameters); };
}

Eigen::VectorXd with_noise(const Eigen::VectorXd& values, double share, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::normal_distribution<double> normal;
  Eigen::VectorXd noisy = values;
  for (double& value : noisy) value *= 1.0 + share * normal(engine);
  return noisy;
}

Eigen::VectorXd fit(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start) {
  return polish(residuals, box, start).parameters;
}

}  // namespace verification
