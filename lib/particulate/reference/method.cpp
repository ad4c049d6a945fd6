#include <particulate/reference/method.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace particulate::reference {

namespace {

struct Entry {
  Table table;
  std::string_view name;
  int order;
  int embedded_order;
};

constexpr std::array entries{Entry{Table::heun_euler_2_1_2, "heun_euler_2_1_2", 2, 1},
                             Entry{Table::bogacki_shampine_4_2_3, "bogacki_shampine_4_2_3", 3, 2},
                             Entry{Table::ark324l2sa_erk_4_2_3, "ark324l2sa_erk_4_2_3", 3, 2},
                             Entry{Table::zonneveld_5_3_4, "zonneveld_5_3_4", 4, 3},
                             Entry{Table::ark436l2sa_erk_6_3_4, "ark436l2sa_erk_6_3_4", 4, 3},
                             Entry{Table::sayfy_aburub_6_3_4, "sayfy_aburub_6_3_4", 4, 3},
                             Entry{Table::cash_karp_6_4_5, "cash_karp_6_4_5", 5, 4},
                             Entry{Table::fehlberg_6_4_5, "fehlberg_6_4_5", 5, 4},
                             Entry{Table::dormand_prince_7_4_5, "dormand_prince_7_4_5", 5, 4},
                             Entry{Table::ark548l2sa_erk_8_4_5, "ark548l2sa_erk_8_4_5", 5, 4},
                             Entry{Table::verner_8_5_6, "verner_8_5_6", 6, 5},
                             Entry{Table::fehlberg_13_7_8, "fehlberg_13_7_8", 8, 7},
                             Entry{Table::knoth_wolke_3_3, "knoth_wolke_3_3", 3, 0},
                             Entry{Table::ark437l2sa_erk_7_3_4, "ark437l2sa_erk_7_3_4", 4, 3},
                             Entry{Table::ark548l2sab_erk_8_4_5, "ark548l2sab_erk_8_4_5", 5, 4}};

struct AdditiveEntry {
  AdditiveTable table;
  std::string_view name;
  int order;
};

constexpr std::array additive_entries{AdditiveEntry{AdditiveTable::ark324l2sa_4_2_3, "ark324l2sa_4_2_3", 3},
                                      AdditiveEntry{AdditiveTable::ark436l2sa_6_3_4, "ark436l2sa_6_3_4", 4},
                                      AdditiveEntry{AdditiveTable::ark437l2sa_7_3_4, "ark437l2sa_7_3_4", 4},
                                      AdditiveEntry{AdditiveTable::ark548l2sa_8_4_5, "ark548l2sa_8_4_5", 5},
                                      AdditiveEntry{AdditiveTable::ark548l2sab_8_4_5, "ark548l2sab_8_4_5", 5}};

template <class Entries, class Enumerator>
const auto& find(const Entries& all, Enumerator table, std::string_view kind) {
  const auto* const found = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.table == table; });
  if (found == all.end()) {
    throw std::invalid_argument(fmt::format("{}: table must be one of the {} enumerators, got number {}", kind,
                                            all.size(), static_cast<int>(table)));
  }
  return *found;
}

constexpr std::string_view explicit_kind = "explicit Runge-Kutta", additive_kind = "implicit-explicit Runge-Kutta";

const Entry& entry(Table table) { return find(entries, table, explicit_kind); }

const AdditiveEntry& entry(AdditiveTable table) { return find(additive_entries, table, additive_kind); }

// Comparisons are written so that a NaN fails them.

void validate_tolerances(std::string_view method, double relative, double absolute) {
  if (!(relative >= 1e-16 && relative < 1.0)) {
    throw std::invalid_argument(
        fmt::format("{}: relative must lie in [1e-16, 1), below is finer than a double, got {}", method, relative));
  }
  if (!(absolute > 0.0 && std::isfinite(absolute))) {
    throw std::invalid_argument(fmt::format(
        "{}: absolute must be positive and finite (a component may pass through zero), got {}", method, absolute));
  }
}

void validate_step(std::string_view method, std::string_view setting, const std::optional<double>& step) {
  if (step && !(*step > 0.0 && std::isfinite(*step))) {
    throw std::invalid_argument(
        fmt::format("{}: {} must be positive and finite (leave it out for none), got {} s", method, setting, *step));
  }
}

void validate_steps(std::string_view method, const std::optional<double>& first, const std::optional<double>& largest,
                    long max_steps) {
  validate_step(method, "first_step", first);
  validate_step(method, "largest_step", largest);
  if (first && largest && *first > *largest) {
    throw std::invalid_argument(
        fmt::format("{}: first_step must not exceed largest_step = {} s, got {} s", method, *largest, *first));
  }
  if (max_steps < 1)
    throw std::invalid_argument(fmt::format("{}: max_steps must be positive, got {}", method, max_steps));
}

template <class Settings>
void validate_runge_kutta(std::string_view kind, const Settings& method) {
  validate_tolerances(kind, method.relative, method.absolute);
  validate_steps(kind, method.first_step, method.largest_step, method.max_steps);
  validate_step(kind, "fixed_step", method.fixed_step);
  if (method.fixed_step && (method.first_step || method.largest_step)) {
    throw std::invalid_argument(
        fmt::format("{}: first_step and largest_step are for steps that vary, got one of them with fixed_step = {} s; "
                    "leave one out",
                    kind, *method.fixed_step));
  }
  (void)entry(method.table);
}

}  // namespace

std::string_view name(Table table) { return entry(table).name; }

int order(Table table) { return entry(table).order; }

std::string_view name(AdditiveTable table) { return entry(table).name; }

int order(AdditiveTable table) { return entry(table).order; }

int embedded_order(Table table) { return entry(table).embedded_order; }

Table table_named(std::string_view name) {
  std::string known;
  for (const Entry& e : entries) {
    if (e.name == name) return e.table;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", e.name);
  }
  throw std::invalid_argument(fmt::format("explicit Runge-Kutta: table must be one of {}; got '{}'", known, name));
}

void validate(const Adams& method) {
  validate_tolerances("Adams", method.relative, method.absolute);
  validate_steps("Adams", method.first_step, method.largest_step, method.max_steps);
  if (method.max_order < 1 || method.max_order > 12) {
    throw std::invalid_argument(fmt::format("Adams: max_order must lie in 1 ... 12, got {}", method.max_order));
  }
  if (method.anderson < 0) {
    throw std::invalid_argument(fmt::format("Adams: anderson must not be negative, got {}", method.anderson));
  }
}

void validate(const ExplicitRungeKutta& method) {
  validate_runge_kutta(explicit_kind, method);
  if (embedded_order(method.table) == 0 && !method.fixed_step) {
    throw std::invalid_argument(fmt::format("{}: {} has no embedded method to choose steps by; give a fixed_step",
                                            explicit_kind, name(method.table)));
  }
}

void validate(const Bdf& method) {
  validate_tolerances("BDF", method.relative, method.absolute);
  validate_steps("BDF", method.first_step, method.largest_step, method.max_steps);
  if (method.max_order < 1 || method.max_order > 5) {
    throw std::invalid_argument(fmt::format("BDF: max_order must lie in 1 ... 5, got {}", method.max_order));
  }
  const auto* const band = std::get_if<BandedJacobian>(&method.jacobian);
  if (band && (band->lower < 0 || band->upper < 0)) {
    throw std::invalid_argument(
        fmt::format("BDF: half-bandwidths must not be negative, got lower {} and upper {}", band->lower, band->upper));
  }
}

void validate(const ImplicitExplicit& method) { validate_runge_kutta(additive_kind, method); }

}  // namespace particulate::reference
