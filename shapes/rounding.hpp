#pragma once
/// Construction of a core whose rounded body matches a scan.
#include <optional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Makes the core whose rounded body is near a closed scan. The vertices of the scan move inwards
/// so that the planes of their faces move by `minkowski_radius`. If a vertex has more than three
/// planes, this holds in the least-squares sense (`PlaneQuadric`). Flipped triangles are collapsed.
/// @param scan  closed, outward-facing and simplified; edges not much shorter than the radius
/// @throws GeometryError  if the mesh is open, or if the radius is so large that the core would
///                        vanish or invert; the message gives the largest possible radius
SpheroPolyhedron inset_core(const TriangleMesh& scan, double minkowski_radius);
/// Makes the core as `inset_core`, but returns empty if the radius is too large. It is cheaper
/// then, because it does not search the largest possible radius.
/// @throws GeometryError  if the mesh is open
std::optional<SpheroPolyhedron> try_inset_core(const TriangleMesh& scan, double minkowski_radius);

}  // namespace clast
