// Reflectance where permeabilities differ or dip, and of sound: closed forms and numbers of the textbooks.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <harness/case.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scattering/interface.hpp>

namespace verification::dips_and_sound {

using namespace particulate::scattering;

constexpr double degree = std::numbers::pi / 180.0;

const Case dips{
    {.name = "reflectance_dips",
     .claim = "R falls away from normal incidence if and only if R(0) > 1/3",
     .equation = "D B.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      long wrong = 0, looked_at = 0;
      for (const double mu : {0.1, 0.5, 1.0, 2.0, 10.0}) {
        for (double n = 0.05 * mu; n < 30.0 * mu; n *= 1.07) {
          const Fresnel law{n, mu};
          if (n <= 0.2 || std::abs(n - 1.0) < 0.01 || std::abs(reflectance(law, 1.0) - 1.0 / 3.0) < 1e-3) continue;
          ++looked_at;
          const double c = std::sqrt(1.0 - 1e-4);
          const bool falls = reflectance(law, c) < reflectance(law, 1.0);
          wrong += falls != (reflectance(law, 1.0) > 1.0 / 3.0) ? 1 : 0;
          wrong += falls != (dip_coefficient(law) < 0.0) ? 1 : 0;
        }
      }
      rows.none("pairs of n^ and mu^ for which it does not", wrong, "an equivalence");
      rows.at_least("pairs looked at",
                    {.limit = 300.0, .computed = static_cast<double>(looked_at), .because = "else it says little"});
      rows.compare("R at 57.5 degrees, n^ = 4", {.expected = 0.357778,
                                                 .computed = reflectance(Fresnel{4.0}, std::cos(57.5 * degree)),
                                                 .tolerance = absolute(5e-7),
                                                 .because = "six digits were given"});
    }};

const Case solid{
    {.name = "sound_against_a_solid",
     .claim = "what a steel wall reflects and takes of sound in water is known, and adds up to all",
     .equation = "D B.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const FluidSolid steel;
      const auto row = [&](const std::string& what, double expected, double computed, double off) {
        rows.compare(what, {.expected = expected,
                            .computed = computed,
                            .tolerance = absolute(off),
                            .because = "digits that were given"});
      };
      const SolidShares at_10 = shares(steel, std::cos(10.0 * degree));
      row("reflected at 10 degrees", 0.877270038325, at_10.reflected, 5e-13);
      row("longitudinal", 0.087870111164, at_10.longitudinal, 5e-13);
      row("shear", 0.034859850511, at_10.shear, 5e-13);
      row("reflected at 20 degrees", 0.84241, reflectance(steel, std::cos(20.0 * degree)), 5e-6);
      row("first critical angle [degrees]", 14.528, critical_angle(steel.c_f / steel.c_l) / degree, 5e-4);
      row("second [degrees]", 27.549, critical_angle(steel.c_f / steel.c_s) / degree, 5e-4);
      row("air to water at normal incidence", 0.998879, reflectance(FluidFluid{1.48e6 / 415.0, 1.0}, 1.0), 5e-7);
      double off = 0.0;
      for (int k = 0; k <= 9000; ++k) {
        const SolidShares all = shares(steel, std::cos(0.01 * k * degree));
        off = particulate::report::worse_of(off, std::abs(all.reflected + all.longitudinal + all.shear - 1.0));
      }
      rows.compare("largest error of the sum, over angles",
                   {.expected = 0.0, .computed = off, .tolerance = absolute(4e-16), .because = "each is rounded once"});
    }};

}  // namespace verification::dips_and_sound
