#pragma once
/// Which photos see which part of a surface.
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

/// How often each triangle of a surface is seen.
struct SurfaceViews {
  std::vector<std::uint16_t> photos;  ///< that were compared and see it
  std::vector<std::uint16_t> pairs;   ///< compared pairs of which both see it
};

/// A photo sees a triangle that lies in it whole, is turned to it by 80 degrees at most, and has no
/// other part of the surface before its middle (by more than 1 % of the surface's diagonal).
/// @param surface           closed, outward
/// @param block_from_model  to the frame of the surface from that of the cameras
/// @param threads           0: one per core; the results are the same for any number
SurfaceViews count_surface_views(const TriangleMesh& surface, const PhotoScan& scan,
                           const Pose& block_from_model, unsigned threads = 0);

/// Share of the surface's area whose triangles have at least so many.
/// @param counts  of each triangle
double observed_fraction(const TriangleMesh& surface, const std::vector<std::uint16_t>& counts,
                  std::uint16_t min_views);

}  // namespace clast
