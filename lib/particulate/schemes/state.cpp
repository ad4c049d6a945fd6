#include <particulate/schemes/state.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

// N, if these are three numbers a particle.
Eigen::Index particles_in(const Eigen::VectorXd& x, const char* name) {
  if (x.size() % 3 == 0) return x.size() / 3;
  throw std::invalid_argument(
      fmt::format("state: {} must hold three numbers a particle, all x, all y, all z, got {}", name, x.size()));
}

// Column by column: the numbers of one particle stand N apart.
template <class Vector>
auto one_of(Vector& x, Eigen::Index i, const char* name) {
  const Eigen::Index N = particles_in(x, name);
  if (i >= 0 && i < N) return x(Eigen::seqN(i, Eigen::fix<3>, N));
  throw std::invalid_argument(
      fmt::format("state: {} of a particle must be asked for with 0 <= i < {}, got i = {}", name, N, i));
}

}  // namespace

VectorsOf positions(const State& state) { return {state.r.data(), particles_in(state.r, "r"), 3}; }
MutableVectorsOf positions(State& state) { return {state.r.data(), particles_in(state.r, "r"), 3}; }
VectorsOf velocities(const State& state) { return {state.v.data(), particles_in(state.v, "v"), 3}; }
MutableVectorsOf velocities(State& state) { return {state.v.data(), particles_in(state.v, "v"), 3}; }

const Eigen::Vector3d position(const State& state, Eigen::Index i) { return one_of(state.r, i, "r"); }
const Eigen::Vector3d velocity(const State& state, Eigen::Index i) { return one_of(state.v, i, "v"); }
void set_position(State& state, Eigen::Index i, const Eigen::Vector3d& value) { one_of(state.r, i, "r") = value; }
void set_velocity(State& state, Eigen::Index i, const Eigen::Vector3d& value) { one_of(state.v, i, "v") = value; }

Eigen::VectorXd flat(const State& state) {
  Eigen::VectorXd x(state.r.size() + state.v.size() + state.y.size());
  const Eigen::Index n = state.r.size();
  x.head(n) = state.r;
  x.segment(n, state.v.size()) = state.v;
  x.tail(state.y.size()) = state.y;
  return x;
}

void unflatten(In x, State& state) {
  const Eigen::Index n = state.r.size();
  state.r = x.head(n);
  state.v = x.segment(n, n);
  state.y = x.tail(state.y.size());
}

// Zero times what is not finite is not zero.
bool is_finite(const State& state) {
  const double sum = (0.0 * state.r).sum() + (0.0 * state.v).sum() + (0.0 * state.y).sum();
  return std::isfinite(state.t) && sum == 0.0;
}

}  // namespace particulate::schemes
