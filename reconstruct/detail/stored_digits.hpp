#pragma once
/// How finely a file keeps coordinates.
#include <filesystem>
#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct CoordinateResolution {
  double step = 0.0;     ///< the coarsest distance of neighbouring numbers of an axis
  double largest = 0.0;  ///< the largest coordinate, where that step is
};

/// The step that all coordinates of an axis are multiples of because they were stored as 32-bit
/// floats or written with seven digits. None: coordinates of every axis have more digits.
std::optional<CoordinateResolution> find_coordinate_resolution(const TriangleMesh& mesh);

/// The note on a file that keeps too few digits of its coordinates, empty where there are enough.
/// @param mesh  as read from `path`, in its units
/// @param unit  metres per unit
/// @throws InputError  the shape of the block is lost
std::string check_coordinate_digits(const TriangleMesh& mesh, const std::filesystem::path& path, double unit);

}  // namespace clast::reconstruct_detail
