#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <particulate/report/stamp.hpp>
#include <particulate/report/table.hpp>

namespace particulate::report {

/// The folder that a run writes its results to: of one run, and finished or visibly not.
///
/// A run that begins takes down what the run before it left there, the stamp first, and writes `unfinished.txt`, which
/// lists what it has written so far and goes when the stamp is there. So a run that is cut short, however it ends,
/// leaves no file of another one beside its own, and none that looks finished. Files that no run wrote are left alone.
class Output {
 public:
  /// @param folder  made if it does not exist, and tried
  /// @throws std::runtime_error if no file can be written there, or another run is at work there; what was
  ///         there is then untouched
  explicit Output(std::filesystem::path folder);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  /// Leaves the folder to others.
  ~Output();

  /// Writes a table as `<folder>/<name>.csv`, whole.
  /// @param name   file name without its ending: lower-case letters, digits, underscores
  /// @param table  what to write
  /// @throws std::invalid_argument for another kind of name, std::runtime_error if the file cannot be written
  void write(const std::string& name, const Table& table) const;
  /// Writes a file that is no table, whole: for other programs to read.
  /// @param file     name with its ending: lower-case letters, digits, underscores, and .xyz, .vtp or .vti
  /// @param content  every byte of it
  /// @throws std::invalid_argument for another kind of name, std::runtime_error if the file cannot be written
  void write_file(const std::string& file, std::string_view content) const;
  /// Writes `<folder>/parameters.toml`, whole: what repeats the run.
  /// @param toml  the file's text
  /// @throws std::runtime_error if it cannot be written
  void write_parameters(std::string_view toml) const;
  /// Ends the run: writes `<folder>/stamp.json` with the files that were written.
  /// @param stamp  what they were made with
  /// @return how many files the run has left, the stamp among them
  /// @throws std::runtime_error if it cannot be written
  std::size_t finish(Stamp stamp) const;

  /// @return the folder
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void add(const std::string& file, std::string_view content) const;

  std::filesystem::path folder_;
  int lock_ = -1;  // the folder's descriptor
};

/// Refuses a folder whose results are of no finished run: for what reads them.
/// @param folder  of a run
/// @throws std::runtime_error unless it holds a stamp and no run is, or was cut short, at work there
void require_finished(const std::filesystem::path& folder);

}  // namespace particulate::report
