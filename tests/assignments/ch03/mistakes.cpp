// Typical mistakes, one program: the environment's MISTAKE names the one that is made. Before each stands what it must
// get, as in the first lines of other submissions.

#include <vector>

#include "../mistakes.hpp"
#include "right.hpp"

namespace {

using Fields = std::vector<Sweeps>;
using right::Two;

constexpr double infinity = std::numeric_limits<double>::infinity();

// What is handed in: right, where a mistake does not say otherwise.
struct Functions {
  double (*step_factor)(const Sweeps&, int) = right::step_factor;
  Decision (*next_step)(double, const Fields&, const Settings&) = right::next_step;
  State (*gauss2_step)(const Acceleration&, const State&, double, int) = right::gauss2_step;
};

// The factor where there is no need to guard it.
double unguarded(const Sweeps& of, int K_d) {
  return std::pow(of.TOL / of.w_0, 1.0 / (of.p * K_d)) / std::pow(of.w_K / of.w_0, 1.0 / (of.p * of.K));
}

const std::vector<Mistake<Functions>> mistakes{
    // The exponent p of the step is forgotten.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 13
    // hint: p is forgotten
    {"forgotten_p", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       Sweeps other = sweeps;
       other.p = 1;
       return right::step_factor(other, K_d);
     }},

    // The exponents are quotients of whole numbers, which are 0.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 13
    // hint: 1/(p K) of whole numbers is 0
    {"whole_numbers", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       if (sweeps.w_K == 0.0 || sweeps.K == 0) return infinity;
       const int wanted = 1 / (sweeps.p * K_d), seen = 1 / (sweeps.p * sweeps.K);
       return std::pow(sweeps.TOL / sweeps.w_0, wanted) / std::pow(sweeps.w_K / sweeps.w_0, seen);
     }},

    // K_d and K are swapped.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 13
    // hint: K_d and K are swapped
    {"swapped_contractions", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       if (sweeps.w_K == 0.0 || sweeps.K == 0) return infinity;
       Sweeps other = sweeps;
       other.K = K_d;
       return right::step_factor(other, sweeps.K);
     }},

    // Sweeps are counted, one more than contractions.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 13
    // hint: K counts contractions, not sweeps
    {"counts_sweeps", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       Sweeps other = sweeps;
       if (sweeps.K > 0) ++other.K;
       return right::step_factor(other, K_d);
     }},

    // The factor is upside down.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 13
    // hint: the ratio is inverted
    {"upside_down", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       const double factor = right::step_factor(sweeps, K_d);
       return factor == infinity ? infinity : 1.0 / factor;
     }},

    // TOL is compared with the last change, not with the first.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 13
    // hint: TOL is compared with w_0
    {"last_change", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       if (sweeps.w_K == 0.0 || sweeps.K == 0) return infinity;
       const double wanted = std::pow(sweeps.TOL / sweeps.w_K, 1.0 / (sweeps.p * K_d));
       return wanted / std::pow(sweeps.w_K / sweeps.w_0, 1.0 / (sweeps.p * sweeps.K));
     }},

    // A small number keeps the quotients from 0/0.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 15
    // hint: no small number belongs into a quotient
    {"softened", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) {
       Sweeps other = sweeps;
       other.w_0 += 1e-12;
       other.w_K += 1e-12;
       return unguarded(other, K_d);
     }},

    // Nothing is done about a last change of zero.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 18
    // hint: guard 0/0
    {"no_guard", &Functions::step_factor, unguarded},

    // K = 0 is looked for, but not w_K = 0, which is 0/0 where nothing moves.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 18
    // hint: guard 0/0 and 1/0
    {"at_rest", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) { return sweeps.K == 0 ? infinity : unguarded(sweeps, K_d); }},

    // Nothing is done about K = 0, where any number to the power of 1/0 comes out.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 18
    // hint: guard 0/0 and 1/0
    {"single_sweep", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) { return sweeps.w_K == 0.0 ? infinity : unguarded(sweeps, K_d); }},

    // A last change below a small number counts as none.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 18
    // hint: a small w_K is a number like any other
    // never: no small number
    {"small_is_zero", &Functions::step_factor,
     [](const Sweeps& sweeps, int K_d) { return sweeps.w_K < 1e-12 ? infinity : right::step_factor(sweeps, K_d); }},

    // A step that meets TOL exactly is refused.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 17
    // hint: a step that meets TOL exactly stands
    {"strictly_below", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       const bool accepted =
           std::all_of(fields.begin(), fields.end(), [](const Sweeps& field) { return field.w_K < field.TOL; });
       return right::decision(dt, accepted, right::phi(fields, settings), settings);
     }},

    // A step is refused only if a change is larger than TOL, which NaN never is.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 18
    // hint: NaN fails every comparison
    {"accepts_no_number", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       const bool refused =
           std::any_of(fields.begin(), fields.end(), [](const Sweeps& field) { return field.w_K > field.TOL; });
       return right::decision(dt, !refused, right::phi(fields, settings), settings);
     }},

    // A field whose last change is no number is refused, but its factor is passed by.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 18
    // hint: a field whose w_K is NaN or infinite counts with Phi_K = 0
    // never: not the largest
    {"passes_no_number", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       double phi = infinity;
       for (const Sweeps& field : fields) phi = std::min(phi, step_factor(field, settings.K_d));
       return right::decision(dt, right::is_accepted(fields), phi, settings);
     }},

    // The next step is the factor itself.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 10
    // hint: dt is forgotten
    {"forgotten_dt", &Functions::next_step,
     [](double, const Fields& fields, const Settings& settings) { return right::next_step(1.0, fields, settings); }},

    // The limit of the step is forgotten.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 17
    // hint: cap forgotten: no step is larger than limit
    {"no_cap", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       Settings other = settings;
       other.limit = infinity;
       return right::next_step(dt, fields, other);
     }},

    // An accepted step may be followed by a smaller one.
    // graded: --variant 1|2 --student anna|bob@school.edu -> 17
    // hint: after an accepted step the next is not smaller
    {"no_floor", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       Decision decision = right::next_step(dt, fields, settings);
       if (decision.accepted) decision.next = std::min(decision.next, right::phi(fields, settings) * dt);
       return decision;
     }},

    // The first field alone is looked at.
    // graded: --variant 2 --student anna|bob@school.edu -> 10
    // hint: every field counts, not the first alone
    {"first_field", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       return right::next_step(dt, {fields.front()}, settings);
     }},

    // The first field's tolerance is taken for all.
    // graded: --variant 2 --student anna|bob@school.edu -> 12
    // hint: each field has a tolerance of its own
    {"common_tolerance", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       Fields alike = fields;
       for (Sweeps& field : alike) field.TOL = fields.front().TOL;
       return right::next_step(dt, alike, settings);
     }},

    // The largest factor rules.
    // graded: --variant 2 --student anna|bob@school.edu -> 13
    // hint: the smallest Phi_K of all fields rules, not the largest
    {"largest_factor", &Functions::next_step,
     [](double dt, const Fields& fields, const Settings& settings) {
       double largest = 0.0;
       for (const Sweeps& field : fields) {
         if (std::isfinite(field.w_K)) largest = std::max(largest, step_factor(field, settings.K_d));
       }
       return right::decision(dt, right::is_accepted(fields), largest, settings);
     }},

    // A is taken where A A belongs.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: A_bar = A A, not A
    {"gauss_whole_matrix", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       const double root = std::sqrt(3.0);
       Two stages{};
       for (int k = 0; k < sweeps; ++k) {
         const Two last = stages;
         stages = {a(from.r + (0.5 - root / 6) * dt * from.v + dt * dt * (last[0] / 4 + (0.25 - root / 6) * last[1])),
                   a(from.r + (0.5 + root / 6) * dt * from.v + dt * dt * ((0.25 + root / 6) * last[0] + last[1] / 4))};
       }
       return right::gauss2_end(from, dt, stages);
     }},

    // Rows and columns of A_bar are swapped.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: rows and columns are swapped
    {"gauss_transposed", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       const double root = std::sqrt(3.0);
       Two stages{};
       for (int k = 0; k < sweeps; ++k) {
         const Two last = stages;
         stages = {
             a(from.r + (0.5 - root / 6) * dt * from.v + dt * dt * (last[0] / 24 + (0.125 + root / 12) * last[1])),
             a(from.r + (0.5 + root / 6) * dt * from.v + dt * dt * ((0.125 - root / 12) * last[0] + last[1] / 24))};
       }
       return right::gauss2_end(from, dt, stages);
     }},

    // The nodes and weights of the trapezoidal rule.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: the trapezoidal rule
    {"gauss_trapezoidal", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       double end = 0.0, start = 0.0;
       for (int k = 0; k < sweeps; ++k) {
         const double place = from.r + dt * from.v + 0.25 * dt * dt * (start + end);
         start = a(from.r);
         end = a(place);
       }
       return State{.r = from.r + dt * from.v + 0.25 * dt * dt * (start + end), .v = from.v + 0.5 * dt * (start + end)};
     }},

    // b_bar is the wrong way round.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: b_bar_i = b_i (1 - c_i)
    {"gauss_swapped_weights", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       const Two stages = right::swept(a, from, dt, sweeps);
       return right::gauss2_end(from, dt, {stages[1], stages[0]});
     }},

    // The position ends with half the mean acceleration.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: not with dt^2/2 times the mean acceleration
    {"gauss_mean_acceleration", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       const Two stages = right::swept(a, from, dt, sweeps);
       const double mean = 0.5 * (stages[0] + stages[1]);
       return State{.r = from.r + dt * from.v + 0.5 * dt * dt * mean, .v = from.v + dt * mean};
     }},

    // The stages do not drift.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: the stages drift
    {"gauss_no_drift", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       return right::gauss2_end(from, dt, right::swept(a, {.r = from.r, .v = 0.0}, dt, sweeps));
     }},

    // The first guess is the acceleration at the start.
    // graded: --variant 1 --student anna -> 18
    // graded: --variant 2 --student bob@school.edu -> 18
    // hint: a_1 = a_2 = 0
    {"gauss_other_guess", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       return right::gauss2_end(from, dt, right::swept(a, from, dt, sweeps, {a(from.r), a(from.r)}));
     }},

    // The second stage uses the new rate of the first.
    // graded: --variant 1 --student anna -> 18
    // graded: --variant 2 --student bob@school.edu -> 18
    // hint: all at once
    {"gauss_in_turn", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       Two stages{};
       for (int k = 0; k < sweeps; ++k) {
         stages[0] = right::sweep(a, from, dt, stages)[0];
         stages[1] = right::sweep(a, from, dt, stages)[1];
       }
       return right::gauss2_end(from, dt, stages);
     }},

    // The root has four digits.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: sqrt(3) has more digits
    {"gauss_four_digits", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       const double root = 1.732;
       return right::gauss2_end(from, dt, right::swept(a, from, dt, sweeps, {}, root), root);
     }},

    // One sweep only.
    // graded: --variant 1 --student anna -> 15
    // graded: --variant 2 --student bob@school.edu -> 15
    // hint: one sweep is not enough
    {"gauss_one_sweep", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int) { return right::gauss2_step(a, from, dt, 1); }},

    // A sweep too many.
    // graded: --variant 1 --student anna -> 18
    // graded: --variant 2 --student bob@school.edu -> 18
    // hint: a sweep too many
    {"gauss_one_more_sweep", &Functions::gauss2_step,
     [](const Acceleration& a, const State& from, double dt, int sweeps) {
       return right::gauss2_step(a, from, dt, sweeps + 1);
     }},
};

const Functions handed_in = made(mistakes);

}  // namespace

double step_factor(const Sweeps& sweeps, int K_d) { return handed_in.step_factor(sweeps, K_d); }

Decision next_step(double dt, const Fields& fields, const Settings& settings) {
  return handed_in.next_step(dt, fields, settings);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return handed_in.gauss2_step(a, from, dt, sweeps);
}
