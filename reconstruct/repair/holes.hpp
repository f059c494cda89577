#pragma once
/// Hole filling.
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Maximum number of edges of holes that are closed by a fan. A fan is exact for planar holes.
inline constexpr std::size_t kMaxFanEdges = 4;

FilledHole measure_hole(const std::vector<Vec3>& border);

/// True if the hole is an unobserved side, for which only bounds are known. Its area must be at
/// least 5 % of the closed surface. If its width is at least three mean border edges, 1 % is
/// sufficient (width: twice the area over the perimeter). Other holes are gaps, whose border
/// determines the filling.
/// @param seen_area  area of the observed surface, m^2
bool is_unobserved_side(const std::vector<Vec3>& border, double seen_area);

/// Closes holes of at most `max_edges` border edges by a fan without new vertices. It is the fan of
/// minimum area that duplicates no edge. The area fractions of the result are 0.
std::vector<FilledHole> fill_holes_with_fans(TriangleMesh& mesh, std::size_t max_edges);

/// Fills all holes by a triangulation of minimum bending and area. It is refined to the surrounding
/// density, and faired to continue smoothly at the border. If there is no triangulation, a star
/// about the centre of the border is faired. The filling deviates from a membrane by at most half
/// the width of the hole. Holes that cannot be filled are not in the result.
/// @param mesh  oriented 2-manifold with border; each vertex has one fan of triangles
/// @param fill_unobserved_sides  if true, unobserved sides are filled, too
/// @throws GeometryError  if the search for holes fails
/// @cite liepa2003
std::vector<FilledHole> fill_holes(TriangleMesh& mesh, bool fill_unobserved_sides = true);

}  // namespace clast::reconstruct_detail
