#include <particulate/fluid/flow.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>

#include "close.hpp"

namespace tests::flow_test {

using namespace particulate::fluid;
using Eigen::VectorXd;
using particulate::schemes::State;

template <int Dim>
Boundaries<Dim> periodic() {
  return {};
}

// A gas with gamma = 1 + 1/2, and a viscosity of which the longitudinal stress is one slope: mu (2 - 2/3) = 1.
const Fluid<particulate::continuum::IdealGas> gas{.state = {.R = 1.0}, .viscosity = {.mu = 0.75}, .c = 2.0, .K = 0.5};
const Fluid<particulate::continuum::Barotropic> barotropic{.state = {.P_R = 1.0, .Y = 4.0, .rho_R = 1.0},
                                                           .viscosity = {.mu = 0.75}};

// Anything, smooth and without symmetries.
template <int Dim>
Local<Dim> anything(const Vector<Dim>& x) {
  const double s = x.dot(Vector<Dim>::LinSpaced(Dim, 1.3, 2.9));
  Local<Dim> here{.rho = 1.0 + 0.2 * std::sin(s), .theta = 1.5 + 0.3 * std::cos(2.0 * s + 0.4)};
  for (int a = 0; a < Dim; ++a) here.v[a] = 0.3 * std::sin(1.7 * s + a) - 0.1 * a;
  return here;
}

template <class F>
VectorXd rate_of(const F& flow, const State& at) {
  VectorXd dy = VectorXd::Constant(at.y.size(), not_a_number);
  BOOST_TEST_REQUIRE(flow.rate(at.t, at.y, dy));
  return dy;
}

const Grid<1> line{.cells = {4}, .lengths = Vector<1>(4.0)};
const GasFlow<1> ring(line, gas, periodic<1>());
const Grid<2> square{.cells = {5, 7}, .lengths = {1.0, 3.0}};
const Grid<3> brick{.cells = {5, 4, 6}, .lengths = {2.5, 1.6, 3.6}, .corner = {-1.0, 0.5, 2.0}};

BOOST_AUTO_TEST_SUITE(flow)

BOOST_AUTO_TEST_CASE(refuses_a_fluid_that_cannot_be_meant) {
  const auto refuses = [](auto fluid, const char* words) { CHECK_REFUSED(GasFlow<1>(line, fluid, {}), words); };
  const auto with = [](auto member, double value) {
    Fluid<particulate::continuum::IdealGas> fluid = gas;
    fluid.*member = value;
    return fluid;
  };
  using F = Fluid<particulate::continuum::IdealGas>;
  refuses(with(&F::lambda_over_mu, -0.7), "lambda_over_mu must be finite and at least -2/3");
  refuses(with(&F::lambda_over_mu, infinity), "lambda_over_mu must be finite and at least -2/3");
  refuses(with(&F::c, 0.0), "fluid: c must be positive and finite, got 0");
  refuses(with(&F::c, not_a_number), "c must be positive and finite, got nan");
  refuses(with(&F::K, -1.0), "K must be finite and not negative, got -1");
  refuses(with(&F::K, infinity), "K must be finite and not negative, got inf");
  refuses(F{.state = {.R = 0.0}}, "ideal gas: R must be positive");
  refuses(F{.viscosity = {.mu = -1.0}}, "mu");
}

BOOST_AUTO_TEST_CASE(refuses_a_grid_boundaries_and_threads_that_cannot_be_meant) {
  CHECK_REFUSED(GasFlow<1>({.cells = {3}}, gas, {}), "at least 4 cells");
  CHECK_REFUSED(GasFlow<1>(line, gas, {Wall<1>{}, Periodic{}}), "boundary x low: it must be periodic if");
  CHECK_REFUSED(BarotropicFlow<1>(line, barotropic, {Wall<1>{.theta = 1.0}, Wall<1>{}}),
                "a barotropic fluid has no temperature");
  CHECK_REFUSED(GasFlow<1>(line, gas, {}, 0), "threads must be from 1 to 1024, got 0");
  CHECK_REFUSED(GasFlow<1>(line, gas, {}, 1025), "threads must be from 1 to 1024, got 1025");
  CHECK_REFUSED(GasFlow<1>(line, gas, {}, 1, static_cast<particulate::laws::Kernel>(17)),
                "this build has no kernel none for this processor: take best");
}

BOOST_AUTO_TEST_CASE(has_no_use_for_the_heat_capacity_of_a_barotropic_fluid) {
  Fluid<particulate::continuum::Barotropic> cold = barotropic;
  cold.c = cold.K = not_a_number;
  BOOST_CHECK_NO_THROW(BarotropicFlow<1>(line, cold, {}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(start)

BOOST_AUTO_TEST_CASE(holds_density_momentum_and_energy_field_by_field) {
  const GasFlow<2> flow({.cells = {4, 5}, .lengths = {1.0, 1.0}}, gas, periodic<2>());
  const State state = flow.start([](const Vector<2>& x) {
    return Local<2>{.rho = 2.0 + x[0], .v = {x[1], -3.0}, .theta = 5.0};
  });
  // Of cell (1, 2), whose middle is (0.375, 0.5): E = 2.375 (2 * 5 + (0.25 + 9)/2).
  BOOST_TEST(state.t == 0.0);
  BOOST_TEST_REQUIRE(state.y.size() == 80);
  BOOST_TEST(state.y[9] == 2.375);
  BOOST_TEST(state.y[29] == 2.375 * 0.5);
  BOOST_TEST(state.y[49] == 2.375 * -3.0);
  BOOST_TEST(state.y[69] == 2.375 * 14.625, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(comes_back_from_local) {
  const GasFlow<3> flow(brick, gas, periodic<3>());
  const State state = flow.start(anything<3>);
  const Local<3> here = flow.local(state, brick.index({3, 2, 4})), expected = anything<3>(brick.centre({3, 2, 4}));
  BOOST_TEST(here.rho == expected.rho);
  BOOST_TEST(close(here.v, expected.v, {.relative = 1e-15}));
  BOOST_TEST(here.theta == expected.theta, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(has_no_energy_in_a_barotropic_fluid) {
  const BarotropicFlow<3> flow(brick, barotropic, periodic<3>());
  BOOST_TEST(flow.start(anything<3>).y.size() == 4 * 120);
}

BOOST_AUTO_TEST_CASE(refuses_what_no_fluid_is) {
  const auto refuses = [](Local<1> here, const char* words) {
    CHECK_REFUSED(ring.start([&](const Vector<1>& x) { return x[0] > 2.0 ? here : Local<1>{}; }), words);
  };
  refuses({.rho = 0.0},
          "a start must have a positive density and temperature everywhere, and be finite; cell 2 has 0 kg/m^3, 300 K "
          "and 0 m/s");
  refuses({.rho = -1.0}, "cell 2 has -1 kg/m^3");
  refuses({.theta = 0.0}, ", 0 K and");
  refuses({.theta = -5.0}, ", -5 K and");
  refuses({.rho = not_a_number}, "cell 2 has nan kg/m^3");
  refuses({.rho = infinity}, "cell 2 has inf kg/m^3");
  refuses({.v = Vector<1>(infinity)}, "inf m/s");
  CHECK_REFUSED(BarotropicFlow<1>(line, barotropic, {}).start([](const Vector<1>&) { return Local<1>{.rho = -1.0}; }),
                "cell 0 has -1 kg/m^3 and 0 m/s");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(fields)

BOOST_AUTO_TEST_CASE(are_density_momentum_and_energy_one_after_the_other) {
  const GasFlow<3> flow(brick, gas, periodic<3>());
  const auto ranges = flow.ranges();
  BOOST_TEST(flow.fields() == 3);
  BOOST_TEST_REQUIRE(ranges.size() == 3);
  const char* const names[]{"density", "momentum", "energy"};
  const Eigen::Index first[]{0, 120, 480}, size[]{120, 360, 120};
  for (std::size_t k = 0; k < 3; ++k) {
    BOOST_TEST(ranges[k].name == names[k]);
    BOOST_TEST(ranges[k].first == first[k]);
    BOOST_TEST(ranges[k].size == size[k]);
    BOOST_TEST(flow.part(k).first == first[k]);
    BOOST_TEST(flow.part(k).size == size[k]);
    BOOST_TEST(!flow.part(k).motion);
  }
}

BOOST_AUTO_TEST_CASE(of_a_barotropic_fluid_are_two) {
  const BarotropicFlow<2> flow({.cells = {4, 4}}, barotropic, periodic<2>());
  BOOST_TEST(flow.fields() == 2);
  BOOST_TEST(flow.ranges().size() == 2);
  BOOST_TEST(flow.part(1).size == 32);
}

// Momentum is measured by sound: gamma R theta = 1.5 * 6, so 3 m/s in each of 16 cells of 2 kg/m^3.
BOOST_AUTO_TEST_CASE(have_sizes_that_do_not_vanish_in_a_fluid_at_rest) {
  const GasFlow<2> flow({.cells = {4, 4}}, gas, periodic<2>());
  const State still = flow.start([](const Vector<2>&) { return Local<2>{.rho = 2.0, .theta = 6.0}; });
  BOOST_TEST(flow.field_size(0, still) == 32.0, tolerance(1e-14));
  BOOST_TEST(flow.field_size(1, still) == 96.0, tolerance(1e-14));
  BOOST_TEST(flow.field_size(2, still) == 16.0 * 24.0, tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(rate)

// Cells of 1 m with rho = 1 2 1 2, u = 0 1 2 1, theta = P/rho = 1 2 3 2, so P = 1 4 3 4. At the faces behind each
// m = 0.75 2.25 2.25 0.75, and slopes, which are stresses, 1 1 -1 -1. So m u_bar + P_bar - tau
// = 1.875 5.875 7.875 3.875; m (2 theta_bar + u_0 u_1/2) + (u_0 P_1 + u_1 P_0)/2 - tau u_bar - (theta_1 - theta_0)/2 =
//   0.75 * 3 + 0.5 - 0.5 - 0.5 = 1.75,   2.25 * 6 + 5.5 - 1.5 - 0.5 = 17,
//   2.25 * 6 + 5.5 + 1.5 + 0.5 = 21,     0.75 * 3 + 0.5 + 0.5 + 0.5 = 3.75.
BOOST_AUTO_TEST_CASE(of_four_cells_is_what_the_fluxes_by_hand_leave) {
  State state{.y = VectorXd(12)};
  state.y << 1.0, 2.0, 1.0, 2.0, 0.0, 2.0, 2.0, 2.0, 2.0, 9.0, 8.0, 9.0;
  VectorXd expected(12);
  expected << 0.0, -1.5, 0.0, 1.5, 2.0, -4.0, -2.0, 4.0, 2.0, -15.25, -4.0, 17.25;
  BOOST_TEST(close(rate_of(ring, state), expected, {.relative = 1e-14, .absolute = 1e-14}));
}

template <class F>
void is_exactly_zero(const F& flow, const Vector<2>& v) {
  const State state = flow.start([&](const Vector<2>&) { return Local<2>{.rho = 2.0, .v = v, .theta = 0.75}; });
  BOOST_TEST(rate_of(flow, state).cwiseAbs().maxCoeff() == 0.0);
}

// Numbers that binary fractions hold, so that temperature and pressure are exact: P = 2 * 0.75 of the gas, 1 + 4 of the
// barotropic fluid.
BOOST_AUTO_TEST_CASE(of_a_uniform_fluid_is_exactly_zero_wherever_it_may_drift) {
  const Vector<2> any(0.5, -1.75), along(0.5, 0.0);
  const Given<2> same{[&](double, const Vector<2>&) { return Local<2>{.rho = 2.0, .v = any, .theta = 0.75}; }};
  const auto between = [&](const Boundary<2>& low, const Boundary<2>& high, const Vector<2>& v) {
    is_exactly_zero(GasFlow<2>(square, gas, {Periodic{}, Periodic{}, low, high}), v);
  };
  between(Periodic{}, Periodic{}, any);
  between(Wall<2>{.slips = true}, Wall<2>{.slips = true, .theta = 0.75}, along);
  between(Wall<2>{.velocity = along}, Wall<2>{.velocity = along, .theta = 0.75}, along);
  between(same, Outflow{.P = 1.5}, any);
  between(Outflow{.P = 1.5}, same, any);
  is_exactly_zero(BarotropicFlow<2>(square, barotropic, {same, Outflow{.P = 5.0}, same, same}), any);
}

BOOST_AUTO_TEST_CASE(has_no_value_without_density_temperature_or_number) {
  const GasFlow<1> flow(line, gas, periodic<1>());
  const State good = flow.start(anything<1>);
  VectorXd dy(12);
  for (const auto& [number, wrong] : {std::pair{2, 0.0},
                                      {2, -1.0},
                                      {2, infinity},
                                      {2, not_a_number},
                                      {6, infinity},
                                      {6, not_a_number},
                                      {10, 0.0},
                                      {10, -1.0},
                                      {10, infinity},
                                      {10, not_a_number}}) {
    State bad = good;
    bad.y[number] = wrong;
    BOOST_TEST(!flow.rate(0.0, bad.y, dy));
    BOOST_TEST(contains(flow.why_no_value(bad), "cell 2 has"));
  }
  State swift = good;
  swift.y[6] = 100.0;  // more energy of motion than energy
  BOOST_TEST(!flow.rate(0.0, swift.y, dy));
  BOOST_TEST(flow.rate(0.0, good.y, dy));
  BOOST_TEST(flow.why_no_value(good) == "");
  BOOST_TEST(contains(flow.why_no_value([&] {
    State bad = good;
    bad.y[1] = -0.5;
    return bad;
  }()),
                      "cell 1 has -0.5 kg/m^3"));
}

BOOST_AUTO_TEST_CASE(refuses_a_state_of_another_flow) {
  const GasFlow<1> flow(line, gas, {});
  const State other{.y = VectorXd::Ones(5)};
  VectorXd dy(5);
  const auto refused = [](const std::invalid_argument& error) {
    return contains(error.what(), "a state of 4 cells must hold 12 numbers, 3 a cell, got 5");
  };
  BOOST_CHECK_EXCEPTION(flow.rate(0.0, other.y, dy), std::invalid_argument, refused);
  BOOST_CHECK_EXCEPTION(flow.step_limits(other), std::invalid_argument, refused);
  BOOST_CHECK_EXCEPTION(flow.why_no_value(other), std::invalid_argument, refused);
}

BOOST_AUTO_TEST_CASE(says_where_kinetic_energy_leaves_hardly_any_temperature) {
  const GasFlow<1> flow(line, gas, {});
  const State cold = flow.start([](const Vector<1>& x) {
    return Local<1>{.rho = 1.0, .v = Vector<1>(1e3), .theta = x[0] > 2.0 && x[0] < 3.0 ? 1e-5 : 300.0};
  });
  BOOST_TEST(contains(flow.why_no_value(cold), "cell 2 has hardly any temperature left, 1 kg/m^3, "));
  BOOST_TEST(flow.why_no_value(flow.start(anything<1>)) == "");
}

BOOST_AUTO_TEST_CASE(asks_what_is_given_at_its_time_and_a_cell_beyond_the_face) {
  std::vector<std::pair<double, double>> asked;
  const Given<1> tells{[&](double t, const Vector<1>& x) {
    asked.emplace_back(t, x[0]);
    return anything<1>(x);
  }};
  const GasFlow<1> flow(line, gas, {tells, tells});
  State state = flow.start(anything<1>);
  state.t = 3.5;
  rate_of(flow, state);
  BOOST_TEST_REQUIRE(asked.size() == 2);
  BOOST_TEST((asked[0] == std::pair{3.5, -0.5}));
  BOOST_TEST((asked[1] == std::pair{3.5, 4.5}));
}

BOOST_AUTO_TEST_CASE(lets_what_a_given_fluid_throws_through) {
  const Given<2> throws{[](double, const Vector<2>&) -> Local<2> { throw std::domain_error("no fluid here"); }};
  const GasFlow<2> flow({.cells = {8, 8}}, gas, {Periodic{}, Periodic{}, throws, Wall<2>{}}, 2);
  const State state = flow.start([](const Vector<2>&) { return Local<2>{}; });
  Eigen::VectorXd dy(state.y.size());
  BOOST_CHECK_THROW(flow.rate(0.0, state.y, dy), std::domain_error);
}

BOOST_AUTO_TEST_CASE(has_no_value_where_what_is_given_has_none_and_forgets_it) {
  const auto make = [](int threads) {
    const Given<3> late{[](double t, const Vector<3>& x) {
      Local<3> here = anything<3>(x);
      if (t > 1.0) here.v[1] = not_a_number;
      if (t > 2.0) here.v[1] = 0.0, here.rho = -1.0;
      return here;
    }};
    return GasFlow<3>(brick, gas, {Periodic{}, Periodic{}, late, Outflow{.P = 1.0}, Wall<3>{}, late}, threads);
  };
  for (const int threads : {1, 2}) {
    const GasFlow<3> flow = make(threads), fresh = make(threads);
    const State state = flow.start(anything<3>);
    VectorXd dy(state.y.size());
    BOOST_TEST(!flow.rate(2.0, state.y, dy));
    BOOST_TEST(!flow.rate(3.0, state.y, dy));
    BOOST_TEST((rate_of(flow, state).array() == rate_of(fresh, state).array()).all());
  }
}

BOOST_AUTO_TEST_CASE(conserves_mass_momentum_and_energy_of_what_nothing_leaves) {
  const GasFlow<3> flow(brick, gas, periodic<3>());
  const VectorXd dy = rate_of(flow, flow.start(anything<3>));
  for (int f = 0; f < 5; ++f) {
    const auto field = dy.segment(120 * f, 120);
    BOOST_TEST(std::abs(field.sum()) < 1e-14 * field.cwiseAbs().sum());
  }
}

// Walls at rest let neither mass nor energy through.
BOOST_AUTO_TEST_CASE(conserves_mass_and_energy_between_adiabatic_walls) {
  const Wall<3> sticks{}, slips{.slips = true};
  const GasFlow<3> flow(brick, gas, {sticks, slips, slips, sticks, sticks, sticks});
  const VectorXd dy = rate_of(flow, flow.start(anything<3>));
  for (const int f : {0, 4}) {
    const auto field = dy.segment(120 * f, 120);
    BOOST_TEST(std::abs(field.sum()) < 1e-14 * field.cwiseAbs().sum());
  }
}

// In several blocks of rows and planes, which threads share.
BOOST_AUTO_TEST_CASE(is_the_same_to_the_bit_for_any_number_of_threads_and_for_a_copy) {
  const Grid<3> large{.cells = {5, 18, 35}, .lengths = {2.5, 9.0, 17.5}};
  const Given<3> in{[](double, const Vector<3>& x) { return anything<3>(x); }};
  const Boundaries<3> mixed{in, Outflow{.P = 1.0}, Wall<3>{}, Wall<3>{.theta = 1.2}, Periodic{}, Periodic{}};
  const GasFlow<3> alone(large, gas, mixed);
  const State state = alone.start(anything<3>);
  const VectorXd expected = rate_of(alone, state);
  const auto is_the_same = [&](const GasFlow<3>& flow) {
    BOOST_TEST((rate_of(flow, state).array() == expected.array()).all());
  };
  for (const int threads : {2, 3, 100}) is_the_same(GasFlow<3>(large, gas, mixed, threads));
  const GasFlow<3> copy = alone;
  is_the_same(copy);
  is_the_same(alone);
}

// Nothing changes across a direction that is left out.
BOOST_AUTO_TEST_CASE(of_one_and_two_dimensions_is_that_of_three_without_the_others) {
  const auto along = [](double x) { return anything<1>(Vector<1>(x)); };
  const Grid<1> one{.cells = {6}, .lengths = Vector<1>(3.0)};
  const Grid<2> two{.cells = {6, 4}, .lengths = {3.0, 1.0}};
  const Grid<3> three{.cells = {6, 4, 5}, .lengths = {3.0, 1.0, 2.0}};
  const auto fluid = [&]<int Dim>(const Vector<Dim>& x) {
    const Local<1> here = along(x[0]);
    Local<Dim> all{.rho = here.rho, .theta = here.theta};
    all.v[0] = here.v[0];
    return all;
  };
  const auto rate_along = [&]<int Dim>(const Grid<Dim>& grid, Boundaries<Dim> faces) {
    faces[0] = Wall<Dim>{}, faces[1] = Wall<Dim>{.theta = 2.0};
    const GasFlow<Dim> flow(grid, gas, faces);
    const VectorXd dy = rate_of(flow, flow.start([&](const Vector<Dim>& x) { return fluid(x); }));
    VectorXd three_fields(18);
    const Eigen::Index N = grid.size();
    three_fields << dy.segment(N - 6, 6), dy.segment(2 * N - 6, 6), dy.tail(6);
    return three_fields;
  };
  const VectorXd expected = rate_along(one, periodic<1>());
  BOOST_TEST(close(rate_along(two, periodic<2>()), expected, {.relative = 1e-13, .absolute = 1e-14}));
  BOOST_TEST(close(rate_along(three, periodic<3>()), expected, {.relative = 1e-13, .absolute = 1e-14}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(solve)

BOOST_AUTO_TEST_CASE(takes_one_step_of_one_field_and_leaves_the_others) {
  const Given<2> pulsing{[](double t, const Vector<2>& x) {
    Local<2> here = anything<2>(x);
    here.theta += 0.1 * std::sin(t);
    return here;
  }};
  const GasFlow<2> flow(square, gas, {pulsing, Outflow{.P = 1.0}, Periodic{}, Periodic{}});
  State from = flow.start([](const Vector<2>& x) { return anything<2>(2.0 * x); });
  from.t = 0.7;
  State seen = flow.start(anything<2>);
  seen.t = 0.95;
  const double dt = 0.25;
  const VectorXd dy = rate_of(flow, seen);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto part = flow.part(k);
    VectorXd expected = seen.y;
    expected.segment(part.first, part.size) =
        from.y.segment(part.first, part.size) + dt * dy.segment(part.first, part.size);
    State to = seen;
    BOOST_TEST(flow.solve(k, from, dt, seen, to));
    BOOST_TEST(close(to.y, expected, {.absolute = 1e-15}));
    State same = seen;
    BOOST_TEST(flow.solve(k, from, dt, same, same));
    BOOST_TEST((same.y.array() == to.y.array()).all());
  }
}

BOOST_AUTO_TEST_CASE(has_no_value_where_the_rate_has_none) {
  const State from = ring.start(anything<1>);
  State bad = from;
  bad.y[0] = -1.0;
  BOOST_TEST(!ring.solve(1, from, 0.1, bad, bad));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(step_limits)

using Kind = particulate::schemes::TimeScale::Kind;

// Cells of 1/2 m x 1/4 m: 1/h^2 = 4 and 16.
const Grid<2> oblong{.cells = {4, 8}, .lengths = {2.0, 2.0}};
const GasFlow<2> oblong_flow(oblong, gas, periodic<2>());
constexpr double sound_of_gas = 3.0;  // gamma R theta = 1.5 * 6
Local<2> warm(const Vector<2>& v) { return {.rho = 2.0, .v = v, .theta = 6.0}; }

template <class F>
void are(const F& flow, const State& at, const std::vector<particulate::schemes::TimeScale>& expected) {
  const auto scales = flow.step_limits(at);
  BOOST_TEST_REQUIRE(scales.size() == expected.size());
  for (std::size_t k = 0; k < scales.size(); ++k) {
    BOOST_TEST(scales[k].name == expected[k].name);
    BOOST_TEST((scales[k].kind == expected[k].kind));
    BOOST_TEST(scales[k].seconds == expected[k].seconds, tolerance(1e-13));
  }
}

// Viscosity 4 * 0.75/2 (20 + 16/3) = 38; conduction 4 * 0.5/(2 * 2) * 20 = 10.
BOOST_AUTO_TEST_CASE(of_a_fluid_at_rest_are_sound_and_what_diffuses) {
  are(oblong_flow, oblong_flow.start([](const Vector<2>&) {
    return warm({0.0, 0.0});
  }),
      {{"sound, carried along", Kind::waves, 1.0 / (sound_of_gas * std::sqrt(20.0))},
       {"viscosity", Kind::decays, 1.0 / 38.0},
       {"conduction", Kind::decays, 0.1}});
}

// 3 (U^2 + U S/2) L/s with U = 2 + 2 and S = 3 sqrt(20) cells a second, L = 2 m and s = 3 m/s.
BOOST_AUTO_TEST_CASE(of_a_fluid_that_moves_are_those_of_advection_too) {
  are(oblong_flow, oblong_flow.start([](const Vector<2>&) {
    return warm({-1.0, 0.5});
  }),
      {{"sound, carried along", Kind::waves, 1.0 / (4.0 + sound_of_gas * std::sqrt(20.0))},
       {"viscosity", Kind::decays, 1.0 / 38.0},
       {"conduction", Kind::decays, 0.1},
       {"advection, where one sweep drives it", Kind::drifts, 0.5 / (16.0 + 6.0 * std::sqrt(20.0))}});
}

// lambda + mu = 4 mu: 4 * 0.75 (3 + 4 * 9/8) = 22.5.
BOOST_AUTO_TEST_CASE(of_three_dimensions_leave_room_for_waves_along_the_diagonal) {
  Fluid<particulate::continuum::IdealGas> stiff = gas;
  stiff.lambda_over_mu = 3.0;
  const GasFlow<3> flow({.cells = {4, 4, 4}, .lengths = {4.0, 4.0, 4.0}}, stiff, periodic<3>());
  const auto scales = flow.step_limits(flow.start([](const Vector<3>&) { return Local<3>{}; }));
  BOOST_TEST_REQUIRE(scales.size() == 3);
  BOOST_TEST(scales[1].seconds == 1.0 / 22.5, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(are_those_of_the_cell_that_is_worst) {
  State state = oblong_flow.start([](const Vector<2>& x) {
    return x[0] < 0.5 && x[1] < 0.25 ? warm({0.0, 2.0}) : Local<2>{.rho = 4.0, .theta = 1.5};
  });
  const std::vector<particulate::schemes::TimeScale> expected{
      {"sound, carried along", Kind::waves, 1.0 / (8.0 + sound_of_gas * std::sqrt(20.0))},
      {"viscosity", Kind::decays, 1.0 / 38.0},
      {"conduction", Kind::decays, 0.1},
      {"advection, where one sweep drives it", Kind::drifts, 0.5 / (64.0 + 12.0 * std::sqrt(20.0))}};
  are(oblong_flow, state, expected);
  state.y[5] = not_a_number;
  are(oblong_flow, state, expected);
}

// Sound of 2 m/s crosses a cell of 1 m.
BOOST_AUTO_TEST_CASE(of_a_barotropic_fluid_without_viscosity_are_sound_alone_and_refuse_longer_steps) {
  namespace schemes = particulate::schemes;
  Fluid<particulate::continuum::Barotropic> ideal = barotropic;
  ideal.viscosity.mu = 0.0;
  BarotropicFlow<1> flow(line, ideal, periodic<1>());
  const State still = flow.start([](const Vector<1>&) { return Local<1>{}; });
  are(flow, still, {{"sound, carried along", Kind::waves, 0.5}});
  const auto longest = [&](auto scheme, auto control) {
    State state = still;
    const schemes::Outcome out = schemes::integrate(flow, state, 10.0, scheme, control);
    BOOST_TEST(contains(out.reason, "the time scale of sound, carried along, which is 0.5 s"));
    return out.workable_step;
  };
  const auto staggered = [] { return schemes::Staggered({{.name = "density"}, {.name = "momentum"}}); };
  BOOST_TEST(longest(schemes::RungeKutta4{}, schemes::FixedStep{.step = 2.0}) == std::sqrt(2.0), tolerance(1e-14));
  BOOST_TEST(longest(staggered(), schemes::FixedSweeps{.step = 1.01, .sweeps = 1}) == 1.0, tolerance(1e-14));
  BOOST_TEST(longest(staggered(), schemes::FixedSweeps{.step = 0.51, .sweeps = 2}) == 0.5, tolerance(1e-14));
  BOOST_TEST(longest(schemes::ForwardEuler{}, schemes::FixedStep{.step = 1e-6}) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::flow_test
