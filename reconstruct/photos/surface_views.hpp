#pragma once
/// Visibility of a surface in photos.
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

struct SurfaceViews {
  std::vector<std::uint16_t> photos;  ///< number of used photos that see each triangle
  std::vector<std::uint16_t>
      pairs;  ///< number of stereo pairs of which both photos see each triangle
};

/// Counts the views of each triangle. A photo sees a triangle if the triangle is inside the image,
/// faces the camera within 80 degrees, and is not occluded. A part of the surface occludes it if it
/// is nearer to the camera by more than 1 % of the diagonal.
/// @param surface  closed, outward
/// @param block_from_model  transform from the camera model to the frame of the surface
/// @param threads  0: one per core; does not affect the result
SurfaceViews count_surface_views(const TriangleMesh& surface, const PhotoScan& scan,
                                 const Pose& block_from_model, unsigned threads = 0);

/// Returns the fraction of the surface area whose triangles have at least `min_views` views.
/// @param counts  number of views of each triangle
double observed_fraction(const TriangleMesh& surface, const std::vector<std::uint16_t>& counts,
                         std::uint16_t min_views);

}  // namespace clast
