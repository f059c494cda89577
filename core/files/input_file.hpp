#pragma once
/// Checks of input files.
#include <filesystem>

namespace clast {

/// Checks that `path` is a regular file, so that it can be read repeatedly.
/// @throws InputError  if it is missing, a folder, a pipe, a socket or a device
void check_input_file(const std::filesystem::path& path);

}  // namespace clast
