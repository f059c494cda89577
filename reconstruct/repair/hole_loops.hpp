#pragma once
/// Borders of the holes of torn surfaces, whose parts may be connected at vertices only.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Flips fragments that are attached at single vertices, if their orientation is opposite to most
/// of the surface there. Returns the number of flipped triangles.
/// @param mesh  manifold edges, consistently oriented
std::size_t orient_vertex_attached_fragments(TriangleMesh& mesh);

/// Finds the border loop of each hole, in the direction of the edges of filling triangles.
///
/// A vertex of a torn surface may have several disjoint fans of triangles. A border then continues
/// from one fan to the next. Such a loop encloses adjacent missing triangles and may visit a vertex
/// several times. If fans overlap, two sheets touch, and the border stays with its fan.
/// Borders that do not close, beside triangles of opposite orientation, are left out.
/// @param mesh  manifold edges
std::vector<std::vector<std::uint32_t>> find_hole_loops(const TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
