#pragma once
/// Retriangulation of missing faces between existing vertices.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Maximum width (twice the area over the perimeter, in mean border edges) of a hole without
/// missing vertices: n - 2 equal triangles between n vertices have less than 0.87, and a hexagon
/// without its centre has 0.87.
inline constexpr double kMaxMissingFaceWidth = 1.0;

/// Closes all holes up to `kMaxMissingFaceWidth` by the triangulation of minimum bending; fragments
/// attached at vertices become part of the surface again. No vertex is added or moved. Loose
/// components below 5 % of the area are unchanged.
///
/// This restores surfaces exactly after random deletion of up to half of the triangles.
/// @param mesh  manifold edges, consistently oriented
/// @returns the fillings, with area fractions 0
std::vector<FilledHole> retriangulate_missing_faces(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
