#pragma once
/// Mass properties of sphero-polyhedra.
#include "massprops/mass_properties.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Closed form for a convex core: polyhedron, face prisms, edge wedges and vertex cones. A single
/// vertex (ball) and two vertices with an edge (capsule) are convex cores too.
/// @throws GeometryError  core open, not outward, or with a reflex edge (beyond 1e-9 rad)
MassProperties convex_sphero_mass_properties(const SpheroPolyhedron& body, double density);

/// For any core, convex or not, also one that touches or crosses itself: the closed form, less what
/// its pieces count more than once near reflex edges and where the body meets itself. That part is
/// integrated along columns; the columns get denser until the four interleaved grids of half the
/// density agree within `accuracy`. Convex bodies are exact.
/// @param accuracy  relative, on volume and, against the smallest principal moment, on every part
///                  of the inertia tensor; in [1e-9, 0.1]. The largest departure of the four grids
///                  from their mean is the bound kept in `relative_error`; it can stay above
///                  `accuracy` only for skins that cross themselves at a scale below 1/4096 of the
///                  body.
/// @throws GeometryError  core open or its volume not positive
/// @throws InputError     accuracy out of range
MassProperties sphero_mass_properties(const SpheroPolyhedron& body, double density,
                                      double accuracy = 1e-4);

/// Surface area of the rounded body, m^2: the derivative of its volume by the radius. Exact for
/// convex cores (A + 2 M r + 4 pi r^2); else to about 1e-3.
/// @throws GeometryError  core open or its volume not positive
double sphero_surface_area(const SpheroPolyhedron& body);

}  // namespace clast
