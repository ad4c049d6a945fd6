#include "driver.hpp"

#include <cmath>
#include <numbers>

#include "flux.hpp"

namespace {

using Numbers = std::vector<double>;

void add(Numbers& to, const Three& x) { to.insert(to.end(), {x.mass, x.momentum, x.energy}); }

Cell cell(const Numbers& x, std::size_t first) { return {x[first], x[first + 1], x[first + 2]}; }

// Those that stand behind the first numbers.
std::vector<Cell> cells(const Numbers& x, std::size_t first) {
  std::vector<Cell> all;
  for (std::size_t k = first; k + 2 < x.size(); k += 3) all.push_back(cell(x, k));
  return all;
}

Flux flux_of(const Gas& gas) {
  return [gas](const Cell& left, const Cell& right) { return face_flux(gas, left, right); };
}

// Inputs: R c, then rho u theta of the cells left and right.
Numbers of_a_face(const Numbers& x) {
  Numbers all;
  add(all, face_flux({x[0], x[1]}, cell(x, 2), cell(x, 5)));
  return all;
}

// Inputs: R c, then rho u of each cell; the pressure is 1 everywhere. A cell of 1 m makes u d(rho u)/dt - u^2/2 drho/dt
// of kinetic energy.
Numbers of_convection(const Numbers& x) {
  std::vector<Cell> ring;
  for (std::size_t k = 2; k + 1 < x.size(); k += 2) ring.push_back({x[k], x[k + 1], 1.0 / (x[0] * x[k])});
  const std::size_t n = ring.size();
  double made = 0.0, moved = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Cell &left = ring[(i + n - 1) % n], &here = ring[i], &right = ring[(i + 1) % n];
    const Three in = face_flux({x[0], x[1]}, left, here), out = face_flux({x[0], x[1]}, here, right);
    made += here.u * (in.momentum - out.momentum) - 0.5 * here.u * here.u * (in.mass - out.mass);
    moved += 0.5 * std::abs(out.mass) * here.u * here.u;
  }
  return {made, moved};
}

// Inputs: n a R c. One period of a smooth gas.
Numbers of_a_wave(const Numbers& x) {
  const double n = x[0], a = x[1];
  const auto at = [&](double i) -> Cell {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / n;
    return {1.0 + a * std::sin(angle), 0.5 + a * std::cos(angle), 2.0 + a * std::sin(2.0 * angle)};
  };
  Numbers all;
  for (double i = 0.0; i < n; i += 1.0) {
    const Three in = face_flux({x[2], x[3]}, at(i - 1.0), at(i)), out = face_flux({x[2], x[3]}, at(i), at(i + 1.0));
    add(all, {n * (in.mass - out.mass), n * (in.momentum - out.momentum), n * (in.energy - out.energy)});
  }
  return all;
}

// Inputs: h, then rho u theta of each cell. The flux is none of a gas.
Numbers of_a_ring(const Numbers& x) {
  const Flux flux = [](const Cell& left, const Cell& right) -> Three {
    return {left.rho + 2.0 * right.u, left.u - 3.0 * right.theta, left.theta * right.rho};
  };
  Numbers all;
  for (const Three& rate : ring_rates(flux, cells(x, 1), x[0])) add(all, rate);
  return all;
}

// Inputs: h R c, then rho u theta of each cell. Of mass, momentum and energy how much is made, and how much moves.
Numbers of_conservation(const Numbers& x) {
  Numbers all(6, 0.0);
  for (const Three& rate : ring_rates(flux_of({x[1], x[2]}), cells(x, 3), x[0])) {
    all[0] += rate.mass, all[1] += rate.momentum, all[2] += rate.energy;
    all[3] += std::abs(rate.mass), all[4] += std::abs(rate.momentum), all[5] += std::abs(rate.energy);
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(argc, argv,
                        {{"face_flux", of_a_face},
                         {"convection", of_convection},
                         {"wave", of_a_wave},
                         {"ring_rates", of_a_ring},
                         {"conservation", of_conservation}});
}
