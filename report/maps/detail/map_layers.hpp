#pragma once
/// Rasters and paths of an interactive map.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Maximum number of raster cells of a map in a page. Cells of larger rasters are merged.
inline constexpr std::size_t kMaxMapCells = 100'000;
/// Maximum number of drawn paths, selected evenly from the stored paths.
inline constexpr std::size_t kMaxMapPaths = 250;

struct MapLayerData {
  std::string json;              ///< raster layers and paths as JSON, for map.js
  std::size_t paths = 0;         ///< number of drawn paths
  std::size_t stored_paths = 0;  ///< number of stored paths
};

/// Makes the JSON of rasters and paths. `layers` lists {name, title, meaning, unit, unit_size,
/// breaks, numbers, colours, columns, x0, y0, cell, values}. The values are float32, row-major from
/// the top, in stored units, NaN for none. `paths` has for each shape class {name, colour, x, y},
/// float32 with NaN between paths. Positions are map coordinates minus `origin`.
/// @param with_paths  true if paths are included
/// @throws InputError  if a results file can no longer be read
MapLayerData make_map_layer_data(const Comparison& comparison,
                                 const std::vector<const MapRasterSet*>& rasters,
                                 const Vec2& origin, bool with_paths);

}  // namespace clast::report_detail
