// A cloud of 5000 by multirate collocation and by SUNDIALS: error against processor time, some two minutes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <ch04_simulations/clouds.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/multirate.hpp>

using namespace particulate;

namespace {

using Cloud = scenes::Scene<kinematics::Space, laws::NearField>;
constexpr double t_end = 0.25, wanted = 1e-6;

double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// One way to the end, and what came out of it.
struct Way {
  std::string name;
  std::function<void(const Cloud&, schemes::State&)> go;
  double error = 0.0, seconds = std::numeric_limits<double>::infinity();

  void try_it(const Cloud& cloud, const Eigen::VectorXd& truth) {
    schemes::State state = scenes::start(cloud);
    const double before = processor_time();
    go(cloud, state);
    seconds = std::min(seconds, processor_time() - before);
    error = (state.r - truth).cwiseAbs().maxCoeff();
  }
};

Way by(const std::string& name, const reference::Method& method) {
  return {.name = name, .go = [=](const Cloud& cloud, schemes::State& state) {
            (void)reference::integrate(cloud, state, t_end, method);
          }};
}

template <class Control>
Way by_multirate(const std::string& name, const Control& control) {
  return {.name = name, .go = [=](const Cloud& cloud, schemes::State& state) {
            (void)schemes::integrate(cloud, state, t_end,
                                     schemes::Multirate<6>({.TOL = 1e-6, .size = 1.0, .speed = 1.0}), Control(control));
          }};
}

}  // namespace

int main() {
  const Cloud cloud(verification::book_cloud(5000, 1), {}, laws::NearField{.alpha1 = 0.5, .alpha2 = 0.25});
  schemes::State truth = scenes::start(cloud);
  (void)reference::integrate(
      cloud, truth, t_end,
      reference::ExplicitRungeKutta{.table = reference::Table::fehlberg_13_7_8, .relative = 1e-11, .absolute = 1e-11});
  std::vector<Way> ways{
      by_multirate("multirate, 0.02 s, 2 sweeps", schemes::FixedSweeps{.step = 0.02, .sweeps = 2}),
      by_multirate("multirate, TOL 1e-5", schemes::ErrorControl{.TOL = 1e-5, .sweep_TOL = 1e-5, .limit = t_end})};
  for (const double TOL : {1e-7, 3e-8, 1e-8, 3e-9, 1e-9}) {
    ways.push_back(by(fmt::format("CVODE Adams, {:.0e}", TOL), reference::Adams{.relative = TOL, .absolute = TOL}));
    for (const reference::Table table :
         {reference::Table::fehlberg_13_7_8, reference::Table::verner_8_5_6, reference::Table::dormand_prince_7_4_5}) {
      ways.push_back(by(fmt::format("ARKODE {}, {:.0e}", name(table), TOL),
                        reference::ExplicitRungeKutta{.table = table, .relative = TOL, .absolute = TOL}));
    }
  }
  fmt::print("{:<40}{:>12}{:>12}\n", "5000 particles for 0.25 s", "error [m]", "seconds");
  double best = std::numeric_limits<double>::infinity(), ours = best;
  for (int repeat = 0; repeat < 2; ++repeat) {
    for (Way& way : ways) way.try_it(cloud, truth.r);
  }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    fmt::print("{:<40}{:>12.1e}{:>12.2f}\n", ways[k].name, ways[k].error, ways[k].seconds);
    if (ways[k].error <= wanted) (k < 2 ? ours : best) = std::min(k < 2 ? ours : best, ways[k].seconds);
  }
  fmt::print("To {:.0e} m the best of SUNDIALS takes {:.1f} times as long.\n", wanted, best / ours);
}
