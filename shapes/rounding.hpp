#pragma once
/// Construction of a core whose rounded body matches a scan.
#include <optional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Makes the core of a closed scan by moving vertices inwards so that face planes move by
/// `minkowski_radius` (least squares for more than three planes, singular values below 15 % of the
/// largest cut). Flipped triangles are collapsed.
/// @param scan  closed, outward, simplified: edges not much shorter than the radius
/// @throws GeometryError  if the mesh is open, or the radius so large that the core would vanish or
///                        invert; the message states the largest possible radius
SpheroPolyhedron inset_core(const TriangleMesh& scan, double minkowski_radius);
/// Makes the core, or returns empty if the radius is too large. Cheaper than `inset_core`, which
/// searches the largest possible radius for its message.
/// @throws GeometryError  if the mesh is open
std::optional<SpheroPolyhedron> try_inset_core(const TriangleMesh& scan, double minkowski_radius);

}  // namespace clast
