#pragma once
/// Merging of coplanar faces.
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Flatness tolerance for shapes from files: rounding of single precision or eight digits.
inline constexpr double kFileFlatnessTolerance = 1e-7;

/// Merges connected coplanar faces to polygons. Vertices inside polygons and on straight edges are
/// removed. The cost of contacts then depends on the shape, not on the mesh. Faces that would have
/// a hole or touch themselves at a vertex are not merged.
///
/// The largest face defines the plane. Polygons may be concave. Each starts at a convex vertex with
/// non-degenerate sides, where some readers compute the normal. Shapes without faces are unchanged.
/// @param flatness  largest distance of a vertex from its plane or straight edge, relative to the
///                  diagonal of the core; the default changes the volume by less than 1e-11 of it
SpheroPolyhedron merge_coplanar_faces(const SpheroPolyhedron& shape, double flatness = 1e-12);

}  // namespace clast
