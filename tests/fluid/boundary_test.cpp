#include <particulate/fluid/boundary.hpp>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::boundary_test {

using namespace particulate::fluid;

// Periodic but for the faces of y.
void check(const Boundary<2>& low, const Boundary<2>& high, bool has_heat = true) {
  validate(Boundaries<2>{Periodic{}, Periodic{}, low, high}, has_heat);
}
const Given<2> at_rest{[](double, const Vector<2>&) { return Local<2>{}; }};
Wall<2> warm(double theta) { return {.theta = theta}; }
Wall<2> moving(double vx, double vy) { return {.velocity = {vx, vy}}; }

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_what_belongs_together) {
  BOOST_CHECK_NO_THROW(check(Periodic{}, Periodic{}));
  BOOST_CHECK_NO_THROW(check(moving(-2.0, 0.0), warm(300.0)));
  BOOST_CHECK_NO_THROW(check(at_rest, Outflow{.P = -1.0}, false));
  BOOST_CHECK_NO_THROW(check(Wall<2>{.slips = true}, Wall<2>{}, false));
}

BOOST_AUTO_TEST_CASE(refuses_a_periodic_face_opposite_to_another_kind) {
  CHECK_REFUSED(check(Periodic{}, Wall<2>{}), "boundary y low: it must be periodic if y high is, and only then");
  CHECK_REFUSED(check(Outflow{}, Periodic{}), "boundary y low: it must be periodic if y high is, and only then");
  CHECK_REFUSED(validate(Boundaries<3>{Periodic{}, Periodic{}, Periodic{}, Periodic{}, Wall<3>{}, Periodic{}}, true),
                "boundary z low: it must be periodic if z high is");
}

BOOST_AUTO_TEST_CASE(refuses_a_wall_that_moves_across_itself_or_nowhere) {
  CHECK_REFUSED(check(Wall<2>{}, moving(1.0, 0.75)),
                "boundary y high: a wall must move along itself, finitely fast, got 1.25 m/s of which 0.75 across it");
  CHECK_REFUSED(check(moving(0.0, not_a_number), Wall<2>{}), "got nan m/s of which nan across it");
  CHECK_REFUSED(check(moving(infinity, 0.0), Wall<2>{}),
                "boundary y low: a wall must move along itself, finitely fast, got inf m/s of which 0 across it");
}

BOOST_AUTO_TEST_CASE(refuses_temperatures_of_walls_that_are_none) {
  CHECK_REFUSED(check(warm(0.0), Wall<2>{}),
                "boundary y low: the temperature of a wall must be positive and finite, got 0 K");
  CHECK_REFUSED(check(warm(-1.0), Wall<2>{}), "must be positive and finite, got -1 K");
  CHECK_REFUSED(check(Wall<2>{}, warm(infinity)), "boundary y high: the temperature of a wall must be");
  CHECK_REFUSED(check(Wall<2>{}, warm(not_a_number)), "must be positive and finite, got nan K");
}

BOOST_AUTO_TEST_CASE(refuses_the_temperature_of_a_wall_of_a_fluid_that_has_none) {
  CHECK_REFUSED(check(Wall<2>{}, warm(300.0), false),
                "boundary y high: a barotropic fluid has no temperature: give the wall none");
}

BOOST_AUTO_TEST_CASE(refuses_a_fluid_that_is_not_given) {
  CHECK_REFUSED(check(Given<2>{}, Outflow{}), "boundary y low: the fluid must be given");
}

BOOST_AUTO_TEST_CASE(refuses_a_pressure_that_is_none) {
  CHECK_REFUSED(check(at_rest, Outflow{.P = not_a_number}), "boundary y high: the pressure must be finite, got nan Pa");
  CHECK_REFUSED(check(at_rest, Outflow{.P = infinity}), "the pressure must be finite, got inf Pa");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::boundary_test
