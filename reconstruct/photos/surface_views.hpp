#pragma once
/// Visibility of a surface in photos.
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

struct SurfaceViews {
  std::vector<std::uint16_t> photos;  ///< compared photos that see it
  std::vector<std::uint16_t> pairs;   ///< compared pairs that both see it
};

/// Counts the views of each triangle. A photo sees a triangle that is inside the image, faces it
/// within 80 degrees, and is not occluded by more than 1 % of the surface's diagonal.
/// @param surface  closed, outward
/// @param block_from_model  from the frame of the cameras to that of the surface
/// @param threads  0: one per core; does not affect the result
SurfaceViews count_surface_views(const TriangleMesh& surface, const PhotoScan& scan,
                                 const Pose& block_from_model, unsigned threads = 0);

/// Returns the area fraction of triangles with at least `min_views`.
/// @param counts  per triangle
double observed_fraction(const TriangleMesh& surface, const std::vector<std::uint16_t>& counts,
                         std::uint16_t min_views);

}  // namespace clast
