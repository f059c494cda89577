#pragma once
/// Reader of board files (docs/formats.md). A board has markers on a plate, or is a ChArUco board.
#include <filesystem>

#include "reconstruct/photos/scale_board.hpp"

namespace clast {

/// Reads a board file.
/// @throws InputError  if the file cannot be read or does not describe a board; names file, line,
///                     key and expectation
ScaleBoard read_scale_board(const std::filesystem::path& file);

}  // namespace clast
