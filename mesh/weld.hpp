#pragma once
/// Welding of duplicate vertices and detection of duplicate triangles.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Finds the vertex into which each vertex is merged: the first remaining one within `tolerance`
/// (m), or itself. A tolerance below the rounding error of the coordinates merges only equal
/// vertices.
/// @throws InputError  if the tolerance is negative or not finite
std::vector<std::uint32_t> find_weld_targets(std::span<const Vec3> vertices, double tolerance);

/// Merges vertices closer than `tolerance` (m) to the first of them. Degenerate triangles, exact
/// duplicates and unused vertices are removed. The order is kept.
TriangleMesh weld_vertices(const TriangleMesh& mesh, double tolerance);

/// Condition under which triangles with equal vertices are duplicates.
enum class WindingMatch {
  kSame,   ///< equal winding
  kEither  ///< equal or opposite winding
};

/// Duplicate triangle, and the first triangle with the same vertices.
struct DuplicateTriangle {
  std::uint32_t first = 0, duplicate = 0;
};

/// Finds all duplicate triangles, sorted by vertices, then index.
std::vector<DuplicateTriangle> find_duplicate_triangles(
    std::span<const TriangleMesh::Triangle> triangles, WindingMatch match);

}  // namespace clast
