#pragma once
/// Whole files in and out as bytes, and what their names say.
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace clast {

/// Gives the content of a file in pieces of a megabyte, in order.
/// @throws InputError  missing, a folder, a pipe, a device, or unreadable; names the path
void read_in_chunks(const std::filesystem::path& path,
                    const std::function<void(std::string_view)>& consume);

/// The content of a file.
/// @throws InputError  missing, a folder, a pipe, a device, or unreadable; names the path
std::string read_text_file(const std::filesystem::path& path);

/// Writes `content` through an `OutputFile`, so that `path` is either the old or the new file.
/// @throws InputError  the folder can't be written to
void write_text_file(const std::filesystem::path& path, std::string_view content);

/// Lower-case extension of a file name, with the dot.
std::string lower_case_extension(const std::filesystem::path& path);

}  // namespace clast
