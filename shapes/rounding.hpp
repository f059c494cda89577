#pragma once
/// From the outer surface of a rock to a core whose rounded body keeps that surface.
#include <optional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// The core of a closed scan: every vertex moved inwards so that the planes of its faces move in by
/// `minkowski_radius` (least squares where more than three meet, singular values below 15 % of the
/// largest cut). Triangles that flip are collapsed.
/// @param scan   closed, outward, already simplified: edges not much shorter than the radius
/// @throws GeometryError  open mesh, or a radius so large that the core would vanish or invert;
///                        the message gives the largest radius that works
SpheroPolyhedron inset_core(const TriangleMesh& scan, double minkowski_radius);
/// The same, or none where the radius is too large. To find one that works, for the message, takes
/// as long as twenty cores.
/// @throws GeometryError  open mesh
std::optional<SpheroPolyhedron> try_inset_core(const TriangleMesh& scan,
                                                    double minkowski_radius);

}  // namespace clast
