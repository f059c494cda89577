#pragma once
/// Merging of coplanar faces.
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Flatness for shapes in files: the error of single precision or eight digits, negligible for
/// contacts.
inline constexpr double kFileFlatness = 1e-7;

/// Merges connected coplanar faces to polygons and removes vertices inside them and on straight
/// edges, so that the contact cost depends on the shape and not on the mesh. Faces around a hole,
/// and those that touch themselves at a vertex, are unchanged.
///
/// The largest face defines the plane. Polygons may be concave; each starts at a convex vertex with
/// two non-degenerate sides, from which some readers compute the normal. Shapes without faces are
/// unchanged.
/// @param flatness  largest distance of a vertex from a plane or straight edge, relative to the
///                  core's diagonal; the default changes a volume by less than 1e-11
SpheroPolyhedron merge_coplanar_faces(const SpheroPolyhedron& shape, double flatness = 1e-12);

}  // namespace clast
