#pragma once
/// Resolution of the coordinates in a file.
#include <filesystem>
#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct CoordinateResolution {
  double step = 0.0;     ///< coarsest resolution over the axes
  double largest = 0.0;  ///< largest coordinate of that axis
};

/// Finds the resolution of coordinates stored as 32-bit floats or with seven digits; empty if all
/// axes have more digits.
std::optional<CoordinateResolution> find_coordinate_resolution(const TriangleMesh& mesh);

/// Returns a note if the file stores too few digits; otherwise empty.
/// @param mesh  as read from `path`, in its units
/// @param unit  metres per unit
/// @throws InputError  if the block's shape is lost
std::string check_coordinate_digits(const TriangleMesh& mesh, const std::filesystem::path& path,
                                    double unit);

}  // namespace clast::reconstruct_detail
