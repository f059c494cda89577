#pragma once
/// The file of `clast reconstruct --board`: markers on a plate, or a ChArUco board
/// (docs/formats.md).
#include <filesystem>

#include "reconstruct/photos/scale_board.hpp"

namespace clast {

/// @throws InputError  not readable, or not a board: file, line, key and what was expected
ScaleBoard read_scale_board(const std::filesystem::path& file);

}  // namespace clast
