#pragma once
/// Reading and writing of whole files, and file name extensions.
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace clast {

/// Reads a file in chunks of 1 MB, in order.
/// @throws InputError  if the file is missing, a folder, a pipe, a device, or unreadable
void read_file_in_chunks(const std::filesystem::path& path,
                         const std::function<void(std::string_view)>& consume);

/// Reads a whole file into a text.
/// @throws InputError  if it is missing, a folder, a pipe, a device, or unreadable
std::string read_text_file(const std::filesystem::path& path);

/// Writes a file atomically through an `OutputFile`.
/// @throws InputError  if the folder cannot be written
void write_text_file(const std::filesystem::path& path, std::string_view content);

/// Returns the lower-case extension of a file name, with the dot.
std::string lower_case_extension(const std::filesystem::path& path);

}  // namespace clast
