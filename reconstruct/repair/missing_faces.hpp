#pragma once
/// Restoration of missing triangles between existing vertices.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Maximum width of a hole that misses no vertices. The width is twice the area over the perimeter,
/// in mean border edges. It is less than 0.87 for n - 2 equal triangles between n vertices.
inline constexpr double kMaxMissingFaceWidth = 1.0;

/// Closes all holes up to `kMaxMissingFaceWidth` by the triangulation of minimum bending. No vertex
/// is added or moved. Fragments that are attached at vertices become part of the surface again.
/// Loose components with less than 5 % of the area are unchanged.
///
/// Surfaces are restored exactly if up to half of their triangles were deleted at random.
/// @param mesh  manifold edges, consistently oriented
/// @returns the fillings, with area fractions 0
std::vector<FilledHole> retriangulate_missing_faces(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
