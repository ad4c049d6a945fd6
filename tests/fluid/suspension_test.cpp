#include <particulate/fluid/suspension.hpp>

#include <cmath>
#include <stdexcept>

#include <particulate/contact/located_contact.hpp>
#include <particulate/fluid/frozen_flow.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/cooling.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "close.hpp"

namespace tests::suspension_test {

using namespace particulate;
using namespace particulate::fluid;
using contact::Contact, contact::LocatedContact;
using Eigen::Vector3d, Eigen::VectorXd;
using kinematics::Particle;
using schemes::State;

using Hot = Suspension<GasFlow<3>, HeatExchange>;
using Plain = Suspension<GasFlow<3>>;
static_assert(schemes::CoupledProblem<Hot> && schemes::StaggeredProblem<Hot> && schemes::HasStepLimits<Hot>);
static_assert(!schemes::Jumps<Hot> && schemes::Jumps<Suspension<GasFlow<3>, NoHeat, Contact<>>>);
static_assert(schemes::LocatesJumps<Suspension<GasFlow<3>, NoHeat, LocatedContact<>>>);
static_assert(Hot::has_temperatures && !Plain::has_temperatures);
static_assert(!schemes::Advances<schemes::VelocityVerlet, Plain> && schemes::Advances<schemes::Staggered, Plain>);

// A gas with gamma = 1 + 1/2.
const Fluid<continuum::IdealGas> gas{.state = {.R = 1.0}, .viscosity = {.mu = 0.05}, .c = 2.0, .K = 0.5};
const Fluid<continuum::Barotropic> cold{.state = {.P_R = 1.0, .Y = 4.0, .rho_R = 1.0}, .viscosity = {.mu = 0.05}};
template <int Dim>
Grid<Dim> box() {
  Grid<Dim> grid{.lengths = Vector<Dim>::Constant(2.0)};
  grid.cells.fill(8);
  return grid;
}
template <int Dim>
Boundaries<Dim> closed() {
  Boundaries<Dim> walls;
  walls.fill(Wall<Dim>{});
  return walls;
}
template <int Dim>
GasFlow<Dim> ring() {
  return {box<Dim>(), gas, {}};
}

template <int Dim>
Local<Dim> anything(const Vector<Dim>& x) {
  const double s = pi * x.sum();
  return {
      .rho = 1.0 + 0.2 * std::sin(s), .v = Vector<Dim>::Constant(0.3 * std::cos(s)), .theta = 2.0 + 0.1 * std::sin(s)};
}
template <int Dim>
Local<Dim> still(const Vector<Dim>&) {
  return {.rho = 2.0, .theta = 6.0};
}

const Vector3d rest = Vector3d::Zero();
Particle sphere(const Vector3d& r, const Vector3d& v = rest, double mass = 0.3) {
  return {.position = r, .velocity = v, .mass = mass, .radius = 0.1, .temperature = 4.0, .heat_capacity = 3.0};
}
// One near a face, one far outside of the box, which begins again, and one in the middle.
kinematics::Particles three() {
  return kinematics::particles({sphere({0.03, 0.4, 1.9}, {1.0, -0.5, 0.2}),
                                sphere({21.3, -3.1, 0.7}, {0.0, 0.7, -1.0}, 0.1),
                                sphere({1.1, 1.2, 1.05}, {-0.4, 0.1, 0.3}, 2.0)});
}
const HeatExchange heat{.h_c = 2.0, .emissivity = 0.0, .a_v = 0.4};

template <class S>
schemes::Staggered staggered(const S& suspension) {
  const auto name = [](std::size_t k) { return std::array{"1", "2", "3", "4", "5"}.at(k); };
  std::vector<schemes::Field> fields;
  for (std::size_t k = 0; k < suspension.fields(); ++k) fields.push_back({.name = name(k), .TOL = 1e-12});
  return schemes::Staggered(fields);
}
template <class S, class Scheme, class Control>
State after(const S& suspension, State at, double seconds, Scheme scheme, Control control) {
  const schemes::Outcome out = integrate(suspension, at, at.t + seconds, scheme, control);
  BOOST_TEST_REQUIRE((out.status == schemes::Status::reached), out);
  return at;
}
void are_close(const Totals& a, const Totals& b, double of_energy = 1e-13) {
  BOOST_TEST(a.mass == b.mass, tolerance(1e-13));
  BOOST_TEST(close(a.momentum, b.momentum, {.absolute = 1e-13}));
  BOOST_TEST(a.energy == b.energy, tolerance(of_energy));
}
bool same(const State& a, const State& b) { return a.r == b.r && a.v == b.v && a.y == b.y; }

BOOST_AUTO_TEST_SUITE(Suspension_refusals)

BOOST_AUTO_TEST_CASE(of_what_does_not_fit_the_box_say_what_to_do) {
  const auto in = [](const Boundaries<3>& faces, const Particle& particle, Spreading spreading = {.w = 0.5}) {
    return Suspension(GasFlow<3>(box<3>(), gas, faces), kinematics::particles({particle}), spreading);
  };
  const Particle inside = sphere({1.0, 1.0, 1.0}), beyond = sphere({2.5, 1.0, 1.0});
  CHECK_REFUSED(in({}, inside, {.w = 0.24}), "got 0.24 m for particle 0: take smaller cells, or a larger w");
  CHECK_REFUSED(in({}, inside, {.w = 1.01}), "got 1.01 m for particle 0: take a larger box, or a smaller w");
  CHECK_REFUSED(in({}, inside, {.w = not_a_number}), "got nan m for particle 0");
  BOOST_TEST(in({}, inside, {}).particles().size() == 1);  // 5 * 0.1 m
  for (const Boundary<3>& face : {Boundary<3>(Outflow{}), Boundary<3>(Wall<3>{})}) {
    CHECK_REFUSED(in({face, face, Periodic{}, Periodic{}, Periodic{}, Periodic{}}, beyond),
                  "particle 0 at (2.5, 1, 1) m is outside of the box, which does not begin again there, or too far "
                  "away to tell its cell: end the run "
                  "where it leaves, take a larger box, or keep it in by a contact with the box's walls");
  }
  BOOST_CHECK_NO_THROW(in({}, beyond));
  BOOST_CHECK_NO_THROW(in({}, inside, {.w = 0.25, .corrected = true}));
  Particle large = inside;
  large.radius = 0.2;
  CHECK_REFUSED(
      in({}, large, {.w = 0.39, .corrected = true}),
      "needs a half-width of at least two radii, got 0.39 m for particle 0 of radius 0.2 m: take a larger w, or "
      "no correction");
  large.radius = 0.51;
  CHECK_REFUSED(in({}, large), "space: its length in direction x must be at least two diameters");
}

BOOST_AUTO_TEST_CASE(of_an_overlapping_start_name_both) {
  const auto with = [](const GasFlow<3>& flow, const Particle& a, const Particle& b) {
    return Suspension(flow, kinematics::particles({a, b}));
  };
  const Particle middle = sphere({1.0, 1.0, 1.0});
  CHECK_REFUSED(with(ring<3>(), middle, sphere({1.15, 1.0, 1.0})),
                "suspension: no two particles may overlap at the start, nor a particle and a wall; particle 0 overlaps "
                "particle 1 by 0.05 m: place them apart");
  CHECK_REFUSED(with(ring<3>(), sphere({0.05, 1.0, 1.0}), sphere({1.95, 1.0, 5.0})), "particle 1 by 0.1 m");
  CHECK_REFUSED(with({box<3>(), gas, closed<3>()}, middle, sphere({1.0, 1.0, 0.04})),
                "particle 1 overlaps a wall by 0.06 m: place them apart");
  BOOST_CHECK_NO_THROW(with({box<3>(), gas, closed<3>()}, middle, sphere({1.0, 1.2, 0.1})));
}

BOOST_AUTO_TEST_CASE(of_fluids_heat_and_laws_that_cannot_be_meant) {
  Fluid<continuum::IdealGas> ideal = gas;
  ideal.viscosity.mu = 0.0;
  CHECK_REFUSED(Suspension(GasFlow<3>(box<3>(), ideal, {}), three()),
                "suspension: drag asks for the viscosity of the fluid, which must be positive, got 0 Pa s");
  BOOST_CHECK_NO_THROW(Suspension(GasFlow<3>(box<3>(), ideal, {}), kinematics::Particles{}));
  CHECK_REFUSED(Suspension(ring<3>(), three(), {}, HeatExchange{.a_v = 1.5}), "a_v must lie between 0 and 1, got 1.5");
  CHECK_REFUSED(Suspension(ring<3>(), three(), {}, HeatExchange{.a_v = not_a_number}), "got nan");
  kinematics::Particles without = three();
  without.temperature = without.heat_capacity = VectorXd();
  CHECK_REFUSED(Suspension(ring<3>(), without, {}, heat), "every particle must have a temperature and a heat capacity");
  BOOST_CHECK_NO_THROW(Suspension(ring<3>(), without));
  const auto near = [](double cutoff, double taper) {
    return Suspension(ring<3>(), three(), {}, NoHeat{},
                      laws::NearField{.alpha1 = 1.0, .cutoff = cutoff, .taper = taper});
  };
  CHECK_REFUSED(near(infinity, 0.0), "it must reach no farther than half the shortest period, 1 m");
  CHECK_REFUSED(near(1.01, 0.1), "it reaches 1.01 m: set cutoff, and a taper if the force is to end smoothly");
  BOOST_CHECK_NO_THROW(near(1.0, 0.1));
  kinematics::Particles lost = three();
  lost.position(1, 2) = not_a_number;
  CHECK_REFUSED(Suspension(ring<3>(), lost),
                "particles: positions must be finite, got (21.3, -3.1, nan) m for particle 1");
}

BOOST_AUTO_TEST_CASE(of_states_of_another_size_and_of_fields_out_of_order) {
  const Hot suspension(ring<3>(), three(), {}, heat);
  const State start = suspension.start(anything<3>);
  State other = start;
  other.y.conservativeResize(7);
  const char* const words =
      "suspension: a state of 3 particles must hold 9 numbers of places and as many of velocities, and in y 2563 of "
      "the "
      "fluid and of temperatures, got 9, 9 and 7";
  VectorXd a(9), dy(7);
  CHECK_REFUSED(suspension.rates(0.0, other.r, other.v, other.y, a, dy), words);
  CHECK_REFUSED(suspension.solve(0, other, 0.1, other, other), words);
  CHECK_REFUSED(suspension.step_limits(other), words);
  CHECK_REFUSED(suspension.totals(other), words);
  CHECK_REFUSED(suspension.streams(other), words);
  CHECK_REFUSED(suspension.why_no_value(other), words);
  CHECK_REFUSED(suspension.of_particles(other), words);
  other = start;
  other.r.conservativeResize(3);
  CHECK_REFUSED(suspension.why_no_value(other), "of the fluid and of temperatures, got 3, 9 and 2563");
  CHECK_REFUSED(suspension.solve(0, start, 0.1, other, other), "got 3, 9 and 2563");
  const char* const order = "suspension: fields must be solved in their order in each sweep, from the particles on, ";
  State to = start;
  CHECK_REFUSED(suspension.solve(3, start, 1e-3, start, to), order);
  BOOST_TEST(suspension.solve(0, start, 1e-3, start, to));
  BOOST_TEST(suspension.solve(3, start, 1e-3, start, to));
  CHECK_REFUSED(suspension.solve(1, start, 2e-3, start, to), order);
  VectorXd whole(start.y.size());
  BOOST_TEST(suspension.rates(0.0, start.r, start.v, start.y, a, whole));  // forgets what was given in the step
  CHECK_REFUSED(suspension.solve(3, start, 1e-3, start, to), order);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Suspension_fields)

BOOST_AUTO_TEST_CASE(are_particles_their_temperatures_and_the_fluid) {
  const Hot hot(ring<3>(), three(), {}, heat);
  BOOST_TEST(hot.fields() == 5);
  BOOST_TEST((hot.part(0).motion && !hot.part(1).motion));
  const Eigen::Index first[]{0, 2560, 0, 512, 2048}, size[]{0, 3, 512, 1536, 512};
  for (std::size_t k = 1; k < 5; ++k) BOOST_TEST((hot.part(k).first == first[k] && hot.part(k).size == size[k]));
  const std::vector<schemes::Range> ranges = hot.ranges();
  BOOST_TEST_REQUIRE(ranges.size() == 4);
  BOOST_TEST((ranges[0].name == "density" && ranges[3].name == "particle temperatures"));
  BOOST_TEST((ranges[3].first == 2560 && ranges[3].size == 3));
  const Plain plain(ring<3>(), three());
  BOOST_TEST((plain.fields() == 4 && plain.ranges().size() == 3 && plain.start(still<3>).y.size() == 2560));
  const Suspension barotropic(BarotropicFlow<2>(box<2>(), cold, {}), three());
  BOOST_TEST((barotropic.fields() == 3 && barotropic.start(still<2>).y.size() == 192));
  const Suspension cools(ring<3>(), three(), {}, NoHeat{}, thermo::Cooling{.h_c = 1.0});
  BOOST_TEST((cools.fields() == 5 && cools.start(still<3>).y.size() == 2563));
}

// Cells of 1/64 m^3: 512 of 2 kg/m^3 are 16 kg, of 2 * 6 J/kg. Particles: 2.4 kg, at 4 K and 3 J/(kg K).
BOOST_AUTO_TEST_CASE(have_totals_distances_and_sizes) {
  const Hot hot(ring<3>(), three(), {}, heat);
  const State start = hot.start(still<3>);
  const Totals all = hot.totals(start);
  BOOST_TEST(all.mass == 16.0, tolerance(1e-13));
  BOOST_TEST(close(all.momentum, Vector3d(0.3 - 0.8, -0.15 + 0.07 + 0.2, 0.06 - 0.1 + 0.6), {.absolute = 1e-14}));
  BOOST_TEST(all.energy == 192.0 + 28.8 + 0.15 * 1.29 + 0.05 * 1.49 + 0.26, tolerance(1e-13));
  State moved = start;
  moved.r += VectorXd::Constant(9, 1.0);
  BOOST_TEST(hot.distance(0, start.r, moved.r) == 3.0 * std::sqrt(3.0), tolerance(1e-13));
  BOOST_TEST(hot.distance(1, Vector3d(1.0, 2.0, 3.0), Vector3d(2.0, 0.0, 3.0)) == 3.0);
  BOOST_TEST(hot.field_size(1, start) == 12.0);
  BOOST_TEST(hot.field_size(2, start) == 1024.0, tolerance(1e-13));
  BOOST_TEST((hot.local(start, 77).rho == 2.0 && hot.domain().lengths == Vector3d::Constant(2.0)));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Suspension_rates)

// Particles as in a scene in the same flow, standing still; the fluid as by itself, less what they get, by hats of
// one's own.
BOOST_AUTO_TEST_CASE(are_those_of_a_scene_in_the_flow_and_of_the_flow_less_what_particles_get) {
  const GasFlow<3> flow = ring<3>();
  const Hot suspension(flow, three(), {.w = 0.6}, heat);
  const State at = suspension.start(anything<3>);
  VectorXd a(9), dy(at.y.size()), alone(2560), a_scene(9), theta(3);
  BOOST_TEST_REQUIRE(suspension.rates(0.0, at.r, at.v, at.y, a, dy));
  const State fluid{.y = at.y.head(2560)};
  const FrozenFlow field(flow, fluid, 0.6);
  const scenes::Scene scene(three(), kinematics::Space{}, Drag{field}, HeatFromFluid{field, heat});
  BOOST_TEST_REQUIRE(scene.rates(0.0, at.r, at.v, at.y.tail(3), a_scene, theta));
  BOOST_TEST(close(a, a_scene, {.relative = 1e-12}));
  BOOST_TEST(close(dy.tail(3), theta, {.relative = 1e-12}));

  Eigen::MatrixXd given(4, 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vector3d v = schemes::velocity(at, i);
    const Stream there = field(0.0, schemes::position(at, i));
    const double mass = three().mass[i];
    const Vector3d force = mass * Vector3d(a[i], a[i + 3], a[i + 6]);
    given.col(i) << force,
        force.dot(v) + 2.0 * thermo::surface(0.1) * (there.theta - 4.0) + 0.4 * force.dot(there.v - v);
  }
  Hats<3> hats(flow.grid(), {}, VectorXd::Constant(3, 0.6));
  BOOST_TEST_REQUIRE((hats.place(at.r) && flow.rate(0.0, fluid.y, alone)));
  hats.spread(given.data(), 4, 4, -64.0, alone.data() + 512);
  BOOST_TEST(close(dy.head(2560), alone, {.relative = 1e-12, .absolute = 1e-12}));
}

// Gravity, near field and contact among particles as in a scene of their own.
BOOST_AUTO_TEST_CASE(have_the_other_laws_of_a_scene_beside_drag) {
  const laws::NearField near{.alpha1 = 0.4, .alpha2 = 0.1, .cutoff = 0.9, .taper = 0.2};
  const Plain alone(ring<3>(), three());
  const Suspension both(ring<3>(), three(), {}, NoHeat{}, near, laws::Gravity{}, Contact<>{});
  const scenes::Scene scene(three(), both.domain(), near, laws::Gravity{});
  const State at = both.start(anything<3>);
  VectorXd a(9), drag(9), other(9), dy(2560), same_dy(2560);
  BOOST_TEST_REQUIRE(both.rates(0.0, at.r, at.v, at.y, a, dy));
  BOOST_TEST_REQUIRE((alone.rates(0.0, at.r, at.v, at.y, drag, same_dy) && scene.acceleration(0.0, at.r, other)));
  BOOST_TEST(close(a, drag + other, {.relative = 1e-12, .absolute = 1e-13}));
  BOOST_TEST((dy == same_dy));
}

BOOST_AUTO_TEST_CASE(have_no_drag_across_the_directions_of_the_fluid) {
  const Suspension suspension(ring<1>(), kinematics::particles({sphere({1.0, 5.0, -9.0}, {1.0, 2.0, 3.0})}));
  const State at = suspension.start(still<1>);
  VectorXd a(3), dy(at.y.size());
  BOOST_TEST(suspension.rates(0.0, at.r, at.v, at.y, a, dy));
  BOOST_TEST((a[0] < 0.0 && a[1] == 0.0 && a[2] == 0.0));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Suspension_runs)

// To rounding whatever the number of sweeps. Runge-Kutta keeps what is linear in the state, which the kinetic energy of
// the particles is not: that holds at its order.
template <class S>
void keeps_all(const S& suspension, const State& start) {
  const Totals before = suspension.totals(start);
  for (const int sweeps : {1, 2, 5}) {
    const schemes::FixedSweeps control{.step = 2e-3, .sweeps = sweeps};
    are_close(suspension.totals(after(suspension, start, 0.1, staggered(suspension), control)), before);
  }
  const schemes::FixedStep control{.step = 0.01};
  are_close(suspension.totals(after(suspension, start, 0.1, schemes::RungeKutta4{}, control)), before, 1e-9);
}
BOOST_AUTO_TEST_CASE(keep_mass_momentum_and_energy_to_rounding_for_any_number_of_sweeps) {
  const kinematics::Particles one = kinematics::particles({sphere({0.03, 0.4, 1.9}, {1.0, -0.5, 0.2}, 20.0)});
  const Suspension line(ring<1>(), one, {}, heat);
  keeps_all(line, line.start(anything<1>));
  const Suspension sheet(GasFlow<2>(box<2>(), gas, {}), three(), {}, heat, laws::NearField{.cutoff = 0.9}, Contact<>{},
                         thermo::ImpactHeat{});
  keeps_all(sheet, sheet.start(anything<2>));
  const Hot brick(ring<3>(), three(), {.w = 0.5, .corrected = true}, heat);
  keeps_all(brick, brick.start(anything<3>));
  const Plain plain(ring<3>(), three());
  keeps_all(plain, plain.start(anything<3>));
}

BOOST_AUTO_TEST_CASE(keep_mass_and_momentum_of_a_barotropic_fluid) {
  const Suspension suspension(BarotropicFlow<2>(box<2>(), cold, {}), three());
  const State start = suspension.start(anything<2>);
  const Totals before = suspension.totals(start);
  const State end =
      after(suspension, start, 0.1, staggered(suspension), schemes::FixedSweeps{.step = 2e-3, .sweeps = 1});
  const Totals there = suspension.totals(end);
  BOOST_TEST(there.mass == before.mass, tolerance(1e-14));
  BOOST_TEST(close(there.momentum, before.momentum, {.absolute = 1e-14}));
}

// Converged sweeps are backward Euler of all: at half of the step they are half as far from collocation.
BOOST_AUTO_TEST_CASE(come_to_the_same_end_by_every_scheme) {
  const Suspension suspension(ring<2>(), three(), {}, heat);
  const State start = suspension.start(anything<2>);
  const auto off = [&](const State& a, const State& b) {
    return std::hypot((a.r - b.r).norm(), (a.v - b.v).norm(), (a.y - b.y).norm());
  };
  const State exact = after(suspension, start, 0.2, schemes::Collocation<schemes::Gauss<3>>{},
                            schemes::FixedStep{.step = 0.01, .TOL = 1e-11});
  const State explicitly = after(suspension, start, 0.2, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.01});
  BOOST_TEST(off(explicitly, exact) < 1e-5);
  const auto implicitly = [&](double step) {
    return off(after(suspension, start, 0.2, staggered(suspension),
                     schemes::FixedStep{.step = step, .TOL = 1.0, .contractions = 100}),
               exact);
  };
  const double coarse = implicitly(4e-3), fine = implicitly(2e-3);
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 1.0) < 0.1);
}

BOOST_AUTO_TEST_CASE(without_particles_are_those_of_the_flow_to_the_bit) {
  const GasFlow<2> flow = ring<2>();
  const Suspension none(flow, kinematics::Particles{}, {}, heat, Contact<>{}, thermo::ImpactHeat{});
  const State start = none.start(anything<2>), fluid = flow.start(anything<2>);
  BOOST_TEST(start.y == fluid.y);
  const schemes::FixedStep explicitly{.step = 0.01};
  const auto end = [&](const auto& problem, const State& from) {
    return after(problem, from, 0.1, schemes::RungeKutta4{}, explicitly).y;
  };
  BOOST_TEST(end(none, start) == end(flow, fluid));
  const schemes::FixedSweeps sweeps{.step = 2e-3, .sweeps = 3};
  const VectorXd both = after(none, start, 0.1, staggered(none), sweeps).y;
  BOOST_TEST(both == after(flow, fluid, 0.1, staggered(flow), sweeps).y);
}

// Whatever is asked in between, of the same object, of a copy, or by another run.
BOOST_AUTO_TEST_CASE(share_an_object_with_others_and_threads_to_the_bit) {
  const Hot suspension(ring<3>(), three(), {}, heat);
  const State start = suspension.start(anything<3>);
  const schemes::FixedSweeps control{.step = 2e-3, .sweeps = 2};
  const State expected = after(suspension, start, 6e-3, staggered(suspension), control);
  State asked = start;
  const auto ask = [&](const State& from, const State& to, double, const auto&) {
    (void)suspension.step_limits(from), (void)suspension.reynolds(to);
    (void)after(suspension, start, 4e-3, staggered(suspension), control);
    return true;
  };
  (void)integrate(suspension, asked, 6e-3, staggered(suspension), schemes::FixedSweeps(control), ask);
  BOOST_TEST(same(asked, expected));
  const Hot copy = suspension;
  BOOST_TEST(same(after(copy, start, 6e-3, staggered(copy), control), expected));
  for (const int threads : {2, 3}) {
    const Hot shared(GasFlow<3>(box<3>(), gas, {}, threads), three(), {}, heat);
    BOOST_TEST(same(after(shared, start, 6e-3, staggered(shared), control), expected));
  }
}

BOOST_AUTO_TEST_CASE(are_the_same_a_billion_periods_away_and_late) {
  const Hot suspension(ring<3>(), three(), {}, heat);
  const State start = suspension.start(anything<3>);
  const auto end = [&](const State& from) {
    return after(suspension, from, 0.02, staggered(suspension), schemes::FixedSweeps{.step = 2e-3, .sweeps = 2});
  };
  State far = start;
  far.r.head(3).array() += 2e9;
  far.t = 1e6;
  BOOST_TEST(close(end(far).y, end(start).y, {.relative = 1e-6, .absolute = 1e-6}));
  BOOST_TEST(close(end(far).v, end(start).v, {.relative = 1e-6}));
}

BOOST_AUTO_TEST_CASE(end_where_a_particle_leaves_and_leave_the_state_before) {
  Boundaries<3> open{};
  open[4] = open[5] = Wall<3>{};
  const Suspension suspension(GasFlow<3>(box<3>(), gas, open),
                              kinematics::particles({sphere({1.0, 1.0, 1.85}, {0.0, 0.0, 1.0}, 1e3)}));
  State at = suspension.start(still<3>);
  const double energy = suspension.totals(at).energy;
  const schemes::Outcome out =
      integrate(suspension, at, 1.0, staggered(suspension), schemes::FixedSweeps{.step = 4e-3, .sweeps = 2});
  BOOST_TEST((out.failure == schemes::Failure::no_value));
  BOOST_TEST(contains(out.reason, "particle 0 at (1, 1, "));
  BOOST_TEST(
      contains(out.reason, "which does not begin again there, or too far away to tell its cell: end the run where it"));
  BOOST_TEST(std::abs(at.t - 0.15) < 5e-3);
  BOOST_TEST((at.r[2] > 1.99 && at.r[2] <= 2.0));
  BOOST_TEST(suspension.totals(at).energy == energy, tolerance(1e-13));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Suspension_jump)

// Two that meet head on in a fast stream: the drag on both, 6 pi mu b of a slip of 5 and 7 m/s and more, is among the
// forces of their impact as it is in a scene in the same flow.
BOOST_AUTO_TEST_CASE(feel_the_drag_as_in_a_scene_and_turn_into_heat) {
  const GasFlow<3> flow = ring<3>();
  const kinematics::Particles both =
      kinematics::particles({sphere({0.9, 1.0, 1.0}, {1.0, 0.0, 0.0}), sphere({1.1, 1.0, 1.0}, {-1.0, 0.0, 0.0})});
  const Contact<> bounce{.restitution = {.e = 0.5}, .gamma = 0.5};
  const Suspension suspension(flow, both, {.w = 0.5}, heat, bounce, thermo::ImpactHeat{});
  State at = suspension.start([](const Vector<3>& x) {
    return Local<3>{.rho = 5.0, .v = {x[0] < 1.0 ? 6.0 : 0.0, 0.0, 0.0}};
  });
  at.r[1] -= 1e-3;
  const double before = suspension.totals(at).energy;
  const FrozenFlow field(flow, {.y = at.y.head(2560)}, 0.5);
  const auto expected = [&](const auto&... drag) {
    const scenes::Scene scene(both, suspension.domain(), drag..., bounce, thermo::ImpactHeat{});
    State state{.r = at.r, .v = at.v, .y = at.y.tail(2)};
    BOOST_TEST(scene.jump(state, 0.1).impacts == 1);
    return state;
  };
  const State with = expected(Drag{field}), without = expected();
  const schemes::Jump jump = suspension.jump(at, 0.1);
  BOOST_TEST((jump.impacts == 1 && jump.unsettled.empty()));
  BOOST_TEST(close(at.v, with.v, {.absolute = 1e-14}));
  BOOST_TEST(close(at.y.tail(2), with.y, {.relative = 1e-14}));
  BOOST_TEST((with.v - without.v).norm() > 1e-3);
  BOOST_TEST(jump.heat > 0.0);
  BOOST_TEST(suspension.totals(at).energy - before == jump.energy_change + jump.heat, tolerance(1e-9));
  at.y[3] = -1.0;
  BOOST_TEST(
      contains(suspension.jump(at, 0.1).unsettled, "the fluid has no value where bodies touch: cell 3 has -1 kg/m^3"));
}

template <class C>
void bounce_between_walls(const C& law) {
  const kinematics::Particles heavy = kinematics::particles({sphere({1.0, 1.0, 1.0}, {3.0, 0.0, 0.0}, 50.0)});
  const Suspension suspension(GasFlow<2>(box<2>(), gas, closed<2>()), heavy, {}, heat, law, thermo::ImpactHeat{});
  State at = suspension.start(still<2>);
  const double energy = suspension.totals(at).energy;
  const schemes::Outcome out =
      integrate(suspension, at, 1.0, staggered(suspension), schemes::FixedSweeps{.step = 4e-3, .sweeps = 2});
  BOOST_TEST((out.status == schemes::Status::reached), out);
  BOOST_TEST(out.impacts == 2);
  BOOST_TEST((at.v[0] > 0.0 && at.v[0] < 3.0));
  BOOST_TEST(suspension.totals(at).energy == energy, tolerance(1e-12));
}
BOOST_AUTO_TEST_CASE(with_walls_keep_particles_in_and_give_all_their_energy_to_heat) {
  bounce_between_walls(Contact<>{.restitution = {.e = 0.9}});
  bounce_between_walls(LocatedContact<>{.restitution = {.e = 0.9}});
  bounce_between_walls(Contact<contact::SofteningRestitution>{.restitution = {.cold = {.e_o = 0.9}}});
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Suspension_step_limits)

using Kind = schemes::TimeScale::Kind;

// One sphere on the middle of a cell, w = h: all of it is in that cell, of 1 m with 2 kg/m^3 and c = 2. Stokes: xi = 1.
// m = 8: Lambda = 4, R = 1/2; m c = 24 and h_c a_s = 12: Lambda = 6, R = 3. So 1/8 + 1/2, 1/2 * 3/4, 12/24 + 3, 3 *
// 5/6.
BOOST_AUTO_TEST_CASE(are_those_of_the_flow_and_of_what_both_exchange) {
  constexpr double b = 1.0 / (6.0 * pi);
  Fluid<continuum::IdealGas> thick = gas;
  thick.viscosity.mu = 1.0;
  const GasFlow<1> flow({.cells = {8}, .lengths = Vector<1>(8.0)}, thick, {});
  const auto limits = [&](double mass, double h_c) {
    const Suspension suspension(
        flow,
        kinematics::particles(
            {{.position = {2.5, 0.0, 0.0}, .mass = mass, .radius = b, .temperature = 4.0, .heat_capacity = 3.0}}),
        {.w = 1.0}, HeatExchange{.h_c = h_c});
    std::vector<schemes::TimeScale> all = suspension.step_limits(suspension.start(still<1>));
    const std::size_t own = flow.step_limits(flow.start(still<1>)).size();
    return std::vector<schemes::TimeScale>(all.begin() + static_cast<std::ptrdiff_t>(own), all.end());
  };
  const std::vector<schemes::TimeScale> all = limits(8.0, 12.0 / (4.0 * pi * b * b));
  const schemes::TimeScale expected[]{{"drag", Kind::relaxes, 1.6},
                                      {"mass of the particles against their fluid's", Kind::loads, 1.0 / 0.375},
                                      {"heat of the particles", Kind::relaxes, 1.0 / 3.5},
                                      {"heat capacity of the particles against their fluid's", Kind::loads, 0.4}};
  BOOST_TEST_REQUIRE(all.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST((all[k].name == expected[k].name && all[k].kind == expected[k].kind));
    BOOST_TEST(all[k].seconds == expected[k].seconds, tolerance(1e-12));
  }
  BOOST_TEST(limits(1.0, 0.0).size() == 1);  // lighter than their fluid, and no heat
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(what_particles_feel)

BOOST_AUTO_TEST_CASE(is_the_fluid_around_them_and_its_reynolds_number) {
  const Hot suspension(ring<3>(), three(), {}, heat);
  State at = suspension.start([](const Vector<3>&) {
    return Local<3>{.rho = 2.0, .v = {1.0, 0.0, 0.0}, .theta = 6.0};
  });
  for (const Stream& there : suspension.streams(at)) {
    BOOST_TEST(close(there.v, Vector3d(1.0, 0.0, 0.0), {.absolute = 1e-14}));
    BOOST_TEST((std::abs(there.rho - 2.0) < 1e-14 && std::abs(there.theta - 6.0) < 1e-13 && there.mu == 0.05));
  }
  // 2 * 0.1 * 2/0.05 = 8 a m/s of slip.
  BOOST_TEST(suspension.reynolds(at)[0] == 8.0 * std::sqrt(0.29), tolerance(1e-12));
  at.y[7] = not_a_number;
  CHECK_REFUSED(suspension.streams(at), "cell 7 has nan kg/m^3");
}

// At u_c = 3e5 mu/(2 b rho) = 0.75 m/s C_D jumps. With dt rho pi b^2/(2 m) u_c = 4 a slip of 2.2 u_c leads to two roots
// of backward Euler, and to that on whose side the sweeps begin.
BOOST_AUTO_TEST_CASE(tells_which_root_its_drag_took_beside_the_jump) {
  constexpr double u_c = 0.75, mass = 1e3, dt = 8.0 * mass / (u_c * 1e5 * pi * 0.01);
  const Plain suspension(ring<3>(), kinematics::particles({sphere({1.0, 1.0, 1.0}, {-2.2 * u_c, 0.0, 0.0}, mass)}));
  const State start = suspension.start([](const Vector<3>&) { return Local<3>{.rho = 1e5, .theta = 1.0}; });
  for (const double slip : {0.9 * u_c, 1.2 * u_c}) {
    State to = start;
    to.v[0] = -slip;
    for (int sweep = 0; sweep < 100; ++sweep) BOOST_TEST_REQUIRE(suspension.solve(0, start, dt, to, to));
    to.t += dt;
    const bool slow = slip < u_c;
    BOOST_TEST((suspension.roots_taken().slow == (slow ? 1 : 0) && suspension.roots_taken().fast == (slow ? 0 : 1)));
    BOOST_TEST((suspension.reynolds(to)[0] < drag_crisis) == slow);
  }
}

BOOST_AUTO_TEST_CASE(is_said_where_it_has_no_value) {
  const Hot suspension(GasFlow<3>(box<3>(), gas, closed<3>()), kinematics::particles({sphere({1.0, 1.0, 1.0})}), {},
                       heat);
  const State good = suspension.start(still<3>);
  const auto why = [&](auto change) {
    State bad = good;
    change(bad);
    return suspension.why_no_value(bad);
  };
  BOOST_TEST(suspension.why_no_value(good) == "");
  BOOST_TEST(contains(why([](State& s) { s.y[5] = -1.0; }), "cell 5 has -1 kg/m^3"));
  BOOST_TEST(contains(why([](State& s) { s.y[2560] = -1.0; }), "particle 0 has a temperature of -1 K"));
  BOOST_TEST(contains(why([](State& s) { s.r[1] = 2.01; }), "particle 0 at (1, 2.01, 1) m is outside of the box"));
  BOOST_TEST(contains(why([](State& s) { s.r[1] = not_a_number; }), "particle 0 at (1, nan, 1) m"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::suspension_test
