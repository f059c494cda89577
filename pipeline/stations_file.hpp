#pragma once
/// Reader of the positions from which a deposit was scanned.
#include <filesystem>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Reads the positions of the scanner or the cameras from a table of points, in any format of
/// `stream_cloud`, such as CSV with the columns x, y and z.
/// @return  positions in units and axes of the file
/// @throws InputError  if `stream_cloud` throws, or if there are more positions than scans have
std::vector<Vec3> read_stations(const std::filesystem::path& file);

}  // namespace clast
