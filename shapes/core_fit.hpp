#pragma once
/// Fitting of a core so that its rounded body matches a scan.
#include "shapes/scan_surface.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

struct CoreFitOptions {
  int rounds = 30;
  double target_distance = 0.0;     ///< stop if the largest distance is at most this, m
  double abandon_distance = 1e300;  ///< stop if this largest distance cannot be reached, m

  void check() const;  ///< throws InputError naming the field and its value
};

/// Moves the core vertices to minimise the largest distance between rounded surface and scan, in
/// both directions. The method is damped least squares over points of both surfaces. Weights
/// increase towards the largest distances, as for a p-norm with p rising from 2 to 8. Edges that
/// block the motion are collapsed. Returns the best core found. It has no more vertices than
/// `start` and no new self-intersections. The result is deterministic.
/// @param start  closed core with a radius, near the scan, for example from `inset_core`
/// @cite lawson1961
SpheroPolyhedron fit_core(const ScanSurface& scan, const SpheroPolyhedron& start,
                          const CoreFitOptions& options = {});

}  // namespace clast
