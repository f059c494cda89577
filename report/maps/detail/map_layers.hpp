#pragma once
/// Rasters and paths of a map as a page holds them.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Larger rasters are joined for the page, each cell with the largest value of those it joins.
inline constexpr std::size_t kMostMapCells = 100'000;
/// Of all stored paths so many are drawn at most, evenly chosen: more can't be told apart.
inline constexpr std::size_t kMostMapPaths = 250;

struct MapLayers {
  std::string json;              ///< {layers, paths}: see map.js
  std::size_t paths = 0;         ///< drawn
  std::size_t stored_paths = 0;  ///< that could be drawn
};

/// JSON with `layers`, a list of {name, title, meaning, unit, unit_size, breaks, numbers, colours,
/// columns, x0, y0, cell, values float32 row by row from the top, in stored units, NaN: none}; and
/// `paths`, a list for each shape class of {name, colour, x, y float32, NaN between two paths}.
/// Places are map coordinates less `origin`.
/// @param with_paths  else none are read
/// @throws InputError  a results file can't be read any more
MapLayers make_map_layers(const Comparison& comparison, const std::vector<const MapRasterSet*>& rasters,
                     const Vec2& origin, bool with_paths);

}  // namespace clast::report_detail
