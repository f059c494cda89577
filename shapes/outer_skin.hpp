#pragma once
/// The rounded surface as one clean mesh, whatever the core is like.
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// A closed, oriented 2-manifold without crossings around the rounded body. Where no edge is
/// reflex this is `skin_mesh`. Else the offset of the core is wrapped: vertices lie on the rounded
/// surface, triangles are about a piece of a quarter turn long (but no shorter than 1/150 of the
/// diagonal), so that creases are bevelled at that size, and the volume is short by a share of its
/// square; clefts narrower than it are closed.
/// @param segments  pieces per quarter turn
/// @throws GeometryError, InputError  as `skin_mesh`
/// @cite portaneri2022
TriangleMesh outer_skin(const SpheroPolyhedron& shape, int segments = 4);

}  // namespace clast
