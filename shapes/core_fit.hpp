#pragma once
/// Moving the vertices of a core until its rounded body lies as close to the scan as it can.
#include "shapes/scan_surface.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// When to stop fitting.
struct CoreFitOptions {
  int rounds = 30;
  double good_enough = 0.0;  ///< largest distance, m, at which the fit ends early
  double hopeless = 1e300;   ///< m: ends early, too, when it is clear that this isn't reached

  void check() const;  ///< throws InputError naming the field and its value
};

/// The body with its core moved so that the largest distance between its rounded surface and the
/// scan, either way, gets small: damped least squares over points of both surfaces, weighted more
/// and more towards the farthest ones (iteratively reweighted, the norm rises from 2 to 8). Core
/// vertices at sharp corners move outwards until body and scan stand out equally. Edges that keep
/// triangles from moving without crossing are collapsed. The best core met is returned; it has no
/// more vertices than the first, and crosses itself nowhere if that doesn't. Same input, same bits.
/// @param start  closed core with a radius, near the scan: see `inset_core`
/// @cite lawson1961
SpheroPolyhedron fit_core(const ScanSurface& scan, const SpheroPolyhedron& start,
                             const CoreFitOptions& options = {});

}  // namespace clast
