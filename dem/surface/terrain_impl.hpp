#pragma once
/// The inside of TerrainSurface.
#include "dem/surface/indexed_surface.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

struct TerrainSurface::Impl {
  /// A place on the skin.
  struct SurfacePoint {
    double height;       ///< z, m
    std::uint32_t face;  ///< number of its triangle
  };
  /// As `TerrainSurface::height_at`.
  std::optional<SurfacePoint> find_surface_point(double x, double y, double z_near) const;

  TriangleMesh mesh;
  dem_detail::IndexedSurface surface;
  std::vector<std::uint16_t> zones;  ///< of every triangle
  std::uint16_t zone_count = 0;
};

}  // namespace clast
