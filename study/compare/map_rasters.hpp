#pragma once
/// Values on a grid of square cells of the map.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// A value for every cell of a map.
struct RasterLayer {
  std::string name;          ///< "E_95"
  std::string meaning;       ///< with its unit
  std::vector<float> value;  ///< row by row from the top (largest y); NaN: none
};

using MapCell = std::pair<std::int64_t, std::int64_t>;  ///< row and column from the map's origin

struct MapRasterSet {
  Vec2 corner = Vec2::Zero();  ///< lowest x and y of the map, m, a multiple of `cell`
  double cell = 1.0;           ///< m
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<RasterLayer> layers;

  /// Where the values of a layer hold that of a cell.
  std::size_t index(const MapCell& place) const;
};

/// The smallest grid that holds all cells, with these layers, without a value yet.
/// @param cells  not empty
/// @param width  of a cell, m
MapRasterSet rasterize_cells(const std::vector<MapCell>& cells, double width,
                        std::vector<RasterLayer> layers);

}  // namespace clast
