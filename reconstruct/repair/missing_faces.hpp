#pragma once
/// Holes that a few missing triangles left: closed by triangles between the vertices that are
/// there.
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Twice the area over the length round a hole, in mean sides of its border, up to which no vertex
/// need be missing inside: n - 2 even triangles between n corners have less, and a hexagon that
/// lost its middle has just this.
inline constexpr double kMaxMissingFaceWidth = 1.0;

/// Closes every hole that is no wider than `kMaxMissingFaceWidth`, by the triangulation with
/// the least bending; fragments attached at corners become part of the surface again. No vertex is
/// added or moved. Loose components with less than 5 % of the area stay as they are.
///
/// Where triangles were deleted at random, up to half of them, this restores the surface to the
/// last vertex.
/// @param mesh  no edge of more than two triangles, neighbours over edges agree
/// @returns the fillings, shares of the area left at 0
std::vector<FilledHole> retriangulate_missing_faces(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
