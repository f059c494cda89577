#pragma once
/// The inside of TerrainSurface.
#include "dem/detail/indexed_surface.hpp"
#include "dem/terrain_surface.hpp"

namespace clast {

struct TerrainSurface::Impl {
  TriangleMesh mesh;
  dem_detail::IndexedSurface surface;
  std::vector<std::uint16_t> zones;  ///< of every triangle
  std::uint16_t zone_count = 0;
};

}  // namespace clast
