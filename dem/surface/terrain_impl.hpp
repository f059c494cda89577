#pragma once
/// Implementation of TerrainSurface.
#include "dem/surface/indexed_surface.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

struct TerrainSurface::Impl {
  struct SurfacePoint {
    double height;       ///< z, m
    std::uint32_t face;  ///< index of its triangle
  };
  /// Finds the surface point on the vertical line through (x, y) that is nearest to the height
  /// `z_near`.
  std::optional<SurfacePoint> find_surface_point(double x, double y, double z_near) const;

  TriangleMesh mesh;
  dem_detail::IndexedSurface surface;
  std::vector<std::uint16_t> zones;  ///< ground zone of each triangle
  std::uint16_t zone_count = 0;
};

}  // namespace clast
