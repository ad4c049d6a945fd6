// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions.

#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  double (*strength)(const PairLaw&, double) = right::strength;
  double (*potential)(const PairLaw&, double, double) = right::potential;
  double (*equilibrium_distance)(const PairLaw&) = right::equilibrium_distance;
  double (*stiffness)(const PairLaw&) = right::stiffness;
  double (*period)(const PairLaw&, double, double) = right::period;
};

double upside_down(const PairLaw& law) { return std::pow(law.alpha1 / law.alpha2, 1.0 / (law.beta2 - law.beta1)); }

// What the first variant's formulas take for the second variant's law.
PairLaw second(const PairLaw& law) {
  return {.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = -law.beta1, .beta2 = law.beta2};
}

const std::vector<Mistake<Functions>> mistakes{
    // The repulsion is added.
    // graded: --variant 1 --student anna|bob@school.edu -> 15
    // hint: repulsion is subtracted from attraction
    // never: sign of the whole: attraction
    {"sign_of_repulsion", &Functions::strength,
     [](const PairLaw& law, double d) {
       return law.alpha1 * std::pow(d, -law.beta1) + law.alpha2 * std::pow(d, -law.beta2);
     }},

    // Each strength has the other exponent.
    // graded: --variant 1 --student anna|bob@school.edu -> 15
    // hint: swapped exponents
    {"swapped_exponents", &Functions::strength,
     [](const PairLaw& law, double d) {
       return law.alpha1 * std::pow(d, -law.beta2) - law.alpha2 * std::pow(d, -law.beta1);
     }},

    // A small number keeps the distance from zero.
    // graded: --variant 1 --student anna|bob@school.edu -> 19
    // hint: add no small number to d
    {"softened", &Functions::strength, [](const PairLaw& law, double d) { return right::strength(law, d + 1e-13); }},

    // The law of the first variant, where the second is asked.
    // graded: --variant 2 --student anna|bob@school.edu -> 3
    // hint: the law of the other variant
    {"other_variant"},

    // The potential falls where the force attracts.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: V' = C
    // hint: sign of the whole
    // hint: so that energy is conserved
    {"sign_of_potential", &Functions::potential,
     [](const PairLaw& law, double d, double d_ref) { return -right::potential(law, d, d_ref); }},

    // The potential is zero at infinity, not at d_ref.
    // graded: --variant 1 --student anna|bob@school.edu -> 13
    // hint: V is measured from d_ref
    {"no_reference", &Functions::potential,
     [](const PairLaw& law, double d, double) {
       const auto term = [&](double alpha, double beta) { return alpha * std::pow(d, 1.0 - beta) / (1.0 - beta); };
       return term(law.alpha1, law.beta1) - term(law.alpha2, law.beta2);
     }},

    // Integrated powers keep their exponent.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: integrating a power raises it by one
    {"exponent", &Functions::potential,
     [](const PairLaw& law, double d, double d_ref) {
       const auto at = [&](double x) {
         return law.alpha1 * std::pow(x, -law.beta1) / (1.0 - law.beta1) -
                law.alpha2 * std::pow(x, -law.beta2) / (1.0 - law.beta2);
       };
       return at(d) - at(d_ref);
     }},

    // Nothing is done about 1 - beta = 0, and 0/0 is not a number.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: the integral of 1/d is a logarithm
    {"no_logarithm", &Functions::potential,
     [](const PairLaw& law, double d, double d_ref) {
       const auto term = [&](double alpha, double beta) {
         return alpha * (std::pow(d, 1.0 - beta) - std::pow(d_ref, 1.0 - beta)) / (1.0 - beta);
       };
       return term(law.alpha1, law.beta1) - term(law.alpha2, law.beta2);
     }},

    // The logarithm stands at beta = 1 alone; close to it the difference of powers cancels.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: close to beta = 1 a difference of powers cancels
    {"cancellation", &Functions::potential,
     [](const PairLaw& law, double d, double d_ref) {
       const auto term = [&](double alpha, double beta) {
         if (beta == 1.0) return alpha * std::log(d / d_ref);
         return alpha * (std::pow(d, 1.0 - beta) - std::pow(d_ref, 1.0 - beta)) / (1.0 - beta);
       };
       return term(law.alpha1, law.beta1) - term(law.alpha2, law.beta2);
     }},

    // Attraction is integrated as if its exponent were 1, which is right in one question of the limit case.
    // graded: --variant 1 --student anna|bob@school.edu -> 11
    // hint: energy is not conserved
    {"not_conservative", &Functions::potential,
     [](const PairLaw& law, double d, double d_ref) {
       return right::term(law.alpha1, 1.0, d, d_ref) - right::term(law.alpha2, law.beta2, d, d_ref);
     }},

    // The strengths are swapped in the equilibrium.
    // graded: --variant 1 --student anna|bob@school.edu -> 18
    // hint: more repulsion
    {"upside_down", &Functions::equilibrium_distance, upside_down, &Functions::stiffness,
     [](const PairLaw& law) { return right::stiffness_at(law, right::equilibrium_distance(law)); }},

    // The strengths are swapped in the equilibrium, and stiffness and period are taken there.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: d_e is upside down
    // never: term by term
    {"upside_down_throughout", &Functions::equilibrium_distance, upside_down},

    // The exponent of the repulsion does not become a factor of its slope.
    // graded: --variant 1 --student anna|bob@school.edu -> 14
    // hint: the factor beta2 is missing in V
    // never: forty orders
    // never: sign: at a stable equilibrium
    // never: term by term
    {"missing_exponent", &Functions::stiffness,
     [](const PairLaw& law) {
       const double d_e = equilibrium_distance(law);
       return law.alpha2 * std::pow(d_e, -law.beta2 - 1.0) - law.alpha1 * law.beta1 * std::pow(d_e, -law.beta1 - 1.0);
     }},

    // In the second variant's law, the exponent of the attraction does not become a factor of its slope.
    // graded: --variant 2 --student anna|bob@school.edu|1234567 -> 17
    // hint: the factor beta1 is missing in V
    // never: forty orders
    // never: sign: at a stable equilibrium
    // never: term by term
    {"missing_exponent_second", &Functions::strength,
     [](const PairLaw& law, double d) { return right::strength(second(law), d); }, &Functions::potential,
     [](const PairLaw& law, double d, double d_ref) { return right::potential(second(law), d, d_ref); },
     &Functions::equilibrium_distance, [](const PairLaw& law) { return right::equilibrium_distance(second(law)); },
     &Functions::stiffness,
     [](const PairLaw& law) {
       const double d_e = equilibrium_distance(law);
       return law.alpha1 * std::pow(d_e, law.beta1 - 1.0) + law.alpha2 * law.beta2 * std::pow(d_e, -law.beta2 - 1.0);
     }},

    // One body oscillates, the other is thought to be fixed.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: take the reduced mass
    {"one_mass", &Functions::period,
     [](const PairLaw& law, double m_i, double) { return 2.0 * std::numbers::pi * std::sqrt(m_i / stiffness(law)); }},

    // A reduced mass with a factor 1/2 that is right nowhere.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: factor sqrt 2
    {"half_the_mass", &Functions::period,
     [](const PairLaw& law, double m_i, double m_j) { return std::sqrt(0.5) * right::period(law, m_i, m_j); }},

    // pi has six digits.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: pi has more digits
    {"six_digits", &Functions::period,
     [](const PairLaw& law, double m_i, double m_j) {
       return right::period(law, m_i, m_j) / std::numbers::pi * 3.14159;
     }},

    // The angular frequency is inverted and 2 pi forgotten.
    // graded: --variant 1 --student anna|bob@school.edu -> 17
    // hint: factor 2 pi
    {"angular_frequency", &Functions::period,
     [](const PairLaw& law, double m_i, double m_j) {
       return right::period(law, m_i, m_j) / (2.0 * std::numbers::pi);
     }},
};

const Functions handed_in = made(mistakes);

}  // namespace

double strength(const PairLaw& law, double d) { return handed_in.strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return handed_in.potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return handed_in.equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return handed_in.stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return handed_in.period(law, m_i, m_j); }
