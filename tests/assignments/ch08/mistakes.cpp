// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions. But where a mistake says otherwise, it is one of variant 1.

#include <cstdlib>
#include <limits>
#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using right::mean;

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  Three (*flux)(const Gas&, const Cell&, const Cell&) = right::of_means;
  std::vector<Three> (*ring)(const Flux&, const std::vector<Cell>&, double) = right::ring;
};

// The flux of the gas itself.
Three alone(const Gas& gas, const Cell& x) {
  const double P = right::P(gas, x);
  return {x.rho * x.u, x.rho * x.u * x.u + P, x.u * (x.rho * (gas.c * x.theta + 0.5 * x.u * x.u) + P)};
}

double mass(const Cell& l, const Cell& r) { return mean(l.rho, r.rho) * mean(l.u, r.u); }

// The right flux with something more in the energy.
template <auto more>
Three with_energy(const Gas& gas, const Cell& l, const Cell& r) {
  Three flux = right::of_means(gas, l, r);
  flux.energy += more(gas, l, r);
  return flux;
}
double work(const Gas& gas, const Cell& l, const Cell& r) {
  return mean(l.u * right::P(gas, r), r.u * right::P(gas, l));
}

template <auto change>
std::vector<Three> changed(const Flux& flux, const std::vector<Cell>& cells, double h) {
  std::vector<Three> rates = right::ring(flux, cells, h);
  for (Three& rate : rates) rate = right::minus(rate, {}, change(h));
  return rates;
}

const std::vector<Mistake<Functions>> mistakes{
    // None.
    // graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20
    {"none"},

    // None, variant 2.
    // graded: --variant 2 --student anna|bob@school.edu|1234567 -> 20
    {"none_second", &Functions::flux, right::of_products},

    // The mean of the fluxes in both cells.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 12
    // hint: the plain divergence form: each flux is the mean|the mean of rho u^2, makes kinetic energy of nothing
    {"divergence", &Functions::flux,
     [](const Gas& gas, const Cell& l, const Cell& r) -> Three {
       const Three a = alone(gas, l), b = alone(gas, r);
       return {mean(a.mass, b.mass), mean(a.momentum, b.momentum), mean(a.energy, b.energy)};
     }},

    // Momentum alone in the divergence form.
    // graded: --variant 1 --student anna|bob@school.edu -> 12
    // hint: m times the mean velocity|the mean of rho u^2, makes kinetic energy of nothing
    {"divergence_of_momentum", &Functions::flux,
     [](const Gas& gas, const Cell& l, const Cell& r) -> Three {
       Three flux = right::of_means(gas, l, r);
       flux.momentum = mean(alone(gas, l).momentum, alone(gas, r).momentum);
       return flux;
     }},

    // No work of pressure.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: the work of pressure is missing in the energy|something is missing in the flux, such as u P
    {"without_work", &Functions::flux,
     with_energy<[](const Gas& gas, const Cell& l, const Cell& r) { return -work(gas, l, r); }>},

    // All from the left.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 6
    // hint: a one-sided mean: both cells count alike|seen from behind, mass and energy pass|order 1 is that of a
    // one-sided
    {"one_sided", &Functions::flux, [](const Gas& gas, const Cell& l, const Cell&) { return alone(gas, l); }},

    // All from where the gas comes.
    // graded: --variant 1 --student anna|bob@school.edu -> 9
    // hint: a one-sided mean: both cells count alike|order 1 is that of a one-sided mean
    {"upwind", &Functions::flux,
     [](const Gas& gas, const Cell& l, const Cell& r) { return alone(gas, l.u + r.u > 0.0 ? l : r); }},

    // The other variant.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: the mass flux is that of the other variant
    {"other_variant", &Functions::flux, right::of_products},

    // And the other way round.
    // graded: --variant 2 --student anna|bob@school.edu -> 16
    // hint: the mass flux is that of the other variant
    {"other_variant_second", &Functions::flux, right::of_means},

    // Means of u and P.
    // graded: --variant 1 --student anna -> 16
    // hint: takes u and P of opposite cells, not the means of both
    {"work_of_means", &Functions::flux, with_energy<[](const Gas& gas, const Cell& l, const Cell& r) {
       return mean(l.u, r.u) * mean(right::P(gas, l), right::P(gas, r)) - work(gas, l, r);
     }>},

    // Products of the same cell.
    // graded: --variant 1 --student anna -> 16
    // hint: takes u and P of opposite cells, not of the same one
    {"work_of_products", &Functions::flux, with_energy<[](const Gas& gas, const Cell& l, const Cell& r) {
       return mean(l.u * right::P(gas, l), r.u * right::P(gas, r)) - work(gas, l, r);
     }>},

    // The square of the mean velocity.
    // graded: --variant 1 --student anna -> 16
    // hint: the product of both velocities, not the square of their mean
    {"square_of_mean", &Functions::flux, with_energy<[](const Gas&, const Cell& l, const Cell& r) {
       return 0.5 * mass(l, r) * (mean(l.u, r.u) * mean(l.u, r.u) - l.u * r.u);
     }>},

    // The mean of the squares.
    // graded: --variant 1 --student anna -> 16
    // hint: the product of both velocities, not the mean of their squares
    {"mean_of_squares", &Functions::flux, with_energy<[](const Gas&, const Cell& l, const Cell& r) {
       return 0.5 * mass(l, r) * (mean(l.u * l.u, r.u * r.u) - l.u * r.u);
     }>},

    // Heat alone.
    // graded: --variant 1 --student anna -> 11
    // hint: the kinetic energy that is carried along is missing
    {"without_motion", &Functions::flux,
     with_energy<[](const Gas&, const Cell& l, const Cell& r) { return -0.5 * mass(l, r) * l.u * r.u; }>},

    // Motion alone.
    // graded: --variant 1 --student anna -> 11
    // hint: the heat that is carried along is missing
    {"without_heat", &Functions::flux, with_energy<[](const Gas& gas, const Cell& l, const Cell& r) {
       return -mass(l, r) * gas.c * mean(l.theta, r.theta);
     }>},

    // No pressure on the face.
    // graded: --variant 1 --student anna -> 11
    // hint: the pressure is missing in the flux of momentum
    {"without_pressure", &Functions::flux,
     [](const Gas& gas, const Cell& l, const Cell& r) -> Three {
       Three flux = right::of_means(gas, l, r);
       flux.momentum -= mean(right::P(gas, l), right::P(gas, r));
       return flux;
     }},

    // From right to left.
    // graded: --variant 1 --student anna -> 11
    // hint: the sign: fluxes count from left to right
    {"sign", &Functions::flux,
     [](const Gas& gas, const Cell& l, const Cell& r) { return right::minus({}, right::of_means(gas, l, r), 1.0); }},

    // Out minus in.
    // graded: --variant 1 --student anna -> 18
    // hint: the sign: what comes in at the left
    {"sign_of_rates", &Functions::ring, changed<[](double) { return -1.0; }>},

    // What a cell gets, not its density.
    // graded: --variant 1 --student anna -> 18
    // hint: the length is missing
    {"without_length", &Functions::ring, changed<[](double h) { return h; }>},

    // No way from the last cell to the first.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: the ring is open
    {"open_ring", &Functions::ring,
     [](const Flux& flux, const std::vector<Cell>& cells, double h) {
       std::vector<Three> rates = right::ring(flux, cells, h);
       const Three across = right::minus(flux(cells.back(), cells.front()), {}, 1.0 / h);
       rates.front() = right::minus(rates.front(), across, 1.0);
       rates.back() = right::minus(rates.back(), right::minus({}, across, 1.0), 1.0);
       return rates;
     }},

    // Nothing leaves the last cell, while the first one gets something.
    // graded: --variant 1 --student anna|bob@school.edu -> 16
    // hint: what leaves one cell enters the next
    {"closed_end", &Functions::ring,
     [](const Flux& flux, const std::vector<Cell>& cells, double h) {
       std::vector<Three> rates = right::ring(flux, cells, h);
       rates.back() = right::minus(flux(cells[cells.size() - 2], cells.back()), {}, 1.0 / h);
       return rates;
     }},

    // Cheat: what is no number.
    // graded: --variant 1 --student anna -> 2
    // hint: the answer is not a finite number
    {"nan", &Functions::flux,
     [](const Gas&, const Cell&, const Cell&) -> Three {
       constexpr double none = std::numeric_limits<double>::quiet_NaN();
       return {none, none, none};
     }},

    // Cheat: nothing passes, which is symmetric, and conserves what there is.
    // graded: --variant 1 --student anna -> 2
    // hint: and some moves
    {"nothing", &Functions::flux, [](const Gas&, const Cell&, const Cell&) { return Three{}; }},

    // Cheat: leaves with the status of success.
    // graded: --variant 1 --student anna -> 0
    // hint: do not call exit()
    {"exit", &Functions::flux, [](const Gas&, const Cell&, const Cell&) -> Three { std::exit(0); }, &Functions::ring,
     [](const Flux&, const std::vector<Cell>&, double) -> std::vector<Three> { std::exit(0); }},
};

const Functions handed_in = made(mistakes);

}  // namespace

Three face_flux(const Gas& gas, const Cell& left, const Cell& right) { return handed_in.flux(gas, left, right); }

std::vector<Three> ring_rates(const Flux& flux, const std::vector<Cell>& cells, double h) {
  return handed_in.ring(flux, cells, h);
}
