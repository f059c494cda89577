#pragma once
/// From the outer surface of a rock to a core whose rounded body keeps that surface.
#include <cstddef>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// How far the rounded body is from the scan it stands for.
struct Deviation {
  double hausdorff = 0.0;        ///< larger of both one-sided distances, m
  double mean = 0.0;             ///< area-weighted mean distance scan to body, m
  double volume_relative = 0.0;  ///< (body - scan) / scan
};

/// The core of a closed scan: every vertex moved inwards so that the planes of its faces move in by
/// `minkowski_radius` (least squares where more than three meet, singular values below 15 % of the
/// largest cut). Triangles that flip are collapsed.
/// @param scan   closed, outward, already simplified: edges not much shorter than the radius
/// @throws GeometryError  open mesh, or a radius so large that the core would vanish or invert;
///                        the message gives the largest radius that works
SpheroPolyhedron rounded_core(const TriangleMesh& scan, double minkowski_radius);

/// Distances between the surface of the rounded body and the scan, both ways, by dense sampling of
/// either (at least `samples` points on each) against the exact distance to the other.
/// The volume term is left 0: the caller knows both volumes.
Deviation surface_deviation(const TriangleMesh& scan, const SpheroPolyhedron& body,
                            std::size_t samples = 20000);

}  // namespace clast
