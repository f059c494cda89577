#pragma once
/// Joining vertices that a file stored more than once, and finding triangles that it did.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Of every vertex the one that it becomes: the first within `tolerance` (m) that itself stays, or
/// itself. Below the rounding of the coordinates only equal ones can be meant.
/// @throws InputError  a tolerance that is negative or not finite
std::vector<std::uint32_t> weld_targets(std::span<const Vec3> vertices, double tolerance);

/// Vertices closer than `tolerance` (m) become one, at the position of the first; triangles that
/// lose a corner by it and exact duplicates are dropped, unused vertices too. Order is kept.
TriangleMesh weld_vertices(const TriangleMesh& mesh, double tolerance);

/// Which triangles of equal corners count as copies.
enum class WindingMatch {
  kSame,   ///< those that also turn the same way
  kEither  ///< those back to back with another too
};

/// A triangle, and the one before it that has the same corners.
struct DuplicateTriangle {
  std::uint32_t before = 0, again = 0;
};

/// All copies, sorted by their corners, then by number.
std::vector<DuplicateTriangle> find_duplicate_triangles(std::span<const TriangleMesh::Triangle> triangles,
                                             WindingMatch turn);

}  // namespace clast
