#pragma once
/// Board file of `clast reconstruct --board`: markers on a plate, or a ChArUco board
/// (docs/formats.md).
#include <filesystem>

#include "reconstruct/photos/scale_board.hpp"

namespace clast {

/// Reads a board file.
/// @throws InputError  if it is not readable or not a board; names file, line, key and expectation
ScaleBoard read_scale_board(const std::filesystem::path& file);

}  // namespace clast
