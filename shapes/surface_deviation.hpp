#pragma once
/// Deviation of a rounded body from its scan.
#include <cstddef>
#include <optional>

#include "shapes/scan_surface.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Deviation of a rounded body from its scan.
struct SurfaceDeviation {
  double hausdorff = 0.0;  ///< larger of the two largest distances, m
  double scan_to_body =
      0.0;  ///< largest distance of a point of the scan from the body's surface, m
  double body_to_scan =
      0.0;            ///< largest distance of a point of the body's surface from the scan, m
  double mean = 0.0;  ///< area-weighted mean distance of the scan from the body, m
  double volume_relative = 0.0;   ///< (body - scan) / scan
  double area_relative = 0.0;     ///< the same for surface areas
  double moments_relative = 0.0;  ///< largest relative difference of a principal moment
};

struct DeviationOptions {
  std::size_t samples = 20000;  ///< points of the scan for the mean distance
  /// If given, the largest distances are only compared with this limit, m. Both are then upper
  /// bounds that are at most `limit`, or one is a distance above it.
  std::optional<double> limit = {};
  unsigned threads = 1;  ///< number of threads, 0: one per core; does not affect the result
};

/// Measures the distances between rounded surface and scan in both directions. Volume, area and
/// moments are left 0 for the caller.
///
/// The largest distances are upper bounds by branch and bound, at most 2e-5 of the diagonal above
/// an attained value. The gap is larger only if a million patches do not suffice, as for a constant
/// distance. Under a crease, the distance to a near exposed point counts. The mean is over
/// `samples` points of the scan.
/// @throws GeometryError  if the body has no faces
SurfaceDeviation measure_surface_deviation(const ScanSurface& scan, const SpheroPolyhedron& body,
                                           const DeviationOptions& options = {});

}  // namespace clast
