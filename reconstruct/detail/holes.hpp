#pragma once
/// Filling holes.
#include <cstddef>
#include <vector>

#include "reconstruct/repair_report.hpp"
#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

/// Closes holes of at most `most_edges` border edges by the fan of least area that makes no edge
/// twice: no vertex is added, none moves. Shares of the area are left at 0.
std::vector<FilledHole> close_by_fans(TriangleMesh& mesh, std::size_t most_edges);

/// Fills every hole: a triangulation of its border of least bends and area, cut to the size of the
/// triangles around, and faired so that it goes on smoothly at the border; where there is none, a
/// star over the middle of the border, faired alike. A hole that even so stays open isn't listed.
/// @param mesh  oriented 2-manifold with border, no pinched vertex
/// @throws GeometryError  a hole defeats the search
/// @cite liepa2003
std::vector<FilledHole> fill_holes(TriangleMesh& mesh);

}  // namespace clast::detail
