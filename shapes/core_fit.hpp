#pragma once
/// Fitting of a core so that its rounded body matches a scan.
#include <functional>

#include "shapes/scan_surface.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

struct CoreFitOptions {
  int rounds = 30;
  double target_distance = 0.0;  ///< the fit ends if no distance is larger, m
  double max_distance = 1e300;   ///< the fit is abandoned if this cannot be reached, m
  /// Correction of a body at the target distance, for example to a given volume. It must not move
  /// the surface by more than a few percent of the target distance.
  std::function<SpheroPolyhedron(SpheroPolyhedron)> correct = {};
  unsigned threads = 1;  ///< number of threads, 0: one per core; does not affect the result

  void check() const;  ///< throws InputError naming the field and its value
};

/// Result of `fit_core`.
struct CoreFit {
  SpheroPolyhedron body;          ///< corrected, if there is a correction
  double distance_bound = 1e300;  ///< upper bound of the distances between `body` and scan, m;
                                  ///< 1e300 if unknown
};

/// Moves the core vertices to minimise the largest distance between rounded surface and scan, in
/// both directions. The method is damped least squares over points of both surfaces. Weights
/// increase towards the largest distances, as for a p-norm with p rising from 2 to 8. When all
/// points are within the target distance, points beyond `max_distance` are searched by branch and
/// bound and added, until there are none (exchange method of semi-infinite programming). Edges that
/// block the motion are collapsed. Returns the best core found. It has no more vertices than
/// `start` and no new self-intersections. The result is deterministic.
/// @param start  closed core with a radius, near the scan, for example from `inset_core`
/// @cite lawson1961 hettich1993
CoreFit fit_core(const ScanSurface& scan, const SpheroPolyhedron& start,
                 const CoreFitOptions& options = {});

}  // namespace clast
