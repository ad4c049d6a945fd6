#include <particulate/scattering/interface.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <boost/multiprecision/cpp_dec_float.hpp>

#include "says.hpp"

namespace tests::interface_test {

using boost::test_tools::tolerance;
using namespace particulate::scattering;
using Wide = boost::multiprecision::cpp_dec_float_50;

double cosine_of(double degrees) { return std::cos(degrees / 180.0 * std::numbers::pi); }

// Of Fresnel's formulas as they are printed, in fifty digits.
Wide printed(const Fresnel& law, double cosine) {
  const Wide n = law.n_hat, mu = law.mu_hat, c = cosine, square = n * n - 1 + c * c;
  if (square <= 0) return 1;
  const Wide s = sqrt(square), along = (n * n / mu * c - s) / (n * n / mu * c + s),
             across = (c - s / mu) / (c + s / mu);
  return (along * along + across * across) / 2;
}
Wide printed(const FluidFluid& law, double cosine) {
  const Wide c = cosine, square = 1 - Wide(law.c_hat) * law.c_hat * (1 - c * c);
  if (square <= 0) return 1;
  const Wide t = sqrt(square), r = (law.Z_hat * c - t) / (law.Z_hat * c + t);
  return r * r;
}
// In units in the last place.
double units_off(double computed, const Wide& exact) {
  const double nearest = exact.convert_to<double>();
  const double unit = std::nextafter(nearest, 2.0) - nearest;
  return Wide(abs(Wide(computed) - exact) / unit).convert_to<double>();
}

BOOST_AUTO_TEST_SUITE(reflectance_)

BOOST_AUTO_TEST_CASE(is_right_to_three_units_in_the_last_place) {
  double worst = 0.0;
  for (const double n : {1.0 - 1e-12, 1.0 + 1e-12, 1e-6, 0.5, 0.99, 1.075, 1.5, 2.0, 10.0, 1e6}) {
    for (const double mu : {1.0, 2.0, 10.0, 0.3}) {
      for (const double c : {0.0, 1e-12, 1e-3, 0.1, 0.3, 0.5, 0.7, 0.866, 0.9, 1.0 - 1e-9, 1.0 - 1e-12, 1.0}) {
        const Fresnel law{n, mu};
        worst = std::max(worst, units_off(reflectance(law, c), printed(law, c)));
      }
    }
  }
  BOOST_TEST(worst < 3.0);
  worst = 0.0;
  for (const double Z : {0.5, 2.0, 10.0, 3566.0}) {
    for (const double c_hat : {0.5, 1.0, 1.0 + 1e-12, 2.0, 4.35}) {
      for (const double c : {0.0, 1e-6, 0.1, 0.5, 0.9, 0.99, 1.0}) {
        const FluidFluid law{Z, c_hat};
        worst = std::max(worst, units_off(reflectance(law, c), printed(law, c)));
      }
    }
  }
  BOOST_TEST(worst < 3.0);
}

// Glass: 30, 60 and 85 degrees.
BOOST_AUTO_TEST_CASE(is_that_of_the_tables) {
  const Fresnel glass{1.5};
  BOOST_TEST(reflectance(glass, cosine_of(30.0)) == 0.041522625975822, tolerance(1e-13));
  BOOST_TEST(reflectance(glass, cosine_of(60.0)) == 0.089186712802213, tolerance(1e-13));
  BOOST_TEST(reflectance(glass, cosine_of(85.0)) == 0.61279964526483, tolerance(1e-13));
}

// At normal incidence ((n - mu)/(n + mu))^2, at grazing incidence all.
BOOST_AUTO_TEST_CASE(has_its_limits) {
  BOOST_TEST(reflectance(Fresnel{4.0, 2.0}, 1.0) == 1.0 / 9.0, tolerance(1e-15));
  BOOST_TEST(reflectance(Fresnel{4.0, 2.0}, 0.0) == 1.0);
  BOOST_TEST(reflectance(Fresnel{1.0}, 0.5) == 0.0);
  BOOST_TEST(reflectance(Fresnel{0.5}, 0.8) == 1.0);  // sin = 0.6 > 0.5
  BOOST_TEST(reflectance(FluidFluid{1.48e6 / 415.0, 1.0}, 1.0) == 0.998879, tolerance(1e-6));
  BOOST_TEST(reflectance(FluidFluid{2.0, 2.0}, 0.8) == 1.0);  // sin_t = 1.2
}

BOOST_AUTO_TEST_CASE(of_one_polarization_ends_at_brewsters_angle) {
  const double theta = brewster_angle(1.5);
  BOOST_TEST(theta * 180.0 / std::numbers::pi == 56.30993247, tolerance(1e-9));
  BOOST_TEST(std::abs(r_parallel({1.5}, std::cos(theta))) < 1e-16);
  BOOST_TEST(r_perpendicular({1.5}, std::cos(theta)) == -5.0 / 13.0, tolerance(1e-15));  // (1 - n^2)/(1 + n^2)
}

BOOST_AUTO_TEST_CASE(is_total_beyond_the_critical_angle) {
  const double edge = std::cos(critical_angle(0.5));
  BOOST_TEST(reflectance(Fresnel{0.5}, std::nextafter(edge, 0.0) - 1e-15) == 1.0);
  BOOST_TEST(reflectance(Fresnel{0.5}, edge + 1e-9) < 1.0);
  CHECK_REFUSED(critical_angle(1.0), "needs a ratio between 0 and 1, got 1: nothing is reflected totally");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(dip_coefficient_)

// R - R(0) over sin^4, at 0.02.
BOOST_AUTO_TEST_CASE(is_the_first_change_of_reflectance) {
  for (const Fresnel& law : {Fresnel{2.0}, Fresnel{4.0}, Fresnel{1.5, 10.0}, Fresnel{10.0, 10.0}}) {
    const double sine = 0.02, c = std::sqrt(1.0 - sine * sine);
    const double slope = (reflectance(law, c) - reflectance(law, 1.0)) / std::pow(sine, 4);
    BOOST_TEST(slope == dip_coefficient(law), tolerance(5e-3));
    BOOST_TEST((dip_coefficient(law) < 0.0) == (reflectance(law, 1.0) > 1.0 / 3.0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(sphere_reflectance_)

BOOST_AUTO_TEST_CASE(has_known_values) {
  BOOST_TEST(sphere_reflectance(Fresnel{1.075}) == 0.0197331224069517, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(Fresnel{1.5}) == 0.091777959342351, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(Fresnel{100.0}) == 0.950161171239651, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(Fresnel{10.0, 10.0}) == 0.0897307074344240, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(FluidFluid{2.0, 1.0}) == 1.0 / 9.0, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(FluidFluid{2.0, 2.0}) == 22.0 / 27.0, tolerance(1e-14));
  BOOST_TEST(planar_reflectance(Fresnel{2.0}) == 0.138036675000063139, tolerance(1e-14));
  BOOST_TEST(sphere_x_irradiance({10.0}) == -0.0198041189561911, tolerance(1e-13));
  BOOST_TEST(stepping_slope({2.0}) == 0.180184246116391, tolerance(1e-13));
}

// Digits of another quadrature, with 30 of them. They end, too: R near the edge has no digits to halve intervals for.
BOOST_AUTO_TEST_CASE(has_known_values_where_rays_are_reflected_totally) {
  BOOST_TEST(sphere_reflectance(Fresnel{0.7}) == 0.54976258564573547, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(Fresnel{0.01, 2.0}) == 0.99999743446520739, tolerance(1e-14));
  BOOST_TEST(sphere_reflectance(FluidFluid{2.0, 1.25}) == 0.49369008401649677, tolerance(1e-14));
  BOOST_TEST(planar_reflectance(Fresnel{0.7}) == 0.34066088197092578, tolerance(1e-14));
  BOOST_TEST(planar_reflectance(Fresnel{0.01, 2.0}) == 0.99977053697950235, tolerance(1e-14));
  BOOST_TEST(sphere_x_irradiance({0.7}) == 0.23882864190030921, tolerance(1e-14));
  BOOST_TEST(stepping_slope({0.01, 2.0}) == 0.53333076825213497, tolerance(1e-14));
}

// Closed form and quadrature, on either side of where one takes over.
BOOST_AUTO_TEST_CASE(is_the_same_by_both_ways) {
  for (const double n : {1.5, 2.0, 30.0, 1e3}) {
    BOOST_TEST(sphere_reflectance(Fresnel{n}) == sphere_reflectance(Fresnel{n, 1.0 + 1e-15}), tolerance(3e-14));
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(shares_)

// Water on steel at 10 and 20 degrees; critical angles 14.528 and 27.549 degrees.
BOOST_AUTO_TEST_CASE(are_those_of_water_and_steel) {
  const SolidShares at_10 = shares({}, cosine_of(10.0));
  BOOST_TEST(at_10.reflected == 0.877270038325, tolerance(1e-11));
  BOOST_TEST(at_10.longitudinal == 0.087870111164, tolerance(1e-11));
  BOOST_TEST(at_10.shear == 0.034859850511, tolerance(1e-11));
  BOOST_TEST(reflectance(FluidSolid{}, cosine_of(20.0)) == 0.84241, tolerance(1e-5));
  BOOST_TEST(critical_angle(1480.0 / 5900.0) * 180.0 / std::numbers::pi == 14.528, tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(add_up_to_one) {
  for (double degrees = 0.0; degrees <= 90.0; degrees += 0.25) {
    const SolidShares all = shares({}, cosine_of(degrees));
    BOOST_TEST(all.reflected + all.longitudinal + all.shear == 1.0, tolerance(1e-15));
    if (degrees > 14.6) BOOST_TEST(std::abs(all.longitudinal) < 1e-15);
    if (degrees > 27.6) BOOST_TEST(std::abs(all.shear) < 1e-15);
  }
}

// A solid without shear is a fluid.
BOOST_AUTO_TEST_CASE(are_those_of_a_fluid_where_nothing_shears) {
  const FluidSolid soft{.rho_s = 2000.0, .c_l = 1000.0, .c_s = 1e-3};
  const FluidFluid fluid{.Z_hat = 2000.0 * 1000.0 / (1000.0 * 1480.0), .c_hat = 1000.0 / 1480.0};
  for (const double c : {0.1, 0.5, 1.0}) BOOST_TEST(reflectance(soft, c) == reflectance(fluid, c), tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_interface) {
  CHECK_REFUSED(validate(Fresnel{0.0}), "interface: n_hat must be positive and finite, got 0");
  CHECK_REFUSED(validate(Fresnel{1.5, -1.0}), "mu_hat must be positive and finite, got -1");
  CHECK_REFUSED(validate(FluidFluid{std::numeric_limits<double>::quiet_NaN(), 1.0}), "Z_hat must be positive");
  CHECK_REFUSED(validate(FluidSolid{.c_l = 3600.0}), "c_l > c_s sqrt(4/3), got c_l = 3600 m/s and c_s = 3200 m/s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::interface_test
