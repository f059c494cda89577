#pragma once
/// Hole loops of torn surfaces, including parts connected at vertices only.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Flips fragments attached at single vertices with opposite orientation to most of the surface
/// there. Returns the number of flipped triangles.
/// @param mesh  manifold edges, consistently oriented
std::size_t orient_vertex_attached_fragments(TriangleMesh& mesh);

/// Finds the border of each hole, in the direction that filling triangles need.
///
/// At vertices with several disjoint fans, as in torn surfaces, a border continues from one fan to
/// the next, so that a loop encloses adjacent missing triangles and may visit a vertex several
/// times. At overlapping fans two sheets touch, and the border stays with its fan.
/// @param mesh  manifold edges, consistently oriented
std::vector<std::vector<std::uint32_t>> find_hole_loops(const TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
