#pragma once
/// Filling holes.
#include <cstddef>
#include <vector>

#include "reconstruct/repair_report.hpp"
#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

/// Holes of at most this many edges are closed by a fan, exactly where they lie in a plane.
inline constexpr std::size_t kFanEdges = 4;

/// What can be said of a hole from its border.
FilledHole measured_hole(const std::vector<Vec3>& border);

/// Area of the flat surface that a border spans best, m^2.
double flat_area(const std::vector<Vec3>& border);

/// Closes holes of at most `most_edges` border edges by the fan of least area that makes no edge
/// twice: no vertex is added, none moves. Shares of the area are left at 0.
std::vector<FilledHole> close_by_fans(TriangleMesh& mesh, std::size_t most_edges);

/// Fills every hole: a triangulation of its border of least bends and area, cut to the size of the
/// triangles around, and faired so that it goes on smoothly at the border; where there is none, a
/// star over the middle of the border, faired alike. It bulges from a soap film over the border by
/// half the width of the hole at most. A hole that even so stays open isn't listed.
/// @param mesh           oriented 2-manifold with border, no pinched vertex
/// @param largest_share  of the area that a hole has flat; a larger one is left open
/// @throws GeometryError  a hole defeats the search
/// @cite liepa2003
std::vector<FilledHole> fill_holes(TriangleMesh& mesh, double largest_share = 1.0);

}  // namespace clast::detail
