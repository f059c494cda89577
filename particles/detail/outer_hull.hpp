#pragma once
/// Convex polyhedra with few vertices around a hull.
#include <cstddef>
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "shapes/convex_cell.hpp"

namespace clast::particles_detail {

/// Makes a convex polyhedron with at most `max_vertices` vertices that contains a hull and is
/// within a cell.
///
/// The cell is cut by planes of faces of the hull, first by the plane above which the cell
/// protrudes farthest. Cuts that would exceed `max_vertices` are left out.
/// @param hull  closed convex mesh within the cell
/// @param planes  planes of the faces of the hull
/// @param max_vertices  at least the number of vertices of the cell
TriangleMesh outer_hull(const TriangleMesh& hull, std::span<const Plane> planes, ConvexCell cell,
                        std::size_t max_vertices);

}  // namespace clast::particles_detail
