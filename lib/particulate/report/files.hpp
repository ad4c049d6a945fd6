#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace particulate::report {

/// Writes a file whole: under a temporary name in the same folder, then renamed over the old one.
///
/// A reader therefore sees the old content or the new, and a run that is cut short leaves the old.
/// The file gets the permissions that the process gives to any new file.
/// @param path     where the file shall stand; its folder must exist
/// @param content  every byte of it
/// @throws std::runtime_error with the path and the system's reason; the old file is then untouched and no temporary
///         file is left behind
void write_whole(const std::filesystem::path& path, std::string_view content);

/// Reads a file into one string.
/// @param path  a file that exists
/// @return every byte of it
/// @throws std::runtime_error with the path and the system's reason
std::string read_whole(const std::filesystem::path& path);

/// Makes a folder, with those above it, and shows by writing that files can be put there.
///
/// Called before a long run begins, so that hours of work do not end at a folder that takes no file.
/// @param folder  where results shall go
/// @throws std::runtime_error with the folder, the system's reason and what to do
void prepare_folder(const std::filesystem::path& folder);

}  // namespace particulate::report
