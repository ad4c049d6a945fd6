#pragma once

#include <functional>
#include <source_location>
#include <string>
#include <string_view>

#include <harness/rows.hpp>

namespace verification {

/// Where the expected values of a case come from. Never from the library's own earlier output.
enum class Reference {
  closed_form,         ///< a formula, re-derived and evaluated apart
  identity,            ///< holds to rounding by the structure of the equations: a conservation law, a symmetry
  sundials,            ///< CVODE or ARKODE at tight tolerances
  published,           ///< digits or curves from the literature
  independent_method,  ///< another method, written for the case: quadrature, extended precision
  convergence,         ///< the order that theory gives
  statistics,          ///< a distribution or mean, with its standard error
  design               ///< what the library promises of itself: a refusal, a count
};

/// @param reference  any of them
/// @return its name in words, as in rows.csv: "closed form"
std::string_view name_of(Reference reference);

/// What a case claims.
struct Claim {
  std::string name;                              ///< lower-case letters, digits, underscores; no two alike
  std::string claim;                             ///< the fact as a sentence
  std::string equation;                          ///< `M 2.46`, `D 2.3`, `R 2.4.2`
  Reference reference = Reference::closed_form;  ///< where the expected values come from
};

/// A claim and the function that proves it. Registers itself: a case is one constant, in the file of its theme.
class Case {
 public:
  /// @param claim  name, sentence, equation, reference
  /// @param proof  writes at least one row
  /// @param where  where the constant stands
  Case(Claim claim, std::function<void(Rows&)> proof, std::source_location where = std::source_location::current());
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  /// @return name, sentence, equation, reference
  const Claim& claim() const { return claim_; }
  /// @return folder and file of the case: `ch03_schemes/contraction.cpp`
  const std::string& source() const { return source_; }
  /// Runs the proof. @param rows where it writes to
  void prove(Rows& rows) const { proof_(rows); }

 private:
  Claim claim_;
  std::function<void(Rows&)> proof_;
  std::string source_;
};

}  // namespace verification
