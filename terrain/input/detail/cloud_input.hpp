#pragma once
/// Streaming of point clouds to height grids. The memory needed depends on the grid only.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

/// Height grid of point clouds, with notes.
struct CloudGrid {
  HeightGrid grid;
  std::string crs;
  std::vector<std::string> notes;
};

/// Computes the height grid of the clouds in `options`. If points are classified, only ground
/// points are used. Cells lie on multiples of their size. The files are read twice. For percentiles
/// and outliers, they are read a third time, for up to 64 heights per cell.
/// @throws InputError  if a cloud cannot be read or has no points, if there are too many cells, or
///                     if all points are outliers
CloudGrid read_cloud_grid(const TerrainOptions& options);

/// Makes an empty grid of square cells on multiples of their size over a plan box.
/// @throws InputError  if there are too many cells; the message names `path`
HeightGrid make_covering_grid(const Vec2& low, const Vec2& high, double cell,
                              const std::filesystem::path& path);

/// Computes the mean height of the points in each square cell. Cells lie on multiples of `cell`.
HeightGrid grid_mean_heights(std::span<const Vec3> points, double cell,
                             const std::filesystem::path& path);

}  // namespace clast::terrain_detail
