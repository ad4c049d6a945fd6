#include <particulate/scattering/heat.hpp>

#include <tuple>

#include <Eigen/SparseCore>

#include <particulate/scattering/red_cell.hpp>
#include <particulate/scattering/stepped.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::heat_test {

using boost::test_tools::tolerance;
using namespace particulate;
using namespace particulate::scattering;
using Eigen::Vector2d, Eigen::Vector3d;

// 10 (theta - 300) W/m^2 go by convection, and 0.5 B (theta^4 - 300^4) by radiation.
const thermo::Cooling both{.h_c = 10.0, .emissivity = 0.5};

HeatedBodies two_bodies(const thermo::Cooling& cooling = both) {
  return {
      .capacity = Vector2d(2.0, 4.0), .surface = Vector2d(0.5, 0.25), .power = Vector2d(10.0, 0.0), .cooling = cooling};
}

BOOST_AUTO_TEST_SUITE(HeatedBodies_)

// At 400 K 1000 + 0.5 B 1.75e10 = 1496.1577616625 W/m^2 go: (10 - 0.5 * 1496.1577616625)/2 K/s of the lit body. At 300
// K nothing goes.
BOOST_AUTO_TEST_CASE(are_warmed_by_their_power_and_cooled_over_their_surface) {
  Eigen::VectorXd rate(2);
  BOOST_TEST(two_bodies().rate(0.0, Vector2d(400.0, 400.0), rate));
  BOOST_TEST(close(rate, Vector2d(-369.039440415625, -93.50986010390625), {.relative = 1e-14}));
  BOOST_TEST(two_bodies().rate(0.0, Vector2d(300.0, 300.0), rate));
  BOOST_TEST(close(rate, Vector2d(5.0, 0.0), {}));
}

BOOST_AUTO_TEST_CASE(have_no_rate_below_0_K) {
  Eigen::VectorXd rate(2);
  BOOST_TEST(two_bodies().rate(0.0, Vector2d(300.0, 0.0), rate));
  BOOST_TEST(!two_bodies().rate(0.0, Vector2d(300.0, -1e-9), rate));
  BOOST_TEST(!two_bodies().rate(0.0, Vector2d(not_a_number, 300.0), rate));
  BOOST_TEST(!two_bodies().rate(0.0, Vector2d(1e100, 300.0), rate));
}

BOOST_AUTO_TEST_CASE(have_a_jacobian_of_their_own_slopes_alone) {
  const HeatedBodies bodies = two_bodies();
  const Vector2d theta(450.0, 700.0);
  schemes::SparseJacobian J;
  bodies.sparse_jacobian(0.0, theta, J);
  Eigen::MatrixXd differences(2, 2);
  for (int j = 0; j < 2; ++j) {
    const Vector2d h = 1e-2 * Vector2d::Unit(j);
    Eigen::VectorXd above(2), below(2);
    BOOST_TEST((bodies.rate(0.0, theta + h, above) && bodies.rate(0.0, theta - h, below)));
    differences.col(j) = (above - below) / 2e-2;
  }
  BOOST_TEST(close(Eigen::MatrixXd(J), differences, {.relative = 1e-8}));
  BOOST_TEST(J.nonZeros() == 2);
  BOOST_TEST((bodies.bandwidth().lower == 0 && bodies.bandwidth().upper == 0));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_heated) {
  const auto with = [](const auto& change) {
    HeatedBodies bodies = two_bodies();
    change(bodies);
    return bodies;
  };
  BOOST_CHECK_NO_THROW(validate(two_bodies()));
  CHECK_REFUSED(validate(with([](auto& b) { b.power.resize(3); })),
                "each must have a heat capacity, a surface and a power, got 2, 2 and 3");
  CHECK_REFUSED(validate(with([](auto& b) { b.surface.resize(1); })), "got 2, 1 and 2");
  CHECK_REFUSED(validate(with([](auto& b) { b.capacity[1] = 0.0; })),
                "heat capacities, rho c times the volume, must be positive and finite, that of body 1 is 0 J/K");
  CHECK_REFUSED(validate(with([](auto& b) { b.surface[0] = -1.0; })),
                "surfaces must be positive and finite, that of body 0 is -1 m^2");
  CHECK_REFUSED(validate(with([](auto& b) { b.power[1] = -2.0; })),
                "powers must not be negative and finite, that of body 1 is -2 W");
  CHECK_REFUSED(validate(with([](auto& b) { b.power[1] = infinity; })), "that of body 1 is inf W");
  CHECK_REFUSED(validate(with([](auto& b) { b.capacity[0] = not_a_number; })), "that of body 0 is nan J/K");
  CHECK_REFUSED(validate(two_bodies({.emissivity = 1.5})), "emissivity must lie between 0 and 1, got 1.5");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(heated_bodies_)

const kinematics::Box box{.lengths = Vector3d::Constant(2e-2), .corner = Vector3d::Constant(-1e-2)};

// Ball: 4/3 pi b^3 and 4 pi b^2. Oblate, a = 4 c, e^2 = 15/16: 4/3 pi a^2 c and 2 pi a^2 (1 + (1 - e^2)/e artanh e).
// The red cell as known to 14 digits.
BOOST_AUTO_TEST_CASE(are_as_large_as_their_volumes_and_surfaces) {
  const double rho_c = 2e6;
  const auto only = [&](const auto& cloud, double volume, double surface) {
    const HeatedBodies bodies = heated_bodies(cloud, rho_c, both);
    BOOST_TEST(bodies.capacity[0] == rho_c * volume, tolerance(1e-12));
    BOOST_TEST(bodies.surface[0] == surface, tolerance(1e-12));
    BOOST_TEST(bodies.power[0] == 0.0);
    BOOST_TEST(bodies.cooling.h_c == 10.0);
  };
  only(Cloud<Sphere>({{.radius = 1e-3}}, box), 4.0 / 3.0 * pi * 1e-9, 4.0 * pi * 1e-6);
  only(Cloud<Spheroid>({{.equatorial = 2e-3, .polar = 5e-4}}, box), 8.377580409572782e-09, 2.8480278854014385e-05);
  only(Cloud<RedCell>({RedCell{}}, box), 94.0910641006e-18, 134.0896866817e-12);
}

BOOST_AUTO_TEST_CASE(refuse_a_heat_capacity_that_is_none) {
  const Cloud<Sphere> cloud({{.radius = 1e-3}}, box);
  CHECK_REFUSED(heated_bodies(cloud, 0.0), "rho c times the volume, must be positive and finite, that of body 0 is 0");
  CHECK_REFUSED(heated_bodies(cloud, not_a_number), "that of body 0 is nan J/K");
  CHECK_REFUSED(heated_bodies(cloud, 2e6, {.h_c = -1.0}), "h_c must be finite and not negative, got -1");
  BOOST_TEST(heated_bodies(Cloud<Sphere>({}, box), 2e6).capacity.size() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(start_)

BOOST_AUTO_TEST_CASE(has_one_temperature_for_all) {
  const schemes::State state = start(two_bodies(), 310.0);
  BOOST_TEST((state.t == 0.0 && state.r.size() == 0));
  BOOST_TEST(close(state.y, Vector2d(310.0, 310.0), {}));
  CHECK_REFUSED(start(two_bodies(), 0.0), "temperature at the start must be positive and finite, got 0 K");
  CHECK_REFUSED(start(two_bodies(), not_a_number), "got nan K");
  CHECK_REFUSED(start(two_bodies({.h_c = not_a_number}), 300.0), "h_c must be finite");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(equilibrium_temperatures_)

// 0.5 B (400^4 - 300^4) = 496.1577616625 W/m^2 over 0.5 m^2; of the body in the dark the temperature of its
// surroundings.
BOOST_AUTO_TEST_CASE(are_where_each_gives_away_what_it_absorbs) {
  HeatedBodies bodies = two_bodies({.emissivity = 0.5});
  bodies.power[0] = 0.5 * 496.1577616625;
  BOOST_TEST(close(equilibrium_temperatures(bodies), Vector2d(400.0, 300.0), {.relative = 1e-13}));
  bodies.cooling = {.h_c = 10.0, .theta_o = 290.0};
  bodies.power[0] = 25.0;
  BOOST_TEST(close(equilibrium_temperatures(bodies), Vector2d(295.0, 290.0), {.relative = 1e-15}));
  CHECK_REFUSED(equilibrium_temperatures(two_bodies({})), "give h_c or emissivity");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(warmed_by_)

BOOST_AUTO_TEST_CASE(adds_energy_over_heat_capacity) {
  const HeatedBodies bodies = two_bodies();
  const Vector2d theta(300.0, 310.0);
  BOOST_TEST(close(warmed_by(bodies, theta, Vector2d(5.0, 2.0)), Vector2d(302.5, 310.5), {}));
  BOOST_TEST(close(warmed_by(bodies, theta, Vector2d::Zero()), theta, {}));
  CHECK_REFUSED(warmed_by(bodies, theta, Vector3d::Zero()),
                "each of 2 must have a temperature and an energy, got 2 and 3");
  CHECK_REFUSED(warmed_by(bodies, Vector3d::Zero(), theta), "got 3 and 2");
  CHECK_REFUSED(warmed_by(bodies, theta, Vector2d(not_a_number, 0.0)), "body 0 has 300 K and gets nan J");
  CHECK_REFUSED(warmed_by(bodies, Vector2d(infinity, 0.0), theta), "body 0 has inf K");
  CHECK_REFUSED(warmed_by(bodies, theta, Vector2d(0.0, -1.0)), "energies not negative, body 1 has 310 K and gets -1 J");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(heat_jumps_)

void is(const HeatJump& jump, double length, std::int32_t body, double energy) {
  BOOST_TEST(jump.t == length / 299792458.0, tolerance(1e-14));
  BOOST_TEST(jump.body == body);
  BOOST_TEST(jump.energy == energy, tolerance(1e-13));
}

// What a ray carries before and after; a start and an end warm nothing.
BOOST_AUTO_TEST_CASE(come_in_the_order_of_their_times_then_of_their_bodies) {
  const auto point = [](std::int32_t ray, double length, double power, std::int32_t body) {
    return PathPoint{.ray = ray, .place = Vector3d::Zero(), .length = length, .power = power, .body = body};
  };
  const std::vector<HeatJump> jumps =
      heat_jumps({point(0, 0.0, 5.0, -1), point(0, 3.0, 2.0, 4), point(0, 9.0, 2.0, -1),  //
                  point(1, 0.0, 7.0, -1), point(1, 1.0, 6.0, 7), point(1, 3.0, 1.0, 2), point(1, 8.0, 1.0, -1)});
  BOOST_TEST_REQUIRE(jumps.size() == 3);
  is(jumps[0], 1.0, 7, 1.0);
  is(jumps[1], 3.0, 2, 5.0);
  is(jumps[2], 3.0, 4, 3.0);
  BOOST_TEST(heat_jumps({}).empty());
}

// A ray of 2 J to and fro between two balls, of which each takes 8/9 of it, is cut off at the second hit: after 0.31
// and 0.4 m more. In steps of 0.05 m it lies inside of them after 0.35 and 0.45 m more.
BOOST_AUTO_TEST_CASE(hold_the_hit_at_which_a_ray_is_cut_off) {
  const Cloud<Sphere> cloud({{{0.2, 0.5, 0.5}, 0.1}, {{0.8, 0.5, 0.5}, 0.1}}, {});
  const Rays ray{.place = Vector3d(0.39, 0.5, 0.5).transpose(),
                 .direction = Vector3d::UnitX().transpose(),
                 .power = Eigen::VectorXd::Constant(1, 2.0)};
  const TraceSettings settings{.most_hits = 1, .keeps_paths = true};
  const Traced exact = trace(cloud, Fresnel{2.0}, ray, settings);
  const Traced stepped = trace_in_steps(cloud, Fresnel{2.0}, ray, {.xi = 0.5, .bounds = settings});
  for (const auto& [traced, first, second] : {std::tuple{&exact, 0.31, 0.71}, {&stepped, 0.35, 0.8}}) {
    const std::vector<HeatJump> jumps = heat_jumps(traced->paths);
    BOOST_TEST_REQUIRE(jumps.size() == 2);
    is(jumps[0], first, 1, 16.0 / 9.0);
    is(jumps[1], second, 0, 16.0 / 81.0);
    BOOST_TEST(traced->ledger.cut_off == 2.0 / 81.0, tolerance(1e-13));
    BOOST_TEST(close(traced->absorbed, Vector2d(jumps[1].energy, jumps[0].energy), {.relative = 1e-13}));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::heat_test
