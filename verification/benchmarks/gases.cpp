// What a step or an impact costs in the scenes that lammps_gas.in and lammps_fluid.in describe: a stepped granular gas,
// the same gas from impact to impact, and a dense fluid that is cut off. benchmark_gases gas|fluid|events.

#include <chrono>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/core.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/hard_spheres.hpp>
#include <particulate/kinematics/starts.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

using namespace particulate;
using kinematics::Space;

namespace {

using kinematics::Lattice;

// Unit masses and diameters on a lattice of so many cells a side, with velocities of temperature T.
kinematics::Particles crystal(Lattice kind, Eigen::Index side, double edge, double T) {
  const Eigen::Index N = side * side * side * (kind == Lattice::simple_cubic ? 1 : 4);
  boost::random::mt19937_64 engine(1);
  boost::random::normal_distribution<double> normal(0.0, std::sqrt(T));
  kinematics::Particles all{.position = lattice(kind, N, edge),
                            .velocity = kinematics::Vectors::NullaryExpr(N, 3, [&] { return normal(engine); }),
                            .mass = Eigen::VectorXd::Ones(N),
                            .radius = Eigen::VectorXd::Constant(N, 0.5)};
  all.velocity.rowwise() -= all.velocity.colwise().mean().eval();
  return all;
}

Space box(double length) { return {.lengths = Eigen::Vector3d::Constant(length)}; }

// Runs to one time, and then measures to another.
template <class Run>
schemes::Outcome measured(Run&& run, double warm, double end, double& seconds) {
  const schemes::Outcome before = run(warm);
  const auto start = std::chrono::steady_clock::now();
  const schemes::Outcome out = run(end);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (out.status != schemes::Status::reached) fmt::print("{}{}\n", before.reason, out.reason);
  return out;
}

template <class S>
void step(const S& scene, double dt, long warm, long steps) {
  schemes::State state = start(scene);
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = dt};
  double seconds = 0.0;
  const schemes::Outcome out =
      measured([&](double t) { return integrate(scene, state, t, scheme, control); }, dt * static_cast<double>(warm),
               dt * static_cast<double>(warm + steps), seconds);
  const double particles = static_cast<double>(scene.particles().size());
  fmt::print("{:.4f} us a particle and step", seconds / static_cast<double>(out.steps) / particles * 1e6);
  if (out.impacts > 0) {
    fmt::print(", {:.2f} us an impact, deepest overlap {:.3f} of a diameter, in steps of {:g}",
               seconds / static_cast<double>(out.impacts) * 1e6, out.overlap, dt);
  }
  fmt::print("\n");
}

const double apart = std::cbrt(std::numbers::pi / 0.6);  // at a volume fraction of 0.1

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "gas") {
    const scenes::Scene gas(crystal(Lattice::simple_cubic, 22, apart, 1.0), box(22.0 * apart), contact::Contact<>{});
    step(gas, 0.000617, 2000, 5000);
    step(gas, 0.005, 250, 1000);
  } else if (what == "fluid") {
    const double spacing = std::cbrt(4.0 / 0.8442);
    const laws::NearField lennard_jones{.alpha1 = 24.0, .alpha2 = 48.0, .beta1 = 7.0, .beta2 = 13.0, .cutoff = 3.0};
    step(scenes::Scene(crystal(Lattice::face_centred_cubic, 14, spacing, 1.44), box(14.0 * spacing), lennard_jones),
         0.002, 100, 400);
  } else if (what == "events") {
    for (const Eigen::Index side : {22, 46}) {
      contact::HardSpheres gas(crystal(Lattice::simple_cubic, side, apart, 1.0),
                               box(static_cast<double>(side) * apart));
      schemes::State state = start(gas);
      double seconds = 0.0;
      const schemes::Outcome out =
          measured([&](double t) { return gas.advance(state, t); }, 5.0, side < 30 ? 25.0 : 10.0, seconds);
      fmt::print("{} spheres: {:.2f} us an impact\n", gas.particles().size(),
                 seconds / static_cast<double>(out.impacts) * 1e6);
    }
  } else {
    fmt::print(stderr, "usage: benchmark_gases gas|fluid|events\n");
    return 2;
  }
}
