#pragma once
/// The borders of the holes of a torn sheet, also where parts of it are connected only at corners.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Flips fragments that are attached at single vertices and face the opposite way to most of the
/// surface they are attached to. Returns the number of triangles that were flipped.
/// @param mesh  no edge of more than two triangles, neighbours over edges agree
std::size_t orient_vertex_attached_fragments(TriangleMesh& mesh);

/// The border of each hole, in the direction that a filling triangle needs.
///
/// Where the fans of a vertex stand beside one another around it, as what is left of a torn sheet
/// does, a border runs across the gap from one fan to the next. So a loop encloses triangles that
/// are missing beside each other, and may pass a vertex more than once. Where fans overlap, two
/// sheets touch: there a border stays with its fan, as if the vertex was split.
/// @param mesh  no edge of more than two triangles, neighbours over edges agree
std::vector<std::vector<std::uint32_t>> find_hole_loops(const TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
