#pragma once
/// Convex polyhedra with few vertices around a hull.
#include <cstddef>
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "shapes/convex_cell.hpp"

namespace clast::particles_detail {

/// Makes a convex polyhedron with at most `max_vertices` vertices that contains a hull and is
/// within a cell: the cell is cut by planes of faces of the hull, that above which most of the cell
/// protrudes first.
/// @param hull  within the cell
/// @param planes  of its faces
/// @param max_vertices  at least the number of vertices of the cell
TriangleMesh outer_hull(const TriangleMesh& hull, std::span<const Plane> planes, ConvexCell cell,
                        std::size_t max_vertices);

}  // namespace clast::particles_detail
