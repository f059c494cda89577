#pragma once
/// Point clouds to grids of heights, streamed: what is held grows with the grid, not with the
/// cloud.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "terrain/raw_surface.hpp"
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

/// Heights of one or more clouds, with what was left out, in words.
struct CloudGrid {
  HeightGrid grid;
  std::string crs;
  std::vector<std::string> notes;
};

/// Reads the clouds of `options` two or three times: for extent and density, for the number of
/// points per cell, and, where a percentile or outliers are asked, for their heights. Of these at
/// most 64 per cell are kept, spread evenly over the order of the file: all of them in a survey of
/// usual density. Cells lie on multiples of their size. Of a cloud with classes only ground counts.
/// @throws InputError  unreadable, without points, too many cells, or nothing but outliers
CloudGrid read_cloud_grid(const TerrainOptions& options);

/// Square cells on multiples of their size over a plan box, without heights.
/// @throws InputError  too many; the message is about `path`
HeightGrid make_covering_grid(const Vec2& low, const Vec2& high, double cell,
                         const std::filesystem::path& path);

/// Mean height per square cell; cells lie on multiples of `cell`.
HeightGrid bin_points(std::span<const Vec3> points, double cell, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
