#pragma once
/// Orientation of the normals of a point cloud.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Propagation rule from a normal to its neighbour.
enum class NormalPropagation {
  kParallel,  ///< neighbouring normals are nearly parallel [hoppe1992]: robust against noise
  /// The surface follows a circular arc between neighbours [konig2009]: for sharp edges and thin
  /// parts.
  kCircularArc,
};

/// Orients normals along the minimum spanning tree of direction changes. Each connected set faces
/// away from its centre on the whole, because the start point may be an outlier.
/// @param normals  unit, arbitrary sign, one per point
/// @cite hoppe1992 @cite konig2009
void orient_outward(std::vector<Vec3>& normals, std::span<const Vec3> points,
                    NormalPropagation propagation = NormalPropagation::kParallel);

/// Replaces point normals that deviate by more than 60 degrees from their triangles, as those from
/// points of two sides. Returns their number.
/// @param surface  outward; its vertices are the points
std::size_t correct_normals(std::vector<Vec3>& normals, const TriangleMesh& surface);

}  // namespace clast::reconstruct_detail
