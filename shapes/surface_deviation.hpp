#pragma once
/// How far a rounded body is from the scan it stands for.
#include <cstddef>

#include "shapes/scan_surface.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// How far the rounded body is from the scan it stands for.
struct SurfaceDeviation {
  double hausdorff = 0.0;  ///< larger of both one-sided distances, m
  double scan_to_body =
      0.0;  ///< largest distance of a point of the scan from the body's surface, m
  double body_to_scan =
      0.0;            ///< largest distance of a point of the body's surface from the scan, m
  double mean = 0.0;  ///< area-weighted mean distance scan to body, m
  double volume_relative = 0.0;   ///< (body - scan) / scan
  double area_relative = 0.0;     ///< the same of the surface areas
  double moments_relative = 0.0;  ///< largest relative difference of a principal moment
};

/// Distances between the surface of the rounded body and the scan, both ways.
///
/// The largest distances are upper bounds from a branch and bound over either surface, and at most
/// 2e-4 of the scan's diagonal above one that is attained, or at most 2e-3 of it; where a million
/// parts do not decide, as where the distance is the same everywhere, farther above. (Under a
/// crease of the body, where the nearest skin is buried, the distance to a bare point close by
/// counts.) The mean is over `samples` points on the scan. Volume, area and moments are left 0: the
/// caller knows them.
/// @throws GeometryError  the body has no faces
SurfaceDeviation measure_surface_deviation(const ScanSurface& scan, const SpheroPolyhedron& body,
                            std::size_t samples = 20000);

}  // namespace clast
