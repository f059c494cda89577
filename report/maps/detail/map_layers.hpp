#pragma once
/// Rasters and paths of an interactive map.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Maximum number of raster cells; larger rasters are coarsened by the maximum of the merged cells.
inline constexpr std::size_t kMaxMapCells = 100'000;
/// Maximum number of drawn paths, chosen evenly.
inline constexpr std::size_t kMaxMapPaths = 250;

struct MapLayers {
  std::string json;              ///< {layers, paths}: see map.js
  std::size_t paths = 0;         ///< number of drawn paths
  std::size_t stored_paths = 0;  ///< number of stored paths
};

/// Makes JSON with `layers`, a list of {name, title, meaning, unit, unit_size, breaks, numbers,
/// colours, columns, x0, y0, cell, values float32 row-major from the top, in stored units, NaN:
/// none}, and `paths`, a list per shape class of {name, colour, x, y float32, NaN between paths}.
/// Positions are map coordinates minus `origin`.
/// @param with_paths  include paths
/// @throws InputError  if a results file can no longer be read
MapLayers make_map_layers(const Comparison& comparison,
                          const std::vector<const MapRasterSet*>& rasters, const Vec2& origin,
                          bool with_paths);

}  // namespace clast::report_detail
