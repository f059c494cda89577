#pragma once
/// Filling holes.
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Holes of at most this many edges are closed by a fan, exactly where they lie in a plane.
inline constexpr std::size_t kFanEdges = 4;

/// What is known of a hole from its border.
FilledHole measure_hole(const std::vector<Vec3>& border);

/// Is the hole within this border an unseen side, of which only bounds are known? It is if it has
/// 5 % of the closed surface, or 1 % and a width of three of its mean border sides (twice its area
/// over its perimeter). A smaller one is a gap in what was seen: its rim determines what fills
/// it.
/// @param seen_area  of the surface around it, m^2
bool is_unobserved_side(const std::vector<Vec3>& border, double seen_area);

/// Closes holes of at most `max_edges` border edges by the fan of least area that makes no edge
/// twice: no vertex is added, none moves. Shares of the area are left at 0.
std::vector<FilledHole> fill_with_fans(TriangleMesh& mesh, std::size_t max_edges);

/// Fills every hole: a triangulation of its border of least bends and area, cut to the size of the
/// triangles around, and faired so that it goes on smoothly at the border; where there is none, a
/// star over the middle of the border, faired alike. It deviates from a membrane over the border by
/// half the width of the hole at most. A hole that even so stays open isn't listed.
/// @param mesh          oriented 2-manifold with border, no pinched vertex
/// @param fill_unobserved_sides  fill those too
/// @throws GeometryError  a hole defeats the search
/// @cite liepa2003
std::vector<FilledHole> fill_holes(TriangleMesh& mesh, bool fill_unobserved_sides = true);

}  // namespace clast::reconstruct_detail
