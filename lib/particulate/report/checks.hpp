#pragma once

#include <string>

#include <particulate/report/table.hpp>

namespace particulate::report {

/// What a chapter's run claims of itself: each claim with the error that was seen and the error that is allowed.
class Checks {
 public:
  /// Adds a claim, which holds if |error| <= allowed. A NaN fails it.
  /// @param claim    the fact as a sentence, with the unit of its error
  /// @param error    what was seen, of either sign
  /// @param allowed  the largest size it may have, >= 0
  void add(const std::string& claim, double error, double allowed);

  /// @return the claims so far: claim, size of the error, what is allowed, holds or FAILS
  const Table& table() const { return table_; }
  /// @return the same for a terminal: a claim a line, those that are long broken, numbers to three digits
  std::string text() const;
  /// @return whether every claim so far holds
  bool all_hold() const { return all_hold_; }

 private:
  Table table_{{"claim", "error", "allowed", "verdict"}};
  bool all_hold_ = true;
};

}  // namespace particulate::report
