#pragma once
/// Resolution of the coordinates in a file.
#include <filesystem>
#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct CoordinateResolution {
  double step = 0.0;            ///< coarsest resolution of the three axes
  double max_coordinate = 0.0;  ///< largest coordinate of that axis
};

/// Finds the resolution of coordinates that were stored as 32-bit floats or with seven digits.
/// Empty if all axes have more digits.
std::optional<CoordinateResolution> find_coordinate_resolution(const TriangleMesh& mesh);

/// Checks the resolution of the coordinates in a file. Returns a note if the file stores too few
/// digits; otherwise empty.
/// @param mesh  mesh as read from `path`, in the units of the file
/// @param unit  metres per unit
/// @throws InputError  if the resolution is too coarse for the shape of the block
std::string check_coordinate_digits(const TriangleMesh& mesh, const std::filesystem::path& path,
                                    double unit);

}  // namespace clast::reconstruct_detail
