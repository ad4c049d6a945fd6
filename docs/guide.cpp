// Turns what a quick run wrote into what the pages show, so that no number is ever typed into prose:
//
//   guide tables <data> <prefix> <out>          every short CSV table of <data> as <out>/<prefix>_<name>.html
//   guide pages <out> <figures> <slug>=<data>.. the verification guide, and the data of its work-precision figures
//
// Text from a run stands in HTML blocks, escaped, because Doxygen would read commands into it.

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <particulate/report/files.hpp>
#include <particulate/report/guarded.hpp>
#include <particulate/report/output.hpp>

namespace {

namespace fs = std::filesystem;
namespace report = particulate::report;
using Strings = std::vector<std::string>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// --- Reading ---------------------------------------------------------------------------------------------------------

// A CSV file whose fields are asked for by the name of their column.
class Csv {
 public:
  explicit Csv(const fs::path& path)
      : origin_(path.string()), lines_(report::parse_csv(report::read_whole(path), origin_)) {
    if (lines_.empty()) throw std::runtime_error(origin_ + ": no header line; run the program again");
  }
  const Strings& columns() const { return lines_.front(); }
  std::size_t size() const { return lines_.size() - 1; }
  const Strings& row(std::size_t i) const { return lines_.at(i + 1); }
  const std::string& at(std::size_t i, const std::string& column) const {
    const auto found = std::find(columns().begin(), columns().end(), column);
    if (found == columns().end()) throw std::runtime_error(fmt::format("{}: no column named {}", origin_, column));
    return row(i).at(static_cast<std::size_t>(found - columns().begin()));
  }

 private:
  std::string origin_;
  std::vector<Strings> lines_;
};

// The number that a whole field spells, if it does.
std::optional<double> number_in(const std::string& field) {
  double value = 0.0;
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (field.empty() || error != std::errc() || stop != end) return std::nullopt;
  return value;
}

double number_or_nan(const std::string& field) { return number_in(field).value_or(nan); }

// --- HTML ------------------------------------------------------------------------------------------------------------

std::string escaped(std::string_view text) {
  static const std::map<char, std::string_view> entities{{'&', "&amp;"},  {'<', "&lt;"},  {'>', "&gt;"},
                                                         {'"', "&quot;"}, {'@', "&#64;"}, {'\\', "&#92;"}};
  std::string out;
  for (const char c : text) {
    const auto entity = entities.find(c);
    if (entity == entities.end()) {
      out += c;
    } else {
      out += entity->second;
    }
  }
  return out;
}

// Numbers are rounded for the reader; the CSV file keeps every digit. Whole numbers stand as they are.
std::string rounded(const std::string& field, int digits) {
  const std::optional<double> value = number_in(field);
  if (!value || field.find_first_of(".en") == std::string::npos) return escaped(field);
  return fmt::format("{:.{}g}", *value, digits);
}

struct HtmlTable {
  Strings columns;
  std::vector<Strings> rows{};  // cells are HTML already
  std::vector<bool> bad{};      // rows to be marked; may be shorter than rows
};

// Numbers stand to the right, and so does the head of a column that holds nothing else.
bool is_numeric(const HtmlTable& table, std::size_t column) {
  return std::all_of(table.rows.begin(), table.rows.end(),
                     [&](const Strings& row) { return row.at(column).empty() || number_in(row[column]); });
}

std::string html(const HtmlTable& table) {
  std::string out = "<div class=\"scroll tex2jax_ignore\"><table class=\"markdownTable\"><thead><tr>";
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    out += (is_numeric(table, k) ? "<th class=\"number\">" : "<th>") + escaped(table.columns[k]) + "</th>";
  }
  out += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    out += i < table.bad.size() && table.bad[i] ? "<tr class=\"bad\">" : "<tr>";
    for (const std::string& cell : table.rows[i]) {
      out += (number_in(cell) ? "<td class=\"number\">" : "<td>") + cell + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

// What holds is folded, so that a page shows what it claims and what fails; rows marked as bad always stay in sight.
constexpr std::size_t longest_unfolded = 3;

std::string folded(const HtmlTable& table, const std::string& summary) {
  if (table.rows.size() <= longest_unfolded) return html(table);
  HtmlTable seen{.columns = table.columns}, hidden{.columns = table.columns};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool bad = table.bad.at(i);
    (bad ? seen : hidden).rows.push_back(table.rows[i]);
    if (bad) seen.bad.push_back(true);
  }
  const std::string details =
      fmt::format("<details><summary>{} {}</summary>\n{}</details>\n", hidden.rows.size(), summary, html(hidden));
  return (seen.rows.empty() ? "" : html(seen)) + details;
}

std::string block(const std::string& markup) { return "\n@htmlonly\n" + markup + "@endhtmlonly\n\n"; }

std::string equation_link(const std::string& equation) {
  return "<a href=\"equation_index.html\">" + escaped(equation) + "</a>";
}

// --- Tables of a chapter ---------------------------------------------------------------------------------------------

// Longer ones are curves: figures show them. The longest that is read is that of planted defects.
constexpr std::size_t longest_table = 200;

// "ch01: potential_slope, near_field_pairs; ch02: no_pull": each case a link to its rows.
std::string linked_cases(const std::string& cases) {
  if (const std::size_t group = cases.find("; "); group != std::string::npos) {
    return linked_cases(cases.substr(0, group)) + "; " + linked_cases(cases.substr(group + 2));
  }
  const std::size_t colon = cases.find(": ");
  if (colon == std::string::npos) return escaped(cases);
  const std::string chapter = cases.substr(0, colon);
  Strings links;
  for (std::size_t from = colon + 2; from < cases.size();) {
    const std::size_t end = std::min(cases.find(", ", from), cases.size());
    links.push_back(fmt::format("<a href=\"verify_{0}.html#verify_{0}_{1}\">{1}</a>", escaped(chapter),
                                escaped(cases.substr(from, end - from))));
    from = end + 2;
  }
  return fmt::format("{}", fmt::join(links, ", "));
}

void write_tables(const fs::path& data, const std::string& prefix, const fs::path& out) {
  // The table of planted defects is no run's, and has no stamp.
  if (fs::exists(data / "unfinished.txt")) report::require_finished(data);
  for (const fs::directory_entry& entry : fs::directory_iterator(data)) {
    if (entry.path().extension() != ".csv") continue;
    const Csv csv(entry.path());
    if (csv.size() > longest_table) continue;
    HtmlTable table{.columns = csv.columns()};
    for (std::size_t i = 0; i < csv.size(); ++i) {
      Strings cells;
      for (std::size_t k = 0; k < csv.columns().size(); ++k) {
        const std::string& field = csv.row(i).at(k);
        cells.push_back(csv.columns()[k] == "caught by" ? linked_cases(field) : rounded(field, 6));
      }
      table.rows.push_back(cells);
    }
    const fs::path shown = out / fmt::format("{}_{}.html", prefix, entry.path().stem().string());
    if (fs::exists(shown)) {
      throw std::runtime_error(
          fmt::format("{}: a chapter's program and its verification must name their tables differently; rename the "
                      "program's, the other is {}",
                      entry.path().string(), shown.string()));
    }
    report::write_whole(shown, html(table));
  }
  const fs::path parameters = data / "parameters.toml";
  if (fs::exists(parameters)) {
    report::write_whole(out / (prefix + "_parameters.toml"), report::read_whole(parameters));
  }
}

// --- The guide: claims and extreme cases -----------------------------------------------------------------------------

std::string capitalized(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

struct Chapter {
  std::string slug;  // ch01_fundamentals
  fs::path data;
  std::string name() const { return slug.substr(0, slug.find('_')); }  // ch01
  std::string page() const { return "verify_" + name(); }
  std::string title() const {
    std::string number = name().substr(2), topic = slug.substr(slug.find('_') + 1);
    const bool appendix = name().starts_with("app");
    number = appendix ? name().substr(3) : number.substr(number.find_first_not_of('0'));
    std::replace(topic.begin(), topic.end(), '_', ' ');
    return fmt::format("{} {}: {}", appendix ? "Appendix" : "Chapter", number, capitalized(topic));
  }
};

// One case of the catalogue: consecutive rows under one name.
struct Case {
  std::string name;
  std::vector<std::size_t> rows;
};

std::vector<Case> cases_of(const Csv& rows) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string& name = rows.at(i, "case");
    const auto known = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return c.name == name; });
    if (known == cases.end()) {
      cases.push_back({name, {i}});
    } else {
      known->rows.push_back(i);
    }
  }
  return cases;
}

bool fails(const Csv& rows, std::size_t i) { return rows.at(i, "verdict") != "pass"; }
bool fails_stability(const Csv& extremes, std::size_t i) { return extremes.at(i, "verdict") != extremes.at(i, "must"); }

struct Counts {
  std::size_t claims = 0, rows = 0, failures = 0, extremes = 0, extreme_failures = 0;
  std::map<std::string, std::size_t> claims_by_reference{};
};

Counts count(const Csv& rows, const std::optional<Csv>& extremes) {
  const std::vector<Case> cases = cases_of(rows);
  Counts counts{.claims = cases.size(), .rows = rows.size()};
  for (const Case& c : cases) ++counts.claims_by_reference[rows.at(c.rows.front(), "reference")];
  for (std::size_t i = 0; i < rows.size(); ++i) counts.failures += fails(rows, i);
  if (!extremes) return counts;
  counts.extremes = extremes->size();
  for (std::size_t i = 0; i < extremes->size(); ++i) counts.extreme_failures += fails_stability(*extremes, i);
  return counts;
}

std::string references(const Counts& counts) {
  Strings parts;
  for (const auto& [kind, claims] : counts.claims_by_reference) parts.push_back(fmt::format("{} {}", claims, kind));
  return escaped(fmt::format("{}", fmt::join(parts, ", ")));
}

// What is short stands first: a table that is too wide hides its end.
Strings summary_row(const Counts& counts) {
  return {fmt::format("{}", counts.claims),           fmt::format("{}", counts.rows),
          fmt::format("{}", counts.failures),         fmt::format("{}", counts.extremes),
          fmt::format("{}", counts.extreme_failures), references(counts)};
}
const Strings summary_columns{"Claims",         "Rows", "Rows that fail", "Extreme cases", "that end otherwise",
                              "Checked against"};

// Metrics that have no tolerance: the expected value is a bound, or the only one allowed.
bool is_bound(const std::string& metric) {
  return metric == "at most" || metric == "at least" || metric == "equal" || metric == "verdict" ||
         metric == "left out";
}

// One line a claim, which opens to its rows; what fails is open.
std::string claim_section(const Csv& rows, const Case& c) {
  const std::size_t first = c.rows.front();
  HtmlTable table{.columns = {"Quantity", "Expected", "Computed", "Error", "Tolerance", "Because", "Verdict"}};
  std::size_t failed = 0;
  for (const std::size_t i : c.rows) {
    const bool bound = is_bound(rows.at(i, "metric"));
    table.rows.push_back({escaped(rows.at(i, "quantity")), rounded(rows.at(i, "expected"), 10),
                          rounded(rows.at(i, "computed"), 10), bound ? "" : rounded(rows.at(i, "error"), 2),
                          (bound ? "" : rounded(rows.at(i, "tolerance"), 3) + " ") + escaped(rows.at(i, "metric")),
                          escaped(rows.at(i, "because")), escaped(rows.at(i, "verdict"))});
    table.bad.push_back(fails(rows, i));
    failed += fails(rows, i);
  }
  const std::string facts =
      fmt::format("<code>{}</code> &middot; {} &middot; {} &middot; {} row{}{}", c.name,
                  equation_link(rows.at(first, "equation")), escaped(rows.at(first, "reference")), c.rows.size(),
                  c.rows.size() == 1 ? "" : "s", failed == 0 ? "" : fmt::format(", {} failed", failed));
  return fmt::format(
      "@anchor verify_{}_{}\n@htmlonly[block]\n<details class=\"claim{}><summary>{}. <span class=\"facts\">{}</span>"
      "</summary>\n{}</details>\n@endhtmlonly\n\n",
      rows.at(first, "chapter"), c.name, failed == 0 ? "\"" : " bad\" open",
      escaped(capitalized(rows.at(first, "claim"))), facts,
      failed == 0 ? html(table) : folded(table, "rows that hold"));
}

// The claims of a chapter, theme by theme, that is by the source they stand in.
std::string claims_section(const Csv& rows, const Csv& cases) {
  std::map<std::string, std::string> themes;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::string theme = fs::path(cases.at(i, "source")).stem().string();
    std::replace(theme.begin(), theme.end(), '_', ' ');
    themes[cases.at(i, "case")] = capitalized(theme);
  }
  std::string out, theme;
  for (const Case& c : cases_of(rows)) {
    if (themes[c.name] != theme) out += fmt::format("### {}\n\n", theme = themes[c.name]);
    out += claim_section(rows, c);
  }
  return out;
}

std::string stability_section(const Csv& extremes) {
  HtmlTable table{.columns = {"Case", "Must be", "Was", "Reason given"}};
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    table.rows.push_back({escaped(extremes.at(i, "case")), escaped(extremes.at(i, "must")),
                          escaped(extremes.at(i, "verdict")), escaped(extremes.at(i, "reason"))});
    table.bad.push_back(fails_stability(extremes, i));
  }
  return "What must be solved at the edge of the models, and what must be refused with the reason. *Wrong* is an "
         "answer\n"
         "given with confidence that is not one.\n" +
         block(folded(table, "cases that end as they must"));
}

// A command line without the folders of whoever ran it.
std::string without_folders(const std::string& text) {
  std::string out;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, end - from);
    out += (out.empty() ? "" : " ") + (word.starts_with('/') ? fs::path(word).filename().string() : word);
    from = end + 1;
  }
  return out;
}

std::string stamp_table(const fs::path& data) {
  const nlohmann::ordered_json stamp = nlohmann::ordered_json::parse(report::read_whole(data / "stamp.json"));
  HtmlTable table{.columns = {"Made with", ""}};
  for (const auto& [key, value] : stamp.items()) {
    if (key == "files") continue;  // which its folder shows
    table.rows.push_back(
        {escaped(key), escaped(value.is_string() ? without_folders(value.get<std::string>()) : value.dump())});
  }
  return block(html(table));
}

// --- Work and precision ----------------------------------------------------------------------------------------------

struct Point {
  std::string setting, status;
  double error = nan, seconds = nan, median = nan, evaluations = nan;
};

struct Curve {
  std::string method;
  bool tuned = false;
  std::vector<Point> points{}, failed{};
  double nominal = nan, fitted = nan;  // error ~ evaluations^-order, where the method has one
};

std::string name_of(const Curve& curve) {
  const bool said = !curve.tuned || curve.method.find("tuned") != std::string::npos;
  return curve.method + (said ? "" : ", tuned");
}

struct Diagram {
  std::string problem, reference, title{};
  double floor = 0.0;
  std::size_t at_floor = 0;
  std::vector<Curve> curves{};
};

// Within a decade of the reference's own error a point says nothing about the method.
constexpr double above_floor = 10.0;

Curve& curve_of(Diagram& diagram, const std::string& method, bool tuned) {
  for (Curve& curve : diagram.curves) {
    if (curve.method == method && curve.tuned == tuned) return curve;
  }
  return diagram.curves.emplace_back(Curve{.method = method, .tuned = tuned});
}

bool is_true(const std::string& field) { return field == "true" || field == "yes" || field == "1"; }

void add_point(Diagram& diagram, const Csv& work, std::size_t i) {
  const Point point{.setting = work.at(i, "setting"),
                    .status = work.at(i, "status"),
                    .error = number_or_nan(work.at(i, "error_max")),
                    .seconds = number_or_nan(work.at(i, "seconds_min")),
                    .median = number_or_nan(work.at(i, "seconds_median")),
                    .evaluations = number_or_nan(work.at(i, "evaluations"))};
  diagram.floor = std::max(diagram.floor, number_or_nan(work.at(i, "floor")));
  Curve& curve = curve_of(diagram, work.at(i, "method"), is_true(work.at(i, "tuned")));
  if (point.status == "at floor") {
    ++diagram.at_floor;
  } else if (point.status == "solved" && point.error > 0.0 && std::isfinite(point.error)) {
    curve.points.push_back(point);
  } else {
    curve.failed.push_back(point);
  }
}

std::vector<Diagram> diagrams_of(const Csv& work) {
  std::vector<Diagram> diagrams;
  for (std::size_t i = 0; i < work.size(); ++i) {
    const std::string& problem = work.at(i, "problem");
    auto known = std::find_if(diagrams.begin(), diagrams.end(), [&](const Diagram& d) { return d.problem == problem; });
    if (known == diagrams.end()) {
      known = diagrams.insert(diagrams.end(), {.problem = problem, .reference = work.at(i, "reference")});
    }
    add_point(*known, work, i);
  }
  return diagrams;
}

// What a diagram is of, in words: from the claim "error against run time of a mass on a spring: ..." of its own case,
// or else the problem's name.
std::string title_of(const Diagram& diagram, const Csv& rows) {
  constexpr std::string_view before = "error against run time of ";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string& claim = rows.at(i, "claim");
    if (rows.at(i, "case") != "work_precision_" + diagram.problem || !claim.starts_with(before)) continue;
    return capitalized(claim.substr(before.size(), claim.find(':') - before.size()));
  }
  std::string name = diagram.problem;
  std::replace(name.begin(), name.end(), '_', ' ');
  return capitalized(name);
}

// Methods with an order of their own have a row that compares it: "<problem>, <method>: slope ...".
void read_orders(Diagram& diagram, const Csv& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows.at(i, "metric").starts_with("order")) continue;
    for (Curve& curve : diagram.curves) {
      if (!rows.at(i, "quantity").starts_with(fmt::format("{}, {}: ", diagram.problem, curve.method))) continue;
      curve.nominal = number_or_nan(rows.at(i, "expected"));
      curve.fitted = number_or_nan(rows.at(i, "computed"));
    }
  }
}

std::string slug(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
    if (plain) out += c;
    if (!plain && !out.empty() && out.back() != '_') out += '_';
  }
  return out;
}

// Gnuplot reads ' doubled inside '...'.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += c;
    out += c;
  }
  return out += "'";
}

bool is_sundials(const Curve& curve) {
  return curve.method.find("CVODE") != std::string::npos || curve.method.find("ARK") != std::string::npos;
}

std::string label(const Curve& curve) {
  return name_of(curve) + (std::isfinite(curve.fitted) ? fmt::format(", order {:.2f}", curve.fitted) : "");
}

// The errors drawn, widened to whole decades, with the floor's band if it is not far below them.
std::pair<double, double> frame(const Diagram& diagram) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const Curve& curve : diagram.curves) {
    for (const Point& p : curve.points) low = std::min(low, p.error), high = std::max(high, p.error);
  }
  const double shaded = above_floor * diagram.floor;
  if (low < 1e4 * shaded) low = std::min(low, diagram.floor);
  return {std::pow(10.0, std::floor(std::log10(low))), std::pow(10.0, std::ceil(std::log10(high) + 0.5))};
}

struct Failure {
  int number;
  const Curve* curve;
  const Point* point;
};

std::vector<Failure> failures_of(const Diagram& diagram) {
  std::vector<Failure> failures;
  for (const Curve& curve : diagram.curves) {
    for (const Point& p : curve.failed) failures.push_back({static_cast<int>(failures.size()) + 1, &curve, &p});
  }
  return failures;
}

std::vector<Curve> drawn(const Diagram& diagram) {
  std::vector<Curve> curves;
  std::copy_if(diagram.curves.begin(), diagram.curves.end(), std::back_inserter(curves),
               [](const Curve& curve) { return !curve.points.empty(); });
  return curves;
}

// One block of points a drawn curve, then one with the failures: their number, and what they cost. Failures without a
// cost stand above all that was measured.
std::string plot_data(const Diagram& diagram) {
  std::string out;
  double seconds = 1e-9, evaluations = 1.0;
  for (const Curve& curve : drawn(diagram)) {
    out += "# error,seconds,median,evaluations\n";
    for (const Point& p : curve.points) {
      out += fmt::format("{},{},{},{}\n", p.error, p.seconds, p.median, p.evaluations);
      seconds = std::max(seconds, p.median), evaluations = std::max(evaluations, p.evaluations);
    }
    out += "\n\n";
  }
  for (const Failure& f : failures_of(diagram)) {
    out += fmt::format("{},{},{},{}\n", f.number, std::isfinite(f.point->seconds) ? f.point->seconds : 2.0 * seconds,
                       f.point->median, f.point->evaluations > 0.0 ? f.point->evaluations : 2.0 * evaluations);
  }
  return out;
}

// The line c error^(-1/order) through the middle of a curve's points on logarithmic scales, as far as they reach.
// Errors above one hundredth are left out: they are not small yet.
struct Theory {
  double factor = 0.0, from = std::numeric_limits<double>::infinity(), to = 0.0;
};
std::optional<Theory> theory_of(const Curve& curve) {
  Theory line;
  double sum = 0.0, n = 0.0;
  for (const Point& p : curve.points) {
    if (!(p.error < 1e-2)) continue;
    sum += std::log(p.evaluations) + std::log(p.error) / curve.nominal, n += 1.0;
    line.from = std::min(line.from, p.error), line.to = std::max(line.to, p.error);
  }
  if (!(curve.nominal > 0.0) || n < 2.0) return std::nullopt;
  line.factor = std::exp(sum / n);
  return line;
}

// What work_precision.gp has to know about one diagram.
std::string plot_commands(const Diagram& diagram, const std::string& name) {
  static const Strings inks{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#2f93d0"};
  static const std::vector<int> own_marks{7, 5, 9, 11, 13, 15}, sundials_marks{6, 4, 8, 10, 12, 14};  // filled, open
  const std::vector<Curve> curves = drawn(diagram);
  const auto [left, right] = frame(diagram);
  std::string out = fmt::format("data = points.'/{}.csv'\nname = '{}'\nheading = {}\ncurves = {}\nfailures = {}\n",
                                name, name, quoted(diagram.title), curves.size(), failures_of(diagram).size());
  out += fmt::format("left = {}\nright = {}\nshaded = {}\n", left, right, above_floor * diagram.floor);
  for (const std::string_view array : {"title", "ink", "mark", "dash", "slope", "through", "from", "to"}) {
    out += fmt::format("array {}[{}]\n", array, curves.size());
  }
  std::size_t own = 0, foreign = 0;
  int slopes = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool sundials = is_sundials(curves[i]);
    const std::size_t k = sundials ? foreign++ : own++;
    out += fmt::format("title[{0}] = {1}; ink[{0}] = '{2}'; mark[{0}] = {3}; dash[{0}] = {4}\n", i + 1,
                       quoted(label(curves[i])), inks[(i + i / inks.size()) % inks.size()],
                       (sundials ? sundials_marks : own_marks)[k % own_marks.size()],
                       curves[i].tuned ? 3 : (sundials ? 2 : 1));
    if (const std::optional<Theory> line = theory_of(curves[i])) {
      out += fmt::format("slope[{0}] = {1}; through[{0}] = {2}; from[{0}] = {3}; to[{0}] = {4}\n", ++slopes,
                         curves[i].nominal, line->factor, line->from / 2.0, line->to * 2.0);
    }
  }
  out += fmt::format("slopes = {}\n", slopes);
  return out + "load work_precision\n";
}

std::string failure_table(const Diagram& diagram) {
  HtmlTable table{.columns = {"Mark", "Method", "Setting", "What happened"}};
  for (const Failure& f : failures_of(diagram)) {
    table.rows.push_back({fmt::format("{}", f.number), escaped(name_of(*f.curve)), rounded(f.point->setting, 3),
                          escaped(f.point->status)});
  }
  return table.rows.empty() ? "" : "Runs that failed, marked at the right frame:\n" + block(html(table));
}

// Everything that was measured, for those who want the figures' numbers.
std::string all_points(const Csv& work, const std::string& problem) {
  HtmlTable table{.columns = {"Method", "Setting", "Error at the end", "Largest error", "Seconds", "Median", "Overhead",
                              "Right-hand sides", "Iterations", "Status"}};
  for (std::size_t i = 0; i < work.size(); ++i) {
    if (work.at(i, "problem") != problem) continue;
    Strings cells{escaped(work.at(i, "method"))};
    for (const char* column : {"setting", "error_end", "error_max", "seconds_min", "seconds_median", "seconds_overhead",
                               "evaluations", "iterations", "status"}) {
      cells.push_back(rounded(work.at(i, column), 3));
    }
    table.rows.push_back(cells);
  }
  return "Every point. Overhead: seconds with the right-hand side replayed from a recording, so the method's own "
         "work.\n" +
         block(html(table));
}

// Writes a diagram's data and returns its part of the page; its commands are added to the script.
std::string draw(const Diagram& diagram, const Csv& work, const std::string& chapter, const fs::path& figures,
                 std::string& script) {
  const std::string name = fmt::format("{}_work_{}", chapter, slug(diagram.problem));
  const bool anything = !drawn(diagram).empty();
  if (anything) {
    report::write_whole(figures / (name + ".csv"), plot_data(diagram));
    script += plot_commands(diagram, name);
  }
  std::string out = fmt::format("### {} {{#guide_{}}}\n", diagram.title, name);
  out +=
      block(fmt::format("<p>Reference: {}, good to {:.2g}. Points within a factor {} of that, a shaded "
                        "band where it is near, are not drawn: {} here.</p>\n",
                        escaped(diagram.reference), diagram.floor, above_floor, diagram.at_floor));
  if (anything) out += fmt::format("@image html {}_seconds.svg\n\n", name);
  out += failure_table(diagram) +
         "@htmlonly[block]<details><summary>Against right-hand sides, and every point</summary>@endhtmlonly\n\n";
  if (anything) out += fmt::format("@image html {}_evaluations.svg\n\n", name);
  return out + all_points(work, diagram.problem) + "@htmlonly[block]</details>@endhtmlonly\n\n";
}

std::string work_section(const Chapter& chapter, const Csv& rows, const fs::path& figures) {
  const Csv work(chapter.data / "work_precision.csv");
  std::string script, out;
  for (Diagram& diagram : diagrams_of(work)) {
    diagram.title = title_of(diagram, rows);
    read_orders(diagram, rows);
    out += draw(diagram, work, chapter.name(), figures, script);
  }
  report::write_whole(figures / (chapter.name() + "_work.gp"), script);
  return "Across: the error attained, the largest over the times compared, never a tolerance that was asked for. Up: "
         "what\n"
         "it cost: in seconds (the least of the repeats; the whisker ends at their median), and, folded below each, "
         "in\n"
         "right-hand sides, which repeat exactly. Filled marks are methods of this library, open marks with broken "
         "lines are\n"
         "SUNDIALS. Methods of fixed step show the order fitted to their points, and a thin line with the slope of "
         "their theory.\n\n" +
         out;
}

// --- The guide's pages -----------------------------------------------------------------------------------------------

Counts write_chapter_page(const Chapter& chapter, const fs::path& out, const fs::path& figures) {
  report::require_finished(chapter.data);
  const Csv rows(chapter.data / "rows.csv");
  std::optional<Csv> extremes;
  if (fs::exists(chapter.data / "stability.csv")) extremes.emplace(chapter.data / "stability.csv");
  const Counts counts = count(rows, extremes);
  if (counts.rows == 0) {
    throw std::runtime_error((chapter.data / "rows.csv").string() + ": no row, so nothing was verified");
  }
  const bool has_extremes = extremes && extremes->size() > 0;
  const bool has_work = fs::exists(chapter.data / "work_precision.csv");
  std::string page = fmt::format("# {}, verified {{#{}}}\n\n", chapter.title(), chapter.page());
  page += fmt::format(
      "This page is made from what `{0}` wrote in a {3} run when the documentation was built; how to read it is told "
      "in\n"
      "the @ref verification_guide. The chapter itself: @ref {1}. Further down:\n"
      "{4}{5}[the run](#guide_{2}_run).\n",
      chapter.page(), chapter.slug, chapter.name(), rows.at(0, "run"),
      has_extremes ? fmt::format("[extreme cases](#guide_{}_extremes), ", chapter.name()) : "",
      has_work ? fmt::format("[error against run time](#guide_{}_work), ", chapter.name()) : "");
  page += block(html({.columns = summary_columns,
                      .rows = {summary_row(counts)},
                      .bad = {counts.failures + counts.extreme_failures > 0}}));
  page += fmt::format(
      "## Claims {{#guide_{}_claims}}\n\nEach opens to its rows: what was expected, computed and allowed, "
      "and why.\n\n",
      chapter.name());
  page += claims_section(rows, Csv(chapter.data / "cases.csv"));
  if (has_extremes) {
    page += fmt::format("## Extreme cases {{#guide_{}_extremes}}\n\n", chapter.name()) + stability_section(*extremes);
  }
  if (has_work) {
    page += fmt::format("## Error against run time {{#guide_{}_work}}\n\n", chapter.name()) +
            work_section(chapter, rows, figures);
  }
  page += fmt::format("## The run {{#guide_{}_run}}\n", chapter.name()) + stamp_table(chapter.data);
  report::write_whole(out / (chapter.page() + ".md"), page);
  return counts;
}

constexpr std::string_view how_to_read = R"(# Verification guide {#verification_guide}

What this library claims, and what each claim is checked against. These pages are made from the rows that the verification
programs write; nothing on them is typed by hand.

One row compares one number. The *expected* value comes from outside the code it judges:

| Checked against | What stands behind the expected value |
| :--- | :--- |
| closed form | a formula, derived again and evaluated apart from the library |
| identity | a conservation law or symmetry of the equations, which holds to rounding |
| SUNDIALS | the same problem, integrated by CVODE or ARKODE at tight tolerances @cite hindmarsh2005 @cite reynolds2023 |
| published | digits or curves from the literature |
| independent method | another method, written for the case: quadrature, extended precision |
| convergence | the order of accuracy that theory gives, two-sided |
| statistics | a distribution or a mean, with its standard error |
| design | what the library promises of itself: a refusal, a count |

The *tolerance* stands in the case with the reason for its size; a NaN, a missing result or an exception fails. *Extreme*
cases say beforehand whether they must be solved or refused, and the other outcome is a failure. A claim that holds is one
line, which opens to its rows; what fails is open.
The pages show a quick run: it drops no claim, but shortens sizes, repeats and sweeps. The full run is
`./verification/run.sh`. Whether all of this would notice a mistake has been tried with planted ones: @ref teeth.

)";

void write_pages(const fs::path& out, const fs::path& figures, const std::vector<Chapter>& chapters) {
  HtmlTable table{.columns = summary_columns};
  table.columns.insert(table.columns.begin(), "Chapter");
  std::string pages;
  for (const Chapter& chapter : chapters) {
    const Counts counts = write_chapter_page(chapter, out, figures);
    Strings row = summary_row(counts);
    row.insert(row.begin(), fmt::format("<a href=\"{}.html\">{}</a>", chapter.page(), escaped(chapter.title())));
    table.rows.push_back(row);
    table.bad.push_back(counts.failures + counts.extreme_failures > 0);
    pages += fmt::format("- @subpage {}\n", chapter.page());
  }
  pages += "- @subpage teeth\n";
  report::write_whole(out / "verification_guide.md", std::string(how_to_read) + block(html(table)) + pages);
}

// "ch01_fundamentals=folder"
Chapter chapter_from(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  const std::string name = argument.substr(0, equals);
  const bool named = (name.starts_with("ch") || name.starts_with("app")) && name.find('_') != std::string::npos;
  if (equals == std::string::npos || !named) {
    throw std::runtime_error("a chapter is given as chNN_slug=folder, got " + argument);
  }
  return {.slug = name, .data = argument.substr(equals + 1)};
}

int run(const Strings& arguments) {
  if (arguments.size() == 4 && arguments[0] == "tables") {
    write_tables(arguments[1], arguments[2], arguments[3]);
    return 0;
  }
  if (arguments.size() >= 3 && arguments[0] == "pages") {
    std::vector<Chapter> chapters;
    for (std::size_t i = 3; i < arguments.size(); ++i) chapters.push_back(chapter_from(arguments[i]));
    write_pages(arguments[1], arguments[2], chapters);
    return 0;
  }
  fmt::print(stderr, "usage: guide tables <data> <prefix> <out> | guide pages <out> <figures> <slug>=<data>...\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  return report::guarded("guide", [&] { return run(Strings(argv + 1, argv + argc)); });
}
