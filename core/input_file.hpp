#pragma once
/// Files that are read.
#include <filesystem>

namespace clast {

/// That `path` is a file that can be read from its beginning as often as need be.
/// @throws InputError  missing, a folder, a pipe, a socket or a device: reading these may wait for
///                     ever, or give what can't be had again; names the path
void check_input_file(const std::filesystem::path& path);

}  // namespace clast
