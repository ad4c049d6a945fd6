#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace particulate::report {

/// One `key = value` of a parameter file.
struct Setting {
  /// What kind of value TOML takes it for.
  enum class Kind {
    number,  ///< with a point or an exponent, or inf or nan
    whole,   ///< an integer
    truth,   ///< true or false
    text,    ///< in quotes
    other    ///< a date, an array, a table
  };
  std::string key;          ///< as it stands in the file
  Kind kind = Kind::other;  ///< of the value
  std::string value;        ///< a number's own digits, true or false, a text without its quotes
  unsigned line = 0;        ///< where it stands, from 1
};

/// Reads a TOML file of single values. Numbers keep their digits: turning them into bits is left to the caller.
/// @param file  the file
/// @return every key of the file's top level, in the order of the file
/// @throws std::runtime_error with file, line and reason if it cannot be read or is no TOML
std::vector<Setting> read_parameter_file(const std::filesystem::path& file);

/// @param text  printable ASCII
/// @return it in quotes, so that TOML reads it back as it was
std::string toml_text(const std::string& text);
/// @param number  any double
/// @return its shortest exact digits, with a point or an exponent, so that TOML reads back the same bits
std::string toml_number(double number);

}  // namespace particulate::report
