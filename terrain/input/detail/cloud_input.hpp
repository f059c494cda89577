#pragma once
/// Streaming of point clouds to height grids; the memory depends on the grid only.
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

/// Reads the clouds two or three times: for extent and density, for the number of points per cell,
/// and, for a percentile or outliers, for up to 64 heights per cell, spread evenly over the file.
/// Cells lie on multiples of their size. If points are classified, only ground points are used.
/// @throws InputError  if a cloud cannot be read or has no points, there are too many cells, or
///                     only outliers
CloudGrid read_cloud_grid(const TerrainOptions& options);

/// Makes an empty grid of square cells on multiples of their size over a plan box.
/// @throws InputError  if there are too many cells; names `path`
HeightGrid make_covering_grid(const Vec2& low, const Vec2& high, double cell,
                              const std::filesystem::path& path);

/// Computes the mean height per square cell; cells lie on multiples of `cell`.
HeightGrid bin_points(std::span<const Vec3> points, double cell, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
