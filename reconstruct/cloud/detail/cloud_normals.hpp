#pragma once
/// Which way the surface through points faces.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// What a normal says of that of a neighbour.
enum class NormalPropagation {
  kParallel,  ///< both are nearly the same [hoppe1992]: best against noise
  /// The surface bends along a circle from one to the other [konig2009]: over sharp edges, and
  /// round thin parts.
  kCircularArc,
};

/// Orients the normals from neighbour to neighbour along the spanning tree with the least change of
/// direction. Each connected set of points faces away from its middle on the whole: the one point
/// at which it starts may be an outlier.
/// @param normals  unit, of either sign, one for each point
/// @cite hoppe1992 @cite konig2009
void orient_outward(std::vector<Vec3>& normals, std::span<const Vec3> points,
                  NormalPropagation propagation = NormalPropagation::kParallel);

/// Gives a vertex the normal of its triangles where its own is more than 60 degrees off: it came
/// from points of two sides, or faces in. Counts these.
/// @param surface  outward; its vertices are the points the normals are of
std::size_t correct_normals(std::vector<Vec3>& normals, const TriangleMesh& surface);

}  // namespace clast::reconstruct_detail
