#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>

/// @file
/// The reference methods and their settings. Tolerances bound the local error of a step, component by component:
/// \f$ |e_k| \lesssim \text{relative}\,|y_k| + \text{absolute} \f$ in the root mean square over the components. The
/// error at the end is larger, 1e3 to 1e4 times the tolerance over ten orbits of a Kepler problem.

namespace particulate::reference {

/// The explicit Runge-Kutta methods of ARKODE. A name ends in stages, order of the embedded method, order.
///
/// Sources: the ARKODE manual, where each table stands with its literature. The tables of additive methods (ark...) are
/// their explicit halves.
enum class Table {
  heun_euler_2_1_2,        ///< Heun-Euler
  bogacki_shampine_4_2_3,  ///< Bogacki-Shampine
  ark324l2sa_erk_4_2_3,    ///< ARK3(2)4L[2]SA
  zonneveld_5_3_4,         ///< Zonneveld
  ark436l2sa_erk_6_3_4,    ///< ARK4(3)6L[2]SA
  sayfy_aburub_6_3_4,      ///< Sayfy-Aburub
  cash_karp_6_4_5,         ///< Cash-Karp
  fehlberg_6_4_5,          ///< Fehlberg
  dormand_prince_7_4_5,    ///< Dormand-Prince
  ark548l2sa_erk_8_4_5,    ///< ARK5(4)8L[2]SA
  verner_8_5_6,            ///< Verner
  fehlberg_13_7_8,         ///< Fehlberg
  knoth_wolke_3_3,         ///< Knoth-Wolke, without an embedded method: for fixed steps only
  ark437l2sa_erk_7_3_4,    ///< ARK4(3)7L[2]SA
  ark548l2sab_erk_8_4_5    ///< ARK5(4)8L[2]SA, second version
};

/// Every table, in the order of its enumeration.
inline constexpr std::array tables{
    Table::heun_euler_2_1_2,     Table::bogacki_shampine_4_2_3, Table::ark324l2sa_erk_4_2_3, Table::zonneveld_5_3_4,
    Table::ark436l2sa_erk_6_3_4, Table::sayfy_aburub_6_3_4,     Table::cash_karp_6_4_5,      Table::fehlberg_6_4_5,
    Table::dormand_prince_7_4_5, Table::ark548l2sa_erk_8_4_5,   Table::verner_8_5_6,         Table::fehlberg_13_7_8,
    Table::knoth_wolke_3_3,      Table::ark437l2sa_erk_7_3_4,   Table::ark548l2sab_erk_8_4_5};

/// Name of a table, spelled as its enumerator.
///
/// @param table  a table
/// @return its name, such as "verner_8_5_6"
/// @throws std::invalid_argument for a value that is no enumerator
std::string_view name(Table table);

/// The table of that name.
///
/// @param name  spelled as the enumerator
/// @return the table
/// @throws std::invalid_argument for an unknown name, listing the known ones
Table table_named(std::string_view name);

/// Order of the solution that a table advances.
///
/// @param table  a table
/// @return order of its global error [-]
/// @throws std::invalid_argument for a value that is no enumerator
int order(Table table);

/// Order of the embedded method, which estimates the error of a step.
///
/// @param table  a table
/// @return its order, 0 where there is none [-]
/// @throws std::invalid_argument for a value that is no enumerator
int embedded_order(Table table);

/// Adams-Moulton methods of variable order and step with a functional corrector: CVODE, for problems that are not
/// stiff.
///
/// The corrector is a fixed point of at most three sweeps a step. Where it does not contract the step shrinks.
struct Adams {
  double relative = 1e-10;                  ///< relative tolerance, in [1e-16, 1) [-]
  double absolute = 1e-12;                  ///< absolute tolerance, > 0, in the units of every unknown
  int max_order = 12;                       ///< highest order used, 1 to 12 [-]
  int anderson = 0;                         ///< earlier sweeps that Anderson acceleration mixes in, >= 0; 0: none [-]
  std::optional<double> first_step = {};    ///< > 0; none: chosen by CVODE [s]
  std::optional<double> largest_step = {};  ///< > 0, not below first_step; none: no limit [s]
  long max_steps = 1'000'000;               ///< accepted steps that one advance may take, > 0 [-]
};

/// An explicit Runge-Kutta method: ARKODE, with steps from the embedded method or all of one size.
struct ExplicitRungeKutta {
  Table table = Table::dormand_prince_7_4_5;  ///< the method
  double relative = 1e-10;                    ///< relative tolerance, in [1e-16, 1) [-]
  double absolute = 1e-12;                    ///< absolute tolerance, > 0, in the units of every unknown
  std::optional<double> fixed_step = {};      ///< > 0, but for what is left of an advance; tolerances then rest [s]
  std::optional<double> first_step = {};      ///< > 0, not with fixed_step; none: chosen by ARKODE [s]
  std::optional<double> largest_step = {};    ///< > 0, not below first_step, not with fixed_step; none: no limit [s]
  long max_steps = 1'000'000;                 ///< accepted steps that one advance may take, > 0 [-]
};

/// Newton's method solves with the full Jacobian: the problem's own (schemes::HasJacobian) if it is of first order and
/// has one, difference quotients of its rate else, one right-hand side an unknown.
struct DenseJacobian {};

/// Newton's method solves with a band of the Jacobian, \f$ \partial f_i/\partial y_j \f$ for
/// \f$ -\text{upper} \le i - j \le \text{lower} \f$, always of difference quotients: lower + upper + 1 right-hand
/// sides. What lies outside is taken for zero, which costs iterations, not accuracy.
struct BandedJacobian {
  int lower = 1;  ///< diagonals below the main one, >= 0 and below the number of unknowns [-]
  int upper = 1;  ///< diagonals above it, likewise [-]
};

/// How Newton's method gets its Jacobian and solves with it.
using Jacobian = std::variant<DenseJacobian, BandedJacobian>;

/// Backward differentiation formulas of variable order and step with Newton's method: CVODE, for stiff problems.
struct Bdf {
  double relative = 1e-10;                  ///< relative tolerance, in [1e-16, 1) [-]
  double absolute = 1e-12;                  ///< absolute tolerance, > 0, in the units of every unknown
  int max_order = 5;                        ///< highest order used, 1 to 5 [-]
  Jacobian jacobian = DenseJacobian{};      ///< full or banded
  std::optional<double> first_step = {};    ///< > 0; none: chosen by CVODE [s]
  std::optional<double> largest_step = {};  ///< > 0, not below first_step; none: no limit [s]
  long max_steps = 1'000'000;               ///< accepted steps that one advance may take, > 0 [-]
};

/// The additive Runge-Kutta pairs of ARKODE, an explicit and a stiffly accurate diagonally implicit method of Kennedy
/// and Carpenter on the same nodes. A name ends in stages, order of the embedded pair, order.
///
/// Sources: the ARKODE manual, where each pair stands with its literature.
enum class AdditiveTable {
  ark324l2sa_4_2_3,  ///< ARK3(2)4L[2]SA
  ark436l2sa_6_3_4,  ///< ARK4(3)6L[2]SA
  ark437l2sa_7_3_4,  ///< ARK4(3)7L[2]SA
  ark548l2sa_8_4_5,  ///< ARK5(4)8L[2]SA
  ark548l2sab_8_4_5  ///< ARK5(4)8L[2]SA, second version
};

/// Every additive pair, in the order of its enumeration.
inline constexpr std::array additive_tables{AdditiveTable::ark324l2sa_4_2_3, AdditiveTable::ark436l2sa_6_3_4,
                                            AdditiveTable::ark437l2sa_7_3_4, AdditiveTable::ark548l2sa_8_4_5,
                                            AdditiveTable::ark548l2sab_8_4_5};

/// Name of an additive pair, spelled as its enumerator.
///
/// @param table  a pair
/// @return its name, such as "ark548l2sa_8_4_5"
/// @throws std::invalid_argument for a value that is no enumerator
std::string_view name(AdditiveTable table);

/// Order of the solution that an additive pair advances.
///
/// @param table  a pair
/// @return order of its global error [-]
/// @throws std::invalid_argument for a value that is no enumerator
int order(AdditiveTable table);

/// An additive Runge-Kutta pair: ARKODE, for first-order problems in two parts (schemes::Splits).
///
/// The slow part is explicit. The fast one is implicit, by Newton's method with a full Jacobian of difference quotients
/// of that part; its iteration ends at a tenth of the tolerances.
struct ImplicitExplicit {
  AdditiveTable table = AdditiveTable::ark436l2sa_6_3_4;  ///< the pair
  double relative = 1e-10;                                ///< relative tolerance, in [1e-16, 1) [-]
  double absolute = 1e-12;                                ///< absolute tolerance, > 0, in the units of every unknown
  std::optional<double> fixed_step = {};  ///< > 0, but for what is left of an advance; tolerances are Newton's only [s]
  std::optional<double> first_step = {};  ///< > 0, not with fixed_step; none: chosen by ARKODE [s]
  std::optional<double> largest_step = {};  ///< > 0, not below first_step, not with fixed_step; none: no limit [s]
  long max_steps = 1'000'000;               ///< accepted steps that one advance may take, > 0 [-]
};

/// Any reference method.
using Method = std::variant<Adams, ExplicitRungeKutta, Bdf, ImplicitExplicit>;

/// Refuses settings that cannot be meant. Called once, where a method enters an integrator.
///
/// @param method  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const Adams& method);
/// @copydoc validate(const Adams&)
void validate(const ExplicitRungeKutta& method);
/// @copydoc validate(const Adams&)
void validate(const Bdf& method);
/// @copydoc validate(const Adams&)
void validate(const ImplicitExplicit& method);

}  // namespace particulate::reference
