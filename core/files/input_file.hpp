#pragma once
/// Files that are read.
#include <filesystem>

namespace clast {

/// Checks that `path` is a file that can be read from its beginning as often as needed.
/// @throws InputError  missing, a folder, a pipe, a socket or a device: reading these may wait
///                     forever, or give data that can't be read again; names the path
void check_input_file(const std::filesystem::path& path);

}  // namespace clast
