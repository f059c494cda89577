#pragma once
/// Orientation of the normals of a point cloud.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Rule by which the sign of a normal is propagated to a neighbouring normal.
enum class NormalPropagation {
  kParallel,  ///< assumes nearly parallel normals [hoppe1992]; robust against noise
  /// Assumes a circular arc between the points [konig2009]; for sharp edges and thin parts.
  kCircularArc,
};

/// Orients normals along the minimum spanning tree of direction changes. In each connected set,
/// most normals face away from the set's centre.
/// @param normals  unit normals of arbitrary sign, one per point
/// @cite hoppe1992 @cite konig2009
void orient_outward(std::vector<Vec3>& normals, std::span<const Vec3> points,
                    NormalPropagation propagation = NormalPropagation::kParallel);

/// Replaces point normals that deviate by more than 60 degrees from those of their triangles. Such
/// normals were estimated from points on two sides of the surface. Returns their number.
/// @param surface  outward; its vertices are the points
std::size_t correct_normals(std::vector<Vec3>& normals, const TriangleMesh& surface);

}  // namespace clast::reconstruct_detail
