#pragma once
/// Hole filling.
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/repair_report.hpp"

namespace clast::reconstruct_detail {

/// Maximum number of edges of holes closed by a fan, exact for planar holes.
inline constexpr std::size_t kFanEdges = 4;

FilledHole measure_hole(const std::vector<Vec3>& border);

/// True if the hole is an unobserved side, of which only bounds are known: at least 5 % of the
/// closed surface, or 1 % with a width of three mean border edges (twice its area over its
/// perimeter). Smaller holes are gaps, whose rim determines the filling.
/// @param seen_area  of the surrounding surface, m^2
bool is_unobserved_side(const std::vector<Vec3>& border, double seen_area);

/// Closes holes of at most `max_edges` border edges by the fan of minimum area without duplicate
/// edges or new vertices. Area fractions are left 0.
std::vector<FilledHole> fill_with_fans(TriangleMesh& mesh, std::size_t max_edges);

/// Fills all holes by a triangulation of minimum bending and area, refined to the surrounding
/// density and faired to continue smoothly at the border; if there is none, by a faired star about
/// the border's centre. The filling deviates from a membrane by at most half the hole's width.
/// Holes that cannot be filled are not listed.
/// @param mesh  oriented 2-manifold with border, no pinched vertex
/// @param fill_unobserved_sides  fill unobserved sides, too
/// @throws GeometryError  if the search fails
/// @cite liepa2003
std::vector<FilledHole> fill_holes(TriangleMesh& mesh, bool fill_unobserved_sides = true);

}  // namespace clast::reconstruct_detail
