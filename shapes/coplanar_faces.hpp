#pragma once
/// Faces in one plane joined to polygons.
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// A flatness for shapes of files: what single precision or eight digits leave of a plane, and
/// nothing that a contact notices.
inline constexpr double kFileFlatness = 1e-7;

/// The same body with fewer parts: connected faces in one plane become one polygon, vertices inside
/// it and on straight edges are dropped, so that contact costs what the shape is and not how it was
/// meshed. Faces around a hole, and those that touch themselves at a vertex, stay as they are.
///
/// The largest face of a plane sets it. Polygons may be concave; each starts at a convex corner
/// with both sides of some length, so that readers which take the normal from the first corner get
/// it right. A shape without faces comes back as it is.
/// @param flatness  how far a vertex may lie off a plane or a straight edge, as a share of the
///                  core's diagonal; the default changes a volume by less than 1e-11
SpheroPolyhedron merge_coplanar_faces(const SpheroPolyhedron& shape, double flatness = 1e-12);

}  // namespace clast
