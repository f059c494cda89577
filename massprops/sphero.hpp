#pragma once
/// Mass properties of sphero-polyhedra.
#include "massprops/mass_properties.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Computes the mass properties of a rounded convex core in closed form, as the sum of polyhedron,
/// face prisms, edge wedges and vertex cones. A single vertex (ball) and two vertices (capsule) are
/// valid cores.
/// @throws GeometryError  if the core is open, oriented inward or has an edge that is reflex by
///                        more than 1e-9 rad
MassProperties convex_sphero_mass_properties(const SpheroPolyhedron& body, double density);

/// Computes the mass properties of any rounded core, also of cores that touch or intersect
/// themselves. The closed form of convex cores is corrected by the volume that its pieces count
/// more than once near reflex edges and self-contacts. This volume is integrated along columns that
/// are refined until four interleaved grids of half the density agree within `accuracy`. Convex
/// bodies are exact.
/// @param accuracy  relative to the volume and, for the inertia tensor, to the smallest principal
///                  moment; in [1e-9, 0.1]. `relative_error` is the largest deviation of the four
///                  grids from their mean. It can exceed `accuracy` only if the surface intersects
///                  itself at a scale below 1/4096 of the body.
/// @throws GeometryError  if the core is open or its volume is not positive
/// @throws InputError     if the accuracy is out of range
MassProperties sphero_mass_properties(const SpheroPolyhedron& body, double density,
                                      double accuracy = 1e-4);

/// Surface area of the rounded body, m^2: the derivative of its volume with respect to the radius.
/// It is exact for convex cores (A + 2 M r + 4 pi r^2, where M is the integrated mean curvature),
/// otherwise accurate to about 1e-3.
/// @throws GeometryError  if the core is open or its volume is not positive
double sphero_surface_area(const SpheroPolyhedron& body);

}  // namespace clast
