#include "study/compare/map_rasters.hpp"

#include <algorithm>
#include <cmath>

namespace clast {

std::size_t MapRasterSet::index(const MapCell& place) const {
  const std::int64_t top = std::llround(corner.y() / cell_size) + rows - 1;
  const std::int64_t left = std::llround(corner.x() / cell_size);
  return static_cast<std::size_t>((top - place.first) * columns + place.second - left);
}

MapRasterSet rasterize_cells(const std::vector<MapCell>& cells, double width,
                             std::vector<RasterLayer> layers) {
  MapCell low = cells.front(), high = low;
  for (const MapCell& cell : cells) {
    low = {std::min(low.first, cell.first), std::min(low.second, cell.second)};
    high = {std::max(high.first, cell.first), std::max(high.second, cell.second)};
  }
  MapRasterSet rasters;
  rasters.cell_size = width;
  rasters.corner = width * Vec2(static_cast<double>(low.second), static_cast<double>(low.first));
  rasters.columns = static_cast<std::uint32_t>(high.second - low.second + 1);
  rasters.rows = static_cast<std::uint32_t>(high.first - low.first + 1);
  rasters.layers = std::move(layers);
  for (RasterLayer& layer : rasters.layers) {
    layer.values.assign(std::size_t{rasters.columns} * rasters.rows, NAN);
  }
  return rasters;
}

}  // namespace clast
