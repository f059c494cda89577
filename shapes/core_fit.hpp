#pragma once
/// Fitting of a core so that its rounded body matches a scan.
#include "shapes/scan_surface.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

struct CoreFitOptions {
  int rounds = 30;
  double good_enough = 0.0;  ///< largest distance at which the fit stops, m
  double hopeless = 1e300;   ///< stop if this distance cannot be reached, m

  void check() const;  ///< throws InputError naming the field and its value
};

/// Moves the core vertices to minimise the largest distance between rounded surface and scan in
/// either direction: damped least squares over points of both surfaces, reweighted towards the
/// largest distances (the norm rises from 2 to 8). At sharp corners core vertices move outwards
/// until both deviations are equal. Edges that block the motion are collapsed. Returns the best
/// core found, with no more vertices than the first and no new self-intersections. Deterministic.
/// @param start  closed core with a radius, near the scan: see `inset_core`
/// @cite lawson1961
SpheroPolyhedron fit_core(const ScanSurface& scan, const SpheroPolyhedron& start,
                          const CoreFitOptions& options = {});

}  // namespace clast
