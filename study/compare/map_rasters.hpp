#pragma once
/// Raster layers on a grid of square cells in map coordinates.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Raster layer on a map: one value per cell.
struct RasterLayer {
  std::string name;     ///< name, such as "E_95"
  std::string meaning;  ///< description with unit
  /// Values, row-major, the first row at the largest y; NaN for cells without a value.
  std::vector<float> values;
};

using MapCell =
    /// Cell of a map grid: row and column from the origin of map coordinates.
    std::pair<std::int64_t, std::int64_t>;

/// Raster layers that share one grid.
struct MapRasterSet {
  Vec2 corner = Vec2::Zero();  ///< minimum x and y of the grid, m, a multiple of `cell`
  double cell_size = 1.0;      ///< side length of a cell, m
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<RasterLayer> layers;

  /// Returns the index of a cell into `RasterLayer::value`.
  std::size_t index(const MapCell& place) const;
};

/// Makes the smallest grid that contains all cells, with layers whose values are NaN.
/// @param cells  not empty
/// @param width  side length of a cell, m
MapRasterSet rasterize_cells(const std::vector<MapCell>& cells, double width,
                             std::vector<RasterLayer> layers);

}  // namespace clast
